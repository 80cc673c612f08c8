/* picture.c - from the input files to the output.
 *
 * The pictures of a turntable share one window, the box of the windows of all sides, so that they have one scale and
 * nothing jumps. The letters of their labels have one size, too. */
#include "cli/picture.h"

#include <math.h>
#include <string.h>

#include "cli/hints.h"
#include "cli/lists.h"
#include "cli/message.h"
#include "cli/parse.h"
#include "cli/parts.h"
#include "cli/report.h"
#include "cli/signals.h"
#include "cli/values.h"

enum { NAME_SIZE = 4096, HULLS_TOLD = 20 };

typedef struct picture_window {
    roberts_vec2 min, max;
    bool framed; /* one of them is a field of view */
} picture_window;

/* What is drawn on one page: one view, or those of a sheet. */
typedef struct views {
    roberts_drawing drawing[ROBERTS_SHEET_VIEWS];
    roberts_region_list regions[ROBERTS_SHEET_VIEWS]; /* empty if nothing needs them */
    size_t count;
    bool explained; /* a warning has said why it is almost empty */
} views;

/* Names the inputs: the first of them, and how many more there are. */
static const char *name_several(const cli_options *options, const char *first, char *name, size_t size)
{
    if (strcmp(first, "-") == 0)
        first = "standard input";
    if (options->input_count > 1)
        snprintf(name, size, "%s and %zu more", first, options->input_count - 1);
    else
        snprintf(name, size, "%s", first);
    return name;
}

/* What messages call the inputs. */
static const char *name_inputs(const cli_options *options, char *name, size_t size)
{
    return name_several(options, options->input[0], name, size);
}

/* The same without folders. */
static const char *write_title(const cli_options *options, char *title, size_t size)
{
    const char *first = options->input[0], *slash = strrchr(first, '/');
    return name_several(options, slash ? slash + 1 : first, title, size);
}

static void warn_of_file(const cli_options *options, const char *file, const char *text)
{
    const roberts_warnings *to = &options->scene.warnings;
    if (to->warn)
        to->warn(to->context, file, 0, text);
}

static void warn_of_inputs(const cli_options *options, const char *text)
{
    char name[NAME_SIZE];
    warn_of_file(options, name_inputs(options, name, sizeof name), text);
}

/* Begins a line about the inputs in the log. */
static void begin_of_inputs(const cli_options *options)
{
    char name[NAME_SIZE];
    message_begin(options->log, name_inputs(options, name, sizeof name));
}

/* Reports the error, which concerns the inputs if it names no file. Returns the exit status. */
static int fail(const cli_options *options, roberts_error *error, picture_result *result)
{
    if (!error->file[0] && error->status != ROBERTS_BAD_ARGUMENT)
        name_inputs(options, error->file, sizeof error->file);
    hint_memory(options, error);
    result->error = *error;
    return message_error(options->log, error);
}

static roberts_status read_all(const cli_options *options, const char *const *name, size_t count, roberts_mesh *mesh,
                               roberts_error *error)
{
    roberts_status status = ROBERTS_OK;
    for (size_t i = 0; i < count && status == ROBERTS_OK; i++) {
        status = roberts_mesh_read_file(mesh, name[i], &options->scene.warnings, error);
        if (status != ROBERTS_OK)
            hint_unread(options, name[i], error);
    }
    if (status == ROBERTS_OK && options->y_up)
        roberts_mesh_stand_up(mesh);
    return status;
}

/* Reads the models for which there is to be room. */
static roberts_status read_room(const cli_options *options, roberts_mesh *room, roberts_error *error)
{
    if (!values_has_page(options->draw.format))
        return ROBERTS_OK; /* a table has no room */
    const roberts_status status = read_all(options, options->room, options->room_count, room, error);
    if (status == ROBERTS_OK && options->room_count > 0 && room->corner_count == 0 && !options->quiet)
        warn_of_file(options, options->room[0], "--room-for has no effect: there is no face in it");
    return status;
}

/* Names the solids that hulls have replaced, by their numbers; prints nothing if there are none. */
static void tell_hulls(const cli_options *options, const roberts_scene *scene)
{
    const uint32_t solids = (uint32_t)roberts_scene_solid_count(scene);
    uint32_t hulls = 0, told = 0;
    for (uint32_t s = 0; s < solids; s++)
        hulls += roberts_scene_is_hull(scene, s);
    if (hulls == 0)
        return;
    begin_of_inputs(options);
    fputs(hulls == 1 ? "a convex hull in place of solid" : "convex hulls in place of solids", options->log);
    for (uint32_t s = 0; s < solids && told < HULLS_TOLD; s++)
        if (roberts_scene_is_hull(scene, s))
            fprintf(options->log, "%s%u", told++ ? ", " : " ", (unsigned)s);
    fputs(hulls > told ? " ...\n" : "\n", options->log);
}

/* Prints the kinds of the bodies; nothing if all are convex. */
static void tell_kinds(const cli_options *options, const roberts_scene *scene)
{
    static const char *const names[] = {
        [ROBERTS_CONVEX] = "convex", [ROBERTS_CLOSED] = "closed but not convex", [ROBERTS_OPEN] = "open"};
    size_t of[ROBERTS_OPEN + 1] = {0}, told = 0;
    for (uint32_t s = 0; s < roberts_scene_solid_count(scene); s++)
        of[roberts_scene_body_kind(scene, s)]++;
    if (of[ROBERTS_CLOSED] + of[ROBERTS_OPEN] == 0)
        return;
    begin_of_inputs(options);
    for (size_t kind = 0; kind <= ROBERTS_OPEN; kind++)
        if (of[kind] > 0)
            fprintf(options->log, "%s%zu %s", told++ ? ", " : "bodies: ", of[kind], names[kind]);
    fputc('\n', options->log);
}

static void note_of_inputs(const cli_options *options, const char *text)
{
    message_open(options->log);
    begin_of_inputs(options);
    fprintf(options->log, "note: %s\n", text);
    message_close(options->log);
}

/* Prints that rounding may have moved what touches, if something touches or crosses. */
static void tell_rounded(const cli_options *options, const roberts_drawing *drawing, const run_stats *run)
{
    if (run->step > 0.0 && drawing->tally.pierced + drawing->crossing_count > 0)
        note_of_inputs(
            options, "faces cross, and coordinates are decimals of few digits or 32-bit floats; if these were rounded, "
                     "--rounded draws what touched before");
}

/* Prints that edges of 30 degrees and less are left out of curved bodies, or that those of convex bodies of many faces
 * are drawn, unless --crease, --all-edges or --quiet is given. */
static void tell_curved(const cli_options *options, const roberts_scene *scene)
{
    char text[120];
    if (options->quiet || !options->hide.crease_auto || options->hide.all_edges)
        return;
    const size_t curved = hint_curved(scene), round = hint_round(scene);
    snprintf(text, sizeof text,
             "edges of 30 degrees and less are left out of %zu curved bod%s; --crease 0.1 draws them", curved,
             curved == 1 ? "y" : "ies");
    if (curved > 0)
        note_of_inputs(options, text);
    snprintf(text, sizeof text,
             "edges of 30 degrees and less of %zu convex bod%s are drawn; --crease 30 leaves them out", round,
             round == 1 ? "y" : "ies");
    if (round > 0)
        note_of_inputs(options, text);
}

static void tell_scene(const cli_options *options, const roberts_scene *scene, const run_stats *run)
{
    const size_t bodies = roberts_scene_solid_count(scene);
    message_open(options->log);
    begin_of_inputs(options);
    fprintf(options->log, "%zu bod%s, %zu vertices, %zu face%s", bodies, bodies == 1 ? "y" : "ies", run->vertices,
            run->faces, run->faces == 1 ? "" : "s");
    if (run->lines > 0)
        fprintf(options->log, ", %zu %s", run->lines, run->lines == 1 ? "point or line" : "points and lines");
    fprintf(options->log, "; %.3f s\n", run->read.wall + run->solids.wall);
    if (*run->missing) {
        begin_of_inputs(options);
        fprintf(options->log, "colours are missing, since there is no file %s\n", run->missing);
    }
    tell_kinds(options, scene);
    if (options->scene.hull)
        tell_hulls(options, scene);
    message_close(options->log);
}

/* Counts the elements of one corner or two. */
static size_t count_lines(const roberts_mesh *mesh)
{
    size_t count = 0;
    for (size_t f = 0; f < mesh->face_count; f++)
        count += mesh->face_start[f + 1] - mesh->face_start[f] - 1 < 2;
    return count;
}

/* Finds the first .mtl file that an OBJ names and that is not there. */
static void find_missing(const roberts_mesh *mesh, run_stats *run)
{
    for (size_t i = 0; i < mesh->source_count && !*run->missing; i++)
        if (mesh->source[i].missing)
            snprintf(run->missing, sizeof run->missing, "%s", mesh->source[i].missing);
    for (char *c = run->missing; *c; c++)
        *c = message_is_control(*c) ? '?' : *c;
}

/* Are names compared with the mesh? */
static bool checks_names(const cli_options *options)
{
    return options->names && !options->quiet;
}

static void warn_names(const cli_options *options, const roberts_mesh *mesh, size_t bodies)
{
    char text[256];
    if (checks_names(options) && hint_idle_names(options, mesh, bodies, text, sizeof text))
        warn_of_inputs(options, text);
}

/* What has labels. */
static unsigned label_kinds(const roberts_draw_options *page)
{
    unsigned kinds = page->lettering.labels;
    for (size_t i = 0; i < page->lettering.name_count; i++)
        kinds |= (unsigned)page->lettering.name[i].of;
    return values_has_page(page->format) ? kinds : 0;
}

/* Options without effect on these bodies. With --batch they may be for other models. `faces`: of the mesh. */
static void warn_idle_bodies(const cli_options *options, const roberts_scene *scene, size_t faces)
{
    if (options->quiet || options->batch)
        return;
    if (options->scene.hull && hint_idle_hull(scene, faces))
        warn_of_inputs(options, "--hull has no effect: all bodies are convex solids");
    if (options->scene.even_odd && hint_idle_rule(scene))
        warn_of_inputs(options, "--fill-rule has no effect: no face crosses itself");
    if (label_kinds(&options->draw) & ROBERTS_LABEL_NAMES && hint_no_names(scene))
        warn_of_inputs(options, "--label names has no effect: no body has a name in the file");
    const bool is_table = values_is_table(options->draw.format);
    if (is_table && values_has_column(&options->draw, ROBERTS_COLUMN_NAME) && hint_no_names(scene))
        warn_of_inputs(options, "--columns +name has no effect: no body has a name in the file");
    if (is_table && values_has_column(&options->draw, ROBERTS_COLUMN_BY) && options->hide.keep_hidden &&
        hint_no_names(scene))
        warn_of_inputs(options, "--columns +by has no effect: no body has a name in the file");
}

/* Reads the inputs and builds the scene. The mesh is released. */
static roberts_status load(const cli_options *options, roberts_scene **scene, run_stats *run, roberts_error *error)
{
    roberts_mesh mesh = {.threads = options->hide.threads};
    roberts_scene_options solids = options->scene;
    roberts_time start = report_now();
    solids.threads = options->hide.threads;
    progress_stage("reading");
    roberts_status status = read_all(options, (const char *const *)options->input, options->input_count, &mesh, error);
    run->read = report_since(start);
    if (status == ROBERTS_OK && options->verbose)
        run->lines = count_lines(&mesh);
    find_missing(&mesh, run);
    if (!options->quiet && !options->scene.rounded && options->hide.epsilon == 0.0)
        run->step = roberts_mesh_step(&mesh);
    const size_t faces = mesh.face_count; /* building may take the mesh */
    if (status == ROBERTS_OK) {
        start = report_now();
        progress_stage("finding the bodies");
        status = checks_names(options) ? roberts_scene_build(&mesh, &solids, scene, error)
                                       : roberts_scene_take(&mesh, &solids, scene, error);
        run->solids = report_since(start);
        if (status != ROBERTS_OK)
            hint_refused(options, &mesh, error);
        else
            warn_names(options, &mesh, roberts_scene_solid_count(*scene));
    }
    roberts_mesh_free(&mesh);
    if (status != ROBERTS_OK)
        return status;
    run->vertices = roberts_scene_vertex_count(*scene);
    run->faces = roberts_scene_face_count(*scene);
    run->pieces = roberts_scene_piece_count(*scene);
    run->edges = roberts_scene_edge_count(*scene);
    if (options->verbose)
        tell_scene(options, *scene, run);
    warn_idle_bodies(options, *scene, faces);
    tell_curved(options, *scene);
    return status;
}

/* Whether the output or a check needs the body that hides a part of a line. */
static bool names_hiders(const cli_options *options)
{
    return values_is_table(options->draw.format) || options->verify ||
           (options->draw.format == ROBERTS_SVG && options->draw.grouping == ROBERTS_GROUP_ELEMENT);
}

/* Whether segments need only be counted: none is written, no ray needs them, and a page would be empty only if there
 * were none. The drawing then holds no segments. */
static bool is_counted_only(const cli_options *options)
{
    const roberts_draw_options *page = &options->draw;
    return page->format == ROBERTS_NULL && !options->verify && !options->is_sheet &&
           options->camera.projection == ROBERTS_ORTHOGRAPHIC && !page->outline.off && !page->border.off &&
           !page->crease.off && !page->intersection.off && !page->wire.off && !page->back.off;
}

/* Whether the drawing needs the visible regions of faces. */
static bool needs_regions(const cli_options *options)
{
    const roberts_draw_options *page = &options->draw;
    const bool fills = page->format == ROBERTS_SVG || page->format == ROBERTS_PDF || page->format == ROBERTS_PS ||
                       page->format == ROBERTS_EPS || page->format == ROBERTS_PNG || page->format == ROBERTS_TIKZ;
    const bool labels = label_kinds(page) & ROBERTS_LABEL_AREAS;
    return labels || (fills && page->fill != ROBERTS_FILL_NONE) ||
           (values_has_page(page->format) && values_hatches(page));
}

/* regions: filled if they are needed, and attached to the drawing. */
static roberts_status hide_and_count(const cli_options *options, const roberts_scene *scene, roberts_drawing *drawing,
                                     roberts_region_list *regions, run_stats *run, roberts_error *error)
{
    const roberts_receiver counter = {report_count, run};
    const bool wanted = needs_regions(options) || options->regions;
    roberts_hide_options hide = options->hide;
    roberts_status status;
    hide.nameless = !names_hiders(options);
    hide.slopes = values_hatches(&options->draw) && options->draw.hatching.along != ROBERTS_HATCH_PICTURE;
    if (is_counted_only(options) && !wanted)
        return roberts_hide_each(scene, &options->camera, &hide, &counter, drawing, error);
    if (wanted) {
        status = roberts_hide_with_regions(scene, &options->camera, &hide, drawing, regions, error);
        drawing->regions = regions;
    } else {
        status = roberts_hide(scene, &options->camera, &hide, drawing, error);
    }
    for (size_t i = 0; i < drawing->count && options->stats != STATS_NONE; i++)
        report_count(run, &drawing->segment[i]);
    return status;
}

/* Hides view `i`; its times and findings are added to `run`. */
static roberts_status hide(const cli_options *options, const roberts_scene *scene, views *v, size_t i, run_stats *run,
                           roberts_error *error)
{
    roberts_drawing *drawing = &v->drawing[i];
    progress_stage("removing hidden lines");
    roberts_status status = hide_and_count(options, scene, drawing, &v->regions[i], run, error);
    if (status == ROBERTS_BAD_ARGUMENT) /* all other options were checked when they were parsed */
        snprintf(error->file, sizeof error->file, "--epsilon");
    roberts_time start = report_now();
    if (status == ROBERTS_OK && options->verify) {
        progress_stage("verifying");
        status = report_verify(options, scene, drawing, &run->found, error);
    }
    if (status == ROBERTS_OK)
        status = report_picks(options, scene, error);
    run->verify = report_sum(run->verify, report_since(start));
    return status;
}

/* What messages call a view of a sheet. */
static const char *name_view(const cli_options *options, size_t i, char *name, size_t size)
{
    snprintf(name, size, "%s%s%s", options->label ? options->label : "", options->label ? ": " : "",
             roberts_sheet_view_name(options->sheet, (int)i));
    return name;
}

static roberts_status hide_all(const cli_options *options, const roberts_scene *scene, views *v, run_stats *run,
                               roberts_error *error)
{
    roberts_status status = ROBERTS_OK;
    *v = (views){.count = options->is_sheet ? ROBERTS_SHEET_VIEWS : 1};
    for (size_t i = 0; i < v->count && status == ROBERTS_OK; i++) {
        char label[NAME_SIZE];
        cli_options one = *options;
        if (options->is_sheet) {
            one.label = name_view(options, i, label, sizeof label);
            roberts_sheet_camera(options->sheet, (int)i, &one.camera);
            one.hide.keep_hidden = options->hide.keep_hidden && i != ROBERTS_SHEET_ISO; /* as ISO 5456-3 prefers */
        }
        status = hide(&one, scene, v, i, run, error);
    }
    return status;
}

/* Whether the output needs faces of edges, names, or vertices from the scene. */
static bool needs_scene(const cli_options *options)
{
    return values_is_table(options->draw.format) || options->distance_count > 0 ||
           options->draw.lettering.labels & ROBERTS_LABEL_NAMES ||
           (options->draw.format == ROBERTS_SVG && options->draw.grouping != ROBERTS_GROUP_CLASS);
}

/* What messages call the drawing. */
static const char *name_output(const cli_options *options, char *name, size_t size)
{
    if (options->draw.format == ROBERTS_NULL)
        return name_inputs(options, name, size);
    return strcmp(options->output, "-") == 0 ? "standard output" : options->output;
}

/* Needs the scene, so it runs before the scene is released. */
static void warn_near(const cli_options *options, const roberts_scene *scene, views *v)
{
    char why[256], name[NAME_SIZE];
    if (options->quiet || !hint_near_plane(options, scene, &v->drawing[0], why, sizeof why))
        return;
    warn_of_file(options, name_output(options, name, sizeof name), why);
    v->explained = true;
}

static bool has_obj(const cli_options *options)
{
    for (size_t i = 0; i < options->input_count; i++)
        if (parse_has_ending(options->input[i], ".obj"))
            return true;
    return false;
}

/* Warns that --fill finds no colour on the faces that are seen. --fill shade is grey then, as it should be unless a
 * file is missing. */
static void warn_no_colors(const cli_options *options, const char *missing)
{
    char text[NAME_SIZE];
    if (options->draw.shaded && !*missing)
        return;
    const int used = snprintf(text, sizeof text, "%s: no face that is seen has a colour",
                              options->draw.shaded ? "--fill shade is grey" : "--fill model has no effect");
    if (*missing)
        snprintf(text + used, sizeof text - (size_t)used, ", since there is no file %s", missing);
    else if (has_obj(options))
        snprintf(text + used, sizeof text - (size_t)used,
                 " (those of an OBJ are in the .mtl files beside it that it names)");
    warn_of_inputs(options, text);
}

/* Has --rounded not enlarged the touching distance? With --batch it may be for other models. In spite of --epsilon it
 * has an effect on bodies. */
static bool is_idle_rounded(const cli_options *options, const roberts_drawing *drawing)
{
    return options->scene.rounded && !options->batch && drawing->epsilon_reason != ROBERTS_EPSILON_DECIMAL &&
           drawing->epsilon_reason != ROBERTS_EPSILON_GIVEN;
}

/* Options without effect on these bodies or these lines. A picture of a turntable may have lines that others do not. */
static void warn_idle(const cli_options *options, const roberts_scene *scene, const views *v, const run_stats *run)
{
    char text[256];
    double width;
    const bool page = values_has_page(options->draw.format);
    if (options->quiet || options->turntable > 0)
        return;
    tell_rounded(options, &v->drawing[0], run);
    if (page && options->draw.crop && v->drawing[0].framed)
        warn_of_inputs(options, "--crop has no effect: the near plane cuts the scene close to the eye");
    if (options->hide.unite && scene && hint_all_open(scene))
        warn_of_inputs(options, "--union has no effect: no body is closed");
    if (options->camera.has_section && !v->drawing[0].sectioned)
        warn_of_inputs(options, "--section has no effect: it cuts off nothing of the scene");
    if (hint_wide_epsilon(options, &v->drawing[0], &width)) {
        snprintf(text, sizeof text,
                 "--epsilon is large: faces are about %.2g wide, and those narrower than --epsilon hide nothing",
                 width);
        warn_of_inputs(options, text);
    }
    if (is_idle_rounded(options, &v->drawing[0]))
        warn_of_inputs(options,
                       v->drawing[0].epsilon_reason == ROBERTS_EPSILON_FLOAT32
                           ? "--rounded has no effect: coordinates are 32-bit floats, whose rounding counts anyway"
                           : "--rounded has no effect: coordinates have no decimals, or more than nine digits and "
                             "are no 32-bit floats, or so few that --epsilon must tell what touches");
    if (page && scene && hint_flat(options, scene, &v->drawing[0]))
        warn_of_inputs(
            options,
            "edges between faces in one plane are left out, so that only borders are drawn; --all-edges draws them");
    if (page && needs_regions(options) && hint_no_colors(options, v->drawing, v->count))
        warn_no_colors(options, run->missing);
    if (page && hint_idle_hatch(options, v->drawing, v->count))
        warn_of_inputs(options, options->draw.hatching.sections
                                    ? "--hatch has no effect: no closed body is cut"
                                    : "--hatch has no effect: the light falls straight on all faces that are seen");
    if (page && hint_idle_pens(options, v->drawing, v->count, text, sizeof text))
        warn_of_inputs(options, text);
}

static void free_views(views *v)
{
    for (size_t i = 0; i < v->count; i++) {
        roberts_drawing_free(&v->drawing[i]);
        roberts_regions_free(&v->regions[i]);
    }
}

/* The name of the table of view `i`. False: the output is no table of a sheet, or its name has no place for that of the
 * view. */
static bool name_table(const cli_options *options, size_t i, char *name, size_t size)
{
    return options->is_sheet && values_is_table(options->draw.format) &&
           parse_named(options->output, roberts_sheet_view_name(options->sheet, (int)i), name, size);
}

/* Writes one file for the page, or one table for each view. */
static roberts_status save_page(const cli_options *options, const roberts_draw_options *page, const views *v,
                                roberts_error *error)
{
    char name[NAME_SIZE];
    roberts_sheet sheet = {.angle = options->sheet};
    roberts_drawing drawing = v->drawing[0];
    roberts_status status = ROBERTS_OK;
    if (is_counted_only(options))
        drawing.count = 0;
    if (!options->is_sheet)
        return roberts_drawing_save(&drawing, page, options->output, error);
    if (!name_table(options, 0, name, sizeof name)) {
        for (size_t i = 0; i < v->count; i++)
            sheet.view[i] = &v->drawing[i];
        return roberts_sheet_save(&sheet, page, options->output, error);
    }
    for (size_t i = 0; i < v->count && status == ROBERTS_OK; i++) {
        name_table(options, i, name, sizeof name); /* it fits: no view has a longer name than the first */
        status = roberts_drawing_save(&v->drawing[i], page, name, error);
    }
    return status;
}

/* The library names what is wrong with a page by a word, "dimensions: ...". If that is an option, it gets its dashes.
 */
static void name_option(roberts_error *error)
{
    const size_t length = strcspn(error->message, ":");
    char message[sizeof error->message];
    for (size_t i = 0; i < option_table_all.count && error->status == ROBERTS_BAD_ARGUMENT; i++)
        if (strlen(option_table_all.row[i].name) == length &&
            strncmp(error->message, option_table_all.row[i].name, length) == 0) {
            memcpy(message, error->message, sizeof message);
            snprintf(error->message, sizeof error->message, "--%.*s", (int)sizeof message - 3, message);
            return;
        }
}

static roberts_status save(const cli_options *options, const roberts_scene *scene, const views *v, run_stats *run,
                           roberts_error *error)
{
    roberts_time start = report_now();
    progress_stage("writing");
    roberts_draw_options page = options->draw;
    char title[256];
    page.title = page.lettering.title ? page.lettering.title : write_title(options, title, sizeof title);
    if (!page.description)
        page.description = options->description.text;
    page.ink = &run->ink;
    page.scene = scene;
    page.lettering.warnings = options->scene.warnings;
    page.lettering.field = options->field;
    page.lettering.field_count = options->field_count;
    page.lettering.unit = options->unit;
    page.lettering.distance = options->distance;
    page.lettering.distance_count = options->distance_count;
    roberts_status status = save_page(options, &page, v, error);
    if (status != ROBERTS_OK)
        name_option(error);
    run->draw = report_sum(run->draw, report_since(start));
    return status;
}

/* An empty page is probably a mistake. */
static void warn_empty(const cli_options *options, const views *v)
{
    bool known = is_counted_only(options) && v->drawing[0].count > 0;
    const char *why = options->quiet || known || v->explained ? NULL : hint_empty(options, v->drawing, v->count);
    char text[256], name[NAME_SIZE];
    if (!why)
        return;
    snprintf(text, sizeof text, "the drawing is empty: %s", why);
    warn_of_file(options, name_output(options, name, sizeof name), text);
}

static size_t count_segments(const views *v)
{
    size_t segments = 0;
    for (size_t i = 0; i < v->count; i++)
        segments += v->drawing[i].count;
    return segments;
}

static void tell(const cli_options *options, const run_stats *run, const views *v)
{
    char name[NAME_SIZE], ratio[REPORT_RATIO];
    const bool to_scale = report_ratio(&run->ink, &options->draw.placement, ratio);
    const size_t segments = count_segments(v);
    warn_empty(options, v);
    message_open(options->log);
    if (options->verbose && options->draw.format != ROBERTS_NULL) {
        message_begin(options->log, name_output(options, name, sizeof name));
        fprintf(options->log, "%zu segment%s%s%s; %.3f s\n", segments, segments == 1 ? "" : "s", to_scale ? " at " : "",
                to_scale ? ratio : "", run->total.wall);
    }
    if (options->stats != STATS_NONE)
        report_stats(options, run, v->drawing, v->count);
    message_close(options->log);
}

/* Writes the visible regions, if they are wanted. */
static roberts_status save_regions(const cli_options *options, const views *v, run_stats *run, roberts_error *error)
{
    roberts_draw_options table = options->draw;
    roberts_time start = report_now();
    if (!options->regions)
        return ROBERTS_OK;
    table.format = ROBERTS_JSON;
    roberts_format_by_path(options->regions, &table.format);
    roberts_status status = roberts_regions_save(&v->regions[0], &table, options->regions, error);
    run->draw = report_since(start);
    return status;
}

/* Gives a picture the window that others share. NULL: it has its own. */
static void set_window(roberts_drawing *drawing, const picture_window *window)
{
    if (!window)
        return;
    drawing->framed = window->framed;
    drawing->windowed = true;
    drawing->window_min = window->min;
    drawing->window_max = window->max;
}

/* Makes one picture. Before the last one is written the scene is released, unless the file needs it. Returns the exit
 * status. */
static int draw(const cli_options *options, roberts_scene **scene, bool last, const picture_window *window,
                run_stats run, picture_result *result)
{
    views v;
    roberts_error error = {0};
    roberts_status status = hide_all(options, *scene, &v, &run, &error);
    if (status == ROBERTS_OK)
        warn_near(options, *scene, &v);
    if (status == ROBERTS_OK)
        warn_idle(options, *scene, &v, &run);
    if (status == ROBERTS_OK)
        status = save_regions(options, &v, &run, &error);
    if (last && !needs_scene(options)) {
        roberts_scene_free(*scene);
        *scene = NULL;
    }
    if (status == ROBERTS_OK)
        set_window(&v.drawing[0], window);
    if (status == ROBERTS_OK)
        status = save(options, *scene, &v, &run, &error);
    run.total = report_since(run.begin);
    result->segments = count_segments(&v);
    result->contradictions += run.found.contradictions;
    if (status == ROBERTS_OK)
        tell(options, &run, &v);
    free_views(&v);
    if (status != ROBERTS_OK)
        return fail(options, &error, result);
    return run.found.contradictions > 0 ? EXIT_FAILED : EXIT_DONE; /* the drawing is still written, for inspection */
}

/* Joins parts and draws them. Titles and messages name their models in place of the inputs. */
static int draw_joined(const cli_options *given, run_stats run, picture_result *result)
{
    cli_options own = *given;
    roberts_error error = {0};
    roberts_joined joined;
    progress_stage("joining");
    if (part_join(given, &joined, &error) != ROBERTS_OK)
        return fail(given, &error, result);
    views v = {.drawing = {joined.drawing}, .count = 1};
    for (size_t i = 0; i < joined.input.count; i++)
        description_word(&own.description, joined.input.name[i]);
    own.input = joined.input.name;
    own.input_count = joined.input.count;
    warn_idle(&own, NULL, &v, &run);
    roberts_status status = save(&own, NULL, &v, &run, &error);
    run.total = report_since(run.begin);
    result->segments = count_segments(&v);
    int exit_status = status == ROBERTS_OK ? EXIT_DONE : fail(&own, &error, result);
    if (status == ROBERTS_OK)
        tell(&own, &run, &v);
    roberts_joined_free(&joined);
    return exit_status;
}

static roberts_camera turned(const cli_options *options, const roberts_scene *scene, uint32_t i)
{
    roberts_camera camera = options->camera;
    roberts_camera_turn(scene, 360.0 * i / options->turntable, &camera);
    return camera;
}

static roberts_status find_window(const cli_options *options, const roberts_scene *scene, picture_window *all,
                                  roberts_error *error)
{
    roberts_status status = ROBERTS_OK;
    for (uint32_t i = 0; i < options->turntable && status == ROBERTS_OK; i++) {
        picture_window one;
        roberts_camera camera = turned(options, scene, i);
        status = roberts_window(scene, &camera, &one.min, &one.max, &one.framed, error);
        if (status != ROBERTS_OK)
            break;
        if (i == 0)
            *all = one;
        all->framed = all->framed || one.framed;
        all->min = (roberts_vec2){fmin(all->min.x, one.min.x), fmin(all->min.y, one.min.y)};
        all->max = (roberts_vec2){fmax(all->max.x, one.max.x), fmax(all->max.y, one.max.y)};
    }
    return status;
}

static bool discard(void *context, const void *bytes, size_t size)
{
    (void)context, (void)bytes, (void)size;
    return true;
}

/* Finds the height of letters that labels get in the picture with the least room for them. All pictures of a turntable
 * get it: letters that change from picture to picture would flicker. */
static roberts_status find_letters(const cli_options *options, const roberts_scene *scene, const picture_window *window,
                                   double *least, roberts_error *error)
{
    roberts_ink ink = {0};
    roberts_draw_options page = options->draw;
    roberts_status status = ROBERTS_OK;
    page.format = ROBERTS_SVG; /* the fastest; letters have the same places in all formats */
    page.grouping = ROBERTS_GROUP_CLASS;
    page.order = ROBERTS_ORDER_NONE;
    page.fill = ROBERTS_FILL_NONE;
    page.hatch.off = true;
    page.real_dashes = false;
    page.ink = &ink;
    progress_stage("placing labels");
    for (uint32_t i = 0; i < options->turntable && status == ROBERTS_OK; i++) {
        cli_options one = *options;
        views v = {.count = 1};
        run_stats run = {0};
        one.camera = turned(options, scene, i);
        status = hide_and_count(&one, scene, &v.drawing[0], &v.regions[0], &run, error);
        set_window(&v.drawing[0], window);
        if (status == ROBERTS_OK)
            status = roberts_drawing_write(&v.drawing[0], &page, discard, NULL, error);
        if (ink.label_mm > 0.0 && (*least == 0.0 || ink.label_mm < *least))
            *least = ink.label_mm;
        free_views(&v);
    }
    return status == ROBERTS_BAD_ARGUMENT ? ROBERTS_OK : status; /* drawing will say why, and name the picture */
}

static int draw_turntable(const cli_options *options, roberts_scene **scene, run_stats run, picture_result *result)
{
    char name[NAME_SIZE];
    picture_window window = {0};
    roberts_error error = {0};
    double label_mm = options->draw.lettering.height_mm;
    int status = EXIT_DONE;
    if (find_window(options, *scene, &window, &error) != ROBERTS_OK ||
        (label_kinds(&options->draw) != 0 && label_mm == 0.0 &&
         find_letters(options, *scene, &window, &label_mm, &error) != ROBERTS_OK))
        return fail(options, &error, result);
    for (uint32_t i = 0; i < options->turntable && status == EXIT_DONE; i++) {
        cli_options one = *options;
        one.draw.lettering.height_mm = label_mm;
        one.camera = turned(options, *scene, i);
        one.label = name;
        if (parse_numbered(options->output, i, name, sizeof name))
            one.output = name;
        else /* the format null writes no file */
            snprintf(name, sizeof name, "picture %u", (unsigned)i);
        run.begin = report_now();
        status = draw(&one, scene, i + 1 == options->turntable, &window, run, result);
        progress_count(i + 1, options->turntable);
    }
    return status;
}

/* Enlarges the window of a picture until it holds the corners of all faces of `room`. */
static roberts_status add_room(const roberts_mesh *room, const roberts_scene *scene, const roberts_camera *camera,
                               picture_window *window, roberts_error *error)
{
    enum { TOGETHER = 256 };
    roberts_vec3 p[TOGETHER];
    roberts_status status = ROBERTS_OK;
    for (size_t i = 0, count; i < room->corner_count && status == ROBERTS_OK; i += count) {
        for (count = 0; count < TOGETHER && i + count < room->corner_count; count++)
            p[count] = room->vertex[room->corner[i + count]];
        status = roberts_project(scene, camera, p, count, p, error);
        for (size_t k = 0; k < count && status == ROBERTS_OK; k++) { /* fmin() and fmax() ignore NaN */
            window->min = (roberts_vec2){fmin(window->min.x, p[k].x), fmin(window->min.y, p[k].y)};
            window->max = (roberts_vec2){fmax(window->max.x, p[k].x), fmax(window->max.y, p[k].y)};
        }
    }
    return status;
}

/* Draws one picture, with room for more than it shows. */
static int draw_with_room(const cli_options *options, roberts_scene **scene, const roberts_mesh *room, run_stats run,
                          picture_result *result)
{
    picture_window window = {0};
    roberts_error error = {0};
    if (roberts_window(*scene, &options->camera, &window.min, &window.max, &window.framed, &error) != ROBERTS_OK)
        return fail(options, &error, result);
    if (window.framed && !options->quiet && options->camera.fov_degrees == 0.0)
        warn_of_inputs(options, "--room-for has no effect: the near plane cuts the scene close to the eye");
    if (!window.framed && add_room(room, *scene, &options->camera, &window, &error) != ROBERTS_OK)
        return fail(options, &error, result);
    return draw(options, scene, true, &window, run, result);
}

int picture_load(const cli_options *options, roberts_scene **scene)
{
    run_stats run = {0};
    picture_result result;
    roberts_error error = {0};
    *scene = NULL;
    return load(options, scene, &run, &error) == ROBERTS_OK ? EXIT_DONE : fail(options, &error, &result);
}

int picture_make(const cli_options *given, picture_result *result)
{
    cli_options own = *given;
    const cli_options *options = &own;
    name_list labels = {0};
    roberts_scene *scene = NULL;
    roberts_mesh room = {0};
    roberts_error error = {0};
    run_stats run = {.files = options->input_count, .begin = report_now()};
    int status;
    *result = (picture_result){0};
    if (own.names && (names_read(&labels, own.names, &error) != ROBERTS_OK ||
                      (own.join && names_check_part(&labels, own.names, &error) != ROBERTS_OK))) {
        hint_label(own.names, &error);
        names_free(&labels);
        return fail(options, &error, result);
    }
    if (own.names && labels.count == 0 && !own.batch) /* a batch would say so for each file */
        warn_of_file(options, own.names, "there are no names in it");
    own.draw.lettering.name = labels.item;
    own.draw.lettering.name_count = labels.count;
    if (options->join)
        status = draw_joined(options, run, result);
    else if (read_room(options, &room, &error) != ROBERTS_OK || load(options, &scene, &run, &error) != ROBERTS_OK)
        status = fail(options, &error, result);
    else if (options->turntable)
        status = draw_turntable(options, &scene, run, result);
    else if (options->room_count)
        status = draw_with_room(options, &scene, &room, run, result);
    else
        status = draw(options, &scene, true, NULL, run, result);
    roberts_scene_free(scene);
    roberts_mesh_free(&room);
    names_free(&labels);
    return status;
}
