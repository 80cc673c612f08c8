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

/* ---- the tree --------------------------------------------------------------------------------------------------- */

/* Boxes on their way into the tree, and the faces that they belong to. */
typedef struct box_list {
    tree_box *box;
    uint32_t *face, *solid;
    size_t count, box_room, face_room, solid_room;
} box_list;

static const tree_box no_box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static void extend(tree_box *box, roberts_vec3 p)
{
    box->lo = (roberts_vec3){fmin(box->lo.x, p.x), fmin(box->lo.y, p.y), fmin(box->lo.z, p.z)};
    box->hi = (roberts_vec3){fmax(box->hi.x, p.x), fmax(box->hi.y, p.y), fmax(box->hi.z, p.z)};
}

/* Boxes round the parts of a face between `count` + 1 evenly spaced planes across the longest side of `whole`, the box
 * round all of it. Convex, a part reaches no farther than what its borders' sides reach between the planes. */
static void slice_face(const occluders *o, uint32_t face, tree_box whole, tree_box *slice, uint32_t count)
{
    const roberts_scene *scene = o->s.scene;
    int axis = tree_longest_axis(whole);
    double low = tree_component(whole.lo, axis), step = (tree_component(whole.hi, axis) - low) / count;
    for (uint32_t i = 0; i < count; i++)
        slice[i] = no_box;
    uint32_t end = scene->face_start[face + 1];
    roberts_vec3 A = o->s.P[scene->corner[end - 1]];
    for (uint32_t k = scene->face_start[face]; k < end; k++) {
        roberts_vec3 B = o->s.P[scene->corner[k]];
        bool up = tree_component(A, axis) <= tree_component(B, axis);
        roberts_vec3 L = up ? A : B, LH = vec3_sub(up ? B : A, L);
        double l = (tree_component(L, axis) - low) / step, h = l + tree_component(LH, axis) / step;
        for (uint32_t i = l > 0.0 ? (uint32_t)fmin(l, count - 1) : 0; i < count && (i <= h || i == 0); i++) {
            double in = h > l ? fmax(0.0, (i - l) / (h - l)) : 0.0,
                   out = h > l ? fmin(1.0, (i + 1 - l) / (h - l)) : 1.0;
            extend(&slice[i], vec3_add(L, vec3_scale(in, LH)));
            extend(&slice[i], vec3_add(L, vec3_scale(out, LH)));
        }
        A = B;
    }
}

static double total_area(const tree_box *box, uint32_t count)
{
    double area = 0.0;
    for (uint32_t i = 0; i < count; i++)
        area += tree_box_area(box[i]);
    return area;
}

/* Leaves in `slice` the boxes of a face, and returns how many. A long face across the axes fills little of its box, and
 * a heap of such faces makes a tree useless. Slicing helps (Ernst and Greiner, "Early split clipping for bounding volume
 * hierarchies", 2007), where the rays saved, in proportion to the surface saved, outweigh the boxes added. */
static uint32_t boxes_of_face(const occluders *o, uint32_t face, double rays_per_area, tree_box *slice)
{
    const roberts_scene *scene = o->s.scene;
    tree_box finer[SLICES], whole = no_box;
    uint32_t count = 1;
    for (uint32_t k = scene->face_start[face]; k < scene->face_start[face + 1]; k++)
        extend(&whole, o->s.P[scene->corner[k]]);
    slice[0] = whole;
    double area = tree_box_area(whole);
    while (2 * count <= SLICES && rays_per_area * area > SLICE_COST * count) {
        slice_face(o, face, whole, finer, 2 * count);
        double less = total_area(finer, 2 * count);
        if (!(less < SLICE_GAIN * area && rays_per_area * (area - less) > SLICE_COST * count))
            break;
        count *= 2;
        area = less;
        for (uint32_t i = 0; i < count; i++)
            slice[i] = finer[i];
    }
    return count;
}

static bool add_face(const occluders *o, uint32_t face, double rays_per_area, double margin, box_list *list)
{
    tree_box slice[SLICES];
    const roberts_vec3 grow = {margin, margin, margin};
    uint32_t count = boxes_of_face(o, face, rays_per_area, slice);
    if (!array_reserve(&list->box, &list->box_room, list->count + count, sizeof *list->box) ||
        !array_reserve(&list->face, &list->face_room, list->count + count, sizeof *list->face) ||
        !array_reserve(&list->solid, &list->solid_room, list->count + count, sizeof *list->solid))
        return false;
    for (uint32_t i = 0; i < count; i++) {
        list->box[list->count] = (tree_box){vec3_sub(slice[i].lo, grow), vec3_add(slice[i].hi, grow)};
        list->solid[list->count] = o->face_solid[face];
        list->face[list->count++] = face;
    }
    return true;
}

/* The tree over the faces that may hide, each in boxes that hold whatever counts as touching it. */
static bool build_tree(occluders *o, double rays)
{
    const roberts_scene *scene = o->s.scene;
    double margin = BOX_MARGIN * (o->s.loose + o->s.rounding);
    box_list list = {0};
    tree_box all = no_box;
    bool built = true;
    for (uint32_t i = 0; i < scene->vertex_count; i++)
        extend(&all, o->s.P[i]);
    for (uint32_t face = 0; built && face < scene->face_count; face++)
        if (o->s.facing[face] != SIGHT_NOT_FRONT)
            built = add_face(o, face, rays / tree_box_area(all), margin, &list);
    built = built && list.count < UINT32_MAX && tree_build(&o->t, list.box, list.solid, (uint32_t)list.count);
    o->box_face = list.face;
    free(list.box);
    free(list.solid);
    return built;
}

bool occluders_build(occluders *o, const roberts_scene *scene, const view *v, double rays)
{
    *o = (occluders){.face_solid = alloc_array(scene->face_count, sizeof *o->face_solid),
                     .slack = alloc_zeroed(scene->solid_count, sizeof *o->slack)};
    if (!o->face_solid || !o->slack || !sight_prepare(&o->s, scene, v))
        goto failed;
    for (uint32_t solid = 0; solid < scene->solid_count; solid++) {
        for (uint32_t face = scene->solid[solid].face; face < scene->solid[solid + 1].face; face++) {
            o->face_solid[face] = solid;
            o->slack[solid] = fmax(o->slack[solid], SIGHT_MARGIN * scene->face_deviation[face] / o->s.unit);
        }
    }
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
    tree_walk_start(&walk, &o->t, (roberts_ray){q->X, v}, o->s.perspective ? 1.0 : INFINITY,
                    q->own ? ROBERTS_NONE : q->solid);
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
