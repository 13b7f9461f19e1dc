#!/bin/sh
# Skies from noon to night and scenes under them: tools/skies.sh MAGICHOUR FOLDER GALLERY
# GALLERY/skies.png has a disk for each sun and atmosphere: the whole sky above the horizon, the zenith in the middle and the sun above.
# GALLERY/evening.png has scenes under the atmosphere `earth`. What lies between stays in FOLDER.
#
# Each sky and each scene has the exposure under which the mean luminance of the sky above the horizon is 0.25.
set -eu
export LC_ALL=C
magichour=$1
folder=$2
gallery=$3
tools=$(dirname "$0")
suns="60 10 2 0 -2 -4 -6 -8 -10 -12 -15"
mkdir -p "$folder" "$gallery"

# exposures ATMOSPHERE: a line "SUN EV" for each sun. The directions have the same solid angle each; the sky's two halves are alike.
exposures() {
    for sun in $suns; do
        awk -v sun="$sun" 'BEGIN {
            degree = atan2(0, -1) / 180
            for (i = 0; i < 24; i++) for (k = 0; k < 12; k++) {
                sine = (i + 0.5) / 24
                print "1," sun "," atan2(sine, sqrt(1 - sine * sine)) / degree "," 15 * k + 7.5
            }
        }'
    done | sed '1iheight_m,sun_el_deg,view_el_deg,az_deg' >"$folder/directions.csv"
    "$magichour" sky --at "$folder/directions.csv" --atmosphere "$1" --sky gauss:12 >"$folder/radiances.csv"
    awk -F, 'NR > 1 { if (!($2 in sum)) suns[++n] = $2; sum[$2] += (0.2126 * $5 + 0.7152 * $6 + 0.0722 * $7) / 288 }
        END { for (i = 1; i <= n; i++) printf "%s %.2f\n", suns[i], (sum[suns[i]] > 0 ? log(0.25 / sum[suns[i]]) / log(2) : 0) }' "$folder/radiances.csv"
}

# A mirror ball seen from far above shows the whole sky: the sine of half the angle from the zenith is the distance from the middle.
cat >"$folder/dome.glsl" <<'END'
//@ camera eye 0 100 0  target 0 0 0.0001  fov 0.83
#include "material/matte.glsl"
#include "material/mirror.glsl"
#include "shape/plane.glsl"
#include "shape/sphere.glsl"
void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_sphere(ray, vec3(0.0), 1.0, 0, hit);
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 1, hit);
}
Material scene_material(Hit hit) {
    if (hit.object == 1 || hit.normal.y < sqrt(0.5)) return matte(vec3(0.0));
    return mirror(vec3(1.0));
}
END

tile=128
per_row=6 # skies of each atmosphere
: >"$folder/skies.list"
row=0
for atmosphere in simmons2017 earth; do
    exposures $atmosphere >"$folder/exposures-$atmosphere"
    count=0
    while read -r sun exposure; do
        file=$folder/sky-$atmosphere-$sun.png
        "$magichour" render "$folder/dome.glsl" --atmosphere $atmosphere --sun "$sun,0" --exposure "$exposure" --size ${tile}x$tile --spp 64 --sky gauss:12 \
            --quiet -o "$file"
        echo "$((count % per_row)) $((2 * (count / per_row) + row)) $file $atmosphere, sun $sun" >>"$folder/skies.list"
        count=$((count + 1))
    done <"$folder/exposures-$atmosphere"
    row=$((row + 1))
done
gnuplot -c "$tools/sheet.gp" "$folder/skies.list" "$gallery/skies.png" $tile $tile
echo "skies: $gallery/skies.png"

: >"$folder/evening.list"
row=0
for scene in crater valley pillars; do
    column=0
    for sun in 60 10 2 -2 -4 -6; do
        file=$folder/$scene-$sun.png
        exposure=$(awk -v sun="$sun" '$1 == sun { print $2 }' "$folder/exposures-earth")
        # In twilight the sky alone may err by more, and status 7 says so.
        "$magichour" render "$tools/../scenes/$scene.glsl" --atmosphere earth --sun "$sun" --exposure "$exposure" --size 192x128 --error 0.7 \
            --quiet -o "$file" || [ $? -eq 7 ]
        echo "$column $row $file $scene, sun $sun" >>"$folder/evening.list"
        column=$((column + 1))
    done
    row=$((row + 1))
done
gnuplot -c "$tools/sheet.gp" "$folder/evening.list" "$gallery/evening.png" 192 128
echo "skies: $gallery/evening.png"
