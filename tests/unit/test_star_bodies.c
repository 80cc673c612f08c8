/* test_star_bodies.c - bodies that do not cross themselves; those that do still give lines. */
#include "hide/star_bodies.h"

#include <stdio.h>
#include <string.h>

#include "build_scene.h"
#include "scenes.h"

/* Double pyramids over a ring of five corners. The ring is vertices 2 .. 6; 0 is the upper tip, 1 the lower one. */
typedef struct star_case {
    const char *name;
    roberts_vec3 tip[2];
    int step;    /* in the ring: 1: once round; 2: twice, as in a pentagram */
    bool inward; /* the faces are wound the other way */
    double dent; /* the distance of corner 3 from the axis; that of the others is 2 */
    double touching;
    bool simple;
} star_case;

static const star_case star_cases[] = {
    {"a double pyramid", {{0, 0, 1}, {0, 0, -1}}, 1, false, 2, 1e-11, true},
    {"... wound inward", {{0, 0, 1}, {0, 0, -1}}, 1, true, 2, 1e-11, true},
    {"... with a dent", {{0, 0, 1}, {0, 0, -1}}, 1, false, 1, 1e-11, true},
    {"a dent that passes the middle", {{0, 0, 1}, {0, 0, -1}}, 1, false, -1, 1e-11, false},
    {"a dent up to the axis", {{0, 0, 1}, {0, 0, -1}}, 1, false, 0, 1e-11, true},
    {"the ring goes round twice, so that the body crosses itself", {{0, 0, 1}, {0, 0, -1}}, 2, false, 2, 1e-11, false},
    {"... wound inward", {{0, 0, 1}, {0, 0, -1}}, 2, true, 2, 1e-11, false},
    {"both tips above the ring", {{0, 0, 1}, {0, 0, 0.5}}, 1, false, 2, 1e-11, false},
    {"one tip above the other", {{0, 0, -1}, {0, 0, 1}}, 1, false, 2, 1e-11, true},
    {"a tip far outside the ring", {{5, 0, 1}, {0, 0, -1}}, 1, false, 2, 1e-11, false},
    {"a flat body", {{0, 0, 1e-3}, {0, 0, -1e-3}}, 1, false, 2, 1e-11, false},
    {"a touching distance as large as the body", {{0, 0, 1}, {0, 0, -1}}, 1, false, 2, 1, false},
    {"a touching distance not much less than the distance of faces", {{0, 0, 1}, {0, 0, -1}}, 1, false, 2, 1e-3, false},
};

/* The body of a case, `copies` times, each farther along x by `shift`. */
static roberts_scene *scene_of_case(const star_case *c, double size, int copies, double shift)
{
    char text[4000];
    int at = sprintf(text, "OFF\n%d %d 0\n", 7 * copies, 10 * copies);
    for (int k = 0; k < copies; k++) {
        for (int i = 0; i < 2; i++)
            at += sprintf(text + at, "%.17g %.17g %.17g\n", size * c->tip[i].x + k * shift, size * c->tip[i].y,
                          size * c->tip[i].z);
        for (int i = 0; i < 5; i++) {
            const double angle = 0.3 + i * 1.2566370614359172, far = size * (i == 1 ? c->dent : 2.0);
            at += sprintf(text + at, "%.17g %.17g 0\n", far * cos(angle) + k * shift, far * sin(angle));
        }
    }
    for (int k = 0; k < copies; k++)
        for (int i = 0; i < 5; i++) {
            const int p = 7 * k + 2 + i * c->step % 5, q = 7 * k + 2 + (i + 1) * c->step % 5;
            at += sprintf(text + at, "3 %d %d %d\n3 %d %d %d\n", c->inward ? q : p, c->inward ? p : q, 7 * k,
                          c->inward ? p : q, c->inward ? q : p, 7 * k + 1);
        }
    return scene_of_text(text);
}

static bool is_simple(const roberts_scene *scene, double touching)
{
    box3 box = {scene->box_min, scene->box_max};
    return star_body_rear(scene, 0, &box, touching) != VIEW_UNKNOWN;
}

static void only_stars_that_go_round_once_are_simple(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof star_cases / sizeof *star_cases; i++) {
        const star_case *c = &star_cases[i];
        roberts_scene *scene = scene_of_case(c, 1.0, 1, 0.0);
        assert_int_equal(scene->solid_count, 1);
        if (is_simple(scene, c->touching) != c->simple)
            fail_msg("%s: %s simple", c->name, c->simple ? "not" : "");
        roberts_scene_free(scene);
    }
}

static void the_size_does_not_count_but_its_powers_must_be_in_range(void **state)
{
    static const struct {
        double size;
        bool simple;
    } sizes[] = {{0x1p-100, true}, {0x1p-160, false}, {0x1p100, true}, {0x1p160, false}};
    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        roberts_scene *scene = scene_of_case(&star_cases[2], sizes[i].size, 1, 0.0);
        assert_int_equal(is_simple(scene, 1e-11 * sizes[i].size), sizes[i].simple);
        roberts_scene_free(scene);
    }
}

/* Simple bodies do not cross themselves, but may cross others. */
static void bodies_that_cross_give_lines(void **state)
{
    static const struct {
        const char *name;
        int of, copies;
        double shift;
        bool cross;
    } scenes[] = {
        {"a dented body", 2, 1, 0, false},
        {"two of them, apart", 2, 2, 5, false},
        {"two of them that cross", 2, 2, 1.5, true},
        {"a body that crosses itself", 5, 1, 0, true},
    };
    (void)state;
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        const roberts_camera camera = {.dir = {.31, .47, .83}};
        roberts_scene *scene = scene_of_case(&star_cases[scenes[i].of], 1.0, scenes[i].copies, scenes[i].shift);
        roberts_drawing drawing = drawing_of(scene, &camera, NULL);
        if (drawing.crossing_count > 0 ? !scenes[i].cross : scenes[i].cross)
            fail_msg("%s: %zu lines", scenes[i].name, (size_t)drawing.crossing_count);
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
}

/* Do both drawings have the same visible segments, in the same order? */
static bool same_visible(const roberts_drawing *few, const roberts_drawing *all)
{
    size_t at = 0;
    for (size_t i = 0; i < all->count; i++) {
        const roberts_segment *a = &all->segment[i];
        if (a->state != ROBERTS_VISIBLE)
            continue;
        const roberts_segment *b = at < few->count ? &few->segment[at++] : NULL;
        if (!b || a->line != b->line || memcmp(&a->p0, &b->p0, sizeof a->p0) != 0 ||
            memcmp(&a->p1, &b->p1, sizeof a->p1) != 0)
            return false;
    }
    return at == few->count;
}

enum { ROUND = 12, RINGS = 7 };

/* Balls of triangles, copies of one another along x. Every third corner of a ring lies deeper by `dent`. */
static roberts_scene *scene_of_balls(int copies, double dent, bool inward)
{
    static char text[40000];
    const int corners = ROUND * RINGS + 2;
    int at = sprintf(text, "OFF\n%d %d 0\n", copies * corners, copies * 2 * ROUND * RINGS);
    for (int k = 0; k < copies; k++) {
        at += sprintf(text + at, "%g 0 1\n%g 0 -1\n", 1.5 * k, 1.5 * k);
        for (int i = 0; i < ROUND * RINGS; i++) {
            const double up = 3.141592653589793 * (i / ROUND + 1) / (RINGS + 1), turn = 0.1 + 0.5235987755982988 * i;
            const double far = 1.0 - (i % 3 == 0 ? dent : 0.0);
            at += sprintf(text + at, "%.17g %.17g %.17g\n", far * sin(up) * cos(turn) + 1.5 * k,
                          far * sin(up) * sin(turn), far * cos(up));
        }
    }
    for (int k = 0; k < copies; k++)
        for (int i = 0; i < ROUND * RINGS; i++) {
            const int own = k * corners + 2 + i, next = own - i % ROUND + (i + 1) % ROUND;
            const int below = i / ROUND + 1 < RINGS ? own + ROUND : k * corners + 1;
            const int beside = i / ROUND > 0 ? next - ROUND : k * corners;
            at += sprintf(text + at, "3 %d %d %d\n3 %d %d %d\n", own, inward ? next : below, inward ? below : next, own,
                          inward ? beside : next, inward ? next : beside);
        }
    return scene_of_text(text);
}

/* Edges at the back of a simple body are dropped without a test, unless hidden lines are kept. The same lines are seen
 * with and without these, from outside and from inside, where bodies cross, and where one crosses itself. */
static void edges_at_the_back_are_hidden(void **state)
{
    static const roberts_camera cameras[] = {
        {.dir = {.31, .47, .83}},
        {.dir = {0, 0, 1}},
        {.dir = {1, 0, 0}},
        {.projection = ROBERTS_PERSPECTIVE, .eye = {3, -4, 2}},
        {.projection = ROBERTS_PERSPECTIVE, .eye = {.1, .05, .02}, .look_at = {1, 1, 0}, .has_look_at = true},
    };
    static const double dents[] = {0.05, 0.3, 1.4};
    (void)state;
    for (size_t i = 0; i < 12; i++)
        for (size_t k = 0; k < sizeof cameras / sizeof *cameras; k++) {
            roberts_scene *scene = scene_of_balls(1 + (int)(i % 2), dents[i / 4], i / 2 % 2);
            roberts_hide_options options = roberts_hide_options_default();
            options.all_edges = true;
            roberts_drawing few = drawing_of(scene, &cameras[k], &options);
            options.keep_hidden = true;
            roberts_drawing all = drawing_of(scene, &cameras[k], &options);
            if (!same_visible(&few, &all))
                fail_msg("balls %zu, camera %zu: other lines are seen", i, k);
            if (i < 8 && k == 0 && few.tally.covered < 100 * (1 + i % 2))
                fail_msg("balls %zu: %d edges have been dropped", i, (int)few.tally.covered);
            roberts_drawing_free(&few);
            roberts_drawing_free(&all);
            roberts_scene_free(scene);
        }
}

/* A dented body whose nearest corner is the tip. Which of its faces lie at the back depends neither on their first
 * corners, nor on the way in which all are wound. */
static void first_corners_do_not_count(void **state)
{
    static const int face[8][3] = {{1, 4, 0}, {4, 1, 2}, {2, 3, 4}, {3, 0, 4},
                                   {1, 0, 5}, {1, 5, 2}, {5, 3, 2}, {0, 3, 5}};
    static const roberts_camera cameras[] = {{.dir = {0, 0, 1}}, {.dir = {.31, .47, .83}}, {.dir = {0, 0, -1}}};
    (void)state;
    for (unsigned turns = 0; turns < 6561; turns += 7) /* a digit of base 3 for each face */
        for (size_t k = 0; k < 6; k++) {
            char text[1000];
            int at = sprintf(text, "OFF\n6 8 0\n-2 -2 0\n2 -2 0\n2 2 0\n-2 2 0\n5 1 4\n2 0 -1\n");
            unsigned rest = turns;
            for (int f = 0; f < 8; f++, rest /= 3) {
                const int a = face[f][rest % 3], b = face[f][(rest + 1) % 3], c = face[f][(rest + 2) % 3];
                at += sprintf(text + at, "3 %d %d %d\n", a, k % 2 ? c : b, k % 2 ? b : c);
            }
            roberts_scene *scene = scene_of_text(text);
            roberts_hide_options options = roberts_hide_options_default();
            options.all_edges = true;
            roberts_drawing few = drawing_of(scene, &cameras[k / 2], &options);
            options.keep_hidden = true;
            roberts_drawing all = drawing_of(scene, &cameras[k / 2], &options);
            if (!same_visible(&few, &all))
                fail_msg("turns %u, %zu: other lines are seen", turns, k);
            roberts_drawing_free(&few);
            roberts_drawing_free(&all);
            roberts_scene_free(scene);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_stars_that_go_round_once_are_simple),
        cmocka_unit_test(the_size_does_not_count_but_its_powers_must_be_in_range),
        cmocka_unit_test(bodies_that_cross_give_lines),
        cmocka_unit_test(edges_at_the_back_are_hidden),
        cmocka_unit_test(first_corners_do_not_count),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
