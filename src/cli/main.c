/* main.c - the program: reads the options, calls the library, writes. A client of roberts.h like any other. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "cli/batch.h"
#include "cli/help.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/picture.h"
#include "cli/progress.h"

static int print(const char *text)
{
    if (fputs(text, stdout) >= 0 && fflush(stdout) == 0)
        return EXIT_DONE;
    fprintf(stderr, "roberts: standard output: cannot write: %s\n", strerror(errno));
    return EXIT_FAILED;
}

static int print_help(void)
{
    int status = EXIT_DONE;
    for (size_t i = 0; help_text[i] && status == EXIT_DONE; i++)
        status = print(help_text[i]);
    return status;
}

/* A line of progress is for a person who looks on, and must not come between the lines of a drawing. */
static bool is_watched(const cli_options *options)
{
    bool to_terminal = !options->batch && strcmp(options->output, "-") == 0 && isatty(STDOUT_FILENO);
    return isatty(STDERR_FILENO) && !options->quiet && !to_terminal;
}

/* A file must not take the place of a stream that is closed: messages would come into it. What takes that place fails to read
 * or to write as a closed stream does; messages are lost. */
static void hold_streams(void)
{
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; stream++)
        if (fcntl(stream, F_GETFD) == -1 && errno == EBADF)
            (void)open("/dev/null", stream == STDOUT_FILENO ? O_RDONLY : O_WRONLY); /* the least number that is free */
}

int main(int argc, char **argv)
{
    cli_options options;
    hold_streams();
    interrupt_prepare();
    int status = options_parse(argc, argv, &options);
    if (status != EXIT_DONE)
        return status;
    if (options.help)
        return print_help();
    if (options.version)
        return print("roberts " ROBERTS_VERSION "\n");
    options.scene.warnings.warn = options.quiet ? NULL : message_warning;
    options.scene.warnings.context = options.log = stderr;
    options.draw.temporary = interrupt_temporary;
    options.draw.temporary_context = interrupt_slot(0);
    if (is_watched(&options))
        progress_begin();
    status = options.batch ? batch_make(&options) : picture_make(&options);
    progress_hide();
    return status;
}
