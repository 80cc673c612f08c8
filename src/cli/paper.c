/* paper.c - values of the options that say how a drawing comes on paper. */
#include "cli/paper.h"

#include <stdio.h>
#include <string.h>

#include "cli/message.h"
#include "cli/nearest.h"
#include "cli/parse.h"

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

/* Index of `word` among `words`, or `count`. */
static size_t find_word(const char *word, const char *const *words, size_t count)
{
    size_t i = 0;
    while (i < count && strcmp(word, words[i]) != 0)
        i++;
    return i;
}

/* What of `text` fits, in small letters. */
static void lower_case(const char *text, char *word, size_t size)
{
    size_t i = 0;
    for (; text[i] && i + 1 < size; i++)
        word[i] = (char)(text[i] >= 'A' && text[i] <= 'Z' ? text[i] - 'A' + 'a' : text[i]);
    word[i] = '\0';
}

/* Copies what stands before the first `end` (or all); returns what stands behind it, NULL: there is no `end`. False in
 * `*fits`: longer than any value is. */
static const char *take_word(const char *text, char end, char *word, size_t size, bool *fits)
{
    const char *stop = strchr(text, end);
    size_t length = stop ? (size_t)(stop - text) : strlen(text);
    *fits = length < size;
    snprintf(word, size, "%.*s", (int)(*fits ? length : size - 1), text);
    return stop ? stop + 1 : NULL;
}

/* Two numbers with a sign between them. */
static bool parse_pair(const char *value, char sign, double *a, double *b)
{
    char word[64];
    bool fits;
    const char *second = take_word(value, sign, word, sizeof word, &fits);
    return second && fits && parse_number(word, a) && parse_number(second, b);
}

/* Two lengths with a sign between them. A unit stands for both where only one has it, as in 8.5x11in. */
static bool parse_lengths(const char *value, char sign, double *a_mm, double *b_mm)
{
    char word[64];
    bool fits;
    double a, b, unit_a, unit_b;
    const char *second = take_word(value, sign, word, sizeof word, &fits);
    if (!second || !fits || !parse_measure(word, &a, &unit_a) || !parse_measure(second, &b, &unit_b))
        return false;
    const double unit = unit_b > 0.0 ? unit_b : unit_a > 0.0 ? unit_a : 1.0;
    *a_mm = a * (unit_a > 0.0 ? unit_a : unit);
    *b_mm = b * unit;
    return true;
}

int paper_set_page(roberts_page *page, const char *value)
{
    /* ISO 216, and what North America uses */
    static const char *const names[] = {"a0", "a1", "a2", "a3", "a4", "a5",     "a6",    "b0",     "b1",
                                        "b2", "b3", "b4", "b5", "b6", "letter", "legal", "tabloid"};
    static const double sizes[][2] = {{841, 1189},    {594, 841},    {420, 594},   {297, 420},  {210, 297},
                                      {148, 210},     {105, 148},    {1000, 1414}, {707, 1000}, {500, 707},
                                      {353, 500},     {250, 353},    {176, 250},   {125, 176},  {215.9, 279.4},
                                      {215.9, 355.6}, {279.4, 431.8}};
    char word[64];
    lower_case(value, word, sizeof word); /* as in "A4", "210X297" */
    size_t i = find_word(word, names, COUNT(names));
    if (i < COUNT(names)) {
        page->width_mm = sizes[i][0];
        page->height_mm = sizes[i][1];
        return EXIT_DONE;
    }
    double width, height;
    if (strlen(value) >= sizeof word || !parse_lengths(word, 'x', &width, &height))
        return nearest_unknown("--page", value, names, COUNT(names), "or WxH in mm, as 210x297, or 8.5x11in");
    if (!(width >= 1.0 && width <= 40000.0 && height >= 1.0 && height <= 40000.0))
        return message_misuse("--page: %s: each side has 1 to 40000 mm", value);
    page->width_mm = width;
    page->height_mm = height;
    return EXIT_DONE;
}

int paper_set_scale(roberts_placement *placement, const char *value)
{
    double a, b = 1.0;
    placement->standard = strcmp(value, "standard") == 0;
    placement->scale = 0.0;
    if (placement->standard)
        return EXIT_DONE;
    if (!parse_pair(value, ':', &a, &b) && !parse_number(value, &a))
        return message_misuse("--scale: \"%s\" is not like 1:20, 2:1 or 0.05, nor standard", value);
    if (!(a > 0.0 && b > 0.0 && a / b >= 1e-12 && a / b <= 1e12))
        return message_misuse("--scale: %s is not in 1e-12..1e12", value);
    placement->scale = a / b;
    return EXIT_DONE;
}

int paper_set_unit(roberts_placement *placement, const char *value)
{
    static const char *const names[] = {"mm", "cm", "m", "in", "ft"};
    static const double mm[] = {1.0, 10.0, 1000.0, 25.4, 304.8};
    size_t i = find_word(value, names, COUNT(names));
    if (i == COUNT(names))
        return nearest_unknown("--unit", value, names, COUNT(names), NULL);
    placement->unit_mm = mm[i];
    return EXIT_DONE;
}

int paper_set_align(roberts_placement *placement, const char *value)
{
    static const char *const names[] = {"center", "centre",   "left",      "right",       "top",
                                        "bottom", "top-left", "top-right", "bottom-left", "bottom-right"};
    static const int sides[][2] = {{0, 0},  {0, 0},  {-1, 0}, {1, 0},   {0, 1},
                                   {0, -1}, {-1, 1}, {1, 1},  {-1, -1}, {1, -1}};
    size_t i = find_word(value, names, COUNT(names));
    if (i == COUNT(names))
        return nearest_unknown("--align", value, names, COUNT(names), NULL);
    placement->align_x = sides[i][0];
    placement->align_y = sides[i][1];
    return EXIT_DONE;
}

int paper_set_order(roberts_draw_options *options, const char *value)
{
    static const char *const names[] = {"travel", "none"};
    size_t i = find_word(value, names, COUNT(names));
    if (i == COUNT(names))
        return nearest_unknown("--order", value, names, COUNT(names), NULL);
    options->order = i == 0 ? ROBERTS_ORDER_TRAVEL : ROBERTS_ORDER_NONE;
    return EXIT_DONE;
}

int paper_set_dash(roberts_draw_options *options, const char *value)
{
    static const char *const names[] = {"pattern", "real"};
    size_t i = find_word(value, names, COUNT(names));
    if (i == COUNT(names))
        return nearest_unknown("--dash", value, names, COUNT(names), NULL);
    options->real_dashes = i == 1;
    return EXIT_DONE;
}

/* ---- styles ---- */

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

/* Where it is none, `option` is what the message is about, and `also` what the option can be instead of a name. */
static int parse_color(const char *option, const char *also, const char *value, unsigned char part[3])
{
    static const char *const names[] = {"black", "white", "gray",    "grey",   "red",    "green", "blue",
                                        "cyan",  "brown", "magenta", "yellow", "orange", "purple"};
    static const unsigned char parts[][3] = {
        {0, 0, 0},     {255, 255, 255}, {128, 128, 128}, {128, 128, 128}, {255, 0, 0},   {0, 128, 0},  {0, 0, 255},
        {0, 255, 255}, {165, 42, 42},   {255, 0, 255},   {255, 255, 0},   {255, 165, 0}, {128, 0, 128}};
    size_t i = find_word(value, names, COUNT(names));
    if (i < COUNT(names))
        memcpy(part, parts[i], 3);
    else if (!parse_hex(value, part))
        return nearest_unknown(option, value, names, COUNT(names), also);
    return EXIT_DONE;
}

int paper_set_background(roberts_background *background, const char *value)
{
    unsigned char part[3] = {0};
    background->on = strcmp(value, "none") != 0;
    if (!background->on)
        return EXIT_DONE;
    int status = parse_color("--background", "#rrggbb, #rgb or none", value, part);
    *background = (roberts_background){true, part[0], part[1], part[2]};
    return status;
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

static bool is_length(double mm, double least)
{
    return mm >= least && mm <= 1000.0;
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
    if (strcmp(value, "none") != 0 && !(is_length(dash, 0.001) && is_length(gap, 0.001)))
        return message_misuse("--style: dash=%s is not in 0.001..1000 mm", value);
    pen->dash_mm = dash;
    pen->gap_mm = gap;
    return EXIT_DONE;
}

static int set_width(roberts_pen *pen, const char *value)
{
    double width;
    if (!parse_length(value, &width))
        return message_misuse("--style: width=%s is not a length in mm, or with cm, in or pt behind it", value);
    if (!is_length(width, 0.001))
        return message_misuse("--style: width=%s is not in 0.001..1000 mm", value);
    bool follows = pen->dash_mm == 12.0 * pen->width_mm && pen->gap_mm == 3.0 * pen->width_mm && pen->dash_mm > 0.0;
    pen->width_mm = width;
    if (follows) {
        pen->dash_mm = 12.0 * width;
        pen->gap_mm = 3.0 * width;
    }
    return EXIT_DONE;
}

/* One key=value, or a key alone. */
static int set_key(roberts_pen *pen, const char *item)
{
    static const char *const names[] = {"width", "color", "colour", "dash", "off", "on"};
    char key[64];
    bool fits;
    const char *value = take_word(item, '=', key, sizeof key, &fits);
    size_t i = find_word(key, names, COUNT(names));
    if (i == COUNT(names))
        return nearest_unknown("--style", key, names, COUNT(names), "as in outline:width=0.7,color=red");
    if ((i < 4) != (value != NULL))
        return message_misuse("--style: %s %s", key, i < 4 ? "needs a value" : "takes no value");
    switch (i) {
    case 0:
        return set_width(pen, value);
    case 1:
    case 2:
        return set_color(pen, value);
    case 3:
        return set_dashes(pen, value);
    default:
        pen->off = i == 4;
        return EXIT_DONE;
    }
}

int paper_set_style(roberts_draw_options *options, const char *value)
{
    static const char *const names[] = {"outline", "crease", "hidden", "frame", "symbol"};
    roberts_pen *const pens[] = {&options->outline, &options->crease, &options->back, &options->frame,
                                 &options->symbol};
    char word[64];
    bool fits;
    const char *rest = take_word(value, ':', word, sizeof word, &fits);
    size_t i = find_word(word, names, COUNT(names));
    int status = EXIT_DONE;
    if (!rest && (i < COUNT(names) || strchr(value, '=')))
        return message_misuse("--style: \"%s\" is not CLASS:key=value,..., as outline:width=0.7,color=red", value);
    if (i == COUNT(names))
        return nearest_unknown("--style", word, names, COUNT(names), NULL);
    if (strchr(rest, ':'))
        return message_misuse("--style: \"%s\": there is a comma between two values, as outline:width=0.7,color=red",
                              value);
    while (rest && status == EXIT_DONE) {
        rest = take_word(rest, ',', word, sizeof word, &fits);
        status = fits ? set_key(pens[i], word) : message_misuse("--style: \"%s...\" is too long", word);
    }
    return status;
}
