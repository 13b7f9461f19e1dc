#!/bin/sh
# Runs the test programs of a build folder: tests/run.sh BUILD [fast|slow|all]. All is the default.
# The last line says how many tests passed, failed and were skipped. The exit status is 0 if some passed and none failed.
#
# JOBS=N          programs at the same time; the default is the number of processors. The window's tests run alone, after the others.
# REQUIRE_GL=1    a test that finds no OpenGL fails. Without it, such a test is skipped.
# FEWER_SAMPLES=N the statistical tests take an N-th of their samples; their bounds widen as the measured noise does.
#                 The sanitizers' build (BUILD ends in asan) takes a 64th by default.
set -u

# Statistics of pictures, and what opens many windows: together more than the fast suite may take.
slow="test_bias test_chart test_checkpoint test_cluster test_drivers test_merge test_estimators test_further test_metropolis test_mist_pictures test_noise test_orders_rows test_picture test_portal test_progress test_scenes test_torture test_traced test_web test_web_hands test_window test_window_exposure test_window_load test_window_open test_window_panel test_window_save"
# These wait for events in real time, so they have the processors to themselves.
alone="test_browser test_chart test_web test_web_hands test_window test_window_exposure test_window_load test_window_open test_window_panel test_window_save test_window_toy"
# These see no more under the sanitizers: the pages run in a browser, and test_export writes them.
plain="test_web test_web_hands"
# Seconds that one program may take: at least three times what the slowest of its suite took on two processors.
fast_limit=240 slow_limit=1200 sanitizer_factor=4

among() { case " $2 " in *" $1 "*) ;; *) return 1 ;; esac }

# cmocka's own count of the tests that ended in a way: "[  SKIPPED ] 2 test(s), listed below:".
counted() { sed -n "s/^\[  $1 \] \([0-9]*\) test(s).*/\1/p" "$2" | awk '{ n += $1 } END { print n + 0 }'; }

# Runs one program. Its output is printed in one piece, and its counts go into a file of their own.
run_program() {
    name=$(basename "$1") log=$results/$name.log limit=$fast_limit
    if among "$name" "$slow"; then limit=$slow_limit; fi
    case $1 in */asan/*) limit=$((limit * sanitizer_factor)) ;; esac
    started=$(date +%s%N)
    timeout --kill-after=10 "$limit" "$1" >"$log" 2>&1
    status=$?
    # The leak sanitizer now and then fails to stop the threads of a process that ends, and says so. That is no finding, so the
    # program is run once more without the search for leaks.
    if [ $status != 0 ] && grep -q "LeakSanitizer has encountered a fatal error" "$log"; then
        ASAN_OPTIONS=detect_leaks=0 timeout --kill-after=10 "$limit" "$1" >"$log" 2>&1
        status=$?
    fi
    took=$((($(date +%s%N) - started) / 100000000))
    failures=$(counted "FAILED " "$log")
    if [ "$status" != 0 ] && [ "$failures" = 0 ]; then failures=1; fi
    if [ "$status" = 124 ] || [ "$status" = 137 ]; then echo "$name: stopped after its $limit seconds" >>"$log"; fi
    {
        flock 9
        echo "== $name: $((took / 10)).$((took % 10)) s"
        cat "$log"
    } 9>"$results/lock"
    echo "$(grep -c '^\[       OK' "$log") $failures $(counted SKIPPED "$log")" >"$results/$name.counts"
}

if [ "${1:-}" = --one ]; then
    run_program "$2"
    exit 0
fi

build=${1:-} suite=${2:-all}
case $suite in fast | slow | all) ;; *) build="" ;; esac
if [ -z "$build" ]; then
    echo "usage: tests/run.sh BUILD [fast|slow|all]" >&2
    exit 2
fi
# A display for the backend that needs one. The window's tests bring their own.
if [ -z "${DISPLAY:-}" ] && command -v xvfb-run >/dev/null 2>&1; then exec xvfb-run -a "$0" "$@"; fi
cd "$(dirname "$0")/.." || exit 1
export MAGICHOUR="$PWD/$build/magichour" CMOCKA_MESSAGE_OUTPUT=stdout
export ASAN_OPTIONS=detect_leaks=1 LSAN_OPTIONS="suppressions=$PWD/tests/lsan.supp:print_suppressions=0"
case $build in
# The leak sanitizer breaks down on the thread of Mesa's shader cache, which ends with the process.
*asan) export MESA_SHADER_CACHE_DISABLE=true FEWER_SAMPLES="${FEWER_SAMPLES:-64}" ;;
esac
results=$(mktemp -d)
export results
trap 'rm -rf "$results"' EXIT

# The slow ones start first, so that no processor waits for them at the end.
first="" together="" after=""
for program in "$build"/tests/test_*; do
    if [ ! -x "$program" ] || [ ! -f "$program" ]; then continue; fi
    name=$(basename "$program") of=fast
    case $name in *.o | *.d) continue ;; esac
    if among "$name" "$slow"; then of=slow; fi
    [ "$suite" = all ] || [ "$suite" = "$of" ] || continue
    case $build in *asan) if among "$name" "$plain"; then continue; fi ;; esac
    if among "$name" "$alone"; then
        after="$after $program"
    elif [ $of = slow ]; then
        first="$first $program"
    else
        together="$together $program"
    fi
done
together="$first$together"
# shellcheck disable=SC2086
if [ -n "$together" ]; then printf '%s\n' $together | xargs -n 1 -P "${JOBS:-$(nproc)}" "$0" --one; fi
for program in $after; do run_program "$program"; done
cat "$results"/*.counts 2>/dev/null |
    awk '{ passed += $1; failed += $2; skipped += $3 }
         END { printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped; exit !(passed > 0 && failed == 0) }'
