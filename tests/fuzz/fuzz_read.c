/* fuzz_read.c - the readers with any bytes: at once from memory, and through a callback that gives pieces of changing
 * size. Both must say the same, and what they give must keep what roberts.h promises. */
#include <math.h>
#include <string.h>

#include "fuzz.h"
#include "same_complaint.h"
#include "same_mesh.h"

/* The input, given out in pieces of 1 to 97 bytes, whatever is asked for. */
typedef struct pieces {
    const uint8_t *bytes;
    size_t size, at;
    uint32_t step;
} pieces;

static ptrdiff_t read_piece(void *context, void *buffer, size_t size)
{
    pieces *p = context;
    size_t count = p->size - p->at;
    p->step = p->step * 1664525u + 1013904223u;
    if (count > 1 + (p->step >> 16) % 97)
        count = 1 + (p->step >> 16) % 97;
    if (count > size)
        count = size;
    if (count > 0)
        memcpy(buffer, p->bytes + p->at, count);
    p->at += count;
    return (ptrdiff_t)count;
}

static void take_warning(void *context, const char *file, size_t line, const char *message)
{
    (void)line;
    FUZZ_REQUIRE(strcmp(file, "bytes") == 0 && *message && !strchr(message, '\n'));
    ++*(size_t *)context;
}

static void require_sound(const roberts_mesh *mesh)
{
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        roberts_vec3 p = mesh->vertex[i];
        FUZZ_REQUIRE(fabs(p.x) <= 1e150 && fabs(p.y) <= 1e150 && fabs(p.z) <= 1e150);
    }
    for (size_t f = 0; f < mesh->face_count; f++)
        FUZZ_REQUIRE(mesh->face_start[f] <= mesh->face_start[f + 1]);
    FUZZ_REQUIRE(mesh->face_count == 0 || mesh->face_start[mesh->face_count] == mesh->corner_count);
    for (size_t i = 0; i < mesh->corner_count; i++)
        FUZZ_REQUIRE(mesh->corner[i] < mesh->vertex_count);
    for (size_t i = 0; i < mesh->group_count; i++)
        FUZZ_REQUIRE(mesh->group[i].first_face <= mesh->face_count && strlen(mesh->group[i].name) < 256 &&
                     (i == 0 || mesh->group[i - 1].first_face <= mesh->group[i].first_face));
}

/* Room in proportion to the bytes: no face, vertex or corner takes less than a byte of the file. */
static void require_modest(const roberts_mesh *mesh, size_t size)
{
    FUZZ_REQUIRE(mesh->vertex_count <= size && mesh->face_count <= size && mesh->corner_count <= size);
}

int fuzz_read(const uint8_t *bytes, size_t size)
{
    size_t warned[2] = {0, 0};
    roberts_warnings warnings[2] = {{take_warning, &warned[0]}, {take_warning, &warned[1]}};
    roberts_mesh whole = {0}, pieced = {0};
    roberts_error error[2] = {{0}, {0}};
    pieces p = {bytes, size, 0, (uint32_t)size};
    roberts_status status = roberts_mesh_read_memory(&whole, "bytes", bytes, size, &warnings[0], &error[0]);
    require_sound(&whole);
    require_modest(&whole, size);
    if (!only_size_tells(bytes, size)) {
        roberts_status second = roberts_mesh_read(&pieced, "bytes", read_piece, &p, &warnings[1], &error[1]);
        /* What follows the last face is looked at only as far as it has come: a callback may wait for more. And what
         * cannot be read twice is not looked at for a number that is missing. */
        FUZZ_REQUIRE(status == second && warned[0] - warned[1] <= 2);
        FUZZ_REQUIRE(same_mesh(&whole, &pieced) && whole.source_count == pieced.source_count);
        FUZZ_REQUIRE(status == ROBERTS_OK || (error[1].status == status && same_complaint(&error[1], &error[0])));
    }
    if (status != ROBERTS_OK) {
        FUZZ_REQUIRE(error[0].status == status && error[0].message[0]);
        FUZZ_REQUIRE(whole.vertex_count == 0 && whole.face_count == 0 && whole.source_count == 0);
        FUZZ_REQUIRE(whole.group_count == 0);
    }
    roberts_mesh_free(&whole);
    roberts_mesh_free(&pieced);
    return 0;
}

int fuzz_read_behind(const void *begins, size_t length, const uint8_t *bytes, size_t size)
{
    uint8_t *file = malloc(length + size + 1);
    FUZZ_REQUIRE(file);
    memcpy(file, begins, length);
    if (size)
        memcpy(file + length, bytes, size);
    fuzz_read(file, length + size);
    free(file);
    return 0;
}
