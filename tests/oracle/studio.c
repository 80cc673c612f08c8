/* studio.c - see studio.h. */
#include "studio.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* ---- points ---------------------------------------------------------------------------------------------------- */

roberts_vec3 whole_point(studio *st, int lo, int hi)
{
    roberts_vec3 p;
    p.x = rng_int(&st->d, lo, hi);
    p.y = rng_int(&st->d, lo, hi);
    p.z = rng_int(&st->d, lo, hi);
    return p;
}

roberts_vec3 real_point(studio *st)
{
    roberts_vec3 p;
    p.x = rng_real(&st->d);
    p.y = rng_real(&st->d);
    p.z = rng_real(&st->d);
    return p;
}

/* ---- scenes ---------------------------------------------------------------------------------------------------- */

/* Adds the shape, each of its points sent to at + m p; rows of m are the images' coordinates. */
void put_mapped(studio *st, const shape *s, roberts_vec3 at, double m[3][3])
{
    roberts_mesh *mesh = &st->scene->mesh;
    uint32_t base = (uint32_t)mesh->vertex_count;
    if (st->solid_count < STUDIO_SOLIDS)
        st->first_face[st->solid_count++] = (uint32_t)mesh->face_count;
    for (int i = 0; i < s->point_count && !st->no_memory; i++) {
        double p[3] = {(double)s->point[i][0], (double)s->point[i][1], (double)s->point[i][2]};
        roberts_vec3 v = {at.x + (m[0][0] * p[0] + m[0][1] * p[1] + m[0][2] * p[2]),
                          at.y + (m[1][0] * p[0] + m[1][1] * p[1] + m[1][2] * p[2]),
                          at.z + (m[2][0] * p[0] + m[2][1] * p[1] + m[2][2] * p[2])};
        st->no_memory = roberts_mesh_add_vertex(mesh, v, NULL, NULL) != ROBERTS_OK;
    }
    for (int f = 0; f < s->face_count && !st->no_memory; f++) {
        uint32_t face[SHAPE_CORNERS];
        int count = s->face_start[f + 1] - s->face_start[f], first = rng_int(&st->d, 0, count - 1);
        bool back = rng_int(&st->d, 0, 1);
        for (int i = 0; i < count; i++)
            face[i] = base + (uint32_t)s->corner[s->face_start[f] + (first + (back ? count - i : i)) % count];
        st->no_memory = roberts_mesh_add_face(mesh, face, (size_t)count, NULL) != ROBERTS_OK;
    }
}

void put_scaled(studio *st, const shape *s, roberts_vec3 at, double x, double y, double z)
{
    double m[3][3] = {{x, 0, 0}, {0, y, 0}, {0, 0, z}};
    put_mapped(st, s, at, m);
}

void put(studio *st, const shape *s, double x, double y, double z)
{
    put_scaled(st, s, (roberts_vec3){x, y, z}, 1, 1, 1);
}

void put_at(studio *st, const shape *s, roberts_vec3 at)
{
    put(st, s, at.x, at.y, at.z);
}

/* A corner takes its coordinates as they are, without rounding. */
void put_box(studio *st, roberts_vec3 low, roberts_vec3 high)
{
    shape unit = shape_box(1, 1, 1);
    size_t base = st->scene->mesh.vertex_count;
    put(st, &unit, 0, 0, 0);
    for (size_t i = 0; i < 8 && !st->no_memory; i++)
        st->scene->mesh.vertex[base + i] = (roberts_vec3){
            unit.point[i][0] ? high.x : low.x, unit.point[i][1] ? high.y : low.y, unit.point[i][2] ? high.z : low.z};
}

void put_turned(studio *st, const shape *s, roberts_vec3 at, double size)
{
    double q[4], m[3][3], l;
    do {
        l = 0;
        for (int i = 0; i < 4; i++) {
            q[i] = rng_real(&st->d);
            l += q[i] * q[i];
        }
    } while (l > 1 || l < 0.01);
    for (int i = 0; i < 3; i++) /* the rotation of a quaternion */
        for (int j = 0; j < 3; j++) {
            int k = 3 - i - j, sign = (j + 3 - i) % 3 == 1 ? -1 : 1;
            double diagonal =
                l - 2 * (q[1 + (i + 1) % 3] * q[1 + (i + 1) % 3] + q[1 + (i + 2) % 3] * q[1 + (i + 2) % 3]);
            m[i][j] = i == j ? size * diagonal / l : size * 2 * (q[1 + i] * q[1 + j] + sign * q[0] * q[1 + k]) / l;
        }
    put_mapped(st, s, at, m);
}

/* ---- views ----------------------------------------------------------------------------------------------------- */

void look(studio *st, double x, double y, double z)
{
    st->scene->view = (oracle_view){.x = x, .y = y, .z = z};
}

void look_small(studio *st, int size)
{
    roberts_vec3 dir;
    do
        dir = whole_point(st, -size, size);
    while (dir.x == 0 && dir.y == 0 && dir.z == 0);
    look(st, dir.x, dir.y, dir.z);
}

void look_axis(studio *st)
{
    double v[3] = {0, 0, 0};
    int axis = rng_int(&st->d, 0, 2);
    v[axis] = rng_int(&st->d, 0, 1) ? 1 : -1;
    look(st, v[0], v[1], v[2]);
}

void look_corner(studio *st)
{
    roberts_vec3 side = whole_point(st, 0, 1);
    look(st, side.x > 0 ? 1 : -1, side.y > 0 ? 1 : -1, side.z > 0 ? 1 : -1);
}

void look_random(studio *st)
{
    roberts_vec3 dir = real_point(st);
    look(st, dir.x, dir.y, dir.z);
}

void look_down(studio *st, double aside, double z)
{
    roberts_vec3 dir = real_point(st);
    look(st, aside * dir.x, aside * dir.y, z);
}

void look_any(studio *st)
{
    switch (rng_int(&st->d, 0, 5)) {
    case 0:
        look_axis(st);
        break;
    case 1:
        look_corner(st);
        break;
    case 2:
        look(st, 1, 2, 1.5);
        break;
    case 3:
        look_small(st, 2);
        break;
    case 4:
        look_small(st, 1000);
        break;
    default:
        look_random(st);
    }
}

/* ---- what is not judged ---------------------------------------------------------------------------------------- */

/* What lies nearer than 1e-11 of the scene's diameter counts as touching, by the specification. Where a family makes
 * clearances of any size, those up to twice as large are not judged. Call it last. */
#define TOUCHING 2e-11

static double diameter(const roberts_mesh *mesh, roberts_vec3 *lo, roberts_vec3 *hi)
{
    *lo = *hi = mesh->vertex[0];
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        roberts_vec3 p = mesh->vertex[i];
        *lo = (roberts_vec3){fmin(lo->x, p.x), fmin(lo->y, p.y), fmin(lo->z, p.z)};
        *hi = (roberts_vec3){fmax(hi->x, p.x), fmax(hi->y, p.y), fmax(hi->z, p.z)};
    }
    return hypot(hypot(hi->x - lo->x, hi->y - lo->y), hi->z - lo->z);
}

void near_touching(studio *st)
{
    roberts_vec3 lo, hi;
    if (!st->no_memory)
        st->scene->slack = TOUCHING * diameter(&st->scene->mesh, &lo, &hi);
}

/* ---- eyes ------------------------------------------------------------------------------------------------------ */

/* Moves the viewer from infinity to an eye with whole coordinates (times the scene's unit), well before the scene. */
void look_from_eye(studio *st)
{
    oracle_view *view = &st->scene->view;
    roberts_vec3 lo, hi;
    double away = diameter(&st->scene->mesh, &lo, &hi) * rng_int(&st->d, 3, 9) / 2;
    away /= hypot(hypot(view->x, view->y), view->z);
    view->x = st->unit * ceil(((lo.x + hi.x) / 2 + away * view->x) / st->unit);
    view->y = st->unit * ceil(((lo.y + hi.y) / 2 + away * view->y) / st->unit);
    view->z = st->unit * ceil(((lo.z + hi.z) / 2 + away * view->z) / st->unit);
    view->w = 1;
}

/* ---- eyes amid the scene, and near planes ---------------------------------------------------------------------- */

static roberts_vec3 mean_of(const roberts_mesh *mesh, uint32_t first_corner, uint32_t end)
{
    roberts_vec3 sum = {0, 0, 0};
    for (uint32_t k = first_corner; k < end; k++) {
        roberts_vec3 p = mesh->vertex[mesh->corner[k]];
        sum = (roberts_vec3){sum.x + p.x, sum.y + p.y, sum.z + p.z};
    }
    double n = end - first_corner;
    return (roberts_vec3){sum.x / n, sum.y / n, sum.z / n};
}

static uint32_t face_end(const studio *st, uint32_t solid)
{
    return solid + 1 < st->solid_count ? st->first_face[solid + 1] : (uint32_t)st->scene->mesh.face_count;
}

static roberts_vec3 middle_of(const studio *st, uint32_t solid)
{
    const roberts_mesh *mesh = &st->scene->mesh;
    return mean_of(mesh, mesh->face_start[st->first_face[solid]], mesh->face_start[face_end(st, solid)]);
}

/* Six times the volume of abcp, with the sign of the side of abc on which p lies. */
static double volume(const roberts_vec3 *vertex, const uint32_t *corner, roberts_vec3 p)
{
    roberts_vec3 a = vertex[corner[0]], b = vertex[corner[1]], c = vertex[corner[2]];
    roberts_vec3 u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - a.x, c.y - a.y, c.z - a.z};
    roberts_vec3 w = {p.x - a.x, p.y - a.y, p.z - a.z};
    return w.x * (u.y * v.z - u.z * v.y) + w.y * (u.z * v.x - u.x * v.z) + w.z * (u.x * v.y - u.y * v.x);
}

/* Has each solid a face with the eye clearly in front of it? `least` is a part of the distance of the solid's middle;
 * with 0, an eye on the solid's surface is outside too. */
static bool is_outside(const studio *st, roberts_vec3 eye, double least)
{
    const roberts_mesh *mesh = &st->scene->mesh;
    for (uint32_t solid = 0; solid < st->solid_count; solid++) {
        roberts_vec3 middle = middle_of(st, solid);
        bool outside = false;
        for (uint32_t f = st->first_face[solid]; f < face_end(st, solid) && !outside; f++) {
            const uint32_t *corner = mesh->corner + mesh->face_start[f];
            outside = volume(mesh->vertex, corner, eye) / volume(mesh->vertex, corner, middle) <= -least;
        }
        if (!outside)
            return false;
    }
    return true;
}

/* A point beside a solid: a face's middle or one of its corners, moved away from the solid's middle by half of their
 * distance or by as little as a thousandth. */
static roberts_vec3 beside_solid(studio *st)
{
    const roberts_mesh *mesh = &st->scene->mesh;
    uint32_t solid = (uint32_t)rng_int(&st->d, 0, (int)st->solid_count - 1);
    uint32_t face = (uint32_t)rng_int(&st->d, (int)st->first_face[solid], (int)face_end(st, solid) - 1);
    uint32_t first = mesh->face_start[face], end = rng_int(&st->d, 0, 2) ? mesh->face_start[face + 1] : first + 1;
    roberts_vec3 m = middle_of(st, solid), p = mean_of(mesh, first, end);
    double part = ldexp(1, -rng_int(&st->d, 1, 10));
    return (roberts_vec3){p.x + part * (p.x - m.x), p.y + part * (p.y - m.y), p.z + part * (p.z - m.z)};
}

/* A point of the scene's box. */
static roberts_vec3 amid_scene(studio *st, roberts_vec3 lo, roberts_vec3 hi)
{
    roberts_vec3 p = real_point(st);
    return (roberts_vec3){lo.x + (hi.x - lo.x) * (p.x + 1) / 2, lo.y + (hi.y - lo.y) * (p.y + 1) / 2,
                          lo.z + (hi.z - lo.z) * (p.z + 1) / 2};
}

static bool any_beyond(const roberts_mesh *mesh, roberts_vec3 near, roberts_vec3 ahead)
{
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        roberts_vec3 p = mesh->vertex[i];
        if ((p.x - near.x) * ahead.x + (p.y - near.y) * ahead.y + (p.z - near.z) * ahead.z > 0)
            return true;
    }
    return false;
}

static roberts_vec3 on_grid(roberts_vec3 p, double grain)
{
    return (roberts_vec3){grain * floor(p.x / grain), grain * floor(p.y / grain), grain * floor(p.z / grain)};
}

/* With the near plane through eye + ahead, looking at eye + far ahead. */
static void set_eye(studio *st, roberts_vec3 eye, roberts_vec3 ahead, double far)
{
    st->scene->view = (oracle_view){.x = eye.x,
                                    .y = eye.y,
                                    .z = eye.z,
                                    .w = 1,
                                    .cut = true,
                                    .near = {eye.x + ahead.x, eye.y + ahead.y, eye.z + ahead.z}};
    st->scene->look_at = (roberts_vec3){eye.x + far * ahead.x, eye.y + far * ahead.y, eye.z + far * ahead.z};
}

/* Eye and near plane have coordinates that are multiples of `grain`, a power of two: coarse, it brings contact with
 * whole coordinates; fine, the eye may be very near a solid. The near plane is between a thousandth and a quarter of
 * the scene's size away, the look-at point at least half of it. False: the eye is within a solid, or all of the scene
 * behind it. */
static bool place_amid(studio *st)
{
    const oracle_view *view = &st->scene->view;
    roberts_vec3 lo, hi;
    double size = diameter(&st->scene->mesh, &lo, &hi) / st->unit, step, far = 1;
    bool coarse = rng_int(&st->d, 0, 1) && size > 4 && size < 512;
    roberts_vec3 eye = rng_int(&st->d, 0, 2) ? amid_scene(st, lo, hi) : beside_solid(st), ahead;
    size = st->unit * ldexp(1, (int)floor(log2(size)));
    double grain = coarse ? st->unit / 2 : size * 0x1p-24;
    eye = on_grid(eye, grain);
    look_small(st, 2);
    step = coarse ? grain * rng_int(&st->d, 1, 3) : size * ldexp(1, -rng_int(&st->d, 3, 10));
    ahead = (roberts_vec3){-step * view->x, -step * view->y, -step * view->z};
    while (far * step < size / 2)
        far *= 2;
    set_eye(st, eye, ahead, far);
    return is_outside(st, eye, 1e-9) && any_beyond(&st->scene->mesh, view->near, ahead);
}

/* A millionth of the scene's size before a corner and in no line with it, with the near plane between: as near as the
 * program allows. Eye, near plane and look-at point are exact, as in place_amid(). False: the eye is within a solid. */
static bool place_close(studio *st)
{
    const roberts_mesh *mesh = &st->scene->mesh;
    const oracle_view *view = &st->scene->view;
    roberts_vec3 lo, hi, corner = mesh->vertex[rng_int(&st->d, 0, (int)mesh->vertex_count - 1)], ahead;
    double size = diameter(mesh, &lo, &hi), grain = ldexp(1, (int)floor(log2(size)) - 26);
    look_small(st, 2);
    double near = 1.01e-6 * size / hypot(hypot(view->x, view->y), view->z), step = grain * ceil(near / grain);
    ahead = (roberts_vec3){-step * view->x, -step * view->y, -step * view->z};
    roberts_vec3 aside = real_point(st), eye = {corner.x - 1.25 * ahead.x + 0.25 * step * aside.x,
                                                corner.y - 1.25 * ahead.y + 0.25 * step * aside.y,
                                                corner.z - 1.25 * ahead.z + 0.25 * step * aside.z};
    eye = on_grid(eye, grain);
    set_eye(st, eye, ahead, 0x1p17);
    return is_outside(st, eye, 1e-9);
}

/* In the plane of a face, at a corner of it or in line with one of its sides, with a near plane from a sixteenth of
 * the scene's size on. Eye and near plane are exact where coordinates are whole numbers or halves. False: the eye is
 * within a solid, or all of the scene behind it. */
static bool place_in_plane(studio *st)
{
    const roberts_mesh *mesh = &st->scene->mesh;
    const oracle_view *view = &st->scene->view;
    roberts_vec3 lo, hi;
    double size = ldexp(1, (int)floor(log2(diameter(mesh, &lo, &hi)))), far = 1;
    uint32_t f = (uint32_t)rng_int(&st->d, 0, (int)mesh->face_count - 1);
    const uint32_t *corner = mesh->corner + mesh->face_start[f];
    roberts_vec3 o = mesh->vertex[corner[0]], p = mesh->vertex[corner[1]], q = mesh->vertex[corner[2]];
    double u = rng_int(&st->d, 0, 1) ? 0 : rng_int(&st->d, -8, 8) / 4.0;
    double w = rng_int(&st->d, 0, 1) ? 0 : rng_int(&st->d, -8, 8) / 4.0;
    roberts_vec3 eye = {o.x + u * (p.x - o.x) + w * (q.x - o.x), o.y + u * (p.y - o.y) + w * (q.y - o.y),
                        o.z + u * (p.z - o.z) + w * (q.z - o.z)};
    double step = size * ldexp(1, -rng_int(&st->d, 4, 10));
    look_small(st, 2);
    roberts_vec3 ahead = {-step * view->x, -step * view->y, -step * view->z};
    while (far * step < size)
        far *= 2;
    set_eye(st, eye, ahead, far);
    return is_outside(st, eye, 0) && any_beyond(mesh, view->near, ahead);
}

/* A parallel view of a section through a point of the scene's box or near a solid, on a grid as coarse as in
 * place_amid(). False: all of the scene lies in front of the section. */
static bool place_section(studio *st)
{
    oracle_view *view = &st->scene->view;
    roberts_vec3 lo, hi;
    const double size = diameter(&st->scene->mesh, &lo, &hi) / st->unit;
    const bool coarse = rng_int(&st->d, 0, 1) && size > 4 && size < 512;
    const double grain = coarse ? st->unit / 2 : st->unit * ldexp(1, (int)floor(log2(size)) - 24);
    const roberts_vec3 at = on_grid(rng_int(&st->d, 0, 2) ? amid_scene(st, lo, hi) : beside_solid(st), grain);
    if (rng_int(&st->d, 0, 1))
        look_axis(st);
    else
        look_small(st, 2);
    view->cut = true;
    view->near = at;
    return any_beyond(&st->scene->mesh, at, (roberts_vec3){-view->x, -view->y, -view->z});
}

static void look_from(studio *st, bool place(studio *))
{
    oracle_view before = st->scene->view;
    for (int i = 0; i < 1000; i++)
        if (place(st))
            return;
    st->scene->view = before; /* there is no room */
    look_from_eye(st);
}

void look_from_amid(studio *st)
{
    look_from(st, place_amid);
}

void look_from_close(studio *st)
{
    look_from(st, place_close);
}

void look_from_face_plane(studio *st)
{
    look_from(st, place_in_plane);
}

void look_at_section(studio *st)
{
    look_from(st, place_section);
}

void look_oblique(studio *st)
{
    const double x = rng_int(&st->d, -4, 4) / 4.0, z = rng_int(&st->d, 1, 4) / 4.0;
    st->scene->view = (oracle_view){.x = x, .y = -1, .z = z};
    st->scene->oblique = true;
}

/* ---- changes of a whole scene ---------------------------------------------------------------------------------- */

void map_vertices(studio *st, double scale, roberts_vec3 shift)
{
    roberts_mesh *mesh = &st->scene->mesh;
    for (size_t i = 0; i < mesh->vertex_count; i++)
        mesh->vertex[i] = (roberts_vec3){scale * mesh->vertex[i].x + shift.x, scale * mesh->vertex[i].y + shift.y,
                                         scale * mesh->vertex[i].z + shift.z};
}

static roberts_vec3 mapped(double m[3][3], roberts_vec3 p)
{
    return (roberts_vec3){m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z, m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z,
                          m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z};
}

void map_vertices_by(studio *st, double m[3][3])
{
    roberts_mesh *mesh = &st->scene->mesh;
    for (size_t i = 0; i < mesh->vertex_count; i++)
        mesh->vertex[i] = mapped(m, mesh->vertex[i]);
}

/* ---- families whose contacts rounding has spoiled -------------------------------------------------------------- */

typedef struct triangle {
    uint32_t corner[3];
} triangle;

/* The faces cut into triangles, from any of their corners, in any order. */
static triangle *shuffled_triangles(studio *st, size_t *count)
{
    const roberts_mesh *mesh = &st->scene->mesh;
    triangle *list = malloc((mesh->corner_count + 1) * sizeof *list);
    *count = 0;
    for (size_t f = 0; list && f < mesh->face_count; f++) {
        const uint32_t *corner = mesh->corner + mesh->face_start[f];
        uint32_t n = mesh->face_start[f + 1] - mesh->face_start[f], k = (uint32_t)rng_int(&st->d, 0, (int)n - 1);
        for (uint32_t i = 1; i + 1 < n; i++)
            list[(*count)++] = (triangle){{corner[k], corner[(k + i) % n], corner[(k + i + 1) % n]}};
    }
    for (size_t i = *count; list && i > 1; i--) {
        size_t k = (size_t)rng_int(&st->d, 0, (int)i - 1);
        triangle swap = list[k];
        list[k] = list[i - 1];
        list[i - 1] = swap;
    }
    return list;
}

/* Corner i of triangle k becomes vertex 3 k + i; in `welded` all corners in one place become the first of them. */
static bool add_triangles(const roberts_mesh *from, const triangle *list, size_t count, roberts_mesh *welded)
{
    uint32_t *first = malloc((from->vertex_count + 1) * sizeof *first);
    bool ok = first != NULL;
    for (size_t v = 0; ok && v < from->vertex_count; v++)
        first[v] = ROBERTS_NONE;
    for (size_t k = 0; ok && k < count; k++) {
        uint32_t face[3];
        for (uint32_t i = 0; ok && i < 3; i++) {
            uint32_t old = list[k].corner[i];
            if (first[old] == ROBERTS_NONE)
                first[old] = (uint32_t)(3 * k + i);
            face[i] = first[old];
            ok = roberts_mesh_add_vertex(welded, from->vertex[old], NULL, NULL) == ROBERTS_OK;
        }
        ok = ok && roberts_mesh_add_face(welded, face, 3, NULL) == ROBERTS_OK;
    }
    free(first);
    return ok;
}

static bool read_soup(const roberts_mesh *welded, roberts_mesh *soup)
{
    char *text = NULL;
    size_t size = 0;
    FILE *file = open_memstream(&text, &size);
    if (!file)
        return false;
    fprintf(file, "OFF\n%zu %zu 0\n", welded->vertex_count, welded->face_count);
    for (size_t v = 0; v < welded->vertex_count; v++)
        fprintf(file, "%.17g %.17g %.17g\n", welded->vertex[v].x, welded->vertex[v].y, welded->vertex[v].z);
    for (size_t f = 0; f < welded->face_count; f++)
        fprintf(file, "3 %zu %zu %zu\n", 3 * f, 3 * f + 1, 3 * f + 2);
    bool ok = fclose(file) == 0;
    ok = ok && roberts_mesh_read_memory(soup, "soup", text, size, NULL, NULL) == ROBERTS_OK;
    free(text);
    return ok;
}

void give_as_soup(studio *st)
{
    roberts_mesh welded = {0};
    size_t count;
    triangle *list = shuffled_triangles(st, &count);
    bool ok = list && add_triangles(&st->scene->mesh, list, count, &welded) && read_soup(&welded, &st->scene->soup);
    roberts_mesh_free(&st->scene->mesh);
    st->scene->mesh = welded;
    st->scene->has_soup = true;
    st->no_memory = st->no_memory || !ok;
    free(list);
}

/* Appends vertices first .. end - 1 as a file of points. %.17g writes doubles so that they are read back exactly. */
static bool read_points(const roberts_mesh *from, size_t first, size_t end, roberts_mesh *points)
{
    char *text = NULL;
    size_t size = 0;
    FILE *file = open_memstream(&text, &size);
    if (!file)
        return false;
    fprintf(file, "3 points\n%zu\n", end - first);
    for (size_t v = first; v < end; v++)
        fprintf(file, "%.17g %.17g %.17g\n", from->vertex[v].x, from->vertex[v].y, from->vertex[v].z);
    bool ok = fclose(file) == 0;
    ok = ok && roberts_mesh_read_memory(points, "points", text, size, NULL, NULL) == ROBERTS_OK;
    free(text);
    return ok;
}

/* Solids have been put one after the other: each ends with its greatest vertex. */
void give_as_points(studio *st)
{
    const roberts_mesh *mesh = &st->scene->mesh;
    size_t first = 0;
    bool ok = true;
    for (uint32_t s = 0; ok && s < st->solid_count; s++) {
        uint32_t end_face = s + 1 < st->solid_count ? st->first_face[s + 1] : (uint32_t)mesh->face_count;
        size_t end = first;
        for (uint32_t i = mesh->face_start[st->first_face[s]]; i < mesh->face_start[end_face]; i++)
            end = mesh->corner[i] >= end ? mesh->corner[i] + (size_t)1 : end;
        ok = read_points(mesh, first, end, &st->scene->soup);
        first = end;
    }
    st->scene->has_soup = st->scene->hull = true;
    st->no_memory = st->no_memory || !ok || first != mesh->vertex_count;
}

static bool copy_mesh(const roberts_mesh *from, roberts_mesh *to)
{
    bool ok = true;
    for (size_t i = 0; i < from->vertex_count; i++)
        ok = ok && roberts_mesh_add_vertex(to, from->vertex[i], NULL, NULL) == ROBERTS_OK;
    for (size_t f = 0; f < from->face_count; f++)
        ok = ok && roberts_mesh_add_face(to, from->corner + from->face_start[f],
                                         from->face_start[f + 1] - from->face_start[f], NULL) == ROBERTS_OK;
    return ok;
}

/* Keeps the scene as the original and sends every vertex, and the viewer with them, through m. What moves by 1e-13 of
 * the largest coordinate is not judged. */
void spoil(studio *st, double m[3][3])
{
    test_scene *scene = st->scene;
    double largest = 0;
    if (st->eye)
        look_from_eye(st);
    st->eye = false;
    scene->has_original = true;
    scene->original_view = scene->view;
    st->no_memory = st->no_memory || !copy_mesh(&scene->mesh, &scene->original);
    for (size_t i = 0; i <= scene->mesh.vertex_count && !st->no_memory; i++) {
        roberts_vec3 *v = scene->mesh.vertex + i, p;
        p = i < scene->mesh.vertex_count ? *v : (roberts_vec3){scene->view.x, scene->view.y, scene->view.z};
        p = mapped(m, p);
        if (i < scene->mesh.vertex_count)
            *v = p;
        else
            scene->view = (oracle_view){.x = p.x, .y = p.y, .z = p.z, .w = scene->view.w};
        if (i < scene->mesh.vertex_count || scene->view.w)
            largest = fmax(largest, fmax(fabs(p.x), fmax(fabs(p.y), fabs(p.z))));
    }
    scene->slack = ROUNDING * largest;
}

void spoil_scale(studio *st, double scale)
{
    double m[3][3] = {{scale, 0, 0}, {0, scale, 0}, {0, 0, scale}};
    spoil(st, m);
}
