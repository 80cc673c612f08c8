/* makers.h - functions that make scenes of families and are used outside their own file. */
#ifndef ROBERTS_TESTS_MAKERS_H
#define ROBERTS_TESTS_MAKERS_H

#include "studio.h"

/* families.c: coordinates are integers and halves */
void make_blocks(studio *st);
void make_bricks(studio *st);
void make_checker(studio *st);
void make_crowd(studio *st);
void make_any_exact(studio *st);

/* families_rough.c */
void make_rough_boxes(studio *st);
void make_rough_hexagons(studio *st);
void make_rough_twelve_sided(studio *st);
void make_rough_rhombic(studio *st);
void make_rough_truncated(studio *st);
void make_digits(studio *st);
void make_digits_in_triangles(studio *st);
void make_digits_convex(studio *st);
void make_honeycomb(studio *st);
void make_honeycomb_turned(studio *st);
void make_beams(studio *st);
void make_tilted_beams(studio *st);
void make_crowd_in_plane(studio *st);

#endif
