/* rays.cpp - the definition of "hidden", applied literally in rational numbers: one ray against every triangle. It
 * shares no line with oracle.cpp, so that each can find the other's mistakes. */
#include "oracle.h"

#include <array>
#include <map>
#include <vector>

#include <CGAL/Exact_rational.h>

namespace
{

using number = CGAL::Exact_rational;
using point = std::array<number, 3>;

point minus(const point &p, const point &q)
{
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

number det(const point &a, const point &b, const point &c)
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

struct scene {
    const roberts_mesh &mesh;
    const uint32_t *vertex_solid;

    point at(uint32_t v) const
    {
        return {number(mesh.vertex[v].x), number(mesh.vertex[v].y), number(mesh.vertex[v].z)};
    }

    /* Sign of det(b - a, c - a, inside - a) for a point inside the solid: the side of abc on which the solid lies. */
    int solid_side(const point &a, const point &b, const point &c, uint32_t solid) const
    {
        number sum(0);
        for (uint32_t v = 0; v < mesh.vertex_count; v++)
            if (vertex_solid[v] == solid)
                sum += det(minus(b, a), minus(c, a), minus(at(v), a));
        return sum > 0 ? 1 : sum < 0 ? -1 : 0;
    }
};

/* The first corner of a face that is not in line with its first two. */
point third_corner(const scene &s, size_t f)
{
    const uint32_t *corner = s.mesh.corner + s.mesh.face_start[f];
    point p = s.at(corner[0]), pq = minus(s.at(corner[1]), p);
    uint32_t k = 2, last = s.mesh.face_start[f + 1] - s.mesh.face_start[f] - 1;
    for (; k < last; k++) {
        point pt = minus(s.at(corner[k]), p);
        if (pq[0] * pt[1] != pq[1] * pt[0] || pq[1] * pt[2] != pq[2] * pt[1] || pq[2] * pt[0] != pq[0] * pt[2])
            break;
    }
    return s.at(corner[k]);
}

/* A front face met by a ray, as X + r dir; n.(Y - a) = 0 is its plane. */
struct hit {
    uint32_t solid;
    number r;
    point a, n;
};

struct ray {
    point X, dir;
};

number dot(const point &a, const point &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* All front faces that the ray from X meets at r >= 0. */
std::vector<hit> cast(const scene &s, const point &X, const point &dir)
{
    std::vector<hit> hits;
    for (size_t f = 0; f < s.mesh.face_count; f++) {
        const uint32_t *corner = s.mesh.corner + s.mesh.face_start[f];
        for (uint32_t i = 1; i + 1 < s.mesh.face_start[f + 1] - s.mesh.face_start[f]; i++) {
            uint32_t solid = s.vertex_solid[corner[0]];
            point a = s.at(corner[0]), b = s.at(corner[i]), c = s.at(corner[i + 1]);
            point ab = minus(b, a), ac = minus(c, a), aX = minus(X, a);
            number slope = det(ab, ac, dir), height = det(ab, ac, aX);
            if (slope == 0) /* edge-on (or no triangle) */
                continue;
            number r = -height / slope; /* X + r dir lies in the plane */
            if (r < 0)
                continue;
            point Y{aX[0] + r * dir[0], aX[1] + r * dir[1], aX[2] + r * dir[2]};
            point n{ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0]};
            number whole = det(n, ab, ac), u = det(n, Y, ac) / whole, v = det(n, ab, Y) / whole;
            if (u < 0 || v < 0 || u + v > 1) /* Y = u ab + v ac: outside the triangle */
                continue;
            int side = s.solid_side(a, b, c, solid);
            if ((slope > 0) == (side > 0)) /* the solid lies on the viewer's side: a back face */
                continue;
            hits.push_back({solid, r, a, n});
        }
    }
    return hits;
}

/* Drops the hits that a near plane cuts off, and adds those on the sections with which it closes the solids: the ray
 * passes through the plane within a solid that has a corner beyond it. */
std::vector<hit> cut(const scene &s, const oracle_view &view, const ray &ray, const std::vector<hit> &hits)
{
    std::vector<hit> left;
    point a{number(view.near.x), number(view.near.y), number(view.near.z)};
    point viewer{number(view.x), number(view.y), number(view.z)};
    point n = minus(view.w ? a : point{0, 0, 0}, viewer);
    number r = dot(n, minus(a, ray.X)) / dot(n, ray.dir);
    point C{ray.X[0] + r * ray.dir[0], ray.X[1] + r * ray.dir[1], ray.X[2] + r * ray.dir[2]};
    std::map<uint32_t, bool> within; /* is C in the rest of the solid? */
    for (const hit &h : hits)
        if (h.r <= r)
            left.push_back(h);
    for (uint32_t v = 0; v < s.mesh.vertex_count; v++)
        if (s.vertex_solid[v] != ROBERTS_NONE && dot(n, minus(s.at(v), a)) > 0)
            within[s.vertex_solid[v]] = true;
    for (size_t f = 0; f < s.mesh.face_count; f++) {
        const uint32_t *corner = s.mesh.corner + s.mesh.face_start[f];
        uint32_t solid = s.vertex_solid[corner[0]];
        point p = s.at(corner[0]), q = s.at(corner[1]), t = third_corner(s, f);
        number side = det(minus(q, p), minus(t, p), minus(C, p));
        if (side != 0 && (side > 0 ? 1 : -1) != s.solid_side(p, q, t, solid))
            within[solid] = false;
    }
    for (const auto &[solid, is_within] : within)
        if (is_within)
            left.push_back({solid, r, a, n});
    return left;
}

ray toward_viewer(const scene &s, const oracle_point &from)
{
    const oracle_view &view = *from.view;
    point p = s.at(from.v0), q = s.at(from.v1), viewer{number(view.x), number(view.y), number(view.z)};
    point X{number(from.aside.x), number(from.aside.y), number(from.aside.z)};
    for (int i = 0; i < 3; i++)
        X[i] += p[i] + number(from.t) * (q[i] - p[i]);
    return {X, view.w ? minus(viewer, X) : viewer};
}

std::vector<hit> seen_along(const scene &s, const oracle_view &view, const ray &ray)
{
    std::vector<hit> hits = cast(s, ray.X, ray.dir);
    return view.cut ? cut(s, view, ray, hits) : hits;
}

} // namespace

bool oracle_point_hidden(const oracle_point *from)
{
    scene s{*from->mesh, from->vertex_solid};
    ray ray = toward_viewer(s, *from);
    for (const hit &h : seen_along(s, *from->view, ray))
        if (h.r > 0 && h.solid != from->vertex_solid[from->v0])
            return true;
    return false;
}

bool oracle_point_seen(const oracle_point *from, double touch, uint32_t by, uint32_t *seen)
{
    scene s{*from->mesh, from->vertex_solid};
    ray ray = toward_viewer(s, *from);
    std::vector<hit> hits = seen_along(s, *from->view, ray);
    number nearest(-1);
    *seen = ROBERTS_NONE;
    for (const hit &h : hits)
        if (h.r > nearest || (h.r == nearest && h.solid < *seen)) {
            nearest = h.r;
            *seen = h.solid;
        }
    for (const hit &h : hits) {
        point Y{ray.X[0] + nearest * ray.dir[0], ray.X[1] + nearest * ray.dir[1], ray.X[2] + nearest * ray.dir[2]};
        point d = minus(Y, h.a);
        number height = h.n[0] * d[0] + h.n[1] * d[1] + h.n[2] * d[2];
        number square = h.n[0] * h.n[0] + h.n[1] * h.n[1] + h.n[2] * h.n[2];
        if (h.solid == by && height * height <= number(touch) * number(touch) * square)
            return true;
    }
    return *seen == by;
}
