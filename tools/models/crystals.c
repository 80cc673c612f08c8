/* crystals.c - crystals given by their forms. A form is the set of faces that symmetry generates from one face, given
 * by its Miller indices and its distance from the centre. A crystal is the region behind all of its faces.
 *
 * Axial ratios are from E. S. Dana, "A textbook of mineralogy"; distances are chosen for the look. */
#include <stdbool.h>

#include "figures.h"

enum { PLANES_MAX = 64, CORNERS_MAX = 256 };

static const double corner_slack = 1e-9; /* for a corner on a face, in units of the crystal: far above rounding */

typedef struct half_space {
    roberts_vec3 n; /* unit vector, outward */
    double d;
} half_space;

typedef struct crystal {
    half_space face[PLANES_MAX];
    size_t face_count;
    roberts_vec3 corner[CORNERS_MAX];
    size_t corner_count;
} crystal;

/* ---- forms ----------------------------------------------------------------------------------------------------- */

static void add_plane(crystal *c, roberts_vec3 n, double d)
{
    n = vec3_scale(1 / vec3_length(n), n);
    for (size_t i = 0; i < c->face_count; i++)
        if (vec3_dot(n, c->face[i].n) > 1 - corner_slack)
            return; /* an index is 0, or two are equal */
    c->face[c->face_count++] = (half_space){n, d};
}

/* Adds the planes with all sign changes. */
static void add_signs(crystal *c, roberts_vec3 n, double d)
{
    for (int i = 0; i < 8; i++)
        add_plane(c, vec3(i & 1 ? -n.x : n.x, i & 2 ? -n.y : n.y, i & 4 ? -n.z : n.z), d);
}

/* Cubic, m-3: cyclic permutations of the axes. */
static void add_pyrite_form(crystal *c, double h, double k, double l, double d)
{
    add_signs(c, vec3(h, k, l), d);
    add_signs(c, vec3(k, l, h), d);
    add_signs(c, vec3(l, h, k), d);
}

/* Cubic, m-3m: all permutations of the axes. */
static void add_cubic_form(crystal *c, double h, double k, double l, double d)
{
    add_pyrite_form(c, h, k, l, d);
    add_pyrite_form(c, k, h, l, d);
}

/* Tetragonal, 4/mmm; `ratio` is c / a. */
static void add_tetragonal_form(crystal *c, double ratio, double h, double k, double l, double d)
{
    add_signs(c, vec3(h, k, l / ratio), d);
    add_signs(c, vec3(k, h, l / ratio), d);
}

/* Orthorhombic, mmm; axes a : 1 : c. */
static void add_rhombic_form(crystal *c, roberts_vec3 axes, roberts_vec3 hkl, double d)
{
    add_signs(c, vec3(hkl.x / axes.x, hkl.y, hkl.z / axes.z), d);
}

/* Trigonal, -3m; h k -(h + k) l, axes at 120 degrees with the first along x. Normals are on the reciprocal axes. */
static void add_trigonal_form(crystal *c, double ratio, double h, double k, double l, double d)
{
    for (int turned = 0; turned < 3; turned++) {
        double i = -h - k;
        for (int half = 0; half < 2; half++) { /* about the first axis: k and i are exchanged, l changes sign */
            double second = half ? i : k, sign = half ? -1 : 1;
            roberts_vec3 n = {h, (h + 2 * second) / sqrt(3), sign * l / ratio};
            add_plane(c, n, d);
            add_plane(c, vec3_scale(-1, n), d);
        }
        k = h;
        h = i;
    }
}

/* ---- from faces to the solid ----------------------------------------------------------------------------------- */

static bool is_inside(const crystal *c, roberts_vec3 p)
{
    for (size_t i = 0; i < c->face_count; i++)
        if (vec3_dot(c->face[i].n, p) > c->face[i].d + corner_slack)
            return false;
    return true;
}

static void add_corner(crystal *c, roberts_vec3 p)
{
    for (size_t i = 0; i < c->corner_count; i++)
        if (vec3_length(vec3_sub(c->corner[i], p)) < 10 * corner_slack)
            return;
    c->corner[c->corner_count++] = p;
}

/* Adds the point where three faces meet, if they meet in one point and no face cuts it off. */
static void find_corner(crystal *c, half_space f, half_space g, half_space h)
{
    roberts_vec3 gh = vec3_cross(g.n, h.n), hf = vec3_cross(h.n, f.n), fg = vec3_cross(f.n, g.n);
    double det = vec3_dot(f.n, gh);
    if (fabs(det) < 1e-6)
        return;
    roberts_vec3 p = vec3_add(vec3_scale(f.d, gh), vec3_add(vec3_scale(g.d, hf), vec3_scale(h.d, fg)));
    p = vec3_scale(1 / det, p);
    if (is_inside(c, p))
        add_corner(c, p);
}

/* Walks round a face, counter-clockwise seen from outside: the next corner has all others on its left. */
static void add_face(body *b, const crystal *c, half_space f, uint32_t base)
{
    size_t on[CORNERS_MAX], count = 0, at, next;
    for (size_t i = 0; i < c->corner_count; i++)
        if (fabs(vec3_dot(f.n, c->corner[i]) - f.d) < 10 * corner_slack)
            on[count++] = i;
    if (count < 3)
        return; /* other faces have cut it off */
    at = on[0];
    do {
        next = at;
        for (size_t i = 0; i < count; i++) {
            roberts_vec3 way = vec3_sub(c->corner[next], c->corner[at]), to = vec3_sub(c->corner[on[i]], c->corner[at]);
            if (on[i] != at && (next == at || vec3_dot(vec3_cross(way, to), f.n) < 0))
                next = on[i];
        }
        body_corner(b, base + (uint32_t)at);
        at = next;
    } while (at != on[0]);
    body_end_face(b);
}

/* Adds the crystal with its centre at `at`. */
static void add_crystal(body *b, crystal *c, roberts_vec3 at)
{
    uint32_t base = (uint32_t)b->vertex_count;
    for (size_t i = 0; i < c->face_count; i++)
        for (size_t j = i + 1; j < c->face_count; j++)
            for (size_t k = j + 1; k < c->face_count; k++)
                find_corner(c, c->face[i], c->face[j], c->face[k]);
    for (size_t i = 0; i < c->corner_count; i++) {
        roberts_vec3 p = vec3_add(at, c->corner[i]);
        body_vertex(b, p.x, p.y, p.z);
    }
    for (size_t i = 0; i < c->face_count; i++)
        add_face(b, c, c->face[i], base);
}

/* ---- the plate ------------------------------------------------------------------------------------------------- */

static void add_cubic_crystals(body *b, double z)
{
    crystal galena = {0}, garnet = {0}, pyrite = {0};
    add_cubic_form(&galena, 1, 0, 0, 1.5);
    add_cubic_form(&galena, 1, 1, 1, 1.75);
    add_crystal(b, &galena, vec3(0, 0, z));
    add_cubic_form(&garnet, 1, 1, 0, 1.75);
    add_cubic_form(&garnet, 2, 1, 1, 1.9375);
    add_crystal(b, &garnet, vec3(5, 0, z));
    add_pyrite_form(&pyrite, 2, 1, 0, 1.625);
    add_pyrite_form(&pyrite, 1, 0, 0, 1.6875);
    add_crystal(b, &pyrite, vec3(10, 0, z));
}

static void add_zircon(body *b, roberts_vec3 at)
{
    const double ratio = 0.64037;
    crystal c = {0};
    add_tetragonal_form(&c, ratio, 1, 0, 0, 1.25);
    add_tetragonal_form(&c, ratio, 1, 1, 1, 1.75);
    add_crystal(b, &c, at);
}

static void add_quartz(body *b, roberts_vec3 at)
{
    const double ratio = 1.09997;
    crystal c = {0};
    add_trigonal_form(&c, ratio, 1, 0, 0, 1.25);
    add_trigonal_form(&c, ratio, 1, 0, 1, 1.9375);
    add_trigonal_form(&c, ratio, 0, 1, 1, 2.125);
    add_crystal(b, &c, at);
}

static void add_calcite(body *b, roberts_vec3 at)
{
    const double ratio = 0.8543;
    crystal c = {0};
    add_trigonal_form(&c, ratio, 2, 1, 1, 1.25);
    add_trigonal_form(&c, ratio, 1, 0, 1, 2);
    add_crystal(b, &c, at);
}

static void add_topaz(body *b, roberts_vec3 at)
{
    const roberts_vec3 axes = {0.5285, 1, 0.477};
    crystal c = {0};
    add_rhombic_form(&c, axes, vec3(1, 1, 0), 1.125);
    add_rhombic_form(&c, axes, vec3(0, 2, 1), 2);
    add_rhombic_form(&c, axes, vec3(1, 1, 1), 1.875);
    add_rhombic_form(&c, axes, vec3(0, 0, 1), 2.25);
    add_crystal(b, &c, at);
}

static void add_sulphur(body *b, roberts_vec3 at)
{
    const roberts_vec3 axes = {0.8131, 1, 1.9034};
    crystal c = {0};
    add_rhombic_form(&c, axes, vec3(1, 1, 1), 1.375);
    add_rhombic_form(&c, axes, vec3(1, 1, 3), 1.75);
    add_rhombic_form(&c, axes, vec3(0, 1, 1), 1.5);
    add_rhombic_form(&c, axes, vec3(0, 0, 1), 2);
    add_crystal(b, &c, at);
}

void crystals(body *b)
{
    add_cubic_crystals(b, 6);
    add_zircon(b, vec3(15, 0, 6));
    add_quartz(b, vec3(0, 0, 0));
    add_calcite(b, vec3(5, 0, 0));
    add_topaz(b, vec3(10, 0, 0));
    add_sulphur(b, vec3(15, 0, 0));
}
