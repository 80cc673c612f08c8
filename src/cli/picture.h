/* picture.h - from the files to what is written: a scene and one picture of it, or one from each of several sides. */
#ifndef ROBERTS_CLI_PICTURE_H
#define ROBERTS_CLI_PICTURE_H

#include "cli/options.h"

/* Reads the inputs as one scene and draws it, to `output`, or as --turntable says. Messages go to the log of the
 * options. Returns the exit status. */
int picture_make(const cli_options *given);

/* Reads the inputs and builds their scene, which the caller releases; NULL on failure. Messages go to the log. Returns
 * the exit status. */
int picture_load(const cli_options *options, roberts_scene **scene);

#endif
