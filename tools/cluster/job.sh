#!/usr/bin/env bash
# Runs one job of a list: tools/cluster/job.sh JOBS NUMBER. The job keeps a checkpoint, and goes on from it if it was interrupted or
# killed before. A render that is killed is started again at once, five times at most. Ends with 0 if the job is done, now or
# before, and with 75 if it was told to end (SIGTERM) or is killed each time, so that it should be run again.
set -uo pipefail
jobs=$1 number=$2
state=$jobs.d/$number
line=$(grep -v '^#' "$jobs" | sed -n "${number}p")
[ -n "$line" ] || { echo "job: $jobs has no job $number" >&2; exit 2; }
mkdir -p "$jobs.d"
[ ! -e "$state.done" ] || exit 0
# A job that the scheduler ends is saved first: the signal goes on to the render.
child="" told=""
trap 'told=yes; [ -z "$child" ] || kill -TERM "$child" 2>/dev/null' TERM INT

for _ in 1 2 3 4 5; do
    eval "exec $line --checkpoint $(printf %q "$state.state") --resume $(printf %q "$state.state") --progress none" &
    child=$!
    wait "$child"
    status=$?
    # A signal ends `wait` before the render has ended.
    while kill -0 "$child" 2>/dev/null; do
        wait "$child"
        status=$?
    done
    case $status in
    # The picture is there; 7 is one whose error is not promised.
    0 | 7) touch "$state.done" && rm -f "$state.state" "$state.state.old" && exit 0 ;;
    # Wrong usage, a fault of the scene and a file that cannot be written do not go away.
    2 | 3 | 5) exit "$status" ;;
    esac
    [ -z "$told" ] || break
done
exit 75
