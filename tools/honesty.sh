#!/bin/sh
# Does --error keep its word? tools/honesty.sh MAGICHOUR TRUE_ERROR FOLDER REFERENCES [SEEDS [PROMISES [SCENES [SUNS [PROCESSES]]]]]
#
# Renders each scene at each elevation of the sun, without its disk and with it, with each promise and each seed, and measures the true error
# by the references of tools/references.sh, whose own noise is taken off. What exists in FOLDER is kept, so that a run that was broken off
# goes on; a limit of LIMIT seconds (20) ends a picture that takes longer. FOLDER/honesty.md gets the tables.
# LP_NUM_THREADS=1 and PROCESSES say how many cores are used. SEEDS are numbers with blanks between them.
# shellcheck disable=SC2086
set -eu
export LC_ALL=C
magichour=$1 measures=$2 folder=$3 references=$4 seeds=${5:-1 2} promises=${6:-5 4levels 2 2levels 1} names=${7:-all} suns=${8:-60 30 5 -2} processes=${9:-2}
limit=${LIMIT:-20}
tools=$(dirname "$0")
scenes=$tools/../scenes
export magichour measures folder references limit scenes
[ "$names" != all ] || names=$(cd "$scenes" && for file in *.glsl; do echo "${file%.glsl}"; done)
mkdir -p "$folder"

# The cheapest promises come first, and each ends before the next one begins, which may depend on its verdicts.
for seed in $seeds; do for promise in $promises; do
    for sun in $suns; do for scene in $names; do for disk in off on; do
        [ ! -f "$references/$scene-$sun-$disk-2.exr" ] || echo "$scene $sun $disk $promise $seed"
    done; done; done | xargs -r -L 1 -P "$processes" sh "$tools/honesty_one.sh"
done; done

cat "$folder"/*.row >"$folder/honesty.csv"
awk -f "$tools/honesty.table.awk" "$folder/honesty.csv" >"$folder/honesty.md"
cat "$folder/honesty.md"
