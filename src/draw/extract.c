/* extract.c - the path data in Cairo's SVG, brought to mm.
 *
 * Most of what a large drawing costs is Cairo's printf of "%f", twice a point. GNU's C library takes half of the time for
 * a number from 1 to 8: 85 ns, against 180 for three digits before the point, because there is no power of ten to look for,
 * and digits come off by multiplying instead of by long division. %f has six digits behind the point, and a page fewer than
 * 4 million units each way. So coordinates are handed to Cairo as 2 + unit / 1,000,000 (2 and not 1, so that what lies a unit
 * before the border is quick as well), and here they come back to whole units and are written in mm, exactly. Should a
 * version of Cairo round to fewer digits, the first point of a surface is not what was drawn, and that is an error. */
#include "draw/extract.h"

#include <string.h>

#include "draw/decimal.h"

enum {
    DIGITS_BEHIND = 6, /* of %f: EXTRACT_UNITS */
    DIGITS_BEFORE = 3, /* of a number that is understood; int32_t holds it in millionths */
};

static const uint32_t power_of_10[DIGITS_BEHIND + 1] = {1, 10, 100, 1000, 10000, 100000, 1000000};

void extract_surface(extract *e, page_point first)
{
    e->at = EXTRACT_BETWEEN;
    e->expected = first;
    e->begun = false;
}

/* ---- tags ---- */

static void name_start(extract *e, extract_place at)
{
    e->at = at;
    e->length = 0;
}

static void name_add(extract *e, unsigned char c)
{
    if (e->length < sizeof e->name)
        e->name[e->length++] = (char)c;
}

static bool name_is(const extract *e, const char *name)
{
    return e->length == strlen(name) && memcmp(e->name, name, e->length) == 0;
}

/* One byte, outside of path data. */
static void tag_byte(extract *e, unsigned char c)
{
    bool blank = c == ' ' || c == '\n';
    switch (e->at) {
    case EXTRACT_BETWEEN:
        if (c == '<')
            name_start(e, EXTRACT_NAME);
        break;
    case EXTRACT_NAME:
        if (c == '>')
            e->at = EXTRACT_BETWEEN;
        else if (blank)
            name_start(e, name_is(e, "path") ? EXTRACT_PATH : EXTRACT_TAG);
        else
            name_add(e, c);
        break;
    case EXTRACT_TAG:
        if (c == '>')
            e->at = EXTRACT_BETWEEN;
        break;
    case EXTRACT_PATH:
        if (c == '>')
            e->at = EXTRACT_BETWEEN;
        else if (c == '"' && name_is(e, "d="))
            e->at = EXTRACT_DATA;
        else if (c == '"')
            e->at = EXTRACT_VALUE;
        else if (blank)
            name_start(e, EXTRACT_PATH);
        else
            name_add(e, c);
        break;
    default: /* EXTRACT_VALUE */
        if (c == '"')
            name_start(e, EXTRACT_PATH);
    }
}

/* ---- path data ---- */

static void write_point(const extract *e, char command, page_point p)
{
    char *start = output_room(e->out), *at = start;
    *at++ = command;
    *at++ = ' ';
    at += decimal_fixed(at, p.x, e->decimals);
    *at++ = ' ';
    at += decimal_fixed(at, p.y, e->decimals);
    *at++ = ' ';
    output_took(e->out, (size_t)(at - start));
}

static void write_move(extract *e)
{
    if (e->moves)
        write_point(e, 'M', e->move);
    e->moves = false;
}

static void command_start(extract *e, char command)
{
    e->strange |= e->coordinates != 0 || (command != 'M' && command != 'L' && command != 'Z');
    e->command = command == 'Z' ? '\0' : command;
    if (command == 'Z') {
        write_move(e);
        output_text(e->out, "Z ");
    }
}

/* Behind a closed line Cairo goes to its start once more, as the start of another line; where none follows, that is not
 * passed on. */
static void point_end(extract *e)
{
    page_point p = {e->coordinate[0], e->coordinate[1]};
    if (!e->begun)
        e->strange |= p.x != e->expected.x || p.y != e->expected.y;
    e->begun = true;
    write_move(e);
    if (e->command == 'M') {
        e->move = p;
        e->moves = true;
    } else {
        write_point(e, 'L', p);
    }
    e->strange |= !e->command;
    e->command = '\0';
    e->coordinates = 0;
}

/* Back to page units. */
static void number_end(extract *e, extract_number n)
{
    int behind = n.behind < 0 ? 0 : n.behind;
    if (n.digits == 0 || n.digits - behind > DIGITS_BEFORE || behind > DIGITS_BEHIND) {
        e->strange = true;
        return;
    }
    int32_t value = (int32_t)(n.value * power_of_10[DIGITS_BEHIND - behind]);
    e->coordinate[e->coordinates++] = (n.minus ? -value : value) - EXTRACT_ORIGIN * EXTRACT_UNITS;
    if (e->coordinates == 2)
        point_end(e);
}

/* Reads path data up to the quote that ends them, or to `end`. */
static const unsigned char *data_bytes(extract *e, const unsigned char *at, const unsigned char *end)
{
    static const extract_number none = {.behind = -1};
    extract_number n = e->number;
    while (at < end && *at != '"') {
        const unsigned char *digits = at;
        for (uint32_t digit; at < end && (digit = (uint32_t)*at - '0') <= 9; at++)
            n.value = 10 * n.value + digit; /* too long a number is refused at its end */
        n.digits += (int)(at - digits);
        n.behind += n.behind >= 0 ? (int)(at - digits) : 0;
        if (at > digits)
            continue;
        if (*at == '.' && n.behind < 0) {
            n.behind = 0;
        } else if (*at == '-' && n.digits == 0) {
            n.minus = true;
        } else if (*at == ' ' && n.digits) {
            number_end(e, n);
            n = none;
        } else if (*at != ' ') {
            command_start(e, (char)*at);
        }
        at++;
    }
    e->number = n;
    return at;
}

static void data_start(extract *e)
{
    e->number = (extract_number){.behind = -1};
    e->coordinates = 0;
    e->moves = false;
    if (e->paths++)
        output_text(e->out, "\n");
}

static void data_end(extract *e)
{
    if (e->number.digits)
        number_end(e, e->number);
    e->strange |= e->coordinates != 0;
    name_start(e, EXTRACT_PATH);
}

void extract_bytes(extract *e, const unsigned char *bytes, size_t size)
{
    const unsigned char *end = bytes + size;
    while (bytes < end) {
        if (e->at == EXTRACT_DATA) {
            bytes = data_bytes(e, bytes, end);
            if (bytes == end)
                break;
            data_end(e);
        } else {
            tag_byte(e, *bytes);
            if (e->at == EXTRACT_DATA)
                data_start(e);
        }
        bytes++;
    }
}
