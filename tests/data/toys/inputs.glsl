// expect 3 4: 255 255 255
void mainImage(out vec4 o, in vec2 p) {
    bool sizes = iChannelResolution[0].xy == iResolution.xy && iResolution.z == 1.0 && iChannelResolution[1].x == 1.0;
    bool times = iChannelTime[2] == iTime && iFrameRate > 0.0 && iTimeDelta >= 0.0 && iSampleRate == 44100.0;
    bool rest = iMouse == vec4(0.0) && iDate.x >= 2000.0 && iDate.z >= 1.0;
    o = vec4(sizes ? 1.0 : 0.0, times ? 1.0 : 0.0, rest ? 1.0 : 0.0, 1.0);
}
