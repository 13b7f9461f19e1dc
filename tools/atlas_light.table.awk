# The tables of atlas-light.md, from atlas-light.csv. The time to a given error is the square of the noise of a sample times the time of
# a sample. Into the files `map`.{off,on}.LIGHT go "column row ratio scene sun", with the time over that of the fastest method, for the
# picture.
function time_of(key) { return noise[key] * noise[key] * ns[key] }

BEGIN { FS = ","; lights = split("cosine control mis portal", light, " ") }

NR == 1 { next }

{
    cell = $1 "," $2 "," $3
    if (!(cell in taken)) { order[++cells] = cell; taken[cell] = $11 }
    if (!($1 in scene_row)) scene_row[$1] = scenes++
    if (!($2 in column)) column[$2] = suns++
    key = cell "," $4
    ns[key] = $6; noise[key] = $7
    # Where a few pixels have most of the error, it is chance which picture meets them.
    if ($8 > 0.5) rare[cell] = 1
    specks[cell] = $9 > specks[cell] ? $9 : specks[cell]
    if ($10 > 0 && $10 < 0.8) low[$4]++
    if ($10 > 0) judged[$4]++
}

function name_of(cell,    part) {
    split(cell, part, ",")
    return "`" part[1] "`, " part[2] (part[3] == "off" ? "" : ", disk")
}

END {
    for (i = 1; i <= cells; i++) {
        cell = order[i]
        best = 0
        for (l = 1; l <= lights; l++) {
            if (!(cell "," light[l] in noise)) continue
            t = time_of(cell "," light[l])
            if (t > 0 && (!best || t < best)) { best = t; winner[cell] = light[l] }
        }
        split(cell, part, ",")
        for (l = 1; l <= lights; l++) {
            measured = (cell "," light[l]) in noise
            if (measured) ratio[cell, light[l]] = best ? time_of(cell "," light[l]) / best : 1
            print column[part[2]], scene_row[part[1]], (measured && !rare[cell] ? ratio[cell, light[l]] : "NaN"), part[1], part[2] >(map "." part[3] "." light[l])
        }
        loss[cell] = ratio[cell, taken[cell]]
        print column[part[2]], scene_row[part[1]], (rare[cell] ? "NaN" : loss[cell]), part[1], part[2] >(map "." part[3] ".auto")
        if (rare[cell]) { few++; continue }
        known++
        within10 += loss[cell] <= 1.1
        within30 += loss[cell] <= 1.3
    }
    print "# Which light method is the fastest where\n\nMade by `make atlas-light`.\n"
    printf "`auto` is within 1.1 times the time of the fastest method in %d of %d cells, and within 1.3 times in %d.\n", within10, known, within30
    printf "In %d further cells ten pixels have more than half of the squared error, and the figures there are chance.\n\n", few
    print "| cell | `auto` takes | fastest | time of `auto`, fastest as 1 |\n|---|---|---|---|"
    for (k = 1; k <= 20; k++) {
        worst = ""
        for (i = 1; i <= cells; i++) {
            cell = order[i]
            if (!rare[cell] && !said[cell] && loss[cell] > 1.1 && (worst == "" || loss[cell] > loss[worst])) worst = cell
        }
        if (worst == "") break
        said[worst] = 1
        printf "| %s | `%s` | `%s` | %.2f |\n", name_of(worst), taken[worst], winner[worst], loss[worst]
    }
    print "\n| light | pictures whose noise was estimated | of these at under 0.8 of the true one |\n|---|---|---|"
    for (l = 1; l <= lights; l++) printf "| `%s` | %d | %d |\n", light[l], judged[light[l]], low[light[l]]
}
