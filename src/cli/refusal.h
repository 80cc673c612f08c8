/* refusal.h - what can be done about a file that could not be read, or a model that has been refused. */
#ifndef ROBERTS_CLI_REFUSAL_H
#define ROBERTS_CLI_REFUSAL_H

#include "cli/options.h"

/* Appends to the error's message which options would have the mesh, of which roberts_scene_build() has made no scene. */
void refusal_explain(const cli_options *options, const roberts_mesh *mesh, roberts_error *error);

/* Where the input called `name`, which could not be read, is a folder or a drawing: says so, or what was meant. */
void refusal_explain_reading(const cli_options *options, const char *name, roberts_error *error);

#endif
