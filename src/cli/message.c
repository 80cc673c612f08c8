/* message.c - what the program says on standard error. */
#include "cli/message.h"

#include <stdarg.h>
#include <stdio.h>

#include "cli/signals.h"

enum { MISUSE_SIZE = 8192 }; /* two names of files and what is wrong with them */

/* Names of files may hold control characters; a terminal must not obey them. */
static void put_plain(FILE *log, const char *text)
{
    for (; *text; text++)
        if ((unsigned char)*text < 0x20 || *text == 0x7f)
            fprintf(log, "\\x%02x", (unsigned)(unsigned char)*text);
        else
            fputc(*text, log);
}

int message_misuse(const char *format, ...)
{
    char text[MISUSE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    fputs("roberts: ", stderr);
    put_plain(stderr, text);
    fputs("\nroberts --help lists the options.\n", stderr);
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
    fputs("roberts: ", log);
    put_plain(log, label ? label : "");
    fputs(label ? ": " : "", log);
}

static void say_where(FILE *log, const char *file, size_t line)
{
    fputs("roberts: ", log);
    put_plain(log, file);
    if (file[0] && line)
        fprintf(log, ":%zu: ", line);
    else if (file[0])
        fputs(": ", log);
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
