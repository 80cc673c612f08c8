/* union_judge.c - see union_judge.h. A line and a row lie in one place if the ends of one lie on the line of the other.
 * Their lengths are then compared along either. */
#include "union_judge.h"

#include <math.h>
#include <stdlib.h>

#include "judge.h"
#include "lines.h"

enum { REPORTS = 3 /* most failures reported for a scene */ };

/* Points this near count as one, as a part of the scene's size. */
#define SAME_PLACE 1e-11

typedef struct list {
    oracle_interval *interval;
    size_t count;
} list;

typedef struct work {
    const union_case *c;
    const union_row *row;
    size_t count;
    double near; /* model units */
    list a, b;
    size_t failed;
    mesh_total *total;
    FILE *out;
} work;

/* Does `other` lie on the line and overlap it? *t0 and *t1: the parameters of its ends along the line, which may lie
 * beyond 0 and 1. */
static bool coincide(const work *w, const roberts_vec3 line[2], const roberts_vec3 other[2], double *t0, double *t1)
{
    double off0, off1;
    double length = line_length(line[0], line[1]), reach = line_length(other[0], other[1]);
    *t0 = line_beside(line[0], line[1], other[0], &off0);
    *t1 = line_beside(line[0], line[1], other[1], &off1);
    if (fmax(off0, off1) > w->near * fmax(1, reach / length))
        return false;
    return fmax(*t0, *t1) > 0 && fmin(*t0, *t1) < 1;
}

static void add(list *l, double t0, double t1)
{
    t0 = fmax(t0, 0);
    t1 = fmin(t1, 1);
    if (t0 < t1)
        l->interval[l->count++] = (oracle_interval){t0, t1};
}

/* Adds the parts of line l that are drawn, or visible. Each t becomes from + t * (to - from). */
static void add_truth(const work *w, list *out, const union_line *l, bool visible, double from, double to)
{
    const union_truth *truth = w->c->truth;
    for (size_t i = l->part; i < l->part + l->parts; i++) {
        double t = truth->part[i].t0, end = truth->part[i].t1;
        for (size_t k = l->first; visible && k < l->first + l->count && t < end; k++) {
            const oracle_interval *hidden = &truth->interval[k];
            if (hidden->t1 <= t || hidden->t0 >= end)
                continue;
            if (t < hidden->t0)
                add(out, fmin(from + t * (to - from), from + hidden->t0 * (to - from)),
                    fmax(from + t * (to - from), from + hidden->t0 * (to - from)));
            t = hidden->t1;
        }
        if (t < end)
            add(out, fmin(from + t * (to - from), from + end * (to - from)),
                fmax(from + t * (to - from), from + end * (to - from)));
    }
}

static void tell(work *w, const roberts_vec3 end[2], const char *what, double how_much)
{
    w->total->disagreements++;
    if (++w->failed <= REPORTS)
        fprintf(w->out, "%s: (%.9g, %.9g, %.9g) to (%.9g, %.9g, %.9g): %s (%.3g)\n", w->c->name, end[0].x, end[0].y,
                end[0].z, end[1].x, end[1].y, end[1].z, what, how_much);
}

static double limit_of(const work *w, const roberts_vec3 end[2])
{
    return MESH_JUDGE_LIMIT + w->near / line_length(end[0], end[1]);
}

/* All that the oracle draws, or sees, must be in the table. */
static void judge_line(work *w, const union_line *l, bool visible)
{
    const roberts_vec3 end[2] = {l->a, l->b};
    double t0, t1;
    w->a.count = w->b.count = 0;
    add_truth(w, &w->a, l, visible, 0, 1);
    for (size_t i = 0; i < w->count; i++) {
        const roberts_vec3 other[2] = {w->row[i].p, w->row[i].q};
        if ((!visible || w->row[i].visible) && coincide(w, end, other, &t0, &t1))
            add(&w->b, fmin(t0, t1), fmax(t0, t1));
    }
    w->a.count = line_join(w->a.interval, w->a.count, 0);
    w->b.count = line_join(w->b.interval, w->b.count, 0.5 * limit_of(w, end));
    double missing = judge_outside(w->a.interval, w->a.count, w->b.interval, w->b.count);
    if (missing > limit_of(w, end))
        tell(w, end, visible ? "less of it is visible than should be" : "less of it is drawn than should be", missing);
    else
        w->total->worst = fmax(w->total->worst, missing);
}

static union_class class_of(uint8_t line)
{
    /* edges that no face shows have names of their own in the library, but not in tables */
    bool outline = line == ROBERTS_OUTLINE || line == ROBERTS_BACK_OUTLINE;
    bool crease = line == ROBERTS_CREASE || line == ROBERTS_BACK;
    return outline ? UNION_OUTLINE : crease ? UNION_CREASE : UNION_OPEN;
}

/* A row must lie where something is drawn, and be of its class. */
static void judge_row(work *w, const union_row *row)
{
    const roberts_vec3 end[2] = {row->p, row->q};
    double t0, t1, limit = limit_of(w, end), wrong = 0;
    w->a.count = 0;
    w->b.count = 0;
    add(&w->a, 0, 1);
    for (size_t i = 0; i < w->c->truth->line_count; i++) {
        const union_line *l = &w->c->truth->line[i];
        const roberts_vec3 other[2] = {l->a, l->b};
        if (!coincide(w, end, other, &t0, &t1))
            continue;
        add_truth(w, &w->b, l, row->visible, t0, t1);
        for (size_t k = l->part; k < l->part + l->parts; k++) {
            const union_part *part = &w->c->truth->part[k];
            double from = t0 + part->t0 * (t1 - t0), to = t0 + part->t1 * (t1 - t0);
            double shared = fmin(fmax(from, to), 1) - fmax(fmin(from, to), 0);
            if (part->class_ != UNION_OPEN && part->class_ != class_of(row->line) && shared > limit)
                wrong = fmax(wrong, shared);
        }
    }
    w->b.count = line_join(w->b.interval, w->b.count, 0.5 * limit);
    double extra = judge_outside(w->a.interval, 1, w->b.interval, w->b.count);
    if (extra > limit)
        tell(w, end, row->visible ? "a row is visible where nothing is" : "a row is drawn where nothing is", extra);
    else if (wrong > limit)
        tell(w, end, row->line == ROBERTS_INTERSECTION ? "the class is intersection" : "the class is wrong", wrong);
}

size_t union_judge_rows(const union_case *c, const union_row *row, size_t count, mesh_total *total, FILE *out)
{
    const union_truth *truth = c->truth;
    size_t most = count + 2 * (truth->part_count + truth->interval_count) + 2;
    work w = {.c = c,
              .row = row,
              .count = count,
              .a.interval = malloc(most * sizeof *w.a.interval),
              .b.interval = malloc(most * sizeof *w.b.interval),
              .near = SAME_PLACE * mesh_size(&c->scene->mesh),
              .total = total,
              .out = out};
    for (size_t i = 0; w.a.interval && w.b.interval && i < truth->line_count; i++) {
        total->lines++;
        total->lines_cut += truth->line[i].parts > 0;
        /* lines where faces cross are judged only where they are visible */
        if (!truth->line[i].crossing)
            judge_line(&w, &truth->line[i], false);
        if (!truth->line[i].crossing || !truth->line[i].edge_on)
            judge_line(&w, &truth->line[i], true);
    }
    for (size_t i = 0; w.a.interval && w.b.interval && i < count; i++)
        judge_row(&w, &row[i]);
    free(w.a.interval);
    free(w.b.interval);
    return w.failed;
}

size_t union_judge_drawing(const union_case *c, const roberts_drawing *drawing, mesh_total *total, FILE *out)
{
    union_row *row = malloc((drawing->count + 1) * sizeof *row);
    for (size_t i = 0; row && i < drawing->count; i++) {
        const roberts_segment *s = &drawing->segment[i];
        const roberts_vec3 *vertex = c->scene->mesh.vertex;
        bool crossing = s->line == ROBERTS_INTERSECTION || s->v0 == ROBERTS_NONE;
        roberts_vec3 p = crossing ? drawing->crossing[s->edge].end[0] : vertex[s->v0];
        roberts_vec3 q = crossing ? drawing->crossing[s->edge].end[1] : vertex[s->v1];
        row[i] = (union_row){line_point(p, q, s->t0), line_point(p, q, s->t1), s->state == ROBERTS_VISIBLE, s->line};
    }
    size_t failed = row ? union_judge_rows(c, row, drawing->count, total, out) : 1;
    free(row);
    return failed;
}

union_row *union_rows_of_truth(const union_truth *truth, size_t *count)
{
    union_row *row = malloc((2 * (truth->part_count + truth->interval_count) + 1) * sizeof *row);
    *count = 0;
    for (size_t i = 0; row && i < truth->line_count; i++) {
        const union_line *l = &truth->line[i];
        for (size_t k = l->part; k < l->part + l->parts; k++) {
            const union_part *part = &truth->part[k];
            uint8_t line = part->class_ == UNION_OUTLINE ? ROBERTS_OUTLINE : ROBERTS_CREASE;
            double t = part->t0;
            for (size_t h = l->first; h <= l->first + l->count; h++) {
                bool last = h == l->first + l->count;
                double from = last ? part->t1 : fmin(truth->interval[h].t0, part->t1);
                double to = last ? part->t1 : fmin(truth->interval[h].t1, part->t1);
                if (t < from)
                    row[(*count)++] = (union_row){line_point(l->a, l->b, t), line_point(l->a, l->b, from), true, line};
                t = fmax(t, from);
                if (t < to)
                    row[(*count)++] = (union_row){line_point(l->a, l->b, t), line_point(l->a, l->b, to), false, line};
                t = fmax(t, to);
            }
        }
    }
    return row;
}
