/* mesh_families.c - see mesh_families.h. */
#include "mesh_families.h"

#include <math.h>
#include <string.h>

#include "mesh_workshop.h"

enum { CELLS = 5 /* of a block, each way */ };

/* ---- views ---- */

static void look(workshop *w)
{
    static const int axis[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {-1, 0, 0}};
    oracle_view *v = &w->scene->view;
    int kind = any(w, 0, 5);
    if (kind == 0) {
        const int *a = axis[any(w, 0, 5)];
        *v = (oracle_view){.x = a[0], .y = a[1], .z = a[2]};
    } else if (kind <= 2) {
        do {
            int x = any(w, -3, 3), y = any(w, -3, 3);
            *v = (oracle_view){.x = x, .y = y, .z = any(w, -3, 3)};
        } while (v->x == 0 && v->y == 0 && v->z == 0);
    } else if (kind == 3) {
        double x = rng_real(&w->d), y = rng_real(&w->d);
        *v = (oracle_view){.x = x, .y = y, .z = 0.1 + fabs(rng_real(&w->d))};
    } else { /* an eye, with whole numbers, outside the sphere round the scene */
        double size = 1;
        for (size_t i = 0; i < w->scene->mesh.vertex_count; i++) {
            roberts_vec3 p = w->scene->mesh.vertex[i];
            size = fmax(size, fmax(fabs(p.x), fmax(fabs(p.y), fabs(p.z))));
        }
        int far = (int)ceil(2 * size);
        *v = (oracle_view){.w = 1};
        double *to[3] = {&v->x, &v->y, &v->z};
        int out = any(w, 0, 2);
        for (int k = 0; k < 3; k++)
            *to[k] = k == out ? (any(w, 0, 1) ? 1 : -1) * (far + any(w, 1, 20)) : any(w, -far, far);
    }
}

/* ---- bodies made of cells: blocks, stairs, cups, rings, shells within shells, what meets in an edge or a corner
 * ---- */

typedef struct block {
    bool full[CELLS][CELLS][CELLS];
} block;

static bool filled(const block *b, int x, int y, int z)
{
    return x >= 0 && y >= 0 && z >= 0 && x < CELLS && y < CELLS && z < CELLS && b->full[x][y][z];
}

enum { SHARED = 0, TRIANGLES = 1, SOUP = 2, STRIPS = 4 };

/* A block as it becomes faces. */
typedef struct block_faces {
    uint32_t number[CELLS + 1][CELLS + 1][CELLS + 1]; /* of the vertices that there are */
    const int *at;                                    /* [3] of its first corner */
    int how;
} block_faces;

static uint32_t grid_vertex(workshop *w, block_faces *f, const int p[3])
{
    uint32_t *n = &f->number[p[0]][p[1]][p[2]];
    if ((f->how & SOUP) || *n == ROBERTS_NONE)
        *n = vertex(w, f->at[0] + p[0], f->at[1] + p[1], f->at[2] + p[2]);
    return *n;
}

/* One face of cells, at right angles to `axis`: from `low` on, one cell along the next axis, `length` cells along the
 * last one. */
static void add_quad(workshop *w, block_faces *f, const int low[3], int axis, int length)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    uint32_t c[4];
    for (int k = 0; k < 4; k++) {
        int p[3] = {low[0], low[1], low[2]};
        p[u] += k == 1 || k == 2;
        p[v] += k >= 2 ? length : 0;
        c[k] = grid_vertex(w, f, p);
    }
    if (f->how & TRIANGLES) {
        int first = any(w, 0, 1);
        triangle(w, c[first], c[first + 1], c[first + 2]);
        triangle(w, c[first], c[first + 2], c[(first + 3) % 4]);
    } else {
        face(w, c, 4);
    }
}

/* The border of a block, cell by cell, or in strips of cells, which meet the corners of others in their sides. */
static void add_block(workshop *w, const block *b, int how, const int at[3])
{
    block_faces faces = {.at = at, .how = how};
    memset(faces.number, 0xff, sizeof faces.number);
    for (int axis = 0; axis < 3; axis++)
        for (int side = 0; side < 2; side++)
            for (int i = 0; i < CELLS; i++)
                for (int j = 0; j < CELLS; j++)
                    for (int k = 0, run; k < CELLS; k += run) {
                        int u = (axis + 1) % 3, v = (axis + 2) % 3, p[3];
                        run = 0;
                        do {
                            p[axis] = i, p[u] = j, p[v] = k + run;
                            bool inside = filled(b, p[0], p[1], p[2]);
                            p[axis] += side ? 1 : -1;
                            if (!inside || filled(b, p[0], p[1], p[2]))
                                break;
                            run++;
                        } while ((how & STRIPS) && k + run < CELLS);
                        if (run > 0) {
                            p[axis] = i + side, p[u] = j, p[v] = k;
                            add_quad(w, &faces, p, axis, run);
                        }
                        run = run > 0 ? run : 1;
                    }
}

static void fill_randomly(workshop *w, block *b, int part)
{
    for (int x = 0; x < CELLS; x++)
        for (int y = 0; y < CELLS; y++)
            for (int z = 0; z < CELLS; z++)
                b->full[x][y][z] = any(w, 0, 99) < part;
}

static void fill_box(block *b, const int low[3], const int high[3], bool full)
{
    for (int x = low[0]; x < high[0]; x++)
        for (int y = low[1]; y < high[1]; y++)
            for (int z = low[2]; z < high[2]; z++)
                b->full[x][y][z] = full;
}

/* One or two bodies of a few boxes, with boxes taken out: L, T, U, stairs, cups, rings. */
static void fill_with_boxes(workshop *w, block *b)
{
    *b = (block){0};
    for (int i = 0, boxes = any(w, 2, 5); i < boxes; i++) {
        int low[3], high[3];
        for (int k = 0; k < 3; k++) {
            low[k] = any(w, 0, CELLS - 1);
            high[k] = any(w, low[k] + 1, CELLS);
        }
        fill_box(b, low, high, i == 0 || any(w, 0, 2) > 0);
    }
}

static const int origin[3] = {0, 0, 0};

static void blocks(workshop *w)
{
    block b;
    fill_with_boxes(w, &b);
    add_block(w, &b, any(w, 0, 1) ? TRIANGLES : SHARED, origin);
}

static void blocks_in_strips(workshop *w)
{
    block b;
    fill_with_boxes(w, &b);
    add_block(w, &b, STRIPS, origin);
}

static void block_soup(workshop *w)
{
    block b;
    fill_with_boxes(w, &b);
    int how = any(w, 0, 1) ? SOUP | TRIANGLES : SOUP;
    add_block(w, &b, any(w, 0, 1) ? how | STRIPS : how, origin);
}

/* Cells at random: some meet in edges and corners alone. */
static void crumbs(workshop *w)
{
    block b;
    fill_randomly(w, &b, any(w, 10, 50));
    add_block(w, &b, any(w, 0, 3), origin);
}

static void shells(workshop *w)
{
    block b = {0};
    fill_box(&b, (int[]){0, 0, 0}, (int[]){5, 5, 5}, true);
    fill_box(&b, (int[]){1, 1, 1}, (int[]){4, 4, 4}, false);
    fill_box(&b, (int[]){2, 2, 2}, (int[]){3, 3, 3}, any(w, 0, 1));
    if (any(w, 0, 1)) {
        int low = any(w, 3, 4), x = any(w, 2, 4), y = any(w, 2, 4);
        fill_box(&b, (int[]){1, 1, low}, (int[]){x, y, 5}, false);
    }
    add_block(w, &b, any(w, 0, 1), origin);
}

/* Bodies that touch, overlap and pass through one another. */
static void touching(workshop *w)
{
    for (int i = any(w, 2, 4); i > 0; i--) {
        block b;
        int at[3];
        for (int k = 0; k < 3; k++)
            at[k] = any(w, 0, 6);
        fill_with_boxes(w, &b);
        add_block(w, &b, any(w, 0, 1), at);
    }
}

/* ---- surfaces ---- */

static void terrain(workshop *w)
{
    int n = any(w, 4, 7), steep = any(w, 1, 4);
    uint32_t at[8][8];
    for (int i = 0; i <= n; i++)
        for (int k = 0; k <= n; k++)
            at[i][k] = vertex(w, i, k, any(w, 0, steep));
    for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++) {
            if (any(w, 0, 12) == 0)
                continue;
            triangle(w, at[i][k], at[i + 1][k], at[i + 1][k + 1]);
            triangle(w, at[i][k], at[i + 1][k + 1], at[i][k + 1]);
        }
}

/* A tube round a circle or a knot of whole numbers, or a band with a half turn. */
static void ring(workshop *w, int around, int across, bool half_turn)
{
    uint32_t at[64][16];
    for (int i = 0; i < around; i++)
        for (int k = 0; k < across; k++) {
            double u = full_turn * i / around, v = full_turn * k / across + (half_turn ? u / 2 : 0);
            if (half_turn)
                v = u / 2 + (k ? full_turn / 2 : 0);
            double r = 20 + 9 * cos(v);
            at[i][k] = vertex(w, round_to(r * cos(u), 1), round_to(r * sin(u), 1), round_to(9 * sin(v), 1));
        }
    for (int i = 0; i < around; i++)
        for (int k = 0; k < (half_turn ? across - 1 : across); k++) {
            int j = (i + 1) % around, l = (k + 1) % across;
            bool swap = half_turn && j == 0;
            uint32_t a = at[i][k], b = at[i][l], c = at[j][swap ? k : l], d = at[j][swap ? l : k];
            triangle(w, a, b, c);
            triangle(w, a, c, d);
        }
}

static void tori(workshop *w)
{
    int around = any(w, 5, 16);
    ring(w, around, any(w, 3, 8), false);
}

static void moebius(workshop *w)
{
    ring(w, any(w, 5, 20), 2, true);
}

/* Prisms without lids, or with one. */
static void open_prisms(workshop *w)
{
    for (int i = any(w, 1, 3); i > 0; i--) {
        int n = any(w, 3, 7), x = any(w, -9, 9), y = any(w, -9, 9), z = any(w, -5, 5);
        int lean = any(w, -3, 3), high = any(w, 2, 9);
        uint32_t low[8], up[8];
        for (int k = 0; k < n; k++) {
            double px = x + round_to(8 * cos(full_turn * k / n), 1), py = y + round_to(8 * sin(full_turn * k / n), 1);
            low[k] = vertex(w, px, py, z);
            up[k] = vertex(w, px + lean, py, z + high);
        }
        for (int k = 0; k < n; k++)
            face(w, (uint32_t[]){low[k], low[(k + 1) % n], up[(k + 1) % n], up[k]}, 4);
        if (any(w, 0, 1))
            face(w, low, n);
    }
}

static void soup(workshop *w)
{
    int size = any(w, 2, 8);
    for (int i = any(w, 5, 25); i > 0; i--) {
        uint32_t c[3];
        for (int k = 0; k < 3; k++) {
            int x = any(w, 0, size), y = any(w, 0, size);
            c[k] = vertex(w, x, y, any(w, 0, size));
        }
        triangle(w, c[0], c[1], c[2]);
    }
}

/* Triangles among a few points, three and more at an edge. */
static void knots(workshop *w)
{
    uint32_t at[9];
    int points = any(w, 5, 9);
    for (int i = 0; i < points; i++) {
        int x = any(w, 0, 4), y = any(w, 0, 4);
        at[i] = vertex(w, x, y, any(w, 0, 4));
    }
    for (int i = any(w, 4, 16); i > 0; i--) {
        int a = any(w, 0, points - 1), b = any(w, 0, points - 1), c = any(w, 0, points - 1);
        if (a != b && b != c && a != c)
            triangle(w, at[a], at[b], at[c]);
    }
}

/* Pages that share a back. */
static void books(workshop *w)
{
    uint32_t a = vertex(w, 0, 0, 0), b = vertex(w, 0, 0, 6);
    for (int i = any(w, 2, 7); i > 0; i--) {
        int x = any(w, -4, 4), y = any(w, -4, 4);
        if (x == 0 && y == 0)
            continue;
        uint32_t c = vertex(w, x, y, 6), d = vertex(w, x, y, 0);
        face(w, (uint32_t[]){a, b, c, d}, 4);
    }
}

/* An octahedron with a point over each face, perhaps inside it: a star, or a dented body. mixed: some faces are wound
 * the other way. */
static void star_at(workshop *w, const int at[3], bool mixed)
{
    const int r = any(w, 4, 9), out = any(w, 1, r);
    uint32_t end[3][2];
    for (int axis = 0; axis < 3; axis++)
        for (int side = 0; side < 2; side++) {
            int p[3] = {at[0] + any(w, -1, 1), at[1] + any(w, -1, 1), at[2] + any(w, -1, 1)};
            p[axis] += side ? r : -r;
            end[axis][side] = vertex(w, p[0], p[1], p[2]);
        }
    for (int k = 0; k < 8; k++) {
        const int x = k & 1, y = k >> 1 & 1, z = k >> 2;
        const bool even = (x + y + z) % 2 == 0;
        uint32_t top = vertex(w, at[0] + (x ? out : -out), at[1] + (y ? out : -out), at[2] + (z ? out : -out));
        const uint32_t c[3] = {end[0][x], end[1][y], end[2][z]};
        for (int i = 0; i < 3; i++) {
            bool turned = even ^ (mixed && any(w, 0, 3) == 0);
            triangle(w, c[turned ? (i + 1) % 3 : i], c[turned ? i : (i + 1) % 3], top);
        }
    }
}

/* A sheet with folds and holes. */
static void sheet_at(workshop *w, const int at[3])
{
    uint32_t v[4][4];
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            v[i][k] =
                vertex(w, at[0] + 5 * i - 8 + any(w, -3, 3), at[1] + 5 * k - 8 + any(w, -3, 3), at[2] + any(w, -2, 2));
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            if (any(w, 0, 8) == 0)
                continue;
            triangle(w, v[i][k], v[i + 1][k], v[i + 1][k + 1]);
            triangle(w, v[i][k], v[i + 1][k + 1], v[i][k + 1]);
        }
}

/* Bodies heaped over one another, so that covers hide many of them: see cover_add_body(). */
static void heaps(workshop *w)
{
    for (int i = any(w, 6, 12); i > 0; i--) {
        int at[3] = {any(w, -5, 5), any(w, -5, 5), any(w, -20, 20)}, kind = any(w, 0, 3);
        if (kind == 0)
            sheet_at(w, at);
        else
            star_at(w, at, kind == 1);
    }
}

/* One sheet folded many times, so that its own faces hide nearly all of it: see cover_add_own(). */
static void pleats(workshop *w)
{
    enum { PLEATS = 9, ROWS = 4, ACROSS = 5, SIZE = 40 };
    uint32_t v[PLEATS * ROWS][ACROSS];
    const int loose = any(w, 0, 3);
    for (int i = 0; i < PLEATS * ROWS; i++) {
        const int pleat = i / ROWS, half = SIZE / 2 - pleat, along = i % ROWS, x = 2 * half * along / (ROWS - 1) - half;
        for (int k = 0; k < ACROSS; k++)
            v[i][k] = vertex(w, (pleat % 2 ? -x : x) + any(w, -loose, loose),
                             2 * half * k / (ACROSS - 1) - half + any(w, -loose, loose), -4 * pleat + any(w, 0, loose));
    }
    for (int i = 0; i + 1 < PLEATS * ROWS; i++)
        for (int k = 0; k + 1 < ACROSS; k++) {
            triangle(w, v[i][k], v[i + 1][k], v[i][k + 1]);
            triangle(w, v[i + 1][k], v[i + 1][k + 1], v[i][k + 1]);
        }
}

/* ---- faces of any shape, in planes through whole points ---- */

/* A star polygon, a concave one, or a random one that crosses itself; perhaps with a point over it. */
static void stars(workshop *w)
{
    for (int i = any(w, 1, 3); i > 0; i--) {
        sheet s = any_sheet(w);
        uint32_t c[12];
        int n = any(w, 5, 9), kind = any(w, 0, 2), step = n % 2 ? any(w, 2, n / 2) : 1;
        for (int k = 0; k < n; k++) {
            double u = full_turn * (k * step % n) / n, r = kind == 1 && k % 2 ? 4 : 10;
            int x = (int)round_to(r * cos(u), 1), y = (int)round_to(r * sin(u), 1);
            if (kind == 2) {
                x = any(w, -5, 5);
                y = any(w, -5, 5);
            }
            c[k] = on_sheet(w, &s, x, y);
        }
        face(w, c, n);
        if (any(w, 0, 1)) {
            int x = any(w, -3, 3);
            uint32_t top = vertex(w, x, 2, any(w, 3, 12));
            for (int k = 0; k < n; k++)
                triangle(w, c[k], c[(k + 1) % n], top);
        }
    }
    w->scene->even_odd = any(w, 0, 2) == 0;
}

/* Frames: a slit joins the hole to the border. */
static void slits(workshop *w)
{
    for (int i = any(w, 1, 4); i > 0; i--) {
        sheet s = any_sheet(w);
        int a = any(w, 1, 3), b = any(w, 4, 6), size = any(w, 7, 9);
        uint32_t o[4] = {on_sheet(w, &s, 0, 0), on_sheet(w, &s, size, 0), on_sheet(w, &s, size, size),
                         on_sheet(w, &s, 0, size)};
        uint32_t h[4] = {on_sheet(w, &s, a, a), on_sheet(w, &s, a, b), on_sheet(w, &s, b, b), on_sheet(w, &s, b, a)};
        face(w, (uint32_t[]){o[0], o[1], o[2], o[3], o[0], h[0], h[1], h[2], h[3], h[0]}, 10);
    }
}

/* Rectangles that overlap in one plane, and others through it. */
static void overlaps(workshop *w)
{
    sheet s = any_sheet(w);
    for (int i = any(w, 3, 8); i > 0; i--) {
        sheet t = any(w, 0, 3) ? s : any_sheet(w);
        int x = any(w, -6, 3), y = any(w, -6, 3), a = any(w, 1, 6), b = any(w, 1, 6);
        uint32_t c[4] = {on_sheet(w, &t, x, y), on_sheet(w, &t, x + a, y), on_sheet(w, &t, x + a, y + b),
                         on_sheet(w, &t, x, y + b)};
        face(w, c, 4);
    }
}

/* A body over a profile of many corners, most of them on a few lines: fins, steps, towers, teeth. A triangle lies
 * anywhere, and may go through it. */
static void profiles(workshop *w)
{
    enum { FINS, STEPS, TOWERS, TEETH, MOST = 36 };
    const int kind = any(w, FINS, TEETH), count = any(w, 18, MOST), foot = any(w, 1, 6), high = any(w, 1, 9);
    const int wide = kind == STEPS ? count : 2 * count;
    uint32_t below[4 * MOST + 3], above[4 * MOST + 3];
    int n = 0, at[4 * MOST + 3][2];
    for (int i = 0; i < count; i++) {
        const int top = kind == STEPS ? foot + i : kind == TOWERS ? foot + any(w, 0, high) : foot + high;
        const int corner[][2] = {{2 * i, foot}, {2 * i, top}, {2 * i + 1, top}, {2 * i + 1, foot}};
        const int step[][2] = {{i, top}, {i + 1, top}};
        for (int k = kind == TEETH ? 1 : 0; k < (kind == STEPS ? 2 : 4); k++) {
            at[n][0] = kind == STEPS ? step[k][0] : corner[k][0];
            at[n++][1] = kind == STEPS ? step[k][1] : corner[k][1];
        }
    }
    for (int k = 0; k < 2; k++) {
        at[n][0] = k == 0 ? wide : 0;
        at[n++][1] = 0;
    }
    for (int i = 0; i < n; i++) {
        below[i] = vertex(w, at[i][0], at[i][1], 0);
        above[i] = vertex(w, at[i][0], at[i][1], 4);
    }
    for (int i = 0; i < n; i++)
        face(w, (uint32_t[]){below[i], below[(i + 1) % n], above[(i + 1) % n], above[i]}, 4);
    face(w, below, n);
    face(w, above, n);
    uint32_t loose[3];
    for (int k = 0; k < 3; k++)
        loose[k] = vertex(w, any(w, 0, wide), any(w, -5, 2 * foot + high), any(w, -3, 7));
    triangle(w, loose[0], loose[1], loose[2]);
}

static const mesh_family families[] = {
    {"blocks", blocks},
    {"strips", blocks_in_strips},
    {"block-soup", block_soup},
    {"crumbs", crumbs},
    {"shells", shells},
    {"touching", touching},
    {"terrain", terrain},
    {"tori", tori},
    {"moebius", moebius},
    {"open-prisms", open_prisms},
    {"soup", soup},
    {"knots", knots},
    {"books", books},
    {"heaps", heaps},
    {"pleats", pleats},
    {"stars", stars},
    {"slits", slits},
    {"overlaps", overlaps},
    {"profiles", profiles},
};

enum { OWN = sizeof families / sizeof families[0] };

size_t mesh_family_count(void)
{
    return OWN + mesh_cross_family_count + mesh_union_family_count;
}

static const mesh_family *family(size_t index)
{
    if (index < OWN)
        return &families[index];
    index -= OWN;
    return index < mesh_cross_family_count ? &mesh_cross_families[index]
                                           : &mesh_union_families[index - mesh_cross_family_count];
}

const char *mesh_family_name(size_t index)
{
    return family(index)->name;
}

bool mesh_family_make(size_t index, uint64_t seed, mesh_scene *scene)
{
    workshop w = {.scene = scene, .d = {(seed << 8) + index}};
    *scene = (mesh_scene){0};
    for (int i = 0; i < 8; i++)
        rng_next(&w.d);
    do {
        roberts_mesh_free(&scene->mesh);
        family(index)->make(&w);
    } while (!w.no_memory && scene->mesh.face_count == 0);
    look(&w);
    scene->united = index >= OWN + mesh_cross_family_count;
    if (w.no_memory)
        mesh_scene_free(scene);
    return !w.no_memory;
}

void mesh_scene_free(mesh_scene *scene)
{
    roberts_mesh_free(&scene->mesh);
    *scene = (mesh_scene){0};
}
