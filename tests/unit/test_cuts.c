/* test_cuts.c - the lines along which the near plane cuts bodies. The plane is z = 0, and lengths are true in it, from
 * an eye as in a parallel view. */
#include <stdio.h>

#include "draw/page.h"
#include "model/scene.h"
#include "build_scene.h"
#include "scenes.h"
#include "star_prism.h"

static const roberts_camera eye = {ROBERTS_PERSPECTIVE, .eye = {0, 0, 10}, .has_look_at = true, .near_distance = 10};

/* A parallel view with the same near plane, seen at right angles. */
static roberts_camera section_of(const roberts_camera *from)
{
    const roberts_vec3 back = vec3_sub(from->eye, from->look_at);
    const roberts_vec3 at = vec3_sub(from->eye, vec3_scale(from->near_distance / vec3_length(back), back));
    return (roberts_camera){.dir = back, .section = at, .has_section = from->near_distance > 0.0};
}

/* The same section, seen aslant. *narrow: how large areas of the section are in the picture. */
static roberts_camera slanted_of(const roberts_camera *from, double *narrow)
{
    roberts_camera camera = section_of(from);
    camera.section_normal = camera.dir;
    camera.dir = vec3_add(vec3_scale(1.0 / vec3_length(camera.dir), camera.dir), (roberts_vec3){0.31, -0.47, 0.23});
    *narrow =
        vec3_dot(camera.dir, camera.section_normal) / vec3_length(camera.dir) / vec3_length(camera.section_normal);
    return camera;
}

/* Are the lines closed? Then as many of them begin as end at each point. */
static bool are_closed(const roberts_drawing *d)
{
    bool closed = true;
    for (size_t i = d->count; i < d->count + d->cut_count; i++) {
        int balance = 0;
        for (size_t k = d->count; k < d->count + d->cut_count; k++) {
            const roberts_segment *s = &d->segment[k];
            const roberts_vec2 p = d->segment[i].p1;
            balance += (hypot(s->p0.x - p.x, s->p0.y - p.y) < 1e-9) - (hypot(s->p1.x - p.x, s->p1.y - p.y) < 1e-9);
        }
        closed = closed && balance == 0;
    }
    return closed;
}

/* The length of the cuts, and the area to their left. */
static void measure_cuts(const roberts_drawing *d, double *length, double *area)
{
    *length = *area = 0.0;
    for (size_t i = d->count; i < d->count + d->cut_count; i++) {
        const roberts_segment *s = &d->segment[i];
        assert_true(s->state == ROBERTS_VISIBLE && s->line == ROBERTS_OUTLINE && s->v0 == ROBERTS_NONE);
        *length += hypot(s->p1.x - s->p0.x, s->p1.y - s->p0.y);
        *area += 0.5 * (s->p0.x * s->p1.y - s->p0.y * s->p1.x);
    }
}

/* The cuts of a scene: how many, their length, and the area to their left. */
static void expect_cuts(const char *name, const roberts_scene *scene, const roberts_camera *camera, bool unite,
                        size_t count, double length, double area)
{
    double narrow;
    const roberts_camera cameras[] = {*camera, section_of(camera), slanted_of(camera, &narrow)};
    roberts_hide_options options = roberts_hide_options_default();
    options.unite = unite;
    for (int k = 0; k < 3; k++) {
        roberts_drawing d = drawing_of(scene, &cameras[k], &options);
        const char *way = k == 0 ? "from an eye" : k == 1 ? "in parallel" : "aslant";
        double sum, inside;
        measure_cuts(&d, &sum, &inside);
        inside /= k == 2 ? narrow : 1.0;
        if (d.cut_count != count || (k < 2 && fabs(sum - length) > 1e-9))
            fail_msg("%s, %s: %zu cuts, %.12g long, in place of %zu, %.12g", name, way, d.cut_count, sum, count,
                     length);
        if (area > 0.0 && (fabs(inside - area) > 1e-9 || !are_closed(&d)))
            fail_msg("%s, %s: the cuts go round %.12g in place of %.12g, or are open", name, way, inside, area);
        roberts_drawing_free(&d);
    }
}

/* Boxes from z = -1 to 1: the corners of their bases. */
static const struct {
    const char *name;
    int boxes;
    double box[3][4];
    size_t count;
    double length, area;
    size_t united;
    double united_length, united_area;
} rows[] = {
    {"one", 1, {{-1, -1, 1, 1}}, 4, 8, 4, 4, 8, 4},
    {"apart", 2, {{-1, -1, 1, 1}, {2, 0, 3, 1}}, 8, 12, 5, 8, 12, 5},
    {"flush", 2, {{0, 0, 1, 1}, {1, 0, 3, 1}}, 8, 10, 3, 6, 8, 3},
    {"flush in part", 2, {{0, 0, 1, 3}, {1, 1, 3, 2}}, 8, 14, 5, 8, 12, 5},
    {"through one another", 2, {{0, 0, 2, 2}, {1, 1, 3, 3}}, 8, 16, 8, 8, 12, 7},
    {"one in the other", 2, {{0, 0, 3, 3}, {1, 1, 2, 2}}, 8, 16, 10, 4, 12, 9},
    {"one in the other, flush", 2, {{0, 0, 3, 3}, {0, 1, 2, 2}}, 8, 18, 11, 4, 12, 9},
    {"the same place", 2, {{0, 0, 3, 3}, {0, 0, 3, 3}}, 8, 24, 18, 4, 12, 9},
    {"corner at corner", 2, {{0, 0, 1, 1}, {1, 1, 2, 2}}, 8, 8, 2, 8, 8, 2},
    {"three in a row", 3, {{0, 0, 1, 1}, {1, 0, 2, 1}, {2, 0, 3, 1}}, 12, 12, 3, 8, 8, 3},
};

static void boxes_are_cut(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        model m = {0};
        for (int k = 0; k < rows[i].boxes; k++)
            model_box(&m, (roberts_vec3){rows[i].box[k][0], rows[i].box[k][1], -1},
                      (roberts_vec3){rows[i].box[k][2], rows[i].box[k][3], 1});
        roberts_scene *scene = model_build(&m);
        expect_cuts(rows[i].name, scene, &eye, false, rows[i].count, rows[i].length, rows[i].area);
        expect_cuts(rows[i].name, scene, &eye, true, rows[i].united, rows[i].united_length, rows[i].united_area);
        roberts_scene_free(scene);
        model_free(&m);
    }
}

/* The near plane takes a block away, down to the one on which it stands. With `unite` the other one keeps its whole
 * outline, whichever is first. */
static void what_is_taken_away_leaves_no_seam(void **state)
{
    const roberts_hide_options options = {.unite = true};
    (void)state;
    for (int i = 0; i < 4; i++) {
        const roberts_camera camera = i < 2 ? eye : section_of(&eye);
        model m = {0};
        for (int k = 0; k < 2; k++)
            if (k == i % 2)
                model_box(&m, (roberts_vec3){0, 0, 0}, (roberts_vec3){2, 1, 1});
            else
                model_box(&m, (roberts_vec3){0, 0, -1}, (roberts_vec3){2, 2, 0});
        roberts_scene *scene = model_build(&m);
        roberts_drawing d = drawing_of(scene, &camera, &options);
        double length = 0.0;
        for (const roberts_segment *s = d.segment; s < d.segment + d.count; s++)
            if (s->state == ROBERTS_VISIBLE)
                length += hypot(s->p1.x - s->p0.x, s->p1.y - s->p0.y);
        assert_float_equal(length, 8, 1e-9);
        assert_int_equal(d.cut_count, 0);
        roberts_drawing_free(&d);
        roberts_scene_free(scene);
        model_free(&m);
    }
}

/* ---- contacts in the near plane ---- */

enum { GRID = 6 };

/* The lines of a picture whose lines run along whole coordinates: is there one from (x, y) to the right, or up? */
typedef struct grid_lines {
    bool right[GRID + 1][GRID + 1], up[GRID + 1][GRID + 1];
} grid_lines;

static grid_lines lines_on_grid(const roberts_scene *scene, double z, bool unite)
{
    const roberts_camera camera = {.dir = {0, 0, 1}, .up = {0, 1, 0}, .section = {0, 0, z}, .has_section = true};
    const roberts_vec3 origin = {0, 0, 0};
    const roberts_hide_options options = {.unite = unite};
    roberts_drawing d = drawing_of(scene, &camera, &options);
    grid_lines grid = {{{false}}, {{false}}};
    roberts_vec3 zero;
    assert_int_equal(
        roberts_project(scene, &(roberts_camera){.dir = camera.dir, .up = camera.up}, &origin, 1, &zero, NULL),
        ROBERTS_OK);
    for (size_t i = 0; i < d.count + d.cut_count; i++) {
        const roberts_segment *s = &d.segment[i];
        const double x0 = s->p0.x - zero.x, y0 = s->p0.y - zero.y, x1 = s->p1.x - zero.x, y1 = s->p1.y - zero.y;
        if (s->state != ROBERTS_VISIBLE)
            continue;
        for (int k = (int)lround(fmin(x0, x1)); k < lround(fmax(x0, x1)); k++)
            grid.right[k][lround(y0)] = true;
        for (int k = (int)lround(fmin(y0, y1)); k < lround(fmax(y0, y1)); k++)
            grid.up[lround(x0)][k] = true;
    }
    roberts_drawing_free(&d);
    return grid;
}

/* Adds a box, or what is left of one without the quarter from its middle on along two axes. */
static void put_block(model *m, rng *r)
{
    double low[3], high[3];
    const int axis = rng_int(r, 0, 2), bent = (axis + 1) % 3, other = (axis + 2) % 3;
    for (int k = 0; k < 3; k++) {
        low[k] = rng_int(r, 0, GRID - 2);
        high[k] = low[k] + rng_int(r, 1, 2);
    }
    if (rng_int(r, 0, 1) || high[bent] - low[bent] < 2 || high[other] - low[other] < 2) {
        model_box(m, (roberts_vec3){low[0], low[1], low[2]}, (roberts_vec3){high[0], high[1], high[2]});
        return;
    }
    const bool turned = rng_int(r, 0, 1), over = rng_int(r, 0, 1);
    roberts_vec3 point[12];
    for (int k = 0; k < 12; k++) {
        const roberts_vec2 at = angle_corner(k);
        double p[3];
        p[axis] = k < 6 ? low[axis] : high[axis];
        p[bent] = low[bent] + (turned ? 2 - at.x : at.x);
        p[other] = low[other] + (over ? 2 - at.y : at.y);
        point[k] = (roberts_vec3){p[0], p[1], p[2]};
    }
    model_angle(m, point);
}

/* Blocks that touch and overlap anywhere, taken as one. A section through their contacts is that just behind it. */
static void contacts_are_cut_as_what_is_behind_them(void **state)
{
    rng r = {86};
    size_t all = 0;
    (void)state;
    for (int round = 0; round < 1000; round++) {
        model m = {0};
        const int blocks = rng_int(&r, 2, 6), z = rng_int(&r, 1, GRID - 1);
        for (int k = 0; k < blocks; k++)
            put_block(&m, &r);
        roberts_scene *scene = model_build(&m);
        bool any = false;
        for (size_t v = 0; v < m.mesh.vertex_count; v++)
            any = any || m.mesh.vertex[v].z < z;
        if (any) {
            const grid_lines at = lines_on_grid(scene, z, true), behind = lines_on_grid(scene, z - 0x1p-10, true);
            for (int i = 0; i < (GRID + 1) * (GRID + 1); i++) {
                const int x = i % (GRID + 1), y = i / (GRID + 1);
                if (at.right[x][y] != behind.right[x][y] || at.up[x][y] != behind.up[x][y])
                    fail_msg("round %d, z = %d: the line from %d, %d is drawn only %s", round, z, x, y,
                             at.right[x][y] > behind.right[x][y] || at.up[x][y] > behind.up[x][y] ? "at the contact"
                                                                                                  : "behind it");
                all += at.right[x][y];
            }
        }
        roberts_scene_free(scene);
        model_free(&m);
    }
    assert_true(all > 1000);
}

/* Through each corner of a face that the section is parallel to, the section is the same, although their coordinates
 * are rounded to twelve decimals. */
static void faces_in_the_plane_are_cut_alike(void **state)
{
    rng r = {87};
    double all = 0.0;
    (void)state;
    for (int round = 0; round < 100; round++) {
        model m = {0};
        const mat3 turn = mat3_turn(&r);
        while (m.mesh.vertex_count != 12) { /* an angle */
            model_free(&m);
            put_block(&m, &r);
        }
        model_map(&m, turn, (roberts_vec3){0, 0, 0});
        model_to_digits(&m, 12);
        roberts_scene *scene = model_build(&m);
        double area[2][12];
        for (int v = 0; v < 12; v++)
            for (int way = 0; way < 2; way++) {
                const roberts_camera camera = {.dir = vec3_scale(way ? 1 : -1, round % 2 ? turn.x : turn.y),
                                               .section = m.mesh.vertex[v],
                                               .has_section = true};
                roberts_region_list list;
                area[way][v] = 0.0;
                const roberts_status status = roberts_regions(scene, &camera, NULL, &list, NULL);
                if (status == ROBERTS_BAD_VIEW)
                    continue; /* nothing lies beyond */
                assert_int_equal(status, ROBERTS_OK);
                for (size_t i = 0; i < list.count; i++)
                    area[way][v] += list.region[i].section ? list.region[i].area : 0.0;
                roberts_regions_free(&list);
                all += area[way][v];
            }
        for (int v = 0; v < 12; v++)
            for (int w = 0; w < v; w++) {
                const roberts_vec3 apart = vec3_sub(m.mesh.vertex[v], m.mesh.vertex[w]);
                if (fabs(vec3_dot(apart, round % 2 ? turn.x : turn.y)) > 0.1)
                    continue;
                for (int way = 0; way < 2; way++)
                    if (fabs(area[way][v] - area[way][w]) > 1e-9)
                        fail_msg("round %d: through vertex %d the section is %g large, through %d %g", round, v,
                                 area[way][v], w, area[way][w]);
            }
        roberts_scene_free(scene);
        model_free(&m);
    }
    assert_true(all > 1000);
}

/* A box with a fin in the plane of its front: two faces that lie on one another. Boxes beside the fin and in front of
 * it make the section and the union matter. However the scene is turned, rounding does not decide about the edge at
 * which the fin begins. */
static void folds_in_the_plane_stay(void **state)
{
    static const char text[] =
        "OFF\n26 21 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n3 0 0\n3 0 2\n"
        "2 0 3\n3 0 3\n3 1 3\n2 1 3\n2 0 2\n3 0 2\n3 1 2\n2 1 2\n"
        "5 -2 0\n6 -2 0\n6 -1 0\n5 -1 0\n5 -2 2\n6 -2 2\n6 -1 2\n5 -1 2\n"
        "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n4 1 8 9 5\n3 9 8 1\n3 5 9 1\n"
        "4 10 11 12 13\n4 17 16 15 14\n4 14 15 11 10\n4 15 16 12 11\n4 16 17 13 12\n4 17 14 10 13\n"
        "4 21 20 19 18\n4 22 23 24 25\n4 18 19 23 22\n4 19 20 24 23\n4 20 21 25 24\n4 21 18 22 25\n";
    const roberts_hide_options options = {.unite = true};
    rng r = {89};
    int line[2] = {-1, -1};
    (void)state;
    for (int round = 0; round < 100; round++) {
        const mat3 turn = round > 0 ? mat3_turn(&r) : mat3_scale(1, 1, 1);
        roberts_mesh mesh = mesh_of_text(text);
        for (size_t v = 0; v < mesh.vertex_count; v++)
            mesh.vertex[v] = mat3_map(turn, mesh.vertex[v]);
        const roberts_camera camera = {
            .dir = vec3_scale(-1, turn.y), .section = mesh.vertex[round % 10], .has_section = round % 10 < 2};
        roberts_scene *scene = build_scene(&mesh);
        roberts_drawing d = drawing_of(scene, &camera, &options);
        int found = -2;
        for (size_t i = 0; i < d.count; i++)
            if (d.segment[i].v0 == 1 && d.segment[i].v1 == 5)
                found = d.segment[i].line;
        int *wanted = &line[camera.has_section];
        if (*wanted != -1 && *wanted != found)
            fail_msg("round %d: the class of the edge is %d in place of %d", round, found, *wanted);
        *wanted = found;
        roberts_drawing_free(&d);
        roberts_scene_free(scene);
    }
    assert_true(line[0] >= 0);
}

/* A box with a facet without area, which the near plane cuts in two points at one place. Rounding may put them in
 * either order. */
static void a_facet_without_area_is_cut(void **state)
{
    roberts_scene *scene = scene_of_text(
        "OFF\n10 16 0\n0 0 0\n1 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n1 0 2\n2 0 2\n2 2 2\n0 2 2\n3 0 2 1\n3 0 3 2\n3 0 4 "
        "3\n"
        "3 5 6 7\n3 5 7 8\n3 5 8 9\n3 0 1 6\n3 0 6 5\n3 1 2 7\n3 1 7 6\n3 2 3 8\n3 2 8 7\n3 3 4 9\n3 3 9 8\n3 4 0 5\n"
        "3 4 5 9\n");
    (void)state;
    for (int i = 0; i <= 40; i++) {
        roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = {3, -4, 5}, .has_look_at = true, .look_at = {1, 1, 1},
                                 .near_distance = 6 + 0.0125 * i};
        const roberts_hide_options options = roberts_hide_options_default();
        roberts_region_list regions;
        size_t sections = 0;
        assert_int_equal(roberts_regions(scene, &camera, &options, &regions, NULL), ROBERTS_OK);
        for (size_t k = 0; k < regions.count; k++)
            sections += regions.region[k].section;
        if (sections != 1)
            fail_msg("%g before the eye: %zu sections", camera.near_distance, sections);
        roberts_regions_free(&regions);
    }
    roberts_scene_free(scene);
}

/* A room, seen from inside, that stands far from the origin. The near plane cuts the floor and two walls close to the
 * eye, where depths are a million times as great as in the rest. */
static void a_room_far_away(void **state)
{
    const roberts_hide_options options = roberts_hide_options_default();
    (void)state;
    for (int i = 0; i < 2; i++) {
        const double x = i * 1000, y = i * 2000;
        char text[400];
        snprintf(text, sizeof text,
                 "OFF\n8 4 0\n%g %g 0\n%g %g 0\n%g %g 0\n%g %g 0\n%g %g 3\n%g %g 3\n%g %g 3\n%g %g 3\n"
                 "4 0 1 2 3\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n",
                 x, y, x + 10, y, x + 10, y + 6, x, y + 6, x, y, x + 10, y, x + 10, y + 6, x, y + 6);
        roberts_scene *scene = scene_of_text(text);
        const roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = {x + 1.3, y + 3.1, 1.7}, .has_look_at = true,
                                       .look_at = {x + 9, y + 3.9, 1.2}};
        roberts_region_list regions;
        assert_int_equal(roberts_regions(scene, &camera, &options, &regions, NULL), ROBERTS_OK);
        assert_int_equal(regions.count, 4);
        roberts_regions_free(&regions);
        roberts_scene_free(scene);
    }
}

/* An L-block is one body that is not convex. The sides between the pieces of its cap are no lines. Without one of its
 * walls it is open, and the cut has a gap. */
static void other_bodies_are_cut(void **state)
{
    static const char *const walls[] = {"4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n", "4 5 0 6 11\n"};
    (void)state;
    for (int open = 0; open < 2; open++) {
        char text[600];
        size_t n = (size_t)sprintf(text, "OFF\n12 %d 0\n", 8 - open);
        for (int z = -1; z <= 1; z += 2)
            n += (size_t)sprintf(text + n, "0 0 %d\n3 0 %d\n3 1 %d\n1 1 %d\n1 2 %d\n0 2 %d\n", z, z, z, z, z, z);
        sprintf(text + n, "6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n%s%s", walls[0], open ? "" : walls[1]);
        roberts_scene *scene = scene_of_text(text);
        expect_cuts(open ? "open" : "L", scene, &eye, false, open ? 5 : 6, open ? 8 : 10, open ? 0 : 4);
        expect_cuts(open ? "open" : "L", scene, &eye, true, open ? 5 : 6, open ? 8 : 10, open ? 0 : 4);
        roberts_scene_free(scene);
    }
}

/* The plane through the middle of a cube, across a diagonal, cuts it in a regular hexagon. */
static void cube_is_cut_in_a_hexagon(void **state)
{
    const roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = {9, 9, 9}, .has_look_at = true,
                                   .near_distance = 9 * sqrt(3)};
    model m = {0};
    (void)state;
    model_box(&m, (roberts_vec3){-1, -1, -1}, (roberts_vec3){1, 1, 1});
    roberts_scene *scene = model_build(&m);
    expect_cuts("hexagon", scene, &camera, false, 6, 6 * sqrt(2), 3 * sqrt(3));
    roberts_scene_free(scene);
    model_free(&m);
}

/* A body that the plane does not cut has no cuts, even if one of its faces lies in it; nor has a view from afar. */
static void what_is_whole_has_no_cuts(void **state)
{
    const roberts_camera far_away = {ROBERTS_PERSPECTIVE, .eye = {0, 0, 10}, .has_look_at = true};
    model m = {0};
    (void)state;
    model_box(&m, (roberts_vec3){-1, -1, -1}, (roberts_vec3){1, 1, 0});
    model_box(&m, (roberts_vec3){2, -1, -1}, (roberts_vec3){3, 1, 1});
    roberts_scene *scene = model_build(&m);
    expect_cuts("face in the plane", scene, &eye, false, 4, 6, 2);
    expect_cuts("far away", scene, &far_away, false, 0, 0, 0);
    roberts_scene_free(scene);
    model_free(&m);
}

/* Nor has a body whose face in the plane crosses itself. The crossings are vertices without a number, as ends of cuts
 * are. */
static void whole_star_has_no_cuts(void **state)
{
    (void)state;
    roberts_scene *scene =
        scene_of_text("OFF\n18 13 0\n"
                      "0 2 0\n-1.9 0.6 0\n-1.2 -1.6 0\n1.2 -1.6 0\n1.9 0.6 0\n"
                      "0 2 -1\n-1.9 0.6 -1\n-1.2 -1.6 -1\n1.2 -1.6 -1\n1.9 0.6 -1\n"
                      "4 0 -1\n5 0 -1\n5 1 -1\n4 1 -1\n4 0 1\n5 0 1\n5 1 1\n4 1 1\n"
                      "5 0 2 4 1 3\n5 8 6 9 7 5\n4 0 5 7 2\n4 2 7 9 4\n4 4 9 6 1\n4 1 6 8 3\n4 3 8 5 0\n"
                      "4 13 12 11 10\n4 14 15 16 17\n4 10 11 15 14\n4 11 12 16 15\n4 12 13 17 16\n"
                      "4 13 10 14 17\n");
    expect_cuts("star", scene, &eye, false, 4, 4, 1);
    expect_cuts("star", scene, &eye, true, 4, 4, 1);
    roberts_scene_free(scene);
}

/* By the odd-even rule, only its points are. */
static void the_middle_of_a_star_is_filled(void **state)
{
    double length[2], area[2];
    model m = {0};
    (void)state;
    put_star(&m, true, -1, 1, 0);
    for (int odd = 0; odd < 2; odd++) {
        roberts_scene *scene = scene_of_mesh(&m.mesh, &(roberts_scene_options){.even_odd = odd});
        roberts_drawing d = drawing_of(scene, &eye, NULL);
        measure_cuts(&d, &length[odd], &area[odd]);
        assert_int_equal(d.cut_count, odd ? 15 : 10);
        assert_true(are_closed(&d));
        roberts_drawing_free(&d);
        roberts_scene_free(scene);
    }
    model_free(&m);
    /* the border of the pentagram winds once round its points and twice round its middle */
    assert_true(fabs(2 * area[0] - area[1] - 51) < 1e-9);
    assert_true(area[0] > area[1] + 1 && length[0] < length[1] - 1);
}

/* The area of the caps that are seen. */
static double area_of_caps(const roberts_scene *scene, const roberts_camera *camera)
{
    roberts_region_list list;
    double sum = 0.0;
    assert_int_equal(roberts_regions(scene, camera, NULL, &list, NULL), ROBERTS_OK);
    for (size_t i = 0; i < list.count; i++)
        sum += list.region[i].section ? list.region[i].area : 0.0;
    roberts_regions_free(&list);
    return sum;
}

/* Any plane cuts a prism over a pentagram as one over a decagon, whatever the winding of the faces. Rays find the same,
 * and the caps are regions. */
static void stars_are_cut_as_if_no_faces_crossed(void **state)
{
    rng r = {83};
    double all = 0.0;
    (void)state;
    for (int round = 0; round < 100; round++) {
        const roberts_vec3 dir = {rng_between(&r, -1, 1), rng_between(&r, -1, 1), rng_between(&r, -1, 1)};
        const roberts_vec3 at = {rng_between(&r, -3, 3), rng_between(&r, -3, 3), rng_between(&r, -3, 3)};
        roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = vec3_add(at, vec3_scale(30 / vec3_length(dir), dir)),
                                 .look_at = at, .has_look_at = true, .near_distance = 30};
        if (round % 2)
            camera = section_of(&camera);
        const unsigned turned = (unsigned)rng_int(&r, 0, 4095);
        double length[2], area[2];
        for (int k = 0; k < 2; k++) {
            model m = {0};
            put_star(&m, k == 0, -4, 3, k == 0 ? turned : 0);
            roberts_scene *scene = model_build(&m);
            roberts_drawing d = drawing_of(scene, &camera, NULL);
            roberts_verification found;
            measure_cuts(&d, &length[k], &area[k]);
            assert_int_equal(roberts_verify(scene, &camera, &d, NULL, &found, NULL), ROBERTS_OK);
            assert_int_equal(found.contradictions, 0);
            assert_true(fabs(area_of_caps(scene, &camera) - area[k]) < 1e-7);
            roberts_drawing_free(&d);
            roberts_scene_free(scene);
            model_free(&m);
        }
        if (fabs(length[0] - length[1]) > 1e-7 || fabs(area[0] - area[1]) > 1e-7)
            fail_msg("round %d: %.12g long in place of %.12g, round %.12g in place of %.12g", round, length[0],
                     length[1], area[0], area[1]);
        all += area[0];
    }
    assert_true(all > 1000);
}

/* Writes a block about the origin with the sides 2 a, 2 b and 2 c, to six decimals. Of its walls two are whole, and two
 * are joined at the height t c if `joined`: then the middles of four edges lie on whole walls only as far as rounding
 * allows. */
static void write_block(const roberts_vec3 side[3], double t, bool joined, char *text)
{
    static const char whole[] = "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 2 3 7 6\n4 1 2 6 5\n4 3 0 4 7\n",
                      parts[] = "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 2 3 7 6\n4 1 2 10 9\n4 9 10 6 5\n4 3 0 8 11\n"
                                "4 11 8 4 7\n";
    text += sprintf(text, "OFF\n%d %d 0\n", joined ? 12 : 8, joined ? 8 : 6);
    for (int k = 0; k < (joined ? 12 : 8); k++) {
        const double a = k % 4 == 1 || k % 4 == 2 ? 1 : -1, b = k % 4 >= 2 ? 1 : -1, c = k < 4 ? -1 : k < 8 ? 1 : t;
        const roberts_vec3 p =
            vec3_add(vec3_add(vec3_scale(a, side[0]), vec3_scale(b, side[1])), vec3_scale(c, side[2]));
        text += sprintf(text, "%.6f %.6f %.6f\n", p.x, p.y, p.z);
    }
    sprintf(text, "%s", joined ? parts : whole);
}

static void rounded_joints_are_cut(void **state)
{
    rng r = {84};
    const roberts_scene_options rounded = {.rounded = true};
    (void)state;
    for (int round = 0; round < 300; round++) {
        const roberts_vec3 side[3] = {{1, rng_real(&r) / 3, rng_real(&r) / 3},
                                      {rng_real(&r) / 3, 1, rng_real(&r) / 3},
                                      {rng_real(&r) / 3, rng_real(&r) / 3, 2}};
        const double t = rng_real(&r) / 2;
        const roberts_camera camera = round % 2 ? section_of(&eye) : eye;
        double area[2];
        for (int joined = 0; joined < 2; joined++) {
            char text[1000];
            write_block(side, t, joined, text);
            roberts_mesh mesh = mesh_of_text(text);
            roberts_scene *scene = scene_of_mesh(&mesh, &rounded);
            area[joined] = area_of_caps(scene, &camera);
            roberts_scene_free(scene);
            roberts_mesh_free(&mesh);
        }
        if (fabs(area[0] - area[1]) > 2e-5)
            fail_msg("round %d: the cap is %g large in place of %g", round, area[1], area[0]);
    }
}

/* The region in which a point of the picture lies; NULL: in none. */
static const roberts_region *region_at(const roberts_region_list *list, roberts_vec2 at)
{
    for (const roberts_region *r = list->region; r < list->region + list->count; r++)
        if (page_rings_hold(r->ring_count, list->ring_start + r->first_ring, list->corner, at))
            return r;
    return NULL;
}

/* How many of some random points have another face in their region than rays find, or no region. */
static size_t wrong_points(const roberts_scene *scene, const roberts_camera *camera, rng *r)
{
    roberts_region_list list;
    size_t wrong = 0;
    assert_int_equal(roberts_regions(scene, camera, NULL, &list, NULL), ROBERTS_OK);
    for (int i = 0; i < 200; i++) {
        const roberts_vec2 at = {rng_between(r, -1.2, 1.2), rng_between(r, -1.2, 1.2)};
        const roberts_region *region = region_at(&list, at);
        roberts_picked picked;
        assert_int_equal(roberts_pick(scene, camera, at.x, at.y, &picked, NULL), ROBERTS_OK);
        wrong += (region ? region->face : ROBERTS_NONE - 1) != (picked.count ? picked.hit[0].face : ROBERTS_NONE - 1);
        roberts_picked_free(&picked);
    }
    roberts_regions_free(&list);
    return wrong;
}

/* Where faces cannot be oriented alike, parity decides what is filled: the middle of a pentagram counts twice, and so
 * not at all, whatever the rule by which it is filled. */
static void one_sided_stars_are_cut(void **state)
{
    rng r = {85};
    double all = 0.0;
    (void)state;
    roberts_mesh mesh = mesh_of_file("models/star/great-dodecahemidodecahedron.off");
    for (int round = 0; round < 30; round++) {
        const roberts_vec3 dir = {rng_between(&r, -1, 1), rng_between(&r, -1, 1), rng_between(&r, -1, 1)};
        roberts_camera camera = {ROBERTS_PERSPECTIVE, .eye = vec3_scale(30 / vec3_length(dir), dir),
                                 .has_look_at = true, .near_distance = rng_between(&r, 28.5, 31.5)};
        if (round % 2)
            camera = section_of(&camera);
        double area[2];
        for (int even_odd = 0; even_odd < 2; even_odd++) {
            const roberts_scene_options options = {.even_odd = even_odd, .rounded = true};
            roberts_scene *scene = scene_of_mesh(&mesh, &options);
            area[even_odd] = area_of_caps(scene, &camera);
            assert_int_equal(wrong_points(scene, &camera, &r), 0);
            roberts_scene_free(scene);
        }
        if (fabs(area[0] - area[1]) > 1e-7)
            fail_msg("round %d: the cap is %g large in place of %g", round, area[0], area[1]);
        all += area[0];
    }
    assert_true(all > 10);
    roberts_mesh_free(&mesh);
}

/* Where coordinates are rounded to three decimals, cuts of faces that cross themselves end some thousandths apart. The
 * section changes no more than the body. */
static void rounded_stars_are_cut(void **state)
{
    static const char *const models[] = {"models/star/great-stellated-dodecahedron.off",
                                         "models/star/small-stellated-dodecahedron.off",
                                         "models/star/great-icosahedron.off"};
    rng r = {88};
    (void)state;
    for (int round = 0; round < 300; round++) {
        const roberts_camera camera = {.dir = rng_vec3(&r, 1.0), .section = rng_vec3(&r, 0.3), .has_section = true};
        const mat3 turn = mat3_turn(&r);
        double area[2];
        for (int rounded = 0; rounded < 2; rounded++) {
            model m = {.mesh = mesh_of_file(models[round % 3])};
            model_map(&m, turn, (roberts_vec3){0, 0, 0});
            if (rounded)
                model_to_digits(&m, 3);
            roberts_scene *scene = build_scene(&m.mesh);
            area[rounded] = area_of_caps(scene, &camera);
            roberts_scene_free(scene);
        }
        if (fabs(area[0] - area[1]) > 0.02)
            fail_msg("round %d, %s: the section is %g large in place of %g", round, models[round % 3], area[1],
                     area[0]);
    }
}

/* Near an eye amid the scene, the picture is large, and so is the rounding of the vertices that are cut. A sheet within
 * another one changes nothing of what both cover. */
static void sheets_near_the_eye_are_cut_in_one_line(void **state)
{
    static const char one[] = "OFF\n4 1 0\n0 2 0\n3 2 0\n3 4 0\n0 4 0\n4 0 1 2 3\n",
                      two[] = "OFF\n8 2 0\n0 2 0\n3 2 0\n3 4 0\n0 4 0\n1 2 0\n3 2.5 0\n3 3.5 0\n1 4 0\n"
                              "4 0 1 2 3\n4 4 5 6 7\n";
    const roberts_camera camera = {
        .projection = ROBERTS_PERSPECTIVE, .eye = {3.5, 2.5, 5.5}, .look_at = {5, 3, 5}, .has_look_at = true};
    double area[2] = {0, 0};
    (void)state;
    for (int i = 0; i < 2; i++) {
        roberts_scene *scene = scene_of_text(i ? two : one);
        roberts_region_list l;
        assert_int_equal(roberts_regions(scene, &camera, NULL, &l, NULL), ROBERTS_OK);
        for (size_t k = 0; k < l.count; k++)
            area[i] += l.region[k].area;
        roberts_regions_free(&l);
        roberts_scene_free(scene);
    }
    assert_true(area[0] > 1e6);
    assert_true(fabs(area[1] - area[0]) < 1e-9 * area[0]);
}

/* ---- sections of any direction ---- */

/* Has the drawing this line, in either direction, farther to the right and up by (dx, dy)? */
static bool has_line(const roberts_drawing *d, const roberts_segment *s, double dx, double dy)
{
    const roberts_vec2 P = {s->p0.x + dx, s->p0.y + dy}, Q = {s->p1.x + dx, s->p1.y + dy};
    for (const roberts_segment *t = d->segment, *end = t + d->count + d->cut_count; t < end; t++) {
        const double there = hypot(P.x - t->p0.x, P.y - t->p0.y) + hypot(Q.x - t->p1.x, Q.y - t->p1.y);
        const double back = hypot(P.x - t->p1.x, P.y - t->p1.y) + hypot(Q.x - t->p0.x, Q.y - t->p0.y);
        if (fmin(there, back) < 1e-9)
            return true;
    }
    return false;
}

static roberts_scene *boxes_up_to(double x)
{
    static const double box[][6] = {
        {-1, -1, -1, 1, 1, 1}, {-2, 1, -1, 2, 1.5, 2}, {-0.5, -3, 0, 0.5, -2, 3}, {0.6, -5, 0, 0.9, 5, 1}};
    model m = {0};
    for (size_t i = 0; i < sizeof box / sizeof box[0]; i++)
        if (box[i][0] < x)
            model_box(&m, (roberts_vec3){box[i][0], box[i][1], box[i][2]},
                      (roberts_vec3){fmin(box[i][3], x), box[i][4], box[i][5]});
    roberts_scene *scene = model_build(&m);
    model_free(&m);
    return scene;
}

/* Boxes that a plane cuts, seen from anywhere before it, look like those that end there. */
static void half_of_boxes(void **state)
{
    roberts_scene *whole = boxes_up_to(9), *half = boxes_up_to(0.25);
    rng r = {7};
    (void)state;
    for (int i = 0; i < 500; i++) {
        const roberts_vec3 dir = {rng_between(&r, 0.01, 1), rng_between(&r, -1, 1), rng_between(&r, -1, 1)};
        const roberts_camera plain = {.dir = dir};
        roberts_camera cut = plain;
        cut.section = (roberts_vec3){0.25, 7, i};
        cut.section_normal = (roberts_vec3){i + 1, 0, 0};
        cut.has_section = true;
        roberts_drawing a = drawing_of(whole, &cut, NULL), b = drawing_of(half, &plain, NULL);
        const roberts_vec3 corner = {-1, -1, -1}; /* the middle of the picture is that of the scene's box */
        roberts_vec3 from, to;
        assert_int_equal(roberts_project(whole, &cut, &corner, 1, &from, NULL), ROBERTS_OK);
        assert_int_equal(roberts_project(half, &plain, &corner, 1, &to, NULL), ROBERTS_OK);
        if (a.count + a.cut_count != b.count || a.cut_count != 12)
            fail_msg("row %d: %zu lines and %zu cuts in place of %zu lines", i, a.count, a.cut_count, b.count);
        for (size_t k = 0; k < a.count + a.cut_count; k++)
            if (!has_line(&b, &a.segment[k], to.x - from.x, to.y - from.y))
                fail_msg("row %d: line %zu is not there", i, k);
        roberts_region_list cut_regions, regions;
        double area = 0.0;
        assert_int_equal(roberts_regions(whole, &cut, NULL, &cut_regions, NULL), ROBERTS_OK);
        assert_int_equal(roberts_regions(half, &plain, NULL, &regions, NULL), ROBERTS_OK);
        for (size_t k = 0; k < cut_regions.count; k++)
            area += cut_regions.region[k].area;
        for (size_t k = 0; k < regions.count; k++)
            area -= regions.region[k].area;
        if (cut_regions.count != regions.count || fabs(area) > 1e-9)
            fail_msg("row %d: %zu regions in place of %zu, and %g more area", i, cut_regions.count, regions.count,
                     area);
        roberts_regions_free(&cut_regions);
        roberts_regions_free(&regions);
        roberts_drawing_free(&a);
        roberts_drawing_free(&b);
    }
    roberts_scene_free(whole);
    roberts_scene_free(half);
}

/* Two boxes one behind the other, cut, and seen along the section: the right-hand side of the picture is that of the
 * higher one, whether bodies are united or not. */
static void seen_along_the_section(void **state)
{
    const roberts_camera camera = {
        .dir = {0, -1, 0}, .section = {0, 0, 0}, .section_normal = {1, 0, 0}, .has_section = true};
    model m = {0};
    (void)state;
    model_box(&m, (roberts_vec3){-1, -5, 0}, (roberts_vec3){1, -4, 1});
    model_box(&m, (roberts_vec3){-1, 0, 0}, (roberts_vec3){1, 1, 3});
    roberts_scene *scene = model_build(&m);
    for (int unite = 0; unite < 2; unite++) {
        const roberts_hide_options options = {.unite = unite};
        roberts_drawing d = drawing_of(scene, &camera, &options);
        const roberts_segment *side = NULL;
        for (const roberts_segment *s = d.segment; s < d.segment + d.count + d.cut_count; s++)
            if (fabs(s->p0.x - s->p1.x) < 1e-9 && fabs(fabs(s->p1.y - s->p0.y) - 3.0) < 1e-9 &&
                (!side || s->p0.x > side->p0.x))
                side = s;
        assert_non_null(side);
        assert_float_equal(side->p0.x - d.window_min.x, 1.0, 1e-9);
        roberts_drawing_free(&d);
    }
    roberts_scene_free(scene);
    model_free(&m);
}

/* Sections that face away, from an eye, or with a direction that is no number, are refused; one that is seen edge-on is
 * not. */
static void directions_of_sections(void **state)
{
    const roberts_camera cameras[] = {
        {.dir = {1, 0, 1}, .section_normal = {-1, 0, 0}, .has_section = true},
        {.dir = {0, 0, 1}, .oblique = {-1, 0}, .section_normal = {1, 0, 0}, .has_section = true},
        {.projection = ROBERTS_PERSPECTIVE, .eye = {9, 0, 9}, .section_normal = {1, 0, 0}, .has_section = true},
        {.dir = {1, 0, 1}, .section_normal = {NAN, 0, 0}, .has_section = true},
        {.dir = {0, 0.1, 1}, .section_normal = {3e200, 0, 0}, .has_section = true},
        {.dir = {0, 0, 1}, .oblique = {1, 0}, .section_normal = {1, 0, 0}, .has_section = true}};
    static const char *const said[] = {
        "the section faces away from the viewer; turn its direction round, or look from the other side",
        "the section faces away from the viewer; turn its direction round, or look from the other side",
        "from an eye, a section has no direction but the axis of sight",
        "the point and the direction of the section must be finite",
        NULL,
        NULL};
    roberts_scene *scene = boxes_up_to(9);
    (void)state;
    for (size_t i = 0; i < sizeof cameras / sizeof cameras[0]; i++) {
        roberts_drawing d;
        roberts_error error = {0};
        const roberts_status status = roberts_hide(scene, &cameras[i], NULL, &d, &error);
        print_message("row %zu: %s\n", i, error.message);
        assert_int_equal(status, said[i] ? ROBERTS_BAD_VIEW : ROBERTS_OK);
        if (said[i])
            assert_string_equal(error.message, said[i]);
        else
            assert_true(d.sectioned && d.cut_count > 0);
        roberts_drawing_free(&d);
    }
    roberts_scene_free(scene);
}

/* ---- edges that are lines, whatever the order of bodies and faces ---- */

static const struct {
    const char *name, *text;
    roberts_camera camera;
    bool unite;
    double crease;
    uint32_t body, v[2]; /* the edge, a visible crease */
} crease_cases[] = {
    {"a ridge in the plane of a section, whose faces part from it",
     "OFF\n14 9 0\n0 0 0\n4 0 0\n4 0 4\n2 0 4\n2 0 1\n1 0 2\n0 0 1\n0 3 0\n4 3 0\n4 3 4\n2 3 4\n2 3 1\n1 3 2\n0 3 1\n"
     "7 6 5 4 3 2 1 0\n7 7 8 9 10 11 12 13\n4 0 1 8 7\n4 1 2 9 8\n4 2 3 10 9\n4 3 4 11 10\n4 4 5 12 11\n4 5 6 13 12\n"
     "4 6 0 7 13\n",
     {.dir = {1, -2, 2}, .has_section = true, .section = {0, 0, 2}, .section_normal = {0, 0, 1}},
     false,
     0,
     0,
     {5, 12}},
    {"a knife's edge, of two flush halves",
     "OFF\n12 10 0\n0 0 0\n5 0 0\n5 1 0\n0 0 3\n5 0 3\n5 1 3\n0 0 0\n5 -1 0\n5 0 0\n0 0 3\n5 -1 3\n5 0 3\n"
     "3 2 1 0\n3 3 4 5\n4 0 1 4 3\n4 1 2 5 4\n4 2 0 3 5\n3 8 7 6\n3 9 10 11\n4 6 7 10 9\n4 7 8 11 10\n4 8 6 9 11\n",
     {.dir = {-1, .05, .3}},
     true,
     30,
     0,
     {0, 3}},
    {"three sides at angles of 45, 45 and 90 degrees",
     "OFF\n14 11 0\n0 1 1\n2 1 1\n2 2 1\n0 2 1\n0 1 2\n2 1 2\n2 2 2\n0 2 2\n0 1 0\n1 0 0\n0 0 0\n0 1 2\n1 0 2\n0 0 2\n"
     "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n3 10 9 8\n3 11 12 13\n4 8 9 12 11\n4 9 10 13 "
     "12\n"
     "4 10 8 11 13\n",
     {.dir = {-3, -1, 7}},
     true,
     50,
     0,
     {0, 4}},
    {"a fan of three sheets, the middle one first",
     "OFF\n8 3 0\n0 0 0\n0 0 3\n4 0 0\n4 0 3\n0 -4 0\n0 -4 3\n-3 -3 0\n-3 -3 3\n4 0 1 7 6\n4 0 1 3 2\n4 0 1 5 4\n",
     {.dir = {1, -3, 1}},
     false,
     50,
     0,
     {0, 1}},
    {"two edges in one place in the plane of a section, which takes the first one away",
     "OFF\n20 14 0\n0 0 0\n0 2 0\n0 2 1\n0 1 1\n0 1 2\n0 0 2\n1 0 0\n1 2 0\n1 2 1\n1 1 1\n1 1 2\n1 0 2\n1 1 1\n2 1 1\n"
     "2 2 1\n1 2 1\n1 1 2\n2 1 2\n2 2 2\n1 2 2\n6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n"
     "4 3 4 10 9\n4 4 5 11 10\n4 5 0 6 11\n4 15 14 13 12\n4 16 17 18 19\n4 12 13 17 16\n4 13 14 18 17\n4 14 15 19 18\n"
     "4 15 12 16 19\n",
     {.dir = {0, -1, 0}, .has_section = true, .section = {1, 1, 0}, .section_normal = {-1, -1, 0}},
     true,
     0,
     1,
     {12, 16}},
    {"an inner corner of three cubes: the class is that without a section",
     "OFF\n24 18 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n0 1 0\n1 1 0\n1 2 0\n0 2 0\n0 1 1\n1 1 1\n"
     "1 2 1\n0 2 1\n0 1 1\n1 1 1\n1 2 1\n0 2 1\n0 1 2\n1 1 2\n1 2 2\n0 2 2\n4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 "
     "5\n"
     "4 2 3 7 6\n4 3 0 4 7\n4 11 10 9 8\n4 12 13 14 15\n4 8 9 13 12\n4 9 10 14 13\n4 10 11 15 14\n4 11 8 12 15\n"
     "4 19 18 17 16\n4 20 21 22 23\n4 16 17 21 20\n4 17 18 22 21\n4 18 19 23 22\n4 19 16 20 23\n",
     {.dir = {1, -1, 1}, .has_section = true, .section = {1, .5, 1}},
     true,
     0,
     0,
     {6, 7}},
};

static void creases_by_table(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof crease_cases / sizeof crease_cases[0]; i++) {
        roberts_scene *scene = scene_of_text(crease_cases[i].text);
        roberts_hide_options options = roberts_hide_options_default();
        roberts_drawing drawing;
        size_t found = 0;
        options.unite = crease_cases[i].unite;
        if (crease_cases[i].crease > 0.0) {
            options.crease_degrees = crease_cases[i].crease;
            options.crease_auto = false;
        }
        assert_int_equal(roberts_hide(scene, &crease_cases[i].camera, &options, &drawing, NULL), ROBERTS_OK);
        for (const roberts_segment *s = drawing.segment; s < drawing.segment + drawing.count; s++) {
            const scene_edge edge = scene_edge_at(scene, s->solid, s->edge);
            found += s->solid == crease_cases[i].body && s->state == ROBERTS_VISIBLE && s->line == ROBERTS_CREASE &&
                     scene_vertex_number(scene, edge.v[0]) == crease_cases[i].v[0] &&
                     scene_vertex_number(scene, edge.v[1]) == crease_cases[i].v[1];
        }
        if (found != 1)
            fail_msg("%s: found %zu times", crease_cases[i].name, found);
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes_are_cut),
        cmocka_unit_test(what_is_taken_away_leaves_no_seam),
        cmocka_unit_test(contacts_are_cut_as_what_is_behind_them),
        cmocka_unit_test(faces_in_the_plane_are_cut_alike),
        cmocka_unit_test(folds_in_the_plane_stay),
        cmocka_unit_test(a_facet_without_area_is_cut),
        cmocka_unit_test(a_room_far_away),
        cmocka_unit_test(other_bodies_are_cut),
        cmocka_unit_test(cube_is_cut_in_a_hexagon),
        cmocka_unit_test(what_is_whole_has_no_cuts),
        cmocka_unit_test(whole_star_has_no_cuts),
        cmocka_unit_test(the_middle_of_a_star_is_filled),
        cmocka_unit_test(stars_are_cut_as_if_no_faces_crossed),
        cmocka_unit_test(rounded_joints_are_cut),
        cmocka_unit_test(one_sided_stars_are_cut),
        cmocka_unit_test(rounded_stars_are_cut),
        cmocka_unit_test(half_of_boxes),
        cmocka_unit_test(seen_along_the_section),
        cmocka_unit_test(directions_of_sections),
        cmocka_unit_test(sheets_near_the_eye_are_cut_in_one_line),
        cmocka_unit_test(creases_by_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
