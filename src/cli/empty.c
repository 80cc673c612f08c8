/* empty.c - drawings that show nothing, and why. */
#include "cli/empty.h"

#include <math.h>

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
static bool is_in_window(const roberts_drawing *d, const roberts_segment *s)
{
    double t0 = 0.0, t1 = 1.0;
    return clip(s->p0.x, s->p1.x, d->window_min.x, &t0, &t1) && clip(-s->p0.x, -s->p1.x, -d->window_max.x, &t0, &t1) &&
           clip(s->p0.y, s->p1.y, d->window_min.y, &t0, &t1) && clip(-s->p0.y, -s->p1.y, -d->window_max.y, &t0, &t1);
}

static const roberts_pen *pen_of(const cli_options *options, const roberts_segment *s)
{
    const roberts_draw_options *draw = &options->draw;
    if (s->state == ROBERTS_HIDDEN)
        return &draw->back;
    return s->line == ROBERTS_CREASE ? &draw->crease : &draw->outline;
}

const char *empty_reason(const cli_options *options, const roberts_drawing *drawing, size_t views)
{
    const bool page = options->draw.format != ROBERTS_CSV && options->draw.format != ROBERTS_JSON;
    bool any_seen = false, any_inside = false, too_far = true;
    for (const roberts_drawing *d = drawing; d < drawing + views; d++) {
        too_far = too_far && d->epsilon >= d->scene_diameter;
        for (size_t i = 0; i < d->count; i++) {
            const roberts_segment *s = &d->segment[i];
            if (s->state == ROBERTS_CLIPPED)
                continue;
            any_seen = true;
            if (d->framed && page && !is_in_window(d, s))
                continue;
            any_inside = true;
            if (!page || !pen_of(options, s)->off)
                return NULL;
        }
    }
    if (any_inside)
        return "--style has turned off all lines that would be seen";
    if (any_seen)
        return "no line of the scene lies in the field of view; --look-at turns the eye (default: to the middle of the "
               "scene), --fov makes the field wider";
    if (too_far)
        return "the scene is smaller than what counts as touching from so far; bring --eye nearer, or set --epsilon";
    return "no line of the scene is seen from there; --eye, --look-at and --near say what is in front of the eye";
}
