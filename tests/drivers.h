/* A picture by Mesa's two software drivers. softpipe shares no code generator with llvmpipe, which is known
 * to compile loops wrongly without a word. */
#pragma once

typedef struct DriversDifference {
    /* Of how many values. A few paths may pass an edge on its other side, and then a pixel differs. */
    int differ, values;
    /* Of the values that do not differ, and of all of them: the sums' difference, relative. */
    double bias_of_same, bias;
    /* By how much a value differs at most, relative to the mean. */
    double worst;
} DriversDifference;

/* Skips the test where there is no softpipe. */
void drivers_need_both(void);

/* Renders the scene by softpipe and by llvmpipe. The picture should be small: softpipe is slow. */
DriversDifference drivers_compare(const char *scene, const char *arguments);
