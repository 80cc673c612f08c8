/* seen.h - a scene as one camera sees it: everything that `hide` and `ray` read of it.
 *
 * `scene` is what the near plane leaves of the given scene. View points and the facing of faces are computed on demand,
 * body by body: a body that is never needed is never mapped. Lines are not stored at all. A walk goes through the lines
 * of one body and gives each with its class, its ends and its own faces.
 *
 * A face does not hide the lines that lie in it. So each face has a key, and a line lists the keys of its own faces:
 *
 *   - all faces of a convex body have one key, that of the body: none of them hides an edge with a front face;
 *   - the pieces of one planar face of another body share a key, their scene_plane_number().
 *
 * A line need not be an edge. A line where two faces cross has no edge, its ends may be computed points, and its own
 * keys may belong to faces of two bodies.
 *
 * If bodies are taken together as one (united.h), some pieces of an edge are not lines, and others have a class of
 * their own. The line is still the whole edge, with a list of its pieces, so that its hiders are found only once. */
#ifndef ROBERTS_VIEW_SEEN_H
#define ROBERTS_VIEW_SEEN_H

#include "base/bits.h"
#include "view/clip.h"
#include "view/united.h"
#include "view/view.h"

/* Which edges are lines. */
typedef struct seen_rules {
    double crease_chord; /* two faces are flat if the squared distance of their unit normals is less than this */
    double smooth_chord; /* the same limit for bodies that count as curved */
    bool all_edges;      /* edges of flat faces are lines too */
    bool left_out;       /* edges of flat faces are lines that are marked as left out */
    bool hidden;         /* edges that their own convex body hides, or that the near plane removes, are lines too */
} seen_rules;

/* Lines that are not edges, body by body: line[first[body]] .. line[first[body + 1] - 1] follow the edges of their
 * body. NULL: none. The caller that sets them also frees them. */
typedef struct seen_further {
    const struct seen_line *line;
    const uint32_t *first; /* [solid_count of scene + 1] */
} seen_further;

/* What is known of a face before lines are hidden. */
typedef enum seen_sight {
    SEEN_SOMEWHERE, /* perhaps */
    SEEN_WHOLE,
    SEEN_NOWHERE,
} seen_sight;

typedef struct seen {
    const roberts_scene *source; /* the given scene: rows name its vertices and edges */
    const roberts_scene *scene;  /* the same, or what the near plane leaves of it */
    view view;
    view_clip clip;
    seen_rules rules;
    seen_further further;
    union_bodies bodies;   /* with a union: the bodies ... */
    united edges;          /* ... and their edges; zeroed: no union */
    uint8_t *sight;        /* [face_count of scene] seen_sight; NULL: nothing is known of any. See hide/bare_faces.h */
    roberts_vec3 *P;       /* [vertex_count of scene] view points of the bodies that are mapped */
    unsigned char *facing; /* [face_count of scene] VIEW_FRONT, _BACK or _EDGE_ON, for the bodies that are mapped */
    uint32_t *turned;      /* [corners of scene] reversed corners of faces seen from behind, if these have more than
                              SEEN_TURNED corners; NULL: all bodies are convex */
} seen;

/* Clips the scene and prepares its view; epsilon: as for view_prepare(). Returns ROBERTS_OK, _NO_MEMORY, _BAD_VIEW or
 * _BAD_ARGUMENT; after a failure `s` is empty. Points and lines also need seen_begin_points(), and lines
 * seen_set_rules(). */
roberts_status seen_begin(seen *s, const roberts_scene *scene, const roberts_camera *camera, double epsilon,
                          roberts_error *error);
void seen_end(seen *s);

/* Makes room for view points and facings. False: no memory. */
bool seen_begin_points(seen *s);

/* Sets which edges are lines. */
void seen_set_rules(seen *s, const roberts_hide_options *options);

/* Treats all bodies as one, with at most `threads` threads. The facings of mapped bodies must be known. culled:
 * [solid_count] 1: no walk will visit this body. False: no memory. */
bool seen_unite(seen *s, const unsigned char *culled, uint32_t threads);

/* ---- faces ----------------------------------------------------------------------------------------------------- */

/* A convex piece of a face as the viewer sees it. */
typedef struct seen_face {
    plane F;                /* in view space; the normal points away from the viewer */
    double stretch;         /* see view_plane() */
    const uint32_t *corner; /* [count] counter-clockwise in the picture */
    uint32_t count;
} seen_face;

/* Maps the vertices of first .. end - 1 that lie where the near plane of a perspective has cut the scene. */
void seen_map_cuts(seen *s, uint32_t first, uint32_t end);

/* Maps the points of a body. */
static inline void seen_map_body(seen *s, uint32_t body)
{
    uint32_t first = s->scene->solid[body].vertex, end = s->scene->solid[body + 1].vertex;
    view_points(&s->view, s->scene->point + first, end - first, s->P + first);
    if (s->clip.clipped && s->view.perspective)
        seen_map_cuts(s, first, end);
}

/* Returns the facing of a face of a convex body that is mapped. Fills `out` if it is VIEW_FRONT. */
BITS_INLINE int seen_front_face(seen *s, uint32_t face, seen_face *out)
{
    const roberts_scene *scene = s->scene;
    out->stretch = 1.0;
    int facing = view_face(&s->view, scene, face, s->P, &out->F, &out->stretch);
    s->facing[face] = (unsigned char)facing;
    out->corner = scene->corner + scene->face_start[face];
    out->count = scene->face_start[face + 1] - scene->face_start[face];
    return facing;
}

/* Faces of up to this many corners that are seen from behind are turned over whenever they are needed. In a mesh, most
 * are never needed. */
enum { SEEN_TURNED = 3 };

/* Returns the corners of a face whose facing is known, counter-clockwise in the picture. They are in `turned` if the
 * face is seen from behind and has no more than SEEN_TURNED corners. */
static inline const uint32_t *seen_corners(const seen *s, uint32_t face, uint32_t *count, uint32_t turned[SEEN_TURNED])
{
    const roberts_scene *scene = s->scene;
    uint32_t first = scene->face_start[face];
    *count = scene->face_start[face + 1] - first;
    if (s->facing[face] != VIEW_BACK)
        return scene->corner + first;
    if (*count > SEEN_TURNED)
        return s->turned + first;
    for (uint32_t i = 0; i < *count; i++)
        turned[i] = scene->corner[first + *count - 1 - i];
    return turned;
}

/* Finds the facing of a face of any other body that is mapped, and turns its corners toward the viewer. */
int seen_any_face(seen *s, uint32_t face);

/* The same. The facing of nearly all faces of a mesh is plain. */
static inline int seen_either_face(seen *s, uint32_t face)
{
    const roberts_scene *scene = s->scene;
    int facing = VIEW_UNKNOWN;
    if (!scene->face_plane)
        facing = view_facing_of_triangle(&s->view, scene->corner + scene->face_start[face], s->P);
    if (facing == VIEW_UNKNOWN)
        return seen_any_face(s, face);
    s->facing[face] = (unsigned char)facing;
    return facing;
}

/* Fills `out` with such a face, turned toward the viewer, and returns its shape in the model. turned: as in
 * seen_corners(). */
scene_shape seen_face_again(const seen *s, uint32_t face, seen_face *out, uint32_t turned[SEEN_TURNED]);

/* ---- keys ------------------------------------------------------------------------------------------------------ */

#define SEEN_KEYS 4           /* two edges with two faces each may lie on one another */
#define SEEN_BODY 0x80000000u /* flag in the key of a convex body: there are fewer than 2^31 bodies, and faces */

static inline uint32_t seen_body_key(uint32_t body)
{
    return body | SEEN_BODY;
}

static inline uint32_t seen_face_key(const roberts_scene *scene, uint32_t body, uint32_t face)
{
    return scene_is_convex(scene, body) ? seen_body_key(body) : scene_plane_number(scene, face);
}

/* The faces that do not hide a line because it lies in them. */
typedef struct seen_own {
    uint32_t key[SEEN_KEYS]; /* ROBERTS_NONE: none */
    const scene_many *many;  /* for an edge with more than two faces: all of them; otherwise NULL */
} seen_own;

/* A single face, which may be ROBERTS_NONE. */
static inline seen_own seen_owns_one(uint32_t key)
{
    return (seen_own){{key, ROBERTS_NONE, ROBERTS_NONE, ROBERTS_NONE}, NULL};
}

/* Returns the faces in whose planes an edge of seen.scene lies. Its body is not convex. */
seen_own seen_own_of(const roberts_scene *scene, uint32_t body, uint32_t edge);

/* Is this the key of one of them? */
static inline bool seen_owns(const roberts_scene *scene, const seen_own *own, uint32_t key)
{
    const scene_surface *surface = scene->surface;
    const scene_many *many = own->many;
    bool found = own->key[0] == key || own->key[1] == key || own->key[2] == key || own->key[3] == key;
    for (uint32_t k = many ? many->first : 0; many && k < many->end && !found; k++)
        found = scene_plane_number(scene, surface->many_face[k] & ~MANY_TURNED) == key;
    return found;
}

/* ---- lines ----------------------------------------------------------------------------------------------------- */

/* A computed point of the model: the sum of both vectors. */
typedef struct seen_point {
    roberts_vec3 point, low;
} seen_point;

/* Which parts of a line's edge the near plane has removed, for walks that include them. */
enum {
    SEEN_TAKEN_BEFORE = 1, /* the part before t0 */
    SEEN_TAKEN_AFTER = 2,  /* the part after t1 */
    SEEN_TAKEN = 4,        /* all of it: no end is set */
};

typedef struct seen_line {
    uint32_t edge;         /* edge of seen.source; ROBERTS_NONE: the line is not an edge */
    uint32_t v[2];         /* ends, vertices of seen.scene; ROBERTS_NONE: a computed point */
    const seen_point *end; /* [2] computed ends, never NULL if the line is not an edge; NULL: both ends are vertices */
    seen_own own;          /* its own faces: they do not hide it */
    double t0, t1;         /* the part of its edge that the line covers */
    roberts_line class;
    unsigned taken;           /* SEEN_TAKEN... */
    bool left_out;            /* the drawing does not have the line, because its faces are flat */
    bool alone;               /* pieces that the union does not change belong to the line, with its class */
    bool sheet;               /* a sheet meets closed bodies in it: of its pieces, those are drawn that are no edges */
    const union_piece *piece; /* pieces of the line, up to t1 == 1; NULL: the whole line has one class */
    const union_side *side;   /* base index of the pieces' sides */
} seen_line;

/* Gives a line its pieces, those of line `index` of `of`. False: none of them is drawn. */
bool seen_take_pieces(const seen *s, uint32_t body, const united *of, uint32_t index, seen_line *line);

/* Finds the class of a piece of a line that has pieces. False: the piece is not part of the line. */
bool seen_piece_class(const seen *s, uint32_t body, const seen_line *line, const union_piece *piece,
                      roberts_line *class);

/* The name of an edge of seen.source in the rows of a table: t0..t1 of the edge between two vertices of the input. */
typedef struct seen_name {
    uint32_t v[2]; /* numbers in the input; ROBERTS_NONE: the line is not an edge */
    double t0, t1; /* 0 and 1, unless an edge of the file has been divided */
} seen_name;

/* Returns the name of an edge, or of a line. */
seen_name seen_edge_name(const roberts_scene *source, uint32_t body, uint32_t edge);
seen_name seen_slow_name(const seen *s, uint32_t body, const seen_line *line);

/* Returns the name of a line; if nothing is divided, from the ends at hand. */
static inline seen_name seen_line_name(const seen *s, uint32_t body, const seen_line *line)
{
    const roberts_scene *source = s->source;
    if (s->clip.clipped || line->end || !scene_is_convex(source, body))
        return seen_slow_name(s, body, line);
    return (seen_name){{scene_vertex_number(source, line->v[0]), scene_vertex_number(source, line->v[1])}, 0.0, 1.0};
}

/* Returns the part of an edge of seen.source that the near plane leaves. */
static inline clip_edge seen_left_of(const seen *s, uint32_t edge)
{
    return s->clip.clipped ? s->clip.origin[edge] : (clip_edge){edge, 0.0, 1.0};
}

/* Is it known of both faces of an edge that they are seen whole, or that they are seen nowhere? Then the edge bounds
 * nothing but the pictures of these faces. first: the first face of its body, which is not convex. */
static inline bool seen_has_known_faces(const seen *s, uint32_t first, const scene_edge *edge)
{
    return s->sight && edge->f[0] != ROBERTS_NONE && edge->f[1] != ROBERTS_NONE &&
           s->sight[first + edge->f[0]] != SEEN_SOMEWHERE && s->sight[first + edge->f[1]] != SEEN_SOMEWHERE;
}

/* A walk through the lines of one body, in the order of its edges. */
typedef struct seen_walk {
    const seen *of;
    uint32_t body;
    uint32_t edge, end; /* edges of seen.source: the next one; the end */
    uint32_t key;       /* for a convex body, the one key of own faces of all its lines; otherwise ROBERTS_NONE */
    bool slow;          /* a body that is not convex, a scene that the near plane has clipped, or a union */
    bool passing;       /* seen_pass_flat() may be called */
    bool hidden, all, left_out; /* as in seen_rules */
    bool asked, any;            /* has seen_decide_narrow() looked for front faces, and found any? */
    size_t surviving; /* number of edges visited that have a face toward the viewer; the caller sets it to 0 */
    /* the body's first in seen.scene: */
    const scene_edge *stored;
    const unsigned char *facing;
    uint32_t vertex, face;
} seen_walk;

/* Begins a walk. The body's points must be mapped and its faces classified, unless the near plane has removed all of
 * it. */
seen_walk seen_walk_slowly(const seen *s, uint32_t body);

static inline seen_walk seen_walk_begin(const seen *s, uint32_t body)
{
    const roberts_scene *scene = s->scene;
    const scene_solid *own = &scene->solid[body];
    if (s->clip.clipped || s->edges.first || !scene_is_convex(scene, body))
        return seen_walk_slowly(s, body);
    return (seen_walk){.of = s,
                       .body = body,
                       .key = seen_body_key(body),
                       .edge = own->edge,
                       .end = own[1].edge,
                       .hidden = s->rules.hidden,
                       .all = s->rules.all_edges,
                       .left_out = s->rules.left_out,
                       .stored = scene->edge + own->stored,
                       .facing = s->facing + own->face,
                       .vertex = own->vertex,
                       .face = own->face};
}

/* Do corners of faces and ends of edges have the same numbers, and does no vertex lie on a side of a face? Then each
 * side of a face is an edge. The scene has bodies that are not convex. */
static inline bool seen_has_plain_edges(const seen *s)
{
    const scene_surface *surface = s->scene->surface;
    const bool pieces = s->clip.clipped ? s->clip.pieces : surface->plane_of != NULL;
    return !pieces && surface->part_count == 0 && surface->many_count == 0;
}

/* Is the face part of a cap, by which a body is closed where the near plane cuts it? Besides caps, only faces of hulls
 * have no number, and their corners are in the input. */
static inline bool seen_is_cap(const roberts_scene *scene, uint32_t face)
{
    return scene_face_number(scene, face) == ROBERTS_NONE &&
           scene_vertex_number(scene, scene->corner[scene->face_start[face]]) == ROBERTS_NONE;
}

/* Does an edge of a body that is not convex have one face on its left in the picture and one on its right? facing: of
 * the faces of its body. is: its entry of scene_surface.edge_is. */
static inline bool seen_joins_faces(const unsigned char *facing, const scene_edge *edge, uint8_t is)
{
    if (edge->f[1] == ROBERTS_NONE || is & EDGE_MANY)
        return false;
    unsigned f = facing[edge->f[0]], g = facing[edge->f[1]], turned = (is / EDGE_TURNED_0 ^ is / EDGE_TURNED_1) & 1;
    return (f != VIEW_EDGE_ON) & (g != VIEW_EDGE_ON) & ((f == g) == turned); /* few branches: most edges come here */
}

/* Returns the class of an edge of a convex body from the facing of its two faces. fronts: how many of them are
 * front. */
static inline roberts_line seen_class(int fronts, int f, int g)
{
    if (fronts > 0)
        return fronts == 1 ? ROBERTS_OUTLINE : ROBERTS_CREASE;
    return f == VIEW_BACK && g == VIEW_BACK ? ROBERTS_BACK : ROBERTS_BACK_OUTLINE;
}

/* Is this the class of an edge that its own body hides? */
static inline bool seen_is_back(roberts_line class)
{
    return class == ROBERTS_BACK || class == ROBERTS_BACK_OUTLINE;
}

static inline int seen_fronts(const unsigned char *facing, const scene_edge *edge)
{
    return (facing[edge->f[0]] == VIEW_FRONT) + (facing[edge->f[1]] == VIEW_FRONT);
}

/* Is the edge of a convex body flatter than the crease angle? Compares the normals in the model, which perspective does
 * not bend. first: the first face of the body. */
static inline bool seen_is_flat(const roberts_scene *scene, uint32_t first, const scene_edge *edge, double chord)
{
    const plane F = scene->face_plane[first + edge->f[0]], G = scene->face_plane[first + edge->f[1]];
    const double a = F.a - G.a, b = F.b - G.b, c = F.c - G.c, own = a * a + b * b + c * c;
    return (a * a < chord && own < chord) ||
           (scene_step(scene) > 0.0 && own < scene_flat_below(scene, first + edge->f[0], first + edge->f[1], chord));
}

/* An edge of a convex body has a face that is edge-on. If that face is narrow by itself, the sign of its plane replaces
 * its facing. *f, *g: the facing of the edge's faces. (lines.c) */
void seen_decide_narrow(seen_walk *w, const scene_edge *edge, int *f, int *g);

/* Finds the line of an edge of a convex body, as stored in seen.scene. An edge with exactly one front face is an
 * outline and always a line. An edge whose faces are both front or both not is no line if it is flat. */
BITS_INLINE bool seen_solid_line(seen_walk *w, const scene_edge *edge, seen_line *line)
{
    int f = w->facing[edge->f[0]], g = w->facing[edge->f[1]];
    if ((f == VIEW_EDGE_ON) | (g == VIEW_EDGE_ON))
        seen_decide_narrow(w, edge, &f, &g);
    int fronts = (f == VIEW_FRONT) + (g == VIEW_FRONT);
    w->surviving += fronts > 0;
    if (fronts == 0 && !w->hidden)
        return false;
    line->left_out = fronts != 1 && !w->all && seen_is_flat(w->of->scene, w->face, edge, w->of->rules.crease_chord);
    if (line->left_out && !w->left_out)
        return false;
    line->v[0] = w->vertex + edge->v[0];
    line->v[1] = w->vertex + edge->v[1];
    line->end = NULL;
    line->own = seen_owns_one(w->key);
    line->t0 = 0.0;
    line->t1 = 1.0;
    line->class = seen_class(fronts, f, g);
    line->taken = 0;
    line->piece = NULL;
    return true;
}

/* Is the edge of seen.scene left out because its faces are flat, or nearly flat, to one another? Its body is mapped. */
bool seen_is_left_out(const seen *s, uint32_t body, uint32_t edge);

/* Passes edges of a mesh that are certainly no lines. Most edges of a fine mesh are of this kind. */
void seen_pass_flat(seen_walk *w);

/* Finds the line of edge `edge` of the walk's body. False: the edge is not a line. */
bool seen_slow_line(seen_walk *w, uint32_t edge, seen_line *line);

/* Finds the next line. False: at the end. slow: w->slow. */
BITS_INLINE bool seen_next(seen_walk *w, seen_line *line, bool slow)
{
    while (w->edge < w->end) {
        if (slow && w->passing) {
            seen_pass_flat(w);
            if (w->edge == w->end)
                return false;
        }
        line->edge = w->edge++;
        if (slow ? seen_slow_line(w, line->edge, line) : seen_solid_line(w, w->stored++, line))
            return true;
    }
    return false;
}

/* Finds a line again that a walk through a convex body has given before. */
static inline void seen_again(seen_walk *w, uint32_t edge, seen_line *line)
{
    line->edge = edge;
    if (w->slow) {
        seen_slow_line(w, edge, line);
        return;
    }
    w->all = w->all || !w->left_out; /* it is not flat, or flat edges are wanted */
    seen_solid_line(w, w->stored + (edge - w->edge), line);
}

#endif
