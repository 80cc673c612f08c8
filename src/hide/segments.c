/* segments.c - from a body's edges to lines, and from lines to visible and hidden segments. */
#include "hide/segments.h"

#include <stdlib.h>

#include "base/array.h"

/* ---- lines to segments ----------------------------------------------------------------------------------------- */

/* A body's lines, while they are written to a chunk. */
typedef struct line_writer {
    const seen *seen;
    hide_chunk *out;
    uint32_t body;
    double unit;
    bool all, nameless, levels; /* hidden parts are wanted too; without the body seen there; with their levels */
    bool perspective;
} line_writer;

BITS_INLINE line_writer writer_for(const hide_job *job, hide_chunk *out, uint32_t body)
{
    const view *v = &job->seen.view;
    return (line_writer){.seen = &job->seen,
                         .out = out,
                         .body = body,
                         .unit = v->unit,
                         .all = job->options->keep_hidden,
                         .nameless = job->options->nameless,
                         .levels = job->options->keep_hidden && job->options->levels,
                         .perspective = v->perspective};
}

/* What all segments of a line share. */
typedef struct line_row {
    uint32_t v[2], edge;
    roberts_line class;
    double t0, t1; /* which part of the named edge the line is */
} line_row;

BITS_INLINE line_row row_of_line(const line_writer *w, const seen_line *line)
{
    const seen_name none = {{ROBERTS_NONE, ROBERTS_NONE}, 0.0, 1.0};
    seen_name name = line->end ? none : seen_line_name(w->seen, w->body, line);
    double width = name.t1 - name.t0;
    return (line_row){.v = {name.v[0], name.v[1]},
                      .edge = line->edge,
                      .class = line->class,
                      .t0 = name.t0 + width * line->t0,
                      .t1 = line->t1 == 1.0 ? name.t1 : name.t0 + width * line->t1};
}

/* The parameter in space of a point given by its parameter in the picture. In parallel views they are equal. */
BITS_INLINE double to_space(const line_writer *w, const hide_edge *e, double s)
{
    return w->perspective ? view_to_space(&w->seen->view, e->A.z, e->B.z, s) : s;
}

/* Writes one part of a line, unless rounding leaves no length of it in space. by: the body that hides it, or
 * ROBERTS_NONE if it is visible. The chunk has room for it. */
BITS_INLINE void put_part(const line_writer *w, const line_row *row, const hide_edge *e, const hide_interval *part,
                          uint32_t by)
{
    double unit = w->unit, width = row->t1 - row->t0, s0 = part->t0, s1 = part->t1;
    double t0 = row->t0 + width * to_space(w, e, s0), t1 = s1 == 1.0 ? row->t1 : row->t0 + width * to_space(w, e, s1);
    if (t0 >= t1)
        return;
    roberts_vec3 R0 = hide_edge_at(e, s0), R1 = hide_edge_at(e, s1);
    w->out->segment[w->out->count++] = (roberts_segment){.solid = w->body,
                                                         .v0 = row->v[0],
                                                         .v1 = row->v[1],
                                                         .by = w->nameless ? ROBERTS_NONE : by,
                                                         .t0 = t0,
                                                         .t1 = t1,
                                                         .p0 = {R0.x * unit, R0.y * unit},
                                                         .p1 = {R1.x * unit, R1.y * unit},
                                                         .z0 = R0.z * unit,
                                                         .z1 = R1.z * unit,
                                                         .state = by == ROBERTS_NONE ? ROBERTS_VISIBLE : ROBERTS_HIDDEN,
                                                         .line = (uint8_t)row->class,
                                                         .level = 0, /* every member is set, which is cheaper than
                                                                        clearing first */
                                                         .edge = row->edge};
}

/* Writes a part of an edge that the near plane has removed. at: where the plane cuts the edge. The chunk has room. */
static void put_taken_part(const line_writer *w, const seen_line *taken, roberts_vec3 at)
{
    line_row row = row_of_line(w, taken);
    roberts_vec2 cut = {at.x * w->unit, at.y * w->unit};
    if (row.t0 < row.t1)
        w->out->segment[w->out->count++] = (roberts_segment){.solid = w->body,
                                                             .v0 = row.v[0],
                                                             .v1 = row.v[1],
                                                             .by = ROBERTS_NONE,
                                                             .t0 = row.t0,
                                                             .t1 = row.t1,
                                                             .p0 = cut,
                                                             .p1 = cut,
                                                             .state = ROBERTS_CLIPPED,
                                                             .line = (uint8_t)row.class,
                                                             .edge = row.edge};
}

/* Writes what the near plane has removed from a line's edge: the part before the line (which: SEEN_TAKEN_BEFORE), the
 * part after it (SEEN_TAKEN_AFTER), or all of it (SEEN_TAKEN). The chunk has room. */
static BITS_RARE void put_taken(const line_writer *w, const hide_line *line, unsigned which)
{
    seen_line taken = line->is;
    if (!(taken.taken & which))
        return;
    taken.t0 = which == SEEN_TAKEN_AFTER ? line->is.t1 : 0.0;
    taken.t1 = which == SEEN_TAKEN_BEFORE ? line->is.t0 : 1.0;
    put_taken_part(w, &taken, which == SEEN_TAKEN_AFTER ? line->e.B : line->e.A);
}

/* Adds the visible segments of a line, and the hidden ones if they are wanted. False: no memory. */
BITS_INLINE bool add_line_segments(const line_writer *w, const hide_line *line)
{
    hide_chunk *out = w->out;
    size_t parts = line->intervals.count;
    hide_interval shown = {.t0 = 0.0};
    if (!array_reserve(&out->segment, &out->room, out->count + 2 * parts + 3, sizeof *out->segment))
        return false;
    if (line->is.taken)
        put_taken(w, line, line->is.taken & SEEN_TAKEN ? SEEN_TAKEN : SEEN_TAKEN_BEFORE);
    if (line->is.taken & SEEN_TAKEN)
        return true;
    line_row row = row_of_line(w, &line->is);
    for (size_t i = 0; i < parts; i++) {
        const hide_solid_interval *hidden = &line->intervals.item[i];
        shown.t1 = hidden->part.t0;
        if (shown.t1 > shown.t0)
            put_part(w, &row, &line->e, &shown, ROBERTS_NONE);
        if (w->all)
            put_part(w, &row, &line->e, &hidden->part, hidden->solid);
        shown.t0 = hidden->part.t1;
    }
    shown.t1 = 1.0;
    if (shown.t1 > shown.t0)
        put_part(w, &row, &line->e, &shown, ROBERTS_NONE);
    if (line->is.taken)
        put_taken(w, line, SEEN_TAKEN_AFTER);
    return true;
}

/* Clips a hidden part to `all`. An end nearer than `near` to an end of `all` is moved there. False: nothing is left. */
static bool clip_hidden(hide_interval *hidden, const hide_interval *all, double near)
{
    if (hidden->t0 - all->t0 <= near)
        hidden->t0 = all->t0;
    if (all->t1 - hidden->t1 <= near)
        hidden->t1 = all->t1;
    bool whole = hidden->t0 > all->t0 && hidden->t1 < all->t1;
    return hidden->t1 - hidden->t0 > (whole ? 0.0 : near);
}

/* Writes the parts of a line that lie within `all`, in picture parameters. The chunk has room. */
static void put_parts(const line_writer *w, const line_row *row, const hide_line *line, const hide_interval *all)
{
    double near = w->seen->view.epsilon / line->e.length3;
    hide_interval shown = {.t0 = all->t0};
    for (size_t i = hide_intervals_first(&line->intervals, all->t0);
         i < line->intervals.count && line->intervals.item[i].part.t0 < all->t1; i++) {
        hide_interval hidden = line->intervals.item[i].part;
        if (!clip_hidden(&hidden, all, near))
            continue;
        shown.t1 = hidden.t0;
        if (shown.t1 > shown.t0)
            put_part(w, row, &line->e, &shown, ROBERTS_NONE);
        if (w->all)
            put_part(w, row, &line->e, &hidden, line->intervals.item[i].solid);
        shown.t0 = hidden.t1;
    }
    shown.t1 = all->t1;
    if (shown.t1 > shown.t0)
        put_part(w, row, &line->e, &shown, ROBERTS_NONE);
}

/* Adds the segments of one piece of a line. Each piece has its own class. False: no memory. */
static bool add_piece_segments(const line_writer *w, const hide_line *line, const union_piece *piece,
                               roberts_line class)
{
    const view *v = &w->seen->view;
    const hide_edge *e = &line->e;
    const seen_line *whole = &line->is;
    hide_chunk *out = w->out;
    seen_line part = *whole;
    bool gone = whole->taken & SEEN_TAKEN;
    if (!array_reserve(&out->segment, &out->room, out->count + 2 * line->intervals.count + 3, sizeof *out->segment))
        return false;
    part.class = class;
    part.t0 = piece->t0;
    part.t1 = gone ? piece->t1 : lesser(piece->t1, whole->t0);
    if (whole->taken & (SEEN_TAKEN | SEEN_TAKEN_BEFORE) && part.t0 < part.t1)
        put_taken_part(w, &part, e->A);
    double t0 = greater(piece->t0, whole->t0), t1 = lesser(piece->t1, whole->t1), width = whole->t1 - whole->t0;
    if (!gone && t0 < t1) {
        part.t0 = whole->t0;
        part.t1 = whole->t1;
        line_row row = row_of_line(w, &part);
        hide_interval shown = {.t0 = view_from_space(v, e->A.z, e->B.z, (t0 - whole->t0) / width), .t1 = 1.0};
        if (t1 < whole->t1)
            shown.t1 = view_from_space(v, e->A.z, e->B.z, (t1 - whole->t0) / width);
        put_parts(w, &row, line, &shown);
    }
    part.t0 = greater(piece->t0, whole->t1);
    part.t1 = piece->t1;
    if (whole->taken & SEEN_TAKEN_AFTER && part.t0 < part.t1)
        put_taken_part(w, &part, e->B);
    return true;
}

/* Adds the segments of a line that has pieces. False: no memory. */
static BITS_RARE bool add_segments_of_pieces(const line_writer *w, const hide_line *line)
{
    const union_piece *piece = line->is.piece;
    for (bool last = false; !last; piece++) {
        roberts_line class;
        if (seen_piece_class(w->seen, w->body, &line->is, piece, &class) && !add_piece_segments(w, line, piece, class))
            return false;
        last = piece->t1 == 1.0;
    }
    return true;
}

BITS_INLINE bool add_either(const line_writer *w, const hide_line *line)
{
    return line->is.piece ? add_segments_of_pieces(w, line) : add_line_segments(w, line);
}

/* Sets the level of a line's hidden segments, taken at their middle in space. The line's segments start at `first`. */
static BITS_RARE bool add_levels(const hide_job *job, hide_worker *w, hide_chunk *out, const seen_line *line,
                                 size_t first)
{
    const view *v = &job->seen.view;
    for (roberts_segment *s = out->segment + first, *end = out->segment + out->count; s < end; s++) {
        uint32_t level;
        if (s->state != ROBERTS_HIDDEN)
            continue;
        const roberts_vec3 A = vec3_scale(1.0 / v->unit, (roberts_vec3){s->p0.x, s->p0.y, s->z0});
        const roberts_vec3 B = vec3_scale(1.0 / v->unit, (roberts_vec3){s->p1.x, s->p1.y, s->z1});
        const double middle = view_from_space(v, A.z, B.z, 0.5);
        const roberts_vec3 X = vec3_add(A, vec3_scale(middle, vec3_sub(B, A)));
        if (!point_level(w->fronts, w->grid, line, X, &w->level, &level))
            return false;
        s->level = (uint16_t)(level < UINT16_MAX ? level : UINT16_MAX);
    }
    return true;
}

/* Marks the segments from `first` on. */
static void mark_left_out(hide_chunk *out, size_t first)
{
    for (roberts_segment *s = out->segment + first, *end = out->segment + out->count; s < end; s++)
        s->state = SEGMENT_LEFT_OUT;
}

/* Adds all segments of a line. False: no memory. */
BITS_INLINE bool add_segments(const hide_job *job, hide_worker *w, const line_writer *writer, const hide_line *line)
{
    const size_t first = writer->out->count;
    if ((writer->all || !line->hidden) && !add_either(writer, line))
        return false;
    if (line->is.left_out)
        mark_left_out(writer->out, first);
    return !writer->levels || add_levels(job, w, writer->out, &line->is, first);
}

static bool add_body_segments(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t body)
{
    line_writer writer = writer_for(job, out, body);
    for (const hide_line *line = w->line, *end = line + w->line_count; line < end; line++)
        if (!add_segments(job, w, &writer, line))
            return false;
    return true;
}

/* ---- bodies to lines ------------------------------------------------------------------------------------------- */

/* Covers that may hide lines of a body. */
typedef struct line_covers {
    const cover *set[3];
    uint32_t count;
} line_covers;

/* Returns the covers of all bodies, the sheets, and the body's own covers; none if hidden lines are wanted. */
BITS_INLINE line_covers covers_of(const hide_job *job, uint32_t body)
{
    const cover *all[] = {&job->fronts.cover, &job->grid.sheet, hide_own_cover(&job->fronts, body)};
    line_covers covers = {.count = 0};
    for (int i = 0; i < 3 && !job->options->keep_hidden; i++)
        if (all[i] && all[i]->depth)
            covers.set[covers.count++] = all[i];
    return covers;
}

/* Does AB lie completely behind one set of covers? */
BITS_INLINE bool is_covered(const line_covers *covers, roberts_vec3 A, roberts_vec3 B)
{
    for (uint32_t i = 0; i < covers->count; i++)
        if (cover_hides_edge(covers->set[i], A, B))
            return true;
    return false;
}

/* Takes the last line of the worker back if covers hide it, given the body to which it belongs. */
static bool drop_covered(const hide_job *job, hide_worker *w, uint32_t body)
{
    const line_covers covers = covers_of(job, body);
    const hide_edge *e = &w->line[w->line_count - 1].e;
    if (!is_covered(&covers, e->A, e->B))
        return false;
    w->sides.tally.covered++;
    w->line_count--;
    return true;
}

/* Does the line of an edge lie behind its own body, since both its faces do? back: star_body_rear(). It is known in
 * scenes that no plane has cut: there, the eye is outside. */
BITS_INLINE bool is_behind_body(const seen_walk *walk, const seen_line *line, unsigned char back)
{
    if (back == VIEW_UNKNOWN)
        return false;
    const scene_edge *edge = scene_edge_stored(walk->of->scene, walk->body, line->edge);
    return walk->facing[edge->f[0]] == back && walk->facing[edge->f[1]] == back;
}

/* Hides all of a line behind its own body. False: no memory. */
static bool hide_wholly(hide_line *line, uint32_t body)
{
    hide_interval whole = hide_whole;
    return hide_intervals_add(&line->intervals, body, &whole);
}

/* Takes the next lines of a walk, at most `most`. Lines behind covers are dropped at once; there are covers only if
 * hidden lines are not wanted. A line without a front face is hidden by its own body. False: no memory. */
BITS_INLINE bool take_some(const hide_job *job, hide_worker *w, seen_walk *walk, size_t most, bool slow)
{
    const roberts_vec3 *P = job->fronts.P;
    const line_covers covers = covers_of(job, walk->body);
    const unsigned char back = slow ? hide_rear_facing(&job->fronts, walk->body) : VIEW_UNKNOWN;
    size_t left = walk->end - walk->edge;
    hide_worker_begin(w, walk->key);
    if (!hide_worker_reserve(w, left < most ? left : most))
        return false;
    for (hide_line *line = w->line; w->line_count < most && seen_next(walk, &line->is, slow);) {
        const seen_line *is = &line->is;
        if (slow && is->taken & SEEN_TAKEN) {
            hide_worker_add_taken(w, line++);
            continue;
        }
        w->drawn += !is->left_out;
        if (is_behind_body(walk, is, back) || (covers.count > 0 && is_covered(&covers, P[is->v[0]], P[is->v[1]]))) {
            w->sides.tally.covered++;
            continue;
        }
        hide_worker_add(w, line);
        line->hidden = seen_is_back(is->class);
        if (line->hidden && !hide_wholly(line, walk->body))
            return false;
        line++;
    }
    w->surviving += walk->surviving;
    walk->surviving = 0;
    return true;
}

/* The fast walk is a local copy, so that the compiler can keep it in registers. */
static BITS_PER_PROCESSOR bool take_lines(const hide_job *job, hide_worker *w, seen_walk *walk, size_t most)
{
    if (walk->slow)
        return take_some(job, w, walk, most, true);
    seen_walk fast = *walk;
    return take_some(job, w, &fast, SIZE_MAX, false);
}

/* Sets the body of each hidden part to the one that the viewer sees at its middle. */
static void name_hiders(const hide_job *job, hide_worker *w)
{
    const view *v = &job->seen.view;
    for (hide_line *line = w->line, *end = line + w->line_count; line < end; line++)
        for (size_t i = 0; i < line->intervals.count; i++) {
            const hide_edge *e = &line->e;
            hide_solid_interval *hidden = &line->intervals.item[i];
            double t0 = view_to_space(v, e->A.z, e->B.z, hidden->part.t0);
            double t1 = view_to_space(v, e->A.z, e->B.z, hidden->part.t1);
            roberts_vec3 middle = hide_edge_at(e, view_from_space(v, e->A.z, e->B.z, 0.5 * (t0 + t1)));
            uint32_t body = point_solid(w->fronts, w->grid, (roberts_vec2){middle.x, middle.y});
            if (body != ROBERTS_NONE) /* otherwise the point lies on a border and rounding put it outside */
                hidden->solid = body;
        }
}

/* Cuts the hidden parts of lines where their pieces end: another body may be seen beyond. False: no memory. */
static bool split_at_pieces(const hide_job *job, hide_worker *w)
{
    for (hide_line *line = w->line, *end = line + w->line_count; line < end; line++) {
        const seen_line *is = &line->is;
        const union_piece *piece = is->taken & SEEN_TAKEN ? NULL : is->piece;
        for (; piece && piece->t1 < is->t1; piece++) {
            double t = (piece->t1 - is->t0) / (is->t1 - is->t0);
            if (t > 0.0 &&
                !hide_intervals_split(&line->intervals, view_from_space(&job->seen.view, line->e.A.z, line->e.B.z, t)))
                return false;
        }
    }
    return true;
}

/* Finds the hidden parts of the worker's lines. False: no memory. */
static bool hide_lines(const hide_job *job, hide_worker *w)
{
    if (!hide_worker_run(w))
        return false;
    if (!job->options->keep_hidden)
        return true;
    if (job->seen.edges.first && !split_at_pieces(job, w))
        return false;
    if (!job->options->nameless)
        name_hiders(job, w);
    return true;
}

bool segments_hide(const hide_job *job, hide_worker *w, uint32_t body)
{
    hide_worker_begin(w, ROBERTS_NONE);
    if (!hide_has_lines(&job->fronts, body))
        return true;
    seen_walk walk = seen_walk_begin(&job->seen, body);
    return take_lines(job, w, &walk, SIZE_MAX) && hide_lines(job, w);
}

/* Takes a group of lines of a body that are no edges, from *next on, and moves *next on. False: no memory. */
static bool take_further(const hide_job *job, hide_worker *w, uint32_t body, uint32_t *next)
{
    const uint32_t end = job->seen.further.first[body + 1];
    hide_worker_begin(w, ROBERTS_NONE);
    if (!hide_worker_reserve(w, HIDE_GROUP))
        return false;
    for (; *next < end && w->line_count < HIDE_GROUP; ++*next) {
        hide_line *line = &w->line[w->line_count];
        line->is = job->seen.further.line[*next];
        w->drawn += !line->is.left_out;
        hide_worker_add(w, line);
        drop_covered(job, w, body);
    }
    return true;
}

static bool find_further(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t body)
{
    const uint32_t *first = job->seen.further.first;
    for (uint32_t next = first[body]; next < first[body + 1];)
        if (!take_further(job, w, body, &next) || !hide_lines(job, w) || !add_body_segments(job, w, out, body))
            return false;
    return true;
}

bool segments_at_once(const hide_job *job, uint32_t body)
{
    const scene_solid *s = &job->seen.scene->solid[body];
    return scene_is_convex(job->seen.scene, body) || s[1].edge - s->edge <= HIDE_GROUP;
}

/* How many lines of a large surface are hidden together. Lines that follow one another are mostly neighbours: so few
 * lie within a cell or two. */
#define SURFACE_GROUP 8

/* Writes the segments of a body's edges. Large bodies are handled a group of lines at a time. False: no memory, or the
 * receiver stops the work. */
static bool find_edges(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t body)
{
    if (segments_at_once(job, body))
        return (job->order.solid ? picture_order_recall(&job->order, body, w) : segments_hide(job, w, body)) &&
               add_body_segments(job, w, out, body);
    seen_walk walk = seen_walk_begin(&job->seen, body);
    while (walk.edge < walk.end)
        if (!take_lines(job, w, &walk, SURFACE_GROUP) || !hide_lines(job, w) || !add_body_segments(job, w, out, body) ||
            (out->to && !chunk_give(out, out->to)))
            return false;
    return true;
}

bool segments_find(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t first, uint32_t end)
{
    for (uint32_t s = first; s < end; s++) {
        if (job->order.solid)
            picture_order_fetch(&job->order, s);
        if (!hide_has_lines(&job->fronts, s))
            continue;
        if (!find_edges(job, w, out, s) || (job->seen.further.first && !find_further(job, w, out, s)))
            return false;
    }
    return true;
}

/* ---- where faces cross ----------------------------------------------------------------------------------------- */

/* Takes a group of lines in which faces cross, from *next on, and moves *next on. False: no memory. */
static bool take_crossings(const hide_job *job, hide_worker *w, size_t *next, size_t end)
{
    const crossings *c = &job->crossings;
    hide_worker_begin(w, ROBERTS_NONE);
    if (!hide_worker_reserve(w, HIDE_GROUP))
        return false;
    for (; *next < end && w->line_count < HIDE_GROUP; ++*next) {
        hide_line *line = &w->line[w->line_count];
        const uint32_t body = c->item[*next].body[0];
        line->is = crossings_line(c, &job->seen, *next);
        if (!crossings_unite(c, &job->seen, *next, &line->is))
            continue;
        hide_worker_add(w, line);
        if (!drop_covered(job, w, body) && crossings_is_back(c, &job->seen, *next) && !hide_wholly(line, body))
            return false;
    }
    return true;
}

bool segments_cross(const hide_job *job, hide_worker *w, hide_chunk *out, size_t first, size_t end)
{
    line_writer writer = writer_for(job, out, 0);
    while (first < end) {
        if (!take_crossings(job, w, &first, end) || !hide_lines(job, w))
            return false;
        for (const hide_line *line = w->line; line < w->line + w->line_count; line++) {
            writer.body = job->crossings.item[line->is.edge].body[0];
            if (!add_segments(job, w, &writer, line))
                return false;
        }
    }
    return true;
}
