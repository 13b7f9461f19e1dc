#!/usr/bin/env bash
# Submits all jobs of a list that are not done to Slurm, as one job array: tools/cluster/slurm.sh JOBS [options of sbatch]. A task that is
# killed or whose node fails is queued again and goes on from its checkpoint. The list's last command ("#then: ...") is
# submitted too, to follow when all tasks are done. Prints the numbers of the array and of that job. Run it again to submit what is left.
set -euo pipefail
[ $# -ge 1 ] || { echo "usage: tools/cluster/slurm.sh JOBS [options of sbatch]" >&2; exit 2; }
command -v sbatch >/dev/null || { echo "cluster: Slurm is missing: apt-get install slurm-client" >&2; exit 1; }
jobs=$(realpath "$1")
shift
here=$(realpath "$(dirname "$0")")
mkdir -p "$jobs.d"
left=""
for ((i = 1; i <= $(grep -vc '^#' "$jobs"); i++)); do
    [ -e "$jobs.d/$i.done" ] || left+=${left:+,}$i
done
[ -n "$left" ] || echo "cluster: all jobs are done" >&2
array=""
if [ -n "$left" ]; then
    # Slurm signals the script a minute before a task's time is up, so that it is saved; and it kills what is left.
    array=$(sbatch --parsable --array="$left" --requeue --open-mode=append --signal=B:TERM@60 --output="$jobs.d/%a.log" "$@" <<SCRIPT
#!/usr/bin/env bash
cd $(printf %q "$PWD") || exit 1
trap 'kill -TERM "\$child" 2>/dev/null' TERM
$(printf %q "$here/job.sh") $(printf %q "$jobs") "\$SLURM_ARRAY_TASK_ID" &
child=\$!
wait "\$child"; status=\$?
while kill -0 "\$child" 2>/dev/null; do wait "\$child"; status=\$?; done
# At most twenty times, so that what kills a job each time does not run for ever.
if [ "\$status" = 75 ] && [ "\${SLURM_RESTART_COUNT:-0}" -lt 20 ]; then
    scontrol requeue "\${SLURM_ARRAY_JOB_ID}_\$SLURM_ARRAY_TASK_ID"
    sleep 30
fi
exit "\$status"
SCRIPT
    )
fi
then=$(sed -n 's/^#then: //p' "$jobs")
after=""
if [ -n "$then" ]; then
    after=$(sbatch --parsable ${array:+--dependency=afterok:$array --kill-on-invalid-dep=yes} --output="$jobs.d/then.log" "$@" <<SCRIPT
#!/usr/bin/env bash
cd $(printf %q "$PWD") || exit 1
$then
SCRIPT
    )
fi
echo "$array $after"
