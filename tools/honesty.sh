#!/bin/sh
# Does --error keep its word? tools/honesty.sh MAGICHOUR FOLDER [SIZE [SEEDS [SCENES [SUNS [PERCENTS]]]]]
#
# Renders each scene at each sun, without the sun's disk and with it, with each seed and each error asked for, and compares with
# a reference of 50 times the samples and another seed (kept in FOLDER). With the disk both are without the 0.1 % worst pixels.
# Says how many kept their word and the median of true over promised; fails under 90 % or under one half. What `render` itself warns of,
# sunlight that only chance finds, is counted apart.
# Options are words without blanks in them, and conditions are awk's.
# shellcheck disable=SC2016,SC2086
set -eu
magichour=$1 folder=$2 size=${3:-48x48} seeds=${4:-1 2} scenes=${5:-crater fences valley mirrors} suns=${6:-60 30 5 -2} percents=${7:-2 1}
root=$(dirname "$0")/..
mkdir -p "$folder"
rows=$folder/honesty.csv
echo "scene,sun,disk,percent,seed,samples,estimated,true,warned" >"$rows"

# The value of a JSON line's field.
field() { sed -n "s/.*\"done\": true.*\"$1\": \([-0-9.e+]*\).*/\1/p"; }

for scene in $scenes; do for sun in $suns; do for disk in off on; do
    options="--size $size --sun $sun"
    line=relRMSE
    if [ $disk = on ]; then options="$options --sun-disk" line=trimmed; fi
    for percent in $percents; do
        most=0
        for seed in $seeds; do
            picture=$folder/$scene-$sun-$disk-$percent-$seed.exr
            "$magichour" render "$root/scenes/$scene.glsl" $options --error "$percent" --seed "$seed" -o "$picture" \
                --quiet --progress json 2>"$picture.json"
            samples=$(field samples <"$picture.json")
            most=$(echo "$samples $most" | awk '{ print ($1 > $2 ? $1 : $2) }')
        done
        wanted=$(echo "$most" | awk '{ printf "%d", 50 * $1 }')
        reference=$folder/$scene-$sun-$disk-$percent-reference.exr
        [ -f "$reference" ] || "$magichour" render "$root/scenes/$scene.glsl" $options --spp "$wanted" --seed 1000 -o "$reference" --quiet
        for seed in $seeds; do
            picture=$folder/$scene-$sun-$disk-$percent-$seed.exr
            true=$("$magichour" compare "$picture" "$reference" | awk -v line=$line '$1 == line { print $2 }')
            echo "$scene,$sun,$disk,$percent,$seed,$(field samples <"$picture.json"),$(field error_percent <"$picture.json"),$true,$(grep -c sun_by_chance "$picture.json" || true)" >>"$rows"
            tail -n 1 "$rows"
        done
    done
done; done; done

# Of the rows that the first argument (a condition of awk's) admits.
judge() {
    awk -F, "NR > 1 && $1" "$rows" | awk -F, -v what="$2" '{ ratio[++n] = $8 / $4; kept += $8 <= $4 } END {
        if (!n) exit
        for (i = 1; i <= n; i++) for (j = i + 1; j <= n; j++) if (ratio[j] < ratio[i]) { t = ratio[i]; ratio[i] = ratio[j]; ratio[j] = t }
        median = n % 2 ? ratio[(n + 1) / 2] : (ratio[n / 2] + ratio[n / 2 + 1]) / 2
        printf "%s: %d of %d kept their word (%.0f %%), true over promised: median %.2f, largest %.2f\n", what, kept, n, 100 * kept / n, median, ratio[n]
        exit !(kept >= 0.9 * n && median >= 0.5) }'
}
judge '$9 > 0' "warned that sunlight is left to chance" || true
judge '$9 == 0' "all others"
