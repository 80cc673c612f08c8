/* test_hull_memory.c - convex hulls with each of Qhull's own allocations failing in turn: no memory, or the hull; no
 * exit, no word on standard error. Only our own allocations fail in test_memory_all.c, which continues to solids. Leaks
 * inside Qhull are counted and reported. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "model/hull.h"
#include "process_memory.h"
#include "testing.h"

enum { POINTS = 1000 };

/* Points of a cube's grid, or of a spiral on a cone. */
static void make_points(roberts_vec3 *point, bool grid)
{
    double x = 1, y = 0, cosine = -0.7373688780783197, sine = 0.6754902942615238; /* the golden angle */
    for (int i = 0; i < POINTS; i++) {
        double turned = x * cosine - y * sine;
        y = x * sine + y * cosine;
        x = turned;
        point[i] = grid ? (roberts_vec3){i % 10 / 9.0, i / 10 % 10 / 9.0, i / 100 / 9.0}
                        : (roberts_vec3){x * (1 - i / 2000.0), y * (1 - i / 2000.0), i / 600.0};
    }
}

static void allocations_fail(const char *name, bool grid, double width)
{
    static roberts_vec3 point[POINTS];
    size_t n = 0, refused = 0;
    long lost = 0;
    hull_facets whole = {0};
    make_points(point, grid);
    assert_int_equal(hull_take(&whole, point, POINTS, width), HULL_OK);
    for (bool failed = true; failed;) {
        hull_facets facets = {0};
        long before = memory.blocks;
        memory.calls = 0;
        memory.failing = ++n;
        hull_result result = hull_take(&facets, point, POINTS, width);
        failed = memory.calls >= memory.failing;
        memory.failing = 0;
        if (result != HULL_OK && result != HULL_NO_MEMORY)
            fail_msg("%s, allocation %zu: result %d", name, n, result);
        refused += result != HULL_OK;
        assert_true(failed || result == HULL_OK);
        assert_true(result != HULL_OK || facets.count == whole.count);
        hull_facets_free(&facets);
        lost += memory.blocks - before;
        if (!failed)
            assert_int_equal(memory.blocks, before);
    }
    hull_facets_free(&whole);
    print_message("%s: %zu allocations, without %zu of them no hull, %ld blocks lost\n", name, n - 1, refused, lost);
    assert_true(n > 10 && refused > 10);
    assert_in_range(lost, 0, 4); /* Qhull gives up on its tables where it gets one of them and not the next */
}

static void hulls(void **state)
{
    char said[64];
    int ends[2], kept = dup(STDERR_FILENO);
    (void)state;
    if (!REPLACED)
        SKIP_BECAUSE("allocations cannot be replaced in this build");
    assert_int_equal(pipe(ends), 0);
    dup2(ends[1], STDERR_FILENO);
    allocations_fail("a grid", true, 1e-6);
    allocations_fail("a grid, by rounding alone", true, 0);
    allocations_fail("a cone", false, 1e-6);
    dup2(kept, STDERR_FILENO);
    close(kept);
    close(ends[1]);
    assert_int_equal(read(ends[0], said, sizeof said), 0);
    close(ends[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(hulls)};
    return cmocka_run_group_tests_name("hull_memory", tests, NULL, NULL);
}
