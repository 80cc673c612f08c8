/* occluders.c - all that may hide something. See occluders.h. */
#include "ray/occluders.h"

#include <stdlib.h>

#include "base/array.h"

/* How far boxes reach beyond their faces, in loose epsilons: a corner of angle a, grown by epsilon, sticks out by
 * epsilon / sin (a / 2). */
#define BOX_MARGIN 1000.0
/* Faces are cut into so many boxes at the most, doubling while all boxes together shrink at least to this part and save
 * more asking of boxes than so many for each new one (what building it costs, measured). */
#define SLICES 256
#define SLICE_GAIN 0.75
#define SLICE_COST 20.0

/* ---- the picture ------------------------------------------------------------------------------------------------ */

/* Two directions across the line of sight, and it. Which way up does not matter: nothing is shown. */
static void set_picture(occluders *o, const view *v)
{
    roberts_vec3 d = o->s.perspective ? v->dir : o->s.viewpoint;
    bool steep = fabs(d.z) > 0.7;
    o->right = vec3_cross(steep ? (roberts_vec3){1, 0, 0} : (roberts_vec3){0, 0, 1}, d);
    o->right = vec3_scale(1.0 / vec3_length(o->right), o->right);
    o->up = vec3_cross(d, o->right);
    o->toward = d;
}

/* A point in the picture; z is the height, or one over the distance from the eye's plane: both grow toward the viewer,
 * and both are linear where planes are. */
static roberts_vec3 picture_point(const occluders *o, roberts_vec3 X)
{
    if (!o->s.perspective)
        return (roberts_vec3){vec3_dot(o->right, X), vec3_dot(o->up, X), vec3_dot(o->toward, X)};
    roberts_vec3 q = vec3_sub(X, o->s.viewpoint);
    double w = -1.0 / vec3_dot(o->toward, q);
    return (roberts_vec3){w * vec3_dot(o->right, q), w * vec3_dot(o->up, q), w};
}

/* ---- the tree --------------------------------------------------------------------------------------------------- */

/* Boxes on their way into the tree, and the faces that they belong to. */
typedef struct box_list {
    tree_box *box;
    uint32_t *face, *solid;
    size_t count, box_room, face_room, solid_room;
    double floor, rays_per_shadow;
} box_list;

static const tree_box no_box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static void extend(tree_box *box, roberts_vec3 p)
{
    box->lo = (roberts_vec3){lesser(box->lo.x, p.x), lesser(box->lo.y, p.y), lesser(box->lo.z, p.z)};
    box->hi = (roberts_vec3){greater(box->hi.x, p.x), greater(box->hi.y, p.y), greater(box->hi.z, p.z)};
}

static tree_box face_box(const occluders *o, uint32_t face)
{
    const roberts_scene *scene = o->s.scene;
    tree_box box = no_box;
    for (uint32_t k = scene->face_start[face]; k < scene->face_start[face + 1]; k++)
        extend(&box, picture_point(o, o->s.P[scene->corner[k]]));
    return box;
}

/* Boxes round the parts of a face between `count` + 1 evenly spaced lines across the longer side of `whole`, the box
 * round all of it. Convex, a part reaches no farther than what its borders' sides reach between the lines. */
static void slice_face(const occluders *o, uint32_t face, tree_box whole, tree_box *slice, uint32_t count)
{
    const roberts_scene *scene = o->s.scene;
    bool along_x = whole.hi.x - whole.lo.x > whole.hi.y - whole.lo.y;
    double low = along_x ? whole.lo.x : whole.lo.y, step = ((along_x ? whole.hi.x : whole.hi.y) - low) / count;
    for (uint32_t i = 0; i < count; i++)
        slice[i] = no_box;
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
            extend(&slice[i], vec3_add(L, vec3_scale(in, LH)));
            extend(&slice[i], vec3_add(L, vec3_scale(out, LH)));
        }
        A = B;
    }
}

/* Leaves in `slice` the boxes of a face, and returns how many. A long face across the axes fills little of its box, and
 * a heap of such faces makes a tree useless. Slicing helps (Ernst and Greiner, "Early split clipping for bounding volume
 * hierarchies", 2007), where the rays saved, in proportion to the shadow saved, outweigh the boxes added. */
static uint32_t boxes_of_face(const occluders *o, uint32_t face, const box_list *list, tree_box *slice)
{
    tree_box finer[SLICES], whole = face_box(o, face);
    uint32_t count = 1;
    double rays = list->rays_per_shadow * tree_box_shadow(whole, list->floor); /* that ask for one of the boxes */
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

/* The box with a margin of this length in the model. */
static tree_box grown(const occluders *o, tree_box box, double margin)
{
    roberts_vec3 m = {margin, margin, margin};
    if (o->s.perspective) {
        m.x = margin * box.hi.z * (1.0 + greater(fabs(box.lo.x), fabs(box.hi.x)));
        m.y = margin * box.hi.z * (1.0 + greater(fabs(box.lo.y), fabs(box.hi.y)));
        m.z = margin * box.hi.z * box.hi.z;
    }
    return (tree_box){vec3_sub(box.lo, m), vec3_add(box.hi, m)};
}

static bool add_face(const occluders *o, uint32_t face, box_list *list)
{
    double margin = BOX_MARGIN * (o->s.loose + o->s.rounding);
    tree_box slice[SLICES];
    uint32_t count = boxes_of_face(o, face, list, slice);
    if (!array_reserve(&list->box, &list->box_room, list->count + count, sizeof *list->box) ||
        !array_reserve(&list->face, &list->face_room, list->count + count, sizeof *list->face) ||
        !array_reserve(&list->solid, &list->solid_room, list->count + count, sizeof *list->solid))
        return false;
    for (uint32_t i = 0; i < count; i++) {
        list->box[list->count] = grown(o, slice[i], margin);
        list->solid[list->count] = o->face_solid[face];
        list->face[list->count++] = face;
    }
    return true;
}

/* The tree over the faces that may hide, each in boxes that hold whatever counts as touching it. */
static bool build_tree(occluders *o, const double *rays)
{
    const roberts_scene *scene = o->s.scene;
    box_list list = {0};
    tree_box all = no_box;
    bool built = true;
    for (uint32_t i = 0; i < scene->vertex_count; i++)
        extend(&all, picture_point(o, o->s.P[i]));
    list.floor = all.lo.z;
    for (uint32_t solid = 0; solid < scene->solid_count; solid++) {
        list.rays_per_shadow = 2.0 * rays[solid] / tree_box_shadow(all, all.lo.z); /* they start at half the height */
        for (uint32_t face = scene->solid[solid].face; built && face < scene->solid[solid + 1].face; face++)
            if (o->s.facing[face] != SIGHT_NOT_FRONT)
                built = add_face(o, face, &list);
    }
    built = built && list.count < UINT32_MAX && tree_build(&o->t, list.box, list.solid, (uint32_t)list.count);
    o->box_face = list.face;
    free(list.box);
    free(list.solid);
    return built;
}

bool occluders_build(occluders *o, const roberts_scene *scene, const view *v, const double *rays)
{
    *o = (occluders){.face_solid = alloc_array(scene->face_count, sizeof *o->face_solid),
                     .slack = alloc_zeroed(scene->solid_count, sizeof *o->slack)};
    if (!o->face_solid || !o->slack || !sight_prepare(&o->s, scene, v))
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
    free(o->box_face);
    free(o->face_solid);
    free(o->slack);
    *o = (occluders){0};
}

/* ---- casting ---------------------------------------------------------------------------------------------------- */

static sight_answer ask(const occluders *o, const sight_question *q, uint32_t face, roberts_vec3 v)
{
    bool own = o->face_solid[face] == q->solid;
    if (own && !q->own)
        return SIGHT_NO;
    return sight_hides(&o->s, face, q->X, v, own ? o->slack[q->solid] : 0.0);
}

sight_answer occluders_cast(const occluders *o, const sight_question *q, uint32_t *hider)
{
    roberts_vec3 v = sight_from(&o->s, q->X);
    sight_answer answer = SIGHT_NO;
    const uint32_t *item;
    tree_walk walk;
    if (*hider != ROBERTS_NONE && ask(o, q, *hider, v) == SIGHT_SURELY)
        return SIGHT_SURELY;
    tree_walk_start(&walk, &o->t, picture_point(o, q->X), q->own ? ROBERTS_NONE : q->solid);
    for (uint32_t count; (count = tree_walk_next(&walk, &item)) > 0;) {
        for (uint32_t i = 0; i < count; i++) {
            uint32_t face = o->box_face[item[i]];
            sight_answer one = ask(o, q, face, v);
            if (one == SIGHT_SURELY) {
                *hider = face;
                return SIGHT_SURELY;
            }
            if (one == SIGHT_POSSIBLY)
                answer = one;
        }
    }
    return answer;
}
