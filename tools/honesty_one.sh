#!/bin/sh
# One picture of the study of tools/honesty.sh: honesty_one.sh SCENE SUN DISK PROMISE SEED, with the rest in the environment.
#
# Writes FOLDER/SCENE-SUN-DISK-PROMISE-SEED.row: what was asked for, the verdict, the true error over the promise, and the reason why there
# was no promise. Verdicts are promised, unpromised, slow (the limit of time interrupted it) and noisy (the reference's noise is more than half
# of the promise). What exists is kept. A picture whose easier promise was slow or noisy is so too, and is not rendered.
# shellcheck disable=SC2154
set -eu
scene=$1 sun=$2 disk=$3 promise=$4 seed=$5
name=$folder/$scene-$sun-$disk-$promise-$seed
[ ! -f "$name.row" ] || exit 0

number=${promise%levels}
measure=percent
[ "$number" = "$promise" ] || measure=levels

row() {
    echo "$scene,$sun,$disk,$measure,$number,$seed,$1,$2,$3,$4" >"$name.row.new"
    mv "$name.row.new" "$name.row"
    cat "$name.row"
}

for easier in "$folder/$scene-$sun-$disk"-*"-$seed.row"; do
    [ -f "$easier" ] || continue
    said=$(awk -F, -v measure=$measure -v number="$number" '$4 == measure && $5 > number && ($7 == "slow" || $7 == "noisy") { print $7 }' "$easier")
    [ -z "$said" ] || { row "$said" "" "" "as with the easier promise"; exit 0; }
done

method=sampled
[ "$disk" = on ] || method=off
timeout -s INT -k 20 "$limit" "$magichour" render "$scenes/$scene.glsl" --size 48x48 --sun "$sun" --sun-disk=$method --error "$promise" --seed "$seed" \
    --quiet --progress json -o "$name.exr" 2>"$name.json" || true
field() { sed -n "s/.*\"done\": true.*\"$1\": \"\{0,1\}\([^\",}]*\).*/\1/p" "$name.json"; }
promised=$(field promised)
[ -n "$promised" ] || { echo "honesty: $name: no picture" >&2; exit 1; }
true_error=$("$measures" "$name.exr" "$references/$scene-$sun-$disk-1.exr" "$references/$scene-$sun-$disk-2.exr")
# The true error and the reference's noise, both over the promise. The worst tile may be twice as bad as the picture.
ratios=$(echo "$true_error" | awk -v measure=$measure -v number="$number" '
    function take(error, noise) { if (error > worst) worst = error; if (noise > most) most = noise }
    $1 == measure { take($2 / number, $3 / number) }
    $1 == "tile" && measure == "levels" { take($2 / number / 2, $3 / number / 2) }
    END { printf "%.3f %.3f", worst, most }')
verdict=unpromised
if [ "$(field interrupted)" = true ]; then verdict=slow
elif [ "$(echo "$ratios" | awk '{ print ($2 > 0.5) }')" = 1 ]; then verdict=noisy
elif [ "$promised" = true ]; then verdict=promised; fi
row $verdict "${ratios% *}" "$(field samples)" "$(field unpromised_reason | tr ',' ';')"
