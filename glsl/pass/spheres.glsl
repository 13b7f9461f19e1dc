// The scene's many spheres, for shape/spheres.glsl, in rows of 4096 texels.
uniform sampler2D spheres_table;
// Entries of one list.
uniform int spheres_count;

vec4 spheres_texel(int i) {
    return texelFetch(spheres_table, ivec2(i & 4095, i >> 12), 0);
}

int spheres_entries() {
    return spheres_count;
}
