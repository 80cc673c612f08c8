/* interrupt.c - what becomes of an unfinished file when the program is interrupted.
 *
 * The handler only reads a name and calls unlink(), signal() and raise(), which are async-signal-safe. The name is
 * whole whenever `unfinished` says so. */
#include "cli/interrupt.h"

#include <signal.h>
#include <string.h>
#include <unistd.h>

static char name[4096 + 64]; /* PATH_MAX; longer ones cannot be opened */
static volatile sig_atomic_t unfinished;

static void on_signal(int number)
{
    if (unfinished)
        unlink(name);
    signal(number, SIG_DFL);
    raise(number); /* comes when the handler has returned */
}

void interrupt_prepare(void)
{
    static const int ending[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action = {.sa_handler = on_signal}, old;
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof ending / sizeof ending[0]; i++)
        if (sigaction(ending[i], NULL, &old) == 0 && old.sa_handler != SIG_IGN) /* nohup stays nohup */
            sigaction(ending[i], &action, NULL);
    signal(SIGPIPE, SIG_IGN);
#ifdef SIGXFSZ
    signal(SIGXFSZ, SIG_IGN);
#endif
}

void interrupt_temporary(void *context, const char *path)
{
    (void)context;
    unfinished = 0;
    if (path && strlen(path) < sizeof name) {
        strcpy(name, path);
        unfinished = 1;
    }
}
