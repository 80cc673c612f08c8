/* stroke_groups.c - strokes in groups by view, body and class, for SVG.
 *
 * Pieces are sorted by view, then by body and class, or by class and body; each run of pieces with the same key is a
 * group. Within it they are chained and put in order like the pieces of a class. The pen goes from group to group. */
#include "draw/stroke_groups.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"

/* Where a piece belongs. */
typedef struct group_key {
    uint64_t key;
    uint32_t index; /* of the piece */
} group_key;

/* ---- what a number stands for ---- */

piece_source groups_source(const strokes *s, uint32_t number)
{
    uint32_t view = 0;
    if (number >= s->view[0].first_region) {
        while (view + 1 < s->views && s->view[view + 1].first_region <= number)
            view++;
        const roberts_region *region = &s->view[view].drawing->regions->region[number - s->view[view].first_region];
        return (piece_source){.view = view, .body = region->solid, .region = region};
    }
    while (view + 1 < s->views && s->view[view + 1].first <= number)
        view++;
    const roberts_segment *segment = &s->view[view].drawing->segment[number - s->view[view].first];
    return (piece_source){.view = view, .body = segment->solid, .segment = segment};
}

/* Whether two segments, one after the other, are of one edge or one intersection. */
static bool is_same_edge(const roberts_segment *a, const roberts_segment *b)
{
    return a->solid == b->solid && a->v0 == b->v0 && a->v1 == b->v1 && a->edge == b->edge;
}

uint32_t *groups_parts(const strokes *s, size_t count)
{
    const bool by_body = s->options->grouping == ROBERTS_GROUP_BODY;
    uint32_t *part = alloc_array(count, sizeof *part), next = 0;
    for (size_t v = 0; part && v < s->views; v++) {
        const roberts_drawing *d = s->view[v].drawing;
        uint32_t most = 0;
        for (size_t i = 0; i < d->count; i++) {
            const roberts_segment *own = &d->segment[i];
            if (by_body) {
                most = own->solid > most ? own->solid : most;
                part[s->view[v].first + i] = next + own->solid;
            } else {
                most += i > 0 && !is_same_edge(own - 1, own);
                part[s->view[v].first + i] = next + most;
            }
        }
        next += most + 1; /* views do not overlap, so it is harmless if this exceeds 2^32 */
    }
    for (size_t i = s->view[0].first_region; part && i < count; i++) {
        const piece_source source = groups_source(s, (uint32_t)i);
        part[i] = by_body ? source.body : (uint32_t)i; /* strokes of hatching are joined only with one another */
    }
    return part;
}

/* ---- groups ---- */

static uint32_t rank_of(roberts_line line)
{
    uint32_t below = 0;
    while (line_order[below] != line)
        below++;
    return below;
}

static uint64_t key_of_piece(const strokes *s, const piece *p)
{
    const piece_source source = groups_source(s, p->number);
    const uint64_t view = source.view, body = source.body;
    const uint64_t rank = rank_of((roberts_line)p->line);
    return s->options->grouping == ROBERTS_GROUP_BODY ? view << 40 | body << 8 | rank : view << 40 | rank << 32 | body;
}

static int by_key(const void *a, const void *b)
{
    const group_key *p = a, *q = b;
    if (p->key != q->key)
        return p->key < q->key ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

/* Sorts the pieces by their keys. Returns the keys, which the caller frees; NULL: no memory. */
static group_key *sort_pieces(const strokes *s, pieces *p)
{
    group_key *key = alloc_array(p->count, sizeof *key);
    piece *sorted = alloc_array(p->count, sizeof *sorted);
    if (!key || !sorted) {
        free(key);
        free(sorted);
        return NULL;
    }
    for (size_t i = 0; i < p->count; i++)
        key[i] = (group_key){key_of_piece(s, &p->item[i]), (uint32_t)i};
    if (p->count > 1)
        qsort(key, p->count, sizeof *key, by_key);
    for (size_t i = 0; i < p->count; i++)
        sorted[i] = p->item[key[i].index];
    free(p->item);
    p->item = sorted;
    return key;
}

/* Whether piece i is in the group of the piece before it. With an element for each piece, the hatching of each region
 * is a group too. */
static bool is_same_group(const strokes *s, const group_key *key, const pieces *p, size_t i)
{
    return key[i].key == key[i - 1].key &&
           (s->options->grouping == ROBERTS_GROUP_BODY || p->item[i].line != LINE_HATCH ||
            p->item[i].number == p->item[i - 1].number);
}

/* Makes one group of `p`, which holds its pieces alone. */
static roberts_status make_group(strokes *s, const pieces *p, stroke_group group, page_point *pen, roberts_error *error)
{
    polylines own = {0}; /* cutting dashes copies all lines before them */
    roberts_status status = strokes_chain(s, p, group.line, &own, pen, error);
    group.first = s->lines.count;
    if (status == ROBERTS_OK && !polylines_copy(&own, &s->lines))
        status = error_no_memory(error);
    group.end = s->lines.count;
    if (status == ROBERTS_OK && group.end > group.first)
        s->group[s->group_count++] = group;
    polylines_free(&own);
    return status;
}

roberts_status groups_make(strokes *s, pieces *p, roberts_error *error)
{
    const uint32_t none = (uint32_t)s->views;
    page_point pen = {0, 0}; /* the upper left corner */
    static const roberts_line plain[] = {LINE_FRAME, LINE_SYMBOL, LINE_TEXT, LINE_HIDDEN_TEXT}; /* of no body */
    size_t groups = sizeof plain / sizeof plain[0];
    roberts_status status = ROBERTS_OK;
    group_key *key = sort_pieces(s, p);
    for (size_t i = 0; key && i < p->count; i++)
        groups += i == 0 || !is_same_group(s, key, p, i);
    s->group = alloc_array(groups, sizeof *s->group);
    if (!key || !s->group)
        status = error_no_memory(error);
    for (size_t i = 0, end; status == ROBERTS_OK && i < p->count; i = end) {
        const piece *first = &p->item[i];
        for (end = i + 1; end < p->count && is_same_group(s, key, p, end);)
            end++;
        const piece_source source = groups_source(s, first->number);
        const stroke_group group = {.view = source.view, .body = source.body, .line = (roberts_line)first->line};
        status = make_group(s, &(pieces){.item = p->item + i, .count = end - i}, group, &pen, error);
    }
    for (size_t i = 0; status == ROBERTS_OK && i < sizeof plain / sizeof plain[0]; i++) {
        const stroke_group group = {.view = none, .body = ROBERTS_NONE, .line = plain[i]};
        status = make_group(s, &(pieces){0}, group, &pen, error);
    }
    free(key);
    return status;
}
