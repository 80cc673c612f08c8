/* solid.h - one solid: its frame, planes, winding, edges and checks. */
#ifndef ROBERTS_MODEL_SOLID_H
#define ROBERTS_MODEL_SOLID_H

#include "model/scene.h"

/* ---- edges, and the two faces of each ---------------------------------------------------------------------------- */

enum { EDGES_SMALL = 32 }; /* vertices; up to this many, a solid's half-edges are looked up in a table */

/* Scratch memory, reused for solid after solid; zeroed = empty. */
typedef struct edge_scratch {
    scene_edge *edge;  /* [corners / 2] the result of edges_pair() */
    uint32_t *end;     /* [vertices] where the half-edges of each smaller vertex end in `half` */
    uint64_t *half;    /* [corners] sorted half-edges: larger vertex << 32 | corner where it starts */
    uint32_t *face_of; /* [corners] */
    uint8_t *alike;    /* [corners / 2] whether the two faces of each edge pass it in the same direction */
    size_t edge_room, end_room, half_room, face_of_room, alike_room;
    uint32_t passing[EDGES_SMALL][EDGES_SMALL]; /* the face that passes from the first vertex to the second */
} edge_scratch;

typedef enum edge_pairing {
    EDGES_PAIRED, /* each edge has two faces, which pass it in opposite directions */
    EDGES_MIXED,  /* each edge has two faces, but some pairs pass it in the same direction: see scratch->alike */
    EDGES_EVEN,   /* each edge has an even number of faces, and some have more than two */
    EDGES_OPEN,   /* some edge has an odd number of faces */
    EDGES_NO_MEMORY,
} edge_pairing;

/* Euler's V - E + F, if each edge of solid s has two faces. It is 2 for a closed surface like a sphere, less if the
 * surface has holes, and more if parts share vertices. */
static inline int64_t edges_euler(const roberts_scene *scene, uint32_t s)
{
    const scene_solid *first = scene->solid + s;
    int64_t vertices = first[1].vertex - first->vertex, faces = first[1].face - first->face;
    return vertices - (int64_t)(scene_corners(scene, s) / 2) + faces;
}

/* Writes the edges of solid s to scratch->edge, sorted, in the form that a scene stores. Their number is half the
 * number of corners. If some edge does not have two faces, scratch->edge is undefined. */
edge_pairing edges_pair(const roberts_scene *scene, uint32_t s, edge_scratch *scratch);

/* Sorts the half-edges of solid s into scratch->half by (smaller vertex, larger vertex, corner). Vertices and corners
 * count from the solid's first. Also fills scratch->end and ->face_of. False: no memory. */
bool edges_sort(const roberts_scene *scene, uint32_t s, edge_scratch *scratch);

void edge_scratch_free(edge_scratch *scratch);

/* ---- a frame of its own ---------------------------------------------------------------------------------------- */

/* A face in its solid's frame. */
typedef struct local_face {
    plane F;            /* inward; 0,0,0,0 if the face has no area */
    double depth;       /* F at the barycentre, >= 0 */
    double deviation;   /* greatest distance of a corner from the plane */
    double area, width; /* width: area divided by greatest chord */
    bool strict;        /* strictly convex as a polygon, decided without a tolerance */
    bool lean; /* it takes its plane from its neighbours, because its own is not good enough or it has no area */
} local_face;

/* One solid in a frame of its own: the first vertex is the origin, and a very large or very small solid is scaled by a
 * power of two. The arrays are reused for solid after solid. Zeroed = empty. */
typedef struct solid_frame {
    uint32_t solid;           /* its number */
    const roberts_mesh *mesh; /* for messages */
    uint32_t vertex_first, vertex_count, face_first, face_count;
    roberts_vec3 *point;    /* [vertex_count] */
    local_face *face;       /* [face_count] */
    const scene_edge *edge; /* [edge_count] as a scene stores them; set when they are paired */
    uint32_t edge_count;
    roberts_vec3 *ring;      /* room for the corners of any one face */
    uint32_t turned;         /* number of faces that are clockwise in the input, seen from outside */
    uint32_t widest;         /* the face with the greatest width */
    bool any_lean;           /* some face is `lean` */
    bool any_doubt;          /* some face is not strictly convex, or not planar within the tolerance */
    bool any_shallow;        /* the barycentre is closer than `flat` to some face */
    roberts_vec3 barycentre; /* the mean of the vertices, which is inside a convex solid */
    double unit;             /* model units per unit of this frame */
    double scene_units;      /* the scene's units (of deviation and width) per unit of this frame */
    double size;             /* diagonal of the box */
    double allowed;          /* the tolerance as a length */
    double loose, loose32;   /* the same if coordinates are rounded: see frame_loosen() */
    double flat;             /* a solid thinner than this is flat */
    size_t point_room, face_room, ring_room;
} solid_frame;

/* Enters solid s: makes room, moves and scales its vertices, and measures it. Leaves frame->face unset. Returns
 * ROBERTS_OK, _NO_MEMORY or _BAD_NUMBER (a coordinate is not finite or exceeds 1e150). */
roberts_status frame_enter(solid_frame *frame, const roberts_scene *scene, uint32_t s, double tolerance);

/* How many sizes from the origin a solid may be for the rounding of its coordinates to count in full. */
#define FRAME_FAR 100.0

/* The tolerance as a length, for a solid whose coordinates are rounded. largest: its largest coordinate. */
static inline double frame_loose(double tolerance, double largest, double size)
{
    return tolerance * greater(size, lesser(largest, FRAME_FAR * size));
}

/* If the solid lies far from the origin, allows `loose` if all coordinates have six digits at most, `loose32` if they
 * are those of float32: then each may be off by a part of itself. False: nothing has changed. */
bool frame_loosen(solid_frame *frame, const roberts_scene *scene);

/* Copies the corners of face f (relative to the solid's first face) to frame->ring, relative to the first corner.
 * Returns their number. */
uint32_t frame_ring(const solid_frame *frame, const roberts_scene *scene, uint32_t f);

/* Returns the first corner of face f. */
static inline roberts_vec3 frame_origin(const solid_frame *frame, const roberts_scene *scene, uint32_t f)
{
    return frame->point[scene->corner[scene->face_start[frame->face_first + f]] - frame->vertex_first];
}

void frame_free(solid_frame *frame);

/* ---- one solid ------------------------------------------------------------------------------------------------- */

/* Turns the faces of a component into a solid: planes, winding, edges, checks. */

/* Why a component is not closed like a sphere. */
typedef enum opening {
    OPENING_NONE,
    OPENING_EDGES, /* some edge has an odd number of faces: welding and splitting may help */
    OPENING_PARTS, /* each edge has an even number, but parts share edges or vertices: splitting may help */
    OPENING_HOLES  /* each edge has two faces, but the surface has holes: neither helps */
} opening;

/* Scratch memory, reused for solid after solid; zeroed = empty. */
typedef struct builder {
    solid_frame frame;
    edge_scratch edges;
    opening opening; /* of the last solid */
} builder;

typedef enum build_result {
    BUILD_OK,
    BUILD_OPEN,    /* some edge does not have two faces, or the surface has holes or is disconnected */
    BUILD_REFUSED, /* `error` has the reason */
} build_result;

/* Is solid s closed? If so, each edge has two faces, and V - E + F = 2. BUILD_REFUSED: no memory. */
build_result solid_is_closed(const roberts_scene *scene, builder *work, uint32_t s, roberts_error *error);

/* The requirements for a solid. */
typedef struct solid_rules {
    const roberts_mesh *mesh; /* for messages */
    double tolerance;         /* how far from planar and convex it may be, as a fraction of its size */
    bool must_close;          /* refuse a closed surface with holes; otherwise the result is BUILD_OPEN */
} solid_rules;

/* Makes solid s: fits planes, orients corners counter-clockwise from outside, leaves its edges in work->frame.edge, and
 * checks it. */
build_result solid_build(roberts_scene *scene, builder *work, uint32_t s, const solid_rules *rules,
                         roberts_error *error);

void builder_free(builder *work);

#endif
