/* verify.c - a drawing checked by rays.
 *
 * Idea: at some points of each visible and each hidden stretch of an edge the rule is applied directly: a point is
 * hidden where a front face of another solid lies on its sight line, nearer to the viewer. For an edge without front
 * face (which its own solid hides) the own solid counts as well.
 *
 * Every question has three answers: surely, possibly, no. A point surely hidden that is drawn visible, or not even
 * possibly hidden and drawn hidden, is a contradiction; what is only possible is left undecided. */
#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "ray/sight.h"
#include "ray/tree.h"

/* The first and last point of a stretch lie this part of it from its ends: near enough to find an end that is off by a
 * thousandth of the stretch, and farther than epsilon from it for all stretches that a pen can show. */
#define END_MARGIN 0x1p-10
/* A wrong point counts where a neighbour at this part of the stretch is wrong as well. */
#define NEIGHBOUR 0x1p-12
/* Gaps between the rows of an edge that are rounding (t has a size of 1). */
#define GAP 1e-15
/* How far boxes reach beyond their faces, in loose epsilons: a corner of angle a, grown by epsilon, sticks out by
 * epsilon / sin (a / 2). */
#define BOX_MARGIN 1000.0
/* An angle so near the crease angle may be taken for either side of it; degrees. */
#define CREASE_MARGIN 1e-6

typedef struct verifier {
    sight s;
    tree t;
    uint32_t *tree_face;  /* [items of the tree] front faces, or nearly */
    uint32_t *face_solid; /* [face_count] */
    double *slack;        /* [solid_count] how far a back edge may stick out of the picture of its solid's front faces
                             where coordinates are rounded: that of all its faces */
    uint32_t *row_start;  /* [edge_count + 1] */
    uint32_t *row;        /* [segments] rows of the drawing, edge by edge, by t */
    const roberts_drawing *drawing;
    roberts_verify_options options;
    roberts_verification *result;
} verifier;

roberts_verify_options roberts_verify_options_default(void)
{
    return (roberts_verify_options){.rays = 3, .crease_degrees = 0.1};
}

/* ---- casting ---------------------------------------------------------------------------------------------------- */

/* Whether anything hides X, a point of an edge of `solid`; if `own`, faces of that solid count too. `*by`: a solid that
 * does, or may. */
static sight_answer cast(const verifier *f, roberts_vec3 X, uint32_t solid, bool own, uint32_t *by)
{
    roberts_vec3 v = sight_from(&f->s, X);
    sight_answer answer = SIGHT_NO;
    const uint32_t *item;
    tree_walk walk;
    tree_walk_start(&walk, &f->t, (roberts_ray){X, v}, f->s.perspective ? 1.0 : INFINITY);
    for (uint32_t count; (count = tree_walk_next(&walk, &item)) > 0;) {
        for (uint32_t i = 0; i < count; i++) {
            uint32_t face = f->tree_face[item[i]], occluder = f->face_solid[face];
            if (occluder == solid && !own)
                continue;
            sight_answer one = sight_hides(&f->s, face, X, v, occluder == solid ? f->slack[solid] : 0.0);
            if (one > answer) {
                answer = one;
                *by = occluder;
            }
            if (answer == SIGHT_SURELY)
                return answer;
        }
    }
    return answer;
}

/* What an edge's faces make of it. */
enum { EDGE_FRONT, EDGE_BACK, EDGE_UNSURE };

static int edge_class(const verifier *f, const scene_edge *e)
{
    bool unsure = false;
    for (int i = 0; i < 2; i++) {
        int facing = e->f[i] == ROBERTS_NONE ? SIGHT_NOT_FRONT : f->s.facing[e->f[i]];
        if (facing == SIGHT_FRONT)
            return EDGE_FRONT;
        unsure |= facing == SIGHT_UNSURE;
    }
    return unsure ? EDGE_UNSURE : EDGE_BACK;
}

/* Whether the drawing has to show the edge where nothing hides it: an outline, or bent by more than the crease angle. */
static bool surely_drawn(const verifier *f, const scene_edge *e)
{
    const double degrees = 180.0 / 3.14159265358979323846;
    if (edge_class(f, e) != EDGE_FRONT)
        return false;
    if (f->options.all_edges || e->f[1] == ROBERTS_NONE || f->s.facing[e->f[0]] == SIGHT_NOT_FRONT ||
        f->s.facing[e->f[1]] == SIGHT_NOT_FRONT)
        return true;
    plane F = f->s.scene->face_plane[e->f[0]], G = f->s.scene->face_plane[e->f[1]];
    roberts_vec3 m = {F.a, F.b, F.c}, n = {G.a, G.b, G.c};
    double angle = atan2(vec3_length(vec3_cross(m, n)), vec3_dot(m, n)) * degrees;
    return angle > f->options.crease_degrees + CREASE_MARGIN;
}

/* ---- points of a stretch ---------------------------------------------------------------------------------------- */

static void contradict(verifier *f, roberts_contradiction c)
{
    if (f->result->contradictions++ == 0)
        f->result->first = c;
    if (f->options.contradiction)
        f->options.contradiction(f->options.context, &c);
}

/* Where point k of n lies within a stretch, 0 < position < 1. */
static double position(uint32_t k, uint32_t n)
{
    if (n == 1)
        return 0.5;
    if (k == 0 || k == n - 1)
        return k == 0 ? END_MARGIN : 1.0 - END_MARGIN;
    return (double)k / (n - 1);
}

/* A stretch of an edge that the drawing shows in one state. */
typedef struct stretch {
    uint32_t solid, edge;
    int class;
    double t0, t1;
    roberts_state drawn;
} stretch;

/* Whether the ray from point t of the edge surely contradicts the drawing; `*answer` is what it says. */
static bool contradicted(const verifier *f, const stretch *e, double t, sight_answer *answer, uint32_t *by)
{
    const scene_edge *edge = &f->s.scene->edge[e->edge];
    roberts_vec3 A = f->s.P[edge->v[0]], AB = vec3_sub(f->s.P[edge->v[1]], A);
    *by = ROBERTS_NONE;
    *answer = SIGHT_POSSIBLY;
    if (e->class != EDGE_UNSURE)
        *answer = cast(f, vec3_add(A, vec3_scale(t, AB)), e->solid, e->class == EDGE_BACK, by);
    return *answer == (e->drawn == ROBERTS_HIDDEN ? SIGHT_NO : SIGHT_SURELY);
}

/* Judges the points of a stretch. Where an edge passes behind a mere corner the rule hides one point of it, and the
 * drawing rightly shows nothing of that: only what is contradicted at a neighbouring point too counts. */
static void check_stretch(verifier *f, const stretch *e)
{
    const scene_edge *edge = &f->s.scene->edge[e->edge];
    const uint32_t *number = f->s.scene->number;
    double length = e->t1 - e->t0, step = NEIGHBOUR * length;
    f->result->segments++;
    for (uint32_t k = 0; k < f->options.rays; k++) {
        double t = e->t0 + length * position(k, f->options.rays);
        uint32_t by, other_by;
        sight_answer answer, other;
        f->result->points++;
        bool wrong = contradicted(f, e, t, &answer, &by);
        if (wrong && !contradicted(f, e, t - step, &other, &other_by) &&
            !contradicted(f, e, t + step, &other, &other_by))
            answer = SIGHT_POSSIBLY;
        if (answer == SIGHT_POSSIBLY)
            f->result->undecided++;
        else if (wrong)
            contradict(f, (roberts_contradiction){e->solid, number[edge->v[0]], number[edge->v[1]], t, e->drawn,
                                                  answer == SIGHT_SURELY ? ROBERTS_HIDDEN : ROBERTS_VISIBLE,
                                                  answer == SIGHT_SURELY ? by : ROBERTS_NONE});
    }
}

/* The rows of an edge, and between them, where the edge has to be drawn, the gaps: hidden and left out. */
static void check_edge(verifier *f, uint32_t solid, uint32_t index)
{
    const scene_edge *edge = &f->s.scene->edge[index];
    bool gaps = surely_drawn(f, edge);
    stretch e = {.solid = solid, .edge = index, .class = edge_class(f, edge)};
    double end = 0.0;
    for (uint32_t k = f->row_start[index]; k <= f->row_start[index + 1]; k++) {
        const roberts_segment *row = k < f->row_start[index + 1] ? &f->drawing->segment[f->row[k]] : NULL;
        e.t0 = end;
        e.t1 = row ? row->t0 : 1.0;
        e.drawn = ROBERTS_HIDDEN;
        if (gaps && e.t1 - e.t0 > GAP)
            check_stretch(f, &e);
        if (!row)
            return;
        e.t0 = row->t0;
        e.t1 = row->t1;
        e.drawn = (roberts_state)row->state;
        if (e.drawn != ROBERTS_CLIPPED)
            check_stretch(f, &e);
        end = fmax(end, row->t1);
    }
}

/* ---- rows to edges ---------------------------------------------------------------------------------------------- */

/* The edge of `solid` between input vertices v0 and v1; edge_count where there is none. */
static uint32_t find_edge(const roberts_scene *scene, const roberts_segment *row)
{
    if (row->solid >= scene->solid_count)
        return scene->edge_count;
    uint32_t low = scene->solid[row->solid].edge, high = scene->solid[row->solid + 1].edge;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        const scene_edge *e = &scene->edge[middle];
        uint32_t v0 = scene->number[e->v[0]], v1 = scene->number[e->v[1]];
        if (v0 == row->v0 && v1 == row->v1)
            return middle;
        if (v0 < row->v0 || (v0 == row->v0 && v1 < row->v1))
            low = middle + 1;
        else
            high = middle;
    }
    return scene->edge_count;
}

/* Puts the rows of [first, end) in order of t0; they are few, and mostly in order already. */
static void sort_rows(verifier *f, uint32_t first, uint32_t end)
{
    for (uint32_t i = first + 1; i < end; i++) {
        uint32_t row = f->row[i], k = i;
        for (; k > first && f->drawing->segment[f->row[k - 1]].t0 > f->drawing->segment[row].t0; k--)
            f->row[k] = f->row[k - 1];
        f->row[k] = row;
    }
}

/* Rows by edge, by counting: row_start first counts, then points behind each edge's rows, then to their first. */
static roberts_status assign_rows(verifier *f, roberts_error *error)
{
    const roberts_scene *scene = f->s.scene;
    uint32_t total = 0;
    for (uint32_t i = 0; i < f->drawing->count; i++) {
        const roberts_segment *row = &f->drawing->segment[i];
        uint32_t edge = find_edge(scene, row);
        if (edge == scene->edge_count)
            return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "segment %u is of no edge of the scene (solid %u, %u-%u)",
                             (unsigned)i, (unsigned)row->solid, (unsigned)row->v0, (unsigned)row->v1);
        if (!(0.0 <= row->t0 && row->t0 < row->t1 && row->t1 <= 1.0) || row->state > ROBERTS_CLIPPED)
            return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "segment %u runs from t = %g to %g in state %u",
                             (unsigned)i, row->t0, row->t1, (unsigned)row->state);
        f->row_start[edge]++;
    }
    for (uint32_t e = 0; e <= scene->edge_count; e++)
        total = f->row_start[e] += total;
    for (uint32_t i = (uint32_t)f->drawing->count; i-- > 0;)
        f->row[--f->row_start[find_edge(scene, &f->drawing->segment[i])]] = i;
    for (uint32_t e = 0; e < scene->edge_count; e++)
        sort_rows(f, f->row_start[e], f->row_start[e + 1]);
    return ROBERTS_OK;
}

/* ---- the whole -------------------------------------------------------------------------------------------------- */

/* The tree over the faces that may hide, each in a box that holds whatever counts as touching it. */
static bool build_tree(verifier *f)
{
    const roberts_scene *scene = f->s.scene;
    double margin = BOX_MARGIN * (f->s.loose + f->s.rounding);
    tree_box *box = alloc_array(scene->face_count, sizeof *box);
    uint32_t count = 0;
    if (!box)
        return false;
    for (uint32_t face = 0; face < scene->face_count; face++) {
        if (f->s.facing[face] == SIGHT_NOT_FRONT)
            continue;
        roberts_vec3 lo = {INFINITY, INFINITY, INFINITY}, hi = {-INFINITY, -INFINITY, -INFINITY};
        for (uint32_t k = scene->face_start[face]; k < scene->face_start[face + 1]; k++) {
            roberts_vec3 p = f->s.P[scene->corner[k]];
            lo = (roberts_vec3){fmin(lo.x, p.x - margin), fmin(lo.y, p.y - margin), fmin(lo.z, p.z - margin)};
            hi = (roberts_vec3){fmax(hi.x, p.x + margin), fmax(hi.y, p.y + margin), fmax(hi.z, p.z + margin)};
        }
        f->tree_face[count] = face;
        box[count++] = (tree_box){lo, hi};
    }
    bool built = tree_build(&f->t, box, count);
    free(box);
    return built;
}

static bool prepare(verifier *f, const roberts_scene *scene, const view *v)
{
    f->tree_face = alloc_array(scene->face_count, sizeof *f->tree_face);
    f->face_solid = alloc_array(scene->face_count, sizeof *f->face_solid);
    f->slack = alloc_zeroed(scene->solid_count, sizeof *f->slack);
    f->row_start = alloc_zeroed((size_t)scene->edge_count + 1, sizeof *f->row_start);
    f->row = alloc_array(f->drawing->count, sizeof *f->row);
    if (!f->tree_face || !f->face_solid || !f->slack || !f->row_start || !f->row || !sight_prepare(&f->s, scene, v))
        return false;
    for (uint32_t solid = 0; solid < scene->solid_count; solid++) {
        for (uint32_t face = scene->solid[solid].face; face < scene->solid[solid + 1].face; face++) {
            f->face_solid[face] = solid;
            f->slack[solid] = fmax(f->slack[solid], SIGHT_MARGIN * scene->face_deviation[face] / f->s.unit);
        }
    }
    return build_tree(f);
}

static void release(verifier *f)
{
    sight_free(&f->s);
    tree_free(&f->t);
    free(f->tree_face);
    free(f->face_solid);
    free(f->slack);
    free(f->row_start);
    free(f->row);
}

roberts_status roberts_verify(const roberts_scene *scene, const roberts_camera *camera, const roberts_drawing *drawing,
                              const roberts_verify_options *options, roberts_verification *result, roberts_error *error)
{
    verifier f = {.drawing = drawing, .result = result};
    view v;
    *result = (roberts_verification){0};
    f.options = options ? *options : roberts_verify_options_default();
    if (f.options.rays == 0)
        f.options.rays = roberts_verify_options_default().rays;
    if (drawing->count >= UINT32_MAX)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "more than 2^32 segments");
    roberts_status status = view_prepare(&v, scene, camera, drawing->epsilon, error);
    if (status != ROBERTS_OK)
        return status;
    if (!prepare(&f, scene, &v))
        status = error_no_memory(error);
    else
        status = assign_rows(&f, error);
    for (uint32_t solid = 0; status == ROBERTS_OK && solid < scene->solid_count; solid++)
        for (uint32_t edge = scene->solid[solid].edge; edge < scene->solid[solid + 1].edge; edge++)
            check_edge(&f, solid, edge);
    release(&f);
    return status;
}
