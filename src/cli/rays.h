/* rays.h - what --verify and --pick say, on standard error. */
#ifndef ROBERTS_CLI_RAYS_H
#define ROBERTS_CLI_RAYS_H

#include "cli/options.h"

/* Checks the drawing by rays and tells the contradictions, one a line, the first RAYS_TOLD of them, and how many points
 * were looked at (not that where --quiet and nothing is wrong). Adds the counts to those of `sum`. */
roberts_status rays_verify(const cli_options *options, const roberts_scene *scene, const roberts_drawing *drawing,
                           roberts_verification *sum, roberts_error *error);

/* Tells what is seen at each point that --pick names and what lies behind it, nearest first, one a line. */
roberts_status rays_pick(const cli_options *options, const roberts_scene *scene, roberts_error *error);

#endif
