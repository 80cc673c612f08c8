/* deflater.h - bytes compressed by zlib, for PDF and PNG. */
#ifndef ROBERTS_WRITE_DEFLATER_H
#define ROBERTS_WRITE_DEFLATER_H

#include <zlib.h>

#include "roberts.h"

typedef struct deflater {
    z_stream z;
    roberts_write_fn *write; /* where the compressed bytes go, in blocks */
    void *context;
    unsigned char block[16384];
} deflater;

/* `level` is zlib's, 1 (fast) to 9. False: no memory. After true, deflater_end() releases what zlib holds. */
bool deflater_start(deflater *d, int level, roberts_write_fn *write, void *context);

/* A roberts_write_fn: compresses bytes for the deflater `context`. False: a write has failed. */
bool deflater_write(void *context, const void *bytes, size_t size);

/* Writes the rest. False: a write has failed. */
bool deflater_finish(deflater *d);

void deflater_end(deflater *d);

#endif
