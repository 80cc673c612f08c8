/* array.h - memory for arrays: counted allocation and growth by doubling, both safe against overflow. */
#ifndef ROBERTS_BASE_ARRAY_H
#define ROBERTS_BASE_ARRAY_H

#include <stdbool.h>
#include <stddef.h>

/* Room for `count` elements of `size` bytes, not initialised; NULL: no memory, or the product overflows. Never NULL for
 * a count of 0. Released by free(). */
void *alloc_array(size_t count, size_t size);

/* The same, zeroed. */
void *alloc_zeroed(size_t count, size_t size);

/* Makes `*array` hold at least `need` elements of `size` bytes, at least doubling `*room`, so that appending one by one
 * costs constant time each. False: no memory, and nothing has changed. */
bool array_grow(void *array, size_t *room, size_t need, size_t size);

static inline bool array_reserve(void *array, size_t *room, size_t need, size_t size)
{
    return need <= *room || array_grow(array, room, need, size);
}

#endif
