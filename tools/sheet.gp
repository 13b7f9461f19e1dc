# A contact sheet: gnuplot -c sheet.gp LIST FILE WIDTH HEIGHT [STEP]. LIST has a line for each picture: column, row, picture, label.
# Pictures of one size, WIDTH by HEIGHT, are set pixel for pixel, each with its label below.
# Colours are rounded to multiples of STEP, 1 by default. A step of 5 makes the file half as large, since it rounds the dithering away.
list = ARG1
width = int(ARG3)
height = int(ARG4)
step = ARGC > 4 ? int(ARG5) : 1
rounded(level) = step * int(level / step + 0.5) > 255 ? 255 : step * int(level / step + 0.5)
gap = 6
label = 18

stats list using 1:2 nooutput
columns = int(STATS_max_x) + 1
rows = int(STATS_max_y) + 1
right = columns * (width + gap) + gap
top = rows * (height + label) + gap

set terminal pngcairo size right,top font "DejaVu Sans,8" background "white"
set output ARG2
unset border
unset tics
unset key
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0
set tmargin at screen 1
set xrange [0:right]
set yrange [0:top]

count = int(STATS_records)
array left[count]
array bottom[count]
array picture[count]
do for [i = 1:count] {
    line = system(sprintf("sed -n %dp '%s'", i, list))
    left[i] = gap + int(word(line, 1)) * (width + gap)
    bottom[i] = top - gap - int(word(line, 2)) * (height + label) - height
    picture[i] = word(line, 3)
    words = line[strstrt(line, picture[i]) + strlen(picture[i]) + 1:*]
    set label i words at left[i] + 0.5 * width, bottom[i] - 0.45 * label center noenhanced front
}
plot for [i = 1:count] picture[i] binary filetype=png origin=(left[i] + 0.5, bottom[i] + 0.5) dx=1 dy=1 \
    using (rounded($1)):(rounded($2)):(rounded($3)) with rgbimage
