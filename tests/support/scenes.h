/* scenes.h - scenes for tests: convex solids with small integer corners, mapped, placed side by side, changed and
 * drawn.
 *
 * A `model` is a mesh of solids that follow one another: solid s of the scene has the vertices first_vertex[s] ..
 * first_vertex[s + 1] - 1 and likewise its faces. All random numbers come from our own generator with a seed in the
 * test, so that failures are reproducible. */
#ifndef ROBERTS_TESTS_SCENES_H
#define ROBERTS_TESTS_SCENES_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "build_scene.h"
#include "rng.h"
#include "testing.h"

/* ---- linear maps ----------------------------------------------------------------------------------------------- */

/* Columns: the images of the axes. */
typedef struct mat3 {
    roberts_vec3 x, y, z;
} mat3;

static inline roberts_vec3 mat3_map(mat3 m, roberts_vec3 p)
{
    return (roberts_vec3){m.x.x * p.x + m.y.x * p.y + m.z.x * p.z, m.x.y * p.x + m.y.y * p.y + m.z.y * p.z,
                          m.x.z * p.x + m.y.z * p.y + m.z.z * p.z};
}

static inline mat3 mat3_scale(double x, double y, double z)
{
    return (mat3){{x, 0, 0}, {0, y, 0}, {0, 0, z}};
}

static inline mat3 mat3_times(mat3 a, mat3 b)
{
    return (mat3){mat3_map(a, b.x), mat3_map(a, b.y), mat3_map(a, b.z)};
}

static inline double mat3_determinant(mat3 m)
{
    return vec3_dot(m.x, vec3_cross(m.y, m.z));
}

/* Returns a rotation from a random unit quaternion. */
static inline mat3 mat3_turn(rng *r)
{
    double q[4], n = 0.0;
    while (n < 0.1 || n > 1.0) {
        n = 0.0;
        for (int i = 0; i < 4; i++) {
            q[i] = rng_between(r, -1, 1);
            n += q[i] * q[i];
        }
    }
    n = sqrt(n);
    double w = q[0] / n, x = q[1] / n, y = q[2] / n, z = q[3] / n;
    return (mat3){{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
                  {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
                  {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
}

/* ---- shapes ---------------------------------------------------------------------------------------------------- */

enum { SHAPE_CUBE, SHAPE_TETRAHEDRON, SHAPE_OCTAHEDRON, SHAPE_WEDGE, SHAPE_PYRAMID, SHAPE_HEXAGON, SHAPE_CUT, SHAPES };

typedef struct shape {
    size_t vertices;
    double vertex[12][3];
    unsigned char faces[64]; /* as of mesh_solid() */
} shape;

/* All within [-2, 2]. The cube's vertex number has bit 0 for x, bit 1 for y, bit 2 for z; SHAPE_CUT is the cube with
 * each face cut into two triangles. */
static const shape shapes[SHAPES] = {
    {8,
     {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}},
     {4, 0, 2, 3, 1, 4, 4, 5, 7, 6, 4, 0, 1, 5, 4, 4, 2, 6, 7, 3, 4, 0, 4, 6, 2, 4, 1, 3, 7, 5, 0}},
    {4, {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}}, {3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3, 0}},
    {6,
     {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
     {3, 0, 2, 4, 3, 2, 1, 4, 3, 1, 3, 4, 3, 3, 0, 4, 3, 2, 0, 5, 3, 1, 2, 5, 3, 3, 1, 5, 3, 0, 3, 5, 0}},
    {6,
     {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}},
     {3, 0, 2, 1, 3, 3, 4, 5, 4, 0, 1, 4, 3, 4, 1, 2, 5, 4, 4, 2, 0, 3, 5, 0}},
    {5, {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {0, 0, 1}}, {4, 0, 3, 2, 1, 3, 0, 1, 4, 3, 1,
                                                                          2, 4, 3, 2, 3, 4, 3, 3, 0, 4, 0}},
    {12,
     {{2, 0, -1},
      {1, 2, -1},
      {-1, 2, -1},
      {-2, 0, -1},
      {-1, -2, -1},
      {1, -2, -1}, //
      {2, 0, 1},
      {1, 2, 1},
      {-1, 2, 1},
      {-2, 0, 1},
      {-1, -2, 1},
      {1, -2, 1}},
     {6, 5, 4, 3, 2, 1, 0, 6, 6, 7,  8, 9, 10, 11, 4,  0,  1, 7, 6, 4, 1,  2, 8,
      7, 4, 2, 3, 9, 8, 4, 3, 4, 10, 9, 4, 4,  5,  11, 10, 4, 5, 0, 6, 11, 0}},
    {8,
     {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}},
     {3, 0, 2, 3, 3, 0, 3, 1, 3, 4, 5, 7, 3, 4, 7, 6, 3, 0, 1, 5, 3, 0, 5, 4, 3,
      2, 6, 7, 3, 2, 7, 3, 3, 0, 4, 6, 3, 0, 6, 2, 3, 1, 3, 7, 3, 1, 7, 5, 0}},
};

/* ---- models ---------------------------------------------------------------------------------------------------- */

enum { MODEL_SOLIDS = 1024, MODEL_CORNERS = 128 /* corners of a face */ };

typedef struct model {
    roberts_mesh mesh;
    uint32_t solids;
    uint32_t first_vertex[MODEL_SOLIDS + 1], first_face[MODEL_SOLIDS + 1];
} model;

static inline void model_free(model *m)
{
    roberts_mesh_free(&m->mesh);
    *m = (model){0};
}

static inline void model_close_solid(model *m)
{
    assert_true(m->solids < MODEL_SOLIDS);
    m->solids++;
    m->first_vertex[m->solids] = (uint32_t)m->mesh.vertex_count;
    m->first_face[m->solids] = (uint32_t)m->mesh.face_count;
}

static inline void model_vertex(model *m, roberts_vec3 p)
{
    mesh_vertex(&m->mesh, p);
}

static inline void model_face(model *m, const uint32_t *corner, size_t count)
{
    mesh_face(&m->mesh, corner, count);
}

/* Adds map * shape + offset. */
static inline void model_add(model *m, const shape *s, mat3 map, roberts_vec3 offset)
{
    roberts_vec3 point[12];
    for (size_t i = 0; i < s->vertices; i++) {
        roberts_vec3 p = {s->vertex[i][0], s->vertex[i][1], s->vertex[i][2]};
        point[i] = vec3_add(offset, mat3_map(map, p));
    }
    mesh_solid(&m->mesh, point, s->vertices, s->faces);
    model_close_solid(m);
}

/* Adds the box from `low` to `high`, with its vertices numbered like the cube's. It is exact if the sums of coordinates
 * are. */
static inline void model_box(model *m, roberts_vec3 low, roberts_vec3 high)
{
    roberts_vec3 size = vec3_sub(high, low);
    model_add(m, &shapes[SHAPE_CUBE], mat3_scale(size.x / 2, size.y / 2, size.z / 2),
              vec3_scale(0.5, vec3_add(low, high)));
}

static inline void model_tetrahedron(model *m, const roberts_vec3 point[4])
{
    mesh_tetrahedron(&m->mesh, point);
    model_close_solid(m);
}

/* Maps every vertex p to map * p + offset. */
static inline void model_map(model *m, mat3 map, roberts_vec3 offset)
{
    for (size_t i = 0; i < m->mesh.vertex_count; i++)
        m->mesh.vertex[i] = vec3_add(mat3_map(map, m->mesh.vertex[i]), offset);
}

/* Appends the same solids, with solid order[i] as the i-th, to an empty `to`. */
static inline void model_reorder(model *to, const model *from, const uint32_t *order)
{
    const roberts_mesh *mesh = &from->mesh;
    uint32_t corner[MODEL_CORNERS];
    for (uint32_t i = 0; i < from->solids; i++) {
        uint32_t s = order[i], first = (uint32_t)to->mesh.vertex_count;
        for (uint32_t v = from->first_vertex[s]; v < from->first_vertex[s + 1]; v++)
            model_vertex(to, mesh->vertex[v]);
        for (uint32_t f = from->first_face[s]; f < from->first_face[s + 1]; f++) {
            uint32_t count = mesh->face_start[f + 1] - mesh->face_start[f];
            for (uint32_t k = 0; k < count; k++)
                corner[k] = mesh->corner[mesh->face_start[f] + k] - from->first_vertex[s] + first;
            model_face(to, corner, count);
        }
        model_close_solid(to);
    }
}

static inline void model_copy(model *to, const model *from)
{
    uint32_t same[MODEL_SOLIDS];
    for (uint32_t i = 0; i < from->solids; i++)
        same[i] = i;
    *to = (model){0};
    model_reorder(to, from, same);
}

/* Reverses and rotates corner lists at random. */
static inline void model_wind(model *m, rng *r)
{
    for (size_t f = 0; f < m->mesh.face_count; f++) {
        uint32_t *corner = m->mesh.corner + m->mesh.face_start[f], old[MODEL_CORNERS];
        uint32_t count = m->mesh.face_start[f + 1] - m->mesh.face_start[f];
        uint32_t shift = (uint32_t)rng_int(r, 0, (int)count - 1), back = (uint32_t)rng_int(r, 0, 1);
        memcpy(old, corner, count * sizeof *old);
        for (uint32_t k = 0; k < count; k++)
            corner[k] = old[(shift + (back ? count - k : k)) % count];
    }
}

/* Makes n^3 cells of size 1 with a solid in each, turned at random, with a radius of up to `fill`. Neighbours
 * interpenetrate if it is above 1/2. */
static inline void model_lattice(model *m, int n, double fill, uint64_t seed)
{
    rng r = {seed};
    for (int i = 0; i < n * n * n; i++) {
        const shape *s = &shapes[rng_int(&r, 0, SHAPES - 1)];
        double radius = s == &shapes[SHAPE_HEXAGON] ? sqrt(5.0) + 0.2 : sqrt(3.0);
        double k = rng_between(&r, 0.5, 1.0) * fill / radius;
        mat3 flatten = mat3_scale(k, k * rng_between(&r, 0.2, 1), k * rng_between(&r, 0.5, 1));
        roberts_vec3 cell = {i % n, i / n % n, i / (n * n)};
        model_add(m, s, mat3_times(mat3_turn(&r), flatten), cell);
    }
}

/* Adds a prism (with its two faces of n corners) or, if `pointed`, a double pyramid over a regular polygon of n
 * corners, radius 1 and height 2, mapped. */
static inline void model_round(model *m, uint32_t n, bool pointed, mat3 map, roberts_vec3 offset)
{
    uint32_t first = (uint32_t)m->mesh.vertex_count, corner[2][MODEL_CORNERS];
    for (uint32_t i = 0; i < 2 * n; i++) {
        double angle = 2 * 3.14159265358979323846 * (i % n) / n;
        if (!pointed || i < n)
            model_vertex(m, vec3_add(offset, mat3_map(map, (roberts_vec3){cos(angle), sin(angle),
                                                                          pointed ? 0
                                                                          : i < n ? -1
                                                                                  : 1})));
        corner[i / n][i % n] = first + i;
    }
    for (int top = 0; pointed && top < 2; top++)
        model_vertex(m, vec3_add(offset, mat3_map(map, (roberts_vec3){0, 0, top ? 1 : -1})));
    for (uint32_t i = 0; i < n; i++) {
        uint32_t a = first + i, b = first + (i + 1) % n;
        if (!pointed)
            model_face(m, (uint32_t[]){a, b, b + n, a + n}, 4);
        for (uint32_t top = 0; pointed && top < 2; top++)
            model_face(m, (uint32_t[]){a, b, first + n + top}, 3);
    }
    for (int top = 0; !pointed && top < 2; top++)
        model_face(m, corner[top], n);
    model_close_solid(m);
}

/* Makes n^3 round solids of many faces, turned at random. */
static inline void model_balls(model *m, int n, double fill, uint64_t seed)
{
    rng r = {seed};
    for (int i = 0; i < n * n * n; i++) {
        double k = rng_between(&r, 0.4, 0.7) * fill;
        roberts_vec3 cell = {i % n, i / n % n, i / (n * n)};
        model_round(m, (uint32_t)rng_int(&r, 20, 90), i % 2, mat3_times(mat3_turn(&r), mat3_scale(k, k, k)), cell);
    }
}

/* Corner k of an L that fills three quarters of a square of 2 x 2, counter-clockwise; they repeat after six. */
static inline roberts_vec2 angle_corner(int k)
{
    static const roberts_vec2 profile[6] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    return profile[k % 6];
}

/* Adds a body that is not convex: between an L and another one, six corners each. */
static inline void model_angle(model *m, const roberts_vec3 point[12])
{
    static const uint32_t face[8][6] = {{0, 1, 2, 3, 4, 5}, {11, 10, 9, 8, 7, 6}, {0, 6, 7, 1},   {1, 7, 8, 2},
                                        {2, 8, 9, 3},       {3, 9, 10, 4},        {4, 10, 11, 5}, {5, 11, 6, 0}};
    const uint32_t first = (uint32_t)m->mesh.vertex_count;
    for (int k = 0; k < 12; k++)
        model_vertex(m, point[k]);
    for (int f = 0; f < 8; f++) {
        uint32_t corner[6];
        for (int k = 0; k < 6; k++)
            corner[k] = first + face[f][k];
        model_face(m, corner, f < 2 ? 6 : 4);
    }
    model_close_solid(m);
}

/* Rounds coordinates to `digits` after the point, as in files: faces are no longer quite planar. */
static inline void model_to_digits(model *m, int digits)
{
    double k = pow(10, digits);
    for (size_t i = 0; i < m->mesh.vertex_count; i++) {
        roberts_vec3 p = m->mesh.vertex[i];
        m->mesh.vertex[i] = (roberts_vec3){rint(p.x * k) / k, rint(p.y * k) / k, rint(p.z * k) / k};
    }
}

/* Moves every coordinate by up to `most`. */
static inline void model_shake(model *m, double most, uint64_t seed)
{
    rng r = {seed};
    for (size_t i = 0; i < m->mesh.vertex_count; i++) {
        roberts_vec3 *p = &m->mesh.vertex[i];
        p->x += rng_between(&r, -most, most);
        p->y += rng_between(&r, -most, most);
        p->z += rng_between(&r, -most, most);
    }
}

/* Makes `count` solids with integer corners in a small room, which gives many ties of every kind: corners, edges and
 * faces that coincide, overlap or cross. Every other solid is an axis-aligned box. */
static inline void model_crowd(model *m, int count, int room, uint64_t seed)
{
    rng r = {seed};
    for (int i = 0; i < count; i++) {
        roberts_vec3 at = {rng_int(&r, 0, room), rng_int(&r, 0, room), rng_int(&r, 0, room)};
        mat3 map = mat3_scale(0, 0, 0);
        if (i % 2) {
            roberts_vec3 size = {rng_int(&r, 1, 3), rng_int(&r, 1, 3), rng_int(&r, 1, 3)};
            model_box(m, at, vec3_add(at, size));
            continue;
        }
        while (mat3_determinant(map) == 0.0)
            map = (mat3){{rng_int(&r, -1, 1), rng_int(&r, -1, 1), rng_int(&r, -1, 1)},
                         {rng_int(&r, -1, 1), rng_int(&r, -1, 1), rng_int(&r, -1, 1)},
                         {rng_int(&r, -1, 1), rng_int(&r, -1, 1), rng_int(&r, -1, 1)}};
        model_add(m, &shapes[rng_int(&r, 0, SHAPES - 1)], map, at);
    }
}

/* Makes a wall of bricks 2 x 1 x 1 that touch exactly, each row shifted by half a brick. */
static inline void model_wall(model *m, int columns, int rows)
{
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++) {
            roberts_vec3 low = {2 * i + j % 2, 0, j};
            model_box(m, low, vec3_add(low, (roberts_vec3){2, 1, 1}));
        }
}

/* ---- drawing them ---------------------------------------------------------------------------------------------- */

static inline roberts_scene *model_build(const model *m)
{
    roberts_scene *scene = scene_of_mesh(&m->mesh, NULL);
    assert_int_equal(roberts_scene_solid_count(scene), m->solids);
    return scene;
}

/* Removes the rows of intersections, which come last: for tests of edges. */
static inline void drop_intersections(roberts_drawing *d)
{
    while (d->count > 0 && d->segment[d->count - 1].line == ROBERTS_INTERSECTION)
        d->count--;
}

/* Draws the model and keeps only the rows of edges. */
static inline roberts_drawing model_draw(const model *m, const roberts_camera *camera,
                                         const roberts_hide_options *options)
{
    roberts_scene *scene = model_build(m);
    roberts_drawing drawing = drawing_of(scene, camera, options);
    roberts_scene_free(scene);
    drop_intersections(&drawing);
    return drawing;
}

#endif
