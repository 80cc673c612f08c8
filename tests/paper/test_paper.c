/* Pages against tables: what SVG, PDF and PNG show is read back and compared with the segments. This is a sample;
 * tests/paper/compare draws more. */
#include <dirent.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drawing.h"
#include "paper/trials.h"
#include "testing.h"

/* ---- faults that there were ------------------------------------------------------------------------------------ */

static const struct {
    const char *name, *off;
    roberts_vec3 dir;
} cases[] = {
    {"a hidden edge just below the surface of a brick lies on the visible edge of another",
     "OFF/16 12 0/0 0 0/1 0 0/0 1.0000012 0/1 1.0000012 0/0 0 0.9999999/1 0 0.9999999/0 1.0000012 0.9999999/"
     "1 1.0000012 0.9999999/0 1 0/1 1 0/0 2 0/1 2 0/0 1 1/1 1 1/0 2 1/1 2 1/4 0 2 3 1/4 4 5 7 6/4 0 1 5 4/4 1 3 7 5/"
     "4 3 2 6 7/4 2 0 4 6/4 8 10 11 9/4 12 13 15 14/4 8 9 13 12/4 9 11 15 13/4 11 10 14 15/4 10 8 12 14/",
     {-1, 1, 2}},
    {"a needle, on the page thinner than places are apart",
     "OFF/4 4 0/0 0 0/1 0 1e-6/1 1e-6 0/1 1e-6 1e-6/3 0 2 1/3 0 1 3/3 0 3 2/3 1 2 3/",
     {0, -1, 0.2}},
    {"a box, three faces on one edge, a wire before and behind them",
     "OFF/17 10 0/0 0 0/4 0 0/4 4 0/0 -4 -1/4 -4 -1/0 -3 0/4 -3 0/-1 -2 2/5 3 -2/1 1 1/2 1 1/1 2 1/2 2 1/1 1 2/2 1 2/"
     "1 2 2/2 2 2/3 0 1 2/4 0 1 4 3/4 0 1 6 5/2 7 8/4 9 11 12 10/4 13 14 16 15/4 9 10 14 13/4 10 12 16 14/"
     "4 12 11 15 16/4 11 9 13 15/",
     {1, -2, 3}},
};

/* A slash stands for a new line. */
static void read_scene(trial_scene *scene, const char *name, const char *off)
{
    char text[1000];
    size_t length = strlen(off);
    assert_true(length < sizeof text);
    for (size_t i = 0; i <= length; i++)
        text[i] = off[i] == '/' ? '\n' : off[i];
    *scene = (trial_scene){0};
    snprintf(scene->name, sizeof scene->name, "%s", name);
    assert_int_equal(roberts_mesh_read_memory(&scene->mesh, name, text, length, NULL, NULL), ROBERTS_OK);
}

static void expect_right(const trial_scene *scene, const trial_style *style)
{
    findings f = {.out = stdout};
    trial_result result = trial_run(scene, style, &f);
    if (result == TRIAL_REFUSED)
        fail_msg("%s, %s: refused", scene->name, style->name);
    if (result == TRIAL_WRONG)
        fail_msg("%s, %s: %zu rows not drawn, %zu lines without a row, %zu lines twice, %zu faults of pixels",
                 scene->name, style->name, f.missing, f.unfounded, f.twice, f.pixels);
}

static void old_faults_are_mended(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        for (size_t k = 0; k < trial_style_count(); k++) {
            trial_scene scene;
            read_scene(&scene, cases[i].name, cases[i].off);
            scene.camera = (roberts_camera){.projection = ROBERTS_ORTHOGRAPHIC, .dir = cases[i].dir};
            expect_right(&scene, trial_style_at(k));
            trial_free(&scene);
        }
}

/* ---- scenes ---------------------------------------------------------------------------------------------------- */

/* Each family of this folder in each style, and a fifth of the others. */
static void generated_scenes_are_drawn_right(void **state)
{
    size_t drawn = 0;
    (void)state;
    for (size_t i = 0; i < trial_family_count(); i++)
        for (size_t k = 0; k < trial_style_count(); k++) {
            trial_scene scene;
            bool own = i < trial_own_families();
            if (!own && (i % 5 || k != i / 5 % trial_style_count()))
                continue;
            assert_true(trial_make(i, 1 + k, &scene));
            expect_right(&scene, trial_style_at(k));
            trial_free(&scene);
            drawn++;
        }
    print_message("%zu drawings compared with their tables\n", drawn);
}

enum { MODEL_BYTES = 60000 /* larger files have too many lines for a check of each against each */ };

/* Draws one model, from a preset or in perspective; the style goes round. */
static void draw_model(const char *path, size_t *drawn)
{
    static const char *const view[] = {"iso", "front", "top", NULL};
    trial_scene scene = {0};
    roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE, .eye = {150, -120, 90}};
    const char *preset = view[*drawn % 4];
    snprintf(scene.name, sizeof scene.name, "%s, %s", path, preset ? preset : "perspective");
    assert_int_equal(roberts_mesh_read_file(&scene.mesh, path, NULL, NULL), ROBERTS_OK);
    assert_true(!preset || roberts_camera_preset(preset, &camera));
    scene.camera = camera;
    expect_right(&scene, trial_style_at(*drawn * 5 % trial_style_count()));
    trial_free(&scene);
    ++*drawn;
}

static void draw_folder(const char *folder, size_t *drawn)
{
    struct dirent **entry;
    int count = scandir(folder, &entry, NULL, alphasort);
    assert_true(count > 0);
    for (int i = 0; i < count; i++) {
        char path[300];
        size_t length = strlen(entry[i]->d_name);
        snprintf(path, sizeof path, "%s/%s", folder, entry[i]->d_name);
        if (length > 4 && strcmp(entry[i]->d_name + length - 4, ".off") == 0) {
            FILE *file = fopen(path, "r");
            assert_non_null(file);
            assert_int_equal(fseek(file, 0, SEEK_END), 0);
            long size = ftell(file);
            fclose(file);
            if (size <= MODEL_BYTES)
                draw_model(path, drawn);
        }
        free(entry[i]);
    }
    free(entry);
}

static void models_are_drawn_right(void **state)
{
    static const char *const folder[] = {"models",         "models/platonic", "models/archimedean",
                                         "models/catalan", "models/prisms",   "models/tests"};
    size_t drawn = 0;
    (void)state;
    for (size_t i = 0; i < sizeof folder / sizeof folder[0]; i++)
        draw_folder(folder[i], &drawn);
    print_message("%zu drawings compared with their tables\n", drawn);
    assert_true(drawn > 50);
}

/* ---- the check itself ------------------------------------------------------------------------------------------ */

enum { LINES = 3 };

/* Three rows: an outline, a crease and a hidden one; the drawing fills 100 by 100 mm. */
static void make_rows(row_list *r, const roberts_draw_options *options)
{
    static roberts_segment segment[LINES] = {
        {.p0 = {0, 0}, .p1 = {100, 0}, .state = ROBERTS_VISIBLE, .line = ROBERTS_OUTLINE},
        {.p0 = {0, 0}, .p1 = {0, 100}, .state = ROBERTS_VISIBLE, .line = ROBERTS_CREASE},
        {.p0 = {0, 0}, .p1 = {100, 100}, .state = ROBERTS_HIDDEN, .line = ROBERTS_OUTLINE},
    };
    assert_true(rows_place(r, &(roberts_drawing){.count = LINES, .segment = segment}, options));
}

/* As they have to be drawn. */
#define RIGHT_OUTLINE                                                                                                  \
    {                                                                                                                  \
        {0, 100}, {100, 100}, ROBERTS_OUTLINE, 1                                                                       \
    }
#define RIGHT_CREASE                                                                                                   \
    {                                                                                                                  \
        {0, 100}, {0, 0}, ROBERTS_CREASE, 2                                                                            \
    }
#define RIGHT_HIDDEN                                                                                                   \
    {                                                                                                                  \
        {0, 100}, {100, 0}, ROBERTS_BACK, 3                                                                            \
    }

static const struct {
    const char *name;
    paper_line line[LINES + 1];
    size_t count, missing, unfounded, twice;
} changes[] = {
    {"as it has to be", {RIGHT_OUTLINE, RIGHT_CREASE, RIGHT_HIDDEN}, 3, 0, 0, 0},
    {"the outline is not there", {RIGHT_CREASE, RIGHT_HIDDEN}, 2, 1, 0, 0},
    {"the outline ends too early", {{{0, 100}, {99.98, 100}, 0, 1}, RIGHT_CREASE, RIGHT_HIDDEN}, 3, 1, 0, 0},
    {"the outline ends a little too early", {{{0, 100}, {99.995, 100}, 0, 1}, RIGHT_CREASE, RIGHT_HIDDEN}, 3, 0, 0, 0},
    {"the outline has a gap",
     {{{0, 100}, {50, 100}, 0, 1}, {{50.03, 100}, {100, 100}, 0, 2}, RIGHT_CREASE, RIGHT_HIDDEN},
     4,
     1,
     0,
     0},
    {"the outline is too long", {{{-0.02, 100}, {100, 100}, 0, 1}, RIGHT_CREASE, RIGHT_HIDDEN}, 3, 0, 1, 0},
    {"the outline is beside its place", {{{0, 100.02}, {100, 100.02}, 0, 1}, RIGHT_CREASE, RIGHT_HIDDEN}, 3, 1, 1, 0},
    {"the outline is drawn as a crease", {{{0, 100}, {100, 100}, 1, 1}, RIGHT_CREASE, RIGHT_HIDDEN}, 3, 1, 1, 0},
    {"the crease is drawn as hidden", {RIGHT_OUTLINE, {{0, 100}, {0, 0}, 2, 1}, RIGHT_HIDDEN}, 3, 1, 1, 0},
    {"the outline twice", {RIGHT_OUTLINE, RIGHT_CREASE, RIGHT_HIDDEN, RIGHT_OUTLINE}, 4, 0, 0, 1},
    {"half of the outline twice",
     {RIGHT_OUTLINE, RIGHT_CREASE, RIGHT_HIDDEN, {{20, 100}, {70, 100}, 0, 4}},
     4,
     0,
     0,
     1},
    {"the outline as a crease, too",
     {RIGHT_OUTLINE, RIGHT_CREASE, RIGHT_HIDDEN, {{20, 100}, {70, 100}, 1, 4}},
     4,
     0,
     1,
     1},
};

static void faults_of_lines_are_found(void **state)
{
    roberts_draw_options options = paper_options();
    (void)state;
    options.page = (roberts_page){.width_mm = 100.0, .height_mm = 100.0, .margin_mm = 0.0};
    options.hidden = ROBERTS_HIDDEN_DASHED;
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        row_list r;
        paper_line line[LINES + 1];
        findings f = {0};
        memcpy(line, changes[i].line, sizeof line);
        make_rows(&r, &options);
        check_lines(&r, &(paper){.item = line, .count = changes[i].count}, &options, &f);
        print_message("%s: %zu, %zu, %zu\n", changes[i].name, f.missing, f.unfounded, f.twice);
        assert_int_equal(f.missing, changes[i].missing);
        assert_int_equal(f.unfounded, changes[i].unfounded);
        assert_int_equal(f.twice, changes[i].twice);
        rows_free(&r);
    }
}

/* A line of each class, alone on its height, comes back from SVG and PDF in its layer and colour. */
static void each_class_is_read_back(void **state)
{
    enum { CLASSES = ROBERTS_INTERSECTION + 1 };
    roberts_segment segment[CLASSES] = {{0}};
    roberts_draw_options options = paper_options();
    (void)state;
    options.hidden = ROBERTS_HIDDEN_SOLID;
    for (int i = 0; i < CLASSES; i++)
        segment[i] = (roberts_segment){.p0 = {0, i},
                                       .p1 = {10, i},
                                       .state = i == ROBERTS_BACK ? ROBERTS_HIDDEN : ROBERTS_VISIBLE,
                                       .line = (uint8_t)i};
    for (int pdf = 0; pdf < 2; pdf++) {
        paper p = {0};
        sink to = {0};
        bool found[CLASSES] = {false};
        options.format = pdf ? ROBERTS_PDF : ROBERTS_SVG;
        assert_int_equal(roberts_drawing_write(&(roberts_drawing){.count = CLASSES, .segment = segment}, &options,
                                               sink_write, &to, NULL),
                         ROBERTS_OK);
        assert_true(pdf ? paper_read_pdf(&p, to.bytes, to.size, options.page.height_mm)
                        : paper_read_svg(&p, to.bytes, to.size));
        assert_int_equal(p.count, CLASSES);
        for (size_t i = 0; i < p.count; i++) {
            const paper_line *line = &p.item[i];
            assert_in_range(line->line, 0, CLASSES - 1);
            assert_true(fabs(fabs(line->a.x - line->b.x) - 190.0) < 0.002);
            assert_true(fabs(line->a.y - (148.5 + 19.0 * (2.5 - line->line))) < 0.002);
            found[line->line] = true;
        }
        for (int i = 0; i < CLASSES; i++)
            assert_true(found[i]);
        paper_free(&p);
        free(to.bytes);
    }
}

static void faults_of_pixels_are_found(void **state)
{
    roberts_draw_options options = paper_options();
    row_list r;
    findings f = {0};
    (void)state;
    options.page = (roberts_page){.width_mm = 100.0, .height_mm = 100.0, .margin_mm = 0.0};
    options.hidden = ROBERTS_HIDDEN_SOLID;
    options.dpi = 254.0;
    make_rows(&r, &options);
    rows_free(&r);
    options.page.margin_mm = 5.0;
    make_rows(&r, &options);
    picture p = {.pixel = calloc(1000 * 1000, sizeof *p.pixel), .width = 1000, .height = 1000};
    assert_non_null(p.pixel);
    for (size_t i = 0; i < 1000 * 1000; i++)
        p.pixel[i] = 0xffffff;
    check_pixels(&r, &p, &options, &f);
    assert_int_equal(f.pixels, LINES); /* nothing is drawn */
    f = (findings){0};
    p.pixel[500 * 1000 + 300] = paper_color(ROBERTS_CREASE);
    check_pixels(&r, &p, &options, &f);
    assert_int_equal(f.pixels, LINES + 1);
    free(p.pixel);
    rows_free(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults_of_lines_are_found), cmocka_unit_test(faults_of_pixels_are_found),
        cmocka_unit_test(each_class_is_read_back),   cmocka_unit_test(old_faults_are_mended),
        cmocka_unit_test(models_are_drawn_right),    cmocka_unit_test(generated_scenes_are_drawn_right),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
