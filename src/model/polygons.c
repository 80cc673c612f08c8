/* polygons.c - the faces of a mesh, every corner once.
 *
 * Rule: a corner that repeats an earlier one of its face is no part of the solid, wherever in the face it stands. A
 * face left with fewer than three corners is none. */
#include "model/polygons.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"

roberts_status polygons_of_mesh(polygons *faces, const roberts_mesh *mesh, roberts_error *error)
{
    *faces = (polygons){0};
    if (mesh->vertex_count >= ROBERTS_NONE || mesh->face_count >= ROBERTS_NONE || mesh->corner_count >= ROBERTS_NONE)
        return error_set(error, ROBERTS_NO_MEMORY, 0, "more than %u vertices, faces or corners",
                         (unsigned)ROBERTS_NONE - 1);
    faces->face_count = (uint32_t)mesh->face_count;
    faces->vertex_count = (uint32_t)mesh->vertex_count;
    faces->start = mesh->face_start;
    faces->corner = mesh->corner;
    return ROBERTS_OK;
}

bool polygons_clean(polygons *faces, const uint32_t *name)
{
    size_t corners = faces->face_count ? faces->start[faces->face_count] : 0;
    uint32_t *start = alloc_array((size_t)faces->face_count + 1, sizeof *start);
    uint32_t *corner = alloc_array(corners, sizeof *corner);
    uint32_t *stamp = alloc_zeroed(faces->vertex_count, sizeof *stamp); /* 1 + the last face that has the vertex */
    bool enough = start && corner && stamp;
    uint32_t to = 0;
    if (enough) {
        for (uint32_t f = 0; f < faces->face_count; f++) {
            start[f] = to;
            for (uint32_t i = faces->start[f]; i < faces->start[f + 1]; i++) {
                uint32_t v = name ? name[faces->corner[i]] : faces->corner[i];
                if (stamp[v] != f + 1)
                    corner[to++] = v;
                stamp[v] = f + 1;
            }
        }
        start[faces->face_count] = to;
        polygons_free(&(polygons){.own_start = faces->own_start, .own_corner = faces->own_corner});
        faces->start = faces->own_start = start;
        faces->corner = faces->own_corner = corner;
        faces->repeated += corners - to;
    } else {
        free(start);
        free(corner);
    }
    free(stamp);
    return enough;
}

void polygons_free(polygons *faces)
{
    free(faces->own_start);
    free(faces->own_corner);
    *faces = (polygons){0};
}
