// The mean radiance that a film of any size has at a pixel of the window; 0 where the film has no sample.
vec3 film_mean(sampler2D film, ivec2 at) {
    vec4 sum = texelFetch(film, at, 0);
    return sum.rgb / max(sum.a, 1.0);
}

vec3 film_radiance(sampler2D film, vec2 pixel, vec2 window) {
    ivec2 size = textureSize(film, 0);
    vec2 at = pixel * vec2(size) / window - 0.5;
    ivec2 low = ivec2(floor(at));
    ivec2 high = min(low + 1, size - 1);
    vec2 part = at - vec2(low);
    low = max(low, 0);
    vec3 top = mix(film_mean(film, low), film_mean(film, ivec2(high.x, low.y)), part.x);
    vec3 bottom = mix(film_mean(film, ivec2(low.x, high.y)), film_mean(film, high), part.x);
    return mix(top, bottom, part.y);
}
