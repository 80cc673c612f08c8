/* scene.h - bodies: the model in the form that all later stages read.
 *
 * Everything is numbered compactly and body by body: body s has the vertices solid[s].vertex .. solid[s+1].vertex - 1,
 * and likewise its faces and edges. A sentinel closes the list. `number` leads back to the input; in most files the
 * numbers are the input's own, and the array is NULL. A stored edge counts vertices and faces from its body's first.
 *
 * Convex solids satisfy these invariants. Every face has at least three different corners, counter-clockwise seen from
 * outside; its plane F has F > 0 inside. Every edge has two faces. Solids are numbered by their smallest input vertex
 * (several that share it, by their smallest face; a hull, by the smallest of all its points). A vertex that several
 * solids use is stored once for each. Vertices and faces of a solid ascend by input number. Edges ascend by (number of
 * v[0], number of v[1]), and v[0] < v[1]. A face that is narrower than the tolerance, or has no area, is wound like its
 * neighbours and may take its plane from theirs; only the corners of such a face may turn the other way about its
 * plane.
 *
 * A scene with other bodies has a scene_surface. There, a new vertex where a border crosses itself has no number
 * (ROBERTS_NONE). An edge with one face has f[1] == ROBERTS_NONE; an edge without faces has both. */
#ifndef ROBERTS_MODEL_SCENE_H
#define ROBERTS_MODEL_SCENE_H

#include <string.h>

#include "base/vec.h"
#include "base/warp.h"
#include "read/mesh.h"

/* Default tolerance: how far from planar and convex a solid may be. Published polyhedra are given to six digits. */
#define SCENE_TOLERANCE 1e-5

typedef struct scene_solid {
    uint32_t vertex, face, edge; /* the body's first of each; the next body's first ends them */
    uint32_t stored;             /* index of its edges in scene->edge */
} scene_solid;

typedef struct scene_edge {
    uint32_t v[2]; /* vertices, v[0] < v[1] */
    uint32_t f[2]; /* faces; v[0] -> v[1] runs counter-clockwise round f[0] */
} scene_edge;

/* Additional data of bodies that are not convex. Its scene faces are convex pieces of the faces of the input, which
 * scene_face_number() gives. The corners of each piece run counter-clockwise, seen from where its plane has F < 0; its
 * winding means nothing else. */
enum {
    EDGE_TURNED_0 = 1, /* face f[0] of the edge is on the right of v[0] -> v[1], not on the left */
    EDGE_TURNED_1 = 2, /* face f[1] is on the right */
    EDGE_MANY = 4,     /* it has more than two faces: see scene_many */
    EDGE_CUT = 8,      /* a cut between pieces of one non-planar face: not an edge of the file */
    EDGE_PART = 16,    /* a part of an edge of the file: see scene_part */
    EDGE_NEEDLE = 32,  /* it has two faces, and one of them is a needle: see scene_needle */
};
#define MANY_TURNED 0x80000000u /* a flag in lists of an edge's faces: the face is on the right of v[0] -> v[1] */

/* The faces of an edge with more than two: many_face[first] .. many_face[end - 1], compact numbers, possibly with
 * MANY_TURNED. */
typedef struct scene_many {
    uint32_t edge, first, end;
} scene_many;

/* An edge that is a part of an edge of the file. */
typedef struct scene_part {
    uint32_t edge, v[2]; /* v: numbers in the input, v[0] < v[1] */
    double t0, t1;       /* parameters along the edge of the file */
} scene_part;

/* A face so narrow that rounding of the coordinates has turned its plane, and the face whose plane tells more. */
typedef struct scene_needle {
    uint32_t face;     /* compact number */
    uint32_t stand_in; /* ROBERTS_NONE: none was found */
    float way;         /* 1 if both are wound alike, otherwise -1 */
    float turn;        /* scene_turn() of the face */
} scene_needle;

typedef struct scene_surface {
    uint8_t *kind;      /* [solid_count] roberts_body_kind */
    uint8_t *smooth;    /* [solid_count] 1: a curved surface, many faces that mostly meet at small angles */
    uint8_t *edge_is;   /* [edge_count] EDGE_... flags, for bodies that are not convex */
    uint8_t *bend;      /* [edge_count] see scene_bend_code(), of edges with two faces; NULL: planes are stored */
    uint32_t *plane_of; /* [face_count] see scene_plane_number(); NULL: each face has its own number */
    int32_t *winding;   /* [face_count] how often the border of its face winds round a piece, counter-clockwise as seen
                           from where F < 0; NULL: once round all */
    plane *whole;       /* [face_count] see scene_whole_plane(); NULL: every face is planar */
    scene_many *many;   /* [many_count] sorted by edge */
    uint32_t *many_face;
    scene_part *part;     /* [part_count] sorted by edge */
    scene_needle *needle; /* [needle_count] sorted by face */
    uint32_t many_count, part_count, needle_count;
} scene_surface;

/* What a camera sees of all vertices, in view units: see view_add_reach(). Each is a minimum or maximum over vertices,
 * so it does not depend on how the vertices are divided. */
typedef struct scene_reach {
    double nearest;  /* least distance from the eye's plane */
    double across;   /* greatest |x| or |y| */
    double extent;   /* greatest |x|, |y| or |z| */
    double rounding; /* greatest error of an x or y */
} scene_reach;

/* What a part of a scene needs to know about the whole. With it, the part's bodies are built and seen as they are in
 * the whole, to the last bit. */
typedef struct scene_whole {
    roberts_vec3 box_min, box_max; /* of all vertices that faces use */
    mesh_steps steps;              /* of the rounding of all coordinates */
    scene_reach reach;             /* perspective: by the camera that will see the part */
    roberts_vec2 low, high;        /* the picture's box, view units */
    uint32_t columns, rows;        /* of its covers (hide/cover.h); 0: none are kept */
    uint32_t warped;               /* 1: their axes have these warps; else 0 */
    warp warps[2];
} scene_whole;

/* Arrays that belong to the mesh while the scene is being built. */
enum { LENT_POINT = 1, LENT_FACE_START = 2, LENT_CORNER = 4 };

struct roberts_scene {
    uint32_t solid_count, vertex_count, face_count, edge_count;
    /* How many entries of `edge` are shared by several solids. They come first, pattern by pattern: once as the first
     * solid of the pattern is wound in the input, then for the reverse winding. */
    uint32_t shared;
    unsigned lent;   /* LENT_...; none once the scene is built */
    uint8_t *turned; /* [face_count] 1: corners run the other way round than in the mesh; NULL once built */
    size_t corner_count;
    scene_solid *solid;   /* [solid_count + 1] */
    roberts_vec3 *point;  /* [vertex_count] as read, so that exact arithmetic can use the original values */
    roberts_vec3 *low;    /* [vertex_count] rounding error of `point`; NULL: none */
    uint32_t *number;     /* [vertex_count] see scene_vertex_number(); NULL: numbers as in the input */
    uint32_t *face_start; /* [face_count + 1] into corner; a face has fewer than 2^32 corners in all */
    uint32_t *corner;     /* [corner_count] compact vertex numbers */
    /* NULL, all three: every face is a triangle of a body that is not convex, and its plane is computed whenever it is
     * needed. Stored, the planes of a large mesh would need more memory than anything else. See scene_plane(). */
    plane *face_plane;                        /* [face_count] for points relative to `centre` */
    float *face_deviation;                    /* [face_count] see scene_deviation() */
    float *face_width;                        /* [face_count] see scene_width() */
    uint32_t *face_number;                    /* [face_count] see scene_face_number(); NULL: numbers as in the input */
    scene_edge *edge;                         /* see scene_edge_at() */
    roberts_color *vertex_color, *face_color; /* as in the input, in compact numbering; NULL: none */
    roberts_vec3 box_min, box_max;            /* box of all vertices that faces use */
    roberts_vec3 centre;                      /* middle of that box */
    scene_surface *surface;                   /* NULL: all bodies are convex */
    mesh_steps steps;                         /* of the rounding of coordinates; zeros if it does not count */
    roberts_group *group;                     /* [group_count] as in the input; NULL: none */
    size_t group_count;
    const scene_whole *whole; /* NULL: this is all there is; else the scene is a part of it. Borrowed */
    double unit; /* a power of two, about the size of the box; unit of face_deviation, face_width and view space */
};

/* Finds the line of a segment, an edge or an intersection: its faces and its ends. `scene` and `drawing` as for
 * roberts_segment_ends(). False: there is no such line. */
bool scene_know_edge(const roberts_scene *scene, const roberts_drawing *drawing, const roberts_segment *segment,
                     roberts_known_edge *known);

/* Is the segment a part of a line where faces cross? With `--union`, such a line may have another class. */
static inline bool scene_crosses(const roberts_segment *segment)
{
    return segment->line == ROBERTS_INTERSECTION || segment->v0 == ROBERTS_NONE;
}

static inline bool scene_is_convex(const roberts_scene *scene, uint32_t s)
{
    return !scene->surface || scene->surface->kind[s] == ROBERTS_CONVEX;
}

/* Returns the entry of an edge that is EDGE_MANY. */
const scene_many *scene_many_at(const roberts_scene *scene, uint32_t edge);

/* Lists the faces of an edge, those of one or two in `room`: compact numbers and, if its body is not convex, possibly
 * with MANY_TURNED. Returns how many there are; a wire has none. */
uint32_t scene_faces_at(const roberts_scene *scene, uint32_t s, uint32_t e, uint32_t room[2], const uint32_t **face);

/* Returns the entry of an edge that is EDGE_PART. */
const scene_part *scene_part_at(const roberts_scene *scene, uint32_t edge);

/* Returns the number of the vertex in the input; for welded vertices, the smallest. */
static inline uint32_t scene_vertex_number(const roberts_scene *scene, uint32_t v)
{
    return scene->number ? scene->number[v] : v;
}

/* Returns the number of the face in the input; ROBERTS_NONE: a face of a hull. */
static inline uint32_t scene_face_number(const roberts_scene *scene, uint32_t f)
{
    return scene->face_number ? scene->face_number[f] : f;
}

/* Return the body of a face or of an edge, by bisection. */
uint32_t scene_body_of_face(const roberts_scene *scene, uint32_t face);
uint32_t scene_body_of_edge(const roberts_scene *scene, uint32_t edge);

/* Returns the number of a face's plane. Faces with equal numbers are pieces of one planar face. The scene has bodies
 * that are not convex. */
static inline uint32_t scene_plane_number(const roberts_scene *scene, uint32_t face)
{
    return scene->surface->plane_of ? scene->surface->plane_of[face] : face;
}

/* Is a piece one of several of a planar face? */
static inline bool scene_is_in_pieces(const roberts_scene *scene, uint32_t body, uint32_t piece)
{
    const uint32_t *of = scene_is_convex(scene, body) ? NULL : scene->surface->plane_of;
    const scene_solid *own = &scene->solid[body];
    return of && ((piece > own->face && of[piece - 1] == of[piece]) ||
                  (piece + 1 < own[1].face && of[piece + 1] == of[piece]));
}

/* Returns the first of the equal numbers up to `at`, which follow one another; none before `least` counts. */
uint32_t scene_first_alike(const uint32_t *number, uint32_t at, uint32_t least);

/* Return the first piece of the planar face that a piece belongs to, and the piece after its last one. */
uint32_t scene_first_piece(const roberts_scene *scene, uint32_t body, uint32_t piece);
uint32_t scene_end_of_pieces(const roberts_scene *scene, uint32_t body, uint32_t piece);

/* Returns edge e of solid s as it is stored: vertices and faces count from the solid's first. */
static inline const scene_edge *scene_edge_stored(const roberts_scene *scene, uint32_t s, uint32_t e)
{
    return scene->edge + scene->solid[s].stored + (e - scene->solid[s].edge);
}

/* Returns edge e of solid s with compact numbers. */
static inline scene_edge scene_edge_at(const roberts_scene *scene, uint32_t s, uint32_t e)
{
    const scene_solid *solid = scene->solid + s;
    const scene_edge *edge = scene_edge_stored(scene, s, e);
    return (scene_edge){{edge->v[0] + solid->vertex, edge->v[1] + solid->vertex},
                        {edge->f[0] + solid->face, edge->f[1] + solid->face}};
}

/* The plane of a face, the greatest distance of a corner from it, and the width of the face: its area divided by its
 * greatest chord, which is between half of its least width and all of it. Both are in model units, and both are bounds:
 * the deviation is rounded up to a float and the width down (to 1e-45 of the scene's size). */
typedef struct scene_shape {
    plane F; /* for points relative to scene->centre */
    double deviation, width;
} scene_shape;

/* Measures a triangle of a body that is not convex, as it was measured when the scene was built, bit for bit. (In
 * plain_bodies.c.) */
scene_shape scene_measure(const roberts_scene *scene, uint32_t face);

static inline scene_shape scene_shape_of(const roberts_scene *scene, uint32_t face)
{
    if (!scene->face_plane)
        return scene_measure(scene, face);
    return (scene_shape){scene->face_plane[face], scene->unit * (double)scene->face_deviation[face],
                         scene->unit * (double)scene->face_width[face]};
}

static inline plane scene_plane(const roberts_scene *scene, uint32_t face)
{
    return scene->face_plane ? scene->face_plane[face] : scene_measure(scene, face).F;
}

/* Is there a face that is not planar? */
static inline bool scene_has_bent_faces(const roberts_scene *scene)
{
    return scene->surface && scene->surface->whole;
}

/* Returns the plane of the whole face that a piece belongs to. A face that is not planar is cut into triangles, each
 * with a plane of its own. Its tone, and the angle at which it meets another face, follow from the mean of these
 * planes. */
static inline plane scene_whole_plane(const roberts_scene *scene, uint32_t piece)
{
    return scene_has_bent_faces(scene) ? scene->surface->whole[piece] : scene_plane(scene, piece);
}

static inline double scene_deviation(const roberts_scene *scene, uint32_t face)
{
    return scene_shape_of(scene, face).deviation;
}

static inline double scene_width(const roberts_scene *scene, uint32_t face)
{
    return scene_shape_of(scene, face).width;
}

/* Returns the squared distance of two unit normals; the second one is multiplied by `way`. */
static inline double scene_chord(plane F, plane G, double way)
{
    double a = F.a - way * G.a, b = F.b - way * G.b, c = F.c - way * G.c;
    return a * a + b * b + c * c;
}

/* Returns 1 if the two faces of an edge are wound alike, otherwise -1. is: the edge's flags. */
static inline double scene_way(uint8_t is)
{
    return ((is & EDGE_TURNED_0) != 0) == ((is & EDGE_TURNED_1) != 0) ? -1.0 : 1.0;
}

/* Returns the bend at an edge with two faces: that distance, as if both faces were wound alike. is: its flags. */
static inline double scene_bend(plane F, plane G, uint8_t is)
{
    return scene_chord(F, G, scene_way(is));
}

/* Returns the step of the rounding of coordinates, to 32-bit floats or to few digits; model units, see mesh_steps. 0:
 * they were not rounded. */
static inline double scene_step(const roberts_scene *scene)
{
    return greater(scene->steps.float32, scene->steps.decimal);
}

/* Coordinates that were rounded turn the plane of a narrow face. This is the most by which that may bend an edge, as a
 * distance of unit normals; beyond it, an edge is an edge. */
#define SCENE_ROUNDED_BEND 0.125

/* A face that rounding may have turned by this much is a needle; it is a quarter of a degree. */
#define SCENE_NEEDLE_TURN 0x1p-8

/* Returns how far rounding may have turned the plane of a face, as a distance of unit normals. It moves a corner by at
 * most sqrt(3)/4 of a step. So it turns a plane by at most twice that over the least width of the face, of a triangle
 * half of that over scene_width(). */
static inline double scene_turn(const roberts_scene *scene, uint32_t face)
{
    return 0.5 * scene_step(scene) / scene_width(scene, face);
}

/* Returns the squared distance of unit normals below which two faces are flat with one another: `crease`, or more if
 * coordinates were rounded. crease: 0: none are flat. */
static inline double scene_flat_below(const roberts_scene *scene, uint32_t f, uint32_t g, double crease)
{
    if (!(scene_step(scene) > 0.0 && crease > 0.0))
        return crease;
    const double bend = scene_turn(scene, f) + scene_turn(scene, g);
    const double chord = sqrt(crease) + lesser(bend, SCENE_ROUNDED_BEND);
    return chord * chord;
}

/* Returns a bend as a byte that ascends with it: its binary exponent and two digits more. Most bends differ so much
 * from a crease angle that the byte decides which is greater. */
static inline uint8_t scene_bend_code(double bend)
{
    float rounded = (float)bend;
    uint32_t bits, least = 66u << 2, most = least + UINT8_MAX; /* 2^-61 and below: 0 */
    memcpy(&bits, &rounded, sizeof bits);
    bits >>= 21;
    return (uint8_t)((bits < least ? least : bits > most ? most : bits) - least);
}

/* Factors that outweigh the rounding to float. */
#define SCENE_UPWARD (1.0 + 0x1p-23)
#define SCENE_DOWNWARD (1.0 - 0x1p-23)

static inline void scene_set_bounds(roberts_scene *scene, uint32_t face, double deviation, double width)
{
    scene->face_deviation[face] = (float)(deviation / scene->unit * SCENE_UPWARD);
    scene->face_width[face] = (float)(width / scene->unit * SCENE_DOWNWARD);
}

/* Returns the number of corners of the faces of solid s; in a closed solid, twice the number of edges. */
static inline uint32_t scene_corners(const roberts_scene *scene, uint32_t s)
{
    return scene->face_start[scene->solid[s + 1].face] - scene->face_start[scene->solid[s].face];
}

/* ---- faces with every corner once ------------------------------------------------------------------------------ */

/* Faces, numbered as in the mesh. The arrays belong to the mesh until the faces are cleaned. */
typedef struct polygons {
    uint32_t face_count, vertex_count;
    const uint32_t *start;            /* [face_count + 1] into corner */
    const uint32_t *corner;           /* vertex numbers of the mesh */
    uint32_t *own_start, *own_corner; /* arrays that polygons_free() releases */
    size_t repeated;                  /* number of corners left out by cleaning */
} polygons;

/* Takes the faces unchanged from the mesh. Returns ROBERTS_OK or _NO_MEMORY (more than 32 bits can count). */
roberts_status polygons_of_mesh(polygons *faces, const roberts_mesh *mesh, roberts_error *error);

/* Replaces each vertex number v by name[v] (NULL: no change) and leaves out the corners that then repeat an earlier one
 * of their face. False: no memory; nothing has changed. */
bool polygons_clean(polygons *faces, const uint32_t *name);

void polygons_free(polygons *faces);

static inline uint32_t polygon_size(const polygons *faces, uint32_t f)
{
    return faces->start[f + 1] - faces->start[f];
}

/* ---- the arrays ------------------------------------------------------------------------------------------------ */

/* Which of a scene's vertices and faces have the same numbers as in the mesh. */
typedef struct kept_numbers {
    bool vertices, faces;
} kept_numbers;

/* Allocates the arrays that the scene does not have yet, by its counts of solids, vertices, faces and corners. Numbers
 * that are kept need no array; edges come later. False: no memory; then call roberts_scene_free(). */
bool scene_alloc_arrays(roberts_scene *scene, kept_numbers kept);

/* The same as roberts_scene_take() for a mesh that is a part of a whole, which the scene borrows. (In build.c.) */
roberts_status scene_take_part(roberts_mesh *mesh, const roberts_scene_options *options, const scene_whole *whole,
                               roberts_scene **scene, roberts_error *error);

/* Sets the scene's box, its centre and its unit. A part of a scene has those of the whole. */
void scene_set_box(roberts_scene *scene, roberts_vec3 lo, roberts_vec3 hi);

/* Reverses the corners of face f; the first one keeps its place. */
void scene_turn_face(roberts_scene *scene, uint32_t f);

/* Restores the order of corners in an array that the mesh has lent. */
void scene_turn_back(roberts_scene *scene);

/* Frees all arrays and leaves an empty scene. Lent arrays are not freed, but left as the mesh had them. */
void scene_clear(roberts_scene *scene);

/* Copies the corners of all faces listed in scene->face_number. They remain vertex numbers of the mesh. */
void scene_copy_corners(roberts_scene *scene, const polygons *faces);

/* Allocates the scene's arrays and fills them with solids 0 .. solid_count - 1. Face f belongs to solid of[f]
 * (ROBERTS_NONE: to none). A vertex used by several solids is copied for each. As after components_lay_out(), there are
 * no planes and no edges, and corners are in the order of the file. False: no memory, or too many vertices for 32
 * bits. */
bool scene_lay_out(roberts_scene *scene, const polygons *faces, const uint32_t *of, uint32_t solid_count,
                   const roberts_vec3 *point);

/* ---- files ------------------------------------------------------------------------------------------------------- */

/* Messages name the input file that a solid comes from, and number solids, faces and vertices within it. */

typedef struct solid_source {
    const char *file;             /* "": it has no name, or the solid comes from several files */
    uint32_t solid, face, vertex; /* the file's first of each, to be subtracted from numbers over all files */
} solid_source;

/* Faces that a warning counts; `first` and `last` as numbered in the mesh. */
typedef struct noted_faces {
    size_t count;
    uint32_t first, last;
} noted_faces;

/* Returns the name of the file that has them all, or "". */
const char *source_of_noted(const roberts_mesh *mesh, noted_faces faces);

/* Returns the file that contains all of vertices v_least .. v_most and faces f_least .. f_most, numbered as in the
 * mesh; `solid` is 0. */
solid_source source_find(const roberts_mesh *mesh, uint32_t v_least, uint32_t v_most, uint32_t f_least,
                         uint32_t f_most);

/* Returns the file of solid s, which is laid out. */
solid_source source_of_solid(const roberts_scene *scene, uint32_t s, const roberts_mesh *mesh);

/* Returns the file of solid s by its vertices alone, for a solid whose faces are not in the file. */
solid_source source_of_points(const roberts_scene *scene, uint32_t s, const roberts_mesh *mesh);

#endif
