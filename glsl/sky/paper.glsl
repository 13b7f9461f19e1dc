// The paper's sums for single scattering (Simmons 2017, after Nishita 1993). There are N uniform steps along the view ray. For each of them there are
// M uniform steps back to the eye and M toward the sun. Each step is evaluated at its middle.
#include "sky/sums.glsl"

float absorber_density(Atmosphere a, float h);
// What the columns of air and aerosols between the eye and a point count.
vec2 view_column(vec2 column);

SkySums sky_paper(Atmosphere a, float h, vec3 view, vec3 sun, int view_samples, int light_samples) {
    float r = a.planet_radius_m + h;
    float b = r * view.y;
    Segment segment = atmosphere_segment(a, h, b);
    float view_step = (segment.end - segment.begin) / float(view_samples);
    float nu = dot(view, sun);
    SkySums sums = SkySums(vec3(0.0), vec3(0.0));
    int i = 0;
    do {
        float t = segment.begin + (float(i) + 0.5) * view_step;
        float h_t = altitude_along(h, r, b, t);
        float r_t = a.planet_radius_m + h_t;
        float b_sun = r * sun.y + t * nu;
        float back_step = (t - segment.begin) / float(light_samples);
        float sun_step = distance_to_top(a, h_t, b_sun) / float(light_samples);
        // Sums of the densities of air and aerosols.
        vec2 back = vec2(0.0);
        vec2 toward_sun = vec2(0.0);
        float absorber = 0.0;
        int j = 0;
        do {
            float middle = float(j) + 0.5;
            float h_back = altitude_along(h, r, b, segment.begin + middle * back_step);
            float h_sun = altitude_along(h_t, r_t, b_sun, middle * sun_step);
            back += densities(a, h_back);
            toward_sun += densities(a, h_sun);
            absorber += back_step * absorber_density(a, h_back) + sun_step * absorber_density(a, h_sun);
            j += 1;
        } while (j < light_samples);
        vec2 column = view_column(back * back_step) + toward_sun * sun_step;
        float length = in_planet_shadow(a, h_t, b_sun) ? 0.0 : view_step;
        sky_sums_add(sums, a, length, densities(a, h_t), column, absorber);
        i += 1;
    } while (i < view_samples);
    return sums;
}
