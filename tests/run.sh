#!/bin/sh
# Runs every test program of a build folder: tests/run.sh BUILD. Ends with how many passed, failed and were skipped.
# Brings its own display, for the backend that needs one.
set -u
build=$1
if [ -z "${DISPLAY:-}" ] && command -v xvfb-run >/dev/null 2>&1; then exec xvfb-run -a "$0" "$@"; fi
cd "$(dirname "$0")/.."
export MAGICHOUR="$PWD/$build/magichour" CMOCKA_MESSAGE_OUTPUT=stdout
export ASAN_OPTIONS=detect_leaks=1 LSAN_OPTIONS="suppressions=$PWD/tests/lsan.supp:print_suppressions=0"

# cmocka's own count of the tests that ended in a way: "[  SKIPPED ] 2 test(s), listed below:".
counted() { sed -n "s/^\[  $1 \] \([0-9]*\) test(s).*/\1/p" "$log" | awk '{ n += $1 } END { print n + 0 }'; }

passed=0 failed=0 skipped=0
log=$(mktemp)
trap 'rm -f "$log"' EXIT
for program in "$build"/tests/test_*; do
    [ -x "$program" ] && [ -f "$program" ] || continue
    case $program in *.o | *.d) continue ;; esac
    # Minutes of statistics of pictures, which say nothing about memory.
    case $program in */asan/tests/test_estimators | */asan/tests/test_scenes) continue ;; esac
    echo "== $(basename "$program")"
    "$program" >"$log" 2>&1
    status=$?
    # The leak sanitizer may break down on the thread of Mesa's shader cache, which ends with the process: then once more, without.
    if [ $status != 0 ] && grep -q "LeakSanitizer has encountered a fatal error" "$log"; then
        MESA_SHADER_CACHE_DISABLE=true "$program" >"$log" 2>&1
        status=$?
    fi
    cat "$log"
    passed=$((passed + $(grep -c '^\[       OK' "$log")))
    skipped=$((skipped + $(counted SKIPPED)))
    failures=$(counted "FAILED ")
    [ "$status" = 0 ] || [ "$failures" -gt 0 ] || failures=1
    failed=$((failed + failures))
done
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ]
