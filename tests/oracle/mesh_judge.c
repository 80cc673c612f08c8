/* mesh_judge.c - see mesh_judge.h. A row of the program belongs to an edge of the oracle if its ends lie on that edge:
 * the program may draw the edge as pieces of other edges of the file that lie on the same line. */
#include "mesh_judge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cross_judge.h"
#include "judge.h"
#include "lines.h"
#include "union_judge.h"

enum {
    REPORTS = 3,      /* most failures reported for a scene */
    MANY_EDGES = 3000 /* above this, rows are looked up by their vertices only */
};

/* A piece of an edge, as the program has it. */
typedef struct piece {
    double t0, t1;
    bool hidden;
} piece;

typedef struct judgement {
    const mesh_scene *scene;
    const mesh_truth *truth;
    const roberts_drawing *drawing;
    double size;  /* of the scene */
    piece *piece; /* [count] of the current edge; room for all segments */
    size_t count;
    oracle_interval *hidden; /* [hidden_count] hidden, joined */
    oracle_interval *any;    /* [count] covered by any piece */
    size_t hidden_count;
} judgement;

static void add_piece(judgement *j, double t0, double t1, bool hidden)
{
    if (t0 > t1) {
        double was = t0;
        t0 = t1;
        t1 = was;
    }
    t0 = fmax(t0, 0);
    t1 = fmin(t1, 1);
    if (t1 > t0)
        j->piece[j->count++] = (piece){t0, t1, hidden};
}

/* Takes the rows of the edge itself. */
static void take_own(judgement *j, const mesh_edge *e)
{
    const uint32_t *position = j->truth->position;
    for (size_t i = 0; i < j->drawing->count; i++) {
        const roberts_segment *s = &j->drawing->segment[i];
        if (s->v0 == ROBERTS_NONE)
            continue;
        uint32_t p = position[s->v0], q = position[s->v1];
        if (p == e->v0 && q == e->v1)
            add_piece(j, s->t0, s->t1, s->state != ROBERTS_VISIBLE);
        else if (p == e->v1 && q == e->v0)
            add_piece(j, 1 - s->t1, 1 - s->t0, s->state != ROBERTS_VISIBLE);
    }
}

/* Takes the rows of other edges that lie on this one's line. */
static void take_others(judgement *j, const mesh_edge *e)
{
    const roberts_vec3 *vertex = j->scene->mesh.vertex;
    roberts_vec3 a = vertex[e->v0], b = vertex[e->v1];
    for (size_t i = 0; i < j->drawing->count; i++) {
        const roberts_segment *s = &j->drawing->segment[i];
        double off0, off1;
        if (s->v0 == ROBERTS_NONE)
            continue;
        double t0 = line_beside(a, b, line_point(vertex[s->v0], vertex[s->v1], s->t0), &off0);
        double t1 = line_beside(a, b, line_point(vertex[s->v0], vertex[s->v1], s->t1), &off1);
        if (fmax(off0, off1) <= 1e-11 * j->size)
            add_piece(j, t0, t1, s->state != ROBERTS_VISIBLE);
    }
}

/* Joins the pieces. Everything between visible pieces is hidden. If two edges lie in one place, with vertices of their
 * own, and one is visible there, the line is visible. Returns the length of the edge, where it bounds something, that
 * no piece covers. */
static double uncovered(judgement *j, const mesh_edge *e)
{
    double end = 0;
    qsort(j->piece, j->count, sizeof *j->piece, line_by_start);
    j->hidden_count = 0;
    for (size_t i = 0; i < j->count; i++) {
        const piece *p = &j->piece[i];
        j->any[i] = (oracle_interval){p->t0, p->t1};
        if (p->hidden)
            continue;
        if (p->t0 > end)
            j->hidden[j->hidden_count++] = (oracle_interval){end, p->t0};
        end = fmax(end, p->t1);
    }
    if (end < 1)
        j->hidden[j->hidden_count++] = (oracle_interval){end, 1};
    return judge_outside(j->truth->part + e->part, e->parts, j->any, line_join(j->any, j->count, 0));
}

/* The length of a \ b on those parts of the edge that bound something. */
static double outside(const judgement *j, const mesh_edge *e, const oracle_interval *a, size_t a_count,
                      const oracle_interval *b, size_t b_count)
{
    double sum = 0;
    for (size_t k = e->part; k < e->part + e->parts; k++)
        for (size_t i = 0; i < a_count; i++) {
            const oracle_interval *part = &j->truth->part[k];
            const oracle_interval both = {fmax(a[i].t0, part->t0), fmin(a[i].t1, part->t1)};
            if (both.t0 < both.t1)
                sum += judge_outside(&both, 1, b, b_count);
        }
    return sum;
}

/* Where the two lists differ, asks the oracle at the middle whether its answer is sure. Returns the length that is
 * surely wrong. */
static double surely_wrong(const judgement *j, const mesh_edge *e, double *unjudged)
{
    const oracle_interval *truth = j->truth->interval + e->first;
    size_t cuts = 0;
    double wrong = 0, *cut = malloc((2 * (e->count + j->hidden_count) + 2) * sizeof *cut);
    if (!cut)
        return 1;
    cut[cuts++] = 0;
    cut[cuts++] = 1;
    for (size_t i = 0; i < e->count; i++) {
        cut[cuts++] = truth[i].t0;
        cut[cuts++] = truth[i].t1;
    }
    for (size_t i = 0; i < j->hidden_count; i++) {
        cut[cuts++] = j->hidden[i].t0;
        cut[cuts++] = j->hidden[i].t1;
    }
    qsort(cut, cuts, sizeof *cut, line_by_start);
    for (size_t i = 0; i + 1 < cuts; i++) {
        double t = 0.5 * (cut[i] + cut[i + 1]);
        bool mine = false, theirs = false;
        for (size_t k = 0; k < j->hidden_count; k++)
            mine = mine || (j->hidden[k].t0 < t && t < j->hidden[k].t1);
        for (size_t k = 0; k < e->count; k++)
            theirs = theirs || (truth[k].t0 < t && t < truth[k].t1);
        if (mine == theirs)
            continue;
        const roberts_vec3 *vertex = j->scene->mesh.vertex;
        const mesh_point X = {line_point(vertex[e->v0], vertex[e->v1], t), e->v0, e->v1, ROBERTS_NONE, ROBERTS_NONE};
        oracle_answer answer = mesh_truth_at(&j->scene->mesh, &j->scene->view, j->scene->even_odd, j->truth->position,
                                             &X, j->scene->slack);
        if (answer == ORACLE_UNSURE || (answer == ORACLE_YES) == mine)
            *unjudged += cut[i + 1] - cut[i];
        else
            wrong += cut[i + 1] - cut[i];
    }
    free(cut);
    return wrong;
}

static void judge_edge(judgement *j, const mesh_edge *e, const char *name, mesh_total *total, size_t *failed, FILE *out)
{
    const oracle_interval *truth = j->truth->interval + e->first;
    j->count = 0;
    take_own(j, e);
    double missing = uncovered(j, e);
    if (missing > 0 && j->truth->edge_count <= MANY_EDGES) {
        j->count = 0;
        take_others(j, e);
        missing = uncovered(j, e);
    }
    double wrong = outside(j, e, j->hidden, j->hidden_count, truth, e->count) +
                   outside(j, e, truth, e->count, j->hidden, j->hidden_count);
    if (j->scene->slack > 0 && wrong > MESH_JUDGE_LIMIT)
        wrong = surely_wrong(j, e, &total->unjudged);
    wrong += missing > MESH_JUDGE_LIMIT ? missing : 0;
    bool all = e->count == 1 && truth[0].t0 == 0 && truth[0].t1 == 1;
    total->edges++;
    total->hidden += all;
    total->cut += e->count > 0 && !all;
    if (wrong <= MESH_JUDGE_LIMIT) {
        total->worst = fmax(total->worst, wrong);
        return;
    }
    total->disagreements++;
    if (++*failed > REPORTS)
        return;
    fprintf(out, "%s: edge %u-%u: program and oracle differ on %.3g of it, %.3g of it is in no row\n", name, e->v0,
            e->v1, wrong, missing);
    judge_print_intervals(out, "program hides", j->hidden, j->hidden_count);
    judge_print_intervals(out, "oracle hides", truth, e->count);
}

roberts_camera mesh_judge_camera(const mesh_scene *scene)
{
    const oracle_view *v = &scene->view;
    roberts_camera camera = {.projection = v->w ? ROBERTS_PERSPECTIVE : ROBERTS_ORTHOGRAPHIC};
    *(v->w ? &camera.eye : &camera.dir) = (roberts_vec3){v->x, v->y, v->z};
    return camera;
}

void mesh_judge_keep(const char *name, const mesh_scene *scene, const char *options, const char *folder, FILE *out)
{
    char path[JUDGE_PATH], command[300];
    const oracle_view *v = &scene->view;
    snprintf(command, sizeof command, "%s --%s=%.17g,%.17g,%.17g%s", options, v->w ? "eye" : "dir", v->x, v->y, v->z,
             scene->even_odd ? " --fill-rule evenodd" : "");
    if (judge_write_failure(folder, name, &scene->mesh, command, path))
        fprintf(out, "  build/roberts %s %s\n", command, path);
}

/* Hides the lines of a scene that is built. */
static roberts_status hide(const roberts_scene *built, const mesh_scene *scene, bool all_edges, bool keep_hidden,
                           roberts_drawing *drawing, roberts_error *error)
{
    roberts_camera camera = mesh_judge_camera(scene);
    roberts_hide_options options = roberts_hide_options_default();
    options.keep_hidden = keep_hidden;
    options.all_edges = all_edges;
    options.unite = scene->united;
    return roberts_hide(built, &camera, &options, drawing, error);
}

/* Draws the scene with hidden lines. False: the program refuses it. */
static bool draw(const char *name, const mesh_scene *scene, bool all_edges, roberts_scene **built,
                 roberts_drawing *drawing, FILE *out)
{
    roberts_scene_options bodies = {.even_odd = scene->even_odd};
    roberts_error error;
    if (roberts_scene_build(&scene->mesh, &bodies, built, &error) == ROBERTS_OK &&
        hide(*built, scene, all_edges, true, drawing, &error) == ROBERTS_OK)
        return true;
    fprintf(out, "%s: the program refuses: %s\n", name, error.message);
    return false;
}

/* Do two visible segments of two drawings agree? */
static bool agree(const roberts_drawing *a, const roberts_segment *s, const roberts_drawing *b,
                  const roberts_segment *u)
{
    bool crossing = s->line == ROBERTS_INTERSECTION;
    if (s->solid != u->solid || s->v0 != u->v0 || s->v1 != u->v1 || s->line != u->line ||
        fabs(s->t0 - u->t0) > MESH_JUDGE_LIMIT || fabs(s->t1 - u->t1) > MESH_JUDGE_LIMIT)
        return false;
    return !crossing || memcmp(&a->crossing[s->edge], &b->crossing[u->edge], sizeof *a->crossing) == 0;
}

/* Compares the visible segments with those drawn if hidden lines are not wanted: then crossings are sought in another
 * way, and only where they are seen. Returns the number of failures. */
static size_t judge_seen(const cross_case *c, const roberts_scene *built, const roberts_drawing *drawing,
                         mesh_total *total, FILE *out)
{
    roberts_drawing seen = {0};
    roberts_error error;
    size_t at = 0;
    bool same = hide(built, c->scene, c->all_edges, false, &seen, &error) == ROBERTS_OK;
    for (size_t k = 0; same && k < drawing->count; k++)
        if (drawing->segment[k].state == ROBERTS_VISIBLE) {
            same = at < seen.count && agree(drawing, &drawing->segment[k], &seen, &seen.segment[at]);
            at++;
        }
    same = same && at == seen.count;
    if (!same) {
        fprintf(out, "%s: without hidden lines, visible segment %zu of %zu is not the same\n", c->name, at, seen.count);
        total->disagreements++;
    }
    roberts_drawing_free(&seen);
    return same ? 0 : 1;
}

/* Judges a scene whose bodies are drawn as one. */
static size_t judge_united(const char *name, const mesh_scene *scene, mesh_total *total, FILE *out)
{
    roberts_scene *built = NULL;
    roberts_drawing drawing = {0};
    union_truth truth;
    size_t failed = 1;
    if (!union_truth_find(&scene->mesh, &scene->view, &truth)) {
        fprintf(out, "%s: the oracle refuses: %s\n", name, truth.error);
        total->refused++;
        return 0;
    }
    if (draw(name, scene, false, &built, &drawing, out)) {
        const union_case c = {scene, &truth, name};
        failed = union_judge_drawing(&c, &drawing, total, out);
        failed += judge_seen(&(cross_case){.scene = scene, .name = name}, built, &drawing, total, out);
    } else {
        total->disagreements++;
    }
    roberts_drawing_free(&drawing);
    roberts_scene_free(built);
    union_truth_free(&truth);
    return failed;
}

/* Judges the lines in which faces cross. The truth is settled for each drawing anew. */
static size_t judge_lines(const cross_case *at, const cross_truth *crossed, const roberts_scene *built,
                          const roberts_drawing *drawing, mesh_total *total, FILE *out)
{
    const size_t line_size = crossed->line_count * sizeof *crossed->line;
    const size_t interval_size = crossed->interval_count * sizeof *crossed->interval;
    cross_truth settled = *crossed;
    cross_case c = *at;
    size_t failed = 0;
    settled.line = malloc(line_size + 1);
    settled.interval = malloc(interval_size + 1);
    if (crossed->line && settled.line && settled.interval) {
        memcpy(settled.line, crossed->line, line_size);
        memcpy(settled.interval, crossed->interval, interval_size);
        cross_settle(c.scene, &settled, drawing);
        c.truth = &settled;
        failed = cross_judge_drawing(&c, built, drawing, total, out);
    }
    free(settled.line);
    free(settled.interval);
    return failed;
}

/* Draws the scene with all edges or without the flat ones, and judges it. */
static size_t judge_drawing(const cross_case *c, const mesh_truth *truth, const cross_truth *crossed, mesh_total *total,
                            FILE *out)
{
    roberts_scene *built = NULL;
    roberts_drawing drawing = {0};
    size_t failed = 0;
    if (!draw(c->name, c->scene, c->all_edges, &built, &drawing, out)) {
        failed++;
        total->disagreements++;
    } else {
        judgement j = {.scene = c->scene,
                       .truth = truth,
                       .drawing = &drawing,
                       .size = mesh_size(&c->scene->mesh),
                       .piece = malloc((drawing.count + 1) * sizeof *j.piece),
                       .hidden = malloc((drawing.count + 1) * sizeof *j.hidden),
                       .any = malloc((drawing.count + 1) * sizeof *j.any)};
        for (size_t i = 0; c->all_edges && j.piece && j.hidden && j.any && i < truth->edge_count; i++)
            judge_edge(&j, &truth->edge[i], c->name, total, &failed, out);
        failed += judge_lines(c, crossed, built, &drawing, total, out);
        failed += judge_seen(c, built, &drawing, total, out);
        free(j.piece);
        free(j.hidden);
        free(j.any);
    }
    roberts_drawing_free(&drawing);
    roberts_scene_free(built);
    return failed;
}

bool mesh_judge(const char *name, const mesh_scene *scene, const char *folder, mesh_total *total, FILE *out)
{
    mesh_truth truth;
    cross_truth crossed;
    size_t failed = 0;
    total->scenes++;
    if (scene->united) {
        failed = judge_united(name, scene, total, out);
        if (failed)
            mesh_judge_keep(name, scene, "--union --hidden solid -f csv", folder, out);
        return failed == 0;
    }
    if (!mesh_truth_find(&scene->mesh, &scene->view, scene->even_odd, &truth)) {
        fprintf(out, "%s: the oracle refuses: %s\n", name, truth.error);
        total->refused++;
        return true;
    }
    cross_truth_find(&scene->mesh, &scene->view, scene->even_odd, &crossed); /* if it fails, there are none */
    for (int all_edges = 1; all_edges >= 0 && failed == 0; all_edges--) {
        const cross_case c = {.scene = scene, .position = truth.position, .name = name, .all_edges = all_edges != 0};
        failed = judge_drawing(&c, &truth, &crossed, total, out);
        if (failed)
            mesh_judge_keep(name, scene,
                            all_edges ? "--all-edges --hidden solid -f csv" : "--crease 0.1 --hidden solid -f csv",
                            folder, out);
    }
    total->pairs += truth.pairs;
    total->exact += truth.exact;
    cross_truth_free(&crossed);
    mesh_truth_free(&truth);
    return failed == 0;
}
