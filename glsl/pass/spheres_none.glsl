// For a scene without many spheres.
vec4 spheres_texel(int i) {
    return vec4(0.0);
}

int spheres_entries() {
    return 0;
}
