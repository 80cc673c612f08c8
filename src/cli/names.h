/* names.h - names of vertices, edges, faces and bodies, from a file. */
#ifndef ROBERTS_CLI_NAMES_H
#define ROBERTS_CLI_NAMES_H

#include "roberts.h"

/* Names in the order that roberts_lettering wants; released by names_free(). */
typedef struct name_list {
    roberts_name *item;
    size_t count, room;
    char *text; /* of all of them */
} name_list;

/* Reads lines like "vertex,4,A", "edge,4-17,a", "face,3,base" and "body,0,leg". Empty lines and those that begin with #
 * are skipped. On failure `error` has file, line and reason. */
roberts_status names_read(name_list *n, const char *path, roberts_error *error);
void names_free(name_list *n);

#endif
