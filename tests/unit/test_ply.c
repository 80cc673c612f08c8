/* test_ply.c - PLY as text and in both byte orders: which data are used, skipped or refused, and where. */
#include <math.h>
#include <unistd.h>

#include "read_rows.h"
#include "testing.h"

#define VERTICES(n) "element vertex " n "\nproperty float x\nproperty float y\nproperty float z\n"
#define FACES(n) "element face " n "\nproperty list uchar int vertex_indices\n"
#define TEXT "ply\nformat ascii 1.0\n"
#define THREE "0 0 0\n1 0 0\n0 1 0\n"
#define THREE_TEXT "0,0,0 1,0,0 0,1,0"

static const read_good good[] = {
    {"a triangle", TEXT VERTICES("3") FACES("1") "end_header\n" THREE "3 0 1 2\n", 0, THREE_TEXT " | 0-1-2", NULL},
    {"another version", "ply\nformat ascii 2.0\n" VERTICES("3") FACES("1") "end_header\n" THREE "3 0 1 2\n", 0,
     THREE_TEXT " | 0-1-2", "2: PLY of version 2.0 is read as version 1.0;"},
    {"no version", "ply\nformat ascii\n" VERTICES("3") FACES("1") "end_header\n" THREE "3 0 1 2\n", 0,
     THREE_TEXT " | 0-1-2", NULL},
    {"comments and blanks",
     "ply \r\nformat ascii 1.0 \r\ncomment one # {\r\nobj_info two\r\nelement vertex  1\r\n"
     "property  double x\r\nproperty float64 y\r\nproperty int z  \r\nend_header\r\n1 2 3\r\n",
     0, "1,2,3", NULL},
    {"vertex_index",
     TEXT VERTICES("3") "element face 1\nproperty list uint8 uint32 vertex_index\nend_header\n" THREE "3 2 1 0\n", 0,
     THREE_TEXT " | 2-1-0", NULL},
    {"coordinates in any order",
     TEXT "element vertex 1\nproperty float z\nproperty float x\nproperty float y\nend_header\n3 1 2\n", 0, "1,2,3",
     NULL},
    {"faces before vertices", TEXT FACES("1") VERTICES("3") "end_header\n3 0 1 2\n" THREE, 0, THREE_TEXT " | 0-1-2",
     NULL},
    {"all on one line", TEXT VERTICES("3") FACES("1") "end_header\n0 0 0 1 0 0 0 1 0 3 0 1 2", 0, THREE_TEXT " | 0-1-2",
     NULL},
    {"properties that are not known",
     TEXT "element vertex 3\nproperty float nx\nproperty float x\nproperty list uchar float weights\nproperty float y\n"
          "property float z\nproperty uchar quality\n" FACES(
              "1") "property list uchar float texcoord\nproperty int group\n"
                   "end_header\nnan 0 2 1 2 0 0 7\n0 1 0 0 0 8\n0 0 1 .5 1 0 9\n3 0 1 2 2 -0.5 nan 4\n",
     0, THREE_TEXT " | 0-1-2", NULL},
    {"elements that are not known",
     TEXT "element camera 2\nproperty float x\nproperty list int int y\n" VERTICES("3") "element nothing 9\n" FACES(
         "1") "element after 1\nproperty float x\nend_header\n1 0\n2 3 1 1 1\n" THREE "3 0 1 2\n5\n",
     0, THREE_TEXT " | 0-1-2", NULL},
    {"strips of triangles",
     TEXT VERTICES("3") FACES("1") "element tristrips 2\nproperty list int int vertex_indices\nend_header\n" THREE
                                   "3 2 1 0\n9 0 1 2 0 -1 1 2 2 0\n4 -1 0 1 -1\n",
     0, THREE_TEXT " | 2-1-0 0-1-2 2-1-0", NULL},
    {"strips without a list of vertices",
     TEXT VERTICES("3") "element tristrips 1\nproperty list int int other\nproperty uchar red\n" FACES(
         "1") "end_header\n" THREE "2 7 8 9\n3 0 1 2\n",
     0, THREE_TEXT " | 0-1-2", NULL},
    {"edges",
     TEXT VERTICES(
         "3") "element edge 2\nproperty int vertex1\nproperty int vertex2\nproperty uchar red\nproperty uchar "
              "green\nproperty uchar blue\nend_header\n" THREE "0 1 255 0 51\n2 1 0 0 0\n",
     0, THREE_TEXT " | 0-1(1,0,0.2) 2-1(0,0,0)", NULL},
    {"bytes as colours",
     TEXT "element vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty "
          "uchar green\nproperty uchar blue\nproperty uchar alpha\nend_header\n0 0 0 255 0 51 9\n1 1 1 0 0 0 0\n",
     0, "0,0,0(1,0,0.2) 1,1,1(0,0,0)", NULL},
    {"floats as colours of faces",
     TEXT VERTICES("3") FACES("2") "property float red\nproperty float green\nproperty float blue\nend_header\n" THREE
                                   "3 0 1 2 1 .5 0\n3 0 1 2 2 0 0\n",
     0, THREE_TEXT " | 0-1-2(1,0.5,0) 0-1-2", NULL},
    {"two thirds of a colour",
     TEXT "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
          "property uchar green\nend_header\n0 0 0 255 255\n",
     0, "0,0,0", NULL},
    {"points", TEXT VERTICES("2") "end_header\n0 0 0\n1 1 1\n", 0, "0,0,0 1,1,1", NULL},
    {"faces of no corners", TEXT VERTICES("3") FACES("3") "end_header\n" THREE "0\n3 0 1 2\n2 0 1\n", 0,
     THREE_TEXT " |  0-1-2 0-1", "0: 2 faces with fewer than 3 corners: they hide nothing;"},
    {"data after the last element", TEXT VERTICES("1") "end_header\n0 0 0\n7\n", 0, "0,0,0",
     "9: data after the last element ignored;"},
};

static const read_bad bad[] = {
    {"a strip with a vertex that is not there",
     TEXT VERTICES("3") "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" THREE "3 0 1 3\n", 0,
     ROBERTS_BAD_INDEX, 13, "tristrips 0 names vertex 3, but there are 3"},
    {"a strip cut short",
     TEXT VERTICES("3") "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" THREE "4 0 1 2\n", 0,
     ROBERTS_BAD_SYNTAX, 14, "tristrips 0 of 0..0 expected, but the input ends here"},
    {"no format", "ply\nelement vertex 0\nend_header\n", 0, ROBERTS_BAD_SYNTAX, 3, "the header of PLY has no format"},
    {"another format", "ply\nformat utf8 1.0\n", 0, ROBERTS_BAD_SYNTAX, 2,
     "format ascii, binary_little_endian or binary_big_endian in the header of PLY expected, found \"utf8\""},
    {"ends in the header", TEXT "element vertex 3\n", 0, ROBERTS_BAD_SYNTAX, 4,
     "end_header in the header of PLY expected, but the input ends here"},
    {"another word in the header", TEXT "vertex 3\n", 0, ROBERTS_BAD_SYNTAX, 3,
     "element, property or end_header in the header of PLY expected, found \"vertex\""},
    {"a negative count", TEXT "element vertex -3\n", 0, ROBERTS_BAD_SYNTAX, 3,
     "the number of elements in the header of PLY expected, found \"-3\""},
    {"a type that is not known", TEXT "element vertex 3\nproperty quad x\n", 0, ROBERTS_BAD_SYNTAX, 4,
     "type \"quad\" of a property is not known"},
    {"a property of nothing", TEXT "property float x\n", 0, ROBERTS_BAD_SYNTAX, 3,
     "a property before the first element"},
    {"a property without name", TEXT "element vertex 1\nproperty float\n", 0, ROBERTS_BAD_SYNTAX, 4,
     "the name of a property in the header of PLY expected, but the line ends here"},
    {"x twice", TEXT "element vertex 1\nproperty float x\nproperty int x\n", 0, ROBERTS_BAD_SYNTAX, 5,
     "property x is declared twice"},
    {"vertices twice", TEXT VERTICES("1") "element vertex 1\n", 0, ROBERTS_BAD_SYNTAX, 7,
     "element vertex is declared twice"},
    {"no z", TEXT "element vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n", 0, ROBERTS_BAD_SYNTAX, 7,
     "vertices without x, y and z"},
    {"faces without corners", TEXT "element face 1\nproperty int id\nend_header\n7\n", 0, ROBERTS_BAD_SYNTAX, 6,
     "faces without a list vertex_indices"},
    {"a corner beyond the vertices", TEXT VERTICES("3") FACES("1") "end_header\n" THREE "3 0 1 3\n", 0,
     ROBERTS_BAD_INDEX, 13, "face 0 names vertex 3, but there are 3"},
    {"a negative corner", TEXT VERTICES("3") FACES("2") "end_header\n" THREE "3 0 1 2\n3 0 -1 2\n", 0,
     ROBERTS_BAD_INDEX, 14, "face 1 names vertex -1, but there are 3"},
    {"half a corner", TEXT VERTICES("3") FACES("1") "end_header\n" THREE "3 0 1.5 2\n", 0, ROBERTS_BAD_INDEX, 13,
     "face 0 names vertex 1.5, but there are 3"},
    {"a negative number of corners", TEXT VERTICES("3") FACES("1") "end_header\n" THREE "-3 0 1 2\n", 0,
     ROBERTS_BAD_SYNTAX, 13, "face 0 has a list of -3 numbers"},
    {"a word for a coordinate", TEXT VERTICES("2") "end_header\n0 0 0\n0 x 0\n", 0, ROBERTS_BAD_SYNTAX, 9,
     "vertex 1 of 0..1 expected, found \"x\""},
    {"not a number", TEXT VERTICES("2") "end_header\n0 0 0\n0 nan 0\n", 0, ROBERTS_BAD_NUMBER, 9,
     "vertex 1 of 0..1 expected, found \"nan\"; it must be a finite number"},
    {"too large", TEXT VERTICES("2") "end_header\n0 0 0\n0 0 1e151\n", 0, ROBERTS_BAD_NUMBER, 9,
     "vertex 1 has a coordinate that is infinite or beyond 1e+150"},
    {"fewer vertices than declared", TEXT VERTICES("4000000000") "end_header\n0 0 0\n", 0, ROBERTS_BAD_SYNTAX, 9,
     "vertex 1 of 0..3999999999 expected, but the input ends here"},
    {"fewer corners than declared", TEXT VERTICES("3") FACES("1") "end_header\n" THREE "4000000000 0 1", 0,
     ROBERTS_BAD_SYNTAX, 13, "face 0 of 0..0 expected, but the input ends here"},
};

static void reads_text(void **state)
{
    (void)state;
    read_good_rows(good, sizeof good / sizeof good[0]);
}

static void refuses_text(void **state)
{
    (void)state;
    read_bad_rows(bad, sizeof bad / sizeof bad[0]);
}

/* ---- binary ---------------------------------------------------------------------------------------------------- */

static void build_text(bytes_built *b, const char *text)
{
    build_bytes(b, text, strlen(text));
}

static bytes_built start(bool big, const char *line_end)
{
    bytes_built b = {.big = big};
    build_text(&b, "ply");
    build_text(&b, line_end);
    build_text(&b, big ? "format binary_big_endian 1.0" : "format binary_little_endian 1.0");
    build_text(&b, line_end);
    return b;
}

/* Every type, in both orders, with unused values between the used ones. The first byte of the data looks like a line
 * end. */
static bytes_built build_all_types(bool big, const char *line_end)
{
    static const char *const lines[] = {"element vertex 4",
                                        "property int8 a",
                                        "property float x",
                                        "property ushort b",
                                        "property double y",
                                        "property short z",
                                        "property list uchar float c",
                                        "property uint16 red",
                                        "property uchar green",
                                        "property float blue",
                                        "element face 2",
                                        "property list int uint16 d",
                                        "property list uint16 int8 vertex_indices",
                                        "property uint e",
                                        "end_header"};
    static const float x[4] = {0.0f, 1.0f, 0.1f, -2.5f};
    static const double y[4] = {0.0, 0.1, 1e100, -1.0};
    static const int z[4] = {0, 300, -300, -32768};
    bytes_built b = start(big, line_end);
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        build_text(&b, lines[i]);
        build_text(&b, line_end);
    }
    for (int i = 0; i < 4; i++) {
        build_number(&b, '\n', 1);
        build_float(&b, x[i]);
        build_number(&b, 0x1234, 2);
        build_double(&b, y[i]);
        build_number(&b, (uint64_t)(int64_t)z[i], 2);
        build_number(&b, 2, 1);
        build_float(&b, NAN);
        build_float(&b, 7.0f);
        build_number(&b, 65535, 2);
        build_number(&b, 51, 1);
        build_float(&b, 0.5f);
    }
    for (int i = 0; i < 2; i++) {
        build_number(&b, 1, 4);
        build_number(&b, 0xffff, 2);
        build_number(&b, i ? 4 : 3, 2);
        for (int k = 0; k < 3 + i; k++)
            build_number(&b, (uint64_t)k, 1);
        build_number(&b, 0, 4);
    }
    return b;
}

static void reads_binary(void **state)
{
    static const char text[] =
        "0,0,0(1,0.2,0.5) 1,0.10000000000000001,300(1,0.2,0.5) "
        "0.10000000149011612,1e+100,-300(1,0.2,0.5) -2.5,-1,-32768(1,0.2,0.5) | 0-1-2 0-1-2-3 | float32";
    (void)state;
    for (int big = 0; big < 2; big++)
        for (int i = 0; i < 2; i++) {
            bytes_built b = build_all_types(big, i ? "\r\n" : "\n");
            read_good row = {big ? "big" : "little", b.bytes, b.size, text, NULL};
            read_good_rows(&row, 1);
            build_text(&b, "x");
            row = (read_good){"with a byte more", b.bytes, b.size, text, "0: data after the last element ignored;"};
            read_good_rows(&row, 1);
        }
}

/* Lines of the header end with CR alone, as on old machines: the LF behind it is the first byte of the data. */
static void reads_data_that_begins_with_line_feed(void **state)
{
    bytes_built b = start(false, "\r");
    (void)state;
    build_text(&b, "element vertex 1\rproperty uchar x\rproperty uchar y\rproperty uchar z\rend_header\r\n\r\n");
    read_good row = {"CR", b.bytes, b.size, "10,13,10", NULL};
    read_good_rows(&row, 1);
}

/* Coordinates of 64 bits are not those of 32. */
static void tells_float_from_double(void **state)
{
    (void)state;
    for (int big = 0; big < 2; big++) {
        bytes_built b = start(big, "\n");
        build_text(&b, "element vertex 1\nproperty double x\nproperty double y\nproperty double z\nproperty float "
                       "nx\nend_header\n");
        for (int i = 1; i <= 3; i++)
            build_double(&b, i / 10.0);
        build_float(&b, 0.1f);
        read_good row = {"doubles", b.bytes, b.size, "0.10000000000000001,0.20000000000000001,0.29999999999999999",
                         NULL};
        read_good_rows(&row, 1);
    }
}

/* The input may end at any byte: the message names it. */
static void refuses_binary_cut_short(void **state)
{
    bytes_built b = build_all_types(false, "\n"), header = b;
    (void)state;
    header.bytes[header.size - 1] = '\0';
    const char *end = NULL;
    for (size_t i = 0; i + 11 <= b.size && !end; i++)
        if (memcmp(b.bytes + i, "end_header\n", 11) == 0)
            end = b.bytes + i + 11;
    assert_non_null(end);
    for (size_t size = (size_t)(end - b.bytes); size < b.size; size++) {
        char warnings[1000];
        roberts_mesh mesh = {0};
        roberts_error error;
        assert_int_equal(read_rows_read(b.bytes, size, &mesh, warnings, &error), ROBERTS_BAD_SYNTAX);
        assert_int_equal(error.line, 0);
        assert_non_null(strstr(error.message, "expected, but the input ends before (byte "));
        assert_null(mesh.vertex);
    }
}

static void refuses_binary(void **state)
{
    bytes_built b = start(false, "\n");
    (void)state;
    build_text(&b, VERTICES("3") FACES("1") "end_header\n");
    size_t at = b.size;
    for (int i = 0; i < 9; i++)
        build_float(&b, (float)i);
    build_number(&b, 3, 1);
    size_t corner = b.size;
    build_number(&b, 0, 4);
    build_number(&b, 1, 4);
    build_number(&b, 0xffffffff, 4);
    char expected[100];
    snprintf(expected, sizeof expected, "face 0 names vertex -1, but there are 3 (byte %zu)", corner + 12);
    read_bad row = {"a negative corner", b.bytes, b.size, ROBERTS_BAD_INDEX, 0, expected};
    read_bad_rows(&row, 1);
    b.size = at + 4;
    build_float(&b, INFINITY);
    snprintf(expected, sizeof expected, "vertex 0 has a coordinate that is infinite or beyond 1e+150 (byte %zu)",
             at + 12);
    row = (read_bad){"infinite", b.bytes, corner + 12, ROBERTS_BAD_NUMBER, 0, expected};
    read_bad_rows(&row, 1);
}

/* ---- files ----------------------------------------------------------------------------------------------------- */

static void reads_published_files(void **state)
{
    static const published_file files[] = {{"cube.ply", ROBERTS_OK, 8, 6, 0, false, false},
                                           {"cube_binary.ply", ROBERTS_OK, 8, 12, 0, true, false},
                                           {"float-color.ply", ROBERTS_OK, 3, 1, 0, false, true},
                                           {"points.ply", ROBERTS_OK, 4, 0, 0, false, true}};
    (void)state;
    read_published_files(files, sizeof files / sizeof files[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_text),
        cmocka_unit_test(refuses_text),
        cmocka_unit_test(reads_binary),
        cmocka_unit_test(reads_data_that_begins_with_line_feed),
        cmocka_unit_test(tells_float_from_double),
        cmocka_unit_test(refuses_binary_cut_short),
        cmocka_unit_test(refuses_binary),
        cmocka_unit_test(reads_published_files),
    };
    return cmocka_run_group_tests_name("ply", tests, NULL, NULL);
}
