/* empty.h - drawings that show nothing. */
#ifndef ROBERTS_CLI_EMPTY_H
#define ROBERTS_CLI_EMPTY_H

#include "cli/options.h"

/* Why none of the drawings that come on a page (or in a table) shows a line, and which option changes that; NULL where one
 * does. */
const char *empty_reason(const cli_options *options, const roberts_drawing *drawing, size_t views);

#endif
