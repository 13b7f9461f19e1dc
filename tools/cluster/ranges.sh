#!/usr/bin/env bash
# Cuts a picture into parts by its samples: tools/cluster/ranges.sh PARTS SAMPLES DIR SCENE [options of render]. Writes DIR/jobs, a
# render a line, for slurm.sh and parallel.sh, and as its last line the command that merges the parts to DIR/whole.exr.
set -euo pipefail
[ $# -ge 4 ] || { echo "usage: tools/cluster/ranges.sh PARTS SAMPLES DIR SCENE [options of render]" >&2; exit 2; }
parts=$1 samples=$2 folder=$3
shift 3
magichour=${MAGICHOUR:-$(dirname "$0")/../../build/magichour}
# Each part begins with a whole group of samples, so that the sum is the same to the bit as one run.
groups=$(((samples + parts * 16 - 1) / (parts * 16)))
step=$((16 * groups))
mkdir -p "$folder"
names=()
for ((first = 0; first < samples; first += step)); do
    count=$((samples - first < step ? samples - first : step))
    name=$folder/part-$(printf %04d ${#names[@]}).exr
    names+=("$name")
    printf '%q ' "$magichour" render "$@" --first-sample $first --spp $count --of "$samples" -o "$name"
    echo
done >"$folder/jobs"
{ printf '#then: ' && printf '%q ' "$magichour" merge "${names[@]}" --final -o "$folder/whole.exr" && echo; } >>"$folder/jobs"
echo "$folder/jobs: ${#names[@]} parts of $step samples"
