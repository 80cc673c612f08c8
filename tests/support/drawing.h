/* drawing.h - hand-made drawings, and sinks for their bytes: for the tests of src/draw/. */
#ifndef ROBERTS_TESTS_DRAWING_H
#define ROBERTS_TESTS_DRAWING_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "roberts.h"

/* Returns a visible segment from (x0, y0) to (x1, y1). */
static inline roberts_segment line_at(roberts_line line, double x0, double y0, double x1, double y1)
{
    return (roberts_segment){.v1 = 1,
                             .by = ROBERTS_NONE,
                             .t1 = 1.0,
                             .p0 = {x0, y0},
                             .p1 = {x1, y1},
                             .state = ROBERTS_VISIBLE,
                             .line = (uint8_t)line};
}

/* Draws models/MODEL.off, seen as the preset `view` or, if that is NULL, in perspective; hidden parts included. */
static inline roberts_drawing model_drawing(const char *model, const char *view)
{
    char path[100];
    roberts_mesh mesh = {0};
    roberts_scene *scene;
    roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE, .eye = {150, -120, 90}};
    roberts_hide_options options = roberts_hide_options_default();
    roberts_drawing drawing;
    options.keep_hidden = true;
    snprintf(path, sizeof path, "models/%s.off", model);
    assert_true(!view || roberts_camera_preset(view, &camera));
    assert_int_equal(roberts_mesh_read_file(&mesh, path, NULL, NULL), ROBERTS_OK);
    assert_int_equal(roberts_scene_build(&mesh, NULL, &scene, NULL), ROBERTS_OK);
    assert_int_equal(roberts_hide(scene, &camera, &options, &drawing, NULL), ROBERTS_OK);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
    return drawing;
}

/* The bytes that a writer has produced. With `room` above 0, it fails with ENOSPC after that many. */
typedef struct sink {
    char *bytes;
    size_t size, room;
} sink;

static inline bool sink_write(void *context, const void *bytes, size_t size)
{
    sink *to = context;
    if (to->room && to->size + size > to->room) {
        errno = ENOSPC;
        return false;
    }
    char *grown = realloc(to->bytes, to->size + size + 1);
    if (!grown)
        return false;
    to->bytes = grown;
    memcpy(grown + to->size, bytes, size);
    to->size += size;
    grown[to->size] = '\0';
    return true;
}

#endif
