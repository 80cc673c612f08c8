/* test_front_tree.c - the tree over the fronts of a cell: it leaves out no front that hides anything, and drawings are
 * the same with it as with short lists. */
#include "hide/front_test.h"
#include "hide/front_tree.h"
#include "scenes.h"

enum { SOLIDS = 900, LINES = 80, SEEDS = 6 };

/* Solids with ties of every kind, thin plates above one another, or long thin sticks. */
static void make_scene(model *m, uint64_t seed)
{
    rng r = {seed + 7};
    if (seed % 3 == 0) {
        model_crowd(m, SOLIDS, 8, seed);
        return;
    }
    for (int i = 0; i < SOLIDS; i++) {
        double x = rng_between(&r, 0, 0.1), y = rng_between(&r, 0, 0.1), along = rng_between(&r, -0.1, 0.1);
        roberts_vec3 at = {x, y, 0.003 * i};
        mat3 map = {{2, along, 0}, {-along, 1, 0}, {0, 0, 0.001}};
        if (seed % 3 == 1) {
            map = (mat3){{3, 0.01, 0}, {3 + along, 0.02, 0}, {10 * along, 0, 0.01}};
            at = (roberts_vec3){20 * x, 0.003 * i, 20 * y};
        }
        model_add(m, &shapes[SHAPE_CUBE], map, at);
    }
    if (seed % 4 == 2)
        model_to_digits(m, 4);
}

static const roberts_camera cameras[] = {
    {.dir = {0, 0, 1}, .up = {0, 1, 0}}, {.dir = {1, 2, 0.3}}, {ROBERTS_PERSPECTIVE, .eye = {13, -14, 20}}};

static roberts_vec3 corner(const hide_fronts *fronts, rng *r)
{
    return fronts->P[rng_int(r, 0, (int)fronts->scene->vertex_count - 1)];
}

/* Collects what a line may meet: a part for each front; t0 > t1: none. */
static void walk(const front_tree *tree, const front_line *line, front_visit *met)
{
    front_visit stack[FRONT_TREE_WAITING] = {{0, 0.0f, 1.0f, 0.0f}};
    uint32_t waiting = 1;
    while (waiting > 0) {
        front_visit v = stack[--waiting];
        if (v.child & FRONT_TREE_LEAF)
            met[v.child & ~FRONT_TREE_LEAF] = v;
        else
            waiting += front_node_meets(&tree->node[v.child], line, v.t0, v.t1, stack + waiting);
        assert_true(waiting <= FRONT_TREE_WAITING - 4);
    }
}

/* Visits come by the list of their length, the last one added first. Each comes once. */
static void what_hides_most_comes_first(void **state)
{
    rng r = {53};
    size_t taken = 0, late = 0;
    (void)state;
    for (int round = 0; round < 2000; round++) {
        front_queue queue;
        front_visit waiting[FRONT_QUEUE], found[4], v;
        uint32_t count = 0, name = 0;
        front_queue_begin(&queue);
        for (int step = 0; step < 40; step++) {
            uint32_t more = queue.count <= FRONT_QUEUE - 4 ? (uint32_t)rng_int(&r, 0, 4) : 0;
            for (uint32_t i = 0; i < more; i++) {
                float from = (float)rng_between(&r, 0, 0.5), length = (float)pow(10, rng_between(&r, -12, 0.2));
                found[i] = (front_visit){name++, from, from + length, 0.0f};
            }
            bool any = front_queue_next(&queue, found, more, &v);
            for (uint32_t i = 0; i < more; i++)
                waiting[count++] = found[i];
            assert_true(any == (count > 0));
            if (!any)
                continue;
            uint32_t at = count;
            for (uint32_t i = 0; i < count; i++)
                if (waiting[i].child == v.child)
                    at = i;
            assert_true(at < count);
            for (uint32_t i = 0; i < count; i++)
                assert_true(front_queue_list(&waiting[i]) > front_queue_list(&v) ||
                            (front_queue_list(&waiting[i]) == front_queue_list(&v) && i <= at));
            late += at + 1 < count;
            for (uint32_t i = at + 1; i < count; i++)
                waiting[i - 1] = waiting[i];
            count--;
            assert_int_equal(queue.count, count);
            taken++;
        }
    }
    assert_true(taken > 20000 && late > 1000);
}

static void nothing_hidden_is_left_out(void **state)
{
    size_t hidden = 0, asked = 0, all = 0;
    hide_sides sides = {0};
    (void)state;
    assert_true(hide_sides_reserve(&sides, MODEL_CORNERS + 1));
    for (uint64_t seed = 0; seed < SEEDS; seed++) {
        model m = {0};
        rng r = {seed + 100};
        hide_fronts fronts;
        seen seen_scene;
        front_tree tree;
        make_scene(&m, seed);
        roberts_scene *scene = model_build(&m);
        assert_int_equal(seen_begin(&seen_scene, scene, &cameras[seed / 3 % 3], 0.0, NULL), ROBERTS_OK);
        assert_true(
            hide_fronts_build(&fronts, &seen_scene, &(roberts_hide_options){.keep_hidden = true, .threads = 1}, false));
        fronts.space.scene = NULL; /* these lines do not belong to the scene */
        uint32_t *front = malloc(fronts.front_count * sizeof *front);
        front_visit *met = malloc(fronts.front_count * sizeof *met);
        assert_true(front && met && fronts.front_count > SOLIDS / 2);
        for (uint32_t k = 0; k < fronts.front_count; k++)
            front[k] = k;
        assert_true(front_tree_build(&tree, &fronts, front, fronts.front_count));
        assert_true(tree.count <= 2 * fronts.front_count / 3 + 1);
        for (int i = 0; i < LINES; i++) {
            roberts_vec3 A = corner(&fronts, &r), B = corner(&fronts, &r), AB = vec3_sub(B, A);
            hide_edge e = {.A = A, .B = B, .length = hypot(AB.x, AB.y), .length3 = vec3_length(AB)};
            double margin = hide_margin(&fronts.space);
            front_line line = front_line_of(A, B, margin);
            for (uint32_t k = 0; k < fronts.front_count; k++)
                met[k] = (front_visit){.t0 = 2.0f, .t1 = -1.0f};
            walk(&tree, &line, met);
            for (uint32_t k = 0; k < fronts.front_count; k++) {
                const hide_box none = {0};
                hide_single single = {.front = ROBERTS_NONE};
                hide_meeting meeting = hide_meet(&fronts, k, &none, &single);
                hide_interval part;
                meeting.outline.span = 100.0;
                sides.outline.corner = NULL;
                asked += met[k].t0 <= met[k].t1;
                all++;
                if (!(e.length > 0.0) || !hide_by_front(&fronts, &meeting, &e, NULL, &sides, &part))
                    continue;
                if (!box_clip(A.z, B.z, -INFINITY, (double)fronts.front_box[k].z1 + margin, &part.t0, &part.t1) ||
                    !hide_is_left(&fronts.space, &e, &part))
                    continue;
                hidden++;
                if (!((double)met[k].t0 <= part.t0 && part.t1 <= (double)met[k].t1))
                    fail_msg("scene %d, line %d, front %u: hidden %.9g %.9g, asked %.9g %.9g", (int)seed, i, k, part.t0,
                             part.t1, (double)met[k].t0, (double)met[k].t1);
            }
        }
        front_tree_free(&tree);
        free(front);
        free(met);
        hide_fronts_free(&fronts);
        seen_end(&seen_scene);
        roberts_scene_free(scene);
        model_free(&m);
    }
    print_message("%zu hidden, %zu of %zu asked\n", hidden, asked, all);
    assert_true(hidden > 10000 && asked < all / 2);
    free(sides.H);
}

static roberts_drawing draw(const roberts_scene *scene, uint64_t seed, const roberts_hide_options *options)
{
    return drawing_of(scene, &cameras[seed / 3 % 3], options);
}

/* One cell lists all fronts; forty cells a side list few each. */
static void the_same_lines_as_by_lists(void **state)
{
    size_t crossed = 0;
    (void)state;
    for (uint64_t seed = 0; seed < SEEDS / 2; seed++)
        for (int hidden = 0; hidden < (seed % 3 ? 3 : 1); hidden++) { /* a crowd has very many hidden lines */
            roberts_hide_options options = roberts_hide_options_default();
            model m = {0};
            make_scene(&m, seed);
            options.keep_hidden = hidden > 0;
            options.nameless = hidden > 1;
            options.grid = 1;
            options.threads = 2;
            roberts_scene *scene = model_build(&m);
            roberts_drawing one = draw(scene, seed, &options);
            options.grid = 40;
            roberts_drawing many = draw(scene, seed, &options);
            assert_true(one.count > 50);
            assert_int_equal(one.count, many.count);
            for (size_t i = 0; i < one.count; i++) {
                const roberts_segment *a = &one.segment[i], *b = &many.segment[i];
                crossed += a->line == ROBERTS_INTERSECTION;
                if (a->solid != b->solid || a->v0 != b->v0 || a->v1 != b->v1 || a->t0 != b->t0 || a->t1 != b->t1 ||
                    a->state != b->state || a->by != b->by)
                    fail_msg("scene %d, hidden %d: row %zu, %u-%u: %.17g %.17g (%u) and %.17g %.17g (%u)", (int)seed,
                             hidden, i, a->v0, a->v1, a->t0, a->t1, a->by, b->t0, b->t1, b->by);
            }
            roberts_drawing_free(&one);
            roberts_drawing_free(&many);
            roberts_scene_free(scene);
            model_free(&m);
        }
    assert_true(crossed > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_hides_most_comes_first),
        cmocka_unit_test(nothing_hidden_is_left_out),
        cmocka_unit_test(the_same_lines_as_by_lists),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
