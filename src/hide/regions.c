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
#include "hide/regions.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/sets.h"
#include "base/sort.h"
#include "base/threads.h"
#include "hide/region_faces.h"

/* Where in a stretch a point is taken, as a fraction of it. */
#define ASIDE 0.4557

enum { CELLS_PER_THREAD = 2000 };

/* A ring in the making. */
typedef struct region_ring {
    uint32_t first, corners; /* its half-edges: side[first] .. side[first + corners - 1], the leftmost corner first */
    uint32_t face;           /* of the scene */
    uint32_t outer;          /* the ring round the whole piece: itself, unless it bounds a hole */
    double area;
} region_ring;

typedef struct cell_sight {
    uint32_t face; /* seen in the cell; ROBERTS_NONE: none */
    depth_range depth;
} cell_sight;

typedef struct region_work {
    const hide_job *job;
    planar_map *map;
    map_cells cells;
    region_depths depths;
    uint32_t *start, *cycle; /* the cycles of each cell: [cells + 1], [cycles] */
    cell_sight *sight;       /* [cells] */
    uint8_t *gone;           /* [lines] the same face is seen on both sides */
    uint32_t *root;          /* [cells] joined cells, represented by one of them */
    region_ring *ring;       /* [ring_count] */
    uint32_t *side;          /* [side_count] half-edges of the rings */
    size_t ring_count, ring_room;
    uint32_t side_count; /* fewer than half-edges, whose numbers have 32 bits */
} region_work;

/* ---- lines ----------------------------------------------------------------------------------------------------- */

static bool is_bare(const hide_job *job, uint32_t face)
{
    return job->seen.sight && job->seen.sight[face] == SEEN_WHOLE;
}

/* Is it an edge between two bare faces? */
static bool is_between_bare(const seen *s, const roberts_segment *line)
{
    return s->sight && line->line == ROBERTS_CREASE && !scene_is_convex(s->scene, line->solid) &&
           seen_has_known_faces(s, s->scene->solid[line->solid].face,
                                scene_edge_stored(s->scene, line->solid, line->edge));
}

bool region_lines_take(void *context, const roberts_segment *s)
{
    region_lines *lines = context;
    const double per = lines->seen->view.per_unit;
    if (s->state != SEGMENT_LEFT_OUT) {
        if (!array_reserve(&lines->segment, &lines->room, lines->count + 1, sizeof *s))
            return false;
        lines->segment[lines->count++] = *s;
    }
    return s->line == ROBERTS_WIRE || is_between_bare(lines->seen, s) ||
           planar_map_add(&lines->map, (roberts_vec2){per * s->p0.x, per * s->p0.y},
                          (roberts_vec2){per * s->p1.x, per * s->p1.y});
}

/* ---- which face is seen in a cell ------------------------------------------------------------------------------ */

/* Lists the cycles of each cell. */
static bool list_cycles(region_work *w)
{
    return sort_buckets(w->cells.cell, w->cells.cycle_count, w->cells.cell_count, &w->start, &w->cycle);
}

static roberts_vec2 corner_of(const region_work *w, uint32_t half)
{
    return w->map->node[map_from(w->map, half)];
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
    size_t count = 0;
    for (uint32_t k = w->start[cell]; k < w->start[cell + 1]; k++) {
        const uint32_t first = w->cells.first[w->cycle[k]];
        roberts_vec2 P = corner_of(w, first);
        for (uint32_t half = first, more = 1; more; more = half != first) {
            if (!array_reserve(&scratch->side, &scratch->side_room, count + 1, sizeof *scratch->side))
                return false;
            half = w->cells.next[half];
            const roberts_vec2 Q = corner_of(w, half);
            scratch->side[count++] = (cell_side){P, Q};
            P = Q;
        }
    }
    scratch->count = count;
    return array_reserve(&scratch->item, &scratch->room, count, sizeof *scratch->item);
}

/* The middle and the width of the widest stretch of a cell at height y. Width 0: there is none. */
static double widest_at(region_scratch *scratch, double y, double *x)
{
    size_t count = 0;
    double width = 0.0, *item = scratch->item;
    for (const cell_side *s = scratch->side; s < scratch->side + scratch->count; s++)
        if ((s->P.y <= y) != (s->Q.y <= y))
            item[count++] = s->P.x + (y - s->P.y) / (s->Q.y - s->P.y) * (s->Q.x - s->P.x);
    SORT_LIST(double, item, count, *a > *b, compare_doubles)
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
    return scene->face_number ? scene_first_alike(scene->face_number, face, 0) : face;
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
    uint32_t face = point_face(&w->job->fronts, &w->job->grid, inside, &F);
    if (face == ROBERTS_NONE)
        return true;
    if (is_bare(w->job, face))
        return true; /* a bare face, or several that share sides */
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
    for (uint32_t i = 0; i < w->map->line_count; i++) {
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
    w->gone = alloc_array(w->map->line_count, 1);
    w->root = alloc_array(w->cells.cell_count, sizeof *w->root);
    if (!w->gone || !w->root)
        return false;
    for (uint32_t c = 0; c < w->cells.cell_count; c++)
        w->root[c] = c;
    for (uint32_t i = 0; i < w->map->line_count; i++) {
        uint32_t c = map_cell_of(&w->cells, 2 * i), d = map_cell_of(&w->cells, 2 * i + 1);
        w->gone[i] = w->sight[c].face == w->sight[d].face;
        if (w->gone[i])
            sets_join(w->root, c, d);
    }
    return true;
}

/* Adds the half-edges of the ring that begins with `half` to the sides, from its leftmost corner on, and marks them as
 * done. There is room for them. False: no memory. */
static bool add_ring(region_work *w, uint32_t half, uint8_t *done)
{
    uint32_t *side = w->side + w->side_count, count = 0, leftmost = half;
    for (uint32_t h = map_next(&w->cells, half, w->gone); h != half; h = map_next(&w->cells, h, w->gone))
        if (vec2_compare(corner_of(w, h), corner_of(w, leftmost)) < 0)
            leftmost = h;
    for (uint32_t h = leftmost; !done[h]; h = map_next(&w->cells, h, w->gone)) {
        done[h] = 1;
        side[count++] = h;
    }
    if (!array_reserve(&w->ring, &w->ring_room, w->ring_count + 1, sizeof *w->ring))
        return false;
    w->ring[w->ring_count++] = (region_ring){.first = w->side_count,
                                             .corners = count,
                                             .face = w->sight[map_cell_of(&w->cells, half)].face,
                                             .area = map_area(w->map, side, count)};
    w->side_count += count;
    return true;
}

static bool bounds_region(const region_work *w, uint32_t half)
{
    return !w->gone[half >> 1] && w->sight[map_cell_of(&w->cells, half)].face != ROBERTS_NONE;
}

/* The cell that stands for those on the inner side of a ring. */
static uint32_t root_of(const region_work *w, const region_ring *ring)
{
    return sets_root(w->root, map_cell_of(&w->cells, w->side[ring->first]));
}

static bool trace_rings(region_work *w)
{
    const uint32_t halves = 2 * (uint32_t)w->map->line_count;
    uint32_t sides = 0;
    for (uint32_t h = 0; h < halves; h++)
        sides += bounds_region(w, h);
    w->side = alloc_array(sides, sizeof *w->side);
    uint8_t *done = alloc_zeroed(halves, 1);
    uint32_t *outer = alloc_array(w->cells.cell_count, sizeof *outer); /* by root */
    bool enough = w->side && done && outer &&
                  array_reserve(&w->ring, &w->ring_room, w->cells.cycle_count, sizeof *w->ring); /* mostly enough */
    for (uint32_t h = 0; enough && h < halves; h++)
        if (!done[h] && bounds_region(w, h))
            enough = add_ring(w, h, done);
    for (size_t c = 0; enough && c < w->cells.cell_count; c++)
        outer[c] = ROBERTS_NONE;
    for (uint32_t r = 0; enough && r < w->ring_count; r++)
        if (w->ring[r].area > 0.0)
            outer[root_of(w, &w->ring[r])] = r;
    for (uint32_t r = 0; enough && r < w->ring_count; r++) {
        uint32_t about = outer[root_of(w, &w->ring[r])];
        w->ring[r].outer = about != ROBERTS_NONE ? about : r; /* NONE: the map is not planar */
    }
    free(done);
    free(outer);
    return enough;
}

/* A ring among those of its face. */
typedef struct ring_place {
    uint32_t ring, half;
    bool hole;
    roberts_vec2 outer, at;
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

/* Sorts the rings of one face: outer ones from left to right, each followed by its holes. place: for all of them. */
static void sort_face_rings(const region_work *w, uint32_t *ring, size_t count, ring_place *place)
{
    for (size_t k = 0; k < count; k++) {
        const region_ring *own = &w->ring[ring[k]];
        const uint32_t half = w->side[own->first];
        place[k] = (ring_place){ring[k], half, own->outer != ring[k], corner_of(w, w->side[w->ring[own->outer].first]),
                                corner_of(w, half)};
    }
    qsort(place, count, sizeof *place, compare_places);
    for (size_t k = 0; k < count; k++)
        ring[k] = place[k].ring;
}

/* The numbers of the rings, by faces; NULL: no memory. The caller frees them. */
static uint32_t *sort_rings(const region_work *w)
{
    const size_t count = w->ring_count, faces = w->job->seen.scene->face_count;
    uint32_t *face = alloc_array(count, sizeof *face), *start = NULL, *order = NULL;
    ring_place *place = NULL;
    size_t room = 0;
    bool enough = face;
    for (uint32_t r = 0; face && r < count; r++)
        face[r] = w->ring[r].face;
    enough = enough && sort_buckets(face, count, faces, &start, &order);
    for (size_t f = 0; enough && f < faces; f++) {
        const size_t own = start[f + 1] - start[f];
        if (own < 2)
            continue;
        enough = array_reserve(&place, &room, own, sizeof *place);
        if (enough)
            sort_face_rings(w, order + start[f], own, place);
    }
    free(face);
    free(start);
    free(place);
    if (enough)
        return order;
    free(order);
    return NULL;
}

/* ---- the table ------------------------------------------------------------------------------------------------- */

static void put_corners(const region_work *w, const region_ring *ring, roberts_region_list *out)
{
    double unit = w->job->seen.view.unit;
    for (size_t k = 0; k < ring->corners; k++) {
        roberts_vec2 P = corner_of(w, w->side[ring->first + k]);
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

/* Begins the region of a face. The faces come in order. F: the face's scene_whole_plane(). */
static roberts_region *add_region(const region_work *w, uint32_t face, plane F, roberts_region_list *out)
{
    const hide_job *job = w->job;
    const roberts_scene *scene = job->seen.scene;
    uint32_t solid = out->count > 0 ? out->region[out->count - 1].solid : 0;
    while (scene->solid[solid + 1].face <= face)
        solid++;
    if (out->slope)
        out->slope[out->count] = slope_find(&job->seen, face, F, job->upright);
    roberts_region *region = &out->region[out->count++];
    *region = (roberts_region){.solid = solid,
                               .face = scene_face_number(scene, face),
                               .first_ring = out->ring_count,
                               .z_min = INFINITY,
                               .z_max = -INFINITY,
                               .normal = region_normal(&job->seen, face, F),
                               .color = region_color(job, face),
                               .section = seen_is_cap(scene, face)};
    return region;
}

/* Adds a ring to the last region. */
static void add_region_ring(const region_work *w, const region_ring *ring, roberts_region_list *out)
{
    const double unit = w->job->seen.view.unit;
    roberts_region *region = &out->region[out->count - 1];
    region->ring_count++;
    region->area += ring->area * unit * unit;
    out->ring_start[out->ring_count++] = out->corner_count;
    put_corners(w, ring, out);
}

/* Adds the region of a bare face: its own picture, from the leftmost corner on. It is the same, to the last bit, as if
 * its sides were lines of the map. */
static void add_bare_region(const region_work *w, uint32_t face, roberts_region_list *out)
{
    const seen *s = &w->job->seen;
    const double unit = s->view.unit, per = s->view.per_unit;
    uint32_t turned[SEEN_TURNED], first = 0;
    seen_face look;
    const scene_shape shape = seen_face_again(s, face, &look, turned);
    const bool bent = scene_has_bent_faces(s->scene); /* elsewhere */
    roberts_region *region = add_region(w, face, bent ? scene_whole_plane(s->scene, face) : shape.F, out);
    roberts_vec2 at[3];
    for (uint32_t k = 0; k < 3; k++) {
        const roberts_vec3 P = s->P[look.corner[k]];
        at[k] = (roberts_vec2){per * (P.x * unit), per * (P.y * unit)}; /* as the ends of segments */
        const double z = region_depth_at(&w->job->fronts, look.corner, 3, look.F, at[k]) * unit;
        region->z_min = lesser(region->z_min, z);
        region->z_max = greater(region->z_max, z);
        first = vec2_compare(at[k], at[first]) < 0 ? k : first;
    }
    const roberts_vec2 A = at[first], B = at[(first + 1) % 3], C = at[(first + 2) % 3];
    region->area = 0.5 * ((B.x - A.x) * (C.y - A.y) - (B.y - A.y) * (C.x - A.x)) * unit * unit;
    region->ring_count = 1;
    out->ring_start[out->ring_count++] = out->corner_count;
    for (uint32_t k = 0; k < 3; k++) {
        const roberts_vec2 P = at[(first + k) % 3];
        out->corner[out->corner_count++] = (roberts_vec2){P.x * unit, P.y * unit};
    }
}

/* Adds the regions of the bare faces from *next on, up to the face `end`. */
static void add_bare_regions(const region_work *w, uint32_t *next, uint32_t end, roberts_region_list *out)
{
    for (; w->job->seen.sight && *next < end; ++*next)
        if (is_bare(w->job, *next))
            add_bare_region(w, *next, out);
}

/* Makes room for all regions. order: the rings by their faces. False: no memory. */
static bool reserve_regions(const region_work *w, const uint32_t *order, roberts_region_list *out)
{
    size_t faces = 0, whole = 0;
    for (size_t k = 0; k < w->ring_count; k++)
        faces += k == 0 || w->ring[order[k]].face != w->ring[order[k - 1]].face;
    for (uint32_t f = 0; w->job->seen.sight && f < w->job->seen.scene->face_count; f++)
        whole += is_bare(w->job, f);
    out->region = alloc_array(faces + whole, sizeof *out->region);
    out->ring_start = alloc_array(w->ring_count + whole + 1, sizeof *out->ring_start);
    out->corner = alloc_array(w->side_count + 3 * whole, sizeof *out->corner);
    out->united = w->job->merge_bodies;
    out->slope = w->job->options->slopes ? alloc_array(faces + whole, sizeof *out->slope) : NULL;
    return out->region && out->ring_start && out->corner && (out->slope || !w->job->options->slopes);
}

static bool write_regions(const region_work *w, roberts_region_list *out)
{
    const uint32_t faces = w->job->seen.scene->face_count;
    uint32_t *order = sort_rings(w), *number = alloc_array(faces, sizeof *number), next = 0;
    bool enough = order && number && reserve_regions(w, order, out);
    for (uint32_t f = 0; enough && f < faces; f++)
        number[f] = ROBERTS_NONE;
    for (size_t k = 0; enough && k < w->ring_count; k++) {
        const region_ring *ring = &w->ring[order[k]];
        if (number[ring->face] == ROBERTS_NONE) {
            add_bare_regions(w, &next, ring->face, out);
            number[ring->face] = (uint32_t)out->count;
            add_region(w, ring->face, scene_whole_plane(w->job->seen.scene, ring->face), out);
        }
        add_region_ring(w, ring, out);
    }
    if (enough) {
        add_bare_regions(w, &next, faces, out);
        out->ring_start[out->ring_count] = out->corner_count;
        put_depths(w, number, out);
    }
    free(order);
    free(number);
    return enough;
}

/* ---- all of it ------------------------------------------------------------------------------------------------- */

/* The greatest departure of a face from its plane, or of an outline from the hull that replaces it, but no more than
 * rounding to six digits explains: one bent face must not join what is apart elsewhere. The plane of a sliver may be
 * wrong by far, so its width counts if that is less. */
static double greatest_departure(const hide_fronts *fronts)
{
    const seen *s = fronts->seen;
    const roberts_scene *scene = s->scene;
    float most = 0.0f;
    for (uint32_t f = 0; scene->face_deviation && f < scene->face_count; f++) {
        float own = scene->face_deviation[f] < scene->face_width[f] ? scene->face_deviation[f] : scene->face_width[f];
        most = own > most ? own : most;
    }
    return lesser(greater((double)most * scene->unit * s->view.per_unit, fronts->hull_gap),
                  SCENE_TOLERANCE * s->view.diameter);
}

region_near regions_near(const hide_fronts *fronts)
{
    const view *v = &fronts->seen->view;
    const double touching = REGION_TOUCHING * (v->epsilon + v->across_rounding);
    const double departure = greatest_departure(fronts), joined = touching + LOOSE_DEPARTURES * departure;
    return (region_near){touching, joined, joined + REGION_DEPARTURES * departure};
}

bool regions_find(const hide_job *job, region_lines *lines)
{
    region_work w = {.job = job, .map = &lines->map};
    const region_near *near = &lines->near;
    bool enough = planar_map_divide(w.map, near->joined) && planar_map_join_loose(w.map, near->joined, near->reach) &&
                  map_cells_find(&w.cells, w.map) && list_cycles(&w) &&
                  region_depths_build(&w.depths, &job->fronts, near->touching) && look_into_all(&w) &&
                  merge_faces(&w) && join_cells(&w) && trace_rings(&w) && write_regions(&w, job->regions);
    region_depths_free(&w.depths);
    map_cells_free(&w.cells);
    free(w.start);
    free(w.cycle);
    free(w.sight);
    free(w.gone);
    free(w.root);
    free(w.ring);
    free(w.side);
    return enough;
}

roberts_status roberts_regions(const roberts_scene *scene, const roberts_camera *camera,
                               const roberts_hide_options *options, roberts_region_list *out, roberts_error *error)
{
    roberts_hide_options own = options ? *options : roberts_hide_options_default();
    roberts_drawing drawing;
    own.all_edges = false;
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
    free(regions->slope);
    *regions = (roberts_region_list){0};
}
