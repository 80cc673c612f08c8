/* Letters: the strokes for any UTF-8, their width and place; which characters the fonts lack. */
#include <math.h>

#include "draw/letters.h"
#include "missing.h"
#include "testing.h"

static const double units = 1000.0; /* in a mm */

static polylines drawn(const char *text, double align, bool reads_up)
{
    polylines out = {0};
    const text_line line = {text, {100.0, 100.0}, 21.0, align, reads_up ? TEXT_UPRIGHT : TEXT_LEVEL};
    assert_true(letters_draw(&line, units, &out));
    return out;
}

static size_t strokes_of(const char *text)
{
    polylines out = drawn(text, 0.0, false);
    const size_t count = out.count;
    polylines_free(&out);
    return count;
}

/* The box of what is drawn, mm. */
static void box_of(const polylines *p, roberts_vec2 *min, roberts_vec2 *max)
{
    *min = (roberts_vec2){INFINITY, INFINITY};
    *max = (roberts_vec2){-INFINITY, -INFINITY};
    for (size_t i = 0; i < p->point_count; i++) {
        *min = (roberts_vec2){fmin(min->x, p->point[i].x / units), fmin(min->y, p->point[i].y / units)};
        *max = (roberts_vec2){fmax(max->x, p->point[i].x / units), fmax(max->y, p->point[i].y / units)};
    }
}

/* H of the font: two uprights, 14 units apart, and the bar; 4 units of space on both sides. A unit is a mm here. */
static void letter_by_hand(void **state)
{
    (void)state;
    static const page_point wanted[3][2] = {
        {{104000, 79000}, {104000, 100000}}, {{118000, 79000}, {118000, 100000}}, {{104000, 89000}, {118000, 89000}}};
    polylines out = drawn("H", 0.0, false);
    assert_true(fabs(letters_width("H", 21.0) - 22.0) < 1e-9);
    assert_int_equal(out.count, 3);
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(out.item[i].count, 2);
        assert_memory_equal(out.point + out.item[i].first, wanted[i], sizeof wanted[i]);
    }
    polylines_free(&out);
}

static void aligned_and_turned(void **state)
{
    (void)state;
    roberts_vec2 min, max;
    polylines out = drawn("H", 0.5, false);
    box_of(&out, &min, &max);
    assert_true(min.x == 93.0 && max.x == 107.0 && min.y == 79.0 && max.y == 100.0);
    polylines_free(&out);
    out = drawn("H", 1.0, true); /* it ends at 100, 100, and reads upward: capitals reach to the left */
    box_of(&out, &min, &max);
    assert_true(min.x == 79.0 && max.x == 100.0 && min.y == 104.0 && max.y == 118.0);
    polylines_free(&out);
}

/* Accents add strokes to the letter, and nothing to its width; i loses its dot. */
static void accents(void **state)
{
    (void)state;
    static const struct {
        const char *text, *plain;
        int more;
    } cases[] = {{"é", "e", 1},  {"É", "E", 1}, {"ü", "u", 2},       {"å", "a", 1},       {"Ç", "C", 1},
                 {"ž", "z", 1},  {"ő", "o", 2}, {"ø", "o", 1},       {"Ł", "L", 1},       {"ı", "i", 0},
                 {"í", "i", 0},  {"ï", "i", 1}, {"e\u0301", "e", 1}, {"1\u0305", "1", 1}, {"ß", "ss", 0},
                 {"Æ", "AE", 0}, {"đ", "d", 1}, {"ș", "s", 1}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        if (strokes_of(cases[i].text) != strokes_of(cases[i].plain) + (size_t)cases[i].more)
            fail_msg("%s: %zu strokes, %s %zu", cases[i].text, strokes_of(cases[i].text), cases[i].plain,
                     strokes_of(cases[i].plain));
        assert_true(letters_width(cases[i].text, 3.5) == letters_width(cases[i].plain, 3.5));
        assert_int_equal(letters_missing(cases[i].text, NULL), 0);
    }
}

/* A mark over a capital or a digit is above it, one over a small letter below that height; a cedilla is below the line.
 */
static void accents_in_place(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double top, bottom;
    } cases[] = {{"E", 79.0, 100.0},       {"É", 73.0, 100.0}, {"e", 86.0, 100.0},
                 {"é", 80.0, 100.0},       {"ç", 86.0, 106.0}, {"2", 79.0, 100.0},
                 {"2\u0305", 75.0, 100.0}, {"′", 79.0, 86.0},  {"≤", 80.0, 98.0}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_vec2 min, max;
        polylines out = drawn(cases[i].text, 0.0, false);
        box_of(&out, &min, &max);
        if (min.y != cases[i].top || max.y != cases[i].bottom)
            fail_msg("%s: %g to %g", cases[i].text, min.y, max.y);
        polylines_free(&out);
    }
}

static void greek_letters(void **state)
{
    (void)state;
    assert_int_equal(letters_greek_number(0x3b1), 1);  /* alpha */
    assert_int_equal(letters_greek_number(0x3c1), 17); /* rho */
    assert_int_equal(letters_greek_number(0x3c3), 18); /* sigma, and the final one */
    assert_int_equal(letters_greek_number(0x3c2), 18);
    assert_int_equal(letters_greek_number(0x3c9), 24); /* omega */
    assert_int_equal(letters_greek_number(0x391), 33);
    assert_int_equal(letters_greek_number(0x3a9), 56);
    assert_int_equal(letters_greek_number(0xb5), letters_greek_number(0x3bc));   /* micro, mu */
    assert_int_equal(letters_greek_number(0x2126), letters_greek_number(0x3a9)); /* ohm, Omega */
    assert_int_equal(letters_greek_number(0x2206), letters_greek_number(0x394)); /* increment, Delta */
    assert_int_equal(letters_missing("\u00b5\u2126\u2206", NULL), 0);
    assert_int_equal(letters_greek_number('a'), 0);
    assert_int_equal(letters_missing("αβγδεζηθικλμνξοπρσςτυφχψωΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩ µ", NULL), 0);
    assert_int_equal(strokes_of("Α"), strokes_of("A"));
    assert_int_equal(strokes_of("Δ"), 3);
}

static void signs_and_digits(void **state)
{
    (void)state;
    assert_int_equal(letters_missing("A₁ B² 90° 2×3 ±0,1 ⌀5 „x“ – … √2 ½ 3 €", NULL), 0);
    assert_int_equal(strokes_of("√"), 1);
    assert_int_equal(strokes_of("½"), 3);
    assert_int_equal(strokes_of("€"), 3);
    assert_int_equal(letters_missing("A′ B″ C‴ ≤ ≥ ≠ ≈ ≡ ∞ ± ∓ · ÷ ∠ ⊥ ∥ △ → ← ↔ ∑ ∏ −", NULL), 0);
    assert_int_equal(strokes_of("″"), 2);
    assert_int_equal(strokes_of("≤∞"), 3);
    assert_int_equal(strokes_of("△"), strokes_of("Δ"));
    assert_true(fabs(letters_width("²", 3.5) - 0.6 * letters_width("2", 3.5)) < 1e-9);
    assert_true(letters_width("₁", 3.5) < letters_width("1", 3.5));
}

/* In LaTeX, a formula is as wide as its signs. */
static void formulas(void **state)
{
    static const struct {
        const char *text, *like;
        size_t bytes;
    } cases[] = {{"$v_1$", "xx", 5},
                 {"$\\alpha_{12}$", "xxx", 13},
                 {"$\\{β\\,\\$\\}$", "xxxxx", 12},
                 {"$ $", "", 3},
                 {"a$b$c", "axc", 0},
                 {"5 $", "5 $", 0},
                 {"$$", "$$", 0},
                 {"${$", "${$", 0},
                 {"$}{$", "$}{$", 0},
                 {"$a\\$", "$a\\$", 0},
                 {"$a\\", "$a\\", 0},
                 {"", "", 0}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_int_equal(letters_formula(cases[i].text), cases[i].bytes);
        assert_true(fabs(letters_tex_width(cases[i].text, 3.5) - letters_width(cases[i].like, 3.5)) < 1e-9);
    }
}

/* Anything that is not UTF-8, or not in the fonts, becomes a box, and is never read beyond its end. */
static void faults_of_text(void **state)
{
    (void)state;
    static const missing_case cases[] = {
        {"plain", 0, MISSING_NOTHING},
        {"a\xff"
         "b",
         1, 0},
        {"\xc3", 1, 0},
        {"\xe2\x82", 2, 0},
        {"\xc0\xaf", 2, 0},
        {"\xed\xa0\x80", 3, 0},
        {"漢字", 2, 0x6f22},
        {"😀", 1, 0x1f600},
        {"\x01", 1, 0},
        {"x\xf8\x88", 2, 0},
        {"\t", 1, 9},
        {"e\xcc", 1, 0},
    };
    expect_missing(letters_missing, cases, sizeof cases / sizeof cases[0]);
    assert_int_equal(strokes_of("\xff\xff"), 2); /* boxes */
    assert_int_equal(strokes_of(""), 0);
}

/* Every byte and every pair of bytes: no crash, a width, whole strokes. */
static void all_pairs(void **state)
{
    (void)state;
    for (int a = 1; a < 256; a++)
        for (int b = 1; b < 256; b++) {
            const char text[] = {(char)a, (char)b, '\0'};
            polylines out = drawn(text, 0.0, false);
            assert_true(letters_width(text, 1.0) > 0.0);
            for (size_t i = 0; i < out.count; i++)
                assert_true(out.item[i].count >= 2);
            polylines_free(&out);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(letter_by_hand),   cmocka_unit_test(aligned_and_turned), cmocka_unit_test(accents),
        cmocka_unit_test(accents_in_place), cmocka_unit_test(greek_letters),      cmocka_unit_test(signs_and_digits),
        cmocka_unit_test(formulas),         cmocka_unit_test(faults_of_text),     cmocka_unit_test(all_pairs)};
    return cmocka_run_group_tests_name("letters", tests, NULL, NULL);
}
