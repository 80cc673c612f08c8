/* batch.h - one picture for each file. */
#ifndef ROBERTS_CLI_BATCH_H
#define ROBERTS_CLI_BATCH_H

#include "cli/options.h"

/* Draws each input into the folder options->batch, several at a time. A file that fails does not stop the others.
 * Messages come in the order of the files. Returns the exit status: EXIT_FAILED if a file has failed. */
int batch_make(const cli_options *options);

#endif
