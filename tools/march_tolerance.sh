#!/bin/sh
# What the tolerances of a march cost and what they leave: tools/march_tolerance.sh MAGICHOUR FOLDER CHARTS [TURNS]
#
# MARCH_PRECISION and MARCH_SLACK (glsl/shape/march_*.glsl) are multiplied, one at a time, in copies of the library. The scenes are csg,
# gyroid and knot, and two whose exact shapes are known: a ball, and wires of 0.4 mm behind each other, 4 m away (tests/test_wires.c). Pictures
# with the same random numbers are compared: those of the ball and the wires with the exact shapes, the others with the finest tolerance of the same
# kind. `--depth 1` keeps the difference of a path from growing with its bounces.
# CHARTS gets march-tolerance.png and march-tolerance.csv, with a row for each tolerance and scene:
#   steps            of a ray, on average
#   time             processor time of 192 samples at all depths, as a multiple of that with the library's own tolerance: the median of TURNS (3) turns
#   relrmse_percent  of the picture at --depth 1
#   share_percent    of its values that differ by more than a ten-thousandth
#   levels           RMS difference of the picture as it is shown, of 255
#   bias_percent     of the mean at all depths, in the channel that differs most
# FOLDER keeps the libraries and the pictures. Nothing else should run at the same time.
set -eu
export LC_ALL=C
case $# in [34]) ;; *) sed -n '2,/^set/s/^# \{0,1\}//p' "$0" | sed '$d' >&2; exit 2 ;; esac
magichour=$1 folder=$2 charts=$3 turns=${4:-3}
tools=$(dirname "$0")
root=$tools/..
# shellcheck source=tools/measure.sh
. "$tools/measure.sh"
scenes="csg gyroid knot ball wires"
mkdir -p "$folder" "$charts"

# A line for each tolerance: which one, and what it is multiplied by. The first of each is the finest.
tolerances() {
    for factor in 0.25 1 4 16 64 256; do echo "precision $factor"; done
    for factor in 0 0.3 1 3 10 30; do echo "slack $factor"; done
}

# Copies the library, with one tolerance multiplied: make_library KIND FACTOR
make_library() {
    case $1 in
    precision) constant=MARCH_PRECISION file=shape/march_field.glsl ;;
    slack) constant=MARCH_SLACK file=shape/march_quick.glsl ;;
    esac
    library=$folder/glsl-$1-$2
    rm -rf "$library"
    cp -R "$root/glsl" "$library"
    awk -v constant="$constant" -v factor="$2" '
        $3 == constant && $4 == "=" { sub(/= .*;/, sprintf("= %.3e;", factor * $5)); found = 1 }
        { print }
        END { exit !found }' "$root/glsl/$file" >"$library/$file"
}

# Scenes whose exact shapes are known, each marched and exact.
write_scenes() {
    cat >"$folder/ball.glsl" <<'SCENE'
//@ camera eye 0 2 -4  target 0 0.9 0  fov 40
#include "color/checker.glsl"
#include "distance/sphere.glsl"
#include "material/matte.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"
#include "shape/sphere.glsl"
float scene_distance(vec3 p) {
    return distance_sphere(p, vec3(0.0, 1.0, 0.0), 1.0);
}
void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);
    march(ray, vec3(0.0, 1.0, 0.0), 1.0, 1, hit);
}
Material scene_material(Hit hit) {
    if (hit.object == 1) return matte(vec3(0.7));
    return matte(checker(hit.position, vec3(0.7), vec3(0.3)));
}
SCENE
    sed 's/ march(/ hit_sphere(/' "$folder/ball.glsl" >"$folder/ball-exact.glsl"
    cat >"$folder/wires.glsl" <<'SCENE'
//@ camera eye 0 -0.3 -4  target 0 0 0  fov 0.08
#include "distance/capsule.glsl"
#include "material/matte.glsl"
#include "shape/capsule.glsl"
#include "shape/march.glsl"
const float RADIUS = 0.2e-3;
vec3 at(int i, float y) {
    return RADIUS * vec3(8.0 * float(i % 3 - 1) + 1.7 * float(i / 3), y / RADIUS, 9.0 * float(i / 3 - 1));
}
float scene_distance(vec3 p) {
    float d = INFINITY;
    for (int i = 0; i < 9; i++) d = min(d, distance_capsule(p, at(i, -0.5), at(i, 0.5), RADIUS));
    return d;
}
void scene_intersect(Ray ray, INOUT(Hit) hit) {
    march(ray, 1, hit);
}
Material scene_material(Hit hit) {
    return matte(vec3(0.3));
}
SCENE
    sed 's/ march(.*/ for (int i = 0; i < 9; i++) hit_capsule(ray, at(i, -0.5), at(i, 0.5), RADIUS, 1, hit);/' "$folder/wires.glsl" \
        >"$folder/wires-exact.glsl"
}

file_of() {
    if [ -f "$folder/$1.glsl" ]; then echo "$folder/$1.glsl"; else echo "$root/scenes/$1.glsl"; fi
}

# Renders by a library, and prints the seconds of processor time: render NAME SCENE LIBRARY OPTION...
render() {
    name=$folder/$1 scene=$2 library=$3
    shift 3
    cpu_seconds "$name.json" "$magichour" render "$(file_of "$scene")" --glsl-dir "$library" --size 192x144 --light cosine "$@" \
        --quiet --progress json -o "$name.pfm"
}

# The share of the values of two pictures that differ by more than a ten-thousandth of the larger.
share() {
    pfm_values "$1" >"$folder/values.1"
    pfm_values "$2" | paste - "$folder/values.1" | awk '
        function size(x) { return x < 0 ? -x : x }
        { most = size($1) > size($2) ? size($1) : size($2); n += size($1 - $2) > 1e-4 * most }
        END { printf "%.4f", 100 * n / NR }'
}

# Seconds of 192 samples without the time to start.
march_seconds() {
    few=$(render timed "$1" "$2" --sky uniform --spp 8)
    many=$(render timed "$1" "$2" --sky uniform --spp 200)
    echo "$few $many" | awk '{ print $2 - $1 }'
}

# The median of the times of a tolerance in a scene, as multiples of the library's own in the same turn: relative_time KIND FACTOR SCENE
relative_time() {
    awk -v kind="$1" -v factor="$2" -v scene="$3" '
        $2 != kind || $4 != scene { next }
        $3 == 1 { own[$1] = $5 }
        $3 == factor { time[$1] = $5 }
        END { for (turn in own) print time[turn] / own[turn] }' "$folder/times" | sort -n |
        awk '{ time[NR] = $1 } END { printf "%.3f", (time[int((NR + 1) / 2)] + time[int(NR / 2) + 1]) / 2 }'
}

# A row of the table: row KIND FACTOR SCENE TRUTH, where TRUTH names the pictures that count as true.
row() {
    picture=$folder/$3-$1-$2
    "$magichour" compare "$picture.pfm" "$folder/$4.pfm" --json >"$folder/error"
    "$magichour" compare "$picture-deep.pfm" "$folder/$4-deep.pfm" --json >"$folder/bias"
    steps=$(awk -v steps="$(json_number search_steps "$picture.json")" -v rays="$(json_number search_rays "$picture.json")" \
        'BEGIN { printf "%.2f", steps / rays }')
    printf '%s,%s,%s,%s,%s,%.4g,%s,%.4g,%s\n' "$1" "$2" "$3" "$steps" "$(relative_time "$1" "$2" "$3")" "$(json_number relRMSE "$folder/error")" \
        "$(share "$picture.pfm" "$folder/$4.pfm")" "$(json_number levels_RMS "$folder/error")" "$(largest_bias "$folder/bias")"
}

# The pictures whose errors are measured, at one hit and at all depths: draw NAME SCENE LIBRARY
draw() {
    render "$1" "$2" "$3" --sky gauss:4 --spp 64 --depth 1 >"$folder/seconds"
    render "$1-deep" "$2" "$3" --sky gauss:4 --spp 64 >"$folder/seconds"
}

write_scenes
for scene in ball wires; do draw "$scene-exact" "$scene-exact" "$root/glsl"; done
tolerances | while read -r kind factor; do
    make_library "$kind" "$factor"
    for scene in $scenes; do draw "$scene-$kind-$factor" "$scene" "$folder/glsl-$kind-$factor"; done
done
echo "march_tolerance: the pictures are drawn" >&2

for turn in $(seq "$turns"); do
    for scene in $scenes; do
        tolerances | while read -r kind factor; do
            echo "$turn $kind $factor $scene $(march_seconds "$scene" "$folder/glsl-$kind-$factor")"
        done
    done
    echo "march_tolerance: turn $turn of $turns" >&2
done >"$folder/times"

{
    echo "kind,factor,scene,steps,time,relrmse_percent,share_percent,levels,bias_percent"
    tolerances | while read -r kind factor; do
        for scene in $scenes; do
            truth=$scene-$kind-$(tolerances | awk -v kind="$kind" '$1 == kind { print $2; exit }')
            [ ! -f "$folder/$scene-exact.pfm" ] || truth=$scene-exact
            row "$kind" "$factor" "$scene" "$truth"
        done
    done
} >"$folder/march-tolerance.csv"
gnuplot -c "$tools/march_tolerance.gp" "$folder/march-tolerance.csv" "$charts/march-tolerance.png"
cp "$folder/march-tolerance.csv" "$charts"
echo "march_tolerance: $charts/march-tolerance.png"
