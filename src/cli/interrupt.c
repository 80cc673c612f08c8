/* interrupt.c - what becomes of unfinished files when the program is interrupted.
 *
 * The handler only reads names and calls unlink(), signal() and raise(), which are async-signal-safe. A name is whole
 * whenever its `unfinished` says so. Each thread that writes has a slot of its own. */
#include "cli/interrupt.h"

#include <signal.h>
#include <string.h>
#include <unistd.h>

static struct slot {
    char name[4096 + 64]; /* PATH_MAX; longer ones cannot be opened */
    volatile sig_atomic_t unfinished;
} slots[INTERRUPT_SLOTS];

static void on_signal(int number)
{
    for (int i = 0; i < INTERRUPT_SLOTS; i++)
        if (slots[i].unfinished)
            unlink(slots[i].name);
    signal(number, SIG_DFL);
    raise(number); /* comes when the handler has returned */
}

void interrupt_prepare(void)
{
    static const int ending[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
    struct sigaction action = {.sa_handler = on_signal}, old;
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof ending / sizeof ending[0]; i++)
        if (sigaction(ending[i], NULL, &old) == 0 && old.sa_handler != SIG_IGN) /* nohup stays nohup */
            sigaction(ending[i], &action, NULL);
#ifdef SIGXFSZ
    signal(SIGXFSZ, SIG_IGN);
#endif
}

void *interrupt_slot(int number)
{
    return &slots[number];
}

void interrupt_temporary(void *context, const char *path)
{
    struct slot *slot = context;
    slot->unfinished = 0;
    if (path && strlen(path) < sizeof slot->name) {
        strcpy(slot->name, path);
        slot->unfinished = 1;
    }
}
