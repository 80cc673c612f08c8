/* front.c - see front.h. */
#include "hide/front.h"

#include <math.h>

#include "base/array.h"
#include "hide/outline.h"

/* Cells each way in a picture of n faces, about, are this times the root of n: see CELLS_PER_BOX in cells.c. */
#define CELLS_PER_ROOT 2.0
/* From this many cells (five or six mean boxes) across, a cover's depth is taken cell by cell and not once for all of
 * it. */
#define COVER_WIDE 50.0

/* The front faces of a solid. */
typedef struct front_faces {
    hide_face *face; /* [count] */
    uint32_t count;
    double reach, touch; /* the least and greatest of theirs */
    double steepest;     /* least of -c */
    uint32_t back, edge_on;
} front_faces;

/* Along three axes. */
static double box_size(const hide_box *box)
{
    return (double)(box->x1 - box->x0) + (double)(box->y1 - box->y0) + (double)(box->z1 - box->z0);
}

/* Says how far a distance from the face's plane can be trusted: `touch` within the reach that is returned, `limit`
 * anywhere. The plane of a face of width w is known to about its rounding (and the face's own departure from it) at the
 * face, and to that times r / w at a distance r.
 *
 * The departure of a face that is not narrow is left out of the reach. All that is asked of its plane beyond the face
 * is whether what lies behind its solid lies behind the plane, and a sight line only gets deeper behind both. So the
 * plane need only hold for the solid itself, and that it does, to about the departure. */
static double set_trust(const hide_fronts *fronts, uint32_t solid, uint32_t face, double stretch, hide_face *f)
{
    const view *v = &fronts->seen->view;
    f->departure = 0.0f;
    double departure = scene_deviation(fronts->scene, face) * v->per_unit;
    double width = scene_width(fronts->scene, face) * v->per_unit, rounded = 0.0;
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

/* Classifies the solid's faces and collects its front faces, from the tile's place on.
 *
 * A face whose corners lie beside its plane is front or back as its fitted plane says, also where the eye is within a
 * few departures of that plane. Its picture is a sliver then: how the corners are rounded decides which side is seen,
 * and what is hidden along the sliver. Both answers are right. To call all such faces edge-on instead was tried on
 * 1,500 brick walls: edges that are seen were lost, and which ones depended on the order of the vertices. */
static front_faces find_faces(hide_fronts *fronts, front_tile *tile, uint32_t solid)
{
    const roberts_scene *scene = fronts->scene;
    uint32_t end = scene->solid[solid + 1].face;
    front_faces found = {.face = fronts->face + tile->face, .reach = INFINITY, .steepest = 1.0};
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
        found.reach = lesser(found.reach, set_trust(fronts, solid, face, look.stretch, f));
        found.touch = greater(found.touch, f->touch);
        found.steepest = lesser(found.steepest, -f->F.c);
        tile->most_corners = f->count > tile->most_corners ? f->count : tile->most_corners;
    }
    return found;
}

BITS_INLINE hide_bounds face_bounds(const hide_fronts *fronts, const hide_face *F)
{
    hide_bounds own = hide_no_bounds;
    for (uint32_t i = 0; i < F->count; i++)
        box_add(&own.low, &own.high, fronts->P[F->corner[i]]);
    return own;
}

/* About how many cells of the lists a box meets along one axis, of a window that is `window` long. */
static double cells_along(const hide_fronts *fronts, double length, double window)
{
    return 1.0 + (window > 0.0 ? CELLS_PER_ROOT * sqrt(fronts->scene->face_count) * length / window : 0.0);
}

/* Do the faces lie across one another's boxes, or very many of them in one cell? (`box` is that of the solid.) */
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
        hide_bounds own = face_bounds(fronts, &found->face[k]);
        area += (own.high.x - own.low.x) * (own.high.y - own.low.y);
    }
    return area > DEPTH_OF_BUNDLE * width * height;
}

/* Room for `more` fronts of one face. False: no memory. */
static bool more_singles(front_tile *tile, size_t more)
{
    size_t need = tile->single_count + more;
    return array_reserve(&tile->single, &tile->single_room, need, sizeof *tile->single) &&
           array_reserve(&tile->single_box, &tile->single_box_room, need, sizeof *tile->single_box);
}

/* Each of the faces as a front of its own. */
static bool add_single_fronts(const hide_fronts *fronts, front_tile *tile, uint32_t solid, const front_faces *found)
{
    uint32_t piece = fronts->scene->solid[solid].face;
    if (!more_singles(tile, found->count))
        return false;
    for (uint32_t k = 0; k < found->count; k++, piece++) {
        while (fronts->seen->facing[piece] != VIEW_FRONT)
            piece++;
        hide_bounds own = face_bounds(fronts, &found->face[k]);
        tile->single_box[tile->single_count] = hide_box_around(&own);
        tile->single[tile->single_count++] = (hide_front){.solid = solid,
                                                          .own = seen_body_key(solid),
                                                          .face = tile->face + k,
                                                          .piece = piece,
                                                          .face_count = 1,
                                                          .listed = true,
                                                          .kind = HIDE_SOLID_FACE};
    }
    return true;
}

static double farthest(const hide_fronts *fronts, const uint32_t *corner, uint32_t corners)
{
    double depth = INFINITY;
    for (uint32_t i = 0; i < corners; i++)
        depth = lesser(depth, fronts->P[corner[i]].z);
    return depth;
}

/* Enters a face into the covers, unless its box is too small to hold a cell. Its depth is taken cell by cell. */
static void cover_with_face(hide_fronts *fronts, scan *s, const hide_face *f, const hide_box *box)
{
    const scan_frame *frame = &fronts->cover.frame;
    if (!fronts->cover.depth || (double)(box->x1 - box->x0) < frame->dx || (double)(box->y1 - box->y0) < frame->dy)
        return;
    cover_add(&fronts->cover, s, fronts->P,
              &(cover_front){.corner = f->corner,
                             .count = f->count,
                             .by = ROBERTS_NONE,
                             .face = f,
                             .face_count = 1,
                             .depth = farthest(fronts, f->corner, f->count),
                             .slack = 2.0 * (f->touch + hide_margin(&fronts->space)) / -f->F.c});
}

/* Enters the faces of a body that is not convex, each piece that is not edge-on by itself. False: no memory. */
static BITS_RARE bool add_surface(hide_fronts *fronts, scan *s, front_tile *tile, uint32_t body)
{
    const roberts_scene *scene = fronts->scene;
    uint32_t first = scene->solid[body].face, end = scene->solid[body + 1].face;
    if (!more_singles(tile, end - first))
        return false;
    for (uint32_t face = first; face < end; face++) {
        hide_face *f = &fronts->face[tile->face];
        seen_face look;
        int facing = seen_either_face(fronts->seen, face, &look);
        tile->faces += facing == VIEW_FRONT;
        tile->back += facing == VIEW_BACK;
        tile->edge_on += facing == VIEW_EDGE_ON;
        if (facing == VIEW_EDGE_ON)
            continue;
        f->F = look.F;
        f->corner = look.corner;
        f->count = look.count;
        set_trust(fronts, body, face, look.stretch, f);
        tile->most_corners = f->count > tile->most_corners ? f->count : tile->most_corners;
        hide_bounds own = face_bounds(fronts, f);
        hide_box *box = &tile->single_box[tile->single_count];
        *box = hide_box_around(&own);
        cover_with_face(fronts, s, f, box);
        tile->single[tile->single_count++] = (hide_front){.solid = body,
                                                          .own = seen_face_key(scene, body, face),
                                                          .face = tile->face++,
                                                          .piece = face,
                                                          .face_count = 1,
                                                          .listed = true,
                                                          .kind = HIDE_SURFACE_FACE};
    }
    return true;
}

/* The runs of the faces and of the outline, of those that have many corners. False: no memory. */
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
    return (double)(box->x1 - box->x0) > COVER_WIDE * f->dx || (double)(box->y1 - box->y0) > COVER_WIDE * f->dy;
}

/* Enters the faces of a solid that is not entered as a whole, and the runs of its polygons. bundled: the faces become a
 * bundle. False: no memory. */
static BITS_RARE bool enter_faces(hide_fronts *fronts, front_tile *tile, const hide_front *front,
                                  const front_faces *found, bool bundled)
{
    const uint32_t *outline = fronts->outline + front->outline;
    if (front->kind == HIDE_CONVEX_SOLID)
        return enter_runs(fronts, found, outline, front->corners);
    bool entered = bundled ? bundle_enter(&fronts->bundles, &fronts->space, found->face, found->count, tile->face)
                           : add_single_fronts(fronts, tile, front->solid, found);
    return entered && enter_runs(fronts, found, outline, 0);
}

static void count_faces(front_tile *tile, const front_faces *found)
{
    tile->face += found->count;
    tile->faces += found->count;
    tile->back += found->back;
    tile->edge_on += found->edge_on;
}

/* The hull in place of an outline that is not convex; 0 where it cannot be trusted. Face by face such a front would
 * hide too little: what is seen nearly edge-on is a sliver of the picture. As one front it is right to within what the
 * solid departs from a convex one: no point of the solid lies farther than that before the plane of a face, and a sight
 * line behind the solid only gets deeper behind all planes. */
static uint32_t convex_hull(const hide_fronts *fronts, uint32_t solid, uint32_t *order, uint32_t *outline, double width)
{
    uint32_t corners = outline_hull(fronts, solid, order, outline);
    return outline_is_convex(fronts, outline, corners, width) ? corners : 0;
}

bool front_add(hide_fronts *fronts, front_scratch *scratch, front_tile *tile, uint32_t solid)
{
    const roberts_scene *scene = fronts->scene;
    const hide_box *box = &fronts->box[solid];
    uint32_t *outline = fronts->outline + tile->outline;
    seen_map_body(fronts->seen, solid);
    if (!scene_is_convex(scene, solid))
        return add_surface(fronts, &scratch->scan, tile, solid);
    front_faces found = find_faces(fronts, tile, solid);
    uint32_t cycle = outline_cycle(fronts, solid, scratch->next, outline), corners = cycle;
    double width = (double)(box->x1 - box->x0) + (double)(box->y1 - box->y0);
    if (!outline_is_convex(fronts, outline, corners, width))
        corners = 0;
    if (corners == 0 && found.count > 0 && found.count <= FACES_OF_ONE_FRONT)
        cycle = corners = convex_hull(fronts, solid, scratch->next, outline, width);
    bool whole = corners && found.count <= FACES_OF_ONE_FRONT;
    bool bundled = cycle && !whole && is_bundle(fronts, &found, box);
    double size = box_size(box);
    double reach = found.reach - size;
    if (reach > 6.0 * fronts->seen->view.extent)
        reach = INFINITY; /* nothing is farther away, along three axes */
    /* By how much nearer than the front's farthest corner a point must be to count as touching it. Nothing of a front
     * is farther than the farthest corner of its outline, since its depth is a concave function; a point that much
     * behind it that it is behind each face by more than `touch` is certainly hidden, wherever it is inside the
     * outline. */
    double slack = 2.0 * (found.touch + hide_margin(&fronts->space)) / found.steepest;
    double depth = corners ? farthest(fronts, outline, corners) : -INFINITY;
    hide_front front = {.solid = solid,
                        .own = seen_body_key(solid),
                        .face = tile->face,
                        .face_count = found.count,
                        .depth = hide_float_below(depth - slack),
                        .reach = reach,
                        .loose = hide_float_above(LOOSE_DEPARTURES * (found.touch - fronts->seen->view.epsilon)),
                        .outline = tile->outline,
                        .corners = cycle,
                        .kind = whole ? HIDE_CONVEX_SOLID : HIDE_BUNDLE};
    if (corners && fronts->cover.depth)
        cover_add(&fronts->cover, &scratch->scan, fronts->P,
                  &(cover_front){.corner = outline,
                                 .count = cycle,
                                 .by = whole ? tile->front : ROBERTS_NONE,
                                 .face = found.face,
                                 .face_count = whole && reach > size && is_wide(fronts, box) ? found.count : 0,
                                 .depth = depth,
                                 .slack = slack,
                                 .loose = (double)front.loose});
    if ((!whole || fronts->face_runs.at) && !enter_faces(fronts, tile, &front, &found, bundled))
        return false;
    count_faces(tile, &found);
    if (!whole && !bundled)
        return true;
    tile->outline += cycle;
    tile->most_corners = cycle > tile->most_corners ? cycle : tile->most_corners;
    fronts->front_box[tile->front] = *box;
    fronts->front[tile->front] = front;
    tile->front++;
    return true;
}
