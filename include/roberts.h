/* roberts.h - turns polyhedra into line drawings, with the hidden lines removed in object space.
 *
 * The way through the library:
 *
 *   roberts_mesh     polygons as a file or a program gives them       roberts_mesh_read_file(), roberts_mesh_read()
 *   roberts_scene    bodies: convex solids, and bodies of any shape   roberts_scene_build()
 *   roberts_camera   where the viewer stands                          roberts_camera_preset()
 *   roberts_drawing  visible and hidden segments of every edge        roberts_hide()
 *   a file           SVG, CSV, ...                                    roberts_drawing_save(), roberts_drawing_write()
 *
 * Source of the method: L. G. Roberts, "Machine perception of three-dimensional solids", MIT 1963, in the form of the
 * lecture "Elimination des lignes cachees" (convex polyhedra, inward normals, four tests, grid Objet[i][j]).
 *
 * Every function that can fail returns a roberts_status, and fills `error` unless that is NULL. Nothing here prints,
 * exits or keeps global state; no result depends on the locale. A zeroed struct is a valid empty one, and every
 * *_free() takes an empty one and NULL. A result (a drawing, regions, what is picked) is overwritten: what it held
 * before is not released. */
#ifndef ROBERTS_H
#define ROBERTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The version of this header. Structs may differ between versions below 1.0 whose second number differs. */
#define ROBERTS_VERSION "0.1.0"

/** The version of the library that the program runs with. */
const char *roberts_version(void);

/* ---- values -------------------------------------------------------------------------------------------------- */

typedef struct roberts_vec2 {
    double x, y;
} roberts_vec2; /**< a point of the picture plane, y up */
typedef struct roberts_vec3 {
    double x, y, z;
} roberts_vec3; /**< a point or a free vector, model units */

/** No vertex, face, edge or solid. */
#define ROBERTS_NONE UINT32_MAX

/** The most threads, and the most cells per side of the grid, that options may ask for. */
#define ROBERTS_THREADS_MOST 1024
#define ROBERTS_GRID_MOST 4096

typedef enum roberts_status {
    ROBERTS_OK,
    ROBERTS_NO_MEMORY,    /**< an allocation failed */
    ROBERTS_IO,           /**< reading or writing failed; the message holds the system's reason */
    ROBERTS_BAD_SYNTAX,   /**< the input is in no known format, or breaks the rules of its format */
    ROBERTS_BAD_INDEX,    /**< a face names a vertex that is not there */
    ROBERTS_BAD_NUMBER,   /**< a coordinate is infinite, not a number, or too large to compute with */
    ROBERTS_NOT_CLOSED,   /**< an edge of a component is not shared by exactly two faces */
    ROBERTS_NOT_PLANAR,   /**< the corners of a face do not lie in one plane, within the tolerance */
    ROBERTS_NOT_CONVEX,   /**< a face or a solid is not convex, within the tolerance */
    ROBERTS_FLAT,         /**< a component is closed but encloses no volume */
    ROBERTS_BAD_VIEW,     /**< the camera cannot see the scene: zero direction, scene not in front of the eye, ... */
    ROBERTS_BAD_ARGUMENT, /**< an option is out of its range */
    ROBERTS_STOPPED,      /**< a callback asked to stop */
} roberts_status;

/** What went wrong and where. Plain data: nothing to free. */
typedef struct roberts_error {
    roberts_status status;
    char file[256];    /**< name of the input or output concerned, shortened where longer; empty if none */
    size_t line;       /**< 1-based line of the input, 0 if none applies */
    char message[256]; /**< e.g. "face 7 names vertex 9, but there are 8"; no file, no line, no newline */
} roberts_error;

/** Receives one warning. Warnings of one kind are merged into one, with their count ("2 colours that make no sense
 * ignored"). file: as in roberts_error; line: 0 if none applies; message: no newline, valid during the call only. */
typedef void roberts_warning_fn(void *context, const char *file, size_t line, const char *message);

/** Where warnings go. A NULL function drops them. */
typedef struct roberts_warnings {
    roberts_warning_fn *warn;
    void *context;
} roberts_warnings;

/* ---- mesh: polygons as they come ------------------------------------------------------------------------------ */

/** A colour as the file gives it. count 0: none; 1: value[0] is an index into a colour map; 3 or 4: red, green, blue
 * (and alpha), each in 0..1 (integers 0..255 of the file are divided by 255). */
typedef struct roberts_color {
    unsigned char count;
    float value[4];
} roberts_color;

/** One input that went into a mesh: its vertices and faces follow those of the inputs before it. */
typedef struct roberts_source {
    char *name; /**< owned by the mesh */
    uint32_t first_vertex, first_face;
    bool float32;  /**< its coordinates are 32-bit floats, so each is off by up to half a unit in the last place */
    char *missing; /**< owned by the mesh: the first .mtl file that an OBJ names and that is not there, so that colours
                        are missing; NULL: none */
} roberts_source;

/** Faces that share a name in the input (o or g of OBJ, solid of STL): from first_face up to the first_face of the next
 * group. Several groups may have the same name. */
typedef struct roberts_group {
    char *name; /**< owned by the mesh; "": none */
    uint32_t first_face;
} roberts_group;

/** Polygons over shared vertices, in the order of the input. Faces may have any number of corners (also 1 and 2) and
 * any winding. Fill it with roberts_mesh_read*() or roberts_mesh_add_*(); release it with roberts_mesh_free(). You may
 * read all arrays; only the functions below may change them. For arrays of your own see roberts_mesh_check(). */
typedef struct roberts_mesh {
    size_t vertex_count, face_count, corner_count, source_count, group_count;
    roberts_vec3 *vertex;        /**< [vertex_count] */
    uint32_t *face_start;        /**< [face_count + 1] face f has corners corner[face_start[f]] .. [face_start[f+1]-1];
                                      NULL while there is no face */
    uint32_t *corner;            /**< [corner_count] vertex numbers, counted over all inputs */
    roberts_color *vertex_color; /**< [vertex_count], or NULL where no vertex has a colour */
    roberts_color *face_color;   /**< [face_count], or NULL where no face has a colour */
    roberts_source *source;      /**< [source_count] */
    roberts_group *group;        /**< [group_count] first_face ascends; NULL where no input has groups */
    size_t vertex_room, face_room, corner_room, vertex_color_room, face_color_room, source_room,
        group_room;   /**< private */
    uint32_t threads; /**< set it before reading: most threads for a large file, 0 = one per processor; the result does
                           not depend on it */
} roberts_mesh;

/** Puts up to `size` bytes into `buffer`. Returns how many, 0 at the end of the input, -1 on failure (errno set). */
typedef ptrdiff_t roberts_read_fn(void *context, void *buffer, size_t size);

/**
 * Reads one file in OFF, STL, OBJ or PLY, text or binary, and appends its polygons to `mesh`. The content decides the
 * format, not the name. Vertices are numbered from 0 in all formats, and on from those already in `mesh`. Corners of
 * STL with equal positions become one vertex within each of its solids.
 * name      what messages call the input; copied. NULL: it has no name
 * read      called until it returns 0 or the last declared element is read; it is asked for whole blocks, so bytes
 *           behind that element may be consumed
 * context   handed to `read`
 * warnings  NULL: none wanted
 * On failure `mesh` is as it was before the call.
 * Returns ROBERTS_OK, _NO_MEMORY, _IO, _BAD_SYNTAX, _BAD_INDEX or _BAD_NUMBER (a coordinate beyond 1e150).
 * Sources: the OFF format of Geomview, with the dialects of qhull, Antiprism, OpenSCAD, ModelNet and trimesh; for the
 * others see src/read/README.md.
 */
roberts_status roberts_mesh_read(roberts_mesh *mesh, const char *name, roberts_read_fn *read, void *context,
                                 const roberts_warnings *warnings, roberts_error *error);

/** The same from a file; "-" is standard input. Pipes are read to their end, or to 1 GiB behind the last element, so
 * that their writers can end well. Colours of an OBJ come from the .mtl files beside it, if they exist. */
roberts_status roberts_mesh_read_file(roberts_mesh *mesh, const char *path, const roberts_warnings *warnings,
                                      roberts_error *error);

/** The same from `size` bytes in memory, which are only read. */
roberts_status roberts_mesh_read_memory(roberts_mesh *mesh, const char *name, const void *bytes, size_t size,
                                        const roberts_warnings *warnings, roberts_error *error);

/** Appends a vertex; `index`, unless NULL, receives its number. Returns ROBERTS_OK, _NO_MEMORY or _BAD_NUMBER. */
roberts_status roberts_mesh_add_vertex(roberts_mesh *mesh, roberts_vec3 position, uint32_t *index,
                                       roberts_error *error);

/** Appends a face of `count` corners, in order around it, in either direction. Returns ROBERTS_OK, _NO_MEMORY or
 * _BAD_INDEX. */
roberts_status roberts_mesh_add_face(roberts_mesh *mesh, const uint32_t *corners, size_t count, roberts_error *error);

/** Stands a mesh up whose y axis points up: each vertex x, y, z becomes x, -z, y. The library takes z to point up. */
void roberts_mesh_stand_up(roberts_mesh *mesh);

/**
 * Checks a mesh that you have filled yourself: set the counts, point the pointers to your own arrays, and leave the
 * rest 0 or NULL. roberts_scene_build() then reads the arrays in place, without a copy. You keep them: pass this mesh
 * to no other function; nothing of it is released.
 * Returns ROBERTS_OK, _BAD_NUMBER (a coordinate), _BAD_INDEX (a corner) or _BAD_ARGUMENT (face_start or a count is
 * wrong, an array with a count is NULL, or there are groups or sources, which such a mesh cannot have).
 */
roberts_status roberts_mesh_check(const roberts_mesh *mesh, roberts_error *error);

/** Returns two units of the last place of decimal coordinates, model units: how near to one another things count as
 * touching with roberts_scene_options.rounded. 0: they have many digits, and are no 32-bit floats. */
double roberts_mesh_step(const roberts_mesh *mesh);

/** Releases everything and leaves an empty mesh. */
void roberts_mesh_free(roberts_mesh *mesh);

/* ---- scene: bodies --------------------------------------------------------------------------------------------- */

/** Bodies with their face planes and edges, and the faces of each edge. Opaque; read-only once built, so any number of
 * threads may use it. */
typedef struct roberts_scene roberts_scene;

typedef struct roberts_scene_options {
    /** How far a corner may lie outside a face or beside its plane, as a part of the solid's size (the diagonal of its
     * box); 0 = 1e-5. If all coordinates of a solid have at most six digits, or are 32-bit floats, it is a part of
     * the largest of them instead, up to a hundred sizes. */
    double tolerance;
    bool hull; /**< solids that would be refused, and inputs of points without faces, become their convex hulls */
    roberts_warnings warnings;
    uint32_t threads; /**< 0 = one per processor; the result does not depend on it */
    bool solids;      /**< refuse what is no convex solid (unless `hull` replaces it) */
    /** Which points belong to a face whose border crosses itself: those that the border winds round an odd number of
     * times (true), or any number of times but 0 (false). */
    bool even_odd;
    /** Decimal coordinates were rounded: what touches to within two units of their last place touches. Without this,
     * decimals are taken as they are. The digits count if all coordinates of an input have at most nine (whole numbers
     * and fractions like 0.375, which doubles hold exactly, aside) and two units are at most 1e-4 of its size. The last
     * place is that of the last digit, or of a 32-bit float if all coordinates are printed floats and that is coarser.
     * More digits count only if all coordinates are 32-bit floats to the last bit. */
    bool rounded;
} roberts_scene_options;

/**
 * Finds the bodies of `mesh`: convex solids, closed bodies of any shape, and open ones. A face may have any shape:
 * src/model/README.md has the rules. Winding is not trusted. Components that are open are welded with one another where
 * positions are exactly equal.
 *
 * A convex solid is closed, planar, convex and not flat, within the tolerance. With options->solids, anything else is
 * refused. Faces joined by shared edges are one solid, or several if four or more of them meet in an edge. Corners that
 * repeat another corner of their face are ignored with a warning. So are faces that then have fewer than three corners.
 *
 * With options->hull, convex hulls (by Qhull) replace whatever would be refused:
 * - a closed component that is no convex solid, by its hull;
 * - open components, after welding: those that share vertices together become one hull; closed solids are split off
 *   first;
 * - an input without a face of three corners, by the hull of all its points.
 * A hull's vertices are vertices of the input; its faces are new (ROBERTS_NONE, without colours). Points that lie
 * outside a face by less than the tolerance, or 1e-5 of the size, may be left out. Solids are still numbered by their
 * smallest vertex, even if their hull leaves it out. Points in one plane have no hull: they are left out with a
 * warning, even if they are a whole input, and refused if there is nothing else. A warning counts the replaced solids
 * of each input, and says why. It does not count points without faces, since only their hull can be meant.
 * mesh     only read, and not needed afterwards
 * options  NULL for the defaults
 * scene    owned by the caller, released by roberts_scene_free(); NULL on failure
 * Returns ROBERTS_OK, _NO_MEMORY, _NOT_CLOSED (there is nothing to draw), _BAD_NUMBER or _BAD_ARGUMENT; for arrays of
 * your own that roberts_mesh_check() would refuse also _BAD_INDEX; with options->solids also _NOT_CLOSED, _NOT_PLANAR,
 * _NOT_CONVEX and _FLAT; with hulls _FLAT if there is nothing else. The message names the solid, the vertex or the
 * face, and the amount by which it fails. Its numbers count from 0 in the file that error->file names, or in the whole
 * mesh where it names none (a solid made of several files).
 */
roberts_status roberts_scene_build(const roberts_mesh *mesh, const roberts_scene_options *options,
                                   roberts_scene **scene, roberts_error *error);

/** The same, but reuses the memory of `mesh` where it can: a million solids take 300 MB less. Afterwards `mesh` is
 * empty; on failure it is as it was. */
roberts_status roberts_scene_take(roberts_mesh *mesh, const roberts_scene_options *options, roberts_scene **scene,
                                  roberts_error *error);
void roberts_scene_free(roberts_scene *scene);

/**
 * The tolerance that would accept a mesh that roberts_scene_build() has refused as not planar or not convex: the
 * smallest 1, 2 or 5 times a power of ten that suffices for all solids together. Returns 0 if none suffices up to
 * 0.01, or up to the limit beyond which any shape would pass: 0.025 / sqrt(faces of a solid), and less for a solid
 * whose distance from the origin exceeds its size. Just below that limit the tolerance may have another first digit
 * (0.007 for twelve faces). The search builds the scene several times; with more than 200,000 faces it is not tried,
 * and 0 is returned.
 * options  as given to roberts_scene_build(); `hull` and `warnings` are not used
 */
double roberts_scene_tolerance(const roberts_mesh *mesh, const roberts_scene_options *options);

/** The numbers of bodies and of their vertices, faces (of three corners or more) and edges, with hulls as new faces and
 * edges. A vertex that several bodies use counts once for each. */
size_t roberts_scene_solid_count(const roberts_scene *scene);
size_t roberts_scene_vertex_count(const roberts_scene *scene);
size_t roberts_scene_face_count(const roberts_scene *scene);
size_t roberts_scene_edge_count(const roberts_scene *scene);
/** The number of convex pieces into which these faces are cut: that of the faces, if all are planar and convex. */
size_t roberts_scene_piece_count(const roberts_scene *scene);

/** What a body is. */
typedef enum roberts_body_kind {
    ROBERTS_CONVEX, /**< a closed convex solid */
    ROBERTS_CLOSED, /**< each edge has two faces, or another even number of them */
    ROBERTS_OPEN,   /**< anything else: sheets, loose faces, wires, edges of one face or another odd number of them */
} roberts_body_kind;

/** The kind of a body; ROBERTS_OPEN if no body has that number. */
roberts_body_kind roberts_scene_body_kind(const roberts_scene *scene, uint32_t body);

/** The number of a body's faces; of a body that is not convex, of their convex pieces. 0: no body has that number. */
uint32_t roberts_scene_body_face_count(const roberts_scene *scene, uint32_t body);

/** A body of no more faces is not curved. */
#define ROBERTS_FACETED_MOST 500

/** Whether a body counts as curved: it is not convex, has more than ROBERTS_FACETED_MOST faces, and at least half of
 * its edges that are not flat bend by less than 20 degrees. It is also curved if at least half of its facets have at
 * least half such edges, as the walls of a round extrusion have. A facet is all faces in one plane that edges join. See
 * roberts_hide_options.crease_auto. */
bool roberts_scene_body_curved(const roberts_scene *scene, uint32_t body);

/** The name of the group that the solid's first face is in (o or g of OBJ, solid of STL); "" if it has none. Valid
 * until the scene is freed. */
const char *roberts_scene_name(const roberts_scene *scene, uint32_t solid);

/** Finds the vertex with this number in the input. False: no face has it; of vertices at one place, as in STL, only the
 * smallest number counts. The time is linear in the number of vertices. */
bool roberts_scene_vertex(const roberts_scene *scene, uint32_t number, roberts_vec3 *point);

/** Whether this solid is a convex hull that replaces part of the mesh; false if no solid has that number. */
bool roberts_scene_is_hull(const roberts_scene *scene, uint32_t solid);

/* ---- camera ---------------------------------------------------------------------------------------------------- */

typedef enum roberts_projection { ROBERTS_ORTHOGRAPHIC, ROBERTS_PERSPECTIVE } roberts_projection;

/** A viewpoint. Start from roberts_camera_preset() or from a zeroed struct and set what you need. */
typedef struct roberts_camera {
    roberts_projection projection;
    roberts_vec3 dir;     /**< orthographic: from the scene toward the viewer, any length but 0 */
    roberts_vec3 eye;     /**< perspective: where the eye is */
    roberts_vec3 look_at; /**< perspective: the point in the middle of the picture */
    bool has_look_at;     /**< false: look at the centre of the scene's box */
    /** What points up in the drawing; 0,0,0 = +z. If `up` is parallel to the view, +z replaces it, and +y if +z is
     * parallel too. */
    roberts_vec3 up;
    /** Orthographic: how far a point moves to the right and up in the drawing for each unit that it lies farther away;
     * 0,0 = sight lines perpendicular to the picture plane. */
    roberts_vec2 oblique;
    /** Perspective: anything nearer to the eye's plane is cut off, model units; 0 = a thousandth of the look-at point's
     * distance, and at least 1e-5 of the scene's diameter. Anything nearer than 1e-6 of the diameter is always cut
     * off. */
    double near_distance;
    /** A section through this point of the model: everything nearer to the viewer, along the axis of sight, is cut off.
     * In perspective, this plane or that of `near_distance` counts, whichever is farther from the eye. */
    roberts_vec3 section;
    /** Parallel views: the section is perpendicular to this instead, and all on this side of it is cut off. It must not
     * point away from the viewer; 0,0,0 = the axis of sight. */
    roberts_vec3 section_normal;
    bool has_section; /**< false: `section` is not used, and a parallel view has no near plane */
    /** Perspective: the angle from side to side and from bottom to top, under 180 (on a page that is not square, across
     * its shorter side); 0 = the whole scene, but where the plane at `near_distance` cuts it, at most
     * 60. */
    double fov_degrees;
    double roll_degrees; /**< turns the drawing counter-clockwise */
} roberts_camera;

/** Fills `camera` with the preset called `name` (iso, dimetric, trimetric, front, back, right, left, top, bottom;
 * and the oblique cavalier and cabinet: front views with depth at 45 degrees, in full and half length);
 * false if there is no such preset. */
bool roberts_camera_preset(const char *name, roberts_camera *camera);

/** Fills `camera` with the orthographic view from an azimuth (0 = front, 90 = right, 180 = back; any) and an elevation
 * over the horizon (90 = top, with the front below; -90 to 90), with the drawing turned by `roll` counter-clockwise.
 * All are in degrees; at multiples of 90 the direction is exact. False if one of them is not finite or out of its
 * range. */
bool roberts_camera_angles(double azimuth, double elevation, double roll, roberts_camera *camera);

/** Turns `camera` (direction or eye, look-at point, section with its normal, and up) by `degrees` about the vertical
 * line through the centre of the scene's box, from the front to the right. What the drawing shows turns the other way.
 */
void roberts_camera_turn(const roberts_scene *scene, double degrees, roberts_camera *camera);

/**
 * Finds the window that roberts_hide() would give the drawing of `scene` seen by `camera`, but much faster. `framed`,
 * unless NULL, is filled as in the drawing.
 * To draw pictures from several sides at one scale, set window_min and window_max of every drawing to the box of all
 * their windows, `windowed` to true, and `framed` to true if one of them is framed. For labels of one size, write all
 * of them once, and set lettering.height_mm to the least roberts_ink.label_mm.
 * Returns ROBERTS_OK, _NO_MEMORY or _BAD_VIEW.
 */
roberts_status roberts_window(const roberts_scene *scene, const roberts_camera *camera, roberts_vec2 *min,
                              roberts_vec2 *max, bool *framed, roberts_error *error);

/**
 * Finds where points of the model lie in the picture, seen or not: the inverse of roberts_pick().
 * point, out  [count] each; they may be the same. x and y of a result are as p0 of roberts_segment, z as its z0; all
 *             three are NaN if the near plane cuts the point off. `out` does not change on failure
 * The eye may be anywhere, also inside a body. For places on a page see roberts_ink.origin_mm.
 * Returns ROBERTS_OK or _BAD_VIEW.
 */
roberts_status roberts_project(const roberts_scene *scene, const roberts_camera *camera, const roberts_vec3 *point,
                               size_t count, roberts_vec3 *out, roberts_error *error);

/* ---- hide: hidden lines removed -------------------------------------------------------------------------------- */

typedef enum roberts_state {
    ROBERTS_VISIBLE,
    ROBERTS_HIDDEN,
    ROBERTS_CLIPPED, /**< cut off by the near plane, that of an eye or of a section */
} roberts_state;

typedef enum roberts_line {
    ROBERTS_OUTLINE, /**< its faces lie on one side of it in the picture (one is front, one back), or one is edge-on */
    ROBERTS_CREASE,  /**< its faces lie on both sides of it */
    ROBERTS_BACK,    /**< of a convex solid, between two back faces: hidden by the solid itself, else a crease */
    ROBERTS_BORDER,  /**< an edge of one face */
    ROBERTS_WIRE,    /**< an edge of no face */
    ROBERTS_INTERSECTION, /**< two faces cross there, or one ends on the other along an edge that is left out */
    ROBERTS_BACK_OUTLINE, /**< between a back face and one that is edge-on: hidden by the solid, else an outline */
} roberts_line;

/** A maximal part of a line in one state. A line is an edge, or an intersection: see roberts_crossing. */
typedef struct roberts_segment {
    uint32_t solid;  /**< number of the body, from 0 by smallest vertex; of an intersection, that of its first face */
    uint32_t v0, v1; /**< the edge's vertices as in the input, v0 < v1; ROBERTS_NONE for an intersection */
    uint32_t by;     /**< hidden: the body seen at the middle of the part; otherwise ROBERTS_NONE */
    double t0, t1;   /**< along the line in space, 0 <= t0 < t1 <= 1: from v0 to v1, or from end[0] to end[1] of its
                          roberts_crossing */
    /** Its ends in the picture, model units. Both ends of a clipped part are where it is cut (0,0 if the whole edge is
     * clipped). */
    roberts_vec2 p0, p1;
    /** How near the viewer p0 and p1 are, model units: greater is nearer, and 0 is the depth of the scene's centre or
     * of the look-at point. Linear along the line in the picture, so in perspective e / (1 - e / D), where e and D are
     * how much nearer than the look-at point the end and the eye are, along the axis of sight. */
    double z0, z1;
    uint8_t state; /**< roberts_state */
    uint8_t line;  /**< roberts_line */
    /** Hidden, and roberts_hide_options.levels: how many layers lie in front of the middle of the part, at most 65535;
     * otherwise 0. Each convex or closed body counts as often as the line of sight enters it there: the number of its
     * faces toward the viewer in front of the part. An open body counts each face that the line of sight meets. Faces
     * in whose planes the line lies do not count. (A. Appel, "The notion of quantitative invisibility and the machine
     * rendering of solids", ACM 1967.) */
    uint16_t level;
    uint32_t edge; /**< number of the edge in the scene; of an intersection, its number in roberts_drawing.crossing */
} roberts_segment;

/** A maximal segment in which two faces cross, or in which one ends on the other along an edge that is left out. */
typedef struct roberts_crossing {
    uint32_t face[2];    /**< face[0] < face[1], as numbered in the input */
    roberts_vec3 end[2]; /**< in the model; end[0] has the smaller x, or y where those touch, or z */
} roberts_crossing;

/** What a scene knows about an edge, kept in a drawing that has no scene: see roberts_join(). */
typedef struct roberts_known_edge {
    uint32_t face[2];    /**< as roberts_segment_faces() gives them */
    double t0, t1;       /**< parameters of its ends along the edge of the file */
    roberts_vec3 end[2]; /**< in the model, at t0 and t1 */
} roberts_known_edge;

/** How many pairs of an edge and a front each test decided (lecture: tests 1 to 4, cheapest first). A front is all
 * front faces of a convex solid together; or one front face, if the solid has very many; or one face of any other
 * body. */
typedef struct roberts_tally {
    uint64_t pairs;           /**< pairs of edge and front compared */
    uint64_t test1_visible;   /**< both ends in front of a face's plane */
    uint64_t test2_visible;   /**< the sight plane of the edge misses the outline */
    uint64_t test3_visible;   /**< outside one side */
    uint64_t test3_invisible; /**< inside all sides (up to where the edge pierces the face) */
    uint64_t test4;           /**< cut at the crossings */
    uint64_t covered;         /**< edges dropped without a test: behind covers, or at the back of a body */
    uint64_t pierced;         /**< hidden parts that end where the edge pierces a face; like the other counts, it
                                   depends on the grid, since what is already hidden is not tested again */
    uint64_t refined;         /**< signs and crossings computed again in twice the precision */
} roberts_tally;

/** CPU and wall-clock seconds of one stage. */
typedef struct roberts_time {
    double cpu, wall;
} roberts_time;

/** What determines the touching distance. */
typedef enum roberts_epsilon_reason {
    ROBERTS_EPSILON_GIVEN,    /**< by the options */
    ROBERTS_EPSILON_DIAMETER, /**< 1e-11 of the scene's diameter */
    ROBERTS_EPSILON_ROUNDING, /**< 16 units of the last place of the largest coordinate */
    ROBERTS_EPSILON_FLOAT32,  /**< 2 units of the last place of the largest coordinate that came as a 32-bit float */
    ROBERTS_EPSILON_DECIMAL,  /**< 2 units of the last place of decimal coordinates: roberts_scene_options.rounded */
} roberts_epsilon_reason;

/** The segments of all edges, sorted by solid, v0, v1, t0; then those of all intersections, sorted by their faces and
 * t0. Statistics of the run come with them. */
typedef struct roberts_drawing {
    size_t count;
    roberts_segment *segment; /**< [count + cut_count] */
    size_t crossing_count;
    roberts_crossing *crossing; /**< [crossing_count] sorted by face[0], face[1], end[0]; with hidden lines, of all
                                     faces that are not edge-on */
    size_t crossing_pairs;      /**< pairs of faces that cross in these */
    roberts_vec2 window_min, window_max; /**< box of the scene's picture, hidden parts included; or the field of view */
    bool framed;    /**< the window is the field of view: segments may reach beyond it, and are cut off there when drawn
                         (see roberts_page_shape()) */
    bool sectioned; /**< roberts_camera.section has cut something off */
    bool windowed;  /**< set it to lay out the page by the window, beyond which nothing may reach unless `framed` */
    const struct roberts_region_list *regions; /**< borrowed: what is seen of each face, for fills, hatching and labels;
                                                    of the same scene and camera. NULL: not known. Set it before
                                                    drawing */
    double epsilon;                            /**< the touching distance that was used, model units */
    roberts_epsilon_reason epsilon_reason;
    double scene_diameter;        /**< diagonal of the box round the scene */
    uint32_t grid, grid_rows;     /**< columns and rows of cells, as chosen */
    size_t solids, culled_solids; /**< all; those found completely hidden beforehand (the counts below leave out their
                                       faces and edges) */
    size_t front_faces, back_faces, edge_on_faces; /**< counted in convex pieces of faces */
    /** Edges, or their parts if faces that cross themselves divide them: all; those with a front face. Cuts between the
     * pieces of a face count too. */
    size_t edges, surviving_edges;
    size_t seams; /**< with `unite`: surviving edges (all, if hidden segments are kept), or parts of them, that are left
                       out because bodies are flush there or because they lie inside a body */
    size_t drawn_edges;  /**< surviving edges (all, if hidden segments are kept) that bend by more than the crease
                              angle */
    roberts_tally tally; /**< with regions: also for the edges that only these need */
    roberts_time view_time, grid_time;
    roberts_time hide_time;         /**< with regions: also of the edges that only these need */
    roberts_time region_time;       /**< of visible regions; 0: none are wanted */
    size_t known_edge_count;        /**< only in a joined drawing: there, `edge` of a segment is an index here */
    roberts_known_edge *known_edge; /**< [known_edge_count] */
    size_t cut_count; /**< the segments from `count` on: where the near plane cuts bodies. Pages show them as outlines;
                           they are in no table, and have no v0, v1 and edge */
} roberts_drawing;

typedef struct roberts_hide_options {
    double crease_degrees; /**< an edge between two front faces, or two back ones, that bends by at most this is left
                              out (default: 0.1), and so is one that rounding of the coordinates may have bent */
    bool crease_auto; /**< of curved bodies (a scan, a round part; see roberts_scene_body_curved()) edges that bend by
                           at most 30 degrees are left out (default: true) */
    bool all_edges;   /**< draw flat edges too */
    bool keep_hidden; /**< return hidden segments too, also of back edges, with `by` */
    bool levels;      /**< with keep_hidden: fill in `level` */
    bool nameless;    /**< with keep_hidden: `by` is ROBERTS_NONE, which saves time */
    /** Draw all closed bodies as one: seams between flush blocks and everything inside disappear. In the plane
     * perpendicular to an edge, the bodies together fill some angle. The edge is drawn where this angle is neither
     * nothing, nor all, nor exactly half of the plane. The angle also determines the class of a line: an intersection
     * becomes an outline or a crease. Where edges of several bodies coincide, that of the smallest body number is
     * drawn. */
    bool unite;
    bool merge_regions; /**< for roberts_regions(): coplanar neighbours of one colour become one region, with the number
                             of the first face; those of different bodies only with `unite` */
    bool slopes;        /**< for roberts_regions(): fill in `slope`. roberts_hide_options_default() sets it */
    double epsilon;   /**< touching distance, model units; 0 = 1e-11 of the scene's diameter, but at least 16 ulp of the
                           largest coordinate, 2 float ulp of the largest one that came as a 32-bit float, and 2
                           units of the last place with roberts_scene_options.rounded */
    uint32_t grid;    /**< cells per side, up to ROBERTS_GRID_MOST; 0 = choose. Reduced if the grid would take several
                           times the scene's memory */
    uint32_t threads; /**< up to ROBERTS_THREADS_MOST; 0 = one per processor */
} roberts_hide_options;

roberts_hide_options roberts_hide_options_default(void);

/** Returns the number of processors that this process may use: the number of threads if an option leaves it open. It is
 * 1 in a build without threads. */
uint32_t roberts_processor_count(void);

/**
 * Removes the hidden lines of `scene` seen by `camera`.
 * options  NULL for the defaults
 * drawing  owned by the caller, released by roberts_drawing_free(), also before it is filled again; empty on failure
 * A point of a line is hidden if some face that is not edge-on holds a point strictly nearer to the viewer on the same
 * line of sight. Faces are closed in projection and hide from both sides; positions within epsilon count as touching.
 * Faces in which a line lies do not hide it: an edge's own faces, or both faces of an intersection. The result does not
 * depend on grid or threads. Returns ROBERTS_OK, _NO_MEMORY, _BAD_VIEW or _BAD_ARGUMENT.
 */
roberts_status roberts_hide(const roberts_scene *scene, const roberts_camera *camera,
                            const roberts_hide_options *options, roberts_drawing *drawing, roberts_error *error);
void roberts_drawing_free(roberts_drawing *drawing);

/** Finds the faces of a segment's edge, or those that cross in it: face[0] < face[1], as numbered in the input,
 * including faces of fewer than three corners. ROBERTS_NONE where there is none (a wire, a border, a face of a hull);
 * of more than two, the two smallest. `drawing` is the one with the segment, or its summary; it was made from `scene`,
 * which may be NULL for an intersection. */
void roberts_segment_faces(const roberts_scene *scene, const roberts_drawing *drawing, const roberts_segment *segment,
                           uint32_t face[2]);

/** Finds the ends of a segment in the model, at t0 and t1 of its line. `scene` and `drawing` as above. Returns false,
 * and leaves `end` unchanged, if there is no such line. */
bool roberts_segment_ends(const roberts_scene *scene, const roberts_drawing *drawing, const roberts_segment *segment,
                          roberts_vec3 end[2]);

/** Receives one segment, valid during the call only; false stops the work. */
typedef bool roberts_segment_fn(void *context, const roberts_segment *segment);

/** Receives segments, one by one. */
typedef struct roberts_receiver {
    roberts_segment_fn *receive; /**< called by one thread at a time, not always the same */
    void *context;
} roberts_receiver;

/**
 * The same, but passes the segments to `each` one by one, in order, and stores none, so a large drawing need not fit in
 * memory.
 * summary  NULL, or filled like a drawing without segments; its `count` is the number of segments; its `crossing` is
 *          set before the first intersection is passed; released by roberts_drawing_free()
 * Returns what roberts_hide() returns, or ROBERTS_STOPPED if `each->receive` returned false.
 */
roberts_status roberts_hide_each(const roberts_scene *scene, const roberts_camera *camera,
                                 const roberts_hide_options *options, const roberts_receiver *each,
                                 roberts_drawing *summary, roberts_error *error);

/* ---- regions: what is seen of each face ------------------------------------------------------------------------ */

/** What is seen of one face. Its rings bound it: each runs counter-clockwise in the picture round one piece of it, or
 * clockwise round a hole in the piece before. */
typedef struct roberts_region {
    uint32_t solid; /**< number of the body */
    uint32_t face;  /**< number of the face in the input; ROBERTS_NONE: a hull's, or where the near plane cuts */
    size_t first_ring, ring_count;
    double area;         /**< in the picture, model units squared */
    double z_min, z_max; /**< how near the viewer its farthest and its nearest point are, as z0 in roberts_segment */
    roberts_vec3 normal; /**< unit normal of the face, on the side that is seen, in the viewer's axes: x to the right, y
                              upward, z toward the viewer */
    roberts_color color; /**< the face's colour in the input; if it has none, the mean of its corners' colours */
    bool section;        /**< true: no face, but the cut of a closed body by the near plane */
} roberts_region;

/** Directions in the plane of a face, for hatching that follows the faces. Faces in one plane have the same values. */
typedef struct roberts_slope {
    /** How a point's picture moves when the point moves by one unit in the face's plane: up along the steepest line, or
     * to the right along a level line (as seen from the side that is shown). Up is +z, or the axis along which the
     * camera's `up` lies, unless the camera looks along z. On a level face the two are +y and +x. In perspective they
     * hold at the foot. */
    roberts_vec2 steep, level;
    roberts_vec2 foot; /**< picture of that point of the face's plane which is nearest to the middle of the scene */
} roberts_slope;

/** The visible regions of all faces: they tile the picture's shadow, without gaps and without overlaps. */
typedef struct roberts_region_list {
    size_t count, ring_count, corner_count;
    roberts_region *region; /**< [count] by solid, then by face */
    size_t *ring_start;     /**< [ring_count + 1] ring r has corners corner[ring_start[r]] .. [ring_start[r + 1] - 1] */
    roberts_vec2 *corner;   /**< [corner_count] of the picture, model units */
    roberts_slope *slope;   /**< [count] with roberts_hide_options.slopes; otherwise NULL */
    bool united;            /**< all closed bodies are drawn as one: roberts_hide_options.unite */
} roberts_region_list;

/**
 * Finds what is seen of each face of `scene`. A point of the picture belongs to the face that the viewer sees there. If
 * several touch there, the smallest solid wins, and then the smallest face.
 * options  NULL for the defaults; only epsilon, grid, threads, merge_regions, slopes and unite are used
 * out      owned by the caller, released by roberts_regions_free(); empty on failure
 * Corners are the points at which visible lines end or meet, including lines that the crease angle leaves out.
 * Neighbouring regions have exactly the same corners along their common border. A ring may touch itself in a corner,
 * but does not cross itself. Anything narrower than a few epsilon is no region. Neither grid nor threads change the
 * result. Returns ROBERTS_OK, _NO_MEMORY, _BAD_VIEW or _BAD_ARGUMENT.
 */
roberts_status roberts_regions(const roberts_scene *scene, const roberts_camera *camera,
                               const roberts_hide_options *options, roberts_region_list *out, roberts_error *error);
void roberts_regions_free(roberts_region_list *regions);

/**
 * Does what roberts_hide() and roberts_regions() do, in less time: the scene is mapped once, and each line is hidden
 * once. With `keep_hidden` or `unite` it takes as long as both.
 * options           as for roberts_hide()
 * drawing, regions  both empty on failure
 * The corners of regions may differ from those of roberts_regions() by rounding.
 */
roberts_status roberts_hide_with_regions(const roberts_scene *scene, const roberts_camera *camera,
                                         const roberts_hide_options *options, roberts_drawing *drawing,
                                         roberts_region_list *regions, roberts_error *error);

/* ---- ray: rays against shapes -------------------------------------------------------------------------------- */

/* Common rules. A ray is the points S + t v with t >= 0; v has any length but 0, and t is measured in lengths of v.
 * Shapes are closed: a ray meets a shape that it only touches, and one that S lies on (t = 0), but not one behind S. A
 * ray parallel to a flat shape (its determinant is lost in rounding) does not meet it, even if it lies in it. Otherwise
 * there is no tolerance: through rounding, a ray through the common side of two triangles may miss both. A ray with a
 * zero or infinite direction meets nothing, and nothing meets a flat or empty shape. Each function returns whether the
 * ray meets the shape, and fills its last argument only then. Lengths between 1e-50 and 1e50 are safe from underflow
 * and overflow, which would give a miss.
 *
 * Sources: [L] "Lancer de rayons I" with its corrections 1 to 4, [B] "Intersection entre un rayon et une boite" with
 * its corrections 1 and 2, [Z] "Zobrazovaci kanal, prienik luca s objektami" with its corrections 1 and 2. */

/** A ray in space. */
typedef struct roberts_ray {
    roberts_vec3 origin, direction;
} roberts_ray;

/** A ray in the plane. */
typedef struct roberts_ray2 {
    roberts_vec2 origin, direction;
} roberts_ray2;

/** a x + b y + c z + d = 0; (a, b, c) has any length but 0. For a plane that bounds a solid, > 0 is inside. */
typedef struct roberts_plane {
    double a, b, c, d;
} roberts_plane;

typedef enum roberts_facing {
    ROBERTS_FACING_FRONT, /**< met from outside: v . n < 0 with the outward normal n */
    ROBERTS_FACING_BACK,  /**< met from inside */
} roberts_facing;

/** Where a ray meets something flat. */
typedef struct roberts_hit {
    double t;
    double alpha, beta; /**< segment: P = A + alpha AB; triangle: P = A + alpha AB + beta AC; else 0 */
    roberts_facing facing;
} roberts_hit;

/** Where a ray meets a convex solid: the line is inside from t_in to t_out. */
typedef struct roberts_span {
    double t_in, t_out;    /**< t_in < 0: S is inside; infinite where a solid is unbounded */
    double t;              /**< where the surface is met first: t_in if that is >= 0, else t_out */
    roberts_facing facing; /**< front at t_in, back at t_out */
    /** Polyhedron: index of the plane met at t; box: 0, 1 the sides of least and greatest x, 2, 3 of y, 4, 5 of z; the
     * first if several meet there; ROBERTS_NONE if there is none, and for circle and sphere. */
    uint32_t face;
} roberts_span;

/** Segment AB in the plane; n = AB turned by +90 degrees points to its front. [L] 1.1, proposition 1. */
bool roberts_ray_segment(roberts_ray2 ray, roberts_vec2 a, roberts_vec2 b, roberts_hit *hit);

/** Plane; (a, b, c) points to its front. [L] 1.2, proposition 2; [Z] "priesecnik priamky a roviny". */
bool roberts_ray_plane(roberts_ray ray, roberts_plane F, roberts_hit *hit);

/** Triangle; AB x AC points to its front. By cross products: [L] 1.3, proposition 3 with correction 1. */
bool roberts_ray_triangle(roberts_ray ray, roberts_vec3 a, roberts_vec3 b, roberts_vec3 c, roberts_hit *hit);

/** The same by Moeller and Trumbore ("Fast, minimum storage ray/triangle intersection", 1997): [Z] with correction 2,
 * and meeting both sides. */
bool roberts_ray_triangle_mt(roberts_ray ray, roberts_vec3 a, roberts_vec3 b, roberts_vec3 c, roberts_hit *hit);

/** The same by way of the plane and of dot products in it: [Z] "prienik priamky a trojuholnika" with correction 1. */
bool roberts_ray_triangle_barycentric(roberts_ray ray, roberts_vec3 a, roberts_vec3 b, roberts_vec3 c,
                                      roberts_hit *hit);

/** Whether p, a point of the polygon's plane, lies in the polygon of `count` corners in space. The border belongs to
 * it, as far as rounding allows. Neighbouring corners must differ. False for fewer than 3 corners and for corners on
 * one line. */
typedef bool roberts_inside_fn(const roberts_vec3 *corner, size_t count, roberts_vec3 p);

/** By the parity of crossings with a half-line from p; any simple polygon. [L] 1.4 A. */
bool roberts_inside_crossings(const roberts_vec3 *corner, size_t count, roberts_vec3 p);
/** By the signs of the determinants (PA_i, PA_i+1) in an orthonormal frame; convex polygons. [L] 1.4 B, prop. 4. */
bool roberts_inside_signs(const roberts_vec3 *corner, size_t count, roberts_vec3 p);
/** The same in the (alpha, beta) frame of a corner and its neighbours; convex polygons. [L] 1.4 B, proposition 5. */
bool roberts_inside_frame(const roberts_vec3 *corner, size_t count, roberts_vec3 p);
/** By the sum of the angles under which p sees the sides; p may lie beside the plane. [L] 1.4 C, proposition 6. */
bool roberts_inside_angles(const roberts_vec3 *corner, size_t count, roberts_vec3 p);

/** Plane polygon; seen from its front, the corners run counter-clockwise. inside: NULL = roberts_inside_signs. [L]
 * 1.4. */
bool roberts_ray_polygon(roberts_ray ray, const roberts_vec3 *corner, size_t count, roberts_inside_fn *inside,
                         roberts_hit *hit);

/** Circle in the plane (its disc is the inside). A tangent is met from the front. [L] 2.1. */
bool roberts_ray_circle(roberts_ray2 ray, roberts_vec2 centre, double radius, roberts_span *span);

/** Sphere, by the quadratic equation: [L] 2.2, proposition 7 with correction 2, for v of any length. */
bool roberts_ray_sphere(roberts_ray ray, roberts_vec3 centre, double radius, roberts_span *span);

/** Sphere, by the foot of the perpendicular from its centre; better conditioned if S is far away.
 * [L] 2.3, proposition 8, for v of any length. */
bool roberts_ray_sphere_geometric(roberts_ray ray, roberts_vec3 centre, double radius, roberts_span *span);

/** Box with sides along the axes and opposite corners a, b, in the plane. [L] 3.1, proposition 9. */
bool roberts_ray_box2(roberts_ray2 ray, roberts_vec2 a, roberts_vec2 b, roberts_span *span);

/** The same in space. [L] 3.2 with corrections 3 and 4; [B] with corrections 1 and 2. */
bool roberts_ray_box(roberts_ray ray, roberts_vec3 a, roberts_vec3 b, roberts_span *span);

/** Convex polyhedron: the points where no plane is < 0 (perhaps unbounded or empty). As the slabs of the box, but one
 * half-space at a time; Cyrus and Beck, "Generalized two- and three-dimensional clipping", 1978. */
bool roberts_ray_polyhedron(roberts_ray ray, const roberts_plane *F, size_t count, roberts_span *span);

/* ---- ray: a second opinion on a drawing ------------------------------------------------------------------------ */

/** A point of an edge at which the drawing and a ray disagree. */
typedef struct roberts_contradiction {
    uint32_t solid, v0, v1; /**< the line, as in roberts_segment */
    double t;               /**< where on it */
    roberts_state drawn;    /**< what the drawing says */
    roberts_state cast;     /**< what the ray says; clipped: the near plane cuts the point off */
    uint32_t by;            /**< cast hidden: a solid that hides the point; else ROBERTS_NONE */
    uint32_t drawn_by;      /**< drawn hidden: the solid that the drawing names, or ROBERTS_NONE; if `cast` is hidden
                                 too, this solid is wrong */
    uint32_t face[2];       /**< of an intersection: its faces, ROBERTS_NONE for one of a hull; of an edge (v0 is a
                                 vertex): ROBERTS_NONE */
    bool no_line;           /**< these faces do not cross there; `cast` is meaningless */
} roberts_contradiction;

/** Receives contradictions, line by line, and in order along each line. */
typedef void roberts_contradiction_fn(void *context, const roberts_contradiction *contradiction);

typedef struct roberts_verify_options {
    uint32_t rays; /**< per segment, near its ends and evenly between; 0 = 3. More go where errors are likely */
    /** As given to roberts_hide(), with the same defaults, so that edges without segments are known to be hidden or
     * left out. With `unite` only the parts of edges that are drawn are checked. */
    double crease_degrees;
    bool crease_auto, all_edges, unite;
    uint32_t threads;                        /**< 0 = one per processor; the result does not depend on it */
    roberts_contradiction_fn *contradiction; /**< NULL: count only */
    void *context;
} roberts_verify_options;

roberts_verify_options roberts_verify_options_default(void);

/** What roberts_verify() found. */
typedef struct roberts_verification {
    size_t segments;             /**< segments checked: visible ones, hidden ones, and those left out as hidden */
    size_t points;               /**< rays cast */
    size_t undecided;            /**< of these: points within about epsilon of where the answer changes */
    size_t contradictions;       /**< of these: the drawing is wrong there */
    roberts_contradiction first; /**< where contradictions > 0 */
} roberts_verification;

/**
 * Checks a drawing by casting rays from points of its edges toward the viewer, in model space, through a tree of boxes.
 * scene, camera   those that `drawing` was made from
 * drawing         with or without hidden segments; missing parts of an edge that must be drawn count as hidden
 * options         NULL for the defaults
 * Besides options->rays per segment, rays are cast close to the ends of visible segments, wherever a face hides a part
 * of one, step by step along hidden segments, and at the middle of segments that name what hides them (`by`). The rule
 * is that of roberts_hide(), with drawing->epsilon; points where the answer depends on a few epsilon are counted as
 * undecided. Clipped segments are not checked. The two faces of an intersection must cross there. A contradiction is
 * not a failure. Returns ROBERTS_OK, _NO_MEMORY, _BAD_VIEW, or
 * _BAD_ARGUMENT (a segment of no edge of the scene, t out of order). */
roberts_status roberts_verify(const roberts_scene *scene, const roberts_camera *camera, const roberts_drawing *drawing,
                              const roberts_verify_options *options, roberts_verification *result,
                              roberts_error *error);

/** A face that a sight line meets: a front face of a convex solid, or any face of another body. */
typedef struct roberts_pick_hit {
    uint32_t solid;     /**< number of the body */
    uint32_t face;      /**< number of the face in the input; ROBERTS_NONE: a hull's, or where the near plane cuts */
    double depth;       /**< how near the viewer, model units: distance along the axis of sight from the plane through
                             the scene's centre or the look-at point; > 0 in front of that plane, < 0 behind it */
    roberts_vec3 point; /**< where the sight line meets it, model space */
} roberts_pick_hit;

/** What lies at a point of the picture, nearest first. */
typedef struct roberts_picked {
    size_t count;
    roberts_pick_hit *hit; /**< [count] hit[0] is seen; the others lie behind it */
} roberts_picked;

/**
 * Finds what is seen at (x, y) of the picture (as in roberts_segment's p0, p1) and what lies behind it: every front
 * face on the sight line, and every face of bodies that are not convex, borders included. If a solid has several faces
 * at one depth, the smallest number is given. Hits are sorted by depth, and at equal depths (within epsilon) by solid.
 * picked  owned by the caller, released by roberts_picked_free(); empty if nothing is there, and on failure
 * Returns ROBERTS_OK, _NO_MEMORY, _BAD_VIEW or _BAD_ARGUMENT (x or y not finite).
 */
roberts_status roberts_pick(const roberts_scene *scene, const roberts_camera *camera, double x, double y,
                            roberts_picked *picked, roberts_error *error);
void roberts_picked_free(roberts_picked *picked);

/* ---- draw: pages and tables ------------------------------------------------------------------------------------ */

typedef enum roberts_format {
    ROBERTS_SVG, /**< a page as text, millimetres, one layer per line class */
    ROBERTS_PDF,
    ROBERTS_PS,
    ROBERTS_EPS, /**< PostScript cut to the drawing, for inclusion */
    ROBERTS_PNG,
    ROBERTS_TIKZ, /**< a picture for LaTeX, one path per stroke, a style per line class; ".tex", too */
    ROBERTS_DXF,  /**< of AutoCAD release 12, millimetres, one layer per line class */
    ROBERTS_HPGL, /**< for pen plotters (HP-GL/2), one pen per line class; ".plt", too */
    ROBERTS_CSV,  /**< a table, one row per segment */
    ROBERTS_JSON, /**< the same table as an array of objects */
    ROBERTS_NULL, /**< compute, write nothing */
} roberts_format;

/** Finds the format called `name` ("svg", "csv", ...), or the one that the ending of `path` names, in upper or lower
 * case ("a.SVG"). Returns false if there is none, and leaves `*format` unchanged. */
bool roberts_format_by_name(const char *name, roberts_format *format);
bool roberts_format_by_path(const char *path, roberts_format *format);

/** Whether a file of this format can hold text as text, not only as strokes. (SVG, PDF, TikZ and DXF can.) */
bool roberts_format_has_text(roberts_format format);

/** How hidden segments are drawn. A drawing has them only if roberts_hide() was told to keep them. */
typedef enum roberts_hidden {
    ROBERTS_HIDDEN_NONE,   /**< left out, of tables too */
    ROBERTS_HIDDEN_DASHED, /**< drawn with the dashes of their pen */
    ROBERTS_HIDDEN_SOLID,  /**< drawn without dashes */
} roberts_hidden;

/** How a class of lines is drawn. Caps and joins are always round. */
typedef struct roberts_pen {
    double width_mm;        /**< > 0 */
    double dash_mm, gap_mm; /**< as seen on paper, round caps included; dash_mm 0 = unbroken */
    unsigned char red, green, blue;
    bool off; /**< leave these lines out; all else keeps its place, except without frame or symbol */
    /** Number of the pen in HP-GL, and of the layer if layers are numbered; 0 = that of the class: 1 hidden, 2 wire, 3
     * intersection, 4 crease, 5 border, 6 outline, 7 frame, 8 symbol, 9 hatch, 10 text, 11 hidden-text. */
    unsigned char number;
} roberts_pen;

/** The background of the whole page, below all lines. */
typedef struct roberts_background {
    bool on; /**< false: nothing is drawn; PNG is white then */
    unsigned char red, green, blue;
} roberts_background;

/** What visible faces are filled with, below all lines. It needs `regions` in each drawing. */
typedef enum roberts_fill {
    ROBERTS_FILL_NONE,
    ROBERTS_FILL_COLOR, /**< all with the same colour */
    ROBERTS_FILL_MODEL, /**< with their own colours; a face without a colour is left open, or light grey if shaded */
    ROBERTS_FILL_BODY,  /**< each body with a colour of its own; the colours repeat after nine */
} roberts_fill;

/** Which way the strokes of a hatching run. */
typedef enum roberts_hatch_along {
    ROBERTS_HATCH_PICTURE, /**< to the right, the same for all faces */
    ROBERTS_HATCH_STEEP,   /**< along the steepest line of each face */
    ROBERTS_HATCH_ACROSS,  /**< across it, along a level line of each face */
} roberts_hatch_along;

/** Strokes on faces, closer together where less light falls (`light`). A face that the light meets at a right angle has
 * none. On a face without light they are `spacing_mm` apart. In between, their length per area follows the cosine of
 * the light's angle (Lambert). Strokes continue across coplanar faces. It needs `regions` in each drawing, with their
 * slopes if the strokes follow the faces. */
typedef struct roberts_hatching {
    bool on;                   /**< default: false */
    double spacing_mm;         /**< from stroke to stroke on paper, where no light falls: 0.01 to 1000; default: 0.8 */
    uint32_t levels;           /**< how many tones there are, up to 1000; 0: one for each shade; default: 10 */
    roberts_hatch_along along; /**< default: ROBERTS_HATCH_PICTURE */
    double degrees;            /**< how far strokes are turned counter-clockwise, in the picture or in the face's plane;
                                    -360 to 360; default: 45 */
    /** false: the strokes of each tone are evenly spaced. true: a darker tone has the strokes of the lighter ones, and
     * more between them, so that strokes continue from tone to tone, as on curved surfaces; only tones of a half, a
     * quarter, ... are evenly spaced. Default: false */
    bool nested;
    double cross; /**< 0 to 1, a fraction of the darkest tone: the further strokes of tones darker than this run across
                       the others; default: 1, none do */
    /** Shorter strokes are left out, so the tone of small faces gets lighter: 0 to 1000; default: 0. */
    double shortest_mm;
    /** Only sections have strokes, all in the darkest tone. In bodies with odd numbers they are turned by 90 degrees,
     * unless the bodies are drawn as one; with `cross` at 0.5, both kinds look alike. Default: false */
    bool sections;
} roberts_hatching;

/** Paper. The drawing is fitted into the area within the margins, and centred. */
typedef struct roberts_page {
    double width_mm, height_mm; /**< 1 to 40000 each */
    double margin_mm;           /**< on all four sides, less than half the shorter side; a fitted drawing keeps at least
                                     half its widest pen from the edge (at most a tenth of the shorter side) */
} roberts_page;

/** Makes a field of view (the window of a `framed` drawing, from `min` to `max`, model units) wider or higher about its
 * middle, until it has the shape of the area within the page's margins. The page shows this part of the picture. */
void roberts_page_shape(const roberts_page *page, roberts_vec2 *min, roberts_vec2 *max);

/** How a drawing is laid on its page. A zeroed struct fits it into the margins. */
typedef struct roberts_placement {
    double scale;   /**< length on paper per length of the model, 0.05 for 1:20; 0 = as large as the margins permit */
    double unit_mm; /**< a model unit in mm, for `scale`; 0 = 1 */
    int align_x, align_y; /**< -1 left or bottom, 0 centre, 1 right or top margin */
    bool standard;        /**< scale 0: the largest of 1, 2 or 5 times a power of ten that fits (ISO 5455) */
} roberts_placement;

/** What a label names. */
typedef enum roberts_label_kind {
    ROBERTS_LABEL_VERTICES = 1,
    ROBERTS_LABEL_EDGES = 2,
    ROBERTS_LABEL_FACES = 4,
    ROBERTS_LABEL_BODIES = 8,
    ROBERTS_LABEL_NAMES = 16, /**< bodies, by the names of their groups in the input, from `scene`; one without a name
                                 has no label, or its number with ROBERTS_LABEL_BODIES */
} roberts_label_kind;

/** Those that need `regions` in each drawing. */
#define ROBERTS_LABEL_AREAS (ROBERTS_LABEL_FACES | ROBERTS_LABEL_BODIES | ROBERTS_LABEL_NAMES)

/** A name that a label shows instead of numbers. */
typedef struct roberts_name {
    roberts_label_kind of;
    uint32_t number;  /**< of the vertex, face or body; for an edge, its smaller vertex */
    uint32_t other;   /**< for an edge, its larger vertex; otherwise 0 */
    const char *text; /**< UTF-8; empty: no label */
} roberts_name;

/** Orders two roberts_name by what they belong to, for qsort() and bsearch(): by of, number, other. */
int roberts_name_order(const void *a, const void *b);

/** A text in the title block of a sheet. */
typedef struct roberts_field {
    const char *name; /**< owner, author, approved, number, revision, date or sheet; others are not drawn */
    const char *text; /**< UTF-8 */
} roberts_field;

/** A distance between two vertices, by their numbers in the input. */
typedef struct roberts_distance {
    uint32_t v0, v1;
} roberts_distance;

/** Text on a page, in the pens `text` and `hidden_text`. A zeroed struct means no text. Letters are strokes of A. V.
 * Hershey's "simplex" fonts, Latin and Greek, close to ISO 3098; accents are composed. A character that the fonts lack
 * is drawn as a box, and a warning counts such characters. Labels lie beside vertices and edges, in faces, and in the
 * largest visible face of a body. Where another place in the body has at least half as much room again, such as the
 * middle of a round body whose edges are not drawn, they lie there. Where there is room, none lies on a line or on
 * another label. If a face or body is too narrow for its label, the label stands nearby, and a leader line goes from it
 * to a dot. Labels stay within the margins, or the frame of a field of view, unless placement.scale is given; a drawing
 * that is fitted leaves room for them. Hidden things are labelled only if hidden lines are drawn. */
typedef struct roberts_lettering {
    double height_mm; /**< of capitals, 0.5 to 100; 0 = 3.5, labels 2.5 or 1.8 where there is little room */
    bool native;      /**< SVG, PDF, TikZ and DXF: text in a font of the viewer, so that it can be searched and
                           copied */
    unsigned labels; /**< a set of roberts_label_kind: things without a name are labelled by their numbers in the input;
                        with several kinds as v4, f4 and b4, edges always as 4-17 */
    size_t name_count;
    const roberts_name *name; /**< [name_count] sorted by roberts_name_order(), each once; whatever they name is
                                   labelled */
    /** Sheets: text in the title block (ISO 7200), like the fields. Without title and fields there is no block. */
    const char *title;
    size_t field_count;
    const roberts_field *field; /**< [field_count] */
    bool overall;               /**< sheets: dimensions of the scene: width, height and depth (ISO 129-1) */
    size_t distance_count;
    /** [distance_count] sheets: dimensions between vertices, each in one view that shows it in true length, preferably
     * one that shows both vertices; they need `scene`. If there is no such view or no room, a warning says so.
     * With `overall`, one that is the width, height or depth of the whole is not drawn again. */
    const roberts_distance *distance;
    bool zones;                /**< with a frame: zones and centring marks (ISO 5457), in margins of at least 7 mm */
    const char *unit;          /**< printed after the numbers of dimensions; NULL: none */
    roberts_warnings warnings; /**< of characters that the fonts lack, labels and distances without room, a tiny
                                    drawing, hatching that is all too short, lines beyond a plotter's origin */
} roberts_lettering;

/** In which order the pen draws the lines of a class. */
typedef enum roberts_order {
    ROBERTS_ORDER_TRAVEL, /**< lines that meet are chained, and chains ordered so that the lifted pen travels little */
    ROBERTS_ORDER_NONE,   /**< as in the drawing; a line is chained only to the one before it */
} roberts_order;

/** How the lines of an SVG are grouped. Except for ROBERTS_GROUP_CLASS, groups and elements have a `class`, and
 * attributes for scripts and style sheets: a body's group has data-body (its number) and data-name (the name of its
 * group in the input, if any); a piece of an edge has data-edge="4-17" (its vertices, not for an intersection),
 * data-faces="2,5" (the faces there, as roberts_segment_faces() gives them) and, where it is hidden, data-by (the body
 * seen there). A label whose text is native has what it names: data-vertex, data-edge, data-face or data-body. Pens are
 * attributes of groups, so style sheets override them. On a sheet the layers are the views, with data-view="front" and
 * so on, and contain the groups below. */
typedef enum roberts_grouping {
    ROBERTS_GROUP_CLASS,   /**< a layer for each class, with one path */
    ROBERTS_GROUP_BODY,    /**< a layer for each body, with a group of one path for each class */
    ROBERTS_GROUP_ELEMENT, /**< a layer for each class, with a group for each body, with a path for each piece of an
                                edge; pieces are not chained */
} roberts_grouping;

/** What was drawn on a page. */
typedef struct roberts_ink {
    size_t strokes;        /**< how often the pen goes down */
    double down_mm, up_mm; /**< how far the pen travels on and above the paper, from the first stroke to the last */
    double scale;          /**< mm on paper per model unit */
    /** Where the picture's 0,0 lies, mm to the right and down from the page's upper left corner; on a sheet, that of
     * the front view. The point x, y of the picture lies at origin_mm.x + scale * x, origin_mm.y - scale * y. */
    roberts_vec2 origin_mm;
    double label_mm; /**< height of the capitals of labels; 0: none are wanted */
} roberts_ink;

/** Additional columns of tables, after the usual ones. */
typedef enum roberts_column {
    ROBERTS_COLUMN_ENDS,  /**< X0,Y0,Z0,X1,Y1,Z1: roberts_segment_ends() */
    ROBERTS_COLUMN_DEPTH, /**< z0,z1: how near the viewer the ends are, as in roberts_segment */
    ROBERTS_COLUMN_LEVEL, /**< level, as in roberts_segment; needs roberts_hide_options.levels */
    ROBERTS_COLUMN_NAME,  /**< name: the name of the solid's group, roberts_scene_name() */
    ROBERTS_COLUMN_BY,    /**< by_name: the same for the solid that hides the piece */
    ROBERTS_COLUMNS       /**< how many there are */
} roberts_column;

/** The axes of a plotter, for HP-GL. A zeroed struct has the origin in the page's lower left corner, x to the right. */
typedef struct roberts_plotter {
    bool centre;            /**< the origin is in the middle of the page */
    uint32_t turn;          /**< the page is turned counter-clockwise by 0, 90, 180 or 270 degrees */
    roberts_vec2 inside_mm; /**< how far the origin lies from the page's corner or middle, along the plotter's
                                 axes, -1000 to 1000 */
} roberts_plotter;

/** Reports where an unfinished file is: called with its name just before it is created, and with NULL once it is
 * renamed or removed. So an interrupted program can remove it. The name is valid between the two calls. A file left by
 * a killed program is removed when the same file is saved again. */
typedef void roberts_temporary_fn(void *context, const char *path);

/** How a drawing is written. Start from roberts_draw_options_default() and change what you need. */
typedef struct roberts_draw_options {
    roberts_format format; /**< default: ROBERTS_SVG */
    roberts_hidden hidden; /**< default: ROBERTS_HIDDEN_NONE */
    roberts_page page;     /**< default: A4, upright, margins of 10 mm */
    bool crop; /**< the drawing is laid on this page, which is then cut to the drawing, its labels and its margins.
                    Default: false. Alignment then has no effect. Sheets, and drawings with a field of view, are not
                    cut */
    roberts_pen outline;           /**< default: 0.5 mm */
    roberts_pen border;            /**< edges of one face; default: 0.5 mm */
    roberts_pen crease;            /**< default: 0.35 mm */
    roberts_pen intersection;      /**< where faces cross; default: 0.35 mm */
    roberts_pen wire;              /**< edges of no face; default: 0.35 mm */
    roberts_pen back;              /**< hidden lines; default: 0.25 mm, dashes of 12 and gaps of 3 widths (ISO 128) */
    roberts_pen frame;             /**< along the margins, 5 mm from the drawing; if the drawing is `framed`, where it
                                        is cut off; default: off, 0.7 mm */
    roberts_pen symbol;            /**< projection symbol of a sheet; default: 0.35 mm */
    roberts_pen hatch;             /**< strokes of `hatching`; default: 0.25 mm */
    roberts_pen text;              /**< text and its lines; default: 0.25 mm */
    roberts_pen hidden_text;       /**< labels of what is hidden; default: 0.25 mm, grey */
    roberts_lettering lettering;   /**< default: none */
    roberts_background background; /**< default: off */
    roberts_hatching hatching;     /**< default: off */
    roberts_fill fill;             /**< default: ROBERTS_FILL_NONE */
    unsigned char fill_color[3];   /**< of ROBERTS_FILL_COLOR: red, green, blue; default: white */
    bool shaded;                   /**< fills are darker where less light falls; default: false */
    roberts_vec3 light;            /**< toward the light, as the viewer sees it: x to the right, y upward, z toward the
                                        viewer; any length but 0; default: -1, 2, 3 */
    roberts_placement placement;   /**< default: fitted, in the middle */
    roberts_order order;           /**< default: ROBERTS_ORDER_TRAVEL */
    const roberts_scene *scene;    /**< tables and groups of SVG: the drawing's scene, for the faces and ends of edges,
                                        and for names; NULL: these fields stay empty. Distances need it */
    size_t column_count;           /**< tables: how many additional columns; default: 0 */
    roberts_column column[ROBERTS_COLUMNS]; /**< [column_count] in this order, each once */
    bool real_dashes;                       /**< dashes as separate strokes, fitted to the line; default: false, a dash
                                                 pattern of the line */
    bool number_layers;              /**< SVG: layers are called "1 hidden" to "11 hidden-text"; default: names without
                                          numbers */
    roberts_grouping grouping;       /**< SVG; default: ROBERTS_GROUP_CLASS */
    const char *id_prefix;           /**< SVG: all ids begin with it; default: NULL, nothing. It is a letter or _, then
                                          letters, digits, - . or _, so that the ids are valid; this is not checked */
    roberts_plotter plotter;         /**< HP-GL; default: zeroed */
    double dpi;                      /**< PNG: dots per inch; default: 150 */
    const char *title, *description; /**< SVG and TikZ: UTF-8; NULL or empty: none */
    roberts_ink *ink;                /**< NULL, or filled when a page is written */
    roberts_temporary_fn *temporary; /**< NULL: not needed */
    void *temporary_context;
} roberts_draw_options;

roberts_draw_options roberts_draw_options_default(void);

/** Takes all `size` bytes; returns false on failure (errno set). */
typedef bool roberts_write_fn(void *context, const void *bytes, size_t size);

/**
 * Writes `drawing` in blocks to `write`.
 * options  NULL for the defaults
 * The same drawing and options give the same bytes, on every run and in every locale. On pages no line is drawn twice:
 * of coincident segments the nearest visible one is drawn, or else the nearest hidden one. Parts of one line and class
 * that are 0.001 mm apart or less are joined, and so are ends; parts no longer than that may be left out. Where nothing
 * is joined, SVG is accurate to 0.0005 mm. (On pages longer than 4 m, these lengths are ten times as large.) Tables
 * contain all segments unchanged.
 * Returns ROBERTS_OK, _NO_MEMORY, _IO (a write failed), _BAD_NUMBER (a segment is not finite) or _BAD_ARGUMENT (also if
 * the drawing does not fit on the page at its scale, or lacks the regions that fills, hatching or labels need).
 */
roberts_status roberts_drawing_write(const roberts_drawing *drawing, const roberts_draw_options *options,
                                     roberts_write_fn *write, void *context, roberts_error *error);

/**
 * The same into a file; "-" is standard output. The format is options->format, whatever the ending of `path`:
 * roberts_format_by_path() finds the format of an ending. A regular file appears whole or not at all: it is written in
 * the same folder under a temporary name, then renamed. An existing file keeps its mode, and a symbolic link is
 * followed. A device, a pipe or any other existing file that is not regular is written in place. SIGPIPE is left to the
 * caller; if it is ignored, a closed pipe is an error like any other.
 */
roberts_status roberts_drawing_save(const roberts_drawing *drawing, const roberts_draw_options *options,
                                    const char *path, roberts_error *error);

/**
 * Writes regions into a file as roberts_drawing_save() does ("-" is standard output): a JSON array with one object for
 * each region, which has body, face (null: not in the input), area, z0, z1 (z_min, z_max), color (null or an array) and
 * rings (arrays of [x, y]). If options->format is ROBERTS_CSV, it is a table with one row for each region: body, face,
 * area, z0, z1, color (numbers separated by blanks) and polygon (a MULTIPOLYGON as well-known text, with the corners of
 * rings as x y). `options` may be NULL; only its format and `temporary` are used. Returns ROBERTS_OK, _NO_MEMORY or
 * _IO.
 */
roberts_status roberts_regions_save(const roberts_region_list *regions, const roberts_draw_options *options,
                                    const char *path, roberts_error *error);

/* ---- draw: sheets, several views on one page ------------------------------------------------------------------- */

/** Where the views stand, seen from the front view (ISO 5456-2). */
typedef enum roberts_sheet_angle {
    ROBERTS_FIRST_ANGLE, /**< top view below, view from the left at the right */
    ROBERTS_THIRD_ANGLE, /**< top view above, view from the right at the right */
} roberts_sheet_angle;

enum {
    ROBERTS_SHEET_FRONT,
    ROBERTS_SHEET_TOP,
    ROBERTS_SHEET_SIDE, /**< from the left or from the right, as the angle requires */
    ROBERTS_SHEET_ISO,  /**< in the remaining cell; seen from the front, the top and the side that is shown */
    ROBERTS_SHEET_VIEWS
};

/** Drawings of one scene, each from roberts_hide() with the camera of its view; borrowed. */
typedef struct roberts_sheet {
    roberts_sheet_angle angle;
    double gap_mm; /**< between views; 0 = 15, or 25 if there are distances; more where labels or distances need it */
    const roberts_drawing *view[ROBERTS_SHEET_VIEWS]; /**< NULL: left out */
} roberts_sheet;

/** The name of a view: "front", "top", "left" or "right", or "iso"; NULL for any other number. */
const char *roberts_sheet_view_name(roberts_sheet_angle angle, int view);

/** Fills `camera` for a view, ROBERTS_SHEET_FRONT to ROBERTS_SHEET_ISO; false for any other number. */
bool roberts_sheet_camera(roberts_sheet_angle angle, int view, roberts_camera *camera);

/**
 * Writes the views of a sheet on one page, at one scale and aligned with one another, with the symbol of their angle in
 * the lower right corner. On small pages the symbol is no larger than one of four equal cells for the views, and is
 * left out if that shrinks it to about half its size. The placement holds for all views together: fitted, they are as
 * large as margins, gaps and symbol permit. With a frame the views keep 10 mm from it. Strokes of all views are in the
 * same layers. As CSV and JSON a sheet is one table, whose first column `view` is roberts_sheet_view_name(). For a
 * table of each view, save the drawings by themselves. All else is as for roberts_drawing_write() and
 * roberts_drawing_save().
 */
roberts_status roberts_sheet_write(const roberts_sheet *sheet, const roberts_draw_options *options,
                                   roberts_write_fn *write, void *context, roberts_error *error);
roberts_status roberts_sheet_save(const roberts_sheet *sheet, const roberts_draw_options *options, const char *path,
                                  roberts_error *error);

/* ---- parts: one drawing by several programs --------------------------------------------------------------------- */

/** What is drawn: the same for a plan, for its parts and for joining them. Only the warnings, the threads and `grid`
 * may differ. */
typedef struct roberts_task {
    roberts_camera camera;
    roberts_scene_options scene;     /**< without `hull` */
    roberts_hide_options hide;       /**< hidden segments always have `by` */
    roberts_temporary_fn *temporary; /**< as in roberts_draw_options */
    void *temporary_context;
} roberts_task;

/** Files, by their names; "-" is standard input. */
typedef struct roberts_inputs {
    size_t count;
    char *const *name; /**< [count] */
} roberts_inputs;

/** Part `number` of `of`, from 1. */
typedef struct roberts_share {
    uint32_t number, of;
} roberts_share;

/** A drawing joined from its parts. */
typedef struct roberts_joined {
    roberts_drawing drawing; /**< as roberts_hide() returns it, but most counts are 0 */
    roberts_inputs input;    /**< the models, named as they were given */
    bool has_names;          /**< some input has named groups, which a joined drawing does not keep */
    char *names;             /**< private */
} roberts_joined;

/**
 * Plans a scene so that programs which share nothing else can draw parts of it: writes to `path` all bodies and where
 * they lie in the picture. The inputs are read one after the other, and only one is in memory at a time.
 * All bodies have to be closed and share no vertices; faces may have any shape. Anything that needs the whole scene is
 * refused: open bodies (they are welded with others), repeated corners, hulls, sections, and a near plane that cuts the
 * scene.
 * Returns ROBERTS_OK, _NO_MEMORY, _IO, _BAD_SYNTAX, _BAD_INDEX, _BAD_NUMBER, _NOT_CLOSED, _BAD_VIEW or _BAD_ARGUMENT;
 * with task->scene.solids also what roberts_scene_build() returns.
 */
roberts_status roberts_plan_save(const roberts_inputs *input, const roberts_task *task, const char *path,
                                 roberts_error *error);

/**
 * Draws one part: writes the segments of its bodies to `path`. Parts have about the same number of vertices, and the
 * bodies of a part lie close together in the picture. Memory holds the bodies of the part, and those whose box in the
 * picture meets what its bodies may touch.
 * input  one plan, made for the same task; or models, which are planned first, in an unnamed file beside `path`
 * Returns what roberts_plan_save() returns; _BAD_ARGUMENT also for a plan of another task, or an impossible share.
 */
roberts_status roberts_part_save(const roberts_inputs *input, const roberts_task *task, roberts_share share,
                                 const char *path, roberts_error *error);

/**
 * Joins all parts of one drawing, named in any order. Pages and tables written from `joined->drawing` are the same,
 * byte for byte, as those of a single roberts_hide(). It needs no scene: it stores the faces and ends of edges itself.
 * joined  owned by the caller, released by roberts_joined_free(); empty on failure
 * Returns ROBERTS_OK, _NO_MEMORY, _IO, _BAD_SYNTAX (no part, unfinished or broken) or _BAD_ARGUMENT (parts that do not
 * belong together, of another task, missing or given twice).
 */
roberts_status roberts_join(const roberts_inputs *part, const roberts_task *task, roberts_joined *joined,
                            roberts_error *error);
void roberts_joined_free(roberts_joined *joined);

#ifdef __cplusplus
}
#endif

#endif
