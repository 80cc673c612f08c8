/* lanes.h - two doubles or four floats at a time.
 *
 * With SSE2, which every x86-64 processor has, and with the lanes of WebAssembly, each operation is one instruction or
 * a few. The plain C beside it gives the same bits everywhere, and a test compares them. Nothing here rounds
 * differently from the scalar expression. */
#ifndef ROBERTS_BASE_LANES_H
#define ROBERTS_BASE_LANES_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/* The plain form of every operation, lane by lane. */
typedef struct two_plain {
    double v[2];
} two_plain;

typedef struct four_plain {
    float v[4];
} four_plain;

static inline two_plain two_plain_load(const double *p)
{
    return (two_plain){{p[0], p[1]}};
}

static inline void two_plain_store(double *p, two_plain a)
{
    p[0] = a.v[0];
    p[1] = a.v[1];
}

static inline two_plain two_plain_all(double x)
{
    return (two_plain){{x, x}};
}

static inline two_plain two_plain_of(double x0, double x1)
{
    return (two_plain){{x0, x1}};
}

static inline two_plain two_plain_add(two_plain a, two_plain b)
{
    return (two_plain){{a.v[0] + b.v[0], a.v[1] + b.v[1]}};
}

static inline two_plain two_plain_sub(two_plain a, two_plain b)
{
    return (two_plain){{a.v[0] - b.v[0], a.v[1] - b.v[1]}};
}

static inline two_plain two_plain_mul(two_plain a, two_plain b)
{
    return (two_plain){{a.v[0] * b.v[0], a.v[1] * b.v[1]}};
}

static inline two_plain two_plain_div(two_plain a, two_plain b)
{
    return (two_plain){{a.v[0] / b.v[0], a.v[1] / b.v[1]}};
}

static inline two_plain two_plain_sqrt(two_plain a)
{
    return (two_plain){{sqrt(a.v[0]), sqrt(a.v[1])}};
}

/* Returns -1 if a < 0, otherwise 1. */
static inline two_plain two_plain_side(two_plain a)
{
    return (two_plain){{a.v[0] < 0.0 ? -1.0 : 1.0, a.v[1] < 0.0 ? -1.0 : 1.0}};
}

/* Stores lane 0 to *p and lane 1 to *q. */
static inline void two_plain_part(double *p, double *q, two_plain a)
{
    *p = a.v[0];
    *q = a.v[1];
}

/* Stores the lanes rounded to floats. */
static inline void two_plain_part_floats(float *p, float *q, two_plain a)
{
    *p = (float)a.v[0];
    *q = (float)a.v[1];
}

static inline two_plain two_plain_lesser(two_plain a, two_plain b)
{
    return (two_plain){{a.v[0] < b.v[0] ? a.v[0] : b.v[0], a.v[1] < b.v[1] ? a.v[1] : b.v[1]}};
}

static inline two_plain two_plain_greater(two_plain a, two_plain b)
{
    return (two_plain){{a.v[0] > b.v[0] ? a.v[0] : b.v[0], a.v[1] > b.v[1] ? a.v[1] : b.v[1]}};
}

static inline two_plain two_plain_abs(two_plain a)
{
    return (two_plain){{fabs(a.v[0]), fabs(a.v[1])}};
}

/* Bit i: the sign bit of lane i. */
static inline unsigned two_plain_signs(two_plain a)
{
    return (signbit(a.v[0]) ? 1u : 0u) | (signbit(a.v[1]) ? 2u : 0u);
}

/* Bit i: a[i] <= b[i]. */
static inline unsigned two_plain_at_most(two_plain a, two_plain b)
{
    return (a.v[0] <= b.v[0] ? 1u : 0u) | (a.v[1] <= b.v[1] ? 2u : 0u);
}

/* Returns the lesser of the two lanes. */
static inline double two_plain_least(two_plain a)
{
    return a.v[0] < a.v[1] ? a.v[0] : a.v[1];
}

static inline four_plain four_plain_load(const float *p)
{
    return (four_plain){{p[0], p[1], p[2], p[3]}};
}

static inline void four_plain_store(float *p, four_plain a)
{
    for (int i = 0; i < 4; i++)
        p[i] = a.v[i];
}

static inline four_plain four_plain_all(float x)
{
    return (four_plain){{x, x, x, x}};
}

/* Compares a[i] < b[i]; only for four_plain_either() and four_plain_signs(). */
static inline four_plain four_plain_below(four_plain a, four_plain b)
{
    return (four_plain){{a.v[0] < b.v[0] ? -1.0f : 0.0f, a.v[1] < b.v[1] ? -1.0f : 0.0f, a.v[2] < b.v[2] ? -1.0f : 0.0f,
                         a.v[3] < b.v[3] ? -1.0f : 0.0f}};
}

/* Combines two comparisons by "or". */
static inline four_plain four_plain_either(four_plain a, four_plain b)
{
    for (int i = 0; i < 4; i++)
        a.v[i] = a.v[i] < b.v[i] ? a.v[i] : b.v[i];
    return a;
}

/* Bit i: the comparison holds in lane i. */
static inline unsigned four_plain_signs(four_plain a)
{
    return (a.v[0] < 0.0f ? 1u : 0u) | (a.v[1] < 0.0f ? 2u : 0u) | (a.v[2] < 0.0f ? 4u : 0u) |
           (a.v[3] < 0.0f ? 8u : 0u);
}

static inline four_plain four_plain_sub(four_plain a, four_plain b)
{
    return (four_plain){{a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2], a.v[3] - b.v[3]}};
}

static inline four_plain four_plain_mul(four_plain a, four_plain b)
{
    return (four_plain){{a.v[0] * b.v[0], a.v[1] * b.v[1], a.v[2] * b.v[2], a.v[3] * b.v[3]}};
}

static inline four_plain four_plain_add(four_plain a, four_plain b)
{
    return (four_plain){{a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2], a.v[3] + b.v[3]}};
}

static inline four_plain four_plain_div(four_plain a, four_plain b)
{
    return (four_plain){{a.v[0] / b.v[0], a.v[1] / b.v[1], a.v[2] / b.v[2], a.v[3] / b.v[3]}};
}

/* Returns the lesser, or the greater, of a[i] and b[i]; b[i] if one of them is NaN. */
static inline four_plain four_plain_lesser(four_plain a, four_plain b)
{
    for (int i = 0; i < 4; i++)
        a.v[i] = a.v[i] < b.v[i] ? a.v[i] : b.v[i];
    return a;
}

static inline four_plain four_plain_greater(four_plain a, four_plain b)
{
    for (int i = 0; i < 4; i++)
        a.v[i] = a.v[i] > b.v[i] ? a.v[i] : b.v[i];
    return a;
}

/* Bit i: a[i] <= b[i]. */
static inline unsigned four_plain_at_most(four_plain a, four_plain b)
{
    return (a.v[0] <= b.v[0] ? 1u : 0u) | (a.v[1] <= b.v[1] ? 2u : 0u) | (a.v[2] <= b.v[2] ? 4u : 0u) |
           (a.v[3] <= b.v[3] ? 8u : 0u);
}

/* Byte i: a[i] clamped to 0 .. 255 and rounded down; 0 for NaN. */
static inline uint32_t four_plain_bytes(four_plain a)
{
    uint32_t bytes = 0;
    for (int i = 0; i < 4; i++)
        bytes |= (a.v[i] > 0.0f ? a.v[i] < 255.0f ? (uint32_t)a.v[i] : 255u : 0u) << 8 * i;
    return bytes;
}

/* Bit i: no byte of a[2 i + 1] exceeds the same byte of `most`; i = 0 .. 3. */
static inline unsigned four_plain_bytes_at_most(const uint32_t *a, uint32_t most)
{
    unsigned bits = 0;
    for (int i = 0; i < 4; i++) {
        bool within = true;
        for (int k = 0; k < 32; k += 8)
            within = within && (a[2 * i + 1] >> k & 255) <= (most >> k & 255);
        bits |= (within ? 1u : 0u) << i;
    }
    return bits;
}

/* Compares a[i] == x, like four_plain_below(). */
static inline four_plain four_plain_same(const uint32_t *a, uint32_t x)
{
    return (four_plain){
        {a[0] == x ? -1.0f : 0.0f, a[1] == x ? -1.0f : 0.0f, a[2] == x ? -1.0f : 0.0f, a[3] == x ? -1.0f : 0.0f}};
}

/* Is b[i] - a[i] == shift for i = 0 .. 3? */
static inline bool four_plain_shifted(const uint32_t *a, const uint32_t *b, uint32_t shift)
{
    return b[0] - a[0] == shift && b[1] - a[1] == shift && b[2] - a[2] == shift && b[3] - a[3] == shift;
}

#if defined(__SSE2__)

#include <emmintrin.h>

typedef __m128d two;
typedef __m128 four;

/* Loads from an address that is a multiple of 16 bytes. */
static inline two two_load_aligned(const double *p)
{
    return _mm_load_pd(p);
}

static inline void two_store(double *p, two a)
{
    _mm_storeu_pd(p, a);
}

static inline two two_all(double x)
{
    return _mm_set1_pd(x);
}

static inline two two_of(double x0, double x1)
{
    return _mm_set_pd(x1, x0);
}

static inline two two_add(two a, two b)
{
    return _mm_add_pd(a, b);
}

static inline two two_sub(two a, two b)
{
    return _mm_sub_pd(a, b);
}

static inline two two_mul(two a, two b)
{
    return _mm_mul_pd(a, b);
}

static inline two two_div(two a, two b)
{
    return _mm_div_pd(a, b);
}

static inline two two_sqrt(two a)
{
    return _mm_sqrt_pd(a);
}

static inline two two_side(two a)
{
    return _mm_or_pd(_mm_set1_pd(1.0), _mm_and_pd(_mm_set1_pd(-0.0), _mm_cmplt_pd(a, _mm_setzero_pd())));
}

static inline void two_part(double *p, double *q, two a)
{
    _mm_storel_pd(p, a);
    _mm_storeh_pd(q, a);
}

static inline void two_part_floats(float *p, float *q, two a)
{
    four both = _mm_cvtpd_ps(a);
    _mm_store_ss(p, both);
    _mm_store_ss(q, _mm_shuffle_ps(both, both, 1));
}

static inline two two_lesser(two a, two b)
{
    return _mm_min_pd(a, b);
}

static inline two two_greater(two a, two b)
{
    return _mm_max_pd(a, b);
}

static inline two two_abs(two a)
{
    return _mm_andnot_pd(_mm_set1_pd(-0.0), a);
}

static inline unsigned two_signs(two a)
{
    return (unsigned)_mm_movemask_pd(a);
}

static inline unsigned two_at_most(two a, two b)
{
    return (unsigned)_mm_movemask_pd(_mm_cmple_pd(a, b));
}

static inline double two_least(two a)
{
    return _mm_cvtsd_f64(_mm_min_sd(a, _mm_unpackhi_pd(a, a)));
}

static inline four four_load(const float *p)
{
    return _mm_loadu_ps(p);
}

static inline void four_store(float *p, four a)
{
    _mm_storeu_ps(p, a);
}

static inline four four_all(float x)
{
    return _mm_set1_ps(x);
}

static inline four four_below(four a, four b)
{
    return _mm_cmplt_ps(a, b);
}

static inline four four_either(four a, four b)
{
    return _mm_or_ps(a, b);
}

static inline unsigned four_signs(four a)
{
    return (unsigned)_mm_movemask_ps(a);
}

static inline four four_sub(four a, four b)
{
    return _mm_sub_ps(a, b);
}

static inline four four_mul(four a, four b)
{
    return _mm_mul_ps(a, b);
}

static inline four four_add(four a, four b)
{
    return _mm_add_ps(a, b);
}

static inline four four_div(four a, four b)
{
    return _mm_div_ps(a, b);
}

static inline four four_lesser(four a, four b)
{
    return _mm_min_ps(a, b);
}

static inline four four_greater(four a, four b)
{
    return _mm_max_ps(a, b);
}

static inline unsigned four_at_most(four a, four b)
{
    return (unsigned)_mm_movemask_ps(_mm_cmple_ps(a, b));
}

static inline uint32_t four_bytes(four a)
{
    __m128i whole = _mm_cvttps_epi32(_mm_min_ps(_mm_max_ps(a, _mm_setzero_ps()), _mm_set1_ps(255.0f)));
    whole = _mm_packs_epi32(whole, whole);
    return (uint32_t)_mm_cvtsi128_si32(_mm_packus_epi16(whole, whole));
}

static inline unsigned four_bytes_at_most(const uint32_t *a, uint32_t most)
{
    __m128 low = _mm_castsi128_ps(_mm_loadu_si128((const __m128i *)a));
    __m128 high = _mm_castsi128_ps(_mm_loadu_si128((const __m128i *)(a + 4)));
    __m128i odd = _mm_castps_si128(_mm_shuffle_ps(low, high, _MM_SHUFFLE(3, 1, 3, 1)));
    __m128i within = _mm_cmpeq_epi8(_mm_min_epu8(odd, _mm_set1_epi32((int)most)), odd);
    return (unsigned)_mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(within, _mm_set1_epi32(-1))));
}

static inline four four_same(const uint32_t *a, uint32_t x)
{
    return _mm_castsi128_ps(_mm_cmpeq_epi32(_mm_loadu_si128((const __m128i *)a), _mm_set1_epi32((int)x)));
}

static inline bool four_shifted(const uint32_t *a, const uint32_t *b, uint32_t shift)
{
    __m128i apart = _mm_sub_epi32(_mm_loadu_si128((const __m128i *)b), _mm_loadu_si128((const __m128i *)a));
    return _mm_movemask_epi8(_mm_cmpeq_epi32(apart, _mm_set1_epi32((int)shift))) == 0xffff;
}

#elif defined(__wasm_simd128__)

#include <wasm_simd128.h>

typedef v128_t two;
typedef v128_t four;

static inline two two_load_aligned(const double *p)
{
    return wasm_v128_load(p);
}

static inline void two_store(double *p, two a)
{
    wasm_v128_store(p, a);
}

static inline two two_of(double x0, double x1)
{
    return wasm_f64x2_make(x0, x1);
}

static inline two two_side(two a)
{
    return wasm_v128_or(wasm_f64x2_splat(1.0),
                        wasm_v128_and(wasm_f64x2_splat(-0.0), wasm_f64x2_lt(a, wasm_f64x2_splat(0.0))));
}

static inline void two_part(double *p, double *q, two a)
{
    *p = wasm_f64x2_extract_lane(a, 0);
    *q = wasm_f64x2_extract_lane(a, 1);
}

static inline void two_part_floats(float *p, float *q, two a)
{
    *p = (float)wasm_f64x2_extract_lane(a, 0);
    *q = (float)wasm_f64x2_extract_lane(a, 1);
}

/* wasm_f64x2_pmin(b, a) is a < b ? a : b. */
static inline two two_lesser(two a, two b)
{
    return wasm_f64x2_pmin(b, a);
}

static inline two two_greater(two a, two b)
{
    return wasm_f64x2_pmax(b, a);
}

static inline unsigned two_at_most(two a, two b)
{
    return wasm_i64x2_bitmask(wasm_f64x2_le(a, b));
}

static inline double two_least(two a)
{
    double p = wasm_f64x2_extract_lane(a, 0), q = wasm_f64x2_extract_lane(a, 1);
    return p < q ? p : q;
}

static inline four four_load(const float *p)
{
    return wasm_v128_load(p);
}

static inline void four_store(float *p, four a)
{
    wasm_v128_store(p, a);
}

static inline four four_lesser(four a, four b)
{
    return wasm_f32x4_pmin(b, a);
}

static inline four four_greater(four a, four b)
{
    return wasm_f32x4_pmax(b, a);
}

static inline unsigned four_at_most(four a, four b)
{
    return wasm_i32x4_bitmask(wasm_f32x4_le(a, b));
}

static inline uint32_t four_bytes(four a)
{
    const four low = wasm_f32x4_splat(0.0f), high = wasm_f32x4_splat(255.0f);
    v128_t whole = wasm_i32x4_trunc_sat_f32x4(four_lesser(four_greater(a, low), high));
    whole = wasm_i16x8_narrow_i32x4(whole, whole);
    return (uint32_t)wasm_i32x4_extract_lane(wasm_u8x16_narrow_i16x8(whole, whole), 0);
}

static inline unsigned four_bytes_at_most(const uint32_t *a, uint32_t most)
{
    v128_t odd = wasm_i32x4_shuffle(wasm_v128_load(a), wasm_v128_load(a + 4), 1, 3, 5, 7);
    v128_t within = wasm_i8x16_eq(wasm_u8x16_min(odd, wasm_i32x4_splat((int)most)), odd);
    return wasm_i32x4_bitmask(wasm_i32x4_eq(within, wasm_i32x4_splat(-1)));
}

static inline four four_same(const uint32_t *a, uint32_t x)
{
    return wasm_i32x4_eq(wasm_v128_load(a), wasm_i32x4_splat((int)x));
}

static inline bool four_shifted(const uint32_t *a, const uint32_t *b, uint32_t shift)
{
    v128_t apart = wasm_i32x4_sub(wasm_v128_load(b), wasm_v128_load(a));
    return wasm_i32x4_all_true(wasm_i32x4_eq(apart, wasm_i32x4_splat((int)shift)));
}

#define two_all wasm_f64x2_splat
#define two_add wasm_f64x2_add
#define two_sub wasm_f64x2_sub
#define two_mul wasm_f64x2_mul
#define two_div wasm_f64x2_div
#define two_sqrt wasm_f64x2_sqrt
#define two_abs wasm_f64x2_abs
#define two_signs (unsigned)wasm_i64x2_bitmask
#define four_all wasm_f32x4_splat
#define four_below wasm_f32x4_lt
#define four_either wasm_v128_or
#define four_signs (unsigned)wasm_i32x4_bitmask
#define four_sub wasm_f32x4_sub
#define four_mul wasm_f32x4_mul
#define four_add wasm_f32x4_add
#define four_div wasm_f32x4_div

#else

typedef two_plain two;
typedef four_plain four;
#define two_load_aligned two_plain_load
#define two_store two_plain_store
#define two_all two_plain_all
#define two_of two_plain_of
#define two_add two_plain_add
#define two_sub two_plain_sub
#define two_mul two_plain_mul
#define two_div two_plain_div
#define two_sqrt two_plain_sqrt
#define two_side two_plain_side
#define two_part two_plain_part
#define two_part_floats two_plain_part_floats
#define two_lesser two_plain_lesser
#define two_greater two_plain_greater
#define two_abs two_plain_abs
#define two_signs two_plain_signs
#define two_at_most two_plain_at_most
#define two_least two_plain_least
#define four_load four_plain_load
#define four_store four_plain_store
#define four_all four_plain_all
#define four_below four_plain_below
#define four_either four_plain_either
#define four_signs four_plain_signs
#define four_sub four_plain_sub
#define four_mul four_plain_mul
#define four_add four_plain_add
#define four_div four_plain_div
#define four_lesser four_plain_lesser
#define four_greater four_plain_greater
#define four_at_most four_plain_at_most
#define four_bytes four_plain_bytes
#define four_bytes_at_most four_plain_bytes_at_most
#define four_same four_plain_same
#define four_shifted four_plain_shifted

#endif

#endif
