/* test_verify_spoiled.c - drawings spoiled in one place at a time: --verify finds each fault that can be seen, and none
 * in the drawing as it was. */
#include "roberts.h"
#include "scenes.h"
#include "segments.h"

#define COUNT(a) (sizeof(a) / sizeof(a)[0])

enum { ROUNDS = 8, TRIES = 6 }; /* scenes of a family; faults of a kind in one drawing */

/* ---- scenes ---------------------------------------------------------------------------------------------------- */

/* From BLOCKS on: bodies that are not convex. */
typedef enum family { CROWD, LATTICE, BALLS, COINS, WALL, DIGITS, BLOCKS, TORI, TERRAIN, STARS, FAMILIES } family;

static const char *const family_names[FAMILIES] = {"crowd",  "lattice", "balls", "coins",   "wall",
                                                   "digits", "blocks",  "tori",  "terrain", "stars"};

static roberts_vec3 random_place(rng *r)
{
    return (roberts_vec3){rng_between(r, -1, 3), rng_between(r, -1, 3), rng_between(r, -1, 3)};
}

/* An L of depth 1, its vertices turned by `map`. */
static void add_l_block(model *m, mat3 map, roberts_vec3 offset)
{
    static const double outline[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    uint32_t first = (uint32_t)m->mesh.vertex_count, low[6], high[6];
    for (uint32_t i = 0; i < 12; i++) {
        roberts_vec3 p = {outline[i % 6][0], outline[i % 6][1], i / 6};
        model_vertex(m, vec3_add(offset, mat3_map(map, p)));
    }
    for (uint32_t i = 0; i < 6; i++) {
        low[i] = first + 5 - i;
        high[i] = first + 6 + i;
        uint32_t next = (i + 1) % 6;
        model_face(m, (uint32_t[]){first + i, first + next, first + 6 + next, first + 6 + i}, 4);
    }
    model_face(m, low, 6);
    model_face(m, high, 6);
    model_close_solid(m);
}

/* A torus of 2 x 9 x 6 triangles. */
static void add_torus(model *m, mat3 map, roberts_vec3 offset)
{
    enum { ROUND = 9, ACROSS = 6 };
    uint32_t first = (uint32_t)m->mesh.vertex_count;
    for (int i = 0; i < ROUND; i++)
        for (int k = 0; k < ACROSS; k++) {
            double a = 6.283185307179586 * i / ROUND, b = 6.283185307179586 * k / ACROSS, far = 1.2 + 0.5 * cos(b);
            roberts_vec3 p = {far * cos(a), far * sin(a), 0.5 * sin(b)};
            model_vertex(m, vec3_add(offset, mat3_map(map, p)));
        }
    for (uint32_t i = 0; i < ROUND; i++)
        for (uint32_t k = 0; k < ACROSS; k++) {
            uint32_t j = (i + 1) % ROUND, l = (k + 1) % ACROSS;
            uint32_t a = first + i * ACROSS + k, b = first + j * ACROSS + k;
            uint32_t c = first + j * ACROSS + l, d = first + i * ACROSS + l;
            model_face(m, (uint32_t[]){a, b, c}, 3);
            model_face(m, (uint32_t[]){a, c, d}, 3);
        }
    model_close_solid(m);
}

/* An open sheet of squares, each bent along a diagonal. */
static void add_terrain(model *m, rng *r)
{
    enum { SIDE = 8 };
    uint32_t first = (uint32_t)m->mesh.vertex_count;
    for (int i = 0; i < SIDE * SIDE; i++)
        model_vertex(m, (roberts_vec3){0.7 * (i % SIDE) - 1.5, 0.7 * (i / SIDE) - 1.5, rng_between(r, 0, 2)});
    for (uint32_t i = 0; i + 1 < SIDE; i++)
        for (uint32_t k = 0; k + 1 < SIDE; k++) {
            uint32_t a = first + i * SIDE + k;
            model_face(m, (uint32_t[]){a, a + 1, a + SIDE + 1}, 3);
            model_face(m, (uint32_t[]){a, a + SIDE + 1, a + SIDE}, 3);
        }
    model_close_solid(m);
}

/* The small stellated dodecahedron: about each corner of an icosahedron its five neighbours, every other one. */
static void add_star(model *m, mat3 map, roberts_vec3 offset)
{
    const double golden = 1.6180339887498949;
    uint32_t first = (uint32_t)m->mesh.vertex_count;
    roberts_vec3 p[12];
    for (int i = 0; i < 12; i++) {
        double a = i & 1 ? -1.0 : 1.0, b = i & 2 ? -golden : golden;
        p[i] = i / 4 == 0 ? (roberts_vec3){0, a, b} : i / 4 == 1 ? (roberts_vec3){a, b, 0} : (roberts_vec3){b, 0, a};
        model_vertex(m, vec3_add(offset, mat3_map(map, p[i])));
    }
    for (int i = 0; i < 12; i++) {
        uint32_t corner[5];
        int at = -1, before = -1;
        for (int k = 0; k < 5; k++) { /* two corners are `golden` edges apart where they are next but one */
            int next = 0;
            for (; next < 12; next++) {
                double from_axis = vec3_length(vec3_sub(p[next], p[i]));
                double step = at < 0 ? 2.0 * golden : vec3_length(vec3_sub(p[next], p[at]));
                if (fabs(from_axis - 2.0) < 0.1 && fabs(step - 2.0 * golden) < 0.1 && next != before)
                    break;
            }
            before = at;
            at = next;
            corner[k] = first + (uint32_t)next;
        }
        model_face(m, corner, 5);
    }
    model_close_solid(m);
}

static void add_bodies(model *m, family which, rng *r)
{
    mat3 map;
    switch (which) {
    case BLOCKS:
        for (int i = 0; i < 8; i++) { /* every other one stands on another one */
            map = i % 2 ? mat3_turn(r) : mat3_scale(1, 1, 1);
            roberts_vec3 at = random_place(r);
            add_l_block(m, map, i % 2 ? at : (roberts_vec3){floor(at.x), floor(at.y), i / 2});
        }
        break;
    case TORI:
        for (int i = 0; i < 3; i++) {
            map = mat3_turn(r);
            add_torus(m, map, random_place(r));
        }
        break;
    case TERRAIN:
        add_terrain(m, r);
        model_box(m, (roberts_vec3){0, 0, -1}, (roberts_vec3){1, 1, 3});
        break;
    default:
        for (int i = 0; i < 3; i++) {
            map = mat3_turn(r);
            add_star(m, map, random_place(r));
        }
        break;
    }
}

static roberts_scene *build_family(family which, uint64_t seed)
{
    rng r = {seed};
    model m = {0};
    switch (which) {
    case CROWD:
        model_crowd(&m, 12, 5, seed);
        break;
    case LATTICE:
        model_lattice(&m, 3, 0.7, seed);
        break;
    case BALLS:
        model_balls(&m, 2, 0.9, seed);
        break;
    case COINS: /* faces of many corners */
        for (int i = 0; i < 6; i++)
            model_round(&m, 80, false, mat3_times(mat3_turn(&r), mat3_scale(1, 0.7, 0.1)),
                        (roberts_vec3){rng_between(&r, -1, 1), rng_between(&r, -1, 1), i});
        break;
    case WALL:
        model_wall(&m, 5, 5);
        model_box(&m, (roberts_vec3){3.5, -2, 1.5}, (roberts_vec3){4.25, 4, 2.75});
        break;
    case DIGITS:
        model_lattice(&m, 3, 0.7, seed);
        model_to_digits(&m, 6);
        break;
    default:
        add_bodies(&m, which, &r);
        break;
    }
    roberts_scene *scene = model_build(&m);
    model_free(&m);
    return scene;
}

/* Parallel, from an eye outside, and from one in between, by turns. */
static roberts_camera camera_for(rng *r, int round)
{
    roberts_camera camera = {.dir = {rng_between(r, -1, 1), rng_between(r, -1, 1), rng_between(r, -1, 1)}};
    if (round % 3 == 0)
        return camera;
    double far = round % 3 == 1 ? 20.0 : 9.0;
    camera.projection = ROBERTS_PERSPECTIVE;
    camera.eye = vec3_add(vec3_scale(far / vec3_length(camera.dir), camera.dir), (roberts_vec3){1, 1, 1});
    camera.look_at = (roberts_vec3){1, 1, 1};
    camera.has_look_at = true;
    camera.near_distance = round % 3 == 1 ? 0.0 : 8.0;
    return camera;
}

/* ---- faults ---------------------------------------------------------------------------------------------------- */

typedef enum fault {
    END_1E3, /* an end is moved by a thousandth of the edge, */
    END_1E4, /* ... by 1e-4 of it, */
    END_1E6, /* ... by 1e-6 of it */
    NAME,    /* another solid is named */
    GAP,     /* a visible part between two hidden ones is drawn as hidden */
    OVERLAY, /* a hidden part between two visible ones is drawn as visible */
    MISSING, /* a visible part is left out */
    FAULTS
} fault;

static const char *const fault_names[FAULTS] = {"end off by 1e-3", "end off by 1e-4",  "end off by 1e-6", "wrong by",
                                                "gap swallowed",   "hider overlooked", "left out"};

static void drop_rows(roberts_drawing *drawing, size_t first, size_t count)
{
    roberts_segment *row = drawing->segment;
    memmove(row + first, row + first + count, (drawing->count - first - count) * sizeof *row);
    drawing->count -= count;
}

/* Moves the end that row i shares with the next one, either way. Without hidden rows the next one is a gap. */
static bool move_end(roberts_drawing *drawing, size_t i, double by)
{
    roberts_segment *row = &drawing->segment[i], *next = i + 1 < drawing->count ? row + 1 : NULL;
    bool joined = next && same_edge(row, next) && next->t0 == row->t1 && next->state != ROBERTS_CLIPPED;
    double end = next && same_edge(row, next) ? next->t1 : 1.0;
    if (joined && next->state == row->state)
        return false; /* an edge of the file that comes in parts */
    if (row->t1 >= 1.0 || row->state == ROBERTS_CLIPPED || row->t1 + by <= row->t0 || row->t1 + by >= end)
        return false;
    if (!joined && row->state == ROBERTS_HIDDEN && by < 0.0)
        return false; /* a missing part counts as hidden, and it is */
    if (!joined && next && same_edge(row, next) && next->state != ROBERTS_CLIPPED && row->t1 + by >= next->t0)
        return false; /* the gap must not vanish */
    row->t1 += by;
    if (joined)
        next->t0 = row->t1;
    return true;
}

/* Whether nothing changes from one row to the next: an edge of the file comes in parts. */
static bool continues(const roberts_segment *row, const roberts_segment *next)
{
    return row->state == next->state && row->t1 == next->t0;
}

/* Joins row i with the rows before and after it, and gives it their state. Parts so short that a pen shows nothing
 * of them may be swallowed rightly. */
static bool swallow(roberts_drawing *drawing, size_t i, roberts_state what)
{
    roberts_segment *row = &drawing->segment[i];
    if (i == 0 || i + 1 >= drawing->count || row->state != what || row->t1 - row->t0 < 1e-6 ||
        !same_edge(row, row - 1) || !same_edge(row, row + 1) || row[-1].state != row[1].state ||
        row[-1].state == ROBERTS_CLIPPED || continues(row - 1, row) || continues(row, row + 1))
        return false;
    row[-1].t1 = row[1].t1;
    drop_rows(drawing, i, 2);
    return true;
}

/* Puts the fault into row i. False: this row cannot have it, and nothing has changed. */
static bool spoil(const roberts_scene *scene, roberts_drawing *drawing, size_t i, fault what, rng *r)
{
    static const double off[] = {1e-3, 1e-4, 1e-6};
    roberts_segment *row = &drawing->segment[i];
    uint32_t solids = (uint32_t)roberts_scene_solid_count(scene), other;
    switch (what) {
    case NAME:
        other = (uint32_t)rng_int(r, 0, (int)solids - 1);
        if (row->state != ROBERTS_HIDDEN || row->by == other)
            return false;
        row->by = other;
        return true;
    case GAP:
        return swallow(drawing, i, ROBERTS_VISIBLE);
    case OVERLAY:
        return swallow(drawing, i, ROBERTS_HIDDEN);
    case MISSING:
        if (row->state != ROBERTS_VISIBLE || row->t1 - row->t0 < 1e-6)
            return false;
        drop_rows(drawing, i, 1);
        return true;
    default:
        return move_end(drawing, i, rng_int(r, 0, 1) ? off[what] : -off[what]);
    }
}

/* ---- rates ----------------------------------------------------------------------------------------------------- */

typedef struct rate {
    size_t tried, found;
} rate;

/* The line that is spoiled, and whether that is found. */
typedef struct wanted {
    const roberts_drawing *drawing;
    const roberts_segment *row;
    bool found;
} wanted;

static void count_on(void *context, const roberts_contradiction *c)
{
    wanted *w = context;
    uint32_t face[2] = {ROBERTS_NONE, ROBERTS_NONE};
    if (w->row->line == ROBERTS_INTERSECTION)
        roberts_segment_faces(NULL, w->drawing, w->row, face);
    w->found = w->found || (c->solid == w->row->solid && c->v0 == w->row->v0 && c->v1 == w->row->v1 &&
                            c->face[0] == face[0] && c->face[1] == face[1]);
    assert_true(c->drawn != c->cast || (c->cast == ROBERTS_HIDDEN && c->by != c->drawn_by));
}

/* Whether a contradiction is found on the edge of `row`; row == NULL: on any. */
static bool is_found(const roberts_scene *scene, const roberts_camera *camera, const roberts_drawing *drawing,
                     const roberts_segment *row)
{
    roberts_verify_options options = roberts_verify_options_default();
    roberts_verification found;
    wanted w = {drawing, row, false};
    options.contradiction = row ? count_on : NULL;
    options.context = &w;
    assert_int_equal(roberts_verify(scene, camera, drawing, &options, &found, NULL), ROBERTS_OK);
    return row ? w.found : found.contradictions > 0;
}

/* Where the near plane cuts bodies that pass through one another, their cuts lie in one plane and each of them is seen:
 * either name is right. */
static bool cuts_meet(const roberts_scene *scene, const roberts_camera *camera)
{
    return camera->near_distance > 0.0 && roberts_scene_body_kind(scene, 0) != ROBERTS_CONVEX;
}

/* Faults of each kind in rows at random, one at a time. */
static void spoil_rows(const roberts_scene *scene, const roberts_camera *camera, const roberts_drawing *sound, rng *r,
                       rate rates[FAULTS])
{
    roberts_segment *rows = malloc(sound->count * sizeof *rows);
    assert_non_null(rows);
    for (fault what = 0; what < FAULTS; what++)
        for (int tries = 0, spoiled = 0; tries < 60 * TRIES && spoiled < TRIES; tries++) {
            roberts_drawing drawing = *sound;
            size_t i = (size_t)rng_int(r, 0, (int)sound->count - 1);
            memcpy(rows, sound->segment, sound->count * sizeof *rows);
            drawing.segment = rows;
            if (what == NAME && cuts_meet(scene, camera))
                continue;
            if (!spoil(scene, &drawing, i, what, r))
                continue;
            spoiled++;
            rates[what].tried++;
            bool found = is_found(scene, camera, &drawing, &sound->segment[i]);
            rates[what].found += found;
            if (!found)
                print_message("not found: %s, solid %u, edge %u-%u, t %.17g to %.17g\n", fault_names[what],
                              (unsigned)sound->segment[i].solid, (unsigned)sound->segment[i].v0,
                              (unsigned)sound->segment[i].v1, sound->segment[i].t0, sound->segment[i].t1);
        }
    free(rows);
}

static void check_family(family which, rate rates[FAULTS])
{
    rng r = {100 + (uint64_t)which};
    for (int round = 0; round < ROUNDS; round++) {
        roberts_scene *scene = build_family(which, 1000 * (uint64_t)which + (uint64_t)round);
        roberts_camera camera = camera_for(&r, round);
        roberts_hide_options options = roberts_hide_options_default();
        for (int keep = 0; keep < 2; keep++) {
            roberts_drawing drawing = {0};
            roberts_error error = {0};
            options.keep_hidden = keep;
            roberts_status status = roberts_hide(scene, &camera, &options, &drawing, &error);
            if (status == ROBERTS_BAD_VIEW) /* the eye is in a solid */
                continue;
            assert_int_equal(status, ROBERTS_OK);
            if (is_found(scene, &camera, &drawing, NULL))
                fail_msg("%s %d: a sound drawing is contradicted", family_names[which], round);
            spoil_rows(scene, &camera, &drawing, &r, rates);
            roberts_drawing_free(&drawing);
        }
        roberts_scene_free(scene);
    }
}

/* How many of these faults may be missed: none, except ends that are off by 1e-6. If a border crosses the edge at a
 * small angle, or if the edge is short, such a shift stays within the few epsilons in which --verify reports points as
 * undecided. (13 of 8,299 in a long run.) */
static size_t undetected(fault what, size_t tried)
{
    return what == END_1E6 ? tried / 200 : 0;
}

static void test_spoiled(void **state)
{
    rate rates[FAULTS] = {{0}};
    (void)state;
    for (family which = 0; which < FAMILIES; which++) {
        rate of[FAULTS] = {{0}};
        check_family(which, of);
        for (fault what = 0; what < FAULTS; what++) {
            print_message("%s, %s: %zu of %zu found\n", family_names[which], fault_names[what], of[what].found,
                          of[what].tried);
            rates[what].tried += of[what].tried;
            rates[what].found += of[what].found;
        }
    }
    for (fault what = 0; what < FAULTS; what++) {
        if (rates[what].found < rates[what].tried - undetected(what, rates[what].tried))
            fail_msg("%s: %zu of %zu found", fault_names[what], rates[what].found, rates[what].tried);
        assert_true(rates[what].tried > 200);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_spoiled)};
    return cmocka_run_group_tests_name("verify_spoiled", tests, NULL, NULL);
}
