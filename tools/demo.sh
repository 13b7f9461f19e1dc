#!/bin/sh
# The paper's figures: tools/demo.sh MAGICHOUR FOLDER [further options of `render`]
set -eu
magichour=$1
folder=$2
shift 2
scene=$(dirname "$0")/../scenes/crater.glsl
mkdir -p "$folder"

figure() {
    name=$1
    shift
    "$magichour" render "$scene" -o "$folder/$name.exr" -o "$folder/$name.png" "$@"
}

echo "The paper's figures, EXR and PNG in $folder/:"
figure noon --preset noon --spp 256 "$@"
figure afternoon --preset afternoon --spp 256 "$@"
figure sunset --preset sunset --spp 256 "$@"
figure early-evening --preset early-evening --spp 256 "$@"
# Aerosols alone scatter so narrowly about the sun that the bowl finds the light by chance: more samples.
figure sunset-without-rayleigh --preset sunset --exposure 0 --set atmosphere.rayleigh=0 --spp 1024 "$@"
figure sunset-without-rayleigh-or-ball --preset sunset --exposure 0 --set atmosphere.rayleigh=0 --set ball=0 --spp 1024 "$@"
# Not the paper's: the sun itself.
figure sunlit-noon --preset noon --sun-disk --exposure -3 --spp 256 "$@"
figure sunlit-afternoon --sun 20,180 --sun-disk --exposure -2 --spp 256 "$@"
figure sunlit-sunset --preset sunset --sun-disk --exposure -1.5 --spp 256 "$@"
"$magichour" render "$(dirname "$scene")/gyroid.glsl" -o "$folder/gyroid.exr" -o "$folder/gyroid.png" --sun-disk --exposure -2 --spp 64 "$@"
