// The factors of R, the number of light paths that are expected for each path from the camera (sun/share.glsl). Both kinds of paths compute them by
// these functions. `incoming` comes from the camera's side, and `outgoing` goes to the sun's side. The densities are those of the material, whatever
// the light method draws: R need not be exact for the shares to add up to 1. It is 0 where light goes through a surface that scatters, because light paths
// end there.
#include "light/surface.glsl"

const float BALANCE_LEAST = 1.0e-20;

// Whether a hit on this material throws the sun's light on other surfaces, although rays to the sun are sent from it.
bool balance_counts(Material material) {
    return material_throws(material) > 0.0;
}

// At a hit between two others, or one from which the sun is seen by way of mirrors or glass.
float balance_between(vec3 normal, Material material, vec3 incoming, vec3 outgoing) {
    float back = material_pdf(material, normal, -outgoing, -incoming) * max(dot(outgoing, normal), 0.0);
    return back / max(material_pdf(material, normal, incoming, outgoing) * abs(dot(incoming, normal)), BALANCE_LEAST);
}

// At the first hit, which the camera's rays choose. It is multiplied by the area of the pixel there, seen from the camera.
float balance_first(vec3 normal, Material material, vec3 incoming, vec3 outgoing) {
    float density = material_pdf(material, normal, incoming, outgoing);
    return max(dot(outgoing, normal), 0.0) / max(density * abs(dot(incoming, normal)), BALANCE_LEAST);
}

// At a hit that sends a ray to the sun. Such a ray is uniform in the disk, and so is the direction of a light path.
float balance_end(vec3 normal, Material material, vec3 incoming, vec3 outgoing) {
    float back = material_pdf(material, normal, -outgoing, -incoming) * max(dot(outgoing, normal), 0.0);
    return back / max(abs(dot(incoming, normal)), BALANCE_LEAST);
}
