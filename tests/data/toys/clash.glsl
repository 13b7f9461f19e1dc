// expect 10 20: 51 153 255
const float PI = 3.0;
struct Hit { float t; };
struct Ray { vec3 origin; };
#define INFINITY 1e9
float checker(vec2 p) { return 0.6; }
float hash(float x) { return x; }
float march(Ray ray) { return ray.origin.x; }
vec4 shadertoy(vec4 color) { return color; }
void mainImage(out vec4 O, in vec2 I) {
    Ray ray;
    Hit hit = Hit(march(ray));
    O = shadertoy(vec4(0.2 + hit.t, checker(I), PI / 3.0, 1.0));
}
