/* cuts.c - the lines along which the near plane cuts bodies. See cuts.h.
 *
 * A line is a side of a face whose ends are new vertices in the near plane. A face with no other corners is part of a
 * cap. */
#include "hide/cuts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/box.h"
#include "base/search.h"
#include "base/sort.h"
#include "hide/tolerance.h"
#include "model/union.h"

typedef struct line_list {
    seen_line *line; /* [count] */
    size_t count, room;
} line_list;

/* Does the vertex lie in the near plane? Asked in the model: near the eye, the depth in view space multiplies its
 * rounding by a million. */
static bool is_in_near(const hide_fronts *fronts, uint32_t vertex)
{
    const view *v = &fronts->seen->view;
    const view_clip *clip = &fronts->seen->clip;
    return view_clip_depth(clip, fronts->scene->point[vertex]) <= clip->near + CUT_TOUCHING * v->epsilon * v->unit;
}

/* Is this a vertex in the near plane, where an edge is cut? */
static bool is_cut(const hide_fronts *fronts, uint32_t vertex)
{
    return scene_vertex_number(fronts->scene, vertex) == ROBERTS_NONE && is_in_near(fronts, vertex);
}

typedef bool vertex_test(const hide_fronts *fronts, uint32_t vertex);

static bool all_corners(vertex_test *is, const hide_fronts *fronts, uint32_t face)
{
    const roberts_scene *scene = fronts->scene;
    for (uint32_t k = scene->face_start[face]; k < scene->face_start[face + 1]; k++)
        if (!is(fronts, scene->corner[k]))
            return false;
    return true;
}

/* Adds the sides of a face that are cuts. The face is on their left in the picture. False: no memory. */
static bool add_sides(const hide_fronts *fronts, uint32_t body, uint32_t face, line_list *to)
{
    const roberts_scene *scene = fronts->scene;
    const uint32_t first = scene->face_start[face], end = scene->face_start[face + 1];
    const bool turned = fronts->seen->facing[face] == VIEW_BACK;
    for (uint32_t k = first; k < end; k++) {
        const uint32_t v = scene->corner[k], next = scene->corner[k + 1 < end ? k + 1 : first];
        if (!is_cut(fronts, v) || !is_cut(fronts, next))
            continue;
        if (!array_reserve(&to->line, &to->room, to->count + 1, sizeof *to->line))
            return false;
        to->line[to->count++] = (seen_line){.edge = ROBERTS_NONE,
                                            .v = {turned ? next : v, turned ? v : next},
                                            .own = seen_owns_one(seen_face_key(scene, body, face)),
                                            .t1 = 1.0,
                                            .class = ROBERTS_OUTLINE,
                                            .left_out = true};
    }
    return true;
}

static uint64_t pair_of(const seen_line *line)
{
    const uint64_t a = line->v[0], b = line->v[1];
    return a < b ? a << 32 | b : b << 32 | a;
}

/* Ties are broken, so that every machine keeps the same of several lines. */
static int by_ends(const void *a, const void *b)
{
    const seen_line *f = a, *g = b;
    const uint64_t p = pair_of(f), q = pair_of(g);
    if (p != q)
        return p < q ? -1 : 1;
    if (f->v[0] != g->v[0])
        return f->v[0] < g->v[0] ? -1 : 1;
    return (f->own.key[0] > g->own.key[0]) - (f->own.key[0] < g->own.key[0]);
}

/* Of lines with the same ends, keeps one; of a cap none, because they are sides between two of its pieces. Returns how
 * many are left. */
static size_t drop_equal(seen_line *line, size_t count, bool cap)
{
    size_t kept = 0;
    if (count > 1)
        qsort(line, count, sizeof *line, by_ends);
    for (size_t i = 0, next; i < count; i = next) {
        for (next = i + 1; next < count && pair_of(&line[i]) == pair_of(&line[next]);)
            next++;
        if (next == i + 1 || !cap)
            line[kept++] = line[i];
    }
    return kept;
}

/* Has the near plane left all of the body? Corners without a number may lie in it even then: a face that crosses itself
 * has some. */
static bool is_whole(const seen *s, uint32_t body)
{
    const scene_solid *own = &s->source->solid[body];
    for (uint32_t e = own->edge; e < own[1].edge; e++) {
        const clip_edge left = seen_left_of(s, e);
        if (left.edge == ROBERTS_NONE || left.t0 > 0.0 || left.t1 < 1.0)
            return false;
    }
    return true;
}

/* Adds the cuts of a body's faces that do not bound its cap. False: no memory. */
static bool add_sheets(const hide_fronts *fronts, uint32_t body, line_list *to)
{
    const view_clip *clip = &fronts->seen->clip;
    const scene_solid *own = &fronts->scene->solid[body];
    const size_t first = to->count;
    bool enough = true;
    for (size_t i = find_first(&own->face, clip->sheet, clip->sheet_count, sizeof *clip->sheet, compare_u32);
         enough && i < clip->sheet_count && clip->sheet[i] < own[1].face; i++)
        enough = add_sides(fronts, body, clip->sheet[i], to);
    if (to->count > first)
        to->count = first + drop_equal(to->line + first, to->count - first, false);
    return enough;
}

/* Adds the lines of a body: those of its cap, or else of its faces. False: no memory. */
static bool add_body(const hide_fronts *fronts, uint32_t body, line_list *to)
{
    const scene_solid *own = &fronts->scene->solid[body];
    const size_t first = to->count;
    bool enough = true, capped = false;
    for (int pass = 0; pass < 2 && !capped; pass++)
        for (uint32_t f = own->face; enough && f < own[1].face; f++) {
            const bool cap = all_corners(is_cut, fronts, f);
            capped = capped || cap;
            if (cap || pass > 0)
                enough = add_sides(fronts, body, f, to);
        }
    if (to->count > first)
        to->count = first + drop_equal(to->line + first, to->count - first, capped);
    return enough && (!capped || add_sheets(fronts, body, to));
}

bool cuts_find(const hide_fronts *fronts, seen_further *lines)
{
    const uint32_t bodies = fronts->scene->solid_count;
    line_list found = {0};
    uint32_t *first = alloc_array((size_t)bodies + 1, sizeof *first);
    bool enough = first != NULL;
    for (uint32_t s = 0; enough && s < bodies; s++) {
        first[s] = (uint32_t)found.count;
        enough = fronts->culled[s] || is_whole(fronts->seen, s) || add_body(fronts, s, &found);
    }
    if (enough)
        first[bodies] = (uint32_t)found.count;
    lines->line = found.line;
    lines->first = first;
    return enough;
}

void cuts_free(seen_further *lines)
{
    free((void *)lines->line);
    free((void *)lines->first);
    *lines = (seen_further){0};
}

/* ---- drawing them ------------------------------------------------------------------------------------------------ */

/* The pieces of all caps, and those of faces that lie in the near plane. */
typedef struct cap_pieces {
    uint32_t *face; /* [count] */
    uint32_t *body; /* [count] */
    box3 *box;      /* [count] in the picture */
    box_tree tree;
    uint32_t count, root;
} cap_pieces;

/* What is drawn, and parts of one line that are not. */
typedef struct cut_list {
    roberts_segment *segment; /* [count] */
    size_t count, room;
    double (*part)[2]; /* [parts] */
    size_t parts, part_room;
} cut_list;

static roberts_vec2 in_picture(const hide_fronts *fronts, uint32_t v)
{
    return (roberts_vec2){fronts->P[v].x, fronts->P[v].y};
}

/* The box of some vertices in the picture, widened by the touching distance. */
static box3 picture_box(const hide_fronts *fronts, const uint32_t *v, uint32_t count)
{
    const double touching = fronts->space.epsilon;
    box3 box = {fronts->P[v[0]], fronts->P[v[0]]};
    for (uint32_t i = 1; i < count; i++)
        box3_add(&box, fronts->P[v[i]]);
    return (box3){{box.lo.x - touching, box.lo.y - touching, 0.0}, {box.hi.x + touching, box.hi.y + touching, 0.0}};
}

static void free_caps(cap_pieces *caps)
{
    free(caps->face);
    free(caps->body);
    free(caps->box);
    box_tree_free(&caps->tree);
}

/* False: no memory. Call free_caps() in any case. */
static bool find_caps(const hide_fronts *fronts, const seen_further *lines, cap_pieces *caps)
{
    const roberts_scene *scene = fronts->scene;
    caps->face = alloc_array(scene->face_count, sizeof *caps->face);
    caps->body = alloc_array(scene->face_count, sizeof *caps->body);
    caps->box = alloc_array(scene->face_count, sizeof *caps->box);
    if (!caps->face || !caps->body || !caps->box)
        return false;
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        const bool cut = lines->first[s] < lines->first[s + 1];
        if (fronts->culled[s] || !union_takes(scene, s))
            continue;
        for (uint32_t f = scene->solid[s].face; f < scene->solid[s + 1].face; f++)
            if (fronts->seen->facing[f] != VIEW_EDGE_ON && all_corners(cut ? is_cut : is_in_near, fronts, f)) {
                const uint32_t first = scene->face_start[f];
                caps->face[caps->count] = f;
                caps->body[caps->count] = s;
                caps->box[caps->count++] = picture_box(fronts, scene->corner + first, scene->face_start[f + 1] - first);
            }
    }
    return caps->count == 0 || box_tree_add(&caps->tree, caps->box, caps->count, 0, &caps->root);
}

/* Finds the part of a line that has a cap's piece on its outer side; its own cap is on its left. False: there is none.
 * A piece of which a side runs with the line, in the same direction, is on the inner side. If it `takes` such parts,
 * they count, too. */
static bool part_beside(const hide_fronts *fronts, const roberts_vec2 line[2], uint32_t piece, bool takes,
                        double part[2])
{
    uint32_t turned[SEEN_TURNED], count;
    const uint32_t *corner = seen_corners(fronts->seen, piece, &count, turned);
    const roberts_vec2 along = {line[1].x - line[0].x, line[1].y - line[0].y};
    const double touching = fronts->space.epsilon, length = vec2_length(along.x, along.y);
    part[0] = 0.0;
    part[1] = 1.0;
    for (uint32_t i = 0; i < count && part[1] > part[0]; i++) {
        const roberts_vec2 a = in_picture(fronts, corner[i]), b = in_picture(fronts, corner[i + 1 < count ? i + 1 : 0]);
        const roberts_vec2 side = {b.x - a.x, b.y - a.y};
        const double size = vec2_length(side.x, side.y);
        double inside[2];
        if (!(size > 0.0))
            continue;
        for (int k = 0; k < 2; k++)
            inside[k] = (side.x * (line[k].y - a.y) - side.y * (line[k].x - a.x)) / size;
        if (fabs(inside[0]) <= touching && fabs(inside[1]) <= touching) {
            if (!takes && side.x * along.x + side.y * along.y > 0.0)
                return false;
        } else if (inside[0] < 0.0 && inside[1] < 0.0) {
            return false;
        } else if (inside[0] < 0.0) {
            part[0] = greater(part[0], inside[0] / (inside[0] - inside[1]));
        } else if (inside[1] < 0.0) {
            part[1] = lesser(part[1], inside[0] / (inside[0] - inside[1]));
        }
    }
    return (part[1] - part[0]) * length > touching;
}

/* Finds the parts of a line of body `body` that lie beside caps of others. Of lines in one place, that of the smallest
 * body stays. False: no memory. */
static bool find_parts(const hide_fronts *fronts, const cap_pieces *caps, uint32_t body, const seen_line *line,
                       cut_list *to)
{
    const roberts_vec2 ends[2] = {in_picture(fronts, line->v[0]), in_picture(fronts, line->v[1])};
    const box3 box = picture_box(fronts, line->v, 2);
    box_search near = box_search_begin(&caps->tree, caps->root, &box);
    to->parts = 0;
    for (uint32_t piece; box_search_next(&near, &piece);) {
        const uint32_t other = caps->body[piece];
        if (other == body || !box3_meet(&caps->box[piece], &box))
            continue;
        if (!array_reserve(&to->part, &to->part_room, to->parts + 1, sizeof *to->part))
            return false;
        to->parts += part_beside(fronts, ends, caps->face[piece], other < body, to->part[to->parts]);
    }
    if (to->parts > 1)
        qsort(to->part, to->parts, sizeof *to->part, compare_doubles);
    return true;
}

/* Adds what is drawn of a line between two of its points. False: no memory. */
static bool add_segment(const hide_fronts *fronts, uint32_t body, const seen_line *line, double t0, double t1,
                        cut_list *to)
{
    const double unit = fronts->seen->view.unit;
    const roberts_vec3 a = fronts->P[line->v[0]], ab = vec3_sub(fronts->P[line->v[1]], a);
    const roberts_vec3 p = vec3_add(a, vec3_scale(t0, ab)), q = vec3_add(a, vec3_scale(t1, ab));
    if (!array_reserve(&to->segment, &to->room, to->count + 1, sizeof *to->segment))
        return false;
    to->segment[to->count++] = (roberts_segment){.solid = body,
                                                 .v0 = ROBERTS_NONE,
                                                 .v1 = ROBERTS_NONE,
                                                 .by = ROBERTS_NONE,
                                                 .t0 = t0,
                                                 .t1 = t1,
                                                 .p0 = {p.x * unit, p.y * unit},
                                                 .p1 = {q.x * unit, q.y * unit},
                                                 .z0 = p.z * unit,
                                                 .z1 = q.z * unit,
                                                 .state = ROBERTS_VISIBLE,
                                                 .line = ROBERTS_OUTLINE,
                                                 .edge = ROBERTS_NONE};
    return true;
}

/* Adds what is left of a line between the parts found. False: no memory. */
static bool add_rest(const hide_fronts *fronts, uint32_t body, const seen_line *line, cut_list *to)
{
    const roberts_vec2 a = in_picture(fronts, line->v[0]), b = in_picture(fronts, line->v[1]);
    const double least = fronts->space.epsilon / vec2_length(b.x - a.x, b.y - a.y);
    double t = 0.0;
    bool enough = true;
    for (size_t i = 0; i <= to->parts && enough; i++) {
        const double next = i < to->parts ? to->part[i][0] : 1.0;
        if (next - t > least)
            enough = add_segment(fronts, body, line, t, next, to);
        if (i < to->parts)
            t = greater(t, to->part[i][1]);
    }
    return enough;
}

bool cuts_draw(const hide_fronts *fronts, const seen_further *lines, bool unite, roberts_drawing *drawing)
{
    cut_list list = {0};
    cap_pieces caps = {0};
    bool enough = !unite || find_caps(fronts, lines, &caps);
    for (uint32_t s = 0; enough && s < fronts->scene->solid_count; s++)
        for (uint32_t k = lines->first[s]; enough && k < lines->first[s + 1]; k++)
            enough = (!unite || find_parts(fronts, &caps, s, &lines->line[k], &list)) &&
                     add_rest(fronts, s, &lines->line[k], &list);
    const size_t count = drawing->count + list.count;
    roberts_segment *all = enough && list.count > 0 ? realloc(drawing->segment, count * sizeof *all) : NULL;
    if (all) {
        memcpy(all + drawing->count, list.segment, list.count * sizeof *all);
        drawing->segment = all;
        drawing->cut_count = list.count;
    }
    free(list.segment);
    free(list.part);
    free_caps(&caps);
    return all || (enough && list.count == 0);
}
