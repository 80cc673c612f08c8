/* Polygons of very many corners: tests 2 to 4 by runs of sides give the same as testing every side, to the last bit. */
#include "hide/runs.h"
#include "bare_points.h"
#include "scenes.h"

#define EPSILON 1e-10
#define ROUNDING 4e-15
#define EXTENT 40.0

enum { CORNERS = 3000, EDGES_OF_EACH = 300 };

static const double two_pi = 6.283185307179586;

/* Kinds of polygons. */
typedef enum kind {
    ELLIPSE,   /* regular, then pressed flat */
    WHOLE,     /* its corners are integers: edges between such points often pass through them */
    COLLINEAR, /* a square of which each side has many corners */
    HALF,      /* half a disc: one long side */
    DENTED,    /* corners moved by up to a millionth */
    ROUGH,     /* ... by up to a hundredth: not convex at all */
    HAIRS,     /* pairs of corners that are nearer than epsilon */
    KINDS
} kind;

typedef struct fixture {
    roberts_vec3 P[CORNERS + 2];
    uint32_t corner[CORNERS];
    hide_space space;
    hide_face face;
    hide_edge edge;
    runs *r;
} fixture;

/* Primitive vectors with components up to `most`, by angle: the sides of a convex polygon. Returns their number. */
static uint32_t whole_polygon(roberts_vec3 *P, int most)
{
    int x = 0, y = -3 * most * most, a = 1, b = 0;
    uint32_t count = 0;
    for (int quarter = 0; quarter < 4; quarter++) { /* each from (1, 0), turned, to before (0, 1): Farey's sequence */
        int p = 0, q = 1, r = 1, s = most;          /* slopes p/q < 1, then the mirror images */
        int side[CORNERS][2], sides = 0;
        while (q > 0 && !(p == 1 && q == 1)) {
            side[sides][0] = q;
            side[sides++][1] = p;
            int k = (most + q) / s, t = k * r - p, u = k * s - q;
            p = r;
            q = s;
            r = t;
            s = u;
        }
        side[sides][0] = side[sides][1] = 1;
        for (int i = sides - 1; i > 0; i--) {
            side[2 * sides - i][0] = side[i][1];
            side[2 * sides - i][1] = side[i][0];
        }
        for (int i = 0; i < 2 * sides; i++) {
            P[count++] = (roberts_vec3){x, y, 0.0};
            x += a * side[i][0] - b * side[i][1];
            y += b * side[i][0] + a * side[i][1];
        }
        int turned = a;
        a = -b;
        b = turned;
    }
    return count;
}

static roberts_vec3 on_square(uint32_t i, uint32_t count)
{
    uint32_t part = count / 4, side = i / part < 3 ? i / part : 3;
    double t = 4.0 * (i - side * part) / (side < 3 ? part : count - 3 * part) - 2.0;
    const roberts_vec3 at[4] = {{t, -2, 0}, {2, t, 0}, {-t, 2, 0}, {-2, -t, 0}};
    return at[side];
}

static double noise(rng *r, kind k)
{
    return k == DENTED ? rng_between(r, -1e-6, 1e-6) : k == ROUGH ? rng_between(r, -1e-2, 1e-2) : 0.0;
}

static void set_polygon(fixture *f, rng *r, kind k)
{
    uint32_t count = (uint32_t)(rng_int(r, 0, 3) ? rng_int(r, RUNS_CORNERS + 1, 300) : rng_int(r, 300, CORNERS));
    double w = rng_between(r, 0.01, 3.0), h = rng_between(r, 0.01, 3.0), arc = k == HALF ? two_pi / 2 : two_pi;
    roberts_vec3 P[CORNERS];
    if (k == WHOLE)
        count = whole_polygon(P, rng_int(r, 5, 12));
    for (uint32_t i = 0; i < count && k != WHOLE; i++) {
        uint32_t at = k == HAIRS ? i - i % 2 : i;
        double angle = arc * at / count + (at == i ? 0.0 : 0.4 * EPSILON), m = 1.0 + noise(r, k);
        P[i] = k == COLLINEAR ? on_square(i, count) : (roberts_vec3){w * m * cos(angle), h * m * sin(angle), 0.0};
    }
    rng_permutation(r, f->corner, count);
    for (uint32_t i = 0; i < count; i++)
        f->P[f->corner[i]] = P[i];
    f->face = (hide_face){.corner = f->corner, .count = count};
    double extent = k == WHOLE ? 4000.0 : EXTENT;
    f->space = bare_space(f->P, EPSILON * extent, ROUNDING * extent, extent);
    f->r = runs_make(&f->space, f->corner, count);
    assert_non_null(f->r);
}

/* A point anywhere; a corner, or just beside it; on a side, or just beside it; near the middle. */
static roberts_vec3 place(const fixture *f, rng *r, kind k)
{
    uint32_t i = (uint32_t)rng_int(r, 0, (int)f->face.count - 1);
    roberts_vec3 P = f->P[f->corner[i]], Q = f->P[f->corner[i + 1 < f->face.count ? i + 1 : 0]];
    double size = k == WHOLE ? 900.0 : 3.0, by = (rng_int(r, -2, 2)) * 0.6 * f->space.epsilon;
    double t = rng_int(r, -8, 12) / 4.0;
    switch (rng_int(r, 0, 4)) {
    case 0:
        return (roberts_vec3){P.x + by, P.y - by, 0.0};
    case 1:
        return (roberts_vec3){P.x + t * (Q.x - P.x), P.y + t * (Q.y - P.y) + by, 0.0};
    case 2:
        return (roberts_vec3){rng_between(r, 0.0, 0.1) * P.x, rng_between(r, 0.0, 0.1) * P.y, 0.0};
    case 3:
        if (k == WHOLE)
            return (roberts_vec3){rng_int(r, -500, 500), rng_int(r, -500, 500), 0.0};
        /* fall through */
    default:
        return (roberts_vec3){rng_between(r, -size, size), rng_between(r, -size, size), 0.0};
    }
}

/* Between two such places; end-on; or along a side, in its line. */
static void set_edge(fixture *f, rng *r, kind k)
{
    uint32_t count = f->face.count, a = count, b = count + 1, i = (uint32_t)rng_int(r, 0, (int)count - 2);
    roberts_vec3 P = f->P[f->corner[i]], Q = f->P[f->corner[i + 1]];
    f->P[a] = place(f, r, k);
    f->P[b] = rng_int(r, 0, 19) ? place(f, r, k) : f->P[a];
    if (rng_int(r, 0, 5) == 0) {
        double s = rng_int(r, -4, 2), t = rng_int(r, 1, 5);
        f->P[a] = (roberts_vec3){P.x + s * (Q.x - P.x), P.y + s * (Q.y - P.y), 0.0};
        f->P[b] = (roberts_vec3){P.x + t * (Q.x - P.x), P.y + t * (Q.y - P.y), 0.0};
    }
    f->edge = bare_edge(f->P, a, b);
}

/* The same to the last bit; where several sides are a straight one, to less than a quarter of epsilon. */
static bool same_part(const fixture *f, kind k, const hide_interval *a, const hide_interval *b)
{
    double off = fmax(fabs(a->t0 - b->t0), fabs(a->t1 - b->t1)) * f->edge.length;
    return k == COLLINEAR || k == HAIRS ? off <= 0.25 * f->space.epsilon : memcmp(a, b, sizeof *a) == 0;
}

/* The counts are the same. If several sides form a straight one, an end within epsilon of them may be inside one and
 * outside another. Then a different test finds nothing. */
static bool same_tally(kind k, bool found, const roberts_tally *a, const roberts_tally *b)
{
    return ((k == COLLINEAR || k == HAIRS) && !found) || memcmp(a, b, sizeof *a) == 0;
}

static void runs_find_what_all_sides_do(void **state)
{
    rng r = {23};
    hide_sides sides = {0};
    static fixture f;
    (void)state;
    assert_true(hide_sides_reserve(&sides, CORNERS));
    for (kind k = 0; k < KINDS; k++) {
        roberts_tally outcomes = {0};
        for (int i = 0; i < 100; i++) {
            set_polygon(&f, &r, k);
            for (int e = 0; e < EDGES_OF_EACH; e++) {
                hide_interval part = {0}, other = {0};
                set_edge(&f, &r, k);
                sides.tally = (roberts_tally){0};
                bool found = hide_by_runs(&f.space, f.r, &f.face, &f.edge, &sides, &part);
                roberts_tally tally = sides.tally;
                sides.tally = (roberts_tally){0};
                bool hidden = bare_tests_2_to_4(&f.space, &f.face, &f.edge, &sides, &other);
                if (found != hidden || !same_tally(k, found, &tally, &sides.tally) ||
                    (found && !same_part(&f, k, &part, &other)))
                    fail_msg("kind %d, %u corners, polygon %d, edge %d: %d %.17g %.17g instead of %d %.17g %.17g",
                             (int)k, f.face.count, i, e, found, part.t0, part.t1, hidden, other.t0, other.t1);
                outcomes.test2_visible += tally.test2_visible;
                outcomes.test3_visible += tally.test3_visible;
                outcomes.test3_invisible += tally.test3_invisible;
                outcomes.test4 += tally.test4;
            }
            free(f.r);
        }
        if (outcomes.test2_visible < 100 || outcomes.test3_visible < 100 || outcomes.test3_invisible < 100 ||
            outcomes.test4 < 100)
            fail_msg("kind %d: %zu, %zu, %zu and %zu of the outcomes", (int)k, outcomes.test2_visible,
                     outcomes.test3_visible, outcomes.test3_invisible, outcomes.test4);
    }
    free(sides.H);
}

/* ---- scenes ---------------------------------------------------------------------------------------------------- */

/* Prisms and double pyramids of 65 to 128 corners lying over one another and through one another, and boxes among them;
 * half of the scenes are rounded to five digits, so that polygons are not quite convex. */
static void make_coins(model *m, uint64_t seed)
{
    rng r = {seed};
    for (int i = 0; i < 12; i++) {
        double radius = rng_between(&r, 1.0, 3.0), high = rng_between(&r, 0.01, 0.5), lean = rng_between(&r, -1.0, 1.0);
        mat3 map = {{radius, 0, i % 4 == 3 ? lean : 0}, {0, radius, 0}, {0, 0, high}};
        roberts_vec3 at = {rng_between(&r, -2.0, 2.0), rng_between(&r, -2.0, 2.0), 0.5 * i};
        model_round(m, (uint32_t)rng_int(&r, RUNS_CORNERS + 1, MODEL_CORNERS), i % 5 == 4, map, at);
    }
    for (int i = 0; i < 30; i++) {
        roberts_vec3 at = {rng_between(&r, -4.0, 4.0), rng_between(&r, -4.0, 4.0), rng_between(&r, -1.0, 6.0)};
        model_box(m, at, vec3_add(at, (roberts_vec3){1, rng_between(&r, 0.1, 1.0), 0.5}));
    }
    if (seed % 2)
        model_to_digits(m, 5);
}

static void expect_same(const roberts_drawing *a, const roberts_drawing *b, uint64_t seed, uint32_t grid)
{
    if (a->count != b->count)
        fail_msg("scene %d, grid %u: %zu segments, not %zu", (int)seed, grid, b->count, a->count);
    for (size_t i = 0; i < a->count; i++) {
        const roberts_segment *s = &a->segment[i], *t = &b->segment[i];
        if (s->v0 != t->v0 || s->v1 != t->v1 || s->t0 != t->t0 || s->t1 != t->t1 || s->state != t->state ||
            s->by != t->by)
            fail_msg("scene %d, grid %u: %u-%u %.17g %.17g is not %u-%u %.17g %.17g", (int)seed, grid, t->v0, t->v1,
                     t->t0, t->t1, s->v0, s->v1, s->t0, s->t1);
    }
}

static void any_grid_draws_the_same(void **state)
{
    static const uint32_t grids[] = {1, 3, 50};
    static const roberts_camera cameras[] = {
        {.dir = {0, 0, 1}, .up = {0, 1, 0}},
        {.dir = {1, 2, 3}},
        {.dir = {0, 0, -1}, .up = {0, 1, 0}},
        {ROBERTS_PERSPECTIVE, .eye = {3, -4, 20}},
        {ROBERTS_PERSPECTIVE, .eye = {5, -6, 5}, .look_at = {0, 0, 2}, .has_look_at = true, .near_distance = 7},
    };
    (void)state;
    for (uint64_t seed = 0; seed < 20; seed++) {
        model m = {0};
        roberts_hide_options options = roberts_hide_options_default();
        const roberts_camera *camera = &cameras[seed % (sizeof cameras / sizeof cameras[0])];
        make_coins(&m, seed);
        options.keep_hidden = seed % 4 < 2;
        roberts_drawing drawing = model_draw(&m, camera, &options);
        assert_true(drawing.count > 100);
        for (size_t i = 0; i < sizeof grids / sizeof grids[0]; i++) {
            options.grid = grids[i];
            options.threads = (uint32_t)i + 1;
            roberts_drawing other = model_draw(&m, camera, &options);
            expect_same(&drawing, &other, seed, grids[i]);
            roberts_drawing_free(&other);
        }
        roberts_drawing_free(&drawing);
        model_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runs_find_what_all_sides_do),
        cmocka_unit_test(any_grid_draws_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
