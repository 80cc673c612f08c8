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

/* Cubes of all sizes about the middle of a disc: the nearer to it, the smaller. */
void galaxy_solid(body *b, const plan *p, uint64_t index)
{
    rng r = rng_of(p->seed, index);
    roberts_vec2 at = half_angle(2 * rng_unit(&r) - 1);
    double scale = ldexp(1 + rng_unit(&r), -(int)rng_between(&r, 0, 15)), side = rng_unit(&r) < 0.5 ? -scale : scale;
    double size = 8.0 * scale / sqrt((double)p->n);
    body_add(b, &p->cube, rng_turn(&r, size, vec3(side * at.x, side * at.y, 0.25 * scale * (rng_unit(&r) - 0.5))));
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
