/* drawing.h - drawings made by hand, and where their bytes go: for the tests of src/draw/. */
#ifndef ROBERTS_TESTS_DRAWING_H
#define ROBERTS_TESTS_DRAWING_H

#include <stdlib.h>
#include <string.h>

#include "roberts.h"

/* A visible segment from (x0, y0) to (x1, y1). */
static inline roberts_segment line_at(roberts_line line, double x0, double y0, double x1, double y1)
{
    return (roberts_segment){.v1 = 1,
                             .by = ROBERTS_NONE,
                             .t1 = 1.0,
                             .p0 = {x0, y0},
                             .p1 = {x1, y1},
                             .state = ROBERTS_VISIBLE,
                             .line = (uint8_t)line};
}

/* What a writer was given. With `room` above 0 it fails with ENOSPC once it has got that much. */
typedef struct sink {
    char *bytes;
    size_t size, room;
} sink;

static inline bool sink_write(void *context, const void *bytes, size_t size)
{
    sink *to = context;
    if (to->room && to->size + size > to->room) {
        errno = ENOSPC;
        return false;
    }
    char *grown = realloc(to->bytes, to->size + size + 1);
    if (!grown)
        return false;
    to->bytes = grown;
    memcpy(grown + to->size, bytes, size);
    to->size += size;
    grown[to->size] = '\0';
    return true;
}

#endif
