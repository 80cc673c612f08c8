/* test_number.c - decimal text to doubles, bit for bit against strtod(). */
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/number.h"
#include "testing.h"

enum { ROOM = 2 * NUMBER_LENGTH_MAX };

static uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static double double_of(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static uint64_t next_random(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

/* How many random numbers a test tries: some, or as many as TEST_NUMBERS requests. */
static unsigned long random_count(void)
{
    const char *count = getenv("TEST_NUMBERS");
    return count ? strtoul(count, NULL, 10) : 400000;
}

/* Fails unless the text is read whole, and as strtod() reads it. The text must end in zeros. */
static void check(const char *text)
{
    char *end;
    double value = 0.0, expected = strtod(text, &end);
    const char *after = number_parse(text, &value);
    if (after != end || bits_of(value) != bits_of(expected))
        fail_msg("\"%.60s\": read %td characters as %.17g (%a), strtod() %td as %.17g (%a)", text,
                 after ? after - text : 0, value, value, end - text, expected, expected);
}

/* Numbers, and what may follow them without belonging to them. */
static const struct {
    const char *number, *rest;
} good[] = {
    {"0", ""},
    {"-0", ""},
    {"-0.0", ""},
    {"+1", ""},
    {"1.", ""},
    {".5", ""},
    {"-.5e1", ""},
    {"1", "e"},
    {"1", "e+"},
    {"1", "e-"},
    {"1", "ex"},
    {"1.e2", ""},
    {"1E2", ""},
    {"007", ""},
    {"1", " 2"},
    {"1.2", ".3"},
    {"3", "#c"},
    {"1", ",5"},
    {"1", "-2"},
    {"00000000000000000000000000000000000000001.5", ""},
    {"0.00000000000000000000000000000000000000012345678901234567", ""},
    {"0000000000000000000000000000000000000000000000000000000000", ""},
    {"0.00000000", ""}, /* as "%.8f" writes 0 and other numbers that doubles are */
    {"-0.00000000", ""},
    {"-1.0000000000", ""},
    {"12345678901.12345678", ""}, /* 11 digits before the point, 19 in all; then 12, and 20 */
    {"123456789012.1234567", ""},
    {"12345678901.123456789", ""},
    {"0.123456789012345678", ""},
    {"0.1234567890123456789", ""},
    {"90071992547.40993", ""}, /* 2^53 + 1 without its point: no exact quotient */
    {"0e999999999999999999999", ""},
    {"1e999999999999999999999", ""},
    {"1e-999999999999999999999", ""},
    {"1e310", ""},
    {"-1e310", ""},
    {"1.7976931348623157e308", ""},
    {"1.7976931348623158e308", ""},
    {"1.7976931348623159e308", ""},
    {"17976931348623158079372897140530341507993413271003782693617377898044496829276475094664901797758720709633028641669"
     "28879109465555478519404026306574886715058206819089020007083836762738548458177115317644757302700698555713669596228"
     "42914819860834936475292719074168444365510704342711559699508093042880e0",
     ""},
    {"2.2250738585072014e-308", ""}, /* the least normal */
    {"2.2250738585072011e-308", ""}, /* a much-quoted subnormal */
    {"2.2250738585072012e-308", ""},
    {"4.9406564584124654e-324", ""},
    {"2.4703282292062327e-324", ""}, /* just below half the least subnormal */
    {"2.4703282292062328e-324", ""},
    {"1e-400", ""},
    {"9007199254740991", ""},
    {"9007199254740992", ""},
    {"9007199254740993", ""}, /* ties: 2^53 + 1 and its like */
    {"9007199254740995", ""},
    {"9007199254740993.0", ""},
    {"9007199254740993.00000000000000000000000000000001", ""},
    {"9007199254740992.99999999999999999999999999999999", ""},
    {"900719925474099300000000000000000000000000e-26", ""},
    {"18014398509481985", ""},
    {"18014398509481987", ""},
    {"9223372036854775807", ""},
    {"9223372036854775808", ""},
    {"18446744073709551615", ""},
    {"18446744073709551616", ""},
    {"9999999999999999999", ""},
    {"99999999999999999999", ""},
    {"0.50000000000000000", ""},
    {"0.1000000000000000055511151231257827021181583404541015625", ""},   /* 0.1 in full */
    {"0.100000000000000012490009027033011079765856266021728515625", ""}, /* the middle between 0.1 and the next */
    {"0.100000000000000012490009027033011079765856266021728515624", ""},
    {"0.100000000000000012490009027033011079765856266021728515626", ""},
    {"1.00000000000000011102230246251565404236316680908203125", ""}, /* the middle between 1 and the next */
    {"1.00000000000000011102230246251565404236316680908203124", ""},
    {"1.00000000000000011102230246251565404236316680908203126", ""},
    {"1.00000000000000033306690738754696212708950042724609375", ""},
    {"8.5e22", ""},
    {"1e22", ""},
    {"1e23", ""},
    {"7.3879e20", ""},
    {"5e-324", ""},
    {"1e-27", ""},
    {"123456789012345678e-27", ""},
    {"6.9294956446009195e15", ""},
    {"3.518437208883201171875e13", ""}, /* ties with few digits */
    {"62.5364939768271845828", ""},
    {"8.10109172351e-10", ""},
    {"1.50000000000000011102230246251565", ""},
    {"9007199254740991.4999999999999999999999999999999995", ""},
    {"30078505129381147446200", ""},
    {"1777820000000000000001", ""},
    {"0", "x10"}, /* no hexadecimal */
};

static void reads_the_table(void **state)
{
    static char text[ROOM];
    (void)state;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        size_t length = strlen(good[i].number);
        double value = -1.0;
        memset(text, 0, sizeof text);
        snprintf(text, sizeof text, "%s%s", good[i].number, good[i].rest);
        const char *end = number_parse(text, &value);
        if (!end || (size_t)(end - text) != length)
            fail_msg("\"%s\": %td characters read, not %zu", text, end ? end - text : 0, length);
        memset(text + length, 0, sizeof text - length);
        check(text);
    }
}

static void refuses_what_is_no_number(void **state)
{
    static const char *const bad[] = {"",    ".",    "-",        "+", "-.",  "e5", ".e5", "nan",
                                      "inf", "-inf", "infinity", "#", "abc", " 1", "--1", "+-1",
                                      "\n1", ",5",   "\xc2\xbd", "}", "/",   ":"};
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char text[32] = {0};
        double value;
        snprintf(text, sizeof text, "%s", bad[i]);
        if (number_parse(text, &value))
            fail_msg("\"%s\" is no number", text);
    }
}

/* Up to NUMBER_LENGTH_MAX characters; digits that only the last ones decide. */
static void reads_long_numbers(void **state)
{
    static char text[ROOM];
    double value;
    (void)state;
    for (int length = 1; length <= NUMBER_LENGTH_MAX; length += length < 1200 ? 1 : 97) {
        static const char *const head[] = {
            "9007199254740993", "1.00000000000000011102230246251565404236316680908203125", "0.", ".0000", "1"};
        for (size_t h = 0; h < sizeof head / sizeof *head; h++) {
            size_t first = strlen(head[h]);
            if (first >= (size_t)length)
                continue;
            memset(text, 0, sizeof text);
            snprintf(text, sizeof text, "%s", head[h]);
            memset(text + first, '0', (size_t)length - first);
            check(text);
            text[length - 1] = '1';
            check(text);
            memset(text + first, '9', (size_t)length - first);
            check(text);
        }
    }
    memset(text, 0, sizeof text);
    memset(text, '7', NUMBER_LENGTH_MAX);
    assert_non_null(number_parse(text, &value));
    text[NUMBER_LENGTH_MAX] = '7';
    assert_null(number_parse(text, &value));
}

/* The middle between two doubles, written out in full, is a tie; one digit more or less is none. */
static void rounds_middles_to_even(void **state)
{
    static char text[ROOM];
    uint64_t seed = 7;
    (void)state;
    for (int i = 0; i < 4000; i++) {
        uint64_t bits = next_random(&seed) & INT64_MAX;
        if (i % 4 == 0)
            bits = (bits & ((UINT64_C(1) << 52) - 1)) | (uint64_t)(1023 + (int)(bits >> 55) - 128) << 52;
        if (bits >> 52 >= 2046)
            continue;
        long double middle = ((long double)double_of(bits) + double_of(bits + 1)) / 2; /* exact with 64 bits */
        if (LDBL_MANT_DIG < 64)
            SKIP_BECAUSE("long double has fewer than 64 bits");
        memset(text, 0, sizeof text);
        int length = snprintf(text, ROOM / 2, "%.1100Lf", middle);
        while (text[length - 1] == '0')
            text[--length] = '\0';
        check(text);
        text[length - 1]--; /* the last digit is 5 */
        check(text);
        text[length - 1] += 2;
        check(text);
        if ((size_t)snprintf(text, ROOM / 2, "%.*Le", i % 30, middle) < ROOM / 2)
            check(text);
    }
}

static void reads_random_doubles(void **state)
{
    uint64_t seed = 88172645463325252u;
    char text[1200] = {0};
    (void)state;
    for (unsigned long i = 0, count = random_count(); i < count; i++) {
        static const int precision[] = {17, 17, 16, 9, 15, 19, 20, 25};
        double x = double_of(next_random(&seed));
        if (i % 2) /* a coordinate */
            x = (double)(int64_t)next_random(&seed) * 0x1p-58;
        if (!isfinite(x))
            continue;
        memset(text, 0, 64);
        snprintf(text, sizeof text, i % 4 == 3 ? "%.*f" : "%.*g", precision[i % 8], x);
        check(text);
        if (i % 8 == 0 && strtod(text, NULL) != x)
            fail_msg("%s does not lead back", text);
    }
}

/* Any digits, any exponent. */
static void reads_random_digits(void **state)
{
    uint64_t seed = 42;
    char text[64];
    (void)state;
    for (unsigned long i = 0, rounds = random_count(); i < rounds; i++) {
        uint64_t r = next_random(&seed);
        memset(text, 0, sizeof text);
        int count = (int)(r % 22) + 1, exponent = (int)(r >> 8 & 1023) - 512, point = (int)(r >> 24 & 31), n = 0;
        if (r >> 32 & 1)
            exponent = exponent % 30;
        for (int k = 0; k < count; k++) {
            if (k == point)
                text[n++] = '.';
            text[n++] = (char)('0' + next_random(&seed) % 10);
        }
        if (r >> 33 & 1)
            snprintf(text + n, sizeof text - (size_t)n, "e%d", exponent);
        check(text);
    }
}

/* All decimals of up to four digits, with every exponent from -25 to 25. */
static void reads_short_decimals(void **state)
{
    char text[32];
    (void)state;
    for (int w = 0; w < 10000; w++) {
        for (int q = -25 + w % 5; q <= 25; q += w < 1000 ? 1 : 5) {
            memset(text, 0, sizeof text);
            snprintf(text, sizeof text, "%de%d", w, q);
            check(text);
        }
        for (int point = 0; point <= 4; point++) {
            memset(text, 0, sizeof text);
            snprintf(text, sizeof text, "%04d", w);
            memmove(text + point + 1, text + point, strlen(text + point));
            text[point] = '.';
            check(text);
        }
    }
}

/* Tests every power in the table, from 1e-326 to 1e308, with digits that show its last bits. */
static void reads_every_power(void **state)
{
    static const char *const digits[] = {"1",
                                         "3",
                                         "9007199254740993",
                                         "18446744073709551615",
                                         "9999999999999999999",
                                         "1234567890123456789",
                                         "4611686018427387905"};
    char text[64];
    (void)state;
    for (int q = POWER_MIN - 30; q <= POWER_MAX + 10; q++) {
        for (size_t i = 0; i < sizeof digits / sizeof *digits; i++) {
            memset(text, 0, sizeof text);
            snprintf(text, sizeof text, "%se%d", digits[i], q);
            check(text);
        }
    }
}

/* One power of ten more is the same as ten times as much: 10^(q+1) cut off to 128 bits lies within ten units of ten
 * times 10^q cut off. So no entry can be wrong alone; 10^0 is checked by hand. */
static void powers_belong_together(void **state)
{
    (void)state;
    assert_true(power_table[-POWER_MIN].high == UINT64_C(1) << 63 && power_table[-POWER_MIN].low == 0);
    for (int fraction = 0; fraction <= NUMBER_MOST_FRACTION; fraction++)
        assert_true(number_scales[fraction].high == power_table[-fraction - POWER_MIN].high);
    for (int q = 0; q < POWER_MAX - POWER_MIN; q++) {
        power_ten a = power_table[q], b = power_table[q + 1];
        uint64_t low, carry = bits_multiply(a.low, 10, &low), high, top = bits_multiply(a.high, 10, &high);
        high += carry;
        top += high < carry;
        int shift = top >> 3 ? 4 : 3; /* 10 a has 131 or 132 bits */
        uint64_t h = top << (64 - shift) | high >> shift, l = high << (64 - shift) | low >> shift;
        if (q + 1 == -POWER_MIN)
            continue; /* 10 * 10^-1 cut off is just below 1, with other leading bits */
        if (b.high != h + (b.low < l) || b.low - l > 10)
            fail_msg("10^%d: %016llx where %016llx or a little more belongs", q + 1 + POWER_MIN,
                     (unsigned long long)b.low, (unsigned long long)l);
    }
}

/* The locale is the program's: it must not matter. */
static void knows_no_locale(void **state)
{
    static const char *const comma[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8", "de_DE", "fr_FR"};
    const char *found = NULL;
    double value;
    (void)state;
    for (size_t i = 0; i < sizeof comma / sizeof *comma && !found; i++)
        found = setlocale(LC_NUMERIC, comma[i]);
    if (!found) {
        SKIP_BECAUSE("no locale with a decimal comma");
    }
    bool really = strtod("1,5", NULL) == 1.5; /* what makes this test one */
    static const char short_text[32] = "1.5", long_text[64] = "9007199254740993.00000000000000000000000000000001";
    bool good_short = number_parse(short_text, &value) && value == 1.5;
    bool good_long = number_parse(long_text, &value) && value == 9007199254740994.0;
    setlocale(LC_NUMERIC, "C");
    assert_true(really && good_short && good_long);
}

static void reads_integers(void **state)
{
    static const struct {
        const char *text;
        uint64_t value;
        int length;
    } rows[] = {{"0", 0, 1},
                {"7 ", 7, 1},
                {"1234567", 1234567, 7},
                {"12345678", 12345678, 8},
                {"9999999x", 9999999, 7},
                {"4294967295", UINT32_MAX, 10},
                {"18446744073709551615", UINT64_MAX, 20},
                {"18446744073709551616", UINT64_MAX, 20},
                {"99999999999999999999999", UINT64_MAX, 23},
                {"", 0, 0},
                {"-1", 0, 0},
                {"x", 0, 0}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[40] = {0};
        uint64_t value;
        uint32_t small = 0;
        snprintf(text, sizeof text, "%s", rows[i].text);
        const char *end = number_integer(text, &value);
        assert_true((end ? end - text : 0) == rows[i].length);
        assert_true(!end || value == rows[i].value);
        assert_int_equal(number_short_integer(text, &small), rows[i].length < 8 ? rows[i].length : 0);
        if (rows[i].length && rows[i].length < 8)
            assert_int_equal(small, rows[i].value);
    }
    for (uint32_t n = 0; n < 10000000; n += n < 100000 ? 1 : 9973) {
        char text[24] = {0};
        uint32_t small = 0;
        int length = snprintf(text, sizeof text, "%lu", (unsigned long)n);
        assert_true(number_short_integer(text, &small) == length && small == n);
    }
}

/* Each bit is in its place, whatever the others are. */
static void bits_are_spread(void **state)
{
    (void)state;
    for (uint32_t x = 0; x < 0x10000; x++) {
        uint32_t expected = 0;
        for (int i = 0; i < 16; i++)
            expected |= (x >> i & 1) << 2 * i;
        assert_int_equal(bits_spread(x), expected);
    }
}

/* Plain C and one instruction agree. */
static void bits_agree(void **state)
{
    uint64_t seed = 3;
    (void)state;
    for (int i = 0; i < 100000; i++) {
        uint64_t a = next_random(&seed) >> (i % 64), b = next_random(&seed) << (i % 7), low, plain;
        assert_int_equal(bits_multiply(a, b, &low), bits_multiply_plain(a, b, &plain));
        assert_int_equal(low, plain);
        if (a)
            assert_int_equal(bits_leading_zeros(a), bits_leading_zeros_plain(a));
    }
    for (int i = 0; i < 64; i++) {
        assert_int_equal(bits_trailing_zeros(UINT64_MAX << i), i);
        assert_int_equal(bits_leading_zeros_plain(UINT64_MAX >> i), i);
    }
    assert_true(bits_load("abcdefgh") == UINT64_C(0x6867666564636261));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_the_table),        cmocka_unit_test(refuses_what_is_no_number),
        cmocka_unit_test(reads_long_numbers),     cmocka_unit_test(rounds_middles_to_even),
        cmocka_unit_test(reads_random_doubles),   cmocka_unit_test(reads_random_digits),
        cmocka_unit_test(reads_short_decimals),   cmocka_unit_test(reads_every_power),
        cmocka_unit_test(powers_belong_together), cmocka_unit_test(knows_no_locale),
        cmocka_unit_test(reads_integers),         cmocka_unit_test(bits_agree),
        cmocka_unit_test(bits_are_spread),
    };
    return cmocka_run_group_tests_name("number", tests, NULL, NULL);
}
