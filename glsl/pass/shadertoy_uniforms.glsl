// What Shadertoy tells its programs.
uniform vec3 iResolution;  // pixels, pixels, 1
uniform float iTime;       // seconds
uniform float iTimeDelta;  // since the frame before
uniform float iFrameRate;  // frames a second
uniform int iFrame;        // from 0
uniform vec4 iMouse;       // xy: where the button is or was last down; zw: where it was pressed, negative when it is up
uniform vec4 iDate;        // year, month from 0, day, seconds of the day
uniform float iSampleRate; // 44100
uniform float iChannelTime[4];
uniform vec3 iChannelResolution[4];
uniform sampler2D iChannel0;
uniform sampler2D iChannel1;
uniform sampler2D iChannel2;
uniform sampler2D iChannel3;
