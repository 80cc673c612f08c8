/* cut_ring.c - see cut_ring.h. */
#include "view/cut_ring.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/search.h"
#include "base/sort.h"
#include "base/vec.h"

static int compare_lines(const void *pa, const void *pb)
{
    const cut_line *a = pa, *b = pb;
    if (a->from != b->from)
        return a->from < b->from ? -1 : 1;
    if (a->to != b->to)
        return a->to < b->to ? -1 : 1;
    return (a->winding > b->winding) - (a->winding < b->winding);
}

/* Moves the vertices that begin or end an odd number of lines, or all, to the front, each once, ascending. Returns how
 * many. */
static size_t keep_ends(uint32_t *vertex, size_t count, bool all)
{
    size_t odd = 0;
    qsort(vertex, count, sizeof *vertex, compare_u32);
    for (size_t i = 0, next; i < count; i = next) {
        for (next = i + 1; next < count && vertex[next] == vertex[i];)
            next++;
        if (all || (next - i) % 2)
            vertex[odd++] = vertex[i];
    }
    return odd;
}

/* Where vertices lie on an edge of the body, cuts of that edge and of its parts coincide, except that the coordinates
 * may have been rounded. Replaces each of them by the smallest one, so that lines which meet there have a common end.
 * False: no memory. */
static bool join_lines(cut_lines *lines, const roberts_vec3 *point, double touching)
{
    const size_t ends = 2 * lines->count;
    uint32_t *end = alloc_array(ends, sizeof *end), *first = alloc_array(ends, sizeof *first);
    point_grid grid = {0};
    point_list near = {0};
    size_t odd = 0;
    bool enough = end && first;
    for (size_t i = 0; enough && i < lines->count; i++) {
        end[2 * i] = lines->item[i].from;
        end[2 * i + 1] = lines->item[i].to;
    }
    if (enough && (odd = keep_ends(end, ends, lines->item[0].winding != 0)) > 0)
        enough = point_grid_build(&grid, point, end, odd);
    for (size_t i = 0; enough && i < odd; i++) {
        first[i] = end[i];
        near.count = 0;
        enough = point_grid_near(&grid, point[end[i]], point[end[i]], touching, &near);
        for (size_t k = 0; enough && k < near.count; k++) {
            if (near.item[k] >= end[i] || vec3_length(vec3_sub(point[near.item[k]], point[end[i]])) > touching)
                continue;
            const uint32_t *found = bsearch(&near.item[k], end, i, sizeof *end, compare_u32);
            first[i] = found && first[found - end] < first[i] ? first[found - end] : first[i];
        }
    }
    for (size_t i = 0; enough && odd > 0 && i < ends; i++) {
        uint32_t *own = i % 2 ? &lines->item[i / 2].to : &lines->item[i / 2].from;
        const uint32_t *found = bsearch(own, end, odd, sizeof *end, compare_u32);
        *own = found ? first[found - end] : *own;
    }
    point_grid_free(&grid);
    free(near.item);
    free(end);
    free(first);
    return enough;
}

/* A vertex where cuts do not close. */
typedef struct loose_end {
    uint32_t vertex; /* first, so that compare_u32() sorts them */
    int32_t more;    /* lines that begin there, less those that end there. If parity decides, 1: an odd number meet */
} loose_end;

/* Two loose ends, and how far apart they are. */
typedef struct end_pair {
    double distance;
    uint32_t a, b; /* a line may go from a to b */
} end_pair;

/* With more loose ends than this, none is joined: their pairs would take too much memory and time. */
enum { ENDS_JOINED = 1000 };

static int by_distance(const void *pa, const void *pb)
{
    const end_pair *a = pa, *b = pb;
    if (a->distance != b->distance)
        return a->distance < b->distance ? -1 : 1;
    return a->a != b->a ? (a->a > b->a) - (a->a < b->a) : (a->b > b->b) - (a->b < b->b);
}

/* Lists the loose ends; `end` has room for two for each line. Returns how many there are. */
static size_t find_loose_ends(const cut_lines *lines, loose_end *end)
{
    size_t kept = 0;
    for (size_t i = 0; i < lines->count; i++) {
        const cut_line *line = &lines->item[i];
        const int32_t more = line->winding ? line->winding : 1;
        end[2 * i] = (loose_end){line->from, more};
        end[2 * i + 1] = (loose_end){line->to, line->winding ? -more : more};
    }
    qsort(end, 2 * lines->count, sizeof *end, compare_u32);
    for (size_t i = 0, next; i < 2 * lines->count; i = next) {
        loose_end all = end[i];
        for (next = i + 1; next < 2 * lines->count && end[next].vertex == all.vertex; next++)
            all.more += end[next].more;
        if (lines->item[0].winding == 0)
            all.more %= 2;
        if (all.more != 0)
            end[kept++] = all;
    }
    return kept;
}

/* Joins ends that rounding has left apart, the nearest pairs first, so that all cuts are closed. A new line goes from
 * where too many lines end to where too many begin; if parity decides, its direction does not matter. How far apart
 * they are does not matter either: a cap has to be closed. False: no memory. */
static bool close_gaps(cut_lines *lines, const roberts_vec3 *point)
{
    const bool parity = lines->item[0].winding == 0;
    loose_end *end = alloc_array(2 * lines->count, sizeof *end);
    const size_t ends = end ? find_loose_ends(lines, end) : 0;
    size_t pairs = 0;
    if (!end || ends < 2 || ends > ENDS_JOINED) {
        free(end);
        return end != NULL;
    }
    end_pair *pair = alloc_array(ends * ends, sizeof *pair);
    for (uint32_t a = 0; pair && a < ends; a++)
        for (uint32_t b = 0; b < ends; b++)
            if (parity ? a < b : end[a].more < 0 && end[b].more > 0)
                pair[pairs++] = (end_pair){vec3_length(vec3_sub(point[end[a].vertex], point[end[b].vertex])), a, b};
    if (pairs > 1)
        qsort(pair, pairs, sizeof *pair, by_distance);
    bool enough = pair != NULL;
    for (size_t i = 0; enough && i < pairs; i++) {
        loose_end *a = &end[pair[i].a], *b = &end[pair[i].b];
        const int32_t times = parity ? (a->more != 0 && b->more != 0) : -a->more < b->more ? -a->more : b->more;
        if (times == 0)
            continue;
        enough = array_reserve(&lines->item, &lines->room, lines->count + 1, sizeof *lines->item);
        if (enough)
            lines->item[lines->count++] = (cut_line){a->vertex, b->vertex, parity ? 0 : times, 0};
        a->more += parity ? -times : times;
        b->more -= times;
    }
    free(pair);
    free(end);
    return enough;
}

/* Uses a line once, in both directions. */
static void use_line(cut_line *both, size_t count, size_t i)
{
    const cut_line back = {both[i].to, both[i].from, -both[i].winding, 0};
    both[i].left--;
    for (size_t k = find_numbered(both, count, sizeof *both, back.from); k < count && both[k].from == back.from; k++)
        if (compare_lines(&both[k], &back) == 0 && both[k].left > 0) {
            both[k].left--;
            return;
        }
}

/* Adds a loop to the ring, from the start of a line on: each line is followed by one that begins where it ends. Returns
 * the length of the ring. */
static size_t add_loop(cut_line *both, size_t count, uint32_t start, uint32_t *ring, size_t length)
{
    uint32_t at = start;
    ring[length++] = start;
    for (;;) {
        size_t low = find_numbered(both, count, sizeof *both, at);
        while (low < count && both[low].from == at && (both[low].left == 0 || both[low].winding < 0))
            low++;
        if (low == count || both[low].from != at)
            break;
        use_line(both, count, low);
        at = both[low].to;
        ring[length++] = at;
    }
    if (at != start)
        ring[length++] = start; /* only where close_gaps() has left too many ends */
    ring[length++] = ring[0];
    return length;
}

/* Joins all lines into one ring. Between loops, it goes to its first vertex and back: a path that runs both ways bounds
 * nothing. `both` lists each line in both directions, sorted. With a winding, it is used in the direction in which that
 * is positive. */
static size_t make_ring(cut_line *both, size_t count, uint32_t *ring)
{
    size_t length = 0;
    for (size_t i = 0; i < count; i++)
        while (both[i].left > 0 && both[i].winding >= 0)
            length = add_loop(both, count, both[i].from, ring, length);
    return length;
}

bool cut_ring(cut_lines *lines, const roberts_vec3 *point, double touching, uint32_t **ring, size_t *length)
{
    size_t count = 0, uses = 0;
    cut_line *both = NULL;
    *ring = NULL;
    *length = 0;
    bool enough = join_lines(lines, point, touching) && close_gaps(lines, point) &&
                  (both = alloc_array(2 * lines->count, sizeof *both));
    for (size_t i = 0; enough && i < lines->count; i++) {
        const cut_line *own = &lines->item[i];
        const uint32_t times = own->winding == 0 ? 1 : (uint32_t)abs(own->winding);
        if (own->from == own->to)
            continue;
        both[count++] = (cut_line){own->from, own->to, own->winding, times};
        both[count++] = (cut_line){own->to, own->from, -own->winding, times};
        uses += times;
    }
    if (count > 0) {
        qsort(both, count, sizeof *both, compare_lines);
        *ring = alloc_array(6 * uses + 1, sizeof **ring);
        enough = *ring != NULL;
        *length = enough ? make_ring(both, count, *ring) : 0;
    }
    free(both);
    return enough;
}
