#!/bin/sh
# Writes the tables of tests/README.md anew, between its two marker lines: tests/table.sh BUILD. Takes minutes.
set -eu
build=$1
cd "$(dirname "$0")/.."
rows=$(mktemp)
new=$(mktemp)
trap 'rm -f "$rows" "$new"' EXIT
export MAGICHOUR="$PWD/$build/magichour" MAGICHOUR_TABLE="$rows"
"$build/tests/test_scenes" test_furnace
"$build/tests/test_scenes" test_estimators
"$build/tests/test_noise"

table() {
    printf '\n%s\n\n%s\n' "$2" "$3"
    echo "$3" | sed 's/[^|]*|/---|/g; s/^---//'
    sed -n "s/^$1	//p" "$rows"
}

{
    sed '/^<!-- tables:/q' tests/README.md
    table furnaces "The furnaces of \`test_scenes\`: each scene white all over, 64x48 pixels, 128 samples." \
        "| Scene | Mean, less 1 | Limit | Worst pixel, off by |"
    table z-tests "The z-tests of \`test_scenes\`: the default methods against the plainest ones, without the sun's disk, 48x36 pixels, 8 seeds of 64 samples." \
        "| Scene | Means differ by | Limit | Mean z² | Expected | z beyond 4 | Expected |"
    table noise "The noise of \`test_noise\`, of 64 samples under the atmosphere \`simmons2017\`." \
        "| Scene | \`--sun-disk\` | Noise | Expected |"
    echo
    sed -n '/^<!-- end of the tables/,$p' tests/README.md
} >"$new"
cat "$new" >tests/README.md
