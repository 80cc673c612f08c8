/* test_region_oracle.c - visible regions: the region oracle against areas worked out by hand; the judge against wrong
 * tables; then the library against the oracle on scenes of each family. (More: build/tests/oracle/region_compare.) */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "oracle/mesh_families.h"
#include "oracle/region_judge.h"
#include "folders.h"
#include "make_mesh.h"
#include "testing.h"

enum { SEEDS = 8 /* scenes of each family */, WRONG_SEEDS = 2, FACES = 4 };

/* ---- by hand ---- */

#define SQUARE "0 0 0\n4 0 0\n4 4 0\n0 4 0\n"

/* Scenes seen from +z: the area and the length of the border of what is seen of each face. */
static const struct {
    const char *name, *off;
    bool even_odd;
    double area[FACES], length[FACES];
} hand_cases[] = {
    {"a square", "4 1 0\n" SQUARE "4 0 1 2 3\n", false, {16}, {16}},
    {"a square before another: a hole",
     "8 2 0\n" SQUARE "1 1 1\n2 1 1\n2 2 1\n1 2 1\n4 0 1 2 3\n4 4 5 6 7\n",
     false,
     {15, 1},
     {20, 4}},
    {"the same behind it",
     "8 2 0\n" SQUARE "1 1 -1\n2 1 -1\n2 2 -1\n1 2 -1\n4 0 1 2 3\n4 4 5 6 7\n",
     false,
     {16},
     {16}},
    {"in one plane: the first is seen",
     "8 2 0\n" SQUARE "2 2 0\n6 2 0\n6 6 0\n2 6 0\n4 0 1 2 3\n4 4 5 6 7\n",
     false,
     {16, 12},
     {16, 16}},
    {"they cross in the middle",
     "8 2 0\n" SQUARE "0 0 -1\n4 0 1\n4 4 1\n0 4 -1\n4 0 1 2 3\n4 4 5 6 7\n",
     false,
     {8, 8},
     {12, 12}},
    {"a wall that is edge-on",
     "8 2 0\n" SQUARE "2 0 0\n2 4 0\n2 4 1\n2 0 1\n4 0 1 2 3\n4 4 5 6 7\n",
     false,
     {16},
     {16}},
    {"a band before a square: two pieces",
     "8 2 0\n" SQUARE "1 -1 1\n2 -1 1\n2 5 1\n1 5 1\n4 0 1 2 3\n4 4 5 6 7\n",
     false,
     {12, 6},
     {10 + 12, 14}},
    {"a border that goes round its middle twice, by the odd rule",
     "8 1 0\n" SQUARE "0 0 0\n2 0 0\n2 2 0\n0 2 0\n8 0 1 2 3 4 5 6 7\n",
     true,
     {12},
     {16}},
    {"a slit to a hole", "8 1 0\n" SQUARE "1 1 0\n1 2 0\n2 2 0\n2 1 0\n10 0 1 2 3 0 4 5 6 7 4\n", false, {15}, {20}},
};

/* Adds up what the oracle says about one face. */
static void measure(const region_truth *truth, uint32_t face, double *area, double *length)
{
    *area = *length = 0;
    for (size_t i = 0; i < truth->piece_count; i++) {
        const region_piece *b = &truth->piece[i];
        const int side = (b->left == face) - (b->right == face);
        *area += 0.5 * side * (b->p.x * b->q.y - b->p.y * b->q.x);
        *length += side ? hypot(b->q.x - b->p.x, b->q.y - b->p.y) : 0;
    }
}

static mesh_scene scene_of(const char *off)
{
    char text[600];
    snprintf(text, sizeof text, "OFF\n%s", off);
    return (mesh_scene){.mesh = mesh_of_text(text), .view = {.z = 1}};
}

static void test_by_hand(void **state)
{
    static const uint32_t rank[FACES] = {0, 1, 2, 3};
    (void)state;
    for (size_t i = 0; i < sizeof hand_cases / sizeof *hand_cases; i++) {
        mesh_scene scene = scene_of(hand_cases[i].off);
        region_total total = {0};
        region_truth truth;
        scene.even_odd = hand_cases[i].even_odd;
        assert_true(region_truth_find(&scene.mesh, &scene.view, scene.even_odd, rank, &truth));
        for (uint32_t f = 0; f < scene.mesh.face_count; f++) {
            double area, length;
            measure(&truth, f, &area, &length);
            if (fabs(fabs(area) - hand_cases[i].area[f]) > 1e-12 || fabs(length - hand_cases[i].length[f]) > 1e-12)
                fail_msg("%s: face %u: area %g, length %g", hand_cases[i].name, f, area, length);
        }
        region_truth_free(&truth);
        assert_true(region_judge(hand_cases[i].name, &scene, build_folder(), &total, stdout));
        mesh_scene_free(&scene);
    }
}

/* ---- wrong tables ---- */

/* Moves a corner by a millionth of the picture, in a direction that hardly any border has. */
static void move_corner(roberts_region_list *list)
{
    double size = 0;
    for (size_t i = 0; i < list->corner_count; i++)
        size = fmax(size, fmax(fabs(list->corner[i].x), fabs(list->corner[i].y)));
    list->corner[list->corner_count / 2].x += 1e-6 * size;
    list->corner[list->corner_count / 2].y += 0.618e-6 * size;
}

static void swap_faces(roberts_region_list *list)
{
    const uint32_t face = list->region[0].face;
    list->region[0].face = list->region[list->count - 1].face;
    list->region[list->count - 1].face = face;
}

static void drop_region(roberts_region_list *list)
{
    list->count--;
}

static void drop_ring(roberts_region_list *list)
{
    list->region[list->count - 1].ring_count--;
}

/* Of the largest region: a sliver's area may be less than what the judge allows. */
static void state_area(roberts_region_list *list)
{
    size_t largest = 0;
    for (size_t i = 1; i < list->count; i++)
        largest = list->region[i].area > list->region[largest].area ? i : largest;
    list->region[largest].area *= 1 + 1e-6;
}

static void turn_ring(roberts_region_list *list)
{
    for (size_t i = list->ring_start[0], k = list->ring_start[1] - 1; i < k; i++, k--) {
        const roberts_vec2 p = list->corner[i];
        list->corner[i] = list->corner[k];
        list->corner[k] = p;
    }
}

static void (*const spoilers[])(roberts_region_list *) = {move_corner, swap_faces, drop_region,
                                                          drop_ring,   state_area, turn_ring};

/* Spoils a copy of the list: is it refused then? */
static bool refused_if_spoiled(const mesh_scene *scene, const region_truth *truth, const roberts_region_list *list,
                               void (*spoil)(roberts_region_list *), FILE *out)
{
    roberts_region_list copy = *list;
    region_total total = {0};
    copy.region = malloc(list->count * sizeof *copy.region);
    copy.corner = malloc(list->corner_count * sizeof *copy.corner);
    assert_true(copy.region && copy.corner);
    memcpy(copy.region, list->region, list->count * sizeof *copy.region);
    memcpy(copy.corner, list->corner, list->corner_count * sizeof *copy.corner);
    spoil(&copy);
    const bool refused = region_judge_list("wrong", scene, truth, &copy, &total, out) > 0;
    free(copy.region);
    free(copy.corner);
    return refused;
}

static void test_wrong_tables(void **state)
{
    size_t refused = 0;
    FILE *nowhere = fopen("/dev/null", "w");
    (void)state;
    assert_non_null(nowhere);
    for (size_t f = 0; f < mesh_family_count(); f++)
        for (uint64_t seed = 1; seed <= WRONG_SEEDS; seed++) {
            mesh_scene scene;
            region_total total = {0};
            region_truth truth;
            roberts_region_list list;
            assert_true(mesh_family_make(f, seed, &scene));
            if (region_judge_find("wrong", &scene, &truth, &list, &total, nowhere)) {
                for (size_t k = 0; k < sizeof spoilers / sizeof *spoilers && list.count > 1; k++, refused++)
                    if (!refused_if_spoiled(&scene, &truth, &list, spoilers[k], nowhere))
                        fail_msg("%s-%d: wrong table %zu is taken", mesh_family_name(f), (int)seed, k);
                roberts_regions_free(&list);
                region_truth_free(&truth);
            }
            mesh_scene_free(&scene);
        }
    fclose(nowhere);
    print_message("note: %zu wrong tables refused\n", refused);
    assert_true(refused > 100);
}

/* ---- families ---- */

static void test_families(void **state)
{
    region_total total = {0};
    (void)state;
    for (size_t f = 0; f < mesh_family_count(); f++)
        for (uint64_t seed = 1; seed <= SEEDS; seed++) {
            char name[64];
            mesh_scene scene;
            assert_true(mesh_family_make(f, seed, &scene));
            snprintf(name, sizeof name, "%s-%d", mesh_family_name(f), (int)seed);
            region_judge(name, &scene, build_folder(), &total, stdout);
            mesh_scene_free(&scene);
        }
    print_message("note: %zu regions with %zu rings of %zu scenes compared with the exact oracle: %zu disagreements; "
                  "nothing is seen of %zu more faces\n",
                  total.regions, total.rings, total.scenes - total.refused, total.disagreements, total.unseen);
    assert_true(total.regions > 3000);
    assert_true(total.refused < 5);
    assert_int_equal(total.disagreements, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_by_hand),
        cmocka_unit_test(test_wrong_tables),
        cmocka_unit_test(test_families),
    };
    return cmocka_run_group_tests_name("region oracle", tests, NULL, NULL);
}
