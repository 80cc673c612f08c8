/* front.c - see front.h. */
#include "hide/front.h"

#include <math.h>
#include <string.h>

#include "base/array.h"
#include "hide/face_pairs.h"
#include "hide/star_bodies.h"
#include "hide/tests.h"

/* A picture of n faces has about this times sqrt(n) columns of cells: see CELLS_PER_BOX in cells.c. */
#define CELLS_PER_ROOT 2.0
/* A cover more cells across than this (five or six mean boxes) gets its depth cell by cell, not one for all cells. */
#define COVER_WIDE 50.0

/* ---- the outline of a solid -------------------------------------------------------------------------------------- */

/* The outline of a convex solid is the cycle of its edges with exactly one front face, and it is convex. But a solid
 * given to few digits is convex only within its tolerance, and a face that is edge-on within epsilon is left out. Then
 * the cycle may turn inward, run out along a sliver and back, or fall apart. In these cases the convex hull of all
 * vertices replaces it. */

/* On a very small or flat solid, faces may count as edge-on within epsilon. Then the edges need not form one cycle. */
static uint32_t outline_cycle(const hide_fronts *fronts, uint32_t solid, uint32_t *next, uint32_t *outline)
{
    const scene_solid *own = &fronts->scene->solid[solid];
    const scene_edge *e = fronts->scene->edge + own->stored, *end = e + (own[1].edge - own->edge);
    const unsigned char *facing = fronts->seen->facing + own->face;
    uint32_t edges = 0, start = ROBERTS_NONE, count = 0, size = own[1].vertex - own->vertex;
    for (uint32_t v = 0; v < size; v++)
        next[v] = ROBERTS_NONE;
    for (; e < end; e++) {
        bool left = facing[e->f[0]] == VIEW_FRONT;
        if (left == (facing[e->f[1]] == VIEW_FRONT))
            continue;
        start = e->v[!left]; /* v[0] -> v[1] runs counter-clockwise round f[0] */
        if (next[start] != ROBERTS_NONE)
            return 0;
        next[start] = e->v[left];
        edges++;
    }
    if (edges < 3)
        return 0;
    uint32_t v = start;
    do {
        outline[count++] = v + own->vertex;
        v = next[v];
    } while (v != start && v != ROBERTS_NONE && count < edges);
    return v == start && count == edges ? edges : 0;
}

/* Returns the longer of a side's two components. The length is at most sqrt(2) times as much. */
static double span_of(roberts_vec3 side)
{
    return greater(fabs(side.x), fabs(side.y));
}

/* Does the outline turn left at corner b or go straight on? Decided in double-double numbers. An inward turn counts as
 * straight if the lines of both sides cut off at most half an epsilon from a front of this size. A turn straight back
 * fails, and so does a turn after a side of zero length. */
static BITS_RARE bool turns_left(const hide_fronts *fronts, uint32_t a, uint32_t b, uint32_t c, double size)
{
    const roberts_vec3 *P = fronts->P;
    roberts_vec3 AB = vec3_sub(P[b], P[a]), BC = vec3_sub(P[c], P[b]);
    double left = refine_side(&fronts->space, a, b, refine_vertex(&fronts->space, c)); /* NaN if AB has zero length */
    if (AB.x * BC.x + AB.y * BC.y <= 0.0)
        return left > 0.0;
    return left >= -INWARD_TURN * fronts->seen->view.epsilon / size * span_of(BC);
}

/* Tests 2 to 4 need a convex polygon. They take the inside as the inner side of every side's line, so a single side in
 * a wrong direction may cut off the whole front. A polygon is convex if it turns left or goes straight on at each
 * corner, and goes round once. It goes round once if exactly one corner joins a side that does not rise to one that
 * rises. */
static bool outline_is_convex(const hide_fronts *fronts, const uint32_t *outline, uint32_t corners, double size)
{
    const double plain =
        TURN_ROUNDINGS * fronts->seen->view.across_rounding * size; /* bounds the error of a product of two sides */
    int rounds = 0;
    if (corners < 3)
        return false;
    uint32_t a = outline[corners - 2], b = outline[corners - 1];
    roberts_vec3 AB = vec3_sub(fronts->P[b], fronts->P[a]);
    for (uint32_t i = 0; i < corners; i++) {
        uint32_t c = outline[i];
        roberts_vec3 BC = vec3_sub(fronts->P[c], fronts->P[b]);
        double left = AB.x * BC.y - AB.y * BC.x;
        if (left <= plain && !turns_left(fronts, a, b, c, size))
            return false;
        if (left >= 0.0 || AB.x * BC.x + AB.y * BC.y <= 0.0)
            rounds += AB.y <= 0.0 && BC.y > 0.0;
        else /* straight on, slightly to the right because of rounding */
            rounds -= AB.y > 0.0 && BC.y <= 0.0;
        a = b;
        b = c;
        AB = BC;
    }
    return rounds == 1;
}

/* Orders vertices by x, then by y; of several at one place, the nearest first. */
static bool comes_before(const hide_fronts *fronts, uint32_t a, uint32_t b)
{
    roberts_vec3 A = fronts->P[a], B = fronts->P[b];
    if (A.x != B.x)
        return A.x < B.x;
    if (A.y != B.y)
        return A.y < B.y;
    return A.z != B.z ? A.z > B.z : a < b;
}

/* Restores the heap item[0 .. count - 1], whose root is the vertex that comes last, if only item[root] is out of
 * place. */
static void sift(const hide_fronts *fronts, uint32_t *item, uint32_t root, uint32_t count)
{
    for (uint32_t child; (child = 2 * root + 1) < count; root = child) {
        if (child + 1 < count && comes_before(fronts, item[child], item[child + 1]))
            child++;
        if (!comes_before(fronts, item[root], item[child]))
            return;
        uint32_t moved = item[root];
        item[root] = item[child];
        item[child] = moved;
    }
}

static void sort(const hide_fronts *fronts, uint32_t *item, uint32_t count)
{
    for (uint32_t i = count / 2; i-- > 0;)
        sift(fronts, item, i, count);
    for (uint32_t end = count; end-- > 1;) {
        uint32_t last = item[0];
        item[0] = item[end];
        item[end] = last;
        sift(fronts, item, 0, end);
    }
}

/* A turn of a path: certainly to the left, whatever the rounding; back along its last side, to end on it; or any other,
 * at which there is no corner. */
typedef enum turn { TURN_LEFT, TURN_BACK, TURN_OTHER } turn;

/* Finds how the path a, b, c turns at b. */
static turn turn_of(const hide_fronts *fronts, uint32_t a, uint32_t b, uint32_t c)
{
    const roberts_vec3 *P = fronts->P;
    roberts_vec3 AB = vec3_sub(P[b], P[a]), AC = vec3_sub(P[c], P[a]);
    const double left = AB.x * AC.y - AB.y * AC.x;
    const double plain = TURN_ROUNDINGS * fronts->seen->view.across_rounding * hypot(AC.x, AC.y);
    if (left > plain)
        return TURN_LEFT;
    const double along = AB.x * AC.x + AB.y * AC.y;
    return left >= -plain && along > 0.0 && along < AB.x * AB.x + AB.y * AB.y ? TURN_BACK : TURN_OTHER;
}

/* Adds c to a chain, in place of the last corners at which the path to c does not turn left. The first `kept` corners
 * stay. If the path goes back along its last side, c lies on that, and is no corner. Returns how many corners the chain
 * then has; 0: more than `room`. */
static uint32_t add_corner(const hide_fronts *fronts, uint32_t *chain, uint32_t count, uint32_t kept, uint32_t room,
                           uint32_t c)
{
    for (; count > kept; count--) {
        const turn t = turn_of(fronts, chain[count - 2], chain[count - 1], c);
        if (t == TURN_BACK)
            return count;
        if (t == TURN_LEFT)
            break;
    }
    if (count == room)
        return 0;
    chain[count] = c;
    return count + 1;
}

/* Moves to the front the lowest of the vertices that may come first in order of x, whatever the rounding: it is a
 * corner. The first one may lie in the middle of an upright side. */
static void begin_with_corner(const hide_fronts *fronts, uint32_t *order, uint32_t size)
{
    const roberts_vec3 *P = fronts->P;
    const double most = P[order[0]].x + TURN_ROUNDINGS * fronts->seen->view.across_rounding;
    uint32_t lowest = 0;
    for (uint32_t i = 1; i < size && P[order[i]].x <= most; i++)
        lowest = P[order[i]].y < P[order[lowest]].y ? i : lowest;
    const uint32_t moved = order[0];
    order[0] = order[lowest];
    order[lowest] = moved;
}

/* Andrew's monotone chain: from the first point to the last and back, along the corners below and above the line
 * between them. A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information Processing
 * Letters 9(5), 1979. */
static uint32_t outline_hull(const hide_fronts *fronts, uint32_t solid, uint32_t *order, uint32_t *outline)
{
    const scene_solid *own = &fronts->scene->solid[solid];
    uint32_t size = own[1].vertex - own->vertex, count = 1;
    for (uint32_t v = 0; v < size; v++)
        order[v] = own->vertex + v;
    sort(fronts, order, size);
    begin_with_corner(fronts, order, size);
    const uint32_t first = outline[0] = order[0];
    for (uint32_t i = 1; i < size; i++)
        count = add_corner(fronts, outline, count, 1, size, order[i]);
    const uint32_t below = count, last = outline[count - 1];
    for (uint32_t i = size - 1; i-- > 1;) {
        if (turn_of(fronts, first, last, order[i]) != TURN_LEFT)
            continue;
        count = add_corner(fronts, outline, count, below, size, order[i]);
        if (count == 0)
            return 0; /* by rounding, a vertex above the line is also a corner below it */
    }
    while (count > below && turn_of(fronts, outline[count - 2], outline[count - 1], first) != TURN_LEFT)
        count--;
    return count >= 3 ? count : 0;
}

/* ---- faces and bounds -------------------------------------------------------------------------------------------- */

/* The front faces of a solid. */
typedef struct front_faces {
    hide_face *face; /* [count] */
    uint32_t count;
    double reach, touch; /* the least reach, the greatest touch */
    double steepest;     /* the least -c of their planes */
    uint32_t back, edge_on;
} front_faces;

/* Returns the sum of a box's three sides. */
static double box_size(const hide_box *box)
{
    return (double)(box->x1 - box->x0) + (double)(box->y1 - box->y0) + (double)(box->z1 - box->z0);
}

/* Finds how far distances from the face's plane can be trusted: to `touch` within the reach that is returned, to
 * `limit` everywhere. At the face, the error of the plane is about its rounding and the face's own departure from it.
 * At a distance r it is r / w times that, for a face of width w.
 *
 * The reach does not count the departure of a face that is not narrow. Far from the face, the plane is used only to
 * decide whether points behind the solid lie behind the plane. A sight line only gets deeper behind both, so the plane
 * must be accurate only near the solid. There its error is about the departure. */
static double set_trust(const hide_fronts *fronts, uint32_t solid, const scene_shape *shape, double stretch,
                        hide_face *f)
{
    const view *v = &fronts->seen->view;
    f->departure = 0.0f;
    double departure = shape->deviation * v->per_unit, width = shape->width * v->per_unit, rounded = 0.0;
    if (v->perspective) {
        double grown = 1.0 + (double)fronts->box[solid].z1 * v->inverse_distance; /* D / w at the nearest corner */
        double shrunk = lesser(1.0, 1.0 + (double)fronts->box[solid].z0 * v->inverse_distance);
        departure = (departure + v->plane_rounding) * stretch;
        f->departure = hide_float_above(departure);
        departure *= grown;
        rounded = v->plane_rounding * stretch * grown;
        width *= shrunk * shrunk;
    }
    double error = PLANE_ROUNDINGS * v->rounding + departure, far_error = error * (1.0 + 2.0 * v->extent / width);
    f->touch = v->epsilon + departure;
    f->limit = hide_float_below(far_error > 0.5 * f->touch ? f->touch - far_error : f->touch);
    if (departure > v->epsilon && box_size(&fronts->box[solid]) <= WIDTHS_OF_SOLID * width)
        departure = rounded;
    return width * (0.5 * (v->epsilon + departure) / (PLANE_ROUNDINGS * v->rounding + departure) - 1.0);
}

/* Faces of a tile get their memory at once for this many. */
#define FACES_AT_ONCE 256

/* Expects `count` faces more at the tile's place. */
static void expect_faces(const hide_fronts *fronts, front_tile *tile, uint32_t count)
{
    const uint32_t first = tile->expected_face, most = tile->end_face - first;
    if (count <= first - tile->face)
        return;
    count -= first - tile->face;
    count = count < FACES_AT_ONCE ? FACES_AT_ONCE : count;
    count = count < most ? count : most;
    array_expect(fronts->face + first, count * sizeof *fronts->face);
    tile->expected_face = first + count;
}

/* Finds the facing of the solid's faces, and stores the front faces at the tile's place.
 *
 * The fitted plane alone decides whether a face is front or back, even if corners lie beside the plane and the eye is
 * within a few departures of it. The picture of such a face is a sliver, and the rounding of its corners decides which
 * side is seen and what is hidden along the sliver. Both answers are right. Calling all such faces edge-on was tried on
 * 1,500 brick walls: it lost visible edges, and the order of the vertices decided which ones. */
static front_faces find_faces(hide_fronts *fronts, front_tile *tile, uint32_t solid)
{
    const roberts_scene *scene = fronts->scene;
    uint32_t end = scene->solid[solid + 1].face;
    front_faces found = {.face = fronts->face + tile->face, .reach = INFINITY, .steepest = 1.0};
    expect_faces(fronts, tile, end - scene->solid[solid].face);
    for (uint32_t face = scene->solid[solid].face; face < end; face++) {
        seen_face look;
        int facing = seen_front_face(fronts->seen, face, &look);
        if (facing != VIEW_FRONT) {
            found.back += facing == VIEW_BACK;
            found.edge_on += facing == VIEW_EDGE_ON;
            continue;
        }
        hide_face *f = &found.face[found.count++];
        f->F = look.F;
        f->corner = look.corner;
        f->count = look.count;
        scene_shape shape = scene_shape_of(scene, face);
        found.reach = lesser(found.reach, set_trust(fronts, solid, &shape, look.stretch, f));
        found.touch = greater(found.touch, f->touch);
        found.steepest = lesser(found.steepest, -f->F.c);
        tile->most_corners = f->count > tile->most_corners ? f->count : tile->most_corners;
    }
    return found;
}

/* Estimates how many cells of the lists a box meets along one axis. window: length of the window along that axis. */
static double cells_along(const hide_fronts *fronts, double length, double window)
{
    return 1.0 + (window > 0.0 ? CELLS_PER_ROOT * sqrt(fronts->scene->face_count) * length / window : 0.0);
}

/* Should the faces become a bundle, because their boxes overlap, or because very many lie in one cell? box: that of the
 * solid. */
static bool is_bundle(const hide_fronts *fronts, const front_faces *found, const hide_box *box)
{
    double width = (double)(box->x1 - box->x0), height = (double)(box->y1 - box->y0), area = 0.0;
    if (found->count <= BUNDLE_FACES || !fronts->bundles.at)
        return false;
    double cells = cells_along(fronts, width, fronts->high.x - fronts->low.x) *
                   cells_along(fronts, height, fronts->high.y - fronts->low.y);
    if (found->count > FACES_OF_A_CELL * cells)
        return true;
    for (uint32_t k = 0; k < found->count; k++) {
        box3 own = box3_of(fronts->P, found->face[k].corner, found->face[k].count);
        area += (own.hi.x - own.lo.x) * (own.hi.y - own.lo.y);
    }
    return area > DEPTH_OF_BUNDLE * width * height;
}

/* Makes each front face a front. False: no memory. */
static bool add_single_fronts(const hide_fronts *fronts, front_tile *tile, uint32_t solid, const front_faces *found)
{
    uint32_t piece = fronts->scene->solid[solid].face;
    size_t need = tile->single_count + found->count;
    if (!array_reserve(&tile->single, &tile->single_room, need, sizeof *tile->single) ||
        !array_reserve(&tile->single_box, &tile->single_box_room, need, sizeof *tile->single_box))
        return false;
    for (uint32_t k = 0; k < found->count; k++, piece++) {
        while (fronts->seen->facing[piece] != VIEW_FRONT)
            piece++;
        box3 own = box3_of(fronts->P, found->face[k].corner, found->face[k].count);
        tile->single_box[tile->single_count] = hide_box_around(&own);
        tile->single[tile->single_count++] =
            (hide_front){.solid = solid, .piece = piece, .listed = true, .kind = HIDE_SOLID_FACE};
    }
    return true;
}

/* Rounds as hide_box_around() does. */
BITS_INLINE hide_box box_of_face_inline(const hide_fronts *fronts, uint32_t face)
{
    const uint32_t *start = fronts->scene->face_start + face, *corner = fronts->scene->corner + start[0];
    const roberts_vec3 *p = &fronts->P[corner[0]];
    two low = two_of(p->x, p->y), high = low, ulp = two_all(0x1p-23);
    double far = p->z, near = far;
    for (uint32_t i = 1; i < start[1] - start[0]; i++) {
        p = &fronts->P[corner[i]];
        two q = two_of(p->x, p->y);
        low = two_lesser(low, q);
        high = two_greater(high, q);
        far = lesser(far, p->z);
        near = greater(near, p->z);
    }
    hide_box box = {.z0 = hide_float_below(far), .z1 = hide_float_above(near)};
    two_part_floats(&box.x0, &box.y0, two_sub(low, two_mul(two_abs(low), ulp)));
    two_part_floats(&box.x1, &box.y1, two_add(high, two_mul(two_abs(high), ulp)));
    return box;
}

hide_box front_box_of_face(const hide_fronts *fronts, uint32_t face)
{
    return box_of_face_inline(fronts, face);
}

BITS_INLINE void set_face(hide_fronts *fronts, uint32_t to, uint32_t body, uint32_t face)
{
    fronts->front_box[to] = box_of_face_inline(fronts, face);
    fronts->front[to] = (hide_front){.solid = body, .piece = face, .listed = true, .kind = HIDE_SURFACE_FACE};
}

void front_set_face(hide_fronts *fronts, uint32_t to, uint32_t body, uint32_t face)
{
    set_face(fronts, to, body, face);
}

/* Is it a closed body whose faces are all wound alike? Then a line of sight meets them alternately from both sides,
 * wherever the body does not cross itself. */
static bool is_wound_alike(const roberts_scene *scene, uint32_t body)
{
    const uint8_t *is = scene->surface->edge_is + scene->solid[body].edge;
    uint32_t count = scene->solid[body + 1].edge - scene->solid[body].edge;
    return scene->surface->kind[body] == ROBERTS_CLOSED && is[0] == EDGE_TURNED_1 &&
           memcmp(is, is + 1, (count - 1) * sizeof *is) == 0;
}

/* star_body_rear() of a body whose faces are wound alike. */
static unsigned char rear_of(const hide_fronts *fronts, uint32_t body)
{
    const roberts_scene *scene = fronts->scene;
    if (scene->low || scene->face_deviation)
        return VIEW_UNKNOWN;
    const box3 box = face_pairs_body_box(scene, body);
    return star_body_rear(scene, body, &box, FILTER_APART * scene->unit * fronts->space.epsilon);
}

/* Makes each face of a body that is not convex a front, unless it is edge-on. If the body is closed, faces at its rear
 * are late. Where the rear is not known, these are guessed to be the faces that turn the other side to the viewer than
 * the face whose first corner is nearest. False: no memory. */
static BITS_RARE bool add_surface(hide_fronts *fronts, cover_scratch *w, front_tile *tile, uint32_t body)
{
    const roberts_scene *scene = fronts->scene;
    uint32_t first = scene->solid[body].face, end = scene->solid[body + 1].face, to = tile->surface;
    double nearest[] = {[VIEW_FRONT] = -INFINITY, [VIEW_BACK] = -INFINITY, [VIEW_EDGE_ON] = -INFINITY};
    uint32_t faces[] = {[VIEW_EDGE_ON] = 0};
    int late = VIEW_EDGE_ON;
    for (uint32_t face = first; face < end; face++) {
        const uint32_t *start = scene->face_start + face;
        int facing = seen_either_face(fronts->seen, face);
        faces[facing]++;
        nearest[facing] = greater(nearest[facing], fronts->P[scene->corner[start[0]]].z);
        if (start[1] - start[0] > tile->most_corners && facing != VIEW_EDGE_ON)
            tile->most_corners = start[1] - start[0];
    }
    tile->faces += faces[VIEW_FRONT];
    tile->back += faces[VIEW_BACK];
    tile->edge_on += faces[VIEW_EDGE_ON];
    if (fronts->late && is_wound_alike(scene, body)) {
        late = fronts->rear[body] = rear_of(fronts, body);
        if (late == VIEW_UNKNOWN)
            late = nearest[VIEW_FRONT] >= nearest[VIEW_BACK] ? VIEW_BACK : VIEW_FRONT;
        fronts->late[body] = (unsigned char)late;
    }
    for (uint32_t face = first; face < end; face++) {
        int facing = fronts->seen->facing[face];
        if (facing != VIEW_EDGE_ON && (facing != late || !fronts->waits))
            set_face(fronts, to++, body, face);
    }
    const uint32_t first_front = tile->surface;
    tile->surface = to;
    return (!fronts->cover.depth || cover_add_body(fronts, w, body, late)) &&
           cover_add_own(fronts, body, first_front, to);
}

void hide_make_face(const hide_fronts *fronts, uint32_t solid, uint32_t piece, hide_single *to)
{
    seen_face look;
    scene_shape shape = seen_face_again(fronts->seen, piece, &look, to->turned);
    to->face.F = look.F;
    to->face.corner = look.corner;
    to->face.count = look.count;
    set_trust(fronts, solid, &shape, look.stretch, &to->face);
}

/* Makes runs for those of the faces and the outline that have many corners. False: no memory. */
static bool enter_runs(hide_fronts *fronts, const front_faces *found, const uint32_t *outline, uint32_t corners)
{
    if (!fronts->face_runs.at)
        return true;
    for (uint32_t k = 0; k < found->count; k++)
        if (!runs_enter(&fronts->face_runs, &fronts->space, found->face[k].corner, found->face[k].count))
            return false;
    return runs_enter(&fronts->outline_runs, &fronts->space, outline, corners);
}

/* Is the box many cells of covers across? */
static bool is_wide(const hide_fronts *fronts, const hide_box *box)
{
    const scan_frame *f = &fronts->cover.frame;
    return scan_columns(f, (double)box->x0, (double)box->x1) > COVER_WIDE ||
           scan_rows(f, (double)box->y0, (double)box->y1) > COVER_WIDE;
}

/* Makes fronts, or a bundle, of the faces of a solid that is no front as a whole. Makes their runs too. False: no
 * memory. */
static BITS_RARE bool enter_faces(hide_fronts *fronts, front_tile *tile, uint32_t solid, const front_faces *found,
                                  bool bundled)
{
    bool entered = bundled ? bundle_enter(&fronts->bundles, &fronts->space, found->face, found->count, tile->face)
                           : add_single_fronts(fronts, tile, solid, found);
    return entered && enter_runs(fronts, found, NULL, 0);
}

static void count_faces(front_tile *tile, const front_faces *found)
{
    tile->face += found->count;
    tile->faces += found->count;
    tile->back += found->back;
    tile->edge_on += found->edge_on;
}

/* Finds the hull of the solid in the picture, which replaces an outline that is not convex. Returns its corners; 0: it
 * cannot be trusted. Face by face the solid would hide too little, because faces that are nearly edge-on are slivers.
 * As one front it is right up to the solid's departure from a convex one: no point of the solid is farther than that in
 * front of a face's plane, and a sight line behind the solid only gets deeper behind all planes. */
static uint32_t convex_hull(const hide_fronts *fronts, uint32_t solid, uint32_t *order, uint32_t *outline, double width)
{
    uint32_t corners = outline_hull(fronts, solid, order, outline);
    return outline_is_convex(fronts, outline, corners, width) ? corners : 0;
}

/* View units: the greatest distance at which an edge with exactly one front face lies inside the hull of its solid in
 * the picture. Lines behind the solid end at the hull, that far from the edge that is drawn. */
static double hull_gap(const hide_fronts *fronts, uint32_t solid, const uint32_t *hull, uint32_t corners)
{
    const roberts_scene *scene = fronts->scene;
    const scene_solid *own = &scene->solid[solid];
    double gap = 0.0;
    uint32_t last = 0; /* the side nearest to the last point is often near the next one */
    for (uint32_t e = own->edge; corners > 0 && e < own[1].edge; e++) {
        const scene_edge *edge = scene_edge_stored(scene, solid, e);
        for (int k = 0; k < 2 && seen_fronts(fronts->seen->facing + own->face, edge) == 1; k++) {
            const roberts_vec3 X = fronts->P[own->vertex + edge->v[k]];
            double inside = INFINITY;
            for (uint32_t n = 0, i = last; n < corners && inside > gap; n++, i = i + 1 < corners ? i + 1 : 0) {
                const roberts_vec3 A = fronts->P[hull[i]], B = fronts->P[hull[i + 1 < corners ? i + 1 : 0]];
                const double x = B.x - A.x, y = B.y - A.y,
                             from = (x * (X.y - A.y) - y * (X.x - A.x)) / vec2_length(x, y);
                if (from < inside)
                    last = i;
                inside = lesser(inside, from);
            }
            gap = greater(gap, inside);
        }
    }
    return gap;
}

bool front_add(hide_fronts *fronts, front_scratch *scratch, front_tile *tile, uint32_t solid)
{
    const roberts_scene *scene = fronts->scene;
    const hide_box *box = &fronts->box[solid];
    uint32_t *outline = fronts->outline + tile->outline;
    seen_map_body(fronts->seen, solid);
    if (!scene_is_convex(scene, solid))
        return add_surface(fronts, &scratch->cover, tile, solid);
    front_faces found = find_faces(fronts, tile, solid);
    uint32_t cycle = outline_cycle(fronts, solid, scratch->next, outline), corners = cycle;
    double width = (double)(box->x1 - box->x0) + (double)(box->y1 - box->y0);
    if (!outline_is_convex(fronts, outline, corners, width))
        corners = 0;
    if (corners == 0 && found.count > 0 && found.count <= FACES_OF_ONE_FRONT) {
        cycle = corners = convex_hull(fronts, solid, scratch->next, outline, width);
        tile->hull_gap = greater(tile->hull_gap, hull_gap(fronts, solid, outline, corners));
    }
    bool whole = corners && found.count <= FACES_OF_ONE_FRONT;
    bool bundled = cycle && !whole && is_bundle(fronts, &found, box);
    double size = box_size(box);
    double reach = found.reach - size;
    if (reach > 6.0 * fronts->seen->view.extent)
        reach = INFINITY; /* no two points of the scene are farther apart */
    /* No point of a front is farther than the farthest corner of its outline, because its depth is a concave function.
     * A point that is deeper than that corner by more than `slack` is behind every face by more than `touch`. So it is
     * certainly hidden wherever it is inside the outline. */
    double slack = 2.0 * (found.touch + hide_margin(&fronts->space)) / found.steepest;
    double depth = corners ? hide_farthest(fronts, outline, corners) : -INFINITY;
    hide_whole_front front = {.reach = reach,
                              .face = tile->face,
                              .outline = tile->outline,
                              .corners = cycle,
                              .loose = hide_float_above(LOOSE_DEPARTURES * (found.touch - fronts->seen->view.epsilon)),
                              .depth = hide_float_below(depth - slack),
                              .face_count = found.count};
    if (corners && fronts->cover.depth)
        cover_add(&fronts->cover, &scratch->cover.scan, fronts->P,
                  &(cover_front){.corner = outline,
                                 .count = cycle,
                                 .by = whole ? tile->whole : ROBERTS_NONE,
                                 .face = found.face,
                                 .face_count = whole && reach > size && is_wide(fronts, box) ? found.count : 0,
                                 .depth = depth,
                                 .slack = slack,
                                 .loose = (double)front.loose});
    if (whole ? !enter_runs(fronts, &found, outline, cycle) : !enter_faces(fronts, tile, solid, &found, bundled))
        return false;
    count_faces(tile, &found);
    if (!whole && !bundled)
        return true;
    tile->outline += cycle;
    tile->most_corners = cycle > tile->most_corners ? cycle : tile->most_corners;
    fronts->front_box[tile->whole] = *box;
    fronts->whole[tile->whole] = front;
    fronts->front[tile->whole++] = (hide_front){.solid = solid, .kind = whole ? HIDE_CONVEX_SOLID : HIDE_BUNDLE};
    return true;
}
