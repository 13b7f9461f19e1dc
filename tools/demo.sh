#!/bin/sh
# The crater under the paper's sky and under that of the atmosphere `earth`: tools/demo.sh MAGICHOUR FOLDER [further options of `render`]
#
# A picture is rendered until its noise is too small to be seen: an RMS of 1 of 255 levels, and of 2 in the worst tile. Two pictures
# would take minutes so, and have up to twice that. At the blue hour the sky's own error leaves little of 1 level to the noise.
set -eu
magichour=$1
folder=$2
shift 2
scenes=$(dirname "$0")/../scenes
mkdir -p "$folder"

# figure SECONDS NAME WHAT SCENE OPTIONS...: SECONDS are what it takes on two cores of an AMD EPYC, relative to the other pictures.
figures() {
    say "First the crater under the paper's sky, which scatters light once:"
    figure 3 noon "the sun at 60 degrees" crater --preset noon "$@"
    figure 4 afternoon "the sun at 30" crater --preset afternoon "$@"
    figure 10 sunset "the sun at 5" crater --preset sunset "$@"
    figure 4 early-evening "the sun is 2 degrees below the horizon" crater --preset early-evening "$@"
    figure 35 sunset-without-rayleigh "only aerosols scatter, the air does not" crater --preset sunset --exposure 0 \
        --set atmosphere.rayleigh=0 --error 1.5levels "$@"
    figure 13 sunset-without-rayleigh-or-ball "the same without the ball" crater --preset sunset --exposure 0 \
        --set atmosphere.rayleigh=0 --set ball=0 "$@"

    say "The same crater under the atmosphere earth: ozone, light that air and ground scatter any number of times, true colours:"
    figure 7 earth-noon "the sun at 60" crater --atmosphere earth --preset noon "$@"
    figure 10 earth-sunset "the sun at 5: blue where the paper's sky is green" crater --atmosphere earth --preset sunset "$@"
    figure 7 earth-early-evening "the sun at -2: the sky overhead is blue, because ozone absorbs red" crater \
        --atmosphere earth --preset early-evening "$@"
    figure 5 earth-blue-hour "the sun at -6: the paper's sky would be brown" crater --atmosphere earth --sun -6 --exposure 8.3 \
        --sky table --error 1.5levels "$@"

    say "Not the paper's: the sun's own disk shines too."
    figure 5 sunlit-noon "the sun at 60" crater --preset noon --sun-disk --exposure -3 "$@"
    figure 6 sunlit-afternoon "the sun at 20, behind the camera" crater --sun 20,180 --sun-disk --exposure -2 "$@"
    figure 5 sunlit-sunset "the sun at 5" crater --preset sunset --sun-disk --exposure -1.5 "$@"
    figure 80 gyroid "another scene, a distance field, under earth" gyroid --sun-disk --exposure -2 --error 2levels "$@"
}

# The list is gone through twice: it is counted, and then it is rendered.
count=0 whole=0
say() { :; }
figure() { count=$((count + 1)) whole=$((whole + $1)); }
figures "$@"

number=0 done=0 start=$(date +%s)
# What is left, by the time that the pictures before took.
left() {
    [ $done -gt 0 ] || return 0
    seconds=$((($(date +%s) - start) * (whole - done) / done))
    if [ $seconds -ge 90 ]; then echo " (about $(((seconds + 30) / 60)) minutes left)"; else echo " (about $seconds s left)"; fi
}
# Status 7 says that the error is not promised, because the sky without Rayleigh's scattering was not measured.
unless_unpromised() { [ "$1" = 7 ] || exit "$1"; }
say() { echo && echo "$1"; }
figure() {
    cost=$1 name=$2 what=$3 scene=$4
    shift 4
    number=$((number + 1))
    echo "$number of $count, $name: $what$(left)"
    "$magichour" render "$scenes/$scene.glsl" --error 1levels "$@" -o "$folder/$name.exr" -o "$folder/$name.png" || unless_unpromised $?
    done=$((done + cost))
}
echo "$count pictures, each as EXR and as PNG, go into $folder/. On two cores this takes about $((whole / 60 + 1)) minutes."
figures "$@"

cat <<END

$count pictures are in $folder/, after $(($(date +%s) - start)) s. What to try next:
    $magichour view crater                                  move the sun with the right mouse button; F1 lists the keys
    $magichour render valley -o $folder/valley.png --sun 4   another scene; \`$magichour info\` lists them all
    cp scenes/crater.glsl my.glsl && $magichour view my.glsl   change the file in your editor and see it (scenes/README.md)
END
