/* picture.c - see picture.h. */
#include "hide/picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/error.h"
#include "base/radix.h"
#include "hide/cells.h"
#include "hide/unite.h"

/* A front of more faces than this is entered face by face: an edge that passes it would be compared with all. */
#define FACES_OF_ONE_FRONT 24
/* From this many cells (five or six mean boxes) across, a cover's depth is taken cell by cell and not once for all of it. */
#define COVER_WIDE 50.0
/* Side of a tile in cells of covers: 256 kB of them. */
#define TILE_CELLS 256

/* Scratch memory of the building. */
typedef struct build {
    hide_picture *picture;
    uint32_t *next;  /* [vertices of a solid] the outline's next corner */
    uint32_t *order; /* [solid_count] nearest first */
    uint32_t *key;
} build;

/* A box of view points as they are; one of none is empty. */
typedef struct span {
    roberts_vec3 low, high;
} span;

static const span empty_span = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static void widen(span *s, roberts_vec3 p)
{
    s->low = (roberts_vec3){lesser(s->low.x, p.x), lesser(s->low.y, p.y), lesser(s->low.z, p.z)};
    s->high = (roberts_vec3){greater(s->high.x, p.x), greater(s->high.y, p.y), greater(s->high.z, p.z)};
}

static hide_box box_of(const span *s)
{
    if (s->low.x > s->high.x)
        return (hide_box){INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY};
    return (hide_box){hide_float_below(s->low.x),  hide_float_above(s->high.x), hide_float_below(s->low.y),
                      hide_float_above(s->high.y), hide_float_below(s->low.z),  hide_float_above(s->high.z)};
}

enum { POINTS_AT_ONCE = 64 };

/* The box of a solid's view points. */
static span measure_solid(const hide_picture *picture, uint32_t solid)
{
    const roberts_scene *scene = picture->scene;
    const roberts_vec3 *point = scene->point + scene->solid[solid].vertex;
    uint32_t left = scene->solid[solid + 1].vertex - scene->solid[solid].vertex;
    roberts_vec3 P[POINTS_AT_ONCE];
    span own = empty_span;
    for (uint32_t count; left > 0; left -= count, point += count) {
        count = left < POINTS_AT_ONCE ? left : POINTS_AT_ONCE;
        view_points(&picture->view, point, count, P);
        for (uint32_t i = 0; i < count; i++)
            widen(&own, P[i]);
    }
    return own;
}

/* Boxes of all solids, and the window. */
static void box_solids(hide_picture *picture)
{
    const roberts_scene *scene = picture->scene;
    span all = empty_span;
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        span own = measure_solid(picture, s);
        picture->box[s] = box_of(&own);
        if (scene->solid[s].vertex < scene->solid[s + 1].vertex) { /* the near plane has left something */
            widen(&all, own.low);
            widen(&all, own.high);
        }
    }
    picture->low = (roberts_vec2){all.low.x, all.low.y};
    picture->high = (roberts_vec2){all.high.x, all.high.y};
}

/* How far a distance from the face's plane can be trusted: `touch` within the reach that is returned, `limit` anywhere. The
 * plane of a face of width w is known to about its rounding (and the face's own departure from it) at the face, and to
 * that times r / w at a distance r. */
static double set_trust(const hide_picture *picture, uint32_t solid, uint32_t face, double stretch, hide_face *f)
{
    const view *v = &picture->view;
    double departure = scene_deviation(picture->scene, face) * v->per_unit;
    double width = scene_width(picture->scene, face) * v->per_unit;
    if (v->perspective) {
        double grown = 1.0 + (double)picture->box[solid].z1 * v->inverse_distance; /* D / w at the nearest corner */
        double shrunk = lesser(1.0, 1.0 + (double)picture->box[solid].z0 * v->inverse_distance);
        departure = (departure + v->plane_rounding) * stretch * grown;
        width *= shrunk * shrunk;
    }
    double error = 4.0 * v->rounding + departure, far_error = error * (1.0 + 2.0 * v->extent / width);
    f->touch = v->epsilon + departure;
    f->limit = hide_float_below(far_error > 0.5 * f->touch ? f->touch - far_error : f->touch);
    return width * (0.5 * f->touch / error - 1.0);
}

/* Classifies the solid's faces and collects its front faces. `*reach`, `*touch`: the least and greatest of theirs. False: no
 * memory. */
static bool add_faces(hide_picture *picture, uint32_t solid, double *reach, double *touch)
{
    const roberts_scene *scene = picture->scene;
    uint32_t first = scene->solid[solid].face, end = scene->solid[solid + 1].face;
    *reach = INFINITY;
    *touch = 0.0;
    if (!array_reserve(&picture->face, &picture->face_room, (size_t)picture->face_count + end - first,
                       sizeof(hide_face)))
        return false;
    for (uint32_t face = first; face < end; face++) {
        double stretch = 1.0;
        hide_face *f = &picture->face[picture->face_count];
        int facing = view_face(&picture->view, scene, face, picture->P, &f->F, &stretch);
        picture->facing[face] = (unsigned char)facing;
        picture->back += facing == VIEW_BACK;
        picture->edge_on += facing == VIEW_EDGE_ON;
        if (facing != VIEW_FRONT)
            continue;
        f->corner = scene->corner + scene->face_start[face];
        f->count = scene->face_start[face + 1] - scene->face_start[face];
        *reach = lesser(*reach, set_trust(picture, solid, face, stretch, f));
        *touch = greater(*touch, f->touch);
        if (f->count > picture->most_corners)
            picture->most_corners = f->count;
        picture->face_count++;
    }
    return true;
}

/* The outline: edges with one front face, which they run round counter-clockwise, joined to a cycle. Gives its number of
 * corners, or 0 where the edges are not one cycle: epsilon may have called faces of a very small or flat solid edge-on.
 * No memory: false. */
static bool find_outline(build *b, uint32_t solid, uint32_t *corners)
{
    hide_picture *picture = b->picture;
    const roberts_scene *scene = picture->scene;
    uint32_t base = scene->solid[solid].vertex, size = scene->solid[solid + 1].vertex - base;
    const unsigned char *facing = picture->facing + scene->solid[solid].face;
    uint32_t edges = 0, start = ROBERTS_NONE, found = 0;
    *corners = 0;
    for (uint32_t v = 0; v < size; v++)
        b->next[v] = ROBERTS_NONE;
    for (uint32_t i = scene->solid[solid].edge; i < scene->solid[solid + 1].edge; i++) {
        const scene_edge *e = scene_edge_stored(scene, solid, i);
        bool left = facing[e->f[0]] == VIEW_FRONT;
        if (left == (facing[e->f[1]] == VIEW_FRONT))
            continue;
        start = e->v[!left]; /* v[0] -> v[1] runs counter-clockwise round f[0] */
        if (b->next[start] != ROBERTS_NONE)
            return true;
        b->next[start] = e->v[left];
        edges++;
    }
    if (edges < 3)
        return true;
    if (!array_reserve(&picture->outline, &picture->outline_room, picture->outline_count + edges, sizeof(uint32_t)))
        return false;
    uint32_t v = start;
    do {
        picture->outline[picture->outline_count + found++] = v + base;
        v = b->next[v];
    } while (v != start && v != ROBERTS_NONE && found < edges);
    if (v == start && found == edges)
        *corners = edges;
    return true;
}

static bool add_front(hide_picture *picture, hide_front front, hide_box box)
{
    size_t need = (size_t)picture->front_count + 1;
    if (!array_reserve(&picture->front, &picture->front_room, need, sizeof *picture->front) ||
        !array_reserve(&picture->front_box, &picture->front_box_room, need, sizeof *picture->front_box))
        return false;
    picture->front_box[picture->front_count] = box;
    picture->front[picture->front_count++] = front;
    if (front.corners > picture->most_corners)
        picture->most_corners = front.corners;
    return true;
}

/* Each of the faces from `first` on as a front of its own. */
static bool add_single_fronts(hide_picture *picture, uint32_t solid, uint32_t first)
{
    for (uint32_t k = first; k < picture->face_count; k++) {
        span own = empty_span;
        for (uint32_t i = 0; i < picture->face[k].count; i++)
            widen(&own, picture->P[picture->face[k].corner[i]]);
        if (!add_front(picture, (hide_front){.solid = solid, .face = k, .face_count = 1}, box_of(&own)))
            return false;
    }
    return true;
}

/* By how much nearer than a front's farthest corner a point must be to count as touching it. Nothing of a front is farther
 * than the farthest corner of its outline, since its depth is a concave function; a point that much behind it that it is
 * behind each face by more than `touch` is certainly hidden, wherever it is inside the outline. */
static double find_slack(const hide_picture *picture, uint32_t first, double touch)
{
    double steepest = 1.0;
    for (uint32_t k = first; k < picture->face_count; k++)
        steepest = lesser(steepest, -picture->face[k].F.c);
    return 2.0 * (touch + hide_margin(&picture->space)) / steepest;
}

static double farthest(const hide_picture *picture, const uint32_t *corner, uint32_t corners)
{
    double depth = INFINITY;
    for (uint32_t i = 0; i < corners; i++)
        depth = lesser(depth, picture->P[corner[i]].z);
    return depth;
}

/* Enters what the front of faces from `first` on covers. */
static void cover_front(hide_picture *picture, const hide_front *front, bool whole, bool trusted, double depth,
                        double slack, uint32_t faces)
{
    const hide_box *box = &picture->box[front->solid];
    const scan_frame *f = &picture->cover.frame;
    bool wide = trusted &&
                ((double)(box->x1 - box->x0) > COVER_WIDE * f->dx || (double)(box->y1 - box->y0) > COVER_WIDE * f->dy);
    cover_add(&picture->cover, picture->P, picture->outline + front->outline, front->corners, depth,
              picture->face + front->face, wide ? faces : 0, slack, whole ? picture->front_count : ROBERTS_NONE,
              (double)front->loose);
}

/* Maps a solid and enters its front; false: no memory. */
static bool add_solid(build *b, uint32_t solid)
{
    hide_picture *picture = b->picture;
    const roberts_scene *scene = picture->scene;
    uint32_t first = picture->face_count, corners, vertex = scene->solid[solid].vertex;
    size_t back = picture->back, edge_on = picture->edge_on;
    double reach, touch;
    view_points(&picture->view, scene->point + vertex, scene->solid[solid + 1].vertex - vertex, picture->P + vertex);
    if (!add_faces(picture, solid, &reach, &touch) || !find_outline(b, solid, &corners))
        return false;
    const hide_box *box = &picture->box[solid];
    uint32_t count = picture->face_count - first;
    double size = (double)(box->x1 - box->x0) + (double)(box->y1 - box->y0) + (double)(box->z1 - box->z0);
    reach -= size;
    if (reach > 6.0 * picture->view.extent)
        reach = INFINITY; /* nothing is farther away, along three axes */
    bool whole = corners && count <= FACES_OF_ONE_FRONT;
    if (whole && unite_hides(picture, picture->outline + picture->outline_count, corners, box->z1)) {
        picture->culled[solid] = true;
        picture->face_count = first;
        picture->back = back;
        picture->edge_on = edge_on;
        return true;
    }
    double depth = corners ? farthest(picture, picture->outline + picture->outline_count, corners) : -INFINITY;
    double slack = find_slack(picture, first, touch);
    hide_front front = {.solid = solid,
                        .face = first,
                        .face_count = whole ? (unsigned char)count : 0,
                        .depth = hide_float_below(depth - slack),
                        .reach = reach,
                        .loose = hide_float_above(4.0 * (touch - picture->view.epsilon)),
                        .outline = (uint32_t)picture->outline_count,
                        .corners = corners};
    if (corners && picture->cover.depth)
        cover_front(picture, &front, whole, whole && reach > size, depth, slack, count);
    if (!whole)
        return add_single_fronts(picture, solid, first);
    picture->outline_count += corners;
    if (picture->outline_count > UINT32_MAX || !add_front(picture, front, picture->box[solid]))
        return false;
    unite_offer(picture, picture->front_count - 1);
    return true;
}

/* Nearest first, but tile by tile of the picture: what a tile's solids touch of the covers then stays in the cache. A
 * solid near a tile's border may be taken before one of the next tile that covers it; the second look finds it. */
static bool order_solids(build *b)
{
    const hide_picture *picture = b->picture;
    const scan_frame *f = &picture->cover.frame;
    uint32_t across = f->nx / TILE_CELLS + 1, up = f->ny / TILE_CELLS + 1, tiles = across * up, bits = 0;
    while (tiles > 1u << bits)
        bits++;
    for (uint32_t s = 0; s < picture->scene->solid_count; s++) {
        const hide_box *box = &picture->box[s];
        uint32_t i = scan_column(f, 0.5 * ((double)box->x0 + (double)box->x1)) / TILE_CELLS;
        uint32_t j = scan_row(f, 0.5 * ((double)box->y0 + (double)box->y1)) / TILE_CELLS;
        uint32_t near = radix_key_descending(box->z1);
        b->key[s] = bits ? (i * up + j) << (32 - bits) | near >> bits : near;
    }
    return radix_order(b->key, picture->scene->solid_count, b->order);
}

/* Do the two fronts, of different solids, show the very same faces? Then each hides what the other hides, and neither
 * anything of the other. */
static bool same_front(const hide_picture *picture, uint32_t a, uint32_t b)
{
    const hide_front *f = &picture->front[a], *g = &picture->front[b];
    if (f->face_count != g->face_count || f->corners != g->corners || f->corners == 0 ||
        memcmp(&picture->front_box[a], &picture->front_box[b], sizeof(hide_box)) != 0)
        return false;
    for (uint32_t i = 0; i < f->corners; i++) {
        roberts_vec3 p = picture->P[picture->outline[f->outline + i]], q = picture->P[picture->outline[g->outline + i]];
        if (p.x != q.x || p.y != q.y || p.z != q.z)
            return false;
    }
    for (uint32_t i = 0; i < f->face_count; i++) {
        plane F = picture->face[f->face + i].F, G = picture->face[g->face + i].F;
        if (F.a != G.a || F.b != G.b || F.c != G.c || F.d != G.d ||
            picture->face[f->face + i].touch != picture->face[g->face + i].touch)
            return false;
    }
    return true;
}

/* Fronts that can differ in nothing else differ here. */
static uint32_t place_key(const hide_picture *picture, uint32_t front)
{
    const hide_box *box = &picture->front_box[front];
    uint32_t bits[sizeof *box / sizeof(uint32_t)], key = 2166136261u; /* FNV-1a, word by word */
    memcpy(bits, box, sizeof bits);
    for (size_t i = 0; i < sizeof bits / sizeof bits[0]; i++)
        key = (key ^ bits[i]) * 16777619u;
    return key;
}

/* Marks the fronts that count. Of copies of a solid at the same place one front is enough, else a thousand copies would
 * cost a million comparisons: the first, which has the smallest number, since a stable order of the keys brings them
 * together. */
static bool list_fronts(hide_picture *picture)
{
    uint32_t count = picture->front_count, last = ROBERTS_NONE;
    uint32_t *key = alloc_array(count, sizeof *key), *order = alloc_array(count, sizeof *order);
    bool done = key && order;
    for (uint32_t i = 0; done && i < count; i++) {
        key[i] = place_key(picture, i);
        picture->front[i].listed = !picture->culled[picture->front[i].solid];
    }
    done = done && radix_order(key, count, order);
    for (uint32_t k = 0; done && k < count; k++) {
        uint32_t i = order[k];
        if (!picture->front[i].listed)
            continue;
        if (last != ROBERTS_NONE && key[last] == key[i] && same_front(picture, last, i))
            picture->front[i].listed = false;
        else
            last = i;
    }
    free(key);
    free(order);
    return done;
}

/* Does the front hide the solid, all of whose vertices lie inside its outline or on it? */
static bool hides_solid(const hide_picture *picture, const hide_front *front, uint32_t solid)
{
    const roberts_scene *scene = picture->scene;
    const uint32_t *corner = picture->outline + front->outline;
    if (!(front->depth > picture->box[solid].z1))
        return false;
    for (uint32_t v = scene->solid[solid].vertex; v < scene->solid[solid + 1].vertex; v++) {
        roberts_vec3 X = view_point(&picture->view, scene->point[v]);
        for (uint32_t i = 0; i < front->corners; i++) {
            roberts_vec3 P = picture->P[corner[i]], Q = picture->P[corner[i + 1 < front->corners ? i + 1 : 0]];
            double dx = Q.x - P.x, dy = Q.y - P.y, H = dx * (X.y - P.y) - dy * (X.x - P.x);
            if (H < 0.0 && H < -0.5 * picture->space.epsilon * sqrt(dx * dx + dy * dy))
                return false;
        }
    }
    return true;
}

/* A solid whose border lies on the border of what hides it is in cells that are not wholly covered. So, where the cells
 * further in are, the fronts that cover its middle and its corners are asked themselves. */
static bool is_hidden(const hide_picture *picture, uint32_t solid)
{
    const hide_box *box = &picture->box[solid];
    const scan_frame *f = &picture->cover.frame;
    static const float at[5][2] = {{0.5f, 0.5f}, {0, 0}, {0, 1}, {1, 0}, {1, 1}};
    uint32_t last = ROBERTS_NONE;
    /* most that are not hidden are not in their middle */
    if (!picture->cover.depth || !cover_nearer(&picture->cover, 0.5 * ((double)box->x0 + (double)box->x1),
                                               0.5 * ((double)box->y0 + (double)box->y1), box->z1))
        return false;
    if (cover_hides(&picture->cover, box))
        return true;
    float dx = 1.5f * (float)f->dx, dy = 1.5f * (float)f->dy;
    hide_box inner = {box->x0 + dx, box->x1 - dx, box->y0 + dy, box->y1 - dy, box->z0, box->z1};
    if (inner.x0 > inner.x1 || inner.y0 > inner.y1 || !cover_hides(&picture->cover, &inner))
        return false;
    for (int k = 0; k < 5; k++) {
        float x = inner.x0 + at[k][0] * (inner.x1 - inner.x0), y = inner.y0 + at[k][1] * (inner.y1 - inner.y0);
        uint32_t front = cover_at(&picture->cover, (double)x, (double)y, box->z1);
        if (front != ROBERTS_NONE && front != last && hides_solid(picture, &picture->front[front], solid))
            return true;
        last = front;
    }
    return false;
}

/* With covers: nearest solids first, each culled where those before it cover it, and all once more, in the same order,
 * when every cover is known. */
static bool add_solids(build *b)
{
    hide_picture *picture = b->picture;
    const roberts_scene *scene = picture->scene;
    uint32_t count = scene->solid_count;
    bool covers = picture->cover.depth != NULL;
    if (covers && !order_solids(b))
        return false;
    for (uint32_t k = 0; k < count; k++) {
        uint32_t s = covers ? b->order[k] : k;
        bool empty = scene->solid[s].vertex == scene->solid[s + 1].vertex; /* clipped away */
        picture->culled[s] = empty || is_hidden(picture, s);
        if (!picture->culled[s] && !add_solid(b, s))
            return false;
    }
    for (uint32_t k = 0; picture->cover.rest && k < picture->front_count; k++) {
        const hide_front *front = &picture->front[k];
        unsigned char *culled = &picture->culled[front->solid];
        *culled = *culled ||
                  unite_hides(picture, picture->outline + front->outline, front->corners, picture->front_box[k].z1);
    }
    for (uint32_t k = 0; covers && k < count; k++) {
        uint32_t s = b->order[k];
        picture->culled[s] = picture->culled[s] || is_hidden(picture, s);
        picture->culled_count += picture->culled[s];
    }
    return list_fronts(picture);
}

static uint32_t most_vertices(const roberts_scene *scene)
{
    uint32_t most = 0;
    for (uint32_t s = 0; s < scene->solid_count; s++)
        if (scene->solid[s + 1].vertex - scene->solid[s].vertex > most)
            most = scene->solid[s + 1].vertex - scene->solid[s].vertex;
    return most;
}

static bool alloc_picture(build *b, hide_picture *picture)
{
    const roberts_scene *scene = picture->scene;
    picture->box = alloc_array(scene->solid_count, sizeof *picture->box);
    picture->culled = alloc_zeroed(scene->solid_count, sizeof *picture->culled);
    picture->P = alloc_array(scene->vertex_count, sizeof *picture->P);
    picture->facing = alloc_zeroed(scene->face_count, sizeof *picture->facing);
    b->next = alloc_array(most_vertices(scene), sizeof *b->next);
    b->order = alloc_array(scene->solid_count, sizeof *b->order);
    b->key = alloc_array(scene->solid_count, sizeof *b->key);
    return picture->box && picture->culled && picture->P && picture->facing && b->next && b->order && b->key;
}

static void set_space(hide_picture *picture)
{
    const view *v = &picture->view;
    picture->space = (hide_space){.P = picture->P,
                                  .epsilon = v->epsilon,
                                  .rounding = v->rounding,
                                  .plain = hide_plain(v->extent, v->epsilon, v->rounding),
                                  .scene = picture->scene,
                                  .view = v};
}

roberts_status hide_picture_build(hide_picture *picture, const roberts_scene *scene, const roberts_camera *camera,
                                  double epsilon, bool cull, roberts_error *error)
{
    build b = {.picture = picture};
    *picture = (hide_picture){.scene = scene};
    roberts_status status = view_prepare(&picture->view, scene, camera, epsilon, error);
    if (status != ROBERTS_OK)
        return status;
    status = ROBERTS_NO_MEMORY;
    if (!alloc_picture(&b, picture))
        goto done;
    box_solids(picture);
    set_space(picture);
    scan_frame frame = {0};
    if (cull)
        frame = cells_for_covers(picture->box, scene->solid_count, picture->low, picture->high,
                                 hide_margin(&picture->space));
    bool unite = frame.nx && cells_worth_uniting(picture->box, scene->solid_count, picture->low, picture->high);
    if (!cover_init(&picture->cover, frame) || (unite && !unite_init(&picture->cover)) || !add_solids(&b))
        goto done;
    status = ROBERTS_OK;
done:
    free(b.next);
    free(b.order);
    free(b.key);
    if (status != ROBERTS_OK) {
        hide_picture_free(picture);
        return error_no_memory(error);
    }
    return status;
}

void hide_picture_drop_boxes(hide_picture *picture)
{
    free(picture->box);
    picture->box = NULL;
}

void hide_picture_free(hide_picture *picture)
{
    free(picture->box);
    free(picture->culled);
    free(picture->P);
    free(picture->facing);
    free(picture->face);
    free(picture->front);
    free(picture->front_box);
    free(picture->outline);
    cover_free(&picture->cover);
    *picture = (hide_picture){0};
}
