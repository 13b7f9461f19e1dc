// Counts the searches of a pixel's rays, such as those of march(). A pass adds these numbers to the film, so that the host can warn of failures.
int search_rays = 0;
int search_steps = 0;
// Searches in a field that was no distance, or not a number. They may have stepped over a surface.
int search_broken = 0;
// Searches that took as many steps as they are allowed to.
int search_cut = 0;
