/* test_face_pieces.c - faces of any shape, cut into convex pieces: the pieces tile the region that the border winds
 * round, whatever the rounding. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/orient.h"
#include "base/search.h"
#include "base/sort.h"
#include "base/vec.h"
#include "model/face_pieces.h"
#include "rng.h"
#include "testing.h"

enum { MOST_CORNERS = 64 };

/* Corners in the plane z = 0 unless z is given. */
typedef struct face_case {
    const char *name;
    uint32_t count;
    roberts_vec3 point[12];
    uint32_t corner[12]; /* all 0: 0, 1, 2 ... */
    double area;         /* of all pieces */
    uint32_t pieces;     /* 0: not compared */
    bool even_odd, not_planar;
} face_case;

static const face_case cases[] = {
    {"a square", 4, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0}, 1, 1, false, false},
    {"an L", 6, {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {0}, 3, 2, false, false},
    {"an L the other way round",
     6,
     {{0, 2, 0}, {1, 2, 0}, {1, 1, 0}, {2, 1, 0}, {2, 0, 0}, {0, 0, 0}},
     {0},
     3,
     2,
     false,
     false},
    {"a corner in a straight side",
     5,
     {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}},
     {0},
     2,
     1,
     false,
     false},
    {"a bow-tie", 4, {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}, {0}, 2, 2, false, false},
    {"a pentagram", 5, {{0, 3, 0}, {2, -3, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -3, 0}}, {0}, 0, 0, false, false},
    {"a spike that runs out and back bounds nothing",
     5,
     {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {3, 3, 0}},
     {0, 1, 2, 4, 2, 3},
     4,
     1,
     false,
     false},
    {"a slit to a hole",
     8,
     {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}},
     {0, 1, 2, 3, 0, 4, 5, 6, 7, 4},
     8,
     0,
     false,
     false},
    {"a slit whose two sides have corners of their own",
     10,
     {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}},
     {0},
     8,
     0,
     false,
     false},
    {"a slit inward that ends",
     5,
     {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}},
     {0, 1, 2, 3, 0, 4},
     16,
     1,
     false,
     false},
    {"a border twice round",
     4,
     {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
     {0, 1, 2, 3, 0, 1, 2, 3},
     1,
     1,
     false,
     false},
    {"... by the rule of odd numbers",
     4,
     {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
     {0, 1, 2, 3, 0, 1, 2, 3},
     0,
     0,
     true,
     false},
    {"two squares that share a corner",
     7,
     {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
     {0, 1, 2, 4, 5, 6, 2, 3},
     2,
     2,
     false,
     false},
    {"a corner touches a side",
     6,
     {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {3, 2, 0}, {2, 0, 0}, {0, 2, 0}},
     {0},
     5,
     0,
     false,
     false},
    {"sides that lie on one another in part",
     8,
     {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {3, 2, 0}, {3, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}},
     {0},
     4,
     2,
     false,
     false},
    {"a side runs back beyond its beginning",
     5,
     {{0, 0, 0}, {2, 0, 0}, {-1, 0, 0}, {-1, 2, 0}, {2, 2, 0}},
     {0},
     4,
     0,
     false,
     false},
    {"three sides through one point",
     6,
     {{-2, 0, 0}, {2, 0, 0}, {1, 2, 0}, {-1, -2, 0}, {1, -2, 0}, {-1, 2, 0}},
     {0},
     0,
     0,
     false,
     false},
    {"the inner square winds twice",
     8,
     {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
     {0, 1, 2, 3, 0, 4, 5, 6, 7, 4},
     9,
     0,
     false,
     false},
    {"... which is a hole by the rule of odd numbers",
     8,
     {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
     {0, 1, 2, 3, 0, 4, 5, 6, 7, 4},
     8,
     0,
     true,
     false},
    {"all corners on a line: no piece", 4, {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}}, {0}, 0, 0, false, false},
    {"a quadrilateral that leaves its plane", 4, {{0, 0, 0}, {2, 0, 0}, {2, 1, 1}, {0, 1, 0}}, {0}, 2, 2, false, true},
    {"a concave face that leaves its plane",
     6,
     {{0, 0, 0}, {2, 0, 0.5}, {2, 1, 0}, {1, 1, 0.5}, {1, 2, 0}, {0, 2, 0.5}},
     {0},
     3,
     4,
     false,
     true},
    {"a bow-tie a little off its plane, which its areas do not tell",
     4,
     {{0, 0, 0}, {2, 2, 1e-5}, {2, 0, 0}, {0, 2, 0}},
     {0},
     2,
     2,
     false,
     false},
};

static double sum_of_areas(const face_pieces *f)
{
    double sum = 0.0;
    for (size_t p = 0; p < f->piece_count; p++)
        for (uint32_t i = 1; i + 1 < f->piece[p].count; i++)
            sum += 0.5 * orient2d(f->node[f->piece[p].node[0]].at, f->node[f->piece[p].node[i]].at,
                                  f->node[f->piece[p].node[i + 1]].at);
    return sum;
}

/* Every piece is convex, and no two pieces lie on the same side of one edge. */
static void require_sound(const face_pieces *f, const char *name)
{
    size_t count = 0;
    uint64_t *side = malloc((f->piece_count * PIECE_CORNERS + 1) * sizeof *side);
    assert_non_null(side);
    for (size_t p = 0; p < f->piece_count; p++) {
        const face_piece *own = &f->piece[p];
        assert_in_range(own->count, 3, PIECE_CORNERS);
        for (uint32_t i = 0; i < own->count; i++) {
            uint32_t a = own->node[i], b = own->node[(i + 1) % own->count], c = own->node[(i + 2) % own->count];
            if (orient2d(f->node[a].at, f->node[b].at, f->node[c].at) < 0.0)
                fail_msg("%s: piece %zu is not convex", name, p);
            side[count++] = (uint64_t)a << 32 | b;
        }
    }
    qsort(side, count, sizeof *side, compare_u64);
    for (size_t i = 1; i < count; i++)
        if (side[i] == side[i - 1])
            fail_msg("%s: two pieces lie on the same hand of one side", name);
    for (size_t i = 0; i < f->side_count; i++)
        assert_in_range(f->side[i].piece, 0, f->piece_count - 1);
    free(side);
}

/* How often the border winds round P; false if P is near to it. */
static bool wind(const roberts_vec2 *at, uint32_t count, roberts_vec2 P, int *winding)
{
    *winding = 0;
    for (uint32_t i = 0; i < count; i++) {
        roberts_vec2 a = at[i], b = at[(i + 1) % count];
        const double turn = orient2d(a, b, P), dx = b.x - a.x, dy = b.y - a.y;
        if (turn * turn <= 1e-12 * (dx * dx + dy * dy) && P.x > fmin(a.x, b.x) - 1e-6 && P.x < fmax(a.x, b.x) + 1e-6 &&
            P.y > fmin(a.y, b.y) - 1e-6 && P.y < fmax(a.y, b.y) + 1e-6)
            return false;
        if (a.y <= P.y && b.y > P.y && turn > 0.0)
            ++*winding;
        else if (a.y > P.y && b.y <= P.y && turn < 0.0)
            --*winding;
    }
    return true;
}

static size_t pieces_at(const face_pieces *f, roberts_vec2 P)
{
    size_t count = 0;
    for (size_t p = 0; p < f->piece_count; p++) {
        const face_piece *own = &f->piece[p];
        bool inside = true;
        for (uint32_t i = 0; i < own->count && inside; i++)
            inside = orient2d(f->node[own->node[i]].at, f->node[own->node[(i + 1) % own->count]].at, P) > 0.0;
        count += inside;
    }
    return count;
}

static rng random_state;

static double any(void)
{
    return rng_between(&random_state, 0.0, 1.0);
}

/* Points of the plane lie in one piece if the border winds round them, otherwise in none. */
static void require_tiling(const face_pieces *f, const roberts_vec2 *at, uint32_t count, bool even_odd,
                           const char *name)
{
    roberts_vec2 low = at[0], high = at[0];
    for (uint32_t i = 0; i < count; i++) {
        low = (roberts_vec2){fmin(low.x, at[i].x), fmin(low.y, at[i].y)};
        high = (roberts_vec2){fmax(high.x, at[i].x), fmax(high.y, at[i].y)};
    }
    for (int k = 0; k < 50; k++) {
        roberts_vec2 P = {low.x + any() * (high.x - low.x), low.y + any() * (high.y - low.y)};
        int winding;
        if (!wind(at, count, P, &winding))
            continue;
        size_t found = pieces_at(f, P), expected = even_odd ? winding & 1 : winding != 0;
        if (found > expected || (found < expected && fabs(f->fit.width) > 1e-5))
            fail_msg("%s: %.17g %.17g lies in %zu pieces, and the border winds round it %d times", name, P.x, P.y,
                     found, winding);
    }
}

static void cases_have_their_area(void **unused)
{
    face_pieces f = {0};
    (void)unused;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        const face_case *c = &cases[k];
        uint32_t corner[12], count = 0;
        for (uint32_t i = 0; i < 12; i++)
            count = c->corner[i] ? i + 1 : count;
        bool listed = count > 0;
        /* a list may end in corner 0 only if it is the first one again, which counts once */
        for (uint32_t i = 0; i < 12; i++)
            corner[i] = listed ? c->corner[i] : i;
        count = listed ? count : c->count;
        face_rules rules = {c->point, 1e-5, 1e-11, 1e-11, 1.0, c->even_odd, false};
        assert_true(face_pieces_cut(&f, &rules, corner, count));
        require_sound(&f, c->name);
        double area = sum_of_areas(&f);
        if (c->area > 0.0 && !c->not_planar && fabs(area - c->area) > 1e-9)
            fail_msg("%s: area %.17g instead of %.17g", c->name, area, c->area);
        if (c->pieces && f.piece_count != c->pieces)
            fail_msg("%s: %zu pieces instead of %u", c->name, f.piece_count, c->pieces);
        if (f.planar == c->not_planar && f.piece_count > 0)
            fail_msg("%s: planar is %d", c->name, f.planar);
        roberts_vec2 at[12];
        for (uint32_t i = 0; i < count; i++) {
            roberts_vec3 p = c->point[corner[i]];
            at[i] = f.axis == 0   ? (roberts_vec2){f.turned * p.y, p.z}
                    : f.axis == 1 ? (roberts_vec2){f.turned * p.z, p.x}
                                  : (roberts_vec2){f.turned * p.x, p.y};
        }
        require_tiling(&f, at, count, c->even_odd, c->name);
    }
    face_pieces_free(&f);
}

/* Each part of the border is listed once, and lies on the border of its piece. */
static void require_sides(const face_pieces *f, uint32_t count, const char *name)
{
    uint8_t *met = calloc(count, 1);
    assert_non_null(met);
    assert_int_equal(f->side_count, count);
    for (size_t i = 0; i < f->side_count; i++) {
        const piece_side *s = &f->side[i];
        const face_piece *own = &f->piece[s->piece];
        bool along = false;
        for (uint32_t k = 0; k < own->count; k++) {
            roberts_vec2 a = f->node[own->node[k]].at, b = f->node[own->node[(k + 1) % own->count]].at;
            double from = orient2d(a, b, f->node[s->from].at), to = orient2d(a, b, f->node[s->to].at);
            if (from < 0.0 || to < 0.0)
                fail_msg("%s: side %u leaves its piece", name, s->side);
            along = along || (from == 0.0 && to == 0.0);
        }
        if (!along || met[s->side]++)
            fail_msg("%s: side %u is listed twice, or inside its piece", name, s->side);
    }
    free(met);
}

/* How many sides of pieces are neither on the border nor sides of another piece? */
static size_t count_lone_sides(const face_pieces *f)
{
    size_t count = 0, lone = 0;
    uint64_t *side = malloc((f->piece_count * PIECE_CORNERS + f->side_count) * sizeof *side);
    assert_non_null(side);
    for (size_t p = 0; p < f->piece_count; p++)
        for (uint32_t i = 0; i < f->piece[p].count; i++)
            side[count++] = (uint64_t)f->piece[p].node[i] << 32 | f->piece[p].node[(i + 1) % f->piece[p].count];
    for (size_t i = 0; i < f->side_count; i++)
        side[count++] = (uint64_t)f->side[i].to << 32 | f->side[i].from;
    qsort(side, count, sizeof *side, compare_u64);
    for (size_t i = 0; i < count; i++) {
        uint64_t back = side[i] << 32 | side[i] >> 32;
        lone += !bsearch(&back, side, count, sizeof *side, compare_u64);
    }
    free(side);
    return lone;
}

/* The profile of a heat sink: each fin is one piece, and so is the plate, unless pieces keep all corners. */
static void straight_corners_are_dropped(void **unused)
{
    enum { FINS = 500, COUNT = 4 * FINS + 4 };
    roberts_vec3 point[COUNT] = {{0, 0, 0}, {0, 5, 0}};
    uint32_t corner[COUNT];
    face_pieces f = {0};
    (void)unused;
    for (uint32_t i = 0; i < 4 * FINS; i++)
        point[i + 2] = (roberts_vec3){i / 2 + 1, (i + 1) / 2 % 2 ? 15 : 5, 0};
    point[COUNT - 2] = (roberts_vec3){2 * FINS + 1, 5, 0};
    point[COUNT - 1] = (roberts_vec3){2 * FINS + 1, 0, 0};
    for (uint32_t i = 0; i < COUNT; i++)
        corner[i] = i;
    for (int keep = 0; keep < 2; keep++) {
        face_rules rules = {point, 1e-5, 1e-9, 1e-9, 1.0, false, keep == 1};
        assert_true(face_pieces_cut(&f, &rules, corner, COUNT));
        require_sound(&f, "heat sink");
        require_sides(&f, COUNT, "heat sink");
        assert_true(fabs(sum_of_areas(&f) - 5.0 * (2 * FINS + 1) - 10.0 * FINS) < 1e-6);
        if (keep)
            assert_int_equal(count_lone_sides(&f), 0);
        else
            assert_int_equal(f.piece_count, FINS + 1);
    }
    face_pieces_free(&f);
}

/* How corners of a random face are chosen. */
enum family { ANYWHERE, ON_A_LATTICE, NEARLY_ON_A_LATTICE, NEARLY_ON_LINES, FAR_AWAY, NEARLY_PLANAR, FAMILIES };

static roberts_vec3 choose_point(enum family family)
{
    roberts_vec3 p = {any(), any(), 0.0};
    if (family == ON_A_LATTICE || family == NEARLY_ON_A_LATTICE) {
        p.x = floor(4 * p.x);
        p.y = floor(4 * p.y);
    }
    if (family == NEARLY_ON_A_LATTICE) {
        p.x += (floor(5 * any()) - 2) * 0x1p-52;
        p.y += (floor(5 * any()) - 2) * 0x1p-52;
    }
    if (family == NEARLY_ON_LINES) {
        p.y = floor(3 * p.y) * p.x + (floor(5 * any()) - 2) * 1e-13;
    }
    p.z = p.x / 3 + p.y / 7;
    if (family == NEARLY_PLANAR)
        p.z += (any() - 0.5) * 2e-6;
    if (family == FAR_AWAY) {
        p.x += 1e6;
        p.y -= 2e6;
    }
    return p;
}

static void random_faces_are_tiled(void **unused)
{
    static const char *const names[] = {"anywhere",        "on a lattice", "nearly on a lattice",
                                        "nearly on lines", "far away",     "nearly planar"};
    face_pieces f = {0};
    (void)unused;
    for (int family = 0; family < FAMILIES; family++)
        for (uint64_t seed = 1; seed <= 400; seed++) {
            roberts_vec3 point[MOST_CORNERS];
            roberts_vec2 at[MOST_CORNERS];
            uint32_t corner[MOST_CORNERS], count;
            char name[64];
            random_state = (rng){seed * 77 + (uint64_t)family};
            count = 3 + (uint32_t)(any() * (seed % 10 ? 9 : 60));
            for (uint32_t i = 0; i < count; i++)
                point[i] = choose_point((enum family)family);
            for (uint32_t i = 0; i < count; i++)
                corner[i] = any() < 0.8 ? i : (uint32_t)(any() * count);
            bool even_odd = any() < 0.3;
            double size = family == FAR_AWAY ? 2e6 : family == ON_A_LATTICE || family == NEARLY_ON_A_LATTICE ? 4 : 1;
            const double touching = fmax(1e-11 * size, 16 * 0x1p-52 * size);
            face_rules rules = {point, 1e-5, touching, touching, 1.0, even_odd, false};
            snprintf(name, sizeof name, "%s, seed %d", names[family], (int)seed);
            assert_true(face_pieces_cut(&f, &rules, corner, count));
            require_sound(&f, name);
            if (f.ring_count < 3 || f.piece_count == 0)
                continue;
            for (uint32_t i = 0; i < count; i++) {
                roberts_vec3 p = point[corner[i]];
                at[i] = f.axis == 0   ? (roberts_vec2){f.turned * p.y, p.z}
                        : f.axis == 1 ? (roberts_vec2){f.turned * p.z, p.x}
                                      : (roberts_vec2){f.turned * p.x, p.y};
            }
            require_tiling(&f, at, count, even_odd, name);
        }
    face_pieces_free(&f);
}

/* A comb, a star and a face that crosses itself everywhere, each with many corners. */
static void large_faces_come_out(void **unused)
{
    enum { MANY = 20000 };
    roberts_vec3 *point = malloc(MANY * sizeof *point);
    uint32_t *corner = malloc(MANY * sizeof *corner);
    face_pieces f = {0};
    face_rules rules = {point, 1e-5, 1e-9, 1e-9, 1.0, false, false};
    (void)unused;
    assert_non_null(point);
    assert_non_null(corner);
    for (uint32_t i = 0; i < MANY; i++) {
        corner[i] = i;
        point[i] = (roberts_vec3){i, i % 2 ? 100 : 1, 0};
    }
    point[0].y = point[MANY - 1].y = 0;
    assert_true(face_pieces_cut(&f, &rules, corner, MANY));
    require_sound(&f, "comb");
    double area = 50.5 * (MANY - 1) - 0.5 - 50.0; /* trapezoids below; the first and the last tooth end at 0 */
    if (fabs(sum_of_areas(&f) - area) > 1e-6 * area)
        fail_msg("comb: area %.17g instead of %.17g", sum_of_areas(&f), area);
    for (uint32_t i = 0; i < MANY; i++) {
        double angle = 2.0 * 3.14159265358979323846 * i / MANY, r = i % 2 ? 2 : 1;
        point[i] = (roberts_vec3){r * cos(angle), r * sin(angle), 0};
    }
    assert_true(face_pieces_cut(&f, &rules, corner, MANY));
    require_sound(&f, "star");
    area = MANY * sin(2.0 * 3.14159265358979323846 / MANY); /* triangles of sides 1 and 2 */
    if (fabs(sum_of_areas(&f) - area) > 1e-6 * area)
        fail_msg("star: area %.17g instead of %.17g", sum_of_areas(&f), area);
    random_state = (rng){5};
    for (uint32_t i = 0; i < MANY; i++)
        point[i] = (roberts_vec3){any(), any(), 0};
    assert_true(face_pieces_cut(&f, &rules, corner, MANY));
    assert_int_equal(f.piece_count, 0); /* too many crossings to cut: its sides become wires */
    face_pieces_free(&f);
    free(point);
    free(corner);
}

/* Lines are inserted and removed; the list stays in order, and the tree finds the lowest. */
static void order_of_lines(void **unused)
{
    enum { LINES = 600 };
    sweep_order order = {0};
    uint32_t list[LINES], count = 0;
    (void)unused;
    assert_true(sweep_order_start(&order, LINES));
    random_state = (rng){1};
    for (uint32_t line = 0; line < LINES; line++) {
        uint32_t at = (uint32_t)(any() * (count + 1)); /* below list[at] */
        sweep_order_insert(&order, line, at > 0 ? list[at - 1] : ROBERTS_NONE);
        memmove(list + at + 1, list + at, (count++ - at) * sizeof *list);
        list[at] = line;
        if (any() < 0.4) {
            uint32_t out = (uint32_t)(any() * count);
            sweep_order_remove(&order, list[out]);
            memmove(list + out, list + out + 1, (--count - out) * sizeof *list);
        }
        uint32_t next = sweep_order_above(&order, ROBERTS_NONE);
        for (uint32_t i = 0; i < count; i++, next = sweep_order_above(&order, next))
            assert_int_equal(next, list[i]);
        assert_int_equal(next, ROBERTS_NONE);
    }
    sweep_order_free(&order);
}

/* Signs of turns that doubles get wrong. */
static void turns_are_exact(void **unused)
{
    (void)unused;
    roberts_vec2 a = {0.5, 0.5}, b = {12, 12}, c = {24, 24};
    for (int i = -3; i <= 3; i++)
        for (int k = -3; k <= 3; k++) {
            roberts_vec2 p = {a.x + i * 0x1p-53, a.y + k * 0x1p-53};
            if (i < 0)
                p.x = a.x + i * 0x1p-54;
            double turn = orient2d(p, b, c), expected = p.y - p.x; /* exact: how far above the diagonal */
            assert_int_equal((turn > 0.0) - (turn < 0.0), (expected > 0.0) - (expected < 0.0));
        }
    /* differences of 1 and 2^-100 */
    assert_true(orient2d((roberts_vec2){0, 0}, (roberts_vec2){1, 0x1p-100}, (roberts_vec2){2, 0x1p-99}) == 0.0);
    assert_true(orient2d((roberts_vec2){0, 0}, (roberts_vec2){1, 0x1p-100}, (roberts_vec2){2, 0x1.8p-99}) > 0.0);
    assert_true(orient2d((roberts_vec2){1, 1}, (roberts_vec2){0, 0x1p-150}, (roberts_vec2){-1, -1}) > 0.0);
}

/* A quadrilateral that is not planar is cut in the same way whichever corner comes first, in both directions, wherever
 * it lies. */
static void quadrilaterals_have_one_diagonal(void **unused)
{
    static const struct {
        roberts_vec3 point[4];
        uint32_t ends; /* sum of the corners of the diagonal: 0 + 2 or 1 + 3 */
    } quads[] = {
        {{{0, 0, 0}, {2, 0, 0}, {2, 1, 1}, {0, 1, 0}}, 4},
        {{{0.3, 0.1, 0.1}, {0.2, 1.1, 0.1}, {0.3, 0.1, 0.7}, {1.1, 0.2, 0.3}},
         2},                                               /* its plane is as near to x as to y */
        {{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}}, 2}, /* diagonals of one length */
        {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 1, 1}}, 4},
    };
    (void)unused;
    for (size_t q = 0; q < sizeof quads / sizeof quads[0]; q++)
        for (uint32_t way = 0; way < 16; way++) {
            roberts_vec3 point[4];
            uint32_t corner[4], sum = 0;
            face_pieces f = {0};
            for (uint32_t i = 0; i < 4; i++) {
                point[i] = vec3_add(quads[q].point[i], (roberts_vec3){way / 8 * 16.0, 0, 0});
                corner[i] = way & 4 ? (way + 4 - i) % 4 : (way + i) % 4;
            }
            const face_rules rules = {point, 1e-9, 1e-9, 1e-9, 1.0, false, false};
            assert_true(face_pieces_cut(&f, &rules, corner, 4));
            assert_int_equal(f.piece_count, 2);
            for (uint32_t i = 0; i < 3; i++) /* both pieces have the ends of the diagonal */
                for (uint32_t k = 0; k < 3; k++)
                    sum += f.piece[0].node[i] == f.piece[1].node[k] ? f.node[f.piece[0].node[i]].vertex : 0;
            assert_int_equal(sum, quads[q].ends);
            face_pieces_free(&f);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quadrilaterals_have_one_diagonal),
        cmocka_unit_test(cases_have_their_area),
        cmocka_unit_test(random_faces_are_tiled),
        cmocka_unit_test(large_faces_come_out),
        cmocka_unit_test(straight_corners_are_dropped),
        cmocka_unit_test(order_of_lines),
        cmocka_unit_test(turns_are_exact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
