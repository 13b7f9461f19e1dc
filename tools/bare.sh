#!/bin/sh
# The README's two commands on a bare system: tools/bare.sh bookworm|trixie [FOLDER [TARGETS [VARIABLE=VALUE...]]]
#
# debootstrap makes a minimal Debian with make and git in it. A clean clone of HEAD goes there, and `make demo` and `make test`
# (or TARGETS, such as "demo") run in a chroot, as root; `make` gets the VARIABLEs, such as WINDOW=0. The times are printed, and
# the line that the tests close with. FOLDER must not be there yet; the system and the logs stay in it. Without FOLDER, a
# temporary folder is removed at the end, unless a command failed. Needs root, debootstrap, some 2 GB of disk, and a mirror of
# Debian: this system's own, or $MIRROR.
set -eu

suite=${1-}
case $suite in bookworm | trixie) ;; *) sed -n '2s/^# //p' "$0" >&2; exit 2 ;; esac
[ "$(id -u)" = 0 ] || { echo "bare: needs root, for chroot and mount" >&2; exit 1; }
command -v debootstrap >/dev/null || { echo "bare: debootstrap is missing: apt-get install debootstrap" >&2; exit 1; }

# Everything happens among mounts and processes of its own: they end with this script, however it ends.
if [ -z "${BARE_INSIDE-}" ]; then
    BARE_INSIDE=1 exec unshare --mount --pid --fork --kill-child "$0" "$@"
fi

folder=${2-}
targets=${3:-demo test}
shift $(($# < 3 ? $# : 3))
keep=yes
if [ -z "$folder" ]; then
    folder=$(mktemp -d "${TMPDIR:-/var/tmp}/bare-$suite-XXXXXX")
    keep=""
elif [ -e "$folder" ]; then
    echo "bare: $folder is there already" >&2
    exit 1
fi
mkdir -p "$folder"
folder=$(realpath "$folder")
system=$folder/system
# shellcheck disable=SC2317
finish() {
    for mounted in dev/pts dev/shm proc sys; do umount -l "$system/$mounted" 2>/dev/null || true; done
    [ -n "$keep" ] || rm -rf --one-file-system "$folder"
}
trap finish EXIT
trap 'exit 130' INT TERM

# The mirror that apt has here, where this is a Debian; what else apt needs to reach it goes into the new system too.
# shellcheck disable=SC2016
mirror=${MIRROR-$(apt-get indextargets --format '$(REPO_URI)' 2>/dev/null | grep -m 1 '/debian/*$' || true)}
include=make,git
case $mirror in https:*) include=$include,ca-certificates ;; esac

seconds() { date +%s; }
start=$(seconds)
# An empty mirror leaves it to debootstrap, which has one by default.
# shellcheck disable=SC2086
debootstrap --variant=minbase --include=$include "$suite" "$system" $mirror >"$folder/debootstrap.log" 2>&1 ||
    { keep=yes; tail -n 5 "$folder/debootstrap.log" >&2; exit 1; }
apt-config dump | grep -E '^Acquire::(http|https)::.*[Pp]roxy|^Acquire::(Check-|Retries)' >"$system/etc/apt/apt.conf.d/90bare" || true
printf '#!/bin/sh\nexit 101\n' >"$system/usr/sbin/policy-rc.d"
chmod +x "$system/usr/sbin/policy-rc.d"
mount -t proc proc "$system/proc"
mount --rbind /sys "$system/sys"
mkdir -p "$system/dev/pts" "$system/dev/shm"
mount -t devpts -o newinstance,ptmxmode=0666 devpts "$system/dev/pts"
mount -t tmpfs tmpfs "$system/dev/shm"
echo "bare: $suite, $(cat "$system/etc/debian_version"): made in $(($(seconds) - start)) s"

repository=$(git -C "$(dirname "$0")" rev-parse --show-toplevel)
git clone -q --depth 1 "file://$repository" "$system/root/magichour"

failed=0
for target in $targets; do
    start=$(seconds)
    status=0
    chroot "$system" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
        ${http_proxy+http_proxy="$http_proxy"} ${https_proxy+https_proxy="$https_proxy"} \
        make --no-print-directory -C /root/magichour "$target" "$@" >"$folder/$target.log" 2>&1 </dev/null || status=$?
    took="after $(($(seconds) - start)) s"
    if [ $status != 0 ]; then
        failed=1 keep=yes
        echo "bare: $suite: make $target: FAILED with status $status $took"
        grep -E '^\[  FAILED|error:' "$folder/$target.log" | head -n 20 || true
        tail -n 15 "$folder/$target.log"
        echo "bare: all of it: $folder/$target.log"
    else
        echo "bare: $suite: make $target: done $took: $(tail -n 1 "$folder/$target.log")"
    fi
done
exit $failed
