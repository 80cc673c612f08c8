/* mesh_workshop.h - builds the scenes for the families of bodies of any kind. */
#ifndef ROBERTS_TESTS_MESH_WORKSHOP_H
#define ROBERTS_TESTS_MESH_WORKSHOP_H

#include <math.h>

#include "mesh_families.h"
#include "shapes.h"

enum { FACE_CORNERS = 160 };

typedef struct workshop {
    mesh_scene *scene;
    rng d;
    bool no_memory; /* checked once, at the end */
} workshop;

static inline int any(workshop *w, int lo, int hi)
{
    return rng_int(&w->d, lo, hi);
}

static inline uint32_t vertex(workshop *w, double x, double y, double z)
{
    uint32_t number = 0;
    w->no_memory |= roberts_mesh_add_vertex(&w->scene->mesh, (roberts_vec3){x, y, z}, &number, NULL) != ROBERTS_OK;
    return number;
}

/* Adds a face, starting at any corner, with either winding. */
static inline void face(workshop *w, const uint32_t *corner, int count)
{
    uint32_t turned[FACE_CORNERS];
    int first = any(w, 0, count - 1), back = any(w, 0, 1);
    for (int i = 0; i < count; i++)
        turned[i] = corner[(first + (back ? count - i : i)) % count];
    w->no_memory |= roberts_mesh_add_face(&w->scene->mesh, turned, (size_t)count, NULL) != ROBERTS_OK;
}

static inline void triangle(workshop *w, uint32_t a, uint32_t b, uint32_t c)
{
    face(w, (uint32_t[]){a, b, c}, 3);
}

static inline double round_to(double x, double step)
{
    return floor(x / step + 0.5) * step;
}

static const double full_turn = 6.28318530717958647692;

/* A plane: an image of the plane of two coordinates, such that all its integer points have integer images. */
typedef struct sheet {
    int o[3], u[3], v[3];
} sheet;

static inline sheet any_sheet(workshop *w)
{
    sheet s;
    int axis = any(w, 0, 5);
    for (int k = 0; k < 3; k++) {
        s.o[k] = any(w, -4, 4);
        s.u[k] = axis < 3 ? k == axis : any(w, -1, 1);
        s.v[k] = axis < 3 ? k == (axis + 1) % 3 : any(w, -1, 1);
    }
    if (axis >= 3) { /* independent */
        s.u[0] = 1, s.u[1] = 0;
        s.v[0] = 0, s.v[1] = 1;
    }
    return s;
}

static inline uint32_t on_sheet(workshop *w, const sheet *s, int x, int y)
{
    return vertex(w, s->o[0] + x * s->u[0] + y * s->v[0], s->o[1] + x * s->u[1] + y * s->v[1],
                  s->o[2] + x * s->u[2] + y * s->v[2]);
}

typedef struct matrix {
    int row[3][3];
} matrix;

extern const matrix workshop_identity;

/* Returns 9 times a rotation, in integers. */
matrix workshop_rotation(workshop *w);

/* Adds a convex solid; each point p goes to at + m p. */
void workshop_put(workshop *w, const shape *s, const int at[3], const matrix *m);

typedef struct mesh_family {
    const char *name;
    void (*make)(workshop *w);
} mesh_family;

/* mesh_families_cross.c: bodies and faces that cross. */
extern const mesh_family mesh_cross_families[];
extern const size_t mesh_cross_family_count;

/* mesh_families_union.c: closed bodies, to be drawn as one. */
extern const mesh_family mesh_union_families[];
extern const size_t mesh_union_family_count;

#endif
