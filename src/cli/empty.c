/* empty.c - drawings that show nothing, or next to nothing, and why. */
#include "cli/empty.h"

#include <math.h>
#include <stdio.h>

/* As many as a box has edges. */
enum { FEW_LINES = 12 };

/* Cuts what of [*t0, *t1] lies where a + t (b - a) is low or more; false where nothing is left. */
static bool clip(double a, double b, double low, double *t0, double *t1)
{
    if (a < low && b < low)
        return false;
    if (a < low)
        *t0 = fmax(*t0, (low - a) / (b - a));
    if (b < low)
        *t1 = fmin(*t1, (low - a) / (b - a));
    return *t0 <= *t1;
}

/* Whether a part of the segment lies in the window: Liang and Barsky, "A new concept and method for line clipping", ACM
 * Transactions on Graphics 3(1), 1984. */
static bool is_in_window(roberts_vec2 min, roberts_vec2 max, const roberts_segment *s)
{
    double t0 = 0.0, t1 = 1.0;
    return clip(s->p0.x, s->p1.x, min.x, &t0, &t1) && clip(-s->p0.x, -s->p1.x, -max.x, &t0, &t1) &&
           clip(s->p0.y, s->p1.y, min.y, &t0, &t1) && clip(-s->p0.y, -s->p1.y, -max.y, &t0, &t1);
}

static const roberts_pen *pen_of(const cli_options *options, const roberts_segment *s)
{
    const roberts_draw_options *draw = &options->draw;
    if (s->state == ROBERTS_HIDDEN)
        return &draw->back;
    return s->line == ROBERTS_CREASE ? &draw->crease : &draw->outline;
}

/* What is seen of the scene, on the page where there is one. */
typedef struct glance {
    bool any_seen, any_inside; /* by the eye; in the field of view */
    size_t drawn;
} glance;

/* Looks at segments until `enough` of them are known to be drawn. */
static glance look(const cli_options *options, const roberts_drawing *drawing, size_t views, size_t enough)
{
    const bool page = options->draw.format != ROBERTS_CSV && options->draw.format != ROBERTS_JSON;
    glance g = {0};
    for (const roberts_drawing *d = drawing; d < drawing + views; d++) {
        roberts_vec2 min = d->window_min, max = d->window_max;
        roberts_page_shape(&options->draw.page, &min, &max);
        for (size_t i = 0; i < d->count && g.drawn < enough; i++) {
            const roberts_segment *s = &d->segment[i];
            if (s->state == ROBERTS_CLIPPED)
                continue;
            g.any_seen = true;
            if (d->framed && page && !is_in_window(min, max, s))
                continue;
            g.any_inside = true;
            g.drawn += !page || !pen_of(options, s)->off;
        }
    }
    return g;
}

/* The nearest face that the input does not have is where the near plane cuts, unless hulls have others. To ask takes as long
 * as the view, so that it is asked only where hardly anything is drawn; and one who has set --near has meant a cut that shows
 * something. */
bool empty_by_near(const cli_options *options, const roberts_scene *scene, const roberts_drawing *drawing, char *why,
                   size_t size)
{
    const size_t few = options->camera.near_distance > 0.0 ? 1 : FEW_LINES;
    roberts_picked picked;
    if (options->camera.projection != ROBERTS_PERSPECTIVE || options->scene.hull || !drawing->framed ||
        look(options, drawing, 1, few).drawn >= few ||
        roberts_pick(scene, &options->camera, 0.0, 0.0, &picked, NULL) != ROBERTS_OK)
        return false;
    const bool cut = picked.count > 0 && picked.hit[0].face == ROBERTS_NONE;
    if (cut) {
        const roberts_vec3 eye = options->camera.eye, p = picked.hit[0].point;
        snprintf(why, size,
                 "the near plane, %.3g before the eye, cuts solid %u in the middle of the picture, so that nothing is "
                 "seen there: move --eye away from it, or make --near less",
                 hypot(hypot(p.x - eye.x, p.y - eye.y), p.z - eye.z), (unsigned)picked.hit[0].solid);
    }
    roberts_picked_free(&picked);
    return cut;
}

const char *empty_reason(const cli_options *options, const roberts_drawing *drawing, size_t views)
{
    const glance g = look(options, drawing, views, 1);
    bool too_far = true;
    for (const roberts_drawing *d = drawing; d < drawing + views; d++)
        too_far = too_far && d->epsilon >= d->scene_diameter;
    if (g.drawn > 0)
        return NULL;
    if (g.any_inside)
        return "--style has turned off all lines that would be seen";
    if (g.any_seen)
        return "no line of the scene lies in the field of view; --look-at turns the eye (default: to the middle of the "
               "scene), --fov makes the field wider";
    if (too_far)
        return "the scene is smaller than what counts as touching from so far; bring --eye nearer, or set --epsilon";
    return "no line of the scene is seen from there; --eye, --look-at and --near say what is in front of the eye";
}
