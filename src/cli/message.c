/* message.c - the program's messages on standard error. */
#include "cli/message.h"

#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "cli/signals.h"

enum { MISUSE_SIZE = 8192 }; /* two file names, and the fault */

/* Writes a text that may have file names in it. */
static void put_plain(FILE *log, const char *text)
{
    for (; *text; text++)
        if (message_is_control(*text))
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

/* Length of the character of two bytes or more that `text` begins with, 0 where it is none. UTF-8 is checked after RFC
 * 3629: no surrogates, nothing beyond U+10FFFF, no longer than needed. */
static size_t character_length(const unsigned char *text)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    size_t length = text[0] < 0xc0 ? 0 : text[0] < 0xe0 ? 2 : text[0] < 0xf0 ? 3 : text[0] < 0xf8 ? 4 : 0;
    uint32_t code = length ? text[0] & (0x7fu >> length) : 0;
    for (size_t i = 1; i < length; i++) {
        if ((text[i] & 0xc0) != 0x80) /* the end of the text as well */
            return 0;
        code = code << 6 | (text[i] & 0x3f);
    }
    return code < least[length] || (code >= 0xd800 && code < 0xe000) || code > 0x10ffff ? 0 : length;
}

void message_json(FILE *file, const char *text)
{
    if (!text) {
        fputs("null", file);
        return;
    }
    fputc('"', file);
    for (const unsigned char *at = (const unsigned char *)text; *at;) {
        size_t length = *at < 0x80 ? 1 : character_length(at);
        if (*at == '"' || *at == '\\')
            fprintf(file, "\\%c", *at);
        else if (*at < 0x20)
            fprintf(file, "\\u%04x", *at);
        else if (length)
            fwrite(at, 1, length, file);
        else
            fputs("\\ufffd", file);
        at += length ? length : 1;
    }
    fputc('"', file);
}
