/* Sorting by radix and by merging against the library's, and keys for floats. */
#include <float.h>

#include "base/sort.h"
#include "scenes.h"

typedef struct keyed {
    uint32_t key, number;
} keyed;

static int compare_keyed(const void *pa, const void *pb)
{
    const keyed *a = pa, *b = pb;
    if (a->key != b->key)
        return a->key < b->key ? -1 : 1;
    return (a->number > b->number) - (a->number < b->number);
}

/* Keys within `mask`: few bits make many ties. Stable means: ties by number. */
static void sorts_as_qsort_does(void **state)
{
    static const uint32_t masks[] = {0xffffffff, 0, 1, 0x7ff, 0x800, 0x003ff800, 0xffc00000, 0x80000001, 0x00ffff00};
    static const uint32_t counts[] = {0, 1, 2, 3, 100, 5000};
    rng r = {41};
    (void)state;
    for (size_t m = 0; m < sizeof masks / sizeof masks[0]; m++)
        for (size_t c = 0; c < sizeof counts / sizeof counts[0]; c++) {
            uint32_t count = counts[c], key[5000], order[5000];
            keyed expected[5000];
            for (uint32_t i = 0; i < count; i++) {
                key[i] = (uint32_t)rng_next(&r) & masks[m];
                expected[i] = (keyed){key[i], i};
            }
            qsort(expected, count, sizeof *expected, compare_keyed);
            assert_true(radix_order(key, count, order));
            for (uint32_t i = 0; i < count; i++)
                assert_int_equal(order[i], expected[i].number);
        }
}

static void sorts_items_of_every_count(void **state)
{
    enum { MOST = 200 };
    rng r = {43};
    (void)state;
    for (uint32_t count = 0; count <= MOST; count++) {
        sort_item item[MOST], room[MOST];
        keyed expected[MOST];
        for (uint32_t i = 0; i < count; i++) {
            expected[i] = (keyed){(uint32_t)rng_next(&r) & (count % 2 ? 7u : 0xffffffff), i};
            item[i] = (sort_item){(uint64_t)expected[i].key << 32 | i, ~i};
        }
        qsort(expected, count, sizeof *expected, compare_keyed);
        sort_keyed(item, count, room);
        for (uint32_t i = 0; i < count; i++) {
            assert_int_equal(item[i].key, (uint64_t)expected[i].key << 32 | expected[i].number);
            assert_int_equal(item[i].value, ~expected[i].number);
        }
    }
}

/* Strictly descending but for the two zeros. */
static void keys_descend(void **state)
{
    static const float value[] = {INFINITY, FLT_MAX, 3e10f,    1.0000001f,  1.0f,   0.99999994f, 1e-30f,
                                  FLT_MIN,  1e-40f,  1.4e-45f, 0.0f,        -0.0f,  -1.4e-45f,   -1e-40f,
                                  -FLT_MIN, -1e-30f, -1.0f,    -1.0000001f, -3e10f, -FLT_MAX,    -INFINITY};
    enum { COUNT = sizeof value / sizeof value[0] };
    (void)state;
    for (size_t i = 0; i < COUNT; i++)
        for (size_t j = 0; j < COUNT; j++) {
            uint32_t a = radix_key_descending(value[i]), b = radix_key_descending(value[j]);
            assert_int_equal(a<b, value[i]> value[j]);
            assert_int_equal(a == b, value[i] == value[j]);
        }
}

static void keys_of_random_floats_descend(void **state)
{
    rng r = {42};
    (void)state;
    for (int i = 0; i < 100000; i++) {
        float x = ldexpf((float)rng_between(&r, -1, 1), rng_int(&r, -140, 127));
        float y = i % 3 ? ldexpf((float)rng_between(&r, -1, 1), rng_int(&r, -140, 127)) : nextafterf(x, 0.0f);
        uint32_t a = radix_key_descending(x), b = radix_key_descending(y);
        assert_true((a < b) == (x > y) && (a == b) == (x == y));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sorts_as_qsort_does),
        cmocka_unit_test(sorts_items_of_every_count),
        cmocka_unit_test(keys_descend),
        cmocka_unit_test(keys_of_random_floats_descend),
    };
    return cmocka_run_group_tests_name("radix", tests, NULL, NULL);
}
