/* batch_files.h - the files of a batch: the names of their drawings, and which files to draw. */
#ifndef ROBERTS_CLI_BATCH_FILES_H
#define ROBERTS_CLI_BATCH_FILES_H

#include "cli/lists.h"
#include "cli/manifest.h"
#include "cli/options.h"

typedef struct batch_file {
    char *input;         /* of argv, or of the list */
    char *output, *text; /* owned; the text of its messages */
    bool done;
} batch_file;

typedef struct batch_files {
    const cli_options *options;
    file_list list;
    batch_file *file; /* [count] in the order of the command and the list */
    size_t count;
    size_t current; /* others, whose drawings are up to date */
} batch_files;

/* Functions that return an int return the exit status, after printing any message. */

/* Lists all files, and names their drawings; no two may have the same name. Call batch_files_free() in any case. */
int batch_files_name(batch_files *b, const cli_options *options);

/* No drawing may replace a model, the list, or the manifest. */
int batch_files_check_places(const batch_files *b);

/* Keeps the files of --shard. */
void batch_files_take_shard(batch_files *b);

/* Keeps the files that --update draws. rows: the manifest; NULL: there is none. */
int batch_files_drop_current(batch_files *b, const manifest *rows);

/* Returns the command that draws a file: the text of `command`. */
const char *batch_files_command(const batch_files *b, const batch_file *file, description *command);

/* Makes the folders between DIR and the drawing. If one cannot be made, writing the drawing reports why. */
void batch_files_make_folders(const batch_files *b, const batch_file *file);

void batch_files_free(batch_files *b);

#endif
