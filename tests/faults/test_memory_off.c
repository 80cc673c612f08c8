/* test_memory_off.c - reading with each allocation failing in turn: a status, no crash, no leak, the mesh as it was,
 * and a second try that succeeds. */
#include <stdio.h>
#include <string.h>

#include "memory.h"
#include "read/off.h"
#include "testing.h"

/* Long enough that every array grows several times. */
static size_t make_input(char *text, bool binary)
{
    size_t length = 0;
    if (binary) {
        static const char head[] = "COFF BINARY\n\0\0\0\1\0\0\0\3\0\0\0\0"
                                   "\x3f\x80\0\0\x3f\x80\0\0\x3f\x80\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0";
        length = sizeof head - 1;
        memcpy(text, head, length);
        static const char face[24] = {[3] = 3, [19] = 1, [23] = 7};
        for (int f = 0; f < 3; f++, length += sizeof face)
            memcpy(text + length, face, sizeof face);
        return length;
    }
    length = (size_t)sprintf(text, "COFF\n40 40 0\n");
    for (int v = 0; v < 40; v++)
        length += (size_t)sprintf(text + length, "%d 0 0%s\n", v, v % 4 ? "" : " 255 0 0");
    for (int f = 0; f < 40; f++)
        length += (size_t)sprintf(text + length, "5 0 1 2 3 %d%s\n", f, f % 3 ? "" : " 7");
    return length;
}

static void reading_survives(bool binary)
{
    static const char first[] = "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    static char text[4000];
    size_t length = make_input(text, binary), failures = 0, before = memory_blocks;
    for (size_t n = 1;; n++) {
        roberts_mesh mesh = {0};
        roberts_error error;
        bool appending = n % 2; /* to a mesh that holds something, or to an empty one */
        memory_fail(0);
        if (appending)
            assert_int_equal(roberts_mesh_read_memory(&mesh, "first", first, sizeof first - 1, NULL, NULL), ROBERTS_OK);
        memory_fail((n + 1) / 2);
        roberts_status status = roberts_mesh_read_memory(&mesh, "second", text, length, NULL, &error);
        bool failed = memory_failed();
        memory_fail(0);
        if (failed) {
            failures++;
            assert_int_equal(status, ROBERTS_NO_MEMORY);
            assert_string_equal(error.message, "not enough memory");
            assert_string_equal(error.file, "second");
            assert_true(mesh.vertex_count == (appending ? 3 : 0) && mesh.face_count == (appending ? 1 : 0));
            assert_true(!mesh.vertex_color && !mesh.face_color && mesh.source_count == (appending ? 1 : 0));
            status = roberts_mesh_read_memory(&mesh, "second", text, length, NULL, &error);
        }
        assert_int_equal(status, ROBERTS_OK);
        assert_true(mesh.vertex_color && mesh.face_color && mesh.vertex_color_room >= mesh.vertex_count);
        roberts_mesh_free(&mesh);
        assert_int_equal(memory_blocks, before);
        if (!failed && !appending)
            break;
    }
    assert_true(failures >= 8 + 4); /* block, source, name, five arrays; block, name, two arrays when appending */
}

static void text_survives(void **state)
{
    (void)state;
    reading_survives(false);
}

static void binary_survives(void **state)
{
    (void)state;
    reading_survives(true);
}

/* STL, OBJ with its colours, PLY: one allocation after the other fails, of the reader and of the solids' names. */
static void other_formats_survive(void **state)
{
    static const struct row {
        const char *path;
        size_t least; /* failures: block, source, name, three arrays; of STL the table, of OBJ groups, colours,
                         materials and the name of a file that is missing */
    } rows[] = {{"tests/fuzz/seeds/house.stl", 10},
                {"tests/fuzz/seeds/house-binary.stl", 7},
                {"tests/fuzz/seeds/house.obj", 15},
                {"tests/fuzz/seeds/house.ply", 7},
                {"tests/fuzz/seeds/house-big.ply", 7}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        size_t failures = 0, before = memory_blocks;
        bool failed = true;
        for (size_t n = 1; failed; n++) {
            roberts_mesh mesh = {0};
            roberts_error error = {0};
            memory_fail(n);
            roberts_status status = roberts_mesh_read_file(&mesh, rows[i].path, NULL, &error);
            failed = memory_failed();
            memory_fail(0);
            assert_int_equal(status, failed ? ROBERTS_NO_MEMORY : ROBERTS_OK);
            assert_string_equal(error.message, failed ? "not enough memory" : "");
            assert_true(!failed ||
                        (!mesh.vertex && !mesh.face_start && !mesh.source && !mesh.group && !mesh.face_color));
            failures += failed;
            roberts_mesh_free(&mesh);
            assert_int_equal(memory_blocks, before);
        }
        if (failures < rows[i].least)
            fail_msg("%s: %zu failures", rows[i].path, failures);
    }
}

static ptrdiff_t read_at(void *context, uint64_t offset, void *buffer, size_t size)
{
    const char *text = context;
    size_t length = strlen(text), left = offset < length ? length - (size_t)offset : 0, n = left < size ? left : size;
    memcpy(buffer, text + (offset < length ? offset : 0), n);
    return (ptrdiff_t)n;
}

static size_t place; /* of the single reader of the text */

static ptrdiff_t read_on(void *context, void *buffer, size_t size)
{
    ptrdiff_t got = read_at(context, place, buffer, size < 50 ? size : 50);
    place += (size_t)got;
    return got;
}

static bool go(void *context, uint64_t offset)
{
    (void)context;
    place = (size_t)offset;
    return true;
}

static void run_in_turn(off_work_fn *work, void *job, uint32_t threads)
{
    for (uint32_t i = 0; i < threads; i++)
        work(job, i);
}

/* In pieces: memory that only they need may be missing, since one thread can read everything. */
static void pieces_survive(void **state)
{
    static char text[4000];
    const off_division division = {2, 60, 40, 1, run_in_turn};
    size_t length = (size_t)sprintf(text, "OFF\n60 60 0\n"), failures = 0, before = memory_blocks;
    (void)state;
    for (int i = 0; i < 60; i++)
        length += (size_t)sprintf(text + length, "%d 0 0\n", i);
    for (int i = 0; i < 60; i++)
        length += (size_t)sprintf(text + length, "3 0 1 %d\n", i);
    const input_source source = {
        .read = read_on, .context = text, .read_at = read_at, .go = go, .size = length, .to_end = true};
    for (size_t n = 1;; n++) {
        roberts_mesh mesh = {0};
        roberts_error error;
        place = 0;
        memory_fail(n);
        roberts_status status = read_mesh(&mesh, "pieces", &source, &division, NULL, &error);
        bool failed = memory_failed();
        memory_fail(0);
        failures += status == ROBERTS_NO_MEMORY;
        assert_true(status == ROBERTS_OK ? mesh.vertex_count == 60 && mesh.face_count == 60
                                         : failed && status == ROBERTS_NO_MEMORY && mesh.vertex_count == 0);
        roberts_mesh_free(&mesh);
        assert_int_equal(memory_blocks, before);
        if (!failed) {
            assert_true(n > failures + 10); /* slots, and texts of the threads */
            break;
        }
    }
    assert_true(failures >= 4); /* block, source, name, vertices; failures in pieces are tried again */
}

static void adding_survives(void **state)
{
    static const char colored[] = "COFF 1 1 0\n0 0 0 1. 0 0\n3 0 0 0 7\n";
    const uint32_t corner[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    size_t failures = 0, before = memory_blocks;
    (void)state;
    for (size_t n = 1;; n++) {
        roberts_mesh mesh = {0};
        roberts_error error;
        size_t vertices = 1, faces = 1;
        memory_fail(0);
        assert_int_equal(roberts_mesh_read_memory(&mesh, "t", colored, sizeof colored - 1, NULL, NULL), ROBERTS_OK);
        memory_fail(n);
        for (int i = 0; i < 20; i++) {
            roberts_status status = roberts_mesh_add_vertex(&mesh, (roberts_vec3){1, 2, 3}, NULL, &error);
            assert_true(status == ROBERTS_OK || status == ROBERTS_NO_MEMORY);
            vertices += status == ROBERTS_OK;
            status = roberts_mesh_add_face(&mesh, corner, 10, &error);
            assert_true(status == ROBERTS_OK || status == ROBERTS_NO_MEMORY);
            faces += status == ROBERTS_OK;
        }
        bool failed = memory_failed();
        failures += failed;
        memory_fail(0);
        assert_true(mesh.vertex_count == vertices && mesh.face_count == faces && vertices + faces + failed == 42);
        assert_true(mesh.corner_count == 3 + 10 * (faces - 1) && mesh.face_start[faces] == mesh.corner_count);
        roberts_mesh_free(&mesh);
        assert_int_equal(memory_blocks, before);
        if (!failed)
            break;
    }
    assert_true(failures >= 8);
}

/* Counts without data take no memory: no block is larger than the buffer for reading. */
static void declared_counts_take_no_memory(void **state)
{
    static const char *const rows[] = {
        "OFF 4000000000 4000000000 4000000000\n0 0 0\n1 0 0\n0 1 0\n",
        "COFF 4000000000 4000000000 0\n0 0 0 1 0 0\n",
        "OFF 3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n",
        "OFF 1 18446744073709551615 0\n0 0 0\n18446744073709551615 0\n",
        "OFF 1 4294967294 0\n0 0 0\n4294967295 0\n",
        "4000000000\n",
    };
    static const char binary[] = "OFF BINARY\n\0\0\0\1\xee\0\0\0\0\0\0\0\x3f\x80\0\0\x3f\x80\0\0\x3f\x80\0\0"
                                 "\xee\0\0\0\0\0\0\0\0\0\0\0";
    (void)state;
    for (size_t i = 0; i <= sizeof rows / sizeof *rows; i++) {
        bool last = i == sizeof rows / sizeof *rows;
        const char *bytes = last ? binary : rows[i];
        roberts_mesh mesh = {0};
        memory_fail(0);
        roberts_status status =
            roberts_mesh_read_memory(&mesh, "t", bytes, last ? sizeof binary - 1 : strlen(bytes), NULL, NULL);
        assert_int_equal(status, i == 2 ? ROBERTS_OK : i == 4 ? ROBERTS_BAD_NUMBER : ROBERTS_BAD_SYNTAX);
        assert_true(memory_largest > 0 && memory_largest < 80000);
        roberts_mesh_free(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(text_survives),         cmocka_unit_test(binary_survives),
        cmocka_unit_test(other_formats_survive), cmocka_unit_test(pieces_survive),
        cmocka_unit_test(adding_survives),       cmocka_unit_test(declared_counts_take_no_memory),
    };
    return cmocka_run_group_tests_name("memory off", tests, NULL, NULL);
}
