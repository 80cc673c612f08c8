#!/bin/sh
# Runs test programs, several at a time, continues after a failure, and fails at the end: tests/run.sh PROGRAM...
#
# A program's output goes to PROGRAM.out and PROGRAM.err and is shown if the program fails. Lines that start with
# "note: " are always shown, and so is each skipped test with its reason (support/testing.h). Each line gives the number
# of tests that cmocka reported (on standard output; its final listings are on standard error). The last line is their
# sum, which is also appended to the file TEST_RESULTS. A program that dies, or ends without having run a test, counts
# as one failure, and so does one that leaves a temporary folder (support/temporary.h).
#
# JOBS: how many programs run at a time (default: one more than there are processors, as some of them wait)
set -u

# Tests run make themselves. They inherit the variables of this make, but not its job server, which they cannot use.
MAKEFLAGS=$(printf '%s' "${MAKEFLAGS:-}" | sed 's/--jobserver-[a-z]*=[^ ]*//g; s/-j[0-9]*//g')
export MAKEFLAGS

# count WORD PROGRAM: prints how many of its tests a program reported with this word
count() {
    grep -c "^\[ *$1 *\] " "$2.out"
}

# Runs one program with a temporary folder of its own, writes its three counts to PROGRAM.counts, and reports.
run_one() {
    program=$1
    TMPDIR=$(mktemp -d) || exit 1
    export TMPDIR
    trap 'rm -rf "$TMPDIR"' EXIT
    trap 'exit 1' HUP INT TERM
    "$program" >"$program.out" 2>"$program.err" </dev/null
    status=$?
    good=$(count OK "$program") bad=$(count FAILED "$program") out=$(count SKIPPED "$program")
    if [ "$bad" -eq 0 ] && { [ "$status" -ne 0 ] || [ $((good + out)) -eq 0 ]; }; then
        bad=1
    fi
    left=$(cd "$TMPDIR" && ls -d roberts-* 2>/dev/null)
    if [ -n "$left" ]; then
        echo "left in TMPDIR:" $left >>"$program.err"
        [ "$bad" -ne 0 ] || bad=1
    fi
    echo "$good $bad $out" >"$program.counts"
    skips=$([ "$out" -eq 0 ] || echo ", $out skipped")
    { # in one piece, so that programs that end at the same time do not mix their lines
        if [ "$bad" -ne 0 ]; then
            echo "FAILED  $program: $good passed, $bad failed (exit status $status)"
            sed 's/^/    /' "$program.out" "$program.err"
        elif [ "$good" -eq 0 ]; then
            echo "skipped $program: none passed$skips"
        else
            echo "ok      $program: $good passed$skips"
        fi
        [ "$bad" -ne 0 ] || awk '
            /^skipped: / { reason = ": " substr($0, 10) }
            /^note: / { print "        " substr($0, 7) }
            /^\[  SKIPPED \] / { print "        skipped: " substr($0, 14) reason }
            /^\[ RUN / { reason = "" }' "$program.out"
    } >"$program.report"
    cat "$program.report"
}

if [ "${1:-}" = --one ]; then
    run_one "$2"
    exit 0
fi

for program in "$@"; do
    rm -f "$program.counts"
done
printf '%s\0' "$@" | xargs -0 -n 1 -P "${JOBS:-$(($(nproc 2>/dev/null || echo 1) + 1))}" "$0" --one

passed=0 failed=0 skipped=0
for program in "$@"; do
    good=0 bad=1 out=0
    [ ! -f "$program.counts" ] || read -r good bad out <"$program.counts"
    passed=$((passed + good)) failed=$((failed + bad)) skipped=$((skipped + out))
done
echo
echo "$passed passed, $failed failed, $skipped skipped"
[ -z "${TEST_RESULTS:-}" ] || echo "$passed $failed $skipped" >>"$TEST_RESULTS"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
