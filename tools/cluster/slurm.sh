#!/bin/sh
# Draws one scene in parts by Slurm: a job for the plan, a job array for the parts, and a dependent job that joins them.
#
#   tools/cluster/slurm.sh N FOLDER OUTPUT MODEL... [-- OPTION...]
#
# Prints the number of the last job. FOLDER has to be at the same place on all machines; it keeps the plan, the parts
# and the logs. PLAN_OPTIONS, PART_OPTIONS and JOIN_OPTIONS are options of sbatch for these jobs, such as "--mem=4G".
# Tasks whose machine fails are queued again.
set -eu

[ $# -ge 4 ] || {
    sed -n '2,8s/^# \{0,1\}//p' "$0" >&2
    exit 2
}
step=$(dirname "$0")/step.sh
mkdir -p "$2"
# submit OPTION... SCRIPT ARGUMENT...: prints the number of the job
submit() {
    sbatch --parsable --requeue --kill-on-invalid-dep=yes --output="$folder/log-%x-%a" "$@"
}
folder=$2
# shellcheck disable=SC2086 # several options
{
    plan=$(submit ${PLAN_OPTIONS:-} --job-name=plan "$step" plan "$@")
    parts=$(submit ${PART_OPTIONS:-} --job-name=part --array="1-$1" --dependency="afterok:$plan" "$step" part "$@")
    submit ${JOIN_OPTIONS:-} --job-name=join --dependency="afterok:$parts" "$step" join "$@"
}
