/* paper.h - values of the options that say how a drawing comes on paper. */
#ifndef ROBERTS_CLI_PAPER_H
#define ROBERTS_CLI_PAPER_H

#include "roberts.h"

/* Each returns EXIT_DONE, or EXIT_MISUSED and has said why. */
int paper_set_page(roberts_page *page, const char *value); /* a0 .. a6, b0 .. b6, letter, legal, tabloid, WxH */
int paper_set_scale(roberts_placement *placement, const char *value);        /* 1:20, 2:1, 0.05, standard */
int paper_set_unit(roberts_placement *placement, const char *value);         /* mm, cm, m, in, ft */
int paper_set_align(roberts_placement *placement, const char *value);        /* center, top-left, ... */
int paper_set_order(roberts_draw_options *options, const char *value);       /* travel, none */
int paper_set_dash(roberts_draw_options *options, const char *value);        /* pattern, real */
int paper_set_background(roberts_background *background, const char *value); /* none, or a colour */

/* CLASS:key=value,... Dashes of 12 and gaps of 3 widths follow the width where it changes. */
int paper_set_style(roberts_draw_options *options, const char *value);

#endif
