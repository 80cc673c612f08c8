/* fuzz_pipeline.c - from any bytes to a drawing. The first FUZZ_SETTINGS bytes choose camera, options and format; the
 * rest is read as a file. Where the file is a scene that can be seen, the parts of each edge must follow one another
 * within the edge, the drawing must be finite, not depend on the grid, and be written; so must the visible
 * regions be finite, closed and independent of the grid. */
#include <math.h>

#include "fuzz.h"
#include "model/scene.h"
#include "roberts.h"
#include "segments.h"

/* No drawing of the sizes tried here is larger, bytes: what is larger is written without an end. */
#define DRAWING_MAX ((size_t)1 << 26)

enum settings { KIND, A, B, C, D, E, GRID, FLAGS, CREASE, TOLERANCE, NEAR, FOV };

static double fraction(uint8_t byte)
{
    return (int8_t)byte / 16.0;
}

/* The eye and the oblique shift are chosen in sizes of the scene, so that few bytes reach all that matters. */
static roberts_camera choose_camera(const uint8_t *set, const roberts_scene *scene)
{
    static const char *const presets[] = {"iso",  "dimetric", "trimetric", "front",   "back",     "right",
                                          "left", "top",      "bottom",    "cabinet", "cavalier", "front"};
    roberts_vec3 from = {fraction(set[A]), fraction(set[B]), fraction(set[C])};
    roberts_vec3 c = scene->centre, h = vec3_sub(scene->box_max, scene->box_min);
    double size = fmax(fmax(h.x, h.y), h.z);
    roberts_camera camera = {.dir = from, .up = {0, fraction(set[D]), 1}};
    switch (set[KIND] % 4) {
    case 0:
        FUZZ_REQUIRE(roberts_camera_preset(presets[set[A] % 12], &camera));
        break;
    case 1:
        break;
    case 2:
        camera.oblique = (roberts_vec2){fraction(set[D]), fraction(set[E])};
        break;
    default:
        camera.projection = ROBERTS_PERSPECTIVE;
        camera.eye = (roberts_vec3){c.x + from.x * size, c.y + from.y * size, c.z + from.z * size};
        camera.has_look_at = set[KIND] & 4;
        camera.look_at = (roberts_vec3){c.x + fraction(set[D]) * size, c.y, c.z + fraction(set[E]) * size};
        camera.near_distance = set[NEAR] / 64.0 * size;
        camera.fov_degrees = set[FOV] % 180;
    }
    camera.has_section = set[KIND] & 8;
    camera.section = (roberts_vec3){c.x + fraction(set[NEAR]) * size, c.y + fraction(set[FOV]) * size, c.z};
    return camera;
}

static roberts_hide_options choose_hiding(const uint8_t *set)
{
    roberts_hide_options hide = roberts_hide_options_default();
    hide.keep_hidden = hide.levels = set[FLAGS] & 1;
    hide.all_edges = set[FLAGS] & 2;
    hide.crease_degrees = set[CREASE] % 181;
    hide.grid = set[GRID] % 33;
    hide.unite = set[KIND] & 16;
    hide.threads = 1;
    return hide;
}

static roberts_draw_options choose_format(const uint8_t *set)
{
    static const roberts_format formats[] = {ROBERTS_SVG, ROBERTS_SVG, ROBERTS_CSV, ROBERTS_JSON};
    roberts_draw_options draw = roberts_draw_options_default();
    draw.format = formats[set[FLAGS] >> 2 & 3];
    draw.hidden = (roberts_hidden)((set[FLAGS] >> 4) % 3);
    return draw;
}

static bool count_bytes(void *context, const void *bytes, size_t size)
{
    size_t *count = context;
    FUZZ_REQUIRE(bytes && size > 0);
    return (*count += size) <= DRAWING_MAX;
}

static void require_sound(const roberts_drawing *drawing)
{
    for (size_t i = 0; i < drawing->count; i++) {
        const roberts_segment *s = &drawing->segment[i];
        FUZZ_REQUIRE(0 <= s->t0 && s->t0 < s->t1 && s->t1 <= 1);
        FUZZ_REQUIRE(scene_crosses(s) || s->v0 < s->v1);
        FUZZ_REQUIRE(isfinite(s->p0.x) && isfinite(s->p0.y) && isfinite(s->p1.x) && isfinite(s->p1.y));
        FUZZ_REQUIRE(i == 0 || !same_edge(s - 1, s) || s[-1].t1 <= s->t0);
    }
}

static void require_same(const roberts_drawing *a, const roberts_drawing *b)
{
    FUZZ_REQUIRE(a->count == b->count);
    for (size_t i = 0; i < a->count; i++) {
        const roberts_segment *s = &a->segment[i], *t = &b->segment[i];
        FUZZ_REQUIRE(same_edge(s, t) && s->t0 == t->t0 && s->t1 == t->t1 && s->state == t->state);
        FUZZ_REQUIRE(s->by == t->by && s->line == t->line);
    }
}

static void require_regions(const roberts_scene *scene, const roberts_camera *camera, roberts_hide_options hide)
{
    roberts_region_list list, other;
    FUZZ_REQUIRE(roberts_regions(scene, camera, &hide, &list, NULL) == ROBERTS_OK);
    hide.grid = hide.grid == 1 ? 7 : 1;
    FUZZ_REQUIRE(roberts_regions(scene, camera, &hide, &other, NULL) == ROBERTS_OK);
    FUZZ_REQUIRE(list.count == other.count && list.corner_count == other.corner_count);
    for (size_t i = 0; i < list.count; i++) {
        const roberts_region *r = &list.region[i];
        FUZZ_REQUIRE(r->face == other.region[i].face && r->ring_count > 0);
        FUZZ_REQUIRE(isfinite(r->area) && isfinite(r->z_min) && r->z_min <= r->z_max && isfinite(r->z_max));
        for (size_t k = r->first_ring; k < r->first_ring + r->ring_count; k++)
            FUZZ_REQUIRE(list.ring_start[k] + 3 <= list.ring_start[k + 1]);
    }
    for (size_t i = 0; i < list.corner_count; i++) {
        FUZZ_REQUIRE(isfinite(list.corner[i].x) && isfinite(list.corner[i].y));
        FUZZ_REQUIRE(list.corner[i].x == other.corner[i].x && list.corner[i].y == other.corner[i].y);
    }
    roberts_regions_free(&list);
    roberts_regions_free(&other);
}

static void look(const uint8_t *set, const roberts_scene *scene)
{
    roberts_camera camera = choose_camera(set, scene);
    roberts_hide_options hide = choose_hiding(set);
    roberts_draw_options draw = choose_format(set);
    roberts_drawing drawing = {0}, other = {0};
    roberts_verification found;
    size_t written = 0;
    roberts_status status = roberts_hide(scene, &camera, &hide, &drawing, NULL);
    FUZZ_REQUIRE(status == ROBERTS_OK || status == ROBERTS_BAD_VIEW || status == ROBERTS_BAD_ARGUMENT);
    if (status == ROBERTS_OK) {
        require_sound(&drawing);
        hide.grid = hide.grid == 1 ? 7 : 1;
        FUZZ_REQUIRE(roberts_hide(scene, &camera, &hide, &other, NULL) == ROBERTS_OK);
        require_same(&drawing, &other);
        FUZZ_REQUIRE(roberts_drawing_write(&drawing, &draw, count_bytes, &written, NULL) == ROBERTS_OK);
        FUZZ_REQUIRE(written > 0);
        FUZZ_REQUIRE(roberts_verify(scene, &camera, &drawing, NULL, &found, NULL) == ROBERTS_OK);
    }
    if (status == ROBERTS_OK)
        require_regions(scene, &camera, choose_hiding(set));
    if (status == ROBERTS_OK) {
        roberts_picked picked;
        roberts_vec2 a = drawing.window_min, b = drawing.window_max;
        FUZZ_REQUIRE(roberts_pick(scene, &camera, (a.x + b.x) / 2, (a.y + b.y) / 2, &picked, NULL) == ROBERTS_OK);
        roberts_picked_free(&picked);
    }
    roberts_drawing_free(&drawing);
    roberts_drawing_free(&other);
}

int fuzz_pipeline(const uint8_t *bytes, size_t size)
{
    roberts_mesh mesh = {0};
    roberts_scene *scene = NULL;
    if (size < FUZZ_SETTINGS)
        return 0;
    /* 0 to 1e-1; 0 is the default */
    roberts_scene_options options = {.tolerance = bytes[TOLERANCE] % 4 ? pow(10, -1 - bytes[TOLERANCE] % 16) : 0,
                                     .hull = bytes[KIND] & 64,
                                     .even_odd = bytes[KIND] & 32,
                                     .rounded = bytes[KIND] & 128};
    if (roberts_mesh_read_memory(&mesh, "bytes", bytes + FUZZ_SETTINGS, size - FUZZ_SETTINGS, NULL, NULL) ==
            ROBERTS_OK &&
        roberts_scene_build(&mesh, &options, &scene, NULL) == ROBERTS_OK)
        look(bytes, scene);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
    return 0;
}
