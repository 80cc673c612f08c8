/* front_tree.c - see front_tree.h. */
#include "hide/front_tree.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/search.h"

/* The second strip is along the longest side that makes an angle with the first whose sine is greater than this. */
#define ASLANT 0.25
/* A line may meet a child if it is at most this many margins in front of the child's plane. They are many because steep
 * planes matter within a margin of an outline. */
#define PLANE_MARGINS 1024.0

/* A direction of the picture, and the length of the side that has it. */
typedef struct direction {
    double x, y, length;
} direction;

/* Data of a front while a tree is built. */
typedef struct item {
    uint32_t front;
    direction side[2]; /* of its longest side, and of the longest one aslant to it */
    roberts_vec3 up;   /* the outward normal of its largest face in the picture */
    double area;       /* of that face */
    box3 model;        /* see model_bounds() */
} item;

typedef struct building {
    const hide_fronts *fronts;
    front_tree *tree;
    item *item;      /* by its place in the list */
    box3 *box;       /* the same, for box_tree_halve() */
    box3 *pile;      /* the same in a pile: z is its depth; x its turn, of which 1 counts as half of all depth */
    uint32_t *place; /* in the order of the tree */
} building;

static double cross(const direction *a, const direction *b)
{
    return a->x * b->y - a->y * b->x;
}

/* Takes the side from P to Q if it is longer than the known ones. */
static void take_direction(direction known[2], const direction *new)
{
    if (new->length > known[0].length) {
        direction old = known[0];
        known[0] = *new;
        if (known[1].length > 0.0 && !(fabs(cross(&known[0], &known[1])) > ASLANT))
            known[1] = (direction){0};
        if (old.length > known[1].length && fabs(cross(&known[0], &old)) > ASLANT)
            known[1] = old;
    } else if (new->length > known[1].length && fabs(cross(&known[0], new)) > ASLANT) {
        known[1] = *new;
    }
}

static void measure_sides(const hide_fronts *fronts, item *of)
{
    uint32_t turned[SEEN_TURNED];
    const hide_face outline = hide_outline(fronts, of->front, turned);
    for (uint32_t i = 0; i < outline.count && outline.count <= FRONT_TREE_CORNERS; i++) {
        roberts_vec3 P = fronts->P[outline.corner[i]];
        roberts_vec3 Q = fronts->P[outline.corner[i + 1 < outline.count ? i + 1 : 0]];
        double dx = Q.x - P.x, dy = Q.y - P.y, length = sqrt(dx * dx + dy * dy);
        if (length > 0.0)
            take_direction(of->side, &(direction){dx / length, dy / length, length});
    }
}

static double picture_area(const roberts_vec3 *P, const hide_face *F)
{
    double twice = 0.0;
    for (uint32_t i = 0; i < F->count; i++) {
        roberts_vec3 A = P[F->corner[i]], B = P[F->corner[i + 1 < F->count ? i + 1 : 0]];
        twice += A.x * B.y - B.x * A.y;
    }
    return 0.5 * fabs(twice);
}

/* How far faces of a front may be from the plane of another face and yet touch it, model units: the touching distance
 * and the greatest departure of a face of its body. Doubled, for rounding. */
static double touching_margin(const hide_fronts *fronts, uint32_t front)
{
    const roberts_scene *scene = fronts->scene;
    const hide_front *f = &fronts->front[front];
    const scene_solid *own = &scene->solid[f->solid];
    const bool is_face = hide_is_face(f);
    double departure = 0.0;
    for (uint32_t k = is_face ? f->piece : own->face; k < (is_face ? f->piece + 1 : own[1].face); k++)
        departure = greater(departure, scene_deviation(scene, k));
    return 2.0 * (fronts->space.epsilon * scene->unit + departure);
}

/* Finds the box of a front along the axes of the model, with that margin. If its corners are many, the box has no
 * bounds. */
static box3 model_bounds(const hide_fronts *fronts, uint32_t front)
{
    hide_single single = {.front = ROBERTS_NONE};
    box3 own = box3_none;
    uint32_t faces, corners = 0;
    const hide_face *face = hide_faces(fronts, front, &faces, &single);
    for (uint32_t k = 0; k < faces; k++) {
        corners += face[k].count;
        if (corners > FRONT_TREE_CORNERS)
            return (box3){{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
        for (uint32_t i = 0; i < face[k].count; i++)
            box3_add(&own, fronts->scene->point[face[k].corner[i]]);
    }
    const double m = touching_margin(fronts, front);
    const roberts_vec3 margin = {m, m, m};
    return (box3){vec3_sub(own.lo, margin), vec3_add(own.hi, margin)};
}

static item measure_front(const hide_fronts *fronts, uint32_t front)
{
    item of = {.front = front, .up = {0, 0, 1}, .model = model_bounds(fronts, front)};
    hide_single single = {.front = ROBERTS_NONE};
    uint32_t count;
    const hide_face *face = hide_faces(fronts, front, &count, &single);
    measure_sides(fronts, &of);
    for (uint32_t i = 0; i < count && count <= FRONT_TREE_CORNERS; i++) {
        double area = picture_area(fronts->P, &face[i]);
        if (area > of.area) {
            of.area = area;
            of.up = (roberts_vec3){-face[i].F.a, -face[i].F.b, -face[i].F.c};
        }
    }
    return of;
}

/* Finds the corners of a front's faces. If they are many, finds those of its box. Returns their number. */
static uint32_t corners_of(const hide_fronts *fronts, uint32_t front, roberts_vec3 corner[FRONT_TREE_CORNERS])
{
    const hide_box *box = &fronts->front_box[front];
    hide_single single = {.front = ROBERTS_NONE};
    uint32_t faces, count = 0;
    const hide_face *face = hide_faces(fronts, front, &faces, &single);
    for (uint32_t k = 0; k < faces; k++) {
        if (count + face[k].count > FRONT_TREE_CORNERS) {
            for (uint32_t i = 0; i < 8; i++)
                corner[i] = (roberts_vec3){(double)(i & 1 ? box->x1 : box->x0), (double)(i & 2 ? box->y1 : box->y0),
                                           (double)(i & 4 ? box->z1 : box->z0)};
            return 8;
        }
        for (uint32_t i = 0; i < face[k].count; i++)
            corner[count++] = fronts->P[face[k].corner[i]];
    }
    return count;
}

/* The bounds of one child. */
typedef struct bounds {
    hide_box box;
    struct {
        double x, y, low, high;
    } strip[2];
    roberts_vec3 up;
    double low, high; /* along `up` */
    box3 model;
} bounds;

static void widen_strips(bounds *b, const hide_fronts *fronts, const item *of)
{
    uint32_t turned[SEEN_TURNED];
    const hide_face outline = hide_outline(fronts, of->front, turned);
    const hide_box *box = &fronts->front_box[of->front];
    const bool many = outline.count > FRONT_TREE_CORNERS;
    const double loose = hide_loose(fronts, of->front);
    for (int k = 0; k < 2; k++) {
        const double x = b->strip[k].x, y = b->strip[k].y;
        double low = INFINITY, high = -INFINITY;
        for (uint32_t i = 0; i < (many ? 4 : outline.count); i++) {
            double px = (double)(i & 1 ? box->x1 : box->x0), py = (double)(i & 2 ? box->y1 : box->y0);
            if (!many) {
                px = fronts->P[outline.corner[i]].x;
                py = fronts->P[outline.corner[i]].y;
            }
            low = lesser(low, x * px + y * py);
            high = greater(high, x * px + y * py);
        }
        b->strip[k].low = lesser(b->strip[k].low, low - loose);
        b->strip[k].high = greater(b->strip[k].high, high + loose);
    }
}

/* Widens the slab along `up` to hold the front's faces. */
static void widen_slab(bounds *b, const hide_fronts *fronts, const item *of)
{
    roberts_vec3 corner[FRONT_TREE_CORNERS];
    uint32_t count = corners_of(fronts, of->front, corner);
    for (uint32_t i = 0; i < count; i++) {
        double at = vec3_dot(b->up, corner[i]);
        b->low = lesser(b->low, at);
        b->high = greater(b->high, at);
    }
}

static void choose_directions(bounds *b, const item *all, const uint32_t *place, uint32_t count)
{
    direction side[2] = {{.x = 0.0}, {.x = 0.0}};
    double area = -1.0;
    for (uint32_t i = 0; i < count; i++) {
        const item *of = &all[place[i]];
        take_direction(side, &of->side[0]);
        take_direction(side, &of->side[1]);
        if (of->area > area) {
            area = of->area;
            b->up = of->up;
        }
    }
    /* as floats, which is how nodes keep them */
    b->up = (roberts_vec3){(double)(float)b->up.x, (double)(float)b->up.y, (double)(float)b->up.z};
    for (int k = 0; k < 2; k++) {
        b->strip[k].x = (double)(float)-side[k].y;
        b->strip[k].y = (double)(float)side[k].x;
        b->strip[k].low = INFINITY;
        b->strip[k].high = -INFINITY;
    }
}

static void add_box(hide_box *all, const hide_box *box, float loose)
{
    all->x0 = box->x0 - loose < all->x0 ? box->x0 - loose : all->x0;
    all->x1 = box->x1 + loose > all->x1 ? box->x1 + loose : all->x1;
    all->y0 = box->y0 - loose < all->y0 ? box->y0 - loose : all->y0;
    all->y1 = box->y1 + loose > all->y1 ? box->y1 + loose : all->y1;
    all->z0 = box->z0 < all->z0 ? box->z0 : all->z0;
    all->z1 = box->z1 > all->z1 ? box->z1 : all->z1;
}

/* Bounds a box along one axis by floats. */
static void round_outward(const box3 *box, int axis, float *low, float *high)
{
    *low = hide_float_below(axis == 0 ? box->lo.x : axis == 1 ? box->lo.y : box->lo.z);
    *high = hide_float_above(axis == 0 ? box->hi.x : axis == 1 ? box->hi.y : box->hi.z);
}

/* Sets the bounds of child k. */
static void bound(const building *of, front_node *n, int k, const uint32_t *place, uint32_t count)
{
    const hide_fronts *fronts = of->fronts;
    bounds b = {.box = hide_no_box, .low = INFINITY, .high = -INFINITY, .model = box3_none};
    choose_directions(&b, of->item, place, count);
    for (uint32_t i = 0; i < count; i++) {
        const item *own = &of->item[place[i]];
        add_box(&b.box, &fronts->front_box[own->front], (float)hide_loose(fronts, own->front));
        widen_strips(&b, fronts, own);
        widen_slab(&b, fronts, own);
        box3_add(&b.model, own->model.lo);
        box3_add(&b.model, own->model.hi);
    }
    n->x0[k] = b.box.x0;
    n->x1[k] = b.box.x1;
    n->y0[k] = b.box.y0;
    n->y1[k] = b.box.y1;
    n->z0[k] = b.box.z0;
    n->z1[k] = b.box.z1;
    for (int i = 0; i < 2; i++) {
        n->strip[i].x[k] = (float)b.strip[i].x;
        n->strip[i].y[k] = (float)b.strip[i].y;
        n->strip[i].low[k] = hide_float_below(b.strip[i].low);
        n->strip[i].high[k] = hide_float_above(b.strip[i].high);
    }
    n->plane.x[k] = (float)b.up.x;
    n->plane.y[k] = (float)b.up.y;
    n->plane.z[k] = (float)b.up.z;
    n->plane.low[k] = hide_float_below(b.low);
    n->plane.high[k] = hide_float_above(b.high);
    for (int i = 0; i < 3; i++)
        round_outward(&b.model, i, &n->model[i].low[k], &n->model[i].high[k]);
}

/* How far a front is turned in the picture, from 0 to 1. A half turn changes nothing; if its sides are about as long as
 * one another, a quarter turn changes nothing either. */
static double turn_of(const item *of)
{
    const double x = fabs(of->side[0].x), y = fabs(of->side[0].y);
    const bool second = of->side[0].x * of->side[0].y < 0.0; /* in the second quadrant, or the fourth */
    if (!(of->side[0].length > 0.0))
        return 0.0;
    const double turn = (second ? x : y) / (x + y);
    return of->side[1].length > 0.5 * of->side[0].length ? turn : 0.5 * (turn + second);
}

static void set_pile(building *b, uint32_t count)
{
    double low = INFINITY, high = -INFINITY;
    for (uint32_t i = 0; i < count; i++) {
        low = lesser(low, b->box[i].lo.z);
        high = greater(high, b->box[i].lo.z);
    }
    for (uint32_t i = 0; i < count; i++) {
        const double turn = turn_of(&b->item[i]) * 0.5 * (high - low);
        b->pile[i] = (box3){{turn, 0.0, b->box[i].lo.z}, {turn, 0.0, b->box[i].hi.z}};
    }
}

/* Divides fronts by their places; in a pile, by their turns or their depths, whichever are spread more: the strips of
 * fronts that are turned alike are narrow. */
static void halve(const building *b, uint32_t *first, uint32_t count, uint32_t half)
{
    const bool is_pile = box_longest_axis(b->box, first, count) == 2;
    box_tree_halve(is_pile ? b->pile : b->box, first, count, half);
}

/* Builds a node over at least one item, and what is below it. With four children to most nodes and two to four to the
 * others, there are at most two nodes for three items. */
static uint32_t build_node(building *b, uint32_t *first, uint32_t count)
{
    const uint32_t at = b->tree->count++;
    uint32_t begin[5] = {0, count / 4, count / 2, count / 2 + (count - count / 2) / 2, count};
    front_node *n = &b->tree->node[at];
    *n = (front_node){.x0 = {INFINITY, INFINITY, INFINITY, INFINITY}, .x1 = {INFINITY, INFINITY, INFINITY, INFINITY}};
    halve(b, first, count, begin[2]);
    halve(b, first, begin[2], begin[1]);
    halve(b, first + begin[2], count - begin[2], begin[3] - begin[2]);
    for (int k = 0; k < 4; k++) {
        uint32_t size = begin[k + 1] - begin[k];
        uint32_t *own = first + begin[k];
        if (size == 0)
            continue;
        bound(b, n, k, own, size);
        for (uint32_t i = 0; i < size; i++)
            n->last[k] = own[i] > n->last[k] ? own[i] : n->last[k];
        n->child[k] = size == 1 ? *own | FRONT_TREE_LEAF : build_node(b, own, size);
    }
    return at;
}

bool front_tree_build(front_tree *tree, const hide_fronts *fronts, const uint32_t *front, uint32_t count)
{
    building b = {fronts,
                  tree,
                  alloc_array(count, sizeof *b.item),
                  alloc_array(count, sizeof *b.box),
                  alloc_array(count, sizeof *b.pile),
                  alloc_array(count, sizeof *b.place)};
    *tree = (front_tree){.node = alloc_array(2 * (size_t)count / 3 + 1, sizeof *tree->node)}; /* see build_node() */
    bool done = b.item && b.box && b.pile && b.place && tree->node;
    for (uint32_t i = 0; done && i < count; i++) {
        b.item[i] = measure_front(fronts, front[i]);
        b.box[i] = hide_box3(&fronts->front_box[front[i]]);
        b.place[i] = i;
    }
    if (done) {
        set_pile(&b, count);
        build_node(&b, b.place, count);
    }
    free(b.item);
    free(b.box);
    free(b.pile);
    free(b.place);
    return done;
}

void front_tree_free(front_tree *tree)
{
    free(tree->node);
    *tree = (front_tree){0};
}

/* Floats round each coordinate, product and sum by less than a 2^-23rd of the largest of them. ROUNDINGS is far more
 * than all of them together. */
#define ROUNDINGS 0x1p-19

front_line front_line_of(roberts_vec3 A, roberts_vec3 B, double margin)
{
    double xy = fabs(A.x) + fabs(A.y) + fabs(B.x) + fabs(B.y), z = fabs(A.z) + fabs(B.z);
    float dx = (float)(B.x - A.x), dy = (float)(B.y - A.y);
    return (front_line){.Ax = four_all((float)A.x),
                        .Ay = four_all((float)A.y),
                        .Az = four_all((float)A.z),
                        .dx = four_all(dx),
                        .dy = four_all(dy),
                        .dz = four_all((float)(B.z - A.z)),
                        .per_dx = four_all(1.0f / dx),
                        .per_dy = four_all(1.0f / dy),
                        .margin = four_all((float)(2.0 * margin + ROUNDINGS * xy)),
                        .margin_z = four_all((float)(2.0 * margin + ROUNDINGS * z)),
                        .margin_plane = four_all((float)(PLANE_MARGINS * margin + ROUNDINGS * (xy + z)))};
}

/* Clips to low <= a + t d <= high. */
static inline void clip_to(four from, four to, four *t0, four *t1)
{
    *t0 = four_greater(*t0, four_lesser(from, to));
    *t1 = four_lesser(*t1, four_greater(from, to));
}

/* Is the line a + t d at most `high` at t0 or at t1? */
static inline unsigned reaches(four a, four d, four t0, four t1, four high)
{
    return four_at_most(four_lesser(four_add(a, four_mul(t0, d)), four_add(a, four_mul(t1, d))), high);
}

/* Which children meet the part *t0 .. *t1 of the line? Clips the part to each. */
static inline unsigned meets(const front_node *n, const front_line *line, four *t0, four *t1)
{
    const four m = line->margin;
    clip_to(four_mul(four_sub(four_sub(four_load(n->x0), m), line->Ax), line->per_dx),
            four_mul(four_sub(four_add(four_load(n->x1), m), line->Ax), line->per_dx), t0, t1);
    clip_to(four_mul(four_sub(four_sub(four_load(n->y0), m), line->Ay), line->per_dy),
            four_mul(four_sub(four_add(four_load(n->y1), m), line->Ay), line->per_dy), t0, t1);
    if (!four_at_most(*t0, *t1))
        return 0;
    for (int k = 0; k < 2; k++) {
        const four x = four_load(n->strip[k].x), y = four_load(n->strip[k].y);
        const four a = four_add(four_mul(x, line->Ax), four_mul(y, line->Ay));
        const four per = four_div(four_all(1.0f), four_add(four_mul(x, line->dx), four_mul(y, line->dy)));
        clip_to(four_mul(four_sub(four_sub(four_load(n->strip[k].low), m), a), per),
                four_mul(four_sub(four_add(four_load(n->strip[k].high), m), a), per), t0, t1);
    }
    const unsigned left = four_at_most(*t0, *t1);
    if (!left)
        return 0;
    const four px = four_load(n->plane.x), py = four_load(n->plane.y), pz = four_load(n->plane.z);
    const four a = four_add(four_add(four_mul(px, line->Ax), four_mul(py, line->Ay)), four_mul(pz, line->Az));
    const four d = four_add(four_add(four_mul(px, line->dx), four_mul(py, line->dy)), four_mul(pz, line->dz));
    return left & reaches(line->Az, line->dz, *t0, *t1, four_add(four_load(n->z1), line->margin_z)) &
           reaches(a, d, *t0, *t1, four_add(four_load(n->plane.high), line->margin_plane));
}

static inline bool comes_first(const front_visit *a, const front_visit *b)
{
    const float more = (a->t1 - a->t0) - (b->t1 - b->t0);
    return more > 0.0f || (more == 0.0f && a->z1 < b->z1);
}

uint32_t front_node_meets(const front_node *n, const front_line *line, float t0, float t1, front_visit found[4])
{
    four from = four_all(t0), to = four_all(t1);
    float first[4], last[4];
    uint32_t count = 0;
    unsigned met = meets(n, line, &from, &to);
    four_store(first, from);
    four_store(last, to);
    for (; met; met &= met - 1) {
        const int k = bits_trailing_zeros(met);
        const front_visit v = {n->child[k], first[k], last[k], n->z1[k]};
        uint32_t at = count++;
        for (; at > 0 && comes_first(&found[at - 1], &v); at--)
            found[at] = found[at - 1];
        found[at] = v;
    }
    return count;
}

/* Which children have a box that the other one meets in the picture? */
static inline unsigned pictures_touch(const front_node *n, const hide_box *b)
{
    return four_at_most(four_load(n->x0), four_all(b->x1)) & four_at_most(four_all(b->x0), four_load(n->x1)) &
           four_at_most(four_load(n->y0), four_all(b->y1)) & four_at_most(four_all(b->y0), four_load(n->y1));
}

/* Which children have points between the least and the greatest of `at`, give or take m? */
static inline unsigned between(const float *low, const float *high, const four at[2], four m)
{
    return four_at_most(four_load(low), four_add(at[1], m)) & four_at_most(four_sub(at[0], m), four_load(high));
}

static inline four absolute(four a)
{
    return four_greater(a, four_sub(four_all(0.0f), a));
}

/* Which children have a strip that the box meets in the picture? */
static inline unsigned strips_touch(const front_node *n, const hide_box *b)
{
    const four x = four_all(0.5f * (b->x0 + b->x1)), y = four_all(0.5f * (b->y0 + b->y1));
    const four wide = four_all(0.5f * (b->x1 - b->x0)), high = four_all(0.5f * (b->y1 - b->y0));
    const four m = four_all((float)ROUNDINGS * (fabsf(b->x0) + fabsf(b->x1) + fabsf(b->y0) + fabsf(b->y1)));
    unsigned met = 15;
    for (int k = 0; k < 2; k++) {
        const four dx = four_load(n->strip[k].x), dy = four_load(n->strip[k].y);
        const four at = four_add(four_mul(dx, x), four_mul(dy, y));
        const four half = four_add(four_mul(absolute(dx), wide), four_mul(absolute(dy), high));
        met &= between(n->strip[k].low, n->strip[k].high, (four[2]){four_sub(at, half), four_add(at, half)}, m);
    }
    return met;
}

uint32_t front_node_meets_box(const front_node *n, const hide_box *box, uint32_t found[4])
{
    unsigned met = pictures_touch(n, box) & four_at_most(four_all(box->z0), four_load(n->z1));
    if (met)
        met &= strips_touch(n, box);
    uint32_t count = 0;
    float depth[4];
    for (; met; met &= met - 1) {
        const int k = bits_trailing_zeros(met);
        uint32_t at = count++;
        for (; at > 0 && depth[at - 1] < n->z1[k]; at--) {
            found[at] = found[at - 1];
            depth[at] = depth[at - 1];
        }
        found[at] = n->child[k];
        depth[at] = n->z1[k];
    }
    return count;
}

void front_shape_of(front_shape *shape, const hide_fronts *fronts, uint32_t front)
{
    roberts_vec3 corner[FRONT_TREE_CORNERS];
    const double margin = hide_margin(&fronts->space) + hide_loose(fronts, front);
    double most = 0.0;
    shape->box = &fronts->front_box[front];
    shape->count = corners_of(fronts, front, corner);
    for (uint32_t i = 0; i < shape->count; i++) {
        shape->x[i] = (float)corner[i].x;
        shape->y[i] = (float)corner[i].y;
        shape->z[i] = (float)corner[i].z;
        most = greater(most, fabs(corner[i].x) + fabs(corner[i].y) + fabs(corner[i].z));
    }
    shape->margin = (float)(2.0 * margin + ROUNDINGS * most);
    shape->margin_plane = (float)(PLANE_MARGINS * margin + ROUNDINGS * most);
    const box3 model = model_bounds(fronts, front);
    for (int i = 0; i < 3; i++)
        round_outward(&model, i, &shape->low[i], &shape->high[i]);
}

static inline unsigned boxes_touch(const front_node *n, const hide_box *b)
{
    return pictures_touch(n, b) & four_at_most(four_load(n->z0), four_all(b->z1)) &
           four_at_most(four_all(b->z0), four_load(n->z1));
}

unsigned front_node_touches(const front_node *n, const front_shape *shape, uint32_t place)
{
    unsigned met = boxes_touch(n, shape->box);
    for (unsigned k = 0; k < 4; k++)
        met &= n->last[k] > place ? 15u : ~(1u << k);
    for (int k = 0; k < 3 && met; k++)
        met &= four_at_most(four_load(n->model[k].low), four_all(shape->high[k])) &
               four_at_most(four_all(shape->low[k]), four_load(n->model[k].high));
    for (int k = 0; k < 2 && met; k++) {
        const four x = four_load(n->strip[k].x), y = four_load(n->strip[k].y);
        four range[2] = {four_all(INFINITY), four_all(-INFINITY)};
        for (uint32_t i = 0; i < shape->count; i++) {
            const four at = four_add(four_mul(x, four_all(shape->x[i])), four_mul(y, four_all(shape->y[i])));
            range[0] = four_lesser(range[0], at);
            range[1] = four_greater(range[1], at);
        }
        met &= between(n->strip[k].low, n->strip[k].high, range, four_all(shape->margin));
    }
    if (!met)
        return 0;
    const four x = four_load(n->plane.x), y = four_load(n->plane.y), z = four_load(n->plane.z);
    four range[2] = {four_all(INFINITY), four_all(-INFINITY)};
    for (uint32_t i = 0; i < shape->count; i++) {
        const four xy = four_add(four_mul(x, four_all(shape->x[i])), four_mul(y, four_all(shape->y[i])));
        const four at = four_add(xy, four_mul(z, four_all(shape->z[i])));
        range[0] = four_lesser(range[0], at);
        range[1] = four_greater(range[1], at);
    }
    return met & between(n->plane.low, n->plane.high, range, four_all(shape->margin_plane));
}
