/* report.c - the reports of --stats, --verify and --pick. */
#include "cli/report.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <sys/resource.h>
#include <time.h>

#include "cli/message.h"

/* ---- times ---- */

static double seconds(clockid_t clock)
{
    struct timespec now = {0};
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

roberts_time report_now(void)
{
    return (roberts_time){seconds(CLOCK_PROCESS_CPUTIME_ID), seconds(CLOCK_MONOTONIC)};
}

roberts_time report_since(roberts_time start)
{
    roberts_time now = report_now();
    return (roberts_time){now.cpu - start.cpu, now.wall - start.wall};
}

roberts_time report_sum(roberts_time a, roberts_time b)
{
    return (roberts_time){a.cpu + b.cpu, a.wall + b.wall};
}

/* ---- --stats ---- */

typedef struct figure {
    const char *key; /* in JSON; NULL: not printed at all */
    const char *text;
    uint64_t value;
} figure;

typedef struct stage {
    const char *name;
    roberts_time time;
} stage;

bool report_count(void *run, const roberts_segment *segment)
{
    ((run_stats *)run)->segments[segment->state]++;
    return true;
}

static void add_tally(roberts_tally *sum, const roberts_tally *t)
{
    sum->pairs += t->pairs;
    sum->test1_visible += t->test1_visible;
    sum->test2_visible += t->test2_visible;
    sum->test3_visible += t->test3_visible;
    sum->test3_invisible += t->test3_invisible;
    sum->test4 += t->test4;
    sum->covered += t->covered;
    sum->pierced += t->pierced;
    sum->refined += t->refined;
}

/* Adds up the counts and times of all views. The sum has no segments. */
static roberts_drawing add_up(const roberts_drawing *drawing, size_t views)
{
    roberts_drawing sum = *drawing;
    for (const roberts_drawing *d = drawing + 1; d < drawing + views; d++) {
        sum.count += d->count;
        sum.solids += d->solids;
        sum.culled_solids += d->culled_solids;
        sum.front_faces += d->front_faces;
        sum.back_faces += d->back_faces;
        sum.edge_on_faces += d->edge_on_faces;
        sum.edges += d->edges;
        sum.surviving_edges += d->surviving_edges;
        sum.drawn_edges += d->drawn_edges;
        sum.seams += d->seams;
        sum.crossing_count += d->crossing_count;
        sum.crossing_pairs += d->crossing_pairs;
        add_tally(&sum.tally, &d->tally);
        sum.view_time = report_sum(sum.view_time, d->view_time);
        sum.grid_time = report_sum(sum.grid_time, d->grid_time);
        sum.hide_time = report_sum(sum.hide_time, d->hide_time);
        sum.region_time = report_sum(sum.region_time, d->region_time);
    }
    sum.segment = NULL;
    sum.crossing = NULL;
    return sum;
}

/* kB; Linux and the BSDs count in these, others in bytes. */
static uint64_t peak_memory(void)
{
    struct rusage usage = {0};
    getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
    usage.ru_maxrss /= 1024;
#endif
    return (uint64_t)usage.ru_maxrss;
}

static void print_figures(FILE *log, const figure *figures, size_t count, bool json)
{
    for (size_t i = 0; i < count; i++)
        if (!figures[i].key)
            continue;
        else if (json)
            fprintf(log, "%s\"%s\":%" PRIu64, i ? "," : "", figures[i].key, figures[i].value);
        else
            fprintf(log, "%14" PRIu64 "  %s\n", figures[i].value, figures[i].text);
}

static void print_stages(FILE *log, const stage *stages, size_t count, bool json)
{
    if (!json)
        fputs("           cpu        wall  seconds\n", log);
    for (size_t i = 0; i < count; i++)
        if (json)
            fprintf(log, "%s\"%s\":{\"cpu\":%.6f,\"wall\":%.6f}", i ? "," : "", stages[i].name, stages[i].time.cpu,
                    stages[i].time.wall);
        else
            fprintf(log, "%14.3f%12.3f  %s\n", stages[i].time.cpu, stages[i].time.wall, stages[i].name);
}

/* The travel of the pen; nothing if there is no page. */
static void print_ink(FILE *log, const roberts_ink *ink, const roberts_placement *placement, bool json)
{
    char ratio[REPORT_RATIO];
    if (json && !(ink->scale > 0.0))
        fputs(",\"strokes\":null,\"pen_down_mm\":null,\"pen_up_mm\":null,\"scale\":null,\"origin_mm\":null", log);
    else if (json)
        fprintf(log,
                ",\"strokes\":%zu,\"pen_down_mm\":%.3f,\"pen_up_mm\":%.3f,\"scale\":%.17g,\"origin_mm\":[%.17g,%.17g]",
                ink->strokes, ink->down_mm, ink->up_mm, ink->scale, ink->origin_mm.x, ink->origin_mm.y);
    else if (ink->scale > 0.0)
        fprintf(log,
                "%14zu  strokes\n%14.1f  mm with the pen down\n%14.1f  mm with the pen up\n%14.6g  mm on paper per "
                "model unit\n",
                ink->strokes, ink->down_mm, ink->up_mm, ink->scale);
    if (!json && report_ratio(ink, placement, ratio))
        fprintf(log, "%14s  scale\n", ratio);
}

bool report_ratio(const roberts_ink *ink, const roberts_placement *placement, char ratio[REPORT_RATIO])
{
    double scale = ink->scale / (placement->unit_mm > 0.0 ? placement->unit_mm : 1.0);
    if (!(scale > 0.0) || !(placement->scale > 0.0 || placement->standard))
        return false;
    const double larger = scale < 1.0 ? 1.0 / scale : scale;
    const bool whole = larger >= 1e5 && larger < 1e15; /* 1:1000000, and not 1:1e+06 */
    snprintf(ratio, REPORT_RATIO, scale < 1.0 ? "1:%.*g" : "%.*g:1", whole ? 15 : 6,
             whole ? nearbyint(larger) : larger);
    return true;
}

/* The results of --verify, only in JSON: report_verify() has already printed them as text. null without --verify. */
static void print_verified(FILE *log, const cli_options *options, const roberts_verification *found)
{
    if (options->stats == STATS_JSON && !options->verify)
        fputs(",\"verified\":null", log);
    else if (options->stats == STATS_JSON)
        fprintf(log, ",\"verified\":{\"segments\":%zu,\"points\":%zu,\"undecided\":%zu,\"contradictions\":%zu}",
                found->segments, found->points, found->undecided, found->contradictions);
}

/* Which picture it is. */
static void print_name(const cli_options *options)
{
    if (options->stats == STATS_JSON) {
        fputs("\"file\":", options->log);
        message_json(options->log, options->input[0]);
        fputs(",\"output\":", options->log);
        message_json(options->log, options->draw.format == ROBERTS_NULL ? NULL : options->output);
        fputs(",", options->log);
    } else if (options->label) {
        message_begin(options->log, options->label);
        fputs("statistics\n", options->log);
    }
}

/* Why the touching distance is what it is. */
static const struct epsilon_reason {
    const char *json, *text;
} epsilon_reasons[] = {
    [ROBERTS_EPSILON_GIVEN] = {"given", "as given"},
    [ROBERTS_EPSILON_DIAMETER] = {"diameter", "1e-11 of the diameter"},
    [ROBERTS_EPSILON_ROUNDING] = {"rounding", "16 units of the last place of the largest coordinate"},
    [ROBERTS_EPSILON_FLOAT32] = {"float32", "2 units of the last place of the largest 32-bit float"},
    [ROBERTS_EPSILON_DECIMAL] = {"decimal", "2 units of the last place of decimal coordinates"}};

static void print_epsilon(FILE *log, const roberts_drawing *d, bool json)
{
    const struct epsilon_reason *reason = &epsilon_reasons[d->epsilon_reason];
    if (json)
        fprintf(log, ",\"epsilon\":%.17g,\"epsilon_reason\":\"%s\",\"scene_diameter\":%.17g", d->epsilon, reason->json,
                d->scene_diameter);
    else
        fprintf(log, "%14.4g  epsilon, model units: %s\n%14.6g  diameter of the scene, model units\n", d->epsilon,
                reason->text, d->scene_diameter);
}

static void print_tally(FILE *log, const roberts_tally *tally, bool json)
{
    const figure tests[] = {
        {"pairs", "pairs of edge and front", tally->pairs},
        {"test1_visible", "test 1: in front of the plane, visible", tally->test1_visible},
        {"test2_visible", "test 2: the sight plane misses the face, visible", tally->test2_visible},
        {"test3_visible", "test 3: outside one side, visible", tally->test3_visible},
        {"test3_invisible", "test 3: inside all sides, invisible", tally->test3_invisible},
        {"test4", "test 4: cut at the crossings", tally->test4},
        {"covered", "edges behind covers or at the back of a body, no test", tally->covered},
        {"pierced", "hidden parts that end in a face", tally->pierced},
        {"refined", "signs and crossings refined", tally->refined},
    };
    fputs(json ? ",\"tests\":{" : "", log);
    print_figures(log, tests, sizeof tests / sizeof tests[0], json);
    fputs(json ? "}" : "", log);
}

void report_stats(const cli_options *options, const run_stats *run, const roberts_drawing *drawing, size_t views)
{
    FILE *log = options->log;
    const bool json = options->stats == STATS_JSON;
    const roberts_drawing sum = add_up(drawing, views), *d = &sum;
    const bool whole = run->pieces == run->faces; /* no face had to be cut into pieces, so no edge into parts */
    const figure counts[] = {
        {"files", "files", run->files},
        {"solids", "bodies", d->solids},
        {"culled_solids", "of them culled, wholly hidden", d->culled_solids},
        {"vertices", "vertices", run->vertices * views},
        {"faces", "faces", run->faces * views},
        {whole ? NULL : "pieces", "convex pieces of them", run->pieces * views},
        {"front_faces", "of them front", d->front_faces},
        {"back_faces", "back", d->back_faces},
        {"edge_on_faces", "edge-on", d->edge_on_faces},
        {"edges", "edges", whole ? d->edges : run->edges * views},
        {whole ? NULL : "edge_parts", "parts of them, and cuts between pieces", d->edges},
        {"surviving_edges", "of them with a front face", d->surviving_edges},
        {"drawn_edges",
         options->hide.keep_hidden ? "to draw, which leaves out those below the crease angle"
                                   : "to draw, which leaves out those at the back and below the crease angle",
         d->drawn_edges},
        {"segments", "segments", d->count},
        {"visible", "of them visible", run->segments[ROBERTS_VISIBLE]},
        {"hidden", "hidden", run->segments[ROBERTS_HIDDEN]},
        {"clipped", "clipped", run->segments[ROBERTS_CLIPPED]},
        {"crossing_pairs", "pairs of faces that cross", d->crossing_pairs},
        {"crossings", "lines in which they cross", d->crossing_count},
        {"grid", "columns of the grid", d->grid},
        {"grid_rows", "rows", d->grid_rows},
        {"peak_memory_kb", "kB of memory at most", peak_memory()},
        {options->hide.unite ? "seams" : NULL, "edges left out, or parts of them, where bodies are one", d->seams},
    };
    const stage stages[] = {
        {"read", run->read},     {"solids", run->solids}, {"view", d->view_time},
        {"grid", d->grid_time},  {"hide", d->hide_time},  {"regions", d->region_time},
        {"verify", run->verify}, {"draw", run->draw},     {"total", run->total},
    };
    fputs(json ? "{\"version\":\"" ROBERTS_VERSION "\"," : "", log);
    print_name(options);
    if (views > 1)
        fprintf(log, json ? "\"views\":%zu," : "%14zu  views, counted together\n", views);
    print_figures(log, counts, sizeof counts / sizeof counts[0], json);
    print_ink(log, &run->ink, &options->draw.placement, json);
    print_epsilon(log, d, json);
    print_tally(log, &d->tally, json);
    print_verified(log, options, &run->found);
    fputs(json ? ",\"seconds\":{" : "", log);
    print_stages(log, stages, sizeof stages / sizeof stages[0], json);
    fputs(json ? "}}\n" : "", log);
}

/* ---- --verify ---- */

enum { TOLD_MOST = 20 };

typedef struct telling {
    const cli_options *options;
    size_t told;
} telling;

static void tell_contradiction(void *context, const roberts_contradiction *c)
{
    telling *t = context;
    FILE *log = t->options->log;
    if (t->told++ >= TOLD_MOST)
        return;
    message_open(log);
    message_begin(log, t->options->label);
    fprintf(log, "verify: body %u, ", (unsigned)c->solid);
    if (c->v0 != ROBERTS_NONE)
        fprintf(log, "edge %u-%u", (unsigned)c->v0, (unsigned)c->v1);
    else if (c->face[1] != ROBERTS_NONE)
        fprintf(log, "intersection of faces %u and %u", (unsigned)c->face[0], (unsigned)c->face[1]);
    else if (c->face[0] != ROBERTS_NONE)
        fprintf(log, "intersection of face %u and a face of a hull", (unsigned)c->face[0]);
    else
        fputs("intersection of two faces of hulls", log);
    fprintf(log, ", t = %.17g: ", c->t);
    if (!c->no_line)
        fprintf(log, "drawn %s, but ", c->drawn == ROBERTS_VISIBLE ? "visible" : "hidden");
    if (c->no_line)
        fputs("they do not cross there\n", log);
    else if (c->cast == ROBERTS_CLIPPED)
        fputs("the near plane cuts it off\n", log);
    else if (c->cast == ROBERTS_HIDDEN && c->drawn == ROBERTS_HIDDEN)
        fprintf(log, "it is body %u that hides it, not body %u\n", (unsigned)c->by, (unsigned)c->drawn_by);
    else if (c->cast == ROBERTS_HIDDEN)
        fprintf(log, "body %u hides it\n", (unsigned)c->by);
    else
        fputs("nothing hides it\n", log);
    message_close(log);
}

/* Most rays say nothing: that is no proof. */
static void warn_undecided(const cli_options *options, const roberts_drawing *d)
{
    const roberts_warnings *to = &options->scene.warnings;
    char text[200];
    snprintf(text, sizeof text,
             "verify: most points are undecided: they are within about epsilon of a change, and epsilon is %.4g (%s)",
             d->epsilon, epsilon_reasons[d->epsilon_reason].text);
    if (to->warn)
        to->warn(to->context, options->label ? options->label : "", 0, text);
}

roberts_status report_verify(const cli_options *options, const roberts_scene *scene, const roberts_drawing *drawing,
                             roberts_verification *sum, roberts_error *error)
{
    telling t = {.options = options};
    FILE *log = options->log;
    roberts_verification found;
    roberts_verify_options verify = roberts_verify_options_default();
    verify.rays = options->verify_rays;
    verify.crease_degrees = options->hide.crease_degrees;
    verify.crease_auto = options->hide.crease_auto;
    verify.all_edges = options->hide.all_edges;
    verify.unite = options->hide.unite;
    verify.threads = options->hide.threads;
    verify.contradiction = tell_contradiction;
    verify.context = &t;
    roberts_status status = roberts_verify(scene, &options->camera, drawing, &verify, &found, error);
    if (status == ROBERTS_OK) {
        sum->segments += found.segments;
        sum->points += found.points;
        sum->undecided += found.undecided;
        sum->contradictions += found.contradictions;
    }
    message_open(log);
    if (t.told > TOLD_MOST) {
        message_begin(log, options->label);
        fprintf(log, "verify: ... and %zu more\n", t.told - TOLD_MOST);
    }
    if (status == ROBERTS_OK) {
        message_begin(log, options->label);
        fprintf(log,
                "verify: %zu points of %zu segments checked, visible and hidden, drawn or not; "
                "contradictions: %zu, undecided: %zu\n",
                found.points, found.segments, found.contradictions, found.undecided);
    }
    message_close(log);
    if (status == ROBERTS_OK && found.undecided > found.points / 2)
        warn_undecided(options, drawing);
    return status;
}

/* ---- --pick ---- */

/* A point outside the whole picture may have been measured in millimetres on the page. */
static void tell_nothing_picked(const cli_options *options, const roberts_scene *scene, roberts_vec2 p)
{
    roberts_vec2 low, high;
    bool framed, known = roberts_window(scene, &options->camera, &low, &high, &framed, NULL) == ROBERTS_OK;
    if (known && framed)
        roberts_page_shape(&options->draw.page, &low, &high);
    message_begin(options->log, options->label);
    fprintf(options->log, "pick %.12g,%.12g: nothing is there", p.x, p.y);
    if (known && (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y))
        fprintf(options->log, "; the picture reaches from %.6g,%.6g to %.6g,%.6g", low.x, low.y, high.x, high.y);
    fputs("\n", options->log);
}

/* A face that the input does not have. */
static const char *name_unnumbered(const cli_options *options)
{
    if (!options->scene.hull)
        return "cut by the near plane";
    return options->camera.projection == ROBERTS_PERSPECTIVE || options->camera.has_section
               ? "a face of its hull, or cut by the near plane"
               : "a face of its hull";
}

static roberts_status pick_one(const cli_options *options, const roberts_scene *scene, roberts_vec2 p,
                               roberts_error *error)
{
    roberts_picked picked;
    roberts_status status = roberts_pick(scene, &options->camera, p.x, p.y, &picked, error);
    message_open(options->log);
    if (status == ROBERTS_OK && picked.count == 0)
        tell_nothing_picked(options, scene, p);
    for (size_t i = 0; i < picked.count; i++) {
        const roberts_pick_hit *hit = &picked.hit[i];
        message_begin(options->log, options->label);
        fprintf(options->log, "pick %.12g,%.12g: %sbody %u, ", p.x, p.y, i ? "behind it " : "", (unsigned)hit->solid);
        if (hit->face == ROBERTS_NONE)
            fprintf(options->log, "%s, ", name_unnumbered(options));
        else
            fprintf(options->log, "face %u, ", (unsigned)hit->face);
        fprintf(options->log, "depth %.12g, at %.12g,%.12g,%.12g\n", hit->depth, hit->point.x, hit->point.y,
                hit->point.z);
    }
    message_close(options->log);
    roberts_picked_free(&picked);
    return status;
}

roberts_status report_picks(const cli_options *options, const roberts_scene *scene, roberts_error *error)
{
    roberts_status status = ROBERTS_OK;
    for (size_t i = 0; i < options->pick_count && status == ROBERTS_OK; i++)
        status = pick_one(options, scene, options->pick[i], error);
    return status;
}
