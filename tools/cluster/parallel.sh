#!/usr/bin/env bash
# Runs all jobs of a list on this machine by GNU parallel: tools/cluster/parallel.sh JOBS [options of parallel, such as -j 2]. Run it
# again after an interruption: what is done is not done again, and what was begun goes on. When all jobs are done, the list's last
# command ("#then: ...") follows.
set -euo pipefail
[ $# -ge 1 ] || { echo "usage: tools/cluster/parallel.sh JOBS [options of parallel]" >&2; exit 2; }
command -v parallel >/dev/null || { echo "cluster: GNU parallel is missing: apt-get install parallel" >&2; exit 1; }
jobs=$1
shift
count=$(grep -vc '^#' "$jobs")
# A job that ends with 75 was killed, and is run again.
seq "$count" | parallel --will-cite --retries 5 "$@" "$(dirname "$0")/job.sh" "$jobs" {}
eval "$(sed -n 's/^#then: //p' "$jobs")"
