/* test_fronts.c - the scene in view space, built by threads: which solids they take at the same time; any number of
 * threads gives the same picture. */

#include "hide/front.h"
#include "scenes.h"

/* ---- tiles ----------------------------------------------------------------------------------------------------- */

enum { BOXES = 3000, CELLS_MOST = 600 };

static const struct tile_case {
    uint32_t nx, ny;
    double size; /* of most boxes, in parts of the window */
} tile_cases[] = {{600, 600, 0.02}, {600, 90, 0.05}, {1, 600, 0.1},
                  {127, 129, 0.01}, {390, 512, 0.3}, {600, 600, 1e-6}};

/* A window from (0, 0) to (1, 1), boxes in it and some of them across all of it or beyond: clipped away, they are
 * empty. */
static void fill(hide_fronts *fronts, rng *r, double size)
{
    for (uint32_t i = 0; i < BOXES; i++) {
        double x = rng_between(r, 0, 1), y = rng_between(r, 0, 1);
        double w = i % 50 ? rng_between(r, 0, size) : rng_between(r, 0, 1);
        double h = i % 70 ? rng_between(r, 0, size) : rng_between(r, 0, 1);
        float z = (float)rng_int(r, 0, 99);
        fronts->box[i] = (hide_box){
            (float)fmax(0, x - w), (float)fmin(1, x + w), (float)fmax(0, y - h), (float)fmin(1, y + h), z - 1, z};
        if (i % 100 == 99)
            fronts->box[i] = (hide_box){INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY};
    }
}

/* The tile of the round that reads or writes each cell: at most one. */
static void expect_apart(const tiles *t, const hide_fronts *fronts, int round)
{
    static uint32_t owner[CELLS_MOST][CELLS_MOST];
    const scan_frame *f = &fronts->cover.frame;
    memset(owner, 0, sizeof owner);
    for (uint32_t k = t->round[round]; k < t->round[round + 1]; k++)
        for (uint32_t i = t->tile[k].first; i < t->tile[k].end; i++) {
            const hide_box *box = &fronts->box[t->solid[i]];
            double m = f->margin, dx = 1.5 * f->dx + m, dy = 1.5 * f->dy + m; /* more than any solid asks */
            uint32_t last = scan_column(f, (double)box->x1 + dx), high = scan_row(f, (double)box->y1 + dy);
            for (uint32_t c = scan_column(f, (double)box->x0 - dx); c <= last; c++)
                for (uint32_t j = scan_row(f, (double)box->y0 - dy); j <= high; j++) {
                    if (owner[c][j] != 0 && owner[c][j] != k + 1)
                        fail_msg("%u x %u cells: tiles %u and %u share cell %u, %u", f->nx, f->ny, owner[c][j] - 1, k,
                                 c, j);
                    owner[c][j] = k + 1;
                }
        }
}

/* Each solid is in one tile; tiles of a round never meet in a cell; and each tile has room for what its solids may
 * need. */
static void tiles_of_a_round_are_apart(void **state)
{
    rng r = {91};
    (void)state;
    for (size_t i = 0; i < sizeof tile_cases / sizeof tile_cases[0]; i++) {
        static scene_solid solid[BOXES + 1];
        static hide_box box[BOXES];
        float any = 0;
        roberts_scene scene = {.solid_count = BOXES, .solid = solid};
        hide_fronts fronts = {.scene = &scene, .box = box, .cover.depth = &any};
        bool found[BOXES] = {false};
        tiles t;
        fronts.cover.frame =
            scan_frame_over((roberts_vec2){0, 0}, (roberts_vec2){1, 1}, tile_cases[i].nx, tile_cases[i].ny, 1e-9);
        fill(&fronts, &r, tile_cases[i].size);
        for (int k = 0; k < BOXES; k++) {
            solid[k + 1] = solid[k];
            solid[k + 1].vertex += (uint32_t)rng_int(&r, 0, 9);
            solid[k + 1].face += (uint32_t)rng_int(&r, 4, 9);
        }
        assert_true(tiles_make(&t, &fronts, 1 + (int)i % 3));
        assert_int_equal(t.round[0], 0);
        assert_int_equal(t.round[TILE_ROUNDS], t.count);
        for (int k = 0; k < TILE_ROUNDS; k++)
            if (k > 0) /* the first has one tile */
                expect_apart(&t, &fronts, k);
        uint32_t solids = 0, faces = 0, corners = 0;
        for (uint32_t k = 0; k < t.count; k++) {
            assert_true(t.tile[k].first == solids && t.tile[k].whole == solids && t.tile[k].face == faces &&
                        t.tile[k].outline == corners);
            assert_true(tiles_order(&t, &t.tile[k], &fronts));
            for (; solids < t.tile[k].end; solids++) {
                uint32_t s = t.solid[solids], last = solids > t.tile[k].first ? t.solid[solids - 1] : s;
                assert_true(!found[s] && (box[last].z1 > box[s].z1 || (box[last].z1 == box[s].z1 && last <= s)));
                found[s] = true;
                faces += solid[s + 1].face - solid[s].face;
                corners += solid[s + 1].vertex - solid[s].vertex;
            }
        }
        assert_int_equal(solids, BOXES);
        tiles_free(&t);
    }
}

/* Without covers they follow one another. */
static void tiles_without_covers(void **state)
{
    static const uint32_t counts[] = {0, 1, 511, 512, 513, 2999};
    static scene_solid solid[BOXES + 1];
    (void)state;
    for (int k = 0; k < BOXES; k++)
        solid[k + 1] = (scene_solid){.vertex = solid[k].vertex + 8, .face = solid[k].face + 6};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        roberts_scene scene = {.solid_count = counts[i], .solid = solid};
        hide_fronts fronts = {.scene = &scene};
        tiles t;
        uint32_t solids = 0;
        assert_true(tiles_make(&t, &fronts, 1 + (int)i % 3));
        assert_null(t.solid);
        assert_true(t.round[0] == 0 && t.round[1] == t.count && t.round[TILE_ROUNDS] == t.count);
        for (uint32_t k = 0; k < t.count; k++) {
            assert_true(t.tile[k].first == solids && t.tile[k].whole == solids && t.tile[k].face == solids * 6 &&
                        t.tile[k].outline == solids * 8 && t.tile[k].end >= solids);
            solids = t.tile[k].end;
        }
        assert_int_equal(solids, counts[i]);
        tiles_free(&t);
    }
}

/* ---- threads --------------------------------------------------------------------------------------------------- */

static bool same_outline(const hide_fronts *a, const hide_fronts *b, uint32_t k)
{
    uint32_t turned[2][SEEN_TURNED];
    hide_face f = hide_outline(a, k, turned[0]), g = hide_outline(b, k, turned[1]);
    return f.count == g.count && memcmp(f.corner, g.corner, f.count * sizeof *f.corner) == 0;
}

static bool same_faces(const hide_fronts *a, const hide_fronts *b, uint32_t k)
{
    hide_single single[2] = {{.front = ROBERTS_NONE}, {.front = ROBERTS_NONE}};
    uint32_t count, other;
    const hide_face *p = hide_faces(a, k, &count, &single[0]), *q = hide_faces(b, k, &other, &single[1]);
    if (count != other)
        return false;
    for (uint32_t i = 0; i < count; i++, p++, q++)
        if (memcmp(&p->F, &q->F, sizeof p->F) != 0 || p->count != q->count ||
            memcmp(p->corner, q->corner, p->count * sizeof *p->corner) != 0 || p->touch != q->touch ||
            p->limit != q->limit)
            return false;
    return true;
}

static bool same_whole(const hide_whole_front *f, const hide_whole_front *g)
{
    return f->reach == g->reach && f->loose == g->loose && f->depth == g->depth;
}

static void expect_same(const char *name, uint32_t threads, const hide_fronts *a, const hide_fronts *b)
{
    uint32_t solids = a->scene->solid_count;
    if (a->front_count != b->front_count || a->culled_count != b->culled_count || a->face_count != b->face_count ||
        a->back != b->back || a->edge_on != b->edge_on || a->most_corners != b->most_corners)
        fail_msg("%s, %u threads: %u and %u fronts, %zu and %zu culled", name, threads, a->front_count, b->front_count,
                 a->culled_count, b->culled_count);
    assert_memory_equal(a->box, b->box, solids * sizeof *a->box);
    assert_memory_equal(a->culled, b->culled, solids);
    assert_memory_equal(a->seen->facing, b->seen->facing, a->scene->face_count);
    assert_memory_equal(a->front_box, b->front_box, a->front_count * sizeof *a->front_box);
    for (uint32_t k = 0; k < a->front_count; k++) {
        const hide_front *f = &a->front[k], *g = &b->front[k];
        if (f->solid != g->solid || f->listed != g->listed || f->kind != g->kind || f->piece != g->piece ||
            (k < a->whole_count && !same_whole(&a->whole[k], &b->whole[k])) || !same_outline(a, b, k) ||
            !same_faces(a, b, k))
            fail_msg("%s, %u threads: front %u differs", name, threads, k);
        assert_true(f->listed && !a->culled[f->solid]); /* there are no copies */
    }
    if (a->cover.depth)
        assert_memory_equal(a->cover.depth, b->cover.depth, scan_cells(&a->cover.frame) * sizeof *a->cover.depth);
}

/* The window is the box of all vertices. */
static void expect_window(const char *name, const hide_fronts *fronts)
{
    double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
    for (uint32_t v = 0; v < fronts->scene->vertex_count; v++) {
        roberts_vec3 p = view_point(&fronts->seen->view, fronts->scene->point[v]);
        x0 = fmin(x0, p.x);
        x1 = fmax(x1, p.x);
        y0 = fmin(y0, p.y);
        y1 = fmax(y1, p.y);
    }
    if (fronts->low.x != x0 || fronts->high.x != x1 || fronts->low.y != y0 || fronts->high.y != y1)
        fail_msg("%s: window from %g, %g to %g, %g", name, fronts->low.x, fronts->low.y, fronts->high.x,
                 fronts->high.y);
}

static const roberts_camera aslant = {.dir = {1, -2, 3}}, along = {.dir = {0.01, 0.02, 1}},
                            eye = {ROBERTS_PERSPECTIVE, .eye = {30, -90, 70}};

static const struct scene_case {
    const char *name;
    int kind;
    const roberts_camera *camera;
    bool cull, covers; /* covers: they are kept */
} scene_cases[] = {
    {"a lattice", 0, &aslant, true, true},
    {"a lattice, nothing culled", 0, &aslant, false, false},
    {"a lattice from near by", 0, &eye, true, true},
    {"a heap of plates", 1, &along, true, true},
    {"a wall", 2, &aslant, true, false},
    {"round solids, face by face", 3, &aslant, true, true},
};

/* The model's solids at an offset; the model is empty afterwards. */
static void add_piece(roberts_mesh *mesh, model *m, roberts_vec3 offset)
{
    uint32_t first = (uint32_t)mesh->vertex_count, corner[MODEL_CORNERS];
    for (size_t i = 0; i < m->mesh.vertex_count; i++)
        mesh_vertex(mesh, vec3_add(m->mesh.vertex[i], offset));
    for (size_t f = 0; f < m->mesh.face_count; f++) {
        size_t start = m->mesh.face_start[f], count = m->mesh.face_start[f + 1] - start;
        for (size_t k = 0; k < count; k++)
            corner[k] = first + m->mesh.corner[start + k];
        mesh_face(mesh, corner, count);
    }
    model_free(m);
}

/* A thousand turned plates in a heap. */
static void heap(model *m, rng *r)
{
    for (int i = 0; i < 1000; i++) {
        double turn = rng_between(r, 0, 7), c = cos(turn), s = sin(turn);
        mat3 map = {{2 * c, 2 * s, 0}, {-s, c, 0}, {0, 0, 0.02}};
        model_add(m, &shapes[0], map,
                  (roberts_vec3){rng_between(r, -9, 9), rng_between(r, -9, 9), 0.1 * rng_int(r, 0, 500)});
    }
}

/* Eight thousand solids, made in groups of a thousand. */
static roberts_scene *make(int kind)
{
    rng r = {92};
    roberts_mesh mesh = {0};
    for (int i = 0; i < 8; i++) {
        model m = {0};
        double apart = kind == 2 ? 64 : 10;
        if (kind == 0 || (kind == 3 && i > 0))
            model_lattice(&m, 10, 0.9, 93 + (uint64_t)i);
        else if (kind == 1)
            heap(&m, &r);
        else if (kind == 2)
            model_wall(&m, 32, 32);
        else
            model_balls(&m, 6, 0.9, 94);
        add_piece(&mesh, &m,
                  kind == 1 ? (roberts_vec3){0, 0, 60 * i}
                            : (roberts_vec3){apart * (i & 1), apart * (i >> 1 & 1), apart * (i >> 2)});
    }
    return build_scene(&mesh);
}

/* Nothing in the result depends on the threads, not even the order of the fronts. */
static void same_by_any_threads(void **state)
{
    static const uint32_t threads[] = {2, 3, 7};
    (void)state;
    for (size_t i = 0; i < sizeof scene_cases / sizeof scene_cases[0]; i++) {
        const struct scene_case *c = &scene_cases[i];
        hide_fronts one, many;
        seen alone, together;
        roberts_scene *scene = make(c->kind);
        assert_int_equal(seen_begin(&alone, scene, c->camera, 0.0, NULL), ROBERTS_OK);
        assert_true(
            hide_fronts_build(&one, &alone, &(roberts_hide_options){.keep_hidden = !c->cull, .threads = 1}, false));
        expect_window(c->name, &one);
        if (c->covers != (one.cover.depth != NULL) || (c->covers && one.culled_count < scene->solid_count / 10))
            fail_msg("%s: covers are %skept, %zu of %u culled", c->name, one.cover.depth ? "" : "not ",
                     one.culled_count, scene->solid_count);
        for (size_t k = 0; k < sizeof threads / sizeof threads[0]; k++) {
            assert_int_equal(seen_begin(&together, scene, c->camera, 0.0, NULL), ROBERTS_OK);
            assert_true(hide_fronts_build(
                &many, &together, &(roberts_hide_options){.keep_hidden = !c->cull, .threads = threads[k]}, false));
            expect_same(c->name, threads[k], &one, &many);
            hide_fronts_free(&many);
            seen_end(&together);
        }
        hide_fronts_free(&one);
        seen_end(&alone);
        roberts_scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(tiles_of_a_round_are_apart),
                                       cmocka_unit_test(tiles_without_covers), cmocka_unit_test(same_by_any_threads)};
    return cmocka_run_group_tests_name("fronts", tests, NULL, NULL);
}
