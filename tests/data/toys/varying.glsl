// refused varying.glsl:2: v_texcoord would come from a vertex shader
varying vec2 v_texcoord;
void main() { gl_FragColor = vec4(v_texcoord, 0.0, 1.0); }
