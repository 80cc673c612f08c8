/* hull_inputs.c - the inputs of a mesh, and those that have points without faces: each gets one face for all its points. */
#include "model/hull_inputs.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/error.h"

size_t hull_input_count(const roberts_mesh *mesh)
{
    return mesh->source_count ? mesh->source_count : 1;
}

hull_input hull_input_at(const roberts_mesh *mesh, size_t i)
{
    hull_input range = {0, mesh->vertex_count, 0, mesh->face_count};
    if (i > 0) {
        range.vertex = mesh->source[i].first_vertex;
        range.face = mesh->source[i].first_face;
    }
    if (i + 1 < mesh->source_count) {
        range.vertex_end = mesh->source[i + 1].first_vertex;
        range.face_end = mesh->source[i + 1].first_face;
    }
    return range;
}

size_t hull_bare_points(const roberts_mesh *mesh, size_t i)
{
    const hull_input range = hull_input_at(mesh, i);
    for (size_t f = range.face; f < range.face_end; f++)
        if (mesh->face_start[f + 1] - mesh->face_start[f] >= 3)
            return 0;
    return range.vertex_end - range.vertex;
}

bool hull_bare_input(const roberts_mesh *mesh)
{
    for (size_t i = 0; i < hull_input_count(mesh); i++)
        if (hull_bare_points(mesh, i) > 0)
            return true;
    return false;
}

static roberts_status refuse_few(const char *name, size_t points, roberts_error *error)
{
    error_set_file(error, name ? name : "");
    return error_set(error, ROBERTS_FLAT, 0, "a convex hull takes four points, but there %s %zu",
                     points == 1 ? "is" : "are", points);
}

roberts_status hull_add_inputs(polygons *faces, const roberts_mesh *mesh, roberts_error *error)
{
    const size_t inputs = hull_input_count(mesh);
    size_t corners = mesh->corner_count, count = mesh->face_count, few = inputs, vertices_of_few = 0;
    for (size_t i = 0; i < inputs; i++) {
        const size_t points = hull_bare_points(mesh, i);
        if (points >= HULL_POINTS) {
            corners += points;
            count++;
        } else if (points > 0) {
            vertices_of_few += points;
            few = few < i ? few : i;
        }
    }
    if (few < inputs && vertices_of_few == mesh->vertex_count)
        return refuse_few(mesh->source_count ? mesh->source[few].name : NULL, hull_bare_points(mesh, few), error);
    if (count == mesh->face_count)
        return ROBERTS_OK;
    if (count >= ROBERTS_NONE || corners >= ROBERTS_NONE)
        return error_no_memory(error);
    uint32_t *start = alloc_array(count + 1, sizeof *start), *corner = alloc_array(corners, sizeof *corner);
    if (!start || !corner) {
        free(start);
        free(corner);
        return error_no_memory(error);
    }
    start[0] = 0;
    if (mesh->face_count > 0)
        memcpy(start, mesh->face_start, (mesh->face_count + 1) * sizeof *start);
    if (mesh->corner_count > 0)
        memcpy(corner, mesh->corner, mesh->corner_count * sizeof *corner);
    faces->face_count = (uint32_t)mesh->face_count;
    for (size_t i = 0; i < inputs; i++) {
        const hull_input range = hull_input_at(mesh, i);
        if (hull_bare_points(mesh, i) < HULL_POINTS)
            continue;
        uint32_t to = start[faces->face_count];
        for (size_t v = range.vertex; v < range.vertex_end; v++)
            corner[to++] = (uint32_t)v;
        start[++faces->face_count] = to;
    }
    faces->start = faces->own_start = start;
    faces->corner = faces->own_corner = corner;
    return ROBERTS_OK;
}
