/* off_lines.c - a text that is read once more, line by line, to explain what went wrong. */
#include "model/off_lines.h"

#include <string.h>

/* Bytes that are looked at again: a fraction of a second, even where an error is found at once in a file of any size. */
#define LOOK_MOST ((uint64_t)1 << 26)

text text_begin(const off_reader *r)
{
    return (text){.source = &r->in.source, .buffer = r->in.buffer, .line = 1};
}

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

/* A word begins with `c`. `whole`: all words before it are digits alone. */
static void begin_word(text_line *line, int c, bool whole)
{
    const bool number = strchr("+-.0123456789", c) != NULL, first = line->words++ == 0;
    line->numbers &= number;
    line->named = first ? (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') : line->named && number;
    line->integers += whole;
}

bool text_next_line(text *t, text_line *line)
{
    bool within = false, comment = false, whole = true; /* whole: all words as far as read are digits alone */
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
        line->words = 0; /* the rest of it is not known */
    return line->words > 0;
}
