/* star_bodies.c - see star_bodies.h.
 *
 * Let o be a point, and let det(a - o, b - o, c - o) have one sign for all triangles abc of a closed body whose faces
 * are wound alike. Seen from o, they are triangles of a sphere, all turned the same way. The two faces of an edge lie
 * on different sides of it, so equally many triangles are seen in all directions. If one direction meets one triangle,
 * all do: the triangles divide the sphere, and have only corners and sides in common.
 *
 * Moreover, faces without a common corner are apart. Let D be the size of the body; no corner is farther than D from o.
 * Let no plane be nearer to o than D / FLATTEST, and no determinant less than m. On the sphere, the shortest way from
 * one such face to the other begins or ends in a corner a, and passes through a triangle abc to the side bc. So its
 * sine is at least that of the height of abc over bc, det / (|a| |b x c|) >= m / D^3. The faces are farther apart than
 * D / FLATTEST times that sine (or than D / FLATTEST, if the way is longer than 90 degrees). */
#include "hide/star_bodies.h"

#include "base/bits.h"
#include "model/face_plane.h"

/* Where o is in the body's box. From there, regular bodies have no edge in the direction +x. */
static const roberts_vec3 star_centre = {0.4771, 0.5137, 0.4936};

/* If the plane of a face is nearer to o than the body's size divided by this, nothing is certain. */
#define FLATTEST 64.0
/* Touching distances: faces without a common corner are farther apart than half of this. */
#define STAR_APART 16.0
/* D^3: the error of a determinant is 8 half epsilons of the sum of six products of three differences, each at most D.
 * The margin is more than five times that, so rounding takes less than half off the distance of faces. */
#define DETERMINANT_ERROR 0x1p-45
/* D^2: the error of a turn about the direction +x is 4 half epsilons of the sum of two products of two differences. */
#define TURN_ERROR 0x1p-49
/* Model units: the sixth powers of sizes between these stay in range. */
#define SIZE_LEAST 0x1p-150
#define SIZE_MOST 0x1p150

typedef struct star {
    roberts_vec3 o;
    double sense; /* 1 or -1: the sign of all determinants */
    double least; /* of their sizes */
    double slope; /* square of the least distance of a plane from o */
    double turn;  /* a greater turn has a sure sign */
} star;

/* Does the direction +x from o surely miss a triangle? */
static bool is_missed(const star *s, const roberts_scene *scene, const uint32_t corner[3])
{
    roberts_vec3 p = vec3_sub(scene->point[corner[2]], s->o);
    for (int i = 0; i < 3; i++) {
        roberts_vec3 q = vec3_sub(scene->point[corner[i]], s->o);
        if (s->sense * (p.y * q.z - p.z * q.y) < -s->turn)
            return true;
        p = q;
    }
    return false;
}

/* Which of two triangles are on both sides of a plane through o, by their corners' coordinates along one axis? */
BITS_INLINE unsigned on_both_sides(two a, two b, two c, two o)
{
    return two_at_most(two_lesser(two_lesser(a, b), c), o) & two_at_most(o, two_greater(two_greater(a, b), c));
}

/* Do all triangles show o the same side, plainly, and may the direction +x meet no more than one? Two are taken at a
 * time; the last one may be taken twice. */
static BITS_PER_PROCESSOR bool is_seen_once(const star *s, const roberts_scene *scene, const uint32_t *corner,
                                            uint32_t count)
{
    const roberts_vec3 *P = scene->point;
    const two_vec3 o = two_vec3_all(s->o);
    const two sense = two_all(s->sense), least = two_all(s->least), slope = two_all(s->slope);
    uint32_t met = 0;
    for (uint32_t f = 0; f < count; f += 2) {
        const uint32_t *p = corner + 3 * (size_t)f, *q = f + 1 < count ? p + 3 : p;
        const two_vec3 a = two_vec3_of(&P[p[0]], &P[q[0]]), b = two_vec3_of(&P[p[1]], &P[q[1]]),
                       c = two_vec3_of(&P[p[2]], &P[q[2]]);
        const two_vec3 n = two_vec3_cross(two_vec3_sub(b, a), two_vec3_sub(c, a));
        const two det = two_mul(sense, two_vec3_dot(n, two_vec3_sub(a, o)));
        if (two_at_most(det, least) | two_at_most(two_mul(det, det), two_mul(slope, two_square(n))))
            return false;
        const unsigned near = on_both_sides(a.y, b.y, c.y, o.y) & on_both_sides(a.z, b.z, c.z, o.z);
        if (near && q > p)
            met += (near & 1 && !is_missed(s, scene, p)) + (near & 2 && !is_missed(s, scene, q));
        else if (near)
            met += !is_missed(s, scene, p);
    }
    return met <= 1;
}

unsigned char star_body_rear(const roberts_scene *scene, uint32_t body, const box3 *box, double touching)
{
    const scene_solid *own = &scene->solid[body];
    const uint32_t *corner = scene->corner + scene->face_start[own->face];
    const roberts_vec3 size = vec3_sub(box->hi, box->lo);
    const double D = greater(size.x, greater(size.y, size.z));
    if (!(D > SIZE_LEAST && D < SIZE_MOST))
        return VIEW_UNKNOWN;
    star s = {.least = DETERMINANT_ERROR * D * D * D + FLATTEST * STAR_APART * touching * D * D,
              .slope = D / FLATTEST * (D / FLATTEST),
              .turn = TURN_ERROR * D * D};
    s.o = vec3_add(box->lo, (roberts_vec3){star_centre.x * size.x, star_centre.y * size.y, star_centre.z * size.z});
    const roberts_vec3 a = vec3_sub(scene->point[corner[0]], s.o), b = vec3_sub(scene->point[corner[1]], s.o),
                       c = vec3_sub(scene->point[corner[2]], s.o);
    s.sense = vec3_dot(vec3_cross(a, b), c) < 0.0 ? -1.0 : 1.0;
    if (!is_seen_once(&s, scene, corner, own[1].face - own->face))
        return VIEW_UNKNOWN;
    return s.sense > 0.0 ? VIEW_BACK : VIEW_FRONT; /* > 0: wound counter-clockwise, seen from outside */
}
