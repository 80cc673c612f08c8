#!/bin/sh
# Draws one scene in parts by GNU parallel:
#
#   tools/cluster/parallel.sh N FOLDER OUTPUT MODEL... [-- OPTION...]
#
# FOLDER has to be at the same place on all machines; it keeps the plan and the parts. PARALLEL_OPTIONS are options of
# parallel, such as "--sshloginfile machines" or "-j 2"; without them it uses all processors of this machine. Started
# again after a failure, it draws only what is missing.
set -eu

[ $# -ge 4 ] || {
    sed -n '2,8s/^# \{0,1\}//p' "$0" >&2
    exit 2
}
step=$(dirname "$0")/step.sh
case $step in
/*) ;;
*) step=$PWD/$step ;;
esac
"$step" plan "$@"
# shellcheck disable=SC2086 # several options
seq "$1" | parallel ${PARALLEL_OPTIONS:-} --workdir "$PWD" --quote \
    env "ROBERTS=${ROBERTS:-roberts}" "PART={}" "$step" part "$@"
"$step" join "$@"
