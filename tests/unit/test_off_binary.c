/* test_off_binary.c - OFF BINARY: both orders of bytes, with and without the number of colour floats, every prefix, and
 * what is refused. The files are written here, word by word. */
#include <stdio.h>
#include <string.h>

#include "roberts.h"
#include "testing.h"

/* A binary file while it is written. */
typedef struct file {
    char bytes[1 << 18];
    size_t length;
    bool little;
} file;

static void put_word(file *f, uint32_t word)
{
    assert_true(f->length + 4 <= sizeof f->bytes);
    for (int i = 0; i < 4; i++)
        f->bytes[f->length++] = (char)(word >> (f->little ? 8 * i : 24 - 8 * i) & 255);
}

static void put_float(file *f, float value)
{
    uint32_t word;
    memcpy(&word, &value, sizeof word);
    put_word(f, word);
}

static void put_words(file *f, size_t count, ...)
{
    va_list words;
    va_start(words, count);
    while (count--)
        put_word(f, va_arg(words, unsigned));
    va_end(words);
}

static void put_floats(file *f, size_t count, ...)
{
    va_list floats;
    va_start(floats, count);
    while (count--)
        put_float(f, (float)va_arg(floats, double));
    va_end(floats);
}

static void begin(file *f, const char *head, bool little)
{
    f->little = little;
    f->length = strlen(head);
    memcpy(f->bytes, head, f->length);
}

static void on_warning(void *context, const char *name, size_t line, const char *message)
{
    char *text = context;
    assert_int_equal(line, 0);
    assert_string_equal(name, "b.off");
    snprintf(text + strlen(text), 200, "%s;", message);
}

static char warned[1000];

static roberts_status read_file(const file *f, roberts_mesh *mesh, roberts_error *error)
{
    roberts_warnings warnings = {on_warning, warned};
    warned[0] = '\0';
    return roberts_mesh_read_memory(mesh, "b.off", f->bytes, f->length, &warnings, error);
}

/* Reads a file that must be good. */
static roberts_mesh read_good(const file *f)
{
    roberts_mesh mesh = {0};
    roberts_error error;
    if (read_file(f, &mesh, &error) != ROBERTS_OK)
        fail_msg("refused: %s", error.message);
    return mesh;
}

static file f;

/* Three corners of the unit square, z = .5 */
static void put_triangle(file *to)
{
    put_floats(to, 9, 0.0, 0.0, 0.5, 1.0, 0.0, 0.5, 0.0, 1.0, 0.5);
}

static void check_triangle(const roberts_mesh *mesh)
{
    assert_true(mesh->vertex_count == 3 && mesh->vertex[1].x == 1.0 && mesh->vertex[2].y == 1.0);
    assert_true(mesh->vertex[0].x == 0.0 && mesh->vertex[0].y == 0.0 && mesh->vertex[0].z == 0.5);
    assert_true(mesh->face_count >= 1 && mesh->corner[0] == 0 && mesh->corner[1] == 1 && mesh->corner[2] == 2);
}

static void reads_both_orders(void **state)
{
    static const char *const heads[] = {"OFF BINARY\n", "OFF BINARY\r\n", "off binary\n", "# c\n OFF  BINARY \n"};
    (void)state;
    for (size_t h = 0; h < sizeof heads / sizeof *heads; h++) {
        for (int little = 0; little < 2; little++) {
            begin(&f, heads[h], little);
            put_words(&f, 3, 3, 2, 0);
            put_triangle(&f);
            put_words(&f, 5, 3, 0, 1, 2, 0);
            put_words(&f, 5, 3, 2, 1, 0, 0);
            roberts_mesh mesh = read_good(&f);
            check_triangle(&mesh);
            assert_true(mesh.face_count == 2 && mesh.corner[5] == 0 && !mesh.face_color && !mesh.vertex_color);
            assert_string_equal(warned, "");
            roberts_mesh_free(&mesh);
        }
    }
}

/* Counts that look alike in both orders, or smaller in the wrong one: the vertices decide. */
static void finds_the_order_from_the_vertices(void **state)
{
    static file big;
    (void)state;
    for (int little = 0; little < 2; little++) {
        begin(&big, "OFF BINARY\n", little);
        put_words(&big, 3, 0x0100, 0, 0); /* 256; the other way 65536 */
        for (int v = 0; v < 256; v++)
            put_floats(&big, 3, (double)v, 1.5, -2.0);
        roberts_mesh mesh = read_good(&big);
        assert_true(mesh.vertex_count == 256 && mesh.vertex[255].x == 255.0);
        roberts_mesh_free(&mesh);
        begin(&big, "OFF BINARY\n", little);
        put_words(&big, 3, 0x010000, 0, 0); /* 65536 declared, 256 in the other order: too short for either */
        put_floats(&big, 3, 1.5, 1.5, -2.0);
        roberts_error error;
        assert_int_equal(read_file(&big, &mesh, &error), ROBERTS_BAD_SYNTAX);
        assert_string_equal(error.message, "the input ends in vertex 1 of 0..65535 (byte 35)");
    }
}

/* Only the counts can decide: vertices at the origin, or none. */
static void finds_the_order_from_the_counts(void **state)
{
    (void)state;
    for (int little = 0; little < 2; little++) {
        for (unsigned vertices = 0; vertices < 4; vertices++) {
            begin(&f, "OFF BINARY\n", little);
            put_words(&f, 3, vertices, 2, 0);
            for (unsigned v = 0; v < vertices; v++)
                put_floats(&f, 3, 0.0, 0.0, 0.0);
            put_words(&f, 4, 0, 0, 0, 0); /* faces without corners */
            roberts_mesh mesh = read_good(&f);
            assert_true(mesh.vertex_count == vertices && mesh.face_count == 2);
            roberts_mesh_free(&mesh);
        }
    }
}

/* Vertex numbers continue from those of the previous input. */
static void appends(void **state)
{
    static const char before[] = "OFF 2 1 0\n9 9 9\n8 8 8\n2 0 1\n";
    roberts_mesh mesh = {0};
    roberts_error error;
    (void)state;
    assert_int_equal(roberts_mesh_read_memory(&mesh, "t", before, sizeof before - 1, NULL, NULL), ROBERTS_OK);
    begin(&f, "OFF BINARY\n", false);
    put_words(&f, 3, 3, 1, 0);
    put_triangle(&f);
    put_words(&f, 5, 3, 0, 1, 2, 0);
    assert_int_equal(read_file(&f, &mesh, &error), ROBERTS_OK);
    assert_true(mesh.vertex_count == 5 && mesh.face_count == 2 && mesh.vertex[3].x == 1.0);
    assert_true(mesh.corner[2] == 2 && mesh.corner[3] == 3 && mesh.corner[4] == 4);
    f.length -= 8; /* the third corner is gone */
    assert_int_equal(read_file(&f, &mesh, &error), ROBERTS_BAD_SYNTAX);
    assert_true(mesh.vertex_count == 5 && mesh.face_count == 2 && mesh.corner_count == 5);
    roberts_mesh_free(&mesh);
}

/* Gives the file in pieces; asking for more than there is fails the test, as it would wait for an open pipe. */
static ptrdiff_t read_pipe(void *context, void *buffer, size_t size)
{
    size_t *at = context, n = f.length - *at < 13 ? f.length - *at : 13;
    assert_true(n > 0 && n <= size);
    memcpy(buffer, f.bytes + *at, n);
    *at += n;
    return (ptrdiff_t)n;
}

static void leaves_an_open_pipe_alone(void **state)
{
    (void)state;
    for (int colors = 0; colors < 2; colors++) {
        size_t at = 0;
        roberts_mesh mesh = {0};
        begin(&f, "OFF BINARY\n", true);
        put_words(&f, 3, 3, 2, 0);
        put_triangle(&f);
        put_words(&f, 5, 3, 0, 1, 2, 0);
        put_words(&f, 5, 3, 0, 1, 2, colors ? 3 : 0);
        if (colors)
            put_floats(&f, 3, 0.0, 0.5, 1.0);
        assert_int_equal(roberts_mesh_read(&mesh, "p", read_pipe, &at, NULL, NULL), ROBERTS_OK);
        assert_true(mesh.face_count == 2 && at == f.length);
        roberts_mesh_free(&mesh);
    }
}

static void reads_colors(void **state)
{
    (void)state;
    for (int little = 0; little < 2; little++) {
        begin(&f, "OFF BINARY\n", little);
        put_words(&f, 3, 3, 6, 0);
        put_triangle(&f);
        put_words(&f, 5, 3, 0, 1, 2, 3), put_floats(&f, 3, 1.0, 0.5, 0.0);
        put_words(&f, 5, 3, 0, 1, 2, 4), put_floats(&f, 4, 1.0, 0.5, 0.0, 0.25);
        put_words(&f, 5, 3, 0, 1, 2, 0);
        put_words(&f, 6, 3, 0, 1, 2, 1, 7);
        put_words(&f, 5, 3, 0, 1, 2, 1), put_float(&f, 9.0f);
        put_words(&f, 4, 2, 0, 1, 2), put_floats(&f, 2, 1.0, 1.0);
        roberts_mesh mesh = read_good(&f);
        assert_true(mesh.face_count == 6 && mesh.face_color);
        assert_true(mesh.face_color[0].count == 3 && mesh.face_color[0].value[1] == 0.5f);
        assert_true(mesh.face_color[1].count == 4 && mesh.face_color[1].value[3] == 0.25f);
        assert_true(mesh.face_color[2].count == 0 && mesh.face_color[5].count == 0);
        assert_true(mesh.face_color[3].count == 1 && mesh.face_color[3].value[0] == 7.0f);
        assert_true(mesh.face_color[4].count == 1 && mesh.face_color[4].value[0] == 9.0f);
        assert_string_equal(warned, "1 colour that makes no sense ignored;"); /* and not of the line */
        roberts_mesh_free(&mesh);
    }
}

/* Triangles without the number of colour floats: "3 a b c 3 d e f" could be one with three floats, but for
 * their size. */
static void reads_faces_without_color_count(void **state)
{
    (void)state;
    for (uint32_t corners = 1; corners <= 9; corners++) {
        for (uint32_t faces = 1; faces <= 12; faces++) {
            begin(&f, "OFF BINARY\n", corners % 2);
            put_words(&f, 3, 12, faces, 0);
            for (int v = 0; v < 12; v++)
                put_floats(&f, 3, (double)v, 1.0, 2.0);
            for (uint32_t i = 0; i < faces; i++) {
                put_word(&f, corners);
                for (uint32_t k = 0; k < corners; k++)
                    put_word(&f, (i * 5 + k + 1) % 12);
            }
            if (corners == 1 && faces > 1)
                continue; /* "1 a 1 b" may also be one corner and an index of a colour map */
            roberts_mesh mesh = read_good(&f);
            if (mesh.face_count != faces || mesh.corner_count != (size_t)faces * corners || mesh.face_color)
                fail_msg("%lu faces of %lu corners: read %zu faces, %zu corners", (unsigned long)faces,
                         (unsigned long)corners, mesh.face_count, mesh.corner_count);
            roberts_mesh_free(&mesh);
        }
    }
}

static void reads_all_prefixes(void **state)
{
    (void)state;
    for (int little = 0; little < 2; little++) {
        begin(&f, "STCN4nOFF BINARY\n", little);
        put_words(&f, 4, 3, 3, 1, 0);
        for (int v = 0; v < 3; v++) {
            put_floats(&f, 4, 2.0 * (v == 1), 2.0 * (v == 2), 1.0, 2.0); /* homogeneous */
            put_floats(&f, 3, 0.0, 0.0, 1.0);                            /* normal */
            put_floats(&f, 4, 0.25, 0.5, 0.75, 1.0);                     /* colour */
            put_floats(&f, 2, 0.1, 0.2);                                 /* texture */
        }
        put_words(&f, 5, 3, 0, 1, 2, 0);
        roberts_mesh mesh = read_good(&f);
        check_triangle(&mesh);
        assert_true(mesh.vertex_color[2].count == 4 && mesh.vertex_color[2].value[2] == 0.75f);
        roberts_mesh_free(&mesh);
    }
}

static void warns(void **state)
{
    (void)state;
    begin(&f, "OFF BINARY\n", false);
    put_words(&f, 3, 3, 4, 0);
    put_triangle(&f);
    put_words(&f, 5, 3, 0, 1, 2, 0);
    roberts_mesh mesh = read_good(&f);
    check_triangle(&mesh);
    assert_string_equal(warned, "4 faces declared, but there are 1;");
    roberts_mesh_free(&mesh);
    begin(&f, "OFF BINARY\n", false);
    put_words(&f, 3, 3, 1, 0);
    put_triangle(&f);
    put_words(&f, 5, 3, 0, 1, 2, 0);
    f.bytes[f.length++] = '\n'; /* no harm */
    mesh = read_good(&f);
    assert_string_equal(warned, "");
    roberts_mesh_free(&mesh);
    put_word(&f, 77);
    mesh = read_good(&f);
    assert_string_equal(warned, "data after the last face ignored;");
    roberts_mesh_free(&mesh);
}

/* Each prefix of a good file, by memory and byte by byte: an error that leaves the mesh empty, or fewer faces. */
static void refuses_every_prefix(void **state)
{
    (void)state;
    begin(&f, "COFF BINARY\n", false);
    size_t head = f.length;
    put_words(&f, 3, 3, 2, 0);
    for (int v = 0; v < 3; v++)
        put_floats(&f, 7, (double)v, 1.0, 2.0, 0.5, 0.5, 0.5, 1.0);
    size_t vertices = f.length;
    put_words(&f, 5, 3, 0, 1, 2, 3), put_floats(&f, 3, 1.0, 0.5, 0.0);
    size_t face = f.length;
    put_words(&f, 5, 3, 0, 1, 2, 0);
    size_t whole = f.length;
    for (f.length = head; f.length <= whole; f.length++) {
        roberts_mesh mesh = {0};
        roberts_error error;
        bool good = f.length == vertices || f.length == face || f.length == whole ||
                    f.length == vertices + 16; /* one face, as of those who leave out the number of floats */
        if ((read_file(&f, &mesh, &error) == ROBERTS_OK) != good)
            fail_msg("%zu of %zu bytes: %s", f.length, whole, good ? error.message : "read");
        assert_true(good || (mesh.vertex_count == 0 && !mesh.vertex_color && error.line == 0));
        roberts_mesh_free(&mesh);
    }
}

static void refuses_bad_values(void **state)
{
    enum { NAN_WORD = 0x7fc00000, INFINITY_WORD = 0x7f800000 };
    static const struct {
        const char *name, *head;
        unsigned counts[3], z, face[5];
        roberts_status status;
        const char *message;
    } rows[] = {
        {"nan",
         "OFF BINARY\n",
         {1, 1, 0},
         NAN_WORD,
         {3, 0, 0, 0, 0},
         ROBERTS_BAD_NUMBER,
         "vertex 0 has a coordinate that is infinite or no number (byte 23)"},
        {"infinity",
         "OFF BINARY\n",
         {1, 1, 0},
         INFINITY_WORD,
         {3, 0, 0, 0, 0},
         ROBERTS_BAD_NUMBER,
         "vertex 0 has a coordinate that is infinite or no number (byte 23)"},
        {"index",
         "OFF BINARY\n",
         {1, 1, 0},
         0,
         {3, 0, 1, 0, 0},
         ROBERTS_BAD_INDEX,
         "face 0 names vertex 1, but there are 1 (byte 39)"},
        {"negative index",
         "OFF BINARY\n",
         {1, 1, 0},
         0,
         {3, 0, UINT32_MAX, 0, 0},
         ROBERTS_BAD_INDEX,
         "face 0 names vertex 4294967295, but there are 1 (byte 39)"},
        {"4e9 corners",
         "OFF BINARY\n",
         {1, 1, 0},
         0,
         {4000000000, 0, 0, 0, 0},
         ROBERTS_BAD_SYNTAX,
         "the input ends in face 0 of 0..0 (byte 39)"},
        {"4e9 faces",
         "OFF BINARY\n",
         {1, 4000000000, 0},
         0,
         {3, 0, 0, 0, 1},
         ROBERTS_BAD_SYNTAX,
         "the input ends in face 0 of 0..3999999999 (byte 55)"},
        {"4e9 vertices",
         "OFF BINARY\n",
         {4000000000, 1, 0},
         0x3f800000,
         {3, 0, 0, 0, 1},
         ROBERTS_BAD_SYNTAX,
         "the input ends in vertex 2 of 0..3999999999 (byte 47)"},
        {"colour count",
         "OFF BINARY\n",
         {1, 1, 0},
         0,
         {3, 0, 9, 0, 5},
         ROBERTS_BAD_INDEX,
         "face 0 names vertex 9, but there are 1 (byte 39)"},
        {"dimension",
         "nOFF BINARY\n",
         {5, 1, 0},
         0,
         {0},
         ROBERTS_BAD_SYNTAX,
         "the dimension is 5, but only 3 can be drawn (byte 12)"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        roberts_mesh mesh = {0};
        roberts_error error = {0};
        begin(&f, rows[i].head, false);
        put_words(&f, 3, rows[i].counts[0], rows[i].counts[1], rows[i].counts[2]);
        put_floats(&f, 2, 1.0, 2.0);
        put_word(&f, rows[i].z);
        for (int k = 0; k < 5; k++)
            put_word(&f, rows[i].face[k]);
        if (read_file(&f, &mesh, &error) != rows[i].status || strcmp(error.message, rows[i].message) != 0)
            fail_msg("%s: %s", rows[i].name, error.message);
        assert_int_equal(error.line, 0);
        roberts_mesh_free(&mesh);
    }
}

/* More corners than a block of the input holds. */
static void reads_a_long_face(void **state)
{
    enum { CORNERS = 40000 };
    (void)state;
    for (int little = 0; little < 2; little++) {
        begin(&f, "OFF BINARY\n", little);
        put_words(&f, 3, 3, 2, 0);
        put_triangle(&f);
        put_words(&f, 5, 3, 0, 1, 2, 0);
        put_word(&f, CORNERS);
        for (unsigned i = 0; i < CORNERS; i++)
            put_word(&f, i % 3);
        put_word(&f, 0);
        roberts_mesh mesh = read_good(&f);
        assert_int_equal(mesh.corner_count, 3 + CORNERS);
        for (unsigned i = 0; i < CORNERS; i++)
            assert_true(mesh.corner[3 + i] == i % 3);
        assert_string_equal(warned, "");
        roberts_mesh_free(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_both_orders),
        cmocka_unit_test(finds_the_order_from_the_vertices),
        cmocka_unit_test(finds_the_order_from_the_counts),
        cmocka_unit_test(appends),
        cmocka_unit_test(leaves_an_open_pipe_alone),
        cmocka_unit_test(reads_colors),
        cmocka_unit_test(reads_faces_without_color_count),
        cmocka_unit_test(reads_all_prefixes),
        cmocka_unit_test(warns),
        cmocka_unit_test(refuses_every_prefix),
        cmocka_unit_test(refuses_bad_values),
        cmocka_unit_test(reads_a_long_face),
    };
    return cmocka_run_group_tests_name("off binary", tests, NULL, NULL);
}
