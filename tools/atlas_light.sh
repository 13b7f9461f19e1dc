#!/bin/sh
# Which light method is the fastest where: tools/atlas_light.sh MAGICHOUR FOLDER CHARTS [SCENES [SUNS]]
#
# Renders each scene by each light method that it has a use for, at four elevations of the sun, without its disk and with it (`on`: scenes that
# throw sunlight trace it): once with some samples and once with twice as many. The difference of the two pictures gives the noise of a sample. Its time is that of the CPU in a longer run, less
# that of a run of one sample, so that neither the start-up nor a busy machine decides it. It is measured with the sun at 30 only, as it hardly
# depends on the sun that is up. CHARTS gets atlas-light.{csv,md,png}. What is measured is kept in FOLDER, so that a run that was broken off
# goes on.
# shellcheck disable=SC2046,SC2086
set -eu
export LC_ALL=C LP_NUM_THREADS=1
magichour=$1 folder=$2 charts=$3 scenes=${4:-all} suns=${5:-60 30 5 -2}
tools=$(dirname "$0")
root=$tools/..
# shellcheck source=tools/measure.sh
. "$tools/measure.sh"
size=48x48 pixels=2304
[ "$scenes" != all ] || scenes=$(cd "$root/scenes" && for file in *.glsl; do echo "${file%.glsl}"; done)
mkdir -p "$folder" "$charts"

# What all methods get alike: a table, without which `control` looks the sky up twice. Bias cancels in the difference. The light that
# was scattered more than once is left out: it is smooth, and its tables would take longer than the pictures.
sky_of() {
    grep -q '^//@ *sky ' "$1" || echo "--sky table:gauss:8 --orders 1"
}

options_of() {
    if [ "$3" = on ]; then disk_option=--sun-disk; else disk_option=--sun-disk=$3; fi
    echo "$root/scenes/$1.glsl --sun $2 $disk_option --size $size $(sky_of "$root/scenes/$1.glsl")"
}

lights_of() {
    echo cosine control mis
    ! grep -q '^//@ *portal' "$root/scenes/$1.glsl" || echo portal
}

# Renders and prints the processor's seconds. What it says as JSON goes to a file: render_seconds FILE OPTION...
render_seconds() {
    said=$1
    shift
    cpu_seconds "$said" "$magichour" render "$@" --quiet --progress json -o "$folder/timed.$$.pfm"
}

# Adds a measurement of a path's time: the CPU seconds of a run of one sample, those of a longer run, and its paths. time_once NAME OPTION...
time_once() {
    kept=$folder/$1.times
    shift
    start=$(render_seconds "$folder/timed.$$.json" "$@" --spp 1)
    all=$(render_seconds "$folder/timed.$$.json" "$@" --spp 1000000 --time 1.2)
    echo "$start $all $(json_number paths "$folder/timed.$$.json")" >>"$kept"
}

# The nanoseconds of a path in each method of a scene: the least of several runs in turns. The driver keeps compiled programs, so that the first
# start is longer than the others. times_of SCENE DISK
times_of() {
    lights=$(lights_of "$1")
    [ ! -s "$folder/$1-$2-cosine.ns" ] || return 0
    for light in $lights; do rm -f "$folder/$1-$2-$light.times"; done
    for turn in 1 2 3 4; do for light in $lights; do
        time_once "$1-$2-$light" $(options_of "$1" 30 "$2") --light "$light" --seed "$turn"
    done; done
    for light in $lights; do
        awk 'NR == 1 || $1 < start { start = $1 } { all[NR] = $2; paths[NR] = $3 }
            END { for (i = 1; i <= NR; i++) { ns = 1e9 * (all[i] - start) / paths[i]; if (i == 1 || ns < least) least = ns } print least }' \
            "$folder/$1-$2-$light.times" >"$folder/$1-$2-$light.ns"
    done
}

# A picture for the noise: noise_of NAME SAMPLES SEED OPTION...
noise_of() {
    name=$folder/$1 spp=$2 seed=$3
    shift 3
    [ -s "$name.pfm" ] || {
        "$magichour" render "$@" --spp "$spp" --seed "$seed" --quiet --progress json -o "$folder/unfinished.$$.pfm" 2>"$name.json"
        mv "$folder/unfinished.$$.pfm" "$name.pfm"
    }
}

# A power of two of samples that take 0.15 s or more, by the measured time.
samples_of() {
    [ -s "$folder/$1.samples" ] || awk -v pixels=$pixels '{ for (p = 64; p * pixels * $1 < 0.15e9 && p < 2048; p *= 2); print p }' "$folder/$1-cosine.ns" >"$folder/$1.samples"
    cat "$folder/$1.samples"
}

for scene in $scenes; do for disk in off on; do
    times_of "$scene" "$disk"
    echo "atlas-light: time of $scene-$disk"
done; done

for sun in $suns; do for scene in $scenes; do for disk in off on; do
    options=$(options_of "$scene" "$sun" $disk)
    cell=$scene-$sun-$disk
    samples=$(samples_of "$scene-$disk")
    for light in $(lights_of "$scene"); do
        noise_of "$cell-$light-1" "$samples" 1 $options --light $light
        noise_of "$cell-$light-2" "$((2 * samples))" 2 $options --light $light
    done
    [ -s "$folder/$cell.auto" ] || "$magichour" render $options --spp 1 -v -o "$folder/timed.$$.pfm" 2>&1 |
        sed -n 's/^sky.* light \([a-z]*\),.*/\1/p' >"$folder/$cell.auto"
    echo "atlas-light: $cell"
done; done; done
rm -f "$folder"/timed.$$.*

# The file with the time of a path. Below the horizon the sun's disk costs nothing.
ns_file() {
    if [ "$2" -lt 0 ]; then echo "$folder/$1-off-$4.ns"; else echo "$folder/$1-$3-$4.ns"; fi
}

echo "scene,sun,disk,light,samples,ns_a_path,percent_of_one_sample,share_of_ten_pixels,specks,estimated_over_true,auto" >"$folder/atlas-light.csv"
for scene in $scenes; do for disk in off on; do for sun in $suns; do
    cell=$scene-$sun-$disk
    for light in $(lights_of "$scene"); do
        name=$folder/$cell-$light
        pfm_values "$name-1.pfm" >"$folder/values.1"
        pfm_values "$name-2.pfm" >"$folder/values.2"
        paste "$folder/values.1" "$folder/values.2" |
            awk -v row="$scene,$sun,$disk,$light" -v auto="$(cat "$folder/$cell.auto")" -v ns="$(cat "$(ns_file "$scene" "$sun" $disk $light)")" \
                -v pixels=$pixels -v samples="$(json_number samples "$name-1.json")" \
                -v estimated="$(json_number noise_percent "$name-2.json")" \
                -f "$tools/atlas_light.errors.awk" >>"$folder/atlas-light.csv"
    done
done; done; done
awk -v map="$folder/map" -f "$tools/atlas_light.table.awk" "$folder/atlas-light.csv" >"$folder/atlas-light.md"
gnuplot -c "$tools/atlas_light.gp" "$folder" "$charts/atlas-light.png"
cp "$folder/atlas-light.csv" "$folder/atlas-light.md" "$charts"
cat "$charts/atlas-light.md"
