#!/bin/sh
# Installs the program, or removes what was installed: tools/install.sh install|uninstall BUILD
# BUILD is the folder of the built program, its manual page and its completions. The environment may give PREFIX (/usr/local) and DESTDIR, the
# folder of a package, which is put in front of all paths.
#
# What is installed can be read by everybody, whatever the umask is. Its list is PREFIX/share/magichour/installed: files, and
# with a slash at the end the folders that were made for them. `uninstall` removes what is on the list, and folders only if they
# are empty. The README's pictures (scenes/gallery) stay behind.
set -eu
umask 022
export LC_ALL=C
action=${1-} build=${2-}
case $action in install | uninstall) ;; *) sed -n '2s/^# //p' "$0" >&2; exit 2 ;; esac
cd "$(dirname "$0")/.."
root=${DESTDIR-}${PREFIX:-/usr/local}
list=share/magichour/installed

# What goes where: lines of mode, file and target, with tabs between. Targets are below PREFIX.
plan() {
    printf '755\t%s\tbin/magichour\n' "$build/magichour"
    printf '644\t%s\tshare/man/man1/magichour.1\n' "$build/magichour.1"
    printf '644\t%s\tshare/bash-completion/completions/magichour\n' "$build/magichour.bash"
    printf '644\t%s\tshare/zsh/site-functions/_magichour\n' "$build/magichour.zsh"
    printf '644\t%s\tshare/fish/vendor_completions.d/magichour.fish\n' "$build/magichour.fish"
    for file in LICENSE README.md CHANGES.md; do printf '644\t%s\tshare/doc/magichour/%s\n' $file $file; done
    find glsl scenes -name gallery -prune -o -type f \( -name '*.glsl' -o -name '*.csv' -o -name 'README.md' \) -print | sort |
        while read -r file; do printf '644\t%s\tshare/magichour/%s\n' "$file" "$file"; done
}

listed() { if [ -e "$root/$list" ]; then cat "$root/$list"; fi; }

# All folders of the paths on standard input, the outer ones first; "./" is PREFIX itself.
folders() {
    awk '{ print "./"; for (i = 1; i <= length; i++) if (substr($0, i, 1) == "/") print substr($0, 1, i) }' | sort -u
}

# Removes the files on standard input, and then the folders, the innermost first. A folder that is not empty stays.
remove() {
    sort -r | while read -r path; do
        case $path in
        */)
            folder=$root/${path%/}
            folder=${folder%/.}
            rmdir "$folder" 2>/dev/null || [ ! -d "$folder" ] || echo "uninstall: $folder is not empty and stays"
            ;;
        *) rm -f "$root/$path" ;;
        esac
    done
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
listed >"$work/old"

if [ "$action" = uninstall ]; then
    if [ ! -s "$work/old" ]; then
        echo "uninstall: no list of installed files is at $root/$list, so nothing is removed"
        exit 0
    fi
    # The list goes last of the files, so that an interrupted removal can go on.
    grep -v '/$' "$work/old" | grep -Fxv $list | remove
    rm -f "$root/$list"
    grep '/$' "$work/old" | remove
    exit 0
fi

plan >"$work/plan"
{
    cut -f 3 "$work/plan"
    echo $list
} >"$work/files"
{
    cat "$work/files"
    grep '/$' "$work/old" || true
    folders <"$work/files" | while read -r folder; do [ -d "$root/$folder" ] || echo "$folder"; done
} | awk '!seen[$0]++' >"$work/new"
place=$root/$(dirname $list)
if ! mkdir -p "$place" || [ ! -w "$place" ]; then
    echo "install: $root cannot be written; be root, or choose another folder: make install PREFIX=\$HOME/.local" >&2
    exit 1
fi
# The list comes first: what an interrupted installation has left can be removed by it.
install -m 644 "$work/new" "$root/$list"
folders <"$work/files" | while read -r folder; do mkdir -p "$root/$folder"; done
while IFS="$(printf '\t')" read -r mode file target; do
    install -m "$mode" "$file" "$root/$target"
done <"$work/plan"
# An older version's files that this one does not have.
grep -v '/$' "$work/old" | grep -Fxv -f "$work/files" | remove
echo "install: $(wc -l <"$work/files") files below $root"
