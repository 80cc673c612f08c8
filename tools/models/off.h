/* off.h - writes OFF text: comment, counts, vertices, faces, in that order, without holding the model in memory. */
#ifndef MODELS_OFF_H
#define MODELS_OFF_H

#include <stdbool.h>
#include <stdio.h>

#include "body.h"

typedef struct off_writer {
    FILE *file;
    size_t fill;
    bool failed; /* some write has failed */
    char buffer[1 << 16];
} off_writer;

/* Writes "OFF", the lines of `comment`, each after "# ", and the counts. */
void off_begin(off_writer *w, FILE *file, const char *comment, uint64_t vertex_count, uint64_t face_count);

/* Writes coordinates like "%.17g": they read back as the same doubles. */
void off_vertices(off_writer *w, const body *b);

/* `base`: the number of the body's first vertex in the file. */
void off_faces(off_writer *w, const body *b, uint64_t base);

/* Writes the rest. False: some write has failed (errno is that of the last one). */
bool off_end(off_writer *w);

#endif
