#!/bin/sh
# What the scripts that measure have in common. They source this file.

# Runs a command and prints its seconds of processor time. Its messages go to FILE, and are shown if it fails: cpu_seconds FILE COMMAND...
cpu_seconds() {
    messages=$1
    shift
    ("$@" 2>"$messages" && times) >"$messages.times" || { cat "$messages" >&2; return 1; }
    # The second line is that of the command: "0m1.25s 0m0.03s".
    awk -F '[ms ]+' 'NR == 2 { print 60 * ($1 + $3) + $2 + $4 }' "$messages.times"
}

# A number of a file of JSON lines, or the first of a list of numbers, as it stands in the last line that has it: json_number NAME FILE
json_number() {
    sed -n "s/^{.*\"$1\": \[*\([-0-9.e+]*\).*/\1/p" "$2" | tail -n 1
}

# The largest of the three channels' biases, in percent, from a file of `compare --json`.
largest_bias() {
    sed 's/.*"bias_R_G_B": \[\([^]]*\)\].*/\1/' "$1" | tr ',' '\n' | awk '
        function size(x) { return x < 0 ? -x : x }
        NR == 1 || size($1) > size(bias) { bias = $1 }
        END { printf "%+.5f", bias }'
}

# The values of a PFM, one a line. Its header may have the length of any size.
pfm_values() {
    sed 1,3d "$1" | od -A n -v -t f4 -w4
}
