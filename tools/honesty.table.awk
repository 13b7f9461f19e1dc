# The tables of honesty.md, from the rows of tools/honesty_one.sh.
function add(key) {
    rows[key]++
    if ($7 == "promised") {
        given[key]++
        kept[key] += $8 <= 1
        near[key] += $8 <= 1.1
        if ($8 > worst[key]) worst[key] = $8
    }
    else verdicts[key, $7]++
}

# What the counts of a key fill of a row.
function cells(key) {
    return sprintf("%d | %d | %d | %d | %s | %d | %d | %d |", rows[key], given[key], kept[key], near[key], given[key] ? sprintf("%.2f", worst[key]) : "", \
        verdicts[key, "unpromised"], verdicts[key, "slow"], verdicts[key, "noisy"])
}

function header(first) {
    print "| " first " | pictures | promised | kept within 1.0 | within 1.1 | worst | not promised | took longer | reference too noisy |"
    print "|---|---|---|---|---|---|---|---|---|"
}

function print_rows(keys, count, prefix,    i) {
    for (i = 1; i <= count; i++) print "| " keys[i] " | " cells(prefix keys[i])
}

# A row of a picture that was promised and is not within 1.1 of the promise, the worst first.
function print_broken(    i, j, t) {
    for (i = 1; i <= broken; i++)
        for (j = i + 1; j <= broken; j++) if (ratio[j] > ratio[i]) {
            t = ratio[i]; ratio[i] = ratio[j]; ratio[j] = t
            t = words[i]; words[i] = words[j]; words[j] = t
        }
    for (i = 1; i <= broken; i++) printf "| %s | %.2f |\n", words[i], ratio[i]
}

BEGIN { FS = "," }

{
    name = "`" $1 "`, " $4
    promise = $5 " " ($4 == "percent" ? "%" : "levels")
    if (!(("p" promise) in rows)) promised[++promises] = promise
    if (!(("s" name) in rows)) listed[++list] = name
    add("all"); add("p" promise); add("s" name)
    # What a reason says of shares and materials differs from picture to picture, so that its kind is counted.
    if ($7 == "unpromised") {
        kind = $10 ~ /sunlight/ ? "light left to chance was found too seldom" : $10
        gsub(/[0-9.]+ %/, "some %", kind)
        if (!(kind in reasons)) reason[++kinds] = kind
        reasons[kind]++
    }
    if ($7 == "promised" && $8 > 1.1) {
        ratio[++broken] = $8
        words[broken] = "`" $1 "`, sun " $2 ", disk " $3 ", " promise ", seed " $6
    }
}

END {
    if (!rows["all"]) { print "honesty: no picture was judged" >"/dev/stderr"; exit 1 }
    printf "Of %d pictures in which an error was promised and could be judged, %d are within 1.1 of the promise (%.1f %%). The worst is at %.2f.\n\n", \
        given["all"], near["all"], given["all"] ? 100 * near["all"] / given["all"] : 0, worst["all"]
    header("promise")
    print_rows(promised, promises, "p")
    print "| all | " cells("all")
    print ""
    header("scene, measure")
    print_rows(listed, list, "s")
    if (kinds) print "\n| why there was no promise | pictures |\n|---|---|"
    for (i = 1; i <= kinds; i++) print "| " reason[i] " | " reasons[reason[i]] " |"
    if (broken) print "\n| beyond 1.1 of the promise | true error, the promise as 1 |\n|---|---|"
    print_broken()
}
