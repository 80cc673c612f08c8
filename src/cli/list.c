/* list.c - a list of names of files. */
#include "cli/list.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/text.h"

enum { MOST = 256 * 1024 * 1024 /* bytes: more than two million names of a hundred */ };

bool list_add(file_list *list, char *name)
{
    if (list->count == list->room) {
        const size_t room = 2 * list->room + 64;
        char **grown = realloc(list->name, room * sizeof *grown); /* NOLINT(bugprone-sizeof-expression): of a pointer */
        if (!grown)
            return false;
        list->name = grown;
        list->room = room;
    }
    list->name[list->count++] = name;
    return true;
}

static roberts_status read_text(file_list *list, const char *path, size_t *size, roberts_error *error)
{
    if (strcmp(path, "-") == 0)
        return text_read_stream(stdin, "standard input", MOST, &list->text, size, error);
    return text_read(path, MOST, &list->text, size, error);
}

roberts_status list_read(file_list *list, const char *path, roberts_error *error)
{
    size_t size, line = 0, first = list->count;
    const char *called = strcmp(path, "-") == 0 ? "standard input" : path;
    roberts_status status = read_text(list, path, &size, error);
    if (status != ROBERTS_OK)
        return status;
    const char end = memchr(list->text, '\0', size) ? '\0' : '\n';
    for (char *at = list->text, *next; at < list->text + size; at = next) {
        char *stop = memchr(at, end, (size_t)(list->text + size - at));
        next = stop ? stop + 1 : list->text + size;
        if (stop)
            *stop = '\0'; /* behind the last name there is a NUL anyway */
        line++;
        if (*at == '\0')
            continue;
        if (strcmp(at, "-") == 0)
            return text_fail(error, ROBERTS_BAD_SYNTAX, called, line, "- is no file; a file of this name is ./-");
        if (!list_add(list, at))
            return text_fail(error, ROBERTS_NO_MEMORY, called, 0, "not enough memory");
    }
    return list->count > first ? ROBERTS_OK : text_fail(error, ROBERTS_BAD_SYNTAX, called, 0, "the list is empty");
}

void list_free(file_list *list)
{
    free(list->name);
    free(list->text);
    *list = (file_list){0};
}
