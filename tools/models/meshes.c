/* meshes.c - large triangle meshes for measurements: scan-like bodies, crossing balls, land, stars, loose triangles.
 *
 * Coordinates are rounded to integers of six or seven digits, like a scanner's: the files stay short, and the
 * coordinates are exact. Only +, -, *, / and sqrt() are used, so the bytes are the same everywhere. */
#include "exact.h"
#include "large.h"

static void integer_vertex(body *b, roberts_vec3 p)
{
    body_vertex(b, rint(p.x), rint(p.y), rint(p.z));
}

/* Adds a moved copy of `part`, rounded to integers. */
static void add_rounded(body *b, const body *part, motion move)
{
    size_t first = b->vertex_count;
    body_add(b, part, move);
    for (size_t v = first; v < b->vertex_count; v++)
        b->vertex[v] = vec3(rint(b->vertex[v].x) + 0.0, rint(b->vertex[v].y) + 0.0, rint(b->vertex[v].z) + 0.0);
}

void part_solid(body *b, const plan *p, uint64_t index)
{
    (void)index;
    add_rounded(b, &p->part, turn(1, 0, 0, 0, 1, vec3(0, 0, 0)));
}

/* ---- balls ------------------------------------------------------------------------------------------------------ */

static roberts_vec3 unit(roberts_vec3 p)
{
    return vec3_scale(1 / vec3_length(p), p);
}

enum { ICOSAHEDRON_CORNERS = 12 };

/* Vertex numbers of a divided icosahedron: those of edge uv, u < v, run from u to v, starting after edge[u][v]. */
typedef struct division {
    uint32_t parts;
    uint32_t edge[ICOSAHEDRON_CORNERS][ICOSAHEDRON_CORNERS];
    uint32_t inner; /* first vertex inside the current face */
} division;

/* Returns point i, j of the face abc, i steps from a toward b and j toward c. */
static roberts_vec3 grid_point(const body *ico, const uint32_t *face, uint32_t parts, uint32_t i, uint32_t j)
{
    roberts_vec3 a = vec3_scale(parts - i - j, ico->vertex[face[0]]), b = vec3_scale(i, ico->vertex[face[1]]);
    return unit(vec3_add(vec3_add(a, b), vec3_scale(j, ico->vertex[face[2]])));
}

static uint32_t on_edge(const division *d, uint32_t u, uint32_t v, uint32_t step)
{
    if (step == 0)
        return u;
    if (step == d->parts)
        return v;
    return u < v ? d->edge[u][v] + step - 1 : d->edge[v][u] + d->parts - step - 1;
}

/* Returns the number of that point. */
static uint32_t grid_vertex(const division *d, const uint32_t *face, uint32_t i, uint32_t j)
{
    uint32_t row = 0;
    if (j == 0)
        return on_edge(d, face[0], face[1], i);
    if (i == 0)
        return on_edge(d, face[0], face[2], j);
    if (i + j == d->parts)
        return on_edge(d, face[1], face[2], j);
    row = (j - 1) * (d->parts - 1) - j * (j - 1) / 2; /* the rows before j; row k has parts - 1 - k points inside */
    return d->inner + row + i - 1;
}

/* Adds the points of those edges of a face whose ends are in ascending order; each edge is so in one of its two
 * faces. */
static void add_edge_points(body *b, const body *ico, division *d, const uint32_t *face)
{
    for (uint32_t k = 0; k < 3; k++) {
        uint32_t turned[3] = {face[k], face[(k + 1) % 3], face[(k + 2) % 3]};
        if (turned[0] > turned[1])
            continue;
        d->edge[turned[0]][turned[1]] = (uint32_t)b->vertex_count;
        for (uint32_t i = 1; i < d->parts; i++) {
            roberts_vec3 p = grid_point(ico, turned, d->parts, i, 0);
            body_vertex(b, p.x, p.y, p.z);
        }
    }
}

static void add_face_grid(body *b, const body *ico, division *d, const uint32_t *face)
{
    d->inner = (uint32_t)b->vertex_count;
    for (uint32_t j = 1; j < d->parts; j++)
        for (uint32_t i = 1; i + j < d->parts; i++) {
            roberts_vec3 p = grid_point(ico, face, d->parts, i, j);
            body_vertex(b, p.x, p.y, p.z);
        }
    for (uint32_t j = 0; j < d->parts; j++)
        for (uint32_t i = 0; i + j < d->parts; i++) {
            uint32_t p = grid_vertex(d, face, i, j), q = grid_vertex(d, face, i + 1, j);
            uint32_t r = grid_vertex(d, face, i, j + 1);
            body_face(b, (uint32_t[]){p, q, r}, 3);
            if (i + j + 1 < d->parts)
                body_face(b, (uint32_t[]){q, grid_vertex(d, face, i + 1, j + 1), r}, 3);
        }
}

/* Makes the ball of radius 1 from an icosahedron whose faces are divided into parts^2 triangles each. `b` is empty. */
static void geodesic_make(body *b, const body *ico, uint32_t parts)
{
    division d = {.parts = parts};
    for (size_t v = 0; v < ico->vertex_count; v++) {
        roberts_vec3 p = unit(ico->vertex[v]);
        body_vertex(b, p.x, p.y, p.z);
    }
    for (size_t f = 0; f < ico->face_count; f++)
        add_edge_points(b, ico, &d, ico->corner + 3 * f);
    for (size_t f = 0; f < ico->face_count; f++)
        add_face_grid(b, ico, &d, ico->corner + 3 * f);
}

/* Returns the largest division with at most n triangles. */
static uint32_t division_for(uint64_t n)
{
    uint32_t parts = (uint32_t)sqrt((double)n / 20);
    return parts ? parts : 1;
}

/* ---- bumps ------------------------------------------------------------------------------------------------------ */

/* A bump or a dent around the point `middle` of the unit ball. */
typedef struct bump {
    roberts_vec3 middle;
    double height, width; /* height < 0: a dent */
    bool sharp;           /* it has a rim */
} bump;

enum { WIDE_BUMPS = 24, MIDDLE_BUMPS = 96, BUMPS = 600 };

static roberts_vec3 random_direction(rng *r)
{
    roberts_vec3 p;
    double square;
    do {
        p = vec3(2 * rng_unit(r) - 1, 2 * rng_unit(r) - 1, 2 * rng_unit(r) - 1);
        square = vec3_dot(p, p);
    } while (square > 1 || square < 0.01);
    return unit(p);
}

/* A few wide ones and many small ones. Every fourth is a dent with a sharp rim, where the surface bends by about 55
 * degrees. */
static void make_bumps(bump *list, uint64_t seed)
{
    rng r = rng_of(seed, 0);
    for (int i = 0; i < BUMPS; i++) {
        bool sharp = i % 4 == 3;
        double width = (i < WIDE_BUMPS                  ? 0.6
                        : i < WIDE_BUMPS + MIDDLE_BUMPS ? 0.25
                                                        : 0.1) *
                       (0.75 + 0.5 * rng_unit(&r));
        double steep = sharp ? -0.75 : (0.1 + 0.2 * rng_unit(&r)) * (i % 2 ? -1 : 1);
        width = sharp ? width / 2 : width;
        list[i] = (bump){random_direction(&r), steep * width, width, sharp};
    }
}

/* Returns the height of the surface above the ball in direction p. */
static double bumps_height(const bump *list, roberts_vec3 p)
{
    double height = 0;
    for (int i = 0; i < BUMPS; i++) {
        roberts_vec3 d = vec3_sub(p, list[i].middle);
        double s = 1 - vec3_dot(d, d) / (list[i].width * list[i].width);
        if (s > 0)
            height += list[i].height * (list[i].sharp ? s : s * s);
    }
    return height;
}

static void add_bumps(body *b, uint64_t seed)
{
    bump list[BUMPS];
    make_bumps(list, seed);
    for (size_t v = 0; v < b->vertex_count; v++)
        b->vertex[v] = vec3_scale(1 + bumps_height(list, b->vertex[v]), b->vertex[v]);
}

static void scale_part(plan *p, double scale)
{
    for (size_t v = 0; v < p->part.vertex_count; v++)
        p->part.vertex[v] = vec3_scale(scale, p->part.vertex[v]);
}

void scan_prepare(plan *p)
{
    geodesic_make(&p->part, &p->icosahedron, division_for(p->n));
    add_bumps(&p->part, p->seed);
    scale_part(p, 1e6);
}

/* ---- a thousand balls ------------------------------------------------------------------------------------------- */

enum { BALLS_A_SIDE = 10, CELL = 1000000 };

uint64_t thousand(uint64_t n)
{
    (void)n;
    return (uint64_t)BALLS_A_SIDE * BALLS_A_SIDE * BALLS_A_SIDE;
}

void ball_prepare(plan *p)
{
    geodesic_make(&p->part, &p->icosahedron, division_for(p->n / thousand(p->n)));
}

/* The bumps raise the surface by less than a third. */
void boulder_prepare(plan *p)
{
    ball_prepare(p);
    add_bumps(&p->part, p->seed);
    scale_part(p, 0.75);
}

/* Places a ball in a cell of the lattice, as large as its distance from the cell's middle allows. */
void balls_solid(body *b, const plan *p, uint64_t index)
{
    uint64_t x = index % BALLS_A_SIDE, y = index / BALLS_A_SIDE % BALLS_A_SIDE, z = index / BALLS_A_SIDE / BALLS_A_SIDE;
    rng r = rng_of(p->seed, index);
    double radius = 0.25 + 0.22 * rng_unit(&r), room = 0.98 - 2 * radius;
    roberts_vec3 at = vec3((double)x + 0.5, (double)y + 0.5, (double)z + 0.5);
    at = vec3_add(at, vec3(room * (rng_unit(&r) - 0.5), room * (rng_unit(&r) - 0.5), room * (rng_unit(&r) - 0.5)));
    add_rounded(b, &p->part, rng_turn(&r, CELL * radius, vec3_scale(CELL, at)));
}

/* Places a ball anywhere in a cube so narrow that the triangles of 1,000 balls of 320 cross in about 122,000 pairs. */
void crossing_solid(body *b, const plan *p, uint64_t index)
{
    const double side = 7.05;
    rng r = rng_of(p->seed, index);
    double radius = 0.25 + 0.25 * rng_unit(&r);
    roberts_vec3 at = vec3(side * rng_unit(&r), side * rng_unit(&r), side * rng_unit(&r));
    add_rounded(b, &p->part, rng_turn(&r, CELL * radius, vec3_scale(CELL, at)));
}

/* ---- land ------------------------------------------------------------------------------------------------------- */

/* Returns a value between 0 and 1 for each point of the lattice. */
static double lattice_value(uint64_t seed, int64_t x, int64_t y)
{
    rng r = rng_of(seed, (uint64_t)(x * 1000003 + y));
    return rng_unit(&r);
}

static double smooth_step(double t)
{
    return t * t * (3 - 2 * t);
}

/* Smooth noise between 0 and 1, with hills about 1 wide. */
static double noise(uint64_t seed, double x, double y)
{
    int64_t i = (int64_t)floor(x), j = (int64_t)floor(y);
    double u = smooth_step(x - (double)i), v = smooth_step(y - (double)j);
    double lower = lattice_value(seed, i, j) * (1 - u) + lattice_value(seed, i + 1, j) * u;
    double upper = lattice_value(seed, i, j + 1) * (1 - u) + lattice_value(seed, i + 1, j + 1) * u;
    return lower * (1 - v) + upper * v;
}

/* Returns the height at the point x, y, in cells of the grid: hills 40 cells wide, with smaller ones on them. */
static double land_height(uint64_t seed, double x, double y)
{
    double height = 0, wide = 40;
    for (uint64_t octave = 0; octave < 4; octave++) {
        height += 0.75 * wide * noise(seed + octave, x / wide, y / wide);
        wide /= 2.5;
    }
    return height;
}

/* A grid of triangles. Each point is moved along x by its height, so slopes overhang; two points never coincide,
 * because points of one height move equally. More triangles make more land. */
void terrain_prepare(plan *p)
{
    const double cell = 1000, lean = 1.25;
    uint32_t side = (uint32_t)sqrt((double)p->n / 2);
    side = side ? side : 1;
    for (uint32_t j = 0; j <= side; j++)
        for (uint32_t i = 0; i <= side; i++) {
            double height = land_height(p->seed, i, j);
            integer_vertex(&p->part, vec3(cell * (i + lean * height), cell * j, cell * height));
        }
    for (uint32_t j = 0; j < side; j++)
        for (uint32_t i = 0; i < side; i++) {
            uint32_t v = j * (side + 1) + i, w = v + side + 1;
            body_face(&p->part, (uint32_t[]){v, v + 1, w + 1}, 3);
            body_face(&p->part, (uint32_t[]){v, w + 1, w}, 3);
        }
}

/* ---- stars ------------------------------------------------------------------------------------------------------ */

/* Puts a pyramid on each face of a solid of triangles; the tips are `height` from the middle. */
static void star_make(body *b, const body *core, double radius, double height)
{
    for (size_t v = 0; v < core->vertex_count; v++) {
        roberts_vec3 p = vec3_scale(radius, unit(core->vertex[v]));
        body_vertex(b, p.x, p.y, p.z);
    }
    for (size_t f = 0; f < core->face_count; f++) {
        const uint32_t *c = core->corner + 3 * f;
        roberts_vec3 tip = vec3_scale(height, unit(body_face_normal(core, f)));
        uint32_t top = body_vertex(b, tip.x, tip.y, tip.z);
        for (int i = 0; i < 3; i++)
            body_face(b, (uint32_t[]){c[i], c[(i + 1) % 3], top}, 3);
    }
}

void stars_solid(body *b, const plan *p, uint64_t index)
{
    uint64_t n = p->n, x = index % n, y = index / n % n, z = index / n / n;
    rng r = rng_of(p->seed, index);
    bool many = rng_between(&r, 0, 1);
    roberts_vec3 middle = {(double)x + 0.5, (double)y + 0.5, (double)z + 0.5};
    body star = {0};
    star_make(&star, many ? &p->icosahedron : &p->octahedron, many ? 0.2 : 0.27, 0.48);
    add_rounded(b, &star, rng_turn(&r, 10000, vec3_scale(10000, middle)));
    body_free(&star);
}

/* ---- loose triangles -------------------------------------------------------------------------------------------- */

/* So large that each triangle meets about three others. */
void soup_solid(body *b, const plan *p, uint64_t index)
{
    const double spread = 1000, room = 0.39;
    double side = 1;
    rng r = rng_of(p->seed, index);
    uint32_t v = (uint32_t)b->vertex_count;
    roberts_vec3 q[3], middle, n;
    for (int i = 0; i < 60; i++) /* the cube root of N, by Newton's method */
        side -= (side * side * side - (double)p->n) / (3 * side * side);
    side *= room;
    middle = vec3(side * rng_unit(&r), side * rng_unit(&r), side * rng_unit(&r));
    do {
        for (int i = 0; i < 3; i++)
            q[i] = vec3(2 * rng_unit(&r) - 1, 2 * rng_unit(&r) - 1, 2 * rng_unit(&r) - 1);
        n = vec3_cross(vec3_sub(q[1], q[0]), vec3_sub(q[2], q[0]));
    } while (vec3_dot(n, n) < 0.25);
    for (int i = 0; i < 3; i++)
        integer_vertex(b, vec3_scale(spread, vec3_add(middle, vec3_scale(0.5, q[i]))));
    body_face(b, (uint32_t[]){v, v + 1, v + 2}, 3);
}
