/* Hatching: strokes end on the rings of their regions, their length follows the shade, and they continue from face
 * to face. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/vec.h"
#include "draw/hatch.h"
#include "drawing.h"
#include "rng.h"
#include "testing.h"

/* ---- regions given by hand ------------------------------------------------------------------------------------- */

enum { RINGS_MOST = 4, CORNERS_MOST = 12 };

typedef struct ring {
    size_t count;
    double corner[CORNERS_MOST][2];
} ring;

/* A region with its rings, and a drawing that has it alone. The picture is 100 x 100; a unit is a mm, y up. */
typedef struct given_region {
    roberts_region region;
    roberts_slope slope;
    size_t start[RINGS_MOST + 1];
    roberts_vec2 corner[RINGS_MOST * CORNERS_MOST];
    roberts_region_list list;
    roberts_drawing drawing;
} given_region;

static void give(given_region *g, const ring *rings, size_t count, roberts_vec3 normal)
{
    *g = (given_region){.region = {.ring_count = count, .normal = normal},
                        .slope = {.steep = {0.0, 1.0}, .level = {1.0, 0.0}, .foot = {50.0, 50.0}}};
    size_t corners = 0;
    for (size_t r = 0; r < count; r++) {
        for (size_t k = 0; k < rings[r].count; k++)
            g->corner[corners++] = (roberts_vec2){rings[r].corner[k][0], rings[r].corner[k][1]};
        g->start[r + 1] = corners;
    }
    g->list = (roberts_region_list){1, count, corners, &g->region, g->start, g->corner, &g->slope, false};
    g->drawing = (roberts_drawing){.framed = true, .window_max = {100.0, 100.0}, .epsilon = 1e-9, .regions = &g->list};
}

/* A page of 100 x 100 mm; light from the viewer. */
static roberts_draw_options options_for(double spacing_mm, double degrees)
{
    roberts_draw_options options = roberts_draw_options_default();
    options.page = (roberts_page){100.0, 100.0, 0.0};
    options.light = (roberts_vec3){0.0, 0.0, 1.0};
    options.hatching.on = true;
    options.hatching.spacing_mm = spacing_mm;
    options.hatching.degrees = degrees;
    options.hatching.levels = 0;
    return options;
}

/* The normal of a face of this darkness. */
static roberts_vec3 normal_of(double dark)
{
    const double cosine = 1.0 - dark;
    return (roberts_vec3){sqrt(1.0 - cosine * cosine), 0.0, cosine};
}

static strokes strokes_of(const roberts_drawing *drawing, const roberts_draw_options *options)
{
    strokes s;
    roberts_error error = {0};
    if (strokes_make(&s, drawing, options, &error) != ROBERTS_OK)
        fail_msg("%s", error.message);
    return s;
}

static int place_of_class(roberts_line line)
{
    int i = 0;
    while (line_order[i] != line)
        i++;
    return i;
}

/* How long a stroke is, in mm. */
static double length_mm(const strokes *s, size_t i)
{
    const polyline *line = &s->lines.item[i];
    const page_point *p = s->lines.point + line->first;
    double length = 0.0;
    for (uint32_t k = 0; k + !line->closed < line->count; k++)
        length += page_distance(p[k], p[(k + 1) % line->count]) / s->units_per_mm;
    return length;
}

/* How long the strokes of hatching are, in mm. */
static double hatched_mm(const strokes *s)
{
    const int c = place_of_class(LINE_HATCH);
    double length = 0.0;
    for (size_t i = s->start[c]; i < s->start[c + 1]; i++)
        length += length_mm(s, i);
    return length;
}

/* ---- where strokes end ----------------------------------------------------------------------------------------- */

/* With a spacing of 10 and an angle of 0, lines are 5, 15, ... mm below the page's upper border: y = 95, 85, ..., 5 in
 * the picture. Wanted: the strokes, from left to right, line by line from the top. */
static const struct {
    const char *name;
    size_t rings;
    ring ring[RINGS_MOST];
    const char *wanted;
} clip_cases[] = {
    {"a square", 1, {{4, {{20, 20}, {40, 20}, {40, 40}, {20, 40}}}}, "35: 20-40; 25: 20-40; "},
    {"a square from line to line: its upper side belongs to it, its lower does not",
     1,
     {{4, {{20, 15}, {40, 15}, {40, 35}, {20, 35}}}},
     "35: 20-40; 25: 20-40; "},
    {"a triangle with a corner on a line", 1, {{3, {{20, 10}, {60, 10}, {40, 35}}}}, "25: 32-48; 15: 24-56; "},
    {"a rhombus with two corners on a line, which it crosses there",
     1,
     {{4, {{50, 5}, {80, 25}, {50, 45}, {20, 25}}}},
     "35: 35-65; 25: 20-80; 15: 35-65; "},
    {"a U, from below: two strokes on a line",
     1,
     {{8, {{10, 10}, {70, 10}, {70, 50}, {50, 50}, {50, 30}, {30, 30}, {30, 50}, {10, 50}}}},
     "45: 10-30, 50-70; 35: 10-30, 50-70; 25: 10-70; 15: 10-70; "},
    {"a hole",
     2,
     {{4, {{10, 10}, {90, 10}, {90, 40}, {10, 40}}}, {4, {{30, 20}, {30, 30}, {60, 30}, {60, 20}}}},
     "35: 10-90; 25: 10-30, 60-90; 15: 10-90; "},
    {"a hole with a corner on the ring round it",
     2,
     {{3, {{10, 10}, {90, 10}, {50, 50}}}, {3, {{50, 50}, {40, 20}, {60, 20}}}},
     "45: 45-48.333, 51.667-55; 35: 35-45, 55-65; 25: 25-41.667, 58.333-75; 15: 15-85; "},
    {"two pieces",
     2,
     {{3, {{10, 10}, {30, 10}, {20, 20}}}, {3, {{50, 10}, {90, 10}, {70, 30}}}},
     "25: 65-75; 15: 15-25, 55-85; "},
    {"a side on a line, with the region on both sides of it",
     1,
     {{6, {{10, 5.5}, {90, 5.5}, {90, 35}, {50, 25}, {40, 25}, {10, 35}}}},
     "25: 10-90; 15: 10-90; "},
    {"between two lines", 1, {{4, {{10, 16}, {90, 16}, {90, 24}, {10, 24}}}}, ""},
    {"no area", 1, {{3, {{10, 25}, {50, 25}, {90, 25}}}}, ""},
};

typedef struct span {
    double y, x0, x1;
} span;

static int by_place(const void *pa, const void *pb)
{
    const span *a = pa, *b = pb;
    if (a->y != b->y)
        return a->y > b->y ? -1 : 1;
    return (a->x0 > b->x0) - (a->x0 < b->x0);
}

static void print_spans(const strokes *s, char *text, size_t size)
{
    const int c = place_of_class(LINE_HATCH);
    span list[64];
    size_t count = 0, used = 0;
    for (size_t i = s->start[c]; i < s->start[c + 1]; i++) {
        const polyline *line = &s->lines.item[i];
        const page_point *p = s->lines.point + line->first;
        assert_int_equal(line->count, 2);
        assert_int_equal(p[0].y, p[1].y);
        list[count++] = (span){100.0 - p[0].y / 1000.0, fmin(p[0].x, p[1].x) / 1000.0, fmax(p[0].x, p[1].x) / 1000.0};
    }
    qsort(list, count, sizeof *list, by_place);
    text[0] = '\0';
    for (size_t i = 0; i < count; i++) {
        const bool first = i == 0 || list[i].y != list[i - 1].y, last = i + 1 == count || list[i].y != list[i + 1].y;
        if (first)
            used += (size_t)snprintf(text + used, size - used, "%g: ", list[i].y);
        used += (size_t)snprintf(text + used, size - used, "%.5g-%.5g%s", list[i].x0, list[i].x1, last ? "; " : ", ");
    }
}

static void strokes_end_on_rings(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof clip_cases / sizeof clip_cases[0]; i++) {
        given_region g;
        char text[1000];
        const roberts_draw_options options = options_for(10.0, 0.0);
        give(&g, clip_cases[i].ring, clip_cases[i].rings, normal_of(1.0));
        strokes s = strokes_of(&g.drawing, &options);
        print_spans(&s, text, sizeof text);
        print_message("%s\n", clip_cases[i].name);
        assert_string_equal(text, clip_cases[i].wanted);
        strokes_free(&s);
    }
}

/* ---- tone ------------------------------------------------------------------------------------------------------ */

/* The area of a region. */
static double area_of(const given_region *g)
{
    double twice = 0.0;
    for (size_t r = 0; r < g->list.ring_count; r++)
        for (size_t k = g->start[r]; k < g->start[r + 1]; k++) {
            const roberts_vec2 p = g->corner[k], q = g->corner[k + 1 < g->start[r + 1] ? k + 1 : g->start[r]];
            twice += p.x * q.y - p.y * q.x;
        }
    return fabs(twice) / 2.0;
}

static const ring with_hole[2] = {{5, {{3, 5}, {97, 2}, {93, 60}, {60, 97}, {8, 90}}},
                                  {4, {{40, 30}, {30, 55}, {65, 60}, {60, 35}}}};

enum { FEW_STROKES = 20, LONGEST_MM = 125 /* strokes across the region above, from corner to corner */ };

/* The length of strokes follows the shade: divided by the area and times the spacing, it is how dark the face is.
 * Nested strokes are not equally far apart: a tone between two powers of a half has gaps of two widths. So if few of
 * them cross the region, one more or less counts for more than 5 %. (Fractions of multiples of the golden section,
 * which are nested, too, are no better: measured on 4,000 windows of lines.) */
static void length_follows_shade(void **state)
{
    rng r = {20240};
    double worst[2] = {0.0, 0.0}; /* of even and of nested strokes */
    double stroke = 0.0;          /* of few nested strokes, in strokes of full length */
    (void)state;
    for (int trial = 0; trial < 400; trial++) {
        given_region g;
        const double dark = rng_between(&r, 0.05, 1.0);
        roberts_draw_options options = options_for(rng_between(&r, 0.2, 0.5), rng_between(&r, -360.0, 360.0));
        options.hatching.cross = trial % 3 == 0 ? 1.0 : rng_between(&r, 0.0, 1.0);
        options.hatching.along = (roberts_hatch_along)(trial % 5 % 3);
        options.hatching.nested = trial % 2;
        give(&g, with_hole, 2, normal_of(dark));
        g.slope.steep = (roberts_vec2){rng_between(&r, -1.0, 1.0), rng_between(&r, -1.0, 1.0)};
        g.slope.level = (roberts_vec2){rng_between(&r, -1.0, 1.0), rng_between(&r, -1.0, 1.0)};
        strokes s = strokes_of(&g.drawing, &options);
        const double ink = hatched_mm(&s) * options.hatching.spacing_mm / area_of(&g);
        const double part = fabs(ink - dark) / dark;
        const double strokes_wanted = dark * area_of(&g) / options.hatching.spacing_mm / LONGEST_MM;
        const bool few = options.hatching.nested && strokes_wanted < FEW_STROKES;
        if (part > 0.05 && !(few && part * strokes_wanted < 1.0))
            fail_msg("trial %d: %g of ink where %g was wanted (spacing %g, angle %g, cross %g)", trial, ink, dark,
                     options.hatching.spacing_mm, options.hatching.degrees, options.hatching.cross);
        if (!few)
            worst[trial % 2] = fmax(worst[trial % 2], part);
        else
            stroke = fmax(stroke, part * strokes_wanted);
        strokes_free(&s);
    }
    print_message("note: off by %.2f %% at the most, nested strokes by %.2f %%, fewer than %d by %.2f of one\n",
                  100.0 * worst[0], 100.0 * worst[1], FEW_STROKES, stroke);
}

/* With levels, each tone is that of the nearest level, and no face is off by more than half a level. */
static void levels_are_the_nearest(void **state)
{
    (void)state;
    for (uint32_t levels = 0; levels <= 12; levels++)
        for (int i = 0; i <= 100; i++) {
            roberts_draw_options options = options_for(1.0, 0.0);
            const double dark = i / 100.0;
            const roberts_region region = {.normal = normal_of(dark)};
            options.hatching.levels = levels;
            const double given = hatch_darkness(&options, &region);
            if (levels > 0) {
                assert_true(fabs(given * levels - round(given * levels)) < 1e-9);
                assert_true(fabs(given - dark) <= 0.5 / levels + 1e-9);
            } else {
                assert_true(fabs(given - dark) < 1e-9);
            }
        }
}

/* Faces turned away from the light are as dark as a face parallel to it. A face perpendicular to the light has no
 * strokes. */
static void ends_of_the_scale(void **state)
{
    given_region g;
    roberts_draw_options options = options_for(1.0, 0.0);
    (void)state;
    give(&g, with_hole, 2, (roberts_vec3){0.0, 0.0, 1.0});
    strokes s = strokes_of(&g.drawing, &options);
    assert_true(hatched_mm(&s) == 0.0);
    strokes_free(&s);
    options.light = (roberts_vec3){0.0, 0.0, -5.0};
    assert_true(hatch_darkness(&options, &g.region) == 1.0);
    s = strokes_of(&g.drawing, &options);
    assert_true(fabs(hatched_mm(&s) / area_of(&g) - 1.0) < 0.01);
    strokes_free(&s);
}

/* Only sections have strokes, in the darkest tone, and those of odd bodies run across the others, unless all bodies are
 * drawn as one. */
static void sections_alone_have_strokes(void **state)
{
    given_region g;
    roberts_draw_options options = options_for(1.0, 30.0);
    (void)state;
    options.hatching.sections = true;
    options.hatching.levels = 4;
    for (int section = 0; section < 2; section++)
        for (uint32_t solid = 0; solid < 3; solid++)
            for (int united = 0; united < 2; united++) {
                give(&g, with_hole, 2, (roberts_vec3){0.0, 0.6, 0.8});
                g.region.section = section;
                g.region.solid = solid;
                g.list.united = united;
                strokes s = strokes_of(&g.drawing, &options);
                const double wanted = section ? area_of(&g) : 0.0;
                assert_true(fabs(hatched_mm(&s) - wanted) <= 0.01 * wanted);
                const int c = place_of_class(LINE_HATCH);
                for (size_t i = s.start[c]; i < s.start[c + 1]; i++) {
                    const page_point *p = s.lines.point + s.lines.item[i].first; /* y down */
                    const double degrees = atan2((double)p[0].y - p[1].y, (double)p[1].x - p[0].x) * 180.0 / acos(-1.0);
                    const double off = remainder(degrees - (solid == 1 && !united ? 120.0 : 30.0), 180.0);
                    assert_true(fabs(off) < 1.0 || length_mm(&s, i) < 1.0);
                }
                strokes_free(&s);
            }
}

/* Nested strokes of a lighter tone are also in each darker one. */
static void nested_strokes_stay(void **state)
{
    const ring square = {4, {{10, 10}, {90, 10}, {90, 90}, {10, 90}}};
    bool before[101] = {false};
    (void)state;
    for (int tone = 1; tone <= 16; tone++) {
        given_region g;
        bool there[101] = {false};
        roberts_draw_options options = options_for(1.0, 0.0);
        size_t count = 0;
        options.hatching.nested = true;
        give(&g, &square, 1, normal_of(tone / 16.0));
        strokes s = strokes_of(&g.drawing, &options);
        const int c = place_of_class(LINE_HATCH);
        for (size_t i = s.start[c]; i < s.start[c + 1]; i++) {
            there[s.lines.point[s.lines.item[i].first].y / 1000] = true;
            count++;
        }
        assert_int_equal(count, 5 * tone);
        for (int i = 0; i <= 100; i++) {
            assert_true(there[i] || !before[i]);
            before[i] = there[i];
        }
        strokes_free(&s);
    }
}

/* ---- of scenes ------------------------------------------------------------------------------------------------- */

static roberts_drawing draw_regions(const roberts_scene *scene, const roberts_camera *camera, uint32_t threads,
                                    roberts_region_list *regions)
{
    roberts_hide_options hide = roberts_hide_options_default();
    hide.threads = threads;
    roberts_drawing drawing = drawing_of(scene, camera, &hide);
    assert_int_equal(roberts_regions(scene, camera, &hide, regions, NULL), ROBERTS_OK);
    drawing.regions = regions;
    return drawing;
}

/* A floor of 4 x 4 squares in one plane, of one body or of many: its strokes are those of one square, not cut. */
static void strokes_go_on(void **state)
{
    const char *const views[] = {"top", "iso", "trimetric"};
    (void)state;
    for (int along = ROBERTS_HATCH_PICTURE; along <= ROBERTS_HATCH_ACROSS; along++)
        for (size_t v = 0; v < sizeof views / sizeof views[0]; v++) {
            size_t strokes_on[2];
            double length[2];
            for (int k = 0; k < 2; k++) {
                const int n = k == 0 ? 1 : 4;
                roberts_mesh mesh = {0};
                roberts_camera camera = preset_camera(views[v]);
                roberts_region_list regions;
                for (int i = 0; i <= n * (n + 2); i++)
                    mesh_vertex(&mesh, (roberts_vec3){4.0 / n * (i % (n + 1)), 4.0 / n * (i / (n + 1)), 1.0});
                for (int i = 0; i < n * n; i++) {
                    const uint32_t a = (uint32_t)(i / n * (n + 1) + i % n), b = a + (uint32_t)n + 1;
                    mesh_face(&mesh, (uint32_t[]){a, a + 1, b + 1, b}, 4);
                }
                roberts_scene *scene = build_scene(&mesh);
                roberts_drawing drawing = draw_regions(scene, &camera, 1, &regions);
                assert_int_equal(regions.count, n * n);
                roberts_draw_options options = options_for(1.3, 31.0);
                options.light = (roberts_vec3){1.0, 0.3, 0.1};
                options.hatching.along = (roberts_hatch_along)along;
                strokes s = strokes_of(&drawing, &options);
                const int c = place_of_class(LINE_HATCH);
                strokes_on[k] = s.start[c + 1] - s.start[c];
                length[k] = hatched_mm(&s);
                strokes_free(&s);
                roberts_drawing_free(&drawing);
                roberts_regions_free(&regions);
                roberts_scene_free(scene);
            }
            assert_true(strokes_on[0] > 20);
            assert_int_equal(strokes_on[0], strokes_on[1]);
            assert_true(fabs(length[0] - length[1]) < 0.01 * (double)strokes_on[0]);
        }
}

/* On faces, strokes run along lines of their planes: upright ones on walls, in every view. */
static void steep_strokes_are_upright(void **state)
{
    roberts_scene *scene = scene_of_file("models/platonic/cube.off");
    (void)state;
    for (int i = 0; i < 12; i++) {
        roberts_camera camera;
        roberts_region_list regions;
        assert_true(roberts_camera_angles(17.0 + 30.0 * i, 20.0, 0.0, &camera));
        roberts_drawing drawing = draw_regions(scene, &camera, 1, &regions);
        for (size_t k = 0; k < regions.count; k++) {
            const roberts_vec3 normal = regions.region[k].normal;
            const roberts_slope *own = &regions.slope[k];
            const double c = cos(20.0 * acos(-1.0) / 180.0), s = sin(20.0 * acos(-1.0) / 180.0);
            assert_true(fabs(vec3_length(normal) - 1.0) < 1e-12);
            if (normal.y > 0.5) { /* the top: +y, foreshortened by the elevation, and +x */
                assert_true(fabs(hypot(own->steep.x, own->steep.y / s) - 1.0) < 1e-9);
                assert_true(fabs(hypot(own->level.x, own->level.y / s) - 1.0) < 1e-9);
            } else {
                assert_true(fabs(own->steep.x) < 1e-12 && fabs(own->steep.y - c) < 1e-12);
                assert_true(own->level.x > 0.0);
                assert_true(fabs(own->level.x - normal.z / c) < 1e-9);
            }
        }
        roberts_drawing_free(&drawing);
        roberts_regions_free(&regions);
    }
    roberts_scene_free(scene);
}

/* The same bytes for any number of threads, in parallel view and in perspective, where the frame cuts strokes off. */
static void threads_change_nothing(void **state)
{
    static const char *const models[] = {"models/temple.off", "models/shapes/goblet.off", "models/city.off"};
    (void)state;
    for (size_t m = 0; m < sizeof models / sizeof models[0]; m++) {
        roberts_scene *scene = scene_of_file(models[m]);
        for (int v = 0; v < 2; v++) {
            roberts_camera camera = preset_camera("iso");
            sink out[2];
            if (v == 1) {
                camera.projection = ROBERTS_PERSPECTIVE;
                camera.eye = (roberts_vec3){60.0, -90.0, 50.0};
                camera.fov_degrees = 20.0;
            }
            for (int k = 0; k < 2; k++) {
                roberts_region_list regions;
                roberts_drawing drawing = draw_regions(scene, &camera, k == 0 ? 1 : 5, &regions);
                roberts_draw_options options = roberts_draw_options_default();
                options.hatching.on = true;
                options.hatching.cross = 0.5;
                options.hatching.along = (roberts_hatch_along)(m % 3);
                out[k] = drawing_written(&drawing, &options);
                roberts_drawing_free(&drawing);
                roberts_regions_free(&regions);
            }
            assert_int_equal(out[0].size, out[1].size);
            assert_memory_equal(out[0].bytes, out[1].bytes, out[0].size);
            free(out[0].bytes);
            free(out[1].bytes);
        }
        roberts_scene_free(scene);
    }
}

/* In a field of view, strokes end at its frame. */
static void frames_cut_strokes(void **state)
{
    given_region g;
    const ring wide = {4, {{-500, -500}, {700, -400}, {600, 800}, {-300, 500}}};
    roberts_draw_options options = options_for(0.5, 33.0);
    (void)state;
    options.page = (roberts_page){120.0, 160.0, 10.0};
    give(&g, &wide, 1, normal_of(1.0));
    strokes s = strokes_of(&g.drawing, &options);
    for (size_t i = 0; i < s.lines.point_count; i++) {
        assert_in_range(s.lines.point[i].x, 10000, 110000);
        assert_in_range(s.lines.point[i].y, 10000, 150000);
    }
    assert_true(fabs(hatched_mm(&s) * 0.5 / (100.0 * 140.0) - 1.0) < 0.01);
    strokes_free(&s);
}

/* How many strokes of hatching have at least this length. */
static size_t count_from(const strokes *s, double least_mm)
{
    const int c = place_of_class(LINE_HATCH);
    size_t count = 0;
    for (size_t i = s->start[c]; i < s->start[c + 1]; i++)
        count += length_mm(s, i) >= least_mm;
    return count;
}

/* A triangle has strokes of all lengths. */
static void short_strokes_are_left_out(void **state)
{
    given_region g;
    const ring triangle = {3, {{0, 0}, {100, 0}, {40, 90}}};
    roberts_draw_options options = options_for(1.0, 20.0);
    (void)state;
    give(&g, &triangle, 1, normal_of(1.0));
    for (int ordered = 0; ordered < 2; ordered++) {
        options.order = ordered ? ROBERTS_ORDER_TRAVEL : ROBERTS_ORDER_NONE;
        options.hatching.shortest_mm = 0.0;
        strokes all = strokes_of(&g.drawing, &options);
        options.hatching.shortest_mm = 12.5;
        strokes some = strokes_of(&g.drawing, &options);
        assert_true(count_from(&some, 0.0) == count_from(&some, 12.5));
        assert_true(count_from(&some, 0.0) == count_from(&all, 12.5));
        assert_true(count_from(&some, 0.0) > 0 && count_from(&some, 0.0) < count_from(&all, 0.0));
        strokes_free(&all);
        strokes_free(&some);
    }
}

static bool holds(const char *bytes, size_t size, const char *text)
{
    const size_t length = strlen(text);
    for (size_t i = 0; i + length <= size; i++)
        if (memcmp(bytes + i, text, length) == 0)
            return true;
    return false;
}

/* Every page format has the strokes, in single drawings and on sheets. If a format has layers, styles or pens, the
 * strokes have one of their own. */
static void all_formats_have_strokes(void **state)
{
    static const struct {
        roberts_format format;
        const char *named;
    } formats[] = {{ROBERTS_SVG, "<g id=\"hatch\""},
                   {ROBERTS_PDF, ""},
                   {ROBERTS_PS, ""},
                   {ROBERTS_EPS, ""},
                   {ROBERTS_PNG, ""},
                   {ROBERTS_TIKZ, "\\begin{scope}[every path/.style={roberts hatch}]"},
                   {ROBERTS_DXF, "LINE\n8\nHATCH\n"},
                   {ROBERTS_HPGL, "SP9;"}};
    roberts_scene *scene = scene_of_file("models/platonic/cube.off");
    roberts_region_list regions[2];
    roberts_drawing drawing[2];
    (void)state;
    for (int i = 0; i < 2; i++) {
        roberts_camera camera;
        assert_true(
            roberts_sheet_camera(ROBERTS_FIRST_ANGLE, i == 0 ? ROBERTS_SHEET_FRONT : ROBERTS_SHEET_ISO, &camera));
        drawing[i] = draw_regions(scene, &camera, 1, &regions[i]);
    }
    const roberts_sheet sheet = {.view = {[ROBERTS_SHEET_FRONT] = &drawing[0], [ROBERTS_SHEET_ISO] = &drawing[1]}};
    for (size_t f = 0; f < sizeof formats / sizeof formats[0]; f++)
        for (int k = 0; k < 2; k++) {
            size_t size[2];
            for (int on = 0; on < 2; on++) {
                roberts_draw_options options = roberts_draw_options_default();
                options.format = formats[f].format;
                options.hatching.on = on == 1;
                sink to = k == 0 ? drawing_written(&drawing[1], &options) : sheet_written(&sheet, &options);
                size[on] = to.size;
                if (formats[f].named[0] && holds(to.bytes, to.size, formats[f].named) != (on == 1))
                    fail_msg("%s: %s", formats[f].named, on ? "is not there" : "is there without hatching");
                free(to.bytes);
            }
            assert_true(size[1] > size[0]);
        }
    for (int i = 0; i < 2; i++) {
        roberts_drawing_free(&drawing[i]);
        roberts_regions_free(&regions[i]);
    }
    roberts_scene_free(scene);
}

static void odd_arguments(void **state)
{
    given_region g;
    sink to = {0};
    const ring square = {4, {{0, 0}, {100, 0}, {100, 100}, {0, 100}}};
    roberts_draw_options options = options_for(0.001, 0.0);
    (void)state;
    give(&g, &square, 1, normal_of(1.0));
    assert_int_equal(roberts_drawing_write(&g.drawing, &options, sink_write, &to, NULL), ROBERTS_BAD_ARGUMENT);
    options.hatching.spacing_mm = NAN;
    assert_int_equal(roberts_drawing_write(&g.drawing, &options, sink_write, &to, NULL), ROBERTS_BAD_ARGUMENT);
    options.hatching.spacing_mm = 1.0;
    options.hatching.cross = 1.5;
    assert_int_equal(roberts_drawing_write(&g.drawing, &options, sink_write, &to, NULL), ROBERTS_BAD_ARGUMENT);
    options.hatching.cross = 0.5;
    options.hatching.shortest_mm = -1.0;
    assert_int_equal(roberts_drawing_write(&g.drawing, &options, sink_write, &to, NULL), ROBERTS_BAD_ARGUMENT);
    options.hatching.shortest_mm = 0.0;
    g.drawing.regions = NULL;
    assert_int_equal(roberts_drawing_write(&g.drawing, &options, sink_write, &to, NULL), ROBERTS_BAD_ARGUMENT);
    g.drawing.regions = &g.list;
    g.slope.steep = g.slope.level = (roberts_vec2){0.0, 0.0}; /* seen from the edge: level strokes */
    g.slope.foot = (roberts_vec2){1e300, -1e300};
    options.hatching.along = ROBERTS_HATCH_STEEP;
    assert_int_equal(roberts_drawing_write(&g.drawing, &options, sink_write, &to, NULL), ROBERTS_OK);
    g.list.slope = NULL;
    assert_int_equal(roberts_drawing_write(&g.drawing, &options, sink_write, &to, NULL), ROBERTS_BAD_ARGUMENT);
    options.hatching.along = ROBERTS_HATCH_PICTURE;
    assert_int_equal(roberts_drawing_write(&g.drawing, &options, sink_write, &to, NULL), ROBERTS_OK);
    free(to.bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strokes_end_on_rings),
        cmocka_unit_test(length_follows_shade),
        cmocka_unit_test(levels_are_the_nearest),
        cmocka_unit_test(ends_of_the_scale),
        cmocka_unit_test(sections_alone_have_strokes),
        cmocka_unit_test(nested_strokes_stay),
        cmocka_unit_test(strokes_go_on),
        cmocka_unit_test(steep_strokes_are_upright),
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(frames_cut_strokes),
        cmocka_unit_test(odd_arguments),
        cmocka_unit_test(all_formats_have_strokes),
        cmocka_unit_test(short_strokes_are_left_out),
    };
    return cmocka_run_group_tests_name("hatch", tests, NULL, NULL);
}
