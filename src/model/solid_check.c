/* solid_check.c - whether a closed component is a convex solid, within the tolerance.
 *
 * A closed surface is the surface of a convex solid where every vertex lies behind every face's plane and the faces
 * cover the sphere of directions round the barycentre once. */
#include "model/solid_check.h"

#include "base/error.h"

/* Thinner than this part of its size, a solid is flat: well above what rounding leaves of a plate that has no thickness
 * (some 1e-16), well below any plate that somebody would draw. */
static const double FLAT_PART = 1e-9;

static uint32_t input_face(const roberts_scene *scene, const solid_frame *frame, uint32_t f)
{
    return scene->face_number[frame->first.face + f];
}

static uint32_t input_vertex(const roberts_scene *scene, const solid_frame *frame, uint32_t v)
{
    return scene->number[frame->first.vertex + v];
}

/* Least and greatest distance of the solid's vertices from a face's plane, > 0 inside, and the vertex farthest out. */
typedef struct reach {
    double least, most;
    uint32_t outermost;
} reach;

static reach measure_reach(const solid_frame *frame, const fitted_plane *face, roberts_vec3 on)
{
    uint32_t count = frame->end.vertex - frame->first.vertex;
    double offset = -vec3_dot(face->n, on) - face->mean;
    reach r = {INFINITY, -INFINITY, 0};
    for (uint32_t v = 0; v < count; v++) {
        double distance = vec3_dot(face->n, frame->point[v]) + offset;
        if (distance < r.least) {
            r.least = distance;
            r.outermost = v;
        }
        r.most = distance > r.most ? distance : r.most;
    }
    return r;
}

static roberts_status check_face(const roberts_scene *scene, const solid_frame *frame, uint32_t f, roberts_error *error)
{
    const fitted_plane *face = &frame->face[f];
    uint32_t corner = scene->corner[scene->face_start[frame->first.face + f]] - frame->first.vertex;
    reach r = measure_reach(frame, face, frame->point[corner]);
    double trust = fmin(1.0, face->width / frame->size);
    if (r.most - r.least < FLAT_PART * frame->size)
        return error_set(error, ROBERTS_FLAT, 0, "solid %u is flat: only %.6g thick, %.6g across", frame->solid,
                         (r.most - r.least) * frame->unit, frame->size * frame->unit);
    if (face->deviation > frame->allowed)
        return error_set(error, ROBERTS_NOT_PLANAR, 0,
                         "face %u of solid %u is not planar: a corner lies %.6g beside its plane",
                         input_face(scene, frame, f), frame->solid, face->deviation * frame->unit);
    if (-r.least * trust > frame->allowed)
        return error_set(error, ROBERTS_NOT_CONVEX, 0, "solid %u is not convex: vertex %u lies %.6g outside face %u",
                         frame->solid, input_vertex(scene, frame, r.outermost), -r.least * frame->unit,
                         input_face(scene, frame, f));
    return ROBERTS_OK;
}

roberts_status solid_check(const roberts_scene *scene, const solid_frame *frame, roberts_error *error)
{
    uint32_t faces = frame->end.face - frame->first.face;
    roberts_status status = ROBERTS_OK;
    if (frame->size == 0.0)
        return error_set(error, ROBERTS_FLAT, 0, "solid %u is flat: all its vertices lie in one point", frame->solid);
    for (uint32_t f = 0; f < faces && status == ROBERTS_OK; f++)
        status = check_face(scene, frame, f, error);
    return status;
}
