/* options.h - the command line as a plain struct. */
#ifndef ROBERTS_CLI_OPTIONS_H
#define ROBERTS_CLI_OPTIONS_H

#include <stdio.h>

#include "cli/description.h"
#include "roberts.h"

enum { PICKS_MOST = 64 };

typedef enum cli_stats { STATS_NONE, STATS_TEXT, STATS_JSON } cli_stats;

typedef struct cli_options {
    char **input; /* [input_count], of argv; "-" is standard input; at least one */
    size_t input_count;
    const char *output; /* "-" is standard output */
    const char *batch;  /* NULL, or the folder for a picture of each input; then `output` is not used */
    uint32_t turntable; /* 0, or how many pictures; then `output` holds a place for their numbers */
    bool is_sheet;      /* several views on one page; then the camera is not used */
    roberts_sheet_angle sheet;
    FILE *log;         /* for messages */
    const char *label; /* NULL, or which of several pictures this is: begins what is said of it */
    roberts_scene_options scene;
    roberts_camera camera;
    roberts_hide_options hide;
    roberts_draw_options draw;
    description description; /* of the drawing, as a command */
    cli_stats stats;
    bool verify;
    uint32_t verify_rays; /* per segment; 0 = choose */
    roberts_vec2 pick[PICKS_MOST];
    size_t pick_count;
    bool quiet, verbose, help, version;
} cli_options;

/* Fills `options` from the arguments, which are put in order: operands to the end. Returns EXIT_DONE, or EXIT_MISUSED
 * and has said why. */
int options_parse(int argc, char **argv, cli_options *options);

#endif
