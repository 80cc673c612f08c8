/* rays.c - what --verify and --pick say. */
#include "cli/rays.h"

#include <stdio.h>

#include "cli/message.h"

enum { RAYS_TOLD = 20 };

typedef struct telling {
    FILE *log;
    size_t told;
} telling;

static void tell(void *context, const roberts_contradiction *c)
{
    telling *t = context;
    FILE *log = t->log;
    if (t->told++ >= RAYS_TOLD)
        return;
    message_open(log);
    fprintf(log, "roberts: verify: solid %u, edge %u-%u, t = %.17g: drawn %s, but ", (unsigned)c->solid,
            (unsigned)c->v0, (unsigned)c->v1, c->t, c->drawn == ROBERTS_VISIBLE ? "visible" : "hidden");
    if (c->cast == ROBERTS_HIDDEN)
        fprintf(log, "solid %u hides it\n", (unsigned)c->by);
    else
        fputs("nothing hides it\n", log);
    message_close(log);
}

roberts_status rays_verify(const cli_options *options, const roberts_scene *scene, const roberts_drawing *drawing,
                           bool *wrong, roberts_error *error)
{
    telling t = {.log = options->log};
    roberts_verification found;
    roberts_verify_options verify = roberts_verify_options_default();
    verify.rays = options->verify_rays;
    verify.crease_degrees = options->hide.crease_degrees;
    verify.all_edges = options->hide.all_edges;
    verify.threads = options->hide.threads;
    verify.contradiction = tell;
    verify.context = &t;
    roberts_status status = roberts_verify(scene, &options->camera, drawing, &verify, &found, error);
    *wrong = status == ROBERTS_OK && found.contradictions > 0;
    message_open(options->log);
    if (t.told > RAYS_TOLD)
        fprintf(options->log, "roberts: verify: ... and %zu more\n", t.told - RAYS_TOLD);
    if (status == ROBERTS_OK && (*wrong || !options->quiet))
        fprintf(options->log,
                "roberts: verify: %zu points of %zu segments checked; contradictions: %zu, undecided: %zu\n",
                found.points, found.segments, found.contradictions, found.undecided);
    message_close(options->log);
    return status;
}

static roberts_status pick_one(const cli_options *options, const roberts_scene *scene, roberts_vec2 p,
                               roberts_error *error)
{
    roberts_picked picked;
    roberts_status status = roberts_pick(scene, &options->camera, p.x, p.y, &picked, error);
    message_open(options->log);
    if (status == ROBERTS_OK && picked.count == 0)
        fprintf(options->log, "roberts: pick %.12g,%.12g: nothing is there\n", p.x, p.y);
    for (size_t i = 0; i < picked.count; i++) {
        const roberts_pick_hit *hit = &picked.hit[i];
        fprintf(options->log, "roberts: pick %.12g,%.12g: %ssolid %u, ", p.x, p.y, i ? "behind it " : "",
                (unsigned)hit->solid);
        if (hit->face == ROBERTS_NONE)
            fputs("cut by the near plane, ", options->log);
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
