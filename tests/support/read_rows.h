/* read_rows.h - rows for the readers: a text, and the expected mesh or message. */
#ifndef ROBERTS_TESTS_READ_ROWS_H
#define ROBERTS_TESTS_READ_ROWS_H

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "folders.h"
#include "roberts.h"
#include "same_complaint.h"
#include "same_mesh.h"
#include "testing.h"

/* A mesh as text: "0,0,0 1,0,0 0,1,0 | 0-1-2 | name@0". A colour follows what it colours, in the same word: "(1,0,0)",
 * in thirds. A last part "float32" means that coordinates are 32-bit floats. */
typedef struct mesh_text {
    char text[4096];
    size_t length;
} mesh_text;

static inline void mesh_text_add(mesh_text *t, const char *part)
{
    size_t length = strlen(part);
    assert_true(t->length + length < sizeof t->text);
    memcpy(t->text + t->length, part, length + 1);
    t->length += length;
}

static inline void mesh_text_color(mesh_text *t, const roberts_color *color)
{
    char part[64];
    if (!color || color->count == 0)
        return;
    snprintf(part, sizeof part, "(%.6g,%.6g,%.6g)", (double)color->value[0], (double)color->value[1],
             (double)color->value[2]);
    mesh_text_add(t, part);
}

static inline mesh_text mesh_as_text(const roberts_mesh *mesh)
{
    mesh_text t = {.length = 0};
    char part[512];
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        roberts_vec3 p = mesh->vertex[v];
        snprintf(part, sizeof part, "%s%.17g,%.17g,%.17g", v ? " " : "", p.x, p.y, p.z);
        mesh_text_add(&t, part);
        mesh_text_color(&t, mesh->vertex_color ? &mesh->vertex_color[v] : NULL);
    }
    for (size_t f = 0; f < mesh->face_count; f++) {
        mesh_text_add(&t, f ? " " : " | ");
        for (uint32_t i = mesh->face_start[f]; i < mesh->face_start[f + 1]; i++) {
            snprintf(part, sizeof part, "%s%lu", i > mesh->face_start[f] ? "-" : "", (unsigned long)mesh->corner[i]);
            mesh_text_add(&t, part);
        }
        mesh_text_color(&t, mesh->face_color ? &mesh->face_color[f] : NULL);
    }
    for (size_t g = 0; g < mesh->group_count; g++) {
        snprintf(part, sizeof part, "%s%s@%lu", g ? " " : " | ", mesh->group[g].name,
                 (unsigned long)mesh->group[g].first_face);
        mesh_text_add(&t, part);
    }
    if (mesh->source_count && mesh->source[mesh->source_count - 1].float32)
        mesh_text_add(&t, " | float32");
    return t;
}

typedef struct read_good {
    const char *name, *text;
    size_t size; /* 0: a string */
    const char *mesh, *warnings;
} read_good;

typedef struct read_bad {
    const char *name, *text;
    size_t size;
    roberts_status status;
    size_t line;
    const char *message;
} read_bad;

static inline void read_rows_warn(void *context, const char *file, size_t line, const char *message)
{
    char *said = context, one[400];
    (void)file;
    snprintf(one, sizeof one, "%zu: %s;", line, message);
    assert_true(strlen(said) + strlen(one) < 1000);
    strcat(said, one);
}

/* Delivers the input in pieces of 1 to 7 bytes. */
typedef struct read_pieces {
    const char *bytes;
    size_t size, at;
} read_pieces;

static inline ptrdiff_t read_rows_piece(void *context, void *buffer, size_t size)
{
    read_pieces *p = context;
    size_t step = 1 + p->at % 7, left = p->size - p->at;
    size_t count = step < left ? step : left;
    count = count < size ? count : size;
    if (count)
        memcpy(buffer, p->bytes + p->at, count);
    p->at += count;
    return (ptrdiff_t)count;
}

/* Reads from memory, and in pieces; both must agree. */
static inline roberts_status read_rows_read(const char *bytes, size_t size, roberts_mesh *mesh, char warnings[1000],
                                            roberts_error *error)
{
    roberts_mesh other = {0};
    roberts_error other_error = {0};
    read_pieces pieces = {bytes, size, 0};
    roberts_warnings sink = {read_rows_warn, warnings};
    warnings[0] = '\0';
    *error = (roberts_error){0};
    roberts_status status = roberts_mesh_read_memory(mesh, "t", bytes, size, &sink, error);
    if (!only_size_tells(bytes, size)) {
        assert_int_equal(roberts_mesh_read(&other, "t", read_rows_piece, &pieces, NULL, &other_error), status);
        assert_true(status == ROBERTS_OK ? same_mesh(mesh, &other) : same_complaint(&other_error, error));
    }
    roberts_mesh_free(&other);
    return status;
}

static inline void read_good_rows(const read_good *row, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char warnings[1000];
        roberts_mesh mesh = {0};
        roberts_error error;
        size_t size = row[i].size ? row[i].size : strlen(row[i].text);
        if (read_rows_read(row[i].text, size, &mesh, warnings, &error) != ROBERTS_OK)
            fail_msg("%s: line %zu: %s", row[i].name, error.line, error.message);
        mesh_text found = mesh_as_text(&mesh);
        if (strcmp(found.text, row[i].mesh) != 0 || strcmp(warnings, row[i].warnings ? row[i].warnings : "") != 0)
            fail_msg("%s: %s, warnings \"%s\"", row[i].name, found.text, warnings);
        roberts_mesh_free(&mesh);
    }
}

/* After a failure, a mesh is unchanged, whether it was empty or not. */
static inline void read_bad_rows(const read_bad *row, size_t count)
{
    static const char first[] = "o first\nv 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    for (size_t i = 0; i < count; i++) {
        char warnings[1000];
        roberts_mesh mesh = {0};
        roberts_error error;
        size_t size = row[i].size ? row[i].size : strlen(row[i].text);
        roberts_status status = read_rows_read(row[i].text, size, &mesh, warnings, &error);
        if (status != row[i].status || error.line != row[i].line || strcmp(error.message, row[i].message) != 0)
            fail_msg("%s: status %d, line %zu: %s", row[i].name, (int)status, error.line, error.message);
        assert_true(!mesh.vertex && !mesh.face_start && !mesh.corner && !mesh.source && !mesh.group);
        assert_int_equal(roberts_mesh_read_memory(&mesh, "first", first, strlen(first), NULL, NULL), ROBERTS_OK);
        assert_int_equal(roberts_mesh_read_memory(&mesh, "t", row[i].text, size, NULL, NULL), row[i].status);
        mesh_text found = mesh_as_text(&mesh);
        assert_string_equal(found.text, "0,0,0(1,0,0) 1,0,0 0,1,0 | 0-1-2 | first@0");
        roberts_mesh_free(&mesh);
    }
}

/* ---- published files -------------------------------------------------------------------------------------------- */

/* A file below models/other/ of the shared folder, and what is read of it. */
typedef struct published_file {
    const char *name;
    roberts_status status;
    size_t vertices, faces, groups;
    bool float32, vertex_color;
} published_file;

/* The test is skipped if none of the files is there. */
static inline void read_published_files(const published_file *file, size_t count)
{
    size_t read = 0;
    for (size_t i = 0; i < count; i++) {
        char path[1024];
        roberts_mesh mesh = {0};
        snprintf(path, sizeof path, "%s/models/other/%s", shared_folder(), file[i].name);
        if (access(path, R_OK) != 0)
            continue;
        assert_int_equal(roberts_mesh_read_file(&mesh, path, NULL, NULL), file[i].status);
        if (mesh.vertex_count != file[i].vertices || mesh.face_count != file[i].faces ||
            mesh.group_count != file[i].groups)
            fail_msg("%s: %zu vertices, %zu faces, %zu groups", file[i].name, mesh.vertex_count, mesh.face_count,
                     mesh.group_count);
        assert_int_equal(mesh.source_count && mesh.source[0].float32, file[i].float32);
        assert_int_equal(mesh.vertex_color != NULL, file[i].vertex_color);
        roberts_mesh_free(&mesh);
        read++;
    }
    if (read == 0)
        SKIP_BECAUSE("no published files");
}

/* ---- binary files ------------------------------------------------------------------------------------------------ */

/* The bytes of a binary file, as they are built. */
typedef struct bytes_built {
    char bytes[2048];
    size_t size;
    bool big; /* big-endian numbers */
} bytes_built;

static inline void build_bytes(bytes_built *b, const void *bytes, size_t size)
{
    assert_true(b->size + size <= sizeof b->bytes);
    memcpy(b->bytes + b->size, bytes, size);
    b->size += size;
}

/* Appends the `size` lowest bytes of the number in the wanted order. */
static inline void build_number(bytes_built *b, uint64_t number, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        char byte = (char)(number >> 8 * (b->big ? size - 1 - i : i));
        build_bytes(b, &byte, 1);
    }
}

static inline void build_float(bytes_built *b, float value)
{
    uint32_t word;
    memcpy(&word, &value, sizeof word);
    build_number(b, word, sizeof word);
}

static inline void build_double(bytes_built *b, double value)
{
    uint64_t word;
    memcpy(&word, &value, sizeof word);
    build_number(b, word, sizeof word);
}

#endif
