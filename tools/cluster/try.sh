#!/usr/bin/env bash
# Shows that renders on a cluster lose nothing: a Slurm of one node renders a picture in 8 jobs; two jobs and the controller are killed on
# the way; the merged picture has the same bits as one run. tools/cluster/try.sh [SAMPLES [SCENE [options of render]]]. Needs root.
set -euo pipefail
here=$(dirname "$(realpath "$0")")
magichour=${MAGICHOUR:-$here/../../build/magichour}
samples=${1:-65536} scene=${2:-scenes/crater.glsl}
shift $(($# < 2 ? $# : 2))
options=(--size 128x96 "$@")
folder=$(mktemp -d)
cleanup() {
    "$here/slurm_here.sh" stop "$folder/slurm" || true
    rm -rf "$folder"
}
trap cleanup EXIT
"$here/slurm_here.sh" start "$folder/slurm"
# shellcheck disable=SC1091
. "$folder/slurm/env"

MAGICHOUR=$magichour "$here/ranges.sh" 8 "$samples" "$folder/out" "$scene" "${options[@]}"
# So that there is a checkpoint to go on from, however short the jobs are.
sed -i '/^#/!s/$/ --checkpoint-every 0.05/' "$folder/out/jobs"

# What a controller did not save before it was killed is lost to Slurm, and is submitted again, as a user would.
submit() { [ -n "$(squeue -h 2>/dev/null || echo unknown)" ] || echo "submitted: $("$here/slurm.sh" "$folder/out/jobs")"; }
submit

# Kills the render of a job that has a checkpoint, or its task with all that is in it: no signal that they could answer.
killed=0
kill_one() {
    local state pid task
    for _ in $(seq 1200); do
        [ ! -e "$folder/out/whole.exr" ] || { echo "try: all jobs ended before one could be killed: more samples are needed" >&2 && return 1; }
        submit
        for state in "$folder"/out/jobs.d/*.state; do
            [ -e "$state" ] || continue
            pid=$(pgrep -f "^$magichour render .*--checkpoint $state" | head -n 1) || continue
            task=$(ps -o ppid= -p "$pid" | tr -d ' ')
            [ "$1" = render ] || kill -KILL "$(ps -o ppid= -p "$task" | tr -d ' ')" "$task" 2>/dev/null || continue
            kill -KILL "$pid" 2>/dev/null || continue
            killed=$((killed + 1))
            echo "killed the $1 of job $(basename "$state" .state)"
            return 0
        done
        sleep 0.05
    done
    echo "try: no job could be killed" >&2
    squeue >&2
    sinfo >&2
    tail -n 5 "$folder"/out/jobs.d/*.log "$folder/slurm/log/slurmctld" >&2
    return 1
}
kill_one render
# A controller writes down what it knows every five seconds. One that dies before that takes tasks that are running for strange ones.
sleep 6
"$here/slurm_here.sh" restart-controller "$folder/slurm" && echo "killed the controller, and started it again"
kill_one task
for _ in $(seq 1200); do
    [ ! -e "$folder/out/whole.exr" ] || break
    submit
    sleep 0.25
done
"$magichour" render "$scene" "${options[@]}" --spp "$samples" -o "$folder/one.pfm" --quiet
"$magichour" merge "$folder"/out/part-*.exr -o "$folder/whole.pfm" --quiet
"$magichour" info "$folder/out/whole.exr" | grep -E 'samples|EXR'
cmp "$folder/one.pfm" "$folder/whole.pfm"
[ "$killed" = 2 ]
echo "two jobs and the controller were killed: the same bits as one run"
