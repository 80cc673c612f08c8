/* test_crystal.c - tools/crystal: the forms of all crystal classes, crystals whose corners are known, and messages. */
#include "program.h"
#include "testing.h"

/* The counts of the crystal that the text describes; all 0 if it is refused. */
static void count(const char *text, unsigned counts[2])
{
    put("crystal.txt", text);
    counts[0] = counts[1] = 0;
    if (run("crystal.txt") == 0)
        assert_int_equal(sscanf(last.out, "OFF\n%u %u 0\n", &counts[0], &counts[1]), 2);
}

/* The general form of a class has as many faces as the class has operations. */
static const struct {
    const char *symbol;
    unsigned faces;
} classes[] = {
    {"1", 1},   {"-1", 2},   {"2", 2},    {"m", 2},     {"2/m", 4},   {"222", 4},   {"mm2", 4},   {"mmm", 8},
    {"4", 4},   {"-4", 4},   {"4/m", 8},  {"422", 8},   {"4mm", 8},   {"-42m", 8},  {"-4m2", 8},  {"4/mmm", 16},
    {"3", 3},   {"-3", 6},   {"32", 6},   {"312", 6},   {"3m", 6},    {"31m", 6},   {"-3m", 12},  {"-31m", 12},
    {"6", 6},   {"-6", 6},   {"6/m", 12}, {"622", 12},  {"6mm", 12},  {"-6m2", 12}, {"-62m", 12}, {"6/mmm", 24},
    {"23", 12}, {"m-3", 24}, {"432", 24}, {"-43m", 24}, {"m-3m", 48},
};

/* Six far planes close the form. Each plane of the form has a face. */
static void general_forms_have_all_faces(void **state)
{
    char text[600];
    (void)state;
    for (size_t i = 0; i < sizeof classes / sizeof classes[0]; i++) {
        const bool hexagonal = strchr("36", classes[i].symbol[classes[i].symbol[0] == '-']) != NULL;
        unsigned counts[2], colored = 0;
        print_message("%s\n", classes[i].symbol);
        snprintf(text, sizeof text,
                 "cell 1 1 1 90 90 %d\nclass %s\nform 1 2 4 1 255 0 0\nform 1 0 0 9\nform -1 0 0 9\nform 0 1 0 9\n"
                 "form 0 -1 0 9\nform 0 0 1 9\nform 0 0 -1 9\n",
                 hexagonal ? 120 : 90, classes[i].symbol);
        count(text, counts);
        for (const char *at = last.out; (at = strstr(at, " 255 0 0 # ")) != NULL; at++)
            colored++;
        assert_int_equal(colored, classes[i].faces);
        assert_true(counts[1] >= classes[i].faces);
    }
}

static const struct {
    const char *name, *text;
    unsigned corners, faces;
} known[] = {
    {"cube", "cell 5 5 5\nclass m-3m\nform 1 0 0 1\n", 8, 6},
    {"octahedron", "cell 5 5 5\nclass m-3m\nform 1 1 1 1\n", 6, 8},
    {"tetrahedron", "cell 5 5 5\nclass -43m\nform 1 1 1 1\n", 4, 4},
    {"rhombic dodecahedron", "cell 5 5 5\nclass m-3m\nform 1 1 0 1\n", 14, 12},
    {"pyritohedron", "cell 5 5 5\nclass m-3\nform 2 1 0 1\n", 20, 12},
    {"cuboctahedron, whose corners have four faces",
     "cell 5 5 5\nclass m-3m\nform 1 0 0 1.5\nform 1 1 1 1.7320508075688772\n", 12, 14},
    {"hexagonal prism", "cell 3 3 5 90 90 120\nclass 6/mmm\nform 1 0 0 1\nform 0 0 1 2\n", 12, 8},
    {"the same by four indices", "cell 3 3 5 90 90 120\nclass 6/mmm\nform 1 0 -1 0 1\nform 0 0 0 1 2\n", 12, 8},
    {"rhombohedron", "cell 5 5 17 90 90 120\nclass -3m\nform 1 0 -1 4 1\n", 8, 6},
    {"triclinic box", "cell 8 7 6 94 105 98\nclass -1\nform 1 0 0 1\nform 0 1 0 1\nform 0 0 1 1\n", 8, 6},
    {"a form beyond the others", "cell 5 5 5\nclass m-3m\nform 1 0 0 1\nform 1 1 1 9\n", 8, 6},
};

static void known_crystals(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        unsigned counts[2];
        print_message("%s\n", known[i].name);
        count(known[i].text, counts);
        assert_int_equal(counts[0], known[i].corners);
        assert_int_equal(counts[1], known[i].faces);
    }
}

/* Angles between faces are those that mineralogy measures: from (0001) to (10-11) of quartz 51.8 degrees. The top face
 * is a triangle whose plane is that far from the apex. */
static void axes_have_their_lengths(void **state)
{
    unsigned counts[2];
    double top_z = 0.0;
    (void)state;
    count("cell 4.913 4.913 5.405 90 90 120\nclass 6/mmm\nform 1 0 1 1\n", counts);
    assert_int_equal(counts[0], 8);
    const char *at = strchr(strchr(last.out, '\n') + 1, '\n');
    for (unsigned i = 0; i < counts[0]; i++) {
        double x, y, z;
        assert_non_null(at);
        assert_int_equal(sscanf(at + 1, "%lf %lf %lf", &x, &y, &z), 3);
        top_z = z > top_z ? z : top_z;
        at = strchr(at + 1, '\n');
    }
    assert_float_equal(top_z, 1.0 / 0.6186, 1e-3); /* 1 / cos 51.79 degrees */
}

/* The second file has the indices of faces, in the order of the faces; faces that the crystal lacks are counted. */
static void faces_have_indices(void **state)
{
    static char text[TEXT];
    (void)state;
    put("crystal.txt", "cell 5 5 7 90 90 120\nclass 6/mmm\nform 1 0 -1 0 1\nform 0 0 1 2\nform 1 0 -1 0 1.5\n"
                       "form 1 1 12 90\n");
    assert_int_equal(run("crystal.txt names.csv"), 0);
    assert_said("crystal: crystal.txt: 18 faces lie outside of the crystal, as (1 0 -1 0)\n");
    read_text("names.csv", text);
    assert_int_equal(count_of(text, "\n"), 8);
    assert_non_null(strstr(text, "face,0,(101\u03050)\n"));
    assert_non_null(strstr(text, ",(001\u0305)\n"));
    assert_non_null(strstr(last.out, " # 1 0 -1 0\n"));
    put("crystal.txt", "cell 5 5 5\nclass m-3m\nform 1 0 0 1\nform 12 1 0 1.05\n");
    assert_int_equal(run("crystal.txt names.csv"), 0);
    read_text("names.csv", text);
    assert_non_null(strstr(text, ",(12 1\u0305 0)\n"));
    assert_int_equal(run("crystal.txt missing/names.csv"), 1);
    assert_int_equal(run("--help"), 0);
    assert_non_null(strstr(last.out, " 6/mmm "));
}

static const struct {
    const char *text, *said;
} refused[] = {
    {"cell 1 1 1\nclass m-3m\nform 1 0 0\n", "crystal.txt:3: form: h k l (or h k i l), a distance"},
    {"cell 1 1 1\nform 1 0 0 1\n", "crystal.txt:2: the lines of cell and class must come before the forms"},
    {"cell 1 1 2\nclass m-3m\n", "crystal.txt:2: class m-3m needs a cell with a = b = c and three right angles"},
    {"cell 1 1 1\nclass m3m\n", "crystal.txt:2: \"m3m\" is no crystal class"},
    {"cell 1 1 1\nclass mmm\nform 1 0 0 1\n", "these forms do not close"},
    {"cell 1 1 1 90 90 120\nclass 6mm\nform 1 0 0 1\nform 1 0 1 1\n", "these forms do not close"},
    {"cell 1 1 1 90 90 120\nclass 6mm\nform 1 0 0 1 1\n", "h + k + i must be 0"},
    {"cell 1 1 1\nclass 1\nform 0 0 0 1\n", "one index at least must not be 0"},
    {"cell 1 1 1\nclass 1\nform 1 0 0 -1\n", "the distance must be above 0"},
    {"cell 1 1 1 20 20 90\n", "crystal.txt:1: no cell has these angles"},
    {"cell 1 one 1\n", "crystal.txt:1: a number expected, found \"one\""},
    {"shape 1\n", "cell, class or form expected, found \"shape\""},
    {"# nothing\n", "a line with a form expected, such as form 1 0 0 1"},
    {"cell 1 1 1\nclass m-3m\nform 1 0 0 1 300 0 0\n", "crystal.txt:3: form: a colour has whole numbers from 0 to 255"},
    {"cell 1 1 1\nclass m-3m\nform 1 0 0 1 0.5 0 0\n", "a colour has whole numbers"},
};

static void wrong_lines_are_named(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        put("crystal.txt", refused[i].text);
        assert_int_equal(run("crystal.txt"), 1);
        if (!strstr(last.err, refused[i].said))
            fail_msg("\"%s\" in \"%s\"", refused[i].said, last.err);
        assert_string_equal(last.out, "");
    }
    assert_int_equal(run("missing.txt"), 1);
    assert_int_equal(run(""), 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(general_forms_have_all_faces), IN_FOLDER(known_crystals),        IN_FOLDER(axes_have_their_lengths),
        IN_FOLDER(faces_have_indices),           IN_FOLDER(wrong_lines_are_named),
    };
    if (!program_find_as("tools/crystal") || access(program, X_OK) != 0)
        return 1;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
