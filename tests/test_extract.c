/* The paths in Cairo's SVG: their points in mm, however the bytes come; and whatever is not understood is noticed. */
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "draw/extract.h"
#include "drawing.h"

/* Gives `text` to an extract in pieces of `at_a_time` bytes; what comes out is to be freed. */
static char *extracted(const char *text, int decimals, page_point first, size_t at_a_time, bool *strange)
{
    output *out = malloc(sizeof *out);
    sink to = {0};
    assert_non_null(out);
    output_start(out, sink_write, &to);
    extract e = {.out = out, .decimals = decimals};
    extract_surface(&e, first);
    for (size_t at = 0, size = strlen(text); at < size; at += at_a_time) {
        size_t count = size - at < at_a_time ? size - at : at_a_time;
        extract_bytes(&e, (const unsigned char *)text + at, count);
    }
    output_text(out, ".");
    assert_int_equal(output_finish(out, NULL), ROBERTS_OK);
    free(out);
    *strange = e.strange;
    return to.bytes;
}

static const struct {
    const char *name, *svg;
    int decimals;
    page_point first;
    const char *wanted;
} cases[] = {
    {"no path", "<?xml version=\"1.0\"?>\n<svg d=\"M 3 3\">\n</svg>\n", 3, {0, 0}, "."},
    {"one", "<path d=\"M 2.001 2.5 L 2.124302 2.070766 \"/>", 3, {1000, 500000}, "M 1 500 L 124.302 70.766 ."},
    {"among other attributes",
     "<g><path style=\"a:d; d=\" fill='none' d=\"M 2 2 L 3 2.00001 \" id=\"d\"/></g>",
     3,
     {0, 0},
     "M 0 0 L 1000 0.01 ."},
    {"two",
     "<path d=\"M 2.000001 2 L 3 3 \"/>\n<path d=\"M 2 4 L 3 5.9 \"/>",
     3,
     {1, 0},
     "M 0.001 0 L 1000 1000 \nM 0 2000 L 1000 3900 ."},
    {"hundredths", "<path d=\"M 2.000001 2.00001 L 5.999999 2.0001 \"/>", 2, {1, 10}, "M 0.01 0.1 L 39999.99 1 ."},
    {"before the border", "<path d=\"M 1.999999 1.99 L -0.5 0.5 \"/>", 3, {-1, -10000}, "M -0.001 -10 L -2500 -1500 ."},
    {"closed: the way back to the start is left out",
     "<path d=\"M 2 2 L 3 2 L 3 3 Z M 2 2 \"/>",
     3,
     {0, 0},
     "M 0 0 L 1000 0 L 1000 1000 Z ."},
    {"but not where a line follows",
     "<path d=\"M 2 2 L 3 2 L 3 3 Z M 2 2 L 2 4 \"/>",
     3,
     {0, 0},
     "M 0 0 L 1000 0 L 1000 1000 Z M 0 0 L 0 2000 ."},
    {"without a blank at the end", "<path d=\"M 2 2 L 3 3.5\"/>", 3, {0, 0}, "M 0 0 L 1000 1500 "},
};

static void paths(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        for (size_t at_a_time = 1; at_a_time < 100; at_a_time += at_a_time < 20 ? 1 : 79) {
            bool strange;
            char *text = extracted(cases[i].svg, cases[i].decimals, cases[i].first, at_a_time, &strange);
            if (strange || strncmp(text, cases[i].wanted, strlen(cases[i].wanted)) != 0)
                fail_msg("%s, %zu bytes at a time: %s", cases[i].name, at_a_time, text);
            free(text);
        }
}

static const struct {
    const char *name, *data;
} strange_cases[] = {
    {"a curve", "M 2 2 C 2 3 3 3 3 2 "},
    {"a rectangle's side", "M 2 2 H 3 "},
    {"a power of ten", "M 2 2 L 3e-5 2 "},
    {"a comma", "M 2 2 L 3,5 2 "},
    {"two points", "M 2 2 L 3.1.4 2 "},
    {"a coordinate without a fellow", "M 2 2 L 3 "},
    {"a third one", "M 2 2 L 3 3 3 "},
    {"no command", "2 2 L 3 3 "},
    {"another command between coordinates", "M 2 2 L 3 M 3 "},
    {"a minus alone", "M 2 2 L - 3 "},
    {"more digits than can be", "M 2 2 L 2.0000001 3 "},
    {"a number beyond all pages", "M 2 2 L 1234.5 3 "},
    {"one that no integer holds", "M 2 2 L 99999999999999999999 3 "},
    {"another start than was drawn: rounded to fewer digits", "M 2.0001 2 L 3 3 "},
    {"another start, other axis", "M 2 2.000001 L 3 3 "},
};

static void what_is_not_understood(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof strange_cases / sizeof strange_cases[0]; i++) {
        char svg[200];
        bool strange;
        snprintf(svg, sizeof svg, "<path d=\"%s\"/>", strange_cases[i].data);
        free(extracted(svg, 3, (page_point){0, 0}, 1000, &strange));
        if (!strange)
            fail_msg("%s: taken for good", strange_cases[i].name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(paths),
        cmocka_unit_test(what_is_not_understood),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
