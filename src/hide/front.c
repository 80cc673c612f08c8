/* front.c - see front.h. */
#include "hide/front.h"

#include <math.h>

#include "base/array.h"
#include "hide/refine.h"
#include "hide/span.h"

/* A front of more faces than this is entered face by face: an edge that passes it would be compared with all. */
#define FACES_OF_ONE_FRONT 24
/* A solid of more faces than make a bundle is one where their boxes lie so many times over one another on average. */
#define DEPTH_OF_BUNDLE 8.0
/* ... or one so small in the picture that about so many of its faces share a cell: with fewer, their tree takes longer. */
#define FACES_OF_A_CELL 1000.0
/* Cells each way in a picture of n faces, about, are this times the root of n: see CELLS_PER_BOX in cells.c. */
#define CELLS_PER_ROOT 2.0
/* From this many cells (five or six mean boxes) across, a cover's depth is taken cell by cell and not once for all of it. */
#define COVER_WIDE 50.0

/* The front faces of a solid. */
typedef struct front_faces {
    hide_face *face; /* [count] */
    uint32_t count;
    double reach, touch; /* the least and greatest of theirs */
    double steepest;     /* least of -c */
    uint32_t back, edge_on;
} front_faces;

double front_set_trust(const hide_picture *picture, uint32_t solid, uint32_t face, double stretch, hide_face *f)
{
    const view *v = &picture->view;
    f->departure = 0.0f;
    double departure = scene_deviation(picture->scene, face) * v->per_unit;
    double width = scene_width(picture->scene, face) * v->per_unit;
    if (v->perspective) {
        double grown = 1.0 + (double)picture->box[solid].z1 * v->inverse_distance; /* D / w at the nearest corner */
        double shrunk = lesser(1.0, 1.0 + (double)picture->box[solid].z0 * v->inverse_distance);
        departure = (departure + v->plane_rounding) * stretch;
        f->departure = hide_float_above(departure);
        departure *= grown;
        width *= shrunk * shrunk;
    }
    double error = 4.0 * v->rounding + departure, far_error = error * (1.0 + 2.0 * v->extent / width);
    f->touch = v->epsilon + departure;
    f->limit = hide_float_below(far_error > 0.5 * f->touch ? f->touch - far_error : f->touch);
    return width * (0.5 * f->touch / error - 1.0);
}

/* Classifies the solid's faces and collects its front faces, from the tile's place on.
 *
 * A face whose corners lie beside its plane is front or back as its fitted plane says, also where the eye is within a
 * few departures of that plane. Its picture is a sliver then: how the corners are rounded decides which side is seen,
 * and what is hidden along the sliver. Both answers are right. To call all such faces edge-on instead was tried on
 * 1,500 brick walls: edges that are seen were lost, and which ones depended on the order of the vertices. */
static front_faces find_faces(hide_picture *picture, picture_tile *tile, uint32_t solid)
{
    const roberts_scene *scene = picture->scene;
    uint32_t end = scene->solid[solid + 1].face;
    front_faces found = {.face = picture->face + tile->face, .reach = INFINITY, .steepest = 1.0};
    for (uint32_t face = scene->solid[solid].face; face < end; face++) {
        double stretch = 1.0;
        plane F;
        int facing = view_face(&picture->view, scene, face, picture->P, &F, &stretch);
        picture->facing[face] = (unsigned char)facing;
        if (facing != VIEW_FRONT) {
            found.back += facing == VIEW_BACK;
            found.edge_on += facing == VIEW_EDGE_ON;
            continue;
        }
        hide_face *f = &found.face[found.count++];
        f->F = F;
        f->corner = scene->corner + scene->face_start[face];
        f->count = scene->face_start[face + 1] - scene->face_start[face];
        found.reach = lesser(found.reach, front_set_trust(picture, solid, face, stretch, f));
        found.touch = greater(found.touch, f->touch);
        found.steepest = lesser(found.steepest, -F.c);
        tile->most_corners = f->count > tile->most_corners ? f->count : tile->most_corners;
    }
    return found;
}

/* The outline: edges with one front face, which they run round counter-clockwise, joined to a cycle. Gives its number of
 * corners, or 0 where the edges are not one cycle: epsilon may have called faces of a very small or flat solid edge-on. */
static uint32_t find_outline(const hide_picture *picture, uint32_t solid, uint32_t *next, uint32_t *outline)
{
    const scene_solid *own = &picture->scene->solid[solid];
    const scene_edge *e = picture->scene->edge + own->stored, *end = e + (own[1].edge - own->edge);
    const unsigned char *facing = picture->facing + own->face;
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

/* The longer of a side's two components: its length, or less by a root of two at the most. */
static double span_of(roberts_vec3 side)
{
    return greater(fabs(side.x), fabs(side.y));
}

/* Whether the outline turns left at corner b or goes straight on, in twice the precision. An inward turn counts as
 * straight on where the lines of both sides cut off no more than half of epsilon from a front of this size. A turn
 * straight back does not count, nor does one after a side without length. */
static BITS_RARE bool turns_left(const hide_picture *picture, uint32_t a, uint32_t b, uint32_t c, double size)
{
    const roberts_vec3 *P = picture->P;
    roberts_vec3 AB = vec3_sub(P[b], P[a]), BC = vec3_sub(P[c], P[b]);
    double left = refine_side(&picture->space, a, b, c); /* no number where AB has no length */
    if (AB.x * BC.x + AB.y * BC.y <= 0.0)
        return left > 0.0;
    return left >= -0.5 * picture->view.epsilon / size * span_of(BC);
}

/* Whether the outline is a convex polygon. Tests 2 to 4 need that: for them the inside is what lies on the inner side
 * of every side's line, so that one side in a wrong direction may cut off the whole front.
 *
 * The outline of a convex solid is convex. But a face that is edge-on within epsilon is left out, and a solid given to
 * few digits is convex within its tolerance only: its outline may turn inward, or run out along a sliver and back. A
 * polygon is convex where it turns left at each corner, or goes straight on, and goes round once. To go round is to
 * change once from a side that does not lead up to one that does. */
static bool is_convex(const hide_picture *picture, const uint32_t *outline, uint32_t corners, double size)
{
    const double plain = 8.0 * picture->view.across_rounding * size; /* no product of two sides is off by more */
    int rounds = 0;
    uint32_t a = outline[corners - 2], b = outline[corners - 1];
    roberts_vec3 AB = vec3_sub(picture->P[b], picture->P[a]);
    for (uint32_t i = 0; i < corners; i++) {
        uint32_t c = outline[i];
        roberts_vec3 BC = vec3_sub(picture->P[c], picture->P[b]);
        double left = AB.x * BC.y - AB.y * BC.x;
        if (left <= plain && !turns_left(picture, a, b, c, size))
            return false;
        if (left >= 0.0 || AB.x * BC.x + AB.y * BC.y <= 0.0)
            rounds += AB.y <= 0.0 && BC.y > 0.0;
        else /* straight on, and by rounding a little to the right */
            rounds -= AB.y > 0.0 && BC.y <= 0.0;
        a = b;
        b = c;
        AB = BC;
    }
    return rounds == 1;
}

static span face_span(const hide_picture *picture, const hide_face *F)
{
    span own = empty_span;
    for (uint32_t i = 0; i < F->count; i++)
        box_add(&own.low, &own.high, picture->P[F->corner[i]]);
    return own;
}

/* About how many cells of the lists a box meets along one axis, of a window that is `window` long. */
static double cells_along(const hide_picture *picture, double length, double window)
{
    return 1.0 + (window > 0.0 ? CELLS_PER_ROOT * sqrt(picture->scene->face_count) * length / window : 0.0);
}

/* Do the faces lie across one another's boxes, or very many of them in one cell? (`box` is that of the solid.) */
static bool is_bundle(const hide_picture *picture, const front_faces *found, const hide_box *box)
{
    double width = (double)(box->x1 - box->x0), height = (double)(box->y1 - box->y0), area = 0.0;
    if (found->count <= BUNDLE_FACES || !picture->bundles.at)
        return false;
    double cells = cells_along(picture, width, picture->high.x - picture->low.x) *
                   cells_along(picture, height, picture->high.y - picture->low.y);
    if (found->count > FACES_OF_A_CELL * cells)
        return true;
    for (uint32_t k = 0; k < found->count; k++) {
        span own = face_span(picture, &found->face[k]);
        area += (own.high.x - own.low.x) * (own.high.y - own.low.y);
    }
    return area > DEPTH_OF_BUNDLE * width * height;
}

bool front_more_singles(picture_tile *tile, size_t more)
{
    size_t need = tile->single_count + more;
    return array_reserve(&tile->single, &tile->single_room, need, sizeof *tile->single) &&
           array_reserve(&tile->single_box, &tile->single_box_room, need, sizeof *tile->single_box);
}

/* Each of the faces as a front of its own. */
static bool add_single_fronts(const hide_picture *picture, picture_tile *tile, uint32_t solid, const front_faces *found)
{
    if (!front_more_singles(tile, found->count))
        return false;
    for (uint32_t k = 0; k < found->count; k++) {
        span own = face_span(picture, &found->face[k]);
        tile->single_box[tile->single_count] = span_box(&own);
        tile->single[tile->single_count++] =
            (hide_front){.solid = solid, .face = tile->face + k, .face_count = 1, .listed = true};
    }
    return true;
}

/* The runs of the faces and of the outline, of those that have many corners. False: no memory. */
static bool enter_runs(hide_picture *picture, const front_faces *found, const uint32_t *outline, uint32_t corners)
{
    if (!picture->face_runs.at)
        return true;
    for (uint32_t k = 0; k < found->count; k++)
        if (!runs_enter(&picture->face_runs, &picture->space, found->face[k].corner, found->face[k].count))
            return false;
    return runs_enter(&picture->outline_runs, &picture->space, outline, corners);
}

static double farthest(const hide_picture *picture, const uint32_t *corner, uint32_t corners)
{
    double depth = INFINITY;
    for (uint32_t i = 0; i < corners; i++)
        depth = lesser(depth, picture->P[corner[i]].z);
    return depth;
}

/* Enters what a front covers. trusted: the planes of its faces say how far it is. by: its number, ROBERTS_NONE if it will
 * have none. */
static void cover_front(hide_picture *picture, scan *s, const hide_front *front, const front_faces *found, bool trusted,
                        double depth, double slack, uint32_t by)
{
    const hide_box *box = &picture->box[front->solid];
    const scan_frame *f = &picture->cover.frame;
    bool wide = trusted &&
                ((double)(box->x1 - box->x0) > COVER_WIDE * f->dx || (double)(box->y1 - box->y0) > COVER_WIDE * f->dy);
    cover_add(&picture->cover, s, picture->P, picture->outline + front->outline, front->corners, depth, found->face,
              wide ? found->count : 0, slack, by, (double)front->loose);
}

/* Enters the faces of a solid that is not entered as a whole, and the runs of its polygons. corners: of its outline, 0 where that
 * is not asked. False: no memory. */
static BITS_RARE bool enter_faces(hide_picture *picture, picture_tile *tile, uint32_t solid, const front_faces *found,
                                  const uint32_t *outline, uint32_t corners, bool bundled)
{
    if (bundled)
        return bundle_enter(&picture->bundles, &picture->space, found->face, found->count, tile->face) &&
               enter_runs(picture, found, outline, 0);
    return (corners || add_single_fronts(picture, tile, solid, found)) && enter_runs(picture, found, outline, corners);
}

static void count_faces(picture_tile *tile, const front_faces *found)
{
    tile->face += found->count;
    tile->faces += found->count;
    tile->back += found->back;
    tile->edge_on += found->edge_on;
}

bool front_add(hide_picture *picture, front_scratch *scratch, picture_tile *tile, uint32_t solid)
{
    const roberts_scene *scene = picture->scene;
    const hide_box *box = &picture->box[solid];
    uint32_t vertex = scene->solid[solid].vertex, *outline = picture->outline + tile->outline;
    view_points(&picture->view, scene->point + vertex, scene->solid[solid + 1].vertex - vertex, picture->P + vertex);
    if (!scene_is_convex(scene, solid))
        return surface_add_fronts(picture, tile, solid);
    front_faces found = find_faces(picture, tile, solid);
    uint32_t cycle = find_outline(picture, solid, scratch->next, outline), corners = cycle;
    double width = (double)(box->x1 - box->x0) + (double)(box->y1 - box->y0);
    if (corners && !is_convex(picture, outline, corners, width))
        corners = 0;
    bool whole = corners && found.count <= FACES_OF_ONE_FRONT;
    bool bundled = cycle && !whole && is_bundle(picture, &found, box);
    double size = width + (double)(box->z1 - box->z0);
    double reach = found.reach - size;
    if (reach > 6.0 * picture->view.extent)
        reach = INFINITY; /* nothing is farther away, along three axes */
    /* By how much nearer than the front's farthest corner a point must be to count as touching it. Nothing of a front is
     * farther than the farthest corner of its outline, since its depth is a concave function; a point that much behind it
     * that it is behind each face by more than `touch` is certainly hidden, wherever it is inside the outline. */
    double slack = 2.0 * (found.touch + hide_margin(&picture->space)) / found.steepest;
    double depth = corners ? farthest(picture, outline, corners) : -INFINITY;
    hide_front front = {.solid = solid,
                        .face = tile->face,
                        .face_count = found.count,
                        .depth = hide_float_below(depth - slack),
                        .reach = whole ? reach : -INFINITY, /* a bundle's faces are never asked all at once */
                        .loose = hide_float_above(4.0 * (found.touch - picture->view.epsilon)),
                        .outline = tile->outline,
                        .corners = cycle};
    if (corners && picture->cover.depth)
        cover_front(picture, &scratch->scan, &front, &found, whole && reach > size, depth, slack,
                    whole ? tile->front : ROBERTS_NONE);
    if ((!whole || picture->face_runs.at) &&
        !enter_faces(picture, tile, solid, &found, outline, whole ? corners : 0, bundled))
        return false;
    count_faces(tile, &found);
    if (!whole && !bundled)
        return true;
    tile->outline += cycle;
    tile->most_corners = cycle > tile->most_corners ? cycle : tile->most_corners;
    picture->front_box[tile->front] = *box;
    picture->front[tile->front] = front;
    tile->front++;
    return true;
}
