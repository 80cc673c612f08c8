/* off_plain.c - plain lines, with everything written out in two loops: this is where reading spends its time. */
#include "model/off_plain.h"

#include "base/number.h"
#include "model/mesh.h"

static inline bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static inline const char *pass_blanks(const char *at)
{
    while (is_blank(*at))
        at++;
    return at;
}

const char *plain_next_line(const char *at)
{
    at = pass_blanks(at);
    at += *at == '\r';
    return *at == '\n' ? at + 1 : NULL;
}

/* The first character of the next line that is no blank; NULL where the line does not end here. */
BITS_INLINE const char *begin_line(const char *at)
{
    const char *c = *at == '\n' ? at + 1 : plain_next_line(at);
    return c && (unsigned char)*c <= ' ' ? pass_blanks(c) : c;
}

static inline bool line_ends(const char *at)
{
    return *at == '\n' || plain_next_line(at);
}

/* Any number, that is one in some hundred; NULL where it is none, or too large a coordinate. */
BITS_RARE static const char *any_coordinate(const char *c, double *value)
{
    c = number_parse(c, value);
    return c && (unsigned char)*c <= ' ' && mesh_coordinate(*value) ? c : NULL;
}

/* Reads a coordinate and goes to the next token of the line; at the end of the line stays there. */
BITS_INLINE const char *coordinate(const char *c, number_guess *guess, double *value)
{
    const char *end = number_usual(c, guess, value); /* which is far below MESH_COORDINATE_MAX */
    if (!end || (unsigned char)*end > ' ')
        end = any_coordinate(c, value);
    if (!end)
        return NULL;
    return *end == ' ' && (unsigned char)end[1] > ' ' ? end + 1 : pass_blanks(end);
}

const char *plain_vertices(const char *at, roberts_vec3 *vertex, size_t room, size_t *count)
{
    number_guess guess[3] = {number_guess_digits(8), number_guess_digits(8), number_guess_digits(8)};
    size_t n = 0;
    for (; n < room; n++) {
        roberts_vec3 *p = &vertex[n];
        const char *c = begin_line(at);
        if (!c || !(c = coordinate(c, &guess[0], &p->x)) || !(c = coordinate(c, &guess[1], &p->y)) ||
            !(c = coordinate(c, &guess[2], &p->z)) || !line_ends(c))
            break;
        at = c;
    }
    *count = n;
    return at;
}

/* Where the next vertex number is not as long as the last one, after one blank: its place, and the guess for it; NULL where
 * there is none. */
BITS_RARE static const char *guess_again(const char *at, number_guess *guess)
{
    const char *c = pass_blanks(at);
    int digits = number_digit_count(bits_load(c) ^ NUMBER_DIGITS);
    if (c == at || digits == 0)
        return NULL;
    *guess = number_guess_digits(digits);
    return c;
}

/* Reads `count` vertex numbers; NULL where one is not plain or out of range. */
BITS_INLINE const char *read_corners(const char *at, const plain_faces *f, number_guess *guess, uint32_t *corner,
                                     uint32_t count)
{
    const uint32_t first = f->first, limit = f->limit;
    for (const uint32_t *end = corner + count; corner < end; corner++) {
        const char *c = at + 1;
        uint64_t chunk = bits_load(c) ^ NUMBER_DIGITS;
        if (!number_guess_right(chunk, guess) || *at != ' ') {
            c = guess_again(at, guess);
            if (!c)
                return NULL;
            chunk = bits_load(c) ^ NUMBER_DIGITS;
        }
        uint32_t index = (uint32_t)number_eight_digits(chunk << (64 - 8 * guess->digits));
        if (index >= limit)
            return NULL;
        *corner = first + index;
        at = c + guess->digits; /* where a ninth digit is no blank */
    }
    return at;
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
