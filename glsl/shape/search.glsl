// What the searches of a pixel's rays took, such as march()'s: for a pass to read after its rays, and to tell the user.
int search_rays = 0;
int search_steps = 0;
int search_broken = 0; // whose field was no distance, or no number: they may have leapt over something
int search_cut = 0;    // that took all the steps they may
