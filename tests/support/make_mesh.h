/* make_mesh.h - meshes from points, files and texts. The test fails if anything is refused. */
#ifndef ROBERTS_TESTS_MAKE_MESH_H
#define ROBERTS_TESTS_MAKE_MESH_H

#include <string.h>

#include "base/vec.h"
#include "roberts.h"
#include "testing.h"

/* ---- vertices, faces and solids, which are added ---------------------------------------------------------------- */

/* Returns the number of the vertex. */
static inline uint32_t mesh_vertex(roberts_mesh *mesh, roberts_vec3 p)
{
    uint32_t number;
    assert_int_equal(roberts_mesh_add_vertex(mesh, p, &number, NULL), ROBERTS_OK);
    return number;
}

static inline void mesh_face(roberts_mesh *mesh, const uint32_t *corner, size_t count)
{
    assert_int_equal(roberts_mesh_add_face(mesh, corner, count, NULL), ROBERTS_OK);
}

static inline void mesh_triangle(roberts_mesh *mesh, roberts_vec3 a, roberts_vec3 b, roberts_vec3 c)
{
    uint32_t first = mesh_vertex(mesh, a);
    mesh_vertex(mesh, b);
    mesh_vertex(mesh, c);
    mesh_face(mesh, (uint32_t[]){first, first + 1, first + 2}, 3);
}

/* Adds `count` points as vertices, and faces over them. A face is its number of corners, then the indices of its
 * points; 0 ends the list of faces. */
static inline void mesh_solid(roberts_mesh *mesh, const roberts_vec3 *point, size_t count, const unsigned char *faces)
{
    uint32_t first = (uint32_t)mesh->vertex_count, corner[12];
    for (size_t i = 0; i < count; i++)
        mesh_vertex(mesh, point[i]);
    for (const unsigned char *f = faces; *f; f += 1 + *f) {
        assert_in_range(*f, 1, sizeof corner / sizeof *corner);
        for (int k = 0; k < *f; k++)
            corner[k] = first + f[1 + k];
        mesh_face(mesh, corner, *f);
    }
}

static inline void mesh_tetrahedron(roberts_mesh *mesh, const roberts_vec3 point[4])
{
    static const unsigned char faces[] = {3, 0, 1, 2, 3, 0, 1, 3, 3, 0, 2, 3, 3, 1, 2, 3, 0};
    mesh_solid(mesh, point, 4, faces);
}

/* The faces of a cube whose vertex numbers have bit 0 for x, bit 1 for y and bit 2 for z. In order: z least, z
 * greatest, y least, y greatest, x least, x greatest. */
static const unsigned char mesh_cube_faces[] = {4, 0, 2, 3, 1, 4, 4, 5, 7, 6, 4, 0, 1, 5, 4, 4,
                                                2, 6, 7, 3, 4, 0, 4, 6, 2, 4, 1, 3, 7, 5, 0};

/* Adds the parallelepiped with a corner o and sides u, v, w, in the places of x, y, z. */
static inline void mesh_block(roberts_mesh *mesh, roberts_vec3 o, roberts_vec3 u, roberts_vec3 v, roberts_vec3 w)
{
    roberts_vec3 point[8];
    for (int i = 0; i < 8; i++) {
        point[i] = i & 1 ? vec3_add(o, u) : o;
        point[i] = i & 2 ? vec3_add(point[i], v) : point[i];
        point[i] = i & 4 ? vec3_add(point[i], w) : point[i];
    }
    mesh_solid(mesh, point, 8, mesh_cube_faces);
}

/* Adds the box from `low` to `high`. */
static inline void mesh_box(roberts_mesh *mesh, roberts_vec3 low, roberts_vec3 high)
{
    roberts_vec3 point[8];
    for (int i = 0; i < 8; i++)
        point[i] = (roberts_vec3){i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
    mesh_solid(mesh, point, 8, mesh_cube_faces);
}

/* ---- meshes that are read --------------------------------------------------------------------------------------- */

static inline roberts_mesh mesh_of_file(const char *path)
{
    roberts_mesh mesh = {0};
    roberts_error error;
    if (roberts_mesh_read_file(&mesh, path, NULL, &error) != ROBERTS_OK)
        fail_msg("%s:%zu: %s", path, error.line, error.message);
    return mesh;
}

static inline roberts_mesh mesh_of_text(const char *text)
{
    roberts_mesh mesh = {0};
    roberts_error error;
    if (roberts_mesh_read_memory(&mesh, "text", text, strlen(text), NULL, &error) != ROBERTS_OK)
        fail_msg("line %zu: %s", error.line, error.message);
    return mesh;
}

#endif
