/* empty.h - drawings that show nothing, or next to nothing. */
#ifndef ROBERTS_CLI_EMPTY_H
#define ROBERTS_CLI_EMPTY_H

#include "cli/options.h"

/* Why none of the drawings that come on a page (or in a table) shows a line, and which option changes that; NULL where one
 * does. */
const char *empty_reason(const cli_options *options, const roberts_drawing *drawing, size_t views);

/* Whether that is so, or nearly so, because the eye is on a solid, or so near that the near plane cuts it in the middle of the
 * picture; then `why` tells. */
bool empty_by_near(const cli_options *options, const roberts_scene *scene, const roberts_drawing *drawing, char *why,
                   size_t size);

#endif
