/* orient.c - on which side of a line a point lies, exactly. */
#include <math.h>

#include "base/dd.h"
#include "base/orient.h"

/* Adds a * b to a sum of `count` non-overlapping doubles, smallest first; returns the new count (J. R. Shewchuk,
 * "Adaptive precision floating-point arithmetic and fast robust geometric predicates", Discrete & Computational
 * Geometry 18, 1997). */
static int add_product(double *sum, int count, double a, double b)
{
    double part[2] = {0.0, a * b};
    part[0] = fma(a, b, -part[1]);
    for (int k = 0; k < 2; k++) {
        double carry = part[k];
        for (int i = 0; i < count; i++) {
            dd s = dd_two_sum(carry, sum[i]);
            carry = s.hi;
            sum[i] = s.lo;
        }
        sum[count++] = carry;
    }
    return count;
}

static double exact_turn(roberts_vec2 a, roberts_vec2 b, roberts_vec2 c)
{
    dd bx = dd_two_diff(b.x, a.x), by = dd_two_diff(b.y, a.y), cx = dd_two_diff(c.x, a.x), cy = dd_two_diff(c.y, a.y);
    double sum[16], turn = 0.0;
    int n = add_product(sum, 0, bx.lo, cy.lo);
    n = add_product(sum, n, -by.lo, cx.lo);
    n = add_product(sum, n, bx.lo, cy.hi);
    n = add_product(sum, n, bx.hi, cy.lo);
    n = add_product(sum, n, -by.lo, cx.hi);
    n = add_product(sum, n, -by.hi, cx.lo);
    n = add_product(sum, n, bx.hi, cy.hi);
    n = add_product(sum, n, -by.hi, cx.hi);
    for (int i = 0; i < n; i++)
        turn += sum[i]; /* the last nonzero part exceeds all others together */
    return turn;
}

double orient2d(roberts_vec2 a, roberts_vec2 b, roberts_vec2 c)
{
    double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x), turn = left - right;
    if (fabs(turn) > 4.0 * 0x1p-52 * (fabs(left) + fabs(right)) || (left == 0.0 && right == 0.0))
        return turn;
    return exact_turn(a, b, c);
}
