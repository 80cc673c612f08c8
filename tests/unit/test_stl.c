/* test_stl.c - STL as text and binary: what is read, welded and refused, and where. */
#include <math.h>
#include <stdlib.h>
#include <unistd.h>

#include "read_rows.h"
#include "testing.h"

#define FACET(a, b, c)                                                                                                 \
    "facet normal 0 0 1\n outer loop\n vertex " a "\n vertex " b "\n vertex " c "\n endloop\nendfacet\n"
#define FIRST FACET("0 0 0", "1 0 0", "0 1 0")

static const read_good good[] = {
    {"one facet", "solid a\n" FIRST "endsolid a\n", 0, "0,0,0 1,0,0 0,1,0 | 0-1-2 | a@0", NULL},
    {"equal positions are one vertex", "solid a\n" FIRST FACET("1 0 0", "0 1 0", "0 0 1") "endsolid\n", 0,
     "0,0,0 1,0,0 0,1,0 0,0,1 | 0-1-2 1-2-3 | a@0", NULL},
    {"-0 is 0", "solid a\n" FACET("0 0 0", "1 -0 0", "1 0.0 1") FACET("-0 0 0", "1 0 0", "0 1 0") "endsolid\n", 0,
     "0,0,0 1,0,0 1,0,1 0,1,0 | 0-1-2 0-1-3 | a@0", NULL},
    {"nearly equal positions are not", "solid a\n" FACET("0 0 0", "1 0 0", "1 1e-300 0") "endsolid\n", 0,
     "0,0,0 1,0,0 1,1e-300,0 | 0-1-2 | a@0", NULL},
    {"two solids share nothing", "solid a\n" FIRST "endsolid a\nsolid b\n" FIRST "endsolid b\n", 0,
     "0,0,0 1,0,0 0,1,0 0,0,0 1,0,0 0,1,0 | 0-1-2 3-4-5 | a@0 b@1", NULL},
    {"an empty solid", "solid a\n" FIRST "endsolid a\nsolid b\nendsolid b\n", 0, "0,0,0 1,0,0 0,1,0 | 0-1-2 | a@0 b@1",
     NULL},
    {"no facet at all", "solid\nendsolid\n", 0, " | @0", NULL},
    {"a name of several words", "solid  my # {box}\t\n" FIRST "endsolid\n", 0,
     "0,0,0 1,0,0 0,1,0 | 0-1-2 | my # {box}@0", NULL},
    {"upper case",
     "SOLID A\nFACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0 Vertex 0 1 0 ENDLOOP ENDFACET ENDSOLID", 0,
     "0,0,0 1,0,0 0,1,0 | 0-1-2 | A@0", NULL},
    {"CR LF",
     "solid a\r\nfacet normal 0 0 1\r\nouter loop\r\nvertex 0 0 0\r\nvertex 1 0 0\r\nvertex 0 1 0\r\nendloop\r\n"
     "endfacet\r\nendsolid a\r\n",
     0, "0,0,0 1,0,0 0,1,0 | 0-1-2 | a@0", NULL},
    {"a name with control characters", "solid \033[31ma\001\n" FIRST "endsolid\n", 0,
     "0,0,0 1,0,0 0,1,0 | 0-1-2 | \033 [31ma \001@0", NULL},
    {"an empty solid with such a name", "solid \001\r\nendsolid\r\n", 0, " | \001@0", NULL},
    {"blank lines before, and a byte-order mark", "\xef\xbb\xbf\n  solid a\n" FIRST "endsolid\n", 0,
     "0,0,0 1,0,0 0,1,0 | 0-1-2 | a@0", NULL},
    {"a normal that is none",
     "solid a\nfacet normal nan -nan inf outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop "
     "endfacet endsolid",
     0, "0,0,0 1,0,0 0,1,0 | 0-1-2 | a@0", NULL},
    {"no normal", "solid a\nfacet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet endsolid", 0,
     "0,0,0 1,0,0 0,1,0 | 0-1-2 | a@0", NULL},
    {"four corners",
     "solid a\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 endloop "
     "endfacet endsolid",
     0, "0,0,0 1,0,0 1,1,0 0,1,0 | 0-1-2-3 | a@0", NULL},
    {"without endsolid", "solid a\n" FIRST, 0, "0,0,0 1,0,0 0,1,0 | 0-1-2 | a@0",
     "0: there is no endsolid at the end: is the file complete?;"},
    {"text after it", "solid a\n" FIRST "endsolid a\nmade by hand\n", 0, "0,0,0 1,0,0 0,1,0 | 0-1-2 | a@0",
     "10: text after the last solid ignored;"},
};

static const read_bad bad[] = {
    {"a facet without loop", "solid a\nfacet normal 0 0 1\nvertex 0 0 0\n", 0, ROBERTS_BAD_SYNTAX, 3,
     "outer of facet 0 expected, found \"vertex\""},
    {"two corners", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n", 0,
     ROBERTS_BAD_SYNTAX, 6, "vertex of facet 0 expected, found \"endloop\""},
    {"a word for a number", "solid a\n" FIRST "facet normal 0 0 1\nouter loop\nvertex 0 zero 0\n", 0,
     ROBERTS_BAD_SYNTAX, 11, "y of a corner of facet 1 expected, found \"zero\""},
    {"a coordinate missing", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0\nvertex 0 1 0\n", 0,
     ROBERTS_BAD_SYNTAX, 5, "z of a corner of facet 0 expected, but the line ends here"},
    {"a decimal comma", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0,5 1 0\n", 0, ROBERTS_BAD_SYNTAX, 4,
     "x of a corner of facet 0 expected, found \"0,5\""},
    {"not a number", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\n", 0, ROBERTS_BAD_NUMBER, 4,
     "z of a corner of facet 0 expected, found \"nan\"; it must be a finite number"},
    {"too large", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1e151\n", 0, ROBERTS_BAD_NUMBER, 4,
     "vertex 0 has a coordinate that is infinite or beyond 1e+150"},
    {"ends in a facet", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0", 0, ROBERTS_BAD_SYNTAX, 4,
     "z of a corner of facet 0 expected, but the input ends here"},
    {"no endloop", "solid a\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0\nendfacet\n", 0,
     ROBERTS_BAD_SYNTAX, 3, "endloop of facet 0 expected, found \"endfacet\""},
    {"another word", "solid a\n" FIRST "face\n", 0, ROBERTS_BAD_SYNTAX, 9,
     "facet or endsolid expected, found \"face\""},
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

static const float tetrahedron[4][9] = {
    {0, 0, 0, 0, 1, 0, 1, 0, 0}, {0, 0, 0, 1, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 0, 1, 0, 1, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1}};
static const char tetrahedron_text[] = "0,0,0 0,1,0 1,0,0 0,0,1 | 0-1-2 0-2-3 0-3-1 2-1-3 | float32";

static bytes_built build_header(const char *begins, uint32_t count)
{
    bytes_built b = {.size = 0};
    char header[80] = {0};
    for (size_t i = 0; i < sizeof header && begins[i]; i++)
        header[i] = begins[i];
    build_bytes(&b, header, sizeof header);
    build_number(&b, count, 4);
    return b;
}

static bytes_built build_tetrahedron(const char *begins)
{
    bytes_built b = build_header(begins, 4);
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 3; k++)
            build_float(&b, NAN); /* the normal */
        for (int k = 0; k < 9; k++)
            build_float(&b, tetrahedron[i][k]);
        build_number(&b, 0xffff, 2);
    }
    return b;
}

/* Any 80 bytes of header: among them the beginnings of all other formats, and a text that fills them. */
static void reads_binary(void **state)
{
    static const char *const begins[] = {
        "",
        "solid",
        "solid a",
        "solid of 80 characters, none of them a zero, as some programs have it: facet normal ",
        "OFF 8 6 12\n",
        "ply\n",
        "v 0 0 0\nf 1 2 3\n",
        "glTF",
        "{",
        "3 1 0\n",
        "\357\273\277OFF",
        "COLOR="};
    (void)state;
    for (size_t i = 0; i < sizeof begins / sizeof begins[0]; i++) {
        bytes_built b = build_tetrahedron(begins[i]);
        read_good row = {begins[i], b.bytes, b.size, tetrahedron_text, NULL};
        read_good_rows(&row, 1);
    }
}

/* An unknown or wrong size: the file is recognised by bytes that no text has, whatever the header says. */
static void reads_binary_of_unknown_size(void **state)
{
    static const char *const begins[] = {"",
                                         "\001",
                                         "solid made by a program",
                                         "made by another program",
                                         "3D model exported",
                                         "v 2 exported",
                                         "f 1 2 3",
                                         "OFF 8 6 12",
                                         "# a comment",
                                         "{",
                                         "ply\n",
                                         "glTF",
                                         "// exported",
                                         "line\nbreaks\n",
                                         "\x1f",
                                         "PK"};
    (void)state;
    for (size_t i = 0; i < sizeof begins / sizeof begins[0]; i++) {
        bytes_built b = build_tetrahedron(begins[i]);
        read_pieces pieces = {b.bytes, b.size, 0};
        roberts_mesh mesh = {0};
        roberts_error error;
        if (roberts_mesh_read(&mesh, "t", read_rows_piece, &pieces, NULL, &error) != ROBERTS_OK)
            fail_msg("\"%s\" from a pipe: %s", begins[i], error.message);
        mesh_text found = mesh_as_text(&mesh);
        assert_string_equal(found.text, tetrahedron_text);
        roberts_mesh_free(&mesh);
        read_bad bare = {begins[i], b.bytes,
                         90,        ROBERTS_BAD_SYNTAX,
                         0,         "triangle 0 of 0..3 expected, but the input ends before (byte 84)"};
        read_bad cut = {begins[i],   b.bytes,
                        b.size - 14, ROBERTS_BAD_SYNTAX,
                        0,           "triangle 3 of 0..3 expected, but the input ends before (byte 234)"};
        read_bad_rows(&bare, 1);
        read_bad_rows(&cut, 1);
        build_bytes(&b, "", 1);
        read_good row = {begins[i], b.bytes, b.size, tetrahedron_text, "0: data after the last triangle ignored;"};
        read_good_rows(&row, 1);
    }
}

/* Files that look like STL in places but are not: other binary formats name themselves at their beginning. */
static void knows_other_binary(void **state)
{
    static const struct row {
        const char *begins, *message;
    } rows[] = {{"\x1f\x8b\x08", "compressed, as by gzip"},
                {"PK\x03\x04", "a ZIP archive"},
                {"\xff\xfe", "text in UTF-16"},
                {"$MeshFormat\n", "Gmsh"},
                {"roberts part 1\n", "roberts --join"},
                {"OFF BINARY\n\1\1\1\1", "vertex"},
                {"# first\ncoff binary\n\1\1\1\1", "vertex"}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        bytes_built b = build_tetrahedron(rows[i].begins);
        build_bytes(&b, "", 1); /* the size of STL would decide */
        roberts_mesh mesh = {0};
        roberts_error error;
        assert_int_not_equal(roberts_mesh_read_memory(&mesh, "t", b.bytes, b.size, NULL, &error), ROBERTS_OK);
        if (!strstr(error.message, rows[i].message) || strstr(error.message, "triangle"))
            fail_msg("\"%s\": %s", rows[i].begins, error.message);
    }
}

/* What is compressed has a command with its own name, where a shell takes that as it is. */
static void names_what_is_compressed(void **state)
{
    static const struct row {
        const char *name, *command;
    } rows[] = {{"a/m.stl.gz", "gzip -dc a/m.stl.gz | roberts -"},
                {"m.stl", "gzip -dc model.off.gz | roberts -"},
                {"-m.stl.gz", "gzip -dc model.off.gz | roberts -"},
                {"the m.stl.gz", "gzip -dc model.off.gz | roberts -"}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        roberts_mesh mesh = {0};
        roberts_error error;
        assert_int_equal(roberts_mesh_read_memory(&mesh, rows[i].name, "\x1f\x8b\x08", 3, NULL, &error),
                         ROBERTS_BAD_SYNTAX);
        if (!strstr(error.message, rows[i].command))
            fail_msg("\"%s\": %s", rows[i].name, error.message);
    }
}

/* A header and the number 0. Other formats of that length end in zeros, too. */
static void knows_binary_without_triangles(void **state)
{
    static const char *const begins[] = {"", "solid made by a program", "made by another program"};
    static const char *const others[] = {"\x1f\x8b\x08",  "PK\x03\x04", "glTF",   "OFF BINARY\n",
                                         "4 0 0 nothing", "ply\n",      "v 0 0 0"};
    (void)state;
    for (size_t i = 0; i < sizeof begins / sizeof begins[0]; i++) {
        bytes_built b = build_header(begins[i], 0);
        read_good row = {begins[i], b.bytes, b.size, " | float32", "0: this is binary STL without triangles;"};
        read_good_rows(&row, 1);
    }
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        bytes_built b = build_header(others[i], 0);
        roberts_mesh mesh = {0};
        char warnings[1000];
        roberts_error error;
        (void)read_rows_read(b.bytes, b.size, &mesh, warnings, &error);
        if (strstr(warnings, "STL"))
            fail_msg("\"%s\": %s", others[i], warnings);
        roberts_mesh_free(&mesh);
    }
}

/* A pipe that stays open after a small model: all bytes of the model are there, and no more is read. */
static ptrdiff_t read_once(void *context, void *buffer, size_t size)
{
    read_pieces *pieces = context;
    if (pieces->at > 0)
        fail_msg("more is asked for");
    assert_true(size >= pieces->size);
    memcpy(buffer, pieces->bytes, pieces->size);
    pieces->at = pieces->size;
    return (ptrdiff_t)pieces->size;
}

static void asks_no_more_of_a_text(void **state)
{
    static const char text[] = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    read_pieces pieces = {text, sizeof text - 1, 0};
    roberts_mesh mesh = {0};
    (void)state;
    assert_int_equal(roberts_mesh_read(&mesh, "t", read_once, &pieces, NULL, NULL), ROBERTS_OK);
    assert_int_equal(mesh.face_count, 1);
    roberts_mesh_free(&mesh);
}

static void refuses_binary(void **state)
{
    static const float wrong[] = {NAN, INFINITY, -INFINITY};
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        bytes_built b = build_tetrahedron("solid");
        size_t end = b.size;
        b.size = 84 + 50 + 12 + 4; /* the second triangle's first y */
        build_float(&b, wrong[i]);
        read_bad row = {"no number", b.bytes,
                        end,         ROBERTS_BAD_NUMBER,
                        0,           "triangle 1 has a coordinate that is infinite or no number (byte 134)"};
        read_bad_rows(&row, 1);
    }
}

/* Many triangles: the table of positions grows often. A grid of n x n squares has (n + 1)^2 vertices. */
static void welds_many(void **state)
{
    enum { SIDE = 150 };
    static const int corner[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    const size_t triangles = 2 * SIDE * SIDE, size = 84 + 50 * triangles;
    char *bytes = calloc(size, 1), *at = bytes + 84;
    roberts_mesh mesh = {0};
    (void)state;
    assert_non_null(bytes);
    for (int i = 0; i < 4; i++)
        bytes[80 + i] = (char)(triangles >> 8 * i);
    for (int i = 0; i < SIDE * SIDE; i++)
        for (int k = 0; k < 6; k++) {
            bytes_built b = {.size = 0};
            build_float(&b, (float)(i % SIDE + corner[k][0]) / 3);
            build_float(&b, (float)(i / SIDE + corner[k][1]) / 7);
            memcpy(at + 12 + 12 * (ptrdiff_t)(k % 3), b.bytes, 8);
            at += k % 3 == 2 ? 50 : 0;
        }
    assert_int_equal(roberts_mesh_read_memory(&mesh, "grid", bytes, size, NULL, NULL), ROBERTS_OK);
    assert_int_equal(mesh.vertex_count, (SIDE + 1) * (SIDE + 1));
    assert_int_equal(mesh.face_count, triangles);
    for (size_t i = 0; i < 3 * triangles; i++) { /* each corner has its own position */
        float x;
        memcpy(&x, bytes + 84 + i / 3 * 50 + 12 + i % 3 * 12, sizeof x);
        assert_true(mesh.vertex[mesh.corner[i]].x == (double)x);
    }
    roberts_mesh_free(&mesh);
    free(bytes);
}

/* ---- files ----------------------------------------------------------------------------------------------------- */

static void reads_published_files(void **state)
{
    static const published_file files[] = {{"Spider_ascii.stl", ROBERTS_OK, 722, 1368, 1, false, false},
                                           {"Spider_binary.stl", ROBERTS_OK, 722, 1368, 0, true, false},
                                           {"triangle_with_empty_solid.stl", ROBERTS_OK, 3, 1, 2, false, false},
                                           {"triangle_with_two_solids.stl", ROBERTS_OK, 6, 2, 2, false, false}};
    (void)state;
    read_published_files(files, sizeof files / sizeof files[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_text),
        cmocka_unit_test(refuses_text),
        cmocka_unit_test(reads_binary),
        cmocka_unit_test(reads_binary_of_unknown_size),
        cmocka_unit_test(knows_other_binary),
        cmocka_unit_test(names_what_is_compressed),
        cmocka_unit_test(knows_binary_without_triangles),
        cmocka_unit_test(asks_no_more_of_a_text),
        cmocka_unit_test(refuses_binary),
        cmocka_unit_test(welds_many),
        cmocka_unit_test(reads_published_files),
    };
    return cmocka_run_group_tests_name("stl", tests, NULL, NULL);
}
