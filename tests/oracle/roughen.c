/* roughen.c - see roughen.h. */
#include "roughen.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lines.h"

typedef struct range {
    uint32_t first, end;
} range;

static range faces_of(const studio *st, uint32_t solid)
{
    uint32_t end = solid + 1 < st->solid_count ? st->first_face[solid + 1] : (uint32_t)st->scene->mesh.face_count;
    return (range){st->first_face[solid], end};
}

/* Solids are put one after the other: the vertices of each are consecutive. */
static range vertices_of(const studio *st, uint32_t solid)
{
    const roberts_mesh *mesh = &st->scene->mesh;
    range f = faces_of(st, solid), v = {UINT32_MAX, 0};
    for (uint32_t i = mesh->face_start[f.first]; i < mesh->face_start[f.end]; i++) {
        v.first = mesh->corner[i] < v.first ? mesh->corner[i] : v.first;
        v.end = mesh->corner[i] >= v.end ? mesh->corner[i] + 1 : v.end;
    }
    return v;
}

/* ---- changes --------------------------------------------------------------------------------------------------- */

void shake(studio *st, double most)
{
    roberts_mesh *mesh = &st->scene->mesh;
    int some = rng_int(&st->d, 1, 4), whole = rng_int(&st->d, 0, 1);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        bool moved = rng_int(&st->d, 1, 4) <= some;
        roberts_vec3 by = whole ? whole_point(st, -1, 1) : real_point(st), *p = mesh->vertex + i;
        if (moved)
            *p = (roberts_vec3){p->x + most * by.x, p->y + most * by.y, p->z + most * by.z};
    }
}

/* Gives the scene new faces; `cut` adds those of one solid to the mesh. */
static void replace_faces(studio *st, bool cut(studio *, const roberts_mesh *, range, roberts_mesh *))
{
    roberts_mesh *mesh = &st->scene->mesh, fresh = {0};
    uint32_t first_face[STUDIO_SOLIDS];
    bool ok = !st->no_memory;
    for (size_t i = 0; i < mesh->vertex_count && ok; i++)
        ok = roberts_mesh_add_vertex(&fresh, mesh->vertex[i], NULL, NULL) == ROBERTS_OK;
    for (uint32_t solid = 0; solid < st->solid_count && ok; solid++) {
        first_face[solid] = (uint32_t)fresh.face_count;
        ok = cut(st, mesh, faces_of(st, solid), &fresh);
    }
    if (ok)
        memcpy(st->first_face, first_face, st->solid_count * sizeof *first_face);
    st->no_memory = st->no_memory || !ok;
    roberts_mesh_free(mesh);
    *mesh = fresh;
}

static bool add_triangle(studio *st, roberts_mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t corner[2][3] = {{a, b, c}, {c, b, a}};
    return roberts_mesh_add_face(mesh, corner[rng_int(&st->d, 0, 1)], 3, NULL) == ROBERTS_OK;
}

/* A polygon's corners i .. k: some triangle on the chord from i to k, and what that leaves. */
static bool add_polygon(studio *st, roberts_mesh *mesh, const uint32_t *corner, int i, int k)
{
    if (k - i < 2)
        return true;
    int j = rng_int(&st->d, i + 1, k - 1);
    return add_triangle(st, mesh, corner[i], corner[j], corner[k]) && add_polygon(st, mesh, corner, i, j) &&
           add_polygon(st, mesh, corner, j, k);
}

static bool cut_anyhow(studio *st, const roberts_mesh *mesh, range faces, roberts_mesh *fresh)
{
    bool ok = true;
    for (uint32_t f = faces.first; f < faces.end && ok; f++)
        ok = add_polygon(st, fresh, mesh->corner + mesh->face_start[f], 0,
                         (int)(mesh->face_start[f + 1] - mesh->face_start[f]) - 1);
    return ok;
}

void triangulate(studio *st)
{
    replace_faces(st, cut_anyhow);
}

static bool cut_as_hull(studio *st, const roberts_mesh *mesh, range faces, roberts_mesh *fresh)
{
    range v = {UINT32_MAX, 0};
    for (uint32_t i = mesh->face_start[faces.first]; i < mesh->face_start[faces.end]; i++) {
        v.first = mesh->corner[i] < v.first ? mesh->corner[i] : v.first;
        v.end = mesh->corner[i] >= v.end ? mesh->corner[i] + 1 : v.end;
    }
    uint32_t count = v.end - v.first, (*face)[3] = malloc(2 * (size_t)count * sizeof *face);
    size_t faces_now = face ? oracle_hull(mesh->vertex + v.first, count, face) : 0;
    bool ok = faces_now > 0;
    for (size_t f = 0; f < faces_now && ok; f++)
        ok = add_triangle(st, fresh, v.first + face[f][0], v.first + face[f][1], v.first + face[f][2]);
    free(face);
    return ok;
}

void triangulate_convex(studio *st)
{
    replace_faces(st, cut_as_hull);
}

static double in_digits(double x, int digits)
{
    char text[40];
    snprintf(text, sizeof text, "%.*g", digits, x);
    return strtod(text, NULL);
}

void round_to_digits(studio *st, int digits)
{
    roberts_mesh *mesh = &st->scene->mesh;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        roberts_vec3 *p = mesh->vertex + i;
        *p = (roberts_vec3){in_digits(p->x, digits), in_digits(p->y, digits), in_digits(p->z, digits)};
    }
}

/* ---- how far the answer is determined -------------------------------------------------------------------------- */

typedef struct plane {
    double x, y, z, d; /* length of (x, y, z): 1 */
} plane;

static double at(plane p, roberts_vec3 v)
{
    return p.x * v.x + p.y * v.y + p.z * v.z + p.d;
}

/* Fitted to a face's corners by Newell's sum, relative to `o`; `o` lies on its negative side. */
static plane fit(const roberts_mesh *mesh, uint32_t f, roberts_vec3 o)
{
    plane p = {0, 0, 0, 0};
    uint32_t first = mesh->face_start[f], end = mesh->face_start[f + 1];
    roberts_vec3 mean = {0, 0, 0};
    for (uint32_t i = first; i < end; i++) {
        roberts_vec3 a = mesh->vertex[mesh->corner[i]];
        roberts_vec3 b = mesh->vertex[mesh->corner[i + 1 < end ? i + 1 : first]];
        p.x += (a.y - b.y) * (a.z - o.z + b.z - o.z);
        p.y += (a.z - b.z) * (a.x - o.x + b.x - o.x);
        p.z += (a.x - b.x) * (a.y - o.y + b.y - o.y);
        mean = (roberts_vec3){mean.x + a.x / (end - first), mean.y + a.y / (end - first), mean.z + a.z / (end - first)};
    }
    double l = hypot(hypot(p.x, p.y), p.z);
    p = (plane){p.x / l, p.y / l, p.z / l, 0};
    p.d = -at(p, mean);
    return at(p, o) > 0 ? (plane){-p.x, -p.y, -p.z, -p.d} : p;
}

/* k and R of roughen.h, and the solid's size. */
typedef struct rough {
    double k, radius, departure;
} rough;

static rough measure(const studio *st, uint32_t solid)
{
    const roberts_mesh *mesh = &st->scene->mesh;
    range faces = faces_of(st, solid), v = vertices_of(st, solid);
    roberts_vec3 middle = {0, 0, 0};
    rough r = {0};
    double n = v.end - v.first, largest = 0;
    for (uint32_t i = v.first; i < v.end; i++) {
        roberts_vec3 p = mesh->vertex[i];
        middle = (roberts_vec3){middle.x + p.x / n, middle.y + p.y / n, middle.z + p.z / n};
        largest = fmax(largest, fmax(fabs(p.x), fmax(fabs(p.y), fabs(p.z))));
    }
    for (uint32_t i = v.first; i < v.end; i++)
        r.radius = fmax(r.radius, line_length(mesh->vertex[i], middle));
    for (uint32_t f = faces.first; f < faces.end; f++) {
        plane p = fit(mesh, f, middle);
        double outside = 0, departure = 0;
        for (uint32_t i = v.first; i < v.end; i++)
            outside = fmax(outside, at(p, mesh->vertex[i]));
        for (uint32_t i = mesh->face_start[f]; i < mesh->face_start[f + 1]; i++)
            departure = fmax(departure, fabs(at(p, mesh->vertex[mesh->corner[i]])));
        r.k = fmax(r.k, (outside + departure) / -at(p, middle));
        r.departure = fmax(r.departure, fmax(outside, departure));
    }
    r.departure -= fmin(r.departure, 8 * DBL_EPSILON * largest); /* of rounding here */
    return r;
}

double roughness(const studio *st)
{
    double most = 0;
    for (uint32_t solid = 0; solid < st->solid_count; solid++) {
        rough r = measure(st, solid);
        most = fmax(most, r.departure / r.radius);
    }
    return most;
}

void leave_open(studio *st)
{
    double move = 0;
    if (st->no_memory)
        return;
    for (uint32_t solid = 0; solid < st->solid_count; solid++) {
        rough r = measure(st, solid);
        move = fmax(move, r.departure > 0 ? r.k * r.radius : 0);
        st->scene->rough = st->scene->rough || r.departure > 0;
    }
    near_touching(st);
    st->scene->slack +=
        move / 2; /* the oracle moves walls by twice the slack, the edge being open as well: here it is not */
}

/* ---- views ----------------------------------------------------------------------------------------------------- */

double small_angle(studio *st)
{
    int digits = rng_int(&st->d, 8, 13);
    return digits < 9 ? 0 : pow(10, -digits);
}

void look_in_plane(studio *st, double off)
{
    const roberts_mesh *mesh = &st->scene->mesh;
    roberts_vec3 aside = real_point(st), lo = mesh->vertex[0], hi = lo;
    uint32_t f = (uint32_t)rng_int(&st->d, 0, (int)mesh->face_count - 1), first = mesh->face_start[f];
    uint32_t count = mesh->face_start[f + 1] - first;
    const uint32_t *corner = mesh->corner + first;
    roberts_vec3 o = mesh->vertex[corner[0]], p = mesh->vertex[corner[1]], q = mesh->vertex[corner[count - 1]];
    int u = rng_int(&st->d, -3, 3), w = rng_int(&st->d, u ? -3 : 1, 3);
    roberts_vec3 dir = {u * (p.x - o.x) + w * (q.x - o.x), u * (p.y - o.y) + w * (q.y - o.y),
                        u * (p.z - o.z) + w * (q.z - o.z)};
    double length = hypot(hypot(dir.x, dir.y), dir.z) * off, times = 1;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        roberts_vec3 v = mesh->vertex[i];
        lo = (roberts_vec3){fmin(lo.x, v.x), fmin(lo.y, v.y), fmin(lo.z, v.z)};
        hi = (roberts_vec3){fmax(hi.x, v.x), fmax(hi.y, v.y), fmax(hi.z, v.z)};
    }
    while (times * hypot(hypot(dir.x, dir.y), dir.z) < 2 * line_length(lo, hi))
        times *= 2;
    dir = (roberts_vec3){dir.x + length * aside.x, dir.y + length * aside.y, dir.z + length * aside.z};
    if (!st->eye)
        look(st, dir.x, dir.y, dir.z);
    else
        st->scene->view =
            (oracle_view){.x = o.x + times * dir.x, .y = o.y + times * dir.y, .z = o.z + times * dir.z, .w = 1};
}
