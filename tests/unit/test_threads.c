/* test_threads.c - several threads call the library at once, each with its own work, and all with one scene: every call
 * gives the same result as alone. `make test-threads` runs it under the thread sanitizer. */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "build_scene.h"
#include "roberts.h"
#include "testing.h"

enum { THREADS = 6, ROUNDS = 3 };

/* Bytes that a drawing is written to. */
typedef struct bytes {
    char *data;
    size_t size;
} bytes;

static const char *const model[] = {"models/table.off", "models/tower.off", "models/city.off"};

static bool keep(void *context, const void *data, size_t size)
{
    bytes *b = context;
    char *grown = realloc(b->data, b->size + size);
    if (!grown)
        return false;
    memcpy(grown + b->size, data, size);
    b->data = grown;
    b->size += size;
    return true;
}

/* Reads, builds, hides and writes, two of them the hull of all points; with `scene` only the last two. Empty on
 * failure. */
static bytes draw(unsigned which, const roberts_scene *scene)
{
    static const char *const view[] = {"iso", "front", "cabinet"};
    bytes out = {0};
    roberts_mesh mesh = {0};
    roberts_scene *own = NULL;
    roberts_drawing drawing = {0};
    roberts_camera camera;
    roberts_hide_options hide = roberts_hide_options_default();
    roberts_draw_options options = roberts_draw_options_default();
    hide.threads = 1 + which % 3;
    hide.keep_hidden = which % 2;
    options.format = which % 2 ? ROBERTS_CSV : ROBERTS_SVG;
    roberts_camera_preset(view[which % 3], &camera);
    if (!scene && roberts_mesh_read_file(&mesh, model[which % 3], NULL, NULL) == ROBERTS_OK) {
        roberts_scene_options build = {.hull = which > 3};
        if (build.hull)
            mesh.face_count = mesh.corner_count = 0;
        if (roberts_scene_build(&mesh, &build, &own, NULL) == ROBERTS_OK)
            scene = own;
    }
    if (scene && roberts_hide(scene, &camera, &hide, &drawing, NULL) == ROBERTS_OK)
        (void)roberts_drawing_write(&drawing, &options, keep, &out, NULL);
    roberts_drawing_free(&drawing);
    roberts_scene_free(own);
    roberts_mesh_free(&mesh);
    return out;
}

typedef struct task {
    unsigned which;
    const roberts_scene *scene;
    bytes expected;
    bool same;
} task;

static void *work(void *argument)
{
    task *t = argument;
    t->same = true;
    for (int round = 0; round < ROUNDS; round++) {
        bytes b = draw(t->which, t->scene);
        t->same = t->same && b.size > 0 && b.size == t->expected.size && memcmp(b.data, t->expected.data, b.size) == 0;
        free(b.data);
    }
    return NULL;
}

static void run_together(const roberts_scene *scene)
{
    pthread_t thread[THREADS];
    task t[THREADS];
    for (unsigned i = 0; i < THREADS; i++)
        t[i] = (task){.which = i, .scene = scene, .expected = draw(i, scene)};
    for (unsigned i = 0; i < THREADS; i++)
        assert_int_equal(pthread_create(&thread[i], NULL, work, &t[i]), 0);
    for (unsigned i = 0; i < THREADS; i++) {
        assert_int_equal(pthread_join(thread[i], NULL), 0);
        free(t[i].expected.data);
        if (!t[i].same)
            fail_msg("drawing %u differs from what it is alone", i);
    }
}

static void each_with_its_own(void **state)
{
    (void)state;
    run_together(NULL);
}

static void all_with_one_scene(void **state)
{
    roberts_scene *scene = scene_of_file(model[0]);
    (void)state;
    run_together(scene);
    roberts_scene_free(scene);
}

/* ---- segments one by one --------------------------------------------------------------------------------------- */

typedef struct receiver {
    const roberts_drawing *drawing;
    size_t count, stop_at;
    bool same;
} receiver;

static bool receive(void *context, const roberts_segment *segment)
{
    receiver *r = context;
    const roberts_segment *s = &r->drawing->segment[r->count];
    r->same = r->same && r->count < r->drawing->count && segment->solid == s->solid && segment->v0 == s->v0 &&
              segment->v1 == s->v1 && segment->t0 == s->t0 && segment->t1 == s->t1 && segment->state == s->state;
    return ++r->count != r->stop_at;
}

/* roberts_hide_each() gives what roberts_hide() keeps, in its order, by any number of threads, and can be stopped. */
static void segments_one_by_one(void **state)
{
    roberts_scene *scene = scene_of_file(model[2]);
    roberts_drawing summary;
    roberts_camera camera = preset_camera("iso");
    roberts_hide_options options = roberts_hide_options_default();
    (void)state;
    for (options.threads = 1; options.threads <= 3; options.threads++) {
        roberts_drawing drawing = drawing_of(scene, &camera, &options);
        receiver r = {.drawing = &drawing, .same = true}, stopped = {.drawing = &drawing, .same = true, .stop_at = 5};
        const roberts_receiver to_r = {receive, &r}, to_stopped = {receive, &stopped};
        assert_int_equal(roberts_hide_each(scene, &camera, &options, &to_r, &summary, NULL), ROBERTS_OK);
        assert_true(r.same);
        assert_int_equal(r.count, drawing.count);
        assert_int_equal(summary.count, drawing.count);
        assert_null(summary.segment);
        assert_int_equal(roberts_hide_each(scene, &camera, &options, &to_stopped, NULL, NULL), ROBERTS_STOPPED);
        assert_int_equal(stopped.count, 5);
        roberts_drawing_free(&drawing);
    }
    roberts_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_with_its_own),
        cmocka_unit_test(all_with_one_scene),
        cmocka_unit_test(segments_one_by_one),
    };
    return cmocka_run_group_tests_name("threads", tests, NULL, NULL);
}
