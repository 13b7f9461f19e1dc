# Errors of a method, from lines "cell|reference row|method's row" (see atlas.sh), read twice: the first time for the mean of each
# sun's sky. Into the files `map`HEIGHT go chart cells, "x y percent", the worst of channels and azimuths; a cell without any
# light, neither the reference's nor the method's, is NaN. Printed: the method's rows of the table in Markdown.
#
# Percentiles come from a histogram of 1000 bins a decade.

function worst_of(a, b) { return a > b ? a : b }
function relative(light, truth, least) { return 100 * (light > truth ? light - truth : truth - light) / worst_of(truth, least) }

function count_in(key, error,    bin) {
    if (error > max[key]) where[key] = $6 ", " sprintf("%.4g", $7) ", " $8 ", " substr("RGB", c + 1, 1)
    count[key]++
    squares[key] += error * error
    max[key] = worst_of(max[key], error)
    bin = error < 1e-9 ? 0 : int(1000 * (log(error) / log(10) + 9)) + 1
    bins[key, bin]++
    top[key] = worst_of(top[key], bin)
}

function percentile99(key,    bin, above) {
    for (bin = top[key]; bin > 0; bin--) {
        above += bins[key, bin]
        if (above > 0.01 * count[key]) break
    }
    return bin ? exp(((bin - 0.5) / 1000 - 9) * log(10)) : 0
}

function figure(v) { return v == 0 ? "0" : v >= 99.5 ? sprintf("%.0f", v) : sprintf("%.2g", v) }
function figures(key) {
    if (!count[key]) return "no light"
    return figure(sqrt(squares[key] / count[key])) " / " figure(percentile99(key)) " / " figure(max[key])
}

function end_cell() {
    if (cell != "") print cell, lit ? worst_of(worst, 1e-5) : "NaN" >(map cell_height)
    worst = lit = 0
}

BEGIN {
    FS = "[ ,|]"
    least[0] = 1.43e-6; least[1] = 1.47e-6; least[2] = 1.54e-6
}

# 1 to 4: x y solid_angle band; 5 to 8: height sun view azimuth; 9 to 11: reference; 16 to 18: method
{ sky = $5 "," $6 }

NR == FNR {
    solid_angle[sky] += $3
    for (c = 0; c < 3; c++) flux[sky, c] += $3 * $(9 + c)
    next
}

$1 " " $2 != cell || $5 != cell_height { end_cell(); cell = $1 " " $2; cell_height = $5 }

{
    for (c = 0; c < 3; c++) {
        truth = $(9 + c); light = $(16 + c)
        if (light != light + 0 || light ~ /[ni]/) { print "atlas: not a number: " $0 >"/dev/stderr"; exit 1 }
        if (truth == 0 && light == 0) continue
        lit = 1
        error = relative(light, truth, least[c])
        worst = worst_of(worst, error)
        above_mean = relative(light, truth, worst_of(1e-3 * flux[sky, c] / solid_angle[sky], 1e-30))
        for (i = 1; i <= 2; i++) {
            key = $5 "," (i == 1 ? "all" : $4)
            count_in(key, error)
            count_in(key ",mean", above_mean)
        }
    }
}

END {
    end_cell()
    heights = split("1 10000 100000", height, " ")
    split("1 m,10 km,100 km", height_name, ",")
    bands = split("all day low twilight late", band, " ")
    split("-18 to 90,5 to 90,0 to 2,-6 to -2,-12 to -6", band_name, ",")
    for (h = 1; h <= heights; h++) for (i = 1; i <= bands; i++) {
        key = height[h] "," band[i]
        printf "| %s | %s, %s | %s | %s | %s |\n", height_name[h], band[i], band_name[i], figures(key), \
               where[key] == "" ? "-" : where[key], figures(key ",mean")
    }
}
