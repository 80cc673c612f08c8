/* check.c - whether options make sense together.
 *
 * The rule: a command that would draw something other than what is meant, or lose a file, is misuse. An option that
 * changes nothing is only worth a warning, so that a script can give the same options to every run. The table of
 * options defines which options exclude or need each other; checks that depend on values and files are here. */
#include "cli/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/lists.h"
#include "cli/message.h"
#include "cli/parse.h"
#include "cli/values.h"

enum { NAME_SIZE = 4096, LIST_SIZE = 512 };

/* ---- misuse ---- */

static int check_margin(const cli_options *options)
{
    const roberts_page *page = &options->draw.page;
    if (2.0 * page->margin_mm < (page->width_mm < page->height_mm ? page->width_mm : page->height_mm))
        return EXIT_DONE;
    return message_misuse("--margin: %g mm leave no room on a page of %g x %g mm", page->margin_mm, page->width_mm,
                          page->height_mm);
}

static int check_turntable(const cli_options *options)
{
    static const char how[] = "--turntable needs a name with a place for the number: -o turn-%03d.svg";
    char name[NAME_SIZE];
    const char *place = strchr(options->output, '%');
    if (options->turntable == 0 || options->draw.format == ROBERTS_NULL ||
        parse_numbered(options->output, 0, name, sizeof name))
        return EXIT_DONE;
    if (!place)
        return message_misuse("%s", how);
    if (strchr(place + 1, '%'))
        return message_misuse("%s; \"%s\" has more than one %%", how, options->output);
    if (strlen(options->output) + 10 > sizeof name)
        return message_misuse("%s; this one is too long", how);
    return message_misuse("%s; \"%s\" has a %% of another kind", how, options->output);
}

static bool ends_like_model(const char *name)
{
    static const char *const endings[] = {".off", ".stl", ".obj", ".ply", ".mtl"};
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++)
        if (parse_has_ending(name, endings[i]))
            return true;
    return false;
}

/* If the folder behind --batch is forgotten, the first file is taken for it. */
static int check_batch(const cli_options *options)
{
    static const char how[] = "--batch DIR FILE..., or --batch DIR --list LIST";
    struct stat found;
    if (!options->batch)
        return EXIT_DONE;
    bool there = stat(options->batch, &found) == 0;
    if ((there && !S_ISDIR(found.st_mode)) || (!there && ends_like_model(options->batch)))
        return message_misuse("--batch: %s is %s, where the folder for the drawings should be: %s", options->batch,
                              there ? "a file" : "the name of a file", how);
    for (size_t i = 0; i < options->input_count; i++)
        if (strcmp(options->input[i], "-") == 0)
            return message_misuse("--batch needs names of files: %s", how);
    if (options->update && options->draw.format == ROBERTS_NULL)
        return message_misuse("--update compares files with their drawings, and -f null writes none");
    return EXIT_DONE;
}

/* A name that ends in a slash means a folder, whether it exists or not. check_turntable() checks the names of a
 * turntable. */
int check_folder(const cli_options *options)
{
    struct stat found;
    const char *name = options->output;
    const bool folder = stat(name, &found) == 0 ? S_ISDIR(found.st_mode) : name[strlen(name) - 1] == '/';
    if (!folder || strcmp(name, "-") == 0 || options->turntable || options->draw.format == ROBERTS_NULL)
        return EXIT_DONE;
    if (strcmp(options->input[0], "-") == 0)
        return message_misuse("--output: %s is a folder; name a file in it", name);
    return message_misuse("--output: %s is a folder; name a file in it, or draw each input by itself into it with "
                          "--batch %s",
                          name, name);
}

int check_format(const cli_options *options)
{
    const roberts_format format = options->draw.format;
    const bool is_binary = format == ROBERTS_PDF || format == ROBERTS_PNG;
    if (options->regions && strcmp(options->regions, "-") == 0 && strcmp(options->output, "-") == 0 &&
        format != ROBERTS_NULL)
        return message_misuse("--regions: the drawing goes to standard output: name a file, or write no drawing with "
                              "-f null");
    if (is_binary && !options->batch && strcmp(options->output, "-") == 0 && isatty(STDOUT_FILENO))
        return message_misuse("a terminal cannot show %s: name a file with -o", values_format_name(format));
    return EXIT_DONE;
}

/* Has the file this name? NULL has no file. */
static bool is_file_of(const char *name, const file_identity *file)
{
    file_identity found;
    return name && file_identify(name, &found) && file_identity_order(&found, file) == 0;
}

/* Do both names mean one file? A file that is not there yet is known by its folder and the last part of its name. */
static bool is_one_file(const char *a, const char *b)
{
    const char *const name[] = {a, b};
    char folder[NAME_SIZE];
    struct stat in[2];
    file_identity file;
    size_t length[2];
    if (file_identify(a, &file))
        return is_file_of(b, &file);
    for (int i = 0; i < 2; i++) {
        const char *slash = strrchr(name[i], '/');
        length[i] = slash ? (size_t)(slash - name[i]) + 1 : 0;
        snprintf(folder, sizeof folder, "%.*s.", (int)length[i], name[i]);
        if (stat(folder, &in[i]) != 0)
            return false;
    }
    return in[0].st_dev == in[1].st_dev && in[0].st_ino == in[1].st_ino && strcmp(a + length[0], b + length[1]) == 0;
}

/* The run will write a file. It must not replace one that it reads, nor any other model or its colours: a name behind
 * the wrong option costs the user a model. */
static int check_written(const cli_options *options, const char *by, const char *what, const char *name)
{
    file_identity written;
    const char *is = NULL;
    if (!name || !file_identify(name, &written))
        return EXIT_DONE;
    for (size_t i = 0; i < options->input_count && !is; i++)
        is = is_file_of(options->input[i], &written) ? "an input" : NULL;
    for (size_t i = 0; i < options->room_count && !is; i++)
        is = is_file_of(options->room[i], &written) ? "a file of --room-for" : NULL;
    if (!is && is_file_of(options->names, &written))
        is = "the file of --labels";
    if (!is && ends_like_model(name))
        is = "a model";
    return is ? message_misuse("--%s: %s is %s; %s would take its place", by, name, is, what) : EXIT_DONE;
}

/* Checks all files that the run will write, except those of --batch. */
static int check_outputs(const cli_options *options)
{
    char name[NAME_SIZE];
    int status = check_written(options, "regions", "the regions", options->regions);
    if (options->draw.format == ROBERTS_NULL || status != EXIT_DONE)
        return status;
    for (uint32_t i = 0; i < options->turntable && status == EXIT_DONE; i++)
        if (parse_numbered(options->output, i, name, sizeof name))
            status = check_written(options, "output", "the drawing", name);
    for (int i = 0; options->is_sheet && values_is_table(options->draw.format) && i < ROBERTS_SHEET_VIEWS; i++)
        if (status == EXIT_DONE &&
            parse_named(options->output, roberts_sheet_view_name(options->sheet, i), name, sizeof name))
            status = check_written(options, "output", "the table", name);
    if (status == EXIT_DONE && options->regions && strcmp(options->output, "-") != 0 &&
        is_one_file(options->output, options->regions))
        return message_misuse("--regions: %s is the file of the drawing, too", options->regions);
    return status == EXIT_DONE ? check_written(options, "output", "the drawing", options->output) : status;
}

/* A name meant for the drawing must not be read as a model. */
static int check_inputs(const cli_options *options, bool output_given)
{
    struct stat input;
    size_t streams = 0;
    for (size_t i = 0; i < options->input_count; i++) {
        roberts_format format;
        const char *name = options->input[i];
        if (!*name)
            return message_misuse("the name of an input is empty");
        if (strcmp(name, "-") == 0)
            streams++;
        else if (stat(name, &input) != 0 && !output_given && !options->batch && roberts_format_by_path(name, &format))
            return message_misuse("%s: there is no such file to read; to draw into it: -o %s", name, name);
    }
    if (options->names && strcmp(options->names, "-") == 0)
        return message_misuse("--labels: names cannot be read from standard input; a file called - is ./-");
    return streams > 1 ? message_misuse("standard input (-) can be read only once") : EXIT_DONE;
}

/* Refuses options, inputs and outputs that parts of a drawing cannot have. */
static int check_parts(const cli_options *options, const options_given *given)
{
    static const char *const whole[] = {"fill", "hatch"};
    const char *const name = options->plan ? "plan" : options->join ? "join" : "part";
    if (!options->plan && !options->join && !options->part.of)
        return EXIT_DONE;
    for (size_t i = 0; i < sizeof whole / sizeof whole[0]; i++)
        if (options_is_given(given, whole[i]))
            return message_misuse("--%s: --%s needs the whole scene: draw it in one run", name, whole[i]);
    if (options->draw.lettering.labels & ROBERTS_LABEL_AREAS)
        return message_misuse("--%s: labels of faces and bodies need the whole scene: draw it in one run", name);
    if (options->join && strcmp(options->input[0], "-") == 0)
        return message_misuse("--join needs the names of all parts: --join -o drawing.svg part-*");
    if (!options->join && strcmp(options->output, "-") == 0 && isatty(STDOUT_FILENO))
        return message_misuse("a terminal cannot show a %s: name a file with -o", name);
    return EXIT_DONE;
}

int check_options(const cli_options *options, const options_given *given)
{
    int status;
    if ((status = check_margin(options)) != EXIT_DONE || (status = check_turntable(options)) != EXIT_DONE ||
        (status = check_batch(options)) != EXIT_DONE || (status = check_parts(options, given)) != EXIT_DONE)
        return status;
    status = check_inputs(options, options_is_given(given, "output"));
    return status == EXIT_DONE ? check_outputs(options) : status;
}

/* ---- warnings ---- */

static void warn(const char *what, const char *why)
{
    fprintf(stderr, "roberts: warning: %s has no effect: %s\n", what, why);
}

static bool is_dashed(const roberts_pen *pen)
{
    return pen->dash_mm > 0.0 && !pen->off;
}

/* Warns about options with this flag: they do nothing, since this format `lacks` what they affect. */
static void warn_useless(const cli_options *options, const options_given *given, unsigned flag, const char *lacks)
{
    char list[LIST_SIZE];
    size_t found = 0, used = 0;
    for (size_t i = 0; i < given->table->count && used < LIST_SIZE; i++) {
        const option *o = &given->table->row[i];
        if (given->row[i] && (o->flags & flag))
            used += (size_t)snprintf(list + used, LIST_SIZE - used, "%s--%s", found++ ? ", " : "", o->name);
    }
    if (found > 0)
        fprintf(stderr, "roberts: warning: %s %s no effect: %s %s\n", list, found > 1 ? "have" : "has",
                values_format_name(options->draw.format), lacks);
}

static const char no_text[] =
    "there is no text without --label, --labels, --frame=zones, or --sheet with --title, --field or --dimensions";

static bool has_labels(const options_given *given)
{
    return options_is_given(given, "label") || options_is_given(given, "labels");
}

/* Of faces and bodies, only visible regions are labelled. A list of names may hold vertices. */
static bool has_hidden_labels(const cli_options *options, const options_given *given)
{
    const bool any = options->draw.lettering.labels & (ROBERTS_LABEL_VERTICES | ROBERTS_LABEL_EDGES);
    return options->draw.hidden != ROBERTS_HIDDEN_NONE && (any || options_is_given(given, "labels"));
}

static bool has_text(const cli_options *options, const options_given *given)
{
    return (options->draw.lettering.zones && !options->draw.frame.off) || has_labels(given) ||
           (options->is_sheet && options_is_given(given, "title")) || options_is_given(given, "field") ||
           options_is_given(given, "dimensions");
}

/* Why lines of a class are not on the page, or NULL. */
static const char *missing(const cli_options *options, const options_given *given, size_t pen)
{
    const roberts_draw_options *draw = &options->draw;
    if (pen == PEN_HIDDEN && draw->hidden == ROBERTS_HIDDEN_NONE)
        return "hidden lines are not drawn without --hidden dashed or solid";
    if (pen == PEN_FRAME && draw->frame.off && !options_is_given(given, "frame"))
        return "it is not drawn without --frame";
    if (pen == PEN_SYMBOL && !options->is_sheet)
        return "it is not drawn without --sheet";
    if (pen == PEN_HATCH && !draw->hatching.on)
        return "faces are not hatched without --hatch";
    if (pen == PEN_TEXT && !has_text(options, given))
        return no_text;
    if (pen == PEN_HIDDEN_TEXT && !has_hidden_labels(options, given))
        return "hidden things have labels only with --hidden, and --label vertices or edges, or --labels";
    return NULL;
}

/* Warns of a pen for lines that are missing, or that are off. hint_idle_pens() finds the classes that a drawing does
 * not have. */
static void warn_pen(const cli_options *options, const options_given *given, size_t pen)
{
    char what[64];
    const bool named = options->named_pens >> pen & 1; /* not by --style all */
    const char *why = missing(options, given, pen);
    const bool off = values_pen(&options->draw, pen)->off, set = values_pen_is_set(&options->draw, pen);
    const char *asked = pen == PEN_HIDDEN  ? "--hidden"
                        : pen == PEN_FRAME ? "--frame"
                        : pen == PEN_HATCH ? "--hatch"
                                           : NULL;
    snprintf(what, sizeof what, "%s--style %s", why ? "" : "the pen of ", values_pens[pen]);
    if (why && named && (set || (off && pen != PEN_FRAME)))
        warn(what, why);
    else if (!why && set && off && named)
        warn(what, "these lines are off");
    else if (!why && off && asked)
        warn(asked, "--style turns these lines off");
}

/* Is any line of the page drawn with dashes? */
static bool any_dashed(const roberts_draw_options *draw)
{
    bool any = draw->hidden == ROBERTS_HIDDEN_DASHED && is_dashed(&draw->back);
    for (size_t pen = 0; pen < PENS; pen++)
        any = any || (pen != PEN_HIDDEN && (pen < PEN_FRAME || (pen == PEN_HATCH && draw->hatching.on)) &&
                      is_dashed(values_pen(draw, pen)));
    return any;
}

/* Does any pen have another width than usual? */
static bool any_width_set(const roberts_draw_options *draw)
{
    const roberts_draw_options usual = roberts_draw_options_default();
    bool any = false;
    for (size_t pen = 0; pen < PENS; pen++)
        any = any || values_pen(draw, pen)->width_mm != values_pen(&usual, pen)->width_mm;
    return any;
}

/* Warns about options for page features that this format lacks. */
static void warn_lost(const cli_options *options)
{
    const roberts_draw_options *draw = &options->draw;
    if (draw->background.on && draw->format == ROBERTS_DXF)
        warn("--background", "dxf has no background");
    if (draw->background.on && draw->format == ROBERTS_HPGL)
        warn("--background", "hpgl has no background");
    if (draw->fill != ROBERTS_FILL_NONE && (draw->format == ROBERTS_DXF || draw->format == ROBERTS_HPGL))
        warn("--fill", draw->format == ROBERTS_DXF ? "dxf has no filled areas" : "pens cannot fill");
    if (draw->format == ROBERTS_DXF && any_width_set(draw))
        warn("the width of a pen", "dxf has no widths of lines");
}

/* Does the file have the number of this pen? Layers of views and bodies have numbers of their own. */
static bool has_pen_number(const cli_options *options, size_t pen)
{
    const roberts_draw_options *draw = &options->draw;
    const bool beside = pen == PEN_FRAME || pen == PEN_SYMBOL || pen == PEN_TEXT || pen == PEN_HIDDEN_TEXT;
    const bool by_class =
        draw->grouping == ROBERTS_GROUP_CLASS || (draw->grouping == ROBERTS_GROUP_ELEMENT && !options->is_sheet);
    return draw->format == ROBERTS_HPGL || (draw->format == ROBERTS_SVG && draw->number_layers && (beside || by_class));
}

static void warn_pages(const cli_options *options, const options_given *given)
{
    const roberts_draw_options *draw = &options->draw;
    warn_lost(options);
    if (options_is_given(given, "light") && !draw->shaded && (!draw->hatching.on || draw->hatching.sections))
        warn("--light", draw->hatching.on ? "sections are hatched in one tone"
                                          : "nothing is shaded without --fill shade or --hatch");
    for (size_t pen = 0; pen < PENS; pen++)
        if (values_pen(draw, pen)->number && !has_pen_number(options, pen)) {
            warn("pen= of --style", "only pens of hpgl and numbered layers of classes in svg have numbers");
            break;
        }
    if (options_is_given(given, "align") && draw->crop)
        warn("--align", "--crop leaves no room to move in");
    if (options_is_given(given, "room-for") && options_is_given(given, "fov"))
        warn("--room-for", "--fov says what the picture holds");
    if (options_is_given(given, "landscape") && draw->page.width_mm == draw->page.height_mm)
        warn("--landscape", "the page is square");
    if (options_is_given(given, "layers") && draw->format != ROBERTS_SVG)
        warn("--layers", "only layers of svg are numbered");
    if (options_is_given(given, "group") && draw->format != ROBERTS_SVG)
        warn("--group", "only svg has groups");
    if (options_is_given(given, "id-prefix") && draw->format != ROBERTS_SVG)
        warn("--id-prefix", "only svg has ids");
    if (options_is_given(given, "title") && !options->is_sheet && draw->format != ROBERTS_SVG &&
        draw->format != ROBERTS_TIKZ)
        warn("--title", "only svg, tikz and sheets have a title");
    if (options_is_given(given, "description") && draw->format != ROBERTS_SVG && draw->format != ROBERTS_TIKZ)
        warn("--description", "only svg and tikz have a description");
    if (options_is_given(given, "text") && !has_text(options, given))
        warn("--text", no_text);
    if (options_is_given(given, "label-size") && !has_labels(given) && !options_is_given(given, "dimensions"))
        warn("--label-size", "there are no labels without --label or --labels, and no --dimensions");
    if (has_text(options, given) && values_pen(draw, PEN_TEXT)->off)
        warn("text", "--style text:off leaves it out");
    if (draw->lettering.native && !roberts_format_has_text(draw->format))
        warn("--text native", "only svg, pdf, tikz and dxf can hold text itself");
    if (options_is_given(given, "dpi") && draw->format != ROBERTS_PNG)
        warn("--dpi", "only png has a resolution");
    if (options_is_given(given, "plotter") && draw->format != ROBERTS_HPGL)
        warn("--plotter", "only hpgl has a plotter's origin");
    const bool to_scale = draw->placement.standard || options_is_given(given, "scale");
    if (options_is_given(given, "unit") && !to_scale && !options_is_given(given, "dimensions"))
        warn("--unit", "the drawing is fitted on the page, and not true to --scale");
    for (size_t pen = 0; pen < PENS; pen++)
        warn_pen(options, given, pen);
    const roberts_pen *back = &draw->back;
    if (draw->hidden == ROBERTS_HIDDEN_SOLID && is_dashed(back) &&
        (back->dash_mm != 12.0 * back->width_mm || back->gap_mm != 3.0 * back->width_mm))
        warn("dash= of --style hidden", "--hidden solid draws these lines without dashes");
    if (draw->real_dashes && !any_dashed(draw))
        warn("--dash real", "no lines are dashed, as by --hidden dashed");
}

/* An ending that names something else than what the file will be misleads whoever opens it. */
static void warn_ending(const char *name, const char *but)
{
    char text[120];
    roberts_format told;
    if (ends_like_model(name))
        snprintf(text, sizeof text, "its ending says that it is a model, but %s", but);
    else if (roberts_format_by_path(name, &told))
        snprintf(text, sizeof text, "its ending says %s, but %s", values_format_name(told), but);
    else
        return;
    message_warning(stderr, name, 0, text);
}

/* The ending of the output's name may differ from --format. */
static void warn_format(const cli_options *options)
{
    char but[60];
    roberts_format told;
    const roberts_format written = options->draw.format;
    if (written == ROBERTS_NULL || (roberts_format_by_path(options->output, &told) && told == written))
        return;
    snprintf(but, sizeof but, "it is %s, as --format says", values_format_name(written));
    warn_ending(options->output, but);
}

/* Regions are JSON, unless the name ends in .csv. */
static void warn_regions(const cli_options *options)
{
    const char *name = options->regions, *slash = name ? strrchr(name, '/') : NULL;
    roberts_format told;
    if (!name || (roberts_format_by_path(name, &told) && values_is_table(told)))
        return;
    if (roberts_format_by_path(name, &told) || ends_like_model(name))
        warn_ending(name, "regions are written as json");
    else if (strchr(slash ? slash : name, '.'))
        message_warning(stderr, name, 0, "no format has this ending; regions are written as json");
}

/* Warns of --merge-regions if nothing shows its regions. Plain fills of a class are joined by colour anyway, but with
 * --union a region of several bodies has the colour of one. Labels from a file may be those of faces. */
static void warn_merged(const cli_options *options)
{
    const roberts_draw_options *draw = &options->draw;
    const bool labels = options->names || (draw->lettering.labels & ROBERTS_LABEL_AREAS);
    const bool fills = values_has_page(draw->format) && draw->fill != ROBERTS_FILL_NONE;
    const bool grouped = draw->format == ROBERTS_SVG && draw->grouping != ROBERTS_GROUP_CLASS;
    const bool bodies = options->hide.unite && draw->fill == ROBERTS_FILL_BODY;
    if (options->regions || (values_has_page(draw->format) && (labels || values_hatches(draw))) ||
        (fills && (grouped || bodies || draw->shaded)))
        return;
    warn("--merge-regions", fills ? "fills of one colour are joined anyway"
                                  : "there are no regions without --regions, --fill, --hatch or labels of faces");
}

/* A name with a place for a number without a turntable, or for a view without tables of a sheet: a file may have such a
 * name, but it is probably a mistake. */
static void warn_place(const cli_options *options)
{
    char name[NAME_SIZE];
    const bool views = options->is_sheet && values_is_table(options->draw.format);
    const char *why = NULL;
    if (options->turntable > 0 || options->draw.format == ROBERTS_NULL)
        return;
    if (parse_numbered(options->output, 0, name, sizeof name))
        why = "the file gets this very name: only --turntable puts a number there";
    else if (parse_named(options->output, "", name, sizeof name) && !views)
        why = "the file gets this very name: only tables of --sheet have the name of a view there";
    else if (views && strstr(options->output, "%s") && !parse_named(options->output, "", name, sizeof name))
        why = "the file gets this very name: %s, for the name of a view, may stand there once, without another %";
    if (why)
        message_warning(stderr, options->output, 0, why);
}

/* The vector over its length, which may be too large for a square. */
static roberts_vec3 over_length(roberts_vec3 v)
{
    const double most = fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
    v = (roberts_vec3){v.x / most, v.y / most, v.z / most};
    const double length = sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return (roberts_vec3){v.x / length, v.y / length, v.z / length};
}

/* The sine of an angle at which `up` counts as parallel to the line of sight, as in the library. */
static const double parallel = 1e-9;

/* Warns of an --up along the line of sight, which something else replaces. An eye without --look-at looks at the
 * centre of the scene, which is not known yet. */
static void warn_up(const cli_options *options)
{
    const roberts_camera *camera = &options->camera;
    const roberts_vec3 eye = camera->eye, at = camera->look_at;
    roberts_vec3 dir = camera->dir;
    if (camera->projection == ROBERTS_PERSPECTIVE) {
        if (!camera->has_look_at)
            return;
        dir = (roberts_vec3){eye.x - at.x, eye.y - at.y, eye.z - at.z};
    }
    const roberts_vec3 u = over_length(camera->up), d = over_length(dir);
    if (hypot(hypot(d.y * u.z - d.z * u.y, d.z * u.x - d.x * u.z), d.x * u.y - d.y * u.x) <= parallel)
        warn("--up", "it is parallel to the view");
}

/* A pen wider than this fraction of the page's shorter side is probably a mistake. */
static const double widest_part = 0.1;

/* Warns of pens that would cover much of the page. */
static void warn_wide(const cli_options *options)
{
    const roberts_page *page = &options->draw.page;
    const double side = page->width_mm < page->height_mm ? page->width_mm : page->height_mm;
    bool told = false; /* of --style all */
    for (size_t i = 0; i < PENS; i++) {
        const roberts_pen *pen = values_pen(&options->draw, i);
        const bool named = options->named_pens >> i & 1;
        if (pen->off || !values_pen_is_set(&options->draw, i) || pen->width_mm <= widest_part * side ||
            (told && !named))
            continue;
        fprintf(stderr, "roberts: warning: --style %s: a pen of %g mm is very wide for a page of %g x %g mm\n",
                values_pens[named ? i : PENS], pen->width_mm, page->width_mm, page->height_mm);
        told = told || !named;
    }
}

/* Warns if part of a frame's line lies beyond the page. At a given scale, the frame of a field of view may be far from
 * the margins. */
static void warn_cut_frame(const cli_options *options)
{
    const roberts_draw_options *draw = &options->draw;
    const double half = draw->frame.width_mm / 2.0;
    if (!draw->frame.off && draw->placement.scale == 0.0 && draw->page.margin_mm < half)
        fprintf(stderr,
                "roberts: warning: --margin %g cuts off part of the frame's line; --margin %g leaves it whole\n",
                draw->page.margin_mm, half);
}

/* Warns of hatching that leaves no paper between its strokes. */
static void warn_dense(const cli_options *options)
{
    const roberts_draw_options *draw = &options->draw;
    const roberts_hatching *h = &draw->hatching;
    const double part = h->cross > 0.5 ? h->cross : 1.0 - h->cross; /* of the strokes, in the commoner direction */
    if (values_hatches(draw) && draw->hatch.width_mm * part >= h->spacing_mm)
        fprintf(stderr, "roberts: warning: --hatch: strokes of %g mm, %g mm apart, cover the darkest faces wholly\n",
                draw->hatch.width_mm, draw->hatching.spacing_mm);
}

/* An input, and which file it is. */
typedef struct input_identity {
    file_identity file;
    size_t index;
} input_identity;

/* Files named twice follow one another, in the order of their names. */
static int by_file(const void *a, const void *b)
{
    const input_identity *p = a, *q = b;
    int order = file_identity_order(&p->file, &q->file);
    return order ? order : (p->index > q->index) - (p->index < q->index);
}

/* Warns if two names lead to one file: each of its bodies would be drawn twice, in the same place. Only the first such
 * file is named. --batch itself warns of a name that is there twice. */
static void warn_twice(const cli_options *options)
{
    input_identity *list = options->input_count > 1 ? calloc(options->input_count, sizeof *list) : NULL;
    const char *twice = NULL;
    size_t count = 0;
    if (!list)
        return; /* without memory, the run will fail anyway */
    for (size_t i = 0; i < options->input_count; i++) {
        list[count].index = i;
        if (file_identify(options->input[i], &list[count].file))
            count++;
    }
    qsort(list, count, sizeof *list, by_file);
    const bool told = options->batch && options->draw.format != ROBERTS_NULL;
    for (size_t i = 1; i < count && !twice; i++)
        if (file_identity_order(&list[i - 1].file, &list[i].file) == 0 &&
            !(told && strcmp(options->input[list[i - 1].index], options->input[list[i].index]) == 0))
            twice = options->input[list[i].index];
    if (twice)
        message_warning(stderr, twice, 0,
                        options->batch || options->join ? "this file is named twice"
                                                        : "this file is named twice, and is drawn twice");
    free(list);
}

void check_warn(const cli_options *options, const options_given *given)
{
    if (options->quiet)
        return;
    if (options->plan || options->part.of) {
        warn_ending(options->output,
                    options->plan ? "it is a plan, for --part" : "it is a part of a drawing, for --join");
        return; /* the rest is warned of when the parts are joined */
    }
    if (options->draw.format == ROBERTS_NULL && options_is_given(given, "output"))
        warn("--output", "the format null writes nothing");
    if (options_is_given(given, "format"))
        warn_format(options);
    warn_regions(options);
    if (options->hide.merge_regions)
        warn_merged(options);
    warn_place(options);
    warn_twice(options);
    if (options_is_given(given, "up"))
        warn_up(options);
    if (values_has_page(options->draw.format)) {
        warn_pages(options, given);
        warn_wide(options);
        warn_cut_frame(options);
        warn_dense(options);
    } else {
        warn_useless(options, given, OPTION_PAPER, "has no page");
    }
    if (!values_is_table(options->draw.format))
        warn_useless(options, given, OPTION_TABLE, "is no table");
    else if (options->hide.levels && options->draw.hidden == ROBERTS_HIDDEN_NONE)
        warn("--columns +level", "it is 0 in visible rows, and there are no others without --hidden");
    if (values_is_table(options->draw.format) && values_has_column(&options->draw, ROBERTS_COLUMN_BY) &&
        options->draw.hidden == ROBERTS_HIDDEN_NONE)
        warn("--columns +by", "it is empty in visible rows, and there are no others without --hidden");
    if (isatty(STDIN_FILENO) && strcmp(options->input[0], "-") == 0)
        fputs(
            "roberts: reading the model from the terminal; ctrl-D ends it (roberts --help tells how to name a file)\n",
            stderr);
}
