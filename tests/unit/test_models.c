/* The files of models/ and the generator that makes them: the same bytes again, the solids' counts and symmetry against
 * the known table, the scenes for tests 1 to 4 against their own comments, solids that stand on one another exactly. */
#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/sort.h"
#include "build_scene.h"
#include "folders.h"
#include "mesh_corners.h"
#include "model/scene.h"
#include "testing.h"
#include "whole_file.h"

/* How far lengths, distances and planes may be off, as a part of the solid's circumradius or a similar length:
 * coordinates are rounded to 1e-16, and some are sums of a few terms. */
static const double ROUNDING = 1e-12;

enum { PATH_ROOM = 1024, CORNER_MAX = 12 };

static const char *const folders[] = {"",        "platonic/", "archimedean/", "catalan/",
                                      "prisms/", "star/",     "shapes/",      "tests/"};

/* ---- running the generator ------------------------------------------------------------------------------------- */

/* A path for what the tests write; run.sh keeps "out" and "err" for itself. */
static void scratch_path(char *path, const char *name)
{
    snprintf(path, PATH_ROOM, "%s/tests/test_models.%s", build_folder(), name);
}

/* Exit status of make-models with these arguments, its standard output to `output`. */
static int run(const char *arguments, const char *output)
{
    char command[5 * PATH_ROOM], messages[PATH_ROOM];
    int status;
    scratch_path(messages, "messages");
    snprintf(command, sizeof command, "%s/tools/make-models %s >'%s' 2>'%s'", build_folder(), arguments, output,
             messages);
    status = system(command); /* NOLINT(bugprone-command-processor): the shell redirects */
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/* Calls `use` for every .off file of a folder like models/; returns how many there were. */
static size_t each_model(const char *root, void (*use)(const char *path, const char *name))
{
    size_t count = 0;
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        char path[3 * PATH_ROOM], name[PATH_ROOM];
        DIR *folder;
        struct dirent *entry;
        snprintf(path, sizeof path, "%s/%s", root, folders[i]);
        if (!(folder = opendir(path)))
            continue;
        while ((entry = readdir(folder))) {
            const char *dot = strrchr(entry->d_name, '.');
            if (!dot || strcmp(dot, ".off") != 0)
                continue;
            snprintf(name, sizeof name, "%s%s", folders[i], entry->d_name);
            snprintf(path, sizeof path, "%s/%s", root, name);
            use(path, name);
            count++;
        }
        closedir(folder);
    }
    return count;
}

static void remove_model(const char *path, const char *name)
{
    (void)name;
    unlink(path);
}

static void compare_model(const char *path, const char *name)
{
    char again[PATH_ROOM], twin[2 * PATH_ROOM], *a, *b;
    size_t a_size, b_size;
    scratch_path(again, "again");
    snprintf(twin, sizeof twin, "%s/%s", again, name);
    a = whole_file(path, &a_size);
    b = whole_file(twin, &b_size);
    if (a_size != b_size || memcmp(a, b, a_size) != 0)
        fail_msg("%s differs from what the generator writes (make models)", name);
    free(a);
    free(b);
}

static void nothing(const char *path, const char *name)
{
    (void)path, (void)name;
}

static void generator_writes_the_same_bytes(void **state)
{
    char again[PATH_ROOM], output[PATH_ROOM], arguments[2 * PATH_ROOM];
    size_t count;
    (void)state;
    scratch_path(again, "again");
    scratch_path(output, "scene.off");
    each_model(again, remove_model);
    snprintf(arguments, sizeof arguments, "--all '%s'", again);
    assert_int_equal(run(arguments, output), 0);
    count = each_model("models", compare_model);
    assert_true(count > 80);
    assert_int_equal(each_model(again, nothing), count);
}

static void misuse_and_failure(void **state)
{
    static const struct {
        const char *arguments;
        int status;
    } cases[] = {
        {"", 2},
        {"--help", 0},
        {"lattice", 2},
        {"lattice 0", 2},
        {"lattice 2 1", 0},
        {"lattice 2x", 2},
        {"lattice -2", 2},
        {"wall 3 1", 2},
        {"lattice 2 seed", 2},
        {"nonsense 3", 2},
        {"wall 99999999999999999999", 2},
        {"prism 2", 2},
        {"lattice 2 1 1", 2},
        {"--all /dev/null/x", 1},
    };
    char output[PATH_ROOM];
    (void)state;
    scratch_path(output, "scene.off");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        if (run(cases[i].arguments, output) != cases[i].status)
            fail_msg("make-models %s: not status %d", cases[i].arguments, cases[i].status);
    if (access("/dev/full", W_OK) == 0)
        assert_int_equal(run("wall 5000", "/dev/full"), 1);
}

/* ---- reading --------------------------------------------------------------------------------------------------- */

static void no_warning(void *context, const char *file, size_t line, const char *message)
{
    (void)context;
    fail_msg("%s:%zu: %s", file, line, message);
}

static const roberts_warnings strict = {no_warning, NULL};

static roberts_mesh read_mesh(const char *path)
{
    roberts_mesh mesh = {0};
    roberts_error error = {0};
    if (roberts_mesh_read_file(&mesh, path, &strict, &error) != ROBERTS_OK)
        fail_msg("%s:%zu: %s", path, error.line, error.message);
    return mesh;
}

static roberts_scene *scene_of_model(const roberts_mesh *mesh, const char *path)
{
    roberts_scene_options options = {.warnings = strict};
    roberts_scene *scene;
    roberts_error error = {0};
    if (roberts_scene_build(mesh, &options, &scene, &error) != ROBERTS_OK)
        fail_msg("%s: %s", path, error.message);
    return scene;
}

/* What follows the keyword, the comment, which every model has, and the counts. */
static const char *behind_counts(const char *text)
{
    const char *at = strchr(text, '\n') + 1;
    assert_true(strncmp(text, "OFF\n# ", 6) == 0);
    while (*at == '#')
        at = strchr(at, '\n') + 1;
    return strchr(at, '\n') + 1;
}

/* Every coordinate is written as "%.17g" writes it. */
static void check_numbers(const char *path, const char *name)
{
    roberts_mesh mesh = read_mesh(path);
    size_t size;
    char *text = whole_file(path, &size);
    const char *at = behind_counts(text);
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        roberts_vec3 p = mesh.vertex[v];
        char wanted[128];
        int length = snprintf(wanted, sizeof wanted, "%.17g %.17g %.17g\n", p.x, p.y, p.z);
        if (strncmp(at, wanted, (size_t)length) != 0)
            fail_msg("%s: \"%.60s\" instead of \"%s\"", name, at, wanted);
        at += length;
    }
    free(text);
    roberts_mesh_free(&mesh);
}

static void numbers_have_17_digits(void **state)
{
    static const char *const larger[] = {"lattice 12 7", "plates 3000 5", "needles 3000 2",
                                         "coins 70 2",   "sphere 4000",   "prism 999"};
    char output[PATH_ROOM];
    (void)state;
    each_model("models", check_numbers);
    scratch_path(output, "scene.off");
    for (size_t i = 0; i < sizeof larger / sizeof *larger; i++) {
        assert_int_equal(run(larger[i], output), 0);
        check_numbers(output, larger[i]);
    }
}

/* ---- solids ---------------------------------------------------------------------------------------------------- */

typedef enum kind { UNIFORM, DUAL } kind;

typedef struct known_solid {
    const char *name;
    kind kind;
    size_t vertices, edges, faces;
    size_t with_corners[CORNER_MAX + 1]; /* faces of each corner count */
} known_solid;

/* Counts as in H. M. Cundy, A. P. Rollett, "Mathematical Models", 2nd ed. 1961, sections 3.5, 3.7, 3.8. */
static const known_solid known[] = {
    {"platonic/tetrahedron", UNIFORM, 4, 6, 4, {[3] = 4}},
    {"platonic/cube", UNIFORM, 8, 12, 6, {[4] = 6}},
    {"platonic/octahedron", UNIFORM, 6, 12, 8, {[3] = 8}},
    {"platonic/dodecahedron", UNIFORM, 20, 30, 12, {[5] = 12}},
    {"platonic/icosahedron", UNIFORM, 12, 30, 20, {[3] = 20}},
    {"archimedean/truncated-tetrahedron", UNIFORM, 12, 18, 8, {[3] = 4, [6] = 4}},
    {"archimedean/cuboctahedron", UNIFORM, 12, 24, 14, {[3] = 8, [4] = 6}},
    {"archimedean/truncated-cube", UNIFORM, 24, 36, 14, {[3] = 8, [8] = 6}},
    {"archimedean/truncated-octahedron", UNIFORM, 24, 36, 14, {[4] = 6, [6] = 8}},
    {"archimedean/rhombicuboctahedron", UNIFORM, 24, 48, 26, {[3] = 8, [4] = 18}},
    {"archimedean/truncated-cuboctahedron", UNIFORM, 48, 72, 26, {[4] = 12, [6] = 8, [8] = 6}},
    {"archimedean/snub-cube", UNIFORM, 24, 60, 38, {[3] = 32, [4] = 6}},
    {"archimedean/icosidodecahedron", UNIFORM, 30, 60, 32, {[3] = 20, [5] = 12}},
    {"archimedean/truncated-dodecahedron", UNIFORM, 60, 90, 32, {[3] = 20, [10] = 12}},
    {"archimedean/truncated-icosahedron", UNIFORM, 60, 90, 32, {[5] = 12, [6] = 20}},
    {"archimedean/rhombicosidodecahedron", UNIFORM, 60, 120, 62, {[3] = 20, [4] = 30, [5] = 12}},
    {"archimedean/truncated-icosidodecahedron", UNIFORM, 120, 180, 62, {[4] = 30, [6] = 20, [10] = 12}},
    {"archimedean/snub-dodecahedron", UNIFORM, 60, 150, 92, {[3] = 80, [5] = 12}},
    {"catalan/triakis-tetrahedron", DUAL, 8, 18, 12, {[3] = 12}},
    {"catalan/rhombic-dodecahedron", DUAL, 14, 24, 12, {[4] = 12}},
    {"catalan/triakis-octahedron", DUAL, 14, 36, 24, {[3] = 24}},
    {"catalan/tetrakis-hexahedron", DUAL, 14, 36, 24, {[3] = 24}},
    {"catalan/deltoidal-icositetrahedron", DUAL, 26, 48, 24, {[4] = 24}},
    {"catalan/disdyakis-dodecahedron", DUAL, 26, 72, 48, {[3] = 48}},
    {"catalan/pentagonal-icositetrahedron", DUAL, 38, 60, 24, {[5] = 24}},
    {"catalan/rhombic-triacontahedron", DUAL, 32, 60, 30, {[4] = 30}},
    {"catalan/triakis-icosahedron", DUAL, 32, 90, 60, {[3] = 60}},
    {"catalan/pentakis-dodecahedron", DUAL, 32, 90, 60, {[3] = 60}},
    {"catalan/deltoidal-hexecontahedron", DUAL, 62, 120, 60, {[4] = 60}},
    {"catalan/disdyakis-triacontahedron", DUAL, 62, 180, 120, {[3] = 120}},
    {"catalan/pentagonal-hexecontahedron", DUAL, 92, 150, 60, {[5] = 60}},
    {"prisms/prism-3", UNIFORM, 6, 9, 5, {[3] = 2, [4] = 3}},
    {"prisms/prism-5", UNIFORM, 10, 15, 7, {[4] = 5, [5] = 2}},
    {"prisms/prism-6", UNIFORM, 12, 18, 8, {[4] = 6, [6] = 2}},
    {"prisms/prism-8", UNIFORM, 16, 24, 10, {[4] = 8, [8] = 2}},
    {"prisms/prism-10", UNIFORM, 20, 30, 12, {[4] = 10, [10] = 2}},
    {"prisms/prism-12", UNIFORM, 24, 36, 14, {[4] = 12, [12] = 2}},
    {"prisms/antiprism-3", UNIFORM, 6, 12, 8, {[3] = 8}},
    {"prisms/antiprism-4", UNIFORM, 8, 16, 10, {[3] = 8, [4] = 2}},
    {"prisms/antiprism-5", UNIFORM, 10, 20, 12, {[3] = 10, [5] = 2}},
    {"prisms/antiprism-6", UNIFORM, 12, 24, 14, {[3] = 12, [6] = 2}},
    {"prisms/antiprism-8", UNIFORM, 16, 32, 18, {[3] = 16, [8] = 2}},
    {"prisms/antiprism-10", UNIFORM, 20, 40, 22, {[3] = 20, [10] = 2}},
    {"prisms/antiprism-12", UNIFORM, 24, 48, 26, {[3] = 24, [12] = 2}},
};

static void check_counts(const known_solid *k, const roberts_mesh *m)
{
    size_t with_corners[CORNER_MAX + 1] = {0};
    if (m->vertex_count != k->vertices || m->face_count != k->faces || m->corner_count != 2 * k->edges)
        fail_msg("%s: %zu vertices, %zu faces, %zu corners", k->name, m->vertex_count, m->face_count, m->corner_count);
    assert_int_equal(m->vertex_count + m->face_count, k->edges + 2);
    for (size_t f = 0; f < m->face_count; f++) {
        assert_in_range(corner_count(m, f), 3, CORNER_MAX);
        with_corners[corner_count(m, f)]++;
    }
    for (size_t i = 0; i <= CORNER_MAX; i++)
        if (with_corners[i] != k->with_corners[i])
            fail_msg("%s: %zu faces with %zu corners", k->name, with_corners[i], i);
}

/* Each side of a face is, in the other direction, a side of exactly one other: every edge twice. */
static void check_closed(const known_solid *k, const roberts_mesh *m)
{
    for (size_t f = 0; f < m->face_count; f++)
        for (size_t i = 0; i < corner_count(m, f); i++) {
            size_t same = 0, opposite = 0;
            uint32_t u = corner(m, f, i), v = corner(m, f, i + 1);
            for (size_t g = 0; g < m->face_count; g++)
                for (size_t j = 0; j < corner_count(m, g); j++) {
                    same += corner(m, g, j) == u && corner(m, g, j + 1) == v;
                    opposite += corner(m, g, j) == v && corner(m, g, j + 1) == u;
                }
            if (same != 1 || opposite != 1)
                fail_msg("%s: edge %u-%u is in %zu faces and in %zu the other way", k->name, u, v, same, opposite);
        }
}

/* Normals that follow the winding point outward. Corners lie in their face's plane, and all other vertices strictly
 * inside. */
static void check_convex(const known_solid *k, const roberts_mesh *m)
{
    for (size_t f = 0; f < m->face_count; f++) {
        roberts_vec3 n = normal(m, f), o = point(m, f, 0);
        for (uint32_t v = 0; v < m->vertex_count; v++) {
            double height = vec3_dot(n, vec3_sub(m->vertex[v], o));
            bool on = false;
            for (size_t i = 0; i < corner_count(m, f); i++)
                on = on || corner(m, f, i) == v;
            if (on ? fabs(height) > ROUNDING * vec3_length(o) : height > -0.01 * vec3_length(o))
                fail_msg("%s: vertex %u is %g over face %zu", k->name, v, height, f);
        }
    }
}

static void check_equal(const known_solid *k, const char *what, double value, double first)
{
    if (!(fabs(value - first) <= ROUNDING * first))
        fail_msg("%s: %s %.17g and %.17g", k->name, what, value, first);
}

/* Regular faces (equal sides, corners on a sphere, plane), the same around every vertex. */
static void check_uniform(const known_solid *k, const roberts_mesh *m)
{
    double side = distance(point(m, 0, 0), point(m, 0, 1)), radius = vec3_length(m->vertex[0]);
    for (uint32_t v = 0; v < m->vertex_count; v++) {
        check_equal(k, "distances of vertices from the centre", vec3_length(m->vertex[v]), radius);
        assert_int_equal(surroundings(m, v), surroundings(m, 0));
    }
    for (size_t f = 0; f < m->face_count; f++)
        for (size_t i = 0; i < corner_count(m, f); i++)
            check_equal(k, "edges", distance(point(m, f, i), point(m, f, i + 1)), side);
}

/* Lengths of sides and diagonals of face f in order: the same for congruent faces. */
static size_t lengths(const roberts_mesh *m, size_t f, double *length)
{
    size_t count = 0, n = corner_count(m, f);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < i; j++)
            length[count++] = distance(point(m, f, i), point(m, f, j));
    qsort(length, count, sizeof *length, compare_doubles);
    return count;
}

/* Congruent faces, a sphere that touches all faces, a sphere that touches all edges. */
static void check_dual(const known_solid *k, const roberts_mesh *m)
{
    double inradius = vec3_dot(normal(m, 0), point(m, 0, 0)), midradius = 0, first[10], length[10];
    size_t count = lengths(m, 0, first);
    for (size_t f = 0; f < m->face_count; f++) {
        check_equal(k, "distances of faces from the centre", vec3_dot(normal(m, f), point(m, f, 0)), inradius);
        assert_int_equal(lengths(m, f, length), count);
        for (size_t i = 0; i < count; i++)
            check_equal(k, "lengths in faces", length[i], first[i]);
        for (size_t i = 0; i < corner_count(m, f); i++) {
            roberts_vec3 a = point(m, f, i), b = point(m, f, i + 1);
            double from_edge = vec3_length(vec3_cross(a, b)) / distance(a, b);
            midradius = midradius > 0 ? midradius : from_edge;
            check_equal(k, "distances of edges from the centre", from_edge, midradius);
        }
    }
}

static void solids_are_what_they_are_called(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const known_solid *k = &known[i];
        char path[PATH_ROOM];
        roberts_mesh mesh;
        snprintf(path, sizeof path, "models/%s.off", k->name);
        mesh = read_mesh(path);
        check_counts(k, &mesh);
        check_closed(k, &mesh);
        check_convex(k, &mesh);
        if (k->kind == UNIFORM)
            check_uniform(k, &mesh);
        else
            check_dual(k, &mesh);
        roberts_mesh_free(&mesh);
    }
}

/* ---- the scenes for tests 1 to 4 ------------------------------------------------------------------------------- */

/* What the comment of a scene claims about edge AB and face 0, and what the definitions give. Coordinates are small
 * integers and crossings lie at halves and quarters, so that all of it is exact. */
typedef struct outcome {
    int test;
    double t0, t1; /* hidden part; empty where t0 >= t1 */
} outcome;

/* A number or a fraction. */
static double fraction(const char *text)
{
    char *end;
    double above = strtod(text, &end);
    return *end == '/' ? above / strtod(end + 1, NULL) : above;
}

static outcome claim(const char *name, const char *text)
{
    outcome said = {0, 0, 1};
    char line[256], from[16], to[16];
    const char *at = strstr(text, "\n# test "), *end;
    assert_non_null(at);
    said.test = at[8] - '0';
    if (sscanf(at + 9, ": %255[^\n]", line) != 1)
        fail_msg("%s: claims nothing", name);
    end = strrchr(line, ';');
    if (end && !strcmp(end, "; visible."))
        said.t1 = 0;
    else if (end && sscanf(end, "; hidden for %15s <= t <= %15[^.].", from, to) == 2)
        said.t0 = fraction(from), said.t1 = fraction(to);
    else if (!end || strcmp(end, "; hidden.") != 0)
        fail_msg("%s: claims neither visible nor hidden", name);
    return said;
}

/* Twice the area of abc in the picture: > 0 where a, b, c turn counter-clockwise. */
static double turning(roberts_vec3 a, roberts_vec3 b, roberts_vec3 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* Test 2: the corners lie on one side of the sight plane through AB, at most one of them on it. */
static bool beside(const roberts_mesh *m, roberts_vec3 A, roberts_vec3 B)
{
    int sum = 0, n = (int)corner_count(m, 0);
    for (size_t i = 0; i < corner_count(m, 0); i++) {
        double Q = turning(A, B, point(m, 0, i));
        sum += (Q > 0) - (Q < 0);
    }
    return abs(sum) >= n - 1;
}

/* The part of 0 <= t <= 1 where a value that runs evenly from a to b is at least 0, cut from `o`. */
static void keep_positive(outcome *o, double a, double b)
{
    if (a < 0 && b < 0)
        o->t1 = o->t0;
    else if (a < 0)
        o->t0 = fmax(o->t0, a / (a - b));
    else if (b < 0)
        o->t1 = fmin(o->t1, a / (a - b));
}

/* Tests 1 to 4 by their definition, on edge 8-9 and face 0. */
static outcome decide(const roberts_mesh *m)
{
    roberts_vec3 A = m->vertex[8], B = m->vertex[9], n = normal(m, 0), P0 = point(m, 0, 0);
    double FA = vec3_dot(n, vec3_sub(P0, A)), FB = vec3_dot(n, vec3_sub(P0, B));
    bool inside = true, outside = false;
    outcome o = {4, 0, 1};
    if (FA <= 0 && FB <= 0)
        return (outcome){1, 0, 0};
    if (beside(m, A, B))
        return (outcome){2, 0, 0};
    for (size_t i = 0; i < corner_count(m, 0); i++) {
        double a = turning(point(m, 0, i), point(m, 0, i + 1), A), b = turning(point(m, 0, i), point(m, 0, i + 1), B);
        inside = inside && a >= 0 && b >= 0;
        outside = outside || (a <= 0 && b <= 0 && (a < 0 || b < 0));
        keep_positive(&o, a, b);
    }
    if (inside || outside)
        o.test = 3;
    if (outside)
        return (outcome){3, 0, 0};
    keep_positive(&o, FA, FB);
    return o.t0 < o.t1 ? o : (outcome){o.test, 0, 0};
}

static uint64_t decided_by(const roberts_tally *t, int test)
{
    const uint64_t decided[] = {0, t->test1_visible, t->test2_visible, t->test3_visible + t->test3_invisible, t->test4};
    return decided[test];
}

/* Hidden part of edge 8-9 in the library's drawing from the top; `said`: the test that decided, if --stats counts it,
 * else -1. */
static outcome drawn(const roberts_mesh *m, const char *name, int said)
{
    roberts_scene *scene = scene_of_model(m, name);
    roberts_hide_options options = roberts_hide_options_default();
    outcome o = {-1, 0, 0};
    double shown = 0;
    options.keep_hidden = true;
    roberts_camera camera = preset_camera("top");
    roberts_drawing drawing = drawing_of(scene, &camera, &options);
    for (size_t i = 0; i < drawing.count; i++) {
        const roberts_segment *s = &drawing.segment[i];
        if (s->v0 != 8 || s->v1 != 9)
            continue;
        if (s->line == ROBERTS_BACK || s->line == ROBERTS_BACK_OUTLINE)
            fail_msg("%s: edge 8-9 is hidden by its own solid", name);
        if (s->state == ROBERTS_HIDDEN)
            o.t0 = s->t0, o.t1 = s->t1;
        else
            shown += s->t1 - s->t0;
    }
    if (decided_by(&drawing.tally, said) > 0)
        o.test = said;
    if (fabs(shown + o.t1 - o.t0 - 1) > ROUNDING)
        fail_msg("%s: edge 8-9 is shown for %g and hidden from %g to %g", name, shown, o.t0, o.t1);
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
    return o;
}

static size_t outcomes_seen[5];

static void check_case(const char *path, const char *name)
{
    size_t size;
    char *text;
    outcome said, defined, seen;
    roberts_mesh mesh;
    if (strncmp(name, "tests/", 6) != 0)
        return;
    text = whole_file(path, &size);
    mesh = read_mesh(path);
    said = claim(name, text);
    defined = decide(&mesh);
    if (said.test != defined.test || said.t0 != defined.t0 || said.t1 != defined.t1)
        fail_msg("%s: test %d, hidden from %g to %g", name, defined.test, defined.t0, defined.t1);
    assert_in_range(said.test, 1, 4);
    seen = drawn(&mesh, name, said.test);
    if (seen.test != said.test)
        fail_msg("%s: drawn, but test %d decided nothing", name, said.test);
    if (fabs(seen.t0 - said.t0) > ROUNDING || fabs(seen.t1 - said.t1) > ROUNDING)
        fail_msg("%s: drawn as hidden from %.17g to %.17g", name, seen.t0, seen.t1);
    outcomes_seen[said.test]++;
    roberts_mesh_free(&mesh);
    free(text);
}

static void cases_have_the_outcome_they_claim(void **state)
{
    (void)state;
    each_model("models", check_case);
    for (int test = 1; test <= 4; test++)
        assert_true(outcomes_seen[test] >= 3);
}

/* ---- scenes ---------------------------------------------------------------------------------------------------- */

static void check_builds(const char *path, const char *name)
{
    roberts_mesh mesh = read_mesh(path);
    roberts_scene *scene = scene_of_model(&mesh, name);
    size_t count = roberts_scene_vertex_count(scene);
    bool crosses_itself = strncmp(name, "star/", 5) == 0; /* then points where sides cross may have been added */
    if (crosses_itself ? count < mesh.vertex_count : count != mesh.vertex_count)
        fail_msg("%s: %zu vertices", name, count);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
}

static void all_models_are_scenes_without_a_warning(void **state)
{
    (void)state;
    each_model("models", check_builds);
}

static void families_have_the_number_of_solids_they_promise(void **state)
{
    static const struct {
        const char *arguments;
        size_t solids, faces; /* faces: 0 where random */
    } cases[] = {
        {"lattice 1 9", 1, 0},
        {"lattice 6 4", 216, 0},
        {"city 1 3", 4, 0},
        {"city 9 5", 324, 0},
        {"wall 1", 1, 6},
        {"wall 2", 2, 12},
        {"wall 3", 3, 18},
        {"wall 1000", 1000, 6000},
        {"plates 1", 1, 6},
        {"plates 2000 8", 2000, 12000},
        {"galaxy 100 3", 100, 600},
        {"posts 10", 10, 60},
        {"shells 10", 10, 60},
        {"plain 2", 17, 0},
        {"stack 1", 1, 6},
        {"stack 500 2", 500, 3000},
        {"needles 1 1", 1, 6},
        {"needles 200", 200, 1200},
        {"ground 1", 2, 12},
        {"ground 10 3", 11, 66},
        {"copies 1", 1, 6},
        {"copies 50", 50, 300},
        {"coins 3", 100, 500},
        {"coins 100 4", 100, 10200},
        {"disc 3", 4, 23},
        {"disc 200 2", 201, 1402},
        {"parts 1", 2, 12},
        {"parts 100", 101, 1002},
        {"speck 8", 3, 22},
        {"speck 5000", 3, 10006},
        {"fans 3", 2, 8},
        {"fans 100", 2, 202},
        {"layers 3", 10, 50},
        {"layers 100", 10, 1020},
        {"roof 1", 1, 1},
        {"roof 100", 1, 100},
        {"deck 10", 13, 78},
        {"deck 100", 103, 618},
        {"gear 3", 1, 8},
        {"gear 100", 1, 202},
        {"sphere 8", 1, 8},
        {"sphere 5000", 1, 5000},
        {"prism 3", 1, 5},
        {"prism 4000", 1, 4002},
        {"antiprism 3", 1, 8},
        {"antiprism 1001", 1, 2004},
        {"scan 20", 1, 20},
        {"scan 5000", 1, 20 * 15 * 15},
        {"balls 20000", 1000, 20000},
        {"balls 80000", 1000, 80000},
        {"boulders 80000", 1000, 80000},
        {"crossing 80000", 1000, 80000},
        {"terrain 2", 1, 2},
        {"terrain 5000", 1, 5000},
        {"stars 1", 1, 0},
        {"stars 4", 64, 0},
        {"soup 1", 1, 1},
        {"soup 500", 500, 500},
    };
    char output[PATH_ROOM];
    (void)state;
    scratch_path(output, "scene.off");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        roberts_mesh mesh;
        roberts_scene *scene;
        assert_int_equal(run(cases[i].arguments, output), 0);
        mesh = read_mesh(output);
        scene = scene_of_model(&mesh, cases[i].arguments);
        if (roberts_scene_solid_count(scene) != cases[i].solids ||
            (cases[i].faces && mesh.face_count != cases[i].faces))
            fail_msg("%s: %zu solids, %zu faces", cases[i].arguments, roberts_scene_solid_count(scene),
                     mesh.face_count);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

/* The faces of a crystal's forms: as many of each as its symmetry requires, none cut off by others. */
static void figures_have_the_faces_they_promise(void **state)
{
    static const struct {
        const char *model;
        size_t solids;
        size_t faces[8]; /* of the first solids; 0: not counted */
    } cases[] = {
        {"chair", 17, {6, 6, 6, 6, 6, 6, 6, 6}},
        {"spiral-staircase", 2 + 26 + 26 + 25, {34, 18, 6, 6}},
        {"octahedra", 216, {8, 8, 8, 8, 8, 8, 8, 8}},
        {"icosahedra", 144, {20, 20, 20, 20, 20, 20, 20, 20}},
        {"cubic-space", 64 + 3 * 48, {6, 6, 6, 6, 6, 6, 6, 6}},
        {"platonic-solids", 6, {6, 4, 6, 8, 12, 20}},
        {"archimedean-solids", 13, {8, 14, 14, 14, 26, 26, 38, 32}},
        {"compound-of-five-tetrahedra", 5, {4, 4, 4, 4, 4}},
        {"menger-sponge", 20 * 20, {6, 6, 6, 6, 6, 6, 6, 6}},
        {"locomotive", 54, {6, 6, 6, 6, 6, 6, 6, 6}},
        {"crystals", 8, {6 + 8, 12 + 24, 12 + 6, 4 + 8, 6 + 6 + 6, 12 + 6, 4 + 4 + 8 + 2, 8 + 8 + 4 + 2}},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char path[PATH_ROOM];
        snprintf(path, sizeof path, "models/%s.off", cases[i].model);
        roberts_mesh mesh = read_mesh(path);
        roberts_scene *scene = scene_of_model(&mesh, path);
        print_message("%s: %u solids\n", path, (unsigned)scene->solid_count);
        assert_int_equal(scene->solid_count, cases[i].solids);
        for (int s = 0; s < 8 && cases[i].faces[s]; s++)
            assert_int_equal(scene->solid[s + 1].face - scene->solid[s].face, cases[i].faces[s]);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

/* Five regular tetrahedra; together they have each corner of a dodecahedron once. */
static void five_tetrahedra_are_regular(void **state)
{
    const char *path = "models/compound-of-five-tetrahedra.off";
    roberts_mesh mesh = read_mesh(path);
    (void)state;
    assert_int_equal(mesh.vertex_count, 20);
    for (uint32_t v = 0; v < 20; v++)
        for (uint32_t w = 0; w < v; w++) {
            double apart = vec3_length(vec3_sub(mesh.vertex[v], mesh.vertex[w]));
            if (v / 4 == w / 4)
                assert_true(fabs(apart - sqrt(8)) < 1e-12);
            else
                assert_true(apart > 1);
        }
    roberts_mesh_free(&mesh);
}

static void seeds_make_a_difference(void **state)
{
    char output[PATH_ROOM], *first, *second;
    size_t size;
    (void)state;
    scratch_path(output, "scene.off");
    assert_int_equal(run("lattice 3 1", output), 0);
    first = whole_file(output, &size);
    assert_int_equal(run("lattice 3 2", output), 0);
    second = whole_file(output, &size);
    assert_string_not_equal(behind_counts(first), behind_counts(second));
    free(first);
    free(second);
}

/* Lowest and highest point of a solid. */
static void z_range(const roberts_scene *scene, uint32_t solid, double *lo, double *hi)
{
    *lo = INFINITY;
    *hi = -INFINITY;
    for (uint32_t v = scene->solid[solid].vertex; v < scene->solid[solid + 1].vertex; v++) {
        *lo = fmin(*lo, scene->point[v].z);
        *hi = fmax(*hi, scene->point[v].z);
    }
}

/* Every solid stands on the floor or on another one, or hangs under one, at exactly the same z. */
static void nothing_floats(void **state)
{
    static const char *const scenes[] = {"table",     "temple",     "tower", "stacked-blocks",
                                         "staircase", "brick-wall", "city",  "platonic-solids"};
    (void)state;
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        char path[PATH_ROOM];
        roberts_mesh mesh;
        roberts_scene *scene;
        snprintf(path, sizeof path, "models/%s.off", scenes[i]);
        mesh = read_mesh(path);
        scene = scene_of_model(&mesh, path);
        for (uint32_t s = 0; s < scene->solid_count; s++) {
            double lo, hi, other_lo, other_hi;
            bool held;
            z_range(scene, s, &lo, &hi);
            held = lo == scene->box_min.z;
            for (uint32_t t = 0; t < scene->solid_count && !held; t++) {
                z_range(scene, t, &other_lo, &other_hi);
                held = t != s && (other_hi == lo || other_lo == hi);
            }
            if (!held)
                fail_msg("%s: solid %u floats at z = %.17g", path, s, lo);
        }
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(generator_writes_the_same_bytes),
        cmocka_unit_test(misuse_and_failure),
        cmocka_unit_test(numbers_have_17_digits),
        cmocka_unit_test(solids_are_what_they_are_called),
        cmocka_unit_test(cases_have_the_outcome_they_claim),
        cmocka_unit_test(all_models_are_scenes_without_a_warning),
        cmocka_unit_test(families_have_the_number_of_solids_they_promise),
        cmocka_unit_test(figures_have_the_faces_they_promise),
        cmocka_unit_test(five_tetrahedra_are_regular),
        cmocka_unit_test(seeds_make_a_difference),
        cmocka_unit_test(nothing_floats),
    };
    return cmocka_run_group_tests_name("models", tests, NULL, NULL);
}
