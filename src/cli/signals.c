/* signals.c - signals, and worker processes.
 *
 * Handlers read only data that are written atomically: a pointer to a constant, numbers that fit a sig_atomic_t, and a
 * name while its `unfinished` is set. They call only unlink(), kill(), waitpid(), signal(), raise(), write() and
 * alarm(), which are async-signal-safe. */
/* for MAP_ANONYMOUS */
#define _DEFAULT_SOURCE /* NOLINT(bugprone-reserved-identifier): that is its name */
#include "cli/signals.h"

#include <errno.h>
#include <signal.h>
#include <stdbool.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

/* ---- interruption ---- */

/* The unfinished file of a process. */
typedef struct slot {
    char name[4096 + 64]; /* PATH_MAX; longer ones cannot be opened */
    volatile sig_atomic_t unfinished;
} slot;

static slot alone, *own = &alone;
static slot *workers; /* [SIGNALS_WORKERS], in memory that they share with this process, or NULL */
static volatile sig_atomic_t worker_process[SIGNALS_WORKERS]; /* 0: there is none */

static const int ending[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};

static void remove_unfinished(slot *of)
{
    if (of->unfinished)
        unlink(of->name);
    of->unfinished = 0;
}

static void on_signal(int number)
{
    for (int i = 0; i < SIGNALS_WORKERS; i++)
        if (worker_process[i]) {
            signals_kill(i);
            (void)signals_reap(i);
        }
    remove_unfinished(own);
    signal(number, SIG_DFL);
    raise(number); /* arrives when the handler has returned */
}

void signals_prepare(void)
{
    struct sigaction action = {.sa_handler = on_signal}, old;
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof ending / sizeof ending[0]; i++)
        sigaddset(&action.sa_mask, ending[i]); /* one handler at a time */
    for (size_t i = 0; i < sizeof ending / sizeof ending[0]; i++)
        if (sigaction(ending[i], NULL, &old) == 0 && old.sa_handler != SIG_IGN) /* nohup stays nohup */
            sigaction(ending[i], &action, NULL);
#ifdef SIGXFSZ
    signal(SIGXFSZ, SIG_IGN);
#endif
}

void signals_temporary(void *context, const char *path)
{
    (void)context;
    own->unfinished = 0;
    if (path && strlen(path) < sizeof own->name) {
        strcpy(own->name, path);
        own->unfinished = 1;
    }
}

/* ---- workers ---- */

/* The first thing that a worker does. */
static void become(int number, pid_t parent)
{
    own = &workers[number];
    own->unfinished = 0;
    for (int i = 0; i < SIGNALS_WORKERS; i++)
        worker_process[i] = 0;
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
    if (getppid() != parent)
        _exit(1); /* it ended before it could be watched */
}

pid_t signals_fork(int number)
{
    const pid_t parent = getpid();
    sigset_t set, before;
    if (!workers) {
        void *shared =
            mmap(NULL, SIGNALS_WORKERS * sizeof *workers, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (shared == MAP_FAILED)
            return -1;
        workers = shared;
    }
    /* so no signal finds a worker with its parent's data, or a parent that does not know its worker yet */
    sigemptyset(&set);
    for (size_t i = 0; i < sizeof ending / sizeof ending[0]; i++)
        sigaddset(&set, ending[i]);
    sigprocmask(SIG_BLOCK, &set, &before);
    pid_t process = fork();
    if (process == 0)
        become(number, parent);
    else if (process > 0)
        worker_process[number] = (sig_atomic_t)process;
    const int reason = errno;
    sigprocmask(SIG_SETMASK, &before, NULL);
    errno = reason;
    return process;
}

void signals_kill(int number)
{
    if (worker_process[number])
        kill((pid_t)worker_process[number], SIGKILL);
}

int signals_reap(int number)
{
    int status = 0;
    while (waitpid((pid_t)worker_process[number], &status, 0) < 0 && errno == EINTR)
        ;
    worker_process[number] = 0;
    remove_unfinished(&workers[number]);
    return status;
}

/* ---- progress: a signal each second prints it, so the work need not; a short run prints nothing ---- */

enum { LINE = 72 };

static const char *volatile stage = "starting";
static volatile sig_atomic_t seconds, counted, count_of, hidden, shown;
static bool begun;

static size_t put_text(char *line, size_t used, const char *text)
{
    while (*text && used < LINE)
        line[used++] = *text++;
    return used;
}

static size_t put_number(char *line, size_t used, int number)
{
    char digits[12];
    size_t at = sizeof digits;
    digits[--at] = '\0';
    do
        digits[--at] = (char)('0' + number % 10);
    while ((number /= 10) > 0);
    return put_text(line, used, digits + at);
}

/* Every line is padded to the same length, so that it covers a longer one before it. */
static void write_line(const char *text, size_t used)
{
    char line[LINE + 2];
    memset(line, ' ', sizeof line);
    line[0] = '\r';
    memcpy(line + 1, text, used);
    line[LINE + 1] = '\r';
    ssize_t written = write(STDERR_FILENO, line, sizeof line);
    (void)written; /* nothing is lost with it */
}

static void on_alarm(int number)
{
    int kept = errno;
    char line[LINE];
    (void)number;
    seconds++;
    alarm(1);
    if (!hidden) {
        size_t used = put_text(line, 0, "roberts: ");
        if (count_of > 0) {
            used = put_number(line, used, (int)counted);
            used = put_text(line, used, " of ");
            used = put_number(line, used, (int)count_of);
            used = put_text(line, used, " drawn");
        } else {
            used = put_text(line, used, stage);
        }
        used = put_text(line, used, ", ");
        used = put_number(line, used, (int)seconds);
        used = put_text(line, used, " s");
        shown = 1;
        write_line(line, used);
    }
    errno = kept;
}

void progress_begin(void)
{
    struct sigaction action = {.sa_handler = on_alarm, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    begun = sigaction(SIGALRM, &action, NULL) == 0;
    if (begun)
        alarm(1);
}

void progress_stage(const char *name)
{
    stage = name;
}

void progress_count(size_t done, size_t total)
{
    counted = (sig_atomic_t)done;
    count_of = (sig_atomic_t)total;
}

void progress_hide(void)
{
    hidden = 1;
    if (begun && shown)
        write_line("", 0);
    shown = 0;
}

void progress_show(void)
{
    hidden = 0;
}
