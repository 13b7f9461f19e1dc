# A row of atlas-light.csv, from lines "a b": the values of two pictures of one scene, the second with twice the samples of the first.
#
# The variance of a value is v/n with n samples, so that a - b has v/n + v/(2n). A pixel brighter than 100 holds the sun's own image:
# no surface in its light, which has an irradiance of 20, comes near. These few pixels would decide the figure alone, and are left out.
# A speck is a pixel whose difference is more than 20 times the RMS of the better 99 % of them.
{
    pixel = int((NR - 1) / 3)
    squares[pixel] += ($1 - $2) * ($1 - $2)
    if ($1 > 100 || $2 > 100) bright[pixel] = 1
    light[pixel] += $2
}

END {
    if (NR != 3 * pixels) { print "atlas-light: " row ": " NR " values, not " 3 * pixels >"/dev/stderr"; exit 1 }
    for (p = 0; p < pixels; p++) if (!bright[p]) {
        n++
        mean += light[p] / 3
        sum += squares[p]
        sorted[n] = squares[p]
    }
    # The hundredth part that is worst, by selection.
    most = int(n / 100) > 10 ? int(n / 100) : 10
    rest = sum
    for (i = 1; i <= most; i++) {
        for (j = i + 1; j <= n; j++) if (sorted[j] > sorted[i]) { t = sorted[i]; sorted[i] = sorted[j]; sorted[j] = t }
        rest -= sorted[i]
        if (i <= 10) ten += sorted[i]
    }
    for (i = 1; i <= most; i++) specks += sorted[i] * (n - most) > 400 * rest
    one = 100 * sqrt(sum / (3 * n) * samples / 1.5) / (mean / n)
    printf "%s,%d,%.4g,%.4g,%.3f,%.5f,%.3f,%s\n", row, samples, ns, one, sum ? ten / sum : 0, specks / n, \
        one && estimated != "" ? estimated / (one / sqrt(2 * samples)) : 0, auto
}
