/* threads.h - loops whose items several threads share.
 *
 * Threads are made for one loop and end with it. So none of them ever waits for work, fork() needs no care, and several
 * threads can use the library at once. Making one takes some 20 microseconds: see threads_for(). */
#ifndef ROBERTS_BASE_THREADS_H
#define ROBERTS_BASE_THREADS_H

#include <sched.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>

/* Bytes between data that different threads write: two cache lines, since processors fetch them in pairs. At a smaller
 * distance, threads would take the line from one another at every write. (In an array with an element for each thread,
 * a member `apart` ends the element.) */
#define THREADS_APART 128

/* Returns the number of threads for a loop: as many as asked for (0: as many as available), but no more than are
 * useful. */
int threads_for(uint32_t asked, size_t useful);

/* Does the items first .. end - 1 of a loop. False: the loop has failed; no thread begins any other items. */
typedef bool threads_fn(void *context, size_t first, size_t end);

/* Calls `work` for the items 0 .. count - 1 on at most `threads` threads, one of which is the caller's.
 * at_once  how many items a thread takes at a time. 0: the items are divided into as many equal parts as there are
 *          threads, and thread_self() is the number of the part. So what parts make, taken in the order of their
 *          numbers, is in the order of the items.
 *
 * If the system refuses a thread, the others do its work. Inside another loop there is one thread. False: `work` has
 * failed. */
bool threads_each(int threads, size_t count, size_t at_once, threads_fn *work, void *context);

/* Returns the number of the current thread within the loop, from 0. */
int thread_self(void);

/* Is this called by the work of a loop of several threads? */
bool threads_inside(void);

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
