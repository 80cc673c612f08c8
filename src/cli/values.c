/* values.c - values of the options that name a view, a format or a mode, and of those that are vectors or numbers. */
#include "cli/values.h"

#include <float.h>
#include <inttypes.h>
#include <string.h>

#include "cli/message.h"
#include "cli/nearest.h"
#include "cli/parse.h"

enum { TURNTABLE_MOST = 100000 };

enum { FORMATS = ROBERTS_NULL + 1 };

static const char *const format_names[FORMATS] = {
    [ROBERTS_SVG] = "svg", [ROBERTS_PDF] = "pdf", [ROBERTS_PS] = "ps",     [ROBERTS_EPS] = "eps",
    [ROBERTS_PNG] = "png", [ROBERTS_CSV] = "csv", [ROBERTS_JSON] = "json", [ROBERTS_NULL] = "null",
};

const char *values_format_name(roberts_format format)
{
    return format_names[format];
}

int values_set_format(cli_options *options, const char *value)
{
    if (roberts_format_by_name(value, &options->draw.format))
        return EXIT_DONE;
    return nearest_unknown("--format", value, format_names, FORMATS, NULL);
}

int values_set_view(cli_options *options, const char *value)
{
    static const char *const names[] = {"iso",   "dimetric", "trimetric", "front",    "back",   "left",
                                        "right", "top",      "bottom",    "cavalier", "cabinet"};
    if (roberts_camera_preset(value, &options->camera))
        return EXIT_DONE;
    return nearest_unknown("--view", value, names, sizeof names / sizeof names[0], NULL);
}

int values_set_hidden(cli_options *options, const char *value)
{
    static const char *const names[] = {"none", "dashed", "solid"};
    static const roberts_hidden mode[] = {ROBERTS_HIDDEN_NONE, ROBERTS_HIDDEN_DASHED, ROBERTS_HIDDEN_SOLID};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strcmp(value, names[i]) == 0) {
            options->draw.hidden = mode[i];
            options->hide.keep_hidden = mode[i] != ROBERTS_HIDDEN_NONE;
            return EXIT_DONE;
        }
    return nearest_unknown("--hidden", value, names, sizeof names / sizeof names[0], NULL);
}

int values_set_stats(cli_options *options, const char *value)
{
    static const char *const names[] = {"json"};
    if (value && strcmp(value, names[0]) != 0)
        return nearest_unknown("--stats", value, names, 1, "or left out");
    options->stats = value ? STATS_JSON : STATS_TEXT;
    return EXIT_DONE;
}

int values_set_sheet(cli_options *options, const char *value)
{
    static const char *const names[] = {"first", "third"};
    options->is_sheet = true;
    options->sheet = strcmp(value, names[0]) == 0 ? ROBERTS_FIRST_ANGLE : ROBERTS_THIRD_ANGLE;
    return strcmp(value, names[options->sheet]) == 0 ? EXIT_DONE : nearest_unknown("--sheet", value, names, 2, NULL);
}

int values_set_fill_rule(cli_options *options, const char *value)
{
    static const char *const names[] = {"nonzero", "evenodd"};
    options->scene.even_odd = strcmp(value, names[1]) == 0;
    return strcmp(value, names[options->scene.even_odd]) == 0 ? EXIT_DONE
                                                              : nearest_unknown("--fill-rule", value, names, 2, NULL);
}

int values_set_vector(const char *name, const char *value, roberts_vec3 *vector)
{
    if (parse_vector(value, vector))
        return EXIT_DONE;
    return message_misuse("--%s: \"%s\" is not X,Y,Z (three numbers, point for decimals)", name, value);
}

static int set_point(const char *name, const char *value, roberts_vec2 *point)
{
    if (parse_point(value, point))
        return EXIT_DONE;
    return message_misuse("--%s: \"%s\" is not X,Y (two numbers, point for decimals)", name, value);
}

/* A vector that has to point somewhere. */
int values_set_direction(const char *name, const char *value, roberts_vec3 *vector)
{
    int status = values_set_vector(name, value, vector);
    if (status == EXIT_DONE && vector->x == 0.0 && vector->y == 0.0 && vector->z == 0.0)
        return message_misuse("--%s: 0,0,0 is no direction", name);
    return status;
}

int values_set_number_between(const char *name, const char *value, double min, double max, double *number)
{
    if (!parse_number(value, number))
        return message_misuse("--%s: \"%s\" is not a number", name, value);
    if (*number < min && max == DBL_MAX)
        return message_misuse("--%s: %s is less than %g", name, value, min);
    if (!(*number >= min && *number <= max))
        return message_misuse("--%s: %s is not in %g..%g", name, value, min, max);
    return EXIT_DONE;
}

int values_set_number(const char *name, const char *value, double max, double *number)
{
    return values_set_number_between(name, value, 0.0, max, number);
}

int values_set_length(const char *name, const char *value, double max, double *mm)
{
    if (!parse_length(value, mm))
        return message_misuse("--%s: \"%s\" is not a length in mm, or with cm, in or pt behind it", name, value);
    if (!(*mm >= 0.0 && *mm <= max))
        return message_misuse("--%s: %s is not in 0..%g mm", name, value, max);
    return EXIT_DONE;
}

int values_set_integer(const char *name, const char *value, uint32_t min, uint32_t max, uint32_t *number)
{
    if (!parse_integer(value, number))
        return message_misuse("--%s: \"%s\" is not a whole number from %" PRIu32 " to %" PRIu32, name, value, min, max);
    if (*number < min || *number > max)
        return message_misuse("--%s: %s is not in %" PRIu32 "..%" PRIu32, name, value, min, max);
    return EXIT_DONE;
}

/* A range without its lower end, 0, of which `why` tells what it would do. */
static int set_number_above_zero(const char *name, const char *value, double max, const char *why, double *number)
{
    if (!parse_number(value, number))
        return message_misuse("--%s: \"%s\" is not a number", name, value);
    if (!(*number > 0.0 && *number <= max))
        return message_misuse("--%s: %s %s; it takes a number above 0, up to %g", name, value,
                              *number == 0.0 ? why : "is out of range", max);
    return EXIT_DONE;
}

int values_set_angle_of_view(const char *value, double *degrees)
{
    return set_number_above_zero("fov", value, 179.0, "shows nothing", degrees);
}

int values_set_resolution(const char *value, double *dpi)
{
    return set_number_above_zero("dpi", value, 100000.0, "gives no image", dpi);
}

int values_set_rays(const char *value, uint32_t *rays)
{
    if (parse_integer(value, rays) && *rays == 0)
        return message_misuse("--verify: 0 rays check nothing; it takes 1 or more (3 where none is given)");
    return values_set_integer("verify", value, 1, UINT32_MAX, rays);
}

int values_add_pick(cli_options *options, const char *value)
{
    if (options->pick_count == PICKS_MOST)
        return message_misuse("--pick: %d points are the most", PICKS_MOST);
    return set_point("pick", value, &options->pick[options->pick_count++]);
}

int values_set_turntable(const char *value, uint32_t *number)
{
    return values_set_integer("turntable", value, 1, TURNTABLE_MOST, number);
}
