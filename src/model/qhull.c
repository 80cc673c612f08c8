/* qhull.c - the facets of a convex hull, computed by libqhull.
 *
 * Qhull adds point after point to a hull, and merges facets that rounding leaves doubtful. So its facets are polygons.
 * Points that are not corners lie inside, or at most a few widths outside. Source: C. B. Barber, D. P. Dobkin, H.
 * Huhdanpaa, "The Quickhull algorithm for convex hulls", ACM Transactions on Mathematical Software 22(4), 1996.
 *
 * Qhull's messages go to a small memory buffer that nobody reads; its errors are returned as numbers. Qhull calls
 * exit() on an error within an error, and on an error outside qh_new_qhull(), so nothing that can fail is called
 * outside. Every hull has its own state. */
#include "model/qhull.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <libqhull_r/qhull_ra.h>

#include "base/array.h"

_Static_assert(sizeof(roberts_vec3) == 3 * sizeof(coordT), "points are given to Qhull as they are");

/* Writes Qhull's option for the width as an integer and a power of ten. This avoids the decimal point, which depends on
 * the locale. */
static void write_command(char *command, size_t size, double width)
{
    if (width > 0.0) {
        int exponent = (int)floor(log10(width)) - 2;
        snprintf(command, size, "qhull Pp E%.0fe%d", ceil(width / pow(10.0, exponent)), exponent);
    } else {
        snprintf(command, size, "qhull Pp");
    }
}

static uint32_t point_number(const qhT *qh, const vertexT *vertex)
{
    return (uint32_t)((vertex->point - qh->first_point) / 3);
}

static size_t count_ridges(const facetT *facet)
{
    ridgeT *ridge, **ridgep;
    size_t count = 0;
    FOREACHridge_(facet->ridges) count++;
    return count;
}

/* Appends the corners of a facet that was merged from others. Its ridges determine the order of the corners. False: no
 * memory. */
static bool add_polygon(hull_facets *facets, const qhT *qh, const facetT *facet)
{
    uint32_t *corner = facets->corner + facets->start[facets->count], count = 0, first = 0, at;
    ridgeT *ridge, **ridgep;
    FOREACHridge_(facet->ridges)
    {
        uint32_t a = point_number(qh, SETfirstt_(ridge->vertices, vertexT));
        uint32_t b = point_number(qh, SETsecondt_(ridge->vertices, vertexT));
        bool along = ridge->top == facet;
        first = along ? a : b;
        facets->next[first] = along ? b : a;
        count++;
    }
    at = first;
    for (uint32_t i = 0; i < count; i++, at = facets->next[at])
        corner[i] = at;
    facets->start[facets->count + 1] = facets->start[facets->count] + count;
    facets->count++;
    return count >= 3 && at == first;
}

static bool add_triangle(hull_facets *facets, const qhT *qh, const facetT *facet)
{
    uint32_t *corner = facets->corner + facets->start[facets->count];
    for (int i = 0; i < 3; i++)
        corner[i] = point_number(qh, SETelemt_(facet->vertices, i, vertexT));
    facets->start[facets->count + 1] = facets->start[facets->count] + 3;
    facets->count++;
    return true;
}

static hull_result copy_facets(hull_facets *facets, const qhT *qh, uint32_t points)
{
    size_t corners = 0, count = 0;
    const facetT *facet;
    FORALLfacets
    {
        corners += facet->simplicial ? 3 : count_ridges(facet);
        count++;
    }
    if (corners >= ROBERTS_NONE ||
        !array_reserve(&facets->start, &facets->start_room, count + 1, sizeof *facets->start) ||
        !array_reserve(&facets->corner, &facets->corner_room, corners, sizeof *facets->corner) ||
        !array_reserve(&facets->next, &facets->next_room, points, sizeof *facets->next))
        return HULL_NO_MEMORY;
    memset(facets->next, 0, points * sizeof *facets->next); /* defined even if the ridges are not a cycle */
    facets->count = 0;
    facets->start[0] = 0;
    facets->outside = qh->max_outside;
    FORALLfacets
    {
        if (!(facet->simplicial ? add_triangle : add_polygon)(facets, qh, facet))
            return HULL_FAILED;
    }
    return HULL_OK;
}

static hull_result result_of(int code)
{
    switch (code) {
    case qh_ERRnone:
        return HULL_OK;
    case qh_ERRinput: /* all points have the same x, y or z: there are enough points, and the options are ours */
    case qh_ERRsingular:
        return HULL_FLAT;
    case qh_ERRmem:
        return HULL_NO_MEMORY;
    default:
        return HULL_FAILED;
    }
}

hull_result hull_take(hull_facets *facets, const roberts_vec3 *point, uint32_t count, double width)
{
    char command[64], said[128];
    int unused[2];
    if (count < 4)
        return HULL_FLAT;
    if (count > INT_MAX)
        return HULL_NO_MEMORY;
    qhT *qh = alloc_zeroed(1, sizeof *qh);
    FILE *messages = fmemopen(said, sizeof said, "w");
    hull_result result = HULL_NO_MEMORY;
    if (qh && messages) {
        /* Qhull's parameter is not const, but only options that rotate or joggle the points would change them */
        coordT *coordinates = (coordT *)(uintptr_t)point;
        write_command(command, sizeof command, width);
        result = result_of(qh_new_qhull(qh, 3, (int)count, coordinates, False, command, NULL, messages));
        if (result == HULL_OK)
            result = copy_facets(facets, qh, count);
        qh_freeqhull(qh, !qh_ALL);
        qh_memfreeshort(qh, &unused[0], &unused[1]);
    }
    if (messages)
        fclose(messages);
    free(qh);
    return result;
}

void hull_facets_free(hull_facets *facets)
{
    free(facets->start);
    free(facets->corner);
    free(facets->next);
    *facets = (hull_facets){0};
}
