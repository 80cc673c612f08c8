/* src/hide/schedule.h with POSIX threads, which the thread sanitizer sees: with any number of threads, segments come in
 * order, each once, and the work ends early on request. */
#include <pthread.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/threads.h"
#include "hide/schedule.h"
#include "testing.h"

#define CHUNKS 3000
#define THREADS_TRIED 5

/* How many segments chunk k has: none, few, or enough to make the drawing grow. */
static uint32_t size_of(uint32_t k)
{
    return k % 7 == 3 ? 0 : k % 101 == 5 ? 2000 : k * 2654435761u >> 28;
}

typedef struct labour {
    chunks all;
    uint32_t fails;     /* at this chunk there is no memory; CHUNKS: at none */
    int missing;        /* expected threads that never start, as when the system refuses them */
    atomic_int threads; /* that have begun */
} labour;

static bool fill(hide_chunk *chunk, uint32_t k)
{
    if (!array_reserve(&chunk->segment, &chunk->room, size_of(k), sizeof *chunk->segment))
        return false;
    for (chunk->count = 0; chunk->count < size_of(k); chunk->count++)
        chunk->segment[chunk->count] = (roberts_segment){.solid = k, .v0 = (uint32_t)chunk->count};
    return true;
}

static void *work(void *argument)
{
    labour *job = argument;
    int self = atomic_fetch_add(&job->threads, 1);
    for (hide_chunk *chunk; (chunk = chunks_take(&job->all, self));) {
        uint32_t k = chunk->number;
        if (k % 64 == 9) /* one falls behind */
            for (unsigned turn = 0; turn < 40; turn++)
                thread_wait(turn);
        if (k == job->fails || !fill(chunk, k)) {
            chunks_fail(&job->all, ROBERTS_NO_MEMORY);
            return NULL;
        }
        chunks_done(&job->all, self, chunk);
    }
    return NULL;
}

/* By `threads` threads, this one among them. */
static roberts_status run(labour *job, int threads, roberts_drawing *drawing, const roberts_receiver *to)
{
    pthread_t other[THREADS_TRIED];
    assert_true(chunks_init(&job->all, CHUNKS, threads + job->missing, drawing, to));
    for (int i = 1; i < threads; i++)
        assert_int_equal(pthread_create(&other[i], NULL, work, job), 0);
    work(job);
    for (int i = 1; i < threads; i++)
        assert_int_equal(pthread_join(other[i], NULL), 0);
    roberts_status status = (roberts_status)atomic_load(&job->all.status);
    chunks_free(&job->all);
    return status;
}

/* The segment that follows one that is in order. */
static roberts_segment next(roberts_segment s)
{
    s.v0++;
    while (s.solid < CHUNKS && s.v0 >= size_of(s.solid))
        s = (roberts_segment){.solid = s.solid + 1};
    return s;
}

static size_t total(void)
{
    size_t sum = 0;
    for (uint32_t k = 0; k < CHUNKS; k++)
        sum += size_of(k);
    return sum;
}

static void kept_in_order(void **state)
{
    (void)state;
    for (int i = 0; i < 2 * THREADS_TRIED; i++) {
        int threads = 1 + i / 2;
        labour job = {.fails = CHUNKS, .missing = 3 * (i % 2)};
        roberts_drawing drawing = {0};
        roberts_segment expected = {.v0 = UINT32_MAX};
        assert_int_equal(run(&job, threads, &drawing, NULL), ROBERTS_OK);
        assert_int_equal(drawing.count, total());
        for (size_t k = 0; k < drawing.count; k++) {
            expected = next(expected);
            assert_int_equal(drawing.segment[k].solid, expected.solid);
            assert_int_equal(drawing.segment[k].v0, expected.v0);
        }
        free(drawing.segment);
    }
}

typedef struct receiver {
    roberts_segment last;
    size_t count, stop_at;
    bool in_order;
} receiver;

static bool receive(void *context, const roberts_segment *segment)
{
    receiver *r = context;
    r->last = next(r->last);
    r->in_order = r->in_order && segment->solid == r->last.solid && segment->v0 == r->last.v0;
    return ++r->count != r->stop_at;
}

static void given_in_order(void **state)
{
    (void)state;
    for (int threads = 1; threads <= THREADS_TRIED; threads++)
        for (int stopped = 0; stopped < 2; stopped++) {
            labour job = {.fails = CHUNKS};
            roberts_drawing drawing = {0};
            receiver r = {.last = {.v0 = UINT32_MAX}, .in_order = true, .stop_at = stopped ? total() / 3 : 0};
            const roberts_receiver to = {receive, &r};
            assert_int_equal(run(&job, threads, &drawing, &to), stopped ? ROBERTS_STOPPED : ROBERTS_OK);
            assert_true(r.in_order);
            assert_int_equal(r.count, stopped ? total() / 3 : total());
            assert_int_equal(drawing.count, stopped ? r.count - 1 : r.count);
            assert_null(drawing.segment);
        }
}

/* If one thread has no memory, nothing hangs, and no segments come after those of the missing chunk. */
static void ends_without_memory(void **state)
{
    (void)state;
    for (int threads = 1; threads <= THREADS_TRIED; threads++) {
        labour job = {.fails = CHUNKS / 2};
        roberts_drawing drawing = {0};
        assert_int_equal(run(&job, threads, &drawing, NULL), ROBERTS_NO_MEMORY);
        for (size_t i = 0; i < drawing.count; i++)
            assert_true(drawing.segment[i].solid < job.fails);
        free(drawing.segment);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kept_in_order),
        cmocka_unit_test(given_in_order),
        cmocka_unit_test(ends_without_memory),
    };
    return cmocka_run_group_tests_name("chunks", tests, NULL, NULL);
}
