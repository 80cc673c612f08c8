/* off_explain.c - after an error: a second look at the text, line by line, for what may be its reason.
 *
 * Mostly that is one odd line (off_odd.c). But lines of numbers from the first to the last are points, in a format that has
 * no name and no mark; a number, a line of any text and then lines with a word and three numbers are XYZ, the atoms of a
 * molecule, which has no mark either.
 *
 * Costs nothing while all goes well. Inputs that cannot be read twice (pipes) are left without. */
#include "model/off_odd.h"

#include <stdio.h>
#include <string.h>

enum { POSITION = 3, SAID = 240 };

/* Has the input nothing but lines of equally many numbers? Says so. */
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

void off_explain_error(off_reader *r)
{
    const bool ended = r->in.ended && r->in.at == r->in.end; /* before the buffer is used anew */
    odd_line odd = {0};
    char said[SAID];
    if (!r->error || !r->in.source.read_at || r->in.failure || r->header.binary || r->error->line == 0)
        return;
    text t = text_begin(r);
    if (r->header.bare && describe_points(&t, said)) {
        error_set(r->error, r->error->status, 0, "%s", said);
        return;
    }
    t = text_begin(r);
    if (r->header.bare && is_xyz(&t)) {
        error_set(r->error, r->error->status, 0,
                  "this looks like XYZ, the atoms of a molecule, but only OFF can be read");
        return;
    }
    if (r->header.line == 0)
        return;
    t = text_begin(r);
    if (odd_find(&r->header, &t, ended ? r->error->line : r->error->line - 1, &odd))
        add_to_message(r->error, odd.hint);
}

void off_explain_rest(off_reader *r)
{
    char said[SAID];
    const size_t line = r->in.line;
    if (off_at_keyword(r)) {
        warning_send(r->warnings, r->name, line,
                     "another model begins here and is ignored; OFF holds one, but several files are drawn together");
        return;
    }
    text t = text_begin(r);
    if (r->warnings && r->header.bare && r->in.source.read_at && !r->in.failure && describe_points(&t, said))
        warning_send(r->warnings, r->name, 0, "%s", said);
    else
        warning_send(r->warnings, r->name, line,
                     "text after the last face ignored; the header says %llu %s and %llu face%s",
                     (unsigned long long)r->header.vertices, r->header.vertices == 1 ? "vertex" : "vertices",
                     (unsigned long long)r->header.faces, r->header.faces == 1 ? "" : "s");
}

void off_explain_warning(off_reader *r)
{
    const off_header *h = &r->header;
    odd_line odd = {0};
    if (!r->warnings || !r->in.source.read_at || r->in.failure || h->binary || h->line == 0)
        return;
    text t = text_begin(r);
    if (odd_find(h, &t, SIZE_MAX, &odd) && odd.sure)
        warning_send(r->warnings, r->name, odd.number, "%s%s", odd.question, odd.hint);
}
