/* test_edge_crossings.c - edges that are left out and lie in other faces; intersections of back faces. */
#include "build_scene.h"
#include "scenes.h"

#include <math.h>

#define FLOOR "0 0 0\n4 0 0\n4 4 0\n0 4 0\n"
#define WALL "1 2 0\n3 2 0\n3 2 1\n1 2 1\n"

/* A scene and the one line expected. */
typedef struct edge_case {
    const char *name, *off;
    double crease; /* degrees */
    bool all_edges;
    double x[2]; /* it runs along y = 2, z = 0, from x[0] to x[1]; equal: there is no line */
    uint32_t face[2];
    roberts_vec3 dir;
} edge_case;

#define VIEW                                                                                                           \
    {                                                                                                                  \
        1, -2, 1.5                                                                                                     \
    }

static const edge_case cases[] = {
    {"a wall of two rows, cut at the floor",
     "OFF\n10 3 0\n" FLOOR WALL "1 2 -1\n3 2 -1\n4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
     0.1,
     false,
     {1, 3},
     {0, 1},
     VIEW},
    {"... with all edges drawn",
     "OFF\n10 3 0\n" FLOOR WALL "1 2 -1\n3 2 -1\n4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
     0.1,
     true,
     {0, 0},
     {0, 0},
     VIEW},
    {"... the floor comes last",
     "OFF\n10 3 0\n" FLOOR WALL "1 2 -1\n3 2 -1\n4 4 5 6 7\n4 4 5 9 8\n4 3 2 1 0\n",
     0.1,
     false,
     {1, 3},
     {0, 2},
     VIEW},
    {"... bent there by more than the crease angle",
     "OFF\n10 3 0\n" FLOOR WALL "1 2.1 -1\n3 2.1 -1\n4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
     0.1,
     false,
     {0, 0},
     {0, 0},
     VIEW},
    {"... bent there by less",
     "OFF\n10 3 0\n" FLOOR WALL "1 2.1 -1\n3 2.1 -1\n4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
     20,
     false,
     {1, 3},
     {0, 1},
     VIEW},
    {"... beyond the floor",
     "OFF\n10 3 0\n" FLOOR "-1 2 0\n5 2 0\n5 2 1\n-1 2 1\n-1 2 -1\n5 2 -1\n4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
     0.1,
     false,
     {0, 4},
     {0, 1},
     VIEW},
    {"both faces on one side",
     "OFF\n10 3 0\n" FLOOR "1 2 0\n3 2 0\n3 0 0.1\n1 0 0.1\n1 4 0.1\n3 4 0.1\n4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
     20,
     false,
     {0, 0},
     {0, 0},
     VIEW},
    {"a wall of one row", "OFF\n8 2 0\n" FLOOR WALL "4 0 1 2 3\n4 4 5 6 7\n", 0.1, false, {0, 0}, {0, 0}, VIEW},
    {"tiles that end along the wall",
     "OFF\n12 4 0\n0 0 0\n4 0 0\n4 2 0\n0 2 0\n4 4 0\n0 4 0\n" WALL "1 2 -1\n3 2 -1\n"
     "4 0 1 2 3\n4 3 2 4 5\n4 6 7 8 9\n4 6 7 11 10\n",
     0.1,
     false,
     {1, 3},
     {0, 2},
     VIEW},
    {"tiles that are bent there",
     "OFF\n12 4 0\n0 0 1\n4 0 1\n4 2 0\n0 2 0\n4 4 0\n0 4 0\n" WALL "1 2 -1\n3 2 -1\n"
     "4 0 1 2 3\n4 3 2 4 5\n4 6 7 8 9\n4 6 7 11 10\n",
     0.1,
     false,
     {0, 0},
     {0, 0},
     VIEW},
    {"one tile that ends there",
     "OFF\n10 3 0\n0 0 0\n4 0 0\n4 2 0\n0 2 0\n" WALL "1 2 -1\n3 2 -1\n4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
     0.1,
     false,
     {0, 0},
     {0, 0},
     VIEW},
    {"... and the wall's side runs on from the tiles' edge: one edge of four faces",
     "OFF\n11 5 0\n1 0 0\n3 0 0\n3 2 0\n1 2 0\n3 4 0\n1 4 0\n5 2 0\n5 2 1\n1 2 1\n1 2 -1\n5 2 -1\n"
     "4 0 1 2 3\n4 3 2 4 5\n4 3 6 7 8\n3 3 2 9\n4 2 6 10 9\n",
     0.1,
     false,
     {0, 0},
     {0, 0},
     VIEW},
    {"... from inside the tiles' edge: two edges",
     "OFF\n12 5 0\n0 0 0\n3 0 0\n3 2 0\n1 2 0\n3 4 0\n0 4 0\n5 2 0\n5 2 1\n1 2 1\n1 2 -1\n5 2 -1\n0 2 0\n"
     "4 0 1 2 11\n4 11 2 4 5\n4 3 6 7 8\n3 3 2 9\n4 2 6 10 9\n",
     0.1,
     false,
     {1, 3},
     {0, 2},
     VIEW},
    {"one wall through tiles",
     "OFF\n10 3 0\n0 0 0\n4 0 0\n4 2 0\n0 2 0\n4 4 0\n0 4 0\n1 2 1\n3 2 1\n3 2 -1\n1 2 -1\n"
     "4 0 1 2 3\n4 3 2 4 5\n4 6 7 8 9\n",
     0.1,
     false,
     {1, 3},
     {0, 2},
     VIEW},
    {"a block of two rows through the floor",
     "OFF\n16 11 0\n" FLOOR "1 2 0\n3 2 0\n3 3 0\n1 3 0\n1 2 1\n3 2 1\n3 3 1\n1 3 1\n1 2 -1\n3 2 -1\n3 3 -1\n1 3 -1\n"
     "4 0 1 2 3\n4 8 9 10 11\n4 12 15 14 13\n4 4 5 9 8\n4 12 13 5 4\n4 5 6 10 9\n4 13 14 6 5\n4 6 7 11 10\n"
     "4 14 15 7 6\n4 7 4 8 11\n4 15 12 4 7\n",
     0.1,
     false,
     {1, 3},
     {0, 3},
     VIEW},
    {"two sheets of two tiles, at so small an angle that their edges are apart by much more than they touch",
     "OFF\n12 4 0\n1 1 -.0001\n3 1 -.0001\n3 2 0\n1 2 0\n3 3 .0001\n1 3 .0001\n"
     "1 1.0000001 .0001\n3 1.0000001 .0001\n3 2.0000001 0\n1 2.0000001 0\n3 3.0000001 -.0001\n1 3.0000001 -.0001\n"
     "4 0 1 2 3\n4 3 2 4 5\n4 6 7 8 9\n4 9 8 10 11\n",
     0.1,
     false,
     {1, 3},
     {0, 2},
     VIEW},
    {"a wall of two rows along a diagonal of the floor, from corner to corner",
     "OFF\n8 4 0\n0 2 0\n2 0 0\n4 2 0\n2 4 0\n0 2 1\n4 2 1\n0 2 -1\n4 2 -1\n"
     "4 0 1 2 3\n4 0 2 5 4\n4 2 0 6 7\n3 3 0 4\n",
     0.1,
     false,
     {0, 4},
     {0, 1},
     VIEW},
    {"a wall that is edge-on",
     "OFF\n10 3 0\n" FLOOR WALL "1 2 -1\n3 2 -1\n4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
     0.1,
     false,
     {0, 0},
     {0, 0},
     {1, 0, 1}},
};

/* The line of a case is drawn from end to end, with or without hidden lines, and no ray contradicts it. */
static void edges_left_out_are_lines_where_they_should(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int hidden = 0; hidden < 2; hidden++) {
            const edge_case *c = &cases[i];
            roberts_scene *scene = scene_of_text(c->off);
            const roberts_camera camera = {.dir = c->dir};
            roberts_hide_options options = roberts_hide_options_default();
            roberts_verify_options verify = roberts_verify_options_default();
            roberts_verification found;
            size_t lines = 0, due = c->x[0] < c->x[1];
            options.crease_degrees = verify.crease_degrees = c->crease;
            options.all_edges = verify.all_edges = c->all_edges;
            options.keep_hidden = hidden;
            roberts_drawing drawing = drawing_of(scene, &camera, &options);
            for (size_t k = 0; k < drawing.crossing_count; k++) {
                const roberts_crossing *l = &drawing.crossing[k];
                if (l->end[0].y != 2 || l->end[1].y != 2 || l->end[0].z != 0 || l->end[1].z != 0)
                    continue; /* other sides of the block */
                lines++;
                if (!due)
                    continue;
                assert_true(l->end[0].x == c->x[0] && l->end[1].x == c->x[1]);
                assert_true(l->face[0] == c->face[0] && l->face[1] == c->face[1]);
            }
            if (lines != due)
                fail_msg("%s: %zu lines", c->name, lines);
            assert_int_equal(roberts_verify(scene, &camera, &drawing, &verify, &found, NULL), ROBERTS_OK);
            if (found.contradictions > 0)
                fail_msg("%s: rays contradict", c->name);
            roberts_drawing_free(&drawing);
            roberts_scene_free(scene);
        }
}

/* Two boxes that overlap in a corner: their surfaces meet in a closed line of six sides, half of it in back faces. */
static void back_faces_cross_if_hidden_lines_are_kept(void **state)
{
    static const char boxes[] = "OFF\n16 12 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n"
                                "1 1 1\n3 1 1\n3 3 1\n1 3 1\n1 1 3\n3 1 3\n3 3 3\n1 3 3\n"
                                "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"
                                "4 8 11 10 9\n4 12 13 14 15\n4 8 9 13 12\n4 9 10 14 13\n4 10 11 15 14\n4 11 8 12 15\n";
    const roberts_camera camera = {.dir = {3, -2, 4}};
    roberts_scene *scene = scene_of_text(boxes);
    size_t visible[2] = {0, 0};
    (void)state;
    for (int hidden = 0; hidden < 2; hidden++) {
        roberts_hide_options options = roberts_hide_options_default();
        double whole = 0;
        options.keep_hidden = hidden;
        roberts_drawing drawing = drawing_of(scene, &camera, &options);
        for (size_t k = 0; k < drawing.count; k++)
            if (drawing.segment[k].line == ROBERTS_INTERSECTION) {
                whole += drawing.segment[k].t1 - drawing.segment[k].t0;
                visible[hidden] += drawing.segment[k].state == ROBERTS_VISIBLE;
            }
        if (hidden) {
            assert_int_equal(drawing.crossing_count, 6);
            assert_float_equal(whole, 6, 1e-12);
        }
        roberts_drawing_free(&drawing);
    }
    assert_true(visible[0] > 0 && visible[0] == visible[1]);
    roberts_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edges_left_out_are_lines_where_they_should),
        cmocka_unit_test(back_faces_cross_if_hidden_lines_are_kept),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
