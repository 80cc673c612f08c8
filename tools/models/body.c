/* body.c - growing arrays of vertices and faces, and the simplest solids. */
#include "body.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Makes room for one more element of `size` bytes at `count`. */
static void *grown(void *array, size_t *room, size_t count, size_t size)
{
    if (count < *room)
        return array;
    *room = *room ? 2 * *room : 64;
    array = realloc(array, *room * size);
    if (!array) {
        fputs("make-models: out of memory\n", stderr);
        exit(EXIT_FAILURE);
    }
    return array;
}

uint32_t body_vertex(body *b, double x, double y, double z)
{
    b->vertex = grown(b->vertex, &b->vertex_room, b->vertex_count, sizeof *b->vertex);
    b->vertex[b->vertex_count] = vec3(x + 0.0, y + 0.0, z + 0.0); /* -0 + 0 is +0 */
    return (uint32_t)b->vertex_count++;
}

void body_corner(body *b, uint32_t vertex)
{
    b->corner = grown(b->corner, &b->corner_room, b->corner_count, sizeof *b->corner);
    b->corner[b->corner_count++] = vertex;
}

void body_end_face(body *b)
{
    b->face_end = grown(b->face_end, &b->face_room, b->face_count, sizeof *b->face_end);
    b->face_end[b->face_count++] = (uint32_t)b->corner_count;
}

void body_face(body *b, const uint32_t *corner, size_t count)
{
    for (size_t i = 0; i < count; i++)
        body_corner(b, corner[i]);
    body_end_face(b);
}

size_t body_face_start(const body *b, size_t f)
{
    return f ? b->face_end[f - 1] : 0;
}

roberts_vec3 body_face_normal(const body *b, size_t f)
{
    size_t first = body_face_start(b, f), end = b->face_end[f];
    roberts_vec3 o = b->vertex[b->corner[first]], n = {0};
    for (size_t i = first + 1; i + 1 < end; i++)
        n = vec3_add(n, vec3_cross(vec3_sub(b->vertex[b->corner[i]], o), vec3_sub(b->vertex[b->corner[i + 1]], o)));
    return n;
}

static roberts_vec3 moved(motion move, roberts_vec3 p)
{
    const double(*m)[3] = (const double(*)[3])move.m;
    return (roberts_vec3){m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z + move.shift.x,
                          m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z + move.shift.y,
                          m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z + move.shift.z};
}

void body_add(body *b, const body *part, motion move)
{
    uint32_t base = (uint32_t)b->vertex_count;
    size_t i = 0;
    for (size_t v = 0; v < part->vertex_count; v++) {
        roberts_vec3 p = moved(move, part->vertex[v]);
        body_vertex(b, p.x, p.y, p.z);
    }
    for (size_t f = 0; f < part->face_count; f++) {
        for (; i < part->face_end[f]; i++)
            body_corner(b, base + part->corner[i]);
        body_end_face(b);
    }
}

void body_color(body *b, const uint32_t *color)
{
    size_t room = b->face_count;
    b->color = grown(b->color, &room, b->face_count, sizeof *b->color);
    memcpy(b->color, color, b->face_count * sizeof *color);
}

void body_clear(body *b)
{
    b->vertex_count = b->face_count = b->corner_count = 0;
}

void body_free(body *b)
{
    free(b->color);
    free(b->vertex);
    free(b->face_end);
    free(b->corner);
    *b = (body){0};
}

/* Adds six faces over the corners base .. base + 7: four around the bottom, counter-clockwise from above, then the four
 * above them. */
static void box_faces(body *b, uint32_t base)
{
    static const uint32_t side[6][4] = {{4, 5, 6, 7}, {3, 2, 1, 0}, {0, 1, 5, 4},
                                        {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    for (int f = 0; f < 6; f++) {
        uint32_t corner[4];
        for (int i = 0; i < 4; i++)
            corner[i] = base + side[f][i];
        body_face(b, corner, 4);
    }
}

void body_box(body *b, roberts_vec3 lo, roberts_vec3 hi)
{
    uint32_t base = (uint32_t)b->vertex_count;
    for (int i = 0; i < 2; i++) {
        double z = i ? hi.z : lo.z;
        body_vertex(b, lo.x, lo.y, z);
        body_vertex(b, hi.x, lo.y, z);
        body_vertex(b, hi.x, hi.y, z);
        body_vertex(b, lo.x, hi.y, z);
    }
    box_faces(b, base);
}

void body_plate(body *b, double bottom, const roberts_vec3 top[4])
{
    uint32_t base = (uint32_t)b->vertex_count;
    for (int i = 0; i < 4; i++)
        body_vertex(b, top[i].x, top[i].y, bottom);
    for (int i = 0; i < 4; i++)
        body_vertex(b, top[i].x, top[i].y, top[i].z);
    box_faces(b, base);
}

void body_turned_box(body *b, roberts_vec3 lo, roberts_vec3 hi, double c, double s)
{
    uint32_t base = (uint32_t)b->vertex_count;
    double x = (lo.x + hi.x) / 2, y = (lo.y + hi.y) / 2, u = (hi.x - lo.x) / 2, v = (hi.y - lo.y) / 2;
    for (int i = 0; i < 2; i++) {
        double z = i ? hi.z : lo.z;
        body_vertex(b, x - c * u + s * v, y - s * u - c * v, z);
        body_vertex(b, x + c * u + s * v, y + s * u - c * v, z);
        body_vertex(b, x + c * u - s * v, y + s * u + c * v, z);
        body_vertex(b, x - c * u - s * v, y - s * u + c * v, z);
    }
    box_faces(b, base);
}

void body_pyramid(body *b, roberts_vec3 lo, roberts_vec3 hi)
{
    uint32_t base = body_vertex(b, lo.x, lo.y, lo.z);
    body_vertex(b, hi.x, lo.y, lo.z);
    body_vertex(b, hi.x, hi.y, lo.z);
    body_vertex(b, lo.x, hi.y, lo.z);
    body_vertex(b, (lo.x + hi.x) / 2, (lo.y + hi.y) / 2, hi.z);
    for (uint32_t i = 0; i < 4; i++)
        body_face(b, (uint32_t[]){base + i, base + (i + 1) % 4, base + 4}, 3);
    body_face(b, (uint32_t[]){base + 3, base + 2, base + 1, base}, 4);
}

void body_tetrahedron(body *b, roberts_vec3 p0, roberts_vec3 p1, roberts_vec3 p2, roberts_vec3 p3)
{
    static const uint32_t side[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    roberts_vec3 n = vec3_cross(vec3_sub(p1, p0), vec3_sub(p2, p0));
    uint32_t base = body_vertex(b, p0.x, p0.y, p0.z);
    bool inside_out = vec3_dot(n, vec3_sub(p3, p0)) > 0; /* the face 0 1 2 would face p3 */
    body_vertex(b, p1.x, p1.y, p1.z);
    body_vertex(b, p2.x, p2.y, p2.z);
    body_vertex(b, p3.x, p3.y, p3.z);
    for (int f = 0; f < 4; f++) {
        uint32_t i = base + side[f][0], j = base + side[f][1], k = base + side[f][2];
        body_face(b, inside_out ? (uint32_t[]){i, k, j} : (uint32_t[]){i, j, k}, 3);
    }
}
