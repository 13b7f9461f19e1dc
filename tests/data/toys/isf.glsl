/*{
    "DESCRIPTION": "a gradient",
    "ISFVSN": "2",
    "INPUTS": [{"NAME": "level", "TYPE": "float", "DEFAULT": 0.5}]
}*/
// refused isf.glsl:1: this is an ISF file
void main() { gl_FragColor = vec4(isf_FragNormCoord, level, 1.0); }
