#!/bin/sh
# Raises src/choice/bias_factors.h to what a scan saw. tools/bias_factors.sh FOLDER ...
#
# FOLDERs are those of tools/bias_scan.sh. The factors that are too small become so large that a claim is 1.2 times the error that the
# scan saw in the cell. Both rows of suns that a cell lies between are raised. Errors of a sum are put down to its parts in turn:
# first to the nodes or the steps, as methods without a table show them, then to further orders, then to the table.
#
# For observers up to 2 m the factors of suns down to -6 stay 1: there each sun was measured over ten times as many directions.
set -eu
if [ $# -lt 1 ]; then sed -n '2,9s/^# \{0,1\}//p' "$0"; exit 2; fi
header=$(dirname "$0")/../src/choice/bias_factors.h
files=""
for folder; do files="$files $folder/cells.csv"; done

# The numbers of the header, a row a line; and behind them the cells.
# shellcheck disable=SC2086
{ sed -n 's/^ *{\([0-9][^{}]*\)},.*/factors,\1/p' "$header"; cat $files; } | awk -F, '
    # The number of the first of `edges` that is not below `value`, from 1.
    function band_of(h,  b) { for (b = 1; b < bands && h > edge[b]; b++); return b }
    function row_of(s,  r) { for (r = 1; r < suns - 1 && s < sun[r + 1]; r++); return r }
    function share_of(s,  r, t) {
        r = row_of(s)
        t = (sun[r] - s) / (sun[r] - sun[r + 1])
        return t < 0 ? 0 : t > 1 ? 1 : t
    }
    function column_of(sky) {
        sub(/^table:/, "", sky)
        sub(/@.*/, "", sky)
        return sky in column ? column[sky] : sky ~ /^paper/ ? column["paper:16x4"] : column["gauss:8"]
    }
    # By how much a column is raised in a cell.
    function raised(cell, c,  b, r, t) {
        b = band[cell]
        r = row_of(at[cell])
        t = share_of(at[cell])
        return (raise[b, r, c] ? raise[b, r, c] : 1) ^ (1 - t) * (raise[b, r + 1, c] ? raise[b, r + 1, c] : 1) ^ t
    }
    # A part of a claim, and what the rest of it is: the part becomes so large that the sum is enough.
    function lift(cell, c, part, rest,  b, r, k, f) {
        if (part <= 0) return
        f = (1.2 * seen[cell] - rest) / part
        if (seen[cell] <= claim[cell] / 1.2 || f <= raised(cell, c)) return
        b = band[cell]
        r = row_of(at[cell])
        for (k = r; k <= r + 1; k++) {
            if (b == 1 && sun[k] >= -6) continue
            if (share_of(at[cell]) == (k == r ? 1 : 0)) continue
            if (f > raise[b, k, c]) raise[b, k, c] = f
        }
    }
    # Two digits, upward.
    function rounded(f) { return f <= 1 ? 1 : f < 10 ? int(f * 10 + 0.9999) / 10 : int(f + 0.9999) }
    BEGIN {
        suns = split("90 30 15 5 2 1 0.5 0 -0.2 -1 -4 -6 -8 -10 -12", sun, " ")
        bands = split("2 1000 10000 20000 42000 57000 60000 63000 90000 1e9", edge, " ")
        words = split("up to 2 m|up to 1 km|up to 10 km|up to 20 km|up to 18 km below the top of the air|up to 3 km below the top|up to the top|up to 3 km above the top|up to 30 km above the top|above", name, "|")
        columns = split("gauss:4 gauss:5 gauss:6 gauss:7 gauss:8 gauss:10 gauss:12 paper:16x4 paper:64x16 table table-further harmonics:8 harmonics:10 harmonics:14", c, " ")
        for (k = 1; k <= columns; k++) column[c[k]] = k
        column["gauss:9"] = column["gauss:8"]
        column["gauss:11"] = column["gauss:10"]
    }
    $1 == "factors" {
        row = ++rows
        for (k = 2; k <= NF; k++) factor[int((row - 1) / suns) + 1, (row - 1) % suns + 1, k - 1] = $k
        next
    }
    $1 == "air" || $6 == "nan" { next }
    {
        cells++
        band[cells] = band_of($2)
        at[cells] = $3
        claim[cells] = $6
        seen[cells] = $7
        nodes[cells] = $11
        table[cells] = $12
        further[cells] = $13
        of_nodes[cells] = column_of($9)
        of_further[cells] = column[$10]
    }
    END {
        for (i = 1; i <= cells; i++) if (!table[i] && !further[i]) lift(i, of_nodes[i], nodes[i], 0)
        for (i = 1; i <= cells; i++) if (table[i] && !further[i]) lift(i, column["table"], table[i], nodes[i] * raised(i, of_nodes[i]))
        for (i = 1; i <= cells; i++) if (!table[i] && further[i]) lift(i, of_further[i], further[i], nodes[i] * raised(i, of_nodes[i]))
        for (i = 1; i <= cells; i++) if (table[i] && further[i])
            lift(i, column["table-further"], table[i], nodes[i] * raised(i, of_nodes[i]) + further[i] * raised(i, of_further[i]))
        for (b = 1; b <= bands; b++) {
            print "    {\n        /* " name[b] " */"
            for (r = 1; r <= suns; r++) {
                line = "        {"
                for (k = 1; k <= columns; k++) {
                    f = (rows ? factor[b, r, k] : 1) * (raise[b, r, k] > 1 ? raise[b, r, k] : 1)
                    line = line (k > 1 ? ", " : "") sprintf("%g", rounded(f))
                }
                print line "},"
            }
            print "    },"
        }
        print "};"
    }' >"$header.new"
sed '/^static const double bias_factors/q' "$header" | cat - "$header.new" >"$header.whole"
mv "$header.whole" "$header"
rm "$header.new"
clang-format -i "$header"
