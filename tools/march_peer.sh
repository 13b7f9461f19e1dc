#!/bin/sh
# march() beside a plain sphere tracer with fixed parameters (tools/march_peer.glsl): tools/march_peer.sh MAGICHOUR FOLDER CHARTS
#
# Renders scenes/mandelbulb.glsl with the library and with copies of it that march in other ways, with the same random numbers. CHARTS gets march-peer.{csv,png}.
# A row of the table is a way to march: the microseconds of processor time that a path takes, the field's evaluations in a search (without those of the normal), and the error in
# percent of the mean. The error is taken against two references, which are a very fine plain tracer and march() with narrower tolerances.
#
# The noise is no part of the error. All ways and the references are rendered by several seeds, and the mean product of the differences at two seeds is the square of the
# error, since noise has the mean 0 in it. What is left of the noise makes the mean uncertain. `at_most` is the error at two standard errors above the mean.
# A run of few samples is subtracted from the time, and the least time of all seeds counts. What is measured is kept in FOLDER, so that a run that was broken off goes on.
# shellcheck disable=SC2086
set -eu
export LC_ALL=C LP_NUM_THREADS=1
magichour=$1 folder=$2 charts=$3
tools=$(dirname "$0")
root=$tools/..
# shellcheck source=tools/measure.sh
. "$tools/measure.sh"
width=96 height=72 few=4 seeds="1 2 3 4"
mkdir -p "$folder" "$charts"

# KIND DETAIL FUDGE of plain tracers, and the slack of march(). The kinds of references come last.
cat >"$folder/ways" <<'END'
plain 1.0e-2 1.0
plain 3.0e-3 1.0
plain 1.0e-3 1.0
plain 3.0e-4 1.0
plain 1.0e-4 1.0
plain 1.0e-5 1.0
plain 1.0e-6 1.0
plain 1.0e-3 0.5
plain 1.0e-4 0.5
plain 1.0e-5 0.5
march 0.0 -
march 3.0e-5 -
march 3.0e-4 -
tight 0.0 -
fine 1.0e-6 0.7
END

# Edits a file of the library's copy, and fails if there is nothing to edit: edit FILE EXPRESSION
edit() {
    sed "$2" "$root/glsl/shape/$1" >"$library/shape/$1"
    ! cmp -s "$root/glsl/shape/$1" "$library/shape/$1" || {
        echo "march-peer: nothing to edit in $1" >&2
        exit 1
    }
}

# A copy of the library that marches in this way: library_of KIND DETAIL FUDGE
library_of() {
    library=$folder/library-$1-$2-$3
    rm -rf "$library"
    cp -rL "$root/glsl" "$library"
    case $1 in
    plain | fine)
        step=0.0
        [ "$1" = plain ] || step=3.0e-4
        sed "s/PLAIN_DETAIL = [^;]*/PLAIN_DETAIL = $2/; s/PLAIN_FUDGE = [^;]*/PLAIN_FUDGE = $3/; s/PLAIN_NORMAL_STEP = [^;]*/PLAIN_NORMAL_STEP = $step/" \
            "$tools/march_peer.glsl" >"$library/shape/march.glsl"
        ;;
    *)
        sed "s/MARCH_SLACK = [^;]*/MARCH_SLACK = $2/" "$root/glsl/shape/march_quick.glsl" >"$library/shape/march_quick.glsl"
        ;;
    esac
    [ "$1" = tight ] || return 0
    edit march_field.glsl 's/MARCH_PRECISION = [^;]*/MARCH_PRECISION = 2.0e-7/'
    # The error of central differences is taken away to the second order.
    edit march.glsl 's|vec3 gradient = march_gradient(p, \(.*\));|float h = \1; vec3 gradient = (4.0 * march_gradient(p, 0.5 * h) - march_gradient(p, h)) / 3.0;|'
}

# Renders and prints the processor's seconds: render_seconds PICTURE OPTION...
render_seconds() {
    picture=$1
    shift
    cpu_seconds "$picture.json" "$magichour" render "$root/scenes/mandelbulb.glsl" --size ${width}x$height --sun 30 --sun-disk --light cosine \
        --sky table:gauss:8 --orders 1 "$@" --quiet --progress json -o "$picture"
}

# The samples of a picture at a depth.
samples_of() {
    if [ "$1" = 1 ]; then echo 128; else echo 24; fi
}

while read -r kind detail fudge; do library_of $kind $detail $fudge; done <"$folder/ways"
for seed in $seeds; do for depth in 1 0; do
    while read -r kind detail fudge; do
        name=$folder/$kind-$detail-$fudge-$depth-$seed
        [ ! -s "$name.seconds" ] || continue
        options="--glsl-dir $folder/library-$kind-$detail-$fudge --depth $depth --seed $seed"
        start=$(render_seconds "$folder/few.pfm" $options --spp $few)
        all=$(render_seconds "$name.pfm" $options --spp "$(samples_of $depth)")
        echo "$start $all" >"$name.seconds"
    done <"$folder/ways"
    echo "march-peer: seed $seed, depth $depth"
done; done

# The values of a way's pictures, one a line, a column for each seed: values KIND DETAIL FUDGE DEPTH
values() {
    columns=
    for seed in $seeds; do
        pfm_values "$folder/$1-$2-$3-$4-$seed.pfm" >"$folder/values.$seed"
        columns="$columns $folder/values.$seed"
    done
    paste $columns
}

# The error of the pictures $1 against those of the reference $2, percent, and the most that it may be. It is 0 where the noise hides it.
error() {
    paste "$1" "$2" | awk '
        {
            n = NF / 2
            sum = squares = 0
            for (i = 1; i <= n; i++) { d = $i - $(i + n); sum += d; squares += d * d; mean += $(i + n) / n }
            product = (sum * sum - squares) / (n * (n - 1))
            total += product
            spread += product * product
        }
        function percent(square) { return 100 * sqrt(square > 0 ? square : 0) / (mean / NR) }
        END {
            total /= NR
            deviation = sqrt((spread / NR - total * total) / NR)
            printf "%.3g,%.3g", percent(total), percent(total + 2 * deviation)
        }'
}

echo "depth,way,parameter,fudge,microseconds_a_path,evaluations_a_search,percent_of_fine_plain,at_most,percent_of_tight_march,at_most" >"$folder/march-peer.csv"
for depth in 1 0; do
    values fine 1.0e-6 0.7 $depth >"$folder/fine"
    values tight 0.0 - $depth >"$folder/tight"
    while read -r kind detail fudge; do
        values $kind $detail $fudge $depth >"$folder/values"
        time=$(cat "$folder/$kind-$detail-$fudge-$depth"-?.seconds |
            awk -v paths=$((width * height * ($(samples_of $depth) - few))) '
                NR == 1 || $1 < start { start = $1 } NR == 1 || $2 < all { all = $2 } END { printf "%.3g", 1e6 * (all - start) / paths }')
        steps=$(sed -n 's/.*"search_rays": \([0-9]*\), "search_steps": \([0-9]*\).*/\2 \1/p' "$folder/$kind-$detail-$fudge-$depth-1.pfm.json" |
            awk 'END { printf "%.3g", $1 / $2 }')
        echo "$depth,$kind,$detail,$fudge,$time,$steps,$(error "$folder/values" "$folder/fine"),$(error "$folder/values" "$folder/tight")" >>"$folder/march-peer.csv"
    done <"$folder/ways"
done
cp "$folder/march-peer.csv" "$charts"
gnuplot -c "$tools/march_peer.gp" "$folder/march-peer.csv" "$charts/march-peer.png"

# The plain tracer's time over that of march(), where its error is the most that march()'s may be, between the two thresholds about it; or at its least error.
awk -F , '
    $2 == "march" && $3 == "3.0e-5" { time[$1] = $5; error[$1] = $8 }
    $2 == "plain" && $4 == "1.0" { n[$1]++; t[$1, n[$1]] = $5; e[$1, n[$1]] = $7 }
    END {
        for (depth in time) {
            least = 1
            for (i = 2; i <= n[depth]; i++) if (e[depth, i] < e[depth, least]) least = i
            for (i = 2; i < least && e[depth, i] > error[depth]; i++);
            at = t[depth, i]
            reached = e[depth, i]
            if (reached < error[depth]) {
                share = log(error[depth] / e[depth, i - 1]) / log(reached / e[depth, i - 1])
                at = exp(log(t[depth, i - 1]) + share * log(at / t[depth, i - 1]))
                reached = error[depth]
            }
            printf "march-peer: %s: march() errs by %s %% at most; the plain tracer takes %.2f times as long at %s %%\n",
                depth == 0 ? "full depth" : "depth " depth, error[depth], at / time[depth], reached
        }
    }' "$charts/march-peer.csv"
