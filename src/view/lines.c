/* lines.c - which edges are lines, and of what class: of bodies that are not convex, and of scenes that the near plane
 * has cut. The rest is inlined in seen.h. */
#include "view/seen.h"

/* How the faces of an edge lie about it in the picture. */
typedef struct edge_faces {
    unsigned left, right, edge_on;
    bool flat; /* all in one plane, but for the crease angle */
} edge_faces;

/* `turned`: the face lies on the right of the edge. */
static void add_facing(int facing, bool turned, edge_faces *to)
{
    if (facing == VIEW_EDGE_ON)
        to->edge_on++;
    else if ((facing == VIEW_FRONT) != turned)
        to->left++;
    else
        to->right++;
}

/* The squared distance of two unit normals, the second one times `way`. */
static double chord_between(plane F, plane G, double way)
{
    double a = F.a - way * G.a, b = F.b - way * G.b, c = F.c - way * G.c;
    return a * a + b * b + c * c;
}

/* 1 where the two faces of an edge are wound alike, else -1. */
static double way_of(uint8_t is)
{
    return ((is & EDGE_TURNED_0) != 0) != ((is & EDGE_TURNED_1) != 0) ? 1.0 : -1.0;
}

/* An edge of one face or two. */
static edge_faces faces_of_edge(const seen_walk *w, const scene_edge *edge, uint8_t is, double crease)
{
    edge_faces found = {0};
    uint32_t first = w->of->scene->solid[w->body].face;
    add_facing(w->of->facing[first + edge->f[0]], is & EDGE_TURNED_0, &found);
    if (edge->f[1] == ROBERTS_NONE)
        return found;
    add_facing(w->of->facing[first + edge->f[1]], is & EDGE_TURNED_1, &found);
    found.flat = chord_between(w->plane[edge->f[0]], w->plane[edge->f[1]], way_of(is)) < crease;
    return found;
}

/* An edge of more than two. */
static edge_faces faces_of_many(const seen *s, const scene_many *many, double crease)
{
    const uint32_t *face = s->scene->surface->many_face;
    const plane *of = s->scene->face_plane;
    edge_faces found = {.flat = true};
    for (uint32_t k = many->first; k < many->end; k++) {
        plane F = of[face[many->first] & ~MANY_TURNED], G = of[face[k] & ~MANY_TURNED];
        add_facing(s->facing[face[k] & ~MANY_TURNED], face[k] & MANY_TURNED, &found);
        found.flat = found.flat && (chord_between(F, G, 1.0) < crease || chord_between(F, G, -1.0) < crease);
    }
    return found;
}

/* Faces that meet nearer than this, as a squared distance of normals, are flat. */
static double crease_of(const seen *s, uint32_t body)
{
    return s->source->surface->smooth[body] ? s->rules.smooth_chord : s->rules.crease_chord;
}

/* Is the edge, number `e` of seen.scene, a line? Its class is set then. */
static bool classify(const seen_walk *w, uint32_t e, const scene_edge *edge, seen_line *line)
{
    const seen *s = w->of;
    uint8_t is = s->scene->surface->edge_is[e];
    double crease = crease_of(s, w->body);
    line->class = ROBERTS_WIRE;
    if (edge->f[0] == ROBERTS_NONE)
        return true;
    edge_faces faces = line->own.many ? faces_of_many(s, line->own.many, crease) : faces_of_edge(w, edge, is, crease);
    bool fold = (faces.left == 0) != (faces.right == 0);
    line->class = ROBERTS_OUTLINE;
    if (is & EDGE_CUT)
        return fold && faces.edge_on == 0 && edge->f[1] != ROBERTS_NONE;
    if (edge->f[1] == ROBERTS_NONE)
        line->class = ROBERTS_BORDER;
    else if (!fold && faces.flat && !s->rules.all_edges)
        return false;
    else if (!fold && faces.left > 0)
        line->class = ROBERTS_CREASE;
    return true;
}

seen_own seen_own_of(const roberts_scene *scene, uint32_t body, uint32_t edge)
{
    const scene_surface *surface = scene->surface;
    const scene_edge *e = scene_edge_stored(scene, body, edge);
    seen_own own = seen_owns_none;
    for (int k = 0; k < 2; k++)
        if (e->f[k] != ROBERTS_NONE)
            own.key[k] = surface->plane_of[scene->solid[body].face + e->f[k]];
    if (surface->edge_is[edge] & EDGE_MANY)
        own.many = scene_many_at(scene, edge);
    return own;
}

/* The line of an edge of a body that is not convex, number `e` of seen.scene. */
static bool surface_line(seen_walk *w, uint32_t e, const scene_edge *edge, seen_line *line)
{
    const roberts_scene *scene = w->of->scene;
    const scene_solid *own = &scene->solid[w->body];
    *line = (seen_line){.edge = line->edge,
                        .v = {own->vertex + edge->v[0], own->vertex + edge->v[1]},
                        .own = seen_own_of(scene, w->body, e)};
    if (!classify(w, e, edge, line))
        return false;
    w->surviving++;
    return true;
}

/* An edge of seen.source that the near plane has taken as a whole, of a convex body. */
static bool taken_of_solid(const seen_walk *w, seen_line *line)
{
    const roberts_scene *source = w->of->source;
    line->class = ROBERTS_BACK;
    return w->all || !seen_is_flat(source->face_plane + source->solid[w->body].face,
                                   scene_edge_stored(source, w->body, line->edge), w->of->rules.crease_chord);
}

/* The same of another body. Only of an edge that is flat, or a cut, is it known that it would be no line. */
static bool taken_of_surface(const seen_walk *w, seen_line *line)
{
    const roberts_scene *source = w->of->source;
    const scene_edge *edge = scene_edge_stored(source, w->body, line->edge);
    const plane *of = source->face_plane + source->solid[w->body].face;
    uint8_t is = source->surface->edge_is[line->edge];
    bool flat = edge->f[1] != ROBERTS_NONE && !(is & EDGE_MANY) && !w->all &&
                chord_between(of[edge->f[0]], of[edge->f[1]], way_of(is)) < crease_of(w->of, w->body);
    line->class = edge->f[0] == ROBERTS_NONE   ? ROBERTS_WIRE
                  : edge->f[1] == ROBERTS_NONE ? ROBERTS_BORDER
                                               : ROBERTS_CREASE;
    return !flat && !(is & EDGE_CUT);
}

/* The line of an edge, as it is without a union. Of a body that is not convex all but the class is set even where the
 * edge is no line. */
static bool lone_line(seen_walk *w, uint32_t edge, seen_line *line)
{
    const roberts_scene *scene = w->of->scene;
    clip_edge left = seen_left_of(w->of, edge);
    bool convex = scene_is_convex(scene, w->body);
    if (left.edge == ROBERTS_NONE || left.t0 >= left.t1) { /* equal: it ends on the near plane, to rounding */
        *line = (seen_line){.edge = edge,
                            .v = {ROBERTS_NONE, ROBERTS_NONE},
                            .own = {{w->key, ROBERTS_NONE}, NULL},
                            .t1 = 1.0,
                            .taken = SEEN_TAKEN};
        return w->hidden && (convex ? taken_of_solid(w, line) : taken_of_surface(w, line));
    }
    const scene_edge *stored = scene_edge_stored(scene, w->body, left.edge);
    bool is_line = convex ? seen_solid_line(w, stored, line) : surface_line(w, left.edge, stored, line);
    line->t0 = left.t0;
    line->t1 = left.t1;
    if (w->hidden)
        line->taken = (uint8_t)((left.t0 > 0.0 ? SEEN_TAKEN_BEFORE : 0) | (left.t1 < 1.0 ? SEEN_TAKEN_AFTER : 0));
    return is_line;
}

/* ---- bodies taken together as one ------------------------------------------------------------------------------ */

/* How the viewer sees a face of seen.source. A body that is culled has no view points, and the faces of a scene that
 * the near plane has cut have other numbers: there the depth of the normal decides, by the face's width. */
static int facing_of_side(const seen *s, uint32_t face)
{
    double stretch;
    if (s->scene == s->source && s->facing[face])
        return s->facing[face];
    plane F = view_plane(&s->view, s->source, face, &stretch);
    if (fabs(F.c) * scene_width(s->source, face) <= s->view.epsilon * s->view.unit)
        return VIEW_EDGE_ON;
    return F.c < 0.0 ? VIEW_FRONT : VIEW_BACK;
}

/* The sides of a piece as the faces of an edge; `crease`: flat below that. *back: none is toward the viewer. */
static edge_faces faces_of_piece(const seen *s, const union_piece *piece, double crease, bool *back)
{
    const union_side *side = s->united.side + piece->first;
    const plane *of = s->source->face_plane;
    edge_faces found = {.flat = true};
    *back = true;
    for (uint32_t i = 0; i < piece->count; i++) {
        int facing = facing_of_side(s, side[i].face);
        plane F = of[side[0].face], G = of[side[i].face];
        add_facing(facing, side[i].turned, &found);
        *back = *back && facing != VIEW_FRONT;
        found.flat = found.flat && (chord_between(F, G, 1.0) < crease || chord_between(F, G, -1.0) < crease);
    }
    return found;
}

bool seen_piece_class(const seen *s, uint32_t body, const seen_line *line, const union_piece *piece, uint8_t *class)
{
    *class = line->class;
    if (piece->state != UNION_DRAWN)
        return piece->state == UNION_ALONE && line->alone;
    bool back, convex = scene_is_convex(s->source, body);
    double crease = convex ? s->rules.crease_chord : crease_of(s, body);
    edge_faces faces = faces_of_piece(s, piece, crease, &back);
    bool fold = (faces.left == 0) != (faces.right == 0);
    if (!fold && faces.flat && !s->rules.all_edges)
        return false;
    back = back && line->class == ROBERTS_BACK;
    *class = fold || faces.left == 0 ? ROBERTS_OUTLINE : back ? ROBERTS_BACK : ROBERTS_CREASE;
    return true;
}

/* Would an edge of a convex body be a line without the union? `line`: what it would be if flat edges were lines. */
static bool is_lone_solid_line(const seen_walk *w, const seen_line *line)
{
    const roberts_scene *source = w->of->source;
    return w->of->rules.all_edges || line->class == ROBERTS_OUTLINE ||
           !seen_is_flat(source->face_plane + source->solid[w->body].face,
                         scene_edge_stored(source, w->body, line->edge), w->of->rules.crease_chord);
}

/* The line of an edge where bodies are one. An edge of a convex body that has no face toward the viewer is hidden by
 * its own body, whatever the others fill. */
static bool united_line(seen_walk *w, uint32_t edge, seen_line *line)
{
    const union_piece *piece = united_pieces(&w->of->united, edge);
    bool convex = scene_is_convex(w->of->source, w->body), all = w->all, drawn = false;
    uint8_t class;
    if (!piece)
        return lone_line(w, edge, line);
    w->all = all || convex;
    bool is_line = lone_line(w, edge, line);
    w->all = all;
    if (!is_line && (convex || (line->taken & SEEN_TAKEN && !w->hidden)))
        return false;
    line->alone = convex ? is_lone_solid_line(w, line) : is_line;
    line->piece = piece;
    for (bool last = false; !last && !drawn; piece++) {
        drawn = seen_piece_class(w->of, w->body, line, piece, &class);
        last = piece->t1 == 1.0;
    }
    w->surviving += drawn && !is_line;
    return drawn;
}

bool seen_slow_line(seen_walk *w, uint32_t edge, seen_line *line)
{
    return w->of->united.first ? united_line(w, edge, line) : lone_line(w, edge, line);
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
                   .stored = scene->edge + own->stored,
                   .facing = s->facing + own->face,
                   .plane = scene->face_plane + own->face,
                   .vertex = own->vertex};
    if (!s->clip.clipped || !scene_is_convex(scene, body))
        return w;
    /* edges of a cap are no lines, but they count; they come last */
    for (uint32_t e = own[1].edge; e > own->edge && s->clip.cap[e - 1]; e--)
        w.surviving += seen_fronts(w.facing, scene_edge_stored(scene, body, e - 1)) > 0;
    return w;
}

seen_name seen_part_name(const roberts_scene *source, uint32_t edge)
{
    const scene_part *part = scene_part_at(source, edge);
    return (seen_name){{part->v[0], part->v[1]}, part->t0, part->t1};
}
