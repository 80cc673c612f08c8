/* test_memory_names.c - names for labels read with each allocation failing in turn: a status, no crash, no leak. */
#include <stdio.h>
#include <unistd.h>

#include "cli/lists.h"
#include "memory.h"
#include "temporary.h"
#include "testing.h"

enum { NAMES = 2000 /* text and list grow several times */ };

static void reading_survives(void **state)
{
    (void)state;
    const size_t before = memory_blocks;
    size_t failures = 0;
    assert_int_equal(chdir(temporary), 0);
    FILE *file = fopen("names.csv", "w");
    assert_non_null(file);
    for (int i = NAMES; i-- > 0;)
        fprintf(file, "vertex,%d,name of vertex %d\n", i, i);
    assert_int_equal(fclose(file), 0);
    for (size_t n = 1;; n++) {
        name_list names = {0};
        roberts_error error = {0};
        memory_fail(n);
        const roberts_status status = names_read(&names, "names.csv", &error);
        const bool failed = memory_failed();
        memory_fail(0);
        if (!failed) {
            assert_int_equal(status, ROBERTS_OK);
            assert_int_equal(names.count, NAMES);
        } else {
            assert_int_equal(status, ROBERTS_NO_MEMORY);
            assert_string_equal(error.message, "not enough memory");
            assert_string_equal(error.file, "names.csv");
            failures++;
        }
        names_free(&names);
        assert_int_equal(memory_blocks, before);
        if (!failed)
            break;
    }
    assert_true(failures >= 8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(reading_survives, temporary_make, temporary_remove)};
    return cmocka_run_group_tests_name("memory, names", tests, NULL, NULL);
}
