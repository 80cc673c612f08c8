/* batch.c - one picture for each file, drawn by worker processes.
 *
 * Names are first checked for all files (batch_files.c), so runs with different --shard options agree. This process
 * hands out the files, prints the messages about them in order, and writes the manifest. A file that kills its worker,
 * or takes too long, is just one failed file. */
#include "cli/batch.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/batch_files.h"
#include "cli/manifest.h"
#include "cli/message.h"
#include "cli/picture.h"
#include "cli/report.h"
#include "cli/signals.h"
#include "cli/workers.h"

typedef struct batch {
    const cli_options *options;
    batch_files files;
    size_t done, printed; /* printed: the texts of the files before this one */
    size_t failed;
    manifest manifest; /* its descriptor is -1: there is none */
    uint32_t threads;  /* of a worker */
    int result;
} batch;

/* ---- before the first file is drawn ---- */

static int make_folder(const char *name)
{
    if (mkdir(name, 0777) == 0 || errno == EEXIST)
        return EXIT_DONE;
    const char *reason = strerror(errno);
    message_begin(stderr, name);
    fprintf(stderr, "cannot make the folder: %s\n", reason);
    return EXIT_FAILED;
}

static int open_manifest(batch *b)
{
    roberts_error error;
    if (!b->options->manifest || manifest_open(&b->manifest, b->options->manifest, &error) == ROBERTS_OK)
        return EXIT_DONE;
    return message_error(stderr, &error);
}

static int prepare_batch(batch *b)
{
    const cli_options *options = b->options;
    const bool draws = options->draw.format != ROBERTS_NULL;
    int result = batch_files_name(&b->files, options);
    if (result == EXIT_DONE && draws)
        result = batch_files_check_places(&b->files);
    if (result == EXIT_DONE)
        result = make_folder(options->batch);
    if (result == EXIT_DONE)
        result = open_manifest(b);
    if (result == EXIT_DONE && draws && options->manifest)
        result = batch_files_check_places(&b->files); /* set now that there is a manifest, even a new one */
    if (result == EXIT_DONE && options->shard.of > 0)
        batch_files_take_shard(&b->files);
    if (result == EXIT_DONE && options->update)
        result = batch_files_drop_current(&b->files, options->manifest ? &b->manifest : NULL);
    return result;
}

/* ---- in a worker ---- */

/* The report of a worker: this, after the text of the messages. */
typedef struct file_report {
    int result;
    roberts_status status;
    double seconds;
    size_t lines, warnings;
    char error[600]; /* empty: none */
} file_report;

/* Where the warnings of a file go. */
typedef struct warning_counter {
    FILE *log;
    const char *file; /* that is drawn */
    size_t count;
} warning_counter;

static void count_warning(void *context, const char *file, size_t line, const char *text)
{
    warning_counter *counter = context;
    counter->count++;
    message_warning(counter->log, *file ? file : counter->file, line, text);
}

static void begin(void *context)
{
    batch *b = context;
    if (b->manifest.descriptor >= 0)
        manifest_close(&b->manifest);
}

static void describe_result(const picture_result *made, char *text, size_t size)
{
    const roberts_error *error = &made->error;
    if (error->status == ROBERTS_OK && made->contradictions > 0)
        snprintf(text, size, "--verify has found %zu contradiction%s", made->contradictions,
                 made->contradictions == 1 ? "" : "s");
    else if (error->file[0] && error->line)
        snprintf(text, size, "%s:%zu: %s", error->file, error->line, error->message);
    else
        snprintf(text, size, "%s%s%s", error->file, error->file[0] ? ": " : "", error->message);
}

/* Draws one file. Messages go to `log`. */
static file_report make_one(const batch *b, const batch_file *file, FILE *log)
{
    cli_options own = *b->options;
    char *input = file->input;
    warning_counter counter = {.log = log, .file = file->input};
    picture_result made;
    const roberts_time start = report_now();
    own.input = &input;
    own.input_count = 1;
    own.output = file->output;
    own.label = file->input;
    (void)batch_files_command(&b->files, file, &own.description);
    own.hide.threads = b->threads;
    own.log = log;
    own.scene.warnings.warn = own.quiet ? NULL : count_warning;
    own.scene.warnings.context = &counter;
    if (own.root && own.draw.format != ROBERTS_NULL)
        batch_files_make_folders(&b->files, file);
    file_report report = {.result = picture_make(&own, &made)};
    report.status = made.error.status;
    report.seconds = report_since(start).wall;
    report.lines = made.segments;
    report.warnings = counter.count;
    describe_result(&made, report.error, sizeof report.error);
    return report;
}

static char *work(void *context, size_t task, size_t *size)
{
    const batch *b = context;
    char *text = NULL;
    FILE *log = open_memstream(&text, size);
    if (!log)
        return NULL;
    const file_report report = make_one(b, &b->files.file[task], log);
    const bool whole = fwrite(&report, sizeof report, 1, log) == 1;
    if (fclose(log) == 0 && whole)
        return text;
    free(text);
    return NULL;
}

/* ---- as files are done ---- */

/* Reports why a file was not drawn, if no worker could report it. */
static void explain(const batch *b, const worker_outcome *outcome, char *text, size_t size)
{
    const int status = outcome->status;
    if (outcome->end == WORKER_LATE)
        snprintf(text, size, "it takes more than %.10g s: --limit-seconds", b->options->limit_seconds);
    else if (outcome->end == WORKER_UNSTARTED)
        snprintf(text, size, "cannot start a process: %s", strerror(status));
    else if (outcome->end != WORKER_DIED)
        snprintf(text, size, "not enough memory");
    else if (WIFSIGNALED(status))
        snprintf(text, size, "the process that draws it was ended by signal %d (%s)", WTERMSIG(status),
                 strsignal(WTERMSIG(status)));
    else
        snprintf(text, size, "the process that draws it has ended with status %d", WEXITSTATUS(status));
}

/* Returns the report of a worker, or a report in its place. The text of the messages is stored with the file. */
static file_report take_report(const batch *b, const worker_outcome *outcome, batch_file *file)
{
    file_report report = {.result = EXIT_FAILED, .status = ROBERTS_NO_MEMORY, .seconds = outcome->seconds};
    size_t size;
    if (outcome->report && outcome->size >= sizeof report) {
        const size_t length = outcome->size - sizeof report;
        memcpy(&report, outcome->report + length, sizeof report);
        file->text = malloc(length + 1);
        if (file->text) {
            memcpy(file->text, outcome->report, length);
            file->text[length] = '\0';
        }
        return report;
    }
    explain(b, outcome, report.error, sizeof report.error);
    FILE *log = open_memstream(&file->text, &size);
    if (!log)
        return report;
    message_begin(log, file->input);
    fprintf(log, "%s\n", report.error);
    if (fclose(log) != 0) {
        free(file->text);
        file->text = NULL;
    }
    return report;
}

/* If the manifest cannot be written, the drawings are made all the same. */
static void add_row(batch *b, const batch_file *file, const file_report *report)
{
    roberts_error error;
    description command;
    const bool draws = b->options->draw.format != ROBERTS_NULL;
    const manifest_row row = {.file = file->input,
                              .output = draws ? file->output : NULL,
                              .command = batch_files_command(&b->files, file, &command),
                              .error = report->result == EXIT_DONE ? NULL : report->error,
                              .seconds = report->seconds,
                              .lines = report->lines,
                              .warnings = report->warnings};
    if (b->manifest.descriptor < 0 || manifest_add(&b->manifest, &row, &error) == ROBERTS_OK)
        return;
    b->result = EXIT_FAILED;
    manifest_close(&b->manifest);
    (void)message_error(stderr, &error);
}

/* Prints the texts whose turn it is. */
static void print_texts(batch *b)
{
    for (; b->printed < b->files.count && b->files.file[b->printed].done; b->printed++) {
        batch_file *file = &b->files.file[b->printed];
        if (!file->text || *file->text) {
            progress_hide();
            if (!file->text)
                message_begin(stderr, file->input);
            fputs(file->text ? file->text : "not enough memory\n", stderr);
            progress_show();
        }
        free(file->text);
        file->text = NULL;
    }
}

/* Success must not depend on the files that a worker drew before: they may have used up or spoiled its memory. So if
 * memory was short, or the worker has died, a fresh one tries again. */
static bool finish(void *context, const worker_outcome *outcome)
{
    batch *b = context;
    batch_file *file = &b->files.file[outcome->task];
    const file_report report = take_report(b, outcome, file);
    if (!outcome->fresh && outcome->end != WORKER_LATE && report.status == ROBERTS_NO_MEMORY) {
        free(file->text);
        file->text = NULL;
        return false;
    }
    add_row(b, file, &report);
    b->failed += report.result != EXIT_DONE;
    file->done = true;
    progress_count(++b->done, b->files.count);
    print_texts(b);
    return true;
}

/* Files are drawn by one thread each, unless there are fewer files than processors. Each thread takes address space of
 * its own, so if that is limited, there is one thread. */
static void make_all(batch *b)
{
    const cli_options *options = b->options;
    uint32_t threads = options->hide.threads;
    size_t workers = threads > 0 ? threads : roberts_processor_count();
    workers = workers < SIGNALS_WORKERS ? workers : SIGNALS_WORKERS;
    workers = workers < b->files.count ? workers : b->files.count;
    if (workers == 0)
        return;
    const worker_plan plan = {.tasks = b->files.count,
                              .workers = (int)workers,
                              .limit_seconds = options->limit_seconds,
                              .limit_memory = (uint64_t)(options->limit_memory * 1e6),
                              .context = b,
                              .begin = begin,
                              .work = work,
                              .finish = finish};
    b->threads = options->limit_memory > 0.0 || threads < workers ? 1 : threads / (uint32_t)workers;
    progress_count(0, b->files.count);
    workers_run(&plan);
}

static void tell_batch(const batch *b, roberts_time start)
{
    message_open(stderr);
    fprintf(stderr, "roberts: %zu file%s drawn, %zu up to date, %zu failed; %.3f s\n", b->files.count - b->failed,
            b->files.count - b->failed == 1 ? "" : "s", b->files.current, b->failed, report_since(start).wall);
    message_close(stderr);
}

int batch_make(const cli_options *options)
{
    batch b = {.options = options, .manifest = {.descriptor = -1}};
    const roberts_time start = report_now();
    b.result = prepare_batch(&b);
    if (b.result == EXIT_DONE) {
        make_all(&b);
        if (options->verbose)
            tell_batch(&b, start);
        if (b.failed > 0)
            b.result = EXIT_FAILED;
    }
    if (b.manifest.descriptor >= 0)
        manifest_close(&b.manifest);
    batch_files_free(&b.files);
    return b.result;
}
