/* mesh_families_union.c - scenes of closed bodies that are drawn as one. Coordinates are whole numbers. */

#include "mesh_workshop.h"

static void box(workshop *w, const int at[3], const int size[3])
{
    shape s = shape_box(size[0], size[1], size[2]);
    workshop_put(w, &s, at, &workshop_identity);
}

static void any_triple(workshop *w, int out[3], int low, int high)
{
    for (int k = 0; k < 3; k++)
        out[k] = any(w, low, high);
}

/* Blocks on a small grid: flush, stacked, overlapping, in one another. */
static void united_blocks(workshop *w)
{
    for (int i = any(w, 2, 6); i > 0; i--) {
        int at[3], size[3];
        any_triple(w, at, 0, 3);
        any_triple(w, size, 1, 3);
        box(w, at, size);
    }
}

/* Rows of bricks, each shifted against the one below. */
static void united_bricks(workshop *w)
{
    int rows = any(w, 1, 3), long_ = any(w, 2, 3);
    for (int z = 0; z < rows; z++)
        for (int i = 0; i < long_; i++)
            box(w, (int[]){4 * i + (z % 2 ? 2 : 0), 0, 2 * z}, (int[]){4, 2, 2});
    if (any(w, 0, 1))
        box(w, (int[]){any(w, -2, 2), -2, -1}, (int[]){any(w, 3, 20), 6, 1});
}

/* Blocks turned together, and some turned otherwise. */
static void united_turned(workshop *w)
{
    const matrix all = workshop_rotation(w);
    for (int i = any(w, 2, 4); i > 0; i--) {
        int size[3], grid[3], at[3];
        const matrix m = any(w, 0, 3) ? all : workshop_rotation(w);
        any_triple(w, grid, 0, 2);
        any_triple(w, size, 1, 2);
        for (int k = 0; k < 3; k++)
            at[k] = all.row[k][0] * grid[0] + all.row[k][1] * grid[1] + all.row[k][2] * grid[2];
        shape s = shape_box(size[0], size[1], size[2]);
        workshop_put(w, &s, at, &m);
    }
}

/* Tetrahedra and wedges that stand on blocks, in them and beside them. */
static void united_tetrahedra(workshop *w)
{
    for (int i = any(w, 1, 2); i > 0; i--) {
        int at[3], size[3];
        any_triple(w, at, 0, 2);
        any_triple(w, size, 2, 5);
        box(w, at, size);
    }
    for (int i = any(w, 1, 3); i > 0; i--) {
        shape s = {0};
        for (int k = any(w, 4, 6); k > 0; k--) {
            int x = any(w, 0, 6), y = any(w, 0, 6);
            shape_point(&s, x, y, any(w, 0, 6));
        }
        if (shape_hull(&s))
            workshop_put(w, &s, (int[]){0, 0, 0}, &workshop_identity);
    }
}

/* Wedges: halves, thirds of blocks cut through edges, put together again and otherwise. */
static void united_wedges(workshop *w)
{
    for (int i = any(w, 2, 5); i > 0; i--) {
        int at[3];
        shape s = {0};
        int high = any(w, 1, 3), cut = any(w, 0, 3);
        any_triple(w, at, 0, 2);
        for (int k = 0; k < 8; k++)
            if ((k & 3) != cut)
                shape_point(&s, 2 * (k & 1), 2 * (k >> 1 & 1), high * (k >> 2));
        if (shape_hull(&s))
            workshop_put(w, &s, at, &workshop_identity);
    }
}

/* A body that is not convex, an extruded outline, with blocks in its notches, through them and around them. */
static void united_notched(workshop *w)
{
    static const int outline[][8][2] = {
        {{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}},
        {{0, 0}, {6, 0}, {6, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}},
        {{0, 0}, {6, 0}, {6, 2}, {5, 2}, {5, 3}, {3, 3}, {3, 4}, {0, 4}},
    };
    const int(*p)[2] = outline[any(w, 0, 2)];
    uint32_t low[8], up[8];
    int high = any(w, 1, 4);
    for (int k = 0; k < 8; k++) {
        low[k] = vertex(w, p[k][0], p[k][1], 0);
        up[k] = vertex(w, p[k][0], p[k][1], high);
    }
    for (int k = 0; k < 8; k++)
        face(w, (uint32_t[]){low[k], low[(k + 1) % 8], up[(k + 1) % 8], up[k]}, 4);
    face(w, low, 8);
    face(w, up, 8);
    for (int i = any(w, 1, 3); i > 0; i--) {
        int at[3], size[3];
        any_triple(w, at, -1, 4);
        any_triple(w, size, 1, 3);
        box(w, at, size);
    }
}

/* Solids of any shape through one another. */
static void united_solids(workshop *w)
{
    for (int i = any(w, 2, 4); i > 0; i--) {
        int at[3];
        shape s = shape_any(&w->d);
        any_triple(w, at, -2, 2);
        workshop_put(w, &s, at, &workshop_identity);
    }
}

const mesh_family mesh_union_families[] = {
    {"united-blocks", united_blocks},         {"united-bricks", united_bricks}, {"united-turned", united_turned},
    {"united-tetrahedra", united_tetrahedra}, {"united-wedges", united_wedges}, {"united-notched", united_notched},
    {"united-solids", united_solids},
};

const size_t mesh_union_family_count = sizeof mesh_union_families / sizeof mesh_union_families[0];
