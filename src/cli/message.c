/* message.c - what the program says on standard error. */
#include "cli/message.h"

#include <stdarg.h>
#include <stdio.h>

#include "cli/progress.h"

int message_misuse(const char *format, ...)
{
    va_list arguments;
    fputs("roberts: ", stderr);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputs("\nroberts --help tells how it is used.\n", stderr);
    return EXIT_MISUSED;
}

void message_open(FILE *log)
{
    if (log == stderr)
        progress_hide();
}

void message_close(FILE *log)
{
    if (log == stderr)
        progress_show();
}

void message_begin(FILE *log, const char *label)
{
    fprintf(log, "roberts: %s%s", label ? label : "", label ? ": " : "");
}

static void say_where(FILE *log, const char *file, size_t line)
{
    fputs("roberts: ", log);
    if (file[0] && line)
        fprintf(log, "%s:%zu: ", file, line);
    else if (file[0])
        fprintf(log, "%s: ", file);
}

int message_error(FILE *log, const roberts_error *error)
{
    message_open(log);
    say_where(log, error->file, error->line);
    fprintf(log, "%s\n", error->message);
    message_close(log);
    return error->status == ROBERTS_BAD_ARGUMENT ? EXIT_MISUSED : EXIT_FAILED;
}

void message_warning(void *context, const char *file, size_t line, const char *text)
{
    FILE *log = context;
    message_open(log);
    say_where(log, file, line);
    fprintf(log, "warning: %s\n", text);
    message_close(log);
}
