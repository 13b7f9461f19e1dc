// expect 10 20: 51 0 153
const int COUNT = 4;
float kept[COUNT];
vec2 sums;
void mainImage(out vec4 O, in vec2 I) {
    float heights[COUNT + 1], lows[2] = float[2](0.1, 0.1), highs[3];
    vec3[2] pair;
    if (I.x < 0.0) {
        for (int i = 0; i < COUNT; i++) heights[i] = kept[i] = 1.0, highs[i] = 3.0, pair[1] = vec3(1.0), sums = vec2(1.0);
    }
    float all;
    for (int i = 0; i < COUNT; i++) all += heights[i] + kept[i] + highs[i % 3] + pair[i % 2].y;
    O = vec4(lows[0] + lows[1] + all, sums.y, 0.6, 1.0);
}
