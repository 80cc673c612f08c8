/* threads.c - see threads.h. */
#define _GNU_SOURCE /* for sched_getaffinity(); NOLINT(bugprone-reserved-identifier) */
#include "base/threads.h"

#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

#include "roberts.h"

/* Compilers define _REENTRANT for -pthread. Without it there is one thread. */
#ifdef _REENTRANT
#define HAS_THREADS 1
#else
#define HAS_THREADS 0
#endif

/* A loop. */
typedef struct crew {
    threads_fn *work;
    void *context;
    size_t count, parts;
    size_t at_once;      /* items of each part but the last; 0: parts are equal */
    atomic_size_t taken; /* parts */
    atomic_bool failed;
} crew;

/* One thread of it. */
typedef struct crew_member {
    crew *of;
    int number;
} crew_member;

static _Thread_local int own_number;
static _Thread_local bool own_inside;

uint32_t roberts_processor_count(void)
{
#if HAS_THREADS
#ifdef CPU_COUNT
    cpu_set_t own; /* too small for more than 1024 processors: then all count */
    if (sched_getaffinity(0, sizeof own, &own) == 0)
        return (uint32_t)CPU_COUNT(&own);
#endif
    const long online = sysconf(_SC_NPROCESSORS_ONLN);
    return online > 0 ? (uint32_t)online : 1;
#else
    return 1;
#endif
}

int threads_for(uint32_t asked, size_t useful)
{
    if (!HAS_THREADS || useful < 2 || asked == 1)
        return 1;
    const size_t threads = asked ? asked : roberts_processor_count();
    return (int)(threads < useful ? threads : useful);
}

int thread_self(void)
{
    return own_number;
}

bool threads_inside(void)
{
    return own_inside;
}

/* The first item of part k. */
static size_t part_begin(const crew *c, size_t k)
{
    if (c->at_once == 0)
        return c->count / c->parts * k + c->count % c->parts * k / c->parts;
    return k < c->parts ? k * c->at_once : c->count;
}

static void do_parts(crew *c, int number)
{
    own_number = number;
    while (!atomic_load_explicit(&c->failed, memory_order_relaxed)) {
        const size_t k = atomic_fetch_add_explicit(&c->taken, 1, memory_order_relaxed);
        if (k >= c->parts)
            return;
        if (c->at_once == 0)
            own_number = (int)k;
        if (!c->work(c->context, part_begin(c, k), part_begin(c, k + 1)))
            atomic_store_explicit(&c->failed, true, memory_order_relaxed);
    }
}

#if HAS_THREADS
static void *begin(void *context)
{
    const crew_member *m = context;
    own_inside = true;
    do_parts(m->of, m->number);
    return NULL;
}
#endif

/* Does the parts by `threads` threads, or by fewer if the system has no more. */
static void do_together(crew *c, int threads)
{
#if HAS_THREADS
    pthread_t *thread = malloc((size_t)threads * sizeof *thread);
    crew_member *member = malloc((size_t)threads * sizeof *member);
    int made = 0;
    for (int i = 1; thread && member && i < threads; i++) {
        member[i] = (crew_member){c, i};
        if (pthread_create(&thread[made], NULL, begin, &member[i]) != 0)
            break;
        made++;
    }
    own_inside = true;
    do_parts(c, 0);
    own_inside = false;
    for (int i = 0; i < made; i++)
        pthread_join(thread[i], NULL);
    free(thread);
    free(member);
#else
    (void)threads;
    do_parts(c, 0);
#endif
}

bool threads_each(int threads, size_t count, size_t at_once, threads_fn *work, void *context)
{
    const int outer = own_number;
    if (own_inside || threads < 1)
        threads = 1;
    crew c = {.work = work, .context = context, .count = count, .at_once = at_once};
    if (count == 0)
        return true;
    c.parts = at_once == 0 ? (size_t)threads : (count - 1) / at_once + 1;
    if (c.parts > count)
        c.parts = count;
    if ((size_t)threads > c.parts)
        threads = (int)c.parts;
    atomic_init(&c.taken, 0);
    atomic_init(&c.failed, false);
    if (threads > 1)
        do_together(&c, threads);
    else
        do_parts(&c, 0);
    own_number = outer;
    return !atomic_load(&c.failed);
}
