/* options.c - from the arguments to the options.
 *
 * GNU habits without GNU functions: --name=value and --name value, -ovalue and -o value, -qo value, operands anywhere,
 * everything after -- is an operand. A value may begin with a minus (--dir -1,2,3). */
#include "cli/options.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "cli/check.h"
#include "cli/hints.h"
#include "cli/message.h"
#include "cli/parse.h"

/* ---- the description ---- */

/* Room for the dots. */
enum { DOTS = 4 };

static void add(description *d, const char *text, size_t length)
{
    if (d->is_full)
        return;
    if (length + DOTS >= sizeof d->text - d->length) {
        d->is_full = true;
        text = " ...";
        length = DOTS;
    }
    memcpy(d->text + d->length, text, length);
    d->length += length;
    d->text[d->length] = '\0';
}

/* In quotes if a shell would interpret it; a quote itself stands outside them: 'it'\''s'. */
static void add_quoted(description *d, const char *word)
{
    static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=./,:@%";
    if (*word && word[strspn(word, plain)] == '\0') {
        add(d, word, strlen(word));
        return;
    }
    add(d, "'", 1);
    for (; *word; word++)
        if (*word == '\'')
            add(d, "'\\''", 4);
        else
            add(d, word, 1);
    add(d, "'", 1);
}

void description_word(description *d, const char *word)
{
    if (d->length)
        add(d, " ", 1);
    if (word[0] == '-' && word[1]) /* a file, and no option */
        add(d, "./", 2);
    add_quoted(d, word);
}

/* --name or --name=value. */
static void describe_option(description *d, const char *name, const char *value)
{
    add(d, " --", 3);
    add(d, name, strlen(name));
    if (value) {
        add(d, "=", 1);
        add_quoted(d, value);
    }
}

/* ---- one option ---- */

typedef struct parser {
    cli_options *options;
    options_given given;
    int argc;
    char **argv;
} parser;

static int apply(parser *p, const option *o, const char *value)
{
    int status = o->set ? o->set(o, value, p->options) : EXIT_DONE;
    p->given.row[o - p->given.table->row] = true;
    if (status == EXIT_DONE && (o->flags & OPTION_DRAWS))
        describe_option(&p->options->description, o->name, value);
    return status;
}

/* The option called `name`, which has `length` letters, or NULL. */
static const option *find_option(const option_table *table, const char *name, size_t length)
{
    for (const option *o = table->row; o < table->row + table->count; o++)
        if (strlen(o->name) == length && strncmp(o->name, name, length) == 0)
            return o;
    return NULL;
}

static const option *find_letter(const option_table *table, char letter)
{
    for (const option *o = table->row; o < table->row + table->count; o++)
        if (o->letter == letter)
            return o;
    return NULL;
}

/* Suggests the option that was meant: one with a similar name, one that has this name in other programs, or one with
 * this value. */
static int unknown_option(const option_table *table, const char *name)
{
    const char *words[OPTIONS_MOST + 1] = {NULL}, *meant = hint_option(name);
    roberts_camera camera;
    roberts_format format;
    for (size_t i = 0; i < table->count; i++)
        words[i] = table->row[i].name;
    if (!meant)
        meant = hint_word(name, words);
    if (meant)
        return message_misuse("--%s is unknown; did you mean --%s?", name, meant);
    if (roberts_camera_preset(name, &camera))
        return message_misuse("--%s is unknown; did you mean --view %s?", name, name);
    if (roberts_format_by_name(name, &format))
        return message_misuse("--%s is unknown; did you mean -f %s?", name, name);
    return message_misuse("--%s is unknown", name);
}

/* Is it the end of all options, or a long one? Then it is hardly meant as a value. */
static bool is_option(const option_table *table, const char *word)
{
    return strncmp(word, "--", 2) == 0 && (!word[2] || find_option(table, word + 2, strcspn(word + 2, "=")));
}

/* Applies an option, given as `shown`, with the next argument as its value. */
static int apply_next(parser *p, int *i, const option *o, const char *shown)
{
    if (*i + 1 >= p->argc)
        return message_misuse("%s needs a value", shown);
    const char *value = p->argv[++*i];
    if (is_option(p->given.table, value))
        return message_misuse("%s needs a value, but %s follows; to have that as its value: --%s=%s", shown, value,
                              o->name, value);
    return apply(p, o, value);
}

/* Refuses the word `shown`, which begins with a minus. Its letter at `letter` is no option; if that is the first one,
 * the whole word is none. The word may be the name of a file. */
static int unknown_word(const char *shown, const char *letter)
{
    const bool there = access(shown, F_OK) == 0;
    const char *but = there ? "; the file of this name is ./" : "", *name = there ? shown : "";
    if (letter > shown + 1)
        return message_misuse("%s: -%c is unknown%s%s", shown, *letter, but, name);
    return message_misuse("%s is unknown%s%s", shown, but, name);
}

/* argv[*i] is --name or --name=value; `*i` moves to the last argument that is used. */
static int take_long(parser *p, int *i)
{
    const char *name = p->argv[*i] + 2, *equals = strchr(name, '=');
    size_t length = equals ? (size_t)(equals - name) : strlen(name);
    const char *value = equals ? equals + 1 : NULL;
    const option *o = find_option(p->given.table, name, length);
    if (!o && access(p->argv[*i], F_OK) == 0)
        return unknown_word(p->argv[*i], p->argv[*i] + 1);
    if (!o) {
        char word[64];
        snprintf(word, sizeof word, "%.*s", length < sizeof word ? (int)length : (int)sizeof word - 1, name);
        return unknown_option(p->given.table, word);
    }
    if (value && !o->value)
        return message_misuse("--%s takes no value", o->name);
    if (!value && o->value && !(o->flags & OPTION_OPTIONAL))
        return apply_next(p, i, o, p->argv[*i]);
    return apply(p, o, value);
}

/* argv[*i] is -x, -xyz or -xvalue; as above. One minus before a long name is a slip, and misuse. */
static int take_short(parser *p, int *i)
{
    const char *word = p->argv[*i] + 1;
    if (word[1] && find_option(p->given.table, word, strcspn(word, "=")))
        return message_misuse("-%s is unknown; did you mean --%s?", word, word);
    for (const char *letter = word; *letter; letter++) {
        const option *o = find_letter(p->given.table, *letter);
        int status;
        if (!o)
            return unknown_word(p->argv[*i], letter);
        if (!o->value) {
            if ((status = apply(p, o, NULL)) != EXIT_DONE)
                return status;
            continue;
        }
        if (letter[1] == '=')
            return message_misuse("-%s: only long options have \"=\"; did you mean -%c %s?", word, *letter, letter + 2);
        if (letter[1])
            return apply(p, o, letter + 1);
        return apply_next(p, i, o, (const char[]){'-', *letter, '\0'});
    }
    return EXIT_DONE;
}

/* Refuses an operand that is no file, but was meant as an option, or as the value of the option before it, which takes
 * one only after "=". */
static int misplaced_value(const option_table *table, const char *before, const char *operand)
{
    const option *o = strncmp(before, "--", 2) == 0 ? find_option(table, before + 2, strlen(before + 2)) : NULL;
    uint32_t number;
    if (find_option(table, operand, strlen(operand)) && access(operand, F_OK) != 0)
        return message_misuse("%s: there is no such file; did you mean --%s?", operand, operand);
    if (!o || !(o->flags & OPTION_OPTIONAL))
        return EXIT_DONE;
    bool meant = !o->words && parse_integer(operand, &number);
    for (size_t i = 0; o->words && o->words[i]; i++)
        meant = meant || strcmp(operand, o->words[i]) == 0;
    if (!meant || access(operand, F_OK) == 0)
        return EXIT_DONE;
    return message_misuse("%s: there is no such file; did you mean --%s=%s?", operand, o->name, operand);
}

/* Moves operands to the front of argv; their number goes to `*operands`. */
static int take_all(parser *p, int *operands)
{
    bool only_operands = false;
    int status = EXIT_DONE;
    for (int i = 1; i < p->argc && status == EXIT_DONE; i++) {
        const char *word = p->argv[i];
        if (only_operands || word[0] != '-' || word[1] == '\0') {
            if (!only_operands)
                status = misplaced_value(p->given.table, i > 1 ? p->argv[i - 1] : "", word);
            p->argv[(*operands)++] = p->argv[i];
        } else if (strcmp(word, "--") == 0) {
            only_operands = true;
        } else {
            status = (word[1] == '-' ? take_long : take_short)(p, &i);
        }
    }
    return status;
}

/* ---- all together ---- */

bool options_is_given(const options_given *given, const char *name)
{
    const option *o = find_option(given->table, name, strlen(name));
    return o && given->row[o - given->table->row];
}

/* Whether `name` is one of the words of `list`, which may be NULL. */
static bool has_word(const char *list, const char *name)
{
    const size_t length = strlen(name);
    for (const char *at = list; at && *at; at += strspn(at, " ")) {
        const size_t size = strcspn(at, " ");
        if (size == length && strncmp(at, name, length) == 0)
            return true;
        at += size;
    }
    return false;
}

bool option_excludes(const option *a, const option *b)
{
    return has_word(a->excludes, b->name) || has_word(b->excludes, a->name);
}

static int check_excludes(const options_given *given)
{
    const option *row = given->table->row;
    for (size_t i = 0; i < given->table->count; i++)
        for (size_t j = 0; j < given->table->count; j++)
            if (given->row[i] && given->row[j] && has_word(row[i].excludes, row[j].name))
                return message_misuse("--%s and --%s exclude each other", row[i].name, row[j].name);
    return EXIT_DONE;
}

static int check_needs(const options_given *given)
{
    const option_table *table = given->table;
    for (size_t i = 0; i < table->count; i++) {
        const option *o = &table->row[i];
        bool has = !given->row[i] || !o->needs;
        for (size_t j = 0; j < table->count && !has; j++)
            has = given->row[j] && has_word(o->needs, table->row[j].name);
        if (!has)
            return message_misuse("--%s needs --%.*s", o->name, (int)strcspn(o->needs, " "), o->needs);
    }
    return EXIT_DONE;
}

/* Without -f, the ending of the output's name decides the format; without an ending it is SVG. */
static int choose_format(const options_given *given, cli_options *options)
{
    const char *slash = strrchr(options->output, '/'), *name = slash ? slash + 1 : options->output;
    if (options->plan || options->part.of)
        return EXIT_DONE; /* no drawing */
    if (!options_is_given(given, "format") && !roberts_format_by_path(options->output, &options->draw.format) &&
        strchr(name + (*name == '.'), '.'))
        return message_misuse("%s: no format has this ending (.svg, .pdf, .ps, .eps, .png, .tikz, .tex, .dxf, "
                              ".hpgl, .plt, .csv and .json are known); "
                              "name the format with -f",
                              options->output);
    return EXIT_DONE;
}

/* Applies the options of the camera. Their order does not matter. */
static void set_camera(const options_given *given, cli_options *options)
{
    roberts_camera *camera = &options->camera;
    if (options_is_given(given, "azimuth") || options_is_given(given, "elevation"))
        roberts_camera_angles(options->azimuth, options->elevation, 0.0, camera);
    if (options_is_given(given, "up"))
        camera->up = options->up;
    camera->section = options->section[0];
    camera->section_normal = options->section[1];
    camera->has_section = options_is_given(given, "section");
    camera->roll_degrees = options->roll;
}

/* A title block names a scale of ISO 5455, unless --scale or --fit ask for another one. */
static void choose_scale(const options_given *given, cli_options *options)
{
    const bool block = options_is_given(given, "title") || options_is_given(given, "field");
    if (options->is_sheet && block && !options_is_given(given, "scale") && !options_is_given(given, "fit"))
        options->draw.placement.standard = true;
}

/* The longer side becomes horizontal, in whatever order --landscape and --page came. */
static void lay_down(roberts_page *page)
{
    if (page->width_mm < page->height_mm) {
        double width = page->width_mm;
        page->width_mm = page->height_mm;
        page->height_mm = width;
    }
}

/* A command in a description needs the name of a turntable's pictures, without the folder. */
static void describe_files(cli_options *options, size_t operands)
{
    const char *slash = strrchr(options->output, '/');
    if (options->turntable)
        describe_option(&options->description, "output", slash ? slash + 1 : options->output);
    for (size_t i = 0; i < operands && !options->batch && !options->join; i++)
        description_word(&options->description, options->input[i]);
}

int options_parse(const option_table *table, int argc, char **argv, cli_options *options)
{
    static char standard_input[] = "-";
    static char *nothing_named[] = {standard_input};
    parser p = {.options = options, .given = {.table = table}, .argc = argc, .argv = argv};
    const options_given *given = &p.given;
    int status, operands = 0;
    *options =
        (cli_options){.output = "-", .hide = roberts_hide_options_default(), .draw = roberts_draw_options_default()};
    roberts_camera_preset("iso", &options->camera);
    description_word(&options->description, "roberts");
    if ((status = take_all(&p, &operands)) != EXIT_DONE)
        return status;
    options->input = operands || options->list ? argv : nothing_named;
    options->input_count = operands || options->list ? (size_t)operands : 1;
    if (options->landscape)
        lay_down(&options->draw.page);
    describe_files(options, (size_t)operands);
    if (options->help || options->version)
        return EXIT_DONE;
    if ((status = check_excludes(given)) != EXIT_DONE || (status = check_folder(options)) != EXIT_DONE ||
        (status = choose_format(given, options)) != EXIT_DONE || (status = check_format(options)) != EXIT_DONE ||
        (status = check_needs(given)) != EXIT_DONE || (status = check_options(options, given)) != EXIT_DONE)
        return status;
    choose_scale(given, options);
    set_camera(given, options);
    check_warn(options, given);
    return EXIT_DONE;
}
