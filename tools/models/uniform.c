/* uniform.c - Platonic, Archimedean and Catalan solids, prisms, antiprisms.
 *
 * A uniform solid is the convex hull of the images of a few points under permutations and sign changes of the
 * coordinates. Its edges are the pairs of vertices at the least distance; its faces are the planes through two
 * consecutive edges with all vertices on one side. The dual's vertices are the poles of the faces' planes. Source of
 * the coordinates: H. S. M. Coxeter, "Regular and semi-regular polytopes I", Math. Z. 46 (1940). Coordinates are the
 * natural ones, unscaled, so that as many as possible are integers. */
#include "uniform.h"

#include <stddef.h>

#include "exact.h"

enum { VERTEX_MAX = 120, DEGREE_MAX = 5, FACE_CORNER_MAX = 10 };

/* Relative difference up to which two lengths count as equal: far above rounding (1e-15), far below the differences
 * that occur in these solids (1e-2). */
static const double SAME = 1e-9;

/* The sign changes applied to a point: those for which the product of the three signs is allowed. */
typedef enum signs { ANY, EVEN, ODD } signs;

/* A point (a0 + b0 r, a1 + b1 r, a2 + b2 r), where r is the irrational number of its solid. */
typedef struct seed {
    double a[3], b[3];
} seed;

typedef enum irrational { NONE, GOLDEN, ROOT_2 } irrational;

typedef struct recipe {
    irrational r;
    bool all_permutations; /* otherwise only the even (cyclic) ones */
    signs signs;
    int seed_count;
    seed seed[5];
    const char *about, *dual; /* comments */
} recipe;

static const recipe recipes[UNIFORM_COUNT] = {
    [TETRAHEDRON] = {NONE,
                     false,
                     EVEN,
                     1,
                     {{{1, 1, 1}, {0}}},
                     "Regular tetrahedron: (1, 1, 1) with an even number of signs changed.",
                     NULL},
    [CUBE] = {NONE, false, ANY, 1, {{{1, 1, 1}, {0}}}, "Cube: (+-1, +-1, +-1).", NULL},
    [OCTAHEDRON] = {NONE, true, ANY, 1, {{{1, 0, 0}, {0}}}, "Regular octahedron: permutations of (+-1, 0, 0).", NULL},
    [DODECAHEDRON] =
        {GOLDEN,
         false,
         ANY,
         2,
         {{{1, 1, 1}, {0}}, {{0, -1, 0}, {0, 1, 1}}},
         "Regular dodecahedron: (+-1, +-1, +-1) and even permutations of (0, +-(g - 1), +-g), g the golden\n"
         "ratio.",
         NULL},
    [ICOSAHEDRON] = {GOLDEN,
                     false,
                     ANY,
                     1,
                     {{{0, 1, 0}, {0, 0, 1}}},
                     "Regular icosahedron: even permutations of (0, +-1, +-g), g the golden ratio.",
                     NULL},
    [TRUNCATED_TETRAHEDRON] = {NONE,
                               true,
                               EVEN,
                               1,
                               {{{1, 1, 3}, {0}}},
                               "Truncated tetrahedron: permutations of (1, 1, 3) with an even number of signs changed.",
                               "Triakis tetrahedron: dual of the truncated tetrahedron."},
    [CUBOCTAHEDRON] = {NONE,
                       true,
                       ANY,
                       1,
                       {{{1, 1, 0}, {0}}},
                       "Cuboctahedron: permutations of (+-1, +-1, 0).",
                       "Rhombic dodecahedron: dual of the cuboctahedron."},
    [TRUNCATED_CUBE] = {ROOT_2,
                        true,
                        ANY,
                        1,
                        {{{1, 1, -1}, {0, 0, 1}}},
                        "Truncated cube: permutations of (+-1, +-1, +-(sqrt(2) - 1)).",
                        "Triakis octahedron: dual of the truncated cube."},
    [TRUNCATED_OCTAHEDRON] = {NONE,
                              true,
                              ANY,
                              1,
                              {{{0, 1, 2}, {0}}},
                              "Truncated octahedron: permutations of (0, +-1, +-2).",
                              "Tetrakis hexahedron: dual of the truncated octahedron."},
    [RHOMBICUBOCTAHEDRON] = {ROOT_2,
                             true,
                             ANY,
                             1,
                             {{{1, 1, 1}, {0, 0, 1}}},
                             "Rhombicuboctahedron: permutations of (+-1, +-1, +-(1 + sqrt(2))).",
                             "Deltoidal icositetrahedron: dual of the rhombicuboctahedron."},
    [TRUNCATED_CUBOCTAHEDRON] = {ROOT_2,
                                 true,
                                 ANY,
                                 1,
                                 {{{1, 1, 1}, {0, 1, 2}}},
                                 "Truncated cuboctahedron: permutations of (+-1, +-(1 + sqrt(2)), +-(1 + 2 sqrt(2))).",
                                 "Disdyakis dodecahedron: dual of the truncated cuboctahedron."},
    [SNUB_CUBE] = {.about = "Snub cube: even permutations of (+-1, +-1/t, +-t) with an odd number of minus signs, odd\n"
                            "permutations with an even number; t the tribonacci constant, t^3 = t^2 + t + 1.",
                   .dual = "Pentagonal icositetrahedron: dual of the snub cube."},
    [ICOSIDODECAHEDRON] =
        {GOLDEN,
         false,
         ANY,
         2,
         {{{0, 0, 0}, {2, 0, 0}}, {{1, 0, 1}, {0, 1, 1}}},
         "Icosidodecahedron: even permutations of (+-2g, 0, 0) and (+-1, +-g, +-(1 + g)), g the golden\n"
         "ratio.",
         "Rhombic triacontahedron: dual of the icosidodecahedron."},
    [TRUNCATED_DODECAHEDRON] = {GOLDEN,
                                false,
                                ANY,
                                3,
                                {{{0, -1, 2}, {0, 1, 1}}, {{-1, 0, 0}, {1, 1, 2}}, {{0, 2, 1}, {1, 0, 1}}},
                                "Truncated dodecahedron: even permutations of (0, +-(g - 1), +-(2 + g)),\n"
                                "(+-(g - 1), +-g, +-2g) and (+-g, +-2, +-(1 + g)), g the golden ratio.",
                                "Triakis icosahedron: dual of the truncated dodecahedron."},
    [TRUNCATED_ICOSAHEDRON] =
        {GOLDEN,
         false,
         ANY,
         3,
         {{{0, 1, 0}, {0, 0, 3}}, {{1, 2, 0}, {0, 1, 2}}, {{0, 2, 1}, {1, 0, 2}}},
         "Truncated icosahedron: even permutations of (0, +-1, +-3g), (+-1, +-(2 + g), +-2g) and\n"
         "(+-g, +-2, +-(1 + 2g)), g the golden ratio.",
         "Pentakis dodecahedron: dual of the truncated icosahedron."},
    [RHOMBICOSIDODECAHEDRON] = {GOLDEN,
                                false,
                                ANY,
                                3,
                                {{{1, 1, 1}, {0, 0, 2}}, {{1, 0, 0}, {1, 1, 2}}, {{2, 0, 1}, {1, 0, 1}}},
                                "Rhombicosidodecahedron: even permutations of (+-1, +-1, +-(1 + 2g)),\n"
                                "(+-(1 + g), +-g, +-2g) and (+-(2 + g), 0, +-(1 + g)), g the golden ratio.",
                                "Deltoidal hexecontahedron: dual of the rhombicosidodecahedron."},
    [TRUNCATED_ICOSIDODECAHEDRON] =
        {GOLDEN,
         false,
         ANY,
         5,
         {{{-1, -1, 3}, {1, 1, 1}},
          {{-2, 0, 1}, {2, 1, 2}},
          {{-1, 1, -1}, {1, 1, 3}},
          {{-1, 2, 2}, {2, 0, 1}},
          {{0, 3, 0}, {1, 0, 2}}},
         "Truncated icosidodecahedron: even permutations of (+-(g - 1), +-(g - 1), +-(3 + g)),\n"
         "(+-(2g - 2), +-g, +-(1 + 2g)), (+-(g - 1), +-(1 + g), +-(3g - 1)),\n"
         "(+-(2g - 1), +-2, +-(2 + g)) and (+-g, +-3, +-2g), g the golden ratio.",
         "Disdyakis triacontahedron: dual of the truncated icosidodecahedron."},
    [SNUB_DODECAHEDRON] = {.about = "Snub dodecahedron: the images under the 60 turns of the icosahedron of\n"
                                    "(g^2 (1 - x), x (g + 2 g x) - g^3, x), g the golden ratio, x^3 + 2 x^2 = g^2.",
                           .dual = "Pentagonal hexecontahedron: dual of the snub dodecahedron."},
};

const char *uniform_about(int solid)
{
    return recipes[solid].about;
}

const char *catalan_about(int solid)
{
    return recipes[solid].dual;
}

/* ---- vertices -------------------------------------------------------------------------------------------------- */

static void add_new_vertex(body *b, roberts_vec3 p)
{
    for (size_t i = 0; i < b->vertex_count; i++) {
        roberts_vec3 q = b->vertex[i];
        if (p.x == q.x && p.y == q.y && p.z == q.z)
            return;
    }
    body_vertex(b, p.x, p.y, p.z);
}

/* Adds p with all its sign changes. */
static void add_signs(body *b, const double p[3], signs which)
{
    for (int mask = 0; mask < 8; mask++) {
        bool odd = (mask ^ mask >> 1 ^ mask >> 2) & 1;
        if (which == (odd ? EVEN : ODD))
            continue;
        add_new_vertex(b, vec3(mask & 1 ? -p[0] : p[0], mask & 2 ? -p[1] : p[1], mask & 4 ? -p[2] : p[2]));
    }
}

static void add_even_permutations(body *b, const double p[3], signs which)
{
    for (int i = 0; i < 3; i++)
        add_signs(b, (double[]){p[i], p[(i + 1) % 3], p[(i + 2) % 3]}, which);
}

static void add_odd_permutations(body *b, const double p[3], signs which)
{
    for (int i = 0; i < 3; i++)
        add_signs(b, (double[]){p[i], p[(i + 2) % 3], p[(i + 1) % 3]}, which);
}

static double golden_ratio(void)
{
    return (1 + sqrt(5.0)) / 2;
}

static void recipe_vertices(body *b, const recipe *from)
{
    double r = from->r == GOLDEN ? golden_ratio() : sqrt(2.0);
    for (int i = 0; i < from->seed_count; i++) {
        const seed *s = &from->seed[i];
        double p[3];
        for (int j = 0; j < 3; j++)
            p[j] = s->a[j] + s->b[j] * r;
        add_even_permutations(b, p, from->signs);
        if (from->all_permutations)
            add_odd_permutations(b, p, from->signs);
    }
}

/* Returns the root near x of x^3 + c2 x^2 + c1 x + c0 by Newton's method. Starting from the first digit, eight steps
 * are more than enough for a double. */
static double cubic_root(double x, double c2, double c1, double c0)
{
    for (int i = 0; i < 8; i++)
        x -= (((x + c2) * x + c1) * x + c0) / ((3 * x + 2 * c2) * x + c1);
    return x;
}

static void snub_cube_vertices(body *b)
{
    double t = cubic_root(1.8, -1, -1, -1), p[3] = {1, 1 / t, t};
    add_even_permutations(b, p, ODD);
    add_odd_permutations(b, p, EVEN);
}

/* The 60 rotations are the five about a fivefold axis times the twelve of the tetrahedron. */
static void snub_dodecahedron_vertices(body *b)
{
    double g = golden_ratio(), x = cubic_root(0.9, 2, 0, -g * g), h = 1 / (2 * g);
    double p[3] = {g * g * (1 - x), x * (g + 2 * g * x) - g * g * g, x};
    for (int i = 0; i < 5; i++) {
        double q[3] = {h * p[0] - g / 2 * p[1] + p[2] / 2, g / 2 * p[0] + p[1] / 2 + h * p[2],
                       -p[0] / 2 + h * p[1] + g / 2 * p[2]};
        add_even_permutations(b, p, EVEN);
        p[0] = q[0], p[1] = q[1], p[2] = q[2];
    }
}

/* ---- faces of the hull ----------------------------------------------------------------------------------------- */

/* The other ends of the edges from each vertex. */
typedef struct edges {
    int degree[VERTEX_MAX];
    uint32_t end[VERTEX_MAX][DEGREE_MAX];
} edges;

static double distance2(const body *b, size_t i, size_t j)
{
    roberts_vec3 d = vec3_sub(b->vertex[i], b->vertex[j]);
    return vec3_dot(d, d);
}

/* Makes every pair at the least distance an edge, which is right for a uniform solid. */
static void find_edges(const body *b, edges *e)
{
    double least = INFINITY;
    for (size_t j = 1; j < b->vertex_count; j++)
        least = fmin(least, distance2(b, 0, j));
    for (size_t i = 0; i < b->vertex_count; i++) {
        e->degree[i] = 0;
        for (size_t j = 0; j < b->vertex_count; j++)
            if (j != i && distance2(b, i, j) < least * (1 + SAME) && e->degree[i] < DEGREE_MAX)
                e->end[i][e->degree[i]++] = (uint32_t)j;
    }
}

/* Returns the height of vertex p above the plane of i, j, k, in units of the solid's size. */
static double height(const body *b, uint32_t i, uint32_t j, uint32_t k, size_t p)
{
    roberts_vec3 o = b->vertex[j];
    roberts_vec3 n = vec3_cross(vec3_sub(o, b->vertex[i]), vec3_sub(b->vertex[k], o));
    return vec3_dot(n, vec3_sub(b->vertex[p], o)) / vec3_length(n) / vec3_length(o);
}

/* Is no vertex outside the plane of i, j, k? */
static bool supports(const body *b, uint32_t i, uint32_t j, uint32_t k)
{
    for (size_t p = 0; p < b->vertex_count; p++)
        if (height(b, i, j, k, p) > SAME)
            return false;
    return true;
}

/* Returns the corner after k on the face through i, j, k; j precedes k. */
static uint32_t next_corner(const body *b, const edges *e, uint32_t i, uint32_t j, uint32_t k)
{
    for (int n = 0; n < e->degree[k]; n++) {
        uint32_t m = e->end[k][n];
        if (m != j && (m == i || fabs(height(b, i, j, k, m)) < SAME))
            return m;
    }
    return i;
}

/* Adds the face through the edges ij and jk, if there is one with i as its smallest vertex. */
static void add_face(body *b, const edges *e, uint32_t i, uint32_t j, uint32_t k)
{
    uint32_t corner[FACE_CORNER_MAX] = {i, j, k}, next;
    size_t count = 3;
    if (j < i || k < i || !supports(b, i, j, k))
        return;
    while ((next = next_corner(b, e, i, corner[count - 2], corner[count - 1])) != i) {
        if (next < i || count == FACE_CORNER_MAX)
            return;
        corner[count++] = next;
    }
    body_face(b, corner, count);
}

void uniform_make(body *b, int solid)
{
    body hull = {0};
    edges e;
    if (solid == SNUB_CUBE)
        snub_cube_vertices(&hull);
    else if (solid == SNUB_DODECAHEDRON)
        snub_dodecahedron_vertices(&hull);
    else
        recipe_vertices(&hull, &recipes[solid]);
    find_edges(&hull, &e);
    for (uint32_t i = 0; i < hull.vertex_count; i++)
        for (int n = 0; n < e.degree[i]; n++) {
            uint32_t j = e.end[i][n];
            for (int m = 0; m < e.degree[j]; m++)
                if (e.end[j][m] != i)
                    add_face(&hull, &e, i, j, e.end[j][m]);
        }
    body_add(b, &hull, turn(1, 0, 0, 0, 1, vec3(0, 0, 0)));
    body_free(&hull);
}

/* ---- duals ----------------------------------------------------------------------------------------------------- */

/* Removes the rounding error of a coordinate that is 0 by symmetry: the least true one is above 0.08. */
static double without_residue(double x)
{
    return fabs(x) < 1e-12 ? 0 : x;
}

/* Finds the face with the edge from vertex u to vertex v, and the corner after v in it. */
static size_t face_with_edge(const body *b, uint32_t u, uint32_t v, uint32_t *after)
{
    size_t f = 0, first = 0;
    for (; f < b->face_count; first = b->face_end[f++]) {
        size_t count = b->face_end[f] - first;
        for (size_t i = 0; i < count; i++)
            if (b->corner[first + i] == u && b->corner[first + (i + 1) % count] == v) {
                *after = b->corner[first + (i + 2) % count];
                return f;
            }
    }
    return f;
}

/* Adds the dual's face for vertex v: the poles of the faces around it, counter-clockwise. `end` is the other end of any
 * of its edges. The face with the edge uv has the edge vw, with w after v; the next one clockwise has the edge wv. */
static void add_dual_face(body *b, const body *solid, uint32_t base, uint32_t v, uint32_t end)
{
    uint32_t corner[DEGREE_MAX], u = end;
    size_t count = 0;
    do
        corner[count++] = base + (uint32_t)face_with_edge(solid, u, v, &u);
    while (u != end && count < DEGREE_MAX);
    for (size_t i = 0; i < count / 2; i++) {
        uint32_t swap = corner[i];
        corner[i] = corner[count - 1 - i];
        corner[count - 1 - i] = swap;
    }
    body_face(b, corner, count);
}

void catalan_make(body *b, int solid)
{
    uint32_t base = (uint32_t)b->vertex_count;
    body primal = {0};
    edges e = {0};
    roberts_vec3 middle;
    uniform_make(&primal, solid);
    find_edges(&primal, &e);
    middle = vec3_scale(0.5, vec3_add(primal.vertex[0], primal.vertex[e.end[0][0]]));
    for (size_t f = 0; f < primal.face_count; f++) {
        roberts_vec3 n = body_face_normal(&primal, f), p = primal.vertex[primal.corner[body_face_start(&primal, f)]];
        double k = vec3_dot(middle, middle) / vec3_dot(n, p);
        body_vertex(b, without_residue(k * n.x), without_residue(k * n.y), without_residue(k * n.z));
    }
    for (uint32_t v = 0; v < primal.vertex_count; v++)
        add_dual_face(b, &primal, base, v, e.end[v][0]);
    body_free(&primal);
}

/* ---- over regular polygons ------------------------------------------------------------------------------------- */

/* Adds n vertices at height z, the first one `first` steps of 1/`steps` turn from the x axis. */
static uint32_t add_ring(body *b, uint32_t n, double radius, double z, uint32_t first, uint32_t steps)
{
    uint32_t base = (uint32_t)b->vertex_count;
    for (uint32_t i = 0; i < n; i++) {
        roberts_vec2 p = circle_point(first + i * (steps / n), steps);
        body_vertex(b, radius * p.x, radius * p.y, z);
    }
    return base;
}

/* Adds the polygon over a ring, seen from above or from below. */
static void add_ring_face(body *b, uint32_t base, uint32_t n, bool up)
{
    for (uint32_t i = 0; i < n; i++)
        body_corner(b, base + (up ? i : n - 1 - i));
    body_end_face(b);
}

/* Adds quadrangles between two rings of n with the same directions. */
static void add_band(body *b, uint32_t lower, uint32_t upper, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        uint32_t j = (i + 1) % n;
        body_face(b, (uint32_t[]){lower + i, lower + j, upper + j, upper + i}, 4);
    }
}

/* Adds triangles between a ring and a point above it (`up`) or below it. */
static void add_cap(body *b, uint32_t ring, uint32_t n, uint32_t apex, bool up)
{
    for (uint32_t i = 0; i < n; i++) {
        uint32_t p = ring + i, q = ring + (i + 1) % n;
        body_face(b, (uint32_t[]){up ? p : q, up ? q : p, apex}, 3);
    }
}

void column_make(body *b, uint32_t n, double radius, double z0, double z1)
{
    uint32_t lower = add_ring(b, n, radius, z0, 0, n), upper = add_ring(b, n, radius, z1, 0, n);
    add_ring_face(b, upper, n, true);
    add_ring_face(b, lower, n, false);
    add_band(b, lower, upper, n);
}

void cone_make(body *b, uint32_t n, double radius, double z0, double z1)
{
    uint32_t ring = add_ring(b, n, radius, z0, 0, n), apex = body_vertex(b, 0, 0, z1);
    add_ring_face(b, ring, n, false);
    add_cap(b, ring, n, apex, true);
}

void prism_make(body *b, uint32_t n)
{
    double half = circle_point(1, UINT64_C(2) * n).y; /* half the polygon's side */
    column_make(b, n, 1, -half, half);
}

/* The sides of polygon and triangles are 2 sin(pi/n); seen from above, a triangle's slanted side is 2 sin(pi/2n). */
void antiprism_make(body *b, uint32_t n)
{
    double side = circle_point(1, UINT64_C(2) * n).y, seen = circle_point(1, UINT64_C(4) * n).y;
    double half = sqrt((side - seen) * (side + seen));
    uint32_t lower = add_ring(b, n, 1, -half, 0, 2 * n), upper = add_ring(b, n, 1, half, 1, 2 * n);
    add_ring_face(b, upper, n, true);
    add_ring_face(b, lower, n, false);
    for (uint32_t i = 0; i < n; i++) {
        uint32_t j = (i + 1) % n;
        body_face(b, (uint32_t[]){lower + i, lower + j, upper + i}, 3);
        body_face(b, (uint32_t[]){lower + j, upper + j, upper + i}, 3);
    }
}

void globe_make(body *b, uint32_t rings, uint32_t sides)
{
    uint32_t south = body_vertex(b, 0, 0, -1), first = 0, ring = 0;
    for (uint32_t i = 1; i < rings; i++) {
        roberts_vec2 p = circle_point(i, UINT64_C(2) * rings); /* angle from the south pole */
        uint32_t next = add_ring(b, sides, p.y, -p.x, 0, sides);
        if (i == 1)
            first = next;
        else
            add_band(b, ring, next, sides);
        ring = next;
    }
    add_cap(b, first, sides, south, false);
    add_cap(b, ring, sides, body_vertex(b, 0, 0, 1), true);
}
