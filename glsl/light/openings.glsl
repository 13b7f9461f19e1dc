// Directions toward the openings that a scene names (`portal`). The file that includes this one first defines const int SCENE_PORTALS
// and mat3 scene_portal(int i), whose columns are the centre and two half edges.
#include "math/rectangle.glsl"

// The portals as a place on a surface sees them.
struct Openings {
    RectangleView views[SCENE_PORTALS + 1];
    // Each portal's share of the directions that are drawn. All are 0 where no portal is seen.
    float shares[SCENE_PORTALS + 1];
};

// The light to expect from a portal, for the choice among several: its solid angle, and 0 for a portal below the surface.
float opening_weight(RectangleView view, vec3 normal) {
    vec2 slope = vec2(dot(view.along, normal), dot(view.up, normal));
    vec2 corner = max(slope * view.low, slope * view.high);
    bool above = corner.x + corner.y - view.depth * dot(view.facing, normal) > 0.0;
    return above ? view.solid_angle : 0.0;
}

Openings openings_seen(vec3 position, vec3 normal) {
    Openings openings;
    float total = 0.0;
    for (int i = 0; i < SCENE_PORTALS; i++) {
        openings.views[i] = rectangle_seen(scene_portal(i), position);
        openings.shares[i] = opening_weight(openings.views[i], normal);
        total += openings.shares[i];
    }
    for (int i = 0; i < SCENE_PORTALS; i++) openings.shares[i] /= max(total, 1.0e-30);
    return openings;
}

// A direction through one of the portals, from u in [0,1)^2. u.x chooses the portal and is then stretched and used again: numbers that
// are evenly spread stay so within each part. Where no portal is seen, the direction is the normal.
vec3 openings_sample(Openings openings, vec3 normal, vec2 u) {
    vec3 direction = normal;
    float passed = 0.0;
    for (int i = 0; i < SCENE_PORTALS; i++) {
        float share = openings.shares[i];
        vec2 rest = vec2(clamp((u.x - passed) / max(share, 1.0e-30), 0.0, 1.0), u.y);
        if (share > 0.0 && u.x >= passed) direction = rectangle_sample(openings.views[i], rest);
        passed += share;
    }
    return direction;
}

// The density of openings_sample(), 1/sr. It is 0 everywhere where no portal is seen.
float openings_pdf(Openings openings, vec3 direction) {
    float density = 0.0;
    for (int i = 0; i < SCENE_PORTALS; i++) {
        if (openings.shares[i] > 0.0) density += openings.shares[i] * rectangle_pdf(openings.views[i], direction);
    }
    return density;
}
