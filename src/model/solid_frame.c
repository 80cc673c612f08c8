/* solid_frame.c - one solid and its faces in a frame of its own, in which nothing overflows or loses digits.
 *
 * Differences to a vertex of the solid are exact or nearly so, wherever the solid stands. Scaling by a power of two
 * changes no digit, so that a solid times 2^k gets the same planes. */
#include "model/solid_frame.h"

#include <stdlib.h>

#include "base/array.h"
#include "model/face_plane.h"
#include "model/layout.h"

/* Beyond these sizes a solid is scaled, so that fourth powers of its lengths (squared areas), and of lengths a
 * thousand-millionth of it, are far from the ends of the range. */
static const double LARGE = 0x1p200, SMALL = 0x1p-200;

/* Thinner than this part of its size, a solid is flat: far above what rounding leaves of a plate that has no thickness
 * (some 1e-16), far below any plate that somebody would draw. */
static const double FLAT_PART = 1e-9;

/* What coordinates may reach; the same as for reading. */
static const double GREATEST_COORDINATE = 1e150;

static bool make_room(solid_frame *frame, const roberts_scene *scene)
{
    uint32_t longest = 0;
    for (uint32_t f = frame->face_first; f < frame->face_first + frame->face_count; f++) {
        uint32_t n = scene->face_start[f + 1] - scene->face_start[f];
        longest = n > longest ? n : longest;
    }
    return array_reserve(&frame->point, &frame->point_room, frame->vertex_count, sizeof *frame->point) &&
           array_reserve(&frame->face, &frame->face_room, frame->face_count, sizeof *frame->face) &&
           array_reserve(&frame->ring, &frame->ring_room, longest, sizeof *frame->ring);
}

/* A power of two that brings a size beyond the limits to about 1; 1 for all others. */
static double scale_for(double size)
{
    int exponent;
    if ((size <= LARGE && size >= SMALL) || size == 0.0)
        return 1.0;
    frexp(size, &exponent);
    return ldexp(1.0, exponent < -1000 ? 1000 : -exponent); /* denormal sizes: 2^1074 would overflow */
}

roberts_status frame_enter(solid_frame *frame, const roberts_scene *scene, uint32_t s, double tolerance)
{
    const scene_solid *first = scene->solid + s;
    const roberts_vec3 *point = scene->point + first->vertex;
    roberts_vec3 lo = point[0], hi = point[0], sum = {0, 0, 0}, diagonal;
    double largest, scale;
    frame->solid = s;
    frame->vertex_first = first->vertex;
    frame->vertex_count = first[1].vertex - first->vertex;
    frame->face_first = first->face;
    frame->face_count = first[1].face - first->face;
    if (!make_room(frame, scene))
        return ROBERTS_NO_MEMORY;
    for (uint32_t v = 0; v < frame->vertex_count; v++)
        box_add(&lo, &hi, point[v]);
    diagonal = vec3_sub(hi, lo);
    scale = scale_for(diagonal.x > diagonal.y ? (diagonal.x > diagonal.z ? diagonal.x : diagonal.z)
                                              : (diagonal.y > diagonal.z ? diagonal.y : diagonal.z));
    for (uint32_t v = 0; v < frame->vertex_count; v++) {
        frame->point[v] = vec3_scale(scale, vec3_sub(point[v], point[0]));
        sum = vec3_add(sum, frame->point[v]);
    }
    largest = -lo.x;
    largest = hi.x > largest ? hi.x : largest;
    largest = -lo.y > largest ? -lo.y : largest;
    largest = hi.y > largest ? hi.y : largest;
    largest = -lo.z > largest ? -lo.z : largest;
    largest = hi.z > largest ? hi.z : largest;
    frame->barycentre = vec3_scale(1.0 / frame->vertex_count, sum);
    frame->unit = 1.0 / scale;
    frame->size = vec3_length(vec3_scale(scale, diagonal));
    frame->allowed = tolerance * (largest * scale > frame->size ? largest * scale : frame->size);
    frame->flat = FLAT_PART * frame->size;
    /* a number that is not finite makes the sum so */
    return largest <= GREATEST_COORDINATE && isfinite(sum.x + sum.y + sum.z) ? ROBERTS_OK : ROBERTS_BAD_NUMBER;
}

uint32_t frame_ring(const solid_frame *frame, const roberts_scene *scene, uint32_t f)
{
    const uint32_t *start = scene->face_start + frame->face_first + f, base = frame->vertex_first;
    const uint32_t *corner = scene->corner + start[0];
    const roberts_vec3 *point = frame->point, origin = point[corner[0] - base];
    uint32_t n = start[1] - start[0];
    roberts_vec3 *ring = frame->ring;
    for (uint32_t i = 0; i < n; i++)
        ring[i] = vec3_sub(point[corner[i] - base], origin);
    return n;
}

static void reverse(uint32_t *corner, uint32_t count)
{
    for (uint32_t i = 1, j = count - 1; i < j; i++, j--) {
        uint32_t swapped = corner[i];
        corner[i] = corner[j];
        corner[j] = swapped;
    }
}

static inline void store(const solid_frame *frame, roberts_scene *scene, uint32_t f, double mean)
{
    const local_face *face = &frame->face[f];
    uint32_t to = frame->face_first + f;
    double unit = frame->unit;
    plane F = face->F, *G = &scene->face_plane[to];
    roberts_vec3 p = vec3_sub(scene->point[scene->corner[scene->face_start[to]]], scene->centre);
    G->a = F.a;
    G->b = F.b;
    G->c = F.c;
    G->d = -(F.a * p.x + F.b * p.y + F.c * p.z) - mean * unit;
    scene->face_deviation[to] = face->deviation * unit;
    scene->face_width[to] = face->width * unit;
}

void frame_store(const solid_frame *frame, roberts_scene *scene, uint32_t f, double mean)
{
    store(frame, scene, f, mean);
}

/* Fills in face f; returns the mean for store(). */
static inline double fit_face(solid_frame *frame, roberts_scene *scene, uint32_t f)
{
    local_face *face = &frame->face[f];
    const uint32_t *start = scene->face_start + frame->face_first + f, base = frame->vertex_first;
    const roberts_vec3 *point = frame->point;
    uint32_t *corner = scene->corner + start[0], n = start[1] - start[0];
    roberts_vec3 origin = point[corner[0] - base], b = vec3_sub(frame->barycentre, origin);
    fitted_plane fit;
    double side, depth;
    if (n == 3)
        fit = face_plane_of_triangle(vec3_sub(point[corner[1] - base], origin),
                                     vec3_sub(point[corner[2] - base], origin));
    else if (n == 4)
        fit = face_plane_of_quadrilateral(vec3_sub(point[corner[1] - base], origin),
                                          vec3_sub(point[corner[2] - base], origin),
                                          vec3_sub(point[corner[3] - base], origin));
    else
        fit = face_plane_fit(frame->ring, frame_ring(frame, scene, f));
    depth = vec3_dot(fit.n, b) - fit.mean;
    side = depth < 0.0 ? -1.0 : 1.0;
    face->F.a = side * fit.n.x;
    face->F.b = side * fit.n.y;
    face->F.c = side * fit.n.z;
    face->F.d = side * (-vec3_dot(fit.n, origin) - fit.mean);
    face->depth = side * depth;
    face->deviation = fit.deviation;
    face->area = fit.area;
    face->width = fit.width;
    face->strict = fit.strict;
    face->lean = !(fit.area > 0.0);
    if (side > 0.0) /* counter-clockwise about the inward normal is clockwise seen from outside */
        reverse(corner, n);
    return side * fit.mean;
}

void frame_fit_faces(solid_frame *frame, roberts_scene *scene)
{
    bool lean = false, doubt = false, shallow = false;
    uint32_t widest = 0;
    for (uint32_t f = 0; f < frame->face_count; f++) {
        const local_face *face = &frame->face[f];
        store(frame, scene, f, fit_face(frame, scene, f));
        lean |= face->lean;
        doubt |= face->deviation > frame->allowed || !face->strict;
        shallow |= face->depth < frame->flat;
        widest = face->width > frame->face[widest].width ? f : widest;
    }
    frame->any_lean = lean;
    frame->any_doubt = doubt;
    frame->any_shallow = shallow;
    frame->widest = widest;
}

void frame_free(solid_frame *frame)
{
    free(frame->point);
    free(frame->face);
    free(frame->ring);
    *frame = (solid_frame){0};
}
