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

# What the charts show, in words; they follow from the table beneath.
words() {
    case $1 in
    *) echo "TODO" ;;
    esac
}

awk -v cells="$folder/cells" -v axes="$folder/axes" -f "$tools/atlas.grid.awk" >"$folder/grid.new"
cmp -s "$folder/grid.new" "$folder/grid.csv" || cp "$folder/grid.new" "$folder/grid.csv"
directions=$(wc -l <"$folder/cells")

reference=$folder/reference.csv
if [ -n "$(find "$reference" -newer "$magichour" -newer "$folder/grid.csv" 2>/dev/null)" ]; then
    echo "atlas: the quadrature's $directions directions are there already: $reference"
else
    echo "atlas: the adaptive quadrature, $directions directions, a minute or two ..."
    "$magichour" sky --at "$folder/grid.csv" --sky reference --quiet >"$reference.new"
    mv "$reference.new" "$reference"
fi

{
    cat <<'END'
# Where each sky method breaks

END
} >"$folder/atlas.md"

for method in paper:16x4 paper:64x16 gauss:4 gauss:6 gauss:8 gauss:12 table; do
    name=atlas-$(echo $method | tr : -)
    "$magichour" sky --at "$folder/grid.csv" --sky $method --quiet >"$folder/method.csv"
    # The rows of the three agree; the CSVs have a header.
    { echo; cat "$folder/cells"; } | paste -d '|' - "$reference" "$folder/method.csv" | sed 1d >"$folder/all"
    awk -v map="$folder/map" -f "$tools/atlas.errors.awk" "$folder/all" "$folder/all" >"$folder/rows"
    gnuplot -c "$tools/atlas.gp" $method "$folder" "$charts/$name"
    {
        echo "## $method"
        echo
        echo "![$method]($name.png)"
        echo
        words $method
        echo
        echo "| height | sun, degrees | RMS / p99 / max, % | the largest at | with the higher floor |"
        echo "|---|---|---|---|---|"
        cat "$folder/rows"
        echo
    } >>"$folder/atlas.md"
    echo "atlas: $method: $charts/$name.svg, $charts/$name.png"
done
cp "$folder/atlas.md" "$charts/atlas.md"
cat "$charts/atlas.md"
