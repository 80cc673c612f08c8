/* test_batch_memory.c - lists, manifests and batches with each allocation of the process failing in turn: a status, no
 * leak, no crash, no incomplete row. */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/batch.h"
#include "cli/lists.h"
#include "cli/manifest.h"
#include "cli/message.h"
#include "cli/signals.h"
#include "process_memory.h"
#include "temporary.h"
#include "testing.h"

enum { NAMES = 2000 /* text and list grow several times */, FAILURES = 150 /* allocations of a batch that fail */ };

static char long_name[5000]; /* a row grows several times */

static int set_up(void **state)
{
    memset(long_name, 'x', sizeof long_name - 1);
    return temporary_make(state) == 0 ? chdir(temporary) : -1;
}

static void lists_survive(void **state)
{
    size_t failures = 0;
    (void)state;
    if (!REPLACED)
        SKIP_BECAUSE("allocations cannot be replaced in this build");
    FILE *file = fopen("list", "w");
    assert_non_null(file);
    for (int i = 0; i < NAMES; i++)
        fprintf(file, "file %d.off\n", i);
    fclose(file);
    for (size_t n = 1;; n++) {
        file_list list = {0};
        roberts_error error = {0};
        const long before = memory.blocks;
        memory.calls = 0;
        memory.failing = n;
        const roberts_status status = list_read(&list, "list", &error);
        const bool failed = memory.calls >= n;
        memory.failing = 0;
        assert_true(failed || (status == ROBERTS_OK && list.count == NAMES));
        assert_true(status == ROBERTS_OK || strcmp(error.file, "list") == 0);
        failures += status != ROBERTS_OK;
        list_free(&list);
        assert_int_equal(memory.blocks, before);
        if (!failed)
            break;
    }
    assert_true(failures >= 8);
}

/* Adds a row, and queries it. */
static roberts_status add_and_ask(bool *drawn, roberts_error *error)
{
    manifest m;
    manifest_query query = {0};
    const manifest_row row = {.file = long_name, .output = "out", .command = "roberts"};
    roberts_status status = manifest_open(&m, "rows", error);
    if (status != ROBERTS_OK)
        return status;
    status = manifest_add(&m, &row, error);
    if (status == ROBERTS_OK && !manifest_ask(&query, &row))
        status = ROBERTS_NO_MEMORY;
    if (status == ROBERTS_OK)
        status = manifest_answer(&m, &query, 1, error);
    *drawn = query.drawn;
    free(query.begins);
    manifest_close(&m);
    return status;
}

static void manifests_survive(void **state)
{
    size_t failures = 0;
    (void)state;
    if (!REPLACED)
        SKIP_BECAUSE("allocations cannot be replaced in this build");
    for (size_t n = 1;; n++) {
        roberts_error error = {0};
        bool drawn = false, whole = false;
        unlink("rows");
        const long before = memory.blocks;
        memory.calls = 0;
        memory.failing = n;
        const roberts_status status = add_and_ask(&drawn, &error);
        const bool failed = memory.calls >= n;
        memory.failing = 0;
        assert_int_equal(memory.blocks, before);
        assert_true(failed || status == ROBERTS_OK);
        assert_true(status != ROBERTS_OK || drawn);
        failures += status != ROBERTS_OK;
        /* the file holds a whole row, or nothing */
        assert_true(status != ROBERTS_OK || access("rows", F_OK) == 0);
        memory.failing = 0;
        whole = access("rows", F_OK) != 0 || add_and_ask(&drawn, &error) == ROBERTS_OK;
        assert_true(whole && (drawn || access("rows", F_OK) != 0));
        if (!failed)
            break;
    }
    assert_true(failures >= 5);
}

static void batches_survive(void **state)
{
    static char cube[] = "cube.off", other[] = "other.off";
    char *input[] = {cube, other};
    cli_options options = {.input = input, .input_count = 2, .batch = "out", .list = "list", .manifest = "rows"};
    size_t refused = 0;
    (void)state;
    if (!REPLACED)
        SKIP_BECAUSE("allocations cannot be replaced in this build");
    write_text(cube, "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    write_text(other, "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    write_text("list", "third.off\nfourth.off\n");
    options.hide = roberts_hide_options_default();
    options.hide.threads = 2;
    options.draw = roberts_draw_options_default();
    options.draw.temporary = signals_temporary;
    options.update = true;
    roberts_camera_preset("iso", &options.camera);
    int kept = dup(STDERR_FILENO), away = open("/dev/null", O_WRONLY);
    dup2(away, STDERR_FILENO);
    for (size_t n = 1; n <= FAILURES; n++) {
        unlink("rows");
        unlink("out/cube.svg");
        const long before = memory.blocks;
        memory.calls = 0;
        memory.failing = n;
        const int status = batch_make(&options); /* third.off and fourth.off are missing */
        memory.failing = 0;
        assert_int_equal(memory.blocks, before);
        assert_int_equal(status, EXIT_FAILED);
        refused += access("out/cube.svg", F_OK) != 0;
    }
    dup2(kept, STDERR_FILENO);
    close(kept);
    close(away);
    assert_int_equal(batch_make(&options), EXIT_FAILED);
    assert_int_equal(access("out/cube.svg", F_OK) + access("out/other.svg", F_OK), 0);
    assert_true(refused > 10 && refused < FAILURES);
    assert_int_equal(entries("out", true), 2); /* no unfinished file */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(lists_survive, set_up, temporary_remove),
        cmocka_unit_test_setup_teardown(manifests_survive, set_up, temporary_remove),
        cmocka_unit_test_setup_teardown(batches_survive, set_up, temporary_remove),
    };
    return cmocka_run_group_tests_name("memory, batches", tests, NULL, NULL);
}
