/* lists.h - lists that the user writes: names of files; names of vertices, edges, faces and bodies. */
#ifndef ROBERTS_CLI_LISTS_H
#define ROBERTS_CLI_LISTS_H

#include <sys/types.h>

#include "roberts.h"

/* Fills `error` and returns `status`. */
roberts_status lists_fail(roberts_error *error, roberts_status status, const char *path, size_t line, const char *why);

/* Names in the order of the list; released by list_free(). */
typedef struct file_list {
    char **name; /* [count], in the text */
    size_t count, room;
    char *text;
} file_list;

/* Reads one name per line ("-" is standard input). Lines end with LF or CR LF; empty lines are skipped. If the list
 * holds a NUL, each name ends in a NUL instead, as find -print0 writes them, and may hold any other byte. On failure
 * `error` has file, line and reason. */
roberts_status list_read(file_list *list, const char *path, roberts_error *error);

/* Adds one name, which the caller keeps. False: no memory. */
bool list_add(file_list *list, char *name);

void list_free(file_list *list);

/* A regular file, whatever its name. */
typedef struct file_identity {
    dev_t device;
    ino_t number;
} file_identity;

/* Finds the file of a name. False: there is none, or it is standard input (-), a folder or a device. */
bool file_identify(const char *name, file_identity *file);

/* Orders two file_identity, for qsort() and bsearch(). */
int file_identity_order(const void *a, const void *b);

/* Names in the order that roberts_lettering requires; released by names_free(). */
typedef struct name_list {
    roberts_name *item; /* [count] */
    size_t count;
    char *text; /* of all of them */
} name_list;

/* Reads lines like "vertex,4,A", "edge,4-17,a", "face,3,base" and "body,0,leg". Empty lines and those that begin with #
 * are skipped, and so is a first line with the titles of the columns. On failure `error` has file, line and reason. */
roberts_status names_read(name_list *n, const char *path, roberts_error *error);
/* Refuses names that a drawing in parts cannot have. Returns ROBERTS_OK or _BAD_ARGUMENT. */
roberts_status names_check_part(const name_list *n, const char *path, roberts_error *error);

void names_free(name_list *n);

/* Finds the name that belongs to the same thing as `thing`, among names in that order. NULL: there is none. */
const roberts_name *names_find(const roberts_name *name, size_t count, const roberts_name *thing);

/* Writes what a name belongs to: "vertex 4", "edge 4-17". */
void names_thing(const roberts_name *name, char *text, size_t size);

#endif
