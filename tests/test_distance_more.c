/* The further solids as distance fields: beside the least distance to points of their surfaces, which are
 * said by parameters here and searched in double precision.
 */
#include "solid.h"
#include "support.h"

#include <math.h>
#include <string.h>

static Context context;
static const double PI2 = 6.283185307179586;

/* A frame is the union of its twelve bars, of which each is a box with six faces. */
static const double frame[3] = {0.7, 0.4, 1.0}, frame_bar = 0.2;

static Place frame_at(int patch, double u, double v) {
    int bar = patch / 6, along = bar / 4, face = patch % 6;
    double in_bar[3], at[3];
    in_bar[face / 2] = face % 2, in_bar[(face / 2 + 1) % 3] = u, in_bar[(face / 2 + 2) % 3] = v;
    for (int k = 0; k < 3; k++) {
        int c = (along + k) % 3;
        double inner = frame[c] - frame_bar, side = k && (bar >> (k - 1)) & 1 ? -1 : 1;
        at[c] =
            k ? side * place_mixed(inner, frame[c], in_bar[c]) : place_mixed(-frame[c], frame[c], in_bar[c]);
    }
    return (Place){at[0], at[1], at[2]};
}

static bool frame_has(Place p) {
    double q[3] = {fabs(p.x), fabs(p.y), fabs(p.z)};
    int bars = 0;
    for (int c = 0; c < 3; c++) {
        if (q[c] > frame[c]) return false;
        bars += q[c] > frame[c] - frame_bar;
    }
    return bars >= 2;
}

static Place ring_part_at(int patch, double u, double v) {
    double angle = patch == 0   ? place_mixed(-2.2, 2.2, u)
                   : patch == 1 ? -2.2
                                : 2.2,
           way = patch == 1 ? -1 : 1;
    Place at = {0.8 * cos(angle), 0, 0.8 * sin(angle)}, along = {-way * sin(angle), 0, way * cos(angle)};
    return patch == 0 ? place_tube(at, along, 0.2, v) : place_tube_end(at, along, 0.2, u, v);
}

static bool ring_part_has(Place p) {
    double angle = fmax(-2.2, fmin(atan2(p.z, p.x), 2.2));
    return place_distance2(p, (Place){0.8 * cos(angle), 0, 0.8 * sin(angle)}) < 0.2 * 0.2;
}

static Place link_at(int patch, double u, double v) {
    double side = patch % 2 ? -1 : 1, angle = PI2 / 2 * (u - 0.5);
    if (patch < 2) return place_tube((Place){u - 0.5, 0, side * 0.4}, (Place){1, 0, 0}, 0.15, v);
    return place_tube((Place){side * (0.5 + 0.4 * cos(angle)), 0, 0.4 * sin(angle)},
                      (Place){-side * sin(angle), 0, cos(angle)}, 0.15, v);
}

static bool link_has(Place p) {
    double x = fabs(p.x), ring = x < 0.5 ? fabs(p.z) : sqrt((x - 0.5) * (x - 0.5) + p.z * p.z);
    return (ring - 0.4) * (ring - 0.4) + p.y * p.y < 0.15 * 0.15;
}

/* A prism's corners stand around y; patches: its sides, and two ends in fans about the axis. */
static Place prism_at(const double (*corners)[2], int count, int patch, double u, double v) {
    double place = patch < count ? patch + v : fmin(v * count, count - 1e-12), share = place - floor(place);
    int k = (int)place % count, next = (k + 1) % count;
    if (patch < count) k = patch, next = (k + 1) % count, share = v;
    double x = place_mixed(corners[k][0], corners[next][0], share),
           z = place_mixed(corners[k][1], corners[next][1], share);
    if (patch < count) return (Place){x, u - 0.5, z};
    return (Place){u * x, patch == count ? -0.5 : 0.5, u * z};
}

static bool prism_has(const double (*corners)[2], int count, Place p) {
    for (int k = 0; k < count; k++) {
        const double *a = corners[k], *b = corners[(k + 1) % count];
        if ((b[0] - a[0]) * (p.z - a[1]) - (b[1] - a[1]) * (p.x - a[0]) > 0) return false;
    }
    return fabs(p.y) < 0.5;
}

#define H 0.86602540378443865
static const double hexagon[6][2] = {{0, 0.7},  {0.7 * H, 0.35},   {0.7 * H, -0.35},
                                     {0, -0.7}, {-0.7 * H, -0.35}, {-0.7 * H, 0.35}};
static const double triangle[3][2] = {{0, 0.8}, {0.8 * H, -0.4}, {-0.8 * H, -0.4}};
static const double rhombus[4][2] = {{0, 0.4}, {0.9, 0}, {0, -0.4}, {-0.9, 0}};
#define PRISM(corners, count)                                                                                \
    static Place corners##_at(int patch, double u, double v) {                                               \
        return prism_at(corners, count, patch, u, v);                                                        \
    }                                                                                                        \
    static bool corners##_has(Place p) {                                                                     \
        return prism_has(corners, count, p);                                                                 \
    }
PRISM(hexagon, 6)
PRISM(triangle, 3)
PRISM(rhombus, 4)

/* Cut off, with two radii: patches: the side and two ends. */
static Place trunk_at(double r, double s, int patch, double u, double v) {
    if (patch == 0) return place_spun(place_mixed(r, s, u), place_mixed(-0.6, 0.6, u), v);
    return patch == 1 ? place_spun(r * u, -0.6, v) : place_spun(s * u, 0.6, v);
}

static Place capped_at(int patch, double u, double v) {
    return trunk_at(0.7, 0.25, patch, u, v);
}

static bool capped_has(Place p) {
    return fabs(p.y) < 0.6 && place_across(p) < place_mixed(0.7, 0.25, (p.y + 0.6) / 1.2);
}

static Place flared_at(int patch, double u, double v) {
    return trunk_at(0.0, 1.1, patch, u, v);
}

static bool flared_has(Place p) {
    return fabs(p.y) < 0.6 && place_across(p) < place_mixed(0.0, 1.1, (p.y + 0.6) / 1.2);
}

/* The slant touches balls of the radii 0.5 and 0.2, a metre apart, where their normals rise by the sine 0.3.
 */
static Place round_at(int patch, double u, double v) {
    double rise = asin(0.3);
    if (patch == 0)
        return place_spun(place_mixed(0.5, 0.2, u) * cos(rise),
                          place_mixed(-0.5, 0.5, u) + place_mixed(0.5, 0.2, u) * 0.3, v);
    double angle = patch == 1 ? place_mixed(-PI2 / 4, rise, u) : place_mixed(rise, PI2 / 4, u);
    return patch == 1 ? place_spun(0.5 * cos(angle), -0.5 + 0.5 * sin(angle), v)
                      : place_spun(0.2 * cos(angle), 0.5 + 0.2 * sin(angle), v);
}

static bool round_has(Place p) {
    for (int i = 0; i <= 2000; i++) {
        double t = i / 2000.0, r = place_mixed(0.5, 0.2, t);
        if (place_distance2(p, (Place){0, t - 0.5, 0}) < r * r) return true;
    }
    return false;
}

static Place one_ball_at(int patch, double u, double v) {
    (void)patch;
    return place_spun(0.6 * sin(PI2 / 2 * u), -0.2 - 0.6 * cos(PI2 / 2 * u), v);
}

static bool one_ball_has(Place p) {
    return place_distance2(p, (Place){0, -0.2, 0}) < 0.36;
}

static Place slice_at(double half_angle, int patch, double u, double v) {
    double angle = patch ? half_angle * u : half_angle, r = patch ? 1 : u;
    return place_spun(r * sin(angle), r * cos(angle), v);
}

static bool slice_has(double half_angle, double radius, Place p) {
    return atan2(place_across(p), p.y) < half_angle && place_distance2(p, (Place){0, 0, 0}) < radius * radius;
}

static Place narrow_at(int patch, double u, double v) {
    return slice_at(0.6, patch, u, v);
}

static bool narrow_has(Place p) {
    return slice_has(0.6, 1, p);
}

static Place wide_at(int patch, double u, double v) {
    return slice_at(2.2, patch, u, v);
}

static bool wide_has(Place p) {
    return slice_has(2.2, 1, p);
}

static Place cut_at(double height, int patch, double u, double v) {
    double angle = place_mixed(acos(height / 0.8), PI2 / 2, u);
    return patch ? place_spun(u * sqrt(0.64 - height * height), height, v)
                 : place_spun(0.8 * sin(angle), 0.8 * cos(angle), v);
}

static Place cut_high_at(int patch, double u, double v) {
    return cut_at(0.3, patch, u, v);
}

static Place cut_low_at(int patch, double u, double v) {
    return cut_at(-0.5, patch, u, v);
}

static bool cut_high_has(Place p) {
    return p.y < 0.3 && place_distance2(p, (Place){0, 0, 0}) < 0.64;
}

static bool cut_low_has(Place p) {
    return p.y < -0.5 && place_distance2(p, (Place){0, 0, 0}) < 0.64;
}

static Place bowl_at(int patch, double u, double v) {
    double rim = acos(0.3 / 0.8), angle = place_mixed(rim, PI2 / 2, u), r = patch == 1 ? 0.7 : 0.9;
    if (patch < 2) return place_spun(r * sin(angle), r * cos(angle), v);
    double out = 0.1 * cos(PI2 / 2 * u), up = 0.1 * sin(PI2 / 2 * u);
    return place_spun((0.8 + out) * sin(rim) - up * cos(rim), (0.8 + out) * cos(rim) + up * sin(rim), v);
}

static bool bowl_has(Place p) {
    double angle = fmax(atan2(place_across(p), p.y), acos(0.3 / 0.8)), q = place_across(p) - 0.8 * sin(angle);
    return q * q + (p.y - 0.8 * cos(angle)) * (p.y - 0.8 * cos(angle)) < 0.01;
}

/* The arc's circle is 0.8125 past the axis, and its radius 1.2125. */
static Place spindle_at(int patch, double u, double v) {
    double angle = place_mixed(-1, 1, u) * atan2(0.9, 0.8125);
    (void)patch;
    return place_spun(fmax(1.2125 * cos(angle) - 0.8125, 0), 1.2125 * sin(angle), v);
}

static bool spindle_has(Place p) {
    return (place_across(p) + 0.8125) * (place_across(p) + 0.8125) + p.y * p.y < 1.2125 * 1.2125;
}

static Place octahedron_at(int patch, double u, double v) {
    return (Place){0.9 * (patch & 1 ? -u : u), 0.9 * (patch & 2 ? -v : v) * (1 - u),
                   0.9 * (patch & 4 ? -1 : 1) * (1 - u) * (1 - v)};
}

static bool octahedron_has(Place p) {
    return fabs(p.x) + fabs(p.y) + fabs(p.z) < 0.9;
}

static Place pyramid_at(int patch, double u, double v) {
    double w = 0.6 * u, z = place_mixed(-w, w, v), y = 0.9 * (1 - u);
    if (patch == 4) return (Place){place_mixed(-0.6, 0.6, u), 0, place_mixed(-0.6, 0.6, v)};
    return patch < 2 ? (Place){patch ? -w : w, y, z} : (Place){z, y, patch == 2 ? -w : w};
}

static bool pyramid_has(Place p) {
    return p.y > 0 && fmax(fabs(p.x), fabs(p.z)) < 0.6 * (1 - p.y / 0.9);
}

static Place pillar_at(int patch, double u, double v) {
    (void)patch;
    return place_spun(0.4, place_mixed(-8, 8, u), v);
}

static bool pillar_has(Place p) {
    return place_across(p) < 0.4;
}

static Place endless_at(int patch, double u, double v) {
    (void)patch;
    return place_spun(12 * u * u * sin(0.5), 12 * u * u * cos(0.5), v);
}

static bool endless_has(Place p) {
    return slice_has(0.5, 100, p);
}

static Place endless_wide_at(int patch, double u, double v) {
    (void)patch;
    return place_spun(12 * u * u * sin(2.0), 12 * u * u * cos(2.0), v);
}

static bool endless_wide_has(Place p) {
    return slice_has(2.0, 100, p);
}

static Place bezier_middle(const Place *c, double t) {
    return place_moved((Place){0, 0, 0}, (1 - t) * (1 - t), c[0], 2 * t * (1 - t), c[1], t * t, c[2]);
}

static Place bezier_at(const Place *c, int patch, double u, double v) {
    double t = patch == 0 ? u : patch == 1 ? 0 : 1, way = patch == 1 ? -1 : 1;
    Place none = {0, 0, 0}, along = place_moved(none, t - 1, c[0], 1 - 2 * t, c[1], t, c[2]);
    along = place_united(place_moved(none, way, along, 0, none, 0, none));
    return patch ? place_tube_end(bezier_middle(c, t), along, 0.15, u, v)
                 : place_tube(bezier_middle(c, t), along, 0.15, v);
}

static bool bezier_has(const Place *c, Place p) {
    for (int i = 0; i <= 4000; i++) {
        if (place_distance2(p, bezier_middle(c, i / 4000.0)) < 0.15 * 0.15) return true;
    }
    return false;
}

static const Place bent[3] = {{-0.8, -0.2, 0.1}, {0.0, 0.9, -0.3}, {0.8, -0.1, 0.4}};
static const Place straight[3] = {{-0.8, -0.2, 0.1}, {0.0, -0.15, 0.25}, {0.8, -0.1, 0.4}};

static Place bent_at(int patch, double u, double v) {
    return bezier_at(bent, patch, u, v);
}

static bool bent_has(Place p) {
    return bezier_has(bent, p);
}

static Place straight_at(int patch, double u, double v) {
    return bezier_at(straight, patch, u, v);
}

static bool straight_has(Place p) {
    return bezier_has(straight, p);
}

#define ENDS(reach) "s * (C - " reach " * N), s * (C + " reach " * N), "
#define FILE_OF(name) "#include \"distance/" name ".glsl\""
#define CALL(name, words) "distance_" name "(p, " words ")"
static const Solid solids[] = {
    {FILE_OF("box_frame"), "box_frame", CALL("box_frame", "s * C, s * vec3(0.7, 0.4, 1.0), s * 0.2"),
     frame_at, 72, frame_has, false, true},
    {FILE_OF("capped_torus"), "capped_torus", CALL("capped_torus", "s * C, N, E, 2.2, s * 0.8, s * 0.2"),
     ring_part_at, 3, ring_part_has, true, false},
    {FILE_OF("link"), "link", CALL("link", "s * C, N, E, s * 0.5, s * 0.4, s * 0.15"), link_at, 4, link_has,
     true, false},
    {FILE_OF("prism"), "hexagonal_prism", CALL("hexagonal_prism", "s * C, s * 0.7, s * 0.5"), hexagon_at, 8,
     hexagon_has, false, false},
    {FILE_OF("prism"), "triangular_prism", CALL("triangular_prism", "s * C, s * 0.8, s * 0.5"), triangle_at,
     5, triangle_has, false, false},
    {FILE_OF("prism"), "rhombus_prism", CALL("rhombus_prism", "s * C, s * vec2(0.9, 0.4), s * 0.5"),
     rhombus_at, 6, rhombus_has, false, false},
    {FILE_OF("capped_cone"), "capped_cone", CALL("capped_cone", ENDS("0.6") "s * 0.7, s * 0.25"), capped_at,
     3, capped_has, true, false},
    {FILE_OF("capped_cone"), "capped_cone", CALL("capped_cone", ENDS("0.6") "0.0, s * 1.1"), flared_at, 3,
     flared_has, true, false},
    {FILE_OF("round_cone"), "round_cone", CALL("round_cone", ENDS("0.5") "s * 0.5, s * 0.2"), round_at, 3,
     round_has, true, false},
    {FILE_OF("round_cone"), "round_cone", CALL("round_cone", ENDS("0.2") "s * 0.6, s * 0.1"), one_ball_at, 1,
     one_ball_has, true, false},
    {FILE_OF("cut_sphere"), "solid_angle", CALL("solid_angle", "s * C, N, 0.6, s"), narrow_at, 2, narrow_has,
     true, false},
    {FILE_OF("cut_sphere"), "solid_angle", CALL("solid_angle", "s * C, N, 2.2, s"), wide_at, 2, wide_has,
     true, false},
    {FILE_OF("cut_sphere"), "cut_sphere", CALL("cut_sphere", "s * C, N, s * 0.8, s * 0.3"), cut_high_at, 2,
     cut_high_has, true, false},
    {FILE_OF("cut_sphere"), "cut_sphere", CALL("cut_sphere", "s * C, N, s * 0.8, s * -0.5"), cut_low_at, 2,
     cut_low_has, true, false},
    {FILE_OF("cut_sphere"), "cut_hollow_sphere",
     CALL("cut_hollow_sphere", "s * C, N, s * 0.8, s * 0.3, s * 0.2"), bowl_at, 3, bowl_has, true, false},
    {FILE_OF("vesica"), "vesica", CALL("vesica", ENDS("0.9") "s * 0.4"), spindle_at, 1, spindle_has, true,
     false},
    {FILE_OF("octahedron"), "octahedron", CALL("octahedron", "s * C, s * 0.9"), octahedron_at, 8,
     octahedron_has, false, false},
    {FILE_OF("pyramid"), "pyramid", CALL("pyramid", "s * C, s * 0.6, s * 0.9"), pyramid_at, 5, pyramid_has,
     false, false},
    {FILE_OF("infinite"), "infinite_cylinder", CALL("infinite_cylinder", "s * C, N, s * 0.4"), pillar_at, 1,
     pillar_has, true, false},
    {FILE_OF("infinite"), "infinite_cone", CALL("infinite_cone", "s * C, N, 0.5"), endless_at, 1, endless_has,
     true, false},
    {FILE_OF("infinite"), "infinite_cone", CALL("infinite_cone", "s * C, N, 2.0"), endless_wide_at, 1,
     endless_wide_has, true, false},
    {FILE_OF("bezier"), "bezier_tube",
     CALL("bezier_tube", "s * (C + vec3(-0.8, -0.2, 0.1)), s * (C + vec3(0.0, 0.9, -0.3)), s * (C + "
                         "vec3(0.8, -0.1, 0.4)), s * "
                         "0.15"),
     bent_at, 3, bent_has, false, false},
    {FILE_OF("bezier"), "bezier_tube",
     CALL("bezier_tube", "s * (C + vec3(-0.8, -0.2, 0.1)), s * (C + vec3(0.0, -0.15, 0.25)), s * (C + "
                         "vec3(0.8, -0.1, 0.4)), s * "
                         "0.15"),
     straight_at, 3, straight_has, false, false},
};
enum { SOLIDS = sizeof solids / sizeof *solids };

static void test_solids(void **state) {
    (void)state;
    support_open(&context);
    solid_test_exact(&context, solids, SOLIDS, SOLID_ITEMS);
    context_close(&context);
}

static void test_wrong_size(void **state) {
    (void)state;
    support_open(&context);
    solid_test_wrong_size(&context, solids, SOLIDS);
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_solids), cmocka_unit_test(test_wrong_size)};
    return cmocka_run_group_tests_name("distance_more", tests, support_folder, support_clean);
}
