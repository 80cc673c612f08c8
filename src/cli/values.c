/* values.c - what the value of each option may be, and where it goes. */
#include "cli/values.h"

#include <ctype.h>
#include <float.h>
#include <stddef.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/hints.h"
#include "cli/message.h"
#include "cli/parse.h"

/* ---- any option ---- */

static void *field(const option *o, cli_options *options)
{
    return (char *)options + o->field;
}

/* Reports that a value is not in low .. high; high = DBL_MAX: there is no upper limit. */
static int refuse_range(const char *what, const char *value, double low, double high, const char *unit)
{
    if (high == DBL_MAX)
        return message_misuse("%s: %s is out of range: at least %.10g%s", what, value, low, unit);
    return message_misuse("%s: %s is out of range: from %.10g to %.10g%s", what, value, low, high, unit);
}

/* The same for the value of an option whose row has the range. */
static int refuse_number(const option *o, const char *value, const char *unit)
{
    char what[40];
    snprintf(what, sizeof what, "--%s", o->name);
    return refuse_range(what, value, o->least, o->most, unit);
}

/* How a message ends about a value with a comma between digits, which is probably meant as a decimal point. */
static const char *point_meant(const char *value)
{
    for (const char *comma = strchr(value, ','); comma; comma = strchr(comma + 1, ','))
        if (comma > value && isdigit((unsigned char)comma[-1]) && isdigit((unsigned char)comma[1]))
            return "; decimals have a point, as in 0.5";
    return "";
}

int values_set_flag(const option *o, const char *value, cli_options *options)
{
    (void)value;
    *(bool *)field(o, options) = true;
    return EXIT_DONE;
}

int values_set_any_text(const option *o, const char *value, cli_options *options)
{
    *(const char **)field(o, options) = value;
    return EXIT_DONE;
}

int values_set_text(const option *o, const char *value, cli_options *options)
{
    values_set_any_text(o, value, options);
    if (*value)
        return EXIT_DONE;
    return message_misuse("--%s: the %s is empty", o->name, strcmp(o->value, "TEXT") == 0 ? "text" : "name");
}

int values_set_number(const option *o, const char *value, cli_options *options)
{
    double *number = field(o, options);
    if (!parse_number(value, number))
        return message_misuse("--%s: \"%s\" is not a number%s", o->name, value, point_meant(value));
    return *number >= o->least && *number <= o->most ? EXIT_DONE : refuse_number(o, value, "");
}

int values_set_integer(const option *o, const char *value, cli_options *options)
{
    uint32_t *number = field(o, options);
    if (!parse_integer(value, number))
        return message_misuse("--%s: \"%s\" is not a whole number from %.0f to %.0f", o->name, value, o->least,
                              o->most);
    return *number >= o->least && *number <= o->most ? EXIT_DONE : refuse_number(o, value, "");
}

int values_set_length(const option *o, const char *value, cli_options *options)
{
    double *mm = field(o, options);
    if (!parse_length(value, mm))
        return message_misuse("--%s: \"%s\" is not a length in mm, or with cm, in or pt behind it%s", o->name, value,
                              point_meant(value));
    return *mm >= o->least && *mm <= o->most ? EXIT_DONE : refuse_number(o, value, " mm");
}

int values_set_share(const option *o, const char *value, cli_options *options)
{
    roberts_share *share = field(o, options);
    char word[16];
    bool fits;
    const char *of = parse_word(value, '/', word, sizeof word, &fits);
    if (of && fits && parse_integer(word, &share->number) && parse_integer(of, &share->of) && share->number >= 1 &&
        share->number <= share->of)
        return EXIT_DONE;
    return message_misuse("--%s: \"%s\" is not K/N, with K from 1 to N", o->name, value);
}

int values_set_vector(const option *o, const char *value, cli_options *options)
{
    double v[3];
    if (!parse_numbers(value, v, 3))
        return message_misuse("--%s: \"%s\" is not X,Y,Z (three numbers, point for decimals)", o->name, value);
    *(roberts_vec3 *)field(o, options) = (roberts_vec3){v[0], v[1], v[2]};
    return EXIT_DONE;
}

/* A point, and a direction that may be left out. */
int values_set_section(const option *o, const char *value, cli_options *options)
{
    double v[6] = {0.0};
    const bool directed = parse_numbers(value, v, 6);
    if (!directed && !parse_numbers(value, v, 3))
        return message_misuse("--%s: \"%s\" is not X,Y,Z or X,Y,Z,NX,NY,NZ (numbers, point for decimals)", o->name,
                              value);
    if (directed && v[3] == 0.0 && v[4] == 0.0 && v[5] == 0.0)
        return message_misuse("--%s: 0,0,0 is no direction", o->name);
    options->section[0] = (roberts_vec3){v[0], v[1], v[2]};
    options->section[1] = (roberts_vec3){v[3], v[4], v[5]};
    return EXIT_DONE;
}

int values_set_direction(const option *o, const char *value, cli_options *options)
{
    const roberts_vec3 *v = field(o, options);
    int status = values_set_vector(o, value, options);
    if (status == EXIT_DONE && v->x == 0.0 && v->y == 0.0 && v->z == 0.0)
        return message_misuse("--%s: 0,0,0 is no direction", o->name);
    return status;
}

/* Index of the value among the option's words. */
static int choose(const option *o, const char *value, size_t *index)
{
    char what[40];
    *index = parse_find(value, o->words);
    if (o->words[*index])
        return EXIT_DONE;
    snprintf(what, sizeof what, "--%s", o->name);
    return hint_unknown(what, value, o->words, NULL);
}

/* ---- output ---- */

const char *const values_formats[] = {
    [ROBERTS_SVG] = "svg", [ROBERTS_PDF] = "pdf",   [ROBERTS_PS] = "ps",     [ROBERTS_EPS] = "eps",
    [ROBERTS_PNG] = "png", [ROBERTS_TIKZ] = "tikz", [ROBERTS_DXF] = "dxf",   [ROBERTS_HPGL] = "hpgl",
    [ROBERTS_CSV] = "csv", [ROBERTS_JSON] = "json", [ROBERTS_NULL] = "null", [ROBERTS_NULL + 1] = NULL,
};

const char *values_format_name(roberts_format format)
{
    return values_formats[format];
}

int values_set_format(const option *o, const char *value, cli_options *options)
{
    size_t i;
    if (roberts_format_by_name(value, &options->draw.format))
        return EXIT_DONE;
    return choose(o, value, &i);
}

const char *const values_sheets[] = {"first", "third", NULL};

int values_set_sheet(const option *o, const char *value, cli_options *options)
{
    size_t i;
    int status = choose(o, value, &i);
    options->is_sheet = true;
    options->sheet = i == 0 ? ROBERTS_FIRST_ANGLE : ROBERTS_THIRD_ANGLE;
    return status;
}

const char *const values_hidden[] = {"none", "dashed", "solid", NULL};

int values_set_hidden(const option *o, const char *value, cli_options *options)
{
    static const roberts_hidden modes[] = {ROBERTS_HIDDEN_NONE, ROBERTS_HIDDEN_DASHED, ROBERTS_HIDDEN_SOLID};
    size_t i;
    int status = choose(o, value, &i);
    if (status == EXIT_DONE) {
        options->draw.hidden = modes[i];
        options->hide.keep_hidden = modes[i] != ROBERTS_HIDDEN_NONE;
    }
    return status;
}

const char *const values_columns[] = {
    [ROBERTS_COLUMN_ENDS] = "+ends", [ROBERTS_COLUMN_DEPTH] = "+depth", [ROBERTS_COLUMN_LEVEL] = "+level",
    [ROBERTS_COLUMN_NAME] = "+name", [ROBERTS_COLUMN_BY] = "+by",       [ROBERTS_COLUMNS] = NULL,
};

/* One further column. */
static int add_column(const option *o, const char *word, cli_options *options)
{
    roberts_draw_options *draw = &options->draw;
    const size_t i = parse_find(word, o->words);
    if (!o->words[i])
        return hint_unknown("--columns", word, o->words, "with commas between several");
    if (values_has_column(draw, (roberts_column)i))
        return message_misuse("--columns: %s is there twice", word);
    draw->column[draw->column_count++] = (roberts_column)i;
    options->hide.levels |= i == ROBERTS_COLUMN_LEVEL;
    return EXIT_DONE;
}

int values_set_columns(const option *o, const char *value, cli_options *options)
{
    char word[64];
    bool fits;
    int status = EXIT_DONE;
    options->draw.column_count = 0;
    options->hide.levels = false;
    while (value && status == EXIT_DONE) {
        value = parse_word(value, ',', word, sizeof word, &fits);
        status = fits ? add_column(o, word, options) : message_misuse("--columns: \"%s...\" is too long", word);
    }
    return status;
}

int values_set_crease(const option *o, const char *value, cli_options *options)
{
    options->hide.crease_auto = strcmp(value, "auto") == 0;
    return options->hide.crease_auto ? EXIT_DONE : values_set_number(o, value, options);
}

const char *const values_fill_rules[] = {"nonzero", "evenodd", NULL};

int values_set_fill_rule(const option *o, const char *value, cli_options *options)
{
    size_t i;
    int status = choose(o, value, &i);
    options->scene.even_odd = i == 1;
    return status;
}

/* ---- page ---- */

/* ISO 216, and the sizes of North America */
const char *const values_pages[] = {"a0", "a1", "a2", "a3", "a4", "a5",     "a6",    "b0",      "b1",
                                    "b2", "b3", "b4", "b5", "b6", "letter", "legal", "tabloid", NULL};

int values_set_page(const option *o, const char *value, cli_options *options)
{
    static const double sizes[][2] = {{841, 1189},    {594, 841},    {420, 594},   {297, 420},  {210, 297},
                                      {148, 210},     {105, 148},    {1000, 1414}, {707, 1000}, {500, 707},
                                      {353, 500},     {250, 353},    {176, 250},   {125, 176},  {215.9, 279.4},
                                      {215.9, 355.6}, {279.4, 431.8}};
    roberts_page *page = &options->draw.page;
    char word[64]; /* in lower case, e.g. for "A4", "210X297" */
    size_t length = strlen(value) < sizeof word ? strlen(value) : sizeof word - 1;
    for (size_t i = 0; i < length; i++)
        word[i] = (char)(value[i] >= 'A' && value[i] <= 'Z' ? value[i] - 'A' + 'a' : value[i]);
    word[length] = '\0';
    const size_t i = parse_find(word, o->words);
    double width, height;
    if (o->words[i]) {
        page->width_mm = sizes[i][0];
        page->height_mm = sizes[i][1];
        return EXIT_DONE;
    }
    if (strchr(word, 'x') && *point_meant(word))
        return message_misuse("--page: \"%s\" is not like 210x297 or 8.5x11in%s", value, point_meant(word));
    if (value[length] || !parse_lengths(word, 'x', &width, &height))
        return hint_unknown("--page", value, o->words, "or WxH in mm, as 210x297, or 8.5x11in");
    if (!(width >= 1.0 && width <= 40000.0 && height >= 1.0 && height <= 40000.0))
        return refuse_range("--page", value, 1, 40000, " mm a side");
    page->width_mm = width;
    page->height_mm = height;
    return EXIT_DONE;
}

const char *const values_scales[] = {"standard", NULL};

int values_set_scale(const option *o, const char *value, cli_options *options)
{
    roberts_placement *placement = &options->draw.placement;
    double a, b = 1.0;
    placement->standard = strcmp(value, o->words[0]) == 0;
    placement->scale = 0.0;
    if (placement->standard)
        return EXIT_DONE;
    if (!parse_ratio(value, &a, &b) && !parse_number(value, &a))
        return message_misuse("--scale: \"%s\" is not like 1:20, 2:1 or 0.05, nor standard%s", value,
                              point_meant(value));
    if (!(a > 0.0 && b > 0.0 && a / b >= 1e-12 && a / b <= 1e12))
        return refuse_range("--scale", value, 1e-12, 1e12, "");
    placement->scale = a / b;
    return EXIT_DONE;
}

const char *const values_units[] = {"mm", "cm", "m", "in", "ft", NULL};

int values_set_unit(const option *o, const char *value, cli_options *options)
{
    static const double mm[] = {1.0, 10.0, 1000.0, 25.4, 304.8};
    size_t i;
    int status = choose(o, value, &i);
    if (status == EXIT_DONE)
        options->draw.placement.unit_mm = mm[i];
    if (status == EXIT_DONE)
        options->unit = i == 0 ? NULL : o->words[i];
    return status;
}

const char *const values_places[] = {"center",   "left",      "right",       "top",          "bottom",
                                     "top-left", "top-right", "bottom-left", "bottom-right", NULL};

int values_set_align(const option *o, const char *value, cli_options *options)
{
    static const int sides[][2] = {{0, 0}, {-1, 0}, {1, 0}, {0, 1}, {0, -1}, {-1, 1}, {1, 1}, {-1, -1}, {1, -1}};
    size_t i;
    int status = choose(o, strcmp(value, "centre") == 0 ? "center" : value, &i);
    if (status == EXIT_DONE) {
        options->draw.placement.align_x = sides[i][0];
        options->draw.placement.align_y = sides[i][1];
    }
    return status;
}

/* ORIGIN[,TURN[,XxY]] */
int values_set_plotter(const option *o, const char *value, cli_options *options)
{
    char origin[16], turned[16] = "0";
    bool fits, fits_turn = true;
    uint32_t turn = 0;
    roberts_vec2 inside = {0.0, 0.0};
    const char *rest = parse_word(value, ',', origin, sizeof origin, &fits);
    const bool centre = strcmp(origin, "center") == 0 || strcmp(origin, "centre") == 0;
    if (!fits || (!centre && strcmp(origin, "corner") != 0))
        return message_misuse("--%s: the origin is corner or center, not \"%s\"", o->name, origin);
    if (rest)
        rest = parse_word(rest, ',', turned, sizeof turned, &fits_turn);
    if (!fits_turn || !parse_integer(turned, &turn) || turn > 270 || turn % 90 != 0)
        return message_misuse("--%s: a page is turned by 0, 90, 180 or 270 degrees, not \"%s\"", o->name, turned);
    if (rest && !parse_lengths(rest, 'x', &inside.x, &inside.y))
        return message_misuse("--%s: \"%s\" is not how far the origin lies inside, as 10x4, in mm", o->name, rest);
    if (fmin(inside.x, inside.y) < o->least || fmax(inside.x, inside.y) > o->most)
        return refuse_range("--plotter", rest, o->least, o->most, " mm");
    options->draw.plotter = (roberts_plotter){centre, turn, inside};
    return EXIT_DONE;
}

const char *const values_frames[] = {"zones", NULL};

int values_set_frame(const option *o, const char *value, cli_options *options)
{
    size_t i;
    if (value && choose(o, value, &i) != EXIT_DONE)
        return EXIT_MISUSED;
    options->draw.lettering.zones = value != NULL;
    options->draw.frame.off = false;
    return EXIT_DONE;
}

/* ---- colours and pens ---- */

const char *const values_backgrounds[] = {"none", "black", "white",   "gray",   "red",    "green",  "blue",
                                          "cyan", "brown", "magenta", "yellow", "orange", "purple", NULL};

static const char *const *const color_names = values_backgrounds + 1;

static bool hex_digit(char c, unsigned *value)
{
    static const char digits[] = "0123456789abcdef";
    const char *at = c ? strchr(digits, c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c) : NULL;
    *value = at ? (unsigned)(at - digits) : 0;
    return at != NULL;
}

/* #rgb or #rrggbb. */
static bool parse_hex(const char *value, unsigned char part[3])
{
    size_t length = strlen(value), each = length == 4 ? 1 : 2;
    if (value[0] != '#' || (length != 4 && length != 7))
        return false;
    for (size_t i = 0; i < 3; i++) {
        unsigned high, low;
        if (!hex_digit(value[1 + i * each], &high) || !hex_digit(value[each + i * each], &low))
            return false;
        part[i] = (unsigned char)(16 * high + low);
    }
    return true;
}

/* A colour's name, or #rrggbb. False: it is neither. */
static bool find_color(const char *value, unsigned char part[3])
{
    static const unsigned char parts[][3] = {{0, 0, 0},     {255, 255, 255}, {128, 128, 128}, {255, 0, 0},
                                             {0, 128, 0},   {0, 0, 255},     {0, 255, 255},   {165, 42, 42},
                                             {255, 0, 255}, {255, 255, 0},   {255, 165, 0},   {128, 0, 128}};
    const size_t i = parse_find(strcmp(value, "grey") == 0 ? "gray" : value, color_names);
    if (!color_names[i])
        return parse_hex(value, part);
    memcpy(part, parts[i], 3);
    return true;
}

/* If the value is no colour, the message says that `what` can be a colour's name or `also`. */
static int parse_color(const char *what, const char *also, const char *value, unsigned char part[3])
{
    return find_color(value, part) ? EXIT_DONE : hint_unknown(what, value, color_names, also);
}

int values_set_background(const option *o, const char *value, cli_options *options)
{
    unsigned char part[3] = {0};
    roberts_background *background = &options->draw.background;
    (void)o;
    background->on = strcmp(value, "none") != 0;
    if (!background->on)
        return EXIT_DONE;
    int status = parse_color("--background", "#rrggbb, #rgb or none", value, part);
    *background = (roberts_background){true, part[0], part[1], part[2]};
    return status;
}

const char *const values_fills[] = {"none",  "model",   "shade",  "body",   "shade:body", "shade:white", "shade:gray",
                                    "white", "gray",    "red",    "green",  "blue",       "cyan",        "brown",
                                    "black", "magenta", "yellow", "orange", "purple",     NULL};

/* "shade" alone shades the model's own colours. */
int values_set_fill(const option *o, const char *value, cli_options *options)
{
    static const char shade[] = "shade";
    roberts_draw_options *draw = &options->draw;
    const char *with = strncmp(value, "shade:", sizeof shade) == 0 ? value + sizeof shade : value;
    (void)o;
    draw->shaded = with != value || strcmp(value, shade) == 0;
    if (strcmp(value, shade) == 0 || strcmp(with, "model") == 0)
        draw->fill = ROBERTS_FILL_MODEL;
    else if (strcmp(with, "body") == 0)
        draw->fill = ROBERTS_FILL_BODY;
    else if (strcmp(value, "none") == 0)
        draw->fill = ROBERTS_FILL_NONE;
    else
        draw->fill = ROBERTS_FILL_COLOR;
    if (draw->fill != ROBERTS_FILL_COLOR || find_color(with, draw->fill_color))
        return EXIT_DONE;
    return hint_unknown("--fill", value, values_fills, "shade:COLOR, #rrggbb or #rgb");
}

static int set_color(roberts_pen *pen, const char *value)
{
    unsigned char part[3] = {0};
    int status = parse_color("--style: colour", "#rrggbb or #rgb", value, part);
    if (status != EXIT_DONE)
        return status;
    pen->red = part[0];
    pen->green = part[1];
    pen->blue = part[2];
    return EXIT_DONE;
}

/* Lengths of pens. */
static const double shortest_mm = 0.001, longest_mm = 1000.0;

static bool is_length(double mm)
{
    return mm >= shortest_mm && mm <= longest_mm;
}

static int refuse_length(const char *key, const char *value)
{
    char item[80];
    snprintf(item, sizeof item, "%s=%s", key, value);
    return refuse_range("--style", item, shortest_mm, longest_mm, " mm");
}

/* none, DASH or DASH/GAP; a gap is a quarter of its dash unless given. */
static int set_dashes(roberts_pen *pen, const char *value)
{
    double dash = 0.0, gap = 0.0;
    if (strcmp(value, "none") != 0 && !parse_lengths(value, '/', &dash, &gap)) {
        if (!parse_length(value, &dash))
            return message_misuse("--style: dash=%s is neither none nor DASH/GAP in mm, or with cm, in or pt behind it",
                                  value);
        gap = dash / 4.0;
    }
    if (strcmp(value, "none") != 0 && !(is_length(dash) && is_length(gap)))
        return refuse_length("dash", value);
    pen->dash_mm = dash;
    pen->gap_mm = gap;
    return EXIT_DONE;
}

/* Dashes of 12 and gaps of 3 widths follow the width. */
static int set_width(roberts_pen *pen, const char *value)
{
    double width;
    if (!parse_length(value, &width))
        return message_misuse("--style: width=%s is not a length in mm, or with cm, in or pt behind it", value);
    if (!is_length(width))
        return refuse_length("width", value);
    bool follows = pen->dash_mm == 12.0 * pen->width_mm && pen->gap_mm == 3.0 * pen->width_mm && pen->dash_mm > 0.0;
    pen->width_mm = width;
    if (follows) {
        pen->dash_mm = 12.0 * width;
        pen->gap_mm = 3.0 * width;
    }
    return EXIT_DONE;
}

static int set_pen_number(roberts_pen *pen, const char *value)
{
    uint32_t number;
    if (!parse_integer(value, &number) || number < 1 || number > UINT8_MAX)
        return message_misuse("--style: \"pen=%s\" is no number of a pen, from 1 to %d", value, UINT8_MAX);
    pen->number = (unsigned char)number;
    return EXIT_DONE;
}

/* One key=value, or a key alone. */
static int set_key(roberts_pen *pen, const char *item)
{
    enum { WIDTH, COLOR, COLOUR, DASH, PEN, OFF, ON };
    static const char *const names[] = {"width", "color", "colour", "dash", "pen", "off", "on", NULL};
    char key[64];
    bool fits;
    const char *value = parse_word(item, '=', key, sizeof key, &fits);
    const size_t i = parse_find(key, names);
    if (!names[i])
        return hint_unknown("--style", key, names, "as in outline:width=0.7,color=red");
    if ((i < OFF) != (value != NULL))
        return message_misuse("--style: %s %s", key, i < OFF ? "needs a value" : "takes no value");
    switch (i) {
    case WIDTH:
        return set_width(pen, value);
    case COLOR:
    case COLOUR:
        return set_color(pen, value);
    case DASH:
        return set_dashes(pen, value);
    case PEN:
        return set_pen_number(pen, value);
    default:
        pen->off = i == OFF;
        return EXIT_DONE;
    }
}

const char *const values_pens[] = {
    [PEN_OUTLINE] = "outline",
    [PEN_BORDER] = "border",
    [PEN_CREASE] = "crease",
    [PEN_INTERSECTION] = "intersection",
    [PEN_WIRE] = "wire",
    [PEN_HIDDEN] = "hidden",
    [PEN_FRAME] = "frame",
    [PEN_SYMBOL] = "symbol",
    [PEN_HATCH] = "hatch",
    [PEN_TEXT] = "text",
    [PEN_HIDDEN_TEXT] = "hidden-text",
    [PENS] = "all",
    [PENS + 1] = NULL,
};

static const size_t pen_fields[PENS] = {
    [PEN_OUTLINE] = offsetof(roberts_draw_options, outline),
    [PEN_BORDER] = offsetof(roberts_draw_options, border),
    [PEN_CREASE] = offsetof(roberts_draw_options, crease),
    [PEN_INTERSECTION] = offsetof(roberts_draw_options, intersection),
    [PEN_WIRE] = offsetof(roberts_draw_options, wire),
    [PEN_HIDDEN] = offsetof(roberts_draw_options, back),
    [PEN_FRAME] = offsetof(roberts_draw_options, frame),
    [PEN_SYMBOL] = offsetof(roberts_draw_options, symbol),
    [PEN_HATCH] = offsetof(roberts_draw_options, hatch),
    [PEN_TEXT] = offsetof(roberts_draw_options, text),
    [PEN_HIDDEN_TEXT] = offsetof(roberts_draw_options, hidden_text),
};

bool values_hatches(const roberts_draw_options *draw)
{
    return draw->hatching.on && !draw->hatch.off;
}

const roberts_pen *values_pen(const roberts_draw_options *draw, size_t pen)
{
    return (const roberts_pen *)((const char *)draw + pen_fields[pen]);
}

bool values_pen_is_set(const roberts_draw_options *draw, size_t pen)
{
    const roberts_draw_options defaults = roberts_draw_options_default();
    const roberts_pen *a = values_pen(draw, pen), *b = values_pen(&defaults, pen);
    return a->width_mm != b->width_mm || a->dash_mm != b->dash_mm || a->gap_mm != b->gap_mm || a->red != b->red ||
           a->green != b->green || a->blue != b->blue;
}

/* One key=value, or a key alone, of a class; of PENS: of all classes. */
static int set_in_class(cli_options *options, size_t class, const char *item)
{
    int status = EXIT_DONE;
    if (class < PENS)
        return set_key((roberts_pen *)((char *)&options->draw + pen_fields[class]), item);
    for (size_t pen = 0; pen < PENS && status == EXIT_DONE; pen++)
        if (pen != PEN_FRAME || strcmp(item, "on") != 0) /* --frame draws a frame */
            status = set_in_class(options, pen, item);
    return status;
}

int values_set_style(const option *o, const char *value, cli_options *options)
{
    char word[64];
    bool fits;
    const char *rest = parse_word(value, ':', word, sizeof word, &fits);
    const size_t i = parse_find(word, o->words);
    int status = EXIT_DONE;
    if (!rest && (o->words[i] || strchr(value, '=')))
        return message_misuse("--style: \"%s\" is not CLASS:key=value,..., as outline:width=0.7,color=red", value);
    if (!o->words[i])
        return hint_unknown("--style", word, o->words, NULL);
    if (strchr(rest, ':'))
        return message_misuse("--style: \"%s\": there is a comma between two values, as outline:width=0.7,color=red",
                              value);
    if (*point_meant(rest))
        return message_misuse("--style: \"%s\": there is a comma between two values%s", value, point_meant(rest));
    while (rest && status == EXIT_DONE) {
        rest = parse_word(rest, ',', word, sizeof word, &fits);
        status = fits ? set_in_class(options, i, word) : message_misuse("--style: \"%s...\" is too long", word);
    }
    if (i < PENS)
        options->named_pens |= 1u << i;
    return status;
}

const char *const values_dashes[] = {"pattern", "real", NULL};

int values_set_dash(const option *o, const char *value, cli_options *options)
{
    size_t i;
    int status = choose(o, value, &i);
    options->draw.real_dashes = i == 1;
    return status;
}

const char *const values_orders[] = {"travel", "none", NULL};

int values_set_order(const option *o, const char *value, cli_options *options)
{
    size_t i;
    int status = choose(o, value, &i);
    options->draw.order = i == 0 ? ROBERTS_ORDER_TRAVEL : ROBERTS_ORDER_NONE;
    return status;
}

const char *const values_layers[] = {"named", "numbered", NULL};

int values_set_layers(const option *o, const char *value, cli_options *options)
{
    size_t i;
    int status = choose(o, value, &i);
    options->draw.number_layers = i == 1;
    return status;
}

const char *const values_groups[] = {"class", "body", "element", NULL};

int values_set_group(const option *o, const char *value, cli_options *options)
{
    static const roberts_grouping groupings[] = {ROBERTS_GROUP_CLASS, ROBERTS_GROUP_BODY, ROBERTS_GROUP_ELEMENT};
    size_t i;
    int status = choose(o, value, &i);
    if (status == EXIT_DONE)
        options->draw.grouping = groupings[i];
    return status;
}

int values_set_id_prefix(const option *o, const char *value, cli_options *options)
{
    static const char letters[] = "_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ", others[] = "-.0123456789";
    const char *at = value;
    while (*at && (strchr(letters, *at) || (at > value && strchr(others, *at))))
        at++;
    if (*at || !*value)
        return message_misuse("--%s: \"%s\" cannot begin an id: it needs a letter or _, then letters, digits, - . or _",
                              o->name, value);
    options->draw.id_prefix = value;
    return EXIT_DONE;
}

/* ---- text ---- */

const char *const values_labels[] = {"vertices", "edges", "faces", "bodies", "names", NULL};

int values_set_label(const option *o, const char *value, cli_options *options)
{
    char word[64];
    bool fits;
    options->draw.lettering.labels = 0;
    while (value) {
        value = parse_word(value, ',', word, sizeof word, &fits);
        const size_t i = parse_find(word, o->words);
        if (!fits || !o->words[i])
            return hint_unknown("--label", word, o->words, "with commas between several");
        options->draw.lettering.labels |= 1u << i;
    }
    return EXIT_DONE;
}

const char *const values_texts[] = {"strokes", "native", NULL};

int values_set_text_mode(const option *o, const char *value, cli_options *options)
{
    size_t i;
    int status = choose(o, value, &i);
    options->draw.lettering.native = i == 1;
    return status;
}

const char *const values_fields[] = {"owner", "author", "approved", "number", "revision", "date", "sheet", NULL};

/* NAME=TEXT; the last text of a name counts. */
int values_set_field(const option *o, const char *value, cli_options *options)
{
    char word[16];
    bool fits;
    const char *text = parse_word(value, '=', word, sizeof word, &fits);
    const size_t i = parse_find(word, o->words);
    size_t at = 0;
    if (!fits || !o->words[i])
        return hint_unknown("--field", word, o->words, "as in author=Name");
    if (!text)
        return message_misuse("--field: \"%s\" is not NAME=TEXT, as author=Name", value);
    while (at < options->field_count && strcmp(options->field[at].name, o->words[i]) != 0)
        at++;
    options->field[at] = (roberts_field){o->words[i], text};
    options->field_count += at == options->field_count;
    return EXIT_DONE;
}

const char *const values_dimensions[] = {"overall", NULL};

/* v4-v17, or 4-17 as in labels of edges. */
static bool read_distance(char *word, roberts_distance *distance)
{
    char *second = strchr(word, '-');
    if (!second)
        return false;
    *second++ = '\0';
    return parse_integer(word + (*word == 'v'), &distance->v0) &&
           parse_integer(second + (*second == 'v'), &distance->v1);
}

/* Is this distance, in either direction, one of those before it? */
static bool has_distance(const cli_options *options, const roberts_distance *d)
{
    for (const roberts_distance *e = options->distance; e < d; e++)
        if ((e->v0 == d->v0 && e->v1 == d->v1) || (e->v0 == d->v1 && e->v1 == d->v0))
            return true;
    return false;
}

int values_set_dimensions(const option *o, const char *value, cli_options *options)
{
    char word[64], asked[64];
    bool fits;
    options->draw.lettering.overall = false;
    options->distance_count = 0;
    while (value) {
        roberts_distance *distance = &options->distance[options->distance_count];
        value = parse_word(value, ',', word, sizeof word, &fits);
        snprintf(asked, sizeof asked, "%s", word);
        if (fits && strcmp(word, o->words[0]) == 0) {
            options->draw.lettering.overall = true;
            continue;
        }
        if (options->distance_count == DISTANCES_MOST)
            return message_misuse("--dimensions: at most %d distances can be given", DISTANCES_MOST);
        if (!fits || !read_distance(word, distance))
            return hint_unknown("--dimensions", asked, o->words,
                                "or two vertices, as v4-v17; with commas between several");
        if (distance->v0 == distance->v1)
            return message_misuse("--dimensions: \"%s\" is a distance from a vertex to itself", asked);
        options->distance_count += !has_distance(options, distance);
    }
    return EXIT_DONE;
}

/* ---- view ---- */

const char *const values_views[] = {"iso",   "dimetric", "trimetric", "front",    "back",    "left",
                                    "right", "top",      "bottom",    "cavalier", "cabinet", NULL};

int values_set_view(const option *o, const char *value, cli_options *options)
{
    size_t i;
    return roberts_camera_preset(value, &options->camera) ? EXIT_DONE : choose(o, value, &i);
}

int values_set_dir(const option *o, const char *value, cli_options *options)
{
    options->camera.projection = ROBERTS_ORTHOGRAPHIC;
    return values_set_direction(o, value, options);
}

int values_set_eye(const option *o, const char *value, cli_options *options)
{
    options->camera.projection = ROBERTS_PERSPECTIVE;
    return values_set_vector(o, value, options);
}

int values_set_look_at(const option *o, const char *value, cli_options *options)
{
    options->camera.has_look_at = true;
    return values_set_vector(o, value, options);
}

/* ---- messages ---- */

const char *const values_stats[] = {"json", NULL};

int values_set_stats(const option *o, const char *value, cli_options *options)
{
    if (value && strcmp(value, o->words[0]) != 0)
        return hint_unknown("--stats", value, o->words, "or left out");
    options->stats = value ? STATS_JSON : STATS_TEXT;
    return EXIT_DONE;
}

int values_set_verify(const option *o, const char *value, cli_options *options)
{
    options->verify = true;
    if (!value)
        return EXIT_DONE;
    return values_set_integer(o, value, options);
}

int values_add_room(const option *o, const char *value, cli_options *options)
{
    if (options->room_count == ROOMS_MOST)
        return message_misuse("--room-for: at most %d files can be given", ROOMS_MOST);
    if (!*value || strcmp(value, "-") == 0)
        return message_misuse("--%s: a file is needed, not \"%s\"", o->name, value);
    options->room[options->room_count++] = value;
    return EXIT_DONE;
}

int values_set_pick(const option *o, const char *value, cli_options *options)
{
    double p[2];
    if (options->pick_count == PICKS_MOST)
        return message_misuse("--pick: at most %d points can be given", PICKS_MOST);
    if (!parse_numbers(value, p, 2))
        return message_misuse("--%s: \"%s\" is not X,Y (two numbers, point for decimals)", o->name, value);
    options->pick[options->pick_count++] = (roberts_vec2){p[0], p[1]};
    return EXIT_DONE;
}

/* ---- --hatch: KEY=VALUE,... ---- */

enum {
    KEY_SPACING,
    KEY_LEVELS,
    KEY_ANGLE,
    KEY_DIRECTION,
    KEY_CROSS,
    KEY_LINES,
    KEY_SHORTEST,
    KEY_FACES,
    KEY_OFF,
    KEY_ON
};

const char *const values_hatch_keys[] = {"spacing",  "levels", "angle", "direction", "cross", "lines",
                                         "shortest", "faces",  "off",   "on",        NULL};

static const double hatch_shortest_mm = 0.01, hatch_longest_mm = 1000.0;
enum { LEVELS_MOST = 1000, ANGLE_MOST = 360 };

/* Without an angle, only strokes along the picture are turned, by 45 degrees; so this is decided at the end. */
static int set_hatch_key(roberts_hatching *h, const char *item, bool *turned)
{
    static const char *const directions[] = {"picture", "steep", "across", NULL};
    static const roberts_hatch_along along[] = {ROBERTS_HATCH_PICTURE, ROBERTS_HATCH_STEEP, ROBERTS_HATCH_ACROSS};
    static const char *const lines[] = {"even", "nested", NULL};
    static const char *const faces[] = {"all", "sections", NULL};
    char key[64];
    bool fits;
    const char *value = parse_word(item, '=', key, sizeof key, &fits);
    const size_t i = parse_find(key, values_hatch_keys);
    if (!values_hatch_keys[i])
        return hint_unknown("--hatch", key, values_hatch_keys,
                            "as in spacing=0.8,angle=45; --hatch on takes the defaults");
    if ((i < KEY_OFF) != (value != NULL))
        return message_misuse("--hatch: %s %s", key, i < KEY_OFF ? "needs a value" : "takes no value");
    h->on = i != KEY_OFF;
    switch (i) {
    case KEY_SPACING:
        if (parse_length(value, &h->spacing_mm) && h->spacing_mm >= hatch_shortest_mm &&
            h->spacing_mm <= hatch_longest_mm)
            return EXIT_DONE;
        return message_misuse("--hatch: spacing=%s is not a length from %g to %g mm", value, hatch_shortest_mm,
                              hatch_longest_mm);
    case KEY_LEVELS:
        if (parse_integer(value, &h->levels) && h->levels <= LEVELS_MOST)
            return EXIT_DONE;
        return message_misuse("--hatch: levels=%s is not a whole number from 0 to %d", value, LEVELS_MOST);
    case KEY_ANGLE:
        *turned = true;
        if (parse_number(value, &h->degrees) && h->degrees >= -ANGLE_MOST && h->degrees <= ANGLE_MOST)
            return EXIT_DONE;
        return message_misuse("--hatch: angle=%s is not a number of degrees from -%d to %d", value, ANGLE_MOST,
                              ANGLE_MOST);
    case KEY_CROSS:
        h->cross = 1.0;
        if (strcmp(value, "none") == 0 || (parse_number(value, &h->cross) && h->cross >= 0.0 && h->cross <= 1.0))
            return EXIT_DONE;
        return message_misuse("--hatch: cross=%s is neither none nor a number from 0 to 1", value);
    case KEY_LINES:
        if (!lines[parse_find(value, lines)])
            return hint_unknown("--hatch: lines", value, lines, NULL);
        h->nested = parse_find(value, lines) == 1;
        return EXIT_DONE;
    case KEY_SHORTEST:
        if (parse_length(value, &h->shortest_mm) && h->shortest_mm >= 0.0 && h->shortest_mm <= hatch_longest_mm)
            return EXIT_DONE;
        return message_misuse("--hatch: shortest=%s is not a length from 0 to %g mm", value, hatch_longest_mm);
    case KEY_FACES:
        if (!faces[parse_find(value, faces)])
            return hint_unknown("--hatch: faces", value, faces, NULL);
        h->sections = parse_find(value, faces) == 1;
        return EXIT_DONE;
    case KEY_DIRECTION:
        if (!directions[parse_find(value, directions)])
            return hint_unknown("--hatch: direction", value, directions, NULL);
        h->along = along[parse_find(value, directions)];
        return EXIT_DONE;
    default:
        return EXIT_DONE;
    }
}

int values_set_hatch(const option *o, const char *value, cli_options *options)
{
    roberts_hatching *h = &options->draw.hatching;
    char word[64];
    bool fits, turned = false;
    int status = EXIT_DONE;
    (void)o;
    *h = roberts_draw_options_default().hatching;
    if (*point_meant(value))
        return message_misuse("--hatch: \"%s\": there is a comma between two values%s", value, point_meant(value));
    while (value && status == EXIT_DONE) {
        value = parse_word(value, ',', word, sizeof word, &fits);
        status = fits ? set_hatch_key(h, word, &turned) : message_misuse("--hatch: \"%s...\" is too long", word);
    }
    if (!turned && h->along != ROBERTS_HATCH_PICTURE)
        h->degrees = 0.0;
    return status;
}
