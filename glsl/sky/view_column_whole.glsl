// All light that is scattered on its way to the eye is lost from the ray.
#include "math/dialect.glsl"

vec2 view_column(vec2 column) {
    return column;
}
