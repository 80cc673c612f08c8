/* How drawings change, or do not change, if scenes are scaled, moved, turned, reordered, or drawn with other grids and
 * threads. Then each drawing is compared with a simple second opinion: sight rays from points of every segment.
 *
 * Two kinds of scenes. In the lattices solids lie at random, so nothing ties; these scenes test accuracy. In the crowds
 * and the wall all corners are small integers, so everything ties: corners, edges and faces touch or coincide, and
 * anything that is no tie is far from one. A drawing of them shows whether ties are decided the same way throughout. */
#include <stdio.h>

#include "scenes.h"
#include "segments.h"

/* How much a parameter along an edge may differ between two drawings of one scene with differently rounded coordinates.
 * The library computes each to 1e-11. */
#define T_BOUND 2e-11

enum scene_kind { LATTICE, BALLS, CROWD, COPIES, WALL, CROOKED_WALL };

/* roomy: an eye at (1.5, 1.5, 1.5) is in none of the solids. digits: after the point, 0 = all. */
static const struct scene_case {
    const char *name;
    enum scene_kind kind;
    int size;
    double fill;
    uint64_t seed;
    bool roomy;
    int digits;
} scenes[] = {
    {"lattice", LATTICE, 3, 0.48, 11, true, 0},
    {"interpenetrating lattice", LATTICE, 3, 0.9, 12, false, 0},
    {"deep lattice", LATTICE, 5, 0.8, 16, true, 0},
    {"lattice to six digits", LATTICE, 4, 0.6, 17, true, 6},
    {"balls", BALLS, 2, 0.9, 18, false, 0},
    {"balls to five digits", BALLS, 2, 1.2, 19, false, 5},
    {"crowd", CROWD, 24, 0, 13, false, 0},
    {"dense crowd", CROWD, 40, 0, 14, false, 0},
    {"crowd of copies", COPIES, 16, 0, 20, false, 0},
    {"other copies", COPIES, 16, 0, 2081, false, 0},
    {"wall", WALL, 4, 0, 21, false, 0},
    {"crooked wall", CROOKED_WALL, 4, 0, 22, false, 0},
};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

/* among: the eye stands between the solids, and some are cut by the near plane or lie behind. */
static const struct camera_case {
    const char *name;
    roberts_camera camera;
    bool among;
} cameras[] = {
    {"top", {.dir = {0, 0, 1}, .up = {0, 1, 0}}, false},
    {"front", {.dir = {0, -1, 0}}, false},
    {"iso", {.dir = {1, -1, 1}}, false},
    {"askew", {.dir = {1, 2, 3}}, false},
    {"oblique", {.dir = {0, -1, 0}, .oblique = {0.5, 0.25}}, false},
    {"eye", {ROBERTS_PERSPECTIVE, .eye = {13, -17, 11}, .look_at = {2, 2, 2}, .has_look_at = true}, false},
    {"eye ahead", {ROBERTS_PERSPECTIVE, .eye = {3, -20, 2}, .look_at = {3, 2, 2}, .has_look_at = true}, false},
    {"eye among the solids",
     {ROBERTS_PERSPECTIVE, .eye = {1.5, 1.5, 1.5}, .look_at = {0, 0.5, 0.75}, .has_look_at = true,
      .near_distance = 0.1},
     true},
    {"eye among the solids, looking up",
     {ROBERTS_PERSPECTIVE, .eye = {1.5, 1.5, 1.5}, .look_at = {1.5, 1.5, 4}, .up = {0, 1, 0}, .has_look_at = true,
      .near_distance = 0.01},
     true},
};
enum { CAMERAS = sizeof cameras / sizeof cameras[0] };

/* A wall four bricks deep. */
static void make_wall(model *m, int size)
{
    model one = {0};
    uint32_t order[MODEL_SOLIDS];
    model_wall(&one, size, size);
    for (uint32_t i = 0; i < one.solids; i++)
        order[i] = i;
    for (int k = 0; k < 4; k++) {
        model_reorder(m, &one, order);
        model_map(&one, mat3_scale(1, 1, 1), (roberts_vec3){0, 1, 0});
    }
    model_free(&one);
}

/* Every solid three times at the same place. */
static void make_copies(model *m, int size, uint64_t seed)
{
    model one = {0};
    uint32_t order[MODEL_SOLIDS];
    rng r = {seed + 1};
    model_crowd(&one, size, 3, seed);
    for (int k = 0; k < 3; k++) {
        rng_permutation(&r, order, one.solids);
        model_reorder(m, &one, order);
    }
    model_free(&one);
}

static model make(const struct scene_case *c)
{
    model m = {0};
    switch (c->kind) {
    case LATTICE:
        model_lattice(&m, c->size, c->fill, c->seed);
        break;
    case BALLS:
        model_balls(&m, c->size, c->fill, c->seed);
        break;
    case CROWD:
        model_crowd(&m, c->size, 4, c->seed);
        break;
    case COPIES:
        make_copies(&m, c->size, c->seed);
        break;
    default:
        make_wall(&m, c->size);
        if (c->kind == CROOKED_WALL)
            model_shake(&m, 2e-6, c->seed);
    }
    if (c->digits)
        model_to_digits(&m, c->digits);
    return m;
}

static bool has_ties(const struct scene_case *c)
{
    return c->kind == CROWD || c->kind == COPIES || c->kind == WALL;
}

/* Where bricks all but touch, another rounding may decide otherwise. */
static bool is_crooked(const struct scene_case *c)
{
    return c->kind == CROOKED_WALL;
}

/* Solids may touch, at least within the departure of their faces from planes. Then their order decides which of them is
 * named. */
static bool may_tie(const struct scene_case *c)
{
    return has_ties(c) || is_crooked(c) || c->digits;
}

/* One thread: waiting for others takes longer than these scenes do. */
static roberts_hide_options with_hidden(void)
{
    roberts_hide_options options = roberts_hide_options_default();
    options.keep_hidden = true;
    options.all_edges = true;
    options.threads = 1;
    return options;
}

/* ---- comparing drawings ---------------------------------------------------------------------------------------- */

/* What may differ. Zeros: nothing, to the last bit. */
typedef struct allowance {
    double t;     /* parameters by so much */
    double p;     /* picture points may move by so much, after scaling */
    double scale; /* of the picture; 0 = 1 */
    bool shift;   /* the picture may be moved as a whole */
    bool by;      /* another solid may be named, among those that touch */
} allowance;

/* How far rounding may move a point of the picture. It grows with the picture, which is large near the eye. */
static double picture_bound(const roberts_drawing *d)
{
    double size = d->scene_diameter;
    for (size_t i = 0; i < d->count; i++)
        size = fmax(size, fmax(fabs(d->segment[i].p0.x) + fabs(d->segment[i].p0.y),
                               fabs(d->segment[i].p1.x) + fabs(d->segment[i].p1.y)));
    return T_BOUND * size;
}

static bool same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

static bool near(double a, double b, double bound)
{
    return bound > 0.0 ? fabs(a - b) <= bound : same_bits(a + 0.0, b + 0.0); /* -0 is 0 */
}

static void print_row(const char *what, const roberts_segment *s)
{
    printf("  %s: solid %u edge %u-%u t %.17g..%.17g state %d line %d by %d p (%.17g %.17g) (%.17g %.17g)\n", what,
           s->solid, s->v0, s->v1, s->t0, s->t1, s->state, s->line, (int)s->by, s->p0.x, s->p0.y, s->p1.x, s->p1.y);
}

static bool same_row(const roberts_segment *a, const roberts_segment *b, const allowance *may, roberts_vec2 shift)
{
    double k = may->scale != 0.0 ? may->scale : 1.0;
    return a->solid == b->solid && a->v0 == b->v0 && a->v1 == b->v1 && a->state == b->state && a->line == b->line &&
           (may->by ? (a->by == ROBERTS_NONE) == (b->by == ROBERTS_NONE) : a->by == b->by) &&
           near(a->t0, b->t0, may->t) && near(a->t1, b->t1, may->t) && near(k * a->p0.x + shift.x, b->p0.x, may->p) &&
           near(k * a->p0.y + shift.y, b->p0.y, may->p) && near(k * a->p1.x + shift.x, b->p1.x, may->p) &&
           near(k * a->p1.y + shift.y, b->p1.y, may->p);
}

static void expect_same(const char *what, const char *scene, const char *camera, const roberts_drawing *a,
                        const roberts_drawing *b, allowance may)
{
    roberts_vec2 shift = {0, 0};
    double k = may.scale != 0.0 ? may.scale : 1.0;
    size_t count = a->count < b->count ? a->count : b->count;
    if (may.shift && count)
        shift =
            (roberts_vec2){b->segment[0].p0.x - k * a->segment[0].p0.x, b->segment[0].p0.y - k * a->segment[0].p0.y};
    for (size_t i = 0; i < count; i++)
        if (!same_row(&a->segment[i], &b->segment[i], &may, shift)) {
            print_row("one", &a->segment[i]);
            print_row("other", &b->segment[i]);
            fail_msg("%s: %s, %s: row %zu differs", what, scene, camera, i);
        }
    if (a->count != b->count)
        fail_msg("%s: %s, %s: %zu and %zu rows", what, scene, camera, a->count, b->count);
    assert_true(count > 0);
}

/* Rows as they would be if solid i were solid[i] and vertex v were vertex[v]. */
static void renumber(roberts_drawing *d, const uint32_t *solid, const uint32_t *vertex)
{
    for (size_t i = 0; i < d->count; i++) {
        roberts_segment *s = &d->segment[i], old = *s;
        s->solid = solid[old.solid];
        s->by = old.by == ROBERTS_NONE ? ROBERTS_NONE : solid[old.by];
        s->v0 = vertex[old.v0];
        s->v1 = vertex[old.v1];
        if (s->v0 > s->v1) {
            s->v0 = vertex[old.v1];
            s->v1 = vertex[old.v0];
            s->t0 = 1.0 - old.t1;
            s->t1 = 1.0 - old.t0;
            s->p0 = old.p1;
            s->p1 = old.p0;
        }
    }
    qsort(d->segment, d->count, sizeof *d->segment, compare_segments);
}

/* Calls `check` for each scene and camera with the scene's drawing, hidden rows and all edges included. */
typedef void check_fn(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                      const roberts_drawing *drawing);

/* The models, and their drawings where there is one. */
static model models[SCENES];
static roberts_drawing drawings[SCENES][CAMERAS];

static int draw_all(void **state)
{
    roberts_hide_options options = with_hidden();
    (void)state;
    for (size_t s = 0; s < SCENES; s++) {
        models[s] = make(&scenes[s]);
        for (size_t c = 0; c < CAMERAS; c++)
            if (!cameras[c].among || scenes[s].roomy)
                drawings[s][c] = model_draw(&models[s], &cameras[c].camera, &options);
    }
    return 0;
}

static int free_all(void **state)
{
    (void)state;
    for (size_t s = 0; s < SCENES; s++) {
        for (size_t c = 0; c < CAMERAS; c++)
            roberts_drawing_free(&drawings[s][c]);
        model_free(&models[s]);
    }
    return 0;
}

static void for_each(check_fn *check)
{
    for (size_t s = 0; s < SCENES; s++)
        for (size_t c = 0; c < CAMERAS; c++)
            if (!cameras[c].among || scenes[s].roomy)
                check(&scenes[s], &models[s], &cameras[c], &drawings[s][c]);
}

/* ---- scaled, moved, turned ------------------------------------------------------------------------------------- */

static roberts_camera scaled_camera(roberts_camera camera, double k)
{
    camera.eye = vec3_scale(k, camera.eye);
    camera.look_at = vec3_scale(k, camera.look_at);
    camera.near_distance *= k;
    return camera;
}

static void expect_scaled(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                          const roberts_drawing *drawing, double k, allowance may)
{
    roberts_hide_options options = with_hidden();
    roberts_camera view = scaled_camera(camera->camera, k);
    model other;
    model_copy(&other, m);
    model_map(&other, mat3_scale(k, k, k), (roberts_vec3){0, 0, 0});
    roberts_drawing scaled = model_draw(&other, &view, &options);
    may.scale = k;
    expect_same("scaled", scene->name, camera->name, drawing, &scaled, may);
    assert_true(near(scaled.epsilon / k, drawing->epsilon, may.t > 0.0 ? 1e-12 * drawing->epsilon : 0.0));
    roberts_drawing_free(&scaled);
    model_free(&other);
}

static void check_powers_of_two(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                                const roberts_drawing *drawing)
{
    static const int exponents[] = {-450, -40, -1, 5, 60, 450};
    for (size_t i = 0; i < sizeof exponents / sizeof exponents[0]; i++)
        expect_scaled(scene, m, camera, drawing, ldexp(1.0, exponents[i]), (allowance){0});
}

static void scaled_by_powers_of_two(void **state)
{
    (void)state;
    for_each(check_powers_of_two);
}

static void check_powers_of_ten(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                                const roberts_drawing *drawing)
{
    static const double factors[] = {1e-8, 1e8, 1e-100, 1e100};
    if (is_crooked(scene))
        return;
    for (size_t i = 0; i < sizeof factors / sizeof factors[0]; i++) {
        double k = factors[i];
        expect_scaled(scene, m, camera, drawing, k, (allowance){.t = T_BOUND, .p = k * picture_bound(drawing)});
    }
}

static void scaled_by_powers_of_ten(void **state)
{
    (void)state;
    for_each(check_powers_of_ten);
}

/* Scenes are moved by integers, so that the crowds' coordinates stay exact. A short way changes nothing. Far away, the
 * touching distance grows with the coordinates, and more is computed in twice the precision. */
static void check_moved(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                        const roberts_drawing *drawing)
{
    static const roberts_vec3 offsets[] = {{3, -7, 11}, {-2000, 1000, 3000}, {1e7, -3e7, 2e7}};
    roberts_hide_options options = with_hidden();
    if (!has_ties(scene))
        return; /* their coordinates are no integers: moved, they are another scene */
    for (size_t i = 0; i < sizeof offsets / sizeof offsets[0]; i++) {
        roberts_camera view = camera->camera;
        model other;
        allowance may = {.t = i < 2 ? 0.0 : T_BOUND, .p = i < 2 ? 0.0 : picture_bound(drawing)};
        view.eye = vec3_add(view.eye, offsets[i]);
        view.look_at = vec3_add(view.look_at, offsets[i]);
        model_copy(&other, m);
        model_map(&other, mat3_scale(1, 1, 1), offsets[i]);
        roberts_drawing moved = model_draw(&other, &view, &options);
        expect_same("moved", scene->name, camera->name, drawing, &moved, may);
        roberts_drawing_free(&moved);
        model_free(&other);
    }
}

static void moved_by_integers(void **state)
{
    (void)state;
    for_each(check_moved);
}

/* The centre of the turned scene's box is another point, so that the picture may be moved as a whole. */
static void check_turned(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                         const roberts_drawing *drawing)
{
    roberts_hide_options options = with_hidden();
    rng r = {scene->seed + 1};
    for (int i = 0; i < 3 && !is_crooked(scene); i++) {
        mat3 turn = mat3_turn(&r);
        roberts_camera view = camera->camera;
        model other;
        roberts_vec3 up = view.up.y != 0.0 ? view.up : (roberts_vec3){0, 0, 1};
        view.dir = mat3_map(turn, view.dir);
        view.up = mat3_map(turn, up);
        view.eye = mat3_map(turn, view.eye);
        view.look_at = mat3_map(turn, view.look_at);
        model_copy(&other, m);
        model_map(&other, turn, (roberts_vec3){0, 0, 0});
        roberts_drawing turned = model_draw(&other, &view, &options);
        expect_same("turned", scene->name, camera->name, drawing, &turned,
                    (allowance){.t = T_BOUND, .p = picture_bound(drawing), .shift = true});
        roberts_drawing_free(&turned);
        model_free(&other);
    }
}

static void turned_with_the_camera(void **state)
{
    (void)state;
    for_each(check_turned);
}

/* The length of the direction toward the viewer does not matter, nor does that of `up`. */
static void check_lengths(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                          const roberts_drawing *drawing)
{
    static const int exponents[] = {-1020, -500, 3, 500, 1020};
    roberts_hide_options options = with_hidden();
    for (size_t i = 0; i < sizeof exponents / sizeof exponents[0]; i++) {
        roberts_camera view = camera->camera;
        double k = ldexp(1.0, exponents[i]), up = ldexp(1.0, exponents[4 - i]);
        view.dir = vec3_scale(k, view.dir);
        view.up = vec3_scale(up, view.up);
        roberts_drawing other = model_draw(m, &view, &options);
        expect_same("direction of another length", scene->name, camera->name, drawing, &other, (allowance){0});
        roberts_drawing_free(&other);
    }
}

static void directions_of_any_length(void **state)
{
    (void)state;
    for_each(check_lengths);
}

/* ---- written otherwise ----------------------------------------------------------------------------------------- */

/* Where several solids touch, `by` is the one with the smallest number, so it may change. */
static void check_reordered(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                            const roberts_drawing *drawing)
{
    roberts_hide_options options = with_hidden();
    uint32_t order[MODEL_SOLIDS], *vertex = malloc(m->mesh.vertex_count * sizeof *vertex);
    rng r = {scene->seed + 2};
    model other = {0};
    assert_non_null(vertex);
    rng_permutation(&r, order, m->solids);
    model_reorder(&other, m, order);
    for (uint32_t i = 0; i < m->solids; i++)
        for (uint32_t v = other.first_vertex[i]; v < other.first_vertex[i + 1]; v++)
            vertex[v] = v - other.first_vertex[i] + m->first_vertex[order[i]];
    roberts_drawing reordered = model_draw(&other, &camera->camera, &options);
    renumber(&reordered, order, vertex);
    expect_same("solids reordered", scene->name, camera->name, drawing, &reordered, (allowance){.by = may_tie(scene)});
    roberts_drawing_free(&reordered);
    model_free(&other);
    free(vertex);
}

static void solids_reordered(void **state)
{
    (void)state;
    for_each(check_reordered);
}

static void check_wound(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                        const roberts_drawing *drawing)
{
    roberts_hide_options options = with_hidden();
    rng r = {scene->seed + 3};
    model other;
    if (is_crooked(scene))
        return;
    model_copy(&other, m);
    model_wind(&other, &r);
    roberts_drawing wound = model_draw(&other, &camera->camera, &options);
    expect_same("faces wound otherwise", scene->name, camera->name, drawing, &wound,
                (allowance){.t = T_BOUND, .p = picture_bound(drawing)});
    roberts_drawing_free(&wound);
    model_free(&other);
}

static void faces_wound_otherwise(void **state)
{
    (void)state;
    for_each(check_wound);
}

/* number[v]: the new number of vertex v; faces stay where they are. */
static void renumber_mesh(roberts_mesh *mesh, const uint32_t *number)
{
    roberts_vec3 *old = malloc(mesh->vertex_count * sizeof *old);
    assert_non_null(old);
    memcpy(old, mesh->vertex, mesh->vertex_count * sizeof *old);
    for (size_t v = 0; v < mesh->vertex_count; v++)
        mesh->vertex[number[v]] = old[v];
    for (size_t k = 0; k < mesh->corner_count; k++)
        mesh->corner[k] = number[mesh->corner[k]];
    free(old);
}

/* Which solid of `m` has the i-th smallest number of a first vertex, after renumbering. */
static void order_solids(const model *m, const uint32_t *number, uint32_t *order)
{
    uint32_t least[MODEL_SOLIDS];
    for (uint32_t s = 0; s < m->solids; s++) {
        least[s] = ROBERTS_NONE;
        for (uint32_t v = m->first_vertex[s]; v < m->first_vertex[s + 1]; v++)
            least[s] = number[v] < least[s] ? number[v] : least[s];
    }
    for (uint32_t s = 0; s < m->solids; s++) {
        uint32_t rank = 0;
        for (uint32_t i = 0; i < m->solids; i++)
            rank += least[i] < least[s];
        order[rank] = s;
    }
}

static void check_renumbered(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                             const roberts_drawing *drawing)
{
    roberts_hide_options options = with_hidden();
    uint32_t count = (uint32_t)m->mesh.vertex_count, order[MODEL_SOLIDS];
    if (is_crooked(scene))
        return;
    uint32_t *number = malloc(count * sizeof *number), *back = malloc(count * sizeof *back);
    rng r = {scene->seed + 4};
    model other;
    assert_true(number && back);
    rng_permutation(&r, number, count);
    for (uint32_t v = 0; v < count; v++)
        back[number[v]] = v;
    model_copy(&other, m);
    renumber_mesh(&other.mesh, number);
    order_solids(m, number, order);
    roberts_drawing renumbered = model_draw(&other, &camera->camera, &options);
    renumber(&renumbered, order, back);
    expect_same("vertices renumbered", scene->name, camera->name, drawing, &renumbered,
                (allowance){.t = T_BOUND, .p = picture_bound(drawing), .by = may_tie(scene)});
    roberts_drawing_free(&renumbered);
    model_free(&other);
    free(number);
    free(back);
}

static void vertices_renumbered(void **state)
{
    (void)state;
    for_each(check_renumbered);
}

/* ---- drawn otherwise ------------------------------------------------------------------------------------------- */

static void check_grids(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                        const roberts_drawing *drawing)
{
    static const uint32_t grids[] = {1, 2, 3, 7, 64, 200};
    for (size_t i = 0; i < sizeof grids / sizeof grids[0]; i++) {
        roberts_hide_options options = with_hidden();
        options.grid = grids[i];
        roberts_drawing other = model_draw(m, &camera->camera, &options);
        assert_in_range(other.grid, grids[i] < 64 ? grids[i] : 64, grids[i]); /* fewer cells where lists are long */
        expect_same("another grid", scene->name, camera->name, drawing, &other, (allowance){0});
        roberts_drawing_free(&other);
    }
}

static void any_grid(void **state)
{
    (void)state;
    for_each(check_grids);
}

/* Enough solids to keep several threads busy. */
static void any_threads_any_run(void **state)
{
    model m = {0};
    roberts_hide_options options = with_hidden();
    (void)state;
    model_lattice(&m, 7, 0.6, 15);
    for (size_t c = 2; c < CAMERAS; c++) {
        options.keep_hidden = c % 2 == 0;
        options.threads = 1;
        roberts_drawing one = model_draw(&m, &cameras[c].camera, &options);
        static const uint32_t threads[] = {0, 2, 3, 7};
        for (uint32_t run = 0; run < 20; run++) {
            options.threads = threads[run % 4];
            roberts_drawing again = model_draw(&m, &cameras[c].camera, &options);
            expect_same("another run", "large lattice", cameras[c].name, &one, &again, (allowance){0});
            assert_memory_equal(&one.tally, &again.tally, sizeof one.tally);
            roberts_drawing_free(&again);
        }
        roberts_drawing_free(&one);
    }
    model_free(&m);
}

/* ---- options --------------------------------------------------------------------------------------------------- */

/* Keeps the rows that `keep` accepts. */
static void filter(roberts_drawing *d, bool (*keep)(const roberts_segment *))
{
    size_t kept = 0;
    for (size_t i = 0; i < d->count; i++)
        if (keep(&d->segment[i]))
            d->segment[kept++] = d->segment[i];
    d->count = kept;
}

static bool is_visible(const roberts_segment *s)
{
    return s->state == ROBERTS_VISIBLE;
}

/* If only visible rows are wanted, solids that are wholly hidden may be left out early, with any grid. */
static void check_visible_alone(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                                const roberts_drawing *drawing)
{
    static const uint32_t grids[] = {0, 1, 2, 3, 17, 43, 200};
    const size_t count = sizeof grids / sizeof grids[0] - (camera != &cameras[0]); /* many cells take long */
    roberts_hide_options options = with_hidden();
    roberts_drawing visible = model_draw(m, &camera->camera, &options);
    /* a culled solid hides nothing, but where borders coincide in the picture, its own may be off in the last bit */
    allowance may = {.t = may_tie(scene) ? T_BOUND : 0.0, .p = may_tie(scene) ? picture_bound(drawing) : 0.0};
    assert_int_equal(visible.count, drawing->count);
    filter(&visible, is_visible);
    options.keep_hidden = false;
    for (size_t i = 0; i < count; i++) {
        options.grid = grids[i];
        roberts_drawing alone = model_draw(m, &camera->camera, &options);
        expect_same("visible rows alone", scene->name, camera->name, &visible, &alone, may);
        roberts_drawing_free(&alone);
    }
    roberts_drawing_free(&visible);
}

static void visible_rows_alone(void **state)
{
    (void)state;
    for_each(check_visible_alone);
}

/* Rounds the model to two digits, so that its faces are no longer planar. Frees the model. */
static roberts_scene *build_coarse(model *m)
{
    const roberts_scene_options options = {.tolerance = 0.05};
    roberts_scene *scene = NULL;
    roberts_error error;
    model_to_digits(m, 2);
    if (roberts_scene_build(&m->mesh, &options, &scene, &error) != ROBERTS_OK)
        fail_msg("%s", error.message);
    model_free(m);
    return scene;
}

/* What is visible with hidden rows is visible without them, exactly or except for ties. Frees the scene. */
static void check_scene_alone(roberts_scene *scene, const roberts_camera *camera, const char *name, bool ties)
{
    roberts_hide_options options = with_hidden();
    roberts_drawing visible, alone;
    assert_int_equal(roberts_hide(scene, camera, &options, &visible, NULL), ROBERTS_OK);
    allowance may = {.t = ties ? T_BOUND : 0.0, .p = ties ? picture_bound(&visible) : 0.0};
    options.keep_hidden = false;
    assert_int_equal(roberts_hide(scene, camera, &options, &alone, NULL), ROBERTS_OK);
    filter(&visible, is_visible);
    expect_same("visible rows alone", name, "one view", &visible, &alone, may);
    roberts_drawing_free(&visible);
    roberts_drawing_free(&alone);
    roberts_scene_free(scene);
}

/* Three solids of some thirty front faces, which are entered face by face, and boxes among them; all to two digits, so
 * that faces leave gaps between them where edges pierce them. */
static roberts_scene *make_gaps(uint64_t seed, roberts_camera *camera)
{
    model m = {0};
    rng r = {seed};
    for (int i = 0; i < 3; i++) {
        double k = rng_between(&r, 0.5, 1.5), high = rng_between(&r, 0.3, 2.0);
        mat3 turn = mat3_turn(&r);
        double x = rng_between(&r, -1, 1), y = rng_between(&r, -1, 1);
        uint32_t n = (uint32_t)rng_int(&r, 52, 64);
        model_round(&m, n, false, mat3_times(turn, mat3_scale(k, k, k * high)), (roberts_vec3){x, y, 2.0 * i});
    }
    for (int i = 0; i < 30; i++) {
        double x = rng_between(&r, -2, 2), y = rng_between(&r, -2, 2), z = rng_between(&r, -3, 7);
        double w = rng_between(&r, 0.1, 1), h = rng_between(&r, 0.1, 1), d = rng_between(&r, 0.1, 0.5);
        model_box(&m, (roberts_vec3){x, y, z}, (roberts_vec3){x + w, y + h, z + d});
    }
    double x = rng_between(&r, -0.2, 0.2), y = rng_between(&r, -0.2, 0.2);
    *camera = (roberts_camera){.dir = {x, y, 1}};
    return build_coarse(&m);
}

/* Such a solid hides what all its faces hide together, even if some of them reach only what others hide already. */
static void visible_rows_behind_gaps(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 600; seed++) {
        roberts_camera camera;
        roberts_scene *scene = make_gaps(seed, &camera);
        check_scene_alone(scene, &camera, "faces with gaps", false);
    }
}

/* Solids, and smaller or equal ones straight behind them, which show in the picture only where two digits make them:
 * corners coincide with corners there, and faces do not fill their outlines. */
static roberts_scene *make_echoes(uint64_t seed)
{
    model m = {0};
    rng r = {seed};
    for (int i = 0; i < 12; i++) {
        double w = rng_between(&r, 0.2, 2), h = rng_between(&r, 0.2, 2), d = rng_between(&r, 0.2, 2);
        mat3 turn = mat3_times(mat3_turn(&r), mat3_scale(w, h, d));
        roberts_vec3 at = {rng_between(&r, -4, 4), rng_between(&r, -4, 4), rng_between(&r, -4, 4)};
        for (int k = 0, echoes = rng_int(&r, 1, 5); k < echoes; k++) {
            double size = k && rng_int(&r, 0, 1) ? 0.995 : 1.0;
            roberts_vec3 behind = {at.x - 3.0 * k, at.y - 6.0 * k, at.z - 6.0 * k};
            model_add(&m, &shapes[i % SHAPES], mat3_times(turn, mat3_scale(size, size, size)), behind);
        }
    }
    return build_coarse(&m);
}

static void visible_rows_behind_echoes(void **state)
{
    const roberts_camera camera = {.dir = {1, 2, 2}};
    (void)state;
    for (uint64_t seed = 1801; seed <= 2400; seed++) /* a solid that shows was culled in one of them, 2161 */
        check_scene_alone(make_echoes(seed), &camera, "solids straight behind others", true);
}

/* Every edge of the scene has rows; they follow one another from 0 to 1 and take turns. */
static void check_tiles(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                        const roberts_drawing *drawing)
{
    size_t edges = 0;
    roberts_scene *built = model_build(m);
    for (size_t i = 0; i < drawing->count; i++) {
        const roberts_segment *s = &drawing->segment[i];
        const roberts_segment *before = i ? s - 1 : NULL, *after = i + 1 < drawing->count ? s + 1 : NULL;
        bool first = !before || !same_edge(before, s), last = !after || !same_edge(after, s);
        bool right = s->v0 < s->v1 && s->t0 < s->t1 && (s->by == ROBERTS_NONE) == (s->state != ROBERTS_HIDDEN) &&
                     (first ? s->t0 == 0.0 : s->t0 == before->t1 && s->state != before->state) &&
                     (!last || s->t1 == 1.0) && (!before || compare_segments(before, s) < 0);
        if (!right) {
            print_row("row", s);
            fail_msg("%s, %s: row %zu does not tile", scene->name, camera->name, i);
        }
        edges += first;
    }
    assert_int_equal(edges, roberts_scene_edge_count(built));
    assert_int_equal(edges, drawing->edges);
    assert_true(edges == drawing->drawn_edges || camera->among);
    roberts_scene_free(built);
}

static void rows_tile_every_edge(void **state)
{
    (void)state;
    for_each(check_tiles);
}

/* Without flat edges, only the rows of the diagonals of the cut cubes' six faces are missing. */
static void check_creases(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                          const roberts_drawing *drawing)
{
    roberts_hide_options options = with_hidden();
    size_t k = 0, diagonals = 0;
    options.all_edges = false;
    roberts_drawing fewer = model_draw(m, &camera->camera, &options);
    for (size_t i = 0; i < drawing->count; i++) {
        if (k < fewer.count && same_row(&drawing->segment[i], &fewer.segment[k], &(allowance){0}, (roberts_vec2){0, 0}))
            k++;
        else if (drawing->segment[i].line == ROBERTS_OUTLINE)
            fail_msg("%s, %s: an outline is missing", scene->name, camera->name);
    }
    assert_int_equal(k, fewer.count);
    assert_int_equal(drawing->surviving_edges, fewer.surviving_edges);
    for (uint32_t i = 0; i < m->solids; i++)
        diagonals += m->first_face[i + 1] - m->first_face[i] == 12 ? 6 : 0;
    assert_true(drawing->drawn_edges - fewer.drawn_edges == diagonals || camera->among);
    roberts_drawing_free(&fewer);
}

static void all_edges_add_flat_ones_only(void **state)
{
    (void)state;
    for_each(check_creases);
}

/* A convex solid hides one interval of an edge of another, however the planes and sides of its faces are rounded. Two
 * solids at a time. */
static void one_solid_hides_one_interval(void **state)
{
    rng r = {26};
    size_t parts = 0;
    (void)state;
    for (int i = 0; i < 400; i++) {
        roberts_hide_options options = with_hidden();
        roberts_camera camera = {.dir = {0, 0, 1}, .up = {0, 1, 0}};
        model m = {0};
        if (i % 2) /* the near plane cuts the upper solid */
            camera = (roberts_camera){ROBERTS_PERSPECTIVE, .eye = {0.1, 0.2, 2.1}, .near_distance = 1.1};
        for (int k = 0; k < 2; k++) {
            double size = rng_between(&r, 0.3, 0.6);
            mat3 map = mat3_times(mat3_turn(&r), mat3_scale(size, size * 0.8, size * rng_between(&r, 0.3, 1)));
            roberts_vec3 at = {rng_between(&r, -0.3, 0.3), rng_between(&r, -0.3, 0.3), k};
            if (i % 4 < 2)
                model_round(&m, 80, i % 8 < 4, map, at);
            else
                model_add(&m, &shapes[i % 3 ? SHAPE_CUT : rng_int(&r, 0, SHAPES - 1)], map, at);
        }
        model_to_digits(&m, 5 + i / 8 % 2);
        roberts_drawing d = model_draw(&m, &camera, &options);
        for (size_t k = 0; k < d.count; k++) {
            bool hidden = d.segment[k].state == ROBERTS_HIDDEN && d.segment[k].line != ROBERTS_BACK &&
                          d.segment[k].line != ROBERTS_BACK_OUTLINE;
            parts += hidden;
            if (hidden && k >= 2 && same_edge(&d.segment[k - 2], &d.segment[k]) &&
                d.segment[k - 2].state == ROBERTS_HIDDEN) {
                print_row("gap", &d.segment[k - 1]);
                fail_msg("pair %d: two parts hidden", i);
            }
        }
        roberts_drawing_free(&d);
        model_free(&m);
    }
    assert_true(parts > 1000);
}

/* ---- perspective ----------------------------------------------------------------------------------------------- */

/* Largest difference of a parameter, the rows being otherwise the same. */
static double difference(const roberts_drawing *a, const roberts_drawing *b)
{
    double most = 0.0;
    assert_int_equal(a->count, b->count);
    for (size_t i = 0; i < a->count; i++) {
        const roberts_segment *s = &a->segment[i], *t = &b->segment[i];
        assert_true(same_edge(s, t) && s->state == t->state && s->line == t->line && s->by == t->by);
        most = fmax(most, fmax(fabs(s->t0 - t->t0), fabs(s->t1 - t->t1)));
    }
    return most;
}

/* The effect of perspective falls as 1 / distance: a hundred times as far, a hundredth. */
static void far_eye_comes_to_orthographic(void **state)
{
    (void)state;
    for (size_t s = 0; scenes[s].kind == LATTICE; s++) {
        roberts_hide_options options = with_hidden();
        model m = make(&scenes[s]);
        roberts_camera view = cameras[3].camera;
        roberts_drawing orthographic = model_draw(&m, &view, &options), drawing;
        double change[2];
        view = (roberts_camera){.projection = ROBERTS_PERSPECTIVE, .up = view.up};
        for (int i = 0; i < 2; i++) {
            double distance = i ? 1e8 : 1e6;
            view.eye = vec3_add((roberts_vec3){1, 1, 1}, vec3_scale(distance, cameras[3].camera.dir));
            view.look_at = (roberts_vec3){1, 1, 1};
            view.has_look_at = true;
            drawing = model_draw(&m, &view, &options);
            change[i] = difference(&orthographic, &drawing);
            roberts_drawing_free(&drawing);
        }
        assert_true(change[0] > 1e-9);
        assert_true(fabs(change[1] / change[0] - 0.01) < 0.002);
        roberts_drawing_free(&orthographic);
        model_free(&m);
    }
}

/* ---- a second opinion: rays ------------------------------------------------------------------------------------ */

/* A solid's planes, from the model alone. */
typedef struct solid_planes {
    plane F[200];
    uint32_t count;
} solid_planes;

static solid_planes planes_of(const model *m, uint32_t solid)
{
    solid_planes planes = {.count = 0};
    roberts_vec3 middle = {0, 0, 0};
    uint32_t vertices = m->first_vertex[solid + 1] - m->first_vertex[solid];
    for (uint32_t v = m->first_vertex[solid]; v < m->first_vertex[solid + 1]; v++)
        middle = vec3_add(middle, vec3_scale(1.0 / vertices, m->mesh.vertex[v]));
    for (uint32_t f = m->first_face[solid]; f < m->first_face[solid + 1]; f++) {
        const uint32_t *corner = m->mesh.corner + m->mesh.face_start[f];
        uint32_t count = m->mesh.face_start[f + 1] - m->mesh.face_start[f];
        roberts_vec3 a = m->mesh.vertex[corner[0]], b = m->mesh.vertex[corner[count / 3]],
                     c = m->mesh.vertex[corner[2 * count / 3]]; /* far apart: rounded coordinates tilt it least */
        roberts_vec3 n = vec3_cross(vec3_sub(b, a), vec3_sub(c, a));
        double side = vec3_dot(n, vec3_sub(middle, a)) < 0.0 ? -1.0 : 1.0;
        n = vec3_scale(side / vec3_length(n), n);
        planes.F[planes.count++] = (plane){n.x, n.y, n.z, -vec3_dot(n, a)};
    }
    return planes;
}

/* The part of the line P + s V inside a solid; in - out > 0: by about how much it misses. */
typedef struct chord {
    double in, out;
} chord;

/* No farther than `end`, where the near plane is. grow: by how much all planes are moved outward. */
static chord chord_through(const solid_planes *solid, roberts_vec3 P, roberts_vec3 V, double end, double grow)
{
    chord c = {-1e9, end};
    for (uint32_t i = 0; i < solid->count; i++) {
        plane F = solid->F[i];
        double f = plane_at(F, P) + grow, slope = F.a * V.x + F.b * V.y + F.c * V.z;
        if (fabs(slope) < 1e-9) {
            if (f < -1e-9)
                c.in = fmax(c.in, c.out + 1e6); /* beside this face all along */
            continue;
        }
        if (slope > 0.0)
            c.in = fmax(c.in, -f / slope);
        else
            c.out = fmin(c.out, -f / slope);
    }
    return c;
}

/* By how much solids are made larger and smaller to see whether a point of a lattice is near a tie; in the crowds, what
 * counts as a tie (what is none is farther from one). Model units; scenes are some ten across. */
#define TIE 1e-7
/* For rounded coordinates: a face's plane is uncertain by about 1e-5 near its corners, and by more beyond. */
#define TIE_ROUNDED 2e-4

typedef struct witness {
    const roberts_camera *camera;
    solid_planes *solids;
    uint32_t count;
    bool ties;
    double tie;
} witness;

static witness call_witness(const struct scene_case *scene, const model *m, const roberts_camera *camera)
{
    witness w = {camera, malloc(m->solids * sizeof *w.solids), m->solids, has_ties(scene),
                 scene->digits ? TIE_ROUNDED : TIE};
    assert_non_null(w.solids);
    for (uint32_t i = 0; i < m->solids; i++)
        w.solids[i] = planes_of(m, i);
    return w;
}

/* In an oblique view from the front, what lies farther back is drawn farther right and up. */
static roberts_vec3 toward_viewer(const roberts_camera *camera, roberts_vec3 P)
{
    roberts_vec3 oblique = {camera->oblique.x, 0, camera->oblique.y};
    roberts_vec3 V =
        camera->projection == ROBERTS_PERSPECTIVE ? vec3_sub(camera->eye, P) : vec3_add(camera->dir, oblique);
    return vec3_scale(1.0 / vec3_length(V), V);
}

/* How far P is beyond the near plane; infinite where none is given. */
static double beyond_near(const roberts_camera *camera, roberts_vec3 P)
{
    roberts_vec3 axis = vec3_sub(camera->eye, camera->look_at);
    if (camera->near_distance == 0.0)
        return INFINITY;
    return vec3_dot(axis, vec3_sub(camera->eye, P)) / vec3_length(axis) - camera->near_distance;
}

/* The s of P + s V on the near plane: along V the distance from the eye falls in proportion. */
static double near_plane_at(const roberts_camera *camera, roberts_vec3 P)
{
    double beyond = beyond_near(camera, P);
    return isinf(beyond) ? 1e9 : vec3_length(vec3_sub(camera->eye, P)) * beyond / (beyond + camera->near_distance);
}

/* The line of sight from P, as far as the near plane. */
typedef struct sight {
    roberts_vec3 P, V;
    double end;
} sight;

static sight sight_from(const witness *w, roberts_vec3 P)
{
    return (sight){P, toward_viewer(w->camera, P), near_plane_at(w->camera, P)};
}

static chord ask(const witness *w, uint32_t solid, const sight *from, double grow)
{
    return chord_through(&w->solids[solid], from->P, from->V, from->end, grow);
}

/* A line meets a closed convex solid in a chord whose near end lies on a front face. P, a point of solid `own`, is
 * hidden where another solid's chord ends nearer to the viewer than P. *nearest: where the nearest chord ends. */
static bool is_hidden(const witness *w, uint32_t own, const sight *from, double grow, double *nearest)
{
    double touch = w->ties ? w->tie : 0.0;
    bool hidden = false;
    *nearest = 0.0;
    for (uint32_t i = 0; i < w->count; i++) {
        chord c = ask(w, i, from, grow);
        if (c.out - c.in < -touch)
            continue;
        *nearest = fmax(*nearest, c.out);
        hidden = hidden || (i != own && c.out > touch);
    }
    return hidden;
}

static roberts_vec3 point_at(const model *m, const roberts_segment *s, double t)
{
    roberts_vec3 A = m->mesh.vertex[s->v0], B = m->mesh.vertex[s->v1];
    return vec3_add(A, vec3_scale(t, vec3_sub(B, A)));
}

/* Does the row agree with the rays from one of its points? A back edge is hidden by its own solid. Clipped parts lie in
 * front of the near plane, all others behind it. */
static bool agrees(const witness *w, const roberts_segment *s, roberts_vec3 P, bool *certain)
{
    double beyond = beyond_near(w->camera, P);
    *certain = true;
    if (s->state == ROBERTS_CLIPPED || beyond < -w->tie)
        return s->state == ROBERTS_CLIPPED && beyond < w->tie;
    const sight from = sight_from(w, P);
    double grow = w->ties ? 0.0 : w->tie, nearest;
    bool larger = is_hidden(w, s->solid, &from, grow, &nearest);
    bool smaller = grow == 0.0 ? larger : is_hidden(w, s->solid, &from, -grow, &nearest);
    *certain = larger == smaller;
    return !*certain || s->line == ROBERTS_BACK || s->line == ROBERTS_BACK_OUTLINE ||
           larger == (s->state == ROBERTS_HIDDEN);
}

/* Points inside each row and close to its ends have its state: with the tiling, each row begins and ends where it
 * should, to a hundredth of its length. No place is a simple fraction: there a sight line of a crowd may touch a
 * corner, which hides a point but no part of an edge. */
static void check_states(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                         const roberts_drawing *drawing)
{
    static const double places[] = {0.01, 0.3711, 0.5353, 0.8191, 0.99};
    size_t asked = 0, certain = 0;
    if (is_crooked(scene))
        return;
    witness w = call_witness(scene, m, &camera->camera);
    for (size_t i = 0; i < drawing->count; i++)
        for (size_t k = 0; k < sizeof places / sizeof places[0]; k++) {
            const roberts_segment *s = &drawing->segment[i];
            bool sure;
            if (!agrees(&w, s, point_at(m, s, s->t0 + places[k] * (s->t1 - s->t0)), &sure)) {
                print_row("row", s);
                fail_msg("%s, %s: rays do not agree at %g of its length", scene->name, camera->name, places[k]);
            }
            asked++;
            certain += sure;
        }
    assert_true((double)certain > (scene->digits ? 0.9 : 0.98) * (double)asked);
    free(w.solids);
}

static void states_as_rays_see_them(void **state)
{
    (void)state;
    for_each(check_states);
}

/* The solid that a hidden row names is met by the ray from its middle, and none nearer; in the crowds it is the
 * smallest of those that are as near. */
static bool is_seen(const witness *w, const roberts_segment *s, roberts_vec3 P)
{
    const sight from = sight_from(w, P);
    double grow = w->ties ? 0.0 : w->tie, touch = w->ties ? w->tie : 0.0, nearest;
    is_hidden(w, ROBERTS_NONE, &from, -grow, &nearest);
    chord c = ask(w, s->by, &from, grow);
    for (uint32_t i = 0; w->ties && i < s->by; i++) {
        chord other = ask(w, i, &from, 0.0);
        if (other.out - other.in >= -touch && other.out >= nearest - touch)
            return false;
    }
    return c.out - c.in >= -touch && c.out >= nearest - touch;
}

static void check_by(const struct scene_case *scene, const model *m, const struct camera_case *camera,
                     const roberts_drawing *drawing)
{
    if (is_crooked(scene))
        return;
    witness w = call_witness(scene, m, &camera->camera);
    for (size_t i = 0; i < drawing->count; i++) {
        const roberts_segment *s = &drawing->segment[i];
        if (s->state == ROBERTS_HIDDEN && !is_seen(&w, s, point_at(m, s, 0.5 * (s->t0 + s->t1)))) {
            print_row("row", s);
            fail_msg("%s, %s: rays see another solid", scene->name, camera->name);
        }
    }
    free(w.solids);
}

static void by_as_rays_see_it(void **state)
{
    (void)state;
    for_each(check_by);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scaled_by_powers_of_two),
        cmocka_unit_test(scaled_by_powers_of_ten),
        cmocka_unit_test(moved_by_integers),
        cmocka_unit_test(turned_with_the_camera),
        cmocka_unit_test(directions_of_any_length),
        cmocka_unit_test(solids_reordered),
        cmocka_unit_test(faces_wound_otherwise),
        cmocka_unit_test(vertices_renumbered),
        cmocka_unit_test(any_grid),
        cmocka_unit_test(any_threads_any_run),
        cmocka_unit_test(visible_rows_alone),
        cmocka_unit_test(visible_rows_behind_gaps),
        cmocka_unit_test(visible_rows_behind_echoes),
        cmocka_unit_test(rows_tile_every_edge),
        cmocka_unit_test(all_edges_add_flat_ones_only),
        cmocka_unit_test(one_solid_hides_one_interval),
        cmocka_unit_test(far_eye_comes_to_orthographic),
        cmocka_unit_test(states_as_rays_see_them),
        cmocka_unit_test(by_as_rays_see_it),
    };
    return cmocka_run_group_tests_name("metamorphic", tests, draw_all, free_all);
}
