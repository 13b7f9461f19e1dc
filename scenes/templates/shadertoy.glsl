// A picture that paints itself, as on Shadertoy. See it with `magichour view FILE`, and leave that window open: each time this file is saved, the picture
// changes. mainImage() is called for each pixel, in each frame.
//
// There are iResolution (the picture's size in pixels), iTime (seconds), iFrame, iMouse (the place in pixels while the left button is down) and iChannel0
// (the frame before). `magichour render FILE -o picture.png` draws iTime 0, and --set time=2 another moment.

// A uniform with an annotation is a slider in the window.
uniform float waves;  //@ slider 12  min 1  max 40  label "number of rings"

void mainImage(out vec4 color, in vec2 pixel) {
    vec2 middle = iMouse.z > 0.0 ? iMouse.xy : 0.5 * iResolution.xy;
    vec2 at = (pixel - middle) / iResolution.y;
    float ring = 0.5 + 0.5 * cos(waves * length(at) * 6.2832 - 2.0 * iTime);
    vec3 warm = vec3(1.0, 0.75, 0.45);
    vec3 cold = vec3(0.10, 0.16, 0.35);
    color = vec4(mix(cold, warm, ring * exp(-2.0 * length(at))), 1.0);
}
