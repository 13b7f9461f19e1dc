// For a scene whose rays search by loops.
#include "shape/search.glsl"

// Whether the driver has ended all loops. llvmpipe does so after 65,535 iterations and reports nothing, and a field may have loops
// of its own that nobody counted. The test is a loop of eight turns, of which llvmpipe then grants only one or two. The compiler
// must not be able to compute the number of turns: neither from a uniform in the loop's condition, which it can see through, nor
// from the condition after the loop.
bool loops_ended() {
    int wanted = 8 + min(search_rays, 0);
    int turns = 0;
    float counted = 0.0;
    do {
        turns += 1;
        counted += 1.0;
    } while (turns < wanted);
    return counted < 7.5;
}
