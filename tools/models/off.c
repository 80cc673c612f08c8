/* off.c - writes OFF text with our own number formatting, several times as fast as printf: scenes of a million solids
 * contain about twenty million coordinates. */
#include "off.h"

#include <math.h>
#include <string.h>

enum { NUMBER_MAX = 32 }; /* longer than any number written */

static void flush(off_writer *w)
{
    if (fwrite(w->buffer, 1, w->fill, w->file) != w->fill)
        w->failed = true;
    w->fill = 0;
}

static char *room(off_writer *w)
{
    if (w->fill + NUMBER_MAX > sizeof w->buffer)
        flush(w);
    return w->buffer + w->fill;
}

static void put_char(off_writer *w, char c)
{
    *room(w) = c;
    w->fill++;
}

static size_t count_text(char *to, uint64_t n)
{
    char digit[20];
    size_t count = 0;
    do
        digit[count++] = (char)('0' + n % 10);
    while (n /= 10);
    for (size_t i = 0; i < count; i++)
        to[i] = digit[count - 1 - i];
    return count;
}

static void put_count(off_writer *w, uint64_t n)
{
    w->fill += count_text(room(w), n);
}

/* Computes a * b = product + *error exactly (Dekker 1971), unless something overflows or underflows. */
static double exact_product(double a, double b, double *error)
{
    const double split = 134217729.0; /* 2^27 + 1 */
    double p = a * b, ca = split * a, cb = split * b;
    double ah = ca - (ca - a), bh = cb - (cb - b), al = a - ah, bl = b - bh;
    *error = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
    return p;
}

/* Returns the 17 leading decimal digits of v > 0 as an integer, rounded to nearest with ties to even, such that v is
 * about digits / 10^places; 0: this shortcut does not apply. 10^places is a double up to places = 22, so the product is
 * exact in two parts, of which the first is an even integer from 1e16 on. */
static uint64_t seventeen_digits(double v, int *places)
{
    static const double ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9, 1e10,
                                 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20};
    double product, error;
    int k = 16;
    if (!(v >= 1e-4 && v < 1e15))
        return 0;
    while (v * ten[k] >= 1e17)
        k--;
    while (v * ten[k] < 1e16)
        k++;
    product = exact_product(v, ten[k], &error);
    error = rint(error);
    if (product < 1e16 || (product == 1e16 && error <= 0) || product + error >= 1e17)
        return 0;
    *places = k;
    return (uint64_t)((int64_t)product + (int64_t)error);
}

/* Writes digits / 10^places without trailing zeros. */
static size_t decimal_text(char *to, uint64_t digits, int places)
{
    char text[20];
    size_t whole = places < 17 ? (size_t)(17 - places) : 0, zeros = places > 17 ? (size_t)(places - 17) : 0, used = 17;
    size_t at = 0;
    count_text(text, digits);
    while (used > whole && text[used - 1] == '0')
        used--;
    memcpy(to, text, whole);
    at = whole;
    if (!whole)
        to[at++] = '0';
    if (used == whole)
        return at;
    to[at++] = '.';
    memset(to + at, '0', zeros);
    at += zeros;
    memcpy(to + at, text + whole, used - whole);
    return at + used - whole;
}

static void put_number(off_writer *w, double v)
{
    char *to = room(w), *start = to;
    double size = fabs(v);
    int places = 0;
    uint64_t digits;
    if (v < 0)
        *to++ = '-';
    if (size < 1e15 && size == floor(size))
        to += count_text(to, (uint64_t)size);
    else if ((digits = seventeen_digits(size, &places)) != 0)
        to += decimal_text(to, digits, places);
    else
        to = start + snprintf(start, NUMBER_MAX, "%.17g", v);
    w->fill += (size_t)(to - start);
}

static void put_text(off_writer *w, const char *text)
{
    while (*text)
        put_char(w, *text++);
}

void off_begin(off_writer *w, FILE *file, const char *comment, uint64_t vertex_count, uint64_t face_count)
{
    w->file = file;
    w->fill = 0;
    w->failed = false;
    put_text(w, "OFF\n# ");
    for (; *comment; comment++) {
        put_char(w, *comment);
        if (*comment == '\n')
            put_text(w, "# ");
    }
    put_char(w, '\n');
    put_count(w, vertex_count);
    put_char(w, ' ');
    put_count(w, face_count);
    put_text(w, " 0\n");
}

void off_vertices(off_writer *w, const body *b)
{
    for (size_t i = 0; i < b->vertex_count; i++) {
        put_number(w, b->vertex[i].x);
        put_char(w, ' ');
        put_number(w, b->vertex[i].y);
        put_char(w, ' ');
        put_number(w, b->vertex[i].z);
        put_char(w, '\n');
    }
}

void off_faces(off_writer *w, const body *b, uint64_t base)
{
    size_t i = 0;
    for (size_t f = 0; f < b->face_count; f++) {
        put_count(w, b->face_end[f] - i);
        for (; i < b->face_end[f]; i++) {
            put_char(w, ' ');
            put_count(w, base + b->corner[i]);
        }
        for (int shift = 16; b->color && shift >= 0; shift -= 8) {
            put_char(w, ' ');
            put_count(w, b->color[f] >> shift & 255);
        }
        put_char(w, '\n');
    }
}

bool off_end(off_writer *w)
{
    flush(w);
    if (fflush(w->file) != 0)
        w->failed = true;
    return !w->failed;
}
