/* test_union.c - the pieces of lines that a union keeps, compared with blocks of a grid, where the answer is obvious.
 */
#include "model/union.h"

#include <stdio.h>

#include "roberts.h"
#include "scenes.h"

enum { GRID = 8, BODIES = 32 };

/* Blocks and the cells that they fill; `corner` gives back the whole coordinates of each vertex. */
typedef struct blocks {
    model m;
    uint32_t filled[GRID][GRID][GRID]; /* bit i: by body i */
    roberts_vec3 corner[12 * BODIES];
    int low[BODIES][3], high[BODIES][3];
    bool angled; /* there is a body that is no block */
} blocks;

static void fill_cells(blocks *b, const int low[3], const int high[3])
{
    uint32_t bit = (uint32_t)1 << (b->m.solids - 1);
    for (int x = low[0]; x < high[0]; x++)
        for (int y = low[1]; y < high[1]; y++)
            for (int z = low[2]; z < high[2]; z++)
                b->filled[x][y][z] |= bit;
}

static void add_block(blocks *b, const int low[3], const int high[3], bool cut)
{
    uint32_t first = (uint32_t)b->m.mesh.vertex_count;
    double size[3], middle[3];
    for (int k = 0; k < 3; k++) {
        b->low[b->m.solids][k] = low[k];
        b->high[b->m.solids][k] = high[k];
        size[k] = 0.5 * (high[k] - low[k]);
        middle[k] = 0.5 * (high[k] + low[k]);
    }
    model_add(&b->m, &shapes[cut ? SHAPE_CUT : SHAPE_CUBE], mat3_scale(size[0], size[1], size[2]),
              (roberts_vec3){middle[0], middle[1], middle[2]});
    for (int i = 0; i < 8; i++)
        b->corner[first + (uint32_t)i] = b->m.mesh.vertex[first + (uint32_t)i];
    fill_cells(b, low, high);
}

/* An L-shaped prism along `axis`: the box from low to high, without the quarter beyond `notch`. The body is not convex,
 * nor are two of its faces. */
static void add_angle(blocks *b, const int low[3], const int high[3], const int notch[3], int axis)
{
    int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const int ring[6][2] = {{low[next], low[last]},     {high[next], low[last]},   {high[next], notch[last]},
                            {notch[next], notch[last]}, {notch[next], high[last]}, {low[next], high[last]}};
    uint32_t first = (uint32_t)b->m.mesh.vertex_count;
    for (uint32_t i = 0; i < 12; i++) {
        double p[3];
        p[axis] = i < 6 ? low[axis] : high[axis];
        p[next] = ring[i % 6][0];
        p[last] = ring[i % 6][1];
        b->corner[first + i] = (roberts_vec3){p[0], p[1], p[2]};
        model_vertex(&b->m, b->corner[first + i]);
    }
    for (uint32_t i = 0; i < 6; i++) {
        uint32_t k = (i + 1) % 6;
        model_face(&b->m, (uint32_t[]){first + i, first + k, first + k + 6, first + i + 6}, 4);
    }
    for (uint32_t i = 0; i < 2; i++) {
        uint32_t f = first + 6 * i;
        model_face(&b->m, (uint32_t[]){f, f + 1, f + 2, f + 3, f + 4, f + 5}, 6);
    }
    model_close_solid(&b->m);
    int part[3] = {high[0], high[1], high[2]};
    part[next] = notch[next];
    fill_cells(b, low, part);
    part[next] = high[next];
    part[last] = notch[last];
    fill_cells(b, low, part);
    b->angled = true;
}

/* The bodies that fill each of the four cells about the grid edge from `at` along `axis`, in the order of their angles,
 * as bits. */
static void cells_about(const blocks *b, const int at[3], int axis, uint32_t bodies[4])
{
    int next = (axis + 1) % 3, last = (axis + 2) % 3;
    static const int step[4][2] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}};
    for (int i = 0; i < 4; i++) {
        int c[3] = {at[0], at[1], at[2]};
        c[next] += step[i][0];
        c[last] += step[i][1];
        const bool inside = c[0] >= 0 && c[0] < GRID && c[1] >= 0 && c[1] < GRID && c[2] >= 0 && c[2] < GRID;
        bodies[i] = inside ? b->filled[c[0]][c[1]][c[2]] : 0;
    }
}

/* Is a line drawn there? It is, unless nothing, all or exactly one half is filled. */
static bool is_line(const bool f[4])
{
    int n = f[0] + f[1] + f[2] + f[3];
    return n == 1 || n == 3 || (n == 2 && f[0] == f[2]);
}

/* Is there a line of any single one of the bodies? The same for all bits at once. */
static bool is_any_line(const uint32_t b[4])
{
    return (b[0] ^ b[1] ^ b[2] ^ b[3]) | (b[0] & b[2] & ~b[1] & ~b[3]) | (b[1] & b[3] & ~b[0] & ~b[2]);
}

static void fill_of(const uint32_t bodies[4], bool filled[4])
{
    for (int i = 0; i < 4; i++)
        filled[i] = bodies[i];
}

static double axis_of(roberts_vec3 p, int axis)
{
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/* The direction in which a side leaves the line, turned back to the grid. */
static roberts_vec3 side_direction(const roberts_scene *scene, const union_side *side, roberts_vec3 u, mat3 map)
{
    plane F = scene_plane(scene, side->face);
    roberts_vec3 w = vec3_cross((roberts_vec3){F.a, F.b, F.c}, u);
    w = vec3_scale(side->turned ? 1.0 : -1.0, w);
    return (roberts_vec3){vec3_dot(map.x, w), vec3_dot(map.y, w), vec3_dot(map.z, w)};
}

/* How the grid is laid into space: turned, shifted, rounded unless digits are 0. */
typedef struct layout {
    mat3 turn;
    roberts_vec3 shift;
    int digits;
} layout;

static roberts_vec3 lay(const layout *l, double x, double y, double z)
{
    model m = {0};
    model_vertex(&m, (roberts_vec3){x, y, z});
    model_map(&m, l->turn, l->shift);
    if (l->digits > 0)
        model_to_digits(&m, l->digits);
    roberts_vec3 p = m.mesh.vertex[0];
    model_free(&m);
    return p;
}

typedef uint8_t grid_edges[3][GRID + 1][GRID + 1][GRID + 1];

typedef struct line_check {
    const char *name;
    const blocks *b;
    const roberts_scene *scene;
    const union_bodies *all;
    union_work *work;
    const layout *laid;
    double slack; /* of places of cuts */
} line_check;

/* Sides are where the four cells change from filled to not. */
static bool sides_fit(const line_check *check, const union_piece *piece, roberts_vec3 u, const bool f[4], int axis)
{
    int changes = 0;
    for (int i = 0; i < 4; i++) {
        int next = (axis + 1) % 3, last = (axis + 2) % 3;
        if (f[i] == f[(i + 1) % 4])
            continue;
        bool found = false; /* between cell i and the next one lies the direction last, -next, -last, next */
        for (uint32_t s = 0; s < piece->count; s++) {
            roberts_vec3 d = side_direction(check->scene, &check->work->side[piece->first + s], u, check->laid->turn);
            found = found || fabs(axis_of(d, i % 2 == 0 ? last : next) - (i == 0 || i == 3 ? 1.0 : -1.0)) < 1e-3;
        }
        changes++;
        if (!found)
            return false;
    }
    return changes == (int)piece->count;
}

/* Cuts a line that goes from A to B in the grid, and counts what is drawn. */
static void check_line(line_check *check, const union_line *line, roberts_vec3 A, roberts_vec3 B, grid_edges drawn)
{
    union_work *work = check->work;
    roberts_vec3 u = vec3_scale(1.0 / vec3_length(vec3_sub(line->B, line->A)), vec3_sub(line->B, line->A));
    int axis = A.x != B.x ? 0 : A.y != B.y ? 1 : 2;
    bool straight = (A.x != B.x) + (A.y != B.y) + (A.z != B.z) == 1;
    double length = axis_of(B, axis) - axis_of(A, axis);
    assert_true(union_cut(check->all, line, work));
    for (size_t i = 0; i < work->piece_count; i++) {
        const union_piece *p = &work->piece[i];
        assert_true(p->t0 < p->t1 && p->t0 == (i == 0 ? 0.0 : work->piece[i - 1].t1));
        if (!straight) {
            assert_true(p->state != UNION_DRAWN);
            continue;
        }
        double from = axis_of(A, axis) + p->t0 * length, to = axis_of(A, axis) + p->t1 * length;
        if (!(fabs(from - rint(from)) < check->slack && fabs(to - rint(to)) < check->slack))
            fail_msg("%s: a line is cut at %.9g, %.9g", check->name, from, to);
        int low = (int)rint(lesser(from, to)), high = (int)rint(greater(from, to));
        for (int t = low; t < high; t++) {
            int at[3] = {(int)A.x, (int)A.y, (int)A.z};
            uint32_t bodies[4];
            bool f[4];
            at[axis] = t;
            cells_about(check->b, at, axis, bodies);
            fill_of(bodies, f);
            if (p->state == UNION_ALONE || p->state == UNION_DRAWN)
                drawn[axis][at[0]][at[1]][at[2]]++;
            if (p->state == UNION_DRAWN && !sides_fit(check, p, u, f, axis))
                fail_msg("%s: wrong sides at %d %d %d", check->name, at[0], at[1], at[2]);
        }
    }
    assert_true(work->piece[work->piece_count - 1].t1 == 1.0);
}

static void check_edge(line_check *check, uint32_t s, uint32_t e, grid_edges drawn)
{
    const roberts_scene *scene = check->scene;
    scene_edge edge = scene_edge_at(scene, s, e);
    uint32_t own[2];
    union_line line = union_line_of_edge(scene, s, e, own);
    check_line(check, &line, check->b->corner[scene_vertex_number(scene, edge.v[0])],
               check->b->corner[scene_vertex_number(scene, edge.v[1])], drawn);
}

/* The lines along `axis` in which a face of block i, across the next axis, crosses one of block k, across the last. */
static void check_crossings(line_check *check, int i, int k, int axis, grid_edges crossed)
{
    const blocks *b = check->b;
    int next = (axis + 1) % 3, last = (axis + 2) % 3, p[2][3];
    p[0][axis] = b->low[i][axis] > b->low[k][axis] ? b->low[i][axis] : b->low[k][axis];
    p[1][axis] = b->high[i][axis] < b->high[k][axis] ? b->high[i][axis] : b->high[k][axis];
    for (int side = 0; side < 4; side++) {
        p[0][next] = p[1][next] = side & 1 ? b->high[i][next] : b->low[i][next];
        p[0][last] = p[1][last] = side & 2 ? b->high[k][last] : b->low[k][last];
        if (p[0][axis] >= p[1][axis] || p[0][next] <= b->low[k][next] || p[0][next] >= b->high[k][next] ||
            p[0][last] <= b->low[i][last] || p[0][last] >= b->high[i][last])
            continue;
        union_line line = {.A = lay(check->laid, p[0][0], p[0][1], p[0][2]),
                           .B = lay(check->laid, p[1][0], p[1][1], p[1][2]),
                           .body = ROBERTS_NONE,
                           .crossed = {(uint32_t)i, (uint32_t)k}};
        check_line(check, &line, (roberts_vec3){p[0][0], p[0][1], p[0][2]}, (roberts_vec3){p[1][0], p[1][1], p[1][2]},
                   crossed);
    }
}

/* Each line of the union is an edge, drawn once, or one in which two faces cross. Nothing else is drawn. */
static void check_grid(const line_check *check, grid_edges drawn, grid_edges crossed)
{
    for (int axis = 0; axis < 3; axis++)
        for (int x = 0; x <= GRID; x++)
            for (int y = 0; y <= GRID; y++)
                for (int z = 0; z <= GRID; z++) {
                    uint32_t bodies[4];
                    bool f[4];
                    cells_about(check->b, (int[]){x, y, z}, axis, bodies);
                    fill_of(bodies, f);
                    const bool edge = is_any_line(bodies);
                    int edges = drawn[axis][x][y][z], crossings = crossed[axis][x][y][z];
                    bool line = is_line(f), crossing = line && !edge && !check->b->angled;
                    if (edges != (line && edge) || (crossings > 0) != crossing)
                        fail_msg("%s: at %d %d %d along %c %d edges and %d crossings are drawn", check->name, x, y, z,
                                 "xyz"[axis], edges, crossings);
                }
}

static void check_blocks(const blocks *b, const layout *laid, double touch, double slack, const char *name)
{
    static grid_edges drawn, crossed;
    roberts_scene *scene = NULL;
    roberts_error error;
    union_bodies all;
    union_work work = {0};
    memset(drawn, 0, sizeof drawn);
    memset(crossed, 0, sizeof crossed);
    if (roberts_scene_build(&b->m.mesh, NULL, &scene, &error) != ROBERTS_OK)
        fail_msg("%s: %s", name, error.message);
    double least = 1e-11 * vec3_length(vec3_sub(scene->box_max, scene->box_min));
    assert_true(union_prepare(&all, scene, scene, greater(touch, least)));
    line_check check = {name, b, scene, &all, &work, laid, slack};
    for (uint32_t s = 0; s < scene->solid_count; s++)
        for (uint32_t e = scene->solid[s].edge; e < scene->solid[s + 1].edge; e++)
            check_edge(&check, s, e, drawn);
    for (int i = 0; i < (int)b->m.solids; i++)
        for (int k = 0; k < (int)b->m.solids; k++)
            for (int axis = 0; i != k && !b->angled && axis < 3; axis++)
                check_crossings(&check, i, k, axis, crossed);
    check_grid(&check, drawn, crossed);
    union_work_free(&work);
    union_free(&all);
    roberts_scene_free(scene);
}

/* As it is; turned; turned and rounded to six digits. */
static void check_all_ways(blocks *b, rng *r, const char *name)
{
    layout l = {mat3_scale(1, 1, 1), {0, 0, 0}, 0};
    check_blocks(b, &l, 0.0, 1e-9, name);
    l = (layout){mat3_turn(r), {rng_between(r, -9, 9), rng_between(r, -9, 9), rng_between(r, -9, 9)}, 0};
    model_map(&b->m, l.turn, l.shift);
    check_blocks(b, &l, 0.0, 1e-9, name);
    l.digits = 6;
    model_to_digits(&b->m, l.digits);
    check_blocks(b, &l, 4e-6, 1e-4, name);
    model_free(&b->m);
}

static const struct {
    const char *name;
    int count, block[6][6]; /* low, high */
} bodies[] = {
    {"one block", 1, {{1, 1, 1, 3, 4, 5}}},
    {"two blocks side by side", 2, {{0, 0, 0, 2, 2, 2}, {2, 0, 0, 4, 2, 2}}},
    {"three bricks in a row", 3, {{0, 0, 0, 2, 1, 1}, {2, 0, 0, 4, 1, 1}, {4, 0, 0, 6, 1, 1}}},
    {"four bricks that meet in an edge",
     4,
     {{0, 0, 0, 2, 2, 1}, {2, 0, 0, 4, 2, 1}, {0, 2, 0, 2, 4, 1}, {2, 2, 0, 4, 4, 1}}},
    {"two opposite blocks about an edge", 2, {{0, 0, 0, 2, 2, 2}, {2, 2, 0, 4, 4, 2}}},
    {"... shifted along it", 2, {{0, 0, 0, 2, 2, 4}, {2, 2, 1, 4, 4, 6}}},
    {"three of four blocks about an edge", 3, {{0, 0, 0, 2, 2, 2}, {2, 2, 0, 4, 4, 2}, {2, 0, 0, 4, 2, 2}}},
    {"blocks that share a vertex", 2, {{0, 0, 0, 2, 2, 2}, {2, 2, 2, 4, 4, 4}}},
    {"blocks that share a part of an edge's face", 2, {{0, 0, 0, 3, 3, 3}, {1, 3, 1, 2, 5, 6}}},
    {"L of two", 2, {{0, 0, 0, 4, 1, 1}, {0, 1, 0, 1, 4, 1}}},
    {"L, of unequal width", 2, {{0, 0, 0, 4, 2, 2}, {0, 2, 0, 2, 4, 1}}},
    {"T", 2, {{0, 0, 0, 6, 1, 1}, {2, 1, 0, 4, 4, 1}}},
    {"U", 3, {{0, 0, 0, 6, 1, 2}, {0, 1, 0, 1, 4, 2}, {5, 1, 0, 6, 4, 2}}},
    {"cross, its beams through one another", 2, {{0, 2, 0, 6, 4, 2}, {2, 0, 0, 4, 6, 2}}},
    {"cross, the beams of unequal height", 2, {{0, 2, 1, 6, 4, 2}, {2, 0, 0, 4, 6, 3}}},
    {"cross of three beams", 3, {{0, 2, 2, 6, 4, 4}, {2, 0, 2, 4, 6, 4}, {2, 2, 0, 4, 4, 6}}},
    {"staircase", 4, {{0, 0, 0, 1, 3, 1}, {1, 0, 0, 2, 3, 2}, {2, 0, 0, 3, 3, 3}, {3, 0, 0, 4, 3, 4}}},
    {"staircase of slabs", 3, {{0, 0, 0, 6, 3, 1}, {2, 0, 1, 6, 3, 2}, {4, 0, 2, 6, 3, 3}}},
    {"leg on a slab", 2, {{0, 0, 0, 6, 6, 1}, {2, 2, 1, 4, 4, 5}}},
    {"leg at the corner of a slab", 2, {{0, 0, 0, 6, 6, 1}, {0, 0, 1, 2, 2, 5}}},
    {"table", 5, {{0, 0, 4, 6, 6, 5}, {0, 0, 0, 1, 1, 4}, {5, 0, 0, 6, 1, 4}, {0, 5, 0, 1, 6, 4}, {5, 5, 0, 6, 6, 4}}},
    {"nested", 2, {{0, 0, 0, 6, 6, 6}, {2, 2, 2, 4, 4, 4}}},
    {"nested, with one face in common", 2, {{0, 0, 0, 6, 6, 6}, {0, 2, 2, 4, 4, 4}}},
    {"nested, with an edge in common", 2, {{0, 0, 0, 6, 6, 6}, {0, 0, 2, 4, 4, 4}}},
    {"the same block twice", 2, {{0, 0, 0, 2, 3, 4}, {0, 0, 0, 2, 3, 4}}},
    {"a corner in a corner", 2, {{0, 0, 0, 4, 4, 4}, {2, 2, 2, 6, 6, 6}}},
    {"through and out on both sides", 2, {{0, 2, 2, 6, 4, 4}, {2, 0, 0, 4, 6, 6}}},
    {"a brick on two", 3, {{0, 0, 0, 2, 1, 1}, {2, 0, 0, 4, 1, 1}, {1, 0, 1, 3, 1, 2}}},
};

static void test_bodies(void **state)
{
    (void)state;
    rng r = {17};
    for (size_t i = 0; i < sizeof bodies / sizeof *bodies; i++)
        for (int cut = 0; cut < 2; cut++)
            for (int back = 0; back < 2; back++) {
                blocks b = {0};
                for (int k = 0; k < bodies[i].count; k++) {
                    const int *block = bodies[i].block[back ? bodies[i].count - 1 - k : k];
                    add_block(&b, block, block + 3, cut && k % 2 == 0);
                }
                check_all_ways(&b, &r, bodies[i].name);
            }
}

static void test_random_blocks(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 2000; seed++) {
        rng r = {seed};
        blocks b = {0};
        char name[64];
        int count = rng_int(&r, 2, 9), room = rng_int(&r, 2, GRID);
        snprintf(name, sizeof name, "random blocks %d", (int)seed);
        for (int i = 0; i < count; i++) {
            int low[3], high[3], notch[3];
            bool wide = true;
            for (int k = 0; k < 3; k++) {
                low[k] = rng_int(&r, 0, room - 1);
                high[k] = rng_int(&r, low[k] + 1, low[k] + 4 < room ? low[k] + 4 : room);
                wide = wide && high[k] > low[k] + 1;
                notch[k] = wide ? rng_int(&r, low[k] + 1, high[k] - 1) : 0;
            }
            if (wide && seed % 2 == 1)
                add_angle(&b, low, high, notch, rng_int(&r, 0, 2));
            else
                add_block(&b, low, high, rng_int(&r, 0, 3) == 0);
        }
        check_all_ways(&b, &r, name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_bodies), cmocka_unit_test(test_random_blocks)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
