/* test_parts.c - a drawing that is joined from parts has the same bytes as that of one run, and join refuses parts that
 * do not belong together. */
#include <glob.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "part/plan.h"
#include "build_scene.h"
#include "rng.h"
#include "roberts.h"
#include "temporary.h"
#include "testing.h"
#include "whole_file.h"

enum { PARTS_MOST = 7, NAME = TEMPORARY_ROOM + 32 };

static char plan_path[NAME], part[PARTS_MOST][NAME], one[NAME], joined[NAME], model[2][NAME];

static int begin(void **state)
{
    if (temporary_make(state) != 0)
        return -1;
    snprintf(plan_path, sizeof plan_path, "%s/scene.plan", temporary);
    snprintf(one, sizeof one, "%s/one", temporary);
    snprintf(joined, sizeof joined, "%s/joined", temporary);
    for (int k = 0; k < PARTS_MOST; k++)
        snprintf(part[k], sizeof part[k], "%s/part-%d", temporary, k + 1);
    for (int k = 0; k < 2; k++)
        snprintf(model[k], sizeof model[k], "%s/model-%d.off", temporary, k);
    return 0;
}

/* ---- one run, and parts ----------------------------------------------------------------------------------------- */

static roberts_task task_of(const char *view)
{
    roberts_task task = {.hide = roberts_hide_options_default()};
    task.hide.threads = task.scene.threads = 1;
    if (!roberts_camera_preset(view, &task.camera))
        task.camera = (roberts_camera){.projection = ROBERTS_PERSPECTIVE, .eye = {90, -140, 110}, .up = {0, 0, 1}};
    return task;
}

/* The format and what goes with it. */
typedef struct paper {
    roberts_format format;
    roberts_grouping grouping;
} paper;

static const paper papers[] = {{ROBERTS_SVG, ROBERTS_GROUP_CLASS},
                               {ROBERTS_SVG, ROBERTS_GROUP_ELEMENT},
                               {ROBERTS_CSV, ROBERTS_GROUP_CLASS},
                               {ROBERTS_JSON, ROBERTS_GROUP_CLASS},
                               {ROBERTS_HPGL, ROBERTS_GROUP_CLASS}};

static void save(const roberts_drawing *drawing, const roberts_scene *scene, paper as, const char *path)
{
    roberts_draw_options options = roberts_draw_options_default();
    options.format = as.format;
    options.grouping = as.grouping;
    options.hidden = ROBERTS_HIDDEN_DASHED;
    options.scene = scene;
    options.column_count = 3;
    options.column[0] = ROBERTS_COLUMN_ENDS;
    options.column[1] = ROBERTS_COLUMN_DEPTH;
    options.column[2] = ROBERTS_COLUMN_LEVEL;
    assert_int_equal(roberts_drawing_save(drawing, &options, path, NULL), ROBERTS_OK);
}

static void require_same(const char *what, uint32_t parts, paper as)
{
    size_t size, other;
    char *a = whole_file(one, &size), *b = whole_file(joined, &other);
    if (size != other || memcmp(a, b, size) != 0)
        fail_msg("%s in %u parts differs in format %d", what, parts, (int)as.format);
    free(a);
    free(b);
}

static roberts_status draw_parts(const roberts_inputs *input, const roberts_task *task, uint32_t parts,
                                 roberts_error *error)
{
    roberts_status status = ROBERTS_OK;
    for (uint32_t k = 0; k < parts && status == ROBERTS_OK; k++)
        status = roberts_part_save(input, task, (roberts_share){k + 1, parts}, part[k], error);
    return status;
}

static roberts_status join(uint32_t parts, const roberts_task *task, roberts_joined *to, roberts_error *error)
{
    char *name[PARTS_MOST];
    for (uint32_t k = 0; k < parts; k++)
        name[k] = part[parts - 1 - k]; /* in another order */
    return roberts_join(&(roberts_inputs){parts, name}, task, to, error);
}

/* Returns whether the inputs can be drawn in parts; then everything must be the same. */
static bool is_same(const roberts_inputs *input, const roberts_task *task, uint32_t parts)
{
    roberts_mesh mesh = {.threads = 1};
    roberts_scene *scene = NULL;
    roberts_joined from_parts;
    roberts_error error = {0};
    char *const plans[] = {plan_path};
    if (roberts_plan_save(input, task, plan_path, &error) != ROBERTS_OK)
        return false;
    for (size_t i = 0; i < input->count; i++)
        assert_int_equal(roberts_mesh_read_file(&mesh, input->name[i], NULL, NULL), ROBERTS_OK);
    assert_int_equal(roberts_scene_take(&mesh, &task->scene, &scene, NULL), ROBERTS_OK);
    roberts_drawing drawing = drawing_of(scene, &task->camera, &task->hide);
    const roberts_inputs from = parts % 2 ? *input : (roberts_inputs){1, plans};
    if (draw_parts(&from, task, parts, &error) != ROBERTS_OK || join(parts, task, &from_parts, &error) != ROBERTS_OK)
        fail_msg("%s in %u parts: %s", input->name[0], parts, error.message);
    for (size_t i = 0; i < sizeof papers / sizeof papers[0]; i++) {
        save(&drawing, scene, papers[i], one);
        save(&from_parts.drawing, NULL, papers[i], joined);
        require_same(input->name[0], parts, papers[i]);
    }
    roberts_joined_free(&from_parts);
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
    return true;
}

static const uint32_t counts[] = {1, 2, 3, 7};

/* The models of the project, with hidden lines and without, as one and separately. */
static void models_are_the_same(void **state)
{
    static const char *const views[] = {"iso", "eye", "top", "cabinet"};
    glob_t found;
    size_t same = 0;
    (void)state;
    assert_int_equal(glob("models/*.off", 0, NULL, &found), 0);
    assert_int_equal(glob("models/shapes/*.off", GLOB_APPEND, NULL, &found), 0);
    assert_int_equal(glob("models/tests/*.off", GLOB_APPEND, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        const roberts_inputs input = {1, &found.gl_pathv[i]};
        roberts_task task = task_of(views[i % 4]);
        task.hide.keep_hidden = task.hide.levels = i % 3 > 0;
        task.hide.unite = i % 3 == 1;
        task.hide.all_edges = i % 5 == 1;
        same += is_same(&input, &task, counts[i / 2 % 4]);
    }
    globfree(&found);
    assert_true(same > 40);
}

/* How the bodies of a scene are numbered. */
typedef enum numbering { IN_A_ROW, MIXED_FACES, MIXED, NUMBERINGS } numbering;

/* Writes boxes of all sizes, some of them turned into wedges; many touch, overlap or coincide. */
static void write_crowd(const char *path, uint64_t seed, int count, numbering how)
{
    static const int corner[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    rng r = {seed};
    FILE *file = fopen(path, "w");
    double(*box)[7] = calloc((size_t)count, sizeof *box);
    assert_true(file && box);
    for (int b = 0; b < count; b++) {
        const bool large = b % 29 == 7;
        for (int k = 0; k < 3; k++) {
            box[b][k] = (double)(int)rng_between(&r, -30, 30);
            box[b][3 + k] = (double)(int)rng_between(&r, 1, large ? 40 : 6);
        }
        box[b][6] = b % 3 == 0 ? 0.25 * box[b][3] : 0.0; /* the top is narrower */
    }
    fprintf(file, "OFF\n%d %d 0\n", 8 * count, 6 * count);
    for (int i = 0; i < 8 * count; i++) {
        const int b = how == MIXED ? i % count : i / 8, v = how == MIXED ? i / count : i % 8;
        const double *at = box[b], in = v & 4 ? at[6] : 0.0;
        fprintf(file, "%g %g %g\n", at[0] + (v & 1 ? at[3] - in : in), at[1] + (v & 2 ? at[4] : 0.0),
                at[2] + (v & 4 ? at[5] : 0.0));
    }
    for (int i = 0; i < 6 * count; i++) {
        const int b = how == IN_A_ROW ? i / 6 : i % count, *c = corner[how == IN_A_ROW ? i % 6 : i / count];
        fprintf(file, "4");
        for (int k = 0; k < 4; k++)
            fprintf(file, " %d", how == MIXED ? c[k] * count + b : 8 * b + c[k]);
        fprintf(file, "\n");
    }
    free(box);
    assert_int_equal(fclose(file), 0);
}

/* Crowds in one file and in two, however their bodies are numbered. */
static void crowds_are_the_same(void **state)
{
    static const char *const views[] = {"iso", "eye", "front", "dimetric"};
    char *const names[] = {model[0], model[1]};
    (void)state;
    for (int i = 0; i < 24; i++) {
        const roberts_inputs input = {1 + (size_t)i % 2, names};
        roberts_task task = task_of(views[i % 4]);
        task.hide.keep_hidden = i % 3 > 0;
        task.hide.unite = i % 6 == 5;
        write_crowd(model[0], 100 + (uint64_t)i, 60, (numbering)(i / 2 % NUMBERINGS));
        write_crowd(model[1], 200 + (uint64_t)i, 25, (numbering)(i % NUMBERINGS));
        assert_true(is_same(&input, &task, counts[i / 4 % 4]));
    }
}

/* Crowds in one spot of the picture: the axes of their covers are warped, and parts take the warps from the plan. */
static void spots_are_the_same(void **state)
{
    static const char *const views[] = {"iso", "front", "dimetric"};
    char *const names[] = {model[0], model[1]};
    (void)state;
    for (int i = 0; i < 6; i++) {
        roberts_task task = task_of(views[i % 3]);
        plan_facts facts;
        size_t size;
        task.hide.keep_hidden = false;
        write_crowd(model[0], 300 + (uint64_t)i, 3000, (numbering)(i % NUMBERINGS));
        write_text(model[1], "OFF\n4 4 0\n2000 0 0\n2001 3000 0\n2000 0 5000\n2001 -7 9\n"
                             "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
        assert_true(is_same(&(roberts_inputs){2, names}, &task, counts[i % 4]));
        char *bytes = whole_file(plan_path, &size);
        memcpy(&facts, bytes + size - sizeof facts, sizeof facts);
        free(bytes);
        assert_int_equal(facts.whole.warped, 1);
    }
}

enum { AROUND = 24, ALONG = 15 };

/* Writes rough balls of triangles, many of them behind others. */
static void write_balls(const char *path, uint64_t seed, int count)
{
    const int vertices = ALONG * AROUND + 2, faces = 2 * ALONG * AROUND;
    const double turn = 6.283185307179586 / AROUND;
    rng r = {seed};
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "OFF\n%d %d 0\n", count * vertices, count * faces);
    for (int b = 0; b < count; b++) {
        const double x = 6.0 * (b % 3) + rng_between(&r, -1, 1), y = 9.0 * (int)rng_between(&r, 0, 20),
                     z = 6.0 * (b / 3 % 2) + rng_between(&r, -1, 1), size = rng_between(&r, 1, 5);
        for (int i = 0; i < ALONG * AROUND; i++) {
            const double u = turn * (i % AROUND), v = 3.141592653589793 * (1 + i / AROUND) / (ALONG + 1),
                         d = size * rng_between(&r, 0.9, 1.0);
            fprintf(file, "%.9f %.9f %.9f\n", x + d * sin(v) * cos(u), y + d * sin(v) * sin(u), z + d * cos(v));
        }
        fprintf(file, "%.9f %.9f %.9f\n%.9f %.9f %.9f\n", x, y, z + size, x, y, z - size);
    }
    for (int b = 0; b < count; b++) {
        const int first = b * vertices, top = first + ALONG * AROUND;
        for (int i = 0; i <= ALONG; i++)
            for (int j = 0; j < AROUND; j++) {
                const int k = (j + 1) % AROUND, above = first + (i - 1) * AROUND, below = first + i * AROUND;
                if (i < ALONG)
                    fprintf(file, "3 %d %d %d\n", i ? above + j : top, below + j, below + k);
                if (i > 0)
                    fprintf(file, "3 %d %d %d\n", above + j, i < ALONG ? below + k : top + 1, above + k);
            }
    }
    assert_int_equal(fclose(file), 0);
}

/* Bodies of small faces over one another. No face fills a cell, but those of one body do together, and cull others. */
static void balls_are_the_same(void **state)
{
    static const char *const views[] = {"front", "iso"};
    char *const names[] = {model[0]};
    size_t culled = 0;
    (void)state;
    for (int i = 0; i < 4; i++) {
        roberts_task task = task_of(views[i % 2]);
        task.hide.keep_hidden = false;
        write_balls(model[0], 400 + (uint64_t)i, 60);
        assert_true(is_same(&(roberts_inputs){1, names}, &task, counts[i]));
        roberts_mesh mesh = {.threads = 1};
        roberts_scene *scene = NULL;
        assert_int_equal(roberts_mesh_read_file(&mesh, names[0], NULL, NULL), ROBERTS_OK);
        assert_int_equal(roberts_scene_take(&mesh, NULL, &scene, NULL), ROBERTS_OK);
        roberts_drawing drawing = drawing_of(scene, &task.camera, &task.hide);
        culled += drawing.culled_solids;
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
    assert_true(culled > 20);
}

/* A part holds less than the whole: in many parts, a row of boxes has few rows in each. */
static void parts_are_small(void **state)
{
    char *const names[] = {model[0]};
    const roberts_inputs input = {1, names};
    const roberts_task task = task_of("front");
    size_t size, all = 0;
    (void)state;
    write_crowd(model[0], 5, 200, IN_A_ROW);
    assert_int_equal(draw_parts(&input, &task, 7, NULL), ROBERTS_OK);
    for (int k = 0; k < 7; k++) {
        free(whole_file(part[k], &size));
        all += size;
    }
    for (int k = 0; k < 7; k++) {
        free(whole_file(part[k], &size));
        assert_true(size < all / 2);
    }
}

/* More parts than bodies: some are empty. */
static void parts_may_be_empty(void **state)
{
    char *const names[] = {model[0]};
    const roberts_inputs input = {1, names};
    const roberts_task task = task_of("iso");
    (void)state;
    write_crowd(model[0], 9, 2, IN_A_ROW);
    assert_true(is_same(&input, &task, 7));
}

/* ---- refusals --------------------------------------------------------------------------------------------------- */

static void require_join(const roberts_inputs *parts, const roberts_task *task, roberts_status wanted, const char *said)
{
    roberts_joined to;
    roberts_error error = {0};
    assert_int_equal(roberts_join(parts, task, &to, &error), wanted);
    if (!strstr(error.message, said))
        fail_msg("said: %s, not: %s", error.message, said);
    assert_null(to.drawing.segment);
}

static void join_refuses(void **state)
{
    char *const names[] = {model[0]}, *const others[] = {model[1]};
    char *all[] = {part[0], part[1], part[2]};
    const roberts_inputs three = {3, all}, two = {2, all};
    const roberts_task task = task_of("iso"), turned = task_of("front");
    (void)state;
    write_crowd(model[0], 1, 30, IN_A_ROW);
    write_crowd(model[1], 2, 30, IN_A_ROW);
    assert_int_equal(draw_parts(&(roberts_inputs){1, names}, &task, 3, NULL), ROBERTS_OK);
    require_join(&two, &task, ROBERTS_BAD_ARGUMENT, "part 3 of 3 is missing");
    require_join(&(roberts_inputs){2, all + 1}, &task, ROBERTS_BAD_ARGUMENT, "part 1 of 3 is missing");
    require_join(&three, &turned, ROBERTS_BAD_ARGUMENT, "another view");
    all[2] = part[0];
    require_join(&three, &task, ROBERTS_BAD_ARGUMENT, "part 1 is given twice");
    all[2] = model[0];
    require_join(&three, &task, ROBERTS_BAD_SYNTAX, "no part of a drawing");
    all[2] = part[2];
    assert_int_equal(roberts_part_save(&(roberts_inputs){1, others}, &task, (roberts_share){3, 3}, part[2], NULL),
                     ROBERTS_OK);
    require_join(&three, &task, ROBERTS_BAD_ARGUMENT, "another drawing");
    assert_int_equal(roberts_part_save(&(roberts_inputs){1, names}, &task, (roberts_share){3, 4}, part[2], NULL),
                     ROBERTS_OK);
    require_join(&three, &task, ROBERTS_BAD_ARGUMENT, "another number of parts");
}

/* A part with any one byte changed, or cut off anywhere, is refused, or is the same. */
static void broken_parts_are_refused(void **state)
{
    char *const names[] = {model[0]};
    char *all[] = {part[0], part[1]};
    const roberts_inputs two = {2, all};
    const roberts_task task = task_of("iso");
    size_t size, refused = 0, tried = 0;
    (void)state;
    write_crowd(model[0], 3, 6, IN_A_ROW);
    assert_int_equal(draw_parts(&(roberts_inputs){1, names}, &task, 2, NULL), ROBERTS_OK);
    char *bytes = whole_file(part[1], &size);
    for (size_t at = 0; at < size; at += 7, tried++) {
        roberts_joined to;
        FILE *file = fopen(part[1], "wb");
        const bool cut = at % 2;
        bytes[at] ^= (char)(cut ? 0 : 0x41);
        assert_int_equal(fwrite(bytes, 1, cut ? at : size, file), cut ? at : size);
        assert_int_equal(fclose(file), 0);
        bytes[at] ^= (char)(cut ? 0 : 0x41);
        refused += roberts_join(&two, &task, &to, NULL) != ROBERTS_OK;
        roberts_joined_free(&to);
    }
    free(bytes);
    assert_true(tried > 100);
    assert_true(refused + 8 > tried); /* the name of the input may be another one */
}

/* Anything that needs the whole is refused before anything is written, by the plan as by a part. */
static void wholes_are_refused(void **state)
{
    static const struct {
        const char *text, *said;
        const char *view; /* NULL: iso */
        bool solids;
    } cases[] = {
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "body 0 is open; only", NULL, false},
        /* two triangles at one place: each edge has two faces until one of them is left out */
        {"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n", "body 0 is open; only", NULL, false},
        {"OFF\n2 1 0\n0 0 0\n1 0 0\n2 0 1\n", "is a line", NULL, false},
        {"OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n7 7 7\n4 0 2 1 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", "repeat", NULL,
         false},
        {"OFF\n1 0 0\n0 0 0\n", "no body", NULL, false},
        /* a tetrahedron, and two that share an edge */
        {"OFF\n10 12 0\n5 5 5\n6 5 5\n5 6 5\n5 5 6\n0 0 0\n0 0 1\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n"
         "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 4 5 6\n3 5 4 7\n3 4 6 7\n3 5 7 6\n3 4 5 8\n3 5 4 9\n3 4 8 9\n"
         "3 5 9 8\n",
         "body 1 is several bodies; only", NULL, false},
        /* a box with an arrow for its base */
        {"OFF\n8 6 0\n0 0 0\n2 1 0\n4 0 0\n2 4 0\n0 0 1\n2 1 1\n4 0 1\n2 4 1\n4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n"
         "4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n",
         "convex", NULL, true},
        /* a pyramid over a face that crosses itself */
        {"OFF\n5 5 0\n0 0 0\n2 2 0\n2 0 0\n0 2 0\n1 1 5\n4 0 1 2 3\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n",
         "cross themselves", "eye", false},
    };
    char *const names[] = {model[0]};
    const roberts_inputs input = {1, names};
    roberts_task task;
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_error error = {0}, planned = {0};
        write_text(model[0], cases[i].text);
        task = task_of(cases[i].view ? cases[i].view : "iso");
        task.scene.solids = cases[i].solids;
        (void)remove(plan_path);
        assert_int_not_equal(roberts_part_save(&input, &task, (roberts_share){1, 1}, part[6], &error), ROBERTS_OK);
        if (!strstr(error.message, cases[i].said))
            fail_msg("said: %s, not: %s", error.message, cases[i].said);
        assert_int_equal(roberts_plan_save(&input, &task, plan_path, &planned), error.status);
        assert_string_equal(planned.message, error.message);
        assert_int_not_equal(access(part[6], F_OK), 0);
        assert_int_not_equal(access(plan_path, F_OK), 0);
    }
    task = task_of("iso");
    write_crowd(model[0], 4, 9, IN_A_ROW);
    assert_int_equal(roberts_part_save(&input, &task, (roberts_share){4, 3}, part[6], NULL), ROBERTS_BAD_ARGUMENT);
    task = task_of("eye");
    task.camera.near_distance = 199;
    assert_int_equal(roberts_plan_save(&input, &task, plan_path, NULL), ROBERTS_BAD_VIEW);
    task = task_of("iso");
    task.scene.hull = true;
    assert_int_equal(roberts_plan_save(&input, &task, plan_path, NULL), ROBERTS_BAD_ARGUMENT);
    task = task_of("iso");
    task.camera.has_section = true;
    assert_int_equal(roberts_plan_save(&input, &task, plan_path, NULL), ROBERTS_BAD_ARGUMENT);
}

/* A plan of another task, a plan beside a model, and a plan that is cut off. */
static void plans_are_checked(void **state)
{
    char *names[] = {model[0], plan_path}, *plans[] = {plan_path};
    const roberts_task task = task_of("iso"), turned = task_of("front");
    roberts_task cut = task;
    size_t size;
    (void)state;
    cut.camera.has_section = true;
    write_crowd(model[0], 4, 9, IN_A_ROW);
    assert_int_equal(roberts_plan_save(&(roberts_inputs){1, names}, &task, plan_path, NULL), ROBERTS_OK);
    const roberts_share first = {1, 2};
    assert_int_equal(roberts_part_save(&(roberts_inputs){1, plans}, &task, first, part[0], NULL), ROBERTS_OK);
    assert_int_equal(roberts_part_save(&(roberts_inputs){1, plans}, &turned, first, part[0], NULL),
                     ROBERTS_BAD_ARGUMENT);
    assert_int_equal(roberts_part_save(&(roberts_inputs){1, plans}, &cut, first, part[0], NULL), ROBERTS_BAD_ARGUMENT);
    assert_int_equal(roberts_part_save(&(roberts_inputs){2, names}, &task, first, part[0], NULL), ROBERTS_BAD_ARGUMENT);
    char *bytes = whole_file(plan_path, &size);
    FILE *file = fopen(plan_path, "wb");
    assert_int_equal(fwrite(bytes, 1, size - 8, file), size - 8);
    assert_int_equal(fclose(file), 0);
    free(bytes);
    assert_int_equal(roberts_part_save(&(roberts_inputs){1, plans}, &task, first, part[0], NULL), ROBERTS_BAD_SYNTAX);
}

static void write_plan(const char *bytes, size_t size)
{
    FILE *file = fopen(plan_path, "wb");
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

/* Makes the checks of a plan fit its contents. No body lists numbers. */
static void sign_plan(char *bytes, size_t size)
{
    plan_facts facts;
    memcpy(&facts, bytes + size - sizeof facts, sizeof facts);
    const size_t places = facts.starts - facts.places;
    size_t at = PLAN_BEGIN;
    for (size_t i = 0; i < places / sizeof(plan_place); i++) {
        plan_place *place = (plan_place *)(void *)(bytes + facts.places) + i;
        plan_body body;
        memcpy(&body, bytes + at, sizeof body);
        const size_t length =
            sizeof body + body.vertices * sizeof(roberts_vec3) + ((size_t)body.faces + body.corners) * sizeof(uint32_t);
        place->check = plan_check(0, bytes + at, length);
        at += (size_t)(length + PLAN_UNIT - 1) / PLAN_UNIT * PLAN_UNIT;
    }
    facts.places_check = plan_check(0, bytes + facts.places, places);
    facts.starts_check = plan_check(0, bytes + facts.starts, places / sizeof(plan_place) * sizeof(uint32_t));
    facts.check = plan_check(0, &facts.id, sizeof facts - offsetof(plan_facts, id));
    memcpy(bytes + size - sizeof facts, &facts, sizeof facts);
}

/* Sizes and counts in a plan that do not fit the file, though its checks hold. */
static void broken_plans_are_refused(void **state)
{
    char *names[] = {model[0]}, *plans[] = {plan_path};
    const roberts_task task = task_of("iso");
    plan_facts facts;
    size_t size;
    (void)state;
    write_crowd(model[0], 4, 9, IN_A_ROW);
    assert_int_equal(roberts_plan_save(&(roberts_inputs){1, names}, &task, plan_path, NULL), ROBERTS_OK);
    char *bytes = whole_file(plan_path, &size), *copy = malloc(size);
    assert_non_null(copy);
    memcpy(&facts, bytes + size - sizeof facts, sizeof facts);
    const size_t end = size - sizeof facts, place = facts.places;
    const uint32_t vertices = ((const plan_body *)(const void *)(bytes + PLAN_BEGIN))->vertices;
    const size_t corners = PLAN_BEGIN + sizeof(plan_body) + vertices * sizeof(roberts_vec3); /* of the first face */
    const struct {
        size_t at;
        uint32_t value;
    } wrong[] = {{end + offsetof(plan_facts, weight), 0},
                 {end + offsetof(plan_facts, weight), (uint32_t)facts.weight + 1},
                 {end + offsetof(plan_facts, bodies), 0},
                 {end + offsetof(plan_facts, whole.columns), 1u << 31},
                 {end + offsetof(plan_facts, whole.columns), facts.whole.columns ? 0 : 1},
                 {end + offsetof(plan_facts, whole.warped), 1},
                 {end + offsetof(plan_facts, whole.warped), 2},
                 {place + offsetof(plan_place, vertices), vertices + 1},
                 {place + offsetof(plan_place, faces), 5},
                 {place + offsetof(plan_place, faces), 1000000},
                 {place + offsetof(plan_place, corners), 23},
                 {place + offsetof(plan_place, size), 1},
                 {facts.starts, (uint32_t)facts.weight},
                 {corners, 0xfffffff0},
                 {corners, 5}};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        memcpy(copy, bytes, size);
        sign_plan(copy, size);
        assert_memory_equal(copy, bytes, size);
        memcpy(copy + wrong[i].at, &wrong[i].value, sizeof wrong[i].value);
        sign_plan(copy, size);
        write_plan(copy, size);
        assert_int_equal(roberts_part_save(&(roberts_inputs){1, plans}, &task, (roberts_share){1, 1}, part[0], NULL),
                         ROBERTS_BAD_SYNTAX);
    }
    free(copy);
    free(bytes);
}

/* Is this byte one of those that fill a section up? They are not read. */
static bool is_padding(const char *bytes, const plan_facts *facts, size_t end, size_t at)
{
    if (at >= end)
        return false;
    if (at >= facts->names)
        return strlen(bytes + facts->names) + facts->names < at;
    if (at >= facts->starts)
        return at >= facts->starts + facts->bodies * sizeof(uint32_t);
    size_t begin = PLAN_BEGIN;
    for (size_t i = 0; i < facts->bodies && at < facts->places; i++) {
        plan_place place;
        memcpy(&place, bytes + facts->places + i * sizeof place, sizeof place);
        const size_t length = sizeof(plan_body) + place.vertices * sizeof(roberts_vec3) +
                              ((size_t)place.faces + place.corners) * sizeof(uint32_t);
        if (at < begin + (size_t)place.size * PLAN_UNIT)
            return at >= begin + length;
        begin += (size_t)place.size * PLAN_UNIT;
    }
    return false;
}

/* A single wrong bit is found, wherever it is. */
static void damaged_plans_are_refused(void **state)
{
    char *names[] = {model[0]}, *plans[] = {plan_path};
    const roberts_task task = task_of("iso");
    plan_facts facts;
    size_t size, tried = 0;
    (void)state;
    write_crowd(model[0], 4, 9, IN_A_ROW);
    assert_int_equal(roberts_plan_save(&(roberts_inputs){1, names}, &task, plan_path, NULL), ROBERTS_OK);
    char *bytes = whole_file(plan_path, &size);
    memcpy(&facts, bytes + size - sizeof facts, sizeof facts);
    for (size_t at = PLAN_BEGIN; at < size; at += at < facts.starts ? 13 : 1) {
        if (is_padding(bytes, &facts, size - sizeof facts, at))
            continue;
        bytes[at] ^= (char)(1 << at % 8);
        write_plan(bytes, size);
        if (roberts_part_save(&(roberts_inputs){1, plans}, &task, (roberts_share){1, 1}, part[0], NULL) !=
            ROBERTS_BAD_SYNTAX)
            fail_msg("byte %zu of %zu", at, size);
        bytes[at] ^= (char)(1 << at % 8);
        tried++;
    }
    assert_true(tried > 300);
    free(bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(models_are_the_same, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(crowds_are_the_same, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(spots_are_the_same, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(balls_are_the_same, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(parts_are_small, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(parts_may_be_empty, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(join_refuses, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(broken_parts_are_refused, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(wholes_are_refused, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(plans_are_checked, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(broken_plans_are_refused, begin, temporary_remove),
        cmocka_unit_test_setup_teardown(damaged_plans_are_refused, begin, temporary_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
