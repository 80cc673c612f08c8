/* Double-double numbers against integers of 128 bits, which here are exact: two words with the carry by hand. */
#include "base/bits.h"
#include "base/dd.h"
#include "scenes.h"

/* A unit of rounding, 2^-53, squared: errors are multiples of it. The bounds (3 for a sum, 5 for a product, with all
 * roundings of the form used here) are those of M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds
 * for basic building blocks of double-word arithmetic", ACM TOMS 44(2), 2017. */
#define U2 0x1p-106
#define SUM_BOUND (3.1 * U2)
#define PRODUCT_BOUND (6 * U2)

/* ---- two's complement of 128 bits ------------------------------------------------------------------------------ */

typedef struct wide {
    uint64_t high, low;
} wide;

static wide wide_add(wide a, wide b)
{
    uint64_t low = a.low + b.low;
    return (wide){a.high + b.high + (low < a.low), low};
}

static wide wide_negate(wide a)
{
    return wide_add((wide){~a.high, ~a.low}, (wide){0, 1});
}

static wide wide_subtract(wide a, wide b)
{
    return wide_add(a, wide_negate(b));
}

static wide wide_from(int64_t a)
{
    return (wide){a < 0 ? UINT64_MAX : 0, (uint64_t)a};
}

static wide wide_product(int64_t a, int64_t b)
{
    wide p;
    p.high = bits_multiply_plain(a < 0 ? 0 - (uint64_t)a : (uint64_t)a, b < 0 ? 0 - (uint64_t)b : (uint64_t)b, &p.low);
    return (a < 0) != (b < 0) ? wide_negate(p) : p;
}

static wide wide_shift_left(wide a, int bits)
{
    for (; bits > 0; bits--)
        a = wide_add(a, a);
    return a;
}

/* x: an integer below 2^126. */
static wide wide_from_double(double x)
{
    int exponent;
    double m = frexp(x, &exponent); /* x = (m 2^53) 2^(exponent - 53) */
    if (exponent <= 62)
        return wide_from((int64_t)x);
    return wide_shift_left(wide_from((int64_t)ldexp(m, 53)), exponent - 53);
}

static bool is_negative(wide a)
{
    return a.high >> 63;
}

/* To about 53 bits. */
static double wide_size(wide a)
{
    if (is_negative(a))
        a = wide_negate(a);
    return (double)a.high * 0x1p64 + (double)a.low;
}

static wide wide_from_dd(dd a)
{
    return wide_add(wide_from_double(a.hi), wide_from_double(a.lo));
}

static dd dd_from(int64_t a)
{
    double high = (double)a;
    return (dd){high, (double)(a - (int64_t)high)};
}

static bool dd_is(dd a, wide exact)
{
    wide error = wide_subtract(wide_from_dd(a), exact);
    return error.high == 0 && error.low == 0;
}

/* A random integer below 2^bits in size, of random length. */
static int64_t random_integer(rng *r, int bits)
{
    int64_t a = (int64_t)(rng_next(r) >> (64 - rng_int(r, 1, bits)));
    return rng_next(r) % 2 ? a : -a;
}

static bool is_normal(dd a)
{
    return a.hi + a.lo == a.hi; /* lo is no more than half of hi's last place */
}

/* ---- sums and products ----------------------------------------------------------------------------------------- */

static void two_sums_are_exact(void **state)
{
    rng r = {51};
    (void)state;
    for (int i = 0; i < 20000; i++) {
        int64_t a = random_integer(&r, 53), b = random_integer(&r, 53);
        int up = rng_int(&r, 0, 60);
        wide A = wide_shift_left(wide_from(a), up), B = wide_from(b);
        dd sum = dd_two_sum(ldexp((double)a, up), (double)b), less = dd_two_diff((double)b, ldexp((double)a, up));
        assert_true(dd_is(sum, wide_add(A, B)) && is_normal(sum));
        assert_true(dd_is(less, wide_subtract(B, A)) && is_normal(less));
    }
}

static void sums_and_products_of_integers(void **state)
{
    rng r = {52};
    (void)state;
    for (int i = 0; i < 20000; i++) {
        int64_t a = random_integer(&r, 62), b = random_integer(&r, 62);
        dd A = dd_from(a), B = dd_from(b);
        assert_true(dd_is(dd_add(A, B), wide_add(wide_from(a), wide_from(b))));
        assert_true(dd_is(dd_sub(A, B), wide_subtract(wide_from(a), wide_from(b))));
        assert_true(dd_is(dd_neg(A), wide_negate(wide_from(a))));
        wide exact = wide_product(a, b);
        dd product = dd_mul(A, B);
        assert_true(is_normal(product));
        assert_true(wide_size(wide_subtract(wide_from_dd(product), exact)) <= PRODUCT_BOUND * wide_size(exact));
    }
}

/* Sums of long numbers. In most of them the leading bits or parts cancel. The error is small compared with the sum, not
 * only with its terms. */
static void sums_of_long_numbers(void **state)
{
    rng r = {53};
    (void)state;
    for (int i = 0; i < 20000; i++) {
        dd A = dd_mul(dd_from(random_integer(&r, 53)), dd_from(random_integer(&r, 53)));
        dd B = dd_mul(dd_from(random_integer(&r, 53)), dd_from(random_integer(&r, 53)));
        if (i % 3 == 1)
            B = dd_add(dd_neg(A), dd_from(random_integer(&r, 20)));
        if (i % 3 == 2) {
            A = (dd){ldexp((double)random_integer(&r, 53), 60), ldexp((double)random_integer(&r, 53), 5)};
            B = (dd){-A.hi, (double)random_integer(&r, 53)};
        }
        wide exact = wide_add(wide_from_dd(A), wide_from_dd(B));
        dd sum = dd_add(A, B);
        assert_true(is_normal(sum));
        assert_true(wide_size(wide_subtract(wide_from_dd(sum), exact)) <= SUM_BOUND * wide_size(exact));
    }
}

/* ---- determinants ---------------------------------------------------------------------------------------------- */

static roberts_vec3 random_vector(rng *r, int bits, int64_t v[3])
{
    for (int k = 0; k < 3; k++)
        v[k] = random_integer(r, bits);
    return (roberts_vec3){(double)v[0], (double)v[1], (double)v[2]};
}

static wide wide_times(wide a, int64_t b)
{
    bool negative = is_negative(a) != (b < 0);
    wide p;
    uint64_t size = b < 0 ? 0 - (uint64_t)b : (uint64_t)b;
    if (is_negative(a))
        a = wide_negate(a);
    p.high = bits_multiply_plain(a.low, size, &p.low) + a.high * size;
    return negative ? wide_negate(p) : p;
}

static wide determinant(const int64_t a[3], const int64_t b[3], const int64_t c[3])
{
    wide sum = {0, 0};
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        wide minor = wide_subtract(wide_product(a[i], b[j]), wide_product(a[j], b[i]));
        sum = wide_add(sum, wide_times(minor, c[k]));
    }
    return sum;
}

/* With coordinates of up to 31 bits, each determinant is an integer below 2^96. A double-double holds it, so the result
 * must be exact, and zero if the vectors lie in a plane. */
static void determinants_are_exact(void **state)
{
    rng r = {54};
    (void)state;
    for (int i = 0; i < 20000; i++) {
        int64_t a[3], b[3], c[3];
        roberts_vec3 A = random_vector(&r, 30, a), B = random_vector(&r, 30, b), C = random_vector(&r, 30, c);
        if (i % 2) { /* in their plane, or just beside it */
            for (int k = 0; k < 3; k++)
                c[k] = a[k] - b[k];
            c[0] += i % 4 == 1;
            C = (roberts_vec3){(double)c[0], (double)c[1], (double)c[2]};
        }
        dd det = dd3_dot(dd3_cross(dd3_from(A), dd3_from(B)), dd3_from(C));
        assert_true(dd_is(det, determinant(a, b, c)));
        dd3 zero = {{0, 0}, {0, 0}, {0, 0}};
        det = dd3_dot(dd3_cross(dd3_between(A, C), dd3_add(dd3_from(B), zero)), dd3_between(B, C));
        for (int k = 0; k < 3; k++)
            a[k] -= c[k];
        int64_t bc[3] = {b[0] - c[0], b[1] - c[1], b[2] - c[2]};
        assert_true(dd_is(det, determinant(a, b, bc)));
    }
}

/* ---- zeros ----------------------------------------------------------------------------------------------------- */

/* t = a / (a - b) is m 2^-e with 53 bits of m: |m (a - b) - a 2^e| <= (a - b) means that it is off by at most one unit
 * of its last place. */
static void zeros_to_the_last_place(void **state)
{
    rng r = {55};
    (void)state;
    for (int i = 0; i < 20000; i++) {
        int64_t a = 1 + llabs(random_integer(&r, 61)), b = -llabs(random_integer(&r, 61));
        double t = dd_zero_of(dd_from(a), dd_from(b)), same = dd_zero_of(dd_from(-a), dd_from(-b));
        int exponent;
        double m = ldexp(frexp(t, &exponent), 53);
        assert_true(same == t && t >= 0 && t <= 1);
        wide left = wide_product((int64_t)m, a - b), right = wide_shift_left(wide_from(a), 53 - exponent);
        if (b == 0)
            assert_true(t == 1);
        if (exponent > -10) /* so that nothing overflows */
            assert_true(wide_size(wide_subtract(left, right)) <= (double)(a - b));
    }
    assert_true(dd_zero_of((dd){0, 0}, (dd){-3, 0}) == 0);
    assert_true(dd_zero_of((dd){1, 0}, (dd){-2, 0}) == 1.0 / 3);
    assert_true(dd_zero_of((dd){1, 0x1p-60}, (dd){-1, 0}) == 0.5); /* nearest double */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_sums_are_exact),      cmocka_unit_test(sums_and_products_of_integers),
        cmocka_unit_test(sums_of_long_numbers),    cmocka_unit_test(determinants_are_exact),
        cmocka_unit_test(zeros_to_the_last_place),
    };
    return cmocka_run_group_tests_name("double-double", tests, NULL, NULL);
}
