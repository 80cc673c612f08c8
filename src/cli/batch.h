/* batch.h - one picture for each file. */
#ifndef ROBERTS_CLI_BATCH_H
#define ROBERTS_CLI_BATCH_H

#include "cli/options.h"

/* Draws each input, and each file of the list, into the folder options->batch, several at a time. A file that fails,
 * crashes its process or exceeds a limit does not stop the others. Messages come in the order of the files.
 * Returns the exit status: EXIT_FAILED if a file has failed, or the manifest could not be written. */
int batch_make(const cli_options *options);

#endif
