/* Small scenes whose drawings are worked out by hand: each edge that matters with its parts, and the total number of
 * visible rows, so that nothing else is drawn.
 *
 * Boxes are numbered in the order of the table; box k has the vertices 8 k + x + 2 y + 4 z, where x, y and z are 0 on
 * the low and 1 on the high side. From "top" (x right, y up) only the upper faces are front, the four sides are
 * edge-on; from "front" (x right, z up) only those of least y; from "iso" those of greatest x, least y and greatest z,
 * a point P being hidden by a box that P + s (1, -1, 1) meets for some s > 0. */
#include <float.h>
#include <stdio.h>

#include "scenes.h"

/* Parameters are simple fractions; the library computes them to 1e-11. */
#define T_BOUND 1e-11

enum { BOXES = 5, EDGES = 14 };

typedef struct box {
    roberts_vec3 low, high;
} box;

/* An edge with its parts: "8-9 v 1/4 h0 3/4 v" is visible from 0 to 1/4, hidden by solid 0 to 3/4, visible to 1; c is
 * clipped. */
static const struct scene_case {
    const char *name, *view;
    box boxes[BOXES];
    unsigned visible;
    const char *edges[EDGES];
} cases[] = {
    {"one cube", "iso", {{{0, 0, 0}, {2, 2, 2}}}, 9, {"0-2 h0", "2-3 h0", "2-6 h0", "0-1 v", "1-5 v", "6-7 v"}},
    {"one cube, sides edge-on", "top", {{{0, 0, 0}, {2, 2, 2}}}, 4, {"4-5 v", "0-4 h0", "0-1 h0"}},
    {"cube behind cube",
     "top",
     {{{0, 0, 2}, {2, 2, 4}}, {{1, 1, 0}, {3, 3, 1}}},
     8,
     {"4-5 v", "4-6 v", "5-7 v", "6-7 v", "12-13 h0 1/2 v", "12-14 h0 1/2 v", "13-15 v", "14-15 v", "8-9 h0",
      "10-11 h1", "8-12 h0", "11-15 h1"}},
    {"cube behind cube, written the other way round",
     "top",
     {{{1, 1, 0}, {3, 3, 1}}, {{0, 0, 2}, {2, 2, 4}}},
     8,
     {"4-5 h1 1/2 v", "4-6 h1 1/2 v", "5-7 v", "6-7 v", "12-13 v", "13-15 v"}},
    {"cube before bar",
     "iso",
     {{{0, 0, 0}, {2, 2, 2}}, {{-5, 3, -2}, {3, 4, -1}}},
     21,
     {"12-13 v 1/4 h0 3/4 v", "14-15 v 1/4 h0 5/8 v", "8-9 v 1/4 h0 5/8 v", "12-14 v", "9-13 v", "8-10 h1"}},
    {"block on a table",
     "top",
     {{{0, 0, 0}, {4, 4, 1}}, {{1, 1, 1}, {2, 2, 2}}},
     8,
     {"4-5 v", "6-7 v", "12-13 v", "14-15 v", "8-9 h1"}},
    /* its lower front edge lies behind the table's front face, along its border */
    {"block on a table",
     "front",
     {{{0, 0, 0}, {4, 4, 1}}, {{1, 1, 1}, {2, 2, 2}}},
     7,
     {"4-5 v", "8-9 h0", "8-12 v", "9-13 v", "12-13 v"}},
    /* the table's left edge passes behind the block exactly along the block's outline; the block's lower edges lie in
     * the table's plane */
    {"block on a table",
     "iso",
     {{{0, 0, 0}, {4, 4, 1}}, {{1, 1, 1}, {2, 2, 2}}},
     19,
     {"4-6 v 1/2 h1 3/4 v", "6-7 v", "4-5 v", "8-9 v", "9-11 v", "8-10 h1", "12-14 v"}},
    {"two bricks side by side leave no gap",
     "front",
     {{{0, 0, 0}, {2, 1, 2}}, {{2, 0, 0}, {4, 1, 2}}, {{-1, 2, 1}, {5, 3, 3}}},
     13,
     {"16-17 v 1/6 h0 5/6 v", "1-5 v", "8-12 v", "20-21 v", "16-20 v"}},
    {"two bricks with a gap below epsilon leave none either",
     "front",
     {{{0, 0, 0}, {2, 1, 2}}, {{2 + 1e-12, 0, 0}, {4, 1, 2}}, {{-1, 2, 1}, {5, 3, 3}}},
     13,
     {"16-17 v 1/6 h0 5/6 v"}},
    {"two bricks with a gap show what is behind",
     "front",
     {{{0, 0, 0}, {2, 1, 2}}, {{2.5, 0, 0}, {4, 1, 2}}, {{-1, 2, 1}, {5, 3, 3}}},
     14,
     {"16-17 v 1/6 h0 1/2 v 3.5/6 h1 5/6 v"}},
    {"two bricks with a narrow gap show what is behind",
     "front",
     {{{0, 0, 0}, {2, 1, 2}}, {{2.0000006, 0, 0}, {4, 1, 2}}, {{-1, 2, 1}, {5, 3, 3}}},
     14,
     {"16-17 v 1/6 h0 1/2 v 3.0000006/6 h1 5/6 v"}},
    {"two bricks that overlap unite",
     "front",
     {{{0, 0, 0}, {3, 1, 2}}, {{1, 0.5, 0}, {4, 1, 2}}, {{-1, 2, 1}, {5, 3, 3}}},
     12,
     {"16-17 v 1/6 h0 5/6 v", "8-9 h0 2/3 v", "12-13 h0 2/3 v", "8-12 h0", "9-13 v"}},
    {"four plates meet over an edge",
     "top",
     {{{-2, -2, 2}, {0, 0, 3}},
      {{0, -2, 2}, {2, 0, 3}},
      {{-2, 0, 2}, {0, 2, 3}},
      {{0, 0, 2}, {2, 2, 3}},
      {{-3, 0, 0}, {3, 1, 1}}},
     22,
     {"36-37 v 1/6 h0 5/6 v", "38-39 v 1/6 h2 5/6 v", "36-38 v", "5-7 v", "12-14 v"}},
    {"a rod ends on a wall",
     "iso",
     {{{0, 2, 0}, {4, 3, 4}}, {{1, 0, 1}, {2, 2, 2}}},
     18,
     {"0-1 h1 1/4 v", "0-4 h1 1/4 v", "4-6 v", "13-15 v", "9-11 v", "12-14 v", "14-15 v", "11-15 v", "10-11 h1"}},
    /* where the edges end they touch the wall */
    {"a rod ends on a wall that hides it",
     "back",
     {{{0, 2, 0}, {4, 3, 4}}, {{1, 0, 1}, {2, 2, 2}}},
     4,
     {"2-3 v", "6-7 v", "10-11 h0", "14-15 h0", "10-14 h0", "11-15 h0"}},
    {"an edge behind a border",
     "top",
     {{{0, 0, 2}, {4, 4, 3}}, {{1, -2, 0}, {3, 0, 1}}},
     7,
     {"14-15 h0", "12-13 v", "12-14 v", "13-15 v", "4-5 v"}},
    {"an edge behind a border and longer",
     "top",
     {{{0, 0, 2}, {4, 4, 3}}, {{-1, -2, 0}, {5, 0, 1}}},
     9,
     {"14-15 v 1/6 h0 5/6 v", "12-13 v", "12-14 v"}},
    {"an edge along a border in the same plane",
     "top",
     {{{0, 0, 2}, {4, 4, 3}}, {{1, -2, 2}, {3, 0, 3}}},
     8,
     {"14-15 v", "4-5 v", "12-13 v"}},
    {"an edge beyond a border", "top", {{{0, 0, 2}, {4, 4, 3}}, {{1, -2, 0}, {3, -1e-9, 1}}}, 8, {"14-15 v"}},
    {"an edge beyond a border by less than epsilon",
     "top",
     {{{0, 0, 2}, {4, 4, 3}}, {{1, -2, 0}, {3, -1e-12, 1}}},
     7,
     {"14-15 h0"}},
    {"a corner touches a border", "top", {{{0, 0, 2}, {4, 4, 3}}, {{-2, -2, 0}, {0, 0, 1}}}, 8, {"13-15 v", "14-15 v"}},
    {"a solid inside another",
     "iso",
     {{{0, 0, 0}, {4, 4, 4}}, {{1, 1, 1}, {2, 2, 2}}},
     9,
     {"8-9 h0", "13-15 h0", "12-13 h0", "15-14 h0", "10-14 h0"}},
    {"a solid inside another, up to its upper face",
     "top",
     {{{0, 0, 0}, {4, 4, 4}}, {{1, 1, 3}, {2, 2, 4}}},
     8,
     {"12-13 v", "12-14 v", "13-15 v", "14-15 v", "8-9 h0"}},
    {"the same solid twice: its edges lie in each other's planes",
     "iso",
     {{{0, 0, 0}, {2, 2, 2}}, {{0, 0, 0}, {2, 2, 2}}},
     18,
     {"0-1 v", "8-9 v", "4-6 v", "12-14 v", "13-15 v", "2-3 h0", "10-11 h0"}},
    {"a rod through a plate",
     "front",
     {{{0, 0, 1}, {4, 4, 2}}, {{1, 1, 0}, {2, 2, 4}}},
     10,
     {"8-12 v 1/4 h0 1/2 v", "9-13 v 1/4 h0 1/2 v", "8-9 v", "12-13 v", "0-1 v", "4-5 v"}},
    /* the plate's lower front edge hides the rod's lower edges along a border; the rod's upper corner touches 6-7 */
    {"a rod through a plate",
     "iso",
     {{{0, 0, 1}, {4, 4, 2}}, {{1, 1, 0}, {2, 2, 4}}},
     16,
     {"9-13 h0 1/2 v", "8-12 h0 1/2 v", "11-15 h0 1/2 v", "8-9 h0", "9-11 h0", "12-13 v", "13-15 v", "12-14 v",
      "14-15 v", "4-6 v 1/2 h1", "6-7 v", "4-5 v", "1-3 v"}},
    {"plate on plate",
     "iso",
     {{{0, 0, 0}, {4, 4, 1}}, {{0, 0, 1}, {4, 4, 2}}},
     16,
     {"4-5 v", "5-7 v", "4-6 h1", "6-7 h1", "8-9 v", "9-11 v", "8-10 h1", "0-4 v", "3-7 v"}},
    {"plate on plate", "top", {{{0, 0, 0}, {4, 4, 1}}, {{0, 0, 1}, {4, 4, 2}}}, 4, {"4-5 h1", "4-6 h1", "12-13 v"}},
    {"a face a little behind another",
     "front",
     {{{0, 0, 0}, {2, 1, 2}}, {{0, 1e-9, 0}, {2, 1, 2}}},
     4,
     {"0-1 v", "8-9 h0", "9-13 h0"}},
    {"a face behind another by less than epsilon",
     "front",
     {{{0, 0, 0}, {2, 1, 2}}, {{0, 1e-12, 0}, {2, 1, 2}}},
     8,
     {"0-1 v", "8-9 v", "9-13 v"}},
    {"end-on edges belong to edge-on faces and are hidden",
     "top",
     {{{0, 0, 0}, {2, 2, 1}}, {{-1, -1, 2}, {1, 1, 3}}},
     8,
     {"0-4 h1", "1-5 h0", "2-6 h0", "3-7 h0", "11-15 h1", "4-5 h1 1/2 v"}},
};

/* ---- rows against text ----------------------------------------------------------------------------------------- */

static double read_fraction(const char **text)
{
    char *end;
    double value = strtod(*text, &end);
    if (*end == '/')
        value /= strtod(end + 1, &end);
    *text = end;
    return value;
}

/* Whether the rows of an edge, `count` of them, are those of the text. */
static bool rows_are(const char *text, const roberts_segment *row, size_t count)
{
    double from = 0.0;
    for (size_t i = 0; i < count; i++) {
        char state = *text++;
        uint32_t by = ROBERTS_NONE;
        double to = 1.0;
        if (state == 'h')
            by = (uint32_t)strtoul(text, (char **)(uintptr_t)&text, 10);
        if (*text == ' ') {
            text++;
            to = read_fraction(&text);
            text += *text == ' ';
        }
        uint8_t expected = state == 'h' ? ROBERTS_HIDDEN : state == 'c' ? ROBERTS_CLIPPED : ROBERTS_VISIBLE;
        if (row[i].state != expected || row[i].by != by || fabs(row[i].t0 - from) > T_BOUND ||
            fabs(row[i].t1 - to) > T_BOUND)
            return false;
        from = to;
    }
    return *text == '\0' && from == 1.0;
}

static void print_rows(const roberts_segment *row, size_t count)
{
    for (size_t i = 0; i < count; i++)
        printf("  got %u-%u %s %d %.17g .. %.17g\n", row[i].v0, row[i].v1,
               row[i].state == ROBERTS_HIDDEN    ? "hidden by"
               : row[i].state == ROBERTS_CLIPPED ? "clipped"
                                                 : "visible",
               (int)row[i].by, row[i].t0, row[i].t1);
}

static void expect_edge(const char *name, const char *view, const roberts_drawing *d, const char *text)
{
    const char *parts;
    uint32_t a = (uint32_t)strtoul(text, (char **)(uintptr_t)&parts, 10);
    uint32_t b = (uint32_t)strtoul(parts + 1, (char **)(uintptr_t)&parts, 10);
    uint32_t v0 = a < b ? a : b, v1 = a < b ? b : a;
    size_t first = 0, end;
    while (first < d->count && (d->segment[first].v0 != v0 || d->segment[first].v1 != v1))
        first++;
    for (end = first; end < d->count && d->segment[end].v0 == v0 && d->segment[end].v1 == v1;)
        end++;
    if (first == end || !rows_are(parts + 1, d->segment + first, end - first)) {
        print_rows(d->segment + first, end - first);
        fail_msg("%s (%s): expected %s", name, view, text);
    }
}

static void expect_visible(const char *name, const char *view, const roberts_drawing *d, unsigned visible)
{
    unsigned count = 0;
    for (size_t i = 0; i < d->count; i++)
        count += d->segment[i].state == ROBERTS_VISIBLE;
    if (count != visible) {
        print_rows(d->segment, d->count);
        fail_msg("%s (%s): %u visible rows, expected %u", name, view, count, visible);
    }
}

static roberts_hide_options with_hidden(void)
{
    roberts_hide_options options = roberts_hide_options_default();
    options.keep_hidden = true;
    return options;
}

static void expect_case(const struct scene_case *c, const roberts_camera *camera)
{
    roberts_hide_options options = with_hidden();
    model m = {0};
    for (int k = 0; k < BOXES && c->boxes[k].high.z > c->boxes[k].low.z; k++)
        model_box(&m, c->boxes[k].low, c->boxes[k].high);
    roberts_drawing drawing = model_draw(&m, camera, &options);
    for (int k = 0; k < EDGES && c->edges[k]; k++)
        expect_edge(c->name, c->view, &drawing, c->edges[k]);
    expect_visible(c->name, c->view, &drawing, c->visible);
    roberts_drawing_free(&drawing);
    model_free(&m);
}

static void boxes_by_table(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_camera camera = preset_camera(cases[i].view);
        expect_case(&cases[i], &camera);
    }
}

/* If depth moves points right and up by as much as it is, the line of sight is that of "iso". The pictures differ, the
 * parts are the same. */
static void boxes_seen_obliquely(void **state)
{
    roberts_camera camera = {.dir = {0, -1, 0}, .oblique = {1, 1}};
    size_t tried = 0;
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        if (strcmp(cases[i].view, "iso") == 0) {
            expect_case(&cases[i], &camera);
            tried++;
        }
    assert_true(tried > 5);
}

/* ---- solids that are no boxes ---------------------------------------------------------------------------------- */

/* An edge 8-9 of solid 2 runs along y = 0, at so flat an angle to a border of solid 0 that it is within epsilon (1.2e-9
 * to 1.7e-9) of the border's line for twelve and more of its hundred units. But the gap between them is far wider than
 * epsilon. */
static void borders_at_flat_angles(void **state)
{
    static const struct {
        const char *name;
        roberts_vec3 solid[3][4];
        const char *rows;
    } table[] = {
        {"the border ends at a corner",
         {{{0, 0, 10}, {50, 0, 10}, {60, -30, 10}, {30, -10, 5}},
          {{58, -1, 10}, {59, -1, 10}, {59, 1, 10}, {58, 1, 11}},
          {{0, -4.9e-9, 0}, {100, 5.1e-9, 0}, {50, -5, -10}, {50, -4, -11}}},
         "8-9 v 9.8e-11 h0 0.49 v 0.58 h1 0.59 v"},
        {"... and the other way along the edge",
         {{{100, 0, 10}, {50, 0, 10}, {40, -30, 10}, {70, -10, 5}},
          {{42, -1, 10}, {41, -1, 10}, {41, 1, 10}, {42, 1, 11}},
          {{0, 5.1e-9, 0}, {100, -4.9e-9, 0}, {50, -5, -10}, {50, -4, -11}}},
         "8-9 v 0.41 h1 0.42 v 0.51 h0 0.999999999902 v"},
        {"the edge is before the plane",
         {{{0, 0, 0}, {100, 0, 100}, {100, 10, 100}, {100, 0, 90}},
          {{44, -1, 60}, {45, -1, 60}, {45, 1, 60}, {44, 1, 61}},
          {{0, -1e-8, 50}, {100, 1e-8, 50}, {50, -5, 40}, {50, -4, 39}}},
         "8-9 v 0.44 h1 0.45 v 0.5 h0"},
        /* it is within epsilon outside of one side, and crosses the line of the other 0.01 beyond the corner of both */
        {"beyond a sharp corner",
         {{{10, -1e-10, 10}, {20, -1e-10, 10}, {10, -1e-7, 10}, {13, -3e-8, 9}},
          {{58, -1, 10}, {59, -1, 10}, {59, 1, 10}, {58, 1, 11}},
          {{0, 0, 0}, {100, 0, 0}, {50, -5, -10}, {50, -4, -11}}},
         "8-9 v 0.1 h0 0.2 v 0.58 h1 0.59 v"},
    };
    roberts_camera camera = {.dir = {0, 0, 1}};
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
        for (uint32_t grid = 0; grid < 2; grid++) {
            roberts_hide_options options = with_hidden();
            model m = {0};
            options.grid = grid;
            for (int k = 0; k < 3; k++)
                model_tetrahedron(&m, table[i].solid[k]);
            roberts_drawing drawing = model_draw(&m, &camera, &options);
            expect_edge(table[i].name, "top", &drawing, table[i].rows);
            roberts_drawing_free(&drawing);
            model_free(&m);
        }
}

/* A roof of two faces, and an edge from x = 0 to 100 that pierces both of their planes, at x = 49 and, at so flat an
 * angle that it is within epsilon for ten units, at x = 50. It is hidden from there on, whatever the order of the
 * faces. */
static void pierced_planes_in_any_order(void **state)
{
    static const roberts_vec2 section[4] = {{-1, 5}, {49, 10 - 1e-10}, {101, 10 + 5.1e-9}, {101, 0}}; /* x and z */
    static const uint32_t face[6][4] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6},
                                        {3, 0, 4, 7}, {3, 2, 1, 0}, {4, 5, 6, 7}};
    static const roberts_vec3 edge[4] = {{0, 0, 10}, {100, 0, 10}, {50, 3, -20}, {48, -3, -22}};
    roberts_camera camera = {.dir = {0, 0, 1}};
    roberts_hide_options options = with_hidden();
    (void)state;
    for (int first = 0; first < 6; first++)
        for (int step = 1; step < 6; step += 4) {
            model m = {0};
            for (int i = 0; i < 8; i++)
                model_vertex(&m, (roberts_vec3){section[i % 4].x, i < 4 ? -5 : 5, section[i % 4].y});
            for (int f = 0; f < 6; f++)
                model_face(&m, face[(first + step * f) % 6], 4);
            model_close_solid(&m);
            model_tetrahedron(&m, edge);
            roberts_drawing drawing = model_draw(&m, &camera, &options);
            expect_edge("pierced", "top", &drawing, "8-9 v 0.5 h0");
            roberts_drawing_free(&drawing);
            model_free(&m);
        }
}

/* A prism whose upper edge 32-33... passes diagonally under the corner where four plates meet. */
static void edge_under_a_corner_of_four(void **state)
{
    roberts_camera camera = preset_camera("top");
    roberts_hide_options options = with_hidden();
    model m = {0};
    (void)state;
    for (int i = 0; i < 4; i++) {
        roberts_vec3 low = {i % 2 ? 0 : -2, i / 2 ? 0 : -2, 2};
        model_box(&m, low, vec3_add(low, (roberts_vec3){2, 2, 1}));
    }
    /* triangle (-3, -3), (3, 3), (-3, 3) from z = 0 to 1 */
    model_add(&m, &shapes[SHAPE_WEDGE], (mat3){{3, 3, 0}, {0, 3, 0}, {0, 0, 0.5}}, (roberts_vec3){0, 3, 0.5});
    roberts_drawing drawing = model_draw(&m, &camera, &options);
    expect_edge("under four plates", "top", &drawing, "35-36 v 1/6 h0 5/6 v");
    expect_visible("under four plates", "top", &drawing, 20);
    roberts_drawing_free(&drawing);
    model_free(&m);
}

/* Solids that are convex only within the tolerance, seen from the top: their outlines are not convex. A tetrahedron
 * below them is still hidden. */
static void outlines_that_are_not_convex(void **state)
{
    static const struct {
        const char *name;
        roberts_vec3 corner[6];
        size_t count, edge_on;
        uint32_t face[8][4]; /* three corners and a 0, or four */
    } table[] = {
        /* A prism with corner 4 a little inside. 1-3-4 and 1-2-4 are slivers, 0-1-3 and 2-4-5 edge-on. 2 and 5 are one
         * point of the picture: the outline runs from there to 4 and back. */
        {"out along a sliver and back",
         {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, {1.999999, 1e-7, 1}, {0, 2, 1}},
         6,
         3,
         {{0, 1, 2}, {3, 4, 5}, {0, 1, 3}, {1, 3, 4}, {1, 2, 4}, {2, 4, 5}, {0, 2, 5, 3}}},
        /* A pyramid that stands on its tip, the side 0-1 of its upper face with a dent at 3, near to 0. */
        {"inward where no face is edge-on",
         {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.02, 2e-5, 0}, {0.5, 0.5, -1}},
         5,
         0,
         {{0, 2, 3}, {1, 2, 3}, {0, 3, 4}, {1, 3, 4}, {1, 2, 4}, {0, 2, 4}}},
    };
    roberts_camera camera = preset_camera("top");
    roberts_hide_options options = with_hidden();
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        model m = {0};
        size_t segments = 0;
        for (size_t v = 0; v < table[i].count; v++)
            model_vertex(&m, table[i].corner[v]);
        for (size_t f = 0; table[i].face[f][1]; f++)
            model_face(&m, table[i].face[f], table[i].face[f][3] ? 4 : 3);
        model_close_solid(&m);
        model_tetrahedron(
            &m, (roberts_vec3[]){{0.3, 1e-4, -0.2}, {0.4, 1e-4, -0.2}, {0.3, 2e-4, -0.2}, {0.32, 1.5e-4, -0.1}});
        roberts_drawing drawing = model_draw(&m, &camera, &options);
        assert_int_equal(drawing.edge_on_faces, table[i].edge_on);
        for (size_t k = 0; k < drawing.count; k++) {
            const roberts_segment *s = &drawing.segment[k];
            if (s->solid == 1 && s->state != ROBERTS_HIDDEN)
                fail_msg("%s: edge %u-%u is seen from %g to %g", table[i].name, s->v0, s->v1, s->t0, s->t1);
            segments += s->solid == 1;
        }
        assert_int_equal(segments, 6);
        roberts_drawing_free(&drawing);
        model_free(&m);
    }
}

/* The upper face of a box has a dent of 1e-7 at 8, near to its corner 4, and the side below is not quite plane. A
 * tetrahedron under the box is still hidden. */
static void face_with_a_dent(void **state)
{
    static const roberts_vec3 corner[] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0},      {0, 0, 1},
                                          {2, 0, 1}, {2, 2, 1}, {0, 2, 1}, {1e-6, 1e-7, 1}};
    static const uint32_t face[][6] = {{4, 0, 3, 2, 1}, {5, 4, 8, 5, 6, 7}, {3, 0, 8, 4},   {4, 0, 1, 5, 8},
                                       {4, 1, 2, 6, 5}, {4, 2, 3, 7, 6},    {4, 3, 0, 4, 7}};
    roberts_camera camera = preset_camera("top");
    roberts_hide_options options = with_hidden();
    model m = {0};
    size_t hidden = 0;
    (void)state;
    for (size_t v = 0; v < sizeof corner / sizeof corner[0]; v++)
        model_vertex(&m, corner[v]);
    for (size_t f = 0; f < sizeof face / sizeof face[0]; f++)
        model_face(&m, face[f] + 1, face[f][0]);
    model_close_solid(&m);
    model_tetrahedron(&m, (roberts_vec3[]){{1.5, 0.5, -2}, {1.8, 0.5, -2}, {1.5, 0.05, -2}, {1.6, 0.6, -1}});
    roberts_drawing drawing = model_draw(&m, &camera, &options);
    for (size_t k = 0; k < drawing.count; k++) {
        const roberts_segment *s = &drawing.segment[k];
        if (s->solid == 1 && s->state != ROBERTS_HIDDEN)
            fail_msg("edge %u-%u is seen from %g to %g", s->v0, s->v1, s->t0, s->t1);
        hidden += s->solid == 1;
    }
    assert_int_equal(hidden, 6);
    roberts_drawing_free(&drawing);
    model_free(&m);
}

/* Three plates meet at (0, 0) without a gap: x < 0, and for x > 0 what lies above and below the line y = x / 100. An
 * edge that ends above that line, nearer to it than epsilon, is still hidden: the first one passes above (0, 0), the
 * second crosses the line a little beyond. */
static void edges_that_end_in_a_sliver(void **state)
{
    static const roberts_vec3 plate[][4] = {{{-8, -8, 0}, {0, -8, 0}, {0, 8, 0}, {-8, 8, 0}},
                                            {{0, 0, 0}, {8, 0.08, 0}, {8, 8, 0}, {0, 8, 0}},
                                            {{0, 0, 0}, {0, -8, 0}, {8, -8, 0}, {8, 0.08, 0}}};
    static const uint32_t face[6][4] = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                        {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    static const roberts_vec3 edge[][2] = {{{-2, 5e-4, -1}, {0.04, 5e-4, -1}},
                                           {{-2, -0.024002, -1}, {0.4, 0.004798, -1}}};
    roberts_camera camera = preset_camera("top");
    roberts_hide_options options = with_hidden();
    (void)state;
    options.epsilon = 1e-3;
    for (size_t i = 0; i < sizeof edge / sizeof edge[0]; i++) {
        model m = {0};
        for (size_t k = 0; k < sizeof plate / sizeof plate[0]; k++) {
            uint32_t first = (uint32_t)m.mesh.vertex_count;
            for (int v = 0; v < 8; v++)
                model_vertex(&m, vec3_add(plate[k][v % 4], (roberts_vec3){0, 0, v / 4}));
            for (int f = 0; f < 6; f++)
                model_face(&m,
                           (uint32_t[]){first + face[f][0], first + face[f][1], first + face[f][2], first + face[f][3]},
                           4);
            model_close_solid(&m);
        }
        model_tetrahedron(&m, (roberts_vec3[]){edge[i][0], edge[i][1], {-1, 1, -2}, {-1, 2, -2}});
        roberts_drawing drawing = model_draw(&m, &camera, &options);
        expect_edge("three plates without a gap", "top", &drawing, "24-25 h0");
        roberts_drawing_free(&drawing);
        model_free(&m);
    }
}

/* An edge runs out from under the tip of a plate, so sharp that it stays within epsilon of both sides' lines. */
static void edge_beyond_a_sharp_tip(void **state)
{
    roberts_camera camera = preset_camera("top");
    roberts_hide_options options = with_hidden();
    model m = {0};
    (void)state;
    options.epsilon = 1e-3;
    model_tetrahedron(&m, (roberts_vec3[]){{0, 0, 0}, {8, 0.004, 0}, {8, -0.004, 0}, {8, 0, 1}});
    model_tetrahedron(&m, (roberts_vec3[]){{-1, 0, -1}, {1, 0, -1}, {-1, 4, -2}, {0, 4, -3}});
    roberts_drawing drawing = model_draw(&m, &camera, &options);
    expect_edge("sharp tip", "top", &drawing, "4-5 v 1/2 h0");
    roberts_drawing_free(&drawing);
    model_free(&m);
}

/* A bar's edge of y = 0 from x = 0 to 10 under three plates: one hides x < 5, one x > 6, and one up to x = 3.6, where
 * its border crosses the edge so obliquely that at x = 6 its line is still within epsilon of the edge. But the border
 * has ended at x = 4, or where the bar rises the edge is nearer than the plate from there on; between the other two the
 * edge is seen. */
static void border_that_runs_nearly_along(void **state)
{
    roberts_camera camera = {.dir = {0, 0, 1}};
    roberts_hide_options options = with_hidden();
    int rows = 0;
    (void)state;
    options.epsilon = 1e-6;
    for (int rises = 0; rises < 2; rises++) {
        model m = {0};
        model_box(&m, (roberts_vec3){0, -1, 0}, (roberts_vec3){10, 0, 1});
        model_box(&m, (roberts_vec3){-1, -2, 12}, (roberts_vec3){5, 2, 13});
        model_box(&m, (roberts_vec3){6, -2, 12}, (roberts_vec3){11, 2, 13});
        model_box(&m, (roberts_vec3){-1, 0, 4}, (roberts_vec3){rises ? 9 : 4, 1, 5});
        for (size_t v = 0; v < 8 && rises; v++)
            m.mesh.vertex[v].z += m.mesh.vertex[v].x;
        for (size_t v = 24; v < 32; v++)
            if (m.mesh.vertex[v].y == 0)
                m.mesh.vertex[v].y = 3e-7 * (m.mesh.vertex[v].x - 3.6);
        for (uint32_t grid = 0; grid < 40; grid += 13) {
            options.grid = grid;
            options.keep_hidden = true;
            roberts_drawing drawing = model_draw(&m, &camera, &options);
            expect_edge("a border nearly along", "top", &drawing, "6-7 h1 1/2 v 6/10 h2");
            roberts_drawing_free(&drawing);
            options.keep_hidden = false;
            drawing = model_draw(&m, &camera, &options);
            for (size_t i = 0; i < drawing.count; i++)
                if (drawing.segment[i].v0 == 6 && drawing.segment[i].v1 == 7) {
                    assert_true(fabs(drawing.segment[i].t0 - 0.5) <= T_BOUND);
                    assert_true(fabs(drawing.segment[i].t1 - 0.6) <= T_BOUND);
                    rows++;
                }
            roberts_drawing_free(&drawing);
        }
        model_free(&m);
    }
    assert_int_equal(rows, 8);
}

/* Without names the same parts are hidden. */
static void names_left_out(void **state)
{
    roberts_hide_options options = with_hidden();
    model m = {0};
    size_t hidden = 0;
    (void)state;
    roberts_camera camera = preset_camera("iso");
    for (int k = 0; k < 9; k++)
        model_box(&m, (roberts_vec3){k % 3, k / 3, 0}, (roberts_vec3){k % 3 + 0.8, k / 3 + 0.7, 1 + k * k % 5});
    roberts_drawing named = model_draw(&m, &camera, &options);
    options.nameless = true;
    roberts_drawing nameless = model_draw(&m, &camera, &options);
    assert_int_equal(named.count, nameless.count);
    for (size_t i = 0; i < named.count; i++) {
        const roberts_segment *a = &named.segment[i], *b = &nameless.segment[i];
        assert_int_equal(b->by, ROBERTS_NONE);
        assert_true(a->solid == b->solid && a->edge == b->edge && a->state == b->state);
        assert_true(a->t0 == b->t0 && a->t1 == b->t1);
        hidden += a->state == ROBERTS_HIDDEN && a->by != ROBERTS_NONE && a->by != a->solid;
    }
    assert_true(hidden > 10);
    roberts_drawing_free(&named);
    roberts_drawing_free(&nameless);
    model_free(&m);
}

/* From an eye at (0, 0, 10) the upper face of a box, at z = 5, hides what lies within |x|, |y| <= (10 - z) / 5. */
static void perspective_by_hand(void **state)
{
    static const roberts_vec3 ridge[4] = {{0, 0, 0}, {10, 0, -10}, {5, 5, -20}, {5, -5, -20}};
    roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = {0, 0, 10}, .has_look_at = true};
    roberts_hide_options options = with_hidden();
    model m = {0};
    (void)state;
    model_box(&m, (roberts_vec3){-1, -1, 4}, (roberts_vec3){1, 1, 5});
    model_box(&m, (roberts_vec3){-4, 0, -1}, (roberts_vec3){4, 1, 0});
    model_tetrahedron(&m, ridge);
    roberts_drawing drawing = model_draw(&m, &camera, &options);
    expect_edge("perspective", "eye", &drawing, "12-13 v 1/4 h0 3/4 v");
    expect_edge("perspective", "eye", &drawing, "4-5 v");
    expect_edge("perspective", "eye", &drawing, "0-4 h0");
    /* 10 t <= (10 + 10 t) / 5 up to t = 1/4, which is 2/5 of the edge's picture; behind the bar's lower edge too, where
     * 4 (10 - z) / 10 > x, up to t = 2/3 */
    expect_edge("perspective", "eye", &drawing, "16-17 h1 2/3 v");
    roberts_drawing_free(&drawing);
    model_free(&m);
}

/* The same eye with the near plane z = 9. A post beside it, [1, 2] x [-1, 1] from z = 0 to 12, is cut there: of its
 * upright edges 3/4 remain, of the upper ones nothing; what remains of it hides x from 10/10 * 12/10 to 2/1 * 12 in the
 * plane z = -2. */
static void near_plane_by_hand(void **state)
{
    roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = {0, 0, 10}, .has_look_at = true, .near_distance = 1};
    roberts_hide_options options = with_hidden();
    model m = {0};
    (void)state;
    model_box(&m, (roberts_vec3){1, -1, 0}, (roberts_vec3){2, 1, 12});
    model_box(&m, (roberts_vec3){-30, 0, -3}, (roberts_vec3){30, 1, -2});
    model_box(&m, (roberts_vec3){1, -1, 13}, (roberts_vec3){2, 1, 14}); /* behind */
    for (int cull = 0; cull < 2; cull++) {
        static const char *const edges[] = {"12-13 v 0.52 h0 0.9 v",
                                            "0-4 v 3/4 c",
                                            "0-2 v",
                                            "1-5 h0 3/4 c",
                                            "3-7 h0 3/4 c",
                                            "4-5 c",
                                            "6-7 c",
                                            "16-17 c",
                                            "19-23 c"};
        options.keep_hidden = !cull;
        roberts_drawing d = model_draw(&m, &camera, &options);
        assert_int_equal(d.solids, 3);
        for (size_t k = 0; k < sizeof edges / sizeof edges[0] && !cull; k++)
            expect_edge("near plane", "eye", &d, edges[k]);
        /* of the post 0-2, 0-4, 2-6; of the bar 12-13 in two, 12-14, 13-15, and of 14-15 two */
        expect_visible("near plane", "eye", &d, 9);
        roberts_drawing_free(&d);
    }
    model_free(&m);
}

/* A side that is straight within the tolerance only weaves six times through the near plane, 10 before the eye: of the
 * floor's and the roof's teeth the half beyond it is left, and seen. */
static void side_that_weaves_through_the_near_plane(void **state)
{
    enum { TEETH = 12, CORNERS = TEETH + 3 };
    roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = {6, -10, 0.5}, .look_at = {6, 0, 0.5}, .has_look_at = true,
                             .near_distance = 10};
    roberts_hide_options options = with_hidden();
    model m = {0};
    (void)state;
    uint32_t ring[2][CORNERS];
    for (uint32_t k = 0; k < 2 * CORNERS; k++) {
        uint32_t i = k % CORNERS;
        double y = i > TEETH ? 5 : i % 2 ? 0x1p-23 : -0x1p-23;
        model_vertex(&m, (roberts_vec3){i == TEETH + 1 ? TEETH : i > TEETH ? 0 : i, y, k / CORNERS});
        ring[k / CORNERS][i] = k;
    }
    model_face(&m, ring[0], CORNERS);
    model_face(&m, ring[1], CORNERS);
    for (uint32_t i = 0; i < CORNERS; i++) {
        uint32_t next = (i + 1) % CORNERS;
        model_face(&m, (uint32_t[]){i, next, next + CORNERS, i + CORNERS}, 4);
    }
    model_close_solid(&m);
    roberts_drawing d = model_draw(&m, &camera, &options);
    expect_edge("weaving side", "eye", &d, "0-1 c 1/2 v");
    expect_edge("weaving side", "eye", &d, "1-2 v 1/2 c");
    expect_edge("weaving side", "eye", &d, "26-27 v 1/2 c");
    expect_edge("weaving side", "eye", &d, "13-14 h0");
    expect_visible("weaving side", "eye", &d, 2 * TEETH);
    roberts_drawing_free(&d);
    model_free(&m);
}

/* Two corners of a pyramid lie in the near plane, and in the picture four vertices lie on one upright line within
 * rounding. The triangle is half behind the cut. */
static void cap_whose_border_is_upright_within_rounding(void **state)
{
    roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = {0, 2, 3}, .look_at = {1, 1, 3}, .has_look_at = true,
                             .near_distance = 0.70710678118654757};
    roberts_hide_options options = with_hidden();
    model m = {0};
    const double point[8][3] = {{0, 1, 0}, {1, 1, 0}, {1, 2, 0},     {0, 2, 0},
                                {2, 2, 3}, {0, 0, 3}, {1.1, 1.9, 1}, {3, 3, 3}};
    (void)state;
    for (uint32_t v = 0; v < 5; v++)
        model_vertex(&m, (roberts_vec3){point[v][0], point[v][1], point[v][2]});
    model_face(&m, (uint32_t[]){0, 1, 2, 3}, 4);
    for (uint32_t v = 0; v < 4; v++)
        model_face(&m, (uint32_t[]){v, (v + 1) % 4, 4}, 3);
    model_close_solid(&m);
    for (uint32_t v = 5; v < 8; v++)
        model_vertex(&m, (roberts_vec3){point[v][0], point[v][1], point[v][2]});
    model_face(&m, (uint32_t[]){5, 6, 7}, 3);
    model_close_solid(&m);
    roberts_drawing d = model_draw(&m, &camera, &options);
    expect_edge("cap", "eye", &d, "5-6 v 60/73 h0");
    expect_edge("cap", "eye", &d, "6-7 h0 1/11 v");
    roberts_drawing_free(&d);
    model_free(&m);
}

/* The same where the first corner of the outline lies in the middle of the upright line: the lower end is kept. */
static void cap_that_begins_in_the_middle_of_its_border(void **state)
{
    roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = {0, 2, 4}, .look_at = {2, 4, 4}, .has_look_at = true,
                             .near_distance = 1.4142135623730951};
    roberts_hide_options options = with_hidden();
    model m = {0};
    (void)state;
    model_tetrahedron(&m, (roberts_vec3[]){{2, 2, 6}, {0, 2, 6}, {6, 0, 4}, {6, 2, 4}});
    model_tetrahedron(&m, (roberts_vec3[]){{4, 4, 6}, {6, 0, 2}, {4, 4, 4}, {6, 2, 6}});
    roberts_drawing d = model_draw(&m, &camera, &options);
    expect_edge("cap", "eye", &d, "5-7 v 1/2 h0");
    roberts_drawing_free(&d);
    model_free(&m);
}

/* The picture is a square about the look-at point, at whose depth lengths are true: 10 tan(fov / 2) to each side. */
static void field_of_view(void **state)
{
    static const struct {
        double fov, near_distance, top;
        bool framed;
        double half;
    } table[] = {
        {0, 0.001, 7, false, 10.0 / 3}, /* the upper face, 3 away */
        {90, 0.001, 7, true, 10},
        {0, 5, 7, false, 2}, /* the near plane, 5 away */
        {90, 5, 7, true, 10},
        {0, 1, 9.5, true, 5.7735026918962576}, /* cut by the near plane, and wider than 60 degrees */
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = {0, 0, 10}, .has_look_at = true,
                                 .near_distance = table[i].near_distance, .fov_degrees = table[i].fov};
        roberts_hide_options options = with_hidden();
        model m = {0};
        model_box(&m, (roberts_vec3){-1, -1, 0}, (roberts_vec3){1, 1, table[i].top});
        roberts_drawing d = model_draw(&m, &camera, &options);
        assert_int_equal(d.framed, table[i].framed);
        assert_true(fabs(d.window_max.x - table[i].half) < 1e-12 && fabs(d.window_max.y - table[i].half) < 1e-12);
        assert_true(fabs(d.window_min.x + table[i].half) < 1e-12 && fabs(d.window_min.y + table[i].half) < 1e-12);
        roberts_drawing_free(&d);
        model_free(&m);
    }
}

static void eyes_refused(void **state)
{
    static const struct {
        const char *name;
        roberts_camera camera;
        roberts_status status;
    } table[] = {
        {"good", {ROBERTS_PERSPECTIVE, .eye = {9, 9, 9}}, ROBERTS_OK},
        {"inside", {ROBERTS_PERSPECTIVE, .eye = {0.1, 0.2, 0.3}}, ROBERTS_BAD_VIEW},
        {"inside, looking out",
         {ROBERTS_PERSPECTIVE, .eye = {0.9, 0, 0}, .look_at = {9, 0, 0}, .has_look_at = true},
         ROBERTS_BAD_VIEW},
        {"looking away",
         {ROBERTS_PERSPECTIVE, .eye = {9, 0, 0}, .look_at = {10, 0, 0}, .has_look_at = true},
         ROBERTS_BAD_VIEW},
        {"all before the near plane", {ROBERTS_PERSPECTIVE, .eye = {9, 0, 0}, .near_distance = 11}, ROBERTS_BAD_VIEW},
        {"all in front of the section",
         {.dir = {1, 0, 0}, .section = {-1, 0, 0}, .has_section = true},
         ROBERTS_BAD_VIEW},
        {"section no number", {.dir = {1, 0, 0}, .section = {-1, NAN, 0}, .has_section = true}, ROBERTS_BAD_VIEW},
        {"field of view below 0", {ROBERTS_PERSPECTIVE, .eye = {9, 0, 0}, .fov_degrees = -1}, ROBERTS_BAD_VIEW},
        {"field of view too wide", {ROBERTS_PERSPECTIVE, .eye = {9, 0, 0}, .fov_degrees = 180}, ROBERTS_BAD_VIEW},
        {"field of view no number", {ROBERTS_PERSPECTIVE, .eye = {9, 0, 0}, .fov_degrees = NAN}, ROBERTS_BAD_VIEW},
        {"near distance below 0", {ROBERTS_PERSPECTIVE, .eye = {9, 0, 0}, .near_distance = -1}, ROBERTS_BAD_VIEW},
        {"near distance infinite",
         {ROBERTS_PERSPECTIVE, .eye = {9, 0, 0}, .near_distance = INFINITY},
         ROBERTS_BAD_VIEW},
    };
    model m = {0};
    (void)state;
    model_box(&m, (roberts_vec3){-1, -1, -1}, (roberts_vec3){1, 1, 1});
    roberts_scene *scene = model_build(&m);
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_drawing d = {.count = 77};
        roberts_error error = {0};
        roberts_status status = roberts_hide(scene, &table[i].camera, NULL, &d, &error);
        if (status != table[i].status || (status != ROBERTS_OK) != (error.message[0] != '\0'))
            fail_msg("%s: status %d, message \"%s\"", table[i].name, status, error.message);
        assert_true(status == ROBERTS_OK || (d.count == 0 && !d.segment));
        roberts_drawing_free(&d);
    }
    roberts_scene_free(scene);
    model_free(&m);
}

/* The eye touches a cube, or is so near to it that the near plane must be farther away than requested. Nothing is
 * refused, the drawing is that of the least possible distance, and rays find no fault in it. */
static void eyes_very_near(void **state)
{
    static const struct {
        const char *name;
        roberts_vec3 eye;
        bool seen; /* otherwise the rest of the cube lies behind the cut */
    } table[] = {
        {"before a corner", {1.000001, 1.000001, 1.000001}, true},
        {"nearer to it", {1.0000001, 1.0000001, 1.0000001}, true},
        {"at it", {1, 1, 1}, false},
        {"before an edge", {1.000001, 0.25, 1.000001}, true},
        {"at it", {1, 0.25, 1}, false},
        {"before a face", {0.5, 0.25, 1.0000001}, true},
        {"on it", {0.5, 0.25, 1}, false},
        {"in its plane", {1.0000005, 0.25, 1}, true},
    };
    const double least = 1e-6 * sqrt(12.0) + 64 * DBL_EPSILON; /* of the cube's diameter, and some rounding */
    model m = {0};
    (void)state;
    model_box(&m, (roberts_vec3){-1, -1, -1}, (roberts_vec3){1, 1, 1});
    roberts_scene *scene = model_build(&m);
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        const double nears[] = {1e-6, 1e-9, least};
        roberts_drawing d[3];
        for (int k = 0; k < 3; k++) {
            roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = table[i].eye, .near_distance = nears[k]};
            roberts_error error = {0};
            roberts_verification found;
            if (roberts_hide(scene, &camera, NULL, &d[k], &error) != ROBERTS_OK)
                fail_msg("%s: %s", table[i].name, error.message);
            assert_int_equal(roberts_verify(scene, &camera, &d[k], NULL, &found, NULL), ROBERTS_OK);
            assert_true((found.points > 0) == table[i].seen && found.contradictions == 0);
            assert_int_equal(d[k].count, d[0].count);
        }
        for (size_t k = 0; k < d[0].count; k++) {
            assert_true(d[0].segment[k].t0 == d[1].segment[k].t0 && d[0].segment[k].t1 == d[1].segment[k].t1);
            assert_true(fabs(d[0].segment[k].t0 - d[2].segment[k].t0) < 1e-12 &&
                        fabs(d[0].segment[k].t1 - d[2].segment[k].t1) < 1e-12);
        }
        for (int k = 0; k < 3; k++)
            roberts_drawing_free(&d[k]);
    }
    roberts_scene_free(scene);
    model_free(&m);
}

/* An eye in the middle of a slanted face looks away from the solid at another one. It is outside, whatever the order of
 * the face's corners. If it is moved through the face by more than rounding, it is inside. */
static void eyes_on_a_face(void **state)
{
    static const uint32_t order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static const uint32_t others[3][3] = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    static const roberts_vec3 point[2][4] = {{{1, 3, 4}, {0, 4, 1}, {0, 1, 3}, {2, 1, 3}},
                                             {{2, 0, 2}, {3, 0, 4}, {3, 2, 3}, {4, 0, 3}}};
    (void)state;
    for (int i = 0; i < 2 * 6; i++) {
        const roberts_vec3 *P = point[i / 6];
        roberts_vec3 ab = vec3_add(P[0], P[1]), ac = vec3_add(P[0], P[2]);
        roberts_vec3 eye = vec3_scale(0.25, vec3_add(ab, ac)), out = vec3_sub(eye, P[3]);
        roberts_vec3 low = vec3_add(eye, vec3_scale(9, out)), one = {1, 1, 1};
        model m = {0};
        for (int k = 0; k < 4; k++)
            model_vertex(&m, P[k]);
        model_face(&m, order[i % 6], 3);
        for (int k = 0; k < 3; k++)
            model_face(&m, others[k], 3);
        model_close_solid(&m);
        model_box(&m, low, vec3_add(low, one));
        roberts_scene *scene = model_build(&m);
        for (int inside = 0; inside < 2; inside++) {
            roberts_camera camera = {ROBERTS_PERSPECTIVE, .look_at = low, .has_look_at = true};
            camera.eye = vec3_sub(eye, vec3_scale(inside ? 1e-9 : 0, out));
            roberts_drawing d;
            roberts_error error = {0};
            roberts_status status = roberts_hide(scene, &camera, NULL, &d, &error);
            if (status != (inside ? ROBERTS_BAD_VIEW : ROBERTS_OK))
                fail_msg("solid %d, order %d, %d: \"%s\"", i / 6, i % 6, inside, error.message);
            roberts_drawing_free(&d);
        }
        roberts_scene_free(scene);
        model_free(&m);
    }
}

/* A slab that tilts, given to four digits, passes under the eye, which looks along it: where the near plane cuts it,
 * its nearest corner is a thousand times as near as a small box that lies 0.03 below its upper face. That face departs
 * from its plane by less than 1e-4. At the box, this departure must count for less than at that corner. */
static void box_buried_in_a_slab_under_the_eye(void **state)
{
    static const roberts_vec3 point[2][8] = {{{1.6298, -10.4187, -3.4775},
                                              {9.4834, -5.3185, -2.2532},
                                              {-11.6033, 4.3968, -0.0248},
                                              {0.5014, 12.2577, 1.8621},
                                              {1.627, -10.648, -2.5041},
                                              {9.4806, -5.5478, -1.2799},
                                              {-11.6061, 4.1675, 0.9485},
                                              {0.4986, 12.0283, 2.8355}},
                                             {{-5.536, 2.3709, 0.029},
                                              {-5.0759, 2.6697, 0.1007},
                                              {-5.8402, 2.7586, 0.1195},
                                              {-5.3757, 3.0602, 0.1919},
                                              {-5.5373, 2.2632, 0.4865},
                                              {-5.0772, 2.5619, 0.5582},
                                              {-5.8415, 2.6508, 0.5769},
                                              {-5.377, 2.9525, 0.6493}}};
    static const uint32_t side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    const roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = {3.8832, -6.0355, 0.233},
                                   .look_at = {-3.3323, 4.8587, 1.1352}, .has_look_at = true};
    model m = {0};
    (void)state;
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 8; k++)
            model_vertex(&m, point[i][k]);
        for (int k = 0; k < 6; k++) {
            uint32_t corner[4];
            for (int c = 0; c < 4; c++)
                corner[c] = m.first_vertex[i] + side[k][c];
            model_face(&m, corner, 4);
        }
        model_close_solid(&m);
    }
    for (int hidden = 0; hidden < 2; hidden++) {
        roberts_hide_options options = roberts_hide_options_default();
        options.keep_hidden = hidden;
        roberts_drawing d = model_draw(&m, &camera, &options);
        for (size_t i = 0; i < d.count; i++)
            assert_true(d.segment[i].solid == 0 || d.segment[i].state == ROBERTS_HIDDEN);
        roberts_drawing_free(&d);
    }
    model_free(&m);
}

/* ---- flat edges ------------------------------------------------------------------------------------------------ */

/* A box 4 x 2 x 4 with a ridge along z on top (greatest y): the two upper faces meet at `degrees`. */
static void add_ridged_box(model *m, double degrees)
{
    static const uint32_t side[5][4] = {{0, 1, 6, 5}, {1, 2, 7, 6}, {2, 3, 8, 7}, {3, 4, 9, 8}, {4, 0, 5, 9}};
    double h = 2 * tan(degrees / 2 * acos(-1.0) / 180);
    const roberts_vec2 outline[5] = {{-2, -1}, {2, -1}, {2, 1}, {0, 1 + h}, {-2, 1}};
    for (int i = 0; i < 10; i++)
        model_vertex(m, (roberts_vec3){outline[i % 5].x, outline[i % 5].y, i < 5 ? -2 : 2});
    for (int f = 0; f < 5; f++)
        model_face(m, side[f], 4);
    model_face(m, (uint32_t[]){4, 3, 2, 1, 0}, 5);
    model_face(m, (uint32_t[]){5, 6, 7, 8, 9}, 5);
    model_close_solid(m);
}

/* Rows of edge v0-v1. */
static size_t rows_of(const roberts_drawing *d, uint32_t v0, uint32_t v1)
{
    size_t count = 0;
    for (size_t i = 0; i < d->count; i++)
        count += d->segment[i].v0 == v0 && d->segment[i].v1 == v1;
    return count;
}

/* The ridge has the number 3-8. From above both its faces are front; from the left (or right) one is, however flat the
 * ridge: it is outline then. From below none is. */
static void flat_edges_by_table(void **state)
{
    static const struct {
        const char *name;
        double bend, crease;
        bool all;
        roberts_vec3 dir;
        size_t rows;
    } table[] = {
        {"flatter than a tenth of a degree", 0.099, 0.1, false, {0, 1, 0}, 0},
        {"bent by more", 0.101, 0.1, false, {0, 1, 0}, 1},
        {"flat, but all are wanted", 0.099, 0.1, true, {0, 1, 0}, 1},
        {"outline from the left", 0.099, 0.1, false, {-1, 0, 0}, 1},
        {"outline from the right", 0.099, 180, false, {1, 0, 0}, 1},
        {"from the left, all front", 0.099, 180, false, {-1, 1, 0}, 0},
        {"flat, behind", 0.099, 0.1, false, {0, -1, 0}, 0},
        {"bent, behind", 0.101, 0.1, false, {0, -1, 0}, 1},
        {"nothing is flatter than 0", 1e-4, 0, false, {0, 1, 0}, 1},
        {"a right angle, 89 wanted", 90, 89, false, {0, 1, 0}, 1},
        {"a right angle, just as wanted", 90, 90, false, {0, 1, 0}, 0},
        {"a right angle, 91 wanted", 90, 91, false, {0, 1, 0}, 0},
        {"an acute angle, 170 wanted", 169, 170, false, {0, 1, 0}, 0},
        {"an acute angle, 168 wanted", 169, 168, false, {0, 1, 0}, 1},
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_camera camera = {.dir = table[i].dir};
        roberts_hide_options options = with_hidden();
        model m = {0};
        options.crease_degrees = table[i].crease;
        options.all_edges = table[i].all;
        add_ridged_box(&m, table[i].bend);
        roberts_drawing drawing = model_draw(&m, &camera, &options);
        if (rows_of(&drawing, 3, 8) != table[i].rows)
            fail_msg("%s: %zu rows", table[i].name, rows_of(&drawing, 3, 8));
        roberts_drawing_free(&drawing);
        model_free(&m);
    }
}

/* Coplanar faces: a cube whose faces are cut into triangles looks like one with whole faces. With crease 0 it does not,
 * since no edge is flatter. */
static void cut_cube(void **state)
{
    roberts_camera camera = preset_camera("iso");
    roberts_hide_options options = roberts_hide_options_default();
    model m = {0};
    (void)state;
    model_add(&m, &shapes[SHAPE_CUT], mat3_scale(1, 1, 1), (roberts_vec3){0, 0, 0});
    roberts_drawing drawing = model_draw(&m, &camera, &options);
    assert_int_equal(drawing.count, 9);
    assert_int_equal(drawing.drawn_edges, 9);
    assert_int_equal(drawing.surviving_edges, 12);
    assert_int_equal(drawing.edges, 18);
    roberts_drawing_free(&drawing);
    options.crease_degrees = 0;
    drawing = model_draw(&m, &camera, &options);
    assert_int_equal(drawing.count, 12);
    roberts_drawing_free(&drawing);
    model_free(&m);
}

/* An outline is drawn whatever the crease angle; only creases disappear. */
static void outlines_stay(void **state)
{
    roberts_camera camera = preset_camera("iso");
    roberts_hide_options options = roberts_hide_options_default();
    model m = {0};
    (void)state;
    options.crease_degrees = 180;
    model_box(&m, (roberts_vec3){0, 0, 0}, (roberts_vec3){1, 2, 3});
    roberts_drawing drawing = model_draw(&m, &camera, &options);
    assert_int_equal(drawing.count, 6);
    for (size_t i = 0; i < drawing.count; i++)
        assert_int_equal(drawing.segment[i].line, ROBERTS_OUTLINE);
    roberts_drawing_free(&drawing);
    model_free(&m);
}

/* ---- what is counted, and what is refused ---------------------------------------------------------------------- */

static void counts_and_lines(void **state)
{
    static const struct {
        const char *view;
        size_t front, back, edge_on, surviving, drawn_with_hidden, outlines, creases, backs, back_outlines;
    } table[] = {
        {"iso", 3, 3, 0, 9, 12, 6, 3, 3, 0},
        {"top", 1, 1, 4, 4, 12, 4, 0, 0, 8},
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_camera camera = preset_camera(table[i].view);
        roberts_hide_options options = with_hidden();
        size_t lines[ROBERTS_BACK_OUTLINE + 1] = {0};
        model m = {0};
        model_box(&m, (roberts_vec3){0, 0, 0}, (roberts_vec3){2, 2, 2});
        roberts_drawing d = model_draw(&m, &camera, &options);
        for (size_t k = 0; k < d.count; k++)
            lines[d.segment[k].line]++;
        assert_int_equal(d.front_faces, table[i].front);
        assert_int_equal(d.back_faces, table[i].back);
        assert_int_equal(d.edge_on_faces, table[i].edge_on);
        assert_int_equal(d.surviving_edges, table[i].surviving);
        assert_int_equal(d.drawn_edges, table[i].drawn_with_hidden);
        assert_int_equal(lines[ROBERTS_OUTLINE], table[i].outlines);
        assert_int_equal(lines[ROBERTS_CREASE], table[i].creases);
        assert_int_equal(lines[ROBERTS_BACK], table[i].backs);
        assert_int_equal(lines[ROBERTS_BACK_OUTLINE], table[i].back_outlines);
        roberts_drawing_free(&d);
        model_free(&m);
    }
}

/* Each group of edges has a stamp of sixteen bits, which repeats after 65,535 groups. Here a bar reaches out from under
 * a plate and gets the stamp of the plate, because the upper edges of the round solids in between are tested one by
 * one. In each bar, two edges are half hidden and one is wholly hidden. */
static void more_groups_than_stamps(void **state)
{
    enum { BARS = 20, BETWEEN = 65535 - BARS, CORNERS = 125, ROUNDS = BETWEEN / CORNERS };
    roberts_camera camera = preset_camera("top");
    roberts_hide_options options = with_hidden();
    size_t half = 0, whole = 0;
    model m = {0};
    (void)state;
    options.threads = 1;
    for (int i = 0; i < BARS; i++)
        model_box(&m, (roberts_vec3){4 * i, 0, 5}, (roberts_vec3){4 * i + 3, 10, 6});
    for (uint32_t i = 0; i < ROUNDS; i++)
        model_round(&m, CORNERS, false, mat3_scale(1, 1, 1), (roberts_vec3){3 * i, -10, 0});
    for (uint32_t i = 0; i < BETWEEN % CORNERS; i++)
        model_box(&m, (roberts_vec3){-20, 2 * i, 0}, (roberts_vec3){-19, 2 * i + 1, 1});
    for (int i = 0; i < BARS; i++)
        model_box(&m, (roberts_vec3){4 * i + 1, 8, 0}, (roberts_vec3){4 * i + 2, 12, 1});
    roberts_drawing d = model_draw(&m, &camera, &options);
    for (size_t i = 0; i < d.count; i++) {
        const roberts_segment *s = &d.segment[i];
        if (s->solid < m.solids - BARS || s->state != ROBERTS_HIDDEN || s->line == ROBERTS_BACK ||
            s->line == ROBERTS_BACK_OUTLINE)
            continue;
        assert_int_equal(s->by, s->solid + BARS - m.solids);
        half += s->t1 - s->t0 == 0.5;
        whole += s->t1 - s->t0 == 1;
    }
    assert_int_equal(half, 2 * BARS);
    assert_int_equal(whole, BARS);
    roberts_drawing_free(&d);
    model_free(&m);
}

/* The nine boxes behind the nearest one are culled, one of them after it was mapped. The three behind the eye are not,
 * since nothing hides them. Only the faces of the nearest box are counted. */
static void culled_solids_are_those_hidden(void **state)
{
    roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = {0, 0, 100}, .has_look_at = true};
    roberts_hide_options options = roberts_hide_options_default();
    model m = {0};
    (void)state;
    for (int i = 0; i < 13; i++) {
        double z = i < 10 ? -i : 100 + i;
        model_box(&m, (roberts_vec3){-1, -1, z - 0.5}, (roberts_vec3){1, 1, z});
    }
    roberts_drawing d = model_draw(&m, &camera, &options);
    assert_int_equal(d.solids, 13);
    assert_int_equal(d.culled_solids, 9);
    assert_int_equal(d.front_faces, 1);
    assert_int_equal(d.back_faces, 5);
    roberts_drawing_free(&d);
    model_free(&m);
}

/* The picture's frame and window: relative to the middle of the scene's box, x right, y up. */
static void picture_coordinates(void **state)
{
    roberts_camera camera = preset_camera("front");
    roberts_hide_options options = roberts_hide_options_default();
    model m = {0};
    (void)state;
    model_box(&m, (roberts_vec3){10, 20, 30}, (roberts_vec3){14, 26, 32});
    roberts_drawing d = model_draw(&m, &camera, &options);
    assert_int_equal(d.count, 4);
    assert_true(d.window_min.x == -2 && d.window_max.x == 2 && d.window_min.y == -1 && d.window_max.y == 1);
    const roberts_segment *s = &d.segment[0]; /* 0-1: along x, below */
    assert_true(s->v0 == 0 && s->v1 == 1);
    assert_true(s->p0.x == -2 && s->p0.y == -1 && s->p1.x == 2 && s->p1.y == -1);
    roberts_drawing_free(&d);
    model_free(&m);
}

/* A plate thinner than epsilon, seen from the side: all its faces are edge-on, and nothing is drawn. */
static void nothing_to_draw(void **state)
{
    roberts_camera camera = preset_camera("front");
    roberts_hide_options options = roberts_hide_options_default();
    model m = {0};
    (void)state;
    options.epsilon = 1e-6;
    model_box(&m, (roberts_vec3){0, 0, 0}, (roberts_vec3){1, 1, 0x1p-21});
    roberts_drawing d = model_draw(&m, &camera, &options);
    assert_int_equal(d.count, 0);
    assert_int_equal(d.drawn_edges, 0);
    assert_int_equal(d.edge_on_faces, 6);
    assert_true(d.window_min.x <= d.window_max.x && d.window_min.y <= d.window_max.y);
    roberts_drawing_free(&d);
    options.epsilon = 1e-7; /* now it is wide enough for an outline */
    d = model_draw(&m, &camera, &options);
    assert_int_equal(d.count, 4);
    roberts_drawing_free(&d);
    model_free(&m);
}

static void arguments_refused(void **state)
{
    static const struct {
        const char *name;
        roberts_hide_options options;
        roberts_status status;
    } table[] = {
        {"defaults", {.crease_degrees = 0.1}, ROBERTS_OK},
        {"crease below 0", {.crease_degrees = -1e-9}, ROBERTS_BAD_ARGUMENT},
        {"crease above 180", {.crease_degrees = 180.1}, ROBERTS_BAD_ARGUMENT},
        {"crease no number", {.crease_degrees = NAN}, ROBERTS_BAD_ARGUMENT},
        {"epsilon below 0", {.epsilon = -1e-9}, ROBERTS_BAD_ARGUMENT},
        {"epsilon infinite", {.epsilon = INFINITY}, ROBERTS_BAD_ARGUMENT},
        {"epsilon no number", {.epsilon = NAN}, ROBERTS_BAD_ARGUMENT},
        {"epsilon larger than the scene", {.epsilon = 1}, ROBERTS_BAD_ARGUMENT},
        {"grid too fine", {.grid = 1u << 20}, ROBERTS_BAD_ARGUMENT},
        {"too many threads", {.threads = 1u << 20}, ROBERTS_BAD_ARGUMENT},
    };
    roberts_camera camera = preset_camera("iso");
    model m = {0};
    (void)state;
    model_box(&m, (roberts_vec3){0, 0, 0}, (roberts_vec3){1, 1, 1});
    roberts_scene *scene = model_build(&m);
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_drawing d = {.count = 77};
        roberts_error error = {0};
        roberts_status status = roberts_hide(scene, &camera, &table[i].options, &d, &error);
        if (status != table[i].status || error.status != status || (status != ROBERTS_OK) != (error.message[0] != '\0'))
            fail_msg("%s: status %d, message \"%s\"", table[i].name, status, error.message);
        assert_true(status == ROBERTS_OK || (d.count == 0 && !d.segment));
        roberts_drawing_free(&d);
        assert_int_equal(roberts_hide(scene, &camera, &table[i].options, &d, NULL), status);
        roberts_drawing_free(&d);
    }
    roberts_drawing_free(NULL);
    roberts_scene_free(scene);
    model_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes_by_table),
        cmocka_unit_test(boxes_seen_obliquely),
        cmocka_unit_test(edge_under_a_corner_of_four),
        cmocka_unit_test(outlines_that_are_not_convex),
        cmocka_unit_test(face_with_a_dent),
        cmocka_unit_test(edges_that_end_in_a_sliver),
        cmocka_unit_test(edge_beyond_a_sharp_tip),
        cmocka_unit_test(border_that_runs_nearly_along),
        cmocka_unit_test(borders_at_flat_angles),
        cmocka_unit_test(pierced_planes_in_any_order),
        cmocka_unit_test(perspective_by_hand),
        cmocka_unit_test(near_plane_by_hand),
        cmocka_unit_test(side_that_weaves_through_the_near_plane),
        cmocka_unit_test(cap_whose_border_is_upright_within_rounding),
        cmocka_unit_test(cap_that_begins_in_the_middle_of_its_border),
        cmocka_unit_test(field_of_view),
        cmocka_unit_test(eyes_refused),
        cmocka_unit_test(eyes_very_near),
        cmocka_unit_test(eyes_on_a_face),
        cmocka_unit_test(box_buried_in_a_slab_under_the_eye),
        cmocka_unit_test(flat_edges_by_table),
        cmocka_unit_test(cut_cube),
        cmocka_unit_test(outlines_stay),
        cmocka_unit_test(counts_and_lines),
        cmocka_unit_test(more_groups_than_stamps),
        cmocka_unit_test(names_left_out),
        cmocka_unit_test(culled_solids_are_those_hidden),
        cmocka_unit_test(picture_coordinates),
        cmocka_unit_test(nothing_to_draw),
        cmocka_unit_test(arguments_refused),
    };
    return cmocka_run_group_tests_name("scenes drawn by hand", tests, NULL, NULL);
}
