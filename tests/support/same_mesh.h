/* same_mesh.h - compares two meshes: vertices, faces, colours and groups, but not their inputs. */
#ifndef ROBERTS_TESTS_SAME_MESH_H
#define ROBERTS_TESTS_SAME_MESH_H

#include <string.h>

#include "roberts.h"

static inline bool same_colors(const roberts_color *a, const roberts_color *b, size_t count)
{
    if (!a != !b)
        return false;
    for (size_t i = 0; a && i < count; i++)
        if (a[i].count != b[i].count || memcmp(a[i].value, b[i].value, a[i].count * sizeof *a->value) != 0)
            return false;
    return true;
}

static inline bool same_groups(const roberts_mesh *a, const roberts_mesh *b)
{
    for (size_t i = 0; i < a->group_count && i < b->group_count; i++)
        if (strcmp(a->group[i].name, b->group[i].name) != 0 || a->group[i].first_face != b->group[i].first_face)
            return false;
    return a->group_count == b->group_count;
}

static inline bool same_mesh(const roberts_mesh *a, const roberts_mesh *b)
{
    return a->vertex_count == b->vertex_count && a->face_count == b->face_count && a->corner_count == b->corner_count &&
           (!a->vertex_count || memcmp(a->vertex, b->vertex, a->vertex_count * sizeof *a->vertex) == 0) &&
           (!a->corner_count || memcmp(a->corner, b->corner, a->corner_count * sizeof *a->corner) == 0) &&
           !a->face_start == !b->face_start &&
           (!a->face_start || memcmp(a->face_start, b->face_start, (a->face_count + 1) * sizeof *a->face_start) == 0) &&
           same_colors(a->vertex_color, b->vertex_color, a->vertex_count) &&
           same_colors(a->face_color, b->face_color, a->face_count) && same_groups(a, b);
}

#endif
