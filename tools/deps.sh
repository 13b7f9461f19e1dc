#!/bin/sh
# Installs what is missing, by the system's packages: tools/deps.sh [--missing] [GROUP...]; the groups are listed below.
# Says what it installs; needs nothing and does nothing when all is there. With --missing it installs nothing: it says what
# is missing and how to install it, and fails. The names are those of Debian 12, Debian 13 and Ubuntu 24.04.
set -eu

groups="build window chart almanac test window-test web lint ci cluster fuzz figures"
packages_of() {
    case $1 in
    # The compilers, the libraries of picture formats, and an OpenGL that runs on any machine (Mesa's llvmpipe).
    build) echo gcc g++ make pkg-config libc6-dev libgl-dev libegl-dev libopenexr-dev libpng-dev libegl1 libgl1-mesa-dri ;;
    # The window of `view`, which WINDOW=0 leaves out, and the charts, which CHART=0 leaves out.
    window) echo libglfw3-dev libimgui-dev ;;
    chart) echo libcairo2-dev ;;
    # Where the sun stands at a place and a time, which ALMANAC=0 leaves out.
    almanac) echo liberfa-dev ;;
    # The test framework, and GLM for the oracle; a display for the windows, and hands for them.
    test) echo libcmocka-dev libglm-dev ;;
    window-test) echo xvfb xauth xdotool ;;
    # The tests in a browser: the JSON of its debugging protocol. The browser itself is optional.
    web) echo libjansson-dev ;;
    # What `make lint` asks, and what .ci/run asks besides.
    lint) echo clang-format glslang-tools git shellcheck cppcheck ;;
    ci) echo clang ;;
    # What tools/cluster/ uses: Slurm with its authentication, and GNU parallel.
    cluster) echo slurm-wlm slurmctld slurmd munge parallel ;;
    # What `make fuzz` needs besides: the runtime of the compiler that `clang` stands for.
    fuzz) echo clang "$(apt-cache depends clang 2>/dev/null | sed -n 's/.*Depends: clang-\([0-9]*\)$/libclang-rt-\1-dev/p' | head -n 1)" ;;
    # What draws the READMEs' charts and contact sheets.
    figures) echo gnuplot-nox fonts-dejavu-core ;;
    *) echo "deps: unknown group '$1' (known: $groups)" >&2 && return 2 ;;
    esac
}
# Used where the system still has it. Without OSMesa the other backends do the work; without Chromium its tests are skipped.
optional_of() { [ "$1" != web ] || echo chromium; }
optional="libosmesa6"

only_say=""
if [ "${1-}" = --missing ]; then only_say=yes && shift; fi

needed=""
for group in "${@:-build}"; do
    needed="$needed $(packages_of "$group")"
    optional="$optional $(optional_of "$group")"
done

if ! command -v dpkg-query >/dev/null 2>&1; then
    echo "deps: this is not Debian or Ubuntu; what is needed has other names here than:$needed" >&2
    exit 0
fi

present() { dpkg-query -W -f '${db:Status-Abbrev}' "$1" 2>/dev/null | grep -q '^ii'; }

missing=""
for package in $needed; do present "$package" || missing="$missing $package"; done

if [ -n "$only_say" ]; then
    [ -n "$missing" ] || exit 0
    echo "missing:$missing" >&2
    echo "\`make deps\` installs them, and so does, as root: apt-get install --no-install-recommends$missing" >&2
    exit 1
fi

wanted=""
for package in $optional; do present "$package" || wanted="$wanted $package"; done
[ -n "$missing$wanted" ] || exit 0

root=""
if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null 2>&1; then
        root="sudo"
    elif [ -n "$missing" ]; then
        echo "deps: not root and no sudo here; as root, install:$missing" >&2
        exit 1
    else
        exit 0
    fi
fi

# Ubuntu's package of a snap holds no program that runs in a container.
available() { apt-cache policy "$1" 2>/dev/null | grep 'Candidate: [0-9]' | grep -qv snap; }
unavailable() { for package in "$@"; do available "$package" || return 0; done; return 1; }

if [ -n "$missing" ]; then
    echo "deps: this system lacks$missing; apt-get installs them now${root:+, by $root}"
    # A fresh machine has no package lists, or old ones.
    # shellcheck disable=SC2086
    if unavailable $missing || ! $root apt-get install -s --no-install-recommends $missing >/dev/null 2>&1; then
        $root apt-get update -q
    fi
fi
for package in $wanted; do available "$package" && missing="$missing $package"; done
[ -n "$missing" ] || exit 0
# shellcheck disable=SC2086
size=$($root apt-get install --assume-no --no-install-recommends $missing 2>/dev/null | grep -E '^(Need to get|After this)' || true)
echo "deps: installing$missing"
[ -z "$size" ] || echo "$size"
# shellcheck disable=SC2086
$root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
