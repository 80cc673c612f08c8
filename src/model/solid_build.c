/* solid_build.c - from faces that are laid out to solids: planes, winding, edges, checks.
 *
 * The solid's barycentre, the mean of its vertices, lies inside a convex solid: it decides which side of each face is
 * the inner one, whatever the winding in the file. The two faces of each edge then pass it in opposite directions; where
 * they do not, faces too narrow to decide are wound like their neighbours. */
#include "model/solid_build.h"

#include "base/error.h"
#include "model/narrow_face.h"
#include "model/place.h"
#include "model/convex.h"

/* Whether the solid's edges are stored with its pattern's, which is closed. */
static bool is_stored(const roberts_scene *scene, uint32_t s)
{
    return scene->solid[s].stored < scene->shared;
}

build_result solid_is_closed(const roberts_scene *scene, builder *work, uint32_t s, roberts_error *error)
{
    if (is_stored(scene, s))
        return BUILD_OK;
    edge_pairing pairing = edges_pair(scene, s, &work->edges);
    if (pairing == EDGES_NO_MEMORY)
        return error_no_memory(error), BUILD_REFUSED;
    return pairing == EDGES_OPEN || !edges_like_a_sphere(scene, s) ? BUILD_OPEN : BUILD_OK;
}

/* The edges of solid s, whose faces have been wound: its pattern's, where all or none of them were turned, else found
 * anew. */
static edge_pairing pair(const roberts_scene *scene, builder *work, uint32_t s)
{
    solid_frame *frame = &work->frame;
    if (!is_stored(scene, s) || frame->turned % frame->face_count != 0) {
        edge_pairing pairing = edges_pair(scene, s, &work->edges);
        frame->edge = work->edges.edge;
        return pairing;
    }
    frame->edge = scene->edge + scene->solid[s].stored + (frame->turned > 0 ? frame->edge_count : 0);
    return EDGES_PAIRED;
}

static roberts_status wind(roberts_scene *scene, builder *work, uint32_t s, roberts_error *error)
{
    roberts_status status = narrow_wind(scene, &work->frame, &work->edges);
    if (status == ROBERTS_NO_MEMORY)
        return error_no_memory(error);
    if (status != ROBERTS_OK)
        return error_set(error, status, 0, "solid %u is not convex: its surface has one side only",
                         s - place_of_solid(scene, s, work->frame.mesh).solid);
    return edges_pair(scene, s, &work->edges) == EDGES_PAIRED ? ROBERTS_OK : error_no_memory(error);
}

/* Of a vertex that is no finite number. An open solid is told of when it is welded, so that what is told does not depend on
 * whether it was built or only asked. */
static build_result refuse_numbers(roberts_scene *scene, builder *work, uint32_t s, bool must_close,
                                   roberts_error *error)
{
    build_result result = must_close ? BUILD_OK : solid_is_closed(scene, work, s, error);
    if (result != BUILD_OK)
        return result;
    error_set(error, ROBERTS_BAD_NUMBER, 0, "a vertex of solid %u is not a finite number up to 1e150",
              s - place_of_solid(scene, s, work->frame.mesh).solid);
    return BUILD_REFUSED;
}

/* A face that its neighbours have turned, and that has not been mended, may be within a wide tolerance and still look away
 * from the inside: F > 0 there is promised. */
static roberts_status refuse_turned(const roberts_scene *scene, const solid_frame *frame, roberts_error *error)
{
    for (uint32_t f = 0; f < frame->face_count; f++)
        if (plane_at(frame->face[f].F, frame->barycentre) < 0.0) {
            place at = place_of_solid(scene, frame->solid, frame->mesh);
            return error_set(error, ROBERTS_NOT_CONVEX, 0,
                             "solid %u is not convex: its middle lies %.6g outside face %u", frame->solid - at.solid,
                             -plane_at(frame->face[f].F, frame->barycentre) * frame->unit,
                             scene_face_number(scene, frame->face_first + f) - at.face);
        }
    return ROBERTS_OK;
}

build_result solid_build(roberts_scene *scene, builder *work, uint32_t s, const roberts_mesh *mesh, double tolerance,
                         bool must_close, roberts_error *error)
{
    const bool sphere = edges_like_a_sphere(scene, s);
    edge_pairing pairing;
    roberts_status status = frame_enter(&work->frame, scene, s, tolerance);
    work->frame.mesh = mesh;
    if (status == ROBERTS_NO_MEMORY)
        return error_no_memory(error), BUILD_REFUSED;
    if (status != ROBERTS_OK)
        return refuse_numbers(scene, work, s, must_close, error);
    frame_fit_faces(&work->frame, scene);
    pairing = pair(scene, work, s);
    if (pairing == EDGES_NO_MEMORY)
        return error_no_memory(error), BUILD_REFUSED;
    if (pairing == EDGES_OPEN || (!must_close && !sphere))
        return BUILD_OPEN;
    if (pairing == EDGES_MIXED && wind(scene, work, s, error) != ROBERTS_OK)
        return BUILD_REFUSED;
    if (solid_check(scene, &work->frame, error) != ROBERTS_OK)
        return BUILD_REFUSED;
    if (!sphere)
        return error_set(error, ROBERTS_NOT_CONVEX, 0, "solid %u is not convex: its surface has holes",
                         s - place_of_solid(scene, s, mesh).solid),
               BUILD_REFUSED;
    if (narrow_mend(scene, &work->frame) != ROBERTS_OK)
        return error_no_memory(error), BUILD_REFUSED;
    if (pairing == EDGES_MIXED && refuse_turned(scene, &work->frame, error) != ROBERTS_OK)
        return BUILD_REFUSED;
    return BUILD_OK;
}

void builder_free(builder *work)
{
    frame_free(&work->frame);
    edge_scratch_free(&work->edges);
}
