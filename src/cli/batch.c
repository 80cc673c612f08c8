/* batch.c - one picture for each file, drawn by worker processes.
 *
 * What could go wrong with the names is found out first, for all files: so several runs with a --shard each agree. This
 * process hands out the files, prints what was said about them in their order, and writes the manifest. A file that
 * ends its worker, or takes too long, is one failed file. */
#include "cli/batch.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef _OPENMP
#include <omp.h>
#endif

#include "cli/list.h"
#include "cli/manifest.h"
#include "cli/message.h"
#include "cli/picture.h"
#include "cli/report.h"
#include "cli/signals.h"
#include "cli/values.h"
#include "cli/workers.h"

typedef struct batch_file {
    char *input;         /* of argv, or of the list */
    char *output, *text; /* owned; the text of its messages */
    bool done;
} batch_file;

typedef struct batch {
    const cli_options *options;
    file_list list;
    batch_file *file;
    size_t count, done, printed; /* printed: the texts of the files before this one are out */
    size_t current, failed;      /* up to date, and not drawn again; failed ones */
    manifest manifest;           /* its descriptor is -1: there is none */
    uint32_t threads;            /* of a worker */
    int result;
} batch;

/* DIR/name.svg for any/where/name.off; NULL: no memory. */
static char *output_name(const cli_options *options, const char *input)
{
    const char *slash = strrchr(input, '/'), *name = slash ? slash + 1 : input;
    const char *dot = strrchr(name, '.'), *ending = values_format_name(options->draw.format);
    size_t length = dot && dot > name ? (size_t)(dot - name) : strlen(name);
    size_t size = strlen(options->batch) + 1 + length + 1 + strlen(ending) + 1;
    char *output = malloc(size);
    if (output)
        snprintf(output, size, "%s/%.*s.%s", options->batch, (int)length, name, ending);
    return output;
}

static int by_output(const void *a, const void *b)
{
    const batch_file *const *f = a, *const *g = b;
    return strcmp((*f)->output, (*g)->output);
}

static int no_memory(void)
{
    fputs("roberts: not enough memory\n", stderr);
    return EXIT_FAILED;
}

/* No two files may be drawn to one name. */
static int check_names(const batch *b)
{
    int result = EXIT_DONE;
    /* an array of pointers: the check takes sizeof a pointer for a slip */
    batch_file **order = malloc(b->count * sizeof *order); /* NOLINT(bugprone-sizeof-expression) */
    if (!order)
        return no_memory();
    for (size_t i = 0; i < b->count; i++)
        order[i] = &b->file[i];
    qsort(order, b->count, sizeof *order, by_output); /* NOLINT(bugprone-sizeof-expression) */
    for (size_t i = 1; i < b->count && result == EXIT_DONE; i++)
        if (strcmp(order[i - 1]->output, order[i]->output) == 0)
            result = message_misuse("--batch: %s and %s would both be drawn to %s", order[i - 1]->input,
                                    order[i]->input, order[i]->output);
    free(order);
    return result;
}

/* Which file a name stands for. */
typedef struct place {
    dev_t device;
    ino_t number;
} place;

static int by_place(const void *a, const void *b)
{
    const place *p = a, *q = b;
    if (p->device != q->device)
        return p->device < q->device ? -1 : 1;
    return (p->number > q->number) - (p->number < q->number);
}

static bool find_place(const char *name, place *at)
{
    struct stat found;
    if (stat(name, &found) != 0 || !S_ISREG(found.st_mode))
        return false;
    *at = (place){found.st_dev, found.st_ino};
    return true;
}

/* No drawing may take the place of a model, of the list, or of the manifest. */
static int check_places(const batch *b)
{
    const char *const other[] = {b->options->list, b->options->manifest};
    place *taken = malloc((b->count + 2) * sizeof *taken), output;
    size_t count = 0;
    int result = EXIT_DONE;
    if (!taken)
        return no_memory();
    for (size_t i = 0; i < b->count; i++)
        count += find_place(b->file[i].input, &taken[count]);
    for (size_t i = 0; i < sizeof other / sizeof other[0]; i++)
        count += other[i] && find_place(other[i], &taken[count]);
    qsort(taken, count, sizeof *taken, by_place);
    for (size_t i = 0; i < b->count && result == EXIT_DONE; i++)
        if (find_place(b->file[i].output, &output) && bsearch(&output, taken, count, sizeof *taken, by_place))
            result = message_misuse("--batch: %s is an input, the list or the manifest; the drawing of %s would take "
                                    "its place",
                                    b->file[i].output, b->file[i].input);
    free(taken);
    return result;
}

/* ---- before the first file is drawn ---- */

static int name_files(batch *b)
{
    roberts_error error;
    for (size_t i = 0; i < b->options->input_count; i++)
        if (!list_add(&b->list, b->options->input[i]))
            return no_memory();
    if (b->options->list && list_read(&b->list, b->options->list, &error) != ROBERTS_OK)
        return message_error(stderr, &error);
    b->file = calloc(b->list.count + 1, sizeof *b->file);
    if (!b->file)
        return no_memory();
    for (b->count = 0; b->count < b->list.count; b->count++) {
        batch_file *file = &b->file[b->count];
        file->input = b->list.name[b->count];
        file->output = output_name(b->options, file->input);
        if (!file->output)
            return no_memory();
    }
    return EXIT_DONE;
}

static int make_folder(const char *name)
{
    if (mkdir(name, 0777) == 0 || errno == EEXIST)
        return EXIT_DONE;
    const char *reason = strerror(errno);
    message_begin(stderr, name);
    fprintf(stderr, "cannot make the folder: %s\n", reason);
    return EXIT_FAILED;
}

/* Keeps the files that are wanted, and forgets the others. Returns how many these are. */
static size_t keep(batch *b, bool (*wanted)(size_t, const void *), const void *context)
{
    const size_t all = b->count;
    b->count = 0;
    for (size_t i = 0; i < all; i++) {
        const batch_file file = b->file[i];
        b->file[i] = (batch_file){0};
        if (wanted(i, context))
            b->file[b->count++] = file;
        else
            free(file.output);
    }
    return all - b->count;
}

/* Takes every n-th file: large ones are often neighbours in a list. */
static bool is_in_shard(size_t i, const void *context)
{
    const cli_share *shard = context;
    return i % shard->of == shard->number - 1;
}

static bool is_newer(const struct timespec a, const struct timespec b)
{
    return a.tv_sec != b.tv_sec ? a.tv_sec > b.tv_sec : a.tv_nsec > b.tv_nsec;
}

/* Whether a drawing is newer than the file. Of one age, as with the coarse times of some file systems, it is not. */
static bool is_newer_than(const struct stat *drawing, const char *file)
{
    struct stat found;
    return stat(file, &found) == 0 && is_newer(drawing->st_mtim, found.st_mtim);
}

static bool is_current(const batch *b, size_t i)
{
    struct stat drawing;
    return stat(b->file[i].output, &drawing) == 0 && is_newer_than(&drawing, b->file[i].input) &&
           (!b->options->names || is_newer_than(&drawing, b->options->names));
}

static bool is_marked(size_t i, const void *context)
{
    const bool *mark = context;
    return mark[i];
}

/* The command that draws a file. */
static const char *command_of(const batch *b, const char *input, description *command)
{
    *command = b->options->description;
    description_word(command, input);
    return command->text;
}

/* Marks as to be drawn what the manifest does not say was drawn, by the same command. */
static int mark_unknown(const batch *b, bool *mark)
{
    manifest_query *query = calloc(b->count + 1, sizeof *query);
    size_t count = 0;
    roberts_error error;
    description command;
    int result = query ? EXIT_DONE : no_memory();
    for (size_t i = 0; i < b->count && result == EXIT_DONE; i++) {
        const batch_file *file = &b->file[i];
        const manifest_row row = {file->input, file->output, command_of(b, file->input, &command), .error = NULL};
        if (mark[i])
            continue;
        query[count].index = i;
        if (manifest_ask(&query[count], &row))
            count++;
        else
            result = no_memory();
    }
    if (result == EXIT_DONE && manifest_answer(&b->manifest, query, count, &error) != ROBERTS_OK)
        result = message_error(stderr, &error);
    for (size_t i = 0; i < count; i++) {
        mark[query[i].index] = !query[i].drawn;
        free(query[i].begins);
    }
    free(query);
    return result;
}

/* Forgets the files whose drawings are up to date. */
static int drop_current(batch *b)
{
    bool *mark = malloc(b->count + 1); /* to be drawn */
    if (!mark)
        return no_memory();
    for (size_t i = 0; i < b->count; i++)
        mark[i] = !is_current(b, i);
    const int result = b->options->manifest ? mark_unknown(b, mark) : EXIT_DONE;
    if (result == EXIT_DONE)
        b->current = keep(b, is_marked, mark);
    free(mark);
    return result;
}

static int open_manifest(batch *b)
{
    roberts_error error;
    if (!b->options->manifest || manifest_open(&b->manifest, b->options->manifest, &error) == ROBERTS_OK)
        return EXIT_DONE;
    return message_error(stderr, &error);
}

static int prepare(batch *b)
{
    const bool draws = b->options->draw.format != ROBERTS_NULL;
    int result = name_files(b);
    if (result == EXIT_DONE && draws)
        result = check_names(b);
    if (result == EXIT_DONE && draws)
        result = check_places(b);
    if (result == EXIT_DONE)
        result = make_folder(b->options->batch);
    if (result == EXIT_DONE)
        result = open_manifest(b);
    if (result == EXIT_DONE && draws && b->options->manifest)
        result = check_places(b); /* now that there is a manifest, even if it is new */
    if (result == EXIT_DONE && b->options->shard.of > 0)
        (void)keep(b, is_in_shard, &b->options->shard);
    if (result == EXIT_DONE && b->options->update)
        result = drop_current(b);
    return result;
}

/* ---- in a worker ---- */

/* What a worker reports: this, behind the text of the messages. */
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
    size_t count;
} warning_counter;

static void count_warning(void *context, const char *file, size_t line, const char *text)
{
    warning_counter *counter = context;
    counter->count++;
    message_warning(counter->log, file, line, text);
}

static void begin(void *context)
{
    batch *b = context;
    if (b->manifest.descriptor >= 0)
        manifest_close(&b->manifest);
#ifdef _OPENMP
    (void)omp_get_max_threads(); /* before memory is limited: LLVM's library hangs if it gets none as it begins */
#endif
}

static void describe(const picture_result *made, char *text, size_t size)
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
    warning_counter counter = {.log = log};
    picture_result made;
    const roberts_time start = report_now();
    own.input = &input;
    own.input_count = 1;
    own.output = file->output;
    own.label = file->input;
    (void)command_of(b, file->input, &own.description);
    own.hide.threads = b->threads;
    own.log = log;
    own.scene.warnings.warn = own.quiet ? NULL : count_warning;
    own.scene.warnings.context = &counter;
    file_report report = {.result = picture_make(&own, &made)};
    report.status = made.error.status;
    report.seconds = report_since(start).wall;
    report.lines = made.segments;
    report.warnings = counter.count;
    describe(&made, report.error, sizeof report.error);
    return report;
}

static char *work(void *context, size_t task, size_t *size)
{
    const batch *b = context;
    char *text = NULL;
    FILE *log = open_memstream(&text, size);
    if (!log)
        return NULL;
    const file_report report = make_one(b, &b->file[task], log);
    const bool whole = fwrite(&report, sizeof report, 1, log) == 1;
    if (fclose(log) == 0 && whole)
        return text;
    free(text);
    return NULL;
}

/* ---- as files are done ---- */

/* Says what kept a file from being drawn, when no worker could say it. */
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

/* Returns what a worker has reported, or what is to be said for it. The text of the messages goes to the file. */
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

/* A manifest that cannot be written is given up. The drawings are not. */
static void add_row(batch *b, const batch_file *file, const file_report *report)
{
    roberts_error error;
    description command;
    const bool draws = b->options->draw.format != ROBERTS_NULL;
    const manifest_row row = {.file = file->input,
                              .output = draws ? file->output : NULL,
                              .command = command_of(b, file->input, &command),
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
    for (; b->printed < b->count && b->file[b->printed].done; b->printed++) {
        batch_file *file = &b->file[b->printed];
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

/* What a file needs must not depend on the files that its worker drew before: the memory that these have left behind,
 * or spoiled. So where memory was short, or the worker has died, a fresh one tries again. */
static bool finish(void *context, const worker_outcome *outcome)
{
    batch *b = context;
    batch_file *file = &b->file[outcome->task];
    const file_report report = take_report(b, outcome, file);
    if (!outcome->fresh && outcome->end != WORKER_LATE && report.status == ROBERTS_NO_MEMORY) {
        free(file->text);
        file->text = NULL;
        return false;
    }
    add_row(b, file, &report);
    b->failed += report.result != EXIT_DONE;
    file->done = true;
    progress_count(++b->done, b->count);
    print_texts(b);
    return true;
}

/* Files are drawn by one thread each, unless there are fewer files than processors. Each thread takes address space for
 * itself, so with a limit on it there is one. */
static void make_all(batch *b)
{
    const cli_options *options = b->options;
    uint32_t threads = options->hide.threads;
#ifdef _OPENMP
    if (threads == 0)
        threads = (uint32_t)omp_get_max_threads();
#endif
    size_t workers = threads > 0 ? threads : 1;
    workers = workers < SIGNALS_WORKERS ? workers : SIGNALS_WORKERS;
    workers = workers < b->count ? workers : b->count;
    if (workers == 0)
        return;
    const worker_plan plan = {.tasks = b->count,
                              .workers = (int)workers,
                              .limit_seconds = options->limit_seconds,
                              .limit_memory = (uint64_t)(options->limit_memory * 1e6),
                              .context = b,
                              .begin = begin,
                              .work = work,
                              .finish = finish};
    b->threads = options->limit_memory > 0.0 || threads < workers ? 1 : threads / (uint32_t)workers;
    progress_count(0, b->count);
    workers_run(&plan);
}

static void tell(const batch *b, roberts_time start)
{
    message_open(stderr);
    fprintf(stderr, "roberts: %zu file%s drawn, %zu up to date, %zu failed; %.3f s\n", b->count - b->failed,
            b->count - b->failed == 1 ? "" : "s", b->current, b->failed, report_since(start).wall);
    message_close(stderr);
}

int batch_make(const cli_options *options)
{
    batch b = {.options = options, .manifest = {.descriptor = -1}};
    const roberts_time start = report_now();
    b.result = prepare(&b);
    if (b.result == EXIT_DONE) {
        make_all(&b);
        if (options->verbose)
            tell(&b, start);
        if (b.failed > 0)
            b.result = EXIT_FAILED;
    }
    if (b.manifest.descriptor >= 0)
        manifest_close(&b.manifest);
    for (size_t i = 0; i < b.count; i++)
        free(b.file[i].output);
    free(b.file);
    list_free(&b.list);
    return b.result;
}
