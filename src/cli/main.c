/* main.c - the program: reads the options, calls the library, writes. A client of roberts.h like any other. */
/* for MADV_HUGEPAGE */
#define _DEFAULT_SOURCE /* NOLINT(bugprone-reserved-identifier): that is its name */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#include <stdlib.h>
#include <sys/mman.h>
#endif

#include "cli/batch.h"
#include "cli/help.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/parts.h"
#include "cli/picture.h"
#include "cli/signals.h"

/* The exit status, once everything for standard output is written. */
static int finish_output(void)
{
    if (fflush(stdout) == 0 && !ferror(stdout))
        return EXIT_DONE;
    fprintf(stderr, "roberts: standard output: cannot write: %s\n", strerror(errno));
    return EXIT_FAILED;
}

/* A progress line is for a person who is watching. It must not appear between the lines of a drawing. */
static bool is_watched(const cli_options *options)
{
    bool to_terminal = !options->batch && strcmp(options->output, "-") == 0 && isatty(STDOUT_FILENO);
    return isatty(STDERR_FILENO) && !options->quiet && !to_terminal;
}

/* If a standard stream is closed, the next file opened would get its number, and messages would go into that file. So
 * /dev/null takes the number. It is opened so that reading or writing fails, as with the closed stream. */
static void hold_streams(void)
{
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; stream++)
        if (fcntl(stream, F_GETFD) == -1 && errno == EBADF)
            (void)open("/dev/null", stream == STDOUT_FILENO ? O_RDONLY : O_WRONLY); /* gets the least free number */
}

/* Large arrays of the library lie in large pages of memory (base/array.c). This gives smaller ones such pages to share:
 * a heap of HEAP bytes, which cost nothing until they are written. Arrays beyond ARRAY bytes stay outside, so that they
 * can grow without being copied. The heap itself must not lie outside: then free() would give it back. */
static void prepare_heap(void)
{
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
    enum { HEAP = 47 << 20, ARRAY = 4 << 20, MOST_OUTSIDE = 65536 };
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, HEAP + (1 << 20));
    char *heap = malloc(HEAP);
    if (heap)
        madvise(heap - (size_t)heap % (size_t)sysconf(_SC_PAGESIZE), HEAP, MADV_HUGEPAGE);
    free(heap);
    mallopt(M_MMAP_MAX, MOST_OUTSIDE);
    mallopt(M_MMAP_THRESHOLD, ARRAY);
#endif
}

int main(int argc, char **argv)
{
    cli_options options;
    picture_result result;
    hold_streams();
    signals_prepare();
    int status = options_parse(&option_table_all, argc, argv, &options);
    if (status != EXIT_DONE)
        return status;
    if (options.help)
        help_print(stdout, &option_table_all);
    else if (options.version)
        puts("roberts " ROBERTS_VERSION);
    if (options.help || options.version)
        return finish_output();
    if (!(options.limit_memory > 0.0)) /* it counts the heap too */
        prepare_heap();
    options.scene.warnings.warn = options.quiet ? NULL : message_warning;
    options.scene.warnings.context = options.log = stderr;
    options.draw.temporary = signals_temporary;
    if (is_watched(&options))
        progress_begin();
    if (options.plan || options.part.of)
        status = part_make(&options);
    else
        status = options.batch ? batch_make(&options) : picture_make(&options, &result);
    progress_hide();
    if (status == EXIT_DONE && (options.stats || options.verify || options.pick_count > 0) && ferror(stderr))
        return EXIT_FAILED; /* what was asked for could not be written */
    return status;
}
