/* objet.c - filling and walking the grid. See objet.h. */
#include "hide/objet.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"
#include "base/sort.h"
#include "base/threads.h"
#include "hide/layers.h"

/* A longer list has a tree. Shorter ones are passed over as fast, four fronts at a time, and need no building. */
#define LONG_LIST 768
/* With fewer fronts than this for each, another thread does not pay. */
#define WORTH_A_THREAD 8192

/* Memory of one thread. */
typedef struct lister {
    scan s;
    sort_item *item; /* [room] */
    size_t room;
    char apart[THREADS_APART];
} lister;

/* What all threads share while the grid is filled. */
typedef struct filling {
    objet *grid;
    const hide_fronts *fronts;
    uint32_t first;  /* front that is listed, and those behind it */
    bool fill;       /* entries are written; else they are counted */
    bool late;       /* where sheets are nearer, fronts are not listed */
    uint32_t *place; /* [cells] first counts, then the places of the next entries */
    lister *lister;  /* [threads] */
    int threads;
} filling;

/* Adds one to a count that other threads may change too. Returns the count before. */
static inline uint32_t count_one(uint32_t *cell, bool alone)
{
    return alone ? (*cell)++ : __atomic_fetch_add(cell, 1, __ATOMIC_RELAXED);
}

/* Counts the front in a cell or, with `fill`, lists it there. place: that of its box. */
BITS_INLINE void list_in_cell(const filling *job, uint32_t index, four place, uint32_t column, uint32_t row, bool fill)
{
    objet *grid = job->grid;
    size_t cell = scan_number(&grid->frame, column, row);
    if (job->late && job->fronts->front_box[index].z1 < grid->sheet.depth[cell])
        return;
    uint32_t at = count_one(&job->place[cell], job->threads == 1);
    if (fill)
        grid->entry[at] = (objet_entry){index, objet_sides(objet_cut(place, column, row))};
}

/* The same for every cell that the front touches, column by column. */
static BITS_RARE void list_scanned(const filling *job, uint32_t index, four place, bool fill)
{
    uint32_t turned[SEEN_TURNED], low, high;
    scan *s = &job->lister[thread_self()].s;
    scan_frame wider = job->grid->frame;
    hide_face outline = hide_outline(job->fronts, index, turned);
    wider.margin += hide_loose(job->fronts, index);
    scan_polygon(s, &wider, job->fronts->P, outline.corner, outline.count);
    for (uint32_t i = s->first; i <= s->last; i++) {
        scan_touched(s, &wider, i, &low, &high);
        for (uint32_t j = low; j <= high; j++)
            list_in_cell(job, index, place, i, j, fill);
    }
}

/* The same. If the front's box meets at most two columns and two rows, all their cells are taken. */
BITS_INLINE void list_front(const filling *job, uint32_t index, bool fill)
{
    const scan_frame *f = &job->grid->frame;
    const hide_box *box = &job->fronts->front_box[index];
    const four place = objet_place(job->grid, box);
    const objet_range in = objet_range_of(f, box, f->margin + hide_loose(job->fronts, index));
    if (in.right - in.left > 1 || in.high - in.low > 1) {
        list_scanned(job, index, place, fill);
        return;
    }
    for (uint32_t i = in.left; i <= in.right; i++)
        for (uint32_t j = in.low; j <= in.high; j++)
            list_in_cell(job, index, place, i, j, fill);
}

static bool list_some(void *job, size_t first, size_t end)
{
    const filling *own = job;
    for (size_t k = own->first + first; k < own->first + end; k++)
        if (own->fronts->front[k].listed)
            list_front(own, (uint32_t)k, own->fill);
    return true;
}

/* Counts all fronts, or lists them, in any order. The lists are sorted later. */
static void list_all(filling *job, bool fill)
{
    job->fill = fill;
    threads_each(job->threads, job->fronts->front_count - job->first, 0, list_some, job);
}

/* Makes room for this many entries. False: no memory. */
static bool make_entry_room(objet *grid, size_t count)
{
    if (count > UINT32_MAX || !array_reserve(&grid->entry, &grid->room, count + OBJET_SPARE, sizeof *grid->entry))
        return false;
    memset(grid->entry + count, 0, OBJET_SPARE * sizeof *grid->entry);
    return true;
}

/* Replaces counts by places: start[cell] becomes the first place of the cell's list. False: no memory. */
static bool sum_counts(objet *grid)
{
    size_t total = 0, cells = scan_cells(&grid->frame);
    for (size_t c = 0; c <= cells; c++) {
        size_t count = c < cells ? grid->start[c] : 0;
        if (total > UINT32_MAX)
            return false;
        grid->start[c] = (uint32_t)total;
        total += count;
    }
    return make_entry_room(grid, total);
}

/* Moves each start back. Filling has moved it to the end of its list, where the next list starts. */
static void restore_starts(objet *grid)
{
    size_t cells = scan_cells(&grid->frame);
    for (size_t c = cells; c > 0; c--)
        grid->start[c] = grid->start[c - 1];
    grid->start[0] = 0;
}

/* Sorts the list of a cell, nearest corner first, ties by number. False: no memory. */
static bool sort_list(const filling *job, size_t cell, lister *own)
{
    objet_entry *entry = job->grid->entry + job->grid->start[cell];
    uint32_t count = job->grid->start[cell + 1] - job->grid->start[cell];
    if (count < 2)
        return true;
    if (!array_reserve(&own->item, &own->room, 2 * (size_t)count, sizeof *own->item))
        return false;
    for (uint32_t k = 0; k < count; k++) {
        uint64_t depth = radix_key_descending(job->fronts->front_box[entry[k].front].z1);
        own->item[k] = (sort_item){depth << 32 | entry[k].front, entry[k].sides};
    }
    sort_keyed(own->item, count, own->item + count);
    for (uint32_t k = 0; k < count; k++)
        entry[k] = (objet_entry){(uint32_t)own->item[k].key, own->item[k].value};
    return true;
}

/* Have fronts just been added to the list of a cell? They are at its end. */
static bool has_news(const filling *job, size_t cell)
{
    const uint32_t *start = job->grid->start + cell;
    return start[0] < start[1] && job->grid->entry[start[1] - 1].front >= job->first;
}

typedef struct sorting {
    const filling *job;
    const layers *sheets;
} sorting;

static bool sort_columns(void *context, size_t first, size_t end)
{
    const sorting *s = context;
    const scan_frame *frame = &s->job->grid->frame;
    for (size_t i = first; i < end; i++)
        for (uint32_t j = 0; j < frame->ny; j++) {
            size_t cell = scan_number(frame, (uint32_t)i, j);
            if (s->job->late && !has_news(s->job, cell))
                continue;
            if (!sort_list(s->job, cell, &s->job->lister[thread_self()]))
                return false;
            if (s->job->late)
                layers_find_again(s->sheets, (uint32_t)i, j);
            else
                layers_find(s->sheets, (uint32_t)i, j);
        }
    return true;
}

/* Sorts all new lists, and finds the sheets of each cell while its fronts are in the cache. False: no memory. */
static bool sort_lists(const filling *job, const layers *sheets)
{
    return threads_each(job->threads, job->grid->frame.nx, 16, sort_columns, &(sorting){job, sheets});
}

/* Moves the lists so that each gets room for as many more entries as `place` counts, and sets `place` to where these
 * begin. False: no memory. */
static bool spread_lists(const filling *job)
{
    objet *grid = job->grid;
    size_t cells = scan_cells(&grid->frame), more = 0;
    for (size_t c = 0; c < cells; c++)
        more += job->place[c];
    uint32_t end = grid->start[cells], shift = (uint32_t)more;
    if (!make_entry_room(grid, end + more))
        return false;
    grid->start[cells] = end + shift;
    for (size_t c = cells; c-- > 0;) {
        uint32_t begin = grid->start[c], count = end - begin;
        shift -= job->place[c];
        grid->start[c] = begin + shift;
        memmove(grid->entry + begin + shift, grid->entry + begin, count * sizeof *grid->entry);
        job->place[c] = begin + shift + count;
        end = begin;
    }
    return true;
}

/* Lists the faces that wait. False: no memory. */
static bool list_late(filling *job, layers *sheets, hide_fronts *fronts)
{
    job->late = true;
    job->first = fronts->front_count;
    job->place = alloc_zeroed(scan_cells(&job->grid->frame), sizeof *job->place);
    bool done = job->place && layers_add_late(sheets, fronts);
    if (done) {
        list_all(job, false);
        done = spread_lists(job);
    }
    if (done) {
        list_all(job, true);
        done = sort_lists(job, sheets);
        layers_end_late(sheets);
    }
    free(job->place);
    return done;
}

/* Fills `next`, beginning at the end of each list. False: no memory. */
static bool link_lists(objet *grid, const hide_fronts *fronts)
{
    size_t cells = scan_cells(&grid->frame);
    bool single = false;
    for (uint32_t k = 0; k < fronts->front_count && !single; k++)
        single = fronts->front[k].listed && fronts->front[k].kind == HIDE_SOLID_FACE;
    if (!single)
        return true;
    grid->next = alloc_array(grid->start[cells], sizeof *grid->next);
    for (size_t c = 0; grid->next && c < cells; c++)
        for (uint32_t end = grid->start[c + 1], k = end; k-- > grid->start[c];) {
            bool same = k + 1 < end &&
                        fronts->front[grid->entry[k].front].solid == fronts->front[grid->entry[k + 1].front].solid;
            grid->next[k] = same ? grid->next[k + 1] : k + 1;
        }
    return grid->next != NULL;
}

static bool has_longer(const filling *job)
{
    const objet *grid = job->grid;
    size_t cells = scan_cells(&grid->frame);
    for (size_t c = 0; c < cells; c++)
        if (grid->start[c + 1] - grid->start[c] > LONG_LIST)
            return true;
    return false;
}

static bool plant_tree(const filling *job, size_t cell)
{
    objet *grid = job->grid;
    const objet_entry *entry = grid->entry + grid->start[cell];
    uint32_t count = grid->start[cell + 1] - grid->start[cell];
    if (count <= LONG_LIST)
        return true;
    uint32_t *front = alloc_array(count, sizeof *front);
    for (uint32_t k = 0; front && k < count; k++)
        front[k] = entry[k].front;
    bool done = front && front_tree_build(&grid->tree[cell], job->fronts, front, count);
    free(front);
    return done;
}

static bool plant_some(void *context, size_t first, size_t end)
{
    const filling *job = context;
    for (size_t c = first; c < end; c++)
        if (!plant_tree(job, c))
            return false;
    return true;
}

/* Builds the trees over long lists. False: no memory. */
static bool plant_trees(const filling *job)
{
    objet *grid = job->grid;
    size_t cells = scan_cells(&grid->frame);
    if (grid->next || !has_longer(job))
        return true;
    grid->tree = alloc_zeroed(cells, sizeof *grid->tree);
    return grid->tree && threads_each(job->threads, cells, 16, plant_some, (void *)job);
}

static bool alloc_listers(filling *job)
{
    job->lister = alloc_zeroed((size_t)job->threads, sizeof *job->lister);
    for (int i = 0; job->lister && i < job->threads; i++)
        if (!scan_init(&job->lister[i].s, job->grid->frame.nx))
            return false;
    return job->lister != NULL;
}

static void free_listers(filling *job)
{
    for (int i = 0; job->lister && i < job->threads; i++) {
        scan_free(&job->lister[i].s);
        free(job->lister[i].item);
    }
    free(job->lister);
}

roberts_status objet_build(objet *grid, hide_fronts *fronts, scan_frame frame, uint32_t threads)
{
    filling job = {
        .grid = grid, .fronts = fronts, .threads = threads_for(threads, 1 + fronts->front_count / WORTH_A_THREAD)};
    layers sheets = {0};
    *grid = (objet){.frame = frame};
    for (int i = 0; i < 4; i++) {
        grid->from[i] = (float)(i < 2 ? frame.x0 : frame.y0);
        grid->per[i] = (float)(256.0 * (i < 2 ? frame.per_dx : frame.per_dy));
    }
    job.place = grid->start = alloc_zeroed(scan_cells(&frame) + 1, sizeof *grid->start);
    bool done = grid->start && alloc_listers(&job);
    if (done) {
        list_all(&job, false);
        done = sum_counts(grid);
    }
    if (done) {
        list_all(&job, true);
        restore_starts(grid);
        done = layers_begin(&sheets, grid, fronts, threads) && sort_lists(&job, &sheets) &&
               (!fronts->waits || list_late(&job, &sheets, fronts)) && link_lists(grid, fronts) && plant_trees(&job);
    }
    layers_end(&sheets);
    free_listers(&job);
    if (!done)
        objet_free(grid);
    return done ? ROBERTS_OK : ROBERTS_NO_MEMORY;
}

void objet_free(objet *grid)
{
    free(grid->start);
    free(grid->entry);
    free(grid->next);
    for (size_t c = 0; grid->tree && c < scan_cells(&grid->frame); c++)
        front_tree_free(&grid->tree[c]);
    free(grid->tree);
    free(grid->apart);
    free(grid->below);
    free(grid->star);
    grid->sheet.frame.warps = NULL; /* those of the grid */
    cover_free(&grid->sheet);
    free(grid->frame.warps);
    *grid = (objet){0};
}

void objet_warp_sides(const warp warps[2], float side[4])
{
    for (int i = 0; i < 4; i++)
        side[i] = (float)warp_at(&warps[i / 2], (double)side[i]);
}

bool objet_cells(const objet *grid, roberts_vec3 A, roberts_vec3 B, objet_walk *walk)
{
    const scan_frame *f = &grid->frame;
    double m = f->margin;
    uint32_t last = scan_column(f, greater(A.x, B.x) + m);
    walk->count = 0;
    for (uint32_t i = scan_column(f, lesser(A.x, B.x) - m); i <= last; i++) {
        double t0 = 0.0, t1 = 1.0;
        box_clip(A.x, B.x, scan_left(f, i) - m, scan_left(f, i + 1.0) + m, &t0, &t1);
        if (t0 > t1)
            continue;
        double ya = A.y + t0 * (B.y - A.y), yb = A.y + t1 * (B.y - A.y);
        uint32_t end = scan_row(f, greater(ya, yb) + m);
        for (uint32_t j = scan_row(f, lesser(ya, yb) - m); j <= end; j++) {
            objet_stretch stretch = {i, j, t0, t1};
            box_clip(A.y, B.y, scan_lower(f, j) - m, scan_lower(f, j + 1.0) + m, &stretch.t0, &stretch.t1);
            if (stretch.t0 > stretch.t1)
                continue;
            if (!array_reserve(&walk->item, &walk->room, walk->count + 1, sizeof *walk->item))
                return false;
            walk->item[walk->count++] = stretch;
        }
    }
    return true;
}
