/* Bundles: solids of very many faces whose boxes overlap. The tree is compared with testing all faces one by one. */
#include "hide/front_test.h"
#include "scenes.h"

enum { EDGES_OF_EACH = 3000, SCENES = 24, RINGS = 50, SIDES = 2 * RINGS };

/* Double pyramids, and columns lying down; every other scene to five digits. Two of a kind, one through the other or
 * beside it, so that the picture is large enough for edges. */
static void make_scene(model *m, uint64_t seed)
{
    rng r = {seed};
    uint32_t n = (uint32_t)rng_int(&r, 100, MODEL_CORNERS);
    for (int i = 0; i < 2; i++) {
        double high = rng_between(&r, 0.2, 3.0), lean = seed % 3 == 0 ? rng_between(&r, -1.0, 1.0) : 0.0;
        mat3 map = {{1, 0, 0}, {0, rng_between(&r, 0.1, 1.0), 0}, {lean, lean, high}};
        if (seed % 4 == 3) /* a column along x */
            map = (mat3){{0, 0.1, 0}, {0, 0, 0.1}, {2, 0.5 * lean, 0.5}};
        model_round(m, n, seed % 4 != 3, map,
                    (roberts_vec3){0.3 * i, rng_between(&r, -0.2, 0.2), -rng_between(&r, 0.0, 2.0) * i});
    }
    if (seed % 2)
        model_to_digits(m, 5);
}

/* A ball of parallels and meridians, its poles cut off. */
static void add_ball(model *m, roberts_vec3 at)
{
    uint32_t first = (uint32_t)m->mesh.vertex_count, cap[2][SIDES];
    for (uint32_t i = 0; i < RINGS * SIDES; i++) {
        double up = 3.141592653589793 * (i / SIDES + 1) / (RINGS + 1), round = 6.283185307179586 * (i % SIDES) / SIDES;
        model_vertex(m, vec3_add(at, (roberts_vec3){sin(up) * cos(round), sin(up) * sin(round), -cos(up)}));
    }
    for (uint32_t i = 0; i < (RINGS - 1) * SIDES; i++) {
        uint32_t k = i % SIDES == SIDES - 1 ? i + 1 - SIDES : i + 1;
        model_face(m, (uint32_t[]){first + i, first + k, first + k + SIDES, first + i + SIDES}, 4);
    }
    for (uint32_t i = 0; i < SIDES; i++) {
        cap[0][i] = first + i;
        cap[1][i] = first + (RINGS - 1) * SIDES + i;
    }
    model_face(m, cap[0], SIDES);
    model_face(m, cap[1], SIDES);
    model_close_solid(m);
}

/* Two such through one another, and a box so large and far away that the balls are one spot beside it. */
static void make_speck(model *m)
{
    add_ball(m, (roberts_vec3){0, 0, 0});
    add_ball(m, (roberts_vec3){0.3, 0.2, 0.1});
    model_box(m, (roberts_vec3){1000, 1000, 1000}, (roberts_vec3){2000, 2000, 2000});
}

/* A point anywhere, a vertex, a point on the line through two vertices, or one just beside such a line. */
static roberts_vec3 place(const hide_fronts *fronts, rng *r)
{
    int last = (int)fronts->scene->solid[2].vertex - 1; /* of the first two solids */
    roberts_vec3 P = fronts->P[rng_int(r, 0, last)], Q = fronts->P[rng_int(r, 0, last)];
    double t = rng_between(r, -0.5, 1.5);
    switch (rng_int(r, 0, 3)) {
    case 0:
        return P;
    case 1:
        return vec3_add(P, vec3_scale(t, vec3_sub(Q, P)));
    case 2:
        return vec3_add(P, (roberts_vec3){0.0, 0.0, t - 1.0});
    default:
        return vec3_add(P, (roberts_vec3){rng_between(r, -1.5, 1.5), rng_between(r, -1.5, 1.5), rng_between(r, -3, 3)});
    }
}

static hide_edge edge_of(roberts_vec3 A, roberts_vec3 B)
{
    roberts_vec3 D = vec3_sub(B, A);
    return (hide_edge){.A = A, .B = B, .length = hypot(D.x, D.y), .length3 = vec3_length(D)};
}

/* Finds the hull of what the faces hide one by one, without the tree. */
static bool by_each_face(const hide_fronts *fronts, const hide_meeting *all, const hide_edge *e, hide_sides *sides,
                         hide_interval *hull)
{
    bool found = false;
    for (uint32_t k = 0; k < all->face_count; k++) {
        hide_meeting one = *all;
        hide_interval part;
        one.tree = NULL;
        one.face += k;
        one.face_count = 1;
        if (!hide_by_faces(fronts, &one, e, sides, &part))
            continue;
        *hull = found ? hide_intervals_joined(hull, &part) : part;
        found = true;
    }
    return found;
}

static void a_tree_finds_what_all_faces_do(void **state)
{
    size_t bundles = 0, hidden = 0, cut = 0, asked = 0, all = 0;
    hide_sides sides = {0};
    (void)state;
    assert_true(hide_sides_reserve(&sides, MODEL_CORNERS + 1));
    for (uint64_t seed = 0; seed <= SCENES; seed++) {
        static const roberts_camera cameras[] = {
            {.dir = {0, 0, 1}, .up = {0, 1, 0}}, {.dir = {1, 2, 9}}, {ROBERTS_PERSPECTIVE, .eye = {3, -4, 20}}};
        size_t before = bundles;
        model m = {0};
        rng r = {seed + 100};
        hide_fronts fronts;
        seen seen_scene;
        seed < SCENES ? make_scene(&m, seed) : make_speck(&m);
        roberts_scene *scene = model_build(&m);
        assert_int_equal(seen_begin(&seen_scene, scene, &cameras[seed % 3], 0.0, NULL), ROBERTS_OK);
        assert_true(
            hide_fronts_build(&fronts, &seen_scene, &(roberts_hide_options){.keep_hidden = true, .threads = 1}, false));
        fronts.space.scene = NULL; /* these edges do not belong to the scene */
        for (uint32_t k = 0; k < fronts.front_count; k++) {
            const hide_box none = {0};
            hide_single single = {.front = ROBERTS_NONE};
            if (!hide_bundle(&fronts, k))
                continue;
            hide_meeting meeting = hide_meet(&fronts, k, &none, &single);
            meeting.outline.span = 20.0;
            bundles++;
            for (int i = 0; i < (seed < SCENES ? EDGES_OF_EACH : EDGES_OF_EACH / 10); i++) {
                hide_edge e = edge_of(place(&fronts, &r), place(&fronts, &r));
                hide_interval part = {0}, expected = {0};
                sides.tally = (roberts_tally){0};
                bool found = hide_by_faces(&fronts, &meeting, &e, &sides, &part);
                asked += sides.tally.pairs;
                sides.tally = (roberts_tally){0};
                if (found != by_each_face(&fronts, &meeting, &e, &sides, &expected) ||
                    (found && (part.t0 != expected.t0 || part.t1 != expected.t1)))
                    fail_msg("scene %d, front %u, edge %d: %d %.17g %.17g instead of %.17g %.17g", (int)seed, k, i,
                             found, part.t0, part.t1, expected.t0, expected.t1);
                hidden += found;
                cut += found && (part.t0 > 0.0 || part.t1 < 1.0);
                all += sides.tally.pairs;
            }
        }
        assert_true(seed < SCENES || bundles == before + 2);
        hide_fronts_free(&fronts);
        seen_end(&seen_scene);
        roberts_scene_free(scene);
        model_free(&m);
    }
    print_message("%zu bundles, %zu hidden, %zu cut; asked %zu of %zu\n", bundles, hidden, cut, asked, all);
    assert_true(bundles >= SCENES && hidden > 10000 && cut > 5000 && asked < all / 3);
    free(sides.H);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tree_finds_what_all_faces_do),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
