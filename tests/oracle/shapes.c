/* shapes.c - see shapes.h. */
#include "shapes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- shapes: convex polyhedra with whole coordinates ----------------------------------------------------------- */

static int64_t det3(const int64_t *o, const int64_t *a, const int64_t *b, const int64_t *c)
{
    int64_t u[3], v[3], w[3];
    for (int i = 0; i < 3; i++) {
        u[i] = a[i] - o[i];
        v[i] = b[i] - o[i];
        w[i] = c[i] - o[i];
    }
    return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

static void normal3(const int64_t *o, const int64_t *a, const int64_t *b, int64_t *n)
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = (a[j] - o[j]) * (b[k] - o[k]) - (a[k] - o[k]) * (b[j] - o[j]);
    }
}

/* Walks round the points of one plane, from corner to corner of their convex polygon (gift wrapping), n to the left. */
static int wrap_face(const shape *s, const int *on, int count, const int64_t *n, int *corner)
{
    int first = on[0], axis = n[0] ? 0 : n[1] ? 1 : 2, at, used = 0;
    for (int i = 1; i < count; i++) /* the least point in lexical order is a corner */
        for (int k = 0; k < 3; k++)
            if (s->point[on[i]][k] != s->point[first][k]) {
                first = s->point[on[i]][k] < s->point[first][k] ? on[i] : first;
                break;
            }
    at = first;
    do {
        int next = -1;
        corner[used++] = at;
        for (int i = 0; i < count; i++) {
            int64_t m[3], far = 0, near = 0;
            int turn;
            if (on[i] == at)
                continue;
            if (next < 0) {
                next = on[i];
                continue;
            }
            normal3(s->point[at], s->point[next], s->point[on[i]], m);
            turn = ((m[axis] > 0) - (m[axis] < 0)) * (n[axis] > 0 ? 1 : -1); /* m is parallel to n, or zero */
            for (int k = 0; k < 3; k++) {
                far += llabs(s->point[on[i]][k] - s->point[at][k]);
                near += llabs(s->point[next][k] - s->point[at][k]);
            }
            if (turn < 0 || (turn == 0 && far > near))
                next = on[i];
        }
        at = next;
    } while (at != first && used < count);
    return used;
}

/* Leaves the convex hull of the shape's points in the shape; false where they are flat or the hull is too large.
 * Each plane with all points on one side is a face. This is simple, and fast enough for 64 points. */
bool shape_hull(shape *s)
{
    uint64_t seen[SHAPE_CORNERS];
    bool used[HULL_POINTS] = {false};
    int number[HULL_POINTS], kept = 0;
    s->face_count = s->corner_count = 0;
    s->face_start[0] = 0;
    for (int i = 0; i < s->point_count; i++)
        for (int j = i + 1; j < s->point_count; j++)
            for (int k = j + 1; k < s->point_count; k++) {
                int on[HULL_POINTS], count = 0, f = 0;
                bool above = false, below = false;
                uint64_t mask = 0;
                int64_t n[3];
                normal3(s->point[i], s->point[j], s->point[k], n);
                if (!n[0] && !n[1] && !n[2])
                    continue;
                for (int m = 0; m < s->point_count && !(above && below); m++) {
                    int64_t d = det3(s->point[i], s->point[j], s->point[k], s->point[m]);
                    above |= d > 0;
                    below |= d < 0;
                    if (d == 0) {
                        on[count++] = m;
                        mask |= (uint64_t)1 << m;
                    }
                }
                if (above == below) /* points on both sides; or all in the plane */
                    continue;
                while (f < s->face_count && seen[f] != mask)
                    f++;
                if (f < s->face_count)
                    continue;
                if (s->corner_count + count > SHAPE_CORNERS || s->face_count + 2 > SHAPE_CORNERS)
                    return false;
                seen[s->face_count++] = mask;
                s->corner_count += wrap_face(s, on, count, n, s->corner + s->corner_count);
                s->face_start[s->face_count] = s->corner_count;
            }
    for (int i = 0; i < s->corner_count; i++)
        used[s->corner[i]] = true;
    for (int i = 0; i < s->point_count; i++)
        if (used[i]) {
            number[i] = kept;
            memcpy(s->point[kept++], s->point[i], sizeof s->point[0]);
        }
    for (int i = 0; i < s->corner_count; i++)
        s->corner[i] = number[s->corner[i]];
    s->point_count = kept;
    return s->face_count >= 4;
}

void shape_point(shape *s, int64_t x, int64_t y, int64_t z)
{
    int64_t p[3] = {x, y, z};
    for (int i = 0; i < s->point_count; i++)
        if (memcmp(s->point[i], p, sizeof p) == 0)
            return;
    if (s->point_count < HULL_POINTS)
        memcpy(s->point[s->point_count++], p, sizeof p);
}

shape shape_box(int x, int y, int z)
{
    shape s = {0};
    for (int i = 0; i < 8; i++)
        shape_point(&s, i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0);
    shape_hull(&s);
    return s;
}

/* The hull of `count` random points with coordinates of 0 .. size. Small sizes give many-cornered faces. */
shape shape_random(rng *d, int count, int size)
{
    shape s;
    do {
        s = (shape){0};
        for (int i = 0; i < count; i++) {
            int x = rng_int(d, 0, size), y = rng_int(d, 0, size), z = rng_int(d, 0, size);
            shape_point(&s, x, y, z);
        }
    } while (!shape_hull(&s));
    return s;
}

/* A prism or a pyramid, leaning, over a polygon of up to 16 corners. Its sides are the first whole vectors by angle. */
shape shape_prism(rng *d)
{
    static const int side[16][2] = {{1, 0},  {2, 1},   {1, 1},   {1, 2},   {0, 1},  {-1, 2}, {-1, 1}, {-2, 1},
                                    {-1, 0}, {-2, -1}, {-1, -1}, {-1, -2}, {0, -1}, {1, -2}, {1, -1}, {2, -1}};
    shape s = {0};
    int x = 0, y = 0, lean_x = rng_int(d, -2, 2), lean_y = rng_int(d, -2, 2), high = rng_int(d, 1, 5);
    int step = 1 << rng_int(d, 0, 2), axis = rng_int(d, 0, 2);
    bool pyramid = rng_int(d, 0, 2) == 0;
    for (int i = 0; i < 16; i += step) {
        shape_point(&s, x, y, 0);
        if (!pyramid)
            shape_point(&s, x + lean_x, y + lean_y, high);
        x += side[i][0];
        y += side[i][1];
    }
    if (pyramid)
        shape_point(&s, lean_x, lean_y + 3, high);
    for (int i = 0; i < s.point_count; i++) { /* lay it along another axis */
        int64_t p[3] = {s.point[i][0], s.point[i][1], s.point[i][2]};
        for (int k = 0; k < 3; k++)
            s.point[i][k] = p[(k + axis) % 3];
    }
    shape_hull(&s);
    return s;
}

static int common_divisor(int a, int b)
{
    return b == 0 ? abs(a) : common_divisor(b, a % b);
}

/* The whole vectors of no more than `most` either way that are no multiple of others, by angle from (1, 0) to before
 * (0, 1). Gives their number. */
static int first_vectors(int most, int (*v)[2])
{
    int count = 0;
    for (int x = 1; x <= most; x++)
        for (int y = 0; y <= most; y++)
            if (common_divisor(x, y) == 1) {
                int i = count++;
                for (; i > 0 && v[i - 1][1] * x > y * v[i - 1][0]; i--)
                    memcpy(v[i], v[i - 1], sizeof v[i]);
                v[i][0] = x;
                v[i][1] = y;
            }
    return count;
}

static void add_face(shape *s, const int *corner, int count)
{
    memcpy(s->corner + s->corner_count, corner, (size_t)count * sizeof *corner);
    s->corner_count += count;
    s->face_start[++s->face_count] = s->corner_count;
}

/* Adds a face, and one for each of its sides, to the same corners elsewhere or to an apex. */
static void add_coin(shape *s, int64_t (*ring)[2], int count, bool pyramid, const int *lean)
{
    int own[SHAPE_POINTS], other[SHAPE_POINTS];
    for (int i = 0; i < count; i++) {
        int64_t low[3] = {ring[i][0], ring[i][1], 0}, high[3] = {low[0] + lean[0], low[1] + lean[1], lean[2]};
        memcpy(s->point[own[i] = i], low, sizeof low);
        memcpy(s->point[other[i] = count + (pyramid ? 0 : i)], high, sizeof high);
    }
    s->point_count = count + (pyramid ? 1 : count);
    add_face(s, own, count);
    if (!pyramid)
        add_face(s, other, count);
    for (int i = 0; i < count; i++) {
        int k = (i + 1) % count, side[4] = {own[i], own[k], other[k], other[i]};
        add_face(s, side, pyramid ? 3 : 4);
    }
}

/* Steps from a corner to the next, by a vector turned by this many quarters. */
static void go_on(int64_t *x, int64_t *y, const int *v, int quarters)
{
    int64_t turned[4][2] = {{v[0], v[1]}, {-v[1], v[0]}, {-v[0], -v[1]}, {v[1], -v[0]}};
    *x += turned[quarters][0];
    *y += turned[quarters][1];
}

/* Its sides are whole vectors by angle, of which some are left out together with their opposites, and some come in two
 * parts. */
shape shape_coin(rng *d)
{
    shape s = {0};
    int v[SHAPE_POINTS][2], most = rng_int(d, 6, 7), quarter = first_vectors(most, v), count = 0;
    int lean_x = rng_int(d, -40, 40), lean_y = rng_int(d, -40, 40), high = rng_int(d, 1, 60);
    int parts[SHAPE_POINTS], lean[3] = {lean_x, lean_y, high};
    int64_t ring[SHAPE_POINTS][2], x = 0, y = 0;
    bool pyramid = rng_int(d, 0, 2) == 0, straight = rng_int(d, 0, 2) == 0;
    for (int i = 0; i < 2 * quarter; i++)
        parts[i] = rng_int(d, 0, 9) == 0 ? 0 : straight && rng_int(d, 0, 9) == 0 && quarter < 30 ? 2 : 1;
    for (int i = 0; i < 4 * quarter; i++)
        for (int k = 0; k < parts[i % (2 * quarter)]; k++) {
            ring[count][0] = x;
            ring[count++][1] = y;
            go_on(&x, &y, v[i % quarter], i / quarter);
        }
    lean[0] += pyramid ? (int)ring[count / 4][0] : 0; /* an apex over the middle, or beside it */
    lean[1] += pyramid ? (int)ring[count / 4][1] : 0;
    add_coin(&s, ring, count, pyramid, lean);
    return s;
}

shape shape_large_coin(rng *d)
{
    shape s = {0};
    int v[SHAPE_POINTS][2], quarter = first_vectors(14, v), count = 0;
    int lean_x = rng_int(d, -400, 400), lean_y = rng_int(d, -400, 400), high = rng_int(d, 1, 400);
    int64_t ring[SHAPE_POINTS][2], x = 0, y = 0;
    bool left_out[SHAPE_POINTS];
    for (int i = 0; i < quarter; i++)
        left_out[i] = rng_int(d, 0, 19) == 0;
    for (int i = 0; i < 4 * quarter; i++)
        if (!left_out[i % quarter]) {
            ring[count][0] = x;
            ring[count++][1] = y;
            go_on(&x, &y, v[i % quarter], i / quarter);
        }
    add_coin(&s, ring, count, false, (int[]){lean_x, lean_y, high});
    return s;
}

shape shape_fan(rng *d)
{
    shape s = {0};
    int v[SHAPE_POINTS][2], quarter = first_vectors(rng_int(d, 7, 9), v), count = 0;
    int64_t ring[SHAPE_POINTS][2], x = 0, y = 0;
    for (int i = 0; i < 4 * quarter; i++, count++) {
        ring[count][0] = x;
        ring[count][1] = y;
        go_on(&x, &y, v[i % quarter], i / quarter);
    }
    int middle = (int)ring[2 * quarter][1] / 2, lean_x = rng_int(d, -middle, middle), high = rng_int(d, 20, 400);
    int lean_y = rng_int(d, 0, 2 * middle);
    add_coin(&s, ring, count, true, (int[]){lean_x, lean_y, high});
    return s;
}

shape shape_plate(rng *d)
{
    shape s = {0};
    int wide = rng_int(d, 20, 50), high = rng_int(d, 14, 50), lean[3] = {0, 0, 0}, count = 0;
    int64_t ring[SHAPE_POINTS][2], x = 0, y = 0;
    lean[2] = rng_int(d, 1, 4);
    for (int quarters = 0; quarters < 4; quarters++)
        for (int i = quarters % 2 ? high : wide; i > 0; i--) {
            ring[count][0] = x;
            ring[count++][1] = y;
            go_on(&x, &y, (int[]){1, 0}, quarters);
        }
    add_coin(&s, ring, count, false, lean);
    return s;
}

shape shape_regular_prism(int sides)
{
    shape s = {0};
    for (int i = 0; i < sides; i++) {
        double angle = 2 * 3.14159265358979323846 * i / sides;
        int64_t x = (int64_t)floor(1000 * cos(angle) + 0.5), y = (int64_t)floor(1000 * sin(angle) + 0.5);
        shape_point(&s, x, y, 0);
        shape_point(&s, x, y, 1000);
    }
    shape_hull(&s);
    return s;
}

shape shape_rhombic_dodecahedron(void)
{
    shape s = {0};
    for (int i = 0; i < 8; i++)
        shape_point(&s, i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    for (int k = 0; k < 3; k++)
        for (int way = -2; way <= 2; way += 4)
            shape_point(&s, k == 0 ? way : 0, k == 1 ? way : 0, k == 2 ? way : 0);
    shape_hull(&s);
    return s;
}

shape shape_truncated_octahedron(void)
{
    shape s = {0};
    for (int zero = 0; zero < 3; zero++)
        for (int i = 0; i < 8; i++) {
            int64_t p[3], one = i & 1 ? 1 : -1, two = i & 2 ? 2 : -2;
            p[zero] = 0;
            p[(zero + 1) % 3] = i & 4 ? one : two;
            p[(zero + 2) % 3] = i & 4 ? two : one;
            shape_point(&s, p[0], p[1], p[2]);
        }
    shape_hull(&s);
    return s;
}

shape shape_any(rng *d)
{
    int x, y, z;
    switch (rng_int(d, 0, 5)) {
    case 0:
        x = rng_int(d, 1, 4);
        y = rng_int(d, 1, 4);
        z = rng_int(d, 1, 4);
        return shape_box(x, y, z);
    case 1:
        return shape_prism(d);
    case 2:
        return shape_random(d, 4, 3);
    case 3:
        return shape_random(d, 6, 2);
    case 4:
        return shape_random(d, 10, 3);
    default:
        return shape_random(d, 20, 4);
    }
}
