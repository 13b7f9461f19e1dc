# The directions that the atlas asks about, as rows of `magichour sky --at`. Beside them, into the file `cells`, a line each:
# the direction's place in the chart (x y), the solid angle of its cell and the band of sun elevations that it counts in; and
# into the file `axes` gnuplot's ticks.
#
# Across lies asinh(elevation above the visible horizon / 0.3 degrees), which is linear at the horizon and logarithmic away
# from it; upward the suns of the list below, evenly.

function asinh(v) { return v < 0 ? -asinh(-v) : log(v + sqrt(v * v + 1)) }
function sinh(v) { return (exp(v) - exp(-v)) / 2 }
function sine(degrees) { return sin(degrees * pi / 180) }
function clamp(v, low, high) { return v < low ? low : v > high ? high : v }

function suns_up_to(end, step) {
    for (; sun + step < end + step / 2; suns++) elevation[suns] = sun += step
}

function band(sun) {
    if (sun >= 5) return "day"
    if (sun >= 0 && sun <= 2) return "low"
    if (sun >= -6 && sun <= -2) return "twilight"
    if (sun >= -12 && sun < -6) return "late"
    return "-"
}

# Elevation of the visible horizon from height h: -acos(R / (R + h)), without the cancellation.
function horizon_deg(h) { return -atan2(sqrt(h * (2 * planet_m + h)), planet_m) * 180 / pi }

function view_deg(x, horizon) { return clamp(horizon + linear_deg * sinh(x), -90, 90) }

function column(height, horizon, sun, row, x,    low, high, view, solid_angle, i) {
    low = view_deg(x - step / 2, horizon)
    high = view_deg(x + step / 2, horizon)
    if (high <= low) return
    view = view_deg(x, horizon)
    if (view == -90 || view == 90) view = (low + high) / 2
    solid_angle = sine(high) - sine(low)
    for (i = 1; i <= azimuths; i++) {
        printf "%d,%g,%.9g,%g\n", height, sun, view, azimuth[i]
        printf "%.6g %d %.6g %s\n", x, row, solid_angle, band(sun) >cells
    }
}

function tick(value, place, axis) {
    ticks[axis] = ticks[axis] (ticks[axis] == "" ? "" : ", ") sprintf("'%g' %.6g", value, place)
}

BEGIN {
    pi = atan2(0, -1)
    planet_m = 6360000
    linear_deg = 0.3
    step = 0.1 # of x

    sun = elevation[0] = -18; suns = 1
    suns_up_to(-12, 1); suns_up_to(10, 0.5); suns_up_to(20, 2); suns_up_to(90, 5)
    # Beside the sun's own azimuth and its opposite, some that fall on no table's nodes.
    azimuths = split("0 17 61 113 180", azimuth, " ")
    heights = split("1 10000 100000", height, " ")

    print "height_m,sun_el_deg,view_el_deg,az_deg"
    for (h = 1; h <= heights; h++) {
        horizon = horizon_deg(height[h])
        for (row = 0; row < suns; row++)
            for (i = -66; i < 66; i++) column(height[h], horizon, elevation[row], row, (i + 0.5) * step)
    }

    for (row = 0; row < suns; row++)
        if (index(" -18 -15 -12 -9 -6 -3 0 2 5 10 20 40 60 90 ", " " elevation[row] " ")) tick(elevation[row], row, "y")
    n = split("-90 -30 -10 -3 -1 -0.3 0 0.3 1 3 10 30 90", offset, " ")
    for (i = 1; i <= n; i++) tick(offset[i], asinh(offset[i] / linear_deg), "x")
    printf "set xtics (%s)\nset ytics (%s)\nset yrange [-0.5:%g]\n", ticks["x"], ticks["y"], suns - 0.5 >axes
    # Above the air the sky ends at the limb: where it lies in the chart of the third height.
    limb = -atan2(sqrt((height[3] - 60000) * (2 * planet_m + height[3] + 60000)), planet_m + 60000) * 180 / pi
    printf "limb = %.6g\n", asinh((limb - horizon) / linear_deg) >axes
}
