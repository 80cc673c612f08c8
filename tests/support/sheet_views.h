/* sheet_views.h - all views of a model as a sheet, and sizes of pages. Include it after the headers of cmocka. */
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

/* Draws models/MODEL.off. free_views() releases what it fills. */
static inline void hide_views(views *v, const char *model, roberts_sheet_angle angle)
{
    roberts_mesh mesh = {0};
    char path[100];
    snprintf(path, sizeof path, "models/%s.off", model);
    *v = (views){.sheet = {.angle = angle}};
    assert_int_equal(roberts_mesh_read_file(&mesh, path, NULL, NULL), ROBERTS_OK);
    v->scene = build_scene(&mesh);
    for (int i = 0; i < ROBERTS_SHEET_VIEWS; i++) {
        roberts_camera camera;
        assert_true(roberts_sheet_camera(angle, i, &camera));
        assert_int_equal(roberts_hide(v->scene, &camera, NULL, &v->drawing[i], NULL), ROBERTS_OK);
        v->sheet.view[i] = &v->drawing[i];
    }
}

static inline void free_views(views *v)
{
    for (int i = 0; i < ROBERTS_SHEET_VIEWS; i++)
        roberts_drawing_free(&v->drawing[i]);
    roberts_scene_free(v->scene);
}

#endif
