/* test_fills.c - fills of faces: colours, regions joined by colour, seams between colours.
 *
 * For each colour, the area of its rings must be exactly that of all its regions, with corners rounded to the page:
 * both are whole numbers. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "build_scene.h"
#include "draw/fills.h"
#include "draw/strokes.h"
#include "testing.h"

/* ---- scenes ---------------------------------------------------------------------------------------------------- */

/* A drawing with its regions. */
typedef struct picture {
    roberts_drawing drawing;
    roberts_region_list regions;
} picture;

static void draw_picture(const roberts_scene *scene, const roberts_camera *camera, picture *p)
{
    p->drawing = drawing_of(scene, camera, NULL);
    assert_int_equal(roberts_regions(scene, camera, NULL, &p->regions, NULL), ROBERTS_OK);
    p->drawing.regions = &p->regions;
}

static void free_picture(picture *p)
{
    roberts_drawing_free(&p->drawing);
    roberts_regions_free(&p->regions);
}

static const roberts_camera from_above = {.dir = {0, 0, 1}, .up = {0, 1, 0}};

/* Four squares in a row, of which the last is red and the first two are of one colour, translucent if `alpha` is less
 * than 1; and one apart without a colour. */
static roberts_scene *make_row(const char *alpha)
{
    char text[600];
    snprintf(
        text, sizeof text,
        "OFF\n14 5 0\n0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n3 0 0\n3 1 0\n4 0 0\n4 1 0\n"
        "6 0 0\n7 0 0\n7 1 0\n6 1 0\n"
        "4 0 2 3 1 0.0 0.5 1.0 %s\n4 2 4 5 3 0.0 0.5 1.0 %s\n4 4 6 7 5 0.0 1.0 0.0 1.0\n4 6 8 9 7 1.0 0.0 0.0 1.0\n"
        "4 10 11 12 13\n",
        alpha, alpha);
    return scene_of_text(text);
}

/* The row with its picture and strokes. */
typedef struct row {
    roberts_scene *scene;
    picture p;
    strokes s;
} row;

static void draw_row(const char *alpha, const roberts_draw_options *options, row *r)
{
    r->scene = make_row(alpha);
    draw_picture(r->scene, &from_above, &r->p);
    assert_int_equal(strokes_make(&r->s, &r->p.drawing, options, NULL), ROBERTS_OK);
}

static void free_row(row *r)
{
    strokes_free(&r->s);
    free_picture(&r->p);
    roberts_scene_free(r->scene);
}

/* ---- areas ----------------------------------------------------------------------------------------------------- */

/* Twice the area of a ring, > 0 if it runs as pieces do. */
static int64_t ring_area(const page_point *p, size_t count)
{
    int64_t sum = 0;
    for (size_t i = 0; i < count; i++) {
        page_point a = p[i], b = p[i + 1 < count ? i + 1 : 0];
        sum += (int64_t)b.x * a.y - (int64_t)a.x * b.y;
    }
    return sum;
}

enum { MOST_COLORS = 300 };

/* Areas by colour. */
typedef struct areas {
    const roberts_draw_options *options;
    fill_color color[MOST_COLORS];
    int64_t area[MOST_COLORS];
    size_t count;
} areas;

static void add_area(areas *a, fill_color color, int64_t area)
{
    size_t i = 0;
    while (i < a->count && memcmp(&a->color[i], &color, sizeof color) != 0)
        i++;
    if (i == a->count) {
        assert_true(a->count < MOST_COLORS);
        a->color[a->count++] = color;
        a->area[i] = 0;
    }
    a->area[i] += area;
}

static bool add_region(void *context, const page_region *region)
{
    areas *a = context;
    page_point corner[2000];
    const fill_color color = fills_color(a->options, region->region);
    for (size_t r = 0; r < region->ring_count && color.alpha > 0; r++) {
        size_t first = region->ring_start[r], count = region->ring_start[r + 1] - first;
        assert_true(count <= sizeof corner / sizeof *corner);
        for (size_t k = 0; k < count; k++)
            corner[k] = (page_point){page_round(region->point[first + k].x), page_round(region->point[first + k].y)};
        add_area(a, color, ring_area(corner, count));
    }
    return true;
}

/* Checks the fills of a page. Returns how many rings they have. */
static size_t check_fills(const char *name, const strokes *s)
{
    areas all = {.options = s->options};
    size_t rings = 0;
    bool areas_began = false;
    assert_true(page_regions_walk(s, add_region, &all));
    for (size_t i = 0; i < s->fills.count; i++) {
        const fill_paint *paint = &s->fills.paint[i];
        assert_true(paint->first < paint->end && (paint->seam ? !areas_began : true));
        areas_began = !paint->seam;
        for (size_t k = paint->first; k < paint->end; k++) {
            const polyline *line = &s->fills.lines.item[k];
            assert_int_equal(line->closed, !paint->seam);
            assert_true(line->count >= (paint->seam ? 2 : 3));
            if (paint->seam)
                continue;
            add_area(&all, paint->color, -ring_area(s->fills.lines.point + line->first, line->count));
            rings++;
        }
    }
    for (size_t i = 0; i < all.count; i++)
        if (all.area[i] != 0)
            fail_msg("%s: the rings of a colour have %lld less area than its regions", name, (long long)all.area[i]);
    return rings;
}

static size_t count_paints(const fills *f, bool seams)
{
    size_t count = 0;
    for (size_t i = 0; i < f->count; i++)
        count += f->paint[i].seam == seams;
    return count;
}

/* ---- tests ----------------------------------------------------------------------------------------------------- */

/* Which regions are joined, and which have seams. */
static void test_row(void **state)
{
    static const struct {
        const char *alpha;
        roberts_fill fill;
        size_t rings, paints, seams;
    } cases[] = {
        {"1.0", ROBERTS_FILL_NONE, 0, 0, 0},  {"1.0", ROBERTS_FILL_COLOR, 2, 1, 0},
        {"1.0", ROBERTS_FILL_MODEL, 3, 3, 2}, {"0.5", ROBERTS_FILL_MODEL, 3, 3, 1},
        {"1.0", ROBERTS_FILL_BODY, 2, 2, 0},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_draw_options options = roberts_draw_options_default();
        row r;
        options.fill = cases[i].fill;
        draw_row(cases[i].alpha, &options, &r);
        assert_int_equal(r.p.regions.count, 5);
        assert_int_equal(check_fills("row", &r.s), cases[i].rings);
        assert_int_equal(count_paints(&r.s.fills, false), cases[i].paints);
        assert_int_equal(count_paints(&r.s.fills, true), cases[i].seams);
        free_row(&r);
    }
}

/* Where each region is an element, there are seams between regions of one colour, too; but not if it is translucent. */
static void test_elements(void **state)
{
    static const struct {
        const char *alpha;
        roberts_grouping grouping;
        size_t seams;
    } cases[] = {{"1.0", ROBERTS_GROUP_CLASS, 2},
                 {"1.0", ROBERTS_GROUP_BODY, 3},
                 {"1.0", ROBERTS_GROUP_ELEMENT, 3},
                 {"0.5", ROBERTS_GROUP_ELEMENT, 1}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_draw_options options = roberts_draw_options_default();
        row r;
        size_t seams = 0;
        options.fill = ROBERTS_FILL_MODEL;
        options.grouping = cases[i].grouping;
        draw_row(cases[i].alpha, &options, &r);
        assert_int_equal(check_fills("elements", &r.s), 3);
        for (const fill_paint *paint = r.s.fills.paint; paint < r.s.fills.paint + r.s.fills.count; paint++) {
            seams += paint->seam ? paint->end - paint->first : 0;
            assert_int_equal(paint->body == ROBERTS_NONE, cases[i].grouping == ROBERTS_GROUP_CLASS);
        }
        assert_int_equal(seams, cases[i].seams);
        free_row(&r);
    }
}

/* Where letters could not be read on a fill, plates lie below them: black has a contrast of 4.5 on grey of 117. */
static void test_plates(void **state)
{
    static const struct {
        unsigned char fill, text;
        bool plates;
    } cases[] = {{20, 0, true}, {116, 0, true}, {117, 0, false}, {250, 0, false}, {20, 255, false}, {250, 240, false}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_draw_options options = roberts_draw_options_default();
        row r;
        options.fill = ROBERTS_FILL_COLOR;
        options.lettering.labels = ROBERTS_LABEL_FACES;
        options.text.red = options.text.green = options.text.blue = cases[i].text;
        options.fill_color[0] = options.fill_color[1] = options.fill_color[2] = cases[i].fill;
        draw_row("1.0", &options, &r);
        const fills *f = &r.s.fills;
        const fill_paint *last = &f->paint[f->count - 1];
        assert_true(r.s.notes.count >= 3);
        assert_int_equal(f->count - f->plates, cases[i].plates);
        if (cases[i].plates) {
            assert_int_equal(last->end - last->first, r.s.notes.count);
            assert_true(last->color.red == 255 && last->color.alpha == 255 && !last->seam);
            assert_int_equal(f->lines.item[last->first].count, 4);
        }
        free_row(&r);
    }
}

/* Joined squares are one ring of four corners. */
static void test_ring(void **state)
{
    roberts_draw_options options = roberts_draw_options_default();
    row r;
    (void)state;
    options.fill = ROBERTS_FILL_COLOR;
    options.placement.scale = 10;
    draw_row("1.0", &options, &r);
    assert_int_equal(r.s.fills.lines.count, 2);
    assert_int_equal(r.s.fills.lines.item[0].count, 4);
    assert_int_equal(r.s.fills.lines.item[1].count, 4);
    assert_true(ring_area(r.s.fills.lines.point, 4) == 2 * (int64_t)40000 * 10000); /* 40 x 10 mm */
    free_row(&r);
}

/* Colours of the file, of bodies, of an index; light. */
static void test_colors(void **state)
{
    roberts_draw_options options = roberts_draw_options_default();
    roberts_region region = {.solid = 10, .normal = {0, 0, 1}, .color = {4, {1, 0.5F, 0, 0.5F}}};
    (void)state;
    options.fill = ROBERTS_FILL_MODEL;
    fill_color c = fills_color(&options, &region);
    assert_true(c.red == 255 && c.green == 128 && c.blue == 0 && c.alpha == 128);
    fill_color mixed = fills_on_paper(&options, c);
    assert_true(mixed.red == 255 && mixed.green == 191 && mixed.blue == 127 && mixed.alpha == 255);
    options.background = (roberts_background){true, 0, 0, 0};
    mixed = fills_on_paper(&options, c);
    assert_true(mixed.red == 128 && mixed.green == 64 && mixed.blue == 0 && mixed.alpha == 255);
    options.shaded = true;
    options.light = (roberts_vec3){0, 0, 7};
    assert_int_equal(fills_color(&options, &region).red, 255);
    options.light = (roberts_vec3){1, 0, 0};
    assert_int_equal(fills_color(&options, &region).red, 115); /* 0.45 of 255 */
    options.light = (roberts_vec3){3, 0, 4};
    assert_int_equal(fills_color(&options, &region).red, 227); /* 0.45 + 0.55 * 0.8 */
    region.color = (roberts_color){0};
    assert_int_equal(fills_color(&options, &region).red, 209);
    options.shaded = false;
    assert_int_equal(fills_color(&options, &region).alpha, 0);
    options.fill = ROBERTS_FILL_BODY;
    c = fills_color(&options, &region);
    region.solid = 1;
    fill_color same = fills_color(&options, &region);
    region.solid = 2;
    fill_color other = fills_color(&options, &region);
    assert_memory_equal(&c, &same, sizeof c);
    assert_memory_not_equal(&c, &other, sizeof c);
    options.fill = ROBERTS_FILL_MODEL;
    region.color = (roberts_color){1, {1}};
    c = fills_color(&options, &region);
    assert_memory_equal(&c, &same, sizeof c);
}

/* The mean of the corners' colours, unless the face has its own, or a corner has none. */
static void test_corner_colors(void **state)
{
    roberts_scene *scene =
        scene_of_text("COFF\n4 2 0\n0 0 0 1.0 0.0 0.0 1.0\n1 0 0 0.0 1.0 0.0 1.0\n1 1 0 0.0 0.0 1.0 1.0\n"
                      "0 1 0 0.0 0.0 0.0 0.0\n3 0 1 2\n3 0 2 3 0.0 0.25 0.0\n");
    picture p;
    (void)state;
    draw_picture(scene, &from_above, &p);
    assert_int_equal(p.regions.count, 2);
    const roberts_color *mean = &p.regions.region[0].color, *own = &p.regions.region[1].color;
    assert_int_equal(mean->count, 4);
    for (int i = 0; i < 3; i++)
        assert_true(fabs((double)mean->value[i] - 1.0 / 3.0) < 1e-7);
    assert_true(mean->value[3] == 1.0F);
    assert_true(own->count == 3 && own->value[1] == 0.25F);
    free_picture(&p);
    roberts_scene_free(scene);
}

/* Normals point to the viewer, in the viewer's axes: a cube seen along a diagonal, and a triangle from behind. */
static void test_normals(void **state)
{
    static const roberts_camera along = {.dir = {1, 1, 1}};
    roberts_scene *scene =
        scene_of_text("OFF\n11 7 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
                      "9 9 9\n9 8 9\n8 9 9\n"
                      "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n3 8 9 10\n");
    picture p;
    (void)state;
    draw_picture(scene, &along, &p);
    assert_int_equal(p.regions.count, 4);
    double x = 0, y = 0;
    for (size_t i = 0; i < 4; i++) {
        const roberts_vec3 n = p.regions.region[i].normal;
        assert_true(fabs(vec3_length(n) - 1) < 1e-12 && fabs(n.z - 1 / sqrt(3)) < 1e-12);
        x += i < 3 ? n.x : 0;
        y += i < 3 ? n.y : 0;
        if (p.regions.region[i].face == 1 || p.regions.region[i].face == 6) /* level faces */
            assert_true(fabs(n.x) < 1e-12 && n.y > 0.8);
    }
    assert_true(fabs(x) < 1e-12 && fabs(y) < 1e-12);
    free_picture(&p);
    roberts_scene_free(scene);
}

static void check_model(const char *model, const roberts_camera *camera, size_t *rings, size_t *seams)
{
    char path[100];
    picture p;
    strokes s;
    snprintf(path, sizeof path, "models/%s.off", model);
    roberts_scene *scene = scene_of_file(path);
    draw_picture(scene, camera, &p);
    for (int fill = ROBERTS_FILL_COLOR; fill <= ROBERTS_FILL_BODY; fill++) {
        roberts_draw_options options = roberts_draw_options_default();
        options.fill = (roberts_fill)fill;
        options.shaded = fill != ROBERTS_FILL_BODY;
        assert_int_equal(strokes_make(&s, &p.drawing, &options, NULL), ROBERTS_OK);
        *rings += check_fills(model, &s);
        *seams += count_paints(&s.fills, true);
        for (size_t i = 0; i < s.fills.lines.point_count; i++) { /* nothing leaves the page */
            page_point at = s.fills.lines.point[i];
            assert_true(at.x >= 9999 && at.x <= 200001 && at.y >= 9999 && at.y <= 287001);
        }
        strokes_free(&s);
    }
    free_picture(&p);
    roberts_scene_free(scene);
}

/* Models, also in perspective, cut off at the frame, and cut by the near plane. */
static void test_models(void **state)
{
    static const char *const models[] = {"city",          "compound-of-five-tetrahedra",
                                         "crystals",      "temple",
                                         "menger-sponge", "stacked-blocks",
                                         "chair",         "shapes/torus",
                                         "shapes/screw",  "shapes/moebius-strip",
                                         "shapes/terrain"};
    size_t rings = 0, seams = 0;
    (void)state;
    for (size_t i = 0; i < sizeof models / sizeof models[0]; i++) {
        roberts_camera camera = {.dir = {1, -1, 1}};
        check_model(models[i], &camera, &rings, &seams);
        check_model(models[i], &(roberts_camera){.dir = {0.3, -1, 0.2}}, &rings, &seams);
    }
    check_model("temple",
                &(roberts_camera){
                    .projection = ROBERTS_PERSPECTIVE, .eye = {150, -120, 90}, .fov_degrees = 20, .near_distance = 80},
                &rings, &seams);
    check_model(
        "shapes/torus",
        &(roberts_camera){.projection = ROBERTS_PERSPECTIVE, .eye = {9, -9, 6}, .fov_degrees = 15, .near_distance = 12},
        &rings, &seams);
    print_message("note: %zu rings, %zu colours with seams\n", rings, seams);
    assert_true(rings > 2000 && seams > 200);
}

/* Of the lines of the row, which is 7 wide, one is left: the page has room for it alone, or for fills or hatching, too.
 * A pen that is off changes nothing. */
static void test_room(void **state)
{
    static const roberts_vec2 corner = {3.5, 0.5};
    static const struct {
        roberts_fill fill;
        bool hatched, off, room;
    } table[] = {{ROBERTS_FILL_NONE, false, false, false},
                 {ROBERTS_FILL_MODEL, false, false, true},
                 {ROBERTS_FILL_NONE, true, false, true},
                 {ROBERTS_FILL_NONE, true, true, true}};
    (void)state;
    roberts_scene *scene = make_row("1.0");
    picture p;
    draw_picture(scene, &from_above, &p);
    p.drawing.count = 1;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_draw_options options = roberts_draw_options_default();
        strokes s;
        options.fill = table[i].fill;
        options.hatching.on = table[i].hatched;
        options.hatch.off = table[i].off;
        assert_int_equal(strokes_make(&s, &p.drawing, &options, NULL), ROBERTS_OK);
        assert_true((page_place(&s.map, corner).x <= options.page.width_mm) == table[i].room);
        strokes_free(&s);
    }
    free_picture(&p);
    roberts_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_row),     cmocka_unit_test(test_elements), cmocka_unit_test(test_plates),
        cmocka_unit_test(test_ring),    cmocka_unit_test(test_colors),   cmocka_unit_test(test_corner_colors),
        cmocka_unit_test(test_normals), cmocka_unit_test(test_models),   cmocka_unit_test(test_room)};
    return cmocka_run_group_tests_name("fills", tests, NULL, NULL);
}
