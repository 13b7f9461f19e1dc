// What a path meets in mist that is there.
#include "mist/air_none.glsl"
#include "mist/material/place_mist.glsl"
#include "mist/values.glsl"

bool mist_here() {
    return true;
}

Material mist_material(vec3 position) {
    return material_new(MATERIAL_PLACE_MIST, mist_albedo());
}
