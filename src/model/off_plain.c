/* off_plain.c - plain lines, with everything written out in two loops: this is where reading spends its time. */
#include "model/off_plain.h"

#include <math.h>

#include "base/number.h"
#include "model/mesh.h"

static inline bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

const char *plain_next_line(const char *at)
{
    while (is_blank(*at))
        at++;
    at += *at == '\r';
    return *at == '\n' ? at + 1 : NULL;
}

/* The first character of the next line that is no blank; NULL where the line does not end here. */
BITS_INLINE const char *begin_line(const char *at)
{
    const char *c = *at == '\n' ? at + 1 : plain_next_line(at);
    while (c && is_blank(*c))
        c++;
    return c;
}

/* The next token of the line; where there is none or no blank before it, something that is not plain. */
BITS_INLINE const char *next_token(const char *at)
{
    const char *c = at + (*at == ' ');
    if ((unsigned char)*c <= ' ') {
        while (is_blank(*c))
            c++;
    }
    return c == at ? NULL : c;
}

static inline bool line_ends(const char *at)
{
    return *at == '\n' || plain_next_line(at);
}

/* Any number, that is one in some hundred; NULL where it is none, or too large a coordinate. */
BITS_RARE static const char *any_coordinate(const char *c, double *value)
{
    c = number_parse(c, value);
    return c && fabs(*value) <= MESH_COORDINATE_MAX ? c : NULL;
}

BITS_INLINE const char *coordinate(const char *c, number_guess *guess, double *value)
{
    const char *end = number_usual(c, guess, value); /* which is far below MESH_COORDINATE_MAX */
    return end && (*end | 0x20) != 'e' ? end : any_coordinate(c, value);
}

const char *plain_vertices(const char *at, roberts_vec3 *vertex, size_t room, size_t *count)
{
    number_guess guess[3] = {number_guess_digits(8), number_guess_digits(8), number_guess_digits(8)};
    size_t n = 0;
    for (; n < room; n++) {
        roberts_vec3 p;
        const char *c = begin_line(at);
        if (!c || !(c = coordinate(c, &guess[0], &p.x)) || !(c = next_token(c)) ||
            !(c = coordinate(c, &guess[1], &p.y)) || !(c = next_token(c)) || !(c = coordinate(c, &guess[2], &p.z)) ||
            !line_ends(c))
            break;
        vertex[n] = p;
        at = c;
    }
    *count = n;
    return at;
}

/* Reads `count` vertex numbers; NULL where one is not plain or out of range. */
BITS_INLINE const char *read_corners(const char *c, const plain_faces *f, number_guess *guess, uint32_t *corner,
                                     uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        c = next_token(c);
        if (!c)
            return NULL;
        uint64_t chunk = bits_load(c) ^ NUMBER_DIGITS;
        int digits = number_guessed_count(chunk, guess);
        if (digits == 0)
            return NULL; /* and a ninth digit is no blank */
        uint32_t index = (uint32_t)number_eight_digits(chunk << (64 - 8 * digits));
        if (index >= f->limit)
            return NULL;
        corner[i] = f->first + index;
        c += digits;
    }
    return c;
}

const char *plain_read_faces(const char *at, plain_faces *faces)
{
    number_guess guess = number_guess_digits(1);
    plain_faces f = *faces; /* whose numbers then need not be written with each corner */
    while (f.count < f.room) {
        const char *c = begin_line(at);
        if (!c)
            break;
        uint32_t count = (uint32_t)(unsigned char)*c - '0';
        int digits = 1;
        if (count > 9 || c[1] != ' ')
            digits = number_short_integer(c, &count);
        if (digits == 0 || count == 0 || count > PLAIN_CORNERS || count > f.corner_room - f.corner_count)
            break;
        c = read_corners(c + digits, &f, &guess, f.corner + f.corner_count, count);
        if (!c || !line_ends(c))
            break;
        f.corner_count += count;
        f.end[f.count++] = (uint32_t)f.corner_count;
        f.thin += count < 3;
        at = c;
    }
    *faces = f;
    return at;
}
