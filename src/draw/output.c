/* output.c - bytes on their way out: one buffer before the caller's function. */
#include "draw/output.h"

#include <errno.h>
#include <string.h>

#include "base/error.h"
#include "draw/decimal.h"

void output_start(output *out, roberts_write_fn *write, void *context)
{
    out->write = write;
    out->context = context;
    out->used = 0;
    out->failed = false;
    out->reason = 0;
}

static void pass_on(output *out, const void *bytes, size_t size)
{
    if (out->failed || size == 0)
        return;
    errno = 0;
    if (!out->write(out->context, bytes, size)) {
        out->failed = true;
        out->reason = errno ? errno : EIO; /* a function that sets none */
    }
}

static void flush(output *out)
{
    pass_on(out, out->bytes, out->used);
    out->used = 0;
}

void output_bytes(output *out, const void *bytes, size_t size)
{
    if (size > sizeof out->bytes - out->used)
        flush(out);
    if (size > sizeof out->bytes) {
        pass_on(out, bytes, size);
        return;
    }
    memcpy(out->bytes + out->used, bytes, size);
    out->used += size;
}

void output_text(output *out, const char *text)
{
    output_bytes(out, text, strlen(text));
}

void output_number(output *out, double x)
{
    if (DECIMAL_ROOM > sizeof out->bytes - out->used)
        flush(out);
    out->used += decimal_format(out->bytes + out->used, x);
}

void output_integer(output *out, uint32_t n)
{
    char text[10];
    size_t at = sizeof text;
    do {
        text[--at] = (char)('0' + n % 10);
        n /= 10;
    } while (n);
    output_bytes(out, text + at, sizeof text - at);
}

roberts_status output_finish(output *out, roberts_error *error)
{
    flush(out);
    return out->failed ? output_error(error, "cannot write", out->reason) : ROBERTS_OK;
}

roberts_status output_error(roberts_error *error, const char *what, int reason)
{
    char text[128];
    if (strerror_r(reason, text, sizeof text) != 0)
        return error_set(error, ROBERTS_IO, 0, "%s: error %d", what, reason);
    return error_set(error, ROBERTS_IO, 0, "%s: %s", what, text);
}
