/* shapes.c - a ray against the usual shapes: segment, plane, triangle, polygon, sphere and circle, box, convex
 * polyhedron.
 *
 * The ray is S + t v with t >= 0, and v of any length but 0. Shapes are closed: a ray that only touches a shape meets
 * it. Sources are the lectures "Lancer de rayons I" [L], "Intersection entre un rayon et une boite" [B] and "Prienik
 * luca s objektami" [Z]; the README lists the formulas and their corrections.
 *
 * Invariant: NaN input gives a miss. Every comparison that accepts is written so that it fails for NaN. */
#include "base/angle.h"
#include "ray/determinant.h"

static roberts_facing facing_of(double vn)
{
    return vn < 0.0 ? ROBERTS_FACING_FRONT : ROBERTS_FACING_BACK;
}

static roberts_vec3 ray_at(roberts_ray ray, double t)
{
    return vec3_add(ray.origin, vec3_scale(t, ray.direction));
}

/* Is this a valid direction, finite and not 0? */
static bool ray_has_direction(roberts_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z) && (v.x != 0.0 || v.y != 0.0 || v.z != 0.0);
}

/* The part of a ray's line that is inside a shape, and the faces through which it enters and leaves. */
typedef struct inside_part {
    double t_in, t_out;
    uint32_t face_in, face_out;
} inside_part;

static const inside_part whole_line = {-INFINITY, INFINITY, ROBERTS_NONE, ROBERTS_NONE};

/* Fills `span` with the part and with what the ray meets first. False if the part lies behind S, or is out of range. */
static bool meet_part(inside_part in, roberts_span *span)
{
    if (!(in.t_in <= in.t_out) || !(in.t_out >= 0.0) || !(in.t_in < INFINITY))
        return false;
    if (in.t_in >= 0.0)
        *span = (roberts_span){in.t_in, in.t_out, in.t_in, ROBERTS_FACING_FRONT, in.face_in};
    else
        *span = (roberts_span){in.t_in, in.t_out, in.t_out, ROBERTS_FACING_BACK, in.face_out};
    return true;
}

/* ---- segment and plane ----------------------------------------------------------------------------------------- */

/* [L] 1.1, proposition 1: S + t v = A + alpha AB. The dot product with n (perpendicular to AB) gives t, that with m
 * (perpendicular to v) gives alpha. Since AB . m = -(v . n), one determinant serves both. */
bool roberts_ray_segment(roberts_ray2 ray, roberts_vec2 a, roberts_vec2 b, roberts_hit *hit)
{
    roberts_vec2 v = ray.direction;
    roberts_vec2 sa = {a.x - ray.origin.x, a.y - ray.origin.y};
    roberts_vec2 n = {-(b.y - a.y), b.x - a.x}; /* (AB, n) is a direct base: n points out of the visible side */
    roberts_vec2 m = {-v.y, v.x};
    double vn = v.x * n.x + v.y * n.y;
    if (ray_parallel(vn, fabs(v.x * n.x) + fabs(v.y * n.y)))
        return false;
    double t = (sa.x * n.x + sa.y * n.y) / vn;
    double alpha = (sa.x * m.x + sa.y * m.y) / vn;
    if (!(t >= 0.0 && alpha >= 0.0 && alpha <= 1.0 && t < INFINITY))
        return false;
    *hit = (roberts_hit){t, alpha, 0.0, facing_of(vn)};
    return true;
}

/* [L] 1.2, proposition 2. */
bool roberts_ray_plane(roberts_ray ray, roberts_plane F, roberts_hit *hit)
{
    roberts_vec3 n = {F.a, F.b, F.c};
    double vn = vec3_dot(ray.direction, n);
    if (ray_parallel(vn, vec3_dot_size(ray.direction, n)))
        return false;
    double t = -plane_at(F, ray.origin) / vn;
    if (!(t >= 0.0 && t < INFINITY))
        return false;
    *hit = (roberts_hit){t, 0.0, 0.0, facing_of(vn)};
    return true;
}

/* ---- triangle -------------------------------------------------------------------------------------------------- */

/* Three solutions of S + t v = A + alpha AB + beta AC. They agree on the determinant (v . n with n = AB x AC, up to its
 * sign), on when it is too small (relative to its six terms), and on what is met: alpha >= 0, beta >= 0, alpha + beta
 * <= 1, t >= 0. */
static bool hit_triangle(double t, double alpha, double beta, double vn, roberts_hit *hit)
{
    if (!(t >= 0.0 && alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0 && t < INFINITY))
        return false;
    *hit = (roberts_hit){t, alpha, beta, facing_of(vn)};
    return true;
}

/* [L] 1.3, proposition 3; the numerator of beta has . v, as in its proof (correction 1). */
bool roberts_ray_triangle(roberts_ray ray, roberts_vec3 a, roberts_vec3 b, roberts_vec3 c, roberts_hit *hit)
{
    roberts_vec3 v = ray.direction, sa = vec3_sub(a, ray.origin);
    roberts_vec3 ab = vec3_sub(b, a), ac = vec3_sub(c, a), n = vec3_cross(ab, ac);
    double vn = vec3_dot(v, n);
    if (ray_parallel(vn, vec3_triple_size(ab, ac, v)))
        return false;
    double t = vec3_dot(sa, n) / vn;
    double alpha = -vec3_dot(vec3_cross(sa, ac), v) / vn;
    double beta = vec3_dot(vec3_cross(sa, ab), v) / vn;
    return hit_triangle(t, alpha, beta, vn, hit);
}

/* [Z], Moeller-Trumbore, with the letters of the note: its a = e1 . (d x e2) is -(v . n). Correction 2: a is compared
 * relative to its terms, not with 0. */
bool roberts_ray_triangle_mt(roberts_ray ray, roberts_vec3 a, roberts_vec3 b, roberts_vec3 c, roberts_hit *hit)
{
    roberts_vec3 d = ray.direction, e1 = vec3_sub(b, a), e2 = vec3_sub(c, a);
    roberts_vec3 h = vec3_cross(d, e2);
    double determinant = vec3_dot(e1, h);
    if (ray_parallel(determinant, vec3_triple_size(d, e2, e1)))
        return false;
    double f = 1.0 / determinant;
    roberts_vec3 s = vec3_sub(ray.origin, a);
    double u = f * vec3_dot(s, h);
    if (!(u >= 0.0 && u <= 1.0))
        return false;
    roberts_vec3 q = vec3_cross(s, e1);
    return hit_triangle(f * vec3_dot(e2, q), u, f * vec3_dot(d, q), -determinant, hit);
}

/* [Z]: first P in the plane, then w = P - V0 in the base (u, v) of the sides, where v is the side V2 - V0 and not the
 * ray (correction 1). */
bool roberts_ray_triangle_barycentric(roberts_ray ray, roberts_vec3 a, roberts_vec3 b, roberts_vec3 c, roberts_hit *hit)
{
    roberts_vec3 u = vec3_sub(b, a), v = vec3_sub(c, a), n = vec3_cross(u, v);
    double dn = vec3_dot(ray.direction, n);
    if (ray_parallel(dn, vec3_triple_size(u, v, ray.direction)))
        return false;
    double r = vec3_dot(n, vec3_sub(a, ray.origin)) / dn;
    roberts_vec3 w = vec3_sub(ray_at(ray, r), a);
    double uu = vec3_dot(u, u), uv = vec3_dot(u, v), vv = vec3_dot(v, v), wu = vec3_dot(w, u), wv = vec3_dot(w, v);
    double gram = uv * uv - vv * uu; /* -(n . n) */
    return hit_triangle(r, (uv * wv - vv * wu) / gram, (uv * wu - uu * wv) / gram, dn, hit);
}

/* ---- polygon --------------------------------------------------------------------------------------------------- */

/* The note leaves out points on the border; here they are inside. The frame of the plane is at the corner whose two
 * sides span the largest triangle, because the note's A1 may be collinear with its neighbours.
 *
 * P = O + x u' + y v'; `u` and `v` are the dual base, whose dot products with P - O give x and y. */
typedef struct frame {
    roberts_vec3 origin, u, v;
} frame;

/* Returns the polygon's area vector, of length twice its area, by Newell. Every corner counts, and collinear corners do
 * no harm. `size` is the sum of the absolute terms, component by component. */
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
    *size = s;
    return n;
}

/* Is the polygon's area more than rounding? Without area it has no inside. Sets `n` to its area vector. */
static bool has_area(const roberts_vec3 *corner, size_t count, roberts_vec3 *n)
{
    roberts_vec3 size;
    if (count < 3)
        return false;
    *n = area_vector(corner, count, &size);
    return !ray_parallel(n->x, size.x) || !ray_parallel(n->y, size.y) || !ray_parallel(n->z, size.z);
}

/* Returns the corner whose sides span the largest triangle (the first of equal ones). */
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

/* Makes an orthonormal frame in the plane, oriented so that the corners run counter-clockwise. */
static bool orthonormal_frame(const roberts_vec3 *corner, size_t count, frame *f)
{
    roberts_vec3 n;
    if (!has_area(corner, count, &n))
        return false;
    size_t k = widest_corner(corner, count);
    roberts_vec3 u = vec3_sub(corner[k + 1 < count ? k + 1 : 0], corner[k]);
    roberts_vec3 v = vec3_cross(n, u);
    f->origin = corner[k];
    f->u = vec3_scale(1.0 / vec3_length(u), u);
    f->v = vec3_scale(1.0 / vec3_length(v), v);
    return true;
}

/* Makes the frame of the note's (alpha, beta): alpha along the side to the next corner, beta along the side to the last
 * one. */
static bool oblique_frame(const roberts_vec3 *corner, size_t count, frame *f)
{
    roberts_vec3 n;
    if (!has_area(corner, count, &n))
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

/* Returns det(PA, PB): > 0 if P, A, B turn counter-clockwise. */
static double determinant(roberts_vec2 p, roberts_vec2 a, roberts_vec2 b)
{
    return (p.x - a.x) * (p.y - b.y) - (p.x - b.x) * (p.y - a.y);
}

/* Proposition 4 (and 5): a point is inside if no two determinants differ in sign; 0, on the border, agrees with
 * either. */
static bool signs_agree(const frame *f, const roberts_vec3 *corner, size_t count, roberts_vec3 point)
{
    roberts_vec2 p = in_frame(f, point), a = in_frame(f, corner[count - 1]);
    bool positive = false, negative = false;
    for (size_t i = 0; i < count; i++) {
        roberts_vec2 b = in_frame(f, corner[i]);
        double d = determinant(p, a, b);
        positive |= !(d <= 0.0);
        negative |= !(d >= 0.0); /* NaN counts as both */
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

/* The half-line runs toward +x. A side counts if exactly one of its ends is above p and it crosses right of p. So a
 * corner on the half-line counts once or twice, as it should, and a side along it not at all. */
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

/* Proposition 6: the angles add up to 2 pi or -2 pi inside and to 0 outside, so pi separates the cases. atan2 replaces
 * the note's arccos, which loses half its digits at small angles; the sign is the note's w . n. */
bool roberts_inside_angles(const roberts_vec3 *corner, size_t count, roberts_vec3 p)
{
    roberts_vec3 n;
    double sum = 0.0;
    if (!has_area(corner, count, &n))
        return false;
    roberts_vec3 a = vec3_sub(corner[count - 1], p);
    for (size_t i = 0; i < count; i++) {
        roberts_vec3 b = vec3_sub(corner[i], p), w = vec3_cross(a, b);
        double sine = vec3_length(w), cosine = vec3_dot(a, b);
        if (sine == 0.0 && cosine <= 0.0)
            return true; /* on a corner, or on a side */
        sum += copysign(atan2(sine, cosine), vec3_dot(w, n));
        a = b;
    }
    return fabs(sum) > PI;
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
    *hit = (roberts_hit){t, 0.0, 0.0, facing_of(vn)};
    return true;
}

/* ---- sphere and circle ----------------------------------------------------------------------------------------- */

/* [L] 2.1 to 2.3. The note takes v of length 1; here v has any length, with a = v . v (the note's exercise: the
 * decision needs no square root). A tangent touches at t_in = t_out. A negative radius is an empty sphere, radius 0 a
 * point.
 *
 * a t^2 + 2 B t + C = 0 with B = v . OS, C = OS^2 - R^2 and the reduced discriminant B^2 - a C (proposition 7;
 * correction 2: C, not C^2). The root of larger size is computed from a sum without cancellation, the other from their
 * product C / a. */
bool roberts_ray_sphere(roberts_ray ray, roberts_vec3 centre, double radius, roberts_span *span)
{
    roberts_vec3 v = ray.direction, os = vec3_sub(ray.origin, centre);
    double a = vec3_dot(v, v), b = vec3_dot(v, os), c = vec3_dot(os, os) - radius * radius;
    double discriminant = b * b - a * c;
    if (!(a > 0.0 && a < INFINITY && radius >= 0.0 && discriminant >= 0.0))
        return false;
    double q = -(b + copysign(sqrt(discriminant), b));
    double t0 = q / a, t1 = q != 0.0 ? c / q : t0; /* q = 0: both roots are 0 */
    return meet_part((inside_part){fmin(t0, t1), fmax(t0, t1), ROBERTS_NONE, ROBERTS_NONE}, span);
}

/* H = S + t_H v is the foot of the perpendicular from O, and d = OH (proposition 8). The note's d^2 = SO^2 - (SO . v)^2
 * loses all digits if S is far from O. The square of O - H is the same number and keeps them. */
bool roberts_ray_sphere_geometric(roberts_ray ray, roberts_vec3 centre, double radius, roberts_span *span)
{
    roberts_vec3 v = ray.direction, so = vec3_sub(centre, ray.origin);
    double a = vec3_dot(v, v), t_h = vec3_dot(so, v) / a;
    roberts_vec3 ho = vec3_sub(so, vec3_scale(t_h, v));
    double h2 = radius * radius - vec3_dot(ho, ho);
    if (!(a > 0.0 && a < INFINITY && radius >= 0.0 && h2 >= 0.0))
        return false;
    double h = sqrt(h2 / a);
    return meet_part((inside_part){t_h - h, t_h + h, ROBERTS_NONE, ROBERTS_NONE}, span);
}

/* The sphere's geometric form without z. */
bool roberts_ray_circle(roberts_ray2 ray, roberts_vec2 centre, double radius, roberts_span *span)
{
    roberts_ray flat = {{ray.origin.x, ray.origin.y, 0.0}, {ray.direction.x, ray.direction.y, 0.0}};
    return roberts_ray_sphere_geometric(flat, (roberts_vec3){centre.x, centre.y, 0.0}, radius, span);
}

/* ---- box ------------------------------------------------------------------------------------------------------- */

/* A box is the intersection of the slabs of its axes: [L] 3, [B]. Clips `line` to p <= s + t v <= q, or to q <= ... <=
 * p, on `axis`. If v = 0, the line runs along the slab and is inside it for all t or for none (the notes skip the axis
 * or divide by zero: corrections 3 and 1). */
static bool clip_slab(inside_part *line, uint32_t axis, double p, double q, double s, double v)
{
    double lo = fmin(p, q), hi = fmax(p, q);
    if (v == 0.0)
        return lo <= s && s <= hi;
    bool up = v > 0.0;
    double t_in = ((up ? lo : hi) - s) / v, t_out = ((up ? hi : lo) - s) / v;
    if (!(t_in <= t_out))
        return false; /* NaN */
    if (t_in > line->t_in) {
        line->t_in = t_in;
        line->face_in = 2 * axis + (up ? 0 : 1);
    }
    if (t_out < line->t_out) {
        line->t_out = t_out;
        line->face_out = 2 * axis + (up ? 1 : 0);
    }
    return line->t_in <= line->t_out;
}

bool roberts_ray_box2(roberts_ray2 ray, roberts_vec2 a, roberts_vec2 b, roberts_span *span)
{
    roberts_vec2 s = ray.origin, v = ray.direction;
    inside_part line = whole_line;
    return ray_has_direction((roberts_vec3){v.x, v.y, 0.0}) && clip_slab(&line, 0, a.x, b.x, s.x, v.x) &&
           clip_slab(&line, 1, a.y, b.y, s.y, v.y) && meet_part(line, span);
}

bool roberts_ray_box(roberts_ray ray, roberts_vec3 a, roberts_vec3 b, roberts_span *span)
{
    roberts_vec3 s = ray.origin, v = ray.direction;
    inside_part line = whole_line;
    return ray_has_direction(v) && clip_slab(&line, 0, a.x, b.x, s.x, v.x) && clip_slab(&line, 1, a.y, b.y, s.y, v.y) &&
           clip_slab(&line, 2, a.z, b.z, s.z, v.z) && meet_part(line, span);
}

/* ---- convex polyhedron ----------------------------------------------------------------------------------------- */

/* Clips the line by one half-space after the other (Cyrus and Beck). Along the ray F is F(S) + t (v . n): the line
 * enters through a plane with v . n > 0, and leaves through one with v . n < 0. A plane parallel to the ray keeps all
 * of it if S is inside or on the plane, otherwise nothing. */
bool roberts_ray_polyhedron(roberts_ray ray, const roberts_plane *F, size_t count, roberts_span *span)
{
    inside_part line = whole_line;
    if (!ray_has_direction(ray.direction))
        return false;
    for (size_t i = 0; i < count; i++) {
        roberts_vec3 n = {F[i].a, F[i].b, F[i].c};
        double vn = vec3_dot(ray.direction, n), inside = plane_at(F[i], ray.origin), t = -inside / vn;
        if (ray_parallel(vn, vec3_dot_size(ray.direction, n))) {
            if (!(inside >= 0.0))
                return false;
        } else if (!isfinite(t)) {
            return false;
        } else if (vn > 0.0 && t > line.t_in) {
            line.t_in = t;
            line.face_in = (uint32_t)i;
        } else if (vn < 0.0 && t < line.t_out) {
            line.t_out = t;
            line.face_out = (uint32_t)i;
        }
    }
    return meet_part(line, span);
}
