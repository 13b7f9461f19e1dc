#version 330 core
// What a scene's program for Shadertoy has in its tab Common (src/export/toy.h): the scene and all that traces its paths. The host makes constants of
// the uniforms, and moves the scene's parameters to the top.
#include "scene.glsl"
#include "pass/sun.glsl"
#include <sequence>
#include <sky>
#include <inputs>
#include <scene>
#include <spheres>
#include <bounds>
#include <mist>
#include <materials>
#include <sun>
#include <emission>
#include <light>
#include "math/finite.glsl"
#include "pass/camera.glsl"
