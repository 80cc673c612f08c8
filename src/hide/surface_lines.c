/* surface_lines.c - see surface_lines.h. */
#include "hide/surface_lines.h"

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
    int facing = job->picture.facing[face];
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
    edge_faces faces = many ? faces_of_many(job, many, crease) : faces_of_edge(job, job->scene->solid[body].face, edge, is, crease);
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

/* The lines of a batch become segments; class[]: their classes. */
static bool add_lines(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t body, const uint8_t *class)
{
    const roberts_scene *scene = job->scene;
    const uint8_t *is = scene->surface->edge_is;
    if (!hide_worker_run(w, ROBERTS_NONE))
        return false;
    if (job->options->keep_hidden)
        segments_name_hiders(job, w);
    for (size_t i = 0; i < w->line_count; i++) {
        const hide_line *line = &w->line[i];
        roberts_segment pattern = {.solid = body,
                                   .v0 = scene_vertex_number(scene, line->e.a),
                                   .v1 = scene_vertex_number(scene, line->e.b),
                                   .by = ROBERTS_NONE,
                                   .t1 = 1.0,
                                   .state = ROBERTS_VISIBLE,
                                   .line = class[i]};
        if (is[line->edge] & EDGE_PART) {
            const scene_part *part = scene_part_at(scene, line->edge);
            pattern.v0 = part->v[0];
            pattern.v1 = part->v[1];
            pattern.t0 = part->t0;
            pattern.t1 = part->t1;
        }
        if (!segments_add_parts(job, out, &pattern, line))
            return false;
    }
    return true;
}

bool surface_find(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t body)
{
    const roberts_scene *scene = job->scene;
    const scene_solid *own = &scene->solid[body];
    const uint8_t *is = scene->surface->edge_is;
    const uint32_t *plane_of = scene->surface->plane_of;
    uint8_t class[LINES_AT_ONCE];
    if (job->picture.culled[body])
        return true;
    hide_worker_begin(w);
    for (uint32_t e = own->edge; e < own[1].edge; e++) {
        const scene_edge *edge = scene_edge_stored(scene, body, e);
        const scene_many *many = is[e] & EDGE_MANY ? scene_many_at(scene, e) : NULL;
        int line_class = class_of(job, body, e, edge, many);
        if (line_class == NOT_DRAWN)
            continue;
        w->surviving++;
        w->drawn++;
        if (segments_covered(job, body, edge)) {
            w->tally.covered++;
            continue;
        }
        class[w->line_count] = (uint8_t)line_class;
        hide_line *line = hide_worker_add(w, e, edge, own->vertex);
        if (!line)
            return false;
        for (int k = 0; k < 2; k++)
            line->own[k] = edge->f[k] == ROBERTS_NONE ? ROBERTS_NONE : plane_of[own->face + edge->f[k]];
        line->many = many;
        if (w->line_count < LINES_AT_ONCE)
            continue;
        if (!add_lines(job, w, out, body, class))
            return false;
        hide_worker_begin(w);
    }
    return add_lines(job, w, out, body, class);
}
