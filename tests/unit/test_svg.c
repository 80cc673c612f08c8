/* SVG: the page's size, its layers, and every coordinate read back and compared with where it should be. The other
 * formats: the same bytes every time, and no failure goes unnoticed. */
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "write/formats.h"
#include "drawing.h"
#include "rng.h"
#include "testing.h"

/* `count` segments of all classes in a box of the given size at `corner`; none is shorter than 1/100 of it. */
static roberts_drawing random_drawing(size_t count, double size, roberts_vec2 corner)
{
    rng r = {count};
    roberts_drawing drawing = {.count = count, .segment = malloc((count + 1) * sizeof(roberts_segment))};
    assert_non_null(drawing.segment);
    for (size_t i = 0; i < count; i++) {
        double x = rng_between(&r, 0, 1), y = rng_between(&r, 0, 1);
        double dx = (x < 0.5 ? 1 : -1) * (0.01 + 0.4 * rng_between(&r, 0, 1)), dy = y < 0.5 ? 0.3 : -0.3;
        drawing.segment[i] = line_at((roberts_line)(i % 2), corner.x + size * x, corner.y + size * y,
                                     corner.x + size * (x + dx), corner.y + size * (y + dy));
        if (i % 3 == 2)
            drawing.segment[i].state = ROBERTS_HIDDEN;
    }
    return drawing;
}

/* ---- coordinates ---- */

static const struct {
    const char *name;
    roberts_page page;
    double size;
    roberts_vec2 corner;
    double limit_mm;
} true_cases[] = {
    {"A4", {210, 297, 10}, 1, {0, 0}, 0.00051},
    {"A4 lying", {297, 210, 0}, 7, {3, 4}, 0.00051},
    {"A0", {841, 1189, 10}, 100, {0, 0}, 0.00051},
    {"2A0", {1189, 1682, 10}, 100, {0, 0}, 0.00051},
    {"4 m", {4000, 4000, 0}, 1, {0, 0}, 0.00051},
    {"a roll of 40 m", {900, 40000, 10}, 1, {0, 0}, 0.0051},
    {"40 m each way", {40000, 40000, 0}, 1, {0, 0}, 0.0051},
    {"a stamp", {20, 10, 1}, 1, {0, 0}, 0.00051},
    {"tiny drawing", {210, 297, 10}, 1e-9, {0, 0}, 0.00051},
    {"huge drawing", {210, 297, 10}, 1e9, {-4e8, 1e9}, 0.00051},
    {"far away", {210, 297, 10}, 1, {1e6, -1e7}, 0.00051},
};

/* Where p belongs on the page: the definition, in more digits. Half of the widest pen is kept where margins
 * are less. */
static void exact_place(const roberts_page *page, const roberts_drawing *d, roberts_vec2 p, long double at[2])
{
    long double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (size_t i = 0; i < d->count; i++)
        for (int end = 0; end < 2; end++) {
            roberts_vec2 q = end ? d->segment[i].p1 : d->segment[i].p0;
            low[0] = fminl(low[0], q.x), high[0] = fmaxl(high[0], q.x);
            low[1] = fminl(low[1], q.y), high[1] = fmaxl(high[1], q.y);
        }
    long double margin = fmax(page->margin_mm, roberts_draw_options_default().outline.width_mm / 2);
    long double scale =
        fminl((page->width_mm - 2 * margin) / (high[0] - low[0]), (page->height_mm - 2 * margin) / (high[1] - low[1]));
    at[0] = page->width_mm / 2.0L + scale * (p.x - (low[0] + high[0]) / 2);
    at[1] = page->height_mm / 2.0L - scale * (p.y - (low[1] + high[1]) / 2);
}

static double deviation(const char **at, char command, const long double place[2])
{
    double worst = 0.0;
    *at += strspn(*at, " \n");
    assert_int_equal(**at, command);
    ++*at;
    for (int i = 0; i < 2; i++) {
        char *end;
        double number = strtod(*at, &end);
        assert_ptr_not_equal(end, *at);
        *at = end;
        worst = fmax(worst, fabs((double)(number - place[i])));
    }
    return worst;
}

static void lines_are_true(void **state)
{
    static const char *const layer[] = {"hidden", "crease", "outline"};
    (void)state;
    for (size_t i = 0; i < sizeof true_cases / sizeof true_cases[0]; i++) {
        roberts_drawing drawing = random_drawing(600, true_cases[i].size, true_cases[i].corner);
        roberts_draw_options options = roberts_draw_options_default();
        double worst = 0.0;
        options.order = ROBERTS_ORDER_NONE;
        options.page = true_cases[i].page;
        options.hidden = ROBERTS_HIDDEN_DASHED;
        char *text = drawing_written(&drawing, &options).bytes;
        const char *at = text;
        for (int k = 0; k < 3; k++) {
            char open[64];
            snprintf(open, sizeof open, "<g id=\"%s\"", layer[k]);
            at = strstr(at, open);
            assert_non_null(at);
            at = strstr(at, " d=\"") + 4;
            for (size_t n = 0; n < drawing.count; n++) {
                const roberts_segment *s = &drawing.segment[n];
                int class = s->state == ROBERTS_HIDDEN ? 0 : s->line == ROBERTS_CREASE ? 1 : 2;
                long double place[2];
                if (class != k)
                    continue;
                exact_place(&options.page, &drawing, s->p0, place);
                worst = fmax(worst, deviation(&at, 'M', place));
                exact_place(&options.page, &drawing, s->p1, place);
                worst = fmax(worst, deviation(&at, 'L', place));
            }
            assert_int_equal(strncmp(at, " \"/>\n</g>\n", 10), 0); /* one path, and nothing else in it */
            assert_null(memchr(at + 2, 'M', 4));
        }
        print_message("%s: off by %.6f mm at the most\n", true_cases[i].name, worst);
        assert_true(worst < true_cases[i].limit_mm);
        free(text);
        free(drawing.segment);
    }
}

/* ---- the text round them ---- */

#define SVG(size, box, body)                                                                                           \
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\""                            \
    " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" " size " viewBox=\"" box          \
    "\">\n" body "</svg>\n"
#define A4(body) SVG("width=\"210mm\" height=\"297mm\"", "0 0 210 297", body)
#define LAYER(name, pen, data)                                                                                         \
    "<g id=\"" name "\" inkscape:groupmode=\"layer\" inkscape:label=\"" name "\">\n<path fill=\"none\" " pen           \
    " d=\"" data "\"/>\n</g>\n"
#define ROUND " stroke-linecap=\"round\" stroke-linejoin=\"round\""

static roberts_segment few[] = {
    {.p0 = {0, 0}, .p1 = {190, 0}, .line = ROBERTS_OUTLINE},
    {.p0 = {0, 0}, .p1 = {95, 10}, .line = ROBERTS_CREASE},
    {.p0 = {190, 10}, .p1 = {95, 0}, .line = ROBERTS_OUTLINE, .state = ROBERTS_HIDDEN},
    {.p0 = {5, 5}, .p1 = {5, 5}, .line = ROBERTS_OUTLINE},
    {.p0 = {5, 5}, .p1 = {6, 6}, .line = ROBERTS_OUTLINE, .state = ROBERTS_CLIPPED},
};

static const struct {
    const char *name;
    size_t first, count;
    roberts_hidden hidden;
    roberts_page page;
    const char *wanted;
} text_cases[] = {
    {"empty", 0, 0, ROBERTS_HIDDEN_NONE, {210, 297, 10}, A4("")},
    {"end-on alone", 3, 1, ROBERTS_HIDDEN_NONE, {210, 297, 10}, A4("")},
    {"clipped alone", 4, 1, ROBERTS_HIDDEN_DASHED, {210, 297, 10}, A4("")},
    {"hidden alone, not wanted", 2, 1, ROBERTS_HIDDEN_NONE, {210, 297, 10}, A4("")},
    {"no height",
     0,
     1,
     ROBERTS_HIDDEN_NONE,
     {210, 297, 10},
     A4(LAYER("outline", "stroke=\"#000000\" stroke-width=\"0.5\"" ROUND, "M 10 148.5 L 200 148.5 "))},
    {"two layers",
     0,
     4,
     ROBERTS_HIDDEN_NONE,
     {210, 297, 10},
     A4(LAYER("crease", "stroke=\"#000000\" stroke-width=\"0.35\"" ROUND, "M 10 153.5 L 105 143.5 ")
            LAYER("outline", "stroke=\"#000000\" stroke-width=\"0.5\"" ROUND, "M 10 153.5 L 200 153.5 "))},
    {"dashed: 3 mm and 0.75 mm of ink and none, with the caps",
     2,
     1,
     ROBERTS_HIDDEN_DASHED,
     {210, 297, 10},
     A4(LAYER("hidden", "stroke=\"#000000\" stroke-width=\"0.25\"" ROUND " stroke-dasharray=\"2.75 1\"",
              "M 200 138.5 L 10 158.5 "))},
    {"solid",
     2,
     1,
     ROBERTS_HIDDEN_SOLID,
     {210, 297, 10},
     A4(LAYER("hidden", "stroke=\"#000000\" stroke-width=\"0.25\"" ROUND, "M 200 138.5 L 10 158.5 "))},
    {"odd page",
     0,
     1,
     ROBERTS_HIDDEN_NONE,
     {215.9, 279.405, 12.7},
     SVG("width=\"215.9mm\" height=\"279.405mm\"", "0 0 215.9 279.405",
         LAYER("outline", "stroke=\"#000000\" stroke-width=\"0.5\"" ROUND, "M 12.7 139.703 L 203.2 139.703 "))},
};

static void texts(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof text_cases / sizeof text_cases[0]; i++) {
        roberts_drawing drawing = {.count = text_cases[i].count, .segment = few + text_cases[i].first};
        roberts_draw_options options = roberts_draw_options_default();
        options.order = ROBERTS_ORDER_NONE;
        options.page = text_cases[i].page;
        options.hidden = text_cases[i].hidden;
        char *text = drawing_written(&drawing, &options).bytes;
        print_message("%s\n", text_cases[i].name);
        assert_string_equal(text, text_cases[i].wanted);
        free(text);
    }
}

static void locale_changes_nothing(void **state)
{
    (void)state;
    if (!setlocale(LC_ALL, "de_DE.UTF-8")) {
        SKIP_BECAUSE("no locale de_DE.UTF-8");
    }
    texts(NULL);
    setlocale(LC_ALL, "C");
}

static void pens(void **state)
{
    roberts_drawing drawing = {.count = 1, .segment = few};
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    options.outline = (roberts_pen){.width_mm = 1.2347, .dash_mm = 1, .gap_mm = 2, .red = 255, .green = 8, .blue = 160};
    char *text = drawing_written(&drawing, &options).bytes;
    assert_non_null(strstr(text, "stroke=\"#ff08a0\" stroke-width=\"1.235\""));
    assert_non_null(strstr(text, "stroke-dasharray=\"0 3.235\"")); /* shorter than the pen is wide: dots */
    free(text);
}

/* One rectangle, the page, before all lines; in documents too, where it makes no image of them. */
static void backgrounds(void **state)
{
    static const char below[] =
        "viewBox=\"0 0 210 297\">\n"
        "<rect id=\"background\" width=\"210\" height=\"297\" fill=\"#ff0080\"/>\n<g id=\"outline\"";
    roberts_drawing drawing = {.count = 1, .segment = few};
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    for (int on = 0; on < 2; on++) {
        options.background = (roberts_background){.on = on, .red = 255, .blue = 128};
        options.format = ROBERTS_SVG;
        char *text = drawing_written(&drawing, &options).bytes;
        assert_int_equal(strstr(text, below) != NULL, on);
        assert_int_equal(strstr(text, "<rect") != NULL, on);
        free(text);
        options.format = ROBERTS_EPS;
        text = drawing_written(&drawing, &options).bytes;
        const char *paint = strstr(text, "1 0 0.501961 rg\n"), *line = strstr(text, "0 g\n");
        assert_int_equal(paint != NULL, on);
        assert_true(line && paint < line);
        assert_null(strstr(text, "ImageType")); /* of the dictionaries of images */
        free(text);
    }
}

static const struct {
    const char *given, *wanted;
} xml_cases[] = {
    {"plain", "plain"},
    {"a<b>&\"c'", "a&lt;b&gt;&amp;\"c'"},
    {"tab\tand\nline", "tab\tand\nline"},
    {"bell\a", "bell?"},
    {"\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80", "\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80"}, /* 2, 3 and 4 bytes */
    {"latin \xe9", "latin ?"},
    {"cut off \xe2\x82", "cut off ??"},
    {"too long \xc0\xaf", "too long ??"},
    {"surrogate \xed\xa0\x80", "surrogate ???"},
    {"no character \xef\xbf\xbf", "no character ???"},
    {"beyond \xf4\x90\x80\x80", "beyond ????"},
    {"never \xff\xfe", "never ??"},
};

static void title_and_description(void **state)
{
    roberts_drawing drawing = {.count = 1, .segment = few};
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    for (size_t i = 0; i < sizeof xml_cases / sizeof xml_cases[0]; i++) {
        char wanted[200];
        options.title = "A & B";
        options.description = xml_cases[i].given;
        char *text = drawing_written(&drawing, &options).bytes;
        snprintf(wanted, sizeof wanted, "297\">\n<title>A &amp; B</title>\n<desc>%s</desc>\n<g ", xml_cases[i].wanted);
        assert_non_null(strstr(text, wanted));
        free(text);
    }
}

/* A line around a square: one figure, closed, with nothing after it. */
static void closed_lines_are_closed(void **state)
{
    roberts_segment square[] = {line_at(ROBERTS_OUTLINE, 0, 0, 190, 0), line_at(ROBERTS_OUTLINE, 190, 0, 190, 190),
                                line_at(ROBERTS_OUTLINE, 190, 190, 0, 190), line_at(ROBERTS_OUTLINE, 0, 0, 0, 190)};
    roberts_drawing drawing = {.count = 4, .segment = square};
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    char *text = drawing_written(&drawing, &options).bytes;
    assert_non_null(strstr(text, " d=\"M 10 243.5 L 200 243.5 L 200 53.5 L 10 53.5 Z \"/>"));
    free(text);
}

/* The chunk pHYs right after the header: dots per metre both ways, and the checksum that others compute as well. */
static void images_know_their_resolution(void **state)
{
    static const unsigned char at_300[] = {0,    0, 0, 9,    'p',  'H', 'Y',  's',  0,    0,   0x2e,
                                           0x23, 0, 0, 0x2e, 0x23, 1,   0x78, 0xa5, 0x3f, 0x76};
    roberts_drawing drawing = {.count = 1, .segment = few};
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    options.format = ROBERTS_PNG;
    options.page = (roberts_page){.width_mm = 25.4, .height_mm = 50.8, .margin_mm = 1};
    options.dpi = 300;
    sink png = drawing_written(&drawing, &options);
    assert_true(png.size > 60);
    assert_memory_equal(png.bytes + 12, "IHDR\0\0\x01\x2c\0\0\x02\x58", 12); /* 300 x 600 */
    assert_memory_equal(png.bytes + 33, at_300, sizeof at_300);
    assert_memory_equal(png.bytes + png.size - 8, "IEND", 4);
    free(png.bytes);
}

/* Readers find the objects of a PDF by its table of offsets, which is found by the number at the end. */
static void pdf_objects_are_where_the_table_says(void **state)
{
    roberts_drawing drawing = model_drawing("table", "iso");
    roberts_draw_options options = roberts_draw_options_default();
    size_t table, length = 0;
    (void)state;
    options.format = ROBERTS_PDF;
    sink pdf = drawing_written(&drawing, &options);
    char *bytes = pdf.bytes, *end = bytes + pdf.size;
    assert_string_equal(end - 6, "%%EOF\n");
    table = strtoul(end - 17, NULL, 10);
    assert_true(table < pdf.size);
    assert_memory_equal(bytes + table, "xref\n0 6\n0000000000 65535 f \n", 29);
    for (int i = 1; i <= 5; i++) {
        char object[12];
        const char *row = bytes + table + 9 + (size_t)i * 20;
        size_t at = strtoul(row, NULL, 10), wanted = (size_t)snprintf(object, sizeof object, "%d 0 obj\n", i);
        assert_memory_equal(row + 10, " 00000 n \n", 10);
        assert_true(at < table);
        assert_memory_equal(bytes + at, object, wanted);
        if (i == 5)
            length = strtoul(bytes + at + wanted, NULL, 10);
    }
    const char *stream = strstr(bytes, "stream\n") + 7;
    assert_memory_equal(stream + length, "\nendstream\nendobj\n5 0 obj\n", 26);
    free(bytes);
    roberts_drawing_free(&drawing);
}

/* Offsets have ten digits. As if many bytes were written already, the file ends below that length or is refused. */
static void too_long_a_pdf_is_refused(void **state)
{
    roberts_drawing drawing = model_drawing("table", "iso");
    roberts_draw_options options = roberts_draw_options_default();
    strokes s;
    (void)state;
    options.format = ROBERTS_PDF;
    assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
    for (int i = 0; i < 3; i++) {
        static const uint64_t before[] = {9999900000, 9999999000, 10000000000};
        sink to = {0};
        roberts_error error;
        output *out = malloc(sizeof *out);
        assert_non_null(out);
        output_start(out, sink_write, &to);
        out->written = before[i];
        assert_int_equal(pdf_write(&s, out, &error), i == 0 ? ROBERTS_OK : ROBERTS_BAD_ARGUMENT);
        if (i == 0) {
            assert_int_equal(output_finish(out, NULL), ROBERTS_OK);
            assert_memory_equal(to.bytes + to.size - 17, "99999", 5);
            assert_true(before[i] + to.size < 10000000000);
        } else {
            assert_string_equal(error.message,
                                "a PDF of more than 10^10 bytes cannot say where its parts are; choose another format");
        }
        free(to.bytes);
        free(out);
    }
    strokes_free(&s);
    roberts_drawing_free(&drawing);
}

/* However many strokes a Cairo path or surface takes, none is lost where one of these ends. */
static void no_stroke_is_lost(void **state)
{
    static const size_t counts[] = {1, 2, 999, 1000, 1001, 2000, 49999, 50000, 50001, 100000, 123456};
    (void)state;
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        roberts_drawing drawing = random_drawing(counts[i], 1.0, (roberts_vec2){0, 0});
        roberts_draw_options options = roberts_draw_options_default();
        size_t moves = 0, lines = 0, paths = 0;
        options.order = ROBERTS_ORDER_NONE;
        for (size_t n = 0; n < drawing.count; n++)
            drawing.segment[n] = line_at(ROBERTS_OUTLINE, (double)(n % 400), (double)(n / 400), (double)(n % 400) + 0.4,
                                         (double)(n / 400) + 0.2); /* none meets another */
        char *text = drawing_written(&drawing, &options).bytes;
        for (const char *at = strstr(text, "<path"); *at; at++) {
            moves += at[0] == 'M' && at[1] == ' ';
            lines += at[0] == 'L' && at[1] == ' ';
            paths += strncmp(at, "<path", 5) == 0;
        }
        print_message("%zu\n", counts[i]);
        assert_int_equal(moves, counts[i]);
        assert_int_equal(lines, counts[i]);
        assert_int_equal(paths, 1);
        free(text);
        free(drawing.segment);
    }
}

/* ---- all formats ---- */

static const struct {
    roberts_format format;
    const char *begins;
} format_cases[] = {
    {ROBERTS_SVG, "<?xml"},
    {ROBERTS_PDF, "%PDF-1."},
    {ROBERTS_PS, "%!PS-Adobe-3.0\n"},
    {ROBERTS_EPS, "%!PS-Adobe-3.0 EPSF-3.0\n"},
    {ROBERTS_PNG, "\x89PNG\r\n"},
    {ROBERTS_CSV, "body,"},
    {ROBERTS_TIKZ, "\\ifpgfpicture"},
    {ROBERTS_DXF, "0\nSECTION\n"},
    {ROBERTS_HPGL, "IN;"},
    {ROBERTS_JSON, "[\n{"},
};
enum { FORMATS = sizeof format_cases / sizeof format_cases[0] };

static void bytes_are_the_same_later(void **state)
{
    roberts_drawing drawing = random_drawing(300, 1.0, (roberts_vec2){0, 0});
    roberts_draw_options options = roberts_draw_options_default();
    sink first[FORMATS];
    const struct timespec over_a_second = {1, 100000000};
    (void)state;
    options.hidden = ROBERTS_HIDDEN_DASHED;
    options.dpi = 30;
    for (int i = 0; i < FORMATS; i++) {
        options.format = format_cases[i].format;
        first[i] = drawing_written(&drawing, &options);
        assert_int_equal(strncmp(first[i].bytes, format_cases[i].begins, strlen(format_cases[i].begins)), 0);
    }
    nanosleep(&over_a_second, NULL); /* the clock goes on: dates would differ */
    for (int i = 0; i < FORMATS; i++) {
        options.format = format_cases[i].format;
        sink second = drawing_written(&drawing, &options);
        print_message("%s\n", format_cases[i].begins);
        assert_int_equal(first[i].size, second.size);
        assert_memory_equal(first[i].bytes, second.bytes, second.size);
        free(first[i].bytes);
        free(second.bytes);
    }
    free(drawing.segment);
}

static void failures_are_told(void **state)
{
    roberts_drawing drawing = random_drawing(1000, 1.0, (roberts_vec2){0, 0});
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    options.dpi = 30;
    for (int i = 0; i < FORMATS; i++) {
        options.format = format_cases[i].format;
        sink all = drawing_written(&drawing, &options);
        const size_t size = all.size;
        free(all.bytes);
        for (size_t room = 1; room < 2 * size; room = room * 4 + 1) {
            sink to = {.room = room};
            roberts_error error = {0};
            roberts_status status = roberts_drawing_write(&drawing, &options, sink_write, &to, &error);
            assert_int_equal(status, room < size ? ROBERTS_IO : ROBERTS_OK);
            if (status != ROBERTS_OK)
                assert_string_equal(error.message, "cannot write: No space left on device");
            free(to.bytes);
        }
    }
    free(drawing.segment);
}

static void refused(const roberts_draw_options *options)
{
    roberts_drawing drawing = {.count = 1, .segment = few};
    roberts_error error = {0};
    sink to = {0};
    assert_int_equal(roberts_drawing_write(&drawing, options, sink_write, &to, &error), ROBERTS_BAD_ARGUMENT);
    assert_int_equal(error.status, ROBERTS_BAD_ARGUMENT);
    assert_true(error.message[0] != '\0');
    assert_null(to.bytes);
}

static void senseless_options_are_refused(void **state)
{
    static const double widths[] = {0.0, -1.0, NAN, INFINITY, 1001.0};
    static const double dpis[] = {0.0, -1.0, NAN, INFINITY, 4000.0};
    roberts_draw_options good = roberts_draw_options_default(), bad;
    (void)state;
    for (size_t i = 0; i < sizeof widths / sizeof widths[0]; i++) {
        bad = good;
        bad.crease.width_mm = widths[i];
        refused(&bad);
        bad = good;
        bad.back.dash_mm = widths[i] == 0.0 ? -0.1 : widths[i];
        refused(&bad);
        bad = good;
        bad.format = ROBERTS_PNG;
        bad.dpi = dpis[i];
        refused(&bad);
        bad.page = (roberts_page){210, 297, 200};
        refused(&bad);
    }
    bad = good;
    bad.format = (roberts_format)99;
    refused(&bad);
    bad = good;
    bad.hidden = (roberts_hidden)99;
    refused(&bad);
}

/* Fills, hatching and some labels need regions; formats that have none of these do not. */
static void drawings_without_regions_are_refused(void **state)
{
    static const roberts_name face = {.of = ROBERTS_LABEL_FACES, .text = "A"};
    const roberts_drawing drawing = {.count = 1, .segment = few};
    const roberts_draw_options good = roberts_draw_options_default();
    roberts_draw_options options = good;
    (void)state;
    options.fill = ROBERTS_FILL_BODY;
    refused(&options);
    options.format = ROBERTS_HPGL;
    free(drawing_written(&drawing, &options).bytes);
    options.format = ROBERTS_CSV;
    free(drawing_written(&drawing, &options).bytes);
    options = good;
    options.hatching.on = true;
    refused(&options);
    options.hatch.off = true;
    free(drawing_written(&drawing, &options).bytes);
    options = good;
    options.lettering.labels = ROBERTS_LABEL_BODIES;
    refused(&options);
    options.lettering = (roberts_lettering){.name_count = 1, .name = &face};
    refused(&options);
    const roberts_sheet sheet = {.view = {[ROBERTS_SHEET_TOP] = &drawing}};
    sink to = {0};
    assert_int_equal(roberts_sheet_write(&sheet, &options, sink_write, &to, NULL), ROBERTS_BAD_ARGUMENT);
    options = good;
    options.lettering.labels = ROBERTS_LABEL_VERTICES;
    free(drawing_written(&drawing, &options).bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_are_true),
        cmocka_unit_test(texts),
        cmocka_unit_test(locale_changes_nothing),
        cmocka_unit_test(pens),
        cmocka_unit_test(backgrounds),
        cmocka_unit_test(title_and_description),
        cmocka_unit_test(closed_lines_are_closed),
        cmocka_unit_test(images_know_their_resolution),
        cmocka_unit_test(pdf_objects_are_where_the_table_says),
        cmocka_unit_test(too_long_a_pdf_is_refused),
        cmocka_unit_test(no_stroke_is_lost),
        cmocka_unit_test(bytes_are_the_same_later),
        cmocka_unit_test(failures_are_told),
        cmocka_unit_test(senseless_options_are_refused),
        cmocka_unit_test(drawings_without_regions_are_refused),
    };
    return cmocka_run_group_tests_name("svg", tests, NULL, NULL);
}
