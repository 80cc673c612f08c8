/* live.c - one scene, drawn again and again: what the page calls while a model is turned.
 *
 * The arguments are those of the program, and the same code reads them, reads the files and builds the scene. A frame
 * is the visible and the hidden segments as plain numbers, class by class; the page draws them as they are. What is
 * saved comes from the program itself. */
#include <stdlib.h>

#include "cli/message.h"
#include "cli/options.h"
#include "cli/picture.h"
#include "model/scene.h"

/* Classes of lines in a frame: the visible ones by their line, then all hidden ones. */
enum { VISIBLE_CLASSES = ROBERTS_BACK_OUTLINE + 1, FRAME_CLASSES = VISIBLE_CLASSES + 1 };

/* What the page reads, member by member (live.js knows where they lie). Lengths are those of the model. */
typedef struct live_frame {
    uint32_t count[FRAME_CLASSES]; /* segments of each class */
    double window[4];              /* x0, y0, x1, y1: what would be laid on the page */
    float *line;                   /* x0, y0, x1, y1 of each segment, class after class */
    uint32_t bodies, faces;        /* of the scene */
    double centre[3];              /* of the box round the scene, at which an eye looks */
    double diameter;               /* of that box */
} live_frame;

/* Reads the files and builds the scene, in place of the one before. Returns the exit status. */
int live_open(int argc, char **argv) __attribute__((export_name("live_open")));

/* Draws the scene from where the arguments say. NULL: it failed, and a message says why. */
const live_frame *live_draw(int argc, char **argv) __attribute__((export_name("live_draw")));

static roberts_scene *scene;
static live_frame frame;

/* Reads the arguments, without the warnings that the program gives when it draws. */
static int read_options(int argc, char **argv, cli_options *options)
{
    int status = options_parse(&option_table_all, argc, argv, options);
    options->log = stderr;
    return status;
}

int live_open(int argc, char **argv)
{
    cli_options options;
    int status = read_options(argc, argv, &options);
    roberts_scene_free(scene);
    scene = NULL;
    if (status == EXIT_DONE)
        status = picture_load(&options, &scene);
    if (status == EXIT_DONE) {
        frame.bodies = (uint32_t)roberts_scene_solid_count(scene);
        frame.faces = (uint32_t)roberts_scene_face_count(scene);
        const roberts_vec3 c = scene->centre, lo = scene->box_min, hi = scene->box_max;
        frame.centre[0] = c.x, frame.centre[1] = c.y, frame.centre[2] = c.z;
        frame.diameter = vec3_length(vec3_sub(hi, lo));
    }
    return status;
}

static uint32_t class_of(const roberts_segment *s)
{
    return s->state == ROBERTS_VISIBLE ? s->line : VISIBLE_CLASSES;
}

/* Counts, and fills. False: no memory. */
static bool fill_frame(const roberts_drawing *drawing)
{
    uint32_t at[FRAME_CLASSES] = {0}, total = 0;
    for (int c = 0; c < FRAME_CLASSES; c++)
        frame.count[c] = 0;
    for (size_t i = 0; i < drawing->count; i++)
        frame.count[class_of(&drawing->segment[i])] += drawing->segment[i].state != ROBERTS_CLIPPED;
    for (int c = 0; c < FRAME_CLASSES; c++) {
        at[c] = total;
        total += frame.count[c];
    }
    float *line = realloc(frame.line, (total + 1) * 4 * sizeof *line);
    if (!line)
        return false;
    frame.line = line;
    for (size_t i = 0; i < drawing->count; i++) {
        const roberts_segment *s = &drawing->segment[i];
        if (s->state == ROBERTS_CLIPPED)
            continue;
        float *to = line + 4 * (size_t)at[class_of(s)]++;
        to[0] = (float)s->p0.x;
        to[1] = (float)s->p0.y;
        to[2] = (float)s->p1.x;
        to[3] = (float)s->p1.y;
    }
    frame.window[0] = drawing->window_min.x;
    frame.window[1] = drawing->window_min.y;
    frame.window[2] = drawing->window_max.x;
    frame.window[3] = drawing->window_max.y;
    return true;
}

const live_frame *live_draw(int argc, char **argv)
{
    cli_options options;
    roberts_drawing drawing = {0};
    roberts_error error = {0};
    if (!scene || read_options(argc, argv, &options) != EXIT_DONE)
        return NULL;
    options.hide.nameless = true;
    bool done = roberts_hide(scene, &options.camera, &options.hide, &drawing, &error) == ROBERTS_OK;
    if (!done)
        message_error(stderr, &error);
    done = done && fill_frame(&drawing);
    roberts_drawing_free(&drawing);
    return done ? &frame : NULL;
}
