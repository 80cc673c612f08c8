/* test_layers.c - cells that a sheet of a surface fills: what lies behind is hidden there at once, and the sheet's own
 * lines are seen at once. None of this may change a line. So scenes are drawn with one cell, which no sheet fills since
 * its border lies in it, and with many. Rays check the first drawing. */
#include <stdio.h>

#include "patches.h"
#include "roberts.h"

/* ---- meshes ---- */

static void add_wire(sheet *s, roberts_vec3 p, roberts_vec3 q)
{
    uint32_t corner[2] = {add_vertex(s, p.x, p.y, p.z), add_vertex(s, q.x, q.y, q.z)};
    mesh_face(&s->mesh, corner, 2);
}

/* Something behind all sheets, and across their borders. */
static void add_backdrop(sheet *s, double side, double z)
{
    for (int k = 0; k < 5; k++) {
        double at = side * (0.11 + 0.19 * k);
        add_triangle(s, (roberts_vec3){-0.3, at, z - k}, (roberts_vec3){side + 0.4, at + 0.3, z - k},
                     (roberts_vec3){at, side + 0.2, z - k});
    }
}

/* ---- comparing ---- */

/* Is it the same line, with the same visible part? */
static bool same_segment(const roberts_drawing *a, const roberts_segment *s, const roberts_drawing *b,
                         const roberts_segment *t)
{
    if (s->line != t->line || s->state != t->state || s->t0 != t->t0 || s->t1 != t->t1 || s->solid != t->solid ||
        s->v0 != t->v0 || s->v1 != t->v1 || s->by != t->by)
        return false;
    return s->line != ROBERTS_INTERSECTION ||
           memcmp(a->crossing[s->edge].face, b->crossing[t->edge].face, sizeof a->crossing[0].face) == 0;
}

/* Intersections that are not seen may have rows or not. */
static size_t next_row(const roberts_drawing *d, size_t i)
{
    while (i < d->count && d->segment[i].line == ROBERTS_INTERSECTION && d->segment[i].state == ROBERTS_HIDDEN)
        i++;
    return i;
}

/* The rows of visible intersections, one after the other. */
static size_t next_crossing(const roberts_drawing *d, size_t i)
{
    while (i < d->count && (d->segment[i].line != ROBERTS_INTERSECTION || d->segment[i].state == ROBERTS_HIDDEN))
        i++;
    return i;
}

/* If hidden lines are kept, crossings are sought in space, without cells and stars. So what is seen of them must be the
 * same. */
static void expect_same_crossings(const roberts_drawing *a, const roberts_drawing *b, const char *name)
{
    size_t i = next_crossing(a, 0), k = next_crossing(b, 0);
    for (; i < a->count && k < b->count; i = next_crossing(a, i + 1), k = next_crossing(b, k + 1))
        if (memcmp(a->crossing[a->segment[i].edge].face, b->crossing[b->segment[k].edge].face,
                   sizeof a->crossing[0].face) != 0)
            break;
    if (i < a->count || k < b->count)
        fail_msg("%s: not the same intersections are seen if hidden lines are kept", name);
}

static void expect_same(const roberts_drawing *a, const roberts_drawing *b, const char *name, uint32_t grid)
{
    size_t i = next_row(a, 0), k = next_row(b, 0);
    for (; i < a->count && k < b->count; i = next_row(a, i + 1), k = next_row(b, k + 1)) {
        const roberts_segment *s = &a->segment[i], *t = &b->segment[k];
        if (!same_segment(a, s, b, t))
            fail_msg("%s, grid %u: body %u, edge %d-%d is %s from %.17g to %.17g; one cell: body %u, edge %d-%d %s "
                     "from %.17g to %.17g",
                     name, grid, t->solid, (int)t->v0, (int)t->v1, t->state ? "hidden" : "visible", t->t0, t->t1,
                     s->solid, (int)s->v0, (int)s->v1, s->state ? "hidden" : "visible", s->t0, s->t1);
    }
    if (i < a->count || k < b->count)
        fail_msg("%s, grid %u: %zu rows, one cell has %zu", name, grid, b->count, a->count);
}

/* What has been compared. */
typedef struct tally {
    size_t segments, hidden;
} tally;

static const roberts_camera cameras[] = {
    {.dir = {0, 0, 1}, .up = {0, 1, 0}},
    {.dir = {0.21, -0.33, 1}, .up = {0, 1, 0}},
    {.dir = {0.4, 0.3, -1}, .up = {0, 1, 0}},
    {.projection = ROBERTS_PERSPECTIVE, .eye = {5, 3, 40}, .up = {0, 1, 0}},
    {.projection = ROBERTS_PERSPECTIVE,
     .eye = {5, 3, 12},
     .look_at = {4, 4, 0},
     .has_look_at = true,
     .up = {0, 1, 0},
     .near_distance = 12.1}, /* cuts the sheets */
};

static void draw(const roberts_scene *scene, const roberts_camera *camera, bool hidden, uint32_t grid,
                 roberts_drawing *drawing)
{
    roberts_hide_options options = roberts_hide_options_default();
    options.all_edges = true;
    options.keep_hidden = hidden;
    options.grid = grid;
    options.threads = 1;
    *drawing = (roberts_drawing){0};
    assert_int_equal(roberts_hide(scene, camera, &options, drawing, NULL), ROBERTS_OK);
}

static void expect_true(const roberts_scene *scene, const roberts_camera *camera, const roberts_drawing *drawing,
                        const char *name)
{
    roberts_verify_options options = roberts_verify_options_default();
    roberts_verification found;
    options.all_edges = true;
    assert_int_equal(roberts_verify(scene, camera, drawing, &options, &found, NULL), ROBERTS_OK);
    if (found.contradictions > 0)
        fail_msg("%s: %zu of %zu rays contradict the drawing", name, found.contradictions, found.points);
}

/* Draws the scene with one cell and with many, with hidden lines and without. Without them, more is left out. */
static void compare_scene(sheet *s, const char *name, tally *t)
{
    static const uint32_t grids[] = {2, 5, 8, 16, 64};
    roberts_scene *scene = scene_of_mesh(&s->mesh, NULL);
    for (size_t c = 0; c < 2 * (sizeof cameras / sizeof cameras[0]); c++) {
        const roberts_camera *camera = &cameras[c / 2];
        roberts_drawing one, many, other;
        draw(scene, camera, c % 2, 1, &one);
        draw(scene, camera, !(c % 2), 1, &other);
        expect_same_crossings(&one, &other, name);
        roberts_drawing_free(&other);
        expect_true(scene, camera, &one, name);
        t->segments += one.count;
        for (size_t i = 0; i < one.count; i++)
            t->hidden += one.segment[i].state == ROBERTS_HIDDEN;
        for (size_t g = 0; g < sizeof grids / sizeof grids[0]; g++) {
            draw(scene, camera, c % 2, grids[g], &many);
            expect_same(&one, &many, name, grids[g]);
            roberts_drawing_free(&many);
        }
        roberts_drawing_free(&one);
    }
    roberts_scene_free(scene);
    roberts_mesh_free(&s->mesh);
}

static void expect_compared(const tally *t, size_t segments)
{
    assert_true(t->segments >= segments);
    assert_true(t->hidden > t->segments / 20);
}

/* ---- cases ---- */

/* Patches over a backdrop, from the top one down. */
static const struct {
    const char *name;
    int patches;
    patch patch[3];
} patch_cases[] = {
    {"a flat sheet", 1, {{.step = 1, .nx = 8, .ny = 8}}},
    {"a rough sheet", 1, {{.step = 1, .rough = 0.4, .nx = 8, .ny = 8}}},
    {"a steep sheet", 1, {{.step = 1, .rough = 9, .nx = 8, .ny = 8}}},
    {"one with mixed winding", 1, {{.step = 1, .rough = 0.4, .turned = 0.5, .nx = 8, .ny = 8}}},
    {"one with a hole at the borders of cells", 1, {{.step = 1, .nx = 8, .ny = 8, .hole = {2, 4, 3, 6}}}},
    {"... rough", 1, {{.step = 1, .rough = 0.3, .nx = 8, .ny = 8, .hole = {4, 5, 4, 5}}}},
    {"one with many holes", 1, {{.step = 1, .rough = 0.3, .missing = 0.1, .nx = 12, .ny = 12}}},
    {"sheets over one another",
     3,
     {{.step = 1, .z = 4, .rough = 0.3, .nx = 7, .ny = 7},
      {.step = 0.7, .z = 2, .rough = 0.3, .nx = 12, .ny = 12},
      {.step = 0.5, .rough = 0.2, .nx = 16, .ny = 16}}},
    {"... through one another",
     3,
     {{.step = 1, .z = 0.5, .rough = 1, .nx = 7, .ny = 7},
      {.step = 0.7, .z = 0.2, .rough = 1, .nx = 11, .ny = 11},
      {.step = 0.5, .rough = 1, .nx = 15, .ny = 15}}},
    {"... touching, one plane", 2, {{.step = 1, .nx = 8, .ny = 8}, {.x = 0.5, .step = 1, .nx = 7, .ny = 8}}},
    {"... touching within epsilon",
     2,
     {{.step = 1, .z = 1e-11, .nx = 8, .ny = 8}, {.x = 0.25, .step = 0.5, .nx = 15, .ny = 16}}},
    {"... just apart", 2, {{.step = 1, .z = 1e-7, .nx = 8, .ny = 8}, {.step = 0.75, .nx = 10, .ny = 10}}},
    {"a fine half beside a coarse one", 2, {{.step = 1, .nx = 4, .ny = 8}, {.x = 4, .step = 0.5, .nx = 8, .ny = 16}}},
    {"... with holes",
     2,
     {{.step = 1, .missing = 0.1, .nx = 4, .ny = 8}, {.x = 4, .step = 0.5, .missing = 0.1, .nx = 8, .ny = 16}}},
    {"a sheet with a closed slit", 2, {{.step = 1, .nx = 4, .ny = 8}, {.x = 4, .step = 1, .nx = 4, .ny = 8}}},
    {"... open by little", 2, {{.step = 1, .nx = 4, .ny = 8}, {.x = 4.000001, .step = 1, .nx = 4, .ny = 8}}},
    {"... one side lower", 2, {{.step = 1, .z = 0.001, .nx = 4, .ny = 8}, {.x = 3.999, .step = 1, .nx = 4, .ny = 8}}},
};

static void test_patches(void **state)
{
    tally t = {0};
    (void)state;
    for (size_t i = 0; i < sizeof patch_cases / sizeof patch_cases[0]; i++) {
        rng r = {i + 1};
        sheet s = {0};
        for (int k = 0; k < patch_cases[i].patches; k++)
            add_patch(&s, &patch_cases[i].patch[k], &r);
        add_backdrop(&s, 8, -12);
        compare_scene(&s, patch_cases[i].name, &t);
    }
    expect_compared(&t, 20000);
}

/* Wires over a sheet, in it, through it and behind it. */
static void test_wires(void **state)
{
    static const double height[][2] = {{2, 2}, {1e-12, 1e-12}, {0, 0}, {-1e-12, -1e-12}, {-2, -2}, {1, -1}, {1e-6, 2}};
    tally t = {0};
    (void)state;
    for (size_t i = 0; i < sizeof height / sizeof height[0]; i++) {
        rng r = {i + 100};
        sheet s = {0};
        char name[64];
        snprintf(name, sizeof name, "a wire from %g to %g", height[i][0], height[i][1]);
        add_patch(&s, &(patch){.step = 1, .rough = i % 2 ? 0.25 : 0, .nx = 8, .ny = 8}, &r);
        add_wire(&s, (roberts_vec3){0.3, 0.7, height[i][0]}, (roberts_vec3){7.1, 6.2, height[i][1]});
        add_wire(&s, (roberts_vec3){2, 1, height[i][0]}, (roberts_vec3){2, 7, height[i][1]});
        add_backdrop(&s, 8, -5);
        compare_scene(&s, name, &t);
    }
    expect_compared(&t, 5000);
}

/* Fins on a sheet, over it or under it: faces at edges that two faces of the sheet already share. */
static void test_fins(void **state)
{
    static const double tip[] = {3, 0.5, 1e-3, -1e-3, -2};
    tally t = {0};
    (void)state;
    for (size_t i = 0; i < sizeof tip / sizeof tip[0]; i++) {
        const patch p = {.step = 1, .rough = i % 2 ? 0.25 : 0, .nx = 8, .ny = 8};
        rng r = {i + 200};
        sheet s = {0};
        char name[64];
        snprintf(name, sizeof name, "fins with tips at %g", tip[i]);
        uint32_t first = add_patch(&s, &p, &r);
        for (int k = 0; k < 24; k++) {
            int x = rng_int(&r, 0, 6), y = rng_int(&r, 0, 6), along = rng_int(&r, 0, 2);
            uint32_t a = first + (uint32_t)(x * 9 + y), b = a + (along == 0 ? 9u : along == 1 ? 1u : 10u);
            add_face(&s, a, b, add_vertex(&s, x + rng_between(&r, -1, 2), y + rng_between(&r, -1, 2), tip[i]));
        }
        add_backdrop(&s, 8, -5);
        compare_scene(&s, name, &t);
    }
    expect_compared(&t, 5000);
}

/* A book: rasters that share a spine. Edges of the spine have three or four faces, and no border is near. */
static void add_leaf(sheet *s, const uint32_t *spine, int count, roberts_vec3 step)
{
    uint32_t before[32];
    memcpy(before, spine, (size_t)count * sizeof *spine);
    for (int i = 1; i <= 5; i++)
        for (int k = 0; k < count; k++) {
            uint32_t v = add_vertex(s, 4 + i * step.x, 1 + k * 6.0 / (count - 1) + i * step.y, i * step.z);
            if (k > 0) {
                add_face(s, before[k - 1], v - 1, v);
                add_face(s, before[k - 1], v, before[k]);
                before[k - 1] = v - 1;
            }
            if (k == count - 1)
                before[k] = v;
        }
}

static void test_books(void **state)
{
    enum { LONG = 25 };
    static const struct {
        const char *name;
        int leaves;
        roberts_vec3 leaf[4];
    } books[] = {
        {"a book of three leaves, one over another", 3, {{0.6, 0, 0}, {-0.6, 0, 0}, {-0.5, 0, 0.2}}},
        {"... one under another", 3, {{0.6, 0, 0}, {-0.6, 0, 0}, {-0.5, 0, -0.2}}},
        {"... on the other side", 3, {{0.6, 0, 0}, {-0.6, 0, 0}, {0.5, 0, 0.2}}},
        {"a book of four leaves", 4, {{0.6, 0.1, 0}, {-0.6, 0, 0}, {-0.5, 0, 0.2}, {-0.4, 0, 0.4}}},
        {"two leaves, flat", 2, {{0.6, 0, 0}, {-0.6, 0, 0}}},
    };
    tally t = {0};
    (void)state;
    for (size_t i = 0; i < sizeof books / sizeof books[0]; i++) {
        sheet s = {0};
        uint32_t spine[LONG];
        for (int k = 0; k < LONG; k++)
            spine[k] = add_vertex(&s, 4, 1 + k * 6.0 / (LONG - 1), 0);
        for (int k = 0; k < books[i].leaves; k++)
            add_leaf(&s, spine, LONG, books[i].leaf[k]);
        add_backdrop(&s, 8, -6);
        compare_scene(&s, books[i].name, &t);
    }
    expect_compared(&t, 5000);
}

/* A large triangle with a vertex in the middle of its upper side. A fan about that vertex begins at one half of the
 * side, goes `turns` half turns round, and ends at the other half. So no border is near, and the fan lies over itself
 * and crosses itself. */
static void add_half_turns(sheet *s, int turns, double up)
{
    enum { STEPS = 5 }; /* odd, so that faces cross between their sides */
    const double half = 3.141592653589793;
    uint32_t left = add_vertex(s, 0, 4, 0), right = add_vertex(s, 8, 4, 0), middle = add_vertex(s, 4, 4, 0);
    uint32_t before = right;
    add_face(s, left, add_vertex(s, 4, 0, -3), right);
    for (int i = 1; i < STEPS * turns; i++) {
        double angle = half * i / STEPS, z = up * (i < STEPS * turns / 2 ? i : STEPS * turns - i) / STEPS;
        uint32_t v = add_vertex(s, 4 + 4 * cos(angle), 4 + 4 * sin(angle), z);
        add_face(s, middle, before, v);
        before = v;
    }
    add_face(s, middle, before, left);
}

static void test_half_turns(void **state)
{
    static const double up[] = {0, 0.3, 1, -0.4};
    tally t = {0};
    (void)state;
    for (int turns = 1; turns <= 3; turns += 2)
        for (size_t i = 0; i < sizeof up / sizeof up[0]; i++) {
            sheet s = {0};
            char name[80];
            snprintf(name, sizeof name, "%d half turns about a vertex on a side, %g up", turns, up[i]);
            add_half_turns(&s, turns, up[i]);
            add_backdrop(&s, 8, -9);
            compare_scene(&s, name, &t);
        }
    expect_compared(&t, 1000);
}

/* A fan that goes several times round its tip, in a ring of finer triangles: every edge has a face on its left and one
 * on its right, but faces lie over one another at the tip. */
static void add_winding(sheet *s, int turns, double lift, double tip)
{
    enum { SPOKES = 7, RINGS = 4 };
    int count = SPOKES * turns;
    uint32_t first = s->vertices;
    const double round = 6.283185307179586;
    for (int i = 0; i < count; i++)
        for (int k = 1; k <= RINGS; k++) {
            double angle = round * i / SPOKES, up = lift * sin(round * i / count);
            add_vertex(s, 4 + k * cos(angle), 4 + k * sin(angle), k * up);
        }
    uint32_t middle = add_vertex(s, 4, 4, tip);
    for (int i = 0; i < count; i++) {
        uint32_t a = first + (uint32_t)(RINGS * i), b = first + (uint32_t)(RINGS * ((i + 1) % count));
        add_face(s, middle, a, b);
        for (uint32_t k = 0; k + 1 < RINGS; k++) {
            add_face(s, a + k, a + k + 1, b + k + 1);
            add_face(s, a + k, b + k + 1, b + k);
        }
    }
}

static void test_winding(void **state)
{
    tally t = {0};
    (void)state;
    for (int turns = 1; turns <= 3; turns++)
        for (int steep = 0; steep < 4; steep++) {
            sheet s = {0};
            char name[80];
            double lift = steep == 1 ? 0.02 : 0.4 * steep;
            snprintf(name, sizeof name, "a surface that goes %d times round, lift %g", turns, lift);
            add_winding(&s, turns, lift, steep == 3 ? 2 : 0);
            add_backdrop(&s, 8, -6);
            compare_scene(&s, name, &t);
        }
    expect_compared(&t, 4000);
}

/* The great dodecahedron, its pentagons cut into triangles from their middles or from a corner: its surface goes twice
 * round each vertex. */
static void test_great_dodecahedron(void **state)
{
    tally t = {0};
    (void)state;
    for (int from_middle = 0; from_middle < 2; from_middle++) {
        roberts_mesh star = {0};
        sheet s = {0};
        assert_int_equal(roberts_mesh_read_file(&star, "models/star/great-dodecahedron.off", NULL, NULL), ROBERTS_OK);
        for (size_t v = 0; v < star.vertex_count; v++)
            add_vertex(&s, star.vertex[v].x, star.vertex[v].y, star.vertex[v].z);
        for (size_t f = 0; f < star.face_count; f++) {
            const uint32_t *c = star.corner + star.face_start[f], n = star.face_start[f + 1] - star.face_start[f];
            roberts_vec3 m = {0, 0, 0};
            for (uint32_t i = 0; i < n; i++)
                m = vec3_add(m, vec3_scale(1.0 / n, star.vertex[c[i]]));
            uint32_t middle = from_middle ? add_vertex(&s, m.x, m.y, m.z) : c[0];
            for (uint32_t i = 0; i < n; i++)
                if (c[i] != middle && c[(i + 1) % n] != middle)
                    add_face(&s, middle, c[i], c[(i + 1) % n]);
        }
        compare_scene(&s, from_middle ? "great dodecahedron from its middles" : "great dodecahedron", &t);
        roberts_mesh_free(&star);
    }
    expect_compared(&t, 1000);
}

/* A sheet that is rolled up, closed to a tube, or closed with a twist; seen from all sides. */
static void test_rolls(void **state)
{
    enum { AROUND = 30, ALONG = 6 };
    tally t = {0};
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        sheet s = {0};
        const double round = 6.283185307179586;
        for (int i = 0; i < AROUND; i++)
            for (int k = 0; k <= ALONG; k++) {
                double a = round * (kind == 0 ? 1.7 : 1.0) * i / AROUND, w = k - 0.5 * ALONG;
                double radius = kind == 0 ? 2 + 0.05 * i : 3, half = kind == 2 ? 0.5 * a : 1.2;
                double out = radius + 0.4 * w * cos(half), up = 0.7 * w * sin(half);
                add_vertex(&s, 4 + out * cos(a), 4 + up, out * sin(a));
            }
        for (int i = 0; i < AROUND - (kind == 0); i++)
            for (int k = 0; k < ALONG; k++) {
                bool last = i + 1 == AROUND, twist = last && kind == 2;
                int base = last ? 0 : (i + 1) * (ALONG + 1);
                uint32_t a = (uint32_t)(i * (ALONG + 1) + k), b = (uint32_t)(base + (twist ? ALONG - k : k));
                uint32_t c = (uint32_t)(base + (twist ? ALONG - k - 1 : k + 1));
                add_face(&s, a, b, c);
                add_face(&s, a, c, a + 1);
            }
        compare_scene(&s, kind == 0 ? "a roll" : kind == 1 ? "a tube" : "a twisted band", &t);
    }
    expect_compared(&t, 4000);
}

/* Random scenes: rough sheets, partly reversed, with holes, and with triangles and wires across them. */
static void test_random(void **state)
{
    tally t = {0};
    (void)state;
    for (uint64_t seed = 1; seed <= 40; seed++) {
        rng r = {seed};
        sheet s = {0};
        char name[64];
        int sheets = rng_int(&r, 1, 3);
        snprintf(name, sizeof name, "random scene %d", (int)seed);
        for (int k = 0; k < sheets; k++) {
            patch p = {.x = rng_int(&r, -1, 1) * 0.5, .y = rng_int(&r, -1, 1) * 0.5, .z = rng_int(&r, -2, 2)};
            p.nx = rng_int(&r, 2, 9);
            p.ny = rng_int(&r, 2, 9);
            p.step = 8.0 / (p.nx > p.ny ? p.nx : p.ny);
            p.rough = rng_int(&r, 0, 4) * 0.4;
            p.turned = rng_int(&r, 0, 1) * 0.4;
            p.missing = rng_int(&r, 0, 1) * 0.06;
            add_patch(&s, &p, &r);
        }
        for (int k = rng_int(&r, 0, 4); k > 0; k--) {
            roberts_vec3 p[3];
            for (int i = 0; i < 3; i++)
                p[i] = (roberts_vec3){rng_int(&r, 0, 8), rng_int(&r, 0, 8), rng_int(&r, -4, 4)};
            if (k % 2)
                add_wire(&s, p[0], p[1]);
            else
                add_triangle(&s, p[0], p[1], p[2]);
        }
        add_backdrop(&s, 8, -9);
        compare_scene(&s, name, &t);
    }
    expect_compared(&t, 20000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_patches), cmocka_unit_test(test_wires),
        cmocka_unit_test(test_winding), cmocka_unit_test(test_great_dodecahedron),
        cmocka_unit_test(test_fins),    cmocka_unit_test(test_rolls),
        cmocka_unit_test(test_books),   cmocka_unit_test(test_half_turns),
        cmocka_unit_test(test_random),
    };
    return cmocka_run_group_tests_name("layers", tests, NULL, NULL);
}
