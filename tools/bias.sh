#!/bin/sh
# Remakes src/choice/bias_figures.h: what each sky method errs. tools/bias.sh STEP MAGICHOUR FOLDER [AIRS [PLACES [SUNS [COLUMNS]]]]
#
# STEP is one of
#   measure   measures what is named and is not in FOLDER/measured.csv yet, and adds it there. It can be stopped and goes on later.
#   compare   prints each measured figure beside that of the header, and the ratios' least, median and most.
#   replace   writes the header anew: figures that were measured replace those of before.
#   raise     writes the header anew, but only replaces smaller figures: for what was measured in parts, without the pictures or with
#             other observers.
#   all       measure and replace.
#
# AIRS are `clear` (simmons2017), `ozone` (simmons2017-ozone), and `further` (both with further orders of scattering). PLACES count from 0: up to 1 km, up to 20 km, up to the top of the air, above.
# SUNS are rows of the table, in degrees. COLUMNS are gauss:4 ... gauss:12, paper:16x4, paper:64x16, rows and columns, the last two
# for a table's 96 rows and its 32 columns a half. Those of `further` are share, rows, columns, harmonics:8, harmonics:10 and
# harmonics:14. What is not given is all of it, which takes two cores many hours.
#
# A figure is 1.4 times the largest relRMSE, percent, over the observers of its place, over the row's sun and one a quarter of the
# way to each neighbouring row, and over
#   sky      2048 directions, even over what is above the visible horizon; over all of the sphere if the observer is above 1 km
#   horizon  2048 directions, even over the 20 degrees about the visible horizon; only those above it, below 1 km
#   crater, materials   pictures of 96x96 pixels and 32 samples, of the same paths
# Truth is gauss:12. For gauss:12 itself, and for gauss:n in an air with ozone, it is the adaptive quadrature (--sky reference), but in
# pictures, which it cannot make. No figure is below 0.001.
#
# In `further` errors are those of all light. The figure is the largest over grounds of albedo 0 and 0.8, without and with ozone, at
# the row's sun alone, over the sky and the horizon with 256 directions each. harmonics:n is measured with gauss:12 against the
# reference, and multiplied by 1.8, because fewer observers and directions count; a table with harmonics:14, against gauss:12 with the
# same. The share is how many percent of all light were scattered once, over a black ground; it is not multiplied. All that is named
# is measured, whether or not it was before.
#
# QUICK=1 measures one observer a place, the row's sun alone, 256 directions, and pictures of 32x32 pixels and 8 samples: a figure in
# a few seconds, to see that all works. PICTURES= leaves the pictures out. HEIGHTS="1100 3000" names other observers, in metres.
set -eu
if [ $# -lt 3 ]; then sed -n '2,33s/^# \{0,1\}//p' "$0"; exit 2; fi
all_suns="90 30 15 5 2 1 0.5 0 -0.2 -1 -4 -6 -8 -10 -12"
further_columns="share rows columns harmonics:8 harmonics:10 harmonics:14"
all_columns="gauss:4 gauss:5 gauss:6 gauss:7 gauss:8 gauss:10 gauss:12 paper:16x4 paper:64x16 rows columns"
step=$1 magichour=$2 folder=$3 airs=${4:-clear ozone further} places=${5:-0 1 2 3} suns=${6:-$all_suns} named=${7:-}
root=$(dirname "$0")/..
header=$root/src/choice/bias_figures.h
measured=$folder/measured.csv
quick=${QUICK:-} pictures=${PICTURES-crater materials}
directions=2048 size=96x96 samples=32
if [ "$quick" ]; then directions=256 size=32x32 samples=8; fi
mkdir -p "$folder"
[ -f "$measured" ] || echo "air,place,sun,column,measure,height_m,sun_deg,relrmse_percent" >"$measured"

# Observers of a place, metres: for the sky, and for pictures.
heights() {
    if [ "${HEIGHTS:-}" ]; then
        echo "$HEIGHTS"
        return
    fi
    case $1 in
    0) echo "1 30 300 1000" ;;
    1) echo "1100 3000 10000" ;;
    2) echo "25000 40000 50000" ;;
    3) echo "62000 150000 1000000" ;;
    esac | if [ "$quick" ]; then cut -d' ' -f1; else cat; fi
}
picture_heights() { heights "$1" | awk '{ print $1; if (NF > 1) print $NF }'; }

# The sun of a row, and those that are a quarter of the way to its neighbours.
near() {
    echo "$all_suns" | awk -v sun="$1" -v quick="$quick" '{
        for (i = 1; i <= NF; i++) {
            if ($i != sun) continue
            line = sun
            if (i > 1 && !quick) line = line " " sun + ($(i - 1) - sun) / 4
            if (i < NF && !quick) line = line " " sun + ($(i + 1) - sun) / 4
            print line
        }
    }'
}

atmosphere() { if [ "$1" = ozone ]; then echo simmons2017-ozone; else echo simmons2017; fi; }

# The method that a column measures.
method() {
    case $1 in
    rows) echo table:gauss:12@1024x96 ;;
    columns) echo table:gauss:12@32x1024 ;;
    *) echo "$1" ;;
    esac
}

# The method that is truth for a column, in an air.
truth() {
    case $2,$1 in
    *,gauss:12 | ozone,gauss:*) echo reference ;;
    *) echo gauss:12 ;;
    esac
}

# Directions for `sky --at`: for each height and sun the whole sky, then the horizon, each along a spiral.
list_directions() {
    awk -v heights="$1" -v suns="$2" -v n=$directions 'function turned(a) { return a - 360 * int(a / 360) } BEGIN {
        degree = atan2(0, -1) / 180
        radius = 6360e3
        golden = 2.39996323 / degree
        # With few directions none may be beside the sun, whose azimuth is 0, by design.
        turn = n < 1024 ? 0.5 : 0
        split(heights, h, " ")
        split(suns, s, " ")
        print "height_m,sun_el_deg,view_el_deg,az_deg"
        for (i = 1; i in h; i++) {
            horizon = -sqrt(h[i] * (2 * radius + h[i])) / (radius + h[i])
            middle = atan2(horizon, sqrt(1 - horizon * horizon))
            below = middle - 20 * degree
            if (below < -90 * degree) below = -90 * degree
            from["sky"] = h[i] > 1000 ? -1 : horizon
            from["horizon"] = h[i] > 1000 ? sin(below) : horizon
            to["sky"] = 1
            to["horizon"] = sin(middle + 20 * degree)
            for (j = 1; j in s; j++) for (set = 0; set < 2; set++) for (k = 0; k < n; k++) {
                what = set ? "horizon" : "sky"
                y = from[what] + (to[what] - from[what]) * (k + 0.5) / n
                print h[i] "," s[j] "," sprintf("%.7f,%.5f", atan2(y, sqrt(1 - y * y)) / degree, turned(golden * (k + turn)))
            }
        }
    }'
}

# relRMSE of each run of directions: rows of two outputs of `sky --at`, side by side.
errors_of_sky() {
    paste -d, "$1" "$2" | awk -F, -v n=$directions '
        /^#/ || /^height/ { next }
        {
            for (c = 5; c <= 7; c++) { squares += ($c - $(c + 7)) ^ 2; sum += $(c + 7) }
            if (++count < n) next
            set++
            printf "%s,%s,%s,%.6g\n", set % 2 ? "sky" : "horizon", $1, $2, 100 * sqrt(squares * 3 * n) / sum
            count = squares = sum = 0
        }'
}

# Adds rows "measure,height,sun,percent" of a column, those that are the largest of their measure and of their row of the table.
# keep_largest AIR PLACE COLUMN "ROW SUN SUN SUN;ROW SUN SUN SUN"
keep_largest() {
    awk -F, -v OFS=, -v air="$1" -v place="$2" -v column="$3" -v near="$4" '
        BEGIN {
            n = split(near, rows, ";")
            for (i = 1; i <= n; i++) {
                m = split(rows[i], suns, " ")
                for (k = 2; k <= m; k++) row_of[suns[k] + 0] = suns[1]
            }
        }
        {
            figure = air OFS place OFS row_of[$3 + 0] OFS column OFS $1
            if (figure in most && $4 <= most[figure]) next
            most[figure] = $4
            rest[figure] = $2 OFS $3 OFS $4
        }
        END { for (figure in most) print figure, rest[figure] }' | sort >>"$measured"
}

is_measured() { grep -q "^$1,$2\(,\|$\)" "$measured"; }

# All suns in one run of the program, since to start it takes longer than a sun does.
measure_sky() {
    air=$1 place=$2
    rows=$folder/directions.csv last="-"
    for column in ${named:-$all_columns}; do
        missing="" at=""
        for sun in $suns; do
            if is_measured "$air,$place,$sun,$column" sky; then continue; fi
            missing="$missing$sun $(near "$sun");" at="$at $(near "$sun")"
        done
        if [ ! "$missing" ]; then continue; fi
        if [ "$missing" != "$last" ]; then
            rm -f "$folder"/truth-*.csv
            list_directions "$(heights "$place")" "$at" >"$rows"
            last=$missing
        fi
        true=$(truth "$column" "$air")
        file=$folder/truth-$true.csv
        [ -f "$file" ] || "$magichour" sky --atmosphere "$(atmosphere "$air")" --at "$rows" --sky "$true" >"$file"
        "$magichour" sky --atmosphere "$(atmosphere "$air")" --at "$rows" --sky "$(method "$column")" >"$folder/got.csv"
        errors_of_sky "$folder/got.csv" "$file" | keep_largest "$air" "$place" "$column" "$missing"
    done
}

# The settings that count for `further`, one a line.
further_airs() {
    for air in simmons2017 simmons2017-ozone; do for albedo in 0.8 0; do
        echo "--atmosphere $air --set atmosphere.orders=all --set atmosphere.ground_albedo=$albedo"
    done; done
}

further_heights() {
    case $1 in
    0) echo "1 1000" ;;
    1) echo "1100 10000" ;;
    2) echo "40000" ;;
    3) echo "150000" ;;
    esac
}

# further_sky AIR FILE OPTION ...
further_sky() {
    set_air=$1 target=$2
    shift 2
    # shellcheck disable=SC2086
    "$magichour" sky $set_air --at "$folder/directions.csv" "$@" >"$target"
}

# The share of light that was scattered once in each run of directions, as errors_of_sky writes errors: $1 is single, $2 is all light.
shares_of_sky() {
    paste -d, "$1" "$2" | awk -F, -v n=$directions '
        /^#/ || /^height/ { next }
        {
            for (c = 5; c <= 7; c++) { one += $c; all += $(c + 7) }
            if (++count < n) next
            set++
            printf "%s,%s,%s,%.6g\n", set % 2 ? "sky" : "horizon", $1, $2, 100 * one / all
            count = one = all = 0
        }'
}

# Rows "measure,height,sun,percent" of a column, by a setting: $1 is the column, $2 the setting.
errors_of_further() {
    case $1 in
    rows | columns)
        further_sky "$2" "$folder/got.csv" --sky "$(method "$1")" --further harmonics:14
        errors_of_sky "$folder/got.csv" "$folder/truth-table.csv"
        ;;
    share)
        case $2 in *albedo=0) ;; *) return ;; esac
        further_sky "$2" "$folder/got.csv" --sky gauss:12 --set atmosphere.orders=1
        shares_of_sky "$folder/got.csv" "$folder/truth-table.csv"
        ;;
    harmonics:14)
        errors_of_sky "$folder/truth-table.csv" "$folder/truth.csv"
        ;;
    *)
        further_sky "$2" "$folder/got.csv" --sky gauss:12 --further "$1"
        errors_of_sky "$folder/got.csv" "$folder/truth.csv"
        ;;
    esac
}

# All places and columns of a setting, before the next: they share the truth.
measure_further() {
    all_heights="" missing=""
    for sun in $suns; do missing="$missing$sun $sun;"; done
    for place in $places; do all_heights="$all_heights $(further_heights "$place")"; done
    directions=256
    list_directions "$all_heights" "$suns" >"$folder/directions.csv"
    rm -f "$folder"/errors-*
    further_airs | while read -r setting; do
        echo "further orders: $setting" >&2
        further_sky "$setting" "$folder/truth-table.csv" --sky gauss:12 --further harmonics:14
        case "${named:-harmonics}" in *harmonics*) further_sky "$setting" "$folder/truth.csv" --sky reference ;; esac
        for column in ${named:-$further_columns}; do errors_of_further "$column" "$setting" >>"$folder/errors-$column"; done
    done
    for place in $places; do for column in ${named:-$further_columns}; do
        for measure in sky horizon; do for height in $(further_heights "$place"); do
            grep "^$measure,$height," "$folder/errors-$column" || true
        done; done | keep_largest further "$place" "$column" "$missing"
    done; done
    rm -f "$folder"/errors-*
}

draw() {
    "$magichour" render "$root/scenes/$1.glsl" --atmosphere "$2" --set "atmosphere.observer_height_m=$3" --sun "$4" --sky "$5" \
        --light cosine --size $size --spp $samples --seed 1 --quiet -o "$6"
}

measure_pictures() {
    air=$1 place=$2 sun=$3 scene=$4
    rm -f "$folder"/truth-*.pfm
    for column in ${named:-$all_columns}; do
        figure=$air,$place,$sun,$column
        if [ "$column" = gauss:12 ] || is_measured "$figure" "$scene"; then continue; fi
        for height in $(picture_heights "$place"); do for at in $(near "$sun"); do
            file=$folder/truth-$height-$at.pfm
            [ -f "$file" ] || draw "$scene" "$(atmosphere "$air")" "$height" "$at" gauss:12 "$file"
            draw "$scene" "$(atmosphere "$air")" "$height" "$at" "$(method "$column")" "$folder/got.pfm"
            echo "$scene,$height,$at,$("$magichour" compare "$folder/got.pfm" "$file" | awk '$1 == "relRMSE" { print $2 }')"
        done; done | keep_largest "$air" "$place" "$column" "$sun $(near "$sun")"
    done
}

measure() {
    for air in $airs; do
        if [ "$air" = further ]; then
            measure_further
            continue
        fi
        for place in $places; do
            echo "$air, place $place: the sky" >&2
            measure_sky "$air" "$place"
            for sun in $suns; do
                echo "$air, place $place, sun $sun: pictures" >&2
                for scene in $pictures; do measure_pictures "$air" "$place" "$sun" "$scene"; done
            done
        done
    done
    rm -f "$folder"/truth-* "$folder"/got.* "$folder/directions.csv"
}

# The figures of the header, or with those that were measured in their place: air,place,sun,column,before,after. A row of the header
# is known by its number; those of `further` are the last.
figures() {
    sed -n 's/^ *{\([0-9][^{}]*\)},.*/\1/p' "$header" | awk -F, -v suns="$all_suns" -v columns="$all_columns" -v further="$further_columns" \
        -v measured="$measured" '
        BEGIN {
            split(suns, sun, " ")
            split(columns, column, " ")
            split(further, further_column, " ")
            while ((getline line <measured) > 0) {
                split(line, word, ",")
                figure = word[1] "," word[2] "," word[3] "," word[4]
                if (word[8] + 0 > most[figure]) most[figure] = word[8] + 0
                known[figure] = 1
            }
        }
        {
            row = NR - 1
            for (c = 1; c <= NF; c++) {
                name = row < 120 ? column[c] : further_column[c]
                figure = (row < 60 ? "clear" : row < 120 ? "ozone" : "further") "," int(row / 15) % 4 "," sun[row % 15 + 1] "," name
                after = (name == "share" ? 1 : name ~ /^harmonics/ ? 1.8 : 1.4) * most[figure]
                if (after < 0.001) after = 0.001
                print figure "," $c + 0 "," (figure in known ? sprintf("%.2g", after) + 0 : "-")
            }
        }'
}

compare() {
    figures | awk -F, '
        $6 == "-" { next }
        {
            r = $6 / $5
            print $0 "," sprintf("%.2f", r)
            for (i = ++n; i > 1 && ratio[i - 1] > r; i--) ratio[i] = ratio[i - 1]
            ratio[i] = r
        }
        END { if (n) printf "%d figures, remade over before: least %.2f, median %.2f, most %.2f\n", n, ratio[1], ratio[int((n + 1) / 2)], ratio[n] }'
}

# Writes the header. Its argument is 1 if only smaller figures are replaced.
write() {
    figures | awk -F, -v raise="$1" '
        BEGIN {
            split("up to 1 km|up to 20 km|up to the top of the air|above the air", name, "|")
            words["ozone"] = ", with ozone"
            words["further"] = ", with further orders"
        }
        {
            figure = $6 == "-" || (raise && $6 < $5) ? $5 : $6
            if ($1 != air || $2 != place || $3 != sun) {
                if (line != "") print line "},"
                if ($1 != air && air != "") print $1 == "further" ? "        },\n    },\n};" : "        },\n    },"
                else if ($2 != place && air != "") print air == "further" ? "    }," : "        },"
                if ($1 != air) {
                    if ($1 == "further") print "\nstatic const double bias_further_figures[BIAS_PLACES][BIAS_SUNS][BIAS_FURTHER_COLUMNS] = {"
                    else print "    {"
                }
                if ($1 != air || $2 != place) print "        {\n            /* " name[$2 + 1] words[$1] " */"
                air = $1
                place = $2
                sun = $3
                line = "            {"
            } else {
                line = line ", "
            }
            line = line sprintf("%.2g", figure)
        }
        END { print line "},\n    },\n};" }' >"$folder/figures"
    sed '/^static const double bias_figures/q' "$header" | cat - "$folder/figures" >"$folder/header"
    mv "$folder/header" "$header"
    clang-format -i "$header"
    rm "$folder/figures"
}

case $step in
measure | compare) "$step" ;;
replace) write 0 ;;
raise) write 1 ;;
all)
    measure
    write 0
    ;;
*) echo "tools/bias.sh: unknown step '$step'" >&2; exit 2 ;;
esac
