/* test_array.c - arrays that grow into large pages keep what they hold; sizes that overflow are refused; buckets. */
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/sort.h"
#include "testing.h"

/* Grows an array of items of `size` bytes past `most` bytes, item by item or to much more at a time. */
static void grow(size_t size, size_t most, size_t step)
{
    unsigned char *item = NULL;
    size_t count = 0, room = 0;
    while (count * size < most) {
        const size_t before = room;
        assert_true(array_reserve(&item, &room, count + step, size));
        assert_true(room >= count + step && room >= before);
        for (size_t k = 0; k < step; k++, count++)
            memset(item + count * size, (int)(count * 31 + count / 251) & 0xff, size);
    }
    memset(item + count * size, 0, (room - count) * size); /* all of the room is there */
    for (size_t k = 0; k < count; k++)
        for (size_t i = 0; i < size; i++)
            if (item[k * size + i] != ((k * 31 + k / 251) & 0xff))
                fail_msg("items of %zu bytes: item %zu of %zu is lost", size, k, count);
    free(item);
}

static void growing(void **state)
{
    static const size_t sizes[] = {1, 8, 12, 24, 4000, 3000000};
    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        for (size_t step = 1; step < 1000000; step = step * 37 + 1)
            grow(sizes[i], (size_t)10 << 20, sizes[i] * step < (size_t)20 << 20 ? step : 1);
}

static void refused(void **state)
{
    size_t room = 0;
    char *none = NULL;
    (void)state;
    assert_null(alloc_array(SIZE_MAX / 2, 3));
    assert_null(alloc_array((size_t)PTRDIFF_MAX / 2, 2 + 1));
    assert_null(alloc_sparse(SIZE_MAX, 1));
    assert_null(alloc_zeroed(SIZE_MAX / 8, 16));
    assert_false(array_grow(&none, &room, SIZE_MAX, 1));
    assert_false(array_grow(&none, &room, (size_t)PTRDIFF_MAX / 8, 16));
    assert_true(none == NULL && room == 0);
    for (size_t size = 0; size < 2; size++) {
        void *empty[] = {alloc_array(0, size), alloc_sparse(0, size), alloc_zeroed(0, size)};
        for (int k = 0; k < 3; k++) {
            assert_non_null(empty[k]);
            free(empty[k]);
        }
    }
}

/* Keys, all below `keys`. */
static const struct {
    uint32_t keys, count, key[8];
} bucket_cases[] = {
    {0, 0, {0}}, {3, 0, {0}}, {1, 4, {0, 0, 0, 0}}, {5, 6, {4, 0, 4, 2, 0, 4}}, {4, 8, {3, 3, 2, 2, 1, 1, 0, 0}},
};

static void buckets(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof bucket_cases / sizeof bucket_cases[0]; i++) {
        const uint32_t *key = bucket_cases[i].key, keys = bucket_cases[i].keys, count = bucket_cases[i].count;
        uint32_t *start, *order, listed = 0;
        assert_true(sort_buckets(key, count, keys, &start, &order));
        for (uint32_t k = 0; k < keys; k++) {
            assert_int_equal(start[k], listed);
            for (uint32_t n = 0; n < count; n++)
                if (key[n] == k)
                    assert_int_equal(order[listed++], n);
        }
        assert_int_equal(start[keys], count);
        assert_int_equal(listed, count);
        free(start);
        free(order);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(growing), cmocka_unit_test(refused), cmocka_unit_test(buckets)};
    return cmocka_run_group_tests_name("arrays", tests, NULL, NULL);
}
