/* lines.h - points and parts of lines, for the judges. */
#ifndef ROBERTS_TESTS_LINES_H
#define ROBERTS_TESTS_LINES_H

#include <math.h>
#include <stdlib.h>

#include "oracle.h"

static inline roberts_vec3 line_point(roberts_vec3 a, roberts_vec3 b, double t)
{
    return (roberts_vec3){a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

static inline double line_length(roberts_vec3 a, roberts_vec3 b)
{
    return hypot(hypot(a.x - b.x, a.y - b.y), a.z - b.z);
}

/* Returns the parameter along ab of the point nearest to X. */
static inline double line_along(roberts_vec3 a, roberts_vec3 b, roberts_vec3 X)
{
    double dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
    return ((X.x - a.x) * dx + (X.y - a.y) * dy + (X.z - a.z) * dz) / (dx * dx + dy * dy + dz * dz);
}

/* The same; *off: how far X lies from the line. */
static inline double line_beside(roberts_vec3 a, roberts_vec3 b, roberts_vec3 X, double *off)
{
    double t = line_along(a, b, X);
    *off = line_length(line_point(a, b, t), X);
    return t;
}

/* Compares numbers, intervals, or other structs that begin with a number, for qsort(). */
static inline int line_by_start(const void *a, const void *b)
{
    const double *p = (const double *)a, *q = (const double *)b;
    return (*p > *q) - (*p < *q);
}

/* Sorts intervals and joins those that lie within `gap` of one another; returns how many are left. */
static inline size_t line_join(oracle_interval *part, size_t count, double gap)
{
    size_t joined = 0;
    qsort(part, count, sizeof *part, line_by_start);
    for (size_t i = 0; i < count; i++)
        if (joined && part[i].t0 <= part[joined - 1].t1 + gap)
            part[joined - 1].t1 = fmax(part[joined - 1].t1, part[i].t1);
        else
            part[joined++] = part[i];
    return joined;
}

/* Returns the largest of all coordinates, without their signs. */
static inline double mesh_size(const roberts_mesh *mesh)
{
    double size = 0;
    for (size_t i = 0; i < mesh->vertex_count; i++)
        size = fmax(size, fmax(fabs(mesh->vertex[i].x), fmax(fabs(mesh->vertex[i].y), fabs(mesh->vertex[i].z))));
    return size;
}

#endif
