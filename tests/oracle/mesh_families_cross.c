/* mesh_families_cross.c - scenes in which faces cross. Coordinates are whole numbers, so that planes are exact and
 * contacts are what they look like. */
#include "mesh_workshop.h"

/* ---- loose faces ---- */

static void rectangle(workshop *w, const sheet *s, const int low[2], const int high[2])
{
    uint32_t c[4];
    for (int k = 0; k < 4; k++)
        c[k] = on_sheet(w, s, k == 1 || k == 2 ? high[0] : low[0], k >= 2 ? high[1] : low[1]);
    face(w, c, 4);
}

/* Rectangles through one another, at right angles and aslant. */
static void sheets(workshop *w)
{
    for (int i = any(w, 3, 8); i > 0; i--) {
        sheet s = any_sheet(w);
        int low[2], high[2];
        for (int k = 0; k < 2; k++) {
            low[k] = any(w, -8, -1);
            high[k] = any(w, 1, 8);
        }
        for (int k = 0; k < 3; k++)
            s.o[k] /= 2;
        rectangle(w, &s, low, high);
    }
}

/* Boards with holes, and others that go through the holes, fill them or are too large for them. */
static void slots(workshop *w)
{
    for (int i = any(w, 1, 2); i > 0; i--) {
        int z = any(w, -1, 1);
        uint32_t c[8];
        for (int k = 0; k < 8; k++) {
            bool right = k % 4 == 1 || k % 4 == 2, hole = k >= 4, up = k % 4 >= 2;
            c[k] = vertex(w, hole ? (right ? 6 : 2) : (right ? 9 : 0), hole ? (up ? 5 : 3) : (up ? 8 : 0), z);
        }
        face(w, (uint32_t[]){c[0], c[1], c[2], c[3], c[0], c[4], c[7], c[6], c[5], c[4]}, 10);
    }
    for (int i = any(w, 1, 4); i > 0; i--) {
        int x = any(w, 0, 5), long_ = any(w, 1, 6), y = any(w, 2, 6), lean = any(w, -1, 1), deep = any(w, 0, 3);
        if (any(w, 0, 1)) {
            uint32_t c[4] = {vertex(w, x, y - lean, -deep), vertex(w, x + long_, y - lean, -deep),
                             vertex(w, x + long_, y + lean, 3), vertex(w, x, y + lean, 3)};
            face(w, c, 4);
        } else {
            uint32_t c[4] = {vertex(w, x - lean, y, -deep), vertex(w, x - lean, y + long_, -deep),
                             vertex(w, x + lean, y + long_, 3), vertex(w, x + lean, y, 3)};
            face(w, c, 4);
        }
    }
}

/* Sheets through one line, each along a random part of it. */
static void fans(workshop *w)
{
    sheet s = any_sheet(w); /* its first axis is the line */
    for (int i = any(w, 3, 7); i > 0; i--) {
        sheet t = s;
        int low[2], high[2];
        do
            for (int k = 0; k < 3; k++)
                t.v[k] = any(w, -2, 2);
        while (t.u[0] * t.v[1] == t.u[1] * t.v[0] && t.u[0] * t.v[2] == t.u[2] * t.v[0] &&
               t.u[1] * t.v[2] == t.u[2] * t.v[1]);
        low[0] = any(w, -6, 2);
        high[0] = any(w, low[0] + 1, 8);
        low[1] = any(w, -3, 0);
        high[1] = any(w, 0, 3) ? any(w, 1, 3) : any(w, low[1] + 1, 3);
        rectangle(w, &t, low, high);
    }
    if (any(w, 0, 1))
        sheets(w);
}

/* Folded sheets whose folds, and sides, lie in one line, on and in other sheets: edges and lines in one place. */
static void ridges(workshop *w)
{
    int level = any(w, 0, 1);
    rectangle(w, &(sheet){{0, 0, level}, {1, 0, 0}, {0, 1, 0}}, (int[]){-3, -3}, (int[]){5, 3});
    for (int i = any(w, 2, 4); i > 0; i--) {
        int x = any(w, -4, 2), end = any(w, x + 1, 7), z = any(w, 0, 1);
        int y0 = any(w, -3, 3), y1 = any(w, -3, 3), z0 = any(w, -3, 3), z1 = any(w, -3, 3);
        uint32_t a = vertex(w, x, 0, z), b = vertex(w, end, 0, z);
        if (y0 != 0 || z0 != z)
            face(w, (uint32_t[]){a, b, vertex(w, end, y0, z0), vertex(w, x, y0, z0)}, 4);
        if (y1 != 0 || z1 != z)
            face(w, (uint32_t[]){a, b, vertex(w, end, y1, z1), vertex(w, x, y1, z1)}, 4);
        if (any(w, 0, 1)) { /* one that goes on beyond the line */
            int lean = any(w, -2, 2);
            uint32_t c[4] = {vertex(w, x, -lean, -2), vertex(w, end, -lean, -2), vertex(w, end, lean, 2),
                             vertex(w, x, lean, 2)};
            face(w, c, 4);
        }
    }
}

/* Large triangles that are almost in one plane. */
static void nearly_coplanar(workshop *w)
{
    int size = any(w, 0, 1) ? 1000 : 30000;
    for (int i = any(w, 3, 6); i > 0; i--) {
        uint32_t c[3];
        for (int k = 0; k < 3; k++) {
            int x = any(w, -size, size), y = any(w, -size, size);
            c[k] = vertex(w, x, y, any(w, -2, 2));
        }
        triangle(w, c[0], c[1], c[2]);
    }
}

/* ---- bodies ---- */

static const int nowhere[3] = {0, 0, 0};

/* Regular tetrahedra of one size about one point. */
static void five_tetrahedra(workshop *w)
{
    static const int corner[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    for (int i = any(w, 2, 5); i > 0; i--) {
        int at[3];
        shape s = {0};
        const matrix m = workshop_rotation(w);
        for (int k = 0; k < 4; k++)
            shape_point(&s, corner[k][0], corner[k][1], corner[k][2]);
        for (int k = 0; k < 3; k++)
            at[k] = any(w, 0, 3) ? 0 : any(w, -3, 3);
        if (shape_hull(&s))
            workshop_put(w, &s, at, &m);
    }
}

/* Boxes on the grid, in one another and through one another; all convex. */
static void cubes_in_cubes(workshop *w)
{
    for (int i = any(w, 2, 6); i > 0; i--) {
        int at[3];
        for (int k = 0; k < 3; k++)
            at[k] = any(w, 0, 4);
        int x = any(w, 1, 5), y = any(w, 1, 5);
        shape s = shape_box(x, y, any(w, 1, 5));
        workshop_put(w, &s, at, &workshop_identity);
    }
}

/* The same turned by exact rotations. */
static void turned_cubes(workshop *w)
{
    for (int i = any(w, 2, 4); i > 0; i--) {
        int at[3];
        const matrix m = workshop_rotation(w);
        for (int k = 0; k < 3; k++)
            at[k] = 9 * any(w, -1, 1);
        int x = any(w, 1, 3), y = any(w, 1, 3);
        shape s = shape_box(x, y, any(w, 1, 3));
        workshop_put(w, &s, at, &m);
    }
}

/* Convex solids of any shape, nested and through one another. */
static void convex_solids(workshop *w)
{
    for (int i = any(w, 2, 5); i > 0; i--) {
        int at[3];
        shape s = shape_any(&w->d);
        for (int k = 0; k < 3; k++)
            at[k] = any(w, -3, 3);
        workshop_put(w, &s, at, &workshop_identity);
    }
}

/* A prism over a star, whose walls cross one another, its ends wound round once and twice. */
static void star_prism(workshop *w, const int at[3])
{
    static const int star5[5][2] = {{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}};
    static const int star7[7][2] = {{0, 10}, {10, -2}, {-4, -9}, {-8, 6}, {8, 6}, {4, -9}, {-10, -2}};
    int n = any(w, 0, 1) ? 5 : 7, high = any(w, 2, 12), x = any(w, -3, 3);
    uint32_t low[7], up[7];
    for (int k = 0; k < n; k++) {
        const int *p = n == 5 ? star5[k] : star7[k];
        low[k] = vertex(w, at[0] + p[0], at[1] + p[1], at[2]);
        up[k] = vertex(w, at[0] + p[0] + x, at[1] + p[1], at[2] + high);
    }
    for (int k = 0; k < n; k++)
        face(w, (uint32_t[]){low[k], low[(k + 1) % n], up[(k + 1) % n], up[k]}, 4);
    face(w, low, n);
    face(w, up, n);
}

static void star_bodies(workshop *w)
{
    star_prism(w, nowhere);
    if (any(w, 0, 1)) {
        int x = any(w, -8, 8), y = any(w, -8, 8);
        star_prism(w, (int[]){x, y, any(w, -5, 5)});
    } else if (any(w, 0, 1)) {
        int x = any(w, 3, 20), y = any(w, 3, 20);
        shape s = shape_box(x, y, any(w, 1, 15));
        workshop_put(w, &s, (int[]){-8, -2, any(w, -4, 4)}, &workshop_identity);
    }
    w->scene->even_odd = any(w, 0, 2) == 0;
}

/* Screws: prisms that turn as they rise, in triangles, through plates. */
static void screws(workshop *w)
{
    for (int i = any(w, 1, 2); i > 0; i--) {
        enum { LEVELS = 6, MOST = 6 };
        int n = any(w, 3, MOST), levels = any(w, 2, LEVELS - 1), x = any(w, -4, 4), y = any(w, -4, 4);
        double turn = 0.1 * any(w, 1, 5);
        uint32_t at[LEVELS][MOST];
        for (int l = 0; l <= levels; l++)
            for (int k = 0; k < n; k++) {
                double u = full_turn * k / n + turn * l, r = k % 2 ? 12 : 9;
                at[l][k] = vertex(w, x + round_to(r * cos(u), 1), y + round_to(r * sin(u), 1), 4 * l);
            }
        for (int l = 0; l < levels; l++)
            for (int k = 0; k < n; k++) {
                int next = (k + 1) % n;
                triangle(w, at[l][k], at[l][next], at[l + 1][next]);
                triangle(w, at[l][k], at[l + 1][next], at[l + 1][k]);
            }
        for (int end = 0; end < 2; end++)
            face(w, at[end ? levels : 0], n);
    }
    for (int i = any(w, 1, 2); i > 0; i--) {
        int z = any(w, -2, 18), thick = any(w, 1, 5), side = any(w, 14, 30);
        shape s = shape_box(side, side, thick);
        workshop_put(w, &s, (int[]){-14, -14, z}, &workshop_identity);
    }
}

/* A box with a notch, and convex solids through it. */
static void notched(workshop *w)
{
    static const int outline[8][2] = {{0, 0}, {12, 0}, {12, 9}, {8, 9}, {8, 4}, {4, 4}, {4, 9}, {0, 9}};
    uint32_t low[8], up[8];
    int high = any(w, 4, 9);
    for (int k = 0; k < 8; k++) {
        low[k] = vertex(w, outline[k][0], outline[k][1], 0);
        up[k] = vertex(w, outline[k][0], outline[k][1], high);
    }
    for (int k = 0; k < 8; k++)
        face(w, (uint32_t[]){low[k], low[(k + 1) % 8], up[(k + 1) % 8], up[k]}, 4);
    face(w, low, 8);
    face(w, up, 8);
    for (int i = any(w, 1, 3); i > 0; i--) {
        int at[3];
        shape s = shape_any(&w->d);
        for (int k = 0; k < 3; k++)
            at[k] = any(w, -1, 8);
        workshop_put(w, &s, at, &workshop_identity);
    }
}

/* Random triangles, larger than their grid: they cross in many places. */
static void crossed_soup(workshop *w)
{
    int size = any(w, 3, 12);
    for (int i = any(w, 6, 16); i > 0; i--) {
        uint32_t c[3];
        for (int k = 0; k < 3; k++) {
            int x = any(w, -size, size), y = any(w, -size, size);
            c[k] = vertex(w, x, y, any(w, -size, size));
        }
        triangle(w, c[0], c[1], c[2]);
    }
}

const mesh_family mesh_cross_families[] = {
    {"sheets", sheets},
    {"slots", slots},
    {"fans", fans},
    {"ridges", ridges},
    {"nearly-coplanar", nearly_coplanar},
    {"five-tetrahedra", five_tetrahedra},
    {"cubes-in-cubes", cubes_in_cubes},
    {"turned-cubes", turned_cubes},
    {"convex-solids", convex_solids},
    {"star-bodies", star_bodies},
    {"screws", screws},
    {"notched", notched},
    {"crossed-soup", crossed_soup},
};

const size_t mesh_cross_family_count = sizeof mesh_cross_families / sizeof mesh_cross_families[0];
