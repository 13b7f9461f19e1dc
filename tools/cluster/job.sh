#!/usr/bin/env bash
# Runs one job of a list: tools/cluster/job.sh JOBS NUMBER. The job keeps a checkpoint, and goes on from it if it was interrupted or
# killed before. Ends with 0 if the job is done, now or before, and with 75 if it should be run again.
set -uo pipefail
jobs=$1 number=$2
state=$jobs.d/$number
line=$(grep -v '^#' "$jobs" | sed -n "${number}p")
[ -n "$line" ] || { echo "job: $jobs has no job $number" >&2; exit 2; }
mkdir -p "$jobs.d"
[ ! -e "$state.done" ] || exit 0
# The state of a job that the scheduler ends is saved first: the signal goes on to the render.
child=""
trap '[ -z "$child" ] || kill -TERM "$child" 2>/dev/null' TERM INT
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
0 | 7) touch "$state.done" && rm -f "$state.state" "$state.state.old" ;;
# Wrong usage, a fault of the scene and a file that cannot be written do not go away.
2 | 3 | 5) exit "$status" ;;
*) exit 75 ;;
esac
