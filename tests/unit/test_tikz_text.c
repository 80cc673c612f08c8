/* Text for LaTeX. */
#include <string.h>

#include "write/formats.h"
#include "testing.h"

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
                 {"(11\u03050)e\u0301", "(1\\={1}0)\\'{e}"},
                 {"e\u0302\u0301a\u0328\u0300.", "\\'{\\^{e}}\\`{\\k{a}}."},
                 {"a\nb\x7f\xff.", "a?b??."},
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

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(characters)};
    return cmocka_run_group_tests_name("text for LaTeX", tests, NULL, NULL);
}
