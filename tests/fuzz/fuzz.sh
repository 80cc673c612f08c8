#!/bin/sh
# Runs the fuzzers, one after the other: tests/fuzz/fuzz.sh BUILD SECONDS [FUZZER], where FUZZER is fuzz_read, fuzz_stl,
# fuzz_obj, fuzz_ply or fuzz_pipeline (default: all)
#
# Each starts from the small files of models/, from seeds/ and from earlier findings, and continues from the corpus that
# an earlier run has left in BUILD/fuzz/NAME.d/corpus. The output of libFuzzer is in `log` beside it, and failing inputs
# are in `found` beside it. Minimize such an input with -minimize_crash=1 -runs=100000, fix the fault, and put the input
# into tests/fuzz/found/, as read-*, stl-*, obj-*, ply-* or pipeline-*. FUZZ_FLAGS: further arguments for libFuzzer.
set -eu
build=$1 seconds=$2
shift 2
here=$(dirname "$0")

# seed PROGRAM FILE: prints the file; for the pipeline, after the settings of five cameras
seed() {
    name=$(echo "$2" | tr / _)
    case $1 in
    fuzz_read | fuzz_obj) cp "$2" "$folder/seeds/$name" ;;
    fuzz_ply) tail -c +5 "$2" >"$folder/seeds/$name" ;;
    fuzz_stl)
        { printf '\000' && tail -c +85 "$2"; } >"$folder/seeds/0-$name"
        { printf '\001' && cat "$2"; } >"$folder/seeds/1-$name"
        ;;
    fuzz_pipeline)
        i=0
        for settings in '\000\000\000\000\000\000\000\000\000\000\000\000' \
            '\001\012\024\036\001\000\004\003\012\000\000\000' '\002\000\360\001\010\010\003\021\000\000\000\000' \
            '\003\050\024\030\000\000\001\011\001\000\000\000' '\007\004\002\003\001\001\005\023\001\000\010\132'; do
            i=$((i + 1))
            { printf "$settings" && cat "$2"; } >"$folder/seeds/$i-$name"
        done
        ;;
    esac
}

[ $# -gt 0 ] || set -- fuzz_read fuzz_stl fuzz_obj fuzz_ply fuzz_pipeline
for program in "$@"; do
    folder=$build/fuzz/$program.d
    mkdir -p "$folder/corpus" "$folder/seeds" "$folder/found"
    find models "$here/seeds" -type f -size -6k ! -name '*.svg' ! -name '*.md' | sort >"$folder/list"
    while read -r file; do
        seed "$program" "$file"
    done <"$folder/list"
    cp "$here"/found/"${program#fuzz_}"-* "$folder/seeds/" 2>/dev/null || true
    failed=
    "$build/fuzz/$program" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=6144 \
        -print_final_stats=1 -dict="$here/off.dict" -artifact_prefix="$folder/found/" ${FUZZ_FLAGS:-} \
        "$folder/corpus" "$folder/seeds" \
        >"$folder/log" 2>&1 || failed=1
    echo "$program: $(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/log") executions, failed: ${failed:-0}"
    if [ -n "$failed" ]; then
        tail -n 40 "$folder/log"
        exit 1
    fi
done
