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

bool before(const vec<rational> &p, const vec<rational> &q)
{
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

struct cross_finder {
    const mesh_oracle &o;
    size_t pairs = 0;

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
    std::vector<size_t> first; /* see first_alike() */

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
            vec<N> n = o.newell<N>(g);
            bool over = false, under = false;
            for (uint32_t v : f.corner) {
                int sign = o.has(g, v) ? 0 : sign_of(o.height(g, n, o.mesh.vertex[v]));
                over = over || sign > 0;
                under = under || sign < 0;
            }
            return !over || !under;
        });
    }

    profile profile_of(const polygon &f, const polygon &g, const vec<rational> &along) const
    {
        const roberts_vec3 zero{0, 0, 0};
        profile out;
        vec<rational> n = o.newell<rational>(g);
        for (const auto &side : f.side) {
            vec<rational> p = sub<rational>(o.mesh.vertex[side[0]], zero);
            vec<rational> q = sub<rational>(o.mesh.vertex[side[1]], zero);
            rational hp = o.has(g, side[0]) ? rational(0) : o.height(g, n, p);
            rational hq = o.has(g, side[1]) ? rational(0) : o.height(g, n, q);
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
        pairs++;
        if (beside(F, G) || beside(G, F))
            return;
        vec<rational> along = cross(o.newell<rational>(F), o.newell<rational>(G));
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

    /* A piece of a flat edge that lies in face f. */
    struct seam {
        size_t f;
        std::vector<size_t> own; /* faces of the edge, followed by f */
        vec<rational> a, b;
    };

    /* Finds on which side of the edge from a along d the corners of a face lie, within its plane. 0: on both. */
    int side_of(const polygon &f, const vec<rational> &n, const vec<rational> &a, const vec<rational> &d) const
    {
        vec<rational> m = cross(n, d);
        int side = 0;
        for (uint32_t v : f.corner) {
            const vec<rational> p = sub<rational>(o.mesh.vertex[v], roberts_vec3{0, 0, 0});
            int sign = sign_of(rational(dot(m, vec<rational>{p.x - a.x, p.y - a.y, p.z - a.z})));
            if (sign != 0 && side != 0 && sign != side)
                return 0;
            side = sign != 0 ? sign : side;
        }
        return side;
    }

    void seam_in(size_t f, uint32_t va, uint32_t vb, const std::vector<size_t> &own, std::vector<seam> &out) const
    {
        const polygon &F = o.faces[f], &W = o.faces[own[0]];
        const roberts_vec3 zero{0, 0, 0};
        const vec<rational> a = sub<rational>(o.mesh.vertex[va], zero), b = sub<rational>(o.mesh.vertex[vb], zero);
        const vec<rational> n = o.newell<rational>(F), along = cross(n, o.newell<rational>(W));
        if ((along.x == 0 && along.y == 0 && along.z == 0) || o.height(F, n, a) != 0 || o.height(F, n, b) != 0)
            return;
        profile p = profile_of(F, W, along);
        p.meetings.push_back({dot(along, a), a, 0, 0});
        p.meetings.push_back({dot(along, b), b, 0, 0});
        rational low = std::min(dot(along, a), dot(along, b)), high = std::max(dot(along, a), dot(along, b));
        std::vector<meeting> cut(p.meetings);
        std::sort(cut.begin(), cut.end(), [](const meeting &x, const meeting &y) { return x.s < y.s; });
        for (size_t i = 0; i + 1 < cut.size(); i++) {
            if (cut[i].s == cut[i + 1].s || cut[i].s < low || cut[i + 1].s > high)
                continue;
            if (!goes_on(p, (cut[i].s + cut[i + 1].s) / 2))
                continue;
            seam s{f, own, cut[i].at, cut[i + 1].at};
            s.own.push_back(f);
            out.push_back(s);
        }
    }

    std::vector<seam> seams() const
    {
        std::vector<seam> out;
        for (const auto &[key, own] : o.edges) {
            if (own.size() != 2 || o.faces[own[0]].corner.size() > 4 || o.faces[own[1]].corner.size() > 4)
                continue;
            const vec<rational> n = o.newell<rational>(o.faces[own[0]]), m = o.newell<rational>(o.faces[own[1]]);
            const vec<rational> bend = cross(n, m), a = sub<rational>(o.mesh.vertex[key[0]], roberts_vec3{0, 0, 0});
            const vec<rational> d = sub<rational>(o.mesh.vertex[key[1]], o.mesh.vertex[key[0]]);
            if (bend.x != 0 || bend.y != 0 || bend.z != 0)
                continue;
            if (side_of(o.faces[own[0]], n, a, d) * side_of(o.faces[own[1]], n, a, d) >= 0)
                continue;
            for (size_t f = 0; f < o.faces.size(); f++)
                if (f != own[0] && f != own[1] && !apart(f, own[0]) && !apart(f, own[1]))
                    seam_in(f, key[0], key[1], own, out);
        }
        return out;
    }

    /* Returns, for each face, the first one that has the same corners. */
    std::vector<size_t> first_alike() const
    {
        std::map<std::vector<uint32_t>, size_t> known;
        std::vector<size_t> out;
        for (const polygon &f : o.faces) {
            std::vector<uint32_t> least;
            for (int way = 0; way < 2; way++)
                for (size_t i = 0; i < f.corner.size(); i++) {
                    std::vector<uint32_t> c(f.corner);
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
