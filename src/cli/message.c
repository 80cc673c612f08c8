/* message.c - what the program says on standard error. */
#include "cli/message.h"

#include <stdarg.h>
#include <stdio.h>

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

static void say_where(const char *file, size_t line)
{
    fputs("roberts: ", stderr);
    if (file[0] && line)
        fprintf(stderr, "%s:%zu: ", file, line);
    else if (file[0])
        fprintf(stderr, "%s: ", file);
}

int message_error(const roberts_error *error)
{
    say_where(error->file, error->line);
    fprintf(stderr, "%s\n", error->message);
    return error->status == ROBERTS_BAD_ARGUMENT ? EXIT_MISUSED : EXIT_FAILED;
}

void message_warning(void *context, const char *file, size_t line, const char *text)
{
    (void)context;
    say_where(file, line);
    fprintf(stderr, "warning: %s\n", text);
}
