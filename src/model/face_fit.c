/* face_fit.c - the planes of a solid's faces, and which way round their corners run.
 *
 * Nearly all faces have three or four corners: they are fitted two at a time, each with the next of its kind. */
#include "model/face_plane.h"
#include "model/layout.h"
#include "model/solid_frame.h"

/* Counter-clockwise about the inward normal is clockwise seen from outside. */
static void turn(solid_frame *frame, roberts_scene *scene, uint32_t f)
{
    layout_turn_face(scene, frame->face_first + f);
    frame->turned++;
}

/* What the checks ask of all faces together. */
static void note(solid_frame *frame, const local_face *face)
{
    frame->any_lean |= face->lean;
    frame->any_doubt |= face->deviation > frame->allowed || !face->strict;
    frame->any_shallow |= face->depth < frame->flat;
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
    note(frame, face);
    if (side > 0.0)
        turn(frame, scene, f);
    frame_store(frame, scene, f, side * fit.mean);
}

/* Two faces of three or four corners each, lane by lane; they may be the same. */
typedef struct two_faces {
    uint32_t f, g;         /* counted from the solid's first */
    const uint32_t *c, *d; /* their corners */
    two_vec3 origin;       /* their first corners */
    two_planes fit;
    two side; /* -1 where the fitted normal points outward */
} two_faces;

/* Corner k of both. */
static inline two_vec3 corners_at(const solid_frame *frame, const two_faces *t, uint32_t k)
{
    const roberts_vec3 *point = frame->point;
    return two_vec3_of(&point[t->c[k] - frame->vertex_first], &point[t->d[k] - frame->vertex_first]);
}

static inline two_faces take_two(const solid_frame *frame, const roberts_scene *scene, uint32_t f, uint32_t g,
                                 uint32_t corners)
{
    two_faces t = {.f = f, .g = g};
    t.c = scene->corner + scene->face_start[frame->face_first + f];
    t.d = scene->corner + scene->face_start[frame->face_first + g];
    t.origin = corners_at(frame, &t, 0);
    two_vec3 a = two_vec3_sub(corners_at(frame, &t, 1), t.origin), b = two_vec3_sub(corners_at(frame, &t, 2), t.origin);
    if (corners == 3)
        t.fit = two_planes_of_triangles(a, b);
    else
        t.fit = two_planes_of_quadrilaterals(a, b, two_vec3_sub(corners_at(frame, &t, 3), t.origin));
    return t;
}

/* The planes in the frame and in the scene. */
static inline void store_planes(const solid_frame *frame, roberts_scene *scene, const two_faces *t)
{
    local_face *p = &frame->face[t->f], *q = &frame->face[t->g];
    plane *G = &scene->face_plane[frame->face_first + t->f], *H = &scene->face_plane[frame->face_first + t->g];
    two_vec3 first =
        two_vec3_sub(two_vec3_of(&scene->point[t->c[0]], &scene->point[t->d[0]]), two_vec3_all(scene->centre));
    two zero = two_all(0.0), mean = t->fit.mean;
    two_vec3 n = t->fit.n, F = {two_mul(t->side, n.x), two_mul(t->side, n.y), two_mul(t->side, n.z)};
    two_part(&p->F.a, &q->F.a, F.x);
    two_part(&p->F.b, &q->F.b, F.y);
    two_part(&p->F.c, &q->F.c, F.z);
    two_part(&p->F.d, &q->F.d, two_mul(t->side, two_sub(two_sub(zero, two_vec3_dot(n, t->origin)), mean)));
    two_part(&G->a, &H->a, F.x);
    two_part(&G->b, &H->b, F.y);
    two_part(&G->c, &H->c, F.z);
    two_part(&G->d, &H->d,
             two_sub(two_sub(zero, two_vec3_dot(F, first)), two_mul(two_mul(t->side, mean), two_all(frame->unit))));
}

static inline void store_sizes(const solid_frame *frame, roberts_scene *scene, const two_faces *t, two depth)
{
    local_face *p = &frame->face[t->f], *q = &frame->face[t->g];
    uint32_t f = frame->face_first + t->f, g = frame->face_first + t->g;
    two_part(&p->depth, &q->depth, depth);
    two_part(&p->deviation, &q->deviation, t->fit.deviation);
    two_part(&p->area, &q->area, t->fit.area);
    two_part(&p->width, &q->width, t->fit.width);
    two_part_floats(&scene->face_deviation[f], &scene->face_deviation[g],
                    two_mul(t->fit.deviation, two_all(frame->scene_units * SCENE_UPWARD)));
    two_part_floats(&scene->face_width[f], &scene->face_width[g],
                    two_mul(t->fit.width, two_all(frame->scene_units * SCENE_DOWNWARD)));
    p->strict = t->fit.strict & 1;
    q->strict = t->fit.strict >> 1 & 1;
    p->lean = q->lean = false;
}

/* A face without area: as fitted_plane has it. */
static void store_empty(solid_frame *frame, roberts_scene *scene, uint32_t f)
{
    frame->face[f] = (local_face){.lean = true};
    note(frame, &frame->face[f]);
    frame_store(frame, scene, f, 0.0);
}

/* Fills in faces f and g, both of `corners` corners, 3 or 4; f and g may be the same. */
static void fit_two(solid_frame *frame, roberts_scene *scene, uint32_t f, uint32_t g, uint32_t corners)
{
    two_faces t = take_two(frame, scene, f, g, corners);
    two depth = two_sub(two_vec3_dot(t.fit.n, two_vec3_sub(two_vec3_all(frame->barycentre), t.origin)), t.fit.mean);
    t.side = two_side(depth);
    depth = two_mul(t.side, depth);
    store_planes(frame, scene, &t);
    store_sizes(frame, scene, &t, depth);
    unsigned full = 3 & ~t.fit.empty, outward = two_at_most(t.side, two_all(0.0));
    frame->any_doubt |= (two_at_most(t.fit.deviation, two_all(frame->allowed)) & t.fit.strict & full) != full;
    frame->any_shallow |= (two_at_most(two_all(frame->flat), depth) & full) != full;
    if (!(outward & 1))
        turn(frame, scene, f);
    if (!(outward & 2) && f != g)
        turn(frame, scene, g);
    if (t.fit.empty & 1)
        store_empty(frame, scene, f);
    if (t.fit.empty & 2 && f != g)
        store_empty(frame, scene, g);
}

/* Neighbours in the list that are of one kind go together; others wait for the next of theirs. */
static void fit_all(solid_frame *frame, roberts_scene *scene)
{
    uint32_t waiting[2] = {ROBERTS_NONE, ROBERTS_NONE};
    const uint32_t *start = scene->face_start + frame->face_first, count = frame->face_count;
    for (uint32_t f = 0; f < count; f++) {
        uint32_t n = start[f + 1] - start[f], *other = &waiting[n == 4];
        if (n > 4) {
            fit_face(frame, scene, f);
        } else if (f + 1 < count && start[f + 2] - start[f + 1] == n) {
            fit_two(frame, scene, f, f + 1, n);
            f++;
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
    double greatest;
    frame->turned = frame->widest = 0;
    frame->any_lean = frame->any_doubt = frame->any_shallow = false;
    fit_all(frame, scene);
    greatest = frame->face[0].width;
    for (uint32_t f = 1; f < frame->face_count; f++)
        if (frame->face[f].width > greatest) {
            greatest = frame->face[f].width;
            frame->widest = f;
        }
}
