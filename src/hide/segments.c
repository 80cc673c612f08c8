/* segments.c - see segments.h. */
#include "hide/segments.h"

#include "base/array.h"

/* ---- lines to segments ----------------------------------------------------------------------------------------- */

/* What all segments of a line have in common. */
typedef struct line_row {
    uint32_t body, v[2], edge;
    uint8_t class;
    double t0, t1; /* what the line is of the edge that it names */
} line_row;

BITS_INLINE line_row row_of(const hide_job *job, uint32_t body, const seen_line *line)
{
    seen_name name = seen_line_name(&job->seen, body, line);
    double width = name.t1 - name.t0;
    return (line_row){.body = body,
                      .v = {name.v[0], name.v[1]},
                      .edge = line->edge,
                      .class = line->class,
                      .t0 = name.t0 + width * line->t0,
                      .t1 = line->t1 == 1.0 ? name.t1 : name.t0 + width * line->t1};
}

/* Where on the edge in space a point of its picture is; view_to_space() without a call where it has nothing to do. */
static inline double to_space(const view *v, const hide_edge *e, double s)
{
    return v->perspective ? view_to_space(v, e->A.z, e->B.z, s) : s;
}

/* Writes the part s0..s1 of a line, unless rounding leaves no length of it in space. by: who hides it; ROBERTS_NONE: it
 * is visible. There is room for it. */
BITS_INLINE void put_part(const hide_job *job, hide_chunk *out, const line_row *row, const hide_edge *e,
                          const hide_interval *part, uint32_t by)
{
    const view *v = &job->seen.view;
    double unit = v->unit, width = row->t1 - row->t0, s0 = part->t0, s1 = part->t1;
    double t0 = row->t0 + width * to_space(v, e, s0), t1 = s1 == 1.0 ? row->t1 : row->t0 + width * to_space(v, e, s1);
    if (t0 >= t1)
        return;
    roberts_vec3 R0 = hide_edge_at(e, s0), R1 = hide_edge_at(e, s1);
    out->segment[out->count++] = (roberts_segment){.solid = row->body,
                                                   .v0 = row->v[0],
                                                   .v1 = row->v[1],
                                                   .by = by,
                                                   .t0 = t0,
                                                   .t1 = t1,
                                                   .p0 = {R0.x * unit, R0.y * unit},
                                                   .p1 = {R1.x * unit, R1.y * unit},
                                                   .z0 = R0.z * unit,
                                                   .z1 = R1.z * unit,
                                                   .state = by == ROBERTS_NONE ? ROBERTS_VISIBLE : ROBERTS_HIDDEN,
                                                   .line = row->class,
                                                   .edge = row->edge};
}

/* Writes what the near plane has taken, from t0 to t1 of the edge. at: where it is cut. There is room for it. */
static void put_taken(const hide_job *job, hide_chunk *out, const line_row *row, roberts_vec3 at)
{
    roberts_vec2 cut = {at.x * job->seen.view.unit, at.y * job->seen.view.unit};
    if (row->t0 < row->t1)
        out->segment[out->count++] = (roberts_segment){.solid = row->body,
                                                       .v0 = row->v[0],
                                                       .v1 = row->v[1],
                                                       .by = ROBERTS_NONE,
                                                       .t0 = row->t0,
                                                       .t1 = row->t1,
                                                       .p0 = cut,
                                                       .p1 = cut,
                                                       .state = ROBERTS_CLIPPED,
                                                       .line = row->class,
                                                       .edge = row->edge};
}

/* What the near plane has taken of the line before it (which: SEEN_TAKEN_BEFORE), after it, or instead of it. */
static BITS_RARE void add_taken(const hide_job *job, hide_chunk *out, uint32_t body, const hide_line *line, int which)
{
    seen_line taken = line->is;
    if (!(taken.taken & which))
        return;
    taken.t0 = which == SEEN_TAKEN_AFTER ? line->is.t1 : 0.0;
    taken.t1 = which == SEEN_TAKEN_BEFORE ? line->is.t0 : 1.0;
    line_row row = row_of(job, body, &taken);
    put_taken(job, out, &row, which == SEEN_TAKEN_AFTER ? line->e.B : line->e.A);
}

/* Visible segments of a line between its hidden parts, and those too where they are wanted. False: no memory. */
BITS_INLINE bool add_line(const hide_job *job, hide_chunk *out, uint32_t body, const hide_line *line)
{
    bool all = job->options->keep_hidden;
    size_t parts = line->intervals.count;
    hide_interval shown = {.t0 = 0.0};
    if (!array_reserve(&out->segment, &out->room, out->count + 2 * parts + 3, sizeof *out->segment))
        return false;
    if (line->is.taken)
        add_taken(job, out, body, line, line->is.taken & SEEN_TAKEN ? SEEN_TAKEN : SEEN_TAKEN_BEFORE);
    if (line->is.taken & SEEN_TAKEN)
        return true;
    line_row row = row_of(job, body, &line->is);
    for (size_t i = 0; i <= parts; i++) {
        const hide_solid_interval *hidden = i < parts ? &line->intervals.item[i] : NULL;
        shown.t1 = hidden ? hidden->part.t0 : 1.0;
        if (shown.t1 > shown.t0)
            put_part(job, out, &row, &line->e, &shown, ROBERTS_NONE);
        if (hidden && all)
            put_part(job, out, &row, &line->e, &hidden->part, hidden->solid);
        shown.t0 = hidden ? hidden->part.t1 : 1.0;
    }
    if (line->is.taken)
        add_taken(job, out, body, line, SEEN_TAKEN_AFTER);
    return true;
}

/* What the near plane has taken of a piece, from t0 to t1 of the edge, if that is anything. There is room for it. */
static void put_taken_piece(const hide_job *job, hide_chunk *out, uint32_t body, seen_line piece, roberts_vec3 at)
{
    if (piece.t0 >= piece.t1)
        return;
    line_row row = row_of(job, body, &piece);
    put_taken(job, out, &row, at);
}

/* Writes the parts of a line from s0 to s1 of its picture. There is room for them. */
static void put_parts(const hide_job *job, hide_chunk *out, const line_row *row, const hide_line *line,
                      const hide_interval *all)
{
    hide_interval shown = {.t0 = all->t0};
    for (size_t i = 0; i < line->intervals.count; i++) {
        hide_interval hidden = line->intervals.item[i].part;
        hidden.t0 = greater(hidden.t0, all->t0);
        hidden.t1 = lesser(hidden.t1, all->t1);
        if (hidden.t0 >= hidden.t1)
            continue;
        shown.t1 = hidden.t0;
        if (shown.t1 > shown.t0)
            put_part(job, out, row, &line->e, &shown, ROBERTS_NONE);
        if (job->options->keep_hidden)
            put_part(job, out, row, &line->e, &hidden, line->intervals.item[i].solid);
        shown.t0 = hidden.t1;
    }
    shown.t1 = all->t1;
    if (shown.t1 > shown.t0)
        put_part(job, out, row, &line->e, &shown, ROBERTS_NONE);
}

/* The segments of one piece of a line, which has a class of its own. False: no memory. */
static bool add_piece(const hide_job *job, hide_chunk *out, uint32_t body, const hide_line *line,
                      const union_piece *piece, uint8_t class)
{
    const view *v = &job->seen.view;
    const hide_edge *e = &line->e;
    const seen_line *whole = &line->is;
    seen_line part = *whole;
    bool gone = whole->taken & SEEN_TAKEN;
    if (!array_reserve(&out->segment, &out->room, out->count + 2 * line->intervals.count + 3, sizeof *out->segment))
        return false;
    part.class = class;
    part.t0 = piece->t0;
    part.t1 = gone ? piece->t1 : lesser(piece->t1, whole->t0);
    if (whole->taken & (SEEN_TAKEN | SEEN_TAKEN_BEFORE))
        put_taken_piece(job, out, body, part, e->A);
    double t0 = greater(piece->t0, whole->t0), t1 = lesser(piece->t1, whole->t1), width = whole->t1 - whole->t0;
    if (!gone && t0 < t1) {
        part.t0 = whole->t0;
        part.t1 = whole->t1;
        line_row row = row_of(job, body, &part);
        hide_interval shown = {.t0 = view_from_space(v, e->A.z, e->B.z, (t0 - whole->t0) / width), .t1 = 1.0};
        if (t1 < whole->t1)
            shown.t1 = view_from_space(v, e->A.z, e->B.z, (t1 - whole->t0) / width);
        put_parts(job, out, &row, line, &shown);
    }
    part.t0 = greater(piece->t0, whole->t1);
    part.t1 = piece->t1;
    if (whole->taken & SEEN_TAKEN_AFTER)
        put_taken_piece(job, out, body, part, e->B);
    return true;
}

/* The segments of a line that has pieces. False: no memory. */
static bool add_pieces(const hide_job *job, hide_chunk *out, uint32_t body, const hide_line *line)
{
    const union_piece *piece = line->is.piece;
    for (bool last = false; !last; piece++) {
        uint8_t class;
        if (seen_piece_class(&job->seen, body, &line->is, piece, &class) &&
            !add_piece(job, out, body, line, piece, class))
            return false;
        last = piece->t1 == 1.0;
    }
    return true;
}

static bool add_lines(const hide_job *job, const hide_worker *w, hide_chunk *out, uint32_t body)
{
    bool all = job->options->keep_hidden;
    for (const hide_line *line = w->line, *end = line + w->line_count; line < end; line++)
        if ((all || !line->hidden) &&
            !(line->is.piece ? add_pieces(job, out, body, line) : add_line(job, out, body, line)))
            return false;
    return true;
}

/* ---- bodies to lines ------------------------------------------------------------------------------------------- */

/* Has the body segments? Of one that the near plane has taken, only those that say so. */
static bool has_segments(const hide_job *job, uint32_t body)
{
    return !job->fronts.culled[body] || (job->seen.clip.clipped && job->options->keep_hidden);
}

/* Takes up a body's next lines, `most` of them or all. What lies behind covers is hidden at once; covers are kept only
 * where hidden lines are not wanted. A line without a front face is hidden by its own body. False: no memory. */
static bool take_lines(const hide_job *job, hide_worker *w, seen_walk *walk, size_t most)
{
    const cover *c = &job->fronts.cover;
    const roberts_vec3 *P = job->fronts.P;
    size_t left = walk->end - walk->edge;
    hide_worker_begin(w, walk->key);
    if (!hide_worker_reserve(w, left < most ? left : most))
        return false;
    for (hide_line *line = w->line; w->line_count < most && seen_next(walk, &line->is);) {
        const seen_line *is = &line->is;
        if (is->taken & SEEN_TAKEN) {
            hide_worker_add_taken(w, line++);
            continue;
        }
        w->drawn++;
        if (c->depth && cover_hides_edge(c, P[is->v[0]], P[is->v[1]])) {
            w->sides.tally.covered++;
            continue;
        }
        hide_worker_add(w, line);
        line->hidden = is->class == ROBERTS_BACK;
        if (line->hidden && !hide_intervals_add(&line->intervals, walk->body, &(hide_interval){0.0, 1.0, 0.0, 1.0}))
            return false;
        line++;
    }
    w->surviving += walk->surviving;
    walk->surviving = 0;
    return true;
}

/* The body of each hidden part becomes the one that is seen there, in its middle. */
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
            uint32_t body = hide_seen_at(w, middle.x, middle.y);
            if (body != ROBERTS_NONE) /* else the point lies on a border and rounding has put it outside */
                hidden->solid = body;
        }
}

/* Finds what is hidden of the lines taken up. False: no memory. */
static bool hide_lines(const hide_job *job, hide_worker *w)
{
    if (!hide_worker_run(w))
        return false;
    if (job->options->keep_hidden)
        name_hiders(job, w);
    return true;
}

bool segments_hide(const hide_job *job, hide_worker *w, uint32_t body)
{
    hide_worker_begin(w, ROBERTS_NONE);
    if (!has_segments(job, body))
        return true;
    seen_walk walk = seen_walk_begin(&job->seen, body);
    return take_lines(job, w, &walk, SIZE_MAX) && hide_lines(job, w);
}

/* The lines of a convex body are taken all together: they have the same own faces. Those of another body are taken a
 * group at a time. */
static bool find_in_body(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t body)
{
    if (!has_segments(job, body))
        return true;
    if (scene_is_convex(job->seen.scene, body))
        return (job->order.solid ? picture_order_recall(&job->order, body, w) : segments_hide(job, w, body)) &&
               add_lines(job, w, out, body);
    seen_walk walk = seen_walk_begin(&job->seen, body);
    while (walk.edge < walk.end)
        if (!take_lines(job, w, &walk, HIDE_GROUP) || !hide_lines(job, w) || !add_lines(job, w, out, body))
            return false;
    return true;
}

bool segments_find(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t first, uint32_t end)
{
    for (uint32_t s = first; s < end; s++) {
        if (job->order.solid)
            picture_order_fetch(&job->order, s);
        if (!find_in_body(job, w, out, s))
            return false;
    }
    return true;
}
