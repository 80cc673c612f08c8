/* cross_judge.c - see cross_judge.h. A row belongs to the line of its two faces that holds its middle. */
#include "cross_judge.h"

#include <math.h>
#include <stdlib.h>

#include "lines.h"
#include "mesh_picture.h"

enum { REPORTS = 3 /* most failures reported for a scene */ };

/* Ends may be off by this part of the scene's size, as rounding leaves them. */
#define END_ROUNDING 1e-13

typedef struct rows_at_hand {
    const cross_case *c;
    const cross_row *row;
    size_t count;
    bool *used;      /* [count] */
    size_t *mine;    /* [count] rows of the line at hand, in the table's order */
    double rounding; /* model units */
    size_t failed;
    mesh_total *total;
    FILE *out;
} rows_at_hand;

/* The greatest error of t that is allowed on a line. */
static double t_limit(const rows_at_hand *r, const cross_line *l)
{
    return MESH_JUDGE_LIMIT + r->rounding / line_length(l->a, l->b);
}

static void tell(rows_at_hand *r, uint32_t f0, uint32_t f1, const char *what, double how_much)
{
    r->total->disagreements++;
    if (++r->failed <= REPORTS)
        fprintf(r->out, "%s: faces %u and %u: %s (%.3g)\n", r->c->name, f0, f1, what, how_much);
}

static bool is_of(const cross_row *row, const cross_line *l, double limit)
{
    if (row->f0 != l->f0 || row->f1 != l->f1)
        return false;
    roberts_vec3 middle = {0.5 * (row->p.x + row->q.x), 0.5 * (row->p.y + row->q.y), 0.5 * (row->p.z + row->q.z)};
    double t = line_along(l->a, l->b, middle);
    return t >= -limit && t <= 1 + limit;
}

/* What is wrong with a row on its line; NULL: nothing. */
static const char *fault_of(const rows_at_hand *r, const cross_row *row, const cross_line *l, double *how_much)
{
    double loose = r->rounding + MESH_JUDGE_LIMIT * line_length(l->a, l->b) + 1e3 * r->c->scene->slack;
    *how_much = fmax(line_length(row->p, line_point(l->a, l->b, row->t0)),
                     line_length(row->q, line_point(l->a, l->b, row->t1)));
    if (!(*how_much <= loose))
        return "an end is not where t says";
    *how_much = row->t1 - row->t0;
    if (!(0 <= row->t0 && row->t0 < row->t1 && row->t1 <= 1))
        return "t is not within 0 and 1, or does not ascend";
    *how_much = 0;
    if (!row->intersection)
        return "the class is not intersection";
    *how_much = row->body;
    if (r->c->face_body && r->c->face_body[row->f0] != ROBERTS_NONE && r->c->face_body[row->f0] != row->body)
        return "the body is not that of the first face";
    return NULL;
}

/* Returns the length that the rows of a line leave out between 0 and 1. *turns: do neighbours differ in state? */
static double gaps(const rows_at_hand *r, size_t mine, bool *turns)
{
    double end = 0, gap = 0;
    *turns = true;
    for (size_t i = 0; i < mine; i++) {
        const cross_row *row = &r->row[r->mine[i]];
        gap += fabs(row->t0 - end);
        end = row->t1;
        if (i > 0 && row->visible == r->row[r->mine[i - 1]].visible)
            *turns = false;
    }
    return gap + fabs(1 - end);
}

/* The length that is visible in one and hidden in the other. If the scene is not exact, the oracle is asked about
 * the middles. */
static double unlike(rows_at_hand *r, size_t mine, const cross_line *l)
{
    const oracle_interval *truth = r->c->truth->interval + l->first;
    const mesh_scene *s = r->c->scene;
    size_t cuts = 0;
    double wrong = 0, *cut = malloc((2 * (l->count + mine) + 2) * sizeof *cut);
    if (!cut)
        return 1;
    cut[cuts++] = 0;
    cut[cuts++] = 1;
    for (size_t i = 0; i < l->count; i++) {
        cut[cuts++] = truth[i].t0;
        cut[cuts++] = truth[i].t1;
    }
    for (size_t i = 0; i < mine; i++) {
        cut[cuts++] = r->row[r->mine[i]].t0;
        cut[cuts++] = r->row[r->mine[i]].t1;
    }
    qsort(cut, cuts, sizeof *cut, line_by_start);
    for (size_t i = 0; i + 1 < cuts; i++) {
        double t = 0.5 * (cut[i] + cut[i + 1]);
        bool known = false, mine_hides = false, theirs = false;
        for (size_t k = 0; k < mine; k++) {
            const cross_row *row = &r->row[r->mine[k]];
            if (row->t0 < t && t < row->t1) {
                known = true;
                mine_hides = !row->visible;
            }
        }
        for (size_t k = 0; k < l->count; k++)
            theirs = theirs || (truth[k].t0 < t && t < truth[k].t1);
        if (!known || mine_hides == theirs)
            continue;
        oracle_answer answer = theirs ? ORACLE_YES : ORACLE_NO;
        if (s->slack > 0) {
            const mesh_point X = {line_point(l->a, l->b, t), ROBERTS_NONE, ROBERTS_NONE, l->f0, l->f1};
            answer = mesh_truth_at(&s->mesh, &s->view, s->even_odd, r->c->position, &X, s->slack);
        }
        if (answer == ORACLE_UNSURE || (answer == ORACLE_YES) == mine_hides)
            r->total->unjudged += cut[i + 1] - cut[i];
        else
            wrong += cut[i + 1] - cut[i];
    }
    free(cut);
    return wrong;
}

/* Does the line surely exist somewhere in the gaps between its rows? Without slack, always. */
static bool surely_missing(const rows_at_hand *r, size_t mine, const cross_line *l)
{
    const mesh_scene *s = r->c->scene;
    double from = 0;
    if (s->slack == 0)
        return true;
    for (size_t i = 0; i <= mine; i++) {
        double to = i < mine ? r->row[r->mine[i]].t0 : 1;
        if (to - from > t_limit(r, l) &&
            cross_truth_at(&s->mesh, s->even_odd, l->f0, l->f1, line_point(l->a, l->b, 0.5 * (from + to)), s->slack) ==
                ORACLE_YES)
            return true;
        if (i < mine)
            from = r->row[r->mine[i]].t1;
    }
    return false;
}

/* Does the line have no rows? If one of its faces is edge-on, the border of that face covers it in the picture. */
static bool has_no_rows(const rows_at_hand *r, const cross_line *l)
{
    return l->edge_on || (l->on_edge && r->c->all_edges);
}

static void judge_line(rows_at_hand *r, const cross_line *l)
{
    double limit = t_limit(r, l), how_much;
    size_t mine = 0, before = r->failed;
    bool turns;
    r->total->lines++;
    r->total->on_edges += l->on_edge;
    r->total->lines_cut += l->count > 0;
    for (size_t i = 0; i < r->count; i++)
        if (!r->used[i] && is_of(&r->row[i], l, limit)) {
            const char *fault = fault_of(r, &r->row[i], l, &how_much);
            r->used[i] = true;
            r->mine[mine++] = i;
            if (fault) {
                tell(r, l->f0, l->f1, fault, how_much);
                return;
            }
        }
    double gap = gaps(r, mine, &turns);
    if (gap > limit) {
        if (surely_missing(r, mine, l))
            tell(r, l->f0, l->f1, mine ? "rows leave out a part of the line" : "no row for a line of this length",
                 mine ? gap : line_length(l->a, l->b));
        else
            r->total->unjudged += gap;
    } else if (!turns)
        tell(r, l->f0, l->f1, "two rows in the same state follow one another", 0);
    double wrong = unlike(r, mine, l);
    if (wrong > limit)
        tell(r, l->f0, l->f1, "program and oracle differ in what of the line is visible", wrong);
    else if (r->failed == before)
        r->total->worst = fmax(r->total->worst, wrong);
}

static void judge_order(rows_at_hand *r)
{
    for (size_t i = 0; i < r->count; i++) {
        const cross_row *p = &r->row[i];
        if (p->f0 >= p->f1)
            tell(r, p->f0, p->f1, "faces are not in order", 0);
        if (i > 0 && (p[-1].f0 > p->f0 || (p[-1].f0 == p->f0 && p[-1].f1 > p->f1)))
            tell(r, p->f0, p->f1, "rows are not in order", 0);
    }
}

/* Would the row belong to a line if its faces were f and g, which have the same corners? (Two bodies in one place each
 * have their own faces.) */
static bool has_twin(const rows_at_hand *r, const cross_row *row, uint32_t f, uint32_t g)
{
    cross_row twin = *row;
    twin.f0 = f < g ? f : g;
    twin.f1 = f < g ? g : f;
    for (size_t i = 0; i < r->c->truth->line_count; i++)
        if (is_of(&twin, &r->c->truth->line[i], t_limit(r, &r->c->truth->line[i])))
            return true;
    return false;
}

/* Reports rows that belong to no line of the oracle. */
static void judge_others(rows_at_hand *r)
{
    const mesh_scene *s = r->c->scene;
    for (size_t i = 0; i < r->count; i++) {
        const cross_row *p = &r->row[i];
        if (r->used[i])
            continue;
        if (p->f0 >= s->mesh.face_count || p->f1 >= s->mesh.face_count) {
            tell(r, p->f0, p->f1, "there is no such face", 0);
            continue;
        }
        uint32_t f = r->c->truth->same[p->f0], g = r->c->truth->same[p->f1];
        if (f != ROBERTS_NONE && g != ROBERTS_NONE && (f != p->f0 || g != p->f1) && has_twin(r, p, f, g))
            continue;
        roberts_vec3 X = {0.5 * (p->p.x + p->q.x), 0.5 * (p->p.y + p->q.y), 0.5 * (p->p.z + p->q.z)};
        if (s->slack == 0 || cross_truth_at(&s->mesh, s->even_odd, p->f0, p->f1, X, s->slack) == ORACLE_NO)
            tell(r, p->f0, p->f1, "a row of no line, of this length", line_length(p->p, p->q));
        else
            r->total->unjudged += 1;
    }
}

size_t cross_judge_rows(const cross_case *c, const cross_row *row, size_t count, mesh_total *total, FILE *out)
{
    rows_at_hand r = {.c = c,
                      .row = row,
                      .count = count,
                      .used = calloc(count + 1, sizeof *r.used),
                      .mine = malloc((count + 1) * sizeof *r.mine),
                      .rounding = END_ROUNDING * mesh_size(&c->scene->mesh),
                      .total = total,
                      .out = out};
    if (r.used && r.mine) {
        for (size_t i = 0; i < c->truth->line_count; i++)
            if (!has_no_rows(&r, &c->truth->line[i]))
                judge_line(&r, &c->truth->line[i]);
        judge_order(&r);
        judge_others(&r);
    } else {
        tell(&r, 0, 0, "no memory", 0);
    }
    free(r.used);
    free(r.mine);
    return r.failed;
}

/* ---- of a drawing ---- */

/* How far the picture of X is from p. */
static double beside(const picture *view, roberts_vec3 X, roberts_vec2 p)
{
    roberts_vec3 d = picture_minus(X, view->middle);
    double w = view->far > 0 ? 1 - picture_dot(d, view->toward) / view->far : 1;
    return hypot(picture_dot(d, view->right) / w - p.x, picture_dot(d, view->up) / w - p.y);
}

void cross_take_bodies(const roberts_scene *built, const roberts_drawing *drawing, uint32_t *body)
{
    for (size_t i = 0; i < drawing->count; i++) {
        const roberts_segment *s = &drawing->segment[i];
        uint32_t face[2];
        if (s->line == ROBERTS_INTERSECTION)
            continue;
        roberts_segment_faces(built, drawing, s, face);
        for (int k = 0; k < 2; k++)
            if (face[k] != ROBERTS_NONE)
                body[face[k]] = s->solid;
    }
}

size_t cross_judge_drawing(const cross_case *c, const roberts_scene *built, const roberts_drawing *drawing,
                           mesh_total *total, FILE *out)
{
    const mesh_scene *scene = c->scene;
    const picture view = picture_of(scene);
    size_t count = 0, failed = 0;
    double loose = 1e-9 * mesh_size(&scene->mesh) + 1e3 * scene->slack;
    cross_case with_bodies = *c;
    cross_row *row = malloc((drawing->count + 1) * sizeof *row);
    uint32_t *body = malloc((scene->mesh.face_count + 1) * sizeof *body);
    for (size_t f = 0; body && f < scene->mesh.face_count; f++)
        body[f] = ROBERTS_NONE;
    if (body)
        cross_take_bodies(built, drawing, body);
    for (size_t i = 0; row && body && i < drawing->count; i++) {
        const roberts_segment *s = &drawing->segment[i];
        uint32_t face[2];
        const char *fault = NULL;
        if (s->line != ROBERTS_INTERSECTION) {
            if (count > 0 && s->v0 != ROBERTS_NONE && ++failed == 1)
                fprintf(out, "%s: a row of an edge follows one of an intersection\n", c->name);
            continue;
        }
        roberts_segment_faces(built, drawing, s, face);
        if (s->edge >= drawing->crossing_count || s->v0 != ROBERTS_NONE || s->v1 != ROBERTS_NONE) {
            fault = "it names no line, or an edge";
        } else {
            const roberts_crossing *l = &drawing->crossing[s->edge];
            const cross_line ends = {.a = l->end[0], .b = l->end[1]};
            const cross_row r = {s->solid,
                                 face[0],
                                 face[1],
                                 true,
                                 s->state == ROBERTS_VISIBLE,
                                 s->t0,
                                 s->t1,
                                 line_point(ends.a, ends.b, s->t0),
                                 line_point(ends.a, ends.b, s->t1)};
            row[count++] = r;
            if (l->face[0] != face[0] || l->face[1] != face[1])
                fault = "its faces are not those of its line";
            else if (!(fmax(beside(&view, r.p, s->p0), beside(&view, r.q, s->p1)) <= loose))
                fault = "its ends are not where they are in the picture";
        }
        if (fault && ++failed <= REPORTS)
            fprintf(out, "%s: faces %u and %u: row %zu: %s\n", c->name, face[0], face[1], i, fault);
    }
    total->disagreements += failed;
    with_bodies.face_body = body;
    if (row && body)
        failed += cross_judge_rows(&with_bodies, row, count, total, out);
    free(row);
    free(body);
    return failed;
}

/* Converts the hidden intervals of a line to parameters of another line on which it lies. */
static void send_hidden(const cross_truth *truth, const cross_line *from, const cross_line *to)
{
    for (size_t k = from->first; k < from->first + from->count; k++) {
        oracle_interval *h = &truth->interval[k];
        double t0 = line_along(to->a, to->b, line_point(from->a, from->b, h->t0)),
               t1 = line_along(to->a, to->b, line_point(from->a, from->b, h->t1));
        *h = (oracle_interval){fmin(t0, t1), fmax(t0, t1)};
    }
}

/* Sorts the hidden intervals of a line and joins those within `gap`. */
static void join_hidden(const cross_truth *truth, cross_line *l, double gap)
{
    l->count = line_join(truth->interval + l->first, l->count, gap);
}

/* Joins two lines of the same faces if they meet within the slack. */
static bool unite(const cross_truth *truth, cross_line *l, const cross_line *next, double slack)
{
    const roberts_vec3 mine[2] = {l->a, l->b}, other[2] = {next->a, next->b};
    if (l->f0 != next->f0 || l->f1 != next->f1)
        return false;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            if (line_length(mine[i], other[k]) <= slack) {
                cross_line both = *l;
                both.a = i ? mine[0] : other[1 - k];
                both.b = i ? other[1 - k] : mine[1];
                send_hidden(truth, l, &both);
                send_hidden(truth, next, &both);
                for (size_t h = 0; h < next->count; h++) /* those of `next` lie further on, perhaps after a gap */
                    truth->interval[l->first + l->count + h] = truth->interval[next->first + h];
                both.count += next->count;
                join_hidden(truth, &both, 4 * slack / line_length(both.a, both.b));
                *l = both;
                return true;
            }
    return false;
}

static void turn_round(const cross_truth *truth, cross_line *l)
{
    cross_line turned = *l;
    turned.a = l->b;
    turned.b = l->a;
    send_hidden(truth, l, &turned);
    join_hidden(truth, &turned, 0);
    *l = turned;
}

/* May face f be edge-on if its corners move by the slack? It may if one plane through the viewer passes all of them
 * within the slack. The plane tried goes through the first corner and another one, for each other one. */
static bool may_be_edge_on(const mesh_scene *scene, uint32_t f)
{
    const roberts_mesh *m = &scene->mesh;
    const uint32_t *corner = m->corner + m->face_start[f];
    const uint32_t count = m->face_start[f + 1] - m->face_start[f];
    const roberts_vec3 first = m->vertex[corner[0]], viewer = {scene->view.x, scene->view.y, scene->view.z};
    const roberts_vec3 sight = scene->view.w ? picture_minus(viewer, first) : viewer;
    bool may = false;
    for (uint32_t i = 1; i < count && !may; i++) {
        roberts_vec3 n = picture_unit_cross(sight, picture_minus(m->vertex[corner[i]], first));
        may = true;
        for (uint32_t k = 1; k < count && may; k++)
            may = fabs(picture_dot(n, picture_minus(m->vertex[corner[k]], first))) <= scene->slack;
    }
    return may;
}

void cross_settle(const mesh_scene *scene, cross_truth *truth, const roberts_drawing *drawing)
{
    size_t count = 0;
    for (size_t i = 0; i < truth->line_count && scene->slack > 0; i++) {
        cross_line *last = count ? &truth->line[count - 1] : NULL;
        if (!last || !unite(truth, last, &truth->line[i], scene->slack))
            truth->line[count++] = truth->line[i];
    }
    if (scene->slack > 0)
        truth->line_count = count;
    for (size_t i = 0; i < truth->line_count && scene->slack > 0; i++) {
        cross_line *l = &truth->line[i];
        double straight = HUGE_VAL, turned = HUGE_VAL;
        l->edge_on |= may_be_edge_on(scene, l->f0) || may_be_edge_on(scene, l->f1);
        if (fabs(l->b.x - l->a.x) > scene->slack)
            continue;
        for (size_t k = 0; k < drawing->crossing_count; k++) {
            const roberts_crossing *c = &drawing->crossing[k];
            if (c->face[0] != l->f0 || c->face[1] != l->f1)
                continue;
            straight = fmin(straight, line_length(c->end[0], l->a) + line_length(c->end[1], l->b));
            turned = fmin(turned, line_length(c->end[0], l->b) + line_length(c->end[1], l->a));
        }
        if (turned < straight)
            turn_round(truth, l);
    }
}

cross_row *cross_rows_of_truth(const cross_truth *truth, const uint32_t *face_body, size_t *count)
{
    cross_row *row = malloc((2 * (truth->line_count + truth->interval_count) + 1) * sizeof *row);
    *count = 0;
    for (size_t i = 0; row && i < truth->line_count; i++) {
        const cross_line *l = &truth->line[i];
        double from = 0;
        for (size_t k = 0; k <= l->count && !l->edge_on; k++) {
            const oracle_interval *hidden = &truth->interval[l->first + k];
            const double end[2] = {k < l->count ? hidden->t0 : 1, k < l->count ? hidden->t1 : 1};
            for (int state = 0; state < 2; state++) {
                if (from < end[state])
                    row[(*count)++] = (cross_row){.body = face_body ? face_body[l->f0] : 0,
                                                  .f0 = l->f0,
                                                  .f1 = l->f1,
                                                  .intersection = true,
                                                  .visible = state == 0,
                                                  .t0 = from,
                                                  .t1 = end[state],
                                                  .p = line_point(l->a, l->b, from),
                                                  .q = line_point(l->a, l->b, end[state])};
                from = end[state];
            }
        }
    }
    return row;
}
