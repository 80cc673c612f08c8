/* test_verify.c - the second opinion on drawings: none contradicts correct drawings, and some always contradicts
 * spoiled ones; picking by table; the tree of boxes, compared with testing every box. */
#include <math.h>
#include <string.h>

#include "base/vec.h"
#include "build_scene.h"
#include "ray/tree.h"
#include "rng.h"
#include "roberts.h"
#include "testing.h"

#define COUNT(a) (sizeof(a) / sizeof(a)[0])

/* ---- scenes ---------------------------------------------------------------------------------------------------- */

/* `count` blocks of random shape and turn in a cube of side 2, overlapping as they may. */
static roberts_scene *random_scene(rng *r, int count, double size)
{
    roberts_mesh mesh = {0};
    for (int i = 0; i < count; i++) {
        roberts_vec3 u, v, w;
        do {
            u = rng_vec3(r, size);
            v = rng_vec3(r, size);
            w = rng_vec3(r, size);
        } while (fabs(vec3_dot(u, vec3_cross(v, w))) < 0.1 * size * size * size);
        mesh_block(&mesh, rng_vec3(r, 1.0), u, v, w);
    }
    return build_scene(&mesh);
}

/* nx x ny x nz boxes of 2 x 3 x 4 that touch in faces; in every other layer shifted by half a box. */
static roberts_scene *brick_scene(int nx, int ny, int nz)
{
    roberts_mesh mesh = {0};
    for (int z = 0; z < nz; z++)
        for (int y = 0; y < ny; y++)
            for (int x = 0; x < nx; x++) {
                roberts_vec3 lo = {2.0 * x + (z % 2), 3.0 * y, 4.0 * z};
                mesh_box(&mesh, lo, vec3_add(lo, (roberts_vec3){2, 3, 4}));
            }
    return build_scene(&mesh);
}

static roberts_drawing hide(const roberts_scene *scene, const roberts_camera *camera, bool keep_hidden)
{
    roberts_hide_options options = roberts_hide_options_default();
    options.keep_hidden = keep_hidden;
    return drawing_of(scene, camera, &options);
}

/* ---- right drawings -------------------------------------------------------------------------------------------- */

static void tell(void *context, const roberts_contradiction *c)
{
    if ((*(int *)context)++ < 5)
        print_message("solid %u, edge %u-%u at %.17g: drawn %d, cast %d by %d\n", (unsigned)c->solid, (unsigned)c->v0,
                      (unsigned)c->v1, c->t, (int)c->drawn, (int)c->cast, (int)c->by);
}

/* Nothing contradicts the drawing of `scene`, with hidden segments or without; at most one point in a thousand is left
 * undecided. Returns the number of points. */
static size_t check_right(const char *name, const roberts_scene *scene, const roberts_camera *camera, uint32_t rays)
{
    size_t points = 0;
    for (int keep = 0; keep < 2; keep++) {
        int told = 0;
        roberts_verify_options options = roberts_verify_options_default();
        roberts_verification found;
        roberts_error error = {0};
        roberts_drawing drawing = hide(scene, camera, keep);
        options.rays = rays;
        options.contradiction = tell;
        options.context = &told;
        if (roberts_verify(scene, camera, &drawing, &options, &found, &error) != ROBERTS_OK)
            fail_msg("%s: %s", name, error.message);
        if (found.contradictions || found.undecided * 1000 > found.points)
            fail_msg("%s, keep %d: of %zu points %zu contradict, %zu are undecided", name, keep, found.points,
                     found.contradictions, found.undecided);
        size_t rows = 0;
        for (size_t i = 0; i < drawing.count; i++)
            rows += drawing.segment[i].state != ROBERTS_CLIPPED;
        assert_true(found.points >= found.segments * (rays - 2) && found.segments >= rows); /* walks spare two */
        points += found.points;
        roberts_drawing_free(&drawing);
    }
    return points;
}

static void test_random_scenes(void **state)
{
    rng r = {1};
    size_t points = 0;
    (void)state;
    for (int i = 0; i < 60; i++) {
        roberts_scene *scene = random_scene(&r, 2 + i, rng_between(&r, 0.2, 1.5));
        roberts_camera camera = {.dir = rng_vec3(&r, 1.0)}, eye = {.projection = ROBERTS_PERSPECTIVE};
        eye.eye = vec3_scale(rng_between(&r, 6.0, 30.0) / vec3_length(camera.dir), camera.dir);
        points += check_right("orthographic", scene, &camera, 7);
        points += check_right("perspective", scene, &eye, 7);
        roberts_scene_free(scene);
    }
    assert_true(points > 100000);
}

/* Touching boxes where everything lines up; from near, the eye sees along some faces. */
static void test_bricks(void **state)
{
    static const char *const views[] = {"iso",   "dimetric", "front",  "back",     "left",
                                        "right", "top",      "bottom", "cavalier", "cabinet"};
    roberts_scene *scene = brick_scene(4, 3, 4);
    (void)state;
    for (size_t i = 0; i < COUNT(views); i++) {
        roberts_camera camera = preset_camera(views[i]);
        check_right(views[i], scene, &camera, 5);
    }
    const roberts_vec3 eyes[] = {{4, -20, 8}, {2, -20, 16}, {30, 6, 4}, {20, -20, 30}, {4.5, 4.5, 60}};
    for (size_t i = 0; i < COUNT(eyes); i++) {
        roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE, .eye = eyes[i]};
        check_right("perspective", scene, &camera, 5);
    }
    roberts_scene_free(scene);
}

/* Oblique views, and eyes amid the solids, so that the near plane cuts some. */
static void test_oblique_and_near(void **state)
{
    rng r = {7};
    size_t cut = 0;
    (void)state;
    for (int i = 0; i < 30; i++) {
        roberts_scene *scene = random_scene(&r, 10 + i, 0.4);
        roberts_camera oblique = {.dir = rng_vec3(&r, 1.0),
                                  .oblique = {rng_between(&r, -1.5, 1.5), rng_between(&r, -1.5, 1.5)}};
        roberts_camera amid = {.projection = ROBERTS_PERSPECTIVE, .eye = rng_vec3(&r, 1.0), .has_look_at = true};
        roberts_drawing drawing;
        amid.near_distance = i % 2 ? 0.0 : 0.1;
        amid.look_at = vec3_add(amid.eye, rng_vec3(&r, 1.0));
        check_right("oblique", scene, &oblique, 7);
        roberts_status status = roberts_hide(scene, &amid, NULL, &drawing, NULL);
        roberts_drawing_free(&drawing);
        if (status == ROBERTS_OK) { /* the eye may be inside a solid */
            cut++;
            check_right("amid", scene, &amid, 7);
        }
        roberts_scene_free(scene);
    }
    assert_true(cut > 10);
}

/* The same at all scales and far from the origin. */
static void test_scales(void **state)
{
    static const double scales[] = {1e-100, 1e-8, 1e8, 1e100};
    (void)state;
    for (size_t i = 0; i < COUNT(scales); i++) {
        roberts_mesh mesh = {0};
        for (int k = 0; k < 20; k++) {
            double s = scales[i], x = 1.5 * (k % 4), y = 1.25 * (k % 5), z = 0.75 * k;
            mesh_box(&mesh, (roberts_vec3){s * x, s * y, s * z},
                     (roberts_vec3){s * (x + 1.5), s * (y + 2.5), s * (z + 1.25)});
        }
        roberts_scene *scene = build_scene(&mesh);
        roberts_camera camera = preset_camera("trimetric");
        check_right("scaled", scene, &camera, 5);
        roberts_scene_free(scene);
    }
    roberts_mesh mesh = {0};
    for (int k = 0; k < 8; k++)
        mesh_box(&mesh, (roberts_vec3){1e8 + k, 1e8 + k % 2, -1e8 + k},
                 (roberts_vec3){1e8 + k + 1, 1e8 + 2, -1e8 + k + 2});
    roberts_scene *scene = build_scene(&mesh);
    roberts_camera camera = preset_camera("iso");
    check_right("far away", scene, &camera, 5);
    roberts_scene_free(scene);
}

/* ---- spoiled drawings ------------------------------------------------------------------------------------------ */

typedef struct spoiled {
    const roberts_segment *row;
    size_t here, elsewhere;
} spoiled;

static void count_spoiled(void *context, const roberts_contradiction *c)
{
    spoiled *s = context;
    if (c->solid == s->row->solid && c->v0 == s->row->v0 && c->v1 == s->row->v1)
        s->here++;
    else
        s->elsewhere++;
    assert_true(c->drawn != c->cast || (c->cast == ROBERTS_HIDDEN && c->by != c->drawn_by));
    assert_true((c->by != ROBERTS_NONE) == (c->cast == ROBERTS_HIDDEN));
}

/* The contradictions on the row's edge; there are none on others. */
static size_t find_spoiled(const roberts_scene *scene, const roberts_camera *camera, const roberts_drawing *drawing,
                           const roberts_segment *row)
{
    spoiled s = {row, 0, 0};
    roberts_verify_options options = roberts_verify_options_default();
    roberts_verification found;
    options.contradiction = count_spoiled;
    options.context = &s;
    assert_int_equal(roberts_verify(scene, camera, drawing, &options, &found, NULL), ROBERTS_OK);
    assert_int_equal(s.elsewhere, 0);
    assert_int_equal(s.here, found.contradictions);
    if (found.contradictions)
        assert_true(found.first.solid == row->solid && found.first.v0 == row->v0 && found.first.v1 == row->v1);
    return s.here;
}

/* One row of a drawing is turned from visible to hidden or back, left out, or shortened or lengthened by a hundredth.
 * This is always found, on that edge and on no other. */
static void test_spoiled_rows(void **state)
{
    rng r = {2};
    roberts_scene *scene = random_scene(&r, 5, 0.8);
    roberts_camera camera = preset_camera("dimetric");
    size_t flipped = 0, cut = 0;
    (void)state;
    for (int keep = 0; keep < 2; keep++) {
        roberts_drawing drawing = hide(scene, &camera, keep);
        for (size_t i = 0; i < drawing.count; i++) {
            roberts_segment *row = &drawing.segment[i], sound = *row;
            if (row->t1 - row->t0 < 1e-6)
                continue;
            row->state = row->state == ROBERTS_VISIBLE ? ROBERTS_HIDDEN : ROBERTS_VISIBLE;
            assert_true(find_spoiled(scene, &camera, &drawing, &sound) >= 2);
            *row = sound;
            flipped++;
            if (row->state == ROBERTS_VISIBLE) {
                row->t1 -= 0.01 * (row->t1 - row->t0); /* the end is missing: it must be hidden, and is not */
                assert_true(find_spoiled(scene, &camera, &drawing, &sound) > 0);
                *row = sound;
                cut++;
            }
            if (row->state == ROBERTS_VISIBLE && row->t1 < 1.0) {
                row->t1 = fmin(1.0, row->t1 + 0.01 * (row->t1 - row->t0)); /* goes on where it is hidden */
                assert_true(find_spoiled(scene, &camera, &drawing, &sound) > 0);
                *row = sound;
            }
            if (row->state == ROBERTS_VISIBLE) { /* left out altogether */
                memmove(row, row + 1, (drawing.count - 1 - i) * sizeof *row);
                drawing.count--;
                assert_true(find_spoiled(scene, &camera, &drawing, &sound) > 0);
                memmove(row + 1, row, (drawing.count - i) * sizeof *row);
                drawing.count++;
                *row = sound;
            }
        }
        roberts_drawing_free(&drawing);
    }
    assert_true(flipped > 100 && cut > 50);
    roberts_scene_free(scene);
}

typedef struct findings {
    roberts_contradiction item[12000];
    size_t count;
} findings;

static void keep_finding(void *context, const roberts_contradiction *c)
{
    findings *f = context;
    assert_true(f->count < COUNT(f->item));
    f->item[f->count++] = *c;
}

/* A drawing that is wrong in many places: any number of threads gives the same contradictions in the same order, by
 * edge and t. */
static void test_threads(void **state)
{
    static findings found[4];
    rng r = {5};
    roberts_scene *scene = random_scene(&r, 400, 0.2);
    roberts_camera camera = preset_camera("trimetric");
    roberts_drawing drawing = hide(scene, &camera, true);
    (void)state;
    for (size_t i = 0; i < drawing.count; i += 3)
        drawing.segment[i].state ^= 1;
    for (uint32_t threads = 0; threads < 4; threads++) {
        roberts_verify_options options = roberts_verify_options_default();
        roberts_verification result;
        options.threads = threads;
        options.contradiction = keep_finding;
        options.context = &found[threads];
        assert_int_equal(roberts_verify(scene, &camera, &drawing, &options, &result, NULL), ROBERTS_OK);
        assert_int_equal(found[threads].count, result.contradictions);
        assert_int_equal(found[threads].count, found[0].count);
    }
    assert_true(found[0].count > 1000);
    for (size_t i = 0; i < found[0].count; i++) {
        const roberts_contradiction *a = &found[0].item[i], *z = i ? a - 1 : NULL;
        for (int k = 1; k < 4; k++) {
            const roberts_contradiction *b = &found[k].item[i];
            assert_true(a->solid == b->solid && a->v0 == b->v0 && a->v1 == b->v1 && a->t == b->t && a->by == b->by &&
                        a->drawn == b->drawn && a->cast == b->cast && a->drawn_by == b->drawn_by);
        }
        if (z)
            assert_true(a->face[0] != ROBERTS_NONE || z->solid < a->solid || /* intersections come last */
                        (z->solid == a->solid && (z->v0 < a->v0 || (z->v0 == a->v0 && z->v1 < a->v1) ||
                                                  (z->v0 == a->v0 && z->v1 == a->v1 && z->t <= a->t))));
    }
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
}

/* Five copies of a box at one place, of which the tree takes two, between a box below and a smaller one inside: right,
 * and no row of any of them can be turned unnoticed. */
static void test_copies(void **state)
{
    static const uint32_t first = 1, copies = 5;
    roberts_mesh mesh = {0};
    roberts_camera camera = preset_camera("trimetric"), eye = {.projection = ROBERTS_PERSPECTIVE, .eye = {9, -8, 20}};
    size_t flipped = 0;
    (void)state;
    mesh_box(&mesh, (roberts_vec3){-1, -1, -3}, (roberts_vec3){3, 3, -1});
    for (uint32_t i = 0; i < copies; i++)
        mesh_box(&mesh, (roberts_vec3){0, 0, 0}, (roberts_vec3){2, 2, 2});
    mesh_box(&mesh, (roberts_vec3){0.5, 0.5, 0.5}, (roberts_vec3){1, 1, 1});
    roberts_scene *scene = build_scene(&mesh);
    check_right("copies", scene, &camera, 5);
    check_right("copies", scene, &eye, 5);
    roberts_drawing drawing = hide(scene, &camera, true);
    for (size_t i = 0; i < drawing.count; i++) {
        roberts_segment *row = &drawing.segment[i], sound = *row;
        row->state = row->state == ROBERTS_VISIBLE ? ROBERTS_HIDDEN : ROBERTS_VISIBLE;
        assert_true(find_spoiled(scene, &camera, &drawing, &sound) >= 2);
        *row = sound;
        flipped += row->solid >= first && row->solid < first + copies;
    }
    assert_true(flipped >= 12 * copies);
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
}

/* Long thin bars across one another, which the tree takes in slices. */
static void test_bars(void **state)
{
    rng r = {6};
    roberts_mesh mesh = {0};
    (void)state;
    for (int i = 0; i < 60; i++) {
        double angle = rng_between(&r, 0.0, 3.0), x = 50 * cos(angle), y = 50 * sin(angle);
        roberts_vec3 o = {-x / 2 + rng_between(&r, -5, 5), -y / 2 + rng_between(&r, -5, 5), i};
        mesh_block(&mesh, o, (roberts_vec3){x, y, rng_between(&r, -0.2, 0.2)}, (roberts_vec3){-y / 200, x / 200, 0},
                   (roberts_vec3){0, 0, 0.5});
    }
    roberts_scene *scene = build_scene(&mesh);
    roberts_camera camera = preset_camera("top"), iso = preset_camera("iso"),
                   eye = {.projection = ROBERTS_PERSPECTIVE, .eye = {9, 8, 200}};
    assert_true(check_right("bars", scene, &camera, 5) > 20000);
    check_right("bars", scene, &iso, 5);
    check_right("bars", scene, &eye, 5);
    roberts_scene_free(scene);
}

/* Makes the longest segment of a solid in the picture hidden where it is visible, and visible where it is hidden. */
static bool turn_longest(roberts_drawing *drawing, uint32_t solid)
{
    roberts_segment *longest = NULL;
    double most = 0.0;
    for (size_t i = 0; i < drawing->count; i++) {
        roberts_segment *s = &drawing->segment[i];
        double length = hypot(s->p1.x - s->p0.x, s->p1.y - s->p0.y);
        if (s->solid == solid && s->state != ROBERTS_CLIPPED && length > most) {
            most = length;
            longest = s;
        }
    }
    if (longest)
        longest->state = longest->state == ROBERTS_VISIBLE ? ROBERTS_HIDDEN : ROBERTS_VISIBLE;
    return longest != NULL;
}

/* Edges that cross something in contact with them, within rounding of a tested point: a block turned by 9e-12, seen
 * along the border of another; a cube so far from the eye that its corners are within rounding of its faces; one of
 * which the near plane leaves 1.4e-13. */
static void test_crossed_in_contact(void **state)
{
    const double a = 2.8565979351453e-11, b = 9.0766838716902e-12, s = 1e-4;
    const roberts_vec3 near_corner = {1.3990399113483668e-13, 1.9999999999996403, 2.3924281859855957e-13};
    const struct {
        const char *name;
        roberts_vec3 o[2], u[2], v[2], w;
        roberts_camera camera;
    } table[] = {
        {"nearly along a border",
         {{-5 - a / 3, -2 + a, 86.75}, {-3 + b, -b, 87.75}},
         {{6, -2 * a, 0}, {2, 2 * b, 0}},
         {{2 * a / 3, 2, 0}, {-2 * b, 2, 0}},
         {0, 0, 0.5},
         {ROBERTS_PERSPECTIVE, .eye = {0.99999999993334487, -8.0000000000285656, 85.75}, .look_at = {5, 2, 56},
          .has_look_at = true, .fov_degrees = 22}},
        {"far eye",
         {{0, 0, 0}, {9 * s, 0, 0}},
         {{s, 0, 0}, {s, 0, 0}},
         {{0, s, 0}, {0, s, 0}},
         {0, 0, s},
         {ROBERTS_PERSPECTIVE, .eye = {5e7, -4e7, 2e7}}},
        {"cut to a sliver",
         {near_corner, {9, 2, 0}},
         {{1, 0, 0}, {1, 0, 0}},
         {{0, 2, 0}, {0, 2, 0}},
         {0, 0, 1},
         {ROBERTS_PERSPECTIVE, .eye = {-0.5, 4, 2}, .look_at = {2, 4, 2}, .has_look_at = true, .near_distance = 1.5}},
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_mesh mesh = {0};
        for (int k = 0; k < 2; k++)
            mesh_block(&mesh, table[i].o[k], table[i].u[k], table[i].v[k], table[i].w);
        roberts_scene *scene = build_scene(&mesh);
        for (int keep = 0; keep < 2; keep++) { /* here many points are undecided */
            roberts_drawing drawing = hide(scene, &table[i].camera, keep);
            roberts_verification found;
            assert_int_equal(roberts_verify(scene, &table[i].camera, &drawing, NULL, &found, NULL), ROBERTS_OK);
            if (found.contradictions)
                fail_msg("%s, keep %d: %zu of %zu points", table[i].name, keep, found.contradictions, found.points);
            if (keep) { /* of the first block the near plane may leave a sliver, all of which is contact */
                assert_true(turn_longest(&drawing, 1));
                assert_int_equal(roberts_verify(scene, &table[i].camera, &drawing, NULL, &found, NULL), ROBERTS_OK);
                if (found.contradictions == 0)
                    fail_msg("%s: a wrong segment is not found", table[i].name);
            }
            roberts_drawing_free(&drawing);
        }
        roberts_scene_free(scene);
    }
}

/* A block's side whose picture is a sliver, 3.8e-9 wide and not narrow across its plane, is edge-on where epsilon is
 * more: then an edge of it is at the back. */
static void test_sliver(void **state)
{
    static const roberts_vec3 o = {131.23693562270955, 265.66161015973069, 145.47584033955607};
    static const roberts_vec3 u = {3.24456217511761, -2.14010778934123, 0.0},
                              v = {1.12702626623627, 1.70867597596294, 0.0};
    (void)state;
    for (int i = 0; i < 3; i++) {
        const double epsilon[] = {1e-10, 3.9e-9, 1e-8};
        roberts_mesh mesh = {0};
        mesh_block(&mesh, o, u, v, (roberts_vec3){0, 0, 0.000790569414});
        mesh_block(&mesh, (roberts_vec3){130.517223, 268.619390, 147.020613}, (roberts_vec3){0.757015, -3.583583, 0},
                   (roberts_vec3){2.208371, 0.466508, 0}, (roberts_vec3){0, 0, 0.000790569414});
        roberts_scene *scene = build_scene(&mesh);
        roberts_camera camera = {.dir = {.31, .47, .83}, .up = {0, 0, 1}};
        roberts_hide_options options = roberts_hide_options_default();
        roberts_verification result;
        options.epsilon = epsilon[i];
        roberts_drawing drawing = drawing_of(scene, &camera, &options);
        assert_int_equal(roberts_verify(scene, &camera, &drawing, NULL, &result, NULL), ROBERTS_OK);
        assert_true(result.points > 0);
        assert_int_equal(result.contradictions, 0);
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
}

/* Up to a hundredth of the scene counts as touching. Parts of an edge or a face lost in this way are no
 * contradiction. */
static void test_wide_epsilon(void **state)
{
    rng r = {5};
    size_t points = 0, undecided = 0;
    (void)state;
    for (int i = 0; i < 40; i++) {
        roberts_scene *scene = random_scene(&r, 30, rng_between(&r, 0.2, 1.0));
        roberts_camera camera = {.dir = rng_vec3(&r, 1.0)};
        roberts_hide_options options = roberts_hide_options_default();
        roberts_verify_options verify = roberts_verify_options_default();
        roberts_verification found;
        int told = 0;
        options.epsilon = pow(10.0, -2.0 - i % 5);
        options.keep_hidden = i & 1;
        verify.rays = 7;
        verify.contradiction = tell;
        verify.context = &told;
        roberts_drawing drawing = drawing_of(scene, &camera, &options);
        assert_int_equal(roberts_verify(scene, &camera, &drawing, &verify, &found, NULL), ROBERTS_OK);
        if (found.contradictions)
            fail_msg("epsilon %g: %zu points contradict", options.epsilon, found.contradictions);
        points += found.points;
        undecided += found.undecided;
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
    print_message("%zu points, %zu undecided\n", points, undecided);
    assert_true(points > 20000 && undecided < points / 4);
}

/* The rule itself, by hand: what two boxes do to the top edge of a third. The drawing shows all of it as visible;
 * `wrong` says whether that is contradicted. The edge runs from (0, 0, 0) to (8, 0, 0) and is seen from above; the
 * occluder is the box from `lo` to `hi`. */
static const struct {
    const char *name;
    roberts_vec3 lo, hi;
    bool wrong;
} rule_cases[] = {
    {"over the edge", {2, -1, 1}, {6, 1, 2}, true},
    {"over all of it", {-1, -1, 1}, {9, 1, 2}, true},
    {"below it", {2, -9, -9}, {6, 1, -8}, false},
    {"beside it", {2, 1, 1}, {6, 2, 2}, false},
    {"along its border: closed in projection", {2, 0, 1}, {6, 2, 2}, true},
    {"along its border, within rounding", {2, 1e-15, 1}, {6, 2, 2}, true},
    {"off its border by more than epsilon", {2, 1e-8, 1}, {6, 2, 2}, false},
    {"inside its border by less than epsilon: either may be right", {2, -1e-10, 1}, {6, 2, 2}, false},
    {"inside its border by more than epsilon", {2, -1e-8, 1}, {6, 2, 2}, true},
    {"in the plane of the top face: strict in depth", {2, -1, -1}, {6, 1, 0}, false},
    {"above by rounding", {2, -1, -1}, {6, 1, 1e-15}, false},
    {"above by more than epsilon", {2, -1, -1}, {6, 1, 1e-8}, true},
    {"standing on it", {2, -1, 0}, {6, 1, 1}, true},
    {"the edge pierces it", {2, -1, -1}, {6, 1, 1}, true},
    {"ends at the edge's start", {-3, -1, 1}, {0, 1, 2}, false},
    {"a corner over the edge, at one point", {8, 0, 1}, {9, 1, 2}, false},
};

static void count_on_edge(void *context, const roberts_contradiction *c)
{
    *(size_t *)context += c->solid == 0 && c->v0 == 6 && c->v1 == 7;
}

static void test_rule(void **state)
{
    roberts_camera camera = preset_camera("top");
    (void)state;
    for (size_t i = 0; i < COUNT(rule_cases); i++) {
        roberts_mesh mesh = {0};
        roberts_verification found;
        mesh_box(&mesh, (roberts_vec3){0, -8, -8}, (roberts_vec3){8, 0, 0}); /* the edge is 6-7 */
        mesh_box(&mesh, rule_cases[i].lo, rule_cases[i].hi);
        roberts_scene *scene = build_scene(&mesh);
        roberts_segment row = {.solid = 0, .v0 = 6, .v1 = 7, .t0 = 0, .t1 = 1, .by = ROBERTS_NONE};
        roberts_drawing drawing = {.count = 1, .segment = &row};
        roberts_verify_options options = roberts_verify_options_default();
        size_t wrong = 0;
        options.rays = 33;
        options.contradiction = count_on_edge; /* missing rows of other edges do not matter here */
        options.context = &wrong;
        assert_int_equal(roberts_verify(scene, &camera, &drawing, &options, &found, NULL), ROBERTS_OK);
        if ((wrong > 0) != rule_cases[i].wrong)
            fail_msg("%s: %zu contradictions, %zu undecided", rule_cases[i].name, wrong, found.undecided);
        roberts_scene_free(scene);
    }
}

/* A corner exactly over the middle of the edge hides a single point, which has no length. This is undecided, not a
 * contradiction. */
static void test_corner_over_edge(void **state)
{
    roberts_camera camera = preset_camera("top");
    roberts_mesh mesh = {0};
    roberts_verification found;
    size_t wrong = 0;
    (void)state;
    mesh_box(&mesh, (roberts_vec3){0, -8, -8}, (roberts_vec3){8, 0, 0}); /* the edge is 6-7 */
    mesh_block(&mesh, (roberts_vec3){4, 0, 1}, (roberts_vec3){2, 2, 0}, (roberts_vec3){-2, 2, 0},
               (roberts_vec3){0, 0, 1});
    roberts_scene *scene = build_scene(&mesh);
    roberts_segment row = {.solid = 0, .v0 = 6, .v1 = 7, .t0 = 0, .t1 = 1, .by = ROBERTS_NONE};
    roberts_drawing drawing = {.count = 1, .segment = &row};
    roberts_verify_options options = roberts_verify_options_default();
    options.rays = 1;
    options.contradiction = count_on_edge;
    options.context = &wrong;
    assert_int_equal(roberts_verify(scene, &camera, &drawing, &options, &found, NULL), ROBERTS_OK);
    assert_int_equal(wrong, 0);
    assert_int_equal(found.undecided, 1);
    roberts_scene_free(scene);
}

static void test_bad_drawings(void **state)
{
    static const roberts_segment rows[] = {
        {.solid = 9, .v0 = 0, .v1 = 1, .t0 = 0, .t1 = 1},
        {.solid = 0, .v0 = 1, .v1 = 0, .t0 = 0, .t1 = 1},
        {.solid = 0, .v0 = 0, .v1 = 7, .t0 = 0, .t1 = 1},
        {.solid = 0, .v0 = 0, .v1 = 1, .t0 = 0.5, .t1 = 0.5},
        {.solid = 0, .v0 = 0, .v1 = 1, .t0 = -0.5, .t1 = 0.5},
        {.solid = 0, .v0 = 0, .v1 = 1, .t0 = 0.5, .t1 = 1.5},
        {.solid = 0, .v0 = 0, .v1 = 1, .t0 = NAN, .t1 = 1},
        {.solid = 0, .v0 = 0, .v1 = 1, .t0 = 0, .t1 = 1, .state = 7},
    };
    roberts_scene *scene = brick_scene(1, 1, 1);
    roberts_camera camera = preset_camera("iso"), blind = {0};
    roberts_verification found;
    roberts_error error = {0};
    (void)state;
    for (size_t i = 0; i < COUNT(rows); i++) {
        roberts_segment row = rows[i];
        roberts_drawing drawing = {.count = 1, .segment = &row};
        assert_int_equal(roberts_verify(scene, &camera, &drawing, NULL, &found, &error), ROBERTS_BAD_ARGUMENT);
        assert_true(strlen(error.message) > 0);
    }
    roberts_drawing empty = {0};
    assert_int_equal(roberts_verify(scene, &blind, &empty, NULL, &found, &error), ROBERTS_BAD_VIEW);
    assert_int_equal(roberts_verify(scene, &camera, &empty, NULL, &found, &error), ROBERTS_OK);
    assert_true(found.contradictions == 18); /* 9 edges of the box can be seen and are missing: a ray and a walk each */
    roberts_scene_free(scene);
}

/* ---- pick ------------------------------------------------------------------------------------------------------ */

/* Solid 0: 4 x 4 x 1 at the bottom; solid 1: 2 x 2 x 1 on it; solid 2 beside them, as high as both. Seen from the top
 * the picture's origin is (4, 2), the middle of the scene, which is at height 1. */
static const struct {
    const char *name;
    double x, y;
    size_t count;
    struct {
        uint32_t solid, face;
        double depth;
    } hit[3];
} pick_cases[] = {
    {"on the low box", -3.5, -1.5, 1, {{0, 1, 0}}},
    {"on the box that stands on it", -2, 0, 2, {{1, 7, 1}, {0, 1, 0}}},
    {"on its border", -1, 0, 2, {{1, 7, 1}, {0, 1, 0}}},
    {"on its corner", -3, 1, 2, {{1, 7, 1}, {0, 1, 0}}},
    {"beside all", 0.5, 0, 0, {{0}}},
    {"on the other box", 2, 1, 1, {{2, 13, 1}}},
    {"on the outer border", 4, 2, 1, {{2, 13, 1}}},
    {"just off it", 4.000001, 2, 0, {{0}}},
    {"on the middle of the edge between two faces", -4, 0, 1, {{0, 1, 0}}},
};

static void test_pick_table(void **state)
{
    roberts_mesh mesh = {0};
    roberts_camera camera = preset_camera("top");
    (void)state;
    mesh_box(&mesh, (roberts_vec3){0, 0, 0}, (roberts_vec3){4, 4, 1});
    mesh_box(&mesh, (roberts_vec3){1, 1, 1}, (roberts_vec3){3, 3, 2});
    mesh_box(&mesh, (roberts_vec3){5, 1, 0}, (roberts_vec3){8, 4, 2});
    roberts_scene *scene = build_scene(&mesh);
    for (size_t i = 0; i < COUNT(pick_cases); i++) {
        roberts_picked picked;
        assert_int_equal(roberts_pick(scene, &camera, pick_cases[i].x, pick_cases[i].y, &picked, NULL), ROBERTS_OK);
        if (picked.count != pick_cases[i].count)
            fail_msg("%s: %zu hits", pick_cases[i].name, picked.count);
        for (size_t k = 0; k < picked.count; k++) {
            const roberts_pick_hit *hit = &picked.hit[k];
            if (hit->solid != pick_cases[i].hit[k].solid || hit->face != pick_cases[i].hit[k].face ||
                fabs(hit->depth - pick_cases[i].hit[k].depth) > 1e-14)
                fail_msg("%s: hit %zu is solid %u, face %u at %.17g", pick_cases[i].name, k, (unsigned)hit->solid,
                         (unsigned)hit->face, hit->depth);
            assert_true(fabs(hit->point.x - 4 - pick_cases[i].x) < 1e-14);
            assert_true(fabs(hit->point.y - 2 - pick_cases[i].y) < 1e-14);
            assert_true(fabs(hit->point.z - 1 - hit->depth) < 1e-14);
        }
        roberts_picked_free(&picked);
    }
    roberts_picked picked;
    assert_int_equal(roberts_pick(scene, &camera, NAN, 0, &picked, NULL), ROBERTS_BAD_ARGUMENT);
    assert_int_equal(roberts_pick(scene, &camera, 0, INFINITY, &picked, NULL), ROBERTS_BAD_ARGUMENT);
    roberts_camera blind = {0};
    assert_int_equal(roberts_pick(scene, &blind, 0, 0, &picked, NULL), ROBERTS_BAD_VIEW);
    assert_true(picked.count == 0);
    roberts_scene_free(scene);
}

/* From the eye at height 11 over the middle of the scene, looking down. */
static void test_pick_perspective(void **state)
{
    roberts_mesh mesh = {0};
    roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE, .eye = {0, 0, 11}, .up = {0, 1, 0}};
    roberts_picked picked;
    (void)state;
    mesh_box(&mesh, (roberts_vec3){-4, -4, -1}, (roberts_vec3){4, 4, 0});
    mesh_box(&mesh, (roberts_vec3){-1, -1, 0}, (roberts_vec3){1, 1, 3}); /* the box's middle: (0, 0, 1), D = 10 */
    roberts_scene *scene = build_scene(&mesh);
    /* the tower's top, at height 3, reaches to 1 * 10 / 8 = 1.25 of the picture; behind it lies the floor */
    assert_int_equal(roberts_pick(scene, &camera, 1.2, 0, &picked, NULL), ROBERTS_OK);
    assert_int_equal(picked.count, 2);
    assert_true(picked.hit[0].solid == 1 && picked.hit[0].face == 7 && fabs(picked.hit[0].depth - 2) < 1e-14);
    assert_true(fabs(picked.hit[0].point.x - 0.96) < 1e-14 && fabs(picked.hit[0].point.z - 3) < 1e-14);
    assert_true(picked.hit[1].solid == 0 && picked.hit[1].face == 1 && fabs(picked.hit[1].depth + 1) < 1e-14);
    assert_true(fabs(picked.hit[1].point.x - 1.32) < 1e-14);
    roberts_picked_free(&picked);
    /* its foot, at height 0, would reach to 0.909...: the tower's sides are not seen from above */
    assert_int_equal(roberts_pick(scene, &camera, 1.26, 0, &picked, NULL), ROBERTS_OK);
    assert_int_equal(picked.count, 1);
    assert_true(picked.hit[0].solid == 0 && picked.hit[0].face == 1);
    roberts_picked_free(&picked);
    roberts_scene_free(scene);
}

/* The near plane, 1 below the eye, cuts the tower: looking down one sees where it is cut. */
static void test_pick_cut(void **state)
{
    roberts_mesh mesh = {0};
    roberts_camera camera = {
        .projection = ROBERTS_PERSPECTIVE, .eye = {0, 0, 4}, .up = {0, 1, 0}, .near_distance = 1.0};
    roberts_picked picked;
    (void)state;
    camera.has_look_at = true;
    mesh_box(&mesh, (roberts_vec3){-4, -4, -1}, (roberts_vec3){4, 4, 0});
    mesh_box(&mesh, (roberts_vec3){1, -1, 0}, (roberts_vec3){2, 1, 5});
    roberts_scene *scene = build_scene(&mesh);
    assert_int_equal(roberts_pick(scene, &camera, 6, 0, &picked, NULL), ROBERTS_OK); /* the tower is cut at 4 .. 8 */
    assert_int_equal(picked.count, 1);
    assert_true(picked.hit[0].solid == 1 && picked.hit[0].face == ROBERTS_NONE &&
                fabs(picked.hit[0].depth - 3) < 1e-14);
    assert_true(fabs(picked.hit[0].point.x - 1.5) < 1e-14);
    roberts_picked_free(&picked);
    assert_int_equal(roberts_pick(scene, &camera, 3.5, 0, &picked, NULL), ROBERTS_OK); /* its side, then the floor */
    assert_int_equal(picked.count, 2);
    assert_true(picked.hit[0].solid == 1 && picked.hit[0].face == 10 && picked.hit[1].solid == 0);
    roberts_picked_free(&picked);
    roberts_scene_free(scene);
}

/* Solids that touch or coincide at the same depth come by number; faces of one solid that share the point
 * count once. */
static void test_pick_ties(void **state)
{
    roberts_mesh mesh = {0};
    roberts_camera top = preset_camera("top"), iso = preset_camera("iso");
    roberts_picked picked;
    (void)state;
    for (int i = 0; i < 3; i++)
        mesh_box(&mesh, (roberts_vec3){-1, -1, -1}, (roberts_vec3){1, 1, 1 - 1e-13 * i});
    roberts_scene *scene = build_scene(&mesh);
    assert_int_equal(roberts_pick(scene, &top, 0, 0, &picked, NULL), ROBERTS_OK);
    assert_int_equal(picked.count, 3);
    for (uint32_t i = 0; i < 3; i++)
        assert_true(picked.hit[i].solid == i && picked.hit[i].face == 6 * i + 1);
    roberts_picked_free(&picked);
    /* the iso view looks at the corner (1, -1, 1), where three faces meet: z greatest, y least, x greatest */
    assert_int_equal(roberts_pick(scene, &iso, 0, 0, &picked, NULL), ROBERTS_OK);
    assert_int_equal(picked.count, 3);
    for (uint32_t i = 0; i < 3; i++)
        assert_true(picked.hit[i].solid == i && picked.hit[i].face == 6 * i + 1);
    assert_true(fabs(picked.hit[0].depth - sqrt(3.0)) < 1e-12);
    roberts_picked_free(&picked);
    roberts_scene_free(scene);
}

/* At the middle of a visible segment the edge's own solid is seen first; at that of a hidden one, solid `by`. */
static void test_pick_agrees(void **state)
{
    rng r = {3};
    size_t seen = 0, behind = 0;
    (void)state;
    for (int i = 0; i < 16; i++) {
        roberts_scene *scene = random_scene(&r, 12, 0.6);
        roberts_camera camera = {.dir = rng_vec3(&r, 1.0)};
        if (i % 2) {
            camera.projection = ROBERTS_PERSPECTIVE;
            camera.eye = vec3_scale(9.0 / vec3_length(camera.dir), camera.dir);
        }
        roberts_drawing drawing = hide(scene, &camera, true);
        for (size_t k = 0; k < drawing.count; k++) {
            const roberts_segment *row = &drawing.segment[k];
            roberts_picked picked;
            double x = (row->p0.x + row->p1.x) / 2, y = (row->p0.y + row->p1.y) / 2;
            if (row->t1 - row->t0 < 1e-3 || row->line == ROBERTS_INTERSECTION) /* there two solids are at one depth */
                continue;
            assert_int_equal(roberts_pick(scene, &camera, x, y, &picked, NULL), ROBERTS_OK);
            if (row->state == ROBERTS_VISIBLE) {
                assert_true(picked.count && picked.hit[0].solid == row->solid);
                seen++;
            } else if (camera.projection ==
                       ROBERTS_ORTHOGRAPHIC) { /* otherwise the middle of t is not that of the picture */
                assert_true(picked.count && picked.hit[0].solid == row->by);
                behind++;
            }
            for (size_t j = 1; j < picked.count; j++)
                assert_true(picked.hit[j - 1].depth >= picked.hit[j].depth);
            roberts_picked_free(&picked);
        }
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
    assert_true(seen > 800 && behind > 500);
}

/* ---- the tree of boxes ----------------------------------------------------------------------------------------- */

/* Boxes, and points that are looked for in them together. */
typedef struct tree_trial {
    const box3 *box;
    roberts_vec3 point[TREE_POINTS];
    uint32_t skip[TREE_POINTS]; /* the owner that each point skips */
    uint32_t count, points;     /* how many boxes and points */
} tree_trial;

/* What a walk of some points together finds: each box that the kernel's slab test meets above a point, once; those of
 * the owner that the point skips may be missing. Point `gone` is dropped at the first leaf: nothing is found for it
 * after. Every third leaf is kept for the next walk, which finds it first, and a second time. */
static size_t check_walk(tree_walk *walk, const tree_trial *t, uint32_t gone)
{
    static unsigned char found[TREE_POINTS][500];
    uint32_t kept = walk->kept_count, leaves = 0;
    tree_points p = {0};
    tree_leaf leaf;
    size_t extra = 0;
    memset(found, 0, sizeof found);
    for (uint32_t i = 0; i < t->points; i++)
        tree_points_add(&p, t->point[i], t->skip[i]);
    tree_walk_start(walk, &p);
    for (bool first = true; tree_walk_next(walk, &leaf); first = false) {
        assert_true(!tree_set_is_empty(&leaf.points) && leaf.item_count > 0);
        while (!tree_set_is_empty(&leaf.points)) {
            uint32_t point_found = tree_set_take(&leaf.points);
            assert_true(point_found < t->points);
            for (uint32_t i = 0; i < leaf.item_count; i++) {
                assert_int_equal(leaf.item[i].count, 1);
                assert_true(found[point_found][leaf.item[i].first]++ <= (kept > 0));
            }
            assert_true(first || point_found != gone);
        }
        if (first && gone < t->points)
            tree_points_drop(&p, gone);
        if (leaves++ % 3 == 0)
            tree_walk_keep(walk);
    }
    for (uint32_t i = 0; i < t->points; i++) {
        for (uint32_t k = 0; k < t->count; k++) {
            roberts_span span;
            bool met = roberts_ray_box((roberts_ray){t->point[i], {0, 0, 1}}, t->box[k].lo, t->box[k].hi, &span);
            if (met && k / 50 != t->skip[i] && i != gone)
                assert_true(found[i][k] >= 1);
            extra += found[i][k] && !met;
        }
    }
    return extra;
}

/* The boxes, each fifty an owner's, against random points and some on borders, one at a time and many together. At most
 * `more` boxes per point are found needlessly: neighbours in a leaf. */
static void check_tree(const box3 *box, uint32_t count, rng *r, int walks, size_t more)
{
    static tree_entry entry[500];
    tree_trial trial = {.box = box, .count = count};
    static tree_walk walk;
    tree t;
    size_t extra = 0, rays = 0;
    for (uint32_t i = 0; i < count; i++)
        entry[i] = tree_entry_of(box[i], i / 50, (tree_item){i, 1});
    assert_true(tree_build(&t, entry, count));
    for (int i = 0; i < walks; i++) {
        trial.points = i % 3 ? 1 : 1 + (uint32_t)(i * 37) % TREE_POINTS;
        double near = i % 6 ? 2.0 : 0.25; /* all over the scene, or close together */
        roberts_vec3 middle = rng_vec3(r, 2.0 - near);
        for (uint32_t k = 0; k < trial.points; k++, rays++) {
            trial.point[k] = vec3_add(middle, rng_vec3(r, near));
            trial.skip[k] = rays % 3 ? 99 : (uint32_t)rays % 10;
            if (rays % 7 == 0 && count)
                trial.point[k] =
                    rays % 2 ? box[(uint32_t)rays % count].lo : box[(uint32_t)rays % count].hi; /* on borders */
        }
        if (i % 5 == 0)
            tree_walk_init(&walk, &t);
        extra += check_walk(&walk, &trial, i % 2 ? trial.points / 2 : trial.points);
    }
    assert_true(extra <= more * rays);
    tree_free(&t);
}

static void test_tree(void **state)
{
    enum { MANY = 500 };
    static box3 box[MANY];
    rng r = {4};
    (void)state;
    check_tree(box, 0, &r, 10, 0);
    for (int k = 0; k < MANY; k++) { /* some flat, some points */
        roberts_vec3 a = rng_vec3(&r, 1.5),
                     size = {rng_between(&r, 0, 0.5), k % 3 ? rng_between(&r, 0, 0.5) : 0, k % 7 ? 0.25 : 0};
        box[k] = (box3){a, vec3_add(a, size)};
    }
    for (uint32_t count = 1; count <= MANY; count += count < 10 ? 1 : 49)
        check_tree(box, count, &r, 200, 1);
    for (int k = 0; k < MANY; k++) /* all in one place: nothing to split by */
        box[k] = (box3){{-1, -1, -1}, {1, 1, 1}};
    check_tree(box, MANY, &r, 100, 0);
    for (int k = 0; k < MANY; k++) { /* each a quarter as large as the last: no good plane, the depth has to end,
                                        and most are nothing in single precision */
        double s = ldexp(1.0, -2 * k);
        box[k] = (box3){{s, s, s}, {2 * s, 2 * s, 2 * s}};
    }
    check_tree(box, MANY, &r, 100, 60);
    for (int k = 0; k < MANY;
         k++) { /* some reach out of single precision, or have no end at all, on both sides or on one */
        roberts_vec3 a = rng_vec3(&r, 1.5),
                     size = {rng_between(&r, 0, 0.5), rng_between(&r, 0, 0.5), rng_between(&r, 0, 0.5)};
        double far = k % 2 ? 1e300 : INFINITY;
        box[k] = (box3){a, vec3_add(a, size)};
        double *lo[] = {&box[k].lo.x, &box[k].lo.y, &box[k].lo.z}, *hi[] = {&box[k].hi.x, &box[k].hi.y, &box[k].hi.z};
        if (k % 9 < 3)
            *lo[k % 9] = -far;
        if (k % 7 < 3)
            *hi[k % 7] = far;
    }
    check_tree(box, MANY, &r, 100, 5);
}

/* ---- what fails ------------------------------------------------------------------------------------------------ */

/* An error of no file says so, whatever the caller's struct held before. */
static void failures_name_no_file(void **state)
{
    const roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE, .fov_degrees = -1.0};
    roberts_scene *scene = brick_scene(1, 1, 1);
    roberts_drawing drawing = {0};
    roberts_region_list regions;
    roberts_verification found;
    roberts_picked picked;
    roberts_vec2 low, high;
    bool framed;
    (void)state;
    for (int i = 0; i < 6; i++) {
        roberts_error error;
        memset(&error, 'x', sizeof error);
        roberts_status status = i == 0   ? roberts_hide(scene, &camera, NULL, &drawing, &error)
                                : i == 1 ? roberts_hide_with_regions(scene, &camera, NULL, &drawing, &regions, &error)
                                : i == 2 ? roberts_regions(scene, &camera, NULL, &regions, &error)
                                : i == 3 ? roberts_window(scene, &camera, &low, &high, &framed, &error)
                                : i == 4 ? roberts_pick(scene, &camera, 0.0, 0.0, &picked, &error)
                                         : roberts_verify(scene, &camera, &drawing, NULL, &found, &error);
        assert_int_equal(status, ROBERTS_BAD_VIEW);
        assert_int_equal(error.status, ROBERTS_BAD_VIEW);
        assert_string_equal(error.file, "");
    }
    roberts_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_scenes),
        cmocka_unit_test(test_bricks),
        cmocka_unit_test(test_scales),
        cmocka_unit_test(test_spoiled_rows),
        cmocka_unit_test(test_oblique_and_near),
        cmocka_unit_test(test_pick_cut),
        cmocka_unit_test(test_threads),
        cmocka_unit_test(test_copies),
        cmocka_unit_test(test_bars),
        cmocka_unit_test(test_crossed_in_contact),
        cmocka_unit_test(test_sliver),
        cmocka_unit_test(test_wide_epsilon),
        cmocka_unit_test(test_rule),
        cmocka_unit_test(test_corner_over_edge),
        cmocka_unit_test(test_bad_drawings),
        cmocka_unit_test(test_pick_table),
        cmocka_unit_test(test_pick_perspective),
        cmocka_unit_test(test_pick_ties),
        cmocka_unit_test(test_pick_agrees),
        cmocka_unit_test(test_tree),
        cmocka_unit_test(failures_name_no_file),
    };
    return cmocka_run_group_tests_name("verify", tests, NULL, NULL);
}
