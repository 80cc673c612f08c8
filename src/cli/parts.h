/* parts.h - a drawing in parts: plans, parts, and joining. */
#ifndef ROBERTS_CLI_PARTS_H
#define ROBERTS_CLI_PARTS_H

#include "cli/options.h"

/* Writes a plan or a part, as the options say. Returns the exit status. */
int part_make(const cli_options *options);

/* Joins the parts that are the inputs. Refuses options that need names of groups, if the models have some. */
roberts_status part_join(const cli_options *options, roberts_joined *joined, roberts_error *error);

#endif
