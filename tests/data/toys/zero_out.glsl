// expect 10 20: 0 128 255
void half_green(out vec3 color, out float list[3], inout float kept, out highp float last);
void half_green(out vec3 color, out float list[3], inout float kept, out highp float last) {
    if (kept > 0.0) color.g += 128.0 / 255.0;
}
void mainImage(out vec4 O, in vec2 I) {
    vec3 color = vec3(1.0, 1.0, 1.0);
    float list[3] = float[3](1.0, 1.0, 1.0), kept = 1.0, last = 1.0;
    half_green(color, list, kept, last);
    O.rgb += color + vec3(list[0] + list[2], last, kept);
}
