/* test_union_drawing.c - bodies drawn as one give the drawing of the same body modelled as one.
 *
 * Blocks fill cells of a grid. The same cells make one body: a square for each place where a cell that is filled meets
 * one that is not. Both are drawn, and each visible line of one must lie on visible lines of the other with the same
 * class. The same with sheets, which meet both alike. */
#include <stdio.h>

#include "roberts.h"
#include "scenes.h"
#include "star_prism.h"

enum { CELLS = 12 };

typedef struct cells {
    bool filled[CELLS][CELLS][CELLS];
    const model *sheets; /* that meet the body; NULL: there are none */
} cells;

static bool is_filled(const cells *c, int x, int y, int z)
{
    return x >= 0 && y >= 0 && z >= 0 && x < CELLS && y < CELLS && z < CELLS && c->filled[x][y][z];
}

static void put_block(model *m, cells *c, const int block[6])
{
    model_box(m, (roberts_vec3){block[0], block[1], block[2]}, (roberts_vec3){block[3], block[4], block[5]});
    for (int x = block[0]; x < block[3]; x++)
        for (int y = block[1]; y < block[4]; y++)
            for (int z = block[2]; z < block[5]; z++)
                c->filled[x][y][z] = true;
}

/* Is cell p filled, and its neighbour on that side of it not? */
static bool is_bare(const cells *c, const int p[3], int axis, int side)
{
    int beyond[3] = {p[0], p[1], p[2]};
    beyond[axis] += side ? 1 : -1;
    return is_filled(c, p[0], p[1], p[2]) && !is_filled(c, beyond[0], beyond[1], beyond[2]);
}

/* The surface of the cells; vertices are shared. With `r`, some squares that follow one another are one rectangle, and
 * corners of others lie in the middle of its sides. */
static void put_surface(model *m, const cells *c, rng *r)
{
    static uint32_t number[CELLS + 1][CELLS + 1][CELLS + 1];
    static bool done[CELLS + 1][CELLS + 1][CELLS + 1][6];
    memset(number, 0, sizeof number);
    memset(done, 0, sizeof done);
    for (int i = 0; i < 6 * CELLS * CELLS * CELLS; i++) {
        int side = i % 2, axis = i / 2 % 3, next = (axis + 1) % 3, last = (axis + 2) % 3;
        int from[3] = {i / 6 / CELLS / CELLS, i / 6 / CELLS % CELLS, i / 6 % CELLS}, to[3];
        uint32_t corner[4];
        if (!is_bare(c, from, axis, side) || done[from[0]][from[1]][from[2]][i % 6])
            continue;
        memcpy(to, from, sizeof to);
        do {
            done[to[0]][to[1]][to[2]][i % 6] = true;
            to[next]++;
        } while (r && is_bare(c, to, axis, side) && !done[to[0]][to[1]][to[2]][i % 6] && rng_int(r, 0, 1));
        for (int k = 0; k < 4; k++) {
            bool forth = side ? (k == 1 || k == 2) : (k == 2 || k == 3), up = side ? k >= 2 : (k == 1 || k == 2);
            int p[3] = {from[0], from[1], from[2]};
            p[axis] += side;
            p[next] = forth ? to[next] : from[next];
            p[last] += up;
            uint32_t *n = &number[p[0]][p[1]][p[2]];
            if (*n == 0) {
                model_vertex(m, (roberts_vec3){p[0], p[1], p[2]});
                *n = (uint32_t)m->mesh.vertex_count;
            }
            corner[k] = *n - 1;
        }
        model_face(m, corner, 4);
    }
}

/* Is there an edge about which two opposite cells are filled? The body that is modelled as one falls apart there: each
 * half has that edge, in a class of its own. */
static bool is_pinched(const cells *c)
{
    for (int i = 0; i < 3 * (CELLS + 1) * (CELLS + 1) * (CELLS + 1); i++) {
        int n = CELLS + 1, axis = i % 3, p[3] = {i / 3 % n, i / 3 / n % n, i / 3 / n / n};
        bool f[2][2];
        for (int k = 0; k < 4; k++) {
            int q[3] = {p[0], p[1], p[2]};
            q[(axis + 1) % 3] -= k & 1;
            q[(axis + 2) % 3] -= k >> 1;
            f[k & 1][k >> 1] = is_filled(c, q[0], q[1], q[2]);
        }
        if (f[0][0] == f[1][1] && f[0][1] == f[1][0] && f[0][0] != f[0][1])
            return true;
    }
    return false;
}

/* ---- drawings that are alike ----------------------------------------------------------------------------------- */

typedef struct part {
    double from, to;
} part;

static int compare_parts(const void *a, const void *b)
{
    const part *p = a, *q = b;
    return (p->from > q->from) - (p->from < q->from);
}

typedef struct likeness {
    double slack;  /* lines nearer than this lie on one another */
    bool in_class; /* ... if they are of one class */
} likeness;

/* With the lines along which the near plane cuts bodies. */
static size_t segments_of(const roberts_drawing *d)
{
    return d->count + d->cut_count;
}

/* How much of a segment no visible segment like it in `other` covers. */
static double uncovered(const roberts_segment *s, const roberts_drawing *other, const likeness *how, part *found)
{
    double x = s->p1.x - s->p0.x, y = s->p1.y - s->p0.y, length = hypot(x, y), at = 0.0, bare = 0.0;
    double slack = how->slack;
    size_t count = 0;
    for (size_t i = 0; i < segments_of(other); i++) {
        const roberts_segment *o = &other->segment[i];
        double ax = o->p0.x - s->p0.x, ay = o->p0.y - s->p0.y, bx = o->p1.x - s->p0.x, by = o->p1.y - s->p0.y;
        if (o->state != ROBERTS_VISIBLE || (how->in_class && o->line != s->line) ||
            fabs(x * ay - y * ax) > slack * length || fabs(x * by - y * bx) > slack * length)
            continue;
        double a = (x * ax + y * ay) / length, b = (x * bx + y * by) / length;
        found[count++] = (part){a < b ? a : b, a < b ? b : a};
    }
    qsort(found, count, sizeof *found, compare_parts);
    for (size_t i = 0; i < count && at < length; i++) {
        if (found[i].from > at + slack)
            bare += (found[i].from < length ? found[i].from : length) - at;
        at = found[i].to > at ? found[i].to : at;
    }
    return bare + (at + slack < length ? length - at : 0.0);
}

static void check_covered(const roberts_drawing *of, const roberts_drawing *by, const likeness *how, const char *name)
{
    double slack = how->slack;
    part *found = malloc((segments_of(by) + 1) * sizeof *found);
    assert_non_null(found);
    for (size_t i = 0; i < segments_of(of); i++) {
        const roberts_segment *s = &of->segment[i];
        double length = hypot(s->p1.x - s->p0.x, s->p1.y - s->p0.y);
        if (s->state != ROBERTS_VISIBLE || length < 4 * slack)
            continue;
        double bare = uncovered(s, by, how, found);
        if (bare > 2 * slack)
            fail_msg("%s: %g of solid %u, %u-%u, class %d, from %.9g,%.9g to %.9g,%.9g (t %.9g to %.9g) is not there",
                     name, bare, s->solid, s->v0, s->v1, s->line, s->p0.x, s->p0.y, s->p1.x, s->p1.y, s->t0, s->t1);
    }
    free(found);
}

static roberts_drawing draw_lines(const roberts_mesh *mesh, const roberts_camera *camera, double epsilon, bool unite,
                                  bool hidden)
{
    roberts_scene *scene = NULL;
    roberts_drawing drawing = {0};
    roberts_error error = {0};
    roberts_hide_options options = roberts_hide_options_default();
    options.epsilon = epsilon;
    options.unite = unite;
    options.keep_hidden = hidden;
    if (roberts_scene_build(mesh, NULL, &scene, &error) != ROBERTS_OK ||
        roberts_hide(scene, camera, &options, &drawing, &error) != ROBERTS_OK)
        fail_msg("%s", error.message);
    roberts_scene_free(scene);
    return drawing;
}

static roberts_drawing draw_mesh(const roberts_mesh *mesh, const roberts_camera *camera, double epsilon, bool unite)
{
    return draw_lines(mesh, camera, epsilon, unite, false);
}

static roberts_drawing draw(const model *m, const roberts_camera *camera, double epsilon, bool unite)
{
    return draw_mesh(&m->mesh, camera, epsilon, unite);
}

/* Blocks and the same body modelled as one. */
typedef struct both {
    const model *blocks, *one;
    double epsilon;
    bool pinched, sheets;
} both;

/* Hidden lines count as visible ones. Without sheets, they may differ: some coincide in the picture. */
static roberts_drawing draw_both(const both *b, const model *m, const roberts_camera *camera, bool unite, bool hidden)
{
    roberts_drawing drawing = draw_lines(&m->mesh, camera, b->epsilon, unite, hidden);
    for (size_t i = 0; i < segments_of(&drawing); i++)
        if (drawing.segment[i].state == ROBERTS_HIDDEN)
            drawing.segment[i].state = ROBERTS_VISIBLE;
    return drawing;
}

/* The near plane cuts a sheet inside a body: the cut is left out of any union, even if the body is one. */
static void check_alike_with(const both *b, const roberts_camera *camera, bool hidden, const char *name)
{
    char text[160];
    roberts_drawing united = draw_both(b, b->blocks, camera, true, hidden);
    roberts_drawing one = draw_both(b, b->one, camera, b->sheets, hidden);
    likeness how = {b->epsilon > 0.0 ? 8 * b->epsilon : 1e-8, !b->pinched && !hidden};
    snprintf(text, sizeof text, "%s, too many lines", name);
    check_covered(&united, &one, &how, text);
    snprintf(text, sizeof text, "%s, too few lines", name);
    check_covered(&one, &united, &how, text);
    roberts_drawing_free(&united);
    roberts_drawing_free(&one);
}

static void check_alike(const both *b, const roberts_camera *camera, const char *name)
{
    check_alike_with(b, camera, false, name);
    if (b->sheets)
        check_alike_with(b, camera, true, name);
}

/* Directions from the scene to the viewer: askew and along axes. */
static const roberts_vec3 directions[] = {{1, -1, 1}, {2, -3, 1.5}, {0, 0, 1},   {0, -1, 0},
                                          {-1, 0, 0}, {1, -1, 0},   {-2, 1, -3}, {0.37, -0.71, 0.53}};

enum { DIRECTIONS = sizeof directions / sizeof *directions, VIEWS = 2 * DIRECTIONS + 2 };

/* View `i` of VIEWS: the directions, the same turned with the body, and two in perspective; in the last the near
 * plane goes through the middle of the body. */
static void check_view(const both *b, mat3 turn, int i, const char *name)
{
    roberts_camera camera = {.dir = directions[i % DIRECTIONS]};
    char text[120];
    if (i >= DIRECTIONS)
        camera.dir = mat3_map(turn, camera.dir);
    if (i >= VIEWS - 2)
        camera = (roberts_camera){.projection = ROBERTS_PERSPECTIVE, .eye = {40, -50, 45}};
    if (i == VIEWS - 1) {
        const roberts_mesh *mesh = &b->blocks->mesh;
        for (size_t k = 0; k < mesh->vertex_count; k++)
            camera.look_at = vec3_add(camera.look_at, vec3_scale(1.0 / (double)mesh->vertex_count, mesh->vertex[k]));
        camera.has_look_at = true;
        camera.near_distance = vec3_length(vec3_sub(camera.eye, camera.look_at)) + 0.05;
    }
    snprintf(text, sizeof text, "%s, view %d from %g,%g,%g", name, i, camera.dir.x, camera.dir.y, camera.dir.z);
    check_alike(b, &camera, text);
}

enum { AS_IT_IS, TURNED, TURNED_TO_SIX_DIGITS, LAYOUTS };

#define ALL_VIEWS (-1)

static void put_model(model *to, const model *m)
{
    const roberts_mesh *mesh = &m->mesh;
    const uint32_t first = (uint32_t)to->mesh.vertex_count;
    uint32_t corner[16];
    for (size_t v = 0; v < mesh->vertex_count; v++)
        model_vertex(to, mesh->vertex[v]);
    for (size_t f = 0; f < mesh->face_count; f++) {
        const size_t from = mesh->face_start[f], count = mesh->face_start[f + 1] - from;
        for (size_t k = 0; k < count; k++)
            corner[k] = first + mesh->corner[from + k];
        model_face(to, corner, count);
    }
    model_close_solid(to);
}

/* One body, laid out in one way, in one view or, if that is ALL_VIEWS, in all. */
static void check_layout(const model *blocks, const cells *c, uint64_t seed, int layout, int only, const char *name)
{
    model one = {0}, many;
    rng r = {seed};
    mat3 turn = layout == AS_IT_IS ? mat3_scale(1, 1, 1) : mat3_turn(&r);
    both b = {&many, &one, layout == TURNED_TO_SIX_DIGITS ? 1e-5 : 0.0, is_pinched(c), c->sheets != NULL};
    roberts_vec3 shift = {rng_between(&r, -9, 9), rng_between(&r, -9, 9), rng_between(&r, -9, 9)};
    model_copy(&many, blocks);
    put_surface(&one, c, NULL);
    if (c->sheets) {
        put_model(&many, c->sheets);
        put_model(&one, c->sheets);
    }
    if (layout != AS_IT_IS) {
        model_map(&many, turn, shift);
        model_map(&one, turn, shift);
    }
    if (layout == TURNED_TO_SIX_DIGITS) {
        model_to_digits(&many, 6);
        model_to_digits(&one, 6);
    }
    for (int i = 0; i < VIEWS; i++)
        if (only == ALL_VIEWS || only == i)
            check_view(&b, turn, i, name);
    model_free(&many);
    model_free(&one);
}

/* As it is; turned; turned and rounded to six digits. */
static void check_body(const model *blocks, const cells *c, uint64_t seed, const char *name)
{
    for (int layout = 0; layout < LAYOUTS; layout++)
        check_layout(blocks, c, seed, layout, ALL_VIEWS, name);
}

/* ---- bodies ---------------------------------------------------------------------------------------------------- */

static const struct {
    const char *name;
    int count, block[6][6]; /* low, high */
} bodies[] = {
    {"block of two", 2, {{0, 0, 0, 2, 2, 2}, {2, 0, 0, 5, 2, 2}}},
    {"L", 2, {{0, 0, 0, 4, 1, 2}, {0, 1, 0, 1, 4, 2}}},
    {"T", 2, {{0, 0, 0, 6, 1, 2}, {2, 1, 0, 4, 5, 2}}},
    {"U", 3, {{0, 0, 0, 6, 1, 2}, {0, 1, 0, 1, 4, 2}, {5, 1, 0, 6, 4, 2}}},
    {"cross", 3, {{0, 2, 0, 6, 4, 2}, {2, 0, 0, 4, 2, 2}, {2, 4, 0, 4, 6, 2}}},
    {"staircase", 4, {{0, 0, 0, 1, 3, 1}, {1, 0, 0, 2, 3, 2}, {2, 0, 0, 3, 3, 3}, {3, 0, 0, 4, 3, 4}}},
    {"staircase of slabs", 3, {{0, 0, 0, 6, 3, 1}, {2, 0, 1, 6, 3, 2}, {4, 0, 2, 6, 3, 3}}},
    {"table", 5, {{0, 0, 4, 6, 6, 5}, {1, 1, 0, 2, 2, 4}, {4, 1, 0, 5, 2, 4}, {1, 4, 0, 2, 5, 4}, {4, 4, 0, 5, 5, 4}}},
    {"table with flush legs",
     5,
     {{0, 0, 4, 6, 6, 5}, {0, 0, 0, 1, 1, 4}, {5, 0, 0, 6, 1, 4}, {0, 5, 0, 1, 6, 4}, {5, 5, 0, 6, 6, 4}}},
    {"leg on a slab", 2, {{0, 0, 0, 6, 6, 1}, {2, 2, 1, 4, 4, 5}}},
    {"opposite blocks about an edge", 2, {{0, 0, 0, 2, 2, 4}, {2, 2, 1, 4, 4, 6}}},
    {"blocks that share a vertex", 2, {{0, 0, 0, 2, 2, 2}, {2, 2, 2, 4, 4, 4}}},
    {"nested", 2, {{0, 0, 0, 6, 6, 6}, {0, 2, 2, 4, 4, 4}}},
};

static void test_bodies(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof bodies / sizeof *bodies; i++) {
        model m = {0};
        cells c = {0};
        for (int k = 0; k < bodies[i].count; k++)
            put_block(&m, &c, bodies[i].block[k]);
        check_body(&m, &c, i, bodies[i].name);
        model_free(&m);
    }
}

/* Rows of bricks, every other one shifted by half a brick, with half bricks at both ends. */
static void test_wall(void **state)
{
    (void)state;
    model m = {0};
    cells c = {0};
    for (int row = 0; row < 8; row++)
        for (int x = -(row % 2); x < 12; x += 2)
            put_block(&m, &c, (int[]){x < 0 ? 0 : x, 0, row, x + 2 > 12 ? 12 : x + 2, 2, row + 1});
    check_body(&m, &c, 8, "wall");
    model_free(&m);
}

static void test_menger_sponge(void **state)
{
    (void)state;
    model m = {0};
    cells c = {0};
    for (int i = 0; i < 9 * 9 * 9; i++) {
        int p[3] = {i % 9, i / 9 % 9, i / 81};
        bool kept = true;
        for (int size = 1; size < 9; size *= 3)
            kept = kept && (p[0] / size % 3 == 1) + (p[1] / size % 3 == 1) + (p[2] / size % 3 == 1) < 2;
        if (kept)
            put_block(&m, &c, (int[]){p[0], p[1], p[2], p[0] + 1, p[1] + 1, p[2] + 1});
    }
    assert_int_equal(m.solids, 400);
    check_body(&m, &c, 81, "Menger sponge");
    model_free(&m);
}

/* Cells filled at random, in blocks of one to three along a random axis: they touch in every way. */
static void test_random_cells(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 600; seed++) {
        model m = {0};
        cells c = {0};
        rng r = {seed};
        char name[40];
        int room = rng_int(&r, 2, 4), axis = rng_int(&r, 0, 2), percent = rng_int(&r, 20, 80);
        snprintf(name, sizeof name, "random cells %d", (int)seed);
        for (int i = 0; i < room * room * room; i++) {
            int p[3] = {i % room, i / room % room, i / (room * room)}, block[6];
            if (is_filled(&c, p[0], p[1], p[2]) || rng_int(&r, 0, 99) >= percent)
                continue;
            memcpy(block, p, sizeof p);
            for (int k = 0; k < 3; k++)
                block[3 + k] = p[k] + 1;
            int length = rng_int(&r, 1, 3);
            while (block[3 + axis] < room && block[3 + axis] - p[axis] < length) {
                int next[3] = {p[0], p[1], p[2]};
                next[axis] = block[3 + axis];
                if (is_filled(&c, next[0], next[1], next[2]))
                    break;
                block[3 + axis]++;
            }
            put_block(&m, &c, block);
        }
        if (m.solids > 0)
            check_layout(&m, &c, seed, (int)(seed % LAYOUTS), (int)(seed / LAYOUTS) % VIEWS, name);
        model_free(&m);
    }
}

/* Cells filled at random, each for one of two surfaces. These touch one another, and each also touches itself: edges
 * have four faces. In some scenes, vertices lie on edges. */
static void test_touching_surfaces(void **state)
{
    (void)state;
    int pinched = 0;
    for (uint64_t seed = 0; seed < 300; seed++) {
        model m = {0};
        cells half[2] = {0}, c = {0};
        rng r = {seed};
        char name[40];
        int room = rng_int(&r, 2, 4), percent = rng_int(&r, 20, 80);
        snprintf(name, sizeof name, "touching surfaces %d", (int)seed);
        for (int i = 0; i < room * room * room; i++) {
            int x = i % room, y = i / room % room, z = i / (room * room);
            if (rng_int(&r, 0, 99) >= percent)
                continue;
            half[2 * x > room || (2 * x == room && rng_int(&r, 0, 1))].filled[x][y][z] = true;
            c.filled[x][y][z] = true;
        }
        pinched += is_pinched(&half[0]) || is_pinched(&half[1]);
        int layout = (int)(seed % LAYOUTS);
        bool joined = seed % 2 && layout != TURNED_TO_SIX_DIGITS; /* these would move vertices away from edges */
        for (int k = 0; k < 2; k++) {
            put_surface(&m, &half[k], joined ? &r : NULL);
            model_close_solid(&m);
        }
        if (m.mesh.face_count > 0)
            check_layout(&m, &c, seed, layout, (int)(seed / LAYOUTS) % VIEWS, name);
        model_free(&m);
    }
    assert_true(pinched > 100);
}

/* No two visible lines lie on one another: seen askew, lines in one place of the picture are in one place in space. */
static void check_single(const roberts_drawing *d, double slack, const char *name)
{
    for (size_t i = 0; i < d->count; i++)
        for (size_t k = i + 1; k < d->count; k++) {
            const roberts_segment *a = &d->segment[i], *b = &d->segment[k];
            double x = a->p1.x - a->p0.x, y = a->p1.y - a->p0.y, length = hypot(x, y);
            double t0 = ((b->p0.x - a->p0.x) * x + (b->p0.y - a->p0.y) * y) / length;
            double t1 = ((b->p1.x - a->p0.x) * x + (b->p1.y - a->p0.y) * y) / length;
            double off0 = ((b->p0.x - a->p0.x) * y - (b->p0.y - a->p0.y) * x) / length;
            double off1 = ((b->p1.x - a->p0.x) * y - (b->p1.y - a->p0.y) * x) / length;
            double shared = fmin(fmax(t0, t1), length) - fmax(fmin(t0, t1), 0.0);
            if (fabs(off0) < slack && fabs(off1) < slack && shared > 4 * slack)
                fail_msg("%s: solid %u, %u-%u, and solid %u, %u-%u, lie on one another", name, a->solid, a->v0, a->v1,
                         b->solid, b->v0, b->v1);
        }
}

/* Rays find nothing wrong with the drawing, hidden lines included. */
static void check_rays(const model *m, const char *name)
{
    roberts_camera camera = {.dir = {0.37, -0.71, 0.53}};
    roberts_hide_options options = roberts_hide_options_default();
    roberts_verify_options verify = roberts_verify_options_default();
    roberts_verification found;
    options.unite = verify.unite = options.keep_hidden = true;
    roberts_scene *scene = model_build(m);
    roberts_drawing drawing = drawing_of(scene, &camera, &options);
    assert_int_equal(roberts_verify(scene, &camera, &drawing, &verify, &found, NULL), ROBERTS_OK);
    if (found.contradictions > 0 || found.points == 0)
        fail_msg("%s: %zu contradictions at %zu points", name, found.contradictions, found.points);
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
}

/* Blocks that overlap at random: their faces cross, too. */
static void test_random_blocks(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 2000; seed++) {
        model m = {0};
        cells c = {0};
        rng r = {seed};
        char name[40];
        snprintf(name, sizeof name, "random blocks %d", (int)seed);
        for (int i = rng_int(&r, 2, 7); i > 0; i--) {
            int block[6];
            for (int k = 0; k < 3; k++) {
                block[k] = rng_int(&r, 0, 4);
                block[3 + k] = block[k] + rng_int(&r, 1, 4);
            }
            put_block(&m, &c, block);
        }
        roberts_drawing d = draw(&m, &(roberts_camera){.dir = {0.37, -0.71, 0.53}}, 0.0, true);
        check_single(&d, 1e-8, name);
        if (seed % 10 == 0)
            check_rays(&m, name);
        roberts_drawing_free(&d);
        check_layout(&m, &c, seed, (int)(seed % LAYOUTS), (int)(seed / LAYOUTS) % VIEWS, name);
        model_free(&m);
    }
}

/* ---- sheets ---------------------------------------------------------------------------------------------------- */

/* Bodies that are flush, and a sheet in the plane of their seam. face: the numbers of its corners. */
static const struct {
    const char *name;
    int count, block[4][6];
    double corner[8][3];
    const char *face[2];
} sheets[] = {
    {"house and cellar, with the ground all round",
     2,
     {{0, 0, 0, 4, 3, 2}, {0, 0, 2, 4, 3, 5}},
     {{-2, -2, 2}, {6, -2, 2}, {6, 6, 2}, {-2, 6, 2}},
     {"0123", NULL}},
    {"house upon its cellar in the file",
     2,
     {{0, 0, 2, 4, 3, 5}, {0, 0, 0, 4, 3, 2}},
     {{-2, -2, 2}, {6, -2, 2}, {6, 6, 2}, {-2, 6, 2}},
     {"0123", NULL}},
    {"ground along a part of the house",
     2,
     {{0, 0, 0, 4, 3, 2}, {0, 0, 2, 4, 3, 5}},
     {{1, -2, 2}, {6, -2, 2}, {6, 6, 2}, {1, 6, 2}},
     {"0123", NULL}},
    {"ground that ends at a wall",
     2,
     {{0, 0, 0, 4, 3, 2}, {0, 0, 2, 4, 3, 5}},
     {{-2, -3, 2}, {6, -3, 2}, {6, 0, 2}, {-2, 0, 2}},
     {"0123", NULL}},
    {"ground with a hole for the house",
     2,
     {{0, 0, 0, 4, 3, 2}, {0, 0, 2, 4, 3, 5}},
     {{-2, -2, 2}, {6, -2, 2}, {6, 5, 2}, {-2, 5, 2}, {0, 0, 2}, {4, 0, 2}, {4, 3, 2}, {0, 3, 2}},
     {"0123047654", NULL}},
    {"ground in two strips that meet at a wall",
     2,
     {{0, 0, 0, 4, 3, 2}, {0, 0, 2, 4, 3, 5}},
     {{-2, -2, 2}, {6, -2, 2}, {6, 0, 2}, {-2, 0, 2}, {6, 5, 2}, {-2, 5, 2}},
     {"0123", "3245"}},
    {"sheet between house and cellar, inside",
     2,
     {{0, 0, 0, 4, 3, 2}, {0, 0, 2, 4, 3, 5}},
     {{1, 1, 2}, {3, 1, 2}, {3, 2, 2}, {1, 2, 2}},
     {"0123", NULL}},
    {"house smaller than its cellar",
     2,
     {{0, 0, 0, 4, 3, 2}, {0, 0, 2, 2, 3, 5}},
     {{-2, -2, 2}, {6, -2, 2}, {6, 6, 2}, {-2, 6, 2}},
     {"0123", NULL}},
    {"house that reaches into its cellar",
     2,
     {{0, 0, 0, 4, 3, 3}, {0, 0, 2, 4, 3, 5}},
     {{-2, -2, 3}, {6, -2, 3}, {6, 6, 3}, {-2, 6, 3}},
     {"0123", NULL}},
    {"four blocks about an edge",
     4,
     {{0, 0, 0, 2, 2, 2}, {2, 0, 0, 4, 2, 2}, {0, 0, 2, 2, 2, 4}, {2, 0, 2, 4, 2, 4}},
     {{-2, -2, 2}, {6, -2, 2}, {6, 6, 2}, {-2, 6, 2}},
     {"0123", NULL}},
    {"upright sheet between two houses",
     2,
     {{0, 0, 0, 2, 3, 3}, {2, 0, 0, 5, 3, 3}},
     {{2, -2, -1}, {2, 5, -1}, {2, 5, 5}, {2, -2, 5}},
     {"0123", NULL}},
    {"sheet aslant through a seam",
     2,
     {{0, 0, 0, 4, 3, 2}, {0, 0, 2, 4, 3, 5}},
     {{-1, -2, 0}, {5, -2, 0}, {5, 2, 4}, {-1, 2, 4}},
     {"0123", NULL}},
};

static void test_sheets(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof sheets / sizeof *sheets; i++) {
        model m = {0}, sheet = {0};
        cells c = {.sheets = &sheet};
        for (int k = 0; k < sheets[i].count; k++)
            put_block(&m, &c, sheets[i].block[k]);
        for (int k = 0; k < 8; k++)
            model_vertex(&sheet,
                         (roberts_vec3){sheets[i].corner[k][0], sheets[i].corner[k][1], sheets[i].corner[k][2]});
        for (int f = 0; f < 2 && sheets[i].face[f]; f++) {
            uint32_t corner[16], count = 0;
            for (const char *digit = sheets[i].face[f]; *digit; digit++)
                corner[count++] = (uint32_t)(*digit - '0');
            model_face(&sheet, corner, count);
        }
        check_body(&m, &c, i, sheets[i].name);
        put_model(&m, &sheet);
        roberts_drawing d = draw(&m, &(roberts_camera){.dir = {0.37, -0.71, 0.53}}, 0.0, true);
        check_single(&d, 1e-8, sheets[i].name);
        roberts_drawing_free(&d);
        check_rays(&m, sheets[i].name);
        model_free(&m);
        model_free(&sheet);
    }
}

/* A house whose walls lean inward from the ground on, on its cellar, and the ground: one body, or two. */
static void put_leaning(model *m, bool whole)
{
    static const double at[4][2] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    for (int level = 0; level < 4; level++)
        for (int i = 0; i < 4; i++)
            model_vertex(m, (roberts_vec3){level < 3 ? at[i][0] : 1 + 0.5 * at[i][0],
                                           level < 3 ? at[i][1] : 0.75 + 0.5 * at[i][1], level == 2 ? 1 : level});
    for (uint32_t body = 0; body < 2; body++) {
        const uint32_t low = 4 * body * (whole ? 1 : 2), high = low == 4 ? 12 : low + 4;
        if (!whole || body == 0)
            model_face(m, (uint32_t[]){low + 3, low + 2, low + 1, low}, 4);
        if (!whole || body == 1)
            model_face(m, (uint32_t[]){high, high + 1, high + 2, high + 3}, 4);
        for (uint32_t i = 0; i < 4; i++)
            model_face(m, (uint32_t[]){low + i, low + (i + 1) % 4, high + (i + 1) % 4, high + i}, 4);
    }
    const uint32_t first = (uint32_t)m->mesh.vertex_count;
    for (int i = 0; i < 4; i++)
        model_vertex(m, (roberts_vec3){3 * at[i][0] - 4, 3 * at[i][1] - 4, 1});
    model_face(m, (uint32_t[]){first, first + 1, first + 2, first + 3}, 4);
}

/* The walls of the house and of the cellar bend where they meet. The ground crosses them there if they count as flat;
 * otherwise it only touches the edge, which is drawn. */
static void test_leaning_walls(void **state)
{
    (void)state;
    for (int i = 0; i < 3 * DIRECTIONS; i++) {
        const roberts_camera camera = {.dir = directions[i / 3]};
        double crossed[2] = {0, 0}, all[2] = {0, 0};
        for (int whole = 0; whole < 2; whole++) {
            model m = {0};
            put_leaning(&m, whole);
            roberts_scene *scene = scene_of_mesh(&m.mesh, NULL);
            roberts_hide_options options = roberts_hide_options_default();
            options.unite = !whole;
            options.crease_auto = false;
            options.crease_degrees = i % 3 ? 40.0 : 5.0;
            options.keep_hidden = i % 3 == 2;
            roberts_drawing d = drawing_of(scene, &camera, &options);
            for (size_t k = 0; k < d.count; k++) {
                const roberts_segment *s = &d.segment[k];
                const double length = hypot(s->p1.x - s->p0.x, s->p1.y - s->p0.y);
                all[whole] += length;
                crossed[whole] += s->line == ROBERTS_INTERSECTION ? length : 0.0;
            }
            roberts_drawing_free(&d);
            roberts_scene_free(scene);
            model_free(&m);
        }
        if (fabs(all[0] - all[1]) > 1e-8 || fabs(crossed[0] - crossed[1]) > 1e-8 || (i % 3 == 0 && crossed[1] > 0.0) ||
            (i < 3 && i % 3 > 0 && !(crossed[1] > 1.0)))
            fail_msg("view %d: intersections of %g instead of %g, all lines %g instead of %g", i, crossed[0],
                     crossed[1], all[0], all[1]);
    }
}

/* A sheet from `o` to o + n u + k v: one face, or tiles. */
static void put_sheet(model *m, roberts_vec3 o, roberts_vec3 u, roberts_vec3 v, uint32_t n, uint32_t k, bool tiles)
{
    const uint32_t first = (uint32_t)m->mesh.vertex_count, columns = tiles ? n : 1, rows = tiles ? k : 1;
    for (uint32_t i = 0; i <= columns; i++)
        for (uint32_t j = 0; j <= rows; j++)
            model_vertex(m, vec3_add(o, vec3_add(vec3_scale((double)(i * n) / columns, u),
                                                 vec3_scale((double)(j * k) / rows, v))));
    for (uint32_t i = 0; i < columns; i++)
        for (uint32_t j = 0; j < rows; j++) {
            const uint32_t a = first + i * (rows + 1) + j;
            model_face(m, (uint32_t[]){a, a + rows + 1, a + rows + 2, a + 1}, 4);
        }
    model_close_solid(m);
}

/* Blocks at random, and sheets in planes of the grid, or aslant through its lines. */
static void test_random_sheets(void **state)
{
    static const roberts_vec3 along[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    (void)state;
    for (uint64_t seed = 0; seed < 500; seed++) {
        model m = {0}, sheet = {0};
        cells c = {.sheets = &sheet};
        rng r = {seed};
        char name[40];
        const int room = rng_int(&r, 2, 4);
        snprintf(name, sizeof name, "random sheets %d", (int)seed);
        for (int i = rng_int(&r, 2, 6); i > 0; i--) {
            int block[6];
            for (int k = 0; k < 3; k++) {
                block[k] = rng_int(&r, 0, room - 1);
                block[3 + k] = rng_int(&r, block[k] + 1, room);
            }
            put_block(&m, &c, block);
        }
        for (int i = rng_int(&r, 1, 2); i > 0; i--) {
            const int axis = rng_int(&r, 0, 2);
            const double slope = rng_int(&r, 0, 3) ? 0.0 : rng_int(&r, 0, 1) ? 1.0 : -1.0;
            const roberts_vec3 o = {rng_int(&r, -1, room), rng_int(&r, -1, room), rng_int(&r, -1, room)};
            const roberts_vec3 u = vec3_add(along[(axis + 1) % 3], vec3_scale(slope, along[axis]));
            const uint32_t n = (uint32_t)rng_int(&r, 1, room + 2), k = (uint32_t)rng_int(&r, 1, room + 2);
            put_sheet(&sheet, o, u, along[(axis + 2) % 3], n, k, rng_int(&r, 0, 2) == 0);
        }
        check_layout(&m, &c, seed, (int)(seed % LAYOUTS), (int)(seed / LAYOUTS) % VIEWS, name);
        model_free(&m);
        model_free(&sheet);
    }
}

/* ---- bodies that are not blocks -------------------------------------------------------------------------------- */

/* A single body is its own union, even if its faces cross and wind twice round its middle. But the sides of a pentagram
 * bound nothing where they run through its middle, if that is filled below: the last body has such faces outside. */
static void test_star_bodies(void **state)
{
    static const char *const file[] = {"great-dodecahedron",           "great-icosahedron",
                                       "great-stellated-dodecahedron", "small-stellated-dodecahedron",
                                       "tetrahemihexahedron",          "pentagrammic-crossed-antiprism"};
    (void)state;
    for (size_t i = 0; i < sizeof file / sizeof *file; i++) {
        char path[100];
        roberts_mesh mesh = {0};
        roberts_camera camera = {.dir = {0.37, -0.71, 0.53}};
        likeness how = {1e-8, false};
        snprintf(path, sizeof path, "models/star/%s.off", file[i]);
        assert_int_equal(roberts_mesh_read_file(&mesh, path, NULL, NULL), ROBERTS_OK);
        roberts_drawing alone = draw_mesh(&mesh, &camera, 0.0, false), united = draw_mesh(&mesh, &camera, 0.0, true);
        assert_true(alone.count > 0);
        if (i + 1 < sizeof file / sizeof *file)
            check_covered(&alone, &united, &how, file[i]);
        check_covered(&united, &alone, &how, file[i]);
        roberts_drawing_free(&alone);
        roberts_drawing_free(&united);
        roberts_mesh_free(&mesh);
    }
}

/* Faces of a square, two and two: a closed body that fills nothing. */
static void put_flat(model *m, roberts_vec3 a, roberts_vec3 b)
{
    const uint32_t at = (uint32_t)m->mesh.vertex_count;
    const double sign[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    static const uint32_t corner[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    for (int i = 0; i < 4; i++)
        model_vertex(m, (roberts_vec3){sign[i][0] * a.x + sign[i][1] * b.x, sign[i][0] * a.y + sign[i][1] * b.y,
                                       sign[i][0] * a.z + sign[i][1] * b.z});
    for (int i = 0; i < 4; i++)
        model_face(m, (uint32_t[]){at + corner[i][0], at + corner[i][1], at + corner[i][2]}, 3);
}

/* Bodies that fill nothing hide what is behind them, so the line in which they cross remains, and so do their edges.
 * The same beside a body whose faces wind twice, in the presence of which winding numbers decide. */
static void test_flat_bodies(void **state)
{
    (void)state;
    for (int star = 0; star < 2; star++) {
        const roberts_camera camera = {.dir = {0.37, -0.71, 0.53}};
        const likeness how = {1e-8, false};
        model m = {.mesh = {0}};
        put_flat(&m, (roberts_vec3){2, 0, 0}, (roberts_vec3){0, 2, 0});
        put_flat(&m, (roberts_vec3){0, 1, 0}, (roberts_vec3){0, 0, 1});
        if (star)
            put_star(&m, true, -20.0, -19.0, 0);
        roberts_drawing alone = draw(&m, &camera, 0.0, false), united = draw(&m, &camera, 0.0, true);
        for (size_t i = 0; i < alone.count; i++) /* only lines of the flat bodies count */
            if (alone.segment[i].solid == 2)
                alone.segment[i].state = ROBERTS_HIDDEN;
        check_covered(&alone, &united, &how, "flat bodies");
        roberts_drawing_free(&alone);
        roberts_drawing_free(&united);
        model_free(&m);
    }
}

/* ---- a body whose faces wind twice ------------------------------------------------------------------------------- */

/* Visible lengths by class: of the edges of boxes, and of the lines in which their faces cross others. The last one is
 * that of all lines. */
enum { ALL_LINES = ROBERTS_BACK_OUTLINE + 1, LENGTHS };

static void measure_boxes(const roberts_drawing *d, uint32_t boxes, double length[LENGTHS])
{
    for (int i = 0; i < LENGTHS; i++)
        length[i] = 0.0;
    for (size_t i = 0; i < d->count; i++) {
        const roberts_segment *g = &d->segment[i];
        const bool own = g->v0 != ROBERTS_NONE ? g->solid < boxes : d->crossing[g->edge].face[0] < 6 * boxes;
        const double visible = g->state == ROBERTS_VISIBLE ? hypot(g->p1.x - g->p0.x, g->p1.y - g->p0.y) : 0.0;
        length[g->line] += own ? visible : 0.0;
        length[ALL_LINES] += visible;
    }
}

/* The middle of a pentagram is filled, and so is what lies below it, whatever the winding of the faces. No line crosses
 * it. */
static void test_pentagrams(void **state)
{
    rng r = {471};
    double all = 0.0;
    (void)state;
    for (int scene = 0; scene < 60; scene++) {
        const roberts_camera camera = {.dir = {rng_between(&r, -1, 1), rng_between(&r, -1, 1), rng_between(&r, -1, 1)}};
        const uint32_t boxes = (uint32_t)rng_int(&r, 1, 2);
        const double z0 = rng_int(&r, -3, 0), z1 = rng_int(&r, 1, 4);
        const unsigned turned = scene % 3 ? 0 : (unsigned)rng_int(&r, 0, 4095);
        double length[2][LENGTHS];
        model m[2] = {{.mesh = {0}}, {.mesh = {0}}};
        for (uint32_t b = 0; b < boxes; b++) { /* no face of a box lies in one of the star */
            const roberts_vec3 at = {rng_int(&r, -5, 3) + 0.3, rng_int(&r, -5, 3) + 0.4, rng_int(&r, -5, 3) + 0.5};
            const roberts_vec3 to = {at.x + rng_int(&r, 1, 5), at.y + rng_int(&r, 1, 5), at.z + rng_int(&r, 1, 5)};
            model_box(&m[0], at, to);
            model_box(&m[1], at, to);
        }
        for (int k = 0; k < 2; k++) {
            put_star(&m[k], k == 0, z0, z1, turned);
            roberts_drawing drawing = draw(&m[k], &camera, 0.0, true);
            measure_boxes(&drawing, boxes, length[k]);
            roberts_drawing_free(&drawing);
            model_free(&m[k]);
        }
        for (int i = 0; i < LENGTHS; i++) {
            if (fabs(length[0][i] - length[1][i]) > 1e-7)
                fail_msg("scene %d, class %d: %.9g instead of %.9g", scene, i, length[0][i], length[1][i]);
            all += length[0][i];
        }
    }
    assert_true(all > 100.0);
}

/* An L whose ends are one face each, or four triangles, and a leg that stands along a cut between two of these. */
static void put_leg_on_cut(model *m, bool cut)
{
    static const double at[9][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {.2, .2}, {.8, .2}, {.8, .8}};
    static const uint32_t triangle[4][3] = {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    for (uint32_t z = 0; z < 2; z++)
        for (uint32_t i = 0; i < 6; i++)
            model_vertex(m, (roberts_vec3){at[i][0], at[i][1], z});
    for (uint32_t z = 1; z < 3; z++)
        for (uint32_t i = 6; i < 9; i++)
            model_vertex(m, (roberts_vec3){at[i][0], at[i][1], z});
    for (uint32_t k = 0; k < 4 && cut; k++) {
        const uint32_t *t = triangle[k];
        model_face(m, (uint32_t[]){t[2], t[1], t[0]}, 3);
        model_face(m, (uint32_t[]){t[0] + 6, t[1] + 6, t[2] + 6}, 3);
    }
    if (!cut) {
        model_face(m, (uint32_t[]){5, 4, 3, 2, 1, 0}, 6);
        model_face(m, (uint32_t[]){6, 7, 8, 9, 10, 11}, 6);
    }
    for (uint32_t i = 0; i < 6; i++)
        model_face(m, (uint32_t[]){i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6}, 4);
    model_face(m, (uint32_t[]){14, 13, 12}, 3);
    model_face(m, (uint32_t[]){15, 16, 17}, 3);
    for (uint32_t i = 0; i < 3; i++)
        model_face(m, (uint32_t[]){12 + i, 12 + (i + 1) % 3, 15 + (i + 1) % 3, 15 + i}, 4);
}

/* With the leg, a flat edge is a line. */
static void test_leg_on_cut(void **state)
{
    roberts_camera camera = {.dir = {-0.5, 0.31, 0.6}};
    likeness how = {1e-8, false};
    model whole = {0}, cut = {0};
    (void)state;
    put_leg_on_cut(&whole, false);
    put_leg_on_cut(&cut, true);
    roberts_drawing of = draw_mesh(&cut.mesh, &camera, 0.0, true), by = draw_mesh(&whole.mesh, &camera, 0.0, true);
    check_covered(&of, &by, &how, "cut");
    check_covered(&by, &of, &how, "whole");
    roberts_drawing_free(&of);
    roberts_drawing_free(&by);
    model_free(&whole);
    model_free(&cut);
}

/* Threads, cells and the order in which the bodies come change no line. */
static void test_same_result(void **state)
{
    (void)state;
    model m = {0};
    roberts_camera camera = {.dir = {2, -3, 1.5}};
    roberts_drawing first = {0};
    model_wall(&m, 30, 30);
    roberts_scene *scene = model_build(&m);
    for (uint32_t i = 0; i < 6; i++) {
        roberts_hide_options options = roberts_hide_options_default();
        options.unite = true;
        options.keep_hidden = true;
        options.threads = (uint32_t[]){1, 2, 3, 8, 1, 4}[i];
        options.grid = (uint32_t[]){0, 0, 0, 0, 1, 30}[i];
        roberts_drawing drawing = drawing_of(scene, &camera, &options);
        if (i == 0) {
            first = drawing;
            continue;
        }
        assert_int_equal(drawing.count, first.count);
        for (size_t k = 0; k < first.count; k++) {
            const roberts_segment *a = &first.segment[k], *b = &drawing.segment[k];
            assert_true(a->solid == b->solid && a->v0 == b->v0 && a->v1 == b->v1 && a->by == b->by && a->t0 == b->t0 &&
                        a->t1 == b->t1 && a->state == b->state && a->line == b->line);
        }
        roberts_drawing_free(&drawing);
    }
    roberts_drawing_free(&first);
    roberts_scene_free(scene);
    model_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_bodies),        cmocka_unit_test(test_wall),
                                       cmocka_unit_test(test_menger_sponge), cmocka_unit_test(test_touching_surfaces),
                                       cmocka_unit_test(test_random_cells),  cmocka_unit_test(test_random_blocks),
                                       cmocka_unit_test(test_sheets),        cmocka_unit_test(test_random_sheets),
                                       cmocka_unit_test(test_leaning_walls), cmocka_unit_test(test_star_bodies),
                                       cmocka_unit_test(test_flat_bodies),   cmocka_unit_test(test_pentagrams),
                                       cmocka_unit_test(test_leg_on_cut),    cmocka_unit_test(test_same_result)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
