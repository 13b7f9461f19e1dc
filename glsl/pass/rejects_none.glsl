// For a film that does not tell the causes apart (pass/rejects.glsl).
void film_reject(vec3 radiance, bool finite, bool counts) {
}

void film_rejects(bool fits, float samples) {
}
