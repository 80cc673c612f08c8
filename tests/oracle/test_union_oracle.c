/* test_union_oracle.c - lines of bodies that are drawn as one: the oracle against cases worked out by hand and against
 * cells of a grid; the judge against tables that are wrong on purpose. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "oracle/mesh_families.h"
#include "oracle/shapes.h"
#include "oracle/union_judge.h"
#include "oracle/voxels.h"
#include "make_mesh.h"
#include "testing.h"

/* ---- by hand ---- */

typedef struct block {
    roberts_vec3 low, high;
} block;

/* Blocks seen from (1, 2, 4). How much is drawn of all places together, as outline and as crease; where several
 * bodies have a line in one place, each counts. */
static const struct {
    const char *name;
    size_t count;
    block block[3];
    double outline, crease;
} hand_cases[] = {
    /* a box of a, b, c: its outline has two edges each way, its creases too, one pair near and one far */
    {"one block", 1, {{{0, 0, 0}, {2, 3, 4}}}, 18, 18},
    {"two blocks that share a side are one", 2, {{{0, 0, 0}, {1, 3, 4}}, {{1, 0, 0}, {2, 3, 4}}}, 18, 18},
    {"a block in a block is gone", 2, {{{0, 0, 0}, {2, 3, 4}}, {{0.5, 1, 1}, {1, 2, 2}}}, 18, 18},
    {"a block in a corner of a block has lines where theirs coincide",
     2,
     {{{0, 0, 0}, {2, 3, 4}}, {{1, 2, 3}, {2, 3, 4}}},
     18,
     18 + 3},
    {"apart", 2, {{{0, 0, 0}, {2, 3, 4}}, {{5, 5, 5}, {7, 8, 9}}}, 36, 36},
    /* Of the upper block's lower edges the near two are creases between its walls and the slab, the far two
     * outlines. For the block alone it is the other way round. */
    {"a block on a slab", 2, {{{0, 0, 0}, {6, 6, 1}}, {{2, 2, 1}, {4, 4, 2}}}, 26 + 6 + 4, 26 + 6 + 4},
    {"three blocks, one of them across the seam of two",
     3,
     {{{0, 0, 0}, {2, 2, 2}}, {{2, 0, 0}, {4, 2, 2}}, {{1, 0, 2}, {3, 2, 4}}},
     8 + 4 + 4 + 6 + 2,
     8 + 4 + 4 + 6 + 2},
};

static void test_by_hand(void **state)
{
    const oracle_view view = {.x = 1, .y = 2, .z = 4};
    (void)state;
    for (size_t i = 0; i < sizeof hand_cases / sizeof hand_cases[0]; i++) {
        roberts_mesh mesh = {0};
        union_truth truth;
        double length[3] = {0};
        for (size_t k = 0; k < hand_cases[i].count; k++)
            mesh_box(&mesh, hand_cases[i].block[k].low, hand_cases[i].block[k].high);
        if (!union_truth_find(&mesh, &view, &truth))
            fail_msg("%s: %s", hand_cases[i].name, truth.error);
        for (size_t k = 0; k < truth.line_count; k++) {
            const union_line *l = &truth.line[k];
            double size = fabs(l->a.x - l->b.x) + fabs(l->a.y - l->b.y) + fabs(l->a.z - l->b.z);
            for (size_t m = l->part; m < l->part + l->parts; m++)
                length[truth.part[m].class_] += (truth.part[m].t1 - truth.part[m].t0) * size;
        }
        if (length[0] != hand_cases[i].outline || length[1] != hand_cases[i].crease || length[2] != 0)
            fail_msg("%s: outline %g, crease %g, else %g", hand_cases[i].name, length[0], length[1], length[2]);
        union_truth_free(&truth);
        roberts_mesh_free(&mesh);
    }
}

/* ---- against cells ---- */

/* The class in which the oracle draws a place; -1: it does not draw it. */
static int class_at(const union_truth *truth, roberts_vec3 X)
{
    for (size_t i = 0; i < truth->line_count; i++) {
        const union_line *l = &truth->line[i];
        double d[3] = {l->b.x - l->a.x, l->b.y - l->a.y, l->b.z - l->a.z};
        double p[3] = {X.x - l->a.x, X.y - l->a.y, X.z - l->a.z};
        double t = (d[0] * p[0] + d[1] * p[1] + d[2] * p[2]) / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        if (fabs(p[0] - t * d[0]) + fabs(p[1] - t * d[1]) + fabs(p[2] - t * d[2]) > 1e-12)
            continue;
        for (size_t k = l->part; k < l->part + l->parts; k++)
            if (truth->part[k].t0 < t && t < truth->part[k].t1)
                return (int)truth->part[k].class_;
    }
    return -1;
}

static size_t family_called(const char *name)
{
    size_t f = 0;
    while (strcmp(mesh_family_name(f), name) != 0)
        f++;
    return f;
}

static void test_cells(void **state)
{
    static const char *const family[] = {"united-blocks", "united-bricks", "united-notched"};
    size_t drawn = 0, not_drawn = 0, classes[3] = {0};
    (void)state;
    for (size_t i = 0; i < 3; i++)
        for (uint64_t seed = 1; seed <= 40; seed++) {
            mesh_scene scene;
            union_truth truth;
            size_t count;
            assert_true(mesh_family_make(family_called(family[i]), seed, &scene));
            if (!union_truth_find(&scene.mesh, &scene.view, &truth))
                fail_msg("%s, seed %d: %s", family[i], (int)seed, truth.error);
            voxel_edge *edge = voxel_edges(&scene.mesh, &scene.view, &count);
            assert_non_null(edge);
            for (size_t k = 0; k < count; k++) {
                const voxel_edge *e = &edge[k];
                roberts_vec3 middle = {(e->a.x + e->b.x) / 2, (e->a.y + e->b.y) / 2, (e->a.z + e->b.z) / 2};
                int found = class_at(&truth, middle), wanted = e->drawn ? (int)e->class_ : -1;
                if (found != wanted)
                    fail_msg("%s, seed %d: at %g %g %g: class %d, not %d", family[i], (int)seed, middle.x, middle.y,
                             middle.z, found, wanted);
                drawn += e->drawn;
                not_drawn += !e->drawn;
                classes[e->class_] += e->drawn;
            }
            free(edge);
            union_truth_free(&truth);
            mesh_scene_free(&scene);
        }
    print_message("note: %zu unit edges drawn (%zu outline, %zu crease), %zu not\n", drawn, classes[0], classes[1],
                  not_drawn);
    assert_true(drawn > 1000 && not_drawn > 1000 && classes[0] > 300 && classes[1] > 300);
}

/* ---- the judge ---- */

typedef bool mutate_fn(union_row *row, size_t *count, size_t i);

static bool drop_row(union_row *row, size_t *count, size_t i)
{
    memmove(row + i, row + i + 1, (*count - i - 1) * sizeof *row);
    --*count;
    return true;
}

static bool shift_end(union_row *row, size_t *count, size_t i)
{
    union_row *r = &row[i];
    (void)count;
    r->q = (roberts_vec3){r->q.x + 1e-6 * (r->q.x - r->p.x), r->q.y + 1e-6 * (r->q.y - r->p.y),
                          r->q.z + 1e-6 * (r->q.z - r->p.z)};
    return true;
}

static bool swap_class(union_row *row, size_t *count, size_t i)
{
    (void)count;
    row[i].line = row[i].line == ROBERTS_OUTLINE ? ROBERTS_CREASE : ROBERTS_OUTLINE;
    return true;
}

static bool swap_state(union_row *row, size_t *count, size_t i)
{
    (void)count;
    row[i].visible = !row[i].visible;
    return true;
}

static bool move_row(union_row *row, size_t *count, size_t i)
{
    (void)count;
    row[i].p.x += 0.25;
    row[i].q.x += 0.25;
    row[i].p.y += 0.125;
    row[i].q.y += 0.125;
    return true;
}

static const struct {
    const char *name;
    mutate_fn *mutate;
} mutations[] = {
    {"a row left out", drop_row},       {"an end off by 1e-6", shift_end},       {"another class", swap_class},
    {"visible for hidden", swap_state}, {"a row that lies elsewhere", move_row},
};

enum { MUTATIONS = sizeof mutations / sizeof mutations[0] };

/* Is the row long, and no other in the same place? Otherwise other rows may make up for a wrong one. */
static bool alone(const union_row *row, size_t count, size_t i)
{
    roberts_vec3 p = row[i].p, d = {row[i].q.x - p.x, row[i].q.y - p.y, row[i].q.z - p.z};
    double l = sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    if (l < 1e-3)
        return false;
    for (size_t k = 0; k < count; k++) {
        double off = 0;
        for (int end = 0; end < 2; end++) {
            roberts_vec3 X = end ? row[k].q : row[k].p, e = {X.x - p.x, X.y - p.y, X.z - p.z};
            off = fmax(off, fabs(d.y * e.z - d.z * e.y) + fabs(d.z * e.x - d.x * e.z) + fabs(d.x * e.y - d.y * e.x));
        }
        if (k != i && off < 1e-3 * l)
            return false;
    }
    return true;
}

/* Is the row one of a line where faces cross, which need not be in the table? */
static bool is_optional(const union_truth *truth, const union_row *row)
{
    for (size_t i = 0; i < truth->line_count; i++) {
        const union_line *l = &truth->line[i];
        const roberts_vec3 d = {l->b.x - l->a.x, l->b.y - l->a.y, l->b.z - l->a.z};
        double off = 0;
        for (int end = 0; end < 2; end++) {
            roberts_vec3 X = end ? row->q : row->p, e = {X.x - l->a.x, X.y - l->a.y, X.z - l->a.z};
            off = fmax(off, fabs(d.y * e.z - d.z * e.y) + fabs(d.z * e.x - d.x * e.z) + fabs(d.x * e.y - d.y * e.x));
        }
        if (off < 1e-9 && l->crossing && (l->edge_on || !row->visible))
            return true;
    }
    return false;
}

static void test_wrong_tables(void **state)
{
    size_t tried[MUTATIONS] = {0}, scenes = 0, asked = 0;
    FILE *quiet = tmpfile();
    (void)state;
    assert_non_null(quiet);
    for (size_t f = family_called("united-blocks"); f < mesh_family_count(); f++)
        for (uint64_t seed = 1; seed <= 10; seed++) {
            mesh_scene scene;
            union_truth truth;
            mesh_total total = {0};
            size_t count;
            assert_true(mesh_family_make(f, seed, &scene));
            if (!union_truth_find(&scene.mesh, &scene.view, &truth))
                fail_msg("%s, seed %d: %s", mesh_family_name(f), (int)seed, truth.error);
            asked += truth.asked;
            union_row *row = union_rows_of_truth(&truth, &count), *wrong = malloc((count + 1) * sizeof *wrong);
            assert_true(row && wrong && count > 0);
            const union_case c = {&scene, &truth, mesh_family_name(f)};
            if (union_judge_rows(&c, row, count, &total, stdout) != 0)
                fail_msg("%s, seed %d: the right table is refused", mesh_family_name(f), (int)seed);
            scenes++;
            for (size_t m = 0; m < MUTATIONS; m++)
                for (uint64_t again = 0; again < 3; again++) {
                    size_t i = (size_t)rng_next(&(rng){seed * 100 + m + 1000 * again}) % count, n = count;
                    memcpy(wrong, row, count * sizeof *row);
                    const roberts_vec3 middle = {(row[i].p.x + row[i].q.x) / 2, (row[i].p.y + row[i].q.y) / 2,
                                                 (row[i].p.z + row[i].q.z) / 2};
                    if (!alone(row, count, i) || is_optional(&truth, &row[i]) || class_at(&truth, middle) == UNION_OPEN)
                        continue;
                    mutations[m].mutate(wrong, &n, i);
                    if (union_judge_rows(&c, wrong, n, &total, quiet) == 0)
                        fail_msg("%s, seed %d: %s at row %zu is not noticed: (%g %g %g) to (%g %g %g)",
                                 mesh_family_name(f), (int)seed, mutations[m].name, i, row[i].p.x, row[i].p.y,
                                 row[i].p.z, row[i].q.x, row[i].q.y, row[i].q.z);
                    tried[m]++;
                }
            free(row);
            free(wrong);
            union_truth_free(&truth);
            mesh_scene_free(&scene);
        }
    fclose(quiet);
    print_message("note: %d kinds of wrong tables refused on %zu scenes; %zu points asked\n", (int)MUTATIONS, scenes,
                  asked);
    for (size_t m = 0; m < MUTATIONS; m++)
        if (tried[m] <= 20)
            fail_msg("%s: only tried %zu times", mutations[m].name, tried[m]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_by_hand),
        cmocka_unit_test(test_cells),
        cmocka_unit_test(test_wrong_tables),
    };
    return cmocka_run_group_tests_name("oracle of unions", tests, NULL, NULL);
}
