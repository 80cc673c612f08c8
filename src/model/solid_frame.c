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
    frame->edge_count = scene_corners(scene, s) / 2;
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
    frame->scene_units = frame->unit / scene->unit;
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

/* Counter-clockwise about the inward normal is clockwise seen from outside. */
static void turn(solid_frame *frame, roberts_scene *scene, uint32_t f)
{
    layout_turn_face(scene, frame->face_first + f);
    frame->turned++;
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

/* Fills in face f, of five corners or more. */
static void fit_face(solid_frame *frame, roberts_scene *scene, uint32_t f)
{
    local_face *face = &frame->face[f];
    roberts_vec3 origin = frame_origin(frame, scene, f), b = vec3_sub(frame->barycentre, origin);
    fitted_plane fit = face_plane_fit(frame->ring, frame_ring(frame, scene, f));
    double depth = vec3_dot(fit.n, b) - fit.mean, side = depth < 0.0 ? -1.0 : 1.0;
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
    if (side > 0.0)
        turn(frame, scene, f);
    frame_store(frame, scene, f, side * fit.mean);
}

static inline two_vec3 gather(const roberts_vec3 *p, const roberts_vec3 *q)
{
    return (two_vec3){two_of(p->x, q->x), two_of(p->y, q->y), two_of(p->z, q->z)};
}

/* A face without area: as fitted_plane has it. */
static void store_empty(solid_frame *frame, roberts_scene *scene, uint32_t f)
{
    frame->face[f] = (local_face){.lean = true};
    frame_store(frame, scene, f, 0.0);
}

/* Fills in faces f and g, both of `n` corners, 3 or 4; f and g may be the same. */
static void fit_two(solid_frame *frame, roberts_scene *scene, uint32_t f, uint32_t g, uint32_t n)
{
    const roberts_vec3 *point = frame->point;
    const uint32_t base = frame->vertex_first;
    local_face *p = &frame->face[f], *q = &frame->face[g];
    const uint32_t *c = scene->corner + scene->face_start[frame->face_first + f];
    const uint32_t *d = scene->corner + scene->face_start[frame->face_first + g];
    plane *G = &scene->face_plane[frame->face_first + f], *H = &scene->face_plane[frame->face_first + g];
    two_vec3 origin = gather(&point[c[0] - base], &point[d[0] - base]);
    two_vec3 a = two_vec3_sub(gather(&point[c[1] - base], &point[d[1] - base]), origin);
    two_vec3 b = two_vec3_sub(gather(&point[c[2] - base], &point[d[2] - base]), origin);
    two_vec3 middle = {two_all(frame->barycentre.x), two_all(frame->barycentre.y), two_all(frame->barycentre.z)};
    two_vec3 centre = {two_all(scene->centre.x), two_all(scene->centre.y), two_all(scene->centre.z)};
    two_vec3 first = two_vec3_sub(gather(&scene->point[c[0]], &scene->point[d[0]]), centre);
    two_planes fit = n == 3 ? two_planes_of_triangles(a, b)
                            : two_planes_of_quadrilaterals(
                                  a, b, two_vec3_sub(gather(&point[c[3] - base], &point[d[3] - base]), origin));
    two depth = two_sub(two_vec3_dot(fit.n, two_vec3_sub(middle, origin)), fit.mean), side = two_side(depth);
    two_vec3 F = {two_mul(side, fit.n.x), two_mul(side, fit.n.y), two_mul(side, fit.n.z)};
    two zero = two_all(0.0), unit = two_all(frame->unit);
    two Fd = two_mul(side, two_sub(two_sub(zero, two_vec3_dot(fit.n, origin)), fit.mean));
    two Gd = two_sub(two_sub(zero, two_vec3_dot(F, first)), two_mul(two_mul(side, fit.mean), unit));
    unsigned outward = two_at_most(side, zero);
    two_part(&p->F.a, &q->F.a, F.x);
    two_part(&p->F.b, &q->F.b, F.y);
    two_part(&p->F.c, &q->F.c, F.z);
    two_part(&p->F.d, &q->F.d, Fd);
    two_part(&G->a, &H->a, F.x);
    two_part(&G->b, &H->b, F.y);
    two_part(&G->c, &H->c, F.z);
    two_part(&G->d, &H->d, Gd);
    two_part(&p->depth, &q->depth, two_mul(side, depth));
    two_part(&p->deviation, &q->deviation, fit.deviation);
    two_part(&p->area, &q->area, fit.area);
    two_part(&p->width, &q->width, fit.width);
    two_part_floats(&scene->face_deviation[frame->face_first + f], &scene->face_deviation[frame->face_first + g],
                    two_mul(fit.deviation, two_all(frame->scene_units * SCENE_UPWARD)));
    two_part_floats(&scene->face_width[frame->face_first + f], &scene->face_width[frame->face_first + g],
                    two_mul(fit.width, two_all(frame->scene_units * SCENE_DOWNWARD)));
    p->strict = fit.strict & 1;
    q->strict = fit.strict >> 1 & 1;
    p->lean = q->lean = false;
    if (!(outward & 1))
        turn(frame, scene, f);
    if (!(outward & 2) && f != g)
        turn(frame, scene, g);
    if (fit.empty & 1)
        store_empty(frame, scene, f);
    if (fit.empty & 2 && f != g)
        store_empty(frame, scene, g);
}

/* Triangles and quadrilaterals two at a time, each with the next of its kind. */
static void fit_all(solid_frame *frame, roberts_scene *scene)
{
    uint32_t waiting[2] = {ROBERTS_NONE, ROBERTS_NONE};
    const uint32_t *start = scene->face_start + frame->face_first;
    for (uint32_t f = 0; f < frame->face_count; f++) {
        uint32_t n = start[f + 1] - start[f], *other = &waiting[n == 4];
        if (n > 4) {
            fit_face(frame, scene, f);
        } else if (*other == ROBERTS_NONE) {
            *other = f;
        } else {
            fit_two(frame, scene, *other, f, n);
            *other = ROBERTS_NONE;
        }
    }
    for (uint32_t i = 0; i < 2; i++)
        if (waiting[i] != ROBERTS_NONE)
            fit_two(frame, scene, waiting[i], waiting[i], 3 + i);
}

void frame_fit_faces(solid_frame *frame, roberts_scene *scene)
{
    bool lean = false, doubt = false, shallow = false;
    uint32_t widest = 0;
    frame->turned = 0;
    fit_all(frame, scene);
    for (uint32_t f = 0; f < frame->face_count; f++) {
        const local_face *face = &frame->face[f];
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
