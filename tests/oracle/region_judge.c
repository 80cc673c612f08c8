/* region_judge.c - see region_judge.h. */
#include "region_judge.h"

#include <math.h>
#include <stdlib.h>

#include "cross_judge.h"
#include "mesh_picture.h"

enum { REPORTS = 3 /* most failures reported for a scene */ };

/* A piece of one face's border, in the program's picture. The face lies on its left. */
typedef struct border {
    uint32_t face;
    roberts_vec2 p, q;
} border;

typedef struct comparison {
    const char *name;
    border *mine, *theirs; /* program's and oracle's, by face */
    size_t mine_count, their_count;
    double size; /* of the picture */
    region_total *total;
    FILE *out;
    size_t failed;
} comparison;

static double distance(roberts_vec2 p, roberts_vec2 q)
{
    return hypot(p.x - q.x, p.y - q.y);
}

/* The distance from X to the segment. */
static double beside(const border *b, roberts_vec2 X)
{
    double dx = b->q.x - b->p.x, dy = b->q.y - b->p.y, squared = dx * dx + dy * dy;
    double t = squared > 0 ? ((X.x - b->p.x) * dx + (X.y - b->p.y) * dy) / squared : 0;
    t = fmin(1, fmax(0, t));
    return hypot(b->p.x + t * dx - X.x, b->p.y + t * dy - X.y);
}

static int by_face(const void *a, const void *b)
{
    const border *p = a, *q = b;
    return (p->face > q->face) - (p->face < q->face);
}

static void tell(comparison *c, uint32_t face, const char *what, double how_much)
{
    c->total->disagreements++;
    if (++c->failed <= REPORTS)
        fprintf(c->out, "%s: face %u: %s (%.3g)\n", c->name, face, what, how_much);
}

/* ---- the oracle's picture to the program's ---------------------------------------------------------------------- */

/* p -> m p + b */
typedef struct affine {
    double m[2][2], b[2];
} affine;

static affine map_of(const mesh_scene *scene, const region_truth *truth)
{
    const picture view = picture_of(scene);
    const double a = picture_dot(view.right, truth->u), b = picture_dot(view.up, truth->u);
    const double c = picture_dot(view.right, truth->w), d = picture_dot(view.up, truth->w);
    const double scale = (view.far > 0 ? view.far * view.far : 1) / (a * d - b * c);
    affine out = {.m = {{d * scale, -b * scale}, {-c * scale, a * scale}}};
    if (view.far > 0)
        return out;
    const double x = picture_dot(view.middle, truth->u), y = picture_dot(view.middle, truth->w);
    for (int i = 0; i < 2; i++)
        out.b[i] = -out.m[i][0] * x - out.m[i][1] * y;
    return out;
}

static roberts_vec2 mapped(const affine *m, roberts_vec2 p)
{
    return (roberts_vec2){m->m[0][0] * p.x + m->m[0][1] * p.y + m->b[0], m->m[1][0] * p.x + m->m[1][1] * p.y + m->b[1]};
}

static void take_theirs(comparison *c, const mesh_scene *scene, const region_truth *truth)
{
    const affine map = map_of(scene, truth);
    const bool mirrored = map.m[0][0] * map.m[1][1] < map.m[0][1] * map.m[1][0];
    for (size_t i = 0; i < truth->piece_count; i++) {
        const region_piece *piece = &truth->piece[i];
        const roberts_vec2 p = mapped(&map, piece->p), q = mapped(&map, piece->q);
        const uint32_t left = mirrored ? piece->right : piece->left, right = mirrored ? piece->left : piece->right;
        c->size = fmax(c->size, fmax(fmax(fabs(p.x), fabs(p.y)), fmax(fabs(q.x), fabs(q.y))));
        if (left != ROBERTS_NONE)
            c->theirs[c->their_count++] = (border){left, p, q};
        if (right != ROBERTS_NONE)
            c->theirs[c->their_count++] = (border){right, q, p};
    }
}

static void take_mine(comparison *c, const roberts_region_list *list)
{
    for (size_t i = 0; i < list->count; i++) {
        const roberts_region *region = &list->region[i];
        for (size_t r = region->first_ring; r < region->first_ring + region->ring_count; r++) {
            const size_t first = list->ring_start[r], end = list->ring_start[r + 1];
            for (size_t k = first; k < end; k++)
                c->mine[c->mine_count++] =
                    (border){region->face, list->corner[k], list->corner[k + 1 < end ? k + 1 : first]};
        }
    }
}

/* ---- one face ---------------------------------------------------------------------------------------------------- */

static double area_of(const border *b, size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++) /* about a corner, so that little is lost */
        sum += (b[i].p.x - b[0].p.x) * (b[i].q.y - b[0].p.y) - (b[i].p.y - b[0].p.y) * (b[i].q.x - b[0].p.x);
    return sum / 2;
}

static double length_of(const border *b, size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += distance(b[i].p, b[i].q);
    return sum;
}

/* How far the middle of a piece is from the nearest one that runs the same way. */
static double off_border(const border *piece, const border *b, size_t count)
{
    const roberts_vec2 M = {(piece->p.x + piece->q.x) / 2, (piece->p.y + piece->q.y) / 2};
    double least = HUGE_VAL;
    for (size_t i = 0; i < count; i++)
        if ((b[i].q.x - b[i].p.x) * (piece->q.x - piece->p.x) + (b[i].q.y - b[i].p.y) * (piece->q.y - piece->p.y) > 0)
            least = fmin(least, beside(&b[i], M));
    return least;
}

/* Lines that lie along the border in the picture may end on it; so a corner need not be one of the oracle's ends. */
static double off_pieces(roberts_vec2 X, const border *b, size_t count)
{
    double least = HUGE_VAL;
    for (size_t i = 0; i < count; i++)
        least = fmin(least, beside(&b[i], X));
    return least;
}

static void judge_face(comparison *c, uint32_t face, const border *mine, size_t mine_count, const border *theirs,
                       size_t their_count)
{
    const double size = c->size, limit = REGION_JUDGE_LIMIT * size;
    if (mine_count == 0 || their_count == 0) {
        double area = fabs(area_of(mine, mine_count) + area_of(theirs, their_count));
        if (area > REGION_JUDGE_LIMIT * size * size)
            tell(c, face,
                 mine_count ? "nothing of it is seen, but there is a region of this area"
                            : "it is seen, but there is no region of this area",
                 area);
        return;
    }
    double area = fabs(area_of(mine, mine_count) - area_of(theirs, their_count));
    double length = fabs(length_of(mine, mine_count) - length_of(theirs, their_count)), off = 0, corner = 0;
    for (size_t i = 0; i < their_count; i++)
        off = fmax(off, off_border(&theirs[i], mine, mine_count));
    for (size_t i = 0; i < mine_count; i++)
        corner = fmax(corner, off_pieces(mine[i].p, theirs, their_count));
    if (area > REGION_JUDGE_LIMIT * size * size)
        tell(c, face, "the areas differ", area);
    else if (length > limit * (double)(mine_count + their_count))
        tell(c, face, "the lengths of the borders differ", length);
    else if (off > limit)
        tell(c, face, "a piece of the border is on no ring", off);
    else if (corner > limit)
        tell(c, face, "a corner is not on the border", corner);
    else
        c->total->worst = fmax(c->total->worst, fmax(area / (size * size), fmax(off, corner) / size));
}

static void judge_stated(comparison *c, const roberts_region_list *list)
{
    const border *b = c->mine;
    for (size_t i = 0; i < list->count; i++) {
        const roberts_region *region = &list->region[i];
        const size_t last = region->first_ring + region->ring_count;
        const size_t corners = list->ring_start[last] - list->ring_start[region->first_ring];
        const double differ = fabs(region->area - area_of(b, corners));
        if (differ > REGION_JUDGE_LIMIT * c->size * c->size)
            tell(c, region->face, "the area is not that of the rings", differ);
        if (i > 0 && list->region[i - 1].solid == region->solid && list->region[i - 1].face >= region->face)
            tell(c, region->face, "regions are not in order", 0);
        b += corners;
    }
}

size_t region_judge_list(const char *name, const mesh_scene *scene, const region_truth *truth,
                         const roberts_region_list *list, region_total *total, FILE *out)
{
    comparison c = {.name = name,
                    .mine = malloc((list->corner_count + 1) * sizeof *c.mine),
                    .theirs = malloc((2 * truth->piece_count + 1) * sizeof *c.theirs),
                    .total = total,
                    .out = out};
    if (!c.mine || !c.theirs) {
        tell(&c, 0, "no memory", 0);
    } else {
        take_theirs(&c, scene, truth);
        take_mine(&c, list);
        judge_stated(&c, list);
        qsort(c.mine, c.mine_count, sizeof *c.mine, by_face);
        qsort(c.theirs, c.their_count, sizeof *c.theirs, by_face);
        size_t i = 0, k = 0, seen = 0;
        while (i < c.mine_count || k < c.their_count) {
            const size_t from = i, begin = k;
            uint32_t face = i < c.mine_count ? c.mine[i].face : ROBERTS_NONE;
            if (k < c.their_count && c.theirs[k].face < face)
                face = c.theirs[k].face;
            while (i < c.mine_count && c.mine[i].face == face)
                i++;
            while (k < c.their_count && c.theirs[k].face == face)
                k++;
            seen++;
            judge_face(&c, face, c.mine + from, i - from, c.theirs + begin, k - begin);
        }
        total->regions += list->count;
        total->rings += list->ring_count;
        total->pieces += truth->piece_count;
        total->unseen += scene->mesh.face_count - seen;
    }
    free(c.mine);
    free(c.theirs);
    return c.failed;
}

/* ---- a scene ----------------------------------------------------------------------------------------------------- */

/* Of faces that touch, the one of the body with the smallest number is seen, then the one with the smallest number. */
static uint32_t *ranks_of(const mesh_scene *scene, const roberts_scene *built, const roberts_drawing *drawing)
{
    const size_t count = scene->mesh.face_count;
    uint32_t *body = malloc((count + 1) * sizeof *body), *rank = malloc((count + 1) * sizeof *rank);
    if (body && rank) {
        for (size_t f = 0; f < count; f++)
            body[f] = ROBERTS_NONE;
        cross_take_bodies(built, drawing, body);
        for (size_t f = 0; f < count; f++) {
            rank[f] = 0;
            for (size_t g = 0; g < count; g++)
                rank[f] += body[g] < body[f] || (body[g] == body[f] && g < f);
        }
    }
    free(body);
    return rank;
}

static bool is_place(const roberts_vec3 *P, const roberts_vec3 *Q)
{
    return P->x == Q->x && P->y == Q->y && P->z == Q->z;
}

/* Do three corners of some face lie in different places? If not, the program is right to refuse the scene. */
static bool has_face(const roberts_mesh *mesh)
{
    for (size_t f = 0; f < mesh->face_count; f++) {
        const roberts_vec3 *one = NULL, *other = NULL;
        for (uint32_t k = mesh->face_start[f]; k < mesh->face_start[f + 1]; k++) {
            const roberts_vec3 *P = &mesh->vertex[mesh->corner[k]];
            if (!one)
                one = P;
            else if (is_place(P, one) || (other && is_place(P, other)))
                continue;
            else if (!other)
                other = P;
            else
                return true;
        }
    }
    return false;
}

/* Finds the regions alone, or together with the lines that are drawn. */
static roberts_status find_regions(const roberts_scene *scene, const roberts_camera *camera, bool alone,
                                   roberts_region_list *list, roberts_error *error)
{
    roberts_drawing drawing;
    if (alone)
        return roberts_regions(scene, camera, NULL, list, error);
    roberts_status status = roberts_hide_with_regions(scene, camera, NULL, &drawing, list, error);
    roberts_drawing_free(&drawing);
    return status;
}

bool region_judge_find(const char *name, const mesh_scene *scene, region_truth *truth, roberts_region_list *list,
                       region_total *total, FILE *out)
{
    roberts_camera camera = mesh_judge_camera(scene);
    roberts_hide_options options = roberts_hide_options_default();
    const roberts_scene_options bodies = {.even_odd = scene->even_odd};
    roberts_scene *built = NULL;
    roberts_drawing drawing = {0};
    roberts_error error;
    uint32_t *rank = NULL;
    bool found = false;
    *list = (roberts_region_list){0};
    *truth = (region_truth){0};
    options.keep_hidden = true;
    options.all_edges = true;
    if (roberts_scene_build(&scene->mesh, &bodies, &built, &error) != ROBERTS_OK ||
        roberts_hide(built, &camera, &options, &drawing, &error) != ROBERTS_OK ||
        find_regions(built, &camera, total->scenes % 2 == 0, list, &error) != ROBERTS_OK) {
        fprintf(out, "%s: the program refuses: %s\n", name, error.message);
        ++*(has_face(&scene->mesh) ? &total->disagreements : &total->refused);
    } else if ((rank = ranks_of(scene, built, &drawing)) != NULL) {
        found = region_truth_find(&scene->mesh, &scene->view, scene->even_odd, rank, truth);
        if (!found) {
            fprintf(out, "%s: the oracle refuses: %s\n", name, truth->error);
            total->refused++;
        }
    }
    total->questions += truth->questions;
    total->exact += truth->exact;
    if (!found)
        roberts_regions_free(list);
    roberts_drawing_free(&drawing);
    roberts_scene_free(built);
    free(rank);
    return found;
}

bool region_judge(const char *name, const mesh_scene *scene, const char *folder, region_total *total, FILE *out)
{
    region_truth truth;
    roberts_region_list list;
    const size_t before = total->disagreements;
    total->scenes++;
    if (region_judge_find(name, scene, &truth, &list, total, out)) {
        region_judge_list(name, scene, &truth, &list, total, out);
        roberts_regions_free(&list);
        region_truth_free(&truth);
    }
    if (total->disagreements != before)
        mesh_judge_keep(name, scene, "--regions regions.json", folder, out);
    return total->disagreements == before;
}
