/* region_judge.h - compares the visible regions that the library finds with those of the region oracle. */
#ifndef ROBERTS_TESTS_REGION_JUDGE_H
#define ROBERTS_TESTS_REGION_JUDGE_H

#include <stdio.h>

#include "mesh_judge.h"
#include "region_oracle.h"

typedef struct region_total {
    size_t scenes, regions, rings, pieces; /* compared; pieces of borders are the oracle's */
    size_t unseen;                         /* faces of which nothing is seen */
    size_t disagreements;                  /* faces, or whole scenes that the program refused */
    size_t refused;                        /* scenes that the oracle refused, or that have no face */
    double worst;                          /* greatest difference of a face that did not fail, part of the picture */
    size_t questions, exact;               /* as in region_truth */
} region_total;

/* A face fails if its area or its border differs by more than this part of the picture (of its square). */
#define REGION_JUDGE_LIMIT 1e-9

/* Compares each face: the area, and the area that is stated; the length of the border; each piece of the oracle's
 * border must lie on a ring and have the face on the same side; each corner of a ring must lie on such a piece.
 * Adds to `total`. The first few faces that fail are told on `out`. Returns how many failed. */
size_t region_judge_list(const char *name, const mesh_scene *scene, const region_truth *truth,
                         const roberts_region_list *list, region_total *total, FILE *out);

/* Finds the regions of a scene, each of its bodies for itself, and compares them. A scene that fails is written to
 * FOLDER/failures/NAME.off, and the command that draws it is told. Returns whether everything agreed. */
bool region_judge(const char *name, const mesh_scene *scene, const char *folder, region_total *total, FILE *out);

/* Finds what both say. False: one of them refuses, which is told on `out` and counted. */
bool region_judge_find(const char *name, const mesh_scene *scene, region_truth *truth, roberts_region_list *list,
                       region_total *total, FILE *out);

#endif
