/* golden.c - the program must give the golden's segments to 1e-9, and each edge's golden segments must be what the
 * oracle leaves visible; both are checked in every run, and before a golden is written. So no wrong golden stays
 * unnoticed. */
#include "golden.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "judge.h"
#include "lines.h"

#define SPOILED 1e-13      /* slack for models whose contacts are rounded, as a part of the largest coordinate */
#define CREASE_DEGREES 0.1 /* the program's default, spelled out: flatter edges between front faces are not drawn */
enum { BY_HAND_EDGES = 30 };

typedef struct golden_line {
    uint32_t solid, v0, v1;
    double t0, t1;
    char class[16];
} golden_line;

typedef struct golden_file {
    char model[300], view[100];
    double slack;
    size_t count;
    golden_line *line;
} golden_file;

/* ---- the program's side ---------------------------------------------------------------------------------------- */

static bool draw_model(const char *model, const char *view, roberts_mesh *mesh, roberts_camera *camera,
                       roberts_drawing *drawing, FILE *out)
{
    roberts_error error = {0};
    roberts_scene *scene = NULL;
    bool ok;
    *mesh = (roberts_mesh){0};
    *drawing = (roberts_drawing){0};
    if (!roberts_camera_preset(view, camera)) {
        fprintf(out, "%s: no view %s\n", model, view);
        return false;
    }
    ok = roberts_mesh_read_file(mesh, model, NULL, &error) == ROBERTS_OK &&
         roberts_scene_build(mesh, NULL, &scene, &error) == ROBERTS_OK &&
         roberts_hide(scene, camera, NULL, drawing, &error) == ROBERTS_OK;
    if (!ok)
        fprintf(out, "%s: %s\n", model, error.message);
    while (ok && drawing->count > 0 && drawing->segment[drawing->count - 1].line == ROBERTS_INTERSECTION)
        drawing->count--; /* goldens hold edges; test_mesh_oracle judges intersections */
    roberts_scene_free(scene);
    return ok;
}

static bool from_drawing(const roberts_drawing *drawing, golden_file *g)
{
    g->line = calloc(drawing->count + 1, sizeof *g->line);
    for (size_t i = 0; i < drawing->count && g->line; i++) {
        const roberts_segment *s = drawing->segment + i;
        g->line[i] = (golden_line){s->solid, s->v0, s->v1, s->t0, s->t1, ""};
        snprintf(g->line[i].class, sizeof g->line[i].class, "%s", s->line == ROBERTS_CREASE ? "crease" : "outline");
    }
    g->count = g->line ? drawing->count : 0;
    return g->line != NULL;
}

/* ---- the oracle's side ----------------------------------------------------------------------------------------- */

/* The parts of the edge that the golden does not show. */
static size_t gaps(const golden_line *line, size_t count, oracle_interval *gap)
{
    size_t used = 0;
    double t = 0;
    for (size_t i = 0; i < count; i++) {
        if (line[i].t0 > t)
            gap[used++] = (oracle_interval){t, line[i].t0};
        t = fmax(t, line[i].t1);
    }
    if (t < 1)
        gap[used++] = (oracle_interval){t, 1};
    return used;
}

/* How much of an edge is wrong in the golden. */
static double wrong_part(const oracle_result *truth, const oracle_edge *e, const golden_line *line, size_t count,
                         oracle_interval *gap)
{
    const char *class = e->bend_degrees < 180 ? "crease" : "outline";
    size_t gap_count = gaps(line, count, gap);
    for (size_t i = 0; i < count; i++)
        if (e->bend_degrees >= 0 && strcmp(line[i].class, class) != 0)
            return 1;
    if (e->bend_degrees >= 0 && e->bend_degrees < CREASE_DEGREES)
        return count ? 1 : 0;
    return judge_outside(gap, gap_count, truth->interval + e->maybe, e->maybe_count) +
           judge_outside(truth->interval + e->sure, e->sure_count, gap, gap_count);
}

/* Every edge of the model against the golden's lines. out: NULL to say nothing. */
static bool oracle_agrees(const golden_file *g, const roberts_mesh *mesh, const roberts_camera *camera,
                          golden_total *total, FILE *out)
{
    oracle_view view = {.x = camera->dir.x, .y = camera->dir.y, .z = camera->dir.z};
    oracle_options options = {g->slack * mesh_size(mesh), false};
    oracle_result truth;
    oracle_interval *gap = calloc(g->count + 2, sizeof *gap);
    size_t at = 0, wrong = 0;
    if (!gap || !oracle_run(mesh, &view, &options, &truth)) {
        if (out)
            fprintf(out, "%s: oracle: %s\n", g->model, gap ? truth.error : "no memory");
        free(gap);
        return false;
    }
    for (size_t i = 0; i < truth.edge_count; i++) {
        const oracle_edge *e = truth.edge + i;
        size_t first = at;
        while (at < g->count && g->line[at].solid == e->solid && g->line[at].v0 == e->v0 && g->line[at].v1 == e->v1)
            at++;
        double part = wrong_part(&truth, e, g->line + first, at - first, gap);
        total->unjudged +=
            judge_outside(truth.interval + e->maybe, e->maybe_count, truth.interval + e->sure, e->sure_count);
        if (part > JUDGE_LIMIT && wrong++ < 5 && out)
            fprintf(out, "%s: golden and oracle differ on %.3g of solid %u, edge %u-%u\n", g->model, part, e->solid,
                    e->v0, e->v1);
    }
    if (at != g->count && out)
        fprintf(out, "%s: golden line %zu is of no edge, or out of order\n", g->model, at + 1);
    wrong += at != g->count;
    total->edges += truth.edge_count;
    free(gap);
    oracle_free(&truth);
    return wrong == 0;
}

/* ---- files ----------------------------------------------------------------------------------------------------- */

/* Reads `solid v0 v1 t0 t1 class`. */
static bool read_line(const char *text, golden_line *l)
{
    uint32_t *number[] = {&l->solid, &l->v0, &l->v1};
    double *t[] = {&l->t0, &l->t1};
    char *end;
    for (int i = 0; i < 3; i++, text = end) {
        *number[i] = (uint32_t)strtoul(text, &end, 10);
        if (end == text)
            return false;
    }
    for (int i = 0; i < 2; i++, text = end) {
        *t[i] = strtod(text, &end);
        if (end == text)
            return false;
    }
    return sscanf(text, "%15s", l->class) == 1;
}

static bool golden_read(const char *path, golden_file *g, FILE *out)
{
    char text[400];
    size_t room = 0, lines = 0;
    FILE *file = fopen(path, "r");
    *g = (golden_file){.slack = -1};
    if (!file) {
        fprintf(out, "%s: %s\n", path, strerror(errno));
        return false;
    }
    while (fgets(text, sizeof text, file)) {
        golden_line l = {0};
        lines++;
        if (!strncmp(text, "# slack ", 8))
            g->slack = strtod(text + 8, NULL);
        if (sscanf(text, "# model %299s", g->model) == 1 || sscanf(text, "# view %99s", g->view) == 1 || text[0] == '#')
            continue;
        if (g->count == room) {
            golden_line *more = realloc(g->line, (room = 2 * room + 64) * sizeof *more);
            if (!more)
                break;
            g->line = more;
        }
        if (!read_line(text, &l))
            break;
        g->line[g->count++] = l;
    }
    bool ok = feof(file) && g->model[0] && g->view[0] && g->slack >= 0;
    if (!ok)
        fprintf(out, "%s:%zu: not to be understood\n", path, lines);
    fclose(file);
    return ok;
}

/* Writes every edge with its ends in space and its hidden parts, for a check by hand. */
static void list_edges(const roberts_mesh *mesh, const roberts_camera *camera, FILE *file)
{
    oracle_view view = {.x = camera->dir.x, .y = camera->dir.y, .z = camera->dir.z};
    oracle_result truth;
    if (!oracle_run(mesh, &view, NULL, &truth))
        return;
    if (truth.edge_count < BY_HAND_EDGES) {
        fprintf(file, "#\n# All edges, viewer in direction (%g, %g, %g):\n", view.x, view.y, view.z);
        for (size_t i = 0; i < truth.edge_count; i++) {
            const oracle_edge *e = truth.edge + i;
            roberts_vec3 p = mesh->vertex[e->v0], q = mesh->vertex[e->v1];
            fprintf(file, "# %u: %u-%u, (%g, %g, %g) to (%g, %g, %g): %s", e->solid, e->v0, e->v1, p.x, p.y, p.z, q.x,
                    q.y, q.z,
                    e->survives == ORACLE_NO ? "back"
                    : e->sure_count          ? "hidden"
                                             : "visible");
            for (size_t k = 0; k < e->sure_count && e->survives != ORACLE_NO; k++)
                fprintf(file, " %.12g..%.12g", truth.interval[e->sure + k].t0, truth.interval[e->sure + k].t1);
            fputc('\n', file);
        }
    }
    oracle_free(&truth);
}

bool golden_write(const char *model, const char *view, const char *golden, FILE *out)
{
    roberts_mesh mesh;
    roberts_camera camera;
    roberts_drawing drawing;
    golden_file g = {0};
    golden_total total = {0};
    FILE *file = NULL;
    bool ok = draw_model(model, view, &mesh, &camera, &drawing, out) && from_drawing(&drawing, &g);
    if (!ok)
        goto done;
    snprintf(g.model, sizeof g.model, "%s", model);
    snprintf(g.view, sizeof g.view, "%s", view);
    ok = oracle_agrees(&g, &mesh, &camera, &total, NULL);
    if (!ok) { /* contacts in the model are rounded, or the program is wrong */
        total.unjudged = 0;
        g.slack = SPOILED;
        ok = oracle_agrees(&g, &mesh, &camera, &total, out);
    }
    if (!ok)
        goto done;
    file = fopen(golden, "w");
    ok = file != NULL;
    if (!ok) {
        fprintf(out, "%s: %s\n", golden, strerror(errno));
        goto done;
    }
    fprintf(file, "# model %s\n# view %s\n# slack %g\n# solid v0 v1 t0 t1 class, of visible segments\n", model, view,
            g.slack);
    for (size_t i = 0; i < g.count; i++)
        fprintf(file, "%u %u %u %.12g %.12g %s\n", g.line[i].solid, g.line[i].v0, g.line[i].v1, g.line[i].t0,
                g.line[i].t1, g.line[i].class);
    list_edges(&mesh, &camera, file);
    ok = !ferror(file);
    ok = fclose(file) == 0 && ok;
    fprintf(out, "%s: %zu segments; slack %g, not judged %.3g edges\n", golden, g.count, g.slack, total.unjudged);
done:
    free(g.line);
    roberts_drawing_free(&drawing);
    roberts_mesh_free(&mesh);
    return ok;
}

static bool program_agrees(const char *path, const golden_file *want, const golden_file *got, FILE *out)
{
    for (size_t i = 0; i < want->count || i < got->count; i++) {
        const golden_line *w = want->line + i, *g = got->line + i;
        if (i < want->count && i < got->count && w->solid == g->solid && w->v0 == g->v0 && w->v1 == g->v1 &&
            fabs(w->t0 - g->t0) <= JUDGE_LIMIT && fabs(w->t1 - g->t1) <= JUDGE_LIMIT && !strcmp(w->class, g->class))
            continue;
        fprintf(out, "%s: segment %zu:\n", path, i + 1);
        if (i < want->count)
            fprintf(out, "  golden   %u %u %u %.17g %.17g %s\n", w->solid, w->v0, w->v1, w->t0, w->t1, w->class);
        if (i < got->count)
            fprintf(out, "  program  %u %u %u %.17g %.17g %s\n", g->solid, g->v0, g->v1, g->t0, g->t1, g->class);
        fprintf(out, "  build/roberts -f csv --view %s %s\n", want->view, want->model);
        return false;
    }
    return true;
}

bool golden_check(const char *golden, golden_total *total, FILE *out)
{
    golden_file want, got = {0};
    roberts_mesh mesh = {0};
    roberts_drawing drawing = {0};
    roberts_camera camera;
    bool ok = golden_read(golden, &want, out) && draw_model(want.model, want.view, &mesh, &camera, &drawing, out) &&
              from_drawing(&drawing, &got);
    if (ok) {
        ok = program_agrees(golden, &want, &got, out);
        ok = oracle_agrees(&want, &mesh, &camera, total, out) && ok;
        total->models++;
        total->segments += want.count;
    }
    free(want.line);
    free(got.line);
    roberts_drawing_free(&drawing);
    roberts_mesh_free(&mesh);
    return ok;
}
