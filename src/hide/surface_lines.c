/* surface_lines.c - see surface_lines.h. */
#include "hide/surface_lines.h"

#include "base/array.h"

/* Lines that are taken up at a time. */
enum { LINES_AT_ONCE = HIDE_GROUP };

enum { NOT_DRAWN = -1 };

/* How the faces of an edge lie about it in the picture. */
typedef struct edge_faces {
    unsigned left, right, edge_on;
    bool flat; /* all in one plane, but for the crease angle */
} edge_faces;

static void add_face(const hide_job *job, uint32_t face, bool turned, edge_faces *to)
{
    int facing = job->fronts.facing[face];
    if (facing == VIEW_EDGE_ON)
        to->edge_on++;
    else if ((facing == VIEW_FRONT) != turned)
        to->left++;
    else
        to->right++;
}

static double chord(plane F, plane G, double way)
{
    double a = F.a - way * G.a, b = F.b - way * G.b, c = F.c - way * G.c;
    return a * a + b * b + c * c;
}

/* An edge of one face or two. */
static edge_faces faces_of_edge(const hide_job *job, uint32_t first, const scene_edge *edge, uint8_t is, double crease)
{
    edge_faces found = {0};
    uint32_t f = first + edge->f[0], g = first + edge->f[1];
    bool turned = is & EDGE_TURNED_0, other = is & EDGE_TURNED_1;
    const plane *of = job->scene->face_plane;
    add_face(job, f, turned, &found);
    if (edge->f[1] == ROBERTS_NONE)
        return found;
    add_face(job, g, other, &found);
    found.flat = chord(of[f], of[g], turned != other ? 1.0 : -1.0) < crease;
    return found;
}

/* An edge of more than two. */
static edge_faces faces_of_many(const hide_job *job, const scene_many *many, double crease)
{
    const uint32_t *face = job->scene->surface->many_face;
    const plane *of = job->scene->face_plane;
    edge_faces found = {.flat = true};
    for (uint32_t k = many->first; k < many->end; k++) {
        plane F = of[face[many->first] & ~MANY_TURNED], G = of[face[k] & ~MANY_TURNED];
        add_face(job, face[k] & ~MANY_TURNED, face[k] & MANY_TURNED, &found);
        found.flat = found.flat && (chord(F, G, 1.0) < crease || chord(F, G, -1.0) < crease);
    }
    return found;
}

/* The class of an edge, or NOT_DRAWN. */
static int class_of(const hide_job *job, uint32_t body, uint32_t e, const scene_edge *edge, const scene_many *many)
{
    const scene_surface *surface = job->scene->surface;
    uint8_t is = surface->edge_is[e];
    double crease = surface->smooth[body] ? job->smooth_chord : job->crease_chord;
    if (edge->f[0] == ROBERTS_NONE)
        return ROBERTS_WIRE;
    edge_faces faces =
        many ? faces_of_many(job, many, crease) : faces_of_edge(job, job->scene->solid[body].face, edge, is, crease);
    bool fold = (faces.left == 0) != (faces.right == 0);
    if (is & EDGE_CUT)
        return fold && faces.edge_on == 0 && edge->f[1] != ROBERTS_NONE ? ROBERTS_OUTLINE : NOT_DRAWN;
    if (edge->f[1] == ROBERTS_NONE)
        return ROBERTS_BORDER;
    if (fold)
        return ROBERTS_OUTLINE;
    if (faces.flat && !job->options->all_edges)
        return NOT_DRAWN;
    return faces.left == 0 ? ROBERTS_OUTLINE : ROBERTS_CREASE;
}

/* Lines that are taken up together. */
typedef struct line_batch {
    uint32_t body;
    uint8_t class[LINES_AT_ONCE];
    uint32_t source[LINES_AT_ONCE]; /* edges of the scene as given */
} line_batch;

/* What the near plane leaves of an edge of the scene as given. */
static clip_edge left_of(const hide_job *job, uint32_t e)
{
    return job->clip.clipped ? job->clip.origin[e] : (clip_edge){e, 0.0, 1.0};
}

/* The segment of all of t0..t1 of an edge of the scene as given, which may be a part of an edge of the file. */
static roberts_segment pattern_of(const hide_job *job, uint32_t body, uint32_t e, double t0, double t1)
{
    const roberts_scene *scene = job->source;
    const scene_edge *edge = scene_edge_stored(scene, body, e);
    uint32_t first = scene->solid[body].vertex;
    roberts_segment pattern = {.solid = body,
                               .v0 = scene_vertex_number(scene, first + edge->v[0]),
                               .v1 = scene_vertex_number(scene, first + edge->v[1]),
                               .by = ROBERTS_NONE,
                               .t0 = t0,
                               .t1 = t1,
                               .state = ROBERTS_VISIBLE,
                               .edge = e};
    if (scene->surface->edge_is[e] & EDGE_PART) {
        const scene_part *part = scene_part_at(scene, e);
        double width = part->t1 - part->t0;
        pattern.v0 = part->v[0];
        pattern.v1 = part->v[1];
        pattern.t0 = part->t0 + width * t0;
        pattern.t1 = t1 == 1.0 ? part->t1 : part->t0 + width * t1;
    }
    return pattern;
}

/* A part that the near plane has taken. */
static bool add_clipped(const hide_job *job, hide_chunk *out, roberts_segment pattern, int class)
{
    if (!job->options->keep_hidden || pattern.t0 >= pattern.t1)
        return true;
    if (!array_reserve(&out->segment, &out->room, out->count + 1, sizeof *out->segment))
        return false;
    pattern.state = ROBERTS_CLIPPED;
    pattern.line = (uint8_t) class;
    out->segment[out->count++] = pattern;
    return true;
}

/* Would the edge, of which nothing is left, be drawn? Only of one that is flat or a cut it is known that it would
 * not. */
static bool add_lost(const hide_job *job, hide_chunk *out, uint32_t body, uint32_t e)
{
    const roberts_scene *scene = job->source;
    const scene_edge *edge = scene_edge_stored(scene, body, e);
    const plane *of = scene->face_plane + scene->solid[body].face;
    uint8_t is = scene->surface->edge_is[e];
    double way = ((is & EDGE_TURNED_0) != 0) != ((is & EDGE_TURNED_1) != 0) ? 1.0 : -1.0;
    bool flat = edge->f[1] != ROBERTS_NONE && !(is & EDGE_MANY) && !job->options->all_edges &&
                chord(of[edge->f[0]], of[edge->f[1]], way) <
                    (scene->surface->smooth[body] ? job->smooth_chord : job->crease_chord);
    int class = edge->f[0] == ROBERTS_NONE   ? ROBERTS_WIRE
                : edge->f[1] == ROBERTS_NONE ? ROBERTS_BORDER
                                             : ROBERTS_CREASE;
    return flat || is & EDGE_CUT || add_clipped(job, out, pattern_of(job, body, e, 0.0, 1.0), class);
}

/* The lines of a batch become segments. */
static bool add_lines(const hide_job *job, hide_worker *w, hide_chunk *out, const line_batch *batch)
{
    if (!hide_worker_run(w, ROBERTS_NONE))
        return false;
    if (job->options->keep_hidden)
        segments_name_hiders(job, w);
    for (size_t i = 0; i < w->line_count; i++) {
        uint32_t e = batch->source[i];
        clip_edge left = left_of(job, e);
        roberts_segment pattern = pattern_of(job, batch->body, e, left.t0, left.t1);
        pattern.line = batch->class[i];
        if ((left.t0 > 0.0 && !add_clipped(job, out, pattern_of(job, batch->body, e, 0.0, left.t0), pattern.line)) ||
            !segments_add_parts(job, out, &pattern, &w->line[i]) ||
            (left.t1 < 1.0 && !add_clipped(job, out, pattern_of(job, batch->body, e, left.t1, 1.0), pattern.line)))
            return false;
    }
    hide_worker_begin(w);
    return true;
}

/* Takes up a line that is drawn and not covered. */
static bool take_line(const hide_job *job, hide_worker *w, uint32_t e, const scene_many *many, line_batch *batch,
                      int class)
{
    const roberts_scene *scene = job->scene;
    const scene_solid *own = &scene->solid[batch->body];
    const scene_edge *edge = scene_edge_stored(scene, batch->body, e);
    batch->class[w->line_count] = (uint8_t) class;
    hide_line *line = hide_worker_add(w, e, edge, own->vertex);
    if (!line)
        return false;
    for (int k = 0; k < 2; k++)
        line->own[k] = edge->f[k] == ROBERTS_NONE ? ROBERTS_NONE : scene->surface->plane_of[own->face + edge->f[k]];
    line->many = many;
    return true;
}

bool surface_find(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t body)
{
    const roberts_scene *scene = job->scene;
    line_batch batch = {.body = body};
    if (job->fronts.culled[body] && !(job->clip.clipped && job->options->keep_hidden))
        return true;
    hide_worker_begin(w);
    for (uint32_t e = job->source->solid[body].edge; e < job->source->solid[body + 1].edge; e++) {
        clip_edge left = left_of(job, e);
        if (left.edge == ROBERTS_NONE || left.t0 >= left.t1) {
            if (!add_lines(job, w, out, &batch) || !add_lost(job, out, body, e))
                return false;
            continue;
        }
        const scene_many *many =
            scene->surface->edge_is[left.edge] & EDGE_MANY ? scene_many_at(scene, left.edge) : NULL;
        const scene_edge *edge = scene_edge_stored(scene, body, left.edge);
        int class = class_of(job, body, left.edge, edge, many);
        if (class == NOT_DRAWN)
            continue;
        w->surviving++;
        w->drawn++;
        if (segments_covered(job, body, edge)) {
            w->sides.tally.covered++;
            continue;
        }
        batch.source[w->line_count] = e;
        if (!take_line(job, w, left.edge, many, &batch, class) ||
            (w->line_count == LINES_AT_ONCE && !add_lines(job, w, out, &batch)))
            return false;
    }
    return add_lines(job, w, out, &batch);
}
