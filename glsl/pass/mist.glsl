// The scene's mist: what its annotation says, where it is, how it turns light, and how dense it is.
#include "mist/values.glsl"
#include <mist-values>
#include <mist-region>
#include <mist-phase>
#include <mist-density>
