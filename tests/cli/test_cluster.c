/* test_cluster.c - tools/cluster/ draws a scene in parts by GNU parallel and by Slurm, on this machine, to the same
 * bytes as one run. One part dies and is run again. Slurm also draws many models by the script of models/many.md. Tests
 * of programs that are not installed are skipped. */
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "program.h"
#include "testing.h"

static int shell(const char *command)
{
    int status = system(command);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000;
}

static void require(const char *format, const char *rest)
{
    char command[16384];
    snprintf(command, sizeof command, "set -eu; f='%s'; program='%s'; export ROBERTS=\"$f/roberts\"; %s%s", temporary,
             program, format, rest);
    if (shell(command) != 0)
        fail_msg("%s", command);
}

#define SCENE "models/city.off models/crystals.off"
#define LINES "--hidden dashed --azimuth 30"

/* A program that is killed when it first draws part 2 or shard 2, and the drawing of one run. */
static int begin(void **state)
{
    if (temporary_make(state) != 0)
        return -1;
    require("cat >\"$f/roberts\" <<END\n"
            "#!/bin/sh\n"
            "case \" \\$* \" in *\" --part 2/\"* | *\" --shard 2/\"*) [ -e '$f/died' ] || { : >'$f/died'; kill -KILL "
            "\\$\\$; } ;; esac\n"
            "exec '$program' \"\\$@\"\n"
            "END\n"
            "chmod +x \"$f/roberts\"; ",
            "\"$program\" " LINES " " SCENE " -o \"$f/one.svg\"");
    return 0;
}

static void by_parallel(void **state)
{
    (void)state;
    if (shell("command -v parallel >/dev/null") != 0)
        SKIP_BECAUSE("no GNU parallel (parallel) here");
    require("export PARALLEL_OPTIONS='-j 2 -S :'; ",
            "tools/cluster/parallel.sh 4 \"$f/parts\" \"$f/out.svg\" " SCENE " -- " LINES " 2>\"$f/log\"\n"
            "cmp \"$f/one.svg\" \"$f/out.svg\"; test -e \"$f/died\"; grep -q 'part: status 137' \"$f/log\"");
}

static void skip_without_slurm(void)
{
    if (shell("PATH=$PATH:/usr/sbin; command -v sbatch slurmctld slurmd munged >/dev/null") != 0)
        SKIP_BECAUSE("no Slurm (slurmctld, slurmd, munge) here");
    if (geteuid() != 0)
        SKIP_BECAUSE("only root can start Slurm's daemons");
}

static void by_slurm(void **state)
{
    (void)state;
    skip_without_slurm();
    require(
        "tests/cli/slurm.sh \"$f/slurm\" sh -eu -c '\n",
        "tools/cluster/slurm.sh 4 \"$1/parts\" \"$1/out.svg\" " SCENE " -- " LINES " >\"$1/job\"\n"
        "for _ in $(seq 300); do\n"
        "    [ ! -e \"$1/out.svg\" ] || break\n"
        "    sleep 0.1\n"
        "done' sh \"$f\" >\"$f/log\" 2>&1\n"
        "cmp \"$f/one.svg\" \"$f/out.svg\"; test -e \"$f/died\"; grep -q 'part: status 137' \"$f/parts/log-part-2\"");
}

/* The script is in models/many.md. This machine may have fewer processors and less memory than it requests. The first
 * array loses a task; the second one draws what is missing, and nothing else. */
static void shards_by_slurm(void **state)
{
    (void)state;
    skip_without_slurm();
    require(
        "export PATH=\"$f:$PATH\"; ls -d \"$PWD\"/models/platonic/*.off \"$PWD\"/models/catalan/*.off >\"$f/list\"\n"
        "sed -n '/^```sbatch /,/^```$/{/^```/d;p;}' models/many.md >\"$f/shards.sbatch\"\n"
        "tests/cli/slurm.sh \"$f/slurm\" sh -eu -c '\n",
        "cd \"$1\"\n"
        "for _ in 1 2; do\n"
        "    sbatch --array=1-3 --cpus-per-task=1 --mem=0 shards.sbatch\n"
        "    for _ in $(seq 300); do\n"
        "        squeue --noheader | grep -q . || break\n"
        "        sleep 0.1\n"
        "    done\n"
        "    cat manifest-?.json | wc -l >>rows\n"
        "done' sh \"$f\" >\"$f/log\" 2>&1\n"
        "test -e \"$f/died\"; cd \"$f\"; \"$program\" --batch one --list list; diff -r one drawings\n"
        "all=$(grep -c . list); test $(cat manifest-?.json | grep -c '\"error\":null') = $all\n"
        "test $(sed -n 1p rows) -lt $all; test $(sed -n 2p rows) = $all");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(by_parallel, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(by_slurm, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(shards_by_slurm, begin, temporary_remove),
    };
    if (!program_find())
        return 1;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
