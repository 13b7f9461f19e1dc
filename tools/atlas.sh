#!/bin/sh
# Where each sky method breaks: tools/atlas.sh MAGICHOUR FOLDER CHARTS
# Charts of every method's error against the adaptive quadrature go to CHARTS/atlas-METHOD.{svg,png}, the table to
# CHARTS/atlas.md and to standard output; what lies between stays in FOLDER, the quadrature for the next time too.
set -eu
export LC_ALL=C
magichour=$1
folder=$2
charts=$3
tools=$(dirname "$0")
mkdir -p "$folder" "$charts"

# What the charts show, in words.
words() {
    case $1 in
    paper:16x4)
        echo "Sixteen even steps along a ray miss the 1.2 km of aerosols, and four toward the sun more so: from the ground it is"
        echo "wrong by 3 to 30 % with the sun above 10 degrees, by half or more near the horizon at low sun and in twilight. From"
        echo "10 km it is within 16 % by day. Where the planet's shadow cuts the ray a whole step is lit or dark: several times"
        echo "too bright, or black."
        ;;
    paper:64x16)
        echo "The same failures at a tenth of the size, 1 to 7 % from the ground. What stays bad, up to 100 %, is light from a"
        echo "stretch of the ray shorter than a step: the dark wedges about the horizon, with the sun at -2 to -3 seen from"
        echo "10 km and at -4 to -6 from 100 km."
        ;;
    gauss:4)
        echo "Some per cent near the horizon by day and 10 % in twilight: four nodes cannot follow a long ray through dense air."
        echo "It fails, by tens of per cent, where the sunlight itself grazes the ground and dims within a short stretch of the ray."
        ;;
    gauss:6)
        echo "Within 0.7 % from the ground by day, within 6 % always. Over 10 % only from 10 and 100 km, on rays near the horizon"
        echo "that meet grazing sunlight."
        ;;
    gauss:8)
        echo "Within 0.04 % from the ground by day, within 1 % always. Over 1 % in few places, all in blue: about the horizon seen"
        echo "from 100 km, and from 10 km with the sun at -2 to -3, where rays meet sunlight that grazes the ground."
        ;;
    gauss:12)
        echo "Within 0.001 % by day and 0.02 % always from the ground; most of it is float arithmetic and the closed form of the"
        echo "columns. The faults of gauss:8 are left as spots of 0.2 %."
        ;;
    table)
        echo "What gauss:8 errs, and by day some 0.1 % of the table's own, in stripes as wide as its texels. It is coarse at the edges"
        echo "of the planet's shadow, the red curves: interpolation blurs them, by some per cent and in single directions by"
        echo "more, and lets faint light into the shadow, which the last column shows once a sky is darker than its floor."
        ;;
    harmonics:8)
        echo "Within 3 % by day, and 0.2 to 0.4 % RMS. The largest errors are a band about the horizon: it is sharp, and eight"
        echo "degrees of harmonics about the sun's direction cannot follow it. In twilight they are up to 10 %, and with the sun below"
        echo "-6 up to 20 %."
        ;;
    harmonics:10)
        echo "The same band about the horizon at half to two thirds of the size: within 2 % by day. In twilight the largest errors are 6 % from"
        echo "1 m and from 10 km, and 8 % from 100 km."
        ;;
    harmonics:14)
        echo "Within 0.7 % by day, and 2 % in twilight from 1 m and 10 km. From 100 km, with the sun below -3, it is hardly better than"
        echo "harmonics:10. There the light comes from the edge of the planet's shadow, and the grid of altitudes and sun elevations"
        echo "is too coarse for it, whatever the harmonics."
        ;;
    esac
}

awk -v cells="$folder/cells" -v axes="$folder/axes" -f "$tools/atlas.grid.awk" >"$folder/grid.new"
cmp -s "$folder/grid.new" "$folder/grid.csv" || cp "$folder/grid.new" "$folder/grid.csv"
directions=$(wc -l <"$folder/cells")

# An air with all orders of scattering and a lit ground, in the settings' three channels.
with_all_orders() {
    "$@" --atmosphere simmons2017-ozone --orders all --set atmosphere.ground_albedo=0.1
}

# Computes the truth at all directions into FOLDER/NAME.csv, unless it is there: make_reference NAME OPTION...
make_reference() {
    reference=$folder/$1.csv
    shift
    if [ -n "$(find "$reference" -newer "$magichour" -newer "$folder/grid.csv" 2>/dev/null)" ]; then
        echo "atlas: $directions directions are there already: $reference"
        return
    fi
    echo "atlas: $directions directions by --sky reference, some minutes ..."
    "$magichour" sky --at "$folder/grid.csv" --sky reference --quiet "$@" >"$reference.new"
    mv "$reference.new" "$reference"
}

# Draws a method's chart and writes its part of atlas.md: chart NAME TRUTH OPTION..., after make_reference
chart() {
    name=$1
    file=atlas-$(echo "$name" | tr : -)
    truth=$2
    shift 2
    "$magichour" sky --at "$folder/grid.csv" --quiet "$@" >"$folder/method.csv"
    # The rows of the three agree; the CSVs have a header.
    { echo; cat "$folder/cells"; } | paste -d '|' - "$reference" "$folder/method.csv" | sed 1d >"$folder/all"
    awk -v map="$folder/map" -f "$tools/atlas.errors.awk" "$folder/all" "$folder/all" >"$folder/rows"
    gnuplot -c "$tools/atlas.gp" "$name" "$folder" "$charts/$file" "$truth"
    # Cells with sharp edges, as in the PNG; gnuplot leaves it to the viewer.
    sed -i 's/<image /<image style="image-rendering:pixelated" /' "$charts/$file.svg"
    {
        echo "## $name"
        echo
        echo "![$name]($file.png)"
        echo
        words "$name"
        echo
        echo "| height | sun | RMS / p99 / max, % | the largest: sun, view, azimuth, channel | RMS / p99 / max, %, floor 1e-3 of the mean |"
        echo "|---|---|---|---|---|"
        cat "$folder/rows"
        echo
    } >>"$folder/atlas.md"
    echo "atlas: $name: $charts/$file.svg, $charts/$file.png"
}

{
    cat <<'END'
# Where each sky method breaks

Made by `make atlas` (tools/atlas.sh), under the default atmosphere. The error of a channel is |L - Lref| / max(Lref, floor):
Lref by the adaptive quadrature (`--sky reference`), floor (1.43, 1.47, 1.54)e-6 for R, G, B, a millionth of the zenith's
radiance with the sun there. A chart's cell is the worst of three channels and five azimuths (0, 17, 61, 113 and 180
degrees from the sun's). Blue is fine, yellow is 0.1 %, red is wrong, grey has no light: the ground by night, the planet's
shadow, what is above the air.

The tables count the charts' directions alike, wherever there is light: they are dense about the visible horizon, so these
figures are worse than a mean over the sky. In the last column the floor is a thousandth of the mean of that sun's sky, as
the observer sees it above and below: what counts in a picture exposed for it, except that under a sun far below the horizon
it is the lower of the two. Angles in degrees, azimuth from the sun's.

END
} >"$folder/atlas.md"

make_reference reference
for method in paper:16x4 paper:64x16 gauss:4 gauss:6 gauss:8 gauss:12 table; do
    chart $method "the adaptive quadrature" --sky $method
done

cat >>"$folder/atlas.md" <<'END'
# Where the further orders of scattering break

The same for all orders of scattering above a ground of albedo 0.1, with ozone, in the settings' three channels:
`--atmosphere simmons2017-ozone --orders all --set atmosphere.ground_albedo=0.1`. The error is that of all light together. The
light that was scattered once is computed by `gauss:12`, so that what is shown is the error of `--further`. Lref is
`--sky reference`, which solves for all orders in double precision. The ground is lit by day, so that there is light below the
horizon too.

END
with_all_orders make_reference reference-orders
for further in harmonics:8 harmonics:10 harmonics:14; do
    with_all_orders chart $further "the reference of all orders" --sky gauss:12 --further $further
done
cp "$folder/atlas.md" "$charts/atlas.md"
cat "$charts/atlas.md"
