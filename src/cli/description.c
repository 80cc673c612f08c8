/* description.c - what was drawn and how, as a command that draws it again. */
#include "cli/description.h"

#include <string.h>

/* Room that is left for the dots. */
enum { DOTS = 4 };

static void add(description *d, const char *text, size_t length)
{
    if (d->is_full)
        return;
    if (length + DOTS >= sizeof d->text - d->length) {
        d->is_full = 1;
        text = " ...";
        length = DOTS;
    }
    memcpy(d->text + d->length, text, length);
    d->length += length;
    d->text[d->length] = '\0';
}

/* In quotes where a shell would take it for something else; a quote itself stands outside of them: 'it'\''s'. */
static void add_quoted(description *d, const char *word)
{
    static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=./,:@%";
    if (*word && word[strspn(word, plain)] == '\0') {
        add(d, word, strlen(word));
        return;
    }
    add(d, "'", 1);
    for (; *word; word++)
        if (*word == '\'')
            add(d, "'\\''", 4);
        else
            add(d, word, 1);
    add(d, "'", 1);
}

void description_word(description *d, const char *word)
{
    if (d->length)
        add(d, " ", 1);
    add_quoted(d, word);
}

void description_option(description *d, const char *name, const char *value)
{
    add(d, " --", 3);
    add(d, name, strlen(name));
    if (value) {
        add(d, "=", 1);
        add_quoted(d, value);
    }
}
