/* make-powers.c - prints src/base/number_powers.c, the powers of ten to 128 bits, by schoolbook arithmetic on long
 * integers.
 *
 * 10^q = 5^q 2^q, and the power of two goes into the exponent. For q >= 0 the 128 highest bits of 5^q are taken; for
 * q < 0 those of 1 / 5^-q, one bit at a time by long division. Both cut off what follows.
 *
 * Usage: build/tools/make-powers > src/base/number_powers.c */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "base/number.h"

enum { WORDS = 30 }; /* 30 * 32 bits: 5^326 has 757, and one bit more is needed while dividing */

typedef struct big {
    uint32_t word[WORDS]; /* lowest first */
} big;

static void big_times(big *a, uint32_t factor)
{
    uint64_t carry = 0;
    for (int i = 0; i < WORDS; i++) {
        carry += (uint64_t)a->word[i] * factor;
        a->word[i] = (uint32_t)carry;
        carry >>= 32;
    }
}

static bool big_at_least(const big *a, const big *b)
{
    for (int i = WORDS - 1; i >= 0; i--) {
        if (a->word[i] != b->word[i])
            return a->word[i] > b->word[i];
    }
    return true;
}

static void big_minus(big *a, const big *b)
{
    uint64_t borrow = 0;
    for (int i = 0; i < WORDS; i++) {
        uint64_t difference = (uint64_t)a->word[i] - b->word[i] - borrow;
        a->word[i] = (uint32_t)difference;
        borrow = difference >> 63;
    }
}

static int big_bit(const big *a, int bit)
{
    return bit < 0 ? 0 : (int)(a->word[bit / 32] >> (bit % 32) & 1);
}

static int big_highest(const big *a)
{
    int bit = 32 * WORDS - 1;
    while (!big_bit(a, bit))
        bit--;
    return bit;
}

static void push(power_ten *p, int bit)
{
    p->high = p->high << 1 | p->low >> 63;
    p->low = p->low << 1 | (uint64_t)bit;
}

static power_ten power(int q)
{
    power_ten p = {0, 0};
    big five = {{1}}, rest = {{0}};
    for (int i = 0; i < (q < 0 ? -q : q); i++)
        big_times(&five, 5);
    int highest = big_highest(&five);
    rest.word[highest / 32] = UINT32_C(1) << (highest % 32); /* below 5^-q; twice that is not: the first bit is 1 */
    for (int i = 0; i < 128; i++) {
        if (q >= 0) {
            push(&p, big_bit(&five, highest - i));
            continue;
        }
        big_times(&rest, 2);
        bool fits = big_at_least(&rest, &five);
        if (fits)
            big_minus(&rest, &five);
        push(&p, fits);
    }
    return p;
}

int main(void)
{
    puts("/* number_powers.c - powers of ten to 128 bits, as number.h says. Made by tools/make-powers.c; change that. "
         "*/\n"
         "#include \"base/number.h\"\n\n"
         "/* clang-format off */\n"
         "const power_ten power_table[POWER_MAX - POWER_MIN + 1] = {");
    for (int q = POWER_MIN; q <= POWER_MAX; q++) {
        power_ten p = power(q);
        printf("%s{0x%016llx, 0x%016llx},%s", (q - POWER_MIN) % 2 ? " " : "    ", (unsigned long long)p.high,
               (unsigned long long)p.low, (q - POWER_MIN) % 2 || q == POWER_MAX ? "\n" : "");
    }
    puts("};\n/* clang-format on */");
    return 0;
}
