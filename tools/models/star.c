/* star.c - the four regular star polyhedra, uniform star polyhedra, prisms and antiprisms over the pentagram.
 *
 * Their corners are those of a convex uniform solid. Their edges are all pairs of corners at a certain distance, and
 * their faces all regular polygons {n/d} of certain n and d with such edges as sides: n corners, d turns. Source: H. S.
 * M. Coxeter, M. S. Longuet-Higgins, J. C. P. Miller, "Uniform polyhedra", Phil. Trans. A 246 (1954). */
#include "exact.h"
#include "models.h"
#include "uniform.h"

/* Relative difference up to which two lengths count as equal: far above rounding, far below the differences that
 * occur. */
static const double SAME = 1e-9;

enum { CORNER_MAX = 10, NEIGHBOUR_MAX = 12 };

static const uint32_t NONE = UINT32_MAX;

typedef struct polygon {
    uint32_t corners, turns;
} polygon;

typedef struct star {
    const char *name, *about;
    int solid;       /* the solid with the same corners */
    int distance;    /* length of the edges: 1 is the least distance of two corners, 2 the next larger one, and so on */
    polygon face[3]; /* up to the first with 0 corners */
    bool half;       /* only the triangles over four of the eight octants */
    bool colored;    /* a colour for each direction of faces, which are six */
} star;

static const star stars[] = {
    {"small-stellated-dodecahedron",
     "Small stellated dodecahedron: 12 pentagrams, five at each corner of the icosahedron.",
     ICOSAHEDRON,
     2,
     {{5, 2}},
     false,
     true},
    {"great-dodecahedron",
     "Great dodecahedron: 12 pentagons, five at each corner of the icosahedron.",
     ICOSAHEDRON,
     1,
     {{5, 1}},
     false,
     true},
    {"great-stellated-dodecahedron",
     "Great stellated dodecahedron: 12 pentagrams, three at each corner of the dodecahedron.",
     DODECAHEDRON,
     4,
     {{5, 2}},
     false,
     true},
    {"great-icosahedron",
     "Great icosahedron: 20 triangles, five at each corner of the icosahedron.",
     ICOSAHEDRON,
     2,
     {{3, 1}},
     false,
     false},
    {"tetrahemihexahedron",
     "Tetrahemihexahedron: every second triangle of the octahedron, and three squares through the centre.",
     OCTAHEDRON,
     1,
     {{3, 1}, {4, 1}},
     true,
     false},
    {"octahemioctahedron",
     "Octahemioctahedron: the triangles of the cuboctahedron, and four hexagons through the centre.",
     CUBOCTAHEDRON,
     1,
     {{3, 1}, {6, 1}},
     false,
     false},
    {"cubohemioctahedron",
     "Cubohemioctahedron: the squares of the cuboctahedron, and four hexagons through the centre.",
     CUBOCTAHEDRON,
     1,
     {{4, 1}, {6, 1}},
     false,
     false},
    {"small-ditrigonal-icosidodecahedron",
     "Small ditrigonal icosidodecahedron: 20 triangles and 12 pentagrams on the corners of the dodecahedron.",
     DODECAHEDRON,
     2,
     {{3, 1}, {5, 2}},
     false,
     false},
    {"ditrigonal-dodecadodecahedron",
     "Ditrigonal dodecadodecahedron: 12 pentagons and 12 pentagrams on the corners of the dodecahedron.",
     DODECAHEDRON,
     2,
     {{5, 1}, {5, 2}},
     false,
     false},
    {"great-ditrigonal-icosidodecahedron",
     "Great ditrigonal icosidodecahedron: 20 triangles and 12 pentagons on the corners of the dodecahedron.",
     DODECAHEDRON,
     2,
     {{3, 1}, {5, 1}},
     false,
     false},
    {"dodecadodecahedron",
     "Dodecadodecahedron: 12 pentagons and 12 pentagrams on the corners of the icosidodecahedron.",
     ICOSIDODECAHEDRON,
     2,
     {{5, 1}, {5, 2}},
     false,
     false},
    {"great-icosidodecahedron",
     "Great icosidodecahedron: 20 triangles and 12 pentagrams on the corners of the icosidodecahedron.",
     ICOSIDODECAHEDRON,
     5,
     {{3, 1}, {5, 2}},
     false,
     false},
    {"small-icosihemidodecahedron",
     "Small icosihemidodecahedron: the triangles of the icosidodecahedron, and six decagons through the\ncentre.",
     ICOSIDODECAHEDRON,
     1,
     {{3, 1}, {10, 1}},
     false,
     false},
    {"great-dodecahemicosahedron",
     "Great dodecahemicosahedron: 12 pentagons on the corners of the icosidodecahedron, and ten hexagons\nthrough the "
     "centre.",
     ICOSIDODECAHEDRON,
     2,
     {{5, 1}, {6, 1}},
     false,
     false},
    {"great-dodecahemidodecahedron",
     "Great dodecahemidodecahedron: 12 pentagrams on the corners of the icosidodecahedron, and six decagrams\n{10/3} "
     "through the centre.",
     ICOSIDODECAHEDRON,
     5,
     {{5, 2}, {10, 3}},
     false,
     false},
    {"small-dodecicosidodecahedron",
     "Small dodecicosidodecahedron: the triangles and pentagons of the rhombicosidodecahedron, and 12 decagons.",
     RHOMBICOSIDODECAHEDRON,
     1,
     {{3, 1}, {5, 1}, {10, 1}},
     false,
     false},
    {"small-stellated-truncated-dodecahedron",
     "Small stellated truncated dodecahedron: 12 pentagons and 12 decagrams {10/3} on the corners of "
     "the\nrhombicosidodecahedron.",
     RHOMBICOSIDODECAHEDRON,
     7,
     {{5, 1}, {10, 3}},
     false,
     false},
};

/* ---- edges ------------------------------------------------------------------------------------------------------ */

/* The data of the search: the solid, and for each corner the other ends of its edges. */
typedef struct edges {
    const body *solid;
    double length2; /* squared length of the edges */
    uint32_t degree[120], end[120][NEIGHBOUR_MAX];
} edges;

static double distance2(const body *b, uint32_t i, uint32_t j)
{
    roberts_vec3 d = vec3_sub(b->vertex[i], b->vertex[j]);
    return vec3_dot(d, d);
}

static bool same(double a, double b)
{
    return fabs(a - b) < SAME * fmax(a, b);
}

/* Returns the least squared distance from corner 0 above `least`. */
static double next_distance2(const body *b, double least)
{
    double next = INFINITY;
    for (uint32_t j = 1; j < b->vertex_count; j++) {
        double d = distance2(b, 0, j);
        if (d > least * (1 + SAME))
            next = fmin(next, d);
    }
    return next;
}

static void find_edges(edges *e, const body *solid, int distance)
{
    e->solid = solid;
    e->length2 = 0;
    for (int i = 0; i < distance; i++)
        e->length2 = next_distance2(solid, e->length2);
    for (uint32_t i = 0; i < solid->vertex_count; i++) {
        e->degree[i] = 0;
        for (uint32_t j = 0; j < solid->vertex_count; j++)
            if (j != i && same(distance2(solid, i, j), e->length2) && e->degree[i] < NEIGHBOUR_MAX)
                e->end[i][e->degree[i]++] = j;
    }
}

/* ---- faces ------------------------------------------------------------------------------------------------------ */

/* Returns the turn from edge ij to edge jk. */
static roberts_vec3 turning(const body *b, uint32_t i, uint32_t j, uint32_t k)
{
    return vec3_cross(vec3_sub(b->vertex[j], b->vertex[i]), vec3_sub(b->vertex[k], b->vertex[j]));
}

/* Returns the corner after i, j, k in the regular polygon through them; NONE: none. */
static uint32_t corner_after(const edges *e, uint32_t i, uint32_t j, uint32_t k)
{
    roberts_vec3 n = turning(e->solid, i, j, k);
    for (uint32_t m = 0; m < e->degree[k]; m++) {
        uint32_t next = e->end[k][m];
        if (vec3_length(vec3_sub(turning(e->solid, j, k, next), n)) < SAME * e->length2)
            return next;
    }
    return NONE;
}

/* Adds the polygon with its front outward. */
static void add_outward(body *b, const body *solid, const uint32_t *corner, uint32_t count)
{
    bool outward = vec3_dot(turning(solid, corner[0], corner[1], corner[2]), solid->vertex[corner[0]]) > 0;
    for (uint32_t i = 0; i < count; i++)
        body_corner(b, corner[outward || i == 0 ? i : count - i]);
    body_end_face(b);
}

/* Adds the polygon of this kind through the edges ij and jk, if there is one with i as its smallest corner and j as the
 * smaller one beside it. */
static void add_polygon(body *b, const edges *e, polygon kind, const uint32_t start[3])
{
    double diagonal = 2 * circle_point(kind.turns, UINT64_C(2) * kind.corners).x; /* from i to k, in edges */
    uint32_t corner[CORNER_MAX] = {start[0], start[1], start[2]};
    if (!same(distance2(e->solid, start[0], start[2]), diagonal * diagonal * e->length2))
        return;
    for (uint32_t n = 2; n < kind.corners; n++) {
        uint32_t next = corner_after(e, corner[n - 2], corner[n - 1], corner[n]);
        if (next == NONE || (next == start[0]) != (n + 1 == kind.corners) || next < start[0])
            return;
        if (n + 1 < kind.corners)
            corner[n + 1] = next;
    }
    if (corner[1] < corner[kind.corners - 1])
        add_outward(b, e->solid, corner, kind.corners);
}

static void add_polygons(body *b, const edges *e, polygon kind)
{
    for (uint32_t i = 0; i < e->solid->vertex_count; i++)
        for (uint32_t n = 0; n < e->degree[i]; n++) {
            uint32_t j = e->end[i][n];
            for (uint32_t m = 0; m < e->degree[j]; m++)
                if (e->end[j][m] > i && j > i)
                    add_polygon(b, e, kind, (uint32_t[]){i, j, e->end[j][m]});
        }
}

/* Is the triangle over an octant with an odd number of negative signs? */
static bool left_out(const body *all, size_t f)
{
    roberts_vec3 n = body_face_normal(all, f);
    return all->face_end[f] - body_face_start(all, f) == 3 && n.x * n.y * n.z < 0;
}

/* Faces in parallel planes get one colour. The six are those of Okabe and Ito that differ most, "Color universal
 * design" (2008): people who are colour-blind can tell them apart. */
static void color_directions(body *b)
{
    static const uint32_t six[6] = {0xe69f00, 0x56b4e9, 0x009e73, 0xf0e442, 0xd55e00, 0xcc79a7};
    uint32_t color[12], directions = 0;
    for (size_t f = 0; f < b->face_count; f++) {
        roberts_vec3 n = body_face_normal(b, f);
        size_t g = 0;
        while (g < f && vec3_length(vec3_cross(n, body_face_normal(b, g))) > SAME * vec3_dot(n, n))
            g++;
        color[f] = g < f ? color[g] : six[directions++];
    }
    body_color(b, color);
}

static void make_on_corners(body *b, const star *s)
{
    body solid = {0}, all = {0};
    edges e;
    uniform_make(&solid, s->solid);
    find_edges(&e, &solid, s->distance);
    for (uint32_t v = 0; v < solid.vertex_count; v++) {
        roberts_vec3 p = solid.vertex[v];
        body_vertex(&all, p.x, p.y, p.z);
        body_vertex(b, p.x, p.y, p.z);
    }
    for (int k = 0; k < 3 && s->face[k].corners; k++)
        add_polygons(&all, &e, s->face[k]);
    for (size_t f = 0; f < all.face_count; f++)
        if (!s->half || !left_out(&all, f))
            body_face(b, all.corner + body_face_start(&all, f), all.face_end[f] - body_face_start(&all, f));
    if (s->colored)
        color_directions(b);
    body_free(&all);
    body_free(&solid);
}

/* ---- over the pentagram ----------------------------------------------------------------------------------------- */

/* Adds five points at height z on a circle of radius 1, in the order of a pentagram; the first is at `tenths` of a
 * turn. */
static void add_pentagram(body *b, double z, uint32_t tenths)
{
    uint32_t base = (uint32_t)b->vertex_count;
    for (uint32_t i = 0; i < 5; i++) {
        roberts_vec2 p = circle_point(tenths + 4 * i, 10);
        body_vertex(b, p.x, p.y, z);
    }
    for (uint32_t i = 0; i < 5; i++)
        body_corner(b, base + (z > 0 ? i : 4 - i));
    body_end_face(b);
}

static void pentagrammic_prism(body *b)
{
    double half = circle_point(2, 10).y; /* half a side of the pentagram */
    add_pentagram(b, -half, 0);
    add_pentagram(b, half, 0);
    for (uint32_t i = 0; i < 5; i++)
        body_face(b, (uint32_t[]){i, (i + 1) % 5, 5 + (i + 1) % 5, 5 + i}, 4);
}

/* The upper pentagram lies above the lower one, or is turned by half a turn. Side i of the lower one goes from 4 i to 4
 * i + 4 tenths; above its middle, or opposite to it, is the corner at 4 i + 2 or 4 i + 7 tenths. The sides of the
 * triangles equal those of the pentagrams; seen from above, they are as long as the chord from there to an end. */
static void pentagrammic_antiprism(body *b, bool crossed)
{
    double side = 2 * circle_point(2, 10).y, seen = 2 * circle_point(crossed ? 3 : 2, 20).y;
    double half = sqrt((side - seen) * (side + seen)) / 2;
    add_pentagram(b, -half, 0);
    add_pentagram(b, half, crossed ? 5 : 0);
    for (uint32_t i = 0; i < 5; i++) {
        uint32_t j = (i + 1) % 5, k = 5 + (i + 3) % 5; /* 4 (i + 3) = 4 i + 2, in tenths from the ring's first corner */
        body_face(b, (uint32_t[]){i, j, k}, 3);
        body_face(b, (uint32_t[]){k, 5 + (i + 4) % 5, j}, 3);
    }
}

static void pentagrammic_right_antiprism(body *b)
{
    pentagrammic_antiprism(b, false);
}

static void pentagrammic_crossed_antiprism(body *b)
{
    pentagrammic_antiprism(b, true);
}

/* ---- the table -------------------------------------------------------------------------------------------------- */

static const scene over_pentagram[] = {
    {"pentagrammic-prism", "Uniform prism over the pentagram: circumradius 1, five squares.", pentagrammic_prism},
    {"pentagrammic-antiprism", "Uniform antiprism over the pentagram: circumradius 1, ten triangles.",
     pentagrammic_right_antiprism},
    {"pentagrammic-crossed-antiprism",
     "Uniform crossed antiprism over the pentagram: circumradius 1, ten triangles that cross the axis.",
     pentagrammic_crossed_antiprism},
};

enum { ON_CORNERS = sizeof stars / sizeof *stars };

size_t star_count(void)
{
    return ON_CORNERS + sizeof over_pentagram / sizeof *over_pentagram;
}

const char *star_name(size_t i)
{
    return i < ON_CORNERS ? stars[i].name : over_pentagram[i - ON_CORNERS].name;
}

const char *star_about(size_t i)
{
    return i < ON_CORNERS ? stars[i].about : over_pentagram[i - ON_CORNERS].about;
}

void star_make(body *b, size_t i)
{
    if (i < ON_CORNERS)
        make_on_corners(b, &stars[i]);
    else
        over_pentagram[i - ON_CORNERS].make(b);
}
