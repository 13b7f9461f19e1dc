# march() beside a plain sphere tracer: gnuplot -c march_peer.gp TABLE FILE, with TABLE by march_peer.sh.
table = ARG1
set datafile separator ","
set terminal pngcairo size 900,400 font "DejaVu Sans,10" background "white"
set output ARG2
set logscale xy
set xlabel "processor time of a path, microseconds"
set grid lw 0.5 lc "#60808080" lt 1
set key bottom left samplen 2
set yrange [0.03:100]
set multiplot layout 1,2
do for [depth in "1 0"] {
    set title depth eq "1" ? "one surface hit" : "all surface hits"
    set ylabel depth eq "1" ? "error without noise, % of the mean, at most" : ""
    set xrange [depth eq "1" ? 0.5 : 1 : depth eq "1" ? 30 : 100]
    row(way, fudge) = sprintf("<awk -F, '$1 == %s && $2 == \"%s\" && $4 == \"%s\"' '%s'", depth, way, fudge, table)
    plot row("plain", "1.0") using 5:8 with linespoints pt 7 lw 1.5 lc "#c0392b" title "plain, fudge factor 1", \
        "" using 5:8:(strcol(3) eq "1.0e-6" ? "" : strcol(3)) with labels font ",7" right offset -0.8,-0.2 notitle, \
        "" using 5:8:(strcol(3) eq "1.0e-6" ? strcol(3) : "") with labels font ",7" left offset 0.5,0.6 notitle, \
        row("plain", "0.5") using 5:8 with linespoints pt 6 lw 1.5 lc "#e59866" title "plain, fudge factor 0.5", \
        row("march", "-") using 5:8 with linespoints pt 5 lw 1.5 lc "#1f4e9e" title "march(), slack 3e-4, 3e-5 and 0"
}
unset multiplot
