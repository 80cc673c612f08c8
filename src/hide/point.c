/* point.c - what lies at a point of the picture. See point.h. */
#include "hide/point.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/bits.h"

/* ---- the faces of a front ---------------------------------------------------------------------------------------- */

/* Is a point of the picture inside a face, or within epsilon of it? */
static bool is_in(const hide_fronts *fronts, const hide_face *F, roberts_vec2 X)
{
    return hide_polygon_holds(fronts, &fronts->face_runs, F->corner, F->count, X, fronts->space.epsilon);
}

/* The faces of a front that may hold a point of the picture: of a bundle those that its tree finds, of others all. */
typedef struct face_walk {
    const hide_face *face;
    const bundle *tree;
    roberts_vec2 X;
    uint32_t next, end;
} face_walk;

/* single: room for a single face, empty. */
static face_walk face_walk_begin(const hide_fronts *fronts, uint32_t front, roberts_vec2 X, hide_single *single)
{
    face_walk w = {.tree = hide_bundle(fronts, front), .X = X};
    uint32_t count;
    w.face = hide_faces(fronts, front, &count, single);
    w.end = w.tree ? 0 : count;
    return w;
}

/* NULL: there is none. */
static const hide_face *face_walk_next(face_walk *w)
{
    if (w->next == w->end && !(w->tree && bundle_next(w->tree, w->X.x, w->X.y, &w->next, &w->end)))
        return NULL;
    const uint32_t at = w->next++;
    return &w->face[w->tree ? w->tree->order[at] : at];
}

/* ---- what is seen at a point ------------------------------------------------------------------------------------- */

/* A search for the solid seen at a point: the result so far. */
typedef struct look {
    roberts_vec2 X;
    double best;               /* the nearest depth */
    const hide_front *nearest; /* whose it is */
    const uint32_t *corner;    /* of its face */
    double touch;              /* of its face */
    bool touching;             /* the nearest depth is known; now find who touches it */
    bool again;                /* another face may touch the nearest one */
    bool faces;                /* the face is wanted too */
    uint32_t solid;            /* the smallest number that touches there */
    uint32_t face;             /* the smallest one of that solid that touches there */
    plane F;                   /* its plane; at first, that of the nearest face */
} look;

/* The number in the scene of a face of a front, by its corners. */
static uint32_t face_of_front(const hide_fronts *fronts, const hide_front *front, const uint32_t *corner)
{
    const roberts_scene *scene = fronts->scene;
    if (hide_is_face(front))
        return front->piece;
    uint32_t low = scene->solid[front->solid].face, high = scene->solid[front->solid + 1].face;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (scene->corner + scene->face_start[middle] <= corner)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Looks at a face. held: the point is known to be in its picture. */
static void look_at_face(const hide_fronts *fronts, const hide_front *front, const hide_face *F, double z1, bool held,
                         look *l)
{
    double behind = plane_at(F->F, (roberts_vec3){l->X.x, l->X.y, l->best}); /* that of the nearest depth, so far */
    if (l->touching ? !(fabs(behind) <= 2.0 * F->touch) : behind < -2.0 * F->touch)
        return;
    if (!held && !is_in(fronts, F, l->X))
        return;
    if (!l->touching) {
        double z = lesser(z1, (F->F.a * l->X.x + F->F.b * l->X.y + F->F.d) / -F->F.c);
        if (z <= l->best) {
            l->again = true;
            return;
        }
        l->again =
            l->again || (l->nearest && fabs(plane_at(l->F, (roberts_vec3){l->X.x, l->X.y, z})) <= 2.0 * l->touch);
        l->best = z;
        l->nearest = front;
        l->corner = F->corner;
        l->touch = F->touch;
        l->F = F->F;
        return;
    }
    uint32_t face = l->faces ? face_of_front(fronts, front, F->corner) : ROBERTS_NONE;
    if (front->solid < l->solid || face < l->face) {
        l->face = face;
        l->F = F->F;
    }
    l->solid = front->solid;
}

static void look_at_front(const hide_fronts *fronts, uint32_t index, double z1, look *l)
{
    const hide_front *front = &fronts->front[index];
    hide_single single = {.front = ROBERTS_NONE};
    const bool held = hide_is_face(front); /* then its plane is computed only if the point is in it */
    if (held) {
        const hide_face outline = hide_outline(fronts, index, single.turned);
        if (!is_in(fronts, &outline, l->X))
            return;
    }
    face_walk walk = face_walk_begin(fronts, index, l->X, &single);
    for (const hide_face *F; (F = face_walk_next(&walk));)
        look_at_face(fronts, front, F, z1, held, l);
}

/* Looks at a front of a cell if it can matter. */
static inline void look_at_entry(const hide_fronts *fronts, uint32_t index, look *l)
{
    const hide_front *front = &fronts->front[index];
    const hide_box *box = &fronts->front_box[index];
    bool asked = l->touching && (l->faces ? front->solid > l->solid : front->solid >= l->solid);
    if (!asked && hide_box_holds(box, l->X.x, l->X.y, fronts->space.epsilon))
        look_at_front(fronts, index, (double)box->z1, l);
}

/* Examines the fronts of one cell whose boxes can hold the point, four at a time. beyond: how much farther than the
 * nearest depth a front is still examined. */
static void look_at_cell(const hide_fronts *fronts, const objet *grid, size_t cell, uint32_t sides, double beyond,
                         look *l)
{
    for (uint32_t k = grid->start[cell], end = grid->start[cell + 1]; k < end; k += 4) {
        unsigned near = objet_near(grid, k, end, sides);
        for (; near; near &= near - 1) {
            uint32_t index = grid->entry[k + (uint32_t)bits_trailing_zeros(near)].front;
            if ((double)fronts->front_box[index].z1 + beyond < l->best)
                return; /* all later fronts are farther too */
            look_at_entry(fronts, index, l);
        }
    }
}

/* The same for a cell with a tree. about: the point with its surroundings; its depth is set here. */
static void look_by_tree(const hide_fronts *fronts, const objet *grid, size_t cell, hide_box *about, double beyond,
                         look *l)
{
    const front_node *node = grid->tree[cell].node;
    const objet_entry *list = grid->entry + grid->start[cell];
    uint32_t stack[FRONT_TREE_WAITING] = {0}, depth = 1, found[4];
    while (depth > 0) {
        const uint32_t which = stack[--depth], child = which & ~FRONT_TREE_LEAF;
        if (child != which) {
            look_at_entry(fronts, list[child].front, l);
            continue;
        }
        about->z0 = hide_float_below(l->best - beyond);
        for (uint32_t k = front_node_meets_box(&node[child], about, found); k > 0; k--)
            stack[depth++] = found[k - 1]; /* the nearest one is next */
    }
}

static void look_once(const hide_fronts *fronts, const objet *grid, hide_box *about, look *l)
{
    const uint32_t column = scan_column(&grid->frame, l->X.x), row = scan_row(&grid->frame, l->X.y);
    const size_t cell = scan_number(&grid->frame, column, row);
    double beyond = l->touching || l->faces ? fronts->thickest : 0.0;
    if (l->faces)
        beyond = lesser(beyond, LOOK_DEPTH * fronts->seen->view.diameter);
    if (grid->tree && grid->tree[cell].node)
        look_by_tree(fronts, grid, cell, about, beyond, l);
    else
        look_at_cell(fronts, grid, cell, objet_most(objet_cut(objet_place(grid, about), column, row)), beyond, l);
}

/* Looks at l->X. */
static void look_there(const hide_fronts *fronts, const objet *grid, look *l)
{
    const double m = fronts->space.epsilon;
    hide_box about = {.x0 = hide_float_below(l->X.x - m),
                      .x1 = hide_float_above(l->X.x + m),
                      .y0 = hide_float_below(l->X.y - m),
                      .y1 = hide_float_above(l->X.y + m)};
    l->again = !l->faces;
    look_once(fronts, grid, &about, l);
    if (!l->nearest)
        return;
    if (!l->again && fabs(plane_at(l->F, (roberts_vec3){l->X.x, l->X.y, l->best})) <= 2.0 * l->touch) {
        l->solid = l->nearest->solid;
        l->face = face_of_front(fronts, l->nearest, l->corner);
        return;
    }
    l->touching = true;
    look_once(fronts, grid, &about, l);
}

uint32_t point_solid(const hide_fronts *fronts, const objet *grid, roberts_vec2 X)
{
    look l = {.X = X, .best = -INFINITY, .solid = ROBERTS_NONE};
    look_there(fronts, grid, &l);
    return l.solid;
}

uint32_t point_face(const hide_fronts *fronts, const objet *grid, roberts_vec2 X, plane *F)
{
    look l = {.X = X, .best = -INFINITY, .solid = ROBERTS_NONE, .faces = true, .face = ROBERTS_NONE};
    look_there(fronts, grid, &l);
    *F = l.F;
    return l.face;
}

/* ---- the layers in front of a point ------------------------------------------------------------------------------ */

/* The number of layers in front of a hidden point: Appel's quantitative invisibility ("The notion of quantitative
 * invisibility and the machine rendering of solids", ACM 1967).
 *
 * Appel counts the faces toward the viewer. Winding would tell which these are, but winding is not trusted here. The
 * line of sight comes from outside: it enters a closed body through the first face it meets, leaves through the second,
 * and so on. So every other face is toward the viewer.
 *
 * In the picture, the point may lie on the border of faces, for instance where equal blocks are stacked. Then the point
 * is moved slightly in four directions, so that it lies in exactly one of two faces with a common side. Faces are
 * closed, so for each body the direction with the most layers counts. */

enum { WAYS = 4 };

/* Directions along which no side of a usual model runs. */
static const roberts_vec2 way[WAYS] = {{0.842, 0.539}, {-0.539, 0.842}, {-0.842, -0.539}, {0.539, -0.842}};

/* Finds the directions in which X can be moved slightly so that it lies in the face, as bits. */
static unsigned ways_into(const hide_fronts *fronts, const hide_face *F, roberts_vec3 X)
{
    unsigned ways = (1u << WAYS) - 1;
    for (uint32_t i = 0; i < F->count && ways; i++) {
        roberts_vec3 P = fronts->P[F->corner[i]], Q = fronts->P[F->corner[i + 1 < F->count ? i + 1 : 0]];
        double dx = Q.x - P.x, dy = Q.y - P.y, H = dx * (X.y - P.y) - dy * (X.x - P.x);
        double band = fronts->space.epsilon * sqrt(dx * dx + dy * dy);
        if (H > band)
            continue;
        for (int k = 0; k < WAYS; k++)
            if (H < -band || !(dx * way[k].y - dy * way[k].x > 0.0))
                ways &= ~(1u << k);
    }
    return ways;
}

/* Records a face if it lies in front of X. False: no memory. */
static bool take_face(const hide_fronts *fronts, uint32_t body, const hide_face *F, roberts_vec3 X, level_hits *hits)
{
    if (plane_at(F->F, X) <= F->touch || !is_in(fronts, F, (roberts_vec2){X.x, X.y}))
        return true;
    if (!array_reserve(&hits->item, &hits->room, hits->count + 1, sizeof *hits->item))
        return false;
    hits->item[hits->count++] = (level_hit){body, ways_into(fronts, F, X)};
    return true;
}

static bool take_front(const hide_fronts *fronts, uint32_t index, roberts_vec3 X, level_hits *hits)
{
    hide_single single = {.front = ROBERTS_NONE};
    face_walk walk = face_walk_begin(fronts, index, (roberts_vec2){X.x, X.y}, &single);
    for (const hide_face *F; (F = face_walk_next(&walk));)
        if (!take_face(fronts, fronts->front[index].solid, F, X, hits))
            return false;
    return true;
}

static int by_body(const void *a, const void *b)
{
    const level_hit *p = a, *q = b;
    return (p->body > q->body) - (p->body < q->body);
}

/* Returns the layers of one body. hit[0 .. count - 1] are its faces in front of the point. */
static uint32_t layers(const roberts_scene *scene, const level_hit *hit, size_t count)
{
    uint32_t most = 0;
    for (int k = 0; k < WAYS; k++) {
        uint32_t met = 0;
        for (size_t i = 0; i < count; i++)
            met += hit[i].ways >> k & 1;
        most = met > most ? met : most;
    }
    if (scene_is_convex(scene, hit->body))
        return most > 0;
    return scene->surface->kind[hit->body] == ROBERTS_CLOSED ? (most + 1) / 2 : most;
}

bool point_level(const hide_fronts *fronts, const objet *grid, const seen_line *line, roberts_vec3 X, level_hits *hits,
                 uint32_t *level)
{
    size_t cell = scan_cell(&grid->frame, X.x, X.y);
    *level = seen_is_back(line->class);
    hits->count = 0;
    for (uint32_t k = grid->start[cell]; k < grid->start[cell + 1]; k++) {
        const uint32_t index = grid->entry[k].front;
        const bool copied = fronts->next_copy && index < fronts->whole_count;
        const hide_box *box = &fronts->front_box[index];
        if (!hide_box_holds(box, X.x, X.y, fronts->space.epsilon) || (double)box->z1 < X.z)
            continue;
        for (uint32_t i = index; i != ROBERTS_NONE; i = copied ? fronts->next_copy[i] : ROBERTS_NONE)
            if (!seen_owns(fronts->scene, &line->own, hide_key(fronts, &fronts->front[i])) &&
                !take_front(fronts, i, X, hits))
                return false;
    }
    if (hits->count > 1)
        qsort(hits->item, hits->count, sizeof *hits->item, by_body);
    for (size_t i = 0, next; i < hits->count; i = next) {
        for (next = i + 1; next < hits->count && hits->item[next].body == hits->item[i].body;)
            next++;
        *level += layers(fronts->scene, &hits->item[i], next - i);
    }
    *level += *level == 0; /* rounding has put X beside what hides it */
    return true;
}
