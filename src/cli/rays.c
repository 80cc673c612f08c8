/* rays.c - what --verify and --pick say. */
#include "cli/rays.h"

#include <stdio.h>

#include "cli/message.h"

enum { RAYS_TOLD = 20 };

typedef struct telling {
    const cli_options *options;
    size_t told;
} telling;

static void tell(void *context, const roberts_contradiction *c)
{
    telling *t = context;
    FILE *log = t->options->log;
    if (t->told++ >= RAYS_TOLD)
        return;
    message_open(log);
    message_begin(log, t->options->label);
    fprintf(log, "verify: solid %u, edge %u-%u, t = %.17g: drawn %s, but ", (unsigned)c->solid, (unsigned)c->v0,
            (unsigned)c->v1, c->t, c->drawn == ROBERTS_VISIBLE ? "visible" : "hidden");
    if (c->cast == ROBERTS_CLIPPED)
        fputs("the near plane cuts it off\n", log);
    else if (c->cast == ROBERTS_HIDDEN && c->drawn == ROBERTS_HIDDEN)
        fprintf(log, "it is solid %u that hides it, not solid %u\n", (unsigned)c->by, (unsigned)c->drawn_by);
    else if (c->cast == ROBERTS_HIDDEN)
        fprintf(log, "solid %u hides it\n", (unsigned)c->by);
    else
        fputs("nothing hides it\n", log);
    message_close(log);
}

roberts_status rays_verify(const cli_options *options, const roberts_scene *scene, const roberts_drawing *drawing,
                           roberts_verification *sum, roberts_error *error)
{
    telling t = {.options = options};
    FILE *log = options->log;
    roberts_verification found;
    roberts_verify_options verify = roberts_verify_options_default();
    verify.rays = options->verify_rays;
    verify.crease_degrees = options->hide.crease_degrees;
    verify.all_edges = options->hide.all_edges;
    verify.threads = options->hide.threads;
    verify.contradiction = tell;
    verify.context = &t;
    roberts_status status = roberts_verify(scene, &options->camera, drawing, &verify, &found, error);
    if (status == ROBERTS_OK) {
        sum->segments += found.segments;
        sum->points += found.points;
        sum->undecided += found.undecided;
        sum->contradictions += found.contradictions;
    }
    message_open(log);
    if (t.told > RAYS_TOLD) {
        message_begin(log, options->label);
        fprintf(log, "verify: ... and %zu more\n", t.told - RAYS_TOLD);
    }
    if (status == ROBERTS_OK && (found.contradictions > 0 || !options->quiet)) {
        message_begin(log, options->label);
        fprintf(log,
                "verify: %zu points of %zu segments checked, visible and hidden ones; contradictions: %zu, undecided: "
                "%zu\n",
                found.points, found.segments, found.contradictions, found.undecided);
    }
    message_close(log);
    return status;
}

/* Somebody who misses the whole picture may have taken it for millimetres of the page. */
static void tell_nothing(const cli_options *options, const roberts_scene *scene, roberts_vec2 p)
{
    roberts_vec2 low, high;
    bool framed, known = roberts_window(scene, &options->camera, &low, &high, &framed, NULL) == ROBERTS_OK;
    if (known && framed)
        roberts_page_shape(&options->draw.page, &low, &high);
    message_begin(options->log, options->label);
    fprintf(options->log, "pick %.12g,%.12g: nothing is there", p.x, p.y);
    if (known && (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y))
        fprintf(options->log, "; the picture reaches from %.6g,%.6g to %.6g,%.6g", low.x, low.y, high.x, high.y);
    fputs("\n", options->log);
}

/* A face that the input does not have. */
static const char *name_unnumbered(const cli_options *options)
{
    if (!options->scene.hull)
        return "cut by the near plane";
    return options->camera.projection == ROBERTS_PERSPECTIVE ? "a face of its hull, or cut by the near plane"
                                                             : "a face of its hull";
}

static roberts_status pick_one(const cli_options *options, const roberts_scene *scene, roberts_vec2 p,
                               roberts_error *error)
{
    roberts_picked picked;
    roberts_status status = roberts_pick(scene, &options->camera, p.x, p.y, &picked, error);
    message_open(options->log);
    if (status == ROBERTS_OK && picked.count == 0)
        tell_nothing(options, scene, p);
    for (size_t i = 0; i < picked.count; i++) {
        const roberts_pick_hit *hit = &picked.hit[i];
        message_begin(options->log, options->label);
        fprintf(options->log, "pick %.12g,%.12g: %ssolid %u, ", p.x, p.y, i ? "behind it " : "", (unsigned)hit->solid);
        if (hit->face == ROBERTS_NONE)
            fprintf(options->log, "%s, ", name_unnumbered(options));
        else
            fprintf(options->log, "face %u, ", (unsigned)hit->face);
        fprintf(options->log, "depth %.12g, at %.12g,%.12g,%.12g\n", hit->depth, hit->point.x, hit->point.y,
                hit->point.z);
    }
    message_close(options->log);
    roberts_picked_free(&picked);
    return status;
}

roberts_status rays_pick(const cli_options *options, const roberts_scene *scene, roberts_error *error)
{
    roberts_status status = ROBERTS_OK;
    for (size_t i = 0; i < options->pick_count && status == ROBERTS_OK; i++)
        status = pick_one(options, scene, options->pick[i], error);
    return status;
}
