/* test_off_models.c - published models, compared with what another reader found in them and listed in INDEX.md: numbers
 * of vertices, faces, thin faces and colours. Skipped if the models are not there. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "folders.h"
#include "roberts.h"
#include "testing.h"

enum { LINE = 4096 };

/* The index, or a test that is skipped. */
static FILE *open_index(void)
{
    char path[LINE];
    snprintf(path, sizeof path, "%s/models/INDEX.md", shared_folder());
    FILE *file = fopen(path, "r");
    if (!file) {
        SKIP_BECAUSE("no %s", path);
    }
    return file;
}

/* Reads a model; `thin` gets how many of its faces have fewer than three corners, of which there is no warning. */
static roberts_status read_model(const char *name, roberts_mesh *mesh, size_t *thin, roberts_error *error)
{
    char path[LINE];
    snprintf(path, sizeof path, "%s/models/%s", shared_folder(), name);
    roberts_status status = roberts_mesh_read_file(mesh, path, NULL, error);
    *thin = 0;
    for (size_t f = 0; f < mesh->face_count; f++)
        *thin += mesh->face_start[f + 1] - mesh->face_start[f] < 3;
    return status;
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
        size_t vertices = 0, faces = 0, thin;
        roberts_mesh mesh = {0};
        roberts_error error;
        if (!column(row, 0, text) || !quoted(text, name))
            continue;
        if (column(row, 3, text))
            vertices = strtoul(text, NULL, 10);
        if (column(row, 4, text))
            faces = strtoul(text, NULL, 10);
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

/* Reads "24x3f, 8x4f" and compares; returns how many there are in all. */
static size_t compare_colors(const char *name, const char *fields, const roberts_color *color, size_t count)
{
    size_t all = 0;
    for (char *end; *fields == ' ' || *fields == ','; fields = end + 1) { /* after the letter f or i */
        size_t number = strtoul(fields + (*fields == ','), &end, 10);
        if (*end != 'x')
            break;
        unsigned numbers = (unsigned)strtoul(end + 1, &end, 10);
        if (colored(color, count, numbers) != number)
            fail_msg("%s: not %zu colours of %u numbers", name, number, numbers);
        all += number;
    }
    return all;
}

/* The text after `title` in the notes; NULL if there is none. */
static const char *after(const char *notes, const char *title)
{
    const char *found = strstr(notes, title);
    return found ? found + strlen(title) : NULL;
}

/* Compares with the notes "... 24 faces with <3 vertices ...; face colour fields: 360x3f, 760x4f". */
static void compare_notes(const char *name, const char *notes)
{
    size_t thin, expected_thin = 0;
    roberts_mesh mesh = {0};
    roberts_error error;
    const char *note = strstr(notes, " faces with <3");
    if (read_model(name, &mesh, &thin, &error) != ROBERTS_OK)
        fail_msg("%s: %s", name, error.message);
    if (note) {
        while (note[-1] >= '0' && note[-1] <= '9')
            note--;
        expected_thin = strtoul(note, NULL, 10);
    }
    if (thin != expected_thin)
        fail_msg("%s: %zu thin faces instead of %zu", name, thin, expected_thin);
    if ((note = after(notes, "face colour fields:")) != NULL) {
        size_t all = compare_colors(name, note, mesh.face_color, mesh.face_count);
        assert_true(all > 0 && all + colored(mesh.face_color, mesh.face_count, 0) == mesh.face_count);
    } else {
        assert_null(mesh.face_color);
    }
    if ((note = after(notes, "vertex extra fields:")) != NULL && !strstr(name, "NOFF")) { /* there they are normals */
        assert_int_equal(colored(mesh.vertex_color, mesh.vertex_count, 4), mesh.vertex_count);
        assert_true(strtoul(note, NULL, 10) == mesh.vertex_count);
    } else {
        assert_null(mesh.vertex_color);
    }
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
