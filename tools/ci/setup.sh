#!/bin/sh
# Builds and installs magichour without its window, on a bare Debian or Ubuntu, as root: setup.sh ARCHIVE
# ARCHIVE is what `make dist` makes, magichour-VERSION.tar.gz.
set -eu
archive=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tar -xzf "$archive" -C "$work" --strip-components=1
cd "$work"
tools/deps.sh build almanac
make -j"$(nproc)" WINDOW=0 CHART=0 all
make WINDOW=0 CHART=0 install
