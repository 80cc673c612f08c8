/* test_obj.c - Wavefront OBJ: all forms of corners, groups, colours from .mtl files, what is skipped and what is
 * refused. */

#include "read/obj.h"
#include "read_rows.h"
#include "temporary.h"
#include "testing.h"

#define THREE "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
#define THREE_TEXT "0,0,0 1,0,0 0,1,0"

static const read_good good[] = {
    {"a triangle", THREE "f 1 2 3\n", 0, THREE_TEXT " | 0-1-2", NULL},
    {"corners with texture and normal",
     THREE "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1/1/1 2/1/1 3/1/1\nf 1//1 2//1 3//1\n", 0,
     THREE_TEXT " | 0-1-2 0-1-2 0-1-2", NULL},
    {"a slash and nothing behind it", THREE "f 1/ 2/ 3/\nf 1// 2// 3//\n", 0, THREE_TEXT " | 0-1-2 0-1-2", NULL},
    {"from the end", THREE "f -3 -2 -1\nv 5 5 5\nf -4//-1 -2/-1 -1/-1/-1\n", 0, THREE_TEXT " 5,5,5 | 0-1-2 0-2-3",
     NULL},
    {"a face before its vertices", "f 1 2 3\n" THREE, 0, THREE_TEXT " | 0-1-2", NULL},
    {"many corners", THREE "v 1 1 0\nf 1 2 4 3 1 2\n", 0, THREE_TEXT " 1,1,0 | 0-1-3-2-0-1", NULL},
    {"a face of two corners", THREE "f 1 2\n", 0, THREE_TEXT " | 0-1",
     "0: 1 face with fewer than 3 corners: it hides nothing;"},
    {"lines", THREE "l 1 2/7 3\nl 1\n", 0, THREE_TEXT " | 0-1 1-2", NULL},
    {"points are passed", THREE "p 1 2\nf 1 2 3\n", 0, THREE_TEXT " | 0-1-2", NULL},
    {"objects and groups", THREE "f 1 2 3\no box\nf 1 2 3\ng left wall\nf 3 2 1\ng\nf 1 3 2\n", 0,
     THREE_TEXT " | 0-1-2 0-1-2 2-1-0 0-2-1 | box@1 left wall@2 @3", NULL},
    {"a weight", "v 1 2 3 0.5\nf 1\n", 0, "1,2,3 | 0", "0: 1 face with fewer than 3 corners: it hides nothing;"},
    {"colours of vertices", "v 1 2 3 1 0.5 0\nv 4 5 6\nv 7 8 9 1 0 0.25 1\n", 0, "1,2,3(1,0.5,0) 4,5,6 7,8,9(0,0.25,1)",
     NULL},
    {"numbers that are no colour", "v 1 2 3 255 0 0\n", 0, "1,2,3", NULL},
    {"comments", "# made by\nv 0 0 0 # first\nv 1 0 0 #second\nv 0 1 0\nf 1 2 3 # all\n#end", 0, THREE_TEXT " | 0-1-2",
     NULL},
    {"comments that end in a backslash", THREE "# C:\\a\\\nf 1 2 3 # C:\\b\\\nvn 0 0 1 # C:\\c\\\nf 3 2 1\n", 0,
     THREE_TEXT " | 0-1-2 2-1-0", NULL},
    {"a sign in a word that begins no comment", THREE "xx part#7\\\nf 3 2 1\nf 1 2 3\n", 0, THREE_TEXT " | 0-1-2",
     "4: 1 line ignored, the first with \"xx\";"},
    {"joined lines", "v 0 \\\n 0 \\\r\n 0\nv 1 0 0\nv 0 1 0\nf 1 \\\n2\\\n 3\n", 0, THREE_TEXT " | 0-1-2", NULL},
    {"a joined line that is passed", THREE "vn 0 0 \\\n1\nf 1 2 3\n", 0, THREE_TEXT " | 0-1-2", NULL},
    {"... and comes in pieces", THREE "vn 1\\\nv\nf 1 2 3\nvn 1\\", 0, THREE_TEXT " | 0-1-2",
     NULL}, /* cut after the first backslash */
    {"a backslash that joins nothing", THREE "g a\\b \\ c\nf 1 2 3\n", 0, THREE_TEXT " | 0-1-2 | a\\b \\ c@0", NULL},
    {"CR LF", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\ng a\r\nf 1 2 3\r\n", 0, THREE_TEXT " | 0-1-2 | a@0", NULL},
    {"CR alone", "v 0 0 0\rv 1 0 0\rv 0 1 0\rvn 0 0 1\rf 1 2 3\r", 0, THREE_TEXT " | 0-1-2", NULL},
    {"no line end at the end", THREE "f 1 2 3", 0, THREE_TEXT " | 0-1-2", NULL},
    {"tabs and blanks", "\t v\t0  0 0 \nv 1 0 0\n v 0 1 0\t\n\tf  1\t2 3 \n", 0, THREE_TEXT " | 0-1-2", NULL},
    {"forms of numbers", "v +1 -2. .5\nv 1e2 2.E+1 31e-1\n", 0, "1,-2,0.5 100,20,3.1000000000000001", NULL},
    {"words that are passed", "s off\nmg 1 2\nlod 3\n" THREE "vp 1\nf 1 2 3\n", 0, THREE_TEXT " | 0-1-2", NULL},
    {"words that are not known", THREE "curv 0 1 2\nf 1 2 3\nsurf 0\n", 0, THREE_TEXT " | 0-1-2",
     "4: 2 lines ignored, the first with \"curv\";"},
    {"a material that is not there", "mtllib none.mtl\n" THREE "usemtl red\nf 1 2 3\n", 0, THREE_TEXT " | 0-1-2", NULL},
};

static const read_bad bad[] = {
    {"index 0", THREE "f 1 2 0\n", 0, ROBERTS_BAD_INDEX, 4,
     "face 0 (counted from 0) names vertex 0, but OBJ counts from 1"},
    {"too far back", THREE "f 1 2 3\nf -1 -2 -4\n", 0, ROBERTS_BAD_INDEX, 5,
     "face 1 (counted from 0) names vertex -4, but there are 3 so far"},
    {"a vertex that never comes", THREE "f 1 2 3\nf 1 2 4\nf 5 1 2\nf 5 2 3\n", 0, ROBERTS_BAD_INDEX, 6,
     "a face or line names vertex 5, but there are 3"},
    {"a number beyond all", THREE "f 1 2 99999999999\n", 0, ROBERTS_BAD_INDEX, 4,
     "face 0 (counted from 0) names vertex 99999999999, but there are 3 so far"},
    {"a number of many digits", THREE "f 1 2 11111111111111111111\n", 0, ROBERTS_BAD_SYNTAX, 4,
     "a corner of face 0 (counted from 0) expected, found \"11111111111111111111\""},
    {"a word for a corner", THREE "f 1 2 x\n", 0, ROBERTS_BAD_SYNTAX, 4,
     "a corner of face 0 (counted from 0) expected, found \"x\""},
    {"a decimal corner", THREE "f 1 2 3.5\n", 0, ROBERTS_BAD_SYNTAX, 4,
     "a corner of face 0 (counted from 0) expected, found \"3.5\""},
    {"four parts", THREE "f 1 2 3/1/1/1\n", 0, ROBERTS_BAD_SYNTAX, 4,
     "a corner of face 0 (counted from 0) expected, found \"3/1/1/1\""},
    {"a corner without its vertex", THREE "f 1 2 /3\n", 0, ROBERTS_BAD_SYNTAX, 4,
     "a corner of face 0 (counted from 0) expected, found \"/3\""},
    {"a bad line", THREE "l 1 b\n", 0, ROBERTS_BAD_SYNTAX, 4, "a corner of a line expected, found \"b\""},
    {"a face of nothing", THREE "f\n", 0, ROBERTS_BAD_SYNTAX, 4,
     "a corner of face 0 (counted from 0) expected, but the line ends here"},
    {"two coordinates", "v 0 0\n", 0, ROBERTS_BAD_SYNTAX, 1,
     "z of vertex 0 (counted from 0) expected, but the line ends here"},
    {"a word for a coordinate", "v 0 0 0\nv 0 x 0\n", 0, ROBERTS_BAD_SYNTAX, 2,
     "y of vertex 1 (counted from 0) expected, found \"x\""},
    {"a number with something behind it", "v 0 0 0\nv 0 0 3.1+e2\n", 0, ROBERTS_BAD_SYNTAX, 2,
     "z of vertex 1 (counted from 0) expected, found \"3.1+e2\""},
    {"not a number", "v 0 0 0\nv nan 0 0\n", 0, ROBERTS_BAD_NUMBER, 2,
     "x of vertex 1 (counted from 0) expected, found \"nan\"; it must be a finite number"},
    {"too large", "v 0 0 0\nv 0 0 -2e150\n", 0, ROBERTS_BAD_NUMBER, 2,
     "vertex 1 has a coordinate that is infinite or beyond 1e+150"},
};

static void reads(void **state)
{
    (void)state;
    read_good_rows(good, sizeof good / sizeof good[0]);
}

static void refuses(void **state)
{
    (void)state;
    read_bad_rows(bad, sizeof bad / sizeof bad[0]);
}

/* ---- materials ------------------------------------------------------------------------------------------------- */

static const struct library {
    const char *text, *name;
    roberts_color color;
} libraries[] = {
    {"newmtl red\nKd 1 0 0\n", "red", {3, {1, 0, 0}}},
    {"newmtl red\nKd 1 0 0\n", "green", {0, {0}}},
    {"newmtl b\nKd 0 0 1\nnewmtl a\nKa 1 1 1\n\tKd 0.5 .25 1e0 # c\nnewmtl c\n", "a", {3, {0.5f, 0.25f, 1}}},
    {"newmtl b\nKd 0 0 1\nnewmtl a\nKa 1 1 1\nKd 0.5 0.25 1\nnewmtl c\n", "c", {0, {0}}},
    {"newmtl two words\r\nKd 0 1 0\r\n", "two words", {3, {0, 1, 0}}},
    {"newmtl a\nKd 1 0 0\nnewmtl a\nKd 0 1 0\n", "a", {3, {0, 1, 0}}},       /* the last one counts */
    {"newmtl a\nKd spectral file.rfl 1\nKd 2 0 0\nKd 0 1\n", "a", {0, {0}}}, /* and none of these */
    {"newmtl a\nKd 0.5\nKd 0.25 1\n", "a", {3, {0.5f, 0.5f, 0.5f}}},         /* a grey */
    {"Kd 1 0 0\nnewmtl a\n", "a", {0, {0}}},
    {"\x01\x02 nonsense\nnewmtl a\nKd 1 1 1\n", "a", {3, {1, 1, 1}}},
    {"", "", {0, {0}}},
};

static void reads_materials(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof libraries / sizeof libraries[0]; i++) {
        obj_materials m = {0};
        input_memory text = {libraries[i].text, strlen(libraries[i].text), 0};
        const input_source source = input_from_memory(&text);
        assert_true(obj_materials_read(&m, &source));
        obj_materials_sort(&m);
        const roberts_color *color = obj_materials_color(&m, libraries[i].name);
        const roberts_color found = color ? *color : (roberts_color){0};
        assert_int_equal(found.count, libraries[i].color.count);
        assert_memory_equal(found.value, libraries[i].color.value, sizeof found.value);
        obj_materials_free(&m);
    }
}

static void put(const char *name, const char *text)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", temporary, name);
    write_text(path, text);
}

/* Colours come from files beside the model, and from nowhere else. */
static void reads_files_beside(void **state)
{
    static const struct row {
        const char *text, *mesh, *warnings, *missing;
    } rows[] = {
        {"mtllib m.mtl\nusemtl red\nf 1 2 3\nusemtl none\nf 1 2 3\nusemtl blue\nf 1 2 3\n",
         " | 0-1-2(1,0,0) 0-1-2 0-1-2(0,0,1)",
         "7: no colour for 1 use of materials that the .mtl files lack, the first of \"none\";", NULL},
        {"mtllib m.mtl\nusemtl my \x1b[31mpaint\nf 1 2 3\nusemtl b\nf 1 2 3\n", " | 0-1-2 0-1-2",
         "5: no colour for 2 uses of materials that the .mtl files lack, the first of \"my ? [31mpaint\";", NULL},
        {"mtllib bad.mtl\nusemtl red\nf 1 2 3\n", " | 0-1-2(0,1,0)", "3: 2 colours that make no sense ignored;", NULL},
        {"mtllib my colours.mtl\nusemtl red\nf 1 2 3\n", " | 0-1-2(0,1,0)", NULL, NULL},
        {"mtllib none.mtl m.mtl\nusemtl red\nf 1 2 3\n", " | 0-1-2(1,0,0)", NULL, "none.mtl"},
        {"mtllib m.mtl m.mtl\nusemtl blue\nf 1 2 3\n", " | 0-1-2(0,0,1)", NULL, NULL},
        {"mtllib /x/a b.mtl\nmtllib c.mtl\nusemtl red\nf 1 2 3\n", " | 0-1-2", NULL, "a b.mtl"},
        {"mtllib C:\\models\\m.mtl\nusemtl red\nf 1 2 3\n", " | 0-1-2(1,0,0)", NULL, NULL},
        {"mtllib ../m.mtl\nusemtl red\nf 1 2 3\n", " | 0-1-2(1,0,0)", NULL, NULL},
        {"mtllib ..\nusemtl red\nf 1 2 3\n", " | 0-1-2", NULL, ".."},
        {"mtllib inner/\nusemtl red\nf 1 2 3\n", " | 0-1-2", NULL, NULL},
        {"mtllib\nusemtl red\nf 1 2 3\nmtllib m.mtl\nusemtl red\nf 1 2 3\n", " | 0-1-2 0-1-2(1,0,0)", NULL, NULL},
    };
    char path[600];
    (void)state;
    put("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    put("bad.mtl", "newmtl red\nKd 0 1 0\nKd 1 0 x\nKd 2 0 0\nKd spectral a.rfl 1\n");
    put("my colours.mtl", "newmtl red\nKd 0 1 0\n");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char text[512];
        roberts_mesh mesh = {0};
        snprintf(text, sizeof text, "%s%s", THREE, rows[i].text);
        put("a.obj", text);
        snprintf(path, sizeof path, "%s/a.obj", temporary);
        char warnings[1000] = "";
        const roberts_warnings sink = {read_rows_warn, warnings};
        assert_int_equal(roberts_mesh_read_file(&mesh, path, &sink, NULL), ROBERTS_OK);
        assert_string_equal(warnings, rows[i].warnings ? rows[i].warnings : "");
        mesh_text found = mesh_as_text(&mesh);
        snprintf(text, sizeof text, "%s%s", THREE_TEXT, rows[i].mesh);
        assert_string_equal(found.text, text);
        if (rows[i].missing) {
            snprintf(path, sizeof path, "%s/%s", temporary, rows[i].missing);
            assert_string_equal(mesh.source[0].missing, path);
        } else {
            assert_null(mesh.source[0].missing);
        }
        roberts_mesh_free(&mesh);
    }
}

/* ---- files ----------------------------------------------------------------------------------------------------- */

static void reads_published_files(void **state)
{
    static const published_file files[] = {{"box_longline.obj", ROBERTS_OK, 8, 6, 1, false, false},
                                           {"concave_polygon.obj", ROBERTS_OK, 64, 1, 2, false, false},
                                           {"cube_with_vertexcolors.obj", ROBERTS_OK, 8, 12, 1, false, true},
                                           {"multiple_spaces.obj", ROBERTS_OK, 4, 1, 0, false, false},
                                           {"number_formats.obj", ROBERTS_BAD_SYNTAX, 0, 0, 0, false, false},
                                           {"point_cloud.obj", ROBERTS_OK, 3, 0, 0, false, false},
                                           {"spider.obj", ROBERTS_OK, 762, 1368, 19, false, false},
                                           {"testmixed.obj", ROBERTS_OK, 8, 24, 0, false, false}};
    (void)state;
    read_published_files(files, sizeof files / sizeof files[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads),
        cmocka_unit_test(refuses),
        cmocka_unit_test(reads_materials),
        cmocka_unit_test_setup_teardown(reads_files_beside, temporary_make, temporary_remove),
        cmocka_unit_test(reads_published_files),
    };
    return cmocka_run_group_tests_name("obj", tests, NULL, NULL);
}
