#!/bin/sh
# Runs each fuzz target of a build folder for some seconds: tools/fuzz.sh BUILD SECONDS [SEED]. Called by `make fuzz`. With a seed and an empty
# corpus, the inputs are the same each time, as far as the seconds go. What reaches new code is
# kept in BUILD/corpus, and what crashes in BUILD/crashes. Fails if a target crashed, hung or took too much memory.
set -eu

build=${1:?} seconds=${2:?} seed=${3:-0} failed=0
mkdir -p "$build/crashes"
for program in "$build"/tests/fuzz/fuzz_*; do
    case $program in *.o | *.d) continue ;; esac
    name=$(basename "$program") log=$build/crashes/$(basename "$program").log
    name=${name#fuzz_}
    corpus=$build/corpus/$name
    mkdir -p "$corpus"
    # scenes/ and the pictures of the tests are seeds as they are.
    more=""
    case $name in
    scene) more=scenes ;;
    exr) more=tests/data ;;
    png) more=scenes/gallery ;;
    esac
    : >"$corpus.list"
    for seeds in "tests/fuzz/seeds/$name" $more; do
        [ ! -d "$seeds" ] || find "$seeds" -maxdepth 1 -type f -size -256k | sort >>"$corpus.list"
    done
    paste -sd, "$corpus.list" >"$corpus.seeds"
    status=0
    UBSAN_OPTIONS=print_stacktrace=1 "$program" -max_total_time="$seconds" -seed="$seed" -timeout=10 -rss_limit_mb=1024 -max_len=65536 \
        -print_final_stats=1 -artifact_prefix="$build/crashes/$name-" -seed_inputs=@"$corpus.seeds" "$corpus" >"$log" 2>&1 || status=$?
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    covered=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -n 1)
    echo "$name: ${runs:-0} runs, ${covered:-0} edges covered, status $status"
    if [ "$status" != 0 ]; then
        failed=1
        grep -a "ERROR\|SUMMARY\|runtime error" "$log" | head -n 5 || true
    fi
done
exit $failed
