/* test_off_models.c - published models, and what another reader (that made INDEX.md beside them) found in them: numbers
 * of vertices, faces, thin faces and colours. Skipped where they are not there. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "roberts.h"

enum { LINE = 4096 };

static const char *folder(void)
{
    const char *shared = getenv("ROBERTS_SHARED");
    return shared && *shared ? shared : "../shared";
}

/* The index, or a test that is skipped. */
static FILE *open_index(void)
{
    char path[LINE];
    snprintf(path, sizeof path, "%s/models/INDEX.md", folder());
    FILE *file = fopen(path, "r");
    if (!file) {
        print_message("no %s\n", path);
        skip();
    }
    return file;
}

static void count_warning(void *context, const char *file, size_t line, const char *message)
{
    size_t *thin = context, count;
    (void)file;
    (void)line;
    if (sscanf(message, "%zu face", &count) == 1 && strstr(message, "fewer than 3 corners"))
        *thin = count;
}

static roberts_status read_model(const char *name, roberts_mesh *mesh, size_t *thin, roberts_error *error)
{
    char path[LINE];
    roberts_warnings warnings = {count_warning, thin};
    *thin = 0;
    snprintf(path, sizeof path, "%s/models/%s", folder(), name);
    return roberts_mesh_read_file(mesh, path, &warnings, error);
}

/* Column `wanted` of a table row, in which "\|" is no border. */
static bool column(const char *row, int wanted, char *text)
{
    int at = -1;
    for (const char *c = row; *c; c++) {
        if (*c == '|' && (c == row || c[-1] != '\\'))
            at++;
        else if (at == wanted)
            *text++ = *c;
    }
    *text = '\0';
    return at > wanted;
}

/* The name between back quotes at the start of `text`. */
static bool quoted(const char *text, char *name)
{
    return sscanf(text, " `%[^`]`", name) == 1;
}

static void numbers_are_those_of_the_index(void **state)
{
    char row[LINE], text[LINE], name[LINE];
    int models = 0, refused = 0;
    FILE *index = open_index();
    (void)state;
    while (fgets(row, sizeof row, index)) {
        size_t vertices, faces, thin;
        roberts_mesh mesh = {0};
        roberts_error error;
        if (!column(row, 0, text) || !quoted(text, name))
            continue;
        assert_true(column(row, 3, text) && sscanf(text, "%zu", &vertices) == 1);
        assert_true(column(row, 4, text) && sscanf(text, "%zu", &faces) == 1);
        models++;
        roberts_status status = read_model(name, &mesh, &thin, &error);
        if (strstr(name, "bogus")) { /* 1000 vertices declared, 4 there */
            refused++;
            assert_int_equal(status, ROBERTS_BAD_SYNTAX);
            assert_int_equal(error.line, 6);
        } else if (status != ROBERTS_OK || mesh.vertex_count != vertices || mesh.face_count != faces) {
            fail_msg("%s: %s, %zu vertices, %zu faces instead of %zu, %zu", name, status ? error.message : "read",
                     mesh.vertex_count, mesh.face_count, vertices, faces);
        }
        roberts_mesh_free(&mesh);
    }
    fclose(index);
    print_message("%d models, %d refused\n", models, refused);
    assert_true(models >= 40 && refused == 1);
}

/* How many of `count` things have a colour of `numbers` numbers. */
static size_t colored(const roberts_color *color, size_t count, unsigned numbers)
{
    size_t n = 0;
    for (size_t i = 0; color && i < count; i++)
        n += color[i].count == numbers;
    return n;
}

/* Compares with the notes "... 24 faces with <3 vertices ...; face colour fields: 360x3f, 760x4f; vertex extra fields: 8x4". */
static void compare_notes(const char *name, const char *notes)
{
    size_t thin, expected_thin = 0, number;
    unsigned numbers;
    roberts_mesh mesh = {0};
    roberts_error error;
    const char *note;
    if (read_model(name, &mesh, &thin, &error) != ROBERTS_OK)
        fail_msg("%s: %s", name, error.message);
    if ((note = strstr(notes, " faces with <3")) != NULL) {
        while (note[-1] >= '0' && note[-1] <= '9')
            note--;
        expected_thin = strtoul(note, NULL, 10);
    }
    if (thin != expected_thin)
        fail_msg("%s: %zu thin faces instead of %zu", name, thin, expected_thin);
    if ((note = strstr(notes, "face colour fields: ")) != NULL) {
        size_t all = 0;
        for (note += 19;
             (*note == ' ' || *note == ',') && sscanf(note + (*note == ','), " %zux%u", &number, &numbers) == 2;) {
            if (colored(mesh.face_color, mesh.face_count, numbers) != number)
                fail_msg("%s: not %zu faces with colours of %u numbers", name, number, numbers);
            all += number;
            note += strcspn(note + 1, ",;\n") + 1;
        }
        assert_true(all > 0 && all <= mesh.face_count);
        assert_int_equal(colored(mesh.face_color, mesh.face_count, 0), mesh.face_count - all);
    } else {
        assert_null(mesh.face_color);
    }
    if ((note = strstr(notes, "vertex extra fields: ")) != NULL &&
        sscanf(note + 21, "%zux%u", &number, &numbers) == 2 && numbers == 4)
        assert_int_equal(colored(mesh.vertex_color, mesh.vertex_count, 4), number);
    else
        assert_null(mesh.vertex_color);
    roberts_mesh_free(&mesh);
}

static void colours_are_those_of_the_index(void **state)
{
    char row[LINE], name[LINE];
    int notes = 0;
    FILE *index = open_index();
    (void)state;
    while (fgets(row, sizeof row, index)) {
        if (strncmp(row, "- ", 2) != 0 || !quoted(row + 2, name) || strstr(name, "bogus"))
            continue;
        notes++;
        compare_notes(name, row);
    }
    fclose(index);
    assert_true(notes >= 39);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_those_of_the_index),
        cmocka_unit_test(colours_are_those_of_the_index),
    };
    return cmocka_run_group_tests_name("off models", tests, NULL, NULL);
}
