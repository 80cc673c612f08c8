/* families.h - families of scenes for comparing the program with the oracle. They include what random positions
 * produce, and what they never produce (contact, borders, corners, edges seen end-on). A family and a seed give the
 * same scene on every machine. */
#ifndef ROBERTS_TESTS_FAMILIES_H
#define ROBERTS_TESTS_FAMILIES_H

#include "oracle.h"

typedef struct test_scene {
    roberts_mesh mesh;
    oracle_view view;
    roberts_vec3 look_at;   /* with a near plane: a point on the line from the eye through view.near */
    bool oblique;           /* the program draws an oblique view from the front; view.y is -1 */
    double slack;           /* model units; 0: judged strictly, otherwise oracle_options.slack */
    bool rough;             /* faces or solids are not quite planar and convex, so the scene is known only to `slack` */
    double tolerance;       /* roberts_scene_options.tolerance; 0: the default */
    uint32_t grid, threads; /* options for the program that must not change the result */
    /* Input given to the program instead of `mesh`. has_soup: the same faces, no two of which share a vertex; after
     * welding, the vertices are those of `mesh`. hull: each solid's points as an input, of which it takes the hull. */
    bool has_soup, hull;
    roberts_mesh soup;
    /* If rounding has spoiled contacts: the scene before rounding. The drawing must still match it. */
    bool has_original;
    roberts_mesh original;
    oracle_view original_view;
} test_scene;

size_t scene_family_count(void);
const char *scene_family_name(size_t index);

/* Makes scene `seed` of a family; false: unknown family, or no memory. Suffixes of a name: "@eye" is the family in
 * perspective, "@near" seen from an eye amid the scene, "@oblique" in an oblique view, "@soup" given as separate
 * triangles, as text, "@points" without its faces. Release with test_scene_free(). */
bool scene_make(const char *family, uint64_t seed, test_scene *scene);
void test_scene_free(test_scene *scene);

#endif
