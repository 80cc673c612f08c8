/* same_complaint.h - compares errors of an input read by a function with those of the same input read from memory. */
#ifndef ROBERTS_TESTS_SAME_COMPLAINT_H
#define ROBERTS_TESTS_SAME_COMPLAINT_H

#include <stdbool.h>
#include <string.h>

#include "roberts.h"

/* Are both errors the same? An input that can be read twice is examined again after an error, and then the message says
 * more, or says that it is not OFF. */
static inline bool same_complaint(const roberts_error *once, const roberts_error *twice)
{
    size_t length = strlen(once->message);
    if (once->status != twice->status)
        return false;
    if (strncmp(twice->message, "this looks like ", 16) == 0)
        return twice->line == 0;
    return once->line == twice->line && strncmp(once->message, twice->message, length) == 0 &&
           (twice->message[length] == '\0' || strncmp(twice->message + length, "; look: line ", 13) == 0);
}

/* Is the size the only sign that this is binary STL? Read from a function, whose size is unknown, it is then something
 * else. */
static inline bool only_size_tells(const void *bytes, size_t size)
{
    const unsigned char *b = bytes;
    return size >= 84 && size == 84 + 50 * (b[80] | (size_t)b[81] << 8 | (size_t)b[82] << 16 | (size_t)b[83] << 24);
}

#endif
