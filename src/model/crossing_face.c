/* crossing_face.c - see crossing_face.h. */
#include "model/crossing_face.h"

/* ---- planes and signs ------------------------------------------------------------------------------------------ */

dd3 crossing_exactly_from(const crossing_rules *rules, uint32_t v, roberts_vec3 point, roberts_vec3 low)
{
    const roberts_scene *scene = rules->scene;
    double k = 1.0 / scene->unit; /* a power of two: scaling is exact */
    dd3 d = dd3_between(vec3_scale(k, scene->point[v]), vec3_scale(k, point));
    if (!scene->low)
        return d;
    return dd3_add(d, dd3_between(vec3_scale(k, scene->low[v]), vec3_scale(k, low)));
}

/* Adds one piece's part of the normal, of the sum of the corners, and of the error. */
static void add_piece(const crossing_rules *rules, crossing_face *f, uint32_t piece, roberts_vec3 *sum)
{
    const roberts_scene *scene = rules->scene;
    uint32_t first = scene->face_start[piece], end = scene->face_start[piece + 1];
    roberts_vec3 P = crossing_from(rules, scene->corner[end - 1], f->origin, f->low);
    for (uint32_t k = first; k < end; k++) {
        roberts_vec3 Q = crossing_from(rules, scene->corner[k], f->origin, f->low);
        f->n = vec3_add(f->n, vec3_cross(P, Q));
        f->error += crossing_greatest(P) * crossing_greatest(Q);
        f->chord = greater(f->chord, crossing_greatest(Q));
        *sum = vec3_add(*sum, Q);
        P = Q;
    }
}

static uint32_t corners_of(const crossing_rules *rules, const crossing_face *f)
{
    return rules->scene->face_start[f->end] - rules->scene->face_start[f->first];
}

crossing_face crossing_face_of(const crossing_rules *rules, uint32_t body, uint32_t piece)
{
    const roberts_scene *scene = rules->scene;
    crossing_face f = {.body = body, .first = scene_first_piece(scene, body, piece), .end = piece + 1};
    roberts_vec3 sum = {0.0, 0.0, 0.0};
    if (!scene_is_convex(scene, body))
        while (f.end < scene->solid[body + 1].face &&
               scene_plane_number(scene, f.end) == scene_plane_number(scene, piece))
            f.end++;
    uint32_t origin = scene->corner[scene->face_start[f.first]], count = corners_of(rules, &f);
    f.origin = scene->point[origin];
    if (scene->low)
        f.low = scene->low[origin];
    for (uint32_t k = f.first; k < f.end; k++)
        add_piece(rules, &f, k, &sum);
    /* A coordinate of n is off by 6 + count halves of an ulp of the sum of its terms, at most twice f.error. A height
     * adds three such products and their sum. */
    f.error *= 2.0 * (40.0 + 3.0 * count) * 0x1p-53;
    f.mean = count > 3 ? vec3_dot(f.n, sum) / count : 0.0;
    f.length = vec3_length(f.n);
    f.touch = f.length * (rules->touching + scene_deviation(scene, f.first)) / scene->unit;
    return f;
}

void crossing_refine(const crossing_rules *rules, crossing_face *f)
{
    const roberts_scene *scene = rules->scene;
    dd3 n = {{0, 0}, {0, 0}, {0, 0}}, sum = n;
    uint32_t count = corners_of(rules, f);
    for (uint32_t piece = f->first; piece < f->end; piece++) {
        uint32_t first = scene->face_start[piece], end = scene->face_start[piece + 1];
        dd3 P = crossing_exactly_from(rules, scene->corner[end - 1], f->origin, f->low);
        for (uint32_t k = first; k < end; k++) {
            dd3 Q = crossing_exactly_from(rules, scene->corner[k], f->origin, f->low);
            if (k > first || piece > f->first) /* else Q is the origin; P is handled likewise */
                n = dd3_add(n, dd3_cross(P, Q));
            if (count > 3)
                sum = dd3_add(sum, Q);
            P = Q;
        }
    }
    f->exact_n = n;
    f->exact_mean = count > 3 ? dd_div(dd3_dot(n, sum), (dd){count, 0.0}) : (dd){0.0, 0.0};
    f->refined = true;
}

dd crossing_exact_height(const crossing_rules *rules, crossing_face *f, uint32_t v)
{
    if (!f->refined)
        crossing_refine(rules, f);
    return dd_sub(dd3_dot(f->exact_n, crossing_exactly_from(rules, v, f->origin, f->low)), f->exact_mean);
}

/* Is pq, of `body`, a side of g? If g has several pieces, pq may be a cut between them: then the answer is false. */
static bool is_side_of(const crossing_rules *rules, const crossing_face *g, uint32_t body, uint32_t p, uint32_t q)
{
    const roberts_scene *scene = rules->scene;
    uint32_t first = scene->face_start[g->first], end = scene->face_start[g->first + 1], a = scene->corner[end - 1];
    for (uint32_t k = first; k < end && body == g->body && !crossing_in_pieces(g); k++) {
        uint32_t b = scene->corner[k];
        if ((a == p && b == q) || (a == q && b == p))
            return true;
        a = b;
    }
    return false;
}

/* Adds the position of one piece of f. */
static void add_lie(const crossing_rules *rules, const crossing_face *f, uint32_t piece, crossing_face *g,
                    crossing_lie *to)
{
    const roberts_scene *scene = rules->scene;
    uint32_t first = scene->face_start[piece], count = scene->face_start[piece + 1] - first;
    const uint32_t *corner = scene->corner + first;
    bool whole = !crossing_in_pieces(f), begins = false, before = false; /* the first and the last corner are on it */
    for (uint32_t k = 0; k < count && !(whole && to->over && to->under); k++) {
        int sign = crossing_height_of(rules, g, f->body, corner[k]).sign;
        bool ends = begins && k + 1 == count && sign == 0; /* the side back to the first corner, too */
        to->over = to->over || sign > 0;
        to->under = to->under || sign < 0;
        if (sign == 0 && !to->side)
            to->side = (before && !is_side_of(rules, g, f->body, corner[k - 1], corner[k])) ||
                       (ends && !is_side_of(rules, g, f->body, corner[k], corner[0]));
        before = sign == 0;
        begins = k == 0 ? before : begins;
    }
}

crossing_lie crossing_lie_of(const crossing_rules *rules, const crossing_face *f, crossing_face *g)
{
    crossing_lie lie = {false, false, false};
    for (uint32_t piece = f->first; piece < f->end; piece++)
        add_lie(rules, f, piece, g, &lie);
    return lie;
}
