/* cross_oracle.cpp - see cross_oracle.h. */
#include "cross_oracle.h"

#include "cross_exact.h"

#include <cstdio>
#include <cstring>

namespace
{

/* ---- how clear an answer is, in doubles ---- */

struct doubles {
    double x, y, z;

    doubles operator-(const doubles &o) const
    {
        return {x - o.x, y - o.y, z - o.z};
    }
};

double times(const doubles &a, const doubles &b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

doubles across(const doubles &a, const doubles &b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double size_of(const doubles &a)
{
    return std::sqrt(times(a, a));
}

struct plain_face {
    std::vector<doubles> corner;
    doubles n{0, 0, 0}, middle{0, 0, 0}; /* n: of length 1; 0 where the face is thin */

    plain_face(const roberts_mesh &mesh, uint32_t f)
    {
        for (uint32_t i = mesh.face_start[f]; i < mesh.face_start[f + 1]; i++) {
            const roberts_vec3 &p = mesh.vertex[mesh.corner[i]];
            corner.push_back({p.x, p.y, p.z});
        }
        double count = (double)corner.size(), widest = 0;
        for (const doubles &p : corner) {
            middle = {middle.x + p.x / count, middle.y + p.y / count, middle.z + p.z / count};
            for (const doubles &q : corner) {
                doubles c = across(p - corner[0], q - corner[0]);
                if (size_of(c) > widest)
                    widest = size_of(c), n = c;
            }
        }
        if (widest > 0)
            n = {n.x / widest, n.y / widest, n.z / widest};
    }

    double height(const doubles &X) const
    {
        return times(n, X - middle);
    }

    /* Is X in the face, as seen along its normal, and how far from the border? */
    bool inside(const doubles &X, bool even_odd, double *border) const
    {
        doubles e = std::fabs(n.z) < 0.9 ? doubles{0, 0, 1} : doubles{0, 1, 0}, u = across(e, n);
        double l = size_of(u);
        u = {u.x / l, u.y / l, u.z / l};
        doubles v = across(n, u);
        long winding = 0;
        *border = HUGE_VAL;
        for (size_t i = 0; i < corner.size(); i++) {
            doubles p = corner[i] - X, q = corner[(i + 1) % corner.size()] - X;
            double px = times(p, u), py = times(p, v), qx = times(q, u), qy = times(q, v);
            double dx = qx - px, dy = qy - py, d = dx * dx + dy * dy;
            double s = d > 0 ? std::min(1.0, std::max(0.0, -(px * dx + py * dy) / d)) : 0;
            *border = std::min(*border, std::hypot(px + s * dx, py + s * dy));
            double turn = dx * -py + dy * px;
            if (py <= 0 && qy > 0)
                winding += turn > 0;
            else if (qy <= 0 && py > 0)
                winding -= turn < 0;
        }
        return even_odd ? winding % 2 != 0 : winding != 0;
    }
};

} // namespace

bool cross_truth_find(const roberts_mesh *mesh, const oracle_view *view, bool even_odd, cross_truth *truth)
{
    std::memset(truth, 0, sizeof *truth);
    try {
        mesh_oracle o(*mesh, *view, even_odd);
        cross_finder finder(o);
        std::vector<cross_line> lines;
        std::vector<oracle_interval> intervals;
        for (const crossing &c : finder.find()) {
            const spot a = o.spot_of(c.a), b = o.spot_of(c.b);
            std::vector<oracle_interval> hidden = o.hide(a, b, {c.f, c.g});
            bool edge_on = o.edge_on(o.faces[c.f]) || o.edge_on(o.faces[c.g]);
            lines.push_back({o.faces[c.f].number, o.faces[c.g].number, nearest(c.a), nearest(c.b), edge_on, false,
                             intervals.size(), hidden.size()});
            intervals.insert(intervals.end(), hidden.begin(), hidden.end());
        }
        for (const cross_finder::seam &s : finder.seams()) {
            std::vector<oracle_interval> hidden = o.hide(o.spot_of(s.a), o.spot_of(s.b), s.own);
            lines.push_back({o.faces[s.f].number, o.faces[s.g].number, nearest(s.a), nearest(s.b), false, true,
                             intervals.size(), hidden.size()});
            intervals.insert(intervals.end(), hidden.begin(), hidden.end());
        }
        std::stable_sort(lines.begin(), lines.end(), [](const cross_line &x, const cross_line &y) {
            return std::tie(x.f0, x.f1, x.a.x, x.a.y, x.a.z) < std::tie(y.f0, y.f1, y.a.x, y.a.y, y.a.z);
        });
        std::vector<uint32_t> same(mesh->face_count, ROBERTS_NONE);
        for (size_t f = 0; f < o.faces.size(); f++)
            same[o.faces[f].number] = o.faces[finder.first[f]].number;
        truth->same = copy_of(same);
        truth->line_count = lines.size(), truth->interval_count = intervals.size();
        truth->line = copy_of(lines);
        truth->interval = copy_of(intervals);
        return true;
    } catch (const std::exception &e) {
        cross_truth_free(truth);
        std::snprintf(truth->error, sizeof truth->error, "%s", e.what());
        return false;
    }
}

void cross_truth_free(cross_truth *truth)
{
    std::free(truth->line);
    std::free(truth->interval);
    std::free(truth->same);
    std::memset(truth, 0, sizeof *truth);
}

oracle_answer cross_truth_at(const roberts_mesh *mesh, bool even_odd, uint32_t f0, uint32_t f1, roberts_vec3 X,
                             double slack)
{
    const plain_face f(*mesh, f0), g(*mesh, f1);
    const doubles P{X.x, X.y, X.z};
    double lean = size_of(across(f.n, g.n)), reach = 4 * slack * (1 + 1 / lean), in_f, in_g;
    if (!(lean > 1e-6))
        return ORACLE_UNSURE;
    bool inside_f = f.inside(P, even_odd, &in_f), inside_g = g.inside(P, even_odd, &in_g);
    double off = std::max(std::fabs(f.height(P)), std::fabs(g.height(P)));
    if (off > reach || (!inside_f && in_f > reach) || (!inside_g && in_g > reach))
        return ORACLE_NO;
    return inside_f && inside_g && in_f > reach && in_g > reach ? ORACLE_YES : ORACLE_UNSURE;
}
