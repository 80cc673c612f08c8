/* lines.c - which edges are lines, and their classes, for bodies that are not convex, scenes that the near plane cuts,
 * and --union. Edges of convex solids are handled in seen.h, inline. */
#include "view/seen.h"

#include <float.h>
#include <string.h>

#include "base/sort.h"

/* No unit: a face is edge-on if the depth of its normal is at most this, a few roundings. */
#define EDGE_ON_NORMAL (8.0 * DBL_EPSILON)

/* How many faces of an edge lie on each side of it in the picture. */
typedef struct edge_faces {
    unsigned left, right;
    bool flat; /* all within the crease angle of one plane */
} edge_faces;

/* The facing of a face of seen.source in a parallel view, or of a culled body. The depth of the normal decides, in
 * relation to the width of the face. */
static int facing_of_normal(const seen *s, uint32_t face)
{
    double stretch;
    const plane F = view_plane(&s->view, s->source, face, &stretch);
    if (fabs(F.c) * scene_width(s->source, face) <= s->view.epsilon * s->view.unit)
        return VIEW_EDGE_ON;
    return F.c < 0.0 ? VIEW_FRONT : VIEW_BACK;
}

/* The facing of a face of seen.scene, or of seen.source if that is another: then in perspective the face is compared
 * with the eye. */
static int facing_of_face(const seen *s, const roberts_scene *scene, uint32_t face)
{
    const view *v = &s->view;
    if (scene == s->scene)
        return s->facing[face];
    if (!v->perspective)
        return facing_of_normal(s, face);
    double inside = plane_at(scene_plane(scene, face), vec3_sub(v->viewpoint, scene->centre));
    return fabs(inside) <= v->epsilon * v->unit ? VIEW_EDGE_ON : inside < 0.0 ? VIEW_FRONT : VIEW_BACK;
}

/* `turned`: the face lies on the right of the edge. A face that is edge-on lies on neither side. */
static void add_edge_face(int facing, bool turned, edge_faces *to)
{
    if (facing == VIEW_EDGE_ON)
        return;
    if ((facing == VIEW_FRONT) != turned)
        to->left++;
    else
        to->right++;
}

/* Do all faces lie on one side? */
static bool is_fold(const edge_faces *faces)
{
    return (faces->left == 0) != (faces->right == 0);
}

/* Do two faces of an edge meet at the crease angle or less, both as a whole and in the pieces that meet there? way: -1
 * if they are wound differently. */
static bool are_flat(const roberts_scene *scene, uint32_t f, uint32_t g, double way, double crease)
{
    const double most = scene_flat_below(scene, f, g, crease);
    return scene_chord(scene_plane(scene, f), scene_plane(scene, g), way) < most &&
           (!scene_has_bent_faces(scene) ||
            scene_chord(scene_whole_plane(scene, f), scene_whole_plane(scene, g), way) < most);
}

/* Does a face lie within the crease angle of the first one, or of its back? */
static bool is_flat_with(const roberts_scene *scene, uint32_t first, uint32_t face, double crease)
{
    return are_flat(scene, first, face, 1.0, crease) || are_flat(scene, first, face, -1.0, crease);
}

/* May rounding have turned a needle so far that it is seen from the wrong side? */
static bool is_uncertain(const seen *s, const roberts_scene *scene, const scene_needle *needle)
{
    const view *v = &s->view;
    const plane F = scene_plane(scene, needle->face);
    roberts_vec3 along = v->viewpoint;
    if (v->perspective)
        along = vec3_sub(along, scene->point[scene->corner[scene->face_start[needle->face]]]);
    const double height = F.a * along.x + F.b * along.y + F.c * along.z;
    return needle->turn > SCENE_ROUNDED_BEND || fabs(height) < (double)needle->turn * vec3_length(along);
}

/* The face that decides which side of a face is seen, and how it bends: another one if it is a needle, and the view or
 * the width of the needle leaves doubt. *way: -1 if that face is wound the other way. */
static uint32_t deciding_face(const seen *s, const roberts_scene *scene, uint32_t face, double *way)
{
    const scene_surface *surface = scene->surface;
    const size_t at = find_numbered(surface->needle, surface->needle_count, sizeof *surface->needle, face);
    *way = 1.0;
    if (at == surface->needle_count)
        return face;
    const scene_needle *needle = &surface->needle[at];
    if (needle->face != face || needle->stand_in == ROBERTS_NONE || !is_uncertain(s, scene, needle))
        return face;
    *way = needle->way;
    return needle->stand_in;
}

/* The same as faces_of_edge() for an edge that has a needle. */
static edge_faces faces_of_needle(const seen *s, const roberts_scene *scene, const uint32_t face[2], uint8_t is,
                                  double crease)
{
    edge_faces found = {0};
    double way[2];
    const uint32_t f = deciding_face(s, scene, face[0], &way[0]), g = deciding_face(s, scene, face[1], &way[1]);
    add_edge_face(facing_of_face(s, scene, f), ((is & EDGE_TURNED_0) != 0) != (way[0] < 0.0), &found);
    add_edge_face(facing_of_face(s, scene, g), ((is & EDGE_TURNED_1) != 0) != (way[1] < 0.0), &found);
    found.flat = are_flat(scene, f, g, scene_way(is) * way[0] * way[1], crease);
    return found;
}

/* Do the two faces of edge `e` meet at the crease angle or less? first: the first face of its body. */
static bool is_flatter(const roberts_scene *scene, uint32_t first, const scene_edge *edge, uint32_t e, double crease)
{
    const scene_surface *surface = scene->surface;
    const int order = surface->bend ? surface->bend[e] - scene_bend_code(crease) : 0;
    if (order < 0 || (order > 0 && !(scene_step(scene) > 0.0)))
        return order < 0;
    return are_flat(scene, first + edge->f[0], first + edge->f[1], scene_way(surface->edge_is[e]), crease);
}

/* The faces of edge `e` of the body in `scene`, which has one or two; `flat` is not set. */
static edge_faces sides_of_edge(const seen_walk *w, const roberts_scene *scene, const scene_edge *edge, uint32_t e)
{
    edge_faces found = {0};
    uint32_t first = scene->solid[w->body].face;
    uint8_t is = scene->surface->edge_is[e];
    add_edge_face(facing_of_face(w->of, scene, first + edge->f[0]), is & EDGE_TURNED_0, &found);
    if (edge->f[1] != ROBERTS_NONE)
        add_edge_face(facing_of_face(w->of, scene, first + edge->f[1]), is & EDGE_TURNED_1, &found);
    return found;
}

/* The same with `flat`. */
static edge_faces faces_of_edge(const seen_walk *w, const roberts_scene *scene, const scene_edge *edge, uint32_t e,
                                double crease)
{
    const uint8_t is = scene->surface->edge_is[e];
    const uint32_t first = scene->solid[w->body].face;
    if (is & EDGE_NEEDLE)
        return faces_of_needle(w->of, scene, (uint32_t[]){first + edge->f[0], first + edge->f[1]}, is, crease);
    edge_faces found = sides_of_edge(w, scene, edge, e);
    if (edge->f[1] != ROBERTS_NONE)
        found.flat = is_flatter(scene, first, edge, e, crease);
    return found;
}

/* The faces of an edge that has more than two. */
static edge_faces faces_of_many(const seen *s, const roberts_scene *scene, const scene_many *many, double crease)
{
    const uint32_t *face = scene->surface->many_face;
    edge_faces found = {.flat = true};
    for (uint32_t k = many->first; k < many->end; k++) {
        uint32_t f = face[k] & ~MANY_TURNED;
        add_edge_face(facing_of_face(s, scene, f), face[k] & MANY_TURNED, &found);
        for (uint32_t i = many->first; i < k && found.flat; i++) /* any two: within an angle is not transitive */
            found.flat = is_flat_with(scene, face[i] & ~MANY_TURNED, f, crease);
    }
    return found;
}

/* Is a cut through faces that are not planar an outline? It is if one of them folds there. If several have the cut,
 * each has its own pieces, which follow one another. */
static bool is_folded_cut(const seen_walk *w, const roberts_scene *scene, uint32_t e)
{
    const scene_edge *edge = scene_edge_stored(scene, w->body, e);
    if (edge->f[1] == ROBERTS_NONE)
        return false;
    if (!(scene->surface->edge_is[e] & EDGE_MANY)) {
        const edge_faces faces = sides_of_edge(w, scene, edge, e);
        return is_fold(&faces);
    }
    const scene_many *many = scene_many_at(scene, e);
    const uint32_t *piece = scene->surface->many_face;
    for (uint32_t k = many->first, next; k < many->end; k = next) {
        const uint32_t face = scene_face_number(scene, piece[k] & ~MANY_TURNED);
        edge_faces found = {0};
        for (next = k; next < many->end && scene_face_number(scene, piece[next] & ~MANY_TURNED) == face; next++)
            add_edge_face(facing_of_face(w->of, scene, piece[next] & ~MANY_TURNED), piece[next] & MANY_TURNED, &found);
        if (next - k > 1 && is_fold(&found))
            return true;
    }
    return false;
}

/* The squared distance of normals below which two faces of the body count as flat. */
static double crease_of(const seen *s, uint32_t body)
{
    return s->source->surface->smooth[body] ? s->rules.smooth_chord : s->rules.crease_chord;
}

/* Is edge `e` a line? If so, its class is set. `scene` is seen.scene or seen.source. */
static bool classify(const seen_walk *w, const roberts_scene *scene, uint32_t e, seen_line *line)
{
    const seen *s = w->of;
    const scene_edge *edge = scene_edge_stored(scene, w->body, e);
    uint8_t is = scene->surface->edge_is[e];
    double crease = crease_of(s, w->body);
    line->class = ROBERTS_WIRE;
    line->left_out = false;
    if (edge->f[0] == ROBERTS_NONE)
        return true;
    if (is & EDGE_CUT) {
        const bool folded = is_folded_cut(w, scene, e);
        line->class = ROBERTS_OUTLINE;
        if (folded || !(is & EDGE_MANY)) /* else several faces are cut along it: it is an edge of several faces */
            return folded;
    }
    edge_faces faces = is & EDGE_MANY ? faces_of_many(s, scene, scene_many_at(scene, e), crease)
                                      : faces_of_edge(w, scene, edge, e, crease);
    bool border = edge->f[1] == ROBERTS_NONE, fold = is_fold(&faces);
    line->class = border ? ROBERTS_BORDER : !fold && faces.left > 0 ? ROBERTS_CREASE : ROBERTS_OUTLINE;
    line->left_out = !border && !fold && faces.flat && !s->rules.all_edges;
    return !line->left_out || s->rules.left_out;
}

seen_own seen_own_of(const roberts_scene *scene, uint32_t body, uint32_t edge)
{
    const scene_surface *surface = scene->surface;
    const scene_edge *e = scene_edge_stored(scene, body, edge);
    seen_own own = seen_owns_one(ROBERTS_NONE);
    for (int k = 0; k < 2; k++)
        if (e->f[k] != ROBERTS_NONE)
            own.key[k] = scene_plane_number(scene, scene->solid[body].face + e->f[k]);
    if (surface->edge_is[edge] & EDGE_MANY)
        own.many = scene_many_at(scene, edge);
    return own;
}

/* The line of edge `e` of seen.scene, of a body that is not convex. False: it is no line. */
static bool surface_line(seen_walk *w, uint32_t e, const scene_edge *edge, seen_line *line)
{
    const seen *s = w->of;
    const roberts_scene *scene = s->scene;
    uint8_t is = scene->surface->edge_is[e];
    bool joins = (w->all || w->left_out) && !(is & (EDGE_CUT | EDGE_NEEDLE)) && seen_joins_faces(w->facing, edge, is);
    line->class = ROBERTS_CREASE; /* most lines are of this kind if all edges are taken */
    line->left_out = joins && !w->all && is_flatter(scene, scene->solid[w->body].face, edge, e, crease_of(s, w->body));
    bool is_line = joins || classify(w, scene, e, line);
    if (line->left_out && seen_has_known_faces(s, w->face, edge))
        return false;
    line->v[0] = w->vertex + edge->v[0];
    line->v[1] = w->vertex + edge->v[1];
    line->end = NULL;
    line->own = seen_own_of(scene, w->body, e);
    line->taken = 0;
    line->piece = NULL;
    w->surviving += is_line && !line->left_out;
    return is_line;
}

/* The facing of a face that is edge-on, if its picture is narrow because the face is: then the body gave it a plane
 * that fits its neighbours. */
static int facing_of_narrow(const seen *s, uint32_t face)
{
    const view *v = &s->view;
    if (scene_width(s->scene, face) > v->epsilon * v->unit)
        return VIEW_EDGE_ON;
    const double depth = view_plane(v, s->scene, face, NULL).c;
    return fabs(depth) <= EDGE_ON_NORMAL ? VIEW_EDGE_ON : depth < 0.0 ? VIEW_FRONT : VIEW_BACK;
}

/* A body that is smaller than epsilon in the picture has no lines. */
void seen_decide_narrow(seen_walk *w, const scene_edge *edge, int *f, int *g)
{
    if (!w->asked)
        w->any = memchr(w->facing, VIEW_FRONT, w->of->scene->solid[w->body + 1].face - w->face);
    w->asked = true;
    if (!w->any)
        return;
    if (*f == VIEW_EDGE_ON)
        *f = facing_of_narrow(w->of, w->face + edge->f[0]);
    if (*g == VIEW_EDGE_ON)
        *g = facing_of_narrow(w->of, w->face + edge->f[1]);
}

/* Would an edge of a convex body that the near plane has completely removed be a line? Sets its class. */
static bool taken_of_solid(const seen_walk *w, seen_line *line)
{
    const roberts_scene *source = w->of->source;
    const scene_edge *edge = scene_edge_stored(source, w->body, line->edge);
    uint32_t first = source->solid[w->body].face;
    int f = facing_of_face(w->of, source, first + edge->f[0]), g = facing_of_face(w->of, source, first + edge->f[1]);
    line->class = seen_class((f == VIEW_FRONT) + (g == VIEW_FRONT), f, g);
    return line->class == ROBERTS_OUTLINE || w->all || !seen_is_flat(source, first, edge, w->of->rules.crease_chord);
}

/* The line of an edge without a union. False: it is no line. For bodies that are not convex, everything but the class
 * is set even then. */
static bool lone_line(seen_walk *w, uint32_t edge, seen_line *line)
{
    const roberts_scene *scene = w->of->scene;
    clip_edge left = seen_left_of(w->of, edge);
    bool convex = w->key != ROBERTS_NONE;
    if (left.edge == ROBERTS_NONE || left.t0 >= left.t1) { /* equal: it ends on the near plane, to rounding */
        *line = (seen_line){.edge = edge,
                            .v = {ROBERTS_NONE, ROBERTS_NONE},
                            .own = seen_owns_one(w->key),
                            .t1 = 1.0,
                            .taken = SEEN_TAKEN};
        return w->hidden && (convex ? taken_of_solid(w, line) : classify(w, w->of->source, edge, line));
    }
    const scene_edge *stored = scene_edge_stored(scene, w->body, left.edge);
    bool is_line = convex ? seen_solid_line(w, stored, line) : surface_line(w, left.edge, stored, line);
    line->t0 = left.t0;
    line->t1 = left.t1;
    if (w->hidden)
        line->taken = (left.t0 > 0.0 ? SEEN_TAKEN_BEFORE : 0u) | (left.t1 < 1.0 ? SEEN_TAKEN_AFTER : 0u);
    return is_line;
}

bool seen_is_left_out(const seen *s, uint32_t body, uint32_t edge)
{
    const roberts_scene *scene = s->scene;
    const scene_edge *e = scene_edge_stored(scene, body, edge);
    uint32_t first = scene->solid[body].face;
    const seen_walk walk = {.of = s, .body = body};
    seen_line line;
    if (e->f[1] == ROBERTS_NONE || (s->clip.clipped && s->clip.cap[edge]))
        return false;
    if (scene_is_convex(scene, body))
        return !s->rules.all_edges && seen_fronts(s->facing + first, e) != 1 &&
               seen_is_flat(scene, first, e, s->rules.crease_chord);
    return !classify(&walk, scene, edge, &line) || line.left_out;
}

/* ---- bodies taken together as one ------------------------------------------------------------------------------ */

/* The facing of a face of seen.source. It is not stored for a culled body. */
static int facing_of_side(const seen *s, uint32_t face)
{
    return s->scene != s->source || s->facing[face] ? facing_of_face(s, s->source, face) : facing_of_normal(s, face);
}

/* Counts the sides of a piece as the faces of an edge. Below `crease` they are flat. */
static edge_faces faces_of_piece(const seen *s, const union_side *side, uint32_t count, double crease)
{
    edge_faces found = {.flat = true};
    for (uint32_t i = 0; i < count; i++) {
        add_edge_face(facing_of_side(s, side[i].face), side[i].turned, &found);
        for (uint32_t k = 0; k < i && found.flat; k++)
            found.flat = count > 2 ? is_flat_with(s->source, side[k].face, side[i].face, crease)
                                   : are_flat(s->source, side[0].face, side[1].face,
                                              side[0].turned != side[1].turned ? 1.0 : -1.0, crease);
    }
    return found;
}

bool seen_piece_class(const seen *s, uint32_t body, const seen_line *line, const union_piece *piece,
                      roberts_line *class)
{
    *class = line->class;
    if (piece->state != UNION_DRAWN)
        return piece->state == UNION_MET || (piece->state == UNION_ALONE && line->alone);
    body = line->sheet ? line->side[piece->first].body : body;
    bool back = seen_is_back(line->class), convex = scene_is_convex(s->source, body);
    double crease = convex ? s->rules.crease_chord : crease_of(s, body);
    edge_faces faces = faces_of_piece(s, line->side + piece->first, piece->count, crease);
    bool fold = is_fold(&faces), left_out = !fold && faces.flat && !s->rules.all_edges;
    if (left_out || line->sheet)
        return left_out && line->sheet;
    if (fold || faces.left == 0)
        *class = back ? ROBERTS_BACK_OUTLINE : ROBERTS_OUTLINE;
    else
        *class = back ? ROBERTS_BACK : ROBERTS_CREASE;
    return true;
}

bool seen_take_pieces(const seen *s, uint32_t body, const united *of, uint32_t index, seen_line *line)
{
    const union_piece *piece = united_pieces(of, index);
    bool drawn = false;
    roberts_line class;
    line->piece = piece;
    line->side = of->side;
    for (bool last = false; !last && !drawn; piece++) {
        drawn = seen_piece_class(s, body, line, piece, &class);
        last = piece->t1 == 1.0;
    }
    return drawn;
}

/* Would an edge of a convex body be a line without the union? `line` is what it would be if flat edges were lines. */
static bool is_lone_solid_line(const seen_walk *w, const seen_line *line)
{
    const roberts_scene *source = w->of->source;
    return w->of->rules.all_edges || line->class == ROBERTS_OUTLINE ||
           !seen_is_flat(source, source->solid[w->body].face, scene_edge_stored(source, w->body, line->edge),
                         w->of->rules.crease_chord);
}

/* The line of an edge with a union. If an edge of a convex body has no front face, its own body hides it, whatever the
 * other bodies fill. */
static bool united_line(seen_walk *w, uint32_t edge, seen_line *line)
{
    bool convex = scene_is_convex(w->of->source, w->body), all = w->all;
    if (!united_pieces(&w->of->edges, edge))
        return lone_line(w, edge, line);
    w->all = all || convex;
    bool is_line = lone_line(w, edge, line);
    w->all = all;
    if (!is_line && (convex || (line->taken & SEEN_TAKEN && !w->hidden)))
        return false;
    line->alone = convex ? is_lone_solid_line(w, line) : is_line;
    line->left_out = line->sheet = false;
    bool drawn = seen_take_pieces(w->of, w->body, &w->of->edges, edge, line);
    w->surviving += drawn && !is_line;
    return drawn;
}

bool seen_slow_line(seen_walk *w, uint32_t edge, seen_line *line)
{
    return w->of->edges.first ? united_line(w, edge, line) : lone_line(w, edge, line);
}

void seen_pass_flat(seen_walk *w)
{
    const roberts_scene *scene = w->of->scene;
    const scene_edge *edge = scene_edge_stored(scene, w->body, w->edge);
    const uint8_t *is = scene->surface->edge_is, *bend = scene->surface->bend;
    uint8_t crease = scene_bend_code(crease_of(w->of, w->body));
    uint32_t e = w->edge;
    for (; w->left_out && e < w->end; e++, edge++) /* a loop of its own: the other one must not become slower */
        if (bend[e] >= crease || !seen_joins_faces(w->facing, edge, is[e]) ||
            !seen_has_known_faces(w->of, w->face, edge)) {
            w->edge = e;
            return;
        }
    while (e < w->end && bend[e] < crease && seen_joins_faces(w->facing, edge, is[e])) {
        e++;
        edge++;
    }
    w->edge = e;
}

seen_walk seen_walk_slowly(const seen *s, uint32_t body)
{
    const roberts_scene *scene = s->scene, *source = s->source;
    const scene_solid *own = &scene->solid[body];
    seen_walk w = {.of = s,
                   .body = body,
                   .key = scene_is_convex(scene, body) ? seen_body_key(body) : ROBERTS_NONE,
                   .edge = source->solid[body].edge,
                   .end = source->solid[body + 1].edge,
                   .slow = true,
                   .hidden = s->rules.hidden,
                   .all = s->rules.all_edges,
                   .left_out = s->rules.left_out,
                   .stored = scene->edge + own->stored,
                   .facing = s->facing + own->face,
                   .vertex = own->vertex,
                   .face = own->face,
                   .passing = scene->surface && scene->surface->bend && !s->rules.all_edges &&
                              (!s->rules.left_out || s->sight) && !s->clip.clipped && !s->edges.first};
    if (!s->clip.clipped || !scene_is_convex(scene, body))
        return w;
    /* edges of a cap are no lines, but they are counted; they come last */
    for (uint32_t e = own[1].edge; e > own->edge && s->clip.cap[e - 1]; e--)
        w.surviving += seen_fronts(w.facing, scene_edge_stored(scene, body, e - 1)) > 0;
    return w;
}

seen_name seen_edge_name(const roberts_scene *source, uint32_t body, uint32_t edge)
{
    if (!scene_is_convex(source, body) && source->surface->edge_is[edge] & EDGE_PART) {
        const scene_part *part = scene_part_at(source, edge);
        return (seen_name){{part->v[0], part->v[1]}, part->t0, part->t1};
    }
    const scene_edge e = scene_edge_at(source, body, edge);
    return (seen_name){{scene_vertex_number(source, e.v[0]), scene_vertex_number(source, e.v[1])}, 0.0, 1.0};
}

seen_name seen_slow_name(const seen *s, uint32_t body, const seen_line *line)
{
    if (line->edge == ROBERTS_NONE)
        return (seen_name){{ROBERTS_NONE, ROBERTS_NONE}, 0.0, 1.0};
    return seen_edge_name(s->source, body, line->edge);
}
