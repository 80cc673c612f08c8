/* batch.c - one picture for each file, drawn by worker processes.
 *
 * Names are first checked for all files, so runs with different --shard options agree. This process hands out the
 * files, prints the messages about them in order, and writes the manifest. A file that kills its worker, or takes too
 * long, is just one failed file. */
#include "cli/batch.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include "cli/lists.h"
#include "cli/manifest.h"
#include "cli/message.h"
#include "cli/parse.h"
#include "cli/picture.h"
#include "cli/report.h"
#include "cli/signals.h"
#include "cli/values.h"
#include "cli/workers.h"

/* ---- the files of a batch: the names of their drawings, and which files to draw ---------------------------------- */

typedef struct batch_file {
    char *input;         /* of argv, or of the list */
    char *output, *text; /* owned; the text of its messages */
    size_t folder;       /* the length of DIR, with which the output begins */
    bool done;
    bool again; /* an earlier file has the same name */
} batch_file;

typedef struct batch_files {
    const cli_options *options;
    file_list list;
    batch_file *file; /* [count] in the order of the command and the list */
    size_t count;
    size_t current; /* others, whose drawings are up to date */
} batch_files;

/* Functions that return an int return the exit status, after printing any message. */

static int no_memory(void)
{
    fputs("roberts: not enough memory\n", stderr);
    return EXIT_FAILED;
}

/* ---- names ---- */

/* Length of the folder part of a file name, with its slash. */
static size_t folder_length(const char *name)
{
    const char *slash = strrchr(name, '/');
    return slash ? (size_t)(slash - name) + 1 : 0;
}

/* Skips slashes and parts that are only a dot, which have no effect. */
static const char *next_part(const char *at)
{
    while (*at == '/' || (at[0] == '.' && (at[1] == '/' || !at[1])))
        at++;
    return at;
}

/* Returns the rest of a name below the folder `root`. Compares letters only: links are not followed. NULL: it is not
 * below it. */
static const char *name_below(const char *root, const char *name)
{
    if ((*root == '/') != (*name == '/'))
        return NULL;
    for (root = next_part(root), name = next_part(name); *root; root = next_part(root), name = next_part(name)) {
        const size_t length = strcspn(root, "/");
        if (strcspn(name, "/") != length || strncmp(root, name, length) != 0)
            return NULL;
        root += length;
        name += length;
    }
    for (const char *at = name; *at; at = next_part(at + strcspn(at, "/")))
        if (strcspn(at, "/") == 2 && strncmp(at, "..", 2) == 0)
            return NULL;
    return *name ? name : NULL;
}

/* Returns the part of a file name that its drawing keeps: the part after the last slash, or below --root. NULL: it is
 * not in that folder. */
static const char *kept_name(const cli_options *options, const char *input)
{
    return options->root ? name_below(options->root, input) : input + folder_length(input);
}

/* DIR/name.svg for any/where/name.off, where the kept name is name.off; NULL: no memory. */
static char *output_name(const cli_options *options, const char *kept)
{
    const char *ending = values_format_name(options->draw.format);
    char *output = malloc(strlen(options->batch) + 1 + strlen(kept) + 1 + strlen(ending) + 1), *to = output;
    if (!output)
        return NULL;
    to += sprintf(to, "%s", options->batch);
    for (const char *at = kept; *at; at = next_part(at)) {
        const int length = (int)strcspn(at, "/");
        to += sprintf(to, "/%.*s", length, at);
        at += length;
    }
    char *dot = strrchr(output, '.'), *slash = strrchr(output, '/');
    sprintf(dot > slash + 1 ? dot : to, ".%s", ending);
    return output;
}

/* By output, by input, and then as they are named. */
static int by_output(const void *a, const void *b)
{
    const batch_file *const *f = a, *const *g = b;
    int order = strcmp((*f)->output, (*g)->output);
    order = order ? order : strcmp((*f)->input, (*g)->input);
    return order ? order : (*f > *g) - (*f < *g);
}

static bool in_one_folder(const char *a, const char *b)
{
    const size_t length = folder_length(a);
    return length == folder_length(b) && strncmp(a, b, length) == 0;
}

/* Keeps the wanted files, and drops the others. Returns how many are dropped. */
static size_t keep(batch_files *b, bool (*wanted)(size_t, const void *), const void *context)
{
    const size_t all = b->count;
    b->count = 0;
    for (size_t i = 0; i < all; i++) {
        const batch_file file = b->file[i];
        const bool is_wanted = wanted(i, context);
        b->file[i] = (batch_file){0};
        if (is_wanted)
            b->file[b->count++] = file;
        else
            free(file.output);
    }
    return all - b->count;
}

static bool is_first(size_t i, const void *context)
{
    return !((const batch_files *)context)->file[i].again;
}

/* No two drawings may have the same name, but a file that is named again is drawn once: globs overlap. */
static int check_names(batch_files *b)
{
    int result = EXIT_DONE;
    const char *again = NULL; /* the first such file, which is named for all */
    /* an array of pointers: the check takes sizeof a pointer for a slip */
    batch_file **order = malloc(b->count * sizeof *order); /* NOLINT(bugprone-sizeof-expression) */
    if (!order)
        return no_memory();
    for (size_t i = 0; i < b->count; i++)
        order[i] = &b->file[i];
    qsort(order, b->count, sizeof *order, by_output); /* NOLINT(bugprone-sizeof-expression) */
    for (size_t i = 1; i < b->count && result == EXIT_DONE; i++) {
        const batch_file *one = order[i - 1] < order[i] ? order[i - 1] : order[i];
        const batch_file *other = one == order[i] ? order[i - 1] : order[i];
        order[i]->again = strcmp(one->input, other->input) == 0;
        if (!order[i]->again && strcmp(one->output, other->output) == 0)
            result =
                message_misuse("--batch: %s and %s would both be drawn to %s%s", one->input, other->input, one->output,
                               b->options->root || in_one_folder(one->input, other->input)
                                   ? ""
                                   : "; with --root FOLDER drawings keep their folders below FOLDER");
    }
    free(order);
    for (size_t i = 0; i < b->count && result == EXIT_DONE && !again; i++)
        again = b->file[i].again ? b->file[i].input : NULL;
    if (again && !b->options->quiet)
        message_warning(stderr, again, 0, "this file is named twice, and is drawn once");
    if (again)
        (void)keep(b, is_first, b);
    return result;
}

/* No drawing may replace a model, the list, or the manifest. */
static int batch_files_check_places(const batch_files *b)
{
    const char *const other[] = {b->options->list, b->options->manifest, b->options->names};
    const size_t others = sizeof other / sizeof other[0], rooms = b->options->room_count;
    file_identity *taken = malloc((b->count + others + rooms) * sizeof *taken), output;
    size_t count = 0;
    int result = EXIT_DONE;
    if (!taken)
        return no_memory();
    for (size_t i = 0; i < b->count; i++)
        count += file_identify(b->file[i].input, &taken[count]);
    for (size_t i = 0; i < others; i++)
        count += other[i] && file_identify(other[i], &taken[count]);
    for (size_t i = 0; i < rooms; i++)
        count += file_identify(b->options->room[i], &taken[count]);
    qsort(taken, count, sizeof *taken, file_identity_order);
    for (size_t i = 0; i < b->count && result == EXIT_DONE; i++)
        if (file_identify(b->file[i].output, &output) &&
            bsearch(&output, taken, count, sizeof *taken, file_identity_order))
            result = message_misuse("--batch: %s is an input, the list, the manifest or a file of --labels or "
                                    "--room-for; the drawing of %s would take its place",
                                    b->file[i].output, b->file[i].input);
    free(taken);
    return result;
}

/* Names the drawings of all files. */
static int name_drawings(batch_files *b)
{
    b->file = calloc(b->list.count + 1, sizeof *b->file);
    if (!b->file)
        return no_memory();
    for (; b->count < b->list.count; b->count++) {
        batch_file *file = &b->file[b->count];
        file->input = b->list.name[b->count];
        const char *kept = kept_name(b->options, file->input);
        if (!kept)
            return message_misuse("--root: %s is not in the folder %s", file->input, b->options->root);
        file->output = output_name(b->options, kept);
        file->folder = strlen(b->options->batch);
        if (!file->output)
            return no_memory();
    }
    return EXIT_DONE;
}

/* Lists all files, and names their drawings; no two may have the same name. Call batch_files_free() in any case. */
static int batch_files_name(batch_files *b, const cli_options *options)
{
    roberts_error error;
    *b = (batch_files){.options = options};
    for (size_t i = 0; i < options->input_count; i++)
        if (!list_add(&b->list, options->input[i]))
            return no_memory();
    if (options->list && list_read(&b->list, options->list, &error) != ROBERTS_OK)
        return message_error(stderr, &error);
    const int result = name_drawings(b);
    return result == EXIT_DONE && options->draw.format != ROBERTS_NULL ? check_names(b) : result;
}

/* ---- which of them are drawn ---- */

/* Returns the command that draws a file: the text of `command`. */
static const char *batch_files_command(const batch_files *b, const batch_file *file, description *command)
{
    *command = b->options->description;
    description_word(command, file->input);
    return command->text;
}

/* Takes every n-th file: large ones are often neighbours in a list. */
static bool is_in_shard(size_t i, const void *context)
{
    const roberts_share *shard = context;
    return i % shard->of == shard->number - 1;
}

/* Keeps the files of --shard. */
static void batch_files_take_shard(batch_files *b)
{
    (void)keep(b, is_in_shard, &b->options->shard);
}

static bool is_newer(const struct timespec a, const struct timespec b)
{
    return a.tv_sec != b.tv_sec ? a.tv_sec > b.tv_sec : a.tv_nsec > b.tv_nsec;
}

/* Whether a drawing is newer than the file. If both have the same time, as with the coarse times of some file systems,
 * it is not. */
static bool is_newer_than(const struct stat *drawing, const char *file)
{
    struct stat found;
    return stat(file, &found) == 0 && is_newer(drawing->st_mtim, found.st_mtim);
}

static bool is_current(const batch_files *b, size_t i)
{
    const cli_options *options = b->options;
    struct stat drawing;
    bool is = stat(b->file[i].output, &drawing) == 0 && is_newer_than(&drawing, b->file[i].input) &&
              (!options->names || is_newer_than(&drawing, options->names));
    for (size_t k = 0; k < options->room_count && is; k++)
        is = is_newer_than(&drawing, options->room[k]);
    return is;
}

/* ---- materials: the colours of an OBJ come from .mtl files in its folder ---- */

/* By the names of their folders. */
static int by_folder(const void *a, const void *b)
{
    const batch_file *const *f = a, *const *g = b;
    const size_t p = folder_length((*f)->input), q = folder_length((*g)->input);
    return p != q ? (p > q) - (p < q) : strncmp((*f)->input, (*g)->input, p);
}

/* Finds when the newest .mtl file beside a file was changed; long ago, if there is none. False: the folder cannot be
 * read. */
static bool newest_material(const char *name, struct timespec *newest)
{
    const size_t length = folder_length(name);
    char *folder = length > 0 ? strndup(name, length) : strdup(".");
    DIR *open = folder ? opendir(folder) : NULL;
    struct stat found;
    *newest = (struct timespec){0};
    for (const struct dirent *entry; open && (entry = readdir(open));)
        if (parse_has_ending(entry->d_name, ".mtl") && fstatat(dirfd(open), entry->d_name, &found, 0) == 0 &&
            is_newer(found.st_mtim, *newest))
            *newest = found.st_mtim;
    free(folder);
    return open && closedir(open) == 0;
}

/* Marks for drawing each OBJ whose drawing is not newer than all .mtl files in its folder. Only the OBJ itself names
 * those that it uses, and it is not read. Each folder is searched once. */
static int mark_coloured(const batch_files *b, bool *mark)
{
    /* an array of pointers: the check takes sizeof a pointer for a slip */
    batch_file **order = malloc((b->count + 1) * sizeof *order); /* NOLINT(bugprone-sizeof-expression) */
    struct timespec newest = {0};
    struct stat drawing;
    size_t count = 0;
    bool known = false;
    if (!order)
        return no_memory();
    for (size_t i = 0; i < b->count; i++)
        if (!mark[i] && parse_has_ending(b->file[i].input, ".obj"))
            order[count++] = &b->file[i];
    qsort(order, count, sizeof *order, by_folder); /* NOLINT(bugprone-sizeof-expression) */
    for (size_t i = 0; i < count; i++) {
        if (i == 0 || by_folder(&order[i - 1], &order[i]) != 0)
            known = newest_material(order[i]->input, &newest);
        mark[order[i] - b->file] =
            !known || stat(order[i]->output, &drawing) != 0 || !is_newer(drawing.st_mtim, newest);
    }
    free(order);
    return EXIT_DONE;
}

/* ---- what is up to date ---- */

static bool is_marked(size_t i, const void *context)
{
    const bool *mark = context;
    return mark[i];
}

/* Marks for drawing every file that, by the manifest, was not drawn by the same command. */
static int mark_unknown(const batch_files *b, const manifest *rows, bool *mark)
{
    manifest_query *query = calloc(b->count + 1, sizeof *query);
    size_t count = 0;
    roberts_error error;
    description command;
    int result = query ? EXIT_DONE : no_memory();
    for (size_t i = 0; i < b->count && result == EXIT_DONE; i++) {
        const batch_file *file = &b->file[i];
        const manifest_row row = {file->input, file->output, batch_files_command(b, file, &command), .error = NULL};
        if (mark[i])
            continue;
        query[count].index = i;
        if (manifest_ask(&query[count], &row))
            count++;
        else
            result = no_memory();
    }
    if (result == EXIT_DONE && manifest_answer(rows, query, count, &error) != ROBERTS_OK)
        result = message_error(stderr, &error);
    for (size_t i = 0; i < count; i++) {
        mark[query[i].index] = !query[i].drawn;
        free(query[i].begins);
    }
    free(query);
    return result;
}

/* Keeps the files that --update draws. rows: the manifest; NULL: there is none. */
static int batch_files_drop_current(batch_files *b, const manifest *rows)
{
    bool *mark = malloc(b->count + 1); /* to be drawn */
    if (!mark)
        return no_memory();
    for (size_t i = 0; i < b->count; i++)
        mark[i] = !is_current(b, i);
    int result = mark_coloured(b, mark);
    if (result == EXIT_DONE && rows)
        result = mark_unknown(b, rows, mark);
    if (result == EXIT_DONE)
        b->current = keep(b, is_marked, mark);
    free(mark);
    return result;
}

static void batch_files_free(batch_files *b)
{
    for (size_t i = 0; i < b->count; i++) {
        free(b->file[i].output);
        free(b->file[i].text);
    }
    free(b->file);
    list_free(&b->list);
}

/* ---- drawing them ------------------------------------------------------------------------------------------------ */

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

/* Makes the folders of a path that are missing, where a slash follows them behind `first`. */
static void make_parents(char *path, size_t first)
{
    for (char *slash = path + first; (slash = strchr(slash + 1, '/')) != NULL;) {
        *slash = '\0';
        (void)mkdir(path, 0777);
        *slash = '/';
    }
}

static int make_folder(const char *name)
{
    char *path = strdup(name);
    if (path && *path)
        make_parents(path, 0);
    free(path);
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

/* A roberts_temporary_fn that first makes the missing folders of a drawing: a model that is refused before leaves none
 * behind. If one cannot be made, writing the drawing reports why. */
static void make_folders(void *context, const char *path)
{
    const batch_file *file = context;
    if (path)
        make_parents(file->output, file->folder);
    signals_temporary(NULL, path);
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
static file_report make_one(const batch *b, batch_file *file, FILE *log)
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
    if (own.root) {
        own.draw.temporary = make_folders;
        own.draw.temporary_context = file;
    }
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
        snprintf(text, size, "it takes too long: --limit-seconds allows %.10g s", b->options->limit_seconds);
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

/* The messages of files that failed may be far up. */
static void tell_failed(const batch *b)
{
    if (b->failed == 0 || b->files.count == 1)
        return;
    message_open(stderr);
    fprintf(stderr, "roberts: %zu of %zu models %s not drawn\n", b->failed, b->files.count,
            b->failed == 1 ? "was" : "were");
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
        else if (!options->quiet)
            tell_failed(&b);
        if (b.failed > 0)
            b.result = EXIT_FAILED;
    }
    if (b.manifest.descriptor >= 0)
        manifest_close(&b.manifest);
    batch_files_free(&b.files);
    return b.result;
}
