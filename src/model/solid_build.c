/* solid_build.c - one solid after the other into the scene: vertices and faces renumbered, planes, orientation, edges.
 *
 * The solid's barycentre, the mean of its vertices, lies inside a convex solid: it decides which side of each face is
 * the inner one, whatever the winding in the file. */
#include "model/solid_build.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/error.h"
#include "model/solid_check.h"

/* Beyond these sizes a solid is scaled before anything is squared. */
static const double LARGE = 0x1p200, SMALL = 0x1p-200;

static int compare_numbers(const void *a, const void *b)
{
    uint32_t x, y;
    memcpy(&x, a, sizeof x);
    memcpy(&y, b, sizeof y);
    return (x > y) - (x < y);
}

/* Copies the corners of the group's faces as they are in the file; gives their range and the longest face. */
static void copy_corners(roberts_scene *scene, const builder *work, const uint32_t *face, uint32_t count,
                         uint32_t range[2], uint32_t *longest)
{
    uint32_t f = scene->face_count, to = scene->face_start[f];
    range[0] = ROBERTS_NONE;
    range[1] = 0;
    for (uint32_t i = 0; i < count; i++, f++) {
        const uint32_t *corner = work->faces->corner + work->faces->start[face[i]];
        uint32_t n = polygon_size(work->faces, face[i]);
        *longest = n > *longest ? n : *longest;
        scene->face_number[f] = face[i];
        scene->face_start[f] = to;
        for (uint32_t k = 0; k < n; k++) {
            uint32_t v = corner[k];
            range[0] = v < range[0] ? v : range[0];
            range[1] = v > range[1] ? v : range[1];
            scene->corner[to++] = v;
        }
    }
    scene->face_start[f] = to;
}

/* Numbers the vertices that the corners from..to use, ascending, by marking them in a table of their range. */
static bool number_dense(roberts_scene *scene, builder *work, uint32_t from, uint32_t to, const uint32_t range[2])
{
    size_t span = (size_t)range[1] - range[0] + 1;
    if (!array_reserve(&work->mark, &work->mark_room, span, sizeof *work->mark))
        return false;
    memset(work->mark, 0, span * sizeof *work->mark);
    for (uint32_t i = from; i < to; i++)
        work->mark[scene->corner[i] - range[0]] = 1;
    for (size_t v = 0; v < span; v++)
        if (work->mark[v]) {
            work->mark[v] = scene->vertex_count;
            scene->number[scene->vertex_count++] = range[0] + (uint32_t)v;
        }
    for (uint32_t i = from; i < to; i++)
        scene->corner[i] = work->mark[scene->corner[i] - range[0]];
    return true;
}

/* The same by sorting, where the solid's vertices are strewn over the file. */
static bool number_sparse(roberts_scene *scene, builder *work, uint32_t from, uint32_t to)
{
    uint32_t first = scene->vertex_count, count = to - from;
    if (!array_reserve(&work->mark, &work->mark_room, count, sizeof *work->mark))
        return false;
    memcpy(work->mark, scene->corner + from, count * sizeof *work->mark);
    qsort(work->mark, count, sizeof *work->mark, compare_numbers);
    for (uint32_t i = 0; i < count; i++)
        if (i == 0 || work->mark[i] != work->mark[i - 1])
            scene->number[scene->vertex_count++] = work->mark[i];
    for (uint32_t i = from; i < to; i++) {
        const uint32_t *found = bsearch(&scene->corner[i], scene->number + first, scene->vertex_count - first,
                                        sizeof *scene->number, compare_numbers);
        scene->corner[i] = (uint32_t)(found - scene->number);
    }
    return true;
}

/* Fills scene->point and measures the solid's frame. False where a coordinate is not finite. */
static bool measure_frame(roberts_scene *scene, builder *work, solid_frame *frame)
{
    uint32_t count = frame->end.vertex - frame->first.vertex;
    roberts_vec3 *point = scene->point + frame->first.vertex, lo, hi, sum = {0, 0, 0}, diagonal;
    double largest, scale = 1.0;
    int exponent;
    lo = hi = work->mesh->vertex[scene->number[frame->first.vertex]];
    for (uint32_t v = 0; v < count; v++) {
        roberts_vec3 p = work->mesh->vertex[scene->number[frame->first.vertex + v]];
        point[v] = p;
        lo.x = p.x < lo.x ? p.x : lo.x;
        lo.y = p.y < lo.y ? p.y : lo.y;
        lo.z = p.z < lo.z ? p.z : lo.z;
        hi.x = p.x > hi.x ? p.x : hi.x;
        hi.y = p.y > hi.y ? p.y : hi.y;
        hi.z = p.z > hi.z ? p.z : hi.z;
    }
    diagonal = vec3_sub(hi, lo);
    frame->size = fmax(fmax(diagonal.x, diagonal.y), diagonal.z);
    if (frame->size > 0.0 && (frame->size > LARGE || frame->size < SMALL)) {
        frexp(frame->size, &exponent);
        scale = ldexp(1.0, exponent < -1000 ? 1000 : -exponent);
    }
    frame->unit = 1.0 / scale;
    frame->size = vec3_length(vec3_scale(scale, diagonal));
    largest = fmax(fmax(fmax(fabs(lo.x), fabs(hi.x)), fmax(fabs(lo.y), fabs(hi.y))), fmax(fabs(lo.z), fabs(hi.z)));
    frame->allowed = work->tolerance * fmax(frame->size, largest * scale);
    for (uint32_t v = 0; v < count; v++) {
        work->point[v] = vec3_scale(scale, vec3_sub(point[v], point[0]));
        sum = vec3_add(sum, work->point[v]);
    }
    frame->point = work->point;
    frame->barycentre = vec3_scale(1.0 / count, sum);
    return isfinite(sum.x) && isfinite(sum.y) && isfinite(sum.z) && largest <= 1e150;
}

static void reverse(uint32_t *corner, uint32_t count)
{
    for (uint32_t i = 1, j = count - 1; i < j; i++, j--) {
        uint32_t swapped = corner[i];
        corner[i] = corner[j];
        corner[j] = swapped;
    }
}

/* Fits the plane of face f (compact number) and turns plane and corners so that the barycentre lies inside. */
static void fit_face(roberts_scene *scene, builder *work, const solid_frame *frame, uint32_t f)
{
    uint32_t *corner = scene->corner + scene->face_start[f], n = scene->face_start[f + 1] - scene->face_start[f];
    fitted_plane face;
    roberts_vec3 p;
    for (uint32_t i = 0; i < n; i++)
        work->ring[i] = work->point[corner[i] - frame->first.vertex];
    face = face_plane_fit(work->ring, n);
    if (vec3_dot(face.n, vec3_sub(frame->barycentre, work->ring[0])) - face.mean < 0.0) {
        face.n = (roberts_vec3){-face.n.x, -face.n.y, -face.n.z};
        face.mean = -face.mean;
    } else {
        reverse(corner, n); /* counter-clockwise about the inward normal is clockwise seen from outside */
    }
    p = vec3_sub(scene->point[corner[0]], scene->centre);
    scene->face_plane[f] = (plane){face.n.x, face.n.y, face.n.z, -vec3_dot(face.n, p) - face.mean * frame->unit};
    scene->face_deviation[f] = face.deviation * frame->unit;
    scene->face_width[f] = face.width * frame->unit;
    work->plane[f - frame->first.face] = face;
}

build_result solid_build(roberts_scene *scene, builder *work, const grouping *group, uint32_t s, roberts_error *error)
{
    solid_frame frame = {.solid = scene->solid_count, .first = scene->solid[scene->solid_count]};
    uint32_t faces = group->start[s + 1] - group->start[s], range[2], from, to, longest = 0;
    edge_pairing pairing;
    copy_corners(scene, work, group->face + group->start[s], faces, range, &longest);
    from = scene->face_start[frame.first.face];
    to = scene->face_start[frame.first.face + faces];
    if ((range[1] - range[0]) / 4 <= to - from ? !number_dense(scene, work, from, to, range)
                                               : !number_sparse(scene, work, from, to))
        return BUILD_NO_MEMORY;
    frame.end = (scene_solid){scene->vertex_count, frame.first.face + faces, frame.first.edge + (to - from) / 2};
    if (!array_reserve(&work->point, &work->point_room, frame.end.vertex - frame.first.vertex, sizeof *work->point) ||
        !array_reserve(&work->ring, &work->ring_room, longest, sizeof *work->ring) ||
        !array_reserve(&work->plane, &work->plane_room, faces, sizeof *work->plane))
        return BUILD_NO_MEMORY;
    if (!work->topology_only) {
        if (!measure_frame(scene, work, &frame))
            return error_set(error, ROBERTS_BAD_NUMBER, 0, "a vertex of solid %u is not finite or beyond 1e150",
                             frame.solid),
                   BUILD_REFUSED;
        for (uint32_t f = frame.first.face; f < frame.end.face; f++)
            fit_face(scene, work, &frame, f);
        frame.face = work->plane;
    }
    pairing = edges_pair(scene, &frame.first, &frame.end, &work->edges);
    if (pairing == EDGES_NO_MEMORY)
        return BUILD_NO_MEMORY;
    if (pairing == EDGES_OPEN) {
        scene->vertex_count = frame.first.vertex;
        return BUILD_OPEN;
    }
    scene->solid[++scene->solid_count] = frame.end;
    scene->face_count = frame.end.face;
    scene->edge_count = frame.end.edge;
    if (!work->topology_only && solid_check(scene, &frame, error) != ROBERTS_OK)
        return BUILD_REFUSED;
    if (!work->topology_only && pairing == EDGES_MIXED)
        return error_set(error, ROBERTS_NOT_CONVEX, 0, "solid %u is not convex", frame.solid), BUILD_REFUSED;
    return BUILD_OK;
}

void builder_free(builder *work)
{
    free(work->mark);
    free(work->point);
    free(work->ring);
    free(work->plane);
    edge_scratch_free(&work->edges);
}
