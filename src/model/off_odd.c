/* off_odd.c - which line of a text is not as its header says, or not as the lines before it.
 *
 * OFF is read word by word, so that a number that is missing is missed where the words do not make sense any more, which
 * may be far behind. But most files have a vertex or a face on each line: then words that are too few or too many are to be
 * seen in their line, and a header that tells another number of vertices in the line that comes too early or too late.
 * What may be laid out freely is not claimed to be odd. */
#include "model/off_odd.h"

#include <stdio.h>

enum { POSITION = 3, NORMAL = 3, TEXTURE = 2 };

static unsigned least_words(const off_header *h)
{
    return POSITION + (h->homogeneous ? 1 : 0) + (h->normal ? NORMAL : 0) + (h->texture ? TEXTURE : 0);
}

static unsigned most_words(const off_header *h)
{
    return least_words(h) + (h->color ? COLOR_MOST : 0);
}

static const char *plural(uint64_t count)
{
    return count == 1 ? "" : "s";
}

/* Whether the line begins as a face does that is all on it: a number of corners and as many vertices. */
static bool has_corners(const text_line *line)
{
    return line->integers > 0 && line->value < line->integers;
}

/* Whether nothing but a colour, of 0, 1, 3 or 4 numbers, follows these corners. */
static bool is_face(const text_line *line, uint64_t least)
{
    const uint64_t more = line->words - 1 - line->value;
    return has_corners(line) && line->value >= least && more != 2 && more <= COLOR_MOST;
}

/* "line 7 has 2 words, and the OTHERS have 3". */
static bool say_words(odd_line *odd, const text_line *line, const char *others, unsigned words)
{
    odd->number = line->number;
    snprintf(odd->hint, sizeof odd->hint, "line %zu has %u word%s, and the %s have %u", line->number, line->words,
             plural(line->words), others, words);
    return true;
}

/* The line is a face where a vertex should be, or a vertex behind the last; `before`: so many come before it. */
static bool say_count(odd_line *odd, const text_line *line, const char *what, const off_header *h, uint64_t before)
{
    *odd = (odd_line){.number = line->number, .question = "", .sure = true};
    snprintf(odd->hint, sizeof odd->hint,
             "line %zu looks like a %s, but the header says %llu %s, and %llu stand%s before it", line->number, what,
             (unsigned long long)h->vertices, h->vertices == 1 ? "vertex" : "vertices", (unsigned long long)before,
             before == 1 ? "s" : "");
    return true;
}

/* ---- vertices --------------------------------------------------------------------------------------------------- */

/* Line `line`, of vertex v, has not as many words as the very first. `after`: the next, without words where there is none. */
static bool odd_vertex(const off_header *h, uint64_t v, const text_line *first, const text_line *line,
                       const text_line *after, odd_line *odd)
{
    const unsigned least = least_words(h);
    const bool number = (first->words < least) != (line->words < least);
    const bool plain = first->words == least && !h->color && !h->texture; /* else more may be colours */
    const bool goes_on = after->words == first->words && !is_face(after, 3);
    if (plain && is_face(line, 3) && !goes_on)
        return say_count(odd, line, "face", h, v);
    odd->question = number ? "is a number missing? " : goes_on ? "is a number too many? " : "is a vertex missing? ";
    odd->sure = number || (plain && line->words > least);
    if (first->words < least && line->words >= least)
        return say_words(odd, first, "next vertices", line->words);
    return say_words(odd, line, "vertices before it", first->words);
}

/* All vertices have equally many words, but not those of the header's keyword. */
static bool odd_keyword(const off_header *h, const text_line *first, odd_line *odd)
{
    static const char *const meant[] = {[4] = "; is 4OFF meant?",
                                        [5] = "; is STOFF meant?",
                                        [6] = "; is NOFF or COFF meant?",
                                        [7] = "; is COFF meant?"};
    const bool plain = most_words(h) == POSITION, known = first->words < sizeof meant / sizeof meant[0];
    const char *question = plain && known && meant[first->words] ? meant[first->words] : "";
    *odd = (odd_line){.number = first->number, .question = "", .sure = true};
    snprintf(odd->hint, sizeof odd->hint, "line %zu has %u word%s, and the vertices of %s%s%s%sOFF have %u%s",
             first->number, first->words, plural(first->words), h->texture ? "ST" : "", h->color ? "C" : "",
             h->normal ? "N" : "", h->homogeneous ? "4" : "", least_words(h), question);
    return true;
}

/* ---- faces ------------------------------------------------------------------------------------------------------ */

static bool odd_face(const text_line *line, bool sure, odd_line *odd)
{
    const unsigned follow = line->words - 1;
    *odd = (odd_line){.number = line->number, .question = "", .sure = sure};
    snprintf(odd->hint, sizeof odd->hint, "line %zu begins a face of %llu corner%s, and %u number%s follow%s on it",
             line->number, (unsigned long long)line->value, plural(line->value), follow, plural(follow),
             follow == 1 ? "s" : "");
    return true;
}

/* As many words as a vertex, and no face: a vertex too many, before any face. */
static bool is_vertex(const text_line *line, const text_line *vertex)
{
    const bool short_face = line->integers == line->words && line->value >= 3;
    return line->words == vertex->words && line->numbers && !is_face(line, 2) && !short_face;
}

/* Passes the lines on which the face goes on that `line` begins; *line is then the next, without words where there is none
 * or none that is looked at. False: the face does not go on, since the next line is a face by itself or there is none. */
static bool pass_face(text *t, text_line *line)
{
    const uint64_t wanted = line->value;
    uint64_t corners = line->words - 1;
    bool there = text_next_line(t, line);
    if (t->cut)
        return true; /* it may go on there */
    if (!there || (is_face(line, 3) && line->words == line->value + 1))
        return false;
    for (; there && corners < wanted; there = text_next_line(t, line))
        corners += line->words;
    if (!there)
        *line = (text_line){0};
    return true;
}

/* Faces from `line` on, behind vertices that are as `vertex`. */
static bool find_odd_face(const off_header *h, text *t, const text_line *vertex, text_line line, size_t last,
                          odd_line *odd)
{
    bool any = false; /* line that can be no vertex */
    for (uint64_t f = 0; f < h->faces && line.words > 0 && line.number <= last; f++) {
        if (!any && is_vertex(&line, vertex))
            return say_count(odd, &line, "vertex", h, h->vertices + f);
        if (line.integers == 0 || (!has_corners(&line) && line.integers < line.words))
            return false; /* an error by itself */
        if (has_corners(&line) && !is_face(&line, 0))
            return odd_face(&line, line.value < 3, odd); /* else the colour has been told of */
        any |= line.value >= 3 || line.words != vertex->words;
        const text_line begun = line;
        if (has_corners(&line)) {
            if (!text_next_line(t, &line))
                return false;
        } else if (!pass_face(t, &line)) {
            return odd_face(&begun, true, odd);
        }
    }
    return false;
}

bool odd_find(const off_header *h, text *t, size_t last, odd_line *odd)
{
    text_line line = {0}, first = {0}, after = {0};
    bool any_face = false, numbers = true;
    uint64_t v = 0;
    while (v < h->vertices && text_next_line(t, &line)) {
        if (line.number <= h->line)
            continue;
        any_face |= is_face(&line, 3);
        numbers &= line.numbers;
        if (v++ == 0) {
            first = line;
        } else if (line.words != first.words) {
            text_next_line(t, &after);
            return line.number <= last && !t->cut && odd_vertex(h, v - 1, &first, &line, &after, odd);
        }
    }
    if (v < h->vertices || v == 0)
        return false;
    const bool more = text_next_line(t, &line);
    if (first.words >= least_words(h) && first.words <= most_words(h))
        return more && find_odd_face(h, t, &first, line, last, odd);
    const bool as_lines = numbers && !any_face && (more ? is_face(&line, 3) : h->faces == 0); /* else laid out freely */
    return as_lines && first.number <= last && odd_keyword(h, &first, odd);
}
