//@ title   Knot
//@ look    "a golden trefoil: it mirrors itself and the sky; even highlights along the tube show that no step was too long"
//@ camera  eye 0 2.6 -4.2  target 0 0.95 0  fov 42
//@ sun     elevation 30  azimuth 130
//@ atmosphere earth
//@ size    512 512
//@ bound   0 1 0 1.7
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4
#include "color/checker.glsl"
#include "distance/torus.glsl"
#include "material/matte.glsl"
#include "material/rough_metal.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"

uniform float tube;   //@ slider 0.16  min 0.05  max 0.2  unit m  label "radius of the tube"
uniform float finish; //@ slider 0.25  label "roughness of the gold"

const int GROUND = 0;
const int KNOT = 1;
const vec3 CENTRE = vec3(0.0, 1.0, 0.0);
// The radius of the ring about which the tube winds, and the tube's distance from the ring, in metres.
const float MAJOR = 1.1;
const float MINOR = 0.4;
// How often the tube winds about the ring while it goes round once. After two rounds it meets itself.
const float TURNS = 1.5;
// The width of the space about the fat ring (below) in which the knot's own distance is used, in metres.
const float SPARE = 0.1;

// In a plane through the ring's axis, the tube is two circles. They turn with the azimuth: a metre along a circle about the axis turns them by
// TURNS / radius, and therefore moves them by MINOR * TURNS / radius.
// The distance to the two circles is divided by the steepness at the inner edge of a fat ring that contains the knot. The result is never more
// than the distance inside the fat ring. Elsewhere the distance to the fat ring is used, which is below the distance to the knot.
float scene_distance(vec3 p) {
    vec3 q = p - CENTRE;
    float ring = distance_torus(q, vec3(0.0), vec3(0.0, 1.0, 0.0), MAJOR, MINOR + tube);
    float azimuth = TURNS * atan(q.z, q.x);
    vec2 across = vec2(length(vec2(q.x, q.z)) - MAJOR, q.y);
    float along = abs(cos(azimuth) * across.x + sin(azimuth) * across.y);
    float aside = cos(azimuth) * across.y - sin(azimuth) * across.x;
    float inner = MAJOR - MINOR - tube - SPARE;
    float knot = (length(vec2(along - MINOR, aside)) - tube) / length(vec2(1.0, TURNS * MINOR / inner));
    return max(ring, min(knot, SPARE - ring));
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    march_thinnest = tube;
    march(ray, CENTRE, vec3(MAJOR, 0.0, MAJOR) + MINOR + tube, KNOT, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == KNOT) return rough_metal(gold(), finish);
    return matte(checker(hit.position, vec3(0.55), vec3(0.35)));
}
