/* TikZ, DXF and HP-GL/2: every class has its pen, faults are found, and the programs that the files are for read them.
 * That all strokes are those of the SVG is checked for many drawings by test_paper. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "drawing.h"
#include "paper/plots.h"
#include "temporary.h"
#include "testing.h"

enum { SEGMENTS = ROBERTS_INTERSECTION + 1 };

static const roberts_format formats[] = {ROBERTS_TIKZ, ROBERTS_DXF, ROBERTS_HPGL};
enum { FORMATS = sizeof formats / sizeof formats[0] };

/* A line of each class, a bent one, and a square region for hatching. */
static const roberts_drawing *all_classes(void)
{
    static roberts_segment segment[SEGMENTS + 2];
    static size_t start[] = {0, 4};
    static roberts_vec2 corner[] = {{1, 1}, {6, 1}, {6, 6}, {1, 6}};
    static roberts_region region = {.ring_count = 1, .normal = {0, 1, 0}};
    static const roberts_region_list regions = {
        .count = 1, .ring_count = 1, .corner_count = 4, .region = &region, .ring_start = start, .corner = corner};
    static const roberts_drawing drawing = {
        .count = SEGMENTS + 2, .segment = segment, .window_max = {10, 10}, .regions = &regions};
    for (int i = 0; i < SEGMENTS; i++)
        segment[i] = line_at(i == ROBERTS_BACK ? ROBERTS_OUTLINE : (roberts_line)i, 0, i, 10, i);
    segment[ROBERTS_BACK].state = ROBERTS_HIDDEN;
    segment[SEGMENTS] = line_at(ROBERTS_OUTLINE, 2, 7, 8, 10);
    segment[SEGMENTS + 1] = line_at(ROBERTS_OUTLINE, 8, 10, 8, 7);
    return &drawing;
}

static roberts_draw_options colourful(void)
{
    roberts_draw_options options = paper_options();
    roberts_pen *const pen[] = {&options.outline,      &options.border, &options.crease,
                                &options.intersection, &options.wire,   &options.back,
                                &options.frame,        &options.symbol, &options.hatch};
    options.hidden = ROBERTS_HIDDEN_DASHED;
    options.frame.off = false;
    options.hatching.on = true;
    options.hatching.spacing_mm = 5.0;
    for (size_t i = 0; i < sizeof pen / sizeof pen[0]; i++) {
        pen[i]->width_mm = 0.1 + 0.05 * (double)i;
        pen[i]->dash_mm = i % 3 ? 1.0 + (double)i : 0.0;
        pen[i]->gap_mm = i % 3 ? 0.7 + 0.1 * (double)i : 0.0;
    }
    return options;
}

static char *written(const roberts_drawing *drawing, roberts_draw_options options, roberts_format format)
{
    options.format = format;
    return drawing_written(drawing, &options).bytes;
}

static char *sheet_text(const roberts_drawing *drawing, roberts_draw_options options, roberts_format format)
{
    const roberts_sheet sheet = {.view = {drawing, drawing, drawing, drawing}};
    options.format = format;
    return sheet_written(&sheet, &options).bytes;
}

static void expect_same(char *svg, char *text, roberts_format format, double height_mm)
{
    plot wanted, own;
    assert_true(plot_read(&wanted, ROBERTS_SVG, svg, height_mm));
    assert_true(plot_read(&own, format, text, height_mm));
    assert_true(plot_is_same(&wanted, &own, format, height_mm, stdout));
    plot_free(&wanted);
    plot_free(&own);
    free(text);
}

/* Pens of all kinds, pages of odd sizes and of 0.01 mm, a sheet with its symbol. */
static void every_class_has_its_pen(void **state)
{
    static const roberts_page page[] = {{210, 297, 10}, {33.333, 47.777, 1.5}, {5200, 4100, 100}};
    (void)state;
    for (size_t k = 0; k < sizeof page / sizeof page[0]; k++) {
        roberts_draw_options options = colourful();
        options.page = page[k];
        for (int real = 0; real < 2; real++) {
            options.real_dashes = real;
            char *svg = written(all_classes(), options, ROBERTS_SVG);
            char *sheet = k ? NULL : sheet_text(all_classes(), options, ROBERTS_SVG);
            for (int i = 0; i < FORMATS; i++) {
                expect_same(svg, written(all_classes(), options, formats[i]), formats[i], page[k].height_mm);
                if (sheet)
                    expect_same(sheet, sheet_text(all_classes(), options, formats[i]), formats[i], page[k].height_mm);
            }
            free(svg);
            free(sheet);
        }
    }
}

/* Changes of a file, each of which has to be found. */
static const struct {
    roberts_format format;
    const char *from, *to;
} changes[] = {
    {ROBERTS_TIKZ, "(200,", "(200.001,"},
    {ROBERTS_TIKZ, "rgb,255:red,255", "rgb,255:red,254"},
    {ROBERTS_TIKZ, "--cycle", ""},
    {ROBERTS_TIKZ, "dash pattern=on ", "dash pattern=on 1"},
    {ROBERTS_TIKZ, "{roberts crease}", "{roberts outline}"},
    {ROBERTS_TIKZ, "{roberts hatch}", "{roberts outline}"},
    {ROBERTS_DXF, "\n200\n", "\n200.001\n"},
    {ROBERTS_DXF, "LINE\n8\nCREASE", "LINE\n8\nBORDER"},
    {ROBERTS_DXF, "\n70\n129\n", "\n70\n128\n"},
    {ROBERTS_DXF, "\n6\nDASHED\n", "\n6\nCONTINUOUS\n"},
    {ROBERTS_DXF, "\n49\n", "\n49\n1"},
    {ROBERTS_HPGL, "PD8000,", "PD8001,"},
    {ROBERTS_HPGL, "PC6,255", "PC6,254"},
    {ROBERTS_HPGL, "SP4;", "SP5;"},
    {ROBERTS_HPGL, "LT8,", "LT8,1"},
};

static void changes_are_found(void **state)
{
    roberts_draw_options options = colourful();
    const double height_mm = options.page.height_mm;
    plot wanted;
    (void)state;
    char *svg = written(all_classes(), options, ROBERTS_SVG);
    assert_true(plot_read(&wanted, ROBERTS_SVG, svg, height_mm));
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        plot own;
        char *text = written(all_classes(), options, changes[i].format);
        const char *at = strstr(text, changes[i].from);
        print_message("%s\n", changes[i].from);
        assert_non_null(at);
        char *changed = malloc(strlen(text) + strlen(changes[i].to) + 1);
        assert_non_null(changed);
        size_t head = (size_t)(at - text);
        memcpy(changed, text, head);
        strcpy(changed + head, changes[i].to);
        strcat(changed, at + strlen(changes[i].from));
        assert_false(plot_read(&own, changes[i].format, changed, height_mm) &&
                     plot_is_same(&wanted, &own, changes[i].format, height_mm, NULL));
        plot_free(&own);
        free(changed);
        free(text);
    }
    plot_free(&wanted);
    free(svg);
}

/* The places of the vertices of lines that are drawn, each once; the hidden one, v5, with hidden lines only. */
static void tikz_knows_the_vertices_drawn(void **state)
{
#define TO_V4                                                                                                          \
    "\\coordinate (v0) at (200,203.348);\n\\coordinate (v1) at (105,258.197);\n"                                       \
    "\\coordinate (v2) at (105,148.5);\n\\coordinate (v3) at (10,203.348);\n\\coordinate (v4) at (200,93.652);\n"
#define FROM_V6 "\\coordinate (v6) at (105,38.803);\n\\coordinate (v7) at (10,93.652);\n\\pgfkeysifdefined"
    static const char *const wanted[] = {TO_V4 FROM_V6, TO_V4 "\\coordinate (v5) at (105,148.5);\n" FROM_V6};
    roberts_draw_options options = roberts_draw_options_default();
    roberts_drawing drawing = model_drawing("platonic/cube", "iso");
    (void)state;
    for (int hidden = 0; hidden < 2; hidden++) {
        options.hidden = hidden ? ROBERTS_HIDDEN_DASHED : ROBERTS_HIDDEN_NONE;
        char *text = written(&drawing, options, ROBERTS_TIKZ);
        assert_non_null(strstr(text, wanted[hidden]));
        free(text);
        text = sheet_text(&drawing, options, ROBERTS_TIKZ);
        assert_null(strstr(text, "\\coordinate"));
        free(text);
    }
    roberts_drawing_free(&drawing);
}

static void texts_of_tikz(void **state)
{
    roberts_draw_options options = roberts_draw_options_default();
    roberts_error error;
    sink to = {0};
    (void)state;
    options.format = ROBERTS_TIKZ;
    options.title = "a\nb \\c{";
    options.description = "\xc3\xa9 \xff";
    options.background = (roberts_background){true, 1, 2, 3};
    char *text = written(all_classes(), options, ROBERTS_TIKZ);
    const char *begins = "% a?b \\c{\n% \xc3\xa9 ?\n"
                         "\\ifpgfpicture\\def\\robertspicture{scope}\\else\\def\\robertspicture{tikzpicture}\\fi\n"
                         "\\begin{\\robertspicture}[x=1mm,y=1mm]\n"
                         "\\pgfkeysifdefined{/tikz/roberts page/.@cmd}{}{\\tikzset{roberts page/.style="
                         "{fill={rgb,255:red,1;green,2;blue,3}}}}\n"
                         "\\path[roberts page] (0,0) rectangle (210,297);\n";
    assert_memory_equal(text, begins, strlen(begins));
    const char *ends = "\\end{\\robertspicture}%\n"; /* no space beside the picture */
    assert_string_equal(text + strlen(text) - strlen(ends), ends);
    free(text);
    options.page = (roberts_page){5701, 100, 10};
    assert_int_equal(roberts_drawing_write(all_classes(), &options, sink_write, &to, &error), ROBERTS_BAD_ARGUMENT);
    assert_string_equal(error.message, "TeX knows no lengths of more than 5700 mm: choose a smaller page");
    assert_null(to.bytes);
}

/* What is less than half a unit long is a dot; a point that falls on the one before is left out. */
static void tiny_strokes_of_hpgl(void **state)
{
    roberts_segment segment[] = {line_at(ROBERTS_CREASE, 0, 0, 0.004, 0), line_at(ROBERTS_OUTLINE, 0, 50, 10, 50),
                                 line_at(ROBERTS_OUTLINE, 10, 50, 10.004, 50.004),
                                 line_at(ROBERTS_OUTLINE, 10.004, 50.004, 10, 60)};
    const roberts_drawing drawing = {.count = 4, .segment = segment, .framed = true, .window_max = {100, 100}};
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    options.page = (roberts_page){.width_mm = 100, .height_mm = 100};
    char *text = written(&drawing, options, ROBERTS_HPGL);
    assert_string_equal(text, "IN;NP16;\nSP4;PW0.35,4;PC4,0,0,0;LT;\nPU0,0;PD0,0;\nSP6;PW0.5,6;PC6,0,0,0;LT;\n"
                              "PU0,2000;PD400,2000,400,2400;\nPU;SP0;\n");
    free(text);
}

/* Classes with one pen follow the first of them, whatever is drawn in between: the plotter changes the pen but once. */
static void classes_share_a_pen(void **state)
{
    static const struct {
        unsigned char wire, crease, outline;
        const char *pens;
    } rows[] = {{1, 2, 1, "112"}, {3, 3, 3, "333"}, {1, 2, 3, "123"}, {2, 1, 1, "211"}};
    const roberts_segment segment[] = {line_at(ROBERTS_WIRE, 0, 0, 9, 0), line_at(ROBERTS_CREASE, 0, 9, 9, 9),
                                       line_at(ROBERTS_OUTLINE, 0, 50, 10, 50)};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        roberts_segment own[3];
        char pens[8] = "";
        memcpy(own, segment, sizeof own);
        const roberts_drawing drawing = {.count = 3, .segment = own};
        roberts_draw_options options = roberts_draw_options_default();
        options.wire.number = rows[i].wire;
        options.crease.number = rows[i].crease;
        options.outline.number = rows[i].outline;
        char *text = written(&drawing, options, ROBERTS_HPGL);
        for (const char *at = strstr(text, "SP"); at && at[2] != '0'; at = strstr(at + 1, "SP"))
            strncat(pens, at + 2, 1);
        assert_string_equal(pens, rows[i].pens);
        free(text);
    }
}

/* The corners of a page of 100 x 60 mm, as 4000 x 2400 units: right, up from the lower left. */
static void plotters_have_their_axes(void **state)
{
    static const struct {
        roberts_plotter plotter;
        const char *line;
    } cases[] = {
        {{false, 0, {0, 0}}, "PU0,0;PD4000,2400;"},          {{false, 90, {0, 0}}, "PU2400,0;PD0,4000;"},
        {{false, 180, {0, 0}}, "PU4000,2400;PD0,0;"},        {{false, 270, {0, 0}}, "PU0,4000;PD2400,0;"},
        {{true, 0, {0, 0}}, "PU-2000,-1200;PD2000,1200;"},   {{true, 90, {0, 0}}, "PU1200,-2000;PD-1200,2000;"},
        {{true, 180, {0, 0}}, "PU2000,1200;PD-2000,-1200;"}, {{true, 270, {0, 0}}, "PU-1200,2000;PD1200,-2000;"},
        {{false, 0, {10, 4}}, "PU-400,-160;PD3600,2240;"},   {{false, 90, {10, 4}}, "PU2000,-160;PD-400,3840;"},
    };
    roberts_segment segment = line_at(ROBERTS_CREASE, 0, 0, 100, 60);
    const roberts_drawing drawing = {.count = 1, .segment = &segment, .framed = true, .window_max = {100, 60}};
    roberts_draw_options options = roberts_draw_options_default();
    roberts_error error;
    sink to = {0};
    (void)state;
    options.page = (roberts_page){.width_mm = 100, .height_mm = 60};
    options.order = ROBERTS_ORDER_NONE;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        options.plotter = cases[i].plotter;
        char *text = written(&drawing, options, ROBERTS_HPGL);
        print_message("%s\n", cases[i].line);
        assert_non_null(strstr(text, cases[i].line));
        free(text);
    }
    options.plotter.turn = 45;
    assert_int_equal(roberts_drawing_write(&drawing, &options, sink_write, &to, &error), ROBERTS_BAD_ARGUMENT);
    assert_string_equal(error.message, "a plotter's page is turned by 0, 90, 180 or 270 degrees");
    options.plotter = (roberts_plotter){.inside_mm = {0, NAN}};
    assert_int_equal(roberts_drawing_write(&drawing, &options, sink_write, &to, &error), ROBERTS_BAD_ARGUMENT);
    assert_string_equal(error.message, "a plotter's origin lies at most 1000 mm inside");
}

static const struct {
    unsigned char red, green, blue;
    int number;
} color_cases[] = {
    {0, 0, 0, 7},         {255, 255, 255, 255}, {255, 0, 0, 1},    {255, 255, 0, 2},   {0, 255, 0, 3},
    {0, 255, 255, 4},     {0, 0, 255, 5},       {255, 0, 255, 6},  {128, 128, 128, 8}, {192, 192, 192, 9},
    {255, 128, 0, 30},    {165, 0, 0, 12},      {128, 64, 64, 15}, {0, 165, 0, 92},    {3, 3, 250, 5},
    {100, 100, 100, 252}, {255, 64, 0, 20},     {0, 64, 255, 160}, {0, 0, 127, 174},   {255, 0, 64, 240},
};

static void colours_of_dxf(void **state)
{
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    for (size_t i = 0; i < sizeof color_cases / sizeof color_cases[0]; i++) {
        char layer[60];
        options.outline.red = color_cases[i].red;
        options.outline.green = color_cases[i].green;
        options.outline.blue = color_cases[i].blue;
        char *text = written(all_classes(), options, ROBERTS_DXF);
        snprintf(layer, sizeof layer, "LAYER\n2\nOUTLINE\n70\n0\n62\n%d\n6\n", color_cases[i].number);
        print_message("%d %d %d\n", color_cases[i].red, color_cases[i].green, color_cases[i].blue);
        assert_non_null(strstr(text, layer));
        free(text);
    }
}

/* The background reaches to the borders of a PostScript page, which is whole points. */
static void backgrounds_of_postscript(void **state)
{
    static const roberts_format both[] = {ROBERTS_PS, ROBERTS_EPS};
    (void)state;
    for (int i = 0; i < 2; i++) {
        roberts_draw_options options = roberts_draw_options_default();
        options.page = (roberts_page){100, 80, 10}; /* 283.46 and 226.77 points */
        options.background = (roberts_background){true, 1, 2, 3};
        char *text = written(all_classes(), options, both[i]);
        assert_non_null(strstr(text, "\n%%BoundingBox: 0 0 284 227\n"));
        assert_non_null(strstr(text, "\n0 0 284 227 rectfill\n"));
        free(text);
    }
}

/* ---- programs that read them ---- */

static char top[4096]; /* the folder that the test began in */

static void save(const char *path, roberts_format format, const roberts_draw_options *from)
{
    roberts_draw_options options = *from;
    options.format = format;
    assert_int_equal(roberts_drawing_save(all_classes(), &options, path, NULL), ROBERTS_OK);
}

/* Counts what is on each layer, the dashes of DASHED, and what the reader complains of. */
static void a_reader_of_dxf_opens_it(void **state)
{
    const roberts_draw_options options = colourful();
    (void)state;
    if (system("/usr/bin/python3 -c 'import ezdxf' 2>/dev/null") != 0)
        SKIP_BECAUSE("no ezdxf (python3-ezdxf) here");
    assert_int_equal(chdir(temporary), 0);
    save("a.dxf", ROBERTS_DXF, &options);
    assert_int_equal(system("/usr/bin/python3 -c '\n"
                            "import ezdxf, collections\n"
                            "doc = ezdxf.readfile(\"a.dxf\")\n"
                            "audit = doc.audit()\n"
                            "assert doc.dxfversion == \"AC1009\" and doc.units == 4\n"
                            "assert not audit.errors and not audit.fixes\n"
                            "found = collections.Counter((e.dxf.layer, e.dxftype()) for e in doc.modelspace())\n"
                            "assert found == {(\"HATCH\", \"LINE\"): 12, (\"HIDDEN\", \"LINE\"): 1, (\"WIRE\", "
                            "\"LINE\"): 1, (\"INTERSECTION\", \"LINE\"): 1,\n"
                            "    (\"CREASE\", \"LINE\"): 1, (\"BORDER\", \"LINE\"): 1, (\"OUTLINE\", \"LINE\"): 1,\n"
                            "    (\"OUTLINE\", \"POLYLINE\"): 1, (\"FRAME\", \"POLYLINE\"): 1}, found\n"
                            "assert doc.layers.get(\"HIDDEN\").dxf.linetype == \"DASHED\"\n"
                            "assert \"DASHED\" in doc.linetypes\n"
                            "closed = [e.is_closed for e in doc.modelspace() if e.dxf.layer == \"FRAME\"]\n"
                            "assert closed == [True]\n'"),
                     0);
    assert_int_equal(chdir(top), 0);
}

/* A sheet of two views: its labels, dimensions and title block as text, not as strokes. */
static roberts_draw_options with_text(void)
{
    static const roberts_name names[] = {{ROBERTS_LABEL_EDGES, 0, 1, "\u00e9\U0001d11e 5%% \\ \t"}};
    roberts_draw_options options = roberts_draw_options_default();
    options.page = (roberts_page){297, 210, 10};
    options.lettering.native = true;
    options.lettering.name = names;
    options.lettering.name_count = 1;
    options.lettering.title = "Title";
    options.lettering.overall = true;
    return options;
}

static void texts_of_dxf(void **state)
{
    (void)state;
    roberts_draw_options options = with_text();
    char *text = sheet_text(all_classes(), options, ROBERTS_DXF);
    assert_non_null(strstr(text, "LAYER\n2\nTEXT\n"));
    assert_non_null(strstr(text, "\n1\n\\U+00E9\\U+D834\\U+DD1E 5%%%%%% \\ ?\n72\n1\n")); /* centred */
    assert_non_null(strstr(text, "\n40\n5\n1\nTitle\n0\n"));   /* 5 mm high, from its start */
    assert_non_null(strstr(text, "\n1\n10\n50\n90\n72\n1\n")); /* the height reads up */
    free(text);
    options.text.off = true;
    text = sheet_text(all_classes(), options, ROBERTS_DXF);
    assert_null(strstr(text, "TEXT"));
    free(text);
}

static void a_reader_of_dxf_finds_text(void **state)
{
    const roberts_sheet sheet = {.view = {all_classes(), all_classes(), all_classes(), all_classes()}};
    roberts_draw_options options = with_text();
    (void)state;
    if (system("/usr/bin/python3 -c 'import ezdxf' 2>/dev/null") != 0)
        SKIP_BECAUSE("no ezdxf (python3-ezdxf) here");
    assert_int_equal(chdir(temporary), 0);
    options.format = ROBERTS_DXF;
    assert_int_equal(roberts_sheet_save(&sheet, &options, "t.dxf", NULL), ROBERTS_OK);
    assert_int_equal(
        system("/usr/bin/python3 -c '\n"
               "import ezdxf\n"
               "doc = ezdxf.readfile(\"t.dxf\")\n"
               "audit = doc.audit()\n"
               "assert not audit.errors and not audit.fixes\n"
               "texts = [e for e in doc.modelspace() if e.dxftype() == \"TEXT\" and e.dxf.layer == \"TEXT\"]\n"
               "found = {(e.dxf.text, e.dxf.height, e.dxf.rotation, e.dxf.halign) for e in texts}\n"
               "assert (\"Title\", 5.0, 0.0, 0) in found and (\"10\", 3.5, 90.0, 1) in found, found\n'"),
        0);
    assert_int_equal(chdir(top), 0);
}

/* The document redefines a style and uses a vertex. */
static void latex_compiles_tikz(void **state)
{
    const roberts_draw_options options = colourful();
    (void)state;
    if (system("pdflatex --version >/dev/null 2>&1 && kpsewhich tikz.sty >/dev/null 2>&1") != 0)
        SKIP_BECAUSE("no pdflatex with tikz here");
    assert_int_equal(chdir(temporary), 0);
    save("a.tikz", ROBERTS_TIKZ, &options);
    FILE *file = fopen("a.tex", "w");
    assert_non_null(file);
    fputs("\\documentclass{article}\n\\usepackage{tikz}\n\\begin{document}\n"
          "\\newcount\\n\\tikzset{roberts crease/.style={draw=red,/utils/exec={\\global\\advance\\n by 1 }}}\n"
          "\\resizebox{5cm}{!}{\\input{a.tikz}}\n"
          "\\begin{tikzpicture}\\input{a.tikz}\\draw (v0) -- (v1);\\end{tikzpicture}\n"
          "\\typeout{creases: \\the\\n}\n\\end{document}\n",
          file);
    assert_int_equal(fclose(file), 0);
    assert_int_equal(system("pdflatex -halt-on-error -interaction=nonstopmode a.tex >a.out 2>&1"), 0);
    assert_int_equal(system("grep -q '^creases: 2$' a.log"), 0);
    assert_int_equal(chdir(top), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_class_has_its_pen),
        cmocka_unit_test(changes_are_found),
        cmocka_unit_test(tikz_knows_the_vertices_drawn),
        cmocka_unit_test(texts_of_tikz),
        cmocka_unit_test(classes_share_a_pen),
        cmocka_unit_test(tiny_strokes_of_hpgl),
        cmocka_unit_test(plotters_have_their_axes),
        cmocka_unit_test(colours_of_dxf),
        cmocka_unit_test(backgrounds_of_postscript),
        cmocka_unit_test_setup_teardown(a_reader_of_dxf_opens_it, temporary_make, temporary_remove),
        cmocka_unit_test(texts_of_dxf),
        cmocka_unit_test_setup_teardown(a_reader_of_dxf_finds_text, temporary_make, temporary_remove),
        cmocka_unit_test_setup_teardown(latex_compiles_tikz, temporary_make, temporary_remove),
    };
    if (!getcwd(top, sizeof top))
        return 1;
    return cmocka_run_group_tests_name("plots", tests, NULL, NULL);
}
