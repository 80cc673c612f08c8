/* drawing.h - hand-made drawings, and sinks for their bytes: for the tests of src/draw/. */
#ifndef ROBERTS_TESTS_DRAWING_H
#define ROBERTS_TESTS_DRAWING_H

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "build_scene.h"

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
    const roberts_camera eye = {.projection = ROBERTS_PERSPECTIVE, .eye = {150, -120, 90}};
    roberts_camera camera = view ? preset_camera(view) : eye;
    roberts_hide_options options = roberts_hide_options_default();
    char path[100];
    options.keep_hidden = true;
    snprintf(path, sizeof path, "models/%s.off", model);
    roberts_scene *scene = scene_of_file(path);
    roberts_drawing drawing = drawing_of(scene, &camera, &options);
    roberts_scene_free(scene);
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

/* The caller frees the bytes. */
static inline sink drawing_written(const roberts_drawing *drawing, const roberts_draw_options *options)
{
    sink to = {0};
    roberts_error error = {0};
    if (roberts_drawing_write(drawing, options, sink_write, &to, &error) != ROBERTS_OK)
        fail_msg("%s", error.message);
    return to;
}

static inline sink sheet_written(const roberts_sheet *sheet, const roberts_draw_options *options)
{
    sink to = {0};
    roberts_error error = {0};
    if (roberts_sheet_write(sheet, options, sink_write, &to, &error) != ROBERTS_OK)
        fail_msg("%s", error.message);
    return to;
}

#endif
