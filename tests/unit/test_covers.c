/* test_covers.c - covers: what lies wholly behind a face, or behind faces of one body that cover a cell together, is
 * dropped at once. None of this may change what is seen. So bodies over one another are drawn without hidden lines, and
 * with them: then there are no covers. */
#include <stdio.h>

#include "patches.h"
#include "roberts.h"

/* ---- bodies ---- */

enum { AROUND = 12, ALONG = 7 };

/* Adds a rough ball of triangles. turned: which part of them runs the other way round. */
static void add_ball(sheet *s, roberts_vec3 middle, double radius, double turned, rng *r)
{
    const uint32_t first = s->vertices;
    const double turn = 6.283185307179586 / AROUND;
    for (int i = 0; i < ALONG; i++)
        for (int j = 0; j < AROUND; j++) {
            const double u = turn * j, v = 3.141592653589793 * (i + 1) / (ALONG + 1),
                         d = radius * rng_between(r, 0.85, 1.0);
            add_vertex(s, middle.x + d * sin(v) * cos(u), middle.y + d * sin(v) * sin(u), middle.z + d * cos(v));
        }
    const uint32_t top = add_vertex(s, middle.x, middle.y, middle.z + radius),
                   low = add_vertex(s, middle.x, middle.y, middle.z - radius);
    for (uint32_t i = 0; i <= ALONG; i++)
        for (uint32_t j = 0; j < AROUND; j++) {
            const uint32_t k = (j + 1) % AROUND, above = first + (i - 1) * AROUND, below = first + i * AROUND;
            const uint32_t c[4] = {i ? above + j : top, i < ALONG ? below + j : low, i < ALONG ? below + k : low,
                                   i ? above + k : top};
            const bool swap = rng_between(r, 0, 1) < turned;
            if (i < ALONG)
                add_face(s, c[0], c[swap ? 2 : 1], c[swap ? 1 : 2]);
            if (i > 0)
                add_face(s, c[0], c[swap ? 3 : 2], c[swap ? 2 : 3]);
        }
}

/* Adds a sheet of planar quadrilaterals, folded along one direction. */
static void add_folds(sheet *s, roberts_vec3 corner, double step, uint32_t count, rng *r)
{
    const uint32_t first = s->vertices, row = count + 1;
    for (uint32_t i = 0; i <= count; i++) {
        const double z = corner.z + rng_between(r, -0.4, 0.4);
        for (uint32_t j = 0; j <= count; j++)
            add_vertex(s, corner.x + step * i, corner.y + step * j, z);
    }
    for (uint32_t v = first; v < first + count * row; v++)
        if ((v - first) % row < count)
            mesh_face(&s->mesh, (const uint32_t[]){v, v + row, v + row + 1, v + 1}, 4);
}

/* Adds a flat sheet, and another in its plane, which it does not hide. */
static void add_flat_pair(sheet *s, roberts_vec3 at, rng *r)
{
    for (int k = 0; k < 2; k++)
        add_patch(s, &(patch){.x = at.x - 4 + 0.3 * k, .y = at.y - 4, .z = at.z, .step = 1 - 0.2 * k, .nx = 7, .ny = 7},
                  r);
}

/* Adds quadrilaterals that are planar within the tolerance, and triangles behind them within that departure. */
static void add_bent(sheet *s, roberts_vec3 at, rng *r)
{
    const uint32_t first = s->vertices;
    for (int i = 0; i < 25; i++)
        add_vertex(s, at.x + 2 * (i / 5) - 4, at.y + 2 * (i % 5) - 4, at.z + rng_between(r, -6e-6, 6e-6));
    for (uint32_t v = first; v < first + 20; v++)
        if ((v - first) % 5 < 4)
            mesh_face(&s->mesh, (const uint32_t[]){v, v + 5, v + 6, v + 1}, 4);
    for (int k = 0; k < 3; k++) {
        const double x = at.x + 2 * k - 3.6, y = at.y - 3.6, z = at.z - 3e-6;
        add_triangle(s, (roberts_vec3){x, y, z}, (roberts_vec3){x + 0.5, y, z}, (roberts_vec3){x, y + 0.5, z});
    }
}

/* A bow-tie: two sides cross. It may be off its plane, but counts as planar. Triangles lie along one of its sides, all
 * on one side of it, where the bow-tie has a triangle on either side. */
static void add_bow_tie(sheet *s, roberts_vec3 at, rng *r)
{
    static const double corner[7][2] = {{-10, 0}, {10, 0}, {10, -8}, {-10, 8}, {-10, -10}, {10, -10}, {0, -10}};
    const uint32_t first = s->vertices;
    for (int i = 0; i < 7; i++)
        add_vertex(s, at.x + 0.6 * corner[i][0], at.y + 0.6 * corner[i][1],
                   at.z + (i < 6 ? rng_between(r, -1e-6, 1e-6) : 0));
    mesh_face(&s->mesh, (const uint32_t[]){first, first + 1, first + 2, first + 3}, 4);
    add_face(s, first, first + 4, first + 6);
    add_face(s, first, first + 6, first + 1);
    add_face(s, first + 1, first + 6, first + 5);
}

/* Bodies over one another: balls, sheets with holes, folds; partly through one another, and partly reversed. */
static void add_heap(sheet *s, rng *r)
{
    for (int k = rng_int(r, 8, 14); k > 0; k--) {
        const roberts_vec3 at = {rng_between(r, -2, 2), rng_between(r, -2, 2), -3.0 * k};
        const double mixed = rng_int(r, 0, 1) * 0.2, missing = rng_int(r, 0, 1) * 0.05;
        switch (rng_int(r, 0, 7)) {
        case 0:
            add_folds(s, (roberts_vec3){at.x - 4, at.y - 4, at.z}, 1, 8, r);
            break;
        case 1:
            add_flat_pair(s, at, r);
            break;
        case 2:
            add_patch(s,
                      &(patch){.x = at.x - 4,
                               .y = at.y - 4,
                               .z = at.z,
                               .step = 1,
                               .rough = 0.5,
                               .turned = mixed,
                               .missing = missing,
                               .nx = 8,
                               .ny = 8},
                      r);
            break;
        case 3:
            add_bent(s, at, r);
            break;
        case 4:
            add_bow_tie(s, at, r);
            break;
        default:
            add_ball(s, at, rng_between(r, 3, 5), mixed, r);
        }
    }
}

static void add_pleats_of_twelve(sheet *s, rng *r)
{
    add_pleats(s, 12, 10, r);
}

/* ---- comparing ---- */

static const roberts_camera cameras[] = {
    {.dir = {0, 0, 1}, .up = {0, 1, 0}},
    {.dir = {0.21, -0.13, 1}, .up = {0, 1, 0}},
    {.projection = ROBERTS_PERSPECTIVE, .eye = {1, 2, 40}, .up = {0, 1, 0}},
    {.projection = ROBERTS_PERSPECTIVE, .eye = {1, 2, 9}, .up = {0, 1, 0}, .near_distance = 13.3}, /* cuts bodies */
};

static void draw(const roberts_scene *scene, const roberts_camera *camera, bool hidden, roberts_drawing *drawing)
{
    roberts_hide_options options = roberts_hide_options_default();
    options.all_edges = true;
    options.keep_hidden = hidden;
    assert_int_equal(roberts_hide(scene, camera, &options, drawing, NULL), ROBERTS_OK);
}

static size_t next_visible(const roberts_drawing *d, size_t i)
{
    while (i < d->count && d->segment[i].state != ROBERTS_VISIBLE)
        i++;
    return i;
}

/* The same faces are named, and the ends agree up to rounding. */
static bool same_row(const roberts_drawing *a, const roberts_segment *s, const roberts_drawing *b,
                     const roberts_segment *t)
{
    if (s->line != t->line || s->solid != t->solid || s->v0 != t->v0 || s->v1 != t->v1 ||
        !(fabs(s->t0 - t->t0) < 1e-12) || !(fabs(s->t1 - t->t1) < 1e-12))
        return false;
    return s->line != ROBERTS_INTERSECTION ||
           memcmp(a->crossing[s->edge].face, b->crossing[t->edge].face, sizeof a->crossing[0].face) == 0;
}

/* What covers have hidden. */
typedef struct tally {
    size_t culled;
    uint64_t covered;
} tally;

static void compare_scene(sheet *s, const char *name, tally *t)
{
    roberts_scene *scene = scene_of_mesh(&s->mesh, NULL);
    for (size_t c = 0; c < sizeof cameras / sizeof cameras[0]; c++) {
        roberts_drawing with, without;
        draw(scene, &cameras[c], false, &with);
        draw(scene, &cameras[c], true, &without);
        size_t i = next_visible(&with, 0), k = next_visible(&without, 0);
        for (; i < with.count && k < without.count; i = next_visible(&with, i + 1), k = next_visible(&without, k + 1))
            if (!same_row(&with, &with.segment[i], &without, &without.segment[k]))
                break;
        if (i < with.count || k < without.count)
            fail_msg("%s, camera %zu: visible rows %zu of %zu and %zu of %zu differ", name, c, i, with.count, k,
                     without.count);
        t->culled += with.culled_solids;
        t->covered += with.tally.covered;
        roberts_drawing_free(&with);
        roberts_drawing_free(&without);
    }
    roberts_scene_free(scene);
    roberts_mesh_free(&s->mesh);
}

/* ---- cases ---- */

/* Makes scenes from the seeds 1 .. count, and compares each. */
static tally compare_scenes(const char *kind, int count, void (*add)(sheet *s, rng *r))
{
    tally t = {0};
    for (int seed = 1; seed <= count; seed++) {
        rng r = {(uint64_t)seed};
        sheet s = {0};
        char name[64];
        snprintf(name, sizeof name, "%s %d", kind, seed);
        add(&s, &r);
        compare_scene(&s, name, &t);
    }
    print_message("note: %zu bodies culled, %llu lines behind covers\n", t.culled, (unsigned long long)t.covered);
    return t;
}

static void test_heaps(void **state)
{
    (void)state;
    const tally t = compare_scenes("heap", 60, add_heap);
    assert_true(t.culled > 100 && t.covered > 1000);
}

static void test_pleats(void **state)
{
    (void)state;
    assert_true(compare_scenes("pleats", 12, add_pleats_of_twelve).covered > 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_heaps), cmocka_unit_test(test_pleats)};
    return cmocka_run_group_tests_name("covers", tests, NULL, NULL);
}
