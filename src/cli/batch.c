/* batch.c - one picture for each file, threads over the files.
 *
 * Each file has a log in memory. The thread that finishes a file prints the logs whose turn it is. So a large file
 * holds up the messages of later files, but not their work. */
#include "cli/batch.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#ifdef _OPENMP
#include <omp.h>
#endif

#include "cli/message.h"
#include "cli/picture.h"
#include "cli/signals.h"
#include "cli/values.h"

typedef struct batch_file {
    char *input;         /* of argv */
    char *output, *text; /* owned; the log's text */
    int result;
    bool done;
} batch_file;

typedef struct batch {
    const cli_options *options;
    batch_file *file;
    size_t count, done, printed; /* printed: the logs of the files before this one are out */
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

/* No drawing may take the place of a model. */
static int check_places(const batch *b)
{
    place *input = malloc(b->count * sizeof *input), output;
    size_t count = 0;
    int result = EXIT_DONE;
    if (!input)
        return no_memory();
    for (size_t i = 0; i < b->count; i++)
        count += find_place(b->file[i].input, &input[count]);
    qsort(input, count, sizeof *input, by_place);
    for (size_t i = 0; i < b->count && result == EXIT_DONE; i++)
        if (find_place(b->file[i].output, &output) && bsearch(&output, input, count, sizeof *input, by_place))
            result = message_misuse("--batch: %s is an input; the drawing of %s would take its place",
                                    b->file[i].output, b->file[i].input);
    free(input);
    return result;
}

static int prepare(batch *b)
{
    for (size_t i = 0; i < b->count; i++) {
        b->file[i].input = b->options->input[i];
        b->file[i].output = output_name(b->options, b->options->input[i]);
        if (!b->file[i].output)
            return no_memory();
    }
    int result = check_names(b);
    if (result == EXIT_DONE && b->options->draw.format != ROBERTS_NULL)
        result = check_places(b);
    if (result == EXIT_DONE && mkdir(b->options->batch, 0777) != 0 && errno != EEXIST) {
        const char *reason = strerror(errno);
        message_begin(stderr, b->options->batch);
        fprintf(stderr, "cannot make the folder: %s\n", reason);
        result = EXIT_FAILED;
    }
    return result;
}

static void make_one(const batch *b, batch_file *file, int thread)
{
    size_t size;
    cli_options own = *b->options;
    char *input = file->input;
    FILE *log = open_memstream(&file->text, &size);
    file->result = EXIT_FAILED;
    if (!log)
        return; /* finish_one() reports it */
    own.input = &input;
    own.input_count = 1;
    own.output = file->output;
    own.label = file->input;
    description_word(&own.description, file->input);
    own.log = log;
    own.scene.warnings.context = log;
    own.draw.temporary_context = signals_slot(thread);
    file->result = picture_make(&own);
    if (fclose(log) != 0) {
        free(file->text);
        file->text = NULL;
    }
}

/* Prints the logs whose turn it is. One thread at a time. */
static void finish_one(batch *b, batch_file *file)
{
    file->done = true;
    progress_count(++b->done, b->count);
    for (; b->printed < b->count && b->file[b->printed].done; b->printed++) {
        batch_file *next = &b->file[b->printed];
        if (!next->text || *next->text) {
            progress_hide();
            if (!next->text)
                message_begin(stderr, next->input);
            fputs(next->text ? next->text : "not enough memory\n", stderr);
            progress_show();
        }
        free(next->text);
        next->text = NULL;
    }
}

static void make_all(batch *b)
{
    long count = (long)b->count;
#ifdef _OPENMP
    uint32_t asked = b->options->hide.threads ? b->options->hide.threads : (uint32_t)omp_get_max_threads();
    int threads = asked < SIGNALS_SLOTS ? (int)asked : SIGNALS_SLOTS;
    if (threads > count)
        threads = (int)count;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
#endif
    for (long i = 0; i < count; i++) {
        int thread = 0;
#ifdef _OPENMP
        thread = omp_get_thread_num();
#endif
        make_one(b, &b->file[i], thread);
#ifdef _OPENMP
#pragma omp critical(batch_finish)
#endif
        finish_one(b, &b->file[i]);
    }
}

int batch_make(const cli_options *options)
{
    batch b = {.options = options, .count = options->input_count};
    b.file = calloc(b.count, sizeof *b.file);
    if (!b.file)
        return no_memory();
    int result = prepare(&b);
    if (result == EXIT_DONE) {
        make_all(&b);
        for (size_t i = 0; i < b.count; i++)
            if (b.file[i].result != EXIT_DONE)
                result = EXIT_FAILED;
    }
    for (size_t i = 0; i < b.count; i++)
        free(b.file[i].output);
    free(b.file);
    return result;
}
