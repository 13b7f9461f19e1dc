# The chart of tools/march_tolerance.sh: gnuplot -c march_tolerance.gp CSV FILE
# Left by the precision, right by the slack: the error, the error of the picture as it is shown, and the time.
csv = ARG1
set terminal pngcairo size 1060,860 font "DejaVu Sans,9" background "white"
set output ARG2
set datafile separator ","
set border 3
set tics out nomirror scale 0.4
set grid ytics linecolor "#dddddd"
set logscale x
scenes = "csg gyroid knot ball wires"
colors = "#26347c #3f9f5f #c8951a #d9432f #7b4fa3"
kinds = "precision slack"
# Columns of the table, and what they are.
columns = "6 8 5"
titles = "'relRMSE, %' 'RMS of the picture as it is shown, levels of 255' 'time, as a multiple'"
rows(kind, scene) = sprintf("< awk -F, '$1 == \"%s\" && $3 == \"%s\"' '%s'", kind, scene, csv)
# An error of 0 is that of the picture with which the others are compared. It has no place on a logarithmic axis, and a factor of 0 gets one.
shown(value) = value > 0 ? value : NaN
place(factor) = factor > 0 ? factor : 0.1

set multiplot layout 3,2 margins 0.06,0.98,0.06,0.93 spacing 0.07,0.07 \
    title "{/:Bold What the march's tolerances leave and what they cost}"
do for [row = 1:3] {
    do for [k = 1:2] {
        kind = word(kinds, k)
        set title word(titles, row)
        if (row < 3) {
            set logscale y
            set yrange [0.003:200]
        } else {
            unset logscale y
            set yrange [0.5:1.2]
            set xlabel sprintf("%s, the library's own as 1", kind)
        }
        if (k == 1) {
            set xtics ("1/4" 0.25, "1" 1, "4" 4, "16" 16, "64" 64, "256" 256)
            set xrange [0.2:320]
        } else {
            set xtics ("0" 0.1, "0.3" 0.3, "1" 1, "3" 3, "10" 10, "30" 30)
            set xrange [0.08:38]
        }
        unset arrow
        unset label
        if (row == 2) {
            set arrow from graph 0, first 0.289 to graph 1, first 0.289 nohead dashtype 2 linecolor "#666666"
            set label "the rounding to 8 bits" at graph 0.01, first 0.45 left textcolor "#666666"
        }
        if (row == 1 && k == 1) { set key top left } else { unset key }
        plot for [s = 1:5] rows(kind, word(scenes, s)) using (place($2)):(shown(column(int(word(columns, row))))) \
            with linespoints title word(scenes, s) linecolor rgb word(colors, s) linewidth 2 pointtype 7 pointsize 0.7
    }
}
unset multiplot
