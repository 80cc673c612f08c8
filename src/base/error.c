/* error.c - fills a roberts_error; sends warnings; says the version. */
#include "base/error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *roberts_version(void)
{
    return ROBERTS_VERSION;
}

roberts_status error_set(roberts_error *error, roberts_status status, size_t line, const char *format, ...)
{
    if (error) {
        va_list arguments;
        error->status = status;
        error->file[0] = '\0';
        error->line = line;
        va_start(arguments, format);
        vsnprintf(error->message, sizeof error->message, format, arguments);
        va_end(arguments);
    }
    return status;
}

void error_set_file(roberts_error *error, const char *file)
{
    if (!error)
        return;
    size_t length = strlen(file);
    if (length < sizeof error->file)
        memcpy(error->file, file, length + 1);
    else
        snprintf(error->file, sizeof error->file, "...%s", file + length - (sizeof error->file - 4));
}

roberts_status error_in(roberts_error *error, const char *file, roberts_status status)
{
    error_set_file(error, file);
    return status;
}

roberts_status error_no_memory(roberts_error *error)
{
    return error_set(error, ROBERTS_NO_MEMORY, 0, "not enough memory");
}

void warning_send(const roberts_warnings *warnings, const char *file, size_t line, const char *format, ...)
{
    char message[256];
    va_list arguments;
    if (!warnings || !warnings->warn)
        return;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    warnings->warn(warnings->context, file, line, message);
}
