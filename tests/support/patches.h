/* patches.h - meshes for tests: vertices and triangles one by one, and patches of a raster. */
#ifndef ROBERTS_TESTS_PATCHES_H
#define ROBERTS_TESTS_PATCHES_H

#include "scenes.h"

typedef struct sheet {
    roberts_mesh mesh;
    uint32_t vertices;
} sheet;

static inline uint32_t add_vertex(sheet *s, double x, double y, double z)
{
    uint32_t index;
    assert_int_equal(roberts_mesh_add_vertex(&s->mesh, (roberts_vec3){x, y, z}, &index, NULL), ROBERTS_OK);
    s->vertices = index + 1;
    return index;
}

static inline void add_face(sheet *s, uint32_t a, uint32_t b, uint32_t c)
{
    uint32_t corner[3] = {a, b, c};
    mesh_face(&s->mesh, corner, 3);
}

static inline void add_triangle(sheet *s, roberts_vec3 p, roberts_vec3 q, roberts_vec3 r)
{
    uint32_t a = add_vertex(s, p.x, p.y, p.z), b = add_vertex(s, q.x, q.y, q.z);
    add_face(s, a, b, add_vertex(s, r.x, r.y, r.z));
}

/* How a patch is made. */
typedef struct patch {
    double x, y, z; /* of its first corner */
    double step;    /* of the raster */
    double rough;   /* heights differ by as much */
    double turned;  /* which part of the triangles runs the other way round */
    double missing; /* which part of them is left out */
    int nx, ny;     /* squares */
    int hole[4];    /* squares x0..x1-1, y0..y1-1 that are left out */
} patch;

/* Squares in two triangles each. The vertex of column i and row j is first + i * (ny + 1) + j. */
static inline uint32_t add_patch(sheet *s, const patch *p, rng *r)
{
    uint32_t first = s->vertices, down = (uint32_t)p->ny + 1;
    for (int i = 0; i <= p->nx; i++)
        for (int j = 0; j <= p->ny; j++)
            add_vertex(s, p->x + p->step * i, p->y + p->step * j, p->z + p->rough * rng_int(r, -8, 8) / 8);
    for (int i = 0; i < p->nx; i++)
        for (int j = 0; j < p->ny; j++) {
            uint32_t v = first + (uint32_t)i * down + (uint32_t)j;
            const uint32_t corner[2][3] = {{v, v + down, v + down + 1}, {v, v + down + 1, v + 1}};
            if (p->hole[0] <= i && i < p->hole[1] && p->hole[2] <= j && j < p->hole[3])
                continue;
            for (int k = 0; k < 2; k++) {
                if (rng_between(r, 0, 1) < p->missing)
                    continue;
                bool turned = rng_between(r, 0, 1) < p->turned;
                add_face(s, corner[k][0], corner[k][turned ? 2 : 1], corner[k][turned ? 1 : 2]);
            }
        }
    return first;
}

/* Adds one sheet that goes to and fro `pleats` times in so many steps, often through itself, with a few holes. */
static inline void add_pleats(sheet *s, uint32_t pleats, uint32_t steps, rng *r)
{
    const double rough = rng_int(r, 0, 3) * 0.5;
    const uint32_t first = s->vertices, row = steps + 1;
    for (uint32_t i = 0; i <= pleats * steps; i++) {
        const uint32_t on = i % (2 * steps), x = on <= steps ? on : 2 * steps - on;
        for (uint32_t j = 0; j <= steps; j++)
            add_vertex(s, x + rng_between(r, -0.2, 0.2), j + rng_between(r, -0.2, 0.2),
                       -0.2 * i + rng_between(r, -rough, rough));
    }
    for (uint32_t v = first; v < first + pleats * steps * row; v++)
        if ((v - first) % row < steps && rng_int(r, 0, 60) > 0) {
            add_face(s, v, v + row, v + row + 1);
            add_face(s, v, v + row + 1, v + 1);
        }
}

#endif
