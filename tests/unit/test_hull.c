/* test_hull.c - convex hulls that replace anything that is no convex solid. Hulls of points with small whole
 * coordinates are compared with exact integer arithmetic, all others by counts, drawings and messages. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/scene.h"
#include "same_scene.h"
#include "scenes.h"
#include "testing.h"

#include "program.h"
#include "whole.h"

/* Counts of a scene. */
typedef struct counts {
    size_t solids, vertices, faces;
} counts;

static counts counts_of(const roberts_scene *scene)
{
    return (counts){roberts_scene_solid_count(scene), roberts_scene_vertex_count(scene),
                    roberts_scene_face_count(scene)};
}

static roberts_status build(const roberts_mesh *mesh, bool hull, double tolerance, roberts_scene **scene,
                            roberts_error *error)
{
    roberts_scene_options options = {.hull = hull, .solids = !hull, .tolerance = tolerance};
    return roberts_scene_build(mesh, &options, scene, error);
}

static void read_off(roberts_mesh *mesh, const char *name, const char *off)
{
    roberts_error error = {0};
    if (roberts_mesh_read_memory(mesh, name, off, strlen(off), NULL, &error) != ROBERTS_OK)
        fail_msg("%s: line %zu: %s", name, error.line, error.message);
}

/* ---- whole numbers --------------------------------------------------------------------------------------------- */

static whole corner_at(const roberts_scene *scene, uint32_t f, uint32_t i)
{
    uint32_t start = scene->face_start[f], n = scene->face_start[f + 1] - start;
    roberts_vec3 p = scene->point[scene->corner[start + i % n]];
    return (whole){(int64_t)p.x, (int64_t)p.y, (int64_t)p.z};
}

/* The normal of face f outward, by its first three corners. */
static whole outward(const roberts_scene *scene, uint32_t f)
{
    whole a = corner_at(scene, f, 0);
    return whole_cross(whole_sub(corner_at(scene, f, 1), a), whole_sub(corner_at(scene, f, 2), a));
}

/* Each face is strictly convex and planar, all points lie behind its plane or in it, and no two neighbours are
 * coplanar. Only one polyhedron is like this. */
static void assert_exact_hull(const roberts_scene *scene, const roberts_mesh *mesh)
{
    for (uint32_t f = 0; f < scene->face_count; f++) {
        whole n = outward(scene, f), a = corner_at(scene, f, 0);
        assert_true(whole_dot(n, n) > 0);
        for (uint32_t i = 0; i < scene->face_start[f + 1] - scene->face_start[f]; i++) {
            whole p = corner_at(scene, f, i), q = corner_at(scene, f, i + 1), r = corner_at(scene, f, i + 2);
            assert_int_equal(whole_dot(n, whole_sub(p, a)), 0);
            assert_true(whole_dot(n, whole_cross(whole_sub(q, p), whole_sub(r, q))) > 0);
        }
        for (size_t v = 0; v < mesh->vertex_count; v++) {
            roberts_vec3 p = mesh->vertex[v];
            assert_true(whole_dot(n, whole_sub((whole){(int64_t)p.x, (int64_t)p.y, (int64_t)p.z}, a)) <= 0);
        }
    }
    for (uint32_t s = 0; s < scene->solid_count; s++)
        for (uint32_t e = scene->solid[s].edge; e < scene->solid[s + 1].edge; e++) {
            scene_edge edge = scene_edge_at(scene, s, e);
            whole n = outward(scene, edge.f[0]), m = outward(scene, edge.f[1]), c = whole_cross(n, m);
            assert_true(c.x || c.y || c.z);
        }
}

static bool all_in_one_plane(const roberts_mesh *mesh)
{
    whole p[64], n = {0, 0, 0}, u = {0, 0, 0};
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        p[v] = (whole){(int64_t)mesh->vertex[v].x, (int64_t)mesh->vertex[v].y, (int64_t)mesh->vertex[v].z};
        if (whole_dot(u, u) == 0)
            u = whole_sub(p[v], p[0]);
        if (whole_dot(n, n) == 0)
            n = whole_cross(u, whole_sub(p[v], p[0]));
    }
    for (size_t v = 0; v < mesh->vertex_count; v++)
        if (whole_dot(n, whole_sub(p[v], p[0])) != 0)
            return false;
    return true;
}

static void whole_points(void **state)
{
    static const struct {
        int size;         /* coordinates are 0 .. size */
        double tolerance; /* small enough that no plane through points passes others by less */
    } kind[] = {{1, 0}, {2, 0}, {3, 0}, {7, 0}, {12, 0}, {1000, 1e-11}};
    (void)state;
    rng r = {2026};
    size_t flat = 0, hulls = 0;
    for (size_t k = 0; k < sizeof kind / sizeof kind[0]; k++)
        for (int round = 0; round < 300; round++) {
            roberts_mesh mesh = {0};
            roberts_scene *scene = NULL;
            roberts_error error = {0};
            int count = rng_int(&r, 4, 60);
            for (int i = 0; i < count; i++) {
                roberts_vec3 p = {rng_int(&r, 0, kind[k].size), rng_int(&r, 0, kind[k].size),
                                  rng_int(&r, 0, kind[k].size)};
                mesh_vertex(&mesh, p);
            }
            roberts_status status = build(&mesh, true, kind[k].tolerance, &scene, &error);
            if (status != (all_in_one_plane(&mesh) ? ROBERTS_FLAT : ROBERTS_OK))
                fail_msg("size %d, round %d: status %d, %s", kind[k].size, round, status, error.message);
            if (status == ROBERTS_OK)
                assert_exact_hull(scene, &mesh);
            flat += status != ROBERTS_OK;
            hulls += status == ROBERTS_OK;
            roberts_scene_free(scene);
            roberts_mesh_free(&mesh);
        }
    print_message("%zu hulls, %zu flat\n", hulls, flat);
    assert_true(hulls > 1500 && flat > 0);
}

/* ---- points in doubles ----------------------------------------------------------------------------------------- */

/* Turned grids, repeated points and spheres, moved by up to `noise` and of very different sizes: hulls are found, and
 * all points lie inside them, within the tolerance. */
static void noisy_points(void **state)
{
    static const double noises[] = {0, 1e-17, 1e-15, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5, 1e-3};
    static const double sizes[] = {1, 1e-300, 1e-9, 1e9, 1e149};
    (void)state;
    rng r = {7};
    for (size_t n = 0; n < sizeof noises / sizeof noises[0]; n++)
        for (int round = 0; round < 60; round++) {
            double size = sizes[round % 5], noise = noises[n];
            mat3 turn = mat3_turn(&r);
            roberts_mesh mesh = {0};
            roberts_scene *scene = NULL;
            roberts_error error = {0};
            for (int i = 0; i < 125; i++) {
                double z = (i + 0.5) / 62.5 - 1, ring = sqrt(1 - z * z);
                roberts_vec3 grid = {i % 5 / 4.0, i / 5 % 5 / 4.0, i / 25 / 4.0};
                roberts_vec3 few = {i % 7 / 7.0, i % 5 / 5.0 + i % 7 / 9.0, i % 3}; /* many at one place */
                roberts_vec3 sphere = {ring * cos(i * 2.4), ring * sin(i * 2.4), z};
                roberts_vec3 p = mat3_map(turn, round % 3 == 0 ? grid : round % 3 == 1 ? few : sphere);
                p = (roberts_vec3){size * (p.x + noise * rng_between(&r, -1, 1)),
                                   size * (p.y + noise * rng_between(&r, -1, 1)),
                                   size * (p.z + noise * rng_between(&r, -1, 1))};
                mesh_vertex(&mesh, p);
            }
            if (build(&mesh, true, 0, &scene, &error) != ROBERTS_OK)
                fail_msg("noise %g, round %d: %s", noise, round, error.message);
            roberts_vec3 across = vec3_sub(scene->box_max, scene->box_min);
            double bound = 1e-5 * size * vec3_length(vec3_scale(1 / size, across)); /* squares must not vanish */
            for (uint32_t f = 0; f < scene->face_count; f++)
                for (size_t v = 0; v < mesh.vertex_count; v++) {
                    double inside = plane_at(scene_plane(scene, f), vec3_sub(mesh.vertex[v], scene->centre));
                    if (scene_width(scene, f) > 1e-3 * size && !(inside >= -bound))
                        fail_msg("noise %g, round %d: vertex %zu is %g outside face %u", noise, round, v, -inside, f);
                }
            roberts_scene_free(scene);
            roberts_mesh_free(&mesh);
        }
}

static double six_decimals(double x)
{
    return round(x * 1e6) / 1e6;
}

/* A turned prism of eight sides, given as points of six digits: it has ten faces, though none of them is exactly
 * planar. */
static void six_digits(void **state)
{
    (void)state;
    rng r = {11};
    for (int round = 0; round < 50; round++) {
        mat3 turn = mat3_turn(&r);
        roberts_mesh mesh = {0};
        roberts_scene *scene = NULL;
        for (int i = 0; i < 16; i++) {
            double angle = atan(1) * (i / 2);
            roberts_vec3 p = mat3_map(turn, (roberts_vec3){cos(angle), sin(angle), i % 2});
            p = (roberts_vec3){six_decimals(p.x), six_decimals(p.y), six_decimals(p.z)};
            mesh_vertex(&mesh, p);
        }
        assert_int_equal(build(&mesh, true, 0, &scene, NULL), ROBERTS_OK);
        assert_int_equal(roberts_scene_face_count(scene), 10);
        assert_int_equal(roberts_scene_vertex_count(scene), 16);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

/* ---- what becomes of what -------------------------------------------------------------------------------------- */

#define CUBE_POINTS "0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\n"
#define CUBE_FACES "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"

/* An L of 12 corners and 8 faces: its hull loses the two of the inner edge. */
#define L_POINTS "0 0 0 2 0 0 2 1 0 1 1 0 1 2 0 0 2 0 0 0 1 2 0 1 2 1 1 1 1 1 1 2 1 0 2 1\n"
#define L_FACES "6 0 5 4 3 2 1\n6 6 7 8 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n4 5 0 6 11\n"

static const struct {
    const char *name, *off;
    counts hull;
} made[] = {
    {"points of a cube", "OFF\n8 0 0\n" CUBE_POINTS, {1, 8, 6}},
    {"... and some inside, on faces and on edges, the first of them",
     "OFF\n12 0 0\n.5 .5 .5\n.5 .5 1\n.5 0 0\n.1 .2 .3\n" CUBE_POINTS,
     {1, 8, 6}},
    {"... each twice", "OFF\n16 0 0\n" CUBE_POINTS CUBE_POINTS, {1, 8, 6}},
    {"points with one- and two-cornered faces", "OFF\n8 3 0\n" CUBE_POINTS "1 0\n2 0 1\n1 7\n", {1, 8, 6}},
    {"a whole cube", "OFF\n8 6 0\n" CUBE_POINTS CUBE_FACES, {1, 8, 6}},
    {"a cube without a side",
     "OFF\n8 5 0\n" CUBE_POINTS "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n",
     {1, 8, 6}},
    {"a cube with a point that no face uses",
     "OFF\n9 5 0\n" CUBE_POINTS "9 9 9\n4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n"
     "4 2 6 7 3\n4 0 4 6 2\n",
     {1, 8, 6}},
    {"a cube of two loose sides that share no edge", "OFF\n8 2 0\n" CUBE_POINTS "4 0 2 3 1\n4 0 1 5 4\n", {1, 6, 5}},
    {"an L", "OFF\n12 8 0\n" L_POINTS L_FACES, {1, 10, 7}},
    {"an L without an end",
     "OFF\n12 7 0\n" L_POINTS "6 0 5 4 3 2 1\n6 6 7 8 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n"
     "4 3 4 10 9\n4 5 0 6 11\n",
     {1, 10, 7}},
    {"a cube within an L's hull, a solid of its own, before it",
     "OFF\n20 14 0\n" CUBE_POINTS
     "-1 -1 -1 9 -1 -1 9 4 -1 4 4 -1 4 9 -1 -1 9 -1 -1 -1 8 9 -1 8 9 4 8 4 4 8 4 9 8 -1 9 8\n" CUBE_FACES
     "6 8 13 12 11 10 9\n6 14 15 16 17 18 19\n4 8 9 15 14\n4 9 10 16 15\n4 10 11 17 16\n4 11 12 18 17\n"
     "4 12 13 19 18\n4 13 8 14 19\n",
     {2, 18, 13}},
    {"two cubes that share a corner, one of them open: still two",
     "OFF\n15 11 0\n" CUBE_POINTS "2 1 1 1 2 1 2 2 1 1 1 2 2 1 2 1 2 2 2 2 2\n" CUBE_FACES
     "4 7 9 10 8\n4 11 12 14 13\n4 7 8 12 11\n4 9 13 14 10\n4 7 11 13 9\n",
     {2, 16, 12}},
    {"two cubes that share an edge, one of them open: they do not come apart",
     "OFF\n14 11 0\n" CUBE_POINTS "2 1 0 1 2 0 2 2 0 2 1 1 1 2 1 2 2 1\n" CUBE_FACES
     "4 3 8 10 9\n4 7 12 13 11\n4 3 7 11 8\n4 8 11 13 10\n4 10 13 12 9\n",
     {1, 12, 8}},
    {"two triangles that share a position, and no edge",
     "OFF\n6 2 0\n0 0 0 1 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n3 0 1 2\n3 3 4 5\n",
     {1, 4, 4}},
    {"a quadrilateral bent by a tenth, in a closed solid",
     "OFF\n8 6 0\n0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1.1\n" CUBE_FACES,
     {1, 8, 7}},
};

static void solids(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof made / sizeof made[0]; i++) {
        roberts_mesh mesh = {0};
        roberts_scene *scene = NULL;
        roberts_error error = {0};
        read_off(&mesh, made[i].name, made[i].off);
        if (build(&mesh, true, 0, &scene, &error) != ROBERTS_OK)
            fail_msg("%s: %s", made[i].name, error.message);
        counts found = counts_of(scene), wanted = made[i].hull;
        if (found.solids != wanted.solids || found.vertices != wanted.vertices || found.faces != wanted.faces)
            fail_msg("%s: %zu solids, %zu vertices, %zu faces", made[i].name, found.solids, found.vertices,
                     found.faces);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

/* With several files, each keeps its numbers: a hull is numbered by all its points. */
static void several_files(void **state)
{
    (void)state;
    roberts_mesh mesh = {0};
    roberts_scene *scene = NULL;
    roberts_error error = {0};
    read_off(&mesh, "points", "OFF\n9 0 0\n.5 .5 .5\n" CUBE_POINTS);
    read_off(&mesh, "L", "OFF\n12 8 0\n" L_POINTS L_FACES);
    read_off(&mesh, "cube",
             "COFF\n8 6 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n1 1 0 1 0 0 1\n0 0 1 1 0 0 1\n"
             "1 0 1 1 0 0 1\n0 1 1 1 0 0 1\n1 1 1 1 0 0 1\n4 0 2 3 1 255 0 0\n4 4 5 7 6 255 0 0\n"
             "4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n");
    assert_int_equal(build(&mesh, false, 0, &scene, &error), ROBERTS_NOT_CONVEX);
    assert_int_equal(build(&mesh, true, 0, &scene, &error), ROBERTS_OK);
    assert_int_equal(scene->solid_count, 3);
    for (uint32_t s = 0; s < 3; s++) {
        static const uint32_t first[] = {1, 9, 21}; /* vertices that the solids have */
        assert_int_equal(scene_vertex_number(scene, scene->solid[s].vertex), first[s]);
        for (uint32_t f = scene->solid[s].face; f < scene->solid[s + 1].face; f++) {
            uint32_t place = f - scene->solid[s].face; /* the cube's faces are those of the file, with its colours */
            assert_int_equal(scene_face_number(scene, f), s < 2 ? ROBERTS_NONE : 8 + place);
            assert_int_equal(scene->face_color[f].count, s == 2 && place < 2 ? 3 : 0);
        }
    }
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
}

static const struct {
    const char *name, *off;
    double tolerance;
    roberts_status status;
    const char *message;
} refused[] = {
    {"nothing", "OFF\n0 0 0\n", 0, ROBERTS_NOT_CLOSED,
     "nothing to draw: there is no face with three different corners"},
    {"one point", "OFF\n1 0 0\n0 0 0\n", 0, ROBERTS_FLAT, "a convex hull takes four points, but there is 1"},
    {"three points", "OFF\n3 0 0\n0 0 0 1 0 0 0 1 0\n", 0, ROBERTS_FLAT,
     "a convex hull takes four points, but there are 3"},
    {"four points at one place", "OFF\n4 0 0\n1 2 3 1 2 3 1 2 3 1 2 3\n", 0, ROBERTS_FLAT,
     "the convex hull of solid 0, of 4 points from vertex 0 on, is flat: they lie in one plane, or nearly so"},
    {"points in a line", "OFF\n5 0 0\n0 0 0 1 2 3 2 4 6 3 6 9 4 8 12\n", 0, ROBERTS_FLAT,
     "the convex hull of solid 0, of 5 points from vertex 0 on, is flat: they lie in one plane, or nearly so"},
    {"points in a plane", "OFF\n5 0 0\n0 0 0 1 0 1 0 1 1 1 1 2 5 3 8\n", 0, ROBERTS_FLAT,
     "the convex hull of solid 0, of 5 points from vertex 0 on, is flat: they lie in one plane, or nearly so"},
    {"points nearly in a plane", "OFF\n4 0 0\n0 0 0 1 0 0 0 1 0 1 1 1e-11\n", 0, ROBERTS_FLAT,
     "the convex hull of solid 0, of 4 points from vertex 0 on, is flat: they lie in one plane, or nearly so"},
    {"a triangle", "OFF\n3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n", 0, ROBERTS_FLAT,
     "the convex hull of solid 0, of 3 points from vertex 0 on, is flat: they lie in one plane, or nearly so"},
    {"two triangles", "OFF\n6 2 0\n0 0 0 1 0 0 0 1 0 5 5 5 6 5 5 5 6 5\n3 3 4 5\n3 0 1 2\n", 0, ROBERTS_FLAT,
     "the convex hull of solid 0, of 3 points from vertex 0 on, is flat: they lie in one plane, or nearly so"},
    {"a tolerance out of range", "OFF\n8 0 0\n" CUBE_POINTS, 2, ROBERTS_BAD_ARGUMENT,
     "the tolerance, 2, is not between 0 and 1"},
};

static void refusals(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        roberts_mesh mesh = {0};
        roberts_scene *scene = NULL;
        roberts_error error = {0};
        read_off(&mesh, refused[i].name, refused[i].off);
        roberts_status status = build(&mesh, true, refused[i].tolerance, &scene, &error);
        if (status != refused[i].status || strcmp(error.message, refused[i].message) != 0)
            fail_msg("%s: status %d, %s", refused[i].name, status, error.message);
        if (status == ROBERTS_FLAT)
            assert_string_equal(error.file, refused[i].name);
        assert_null(scene);
        roberts_mesh_free(&mesh);
    }
}

/* Keeps the warnings as "file: message\n" one after the other. */
static void note(void *context, const char *file, size_t line, const char *message)
{
    char *text = context;
    assert_int_equal(line, 0);
    snprintf(text + strlen(text), 1024 - strlen(text), "%s: %s\n", file, message);
}

#define TRIANGLE "OFF\n3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n"
#define SQUARE "OFF\n4 0 0\n0 0 9 1 0 9 0 1 9 1 1 9\n"
#define CUBE "OFF\n8 6 0\n" CUBE_POINTS CUBE_FACES

/* Flat sets of points are left out, even a whole input. They are refused if no input has anything else. */
static const struct {
    const char *name, *off[3];
    size_t solids; /* 0: refused */
    const char *said;
} flat_cases[] = {
    {"a triangle behind a cube",
     {"OFF\n11 7 0\n" CUBE_POINTS "0 0 9 1 0 9 0 1 9\n" CUBE_FACES "3 8 9 10\n"},
     1,
     "0: 1 flat component ignored, of 3 points from vertex 8 on: it has no convex hull\n"},
    {"square and triangle before the cube of the second input",
     {CUBE, "OFF\n15 8 0\n0 0 9 1 0 9 1 1 9 0 1 9 0 0 5 1 0 5 0 1 5\n" CUBE_POINTS
            "4 0 1 2 3\n3 4 5 6\n4 7 9 10 8\n4 7 8 12 11\n4 11 12 14 13\n4 9 13 14 10\n4 7 11 13 9\n4 8 10 14 12\n"},
     2,
     "1: 2 flat components ignored, the first of 4 points from vertex 0 on: they have no convex hulls\n"},
    {"a closed one without volume",
     {"OFF\n12 10 0\n" CUBE_POINTS "9 0 0 8 0 0 9 1 0 8 1 0\n" CUBE_FACES "3 8 9 10\n3 9 10 11\n3 8 10 11\n3 8 9 11\n"},
     1,
     "0: 1 flat component ignored, of 4 points from vertex 8 on: it has no convex hull\n"},
    {"all vertices in one place",
     {"OFF\n11 7 0\n" CUBE_POINTS "7 7 7 7 7 7 7 7 7\n" CUBE_FACES "3 8 9 10\n"}, /* welded, no face is left of it */
     1,
     ""},
    {"an input of its own",
     {CUBE, TRIANGLE},
     1,
     "1: 1 flat component ignored, of 3 points from vertex 0 on: it has no convex hull\n"},
    {"before one that is left out",
     {TRIANGLE, "OFF\n11 7 0\n" CUBE_POINTS "0 0 9 1 0 9 0 1 9\n" CUBE_FACES "3 8 9 10\n"},
     1,
     "0: 1 flat component ignored, of 3 points from vertex 0 on: it has no convex hull\n"
     "1: 1 flat component ignored, of 3 points from vertex 8 on: it has no convex hull\n"},
    {"points in a plane, as inputs of their own",
     {SQUARE, "OFF\n8 0 0\n" CUBE_POINTS, SQUARE},
     1,
     "0: 1 flat component ignored, of 4 points from vertex 0 on: it has no convex hull\n"
     "2: 1 flat component ignored, of 4 points from vertex 0 on: it has no convex hull\n"},
    {"points too few",
     {"OFF\n1 0 0\n9 9 9\n", CUBE, "OFF\n3 1 0\n0 0 9 1 0 9 0 1 9\n2 0 1\n"},
     1,
     "0: 1 point ignored: a convex hull takes four\n2: 3 points ignored: a convex hull takes four\n"},
    {"points too few, the others in a plane", {"OFF\n1 0 0\n9 9 9\n", SQUARE, TRIANGLE}, 0, ""},
    {"points too few in all inputs", {"OFF\n0 0 0\n", "OFF\n1 0 0\n9 9 9\n", "OFF\n1 0 0\n8 8 8\n"}, 0, ""},
    {"an input without anything", {"OFF\n0 0 0\n", CUBE}, 1, ""},
    {"points alone, which are not replaced", {"OFF\n8 0 0\n" CUBE_POINTS}, 1, ""},
    {"a cube without two sides, replaced",
     {"OFF\n8 4 0\n" CUBE_POINTS "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 1 3 7 5\n", CUBE},
     2,
     "0: 1 solid replaced by its convex hull: not closed\n"},
    {"of each kind one, in two inputs, and one that is sound",
     {CUBE,
      "OFF\n20 14 0\n0 0 9 1 0 9 0 1 9 1 1 9 0 0 10 1 0 10 0 1 10 1 1 10.1\n" L_POINTS CUBE_FACES
      "6 8 13 12 11 10 9\n6 14 15 16 17 18 19\n4 8 9 15 14\n4 9 10 16 15\n4 10 11 17 16\n4 11 12 18 17\n"
      "4 12 13 19 18\n4 13 8 14 19\n",
      "OFF\n14 6 0\n0 0 9 1 0 9 0 1 9 9 9 9 8 9 9 9 8 9\n" CUBE_POINTS
      "3 0 1 2\n3 3 4 5\n4 6 8 9 7\n4 10 11 13 12\n4 6 7 11 10\n4 7 9 13 11\n"},
     4,
     "1: 2 solids replaced by their convex hulls: 1 not planar, 1 not convex\n"
     "2: 1 solid replaced by its convex hull: not closed\n"
     "2: 2 flat components ignored, the first of 3 points from vertex 0 on: they have no convex hulls\n"},
};

static void flat_components_are_left_out(void **state)
{
    static const char *const names[] = {"0", "1", "2"};
    (void)state;
    for (size_t i = 0; i < sizeof flat_cases / sizeof flat_cases[0]; i++) {
        char said[1024] = "";
        roberts_mesh mesh = {0};
        roberts_scene *scene = NULL;
        roberts_error error = {0};
        const roberts_scene_options options = {.hull = true, .warnings = {note, said}};
        for (size_t k = 0; k < 3 && flat_cases[i].off[k]; k++)
            read_off(&mesh, names[k], flat_cases[i].off[k]);
        roberts_status status = roberts_scene_build(&mesh, &options, &scene, &error);
        print_message("%s\n", flat_cases[i].name);
        assert_int_equal(status, flat_cases[i].solids ? ROBERTS_OK : ROBERTS_FLAT);
        assert_string_equal(said, flat_cases[i].said);
        if (scene)
            assert_int_equal(roberts_scene_solid_count(scene), flat_cases[i].solids);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

/* Plates as thin as 3^-18 of their size, about 2.6e-9. Solids may be as thin as 1e-9. */
static void thin_plates(void **state)
{
    (void)state;
    for (int k = 0; k <= 18; k++) {
        double height = pow(3, -k);
        roberts_mesh mesh = {0};
        roberts_scene *scene = NULL;
        roberts_error error = {0};
        for (int i = 0; i < 8; i++) {
            roberts_vec3 p = {i & 1, i >> 1 & 1, height * (i >> 2)};
            mesh_vertex(&mesh, p);
        }
        if (build(&mesh, true, 0, &scene, &error) != ROBERTS_OK || roberts_scene_face_count(scene) != 6)
            fail_msg("height %g: %s", height, error.message);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

/* ---- threads --------------------------------------------------------------------------------------------------- */

enum { FANS = 700, FAN_POINTS = 12 };

/* Open fans of triangles. Of each `every` fans, the last one lies in a plane; 0: none does. */
static void make_fans(roberts_mesh *mesh, uint32_t every)
{
    rng r = {77};
    for (uint32_t fan = 0; fan < FANS; fan++) {
        uint32_t first = fan * FAN_POINTS;
        for (uint32_t i = 0; i < FAN_POINTS; i++) {
            roberts_vec3 p = {2.0 * (fan % 30) + rng_between(&r, 0, 1), 2.0 * (fan / 30) + rng_between(&r, 0, 1),
                              every && fan % every == every - 1 ? 0 : rng_between(&r, 0, 1)};
            mesh_vertex(mesh, p);
        }
        for (uint32_t i = 1; i + 1 < FAN_POINTS; i++)
            mesh_face(mesh, (uint32_t[]){first, first + i, first + i + 1}, 3);
    }
}

/* Any number of threads gives the same hulls in the same order, and the same warning or first refusal. */
static void threads_change_nothing(void **state)
{
    static const struct {
        uint32_t every, solids;
        const char *said;
    } cases[] = {
        {0, FANS, ": 700 solids replaced by their convex hulls: not closed\n"},
        {FANS, FANS - 1,
         ": 699 solids replaced by their convex hulls: not closed\n"
         ": 1 flat component ignored, of 12 points from vertex 8388 on: it has no convex hull\n"}, /* the last */
        {7, FANS - FANS / 7,
         ": 600 solids replaced by their convex hulls: not closed\n"
         ": 100 flat components ignored, the first of 12 points from vertex 72 on: they have no convex hulls\n"},
        {1, 0,
         "the convex hull of solid 0, of 12 points from vertex 0 on, is flat: they lie in one plane, or nearly so"},
    };
    static const uint32_t threads[] = {1, 2, 3, 7};
    (void)state;
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        roberts_mesh mesh = {0};
        roberts_scene *first = NULL;
        make_fans(&mesh, cases[k].every);
        for (size_t i = 0; i < sizeof threads / sizeof threads[0]; i++) {
            char said[1024] = "";
            const roberts_scene_options options = {.hull = true, .threads = threads[i], .warnings = {note, said}};
            roberts_scene *scene = NULL;
            roberts_error error = {0};
            roberts_status status = roberts_scene_build(&mesh, &options, &scene, &error);
            assert_int_equal(status, cases[k].solids ? ROBERTS_OK : ROBERTS_FLAT);
            assert_string_equal(status == ROBERTS_OK ? said : error.message, cases[k].said);
            if (status == ROBERTS_OK && !first) {
                assert_int_equal(scene->solid_count, cases[k].solids);
                first = scene;
                continue;
            }
            if (status == ROBERTS_OK)
                expect_same_scene(scene, first);
            roberts_scene_free(scene);
        }
        roberts_scene_free(first);
        roberts_mesh_free(&mesh);
    }
}

/* ---- drawings -------------------------------------------------------------------------------------------------- */

static void draw(const char *path, bool bare, bool hull, roberts_drawing *drawing)
{
    roberts_mesh mesh = {0};
    roberts_scene *scene = NULL;
    roberts_error error = {0};
    roberts_hide_options options = roberts_hide_options_default();
    roberts_camera camera = {.dir = {0.31, -0.47, 0.83}};
    options.keep_hidden = true;
    if (roberts_mesh_read_file(&mesh, path, NULL, &error) != ROBERTS_OK)
        fail_msg("%s: %s", path, error.message);
    if (bare)
        mesh.face_count = mesh.corner_count = mesh.source[0].first_face = 0;
    if (build(&mesh, hull, 0, &scene, &error) != ROBERTS_OK ||
        roberts_hide(scene, &camera, &options, drawing, &error) != ROBERTS_OK)
        fail_msg("%s: %s", path, error.message);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
}

static void assert_same_drawing(const char *path, bool bare)
{
    roberts_drawing as_is = {0}, hull = {0};
    draw(path, false, false, &as_is);
    draw(path, bare, true, &hull);
    assert_int_equal(as_is.count, hull.count);
    assert_true(as_is.count > 0);
    for (size_t i = 0; i < as_is.count; i++) {
        const roberts_segment *s = &as_is.segment[i], *t = &hull.segment[i];
        assert_true(s->solid == t->solid && s->v0 == t->v0 && s->v1 == t->v1 && s->by == t->by);
        assert_true(s->state == t->state && s->line == t->line);
        assert_true(s->t0 == t->t0 && s->t1 == t->t1);
        assert_memory_equal(&s->p0, &t->p0, sizeof s->p0);
        assert_memory_equal(&s->p1, &t->p1, sizeof s->p1);
    }
    roberts_drawing_free(&as_is);
    roberts_drawing_free(&hull);
}

/* Scenes of convex solids are drawn as without `--hull`; single solids also from their points alone. */
static void same_drawings(void **state)
{
    static const char *const many[] = {"models/table.off", "models/city.off", "models/stella-octangula.off"};
    static const char *const one[] = {"models/platonic/cube.off",
                                      "models/platonic/dodecahedron.off",
                                      "models/archimedean/truncated-icosahedron.off",
                                      "models/catalan/rhombic-triacontahedron.off",
                                      "models/prisms/prism-60.off",
                                      "models/sphere.off"};
    (void)state;
    for (size_t i = 0; i < sizeof many / sizeof many[0]; i++)
        assert_same_drawing(many[i], false);
    for (size_t i = 0; i < sizeof one / sizeof one[0]; i++)
        assert_same_drawing(one[i], true);
}

/* ---- the program ----------------------------------------------------------------------------------------------- */

static void program_draws_hulls(void **state)
{
    (void)state;
    put("in/cube.off", "OFF\n8 0 0\n" CUBE_POINTS);
    put("in/rbox", "3 rbox c\n8\n" CUBE_POINTS);
    put("in/flat.off", "OFF\n4 0 0\n0 0 0 1 0 0 0 1 0 1 1 0\n");
    assert_int_equal(run("in/cube.off -f csv"), 1);
    assert_said("in/cube.off: nothing to draw: there is no face with three different corners");
    assert_int_equal(run("--hull -v -f null in/cube.off"), 0);
    assert_said("in/cube.off: 1 body, 8 vertices, 6 faces");
    assert_int_equal(run("--hull -v -f null in/rbox"), 0);
    assert_said("in/rbox: 1 body, 8 vertices, 6 faces");
    assert_int_equal(run("--hull in/flat.off"), 1);
    assert_string_equal(
        last.err,
        "roberts: in/flat.off: the convex hull of solid 0, of 4 points from vertex 0 on, is flat: they lie in one "
        "plane, or nearly so\n");
    assert_string_equal(last.out, "");
    assert_int_equal(run("--hull -f null --view top --pick 0,0 in/cube.off"), 0);
    assert_said("body 0, a face of its hull, ");
    put("in/fan.off",
        "OFF\n11 8 0\n" CUBE_POINTS "0 0 9 1 0 9 0 1 8\n" CUBE_FACES "3 8 9 10\n3 0 8 9\n"); /* beside a cube */
    assert_int_equal(run("--hull -f null in/fan.off models/platonic/cube.off in/cube.off"), 0);
    assert_string_equal(last.err, "roberts: in/fan.off: warning: 1 solid replaced by its convex hull: not closed\n");
    assert_int_equal(run("--hull -q -f null in/fan.off"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("--hull -f null in/rbox"), 0); /* points alone: nothing is replaced */
    assert_string_equal(last.err, "");
    assert_int_equal(run("--hull --batch in -f null models/platonic/cube.off in/fan.off"), 0);
    assert_string_equal(last.err, "roberts: in/fan.off: warning: 1 solid replaced by its convex hull: not closed\n");
    assert_int_equal(run("--hull -v -f null in/fan.off models/platonic/cube.off in/cube.off"), 0);
    assert_said(": 4 bodies, ");
    assert_said("in/fan.off and 2 more: convex hulls in place of solids 1, 3\n");
    put("in/stray.off", "OFF\n11 7 0\n0 0 9 1 0 9 0 1 9\n" CUBE_POINTS
                        "3 0 1 2\n4 3 5 6 4\n4 3 4 8 7\n4 7 8 10 9\n4 5 9 10 6\n4 3 7 9 5\n4 4 6 10 8\n");
    assert_int_equal(run("--hull -f csv in/stray.off"), 0);
    assert_string_equal(last.err,
                        "roberts: in/stray.off: warning: 1 flat component ignored, of 3 points from vertex 0 on: "
                        "it has no convex hull\n");
    assert_non_null(strstr(last.out, "\n0,3,")); /* the cube is solid 0 now */
    assert_int_equal(run("--hull -q -f null in/stray.off"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("--hull -f null in/cube.off in/flat.off"), 0);
    assert_string_equal(last.err,
                        "roberts: in/flat.off: warning: 1 flat component ignored, of 4 points from vertex 0 on: "
                        "it has no convex hull\n");
    put("in/few.off", "OFF\n2 0 0\n0 0 0 1 0 0\n");
    assert_int_equal(run("-q --hull in/few.off in/few.off"), 1);
    assert_string_equal(last.err, "roberts: in/few.off: a convex hull takes four points, but there are 2\n");
    assert_int_equal(run("--hull in/few.off in/flat.off"), 1);
    assert_said("roberts: in/flat.off: the convex hull of solid 0, of 4 points from vertex 0 on, is flat");
    assert_int_equal(run("--hull -v -f null models/platonic/cube.off"), 0);
    assert_null(strstr(last.err, "in place of"));
    assert_int_equal(run("--hull in/cube.off"), 0);
    assert_non_null(strstr(last.out, "roberts --hull in/cube.off")); /* the description: it changes the drawing */
    assert_int_equal(run("--hull=1 in/cube.off"), 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_points),  cmocka_unit_test(noisy_points),
        cmocka_unit_test(six_digits),    cmocka_unit_test(solids),
        cmocka_unit_test(several_files), cmocka_unit_test(refusals),
        cmocka_unit_test(thin_plates),   cmocka_unit_test(flat_components_are_left_out),
        cmocka_unit_test(same_drawings), cmocka_unit_test(threads_change_nothing),
        IN_FOLDER(program_draws_hulls),
    };
    program_find();
    return cmocka_run_group_tests_name("hull", tests, NULL, NULL);
}
