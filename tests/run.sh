#!/bin/sh
# Runs test programs one after the other, goes on after a failure, and fails at the end: tests/run.sh PROGRAM...
#
# A program's output goes to PROGRAM.out and PROGRAM.err and is shown where the program fails; lines that start with
# "note: " are shown in any case. Each line tells how many tests cmocka reported (on standard output; its listings at
# the end are on standard error); the last line is their sum, which also goes to the end of the file that TEST_RESULTS
# names. A program that dies, or stops without having run a test, counts as one failure, and so does one that leaves a
# temporary folder (temporary.h).
set -u

TMPDIR=$(mktemp -d) || exit 1
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT
trap 'exit 1' HUP INT TERM

passed=0 failed=0 skipped=0

# count WORD PROGRAM: how many of its tests a program reported so
count() {
    grep -c "^\[ *$1 *\] " "$2.out"
}

for program in "$@"; do
    "$program" >"$program.out" 2>"$program.err" </dev/null
    status=$?
    good=$(count OK "$program") bad=$(count FAILED "$program") out=$(count SKIPPED "$program")
    if [ "$bad" -eq 0 ] && { [ "$status" -ne 0 ] || [ $((good + out)) -eq 0 ]; }; then
        bad=1
    fi
    left=$(cd "$TMPDIR" && ls -d roberts-* 2>/dev/null)
    if [ -n "$left" ]; then
        echo "left in TMPDIR:" $left >>"$program.err"
        rm -rf "$TMPDIR"/roberts-*
        [ "$bad" -ne 0 ] || bad=1
    fi
    passed=$((passed + good)) failed=$((failed + bad)) skipped=$((skipped + out))
    if [ "$bad" -ne 0 ]; then
        echo "FAILED  $program: $good passed, $bad failed (exit status $status)"
        sed 's/^/    /' "$program.out" "$program.err"
    else
        echo "ok      $program: $good passed"
        sed -n 's/^\[  SKIPPED \] /        skipped: /p; s/^note: /        /p' "$program.out"
    fi
done
echo
echo "$passed passed, $failed failed, $skipped skipped"
[ -z "${TEST_RESULTS:-}" ] || echo "$passed $failed $skipped" >>"$TEST_RESULTS"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
