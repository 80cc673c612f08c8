/* large.c - scenes of any size, up to millions of solids.
 *
 * Solid `index` of a scene depends only on the scene's arguments and its index, with a random stream of its own. So the
 * writer makes every solid three times (to count, for its vertices, for its faces) and keeps none. Solids of one scene
 * are disjoint or touch in faces, unless the scene says otherwise. */
#include <inttypes.h>

#include "exact.h"
#include "large.h"
#include "models.h"
#include "off.h"
#include "uniform.h"

static uint64_t one_each(uint64_t n)
{
    return n;
}

/* Returns the greatest integer whose square is at most n < 2^52. */
static uint64_t integer_root(uint64_t n)
{
    return (uint64_t)sqrt((double)n);
}

/* ---- lattice --------------------------------------------------------------------------------------------------- */

static uint64_t cube_of(uint64_t n)
{
    return n * n * n;
}

/* Adds a tetrahedron, cube or octahedron within a ball of radius 7/16 in each cell. */
static void lattice_solid(body *b, const plan *p, uint64_t index)
{
    uint64_t n = p->n, x = index % n, y = index / n % n, z = index / n / n;
    rng r = rng_of(p->seed, index);
    int64_t kind = rng_between(&r, 0, 2);
    roberts_vec3 middle = {(double)x + 0.5, (double)y + 0.5, (double)z + 0.5};
    if (kind == 0)
        body_add(b, &p->tetrahedron, rng_turn(&r, 0.25, middle));
    else if (kind == 1)
        body_add(b, &p->cube, rng_turn(&r, 0.25, middle));
    else
        body_add(b, &p->octahedron, rng_turn(&r, 0.4375, middle));
}

/* ---- city ------------------------------------------------------------------------------------------------------ */

/* n x n blocks of 12 x 12 with streets of 4 between them, with four solids in each. */
static uint64_t city_count(uint64_t n)
{
    return 4 * n * n;
}

/* Returns the bounds of the height of buildings in a block: higher near the middle. */
static int64_t city_height(uint64_t n, uint64_t column, uint64_t row)
{
    int64_t dx = 2 * (int64_t)column + 1 - (int64_t)n, dy = 2 * (int64_t)row + 1 - (int64_t)n, N = (int64_t)n;
    return 5 + 22 * N * N / (N * N + 6 * (dx * dx + dy * dy));
}

/* Four storeys, each standing on the one below and set back from its walls. */
static void tower_tier(body *b, rng *r, roberts_vec3 at, int64_t height, uint64_t tier)
{
    double lo = 0, hi = 12, z0 = 0, z1 = 0;
    for (uint64_t i = 0; i <= tier; i++) {
        lo += 0.5 * (double)rng_between(r, 1, i ? 3 : 2);
        hi -= 0.5 * (double)rng_between(r, 1, i ? 3 : 2);
        z0 = z1;
        z1 += (double)rng_between(r, 2 + height / 4, 2 + height / 2);
    }
    body_box(b, vec3_add(at, vec3(lo, lo, z0)), vec3_add(at, vec3(hi, hi, z1)));
}

/* Four houses, or four wings that touch around a courtyard. */
static void quarter(body *b, rng *r, roberts_vec3 at, int64_t height, uint64_t index, bool wings)
{
    static const double house[4][4] = {{0, 0, 5, 5}, {7, 0, 12, 5}, {0, 7, 5, 12}, {7, 7, 12, 12}};
    static const double wing[4][4] = {{0, 0, 9, 3}, {9, 0, 12, 9}, {3, 9, 12, 12}, {0, 3, 3, 12}};
    const double *q = wings ? wing[index] : house[index];
    double z = 0;
    for (uint64_t i = 0; i <= index; i++)
        z = (double)rng_between(r, 2, 2 + height / 2);
    body_box(b, vec3_add(at, vec3(q[0], q[1], 0)), vec3_add(at, vec3(q[2], q[3], z)));
}

/* A low storey over the whole block, with two towers on it, one of which has a pyramid as its roof. */
static void podium_part(body *b, rng *r, roberts_vec3 at, int64_t height, uint64_t index)
{
    double base = (double)rng_between(r, 2, 3), side = (double)rng_between(r, 5, 8);
    double tall = base + (double)rng_between(r, height / 2, height), low = base + (double)rng_between(r, 2, height / 2);
    roberts_vec3 lo[4] = {{0, 0, 0}, {1, 1, base}, {1, 1, tall}, {side + 2, 1, base}};
    roberts_vec3 hi[4] = {{12, 12, base}, {1 + side, 11, tall}, {1 + side, 11, tall + 3}, {11.5, 8, low}};
    if (index == 2)
        body_pyramid(b, vec3_add(at, lo[index]), vec3_add(at, hi[index]));
    else
        body_box(b, vec3_add(at, lo[index]), vec3_add(at, hi[index]));
}

static void city_solid(body *b, const plan *p, uint64_t index)
{
    uint64_t block = index / 4, column = block % p->n, row = block / p->n;
    rng r = rng_of(p->seed, block);
    roberts_vec3 at = {16 * (double)column, 16 * (double)row, 0};
    int64_t height = city_height(p->n, column, row), kind = rng_between(&r, 0, 5);
    if (kind < 2)
        tower_tier(b, &r, at, height, index % 4);
    else if (kind < 4)
        quarter(b, &r, at, height, index % 4, kind == 2);
    else
        podium_part(b, &r, at, height, index % 4);
}

/* The same on a plate 300 times as wide. */
static uint64_t plain_count(uint64_t n)
{
    return city_count(n) + 1;
}

static void plain_solid(body *b, const plan *p, uint64_t index)
{
    double width = 16 * (double)p->n;
    if (index > 0)
        city_solid(b, p, index - 1);
    else
        body_box(b, vec3(-150 * width, -150 * width, -1), vec3(150 * width, 150 * width, 0));
}

/* ---- wall ------------------------------------------------------------------------------------------------------ */

/* Bricks of 4 x 2 x 1 in running bond: courses of `width` whole bricks alternate with courses that have a half brick at
 * each end. The ratio of length to height is about 4 to 3. */
static void wall_solid(body *b, const plan *p, uint64_t index)
{
    uint64_t width = integer_root(p->n / 3), pair, i;
    double x0, x1, z;
    width = width ? width : 1;
    pair = index / (2 * width + 1);
    i = index % (2 * width + 1);
    z = 2 * (double)pair + (i < width ? 0 : 1);
    if (i < width) {
        x0 = 4 * (double)i;
        x1 = x0 + 4;
    } else {
        i -= width;
        x0 = i ? 4 * (double)i - 2 : 0;
        x1 = i < width ? 4 * (double)i + 2 : 4 * (double)width;
    }
    body_box(b, vec3(x0, 0, z), vec3(x1, 2, z + 1));
}

/* ---- heaps ----------------------------------------------------------------------------------------------------- */

/* A plate at a random position, turned about the vertical, above all earlier ones; about nine overlap everywhere. The
 * heap is half as high as wide. */
static void plates_solid(body *b, const plan *p, uint64_t index)
{
    rng r = rng_of(p->seed, index);
    double side = sqrt((double)p->n), x = side * rng_unit(&r), y = side * rng_unit(&r);
    double u = 1 + rng_unit(&r), v = 1 + rng_unit(&r), rise = side / (double)(2 * p->n), z = rise * (double)index;
    roberts_vec2 a = half_angle(2 * rng_unit(&r) - 1);
    body_turned_box(b, vec3(x - u, y - v, z), vec3(x + u, y + v, z + rise / 2), a.x, a.y);
}

/* Boxes stacked on the z axis, turned and of different widths: seen from the top, all are in the same few cells. */
static void stack_solid(body *b, const plan *p, uint64_t index)
{
    rng r = rng_of(p->seed, index);
    double u = 1 + rng_unit(&r), v = 1 + rng_unit(&r), z = (double)index;
    roberts_vec2 a = half_angle(2 * rng_unit(&r) - 1);
    body_turned_box(b, vec3(-u, -v, z), vec3(u, v, z + 0.5), a.x, a.y);
}

/* Sticks as long as the picture, one above the other, in all directions. */
static void needles_solid(body *b, const plan *p, uint64_t index)
{
    rng r = rng_of(p->seed, index);
    double side = (double)p->n, x = side * (rng_unit(&r) - 0.5), y = side * (rng_unit(&r) - 0.5), z = (double)index;
    roberts_vec2 a = half_angle(2 * rng_unit(&r) - 1);
    body_turned_box(b, vec3(x - side, y - 0.25, z), vec3(x + side, y + 0.25, z + 0.5), a.x, a.y);
}

/* One slab, and under it n small boxes on a square grid. */
static uint64_t ground_count(uint64_t n)
{
    return n + 1;
}

static void ground_solid(body *b, const plan *p, uint64_t index)
{
    uint64_t width = integer_root(p->n - 1) + 1, column = (index - 1) % width, row = (index - 1) / width;
    double x = 2 * (double)column + 1, y = 2 * (double)row + 1, side = 2 * (double)width + 1, deep;
    rng r = rng_of(p->seed, index);
    if (index == 0) {
        body_box(b, vec3(0, 0, 0), vec3(side, side, 1));
        return;
    }
    deep = (double)rng_between(&r, 1, 4);
    body_box(b, vec3(x, y, -1 - deep), vec3(x + 1, y + 1, -1));
}

/* The same turned cube, n times at the same position. */
static void copies_solid(body *b, const plan *p, uint64_t index)
{
    (void)index;
    body_add(b, &p->cube, turn(7, 1, 2, 3, 1, vec3(0, 0, 0)));
}

/* A hundred coins of N corners one above the other, each at a random position within a radius, so that several dozen
 * rims cross everywhere. */
static uint64_t hundred(uint64_t n)
{
    (void)n;
    return 100;
}

static void coins_solid(body *b, const plan *p, uint64_t index)
{
    rng r = rng_of(p->seed, index);
    double x = 2 * rng_unit(&r), y = 2 * rng_unit(&r), z = 0.25 * (double)index;
    roberts_vec2 a = half_angle(2 * rng_unit(&r) - 1);
    motion move = {{{a.x, -a.y, 0}, {a.y, a.x, 0}, {0, 0, 1}}, {x, y, z}};
    body coin = {0};
    column_make(&coin, (uint32_t)p->n, 1, 0, 0.125);
    body_add(b, &coin, move);
    body_free(&coin);
}

/* One disc of N corners, and under it n small boxes on a square grid. Those at its rim stick out, some completely. */
static void disc_solid(body *b, const plan *p, uint64_t index)
{
    uint64_t width = integer_root(p->n - 1) + 1, column = (index - 1) % width, row = (index - 1) / width;
    double radius = (double)width;
    double x = 2 * (double)column - radius, y = 2 * (double)row - radius, deep;
    rng r = rng_of(p->seed, index);
    if (index == 0) {
        column_make(b, (uint32_t)p->n, radius, 0, 1);
        return;
    }
    deep = (double)rng_between(&r, 1, 4);
    body_box(b, vec3(x, y, -1 - deep), vec3(x + 1, y + 1, -1));
}

/* A square slab whose straight borders are each divided into n parts, and n small boxes under one of them. */
static void slab_make(body *b, uint64_t n)
{
    uint32_t base = (uint32_t)b->vertex_count, ring = (uint32_t)(4 * n);
    for (uint32_t z = 0; z < 2; z++)
        for (uint32_t k = 0; k < 4; k++)
            for (uint64_t i = 0; i < n; i++) {
                double side = (double)n, t = (double)i;
                const double x[4] = {t, side, side - t, 0}, y[4] = {0, t, side, side - t};
                body_vertex(b, x[k], y[k], z);
            }
    for (uint32_t i = 0; i < ring; i++)
        body_corner(b, base + ring + i);
    body_end_face(b);
    for (uint32_t i = ring; i > 0; i--)
        body_corner(b, base + i - 1);
    body_end_face(b);
    for (uint32_t i = 0; i < ring; i++) {
        uint32_t p = base + i, q = base + (i + 1) % ring;
        body_face(b, (uint32_t[]){p, q, q + ring, p + ring}, 4);
    }
}

static void parts_solid(body *b, const plan *p, uint64_t index)
{
    double x = (double)index - 0.75;
    if (index == 0)
        slab_make(b, p->n);
    else
        body_box(b, vec3(x, -0.5, -2), vec3(x + 0.5, 0.5, -1));
}

/* Two pyramids over a regular N-gon, the second one lower and shifted. No two of their edges are parallel in the
 * picture. */
static uint64_t two(uint64_t n)
{
    (void)n;
    return 2;
}

static void fans_solid(body *b, const plan *p, uint64_t index)
{
    motion move = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0.25, 0.125, -2}};
    body fan = {0};
    cone_make(&fan, (uint32_t)p->n, 1, 0, 1);
    if (index == 0)
        move.shift = vec3(0, 0, 0);
    body_add(b, &fan, move);
    body_free(&fan);
}

/* A prism over a star of N points: a wheel with N pointed teeth. */
static void gear_solid(body *b, const plan *p, uint64_t index)
{
    (void)index;
    column_make(b, (uint32_t)(2 * p->n), 1, 0, 0.25);
    for (size_t v = 1; v < b->vertex_count; v += 2)
        b->vertex[v] = vec3(0.5 * b->vertex[v].x, 0.5 * b->vertex[v].y, b->vertex[v].z);
}

/* cos(order t), given x = cos t. */
static double chebyshev(double x, int order)
{
    double before = 1, at = x;
    for (int k = 1; k < order; k++) {
        double next = 2 * x * at - before;
        before = at;
        at = next;
    }
    return at;
}

/* Ten boards over one another with a winding border, like the layers of a hill. */
static uint64_t ten(uint64_t n)
{
    (void)n;
    return 10;
}

static void layers_solid(body *b, const plan *p, uint64_t index)
{
    const double layer = (double)index, wide = 1 - 0.08 * layer;
    column_make(b, (uint32_t)p->n, 1, 0.03125 * layer, 0.03125 * (layer + 1));
    for (size_t v = 0; v < b->vertex_count; v++) {
        const roberts_vec3 at = b->vertex[v];
        const double far = wide * (1 + chebyshev(at.x, 5) / 8 + chebyshev(at.y, 13) / 16 + chebyshev(at.x, 27) / 32);
        b->vertex[v] = vec3(far * at.x, far * at.y, at.z);
    }
}

/* A sheet of N strips, folded up and down. It is open. */
static void roof_solid(body *b, const plan *p, uint64_t index)
{
    const uint32_t n = (uint32_t)p->n;
    (void)index;
    for (uint32_t i = 0; i <= n; i++) {
        body_vertex(b, i, 0, i % 2);
        body_vertex(b, i, 0.25 * n, i % 2);
    }
    for (uint32_t i = 0; i < n; i++)
        body_face(b, (uint32_t[]){2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1}, 4);
}

/* N planks side by side, flush on three joists. */
static uint64_t deck_count(uint64_t n)
{
    return n + 3;
}

static void deck_solid(body *b, const plan *p, uint64_t index)
{
    const double n = (double)p->n, x = (double)index, y = 0.2 * n * (x - n);
    if (index < p->n)
        body_box(b, vec3(x, 0, 0), vec3(x + 0.875, 0.5 * n, 0.25));
    else
        body_box(b, vec3(0, y, -1), vec3(n, y + 1, 0));
}

/* Two interpenetrating balls of about n faces, and a box that is larger in proportion to its distance, so that the
 * balls cover one spot of the picture. */
static uint64_t three(uint64_t n)
{
    (void)n;
    return 3;
}

static void speck_solid(body *b, const plan *p, uint64_t index)
{
    uint64_t rings = integer_root(p->n / 2);
    motion move = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0.3125, 0.1875, 0.125}};
    body ball = {0};
    rings = rings < 2 ? 2 : rings;
    if (index == 2) {
        body_box(b, vec3(1000, 1000, 1000), vec3(2000, 2000, 2000));
        return;
    }
    globe_make(&ball, (uint32_t)rings, (uint32_t)(2 * rings));
    if (index == 0)
        move.shift = vec3(0, 0, 0);
    body_add(b, &ball, move);
    body_free(&ball);
}

/* ---- single solids --------------------------------------------------------------------------------------------- */

static uint64_t single(uint64_t n)
{
    (void)n;
    return 1;
}

static void prism_solid(body *b, const plan *p, uint64_t index)
{
    (void)index;
    prism_make(b, (uint32_t)p->n);
}

static void antiprism_solid(body *b, const plan *p, uint64_t index)
{
    (void)index;
    antiprism_make(b, (uint32_t)p->n);
}

/* Twice as many meridians as zones, and about n faces. */
static void sphere_solid(body *b, const plan *p, uint64_t index)
{
    uint64_t rings = integer_root(p->n / 2);
    (void)index;
    rings = rings < 2 ? 2 : rings;
    globe_make(b, (uint32_t)rings, (uint32_t)(2 * rings));
}

/* ---- the table, and writing ------------------------------------------------------------------------------------ */

typedef uint64_t count_fn(uint64_t n);
typedef void prepare_fn(plan *p);                              /* makes p->part */
typedef void solid_fn(body *b, const plan *p, uint64_t index); /* adds solid `index` */

static const struct {
    family family;
    count_fn *count;
    solid_fn *solid;
    prepare_fn *prepare; /* NULL: needs no preparation */
} families[] = {
    {{"lattice", "N [SEED]",
      "Lattice of N^3 tetrahedra, cubes and octahedra, one in each unit cell, each at a random turn (a rational one).",
      1, 200, true},
     cube_of,
     lattice_solid,
     NULL},
    {{"city", "N [SEED]",
      "City of N x N blocks between streets, four solids to a block: setback towers, houses, courtyards of four wings\n"
      "that touch, podiums with towers on them. Heights and kinds are random.",
      1, 2000, true},
     city_count,
     city_solid,
     NULL},
    {{"wall", "N", "Brick wall, N bricks of 4 x 2 x 1 in running bond, without gaps.", 1, 50000000, false},
     one_each,
     wall_solid,
     NULL},
    {{"plates", "N [SEED]",
      "Heap of N thin plates at random places and turned at random about the vertical, each over all before it.", 1,
      50000000, true},
     one_each,
     plates_solid,
     NULL},
    {{"stack", "N [SEED]",
      "Stack of N boxes along the z axis, of random width and turn; from the top they all lie behind one another.", 1,
      50000000, true},
     one_each,
     stack_solid,
     NULL},
    {{"needles", "N [SEED]", "N long sticks over one another in random directions, each across the whole picture.", 1,
      50000000, true},
     one_each,
     needles_solid,
     NULL},
    {{"ground", "N [SEED]", "One slab with N small boxes hanging under it; from below, N boxes before one large face.",
      1, 50000000, true},
     ground_count,
     ground_solid,
     NULL},
    {{"copies", "N", "N copies of one cube in the same place.", 1, 50000000, false}, one_each, copies_solid, NULL},
    {{"coins", "N [SEED]", "A hundred coins of N corners over one another.", 3, 1000000, true},
     hundred,
     coins_solid,
     NULL},
    {{"disc", "N [SEED]", "One disc of N corners with N small boxes under it, some beyond its rim.", 3, 10000000, true},
     ground_count,
     disc_solid,
     NULL},
    {{"parts", "N", "Square slab, its straight borders in N parts each, with N small boxes under one of them.", 1,
      10000000, false},
     ground_count,
     parts_solid,
     NULL},
    {{"fans", "N", "Two pyramids over the regular N-gon, one behind the tip of the other.", 3, 1000000, false},
     two,
     fans_solid,
     NULL},
    {{"gear", "N", "Wheel of N pointed teeth: a prism over a star.", 3, 100000, false}, single, gear_solid, NULL},
    {{"layers", "N", "Ten boards over one another, smaller and smaller, each with a winding border of N corners.", 3,
      100000, false},
     ten,
     layers_solid,
     NULL},
    {{"roof", "N", "Sheet of N strips, folded up and down like a corrugated roof.", 1, 10000000, false},
     single,
     roof_solid,
     NULL},
    {{"deck", "N", "N planks side by side, with gaps, flush on three long joists.", 10, 10000000, false},
     deck_count,
     deck_solid,
     NULL},
    {{"speck", "N", "Two balls of about N faces each, one through the other, and a large box far away.", 8, 10000000,
      false},
     three,
     speck_solid,
     NULL},
    {{"sphere", "N", "Ball of about N faces: parallels and meridians.", 8, 10000000, false},
     single,
     sphere_solid,
     NULL},
    {{"prism", "N", "Uniform prism over the regular N-gon: circumradius of the N-gon 1, side faces squares.", 3,
      1000000, false},
     single,
     prism_solid,
     NULL},
    {{"antiprism", "N",
      "Uniform antiprism over the regular N-gon: circumradius of the N-gon 1, side faces equilateral triangles.", 3,
      1000000, false},
     single,
     antiprism_solid,
     NULL},
    {{"scan", "N [SEED]", "Ball of about N triangles with bumps, and with dents that have sharp rims.", 20, 20000000,
      true},
     single,
     part_solid,
     scan_prepare},
    {{"balls", "N [SEED]", "A thousand balls of about N triangles in all, none touching another.", 20000, 50000000,
      true},
     thousand,
     balls_solid,
     ball_prepare},
    {{"boulders", "N [SEED]", "The same with bumps and dents.", 20000, 50000000, true},
     thousand,
     balls_solid,
     boulder_prepare},
    {{"crossing", "N [SEED]", "A thousand balls of about N triangles in all, each crossing some others.", 20000,
      50000000, true},
     thousand,
     crossing_solid,
     ball_prepare},
    {{"terrain", "N [SEED]", "Land of about N triangles, an open sheet that leans over to one side.", 2, 50000000,
      true},
     single,
     part_solid,
     terrain_prepare},
    {{"stars", "N [SEED]",
      "Lattice of N^3 spiky stars of 24 or 60 triangles, one in each unit cell, each at a random turn.", 1, 200, true},
     cube_of,
     stars_solid,
     NULL},
    {{"soup", "N [SEED]", "N loose triangles in a cube, each crossing some three others.", 1, 50000000, true},
     one_each,
     soup_solid,
     NULL},
    {{"boards", "N", "A floor of N long planks side by side.", 1, 50000000, false}, one_each, boards_solid, NULL},
    {{"diagonal", "N [SEED]", "N long sticks over one another, each along the diagonal of the picture.", 1, 50000000,
      true},
     one_each,
     diagonal_solid,
     NULL},
    {{"crowd", "N [SEED]", "N cubes close together, in a thousandth of the picture that four others span.", 1, 50000000,
      true},
     crowd_count,
     crowd_solid,
     NULL},
    {{"galaxy", "N [SEED]", "N cubes about a point, of sizes from 1 to 2^-15: the smaller, the nearer to it.", 1,
      50000000, true},
     one_each,
     galaxy_solid,
     NULL},
    {{"sheets", "N [SEED]", "N thin sheets over one another, each turned and moved a little.", 1, 50000000, true},
     one_each,
     sheets_solid,
     NULL},
    {{"floors", "N", "Tower of N floors, each a little narrower than the one below, and turned against it.", 1,
      50000000, false},
     one_each,
     floors_solid,
     NULL},
    {{"spines", "N [SEED]", "N spines that point away from one point, in all directions.", 1, 50000000, true},
     one_each,
     spines_solid,
     NULL},
    {{"posts", "N [SEED]", "N posts side by side, a thousand times as high as wide.", 1, 50000000, true},
     one_each,
     posts_solid,
     NULL},
    {{"shells", "N [SEED]", "N square shells from wide to narrow, each turned at random.", 1, 50000000, true},
     one_each,
     shells_solid,
     NULL},
    {{"plain", "N [SEED]", "City of N x N blocks on a plate 300 times as wide.", 1, 2000, true},
     plain_count,
     plain_solid,
     NULL},
};

size_t family_count(void)
{
    return sizeof families / sizeof *families;
}

const family *family_at(size_t i)
{
    return &families[i].family;
}

/* Writes the comment of the file: a description of the scene, and its arguments. */
static void describe(size_t i, uint64_t n, uint64_t seed, char *text, size_t size)
{
    const family *f = &families[i].family;
    char arguments[48] = "";
    if (f->seeded)
        snprintf(arguments, sizeof arguments, " %" PRIu64, seed);
    snprintf(text, size, "%s\nMade by make-models %s %" PRIu64 "%s: N = %" PRIu64 ".", f->about, f->name, n, arguments,
             n);
}

/* Makes every solid in turn in the empty body `b` and passes it to the writer: pass 0 counts, 1 writes vertices, 2
 * writes faces. */
static void run_pass(size_t i, const plan *p, int pass, off_writer *w, uint64_t *vertices, uint64_t *faces)
{
    uint64_t count = families[i].count(p->n);
    body b = {0};
    *vertices = *faces = 0;
    for (uint64_t k = 0; k < count; k++, body_clear(&b)) {
        families[i].solid(&b, p, k);
        if (pass == 1)
            off_vertices(w, &b);
        else if (pass == 2)
            off_faces(w, &b, *vertices);
        *vertices += b.vertex_count;
        *faces += b.face_count;
    }
    body_free(&b);
}

bool family_write(size_t i, uint64_t n, uint64_t seed, FILE *file)
{
    static off_writer w; /* too large for some stacks */
    plan p = {.n = n, .seed = seed};
    uint64_t vertices, faces;
    char comment[512];
    uniform_make(&p.tetrahedron, TETRAHEDRON);
    uniform_make(&p.cube, CUBE);
    uniform_make(&p.octahedron, OCTAHEDRON);
    uniform_make(&p.icosahedron, ICOSAHEDRON);
    if (families[i].prepare)
        families[i].prepare(&p);
    describe(i, n, seed, comment, sizeof comment);
    run_pass(i, &p, 0, &w, &vertices, &faces);
    off_begin(&w, file, comment, vertices, faces);
    run_pass(i, &p, 1, &w, &vertices, &faces);
    run_pass(i, &p, 2, &w, &vertices, &faces);
    body_free(&p.tetrahedron);
    body_free(&p.cube);
    body_free(&p.octahedron);
    body_free(&p.icosahedron);
    body_free(&p.part);
    return off_end(&w);
}
