/* box.c - ray against a box with sides along the axes: "Lancer de rayons I", 3, and "Intersection entre un rayon et
 * une boite": the box is what the slabs of the axes have in common. */
#include "ray/ray.h"

/* The part of the line in all slabs so far, and the sides where it enters and leaves. */
typedef struct slabs {
    double t_in, t_out;
    uint32_t face_in, face_out;
} slabs;

static slabs whole_line(void)
{
    return (slabs){-INFINITY, INFINITY, ROBERTS_NONE, ROBERTS_NONE};
}

/* Cuts `line` with lo <= s + t v <= hi on `axis`. Where v = 0 the line runs along the slab: inside it for all t or for
 * none (the notes skip the axis or divide by zero: corrections 3 and 1). */
static bool clip_slab(slabs *line, uint32_t axis, double p, double q, double s, double v)
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
    slabs line = whole_line();
    return ray_has_direction((roberts_vec3){v.x, v.y, 0.0}) && clip_slab(&line, 0, a.x, b.x, s.x, v.x) &&
           clip_slab(&line, 1, a.y, b.y, s.y, v.y) &&
           ray_span(line.t_in, line.face_in, line.t_out, line.face_out, span);
}

bool roberts_ray_box(roberts_ray ray, roberts_vec3 a, roberts_vec3 b, roberts_span *span)
{
    roberts_vec3 s = ray.origin, v = ray.direction;
    slabs line = whole_line();
    return ray_has_direction(v) && clip_slab(&line, 0, a.x, b.x, s.x, v.x) && clip_slab(&line, 1, a.y, b.y, s.y, v.y) &&
           clip_slab(&line, 2, a.z, b.z, s.z, v.z) &&
           ray_span(line.t_in, line.face_in, line.t_out, line.face_out, span);
}
