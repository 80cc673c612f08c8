/* chunks.c - see chunks.h. */
#include "hide/chunks.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

/* At the end threads wait for the last run, so that each should have many. */
#define RUNS_PER_THREAD 16

bool chunks_init(chunks *c, uint32_t total, int threads, roberts_drawing *drawing, roberts_segment_fn *each,
                 void *context)
{
    *c = (chunks){.total = total, .drawing = drawing, .each = each, .context = context, .threads = threads};
    uint32_t fair = total / ((uint32_t)threads * RUNS_PER_THREAD);
    c->run = fair < 1 ? 1 : fair < CHUNKS_RUN ? fair : CHUNKS_RUN;
    c->queue = alloc_zeroed((size_t)threads, sizeof *c->queue);
    for (int i = 0; c->queue && i < threads; i++)
        for (uint32_t k = 0; k < CHUNKS_WAITING; k++)
            c->queue[i].spare[k] = &c->queue[i].chunk[k];
    return c->queue != NULL;
}

void chunks_free(chunks *c)
{
    for (int i = 0; c->queue && i < c->threads; i++)
        for (uint32_t k = 0; k < CHUNKS_WAITING; k++)
            free(c->queue[i].chunk[k].segment);
    free(c->queue);
    c->queue = NULL;
}

void chunks_fail(chunks *c, roberts_status status)
{
    int ok = ROBERTS_OK;
    atomic_compare_exchange_strong(&c->status, &ok, (int)status);
}

static bool goes_on(chunks *c)
{
    return atomic_load(&c->status) == ROBERTS_OK;
}

static void give_away(chunks *c, const hide_chunk *chunk)
{
    for (size_t i = 0; i < chunk->count; i++, c->drawing->count++)
        if (!c->each(c->context, &chunk->segment[i])) {
            chunks_fail(c, ROBERTS_STOPPED);
            return;
        }
    atomic_store(&c->turn, chunk->number + 1);
}

/* The drawing moves only while nobody writes to it. The next has its turn before the copying, most of which is the system
 * bringing new memory. */
static void lay_down(chunks *c, const hide_chunk *chunk)
{
    size_t first = c->drawing->count, total = first + chunk->count;
    if (total > c->room) {
        for (unsigned turn = 0; atomic_load(&c->copying); turn++)
            thread_wait(turn);
        if (!array_reserve(&c->drawing->segment, &c->room, total, sizeof *c->drawing->segment)) {
            chunks_fail(c, ROBERTS_NO_MEMORY);
            return;
        }
    }
    roberts_segment *to = c->drawing->segment + first;
    c->drawing->count = total;
    atomic_fetch_add(&c->copying, 1);
    atomic_store(&c->turn, chunk->number + 1);
    if (chunk->count)
        memcpy(to, chunk->segment, chunk->count * sizeof *chunk->segment);
    atomic_fetch_sub(&c->copying, 1);
}

/* The thread's own whose turn it is: they are free again. */
static void settle(chunks *c, chunk_queue *own)
{
    for (; own->count && goes_on(c); own->first = (own->first + 1) % CHUNKS_WAITING) {
        hide_chunk *chunk = own->waiting[own->first];
        if (chunk->number != atomic_load(&c->turn))
            break;
        if (c->each)
            give_away(c, chunk);
        else
            lay_down(c, chunk);
        own->count--;
        own->spare[CHUNKS_WAITING - 1 - own->count] = chunk;
    }
}

/* Until no more than `most` of the thread's own are waiting. */
static void wait_for_turns(chunks *c, chunk_queue *own, uint32_t most)
{
    for (unsigned turn = 0; own->count > most && goes_on(c); turn++) {
        thread_wait(turn);
        settle(c, own);
    }
}

/* The thread's next run, where there is one; else an empty one. */
static void take_run(chunks *c, chunk_queue *own)
{
    uint32_t runs = (c->total + c->run - 1) / c->run;
    uint32_t k = atomic_load(&c->taken) < runs ? atomic_fetch_add(&c->taken, 1) : runs;
    if (k >= runs)
        return;
    own->next = k * c->run;
    own->end = c->total - own->next < c->run ? c->total : own->next + c->run;
}

hide_chunk *chunks_take(chunks *c, int self)
{
    chunk_queue *own = &c->queue[self];
    wait_for_turns(c, own, CHUNKS_WAITING - 1);
    if (own->next == own->end)
        take_run(c, own);
    if (own->next == own->end)
        wait_for_turns(c, own, 0);
    if (own->next == own->end || !goes_on(c))
        return NULL;
    hide_chunk *chunk = own->spare[CHUNKS_WAITING - 1 - own->count];
    chunk->number = own->next++;
    chunk->count = 0;
    return chunk;
}

void chunks_done(chunks *c, int self, hide_chunk *chunk)
{
    chunk_queue *own = &c->queue[self];
    own->waiting[(own->first + own->count++) % CHUNKS_WAITING] = chunk;
    settle(c, own);
}
