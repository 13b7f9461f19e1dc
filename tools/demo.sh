#!/bin/sh
# The paper's figures: tools/demo.sh MAGICHOUR FOLDER [further options of `render`]
# One line each: name, preset or sun, further settings.
set -eu
magichour=$1
folder=$2
shift 2
scene=$(dirname "$0")/../scenes/crater.glsl
mkdir -p "$folder"

figure() {
    name=$1
    shift
    "$magichour" render "$scene" -o "$folder/$name.exr" -o "$folder/$name.png" --spp 256 "$@"
}

echo "The crater under the paper's sky (16x4 sums), 512x512, 256 samples a pixel; EXR and PNG in $folder/"
figure noon --preset noon "$@"
figure afternoon --preset afternoon "$@"
figure sunset --preset sunset "$@"
figure early-evening --preset early-evening "$@"
figure sunset-without-rayleigh --preset sunset --set atmosphere.rayleigh=0 "$@"
figure sunset-without-rayleigh-or-ball --preset sunset --set atmosphere.rayleigh=0 --set ball=0 "$@"
