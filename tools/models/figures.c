/* figures.c - models for figures. See figures.h. */
#include "figures.h"

#include "exact.h"
#include "stand.h"
#include "uniform.h"

static const motion unmoved = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

static motion scaled(double scale, roberts_vec3 shift)
{
    return (motion){{{scale, 0, 0}, {0, scale, 0}, {0, 0, scale}}, shift};
}

/* Adds the parallelepiped from p along a, b, c, whose determinant is positive. */
static void add_parallelepiped(body *to, roberts_vec3 p, roberts_vec3 a, roberts_vec3 b, roberts_vec3 c)
{
    body box = {0};
    body_box(&box, vec3(0, 0, 0), vec3(1, 1, 1));
    body_add(to, &box, (motion){{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}}, p});
    body_free(&box);
}

/* ---- a chair --------------------------------------------------------------------------------------------------- */

/* Adds a box above the seat, where everything leans back by 1 in 8. */
static void add_leaning(body *b, roberts_vec3 lo, roberts_vec3 hi)
{
    const double seat = 45, lean = 1.0 / 8;
    add_parallelepiped(b, vec3(lo.x, lo.y + lean * (lo.z - seat), lo.z), vec3(hi.x - lo.x, 0, 0),
                       vec3(0, hi.y - lo.y, 0), vec3(0, lean * (hi.z - lo.z), hi.z - lo.z));
}

void chair(body *b)
{
    for (int i = 0; i < 2; i++) {
        double x = 40 * i;
        body_box(b, vec3(x, 0, 0), vec3(x + 4, 4, 42));
        body_box(b, vec3(x, 38, 0), vec3(x + 4, 42, 45));
        add_leaning(b, vec3(x, 38, 45), vec3(x + 4, 42, 93));
        body_box(b, vec3(x + 1, 4, 35), vec3(x + 3, 38, 42)); /* under the seat, and near the floor */
        body_box(b, vec3(x + 1, 4, 14), vec3(x + 3, 38, 17));
    }
    body_box(b, vec3(0, 0, 42), vec3(44, 38, 45));
    body_box(b, vec3(4, 1, 35), vec3(40, 3, 42));
    body_box(b, vec3(4, 39, 35), vec3(40, 41, 42));
    body_box(b, vec3(3, 20, 14), vec3(41, 22, 17));
    for (int i = 0; i < 3; i++)
        add_leaning(b, vec3(4, 39, 59 + 12 * i), vec3(40, 41, 66 + 12 * i));
}

/* ---- a staircase ----------------------------------------------------------------------------------------------- */

enum { STEPS_A_TURN = 16, STEPS = 26 };

static const double step_rise = 1.25, step_thick = 0.375, column_radius = 1.5, step_radius = 7;

static roberts_vec3 round_point(uint64_t k, uint64_t n, double radius, double z)
{
    roberts_vec2 p = circle_point(k, n);
    return vec3(radius * p.x, radius * p.y, z);
}

/* Adds a step, from side k of the column outward. */
static void add_step(body *b, uint32_t k, double z)
{
    uint32_t base = (uint32_t)b->vertex_count;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 4; j++) {
            uint32_t around = k + (j == 1 || j == 2 ? 0 : 1);
            roberts_vec3 p =
                round_point(around, STEPS_A_TURN, j < 2 ? column_radius : step_radius, z - step_thick * (1 - i));
            body_vertex(b, p.x, p.y, p.z);
        }
    body_face(b, (uint32_t[]){base + 4, base + 5, base + 6, base + 7}, 4);
    body_face(b, (uint32_t[]){base + 3, base + 2, base + 1, base}, 4);
    for (uint32_t i = 0; i < 4; i++) {
        uint32_t j = (i + 1) % 4;
        body_face(b, (uint32_t[]){base + i, base + j, base + 4 + j, base + 4 + i}, 4);
    }
}

/* Returns the top of the post on step k: in the middle of the step, near its outer side. */
static roberts_vec3 post_top(uint32_t k)
{
    return round_point(2 * k + 1, 2 * STEPS_A_TURN, step_radius - 0.5, step_rise * (k + 1) + 5);
}

void spiral_staircase(body *b)
{
    const double post = 0.125, rail = 0.25; /* half widths */
    body part = {0};
    column_make(&part, 2 * STEPS_A_TURN, step_radius + 2, -0.5, 0);
    column_make(&part, STEPS_A_TURN, column_radius, 0, step_rise * STEPS + 3);
    body_add(b, &part, unmoved);
    body_free(&part);
    for (uint32_t k = 0; k < STEPS; k++) {
        roberts_vec3 top = post_top(k);
        double floor = step_rise * (k + 1);
        add_step(b, k, floor);
        body_turned_box(b, vec3(top.x - post, top.y - post, floor), vec3(top.x + post, top.y + post, top.z),
                        circle_point(2 * k + 1, 2 * STEPS_A_TURN).x, circle_point(2 * k + 1, 2 * STEPS_A_TURN).y);
    }
    for (uint32_t k = 0; k + 1 < STEPS; k++) {
        roberts_vec3 p = post_top(k), along = vec3_sub(post_top(k + 1), p);
        roberts_vec3 out = vec3_scale(2 * rail, round_point(k + 1, STEPS_A_TURN, 1, 0));
        add_parallelepiped(b, vec3_sub(p, vec3_scale(0.5, out)), out, along, vec3(0, 0, 2 * rail));
    }
}

/* ---- arrangements ---------------------------------------------------------------------------------------------- */

/* Adds a copy of `part`, of size `ratio`, at each corner of it, recursively to depth `level`. */
static void add_flake(body *b, const body *part, double ratio, int level, motion at)
{
    if (level == 0) {
        body_add(b, part, at);
        return;
    }
    for (size_t i = 0; i < part->vertex_count; i++) {
        roberts_vec3 corner = vec3_scale(at.m[0][0] * (1 - ratio), part->vertex[i]);
        add_flake(b, part, ratio, level - 1, scaled(ratio * at.m[0][0], vec3_add(at.shift, corner)));
    }
}

void octahedra(body *b)
{
    body part = {0};
    uniform_make(&part, OCTAHEDRON);
    add_flake(b, &part, 0.5, 3, scaled(8, vec3(0, 0, 0)));
    body_free(&part);
}

void icosahedra(body *b)
{
    body part = {0};
    uniform_make(&part, ICOSAHEDRON);
    add_flake(b, &part, (3 - sqrt(5)) / 2, 2, unmoved);
    body_free(&part);
}

void cubic_space(body *b)
{
    const int n = 4;
    const double cube = 0.75, bar = 0.25, apart = 4;
    for (int i = 0; i < n * n * n; i++) {
        roberts_vec3 p = {apart * (i % n), apart * (i / n % n), apart * (i / n / n)};
        body_box(b, vec3_sub(p, vec3(cube, cube, cube)), vec3_add(p, vec3(cube, cube, cube)));
        if (i % n + 1 < n)
            body_box(b, vec3_add(p, vec3(cube, -bar, -bar)), vec3_add(p, vec3(apart - cube, bar, bar)));
        if (i / n % n + 1 < n)
            body_box(b, vec3_add(p, vec3(-bar, cube, -bar)), vec3_add(p, vec3(bar, apart - cube, bar)));
        if (i / n / n + 1 < n)
            body_box(b, vec3_add(p, vec3(-bar, -bar, cube)), vec3_add(p, vec3(bar, bar, apart - cube)));
    }
}

/* ---- plates of solids ------------------------------------------------------------------------------------------ */

static double circumradius(int solid)
{
    body part = {0};
    uniform_make(&part, solid);
    double radius = vec3_length(part.vertex[0]);
    body_free(&part);
    return radius;
}

void platonic_solids(body *b)
{
    static const struct {
        int solid;
        size_t corners; /* of a face */
    } row[] = {{TETRAHEDRON, 3}, {CUBE, 4}, {OCTAHEDRON, 3}, {DODECAHEDRON, 5}, {ICOSAHEDRON, 3}};
    const double apart = 10, radius = 4;
    body_box(b, vec3(-6, -5, -1), vec3(46, 5, 0));
    for (int i = 0; i < 5; i++)
        stand_uniform(b, row[i].solid, row[i].corners, radius / circumradius(row[i].solid), vec3(apart * i, 0, 0),
                      half_angle(0.375));
}

/* In three rows, one above the other. */
void archimedean_solids(body *b)
{
    static const int first[] = {0, 4, 9, 13}; /* first index of each row, and the end */
    for (int row = 0; row < 3; row++)
        for (int i = first[row]; i < first[row + 1]; i++) {
            body part = {0};
            int count = first[row + 1] - first[row];
            double x = 2.375 * (i - first[row]) - 2.375 * (count - 1) / 2;
            uniform_make(&part, PLATONIC_COUNT + i);
            body_add(b, &part, scaled(1 / circumradius(PLATONIC_COUNT + i), vec3(x, 0, -2.25 * row)));
            body_free(&part);
        }
}
