/* trials.h - drawings whose pages are compared with their tables: scenes, and styles in which they are drawn. */
#ifndef ROBERTS_TESTS_TRIALS_H
#define ROBERTS_TESTS_TRIALS_H

#include "check.h"

/* A way to draw a scene. */
typedef enum trial_kind { TRIAL_VIEW, TRIAL_FOV, TRIAL_SHEET } trial_kind;

typedef struct trial_style {
    const char *name;
    trial_kind kind;
    roberts_hidden hidden;
    roberts_order order;
    bool real_dashes, frame;
    roberts_format format; /* beside SVG, which is always checked */
} trial_style;

size_t trial_style_count(void);
const trial_style *trial_style_at(size_t i);

/* A scene and its viewer. */
typedef struct trial_scene {
    char name[400];
    roberts_mesh mesh;
    roberts_camera camera;
    double tolerance; /* as in roberts_scene_options */
    bool hull;
} trial_scene;

/* The families of this folder, followed by those that are compared with the oracle. */
size_t trial_family_count(void);
size_t trial_own_families(void); /* how many are of this folder */
const char *trial_family_name(size_t i);

/* Makes the scene `seed` of a family; false: no memory. */
bool trial_make(size_t family, uint64_t seed, trial_scene *scene);
void trial_free(trial_scene *scene);

typedef enum trial_result { TRIAL_RIGHT, TRIAL_WRONG, TRIAL_REFUSED } trial_result;

/* Draws the scene in a style and checks the result. Faults are described on f->out. TRIAL_REFUSED: the scene, its view
 * or its sheet was refused. */
trial_result trial_run(const trial_scene *scene, const trial_style *style, findings *f);

#endif
