/* segments.c - see segments.h. */
#include "hide/segments.h"

#include "base/array.h"
#include "hide/surface_lines.h"

/* Flatter than the crease angle; the normals of the model are compared, which perspective does not bend. `edge` is
 * stored with the solid. */
static bool is_flat(const hide_job *job, const roberts_scene *scene, uint32_t solid, const scene_edge *edge)
{
    const plane *of = scene->face_plane + scene->solid[solid].face;
    plane F = of[edge->f[0]], G = of[edge->f[1]];
    double a = F.a - G.a, b = F.b - G.b, c = F.c - G.c;
    return a * a + b * b + c * c < job->crease_chord;
}

/* Where on the edge in space a point of its picture is; view_to_space() without a call where it has nothing to do. */
static inline double to_space(const view *v, const hide_edge *e, double s)
{
    return v->perspective ? view_to_space(v, e->A.z, e->B.z, s) : s;
}

static bool add_segment(const hide_job *job, hide_chunk *out, const roberts_segment *pattern, const hide_edge *e,
                        double s0, double s1)
{
    const view *v = &job->fronts.view;
    double unit = v->unit, width = pattern->t1 - pattern->t0; /* of what the near plane leaves of the edge, mostly 1 */
    double t0 = pattern->t0 + width * to_space(v, e, s0);
    double t1 = s1 == 1.0 ? pattern->t1 : pattern->t0 + width * to_space(v, e, s1);
    if (t0 >= t1)
        return true; /* rounding leaves no length in space */
    if (!array_reserve(&out->segment, &out->room, out->count + 1, sizeof *out->segment))
        return false;
    roberts_vec3 R0 = hide_edge_at(e, s0), R1 = hide_edge_at(e, s1);
    roberts_segment *segment = &out->segment[out->count++];
    *segment = *pattern;
    segment->t0 = t0;
    segment->t1 = t1;
    segment->p0 = (roberts_vec2){R0.x * unit, R0.y * unit};
    segment->p1 = (roberts_vec2){R1.x * unit, R1.y * unit};
    segment->z0 = R0.z * unit;
    segment->z1 = R1.z * unit;
    return true;
}

static bool add_hidden(const hide_job *job, hide_chunk *out, roberts_segment pattern, const hide_edge *e,
                       const hide_solid_interval *hidden)
{
    pattern.state = ROBERTS_HIDDEN;
    pattern.by = hidden->solid;
    return add_segment(job, out, &pattern, e, hidden->part.t0, hidden->part.t1);
}

/* How the faces of a solid look, from its first on. */
static const unsigned char *facing_of(const hide_job *job, uint32_t solid)
{
    return job->fronts.facing + job->scene->solid[solid].face;
}

/* How many of the two faces of a stored edge are front. */
static inline int front_count(const unsigned char *facing, const scene_edge *edge)
{
    return (facing[edge->f[0]] == VIEW_FRONT) + (facing[edge->f[1]] == VIEW_FRONT);
}

static bool add_clipped(hide_chunk *out, roberts_segment pattern, double t0, double t1, roberts_vec2 at)
{
    if (!array_reserve(&out->segment, &out->room, out->count + 1, sizeof *out->segment))
        return false;
    pattern.state = ROBERTS_CLIPPED;
    pattern.t0 = t0;
    pattern.t1 = t1;
    pattern.p0 = pattern.p1 = at;
    out->segment[out->count++] = pattern;
    return true;
}

bool segments_add_parts(const hide_job *job, hide_chunk *out, const roberts_segment *pattern, const hide_line *line)
{
    double from = 0.0;
    const hide_edge *e = &line->e;
    bool all = job->options->keep_hidden;
    for (size_t i = 0; i < line->intervals.count; i++) {
        const hide_interval *part = &line->intervals.item[i].part;
        if (part->t0 > from && !add_segment(job, out, pattern, e, from, part->t0))
            return false;
        if (all && !add_hidden(job, out, *pattern, e, &line->intervals.item[i]))
            return false;
        from = part->t1;
    }
    return from >= 1.0 || add_segment(job, out, pattern, e, from, 1.0);
}

/* The same of an edge of which the near plane has left t0..t1 of the pattern. */
static bool add_line(const hide_job *job, hide_chunk *out, const roberts_segment *pattern, const hide_line *line)
{
    double unit = job->fronts.view.unit;
    const hide_edge *e = &line->e;
    bool all = job->options->keep_hidden;
    if (all && pattern->t0 > 0.0 &&
        !add_clipped(out, *pattern, 0.0, pattern->t0, (roberts_vec2){e->A.x * unit, e->A.y * unit}))
        return false;
    if (!segments_add_parts(job, out, pattern, line))
        return false;
    return !all || pattern->t1 >= 1.0 ||
           add_clipped(out, *pattern, pattern->t1, 1.0, (roberts_vec2){e->B.x * unit, e->B.y * unit});
}

/* The same of an edge that the near plane leaves whole, where its visible segments are all that is wanted. It has a
 * front face. (To share what writes a segment with add_segment() took two to four in a thousand of all
 * instructions.) */
static bool add_visible(const hide_job *job, hide_chunk *out, uint32_t solid, const unsigned char *facing,
                        const hide_line *line)
{
    const view *v = &job->fronts.view;
    const hide_edge *e = &line->e;
    const scene_edge *edge = scene_edge_stored(job->scene, solid, line->edge);
    roberts_line kind = front_count(facing, edge) == 2 ? ROBERTS_CREASE : ROBERTS_OUTLINE;
    double from = 0.0, unit = v->unit;
    size_t parts = line->intervals.count;
    if (!array_reserve(&out->segment, &out->room, out->count + parts + 1, sizeof *out->segment))
        return false;
    for (size_t i = 0; i <= parts; i++) {
        const hide_interval *part = i < parts ? &line->intervals.item[i].part : NULL;
        double to = part ? part->t0 : 1.0, t0 = to_space(v, e, from), t1 = to == 1.0 ? 1.0 : to_space(v, e, to);
        if (to > from && t0 < t1) {
            roberts_vec3 R0 = hide_edge_at(e, from), R1 = hide_edge_at(e, to);
            out->segment[out->count++] = (roberts_segment){.solid = solid,
                                                           .v0 = scene_vertex_number(job->scene, e->a),
                                                           .v1 = scene_vertex_number(job->scene, e->b),
                                                           .by = ROBERTS_NONE,
                                                           .t0 = t0,
                                                           .t1 = t1,
                                                           .p0 = {R0.x * unit, R0.y * unit},
                                                           .p1 = {R1.x * unit, R1.y * unit},
                                                           .z0 = R0.z * unit,
                                                           .z1 = R1.z * unit,
                                                           .state = ROBERTS_VISIBLE,
                                                           .line = (uint8_t)kind,
                                                           .edge = line->edge};
        }
        from = part ? part->t1 : 1.0;
    }
    return true;
}

/* What lies behind the covers is hidden at once; covers are kept only where hidden lines are not wanted. P: view points
 * of the solid. */
static inline bool is_covered(const cover *c, const roberts_vec3 *P, const scene_edge *edge)
{
    return c->depth && cover_hides_edge(c, P[edge->v[0]], P[edge->v[1]]);
}

bool segments_covered(const hide_job *job, uint32_t solid, const scene_edge *edge)
{
    return is_covered(&job->fronts.cover, job->fronts.P + job->scene->solid[solid].vertex, edge);
}

/* Takes up the edges of a solid that are drawn and not covered. A surviving edge has a front face. An outline (one
 * front face) is always drawn; an edge whose two faces look the same way is not where it is flat, whether they are
 * front or, among hidden lines, back. */
static bool take_edges(const hide_job *job, hide_worker *w, uint32_t solid)
{
    const roberts_scene *scene = job->scene;
    const unsigned char *facing = facing_of(job, solid);
    const scene_edge *edge = scene->edge + scene->solid[solid].stored;
    const roberts_vec3 *P = job->fronts.P + scene->solid[solid].vertex;
    const bool *cap = job->clip.clipped ? job->clip.cap : NULL;
    bool keep_hidden = job->options->keep_hidden, all = job->options->all_edges;
    hide_worker_begin(w);
    for (uint32_t i = scene->solid[solid].edge, end = scene->solid[solid + 1].edge; i < end; i++, edge++) {
        int fronts = front_count(facing, edge);
        w->surviving += fronts > 0;
        if ((fronts == 0 && !keep_hidden) || (cap && cap[i]) ||
            (fronts != 1 && !all && is_flat(job, scene, solid, edge)))
            continue;
        w->drawn++;
        if (is_covered(&job->fronts.cover, P, edge)) {
            w->sides.tally.covered++;
            continue;
        }
        hide_line *line = hide_worker_add(w, i, edge, scene->solid[solid].vertex);
        if (!line)
            return false;
        if (fronts == 0) {
            line->hidden = true;
            if (!hide_intervals_add(&line->intervals, solid, &(hide_interval){0.0, 1.0, 0.0, 1.0}))
                return false;
        }
    }
    return true;
}

/* The solid of each hidden part becomes the one that is seen there, in its middle. */
void segments_name_hiders(const hide_job *job, hide_worker *w)
{
    const view *v = &job->fronts.view;
    for (hide_line *line = w->line, *end = line + w->line_count; line < end; line++)
        for (size_t i = 0; i < line->intervals.count; i++) {
            const hide_edge *e = &line->e;
            hide_solid_interval *hidden = &line->intervals.item[i];
            double t0 = view_to_space(v, e->A.z, e->B.z, hidden->part.t0);
            double t1 = view_to_space(v, e->A.z, e->B.z, hidden->part.t1);
            roberts_vec3 middle = hide_edge_at(e, view_from_space(v, e->A.z, e->B.z, 0.5 * (t0 + t1)));
            uint32_t seen = hide_seen_at(w, middle.x, middle.y);
            if (seen != ROBERTS_NONE) /* else the point lies on a border and rounding has put it outside */
                hidden->solid = seen;
        }
}

bool segments_hide(const hide_job *job, hide_worker *w, uint32_t solid)
{
    if (!take_edges(job, w, solid) || !hide_worker_run(w, solid))
        return false;
    if (job->options->keep_hidden)
        segments_name_hiders(job, w);
    return true;
}

/* One edge of the scene as given: the line that stands for it, NULL where it is not drawn. */
static bool add_edge(const hide_job *job, hide_chunk *out, uint32_t solid, uint32_t edge, const hide_line *line)
{
    const scene_edge *source = scene_edge_stored(job->source, solid, edge);
    uint32_t first = job->source->solid[solid].vertex;
    clip_edge left = {edge, 0.0, 1.0};
    if (job->clip.clipped)
        left = job->clip.origin[edge];
    if (left.edge != ROBERTS_NONE && (!line || (line->hidden && !job->options->keep_hidden)))
        return true;
    int fronts = line ? front_count(facing_of(job, solid), scene_edge_stored(job->scene, solid, line->edge)) : 0;
    roberts_segment pattern = {.solid = solid,
                               .v0 = scene_vertex_number(job->source, first + source->v[0]),
                               .v1 = scene_vertex_number(job->source, first + source->v[1]),
                               .by = ROBERTS_NONE,
                               .t0 = left.t0,
                               .t1 = left.t1,
                               .state = ROBERTS_VISIBLE,
                               .line = fronts == 1   ? ROBERTS_OUTLINE
                                       : fronts == 2 ? ROBERTS_CREASE
                                                     : ROBERTS_BACK,
                               .edge = edge};
    if (left.edge == ROBERTS_NONE || left.t0 >= left.t1) { /* equal: it ends on the near plane, to rounding */
        bool drawn = job->options->all_edges || !is_flat(job, job->source, solid, source);
        return !job->options->keep_hidden || !drawn || add_clipped(out, pattern, 0.0, 1.0, (roberts_vec2){0.0, 0.0});
    }
    return add_line(job, out, &pattern, line);
}

/* The lines come in the order of the edges, of which some are not drawn and some, by the near plane, clipped away. */
static bool add_solid(const hide_job *job, const hide_worker *w, hide_chunk *out, uint32_t solid)
{
    const hide_line *line = w->line, *end = line + w->line_count;
    const unsigned char *facing = facing_of(job, solid);
    bool visible = !job->clip.clipped && !job->options->keep_hidden;
    for (; visible && line < end; line++)
        if (!line->hidden && !add_visible(job, out, solid, facing, line))
            return false;
    for (; !job->clip.clipped && line < end; line++)
        if (!add_edge(job, out, solid, line->edge, line))
            return false;
    for (uint32_t i = job->source->solid[solid].edge; job->clip.clipped && i < job->source->solid[solid + 1].edge;
         i++) {
        bool drawn = line < end && line->edge == job->clip.origin[i].edge;
        if (!add_edge(job, out, solid, i, drawn ? line++ : NULL))
            return false;
    }
    return true;
}

static bool find_in_solid(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t solid)
{
    if (!scene_is_convex(job->scene, solid))
        return surface_find(job, w, out, solid);
    if (job->fronts.culled[solid] && !(job->clip.clipped && job->options->keep_hidden))
        return true;
    if (job->order.solid ? !picture_order_recall(&job->order, solid, w) : !segments_hide(job, w, solid))
        return false;
    return add_solid(job, w, out, solid);
}

bool segments_find(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t first, uint32_t end)
{
    for (uint32_t s = first; s < end; s++) {
        if (job->order.solid)
            picture_order_fetch(&job->order, s);
        if (!find_in_solid(job, w, out, s))
            return false;
    }
    return true;
}
