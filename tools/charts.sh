#!/bin/sh
# The READMEs' charts of speed against accuracy: tools/charts.sh MAGICHOUR FOLDER CHARTS [SECONDS]
#
# Measures each scene's chart for about SECONDS (90), and the crater's three charts for three times as long. FOLDER keeps what is measured, and CHARTS gets
# the pictures and tables. Points of other programs come from CHARTS/points-NAME.csv, which tools/points.sh measures.
# shellcheck disable=SC2086
set -eu
magichour=$1 folder=$2 charts=$3 seconds=${4:-90}
root=$(dirname "$0")/..
mkdir -p "$folder" "$charts"

# Measures a chart of paths: chart NAME SCENE OPTION...
chart() {
    name=$1 scene=$2
    shift 2
    points=
    [ ! -s "$charts/points-$name.csv" ] || points="--points $charts/points-$name.csv"
    "$magichour" chart "$root/$scene" -o "$folder/$name" $points "$@"
    cp "$folder/$name/paths.png" "$charts/chart-paths-$name.png"
    cp "$folder/$name/paths.csv" "$charts/chart-paths-$name.csv"
}

chart crater scenes/crater.glsl --time $((3 * seconds))
mv "$charts/chart-paths-crater.png" "$charts/chart-paths.png"
mv "$charts/chart-paths-crater.csv" "$charts/chart-paths.csv"
for kind in png csv; do
    cp "$folder/crater/sky.$kind" "$charts/chart-sky.$kind"
    cp "$folder/crater/scale.$kind" "$charts/chart-scale.$kind"
done
small="--size 128x128 --charts paths --time $seconds"
chart house scenes/house.glsl --sun 5 $small
chart arches scenes/arches.glsl $small
chart room tests/data/window_room.glsl $small
chart materials scenes/materials.glsl --sun-disk $small
chart glass tests/data/glass.glsl --set atmosphere.rayleigh=0 --set atmosphere.mie=0 $small
