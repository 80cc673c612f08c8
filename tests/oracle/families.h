/* families.h - families of scenes on which the program is held against the oracle: what random position finds, and what it
 * never finds (contact, borders, corners, edges seen end-on). A family and a seed are one scene, on every machine. */
#ifndef ROBERTS_TESTS_FAMILIES_H
#define ROBERTS_TESTS_FAMILIES_H

#include "oracle.h"

typedef struct test_scene {
    roberts_mesh mesh;
    oracle_view view;
    roberts_vec3 look_at; /* where there is a near plane: a point on the line from the eye through view.near */
    bool oblique;         /* the program is asked for an oblique view from the front; view.y is -1 */
    double slack;         /* model units; 0: judged strictly, else oracle_options.slack */
    bool
        rough; /* faces or solids are not quite planar and convex: the scene itself is no better known than to `slack` */
    double tolerance;       /* roberts_scene_options.tolerance; 0: the default */
    uint32_t grid, threads; /* what the program is asked to use: it must not matter */
    /* What the program is given instead of `mesh`: the same faces, no two of which share a vertex. Where it welds them they
     * come to the vertices of `mesh`. Or each solid's points as an input, of which it has to take the hull. */
    bool has_soup, hull;
    roberts_mesh soup;
    /* Where rounding has spoiled contacts: the scene before that, whose drawing it must still be. */
    bool has_original;
    roberts_mesh original;
    oracle_view original_view;
} test_scene;

size_t scene_family_count(void);
const char *scene_family_name(size_t index);

/* Makes the scene `seed` of a family; false: no family of that name, or no memory. A name that ends in "@eye" is that
 * family in perspective, in "@near" from an eye amid the scene, in "@oblique" in an oblique view, in "@soup" given as
 * triangles one by one, as text, in "@points" without its faces. Release with test_scene_free(). */
bool scene_make(const char *family, uint64_t seed, test_scene *scene);
void test_scene_free(test_scene *scene);

#endif
