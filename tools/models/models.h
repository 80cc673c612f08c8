/* models.h - everything that the generator can make. */
#ifndef MODELS_MODELS_H
#define MODELS_MODELS_H

#include <stdbool.h>
#include <stdio.h>

#include "body.h"

/* ---- committed models: completed, then written ----------------------------------------------------------------- */

/* One scene for each outcome of tests 1 to 4: the plate, solid 0, and a tetrahedron with the edge 8-9 under test. */
size_t case_count(void);
const char *case_name(size_t i);
void case_about(size_t i, char *text, size_t size);
void case_make(body *b, size_t i);

/* Star polyhedra, centred at the origin. */
size_t star_count(void);
const char *star_name(size_t i);
const char *star_about(size_t i);
void star_make(body *b, size_t i);

typedef struct scene {
    const char *name, *about;
    void (*make)(body *b);
} scene;

size_t scene_count(void);
const scene *scene_at(size_t i);

/* Bodies that are not convex, from formulas. */
size_t shape_count(void);
const scene *shape_at(size_t i);

/* ---- families of any size: made solid by solid while being written --------------------------------------------- */

typedef struct family {
    const char *name, *arguments;
    const char *about;     /* one line or two, where N is the argument */
    uint64_t least, limit; /* bounds of N */
    bool seeded;
} family;

size_t family_count(void);
const family *family_at(size_t i);

/* Writes the scene of family i; `seed` is used if the family is random. False: writing failed. */
bool family_write(size_t i, uint64_t n, uint64_t seed, FILE *file);

#endif
