/* Messages of the program: the file and the fault in it, options without effect, empty drawings. */
/* for a terminal of our own: posix_openpt() */
#define _XOPEN_SOURCE 700 /* NOLINT(bugprone-reserved-identifier): that is its name */

#include <math.h>
#include <sys/resource.h>
#include <time.h>

#include "program.h"
#include "roberts.h"
#include "sanitized.h"
#include "testing.h"

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
    put("tri.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    put("empty.off", "OFF\n0 0 0\n");
    assert_int_equal(run("--solids good.off bent.off good.off"), 1);
    assert_said("roberts: bent.off: face 0 of solid 0 is not planar: ");
    assert_int_equal(run("--solids good.off models/table.off empty.off dented.off --tolerance 0.001"), 1);
    assert_said("roberts: dented.off: solid 0 is not convex: vertex 2 lies 0.707107 outside face 0 (see --hull)\n");
    assert_int_equal(run("--solids good.off models/table.off --tolerance 1e-17"), 1);
    assert_said("roberts: models/table.off: face 73 of solid 12 is not planar: ");
    assert_int_equal(run("--solids good.off open.off good.off"), 1);
    assert_said("roberts: open.off: solid 0 is not closed: edge 0-3 belongs to 1 face instead of 2");
    assert_int_equal(run("models/table.off empty.off"), 0);
    put("lined.off", "OFF\n4 3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n2 0 3\n1 1\n"); /* nothing to warn of */
    assert_int_equal(run("-v -f null lined.off"), 0);
    assert_int_equal(strncmp(last.err, "roberts: lined.off: 2 bodies, 5 vertices, 1 face, 2 points and lines; ", 69),
                     0);
    put("wire.off", "OFF\n2 1\n0 0 0\n1 0 0\n2 0 1\n");
    assert_int_equal(run("-v -f null wire.off"), 0);
    assert_int_equal(strncmp(last.err, "roberts: wire.off: 1 body, 2 vertices, 0 faces, 1 point or line; ", 65), 0);
    assert_int_equal(run("tri.off --hull"), 1); /* and no hint */
    assert_null(strstr(last.err, "see --hull"));
    assert_int_equal(run("--solids open.off half.off"), 1); /* one solid of two files, by positions */
    assert_said("roberts: open.off and 1 more: solid 0 is not closed: edge ");
    assert_int_equal(run("empty.off empty.off"), 1);
    assert_said("roberts: empty.off and 1 more: nothing to draw: there is no face with three different corners\n");
    put("three.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"); /* no points that have a hull */
    put("four.off", "OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
    assert_int_equal(run("three.off"), 1);
    assert_said("roberts: three.off: nothing to draw: there is no face with three different corners\n");
    assert_int_equal(run("--solids tri.off"), 1);
    assert_null(strstr(last.err, "see --hull"));
    assert_int_equal(run("four.off"), 1);
    assert_said("roberts: four.off: nothing to draw: there is no face with three different corners (--hull draws the "
                "convex hull of points)\n");
}

/* Faces that a warning counts are those of one file or of several. */
static void warnings_name_the_file(void **state)
{
    (void)state;
    put("twist.off", "OFF\n4 1 0\n9 0 .5\n12 3 0\n12 0 0\n9 3 0\n4 0 1 2 3\n");
    assert_int_equal(run("-f null models/platonic/cube.off twist.off"), 0);
    assert_string_equal(last.err, "roberts: twist.off: warning: 1 face crosses or touches itself and is not planar: "
                                  "lines on it may be wrong\n");
    put("twice.off", "OFF\n3 2 0\n0 0 5\n3 0 5\n0 3 5\n3 0 1 2\n3 0 1 2\n");
    assert_int_equal(run("-f null twice.off models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "roberts: twice.off: warning: 1 face repeats an earlier one, and does not count\n");
    put("again.off", "OFF\n3 2 0\n0 0 9\n3 0 9\n0 3 9\n3 0 1 2\n3 0 1 2\n");
    assert_int_equal(run("-f null twice.off models/platonic/cube.off again.off"), 0);
    assert_string_equal(last.err, "roberts: warning: 2 faces repeat an earlier one, and do not count\n");
}

/* As by cat, also from standard input: the first one is drawn. */
static void one_model_after_another(void **state)
{
    (void)state;
    put("two.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n"
                   "OFF\n4 4 0\n5 0 0\n6 0 0\n5 1 0\n5 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n");
    assert_int_equal(run("-f null two.off"), 0);
    assert_string_equal(last.err,
                        "roberts: two.off:11: warning: another model begins here and is ignored; OFF holds one, "
                        "but several files are drawn together\n");
    finish(start("-f null -", "two.off", -1));
    assert_int_equal(last.status, 0);
    assert_said("roberts: standard input:11: warning: another model begins here and is ignored; ");
    assert_int_equal(run("-f null -q two.off"), 0);
    assert_string_equal(last.err, "");
}

/* The second model comes late: the warning is certain, and the writer can write to its end. */
static void one_model_after_another_in_a_pipe(void **state)
{
    static char text[400000]; /* more than a pipe holds */
    static const char tail[] = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n";
    const struct timespec while_waiting = {.tv_nsec = 200000000};
    void (*before)(int) = signal(SIGPIPE, SIG_IGN);
    (void)state;
    memset(text, '#', sizeof text);
    assert_int_equal(mkfifo("in/pipe", 0600), 0);
    for (int by_name = 0; by_name < 2; by_name++) {
        pid_t child = start(by_name ? "-f null in/pipe" : "-f null -", by_name ? NULL : "in/pipe", -1);
        int end = open("in/pipe", O_WRONLY);
        assert_int_equal(write(end, tail, sizeof tail - 1), sizeof tail - 1);
        nanosleep(&while_waiting, NULL);
        assert_int_equal(write(end, tail, sizeof tail - 1), sizeof tail - 1);
        assert_int_equal(write(end, text, sizeof text), sizeof text);
        close(end);
        finish(child);
        assert_int_equal(last.status, 0);
        assert_said(":11: warning: another model begins here and is ignored; ");
    }
    signal(SIGPIPE, before);
}

/* The drawing would be wrong: from files and from pipes. */
static void numbers_that_are_missing(void **state)
{
    static const struct {
        const char *text, *said;
    } rows[] = {
        {"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
         ":5: vertex 2 of 0..3 does not end with its line, and then a face has no corners"},
        {"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2\n3 2 0 3\n",
         ":9: face 2 of 0..3 runs into the line of the next, and then there are fewer faces than declared"},
        {"OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
         ":7: vertex 4 of 0..4 does not end with its line, and then there are fewer faces than declared"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        put("v.off", rows[i].text);
        assert_int_equal(run("v.off -o v.svg"), 1);
        assert_int_equal(strncmp(last.err, "roberts: v.off:", 15), 0);
        assert_said(rows[i].said);
        finish(start("- -o v.svg", "v.off", -1));
        assert_int_equal(last.status, 1);
        assert_said(rows[i].said);
        assert_int_equal(access("v.svg", F_OK), -1);
    }
}

/* A solid whose faces are turned to match their neighbours, which only the last check finds; and a one-sided
 * surface. */
static void every_refusal_names_the_file(void **state)
{
    (void)state;
    put("moebius.off", "OFF\n6 10 0\n0 1 1.618\n0 -1 1.618\n1.618 0 1\n1 1.618 0\n-1 1.618 0\n-1.618 0 1\n"
                       "3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 5\n3 0 5 1\n3 1 2 4\n3 2 3 5\n3 3 4 1\n3 4 5 2\n3 5 1 3\n");
    put("flat.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n");
    put("point.off", "OFF\n4 4 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n");
    assert_int_equal(run("--solids models/table.off moebius.off"), 1);
    assert_said("roberts: moebius.off: solid 0 is not convex: its surface has one side only (see --hull)\n");
    assert_int_equal(run("--solids models/table.off flat.off models/table.off"), 1);
    assert_said("roberts: flat.off: solid 0 is flat: ");
    assert_int_equal(run("--solids models/table.off point.off"), 1);
    assert_said("roberts: point.off: solid 0 is flat: all its vertices lie in one point\n");
    assert_int_equal(run("--eye 18,12,15.5 models/table.off"), 1);
    assert_said("roberts: models/table.off: the eye is inside solid 0; move it out of all solids\n");
}

/* A tolerance is named if the model passes with it, and it is large enough for all of its solids. */
static const struct {
    double lifted[2]; /* of two cubes a corner, whose faces are then off their planes by a quarter of it */
    const char *arguments, *hint;
} tolerance_cases[] = {
    {{0.001, 0}, "", "beside their plane (--tolerance 0.0002 would do; see also --hull)\n"},
    {{0.0001, 0.01}, "", "beside their plane (--tolerance 0.0005 would do; see also --hull)\n"},
    {{0.0001, 0.01}, "--tolerance 0.0002 ", "beside their plane (--tolerance 0.0005 would do; see also --hull)\n"},
    {{0, 0.0001}, "--tolerance 1e-7 ", "beside their plane (--tolerance 5e-06 would do; see also --hull)\n"},
    {{0.0001, 0.5}, "", "beside their plane (see --hull)\n"},
    {{0.5, 0}, "--tolerance 0.02 ", "beside their plane (see --hull)\n"},
};

static void a_tolerance_that_helps_is_named(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof tolerance_cases / sizeof tolerance_cases[0]; i++) {
        char line[200];
        double tolerance;
        put_cube("a.off", 0, tolerance_cases[i].lifted[0], 6);
        put_cube("b.off", 5, tolerance_cases[i].lifted[1], 6);
        snprintf(line, sizeof line, "--solids %s-f null a.off b.off", tolerance_cases[i].arguments);
        print_message("roberts %s\n", line);
        assert_int_equal(run(line), 1);
        assert_said(tolerance_cases[i].hint);
        assert_int_equal(count_of(last.err, "\n"), 1);
        const char *named = strstr(last.err, "(--tolerance ");
        if (!named)
            continue;
        assert_int_equal(sscanf(named, "(--tolerance %lf", &tolerance), 1);
        snprintf(line, sizeof line, "--solids -f null a.off b.off --tolerance %g", tolerance);
        assert_int_equal(run(line), 0);
        snprintf(line, sizeof line, "--solids -f null a.off b.off --tolerance %g",
                 tolerance / 2.5); /* and not half of it */
        assert_int_equal(run(line), 1);
    }
}

/* Just below the limit a tolerance may have a digit other than 1, 2 or 5. The limit is 0.025 / sqrt(12) for a
 * dodecahedron. */
static void a_tolerance_below_the_limit_is_named(void **state)
{
    static char text[TEXT], moved[TEXT];
    (void)state;
    read_text("models/platonic/dodecahedron.off", text);
    const char *corner = strstr(text, "\n1 1 1\n");
    assert_non_null(corner);
    snprintf(moved, sizeof moved, "%.*s\n1.07 1.07 1.07%s", (int)(corner - text), text, corner + strlen("\n1 1 1"));
    put("moved.off", moved);
    assert_int_equal(run("--solids -f null moved.off"), 1);
    assert_said(" beside their plane (--tolerance 0.007 would do; see also --hull)\n");
    assert_int_equal(run("--solids -f null moved.off --tolerance 0.007"), 0);
    assert_int_equal(run("--solids -f null moved.off --tolerance 0.005"), 1);
}

/* A surface of revolution as triangles, with a waist of `depth` in the middle: 1.5 high and low, 1 wide. */
static void put_round(const char *path, int around, int rings, double depth)
{
    enum { ROUND_MOST = 100000 };
    char *text = malloc(ROUND_MOST);
    assert_non_null(text);
    const int points = 2 + (rings - 1) * around, bottom = points - 1;
    int used = snprintf(text, ROUND_MOST, "OFF\n%d %d 0\n0 0 1.5\n", points, 2 * (rings - 1) * around);
    for (int i = 0; i < points - 2; i++) {
        double turn = 2 * 3.14159265358979323846 * (i % around) / around;
        double z = cos(3.14159265358979323846 * (1 + i / around) / rings);
        double wide = sqrt(1 - z * z) * (1 - depth * exp(-6 * z * z));
        used += snprintf(text + used, ROUND_MOST - (size_t)used, "%.7f %.7f %.7f\n", wide * cos(turn), wide * sin(turn),
                         1.5 * z);
    }
    used += snprintf(text + used, ROUND_MOST - (size_t)used, "0 0 -1.5\n");
    for (int i = 0; i < points - 2; i++) {
        int next = i - i % around + (i + 1) % around, below = i + around + 1, below_next = next + around + 1;
        if (i < around)
            used += snprintf(text + used, ROUND_MOST - (size_t)used, "3 0 %d %d\n", i + 1, next + 1);
        if (below < bottom)
            used += snprintf(text + used, ROUND_MOST - (size_t)used, "3 %d %d %d\n3 %d %d %d\n", i + 1, below,
                             below_next, i + 1, below_next, next + 1);
        else
            used += snprintf(text + used, ROUND_MOST - (size_t)used, "3 %d %d %d\n", bottom, next + 1, i + 1);
    }
    assert_in_range(used, 1, ROUND_MOST - 1);
    put(path, text);
    free(text);
}

/* If its faces are small, any shape passes with some tolerance. It is not named for this one, which has a waist of
 * half its width. A ball of as many faces, almost round, passes with a small one. */
static void a_tolerance_that_passes_any_shape_is_not_named(void **state)
{
    (void)state;
    put_round("waist.off", 40, 30, 0.6);
    assert_int_equal(run("--solids -f null waist.off"), 1);
    assert_said(" (see --hull)\n");
    assert_int_equal(run("--solids -f null waist.off --tolerance 0.01"), 0);
    put_cube("far.off", 2000, 0.5, 6); /* the tolerance is a part of the coordinates here */
    assert_int_equal(run("--solids -f null far.off"), 1);
    assert_said(" beside their plane (see --hull)\n");
    assert_int_equal(run("--solids -f null far.off --tolerance 0.01"), 0);
    put_round("ball.off", 40, 30, 0.0);
    assert_int_equal(run("--solids -f null ball.off --tolerance 1e-10"), 1);
    assert_said(" would do; see also --hull)\n");
}

/* ---- misuse that says what was meant ---- */

static const struct {
    const char *arguments, *said;
} misuse_cases[] = {
    {"--hatch spacng=1", "did you mean spacing?"},
    {"--hatch spacing", "--hatch: spacing needs a value\n"},
    {"--hatch on=1", "--hatch: on takes no value\n"},
    {"--hatch spacing=0", "--hatch: spacing=0 is not a length from 0.01 to 1000 mm\n"},
    {"--hatch levels=1.5", "--hatch: levels=1.5 is not a whole number from 0 to 1000\n"},
    {"--hatch angle=400", "--hatch: angle=400 is not a number of degrees from -360 to 360\n"},
    {"--hatch cross=2", "--hatch: cross=2 is neither none nor a number from 0 to 1\n"},
    {"--hatch shortest=-1", "--hatch: shortest=-1 is not a length from 0 to 1000 mm\n"},
    {"--hatch faces=cut", "--hatch: faces: \"cut\" is unknown; it can be all, sections\n"},
    {"--hatch direction=up", "--hatch: direction: \"up\" is unknown; it can be picture, steep, across\n"},
    {"--style outline:0,5", "--style: \"outline:0,5\": there is a comma between two values; decimals have a point"},
    {"--style outline:width=0,5", "between two values; decimals have a point, as in 0.5\n"},
    {"--hatch spacing=0,8", "--hatch: \"spacing=0,8\": there is a comma between two values; decimals have a point"},
    {"--crease 0,1", "--crease: \"0,1\" is not a number; decimals have a point, as in 0.5\n"},
    {"--margin 1,5cm", "in or pt behind it; decimals have a point, as in 0.5\n"},
    {"--scale 1:2,5", "nor standard; decimals have a point, as in 0.5\n"},
    {"--page 8,5x11in", "--page: \"8,5x11in\" is not like 210x297 or 8.5x11in; decimals have a point, as in 0.5\n"},
    {"--group bodies", "bodies"},
    {"--id-prefix 9a",
     "--id-prefix: \"9a\" cannot begin an id: it needs a letter or _, then letters, digits, - . or _\n"},
    {"--page b7", "\"b7\" is unknown; it can be a0, a1, a2, a3, a4, a5, a6, b0, b1, b2, b3, b4, b5, b6, letter, legal, "
                  "tabloid, or WxH in mm, as 210x297, or 8.5x11in\n"},
    {"--page leter", "\"leter\" is unknown; did you mean letter? It can be a0, "},
    {"--unit km", "\"km\" is unknown; it can be mm, cm, m, in, ft\n"}, /* and two wrong letters give no suggestion */
    {"--hidden dahsed", "did you mean dashed? It can be none, dashed, solid\n"},
    {"--dashed", "--dashed is unknown; did you mean --hidden dashed?"},
    {"--paper a4", "--paper is unknown; did you mean --page?"},
    {"--color red", "--color is unknown; did you mean --style outline:color=NAME?"},
    {"--pen 0.3", "--pen is unknown; did you mean --style outline:width=MM?"},
    {"--wireframe", "--wireframe is unknown; did you mean --hidden solid?"},
    {"--isometric", "--isometric is unknown; did you mean --view iso?"},
    {"--front", "--front is unknown; did you mean --view front?"},
    {"--pdf", "--pdf is unknown; did you mean -f pdf?"},
    {"-hidden dashed", "-hidden is unknown; did you mean --hidden?"},
    {"-output a.svg", "-output is unknown; did you mean --output?"}, /* and no file "utput" */
    {"-format=svg", "-format=svg is unknown; did you mean --format=svg?"},
    {"models/table.off elevation 20", "elevation: there is no such file; did you mean --elevation?"},
    {"help", "help: there is no such file; did you mean --help?"},
    {"--no-hidden", "--no-hidden is unknown; did you mean --hidden none?"},
    {"--stats json models/table.off", "json: there is no such file; did you mean --stats=json?"},
    {"models/table.off --verify 10", "10: there is no such file; did you mean --verify=10?"},
    {"--verify=x", "--verify: \"x\" is not a whole number from 1 to 4294967295\n"},
    {"--verify=4294967296", "--verify: \"4294967296\" is not a whole number from 1 to 4294967295\n"},
    {"--verify=0", "--verify: 0 is out of range: from 1 to 4294967295"},
    {"--fov 0 --eye 9,9,9", "--fov: 0 is out of range: from 0.001 to 179\n"},
    {"--fov 180 --eye 9,9,9", "--fov: 180 is out of range: from 0.001 to 179\n"},
    {"--fov -1 --eye 9,9,9", "--fov: -1 is out of range: from 0.001 to 179\n"},
    {"--fov wide --eye 9,9,9", "--fov: \"wide\" is not a number\n"},
    {"--dpi 0", "--dpi: 0 is out of range: from 10 to 10000\n"},
    {"--fill mode", "--fill: \"mode\" is unknown; did you mean model? It can be none, model, shade, body, "},
    {"--plotter middle", "--plotter: the origin is corner or center, not \"middle\"\n"},
    {"--plotter corner,45", "--plotter: a page is turned by 0, 90, 180 or 270 degrees, not \"45\"\n"},
    {"--plotter corner,90,", "--plotter: \"\" is not how far the origin lies inside, as 10x4, in mm\n"},
    {"--plotter corner,90,10", "--plotter: \"10\" is not how far the origin lies inside, as 10x4, in mm\n"},
    {"--plotter corner,90,10x1001", "--plotter: 10x1001 is out of range: from -1000 to 1000 mm\n"},
    {"--dpi 1e6", "--dpi: 1e6 is out of range: from 10 to 10000\n"},
    {"--threads 100000", "--threads: 100000 is out of range: from 0 to 1024\n"},
    {"--threads 1.5", "--threads: \"1.5\" is not a whole number from 0 to 1024\n"},
    {"--grid 4097", "--grid: 4097 is out of range: from 0 to 4096\n"},
    {"--epsilon 100 copy.off",
     "roberts: --epsilon: the touching distance, 100, is more than 0.0173205, a hundredth of the scene\n"},
    {"--near -1 --eye 9,9,9", "--near: -1 is out of range: at least 0\n"},
    {"--near 1", "--near needs --eye"},
    {"--section 1,2", "--section: \"1,2\" is not X,Y,Z or X,Y,Z,NX,NY,NZ (numbers, point for decimals)\n"},
    {"--section 1,2,3,4,5", "--section: \"1,2,3,4,5\" is not X,Y,Z or X,Y,Z,NX,NY,NZ (numbers, point for decimals)\n"},
    {"--section 1,2,3,0,0,0", "--section: 0,0,0 is no direction\n"},
    {"--section 1,2,3 --sheet first", "--section and --sheet exclude each other\n"},
    {"--section 1,2,3 --plan", "--section and --plan exclude each other\n"},
    {"--dpi 3000 models/table.off -o a.png",
     "3000 dpi make an image of 24804 x 35079 pixels; it has 1 to 32767 a side, on this page at most 2802 dpi\n"},
    {"--turntable 4 -o a%d-%d.svg", "turn-%03d.svg; \"a%d-%d.svg\" has more than one %\n"},
    {"--turntable 4 -o a-%s.svg", "turn-%03d.svg; \"a-%s.svg\" has a % of another kind\n"},
    {"--batch models/table.off models/tower.off",
     "--batch: models/table.off is a file, where the folder for the drawings should be: --batch DIR FILE..."},
    {"--batch models/table.off", "--batch: models/table.off is a file, where the folder"},
    {"--batch no.OFF models/tower.off", "--batch: no.OFF is the name of a file, where the folder"},
    {"--batch missing.Stl models/table.off",
     "--batch: missing.Stl is the name of a file, where the folder for the drawings should be: --batch DIR FILE..."},
    {"--batch in", "--batch needs names of files: --batch DIR FILE..."},
    {"models/table.off models/tower.off -o in",
     "--output: in is a folder; name a file in it, or draw each input by itself into it with --batch in\n"},
    {"models/table.off -f pdf -o ..",
     "--output: .. is a folder; name a file in it, or draw each input by itself into "},
    {"models/table.off -o not/yet/", "or draw each input by itself into it with --batch not/yet/\n"},
    {"-o in", "--output: in is a folder; name a file in it\n"}, /* --batch does not read standard input */
    {"models/table.off --turntable 2 -o in", "--turntable needs a name with a place for the number: -o turn-%03d.svg"},
    {"--style outline=red", "\"outline=red\" is not CLASS:key=value,..., as outline:width=0.7,color=red"},
    {"--style outline:red",
     "\"red\" is unknown; it can be width, color, colour, dash, pen, off, on, as in outline:width="},
    {"--style outline:color=red:width=2", "there is a comma between two values, as outline:width=0.7,color=red"},
    {"models/table.off out.svg", "out.svg: there is no such file to read; to draw into it: -o out.svg"},
    {"copy.off -f csv -o copy.off", "--output: copy.off is an input; the drawing would take its place"},
    {"--regions copy.off copy.off -o a.svg", "--regions: copy.off is an input; the regions would take its place"},
    {"--regions copy.off models/table.off -o a.svg",
     "--regions: copy.off is a model; the regions would take its place"},
    {"--regions a.json models/table.off -f json -o a.json", "--regions: a.json is the file of the drawing, too"},
    {"--regions in/../a.json models/table.off -f json -o a.json", "--regions: in/../a.json is the file of the drawing"},
    {"--regions link.csv models/table.off -f csv -o names.csv", "--regions: link.csv is the file of the drawing, too"},
    {"--sheet first --dimensions 0-9999 -o s.svg copy.off",
     "roberts: s.svg: --dimensions: no face has vertex 9999 (of vertices at one place the smallest number counts)\n"},
    {"--sheet first --title T --page 100x100 -o s.svg copy.off", "roberts: s.svg: --page: title block and views need "},
    {"--labels - copy.off -o a.svg", "--labels: names cannot be read from standard input; a file called - is ./-"},
    {"--labels faces.csv --part 1/2 copy.off -o a", "faces.csv: names of faces and bodies need the whole scene"},
    {"--labels faces.csv --plan copy.off -o a", "faces.csv: names of faces and bodies need the whole scene"},
    {"--labels faces.csv --join copy.off -o a.svg", "faces.csv: names of faces and bodies need the whole scene"},
    {"--labels names.csv --regions names.csv copy.off -o a.svg", "--regions: names.csv is the file of --labels; the "},
    {"--labels names.csv copy.off -f csv -o names.csv", "--output: names.csv is the file of --labels; the drawing "},
    {"models/table.off -f svg -o paint.mtl", "--output: paint.mtl is a model; the drawing would take its place"},
    {"copy1.off --turntable 2 -f svg -o copy%d.off",
     "--output: copy1.off is an input; the drawing would take its place"},
    {"models/table.off --turntable 2 -f svg -o copy%d.off", "--output: copy1.off is a model; the drawing would take"},
    {"models/table.off --sheet first -f csv -o copy-%s.off", "--output: copy-top.off is a model; the table would take"},
};

/* The program inherits the limit. */
static void images_too_large_for_memory(void **state)
{
    const rlim_t megabytes_300 = 300 << 20;
    struct rlimit limit, low;
    (void)state;
    assert_int_equal(getrlimit(RLIMIT_AS, &limit), 0);
    if (SANITIZED || (limit.rlim_max != RLIM_INFINITY && limit.rlim_max < megabytes_300))
        SKIP_BECAUSE("address space cannot be limited here, or under a sanitizer");
    low = limit;
    low.rlim_cur = megabytes_300;
    assert_int_equal(setrlimit(RLIMIT_AS, &low), 0);
    int large = run("--dpi 1000 --hidden dashed --style hidden:dash=200 models/table.off -o in/a.png");
    assert_said(
        "roberts: in/a.png: 1000 dpi make an image of 8268 x 11693 pixels; it takes 387 MB of memory, and there "
        "are 314 MB at the most\n");
    int small = run("--dpi 950 models/platonic/cube.off -o in/b.png"); /* 349 MB of pixels, in bands */
    assert_int_equal(setrlimit(RLIMIT_AS, &limit), 0);
    assert_int_equal(large, 1);
    assert_int_equal(small, 0);
    assert_int_equal(entries("in", false), 1);
}

static void misuse_tells_what_was_meant(void **state)
{
    (void)state;
    put_cube("copy.off", 0, 0, 6);
    put_cube("copy1.off", 0, 0, 6);
    put_cube("copy-top.off", 0, 0, 6);
    put("paint.mtl", "newmtl red\n");
    put("names.csv", "vertex,0,A\n");
    put("faces.csv", "vertex,0,A\nface,2,lid\n");
    assert_int_equal(symlink("names.csv", "link.csv"), 0);
    int before = entries(".", false) + 2; /* and what the runs say */
    for (size_t i = 0; i < sizeof misuse_cases / sizeof misuse_cases[0]; i++) {
        print_message("roberts %s\n", misuse_cases[i].arguments);
        assert_int_equal(run(misuse_cases[i].arguments), 2);
        assert_said(misuse_cases[i].said);
        assert_string_equal(last.out, "");
    }
    assert_int_equal(entries(".", false), before);
    assert_int_equal(mkdir("faces", 0700), 0);
    assert_int_equal(run("--labels faces copy.off"), 1);
    assert_said("roberts: faces: is a folder\n");
    assert_int_equal(run("copy.off"), 0);
}

static void empty_names(void **state)
{
    (void)state;
    put_cube("one.off", 0, 0, 6);
    char *const words[] = {program, "one.off", "", NULL};
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        dup2(open_stream("err", O_WRONLY | O_TRUNC), STDERR_FILENO);
        execv(program, words);
        _exit(127);
    }
    finish(child);
    assert_int_equal(last.status, 2);
    assert_said("roberts: the name of an input is empty\n");
}

/* The second run without -o finds the drawing of the first; and a folder is no model. */
static void what_is_no_model(void **state)
{
    (void)state;
    put("a.svg", "<svg/>\n");
    assert_int_equal(run("--turntable 2 -f null --stats models/table.off"), 0);
    assert_said("roberts: picture 0: statistics\n");
    assert_said("roberts: picture 1: statistics\n");
    assert_int_equal(run("--labels faces,edges models/table.off -o b.svg"), 1);
    assert_said("faces,edges: No such file or directory; for numbers: --label faces,edges\n");
    assert_int_equal(run("--part 1/2 --labels faces models/table.off -o part"), 1);
    assert_said("faces: No such file or directory; for numbers: --label faces\n");
    assert_int_equal(run("models/table.off a.svg"), 1);
    assert_said("a.svg:1: this is XML (as AMF, X3D and COLLADA are), but only OFF, STL, OBJ and PLY can be read; to "
                "draw into it, name it with -o\n");
    assert_int_equal(run("models/table.off a.svg -o b.svg"), 1);
    assert_said("but only OFF, STL, OBJ and PLY can be read\n");
    assert_int_equal(run("in -f null"), 1);
    assert_said("roberts: in: is a folder; name the files in it, as *.off or *.stl\n");
    assert_int_equal(run("--plan models/table.off -o in/t.plan"), 0);
    assert_int_equal(run("in/t.plan"), 1);
    assert_said(
        "in/t.plan:1: this is the plan of a drawing, but only OFF, STL, OBJ and PLY can be read; to convert it: "
        "roberts --part 1/1 x.plan -o part-1 && roberts --join part-1 -o drawing.svg\n");
    assert_int_equal(run("--part 1/1 in/t.plan -o in/t.svg"), 0);
    assert_int_equal(run("in/t.svg"), 1);
    assert_said("in/t.svg:1: this is a part of a drawing, but only OFF, STL, OBJ and PLY can be read; to convert it: "
                "roberts --join -o drawing.svg part-*\n");
    put("cut.stl", "Generated by something, and a header goes on to byte 80 with more text and blanks .\n");
    assert_int_equal(truncate("cut.stl", 83), 0);
    assert_int_equal(run("cut.stl"), 1);
    assert_said("found \"Generated\"; as STL it is cut off: it would have 84 bytes or more\n");
    put("long.stl", "Generated by something, and a header goes on to byte 80 with more text and blanks .\n");
    assert_int_equal(run("long.stl"), 1);
    assert_said("found \"Generated\"\n");
}

/* The ending names a converter where the first bytes do not. */
static void converters_are_named(void **state)
{
    (void)state;
    put("in/box.scad", "w = 10;\ncube(w);\n");
    assert_int_equal(run("in/box.scad -f null"), 1);
    assert_said("found \"w\"; to convert it: openscad -o model.stl model.scad\n");
    put("in/box.scad", "module box() { cube(1); }\n");
    assert_int_equal(run("in/box.scad -f null"), 1);
    assert_said("roberts: in/box.scad:1: this is OpenSCAD, but only OFF, STL, OBJ and PLY can be read; to convert it: "
                "openscad -o model.stl model.scad\n");
    put("in/box.off", "w = 10;\n");
    assert_int_equal(run("in/box.off -f null"), 1);
    assert_said("found \"w\"\n");
}

/* A file that is named twice is drawn on itself. */
static void files_named_twice_are_warned_of(void **state)
{
    (void)state;
    assert_int_equal(run("models/table.off models/platonic/cube.off models/platonic/../table.off -f null"), 0);
    assert_string_equal(last.err, "roberts: models/platonic/../table.off: warning: this file is named twice, and is "
                                  "drawn twice\n");
    assert_int_equal(run("-q models/table.off models/table.off -f null"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("models/table.off models/platonic/cube.off -f null"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("--part 1/1 models/table.off -o part"), 0);
    assert_int_equal(run("--join part part -o a.svg"), 2);
    assert_said("roberts: part: warning: this file is named twice\n");
}

/* A file of names without names; distances that are one. */
static void what_is_there_once(void **state)
{
    (void)state;
    put("no-name.csv", "# vertex,0,A\n");
    assert_int_equal(run("--labels no-name.csv models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "roberts: no-name.csv: warning: there are no names in it\n");
    assert_int_equal(run("--sheet first --dimensions v0-v1,v2-v3 models/platonic/cube.off"), 0);
    const size_t before = strlen(last.out) - strlen("v0-v1,v2-v3"); /* the drawing holds its command */
    assert_int_equal(run("--sheet first --dimensions v0-v1,v2-v3,v1-v0,3-2 models/platonic/cube.off"), 0);
    assert_int_equal(strlen(last.out) - strlen("v0-v1,v2-v3,v1-v0,3-2"), before);
}

/* The paths of seams name their body where lines are grouped. */
static void seams_name_their_body(void **state)
{
    static const char seam[] = "<g class=\"seam\" fill=\"none\"";
    (void)state;
    assert_int_equal(run("--fill body --group body models/table.off"), 0);
    const char *at = strstr(last.out, seam), *first = at ? strstr(at, "<path") : NULL;
    assert_non_null(first);
    assert_int_equal(strncmp(first, "<path data-body=\"0\" stroke=\"", 28), 0);
    assert_int_equal(run("--fill body models/table.off"), 0);
    assert_null(strstr(last.out, "data-body"));
}

/* A prism of many sides stands for a cylinder. */
static void round_bodies_are_told(void **state)
{
    enum { SIDES = 600 };
    (void)state;
    FILE *file = fopen("round.off", "w");
    assert_non_null(file);
    fprintf(file, "OFF %d %d 0\n", 2 * SIDES, SIDES + 2);
    for (int i = 0; i < 2 * SIDES; i++)
        fprintf(file, "%.17g %.17g %d\n", cos(i % SIDES * 6.283185307179586 / SIDES),
                sin(i % SIDES * 6.283185307179586 / SIDES), i / SIDES);
    for (int lid = 0; lid < 2; lid++) {
        fprintf(file, "%d", SIDES);
        for (int i = 0; i < SIDES; i++)
            fprintf(file, " %d", lid ? SIDES + i : SIDES - 1 - i);
        fputc('\n', file);
    }
    for (int i = 0; i < SIDES; i++)
        fprintf(file, "4 %d %d %d %d\n", i, (i + 1) % SIDES, SIDES + (i + 1) % SIDES, SIDES + i);
    assert_int_equal(fclose(file), 0);
    assert_int_equal(run("round.off -f null"), 0);
    assert_string_equal(last.err, "roberts: round.off: note: edges of 30 degrees and less of 1 convex body are drawn; "
                                  "--crease 30 leaves them out\n");
    assert_int_equal(run("round.off models/table.off -f null"), 0);
    assert_non_null(strstr(last.err, "of 1 convex body are drawn"));
    assert_int_equal(run("round.off -f null --crease 30"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("models/platonic/cube.off -f null"), 0);
    assert_string_equal(last.err, "");
}

/* A - means the stream, even if a file has that name. */
static void a_file_called_minus(void **state)
{
    (void)state;
    put_cube("one.off", 0, 0, 6);
    put("-", "");
    finish(start("- -o -", "one.off", -1));
    assert_int_equal(last.status, 0);
    assert_non_null(strstr(last.out, "<svg"));
}

/* ---- options that change nothing ---- */

/* The expected warning, after "roberts: warning: "; empty: none. */
static const struct {
    const char *arguments, *said;
} idle_cases[] = {
    {"--unit in", "--unit has no effect: the drawing is fitted on the page, and not true to --scale\n"},
    {"--unit in --scale 1:1", ""},
    {"--layers numbered --style outline:pen=3", ""},
    {"--layers numbered --group element --style outline:pen=3", ""},
    {"--layers numbered --group body --style outline:pen=3",
     "pen= of --style has no effect: only pens of hpgl and numbered layers of classes in svg have numbers\n"},
    {"--layers numbered --group body --frame --style frame:pen=3", ""},
    {"--sheet first --layers numbered --style outline:pen=3", ""},
    {"--sheet first --layers numbered --group element --style symbol:pen=3", ""},
    {"--sheet first --layers numbered --group element --style outline:pen=3",
     "pen= of --style has no effect: only pens of hpgl and numbered layers of classes in svg have numbers\n"},
    {"--dpi 300", "--dpi has no effect: only png has a resolution\n"},
    {"--hatch on --style hatch:width=1.5",
     "--hatch: strokes of 1.5 mm, 0.8 mm apart, cover the darkest faces wholly\n"},
    {"--sheet first --landscape --title "
     "MMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMM",
     "title block: the letters of \"Title\" are only "},
    {"--landscape --page 100x100", "--landscape has no effect: the page is square\n"},
    {"--view top --up 0,0,2", "--up has no effect: it is parallel to the view\n"},
    {"--eye 9,9,9 --look-at 1,1,1 --up -1,-1,-1", "--up has no effect: it is parallel to the view\n"},
    {"--azimuth 90 --elevation 0 --up 1,0,0", "--up has no effect: it is parallel to the view\n"},
    {"--view top --up 1,0,1", ""},
    {"--plotter center,90 -f hpgl", ""},
    {"--plotter corner,90,10x4 -f hpgl", ""},
    {"--plotter corner", "--plotter has no effect: only hpgl has a plotter's origin\n"},
    {"--layers numbered -f pdf", "--layers has no effect: only layers of svg are numbered\n"},
    {"--style hatch:color=red", "--style hatch has no effect: faces are not hatched without --hatch\n"},
    {"--hatch on -f csv", "--hatch has no effect: csv has no page\n"},
    {"--hatch on --dash real", "--dash real has no effect: no lines are dashed, as by --hidden dashed\n"},
    {"--hatch on --dash real --style hatch:dash=1", ""},
    {"--text native", "--text has no effect: there is no text without --label, "},
    {"--title T --sheet first --label-size 5",
     "--label-size has no effect: there are no labels without --label or --labels, and no --dimensions\n"},
    {"--label vertices --text native -f hpgl",
     "--text native has no effect: only svg, pdf, tikz and dxf can hold text itself\n"},
    {"--label vertices --text native -f svg", ""},
    {"--label vertices --text native -f pdf", ""},
    {"--label vertices --text native -f tikz", ""},
    {"--label vertices --text native -f dxf", ""},
    {"--margin 2 --frame --plotter corner,0,10x4 -f hpgl", "lines reach 8.0 mm beyond the plotter's origin; its pen"},
    {"--margin 12 --frame --plotter corner,0,10x4 -f hpgl", ""},
    {"--margin 2 --frame --plotter center -f hpgl", ""},
    {"--hatch shortest=500", "all strokes of hatching are shorter than 500 mm, and left out\n"},
    {"--hatch shortest=1", ""},
    {"--scale 1:1 --unit mm", "at this scale the drawing is less than 10 mm large: is --unit right?\n"},
    {"--sheet first --page 20x20 --margin 2", "on this page the drawing is less than 1 mm large: is --page right?\n"},
    {"--page 20x20 --margin 6", "on this page the drawing is less than 10 mm large: is --page right?\n"},
    {"--page 20x20 --margin 2", ""},
    {"--group body -f pdf", "--group has no effect: only svg has groups\n"},
    {"--id-prefix a -f tikz", "--id-prefix has no effect: only svg has ids\n"},
    {"--background red -f dxf", "--background has no effect: dxf has no background\n"},
    {"--background red -f hpgl", "--background has no effect: hpgl has no background\n"},
    {"--fill red -f dxf", "--fill has no effect: dxf has no filled areas\n"},
    {"--fill red -f hpgl", "--fill has no effect: pens cannot fill\n"},
    {"--fill red -f csv", "--fill has no effect: csv has no page\n"},
    {"--fill red", ""},
    {"--light 1,2,3", "--light has no effect: nothing is shaded without --fill shade or --hatch\n"},
    {"--style all:width=0.2,color=red", ""},
    {"--style all:width=50", "--style all: a pen of 50 mm is very wide for a page of 210 x 297 mm\n"},
    {"--style all:width=1 --style hatch:width=2", "--style hatch has no effect: faces are not hatched without"},
    {"--light 1,2,3 --hatch faces=sections --eye 0,-4,0 --near 3.5",
     "--light has no effect: sections are hatched in one tone\n"},
    {"--fill shade --light 1,2,3", ""},
    {"--fill shade:red -f tikz", ""},
    {"--style crease:width=1 -f dxf", "the width of a pen has no effect: dxf has no widths of lines\n"},
    {"--style crease:width=1 --style outline:color=red -f hpgl", ""},
    {"--style outline:color=red -f dxf", ""},
    {"--dpi 20 -o in/a.png", ""},
    {"--style outline:width=21", ""},
    {"--style outline:width=21.1", "--style outline: a pen of 21.1 mm is very wide for a page of 210 x 297 mm\n"},
    {"--style outline:width=50 --page 600x500", ""},
    {"--style crease:width=1000,off", "the pen of --style crease has no effect: these lines are off\n"},
    {"--style hidden:color=red", "--style hidden has no effect: hidden lines are not drawn without --hidden dashed or "
                                 "solid\n"},
    {"--style hidden:width=1 --hidden none", "--style hidden has no effect"},
    {"--style hidden:color=red --hidden solid", ""},
    {"--style hidden:width=0.7 --hidden solid", ""},
    {"--style hidden:dash=none --hidden solid", ""},
    {"--style hidden:dash=2 --hidden solid",
     "dash= of --style hidden has no effect: --hidden solid draws these lines without dashes\n"},
    {"--style hidden:off",
     "--style hidden has no effect: hidden lines are not drawn without --hidden dashed or solid\n"},
    {"--style symbol:off", "--style symbol has no effect: it is not drawn without --sheet\n"},
    {"--style frame:off", ""},
    {"--style frame:width=2", "--style frame has no effect: it is not drawn without --frame\n"},
    {"--style frame:width=2 --frame", ""},
    {"--style frame:width=2,on", ""},
    {"--frame --margin 0", "--margin 0 cuts off part of the frame's line; --margin 0.35 leaves it whole\n"},
    {"--frame --margin 0.35", ""},
    {"--margin 0", ""},
    {"--frame --style frame:width=2 --margin 0.9", "--margin 0.9 cuts off part of the frame's line; --margin 1 leaves"},
    {"--style symbol:width=2", "--style symbol has no effect: it is not drawn without --sheet\n"},
    {"--style symbol:width=2 --sheet first --landscape", ""},
    {"--style outline:off,width=1", "the pen of --style outline has no effect: these lines are off\n"},
    {"--style outline:off", ""},
    {"--style crease:color=red --style crease:off", "the pen of --style crease has no effect: these lines are off\n"},
    {"--style crease:off,width=1,on", ""},
    {"--style hidden:off,width=1 --hidden dashed", "the pen of --style hidden has no effect: these lines are off\n"},
    {"--style hidden:off --hidden dashed", "--hidden has no effect: --style turns these lines off\n"},
    {"--frame --style frame:off", "--frame has no effect: --style turns these lines off\n"},
    {"--hatch on --style hatch:off", "--hatch has no effect: --style turns these lines off\n"},
    {"--frame --style frame:off,width=2", "the pen of --style frame has no effect: these lines are off\n"},
    {"--style symbol:dash=2,off --sheet first", "the pen of --style symbol has no effect: these lines are off\n"},
    {"--style text:width=1", "--style text has no effect: there is no text without --label, --labels, --frame=zones, "
                             "or --sheet with --title, --field or --dimensions\n"},
    {"--style text:width=0.3 --title T", "--style text has no effect: there is no text without --label"},
    {"--title T", ""},
    {"--title T -f tikz", ""},
    {"--title T -f pdf", "--title has no effect: only svg, tikz and sheets have a title\n"},
    {"--description T -f tikz", ""},
    {"--crop --align left", "--align has no effect: --crop leaves no room to move in\n"},
    {"--description T -f pdf", "--description has no effect: only svg and tikz have a description\n"},
    {"--style text:width=0.3 --label vertices", ""},
    {"--style text:width=0.3 --frame=zones", ""},
    {"--style text:width=0.3 --frame=zones --style frame:off", "--frame has no effect: --style turns these lines off\n"
                                                               "roberts: warning: --style text has no effect: "},
    {"--style text:off --label vertices", "text has no effect: --style text:off leaves it out\n"},
    {"--style text:off", "--style text has no effect: there is no text without --label"},
    {"--style hidden-text:width=0.3 --label vertices",
     "--style hidden-text has no effect: hidden things have labels only with --hidden, and --label vertices or edges, "
     "or --labels\n"},
    {"--style hidden-text:width=0.3 --label faces,bodies --hidden dashed", "--style hidden-text has no effect"},
    {"--style hidden-text:width=0.3 --label faces,edges --hidden dashed", ""},
    {"--style hidden-text:width=0.3 --labels one-name.csv --hidden dashed", ""},
    {"--dash real", "--dash real has no effect: no lines are dashed, as by --hidden dashed\n"},
    {"--dash real --hidden solid", "--dash real has no effect"},
    {"--dash real --hidden dashed", ""},
    {"--dash real --style crease:dash=2", ""},
    {"--dash pattern", ""},
    {"-f csv --page a3", "--page has no effect: csv has no page\n"},
    {"-f csv --background white", "--background has no effect: csv has no page\n"},
    {"-f json --scale 1:2 --unit in --margin 5 --landscape --frame",
     "--landscape, --margin, --scale, --unit, --frame have no effect: json has no page\n"},
    {"-f null --order none --dpi 90", "--dpi, --order have no effect: null has no page\n"},
    {"--columns +ends", "--columns has no effect: svg is no table\n"},
    {"-f csv --columns +ends", ""},
    {"-f csv --columns +level",
     "--columns +level has no effect: it is 0 in visible rows, and there are no others without "
     "--hidden\n"},
    {"-f csv --columns +level --hidden dashed", ""},
    {"-f csv --columns +by",
     "--columns +by has no effect: it is empty in visible rows, and there are no others without --hidden\n"},
    {"--merge-regions",
     "--merge-regions has no effect: there are no regions without --regions, --fill, --hatch or labels of faces\n"},
    {"--merge-regions --fill white -f csv", "--merge-regions has no effect"},
    {"--merge-regions --fill white", "--merge-regions has no effect: fills of one colour are joined anyway\n"},
    {"--merge-regions --fill white --group element", ""},
    {"--merge-regions --fill body --union", ""},
    {"--merge-regions --fill shade", ""},
    {"--merge-regions --regions in/r.json", ""},
    {"-f null -o in/b.svg", "--output has no effect: the format null writes nothing\n"},
    {"-f csv --hidden dashed --crease 5", ""},
};

static void idle_options_are_warned_of(void **state)
{
    char line[300], said[300];
    (void)state;
    put("one-name.csv", "vertex,0,A\n");
    for (size_t i = 0; i < sizeof idle_cases / sizeof idle_cases[0]; i++) {
        snprintf(line, sizeof line, "%s models/platonic/cube.off", idle_cases[i].arguments);
        print_message("roberts %s\n", line);
        assert_int_equal(run(line), 0);
        if (idle_cases[i].said[0]) {
            snprintf(said, sizeof said, "roberts: warning: %s", idle_cases[i].said);
            assert_int_equal(strncmp(last.err, said, strlen(said)), 0);
        } else {
            assert_string_equal(last.err, "");
        }
        snprintf(line, sizeof line, "-q %s models/platonic/cube.off", idle_cases[i].arguments);
        assert_int_equal(run(line), 0);
        assert_string_equal(last.err, "");
    }
}

/* Classes that these models do not have, and bodies that no union joins. */
static const struct {
    const char *arguments, *said;
} lacking_cases[] = {
    {"--style wire:off models/platonic/cube.off",
     "models/platonic/cube.off: warning: --style wire has no effect: the drawing has no such lines\n"},
    {"--style border:width=2 --style intersection:color=red models/platonic/cube.off",
     "models/platonic/cube.off: warning: --style border, --style intersection have no effect: the drawing has no such "
     "lines\n"},
    {"--style crease:width=1 --view top models/platonic/cube.off",
     "models/platonic/cube.off: warning: --style crease has no effect: the drawing has no such lines\n"},
    {"--style crease:width=1 models/platonic/cube.off", ""},
    {"--style border:width=2 models/shapes/moebius-strip.off", ""},
    {"--style intersection:off models/interpenetrating-cubes.off", ""},
    {"--style hidden:width=1 --hidden dashed --view top models/platonic/cube.off", ""},
    {"--style hidden:width=1 --hidden dashed triangle.off",
     "triangle.off: warning: --style hidden has no effect: the drawing has no such lines\n"},
    {"--style crease:width=1 --sheet first --landscape models/platonic/cube.off", ""}, /* its isometric view has some */
    {"--style wire:off --turntable 2 -o in/w%d.svg models/platonic/cube.off", ""},
    {"--union triangle.off", "triangle.off: warning: --union has no effect: no body is closed\n"},
    {"--union triangle.off models/platonic/cube.off", ""},
    {"--hull models/platonic/cube.off",
     "models/platonic/cube.off: warning: --hull has no effect: all bodies are convex solids\n"},
    {"--hull --batch in models/platonic/cube.off", ""},
    {"--hull points.off", ""},
    {"-f csv --columns +name,+ends models/platonic/cube.off",
     "models/platonic/cube.off: warning: --columns +name has no effect: no body has a name in the file\n"},
    {"-f csv --columns +by --hidden dashed models/platonic/cube.off",
     "models/platonic/cube.off: warning: --columns +by has no effect: no body has a name in the file\n"},
    {"-f csv --columns +name,+by --hidden dashed named.obj", ""},
    {"-f csv --columns +name --batch in models/platonic/cube.off", ""},
    {"--fill-rule evenodd models/platonic/cube.off",
     "models/platonic/cube.off: warning: --fill-rule has no effect: no face crosses itself\n"},
    {"--fill-rule nonzero models/platonic/cube.off", ""},
    {"--rounded models/platonic/cube.off",
     "models/platonic/cube.off: warning: --rounded has no effect: coordinates have no decimals, or more than nine "
     "digits and are no 32-bit floats, or so few that --epsilon must tell what touches\n"},
    {"--rounded float.stl",
     "float.stl: warning: --rounded has no effect: coordinates are 32-bit floats, whose rounding counts anyway\n"},
    {"--rounded --epsilon 1e-9 models/platonic/cube.off", ""},
    {"--rounded --batch in models/platonic/cube.off", ""},
    {"--rounded rounded.off models/platonic/cube.off", ""},
    {"crossing.off", "crossing.off: note: faces cross, and coordinates are decimals of few digits or 32-bit floats; if "
                     "these were rounded, "
                     "--rounded draws what touched before\n"},
    {"--rounded crossing.off", ""},
    {"--epsilon 1e-9 crossing.off", ""},
    {"--fill-rule evenodd --batch in models/platonic/cube.off", ""},
    {"--fill-rule evenodd models/star/pentagrammic-prism.off", ""},
};

/* A triangle as binary STL, on a machine whose numbers begin with their low bytes. */
static void put_float_stl(const char *path)
{
    const char head[80] = "a header";
    const uint32_t count = 1;
    const float facet[12] = {0, 0, 1, 0, 0, 0, 0.1F, 0, 0, 0, 0.1F, 0};
    const uint16_t none = 0;
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(head, sizeof head, 1, file) + fwrite(&count, sizeof count, 1, file) +
                         fwrite(facet, sizeof facet, 1, file) + fwrite(&none, sizeof none, 1, file),
                     4);
    assert_int_equal(fclose(file), 0);
}

static void what_a_drawing_lacks_is_warned_of(void **state)
{
    char line[300], said[300];
    (void)state;
    put("named.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\no lid\nf 1 2 3\n");
    put("triangle.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    put("points.off", "OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
    put("crossing.off", "OFF\n6 2 0\n0 0 0\n1.414214 0 0\n0 1 0\n.2 .2 -1\n.2 .2 1\n2 2 0\n3 0 1 2\n3 3 4 5\n");
    put_float_stl("float.stl");
    put("rounded.off", "OFF\n3 1 0\n0 0 0\n0.707107 0 0\n0 0.707107 0\n3 0 1 2\n");
    for (size_t i = 0; i < sizeof lacking_cases / sizeof lacking_cases[0]; i++) {
        print_message("roberts %s\n", lacking_cases[i].arguments);
        assert_int_equal(run(lacking_cases[i].arguments), 0);
        snprintf(said, sizeof said, "%s%s", lacking_cases[i].said[0] ? "roberts: " : "", lacking_cases[i].said);
        assert_string_equal(last.err, said);
        snprintf(line, sizeof line, "-q %s", lacking_cases[i].arguments);
        assert_int_equal(run(line), 0);
        assert_string_equal(last.err, "");
    }
}

static void endings_that_mislead_are_warned_of(void **state)
{
    (void)state;
    assert_int_equal(run("-f pdf -o in/a.svg models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "roberts: in/a.svg: warning: its ending says svg, but it is pdf, as --format says\n");
    assert_int_equal(run("-f svg -o in/a.STL models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "roberts: in/a.STL: warning: its ending says that it is a model, but it is svg, as "
                                  "--format says\n");
    assert_int_equal(run("-f pdf -q -o in/a.svg models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("-f pdf -o in/a.PDF models/platonic/cube.off"), 0);
    assert_int_equal(run("-f eps -o in/a models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("-f null --regions in/a.svg models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "roberts: in/a.svg: warning: its ending says svg, but regions are written as json\n");
    assert_int_equal(run("-f null --regions in/a.xyz models/platonic/cube.off"), 0);
    assert_string_equal(last.err,
                        "roberts: in/a.xyz: warning: no format has this ending; regions are written as json\n");
    assert_int_equal(run("-f null --regions in/a.json models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("-f null --regions ./a models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("-f null --regions in/a.csv models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("--plan -o in/p.svg models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "roberts: in/p.svg: warning: its ending says svg, but it is a plan, for --part\n");
    assert_int_equal(run("--part 1/2 -o in/q.PDF models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "roberts: in/q.PDF: warning: its ending says pdf, but it is a part of a drawing, for "
                                  "--join\n");
    assert_int_equal(run("--part 1/2 -o in/q.off models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "roberts: in/q.off: warning: its ending says that it is a model, but it is a part of "
                                  "a drawing, for --join\n");
    assert_int_equal(run("--part 1/2 -q -o in/q.svg models/platonic/cube.off"), 0);
    assert_int_equal(run("--part 1/2 -o in/q.1 models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "");
}

/* A place for a number without a turntable; a place for a view without tables. */
static void places_that_nothing_fills_are_warned_of(void **state)
{
    static const char said[] = "warning: the file gets this very name: only --turntable puts a number there\n";
    char whole[200];
    (void)state;
    assert_int_equal(run("-o in/one-%03d.svg models/platonic/cube.off"), 0);
    snprintf(whole, sizeof whole, "roberts: in/one-%%03d.svg: %s", said);
    assert_string_equal(last.err, whole);
    assert_int_equal(access("in/one-%03d.svg", F_OK), 0);
    assert_int_equal(run("-o in/%d --sheet first models/platonic/cube.off"), 0);
    assert_said(said);
    assert_int_equal(run("-q -o in/one-%03d.svg models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("-o in/one-%03d.svg --turntable 2 models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("-o in/100%.svg models/platonic/cube.off"), 0); /* no place for a number */
    assert_string_equal(last.err, "");
    assert_int_equal(run("-o in/%s.svg --sheet first models/platonic/cube.off"), 0);
    assert_said("in/%s.svg: warning: the file gets this very name: only tables of --sheet have the name of a view "
                "there\n");
    assert_int_equal(run("-o in/%s-%s.csv --sheet first models/platonic/cube.off"), 0);
    assert_said(
        "in/%s-%s.csv: warning: the file gets this very name: %s, for the name of a view, may stand there once");
    assert_int_equal(run("-o in/%s.csv --sheet first models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "");
}

/* The user waits for a drawing, and the program for a model. */
static void terminals_are_told_of(void **state)
{
    (void)state;
    int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0)
        SKIP_BECAUSE("no terminal can be opened");
    for (int quiet = 0; quiet < 2; quiet++) {
        assert_int_equal(write(terminal, "\004", 1), 1); /* ctrl-D */
        finish(start(quiet ? "-q" : "--view top", ptsname(terminal), -1));
        assert_int_equal(last.status, 1);
        assert_true((strstr(last.err, "roberts: reading the model from the terminal; ctrl-D ends it") != NULL) !=
                    quiet);
        assert_said("roberts: standard input:1: the input is empty\n");
    }
    close(terminal);
    finish(start("--view top", "/dev/null", -1));
    assert_string_equal(last.err, "roberts: standard input:1: the input is empty\n");
}

/* A terminal must not obey control characters in a name. */
static void names_are_printed_plainly(void **state)
{
    (void)state;
    assert_int_equal(run("a\x1b[31m\x7f.off"), 1);
    assert_string_equal(last.err, "roberts: a\\x1b[31m\\x7f.off: No such file or directory\n");
    assert_int_equal(run("models/platonic/cube.off --view \x1b[1m"), 2);
    assert_null(strchr(last.err, '\x1b'));
    put_cube("b\x07.off", 0, 0, 6);
    assert_int_equal(run("-v -f csv b\x07.off -o c\x07 --verify --turntable 1 -o c\x07%d.csv --stats"), 0);
    assert_said("roberts: b\\x07.off: 1 body, ");
    assert_said("roberts: c\\x07"
                "0.csv: verify: ");
    assert_said("roberts: c\\x07"
                "0.csv: 9 segments; ");
    assert_null(strchr(last.err, '\x07'));
}

/* A file opened later must not get the number of a closed stream: the messages would go to it. */
static void closed_streams_stay_taken(void **state)
{
    (void)state;
    put("err", "");
    start_error = CLOSED;
    int written = run("models/platonic/cube.off -v -f svg -o /dev/fd/2"); /* could not be opened */
    int missing = run("missing.off");
    start_error = -1;
    assert_int_equal(written, 0);
    assert_int_equal(missing, 1);
    assert_string_equal(last.err, "");
}

static void several_points_are_picked(void **state)
{
    (void)state;
    assert_int_equal(run("--pick 2.5,-2 --pick=-1e6,0 --view top -f null models/cube-behind-cube.off"), 0);
    assert_string_equal(last.err, "roberts: pick 2.5,-2: body 0, face 0, depth 2.5, at 2,1.5,4\n"
                                  "roberts: pick -1000000,0: nothing is there; the picture reaches from "
                                  "-4.5,-3.5 to 4.5,3.5\n");
}

static void sizes_of_paper(void **state)
{
    (void)state;
    assert_int_equal(run("--page B5 models/platonic/cube.off"), 0);
    assert_non_null(strstr(last.out, "width=\"176mm\" height=\"250mm\""));
    assert_int_equal(run("--page 100X50.5 models/platonic/cube.off"), 0);
    assert_non_null(strstr(last.out, "width=\"100mm\" height=\"50.5mm\""));
    assert_int_equal(run("--page b0 models/platonic/cube.off"), 0);
    assert_non_null(strstr(last.out, "width=\"1000mm\" height=\"1414mm\""));
    assert_int_equal(run("--page Letter models/platonic/cube.off"), 0);
    assert_non_null(strstr(last.out, "width=\"215.9mm\" height=\"279.4mm\""));
}

/* ---- drawings that show nothing ---- */

/* Writes a sheet of n x n squares, bent like a gutter: the higher, the farther from its left side. */
static void put_tiles(const char *path, int n, double bend)
{
    char text[40000];
    size_t used = (size_t)snprintf(text, sizeof text, "OFF %d %d 0\n", (n + 1) * (n + 1), n * n);
    for (int v = 0; v < (n + 1) * (n + 1); v++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%d %d %g\n", v % (n + 1), v / (n + 1),
                                 bend * (v % (n + 1)) * (v % (n + 1)));
    for (int f = 0, a; f < n * n; f++) {
        a = f / n * (n + 1) + f % n;
        used += (size_t)snprintf(text + used, sizeof text - used, "4 %d %d %d %d\n", a, a + 1, a + n + 2, a + n + 1);
    }
    put(path, text);
}

/* 2 n (n - 1) of 2 n (n + 1) edges are flat: few of two squares a side, as of a net, and most of six. */
static void flat_sheets_are_told(void **state)
{
    static const char said[] = "edges between faces in one plane are left out, so that only borders are drawn; "
                               "--all-edges draws them\n";
    (void)state;
    put_tiles("few.off", 2, 0.0);
    put_tiles("many.off", 6, 0.0);
    put_tiles("curved.off", 24, 0.001);
    assert_int_equal(run("few.off --view top -o a.svg"), 0);
    assert_said(said);
    assert_int_equal(run("many.off --view top -o a.svg"), 0);
    assert_said(said);
    put("poster.off", "OFF\n4 1 0\n-9 -9 9\n9 -9 9\n9 9 9\n-9 9 9\n4 0 1 2 3\n");
    static const char *const silent[] = {"--all-edges many.off", "--crease 1 many.off", "many.off models/table.off",
                                         "poster.off models/platonic/cube.off", "curved.off"};
    for (size_t i = 0; i < sizeof silent / sizeof silent[0]; i++) {
        char line[100];
        snprintf(line, sizeof line, "--view top -o a.svg %s", silent[i]);
        assert_int_equal(run(line), 0);
        assert_null(strstr(last.err, said));
    }
}

/* Names of things that the model does not have. */
static void idle_names_are_told(void **state)
{
    static const struct {
        const char *names, *said;
    } rows[] = {
        {"vertex,7,A\nedge,1-0,B\nface,5,C\nbody,0,D\n", ""},
        {"vertex,8,A\n", "there is no vertex 8, which names.csv names\n"},
        {"edge,0-7,A\nedge,0-1,B\n", "there is no edge 0-7, which names.csv names\n"},
        {"face,6,A\nbody,1,B\n", "there is no face 6, which names.csv names, and 1 more of its names has no effect\n"},
        {"body,1,B\n", "there is no body 1, which names.csv names\n"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        put("names.csv", rows[i].names);
        for (int batch = 0; batch < 2; batch++) {
            assert_int_equal(run(batch ? "--labels names.csv models/platonic/cube.off -f svg --batch ."
                                       : "--labels names.csv models/platonic/cube.off -o a.svg"),
                             0);
            if (*rows[i].said)
                assert_said(rows[i].said);
            else
                assert_string_equal(last.err, "");
        }
    }
}

static const struct {
    const char *arguments, *why; /* empty: the drawing shows something */
} empty_cases[] = {
    {"--eye 20,10,500 --look-at 200,200,490 --fov 10",
     "no line of the scene lies in the field of view; --look-at turns "},
    {"--eye 20,10,500 --look-at 200,200,490 --fov 10 -f null", "no line of the scene lies in the field of view; "},
    {"--eye 20,10,500 --look-at 200,200,490 --fov 10 -f csv", ""}, /* tables include anything outside, too */
    {"--eye 20,10,500 --fov 1", ""},                               /* looks at the middle by default */
    {"--eye 20,10,500 --look-at 60,10,0 --up 0,1,0 --fov 3 --page 300x10 --margin 1", ""}, /* the picture is as wide */
    {"--eye 20,10,500 --look-at 60,10,0 --up 0,1,0 --fov 3 --page 10x300 --margin 1", "no line of the scene lies in "},
    {"--eye 20,12,-100 --look-at 20,12,0 --fov .1",
     "no line of the scene lies in the field of view; "}, /* a face alone */
    {"--eye 1e17,0,0",
     "from so far away the whole scene is smaller than the touching distance; bring --eye nearer, or "},
    {"--eye 1e17,0,0 -f json", "from so far away the whole scene is smaller than the touching distance"},
    {"--style outline:off --style crease:off", "--style has turned off all lines that could be seen\n"},
    {"--style outline:off --style crease:off --hidden solid", ""},
    {"--view top", ""},
};

static void empty_drawings_are_warned_of(void **state)
{
    char line[300], said[300];
    (void)state;
    for (size_t i = 0; i < sizeof empty_cases / sizeof empty_cases[0]; i++) {
        snprintf(line, sizeof line, "%s models/table.off", empty_cases[i].arguments);
        print_message("roberts %s\n", line);
        assert_int_equal(run(line), 0);
        bool is_null = strstr(line, "null") != NULL;
        snprintf(said, sizeof said, "roberts: %s: warning: the drawing is empty: %s",
                 is_null ? "models/table.off" : "standard output", empty_cases[i].why);
        if (empty_cases[i].why[0] && strncmp(last.err, said, strlen(said)) != 0)
            fail_msg("%s\nis not %s", last.err, said);
        if (!empty_cases[i].why[0])
            assert_string_equal(last.err, "");
        snprintf(line, sizeof line, "-q %s models/table.off", empty_cases[i].arguments);
        assert_int_equal(run(line), 0);
        assert_string_equal(last.err, "");
    }
    assert_int_equal(run("--eye 20,10,500 --look-at 200,200,490 --fov 10 models/table.off -o in/a.png"), 0);
    assert_said("roberts: in/a.png: warning: the drawing is empty: ");
    put("in/wire.off", "OFF\n2 1 0\n1 2 3\n2 3 4\n2 0 1\n");
    assert_int_equal(run("--dir 1,1,1 in/wire.off -o in/a.svg"), 0);
    assert_string_equal(last.err, "roberts: in/a.svg: warning: the drawing is empty: all lines that could be seen are "
                                  "points from there; --view and --dir look from elsewhere\n");
    assert_int_equal(run("--dir 1,1,1 --label vertices in/wire.off -o in/a.svg"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("--dir 1,1,1 in/wire.off -o in/a.csv"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("--view top in/wire.off -o in/a.svg"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("--eye 70,-60,60 --look-at 500,-500,500 models/table.off"), 1);
    assert_said("roberts: models/table.off: nothing of the scene lies in front of the eye, beyond the near plane at a "
                "distance of ");
    assert_int_equal(run("--eye 20,10,500 --near 600 models/table.off models/tower.off"), 1);
    assert_said(
        "roberts: models/table.off and 1 more: nothing of the scene lies in front of the eye, beyond the near plane "
        "at a distance of 600; move the eye, the look-at point or the near plane\n");
    assert_int_equal(run("--view top --section 0,0,-99 models/table.off"), 1);
    assert_said("roberts: models/table.off: nothing of the scene lies beyond the section; move its point toward the "
                "viewer, or the way its direction points\n");
    assert_int_equal(run("--view iso --section 0,0,0,-1,0,0 models/table.off"), 1);
    assert_said("roberts: models/table.off: the section faces away from the viewer; turn its direction round, or look "
                "from the other side\n");
    assert_int_equal(run("--eye 9,9,9 --look-at 9,9,9 models/table.off"), 1);
    assert_said("roberts: models/table.off: the eye is at the point that it looks at; move one of them\n");
}

/* A cube from -1 to 1; near planes at a thousandth of the way to its centre unless given. */
static const struct {
    const char *arguments, *said; /* empty: nothing; "!": nothing of the near plane */
} near_cases[] = {
    {"--eye 0,-1,0", "0.001 before the eye, cuts solid 0 in the middle"},          /* on a face */
    {"--eye 1,1,1", "0.00173 before the eye, cuts solid 0 in the middle"},         /* on a vertex */
    {"--eye 0,-1.0005,0", "0.001 before the eye, cuts solid 0 in the middle"},     /* nothing is drawn */
    {"--eye 1.0001,1.0001,1.0001", "0.00173 before the eye, cuts solid 0 in the"}, /* two ends of lines are */
    {"--eye 0,-1.0005,0 -f null", "0.001 before the eye, cuts solid 0 in the middle"},
    {"--eye 0,-1.0005,0 --near 0.0001", ""},
    {"--eye 0,-1.002,0", ""},
    {"--eye 0,-4,0 --near 3.5", ""}, /* its cut alone is drawn */
    {"--eye 0,-4,0 --near 3.5 --fov 20",
     "3.5 before the eye, cuts solid 0 in the middle"},  /* its border lies outside of the picture */
    {"--eye 2,-4,3 --near 4", ""},                       /* intended, and something is drawn */
    {"--eye 0,-3,0 --look-at 3,-3,0.5 --near 0.1", "!"}, /* not by the near plane */
    {"-q --eye 0,-1,0", ""},
};

static void cuts_in_the_middle_are_warned_of(void **state)
{
    char line[300];
    (void)state;
    for (size_t i = 0; i < sizeof near_cases / sizeof near_cases[0]; i++) {
        const char *said = near_cases[i].said;
        snprintf(line, sizeof line, "%s models/platonic/cube.off", near_cases[i].arguments);
        print_message("roberts %s\n", line);
        assert_int_equal(run(line), 0);
        if (*said == '!')
            assert_null(strstr(last.err, "the near plane"));
        else if (*said) {
            assert_said("warning: the near plane, ");
            assert_said(said);
            assert_null(strstr(last.err, "the drawing is empty"));
        } else
            assert_string_equal(last.err, "");
    }
    print_message("an eye inside a ring\n");
    assert_int_equal(run("--eye 3,0,0 --look-at 4,1,0.2 models/shapes/torus.off"), 0);
    assert_said("warning: the near plane, ");
    assert_said("if the eye is inside the solid, move --eye out");
}

/* ---- several pictures ---- */

/* Line `number` of the messages, from 0. */
static void assert_line(int number, const char *begins)
{
    const char *line = last.err;
    for (int i = 0; i < number && strchr(line, '\n'); i++)
        line = strchr(line, '\n') + 1;
    if (strncmp(line, begins, strlen(begins)) != 0)
        fail_msg("line %d is: %.200s\nnot: %s", number, line, begins);
}

#define JSON_BEGINS "{\"version\":\"" ROBERTS_VERSION "\",\"file\":"

static void each_of_several_pictures_is_named(void **state)
{
    (void)state;
    assert_int_equal(run("--batch in -f null --verify --pick 0,0 --pick 1e6,0 --stats=json models/platonic/cube.off "
                         "models/platonic/octahedron.off"),
                     0);
    assert_line(0, "roberts: models/platonic/cube.off: verify: ");
    assert_line(1, "roberts: models/platonic/cube.off: pick 0,0: body 0, ");
    assert_line(2, "roberts: models/platonic/cube.off: pick 1000000,0: nothing is there");
    assert_line(3, JSON_BEGINS "\"models/platonic/cube.off\",\"output\":null,\"files\":1,");
    assert_line(4, "roberts: models/platonic/octahedron.off: verify: ");
    assert_line(7, JSON_BEGINS "\"models/platonic/octahedron.off\",");
    assert_int_equal(run("--batch in --stats models/platonic/cube.off models/platonic/octahedron.off"), 0);
    assert_line(0, "roberts: models/platonic/cube.off: statistics\n");
    assert_said("\nroberts: models/platonic/octahedron.off: statistics\n");
    assert_int_equal(run("--turntable 2 -o in/t-%d.svg --verify --stats=json models/platonic/cube.off"), 0);
    assert_line(0, "roberts: in/t-0.svg: verify: ");
    assert_line(1, JSON_BEGINS "\"models/platonic/cube.off\",\"output\":\"in/t-0.svg\",");
    assert_line(2, "roberts: in/t-1.svg: verify: ");
    assert_int_equal(run("--sheet third --verify models/platonic/cube.off"), 0);
    assert_line(0, "roberts: front: verify: ");
    assert_line(1, "roberts: top: verify: ");
    assert_line(2, "roberts: right: verify: ");
    assert_line(3, "roberts: iso: verify: ");
    assert_int_equal(run("--batch in --sheet first --verify models/platonic/cube.off"), 0);
    assert_line(2, "roberts: models/platonic/cube.off: left: verify: ");
}

static void names_in_json(void **state)
{
    (void)state;
    put_cube("q\"\\\t\x01\xc3\xa9\xff\xe0\x80.off", 0, 0, 6);
    assert_int_equal(run("--stats=json q\"\\\t\x01\xc3\xa9\xff\xe0\x80.off"), 0);
    assert_said(",\"file\":\"q\\\"\\\\\\u0009\\u0001\xc3\xa9\\ufffd\\ufffd\\ufffd.off\",\"output\":\"-\",");
}

/* The counts of --stats add up, and --verify reports which segments it checks. */
static void counts_agree(void **state)
{
    unsigned points, checked;
    (void)state;
    assert_int_equal(run("--stats --verify -f null models/table.off --hidden dashed"), 0);
    assert_int_equal(sscanf(last.err, "roberts: verify: %u points of %u segments checked", &points, &checked), 2);
    assert_said(" segments checked, visible and hidden, drawn or not; ");
    const char *segments = strstr(last.err, "  segments\n");
    assert_true(segments && segments - last.err > 14);
    assert_int_equal(strtoul(segments - 14, NULL, 10), checked);
    assert_said("508  to draw, which leaves out those below the crease angle\n");
    assert_int_equal(run("--stats -f null models/table.off"), 0);
    assert_said("345  to draw, which leaves out those at the back and below the crease angle\n");
    assert_int_equal(run("--stats=json -f null models/table.off"), 0);
    assert_said(",\"strokes\":null,\"pen_down_mm\":null,\"pen_up_mm\":null,\"scale\":null,\"origin_mm\":null,");
    assert_int_equal(run("--stats=json --verify=2 -q -f null models/table.off --hidden dashed"), 0);
    assert_said(",\"segments\":572,");
    assert_said(",\"verified\":{\"segments\":572,\"points\":");
    assert_said(",\"undecided\":0,\"contradictions\":0},\"seconds\":{");
    assert_int_equal(run("--stats=json --verify -q -f null models/platonic/cube.off --sheet third"), 0);
    assert_said(",\"verified\":{\"segments\":21,\"points\":63,\"undecided\":0,\"contradictions\":0},"); /* all views */
    assert_int_equal(run("--stats=json -f null models/platonic/cube.off"), 0);
    assert_said(",\"verified\":null,\"seconds\":{");
}

/* Rays that decide nothing prove nothing. The report itself is no warning. */
static void undecided_is_no_proof(void **state)
{
    (void)state;
    put("specks.off", "OFF\n8 8 0\n0 0 0\n.1 0 0\n0 .1 0\n0 0 .1\n40 40 40\n40.1 40 40\n40 40.1 40\n40 40 40.1\n"
                      "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 4 6 5\n3 4 5 7\n3 4 7 6\n3 5 6 7\n");
    assert_int_equal(run("--verify -f null --epsilon 0.02 specks.off"), 0);
    assert_said("warning: verify: most points are undecided: they are within about epsilon of a change, and epsilon is "
                "0.02 (as given)\n");
    assert_int_equal(run("--verify -f null specks.off"), 0);
    assert_null(strstr(last.err, "most points"));
    assert_int_equal(run("--verify -q -f null --epsilon 0.02 specks.off"), 0);
    assert_line(0, "roberts: verify: ");
    assert_null(strstr(last.err, "warning"));
}

int main(void)
{
    if (!program_find())
        return 1;
    const struct CMUnitTest tests[] = {
        IN_FOLDER(messages_name_the_file),
        IN_FOLDER(warnings_name_the_file),
        IN_FOLDER(one_model_after_another),
        IN_FOLDER(one_model_after_another_in_a_pipe),
        IN_FOLDER(numbers_that_are_missing),
        IN_FOLDER(every_refusal_names_the_file),
        IN_FOLDER(a_tolerance_that_helps_is_named),
        IN_FOLDER(a_tolerance_below_the_limit_is_named),
        IN_FOLDER(a_tolerance_that_passes_any_shape_is_not_named),
        IN_FOLDER(misuse_tells_what_was_meant),
        IN_FOLDER(images_too_large_for_memory),
        IN_FOLDER(empty_names),
        IN_FOLDER(what_is_no_model),
        IN_FOLDER(a_file_called_minus),
        IN_FOLDER(endings_that_mislead_are_warned_of),
        IN_FOLDER(places_that_nothing_fills_are_warned_of),
        IN_FOLDER(idle_options_are_warned_of),
        IN_FOLDER(converters_are_named),
        IN_FOLDER(files_named_twice_are_warned_of),
        IN_FOLDER(what_is_there_once),
        IN_FOLDER(seams_name_their_body),
        IN_FOLDER(round_bodies_are_told),
        IN_FOLDER(what_a_drawing_lacks_is_warned_of),
        IN_FOLDER(terminals_are_told_of),
        IN_FOLDER(names_are_printed_plainly),
        IN_FOLDER(closed_streams_stay_taken),
        IN_FOLDER(several_points_are_picked),
        IN_FOLDER(sizes_of_paper),
        IN_FOLDER(flat_sheets_are_told),
        IN_FOLDER(idle_names_are_told),
        IN_FOLDER(empty_drawings_are_warned_of),
        IN_FOLDER(cuts_in_the_middle_are_warned_of),
        IN_FOLDER(each_of_several_pictures_is_named),
        IN_FOLDER(names_in_json),
        IN_FOLDER(undecided_is_no_proof),
        IN_FOLDER(counts_agree),
    };
    return cmocka_run_group_tests_name("cli_messages", tests, NULL, NULL);
}
