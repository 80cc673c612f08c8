/* array.h - memory for arrays: counted allocation, and growth by doubling, both safe against overflow. Large arrays lie
 * in large pages of memory, if the system has them. */
#ifndef ROBERTS_BASE_ARRAY_H
#define ROBERTS_BASE_ARRAY_H

#include <stdbool.h>
#include <stddef.h>

/* Allocates `count` elements of `size` bytes, not initialised. NULL: no memory, or the product overflows; never NULL
 * for a count of 0. Release with free(). */
void *alloc_array(size_t count, size_t size);

/* Does the same for an array of which large parts may never be written. Such parts cost no memory. */
void *alloc_sparse(size_t count, size_t size);

/* Allocates the same, zeroed. */
void *alloc_zeroed(size_t count, size_t size);

/* Tells the system that these bytes of an array from alloc_sparse() will be written soon: it provides their memory at
 * once, and need not interrupt the program for each page. */
void array_expect(void *first, size_t bytes);

/* Makes `*array` hold at least `need` elements of `size` bytes, and at least doubles `*room`, so that appending takes
 * amortized constant time. False: no memory; nothing has changed. */
bool array_grow(void *array, size_t *room, size_t need, size_t size);

static inline bool array_reserve(void *array, size_t *room, size_t need, size_t size)
{
    return need <= *room || array_grow(array, room, need, size);
}

#endif
