/* voxels.c - see voxels.h. */
#include "voxels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS = 40, LOW = -10, MOST_BODIES = 64 }; /* cells of -10 .. 29 each way */

typedef struct cells {
    uint64_t in[CELLS][CELLS][CELLS]; /* a bit for each body; a face across x flips all cells beyond it */
} cells;

static uint32_t find(uint32_t *root, uint32_t v)
{
    while (root[v] != v)
        v = root[v];
    return v;
}

/* Numbers the bodies by the vertices that their faces join. */
static uint32_t *bodies_of(const roberts_mesh *mesh)
{
    uint32_t *root = malloc(2 * (mesh->vertex_count + 1) * sizeof *root), *number = root + mesh->vertex_count,
             count = 0;
    if (!root)
        return NULL;
    for (uint32_t v = 0; v < mesh->vertex_count; v++)
        root[v] = v;
    for (size_t f = 0; f < mesh->face_count; f++)
        for (uint32_t i = mesh->face_start[f] + 1; i < mesh->face_start[f + 1]; i++)
            root[find(root, mesh->corner[i])] = find(root, mesh->corner[i - 1]);
    for (uint32_t v = 0; v < mesh->vertex_count; v++)
        number[v] = ROBERTS_NONE;
    for (size_t f = 0; f < mesh->face_count; f++) {
        uint32_t r = find(root, mesh->corner[mesh->face_start[f]]);
        if (number[r] == ROBERTS_NONE)
            number[r] = count++;
    }
    for (uint32_t v = 0; v < mesh->vertex_count; v++)
        number[v] = number[find(root, v)];
    memcpy(root, number, mesh->vertex_count * sizeof *root);
    return root;
}

/* Flips the cells beyond each face across x. */
static bool fill(const roberts_mesh *mesh, const uint32_t *body, cells *c)
{
    for (size_t f = 0; f < mesh->face_count; f++) {
        double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
        for (uint32_t i = mesh->face_start[f]; i < mesh->face_start[f + 1]; i++) {
            roberts_vec3 p = mesh->vertex[mesh->corner[i]];
            const double x[3] = {p.x, p.y, p.z};
            for (int k = 0; k < 3; k++) {
                low[k] = fmin(low[k], x[k]);
                high[k] = fmax(high[k], x[k]);
            }
        }
        uint32_t number = body[mesh->corner[mesh->face_start[f]]];
        if (low[0] < high[0])
            continue;
        if (mesh->face_start[f + 1] - mesh->face_start[f] != 4 || number >= MOST_BODIES)
            return false;
        for (int k = 0; k < 3; k++)
            if (low[k] < LOW || high[k] > LOW + CELLS)
                return false;
        for (int x = (int)low[0] - LOW; x < CELLS; x++)
            for (int y = (int)low[1] - LOW; y < (int)high[1] - LOW; y++)
                for (int z = (int)low[2] - LOW; z < (int)high[2] - LOW; z++)
                    c->in[x][y][z] ^= (uint64_t)1 << number;
    }
    return true;
}

static bool full(const cells *c, const int p[3])
{
    for (int k = 0; k < 3; k++)
        if (p[k] < 0 || p[k] >= CELLS)
            return false;
    return c->in[p[0]][p[1]][p[2]] != 0;
}

/* On which side of an upright line the direction r is seen, from the picture. */
static int side_of(const oracle_view *view, roberts_vec3 at, const double d[3], const double r[3])
{
    double V[3] = {view->x, view->y, view->z};
    if (view->w) {
        V[0] -= at.x;
        V[1] -= at.y;
        V[2] -= at.z;
    }
    double det =
        V[0] * (d[1] * r[2] - d[2] * r[1]) - V[1] * (d[0] * r[2] - d[2] * r[0]) + V[2] * (d[0] * r[1] - d[1] * r[0]);
    return (det > 0) - (det < 0);
}

/* The edge from grid point p along an axis: its four cells lie at -1 and 0 along the other two axes. */
static voxel_edge edge_at(const cells *c, const oracle_view *view, const int p[3], int axis)
{
    int u = (axis + 1) % 3, v = (axis + 2) % 3, count = 0;
    bool in[2][2];
    double d[3] = {0}, side[2][3] = {{0}, {0}};
    voxel_edge e = {.a = {p[0] + LOW, p[1] + LOW, p[2] + LOW}, .class_ = UNION_OPEN};
    d[axis] = 1;
    e.b = (roberts_vec3){e.a.x + d[0], e.a.y + d[1], e.a.z + d[2]};
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++) {
            int q[3] = {p[0], p[1], p[2]};
            q[u] += i - 1;
            q[v] += k - 1;
            in[i][k] = full(c, q);
            count += in[i][k];
        }
    e.drawn = count == 1 || count == 3 || (count == 2 && in[0][0] == in[1][1]);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2 && count != 2; k++)
            if (in[i][k] == (count == 1)) { /* the odd one: its sides bound what is filled */
                side[0][u] = i ? 1 : -1;
                side[1][v] = k ? 1 : -1;
            }
    const roberts_vec3 middle = {(e.a.x + e.b.x) / 2, (e.a.y + e.b.y) / 2, (e.a.z + e.b.z) / 2};
    int s0 = side_of(view, middle, d, side[0]), s1 = side_of(view, middle, d, side[1]);
    if (count != 2)
        e.class_ = s0 * s1 >= 0 ? UNION_OUTLINE : UNION_CREASE;
    return e;
}

voxel_edge *voxel_edges(const roberts_mesh *mesh, const oracle_view *view, size_t *count)
{
    voxel_edge *out = NULL;
    cells *c = calloc(1, sizeof *c);
    uint32_t *body = bodies_of(mesh);
    size_t room = 0;
    *count = 0;
    if (!c || !body || !fill(mesh, body, c))
        goto done;
    for (int pass = 0; pass < 2; pass++) {
        for (int x = 0; x < CELLS; x++)
            for (int y = 0; y < CELLS; y++)
                for (int z = 0; z < CELLS; z++)
                    for (int axis = 0; axis < 3; axis++) {
                        const int p[3] = {x, y, z};
                        bool near = false;
                        for (int i = 0; i < 4; i++) {
                            int q[3] = {x, y, z};
                            q[(axis + 1) % 3] -= i & 1;
                            q[(axis + 2) % 3] -= i >> 1;
                            near = near || full(c, q);
                        }
                        if (near && pass)
                            out[(*count)++] = edge_at(c, view, p, axis);
                        room += near && !pass;
                    }
        if (!pass && !(out = malloc((room + 1) * sizeof *out)))
            break;
    }
done:
    free(c);
    free(body);
    return out;
}
