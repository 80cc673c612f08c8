/* polygon.c - is a point of its plane inside a polygon, in the three ways of "Lancer de rayons I", 1.4; ray against
 * a polygon.
 *
 * The note leaves out points on the border; here they are inside. The plane's frame stands on the corner whose two
 * sides span most: the note's A1 may lie on the line of its neighbours. */
#include "ray/ray.h"

/* P = O + x u + y v: `u` and `v` are multiplied with P - O to give x and y (they are the dual base). */
typedef struct frame {
    roberts_vec3 origin, u, v;
} frame;

/* The polygon's area vector, twice its area long, by Newell: every corner counts, and corners on one line do no harm.
 * `size` (may be NULL) is the sum of its terms' sizes, component by component. */
static roberts_vec3 area_vector(const roberts_vec3 *corner, size_t count, roberts_vec3 *size)
{
    roberts_vec3 n = {0.0, 0.0, 0.0}, s = {0.0, 0.0, 0.0};
    for (size_t i = 1; i + 1 < count; i++) {
        roberts_vec3 p = vec3_sub(corner[i], corner[0]), q = vec3_sub(corner[i + 1], corner[0]);
        n = vec3_add(n, vec3_cross(p, q));
        s.x += fabs(p.y * q.z) + fabs(p.z * q.y);
        s.y += fabs(p.z * q.x) + fabs(p.x * q.z);
        s.z += fabs(p.x * q.y) + fabs(p.y * q.x);
    }
    if (size)
        *size = s;
    return n;
}

/* Whether the area is more than rounding; a polygon without area has no inside. */
static bool has_area(roberts_vec3 n, roberts_vec3 size)
{
    return !ray_parallel(n.x, size.x) || !ray_parallel(n.y, size.y) || !ray_parallel(n.z, size.z);
}

/* The corner whose sides span the largest triangle (the first of equal ones). */
static size_t widest_corner(const roberts_vec3 *corner, size_t count)
{
    size_t widest = 0;
    double most = -1.0;
    for (size_t i = 0; i < count; i++) {
        roberts_vec3 next = vec3_sub(corner[i + 1 < count ? i + 1 : 0], corner[i]);
        roberts_vec3 last = vec3_sub(corner[i > 0 ? i - 1 : count - 1], corner[i]);
        roberts_vec3 m = vec3_cross(next, last);
        if (vec3_dot(m, m) > most) {
            most = vec3_dot(m, m);
            widest = i;
        }
    }
    return widest;
}

/* An orthonormal frame in the plane, turned so that the corners run counter-clockwise. */
static bool orthonormal_frame(const roberts_vec3 *corner, size_t count, frame *f)
{
    roberts_vec3 size;
    if (count < 3)
        return false;
    roberts_vec3 n = area_vector(corner, count, &size);
    if (!has_area(n, size))
        return false;
    size_t k = widest_corner(corner, count);
    roberts_vec3 u = vec3_sub(corner[k + 1 < count ? k + 1 : 0], corner[k]);
    roberts_vec3 v = vec3_cross(n, u);
    f->origin = corner[k];
    f->u = vec3_scale(1.0 / vec3_length(u), u);
    f->v = vec3_scale(1.0 / vec3_length(v), v);
    return true;
}

/* The note's (alpha, beta): alpha along the side to the next corner, beta along the side to the last one. */
static bool oblique_frame(const roberts_vec3 *corner, size_t count, frame *f)
{
    roberts_vec3 size;
    if (count < 3 || !has_area(area_vector(corner, count, &size), size))
        return false;
    size_t k = widest_corner(corner, count);
    roberts_vec3 next = vec3_sub(corner[k + 1 < count ? k + 1 : 0], corner[k]);
    roberts_vec3 last = vec3_sub(corner[k > 0 ? k - 1 : count - 1], corner[k]);
    roberts_vec3 m = vec3_cross(next, last);
    f->origin = corner[k];
    f->u = vec3_scale(1.0 / vec3_dot(m, m), vec3_cross(last, m)); /* alpha = (AP x last) . m / m . m */
    f->v = vec3_scale(1.0 / vec3_dot(m, m), vec3_cross(m, next)); /* beta = (next x AP) . m / m . m */
    return true;
}

static roberts_vec2 in_frame(const frame *f, roberts_vec3 p)
{
    roberts_vec3 op = vec3_sub(p, f->origin);
    return (roberts_vec2){vec3_dot(op, f->u), vec3_dot(op, f->v)};
}

/* det(PA, PB): > 0 where P, A, B turn counter-clockwise. */
static double determinant(roberts_vec2 p, roberts_vec2 a, roberts_vec2 b)
{
    return (p.x - a.x) * (p.y - b.y) - (p.x - b.x) * (p.y - a.y);
}

/* Proposition 4 (and 5): inside where no two determinants differ in sign; 0 on the border goes with either. */
static bool signs_agree(const frame *f, const roberts_vec3 *corner, size_t count, roberts_vec3 point)
{
    roberts_vec2 p = in_frame(f, point), a = in_frame(f, corner[count - 1]);
    bool positive = false, negative = false;
    for (size_t i = 0; i < count; i++) {
        roberts_vec2 b = in_frame(f, corner[i]);
        double d = determinant(p, a, b);
        positive |= !(d <= 0.0);
        negative |= !(d >= 0.0); /* NaN is both */
        a = b;
    }
    return !(positive && negative);
}

bool roberts_inside_signs(const roberts_vec3 *corner, size_t count, roberts_vec3 p)
{
    frame f;
    return orthonormal_frame(corner, count, &f) && signs_agree(&f, corner, count, p);
}

bool roberts_inside_frame(const roberts_vec3 *corner, size_t count, roberts_vec3 p)
{
    frame f;
    return oblique_frame(corner, count, &f) && signs_agree(&f, corner, count, p);
}

/* The half-line runs toward +x. A side counts where one end is above p and the other is not (so that a corner on the
 * half-line counts once or twice, as it should, and a side along it not at all) and crosses right of p. */
bool roberts_inside_crossings(const roberts_vec3 *corner, size_t count, roberts_vec3 point)
{
    frame f;
    bool inside = false;
    if (!orthonormal_frame(corner, count, &f))
        return false;
    roberts_vec2 p = in_frame(&f, point), a = in_frame(&f, corner[count - 1]);
    for (size_t i = 0; i < count; i++) {
        roberts_vec2 b = in_frame(&f, corner[i]);
        double d = determinant(p, a, b);
        bool between = fmin(a.x, b.x) <= p.x && p.x <= fmax(a.x, b.x) && fmin(a.y, b.y) <= p.y && p.y <= fmax(a.y, b.y);
        if (d == 0.0 && between)
            return true; /* on the border */
        if ((a.y > p.y) != (b.y > p.y) && (d > 0.0) == (b.y > a.y))
            inside = !inside;
        a = b;
    }
    return inside;
}

/* Proposition 6: the angles sum up to 2 pi or -2 pi inside and to 0 outside, so pi tells them apart. atan2 takes the
 * place of the note's arccos, which loses half its digits at small angles; the sign is the note's w . n. */
bool roberts_inside_angles(const roberts_vec3 *corner, size_t count, roberts_vec3 p)
{
    const double pi = 3.14159265358979323846;
    roberts_vec3 size;
    double sum = 0.0;
    if (count < 3)
        return false;
    roberts_vec3 n = area_vector(corner, count, &size);
    if (!has_area(n, size))
        return false;
    roberts_vec3 a = vec3_sub(corner[count - 1], p);
    for (size_t i = 0; i < count; i++) {
        roberts_vec3 b = vec3_sub(corner[i], p), w = vec3_cross(a, b);
        double sine = vec3_length(w), cosine = vec3_dot(a, b);
        if (sine == 0.0 && cosine <= 0.0)
            return true; /* on a corner, or between two */
        sum += copysign(atan2(sine, cosine), vec3_dot(w, n));
        a = b;
    }
    return fabs(sum) > pi;
}

bool roberts_ray_polygon(roberts_ray ray, const roberts_vec3 *corner, size_t count, roberts_inside_fn *inside,
                         roberts_hit *hit)
{
    roberts_vec3 size;
    if (count < 3)
        return false;
    roberts_vec3 n = area_vector(corner, count, &size);
    double vn = vec3_dot(ray.direction, n);
    if (ray_parallel(vn, vec3_dot_size(ray.direction, size)))
        return false;
    double t = vec3_dot(vec3_sub(corner[0], ray.origin), n) / vn;
    if (!(t >= 0.0 && t < INFINITY) || !(inside ? inside : roberts_inside_signs)(corner, count, ray_at(ray, t)))
        return false;
    *hit = (roberts_hit){t, 0.0, 0.0, vn < 0.0 ? ROBERTS_FACING_FRONT : ROBERTS_FACING_BACK};
    return true;
}
