#version 330 core
// The film's own sum in a picture of --sequence metropolis. The light of the chains is in its second sum, so that here only samples are counted, and the
// sun's own image is added.
#include <sun-image>
#include "pass/film.glsl"
#include <scatter>

uniform uint group_samples;

void main() {
    vec4 group = vec4(sun_image_sum(), float(group_samples));
    film_scatter(group);
    film_add(group, 0.0);
}
