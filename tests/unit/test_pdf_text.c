/* Text of PDF that readers can search: the characters of the fonts, the content of the page, and the result of
 * pdftotext. */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <zlib.h>

#include "write/formats.h"
#include "drawing.h"
#include "missing.h"
#include "temporary.h"
#include "testing.h"

enum { PAGE_ROOM = 20000 };

static char top[2048];

static void characters_that_the_fonts_lack(void **state)
{
    static const missing_case cases[] = {{"A 1-2, b.", 0, MISSING_NOTHING},
                                         {"Größe", 0, MISSING_NOTHING},
                                         {"βΩ", 0, MISSING_NOTHING},
                                         {"10 € – “x”", 0, MISSING_NOTHING},
                                         {"√2 ½", 0, MISSING_NOTHING},
                                         {"A₁²", 1, 0x2081},
                                         {"ů ň", 2, 0x16f},
                                         {"1‐2 3", 0, MISSING_NOTHING},
                                         {"\u4e00b\u4e8c", 2, 0x4e00},
                                         {"b\xff", 1, 0},
                                         {"′ ″ ≤ ≥ ≠ ≈ ≡ ∞ ± · ÷ × ° ∠ ⊥ ∈ ∉ ⊂ ∪ ∩ ∅ → ← ↔ ⇒ ⇔", 0, MISSING_NOTHING},
                                         {"∑ ∏ ∫ ∂ ∇ ∀ ∃ √ ½ −", 0, MISSING_NOTHING},
                                         {"∓", 1, 0x2213},
                                         {"", 0, MISSING_NOTHING}};
    (void)state;
    expect_missing(pdf_text_missing, cases, sizeof cases / sizeof cases[0]);
}

/* An edge with this name, and the options to draw it. */
static const roberts_drawing *named_edge(const char *text, roberts_draw_options *options)
{
    static roberts_segment edge;
    static const roberts_drawing drawing = {.count = 1, .segment = &edge, .window_max = {10, 10}};
    static roberts_name name;
    edge = line_at(ROBERTS_OUTLINE, 0, 5, 10, 5);
    name = (roberts_name){ROBERTS_LABEL_EDGES, 0, 1, text};
    *options = roberts_draw_options_default();
    options->format = ROBERTS_PDF;
    options->lettering.native = true;
    options->lettering.name = &name;
    options->lettering.name_count = 1;
    return &drawing;
}

/* Inflates what is drawn on the page, the first stream of the file. */
static void read_page(const sink *file, char page[PAGE_ROOM])
{
    static const char begin[] = "stream\n";
    size_t at = 0;
    while (at + sizeof begin < file->size && memcmp(file->bytes + at, begin, sizeof begin - 1) != 0)
        at++;
    z_stream z = {.next_in = (Bytef *)file->bytes + at + sizeof begin - 1, .next_out = (Bytef *)page};
    z.avail_in = (uInt)(file->size - at - (sizeof begin - 1));
    z.avail_out = PAGE_ROOM - 1;
    assert_int_equal(inflateInit(&z), Z_OK);
    assert_int_equal(inflate(&z, Z_FINISH), Z_STREAM_END);
    page[z.total_out] = '\0';
    assert_int_equal(inflateEnd(&z), Z_OK);
}

/* Latin in Helvetica, Greek in Symbol, brackets and backslashes escaped, missing characters as question marks. */
static void the_page_holds_the_text(void **state)
{
    static const struct {
        const char *text, *first, *second;
    } cases[] = {{"edge 7", "/F1 ", " Tf (edge 7) Tj ET\n"},
                 {"\u00e9\u03b2", " Tf (\xe9) Tj /F2 ", " Tf (b) Tj ET\n"},
                 {"x \u2264\u221e", " Tf (x ) Tj /F2 ", " Tf (\xa3\xa5) Tj ET\n"},
                 {"(a) \\", "/F1 ", " Tf (\\(a\\) \\\\) Tj ET\n"},
                 {"x\u4e00", "/F1 ", " Tf (x?) Tj ET\n"}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char page[PAGE_ROOM];
        roberts_draw_options options;
        sink file = {0};
        const roberts_drawing *drawing = named_edge(cases[i].text, &options);
        assert_int_equal(roberts_drawing_write(drawing, &options, sink_write, &file, NULL), ROBERTS_OK);
        read_page(&file, page);
        const char *first = strstr(page, cases[i].first);
        if (!first || !strstr(first, cases[i].second))
            fail_msg("\"%s\": no %s ... %s in: %s", cases[i].text, cases[i].first, cases[i].second, page);
        free(file.bytes);
        options.lettering.native = false;
        file = (sink){0};
        assert_int_equal(roberts_drawing_write(drawing, &options, sink_write, &file, NULL), ROBERTS_OK);
        read_page(&file, page);
        assert_null(strstr(page, "Tj"));
        free(file.bytes);
    }
}

static void a_reader_finds_the_text(void **state)
{
    roberts_draw_options options;
    (void)state;
    if (system("pdftotext -v >/dev/null 2>&1") != 0)
        SKIP_BECAUSE("no pdftotext (poppler-utils) here");
    assert_int_equal(chdir(temporary), 0);
    const roberts_drawing *drawing = named_edge("Größe (β) \\ 5 ≤ 8−1 ≈ ∞′″", &options);
    assert_int_equal(roberts_drawing_save(drawing, &options, "a.pdf", NULL), ROBERTS_OK);
    assert_int_equal(system("pdftotext -enc UTF-8 a.pdf - | grep -qxF 'Größe (β) \\ 5 ≤ 8−1 ≈ ∞′″'"), 0);
    assert_int_equal(chdir(top), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(characters_that_the_fonts_lack),
        cmocka_unit_test(the_page_holds_the_text),
        cmocka_unit_test_setup_teardown(a_reader_finds_the_text, temporary_make, temporary_remove),
    };
    if (!getcwd(top, sizeof top))
        return 1;
    return cmocka_run_group_tests_name("text of PDF", tests, NULL, NULL);
}
