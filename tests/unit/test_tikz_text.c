/* Text for LaTeX: what is written, which characters are missing, and that LaTeX sets all others. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "write/formats.h"
#include "missing.h"
#include "temporary.h"
#include "testing.h"

static char top[2048];

static char written[200];
static size_t used;

static bool take(void *context, const void *bytes, size_t size)
{
    (void)context;
    if (used + size >= sizeof written)
        return false;
    memcpy(written + used, bytes, size);
    used += size;
    written[used] = '\0';
    return true;
}

/* Characters that TeX reads as commands are written as names; no character that TeX refuses is left. */
static void characters(void **state)
{
    (void)state;
    static const struct {
        const char *text, *tex;
    } cases[] = {{"A 1-2, b.", "A 1-2, b."},
                 {"50 % #1 $x_1 & {y}", "50 \\% \\#1 \\$x\\_1 \\& \\{y\\}"},
                 {"\\input^~", "\\textbackslash{}input\\textasciicircum{}\\textasciitilde{}"},
                 {"<|>\"", "\\textless{}\\textbar{}\\textgreater{}''"},
                 {"é", "é"},
                 {"βΩ", "\\ensuremath{\\beta}\\ensuremath{\\Omega}"},
                 {"\u2206", "\\ensuremath{\\Delta}"},
                 {"A₁²", "A\\textsubscript{1}\\textsuperscript{2}"},
                 {"90°", "90\\ensuremath{{}^\\circ}"},
                 {"√2½", "\\ensuremath{\\surd}2\\ensuremath{\\frac12}"},
                 {"A′ ≤∞", "A\\ensuremath{{}^\\prime} \\ensuremath{\\leq}\\ensuremath{\\infty}"},
                 {"1−½", "1\\ensuremath{-}\\ensuremath{\\frac12}"},
                 {"– — … ‘ ’ “ ”", "– — … ‘ ’ “ ”"},
                 {"(11\u03050)e\u0301", "(1\\={1}0)\\'{e}"},
                 {"e\u0302\u0301a\u0328\u0300.", "\\'{\\^{e}}\\`{\\k{a}}."},
                 {"a\nb\x7f\xff.", "a?b??."},
                 {"$v_1$", "$v_1$"},
                 {"a_1 $\\beta^{2}$ & $c$", "a\\_1 $\\beta^{2}$ \\& $c$"},
                 {"$\\{x\\$\\}$.", "$\\{x\\$\\}$."},
                 {"5$", "5\\$"},
                 {"$$", "\\$\\$"},
                 {"$}{$", "\\$\\}\\{\\$"},
                 {"${$", "\\$\\{\\$"},
                 {"$a\nb$", "\\$a?b\\$"},
                 {"", ""}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        output out;
        used = 0;
        written[0] = '\0';
        output_start(&out, take, NULL);
        tikz_text_write(&out, cases[i].text);
        assert_int_equal(output_finish(&out, NULL), ROBERTS_OK);
        assert_string_equal(written, cases[i].tex);
    }
}

static void characters_that_latex_lacks(void **state)
{
    static const missing_case cases[] = {
        {"A 1-2, $%", 0, MISSING_NOTHING},
        {"Größe Łódź ů β₁ (11\u03050)", 0, MISSING_NOTHING},
        {"′ ″ ‴ ≤ ≥ ≠ ≈ ≡ ∞ ± ∓ · ÷ × ° ∠ ⊥ ∥ △ ∈ ∉ ⊂ ∪ ∩ ∅ → ← ↔ ⇒ ⇔", 0, MISSING_NOTHING},
        {"∑ ∏ ∫ ∂ ∇ ∀ ∃ √ ½ − – — … ‘ ’ “ ” €", 0, MISSING_NOTHING},
        {"\u4e00b\u4e8c", 2, 0x4e00},
        {"a\u2a3f", 1, 0x2a3f},
        {"\u0438", 1, 0x438},
        {"\u0301e", 1, 0x301}, /* no letter before the accent */
        {"b\xff", 1, 0},
        {"$\u4e00$", 0, MISSING_NOTHING}, /* what a formula means is up to the document */
        {"\t", 1, 9},
        {"", 0, MISSING_NOTHING}};
    (void)state;
    expect_missing(tikz_text_missing, cases, sizeof cases / sizeof cases[0]);
}

static void characters_that_need_t1(void **state)
{
    static const missing_case cases[] = {{"A é Größe Łódź ů ’ “ ”", 0, MISSING_NOTHING},
                                         {"ą", 1, 0x105},
                                         {"đŊþÐ", 4, 0x111},
                                         {"a\u0328.", 1, 0x328},
                                         {"„a“", 1, 0x201e},
                                         {"$đ$", 0, MISSING_NOTHING}};
    (void)state;
    expect_missing(tikz_text_only_in_t1, cases, sizeof cases / sizeof cases[0]);
}

static bool put(void *file, const void *bytes, size_t size)
{
    return fwrite(bytes, 1, size, file) == size;
}

/* LaTeX sets a document of all characters of three bytes or fewer that are not missing, in the encoding T1 or OT1. */
static void set_all(bool t1)
{
    FILE *file = fopen("a.tex", "w");
    assert_non_null(file);
    fputs("\\documentclass{article}\n", file);
    fputs(t1 ? "\\usepackage[T1]{fontenc}\n\\begin{document}\n" : "\\begin{document}\n", file);
    size_t count = 0;
    for (unsigned code = 1; code < 0x10000; code++) {
        const char last = (char)(0x80 | (code & 0x3f)), middle = (char)(0x80 | (code >> 6 & 0x3f));
        const char one[] = {(char)code, '\0'}, two[] = {(char)(0xc0 | code >> 6), last, '\0'};
        const char three[] = {(char)(0xe0 | code >> 12), middle, last, '\0'};
        const char *character = code < 0x80 ? one : code < 0x800 ? two : three;
        output out;
        if (tikz_text_missing(character, NULL) > 0 || (!t1 && tikz_text_only_in_t1(character, NULL) > 0))
            continue;
        output_start(&out, put, file);
        tikz_text_write(&out, character);
        assert_int_equal(output_finish(&out, NULL), ROBERTS_OK);
        fputs(++count % 20 == 0 ? "\n\n" : "\n", file);
    }
    fputs("\\end{document}\n", file);
    assert_int_equal(fclose(file), 0);
    assert_true(count > 400);
    if (system("pdflatex -draftmode -halt-on-error -interaction=nonstopmode a.tex >a.out 2>&1") != 0) {
        assert_int_equal(system("grep -A3 '^!' a.out"), 0);
        fail();
    }
}

static void latex_sets_all_others(void **state)
{
    (void)state;
    if (system("pdflatex --version >/dev/null 2>&1") != 0)
        SKIP_BECAUSE("no pdflatex here");
    assert_int_equal(chdir(temporary), 0);
    set_all(true);
    set_all(false);
    assert_int_equal(chdir(top), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(characters),
        cmocka_unit_test(characters_that_latex_lacks),
        cmocka_unit_test(characters_that_need_t1),
        cmocka_unit_test_setup_teardown(latex_sets_all_others, temporary_make, temporary_remove),
    };
    if (!getcwd(top, sizeof top))
        return 1;
    return cmocka_run_group_tests_name("text for LaTeX", tests, NULL, NULL);
}
