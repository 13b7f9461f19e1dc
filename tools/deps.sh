#!/bin/sh
# Installs what is missing, by the system's packages: tools/deps.sh [--missing] [build] [test] [lint] [ci] [figures]
# Says what it installs; needs nothing and does nothing when all is there. With --missing it installs nothing: it says what
# is missing and how to install it, and fails. The names are those of Debian 12, Debian 13 and Ubuntu 24.04.
set -eu

# build: the compilers, the window and picture libraries, and an OpenGL that runs on any machine (Mesa's llvmpipe).
build="gcc g++ make pkg-config libc6-dev libgl-dev libegl-dev libglfw3-dev libimgui-dev libopenexr-dev libpng-dev libcairo2-dev libegl1 libgl1-mesa-dri"
# test: the test framework, a display for the windows and hands for them, and GLM for the oracle.
test="libcmocka-dev xvfb xauth xdotool libglm-dev"
# lint: what `make lint` asks; ci: what .ci/run asks besides.
lint="clang-format glslang-tools git shellcheck cppcheck"
ci="clang"
# figures: what draws the READMEs' charts and contact sheets.
figures="gnuplot-nox fonts-dejavu-core"
# Used where the system still has it; without it the other backends do the work.
optional="libosmesa6"

only_say=""
if [ "${1-}" = --missing ]; then only_say=yes && shift; fi

if ! command -v dpkg-query >/dev/null 2>&1; then
    echo "deps: this is not Debian or Ubuntu; what is needed has other names here than: $build $test" >&2
    exit 0
fi

present() { dpkg-query -W -f '${db:Status-Abbrev}' "$1" 2>/dev/null | grep -q '^ii'; }

missing=""
for group in "${@:-build}"; do
    case $group in
    build) packages="$build" ;;
    test) packages="$test" ;;
    lint) packages="$lint" ;;
    ci) packages="$ci" ;;
    figures) packages="$figures" ;;
    *)
        echo "deps: unknown group '$group' (known: build, test, lint, ci, figures)" >&2
        exit 2
        ;;
    esac
    for package in $packages; do present "$package" || missing="$missing $package"; done
done

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

available() { apt-cache policy "$1" 2>/dev/null | grep -q 'Candidate: [0-9]'; }
unavailable() { for package in "$@"; do available "$package" || return 0; done; return 1; }

if [ -n "$missing" ]; then
    # A fresh machine has no package lists, or old ones.
    # shellcheck disable=SC2086
    if unavailable $missing || ! $root apt-get install -s --no-install-recommends $missing >/dev/null 2>&1; then
        $root apt-get update -q
    fi
fi
for package in $wanted; do available "$package" && missing="$missing $package"; done
[ -n "$missing" ] || exit 0
echo "deps: installing$missing"
# shellcheck disable=SC2086
$root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
