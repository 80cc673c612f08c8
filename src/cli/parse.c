/* parse.c - values of options. The program never sets a locale, so strtod() knows the point alone. */
#include "cli/parse.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Reads one number at `*at`, which moves behind it. strtod() would also take blanks, inf, nan and 0x10. */
static bool take_number(const char **at, double *number)
{
    char *end;
    size_t length = strspn(*at, "+-.0123456789eE");
    if (length == 0 || strchr("eE", **at))
        return false;
    *number = strtod(*at, &end);
    if (end != *at + length || !isfinite(*number))
        return false;
    *at = end;
    return true;
}

bool parse_number(const char *text, double *number)
{
    double value;
    if (!take_number(&text, &value) || *text)
        return false;
    *number = value;
    return true;
}

bool parse_measure(const char *text, double *number, double *unit_mm)
{
    static const struct {
        const char *name;
        double mm;
    } units[] = {{"", 0.0}, {"mm", 1.0}, {"cm", 10.0}, {"in", 25.4}, {"pt", 25.4 / 72.0}};
    double value;
    if (!take_number(&text, &value))
        return false;
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++)
        if (strcasecmp(text, units[i].name) == 0) {
            *number = value;
            *unit_mm = units[i].mm;
            return true;
        }
    return false;
}

bool parse_length(const char *text, double *mm)
{
    double number, unit_mm;
    if (!parse_measure(text, &number, &unit_mm))
        return false;
    *mm = unit_mm > 0.0 ? number * unit_mm : number;
    return true;
}

bool parse_integer(const char *text, uint32_t *number)
{
    uint64_t value = 0;
    if (!*text)
        return false;
    for (; *text; text++) {
        if (*text < '0' || *text > '9')
            return false;
        value = value * 10 + (uint64_t)(*text - '0');
        if (value > UINT32_MAX)
            return false;
    }
    *number = (uint32_t)value;
    return true;
}

bool parse_point(const char *text, roberts_vec2 *point)
{
    roberts_vec2 p;
    if (!take_number(&text, &p.x) || *text++ != ',')
        return false;
    if (!take_number(&text, &p.y) || *text)
        return false;
    *point = p;
    return true;
}

bool parse_vector(const char *text, roberts_vec3 *vector)
{
    roberts_vec3 v;
    if (!take_number(&text, &v.x) || *text++ != ',')
        return false;
    if (!take_number(&text, &v.y) || *text++ != ',')
        return false;
    if (!take_number(&text, &v.z) || *text)
        return false;
    *vector = v;
    return true;
}

bool parse_numbered(const char *pattern, uint32_t number, char *name, size_t size)
{
    const char *place = strchr(pattern, '%'), *at = place;
    int width = 0;
    if (!place)
        return false;
    if (*++at == '0' && at[1] >= '1' && at[1] <= '9') {
        width = at[1] - '0';
        at += 2;
    }
    if (*at != 'd' || strchr(at, '%'))
        return false;
    int length = snprintf(name, size, "%.*s%0*" PRIu32 "%s", (int)(place - pattern), pattern, width, number, at + 1);
    return length >= 0 && (size_t)length < size;
}
