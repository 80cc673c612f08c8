/* chunks.c - see chunks.h.
 *
 * All operations on what threads share are sequentially consistent, which is what makes it sure that a full chunk is seen
 * by someone: a thread first says that its chunk is full and then looks whether another is at the placing; that one first
 * says that it no longer is, and then looks for full chunks. */
#include "hide/chunks.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/threads.h"

/* So many chunks may wait for their turn, so that a thread that the system has put aside does not stop the others. */
#define SLOTS_PER_THREAD 16
/* So many chunks one thread lays down at a time: it leaves some to the others, since the memory is new to the program and
 * the system has to bring it, which takes longer than the copying. */
#define LAID_AT_ONCE 4

bool chunks_init(chunks *c, uint32_t total, int threads, roberts_drawing *drawing, roberts_segment_fn *each,
                 void *context)
{
    *c = (chunks){.total = total, .drawing = drawing, .each = each, .context = context};
    c->slots = threads > 1 ? SLOTS_PER_THREAD * (uint32_t)threads : 1;
    c->slot = alloc_zeroed(c->slots, sizeof *c->slot);
    for (uint32_t i = 0; c->slot && i < c->slots; i++)
        atomic_init(&c->slot[i].stage, 2 * i);
    return c->slot != NULL;
}

void chunks_free(chunks *c)
{
    for (uint32_t i = 0; c->slot && i < c->slots; i++)
        free(c->slot[i].segment);
    free(c->slot);
    c->slot = NULL;
}

void chunks_fail(chunks *c, roberts_status status)
{
    int ok = ROBERTS_OK;
    atomic_compare_exchange_strong(&c->status, &ok, (int)status);
}

static bool is_full(chunks *c, uint32_t k)
{
    return k < c->total && atomic_load(&c->status) == ROBERTS_OK &&
           atomic_load(&c->slot[k % c->slots].stage) == 2 * k + 1;
}

static void set_free(chunks *c, uint32_t k)
{
    atomic_store(&c->slot[k % c->slots].stage, 2 * (k + c->slots));
}

/* All chunks from k on that are full. */
static void give_away(chunks *c, uint32_t k)
{
    for (; is_full(c, k); set_free(c, k++)) {
        const hide_chunk *chunk = &c->slot[k % c->slots];
        for (size_t i = 0; i < chunk->count; i++, c->drawing->count++)
            if (!c->each(c->context, &chunk->segment[i])) {
                chunks_fail(c, ROBERTS_STOPPED);
                return;
            }
        atomic_store(&c->placed, k + 1);
    }
}

/* Places for some chunks from k on; the first that has none. The drawing moves only while nobody writes to it. */
static uint32_t give_places(chunks *c, uint32_t k)
{
    size_t total = c->drawing->count;
    uint32_t end = k;
    for (; end < k + LAID_AT_ONCE && is_full(c, end); end++) {
        hide_chunk *chunk = &c->slot[end % c->slots];
        chunk->place = total;
        total += chunk->count;
    }
    if (total > c->room) {
        for (unsigned turn = 0; atomic_load(&c->copying); turn++)
            thread_wait(turn);
        if (!array_reserve(&c->drawing->segment, &c->room, total, sizeof *c->drawing->segment)) {
            chunks_fail(c, ROBERTS_NO_MEMORY);
            return k;
        }
    }
    c->drawing->count = total;
    atomic_fetch_add(&c->copying, 1);
    atomic_store(&c->placed, end);
    return end;
}

static void lay_down(chunks *c, uint32_t k, uint32_t end)
{
    for (; k < end; set_free(c, k++)) {
        const hide_chunk *chunk = &c->slot[k % c->slots];
        if (chunk->count)
            memcpy(c->drawing->segment + chunk->place, chunk->segment, chunk->count * sizeof *chunk->segment);
    }
    atomic_fetch_sub(&c->copying, 1);
}

/* What is full and in turn, unless another thread is at it. */
static void place(chunks *c)
{
    while (is_full(c, atomic_load(&c->placed)) && !atomic_exchange(&c->placing, true)) {
        uint32_t first = atomic_load(&c->placed), end = first;
        if (c->each)
            give_away(c, first);
        else if (is_full(c, first))
            end = give_places(c, first);
        atomic_store(&c->placing, false);
        if (end > first)
            lay_down(c, first, end);
    }
}

hide_chunk *chunks_take(chunks *c, uint32_t *k)
{
    *k = atomic_load(&c->taken) < c->total ? atomic_fetch_add(&c->taken, 1) : c->total;
    if (*k >= c->total)
        return NULL;
    hide_chunk *chunk = &c->slot[*k % c->slots];
    for (unsigned turn = 0; atomic_load(&chunk->stage) != 2 * *k; turn++) {
        if (atomic_load(&c->status) != ROBERTS_OK)
            return NULL; /* the slot may still be another's */
        place(c);
        thread_wait(turn);
    }
    chunk->count = 0;
    return atomic_load(&c->status) == ROBERTS_OK ? chunk : NULL;
}

void chunks_done(chunks *c, uint32_t k)
{
    atomic_store(&c->slot[k % c->slots].stage, 2 * k + 1);
    place(c);
}
