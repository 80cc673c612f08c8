/* picture.h - from the input files to the output: a scene and one picture of it, or one from each of several sides. */
#ifndef ROBERTS_CLI_PICTURE_H
#define ROBERTS_CLI_PICTURE_H

#include "cli/options.h"

/* What has become of it. */
typedef struct picture_result {
    size_t segments;       /* of the drawing: of all views, or of the last picture of a turntable */
    size_t contradictions; /* that --verify has found */
    roberts_error error;   /* its status is ROBERTS_OK if there is none */
} picture_result;

/* Reads the inputs as one scene and draws it, to `output`, or as --turntable says. Messages go to the log of the
 * options, warnings to those of the scene's options. Returns the exit status. */
int picture_make(const cli_options *given, picture_result *result);

/* Reads the inputs and builds their scene, which the caller releases; NULL on failure. Messages go to the log. Returns
 * the exit status. */
int picture_load(const cli_options *options, roberts_scene **scene);

#endif
