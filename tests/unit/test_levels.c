/* Levels: how many layers hide a line. Scenes with probes by hand, and a count by rays. */
#include <math.h>
#include <string.h>

#include "build_scene.h"
#include "testing.h"

/* ---- scenes by hand -------------------------------------------------------------------------------------------- */

#define BOX(z0, z1) "0 0 " z0 "/4 0 " z0 "/4 4 " z0 "/0 4 " z0 "/0 0 " z1 "/4 0 " z1 "/4 4 " z1 "/0 4 " z1 "/"
#define BOX_FACES "4 0 1 2 3/4 4 5 6 7/4 0 1 5 4/4 1 2 6 5/4 2 3 7 6/4 3 0 4 7/"
#define BOX_FACES_8 "4 8 9 10 11/4 12 13 14 15/4 8 9 13 12/4 9 10 14 13/4 10 11 15 14/4 11 8 12 15/"
#define BOX_FACES_16 "4 16 17 18 19/4 20 21 22 23/4 16 17 21 20/4 17 18 22 21/4 18 19 23 22/4 19 16 20 23/"

/* A U standing on the x axis, 5 wide, 3 high and 1 thick: arms over x 0 to 1 and 4 to 5, the base up to z = 1. */
#define U_BLOCK "0 0 0/5 0 0/5 0 3/4 0 3/4 0 1/1 0 1/1 0 3/0 0 3/0 1 0/5 1 0/5 1 3/4 1 3/4 1 1/1 1 1/1 1 3/0 1 3/"
#define U_FACES                                                                                                        \
    "8 0 1 2 3 4 5 6 7/8 15 14 13 12 11 10 9 8/4 0 8 9 1/4 1 9 10 2/4 2 10 11 3/4 3 11 12 4/4 4 12 13 5/4 5 13 14 6/"  \
    "4 6 14 15 7/4 7 15 8 0/"

/* A prism over a pentagram. */
#define STAR(z)                                                                                                        \
    "0 1 " z "/-0.587785 -0.809017 " z "/0.951057 0.309017 " z "/-0.951057 0.309017 " z "/0.587785 -0.809017 " z "/"
#define STAR_FACES "5 0 1 2 3 4/5 9 8 7 6 5/4 0 1 6 5/4 1 2 7 6/4 2 3 8 7/4 3 4 9 8/4 4 0 5 9/"

enum { LINES_MOST = 4 };

/* An edge and the level of its hidden parts. */
typedef struct wanted {
    uint32_t v0, v1;
    uint16_t level; /* 0: it is not hidden anywhere */
} wanted;

static const struct {
    const char *name, *off;
    roberts_vec3 dir;
    wanted line[LINES_MOST];
} cases[] = {
    {"a box: its back edges are behind its front",
     "8 6 0/" BOX("0", "1") BOX_FACES,
     {1, -2, 3},
     {{2, 3, 1}, {4, 5, 0}}},
    {"three equal boxes, one above the other: upper rims",
     "24 18 0/" BOX("0", "1") BOX("2", "3") BOX("4", "5") BOX_FACES BOX_FACES_8 BOX_FACES_16,
     {0, 0, 1},
     {{4, 5, 2}, {12, 13, 1}, {20, 21, 0}}},
    {"lower rims are behind their own box, too",
     "24 18 0/" BOX("0", "1") BOX("2", "3") BOX("4", "5") BOX_FACES BOX_FACES_8 BOX_FACES_16,
     {0, 0, 1},
     {{0, 1, 3}, {9, 10, 2}, {18, 19, 1}}},
    {"boxes that touch: a rim on the next one's is behind that",
     "16 12 0/" BOX("0", "1") BOX("1", "2") BOX_FACES BOX_FACES_8,
     {0, 0, 1},
     {{0, 1, 2}, {4, 5, 1}, {8, 9, 1}, {12, 13, 0}}},
    {"two boxes in one place, and a wire below: each counts",
     "18 13 0/" BOX("1", "2") BOX("1", "2") "1 1 0/3 2 0/" BOX_FACES BOX_FACES_8 "2 16 17/",
     {0, 0, 1},
     {{0, 1, 2}, {8, 9, 2}, {16, 17, 2}}},
    {"three sheets, each twice as wide as the one above",
     "12 3 0/0 0 2/1 0 2/1 1 2/0 1 2/0 0 1/2 0 1/2 2 1/0 2 1/0 0 0/4 0 0/4 4 0/0 4 0/4 0 1 2 3/4 4 5 6 7/4 8 9 10 11/",
     {0, 0, 1},
     {{0, 1, 0}, {4, 5, 1}, {5, 6, 0}}},
    {"a wire behind two sheets, of which one lies the other way round, and behind one",
     "12 4 0/0 0 2/1 0 2/1 1 2/0 1 2/0 0 1/1 0 1/1 1 1/0 1 1/0.2 0.3 0/0.8 0.4 0/0.2 0.3 1.5/0.8 0.4 1.5/4 0 1 2 3/"
     "4 7 6 5 4/2 8 9/2 10 11/",
     {0, 0, 1},
     {{8, 9, 2}, {10, 11, 1}}},
    {"two sheets with a common side count each, beside it and along it",
     "10 4 0/0 0 1/1 0 1/1 1 1/0 1 1/2 0 1/2 1 1/0.2 0.3 0/0.8 0.4 0/1 0.2 0/1 0.8 0/4 0 1 2 3/4 1 4 5 2/2 6 7/2 8 9/",
     {0, 0, 1},
     {{6, 7, 1}, {8, 9, 1}}},
    {"a wire behind a U-block: behind both arms, behind the base, along the arms' border",
     "22 13 0/" U_BLOCK "-1 0.3 2/-1 0.6 2/-1 0.3 0.5/-1 0.6 0.5/-1 0 1.5/-1 0 2.5/" U_FACES "2 16 17/2 18 19/2 20 21/",
     {1, 0, 0},
     {{16, 17, 2}, {18, 19, 1}, {20, 21, 2}}},
    {"a wire between the arms", "18 11 0/" U_BLOCK "2 0.3 2/2 0.6 2/" U_FACES "2 16 17/", {1, 0, 0}, {{16, 17, 1}}},
    {"the same with all of the U's faces turned round, or some",
     "18 11 0/" U_BLOCK "2 0.3 2/2 0.6 2/8 7 6 5 4 3 2 1 0/8 15 14 13 12 11 10 9 8/4 0 8 9 1/4 2 10 9 1/4 2 10 11 3/"
     "4 3 11 12 4/4 4 12 13 5/4 6 14 13 5/4 6 14 15 7/4 7 15 8 0/2 16 17/",
     {1, 0, 0},
     {{16, 17, 1}}},
    {"an edge of a U-block behind its own arms",
     "16 10 0/" U_BLOCK U_FACES,
     {3, -0.1, 0.4},
     {{5, 13, 1}, {8, 15, 2}, {2, 10, 0}}},
    {"a wire behind a star: its middle is crossed twice, a tip once",
     "14 9 0/" STAR("0") STAR("1") "0.1 2 0.2/0.1 2 0.8/0.8 2 0.2/0.8 2 0.8/" STAR_FACES "2 10 11/2 12 13/",
     {0, -1, 0},
     {{10, 11, 2}, {12, 13, 1}}},
    {"a wire below a star: one pentagram",
     "12 8 0/" STAR("0") STAR("1") "-0.1 0.05 -1/0.1 -0.05 -1/" STAR_FACES "2 10 11/",
     {0, 0, 1},
     {{10, 11, 1}}},
};

static roberts_drawing draw_levels(const roberts_scene *scene, const roberts_camera *camera, uint32_t grid)
{
    roberts_hide_options options = roberts_hide_options_default();
    options.keep_hidden = options.levels = true;
    options.grid = grid;
    return drawing_of(scene, camera, &options);
}

/* A slash in the text stands for a newline. */
static void layers_are_counted(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[2000] = "OFF\n";
        size_t length = strlen(cases[i].off);
        assert_true(length + 5 < sizeof text);
        for (size_t k = 0; k <= length; k++)
            text[4 + k] = cases[i].off[k] == '/' ? '\n' : cases[i].off[k];
        roberts_scene *scene = scene_of_text(text);
        roberts_camera camera = {.dir = cases[i].dir};
        roberts_drawing drawing = draw_levels(scene, &camera, 0);
        print_message("%s\n", cases[i].name);
        for (int n = 0; n < LINES_MOST && cases[i].line[n].v1; n++) {
            const wanted *line = &cases[i].line[n];
            size_t rows = 0, hidden = 0;
            for (size_t k = 0; k < drawing.count; k++) {
                const roberts_segment *s = &drawing.segment[k];
                if (s->v0 != line->v0 || s->v1 != line->v1)
                    continue;
                rows++;
                hidden += s->state == ROBERTS_HIDDEN;
                if (s->state == ROBERTS_HIDDEN && s->level != line->level)
                    fail_msg("%u-%u: level %u instead of %u", line->v0, line->v1, s->level, line->level);
            }
            assert_true(rows > 0);
            assert_int_equal(hidden > 0, line->level > 0);
        }
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
}

/* ---- against rays ---------------------------------------------------------------------------------------------- */

/* The layers before the middle of a segment, by the faces that roberts_pick() finds there. */
static uint32_t count_by_rays(const roberts_scene *scene, const roberts_camera *camera, const roberts_segment *s)
{
    const double x = 0.5 * (s->p0.x + s->p1.x), y = 0.5 * (s->p0.y + s->p1.y), z = 0.5 * (s->z0 + s->z1);
    const bool back = s->line == ROBERTS_BACK || s->line == ROBERTS_BACK_OUTLINE;
    uint32_t found = back;
    roberts_picked picked;
    assert_int_equal(roberts_pick(scene, camera, x, y, &picked, NULL), ROBERTS_OK);
    for (size_t i = 0; i < picked.count; i++) {
        const uint32_t body = picked.hit[i].solid;
        const bool convex = roberts_scene_body_kind(scene, body) == ROBERTS_CONVEX;
        uint32_t met = 0;
        bool first = true;
        for (size_t k = 0; k < picked.count; k++) {
            first = first && (k >= i || picked.hit[k].solid != body);
            met += picked.hit[k].solid == body && picked.hit[k].depth > z + 1e-7;
        }
        if (!first || (convex && body == s->solid))
            continue;
        found += roberts_scene_body_kind(scene, body) == ROBERTS_CLOSED ? (met + 1) / 2 : met;
    }
    roberts_picked_free(&picked);
    return found;
}

/* Models in a view in which no edges coincide; the level of every hidden row, whatever the grid. */
static void rays_count_the_same(void **state)
{
    static const char *const path[] = {"models/chair.off",  "models/plates.off",   "models/tower.off",
                                       "models/table.off",  "models/crystals.off", "models/temple.off",
                                       "models/needles.off"};
    const roberts_camera camera = {.dir = {0.3137, -0.8719, 0.4311}};
    size_t rows = 0, deepest = 0;
    (void)state;
    for (size_t i = 0; i < sizeof path / sizeof path[0]; i++) {
        roberts_scene *scene = scene_of_file(path[i]);
        roberts_drawing drawing = draw_levels(scene, &camera, 0), coarse = draw_levels(scene, &camera, 1);
        assert_int_equal(drawing.count, coarse.count);
        for (size_t k = 0; k < drawing.count; k++) {
            const roberts_segment *s = &drawing.segment[k];
            assert_int_equal(s->level, coarse.segment[k].level);
            assert_int_equal(s->level > 0, s->state == ROBERTS_HIDDEN);
            if (s->state != ROBERTS_HIDDEN || hypot(s->p1.x - s->p0.x, s->p1.y - s->p0.y) < 1e-6)
                continue;
            const uint32_t rays = count_by_rays(scene, &camera, s);
            if (rays != s->level)
                fail_msg("%s: solid %u, edge %u-%u, t = %g to %g: level %u, but rays meet %u layers", path[i], s->solid,
                         s->v0, s->v1, s->t0, s->t1, s->level, rays);
            rows++;
            deepest = s->level > deepest ? s->level : deepest;
        }
        roberts_drawing_free(&drawing);
        roberts_drawing_free(&coarse);
        roberts_scene_free(scene);
    }
    print_message("%zu hidden rows, levels up to %zu\n", rows, deepest);
    assert_true(rows > 1000 && deepest > 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layers_are_counted),
        cmocka_unit_test(rays_count_the_same),
    };
    return cmocka_run_group_tests_name("levels", tests, NULL, NULL);
}
