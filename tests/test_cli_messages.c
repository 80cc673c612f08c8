/* What the program says to people: which file and what in it, options that change nothing, drawings that come out empty. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "program.h"

/* ---- which file ---- */

/* A unit cube at x; `last`: how much one corner lies above the others; `faces`: how many of its faces, 6 for all. */
static void put_cube(const char *path, double x, double last_corner, int faces)
{
    char text[1024];
    static const char *const face[] = {"4 4 5 6 7\n", "4 0 1 2 3\n", "4 0 1 5 4\n",
                                       "4 1 2 6 5\n", "4 2 3 7 6\n", "4 3 0 4 7\n"};
    int used =
        snprintf(text, sizeof text, "OFF\n8 %d 0\n%g 0 0\n%g 0 0\n%g 1 0\n%g 1 0\n%g 0 1\n%g 0 1\n%g 1 %g\n%g 1 1\n",
                 faces, x, x + 1, x + 1, x, x, x + 1, x + 1, 1 + last_corner, x);
    for (int i = 0; i < faces; i++)
        used += snprintf(text + used, sizeof text - (size_t)used, "%s", face[i]);
    put(path, text);
}

/* Numbers count within the file that is named. */
static void messages_name_the_file(void **state)
{
    (void)state;
    put_cube("good.off", 0, 0, 6);
    put_cube("bent.off", 5, 0.5, 6);
    put_cube("open.off", 10, 0, 5);
    put_cube("half.off", 10, 0, 4);
    put("dented.off", "OFF\n5 6 0\n3 0 0\n0 3 0\n0 0 0\n0 0 3\n.5 .5 .5\n"
                      "3 0 1 4\n3 1 2 4\n3 2 0 4\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    put("empty.off", "OFF\n0 0 0\n");
    assert_int_equal(run("good.off bent.off good.off"), 1);
    assert_said("roberts: bent.off: face 0 of solid 0 is not planar: ");
    assert_int_equal(run("good.off models/table.off empty.off dented.off --tolerance 0.001"), 1);
    assert_said("roberts: dented.off: solid 0 is not convex: vertex 2 lies 0.707107 outside face 0\n");
    assert_int_equal(run("good.off models/table.off --tolerance 1e-17"), 1);
    assert_said("roberts: models/table.off: face 77 of solid 12 is not planar: ");
    assert_int_equal(run("good.off open.off good.off"), 1);
    assert_said("roberts: open.off: solid 0 is not closed: edge 0-3 belongs to 1 face instead of 2");
    assert_int_equal(run("models/table.off empty.off"), 0);
    assert_int_equal(run("open.off half.off"), 1); /* one solid of two files, by positions */
    assert_said("roberts: open.off and 1 more: solid 0 is not closed: edge ");
    assert_int_equal(run("empty.off empty.off"), 1);
    assert_said("roberts: empty.off and 1 more: no solid: there is no face with three or more corners\n");
}

/* A solid that its neighbours' windings turn, which no check but the last one sees; and a surface of one side. */
static void every_refusal_names_the_file(void **state)
{
    (void)state;
    put("moebius.off", "OFF\n6 10 0\n0 1 1.618\n0 -1 1.618\n1.618 0 1\n1 1.618 0\n-1 1.618 0\n-1.618 0 1\n"
                       "3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 5\n3 0 5 1\n3 1 2 4\n3 2 3 5\n3 3 4 1\n3 4 5 2\n3 5 1 3\n");
    put("flat.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n");
    put("point.off", "OFF\n4 4 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n");
    assert_int_equal(run("models/table.off moebius.off"), 1);
    assert_said("roberts: moebius.off: solid 0 is not convex: its surface has one side only\n");
    assert_int_equal(run("models/table.off flat.off models/table.off"), 1);
    assert_said("roberts: flat.off: solid 0 is flat: ");
    assert_int_equal(run("models/table.off point.off"), 1);
    assert_said("roberts: point.off: solid 0 is flat: all its vertices lie in one point\n");
    assert_int_equal(run("--eye 18,12,15.5 models/table.off"), 1);
    assert_said("roberts: models/table.off: the eye is inside solid 0\n");
}

int main(void)
{
    if (!program_find())
        return 1;
    const struct CMUnitTest tests[] = {
        IN_FOLDER(messages_name_the_file),
        IN_FOLDER(every_refusal_names_the_file),
    };
    return cmocka_run_group_tests_name("cli_messages", tests, NULL, NULL);
}
