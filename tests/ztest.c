#include "ztest.h"

#include "support.h"

#include <math.h>

/* The number that a normal one of variance 1 exceeds with this probability, by halving. */
static double normal_limit(double tail) {
    double low = 0, high = 40;
    for (int i = 0; i < 100; i++) {
        double middle = 0.5 * (low + high);
        if (0.5 * erfc(middle / sqrt(2)) > tail)
            low = middle;
        else
            high = middle;
    }
    return high;
}

/* 1 - (1 - alarm)^(1/n), without cancellation. */
static double shared_alarm(long comparisons) {
    return -expm1(log1p(-ZTEST_ALARM) / (double)(comparisons > 1 ? comparisons : 1));
}

double ztest_limit(long comparisons) {
    return normal_limit(0.5 * shared_alarm(comparisons));
}

/* The continued fraction of the incomplete beta function, by Lentz's method (Abramowitz and Stegun 26.5.8).
 */
static double beta_fraction(double a, double b, double x) {
    double c = 1, d = 1 / (1 - (a + b) * x / (a + 1)), h = d;
    for (int m = 1; m < 300; m++) {
        double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        d = 1 / (1 + even * d);
        c = 1 + even / c;
        h *= d * c;
        d = 1 / (1 + odd * d);
        c = 1 + odd / c;
        h *= d * c;
        if (fabs(d * c - 1) < 1e-14) break;
    }
    return h;
}

double ztest_student_tail(double t, double freedom) {
    /* From here on it is as good as normal. */
    if (!(freedom < 1e4)) return erfc(t / sqrt(2));
    double a = 0.5 * freedom, b = 0.5, x = freedom / (freedom + t * t);
    double front = exp(lgamma(a + b) - lgamma(a) - lgamma(b) + a * log(x) + b * log1p(-x));
    /* The fraction converges quickly on this side only. */
    if (x < (a + 1) / (a + b + 2)) return front * beta_fraction(a, b, x) / a;
    return 1 - front * beta_fraction(b, a, 1 - x) / b;
}

double ztest_count_limit(double expected, long comparisons) {
    double alarm = shared_alarm(comparisons);
    double term = exp(-expected), sum = term;
    int count = 0;
    /* Where the first term is too small for a double, the normal distribution is close. */
    if (expected > 500) return expected + normal_limit(alarm) * sqrt(expected);
    while (1 - sum > alarm) sum += term *= expected / ++count;
    return count;
}

double ztest_chi_square(double chi2, double freedom) {
    double spread = 2 / (9 * freedom);
    return (cbrt(chi2 / freedom) - (1 - spread)) / sqrt(spread);
}

void ztest_add(ZTest *test, double difference, double variance, double freedom) {
    double z2 = difference * difference / variance, n = fmin(freedom, 1e6);
    test->z2 += z2;
    test->expected += n / (n - 2);
    test->spread += 2 * n * n * (n - 1) / ((n - 2) * (n - 2) * (n - 4));
    test->far += z2 > 16;
    test->far_expected += ztest_student_tail(4, n);
    test->count++;
}

void ztest_pool(ZTest *pool, const ZTest *test) {
    pool->together = test->together;
    pool->count += test->count;
    pool->z2 += test->z2;
    pool->expected += test->expected;
    pool->spread += test->spread;
    pool->far += test->far;
    pool->far_expected += test->far_expected;
}

bool ztest_mean_square(const char *name, const ZTest *test) {
    double n = (double)test->count, mean = test->z2 / n, expected = test->expected / n;
    double margin = ztest_limit(test->comparisons) * sqrt(test->spread * test->together) / n;
    double low = fmin(expected, 1) - margin, high = expected + margin;
    bool ok = mean > low && mean < high;
    print_message("%s: mean z^2 %.3f, expected %.3f, limits %.3f to %.3f%s\n", name, mean, expected, low,
                  high, ok ? "" : ": OUT");
    return ok;
}

bool ztest_outliers(const char *name, const ZTest *test) {
    double limit = test->together * ztest_count_limit(test->far_expected / test->together, test->comparisons);
    bool ok = test->far <= limit;
    print_message("%s: |z| > 4 in %.3f %% of %ld, expected %.3f %%, limit %.3f %%%s\n", name,
                  100 * test->far / (double)test->count, test->count,
                  100 * test->far_expected / (double)test->count, 100 * limit / (double)test->count,
                  ok ? "" : ": OUT");
    return ok;
}

double ztest_difference_limit(double variance, long comparisons) {
    return ztest_limit(comparisons) * sqrt(variance);
}

bool ztest_difference(const char *name, double difference, double variance, double scale, long comparisons) {
    double limit = ztest_difference_limit(variance, comparisons);
    bool ok = fabs(difference) <= limit;
    print_message("%s: means differ by %+.4f %%, limit %.4f %%%s\n", name, 100 * difference / scale,
                  100 * limit / scale, ok ? "" : ": OUT");
    return ok;
}
