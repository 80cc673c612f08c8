/* stand.c - solids that stand on one of their faces. See stand.h. */
#include "stand.h"

#include "exact.h"
#include "uniform.h"

/* Adds `part`, scaled, standing on its face f. The middle of that face is at `at`, and its first corner lies in the
 * direction of (c, s) from there. The face's corners get exactly the height of `at`, so it lies in that plane. */
static void stand(body *b, const body *part, size_t f, double scale, roberts_vec3 at, roberts_vec2 direction)
{
    size_t first = body_face_start(part, f), count = part->face_end[f] - first, base = b->vertex_count;
    roberts_vec3 middle = {0}, down = body_face_normal(part, f), u, v, w = vec3_scale(-1 / vec3_length(down), down);
    motion move;
    for (size_t i = 0; i < count; i++)
        middle = vec3_add(middle, vec3_scale(1.0 / (double)count, part->vertex[part->corner[first + i]]));
    u = vec3_sub(part->vertex[part->corner[first]], middle);
    u = vec3_scale(1 / vec3_length(u), u);
    v = vec3_cross(w, u);
    roberts_vec3 x = vec3_sub(vec3_scale(direction.x, u), vec3_scale(direction.y, v));
    roberts_vec3 y = vec3_add(vec3_scale(direction.y, u), vec3_scale(direction.x, v));
    move =
        (motion){{{scale * x.x, scale * x.y, scale * x.z},
                  {scale * y.x, scale * y.y, scale * y.z},
                  {scale * w.x, scale * w.y, scale * w.z}},
                 vec3_sub(at, vec3_scale(scale, vec3(vec3_dot(x, middle), vec3_dot(y, middle), vec3_dot(w, middle))))};
    body_add(b, part, move);
    for (size_t i = 0; i < count; i++)
        b->vertex[base + part->corner[first + i]].z = at.z;
}

/* Returns the first face of `part` with this many corners. */
static size_t face_of(const body *part, size_t corners)
{
    size_t f = 0;
    while (f + 1 < part->face_count && part->face_end[f] - body_face_start(part, f) != corners)
        f++;
    return f;
}

void stand_uniform(body *b, int solid, size_t corners, double scale, roberts_vec3 at, roberts_vec2 direction)
{
    body part = {0};
    uniform_make(&part, solid);
    stand(b, &part, face_of(&part, corners), scale, at, direction);
    body_free(&part);
}

void stand_round(body *b, bool pointed, uint32_t n, double radius, double height, roberts_vec3 at)
{
    body part = {0};
    (pointed ? cone_make : column_make)(&part, n, radius, 0, height);
    body_add(b, &part, turn(1, 0, 0, 0, 1, at));
    body_free(&part);
}
