/* list.h - a list of names of files. */
#ifndef ROBERTS_CLI_LIST_H
#define ROBERTS_CLI_LIST_H

#include "roberts.h"

/* Names in the order of the list; released by list_free(). */
typedef struct file_list {
    char **name; /* [count], in the text */
    size_t count, room;
    char *text;
} file_list;

/* Reads one name a line ("-" is standard input). A name may hold any byte but a newline; empty lines are skipped. If
 * the list holds a NUL, each name ends in a NUL instead, as find -print0 writes them: no name can hold one. On failure
 * `error` has file, line and reason. */
roberts_status list_read(file_list *list, const char *path, roberts_error *error);

/* Adds one name, which stays the caller's. False: no memory. */
bool list_add(file_list *list, char *name);

void list_free(file_list *list);

#endif
