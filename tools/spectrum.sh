#!/bin/sh
# Remakes src/scene/spectrum_figures.h: the wavelengths that colours are computed from, and their matrices.
# tools/spectrum.sh MAGICHOUR FOLDER [SETTING ...], such as tools/spectrum.sh build/magichour out/spectrum atmosphere.orders=all
#
# Colours of the sky are computed from 48 wavelengths, 360 to 830 nm, which count as true, and then from few. The rows are
#   heights 1 m to 20 km, suns from 90 to -6 degrees, views over the sky and toward the ground, without and with ozone;
#   with a SETTING, the same again with it, over grounds of four albedos, and suns at -7 and -8 degrees besides;
#   the sun's disk.
# tools/spectrum_fit.c says how wavelengths and matrices are found. Its report goes to FOLDER/report.txt. METHOD names the sky's method, and FURTHER that
# of the further orders. KEEP=1 keeps the wavelengths and finds the matrices alone.
set -eu
if [ $# -lt 2 ]; then sed -n '2,10s/^# \{0,1\}//p' "$0"; exit 2; fi
magichour=$1 folder=$2
shift 2
root=$(dirname "$0")/..
header=$root/src/scene/spectrum_figures.h
mkdir -p "$folder"

# list_rows "SUN ..."
list_rows() {
    awk -v list="$1" 'BEGIN {
        print "height_m,sun_el_deg,view_el_deg,az_deg"
        heights = split("1 1000 5000 20000", height, " ")
        suns = split(list, sun, " ")
        views = split("90 60 30 15 7 3 1 0.2 -2 -20", view, " ")
        azimuths = split("0 15 60 120 180", azimuth, " ")
        for (h = 1; h <= heights; h++) for (s = 1; s <= suns; s++) for (v = 1; v <= views; v++) {
            # From low heights the ground is near, and there is little air before it.
            if (view[v] < 0 && height[h] < 20000) continue
            count = view[v] == 90 || sun[s] == 90 ? 1 : azimuths
            for (a = 1; a <= count; a++) print height[h] "," sun[s] "," view[v] "," azimuth[a]
        }
    }'
}
suns="90 60 30 20 10 5 2 1 0 -1 -2 -3 -4 -5 -6"
list_rows "$suns" >"$folder/rows.csv"
list_rows "$suns -7 -8" >"$folder/more.csv"

# measure NAME ROWS [--set SETTING ...]: adds a file of radiances to the list.
files=""
measure() {
    name=$1 rows=$2
    shift 2
    "$magichour" sky --at "$folder/$rows.csv" --spectrum=360:830:10 --sky "${METHOD:-gauss:12}" \
        --further "${FURTHER:-harmonics:10}" "$@" -o "$folder/$name.csv"
    files="$files $folder/$name.csv"
    echo "spectrum: $name" >&2
}

settings=""
for setting in "$@"; do settings="$settings --set $setting"; done
for ozone in 0 1; do
    measure "ozone-$ozone" rows --set atmosphere.ozone=$ozone
    [ "$settings" ] || continue
    for albedo in 0 0.3 0.8 0.06,0.12,0.04; do
        # shellcheck disable=SC2086
        measure "set-ozone-$ozone-albedo-$albedo" more --set atmosphere.ozone=$ozone --set atmosphere.ground_albedo=$albedo $settings
    done
done

make -s -C "$root" build/tools/spectrum_fit
fit=$(realpath "$root/build/tools/spectrum_fit")
paths=""
for file in $files; do paths="$paths $(realpath "$file")"; done
report=$(realpath "$folder")/report.txt
# The program reads tests/data.
# shellcheck disable=SC2086
(cd "$root" && "$fit" $paths) >"$folder/figures.h" 2>"$report" || { cat "$report"; exit 1; }
cp "$folder/figures.h" "$header"
clang-format -i "$header"
cat "$report"
