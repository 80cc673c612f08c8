/* solid_build.h - one solid after the other into the scene. */
#ifndef ROBERTS_MODEL_SOLID_BUILD_H
#define ROBERTS_MODEL_SOLID_BUILD_H

#include "model/components.h"
#include "model/edges.h"
#include "model/face_plane.h"
#include "model/scene.h"

/* Scratch memory that serves solid after solid; zeroed = empty. */
typedef struct builder {
    const roberts_mesh *mesh;
    const polygons *faces;
    double tolerance;
    bool topology_only;  /* an open component has been found: what follows need only be told open or closed */
    uint32_t *mark;      /* local vertex number by vertex number in the file */
    roberts_vec3 *point; /* the solid's vertices in its own frame */
    roberts_vec3 *ring;  /* the corners of one face */
    fitted_plane *plane;
    size_t mark_room, point_room, ring_room, plane_room;
    edge_scratch edges;
} builder;

typedef enum build_result { BUILD_OK, BUILD_OPEN, BUILD_REFUSED, BUILD_NO_MEMORY } build_result;

/* Appends solid number scene->solid_count of `group` to the scene, whose arrays have room. BUILD_OPEN: its edges do not
 * have two faces each, nothing is appended; BUILD_REFUSED: `error` says why. */
build_result solid_build(roberts_scene *scene, builder *work, const grouping *group, uint32_t s, roberts_error *error);

void builder_free(builder *work);

#endif
