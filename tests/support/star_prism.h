/* star_prism.h - a body whose faces wind twice, and the same body with faces that do not cross. */
#ifndef ROBERTS_TESTS_STAR_PRISM_H
#define ROBERTS_TESTS_STAR_PRISM_H

#include "scenes.h"

/* The crossing of the lines from p to q and from r to s, in the plane z = 0. */
static inline roberts_vec3 cross_lines(roberts_vec3 p, roberts_vec3 q, roberts_vec3 r, roberts_vec3 s)
{
    const double t = ((r.x - p.x) * (s.y - r.y) - (r.y - p.y) * (s.x - r.x)) /
                     ((q.x - p.x) * (s.y - r.y) - (q.y - p.y) * (s.x - r.x));
    return (roberts_vec3){p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), 0};
}

static inline void add_prism_face(model *m, const uint32_t *corner, uint32_t count, bool turned)
{
    uint32_t other[10];
    for (uint32_t i = 0; i < count; i++)
        other[i] = corner[turned ? count - 1 - i : i];
    model_face(m, other, count);
}

/* A prism over a star of five points: with two pentagrams and five walls that cross, or with two decagons and ten walls
 * that do not. `turned`: bits of the faces to turn over. */
static inline void put_star(model *m, bool crossed, double z0, double z1, unsigned turned)
{
    static const roberts_vec3 tip[5] = {{0, 6, 0}, {-6, 1, 0}, {-3, -5, 0}, {3, -5, 0}, {6, 1, 0}};
    const uint32_t first = (uint32_t)m->mesh.vertex_count, count = crossed ? 5 : 10;
    uint32_t low[10], high[10];
    for (int side = 0; side < 2; side++)
        for (uint32_t i = 0; i < count; i++) {
            const uint32_t k = crossed ? 2 * i % 5 : i / 2;
            roberts_vec3 p = tip[k];
            if (!crossed && i % 2)
                p = cross_lines(tip[k], tip[(k + 2) % 5], tip[(k + 4) % 5], tip[(k + 1) % 5]);
            p.z = side ? z1 : z0;
            model_vertex(m, p);
        }
    for (uint32_t i = 0; i < count; i++) {
        low[i] = first + count - 1 - i;
        high[i] = first + count + i;
        const uint32_t next = (i + 1) % count;
        const uint32_t wall[4] = {first + i, first + next, first + count + next, first + count + i};
        add_prism_face(m, wall, 4, turned >> i & 1);
    }
    add_prism_face(m, low, count, turned >> 10 & 1);
    add_prism_face(m, high, count, turned >> 11 & 1);
    model_close_solid(m);
}

#endif
