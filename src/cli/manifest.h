/* manifest.h - the manifest of batches: a file with a line of JSON for each file that was tried. */
#ifndef ROBERTS_CLI_MANIFEST_H
#define ROBERTS_CLI_MANIFEST_H

#include "roberts.h"

/* One line. */
typedef struct manifest_row {
    const char *file, *output; /* output NULL: none is written */
    const char *command;       /* that draws it */
    const char *error;         /* NULL: it was drawn */
    double seconds;            /* on the clock */
    size_t lines, warnings;
} manifest_row;

typedef struct manifest {
    const char *path;
    int descriptor;
} manifest;

/* Opens a manifest for adding rows, and creates it if it is missing. An incomplete last line, left by a killed run, is
 * cut off. A file that holds anything else is refused. On failure `error` has file and reason. */
roberts_status manifest_open(manifest *m, const char *path, roberts_error *error);
void manifest_close(manifest *m);

/* Adds one row, in one piece: several processes may add rows to one manifest. */
roberts_status manifest_add(const manifest *m, const manifest_row *row, roberts_error *error);

/* A query about a file. */
typedef struct manifest_query {
    char *begins; /* owned; how the row of the file begins if it was drawn */
    size_t key;   /* how many bytes of it identify the file */
    size_t index; /* for the caller */
    bool drawn;   /* the answer */
} manifest_query;

/* Adds a query: does the last row about this file say that this command drew it? False: no memory. */
bool manifest_ask(manifest_query *query, const manifest_row *row);

/* Answers `count` queries, and sorts them. */
roberts_status manifest_answer(const manifest *m, manifest_query *query, size_t count, roberts_error *error);

#endif
