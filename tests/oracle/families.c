/* families.c - the families. Contact is made with whole numbers, halves and powers of two, and the view is turned,
 * not the scene: so doubles hold every contact exactly. The families "turned", "tenth" and "tiny" then spoil it by
 * rounding on purpose. Faces have either winding, since the program must not rely on it. */
#include "families.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "makers.h"

/* ---- families in general position ------------------------------------------------------------------------------ */

/* n^3 solids, each turned at random. */
static void lattice(studio *st)
{
    int n = rng_int(&st->d, 2, 4);
    for (int i = 0; i < n * n * n; i++) {
        shape s = shape_any(&st->d);
        int column = i / n, layer = column / n;
        roberts_vec3 at = {i % n, column % n, layer};
        put_turned(st, &s, at, 0.15 + 0.05 * rng_real(&st->d));
    }
    look_random(st);
}

/* Hulls of random points: triangles, well apart or through one another. */
static void hulls(studio *st)
{
    int count = rng_int(&st->d, 10, 40), spread = rng_int(&st->d, 1, 5) * 65536;
    for (int i = 0; i < count; i++) {
        shape s = shape_random(&st->d, rng_int(&st->d, 4, 16), 65536);
        put_at(st, &s, whole_point(st, 0, spread));
    }
    look_random(st);
}

/* Some hundred solids of all sizes before one another: most is hidden many times over. */
static void swarm(studio *st)
{
    int count = rng_int(&st->d, 100, 300);
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        roberts_vec3 at = real_point(st);
        at.z *= 3;
        put_turned(st, &s, at, pow(10, rng_real(&st->d) - 1.7));
    }
    look_down(st, 0.2, 1);
}

/* Solids of so many faces that they do not hide as one. */
static void round_solids(studio *st)
{
    int count = rng_int(&st->d, 3, 8);
    for (int i = 0; i < count; i++) {
        shape s = shape_random(&st->d, 60, 40);
        roberts_vec3 at = real_point(st);
        put_turned(st, &s, at, 0.02);
    }
    look_random(st);
}

/* Solids at random places that pierce one another. */
static void crossing(studio *st)
{
    int count = rng_int(&st->d, 6, 24);
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        roberts_vec3 at = real_point(st);
        put_turned(st, &s, at, 0.3);
    }
    look_random(st);
}

/* Thin parallelograms, turned at random. */
static void slanted_plates(studio *st)
{
    int count = rng_int(&st->d, 6, 24);
    double thin = rng_int(&st->d, 0, 1) ? 1e-3 : 1e-6;
    shape box = shape_box(1, 1, 1);
    while (count-- > 0) {
        double a[3], b[3], n[3], l, m[3][3];
        roberts_vec3 at = real_point(st);
        for (int k = 0; k < 3; k++) {
            a[k] = rng_real(&st->d);
            b[k] = rng_real(&st->d);
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
    int count = rng_int(&st->d, 6, 30);
    double spread = pow(10, -rng_int(&st->d, 0, 5)), thick = pow(10, -rng_int(&st->d, 1, 3));
    shape s = shape_random(&st->d, 4, 1);
    for (int i = 0; i < count; i++) {
        roberts_vec3 at = real_point(st), along = real_point(st), lean = real_point(st);
        double m[3][3] = {
            {20 + along.x, along.y, along.z}, {20 * spread * lean.y, thick, 0}, {20 * spread * lean.z, 0, thick}};
        put_mapped(st, &s, (roberts_vec3){0, at.y * spread * 10, at.z}, m);
    }
    look_down(st, 0.3, rng_int(&st->d, 0, 1) ? 1 : -1);
}

/* ---- families in degenerate position, exact -------------------------------------------------------------------- */

/* Blocks between whole coordinates: touching, overlapping, lined up. */
void make_blocks(studio *st)
{
    int count = rng_int(&st->d, 6, 40);
    for (int i = 0; i < count; i++) {
        roberts_vec3 p = whole_point(st, 0, 8), size = whole_point(st, 1, 4);
        put_box(st, p, (roberts_vec3){p.x + size.x, p.y + size.y, p.z + size.z});
    }
    if (rng_int(&st->d, 0, 2))
        rng_int(&st->d, 0, 1) ? look_axis(st) : look_corner(st);
    else
        look_any(st);
}

/* A deep shaft of blocks between whole coordinates: covers behind covers, and all of them in line. */
static void shaft(studio *st)
{
    int count = rng_int(&st->d, 100, 300);
    for (int i = 0; i < count; i++) {
        int x = rng_int(&st->d, 0, 10), y = rng_int(&st->d, 0, 10), z = rng_int(&st->d, 0, 300);
        int w = rng_int(&st->d, 1, 4), h = rng_int(&st->d, 1, 4), deep = rng_int(&st->d, 1, 9);
        put_box(st, (roberts_vec3){x, y, z}, (roberts_vec3){x + w, y + h, z + deep});
    }
    roberts_vec3 dir = whole_point(st, -1, 1);
    look(st, dir.x, dir.y, rng_int(&st->d, 0, 1) ? 40 : -1);
}

/* A wall in running bond, some bricks missing: faces, edges and corners touch. */
void make_bricks(studio *st)
{
    int rows = rng_int(&st->d, 2, 5), columns = rng_int(&st->d, 2, 5), deep = rng_int(&st->d, 1, 2);
    for (int z = 0; z < rows; z++)
        for (int x = 0; x < columns; x++)
            for (int y = 0; y < deep; y++)
                if (rng_int(&st->d, 0, 4))
                    put_box(st, (roberts_vec3){2 * x + z % 2, y, z}, (roberts_vec3){2 * x + z % 2 + 2, y + 1, z + 1});
    put_box(st, (roberts_vec3){-1, -1, -1}, (roberts_vec3){2 * columns + 2, deep + 1, 0});
    look_any(st);
}

/* Cubes of a grid, some of them taken: many meet in an edge or a corner alone. */
void make_checker(studio *st)
{
    int n = rng_int(&st->d, 2, 4), dense = rng_int(&st->d, 1, 3);
    put_box(st, (roberts_vec3){0, 0, 0}, (roberts_vec3){1, 1, 1});
    for (int i = 1; i < n * n * n; i++)
        if (rng_int(&st->d, 0, 3) < dense) {
            int x = i % n, y = i / n % n, z = i / n / n;
            put_box(st, (roberts_vec3){x, y, z}, (roberts_vec3){x + 1, y + 1, z + 1});
        }
    look_any(st);
}

/* Polyhedra with many-cornered faces on a fine lattice. */
static void polytopes(studio *st)
{
    int count = rng_int(&st->d, 5, 20), spread = rng_int(&st->d, 4, 30);
    for (int i = 0; i < count; i++) {
        shape s = rng_int(&st->d, 0, 1) ? shape_prism(&st->d) : shape_random(&st->d, 24, 5);
        put_at(st, &s, whole_point(st, 0, spread));
    }
    look_any(st);
}

/* Solids with faces of very many corners over one another, and some small ones among them. */
static void coins(studio *st)
{
    int count = rng_int(&st->d, 2, 3), small_ones = rng_int(&st->d, 0, 20);
    for (int i = 0; i < count; i++) {
        shape s = shape_coin(&st->d);
        int x = rng_int(&st->d, -60, 60), y = rng_int(&st->d, -60, 60), z = 4 * rng_int(&st->d, 0, 40);
        put(st, &s, x, y, z);
    }
    for (int i = 0; i < small_ones; i++) {
        shape s = shape_any(&st->d);
        double size = rng_int(&st->d, 1, 30);
        int x = rng_int(&st->d, -120, 120), y = rng_int(&st->d, -60, 180), z = rng_int(&st->d, 0, 160);
        put_scaled(st, &s, (roberts_vec3){x, y, z}, size, size, size);
    }
    rng_int(&st->d, 0, 1) ? look_axis(st) : look_any(st);
}

/* Plates whose straight borders have very many corners, and small solids across these or in line with them. */
static void plates_in_parts(studio *st)
{
    int count = rng_int(&st->d, 1, 3), small_ones = rng_int(&st->d, 5, 40);
    for (int i = 0; i < count; i++) {
        shape s = shape_plate(&st->d);
        int x = rng_int(&st->d, -9, 9), y = rng_int(&st->d, -9, 9), z = 5 * rng_int(&st->d, -2, 2);
        put(st, &s, x, y, z);
    }
    for (int i = 0; i < small_ones; i++) {
        shape s = shape_any(&st->d);
        int x = rng_int(&st->d, -9, 50), y = rng_int(&st->d, -9, 50), z = rng_int(&st->d, -15, 15);
        put(st, &s, x, y, z);
    }
    rng_int(&st->d, 0, 1) ? look_axis(st) : look_any(st);
}

/* Solids with a face of 500 corners, and small ones among them. */
static void large_coins(studio *st)
{
    int count = rng_int(&st->d, 1, 2), small_ones = rng_int(&st->d, 5, 20);
    for (int i = 0; i < count; i++) {
        shape s = shape_large_coin(&st->d);
        int x = rng_int(&st->d, -600, 600), y = rng_int(&st->d, -600, 600), z = 40 * rng_int(&st->d, 0, 40);
        put(st, &s, x, y, z);
    }
    for (int i = 0; i < small_ones; i++) {
        shape s = shape_any(&st->d);
        double size = rng_int(&st->d, 10, 300);
        int x = rng_int(&st->d, -1200, 1200), y = rng_int(&st->d, -600, 1800), z = rng_int(&st->d, 0, 1600);
        put_scaled(st, &s, (roberts_vec3){x, y, z}, size, size, size);
    }
    rng_int(&st->d, 0, 1) ? look_axis(st) : look_any(st);
}

/* Pyramids of very many sides, one behind the tip of the other or through it, and small solids among them. */
static void fans(studio *st)
{
    int count = rng_int(&st->d, 2, 3), small_ones = rng_int(&st->d, 0, 10);
    for (int i = 0; i < count; i++) {
        shape s = shape_fan(&st->d);
        int x = rng_int(&st->d, -90, 90), y = rng_int(&st->d, -90, 90), z = 4 * rng_int(&st->d, -40, 40);
        put(st, &s, x, y, z);
    }
    for (int i = 0; i < small_ones; i++) {
        shape s = shape_any(&st->d);
        double size = rng_int(&st->d, 1, 30);
        int x = rng_int(&st->d, -240, 240), y = rng_int(&st->d, -60, 420), z = rng_int(&st->d, -90, 400);
        put_scaled(st, &s, (roberts_vec3){x, y, z}, size, size, size);
    }
    int x = rng_int(&st->d, -1, 1), y = rng_int(&st->d, -1, 1);
    rng_int(&st->d, 0, 1) ? look(st, x, y, 8) : look_any(st);
}

/* All kinds crowded on a coarse lattice and seen along short whole vectors: everything lines up with everything. */
void make_crowd(studio *st)
{
    int count = rng_int(&st->d, 4, 24), spread = rng_int(&st->d, 2, 8);
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        put_at(st, &s, whole_point(st, 0, spread));
    }
    rng_int(&st->d, 0, 3) ? look_small(st, 2) : look_any(st);
}

/* A corner, the middle of an edge or a point inside a face; coordinates of the shape are multiples of 6. */
static void anchor(rng *d, const shape *s, int64_t p[3])
{
    int f = rng_int(d, 0, s->face_count - 1), count = s->face_start[f + 1] - s->face_start[f];
    int kind = rng_int(d, 1, 3), first = rng_int(d, 0, count - 1);
    for (int k = 0; k < 3; k++) {
        p[k] = 0;
        for (int i = 0; i < kind; i++)
            p[k] += s->point[s->corner[s->face_start[f] + (first + i) % count]][k];
        p[k] /= kind;
    }
}

static shape shape_times_six(rng *d)
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
    int count = rng_int(&st->d, 3, 16);
    look_small(st, 3);
    shape before = shape_times_six(&st->d);
    int64_t at[3] = {0, 0, 0},
            dir[3] = {(int64_t)st->scene->view.x, (int64_t)st->scene->view.y, (int64_t)st->scene->view.z};
    put(st, &before, 0, 0, 0);
    for (int i = 1; i < count; i++) {
        shape s = shape_times_six(&st->d);
        int64_t p[3], q[3];
        int along = rng_int(&st->d, 0, 1) ? 0 : rng_int(&st->d, -12, 12);
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
    int count = rng_int(&st->d, 3, 16);
    look_small(st, 3);
    shape before = shape_times_six(&st->d);
    oracle_view *view = &st->scene->view;
    int64_t at[3] = {0, 0, 0}, eye[3] = {240 * (int64_t)view->x, 240 * (int64_t)view->y, 240 * (int64_t)view->z};
    put(st, &before, 0, 0, 0);
    for (int i = 1; i < count; i++) {
        shape s = shape_times_six(&st->d);
        int64_t p[3], q[3], to[3];
        bool behind = rng_int(&st->d, 0, 1);
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
    *view = (oracle_view){.x = (double)eye[0], .y = (double)eye[1], .z = (double)eye[2], .w = 1};
}

/* Solids within solids about common centres, some of the same size. */
static void nested(studio *st)
{
    int centres = rng_int(&st->d, 1, 4);
    for (int c = 0; c < centres; c++) {
        shape s = shape_any(&st->d);
        int x = rng_int(&st->d, 0, 40), y = rng_int(&st->d, 0, 40), z = rng_int(&st->d, 0, 40);
        const int64_t *p = s.point[0], *q = s.point[s.point_count - 1];
        int64_t middle[3] = {p[0] + q[0], p[1] + q[1], p[2] + q[2]}; /* twice a point of the solid */
        for (int i = rng_int(&st->d, 2, 6); i > 0; i--) {
            int k = rng_int(&st->d, 1, 6);
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
    int count = rng_int(&st->d, 2, 8);
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        int x = rng_int(&st->d, 0, 6), y = rng_int(&st->d, 0, 6), z = rng_int(&st->d, 0, 6);
        for (int k = rng_int(&st->d, 1, 3); k > 0; k--)
            put(st, &s, x, y, z);
    }
    look_any(st);
}

/* Thin plates on one another and apart, parallel to the axes; equal heights are the same double. */
static void heap(studio *st, double thin)
{
    int count = rng_int(&st->d, 6, 30);
    for (int i = 0; i < count; i++) {
        double x = rng_int(&st->d, 0, 6), y = rng_int(&st->d, 0, 6);
        int layer = rng_int(&st->d, 0, 5), way = rng_int(&st->d, 0, 4);
        double z0 = layer * thin, z1 = (layer + 1) * thin;
        double w = rng_int(&st->d, 1, 4), h = rng_int(&st->d, 1, 4);
        if (way == 0)
            put_box(st, (roberts_vec3){z0, x, y}, (roberts_vec3){z1, x + w, y + h});
        else if (way == 1)
            put_box(st, (roberts_vec3){x, z0, y}, (roberts_vec3){x + w, z1, y + h});
        else
            put_box(st, (roberts_vec3){x, y, z0}, (roberts_vec3){x + w, y + h, z1});
    }
    look_any(st);
}

/* Thickness about 1e-3 or 1e-6, but a power of two, so that sums of heights are exact too. */
static void plates(studio *st)
{
    heap(st, ldexp(1, rng_int(&st->d, 0, 1) ? -10 : -20));
}

/* Where a near plane cuts plates of a millionth, what lies behind the cuts lies nearer to them than what counts as
 * touching. */
static void thicker_plates(studio *st)
{
    heap(st, 0x1p-10);
}

/* Thickness 1e-3 or 1e-6. What rounding of it may change is not judged. */
static void decimal_plates(studio *st)
{
    heap(st, rng_int(&st->d, 0, 1) ? 1e-3 : 1e-6);
    st->scene->slack = ROUNDING * 10; /* coordinates are at most 10 */
}

/* A stack of boxes, each turned about the vertical: the faces between them meet exactly, whatever x and y became. */
static void tower(studio *st)
{
    int count = rng_int(&st->d, 3, 20);
    double angle = rng_real(&st->d);
    for (int i = 0; i < count; i++) {
        shape s = rng_int(&st->d, 0, 3) ? shape_box(4, 4, 1) : shape_box(2, 6, 1);
        double c = cos(angle * i), n = sin(angle * i), shift = (double)s.point[s.point_count - 1][0] / 2;
        double m[3][3] = {{c, -n, 0}, {n, c, 0}, {0, 0, 1}};
        put_mapped(st, &s, (roberts_vec3){-shift * c + shift * n, -shift * n - shift * c, i}, m);
    }
    look_any(st);
}

/* Up to a million times as deep as the picture is wide: large depths must not spoil x and y. Returns the depth. */
static double put_deep(studio *st, int axis)
{
    int count = rng_int(&st->d, 6, 24), spread = rng_int(&st->d, 1, 5);
    double depth = ldexp(1, rng_int(&st->d, 6, 20));
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        double x = rng_int(&st->d, -spread, spread), y = rng_int(&st->d, -spread, spread);
        double z = floor(depth * rng_real(&st->d));
        put(st, &s, axis == 0 ? z : x, axis == 1 ? z : y, axis == 2 ? z : axis == 1 ? y : x);
    }
    return depth;
}

static void look_along(studio *st, int axis, double x, double y, double z)
{
    look(st, axis == 0 ? z : x, axis == 1 ? z : y, axis == 2 ? z : axis == 1 ? y : x);
}

static void deep(studio *st)
{
    int axis = rng_int(&st->d, 0, 2);
    put_deep(st, axis);
    look_along(st, axis, 0, 0, rng_int(&st->d, 0, 1) ? 1 : -3);
}

/* The view is off that axis by some widths of a solid from front to back, so clearances are small. */
static void deep_aslant(studio *st)
{
    int axis = rng_int(&st->d, 0, 2);
    double depth = put_deep(st, axis);
    roberts_vec3 aside = whole_point(st, -3, 3);
    look_along(st, axis, aside.x, aside.y, depth);
    near_touching(st);
}

/* A crowd seen along one of its edges; in perspective from a point on the line of that edge. */
static void end_on(studio *st)
{
    make_crowd(st);
    const roberts_mesh *mesh = &st->scene->mesh;
    if (st->no_memory)
        return;
    uint32_t first = mesh->face_start[rng_int(&st->d, 0, (int)mesh->face_count - 1)];
    roberts_vec3 a = mesh->vertex[mesh->corner[first]], b = mesh->vertex[mesh->corner[first + 1]];
    look(st, b.x - a.x, b.y - a.y, b.z - a.z);
    if (st->eye)
        st->scene->view = (oracle_view){
            .x = a.x + 48 * (b.x - a.x), .y = a.y + 48 * (b.y - a.y), .z = a.z + 48 * (b.z - a.z), .w = 1};
}

/* Solids of sizes 2^-most .. 2^most together; all coordinates are small multiples of a power of two. */
static void mixed_sizes(studio *st, int most)
{
    int count = rng_int(&st->d, 6, 20);
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        double size = ldexp(1, rng_int(&st->d, -most, most)), spread = fmax(8, size);
        roberts_vec3 at = real_point(st);
        at = (roberts_vec3){floor(spread * at.x), floor(spread * at.y), floor(spread * at.z)};
        put_scaled(st, &s, at, size, size, size);
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
void make_any_exact(studio *st)
{
    static void (*const make[])(studio *) = {make_blocks, make_bricks, make_checker, polytopes,
                                             make_crowd,  touching,    nested,       twice};
    make[rng_int(&st->d, 0, sizeof make / sizeof *make - 1)](st);
}

/* Times 1e8, which keeps whole numbers and halves whole. */
static void huge(studio *st)
{
    make_any_exact(st);
    map_vertices(st, 1e8, (roberts_vec3){0, 0, 0});
    st->unit = 1e8;
}

/* Times 2^-27, about 1e-8, which rounds nothing. */
static void small(studio *st)
{
    make_any_exact(st);
    st->unit = ldexp(1, -27);
    map_vertices(st, st->unit, (roberts_vec3){0, 0, 0});
}

/* Moved far from the origin by whole numbers. */
static void far_away(studio *st)
{
    double far = rng_int(&st->d, 0, 1) ? 1e8 : 1e6;
    make_any_exact(st);
    map_vertices(st, 1, (roberts_vec3){far, -3 * far, rng_int(&st->d, -1000, 1000)});
}

/* Up to a million million times. */
static void all_sizes(studio *st)
{
    mixed_sizes(st, 20);
    near_touching(st);
}

/* ---- families of small clearances, some of them below what counts as touching ---------------------------------- */

/* Exact contacts, and then each solid moved by some millionths. */
static void nudged(studio *st)
{
    int count = rng_int(&st->d, 4, 24), spread = rng_int(&st->d, 2, 6);
    for (int i = 0; i < count; i++) {
        shape s = shape_any(&st->d);
        roberts_vec3 p = whole_point(st, 0, spread), by = whole_point(st, -2, 2);
        put(st, &s, p.x + ldexp(by.x, -20), p.y + ldexp(by.y, -20), p.z + ldexp(by.z, -20));
    }
    rng_int(&st->d, 0, 3) ? look_small(st, 2) : look_any(st);
    near_touching(st);
}

/* A crowd whose corners are each moved a little, so that nothing is quite parallel, in line or in one plane. */
static void crooked(studio *st)
{
    int count = rng_int(&st->d, 4, 20), spread = rng_int(&st->d, 2, 6), twist = rng_int(&st->d, 1, 4);
    for (int i = 0; i < count; i++) {
        shape s;
        do {
            s = shape_any(&st->d);
            for (int k = 0; k < s.point_count; k++)
                for (int c = 0; c < 3; c++)
                    s.point[k][c] = 4096 * s.point[k][c] + rng_int(&st->d, -twist, twist);
        } while (!shape_hull(&s));
        put_scaled(st, &s, whole_point(st, 0, spread), 1.0 / 4096, 1.0 / 4096, 1.0 / 4096);
    }
    rng_int(&st->d, 0, 3) ? look_small(st, 2) : look_any(st);
    near_touching(st);
}

/* ---- families whose contacts rounding has spoiled -------------------------------------------------------------- */

static void turned(studio *st)
{
    make_any_exact(st);
    double a = 3 * rng_real(&st->d), b = 3 * rng_real(&st->d);
    double m[3][3] = {
        {cos(a), -sin(a), 0}, {cos(b) * sin(a), cos(b) * cos(a), -sin(b)}, {sin(b) * sin(a), sin(b) * cos(a), cos(b)}};
    spoil(st, m);
}

static void tenth(studio *st)
{
    make_any_exact(st);
    spoil_scale(st, 0.1);
}

static void tiny(studio *st)
{
    make_any_exact(st);
    spoil_scale(st, 1e-8);
}

/* ---- the list -------------------------------------------------------------------------------------------------- */

static const struct {
    const char *name;
    void (*make)(studio *);
    enum {
        INFINITELY_FAR,
        FROM_EYE,
        FROM_AMID,
        FROM_CLOSE,
        FROM_FACE_PLANE,
        SECTION,
        OBLIQUELY,
        AS_SOUP,
        AS_POINTS
    } way;
} families[] = {
    {"lattice", lattice, INFINITELY_FAR},
    {"hulls", hulls, INFINITELY_FAR},
    {"crossing", crossing, INFINITELY_FAR},
    {"swarm", swarm, INFINITELY_FAR},
    {"round", round_solids, INFINITELY_FAR},
    {"shaft", shaft, INFINITELY_FAR},
    {"slanted-plates", slanted_plates, INFINITELY_FAR},
    {"needles", needles, INFINITELY_FAR},
    {"blocks", make_blocks, INFINITELY_FAR},
    {"bricks", make_bricks, INFINITELY_FAR},
    {"checker", make_checker, INFINITELY_FAR},
    {"polytopes", polytopes, INFINITELY_FAR},
    {"coins", coins, INFINITELY_FAR},
    {"plates-in-parts", plates_in_parts, INFINITELY_FAR},
    {"fans", fans, INFINITELY_FAR},
    {"crowd", make_crowd, INFINITELY_FAR},
    {"touching", touching, INFINITELY_FAR},
    {"nested", nested, INFINITELY_FAR},
    {"twice", twice, INFINITELY_FAR},
    {"plates", plates, INFINITELY_FAR},
    {"decimal-plates", decimal_plates, INFINITELY_FAR},
    {"tower", tower, INFINITELY_FAR},
    {"deep", deep, INFINITELY_FAR},
    {"deep-aslant", deep_aslant, INFINITELY_FAR},
    {"end-on", end_on, INFINITELY_FAR},
    {"sizes", sizes, INFINITELY_FAR},
    {"giants", giants, INFINITELY_FAR},
    {"huge", huge, INFINITELY_FAR},
    {"small", small, INFINITELY_FAR},
    {"far", far_away, INFINITELY_FAR},
    {"nudged", nudged, INFINITELY_FAR},
    {"crooked", crooked, INFINITELY_FAR},
    {"turned", turned, INFINITELY_FAR},
    {"tenth", tenth, INFINITELY_FAR},
    {"tiny", tiny, INFINITELY_FAR},
    {"lattice@eye", lattice, FROM_EYE},
    {"hulls@eye", hulls, FROM_EYE},
    {"crossing@eye", crossing, FROM_EYE},
    {"swarm@eye", swarm, FROM_EYE},
    {"round@eye", round_solids, FROM_EYE},
    {"shaft@eye", shaft, FROM_EYE},
    {"slanted-plates@eye", slanted_plates, FROM_EYE},
    {"needles@eye", needles, FROM_EYE},
    {"blocks@eye", make_blocks, FROM_EYE},
    {"bricks@eye", make_bricks, FROM_EYE},
    {"checker@eye", make_checker, FROM_EYE},
    {"polytopes@eye", polytopes, FROM_EYE},
    {"coins@eye", coins, FROM_EYE},
    {"plates-in-parts@eye", plates_in_parts, FROM_EYE},
    {"fans@eye", fans, FROM_EYE},
    {"crowd@eye", make_crowd, FROM_EYE},
    {"touching@eye", touching_from_eye, FROM_EYE},
    {"nested@eye", nested, FROM_EYE},
    {"twice@eye", twice, FROM_EYE},
    {"plates@eye", plates, FROM_EYE},
    {"tower@eye", tower, FROM_EYE},
    {"end-on@eye", end_on, FROM_EYE},
    {"sizes@eye", sizes, FROM_EYE},
    {"huge@eye", huge, FROM_EYE},
    {"small@eye", small, FROM_EYE},
    {"far@eye", far_away, FROM_EYE},
    {"crooked@eye", crooked, FROM_EYE},
    {"turned@eye", turned, FROM_EYE},
    {"tenth@eye", tenth, FROM_EYE},
    {"lattice@near", lattice, FROM_AMID},
    {"hulls@near", hulls, FROM_AMID},
    {"crossing@near", crossing, FROM_AMID},
    {"swarm@near", swarm, FROM_AMID},
    {"slanted-plates@near", slanted_plates, FROM_AMID},
    {"needles@near", needles, FROM_AMID},
    {"round@near", round_solids, FROM_AMID},
    {"blocks@near", make_blocks, FROM_AMID},
    {"shaft@near", shaft, FROM_AMID},
    {"bricks@near", make_bricks, FROM_AMID},
    {"checker@near", make_checker, FROM_AMID},
    {"polytopes@near", polytopes, FROM_AMID},
    {"coins@near", coins, FROM_AMID},
    {"plates-in-parts@near", plates_in_parts, FROM_AMID},
    {"fans@near", fans, FROM_AMID},
    {"crowd@near", make_crowd, FROM_AMID},
    {"touching@near", touching, FROM_AMID},
    {"twice@near", twice, FROM_AMID},
    {"plates@near", thicker_plates, FROM_AMID},
    {"tower@near", tower, FROM_AMID},
    {"sizes@near", sizes, FROM_AMID},
    {"huge@near", huge, FROM_AMID},
    {"small@near", small, FROM_AMID},
    {"lattice@close", lattice, FROM_CLOSE},
    {"hulls@close", hulls, FROM_CLOSE},
    {"crossing@close", crossing, FROM_CLOSE},
    {"polytopes@close", polytopes, FROM_CLOSE},
    {"lattice@oblique", lattice, OBLIQUELY},
    {"blocks@oblique", make_blocks, OBLIQUELY},
    {"crowd@oblique", make_crowd, OBLIQUELY},
    {"lattice@soup", lattice, AS_SOUP},
    {"crossing@soup", crossing, AS_SOUP},
    {"swarm@soup", swarm, AS_SOUP},
    {"round@soup", round_solids, AS_SOUP},
    {"hulls@points", hulls, AS_POINTS},
    {"polytopes@points", polytopes, AS_POINTS},
    {"blocks@points", make_blocks, AS_POINTS},
    {"large-coins", large_coins, INFINITELY_FAR},
    {"large-coins@eye", large_coins, FROM_EYE},
    {"large-coins@near", large_coins, FROM_AMID},
    {"all-sizes", all_sizes, INFINITELY_FAR},
    {"all-sizes@eye", all_sizes, FROM_EYE},
    {"rough-boxes", make_rough_boxes, INFINITELY_FAR},
    {"rough-boxes@eye", make_rough_boxes, FROM_EYE},
    {"rough-hexagons", make_rough_hexagons, INFINITELY_FAR},
    {"rough-hexagons@eye", make_rough_hexagons, FROM_EYE},
    {"rough-twelve-sided", make_rough_twelve_sided, INFINITELY_FAR},
    {"rough-twelve-sided@eye", make_rough_twelve_sided, FROM_EYE},
    {"rough-rhombic", make_rough_rhombic, INFINITELY_FAR},
    {"rough-rhombic@eye", make_rough_rhombic, FROM_EYE},
    {"rough-truncated", make_rough_truncated, INFINITELY_FAR},
    {"rough-truncated@eye", make_rough_truncated, FROM_EYE},
    {"digits", make_digits, INFINITELY_FAR},
    {"digits@eye", make_digits, FROM_EYE},
    {"digits-in-triangles", make_digits_in_triangles, INFINITELY_FAR},
    {"digits-in-triangles@eye", make_digits_in_triangles, FROM_EYE},
    {"digits-convex", make_digits_convex, INFINITELY_FAR},
    {"digits-convex@eye", make_digits_convex, FROM_EYE},
    {"honeycomb", make_honeycomb, INFINITELY_FAR},
    {"honeycomb@eye", make_honeycomb, FROM_EYE},
    {"honeycomb@near", make_honeycomb, FROM_AMID},
    {"honeycomb@plane", make_honeycomb, FROM_FACE_PLANE},
    {"honeycomb@oblique", make_honeycomb, OBLIQUELY},
    {"honeycomb-turned", make_honeycomb_turned, INFINITELY_FAR},
    {"honeycomb-turned@eye", make_honeycomb_turned, FROM_EYE},
    {"beams", make_beams, INFINITELY_FAR},
    {"beams@eye", make_beams, FROM_EYE},
    {"tilted-beams", make_tilted_beams, INFINITELY_FAR},
    {"tilted-beams@eye", make_tilted_beams, FROM_EYE},
    {"crowd@plane", make_crowd, FROM_FACE_PLANE},
    {"blocks@plane", make_blocks, FROM_FACE_PLANE},
    {"polytopes@plane", polytopes, FROM_FACE_PLANE},
    {"lattice@section", lattice, SECTION},
    {"crossing@section", crossing, SECTION},
    {"swarm@section", swarm, SECTION},
    {"needles@section", needles, SECTION},
    {"blocks@section", make_blocks, SECTION},
    {"bricks@section", make_bricks, SECTION},
    {"polytopes@section", polytopes, SECTION},
    {"coins@section", coins, SECTION},
    {"fans@section", fans, SECTION},
    {"touching@section", touching, SECTION},
    {"plates@section", thicker_plates, SECTION},
    {"sizes@section", sizes, SECTION},
    {"huge@section", huge, SECTION},
    {"small@section", small, SECTION},
    {"honeycomb@section", make_honeycomb, SECTION},
    {"crossing-in-plane", make_crowd_in_plane, INFINITELY_FAR},
    {"crossing-in-plane@eye", make_crowd_in_plane, FROM_EYE},
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
        studio st = {.scene = scene, .d = {seed}, .unit = 1, .eye = families[i].way == FROM_EYE};
        if (strcmp(family, families[i].name) != 0)
            continue;
        for (const char *c = family; *c; c++)
            st.d.state = rng_next(&st.d) ^ (unsigned char)*c;
        scene->grid = (uint32_t[]){0, 0, 1, 9}[seed % 4];
        scene->threads = seed % 16 ? 1 : 3;
        families[i].make(&st);
        if (st.eye && !scene->view.w && !st.no_memory)
            look_from_eye(&st);
        if (families[i].way == FROM_AMID && !st.no_memory)
            look_from_amid(&st);
        if (families[i].way == FROM_CLOSE && !st.no_memory)
            look_from_close(&st);
        if (families[i].way == FROM_FACE_PLANE && !st.no_memory)
            look_from_face_plane(&st);
        if (families[i].way == SECTION && !st.no_memory)
            look_at_section(&st);
        if (families[i].way == OBLIQUELY)
            look_oblique(&st);
        if (families[i].way == AS_SOUP && !st.no_memory)
            give_as_soup(&st);
        if (families[i].way == AS_POINTS && !st.no_memory)
            give_as_points(&st);
        if (st.no_memory)
            test_scene_free(scene);
        return !st.no_memory;
    }
    return false;
}

void test_scene_free(test_scene *scene)
{
    roberts_mesh_free(&scene->mesh);
    roberts_mesh_free(&scene->soup);
    roberts_mesh_free(&scene->original);
    *scene = (test_scene){0};
}
