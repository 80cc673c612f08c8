/* segments.c - see segments.h. */
#include "hide/segments.h"

#include "base/array.h"

/* ---- lines to segments ----------------------------------------------------------------------------------------- */

/* What all rows of a line have in common. Its t0..t1 is what the line is of the edge that it names. */
static inline roberts_segment row_of(const hide_job *job, uint32_t body, const seen_line *line)
{
    seen_name name = seen_edge_name(job->seen.source, body, line->edge);
    double width = name.t1 - name.t0;
    return (roberts_segment){.solid = body,
                             .v0 = name.v[0],
                             .v1 = name.v[1],
                             .by = ROBERTS_NONE,
                             .t0 = name.t0 + width * line->t0,
                             .t1 = line->t1 == 1.0 ? name.t1 : name.t0 + width * line->t1,
                             .state = ROBERTS_VISIBLE,
                             .line = line->class,
                             .edge = line->edge};
}

/* Where on the edge in space a point of its picture is; view_to_space() without a call where it has nothing to do. */
static inline double to_space(const view *v, const hide_edge *e, double s)
{
    return v->perspective ? view_to_space(v, e->A.z, e->B.z, s) : s;
}

/* Writes the part s0..s1 of a line, unless rounding leaves no length of it in space. There is room for it. */
static inline void put_part(const hide_job *job, hide_chunk *out, const roberts_segment *row, const hide_edge *e,
                            double s0, double s1)
{
    const view *v = &job->seen.view;
    double unit = v->unit, width = row->t1 - row->t0;
    double t0 = row->t0 + width * to_space(v, e, s0), t1 = s1 == 1.0 ? row->t1 : row->t0 + width * to_space(v, e, s1);
    if (t0 >= t1)
        return;
    roberts_vec3 R0 = hide_edge_at(e, s0), R1 = hide_edge_at(e, s1);
    out->segment[out->count++] = (roberts_segment){.solid = row->solid,
                                                   .v0 = row->v0,
                                                   .v1 = row->v1,
                                                   .by = row->by,
                                                   .t0 = t0,
                                                   .t1 = t1,
                                                   .p0 = {R0.x * unit, R0.y * unit},
                                                   .p1 = {R1.x * unit, R1.y * unit},
                                                   .z0 = R0.z * unit,
                                                   .z1 = R1.z * unit,
                                                   .state = row->state,
                                                   .line = row->line,
                                                   .edge = row->edge};
}

static void put_hidden(const hide_job *job, hide_chunk *out, const roberts_segment *row, const hide_edge *e,
                       const hide_solid_interval *hidden)
{
    roberts_segment part = *row;
    part.state = ROBERTS_HIDDEN;
    part.by = hidden->solid;
    put_part(job, out, &part, e, hidden->part.t0, hidden->part.t1);
}

/* Writes what the near plane has taken, from t0 to t1 of the edge. `at`: where it is cut. There is room for it. */
static void put_taken(const hide_job *job, hide_chunk *out, uint32_t body, seen_line line, roberts_vec3 at)
{
    double unit = job->seen.view.unit;
    roberts_segment row = row_of(job, body, &line);
    row.state = ROBERTS_CLIPPED;
    row.p0 = row.p1 = (roberts_vec2){at.x * unit, at.y * unit};
    if (row.t0 < row.t1)
        out->segment[out->count++] = row;
}

/* Writes what the near plane has taken of a piece from t0 to t1 of the edge, if that is anything. */
static void put_taken_piece(const hide_job *job, hide_chunk *out, uint32_t body, seen_line piece, roberts_vec3 at)
{
    if (piece.t0 < piece.t1)
        put_taken(job, out, body, piece, at);
}

/* Writes the rows of one piece of a line; `piece`: the line in the class of the piece, from t0 to t1 of the edge. There
 * is room for them. */
static void put_piece(const hide_job *job, hide_chunk *out, uint32_t body, const hide_line *line, seen_line piece)
{
    const view *v = &job->seen.view;
    const hide_edge *e = &line->e;
    const seen_line *whole = &line->is;
    double t0 = greater(piece.t0, whole->t0), t1 = lesser(piece.t1, whole->t1), length = whole->t1 - whole->t0;
    double at0 = piece.t0, at1 = piece.t1;
    if (whole->taken & (SEEN_TAKEN | SEEN_TAKEN_BEFORE)) {
        piece.t1 = whole->taken & SEEN_TAKEN ? at1 : lesser(at1, whole->t0);
        put_taken_piece(job, out, body, piece, e->A);
    }
    if (!(whole->taken & SEEN_TAKEN) && t0 < t1) {
        double s0 = view_from_space(v, e->A.z, e->B.z, (t0 - whole->t0) / length);
        double s1 = t1 == whole->t1 ? 1.0 : view_from_space(v, e->A.z, e->B.z, (t1 - whole->t0) / length), from = s0;
        piece.t0 = whole->t0;
        piece.t1 = whole->t1;
        roberts_segment row = row_of(job, body, &piece);
        for (size_t i = 0; i < line->intervals.count; i++) {
            hide_solid_interval hidden = line->intervals.item[i];
            hidden.part.t0 = greater(hidden.part.t0, s0);
            hidden.part.t1 = lesser(hidden.part.t1, s1);
            if (hidden.part.t0 >= hidden.part.t1)
                continue;
            if (hidden.part.t0 > from)
                put_part(job, out, &row, e, from, hidden.part.t0);
            if (job->options->keep_hidden)
                put_hidden(job, out, &row, e, &hidden);
            from = hidden.part.t1;
        }
        if (from < s1)
            put_part(job, out, &row, e, from, s1);
    }
    if (whole->taken & SEEN_TAKEN_AFTER) {
        piece.t0 = greater(at0, whole->t1);
        piece.t1 = at1;
        put_taken_piece(job, out, body, piece, e->B);
    }
}

/* The same of a line that has pieces, in the class of each. False: no memory. */
static bool add_pieces(const hide_job *job, hide_chunk *out, uint32_t body, const hide_line *line)
{
    for (const union_piece *p = line->is.piece, *last = NULL; !last; p++) {
        seen_line piece = line->is;
        if (!array_reserve(&out->segment, &out->room, out->count + 2 * line->intervals.count + 3, sizeof *out->segment))
            return false;
        piece.t0 = p->t0;
        piece.t1 = p->t1;
        if (seen_piece_class(&job->seen, body, &line->is, p, &piece.class))
            put_piece(job, out, body, line, piece);
        last = p->t1 == 1.0 ? p : NULL;
    }
    return true;
}

/* Visible segments of a line between its hidden parts, and those too where they are wanted. False: no memory. */
static inline bool add_line(const hide_job *job, hide_chunk *out, uint32_t body, const hide_line *line)
{
    bool all = job->options->keep_hidden;
    const hide_edge *e = &line->e;
    size_t parts = line->intervals.count;
    double from = 0.0;
    if (line->hidden && !all)
        return true;
    if (line->is.piece)
        return add_pieces(job, out, body, line);
    if (!array_reserve(&out->segment, &out->room, out->count + 2 * parts + 3, sizeof *out->segment))
        return false;
    seen_line taken = line->is;
    if (line->is.taken & (SEEN_TAKEN | SEEN_TAKEN_BEFORE)) {
        taken.t0 = 0.0;
        taken.t1 = line->is.taken & SEEN_TAKEN ? 1.0 : line->is.t0;
        put_taken(job, out, body, taken, e->A);
    }
    if (line->is.taken & SEEN_TAKEN)
        return true;
    roberts_segment row = row_of(job, body, &line->is);
    for (size_t i = 0; i < parts; i++) {
        const hide_interval *part = &line->intervals.item[i].part;
        if (part->t0 > from)
            put_part(job, out, &row, e, from, part->t0);
        if (all)
            put_hidden(job, out, &row, e, &line->intervals.item[i]);
        from = part->t1;
    }
    if (from < 1.0)
        put_part(job, out, &row, e, from, 1.0);
    if (line->is.taken & SEEN_TAKEN_AFTER) {
        taken.t0 = line->is.t1;
        taken.t1 = 1.0;
        put_taken(job, out, body, taken, e->B);
    }
    return true;
}

static bool add_lines(const hide_job *job, const hide_worker *w, hide_chunk *out, uint32_t body)
{
    for (const hide_line *line = w->line, *end = line + w->line_count; line < end; line++)
        if (!add_line(job, out, body, line))
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
    hide_worker_begin(w);
    while (w->line_count < most) {
        hide_line *line = hide_worker_next(w);
        if (!line)
            return false;
        const seen_line *is = &line->is;
        if (!seen_next(walk, &line->is))
            break;
        if (is->taken & SEEN_TAKEN) {
            hide_worker_add_taken(w);
            continue;
        }
        w->drawn++;
        if (c->depth && cover_hides_edge(c, P[is->v[0]], P[is->v[1]])) {
            w->sides.tally.covered++;
            continue;
        }
        hide_worker_add(w);
        line->hidden = is->class == ROBERTS_BACK;
        if (line->hidden && !hide_intervals_add(&line->intervals, walk->body, &(hide_interval){0.0, 1.0, 0.0, 1.0}))
            return false;
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
    hide_worker_begin(w);
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
