// What a path asks of the mist between the surfaces. The files of this folder answer.
// homogeneous.glsl and height.glsl say how dense it is, and closed.glsl and function.glsl how far light comes in it; none.glsl is for scenes without mist.
// The atmosphere's own air between the surfaces is mist too, of coloured extinction (air.glsl).
//
// Mist is told by its extinction, the share of the light that a metre of it takes away. The optical depth of a way is the sum of the
// extinction along it, and the transmittance exp(-depth) is the share of the light that comes through.
#include "scene.glsl"

// The part of a ray that is in the mist.
struct MistWay {
    Ray ray;
    // Where it begins, in metres along the ray, and how long it is in metres.
    float begin;
    float metres;
    float depth;
    // The extinction where it begins, 1/m, and the share of its extinction that the mist loses in a metre along the ray. The second is
    // 0 in mist of one density.
    float extinction;
    float fall;
};

// A place in the mist that stands for all of a way.
struct MistPoint {
    // Metres along the ray.
    float t;
    // The share of the light that the way takes away, over the density of the place.
    vec3 weight;
};

// Where a path goes on: in the mist, or behind it.
struct MistEvent {
    // Metres along the ray; INFINITY if the mist scatters nothing.
    float t;
    // The light that comes from there, over the probability of this choice: 1 where all channels have the same extinction.
    vec3 weight;
};

// Whether the scene has mist. It is a constant, so that a scene without mist is compiled as if there were no such thing.
bool mist_here();

// Gives the mist two new random numbers from [0, 1), of which it makes those that it needs besides. A path calls it before each of its parts, while it is
// alive.
void mist_begin(vec2 numbers);

// The way of a ray's first metres.
MistWay mist_way(Ray ray, float distance);

// The length of the way's beginning that has this depth, which is at most that of the way.
float mist_reached(MistWay way, float depth);

// The share of the light that comes through the way, or an estimate of it whose mean is right.
vec3 mist_kept(MistWay way);

// Draws the place where the way first scatters or absorbs light, for a path of this throughput: of what colours it is. u is in [0, 1).
MistEvent mist_event(MistWay way, vec3 throughput, float u);

// Draws a place of the way with a density in proportion to the light that the place takes away. u is in [0, 1).
MistPoint mist_point(MistWay way, vec3 throughput, float u);

// By how much the scene's own density leaves the range from 0 to 1 at a random place of a ray's first metres; 0 where it does not. u is in [0, 1).
float mist_excess(Ray ray, float distance, float u);
// How much of the light of a ray's first metres comes through only because tracks end before the way does, for one track; 0 where all come to their end.
float mist_overrun(Ray ray, float distance);

// What a path meets there.
Material mist_material(vec3 position);

// Whether the light of the open sky that mist scatters toward the origin of a ray is known, which is a constant; and that light, over the albedo.
bool mist_knows_sky();
// Whether the light method counts on an open sky.
bool mist_in_open();
// The share of this light that may be counted on, from 0 to 1: the narrower the phase function, the coarser is what is known of it.
float mist_sky_share();
vec3 mist_sky(vec3 incoming);

// Whether the mist is the atmosphere's air, which is a constant; and if it is, the sunlight that a metre of it scatters toward the origin of a ray of this direction,
// if nothing stands before the sun; and the direction to the sun.
bool mist_is_air();
vec3 air_sunlight(vec3 position, vec3 incoming);
vec3 air_sun_direction();

// A place in the mist as a hit. It has no normal, so that rays begin exactly there.
Hit mist_hit(Ray ray, float t) {
    return Hit(t, ray.origin + t * ray.direction, vec3(0.0), -1, 0, false);
}
