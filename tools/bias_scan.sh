#!/bin/sh
# Holds what the sky's methods are said to err against what they err. tools/bias_scan.sh MAGICHOUR FOLDER [AIRS [METHODS]]
#
# A cell is an air, a height of the observer, an elevation of the sun, and a method. Its ratio is the true relRMSE divided by the
# claim: the larger of two true ones, over DIRECTIONS directions (192) that are even over the sky, and as many that are even over the
# 20 degrees about the visible horizon. Both are as in tools/bias.sh. Truth is --sky reference. Where the ratio is above 1 it is
# measured again, over four times as many directions, because one that is close beside the sun may decide it.
#
# The scan prints the worst ratio by band of height, band of sun, and method, in the three-column air and in those with further orders
# apart, then each cell whose ratio is above 1. FOLDER/cells.csv has all cells. AIRS are names out of list_airs below, METHODS are
# SKY/FURTHER, or /auto:ERROR for what auto takes for --error ERROR. By default they are all. Truth is kept in FOLDER, and is not
# computed again: the first scan takes two hours of a core, and each further scan some minutes.
#
# tools/bias_claim, beside MAGICHOUR, prints the claims. EVERY=n takes every nth cell alone.
set -eu
if [ $# -lt 2 ]; then sed -n '2,15s/^# \{0,1\}//p' "$0"; exit 2; fi
magichour=$1 folder=$2 named_airs=${3:-} named_methods=${4:-}
directions=${DIRECTIONS:-192} every=${EVERY:-1}
mkdir -p "$folder"
claim=$(dirname "$magichour")/tools/bias_claim

heights="0 1 10 30 100 300 600 1000 1001 1100 1500 2000 3000 5000 8000 12000 16000 20000 20001 25000 30000 35000 40000 45000 50000 55000 58000
58500 59000 59500 59800 59950 59999 60000 60001 60050 60300 60800 61500 62000 66000 75000 100000 150000 300000 1000000"
suns="90 60 40 30 20 15 10 7 5 3 2 1.5 1 0.75 0.5 0.3 0.1 0 -0.1 -0.2 -0.4 -0.7 -1 -1.5 -2 -2.5 -3 -4 -5 -6 -7 -8 -9 -10 -11 -12"

# An air a line: its name, how many cells one is taken of, whether it has further orders, the preset, and settings.
list_airs() {
    cat <<'END'
clear 1 single simmons2017
ozone 1 single simmons2017-ozone
author 9 single simmons2017-author
denser 5 single simmons2017 rayleigh=1.09 mie=1.09
thinner 5 single simmons2017-ozone rayleigh=0.92 mie=0.92 ozone=0.92
narrower 7 single simmons2017 mie_g=0.7
spectrum 5 single simmons2017-ozone spectrum=6
earth 5 further earth
black 7 further earth ground_albedo=0
bright 7 further earth ground_albedo=0.8
channels 5 further simmons2017 orders=all ground_albedo=0.3
dusty 7 further earth mie=1.09 rayleigh=0.92
END
}

methods() {
    if [ "$named_methods" ]; then
        echo "$named_methods" | tr ' ' '\n'
    elif [ "$1" = single ]; then
        for sky in gauss:4 gauss:5 gauss:6 gauss:7 gauss:8 gauss:9 gauss:10 gauss:11 gauss:12 paper:16x4 paper:32x8 paper:64x16 \
            table table:gauss:12@16x48 table:gauss:12@32x96 table:gauss:10@64x64 table:gauss:12@128x384 table:gauss:12@256x768; do
            echo "$sky/harmonics"
        done
        for error in 5 1 0.3; do echo "/auto:$error"; done
    else
        for sky in gauss:12/harmonics:8 gauss:12/harmonics:10 gauss:12/harmonics:14 gauss:5/harmonics:14 table/harmonics:14 \
            table:gauss:12@32x96/harmonics:10 table:gauss:12@64x64/harmonics:14 table:gauss:12@256x768/harmonics:14 /auto:5 /auto:1 /auto:0.3; do
            echo "$sky"
        done
    fi
}

# Cells "height,sun" of an air: one of $1, and another one for each air, whose name is $2.
list_cells() {
    echo "$heights" | tr '\n' ' ' | awk -v suns="$suns" -v step="$(($1 * every))" -v name="$2" '{
        n = split(suns, sun, " ")
        # A step that has no factor in common with the number of suns takes all suns at some height.
        at = length(name) % step
        for (h = 1; h <= NF; h++) for (s = 1; s <= n; s++) if (at++ % step == 0) print $h "," sun[s]
    }'
}

# Directions for `sky --at`: for each cell the whole sky, then the horizon, each along a spiral that starts somewhere else.
list_directions() {
    # Numbers are as the program prints them again, which tells whether truth is known already.
    awk -F, -v n="$n" 'function turned(a) { return a - 360 * int(a / 360) }
    function number(a, digits) {
        a = sprintf("%.*f", digits, a)
        sub(/\.?0+$/, "", a)
        return a == "-0" || a == "" ? "0" : a
    }
    BEGIN {
        degree = atan2(0, -1) / 180
        radius = 6360e3
        golden = 2.39996323 / degree
        print "height_m,sun_el_deg,view_el_deg,az_deg"
    }
    {
        horizon = -sqrt($1 * (2 * radius + $1)) / (radius + $1)
        middle = atan2(horizon, sqrt(1 - horizon * horizon))
        below = middle - 20 * degree
        if (below < -90 * degree) below = -90 * degree
        for (set = 0; set < 2; set++) for (k = 0; k < n; k++) {
            from = $1 <= 1000 ? horizon : set ? sin(below) : -1
            y = from + ((set ? sin(middle + 20 * degree) : 1) - from) * (k + 0.5) / n
            print $1 "," $2 "," number(atan2(y, sqrt(1 - y * y)) / degree, 7) "," number(turned(golden * (k + 0.5 + NR * 0.37)), 5)
        }
    }'
}

# The rows of truth of the cells whose numbers are the lines of $1.
choose_rows() { awk -F, -v n="$n" 'FNR == NR { wanted[$1]; next } /^#/ || /^height/ { next } { cell = int(row / (2 * n)); row += 1 } cell in wanted' "$1" "$2"; }

# The larger relRMSE of each cell: rows of two outputs of `sky --at`, side by side.
errors() {
    paste -d, "$1" "$2" | awk -F, -v n="$n" '
        {
            for (c = 5; c <= 7; c++) { squares += ($c - $(c + 7)) ^ 2; sum += $(c + 7) }
            if (++count < n) next
            error = sum > 0 ? 100 * sqrt(squares * 3 * n) / sum : 0
            if (++set % 2 == 0) printf "%.6g\n", (error > before ? error : before)
            before = error
            count = squares = sum = 0
        }'
}

# What is claimed for the cells in list.csv by their methods: each line is a cell's number and a line of bias_claim.
# list_claims ORDERS PRESET [NAME=VALUE ...]
list_claims() {
    orders=$1
    shift
    for method in $(methods "$orders"); do
        sky=${method%%/*} further=${method#*/}
        awk -v sky="${sky:-$further}" -v further="$further" '{ print $0 "," sky "," further }' "$folder/list.csv" |
            "$claim" "$@" | awk -F, '{ print NR - 1 "," $0 }'
    done
}

# Rows of cells.csv for what is in claims.csv, with truth of the cells in list.csv: measure NAME TRUTH PRESET [OPTION ...]
measure() {
    name=$1 truth=$2 preset=$3
    shift 3
    list_directions <"$folder/list.csv" >"$folder/directions.csv"
    if ! cut -d, -f1-4 "$truth" 2>/dev/null | cmp -s - "$folder/directions.csv"; then
        echo "$name: truth" >&2
        "$magichour" sky --quiet --atmosphere "$preset" "$@" --at "$folder/directions.csv" --sky reference >"$truth"
    fi
    awk -F, -v name="$name" '$6 == "nan" { print name "," $2 "," $3 "," $4 "," $5 ",nan,,," $7 "," $8 ",,," }' "$folder/claims.csv"
    awk -F, '$6 != "nan" { print $7 "," $8 }' "$folder/claims.csv" | sort -u | while IFS=, read -r sky further; do
        echo "$name: $sky $further" >&2
        awk -F, -v sky="$sky" -v further="$further" '$6 != "nan" && $7 == sky && $8 == further' "$folder/claims.csv" >"$folder/some.csv"
        cut -d, -f1 "$folder/some.csv" | sort -nu >"$folder/numbers"
        choose_rows "$folder/numbers" "$truth" >"$folder/true.csv"
        "$magichour" sky --quiet --atmosphere "$preset" "$@" --at "$folder/true.csv" --sky "$sky" --further "$further" |
            grep -v '^#\|^height' >"$folder/got.csv"
        errors "$folder/got.csv" "$folder/true.csv" | paste -d, "$folder/numbers" - |
            awk -F, -v name="$name" 'FNR == NR { error[$1] = $2; next }
                { print name "," $2 "," $3 "," $4 "," $5 "," $6 "," error[$1] "," error[$1] / $6 "," $7 "," $8 "," $9 "," $10 "," $11 }' - "$folder/some.csv"
    done
}

# scan NAME STEP ORDERS PRESET [NAME=VALUE ...]
scan() {
    name=$1 step=$2 orders=$3 preset=$4 n=$directions
    shift 4
    for word; do set -- "$@" --set "atmosphere.$word"; shift; done
    settings=""
    for word; do case $word in atmosphere.*) settings="$settings ${word#atmosphere.}" ;; esac; done
    list_cells "$step" "$name" >"$folder/list.csv"
    # shellcheck disable=SC2086
    list_claims "$orders" "$preset" $settings >"$folder/claims.csv"
    measure "$name" "$folder/truth-$name.csv" "$preset" "$@" >"$folder/first.csv"
    awk -F, '$6 != "nan" && $8 > 1' "$folder/first.csv" >"$folder/above.csv"
    if [ -s "$folder/above.csv" ]; then
        n=$((4 * directions))
        cut -d, -f2,3 "$folder/above.csv" | sort -t, -u -k1,1g -k2,2g >"$folder/list.csv"
        # shellcheck disable=SC2086
        list_claims "$orders" "$preset" $settings |
            awk -F, 'FNR == NR { above[$2 "," $3 "," $4 "," $5]; next } ($2 "," $3 "," $4 "," $5) in above' "$folder/above.csv" - >"$folder/claims.csv"
        measure "$name" "$folder/truth-$name-again.csv" "$preset" "$@" >"$folder/again.csv"
    else
        : >"$folder/again.csv"
    fi
    awk -F, '{ cell = $2 "," $3 "," $4 "," $5 } FNR == NR { again[cell] = $0; next } { print cell in again ? again[cell] : $0 }' \
        "$folder/again.csv" "$folder/first.csv" >>"$folder/cells.csv"
}

# The worst ratio by band of height, band of sun and kind of method.
report() {
    awk -F, '
        function band_of_height(h) { return h <= 1e3 ? 1 : h <= 20e3 ? 2 : h <= 58e3 ? 3 : h <= 60e3 ? 4 : h <= 62e3 ? 5 : 6 }
        function band_of_sun(s) { return s > 5 ? 1 : s > 1 ? 2 : s >= -1 ? 3 : s >= -6 ? 4 : 5 }
        function kind_of(sky, further, air) {
            if (sky ~ /^auto/) return "auto"
            sub(/:.*/, "", sky)
            return sky (air ~ further_airs ? "+harm" : "")
        }
        BEGIN {
            further_airs = "^(earth|black|bright|channels|dusty)$"
            heights = split("1 km|20 km|58 km|60 km|62 km|above", height, "|")
            suns = split("above 5|1 to 5|-1 to 1|-6 to -1|below -6", sun, "|")
            kinds = split("gauss|paper|table|gauss+harm|table+harm|auto", kind, "|")
        }
        NR == 1 { next }
        $6 == "nan" { without++; next }
        {
            cells++
            band = band_of_height($2) "," band_of_sun($3) "," kind_of($4, $5, $1)
            if ($8 > worst[band]) worst[band] = $8
            above += $8 > 1
            if ($8 > most) { most = $8; line = $0 }
        }
        END {
            printf "%-9s%-10s", "up to", "sun"
            for (k = 1; k <= kinds; k++) printf "%12s", kind[k]
            print ""
            for (h = 1; h <= heights; h++) for (s = 1; s <= suns; s++) {
                printf "%-9s%-10s", height[h], sun[s]
                for (k = 1; k <= kinds; k++) {
                    band = h "," s "," kind[k]
                    printf "%12s", band in worst ? sprintf("%.2f", worst[band]) : "-"
                }
                print ""
            }
            printf "%d cells with a claim, %d without; %d above 1; the worst: %s\n", cells, without, above, line
        }' "$folder/cells.csv"
    awk -F, 'NR > 1 && $8 > 1' "$folder/cells.csv" | sort -t, -k8,8gr
}

echo "air,height_m,sun_deg,sky,further,claim_percent,true_percent,ratio,sky_taken,further_taken,nodes_claim,table_claim,further_claim" >"$folder/cells.csv"
list_airs | while read -r line; do
    case " ${named_airs:-${line%% *}} " in *" ${line%% *} "*) ;; *) continue ;; esac
    # shellcheck disable=SC2086
    scan $line </dev/null
done
rm -f "$folder/list.csv" "$folder/directions.csv" "$folder/claims.csv" "$folder/some.csv" "$folder/numbers" "$folder/true.csv" "$folder/got.csv" "$folder/first.csv" \
    "$folder/above.csv" "$folder/again.csv"
report
