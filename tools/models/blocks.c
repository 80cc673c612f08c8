/* blocks.c - convex solids that touch flush or interpenetrate: together they look like one body. */
#include "exact.h"
#include "figures.h"
#include "uniform.h"

/* ---- compound of five tetrahedra -------------------------------------------------------------------------------- */

static uint32_t nearest_vertex(const body *b, roberts_vec3 p)
{
    uint32_t nearest = 0;
    for (uint32_t v = 1; v < b->vertex_count; v++)
        if (vec3_length(vec3_sub(b->vertex[v], p)) < vec3_length(vec3_sub(b->vertex[nearest], p)))
            nearest = v;
    return nearest;
}

/* The tetrahedron in the cube (+-1, +-1, +-1) is turned by fifths about an axis of the dodecahedron. Its corners remain
 * corners of the dodecahedron, so they get exactly those coordinates. */
void five_tetrahedra(body *b)
{
    const double g = (1 + sqrt(5)) / 2, h = 1 / (2 * g);
    const motion fifth = {{{h, -0.5, g / 2}, {0.5, g / 2, h}, {-g / 2, h, 0.5}}, {0, 0, 0}};
    body dodecahedron = {0}, part = {0};
    uniform_make(&dodecahedron, DODECAHEDRON);
    uniform_make(&part, TETRAHEDRON);
    for (int i = 0; i < 5; i++) {
        body turned = {0};
        for (size_t v = 0; v < part.vertex_count; v++)
            part.vertex[v] = dodecahedron.vertex[nearest_vertex(&dodecahedron, part.vertex[v])];
        body_add(b, &part, turn(1, 0, 0, 0, 1, vec3(0, 0, 0)));
        body_add(&turned, &part, fifth);
        body_free(&part);
        part = turned;
    }
    body_free(&part);
    body_free(&dodecahedron);
}

/* ---- Menger sponge ---------------------------------------------------------------------------------------------- */

/* Is the middle third cut away here? It is if two of the three coordinates are in the middle. */
static bool cut_away(int x, int y, int z)
{
    return (x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2;
}

void menger_sponge(body *b)
{
    const int side = 9;
    for (int i = 0; i < side * side * side; i++) {
        int x = i % side, y = i / side % side, z = i / side / side;
        if (!cut_away(x, y, z) && !cut_away(x / 3, y / 3, z / 3))
            body_box(b, vec3(x, y, z), vec3(x + 1, y + 1, z + 1));
    }
}

/* ---- a locomotive ----------------------------------------------------------------------------------------------- */

/* The axis of a column: its direction, and where its point 0 is. */
typedef struct axis {
    enum { ALONG_X, ALONG_Y, ALONG_Z } along;
    roberts_vec3 origin;
} axis;

/* Adds a column of n sides from z0 to z1 on its axis. */
static void add_column(body *b, axis a, uint32_t n, double radius, double z0, double z1)
{
    static const motion axes[] = {[ALONG_X] = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 0}},
                                  [ALONG_Y] = {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, {0, 0, 0}},
                                  [ALONG_Z] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}}};
    motion move = axes[a.along];
    body column = {0};
    move.shift = a.origin;
    column_make(&column, n, radius, z0, z1);
    body_add(b, &column, move);
    body_free(&column);
}

/* Adds a box on both sides: y from y0 to y1 and from -y1 to -y0. */
static void add_pair(body *b, roberts_vec3 lo, roberts_vec3 hi)
{
    body_box(b, lo, hi);
    body_box(b, vec3(lo.x, -hi.y, lo.z), vec3(hi.x, -lo.y, hi.z));
}

static void add_wheels(body *b, double x, double radius)
{
    const axis axle = {ALONG_Y, {x, 0, radius}};
    add_column(b, axle, 24, radius, 3, 3.75);
    add_column(b, axle, 24, radius, -3.75, -3);
}

static void running_gear(body *b)
{
    body_box(b, vec3(0, -3, 3), vec3(24, 3, 4)); /* the frame */
    for (int i = 0; i < 3; i++)
        add_wheels(b, 4 + 5.5 * i, 2.5);
    add_wheels(b, 21, 1.5);
    add_pair(b, vec3(3, 3.75, 2.25), vec3(16, 4.25, 2.75));    /* rods on the wheels */
    add_pair(b, vec3(18, 3, 3.25), vec3(23.5, 5, 5.25));       /* cylinders beside the frame */
    add_pair(b, vec3(15.5, 4.25, 2.375), vec3(16, 4.75, 4.5)); /* crossheads, from the rod up to the piston */
    add_pair(b, vec3(15.5, 4.25, 4), vec3(18, 4.75, 4.5));     /* pistons, which go into the cylinder */
    body_box(b, vec3(24, -4, 2.5), vec3(24.5, 4, 4.25));       /* the buffer beam */
    for (int side = -1; side < 2; side += 2) {
        const axis buffer = {ALONG_X, {0, 2.5 * side, 3.375}};
        add_column(b, buffer, 12, 0.5, 24.5, 25.5);
        add_column(b, buffer, 12, 0.875, 25.5, 25.75);
    }
}

static void cab(body *b)
{
    add_pair(b, vec3(0, 2.5, 4), vec3(8, 3, 9)); /* walls, flush with the frame */
    body_box(b, vec3(7.5, -2.5, 4), vec3(8, 2.5, 9));
    for (int i = 0; i < 2; i++)
        add_pair(b, vec3(7.5 * i, 2.5, 9), vec3(7.5 * i + 0.5, 3, 12.5));
    body_box(b, vec3(7.5, -2.5, 9), vec3(8, 2.5, 12.5));
    add_pair(b, vec3(0.5, 2.5, 12), vec3(7.5, 3, 12.5));
    body_box(b, vec3(-0.5, -3.75, 12.5), vec3(9, 3.75, 13));
}

/* The boiler goes through the cab's wall, the smoke box and the saddles; the parts on top go into it. */
static void boiler(body *b)
{
    const axis middle = {ALONG_X, {0, 0, 7.5}}, chimney = {ALONG_Z, {21.25, 0, 0}}, dome = {ALONG_Z, {14, 0, 0}};
    add_column(b, middle, 16, 2.75, 6, 19.5);
    add_column(b, middle, 16, 3, 19, 23.5);
    add_column(b, middle, 16, 1.75, 23.5, 23.75);
    for (int i = 0; i < 2; i++)
        add_column(b, middle, 16, 2.875, 11 + 5 * i, 11.5 + 5 * i);
    body_box(b, vec3(19.5, -2, 4), vec3(23, 2, 6));
    body_box(b, vec3(8, -2.5, 4), vec3(10, 2.5, 7));
    add_column(b, chimney, 12, 1, 9.5, 14);
    add_column(b, chimney, 12, 1.375, 14, 14.75);
    add_column(b, dome, 12, 1.375, 9, 11.5);
    cone_make(b, 12, 1.375, 11.5, 12.5);
    for (size_t v = b->vertex_count - 13; v < b->vertex_count; v++)
        b->vertex[v].x += 14;
}

static void track(body *b)
{
    add_pair(b, vec3(-3, 3.125, -0.5), vec3(29, 3.625, 0));
    for (int i = 0; i < 8; i++)
        body_box(b, vec3(-2 + 4 * i, -5, -1), vec3(-0.5 + 4 * i, 5, -0.5));
}

void locomotive(body *b)
{
    track(b);
    running_gear(b);
    boiler(b);
    cab(b);
}
