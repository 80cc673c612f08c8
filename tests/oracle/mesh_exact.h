/* mesh_exact.h - shared by the exact judges of any mesh (C++): its faces, their pictures, and what a face hides.
 * Everything is decided in the picture. Points are projected exactly. A segment is cut where it crosses the line of a
 * side and where it pierces the plane. Each open part between two cuts is tested at its middle. */
#ifndef ROBERTS_TESTS_MESH_EXACT_H
#define ROBERTS_TESTS_MESH_EXACT_H

#include "exact.h"
#include "oracle.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace
{

/* Fraction of the face's size: how far a corner may be from its face's plane. */
const double PLANAR = 1e-5;

template <class N> struct point2 {
    N x, y, w; /* w: depth of the point from the eye along the axis; 1 for a viewer at infinity */
};

/* A face with no corner repeated directly, given by positions. */
struct polygon {
    uint32_t number; /* in the mesh */
    std::vector<uint32_t> corner;
    std::vector<std::array<uint32_t, 2>> side; /* without those that run both ways */
    double x0, x1, y0, y1;                     /* box of its picture, with a margin */
    /* Two corners that form a triangle with the first one. Used if parts of the face with opposite orientation have
     * equal areas: then Newell's normal is 0 or mere rounding. Otherwise 0. */
    uint32_t second, third;
    int facing; /* 1: its normal points toward the viewer, -1: away; 0: edge-on */
    /* Twice the area vector, and the sum of the corners */
    vec<interval> near_normal, near_sum;
    vec<rational> normal, sum;
};

/* A point of a line, and its picture. */
struct spot {
    vec<interval> near;
    vec<rational> at;
    point2<interval> near_flat;
    point2<rational> flat;
    uint32_t vertex; /* ROBERTS_NONE: not a vertex */

    const vec<interval> &space(interval) const
    {
        return near;
    }

    const vec<rational> &space(rational) const
    {
        return at;
    }

    const point2<interval> &picture(interval) const
    {
        return near_flat;
    }

    const point2<rational> &picture(rational) const
    {
        return flat;
    }
};

struct mesh_oracle {
    const roberts_mesh &mesh;
    oracle_view view;
    bool even_odd;
    std::vector<uint32_t> position;
    std::vector<vec<rational>> place; /* [vertex] */
    std::vector<polygon> faces;
    std::map<std::array<uint32_t, 2>, std::vector<size_t>> edges; /* faces of each edge */
    roberts_vec3 U{}, W{}, D{};                                   /* axes of the picture: any independent ones */
    std::vector<point2<interval>> flat;                           /* [vertex] */
    std::vector<point2<rational>> flat_exact;
    double margin = 0;
    size_t pairs = 0, exact = 0;

    mesh_oracle(const roberts_mesh &m, const oracle_view &v, bool odd) : mesh(m), view(v), even_odd(odd)
    {
        if (view.cut)
            throw std::runtime_error("a near plane is not asked for here");
        weld();
        take_faces();
        frame();
        for (polygon &f : faces) {
            box_face(f);
            f.facing = exactly(false, &exact, [&](auto zero) { return facing_of<decltype(zero)>(f); });
        }
        exact = 0;
    }

    /* ---- the mesh ---- */

    void weld()
    {
        std::map<std::tuple<double, double, double>, uint32_t> at;
        for (uint32_t i = 0; i < mesh.vertex_count; i++) {
            const roberts_vec3 &p = mesh.vertex[i]; /* -0 is 0 */
            position.push_back(at.emplace(std::make_tuple(p.x + 0.0, p.y + 0.0, p.z + 0.0), i).first->second);
            place.push_back({rational(p.x), rational(p.y), rational(p.z)});
        }
    }

    void take_faces()
    {
        for (size_t f = 0; f < mesh.face_count; f++) {
            polygon face{};
            face.number = (uint32_t)f;
            for (uint32_t i = mesh.face_start[f]; i < mesh.face_start[f + 1]; i++)
                if (face.corner.empty() || face.corner.back() != position[mesh.corner[i]])
                    face.corner.push_back(position[mesh.corner[i]]);
            while (face.corner.size() > 1 && face.corner.front() == face.corner.back())
                face.corner.pop_back();
            std::vector<uint32_t> distinct(face.corner);
            std::sort(distinct.begin(), distinct.end());
            distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
            if (distinct.size() < 3)
                continue;
            size_t n = face.corner.size();
            for (size_t i = 0; i < n; i++) {
                uint32_t p = face.corner[i], q = face.corner[(i + 1) % n];
                std::vector<size_t> &of = edges[{std::min(p, q), std::max(p, q)}];
                if (of.empty() || of.back() != faces.size())
                    of.push_back(faces.size());
            }
            take_sides(face, distinct);
            take_plane(face);
            faces.push_back(face);
        }
        if (faces.empty())
            throw std::runtime_error("no face");
    }

    /* Lists the sides, cut at the face's own corners, but for stretches that the border runs along both ways. */
    void take_sides(polygon &face, const std::vector<uint32_t> &corners) const
    {
        std::map<std::array<uint32_t, 2>, int> runs;
        for (size_t i = 0; i < face.corner.size(); i++) {
            uint32_t p = face.corner[i], q = face.corner[(i + 1) % face.corner.size()];
            std::vector<uint32_t> stop{p, q};
            for (uint32_t v : corners)
                if (lies_between(p, q, v))
                    stop.push_back(v);
            if (stop.size() > 2) {
                const vec<rational> d = minus(place[q], place[p]);
                std::sort(stop.begin(), stop.end(),
                          [&](uint32_t a, uint32_t b) { return dot(d, minus(place[a], place[b])) < 0; });
            }
            for (size_t k = 1; k < stop.size(); k++)
                runs[{std::min(stop[k - 1], stop[k]), std::max(stop[k - 1], stop[k])}] +=
                    stop[k - 1] < stop[k] ? 1 : -1;
        }
        for (auto &[key, net] : runs)
            for (int k = 0; k < std::abs(net); k++)
                face.side.push_back(net > 0 ? key : std::array<uint32_t, 2>{key[1], key[0]});
    }

    /* Does v lie on the side from p to q, between its ends? */
    bool lies_between(uint32_t p, uint32_t q, uint32_t v) const
    {
        const roberts_vec3 &P = mesh.vertex[p], &Q = mesh.vertex[q], &V = mesh.vertex[v];
        const double dx = Q.x - P.x, dy = Q.y - P.y, dz = Q.z - P.z, x = V.x - P.x, y = V.y - P.y, z = V.z - P.z;
        const double size =
            (std::fabs(dx) + std::fabs(dy) + std::fabs(dz)) * (std::fabs(x) + std::fabs(y) + std::fabs(z));
        if (v == p || v == q || std::fabs(dx * y - dy * x) + std::fabs(dy * z - dz * y) > 1e-9 * size)
            return false;
        const vec<rational> d = minus(place[q], place[p]), e = minus(place[v], place[p]), c = cross(d, e);
        return c.x == 0 && c.y == 0 && c.z == 0 && dot(d, e) > 0 && dot(d, e) < dot(d, d);
    }

    /* Chooses the corners that the face's plane is taken from, and computes the plane. */
    void take_plane(polygon &f) const
    {
        if (is_plain(f)) {
            f.normal = newell<rational>(f);
            f.sum = corner_sum<rational>(f);
            return;
        }
        const vec<rational> &o = place[f.corner[0]];
        double largest = 0, sum = size_of(newell<rational>(f));
        uint32_t second = 0, third = 0;
        for (uint32_t p : f.corner)
            for (uint32_t q : f.corner) {
                double size = size_of(cross(minus(place[p], o), minus(place[q], o)));
                if (size > largest) {
                    largest = size;
                    second = p;
                    third = q;
                }
            }
        if (sum < 1e-6 * largest) {
            f.second = second;
            f.third = third;
        }
        f.normal = newell<rational>(f);
        f.sum = corner_sum<rational>(f);
        {
            CGAL::Protect_FPU_rounding<true> upward;
            f.near_normal = newell<interval>(f);
            f.near_sum = corner_sum<interval>(f);
        }
        for (uint32_t p : f.corner) {
            vec<rational> d = minus(place[p], o);
            if (std::fabs(CGAL::to_double(dot(f.normal, d))) > PLANAR * size_of(f.normal) * std::sqrt(largest))
                throw std::runtime_error("a face is not planar");
        }
    }

    /* Do intervals show that the face's plane is that of Newell's normal, and that its corners are near it? Sets the
     * plane's intervals then. */
    bool is_plain(polygon &f) const
    {
        CGAL::Protect_FPU_rounding<true> upward;
        const vec<interval> o = at_vertex(f.corner[0], interval());
        f.near_normal = newell<interval>(f);
        f.near_sum = corner_sum<interval>(f);
        double low = 0, high = 0; /* square of the largest area: at least, at most */
        for (uint32_t p : f.corner)
            for (uint32_t q : f.corner) {
                const vec<interval> c = cross(minus(at_vertex(p, interval()), o), minus(at_vertex(q, interval()), o));
                const interval size = dot(c, c);
                low = std::max(low, size.inf()), high = std::max(high, size.sup());
            }
        const interval sum = dot(f.near_normal, f.near_normal);
        if (!(sum.inf() > 1.1e-12 * high))
            return false;
        const double most = 0.99 * PLANAR * PLANAR * sum.inf() * std::sqrt(low);
        for (uint32_t p : f.corner) {
            const interval h = dot(f.near_normal, minus(at_vertex(p, interval()), o));
            if (!(CGAL::square(h).sup() < most))
                return false;
        }
        return true;
    }

    static double size_of(const vec<rational> &d)
    {
        return std::sqrt(CGAL::to_double(dot(d, d)));
    }

    /* ---- the picture ---- */

    void frame()
    {
        roberts_vec3 lo{HUGE_VAL, HUGE_VAL, HUGE_VAL}, hi{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
        for (const polygon &f : faces)
            for (uint32_t v : f.corner) {
                const roberts_vec3 &p = mesh.vertex[v];
                lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
                hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
            }
        roberts_vec3 V{view.x, view.y, view.z};
        if (view.w) {
            D = {(lo.x + hi.x) / 2 - V.x, (lo.y + hi.y) / 2 - V.y, (lo.z + hi.z) / 2 - V.z};
            V = D;
        }
        /* two axes exactly perpendicular to V: V_k e_i - V_i e_k for the largest V_k */
        double ax = std::fabs(V.x), ay = std::fabs(V.y), az = std::fabs(V.z);
        if (az >= ax && az >= ay) {
            U = {V.z, 0, -V.x};
            W = {0, V.z, -V.y};
        } else if (ay >= ax) {
            U = {V.y, -V.x, 0};
            W = {0, -V.z, V.y};
        } else {
            U = {-V.y, V.x, 0};
            W = {-V.z, 0, V.x};
        }
        flat.resize(mesh.vertex_count);
        flat_exact.resize(mesh.vertex_count);
        std::vector<bool> used(mesh.vertex_count);
        for (const polygon &f : faces)
            for (uint32_t v : f.corner)
                used[v] = true;
        double largest = 0;
        for (uint32_t v = 0; v < mesh.vertex_count; v++) {
            if (!used[v])
                continue;
            {
                CGAL::Protect_FPU_rounding<true> upward;
                flat[v] = project<interval>(v);
            }
            flat_exact[v] = project<rational>(v);
            if (CGAL::sign(flat_exact[v].w) <= 0)
                throw std::runtime_error("the scene is not in front of the eye");
            for (const interval &x : {flat[v].x, flat[v].y})
                largest = std::max({largest, std::fabs(x.inf()), std::fabs(x.sup())});
        }
        margin = 1e-9 * largest;
    }

    template <class N> point2<N> project(uint32_t v) const
    {
        return project(vec<N>(at_vertex(v, N())));
    }

    template <class N> point2<N> project(vec<N> X) const
    {
        roberts_vec3 zero{0, 0, 0};
        if (view.w)
            X = {X.x - N(view.x), X.y - N(view.y), X.z - N(view.z)};
        N x = dot(X, sub<N>(U, zero)), y = dot(X, sub<N>(W, zero)), w(1);
        if (view.w) {
            w = dot(X, sub<N>(D, zero));
            x = x / w;
            y = y / w;
        }
        return {x, y, w};
    }

    const point2<interval> &at(uint32_t v, interval) const
    {
        return flat[v];
    }

    const point2<rational> &at(uint32_t v, rational) const
    {
        return flat_exact[v];
    }

    void box_face(polygon &f) const
    {
        f.x0 = f.y0 = HUGE_VAL;
        f.x1 = f.y1 = -HUGE_VAL;
        for (uint32_t v : f.corner) {
            f.x0 = std::min(f.x0, flat[v].x.inf() - margin), f.x1 = std::max(f.x1, flat[v].x.sup() + margin);
            f.y0 = std::min(f.y0, flat[v].y.inf() - margin), f.y1 = std::max(f.y1, flat[v].y.sup() + margin);
        }
    }

    spot spot_of(uint32_t v) const
    {
        return {at_vertex(v, interval()), place[v], flat[v], flat_exact[v], v};
    }

    static interval around(const rational &x)
    {
        std::pair<double, double> ends = CGAL::to_interval(x);
        return interval(ends.first, ends.second);
    }

    spot spot_of(const vec<rational> &X) const
    {
        spot s{{around(X.x), around(X.y), around(X.z)}, X, {}, project(X), ROBERTS_NONE};
        s.near_flat = {around(s.flat.x), around(s.flat.y), around(s.flat.w)};
        return s;
    }

    /* Are the boxes of their pictures apart? */
    static bool apart(const polygon &f, const spot &a, const spot &b)
    {
        const point2<interval> &p = a.near_flat, &q = b.near_flat;
        return std::max(p.x.sup(), q.x.sup()) < f.x0 || std::min(p.x.inf(), q.x.inf()) > f.x1 ||
               std::max(p.y.sup(), q.y.sup()) < f.y0 || std::min(p.y.inf(), q.y.inf()) > f.y1;
    }

    /* ---- one face ---- */

    vec<interval> at_vertex(uint32_t v, interval) const
    {
        const roberts_vec3 &p = mesh.vertex[v];
        return {interval(p.x), interval(p.y), interval(p.z)};
    }

    const vec<rational> &at_vertex(uint32_t v, rational) const
    {
        return place[v];
    }

    /* Twice the area vector */
    template <class N> vec<N> newell(const polygon &f) const
    {
        const vec<N> o = at_vertex(f.corner[0], N());
        if (f.second != f.third)
            return cross(minus(at_vertex(f.second, N()), o), minus(at_vertex(f.third, N()), o));
        vec<N> n{N(0), N(0), N(0)};
        for (size_t i = 1; i + 1 < f.corner.size(); i++)
            n = plus(n, cross(minus(at_vertex(f.corner[i], N()), o), minus(at_vertex(f.corner[i + 1], N()), o)));
        return n;
    }

    template <class N> vec<N> corner_sum(const polygon &f) const
    {
        vec<N> sum{N(0), N(0), N(0)};
        for (uint32_t v : f.corner)
            sum = plus(sum, at_vertex(v, N()));
        return sum;
    }

    static const vec<interval> &normal_of(const polygon &f, interval)
    {
        return f.near_normal;
    }

    static const vec<rational> &normal_of(const polygon &f, rational)
    {
        return f.normal;
    }

    static const vec<interval> &sum_of(const polygon &f, interval)
    {
        return f.near_sum;
    }

    static const vec<rational> &sum_of(const polygon &f, rational)
    {
        return f.sum;
    }

    /* How far X lies above the face's plane, times the length of its normal and the number of its corners */
    template <class N> N height(const polygon &f, const vec<N> &X) const
    {
        const N count((double)f.corner.size());
        const vec<N> &sum = sum_of(f, N());
        return dot(normal_of(f, N()), vec<N>{count * X.x - sum.x, count * X.y - sum.y, count * X.z - sum.z});
    }

    template <class N> N height(const polygon &f, const roberts_vec3 &X) const
    {
        return height(f, vec<N>{N(X.x), N(X.y), N(X.z)});
    }

    /* Returns the height of an end of a line; a corner of the face is at height 0. */
    template <class N> N height(const polygon &f, const spot &s) const
    {
        return s.vertex != ROBERTS_NONE && has(f, s.vertex) ? N(0) : height(f, s.space(N()));
    }

    static bool has(const polygon &f, uint32_t v)
    {
        return std::find(f.corner.begin(), f.corner.end(), v) != f.corner.end();
    }

    template <class N> static N orient(const point2<N> &p, const point2<N> &q, const N &x, const N &y)
    {
        return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    }

    /* On which side of the side's line the point lies in the picture; an end of the side lies on it. */
    template <class N> N beside(const std::array<uint32_t, 2> &side, const spot &s) const
    {
        if (s.vertex != ROBERTS_NONE && (s.vertex == side[0] || s.vertex == side[1]))
            return N(0);
        const point2<N> &X = s.picture(N());
        return orient(at(side[0], N()), at(side[1], N()), X.x, X.y);
    }

    /* Is (x, y) in the face's picture, border included? */
    template <class N> bool inside(const polygon &f, const N &x, const N &y) const
    {
        long winding = 0;
        for (const auto &s : f.side) {
            const point2<N> &p = at(s[0], N()), &q = at(s[1], N());
            int up = sign_of(N(y - p.y)), down = sign_of(N(y - q.y));
            if ((up > 0 && down > 0) || (up < 0 && down < 0))
                continue;
            int turn = sign_of(orient(p, q, x, y));
            if (turn == 0) {
                int left = sign_of(N(x - p.x)), right = sign_of(N(x - q.x));
                if (left * right <= 0) /* up * down <= 0 already */
                    return true;
                continue;
            }
            if (up >= 0 && down < 0)
                winding += turn > 0;
            else if (down >= 0 && up < 0)
                winding -= turn < 0;
        }
        return even_odd ? winding % 2 != 0 : winding != 0;
    }

    /* Where along the edge in space a point of its picture lies, and the other way about. */
    template <class N> static N to_space(const N &s, const N &wa, const N &wb)
    {
        return s * wa / ((N(1) - s) * wb + s * wa);
    }

    template <class N> static N to_picture(const N &t, const N &wa, const N &wb)
    {
        return t * wb / ((N(1) - t) * wa + t * wb);
    }

    /* ---- what a side bounds ---- */

    /* Finds the parameter of a corner along the line through a and b. False: it is not on that line. */
    bool along(uint32_t a, uint32_t b, uint32_t v, rational *t) const
    {
        if (v == a || v == b) {
            *t = v == a ? 0 : 1;
            return true;
        }
        const roberts_vec3 &A = mesh.vertex[a], &B = mesh.vertex[b], &P = mesh.vertex[v];
        double dx = B.x - A.x, dy = B.y - A.y, dz = B.z - A.z, x = P.x - A.x, y = P.y - A.y, z = P.z - A.z;
        double least = 1e-9 * (std::fabs(dx) + std::fabs(dy) + std::fabs(dz)) *
                       (std::fabs(A.x) + std::fabs(A.y) + std::fabs(A.z) + std::fabs(P.x) + std::fabs(P.y) +
                        std::fabs(P.z) + std::fabs(B.x) + std::fabs(B.y) + std::fabs(B.z));
        if (std::fabs(dx * y - dy * x) > least || std::fabs(dx * z - dz * x) > least ||
            std::fabs(dy * z - dz * y) > least)
            return false;
        vec<rational> d = minus(place[b], place[a]), p = minus(place[v], place[a]), c = cross(d, p);
        if (c.x != 0 || c.y != 0 || c.z != 0)
            return false;
        *t = d.x != 0 ? rational(p.x / d.x) : d.y != 0 ? rational(p.y / d.y) : rational(p.z / d.z);
        return true;
    }

    /* Returns where the border of face f bounds it along its side from a to b: pairs of ends. */
    std::vector<rational> bounded(const polygon &f, uint32_t a, uint32_t b) const
    {
        std::vector<std::tuple<rational, int>> change;
        rational t, s;
        if (f.corner.size() == 3 ||
            std::all_of(f.corner.begin(), f.corner.end(), [&](uint32_t v) { return along(a, b, v, &t); }))
            return {rational(0), rational(1)};
        for (const auto &side : f.side)
            if (along(a, b, side[0], &s) && along(a, b, side[1], &t)) {
                int way = s < t ? 1 : -1;
                rational low = std::max(rational(0), std::min(s, t)), high = std::min(rational(1), std::max(s, t));
                if (low < high) {
                    change.emplace_back(low, way);
                    change.emplace_back(high, -way);
                }
            }
        std::sort(change.begin(), change.end());
        std::vector<rational> out;
        int net = 0;
        for (size_t i = 0; i + 1 < change.size(); i++) {
            net += std::get<1>(change[i]);
            const rational &from = std::get<0>(change[i]), &to = std::get<0>(change[i + 1]);
            if (from == to || (even_odd ? net % 2 == 0 : net == 0))
                continue;
            if (!out.empty() && out.back() == from)
                out.back() = to;
            else
                out.insert(out.end(), {from, to});
        }
        return out;
    }

    /* Does the same for all faces that have the edge. */
    std::vector<oracle_interval> parts(uint32_t a, uint32_t b, const std::vector<size_t> &own) const
    {
        std::vector<oracle_interval> all;
        for (size_t f : own) {
            std::vector<rational> ends = bounded(faces[f], a, b);
            for (size_t i = 0; i < ends.size(); i += 2)
                all.push_back({rounded(ends[i]), rounded(ends[i + 1])});
        }
        return join(all, 0);
    }

    template <class N> int facing_of(const polygon &f) const
    {
        const roberts_vec3 V{view.x, view.y, view.z};
        return sign_of(view.w ? height<N>(f, V) : dot(normal_of(f, N()), sub<N>(V, roberts_vec3{0, 0, 0})));
    }

    static bool edge_on(const polygon &f)
    {
        return f.facing == 0;
    }

    /* Returns what face f hides of the line from a to b, which does not lie in the face by definition. */
    template <class N> std::vector<oracle_interval> hide_by(const polygon &f, const spot &a, const spot &b) const
    {
        std::vector<oracle_interval> out;
        if (f.facing == 0)
            return out;
        N toward(-f.facing);
        N ga = toward * height<N>(f, a), gb = toward * height<N>(f, b);
        int sa = sign_of(ga), sb = sign_of(gb);
        if (sa <= 0 && sb <= 0)
            return out;
        const point2<N> &A = a.picture(N()), &B = b.picture(N());
        std::vector<N> cut{N(0), N(1)};
        if (sa * sb < 0)
            cut.push_back(N(ga / (ga - gb)));
        bool point = sign_of(N(A.x - B.x)) == 0 && sign_of(N(A.y - B.y)) == 0;
        for (size_t i = 0; !point && i < f.side.size(); i++) {
            const point2<N> &p = at(f.side[i][0], N()), &q = at(f.side[i][1], N());
            N oa = beside<N>(f.side[i], a), ob = beside<N>(f.side[i], b);
            int ra = sign_of(oa), rb = sign_of(ob);
            if (ra * rb < 0)
                cut.push_back(to_space(N(oa / (oa - ob)), A.w, B.w));
            else if (ra == 0 && rb == 0)
                for (const point2<N> *r : {&p, &q}) {
                    bool wide = sign_of(N(A.x - B.x)) != 0;
                    N s = wide ? N((r->x - A.x) / (B.x - A.x)) : N((r->y - A.y) / (B.y - A.y));
                    if (sign_of(s) > 0 && sign_of(N(N(1) - s)) > 0)
                        cut.push_back(to_space(s, A.w, B.w));
                }
        }
        std::sort(cut.begin(), cut.end(), [](const N &x, const N &y) { return sign_of(N(x - y)) < 0; });
        for (size_t i = 0; i + 1 < cut.size(); i++) {
            if (sign_of(N(cut[i + 1] - cut[i])) == 0)
                continue;
            N t = (cut[i] + cut[i + 1]) / N(2), s = to_picture(t, A.w, B.w);
            if (sign_of(N((N(1) - t) * ga + t * gb)) <= 0)
                continue;
            if (inside(f, N(A.x + s * (B.x - A.x)), N(A.y + s * (B.y - A.y))))
                out.push_back({rounded(cut[i]), rounded(cut[i + 1])});
        }
        return out;
    }

    std::vector<oracle_interval> hide(const spot &a, const spot &b, const std::vector<size_t> &own)
    {
        std::vector<oracle_interval> all;
        for (size_t f = 0; f < faces.size(); f++) {
            if (apart(faces[f], a, b) || std::find(own.begin(), own.end(), f) != own.end())
                continue;
            pairs++;
            std::vector<oracle_interval> some =
                exactly(false, &exact, [&](auto zero) { return hide_by<decltype(zero)>(faces[f], a, b); });
            if (some.size() == 1 && some[0].t0 == 0 && some[0].t1 == 1)
                return some; /* everything is hidden: other faces change nothing */
            all.insert(all.end(), some.begin(), some.end());
        }
        return join(all, 4e-14);
    }

    /* Sorts intervals, and joins those no farther than `gap` apart. */
    static std::vector<oracle_interval> join(std::vector<oracle_interval> all, double gap)
    {
        std::vector<oracle_interval> joined;
        std::sort(all.begin(), all.end(),
                  [](const oracle_interval &p, const oracle_interval &q) { return p.t0 < q.t0; });
        for (const oracle_interval &i : all)
            if (!joined.empty() && i.t0 <= joined.back().t1 + gap)
                joined.back().t1 = std::max(joined.back().t1, i.t1);
            else
                joined.push_back(i);
        return joined;
    }
};

template <class T> T *copy_of(const std::vector<T> &list)
{
    T *out = (T *)std::malloc((list.size() + 1) * sizeof(T));
    if (!out)
        throw std::bad_alloc();
    std::copy(list.begin(), list.end(), out);
    return out;
}

} // namespace

#endif
