/* mesh_oracle.cpp - see mesh_oracle.h. */
#include "mesh_oracle.h"

#include "mesh_exact.h"

#include <cstdio>
#include <cstring>

namespace
{

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
            std::vector<oracle_interval> hidden = o.hide(o.spot_of(key[0]), o.spot_of(key[1]), own);
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
                            const mesh_point *point, double slack)
{
    plain X{point->at.x, point->at.y, point->at.z};
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
            own0 = own0 || c == point->v0;
            own1 = own1 || c == point->v1;
        }
        if (q.size() < 3 || (own0 && own1) || f == point->f0 || f == point->f1)
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
