/* put_text.h - texts of models in the making, too long for an array on the stack. */
#ifndef ROBERTS_TESTS_PUT_TEXT_H
#define ROBERTS_TESTS_PUT_TEXT_H

#include <stdarg.h>
#include <stdio.h>

#include "testing.h"

enum { PUT_ROOM = 1 << 17, PUT_MOST = 256 };

/* Free `at` with test_free(). */
typedef struct put_text {
    char *at; /* [PUT_ROOM] */
    size_t count;
} put_text;

static inline put_text put_begin(void)
{
    return (put_text){test_malloc(PUT_ROOM), 0};
}

/* Appends fewer than PUT_MOST characters, as printf() does. */
static inline void put(put_text *t, const char *format, ...)
{
    va_list arguments;
    assert_true(PUT_ROOM - t->count > PUT_MOST);
    va_start(arguments, format);
    const int count = vsnprintf(t->at + t->count, PUT_MOST, format, arguments);
    va_end(arguments);
    assert_true(count >= 0 && count < PUT_MOST);
    t->count += (size_t)count;
}

#endif
