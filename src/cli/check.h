/* check.h - whether options make sense together, and with the files that are named. */
#ifndef ROBERTS_CLI_CHECK_H
#define ROBERTS_CLI_CHECK_H

#include "cli/options.h"

/* Each returns EXIT_DONE, or EXIT_MISUSED after a message. */
int check_folder(const cli_options *options); /* the output is no folder; checked before its name determines the
                                                 format */
int check_format(const cli_options *options); /* the format goes with the other options and the output */
int check_options(const cli_options *options, const options_given *given); /* all else */

/* Warns about options that change nothing, with the reason. */
void check_warn(const cli_options *options, const options_given *given);

#endif
