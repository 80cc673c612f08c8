/* test_same_bytes.c - the program gives the same bytes whatever the threads and the grid, and however often it is run.
 * The scene has enough solids for seven threads to share. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "folders.h"
#include "rng.h"
#include "temporary.h"
#include "testing.h"
#include "whole_file.h"

enum { SIDE = 56, BOXES = SIDE * SIDE + 1, TRIANGLES = 3000, RUNS = 12 };

static char program[4096], boxes[TEMPORARY_ROOM + 20], triangles[TEMPORARY_ROOM + 20];

/* The table shows everything computed, and the SVG the strokes made of it. Writers know neither threads nor grid, so
 * the other formats are drawn less often. */
static const char *const formats[] = {"csv", "svg", "pdf", "ps", "eps", "png", "tikz", "dxf", "hpgl", "json"};
enum { CSV = 0, SVG = 1 };

/* Boxes of different heights on a square, some of which touch, over a plate so wide that the grid has more cells where
 * the boxes are. */
static void write_boxes(const char *path)
{
    static const int corner[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "OFF\n%d %d 0\n", BOXES * 8, BOXES * 6);
    for (int i = 0; i < SIDE * SIDE * 8; i++) {
        int x = i / 8 % SIDE, y = i / 8 / SIDE;
        fprintf(file, "%d %d %d\n", 3 * x + i % 2 * (2 + (x + y) % 2), 3 * y + i / 2 % 2 * 2,
                i / 4 % 2 * (1 + (x * 7 + y * 5) % 11));
    }
    for (int i = 0; i < 8; i++)
        fprintf(file, "%d %d %d\n", i % 2 ? 4000 : -3000, i / 2 % 2 ? 5000 : -2000, -(i / 4 % 2 ? 1 : 3));
    for (int i = 0; i < BOXES * 6; i++) {
        const int *c = corner[i % 6], first = 8 * (i / 6);
        fprintf(file, "4 %d %d %d %d\n", first + c[0], first + c[1], first + c[2], first + c[3]);
    }
    assert_int_equal(fclose(file), 0);
}

/* Triangles that cross in one place, and one that is far away and wide: where they crowd the grid has more cells. */
static void write_triangles(const char *path)
{
    rng r = {7};
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "OFF\n%d %d 0\n-900 -900 -400\n900 -900 -400\n0 900 -400\n", 3 * TRIANGLES + 3, TRIANGLES + 1);
    for (int i = 0; i < TRIANGLES; i++) {
        const double x = rng_between(&r, 0, 20), y = rng_between(&r, 0, 20), z = rng_between(&r, 0, 20);
        for (int k = 0; k < 3; k++)
            fprintf(file, "%.9g %.9g %.9g\n", x + rng_between(&r, -2, 2), y + rng_between(&r, -2, 2),
                    z + rng_between(&r, -2, 2));
    }
    for (int i = 0; i <= TRIANGLES; i++)
        fprintf(file, "3 %d %d %d\n", 3 * i, 3 * i + 1, 3 * i + 2);
    assert_int_equal(fclose(file), 0);
}

/* The program's output for this model with these options; to be freed. */
static char *draw(const char *model, const char *format, const char *options, size_t *size)
{
    char command[8192];
    snprintf(command, sizeof command, "'%s' '%s' --dir 3,-5,4 -o '%s/out.%s' %s", program, model, temporary, format,
             options);
    int status = system(command);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    snprintf(command, sizeof command, "%s/out.%s", temporary, format);
    char *bytes = whole_file(command, size);
    assert_int_equal(unlink(command), 0);
    return bytes;
}

static void require_same(const char *model, const char *format, const char *options, const char *bytes, size_t size)
{
    size_t other_size;
    char *other = draw(model, format, options, &other_size);
    if (other_size != size || memcmp(bytes, other, size) != 0)
        fail_msg("%s differs with %s", format, options);
    free(other);
}

static void threads_and_grids(void **state)
{
    static const int threads[] = {1, 2, 3, 7}, grids[] = {1, 2, 40};
    char options[64];
    (void)state;
    for (size_t f = 0; f < sizeof formats / sizeof formats[0]; f++) {
        size_t size;
        char *bytes = draw(boxes, formats[f], "--hidden dashed", &size);
        assert_true(size > 1000);
        for (size_t t = 0; t < sizeof threads / sizeof threads[0]; t++)
            for (size_t g = 0; g < sizeof grids / sizeof grids[0]; g++) {
                if ((f > CSV && grids[g] < 40) || (f > SVG && threads[t] != 7))
                    continue;
                snprintf(options, sizeof options, "--hidden dashed --threads %d --grid %d", threads[t], grids[g]);
                require_same(boxes, formats[f], options, bytes, size);
            }
        free(bytes);
    }
}

static void crowds_and_grids(void **state)
{
    static const char *const hidden[] = {"", "--hidden dashed"};
    char options[64];
    (void)state;
    for (int h = 0; h < 2; h++) {
        size_t size;
        char *bytes = draw(triangles, "csv", hidden[h], &size);
        assert_true(size > 100000);
        for (int grid = 1; grid <= 81; grid *= 9) {
            snprintf(options, sizeof options, "%s --grid %d", hidden[h], grid);
            require_same(triangles, "csv", options, bytes, size);
        }
        free(bytes);
    }
}

static void runs(void **state)
{
    (void)state;
    for (size_t f = 0; f < sizeof formats / sizeof formats[0]; f++) {
        size_t size;
        char *bytes = draw("models/city.off", formats[f], "--hidden dashed", &size);
        for (int i = 1; i < (f <= SVG ? RUNS : 3); i++)
            require_same("models/city.off", formats[f], "--hidden dashed", bytes, size);
        free(bytes);
    }
}

static int enter_folder(void **state)
{
    if (temporary_make(state) != 0)
        return -1;
    snprintf(boxes, sizeof boxes, "%s/boxes.off", temporary);
    write_boxes(boxes);
    snprintf(triangles, sizeof triangles, "%s/triangles.off", temporary);
    write_triangles(triangles);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(threads_and_grids), cmocka_unit_test(crowds_and_grids),
                                       cmocka_unit_test(runs)};
    snprintf(program, sizeof program, "%s/roberts", build_folder());
    return cmocka_run_group_tests_name("same_bytes", tests, enter_folder, temporary_remove);
}
