/* suggest_tolerance.c - the tolerance that would accept a refused model.
 *
 * It is found by trial: the whole model passes with any tolerance that is suggested. The amount by which the first
 * solid failed would not be enough. Others may fail by more, or for reasons that no tolerance cures. */
#include <math.h>

#include "base/box.h"
#include "model/scene.h"

/* Steps of 1, 2 or 5 times a power of ten, up to a hundredth of the size: coordinates rounded to two digits may be off
 * by that much. A model farther from convex has another shape, and its drawing would look wrong; its hull is at least a
 * solid. */
static const double steps[] = {1e-10, 2e-10, 5e-10, 1e-9, 2e-9, 5e-9, 1e-8, 2e-8, 5e-8, 1e-7, 2e-7, 5e-7, 1e-6,
                               2e-6,  5e-6,  1e-5,  2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2};

enum { STEPS = sizeof steps / sizeof steps[0] };

/* A model with more faces is not tried, because a refusal must not take seconds. */
enum { FACES_TRIED = 200000 };

/* In a solid of n faces, each is about 1 / sqrt(n) of the size wide, and a vertex may lie outside its plane by sqrt(n)
 * tolerances (see convex.c). That must not exceed this fraction of the size; a cube reaches it at a hundredth. A larger
 * tolerance would accept any surface of many small faces, or any solid far from the origin. */
static const double OUTSIDE_MOST = 0.025;

/* Returns the size of solid s as a fraction of its largest coordinate, at most 1. If the solid is far from the origin,
 * the tolerance is relative to that coordinate. */
static double part_of_coordinates(const roberts_scene *scene, uint32_t s)
{
    const uint32_t first = scene->solid[s].vertex;
    roberts_vec3 low = scene->point[first], high = low;
    box_add_all(&low, &high, scene->point + first, scene->solid[s + 1].vertex - first);
    const double size = fmax(high.x - low.x, fmax(high.y - low.y, high.z - low.z));
    const double largest = fmax(fmax(fmax(high.x, -low.x), fmax(high.y, -low.y)), fmax(high.z, -low.z));
    return size < largest ? size / largest : 1.0;
}

/* Returns the greatest tolerance with which the shape of all solids still matters. */
static double greatest_tolerance(const roberts_scene *scene)
{
    double most = OUTSIDE_MOST;
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        const uint32_t faces = scene->solid[s + 1].face - scene->solid[s].face;
        most = fmin(most, OUTSIDE_MOST / sqrt(faces) * part_of_coordinates(scene, s));
    }
    return most;
}

/* Does the mesh pass? If so, sets *most to the greatest tolerance that may be suggested. */
static bool passes(const roberts_mesh *mesh, uint32_t threads, double tolerance, double *most)
{
    const roberts_scene_options options = {.solids = true, .tolerance = tolerance, .threads = threads};
    roberts_scene *scene = NULL;
    const bool passed = roberts_scene_build(mesh, &options, &scene, NULL) == ROBERTS_OK;
    if (passed)
        *most = greatest_tolerance(scene);
    roberts_scene_free(scene);
    return passed;
}

/* Rounds down to one digit: 0.0072 to 0.007. */
static double round_down(double x)
{
    const double power = pow(10.0, -floor(log10(x)));
    return floor(x * power) / power;
}

/* Finds the first of the steps up to `most` that passes, by bisection. If none does, returns `most` itself, which
 * passes. */
static double first_step(const roberts_mesh *mesh, uint32_t threads, double tried, double most)
{
    size_t fails = 0, does = 0;
    double ignored;
    while (does < STEPS && steps[does] <= most)
        does++;
    while (fails < does) {
        const size_t middle = fails + (does - fails) / 2;
        if (steps[middle] > tried && passes(mesh, threads, steps[middle], &ignored))
            does = middle;
        else
            fails = middle + 1;
    }
    return does < STEPS && steps[does] <= most ? steps[does] : most;
}

double roberts_scene_tolerance(const roberts_mesh *mesh, const roberts_scene_options *options)
{
    const double tried = options && options->tolerance > 0.0 ? options->tolerance : SCENE_TOLERANCE;
    const uint32_t threads = options ? options->threads : 0;
    double most = steps[STEPS - 1], bound;
    if (mesh->face_count > FACES_TRIED || most <= tried || !passes(mesh, threads, most, &bound))
        return 0.0;
    if (bound < most) {
        most = round_down(bound);
        if (most <= tried || !passes(mesh, threads, most, &bound))
            return 0.0;
    }
    return first_step(mesh, threads, tried, most);
}
