/* array.c - counted allocation, and growth by doubling. */
#include "base/array.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

void *alloc_array(size_t count, size_t size)
{
    if (size && count > (size_t)PTRDIFF_MAX / size)
        return NULL;
    if (count == 0 || size == 0)
        return malloc(1);
    return malloc(count * size);
}

void *alloc_zeroed(size_t count, size_t size)
{
    if (size && count > (size_t)PTRDIFF_MAX / size)
        return NULL;
    return calloc(count ? count : 1, size ? size : 1);
}

bool array_grow(void *array, size_t *room, size_t need, size_t size)
{
    void *old, *grown;
    size_t wanted = *room < 8 ? 8 : *room;
    while (wanted < need && wanted <= SIZE_MAX / 2)
        wanted *= 2;
    if (wanted < need || wanted > (size_t)PTRDIFF_MAX / size)
        return false;
    memcpy(&old, array, sizeof old); /* `array` points to a pointer of any type, so it is copied as bytes */
    grown = realloc(old, wanted * size);
    if (!grown)
        return false;
    memcpy(array, &grown, sizeof grown);
    *room = wanted;
    return true;
}
