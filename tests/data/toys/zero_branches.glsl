// expect 10 20: 0 153 51
#define FANCY 1
#if FANCY
float shade(float x) {
#else
float shade(vec2 x) {
#endif
    float y;
    return y + x;
}
void mainImage(out vec4 O, in vec2 I) {
    float kept;
    switch (int(I.x) - 10) {
    case 0:
        float chosen;
        kept = chosen;
        break;
    default:
        kept = 1.0;
    }
    O = vec4(kept, shade(0.6), 0.2, 1.0);
}
