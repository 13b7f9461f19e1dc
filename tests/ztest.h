/* Statistical tests with a stated rate of false alarms.
 *
 * Each assertion of this file fails by chance, with all being right, with a probability of ZTEST_ALARM at
 * most. Seeds are fixed, so a test that has passed passes again; the rate says what to expect when a change
 * draws other random numbers. The largest of many comparisons shares the rate: by Sidak's correction each of
 * n has 1 - (1 - ZTEST_ALARM)^(1/n). Limits are computed from the noise that was measured, so they hold for
 * many samples as for few. */
#pragma once

#include <stdbool.h>

#define ZTEST_ALARM 1e-3

/* How far a normal number of variance 1 is from 0 at most, and the same for the largest of so many. */
double ztest_limit(long comparisons);

/* The probability that |t| is larger, for Student's t with so many degrees of freedom. */
double ztest_student_tail(double t, double freedom);

/* How many events there are at most where so many are expected (Poisson), in the largest of so many
 * comparisons. */
double ztest_count_limit(double expected, long comparisons);

/* A chi-square as a normal number of variance 1 (Wilson and Hilferty), to be held against ztest_limit(). */
double ztest_chi_square(double chi2, double freedom);

/* Values of two pictures compared one by one: z is their difference over its standard error, which is itself
 * an estimate, so that z is distributed as Student's t. */
typedef struct ZTest {
    /* How many values in a row have the same random numbers (a pixel's three channels) and count as one. */
    int together;
    /* How many such tests share the rate of false alarms; 0 is one. */
    long comparisons;
    long count;
    /* Sums over the values: of z^2, of what it is expected to be, and of its variance. */
    double z2, expected, spread;
    /* Values with |z| > 4, and how many are expected. */
    double far, far_expected;
} ZTest;

void ztest_add(ZTest *test, double difference, double variance, double freedom);

/* Adds what another test has found, of other random numbers. */
void ztest_pool(ZTest *pool, const ZTest *test);

/* The largest difference that ztest_difference() allows. */
double ztest_difference_limit(double variance, long comparisons);

/* Whether the mean of z^2 is what the measured noise makes it. Below, it may be 1 instead of Student's
 * expectation: so it is where the noise of a value comes from one rare event among the seeds. Prints the
 * figures and the limits. */
bool ztest_mean_square(const char *name, const ZTest *test);

/* Whether no more values have |z| > 4 than chance makes. Prints the figures and the limit. */
bool ztest_outliers(const char *name, const ZTest *test);

/* Whether a difference is within its noise; it is the largest of `comparisons`. Prints both, relative to
 * `scale`. */
bool ztest_difference(const char *name, double difference, double variance, double scale, long comparisons);
