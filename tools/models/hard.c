/* hard.c - scenes that are hard for a grid: long solids side by side, sizes far apart, deep piles.
 *
 * In a deep pile each solid peeps out, so that no solid hides another whole. */
#include <math.h>

#include "exact.h"
#include "large.h"

/* Planks side by side. The floor is square. */
void boards_solid(body *b, const plan *p, uint64_t index)
{
    double y = (double)index;
    body_box(b, vec3(0, y, 0), vec3((double)p->n, y + 1, 0.25));
}

/* Sticks of the length of the picture, all within some degrees of its diagonal, one above the other. */
void diagonal_solid(body *b, const plan *p, uint64_t index)
{
    rng r = rng_of(p->seed, index);
    double side = (double)p->n, across = side * (rng_unit(&r) - 0.5), z = (double)index;
    roberts_vec2 a = half_angle(0.375 + 0.0625 * rng_unit(&r));
    roberts_vec3 middle = vec3(-across, across, z);
    body_turned_box(b, vec3(middle.x - side, middle.y - 0.125, z), vec3(middle.x + side, middle.y + 0.125, z + 0.5),
                    a.x, a.y);
}

/* n cubes close together, and four at the corners of a square a thousand times as wide. */
uint64_t crowd_count(uint64_t n)
{
    return n + 4;
}

void crowd_solid(body *b, const plan *p, uint64_t index)
{
    uint64_t width = 1, i = index - 4;
    rng r = rng_of(p->seed, index);
    while (width * width * width < p->n)
        width++;
    double far = 500.0 * (double)width;
    if (index < 4) {
        double x = index & 1 ? far : -far, y = index & 2 ? far : -far;
        body_box(b, vec3(x - 1, y - 1, 0), vec3(x + 1, y + 1, 1));
        return;
    }
    roberts_vec3 middle = vec3((double)(i % width), (double)(i / width % width), (double)(i / width / width));
    body_add(b, &p->cube, rng_turn(&r, 0.25, middle));
}

/* Cubes of sixteen sizes about one point: the smaller, the nearer to it. Those of one size fill a ring, which is half
 * as wide as the next one. In the picture from above, each lies in a place of its own. */
void galaxy_solid(body *b, const plan *p, uint64_t index)
{
    rng r = rng_of(p->seed, index);
    uint64_t places = 1, of_ring = index / 16;
    while (64 * places * places < p->n + 16)
        places++; /* across a ring; four times as many are along it */
    double m = (double)places, scale = ldexp(1, -(int)(index % 16));
    uint64_t along = of_ring / places % (4 * places);
    roberts_vec2 at = half_angle(((double)(along / 2) + 0.5) / m - 1);
    double far = scale * (1 + ((double)(of_ring % places) + 0.5) / m), side = along % 2 ? -far : far;
    body_add(b, &p->cube,
             rng_turn(&r, 0.25 * scale / m, vec3(side * at.x, side * at.y, 0.25 * scale * (rng_unit(&r) - 0.5))));
}

/* Posts side by side. From nearly above, their long edges are seen nearly end-on. */
void posts_solid(body *b, const plan *p, uint64_t index)
{
    rng r = rng_of(p->seed, index);
    uint64_t width = 1;
    while (width * width < p->n)
        width++;
    double x = (double)(index % width), y = (double)(index / width), high = 500 + 500 * rng_unit(&r);
    body_box(b, vec3(x, y, 0), vec3(x + 0.5 + 0.25 * rng_unit(&r), y + 0.5 + 0.25 * rng_unit(&r), high));
}

/* Square shells from wide to narrow, each turned anyhow. */
void shells_solid(body *b, const plan *p, uint64_t index)
{
    rng r = rng_of(p->seed, index);
    double z = (double)index, side = 1.0 + ((double)p->n - z) / (double)p->n;
    roberts_vec2 a = half_angle(2.0 * rng_unit(&r) - 1.0);
    body_turned_box(b, vec3(-side, -side, z), vec3(side, side, z + 0.5), a.x, a.y);
}

/* Thin sheets one above the other, each turned and moved a little. */
void sheets_solid(body *b, const plan *p, uint64_t index)
{
    rng r = rng_of(p->seed, index);
    double x = 0.125 * rng_unit(&r), y = 0.125 * rng_unit(&r), z = (double)index / (double)p->n;
    roberts_vec2 a = half_angle(0.0625 * (rng_unit(&r) - 0.5));
    body_turned_box(b, vec3(x - 2, y - 1, z), vec3(x + 2, y + 1, z + 0.5 / (double)p->n), a.x, a.y);
}

/* Floors of a tower, narrower toward its top, each turned against the one below. */
void floors_solid(body *b, const plan *p, uint64_t index)
{
    double z = (double)index, side = 1.0 + ((double)p->n - z) / (double)p->n;
    roberts_vec2 a = half_angle(2.0 * z / (double)p->n - 1.0);
    body_turned_box(b, vec3(-side, -side, z), vec3(side, side, z + 0.5), a.x, a.y);
}

/* Spines from the middle of a ball, in all directions. */
void spines_solid(body *b, const plan *p, uint64_t index)
{
    rng r = rng_of(p->seed, index);
    motion m = rng_turn(&r, 1, vec3(0, 0, 0));
    double thick = 1.0 / sqrt((double)p->n);
    body spine = {0};
    body_pyramid(&spine, vec3(-thick, -thick, 1), vec3(thick, thick, 2 + rng_unit(&r)));
    body_add(b, &spine, m);
    body_free(&spine);
}
