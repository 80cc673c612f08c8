/* The visible segments of an OFF file, one by one: their number and their length in the picture.
 *   cc segments.c $(pkg-config --cflags --libs roberts) -lm -o segments && ./segments model.off */
#include <math.h>
#include <roberts.h>
#include <stdio.h>

typedef struct sum {
    unsigned long count;
    double length;
} sum;

static bool add(void *context, const roberts_segment *segment)
{
    sum *s = context;
    s->count++;
    s->length += hypot(segment->p1.x - segment->p0.x, segment->p1.y - segment->p0.y);
    return true;
}

int main(int argc, char **argv)
{
    roberts_mesh mesh = {0};
    roberts_scene *scene = NULL;
    roberts_error error = {0};
    roberts_camera camera;
    sum s = {0};
    const roberts_receiver adder = {add, &s};
    roberts_camera_preset("top", &camera);
    roberts_status status = roberts_mesh_read_file(&mesh, argc > 1 ? argv[1] : "-", NULL, &error);
    if (status == ROBERTS_OK)
        status = roberts_scene_build(&mesh, NULL, &scene, &error);
    roberts_mesh_free(&mesh);
    if (status == ROBERTS_OK)
        status = roberts_hide_each(scene, &camera, NULL, &adder, NULL, &error);
    roberts_scene_free(scene);
    if (status == ROBERTS_OK)
        printf("%lu segments, %.10g long\n", s.count, s.length);
    else
        fprintf(stderr, "%s: %s\n", error.file, error.message);
    return status == ROBERTS_OK ? 0 : 1;
}
