/* solid_build.h - from faces that are laid out to solids: planes, winding, edges, checks. */
#ifndef ROBERTS_MODEL_SOLID_BUILD_H
#define ROBERTS_MODEL_SOLID_BUILD_H

#include "model/edges.h"
#include "model/solid_frame.h"

/* Scratch memory that serves solid after solid; zeroed = empty. */
typedef struct builder {
    solid_frame frame;
    edge_scratch edges;
    bool holes; /* the solid that was built or asked last is closed, but its surface has holes: no welding helps */
} builder;

typedef enum build_result {
    BUILD_OK,
    BUILD_OPEN,    /* the edges do not have two faces each, or the surface is not one closed one without holes */
    BUILD_REFUSED, /* `error` says why */
} build_result;

/* Whether solid s is closed: each edge has two faces, and corners, sides and faces number as on a sphere. BUILD_REFUSED: no
 * memory. */
build_result solid_is_closed(const roberts_scene *scene, builder *work, uint32_t s, roberts_error *error);

/* Makes solid s: planes, corners counter-clockwise from outside, its edges in work->frame.edge, and checks it. Where
 * `must_close`, a surface with holes is refused, not BUILD_OPEN. */
build_result solid_build(roberts_scene *scene, builder *work, uint32_t s, const roberts_mesh *mesh, double tolerance,
                         bool must_close, roberts_error *error);

void builder_free(builder *work);

#endif
