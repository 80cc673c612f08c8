/* test_off_any.c - arbitrary bytes: no crash, no invalid mesh, errors with a message, an unchanged mesh after an error,
 * and the same result however the bytes arrive. Good files are cut off at each byte, each byte is replaced by every
 * other value, and pieces of different files are combined at random. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rng.h"
#include "same_complaint.h"
#include "same_mesh.h"
#include "testing.h"

typedef struct bytes {
    const char *text;
    size_t length;
} bytes;

#define TEXT(literal)                                                                                                  \
    {                                                                                                                  \
        literal, sizeof(literal) - 1                                                                                   \
    }

static const bytes seeds[] = {
    TEXT("OFF\n3 2 0\n0 0 0\n1.5 0 0\n0 -1e1 .25\n3 0 1 2\n3 2 1 0 255 0 0\n"),
    TEXT("{ = STCN4nOFF 3\n2 1 0\n0 0 0 1 0 0 1 .5 0 0 1 .1 .2\n1 0 0 2 0 0 1 9 1 1\n3 0 1 0 7 #\n}"),
    TEXT("\xef\xbb\xbf"
         "coff2 1\r\n0 0 0 1 0 0\r1 0 0\r\n\r\n1 0 #a\n"),
    TEXT("3\n1 1 0\n# c\n0.12345678901234567890 1e-320 12345678901234567\n1 0\nrest"),
    TEXT(
        "OFF BINARY\n\0\0\0\1\0\0\0\1\0\0\0\0\x3f\x80\0\0\x3f\x80\0\0\0\0\0\0\0\0\0\2\0\0\0\0\0\0\0\0\0\0\0\1\0\0\0\7"),
    TEXT("OFF BINARY\n\1\0\0\0\2\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\x80\x3f\0\0\0\0\1\0\0\0\0\0\0\0\1\0\0\0\0\0\0\0"),
};

typedef struct feed {
    bytes left;
    size_t step;
} feed;

static ptrdiff_t read_feed(void *context, void *buffer, size_t size)
{
    feed *f = context;
    size_t n = f->left.length < f->step ? f->left.length : f->step;
    n = n < size ? n : size;
    memcpy(buffer, f->left.text, n);
    f->left.text += n;
    f->left.length -= n;
    return (ptrdiff_t)n;
}

static void check_warning(void *context, const char *file, size_t line, const char *message)
{
    (void)context;
    (void)line;
    assert_string_equal(file, "any.off");
    assert_true(strlen(message) > 10 && !strpbrk(message, "\n\r"));
}

static void check_mesh(const roberts_mesh *mesh)
{
    for (size_t f = 0; f < mesh->face_count; f++)
        assert_true(mesh->face_start[f] <= mesh->face_start[f + 1] && mesh->face_start[0] == 0);
    assert_true(mesh->corner_count == (mesh->face_count ? mesh->face_start[mesh->face_count] : 0));
    for (size_t i = 0; i < mesh->corner_count; i++)
        assert_true(mesh->corner[i] < mesh->vertex_count);
    for (size_t v = 0; v < mesh->vertex_count; v++)
        assert_true(fabs(mesh->vertex[v].x) <= 1e150 && fabs(mesh->vertex[v].y) <= 1e150 &&
                    fabs(mesh->vertex[v].z) <= 1e150);
    for (size_t v = 0; mesh->vertex_color && v < mesh->vertex_count; v++)
        assert_true(mesh->vertex_color[v].count <= 4);
    for (size_t f = 0; mesh->face_color && f < mesh->face_count; f++)
        assert_true(mesh->face_color[f].count <= 4);
    assert_true(mesh->source_count == 1);
}

/* Reads the input in two ways and compares. */
static void check(bytes input)
{
    roberts_warnings warnings = {check_warning, NULL};
    roberts_mesh whole = {0}, pieces = {0};
    roberts_error error = {0}, other = {0};
    feed source = {input, input.length % 5 + 1};
    roberts_status status = roberts_mesh_read_memory(&whole, "any.off", input.text, input.length, &warnings, &error);
    if (status == ROBERTS_OK) {
        check_mesh(&whole);
    } else {
        assert_true(status == ROBERTS_BAD_SYNTAX || status == ROBERTS_BAD_INDEX || status == ROBERTS_BAD_NUMBER);
        assert_true(error.status == status && strlen(error.message) > 10 &&
                    strlen(error.message) < sizeof error.message - 1);
        assert_true(strcmp(error.file, "any.off") == 0 && error.line <= input.length + 1);
        for (const char *c = error.message; *c; c++)
            assert_true(*c >= ' ' && *c <= '~');
        assert_true(!whole.vertex_count && !whole.face_count && !whole.source_count && !whole.vertex_color &&
                    !whole.face_color && !whole.face_start);
    }
    if (only_size_tells(input.text, input.length)) {
        roberts_mesh_free(&whole);
        return;
    }
    if (roberts_mesh_read(&pieces, "any.off", read_feed, &source, NULL, &other) != status ||
        (status != ROBERTS_OK && !same_complaint(&other, &error)) || !same_mesh(&whole, &pieces)) {
        fprintf(stderr, "input:");
        for (size_t i = 0; i < input.length; i++)
            fprintf(stderr, " %02x", (unsigned char)input.text[i]);
        fail_msg("not the same in pieces of %zu: \"%s\" line %zu, \"%s\" line %zu", input.length % 5 + 1, error.message,
                 error.line, other.message, other.line);
    }
    roberts_mesh_free(&whole);
    roberts_mesh_free(&pieces);
}

/* A copy without anything around it, so that a sanitizer sees reads beyond its ends. */
static void check_copy(const char *text, size_t length)
{
    char *copy = malloc(length ? length : 1);
    assert_non_null(copy);
    memcpy(copy, text, length);
    check((bytes){copy, length});
    free(copy);
}

static void cut_off_anywhere(void **state)
{
    (void)state;
    for (size_t s = 0; s < sizeof seeds / sizeof *seeds; s++) {
        for (size_t length = 0; length <= seeds[s].length; length++)
            check_copy(seeds[s].text, length);
    }
}

static void any_byte_changed(void **state)
{
    (void)state;
    for (size_t s = 0; s < sizeof seeds / sizeof *seeds; s++) {
        char text[200];
        assert_true(seeds[s].length < sizeof text);
        memcpy(text, seeds[s].text, seeds[s].length);
        for (size_t i = 0; i < seeds[s].length; i++) {
            for (int c = 0; c < 256; c++) {
                text[i] = (char)c;
                check((bytes){text, seeds[s].length});
            }
            text[i] = seeds[s].text[i];
        }
    }
}

static void pieces_by_chance(void **state)
{
    static const char *const words[] = {"OFF",   "BINARY\n", " ",    "\n",         "\r",    "#",    "{",   "}",
                                        "=",     "3",        "0",    "1 ",         "-1",    ".",    "e9",  "nan",
                                        "1e999", "4OFF",     "nOFF", "COFF",       "STOFF", "NOFF", "\t",  "0 0 0\n",
                                        "2 ",    "255",      "0.5 ", "999999999 ", "\v",    "\x01", "\xff"};
    rng r = {5};
    (void)state;
    for (int n = 0; n < 20000; n++) {
        char text[400];
        size_t length = 0;
        for (uint32_t pieces = 1 + rng_below(&r, 30); pieces; pieces--) {
            const bytes *from = &seeds[rng_below(&r, sizeof seeds / sizeof *seeds)];
            const char *piece = words[rng_below(&r, sizeof words / sizeof *words)];
            size_t size = strlen(piece);
            if (rng_below(&r, 4) == 0) {
                size_t start = rng_below(&r, (uint32_t)from->length);
                piece = from->text + start;
                size = 1 + rng_below(&r, (uint32_t)(from->length - start));
            }
            if (length + size > sizeof text)
                break;
            memcpy(text + length, piece, size);
            length += size;
        }
        check((bytes){text, length});
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cut_off_anywhere),
        cmocka_unit_test(any_byte_changed),
        cmocka_unit_test(pieces_by_chance),
    };
    return cmocka_run_group_tests_name("off any", tests, NULL, NULL);
}
