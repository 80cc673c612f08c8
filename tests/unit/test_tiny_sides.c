/* test_tiny_sides.c - a corner may lie one ulp beside another one of the same face. The side between them has no
 * direction to trust, and changes nothing in the drawing. */
#include "scenes.h"

/* Blocks that touch and cross, boxes and angles, turned together. Coordinates are rounded by the turn. */
static void make_blocks(model *m, rng *r)
{
    const int blocks = rng_int(r, 1, 3);
    for (int i = 0; i < blocks; i++) {
        const roberts_vec3 low = {rng_int(r, 0, 3) / 2.0, rng_int(r, 0, 3) / 2.0, rng_int(r, 0, 3) / 2.0};
        roberts_vec3 point[12];
        if (rng_int(r, 0, 1)) {
            model_box(m, low, vec3_add(low, (roberts_vec3){rng_int(r, 1, 4) / 2.0, rng_int(r, 1, 4) / 2.0, 2}));
            continue;
        }
        for (int k = 0; k < 12; k++)
            point[k] = vec3_add(low, (roberts_vec3){angle_corner(k).x, k < 6 ? 0 : 1.5, angle_corner(k).y});
        model_angle(m, point);
    }
    model_map(m, mat3_turn(r), (roberts_vec3){0, 0, 0});
}

/* Copies a mesh with a new vertex on the edge from a to b, next to b: one ulp beside it, or a few, or at its place. */
static void divide_edge(const roberts_mesh *from, uint32_t a, uint32_t b, rng *r, roberts_mesh *to)
{
    const uint32_t added = (uint32_t)from->vertex_count;
    roberts_vec3 near = from->vertex[b];
    for (uint32_t v = 0; v < added; v++)
        mesh_vertex(to, from->vertex[v]);
    for (int steps = rng_int(r, 0, 3); steps > 0; steps--)
        near = (roberts_vec3){nextafter(near.x, from->vertex[a].x), nextafter(near.y, from->vertex[a].y),
                              nextafter(near.z, from->vertex[a].z)};
    mesh_vertex(to, near);
    for (size_t f = 0; f < from->face_count; f++) {
        const uint32_t first = from->face_start[f], count = from->face_start[f + 1] - first;
        uint32_t corner[16], corners = 0;
        for (uint32_t k = 0; k < count; k++) {
            const uint32_t v = from->corner[first + k], next = from->corner[first + (k + 1) % count];
            corner[corners++] = v;
            if ((v == a && next == b) || (v == b && next == a))
                corner[corners++] = added;
        }
        mesh_face(to, corner, corners);
    }
}

/* What is seen of a scene: the length of each class of lines, and the area of the regions of each face. */
enum { CLASSES = 8, FACES = 40 };

typedef struct seen_sums {
    double length[CLASSES], area[FACES + 1];
} seen_sums;

static seen_sums see(const roberts_mesh *mesh, const roberts_camera *camera, bool unite)
{
    const roberts_hide_options options = {.unite = unite};
    seen_sums sums = {{0}, {0}};
    roberts_region_list regions;
    roberts_scene *scene = scene_of_mesh(mesh, NULL);
    roberts_drawing d = drawing_of(scene, camera, &options);
    for (size_t i = 0; i < d.count + d.cut_count; i++) {
        const roberts_segment *s = &d.segment[i];
        if (s->state == ROBERTS_VISIBLE)
            sums.length[s->line] += hypot(s->p1.x - s->p0.x, s->p1.y - s->p0.y);
    }
    assert_int_equal(roberts_regions(scene, camera, &options, &regions, NULL), ROBERTS_OK);
    for (size_t i = 0; i < regions.count; i++)
        sums.area[regions.region[i].face < FACES ? regions.region[i].face : FACES] += regions.region[i].area;
    roberts_regions_free(&regions);
    roberts_drawing_free(&d);
    roberts_scene_free(scene);
    return sums;
}

/* In a parallel view, from an eye, and with a section through the corner. */
static void tiny_sides_change_nothing(void **state)
{
    rng r = {21};
    double all = 0.0;
    (void)state;
    for (int round = 0; round < 600; round++) {
        model m = {0};
        make_blocks(&m, &r);
        const size_t f = (size_t)rng_int(&r, 0, (int)m.mesh.face_count - 1);
        const uint32_t first = m.mesh.face_start[f], count = m.mesh.face_start[f + 1] - first;
        const uint32_t k = (uint32_t)rng_int(&r, 0, (int)count - 1);
        const uint32_t a = m.mesh.corner[first + k], b = m.mesh.corner[first + (k + 1) % count];
        const bool unite = round % 2;
        roberts_camera camera = {.dir = rng_vec3(&r, 1.0)};
        roberts_mesh divided = {0};
        if (round % 3 == 1)
            camera = (roberts_camera){.projection = ROBERTS_PERSPECTIVE,
                                      .eye = vec3_scale(30 / vec3_length(camera.dir), camera.dir)};
        else if (round % 3 == 2) {
            camera.has_section = true;
            camera.section = m.mesh.vertex[b];
        }
        divide_edge(&m.mesh, a, b, &r, &divided);
        bool beyond = false;
        for (size_t v = 0; v < m.mesh.vertex_count; v++)
            beyond = beyond || vec3_dot(camera.dir, vec3_sub(m.mesh.vertex[v], camera.section)) < -1e-3;
        if (beyond || !camera.has_section) {
            const seen_sums plain = see(&m.mesh, &camera, unite), own = see(&divided, &camera, unite);
            for (int i = 0; i < CLASSES; i++) {
                if (fabs(plain.length[i] - own.length[i]) > 1e-6)
                    fail_msg("round %d: lines of class %d are %g long in place of %g", round, i, own.length[i],
                             plain.length[i]);
                all += plain.length[i];
            }
            for (int i = 0; i <= FACES; i++)
                if (fabs(plain.area[i] - own.area[i]) > 1e-6)
                    fail_msg("round %d: face %d has an area of %g in place of %g", round, i, own.area[i],
                             plain.area[i]);
        }
        roberts_mesh_free(&divided);
        model_free(&m);
    }
    assert_true(all > 5000);
}

/* Two faces cross. A corner of one has a twin, and both have one picture: that side of it separates nothing. */
static void faces_with_twins_cross(void **state)
{
    const roberts_camera camera = {.dir = {1, -1, 1}};
    (void)state;
    roberts_scene *scene = scene_of_text("OFF\n"
                                         "8 2 0\n"
                                         "0.24 0.15 0\n"
                                         "0.24000000000000002 0.15 0\n"
                                         "4 -2 -4\n"
                                         "-4 -2 -4\n"
                                         "1 -4 2\n"
                                         "1 4 2\n"
                                         "1 4 -6\n"
                                         "1 -4 -6\n"
                                         "4 0 1 2 3\n"
                                         "4 4 5 6 7\n");
    roberts_drawing d = drawing_of(scene, &camera, NULL);
    assert_int_equal(d.crossing_count, 1);
    roberts_drawing_free(&d);
    roberts_scene_free(scene);
}

/* Signs of turns at corners this close contradict one another in doubles: a hull of them had too little
 * room, as the address sanitizer shows. */
static void hull_of_close_corners(void **state)
{
    (void)state;
    roberts_scene_free(scene_of_text("OFF\n5 4 0\n"
                                     "-0.24023481426194931 -2.0170771290016258 -0.066105428597881044\n"
                                     "0.6298622248900112 0.13656455140647861 1.5478210427346728\n"
                                     "-1.944610333182385 0.19604325047038706 0.37796920079491736\n"
                                     "-1.3901396187192128 -1.6071980381329292 2.4853094870038039\n"
                                     "0.62986222489000887 0.13656455140647866 1.5478210427346717\n"
                                     "4 0 1 4 2\n3 0 3 1\n3 0 2 3\n4 1 3 2 4\n"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tiny_sides_change_nothing),
        cmocka_unit_test(faces_with_twins_cross),
        cmocka_unit_test(hull_of_close_corners),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
