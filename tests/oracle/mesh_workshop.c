/* mesh_workshop.c - see mesh_workshop.h. */
#include "mesh_workshop.h"

#include <stdlib.h>
#include <string.h>

void workshop_put(workshop *w, const shape *s, const int at[3], const matrix *m)
{
    uint32_t *number = malloc((size_t)s->point_count * sizeof *number), corner[SHAPE_POINTS];
    if (!number) {
        w->no_memory = true;
        return;
    }
    for (int i = 0; i < s->point_count; i++) {
        double p[3];
        for (int k = 0; k < 3; k++)
            p[k] = at[k] + (double)(m->row[k][0] * s->point[i][0] + m->row[k][1] * s->point[i][1] +
                                    m->row[k][2] * s->point[i][2]);
        number[i] = vertex(w, p[0], p[1], p[2]);
    }
    for (int f = 0; f < s->face_count; f++) {
        int count = 0;
        for (int i = s->face_start[f]; i < s->face_start[f + 1] && count < FACE_CORNERS; i++)
            corner[count++] = number[s->corner[i]];
        face(w, corner, count);
    }
    free(number);
}

const matrix workshop_identity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/* The matrix of a rotation times the quaternion's norm: whole numbers. */
static matrix rotation(const int q[4])
{
    int a = q[0], b = q[1], c = q[2], d = q[3];
    return (matrix){{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
                     {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
                     {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}}};
}

matrix workshop_rotation(workshop *w)
{
    static const int quaternion[][4] = {{3, 0, 0, 0}, {2, 2, 1, 0}, {2, 1, 0, 2},  {1, 2, 2, 0},
                                        {2, 0, 2, 1}, {0, 2, 1, 2}, {2, -2, 0, 1}, {1, 0, -2, 2}};
    int q[4];
    memcpy(q, quaternion[any(w, 0, 7)], sizeof q);
    for (int k = 1; k < 4; k++)
        q[k] *= any(w, 0, 1) ? 1 : -1;
    return rotation(q);
}
