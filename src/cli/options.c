/* options.c - the command line as a plain struct.
 *
 * GNU habits without GNU functions: --name=value and --name value, -ovalue and -o value, -qo value, operands anywhere,
 * everything after -- is an operand. A value may begin with a minus (--dir -1,2,3). Of an option given twice the last
 * counts; options that contradict each other are misuse. */
#include "cli/options.h"

#include <float.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "cli/message.h"
#include "cli/nearest.h"
#include "cli/paper.h"
#include "cli/parse.h"
#include "cli/sense.h"
#include "cli/values.h"

typedef enum option_id {
    OPTION_OUTPUT,
    OPTION_FORMAT,
    OPTION_DIR,
    OPTION_VIEW,
    OPTION_EYE,
    OPTION_LOOK_AT,
    OPTION_NEAR,
    OPTION_FOV,
    OPTION_UP,
    OPTION_AZIMUTH,
    OPTION_ELEVATION,
    OPTION_ROLL,
    OPTION_HIDDEN,
    OPTION_CREASE,
    OPTION_ALL_EDGES,
    OPTION_PAGE,
    OPTION_LANDSCAPE,
    OPTION_MARGIN,
    OPTION_FIT,
    OPTION_SCALE,
    OPTION_UNIT,
    OPTION_ALIGN,
    OPTION_FRAME,
    OPTION_BACKGROUND,
    OPTION_STYLE,
    OPTION_DASH,
    OPTION_ORDER,
    OPTION_DPI,
    OPTION_STATS,
    OPTION_VERIFY,
    OPTION_PICK,
    OPTION_QUIET,
    OPTION_VERBOSE,
    OPTION_BATCH,
    OPTION_TURNTABLE,
    OPTION_SHEET,
    OPTION_HULL,
    OPTION_SOLIDS,
    OPTION_FILL_RULE,
    OPTION_THREADS,
    OPTION_GRID,
    OPTION_EPSILON,
    OPTION_TOLERANCE,
    OPTION_HELP,
    OPTION_VERSION,
    OPTION_COUNT
} option_id;

typedef enum value_kind { NO_VALUE, VALUE, VALUE_OPTIONAL /* only as --name=value */ } value_kind;

static const struct option {
    const char *name;
    char letter; /* 0: none */
    value_kind value;
} option_table[OPTION_COUNT] = {
    [OPTION_OUTPUT] = {"output", 'o', VALUE},
    [OPTION_FORMAT] = {"format", 'f', VALUE},
    [OPTION_DIR] = {"dir", 0, VALUE},
    [OPTION_VIEW] = {"view", 0, VALUE},
    [OPTION_EYE] = {"eye", 0, VALUE},
    [OPTION_LOOK_AT] = {"look-at", 0, VALUE},
    [OPTION_NEAR] = {"near", 0, VALUE},
    [OPTION_FOV] = {"fov", 0, VALUE},
    [OPTION_UP] = {"up", 0, VALUE},
    [OPTION_AZIMUTH] = {"azimuth", 0, VALUE},
    [OPTION_ELEVATION] = {"elevation", 0, VALUE},
    [OPTION_ROLL] = {"roll", 0, VALUE},
    [OPTION_HIDDEN] = {"hidden", 0, VALUE},
    [OPTION_CREASE] = {"crease", 0, VALUE},
    [OPTION_ALL_EDGES] = {"all-edges", 0, NO_VALUE},
    [OPTION_PAGE] = {"page", 0, VALUE},
    [OPTION_LANDSCAPE] = {"landscape", 0, NO_VALUE},
    [OPTION_MARGIN] = {"margin", 0, VALUE},
    [OPTION_FIT] = {"fit", 0, NO_VALUE},
    [OPTION_SCALE] = {"scale", 0, VALUE},
    [OPTION_UNIT] = {"unit", 0, VALUE},
    [OPTION_ALIGN] = {"align", 0, VALUE},
    [OPTION_FRAME] = {"frame", 0, NO_VALUE},
    [OPTION_BACKGROUND] = {"background", 0, VALUE},
    [OPTION_STYLE] = {"style", 0, VALUE},
    [OPTION_DASH] = {"dash", 0, VALUE},
    [OPTION_ORDER] = {"order", 0, VALUE},
    [OPTION_DPI] = {"dpi", 0, VALUE},
    [OPTION_STATS] = {"stats", 0, VALUE_OPTIONAL},
    [OPTION_VERIFY] = {"verify", 0, VALUE_OPTIONAL},
    [OPTION_PICK] = {"pick", 0, VALUE},
    [OPTION_QUIET] = {"quiet", 'q', NO_VALUE},
    [OPTION_VERBOSE] = {"verbose", 'v', NO_VALUE},
    [OPTION_BATCH] = {"batch", 0, VALUE},
    [OPTION_TURNTABLE] = {"turntable", 0, VALUE},
    [OPTION_SHEET] = {"sheet", 0, VALUE},
    [OPTION_HULL] = {"hull", 0, NO_VALUE},
    [OPTION_SOLIDS] = {"solids", 0, NO_VALUE},
    [OPTION_FILL_RULE] = {"fill-rule", 0, VALUE},
    [OPTION_THREADS] = {"threads", 0, VALUE},
    [OPTION_GRID] = {"grid", 0, VALUE},
    [OPTION_EPSILON] = {"epsilon", 0, VALUE},
    [OPTION_TOLERANCE] = {"tolerance", 0, VALUE},
    [OPTION_HELP] = {"help", 'h', NO_VALUE},
    [OPTION_VERSION] = {"version", 'V', NO_VALUE},
};

/* Options that leave no sense together. */
static const option_id conflict[][2] = {
    {OPTION_DIR, OPTION_VIEW},        {OPTION_DIR, OPTION_EYE},        {OPTION_VIEW, OPTION_EYE},
    {OPTION_DIR, OPTION_LOOK_AT},     {OPTION_VIEW, OPTION_LOOK_AT},   {OPTION_CREASE, OPTION_ALL_EDGES},
    {OPTION_AZIMUTH, OPTION_DIR},     {OPTION_AZIMUTH, OPTION_VIEW},   {OPTION_AZIMUTH, OPTION_EYE},
    {OPTION_ELEVATION, OPTION_DIR},   {OPTION_ELEVATION, OPTION_VIEW}, {OPTION_ELEVATION, OPTION_EYE},
    {OPTION_FIT, OPTION_SCALE},       {OPTION_QUIET, OPTION_VERBOSE},  {OPTION_BATCH, OPTION_OUTPUT},
    {OPTION_BATCH, OPTION_TURNTABLE}, {OPTION_SHEET, OPTION_VIEW},     {OPTION_SHEET, OPTION_DIR},
    {OPTION_SHEET, OPTION_EYE},       {OPTION_SHEET, OPTION_AZIMUTH},  {OPTION_SHEET, OPTION_ELEVATION},
    {OPTION_SHEET, OPTION_UP},        {OPTION_SHEET, OPTION_ROLL},     {OPTION_SHEET, OPTION_TURNTABLE},
    {OPTION_SHEET, OPTION_PICK},      {OPTION_HULL, OPTION_SOLIDS},
};

typedef struct parser {
    cli_options *options;
    bool given[OPTION_COUNT];
    roberts_vec3 up;
    double azimuth, elevation, roll; /* degrees */
} parser;

/* ---- one option ---- */

static int apply_value(parser *p, option_id id, const char *value)
{
    cli_options *options = p->options;
    const char *name = option_table[id].name;
    p->given[id] = true;
    switch (id) {
    case OPTION_OUTPUT:
        options->output = value;
        return *value ? EXIT_DONE : message_misuse("--output: the name is empty");
    case OPTION_FORMAT:
        return values_set_format(options, value);
    case OPTION_DIR:
        options->camera.projection = ROBERTS_ORTHOGRAPHIC;
        return values_set_direction(name, value, &options->camera.dir);
    case OPTION_VIEW:
        return values_set_view(options, value);
    case OPTION_EYE:
        options->camera.projection = ROBERTS_PERSPECTIVE;
        return values_set_vector(name, value, &options->camera.eye);
    case OPTION_LOOK_AT:
        options->camera.has_look_at = true;
        return values_set_vector(name, value, &options->camera.look_at);
    case OPTION_NEAR:
        return values_set_number(name, value, DBL_MAX, &options->camera.near_distance);
    case OPTION_FOV:
        return values_set_angle_of_view(value, &options->camera.fov_degrees);
    case OPTION_UP:
        return values_set_direction(name, value, &p->up);
    case OPTION_AZIMUTH:
        return values_set_number_between(name, value, -360.0, 360.0, &p->azimuth);
    case OPTION_ELEVATION:
        return values_set_number_between(name, value, -90.0, 90.0, &p->elevation);
    case OPTION_ROLL:
        return values_set_number_between(name, value, -360.0, 360.0, &p->roll);
    case OPTION_HIDDEN:
        return values_set_hidden(options, value);
    case OPTION_CREASE:
        options->hide.crease_auto = strcmp(value, "auto") == 0;
        return options->hide.crease_auto ? EXIT_DONE
                                         : values_set_number(name, value, 180.0, &options->hide.crease_degrees);
    case OPTION_ALL_EDGES:
        options->hide.all_edges = true;
        return EXIT_DONE;
    case OPTION_PAGE:
        return paper_set_page(&options->draw.page, value);
    case OPTION_MARGIN:
        return values_set_length(name, value, 20000.0, &options->draw.page.margin_mm);
    case OPTION_LANDSCAPE: /* whatever order it and --page come in */
    case OPTION_FIT:
        return EXIT_DONE;
    case OPTION_SCALE:
        return paper_set_scale(&options->draw.placement, value);
    case OPTION_UNIT:
        return paper_set_unit(&options->draw.placement, value);
    case OPTION_ALIGN:
        return paper_set_align(&options->draw.placement, value);
    case OPTION_FRAME:
        options->draw.frame.off = false;
        return EXIT_DONE;
    case OPTION_BACKGROUND:
        return paper_set_background(&options->draw.background, value);
    case OPTION_STYLE:
        return paper_set_style(&options->draw, value);
    case OPTION_DASH:
        return paper_set_dash(&options->draw, value);
    case OPTION_ORDER:
        return paper_set_order(&options->draw, value);
    case OPTION_DPI:
        return values_set_resolution(value, &options->draw.dpi);
    case OPTION_STATS:
        return values_set_stats(options, value);
    case OPTION_VERIFY:
        options->verify = true;
        return value ? values_set_rays(value, &options->verify_rays) : EXIT_DONE;
    case OPTION_PICK:
        return values_add_pick(options, value);
    case OPTION_QUIET:
        options->quiet = true;
        return EXIT_DONE;
    case OPTION_VERBOSE:
        options->verbose = true;
        return EXIT_DONE;
    case OPTION_BATCH:
        options->batch = value;
        return *value ? EXIT_DONE : message_misuse("--batch: the name is empty");
    case OPTION_TURNTABLE:
        return values_set_turntable(value, &options->turntable);
    case OPTION_SHEET:
        return values_set_sheet(options, value);
    case OPTION_HULL:
        options->scene.hull = true;
        return EXIT_DONE;
    case OPTION_SOLIDS:
        options->scene.solids = true;
        return EXIT_DONE;
    case OPTION_FILL_RULE:
        return values_set_fill_rule(options, value);
    case OPTION_THREADS:
        return values_set_integer(name, value, 0, ROBERTS_THREADS_MOST, &options->hide.threads);
    case OPTION_GRID:
        return values_set_integer(name, value, 0, ROBERTS_GRID_MOST, &options->hide.grid);
    case OPTION_EPSILON:
        return values_set_number(name, value, 1e150, &options->hide.epsilon);
    case OPTION_TOLERANCE:
        return values_set_number(name, value, 1.0, &options->scene.tolerance);
    case OPTION_HELP:
        options->help = true;
        return EXIT_DONE;
    case OPTION_VERSION:
        options->version = true;
        return EXIT_DONE;
    case OPTION_COUNT:
        break;
    }
    return message_misuse("--%s is unknown", name);
}

/* Whether an option changes what is drawn: the others are no part of a drawing's description, which does not depend on
 * where it is written to and what is computed how. */
static bool is_described(option_id id)
{
    switch (id) {
    case OPTION_OUTPUT:
    case OPTION_FORMAT:
    case OPTION_DPI:
    case OPTION_STATS:
    case OPTION_VERIFY:
    case OPTION_PICK:
    case OPTION_QUIET:
    case OPTION_VERBOSE:
    case OPTION_BATCH: /* each drawing is as if made by itself */
    case OPTION_THREADS:
    case OPTION_GRID:
    case OPTION_EPSILON:
    case OPTION_TOLERANCE:
    case OPTION_HELP:
    case OPTION_VERSION:
        return false;
    default:
        return true;
    }
}

static int apply(parser *p, option_id id, const char *value)
{
    int status = apply_value(p, id, value);
    if (status == EXIT_DONE && is_described(id))
        description_option(&p->options->description, option_table[id].name, value);
    return status;
}

/* The option called `name`, or OPTION_COUNT. */
static option_id find_option(const char *name, size_t length)
{
    int id = 0;
    while (id < OPTION_COUNT &&
           !(strlen(option_table[id].name) == length && strncmp(option_table[id].name, name, length) == 0))
        id++;
    return (option_id)id;
}

/* The option that was meant: one of like letters, one that is called otherwise elsewhere, or the value of one. */
static int unknown_option(const char *name)
{
    const char *words[OPTION_COUNT], *meant = nearest_option(name);
    roberts_camera camera;
    roberts_format format;
    for (int i = 0; i < OPTION_COUNT; i++)
        words[i] = option_table[i].name;
    if (!meant)
        meant = nearest_word(name, words, OPTION_COUNT);
    if (meant)
        return message_misuse("--%s is unknown; did you mean --%s?", name, meant);
    if (roberts_camera_preset(name, &camera))
        return message_misuse("--%s is unknown; did you mean --view %s?", name, name);
    if (roberts_format_by_name(name, &format))
        return message_misuse("--%s is unknown; did you mean -f %s?", name, name);
    return message_misuse("--%s is unknown", name);
}

/* argv[*i] is --name or --name=value; `*i` moves to the last argument that is used. */
static int take_long(parser *p, int argc, char **argv, int *i)
{
    const char *name = argv[*i] + 2, *equals = strchr(name, '=');
    size_t length = equals ? (size_t)(equals - name) : strlen(name);
    const char *value = equals ? equals + 1 : NULL;
    option_id id = find_option(name, length);
    if (id == OPTION_COUNT) {
        char word[64];
        snprintf(word, sizeof word, "%.*s", length < sizeof word ? (int)length : (int)sizeof word - 1, name);
        return unknown_option(word);
    }
    if (value && option_table[id].value == NO_VALUE)
        return message_misuse("--%s takes no value", option_table[id].name);
    if (!value && option_table[id].value == VALUE) {
        if (*i + 1 >= argc)
            return message_misuse("--%s needs a value", option_table[id].name);
        value = argv[++*i];
    }
    return apply(p, id, value);
}

/* argv[*i] is -x, -xyz or -xvalue; as above. One minus before a long name is a slip, which else might name a file. */
static int take_short(parser *p, int argc, char **argv, int *i)
{
    const char *word = argv[*i] + 1;
    if (word[1] && find_option(word, strcspn(word, "=")) != OPTION_COUNT)
        return message_misuse("-%s is unknown; did you mean --%s?", word, word);
    for (const char *letter = argv[*i] + 1; *letter; letter++) {
        int id = 0, status;
        while (id < OPTION_COUNT && option_table[id].letter != *letter)
            id++;
        if (id == OPTION_COUNT)
            return message_misuse("-%c is unknown", *letter);
        if (option_table[id].value == NO_VALUE) {
            if ((status = apply(p, (option_id)id, NULL)) != EXIT_DONE)
                return status;
            continue;
        }
        if (letter[1])
            return apply(p, (option_id)id, letter + 1);
        if (*i + 1 >= argc)
            return message_misuse("-%c needs a value", *letter);
        return apply(p, (option_id)id, argv[++*i]);
    }
    return EXIT_DONE;
}

/* An operand that was meant as the value of the option before it, which takes one only behind "=". */
static int misplaced_value(const char *option, const char *operand)
{
    uint32_t number;
    bool meant = (strcmp(option, "--stats") == 0 && strcmp(operand, "json") == 0) ||
                 (strcmp(option, "--verify") == 0 && parse_integer(operand, &number));
    if (!meant || access(operand, F_OK) == 0)
        return EXIT_DONE;
    return message_misuse("%s: there is no such file; did you mean %s=%s?", operand, option, operand);
}

/* ---- all together ---- */

static int check_conflicts(const parser *p)
{
    for (size_t i = 0; i < sizeof conflict / sizeof conflict[0]; i++)
        if (p->given[conflict[i][0]] && p->given[conflict[i][1]])
            return message_misuse("--%s and --%s exclude each other", option_table[conflict[i][0]].name,
                                  option_table[conflict[i][1]].name);
    return EXIT_DONE;
}

/* The format, where -f has not told it: by the ending of the output's name; SVG where that has none. */
static int choose_format(const parser *p)
{
    cli_options *options = p->options;
    const char *slash = strrchr(options->output, '/'), *name = slash ? slash + 1 : options->output;
    if (!p->given[OPTION_FORMAT] && !roberts_format_by_path(options->output, &options->draw.format) &&
        strchr(name + (*name == '.'), '.'))
        return message_misuse("%s: no format is known by this ending, as by .svg, .pdf, .ps, .eps, .png, .csv or "
                              ".json; say which with -f",
                              options->output);
    bool is_table = options->draw.format == ROBERTS_CSV || options->draw.format == ROBERTS_JSON;
    if (options->is_sheet && is_table)
        return message_misuse("--sheet makes a page, not a table: choose another format than %s",
                              values_format_name(options->draw.format));
    bool binary = options->draw.format == ROBERTS_PDF || options->draw.format == ROBERTS_PNG;
    if (binary && !options->batch && strcmp(options->output, "-") == 0 && isatty(STDOUT_FILENO))
        return message_misuse("these bytes are not for a terminal: name a file with -o");
    return EXIT_DONE;
}

/* What several options make of the camera, in whatever order they came. */
static void set_camera(const parser *p)
{
    roberts_camera *camera = &p->options->camera;
    if (p->given[OPTION_AZIMUTH] || p->given[OPTION_ELEVATION])
        roberts_camera_angles(p->azimuth, p->elevation, 0.0, camera);
    if (p->given[OPTION_UP])
        camera->up = p->up;
    camera->roll_degrees = p->roll;
}

/* Names of the options that were given, in the order of the table; how many there are. */
static size_t list_given(const parser *p, const char *names[OPTION_COUNT])
{
    size_t count = 0;
    for (int i = 0; i < OPTION_COUNT; i++)
        if (p->given[i])
            names[count++] = option_table[i].name;
    return count;
}

static void lay_down(roberts_page *page)
{
    if (page->width_mm < page->height_mm) {
        double width = page->width_mm;
        page->width_mm = page->height_mm;
        page->height_mm = width;
    }
}

/* Pictures of a turntable are not drawn again without a name that has a place for their numbers; its folder is left out. */
static void describe_numbered(cli_options *options)
{
    const char *slash = strrchr(options->output, '/');
    if (options->turntable)
        description_option(&options->description, option_table[OPTION_OUTPUT].name,
                           slash ? slash + 1 : options->output);
}

int options_parse(int argc, char **argv, cli_options *options)
{
    static char standard_input[] = "-";
    static char *nothing_named[] = {standard_input};
    parser p = {.options = options};
    int status, operands = 0; /* operands so far, moved to argv[0] .. */
    bool only_operands = false;
    *options =
        (cli_options){.output = "-", .hide = roberts_hide_options_default(), .draw = roberts_draw_options_default()};
    roberts_camera_preset("iso", &options->camera);
    description_word(&options->description, "roberts");
    for (int i = 1; i < argc; i++) {
        if (only_operands || argv[i][0] != '-' || argv[i][1] == '\0') {
            if (!only_operands && i > 1 && (status = misplaced_value(argv[i - 1], argv[i])) != EXIT_DONE)
                return status;
            argv[operands++] = argv[i];
        } else if (strcmp(argv[i], "--") == 0)
            only_operands = true;
        else if ((status = (argv[i][1] == '-' ? take_long : take_short)(&p, argc, argv, &i)) != EXIT_DONE)
            return status;
    }
    options->input = operands ? argv : nothing_named;
    options->input_count = operands ? (size_t)operands : 1;
    if (p.given[OPTION_LANDSCAPE])
        lay_down(&options->draw.page);
    describe_numbered(options);
    for (int i = 0; i < operands && !options->batch; i++)
        description_word(&options->description, argv[i]);
    if (options->help || options->version)
        return EXIT_DONE;
    const char *names[OPTION_COUNT];
    const sense_given given = {names, list_given(&p, names)};
    if ((status = check_conflicts(&p)) != EXIT_DONE || (status = sense_check_folder(options)) != EXIT_DONE ||
        (status = choose_format(&p)) != EXIT_DONE || (status = sense_check(options, given)) != EXIT_DONE)
        return status;
    sense_warn(options, given);
    set_camera(&p);
    return EXIT_DONE;
}
