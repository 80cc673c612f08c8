/* mesh_corners.h - corners, points and normals of the faces of a mesh. */
#ifndef MESH_CORNERS_H
#define MESH_CORNERS_H

#include <stddef.h>
#include <stdint.h>

#include <roberts.h>

#include "base/vec.h"

static inline size_t corner_count(const roberts_mesh *m, size_t f)
{
    return m->face_start[f + 1] - m->face_start[f];
}

/* Returns corner i of face f; i is less than twice their number. */
static inline uint32_t corner(const roberts_mesh *m, size_t f, size_t i)
{
    return m->corner[m->face_start[f] + (i < corner_count(m, f) ? i : i - corner_count(m, f))];
}

static inline roberts_vec3 point(const roberts_mesh *m, size_t f, size_t i)
{
    return m->vertex[corner(m, f, i)];
}

/* Returns the unit normal of face f from the winding of its first three corners. */
static inline roberts_vec3 normal(const roberts_mesh *m, size_t f)
{
    roberts_vec3 o = point(m, f, 1);
    roberts_vec3 n = vec3_cross(vec3_sub(o, point(m, f, 0)), vec3_sub(point(m, f, 2), o));
    return vec3_scale(1 / vec3_length(n), n);
}

/* Returns the corners of the faces around vertex v as one number, whatever their order. */
static inline size_t surroundings(const roberts_mesh *m, uint32_t v)
{
    size_t code = 1;
    for (size_t f = 0; f < m->face_count; f++)
        for (size_t i = 0; i < corner_count(m, f); i++)
            if (corner(m, f, i) == v)
                code *= corner_count(m, f) * corner_count(m, f) + 1;
    return code;
}

static inline double distance(roberts_vec3 a, roberts_vec3 b)
{
    return vec3_length(vec3_sub(a, b));
}

#endif
