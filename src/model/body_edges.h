/* body_edges.h - the edges of bodies that are not convex: found on the surface, as sides of its pieces that coincide,
 * then stored in the scene, body by body. Also which of these bodies are curved, and whether wires lie beside convex
 * solids. */
#ifndef ROBERTS_MODEL_BODY_EDGES_H
#define ROBERTS_MODEL_BODY_EDGES_H

#include "model/surface.h"

/* ---- edges of a surface ------------------------------------------------------------------------------------------ */

/* Where a point touches a segment from A to B within the touching distance: not at all, at an end, or between the
 * ends. */
typedef enum surface_touch { TOUCHES_NOT, TOUCHES_START, TOUCHES_END, TOUCHES_BETWEEN } surface_touch;

/* *t: parameter of the point along the segment. */
surface_touch surface_touches(roberts_vec3 A, roberts_vec3 B, roberts_vec3 P, double touching, double *t);

/* Finds the edges: sides that coincide within `touching` become one edge. Frees the sides. False: no memory. */
bool surface_find_edges(surface *s, double touching);

/* An edge of more pieces counts as odd: comparing all pairs of them would take long. */
enum { SURFACE_EVEN_MOST = 16 };

/* Do the edge's pieces belong to an even number of faces? */
bool surface_is_even(const surface *s, const surface_edge *e);

/* ---- edges of bodies --------------------------------------------------------------------------------------------- */

/* The edges of a surface, body by body, sorted by their names in the file. Zeroed = empty. */
typedef struct body_edges {
    const surface *surface;
    uint32_t *order;  /* [surface.edge_count] */
    uint32_t *first;  /* [bodies + 1] into order */
    uint32_t *face;   /* [pieces] number of each piece in the scene; set by the caller before edges are stored */
    uint32_t *vertex; /* [vertices of the surface] numbers within the current body */
    size_t many_room, many_face_room, many_faces, part_room; /* sizes of the scene's arrays */
} body_edges;

/* Lists the edges. of[p] is the body of piece p; from of[pieces] on, of[] has the bodies of the odd edges in order.
 * False: no memory; body_edges_free() is still needed. */
bool body_edges_list(body_edges *list, const surface *s, const uint32_t *of, uint32_t bodies);

/* Returns the number of edges of body b. */
static inline uint32_t body_edges_count(const body_edges *list, uint32_t b)
{
    return list->first[b + 1] - list->first[b];
}

/* Stores the edges of body b, and whether it is closed. The scene is laid out, and the `number` of its vertices is
 * still that of the surface. False: no memory. */
bool body_edges_store(body_edges *list, roberts_scene *scene, uint32_t b);

void body_edges_free(body_edges *list);

/* ---- curved surfaces --------------------------------------------------------------------------------------------- */

/* How many edges of a body are bent, and how many of these only slightly. */
typedef struct bend_count {
    uint32_t much, little;
} bend_count;

/* Counts one edge with two faces. */
void bend_count_add(bend_count *count, double bend);

/* Finds whether body b is a curved surface: scene_surface.smooth, which is zeroed. counted: its edges; NULL: they are
 * counted here, by the planes of the scene. A curved surface has more than ROBERTS_FACETED_MOST faces, and at least
 * half of its bent edges are bent only slightly, or at least half of its facets are curved. Faces in one plane that
 * edges join are one facet. It is curved if at least half of its bent edges are bent only slightly. So are the walls of
 * a round extrusion, whose sharp rims outnumber all other edges. False: no memory. */
bool body_find_smooth(const roberts_scene *scene, uint32_t b, const bend_count *counted);

/* ---- wires beside convex solids ---------------------------------------------------------------------------------- */

/* Does the mesh have wires, that is, elements of two corners that are not edges of the scene? `scene` holds the convex
 * solids of the mesh; all remaining elements have one or two corners. False: no memory. */
bool body_edges_wires(const roberts_scene *scene, const roberts_mesh *mesh, bool *found);

#endif
