/* split.c - faces that meet in edges, two or more at each: which of them make up one solid.
 *
 * Pieces that hang together by edges (not by mere vertices, so that two solids touching in a corner stay two) and have two
 * faces at each edge are solids. In any other piece solids touch: four faces meet in an edge, or six. Two ways lead apart,
 * tried in this order:
 *
 * 1. By the file. Faces of one solid mostly stand together, so faces are taken in order until each edge of those taken has
 *    two of them; these are a solid, or some that do not touch. It needs no geometry, and gives back what was written.
 * 2. By the angles between faces: see walls.c.
 *
 * Both are linear for faces with few neighbours. */
#include "model/split.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/sets.h"
#include "model/walls.h"

/* ---- pieces -------------------------------------------------------------------------------------------------------- */

static void unite(uint32_t *parent, uint32_t a, uint32_t b)
{
    a = sets_root(parent, a);
    b = sets_root(parent, b);
    parent[a < b ? b : a] = a < b ? a : b;
}

/* Numbers the edges and joins the faces at each. */
static void number_edges(splitter *s)
{
    uint32_t start = 0, vertices = s->loose->vertex_count;
    for (uint32_t f = 0; f < s->face_count; f++)
        s->parent[f] = f;
    for (uint32_t v = 0; v < vertices; start = s->edges->end[v++])
        for (uint32_t i = start; i < s->edges->end[v]; i++) {
            if (i == start || s->edges->half[i] >> 32 != s->edges->half[i - 1] >> 32)
                s->edge_start[s->edge_count++] = i;
            else
                unite(s->parent, splitter_face(s, i - 1), splitter_face(s, i));
            s->edge_of[(uint32_t)s->edges->half[i]] = s->edge_count - 1;
        }
    s->edge_start[s->edge_count] = s->corner_count;
}

/* ---- by the file --------------------------------------------------------------------------------------------------- */

/* The faces order[from] .. order[to - 1] have two at each edge: a group for each part that hangs together. */
static void group_run(splitter *s, uint32_t *parent, uint32_t from, uint32_t to)
{
    for (uint32_t i = from; i < to; i++) {
        uint32_t f = s->order[i];
        for (uint32_t c = s->loose->face_start[f]; c < s->loose->face_start[f + 1]; c++)
            unite(parent, f, s->last[s->edge_of[c]]);
    }
    for (uint32_t i = from; i < to; i++) {
        uint32_t f = s->order[i], root = sets_root(parent, f); /* the root is the smallest and comes first */
        s->groups->of[f] = root == f ? splitter_group(s, true) : s->groups->of[root];
    }
}

/* Splits the piece order[from] .. order[to - 1] into runs that close. False, and nothing is grouped, where some do not. */
static bool split_by_file(splitter *s, uint32_t *parent, uint32_t from, uint32_t to)
{
    uint32_t groups = s->groups->count, open = 0, crowded = 0, begin = from;
    for (uint32_t i = from; i < to; i++)
        parent[s->order[i]] = s->order[i];
    for (uint32_t i = from; i < to && !crowded; i++) {
        uint32_t f = s->order[i];
        for (uint32_t c = s->loose->face_start[f]; c < s->loose->face_start[f + 1]; c++) {
            uint32_t e = s->edge_of[c];
            s->last[e] = s->count[e]++ == 0 ? f : s->last[e];
            open += s->count[e] == 1;
            open -= s->count[e] == 2;
            crowded += s->count[e] > 2;
        }
        if (open > 0 || crowded)
            continue;
        group_run(s, parent, begin, i + 1);
        for (; begin <= i; begin++)
            for (uint32_t c = s->loose->face_start[s->order[begin]]; c < s->loose->face_start[s->order[begin] + 1]; c++)
                s->count[s->edge_of[c]] = 0;
    }
    if (!open && !crowded)
        return true;
    for (uint32_t i = from; i < to; i++) {
        s->groups->of[s->order[i]] = ROBERTS_NONE;
        for (uint32_t c = s->loose->face_start[s->order[i]]; c < s->loose->face_start[s->order[i] + 1]; c++)
            s->count[s->edge_of[c]] = 0;
    }
    s->groups->count = groups;
    return false;
}

/* ---- all pieces ------------------------------------------------------------------------------------------------------ */

/* Sorts the faces by piece, ascending in each; parent[f] becomes the piece's number, start[p] its end. */
static uint32_t sort_pieces(splitter *s, uint32_t *end)
{
    uint32_t pieces = 0, sum = 0;
    for (uint32_t f = 0; f < s->face_count; f++)
        s->parent[f] = sets_root(s->parent, f);
    for (uint32_t f = 0; f < s->face_count; f++) { /* a root comes before its faces */
        s->parent[f] = s->parent[f] == f ? pieces++ : s->parent[s->parent[f]];
        end[s->parent[f]]++;
    }
    for (uint32_t p = 0; p < pieces; p++) {
        uint32_t here = end[p];
        end[p] = sum;
        sum += here;
    }
    for (uint32_t f = 0; f < s->face_count; f++)
        s->order[end[s->parent[f]]++] = f;
    return pieces;
}

/* What the faces at the piece's edges allow. */
typedef enum edge_counts {
    TWO_EACH, /* the piece is closed */
    EVEN,     /* it may be solids that touch */
    ODD,      /* it is not: each solid takes two of the faces at an edge */
} edge_counts;

static edge_counts count_at_edges(const splitter *s, uint32_t from, uint32_t to)
{
    edge_counts found = TWO_EACH;
    for (uint32_t i = from; i < to; i++)
        for (uint32_t c = s->loose->face_start[s->order[i]]; c < s->loose->face_start[s->order[i] + 1]; c++) {
            uint32_t count = s->edge_start[s->edge_of[c] + 1] - s->edge_start[s->edge_of[c]];
            if (count % 2)
                return ODD;
            found = count == 2 ? found : EVEN;
        }
    return found;
}

static bool split_piece(splitter *s, const solid_frame *frame, uint32_t *scratch, uint32_t from, uint32_t to)
{
    edge_counts counts = count_at_edges(s, from, to);
    bool whole = counts != EVEN;
    if (counts == EVEN && split_by_file(s, scratch, from, to))
        return true;
    if (counts == EVEN && !walls_split(s, frame, from, to))
        return false;
    for (uint32_t i = from; i < to; i++)
        whole |= s->groups->of[s->order[i]] == ROBERTS_NONE;
    if (whole) {
        uint32_t group = splitter_group(s, counts == TWO_EACH);
        for (uint32_t i = from; i < to; i++)
            s->groups->of[s->order[i]] = group;
    }
    return true;
}

bool split_faces(split_groups *groups, const roberts_scene *loose, const edge_scratch *edges)
{
    splitter s = {.loose = loose, .edges = edges, .groups = groups, .face_count = loose->face_count};
    solid_frame frame = {0};
    uint32_t *end = alloc_zeroed(loose->face_count, sizeof *end);
    uint32_t *scratch = alloc_array(loose->face_count, sizeof *scratch);
    bool enough = false;
    s.corner_count = (uint32_t)loose->corner_count;
    s.edge_of = alloc_array(s.corner_count, sizeof *s.edge_of);
    s.edge_start = alloc_array((size_t)s.corner_count + 1, sizeof *s.edge_start);
    s.parent = alloc_array(s.face_count, sizeof *s.parent);
    s.order = alloc_array(s.face_count, sizeof *s.order);
    s.count = alloc_zeroed(s.corner_count, sizeof *s.count);
    s.last = alloc_array(s.corner_count, sizeof *s.last);
    *groups = (split_groups){0};
    groups->of = alloc_array(s.face_count, sizeof *groups->of);
    groups->closed = alloc_zeroed((size_t)s.face_count + 1, sizeof *groups->closed);
    if (!end || !scratch || !s.edge_of || !s.edge_start || !s.parent || !s.order || !s.count || !s.last ||
        !groups->of || !groups->closed || frame_enter(&frame, loose, 0, 0.0) == ROBERTS_NO_MEMORY)
        goto done;
    memset(groups->of, 0xff, s.face_count * sizeof *groups->of);
    number_edges(&s);
    uint32_t pieces = sort_pieces(&s, end), from = 0;
    enough = true;
    for (uint32_t p = 0; p < pieces && enough; from = end[p++])
        enough = split_piece(&s, &frame, scratch, from, end[p]);
done:
    frame_free(&frame);
    free(end);
    free(scratch);
    free(s.edge_of);
    free(s.edge_start);
    free(s.parent);
    free(s.order);
    free(s.count);
    free(s.last);
    if (!enough)
        split_groups_free(groups);
    return enough;
}

void split_groups_free(split_groups *groups)
{
    free(groups->of);
    free(groups->closed);
    *groups = (split_groups){0};
}
