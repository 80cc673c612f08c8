/* union_oracle.cpp - see union_oracle.h. A line is cut where it meets any face. At the middle of each piece, the
 * angles that the bodies fill are computed. For a convex body, the planes of its faces through the point give the
 * angle. For any other body, the planes through the line divide its surroundings into sectors, and a point beside the
 * line in each sector is tested: is it inside? */
#include "union_oracle.h"

#include "cross_exact.h"

#include <cstdio>
#include <cstring>
#include <numeric>

namespace
{

using point3 = vec<rational>;

point3 plus(const point3 &p, const rational &t, const point3 &d)
{
    return {p.x + t * d.x, p.y + t * d.y, p.z + t * d.z};
}

bool is_zero(const point3 &d)
{
    return d.x == 0 && d.y == 0 && d.z == 0;
}

struct direction {
    rational x, y; /* in the plane across the line */
};

rational turn(const direction &p, const direction &q)
{
    return p.x * q.y - p.y * q.x;
}

/* Is the angle of a direction 180 degrees or more? */
bool lower(const direction &d)
{
    return d.y < 0 || (d.y == 0 && d.x < 0);
}

bool by_angle(const direction &p, const direction &q)
{
    return lower(p) != lower(q) ? lower(q) : turn(p, q) > 0;
}

bool same_angle(const direction &p, const direction &q)
{
    return !by_angle(p, q) && !by_angle(q, p);
}

struct closed_body {
    std::vector<size_t> face;
    bool convex;
    double low[3], high[3];
};

struct line_at_hand {
    spot a, b;
    std::vector<size_t> own;
    double low[3], high[3]; /* its box, with a margin */
};

struct union_finder {
    const roberts_mesh &mesh;
    const oracle_view &view;
    mesh_oracle o;
    std::vector<point3> vertex;
    std::vector<point3> normal; /* [face]; points outward for convex bodies */
    std::vector<closed_body> solids;
    std::vector<std::tuple<uint32_t, uint32_t, std::vector<size_t>>> edges;
    std::vector<std::array<double, 6>> face_box;
    double margin = 0;
    size_t asked = 0;

    union_finder(const roberts_mesh &m, const oracle_view &v) : mesh(m), view(v), o(m, v, false)
    {
        const roberts_vec3 zero{0, 0, 0};
        for (uint32_t i = 0; i < mesh.vertex_count; i++) {
            vertex.push_back(sub<rational>(mesh.vertex[i], zero));
            margin = std::max(
                {margin, std::fabs(mesh.vertex[i].x), std::fabs(mesh.vertex[i].y), std::fabs(mesh.vertex[i].z)});
        }
        margin *= 1e-9;
        for (const polygon &f : o.faces) {
            normal.push_back(o.newell<rational>(f));
            std::array<double, 6> box{HUGE_VAL, HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
            for (uint32_t v0 : f.corner) {
                const roberts_vec3 &p = mesh.vertex[v0];
                const double x[3] = {p.x, p.y, p.z};
                for (size_t k = 0; k < 3; k++) {
                    box[k] = std::min(box[k], x[k] - margin);
                    box[k + 3] = std::max(box[k + 3], x[k] + margin);
                }
            }
            face_box.push_back(box);
        }
        take_solids();
    }

    void take_solids()
    {
        std::map<std::array<uint32_t, 2>, std::vector<size_t>> at;
        std::vector<size_t> root(o.faces.size());
        std::iota(root.begin(), root.end(), (size_t)0);
        auto find = [&](size_t f) {
            while (root[f] != f)
                f = root[f];
            return f;
        };
        for (size_t f = 0; f < o.faces.size(); f++) {
            uint32_t start = mesh.face_start[o.faces[f].number], end = mesh.face_start[o.faces[f].number + 1];
            for (uint32_t i = start; i < end; i++) {
                uint32_t p = mesh.corner[i], q = mesh.corner[i + 1 < end ? i + 1 : start];
                at[{std::min(p, q), std::max(p, q)}].push_back(f);
            }
        }
        for (const auto &[key, own] : at) {
            if (own.size() != 2 || own[0] == own[1])
                throw std::runtime_error("a body is not closed");
            root[find(own[0])] = find(own[1]);
            edges.emplace_back(key[0], key[1], own);
        }
        std::map<size_t, size_t> index;
        for (size_t f = 0; f < o.faces.size(); f++) {
            auto [where, fresh] = index.emplace(find(f), solids.size());
            if (fresh)
                solids.push_back({{}, true, {HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}});
            closed_body &s = solids[where->second];
            s.face.push_back(f);
            for (size_t k = 0; k < 3; k++) {
                s.low[k] = std::min(s.low[k], face_box[f][k]);
                s.high[k] = std::max(s.high[k], face_box[f][k + 3]);
            }
        }
        for (closed_body &s : solids)
            turn_outward(s);
    }

    void turn_outward(closed_body &s)
    {
        for (size_t f : s.face) {
            int side = 0;
            for (size_t g : s.face)
                for (uint32_t v : o.faces[g].corner) {
                    int sign = sign_of(height(f, vertex[v]));
                    if (sign != 0 && side != 0 && sign != side)
                        s.convex = false;
                    side = sign != 0 ? sign : side;
                }
            if (side > 0)
                normal[f] = {-normal[f].x, -normal[f].y, -normal[f].z};
        }
    }

    rational height(size_t f, const point3 &X) const
    {
        return dot(normal[f], minus(X, vertex[o.faces[f].corner[0]]));
    }

    /* Does a point of a face's plane lie in the face? -1: beside it, 0: on its border, 1: inside. */
    int in_face(size_t f, const point3 &X) const
    {
        const point3 &n = normal[f];
        double ax = std::fabs(CGAL::to_double(n.x)), ay = std::fabs(CGAL::to_double(n.y));
        double az = std::fabs(CGAL::to_double(n.z));
        int drop = az >= ax && az >= ay ? 2 : ay >= ax ? 1 : 0;
        auto flat = [drop](const point3 &p) {
            return drop == 2 ? direction{p.x, p.y} : drop == 1 ? direction{p.x, p.z} : direction{p.y, p.z};
        };
        const direction P = flat(X);
        bool inside = false;
        for (const auto &side : o.faces[f].side) {
            direction p = flat(vertex[side[0]]), q = flat(vertex[side[1]]);
            direction a{p.x - P.x, p.y - P.y}, b{q.x - P.x, q.y - P.y};
            rational c = turn(a, b);
            if (c == 0 && a.x * b.x + a.y * b.y <= 0)
                return 0;
            if ((a.y > 0) != (b.y > 0) && (c > 0) == (b.y > 0))
                inside = !inside;
        }
        return inside ? 1 : -1;
    }

    /* Is a point that lies in no face inside the body? Casts a ray that meets no border. */
    bool inside(const closed_body &s, const point3 &X) const
    {
        static const int ways[][3] = {{101, 37, 11}, {-13, 97, 29}, {7, -31, 89}, {-61, 5, -83}, {43, 71, -67}};
        for (const auto &way : ways) {
            const point3 d{rational(way[0]), rational(way[1]), rational(way[2])};
            bool in = false, clear = true;
            for (size_t i = 0; clear && i < s.face.size(); i++) {
                size_t f = s.face[i];
                rational h = height(f, X), rate = dot(normal[f], d);
                if (rate == 0) {
                    clear = h != 0;
                    continue;
                }
                rational t = -h / rate;
                if (t < 0)
                    continue;
                int there = in_face(f, plus(X, t, d));
                clear = there != 0 && (t != 0 || there < 0);
                in = in != (there > 0);
            }
            if (clear)
                return in;
        }
        throw std::runtime_error("no ray is clear");
    }

    /* ---- one line ---- */

    line_at_hand take_line(const spot &a, const spot &b, const std::vector<size_t> &own) const
    {
        line_at_hand l{a, b, own, {}, {}};
        const rational *p[3] = {&a.at.x, &a.at.y, &a.at.z}, *q[3] = {&b.at.x, &b.at.y, &b.at.z};
        for (int k = 0; k < 3; k++) {
            double x = CGAL::to_double(*p[k]), y = CGAL::to_double(*q[k]);
            l.low[k] = std::min(x, y) - margin;
            l.high[k] = std::max(x, y) + margin;
        }
        return l;
    }

    std::vector<rational> cuts(const line_at_hand &l) const
    {
        std::vector<rational> cut{rational(0), rational(1)};
        const point3 &A = l.a.at, d = minus(l.b.at, l.a.at);
        rational dd = dot(d, d);
        for (size_t f = 0; f < o.faces.size(); f++) {
            bool apart = false;
            for (size_t k = 0; k < 3; k++)
                apart = apart || l.high[k] < face_box[f][k] || l.low[k] > face_box[f][k + 3];
            if (apart)
                continue;
            rational ga = height(f, A), gb = height(f, l.b.at);
            int sa = sign_of(ga), sb = sign_of(gb);
            if (sa * sb < 0)
                cut.push_back(ga / (ga - gb));
            if (sa != 0 || sb != 0)
                continue;
            point3 m = cross(normal[f], d);
            for (const auto &side : o.faces[f].side) {
                point3 p = minus(vertex[side[0]], A), q = minus(vertex[side[1]], A);
                rational hp = dot(m, p), hq = dot(m, q);
                if (hp == 0 && hq == 0) {
                    cut.push_back(dot(p, d) / dd);
                    cut.push_back(dot(q, d) / dd);
                } else if (sign_of(hp) * sign_of(hq) <= 0) {
                    cut.push_back(dot(plus(p, hp / (hp - hq), minus(q, p)), d) / dd);
                }
            }
        }
        std::sort(cut.begin(), cut.end());
        cut.erase(std::unique(cut.begin(), cut.end()), cut.end());
        cut.erase(std::remove_if(cut.begin(), cut.end(), [](const rational &t) { return t < 0 || t > 1; }), cut.end());
        return cut;
    }

    /* A body at a point: the point is in some of its faces, or inside it. All other bodies are left out. */
    struct presence {
        const closed_body *s;
        std::vector<size_t> face;
    };

    /* False: the point is inside some body. */
    bool bodies_at(const point3 &X, std::vector<presence> &out) const
    {
        const double x[3] = {CGAL::to_double(X.x), CGAL::to_double(X.y), CGAL::to_double(X.z)};
        for (const closed_body &s : solids) {
            bool apart = false;
            for (int k = 0; k < 3; k++)
                apart = apart || x[k] < s.low[k] || x[k] > s.high[k];
            if (apart)
                continue;
            presence here{&s, {}};
            bool out_of = false;
            for (size_t i = 0; !out_of && i < s.face.size(); i++) {
                size_t f = s.face[i];
                int sign = sign_of(height(f, X));
                out_of = s.convex && sign > 0;
                if (sign == 0 && (s.convex || in_face(f, X) >= 0))
                    here.face.push_back(f);
            }
            if (out_of)
                continue;
            if (here.face.empty()) {
                if (s.convex || inside(s, X))
                    return false;
                continue;
            }
            out.push_back(here);
        }
        return true;
    }

    /* Does a convex body fill the sector that `way` leads into? */
    bool fills(const presence &p, const point3 &way) const
    {
        bool all = true;
        for (size_t f : p.face)
            all = all && dot(normal[f], way) < 0;
        return all;
    }

    /* Does any body fill the sector between r and s? The test point is moved a little along d, too, so that it lies in
     * no plane across the line. */
    bool fills_any(const presence &p, const point3 &X, const point3 &r, const point3 &s, const point3 &d) const
    {
        static const int mix[][3] = {{1, 1, 1}, {1, 2, 3}, {3, 2, -1}, {2, 5, 2}, {7, 3, -5}, {4, 9, 7}};
        for (const auto &m : mix) {
            point3 way = plus(plus({r.x * m[0], r.y * m[0], r.z * m[0]}, rational(m[1]), s), rational(m[2]) / 64, d);
            rational step(1);
            bool clear = true;
            for (size_t f : p.s->face) {
                rational h = height(f, X), rate = dot(normal[f], way);
                if (h == 0 && rate == 0)
                    clear = false;
                else if (h != 0 && rate != 0 && -h / rate > 0)
                    step = std::min(step, rational(-h / rate / 2));
            }
            if (clear)
                return inside(*p.s, plus(X, step, way));
        }
        throw std::runtime_error("no way into a sector is clear");
    }

    /* What the bodies fill around X, a point of a line with direction d. -1: the line is not drawn there. */
    int class_at(const point3 &X, const point3 &d)
    {
        asked++;
        std::vector<presence> bodies;
        if (!bodies_at(X, bodies))
            return -1;
        /* two vectors across d */
        point3 e1 =
            d.x != 0 || d.y != 0 ? point3{d.y, -d.x, rational(0)} : point3{rational(1), rational(0), rational(0)};
        point3 e2 = cross(d, e1);
        rational n1 = dot(e1, e1), n2 = dot(e2, e2);
        std::vector<direction> ray;
        for (const presence &p : bodies)
            for (size_t f : p.face) {
                point3 r = cross(normal[f], d);
                if (is_zero(r) || dot(normal[f], d) != 0)
                    throw std::runtime_error("a piece of a line is not cut where it meets a face");
                rational x = dot(r, e1) / n1, y = dot(r, e2) / n2;
                ray.push_back({x, y});
                ray.push_back({-x, -y});
            }
        std::sort(ray.begin(), ray.end(), by_angle);
        ray.erase(std::unique(ray.begin(), ray.end(), same_angle), ray.end());
        size_t n = ray.size();
        std::vector<bool> full(n, false);
        auto in_space = [&](const direction &r) { return plus({r.x * e1.x, r.x * e1.y, r.x * e1.z}, r.y, e2); };
        for (size_t i = 0; i < n; i++) {
            direction r = ray[i], s = ray[(i + 1) % n];
            if (turn(r, s) <= 0) /* half a turn: take the middle instead of the end */
                s = {-r.y, r.x};
            point3 R = in_space(r), S = in_space(s), way = plus(R, rational(1), S);
            for (const presence &p : bodies)
                full[i] = full[i] || (p.s->convex ? fills(p, way) : fills_any(p, X, R, S, d));
        }
        std::vector<size_t> side; /* rays that bound the filled sectors */
        for (size_t i = 0; i < n; i++)
            if (full[i] != full[(i + n - 1) % n])
                side.push_back(i);
        if (side.empty() || (side.size() == 2 && turn(ray[side[0]], ray[side[1]]) == 0))
            return -1;
        if (side.size() > 2)
            return UNION_OPEN;
        point3 V{rational(view.x), rational(view.y), rational(view.z)};
        if (view.w)
            V = minus(V, X);
        direction to_viewer{dot(V, e1) / n1, dot(V, e2) / n2};
        int s0 = sign_of(turn(to_viewer, ray[side[0]])), s1 = sign_of(turn(to_viewer, ray[side[1]]));
        return s0 * s1 >= 0 ? UNION_OUTLINE : UNION_CREASE;
    }

    std::vector<union_part> drawn(const line_at_hand &l)
    {
        std::vector<union_part> out;
        std::vector<rational> cut = cuts(l);
        const point3 d = minus(l.b.at, l.a.at);
        bool joined = false;
        for (size_t i = 0; i + 1 < cut.size(); i++) {
            int c = class_at(plus(l.a.at, (cut[i] + cut[i + 1]) / 2, d), d);
            if (c < 0) {
                joined = false;
                continue;
            }
            if (joined && out.back().class_ == c)
                out.back().t1 = rounded(cut[i + 1]);
            else
                out.push_back({rounded(cut[i]), rounded(cut[i + 1]), (union_class)c});
            joined = true;
        }
        return out;
    }
};

} // namespace

bool union_truth_find(const roberts_mesh *mesh, const oracle_view *view, union_truth *truth)
{
    std::memset(truth, 0, sizeof *truth);
    try {
        union_finder u(*mesh, *view);
        std::vector<union_line> lines;
        std::vector<union_part> parts;
        std::vector<oracle_interval> intervals;
        auto add = [&](const spot &a, const spot &b, const std::vector<size_t> &own, bool crossing) {
            bool edge_on = u.o.edge_on(u.o.faces[own[0]]) || u.o.edge_on(u.o.faces[own[1]]);
            std::vector<union_part> part = u.drawn(u.take_line(a, b, own));
            std::vector<oracle_interval> hidden;
            if (!part.empty())
                hidden = u.o.hide(a, b, own);
            lines.push_back({nearest(a.at), nearest(b.at), crossing, edge_on, parts.size(), part.size(),
                             intervals.size(), hidden.size()});
            parts.insert(parts.end(), part.begin(), part.end());
            intervals.insert(intervals.end(), hidden.begin(), hidden.end());
        };
        for (const auto &[v0, v1, own] : u.edges)
            add(u.o.spot_of(u.o.position[v0]), u.o.spot_of(u.o.position[v1]), own, false);
        for (const crossing &c : cross_finder(u.o).find())
            add(u.o.spot_of(c.a), u.o.spot_of(c.b), {c.f, c.g}, true);
        truth->line_count = lines.size(), truth->part_count = parts.size();
        truth->interval_count = intervals.size(), truth->asked = u.asked;
        truth->line = copy_of(lines);
        truth->part = copy_of(parts);
        truth->interval = copy_of(intervals);
        return true;
    } catch (const std::exception &e) {
        union_truth_free(truth);
        std::snprintf(truth->error, sizeof truth->error, "%s", e.what());
        return false;
    }
}

void union_truth_free(union_truth *truth)
{
    std::free(truth->line);
    std::free(truth->part);
    std::free(truth->interval);
    std::memset(truth, 0, sizeof *truth);
}
