/* refusal.c - what can be done about a file that could not be read, or a model that has been refused.
 *
 * Whether a larger --tolerance helps, and which, is tried: what is told has had the whole model pass. By how much the first
 * solid failed would not tell, since others may fail by more, and some failures are none of tolerance. */
#include "cli/refusal.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "base/box.h"
#include "model/hull.h"
#include "model/scene.h"

/* 1, 2 or 5 times a power of ten, up to a hundredth of the size, which is what coordinates rounded to two digits may be off.
 * What is farther from convex is of another shape: a drawing of it would be wrong to see, and its hull is at least a solid. */
static const double tolerances[] = {1e-10, 2e-10, 5e-10, 1e-9, 2e-9, 5e-9, 1e-8, 2e-8, 5e-8, 1e-7, 2e-7, 5e-7, 1e-6,
                                    2e-6,  5e-6,  1e-5,  2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2};

enum { TOLERANCES = sizeof tolerances / sizeof tolerances[0] };

/* Of more faces than this no tolerance is tried: a refusal must not take seconds. */
#define FACES_TRIED 200000

/* Of n faces each is about 1 / sqrt(n) of the size wide, and a vertex may lie outside its plane by sqrt(n) tolerances (see
 * convex.c): by no more than this part of the size, which a cube's may at a hundredth. Else the tolerance would pass a
 * surface of many small faces, or a solid far from the origin, whatever its shape. */
static const double OUTSIDE_MOST = 0.025;

/* The size of solid s as a part of its largest coordinate, by which the tolerance counts where it is far from the origin; at
 * most 1. */
static double part_of_coordinates(const roberts_scene *scene, uint32_t s)
{
    const uint32_t first = scene->solid[s].vertex;
    roberts_vec3 low = scene->point[first], high = low;
    box_add_all(&low, &high, scene->point + first, scene->solid[s + 1].vertex - first);
    const double size = fmax(high.x - low.x, fmax(high.y - low.y, high.z - low.z));
    const double largest = fmax(fmax(fmax(high.x, -low.x), fmax(high.y, -low.y)), fmax(high.z, -low.z));
    return size < largest ? size / largest : 1.0;
}

/* The greatest tolerance at which the shape of all solids still tells. */
static double greatest_tolerance(const roberts_scene *scene)
{
    double most = OUTSIDE_MOST;
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        const uint32_t faces = scene->solid[s + 1].face - scene->solid[s].face;
        most = fmin(most, OUTSIDE_MOST / sqrt(faces) * part_of_coordinates(scene, s));
    }
    return most;
}

/* Gives the greatest tolerance that can be told in `most`, where the mesh passes with this one. */
static bool passes(const cli_options *options, const roberts_mesh *mesh, double tolerance, double *most)
{
    roberts_scene_options solids = {.tolerance = tolerance, .threads = options->hide.threads};
    roberts_scene *scene = NULL;
    const bool passed = roberts_scene_build(mesh, &solids, &scene, NULL) == ROBERTS_OK;
    if (passed)
        *most = greatest_tolerance(scene);
    roberts_scene_free(scene);
    return passed;
}

/* The first of the tolerances that passes, by bisection; 0 where none does that can be told. */
static double find_tolerance(const cli_options *options, const roberts_mesh *mesh)
{
    const double tried = options->scene.tolerance > 0.0 ? options->scene.tolerance : SCENE_TOLERANCE;
    size_t fails = 0, does = TOLERANCES - 1;
    double most = 0.0;
    if (mesh->face_count > FACES_TRIED || tolerances[does] <= tried || !passes(options, mesh, tolerances[does], &most))
        return 0.0;
    while (does > 0 && tolerances[does] > most)
        does--;
    if (does < TOLERANCES - 1 && (tolerances[does] <= tried || !passes(options, mesh, tolerances[does], &most)))
        return 0.0;
    while (fails < does) {
        const size_t middle = fails + (does - fails) / 2;
        if (tolerances[middle] > tried && passes(options, mesh, tolerances[middle], &most))
            does = middle;
        else
            fails = middle + 1;
    }
    return tolerances[does];
}

void refusal_explain(const cli_options *options, const roberts_mesh *mesh, roberts_error *error)
{
    const bool shape = error->status == ROBERTS_NOT_PLANAR || error->status == ROBERTS_NOT_CONVEX;
    const size_t used = strlen(error->message), room = sizeof error->message - used;
    if (options->scene.hull || (!shape && error->status != ROBERTS_NOT_CLOSED))
        return;
    const double tolerance = shape ? find_tolerance(options, mesh) : 0.0;
    if (tolerance > 0.0)
        snprintf(error->message + used, room, " (--tolerance %g would do; see also --hull)", tolerance);
    else if (mesh->vertex_count >= HULL_POINTS)
        snprintf(error->message + used, room, " (see --hull)");
}

/* A drawing that is there from an earlier run is taken for a model where -o is forgotten. */
void refusal_explain_reading(const cli_options *options, const char *name, roberts_error *error)
{
    const size_t used = strlen(error->message), room = sizeof error->message - used;
    struct stat found;
    roberts_format format;
    if (strcmp(name, "-") == 0 || stat(name, &found) != 0)
        return;
    if (S_ISDIR(found.st_mode))
        snprintf(error->message, sizeof error->message, "is a folder; name the files in it, as *.off");
    else if (error->status == ROBERTS_BAD_SYNTAX && strcmp(options->output, "-") == 0 &&
             roberts_format_by_path(name, &format))
        snprintf(error->message + used, room, "; to draw into it: -o and its name");
}
