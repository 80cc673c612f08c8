/* deflater.c - bytes compressed by zlib. */
#include "write/deflater.h"

#include <limits.h>
#include <stdint.h>

bool deflater_start(deflater *d, int level, roberts_write_fn *write, void *context)
{
    d->z = (z_stream){.next_out = d->block, .avail_out = sizeof d->block};
    d->write = write;
    d->context = context;
    return deflateInit(&d->z, level) == Z_OK;
}

/* Passes on the block. */
static bool pass_on(deflater *d)
{
    size_t size = sizeof d->block - d->z.avail_out;
    d->z.next_out = d->block;
    d->z.avail_out = sizeof d->block;
    return size == 0 || d->write(d->context, d->block, size);
}

bool deflater_write(void *context, const void *bytes, size_t size)
{
    deflater *d = context;
    while (size) {
        uInt some = size < UINT_MAX ? (uInt)size : UINT_MAX;
        d->z.next_in = (Bytef *)(uintptr_t)bytes; /* zlib only reads it */
        d->z.avail_in = some;
        while (d->z.avail_in) {
            deflate(&d->z, Z_NO_FLUSH);
            if (d->z.avail_out == 0 && !pass_on(d))
                return false;
        }
        bytes = (const char *)bytes + some;
        size -= some;
    }
    return true;
}

bool deflater_finish(deflater *d)
{
    while (deflate(&d->z, Z_FINISH) != Z_STREAM_END)
        if (!pass_on(d))
            return false;
    return pass_on(d);
}

void deflater_end(deflater *d)
{
    deflateEnd(&d->z);
}
