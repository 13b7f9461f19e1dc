// Shadertoy's uniforms.

// Width and height in pixels, and 1.
uniform vec3 iResolution;
// In seconds.
uniform float iTime;
// Seconds since the frame before.
uniform float iTimeDelta;
// Frames a second.
uniform float iFrameRate;
// The first frame is 0.
uniform int iFrame;
// xy is where the button is or was last down. zw is where it was pressed, negative when it is up.
uniform vec4 iMouse;
// Year, month from 0, day, and second of the day.
uniform vec4 iDate;
// It is 44100.
uniform float iSampleRate;
uniform float iChannelTime[4];
uniform vec3 iChannelResolution[4];
// Where in its pixel a sample lies, from the middle, in pixels; z is 0.
uniform vec3 shadertoy_shift;
// How often a loop turns that finds out whether the driver has ended all loops.
uniform int shadertoy_turns;
uniform sampler2D iChannel0;
uniform sampler2D iChannel1;
uniform sampler2D iChannel2;
uniform sampler2D iChannel3;
