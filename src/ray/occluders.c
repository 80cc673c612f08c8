/* occluders.c - the front faces of a scene, in a tree of boxes. See occluders.h. */
#include "ray/occluders.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/sort.h"

/* Loose epsilons: how far boxes extend beyond their faces. A corner of angle a, expanded by epsilon, extends by epsilon
 * / sin(a / 2). */
#define BOX_MARGIN 1000.0
/* A face is cut into at most SLICES boxes. Their number doubles as long as all boxes together shrink to SLICE_GAIN or
 * less and each new box saves more than SLICE_COST queries (the measured cost of building it). */
#define SLICES 1024
#define SLICE_GAIN 0.75
#define SLICE_COST 20.0
/* A solid of at most FACES_TOGETHER faces is a single item of the tree, if its picture fills at least FILL_TOGETHER of
 * its box. */
#define FACES_TOGETHER 12
#define FILL_TOGETHER 0.125

/* ---- the picture ----------------------------------------------------------------------------------------------- */

/* Sets the line of sight and two directions perpendicular to it. Their rotation does not matter, since this picture is
 * not shown. */
static void set_picture(occluders *o, const view *v)
{
    roberts_vec3 d = o->s.perspective ? v->dir : o->s.viewpoint;
    bool steep = fabs(d.z) > 0.7;
    o->right = vec3_cross(steep ? (roberts_vec3){1, 0, 0} : (roberts_vec3){0, 0, 1}, d);
    o->right = vec3_scale(1.0 / vec3_length(o->right), o->right);
    o->up = vec3_cross(d, o->right);
    o->toward = d;
}

/* Maps a point to the picture. z is the height or, in perspective, one over the distance from the eye's plane. Both
 * increase toward the viewer, and both keep planes planar. */
static roberts_vec3 picture_point(const occluders *o, roberts_vec3 X)
{
    if (!o->s.perspective)
        return (roberts_vec3){vec3_dot(o->right, X), vec3_dot(o->up, X), vec3_dot(o->toward, X)};
    roberts_vec3 q = vec3_sub(X, o->s.viewpoint);
    double w = -1.0 / vec3_dot(o->toward, q);
    return (roberts_vec3){w * vec3_dot(o->right, q), w * vec3_dot(o->up, q), w};
}

/* ---- the tree -------------------------------------------------------------------------------------------------- */

/* Boxes to be put into the tree. */
typedef struct box_list {
    tree_entry *entry;
    size_t count, room;
    double floor, rays_per_shadow;
    box3 *slice, *finer; /* [SLICES] the boxes of a face; too large for a small stack */
} box_list;

static box3 face_box(const occluders *o, uint32_t face)
{
    const roberts_scene *scene = o->s.scene;
    box3 box = box3_none;
    for (uint32_t k = scene->face_start[face]; k < scene->face_start[face + 1]; k++)
        box3_add(&box, picture_point(o, o->s.P[scene->corner[k]]));
    return box;
}

/* Divides a face by `count` + 1 evenly spaced lines across the longer side of its box `whole`. slice[0 .. count-1]
 * become the boxes of the parts. The face is convex, so no part extends beyond the sides between its lines. */
static void slice_face(const occluders *o, uint32_t face, box3 whole, box3 *slice, uint32_t count)
{
    const roberts_scene *scene = o->s.scene;
    bool along_x = whole.hi.x - whole.lo.x > whole.hi.y - whole.lo.y;
    double low = along_x ? whole.lo.x : whole.lo.y, step = ((along_x ? whole.hi.x : whole.hi.y) - low) / count;
    for (uint32_t i = 0; i < count; i++)
        slice[i] = box3_none;
    uint32_t end = scene->face_start[face + 1];
    roberts_vec3 A = picture_point(o, o->s.P[scene->corner[end - 1]]);
    for (uint32_t k = scene->face_start[face]; k < end; k++) {
        roberts_vec3 B = picture_point(o, o->s.P[scene->corner[k]]);
        bool rising = along_x ? A.x <= B.x : A.y <= B.y;
        roberts_vec3 L = rising ? A : B, H = rising ? B : A, LH = vec3_sub(H, L);
        double l = ((along_x ? L.x : L.y) - low) / step, h = ((along_x ? H.x : H.y) - low) / step;
        for (uint32_t i = l > 0.0 ? (uint32_t)lesser(l, count - 1) : 0; i < count && (i <= h || i == 0); i++) {
            double in = h > l ? greater(0.0, (i - l) / (h - l)) : 0.0;
            double out = h > l ? lesser(1.0, (i + 1 - l) / (h - l)) : 1.0;
            box3_add(&slice[i], vec3_add(L, vec3_scale(in, LH)));
            box3_add(&slice[i], vec3_add(L, vec3_scale(out, LH)));
        }
        A = B;
    }
}

/* Fills list->slice with the boxes of a face and returns their number. A long oblique face fills little of its box, and
 * many such faces make a tree useless. Slices help (M. Ernst, G. Greiner, "Early split clipping for bounding volume
 * hierarchies", 2007) if the rays that they save cost more than the boxes that they add. The saving is proportional to
 * the reduction of the shadow. */
static uint32_t boxes_of_face(const occluders *o, uint32_t face, const box_list *list)
{
    box3 *slice = list->slice, *finer = list->finer, whole = face_box(o, face);
    uint32_t count = 1;
    double rays = list->rays_per_shadow * tree_box_shadow(whole, list->floor); /* estimate for this box */
    slice[0] = whole;
    while (2 * count <= SLICES && rays > SLICE_COST * count) {
        double fewer = 0.0;
        slice_face(o, face, whole, finer, 2 * count);
        for (uint32_t i = 0; i < 2 * count; i++)
            fewer += list->rays_per_shadow * tree_box_shadow(finer[i], list->floor);
        if (!(fewer < SLICE_GAIN * rays && rays - fewer > SLICE_COST * count))
            break;
        count *= 2;
        rays = fewer;
        for (uint32_t i = 0; i < count; i++)
            slice[i] = finer[i];
    }
    return count;
}

/* Returns the box with a margin around it. `margin` is a length in the model. */
static box3 grown(const occluders *o, box3 box, double margin)
{
    roberts_vec3 m = {margin, margin, margin};
    if (o->s.perspective) {
        m.x = margin * box.hi.z * (1.0 + greater(fabs(box.lo.x), fabs(box.hi.x)));
        m.y = margin * box.hi.z * (1.0 + greater(fabs(box.lo.y), fabs(box.hi.y)));
        m.z = margin * box.hi.z * box.hi.z;
    }
    return (box3){vec3_sub(box.lo, m), vec3_add(box.hi, m)};
}

/* Makes an entry of the tree. Its box contains everything that counts as touching the faces. */
static tree_entry entry_of(const occluders *o, box3 box, uint32_t solid, tree_item faces)
{
    double margin = BOX_MARGIN * (o->s.loose + o->s.rounding);
    return tree_entry_of(grown(o, box, margin), solid, faces);
}

static bool add_entry(const occluders *o, box3 box, uint32_t solid, tree_item faces, box_list *list)
{
    if (!array_reserve(&list->entry, &list->room, list->count + 1, sizeof *list->entry))
        return false;
    list->entry[list->count++] = entry_of(o, box, solid, faces);
    return true;
}

/* Adds the front faces of a solid, each with its own boxes. False: no memory. */
static bool add_faces(const occluders *o, uint32_t solid, box_list *list)
{
    const roberts_scene *scene = o->s.scene;
    for (uint32_t face = scene->solid[solid].face; face < scene->solid[solid + 1].face; face++) {
        uint32_t count = o->s.facing[face] == SIGHT_NOT_FRONT ? 0 : boxes_of_face(o, face, list);
        for (uint32_t i = 0; i < count; i++)
            if (!add_entry(o, list->slice[i], solid, (tree_item){face, 1}, list))
                return false;
    }
    return true;
}

/* Returns the box of all front faces of a solid. `fill`: the fraction of it that their pictures fill; `fronts`: their
 * range. */
static box3 solid_box(const occluders *o, uint32_t solid, double *fill, tree_item *fronts)
{
    const roberts_scene *scene = o->s.scene;
    box3 box = box3_none;
    double area = 0.0; /* twice the area */
    *fronts = (tree_item){0, 0};
    for (uint32_t face = scene->solid[solid].face; face < scene->solid[solid + 1].face; face++) {
        uint32_t end = scene->face_start[face + 1];
        if (o->s.facing[face] == SIGHT_NOT_FRONT)
            continue;
        *fronts = fronts->count ? (tree_item){fronts->first, face + 1 - fronts->first} : (tree_item){face, 1};
        roberts_vec3 A = picture_point(o, o->s.P[scene->corner[end - 1]]), O = A;
        for (uint32_t k = scene->face_start[face]; k < end; k++) {
            roberts_vec3 B = picture_point(o, o->s.P[scene->corner[k]]);
            area += (A.x - O.x) * (B.y - O.y) - (A.y - O.y) * (B.x - O.x);
            box3_add(&box, B);
            A = B;
        }
    }
    *fill = 0.5 * area / ((box.hi.x - box.lo.x) * (box.hi.y - box.lo.y));
    return box;
}

/* Adds a small solid as one box, which makes the tree smaller; a ray that meets the box usually meets a front face. For
 * a long, thin, oblique solid, slices of its faces are better. False: no memory. */
static bool add_solid(const occluders *o, uint32_t solid, box_list *list)
{
    const roberts_scene *scene = o->s.scene;
    tree_item fronts;
    double fill;
    if (scene->solid[solid + 1].face - scene->solid[solid].face > FACES_TOGETHER)
        return add_faces(o, solid, list);
    box3 box = solid_box(o, solid, &fill, &fronts);
    if (fronts.count == 0)
        return true; /* usually a solid that the near plane removes */
    return fill >= FILL_TOGETHER ? add_entry(o, box, solid, fronts, list) : add_faces(o, solid, list);
}

/* Builds the tree over the faces that may hide. Their boxes contain everything that counts as touching them. False: no
 * memory. */
static bool build_tree(occluders *o, const double *rays)
{
    const roberts_scene *scene = o->s.scene;
    box_list list = {.slice = alloc_array(SLICES, sizeof *list.slice),
                     .finer = alloc_array(SLICES, sizeof *list.finer)};
    bool built = list.slice && list.finer;
    o->window = box3_none;
    for (uint32_t i = 0; i < scene->vertex_count; i++)
        box3_add(&o->window, picture_point(o, o->s.P[i]));
    list.floor = o->window.lo.z;
    double shadow = tree_box_shadow(o->window, list.floor);
    for (uint32_t solid = 0; built && solid < scene->solid_count; solid++) {
        list.rays_per_shadow = 2.0 * rays[solid] / shadow; /* on average, rays start at half the height */
        if (o->twin[solid] == solid)
            built = add_solid(o, solid, &list);
    }
    built = built && list.count <= UINT32_MAX / TREE_WIDTH && tree_build(&o->t, list.entry, (uint32_t)list.count);
    free(list.entry);
    free(list.slice);
    free(list.finer);
    return built;
}

/* ---- copies ---------------------------------------------------------------------------------------------------- */

/* Returns a hash of the solid's points. Copies have the same hash. */
static uint32_t solid_key(const occluders *o, uint32_t solid)
{
    const scene_solid *s = &o->s.scene->solid[solid];
    return bits_hash(o->s.P + s->vertex, (s[1].vertex - s->vertex) * sizeof *o->s.P);
}

/* Do two solids have the same points and faces in the same order, to the last bit? */
static bool is_copy(const occluders *o, uint32_t a, uint32_t b)
{
    const roberts_scene *scene = o->s.scene;
    const scene_solid *s = &scene->solid[a], *z = &scene->solid[b];
    uint32_t vertices = s[1].vertex - s->vertex, faces = s[1].face - s->face, corners = scene_corners(scene, a);
    const uint32_t *start = scene->face_start;
    if (z[1].vertex - z->vertex != vertices || z[1].face - z->face != faces || scene_corners(scene, b) != corners ||
        memcmp(o->s.P + s->vertex, o->s.P + z->vertex, vertices * sizeof *o->s.P) != 0 ||
        memcmp(o->s.facing + s->face, o->s.facing + z->face, faces) != 0)
        return false;
    for (uint32_t i = 0; i < faces; i++) {
        scene_shape f = scene_shape_of(scene, s->face + i), g = scene_shape_of(scene, z->face + i);
        if (start[s->face + i] - start[s->face] != start[z->face + i] - start[z->face] || memcmp(&f, &g, sizeof f) != 0)
            return false;
    }
    for (uint32_t i = 0; i < corners; i++)
        if (scene->corner[start[s->face] + i] - s->vertex != scene->corner[start[z->face] + i] - z->vertex)
            return false;
    return true;
}

/* Finds copies: convex solids at exactly the same place. Two of them go into the tree, so that each copy finds another
 * one in front of it. If the tree had a thousand copies, the rays of each would be tested against all of them. A stable
 * sort by key brings copies together. False: no memory. */
static bool find_twins(occluders *o)
{
    uint32_t count = o->s.scene->solid_count;
    uint32_t *key = alloc_array(count, sizeof *key), *order = alloc_array(count, sizeof *order);
    bool done = key && order;
    for (uint32_t i = 0; done && i < count; i++) {
        key[i] = solid_key(o, i);
        o->twin[i] = i;
    }
    done = done && radix_order(key, count, order);
    uint32_t first = 0, alike = 0; /* order[first], and `alike` - 1 copies of it so far */
    for (uint32_t k = 0; done && k < count; k++) {
        if (alike > 0 && key[order[k]] == key[order[first]] && scene_is_convex(o->s.scene, order[k]) &&
            scene_is_convex(o->s.scene, order[first]) && is_copy(o, order[first], order[k])) {
            if (++alike > 2)
                o->twin[order[k]] = order[first];
        } else {
            first = k;
            alike = 1;
        }
    }
    free(key);
    free(order);
    return done;
}

/* ---- the whole ------------------------------------------------------------------------------------------------- */

bool occluders_build(occluders *o, const roberts_scene *scene, const view *v, const double *rays)
{
    *o = (occluders){.face_solid = alloc_array(scene->face_count, sizeof *o->face_solid),
                     .twin = alloc_array(scene->solid_count, sizeof *o->twin),
                     .slack = alloc_zeroed(scene->solid_count, sizeof *o->slack)};
    if (!o->face_solid || !o->twin || !o->slack || !sight_prepare(&o->s, scene, v) || !sight_sample(&o->s) ||
        !find_twins(o))
        goto failed;
    for (uint32_t solid = 0; solid < scene->solid_count; solid++) {
        for (uint32_t face = scene->solid[solid].face; face < scene->solid[solid + 1].face; face++) {
            o->face_solid[face] = solid;
            o->slack[solid] = fmax(o->slack[solid], SIGHT_MARGIN * scene_deviation(scene, face) / o->s.unit);
        }
    }
    set_picture(o, v);
    if (build_tree(o, rays))
        return true;
failed:
    occluders_free(o);
    return false;
}

void occluders_free(occluders *o)
{
    sight_free(&o->s);
    tree_free(&o->t);
    free(o->face_solid);
    free(o->twin);
    free(o->slack);
    *o = (occluders){0};
}

/* ---- positions ------------------------------------------------------------------------------------------------- */

/* Maps the range from low to high to 0 .. 65535; NaN to 0. */
static uint32_t cell(double x, double low, double high)
{
    double part = (x - low) / (high - low);
    return part >= 1.0 ? 65535 : part > 0.0 ? (uint32_t)(65536.0 * part) : 0;
}

uint32_t occluders_place(const occluders *o, roberts_vec3 X)
{
    roberts_vec3 p = picture_point(o, X);
    return bits_spread(cell(p.x, o->window.lo.x, o->window.hi.x)) |
           bits_spread(cell(p.y, o->window.lo.y, o->window.hi.y)) << 1;
}

/* ---- which faces take part ------------------------------------------------------------------------------------- */

bool occluders_take_part(const occluders *o, const occluders_asker *of, uint32_t face)
{
    const roberts_scene *scene = o->s.scene;
    return !seen_owns(scene, &of->none, seen_face_key(scene, o->face_solid[face], face));
}

/* ---- casting --------------------------------------------------------------------------------------------------- */

/* Queries that go through the tree. */
typedef struct casting {
    const occluders *o;
    sight_question *question;
    roberts_vec3 v[TREE_POINTS]; /* toward the viewer */
    tree_points points;          /* live: those not yet answered "surely" */
} casting;

static sight_answer hides_strictly(const occluders *o, uint32_t face, const sight_question *q, roberts_vec3 v,
                                   double slack)
{
    const scene_solid *solid = &o->s.scene->solid[o->face_solid[face]];
    sight_answer answer = sight_hides_strictly(&o->s, face, q->X, v, slack, q->ends);
    bool convex = scene_is_convex(o->s.scene, o->face_solid[face]);
    for (uint32_t f = solid[0].face; convex && answer == SIGHT_SURELY && f < solid[1].face; f++)
        if (!sight_well_behind(&o->s, f, q->X))
            answer = SIGHT_POSSIBLY;
    return answer;
}

/* Records a hider for a query about the nearest one. From now on the point counts as lying on the hider, so lower boxes
 * are skipped. */
static void keep_nearest(casting *c, uint32_t i, uint32_t face)
{
    sight_question *q = &c->question[i];
    double height = picture_point(c->o, sight_meet(&c->o->s, face, q->X, c->v[i])).z;
    if (q->hider == ROBERTS_NONE || height > q->height) {
        q->hider = face;
        q->height = height;
        tree_points_raise(&c->points, i, height);
    }
}

/* Tests whether the face hides those of the points whose answer may still change. */
static void test_face(casting *c, uint32_t face, tree_set points)
{
    const occluders *o = c->o;
    uint32_t solid = o->face_solid[face];
    bool convex = scene_is_convex(o->s.scene, solid);
    while (!tree_set_is_empty(&points)) {
        uint32_t i = tree_set_take(&points);
        sight_question *q = &c->question[i];
        if ((q->answer == SIGHT_SURELY && !q->nearest) || !occluders_take_part(o, &q->of, face))
            continue;
        double slack = convex && q->of.own && solid == o->twin[q->of.solid] ? o->slack[q->of.solid] : 0.0;
        sight_answer answer =
            q->ends ? hides_strictly(o, face, q, c->v[i], slack) : sight_hides(&o->s, face, q->X, c->v[i], slack);
        if (answer > q->answer)
            q->answer = answer;
        if (answer == SIGHT_SURELY && q->nearest) {
            keep_nearest(c, i, face);
        } else if (answer == SIGHT_SURELY) {
            q->hider = face;
            tree_points_drop(&c->points, i);
        }
    }
}

/* Tests the front faces of an item. If there are several, each is tested only with the points under its own box. */
static void test_item(casting *c, tree_item item, const tree_set *points)
{
    const occluders *o = c->o;
    if (item.count == 1) {
        test_face(c, item.first, *points);
        return;
    }
    for (uint32_t face = item.first; face < item.first + item.count; face++) {
        if (o->s.facing[face] == SIGHT_NOT_FRONT)
            continue;
        tree_entry box = entry_of(o, face_box(o, face), o->face_solid[face], item);
        test_face(c, face, tree_points_under(&c->points, &box, points));
    }
}

void occluders_cast(const occluders *o, tree_walk *w, sight_question *question, uint32_t count)
{
    casting c = {.o = o, .question = question};
    tree_leaf leaf;
    for (uint32_t i = 0; i < count; i++) {
        sight_question *q = &question[i];
        q->answer = SIGHT_NO;
        q->hider = ROBERTS_NONE;
        c.v[i] = sight_from(&o->s, q->X);
        tree_points_add(&c.points, picture_point(o, q->X), q->of.own ? o->s.scene->solid_count : q->of.solid);
    }
    tree_walk_start(w, &c.points);
    while (tree_walk_next(w, &leaf)) {
        tree_set live = c.points.live;
        for (const tree_item *item = leaf.item; item < leaf.item + leaf.item_count; item++)
            test_item(&c, *item, &leaf.points);
        if (memcmp(&live, &c.points.live, sizeof live) != 0)
            tree_walk_keep(w);
    }
}

/* ---- searching ------------------------------------------------------------------------------------------------- */

void occluders_search_start(occluders_search *s, const occluders *o, roberts_vec3 A, roberts_vec3 B, occluders_asker of)
{
    s->o = o;
    s->A = A;
    s->B = B;
    s->of = of;
    s->item = s->item_end = NULL;
    s->face = s->face_end = 0;
    tree_search_start(&s->tree, &o->t, picture_point(o, A), picture_point(o, B),
                      of.own ? o->s.scene->solid_count : of.solid);
}

/* Moves to the next item of the leaf, or to the first item of the next leaf. False at the end. */
static bool next_item(occluders_search *s)
{
    tree_leaf leaf;
    if (s->item == s->item_end) {
        if (!tree_search_next(&s->tree, &leaf))
            return false;
        s->item = leaf.item;
        s->item_end = leaf.item + leaf.item_count;
    }
    s->face = s->item->first;
    s->face_end = s->item->first + s->item->count;
    s->item++;
    return true;
}

bool occluders_search_next(occluders_search *s, uint32_t *face, sight_part *part)
{
    do {
        while (s->face < s->face_end) {
            *face = s->face++;
            if (occluders_take_part(s->o, &s->of, *face) && sight_hidden_part(&s->o->s, *face, s->A, s->B, part))
                return true;
        }
    } while (next_item(s));
    return false;
}
