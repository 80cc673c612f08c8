/* sheet_views.h - all views of a model as a sheet, and sizes of pages. */
#ifndef ROBERTS_TESTS_SHEET_VIEWS_H
#define ROBERTS_TESTS_SHEET_VIEWS_H

#include <stdio.h>

#include "build_scene.h"

/* From A4 to A0, mm. */
static const double pages[][2] = {{210, 297}, {420, 297}, {420, 594}, {841, 594}, {841, 1189}, {1189, 841}};

typedef struct views {
    roberts_scene *scene;
    roberts_drawing drawing[ROBERTS_SHEET_VIEWS];
    roberts_sheet sheet;
} views;

/* Draws all views of a scene. free_views() releases what this fills, and the scene. */
static inline void hide_scene_views(views *v, roberts_scene *scene, roberts_sheet_angle angle,
                                    const roberts_hide_options *options)
{
    *v = (views){.scene = scene, .sheet = {.angle = angle}};
    for (int i = 0; i < ROBERTS_SHEET_VIEWS; i++) {
        roberts_camera camera;
        assert_true(roberts_sheet_camera(angle, i, &camera));
        v->drawing[i] = drawing_of(scene, &camera, options);
        v->sheet.view[i] = &v->drawing[i];
    }
}

/* Draws all views of models/MODEL.off. */
static inline void hide_views(views *v, const char *model, roberts_sheet_angle angle)
{
    char path[100];
    snprintf(path, sizeof path, "models/%s.off", model);
    hide_scene_views(v, scene_of_file(path), angle, NULL);
}

static inline void free_views(views *v)
{
    for (int i = 0; i < ROBERTS_SHEET_VIEWS; i++)
        roberts_drawing_free(&v->drawing[i]);
    roberts_scene_free(v->scene);
}

#endif
