#!/bin/sh
# The crater under the paper's sky and under that of the atmosphere `earth`: tools/demo.sh MAGICHOUR FOLDER [further options of `render`]
set -eu
magichour=$1
folder=$2
shift 2
scenes=$(dirname "$0")/../scenes
mkdir -p "$folder"

# figure NAME WHAT SCENE OPTIONS...
figure() {
    name=$1
    scene=$3
    echo "$name: $2"
    shift 3
    "$magichour" render "$scenes/$scene" "$@" -o "$folder/$name.exr" -o "$folder/$name.png"
}

echo "Pictures, as EXR and as PNG, in $folder/. First the crater under the paper's sky, which scatters light once:"
figure noon "the sun at 60 degrees" crater.glsl --preset noon --spp 256 "$@"
figure afternoon "the sun at 30" crater.glsl --preset afternoon --spp 256 "$@"
figure sunset "the sun at 5" crater.glsl --preset sunset --spp 256 "$@"
figure early-evening "the sun is 2 degrees below the horizon" crater.glsl --preset early-evening --spp 256 "$@"
# Aerosols alone scatter so narrowly about the sun that the bowl finds the light by chance: more samples.
figure sunset-without-rayleigh "only aerosols scatter, the air does not" crater.glsl --preset sunset --exposure 0 \
    --set atmosphere.rayleigh=0 --spp 1024 "$@"
figure sunset-without-rayleigh-or-ball "the same without the ball" crater.glsl --preset sunset --exposure 0 \
    --set atmosphere.rayleigh=0 --set ball=0 --spp 1024 "$@"

echo "The same crater under the atmosphere earth: ozone, light that air and ground scatter any number of times, true colours:"
figure earth-noon "the sun at 60" crater.glsl --atmosphere earth --preset noon --spp 256 "$@"
figure earth-sunset "the sun at 5: blue where the paper's sky is green" crater.glsl --atmosphere earth --preset sunset --spp 256 "$@"
figure earth-early-evening "the sun at -2: the sky overhead is blue, because ozone absorbs red" crater.glsl --atmosphere earth \
    --preset early-evening --spp 256 "$@"
figure earth-blue-hour "the sun at -6: the paper's sky would be brown" crater.glsl --atmosphere earth --sun -6 --exposure 8.3 \
    --sky table --spp 256 "$@"

echo "Not the paper's: the sun's own disk shines too."
figure sunlit-noon "the sun at 60" crater.glsl --preset noon --sun-disk --exposure -3 --spp 256 "$@"
figure sunlit-afternoon "the sun at 20, behind the camera" crater.glsl --sun 20,180 --sun-disk --exposure -2 --spp 256 "$@"
figure sunlit-sunset "the sun at 5" crater.glsl --preset sunset --sun-disk --exposure -1.5 --spp 256 "$@"
figure gyroid "another scene, a distance field, under earth" gyroid.glsl --sun-disk --exposure -2 --spp 64 "$@"
