/* solid_frame.c - one solid and its faces in a frame of its own, in which nothing overflows or loses digits.
 *
 * Differences to a vertex of the solid are exact or nearly so, wherever the solid stands. Scaling by a power of two
 * changes no digit, so that a solid times 2^k gets the same planes. */
#include "model/solid_frame.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"
#include "read/mesh.h"

/* Beyond these sizes a solid is scaled, so that fourth powers of its lengths (squared areas), and of lengths a
 * thousand-millionth of it, are far from the ends of the range. */
static const double LARGE = 0x1p200, SMALL = 0x1p-200;

/* Thinner than this part of its size, a solid is flat: far above what rounding leaves of a plate that has no thickness
 * (some 1e-16), far below any plate that somebody would draw. */
static const double FLAT_PART = 1e-9;

static bool make_room(solid_frame *frame)
{
    return array_reserve(&frame->point, &frame->point_room, frame->vertex_count, sizeof *frame->point) &&
           array_reserve(&frame->face, &frame->face_room, frame->face_count, sizeof *frame->face) &&
           array_reserve(&frame->ring, &frame->ring_room, frame->vertex_count, sizeof *frame->ring);
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

/* Moves `count` points so that the first is at the origin, and scales them; returns their sum. */
static roberts_vec3 move_points(roberts_vec3 *to, const roberts_vec3 *point, uint32_t count, double scale)
{
    two origin = two_of(point[0].x, point[0].y), by = two_all(scale), sum = two_all(0.0);
    double origin_z = point[0].z;
    roberts_vec3 all = {0, 0, 0};
    for (uint32_t v = 0; v < count; v++) {
        two xy = two_mul(by, two_sub(two_of(point[v].x, point[v].y), origin));
        double z = scale * (point[v].z - origin_z);
        two_part(&to[v].x, &to[v].y, xy);
        to[v].z = z;
        sum = two_add(sum, xy);
        all.z += z;
    }
    two_part(&all.x, &all.y, sum);
    return all;
}

static void name_parts(solid_frame *frame, const roberts_scene *scene, uint32_t s)
{
    const scene_solid *first = scene->solid + s;
    frame->solid = s;
    frame->vertex_first = first->vertex;
    frame->vertex_count = first[1].vertex - first->vertex;
    frame->face_first = first->face;
    frame->face_count = first[1].face - first->face;
    frame->edge_count = scene_corners(scene, s) / 2;
}

roberts_status frame_enter(solid_frame *frame, const roberts_scene *scene, uint32_t s, double tolerance)
{
    const roberts_vec3 *point = scene->point + scene->solid[s].vertex;
    roberts_vec3 lo = point[0], hi = point[0], sum, diagonal;
    double largest, scale;
    name_parts(frame, scene, s);
    const uint32_t count = frame->vertex_count;
    if (!make_room(frame))
        return ROBERTS_NO_MEMORY;
    box_add_all(&lo, &hi, point + 1, count - 1);
    diagonal = vec3_sub(hi, lo);
    scale = scale_for(diagonal.x > diagonal.y ? (diagonal.x > diagonal.z ? diagonal.x : diagonal.z)
                                              : (diagonal.y > diagonal.z ? diagonal.y : diagonal.z));
    sum = move_points(frame->point, point, count, scale);
    largest = -lo.x;
    largest = hi.x > largest ? hi.x : largest;
    largest = -lo.y > largest ? -lo.y : largest;
    largest = hi.y > largest ? hi.y : largest;
    largest = -lo.z > largest ? -lo.z : largest;
    largest = hi.z > largest ? hi.z : largest;
    frame->barycentre = vec3_scale(1.0 / frame->vertex_count, sum);
    frame->unit = 1.0 / scale;
    frame->scene_units = frame->unit / scene->unit;
    frame->size = vec3_length(vec3_scale(scale, diagonal));
    frame->allowed = tolerance * (largest * scale > frame->size ? largest * scale : frame->size);
    frame->flat = FLAT_PART * frame->size;
    /* a number that is not finite makes the sum so */
    return largest <= MESH_COORDINATE_MAX && isfinite(sum.x + sum.y + sum.z) ? ROBERTS_OK : ROBERTS_BAD_NUMBER;
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

void frame_store(const solid_frame *frame, roberts_scene *scene, uint32_t f, double mean)
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
    scene_set_bounds(scene, to, face->deviation * unit, face->width * unit);
}

void frame_free(solid_frame *frame)
{
    free(frame->point);
    free(frame->face);
    free(frame->ring);
    *frame = (solid_frame){0};
}
