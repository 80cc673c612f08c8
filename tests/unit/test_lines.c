/* Lines that are no edges (seen.further): hidden by all faces but those whose keys they list. */
#include "hide/cells.h"
#include "hide/segments.h"
#include "build_scene.h"
#include "scenes.h"

/* The drawing of a scene with one further line of body 0. */
static hide_chunk segments_of(const roberts_scene *scene, const roberts_camera *camera, bool all, const seen_line *line)
{
    roberts_hide_options options = roberts_hide_options_default();
    hide_job job = {.options = &options};
    hide_worker w;
    hide_chunk out = {0};
    double depth;
    uint32_t *first = calloc((size_t)scene->solid_count + 1, sizeof *first);
    options.keep_hidden = all;
    options.threads = 1;
    assert_non_null(first);
    for (uint32_t s = 1; s <= scene->solid_count; s++)
        first[s] = 1;
    assert_int_equal(seen_begin(&job.seen, scene, camera, 0.0, NULL), ROBERTS_OK);
    seen_set_rules(&job.seen, &options);
    if (line)
        job.seen.further = (seen_further){line, first};
    assert_true(hide_fronts_build(&job.fronts, &job.seen, &options, false));
    scan_frame frame = cells_for_lists(&(cells_boxes){job.fronts.front_box, job.fronts.front_count, job.fronts.low,
                                                      job.fronts.high, hide_margin(&job.fronts.space)},
                                       0, &depth);
    assert_int_equal(objet_build(&job.grid, &job.fronts, frame, 1), ROBERTS_OK);
    assert_true(hide_worker_init(&w, &job.fronts, &job.grid, all, all));
    assert_true(segments_find(&job, &w, &out, 0, scene->solid_count));
    hide_worker_free(&w);
    objet_free(&job.grid);
    hide_fronts_free(&job.fronts);
    seen_end(&job.seen);
    free(first);
    return out;
}

/* A line between points of the model, which lies in faces of these keys. */
static seen_line line_between(const seen_point end[2], uint32_t key0, uint32_t key1)
{
    return (seen_line){.edge = ROBERTS_NONE,
                       .v = {ROBERTS_NONE, ROBERTS_NONE},
                       .end = end,
                       .own = {{key0, key1}, NULL},
                       .t1 = 1.0,
                       .class = ROBERTS_INTERSECTION};
}

/* Two boxes one over the other as seen from above, the upper one at x from 1 to 2; and a line over the lower one. */
static const struct {
    const char *name;
    double z;        /* of the line, which runs from x = 0.5 to x = 4 */
    int own[2];      /* bodies whose keys it lists; -1: none */
    double shown[4]; /* t of the visible part: from, to; 0, 0: no such part */
} cases[] = {
    {"on the lower box", 1.0, {0, -1}, {0, 1.0 / 7, 3.0 / 7, 1}},
    {"on both", 1.0, {0, 1}, {0, 1}},
    {"on both, the other way round", 1.0, {1, 0}, {0, 1}},
    {"within the lower box, and of its faces", 0.5, {0, -1}, {0, 1.0 / 7, 3.0 / 7, 1}},
    {"within the lower box, and of none", 0.5, {-1, -1}, {0, 0}},
    {"over both", 9.0, {-1, -1}, {0, 1}},
};

static void further_lines(void **state)
{
    const roberts_camera camera = {.dir = {0, 0, 1}, .up = {0, 1, 0}};
    (void)state;
    for (size_t i = 0; i < 2 * (sizeof cases / sizeof cases[0]); i++) {
        bool all = i % 2;
        model m = {0};
        size_t visible = 0, hidden = 0;
        double length = 0.0;
        model_box(&m, (roberts_vec3){0, 0, 0}, (roberts_vec3){5, 5, 1});
        model_box(&m, (roberts_vec3){1, 1, 2}, (roberts_vec3){2, 4, 3});
        roberts_scene *scene = model_build(&m);
        /* the ends are sums: neither part alone is near them */
        seen_point end[2] = {{{0.25, 2, cases[i / 2].z - 1}, {0.25, 0, 1}}, {{5, 3, cases[i / 2].z + 2}, {-1, 0, -2}}};
        uint32_t key[2];
        for (int k = 0; k < 2; k++)
            key[k] = cases[i / 2].own[k] < 0 ? ROBERTS_NONE : seen_body_key((uint32_t)cases[i / 2].own[k]);
        seen_line line = line_between(end, key[0], key[1]);
        hide_chunk with = segments_of(scene, &camera, all, &line), without = segments_of(scene, &camera, all, NULL);
        for (size_t n = 0, edges = 0; n < with.count; n++) {
            const roberts_segment *s = &with.segment[n];
            if (s->edge != ROBERTS_NONE) {
                assert_true(edges < without.count && s->solid == without.segment[edges].solid &&
                            s->edge == without.segment[edges].edge && s->t0 == without.segment[edges].t0 &&
                            s->t1 == without.segment[edges].t1);
                edges++;
                continue;
            }
            assert_int_equal(s->line, ROBERTS_INTERSECTION);
            assert_int_equal(s->solid, 0);
            assert_true(s->v0 == ROBERTS_NONE && s->v1 == ROBERTS_NONE);
            length += s->t1 - s->t0;
            if (s->state == ROBERTS_HIDDEN) {
                hidden++;
                continue;
            }
            const double *shown = cases[i / 2].shown + 2 * visible;
            if (visible > 1 || fabs(s->t0 - shown[0]) > 1e-12 || fabs(s->t1 - shown[1]) > 1e-12)
                fail_msg("%s: visible from %g to %g", cases[i / 2].name, s->t0, s->t1);
            visible++;
        }
        size_t expected = (cases[i / 2].shown[1] > 0.0) + (cases[i / 2].shown[3] > 0.0);
        if (visible != expected || (all ? fabs(length - 1.0) > 1e-12 : hidden > 0))
            fail_msg("%s: %zu visible parts, %zu hidden", cases[i / 2].name, visible, hidden);
        free(with.segment);
        free(without.segment);
        roberts_scene_free(scene);
        model_free(&m);
    }
}

/* ---- edges that the rules leave out ----------------------------------------------------------------------------- */

/* Adds 1 to times[e] for each line that is edge e, and 16 if it is marked as left out. Returns how many lines there
 * are. */
static size_t count_lines(const seen *s, const unsigned char *culled, unsigned char *times)
{
    size_t count = 0;
    for (uint32_t body = 0; body < s->scene->solid_count; body++) {
        if (culled[body])
            continue;
        seen_walk walk = seen_walk_begin(s, body);
        for (seen_line line; seen_next(&walk, &line, walk.slow); count++)
            times[line.edge] += line.left_out ? 17 : 1;
    }
    return count;
}

static const struct {
    const char *model;
    roberts_camera camera;
    bool all; /* all edges are lines at once, so that none is left out */
} rests[] = {
    {"models/archimedean-solids.off", {.dir = {0.31, 0.47, 0.83}}, false},
    {"models/archimedean-solids.off",
     {.projection = ROBERTS_PERSPECTIVE, .eye = {2, 3, 20}, .near_distance = 22},
     false},
    {"models/shapes/bracket.off", {.dir = {0.31, 0.47, 0.83}}, false},
    {"models/shapes/bracket.off", {.dir = {0.31, 0.47, 0.83}}, true},
    {"models/shapes/goblet.off", {.dir = {0.31, 0.47, 0.83}}, false},
    {"models/shapes/goblet.off", {.dir = {0.31, 0.47, 0.83}}, true},
    {"models/shapes/moebius-strip.off", {.dir = {0.31, 0.47, 0.83}}, false},
    {"models/shapes/bracket.off", {.projection = ROBERTS_PERSPECTIVE, .eye = {0, 5, 40}, .near_distance = 32}, false},
    {"models/shapes/goblet.off", {.projection = ROBERTS_PERSPECTIVE, .eye = {30, 0, 5}, .near_distance = 29}, true},
};

/* Each edge that is a line if all edges are drawn is a line by the rules, or one that is left out. Only the latter are
 * marked, if they are wanted. */
static void lines_left_out(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof rests / sizeof rests[0]; i++) {
        roberts_scene *scene = scene_of_file(rests[i].model);
        roberts_hide_options options = roberts_hide_options_default();
        hide_fronts fronts;
        seen s;
        options.crease_degrees = 110;
        options.threads = 1;
        assert_int_equal(seen_begin(&s, scene, &rests[i].camera, 0.0, NULL), ROBERTS_OK);
        assert_int_equal(s.clip.clipped, rests[i].camera.projection == ROBERTS_PERSPECTIVE);
        assert_true(hide_fronts_build(&fronts, &s, &options, false));
        unsigned char *all = calloc(scene->edge_count, 1), *drawn = calloc(scene->edge_count, 1);
        unsigned char *marked = calloc(scene->edge_count, 1);
        assert_true(all && drawn && marked);
        options.all_edges = true;
        seen_set_rules(&s, &options);
        size_t whole = count_lines(&s, fronts.culled, all);
        options.all_edges = rests[i].all;
        seen_set_rules(&s, &options);
        size_t some = count_lines(&s, fronts.culled, drawn), left = 0;
        s.rules.left_out = true;
        assert_int_equal(count_lines(&s, fronts.culled, marked), whole);
        for (uint32_t e = 0; e < scene->edge_count; e++) {
            left += marked[e] / 16;
            if (marked[e] % 16 != all[e] || marked[e] / 16 + drawn[e] != all[e])
                fail_msg("row %zu, %s, edge %u: %d, %d by the rules, %d marked", i, rests[i].model, e, all[e], drawn[e],
                         marked[e]);
        }
        if (some + left != whole || (left > 0) == rests[i].all)
            fail_msg("row %zu, %s: %zu lines and %zu left out, of %zu", i, rests[i].model, some, left, whole);
        free(all);
        free(drawn);
        free(marked);
        hide_fronts_free(&fronts);
        seen_end(&s);
        roberts_scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(further_lines), cmocka_unit_test(lines_left_out)};
    return cmocka_run_group_tests_name("lines", tests, NULL, NULL);
}
