/* refusal.h - what can be done about a model that has been refused. */
#ifndef ROBERTS_CLI_REFUSAL_H
#define ROBERTS_CLI_REFUSAL_H

#include "cli/options.h"

/* Appends to the error's message which options would have the mesh, of which roberts_scene_build() has made no scene. */
void refusal_explain(const cli_options *options, const roberts_mesh *mesh, roberts_error *error);

#endif
