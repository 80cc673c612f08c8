/* workers.h - processes that do numbered tasks, several at a time. */
#ifndef ROBERTS_CLI_WORKERS_H
#define ROBERTS_CLI_WORKERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* How a task has ended. */
typedef enum worker_end {
    WORKER_REPORTED,
    WORKER_UNHEARD,   /* its report does not fit into memory */
    WORKER_DIED,      /* the worker has ended in the middle of it */
    WORKER_LATE,      /* it took too long, and the worker was ended */
    WORKER_UNSTARTED, /* no worker could be started */
} worker_end;

typedef struct worker_outcome {
    size_t task;
    worker_end end;
    const char *report; /* WORKER_REPORTED: `size` bytes; NULL: the worker had no memory for it */
    size_t size;
    int status;     /* WORKER_DIED: as waitpid() returns it; WORKER_UNSTARTED: errno */
    bool fresh;     /* the worker had done nothing before */
    double seconds; /* wall-clock time since the task was handed out */
} worker_outcome;

typedef struct worker_plan {
    size_t tasks;          /* numbered from 0 */
    int workers;           /* the most at a time, from 1 to SIGNALS_WORKERS */
    double limit_seconds;  /* for a task, wall-clock time; 0: none */
    uint64_t limit_memory; /* bytes of address space for a worker, beyond what it has at its start; 0: none */
    void *context;         /* for these functions: */
    void (*begin)(void *); /* in a worker, before its first task */
    /* In a worker: does a task. Returns `*size` bytes that malloc() has allocated; NULL: no memory. */
    char *(*work)(void *, size_t task, size_t *size);
    /* Called in this process, one at a time, as tasks end. False: a fresh worker shall repeat the task, which is
     * possible only if this one was not fresh. */
    bool (*finish)(void *, const worker_outcome *outcome);
} worker_plan;

/* Does all tasks. A worker that dies harms only its own task. Returns when the last worker has ended. Call this before
 * any other thread is started: workers are forked. */
void workers_run(const worker_plan *plan);

#endif
