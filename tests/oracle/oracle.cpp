/* oracle.cpp - exact hidden intervals. Source of the clipping: Cyrus and Beck, "Generalized two- and three-dimensional
 * clipping", Computers & Graphics 3(1), 1978.
 *
 * What one convex solid hides is a convex region, an intersection of half-spaces g(X) = n.(X - a):
 *   - g > 0 for the plane of each front face, n inward: strictly behind the front of the solid;
 *   - g >= 0 for each silhouette edge ab (one face front, the other not), the plane through a, b and the viewer, n to
 *     the side of the front face: in or on the border of the solid's projection.
 * A near plane h(X) = n.(X - near) = 0, n away from the eye E, cuts off the part of a solid before it. What is left
 * hides:
 *   - h > 0: strictly behind it, where it closes the solid like a front face;
 *   - g(E) h - h(E) g >= 0 for each face that is not front, the plane through the eye and the line in which the face
 *     meets the near plane: in or on the border of that section's projection. (Both factors are >= 0, so the rest of
 *     the solid, where g >= 0 and h >= 0, lies within. If the face does not reach the near plane, this adds nothing.)
 * Along an edge X(t) each g is linear in t, so the hidden part is one interval; single points are dropped. The solid is
 * the convex hull of its vertices (CGAL, exact predicates). A face whose corners do not lie exactly in one plane counts
 * as the triangles that the hull makes of it. A planar face counts as coplanar triangles, which cut alike.
 *
 * exactly() (exact.h) decides each question: first with intervals of doubles, then, if need be, with rational
 * numbers. */
#include "oracle.h"

#include "exact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

namespace
{

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using hull_mesh = CGAL::Surface_mesh<kernel::Point_3>;

/* ---- what a solid hides ---------------------------------------------------------------------------------------- */

/* One half-space of the hidden region: behind the front triangle abc, or inside the silhouette edge ab; behind the near
 * plane, or inside its section with the plane of the triangle abc. */
struct wall {
    enum { FRONT, SILHOUETTE, NEAR, SECTION } kind;
    roberts_vec3 a, b, c;
    roberts_vec3 on; /* a point of the half-space's border; of a SECTION, of the near plane */
    vec<interval> n; /* the inward normal, kept for speed */
    interval beside; /* how far inside `on` is, times the normal's length */
};

struct box {
    double x0 = HUGE_VAL, x1 = -HUGE_VAL, y0 = HUGE_VAL, y1 = -HUGE_VAL;
};

bool apart(const box &p, const box &q)
{
    return p.x0 > q.x1 || q.x0 > p.x1 || p.y0 > q.y1 || q.y0 > p.y1;
}

struct face {
    std::vector<uint32_t> corner;
    oracle_answer front;
    std::array<double, 3> normal; /* outward, not of unit length */
};

struct solid {
    std::vector<uint32_t> vertex;
    std::vector<face> faces;
    std::vector<wall> walls;
    bool there = true, cut = false; /* some corner is beyond the near plane; some is before it */
    box shadow;                     /* of its projection, with a margin for rounding */
};

struct edge_work {
    oracle_edge edge;
    std::vector<oracle_interval> sure, maybe;
};

struct oracle {
    const roberts_mesh &mesh;
    oracle_view view;
    double slack;
    bool exact_only;
    size_t exact = 0, pairs = 0;
    std::vector<uint32_t> vertex_solid;
    std::vector<solid> solids;
    std::vector<edge_work> edges;
    roberts_vec3 centre{}, right{}, up{}, toward{}; /* doubles, for boxes only */
    double margin = 0;

    oracle(const roberts_mesh &m, const oracle_view &v, const oracle_options &o)
        : mesh(m), view(v), slack(o.slack), exact_only(o.exact_only)
    {
        if (view.cut && slack != 0)
            throw std::runtime_error("a near plane needs exact coordinates");
        find_solids();
        frame();
        for (size_t s = 0; s < solids.size(); s++) {
            for (face &f : solids[s].faces)
                turn_face(solids[s], f);
            build_walls(solids[s]);
            solids[s].shadow = projected(solids[s].vertex);
            list_edges((uint32_t)s);
        }
    }

    roberts_vec3 viewer() const
    {
        return {view.x, view.y, view.z};
    }

    /* From p toward the viewer. */
    template <class N> vec<N> to_viewer(const roberts_vec3 &p) const
    {
        return view.w ? sub<N>(viewer(), p) : vec<N>{N(view.x), N(view.y), N(view.z)};
    }

    /* The normal of the near plane, away from the viewer. */
    template <class N> vec<N> ahead() const
    {
        return view.w ? sub<N>(view.near, viewer()) : vec<N>{N(-view.x), N(-view.y), N(-view.z)};
    }

    /* h(p): > 0 beyond the near plane. */
    template <class N> N beyond(const roberts_vec3 &p) const
    {
        return dot(ahead<N>(), sub<N>(p, view.near));
    }

    /* -- solids: connected components of the faces, numbered by smallest vertex -- */

    void find_solids()
    {
        std::vector<uint32_t> parent(mesh.vertex_count);
        std::iota(parent.begin(), parent.end(), 0u);
        auto root = [&](uint32_t v) {
            while (parent[v] != v)
                v = parent[v] = parent[parent[v]];
            return v;
        };
        for (size_t f = 0; f < mesh.face_count; f++)
            for (uint32_t i = mesh.face_start[f]; i < mesh.face_start[f + 1]; i++)
                if (mesh.face_start[f + 1] - mesh.face_start[f] >= 3) {
                    uint32_t p = root(mesh.corner[mesh.face_start[f]]), q = root(mesh.corner[i]);
                    parent[std::max(p, q)] = std::min(p, q); /* so that the root is the smallest */
                }
        std::vector<bool> used(mesh.vertex_count);
        for (size_t f = 0; f < mesh.face_count; f++)
            if (mesh.face_start[f + 1] - mesh.face_start[f] >= 3)
                used[root(mesh.corner[mesh.face_start[f]])] = true;
        vertex_solid.assign(mesh.vertex_count, ROBERTS_NONE);
        for (uint32_t v = 0; v < mesh.vertex_count; v++) {
            if (!used[root(v)])
                continue;
            if (root(v) == v) {
                vertex_solid[v] = (uint32_t)solids.size();
                solids.emplace_back();
            }
            vertex_solid[v] = vertex_solid[root(v)];
            solids[vertex_solid[v]].vertex.push_back(v);
        }
        for (size_t f = 0; f < mesh.face_count; f++)
            if (mesh.face_start[f + 1] - mesh.face_start[f] >= 3) {
                const uint32_t *first = mesh.corner + mesh.face_start[f], *last = mesh.corner + mesh.face_start[f + 1];
                solids[vertex_solid[*first]].faces.push_back({{first, last}, ORACLE_NO, {}});
            }
    }

    /* -- faces as given: they decide which edges there are and which survive -- */

    /* Twice the area vector of a face, outward: away from the mean of the solid's vertices. */
    template <class N> vec<N> outward(const solid &s, const face &f) const
    {
        const roberts_vec3 &p = mesh.vertex[f.corner[0]];
        vec<N> n{N(0), N(0), N(0)}, from_mean{N(0), N(0), N(0)};
        for (size_t i = 1; i + 1 < f.corner.size(); i++) {
            vec<N> d = cross(sub<N>(mesh.vertex[f.corner[i]], p), sub<N>(mesh.vertex[f.corner[i + 1]], p));
            n = {n.x + d.x, n.y + d.y, n.z + d.z};
        }
        for (uint32_t v : s.vertex) {
            vec<N> d = sub<N>(p, mesh.vertex[v]);
            from_mean = {from_mean.x + d.x, from_mean.y + d.y, from_mean.z + d.z};
        }
        if (sign_of(dot(n, from_mean)) < 0)
            n = {-n.x, -n.y, -n.z};
        return n;
    }

    /* Does the face look at the viewer? If its corners move by `slack`, twice its projected area changes by at most
     * twice slack times perimeter. If the area is smaller than that, the answer is open. */
    void turn_face(const solid &s, face &f)
    {
        double perimeter = 0;
        for (size_t i = 0; i < f.corner.size(); i++)
            perimeter +=
                length(sub<rational>(mesh.vertex[f.corner[i]], mesh.vertex[f.corner[(i + 1) % f.corner.size()]]));
        f.front = exactly(exact_only, &exact, [&](auto zero) {
            using N = decltype(zero);
            vec<N> n = outward<N>(s, f), v{N(0), N(0), N(0)};
            for (uint32_t c : f.corner) { /* the mean of all corners, times their count */
                vec<N> d = to_viewer<N>(mesh.vertex[c]);
                v = {v.x + d.x, v.y + d.y, v.z + d.z};
            }
            f.normal = {CGAL::to_double(n.x), CGAL::to_double(n.y), CGAL::to_double(n.z)};
            if (slack == 0)
                return sign_of(dot(n, v)) > 0 ? ORACLE_YES : ORACLE_NO;
            N unsure(2 * slack * perimeter * length(v));
            return sign_of(N(dot(n, v) - unsure)) > 0   ? ORACLE_YES
                   : sign_of(N(dot(n, v) + unsure)) < 0 ? ORACLE_NO
                                                        : ORACLE_UNSURE;
        });
    }

    void list_edges(uint32_t number)
    {
        const solid &s = solids[number];
        std::map<std::array<uint32_t, 2>, std::vector<const face *>> faces_at;
        for (const face &f : s.faces)
            for (size_t i = 0; i < f.corner.size(); i++) {
                uint32_t p = f.corner[i], q = f.corner[(i + 1) % f.corner.size()];
                if (p != q)
                    faces_at[{std::min(p, q), std::max(p, q)}].push_back(&f);
            }
        for (const auto &[v, faces] : faces_at) {
            if (faces.size() != 2)
                throw std::runtime_error("edge " + std::to_string(v[0]) + "-" + std::to_string(v[1]) + " has " +
                                         std::to_string(faces.size()) + " faces");
            edge_work work{{number, v[0], v[1], ORACLE_NO, 180, 0, 1, 0, 0, 0, 0}, {}, {}};
            if (view.cut)
                cut_edge(s, work.edge);
            const face &f = *faces[0], &g = *faces[1];
            if (f.front == ORACLE_YES || g.front == ORACLE_YES)
                work.edge.survives = ORACLE_YES;
            else if (f.front == ORACLE_UNSURE || g.front == ORACLE_UNSURE)
                work.edge.survives = ORACLE_UNSURE;
            if (f.front == ORACLE_UNSURE || g.front == ORACLE_UNSURE)
                work.edge.bend_degrees = -1;
            else if (f.front == ORACLE_YES && g.front == ORACLE_YES)
                work.edge.bend_degrees =
                    bend({f.normal[0], f.normal[1], f.normal[2]}, {g.normal[0], g.normal[1], g.normal[2]});
            edges.push_back(work);
        }
    }

    /* The part of the edge beyond the near plane. */
    void cut_edge(const solid &s, oracle_edge &e)
    {
        exactly(exact_only, &exact, [&](auto zero) {
            using N = decltype(zero);
            N t0(0), t1(1), p = beyond<N>(mesh.vertex[e.v0]), q = beyond<N>(mesh.vertex[e.v1]);
            bool within = s.cut && sign_of(p) == 0 && sign_of(q) == 0; /* part of the section */
            bool any = s.there && !within && keep(p, q, t0, t1);
            e.t0 = any ? rounded(t0) : 1;
            e.t1 = any ? rounded(t1) : 1;
            return any;
        });
    }

    static double bend(const vec<double> &m, const vec<double> &n)
    {
        vec<double> c = cross(m, n);
        return std::atan2(std::hypot(c.x, c.y, c.z), dot(m, n)) * 180 / 3.14159265358979323846;
    }

    /* -- walls: from the convex hull -- */

    void build_walls(solid &s)
    {
        std::vector<kernel::Point_3> points;
        hull_mesh hull;
        for (uint32_t v : s.vertex)
            points.emplace_back(mesh.vertex[v].x, mesh.vertex[v].y, mesh.vertex[v].z);
        CGAL::convex_hull_3(points.begin(), points.end(), hull);
        auto at = [&](hull_mesh::Vertex_index v) {
            const kernel::Point_3 &p = hull.point(v);
            return roberts_vec3{p.x(), p.y(), p.z()};
        };
        std::vector<int> side(hull.number_of_faces()); /* the viewer's side of the face; < 0: a front face */
        for (auto f : hull.faces()) {                  /* hull faces run counter-clockwise seen from outside */
            auto h = hull.halfedge(f);
            roberts_vec3 a = at(hull.source(h)), b = at(hull.target(h)), c = at(hull.target(hull.next(h)));
            wall w{wall::FRONT, a, b, c, a, {}, {}};
            side[f] = exactly(exact_only, &exact, [&](auto zero) {
                using N = decltype(zero);
                return sign_of(dot(inward<N>(w), to_viewer<N>(a)));
            });
            if (side[f] < 0)
                s.walls.push_back(w);
            else if (view.cut)
                s.walls.push_back({wall::SECTION, a, b, c, view.near, {}, {}});
        }
        for (auto h : hull.halfedges()) {
            if (hull.is_border(h) || hull.is_border(hull.opposite(h)))
                throw std::runtime_error("a solid is flat");
            if (side[hull.face(h)] < 0 && side[hull.face(hull.opposite(h))] >= 0)
                s.walls.push_back(
                    {wall::SILHOUETTE, at(hull.source(h)), at(hull.target(h)), {}, at(hull.source(h)), {}, {}});
        }
        if (view.w && *std::min_element(side.begin(), side.end()) > 0)
            throw std::runtime_error("the eye is within a solid");
        if (view.cut)
            cut_solid(s);
        CGAL::Protect_FPU_rounding<true> upward;
        for (wall &w : s.walls) {
            w.n = inward<interval>(w);
            w.beside = offset<interval>(w);
        }
    }

    void cut_solid(solid &s)
    {
        s.there = false;
        s.walls.push_back({wall::NEAR, {}, {}, {}, view.near, {}, {}});
        for (uint32_t v : s.vertex) {
            int side =
                exactly(exact_only, &exact, [&](auto zero) { return sign_of(beyond<decltype(zero)>(mesh.vertex[v])); });
            s.there = s.there || side > 0;
            s.cut = s.cut || side < 0;
        }
    }

    template <class N> vec<N> inward(const wall &w) const
    {
        if (w.kind == wall::SILHOUETTE)
            return cross(to_viewer<N>(w.a), sub<N>(w.b, w.a));
        vec<N> n = cross(sub<N>(w.c, w.a), sub<N>(w.b, w.a)), m = ahead<N>();
        if (w.kind == wall::FRONT)
            return n;
        if (w.kind == wall::NEAR)
            return m;
        N g = dot(n, to_viewer<N>(w.a)), h = dot(m, m); /* of the viewer; h with the other sign */
        return {g * m.x + h * n.x, g * m.y + h * n.y, g * m.z + h * n.z};
    }

    /* g(X) = inward . (X - on) + offset */
    template <class N> N offset(const wall &w) const
    {
        if (w.kind != wall::SECTION)
            return N(0);
        vec<N> n = cross(sub<N>(w.c, w.a), sub<N>(w.b, w.a)), m = ahead<N>();
        return dot(m, m) * dot(n, sub<N>(w.on, w.a));
    }

    const vec<interval> &normal(const wall &w, interval) const
    {
        return w.n;
    }

    vec<rational> normal(const wall &w, rational) const
    {
        return inward<rational>(w);
    }

    interval beside(const wall &w, interval) const
    {
        return w.beside;
    }

    rational beside(const wall &w, rational) const
    {
        return offset<rational>(w);
    }

    /* -- clipping -- */

    /* Cuts t0..t1 to where a linear function, gp at 0 and gq at 1, is not negative. False: at most a point is left. */
    template <class N> static bool keep(const N &gp, const N &gq, N &t0, N &t1)
    {
        int sp = sign_of(gp), sq = sign_of(gq);
        if (sp + sq < 0)
            return false;
        if (sp < 0)
            t0 = CGAL::max(t0, N(gp / (gp - gq)));
        if (sq < 0)
            t1 = CGAL::min(t1, N(gp / (gp - gq)));
        return true;
    }

    /* The part of the edge from p to q that lies in the region, each wall moved outward by `grow`. */
    template <class N>
    bool clip(const std::vector<wall> &walls, const roberts_vec3 &p, const roberts_vec3 &q, double grow,
              oracle_interval *part) const
    {
        N t0(0), t1(1);
        for (const wall &w : walls) {
            const vec<N> &n = normal(w, N());
            const N inside = beside(w, N());
            N gp = dot(n, sub<N>(p, w.on)) + inside, gq = dot(n, sub<N>(q, w.on)) + inside;
            if (grow != 0) {
                N more(grow * length(n));
                gp = gp + more, gq = gq + more;
            }
            bool strict = w.kind == wall::FRONT || w.kind == wall::NEAR; /* a point in the wall is not behind it */
            if (!keep(gp, gq, t0, t1) || (strict && sign_of(gp) == 0 && sign_of(gq) == 0))
                return false;
        }
        if (sign_of(N(t1 - t0)) <= 0)
            return false;
        *part = {rounded(t0), rounded(t1)};
        return true;
    }

    bool hidden_by(const solid &s, const oracle_edge &e, double grow, oracle_interval *part)
    {
        return exactly(exact_only, &exact, [&](auto zero) {
            return clip<decltype(zero)>(s.walls, mesh.vertex[e.v0], mesh.vertex[e.v1], grow, part);
        });
    }

    /* If each corner of a solid moves by at most `slack`, the solid hides at least its region shrunk by that, and at
     * most the region grown by that. The edge moves as well, hence twice. In perspective, the border of the region
     * moves in proportion to the distance from the eye. */
    void hide(double stretch)
    {
        for (edge_work &w : edges) {
            if (w.edge.survives == ORACLE_NO) {
                if (w.edge.t0 < w.edge.t1)
                    w.sure = w.maybe = {{w.edge.t0, w.edge.t1}};
                continue;
            }
            box b = projected({w.edge.v0, w.edge.v1});
            for (const solid &s : solids)
                if (&s != &solids[w.edge.solid] && s.there && !apart(b, s.shadow))
                    hide_by(s, w, 2 * slack * stretch);
            if (slack == 0)
                w.sure = w.maybe;
            if (w.edge.survives == ORACLE_UNSURE)
                w.maybe = {{0, 1}};
        }
    }

    void hide_by(const solid &s, edge_work &w, double move)
    {
        oracle_interval part;
        pairs++;
        if (hidden_by(s, w.edge, move, &part))
            w.maybe.push_back(part);
        if (slack != 0 && hidden_by(s, w.edge, -move, &part))
            w.sure.push_back(part);
    }

    /* -- boxes in the picture, in doubles with a wide margin: only to leave out pairs that are far apart -- */

    void frame()
    {
        roberts_vec3 lo{HUGE_VAL, HUGE_VAL, HUGE_VAL}, hi{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
        double largest = 0;
        for (uint32_t v = 0; v < mesh.vertex_count; v++) {
            const roberts_vec3 &p = mesh.vertex[v];
            if (vertex_solid[v] == ROBERTS_NONE)
                continue;
            lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
            hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
            largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
        }
        centre = {(lo.x + hi.x) / 2, (lo.y + hi.y) / 2, (lo.z + hi.z) / 2};
        vec<double> d = to_viewer<double>(view.cut ? view.near : centre);
        double l = std::hypot(d.x, d.y, d.z);
        toward = {d.x / l, d.y / l, d.z / l};
        vec<double> t{toward.x, toward.y, toward.z};
        vec<double> u = std::fabs(t.z) < 0.9 ? cross(vec<double>{0, 0, 1}, t) : cross(vec<double>{0, 1, 0}, t);
        l = std::hypot(u.x, u.y, u.z);
        u = {u.x / l, u.y / l, u.z / l};
        vec<double> v = cross(t, u);
        right = {u.x, u.y, u.z};
        up = {v.x, v.y, v.z};
        if (view.w) /* in tangents; margin: the largest effect of rounding on a point near the eye */
            largest = std::max({largest, std::fabs(view.x), std::fabs(view.y), std::fabs(view.z)});
        margin = 1e-9 * std::hypot(hi.x - lo.x, hi.y - lo.y, hi.z - lo.z) + 1e-12 * largest + 4 * slack;
        if (!std::isfinite(margin))
            throw std::runtime_error("a coordinate is not finite, or there is no solid");
    }

    box projected(const std::vector<uint32_t> &vertices) const
    {
        box b;
        for (uint32_t v : vertices) {
            roberts_vec3 origin = view.w ? roberts_vec3{view.x, view.y, view.z} : centre;
            vec<double> d = sub<double>(mesh.vertex[v], origin);
            double x = dot(d, {right.x, right.y, right.z}), y = dot(d, {up.x, up.y, up.z}), w = 1, m = margin;
            if (view.w) {
                w = -dot(d, {toward.x, toward.y, toward.z});
                if ((!(w >= 1e-3 * length_of(d)) || w == 0) && view.cut)
                    return {-HUGE_VAL, HUGE_VAL, -HUGE_VAL, HUGE_VAL}; /* it may be anywhere */
                if (!(w >= 1e-3 * length_of(d)))
                    throw std::runtime_error("the scene is not in front of the eye");
                m = margin / w * (1 + 1e3);
            }
            b = {std::min(b.x0, x / w - m), std::max(b.x1, x / w + m), std::min(b.y0, y / w - m),
                 std::max(b.y1, y / w + m)};
        }
        return b;
    }

    static double length_of(const vec<double> &d)
    {
        return std::hypot(d.x, d.y, d.z);
    }

    /* Greatest over least distance of a corner from the eye; 1 for a viewer at infinity, and without slack. */
    double stretch() const
    {
        double near = HUGE_VAL, far = 0;
        if (!view.w || slack == 0)
            return 1;
        for (const solid &s : solids)
            for (uint32_t v : s.vertex) {
                double d = length_of(to_viewer<double>(mesh.vertex[v]));
                near = std::min(near, d), far = std::max(far, d);
            }
        return far / near;
    }
};

/* Sorts and joins intervals. Doubles suffice: they decide only whether two intervals are printed as one. */
void unite(std::vector<oracle_interval> &list)
{
    std::vector<oracle_interval> out;
    std::sort(list.begin(), list.end(), [](const oracle_interval &p, const oracle_interval &q) { return p.t0 < q.t0; });
    for (const oracle_interval &i : list)
        if (!out.empty() && i.t0 <= out.back().t1 + 4e-14)
            out.back().t1 = std::max(out.back().t1, i.t1);
        else
            out.push_back(i);
    list = out;
}

template <class T> T *copied(const std::vector<T> &list)
{
    T *out = (T *)std::malloc((list.size() + 1) * sizeof(T));
    if (!out)
        throw std::bad_alloc();
    std::copy(list.begin(), list.end(), out);
    return out;
}

void give(oracle &o, oracle_result *result)
{
    std::vector<oracle_edge> edges;
    std::vector<oracle_interval> intervals;
    for (edge_work &w : o.edges) {
        unite(w.sure);
        unite(w.maybe);
        w.edge.sure = intervals.size(), w.edge.sure_count = w.sure.size();
        intervals.insert(intervals.end(), w.sure.begin(), w.sure.end());
        w.edge.maybe = intervals.size(), w.edge.maybe_count = w.maybe.size();
        intervals.insert(intervals.end(), w.maybe.begin(), w.maybe.end());
        edges.push_back(w.edge);
    }
    result->edge_count = edges.size(), result->interval_count = intervals.size();
    result->solid_count = o.solids.size();
    result->pairs = o.pairs, result->exact = o.exact;
    result->edge = copied(edges);
    result->interval = copied(intervals);
    result->vertex_solid = copied(o.vertex_solid);
}

} // namespace

bool oracle_run(const roberts_mesh *mesh, const oracle_view *view, const oracle_options *options, oracle_result *result)
{
    std::memset(result, 0, sizeof *result);
    try {
        oracle o(*mesh, *view, options ? *options : oracle_options{0, false});
        o.hide(o.stretch());
        give(o, result);
        return true;
    } catch (const std::exception &e) {
        oracle_free(result);
        std::snprintf(result->error, sizeof result->error, "%s", e.what());
        return false;
    }
}

size_t oracle_hull(const roberts_vec3 *point, uint32_t count, uint32_t (*face)[3])
{
    try {
        std::map<std::array<double, 3>, uint32_t> number;
        std::vector<kernel::Point_3> points;
        hull_mesh hull;
        size_t faces = 0;
        for (uint32_t i = 0; i < count; i++) {
            number.emplace(std::array<double, 3>{point[i].x, point[i].y, point[i].z}, i);
            points.emplace_back(point[i].x, point[i].y, point[i].z);
        }
        CGAL::convex_hull_3(points.begin(), points.end(), hull);
        for (auto f : hull.faces()) {
            size_t corner = 0;
            for (auto v : hull.vertices_around_face(hull.halfedge(f))) {
                const kernel::Point_3 &p = hull.point(v);
                face[faces][corner++] = number.at({p.x(), p.y(), p.z()});
            }
            faces++;
        }
        return hull.number_of_vertices() < 4 ? 0 : faces;
    } catch (const std::exception &) {
        return 0;
    }
}

void oracle_free(oracle_result *result)
{
    std::free(result->edge);
    std::free(result->interval);
    std::free(result->vertex_solid);
    std::memset(result, 0, sizeof *result);
}
