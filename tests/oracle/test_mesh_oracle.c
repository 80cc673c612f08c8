/* test_mesh_oracle.c - bodies of any kind: the mesh oracle against cases worked out by hand; then the library
 * against the oracle on scenes of each family (more: make check-long) and on published models. */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "oracle/judge.h"
#include "oracle/mesh_families.h"
#include "folders.h"
#include "make_mesh.h"
#include "testing.h"

enum {
    EDGES_OF_EACH = 50000 / 36, /* and intersection lines, of each family */
    LARGEST_FILE = 6000,        /* bytes; the oracle compares each edge with each face */
    FILES = 1000,
    NAME = 300,
};

/* ---- by hand ---- */

/* Scenes seen from +z. Edge 0-1: what of it bounds something, and what of it is hidden. */
static const struct {
    const char *name, *off;
    bool even_odd;
    size_t edges, parts, count;
    oracle_interval part[2], hidden[2];
} hand_cases[] = {
    {"a triangle over an edge",
     "6 2 0\n0 0 0\n8 0 0\n0 -9 0\n2 -1 1\n4 -1 1\n3 2 1\n3 0 1 2\n3 3 4 5\n",
     false,
     6,
     1,
     1,
     {{0, 1}},
     {{7.0 / 24, 11.0 / 24}}},
    {"the same under the edge",
     "6 2 0\n0 0 0\n8 0 0\n0 -9 0\n2 -1 -1\n4 -1 -1\n3 2 -1\n3 0 1 2\n3 3 4 5\n",
     false,
     6,
     1,
     0,
     {{0, 1}},
     {{0, 0}}},
    {"a border that goes round twice",
     "11 2 0\n-2 3 0\n10 3 0\n4 20 0\n0 0 1\n8 0 1\n8 8 1\n0 8 1\n2 2 1\n6 2 1\n6 6 1\n2 6 1\n3 0 1 2\n"
     "8 3 4 5 6 7 8 9 10\n",
     false,
     11,
     1,
     1,
     {{0, 1}},
     {{3.0 / 12, 10.0 / 12}}},
    {"... by the odd rule",
     "11 2 0\n-2 3 0\n10 3 0\n4 20 0\n0 0 1\n8 0 1\n8 8 1\n0 8 1\n2 2 1\n6 2 1\n6 6 1\n2 6 1\n3 0 1 2\n"
     "8 3 4 5 6 7 8 9 10\n",
     true,
     11,
     1,
     2,
     {{0, 1}},
     {{3.0 / 12, 11.0 / 36}, {8.0 / 12, 10.0 / 12}}},
    {"a hole, and a slit that is no edge",
     "11 2 0\n-2 4 0\n10 4 0\n4 20 0\n0 0 1\n8 0 1\n8 8 1\n0 8 1\n2 2 1\n2 6 1\n6 6 1\n6 2 1\n3 0 1 2\n"
     "10 3 4 5 6 3 7 8 9 10 7\n",
     false,
     11,
     1,
     2,
     {{0, 1}},
     {{2.0 / 12, 4.0 / 12}, {8.0 / 12, 10.0 / 12}}},
    {"a spike, whose two sides end in different places",
     "10 2 0\n-2 4 0\n10 4 0\n4 20 0\n0 0 1\n4 0 1\n4 4 1\n8 4 1\n6 4 1\n4 8 1\n0 8 1\n3 0 1 2\n"
     "7 3 4 5 6 7 8 9\n",
     false,
     9,
     1,
     1,
     {{0, 1}},
     {{2.0 / 12, 8.0 / 12}}},
    {"a bow-tie, whose halves run either way",
     "7 2 0\n-2 3 0\n10 3 0\n4 20 0\n0 0 1\n8 8 1\n8 0 1\n0 8 1\n3 0 1 2\n4 3 4 5 6\n",
     false,
     7,
     1,
     2,
     {{0, 1}},
     {{2.0 / 12, 5.0 / 12}, {7.0 / 12, 10.0 / 12}}},
    {"a side that turns back on itself",
     "5 1 0\n0 0 0\n8 0 0\n4 0 0\n4 8 0\n0 8 0\n5 0 1 2 3 4\n",
     false,
     4,
     1,
     0,
     {{0, 0.5}},
     {{0, 0}}},
};

static void check_intervals(const char *what, const oracle_interval *is, size_t is_count, const oracle_interval *wanted,
                            size_t count)
{
    if (is_count != count)
        fail_msg("%s: %zu intervals, not %zu", what, is_count, count);
    for (size_t i = 0; i < count; i++)
        if (judge_outside(&is[i], 1, &wanted[i], 1) + judge_outside(&wanted[i], 1, &is[i], 1) > 1e-14)
            fail_msg("%s: %.17g to %.17g, not %.17g to %.17g", what, is[i].t0, is[i].t1, wanted[i].t0, wanted[i].t1);
}

static void test_by_hand(void **state)
{
    const oracle_view top = {.z = 1};
    (void)state;
    for (size_t i = 0; i < sizeof hand_cases / sizeof hand_cases[0]; i++) {
        mesh_truth truth;
        char text[1000];
        print_message("%s\n", hand_cases[i].name);
        snprintf(text, sizeof text, "OFF\n%s", hand_cases[i].off);
        roberts_mesh mesh = mesh_of_text(text);
        assert_true(mesh_truth_find(&mesh, &top, hand_cases[i].even_odd, &truth));
        assert_int_equal(truth.edge_count, hand_cases[i].edges);
        const mesh_edge *e = &truth.edge[0];
        assert_true(e->v0 == 0 && e->v1 == 1);
        check_intervals("bounds", truth.part + e->part, e->parts, hand_cases[i].part, hand_cases[i].parts);
        check_intervals("hidden", truth.interval + e->first, e->count, hand_cases[i].hidden, hand_cases[i].count);
        mesh_truth_free(&truth);
        roberts_mesh_free(&mesh);
    }
}

/* ---- the library ---- */

static size_t compared(const mesh_total *total)
{
    return total->edges + total->lines;
}

/* Some scenes of each family, until so many of its edges and lines have been compared. */
static void test_families(void **state)
{
    mesh_total total = {0};
    (void)state;
    for (size_t f = 0; f < mesh_family_count(); f++)
        for (size_t seed = 1, first = compared(&total); compared(&total) < first + EDGES_OF_EACH && seed < 10000;
             seed++) {
            char name[64];
            mesh_scene scene;
            snprintf(name, sizeof name, "%s-%zu", mesh_family_name(f), seed);
            assert_true(mesh_family_make(f, seed, &scene));
            mesh_judge(name, &scene, build_folder(), &total, stdout);
            mesh_scene_free(&scene);
            if (total.disagreements > 100)
                break;
        }
    print_message(
        "note: %zu edges and %zu intersection lines and lines of unions of %zu scenes of %zu families of bodies "
        "of any kind compared with the exact oracle: %zu disagreements\n",
        total.edges, total.lines, total.scenes, mesh_family_count(), total.disagreements);
    assert_true(compared(&total) >= mesh_family_count() * EDGES_OF_EACH);
    assert_true(total.lines > total.edges / 10);
    assert_true(total.cut > total.edges / 20); /* scenes in which little is cut would show little */
    assert_int_equal(total.refused, 0);
    assert_int_equal(total.disagreements, 0);
}

/* Judges one scene. */
static void judge_seed(const char *family, uint64_t seed, mesh_total *total)
{
    for (size_t f = 0; f < mesh_family_count(); f++) {
        char name[64];
        mesh_scene scene;
        if (strcmp(family, mesh_family_name(f)) != 0)
            continue;
        snprintf(name, sizeof name, "%s-%llu", family, (unsigned long long)seed);
        assert_true(mesh_family_make(f, seed, &scene));
        mesh_judge(name, &scene, build_folder(), total, stdout);
        mesh_scene_free(&scene);
    }
}

/* Scenes on which the library and the oracle disagreed before, or would if a rule below were left out. */
static void test_earlier_disagreements(void **state)
{
    static const struct {
        const char *family;
        uint64_t seed;
    } scenes[] = {
        {"stars", 7220011}, /* the tip of a spike bounds nothing, so the scene's box does not hold it */
        {"stars", 7320012}, /* a flat side inside a star runs in another face: it is an intersection */
        {"stars", 367},     /* ... and is two lines, since the star's border crosses it there */
        {"ridges", 665},    /* a wall given twice has a border: it is no edge of two faces */
        {"soup", 974},      /* an open edge crosses another one in the middle of a part: its faces do not end there */
        {"soup", 1096},     /* ... so they hide the line */
        {"five-tetrahedra", 41327}, /* two are the same: both cross the others, with and without hidden lines */
        {"touching", 41253},        /* lines on flat edges where the grid's cells are small, since faces crowd there */
    };
    mesh_total total = {0};
    (void)state;
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++)
        judge_seed(scenes[i].family, scenes[i].seed, &total);
    assert_int_equal(total.scenes, sizeof scenes / sizeof *scenes);
    assert_int_equal(total.refused, 0);
    assert_int_equal(total.disagreements, 0);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(a, b);
}

/* All models of a folder that are not too large. What is no model is left out. */
static void judge_folder(const char *path, mesh_total *total, size_t *refused)
{
    static char names[FILES][NAME];
    size_t count = 0;
    DIR *folder = opendir(path);
    if (!folder)
        return;
    for (const struct dirent *entry; count < FILES && (entry = readdir(folder));) {
        const char *ending = strrchr(entry->d_name, '.');
        if (ending && !strcmp(ending, ".off") && strlen(entry->d_name) < NAME)
            strcpy(names[count++], entry->d_name);
    }
    closedir(folder);
    qsort(names, count, NAME, by_name);
    for (size_t i = 0; i < count; i++) {
        char file[2 * NAME + 2];
        struct stat about;
        mesh_scene scene = {.view = {.x = 3, .y = -6, .z = 4}, .slack = 1e-9};
        if (snprintf(file, sizeof file, "%s/%s", path, names[i]) >= (int)sizeof file)
            continue;
        if (stat(file, &about) != 0 || about.st_size > LARGEST_FILE)
            continue;
        if (roberts_mesh_read_file(&scene.mesh, file, NULL, NULL) == ROBERTS_OK)
            mesh_judge(names[i], &scene, build_folder(), total, stdout);
        else
            ++*refused;
        mesh_scene_free(&scene);
    }
}

static void test_published_models(void **state)
{
    char path[NAME];
    mesh_total total = {0};
    size_t refused = 0;
    (void)state;
    snprintf(path, sizeof path, "%s/models", shared_folder());
    judge_folder(path, &total, &refused);
    if (total.scenes == 0)
        SKIP_BECAUSE("no models in %s", path);
    snprintf(path, sizeof path, "%s/models/catalogue", shared_folder());
    judge_folder(path, &total, &refused);
    print_message(
        "note: %zu edges and %zu intersection lines of %zu published models compared with the exact oracle: %zu "
        "disagreements; %.3g of them not judged; left out: %zu models with faces that are not planar, %zu files "
        "without "
        "a model\n",
        total.edges, total.lines, total.scenes - total.refused, total.disagreements, total.unjudged, total.refused,
        refused);
    assert_int_equal(total.disagreements, 0);
}

/* models/star and models/shapes: none is refused, but for those whose faces are meant to be twisted. */
static void test_own_models(void **state)
{
    mesh_total total = {0};
    size_t refused = 0;
    (void)state;
    judge_folder("models/star", &total, &refused);
    judge_folder("models/shapes", &total, &refused);
    print_message("note: %zu edges and %zu intersection lines of %zu models compared with the exact oracle: %zu "
                  "disagreements; left out: %zu\n",
                  total.edges, total.lines, total.scenes - total.refused, total.disagreements, total.refused);
    assert_int_equal(refused, 0);
    assert_true(total.scenes - total.refused >= 20);
    assert_int_equal(total.disagreements, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_by_hand),
        cmocka_unit_test(test_families),
        cmocka_unit_test(test_earlier_disagreements),
        cmocka_unit_test(test_own_models),
        cmocka_unit_test(test_published_models),
    };
    return cmocka_run_group_tests_name("mesh oracle", tests, NULL, NULL);
}
