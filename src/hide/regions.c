/* regions.c - what is seen of each face, as polygons with holes.
 *
 *   1. Hidden lines are removed from all edges, including flat ones, and the visible parts become a planar map
 *      (planar_map.c). Visible lines meet at their ends, or one ends where it passes behind another, or they coincide.
 *      They cross only where faces touch.
 *   2. The lines divide the picture into cells (planar_map.c). No border of a visible region lies inside a cell, so one
 *      point decides which face is seen in the whole cell.
 *   3. Lines with the same face on both sides are removed. The remaining cycles bound the regions.
 *
 * Regions tile the picture because cells do, whatever the rounding. */
#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "base/sets.h"
#include "base/sort.h"
#include "base/threads.h"
#include "hide/planar_map.h"
#include "hide/region_depths.h"
#include "hide/region_faces.h"
#include "hide/segments.h"

/* Where in a stretch a point is taken, as a fraction of it. */
#define ASIDE 0.4557

enum { CELLS_PER_THREAD = 2000 };

/* A ring in the making. */
typedef struct region_ring {
    uint32_t half;  /* its leftmost corner begins it */
    uint32_t face;  /* of the scene */
    uint32_t outer; /* the ring round the whole piece: itself, unless it bounds a hole */
    uint32_t root;  /* of its cells */
    size_t corners;
    double area;
    roberts_vec2 at;
} region_ring;

typedef struct cell_sight {
    uint32_t face; /* seen in the cell; ROBERTS_NONE: none */
    depth_range depth;
} cell_sight;

typedef struct region_work {
    const hide_job *job;
    planar_map map;
    map_cells cells;
    region_depths depths;
    uint32_t *start, *half; /* the half-edges of each cell: [cells + 1], [2 lines] */
    cell_sight *sight;      /* [cells] */
    uint8_t *gone;          /* [lines] the same face is seen on both sides */
    uint32_t *root;         /* [cells] joined cells, represented by one of them */
    region_ring *ring;      /* [ring_count] */
    size_t ring_count, ring_room;
} region_work;

/* ---- lines ----------------------------------------------------------------------------------------------------- */

/* Does a segment of the rest precede one of the drawing? Segments follow their bodies, then their edges; those of
 * intersections, which only a drawing has, come last. */
static bool precedes(const roberts_segment *rest, const roberts_segment *drawn)
{
    if (drawn->v0 == ROBERTS_NONE || rest->solid < drawn->solid)
        return true;
    return rest->solid == drawn->solid && rest->edge < drawn->edge;
}

/* Takes the lines in the order that they would have if all were of one drawing. */
static bool take_lines(region_work *w, const roberts_drawing *drawing, const roberts_drawing *rest)
{
    const double per = w->job->seen.view.per_unit;
    for (size_t i = 0, k = 0; i < drawing->count || k < rest->count;) {
        const bool first =
            k < rest->count && (i == drawing->count || precedes(&rest->segment[k], &drawing->segment[i]));
        const roberts_segment *s = first ? &rest->segment[k++] : &drawing->segment[i++];
        if (s->state == ROBERTS_VISIBLE && s->line != ROBERTS_WIRE &&
            !planar_map_add(&w->map, (roberts_vec2){per * s->p0.x, per * s->p0.y},
                            (roberts_vec2){per * s->p1.x, per * s->p1.y}))
            return false;
    }
    return true;
}

/* ---- which face is seen in a cell ------------------------------------------------------------------------------ */

/* Lists the half-edges of each cell. */
static bool list_halves(region_work *w)
{
    size_t halves = 2 * w->map.line_count;
    uint32_t *cell = alloc_array(halves, sizeof *cell);
    for (uint32_t h = 0; cell && h < halves; h++)
        cell[h] = map_cell_of(&w->cells, h);
    bool enough = cell && sort_buckets(cell, halves, w->cells.cell_count, &w->start, &w->half);
    free(cell);
    return enough;
}

static roberts_vec2 corner_of(const region_work *w, uint32_t half)
{
    return w->map.node[map_from(&w->map, half)];
}

/* A side of a cell. */
typedef struct cell_side {
    roberts_vec2 P, Q;
} cell_side;

/* The sides of a cell, and numbers. One for each thread. */
typedef struct region_scratch {
    cell_side *side; /* [count] */
    double *item;
    size_t count, side_room, room;
    depth_parts parts;
    char apart[THREADS_APART];
} region_scratch;

static bool take_sides(const region_work *w, uint32_t cell, region_scratch *scratch)
{
    const uint32_t first = w->start[cell], count = w->start[cell + 1] - first;
    if (!array_reserve(&scratch->side, &scratch->side_room, count, sizeof *scratch->side) ||
        !array_reserve(&scratch->item, &scratch->room, count, sizeof *scratch->item))
        return false;
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t half = w->half[first + k];
        scratch->side[k] = (cell_side){corner_of(w, half), corner_of(w, half ^ 1)};
    }
    scratch->count = count;
    return true;
}

/* The middle and the width of the widest stretch of a cell at height y. Width 0: there is none. */
static double widest_at(region_scratch *scratch, double y, double *x)
{
    size_t count = 0;
    double width = 0.0, *item = scratch->item;
    for (const cell_side *s = scratch->side; s < scratch->side + scratch->count; s++)
        if ((s->P.y <= y) != (s->Q.y <= y))
            item[count++] = s->P.x + (y - s->P.y) / (s->Q.y - s->P.y) * (s->Q.x - s->P.x);
    if (count <= 32) {
        SORT_FEW(double, item, count, *a > *b);
    } else {
        qsort(item, count, sizeof *item, compare_doubles);
    }
    for (size_t k = 0; k + 1 < count; k += 2)
        if (item[k + 1] - item[k] > width) {
            width = item[k + 1] - item[k];
            *x = item[k] + ASIDE * width;
        }
    return width;
}

/* A point well inside a cell, but not in its middle. In the middle there may be a line along which another face touches
 * the visible one from behind. */
static roberts_vec2 point_inside(region_scratch *scratch)
{
    static const double heights[] = {0.4871, 0.2303, 0.7519}; /* parts of the cell's height */
    const cell_side *side = scratch->side;
    const size_t count = scratch->count;
    const roberts_vec2 A = side[0].P, B = side[1].P, C = side[count - 1].P;
    double low = INFINITY, high = -INFINITY, most = 0.0;
    for (size_t k = 0; k < count; k++) {
        low = lesser(low, side[k].P.y);
        high = greater(high, side[k].P.y);
    }
    roberts_vec2 inside = {0.3127 * A.x + 0.3681 * B.x + 0.3192 * C.x, 0.3127 * A.y + 0.3681 * B.y + 0.3192 * C.y};
    for (size_t i = 0; count > 3 && i < sizeof heights / sizeof heights[0]; i++) {
        const double y = low + heights[i] * (high - low);
        double x = 0.0, width = widest_at(scratch, y, &x);
        if (width > most) {
            most = width;
            inside = (roberts_vec2){x, y};
        }
    }
    return inside;
}

/* The first piece of a face of the input, or of a body's cap. */
static uint32_t whole_face(const roberts_scene *scene, uint32_t face)
{
    uint32_t number = scene_face_number(scene, face);
    if (number == ROBERTS_NONE)
        return scene_first_piece(scene, scene_body_of_face(scene, face), face);
    uint32_t step = 1; /* pieces are consecutive: longer and longer steps back, then shorter ones */
    for (; step <= face && scene_face_number(scene, face - step) == number; step *= 2)
        face -= step;
    for (; step > 0; step /= 2)
        if (step <= face && scene_face_number(scene, face - step) == number)
            face -= step;
    return face;
}

/* Finds the depths of a cell in which the piece `piece` of `face` is seen at one point. F: the plane of the piece.
 * False: no memory. */
static bool find_depths(const region_work *w, uint32_t piece, plane F, region_scratch *scratch, cell_sight *sight)
{
    const hide_fronts *fronts = &w->job->fronts;
    const uint32_t *start = fronts->scene->face_start + piece, *corner = fronts->scene->corner + start[0];
    const bool several = region_depths_has(&w->depths, sight->face);
    for (const cell_side *s = scratch->side; several && s < scratch->side + scratch->count; s++)
        if (!region_depths_along(&w->depths, sight->face, (roberts_vec2[]){s->P, s->Q}, &scratch->parts, &sight->depth))
            return false;
    if (sight->depth.low <= sight->depth.high)
        return true;
    for (size_t k = 0; k < scratch->count; k++) {
        const double z = region_depth_at(fronts, corner, start[1] - start[0], F, scratch->side[k].P);
        sight->depth.low = lesser(sight->depth.low, z);
        sight->depth.high = greater(sight->depth.high, z);
    }
    return true;
}

/* Finds what is seen in a cell. False: no memory. */
static bool look_into(const region_work *w, uint32_t cell, region_scratch *scratch, cell_sight *sight)
{
    plane F;
    *sight = (cell_sight){ROBERTS_NONE, {INFINITY, -INFINITY}};
    if (!take_sides(w, cell, scratch))
        return false;
    const roberts_vec2 inside = point_inside(scratch);
    uint32_t face = hide_face_seen_at(&w->job->fronts, &w->job->grid, inside.x, inside.y, &F);
    if (face == ROBERTS_NONE)
        return true;
    sight->face = whole_face(w->job->fronts.scene, face);
    return find_depths(w, face, F, scratch, sight);
}

typedef struct region_look {
    const region_work *w;
    region_scratch *scratches; /* [threads] */
} region_look;

/* Cell 0 is outside of all lines. */
static bool look_into_some(void *context, size_t first, size_t end)
{
    const region_look *l = context;
    for (size_t c = first + 1; c < end + 1; c++)
        if (!look_into(l->w, (uint32_t)c, &l->scratches[thread_self()], &l->w->sight[c]))
            return false;
    return true;
}

static bool look_into_all(region_work *w)
{
    uint32_t count = (uint32_t)w->cells.cell_count;
    int threads = threads_for(w->job->options->threads, 1 + count / CELLS_PER_THREAD);
    region_scratch *scratches = alloc_zeroed((size_t)threads, sizeof *scratches);
    w->sight = alloc_array(count, sizeof *w->sight);
    if (!scratches || !w->sight) {
        free(scratches);
        return false;
    }
    w->sight[0] = (cell_sight){ROBERTS_NONE, {INFINITY, -INFINITY}};
    bool done = threads_each(threads, count - 1, 256, look_into_some, &(region_look){w, scratches});
    for (int i = 0; i < threads; i++) {
        free(scratches[i].side);
        free(scratches[i].item);
        free(scratches[i].parts.part);
    }
    free(scratches);
    return done;
}

/* ---- rings ----------------------------------------------------------------------------------------------------- */

static uint32_t root_of(region_work *w, uint32_t cell)
{
    while (w->root[cell] != cell) {
        w->root[cell] = w->root[w->root[cell]];
        cell = w->root[cell];
    }
    return cell;
}

/* Gives coplanar neighbours of one colour the number of the first of them. False: no memory. */
static bool merge_faces(region_work *w)
{
    const uint32_t faces = w->job->fronts.scene->face_count;
    if (!w->job->options->merge_regions)
        return true;
    uint32_t *set = alloc_array(faces, sizeof *set);
    if (!set)
        return false;
    for (uint32_t f = 0; f < faces; f++)
        set[f] = f;
    for (uint32_t i = 0; i < w->map.line_count; i++) {
        uint32_t f = w->sight[map_cell_of(&w->cells, 2 * i)].face, g = w->sight[map_cell_of(&w->cells, 2 * i + 1)].face;
        if (f == ROBERTS_NONE || g == ROBERTS_NONE || sets_root(set, f) == sets_root(set, g))
            continue;
        if (region_can_join(w->job, f, g))
            sets_join(set, f, g);
    }
    for (size_t c = 0; c < w->cells.cell_count; c++)
        if (w->sight[c].face != ROBERTS_NONE)
            w->sight[c].face = sets_root(set, w->sight[c].face);
    free(set);
    return true;
}

/* Removes lines with the same face on both sides. */
static bool join_cells(region_work *w)
{
    w->gone = alloc_array(w->map.line_count, 1);
    w->root = alloc_array(w->cells.cell_count, sizeof *w->root);
    if (!w->gone || !w->root)
        return false;
    for (uint32_t c = 0; c < w->cells.cell_count; c++)
        w->root[c] = c;
    for (uint32_t i = 0; i < w->map.line_count; i++) {
        uint32_t c = map_cell_of(&w->cells, 2 * i), d = map_cell_of(&w->cells, 2 * i + 1);
        w->gone[i] = w->sight[c].face == w->sight[d].face;
        if (w->gone[i]) {
            c = root_of(w, c);
            d = root_of(w, d);
            w->root[c > d ? c : d] = c < d ? c : d;
        }
    }
    return true;
}

/* Traces the ring of a half-edge, and marks it as done. */
static region_ring ring_of(region_work *w, uint32_t half, uint8_t *done)
{
    uint32_t cell = map_cell_of(&w->cells, half);
    region_ring ring = {.half = half, .face = w->sight[cell].face, .root = root_of(w, cell), .at = corner_of(w, half)};
    for (uint32_t h = half; !done[h]; h = map_next(&w->cells, &w->map, h, w->gone)) {
        roberts_vec2 P = corner_of(w, h);
        done[h] = 1;
        ring.corners++;
        if (vec2_compare(P, ring.at) < 0) {
            ring.at = P;
            ring.half = h;
        }
    }
    ring.area = map_area(&w->cells, &w->map, ring.half, w->gone);
    return ring;
}

static bool trace_rings(region_work *w)
{
    uint32_t halves = 2 * (uint32_t)w->map.line_count;
    uint8_t *done = alloc_zeroed(halves, 1);
    uint32_t *outer = alloc_array(w->cells.cell_count, sizeof *outer); /* by root */
    bool enough = done && outer;
    for (uint32_t h = 0; enough && h < halves; h++) {
        if (done[h] || w->gone[h >> 1] || w->sight[map_cell_of(&w->cells, h)].face == ROBERTS_NONE)
            continue;
        enough = array_reserve(&w->ring, &w->ring_room, w->ring_count + 1, sizeof *w->ring);
        if (enough)
            w->ring[w->ring_count++] = ring_of(w, h, done);
    }
    for (size_t c = 0; enough && c < w->cells.cell_count; c++)
        outer[c] = ROBERTS_NONE;
    for (uint32_t r = 0; enough && r < w->ring_count; r++)
        if (w->ring[r].area > 0.0)
            outer[w->ring[r].root] = r;
    for (uint32_t r = 0; enough && r < w->ring_count; r++) {
        uint32_t about = outer[w->ring[r].root];
        w->ring[r].outer = about != ROBERTS_NONE ? about : r; /* NONE: the map is not planar */
    }
    free(done);
    free(outer);
    return enough;
}

/* A ring among those of its face. */
typedef struct ring_place {
    uint32_t face, ring;
    bool hole;
    roberts_vec2 outer, at;
    uint32_t half;
} ring_place;

static int compare_places(const void *pa, const void *pb)
{
    const ring_place *a = pa, *b = pb;
    int order = vec2_compare(a->outer, b->outer);
    if (order != 0)
        return order;
    if (a->hole != b->hole)
        return a->hole ? 1 : -1;
    order = vec2_compare(a->at, b->at);
    return order != 0 ? order : (a->half > b->half) - (a->half < b->half);
}

static ring_place *sort_rings(const region_work *w)
{
    const size_t count = w->ring_count;
    uint32_t *face = alloc_array(count, sizeof *face), *start = NULL, *order = NULL;
    ring_place *place = NULL;
    for (uint32_t r = 0; face && r < count; r++)
        face[r] = w->ring[r].face;
    if (face && sort_buckets(face, count, w->job->seen.scene->face_count, &start, &order))
        place = alloc_array(count, sizeof *place);
    for (size_t i = 0, k = 0; place && i < count; i++) {
        const region_ring *own = &w->ring[order[i]];
        place[i] =
            (ring_place){own->face, order[i], own->outer != order[i], w->ring[own->outer].at, own->at, own->half};
        if (i + 1 < start[own->face + 1])
            continue;
        if (i > k)
            qsort(place + k, i + 1 - k, sizeof *place, compare_places);
        k = i + 1;
    }
    free(face);
    free(start);
    free(order);
    return place;
}

/* ---- the table ------------------------------------------------------------------------------------------------- */

static void put_corners(const region_work *w, const region_ring *ring, roberts_region_list *out)
{
    double unit = w->job->seen.view.unit;
    uint32_t h = ring->half;
    for (size_t k = 0; k < ring->corners; k++, h = map_next(&w->cells, &w->map, h, w->gone)) {
        roberts_vec2 P = corner_of(w, h);
        out->corner[out->corner_count++] = (roberts_vec2){P.x * unit, P.y * unit};
    }
}

/* Gives regions the depths of their cells. number: of each face's region, or ROBERTS_NONE. */
static void put_depths(const region_work *w, const uint32_t *number, roberts_region_list *out)
{
    double unit = w->job->seen.view.unit;
    for (size_t c = 0; c < w->cells.cell_count; c++) {
        const cell_sight *sight = &w->sight[c];
        if (sight->face == ROBERTS_NONE || number[sight->face] == ROBERTS_NONE)
            continue;
        roberts_region *region = &out->region[number[sight->face]];
        region->z_min = lesser(region->z_min, sight->depth.low * unit);
        region->z_max = greater(region->z_max, sight->depth.high * unit);
    }
}

static bool write_regions(const region_work *w, roberts_region_list *out)
{
    const roberts_scene *scene = w->job->seen.scene;
    double unit = w->job->seen.view.unit;
    size_t faces = 0, corners = 0;
    ring_place *place = sort_rings(w);
    uint32_t *number = alloc_array(scene->face_count, sizeof *number);
    for (size_t k = 0; place && k < w->ring_count; k++) {
        faces += k == 0 || place[k].face != place[k - 1].face;
        corners += w->ring[k].corners;
    }
    out->region = alloc_array(faces, sizeof *out->region);
    out->ring_start = alloc_array(w->ring_count + 1, sizeof *out->ring_start);
    out->corner = alloc_array(corners, sizeof *out->corner);
    bool enough = place && number && out->region && out->ring_start && out->corner;
    for (uint32_t f = 0; enough && f < scene->face_count; f++)
        number[f] = ROBERTS_NONE;
    for (size_t k = 0; enough && k < w->ring_count; k++) {
        const region_ring *ring = &w->ring[place[k].ring];
        if (k == 0 || ring->face != place[k - 1].face) {
            uint32_t solid = scene_body_of_face(scene, ring->face), face = scene_face_number(scene, ring->face);
            number[ring->face] = (uint32_t)out->count;
            out->region[out->count++] = (roberts_region){.solid = solid,
                                                         .face = face,
                                                         .first_ring = k,
                                                         .z_min = INFINITY,
                                                         .z_max = -INFINITY,
                                                         .color = region_color(w->job, ring->face)};
            slope_find(&w->job->seen, ring->face, w->job->upright, &out->region[out->count - 1]);
        }
        out->region[out->count - 1].ring_count++;
        out->region[out->count - 1].area += ring->area * unit * unit;
        out->ring_start[out->ring_count++] = out->corner_count;
        put_corners(w, ring, out);
    }
    if (enough) {
        out->ring_start[out->ring_count] = out->corner_count;
        put_depths(w, number, out);
    }
    free(place);
    free(number);
    return enough;
}

/* ---- all of it ------------------------------------------------------------------------------------------------- */

bool regions_find(const hide_job *job, const roberts_drawing *drawing, const roberts_drawing *rest)
{
    const view *v = &job->seen.view;
    const double touching = REGION_TOUCHING * (v->epsilon + v->across_rounding);
    region_work w = {.job = job};
    bool enough = take_lines(&w, drawing, rest) && planar_map_divide(&w.map, touching) &&
                  map_cells_find(&w.cells, &w.map) && list_halves(&w) &&
                  region_depths_build(&w.depths, &job->fronts, touching) && look_into_all(&w) && merge_faces(&w) &&
                  join_cells(&w) && trace_rings(&w) && write_regions(&w, job->regions);
    region_depths_free(&w.depths);
    planar_map_free(&w.map);
    map_cells_free(&w.cells);
    free(w.start);
    free(w.half);
    free(w.sight);
    free(w.gone);
    free(w.root);
    free(w.ring);
    return enough;
}

roberts_status roberts_regions(const roberts_scene *scene, const roberts_camera *camera,
                               const roberts_hide_options *options, roberts_region_list *out, roberts_error *error)
{
    roberts_hide_options own = options ? *options : roberts_hide_options_default();
    roberts_drawing drawing;
    own.all_edges = true;
    own.keep_hidden = own.levels = own.unite = false;
    *out = (roberts_region_list){0};
    hide_job job = {
        .options = &own, .regions = out, .merge_bodies = options && options->unite, .upright = slope_upright(camera)};
    roberts_status status = hide_scene(&job, scene, camera, &drawing, error);
    roberts_drawing_free(&drawing);
    if (status != ROBERTS_OK)
        roberts_regions_free(out);
    return status;
}

roberts_status roberts_hide_with_regions(const roberts_scene *scene, const roberts_camera *camera,
                                         const roberts_hide_options *options, roberts_drawing *drawing,
                                         roberts_region_list *regions, roberts_error *error)
{
    hide_job job = {.options = options, .regions = regions, .upright = slope_upright(camera)};
    roberts_status status;
    *regions = (roberts_region_list){0};
    if (options && (options->keep_hidden || options->unite)) {
        status = roberts_hide(scene, camera, options, drawing, error);
        if (status == ROBERTS_OK && (status = roberts_regions(scene, camera, options, regions, error)) != ROBERTS_OK)
            roberts_drawing_free(drawing);
        return status;
    }
    status = hide_scene(&job, scene, camera, drawing, error);
    if (status != ROBERTS_OK)
        roberts_regions_free(regions);
    return status;
}

void roberts_regions_free(roberts_region_list *regions)
{
    if (!regions)
        return;
    free(regions->region);
    free(regions->ring_start);
    free(regions->corner);
    *regions = (roberts_region_list){0};
}
