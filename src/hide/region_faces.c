/* region_faces.c - what regions take from their faces: colours; which neighbours lie in one plane. */
#include "hide/region_faces.h"

#include <string.h>

#include "base/vec.h"
#include "hide/tolerance.h"

/* ---- colours ---- */

/* The first piece of a face of the input, in the scene before the near plane cuts it; ROBERTS_NONE: there is none. */
static uint32_t source_face(const roberts_scene *source, uint32_t solid, uint32_t number)
{
    uint32_t low = source->solid[solid].face, end = source->solid[solid + 1].face, high = end;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (scene_face_number(source, middle) < number)
            low = middle + 1;
        else
            high = middle;
    }
    return low < end && scene_face_number(source, low) == number ? low : ROBERTS_NONE;
}

/* The mean of the colours of the corners of a face's pieces; none if a corner has none, or only an index. */
static roberts_color corners_color(const roberts_scene *source, uint32_t solid, uint32_t face)
{
    const uint32_t number = scene_face_number(source, face), end = source->solid[solid + 1].face;
    double sum[4] = {0.0}, count = 0.0;
    unsigned char parts = 3;
    for (; face < end && scene_face_number(source, face) == number; face++)
        for (uint32_t k = source->face_start[face]; k < source->face_start[face + 1]; k++) {
            const roberts_color *own = &source->vertex_color[source->corner[k]];
            if (own->count < 3)
                return (roberts_color){0};
            parts = own->count > parts ? own->count : parts;
            for (int i = 0; i < 4; i++)
                sum[i] += i < own->count ? (double)own->value[i] : 1.0; /* without alpha it is opaque */
            count += 1.0;
        }
    roberts_color mean = {.count = parts};
    for (int i = 0; i < parts; i++)
        mean.value[i] = (float)(sum[i] / count);
    return mean;
}

roberts_color region_color(const hide_job *job, uint32_t piece)
{
    const roberts_scene *source = job->seen.source;
    const uint32_t solid = scene_body_of_face(job->fronts.scene, piece);
    const uint32_t number = scene_face_number(job->fronts.scene, piece);
    const roberts_color none = {0};
    if (number == ROBERTS_NONE || (!source->face_color && !source->vertex_color))
        return none;
    uint32_t face = source_face(source, solid, number);
    if (face == ROBERTS_NONE)
        return none;
    if (source->face_color && source->face_color[face].count > 0)
        return source->face_color[face];
    return source->vertex_color ? corners_color(source, solid, face) : none;
}

/* ---- neighbours in one plane ---- */

/* Whether the corners of one face lie in the plane of another, as far as both are planar. */
static bool is_in_plane(const hide_job *job, uint32_t face, uint32_t other)
{
    const roberts_scene *scene = job->fronts.scene;
    const double far = scene_deviation(scene, face) + scene_deviation(scene, other) +
                       REGION_TOUCHING * job->seen.view.epsilon * job->seen.view.unit;
    bool within = true;
    for (uint32_t k = scene->face_start[face]; within && k < scene->face_start[face + 1]; k++)
        within =
            fabs(plane_at(scene_plane(scene, other), vec3_sub(scene->point[scene->corner[k]], scene->centre))) <= far;
    return within;
}

static bool is_one_color(const roberts_color *a, const roberts_color *b)
{
    return a->count == b->count && !memcmp(a->value, b->value, a->count * sizeof *a->value);
}

bool region_can_join(const hide_job *job, uint32_t f, uint32_t g)
{
    const roberts_scene *scene = job->fronts.scene;
    if ((!job->merge_bodies && scene_body_of_face(scene, f) != scene_body_of_face(scene, g)) ||
        !is_in_plane(job, f, g) || !is_in_plane(job, g, f))
        return false;
    const roberts_color a = region_color(job, f);
    const roberts_color b = region_color(job, g);
    return is_one_color(&a, &b);
}
