/* cross_exact.h - the segments in which two faces cross (C++). The line of the two planes is walked from end to end. A
 * face has points on the upper side of the other's plane at X if its border, shifted up infinitesimally, winds round
 * X. */
#ifndef ROBERTS_TESTS_CROSS_EXACT_H
#define ROBERTS_TESTS_CROSS_EXACT_H

#include "mesh_exact.h"

namespace
{

/* A maximal segment in which faces f and g cross. */
struct crossing {
    size_t f, g; /* indices in mesh_oracle.faces, f < g */
    vec<rational> a, b;
};

roberts_vec3 nearest(const vec<rational> &p)
{
    return {CGAL::to_double(p.x), CGAL::to_double(p.y), CGAL::to_double(p.z)};
}

bool before(const vec<rational> &p, const vec<rational> &q)
{
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

struct cross_finder {
    const mesh_oracle &o;

    /* A point where the border of a face meets the other's plane, along the line of both planes. */
    struct meeting {
        rational s;
        vec<rational> at;
        int up, down; /* by how much the winding number on each side falls here for points farther along */
    };

    /* A side that runs along the line. */
    struct run {
        rational low, high;
        int way;
    };

    struct profile {
        std::vector<meeting> meetings;
        std::vector<run> runs;
    };

    /* Boxes in space; pairs that are apart need no exact test. */
    struct box {
        double low[3], high[3];
    };
    std::vector<box> boxes;
    std::vector<size_t> first;                                    /* see first_alike() */
    std::map<std::array<uint32_t, 2>, std::vector<size_t>> edges; /* faces of each edge: see take_edges() */
    std::set<std::array<uint32_t, 2>> joined;                     /* complete edges: see join_edges() */
    std::set<uint32_t> ends;                                      /* of all edges */

    explicit cross_finder(const mesh_oracle &oracle) : o(oracle)
    {
        for (const polygon &f : o.faces) {
            box b{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
            for (uint32_t v : f.corner) {
                const roberts_vec3 &p = o.mesh.vertex[v];
                const double x[3] = {p.x, p.y, p.z};
                for (int k = 0; k < 3; k++)
                    b.low[k] = std::min(b.low[k], x[k]), b.high[k] = std::max(b.high[k], x[k]);
            }
            boxes.push_back(b);
        }
        first = first_alike();
    }

    bool apart(size_t f, size_t g) const
    {
        for (int k = 0; k < 3; k++)
            if (boxes[f].high[k] < boxes[g].low[k] || boxes[g].high[k] < boxes[f].low[k])
                return true;
        return false;
    }

    /* Is the whole face f on one side of g's plane, or in it? */
    bool beside(const polygon &f, const polygon &g) const
    {
        size_t exact = 0;
        return exactly(false, &exact, [&](auto zero) {
            using N = decltype(zero);
            bool over = false, under = false;
            for (uint32_t v : f.corner) {
                int sign = o.has(g, v) ? 0 : sign_of(o.height<N>(g, o.mesh.vertex[v]));
                over = over || sign > 0;
                under = under || sign < 0;
            }
            return !over || !under;
        });
    }

    /* On which side of g's plane the ends of the sides of f surely lie; 0: perhaps in it. */
    std::vector<int> rough_signs(const polygon &f, const polygon &g) const
    {
        CGAL::Protect_FPU_rounding<true> upward;
        std::vector<int> out;
        for (const auto &side : f.side)
            for (uint32_t v : side) {
                const interval h = o.has(g, v) ? interval(0) : o.height<interval>(g, o.mesh.vertex[v]);
                out.push_back((h.inf() > 0) - (h.sup() < 0));
            }
        return out;
    }

    profile profile_of(const polygon &f, const polygon &g, const vec<rational> &along) const
    {
        profile out;
        const std::vector<int> sign = rough_signs(f, g);
        for (size_t i = 0; i < f.side.size(); i++) {
            const auto &side = f.side[i];
            if (sign[2 * i] * sign[2 * i + 1] > 0)
                continue; /* both ends lie on one side of the plane */
            const vec<rational> &p = o.place[side[0]], &q = o.place[side[1]];
            rational hp = o.has(g, side[0]) ? rational(0) : o.height(g, p);
            rational hq = o.has(g, side[1]) ? rational(0) : o.height(g, q);
            int sp = sign_of(hp), sq = sign_of(hq);
            if (sp == 0 && sq == 0) {
                rational s = dot(along, p), t = dot(along, q);
                out.runs.push_back({std::min(s, t), std::max(s, t), s < t ? 1 : -1});
                out.meetings.push_back({s, p, 0, 0});
                out.meetings.push_back({t, q, 0, 0});
            } else if (sp * sq <= 0) {
                rational u = hp / (hp - hq);
                vec<rational> X{p.x + u * (q.x - p.x), p.y + u * (q.y - p.y), p.z + u * (q.z - p.z)};
                int up = (sp > 0) - (sq > 0), down = (sp >= 0) - (sq >= 0);
                out.meetings.push_back({dot(along, X), X, up, down});
            }
        }
        return out;
    }

    bool filled(long winding) const
    {
        return o.even_odd ? winding % 2 != 0 : winding != 0;
    }

    /* Does the face continue on both sides at s, which is not a meeting, without a side that bounds it there? */
    bool goes_on(const profile &p, const rational &s) const
    {
        long up = 0, down = 0, net = 0;
        for (const meeting &m : p.meetings)
            if (m.s > s)
                up += m.up, down += m.down;
        for (const run &r : p.runs)
            if (r.low < s && s < r.high)
                net += r.way;
        return filled(up) && filled(down) && !filled(net);
    }

    void cross_pair(size_t f, size_t g, std::vector<crossing> &out)
    {
        const polygon &F = o.faces[f], &G = o.faces[g];
        if (apart(f, g))
            return;
        if (beside(F, G) || beside(G, F))
            return;
        vec<rational> along = cross(F.normal, G.normal);
        if (along.x == 0 && along.y == 0 && along.z == 0)
            return;
        profile p = profile_of(F, G, along), q = profile_of(G, F, along);
        std::vector<meeting> cut(p.meetings);
        cut.insert(cut.end(), q.meetings.begin(), q.meetings.end());
        std::sort(cut.begin(), cut.end(), [](const meeting &x, const meeting &y) { return x.s < y.s; });
        bool open = false;
        for (size_t i = 0; i + 1 < cut.size(); i++) {
            if (cut[i].s == cut[i + 1].s)
                continue;
            rational s = (cut[i].s + cut[i + 1].s) / 2;
            if (!goes_on(p, s) || !goes_on(q, s)) {
                open = false;
                continue;
            }
            if (open)
                out.back().b = cut[i + 1].at;
            else
                out.push_back({f, g, cut[i].at, cut[i + 1].at});
            open = true;
        }
    }

    /* ---- edges that are not drawn ---- */

    /* A part of an edge that is not drawn, in which its face f ends on face g. */
    struct seam {
        size_t f, g;
        std::vector<size_t> own; /* all faces of the edge or edges, and g */
        vec<rational> a, b;
    };

    /* An edge: a + t d. */
    struct carrier {
        std::array<uint32_t, 2> key;
        vec<rational> a, d;

        vec<rational> at(const rational &t) const
        {
            return {a.x + t * d.x, a.y + t * d.y, a.z + t * d.z};
        }
    };

    /* Positions that are equal are one vertex "where that closes what is open". Bodies that are closed as they are in
     * the file, with an even number of faces at each edge, keep their own vertices, and so their own edges. Names each
     * vertex of the file by the smallest one with which it is one vertex. */
    std::vector<uint32_t> vertex_names() const
    {
        std::vector<uint32_t> body(o.mesh.vertex_count), name(body.size());
        std::map<std::array<uint32_t, 2>, std::set<size_t>> sides;
        std::iota(body.begin(), body.end(), 0);
        const auto root = [&](uint32_t v) {
            while (body[v] != v)
                v = body[v];
            return v;
        };
        for_sides([&](size_t f, uint32_t p, uint32_t q) {
            sides[{std::min(p, q), std::max(p, q)}].insert(f);
            body[std::max(root(p), root(q))] = std::min(root(p), root(q));
        });
        std::set<uint32_t> open;
        for (const auto &[key, faces] : sides)
            if (faces.size() % 2 != 0)
                open.insert(root(key[0]));
        std::map<uint32_t, uint32_t> least; /* of open bodies, by position */
        for (uint32_t v = 0; v < name.size(); v++)
            name[v] = open.count(root(v)) ? least.emplace(o.position[v], v).first->second : v;
        return name;
    }

    /* Calls take(face, p, q) for each side, with its ends as in the file. */
    template <class T> void for_sides(T take) const
    {
        for (size_t f = 0; f < o.faces.size(); f++) {
            const uint32_t begin = o.mesh.face_start[o.faces[f].number], end = o.mesh.face_start[o.faces[f].number + 1];
            for (uint32_t i = begin; i < end; i++) {
                const uint32_t p = o.mesh.corner[i], q = o.mesh.corner[i + 1 < end ? i + 1 : begin];
                if (o.position[p] != o.position[q])
                    take(f, p, q);
            }
        }
    }

    void take_edges()
    {
        const std::vector<uint32_t> name = vertex_names();
        for_sides([&](size_t f, uint32_t p, uint32_t q) {
            const uint32_t a = name[p], b = name[q];
            if (first[f] != f)
                return; /* a face given again has no edges of its own */
            std::vector<size_t> &of = edges[{std::min(a, b), std::max(a, b)}];
            if (of.empty() || of.back() != f)
                of.push_back(f);
            ends.insert({a, b});
        });
        join_edges();
    }

    /* "Each piece of an edge has the faces of all edges that lie on it": edges with an odd number of faces divide one
     * another at their ends, and what lies between two ends that follow one another is one edge. An edge with an even
     * number of faces is complete: no vertex divides it. But if it runs between two such ends itself, it is that
     * edge. */
    void join_edges()
    {
        std::set<uint32_t> odd; /* ends of edges with an odd number of faces */
        for (const auto &[key, faces] : edges)
            if (faces.size() % 2 != 0)
                odd.insert(key.begin(), key.end());
        for (const auto &[key, faces] : edges) {
            if (faces.size() % 2 != 0 || !odd.count(key[0]) || !odd.count(key[1]))
                continue;
            const vec<rational> middle = carrier_of(key).at(rational(1) / 2);
            const std::array<uint32_t, 2> whole = key;
            if (std::none_of(odd.begin(), odd.end(), [&](uint32_t v) { return is_on(whole, place(v)); }) &&
                std::any_of(edges.begin(), edges.end(), [&](const auto &e) {
                    return e.second.size() % 2 != 0 && runs_along(e.first, whole, middle);
                }))
                joined.insert(key);
        }
    }

    /* Does the edge count as one with all others of this kind where they overlap? */
    bool is_open(const std::array<uint32_t, 2> &key) const
    {
        return edges.at(key).size() % 2 != 0 || joined.count(key) > 0;
    }

    std::vector<std::array<double, 4>> rough; /* planes in doubles: unit normal, and its product with a corner */

    const vec<rational> &place(uint32_t v) const
    {
        return o.place[v];
    }

    static vec<interval> near(const vec<rational> &p)
    {
        return {mesh_oracle::around(p.x), mesh_oracle::around(p.y), mesh_oracle::around(p.z)};
    }

    carrier carrier_of(const std::array<uint32_t, 2> &key) const
    {
        return {key, place(key[0]), minus(place(key[1]), place(key[0]))};
    }

    void make_rough()
    {
        for (const polygon &f : o.faces) {
            const vec<rational> n = f.normal;
            const double x = CGAL::to_double(n.x), y = CGAL::to_double(n.y), z = CGAL::to_double(n.z);
            const double l = std::sqrt(x * x + y * y + z * z);
            const roberts_vec3 &p = o.mesh.vertex[f.corner[0]];
            rough.push_back({x / l, y / l, z / l, (x * p.x + y * p.y + z * p.z) / l});
        }
    }

    /* Surely not in the plane of the face? */
    bool off_plane(size_t f, uint32_t v) const
    {
        const roberts_vec3 &p = o.mesh.vertex[v];
        const std::array<double, 4> &r = rough[f];
        const double size = std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z) + std::fabs(r[3]);
        return std::fabs(r[0] * p.x + r[1] * p.y + r[2] * p.z - r[3]) > 1e-4 * size;
    }

    /* Does the interval that work() computes leave out 0? */
    template <class W> static bool surely_not_zero(W work)
    {
        CGAL::Protect_FPU_rounding<true> upward;
        const interval x = work();
        return x.inf() > 0 || x.sup() < 0;
    }

    bool in_plane(size_t f, uint32_t v) const
    {
        const polygon &F = o.faces[f];
        if (o.has(F, o.position[v]))
            return true;
        if (off_plane(f, v) || surely_not_zero([&] { return o.height<interval>(F, o.mesh.vertex[v]); }))
            return false;
        return o.height(F, place(v)) == 0;
    }

    bool in_one_plane(size_t f, size_t g) const
    {
        for (uint32_t v : o.faces[f].corner)
            if (!in_plane(g, v))
                return false;
        return true;
    }

    /* Where the border of a face, in whose plane the edge lies, meets its line. */
    void add_cuts(size_t f, const carrier &e, std::vector<rational> &cut) const
    {
        const vec<rational> m = cross(o.faces[f].normal, e.d);
        const rational length = dot(e.d, e.d);
        for (const auto &side : o.faces[f].side) {
            const vec<rational> p = minus(place(side[0]), e.a), q = minus(place(side[1]), e.a);
            const rational hp = dot(m, p), hq = dot(m, q), tp = dot(e.d, p) / length, tq = dot(e.d, q) / length;
            if (hp == 0)
                cut.push_back(tp);
            if (hq == 0)
                cut.push_back(tq);
            if (sign_of(hp) * sign_of(hq) < 0)
                cut.push_back(tp + hp / (hp - hq) * (tq - tp));
        }
    }

    /* Does the face hold what lies beside X on one side of the edge, in its plane? way: 1 to the left, as seen against
     * the normal, or -1. */
    bool holds_beside(size_t f, const carrier &e, const vec<rational> &X, int way) const
    {
        const vec<rational> m = cross(o.faces[f].normal, e.d);
        long winding = 0;
        for (const auto &side : o.faces[f].side) {
            const vec<rational> p = minus(place(side[0]), X), q = minus(place(side[1]), X);
            const rational yp = dot(e.d, p), yq = dot(e.d, q);
            if ((yp > 0) == (yq > 0))
                continue;
            const rational xp = dot(m, p), xq = dot(m, q), x = xp + yp / (yp - yq) * (xq - xp);
            if (sign_of(x) == way)
                winding += yq > 0 ? 1 : -1;
        }
        return filled(winding);
    }

    /* On which side of the edge does the face end at X: 1, -1; 0: nowhere, or it goes on at both. */
    int ends_at(size_t f, const carrier &e, const vec<rational> &X) const
    {
        return (int)holds_beside(f, e, X, 1) - (int)holds_beside(f, e, X, -1);
    }

    /* Does the face go on at both sides of X, where a side of it bounds something too? A border that winds once on one
     * side of it and twice on the other has such a side. */
    bool passes(size_t f, const carrier &e, const vec<rational> &X) const
    {
        long net = 0;
        for (const auto &side : o.faces[f].side) {
            const vec<rational> p = minus(place(side[0]), X), q = minus(place(side[1]), X);
            if (parallel(e.d, p) && parallel(e.d, q))
                net += (dot(e.d, q) > 0) - (dot(e.d, p) > 0);
        }
        return filled(net) && holds_beside(f, e, X, 1) && holds_beside(f, e, X, -1);
    }

    /* Does the face pass between two of these points of the edge? */
    bool passes_somewhere(size_t f, const carrier &e, std::vector<rational> cut) const
    {
        std::sort(cut.begin(), cut.end());
        for (size_t i = 0; i + 1 < cut.size(); i++)
            if (cut[i] != cut[i + 1] && cut[i] >= 0 && cut[i + 1] <= 1 && passes(f, e, e.at((cut[i] + cut[i + 1]) / 2)))
                return true;
        return false;
    }

    /* Are two faces flat to one another, to a tenth of a degree? */
    bool flat(size_t f, size_t g) const
    {
        const std::array<double, 4> &a = rough[f], &b = rough[g];
        const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
        return x * x + y * y + z * z < 3.046e-6;
    }

    /* The faces that end at X in the edge, or in all open edges there. */
    std::vector<size_t> group_at(const carrier &e, const vec<rational> &X) const
    {
        std::vector<size_t> out;
        if (!is_open(e.key))
            return edges.at(e.key);
        for (const auto &[key, faces] : edges)
            if (is_open(key) && runs_along(key, e.key, X))
                for (size_t f : faces)
                    if (std::find(out.begin(), out.end(), f) == out.end())
                        out.push_back(f);
        std::sort(out.begin(), out.end());
        return out;
    }

    /* Does the edge pass X on the line of another one? */
    bool runs_along(const std::array<uint32_t, 2> &key, const std::array<uint32_t, 2> &other,
                    const vec<rational> &X) const
    {
        return is_on(key, X) && parallel(carrier_of(key).d, carrier_of(other).d);
    }

    /* Does X surely lie outside of the edge's box? */
    bool off_box(const std::array<uint32_t, 2> &key, const vec<rational> &X) const
    {
        const roberts_vec3 &a = o.mesh.vertex[key[0]], &b = o.mesh.vertex[key[1]];
        const auto beside = [](double p, double q, const rational &x) {
            return x.approx().sup() < std::min(p, q) || x.approx().inf() > std::max(p, q);
        };
        return beside(a.x, b.x, X.x) || beside(a.y, b.y, X.y) || beside(a.z, b.z, X.z);
    }

    bool is_on(const std::array<uint32_t, 2> &key, const vec<rational> &X) const
    {
        if (off_box(key, X))
            return false;
        const carrier e = carrier_of(key);
        const vec<rational> p = minus(X, e.a), c = cross(e.d, p);
        const rational t = dot(e.d, p);
        return c.x == 0 && c.y == 0 && c.z == 0 && t > 0 && t < dot(e.d, e.d);
    }

    /* Is the edge left out at X? Its faces end there on both sides in the picture, and are flat to one another. */
    bool left_out(const std::vector<size_t> &group, const carrier &e, const vec<rational> &X) const
    {
        const roberts_vec3 V{o.view.x, o.view.y, o.view.z};
        vec<rational> v = sub<rational>(V, roberts_vec3{0, 0, 0});
        if (o.view.w)
            v = minus(v, X);
        int left = 0, right = 0, count = 0;
        for (size_t f : group) {
            const int way = first[f] == f ? ends_at(f, e, X) : 0;
            const bool both = first[f] == f && way == 0 && passes(f, e, X);
            if (way == 0 && !both)
                continue;
            const int side = way * sign_of(dot(cross(e.d, cross(o.faces[f].normal, e.d)), v));
            left += both || side > 0;
            right += both || side < 0;
            count += both ? 2 : 1;
            if (!flat(group[0], f))
                return false;
        }
        return count > 1 && (left > 0) == (right > 0);
    }

    /* The first of the faces that ends at X, or passes it, and does not lie in the plane of g; NONE: no such face. */
    static constexpr size_t NONE = (size_t)-1;

    size_t first_across(const std::vector<size_t> &group, const carrier &e, const vec<rational> &X, size_t g) const
    {
        for (size_t f : group)
            if (first[f] == f && !o.edge_on(o.faces[f]) && (ends_at(f, e, X) != 0 || passes(f, e, X)) &&
                !in_one_plane(f, g))
                return f;
        return NONE;
    }

    /* Is the edge the first one of its group at X? `along`: all other edges on its line. */
    bool speaks(const std::array<uint32_t, 2> &key, const std::vector<std::array<uint32_t, 2>> &along,
                const vec<rational> &X) const
    {
        for (const auto &other : along)
            if (is_open(key) && other < key && is_open(other) && is_on(other, X))
                return false;
        return true;
    }

    /* Do the faces that end at X lie on both sides of g? */
    bool straddles(const std::vector<size_t> &group, const carrier &e, const vec<rational> &X, size_t g) const
    {
        bool over = false, under = false;
        for (size_t f : group) {
            const vec<rational> m = cross(o.faces[f].normal, e.d);
            const int lean = sign_of(dot(o.faces[g].normal, m)), side = ends_at(f, e, X) * lean;
            const bool both = lean != 0 && side == 0 && passes(f, e, X);
            over = over || both || side > 0;
            under = under || both || side < 0;
        }
        return over && under;
    }

    /* A part of an edge, and the point in its middle. */
    struct stretch {
        const carrier &e;
        const rational &from, &to;
        vec<rational> X;
    };

    /* Which of the ends of all edges lie on the line of this edge? [vertex] */
    std::vector<bool> ends_on_line(const carrier &e) const
    {
        std::vector<bool> out(o.mesh.vertex_count);
        std::vector<uint32_t> perhaps;
        {
            CGAL::Protect_FPU_rounding<true> upward;
            const vec<interval> a = o.at_vertex(e.key[0], interval()), b = o.at_vertex(e.key[1], interval());
            for (uint32_t v : ends) {
                const vec<interval> c = cross(minus(b, a), minus(o.at_vertex(v, interval()), a));
                if (c.x.do_overlap(0) && c.y.do_overlap(0) && c.z.do_overlap(0))
                    perhaps.push_back(v);
            }
        }
        for (uint32_t v : perhaps)
            out[v] = v == e.key[0] || v == e.key[1] || parallel(e.d, minus(place(v), e.a));
        return out;
    }

    /* What lies on one edge. */
    void seams_on(const std::array<uint32_t, 2> &key, std::vector<seam> &out) const
    {
        const carrier e = carrier_of(key);
        const std::vector<size_t> &own = edges.at(key);
        const bool open = is_open(key);
        std::vector<size_t> near;
        std::vector<std::array<uint32_t, 2>> along;
        std::vector<rational> cut{rational(0), rational(1)};
        for (size_t f = 0; f < o.faces.size(); f++)
            if (first[f] == f && !apart(f, own[0]) && in_plane(f, key[0]) && in_plane(f, key[1]))
                near.push_back(f);
        const std::vector<bool> on_line = ends_on_line(e);
        for (const auto &[other, faces] : edges)
            if (other != key && on_line[other[0]] && on_line[other[1]])
                along.push_back(other);
        /* nothing else lies along the edge */
        const auto is_own = [&own](size_t f) { return std::find(own.begin(), own.end(), f) != own.end(); };
        if (along.empty() && std::all_of(near.begin(), near.end(), is_own))
            return;
        for (size_t f : near)
            add_cuts(f, e, cut);
        std::vector<rational> divided; /* open edges divide one another at their ends */
        for (const auto &[other, faces] : edges)
            for (uint32_t v : other)
                if (on_line[v]) {
                    cut.push_back(dot(e.d, minus(place(v), e.a)) / dot(e.d, e.d));
                    if (open && is_open(other))
                        divided.push_back(cut.back());
                }
        for (size_t f : own) /* and so do the sides of a face whose border crosses itself */
            if (passes_somewhere(f, e, cut))
                add_cuts(f, e, divided);
        std::sort(cut.begin(), cut.end());
        const size_t begin = out.size();
        for (size_t i = 0; i + 1 < cut.size(); i++) {
            if (cut[i] == cut[i + 1] || cut[i] < 0 || cut[i + 1] > 1)
                continue;
            const stretch s{e, cut[i], cut[i + 1], e.at((cut[i] + cut[i + 1]) / 2)};
            const vec<rational> &X = s.X;
            const std::vector<size_t> group = group_at(e, X);
            const bool divide = std::find(divided.begin(), divided.end(), cut[i]) != divided.end();
            if (!speaks(key, along, X) || !left_out(group, e, X))
                continue;
            for (size_t g : near)
                if (std::find(group.begin(), group.end(), g) == group.end() && !o.edge_on(o.faces[g]) &&
                    holds_beside(g, e, X, 1) && holds_beside(g, e, X, -1) && !passes(g, e, X))
                    put({g}, group, s, begin, divide, out);
            for (const auto &other : along) {
                if (!(key < other) || !is_on(other, X) || (open && is_open(other)) || !speaks(other, along, X))
                    continue;
                const std::vector<size_t> theirs = group_at(carrier_of(other), X);
                if (left_out(theirs, carrier_of(other), X))
                    put(theirs, group, s, begin, divide, out);
            }
        }
    }

    static bool parallel(const vec<rational> &d, const vec<rational> &p)
    {
        const vec<interval> e = near(d), q = near(p);
        if (surely_not_zero([&] { return e.x * q.y - e.y * q.x; }) ||
            surely_not_zero([&] { return e.y * q.z - e.z * q.y; }) ||
            surely_not_zero([&] { return e.x * q.z - e.z * q.x; }))
            return false;
        return d.x * p.y == d.y * p.x && d.y * p.z == d.z * p.y && d.x * p.z == d.z * p.x;
    }

    /* Adds a stretch in which the first of `group` ends on the first of `theirs` that lies across. The seams from
     * `begin` on are of the same edge: one of the same faces that ends where this one begins is continued, unless the
     * edge is divided there. */
    void put(const std::vector<size_t> &theirs, const std::vector<size_t> &group, const stretch &s, size_t begin,
             bool divide, std::vector<seam> &out) const
    {
        size_t f = first_across(group, s.e, s.X, theirs[0]), g = theirs[0];
        if (f != NONE && theirs.size() > 1)
            g = first_across(theirs, s.e, s.X, f);
        if (f == NONE || g == NONE || !straddles(group, s.e, s.X, g) ||
            (theirs.size() > 1 && !straddles(theirs, s.e, s.X, f)))
            return;
        for (size_t k = begin; !divide && k < out.size(); k++)
            if (out[k].f == f && out[k].g == g && same(out[k].b, s.e.at(s.from))) {
                out[k].b = s.e.at(s.to);
                return;
            }
        seam own{f, g, group, s.e.at(s.from), s.e.at(s.to)};
        own.own.insert(own.own.end(), theirs.begin(), theirs.end());
        out.push_back(own);
    }

    static bool same(const vec<rational> &p, const vec<rational> &q)
    {
        return p.x == q.x && p.y == q.y && p.z == q.z;
    }

    /* All of them, each face of smaller number first, in order. */
    std::vector<seam> seams()
    {
        std::vector<seam> out;
        make_rough();
        take_edges();
        for (const auto &[key, own] : edges)
            seams_on(key, out);
        for (seam &s : out) {
            if (s.f > s.g)
                std::swap(s.f, s.g);
            if (before(s.b, s.a))
                std::swap(s.a, s.b);
        }
        return out;
    }

    /* Returns, for each face, the first one that has the same corners. */
    std::vector<size_t> first_alike() const
    {
        const std::vector<uint32_t> name = vertex_names();
        std::map<std::vector<uint32_t>, size_t> known;
        std::vector<size_t> out;
        for (const polygon &f : o.faces) {
            std::vector<uint32_t> least, corners;
            for (uint32_t i = o.mesh.face_start[f.number]; i < o.mesh.face_start[f.number + 1]; i++)
                if (corners.empty() || corners.back() != name[o.mesh.corner[i]])
                    corners.push_back(name[o.mesh.corner[i]]);
            while (corners.size() > 1 && corners.front() == corners.back())
                corners.pop_back();
            for (int way = 0; way < 2; way++)
                for (size_t i = 0; i < corners.size(); i++) {
                    std::vector<uint32_t> c(corners);
                    if (way)
                        std::reverse(c.begin(), c.end());
                    std::rotate(c.begin(), c.begin() + (long)i, c.end());
                    if (least.empty() || c < least)
                        least = c;
                }
            out.push_back(known.emplace(least, out.size()).first->second);
        }
        return out;
    }

    std::vector<crossing> find()
    {
        std::vector<crossing> out;
        for (size_t f = 0; f < o.faces.size(); f++)
            for (size_t g = f + 1; first[f] == f && g < o.faces.size(); g++)
                if (first[g] == g)
                    cross_pair(f, g, out);
        for (crossing &c : out)
            if (before(c.b, c.a))
                std::swap(c.a, c.b);
        std::sort(out.begin(), out.end(), [](const crossing &x, const crossing &y) {
            return std::tie(x.f, x.g) != std::tie(y.f, y.g) ? std::tie(x.f, x.g) < std::tie(y.f, y.g)
                                                            : before(x.a, y.a);
        });
        return out;
    }
};

} // namespace

#endif
