/* families.c - the families. Contact is made with whole numbers, halves and powers of two, and the view is turned, not the
 * scene: so doubles hold every contact exactly. The families "turned", "tenth" and "tiny" then spoil it by rounding on
 * purpose. Every face is given either winding, because nobody may trust it. */
#include "families.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- random numbers: splitmix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014) -- */

typedef struct dice {
    uint64_t state;
} dice;

static uint64_t dice_next(dice *d)
{
    uint64_t z = d->state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/* A whole number of lo .. hi. */
static int dice_int(dice *d, int lo, int hi)
{
    return lo + (int)(dice_next(d) % (uint64_t)(hi - lo + 1));
}

/* A double of -1 .. 1. */
static double dice_real(dice *d)
{
    return (double)(int64_t)dice_next(d) / 9223372036854775808.0;
}

/* ---- shapes: convex polyhedra with whole coordinates ------------------------------------------------------------- */

enum { SHAPE_POINTS = 64, SHAPE_CORNERS = 512 };

/* Coordinates are below 2^18 in size, so that every determinant of three differences fits 64 bits. */
typedef struct shape {
    int point_count, face_count, corner_count;
    int64_t point[SHAPE_POINTS][3];
    int face_start[SHAPE_CORNERS]; /* [face_count + 1] */
    int corner[SHAPE_CORNERS];
} shape;

static int64_t det3(const int64_t *o, const int64_t *a, const int64_t *b, const int64_t *c)
{
    int64_t u[3], v[3], w[3];
    for (int i = 0; i < 3; i++) {
        u[i] = a[i] - o[i];
        v[i] = b[i] - o[i];
        w[i] = c[i] - o[i];
    }
    return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

static void normal3(const int64_t *o, const int64_t *a, const int64_t *b, int64_t *n)
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = (a[j] - o[j]) * (b[k] - o[k]) - (a[k] - o[k]) * (b[j] - o[j]);
    }
}

/* Walks round the points of one plane, from corner to corner of their convex polygon (gift wrapping), n to the left. */
static int wrap_face(const shape *s, const int *on, int count, const int64_t *n, int *corner)
{
    int first = on[0], axis = n[0] ? 0 : n[1] ? 1 : 2, at, used = 0;
    for (int i = 1; i < count; i++) /* the least point in lexical order is a corner */
        for (int k = 0; k < 3; k++)
            if (s->point[on[i]][k] != s->point[first][k]) {
                first = s->point[on[i]][k] < s->point[first][k] ? on[i] : first;
                break;
            }
    at = first;
    do {
        int next = -1;
        corner[used++] = at;
        for (int i = 0; i < count; i++) {
            int64_t m[3], far = 0, near = 0;
            int turn;
            if (on[i] == at)
                continue;
            if (next < 0) {
                next = on[i];
                continue;
            }
            normal3(s->point[at], s->point[next], s->point[on[i]], m);
            turn = ((m[axis] > 0) - (m[axis] < 0)) * (n[axis] > 0 ? 1 : -1); /* m is parallel to n, or zero */
            for (int k = 0; k < 3; k++) {
                far += llabs(s->point[on[i]][k] - s->point[at][k]);
                near += llabs(s->point[next][k] - s->point[at][k]);
            }
            if (turn < 0 || (turn == 0 && far > near))
                next = on[i];
        }
        at = next;
    } while (at != first && used < count);
    return used;
}

/* Leaves the convex hull of the shape's points in the shape; false where they are flat or the hull is too large. Each
 * plane with all points on one side is a face: plain enough to be believed, and fast enough for 64 points. */
static bool shape_hull(shape *s)
{
    uint64_t seen[SHAPE_CORNERS];
    bool used[SHAPE_POINTS] = {false};
    int number[SHAPE_POINTS], kept = 0;
    s->face_count = s->corner_count = 0;
    s->face_start[0] = 0;
    for (int i = 0; i < s->point_count; i++)
        for (int j = i + 1; j < s->point_count; j++)
            for (int k = j + 1; k < s->point_count; k++) {
                int on[SHAPE_POINTS], count = 0, f = 0;
                bool above = false, below = false;
                uint64_t mask = 0;
                int64_t n[3];
                normal3(s->point[i], s->point[j], s->point[k], n);
                if (!n[0] && !n[1] && !n[2])
                    continue;
                for (int m = 0; m < s->point_count && !(above && below); m++) {
                    int64_t d = det3(s->point[i], s->point[j], s->point[k], s->point[m]);
                    above |= d > 0;
                    below |= d < 0;
                    if (d == 0) {
                        on[count++] = m;
                        mask |= (uint64_t)1 << m;
                    }
                }
                if (above == below) /* points on both sides; or all in the plane */
                    continue;
                while (f < s->face_count && seen[f] != mask)
                    f++;
                if (f < s->face_count)
                    continue;
                if (s->corner_count + count > SHAPE_CORNERS || s->face_count + 2 > SHAPE_CORNERS)
                    return false;
                seen[s->face_count++] = mask;
                s->corner_count += wrap_face(s, on, count, n, s->corner + s->corner_count);
                s->face_start[s->face_count] = s->corner_count;
            }
    for (int i = 0; i < s->corner_count; i++)
        used[s->corner[i]] = true;
    for (int i = 0; i < s->point_count; i++)
        if (used[i]) {
            number[i] = kept;
            memcpy(s->point[kept++], s->point[i], sizeof s->point[0]);
        }
    for (int i = 0; i < s->corner_count; i++)
        s->corner[i] = number[s->corner[i]];
    s->point_count = kept;
    return s->face_count >= 4;
}

static void shape_point(shape *s, int64_t x, int64_t y, int64_t z)
{
    int64_t p[3] = {x, y, z};
    for (int i = 0; i < s->point_count; i++)
        if (memcmp(s->point[i], p, sizeof p) == 0)
            return;
    if (s->point_count < SHAPE_POINTS)
        memcpy(s->point[s->point_count++], p, sizeof p);
}

static shape shape_box(int x, int y, int z)
{
    shape s = {0};
    for (int i = 0; i < 8; i++)
        shape_point(&s, i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0);
    shape_hull(&s);
    return s;
}

/* The hull of `count` random points with coordinates of 0 .. size. Small sizes give many-cornered faces. */
static shape shape_random(dice *d, int count, int size)
{
    shape s;
    do {
        s = (shape){0};
        for (int i = 0; i < count; i++)
            shape_point(&s, dice_int(d, 0, size), dice_int(d, 0, size), dice_int(d, 0, size));
    } while (!shape_hull(&s));
    return s;
}

/* A prism or a pyramid, leaning, over a polygon of up to 16 corners whose sides are the first whole vectors by angle. */
static shape shape_prism(dice *d)
{
    static const int side[16][2] = {{1, 0},  {2, 1},   {1, 1},   {1, 2},   {0, 1},  {-1, 2}, {-1, 1}, {-2, 1},
                                    {-1, 0}, {-2, -1}, {-1, -1}, {-1, -2}, {0, -1}, {1, -2}, {1, -1}, {2, -1}};
    shape s = {0};
    int x = 0, y = 0, lean_x = dice_int(d, -2, 2), lean_y = dice_int(d, -2, 2), high = dice_int(d, 1, 5);
    int step = 1 << dice_int(d, 0, 2), axis = dice_int(d, 0, 2);
    bool pyramid = dice_int(d, 0, 2) == 0;
    for (int i = 0; i < 16; i += step) {
        shape_point(&s, x, y, 0);
        if (!pyramid)
            shape_point(&s, x + lean_x, y + lean_y, high);
        x += side[i][0];
        y += side[i][1];
    }
    if (pyramid)
        shape_point(&s, lean_x, lean_y + 3, high);
    for (int i = 0; i < s.point_count; i++) { /* lay it along another axis */
        int64_t p[3] = {s.point[i][0], s.point[i][1], s.point[i][2]};
        for (int k = 0; k < 3; k++)
            s.point[i][k] = p[(k + axis) % 3];
    }
    shape_hull(&s);
    return s;
}

static shape shape_any(dice *d)
{
    switch (dice_int(d, 0, 5)) {
    case 0:
        return shape_box(dice_int(d, 1, 4), dice_int(d, 1, 4), dice_int(d, 1, 4));
    case 1:
        return shape_prism(d);
    case 2:
        return shape_random(d, 4, 3);
    case 3:
        return shape_random(d, 6, 2);
    case 4:
        return shape_random(d, 10, 3);
    default:
        return shape_random(d, 20, 4);
    }
}

/* ---- scenes ------------------------------------------------------------------------------------------------------ */

typedef struct studio {
    test_scene *scene;
    dice d;
    double unit;    /* the eye's coordinates are multiples of it */
    bool eye;       /* perspective wanted */
    bool no_memory; /* checked once, at the end */
} studio;

/* Adds the shape, each of its points sent to at + m p; rows of m are the images' coordinates. */
static void put_mapped(studio *st, const shape *s, roberts_vec3 at, double m[3][3])
{
    roberts_mesh *mesh = &st->scene->mesh;
    uint32_t base = (uint32_t)mesh->vertex_count;
    for (int i = 0; i < s->point_count && !st->no_memory; i++) {
        double p[3] = {(double)s->point[i][0], (double)s->point[i][1], (double)s->point[i][2]};
        roberts_vec3 v = {at.x + (m[0][0] * p[0] + m[0][1] * p[1] + m[0][2] * p[2]),
                          at.y + (m[1][0] * p[0] + m[1][1] * p[1] + m[1][2] * p[2]),
                          at.z + (m[2][0] * p[0] + m[2][1] * p[1] + m[2][2] * p[2])};
        st->no_memory = roberts_mesh_add_vertex(mesh, v, NULL, NULL) != ROBERTS_OK;
    }
    for (int f = 0; f < s->face_count && !st->no_memory; f++) {
        uint32_t face[SHAPE_CORNERS];
        int count = s->face_start[f + 1] - s->face_start[f], first = dice_int(&st->d, 0, count - 1);
        bool back = dice_int(&st->d, 0, 1);
        for (int i = 0; i < count; i++)
            face[i] = base + (uint32_t)s->corner[s->face_start[f] + (first + (back ? count - i : i)) % count];
        st->no_memory = roberts_mesh_add_face(mesh, face, (size_t)count, NULL) != ROBERTS_OK;
    }
}

static void put_scaled(studio *st, const shape *s, roberts_vec3 at, double x, double y, double z)
{
    double m[3][3] = {{x, 0, 0}, {0, y, 0}, {0, 0, z}};
    put_mapped(st, s, at, m);
}

static void put(studio *st, const shape *s, double x, double y, double z)
{
    put_scaled(st, s, (roberts_vec3){x, y, z}, 1, 1, 1);
}

/* A corner takes its numbers as they are: nothing is computed, nothing rounded. */
static void put_box(studio *st, double x0, double y0, double z0, double x1, double y1, double z1)
{
    shape unit = shape_box(1, 1, 1);
    size_t base = st->scene->mesh.vertex_count;
    put(st, &unit, 0, 0, 0);
    for (size_t i = 0; i < 8 && !st->no_memory; i++)
        st->scene->mesh.vertex[base + i] =
            (roberts_vec3){unit.point[i][0] ? x1 : x0, unit.point[i][1] ? y1 : y0, unit.point[i][2] ? z1 : z0};
}

static void put_turned(studio *st, const shape *s, roberts_vec3 at, double size)
{
    double q[4], m[3][3], l;
    do {
        l = 0;
        for (int i = 0; i < 4; i++) {
            q[i] = dice_real(&st->d);
            l += q[i] * q[i];
        }
    } while (l > 1 || l < 0.01);
    for (int i = 0; i < 3; i++) /* the rotation of a quaternion */
        for (int j = 0; j < 3; j++) {
            int k = 3 - i - j, sign = (j + 3 - i) % 3 == 1 ? -1 : 1;
            double diagonal =
                l - 2 * (q[1 + (i + 1) % 3] * q[1 + (i + 1) % 3] + q[1 + (i + 2) % 3] * q[1 + (i + 2) % 3]);
            m[i][j] = i == j ? size * diagonal / l : size * 2 * (q[1 + i] * q[1 + j] + sign * q[0] * q[1 + k]) / l;
        }
    put_mapped(st, s, at, m);
}

/* ---- views ------------------------------------------------------------------------------------------------------- */

static void look(studio *st, double x, double y, double z)
{
    st->scene->view = (oracle_view){x, y, z, 0};
}

static void look_small(studio *st, int size)
{
    int x, y, z;
    do {
        x = dice_int(&st->d, -size, size);
        y = dice_int(&st->d, -size, size);
        z = dice_int(&st->d, -size, size);
    } while (!x && !y && !z);
    look(st, x, y, z);
}

static void look_axis(studio *st)
{
    double v[3] = {0, 0, 0};
    v[dice_int(&st->d, 0, 2)] = dice_int(&st->d, 0, 1) ? 1 : -1;
    look(st, v[0], v[1], v[2]);
}

static void look_corner(studio *st)
{
    look(st, dice_int(&st->d, 0, 1) ? 1 : -1, dice_int(&st->d, 0, 1) ? 1 : -1, dice_int(&st->d, 0, 1) ? 1 : -1);
}

static void look_random(studio *st)
{
    look(st, dice_real(&st->d), dice_real(&st->d), dice_real(&st->d));
}

static void look_any(studio *st)
{
    switch (dice_int(&st->d, 0, 5)) {
    case 0:
        look_axis(st);
        break;
    case 1:
        look_corner(st);
        break;
    case 2:
        look(st, 1, 2, 1.5);
        break;
    case 3:
        look_small(st, 2);
        break;
    case 4:
        look_small(st, 1000);
        break;
    default:
        look_random(st);
    }
}

/* ---- what is not judged ------------------------------------------------------------------------------------------ */

/* Where contacts are rounded: moves of this part of the largest coordinate. */
#define ROUNDING 1e-13

/* What lies nearer than 1e-11 of the scene's diameter counts as touching, by the specification. Where a family makes
 * clearances of any size, those up to twice as large are not judged. Call it last. */
#define TOUCHING 2e-11

static double diameter(const roberts_mesh *mesh, roberts_vec3 *lo, roberts_vec3 *hi)
{
    *lo = *hi = mesh->vertex[0];
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        roberts_vec3 p = mesh->vertex[i];
        *lo = (roberts_vec3){fmin(lo->x, p.x), fmin(lo->y, p.y), fmin(lo->z, p.z)};
        *hi = (roberts_vec3){fmax(hi->x, p.x), fmax(hi->y, p.y), fmax(hi->z, p.z)};
    }
    return hypot(hypot(hi->x - lo->x, hi->y - lo->y), hi->z - lo->z);
}

static void near_touching(studio *st)
{
    roberts_vec3 lo, hi;
    if (!st->no_memory)
        st->scene->slack = TOUCHING * diameter(&st->scene->mesh, &lo, &hi);
}

/* ---- eyes -------------------------------------------------------------------------------------------------------- */

/* Moves the viewer from infinity to an eye with whole coordinates (times the scene's unit), well before the scene. */
static void look_from_eye(studio *st)
{
    oracle_view *view = &st->scene->view;
    roberts_vec3 lo, hi;
    double away = diameter(&st->scene->mesh, &lo, &hi) * dice_int(&st->d, 3, 9) / 2;
    away /= hypot(hypot(view->x, view->y), view->z);
    view->x = st->unit * ceil(((lo.x + hi.x) / 2 + away * view->x) / st->unit);
    view->y = st->unit * ceil(((lo.y + hi.y) / 2 + away * view->y) / st->unit);
    view->z = st->unit * ceil(((lo.z + hi.z) / 2 + away * view->z) / st->unit);
    view->w = 1;
}

/* ---- families in general position -------------------------------------------------------------------------------- */

/* n^3 solids, each turned at random. */
static void lattice(studio *st)
{
    int n = dice_int(&st->d, 2, 4);
    for (int i = 0; i < n * n * n; i++) {
        shape s = shape_any(&st->d);
        int column = i / n, layer = column / n;
        roberts_vec3 at = {i % n, column % n, layer};
        put_turned(st, &s, at, 0.15 + 0.05 * dice_real(&st->d));
    }
    look_random(st);
}

/* Hulls of random points: triangles, well apart or through one another. */
static void hulls(studio *st)
{
    int count = dice_int(&st->d, 10, 40), spread = dice_int(&st->d, 1, 5) * 65536;
    for (int i = 0; i < count; i++) {
        shape s = shape_random(&st->d, dice_int(&st->d, 4, 16), 65536);
        put(st, &s, dice_int(&st->d, 0, spread), dice_int(&st->d, 0, spread), dice_int(&st->d, 0, spread));
    }
    look_random(st);
}

/* Some hundred solids of all sizes before one another: most is hidden many times over. */
static void swarm(studio *st)
{
    int count = dice_int(&st->d, 100, 300);
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        roberts_vec3 at = {dice_real(&st->d), dice_real(&st->d), 3 * dice_real(&st->d)};
        put_turned(st, &s, at, pow(10, dice_real(&st->d) - 1.7));
    }
    look(st, 0.2 * dice_real(&st->d), 0.2 * dice_real(&st->d), 1);
}

/* Solids that pierce one another, anyhow. */
static void crossing(studio *st)
{
    int count = dice_int(&st->d, 6, 24);
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        roberts_vec3 at = {dice_real(&st->d), dice_real(&st->d), dice_real(&st->d)};
        put_turned(st, &s, at, 0.3);
    }
    look_random(st);
}

/* Thin parallelograms, turned anyhow. */
static void slanted_plates(studio *st)
{
    int count = dice_int(&st->d, 6, 24);
    double thin = dice_int(&st->d, 0, 1) ? 1e-3 : 1e-6;
    shape box = shape_box(1, 1, 1);
    while (count-- > 0) {
        double a[3], b[3], n[3], l, m[3][3];
        roberts_vec3 at = {dice_real(&st->d), dice_real(&st->d), dice_real(&st->d)};
        for (int k = 0; k < 3; k++) {
            a[k] = dice_real(&st->d);
            b[k] = dice_real(&st->d);
        }
        for (int k = 0; k < 3; k++)
            n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
        l = hypot(hypot(n[0], n[1]), n[2]);
        if (l < 0.1)
            continue;
        for (int k = 0; k < 3; k++) {
            m[k][0] = a[k];
            m[k][1] = b[k];
            m[k][2] = n[k] * thin / l;
        }
        put_mapped(st, &box, at, m);
    }
    if (st->scene->mesh.vertex_count == 0)
        put(st, &box, 0, 0, 0);
    look_random(st);
}

/* Long needles that are nearly parallel, so that they cross at small angles. */
static void needles(studio *st)
{
    int count = dice_int(&st->d, 6, 30);
    double spread = pow(10, -dice_int(&st->d, 0, 5)), thick = pow(10, -dice_int(&st->d, 1, 3));
    shape s = shape_random(&st->d, 4, 1);
    for (int i = 0; i < count; i++) {
        roberts_vec3 at = {0, dice_real(&st->d) * spread * 10, dice_real(&st->d)};
        double m[3][3] = {{20 + dice_real(&st->d), dice_real(&st->d), dice_real(&st->d)},
                          {20 * spread * dice_real(&st->d), thick, 0},
                          {20 * spread * dice_real(&st->d), 0, thick}};
        put_mapped(st, &s, at, m);
    }
    look(st, 0.3 * dice_real(&st->d), 0.3 * dice_real(&st->d), dice_int(&st->d, 0, 1) ? 1 : -1);
}

/* ---- families in degenerate position, exact ---------------------------------------------------------------------- */

/* Blocks between whole coordinates: touching, overlapping, lined up. */
static void blocks(studio *st)
{
    int count = dice_int(&st->d, 6, 40);
    for (int i = 0; i < count; i++) {
        int x = dice_int(&st->d, 0, 8), y = dice_int(&st->d, 0, 8), z = dice_int(&st->d, 0, 8);
        put_box(st, x, y, z, x + dice_int(&st->d, 1, 4), y + dice_int(&st->d, 1, 4), z + dice_int(&st->d, 1, 4));
    }
    if (dice_int(&st->d, 0, 2))
        dice_int(&st->d, 0, 1) ? look_axis(st) : look_corner(st);
    else
        look_any(st);
}

/* A deep shaft of blocks between whole coordinates: covers behind covers, and all of them in line. */
static void shaft(studio *st)
{
    int count = dice_int(&st->d, 100, 300);
    for (int i = 0; i < count; i++) {
        int x = dice_int(&st->d, 0, 10), y = dice_int(&st->d, 0, 10), z = dice_int(&st->d, 0, 300);
        int w = dice_int(&st->d, 1, 4), h = dice_int(&st->d, 1, 4), deep = dice_int(&st->d, 1, 9);
        put_box(st, x, y, z, x + w, y + h, z + deep);
    }
    look(st, dice_int(&st->d, -1, 1), dice_int(&st->d, -1, 1), dice_int(&st->d, 0, 1) ? 40 : -1);
}

/* A wall in running bond, some bricks missing: faces, edges and corners touch. */
static void bricks(studio *st)
{
    int rows = dice_int(&st->d, 2, 5), columns = dice_int(&st->d, 2, 5), deep = dice_int(&st->d, 1, 2);
    for (int z = 0; z < rows; z++)
        for (int x = 0; x < columns; x++)
            for (int y = 0; y < deep; y++)
                if (dice_int(&st->d, 0, 4))
                    put_box(st, 2 * x + z % 2, y, z, 2 * x + z % 2 + 2, y + 1, z + 1);
    put_box(st, -1, -1, -1, 2 * columns + 2, deep + 1, 0);
    look_any(st);
}

/* Cubes of a grid, some of them taken: many meet in an edge or a corner alone. */
static void checker(studio *st)
{
    int n = dice_int(&st->d, 2, 4), dense = dice_int(&st->d, 1, 3);
    put_box(st, 0, 0, 0, 1, 1, 1);
    for (int i = 1; i < n * n * n; i++)
        if (dice_int(&st->d, 0, 3) < dense) {
            int x = i % n, y = i / n % n, z = i / n / n;
            put_box(st, x, y, z, x + 1, y + 1, z + 1);
        }
    look_any(st);
}

/* Polyhedra with many-cornered faces on a fine lattice. */
static void polytopes(studio *st)
{
    int count = dice_int(&st->d, 5, 20), spread = dice_int(&st->d, 4, 30);
    for (int i = 0; i < count; i++) {
        shape s = dice_int(&st->d, 0, 1) ? shape_prism(&st->d) : shape_random(&st->d, 24, 5);
        put(st, &s, dice_int(&st->d, 0, spread), dice_int(&st->d, 0, spread), dice_int(&st->d, 0, spread));
    }
    look_any(st);
}

/* All kinds crowded on a coarse lattice and seen along short whole vectors: everything lines up with everything. */
static void crowd(studio *st)
{
    int count = dice_int(&st->d, 4, 24), spread = dice_int(&st->d, 2, 8);
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        put(st, &s, dice_int(&st->d, 0, spread), dice_int(&st->d, 0, spread), dice_int(&st->d, 0, spread));
    }
    dice_int(&st->d, 0, 3) ? look_small(st, 2) : look_any(st);
}

/* A corner, the middle of an edge or a point inside a face; coordinates of the shape are multiples of 6. */
static void anchor(dice *d, const shape *s, int64_t p[3])
{
    int f = dice_int(d, 0, s->face_count - 1), count = s->face_start[f + 1] - s->face_start[f];
    int kind = dice_int(d, 1, 3), first = dice_int(d, 0, count - 1);
    for (int k = 0; k < 3; k++) {
        p[k] = 0;
        for (int i = 0; i < kind; i++)
            p[k] += s->point[s->corner[s->face_start[f] + (first + i) % count]][k];
        p[k] /= kind;
    }
}

static shape shape_times_six(dice *d)
{
    shape s = shape_any(d);
    for (int i = 0; i < s.point_count; i++)
        for (int k = 0; k < 3; k++)
            s.point[i][k] *= 6;
    return s;
}

/* Each solid set so that a corner, an edge's middle or a point of a face touches one of the solid before it, or lies
 * before or behind it on the same sight line. */
static void touching(studio *st)
{
    int count = dice_int(&st->d, 3, 16);
    look_small(st, 3);
    shape before = shape_times_six(&st->d);
    int64_t at[3] = {0, 0, 0},
            dir[3] = {(int64_t)st->scene->view.x, (int64_t)st->scene->view.y, (int64_t)st->scene->view.z};
    put(st, &before, 0, 0, 0);
    for (int i = 1; i < count; i++) {
        shape s = shape_times_six(&st->d);
        int64_t p[3], q[3];
        int along = dice_int(&st->d, 0, 1) ? 0 : dice_int(&st->d, -12, 12);
        anchor(&st->d, &before, p);
        anchor(&st->d, &s, q);
        for (int k = 0; k < 3; k++)
            at[k] += p[k] - q[k] + along * dir[k];
        put(st, &s, (double)at[0], (double)at[1], (double)at[2]);
        before = s;
    }
}

/* The same before an eye: a solid touches one of those before, or has its point twice as far on the same sight line. */
static void touching_from_eye(studio *st)
{
    int count = dice_int(&st->d, 3, 16);
    look_small(st, 3);
    shape before = shape_times_six(&st->d);
    oracle_view *view = &st->scene->view;
    int64_t at[3] = {0, 0, 0}, eye[3] = {240 * (int64_t)view->x, 240 * (int64_t)view->y, 240 * (int64_t)view->z};
    put(st, &before, 0, 0, 0);
    for (int i = 1; i < count; i++) {
        shape s = shape_times_six(&st->d);
        int64_t p[3], q[3], to[3];
        bool behind = dice_int(&st->d, 0, 1);
        anchor(&st->d, &before, p);
        anchor(&st->d, &s, q);
        for (int k = 0; k < 3; k++)
            to[k] = behind ? 2 * (at[k] + p[k]) - eye[k] - q[k] : at[k] + p[k] - q[k];
        if (!behind && llabs(to[0]) + llabs(to[1]) + llabs(to[2]) > 120)
            continue; /* too near to the eye */
        put(st, &s, (double)to[0], (double)to[1], (double)to[2]);
        if (!behind) {
            memcpy(at, to, sizeof at);
            before = s;
        }
    }
    *view = (oracle_view){(double)eye[0], (double)eye[1], (double)eye[2], 1};
}

/* Solids within solids about common centres, some of the same size. */
static void nested(studio *st)
{
    int centres = dice_int(&st->d, 1, 4);
    for (int c = 0; c < centres; c++) {
        shape s = shape_any(&st->d);
        int x = dice_int(&st->d, 0, 40), y = dice_int(&st->d, 0, 40), z = dice_int(&st->d, 0, 40);
        const int64_t *p = s.point[0], *q = s.point[s.point_count - 1];
        int64_t middle[3] = {p[0] + q[0], p[1] + q[1], p[2] + q[2]}; /* twice a point of the solid */
        for (int i = dice_int(&st->d, 2, 6); i > 0; i--) {
            int k = dice_int(&st->d, 1, 6);
            put_scaled(st, &s,
                       (roberts_vec3){x - 0.5 * k * (double)middle[0], y - 0.5 * k * (double)middle[1],
                                      z - 0.5 * k * (double)middle[2]},
                       k, k, k);
        }
    }
    look_any(st);
}

/* Solids given two or three times over. */
static void twice(studio *st)
{
    int count = dice_int(&st->d, 2, 8);
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        int x = dice_int(&st->d, 0, 6), y = dice_int(&st->d, 0, 6), z = dice_int(&st->d, 0, 6);
        for (int k = dice_int(&st->d, 1, 3); k > 0; k--)
            put(st, &s, x, y, z);
    }
    look_any(st);
}

/* Thin plates on one another and apart, parallel to the axes; equal heights are the same double. */
static void heap(studio *st, double thin)
{
    int count = dice_int(&st->d, 6, 30);
    for (int i = 0; i < count; i++) {
        double x = dice_int(&st->d, 0, 6), y = dice_int(&st->d, 0, 6);
        int layer = dice_int(&st->d, 0, 5), way = dice_int(&st->d, 0, 4);
        double z0 = layer * thin, z1 = (layer + 1) * thin;
        double w = dice_int(&st->d, 1, 4), h = dice_int(&st->d, 1, 4);
        if (way == 0)
            put_box(st, z0, x, y, z1, x + w, y + h);
        else if (way == 1)
            put_box(st, x, z0, y, x + w, z1, y + h);
        else
            put_box(st, x, y, z0, x + w, y + h, z1);
    }
    look_any(st);
}

/* Thickness about 1e-3 or 1e-6, but a power of two, so that sums of heights are exact too. */
static void plates(studio *st)
{
    heap(st, ldexp(1, dice_int(&st->d, 0, 1) ? -10 : -20));
}

/* Thickness 1e-3 or 1e-6, and not judged what rounding of that might change. */
static void decimal_plates(studio *st)
{
    heap(st, dice_int(&st->d, 0, 1) ? 1e-3 : 1e-6);
    st->scene->slack = ROUNDING * 10; /* coordinates are at most 10 */
}

/* A stack of boxes, each turned about the vertical: the faces between them meet exactly, whatever x and y became. */
static void tower(studio *st)
{
    int count = dice_int(&st->d, 3, 20);
    double angle = dice_real(&st->d);
    for (int i = 0; i < count; i++) {
        shape s = dice_int(&st->d, 0, 3) ? shape_box(4, 4, 1) : shape_box(2, 6, 1);
        double c = cos(angle * i), n = sin(angle * i), shift = (double)s.point[s.point_count - 1][0] / 2;
        double m[3][3] = {{c, -n, 0}, {n, c, 0}, {0, 0, 1}};
        put_mapped(st, &s, (roberts_vec3){-shift * c + shift * n, -shift * n - shift * c, i}, m);
    }
    look_any(st);
}

/* A crowd seen along one of its edges; in perspective from a point on the line of that edge. */
static void end_on(studio *st)
{
    crowd(st);
    const roberts_mesh *mesh = &st->scene->mesh;
    if (st->no_memory)
        return;
    uint32_t first = mesh->face_start[dice_int(&st->d, 0, (int)mesh->face_count - 1)];
    roberts_vec3 a = mesh->vertex[mesh->corner[first]], b = mesh->vertex[mesh->corner[first + 1]];
    look(st, b.x - a.x, b.y - a.y, b.z - a.z);
    if (st->eye)
        st->scene->view = (oracle_view){a.x + 48 * (b.x - a.x), a.y + 48 * (b.y - a.y), a.z + 48 * (b.z - a.z), 1};
}

/* Solids of sizes 2^-most .. 2^most together; all coordinates are small multiples of a power of two. */
static void mixed_sizes(studio *st, int most)
{
    int count = dice_int(&st->d, 6, 20);
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        double size = ldexp(1, dice_int(&st->d, -most, most)), spread = fmax(8, size);
        put_scaled(st, &s,
                   (roberts_vec3){floor(spread * dice_real(&st->d)), floor(spread * dice_real(&st->d)),
                                  floor(spread * dice_real(&st->d))},
                   size, size, size);
    }
    look_any(st);
}

/* Up to a thousand times larger than others. */
static void sizes(studio *st)
{
    mixed_sizes(st, 5);
}

/* Up to a million times, where faces of the smallest may look narrower than what counts as touching. */
static void giants(studio *st)
{
    mixed_sizes(st, 10);
    near_touching(st);
}

/* One of the families whose coordinates are whole numbers or halves. */
static void any_exact(studio *st)
{
    static void (*const make[])(studio *) = {blocks, bricks, checker, polytopes, crowd, touching, nested, twice};
    make[dice_int(&st->d, 0, sizeof make / sizeof *make - 1)](st);
}

static void map_vertices(studio *st, double scale, roberts_vec3 shift)
{
    roberts_mesh *mesh = &st->scene->mesh;
    for (size_t i = 0; i < mesh->vertex_count; i++)
        mesh->vertex[i] = (roberts_vec3){scale * mesh->vertex[i].x + shift.x, scale * mesh->vertex[i].y + shift.y,
                                         scale * mesh->vertex[i].z + shift.z};
}

/* Times 1e8, which keeps whole numbers and halves whole. */
static void huge(studio *st)
{
    any_exact(st);
    map_vertices(st, 1e8, (roberts_vec3){0, 0, 0});
    st->unit = 1e8;
}

/* Times 2^-27, about 1e-8, which rounds nothing. */
static void small(studio *st)
{
    any_exact(st);
    st->unit = ldexp(1, -27);
    map_vertices(st, st->unit, (roberts_vec3){0, 0, 0});
}

/* Moved far from the origin by whole numbers. */
static void far_away(studio *st)
{
    double far = dice_int(&st->d, 0, 1) ? 1e8 : 1e6;
    any_exact(st);
    map_vertices(st, 1, (roberts_vec3){far, -3 * far, dice_int(&st->d, -1000, 1000)});
}

/* ---- families of small clearances, some of them below what counts as touching ------------------------------------ */

/* Exact contacts, and then each solid moved by some millionths. */
static void nudged(studio *st)
{
    int count = dice_int(&st->d, 4, 24), spread = dice_int(&st->d, 2, 6);
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        double x = dice_int(&st->d, 0, spread), y = dice_int(&st->d, 0, spread), z = dice_int(&st->d, 0, spread);
        put(st, &s, x + ldexp(dice_int(&st->d, -2, 2), -20), y + ldexp(dice_int(&st->d, -2, 2), -20),
            z + ldexp(dice_int(&st->d, -2, 2), -20));
    }
    dice_int(&st->d, 0, 3) ? look_small(st, 2) : look_any(st);
    near_touching(st);
}

/* A crowd whose corners are each moved a little, so that nothing is quite parallel, in line or in one plane. */
static void crooked(studio *st)
{
    int count = dice_int(&st->d, 4, 20), spread = dice_int(&st->d, 2, 6), twist = dice_int(&st->d, 1, 4);
    for (int i = 0; i < count; i++) {
        shape s;
        do {
            s = shape_any(&st->d);
            for (int k = 0; k < s.point_count; k++)
                for (int c = 0; c < 3; c++)
                    s.point[k][c] = 4096 * s.point[k][c] + dice_int(&st->d, -twist, twist);
        } while (!shape_hull(&s));
        put_scaled(
            st, &s,
            (roberts_vec3){dice_int(&st->d, 0, spread), dice_int(&st->d, 0, spread), dice_int(&st->d, 0, spread)},
            1.0 / 4096, 1.0 / 4096, 1.0 / 4096);
    }
    dice_int(&st->d, 0, 3) ? look_small(st, 2) : look_any(st);
    near_touching(st);
}

/* ---- families whose contacts rounding has spoiled ---------------------------------------------------------------- */

static bool copy_mesh(const roberts_mesh *from, roberts_mesh *to)
{
    bool ok = true;
    for (size_t i = 0; i < from->vertex_count; i++)
        ok = ok && roberts_mesh_add_vertex(to, from->vertex[i], NULL, NULL) == ROBERTS_OK;
    for (size_t f = 0; f < from->face_count; f++)
        ok = ok && roberts_mesh_add_face(to, from->corner + from->face_start[f],
                                         from->face_start[f + 1] - from->face_start[f], NULL) == ROBERTS_OK;
    return ok;
}

/* Keeps the scene as the original and sends every vertex, and the viewer with them, through m. What moves by 1e-13 of
 * the largest coordinate is not judged. */
static void spoil(studio *st, double m[3][3])
{
    test_scene *scene = st->scene;
    double largest = 0;
    if (st->eye)
        look_from_eye(st);
    st->eye = false;
    scene->has_original = true;
    scene->original_view = scene->view;
    st->no_memory = st->no_memory || !copy_mesh(&scene->mesh, &scene->original);
    for (size_t i = 0; i <= scene->mesh.vertex_count && !st->no_memory; i++) {
        roberts_vec3 *v = scene->mesh.vertex + i, p;
        p = i < scene->mesh.vertex_count ? *v : (roberts_vec3){scene->view.x, scene->view.y, scene->view.z};
        p = (roberts_vec3){m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z, m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z,
                           m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z};
        if (i < scene->mesh.vertex_count)
            *v = p;
        else
            scene->view = (oracle_view){p.x, p.y, p.z, scene->view.w};
        if (i < scene->mesh.vertex_count || scene->view.w)
            largest = fmax(largest, fmax(fabs(p.x), fmax(fabs(p.y), fabs(p.z))));
    }
    scene->slack = ROUNDING * largest;
}

static void spoil_scale(studio *st, double scale)
{
    double m[3][3] = {{scale, 0, 0}, {0, scale, 0}, {0, 0, scale}};
    spoil(st, m);
}

static void turned(studio *st)
{
    any_exact(st);
    double a = 3 * dice_real(&st->d), b = 3 * dice_real(&st->d);
    double m[3][3] = {
        {cos(a), -sin(a), 0}, {cos(b) * sin(a), cos(b) * cos(a), -sin(b)}, {sin(b) * sin(a), sin(b) * cos(a), cos(b)}};
    spoil(st, m);
}

static void tenth(studio *st)
{
    any_exact(st);
    spoil_scale(st, 0.1);
}

static void tiny(studio *st)
{
    any_exact(st);
    spoil_scale(st, 1e-8);
}

/* ---- the list ---------------------------------------------------------------------------------------------------- */

static const struct {
    const char *name;
    void (*make)(studio *);
    bool eye;
} families[] = {
    {"lattice", lattice, false},
    {"hulls", hulls, false},
    {"crossing", crossing, false},
    {"swarm", swarm, false},
    {"shaft", shaft, false},
    {"slanted-plates", slanted_plates, false},
    {"needles", needles, false},
    {"blocks", blocks, false},
    {"bricks", bricks, false},
    {"checker", checker, false},
    {"polytopes", polytopes, false},
    {"crowd", crowd, false},
    {"touching", touching, false},
    {"nested", nested, false},
    {"twice", twice, false},
    {"plates", plates, false},
    {"decimal-plates", decimal_plates, false},
    {"tower", tower, false},
    {"end-on", end_on, false},
    {"sizes", sizes, false},
    {"giants", giants, false},
    {"huge", huge, false},
    {"small", small, false},
    {"far", far_away, false},
    {"nudged", nudged, false},
    {"crooked", crooked, false},
    {"turned", turned, false},
    {"tenth", tenth, false},
    {"tiny", tiny, false},
    {"lattice@eye", lattice, true},
    {"hulls@eye", hulls, true},
    {"crossing@eye", crossing, true},
    {"swarm@eye", swarm, true},
    {"shaft@eye", shaft, true},
    {"slanted-plates@eye", slanted_plates, true},
    {"needles@eye", needles, true},
    {"blocks@eye", blocks, true},
    {"bricks@eye", bricks, true},
    {"checker@eye", checker, true},
    {"polytopes@eye", polytopes, true},
    {"crowd@eye", crowd, true},
    {"touching@eye", touching_from_eye, true},
    {"nested@eye", nested, true},
    {"twice@eye", twice, true},
    {"plates@eye", plates, true},
    {"tower@eye", tower, true},
    {"end-on@eye", end_on, true},
    {"sizes@eye", sizes, true},
    {"huge@eye", huge, true},
    {"small@eye", small, true},
    {"far@eye", far_away, true},
    {"crooked@eye", crooked, true},
    {"turned@eye", turned, true},
    {"tenth@eye", tenth, true},
};

size_t scene_family_count(void)
{
    return sizeof families / sizeof *families;
}

const char *scene_family_name(size_t index)
{
    return families[index].name;
}

bool scene_make(const char *family, uint64_t seed, test_scene *scene)
{
    *scene = (test_scene){0};
    for (size_t i = 0; i < scene_family_count(); i++) {
        studio st = {scene, {seed}, 1, families[i].eye, false};
        if (strcmp(family, families[i].name) != 0)
            continue;
        for (const char *c = family; *c; c++)
            st.d.state = dice_next(&st.d) ^ (unsigned char)*c;
        scene->grid = (uint32_t[]){0, 0, 1, 9}[seed % 4];
        scene->threads = seed % 16 ? 1 : 3;
        families[i].make(&st);
        if (st.eye && !scene->view.w && !st.no_memory)
            look_from_eye(&st);
        if (st.no_memory)
            test_scene_free(scene);
        return !st.no_memory;
    }
    return false;
}

void test_scene_free(test_scene *scene)
{
    roberts_mesh_free(&scene->mesh);
    roberts_mesh_free(&scene->original);
    *scene = (test_scene){0};
}
