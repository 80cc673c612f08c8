/* test_memory_order.c - scenes so large that solids scattered in the picture, or behind one another, are hidden in an
 * order other than that of the file: the same drawing as of the same solids in order, or as with hidden lines kept, by
 * any number of threads; and memory that fails. */
#include <stdlib.h>
#include <string.h>

#include "hide/cells.h"
#include "hide/schedule.h"
#include "build_scene.h"
#include "memory.h"
#include "roberts.h"
#include "testing.h"

enum { SIDE = 182, COUNT = SIDE * SIDE, FAILURES = 8, EARLY = 3 };

/* Returns a pseudo-random number between 0 and 1. */
static double anyhow(uint64_t n)
{
    n = (n ^ n >> 30) * 0xbf58476d1ce4e5b9u;
    n = (n ^ n >> 27) * 0x94d049bb133111ebu;
    return (double)(n >> 11) * 0x1p-53;
}

/* Scenes whose solids are scattered, made once: of tetrahedra, and of loose faces. */
static roberts_scene *mixed[2];

static const roberts_camera camera = {.dir = {1, -2, 30}};

/* A loose triangle or quadrilateral, or exactly behind the one of the cell before. */
static void add_loose(roberts_mesh *mesh, uint32_t cell)
{
    static const unsigned char triangle[] = {3, 0, 1, 2, 0}, quadrilateral[] = {4, 0, 1, 2, 3, 0};
    const uint32_t as = cell % 5 == 4 ? cell - 1 : cell;
    const roberts_vec3 at = {as % SIDE + anyhow(3 * as + 1), as / SIDE + anyhow(3 * as + 2), 3.0 * anyhow(3 * as + 3)};
    const roberts_vec3 a = {1.5, 0.1, anyhow(5 * as + 4)}, b = {0.2, 1.4, anyhow(7 * as + 5)};
    const roberts_vec3 first = vec3_add(at, vec3_scale(cell % 5 == 4 ? -0.1 : 0.0, camera.dir));
    const roberts_vec3 second = vec3_add(first, a);
    const roberts_vec3 point[4] = {first, second, vec3_add(second, b), vec3_add(first, b)};
    mesh_solid(mesh, point, 4, as % 3 ? triangle : quadrilateral);
}

/* A meadow of tetrahedra, or of loose faces, that reach over one another, two deep; more where they are `wide`.
 * cell[i]: where the i-th stands, row by row. */
static roberts_scene *make_scene(const uint32_t *cell, double wide, bool loose)
{
    static const unsigned char faces[] = {3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 2, 0, 3, 0};
    roberts_mesh mesh = {0};
    for (uint32_t i = 0; i < COUNT; i++) {
        double x = cell[i] % SIDE + anyhow(3 * cell[i] + 1), y = cell[i] / SIDE + anyhow(3 * cell[i] + 2);
        double z = 3.0 * anyhow(3 * cell[i] + 3);
        const roberts_vec3 point[4] = {
            {x, y, z}, {x + 1.5 * wide, y + 0.1, z}, {x + 0.2, y + 1.4 * wide, z}, {x + 0.5, y + 0.5, z + 1}};
        if (loose)
            add_loose(&mesh, cell[i]);
        else
            mesh_solid(&mesh, point, 4, faces);
    }
    return build_scene(&mesh);
}

/* In order, or (the same on each run) scattered. */
static void fill(uint32_t *cell, bool scattered)
{
    for (uint32_t i = 0; i < COUNT; i++)
        cell[i] = i;
    for (uint32_t i = COUNT - 1; scattered && i > 0; i--) {
        uint32_t k = (uint32_t)(anyhow(i) * (i + 1)), was = cell[i];
        cell[i] = cell[k];
        cell[k] = was;
    }
}

static const roberts_scene *scattered_scene(uint32_t *cell, bool loose)
{
    fill(cell, true);
    if (!mixed[loose])
        mixed[loose] = make_scene(cell, 1.0, loose);
    return mixed[loose];
}

static int free_scattered(void **state)
{
    (void)state;
    roberts_scene_free(mixed[0]);
    roberts_scene_free(mixed[1]);
    return 0;
}

static bool is_worth(const roberts_scene *scene)
{
    hide_fronts fronts;
    seen seen_scene;
    picture_order order;
    double depth;
    assert_int_equal(seen_begin(&seen_scene, scene, &camera, 0.0, NULL), ROBERTS_OK);
    assert_true(hide_fronts_build(&fronts, &seen_scene, &(roberts_hide_options){.threads = 1}, false));
    cells_for_lists(&(cells_boxes){fronts.front_box, fronts.front_count, fronts.low, fronts.high, 0.0}, 0, &depth);
    assert_true(picture_order_init(&order, &fronts, depth));
    bool worth = order.solid != NULL;
    for (uint32_t i = 0; worth && i < order.count; i++)
        assert_true(order.solid[i] < COUNT && order.place[order.solid[i]] == i);
    picture_order_free(&order);
    hide_fronts_free(&fronts);
    seen_end(&seen_scene);
    return worth;
}

/* Rows of edges, which come in the order of solids; those of intersections follow. */
static size_t rows_of_edges(const roberts_drawing *drawing)
{
    size_t count = 0;
    while (count < drawing->count && drawing->segment[count].line != ROBERTS_INTERSECTION)
        count++;
    return count;
}

/* Where the rows of each cell begin, and how many there are. */
static void find_cells(const roberts_drawing *drawing, const uint32_t *cell, size_t *first, size_t *count)
{
    memset(count, 0, COUNT * sizeof *count);
    for (size_t i = rows_of_edges(drawing); i-- > 0;) {
        first[cell[drawing->segment[i].solid]] = i;
        count[cell[drawing->segment[i].solid]]++;
    }
}

static void same_part(const roberts_segment *a, const roberts_segment *b)
{
    assert_int_equal(a->v0 - 4 * a->solid, b->v0 - 4 * b->solid);
    assert_int_equal(a->v1 - 4 * a->solid, b->v1 - 4 * b->solid);
    assert_true(a->t0 == b->t0 && a->t1 == b->t1 && a->p0.x == b->p0.x && a->p1.y == b->p1.y && a->z1 == b->z1);
    assert_int_equal(a->state, b->state);
    assert_int_equal(a->line, b->line);
}

typedef struct kind {
    bool keep_hidden, loose;
} kind;

static void scattered_as_in_order(void **state)
{
    const kind *of = *state;
    uint32_t *cell = calloc(COUNT, sizeof *cell);
    size_t *first = calloc(COUNT, sizeof *first), *count = calloc(COUNT, sizeof *count), next = 0;
    roberts_drawing ordered, drawing;
    roberts_tally tally;
    roberts_hide_options options = roberts_hide_options_default();
    options.keep_hidden = of->keep_hidden;
    fill(cell, false);
    roberts_scene *scene = make_scene(cell, 1.0, of->loose);
    assert_false(is_worth(scene));
    assert_int_equal(roberts_hide(scene, &camera, &options, &ordered, NULL), ROBERTS_OK);
    roberts_scene_free(scene);
    const roberts_scene *other = scattered_scene(cell, of->loose);
    assert_true(is_worth(other));
    for (options.threads = 1; options.threads <= 3; options.threads += 2, next = 0) {
        assert_int_equal(roberts_hide(other, &camera, &options, &drawing, NULL), ROBERTS_OK);
        assert_int_equal(drawing.count, ordered.count);
        /* The tests differ a little from those of the ordered scene: the last bits of an intersection's ends depend on
         * which of its faces comes first. */
        if (options.threads == 1)
            tally = drawing.tally;
        assert_memory_equal(&drawing.tally, &tally, sizeof tally);
        assert_int_equal(drawing.drawn_edges, ordered.drawn_edges);
        assert_true(drawing.count > COUNT);
        for (size_t i = 1, end = rows_of_edges(&drawing); i < end; i++)
            assert_true(drawing.segment[i - 1].solid <= drawing.segment[i].solid);
        find_cells(&drawing, cell, first, count);
        for (uint32_t c = 0; c < COUNT; c++)
            for (size_t k = 0; k < count[c]; k++, next++) {
                uint32_t by = drawing.segment[first[c] + k].by;
                same_part(&drawing.segment[first[c] + k], &ordered.segment[next]);
                assert_int_equal(by == ROBERTS_NONE ? by : cell[by], ordered.segment[next].by);
            }
        assert_int_equal(next, rows_of_edges(&ordered));
        roberts_drawing_free(&drawing);
    }
    roberts_drawing_free(&ordered);
    free(cell);
    free(first);
    free(count);
}

/* In the order of the file, but deep. */
static void deep_as_with_hidden(void **state)
{
    uint32_t *cell = calloc(COUNT, sizeof *cell);
    roberts_hide_options options = {.keep_hidden = true};
    roberts_drawing all, drawing;
    (void)state;
    fill(cell, false);
    roberts_scene *scene = make_scene(cell, 1.5, false);
    assert_true(is_worth(scene));
    assert_int_equal(roberts_hide(scene, &camera, &options, &all, NULL), ROBERTS_OK);
    options.keep_hidden = false;
    for (options.threads = 1; options.threads <= 3; options.threads += 2) {
        size_t next = 0;
        assert_int_equal(roberts_hide(scene, &camera, &options, &drawing, NULL), ROBERTS_OK);
        assert_true(drawing.count > COUNT && drawing.count < all.count);
        for (size_t i = 0; i < all.count; i++)
            if (all.segment[i].state == ROBERTS_VISIBLE) {
                assert_true(next < drawing.count);
                assert_int_equal(drawing.segment[next].solid, all.segment[i].solid);
                same_part(&drawing.segment[next++], &all.segment[i]);
            }
        assert_int_equal(next, drawing.count);
        roberts_drawing_free(&drawing);
    }
    roberts_drawing_free(&all);
    roberts_scene_free(scene);
    free(cell);
}

/* Some of the many allocations: the first ones, and others from the whole run. An array that cannot be made smaller is
 * kept as it is. */
static void memory_fails(void **state)
{
    const kind *of = *state;
    uint32_t *cell = calloc(COUNT, sizeof *cell);
    size_t lost = 0;
    roberts_hide_options options = roberts_hide_options_default();
    options.threads = 1;
    options.keep_hidden = of->keep_hidden;
    const roberts_scene *scene = scattered_scene(cell, of->loose);
    memory_fail(0);
    size_t before = memory_blocks;
    roberts_drawing drawing = drawing_of(scene, &camera, &options);
    size_t calls = memory_calls, whole = drawing.count;
    roberts_drawing_free(&drawing);
    assert_true(calls > 2 * COUNT / KEPT_SOLIDS);
    for (size_t n = 1; n <= FAILURES; n++) {
        memory_fail(n <= EARLY ? 2 * n : calls * (n - EARLY) / (FAILURES - EARLY + 1));
        roberts_status status = roberts_hide(scene, &camera, &options, &drawing, NULL);
        assert_true(memory_failed());
        memory_fail(0);
        assert_true(status == ROBERTS_NO_MEMORY || (status == ROBERTS_OK && drawing.count == whole));
        lost += status == ROBERTS_NO_MEMORY;
        roberts_drawing_free(&drawing);
        assert_int_equal(memory_blocks, before);
    }
    assert_true(lost > FAILURES / 2);
    free(cell);
}

int main(void)
{
    kind solids = {false, false}, all_solids = {true, false}, loose = {false, true}, all_loose = {true, true};
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate(scattered_as_in_order, &solids),
        cmocka_unit_test_prestate(scattered_as_in_order, &all_solids),
        cmocka_unit_test_prestate(scattered_as_in_order, &loose),
        cmocka_unit_test_prestate(scattered_as_in_order, &all_loose),
        cmocka_unit_test(deep_as_with_hidden),
        cmocka_unit_test_prestate(memory_fails, &solids),
        cmocka_unit_test_prestate(memory_fails, &all_solids),
        cmocka_unit_test_prestate(memory_fails, &loose),
    };
    return cmocka_run_group_tests_name("memory_order", tests, NULL, free_scattered);
}
