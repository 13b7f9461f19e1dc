#!/bin/sh
# Contact sheets of the distances: tools/shapes_sheet.sh MAGICHOUR FOLDER GALLERY
# Solids, flat figures that are extruded, and operators go to GALLERY/distance-solids.png, distance-figures.png and distance-operators.png,
# one picture for each function. Every picture has the same camera and the same light. What lies between stays in FOLDER.
set -eu
export LC_ALL=C
magichour=$1
folder=$2
gallery=$3
tools=$(dirname "$0")
mkdir -p "$folder" "$gallery"
rm -f "$folder"/*.list

# The files of the sheet that is being drawn, its name, the size of a picture, and how many are in a row.
files=
sheet=
width=96
height=96
per_row=8
count=0

# begin SHEET FILES...: a sheet whose scenes include these files.
begin() {
    sheet=$1
    shift
    files=$*
    count=0
}

# finish: puts the pictures on the sheet.
finish() {
    gnuplot -c "$tools/sheet.gp" "$folder/$sheet.list" "$gallery/$sheet.png" $width $height 5
    echo "sheets: $gallery/$sheet.png"
}

# draw NAME RADIUS BODY: the function scene_distance(p), marched within this radius of the middle, or everywhere if it is 0.
draw() {
    scene=$folder/$sheet-$1.glsl
    within="vec3(0.0, 0.5, 0.0), $2, "
    [ "$2" != 0 ] || within=
    {
        echo "//@ camera eye -1.2 1.7 3.4  target 0 0.52 0  fov 26"
        echo "//@ sun elevation 35 azimuth 285"
        echo "//@ sun-disk on"
        echo "//@ atmosphere earth"
        for file in material/matte shape/march shape/plane; do echo "#include \"$file.glsl\""; done
        for file in $files; do echo "#include \"distance/$file.glsl\""; done
        echo "float scene_distance(vec3 p) {"
        echo "    vec2 flat_p = vec2(p.x, p.y - 0.6);"
        echo "    $3"
        echo "}"
        echo "void scene_intersect(Ray ray, INOUT(Hit) hit) {"
        echo "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);"
        echo "    march(ray, ${within}1, hit);"
        echo "}"
        echo "Material scene_material(Hit hit) {"
        echo "    return matte(hit.object == 1 ? vec3(0.75, 0.45, 0.25) : vec3(0.35));"
        echo "}"
    } >"$scene"
    "$magichour" render "$scene" --size "${width}x$height" --spp 256 --exposure -1.5 -o "$folder/$sheet-$1.png" 2>"$folder/$sheet-$1.log" >&2 ||
        { cat "$folder/$sheet-$1.log" >&2 && exit 1; }
    ! grep -i warning "$folder/$sheet-$1.log" || echo "sheets: $1 has warnings"
    echo "$((count % per_row)) $((count / per_row)) $folder/$sheet-$1.png $1" >>"$folder/$sheet.list"
    count=$((count + 1))
}

# solid NAME ARGUMENTS
solid() {
    draw "$1" 0.95 "return distance_$1(p, $2);"
}

# figure NAME ARGUMENTS; line NAME ARGUMENTS: a figure without a width.
figure() {
    draw "$1" 0.95 "return op_extrude(distance_$1(flat_p, $2), p.z, 0.15);"
}

line() {
    draw "$1" 0.95 "return op_extrude(op_round(distance_$1(flat_p, $2), 0.08), p.z, 0.15);"
}

# operator NAME BODY
operator() {
    draw "$1" 0.95 "$2"
}

# two NAME ARGUMENTS: of a box and a ball. The ball stands out of the box's nearest corner.
two() {
    draw "$1" 0.95 "float a = distance_box(p, vec3(0.1, 0.4, -0.1), vec3(0.45, 0.4, 0.45)); float b = distance_sphere(p, vec3(-0.2, 0.7, 0.25), 0.38);
    return op_$1(a, b$2);"
}

# post NAME ARGUMENTS: of a box and a cylinder whose surfaces meet at right angles. In intersections both are so wide that the post alone is left.
post() {
    radius=0.28
    half_width=0.55
    if [ "${1%_intersection}" != "$1" ]; then
        radius=0.45
        half_width=0.75
    fi
    draw "$1" 0.95 "float a = distance_box(p, vec3(0.0, 0.35, 0.0), vec3($half_width, 0.35, $half_width)); float b = distance_cylinder(p, vec3(0.0, -0.5, 0.0), vec3(0.0, 1.1, 0.0), $radius);
    return op_$1(a, b, $2) / JOIN_STEEPNESS;"
}

begin distance-solids boolean box move offset box_frame capped_torus link prism capped_cone round_cone cut_sphere vesica octahedron pyramid infinite bezier menger mandelbulb julia apollonian hills
solid box_frame "vec3(0.0, 0.5, 0.0), vec3(0.5), 0.08"
solid capped_torus "vec3(0.0, 0.55, 0.0), vec3(0.0, 0.0, 1.0), vec3(0.0, 1.0, 0.0), 2.2, 0.42, 0.12"
solid link "vec3(0.0, 0.6, 0.0), vec3(0.0, 0.0, 1.0), vec3(0.0, 1.0, 0.0), 0.22, 0.28, 0.1"
solid hexagonal_prism "vec3(0.0, 0.4, 0.0), 0.6, 0.4"
solid triangular_prism "vec3(0.0, 0.4, 0.0), 0.7, 0.4"
solid rhombus_prism "vec3(0.0, 0.4, 0.0), vec2(0.7, 0.4), 0.4"
solid capped_cone "vec3(0.0), vec3(0.0, 1.0, 0.0), 0.6, 0.3"
solid round_cone "vec3(0.0, 0.42, 0.0), vec3(0.0, 0.95, 0.0), 0.42, 0.2"
solid solid_angle "vec3(0.0, 0.05, 0.0), vec3(0.0, 1.0, 0.0), 0.6, 1.05"
solid cut_sphere "vec3(0.0, 0.6, 0.0), vec3(0.0, 1.0, 0.0), 0.6, 0.2"
solid cut_hollow_sphere "vec3(0.0, 0.55, 0.0), vec3(0.0, 0.8, 0.6), 0.5, 0.15, 0.08"
solid vesica "vec3(0.0), vec3(0.0, 1.2, 0.0), 0.35"
solid octahedron "vec3(0.0, 0.6, 0.0), 0.6"
solid pyramid "vec3(0.0), 0.55, 0.9"
draw infinite_cylinder 0 "return distance_infinite_cylinder(p, vec3(0.0, 0.4, 0.0), vec3(1.0, 0.0, 0.0), 0.3);"
draw infinite_cone 0 "return distance_infinite_cone(p, vec3(0.0, 0.9, 0.0), vec3(0.0, -1.0, 0.0), 0.5);"
solid bezier_tube "vec3(-0.55, 0.15, 0.0), vec3(0.0, 1.7, 0.0), vec3(0.55, 0.15, 0.2), 0.12"
solid menger "vec3(0.0, 0.5, 0.0), 0.5, 3"
operator mandelbulb "return 0.52 * distance_mandelbulb(op_scale(op_translate(p, vec3(0.0, 0.58, 0.0)), 0.52), 8.0, 4);"
operator julia "return 0.5 * distance_julia(op_scale(op_translate(p, vec3(0.0, 0.5, 0.0)), 0.5), vec4(-1.0, 0.2, 0.0, 0.0), 9);"
operator apollonian "vec3 q = op_translate(p, vec3(0.0, 0.55, 0.0));
    return op_intersection(op_round(0.25 * distance_apollonian(op_scale(q, 0.25), 1.1, 6), 0.006), distance_box(q, vec3(0.0), vec3(0.5)));"
draw hills 0 "return (p.y - 0.5 * hills(2.0 * vec2(p.x, p.z))) / length(vec2(1.0, HILLS_SLOPE));"
finish

begin distance-figures section offset round ellipse rectangle polygon quadrilateral segment bezier polyline glyph
figure circle "vec2(0.0), 0.55"
figure ring "vec2(0.0), 0.45, 0.2"
figure arc "vec2(0.0), 0.45, 2.2, 0.2"
figure moon "vec2(-0.1, 0.0), 0.55, 0.45, 0.3"
figure heart "vec2(0.0, -0.58), 1.0"
figure pie "vec2(0.0, -0.4), 0.95, 0.7"
figure ellipse "vec2(0.0), vec2(0.6, 0.35)"
figure rectangle "vec2(0.0), vec2(0.6, 0.4)"
figure rounded_rectangle "vec2(0.0), vec2(0.6, 0.4), 0.2"
figure cross "vec2(0.0), 0.55, 0.2"
figure regular_polygon "vec2(0.0), 0.58, 5.0"
figure star "vec2(0.0), 0.6, 0.27, 5.0"
figure rhombus "vec2(0.0), vec2(0.4, 0.58)"
figure triangle "vec2(-0.6, -0.5), vec2(0.6, -0.3), vec2(-0.1, 0.55)"
figure quadrilateral "vec2(-0.55, -0.5), vec2(0.0, -0.25), vec2(0.55, -0.5), vec2(0.1, 0.55)"
figure trapezoid "vec2(0.0), 0.6, 0.3, 0.4"
figure parallelogram "vec2(0.0), vec2(0.45, 0.4), 0.2"
line segment "vec2(-0.5, -0.4), vec2(0.5, 0.4)"
line quadratic_bezier "vec2(-0.5, -0.4), vec2(0.1, 1.2), vec2(0.5, -0.3)"
operator polygon "Polyline line = polyline_start(flat_p, vec2(-0.55, -0.5)); polyline_to(line, vec2(0.55, -0.5)); polyline_to(line, vec2(0.55, 0.1));
    polyline_to(line, vec2(0.2, 0.1)); polyline_to(line, vec2(0.0, 0.55)); polyline_to(line, vec2(-0.2, 0.1)); polyline_to(line, vec2(-0.55, 0.1));
    return op_extrude(distance_polygon(line), p.z, 0.15);"
operator polyline "Polyline line = polyline_start(p, vec3(-0.6, 0.15, 0.2)); polyline_to(line, vec3(-0.3, 1.0, 0.0)); polyline_to(line, vec3(0.0, 0.2, -0.2));
    polyline_to(line, vec3(0.3, 1.0, -0.2)); polyline_to(line, vec3(0.6, 0.15, 0.3)); return op_round(distance_polyline(line), 0.08);"
operator glyph "float a = distance_glyph(flat_p, vec2(-0.6, -0.4), 0.8, 71); float b = distance_glyph(flat_p, vec2(-0.6 + 0.8 * GLYPH_ADVANCE, -0.4), 0.8, 76);
    return op_extrude(op_round(min(a, b), 0.07), p.z, 0.15);"
finish

# Operators have longer names.
width=112
per_row=7
begin distance-operators boolean smooth offset move elongate repeat repeat_polar repeat_random mirror smooth_kinds join deform noise section \
    polygon box sphere cylinder torus cone plane octahedron rounded_box
two union ""
two intersection ""
two subtraction ""
operator inverse "return op_intersection(distance_box(p, vec3(0.0, 0.4, 0.0), vec3(0.55, 0.4, 0.4)), op_inverse(distance_sphere(p, vec3(0.0, 0.4, 0.0), 0.5)));"
operator xor "float d = op_xor(distance_box(p, vec3(0.1, 0.4, 0.0), vec3(0.45, 0.4, 0.45)), distance_sphere(p, vec3(-0.25, 0.65, 0.0), 0.4));
    return op_intersection(d, distance_plane(p, vec3(0.0, 0.0, 1.0), 0.0));"
two smooth_union ", 0.2"
two smooth_intersection ", 0.2"
two smooth_subtraction ", 0.2"
two smooth_union_circular ", 0.2"
two smooth_union_root ", 0.2"
operator round "return op_round(distance_box(p, vec3(0.0, 0.5, 0.0), vec3(0.35)), 0.15);"
operator shell "return op_intersection(op_shell(distance_sphere(p, vec3(0.0, 0.55, 0.0), 0.48), 0.1), distance_plane(p, vec3(0.0, 0.8, 0.6), 0.6));"
operator translate "float here = distance_octahedron(p, vec3(-0.45, 0.4, 0.0), 0.38);
    return min(here, distance_octahedron(op_translate(p, vec3(0.9, 0.2, 0.0)), vec3(-0.45, 0.4, 0.0), 0.38));"
operator rotate "return distance_box(op_rotate(op_translate(p, vec3(0.0, 0.6, 0.0)), vec3(0.0, 0.0, 1.0), 0.6), vec3(0.0), vec3(0.55, 0.2, 0.3));"
operator scale "vec3 q = op_translate(p, vec3(0.45, 0.0, 0.0));
    return min(distance_cone(op_translate(p, vec3(-0.3, 0.0, 0.0)), vec3(0.0), vec3(0.0, 1.0, 0.0), 0.42),
               0.5 * distance_cone(op_scale(q, 0.5), vec3(0.0), vec3(0.0, 1.0, 0.0), 0.42));"
operator elongate "return distance_torus(op_elongate(op_translate(p, vec3(0.0, 0.45, 0.0)), vec3(0.3, 0.0, 0.0)), vec3(0.0), vec3(0.0, 0.0, 1.0), 0.3, 0.12);"
operator repeat_cell "float d = INFINITY;
    for (int i = 0; i < 4; i++) d = min(d, distance_octahedron(repeat_cell(p, vec3(0.45, 0.0, 0.45), vec3(3.0, 0.0, 3.0), i), vec3(0.0, 0.2, 0.0), 0.2));
    return d;"
operator repeat_polar "vec3 near = repeat_polar(p, 9.0, 0); vec3 beside = repeat_polar(p, 9.0, 1);
    return min(distance_box(near, vec3(0.6, 0.35, 0.0), vec3(0.1, 0.35, 0.12)), distance_box(beside, vec3(0.6, 0.35, 0.0), vec3(0.1, 0.35, 0.12)));"
operator repeat_random "vec3 spacing = vec3(0.45, 0.0, 0.45); float d = repeat_reach(spacing);
    for (int i = 0; i < 4; i++) {
        vec3 random = repeat_random(repeat_index(p, spacing, vec3(3.0, 0.0, 3.0), i), 1u); vec3 q = repeat_cell(p, spacing, vec3(3.0, 0.0, 3.0), i);
        d = min(d, distance_cylinder(q, vec3(0.0), vec3(0.0, 0.2 + 0.7 * random.y, 0.0), 0.08 + 0.1 * random.x));
    }
    return d;"
operator mirror "return distance_cone(op_mirror(p, vec3(1.0, 0.0, 0.0), 0.0), vec3(0.2, 0.2, 0.0), vec3(0.8, 0.9, 0.0), 0.2);"
for edge in chamfer "stairs 4.0" "columns 3.0"; do
    number=${edge#"${edge%% *}"}
    for kind in union intersection subtraction; do
        post "${edge%% *}_$kind" "0.25${number:+,$number}"
    done
done
post pipe 0.08
post engrave 0.08
post groove "0.1, 0.06"
post tongue "0.1, 0.06"
operator twist "return distance_box(op_twist(p, 1.5), vec3(0.0, 0.6, 0.0), vec3(0.3, 0.6, 0.3)) / op_twist_steepness(1.5, 1.0);"
operator bend "vec3 q = op_translate(p, vec3(0.0, 0.25, 0.0)); return distance_box(op_bend(q, 1.2), vec3(0.0), vec3(0.75, 0.12, 0.3)) / op_bend_steepness(1.2, 1.25);"
operator taper "return distance_box(op_taper(p, 0.0, 1.0, 0.4), vec3(0.0, 0.5, 0.0), vec3(0.5)) / op_taper_steepness(0.0, 1.0, 0.4, 1.0);"
operator displace "return op_displace(distance_sphere(p, vec3(0.0, 0.55, 0.0), 0.5), 0.05 * sin(12.0 * p.x) * sin(12.0 * p.y) * sin(12.0 * p.z), 0.6);"
operator noise "return op_noise(distance_sphere(p, vec3(0.0, 0.5, 0.0), 0.45), p, 0.25, 0.2);"
operator noise_octaves "return op_noise_octaves(distance_sphere(p, vec3(0.0, 0.5, 0.0), 0.45), p, 0.25, 0.4, 4);"
operator warp "return distance_box(op_warp(p, 0.1, 0.35), vec3(0.0, 0.5, 0.0), vec3(0.5, 0.4, 0.5)) / op_warp_steepness(0.1, 0.35);"
operator extrude "return op_extrude(distance_star(flat_p, vec2(0.0), 0.6, 0.27, 5.0), p.z, 0.3);"
operator revolve "return distance_star(op_revolve(p, vec3(0.0, 0.3, 0.0), vec3(0.0, 1.0, 0.0)), vec2(0.42, 0.0), 0.28, 0.12, 5.0);"
finish
