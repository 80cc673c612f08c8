/* threads.h - the number of threads, and the number of the current one; also works without OpenMP. */
#ifndef ROBERTS_BASE_THREADS_H
#define ROBERTS_BASE_THREADS_H

#include <sched.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>

#ifdef _OPENMP
#include <omp.h>
#endif

/* Bytes between data that different threads write: two cache lines, since processors fetch them in pairs. At a smaller
 * distance, threads would take the line from one another at every write. (In an array with an element for each thread,
 * a member `apart` ends the element.) */
#define THREADS_APART 128

/* Returns the number of threads for a parallel loop: as many as asked for (0: as many as available), but no more than
 * are useful. */
static inline int threads_for(uint32_t asked, size_t useful)
{
#ifdef _OPENMP
    size_t threads = asked ? asked : (size_t)omp_get_max_threads();
    return threads < useful ? (int)threads : useful ? (int)useful : 1;
#else
    (void)asked;
    (void)useful;
    return 1;
#endif
}

/* Returns the number of the current thread within the loop, from 0. */
static inline int thread_self(void)
{
#ifdef _OPENMP
    return omp_get_thread_num();
#else
    return 0;
#endif
}

/* Lowers the shared number to `value` if it is greater. Imposes no other memory order. */
static inline void thread_lower(_Atomic uint32_t *shared, uint32_t value)
{
    uint32_t least = atomic_load_explicit(shared, memory_order_relaxed);
    while (value < least &&
           !atomic_compare_exchange_weak_explicit(shared, &least, value, memory_order_relaxed, memory_order_relaxed))
        ;
}

/* Lets other threads go first; `turn` counts consecutive calls, from 0. After many turns, the system has probably
 * suspended the other threads, and spinning would keep them from running. Then this sleeps. */
static inline void thread_wait(unsigned turn)
{
    if (turn < 32)
        sched_yield();
    else
        nanosleep(&(struct timespec){0, 100000}, NULL);
}

#endif
