/* test_memory_parts.c - plans, parts and joining with each allocation of ours failing in turn: a status, no crash, no
 * leak. */
#include <stdio.h>

#include "memory.h"
#include "roberts.h"
#include "temporary.h"
#include "testing.h"

enum { NAME = TEMPORARY_ROOM + 32, PARTS = 2, BLOCKS = 9 };

static char plan[NAME], part[PARTS][NAME], model[NAME];

/* Blocks, each a little aside from the one below it. Their faces are mixed, so that the part has to sort them. */
static void write_blocks(void)
{
    static const int corner[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    FILE *file = fopen(model, "w");
    assert_non_null(file);
    fprintf(file, "OFF\n%d %d 0\n", 8 * BLOCKS, 6 * BLOCKS);
    for (int i = 0; i < 8 * BLOCKS; i++)
        fprintf(file, "%d %d %d\n", i / 8 + i % 2 * 5, i / 8 * 2 + i / 2 % 2 * 4, i / 8 * 3 + i / 4 % 2 * 4);
    for (int i = 0; i < 6 * BLOCKS; i++) {
        const int *c = corner[i / BLOCKS], first = i % BLOCKS * 8;
        fprintf(file, "4 %d %d %d %d\n", first + c[0], first + c[1], first + c[2], first + c[3]);
    }
    assert_int_equal(fclose(file), 0);
}

static roberts_status all_three(const roberts_task *task, roberts_error *error)
{
    char *const models[] = {model}, *const plans[] = {plan}, *const parts[] = {part[0], part[1]};
    roberts_joined joined;
    roberts_status status = roberts_plan_save(&(roberts_inputs){1, models}, task, plan, error);
    for (uint32_t k = 0; k < PARTS && status == ROBERTS_OK; k++)
        status = roberts_part_save(&(roberts_inputs){1, plans}, task, (roberts_share){k + 1, PARTS}, part[k], error);
    if (status == ROBERTS_OK &&
        (status = roberts_join(&(roberts_inputs){PARTS, parts}, task, &joined, error)) == ROBERTS_OK)
        roberts_joined_free(&joined);
    return status;
}

static void parts_survive(void **state)
{
    roberts_task task = {.hide = roberts_hide_options_default()};
    size_t failures = 0;
    (void)state;
    snprintf(plan, sizeof plan, "%s/x.plan", temporary);
    snprintf(model, sizeof model, "%s/x.off", temporary);
    for (int k = 0; k < PARTS; k++)
        snprintf(part[k], sizeof part[k], "%s/part-%d", temporary, k);
    write_blocks();
    roberts_camera_preset("iso", &task.camera);
    task.hide.threads = task.scene.threads = 1;
    const size_t before = memory_blocks;
    for (size_t n = 1;; n++) {
        roberts_error error = {0};
        memory_fail(n);
        roberts_status status = all_three(&task, &error);
        bool failed = memory_failed();
        memory_fail(0);
        if (!failed) {
            assert_int_equal(status, ROBERTS_OK);
            break;
        }
        failures++;
        if (status != ROBERTS_NO_MEMORY && status != ROBERTS_OK)
            fail_msg("allocation %zu: status %d, %s", n, (int)status, error.message);
        if (memory_blocks != before)
            fail_msg("allocation %zu: %zu blocks are left over", n, memory_blocks - before);
    }
    assert_true(failures > 100);
    assert_int_equal(memory_blocks, before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(parts_survive, temporary_make, temporary_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
