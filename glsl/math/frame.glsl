#include "math/dialect.glsl"

// Returns x tangent + y bitangent + z axis, where the three form a frame about the unit vector `axis`.
// The frame is that of Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
vec3 in_frame(vec3 axis, float x, float y, float z) {
    float sign_z = axis.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (sign_z + axis.z);
    float b = axis.x * axis.y * a;
    vec3 tangent = vec3(1.0 + sign_z * axis.x * axis.x * a, sign_z * b, -sign_z * axis.x);
    vec3 bitangent = vec3(b, sign_z + axis.y * axis.y * a, -axis.y);
    return x * tangent + y * bitangent + z * axis;
}
