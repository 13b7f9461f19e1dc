#!/bin/sh
# How fast two GLSL libraries march: tools/march_rates.sh MAGICHOUR BASE NEW [REPEATS [SCENES [OPTIONS]]]
#
# BASE and NEW are folders like glsl/. The scenes of each are those of the folder scenes/ beside it, or these here if there is none. The rate is
# that of paths a second of processor time: the time of 80 samples less that of 8, so that what a picture takes before its first sample does not count. The libraries take turns, REPEATS (5) times, and the order of the two
# changes each time. SCENES are names without .glsl, by default all whose surfaces are marched. OPTIONS are further ones of `render`, such
# as "--depth 1".
# One row for each scene: NEW's rate as a multiple of BASE's in the median turn, in the least and in the most, and how the pictures of 80
# samples, of the same seed, differ: their means by the channel that differs most, and relRMSE.
#
# Times are only comparable on a machine that does little else: the spread of the turns tells.
set -eu
export LC_ALL=C
usage() { sed -n '2,/^set/s/^# \{0,1\}//p' "$0" | sed '$d' >&2; exit 2; }
fail() { echo "march_rates: $1" >&2; exit 2; }
case $# in [3-6]) ;; *) usage ;; esac
magichour=$1 base=$2 new=$3 repeats=${4:-5} names=${5:-gyroid arches knot csg pillars valley julia menger} options=${6:-}
tools=$(dirname "$0")
# shellcheck source=tools/measure.sh
. "$tools/measure.sh"
scenes_of() { [ -d "$1/../scenes" ] && echo "$1/../scenes" || echo "$tools/../scenes"; }
command -v "$magichour" >/dev/null || fail "no program $magichour"
for library in "$base" "$new"; do [ -f "$library/shape/march.glsl" ] || fail "no shape/march.glsl in $library"; done
for name in $names; do
    for library in "$base" "$new"; do [ -f "$(scenes_of "$library")/$name.glsl" ] || fail "no scene $name beside $library"; done
done
[ "$repeats" -gt 0 ] 2>/dev/null || fail "REPEATS is a number above 0, not $repeats"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The seconds of processor time of a picture: seconds LIBRARY SCENE SAMPLES PICTURE
seconds() {
    # OPTIONS are words.
    # shellcheck disable=SC2086
    cpu_seconds "$work/messages" "$magichour" render "$(scenes_of "$1")/$2.glsl" --glsl-dir "$1" --size 256x192 --sky uniform --light cosine --spp "$3" \
        $options --quiet -o "$4"
}

# Adds the seconds of 72 samples to a list: march LIBRARY SCENE LIST
march() {
    few=$(seconds "$1" "$2" 8 "$work/few.pfm")
    many=$(seconds "$1" "$2" 80 "$work/$3.pfm")
    echo "$few $many" | awk '{ print $2 - $1 }' >>"$work/$3"
}

echo "| scene | rate, median | least | most | means differ by | relRMSE |"
echo "|---|---|---|---|---|---|"
for name in $names; do
    : >"$work/base"
    : >"$work/new"
    turn=0
    while [ $turn -lt "$repeats" ]; do
        [ $((turn % 2)) = 1 ] || march "$base" "$name" base
        march "$new" "$name" new
        [ $((turn % 2)) = 0 ] || march "$base" "$name" base
        turn=$((turn + 1))
    done
    rates=$(paste "$work/base" "$work/new" | awk '{ print $1 / $2 }' | sort -n | awk '
        { rate[NR] = $1 }
        END { printf "%.3f | %.3f | %.3f", (rate[int((NR + 1) / 2)] + rate[int(NR / 2) + 1]) / 2, rate[1], rate[NR] }')
    "$magichour" compare "$work/new.pfm" "$work/base.pfm" --json >"$work/difference"
    printf '| %s | %s | %s %% | %.4f %% |\n' "$name" "$rates" "$(largest_bias "$work/difference")" "$(json_number relRMSE "$work/difference")"
done
