/* order.c - see order.h. */
#include "order.h"

#include <stdlib.h>

#include "segments.h"
#include "shapes.h"

/* A permutation of 0 .. count - 1. */
static uint32_t *permutation(rng *d, size_t count)
{
    uint32_t *order = malloc((count + 1) * sizeof *order);
    for (size_t i = 0; i < count && order; i++) {
        size_t k = (size_t)(rng_next(d) % (i + 1));
        order[i] = order[k];
        order[k] = (uint32_t)i;
    }
    return order;
}

/* Adds a face of another mesh: its corners by their new numbers, from any of them on, in either direction. */
static bool add_face(const roberts_mesh *mesh, size_t f, const uint32_t *number, rng *d, roberts_mesh *other)
{
    const uint32_t *corner = mesh->corner + mesh->face_start[f];
    size_t count = mesh->face_start[f + 1] - mesh->face_start[f], first = (size_t)rng_int(d, 0, (int)count - 1);
    uint32_t *face = malloc(count * sizeof *face);
    bool back = rng_int(d, 0, 1), ok = face != NULL;
    for (size_t i = 0; i < count && ok; i++)
        face[i] = number[corner[(first + (back ? count - i : i)) % count]];
    ok = ok && roberts_mesh_add_face(other, face, count, NULL) == ROBERTS_OK;
    free(face);
    return ok;
}

bool order_shuffle(const roberts_mesh *mesh, uint64_t seed, roberts_mesh *other, uint32_t *number)
{
    rng d = {seed};
    uint32_t *vertex = permutation(&d, mesh->vertex_count), *face = permutation(&d, mesh->face_count);
    bool ok = vertex && face;
    *other = (roberts_mesh){0};
    for (size_t i = 0; i < mesh->vertex_count && ok; i++) {
        number[vertex[i]] = (uint32_t)i;
        ok = roberts_mesh_add_vertex(other, mesh->vertex[vertex[i]], NULL, NULL) == ROBERTS_OK;
    }
    for (size_t i = 0; i < mesh->face_count && ok; i++)
        ok = add_face(mesh, face[i], number, &d, other);
    free(vertex);
    free(face);
    return ok;
}

bool order_restore(roberts_drawing *drawing, const uint32_t *number, size_t vertex_count, const uint32_t *vertex_solid)
{
    uint32_t *old = malloc((vertex_count + 1) * sizeof *old);
    for (size_t v = 0; v < vertex_count && old; v++)
        old[number[v]] = (uint32_t)v;
    for (size_t i = 0; i < drawing->count && old; i++) {
        roberts_segment *s = drawing->segment + i, was = *s;
        s->v0 = old[was.v0];
        s->v1 = old[was.v1];
        s->solid = vertex_solid[s->v0];
        if (s->v0 > s->v1) {
            s->v0 = old[was.v1];
            s->v1 = old[was.v0];
            s->t0 = 1.0 - was.t1;
            s->t1 = 1.0 - was.t0;
            s->p0 = was.p1;
            s->p1 = was.p0;
        }
    }
    if (old)
        qsort(drawing->segment, drawing->count, sizeof *drawing->segment, compare_segments);
    free(old);
    return old != NULL;
}
