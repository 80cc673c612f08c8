/* Sight lines against faces of many corners: samples of the corners give the same answer as all sides. */
#include "ray/sight.h"
#include "scenes.h"

enum { CORNERS = 120, POINTS = 40000 };

static roberts_vec3 between(roberts_vec3 a, roberts_vec3 b, double t)
{
    return vec3_add(a, vec3_scale(t, vec3_sub(b, a)));
}

/* A point below the face: often near a side, or near where its line goes on, or near a diagonal from the
 * first corner. */
static roberts_vec3 random_point(rng *r, const sight *s, uint32_t face)
{
    const uint32_t *corner = s->scene->corner + s->scene->face_start[face];
    uint32_t count = s->scene->face_start[face + 1] - s->scene->face_start[face];
    uint32_t i = (uint32_t)rng_int(r, 0, (int)count - 1), k = (uint32_t)rng_int(r, 0, (int)count - 1);
    bool diagonal = rng_int(r, 0, 2) == 0;
    roberts_vec3 A = s->P[corner[diagonal ? 0 : i]], B = s->P[corner[diagonal ? i : (i + 1) % count]];
    roberts_vec3 C = s->P[corner[k]];
    static const double off[] = {0, 1e-15, 1e-13, 1e-11, 1e-9, 1e-6, 1e-3, 0.3};
    roberts_vec3 X =
        between(between(A, B, rng_between(r, -0.5, 1.5)), C, rng_between(r, -1, 1) * off[rng_int(r, 0, 7)]);
    roberts_vec3 v = sight_from(s, X);
    return vec3_sub(X, vec3_scale(rng_between(r, 0, 0.2) / vec3_length(v), v));
}

/* Tests with samples and without. */
static void expect_same(const sight *s, uint32_t face, rng *r, int found[3])
{
    sight plain = *s;
    plain.sampled = NULL;
    for (int n = 0; n < POINTS; n++) {
        roberts_vec3 X = random_point(r, s, face), v = sight_from(s, X);
        double slack = rng_int(r, 0, 1) ? 0.0 : s->loose;
        sight_answer through = sight_through(s, face, X, v, slack);
        assert_int_equal(through, sight_through(&plain, face, X, v, slack));
        assert_int_equal(sight_hides(s, face, X, v, slack), sight_hides(&plain, face, X, v, slack));
        const roberts_vec3 ends[2] = {X, random_point(r, s, face)};
        assert_int_equal(sight_hides_strictly(s, face, X, v, slack, ends),
                         sight_hides_strictly(&plain, face, X, v, slack, ends));
        found[through]++;
    }
}

/* Dented: one corner lies behind the chord of its neighbours, by less than the tolerance. Straight: a square whose
 * borders come in many parts, so that diagonals from its first corner lie on one another. */
enum { ROUND, DENTED, STRAIGHT, OUTLINES };

/* Corner i of the square, of CORNERS / 4 to a border, each at whole numbers. */
static roberts_vec2 square_corner(int i)
{
    const int side = CORNERS / 4, along = i % side - side / 2;
    const roberts_vec2 at[] = {
        {along, -side / 2}, {side - side / 2, along}, {-along, side - side / 2}, {-side / 2, -along}};
    return at[i / side];
}

/* A prism, drawn out by `wide`. */
static void add_prism(model *m, double wide, int outline)
{
    const double chord = cos(2 * 3.14159265358979323846 / CORNERS);
    model_round(m, CORNERS, false, mat3_scale(wide, 1, 1), (roberts_vec3){0, 0, 0});
    for (uint32_t v = 12; outline == DENTED && v < 2 * CORNERS; v += CORNERS) {
        m->mesh.vertex[v].x *= chord - 5e-6;
        m->mesh.vertex[v].y *= chord - 5e-6;
    }
    for (int v = 0; outline == STRAIGHT && v < 2 * CORNERS; v++) {
        m->mesh.vertex[v].x = wide * square_corner(v % CORNERS).x;
        m->mesh.vertex[v].y = square_corner(v % CORNERS).y;
    }
}

/* In parallel and in perspective. The face is not sampled if a sample lies outside a side. */
static void samples_say_what_all_sides_say(void **state)
{
    static const double wide[] = {1, 1e-2};
    rng r = {76};
    int found[3] = {0}, sampled = 0, faces = 0;
    (void)state;
    for (int i = 0; i < 4 * OUTLINES; i++) {
        int outline = i >> 2;
        roberts_camera camera = {.dir = {0.2, 0.3, 1}};
        view v;
        sight s;
        model m = {0};
        if (i & 1)
            camera = (roberts_camera){ROBERTS_PERSPECTIVE, .eye = {1, 2, 9}, .has_look_at = true};
        add_prism(&m, wide[i >> 1 & 1], outline);
        roberts_scene *scene = model_build(&m);
        assert_int_equal(view_prepare(&v, scene, &camera, 0, NULL), ROBERTS_OK);
        assert_true(sight_prepare(&s, scene, &v));
        assert_true(sight_sample(&s));
        for (uint32_t face = 0; face < scene->face_count; face++) {
            if (scene->face_start[face + 1] - scene->face_start[face] != CORNERS || s.facing[face] != SIGHT_FRONT)
                continue;
            faces++;
            sampled += s.sampled && s.sampled[face];
            assert_true(outline == DENTED || (s.sampled && s.sampled[face]));
            expect_same(&s, face, &r, found);
        }
        sight_free(&s);
        roberts_scene_free(scene);
        model_free(&m);
    }
    assert_int_equal(faces, 4 * OUTLINES);
    assert_true(sampled < faces);
    for (int answer = 0; answer < 3; answer++)
        assert_true(found[answer] > POINTS / 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(samples_say_what_all_sides_say),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
