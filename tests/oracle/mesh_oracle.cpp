/* mesh_oracle.cpp - see mesh_oracle.h. Everything is asked in the picture: points are projected exactly, an edge is
 * cut where it crosses the line of a side and where it pierces the plane, and each open part between two cuts is
 * asked in its middle. */
#include "mesh_oracle.h"

#include "exact.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <map>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace
{

/* How far a corner may be from its face's plane, as a part of the face's size. */
const double PLANAR = 1e-5;

template <class N> struct point2 {
    N x, y, w; /* w: depth of the point from the eye along the axis; 1 for a viewer at infinity */
};

/* A face with each corner once in a row, by positions. */
struct polygon {
    std::vector<uint32_t> corner;
    std::vector<std::array<uint32_t, 2>> side; /* without those that run both ways */
    double x0, x1, y0, y1;                     /* of its picture, with a margin */
    /* Two corners that make a triangle with the first one, where parts of the face that run either way are as large:
     * then Newell's normal is 0, or nothing but rounding. Else 0. */
    uint32_t second, third;
};

struct mesh_oracle {
    const roberts_mesh &mesh;
    oracle_view view;
    bool even_odd;
    std::vector<uint32_t> position;
    std::vector<polygon> faces;
    std::map<std::array<uint32_t, 2>, std::vector<size_t>> edges; /* faces of each */
    roberts_vec3 U{}, W{}, D{};                                   /* the picture's axes: any that are independent */
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
        for (polygon &f : faces)
            box_face(f);
    }

    /* ---- the mesh ---- */

    void weld()
    {
        std::map<std::tuple<double, double, double>, uint32_t> at;
        for (uint32_t i = 0; i < mesh.vertex_count; i++) {
            const roberts_vec3 &p = mesh.vertex[i]; /* -0 is 0 */
            position.push_back(at.emplace(std::make_tuple(p.x + 0.0, p.y + 0.0, p.z + 0.0), i).first->second);
        }
    }

    void take_faces()
    {
        for (size_t f = 0; f < mesh.face_count; f++) {
            polygon face{};
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
            std::map<std::array<uint32_t, 2>, int> runs;
            size_t n = face.corner.size();
            for (size_t i = 0; i < n; i++) {
                uint32_t p = face.corner[i], q = face.corner[(i + 1) % n];
                runs[{std::min(p, q), std::max(p, q)}] += p < q ? 1 : -1;
                std::vector<size_t> &of = edges[{std::min(p, q), std::max(p, q)}];
                if (of.empty() || of.back() != faces.size())
                    of.push_back(faces.size());
            }
            for (auto &[key, net] : runs)
                for (int k = 0; k < std::abs(net); k++)
                    face.side.push_back(net > 0 ? key : std::array<uint32_t, 2>{key[1], key[0]});
            take_plane(face);
            faces.push_back(face);
        }
        if (faces.empty())
            throw std::runtime_error("no face");
    }

    /* Chooses what the face's plane goes through. */
    void take_plane(polygon &f) const
    {
        const roberts_vec3 &o = mesh.vertex[f.corner[0]];
        double largest = 0, sum = size_of(newell<rational>(f));
        uint32_t second = 0, third = 0;
        for (uint32_t p : f.corner)
            for (uint32_t q : f.corner) {
                double size = size_of(cross(sub<rational>(mesh.vertex[p], o), sub<rational>(mesh.vertex[q], o)));
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
        vec<rational> n = newell<rational>(f);
        for (uint32_t p : f.corner) {
            vec<rational> d = sub<rational>(mesh.vertex[p], o);
            if (std::fabs(CGAL::to_double(dot(n, d))) > PLANAR * size_of(n) * std::sqrt(largest))
                throw std::runtime_error("a face is not planar");
        }
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
        /* two axes at right angles to V, exactly: V_k e_i - V_i e_k for the largest V_k */
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
        double largest = 0;
        {
            CGAL::Protect_FPU_rounding<true> upward;
            for (const polygon &f : faces)
                for (uint32_t v : f.corner)
                    flat[v] = project<interval>(v);
        }
        for (const polygon &f : faces)
            for (uint32_t v : f.corner) {
                flat_exact[v] = project<rational>(v);
                if (CGAL::sign(flat_exact[v].w) <= 0)
                    throw std::runtime_error("the scene is not in front of the eye");
                largest = std::max({largest, std::fabs(CGAL::to_double(flat_exact[v].x)),
                                    std::fabs(CGAL::to_double(flat_exact[v].y))});
            }
        margin = 1e-9 * largest;
    }

    template <class N> point2<N> project(uint32_t v) const
    {
        roberts_vec3 zero{0, 0, 0}, eye = view.w ? roberts_vec3{view.x, view.y, view.z} : zero;
        vec<N> X = sub<N>(mesh.vertex[v], eye);
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
            double x = CGAL::to_double(flat_exact[v].x), y = CGAL::to_double(flat_exact[v].y);
            f.x0 = std::min(f.x0, x - margin), f.x1 = std::max(f.x1, x + margin);
            f.y0 = std::min(f.y0, y - margin), f.y1 = std::max(f.y1, y + margin);
        }
    }

    bool apart(const polygon &f, uint32_t a, uint32_t b) const
    {
        double ax = CGAL::to_double(flat_exact[a].x), ay = CGAL::to_double(flat_exact[a].y);
        double bx = CGAL::to_double(flat_exact[b].x), by = CGAL::to_double(flat_exact[b].y);
        return std::max(ax, bx) < f.x0 || std::min(ax, bx) > f.x1 || std::max(ay, by) < f.y0 || std::min(ay, by) > f.y1;
    }

    /* ---- one face ---- */

    /* Twice the area vector, and the plane's value at a point times the number of corners. */
    template <class N> vec<N> newell(const polygon &f) const
    {
        const roberts_vec3 &o = mesh.vertex[f.corner[0]];
        if (f.second != f.third)
            return cross(sub<N>(mesh.vertex[f.second], o), sub<N>(mesh.vertex[f.third], o));
        vec<N> n{N(0), N(0), N(0)};
        for (size_t i = 1; i + 1 < f.corner.size(); i++) {
            vec<N> d = cross(sub<N>(mesh.vertex[f.corner[i]], o), sub<N>(mesh.vertex[f.corner[i + 1]], o));
            n = {n.x + d.x, n.y + d.y, n.z + d.z};
        }
        return n;
    }

    template <class N> N height(const polygon &f, const vec<N> &n, const roberts_vec3 &X) const
    {
        vec<N> sum{N(0), N(0), N(0)};
        for (uint32_t v : f.corner) {
            vec<N> d = sub<N>(X, mesh.vertex[v]);
            sum = {sum.x + d.x, sum.y + d.y, sum.z + d.z};
        }
        return dot(n, sum);
    }

    static bool has(const polygon &f, uint32_t v)
    {
        return std::find(f.corner.begin(), f.corner.end(), v) != f.corner.end();
    }

    template <class N> static N orient(const point2<N> &p, const point2<N> &q, const N &x, const N &y)
    {
        return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
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

    /* The parameter of a corner along the line through a and b; false: it lies beside that line. */
    bool along(uint32_t a, uint32_t b, uint32_t v, rational *t) const
    {
        const roberts_vec3 &A = mesh.vertex[a], &B = mesh.vertex[b], &P = mesh.vertex[v];
        double dx = B.x - A.x, dy = B.y - A.y, dz = B.z - A.z, x = P.x - A.x, y = P.y - A.y, z = P.z - A.z;
        double least = 1e-9 * (std::fabs(dx) + std::fabs(dy) + std::fabs(dz)) *
                       (std::fabs(A.x) + std::fabs(A.y) + std::fabs(A.z) + std::fabs(P.x) + std::fabs(P.y) +
                        std::fabs(P.z) + std::fabs(B.x) + std::fabs(B.y) + std::fabs(B.z));
        if (std::fabs(dx * y - dy * x) > least || std::fabs(dx * z - dz * x) > least ||
            std::fabs(dy * z - dz * y) > least)
            return false;
        vec<rational> d = sub<rational>(B, A), p = sub<rational>(P, A), c = cross(d, p);
        if (c.x != 0 || c.y != 0 || c.z != 0)
            return false;
        *t = d.x != 0 ? rational(p.x / d.x) : d.y != 0 ? rational(p.y / d.y) : rational(p.z / d.z);
        return true;
    }

    /* Where the border of face f bounds something along its side from a to b: ends of parts, two by two. */
    std::vector<rational> bounded(const polygon &f, uint32_t a, uint32_t b) const
    {
        std::vector<std::tuple<rational, int>> change;
        rational t, s;
        bool line = true;
        for (uint32_t v : f.corner)
            line = line && along(a, b, v, &t);
        if (line || f.corner.size() == 3)
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

    /* The same of all faces that have the edge. */
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

    /* What face f hides of the edge from a to b; f is none of its own. */
    template <class N> std::vector<oracle_interval> hide_by(const polygon &f, uint32_t a, uint32_t b) const
    {
        std::vector<oracle_interval> out;
        vec<N> n = newell<N>(f);
        int facing = view.w ? sign_of(height(f, n, roberts_vec3{view.x, view.y, view.z}))
                            : sign_of(dot(n, sub<N>(roberts_vec3{view.x, view.y, view.z}, roberts_vec3{0, 0, 0})));
        if (facing == 0)
            return out;
        N toward(-facing);
        N ga = has(f, a) ? N(0) : N(toward * height(f, n, mesh.vertex[a]));
        N gb = has(f, b) ? N(0) : N(toward * height(f, n, mesh.vertex[b]));
        int sa = sign_of(ga), sb = sign_of(gb);
        if (sa <= 0 && sb <= 0)
            return out;
        const point2<N> &A = at(a, N()), &B = at(b, N());
        std::vector<N> cut{N(0), N(1)};
        if (sa * sb < 0)
            cut.push_back(N(ga / (ga - gb)));
        bool point = sign_of(N(A.x - B.x)) == 0 && sign_of(N(A.y - B.y)) == 0;
        for (size_t i = 0; !point && i < f.side.size(); i++) {
            const point2<N> &p = at(f.side[i][0], N()), &q = at(f.side[i][1], N());
            N oa = orient(p, q, A.x, A.y), ob = orient(p, q, B.x, B.y);
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

    std::vector<oracle_interval> hide(uint32_t a, uint32_t b, const std::vector<size_t> &own)
    {
        std::vector<oracle_interval> all;
        for (size_t f = 0; f < faces.size(); f++) {
            if (apart(faces[f], a, b) || std::find(own.begin(), own.end(), f) != own.end())
                continue;
            pairs++;
            std::vector<oracle_interval> some =
                exactly(false, &exact, [&](auto zero) { return hide_by<decltype(zero)>(faces[f], a, b); });
            all.insert(all.end(), some.begin(), some.end());
        }
        return join(all, 4e-14);
    }

    /* Sorted, and one where they are no farther than `gap` from one another. */
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

/* ---- how clear an answer is, in doubles ---- */

struct plain {
    double x, y, z;
};

double distance_to(const plain &p, const plain &q, double x, double y)
{
    double dx = q.x - p.x, dy = q.y - p.y, l = dx * dx + dy * dy;
    double s = l > 0 ? std::min(1.0, std::max(0.0, ((x - p.x) * dx + (y - p.y) * dy) / l)) : 0;
    return std::hypot(p.x + s * dx - x, p.y + s * dy - y);
}

/* (p - o) x (q - o) */
plain turn_of(const plain &o, const plain &p, const plain &q)
{
    plain a{p.x - o.x, p.y - o.y, p.z - o.z}, b{q.x - o.x, q.y - o.y, q.z - o.z};
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

} // namespace

bool mesh_truth_find(const roberts_mesh *mesh, const oracle_view *view, bool even_odd, mesh_truth *truth)
{
    std::memset(truth, 0, sizeof *truth);
    try {
        mesh_oracle o(*mesh, *view, even_odd);
        std::vector<mesh_edge> edges;
        std::vector<oracle_interval> intervals, parts;
        for (const auto &[key, own] : o.edges) {
            std::vector<oracle_interval> part = o.parts(key[0], key[1], own);
            if (part.empty())
                continue;
            std::vector<oracle_interval> hidden = o.hide(key[0], key[1], own);
            edges.push_back(
                {key[0], key[1], (uint32_t)own.size(), intervals.size(), hidden.size(), parts.size(), part.size()});
            intervals.insert(intervals.end(), hidden.begin(), hidden.end());
            parts.insert(parts.end(), part.begin(), part.end());
        }
        truth->edge_count = edges.size(), truth->interval_count = intervals.size();
        truth->part_count = parts.size();
        truth->part = copy_of(parts);
        truth->pairs = o.pairs, truth->exact = o.exact;
        truth->edge = copy_of(edges);
        truth->interval = copy_of(intervals);
        truth->position = copy_of(o.position);
        return true;
    } catch (const std::exception &e) {
        mesh_truth_free(truth);
        std::snprintf(truth->error, sizeof truth->error, "%s", e.what());
        return false;
    }
}

void mesh_truth_free(mesh_truth *truth)
{
    std::free(truth->edge);
    std::free(truth->interval);
    std::free(truth->part);
    std::free(truth->position);
    std::memset(truth, 0, sizeof *truth);
}

oracle_answer mesh_truth_at(const roberts_mesh *mesh, const oracle_view *view, bool even_odd, const uint32_t *position,
                            uint32_t v0, uint32_t v1, double t, double slack)
{
    roberts_vec3 a = mesh->vertex[v0], b = mesh->vertex[v1];
    plain X{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
    plain V = view->w ? plain{view->x - X.x, view->y - X.y, view->z - X.z} : plain{view->x, view->y, view->z};
    double l = std::sqrt(V.x * V.x + V.y * V.y + V.z * V.z);
    V = {V.x / l, V.y / l, V.z / l};
    plain e = std::fabs(V.z) < 0.9 ? plain{0, 0, 1} : plain{0, 1, 0};
    plain r{e.y * V.z - e.z * V.y, e.z * V.x - e.x * V.z, e.x * V.y - e.y * V.x};
    l = std::sqrt(r.x * r.x + r.y * r.y + r.z * r.z);
    r = {r.x / l, r.y / l, r.z / l};
    plain u{V.y * r.z - V.z * r.y, V.z * r.x - V.x * r.z, V.x * r.y - V.y * r.x};
    bool unsure = false;
    std::vector<plain> q;
    for (size_t f = 0; f < mesh->face_count; f++) {
        bool own0 = false, own1 = false, behind = false;
        q.clear();
        for (uint32_t i = mesh->face_start[f]; i < mesh->face_start[f + 1]; i++) {
            uint32_t c = position[mesh->corner[i]];
            roberts_vec3 p = mesh->vertex[c];
            plain d{p.x - X.x, p.y - X.y, p.z - X.z};
            double z = d.x * V.x + d.y * V.y + d.z * V.z, w = 1;
            if (view->w) /* distances in the picture, at the distance of X */
                w = l = 1 - z / std::sqrt((view->x - X.x) * (view->x - X.x) + (view->y - X.y) * (view->y - X.y) +
                                          (view->z - X.z) * (view->z - X.z));
            q.push_back({(d.x * r.x + d.y * r.y + d.z * r.z) / w, (d.x * u.x + d.y * u.y + d.z * u.z) / w, z / w});
            own0 = own0 || c == v0;
            own1 = own1 || c == v1;
        }
        if (q.size() < 3 || (own0 && own1))
            continue;
        /* the plane z = z0 + gx x + gy y above X, by Newell */
        plain n{0, 0, 0}, m{0, 0, 0};
        long winding = 0;
        double border = HUGE_VAL;
        for (size_t i = 0; i < q.size(); i++) {
            const plain &p = q[i], &s = q[(i + 1) % q.size()];
            n.x += (p.y - s.y) * (p.z + s.z);
            n.y += (p.z - s.z) * (p.x + s.x);
            n.z += (p.x - s.x) * (p.y + s.y);
            m = {m.x + p.x / q.size(), m.y + p.y / q.size(), m.z + p.z / q.size()};
            border = std::min(border, distance_to(p, s, 0, 0));
            double turn = (s.x - p.x) * -p.y + (s.y - p.y) * p.x;
            if (p.y <= 0 && s.y > 0)
                winding += turn > 0;
            else if (s.y <= 0 && p.y > 0)
                winding -= turn < 0;
        }
        bool in = even_odd ? winding % 2 != 0 : winding != 0;
        if (border > slack && !in)
            continue;
        double size = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z), largest = 0;
        plain widest{0, 0, 0};
        for (const plain &p : q)
            for (const plain &s : q) {
                plain c = turn_of(q[0], p, s);
                double area = std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z);
                if (area > largest) {
                    largest = area;
                    widest = c;
                }
            }
        if (size < 1e-6 * largest) {
            size = largest;
            n = widest;
        }
        double gap = size > 0 ? (n.x * m.x + n.y * m.y + n.z * m.z) / size : 0; /* distance of the plane from X */
        double lean = size > 0 ? std::fabs(n.z) / size : 0;
        if (n.z < 0)
            gap = -gap;
        if (gap < -slack)
            continue;
        behind = gap > slack && lean > 1e-9;
        if (behind && border > slack && in)
            return ORACLE_YES;
        unsure = true;
    }
    return unsure ? ORACLE_UNSURE : ORACLE_NO;
}
