#!/bin/sh
# Makes the source archive: tools/dist.sh FOLDER writes FOLDER/magichour-VERSION.tar.gz and its SHA-256.
# In a git repository it holds what is committed; elsewhere all files but those that were built. The same files give the same
# bytes, in whatever folder and by whatever user: names are sorted, owners and permissions are made equal, and every file has
# the time of the newest, or that of SOURCE_DATE_EPOCH.
set -eu
umask 022
export LC_ALL=C
[ $# = 1 ] || { sed -n '2s/^# //p' "$0" >&2; exit 2; }
mkdir -p "$1"
folder=$(realpath "$1")
cd "$(dirname "$0")/.."
version=$(sed -n 's/^#define MAGICHOUR_VERSION "\(.*\)"/\1/p' src/base/version.h)
name=magichour-$version

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/$name"
# The folder may also have been unpacked inside of another repository.
if [ "$(git rev-parse --show-toplevel 2>/dev/null)" = "$(pwd -P)" ]; then
    [ -z "$(git status --porcelain)" ] || echo "dist: what is not committed is left out (see git status)" >&2
    git archive HEAD | tar -xf - -C "$work/$name"
else
    find . \( -path ./.git -o -path ./build -o -path ./out -o -path ./compile_commands.json \) -prune -o -type f -print0 |
        tar -cf - --null -T - | tar -xf - -C "$work/$name"
fi
newest=$(find "$work/$name" -type f -printf '%T@\n' | sort -n | tail -n 1)
tar -cf - -C "$work" --format=ustar --sort=name --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX \
    --mtime="@${SOURCE_DATE_EPOCH:-${newest%.*}}" "$name" | gzip -9n >"$work/archive"
mv "$work/archive" "$folder/$name.tar.gz"
echo "$(sha256sum <"$folder/$name.tar.gz" | cut -d ' ' -f 1)  $1/$name.tar.gz"
