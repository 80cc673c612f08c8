/* signals.c - in place of cli/signals.c: nothing interrupts a run, and nobody watches its progress. */
#include "cli/signals.h"

void signals_prepare(void)
{
}

void signals_temporary(void *context, const char *path)
{
    (void)context;
    (void)path;
}

void progress_begin(void)
{
}

void progress_stage(const char *name)
{
    (void)name;
}

void progress_count(size_t done, size_t total)
{
    (void)done;
    (void)total;
}

void progress_hide(void)
{
}

void progress_show(void)
{
}
