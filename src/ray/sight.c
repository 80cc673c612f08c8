/* sight.c - sight lines against faces. See sight.h. */
#include "ray/sight.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "ray/determinant.h"

/* A face with more corners than this is sampled: this many of its corners, evenly spaced, represent all. */
#define SAMPLES 64
/* Ulps of the largest coordinate: the rounding of a coordinate or distance, from differences, three products and two
 * sums. */
#define ROUNDINGS 8.0

static roberts_vec3 normalised(roberts_vec3 a)
{
    double m = fmax(fabs(a.x), fmax(fabs(a.y), fabs(a.z)));
    a = (roberts_vec3){a.x / m, a.y / m, a.z / m};
    return vec3_scale(1.0 / vec3_length(a), a);
}

/* Let the eye be at distance D from the look-at point. At distance r D from the eye, a length l has a picture of l / r
 * in view space, and a depth of up to l / r^2. `near` and `far` bound r over the scene. An oblique view stretches or
 * compresses lengths once in the picture and once in the tilt of a plane. */
static void set_margins(sight *s, const view *v)
{
    double far = 1.0 + hypot(v->oblique.x, v->oblique.y), near = 1.0 / far, extent = 0.0;
    for (uint32_t i = 0; i < s->scene->vertex_count; i++) {
        roberts_vec3 p = s->P[i];
        extent = fmax(extent, fmax(fabs(p.x), fmax(fabs(p.y), fabs(p.z))));
        if (s->perspective) {
            double r = vec3_dot(vec3_sub(s->viewpoint, p), v->dir) * v->inverse_distance;
            near = fmin(near, r);
            far = fmax(far, r);
        }
    }
    if (s->perspective)
        extent = fmax(extent, vec3_length(s->viewpoint));
    s->rounding = ROUNDINGS * DBL_EPSILON * extent;
    s->tight = v->epsilon * fmax(near, 0.0) * near / SIGHT_MARGIN;
    s->loose = v->epsilon * far * far * SIGHT_MARGIN;
}

/* Finds the facing of a face by the width of its picture. The width is measured along the picture of the normal, as a
 * length at the depth of the first corner. */
static int sight_facing(const sight *s, uint32_t face)
{
    const roberts_scene *scene = s->scene;
    plane F = scene_plane(scene, face);
    roberts_vec3 n = {F.a, F.b, F.c}, A = s->P[scene->corner[scene->face_start[face]]];
    roberts_vec3 v = sight_from(s, A);
    double ahead = s->perspective ? sight_behind(s, face, s->viewpoint) : vec3_dot(n, v);
    double length = vec3_length(v), low = 0.0, high = 0.0;
    if (!(ahead < 0.0))
        return SIGHT_NOT_FRONT;
    v = vec3_scale(1.0 / length, v);
    double tilt = fabs(vec3_dot(n, v));
    /* A picture is at least as wide as its area divided by its greatest chord. If this is about epsilon, the picture
     * may be a sliver oblique to `across`, or nearly edge-on. */
    bool sliver = tilt * scene_width(scene, face) / s->unit <= s->loose + s->rounding;
    roberts_vec3 across = vec3_sub(n, vec3_scale(vec3_dot(n, v), v));
    if (vec3_length(across) <= 0.5)
        return sliver ? SIGHT_UNSURE : SIGHT_FRONT; /* tilted by less than 30 degrees, and not nearly edge-on */
    across = normalised(across);
    for (uint32_t k = scene->face_start[face] + 1; k < scene->face_start[face + 1]; k++) {
        roberts_vec3 p = vec3_sub(s->P[scene->corner[k]], A);
        double shorten = s->perspective ? 1.0 - vec3_dot(p, v) / length : 1.0;
        low = fmin(low, vec3_dot(p, across) / shorten);
        high = fmax(high, vec3_dot(p, across) / shorten);
    }
    if (high - low <= s->tight - s->rounding)
        return SIGHT_NOT_FRONT;
    return sliver || high - low <= s->loose + s->rounding ? SIGHT_UNSURE : SIGHT_FRONT;
}

static uint32_t corner_count(const sight *s, uint32_t face)
{
    return s->scene->face_start[face + 1] - s->scene->face_start[face];
}

/* Returns corner i of the face; the corner after the last is the first. */
static roberts_vec3 corner_of(const sight *s, uint32_t face, uint32_t i)
{
    uint32_t k = i < corner_count(s, face) ? i : 0;
    return s->P[s->scene->corner[s->scene->face_start[face] + k]];
}

/* Returns the number of the corner that is this sample. The sample after the last is the first corner again. */
static uint32_t sample_of(const sight *s, uint32_t face, uint32_t sample)
{
    return (uint32_t)((uint64_t)corner_count(s, face) * sample / SAMPLES);
}

/* Does no sample lie outside any side, as the viewer sees it? This holds for convex faces, and for some with dents. */
static bool sides_spare_samples(const sight *s, uint32_t face)
{
    const uint32_t *corner = s->scene->corner + s->scene->face_start[face];
    uint32_t count = corner_count(s, face);
    for (uint32_t k = 0; k < SAMPLES; k++) {
        roberts_vec3 X = corner_of(s, face, sample_of(s, face, k)), v = sight_from(s, X), A = s->P[corner[count - 1]];
        for (uint32_t i = 0; i < count; i++) {
            roberts_vec3 B = s->P[corner[i]];
            if (!(vec3_dot(v, vec3_cross(vec3_sub(A, X), vec3_sub(B, A))) >= 0.0))
                return false;
            A = B;
        }
    }
    return true;
}

/* Bounds how far a corner lies outside a side: half the perimeter of the face, times the sum of all turns in the wrong
 * direction. */
static double dent_of(const sight *s, uint32_t face)
{
    uint32_t count = corner_count(s, face);
    plane F = scene_plane(s->scene, face);
    roberts_vec3 n = {F.a, F.b, F.c}, A = corner_of(s, face, count - 2), B = corner_of(s, face, count - 1);
    double turned = 0.0, length = vec3_length(vec3_sub(B, A)), around = 0.0;
    for (uint32_t k = 0; k < count; k++) {
        roberts_vec3 C = corner_of(s, face, k);
        double next = vec3_length(vec3_sub(C, B)), left = -vec3_dot(n, vec3_cross(vec3_sub(B, A), vec3_sub(C, B)));
        if (left < 0.0 && length * next > 0.0)
            turned += -left / (length * next);
        around += next;
        length = next;
        A = B;
        B = C;
    }
    return 0.5 * around * turned;
}

static void turn_face(const sight *s, const roberts_scene *from, uint32_t face)
{
    uint32_t first = from->face_start[face], end = from->face_start[face + 1];
    plane *F = &s->turned->face_plane[face];
    double ahead =
        s->perspective ? sight_behind(s, face, s->viewpoint) : vec3_dot((roberts_vec3){F->a, F->b, F->c}, s->viewpoint);
    if (!(ahead > 0.0))
        return;
    *F = (plane){-F->a, -F->b, -F->c, -F->d};
    for (uint32_t k = first; k < end; k++)
        s->turned->corner[k] = from->corner[end - 1 - (k - first)];
}

/* Turns the faces of bodies that are not convex toward the viewer. False: no memory. */
static bool turn_faces(sight *s, const roberts_scene *scene)
{
    roberts_scene *to = s->turned = alloc_array(1, sizeof *to);
    if (!to)
        return false;
    *to = *scene;
    to->face_plane = alloc_array(scene->face_count, sizeof *to->face_plane);
    to->face_deviation = alloc_array(scene->face_count, sizeof *to->face_deviation);
    to->face_width = alloc_array(scene->face_count, sizeof *to->face_width);
    to->corner = alloc_array(scene->corner_count, sizeof *to->corner);
    if (!to->face_plane || !to->face_deviation || !to->face_width || !to->corner)
        return false;
    for (uint32_t face = 0; face < scene->face_count; face++) {
        const scene_shape shape = scene_shape_of(scene, face);
        to->face_plane[face] = shape.F;
        to->face_deviation[face] = (float)(shape.deviation / scene->unit); /* exact: they were floats */
        to->face_width[face] = (float)(shape.width / scene->unit);
    }
    memcpy(to->corner, scene->corner, scene->corner_count * sizeof *to->corner);
    s->scene = to;
    for (uint32_t solid = 0; solid < scene->solid_count; solid++)
        for (uint32_t face = scene->solid[solid].face; face < scene->solid[solid + 1].face; face++)
            if (!scene_is_convex(scene, solid))
                turn_face(s, scene, face);
    return true;
}

bool sight_prepare(sight *s, const roberts_scene *scene, const view *v)
{
    *s = (sight){.scene = scene, .perspective = v->perspective, .unit = v->unit};
    s->P = alloc_array(scene->vertex_count, sizeof *s->P);
    s->facing = alloc_array(scene->face_count, sizeof *s->facing);
    s->dent = alloc_zeroed(scene->face_count, sizeof *s->dent);
    if (!s->P || !s->facing || !s->dent) {
        sight_free(s);
        return false;
    }
    for (uint32_t i = 0; i < scene->vertex_count; i++)
        s->P[i] = sight_point(s, scene->point[i]);
    s->viewpoint = s->perspective ? sight_point(s, v->viewpoint) : normalised(v->viewpoint);
    if (scene->surface && !turn_faces(s, scene)) {
        sight_free(s);
        return false;
    }
    set_margins(s, v);
    for (uint32_t face = 0; face < scene->face_count; face++) {
        s->facing[face] = (unsigned char)sight_facing(s, face);
        if (s->facing[face] != SIGHT_NOT_FRONT)
            s->dent[face] = (float)(dent_of(s, face) * SCENE_UPWARD);
    }
    return true;
}

bool sight_sample(sight *s)
{
    for (uint32_t face = 0; face < s->scene->face_count; face++) {
        if (corner_count(s, face) <= SAMPLES || s->facing[face] == SIGHT_NOT_FRONT)
            continue;
        if (!s->sampled && !(s->sampled = alloc_zeroed(s->scene->face_count, sizeof *s->sampled)))
            return false;
        s->sampled[face] = sides_spare_samples(s, face);
    }
    return true;
}

void sight_free(sight *s)
{
    if (!s)
        return;
    if (s->turned) {
        free(s->turned->face_plane);
        free(s->turned->face_deviation);
        free(s->turned->face_width);
        free(s->turned->corner);
        free(s->turned);
    }
    free(s->P);
    free(s->facing);
    free(s->dent);
    free(s->sampled);
    *s = (sight){0};
}

/* Finds how the line passes the side AB. Corners of a front face run counter-clockwise for the viewer, so inside is to
 * the left of every side. XA x XB is computed as XA x AB: its rounding is proportional to AB, so a short side far from
 * X stays exact. */
static inline sight_answer pass_side(const sight *s, roberts_vec3 A, roberts_vec3 B, roberts_vec3 X, roberts_vec3 v,
                                     double slack)
{
    roberts_vec3 xa = vec3_sub(A, X), ab = vec3_sub(B, A);
    double left = vec3_dot(v, vec3_cross(xa, ab));
    if (left >= 0.0)
        return SIGHT_SURELY;
    roberts_vec3 spread = vec3_cross(v, ab); /* as long as AB's picture; squares avoid the root */
    double outside = -left - RAY_PARALLEL * vec3_triple_size(xa, ab, v), far = s->loose + s->rounding + slack;
    if (!(outside <= 0.0 || outside * outside <= far * far * vec3_dot(spread, spread)))
        return SIGHT_NO;
    bool contact = outside <= 0.0 || outside * outside <= s->rounding * s->rounding * vec3_dot(spread, spread);
    return contact ? SIGHT_SURELY : SIGHT_POSSIBLY;
}

/* Does the line pass AB on the inner side, farther from it than the touching distance? False if AB is a mere point. */
static inline bool well_left(const sight *s, roberts_vec3 A, roberts_vec3 B, roberts_vec3 X, roberts_vec3 v)
{
    roberts_vec3 xa = vec3_sub(A, X), ab = vec3_sub(B, A), spread = vec3_cross(v, ab);
    double far = s->loose + s->rounding;
    double inside = vec3_dot(v, vec3_cross(xa, ab)) - RAY_PARALLEL * vec3_triple_size(xa, ab, v);
    return inside > 0.0 && inside * inside > far * far * vec3_dot(spread, spread);
}

/* Does the line pass within the polygon of the samples, farther from its sides than the touching distance? The sides of
 * the face are no nearer to it. */
static bool well_inside(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v)
{
    roberts_vec3 A = corner_of(s, face, sample_of(s, face, SAMPLES - 1));
    for (uint32_t k = 0; k < SAMPLES; k++) {
        roberts_vec3 B = corner_of(s, face, sample_of(s, face, k));
        if (!well_left(s, A, B, X, v))
            return false;
        A = B;
    }
    return true;
}

/* The diagonals from the first corner divide a convex face into triangles. Bisection finds the two between which the
 * line passes (F. Preparata, M. Shamos, "Computational Geometry", 1985, 2.2). Returns the first of two neighbours among
 * low .. high, which are corners or samples. `across` is v x the vector from X to the first corner: its product with
 * the vector to another corner is >= 0 if the line passes left of that diagonal. The ends are not tested: beyond the
 * first and the last diagonal lie the first and the last side. */
static uint32_t bisect(const sight *s, uint32_t face, roberts_vec3 across, uint32_t low, uint32_t high, bool samples)
{
    roberts_vec3 first = corner_of(s, face, 0);
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        roberts_vec3 C = corner_of(s, face, samples ? sample_of(s, face, middle) : middle);
        if (vec3_dot(across, vec3_sub(C, first)) >= 0.0)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Gives the answer by samples; SIGHT_POSSIBLY: all sides must be tested.
 *
 * Bisection only chooses what to check. The first check is whether the line passes well within a triangle of three
 * samples, which is a part of their polygon. The second is whether it passes outside one side. If neither decides, the
 * line may pass near a diagonal, and the polygon of all samples is checked. */
static sight_answer pass_samples(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v, double slack)
{
    roberts_vec3 first = corner_of(s, face, 0), across = vec3_cross(v, vec3_sub(first, X));
    uint32_t k = bisect(s, face, across, 0, SAMPLES, true);
    uint32_t a = sample_of(s, face, k), b = sample_of(s, face, k + 1);
    roberts_vec3 A = corner_of(s, face, a), B = corner_of(s, face, b);
    if (well_left(s, A, B, X, v) && well_left(s, first, A, X, v) && well_left(s, B, first, X, v))
        return SIGHT_SURELY;
    a = bisect(s, face, across, a, b, false);
    if (pass_side(s, corner_of(s, face, a), corner_of(s, face, a + 1), X, v, slack) == SIGHT_NO)
        return SIGHT_NO;
    return well_inside(s, face, X, v) ? SIGHT_SURELY : SIGHT_POSSIBLY;
}

sight_answer sight_through(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v, double slack)
{
    const roberts_scene *scene = s->scene;
    uint32_t end = scene->face_start[face + 1];
    roberts_vec3 A = s->P[scene->corner[end - 1]];
    sight_answer answer = SIGHT_SURELY;
    slack += (double)s->dent[face];
    if (s->sampled && s->sampled[face]) {
        sight_answer early = pass_samples(s, face, X, v, slack);
        if (early != SIGHT_POSSIBLY)
            return early;
    }
    for (uint32_t k = scene->face_start[face]; k < end; k++) {
        roberts_vec3 B = s->P[scene->corner[k]];
        sight_answer side = pass_side(s, A, B, X, v, slack);
        if (side == SIGHT_NO)
            return SIGHT_NO;
        answer = side == SIGHT_POSSIBLY ? SIGHT_POSSIBLY : answer;
        A = B;
    }
    return answer;
}

bool sight_well_through(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v)
{
    const roberts_scene *scene = s->scene;
    uint32_t end = scene->face_start[face + 1];
    roberts_vec3 A = s->P[scene->corner[end - 1]];
    if (s->sampled && s->sampled[face] && well_inside(s, face, X, v))
        return true;
    for (uint32_t k = scene->face_start[face]; k < end; k++) {
        roberts_vec3 B = s->P[scene->corner[k]];
        if (!well_left(s, A, B, X, v))
            return false;
        A = B;
    }
    return true;
}

roberts_vec3 sight_meet(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v)
{
    plane F = scene_plane(s->scene, face);
    double t = -sight_behind(s, face, X) / vec3_dot(v, (roberts_vec3){F.a, F.b, F.c});
    return vec3_add(X, vec3_scale(t, v));
}

sight_answer sight_hides(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v, double slack)
{
    if (s->facing[face] == SIGHT_NOT_FRONT)
        return SIGHT_NO;
    double behind = sight_behind(s, face, X);
    if (!(behind > s->rounding))
        return SIGHT_NO;
    sight_answer through = sight_through(s, face, X, v, slack);
    if (through == SIGHT_NO)
        return SIGHT_NO;
    double deviation = scene_deviation(s->scene, face) / s->unit;
    if (s->facing[face] == SIGHT_UNSURE || !(behind > s->loose + deviation * SIGHT_MARGIN + s->rounding))
        return SIGHT_POSSIBLY;
    return through;
}

/* Is the line in contact with the side AB, as in pass_side()? */
static bool is_on_side(const sight *s, roberts_vec3 A, roberts_vec3 B, roberts_vec3 X, roberts_vec3 v)
{
    roberts_vec3 xa = vec3_sub(A, X), ab = vec3_sub(B, A), spread = vec3_cross(v, ab);
    double off = fabs(vec3_dot(v, vec3_cross(xa, ab))) - RAY_PARALLEL * vec3_triple_size(xa, ab, v);
    return off <= 0.0 || off * off <= s->rounding * s->rounding * vec3_dot(spread, spread);
}

static bool runs_along(const sight *s, roberts_vec3 A, roberts_vec3 B, const roberts_vec3 ends[2])
{
    return is_on_side(s, A, B, ends[0], sight_from(s, ends[0])) && is_on_side(s, A, B, ends[1], sight_from(s, ends[1]));
}

/* Does the line pass a side nearer than the touching distance, without contact of the whole edge? The line is known to
 * pass all sides on the inner side. */
static bool grazes_side(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v, const roberts_vec3 ends[2])
{
    const roberts_scene *scene = s->scene;
    uint32_t end = scene->face_start[face + 1];
    double far = (s->loose + s->rounding) * (s->loose + s->rounding);
    roberts_vec3 A = s->P[scene->corner[end - 1]];
    if (s->sampled && s->sampled[face] && well_inside(s, face, X, v))
        return false;
    for (uint32_t k = scene->face_start[face]; k < end; k++) {
        roberts_vec3 B = s->P[scene->corner[k]], ab = vec3_sub(B, A), spread = vec3_cross(v, ab);
        double inside = vec3_dot(spread, vec3_sub(X, A));
        if (inside * inside <= far * vec3_dot(spread, spread) &&
            !(is_on_side(s, A, B, X, v) && runs_along(s, A, B, ends)))
            return true;
        A = B;
    }
    return false;
}

double sight_touch(const sight *s, uint32_t face)
{
    return s->loose + s->rounding + SIGHT_MARGIN * scene_deviation(s->scene, face) / s->unit;
}

static bool lies_in_plane(const sight *s, uint32_t face, roberts_vec3 X)
{
    return fabs(sight_behind(s, face, X)) <= s->rounding;
}

sight_answer sight_hides_strictly(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v, double slack,
                                  const roberts_vec3 ends[2])
{
    double behind = sight_behind(s, face, X), touch = sight_touch(s, face);
    if (s->facing[face] == SIGHT_NOT_FRONT || !(behind > -touch))
        return SIGHT_NO;
    if (lies_in_plane(s, face, X) && lies_in_plane(s, face, ends[0]) && lies_in_plane(s, face, ends[1]))
        return SIGHT_NO;
    sight_answer through = sight_through(s, face, X, v, slack);
    if (through == SIGHT_NO)
        return SIGHT_NO;
    if (s->facing[face] == SIGHT_UNSURE || !(behind > touch) || grazes_side(s, face, X, v, ends))
        return SIGHT_POSSIBLY;
    return through;
}

bool sight_well_behind(const sight *s, uint32_t face, roberts_vec3 X)
{
    return s->facing[face] == SIGHT_NOT_FRONT || sight_behind(s, face, X) > sight_touch(s, face);
}

/* Clips the part to where a linear function, a at t = 0 and b at t = 1, is not negative. False: nothing is left. */
static bool clip_part(sight_part *part, double a, double b)
{
    if (!(a >= 0.0 || b >= 0.0))
        return false;
    if (a < 0.0)
        part->t0 = greater(part->t0, a / (a - b));
    else if (b < 0.0)
        part->t1 = lesser(part->t1, a / (a - b));
    return part->t0 <= part->t1;
}

/* Measures how far the two ends of AB lie inside the side PQ, times a length. The inside is a half-space: its border
 * plane contains PQ and is parallel to the sight lines there. So the distance is linear along AB, in both
 * projections. */
static void measure_side(const sight *s, roberts_vec3 P, roberts_vec3 Q, const roberts_vec3 AB[2], double inside[2])
{
    roberts_vec3 n = vec3_cross(vec3_sub(Q, P), sight_from(s, P));
    for (int i = 0; i < 2; i++)
        inside[i] = vec3_dot(n, vec3_sub(P, AB[i]));
}

/* Clips `part` to the sides from corner `first` to corner `end`. False: nothing is left. */
static bool clip_to_sides(const sight *s, uint32_t face, uint32_t first, uint32_t end, const roberts_vec3 AB[2],
                          sight_part *part)
{
    roberts_vec3 P = corner_of(s, face, first);
    for (uint32_t k = first; k < end; k++) {
        roberts_vec3 Q = corner_of(s, face, k + 1);
        double inside[2];
        measure_side(s, P, Q, AB, inside);
        if (!clip_part(part, inside[0], inside[1]))
            return false;
        P = Q;
    }
    return true;
}

/* Clips `part` to the cap beyond sample k: the polygon of that sample, the next one, and all corners between. False:
 * nothing is left. */
static bool clip_to_cap(const sight *s, uint32_t face, uint32_t k, const roberts_vec3 AB[2], sight_part *part)
{
    uint32_t first = sample_of(s, face, k), end = sample_of(s, face, k + 1);
    double inside[2];
    measure_side(s, corner_of(s, face, first), corner_of(s, face, end), AB, inside);
    return clip_part(part, -inside[0], -inside[1]) && clip_to_sides(s, face, first, end, AB, part);
}

/* Clips to the polygon of the samples, then to the caps beyond the two sides through which AB enters and leaves it.
 * False: nothing is left. */
static bool clip_to_samples(const sight *s, uint32_t face, const roberts_vec3 AB[2], sight_part *part)
{
    sight_part inner = *part, cap;
    uint32_t in = SAMPLES, out = SAMPLES;
    for (uint32_t k = 0; k < SAMPLES; k++) {
        sight_part before = inner;
        double inside[2];
        measure_side(s, corner_of(s, face, sample_of(s, face, k)), corner_of(s, face, sample_of(s, face, k + 1)), AB,
                     inside);
        bool met = clip_part(&inner, inside[0], inside[1]);
        bool beside = inside[0] < 0.0 && inside[1] < 0.0;
        in = beside || inner.t0 > before.t0 ? k : in;
        out = beside || inner.t1 < before.t1 ? k : out;
        if (met)
            continue;
        cap = *part;
        if (in < SAMPLES && clip_to_cap(s, face, in, AB, part))
            return true;
        *part = cap;
        return out < SAMPLES && out != in && clip_to_cap(s, face, out, AB, part);
    }
    cap = *part;
    if (in < SAMPLES && clip_to_cap(s, face, in, AB, &cap))
        inner.t0 = lesser(inner.t0, cap.t0);
    cap = *part;
    if (out < SAMPLES && clip_to_cap(s, face, out, AB, &cap))
        inner.t1 = greater(inner.t1, cap.t1);
    *part = inner;
    return true;
}

bool sight_hidden_part(const sight *s, uint32_t face, roberts_vec3 A, roberts_vec3 B, sight_part *part)
{
    if (s->facing[face] == SIGHT_NOT_FRONT)
        return false;
    const roberts_vec3 AB[2] = {A, B};
    double touch = sight_touch(s, face);
    *part = (sight_part){0.0, 1.0};
    if (!clip_part(part, sight_behind(s, face, A) - touch, sight_behind(s, face, B) - touch))
        return false;
    return s->sampled && s->sampled[face] ? clip_to_samples(s, face, AB, part)
                                          : clip_to_sides(s, face, 0, corner_count(s, face), AB, part);
}
