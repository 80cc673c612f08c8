/* families_rough.c - families of models as people have them: cut into triangles, with corners a little off, given to a
 * few digits, filling space, seen along their faces; and beams that cross at grazing angles. */
#include <math.h>

#include "makers.h"
#include "roughen.h"

/* ---- solids in triangles, a little off, seen along faces ------------------------------------------------------- */

/* Two to eight of the solids close together, and small ones among them, which they may hide. */
static void put_crowd(studio *st, const shape *s, double scale)
{
    int count = rng_int(&st->d, 2, 8), small_ones = rng_int(&st->d, 3, 10), spread = rng_int(&st->d, 1, 3);
    for (int i = 0; i < count; i++)
        put_scaled(st, s, whole_point(st, -spread, spread), scale, scale, scale);
    for (int i = 0; i < small_ones; i++) {
        shape witness = shape_random(&st->d, 4, 3);
        roberts_vec3 at = whole_point(st, -16 * spread, 16 * spread);
        put_scaled(st, &witness, (roberts_vec3){at.x / 8, at.y / 8, at.z / 8}, 0.125, 0.125, 0.125);
    }
}

/* The view is along a face, which is then moved; or the scene is moved, and the view is along one of the triangles
 * that result. If nothing is moved and the view is exact, everything is judged. */
static void roughen(studio *st)
{
    double most = (double[]){0, 1e-12, 1e-9, 1e-6}[rng_int(&st->d, 0, 3)], off = small_angle(st);
    int when = rng_int(&st->d, 0, 3), how = rng_int(&st->d, most == 0 ? 0 : 1, 2);
    if (when < 2)
        look_in_plane(st, off);
    if (most > 0)
        shake(st, most);
    if (how > 0)
        how == 1 ? triangulate(st) : triangulate_convex(st);
    if (when == 2)
        look_in_plane(st, off);
    if (when == 3)
        look_any(st);
    if (most > 0 || off > 0)
        leave_open(st);
}

void make_rough_boxes(studio *st)
{
    int x = rng_int(&st->d, 1, 3), y = rng_int(&st->d, 1, 3), z = rng_int(&st->d, 1, 3);
    shape s = shape_box(x, y, z);
    put_crowd(st, &s, 1);
    roughen(st);
}

void make_rough_hexagons(studio *st)
{
    shape s = shape_regular_prism(6);
    put_crowd(st, &s, 0x1p-10);
    roughen(st);
}

void make_rough_twelve_sided(studio *st)
{
    shape s = shape_regular_prism(12);
    put_crowd(st, &s, 0x1p-10);
    roughen(st);
}

void make_rough_rhombic(studio *st)
{
    shape s = shape_rhombic_dodecahedron();
    put_crowd(st, &s, 1);
    roughen(st);
}

void make_rough_truncated(studio *st)
{
    shape s = shape_truncated_octahedron();
    put_crowd(st, &s, 1);
    roughen(st);
}

void make_crowd_in_plane(studio *st)
{
    bool small_off = rng_int(&st->d, 0, 1);
    make_crowd(st);
    look_in_plane(st, small_off ? small_angle(st) : 0);
    if (small_off)
        near_touching(st);
}

/* ---- solids that fill space ------------------------------------------------------------------------------------ */

/* Is there a cell at p, for boxes of two and for the shapes of shapes.h? */
static bool is_centre(int kind, int x, int y, int z)
{
    if ((x | y | z) & 1)
        return false;
    return kind == 0 || (kind == 1 ? (x + y + z) % 4 == 0 : ((x ^ y) & 2) == 0 && ((x ^ z) & 2) == 0);
}

void make_honeycomb(studio *st)
{
    int kind = rng_int(&st->d, 0, 2), n = kind == 2 ? 3 : 2, kept = rng_int(&st->d, 4, 8);
    shape s = kind == 0 ? shape_box(2, 2, 2) : kind == 1 ? shape_rhombic_dodecahedron() : shape_truncated_octahedron();
    put(st, &s, 0, 0, 0);
    for (int x = -n; x <= n; x++)
        for (int y = -n; y <= n; y++)
            for (int z = -n; z <= n; z++)
                if ((x || y || z) && is_centre(kind, x, y, z) && rng_int(&st->d, 1, 8) <= kept)
                    put(st, &s, x, y, z);
    if (rng_int(&st->d, 0, 1))
        look_in_plane(st, 0);
    else if (!st->eye)
        look_any(st);
    else
        look_small(st, 3);
}

/* A rotation about two axes. */
static void turn(studio *st, double m[3][3])
{
    double a = 3 * rng_real(&st->d), b = 3 * rng_real(&st->d);
    double rows[3][3] = {
        {cos(a), -sin(a), 0}, {cos(b) * sin(a), cos(b) * cos(a), -sin(b)}, {sin(b) * sin(a), sin(b) * cos(a), cos(b)}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            m[i][k] = rows[i][k];
}

void make_honeycomb_turned(studio *st)
{
    double m[3][3];
    make_honeycomb(st);
    turn(st, m);
    spoil(st, m);
}

/* ---- models given to four to seven digits ---------------------------------------------------------------------- */

/* Turned or not; of any size. */
static int put_digits(studio *st)
{
    static void (*const make[])(studio *) = {make_blocks, make_bricks, make_checker, make_honeycomb};
    int digits = rng_int(&st->d, 4, 7);
    double m[3][3], scale = 0.1 + fabs(rng_real(&st->d));
    make[rng_int(&st->d, 0, 3)](st);
    bool turned = rng_int(&st->d, 0, 3) > 0;
    turn(st, m);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            m[i][k] = turned ? scale * m[i][k] : i == k ? scale : 0;
    map_vertices_by(st, m);
    round_to_digits(st, digits);
    return digits;
}

static void look_at_digits(studio *st)
{
    st->unit = 0.125;
    if (rng_int(&st->d, 0, 1))
        look_any(st);
    else
        look_in_plane(st, small_angle(st));
    if (st->eye && !st->scene->view.w)
        look_from_eye(st);
    st->scene->tolerance = fmax(1e-5, 4 * roughness(st));
    leave_open(st);
}

/* Faces of four corners and more, which do not quite lie in a plane. */
void make_digits(studio *st)
{
    put_digits(st);
    look_at_digits(st);
}

void make_digits_in_triangles(studio *st)
{
    put_digits(st);
    triangulate(st);
    look_at_digits(st);
}

/* The hulls of these corners: all is judged but what counts as touching. */
void make_digits_convex(studio *st)
{
    put_digits(st);
    triangulate_convex(st);
    look_at_digits(st);
}

/* ---- beams ----------------------------------------------------------------------------------------------------- */

/* Long beams along x, one above the other, whose sides start in line and part by as little as 1e-10 of their length;
 * their ends are slanted, so that their boxes reach farther than their sides. */
static void put_beams(studio *st, bool tilted)
{
    int count = rng_int(&st->d, 4, 16), fine = rng_int(&st->d, 0, 1), slanted = fine || rng_int(&st->d, 0, 1);
    int digits = fine ? 10 : rng_int(&st->d, 1, 9);
    double wide = rng_int(&st->d, 0, 1) ? 1 : 0.125, spread = pow(10, -digits);
    shape s = rng_int(&st->d, 0, 1) ? shape_box(1, 1, 1) : shape_random(&st->d, 4, 1);
    for (int i = 0; i < count; i++) {
        double length = rng_int(&st->d, 4, 64), x = rng_int(&st->d, -64, 32), row = rng_int(&st->d, -3, 3) / 2.0;
        double side = rng_int(&st->d, 0, 1) * spread * rng_real(&st->d), lean = spread * rng_real(&st->d);
        double rise = rng_int(&st->d, 0, 1) * lean, slope = rng_int(&st->d, -1, 1), slant = rng_int(&st->d, -8, 8);
        double m[3][3] = {{length, slanted * slant, 0}, {length * lean, wide, 0}, {0, 0, 1}};
        if (tilted) /* all in planes through one line, or nearly so, and across one another there */
            m[2][0] = length * (slope + rise);
        put_mapped(st, &s, (roberts_vec3){x, wide * row - lean * (length / 2) + side, tilted ? slope * x : 2 * i}, m);
    }
}

void make_beams(studio *st)
{
    put_beams(st, false);
    st->eye ? look(st, 0, 0, 1) : look_down(st, 1e-3 * rng_int(&st->d, 0, 1), rng_int(&st->d, 0, 1) ? 1 : -1);
    near_touching(st);
}

void make_tilted_beams(studio *st)
{
    put_beams(st, true);
    st->eye ? look_small(st, 2) : look_down(st, rng_int(&st->d, 0, 1), rng_int(&st->d, 0, 1) ? 1 : -1);
    near_touching(st);
}
