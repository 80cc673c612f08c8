/* sense.h - whether options make sense together, and with the files that are named. */
#ifndef ROBERTS_CLI_SENSE_H
#define ROBERTS_CLI_SENSE_H

#include "cli/options.h"

/* The options that were given, by their long names. */
typedef struct sense_given {
    const char *const *name;
    size_t count;
} sense_given;

/* What would not do what is meant is misuse: returns EXIT_DONE, or EXIT_MISUSED and has said why. */
int sense_check(const cli_options *options, sense_given given);

/* The same of an output that is a folder, before a format is read from its name. */
int sense_check_folder(const cli_options *options);

/* What changes nothing is worth a warning: says which options those are, and why. */
void sense_warn(const cli_options *options, sense_given given);

#endif
