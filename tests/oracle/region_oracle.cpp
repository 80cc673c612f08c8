/* region_oracle.cpp - see region_oracle.h. */
#include "region_oracle.h"

#include "cross_exact.h"

#include <cstdio>
#include <cstring>

namespace
{

/* How near a face is to the viewer at a point of the picture: a x + b y + c, greater where it is nearer. */
template <class N> struct nearness {
    N a, b, c;

    N at(const N &x, const N &y) const
    {
        return a * x + b * y + c;
    }
};

/* A side, or a line in which faces cross, in the picture. */
struct line {
    point2<rational> A, B;
    point2<interval> near_A, near_B;
    rational zA, zB; /* how near to the viewer its ends are, as in nearness */
    uint32_t a, b;   /* vertices; ROBERTS_NONE: none */
    double x0, x1, y0, y1;
    std::vector<rational> cut;
    std::vector<size_t> along; /* lines that lie on this one in part, including itself */

    const point2<interval> &from(interval) const
    {
        return near_A;
    }
    const point2<rational> &from(rational) const
    {
        return A;
    }
    const point2<interval> &to(interval) const
    {
        return near_B;
    }
    const point2<rational> &to(rational) const
    {
        return B;
    }
};

struct region_finder {
    const mesh_oracle &o;
    const uint32_t *rank;
    std::vector<line> lines;
    std::map<std::array<uint32_t, 2>, size_t> line_of;
    std::vector<bool> counts;                   /* [faces] not edge-on, and not repeated */
    std::vector<std::vector<size_t>> side_line; /* [faces][sides] */
    std::vector<nearness<rational>> exact_nearness;
    std::vector<nearness<interval>> near_nearness;
    std::vector<region_piece> pieces;
    size_t questions = 0, exact = 0;

    static constexpr size_t NONE = (size_t)-1;

    region_finder(const mesh_oracle &oracle, const uint32_t *r) : o(oracle), rank(r)
    {
    }

    /* ---- faces ---- */

    const vec<rational> &place_of(uint32_t v) const
    {
        return o.place[v];
    }

    rational nearness_of(const vec<rational> &X) const
    {
        const roberts_vec3 zero{0, 0, 0}, V{o.view.x, o.view.y, o.view.z};
        return o.view.w ? rational(rational(1) / o.project(X).w) : dot(X, sub<rational>(V, zero));
    }

    /* By three corners that are not in line in the picture. */
    nearness<rational> nearness_of(const polygon &f) const
    {
        const point2<rational> &p = o.flat_exact[f.corner[0]];
        const rational zp = nearness_of(place_of(f.corner[0]));
        for (size_t i = 1; i + 1 < f.corner.size(); i++)
            for (size_t k = i + 1; k < f.corner.size(); k++) {
                const point2<rational> &q = o.flat_exact[f.corner[i]], &r = o.flat_exact[f.corner[k]];
                const rational ux = q.x - p.x, uy = q.y - p.y, vx = r.x - p.x, vy = r.y - p.y, turn = ux * vy - uy * vx;
                if (turn == 0)
                    continue;
                const rational uz = nearness_of(place_of(f.corner[i])) - zp,
                               vz = nearness_of(place_of(f.corner[k])) - zp;
                const rational a = (uz * vy - vz * uy) / turn, b = (ux * vz - vx * uz) / turn;
                return {a, b, zp - a * p.x - b * p.y};
            }
        throw std::runtime_error("a face without area in the picture");
    }

    void take_face(size_t f, size_t first)
    {
        const polygon &face = o.faces[f];
        counts.push_back(first == f && !o.edge_on(face));
        exact_nearness.push_back(counts[f] ? nearness_of(face)
                                           : nearness<rational>{rational(0), rational(0), rational(0)});
        const nearness<rational> &e = exact_nearness[f];
        near_nearness.push_back({mesh_oracle::around(e.a), mesh_oracle::around(e.b), mesh_oracle::around(e.c)});
        side_line.emplace_back();
        for (const auto &side : face.side)
            side_line[f].push_back(take_side(side[0], side[1]));
    }

    /* ---- lines ---- */

    size_t take_side(uint32_t p, uint32_t q)
    {
        const std::array<uint32_t, 2> key{std::min(p, q), std::max(p, q)};
        const auto known = line_of.find(key);
        if (known != line_of.end())
            return known->second;
        const size_t index = take_line(place_of(key[0]), place_of(key[1]), key[0], key[1]);
        line_of[key] = index;
        return index;
    }

    static point2<interval> around(const point2<rational> &p)
    {
        return {mesh_oracle::around(p.x), mesh_oracle::around(p.y), mesh_oracle::around(p.w)};
    }

    /* NONE: it is a point in the picture. */
    size_t take_line(const vec<rational> &from, const vec<rational> &to, uint32_t a, uint32_t b)
    {
        const point2<rational> A = a != ROBERTS_NONE ? o.flat_exact[a] : o.project(from);
        const point2<rational> B = b != ROBERTS_NONE ? o.flat_exact[b] : o.project(to);
        if (A.x == B.x && A.y == B.y)
            return NONE;
        const point2<interval> P = around(A), Q = around(B);
        lines.push_back({A,
                         B,
                         P,
                         Q,
                         nearness_of(from),
                         nearness_of(to),
                         a,
                         b,
                         std::min(P.x.inf(), Q.x.inf()) - o.margin,
                         std::max(P.x.sup(), Q.x.sup()) + o.margin,
                         std::min(P.y.inf(), Q.y.inf()) - o.margin,
                         std::max(P.y.sup(), Q.y.sup()) + o.margin,
                         {rational(0), rational(1)},
                         {lines.size()}});
        return lines.size() - 1;
    }

    static rational along(const line &l, const point2<rational> &p)
    {
        return l.A.x != l.B.x ? rational((p.x - l.A.x) / (l.B.x - l.A.x)) : rational((p.y - l.A.y) / (l.B.y - l.A.y));
    }

    static void cut_at(line &l, const rational &t)
    {
        if (t > 0 && t < 1)
            l.cut.push_back(t);
    }

    /* On which side of l the ends of m are. */
    template <class N> static std::array<int, 2> sides_of(const line &l, const line &m)
    {
        const point2<N> &A = l.from(N()), &B = l.to(N()), &C = m.from(N()), &D = m.to(N());
        const auto ends = [&](uint32_t v) { return v != ROBERTS_NONE && (v == l.a || v == l.b); };
        return {ends(m.a) ? 0 : sign_of(o_orient(A, B, C)), ends(m.b) ? 0 : sign_of(o_orient(A, B, D))};
    }

    template <class N> static N o_orient(const point2<N> &p, const point2<N> &q, const point2<N> &r)
    {
        return mesh_oracle::orient(p, q, r.x, r.y);
    }

    /* Two lines that lie on one another in the picture, m from t0 to t1 of l, may meet in space. */
    static void cut_where_they_meet(line &l, line &m, const rational &t0, const rational &t1)
    {
        const rational slope = (m.zB - m.zA) / (t1 - t0) - (l.zB - l.zA);
        if (slope == 0)
            return;
        const rational t = (l.zA - m.zA + (m.zB - m.zA) / (t1 - t0) * t0) / slope;
        cut_at(l, t);
        cut_at(m, (t - t0) / (t1 - t0));
    }

    void cut_pair(size_t i, size_t j)
    {
        line &l = lines[i], &m = lines[j];
        if (l.x1 < m.x0 || m.x1 < l.x0 || l.y1 < m.y0 || m.y1 < l.y0)
            return;
        const std::array<int, 2> s = exactly(false, &exact, [&](auto zero) { return sides_of<decltype(zero)>(l, m); });
        if (s[0] * s[1] > 0)
            return;
        const std::array<int, 2> r = exactly(false, &exact, [&](auto zero) { return sides_of<decltype(zero)>(m, l); });
        if (r[0] * r[1] > 0)
            return;
        if (s[0] == 0 && s[1] == 0) {
            const rational t0 = along(l, m.A), t1 = along(l, m.B);
            cut_at(l, t0), cut_at(l, t1);
            cut_at(m, along(m, l.A)), cut_at(m, along(m, l.B));
            if (std::max(t0, t1) > 0 && std::min(t0, t1) < 1) {
                l.along.push_back(j);
                m.along.push_back(i);
                cut_where_they_meet(l, m, t0, t1);
            }
            return;
        }
        if (s[0] * s[1] < 0 && r[0] * r[1] < 0) {
            const rational oa = o_orient(m.A, m.B, l.A), ob = o_orient(m.A, m.B, l.B);
            const rational oc = o_orient(l.A, l.B, m.A), od = o_orient(l.A, l.B, m.B);
            l.cut.push_back(oa / (oa - ob));
            m.cut.push_back(oc / (oc - od));
            return;
        }
        if (s[0] == 0)
            cut_at(l, along(l, m.A));
        if (s[1] == 0)
            cut_at(l, along(l, m.B));
        if (r[0] == 0)
            cut_at(m, along(m, l.A));
        if (r[1] == 0)
            cut_at(m, along(m, l.B));
    }

    /* ---- what is seen beside a piece ---- */

    /* A point of line i, inside a piece. */
    struct place {
        size_t i;
        point2<rational> M;
        point2<interval> near;

        const point2<interval> &at(interval) const
        {
            return near;
        }
        const point2<rational> &at(rational) const
        {
            return M;
        }
    };

    /* Does the face hold what lies immediately to the left of the line (way 1) or to its right (-1)? A ray from there
     * leaves the line at a right angle. Sides along the line lie behind its beginning. */
    template <class N> bool holds(size_t f, const place &p, int way) const
    {
        const line &l = lines[p.i];
        const point2<N> &A = l.from(N()), &B = l.to(N()), &M = p.at(N());
        const N dx = B.x - A.x, dy = B.y - A.y;
        long winding = 0;
        for (size_t k = 0; k < o.faces[f].side.size(); k++) {
            const size_t own = side_line[f][k];
            if (own == NONE || std::find(l.along.begin(), l.along.end(), own) != l.along.end())
                continue;
            const point2<N> &P = o.at(o.faces[f].side[k][0], N()), &Q = o.at(o.faces[f].side[k][1], N());
            const N px = P.x - M.x, py = P.y - M.y, qx = Q.x - M.x, qy = Q.y - M.y;
            const N yp = dx * px + dy * py, yq = dx * qx + dy * qy;
            const bool after = sign_of(yp) > 0, ends_after = sign_of(yq) > 0;
            if (after == ends_after)
                continue;
            const N xp = dx * py - dy * px, xq = dx * qy - dy * qx;
            if (sign_of(N(yp * xq - xp * yq)) * (after ? 1 : -1) == way)
                winding += ends_after ? 1 : -1;
        }
        return o.even_odd ? winding % 2 != 0 : winding != 0;
    }

    const nearness<interval> &of(size_t f, interval) const
    {
        return near_nearness[f];
    }

    const nearness<rational> &of(size_t f, rational) const
    {
        return exact_nearness[f];
    }

    /* Which of two faces is nearer there: the sign of f less g; 0: they touch. */
    template <class N> int compare(size_t f, size_t g, const place &p, int way) const
    {
        const line &l = lines[p.i];
        const point2<N> &A = l.from(N()), &B = l.to(N()), &M = p.at(N());
        const nearness<N> &F = of(f, N()), &G = of(g, N());
        const int here = sign_of(N(F.at(M.x, M.y) - G.at(M.x, M.y)));
        if (here != 0)
            return here;
        return way * sign_of(N((F.a - G.a) * (A.y - B.y) + (F.b - G.b) * (B.x - A.x)));
    }

    /* The face seen, by its index; NONE: nothing. */
    size_t seen(const place &p, int way)
    {
        const interval &x = p.near.x, &y = p.near.y;
        size_t best = NONE;
        questions++;
        for (size_t f = 0; f < o.faces.size(); f++) {
            const polygon &face = o.faces[f];
            if (!counts[f] || x.sup() < face.x0 || x.inf() > face.x1 || y.sup() < face.y0 || y.inf() > face.y1 ||
                !exactly(false, &exact, [&](auto zero) { return holds<decltype(zero)>(f, p, way); }))
                continue;
            const int order = best == NONE ? 1 : exactly(false, &exact, [&](auto zero) {
                return compare<decltype(zero)>(f, best, p, way);
            });
            if (order > 0 || (order == 0 && rank[face.number] < rank[o.faces[best].number]))
                best = f;
        }
        return best;
    }

    uint32_t number(size_t f) const
    {
        return f == NONE ? ROBERTS_NONE : o.faces[f].number;
    }

    static point2<rational> at(const line &l, const rational &t)
    {
        return {l.A.x + t * (l.B.x - l.A.x), l.A.y + t * (l.B.y - l.A.y), rational(1)};
    }

    static roberts_vec2 nearest(const point2<rational> &p)
    {
        return {CGAL::to_double(p.x), CGAL::to_double(p.y)};
    }

    /* Does an earlier line hold this point, too? */
    bool is_said(size_t i, const point2<rational> &M) const
    {
        for (size_t k : lines[i].along) {
            const rational t = k < i ? along(lines[k], M) : rational(-1);
            if (t > 0 && t < 1)
                return true;
        }
        return false;
    }

    void judge_line(size_t i)
    {
        line &l = lines[i];
        std::sort(l.cut.begin(), l.cut.end());
        for (size_t k = 0; k + 1 < l.cut.size(); k++) {
            if (l.cut[k] == l.cut[k + 1])
                continue;
            /* not in the middle, where the ray beside the line would often meet a vertex */
            const rational t = l.cut[k] + (l.cut[k + 1] - l.cut[k]) * rational(0.455078125);
            place p{i, at(l, t), {}};
            if (is_said(i, p.M))
                continue;
            p.near = around(p.M);
            const size_t left = seen(p, 1), right = seen(p, -1);
            if (left != right)
                pieces.push_back({nearest(at(l, l.cut[k])), nearest(at(l, l.cut[k + 1])), number(left), number(right)});
        }
    }

    void find()
    {
        cross_finder finder(o);
        for (size_t f = 0; f < o.faces.size(); f++)
            take_face(f, finder.first[f]);
        for (const crossing &c : finder.find())
            take_line(c.a, c.b, ROBERTS_NONE, ROBERTS_NONE);
        for (size_t i = 0; i < lines.size(); i++)
            for (size_t j = i + 1; j < lines.size(); j++)
                cut_pair(i, j);
        for (size_t i = 0; i < lines.size(); i++)
            judge_line(i);
    }
};

/* The program's picture is about the middle of the box round what is drawn. Refuses scenes in which a corner farther
 * out bounds nothing, such as the tip of a side that runs there and back, or is the end of a wire. */
void check_box(const mesh_oracle &o)
{
    double out[6], in[6];
    std::fill(out, out + 6, -HUGE_VAL);
    std::fill(in, in + 6, -HUGE_VAL);
    const auto grow = [](double *box, const double *x) {
        for (int k = 0; k < 3; k++)
            box[k] = std::max(box[k], x[k]), box[k + 3] = std::max(box[k + 3], -x[k]);
    };
    for (const auto &[key, own] : o.edges) {
        const roberts_vec3 &p = o.mesh.vertex[key[0]], &q = o.mesh.vertex[key[1]];
        const double a[3] = {p.x, p.y, p.z}, b[3] = {q.x, q.y, q.z};
        grow(out, a), grow(out, b);
        for (const oracle_interval &part : o.parts(key[0], key[1], own))
            for (const double t : {part.t0, part.t1}) {
                const double x[3] = {t == 1 ? q.x : p.x + t * (q.x - p.x), t == 1 ? q.y : p.y + t * (q.y - p.y),
                                     t == 1 ? q.z : p.z + t * (q.z - p.z)};
                grow(in, x);
            }
    }
    for (uint32_t i = 0; i < o.mesh.face_start[o.mesh.face_count]; i++) {
        const roberts_vec3 &p = o.mesh.vertex[o.mesh.corner[i]];
        const double a[3] = {p.x, p.y, p.z};
        grow(out, a);
    }
    if (!std::equal(out, out + 6, in))
        throw std::runtime_error("a corner at the rim bounds nothing");
}

} // namespace

bool region_truth_find(const roberts_mesh *mesh, const oracle_view *view, bool even_odd, const uint32_t *rank,
                       region_truth *truth)
{
    std::memset(truth, 0, sizeof *truth);
    try {
        mesh_oracle o(*mesh, *view, even_odd);
        check_box(o);
        region_finder finder(o, rank);
        finder.find();
        truth->u = o.U, truth->w = o.W, truth->d = o.D;
        truth->piece_count = finder.pieces.size();
        truth->piece = copy_of(finder.pieces);
        truth->lines = finder.lines.size();
        truth->questions = finder.questions, truth->exact = finder.exact;
        return true;
    } catch (const std::exception &e) {
        region_truth_free(truth);
        std::snprintf(truth->error, sizeof truth->error, "%s", e.what());
        return false;
    }
}

void region_truth_free(region_truth *truth)
{
    std::free(truth->piece);
    std::memset(truth, 0, sizeof *truth);
}
