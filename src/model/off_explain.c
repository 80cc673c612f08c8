/* off_explain.c - after an error: a second look at the text, line by line, for what may be its reason.
 *
 * OFF is read word by word, so that a number that is missing is missed where the words do not make sense any more, which
 * may be far behind. But most files have a vertex on each line: then the first line with another number of words than
 * the lines before it is where to look. And lines of numbers from the first to the last are points, in a format that has
 * no name and no mark; a number, a line of any text and then lines with a word and three numbers are XYZ, the atoms of a
 * molecule, which has no mark either.
 *
 * Costs nothing while all goes well. Inputs that cannot be read twice (pipes) are left without. */
#include "model/off.h"

#include <stdio.h>
#include <string.h>

enum { POSITION = 3, NORMAL = 3, TEXTURE = 2, HINT = 100, SAID = 240 };

/* Bytes that are looked at again: a fraction of a second, even where an error is found at once in a file of any size. */
#define LOOK_MOST ((uint64_t)1 << 26)

typedef struct text {
    const off_source *source;
    char *buffer; /* [OFF_BLOCK] */
    size_t size, at;
    uint64_t offset; /* of the byte after the buffer's last */
    size_t line;     /* of the next byte, from 1 */
    bool after_cr;
    bool cut; /* there may be more than LOOK_MOST */
} text;

/* A line with a word in it. */
typedef struct text_line {
    size_t number;
    unsigned words;
    bool numbers; /* each word begins as a number does */
    bool named;   /* each but the first, which begins with a letter */
    bool commas;  /* or semicolons, which here stand between words */
} text_line;

/* The next byte; -1: there is none, or none that is looked at. */
static int next_byte(text *t)
{
    if (t->at == t->size) {
        t->cut = t->offset >= LOOK_MOST;
        if (t->cut)
            return -1;
        ptrdiff_t got = t->source->read_at(t->source->context, t->offset, t->buffer, OFF_BLOCK);
        if (got <= 0)
            return -1;
        t->offset += (uint64_t)got;
        t->size = (size_t)got;
        t->at = 0;
    }
    return (unsigned char)t->buffer[t->at++];
}

/* Reads up to the end of the next line with a word. False: there is none. */
static bool next_line(text *t, text_line *line)
{
    bool within = false, comment = false;
    *line = (text_line){.number = t->line, .numbers = true};
    for (int c; (c = next_byte(t)) >= 0;) {
        bool end = c == '\n' || c == '\r', comma = c == ',' || c == ';';
        bool second = c == '\n' && t->after_cr; /* of CR LF */
        t->after_cr = c == '\r';
        if (end && !second) {
            t->line++;
            if (line->words)
                return true;
            line->number = t->line;
        }
        comment = !end && (comment || c == '#');
        line->commas |= comma && !comment;
        bool word = c > ' ' && !comma && !comment && c != '{' && c != '}';
        if (word && !within) {
            const bool number = strchr("+-.0123456789", c) != NULL, first = line->words++ == 0;
            line->numbers &= number;
            line->named = first ? (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') : line->named && number;
        }
        within = word;
    }
    return line->words > 0;
}

/* Has the input nothing but lines of equally many numbers? Says so. */
static bool describe_points(text *t, char said[SAID])
{
    text_line first, line;
    size_t count = 1;
    if (!next_line(t, &first) || !first.numbers || first.words < POSITION)
        return false;
    for (; next_line(t, &line); count++)
        if (!line.numbers || line.words != first.words)
            return false;
    if (t->cut)
        return false;
    if (first.words == POSITION && !first.commas)
        snprintf(said, SAID,
                 "this looks like points, %u numbers on each line, not like OFF; with two lines before them, "
                 "\"3 points\" and \"%zu\", they can be read as points to take the hull of",
                 first.words, count);
    else
        snprintf(said, SAID,
                 "this looks like a table, %u numbers on each line%s, not like OFF; of points, \"3 points\" and their "
                 "number are read, and then three numbers for each, with blanks between",
                 first.words, first.commas ? " with commas" : "");
    return true;
}

/* Does the input begin as XYZ does? The text may be missing; two or three numbers there are rather counts, behind a dimension. */
static bool is_xyz(text *t)
{
    text_line count, title, atom;
    if (!next_line(t, &count) || !count.numbers || count.words != 1 || !next_line(t, &title))
        return false;
    if (title.number == count.number + 2)
        atom = title;
    else if (title.number != count.number + 1 || (title.numbers && title.words <= 3 && title.words >= 2) ||
             !next_line(t, &atom) || atom.number != count.number + 2)
        return false;
    return atom.named && atom.words > POSITION;
}

static void add_to_message(roberts_error *error, const char *hint)
{
    size_t used = strlen(error->message), room = sizeof error->message - used;
    if (strlen(hint) + sizeof "; look: " <= room)
        snprintf(error->message + used, room, "; look: %s", hint);
}

/* Looks at the lines with the vertices, up to line `last`, for the first that has not as many words as the very first; *odd
 * has none where there is no such line. */
static void find_odd(const off_header *h, text *t, size_t last, text_line *first, text_line *odd)
{
    text_line line;
    *first = *odd = (text_line){0};
    for (uint64_t v = 0; v < h->vertices && next_line(t, &line) && line.number <= last;) {
        if (line.number <= h->line)
            continue;
        if (v++ == 0) {
            *first = line;
        } else if (line.words != first->words) {
            *odd = line;
            return;
        }
    }
}

/* "line 7 has 2 words, ..."; none of `odd`: nothing is odd there. */
static void describe(const text_line *first, const text_line *odd, unsigned least, char hint[HINT])
{
    if (first->words < least && odd->words >= least)
        snprintf(hint, HINT, "line %zu has %u word%s, and the next vertices have %u", first->number, first->words,
                 first->words == 1 ? "" : "s", odd->words);
    else
        snprintf(hint, HINT, "line %zu has %u word%s, and the vertices before it have %u", odd->number, odd->words,
                 odd->words == 1 ? "" : "s", first->words);
}

static unsigned least_words(const off_header *h)
{
    return POSITION + (h->homogeneous ? 1 : 0) + (h->normal ? NORMAL : 0) + (h->texture ? TEXTURE : 0);
}

static text begin(const off_reader *r)
{
    return (text){.source = &r->in.source, .buffer = r->in.buffer, .line = 1};
}

void off_explain_error(off_reader *r)
{
    const bool ended = r->in.ended && r->in.at == r->in.end; /* before the buffer is used anew */
    text_line first, odd;
    char hint[HINT], said[SAID];
    if (!r->error || !r->in.source.read_at || r->in.failure || r->header.binary || r->error->line == 0)
        return;
    text t = begin(r);
    if (r->header.bare && describe_points(&t, said)) {
        error_set(r->error, r->error->status, 0, "%s", said);
        return;
    }
    t = begin(r);
    if (r->header.bare && is_xyz(&t)) {
        error_set(r->error, r->error->status, 0,
                  "this looks like XYZ, the atoms of a molecule, but only OFF can be read");
        return;
    }
    if (r->header.line == 0)
        return;
    t = begin(r);
    find_odd(&r->header, &t, ended ? r->error->line : r->error->line - 1, &first, &odd);
    if (odd.words == 0)
        return;
    describe(&first, &odd, least_words(&r->header), hint);
    add_to_message(r->error, hint);
}

void off_explain_rest(off_reader *r)
{
    char said[SAID];
    text t = begin(r);
    if (r->warnings && r->header.bare && r->in.source.read_at && !r->in.failure && describe_points(&t, said))
        warning_send(r->warnings, r->name, 0, "%s", said);
    else
        warning_send(r->warnings, r->name, r->in.line, "text after the last face ignored");
}

void off_explain_warning(off_reader *r)
{
    const off_header *h = &r->header;
    const unsigned least = least_words(h);
    text_line first, odd;
    char hint[HINT];
    if (!r->warnings || !r->in.source.read_at || r->in.failure || h->binary || h->line == 0)
        return;
    text t = begin(r);
    find_odd(h, &t, SIZE_MAX, &first, &odd);
    bool number = (first.words < least) != (odd.words < least);
    bool vertex = first.words == least && odd.words > least && !h->color && !h->texture; /* else more may be colours */
    if (odd.words == 0 || (!number && !vertex))
        return;
    describe(&first, &odd, least, hint);
    warning_send(r->warnings, r->name, first.words < least ? first.number : odd.number, "is a %s missing? %s",
                 number ? "number" : "vertex", hint);
}
