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

/* Opens a manifest to which rows are added; it is made if it is missing. A last line without an end, which a killed run
 * has left, is cut off. A file that holds anything else is refused. On failure `error` has file and reason. */
roberts_status manifest_open(manifest *m, const char *path, roberts_error *error);
void manifest_close(manifest *m);

/* Adds one row, in one piece: several processes may add rows to one manifest. */
roberts_status manifest_add(const manifest *m, const manifest_row *row, roberts_error *error);

/* What is asked about a file. */
typedef struct manifest_query {
    char *begins; /* owned; how the row of the file begins if it was drawn */
    size_t key;   /* how many bytes of it say which file that is */
    size_t index; /* for the caller */
    bool drawn;   /* the answer */
} manifest_query;

/* Asks whether the last row about this file says that it was drawn by this command. Returns false without memory. */
bool manifest_ask(manifest_query *query, const manifest_row *row);

/* Answers `count` queries, which are sorted by that. */
roberts_status manifest_answer(const manifest *m, manifest_query *query, size_t count, roberts_error *error);

#endif
