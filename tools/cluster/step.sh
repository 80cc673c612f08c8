#!/bin/sh
# One step of a drawing in parts, on any machine that sees FOLDER:
#
#   tools/cluster/step.sh plan|part|join N FOLDER OUTPUT MODEL... [-- OPTION...]
#
# plan lays out the models, part draws part $PART (of a Slurm array: its task) of N, join draws OUTPUT from all parts.
# OPTIONs are those of roberts. Each step writes its file whole or not at all, and one that is there already is not
# made again: after a failure, start again. A part that dies is tried three times. ROBERTS names the program.
set -eu

[ $# -ge 5 ] || {
    sed -n '2,8s/^# \{0,1\}//p' "$0" >&2
    exit 2
}
step=$1 count=$2 folder=$3 output=$4
shift 4
models=$#
for word in "$@"; do # the options, then "--", then the models
    [ "$word" != -- ] || models=0
done
roberts=${ROBERTS:-roberts}
plan=$folder/scene.plan

# try FILE COMMAND...: makes FILE, unless it is there
try() {
    made=$1
    shift
    for _ in 1 2 3; do
        [ ! -e "$made" ] || return 0
        "$@" || echo "step.sh: $step: status $?" >&2
    done
    [ -e "$made" ]
}

# Moves the options before the models: only then are they left if the models are taken away.
if [ $models -eq 0 ]; then
    while [ "$1" != -- ]; do
        set -- "$@" "$1"
        models=$((models + 1))
        shift
    done
    shift
fi
case $step in
plan)
    mkdir -p "$folder"
    try "$plan" "$roberts" "$@" --plan -o "$plan"
    ;;
part | join)
    options=$(($# - models)) taken=0
    while [ $taken -lt $# ] && [ $taken -lt $options ]; do # keeps the options, and drops the models behind them
        set -- "$@" "$1"
        shift
        taken=$((taken + 1))
    done
    shift $models
    if [ "$step" = part ]; then
        part=${PART:-$SLURM_ARRAY_TASK_ID}
        try "$folder/part-$part" "$roberts" "$@" --part "$part/$count" "$plan" -o "$folder/part-$part"
    else
        set -- "$@" --join -o "$output"
        for k in $(seq "$count"); do
            set -- "$@" "$folder/part-$k"
        done
        exec "$roberts" "$@"
    fi
    ;;
*)
    echo "step.sh: there is no step $step" >&2
    exit 2
    ;;
esac
