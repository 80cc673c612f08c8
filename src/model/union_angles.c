/* union_angles.c - the region that the bodies at a piece of a line fill together, and its bounds. See union.h. */

#include "base/array.h"
#include "base/box.h"
#include "base/sort.h"
#include "model/union_work.h"

/* Directions tried until a ray passes no border of a face too closely. */
enum { RAYS_TRIED = 16 };

/* Scene units: the least distance at which a ray's side of a border is certain. Far above rounding. Shorter sides of a
 * face are left out: their neighbours bound the face as closely. */
#define RAY_CLEAR 1e-13

#define FULL_TURN 6.28318530717958647692

/* ---- what a body that is not convex fills ------------------------------------------------------------------------ */

enum { MISSES, HITS, UNSURE };

/* Does the segment from M to M + R meet the face, well inside its border and away from M? */
static int ray_meets(const roberts_scene *scene, uint32_t face, roberts_vec3 M, roberts_vec3 R)
{
    plane F = union_plane(scene, face);
    roberts_vec3 n = {F.a, F.b, F.c};
    double slope = vec3_dot(n, R), at = plane_at(F, M), scale = vec3_length(R);
    if (fabs(slope) <= 1e-6 * scale)
        return fabs(at) <= 1e-5 * scale ? UNSURE : at * (at + slope) < 0.0 ? UNSURE : MISSES;
    double t = -at / slope;
    if (t * scale < -RAY_CLEAR)
        return MISSES;
    roberts_vec3 X = vec3_add(M, vec3_scale(t, R));
    uint32_t first = scene->face_start[face], count = scene->face_start[face + 1] - first;
    int left = 0, right = 0, near = 0;
    for (uint32_t i = 0; i < count; i++) {
        roberts_vec3 P = union_place(scene, scene->point[scene->corner[first + i]]);
        roberts_vec3 Q = union_place(scene, scene->point[scene->corner[first + (i + 1) % count]]);
        roberts_vec3 side = vec3_sub(Q, P), to = vec3_sub(X, P);
        if (vec3_length(side) <= RAY_CLEAR)
            continue;
        double area = vec3_dot(vec3_cross(side, to), n), sure = RAY_CLEAR * (vec3_length(side) + vec3_length(to));
        left += area > sure;
        right += area < -sure;
        near += fabs(area) <= sure;
    }
    if (left && right)
        return MISSES;
    return near || t * scale <= RAY_CLEAR ? UNSURE : HITS;
}

static bool is_at(const union_span *span, double t)
{
    return span->t0 <= t && t <= span->t1;
}

/* Does the line touch the plane of this face of the body at t? */
static bool in_contact(const union_cutter *c, uint32_t body, uint32_t face, double t)
{
    const union_work *work = c->work;
    uint32_t number = union_plane_number(c->all->scene, face);
    for (size_t i = 0; i < work->contact_count; i++) {
        const union_contact *contact = &work->contact[i];
        if (contact->body == body && contact->plane == number && is_at(&contact->span, t))
            return true;
    }
    return false;
}

/* How much a crossing of a face toward direction d counts, if winding numbers decide. */
static int32_t winding_across(const union_bodies *all, uint32_t face, roberts_vec3 d)
{
    const plane F = union_plane(all->scene, face);
    return all->winding[face] * (vec3_dot((roberts_vec3){F.a, F.b, F.c}, d) > 0.0 ? 1 : -1);
}

/* Casts a ray from the line at t, in direction w, and counts its crossings with the body's surface: `*winding` is the
 * winding number there, or else their parity. Faces in which the line lies at t do not count. False: it passes a border
 * too closely. */
static bool cast(const union_cutter *c, const union_fill *of, double t, roberts_vec3 w, int32_t *winding)
{
    const union_bodies *all = c->all;
    const roberts_scene *scene = all->scene;
    roberts_vec3 M = vec3_add(c->A, vec3_scale(t, c->U)), R = vec3_scale(2.0 * all->diameter, w), E = vec3_add(M, R);
    uint32_t root = all->root[of->body], first = scene->solid[of->body].face;
    const box_tree_node few = {.skip = 1, .first = first, .count = scene->solid[of->body + 1].face - first};
    const box_tree_node *node = root == ROBERTS_NONE ? &few : all->tree.node + root;
    *winding = 0;
    for (uint32_t i = 0, end = root == ROBERTS_NONE ? 1 : node[0].skip - root; i < end;) {
        double t0 = 0.0, t1 = 1.0;
        const box3 *box = &node[i].box;
        if (root != ROBERTS_NONE && (!box_clip(M.x, E.x, box->lo.x, box->hi.x, &t0, &t1) ||
                                     !box_clip(M.y, E.y, box->lo.y, box->hi.y, &t0, &t1) ||
                                     !box_clip(M.z, E.z, box->lo.z, box->hi.z, &t0, &t1))) {
            i = node[i].skip - root;
            continue;
        }
        for (uint32_t k = node[i].first; k < node[i].first + node[i].count; k++) {
            uint32_t face = root == ROBERTS_NONE ? k : all->tree.item[k];
            if (of->active && in_contact(c, of->body, face, t))
                continue;
            int meets = ray_meets(scene, face, M, R);
            if (meets == UNSURE)
                return false;
            if (meets == HITS && of->wound)
                *winding += winding_across(all, face, R);
            else
                *winding ^= meets == HITS;
        }
        i++;
    }
    return true;
}

/* Finds the winding number of the body in the sector just beside the line at t, or the parity; not 0: it fills the
 * sector. `middle` is the sector's angle, `half` half its width. */
static int32_t winding_by_rays(const union_cutter *c, const union_fill *of, double t, double middle, double half)
{
    static const double turn[RAYS_TRIED] = {0.03,  -0.27, 0.41,  -0.11, 0.33, -0.47, 0.19,  -0.37,
                                            0.071, -0.21, 0.273, -0.43, 0.13, -0.31, 0.459, -0.067};
    for (int i = 0; i < RAYS_TRIED; i++) {
        double angle = middle + half * turn[i], slant = 0.7 * turn[(i + 5) % RAYS_TRIED];
        roberts_vec3 w = vec3_add(vec3_scale(cos(angle), c->e1), vec3_scale(sin(angle), c->e2));
        w = vec3_add(w, vec3_scale(slant, c->u));
        int32_t winding;
        if (cast(c, of, t, vec3_scale(1.0 / vec3_length(w), w), &winding))
            return winding;
    }
    return 0;
}

/* Is the line inside the body at t? The line touches no face of it there. */
static bool is_inside(const union_cutter *c, const union_fill *of, double t)
{
    const roberts_scene *scene = c->all->scene;
    if (!of->convex)
        return winding_by_rays(c, of, t, 0.0, 0.5 * FULL_TURN) != 0;
    roberts_vec3 M = vec3_add(c->A, vec3_scale(t, c->U));
    for (uint32_t f = scene->solid[of->body].face; f < scene->solid[of->body + 1].face; f++)
        if (!(plane_at(union_plane(scene, f), M) > 0.0))
            return false;
    return true;
}

/* ---- the angles about a piece ------------------------------------------------------------------------------------ */

static double touch_of(const union_cutter *c, uint32_t a, uint32_t b)
{
    return c->all->touch + c->all->departure[a] + c->all->departure[b];
}

bool union_agree(const union_cutter *c, const union_side *a, const union_side *b, double way)
{
    return way * vec3_dot(a->d, b->d) > 0.0 &&
           vec3_length(vec3_cross(a->d, b->d)) * lesser(a->reach, b->reach) <= 2.0 * touch_of(c, a->body, b->body);
}

/* Adds a ray. Pieces of one face share one ray. cut: see union_ray. False: no memory. */
static bool add_ray(union_cutter *c, const union_contact *of, double way, double reach, bool cut)
{
    union_work *work = c->work;
    roberts_vec3 d = vec3_scale(way, of->w);
    for (size_t i = 0; i < work->ray_count; i++) {
        union_ray *r = &work->ray[i];
        if (r->side.body == of->body && r->plane == of->plane && r->cut == cut && vec3_dot(r->side.d, d) > 0.0) {
            r->side.reach = greater(r->side.reach, reach);
            r->own = r->own || of->own;
            r->side.face = of->own || (!r->own && of->face < r->side.face) ? of->face : r->side.face;
            return true;
        }
    }
    if (!array_reserve(&work->ray, &work->ray_room, work->ray_count + 1, sizeof *work->ray))
        return false;
    double angle = atan2(vec3_dot(d, c->e2), vec3_dot(d, c->e1));
    work->ray[work->ray_count++] = (union_ray){
        {of->face, way > 0.0, of->body, d, reach}, angle, cut ? ROBERTS_NONE : of->plane, 0, of->own && !cut, cut};
    return true;
}

/* Adds a ray opposite to a face that lies in the near plane: sections of other bodies may continue the face beyond its
 * edge. False: no memory. */
static bool add_cut(union_cutter *c, const union_contact *of)
{
    return add_ray(c, of, of->plus > 0.0 ? -1.0 : 1.0, c->all->diameter, true);
}

static union_fill *fill_of(const union_work *work, uint32_t body)
{
    for (size_t i = 0; i < work->fill_count; i++)
        if (work->fill[i].body == body)
            return &work->fill[i];
    return NULL;
}

/* Finds the rays of the piece around t. *alone: only one body has any. False: no memory. */
static bool find_rays(union_cutter *c, double t, bool *alone)
{
    union_work *work = c->work;
    work->ray_count = 0;
    *alone = true;
    uint32_t first = c->line->body != ROBERTS_NONE ? c->line->body : c->line->crossed[0];
    for (size_t i = 0; i < work->fill_count; i++)
        work->fill[i].active = false;
    for (size_t i = 0; i < work->contact_count; i++) {
        const union_contact *contact = &work->contact[i];
        if (!is_at(&contact->span, t))
            continue;
        fill_of(work, contact->body)->active = true;
        *alone = *alone && contact->body == first;
        if ((contact->plus > 0.0 && !add_ray(c, contact, 1.0, contact->plus, false)) ||
            (contact->minus > 0.0 && !add_ray(c, contact, -1.0, contact->minus, false)) ||
            (contact->own && contact->face == c->in_near && !add_cut(c, contact)))
            return false;
    }
    return true;
}

/* Sorts the rays by angle and groups those of one direction into clusters. Clusters ascend by angle, from 0; the angles
 * of the last may exceed a full turn. Returns the number of clusters. */
static uint32_t find_clusters(union_cutter *c)
{
    union_work *work = c->work;
    union_ray *ray = work->ray;
    size_t n = work->ray_count, start = 0;
    SORT_FEW(union_ray, ray, n, a->angle > b->angle || (a->angle == b->angle && a->side.face > b->side.face))
    while (start < n && union_agree(c, &ray[(start + n - 1) % n].side, &ray[start].side, 1.0))
        start++;
    if (n == 0 || start == n) {
        for (size_t i = 0; i < n; i++)
            ray[i].cluster = 0;
        return n > 0;
    }
    for (size_t i = 0; i < start; i++)
        ray[i].angle += FULL_TURN;
    SORT_FEW(union_ray, ray, n, a->angle > b->angle || (a->angle == b->angle && a->side.face > b->side.face))
    uint32_t cluster = 0;
    for (size_t i = 0; i < n; i++) {
        cluster += i > 0 && !union_agree(c, &ray[i - 1].side, &ray[i].side, 1.0);
        ray[i].cluster = cluster;
    }
    return cluster + 1;
}

/* Returns the middle of the sector that follows cluster k, and half its width. */
static double sector(const union_work *work, uint32_t k, uint32_t clusters, double *half)
{
    double last = -INFINITY, next = INFINITY;
    for (size_t i = 0; i < work->ray_count; i++) {
        const union_ray *r = &work->ray[i];
        if (r->cluster == k)
            last = greater(last, r->angle);
        if (r->cluster == (k + 1) % clusters)
            next = lesser(next, r->angle);
    }
    if (k + 1 == clusters)
        next += FULL_TURN;
    *half = 0.5 * (next - last);
    return 0.5 * (last + next);
}

/* Does a convex body fill direction w? It does if w is on the inner side of all its faces at the line. */
static bool convex_fills(const union_cutter *c, const union_fill *of, double t, roberts_vec3 w)
{
    const union_work *work = c->work;
    for (size_t i = 0; i < work->contact_count; i++) {
        const union_contact *contact = &work->contact[i];
        if (contact->body == of->body && is_at(&contact->span, t) && (contact->plus > 0.0 || contact->minus > 0.0) &&
            !(vec3_dot(contact->n, w) > 0.0))
            return false;
    }
    return true;
}

/* Is it the ray of a face of this body? */
static bool is_of(const union_ray *r, const union_fill *of)
{
    return r->side.body == of->body && !r->cut;
}

/* The change of a body's winding number, or of the parity, where a ray is passed counter-clockwise. */
static int32_t step_past(const union_cutter *c, const union_fill *of, const union_ray *r)
{
    return of->wound ? -winding_across(c->all, r->side.face, vec3_cross(c->u, r->side.d)) : 1;
}

/* Has the near plane, in which the line lies, taken away what is in this direction? What lies in the plane itself
 * stays. reach: how far it extends that way. */
static bool is_taken(const union_cutter *c, roberts_vec3 w, double reach)
{
    const plane near = c->all->near;
    return c->in_near != ROBERTS_NONE && vec3_dot((roberts_vec3){near.a, near.b, near.c}, w) * reach < -c->touch;
}

/* Does the body fill the sector after cluster k? For a body that is not convex, each ray changes the answer. */
static bool fills(const union_cutter *c, const union_fill *of, double t, uint32_t k, double middle)
{
    const union_work *work = c->work;
    const roberts_vec3 w = vec3_add(vec3_scale(cos(middle), c->e1), vec3_scale(sin(middle), c->e2));
    if (!of->active || of->broken || is_taken(c, w, c->all->diameter))
        return false;
    if (of->convex)
        return convex_fills(c, of, t, w);
    int32_t winding = of->first;
    for (size_t i = 0; i < work->ray_count; i++)
        if (is_of(&work->ray[i], of) && work->ray[i].cluster > 0 && work->ray[i].cluster <= k)
            winding += step_past(c, of, &work->ray[i]);
    return of->wound ? winding != 0 : winding % 2 != 0;
}

/* Finds the winding numbers, or the parities, of the bodies that are not convex in the first sector. */
static void begin_fills(union_cutter *c, double t, uint32_t clusters)
{
    union_work *work = c->work;
    double half, middle = sector(work, 0, clusters, &half);
    for (size_t i = 0; i < work->fill_count; i++) {
        union_fill *of = &work->fill[i];
        int32_t round = 0;
        if (!of->active || of->convex)
            continue;
        for (size_t k = 0; k < work->ray_count; k++)
            if (is_of(&work->ray[k], of))
                round += step_past(c, of, &work->ray[k]);
        of->broken = of->wound ? round != 0 : round % 2 != 0;
        of->first = of->broken ? 0 : winding_by_rays(c, of, t, middle, half);
    }
}

/* Does a ray represent a cluster rather than another one, or NULL? For an edge, its own faces are preferred. */
static bool is_preferred(const union_cutter *c, const union_ray *r, const union_ray *to)
{
    if (to && c->line->body != ROBERTS_NONE && r->own != to->own)
        return r->own;
    return !to || r->side.face < to->side.face;
}

/* Returns the ray that represents a cluster where the filled region ends. It is a ray of a body that fills the filled
 * side. */
static const union_ray *bounding_ray(const union_cutter *c, double t, uint32_t k, uint32_t clusters, bool after)
{
    const union_work *work = c->work;
    const union_ray *found = NULL, *other = NULL;
    uint32_t filled = after ? k : (k + clusters - 1) % clusters;
    double half, middle = sector(work, filled, clusters, &half);
    for (size_t i = 0; i < work->ray_count; i++) {
        const union_ray *r = &work->ray[i];
        if (r->cluster != k)
            continue;
        other = other ? other : r;
        if (is_preferred(c, r, found) && fills(c, fill_of(work, r->side.body), t, filled, middle))
            found = r;
    }
    return found ? found : other;
}

/* Is the region between the clusters i and k exactly a half-plane? */
static bool opposite(const union_cutter *c, uint32_t i, uint32_t k)
{
    const union_work *work = c->work;
    for (size_t a = 0; a < work->ray_count; a++)
        for (size_t b = 0; b < work->ray_count; b++)
            if (work->ray[a].cluster == i && work->ray[b].cluster == k &&
                union_agree(c, &work->ray[a].side, &work->ray[b].side, -1.0))
                return true;
    return false;
}

/* Do both faces that cross in the line bound the filled region? */
static bool own_sides(const union_cutter *c, const union_piece *piece)
{
    const roberts_scene *scene = c->all->scene;
    for (uint32_t k = 0; k < c->line->own_count; k++) {
        uint32_t i = piece->first, end = piece->first + piece->count;
        while (i < end &&
               union_plane_number(scene, c->work->side[i].face) != union_plane_number(scene, c->line->own[k]))
            i++;
        if (i == end)
            return false;
    }
    return true;
}

/* Is another line in this place drawn instead? */
static bool drawn_elsewhere(const union_cutter *c, const union_piece *piece)
{
    const union_work *work = c->work;
    if (c->line->body == ROBERTS_NONE && !own_sides(c, piece))
        return true;
    for (size_t i = 0; i < work->ray_count; i++) {
        const union_ray *r = &work->ray[i];
        size_t k = 0;
        if (c->line->body != ROBERTS_NONE && r->side.body >= c->line->body)
            continue;
        if (c->on_near && c->all->cut[r->side.body])
            continue; /* it has no edges left in the near plane */
        while (k < work->ray_count &&
               (k == i || work->ray[k].side.body != r->side.body || work->ray[k].plane != r->plane))
            k++;
        if (k == work->ray_count) /* the face ends here */
            return true;
    }
    return false;
}

/* Returns the ray that represents cluster k, on neither side of which anything is filled: of a body whose faces lie on
 * one another there. These hide what is behind them, as other faces do. NULL: there is none. A convex body that fills
 * neither side is a wedge narrower than the touching distance, and what a broken body fills is not known. */
static const union_ray *folded_ray(const union_cutter *c, uint32_t k)
{
    const union_work *work = c->work;
    const union_ray *found = NULL;
    for (size_t i = 0; i < work->ray_count; i++) {
        const union_ray *r = &work->ray[i];
        const union_fill *of = fill_of(work, r->side.body);
        if (r->cluster == k && !r->cut && !of->convex && !of->broken && !is_taken(c, r->side.d, r->side.reach) &&
            is_preferred(c, r, found))
            found = r;
    }
    return found;
}

/* What becomes of a line in which a sheet meets a closed body. Each face that is a side beyond the sheet may have a
 * line in this place: that with the smallest number is drawn. */
static union_state state_of_sheet(const union_cutter *c, const union_piece *piece, bool flat)
{
    const union_side *least = NULL;
    bool over = false, under = false;
    for (uint32_t i = piece->first; i < piece->first + piece->count; i++) {
        const union_side *side = &c->work->side[i];
        const double height = vec3_dot(c->line->sheet, side->d) * side->reach;
        over = over || height > c->touch;
        under = under || height < -c->touch;
        if (fabs(height) > c->touch && (!least || side->face < least->face))
            least = side;
    }
    if (!over || !under)
        return UNION_SEAM;
    if (least->body != c->line->crossed[0] || scene_face_number(c->all->scene, least->face) != c->line->number)
        return UNION_TWICE;
    return flat ? UNION_MET : UNION_DRAWN;
}

/* Adds the sides of a piece. flat: they bound exactly a half-plane. False: no memory. */
static bool find_sides(union_cutter *c, double t, uint32_t clusters, union_piece *piece, bool *alone, bool *flat)
{
    union_work *work = c->work;
    double half;
    uint32_t edge[2] = {0, 0};
    size_t own = 0;
    piece->first = (uint32_t)work->side_count;
    piece->count = 0;
    *alone = true;
    for (size_t i = 0; i < work->ray_count; i++)
        own += work->ray[i].own;
    for (uint32_t k = 0; k < clusters; k++) {
        uint32_t last = (k + clusters - 1) % clusters;
        double middle = sector(work, k, clusters, &half), before = sector(work, last, clusters, &half);
        bool filled = false, was = false;
        for (size_t i = 0; i < work->fill_count; i++) {
            filled = filled || fills(c, &work->fill[i], t, k, middle);
            was = was || fills(c, &work->fill[i], t, last, before);
        }
        if (filled && was)
            continue;
        const union_ray *r = filled || was ? bounding_ray(c, t, k, clusters, filled) : folded_ray(c, k);
        if (!r)
            continue;
        if (!array_reserve(&work->side, &work->side_room, work->side_count + 1, sizeof *work->side))
            return false;
        work->side[work->side_count++] = r->side;
        *alone = *alone && r->own;
        edge[piece->count > 0] = k;
        piece->count++;
    }
    *alone = *alone && piece->count == own;
    *flat = piece->count == 2 && opposite(c, edge[0], edge[1]);
    return true;
}

/* Does the line belong to one body alone, of which winding numbers tell what it fills? Then lines inside one of its
 * faces, where the border crosses itself, are seams. */
static bool is_wound(const union_cutter *c)
{
    const union_line *line = c->line;
    const uint32_t body = line->body != ROBERTS_NONE ? line->body : line->crossed[0];
    const union_fill *of = fill_of(c->work, body);
    return of && of->active && of->wound && (line->body != ROBERTS_NONE || line->crossed[1] == body);
}

bool union_judge(union_cutter *c, union_piece *piece)
{
    union_work *work = c->work;
    double t = union_middle(piece);
    bool alone, flat;
    size_t sides = work->side_count;
    piece->first = piece->count = 0;
    if (!find_rays(c, t, &alone))
        return false;
    piece->state = UNION_INSIDE;
    for (size_t i = 0; i < work->fill_count; i++)
        if (!work->fill[i].active && !union_is_own(c, work->fill[i].body) && is_inside(c, &work->fill[i], t))
            return true;
    piece->state = UNION_ALONE;
    for (size_t i = 0; i < work->fill_count; i++) /* by rounding, a line may lie beside its own faces */
        alone = alone || (!work->fill[i].active && union_is_own(c, work->fill[i].body));
    if (alone && !is_wound(c))
        return true;
    uint32_t clusters = find_clusters(c);
    if (clusters == 0)
        return true;
    begin_fills(c, t, clusters);
    const union_fill *own = c->line->body == ROBERTS_NONE ? NULL : fill_of(work, c->line->body);
    if (own && own->broken)
        return true;
    if (!find_sides(c, t, clusters, piece, &alone, &flat))
        return false;
    if (vec3_largest(c->line->sheet) > 0.0)
        piece->state = state_of_sheet(c, piece, flat);
    else
        piece->state = piece->count == 0 || flat ? UNION_SEAM : drawn_elsewhere(c, piece) ? UNION_TWICE : UNION_DRAWN;
    if (piece->state == UNION_DRAWN && alone && c->line->body != ROBERTS_NONE)
        piece->state = UNION_ALONE;
    if (piece->state != UNION_DRAWN) {
        piece->first = piece->count = 0;
        work->side_count = sides;
    }
    return true;
}
