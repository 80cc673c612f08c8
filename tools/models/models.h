/* models.h - what the generator can make. */
#ifndef MODELS_MODELS_H
#define MODELS_MODELS_H

#include <stdbool.h>
#include <stdio.h>

#include "body.h"

/* ---- committed models: made whole, then written ---------------------------------------------------------------- */

/* One scene for an outcome of tests 1 to 4: the plate, solid 0, and a tetrahedron whose edge 8-9 meets it. */
size_t case_count(void);
const char *case_name(size_t i);
void case_about(size_t i, char *text, size_t size);
void case_make(body *b, size_t i);

/* One star polyhedron, centred at the origin. */
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

/* Bodies that are not convex, by formula. */
size_t shape_count(void);
const scene *shape_at(size_t i);

/* ---- families of any size: made solid by solid while being written --------------------------------------------- */

typedef struct family {
    const char *name, *arguments;
    const char *about;     /* one line or two, N being the argument */
    uint64_t least, limit; /* bounds of N */
    bool seeded;
} family;

size_t family_count(void);
const family *family_at(size_t i);

/* Writes the scene of family i; `seed` counts where it is seeded. False where writing failed. */
bool family_write(size_t i, uint64_t n, uint64_t seed, FILE *file);

#endif
