#!/bin/sh
# What another renderer and the paper's own method reach, for the charts: tools/points.sh MAGICHOUR CHARTS [PYTHON]
#
# Writes CHARTS/points-{crater,glass,room}.csv. PYTHON has Mitsuba, as tools/peer_error.py says. The paper's own method has a picture of its own, so its error
# is that between two seeds over the square root of two, as Mitsuba's is.
set -eu
export LC_ALL=C
magichour=$1 charts=$2 python=${3:-python3}
root=$(dirname "$0")/..
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Renders the crater by the paper's own method and prints the seconds: paper SAMPLES SEED
paper() {
    "$magichour" render "$root/scenes/crater.glsl" --size 256x256 --sky paper:16x4 --light paper --sequence random --spp "$1" --seed "$2" \
        --quiet --progress json -o "$work/$2.pfm" 2>"$work/said"
    sed -n 's/.*"done": true.*"seconds": \([0-9.e+-]*\).*/\1/p' "$work/said"
}

for name in crater glass room; do
    MAGICHOUR=$magichour "$python" "$root/tools/peer_error.py" $name >"$work/$name.csv"
done
for samples in 4 16 64 256; do
    seconds=$(paper $samples 1)
    paper $samples 2 >"$work/seconds"
    "$magichour" compare "$work/1.pfm" "$work/2.pfm" --json |
        sed -n 's/.*"relRMSE": \([0-9.e+-]*\).*/\1/p' |
        awk -v seconds="$seconds" '{ printf "the paper'"'"'s own method,%.4g,%.4g\n", seconds, $1 / sqrt(2) }' >>"$work/crater.csv"
done
mkdir -p "$charts"
for name in crater glass room; do cp "$work/$name.csv" "$charts/points-$name.csv"; done
