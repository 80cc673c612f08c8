/* array.c - counted allocation, and growth by doubling. */
/* for MADV_HUGEPAGE */
#define _DEFAULT_SOURCE /* NOLINT(bugprone-reserved-identifier): that is its name */
#include "base/array.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

/* Bytes of a large page. */
#define LARGE_PAGE ((size_t)2 << 20)

/* Bytes that malloc() adds to what lies outside its heap, at most. */
#define SPARE ((size_t)4096)

#ifdef MADV_HUGEPAGE
/* Advises the system about all pages that have some of these bytes. */
static void advise(void *first, size_t bytes, int advice)
{
    size_t before = (uintptr_t)first % (uintptr_t)sysconf(_SC_PAGESIZE);
    madvise((char *)first - before, before + bytes, advice);
}
#endif

/* Asks the system for large pages. Otherwise it interrupts the program for every 4 KiB that is written for the first
 * time, which takes up to half of the time of large scenes. The end of the array is where malloc() puts it: if one page
 * were left out, realloc() could not move the array without copying it. */
static void *in_large_pages(void *array, size_t bytes)
{
#ifdef MADV_HUGEPAGE
    if (array && bytes >= LARGE_PAGE)
        advise(array, (bytes + 23) / 16 * 16 - 8, MADV_HUGEPAGE);
#else
    (void)bytes;
#endif
    return array;
}

/* An array of a page and a half or more has pages of its own, and gets the whole of the last one if it fills more than
 * half of it. Otherwise the system would supply that part 4 KiB at a time. */
void *alloc_array(size_t count, size_t size)
{
#ifdef MADV_HUGEPAGE
    void *array = NULL;
    if (size && count <= ((size_t)PTRDIFF_MAX - LARGE_PAGE) / size && count * size >= LARGE_PAGE + LARGE_PAGE / 2) {
        const size_t last = count * size % LARGE_PAGE;
        const size_t bytes = count * size + (last > LARGE_PAGE / 2 ? LARGE_PAGE - last : 0);
        return posix_memalign(&array, LARGE_PAGE, bytes) == 0 ? in_large_pages(array, bytes) : NULL;
    }
#endif
    return alloc_sparse(count, size);
}

void *alloc_sparse(size_t count, size_t size)
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
    return in_large_pages(calloc(count ? count : 1, size ? size : 1), count * size);
}

void array_expect(void *first, size_t bytes)
{
#ifdef MADV_POPULATE_WRITE
    advise(first, bytes, MADV_POPULATE_WRITE);
#else
    (void)first;
    (void)bytes;
#endif
}

/* Makes the array larger. On the way to large pages it is copied here: realloc() would write to the new memory before
 * the system is asked. A large one that fills its pages, with the few bytes that malloc() adds, keeps them when it is
 * moved. */
static void *enlarge(void *array, size_t old, size_t bytes)
{
    if (old >= 2 * LARGE_PAGE || bytes < 2 * LARGE_PAGE)
        return in_large_pages(realloc(array, bytes), bytes);
    void *larger = in_large_pages(malloc(bytes), bytes);
    if (larger && old > 0)
        memcpy(larger, array, old);
    if (larger)
        free(array);
    return larger;
}

bool array_grow(void *array, size_t *room, size_t need, size_t size)
{
    void *old, *grown;
    size_t wanted = *room < 8 ? 8 : *room;
    while (wanted < need && wanted <= SIZE_MAX / 2)
        wanted *= 2;
    if (wanted < need || wanted > ((size_t)PTRDIFF_MAX - 2 * LARGE_PAGE) / size)
        return false;
    if (wanted * size >= LARGE_PAGE)
        wanted = ((wanted * size + SPARE) / LARGE_PAGE * LARGE_PAGE + LARGE_PAGE - SPARE) / size;
    memcpy(&old, array, sizeof old); /* `array` points to a pointer of any type, so it is copied as bytes */
    grown = enlarge(old, *room * size, wanted * size);
    if (!grown)
        return false;
    memcpy(array, &grown, sizeof grown);
    *room = wanted;
    return true;
}
