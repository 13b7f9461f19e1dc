# One method's chart: gnuplot -c atlas.gp METHOD FOLDER FILE TRUTH, with FOLDER/axes and FOLDER/map{1,10000,100000} by the awk programs.
method = ARG1
folder = ARG2
file = ARG3
truth = ARG4

load folder."/axes"
set logscale cb
set cbrange [1e-5:100]
set cbtics ("100 %%" 100, "10 %%" 10, "1 %%" 1, "0.1 %%" 0.1, "0.01 %%" 0.01, "10^{-3} %%" 1e-3, "10^{-4} %%" 1e-4, "10^{-5} %%" 1e-5)
# Blue is fine, yellow is 0.1 %, red is wrong; two steps a decade.
set palette maxcolors 14 defined (0 "#26347c", 2 "#3f7fbf", 3 "#8cc4de", 3.8 "#d9eef2", 4.2 "#fff3b0", 5 "#fdbb5c", 6 "#e0492f", 7 "#4d0014")
unset key
set tics out nomirror
set border lw 0.5
set xlabel "view elevation above the visible horizon, degrees" offset 0,0.3
set grid front lw 0.5 lc "#60808080" lt 1
set object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor "#b8b8b8" fillstyle solid noborder

do for [format in "svg png"] {
    if (format eq "svg") {
        set terminal svg size 1500,560 font "DejaVu Sans,Arial,sans-serif,13" background "white"
    } else {
        set terminal pngcairo size 1500,560 font "DejaVu Sans,10" background "white"
    }
    set output file.".".format
    set multiplot layout 1,3 margins 0.05,0.925,0.13,0.865 spacing 0.032,0 \
        title "{/:Bold ".method."}: error against ".truth.", worst of three channels and five azimuths. Grey: no light." offset 0,0.2
    set ylabel "sun elevation, degrees" offset 0.8,0
    unset colorbox
    set title "observer at 1 m (horizon at -0.03°)" offset 0,-0.6
    plot folder."/map1" using 1:2:3 with image
    unset ylabel
    set title "10 km (horizon at -3.21°)"
    plot folder."/map10000" using 1:2:3 with image
    set title "100 km, above the air (horizon at -10.11°)"
    set colorbox user origin 0.935,0.13 size 0.014,0.735
    set arrow 1 from limb, graph 0 to limb, graph 1 nohead front dashtype 3
    set label 1 "the limb:\nno air above" at limb, graph 0.95 offset 0.6,0 front
    plot folder."/map100000" using 1:2:3 with image
    unset arrow 1
    unset label 1
    unset multiplot
}
