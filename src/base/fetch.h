/* fetch.h - asking for memory before it is needed: only the time changes. */
#ifndef ROBERTS_BASE_FETCH_H
#define ROBERTS_BASE_FETCH_H

#include <stddef.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

/* Bytes that come together, and of an array the most that are asked for: more might be put out again before their turn. */
enum { FETCH_LINE = 64, FETCH_MOST = 512 };

/* Macros: GCC takes a function that only asks ahead for one that does nothing, and leaves calls of it out. */
#if defined(__SSE2__)
#define FETCH_AHEAD(p) _mm_prefetch((const char *)(p), _MM_HINT_T0)
#else
#define FETCH_AHEAD(p) ((void)(p))
#endif

/* The first `size` bytes, but no more than FETCH_MOST. */
#define FETCH_ARRAY(p, size)                                                                                           \
    for (size_t fetched = 0, all = (size) < FETCH_MOST ? (size) : FETCH_MOST; fetched < all; fetched += FETCH_LINE)    \
    FETCH_AHEAD((const char *)(p) + fetched)

#endif
