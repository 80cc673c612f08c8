/* region_depths.c - see region_depths.h. */
#include "hide/region_depths.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "hide/front.h"

/* ---- faces of several pieces ------------------------------------------------------------------------------------- */

/* The end of the pieces of the face that begins with `first`. end: of the body's faces. */
static uint32_t pieces_end(const roberts_scene *scene, uint32_t body, uint32_t first, uint32_t end)
{
    const uint32_t number = scene_face_number(scene, first);
    const bool convex = scene_is_convex(scene, body);
    uint32_t f = first + 1;
    while (f < end && scene_face_number(scene, f) == number &&
           (number != ROBERTS_NONE || (!convex && scene_plane_number(scene, f) == scene_plane_number(scene, first))))
        f++;
    return f;
}

/* Adds the tree of pieces first .. end - 1. False: no memory. */
static bool add_tree(region_depths *d, uint32_t first, uint32_t end)
{
    box3 *box = alloc_array(end - first, sizeof *box);
    for (uint32_t f = first; box && f < end; f++) {
        const hide_box own = front_box_of_face(d->fronts, f);
        box[f - first] = (box3){{(double)own.x0 - d->touching, (double)own.y0 - d->touching, 0.0},
                                {(double)own.x1 + d->touching, (double)own.y1 + d->touching, 0.0}};
    }
    bool enough = box && box_tree_add(&d->tree, box, end - first, first, &d->root[first]);
    free(box);
    return enough;
}

bool region_depths_build(region_depths *d, const hide_fronts *fronts, double touching)
{
    const roberts_scene *scene = fronts->scene;
    *d = (region_depths){.fronts = fronts, .touching = touching};
    for (uint32_t body = 0; scene->face_number && body < scene->solid_count; body++) {
        const uint32_t all = scene->solid[body + 1].face;
        for (uint32_t f = scene->solid[body].face, end; !fronts->culled[body] && f < all; f = end) {
            end = pieces_end(scene, body, f, all);
            if (end - f < 2)
                continue;
            if (!d->root) {
                d->root = alloc_array(scene->face_count, sizeof *d->root);
                for (uint32_t k = 0; d->root && k < scene->face_count; k++)
                    d->root[k] = ROBERTS_NONE;
            }
            if (!d->root || !add_tree(d, f, end))
                return false;
        }
    }
    return true;
}

void region_depths_free(region_depths *d)
{
    box_tree_free(&d->tree);
    free(d->root);
    *d = (region_depths){0};
}

/* ---- a side ------------------------------------------------------------------------------------------------------ */

double region_depth_at(const hide_fronts *fronts, const uint32_t *corner, uint32_t count, plane F, roberts_vec2 at)
{
    const double z = (F.a * at.x + F.b * at.y + F.d) / -F.c;
    double low = INFINITY, high = -INFINITY;
    for (uint32_t k = 0; k < count; k++) {
        low = lesser(low, fronts->P[corner[k]].z);
        high = greater(high, fronts->P[corner[k]].z);
    }
    return z < low ? low : z > high ? high : z;
}

static roberts_vec2 side_point(const roberts_vec2 side[2], double t)
{
    return (roberts_vec2){side[0].x + t * (side[1].x - side[0].x), side[0].y + t * (side[1].y - side[0].y)};
}

/* Finds the part of a side within `touching` of a piece. False: there is none. */
static bool cut_side(const region_depths *d, const roberts_vec2 side[2], uint32_t piece, depth_part *part)
{
    const hide_fronts *fronts = d->fronts;
    uint32_t turned[SEEN_TURNED];
    seen_face look;
    *part = (depth_part){.t0 = 0.0, .t1 = 1.0};
    if (fronts->seen->facing[piece] == VIEW_EDGE_ON)
        return false;
    seen_face_again(fronts->seen, piece, &look, turned);
    for (uint32_t k = 0; k < look.count; k++) {
        const roberts_vec3 C = fronts->P[look.corner[k]], D = fronts->P[look.corner[k + 1 < look.count ? k + 1 : 0]];
        const double x = D.x - C.x, y = D.y - C.y, far = d->touching * hypot(x, y);
        const double p = x * (side[0].y - C.y) - y * (side[0].x - C.x) + far;
        const double q = x * (side[1].y - C.y) - y * (side[1].x - C.x) + far;
        if (p < 0.0 && q < 0.0)
            return false;
        if (p < 0.0)
            part->t0 = greater(part->t0, p / (p - q));
        if (q < 0.0)
            part->t1 = lesser(part->t1, p / (p - q));
    }
    if (part->t0 > part->t1)
        return false;
    part->z0 = region_depth_at(fronts, look.corner, look.count, look.F, side_point(side, part->t0));
    part->z1 = region_depth_at(fronts, look.corner, look.count, look.F, side_point(side, part->t1));
    return true;
}

static int compare_parts(const void *pa, const void *pb)
{
    const depth_part *a = pa, *b = pb;
    return (a->t0 > b->t0) - (a->t0 < b->t0);
}

static double part_depth(const depth_part *part, double t)
{
    return t < part->t1 ? part->z0 + (t - part->t0) / (part->t1 - part->t0) * (part->z1 - part->z0) : part->z1;
}

/* Is part a nearer the viewer than part b, both of which continue after t? */
static bool is_nearer(const depth_part *a, const depth_part *b, double t)
{
    const double middle = 0.5 * (t + lesser(a->t1, b->t1));
    return part_depth(a, middle) > part_depth(b, middle);
}

/* Goes along a side from part to part. A face that is not planar may lie before itself: then its nearest part is seen.
 * Another begins only where the seen one ends, since folds bound cells. slack: parts end within it of where they
 * should, as a fraction of the side. */
static void follow(const depth_parts *parts, double slack, depth_range *range)
{
    const depth_part *part = parts->part, *end = part + parts->count;
    for (double t = 0.0; t + slack < 1.0;) {
        const depth_part *shown = NULL;
        double next = 1.0; /* where the next part begins */
        while (part < end && part->t1 <= t + slack)
            part++;
        for (const depth_part *p = part; p < end; p++) {
            if (p->t0 > t + slack) {
                next = p->t0;
                break;
            }
            if (p->t1 > t + slack && (!shown || is_nearer(p, shown, t)))
                shown = p;
        }
        if (shown) {
            const double z = part_depth(shown, greater(t, shown->t0));
            range->low = lesser(range->low, lesser(z, shown->z1));
            range->high = greater(range->high, greater(z, shown->z1));
        }
        t = shown ? shown->t1 : next;
    }
}

bool region_depths_along(const region_depths *d, uint32_t first, const roberts_vec2 side[2], depth_parts *parts,
                         depth_range *range)
{
    const roberts_vec2 P = side[0], Q = side[1];
    const box3 box = {{lesser(P.x, Q.x), lesser(P.y, Q.y), 0.0}, {greater(P.x, Q.x), greater(P.y, Q.y), 0.0}};
    const double length = hypot(Q.x - P.x, Q.y - P.y);
    const box_tree_node *node = d->tree.node;
    parts->count = 0;
    for (uint32_t i = d->root[first], end = node[i].skip; i < end;) {
        if (!box3_meet(&node[i].box, &box)) {
            i = node[i].skip;
            continue;
        }
        for (uint32_t k = node[i].first; k < node[i].first + node[i].count; k++) {
            if (!array_reserve(&parts->part, &parts->room, parts->count + 1, sizeof *parts->part))
                return false;
            parts->count += cut_side(d, side, d->tree.item[k], &parts->part[parts->count]);
        }
        i++;
    }
    if (parts->count > 1)
        qsort(parts->part, parts->count, sizeof *parts->part, compare_parts);
    follow(parts, 2.0 * d->touching / length, range);
    return true;
}
