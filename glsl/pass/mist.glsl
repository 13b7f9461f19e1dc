// The scene's mist: what its annotation says, where it is, how it turns light, how dense it is, and how light goes through it.
#include "mist/values.glsl"
#include <mist-values>
#include <mist-region>
#include <mist-phase>
#include <mist-density>
#include <mist-tracks>
#include <mist-sky>
