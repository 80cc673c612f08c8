/* workers.c - processes that do numbered tasks, several at a time.
 *
 * Each worker has a socket, on which it gets the number of a task and returns a report. When the socket closes, the
 * worker has ended, for whatever reason. If a worker sees it close, there is no more to do, or the parent has ended. */
#include "cli/workers.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "cli/signals.h"

typedef struct worker {
    int socket; /* -1: there is no worker */
    bool busy, fresh;
    size_t task;
    double begun;
    size_t told; /* bytes received of the report and of its size */
    size_t size;
    char *report;
} worker;

typedef struct crew {
    const worker_plan *plan;
    worker member[SIGNALS_WORKERS];
    size_t next, done; /* tasks handed out; tasks ended */
} crew;

static double now(void)
{
    struct timespec time = {0};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* ---- in a worker ---- */

static bool send_all(int to, const void *bytes, size_t size)
{
    for (const char *at = bytes; size > 0;) {
        const ssize_t sent = send(to, at, size, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent < 0)
            return false;
        at += sent;
        size -= (size_t)sent;
    }
    return true;
}

static bool receive_task(int from, size_t *task)
{
    ssize_t got;
    do
        got = recv(from, task, sizeof *task, MSG_WAITALL);
    while (got < 0 && errno == EINTR);
    return got == (ssize_t)sizeof *task;
}

/* Bytes of address space that this process has; 0: unknown. */
static uint64_t address_space(void)
{
    unsigned long pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (file && fscanf(file, "%lu", &pages) != 1) /* NOLINT(cert-err34-c): a number of the kernel's */
        pages = 0;
    if (file)
        fclose(file);
    return (uint64_t)pages * (uint64_t)sysconf(_SC_PAGESIZE);
}

static void limit_memory(uint64_t bytes)
{
    struct rlimit limit;
    const uint64_t all = address_space() + bytes;
    if (bytes == 0 || getrlimit(RLIMIT_AS, &limit) != 0 || (limit.rlim_max != RLIM_INFINITY && limit.rlim_max <= all))
        return;
    limit.rlim_cur = (rlim_t)all;
    (void)setrlimit(RLIMIT_AS, &limit);
}

static void serve(const worker_plan *plan, int socket)
{
    size_t task, size = 0;
    plan->begin(plan->context);
    limit_memory(plan->limit_memory);
    while (receive_task(socket, &task)) {
        char *report = plan->work(plan->context, task, &size);
        if (!report)
            size = 0;
        if (!send_all(socket, &size, sizeof size) || !send_all(socket, report, size))
            return;
        free(report);
    }
}

/* ---- in the process that hands out tasks ---- */

/* Starts a worker. False: errno says why not. */
static bool start(crew *c, int number)
{
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0)
        return false;
    fflush(NULL); /* the worker must not write data that wait in the parent's buffers */
    const pid_t process = signals_fork(number);
    if (process == 0) {
        for (int i = 0; i < SIGNALS_WORKERS; i++)
            if (c->member[i].socket >= 0)
                close(c->member[i].socket); /* otherwise workers would not end with that process */
        close(ends[0]);
        serve(c->plan, ends[1]);
        exit(0);
    }
    const int reason = errno;
    close(ends[1]);
    if (process < 0)
        close(ends[0]);
    else
        c->member[number] = (worker){.socket = ends[0], .fresh = true};
    errno = reason;
    return process > 0;
}

/* Lets a worker end, or waits until it has ended. Returns its status. */
static int dismiss(worker *w, int number)
{
    close(w->socket);
    free(w->report);
    *w = (worker){.socket = -1};
    return signals_reap(number);
}

/* If the worker has died meanwhile, its socket is closed. */
static void hand_out(worker *w, size_t task)
{
    w->busy = true;
    w->task = task;
    w->begun = now();
    w->told = 0;
    (void)send_all(w->socket, &task, sizeof task);
}

static void tell_outcome(crew *c, const worker_outcome *outcome)
{
    (void)c->plan->finish(c->plan->context, outcome);
    c->done++;
}

static void hand_out_next(crew *c, int number)
{
    worker *w = &c->member[number];
    if (w->socket >= 0 || start(c, number))
        hand_out(w, c->next++);
}

/* The task of a worker has ended. A worker that has died, or is no longer wanted, makes room for another. */
static void end_task(crew *c, int number, worker_outcome *outcome)
{
    worker *w = &c->member[number];
    char *report = w->report;
    outcome->task = w->task;
    outcome->fresh = w->fresh;
    outcome->seconds = now() - w->begun;
    w->report = NULL;
    w->busy = w->fresh = false;
    if (outcome->end != WORKER_REPORTED)
        outcome->status = dismiss(w, number);
    if (c->plan->finish(c->plan->context, outcome) || outcome->fresh) {
        c->done++;
    } else {
        if (w->socket >= 0)
            dismiss(w, number);
        if (start(c, number))
            hand_out(w, outcome->task);
        else
            tell_outcome(
                c, &(worker_outcome){.task = outcome->task, .end = WORKER_UNSTARTED, .status = errno, .fresh = true});
    }
    free(report);
}

/* Receives available bytes of a report. Returns false if the worker has ended. */
static bool take_report(worker *w)
{
    const size_t head = sizeof w->size;
    ssize_t got;
    if (w->told < head)
        got = recv(w->socket, (char *)&w->size + w->told, head - w->told, 0);
    else
        got = recv(w->socket, w->report + (w->told - head), w->size - (w->told - head), 0);
    if (got <= 0)
        return got < 0 && errno == EINTR;
    w->told += (size_t)got;
    return true;
}

static void receive(crew *c, int number)
{
    worker *w = &c->member[number];
    const size_t head = sizeof w->size;
    if (!take_report(w)) {
        end_task(c, number, &(worker_outcome){.end = WORKER_DIED});
        return;
    }
    if (w->told == head && w->size > 0 && !w->report && !(w->report = malloc(w->size))) {
        signals_kill(number);
        end_task(c, number, &(worker_outcome){.end = WORKER_UNHEARD});
    } else if (w->told >= head && w->told - head == w->size) {
        end_task(c, number, &(worker_outcome){.end = WORKER_REPORTED, .report = w->report, .size = w->size});
    }
}

/* Milliseconds until the first task is late; -1: never. */
static int time_left(const crew *c)
{
    double least = HUGE_VAL;
    for (int i = 0; i < c->plan->workers; i++)
        if (c->member[i].busy)
            least = fmin(least, c->member[i].begun + c->plan->limit_seconds - now());
    if (c->plan->limit_seconds == 0.0)
        return -1;
    return (int)ceil(fmin(fmax(1000.0 * least, 0.0), INT_MAX));
}

/* Waits for reports, for ends, and until a task is late. poll() accepts no more descriptors than the limit on open
 * files, so it gets only the busy workers. */
static void wait_for_some(crew *c)
{
    struct pollfd from[SIGNALS_WORKERS];
    int number[SIGNALS_WORKERS], count = 0;
    const double limit = c->plan->limit_seconds;
    for (int i = 0; i < c->plan->workers; i++)
        if (c->member[i].busy) {
            from[count] = (struct pollfd){.fd = c->member[i].socket, .events = POLLIN};
            number[count++] = i;
        }
    const bool any = poll(from, (nfds_t)count, time_left(c)) > 0;
    for (int k = 0; k < count; k++) {
        if (any && from[k].revents) {
            receive(c, number[k]);
        } else if (limit > 0.0 && now() - c->member[number[k]].begun >= limit) {
            signals_kill(number[k]);
            end_task(c, number[k], &(worker_outcome){.end = WORKER_LATE});
        }
    }
}

void workers_run(const worker_plan *plan)
{
    crew c = {.plan = plan};
    for (int i = 0; i < SIGNALS_WORKERS; i++)
        c.member[i].socket = -1;
    while (c.done < plan->tasks) {
        bool any = false;
        int reason = 0;
        for (int i = 0; i < plan->workers; i++) {
            if (!c.member[i].busy && c.next < plan->tasks)
                hand_out_next(&c, i);
            if (!c.member[i].busy)
                reason = errno;
            any = any || c.member[i].busy;
        }
        if (any)
            wait_for_some(&c);
        else if (c.next < plan->tasks)
            tell_outcome(&c,
                         &(worker_outcome){.task = c.next++, .end = WORKER_UNSTARTED, .status = reason, .fresh = true});
    }
    for (int i = 0; i < plan->workers; i++)
        if (c.member[i].socket >= 0)
            dismiss(&c.member[i], i);
}
