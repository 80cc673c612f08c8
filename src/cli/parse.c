/* parse.c - numbers, lengths and words in text. The program never sets a locale, so strtod() takes a decimal point. */
#include "cli/parse.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Reads one number at `*at`, which moves past it. strtod() would also accept blanks, inf, nan and 0x10. */
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

/* A finite number, perhaps followed by mm, cm, in or pt (1/72 inch); `*unit_mm` is 0 without a unit. */
static bool parse_measure(const char *text, double *number, double *unit_mm)
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

bool parse_numbers(const char *text, double *number, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if ((i > 0 && *text++ != ',') || !take_number(&text, &number[i]))
            return false;
    return *text == '\0';
}

const char *parse_word(const char *text, char end, char *word, size_t size, bool *fits)
{
    const char *stop = strchr(text, end);
    size_t length = stop ? (size_t)(stop - text) : strlen(text);
    *fits = length < size;
    snprintf(word, size, "%.*s", (int)(*fits ? length : size - 1), text);
    return stop ? stop + 1 : NULL;
}

bool parse_ratio(const char *value, double *a, double *b)
{
    char word[64];
    bool fits;
    const char *second = parse_word(value, ':', word, sizeof word, &fits);
    return second && fits && parse_number(word, a) && parse_number(second, b);
}

bool parse_lengths(const char *value, char sign, double *a_mm, double *b_mm)
{
    char word[64];
    bool fits;
    double a, b, unit_a, unit_b;
    const char *second = parse_word(value, sign, word, sizeof word, &fits);
    if (!second || !fits || !parse_measure(word, &a, &unit_a) || !parse_measure(second, &b, &unit_b))
        return false;
    const double unit = unit_b > 0.0 ? unit_b : unit_a > 0.0 ? unit_a : 1.0;
    *a_mm = a * (unit_a > 0.0 ? unit_a : unit);
    *b_mm = b * unit;
    return true;
}

bool parse_has_ending(const char *name, const char *ending)
{
    const char *dot = strrchr(name, '.');
    return dot && strcasecmp(dot, ending) == 0;
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

bool parse_named(const char *pattern, const char *word, char *name, size_t size)
{
    const char *place = strchr(pattern, '%');
    if (!place || place[1] != 's' || strchr(place + 1, '%'))
        return false;
    int length = snprintf(name, size, "%.*s%s%s", (int)(place - pattern), pattern, word, place + 2);
    return length >= 0 && (size_t)length < size;
}

size_t parse_find(const char *word, const char *const *words)
{
    size_t i = 0;
    while (words[i] && strcmp(word, words[i]) != 0)
        i++;
    return i;
}
