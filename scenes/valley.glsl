//@ title   Valley
//@ look    "a lake between hills: the slopes' shade, their image in the water, clearest where it is seen at a low angle"
//@ camera  eye -1 3.5 -33  target 0.6 4.2 0  fov 50
//@ sun     elevation 20  azimuth 30
//@ atmosphere earth
//@ size    640 480
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4
//@ mist    off  extinction fog  albedo 0.99 0.99 0.99  g 0.7  falloff deep
//@ preset  fog       mist on  air off  sun.elevation 4  sun.azimuth 20  exposure 0.5
//@ air     off
//@ preset  kilometres  air on  mist off  scale 120  camera.eye -120,960,-5400  camera.target 60,420,0  camera.fov 45  sun.elevation 30  sun.azimuth 60
//@ preset  dry       lake 0  sun.elevation 30  sun.azimuth 110
#include "distance/hills.glsl"
#include "material/matte.glsl"
#include "material/rough_metal.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"

uniform bool lake;     //@ checkbox on  label "a lake, or sand"
uniform float wide;    //@ slider 14  min 4  max 20  unit m  label "from the valley's middle to the top of its slopes"
uniform float fog;     //@ slider 0.25  min 0  max 1  unit /m  label "extinction of the fog on the lake"
uniform float deep;    //@ slider 1  min 0.2  max 20  unit m  label "height in which the fog thins to 1/e"
uniform float scale;   //@ slider 1  min 1  max 200  label "how many times the landscape is larger"
uniform float rough;   //@ slider 1  min 0  max 2  label "how high the smaller hills are"

const int GROUND = 0;
const int HILLS = 1;
// The height of the largest hills and the distance between them, in metres.
const float HIGH = 10.0;
const float LONG = 24.0;
// How far the valley's middle is lowered, in metres.
const float DEEP = 8.5;
// Beyond this distance no ground is above 0.
const float FAR = 45.0;

float height(vec2 at) {
    float sum = HIGH * hills(at / LONG + vec2(7.3, 2.1));
    sum += rough * (3.2 * hills(at / 7.5) + 0.35 * hills(at / 2.5));
    float middle = 2.5 * sin(0.11 * at.y);
    float along = DEEP * (1.0 - abs(at.x - middle) / wide);
    float around = (HIGH + 3.55 * rough) * (length(at) / 20.0 - (FAR - 20.0) / 20.0);
    return sum - max(max(along, around), 0.0);
}

// The slope is the sum of the slopes of all heights that are added. A point above the highest hill is at least as far from the ground as from the
// hill's height.
float scene_distance(vec3 at) {
    vec3 p = at / scale;
    float small = rough * (3.2 / 7.5 + 0.35 / 2.5);
    float cut = max(DEEP / wide * length(vec2(1.0, 0.275)), (HIGH + 3.55 * rough) / 20.0);
    float slope = HILLS_SLOPE * (HIGH / LONG + small) + cut;
    float level = (p.y - height(vec2(p.x, p.z))) / length(vec2(1.0, slope));
    return max(level, p.y - HIGH - 3.55 * rough) * scale;
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    march_thinnest = 0.3 * scale;
    march(ray, vec3(0.0, 0.0, 0.0), (FAR + 3.0) * scale, HILLS, hit);
}

// The lake reflects as Fresnel's equations say for water. Below its surface it is dark.
Material scene_material(Hit hit) {
    if (hit.object == GROUND && lake) return rough_metal(vec3(0.02), 0.15);
    vec3 sand = vec3(0.45, 0.38, 0.28);
    vec3 at = hit.position / scale;
    vec3 grass = mix(vec3(0.16, 0.24, 0.09), vec3(0.34, 0.34, 0.2), hills(vec2(at.x, at.z)));
    return matte(mix(sand, grass, smoothstep(0.7, 0.9, hit.normal.y) * smoothstep(0.05, 0.4, at.y)));
}
