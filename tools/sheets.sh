#!/bin/sh
# Contact sheets of all scenes, shapes and materials: tools/sheets.sh MAGICHOUR FOLDER GALLERY
# Scenes at noon, sunset and in twilight, by their presets, go to GALLERY/sheet-N.png; single shapes and materials, named, to
# GALLERY/shapes-and-materials.png. What lies between stays in FOLDER.
set -eu
export LC_ALL=C
magichour=$1
folder=$2
gallery=$3
tools=$(dirname "$0")
scenes=$tools/../scenes
rows=6 # of scenes on a sheet
mkdir -p "$folder" "$gallery"
rm -f "$folder"/sheet-*.list "$gallery"/sheet-*.png

# samples SCENE PRESET: light finds the rooms with difficulty, and the glow about a low sun is narrow.
samples() {
    case $1-$2 in
    house-sunset) echo 16384 ;;
    house-* | *-room-* | *-sunset) echo 4096 ;;
    *) echo 1024 ;;
    esac
}

# picture NAME SCENE OPTIONS...: FOLDER/NAME.png
picture() {
    file=$folder/$1.png
    shift
    "$magichour" render "$@" --quiet -o "$file"
}

count=0
for scene in "$scenes"/*.glsl; do
    name=$(basename "$scene" .glsl)
    list=$folder/sheet-$((count / rows + 1)).list
    row=$((count % rows))
    "$magichour" info "$scene" >"$folder/info"
    column=0
    for preset in noon sunset twilight; do
        label="$name, $preset"
        set -- --preset $preset
        # A scene without sun has no presets for it, and one picture.
        if ! grep -q -e "--preset $preset:" "$folder/info"; then
            [ $preset = noon ] || break
            label=$name
            set --
        fi
        picture "$name-$preset" "$scene" --size 144x108 --spp "$(samples "$name" $preset)" "$@"
        echo "$column $row $folder/$name-$preset.png $label" >>"$list"
        column=$((column + 1))
    done
    count=$((count + 1))
    echo "sheets: $name"
done

tile=96
per_row=8
: >"$folder/catalogue.list"
count=0

# entry LABEL INCLUDE SHAPE MATERIAL: a solid of a material on the ground.
entry() {
    {
        echo "//@ camera eye 1.2 1.7 -3.4  target 0 0.5 0  fov 26"
        echo "//@ sun elevation 40 azimuth 130"
        echo "//@ bound 0 0.5 0 0.8"
        for file in color/checker material/matte shape/plane $2; do echo "#include \"$file.glsl\""; done
        echo "void scene_intersect(Ray ray, INOUT(Hit) hit) {"
        echo "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);"
        echo "    hit_$3, 1, hit);"
        echo "}"
        echo "Material scene_material(Hit hit) {"
        echo "    if (hit.object == 1) return $4;"
        echo "    return matte(checker(4.0 * hit.position, vec3(0.5), vec3(0.35)));"
        echo "}"
    } >"$folder/entry.glsl"
    picture "entry-$count" "$folder/entry.glsl" --size ${tile}x$tile --spp 1024
    echo "$((count % per_row)) $((count / per_row)) $folder/entry-$count.png $1" >>"$folder/catalogue.list"
    count=$((count + 1))
}

# shape NAME ARGUMENTS
shape() {
    entry "$1" "shape/$1" "$1(ray, $2" "matte(vec3(0.75, 0.45, 0.25))"
}

# material LABEL INCLUDE EXPRESSION: on a ball.
material() {
    entry "$1" "shape/sphere $2" "sphere(ray, vec3(0.0, 0.6, 0.0), 0.6" "$3"
}

shape sphere "vec3(0.0, 0.6, 0.0), 0.6"
shape box "vec3(0.0, 0.5, 0.0), vec3(0.5)"
shape rounded_box "vec3(0.0, 0.5, 0.0), vec3(0.5), 0.15"
shape cylinder "vec3(0.0), vec3(0.0, 1.1, 0.0), 0.5"
shape capsule "vec3(0.0, 0.4, 0.0), vec3(0.0, 0.8, 0.0), 0.4"
shape cone "vec3(0.0), vec3(0.0, 1.2, 0.0), 0.6"
shape torus "vec3(0.0, 0.6, 0.0), vec3(0.0, 0.6, -0.8), 0.42, 0.18"
shape ellipsoid "vec3(0.0, 0.4, 0.0), vec3(0.7, 0.4, 0.5)"
shape disk "vec3(0.0, 0.6, 0.0), vec3(0.0, 0.6, -0.8), 0.6"
entry plane_minus_sphere shape/plane_minus_sphere \
    "plane_minus_sphere(ray, vec3(0.0, 1.0, 0.0), 0.6, vec3(0.0, 0.6, 0.0), 0.55" "matte(vec3(0.75, 0.45, 0.25))"
material matte "" "matte(vec3(0.3, 0.5, 0.75))"
material mirror material/mirror "mirror(vec3(0.95))"
material "gold(), 0.1" material/rough_metal "rough_metal(gold(), 0.1)"
material "copper(), 0.3" material/rough_metal "rough_metal(copper(), 0.3)"
material "aluminium(), 0.6" material/rough_metal "rough_metal(aluminium(), 0.6)"
material emitter material/emitter "emitter(vec3(1.2, 0.8, 0.4))"
material "glass(1.5)" material/glass "glass(1.5)"
material "glass_tinted" material/glass "glass_tinted(vec3(0.6, 0.9, 0.7), 1.5)"
material "author" material/author "author(vec3(0.3, 0.5, 0.75), 0.5, 0.3, 0.1)"
material checker color/checker "matte(checker(4.0 * hit.position, vec3(0.7, 0.2, 0.1), vec3(0.7)))"
material grid color/grid "matte(grid(4.0 * hit.position, 0.15, vec3(0.1), vec3(0.6, 0.65, 0.7)))"
material noise color/noise "matte(mix(vec3(0.2, 0.1, 0.05), vec3(0.8, 0.6, 0.4), noise(8.0 * hit.position)))"
material noise_octaves color/noise "matte(mix(vec3(0.1, 0.2, 0.4), vec3(0.8), noise_octaves(4.0 * hit.position, 5)))"
material gradient color/gradient \
    "matte(gradient(hit.position, vec3(0.0, 0.1, 0.0), vec3(0.0, 1.1, 0.0), vec3(0.8, 0.2, 0.1), vec3(0.2, 0.4, 0.8)))"

for list in "$folder"/sheet-*.list; do
    file=$gallery/$(basename "$list" .list).png
    gnuplot -c "$tools/sheet.gp" "$list" "$file" 144 108
    echo "sheets: $file"
done
gnuplot -c "$tools/sheet.gp" "$folder/catalogue.list" "$gallery/shapes-and-materials.png" $tile $tile
echo "sheets: $gallery/shapes-and-materials.png"
