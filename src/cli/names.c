/* names.c - names of vertices, edges, faces and bodies, from a file of lines KIND,NUMBER,NAME. */
#include "cli/names.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/parse.h"
#include "cli/text.h"

enum { MOST = 32 * 1024 * 1024 /* bytes of the text */ };

/* Reads the whole file; the text ends with a NUL. */
static roberts_status read_names(name_list *n, const char *path, roberts_error *error)
{
    size_t size;
    const roberts_status status = text_read(path, MOST, &n->text, &size, error);
    if (status == ROBERTS_OK && memchr(n->text, '\0', size))
        return text_fail(error, ROBERTS_BAD_SYNTAX, path, 0, "is no text");
    return status;
}

/* Reads one line. Returns why it is wrong, or NULL. */
static const char *read_line(char *line, roberts_name *name)
{
    static const char *const kinds[] = {"vertex", "edge", "face", "body", NULL};
    static const roberts_label_kind of[] = {ROBERTS_LABEL_VERTICES, ROBERTS_LABEL_EDGES, ROBERTS_LABEL_FACES,
                                            ROBERTS_LABEL_BODIES};
    char *number = strchr(line, ','), *text = number ? strchr(number + 1, ',') : NULL;
    if (!text)
        return "a line is KIND,NUMBER,NAME, as vertex,4,A or edge,4-17,a";
    *number++ = *text++ = '\0';
    const size_t kind = parse_find(line, kinds);
    if (!kinds[kind])
        return "the kind is none of vertex, edge, face and body";
    *name = (roberts_name){.of = of[kind], .text = text};
    char *second = name->of == ROBERTS_LABEL_EDGES ? strchr(number, '-') : NULL;
    if (name->of == ROBERTS_LABEL_EDGES && !second)
        return "an edge is named by its vertices, as 4-17";
    if (second)
        *second++ = '\0';
    if (!parse_integer(number, &name->number) || (second && !parse_integer(second, &name->other)))
        return "the number is not a whole number from 0 on";
    if (second && name->number > name->other) {
        const uint32_t smaller = name->other;
        name->other = name->number;
        name->number = smaller;
    }
    return NULL;
}

static int by_thing(const void *a, const void *b)
{
    const roberts_name *p = a, *q = b;
    if (p->of != q->of)
        return p->of < q->of ? -1 : 1;
    if (p->number != q->number)
        return p->number < q->number ? -1 : 1;
    return (p->other > q->other) - (p->other < q->other);
}

static roberts_status refuse_twice(roberts_error *error, const char *path, const roberts_name *name)
{
    const char *kind = name->of == ROBERTS_LABEL_VERTICES ? "vertex"
                       : name->of == ROBERTS_LABEL_FACES  ? "face"
                                                          : "body";
    char why[80];
    if (name->of == ROBERTS_LABEL_EDGES)
        snprintf(why, sizeof why, "edge %u-%u has two names", (unsigned)name->number, (unsigned)name->other);
    else
        snprintf(why, sizeof why, "%s %u has two names", kind, (unsigned)name->number);
    return text_fail(error, ROBERTS_BAD_SYNTAX, path, 0, why);
}

static bool append(name_list *n, const roberts_name *name)
{
    if (n->count == n->room) {
        const size_t room = 2 * n->room + 64;
        roberts_name *grown = realloc(n->item, room * sizeof *grown);
        if (!grown)
            return false;
        n->item = grown;
        n->room = room;
    }
    n->item[n->count++] = *name;
    return true;
}

roberts_status names_read(name_list *n, const char *path, roberts_error *error)
{
    size_t line = 0;
    roberts_status status = read_names(n, path, error);
    for (char *at = n->text, *next; status == ROBERTS_OK && at && *at; at = next) {
        roberts_name name;
        next = strchr(at, '\n');
        if (next)
            *next++ = '\0';
        line++;
        const size_t length = strlen(at);
        if (length > 0 && at[length - 1] == '\r')
            at[length - 1] = '\0';
        if (*at == '\0' || *at == '#')
            continue;
        const char *why = read_line(at, &name);
        if (why)
            return text_fail(error, ROBERTS_BAD_SYNTAX, path, line, why);
        if (!append(n, &name))
            return text_fail(error, ROBERTS_NO_MEMORY, path, 0, "not enough memory");
    }
    if (status == ROBERTS_OK && n->count > 1)
        qsort(n->item, n->count, sizeof *n->item, by_thing);
    for (size_t i = 1; status == ROBERTS_OK && i < n->count; i++)
        if (by_thing(&n->item[i - 1], &n->item[i]) == 0)
            return refuse_twice(error, path, &n->item[i]);
    return status;
}

void names_free(name_list *n)
{
    free(n->item);
    free(n->text);
    *n = (name_list){0};
}
