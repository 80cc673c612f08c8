/* bits.h - operations on 64-bit words: counting zeros, the full product, loading eight characters, spreading bits, a
 * hash; and prefetching.
 *
 * Each uses the compiler's instruction if there is one. The plain C beside it gives the same results everywhere, and a
 * test compares the two. */
#ifndef ROBERTS_BASE_BITS_H
#define ROBERTS_BASE_BITS_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

/* For the few functions and tables whose inlining or visibility makes a measured difference. */
#if defined(__GNUC__)
#define BITS_INLINE static inline __attribute__((__always_inline__))
#define BITS_RARE __attribute__((__noinline__))
#define BITS_HIDDEN __attribute__((__visibility__("hidden"))) /* read directly, even in a shared library */
#else
#define BITS_INLINE static inline
#define BITS_RARE
#define BITS_HIDDEN
#endif

/* For the few functions that take most of the time. Each is compiled twice, and the version for the processor is chosen
 * when the program is loaded. AVX2 has operations with three operands, which save copies, and no others are used: there
 * is no fused multiply-add (-ffp-contract=off), so both give the same bits. Sanitizers cannot run that early. */
#if defined(__x86_64__) && defined(__linux__) && defined(__GLIBC__) && defined(__OPTIMIZE__) &&                        \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
#define BITS_PER_PROCESSOR __attribute__((__target_clones__("avx2", "default")))
#else
#define BITS_PER_PROCESSOR
#endif

/* Returns the number of zero bits above the highest one. word != 0. */
static inline int bits_leading_zeros_plain(uint64_t word)
{
    int count = 0;
    for (int step = 32; step; step /= 2) {
        if (word >> (64 - step) == 0) {
            word <<= step;
            count += step;
        }
    }
    return count;
}

static inline int bits_leading_zeros(uint64_t word)
{
#if defined(__GNUC__)
    return __builtin_clzll(word);
#else
    return bits_leading_zeros_plain(word);
#endif
}

/* Returns the number of zero bits below the lowest one. word != 0. */
static inline int bits_trailing_zeros(uint64_t word)
{
#if defined(__GNUC__)
    return __builtin_ctzll(word);
#else
    return 63 - bits_leading_zeros_plain(word & (0 - word));
#endif
}

/* Computes a * b = high * 2^64 + low from four products of half words; returns high. */
static inline uint64_t bits_multiply_plain(uint64_t a, uint64_t b, uint64_t *low)
{
    uint64_t a0 = a & 0xffffffff, a1 = a >> 32, b0 = b & 0xffffffff, b1 = b >> 32;
    uint64_t middle = a1 * b0 + (a0 * b0 >> 32); /* at most (2^32 - 1)^2 + 2^32 - 1: no overflow */
    uint64_t other = a0 * b1 + (middle & 0xffffffff);
    *low = a * b;
    return a1 * b1 + (middle >> 32) + (other >> 32);
}

/* Computes a * b = high * 2^64 + low; returns high. */
static inline uint64_t bits_multiply(uint64_t a, uint64_t b, uint64_t *low)
{
#if defined(__SIZEOF_INT128__)
    __extension__ typedef unsigned __int128 wide;
    wide product = (wide)a * b;
    *low = (uint64_t)product;
    return (uint64_t)(product >> 64);
#else
    return bits_multiply_plain(a, b, low);
#endif
}

/* Loads eight characters, the first into the lowest byte, on any machine. */
static inline uint64_t bits_load(const char *text)
{
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    uint64_t word;
    memcpy(&word, text, sizeof word);
    return word;
#else
    const unsigned char *c = (const unsigned char *)text;
    return (uint64_t)c[0] | (uint64_t)c[1] << 8 | (uint64_t)c[2] << 16 | (uint64_t)c[3] << 24 | (uint64_t)c[4] << 32 |
           (uint64_t)c[5] << 40 | (uint64_t)c[6] << 48 | (uint64_t)c[7] << 56;
#endif
}

/* Spreads bits 0 to 15 of x, with a zero above each. Two spread numbers, one of them shifted left by one, form the
 * index on the Z-order curve (G. M. Morton, "A computer oriented geodetic data base and a new technique in file
 * sequencing", IBM 1966). */
static inline uint32_t bits_spread(uint32_t x)
{
    x = (x | x << 8) & 0x00ff00ffu;
    x = (x | x << 4) & 0x0f0f0f0fu;
    x = (x | x << 2) & 0x33333333u;
    return (x | x << 1) & 0x55555555u;
}

/* Returns a hash of `size` bytes, a multiple of 4: FNV-1a, word by word (G. Fowler, L. C. Noll, P. Vo). */
static inline uint32_t bits_hash(const void *bytes, size_t size)
{
    uint32_t hash = 2166136261u, word;
    for (size_t i = 0; i < size; i += sizeof word) {
        memcpy(&word, (const char *)bytes + i, sizeof word);
        hash = (hash ^ word) * 16777619u;
    }
    return hash;
}

/* ---- prefetching: affects only the time ------------------------------------------------------------------------ */

/* Bytes: a cache line, and the most to prefetch of an array. More might be evicted before it is used. */
enum { FETCH_LINE = 64, FETCH_MOST = 512 };

/* Macros, because GCC assumes that a function that only prefetches has no effect, and removes its calls. */
#if defined(__SSE2__)
#define FETCH_AHEAD(p) _mm_prefetch((const char *)(p), _MM_HINT_T0)
#else
#define FETCH_AHEAD(p) ((void)(p))
#endif

/* Prefetches the first `size` bytes, but at most FETCH_MOST. */
#define FETCH_ARRAY(p, size)                                                                                           \
    for (size_t fetched = 0, all = (size) < FETCH_MOST ? (size) : FETCH_MOST; fetched < all; fetched += FETCH_LINE)    \
    FETCH_AHEAD((const char *)(p) + fetched)

#endif
