/* narrow_face.h - faces too narrow to tell by themselves which side is the inner one, or where their plane lies. */
#ifndef ROBERTS_MODEL_NARROW_FACE_H
#define ROBERTS_MODEL_NARROW_FACE_H

#include "model/edges.h"
#include "model/solid_frame.h"

/* Winds the faces of a solid alike, beginning from the widest, where the edges (paired, but mixed) say that the
 * barycentre has not. A face that is turned has its corners reversed and its plane too. Edges have to be paired anew
 * afterwards. Returns ROBERTS_OK, _NO_MEMORY or _NOT_CONVEX (the surface has one side only). */
roberts_status narrow_wind(roberts_scene *scene, solid_frame *frame, const edge_scratch *edges);

/* Gives each face that is marked so a plane that leans on its neighbours' instead of its own, if that one is no farther
 * than the tolerance from its corners. Returns ROBERTS_OK or _NO_MEMORY. */
roberts_status narrow_mend(roberts_scene *scene, solid_frame *frame);

#endif
