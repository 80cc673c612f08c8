/* test_loose_ends.c - every visible facet is bounded all round: at each end of a visible line, another line continues.
 * First, pictures whose answer is known by hand. Then all of models/ and the published models, from directions in which
 * no face is edge-on. With --union, borders of regions have lines. */
#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/vec.h"
#include "build_scene.h"
#include "folders.h"
#include "loose_ends.h"
#include "testing.h"

/* ---- by hand ---- */

/* Lines as x0 y0 x1 y1. */
static const struct {
    const char *name;
    size_t lines;
    double line[6][4];
    size_t loose;
} hand_cases[] = {
    {"a line alone", 1, {{0, 0, 1, 0}}, 2},
    {"a triangle", 3, {{0, 0, 1, 0}, {1, 0, 0, 1}, {0, 1, 0, 0}}, 0},
    {"an open corner", 2, {{0, 0, 1, 0}, {1, 0, 0, 1}}, 2},
    {"a line that ends on another", 4, {{0, 0, 1, 0}, {1, 0, 0, 1}, {0, 1, 0, 0}, {0.2, 0, 0.2, 0.8}}, 0},
    {"... and just before it", 4, {{0, 0, 1, 0}, {1, 0, 0, 1}, {0, 1, 0, 0}, {0.2, 0, 0.2, 0.7999}}, 1},
    {"a line over another in the same place leads nowhere", 2, {{0, 0, 1, 0}, {0, 0, 1, 0}}, 4},
    {"the same, shorter", 2, {{0, 0, 1, 0}, {0, 0, 0.5, 0}}, 3},
    {"one after another", 3, {{0, 0, 1, 0}, {1, 0, 2, 0}, {2, 0, 3, 0}}, 2},
};

static void test_by_hand(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof hand_cases / sizeof hand_cases[0]; i++) {
        roberts_segment segment[6] = {{0}};
        roberts_drawing drawing = {.count = hand_cases[i].lines, .segment = segment};
        loose_end end[12];
        size_t asked;
        for (size_t k = 0; k < hand_cases[i].lines; k++) {
            const double *l = hand_cases[i].line[k];
            segment[k] = (roberts_segment){.p0 = {l[0], l[1]}, .p1 = {l[2], l[3]}, .line = ROBERTS_CREASE};
        }
        size_t loose = loose_ends_find(&drawing, end, 12, &asked);
        if (loose != hand_cases[i].loose || asked != 2 * hand_cases[i].lines)
            fail_msg("%s: %zu loose ends of %zu", hand_cases[i].name, loose, asked);
    }
}

/* ---- models ---- */

enum {
    FILES = 2000,
    NAME = 600,
    LARGEST_FILE = 3000000 /* bytes */,
    REPORTS = 12,
    MOST_CORNERS = 200,
    MOST_COMPARED = 3000 /* corners of a model */
};

typedef struct tally {
    size_t models, left_out, twisted, refused, ends, loose, bad_models, borders, bare;
} tally;

static const roberts_camera views[] = {
    {.dir = {0.3172, -0.6451, 0.4093}},
    {.dir = {-0.7331, 0.2719, 0.5237}},
};

/* A face's corners along its plane and across it, as parts of its size. */
typedef struct flat_face {
    double x[MOST_CORNERS], y[MOST_CORNERS], off; /* off: how far the farthest corner is from the plane */
    uint32_t count;
} flat_face;

static flat_face flatten(const roberts_mesh *mesh, size_t f)
{
    const uint32_t *corner = mesh->corner + mesh->face_start[f];
    flat_face out = {.count = mesh->face_start[f + 1] - mesh->face_start[f]};
    roberts_vec3 o = mesh->vertex[corner[0]], n = {0, 0, 0}, u = {0, 0, 0};
    for (uint32_t i = 1; i < out.count; i++)
        for (uint32_t k = i + 1; k < out.count; k++) {
            roberts_vec3 a = vec3_sub(mesh->vertex[corner[i]], o),
                         c = vec3_cross(a, vec3_sub(mesh->vertex[corner[k]], o));
            if (vec3_dot(c, c) > vec3_dot(n, n)) {
                n = c;
                u = a;
            }
        }
    roberts_vec3 v = vec3_cross(n, u);
    double nn = sqrt(vec3_dot(n, n)), uu = vec3_dot(u, u), vv = vec3_dot(v, v);
    for (uint32_t i = 0; nn > 0 && i < out.count; i++) {
        roberts_vec3 d = vec3_sub(mesh->vertex[corner[i]], o);
        out.x[i] = vec3_dot(d, u) / uu;
        out.y[i] = vec3_dot(d, v) / sqrt(uu * vv);
        out.off = fmax(out.off, fabs(vec3_dot(d, n)) / nn / sqrt(uu));
    }
    return out;
}

/* Parts of a face's size: one whose corners are no farther from its plane is planar. */
static const double planar = 1e-5;

/* Are all faces planar, as far as is looked? */
static bool is_flat_faced(const roberts_mesh *mesh)
{
    for (size_t f = 0; f < mesh->face_count; f++) {
        const uint32_t n = mesh->face_start[f + 1] - mesh->face_start[f];
        if (n > MOST_CORNERS || (n > 3 && flatten(mesh, f).off > planar))
            return false;
    }
    return true;
}

static double turn(const flat_face *f, uint32_t i, uint32_t k, uint32_t m)
{
    return (f->x[k] - f->x[i]) * (f->y[m] - f->y[i]) - (f->y[k] - f->y[i]) * (f->x[m] - f->x[i]);
}

/* Does the mesh have a face that is not planar and crosses itself? Its sides cross as seen across the face, but not in
 * space, so that no surface is bounded by them. */
static bool is_twisted(const roberts_mesh *mesh)
{
    for (size_t f = 0; f < mesh->face_count; f++) {
        uint32_t n = mesh->face_start[f + 1] - mesh->face_start[f];
        if (n < 4 || n > MOST_CORNERS)
            continue;
        const flat_face flat = flatten(mesh, f);
        if (flat.off <= planar)
            continue;
        for (uint32_t i = 0; i < n; i++)
            for (uint32_t k = 0; k < n; k++) {
                uint32_t p = i, q = (i + 1) % n, r = k, s = (k + 1) % n;
                if (turn(&flat, p, q, r) * turn(&flat, p, q, s) < 0 && turn(&flat, r, s, p) * turn(&flat, r, s, q) < 0)
                    return true;
            }
    }
    return false;
}

/* ---- borders of regions ---- */

/* A side of a ring, its ends in order. */
typedef struct ring_side {
    roberts_vec2 end[2];
    roberts_vec3 normal; /* of the face */
} ring_side;

static int by_ends(const void *a, const void *b)
{
    const ring_side *p = a, *q = b;
    const int order = vec2_compare(p->end[0], q->end[0]);
    return order != 0 ? order : vec2_compare(p->end[1], q->end[1]);
}

static ring_side *list_sides(const roberts_region_list *regions)
{
    ring_side *side = malloc((regions->corner_count + 1) * sizeof *side);
    size_t count = 0;
    assert_non_null(side);
    for (size_t i = 0; i < regions->count; i++) {
        const roberts_region *r = &regions->region[i];
        for (size_t k = r->first_ring; k < r->first_ring + r->ring_count; k++)
            for (size_t first = regions->ring_start[k], end = regions->ring_start[k + 1], c = first; c < end; c++) {
                const roberts_vec2 a = regions->corner[c], b = regions->corner[c + 1 < end ? c + 1 : first];
                const bool turned = vec2_compare(a, b) > 0;
                side[count++] = (ring_side){{turned ? b : a, turned ? a : b}, r->normal};
            }
    }
    qsort(side, count, sizeof *side, by_ends);
    return side;
}

/* Does a visible line go through a point, within `near`? */
static bool has_line(const roberts_drawing *drawing, roberts_vec2 p, double near)
{
    for (size_t i = 0; i < drawing->count; i++) {
        const roberts_segment *s = &drawing->segment[i];
        const double x = s->p1.x - s->p0.x, y = s->p1.y - s->p0.y, length = hypot(x, y);
        const double u = p.x - s->p0.x, v = p.y - s->p0.y;
        if (s->state == ROBERTS_VISIBLE && fabs(x * v - y * u) <= near * length && x * u + y * v >= -near * length &&
            x * u + y * v <= (length + near) * length)
            return true;
    }
    return false;
}

/* How many borders between two regions whose faces lie in different planes have no line, if bodies are drawn as one.
 * A border of a face that is not planar may lie beside its line. Borders shorter than a hundred times `near` do not
 * count. */
static size_t count_bare(const roberts_scene *scene, const roberts_camera *camera, size_t *asked)
{
    roberts_hide_options options = roberts_hide_options_default();
    roberts_region_list regions;
    size_t bare = 0;
    options.all_edges = options.unite = true;
    roberts_drawing drawing = drawing_of(scene, camera, &options);
    assert_int_equal(roberts_regions(scene, camera, &options, &regions, NULL), ROBERTS_OK);
    ring_side *side = list_sides(&regions);
    const double near = LOOSE_END_NEAR * drawing.scene_diameter;
    for (size_t i = 0; i + 1 < regions.corner_count; i++) {
        const roberts_vec2 a = side[i].end[0], b = side[i].end[1];
        const roberts_vec3 n = vec3_sub(side[i].normal, side[i + 1].normal);
        if (by_ends(&side[i], &side[i + 1]) != 0 || vec3_dot(n, n) < 1e-6 || hypot(b.x - a.x, b.y - a.y) < 100 * near)
            continue;
        ++*asked;
        bare += !has_line(&drawing, (roberts_vec2){0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}, near);
    }
    free(side);
    roberts_regions_free(&regions);
    roberts_drawing_free(&drawing);
    return bare;
}

static void walk_model(const char *path, tally *t)
{
    roberts_mesh mesh = {0};
    roberts_scene *scene = NULL;
    roberts_hide_options options = roberts_hide_options_default();
    options.all_edges = true;
    if (roberts_mesh_read_file(&mesh, path, NULL, NULL) != ROBERTS_OK ||
        roberts_scene_build(&mesh, NULL, &scene, NULL) != ROBERTS_OK) {
        t->refused++;
        roberts_mesh_free(&mesh);
        return;
    }
    if (is_twisted(&mesh)) {
        t->twisted++;
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
        return;
    }
    t->models++;
    size_t before = t->loose;
    for (size_t v = 0; v < sizeof views / sizeof views[0]; v++) {
        loose_end end[4];
        size_t asked;
        roberts_drawing drawing = drawing_of(scene, &views[v], &options);
        size_t loose = loose_ends_find(&drawing, end, 4, &asked);
        assert_true(loose != SIZE_MAX);
        t->ends += asked;
        t->loose += loose;
        if (loose && t->bad_models < REPORTS) {
            const roberts_segment *s = &drawing.segment[end[0].segment];
            roberts_vec2 p = end[0].end ? s->p1 : s->p0;
            uint32_t f[2];
            roberts_segment_faces(scene, &drawing, s, f);
            printf("%s: %zu of %zu ends are loose; the first at %.9g, %.9g: %s %ld-%ld, faces %ld and %ld, t %.9g\n"
                   "  build/roberts --all-edges -f csv --dir=%.4f,%.4f,%.4f %s\n",
                   path, loose, asked, p.x, p.y, s->line == ROBERTS_INTERSECTION ? "intersection" : "edge",
                   s->v0 == ROBERTS_NONE ? -1L : (long)s->v0, s->v1 == ROBERTS_NONE ? -1L : (long)s->v1,
                   f[0] == ROBERTS_NONE ? -1L : (long)f[0], f[1] == ROBERTS_NONE ? -1L : (long)f[1],
                   end[0].end ? s->t1 : s->t0, views[v].dir.x, views[v].dir.y, views[v].dir.z, path);
        }
        roberts_drawing_free(&drawing);
    }
    t->bad_models += t->loose > before;
    if (mesh.corner_count <= MOST_COMPARED && is_flat_faced(&mesh)) {
        const size_t bare = count_bare(scene, &views[0], &t->borders);
        if (bare)
            printf("%s: with --union, %zu borders have no line\n", path, bare);
        t->bare += bare;
    }
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(a, b);
}

/* All models in a folder and in those below it. */
static void walk_folder(const char *path, tally *t)
{
    char(*names)[NAME] = malloc(sizeof(char[FILES][NAME]));
    size_t count = 0;
    DIR *folder = opendir(path);
    for (const struct dirent *entry; folder && names && count < FILES && (entry = readdir(folder));)
        if (entry->d_name[0] != '.' && snprintf(names[count], NAME, "%s/%s", path, entry->d_name) < NAME)
            count++;
    if (folder)
        closedir(folder);
    if (names)
        qsort(names, count, NAME, by_name);
    for (size_t i = 0; i < count; i++) {
        const char *ending = strrchr(names[i], '.');
        struct stat about;
        if (stat(names[i], &about) != 0)
            continue;
        if (S_ISDIR(about.st_mode))
            walk_folder(names[i], t);
        else if (ending && !strcmp(ending, ".off")) {
            if (about.st_size > LARGEST_FILE)
                t->left_out++;
            else
                walk_model(names[i], t);
        }
    }
    free(names);
}

static void test_models(void **state)
{
    tally t = {0};
    (void)state;
    walk_folder("models", &t);
    print_message("note: %zu ends of lines of %zu models in two views: %zu loose, of %zu models\n", t.ends, t.models,
                  t.loose, t.bad_models);
    assert_true(t.models > 50 && t.ends > 10000 && t.borders > 1000);
    assert_int_equal(t.loose, 0);
    assert_int_equal(t.bare, 0);
}

static void test_published_models(void **state)
{
    char path[NAME];
    tally t = {0};
    (void)state;
    snprintf(path, sizeof path, "%s/models", shared_folder());
    walk_folder(path, &t);
    if (t.models == 0)
        SKIP_BECAUSE("no models in %s", path);
    print_message("note: %zu ends of lines of %zu published models in two views: %zu loose, of %zu models; left out: "
                  "%zu large files, %zu with a face that crosses itself and is not planar, %zu without a model\n",
                  t.ends, t.models, t.loose, t.bad_models, t.left_out, t.twisted, t.refused);
    print_message("note: %zu borders of regions with --union, %zu without a line\n", t.borders, t.bare);
    assert_int_equal(t.loose, 0);
    assert_int_equal(t.bare, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_by_hand),
        cmocka_unit_test(test_models),
        cmocka_unit_test(test_published_models),
    };
    return cmocka_run_group_tests_name("loose ends", tests, NULL, NULL);
}
