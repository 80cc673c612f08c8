/* test_flat_patches.c - a flat face given as very many slivers is crossed where it would be as one polygon. */
#include "build_scene.h"
#include "put_text.h"
#include "scenes.h"

#include <math.h>

enum { CORNERS = 1000 }; /* so many slivers in one cell have a tree */

/* Faces that meet the disc z = 0 of radius 10, or do not. Corners from CORNERS on are listed here; the others are those
 * of the disc, at angles of 2 pi k / CORNERS. */
typedef struct flat_case {
    const char *name, *corners, *faces;
    int corner_count, face_count;
    double length; /* of all lines in which they cross the disc */
} flat_case;

static const flat_case cases[] = {
    {"a wall through the disc", "-3 1 -2\n3 1 -2\n3 1 2\n-3 1 2\n", "4 1000 1001 1002 1003\n", 4, 1, 6},
    {"a wall with a foot through it", "-3 1 3\n3 1 3\n3 1 -2\n2 1 -2\n2 1 2\n-3 1 2\n",
     "6 1000 1001 1002 1003 1004 1005\n", 6, 1, 1},
    {"... with the other foot", "3 1 3\n-3 1 3\n-3 1 -2\n-2 1 -2\n-2 1 2\n3 1 2\n", "6 1000 1001 1002 1003 1004 1005\n",
     6, 1, 1},
    {"... with a foot between", "3 1 3\n-3 1 3\n-3 1 2\n-1 1 2\n-1 1 -2\n1 1 -2\n1 1 2\n3 1 2\n",
     "8 1000 1001 1002 1003 1004 1005 1006 1007\n", 8, 1, 2},
    {"a wall that stands on it", "-3 1 0\n3 1 0\n3 1 2\n-3 1 2\n", "4 1000 1001 1002 1003\n", 4, 1, 0},
    {"a wall above it", "-3 1 .5\n3 1 .5\n3 1 2\n-3 1 2\n", "4 1000 1001 1002 1003\n", 4, 1, 0},
    {"two walls that meet in a chord", "0 0 2\n0 0 -2\n", "3 100 600 1000\n3 600 100 1001\n", 2, 2, 20},
    {"... of one body with the disc", "0 0 2\n0 0 -2\n",
     "3 100 600 1000\n3 600 100 1001\n3 100 101 1000\n3 600 601 1000\n", 2, 4, 20},
    {"a wall on a chord", "0 0 2\n", "3 100 600 1000\n3 100 101 1000\n3 600 601 1000\n", 1, 3, 0},
    {"a wall on a side", "0 0 2\n", "3 100 101 1000\n", 1, 1, 0},
    {"a face that touches it with one corner", "1 0 2\n-1 1 2\n", "3 250 1000 1001\n3 250 251 1000\n", 2, 2, 0},
    {"a face that enters it at one corner", "0 4 2\n0 0 -2\n", "3 250 1000 1001\n3 250 251 1000\n", 2, 2, 8},
    {"walls on its sides, with one that crosses it", "0 0 -4\n0 0 4\n0 3 4\n0 3 -4\n",
     "3 0 1 1000\n3 1 2 1000\n3 2 3 1001\n4 1001 1002 1003 1000\n", 4, 4, 3},
};

/* The disc as one polygon, or as slivers at corner 0. */
static roberts_scene *scene_of_case(const flat_case *c, bool slivers)
{
    put_text t = put_begin();
    put(&t, "OFF\n%d %d 0\n", CORNERS + c->corner_count, (slivers ? CORNERS - 2 : 1) + c->face_count);
    for (int k = 0; k < CORNERS; k++) {
        const double angle = 2 * 3.14159265358979323846 * k / CORNERS;
        put(&t, "%.17g %.17g 0\n", 2 * k == CORNERS ? -10 : 10 * cos(angle), 2 * k % CORNERS ? 10 * sin(angle) : 0.0);
    }
    put(&t, "%s", c->corners);
    if (slivers)
        for (int k = 1; k < CORNERS - 1; k++)
            put(&t, "3 0 %d %d\n", k, k + 1);
    else {
        put(&t, "%d", CORNERS);
        for (int k = 0; k < CORNERS; k++)
            put(&t, " %d", k);
        put(&t, "\n");
    }
    put(&t, "%s", c->faces);
    roberts_scene *scene = scene_of_text(t.at);
    test_free(t.at);
    return scene;
}

static double length_of_crossings(const roberts_drawing *drawing)
{
    double length = 0.0;
    for (size_t k = 0; k < drawing->crossing_count; k++) {
        const roberts_vec3 *end = drawing->crossing[k].end;
        length += vec3_length(vec3_sub(end[1], end[0]));
    }
    return length;
}

/* With hidden lines, pairs of faces are found in space; without, by the cells of the picture. */
static void slivers_are_crossed_like_the_polygon(void **state)
{
    const roberts_camera camera = {.dir = {1, -2, 1.5}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int slivers = 0; slivers < 2; slivers++)
            for (int hidden = 0; hidden < 2; hidden++) {
                roberts_scene *scene = scene_of_case(&cases[i], slivers);
                roberts_hide_options options = roberts_hide_options_default();
                options.keep_hidden = hidden;
                options.crease_degrees = 0.1;
                options.grid = 1;
                roberts_drawing drawing = drawing_of(scene, &camera, &options);
                const double length = length_of_crossings(&drawing);
                if (fabs(length - cases[i].length) > 1e-9)
                    fail_msg("%s: %.17g, not %g%s%s", cases[i].name, length, cases[i].length,
                             slivers ? ", of slivers" : "", hidden ? ", hidden lines kept" : "");
                roberts_drawing_free(&drawing);
                roberts_scene_free(scene);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slivers_are_crossed_like_the_polygon),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
