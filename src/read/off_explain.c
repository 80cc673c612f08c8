/* off_explain.c - messages about a faulty file, from a second look at the text, line by line.
 *
 * OFF is read word by word. A missing number is noticed where the words no longer make sense, which may be far behind
 * it. But most files have one vertex or one face on each line. So the second look can find a line with too few or too
 * many words, and a header that declares a different number of vertices. It claims nothing about a file that may be
 * laid out freely.
 *
 * If all lines are numbers, the file contains points, in a format without a name. A number, a line of any text and then
 * lines of a word and three numbers are XYZ, the atoms of a molecule.
 *
 * A correct file costs nothing. An input that cannot be read twice (a pipe) gets no second look. */
#include "read/off.h"

#include <stdio.h>
#include <string.h>

/* ---- reading the text again, line by line ---------------------------------------------------------------------- */

typedef struct text {
    const input_source *source;
    char *buffer; /* [INPUT_BLOCK] */
    size_t size, at;
    uint64_t offset; /* offset of the byte after the buffer's last */
    size_t line;     /* line of the next byte, from 1 */
    bool after_cr;
    bool cut; /* LOOK_MOST is reached: there may be more */
} text;

/* A line with at least one word. */
typedef struct text_line {
    size_t number;
    unsigned words;
    unsigned integers; /* number of leading words that consist of digits */
    uint64_t value;    /* value of the first of these; UINT64_MAX: too large */
    bool numbers;      /* each word begins like a number */
    bool named;        /* the first word begins with a letter, all others like a number */
    bool commas;       /* there are commas or semicolons, which separate words here */
} text_line;

/* Bytes: the most to read again. This takes a fraction of a second, however large the file. */
#define LOOK_MOST ((uint64_t)1 << 26)

static text text_begin(const reader *r)
{
    return (text){.source = &r->in.source, .buffer = r->in.buffer, .line = 1};
}

/* Returns the next byte; -1: the end, or LOOK_MOST is reached. */
static int next_byte(text *t)
{
    if (t->at == t->size) {
        t->cut = t->offset >= LOOK_MOST;
        if (t->cut)
            return -1;
        ptrdiff_t got = t->source->read_at(t->source->context, t->offset, t->buffer, INPUT_BLOCK);
        if (got <= 0)
            return -1;
        t->offset += (uint64_t)got;
        t->size = (size_t)got;
        t->at = 0;
    }
    return (unsigned char)t->buffer[t->at++];
}

/* Records that a word begins with `c`. `whole`: all words before it consist of digits. */
static void begin_word(text_line *line, int c, bool whole)
{
    const bool number = strchr("+-.0123456789", c) != NULL, first = line->words++ == 0;
    line->numbers &= number;
    line->named = first ? (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') : line->named && number;
    line->integers += whole;
}

static bool text_next_line(text *t, text_line *line)
{
    bool within = false, comment = false, whole = true; /* whole: all words so far consist of digits */
    *line = (text_line){.number = t->line, .numbers = true};
    for (int c; (c = next_byte(t)) >= 0;) {
        bool end = c == '\n' || c == '\r', comma = c == ',' || c == ';';
        bool second = c == '\n' && t->after_cr; /* second character of CR LF */
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
        if (word && !within)
            begin_word(line, c, whole);
        if (word && whole && (c < '0' || c > '9')) {
            whole = false;
            line->integers--;
        } else if (word && line->words == 1 && whole) {
            line->value = line->value < UINT64_MAX / 10 ? 10 * line->value + (uint64_t)(c - '0') : UINT64_MAX;
        }
        within = word;
    }
    if (t->cut)
        line->words = 0; /* the line may continue */
    return line->words > 0;
}

/* ---- the line that differs from the others ---------------------------------------------------------------------- */

enum { ODD_HINT = 120 };

typedef struct odd_line {
    size_t number;
    const char *question; /* what seems to be missing, or "" */
    bool sure;            /* report it even without an error, if something else is doubtful too */
    char hint[ODD_HINT];  /* "line 7 has 2 words, ..." */
} odd_line;

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

/* Does the line begin with a number of corners and that many vertices? */
static bool has_corners(const text_line *line)
{
    return line->integers > 0 && line->value < line->integers;
}

/* Is the rest of the line, after the corners, a colour of 0, 1, 3 or 4 numbers? */
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

/* Reports a face where a vertex is expected, or a vertex after the last one. `before`: how many precede it. */
static bool say_count(odd_line *odd, const text_line *line, const char *what, const off_header *h, uint64_t before)
{
    *odd = (odd_line){.number = line->number, .question = "", .sure = true};
    snprintf(odd->hint, sizeof odd->hint,
             "line %zu looks like a %s, but the header says %llu %s, and %llu stand%s before it", line->number, what,
             (unsigned long long)h->vertices, h->vertices == 1 ? "vertex" : "vertices", (unsigned long long)before,
             before == 1 ? "s" : "");
    return true;
}

/* ---- vertices -------------------------------------------------------------------------------------------------- */

/* Examines `line`, of vertex v, which does not have as many words as `first`. `after`: the next line, without words if
 * there is none. */
static bool odd_vertex(const off_header *h, uint64_t v, const text_line *first, const text_line *line,
                       const text_line *after, odd_line *odd)
{
    const unsigned least = least_words(h);
    const bool number = (first->words < least) != (line->words < least);
    const bool plain = first->words == least && !h->color && !h->texture; /* otherwise more words may be colours */
    const bool goes_on = after->words == first->words && !is_face(after, 3);
    if (plain && is_face(line, 3) && !goes_on)
        return say_count(odd, line, "face", h, v);
    odd->question = number ? "is a number missing? " : goes_on ? "is a number too many? " : "is a vertex missing? ";
    odd->sure = number || (plain && line->words > least);
    if (first->words < least && line->words >= least)
        return say_words(odd, first, "next vertices", line->words);
    return say_words(odd, line, "vertices before it", first->words);
}

/* All vertices have the same number of words, but not the number that the keyword implies. */
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

/* ---- faces ----------------------------------------------------------------------------------------------------- */

static bool odd_face(const text_line *line, bool sure, odd_line *odd)
{
    const unsigned follow = line->words - 1;
    *odd = (odd_line){.number = line->number, .question = "", .sure = sure};
    snprintf(odd->hint, sizeof odd->hint, "line %zu begins a face of %llu corner%s, and %u number%s follow%s on it",
             line->number, (unsigned long long)line->value, plural(line->value), follow, plural(follow),
             follow == 1 ? "s" : "");
    return true;
}

/* Is this an extra vertex before the faces? It has as many words as a vertex, and is not a face. */
static bool is_vertex(const text_line *line, const text_line *vertex)
{
    const bool short_face = line->integers == line->words && line->value >= 3;
    return line->words == vertex->words && line->numbers && !is_face(line, 2) && !short_face;
}

/* Passes the lines of a face that begins with `line`. *line becomes the next line, without words if there is none or
 * the limit is reached. False: the face does not continue, since the next line is a face of its own or there is
 * none. */
static bool pass_face(text *t, text_line *line)
{
    const uint64_t wanted = line->value;
    uint64_t corners = line->words - 1;
    bool there = text_next_line(t, line);
    if (t->cut)
        return true; /* it may continue there */
    if (!there || (is_face(line, 3) && line->words == line->value + 1))
        return false;
    for (; there && corners < wanted; there = text_next_line(t, line))
        corners += line->words;
    if (!there)
        *line = (text_line){0};
    return true;
}

/* Examines the faces from `line` on. `vertex`: a line with the form of the vertices. */
static bool find_odd_face(const off_header *h, text *t, const text_line *vertex, text_line line, size_t last,
                          odd_line *odd)
{
    bool any = false; /* there was a line that cannot be a vertex */
    for (uint64_t f = 0; f < h->faces && line.words > 0 && line.number <= last; f++) {
        if (!any && is_vertex(&line, vertex))
            return say_count(odd, &line, "vertex", h, h->vertices + f);
        if (line.integers == 0 || (!has_corners(&line) && line.integers < line.words))
            return false; /* the reader itself reports this line */
        if (has_corners(&line) && !is_face(&line, 0))
            return odd_face(&line, line.value < 3, odd); /* otherwise a warning about the colour was sent */
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

static bool odd_find(const off_header *h, text *t, size_t last, odd_line *odd)
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
    const bool as_lines =
        numbers && !any_face && (more ? is_face(&line, 3) : h->faces == 0); /* otherwise laid out freely */
    return as_lines && first.number <= last && odd_keyword(h, &first, odd);
}

/* ---- messages -------------------------------------------------------------------------------------------------- */

enum { SAID = 240 };

/* If all lines of the input have the same number of numbers, says so. */
static bool describe_points(text *t, char said[SAID])
{
    text_line first, line;
    size_t count = 1;
    if (!text_next_line(t, &first) || !first.numbers || first.words < POSITION)
        return false;
    for (; text_next_line(t, &line); count++)
        if (!line.numbers || line.words != first.words)
            return false;
    if (t->cut)
        return false;
    if (first.words == POSITION && !first.commas)
        snprintf(said, SAID,
                 "this looks like points, not OFF; put the lines \"3 points\" and \"%zu\" before them and use --hull",
                 count);
    else
        snprintf(said, SAID,
                 "this looks like a table, %u numbers a line%s, not OFF; points are the lines \"3 points\", their "
                 "number, and "
                 "then three numbers a line, with blanks between",
                 first.words, first.commas ? " with commas" : "");
    return true;
}

/* Does the input begin like XYZ? The line of text may be missing. If it has two or three numbers, they are more likely
 * counts after a dimension. */
static bool is_xyz(text *t)
{
    text_line count, title, atom;
    if (!text_next_line(t, &count) || !count.numbers || count.words != 1 || !text_next_line(t, &title))
        return false;
    if (title.number == count.number + 2)
        atom = title;
    else if (title.number != count.number + 1 || (title.numbers && title.words <= 3 && title.words >= 2) ||
             !text_next_line(t, &atom) || atom.number != count.number + 2)
        return false;
    return atom.named && atom.words > POSITION;
}

static void add_to_message(roberts_error *error, const char *hint)
{
    size_t used = strlen(error->message), room = sizeof error->message - used;
    if (strlen(hint) + sizeof "; look: " <= room)
        snprintf(error->message + used, room, "; look: %s", hint);
}

void off_explain_error(reader *r)
{
    const bool ended = r->in.ended && r->in.at == r->in.end; /* read before the buffer is overwritten */
    odd_line odd = {0};
    char said[SAID];
    if (!r->error || !r->in.source.read_at || r->in.failure || r->off->header.binary || r->error->line == 0)
        return;
    text t = text_begin(r);
    if (r->off->header.bare && describe_points(&t, said)) {
        error_set(r->error, r->error->status, 0, "%s", said);
        return;
    }
    t = text_begin(r);
    if (r->off->header.bare && is_xyz(&t)) {
        error_set(r->error, r->error->status, 0,
                  "this looks like XYZ, the atoms of a molecule, but only OFF, STL, OBJ and PLY can be read");
        return;
    }
    if (r->off->header.line == 0)
        return;
    t = text_begin(r);
    if (odd_find(&r->off->header, &t, ended ? r->in.line : r->in.line - 1, &odd))
        add_to_message(r->error, odd.hint);
}

void off_explain_rest(reader *r)
{
    char said[SAID];
    const size_t line = r->in.line;
    if (off_at_keyword(r)) {
        warning_send(r->warnings, r->name, line,
                     "another model begins here and is ignored; OFF holds one, but several files are drawn together");
        return;
    }
    text t = text_begin(r);
    if (r->warnings && r->off->header.bare && r->in.source.read_at && !r->in.failure && describe_points(&t, said))
        warning_send(r->warnings, r->name, 0, "%s", said);
    else
        warning_send(r->warnings, r->name, line,
                     "text after the last face ignored; the header says %llu %s and %llu face%s",
                     (unsigned long long)r->off->header.vertices, r->off->header.vertices == 1 ? "vertex" : "vertices",
                     (unsigned long long)r->off->header.faces, r->off->header.faces == 1 ? "" : "s");
}

void off_explain_warning(reader *r)
{
    const off_header *h = &r->off->header;
    odd_line odd = {0};
    if (!r->warnings || !r->in.source.read_at || r->in.failure || h->binary || h->line == 0)
        return;
    text t = text_begin(r);
    if (odd_find(h, &t, SIZE_MAX, &odd) && odd.sure)
        warning_send(r->warnings, r->name, odd.number, "%s%s", odd.question, odd.hint);
}
