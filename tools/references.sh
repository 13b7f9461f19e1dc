#!/bin/sh
# References of small pictures: tools/references.sh MAGICHOUR FOLDER [SIZE [SECONDS [SCENES [SUNS]]]]
#
# Renders each scene at each elevation of the sun, without its disk and with it, twice with different seeds, for SECONDS each or until
# the error is too small to matter. The halves FOLDER/SCENE-SUN-DISK-{1,2}.exr tell by their difference how noisy their mean is.
# What exists is kept, so that a run that was broken off goes on. LP_NUM_THREADS=1 leaves the other cores of the machine alone.
# Options are words without blanks in them.
# shellcheck disable=SC2046,SC2086
set -eu
magichour=$1 folder=$2 size=${3:-48x48} seconds=${4:-9} scenes=${5:-all} suns=${6:-60 30 5 -2}
root=$(dirname "$0")/..
[ "$scenes" != all ] || scenes=$(cd "$root/scenes" && for file in *.glsl; do echo "${file%.glsl}"; done)
mkdir -p "$folder"

# The most accurate sky that there is, unless the scene names its own.
sky_of() {
    grep -q '^//@ *sky ' "$1" || echo "--sky table:gauss:12@256x768 --further harmonics:14"
}

for sun in $suns; do for scene in $scenes; do for disk in off on; do for half in 1 2; do
    file=$root/scenes/$scene.glsl
    picture=$folder/$scene-$sun-$disk-$half.exr
    [ ! -f "$picture" ] || continue
    method=sampled
    [ $disk = on ] || method=off
    # A picture that is not finished does not look like one that is. That the time was up, status 7, is expected.
    status=0
    "$magichour" render "$file" --size "$size" --sun "$sun" --sun-disk=$method $(sky_of "$file") \
        --time "$seconds" --error 0.12 --seed "$((1000 + half))" --quiet \
        -o "$folder/unfinished.exr" 2>"$folder/unfinished.log" || status=$?
    [ $status = 0 ] || [ $status = 7 ] || {
        cat "$folder/unfinished.log" >&2
        exit 1
    }
    mv "$folder/unfinished.exr" "$picture"
    echo "references: $picture"
done; done; done; done
