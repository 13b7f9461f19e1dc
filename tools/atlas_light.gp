# The picture of atlas-light.md: gnuplot -c atlas_light.gp FOLDER FILE, with FOLDER/map.DISK.LIGHT by atlas_light.table.awk.
folder = ARG1
set terminal pngcairo size 1060,760 font "DejaVu Sans,9" background "white"
set output ARG2
set logscale cb
set cbrange [1:4]
set cbtics ("1" 1, "1.1" 1.1, "1.3" 1.3, "2" 2, "4+" 4)
set palette defined (0 "#26347c", 0.07 "#3f7fbf", 0.19 "#d9eef2", 0.5 "#fdbb5c", 0.75 "#e0492f", 1 "#4d0014")
unset key
set tics out nomirror scale 0.3
stats folder."/map.off.auto" using 1:2 nooutput
set xrange [-0.5:STATS_max_x + 0.5]
set yrange [STATS_max_y + 0.5:-0.5]
set object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor "#b8b8b8" fillstyle solid noborder
set multiplot layout 1,10 margins 0.1,0.9,0.07,0.87 spacing 0.008,0 \
    title "{/:Bold Time to a given error, the fastest method as 1.} Left without the sun's disk, right with it. Below: the sun's elevation. Grey: chance decides, or no portal."
unset colorbox
do for [disk in "off on"] {
    do for [light in "auto cosine control mis portal"] {
        set title light
        if (disk eq "off" && light eq "auto") {
            plot folder."/map.off.auto" using 1:2:($3 > 4 ? 4 : $3):ytic(4):xtic(5) with image
            set format y ""
        } else {
            if (disk eq "on" && light eq "portal") {
                set colorbox user origin 0.915,0.07 size 0.015,0.8
            }
            plot folder."/map.".disk.".".light using 1:2:($3 > 4 ? 4 : $3):xtic(5) with image
        }
    }
}
unset multiplot
