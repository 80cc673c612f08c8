/* judge.c - compares program and oracle edge by edge. What the program hides must lie in `maybe`, and what it shows
 * must lie outside `sure` (oracle.h). Without slack these two are the same, so the answers must be equal. A scene
 * spoiled by rounding is also compared with its original, strictly. The program's segments must tile [0, 1], and
 * neighbours must differ in state. Drawn without hidden lines, where less is examined, the scene must have the same
 * visible segments. */
#include "judge.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "lines.h"
#include "order.h"

enum {
    REPORTS = 3,     /* most failures reported for a scene */
    SEEN_FACES = 200 /* most faces of a scene checked with plain rays, which are slow */
};

roberts_camera judge_camera(const test_scene *scene)
{
    const oracle_view *view = &scene->view;
    roberts_camera camera = {0};
    roberts_vec3 v = {view->x, view->y, view->z};
    camera.projection = view->w ? ROBERTS_PERSPECTIVE : ROBERTS_ORTHOGRAPHIC;
    if (view->w)
        camera.eye = v;
    else
        camera.dir = v;
    if (scene->oblique) {
        camera.dir = (roberts_vec3){0, -1, 0};
        camera.oblique = (roberts_vec2){v.x, v.z};
    }
    camera.has_section = view->cut && !view->w;
    camera.section = view->near;
    if (view->cut && view->w) {
        camera.has_look_at = true;
        camera.look_at = scene->look_at;
        camera.near_distance = line_length(view->near, v);
    }
    return camera;
}

double judge_outside(const oracle_interval *a, size_t a_count, const oracle_interval *b, size_t b_count)
{
    double sum = 0;
    for (size_t i = 0; i < a_count; i++) {
        double from = a[i].t0;
        for (size_t k = 0; k < b_count && from < a[i].t1; k++) {
            if (b[k].t1 <= from)
                continue;
            if (b[k].t0 > from)
                sum += fmin(b[k].t0, a[i].t1) - from;
            from = b[k].t1;
        }
        if (from < a[i].t1)
            sum += a[i].t1 - from;
    }
    return sum;
}

/* ---- the two sides --------------------------------------------------------------------------------------------- */

/* Draws `mesh`, the scene's mesh or a part of it, with the scene's options. If it is the whole mesh and the scene has a
 * soup, the program gets the soup. */
static roberts_status draw(const test_scene *how, const roberts_mesh *mesh, bool keep_hidden, roberts_drawing *drawing,
                           roberts_error *error)
{
    roberts_scene *scene = NULL;
    roberts_camera camera = judge_camera(how);
    /* a small tolerance, so that only coplanar faces of a hull become one */
    roberts_scene_options solids = {.hull = how->hull, .tolerance = how->hull ? 1e-10 : how->tolerance};
    roberts_hide_options options = roberts_hide_options_default();
    options.all_edges = true;
    options.keep_hidden = keep_hidden;
    options.grid = how->grid;
    options.threads = how->threads;
    *drawing = (roberts_drawing){0};
    if (how->has_soup && mesh == &how->mesh)
        mesh = &how->soup;
    roberts_status status = roberts_scene_build(mesh, &solids, &scene, error);
    if (status == ROBERTS_OK)
        status = roberts_hide(scene, &camera, &options, drawing, error);
    while (status == ROBERTS_OK && drawing->count > 0 &&
           drawing->segment[drawing->count - 1].line == ROBERTS_INTERSECTION)
        drawing->count--; /* only edges are judged here */
    roberts_scene_free(scene);
    return status;
}

/* The segments of one edge: its hidden intervals, what the near plane leaves of it, and whether they tile it. */
typedef struct edge_segments {
    size_t count, hidden_count;
    oracle_interval *hidden; /* room for all segments of the drawing */
    double t0, t1;           /* 1, 1: all of it is clipped */
    bool tiled;
} edge_segments;

static void take_edge(const roberts_drawing *drawing, size_t *at, const oracle_edge *edge, edge_segments *out)
{
    double t = 0;
    out->count = out->hidden_count = 0;
    out->tiled = true;
    out->t0 = 0, out->t1 = 1;
    while (*at < drawing->count) {
        const roberts_segment *s = drawing->segment + *at;
        if (s->solid != edge->solid || s->v0 != edge->v0 || s->v1 != edge->v1)
            break;
        out->tiled =
            out->tiled && s->t0 == t && s->t1 > s->t0 && out->t1 == 1 && (out->count == 0 || s->state != s[-1].state);
        if (s->state == ROBERTS_HIDDEN)
            out->hidden[out->hidden_count++] = (oracle_interval){s->t0, s->t1};
        if (s->state == ROBERTS_CLIPPED && s->t0 == 0)
            out->t0 = s->t1;
        else if (s->state == ROBERTS_CLIPPED)
            out->t1 = s->t0;
        t = s->t1;
        out->count++;
        ++*at;
    }
    out->tiled = out->tiled && t == 1;
}

/* How much of the edge is wrong. 1 if the segments do not tile it. */
static double wrong_length(const edge_segments *mine, const oracle_result *truth, const oracle_edge *edge)
{
    if (!mine->tiled)
        return 1;
    return fabs(mine->t0 - edge->t0) + fabs(mine->t1 - edge->t1) +
           judge_outside(mine->hidden, mine->hidden_count, truth->interval + edge->maybe, edge->maybe_count) +
           judge_outside(truth->interval + edge->sure, edge->sure_count, mine->hidden, mine->hidden_count);
}

/* How much of an edge may differ. In a rough scene, very short parts are not judged: they exist only for some
 * positions of the corners within the slack. The factor 4 is 2 for the two ends, times 2 because slack counts for
 * more in perspective. */
static double limit_of(const test_scene *scene, const roberts_mesh *mesh, const oracle_edge *edge)
{
    roberts_vec3 p = mesh->vertex[edge->v0], q = mesh->vertex[edge->v1];
    return JUDGE_LIMIT + (scene->rough ? 4 * scene->slack / line_length(p, q) : 0);
}

/* ---- reports --------------------------------------------------------------------------------------------------- */

bool judge_write_off(const char *path, const roberts_mesh *mesh, const char *comment)
{
    FILE *file = fopen(path, "w");
    if (!file)
        return false;
    fprintf(file, "OFF\n# %s\n%zu %zu 0\n", comment, mesh->vertex_count, mesh->face_count);
    for (size_t i = 0; i < mesh->vertex_count; i++)
        fprintf(file, "%.17g %.17g %.17g\n", mesh->vertex[i].x, mesh->vertex[i].y, mesh->vertex[i].z);
    for (size_t f = 0; f < mesh->face_count; f++) {
        fprintf(file, "%u", mesh->face_start[f + 1] - mesh->face_start[f]);
        for (uint32_t i = mesh->face_start[f]; i < mesh->face_start[f + 1]; i++)
            fprintf(file, " %u", mesh->corner[i]);
        fputc('\n', file);
    }
    bool ok = !ferror(file);
    return fclose(file) == 0 && ok;
}

bool judge_write_failure(const char *folder, const char *name, const roberts_mesh *mesh, const char *comment,
                         char path[JUDGE_PATH])
{
    snprintf(path, JUDGE_PATH, "%s/failures", folder);
    mkdir(folder, 0777);
    mkdir(path, 0777);
    snprintf(path, JUDGE_PATH, "%s/failures/%s.off", folder, name);
    return judge_write_off(path, mesh, comment);
}

/* Copies only the wanted solids of the mesh. Vertices *v0 and *v1 become their numbers in the copy. */
static bool part_of(const roberts_mesh *mesh, const uint32_t *vertex_solid, const bool *wanted, roberts_mesh *part,
                    uint32_t *v0, uint32_t *v1)
{
    uint32_t *number = malloc((mesh->vertex_count + 1) * sizeof *number), *face;
    bool ok = number != NULL;
    uint32_t old0 = *v0, old1 = *v1;
    *part = (roberts_mesh){0};
    for (size_t v = 0; v < mesh->vertex_count && ok; v++)
        if (vertex_solid[v] != ROBERTS_NONE && wanted[vertex_solid[v]])
            ok = roberts_mesh_add_vertex(part, mesh->vertex[v], &number[v], NULL) == ROBERTS_OK;
    for (size_t f = 0; f < mesh->face_count && ok; f++) {
        size_t first = mesh->face_start[f], count = mesh->face_start[f + 1] - first;
        uint32_t solid = count ? vertex_solid[mesh->corner[first]] : ROBERTS_NONE;
        if (solid == ROBERTS_NONE || !wanted[solid])
            continue;
        face = malloc(count * sizeof *face);
        ok = face != NULL;
        for (size_t i = 0; i < count && ok; i++)
            face[i] = number[mesh->corner[first + i]];
        ok = ok && roberts_mesh_add_face(part, face, count, NULL) == ROBERTS_OK;
        free(face);
    }
    if (ok) {
        *v0 = number[old0];
        *v1 = number[old1];
    }
    free(number);
    return ok;
}

typedef struct one_edge {
    double wrong, limit;
    oracle_edge edge;
    oracle_result truth;
    roberts_drawing drawing;
    edge_segments mine;
    roberts_error error;
} one_edge;

static void one_edge_free(one_edge *one)
{
    free(one->mine.hidden);
    oracle_free(&one->truth);
    roberts_drawing_free(&one->drawing);
    *one = (one_edge){0};
}

/* Compares one edge of a mesh. If the program refuses the mesh, `wrong` is 1; if the oracle refuses it, 0. */
static void judge_one(const test_scene *how, const roberts_mesh *mesh, uint32_t v0, uint32_t v1, one_edge *one)
{
    oracle_options options = {how->slack, false};
    *one = (one_edge){0};
    if (!oracle_run(mesh, &how->view, &options, &one->truth))
        return;
    one->wrong = 1;
    if (draw(how, mesh, true, &one->drawing, &one->error) != ROBERTS_OK)
        return;
    one->mine.hidden = calloc(one->drawing.count + 1, sizeof *one->mine.hidden);
    for (size_t i = 0, at = 0; i < one->truth.edge_count && one->mine.hidden; i++) {
        const oracle_edge *e = one->truth.edge + i;
        take_edge(&one->drawing, &at, e, &one->mine);
        if (e->v0 == v0 && e->v1 == v1) {
            one->edge = *e;
            one->wrong = wrong_length(&one->mine, &one->truth, e);
            one->limit = limit_of(how, mesh, e);
            return;
        }
    }
}

void judge_print_intervals(FILE *out, const char *title, const oracle_interval *list, size_t count)
{
    fprintf(out, "  %-18s", title);
    for (size_t i = 0; i < count; i++)
        fprintf(out, " [%.17g, %.17g]", list[i].t0, list[i].t1);
    fprintf(out, "%s\n", count ? "" : " nothing");
}

static void print_one(FILE *out, const char *what, const one_edge *one)
{
    fprintf(out, "%s: solid %u, edge %u-%u: program and oracle differ on %.3g of it\n", what, one->edge.solid,
            one->edge.v0, one->edge.v1, one->wrong);
    judge_print_intervals(out, "program hides", one->mine.hidden, one->mine.hidden_count);
    if (!one->mine.tiled)
        fprintf(out, "  the program's %zu segments do not tile the edge in turns\n", one->mine.count);
    if (one->mine.t0 > 0 || one->mine.t1 < 1 || one->edge.t0 > 0 || one->edge.t1 < 1)
        fprintf(out, "  of the near plane the program leaves [%.17g, %.17g], the oracle [%.17g, %.17g]\n", one->mine.t0,
                one->mine.t1, one->edge.t0, one->edge.t1);
    judge_print_intervals(out, "oracle hides", one->truth.interval + one->edge.sure, one->edge.sure_count);
    if (one->edge.survives != ORACLE_NO && one->truth.interval)
        judge_print_intervals(out, "or at most", one->truth.interval + one->edge.maybe, one->edge.maybe_count);
}

/* A scene that is being judged: what it is called, where failures are written and reported, where they are counted. */
typedef struct judging {
    const char *name, *folder;
    const test_scene *scene;
    judge_total *total;
    FILE *out;
} judging;

static void write_failure(const judging *j, size_t nth, const roberts_mesh *mesh)
{
    char path[JUDGE_PATH], name[200], command[800], comment[1200];
    roberts_camera c = judge_camera(j->scene);
    bool eye = c.projection == ROBERTS_PERSPECTIVE;
    roberts_vec3 v = eye ? c.eye : c.dir;
    int used = 0;
    snprintf(name, sizeof name, "%s-%zu", j->name, nth);
    used = snprintf(command, sizeof command,
                    "--all-edges --hidden solid -f csv --grid %u --threads %u --%s=%.17g,%.17g,%.17g", j->scene->grid,
                    j->scene->threads, eye ? "eye" : "dir", v.x, v.y, v.z);
    if (c.has_look_at)
        snprintf(command + used, sizeof command - (size_t)used, " --look-at=%.17g,%.17g,%.17g --near %.17g",
                 c.look_at.x, c.look_at.y, c.look_at.z, c.near_distance);
    if (c.has_section)
        snprintf(command + used, sizeof command - (size_t)used, " --section=%.17g,%.17g,%.17g", c.section.x,
                 c.section.y, c.section.z);
    if (j->scene->tolerance != 0)
        snprintf(command + strlen(command), sizeof command - strlen(command), " --tolerance %.17g",
                 j->scene->tolerance);
    snprintf(comment, sizeof comment, "%s; slack %.17g", command, j->scene->slack);
    if (j->scene->has_soup && mesh == &j->scene->mesh)
        mesh = &j->scene->soup;
    if (judge_write_failure(j->folder, name, mesh, comment, path))
        fprintf(j->out, "  build/roberts %s %s\n", command, path);
    else
        fprintf(j->out, "  (%s: %s)\n", path, strerror(errno));
}

/* Does the edge fail in the part of the scene that has only the wanted solids? */
static bool part_fails(const test_scene *scene, const oracle_result *truth, const bool *wanted, const oracle_edge *edge,
                       roberts_mesh *part, one_edge *one)
{
    uint32_t v0 = edge->v0, v1 = edge->v1;
    *one = (one_edge){0};
    if (part_of(&scene->mesh, truth->vertex_solid, wanted, part, &v0, &v1))
        judge_one(scene, part, v0, v1, one);
    return one->wrong > one->limit;
}

/* Removes halves, then quarters, then single solids, as long as the edge still fails. The edge's own solid stays. */
static void shrink(const test_scene *scene, const oracle_result *truth, const oracle_edge *edge, bool *wanted,
                   bool *before)
{
    size_t count = truth->solid_count;
    for (size_t size = (count + 1) / 2, last = 0; size != last; last = size, size = (size + 1) / 2)
        for (size_t first = 0; first < count; first += size) {
            roberts_mesh part;
            one_edge one;
            bool any = false;
            memcpy(before, wanted, count * sizeof *before);
            for (size_t i = first; i < first + size && i < count; i++) {
                any = any || (wanted[i] && i != edge->solid);
                wanted[i] = i == edge->solid;
            }
            if (!any)
                continue;
            if (!part_fails(scene, truth, wanted, edge, &part, &one))
                memcpy(wanted, before, count * sizeof *before);
            one_edge_free(&one);
            roberts_mesh_free(&part);
        }
}

static void report(const judging *j, size_t nth, const oracle_result *truth, const oracle_edge *edge)
{
    const test_scene *scene = j->scene;
    bool *wanted = calloc(truth->solid_count + 1, sizeof *wanted);
    bool *before = calloc(truth->solid_count + 1, sizeof *before);
    roberts_mesh part;
    one_edge one;
    judge_one(scene, &scene->mesh, edge->v0, edge->v1, &one);
    print_one(j->out, j->name, &one);
    one_edge_free(&one);
    if (wanted && before) {
        for (size_t i = 0; i < truth->solid_count; i++)
            wanted[i] = true;
        shrink(scene, truth, edge, wanted, before);
        part_fails(scene, truth, wanted, edge, &part, &one);
        print_one(j->out, "  the smallest part of it that fails", &one);
        write_failure(j, nth, &part);
        one_edge_free(&one);
        roberts_mesh_free(&part);
    }
    free(wanted);
    free(before);
}

/* ---- scenes ---------------------------------------------------------------------------------------------------- */

static void count_edge(const oracle_result *truth, const oracle_edge *e, judge_total *total)
{
    const oracle_interval *maybe = truth->interval + e->maybe, *sure = truth->interval + e->sure;
    total->edges++;
    total->drawn += e->survives != ORACLE_NO && e->t0 < e->t1;
    total->clipped += e->t0 > 0 || e->t1 < 1;
    total->cut += e->maybe_count > 1 || (e->maybe_count == 1 && (maybe->t0 > 0 || maybe->t1 < 1));
    total->unjudged += judge_outside(maybe, e->maybe_count, sure, e->sure_count);
}

/* Compares the drawing with the oracle's answer for the scene, or for its original. */
static bool judge_drawing(const judging *j, const roberts_drawing *drawing, bool original)
{
    const test_scene *scene = j->scene;
    oracle_options options = {original ? 0 : scene->slack, false};
    oracle_result truth;
    edge_segments mine = {0};
    size_t at = 0, failed = 0;
    if (!oracle_run(original ? &scene->original : &scene->mesh, original ? &scene->original_view : &scene->view,
                    &options, &truth)) {
        fprintf(j->out, "%s: the oracle says: %s\n", j->name, truth.error);
        j->total->disagreements++;
        return false;
    }
    mine.hidden = calloc(drawing->count + 1, sizeof *mine.hidden);
    for (size_t i = 0; i < truth.edge_count && mine.hidden; i++) {
        const oracle_edge *e = truth.edge + i;
        take_edge(drawing, &at, e, &mine);
        double wrong = wrong_length(&mine, &truth, e);
        if (!original)
            count_edge(&truth, e, j->total);
        if (wrong <= limit_of(scene, &scene->mesh, e)) {
            j->total->slivers += wrong > JUDGE_LIMIT;
            j->total->worst = wrong > JUDGE_LIMIT ? j->total->worst : fmax(j->total->worst, wrong);
            continue;
        }
        if (failed++ >= REPORTS)
            continue;
        if (!original) {
            report(j, failed, &truth, e);
        } else {
            fprintf(j->out, "%s (compared with its original): solid %u, edge %u-%u: they differ on %.3g of it\n",
                    j->name, e->solid, e->v0, e->v1, wrong);
            judge_print_intervals(j->out, "program hides", mine.hidden, mine.hidden_count);
            judge_print_intervals(j->out, "the original hides", truth.interval + e->sure, e->sure_count);
            write_failure(j, failed, &scene->mesh);
        }
    }
    if (at != drawing->count || !mine.hidden) {
        fprintf(j->out, "%s: the drawing has segments of edges that do not exist\n", j->name);
        failed++;
    }
    j->total->pairs += truth.pairs;
    j->total->exact += truth.exact;
    j->total->disagreements += failed;
    free(mine.hidden);
    oracle_free(&truth);
    return failed == 0;
}

/* Does a plain ray see the same solid at the middle of a hidden segment as the program? The rounded middle may lie in
 * line with a border, so a point a little before or after it may agree instead. With slack, a point beside it may: at
 * twice the slack, or ten times as far, since in perspective a moved corner moves points behind it by more. */
static bool is_seen(const test_scene *scene, const oracle_result *truth, const roberts_segment *s, double epsilon,
                    uint32_t *seen)
{
    static const double along[] = {0, -1e-12, 1e-12}, beside[] = {2, 20};
    for (int i = 0; i < 3; i++)
        for (int way = 0; way < (scene->slack > 0 ? 54 : 1); way++) { /* way 0: not at all; then to all sides */
            double by = scene->slack * beside[way / 27], t = (s->t0 + s->t1) / 2 + along[i] * (s->t1 - s->t0);
            roberts_vec3 aside = {by * ((way + 1) % 3 - 1), by * ((way / 3 + 1) % 3 - 1), by * ((way / 9 + 1) % 3 - 1)};
            oracle_point point = {&scene->mesh, truth->vertex_solid, &scene->view, s->v0, s->v1, t, aside};
            /* solids that touch count as present, and of these the one with the smallest number is seen */
            double touch = 2 * epsilon + 2 * scene->slack;
            if (oracle_point_seen(&point, 0, s->by, seen) && *seen == s->by)
                return true;
            if ((s->by < *seen || scene->slack > 0) && oracle_point_seen(&point, touch, s->by, seen))
                return true;
        }
    return false;
}

/* Is the middle of the segment hidden for all positions of the corners within the slack? */
static bool is_surely_hidden(const oracle_result *truth, const roberts_segment *s)
{
    double t = (s->t0 + s->t1) / 2;
    for (size_t i = 0; i < truth->edge_count; i++) {
        const oracle_edge *e = truth->edge + i;
        if (e->solid != s->solid || e->v0 != s->v0 || e->v1 != s->v1)
            continue;
        for (size_t k = e->sure; k < e->sure + e->sure_count; k++)
            if (truth->interval[k].t0 <= t && t <= truth->interval[k].t1)
                return e->survives != ORACLE_UNSURE;
    }
    return false;
}

/* Compares `by` of one hidden segment with the plain rays of rays.cpp. Segments that are hidden only perhaps are left
 * out. */
static bool judge_seen(const judging *j, const roberts_drawing *drawing)
{
    const test_scene *scene = j->scene;
    const roberts_segment *s = NULL;
    const oracle_options options = {scene->slack, false};
    oracle_result truth;
    uint32_t seen = ROBERTS_NONE;
    bool agreed = true;
    if (!oracle_run(&scene->mesh, &scene->view, &options, &truth))
        return true;
    for (size_t i = 0, start = drawing->count * 5 / 8; i < drawing->count && !s; i++) {
        const roberts_segment *at = drawing->segment + (start + i) % drawing->count;
        if (at->state == ROBERTS_HIDDEN && (scene->slack == 0 || is_surely_hidden(&truth, at)))
            s = at;
    }
    if (s) {
        j->total->seen++;
        agreed = is_seen(scene, &truth, s, drawing->epsilon, &seen);
    }
    if (!agreed) {
        fprintf(
            j->out,
            "%s: solid %u, edge %u-%u, at the middle of [%.17g, %.17g]: the program sees solid %d, a ray solid %d\n",
            j->name, s->solid, s->v0, s->v1, s->t0, s->t1, (int)s->by, (int)seen);
        write_failure(j, 0, &scene->mesh);
        j->total->disagreements++;
    }
    oracle_free(&truth);
    return agreed;
}

static bool is_same(const roberts_segment *a, const roberts_segment *b)
{
    return a->v0 == b->v0 && a->v1 == b->v1 && a->solid == b->solid && a->state == b->state &&
           fabs(a->t0 - b->t0) <= JUDGE_LIMIT && fabs(a->t1 - b->t1) <= JUDGE_LIMIT;
}

/* Compares the visible segments with those of a drawing without hidden lines. */
static bool judge_visible(const judging *j, const roberts_drawing *drawing)
{
    const test_scene *scene = j->scene;
    const roberts_segment *wrong = NULL;
    roberts_drawing alone;
    roberts_error error = {0};
    size_t at = 0;
    bool drawn = draw(scene, &scene->mesh, false, &alone, &error) == ROBERTS_OK;
    for (size_t i = 0; i < drawing->count && drawn && !wrong; i++)
        if (drawing->segment[i].state == ROBERTS_VISIBLE &&
            (at == alone.count || !is_same(&drawing->segment[i], &alone.segment[at++])))
            wrong = &drawing->segment[i];
    if (!wrong && at < alone.count)
        wrong = &alone.segment[at];
    if (wrong)
        fprintf(j->out,
                "%s: solid %u, edge %u-%u: what is visible from %.17g to %.17g is so only with hidden lines, or only "
                "without\n",
                j->name, wrong->solid, wrong->v0, wrong->v1, wrong->t0, wrong->t1);
    if (!drawn)
        fprintf(j->out, "%s: the program refuses it without hidden lines: %s\n", j->name, error.message);
    if (wrong || !drawn) {
        write_failure(j, 0, &scene->mesh);
        j->total->disagreements++;
    }
    roberts_drawing_free(&alone);
    return drawn && !wrong;
}

/* Do the segments differ from the oracle's only where the answer is open? */
static bool is_open(const test_scene *scene, const roberts_drawing *drawing)
{
    oracle_options options = {scene->slack, false};
    oracle_result truth;
    edge_segments mine = {0};
    size_t at = 0;
    if (scene->slack == 0 || !oracle_run(&scene->mesh, &scene->view, &options, &truth))
        return false;
    mine.hidden = calloc(drawing->count + 1, sizeof *mine.hidden);
    bool ok = mine.hidden != NULL;
    for (size_t i = 0; i < truth.edge_count && ok; i++) {
        take_edge(drawing, &at, truth.edge + i, &mine);
        ok = wrong_length(&mine, &truth, truth.edge + i) <= limit_of(scene, &scene->mesh, truth.edge + i);
    }
    free(mine.hidden);
    oracle_free(&truth);
    return ok && at == drawing->count;
}

static const char *name_of_state(roberts_state state)
{
    return state == ROBERTS_HIDDEN ? "hidden" : state == ROBERTS_CLIPPED ? "clipped" : "visible";
}

static void print_other(FILE *out, const char *name, const roberts_segment *s, const roberts_segment *again)
{
    fprintf(out, "%s: solid %u, edge %u-%u: %s from %.17g to %.17g; in another order", name, s->solid, s->v0, s->v1,
            name_of_state(s->state), s->t0, s->t1);
    if (again)
        fprintf(out, " solid %u, edge %u-%u: %s from %.17g to %.17g\n", again->solid, again->v0, again->v1,
                name_of_state(again->state), again->t0, again->t1);
    else
        fprintf(out, " it is not there\n");
}

/* The first segment from i on that is longer than a rounding error. (If another order reverses an edge, 1 - t is
 * rounded.) */
static size_t next_longer(const roberts_drawing *drawing, size_t i)
{
    while (i < drawing->count && drawing->segment[i].t1 - drawing->segment[i].t0 < 1e-15)
        i++;
    return i;
}

/* Compares the segments with those of the same scene in another order of vertices, faces and corners. They must be the
 * same, except for their names, and for `by` among solids that touch. Where contact is left open, rounding may decide
 * differently; such scenes are counted. */
static bool judge_order(const judging *j, const roberts_drawing *drawing)
{
    const test_scene *scene = j->scene;
    size_t count = scene->mesh.vertex_count;
    uint32_t *number = calloc(count + 1, sizeof *number), *vertex_solid = calloc(count + 1, sizeof *vertex_solid);
    roberts_mesh other = {0};
    roberts_drawing again = {0};
    roberts_error error = {0};
    const roberts_segment *wrong = NULL;
    for (size_t i = 0; i < drawing->count && vertex_solid; i++)
        vertex_solid[drawing->segment[i].v0] = vertex_solid[drawing->segment[i].v1] = drawing->segment[i].solid;
    bool drawn = number && vertex_solid && order_shuffle(&scene->mesh, count, &other, number) &&
                 draw(scene, &other, true, &again, &error) == ROBERTS_OK &&
                 order_restore(&again, number, count, vertex_solid);
    size_t at = next_longer(&again, 0);
    for (size_t i = next_longer(drawing, 0); i < drawing->count && drawn && !wrong; i = next_longer(drawing, i + 1)) {
        if (at == again.count || !is_same(drawing->segment + i, again.segment + at))
            wrong = drawing->segment + i;
        else
            at = next_longer(&again, at + 1);
    }
    j->total->reordered++;
    if (wrong && is_open(scene, &again)) {
        j->total->reordered_open++;
        wrong = NULL;
    }
    if (wrong)
        print_other(j->out, j->name, wrong, at < again.count ? again.segment + at : NULL);
    if (!drawn)
        fprintf(j->out, "%s: in another order the program refuses it: %s\n", j->name, error.message);
    if (wrong || !drawn) {
        write_failure(j, 0, &scene->mesh);
        j->total->disagreements++;
    }
    free(number);
    free(vertex_solid);
    roberts_mesh_free(&other);
    roberts_drawing_free(&again);
    return drawn && !wrong;
}

bool judge_scene(const char *name, const test_scene *scene, const char *folder, judge_total *total, FILE *out)
{
    roberts_drawing drawing;
    roberts_error error = {0};
    const judging j = {name, folder, scene, total, out};
    bool ok;
    total->scenes++;
    if (draw(scene, &scene->mesh, true, &drawing, &error) != ROBERTS_OK) {
        fprintf(out, "%s: the program refuses it: %s\n", name, error.message);
        write_failure(&j, 0, &scene->mesh);
        total->disagreements++;
        return false;
    }
    ok = judge_drawing(&j, &drawing, false);
    ok = judge_visible(&j, &drawing) && ok;
    if (!scene->has_soup)
        ok = judge_order(&j, &drawing) && ok;
    if (scene->has_original)
        ok = judge_drawing(&j, &drawing, true) && ok;
    else if (scene->mesh.face_count <= SEEN_FACES)
        ok = judge_seen(&j, &drawing) && ok;
    roberts_drawing_free(&drawing);
    return ok;
}
