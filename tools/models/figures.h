/* figures.h - models for figures: arrangements, groups of solids, objects to draw from several sides. */
#ifndef MODELS_FIGURES_H
#define MODELS_FIGURES_H

#include "body.h"

void chair(body *b);
void spiral_staircase(body *b);
void octahedra(body *b);
void icosahedra(body *b);
void cubic_space(body *b);
void platonic_solids(body *b);
void archimedean_solids(body *b);

/* In blocks.c. */
void five_tetrahedra(body *b);
void menger_sponge(body *b);
void locomotive(body *b);

/* In crystals.c. */
void crystals(body *b);

#endif
