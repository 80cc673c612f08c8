/* batch_files.c - the files of a batch, and their drawings. */
#include "cli/batch_files.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "cli/message.h"
#include "cli/parse.h"
#include "cli/values.h"

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

static int by_output(const void *a, const void *b)
{
    const batch_file *const *f = a, *const *g = b;
    return strcmp((*f)->output, (*g)->output);
}

static bool in_one_folder(const char *a, const char *b)
{
    const size_t length = folder_length(a);
    return length == folder_length(b) && strncmp(a, b, length) == 0;
}

/* No two drawings may have the same name. */
static int check_names(const batch_files *b)
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
            result = message_misuse("--batch: %s and %s would both be drawn to %s%s", order[i - 1]->input,
                                    order[i]->input, order[i]->output,
                                    b->options->root || in_one_folder(order[i - 1]->input, order[i]->input)
                                        ? ""
                                        : "; with --root FOLDER drawings keep their folders below FOLDER");
    free(order);
    return result;
}

int batch_files_check_places(const batch_files *b)
{
    const char *const other[] = {b->options->list, b->options->manifest, b->options->names};
    file_identity *taken = malloc((b->count + sizeof other / sizeof other[0]) * sizeof *taken), output;
    size_t count = 0;
    int result = EXIT_DONE;
    if (!taken)
        return no_memory();
    for (size_t i = 0; i < b->count; i++)
        count += file_identify(b->file[i].input, &taken[count]);
    for (size_t i = 0; i < sizeof other / sizeof other[0]; i++)
        count += other[i] && file_identify(other[i], &taken[count]);
    qsort(taken, count, sizeof *taken, file_identity_order);
    for (size_t i = 0; i < b->count && result == EXIT_DONE; i++)
        if (file_identify(b->file[i].output, &output) &&
            bsearch(&output, taken, count, sizeof *taken, file_identity_order))
            result = message_misuse("--batch: %s is an input, the list, the manifest or the file of --labels; the "
                                    "drawing of %s would take its place",
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
        if (!file->output)
            return no_memory();
    }
    return EXIT_DONE;
}

int batch_files_name(batch_files *b, const cli_options *options)
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

/* Keeps the wanted files, and drops the others. Returns how many are dropped. */
static size_t keep(batch_files *b, bool (*wanted)(size_t, const void *), const void *context)
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
    const roberts_share *shard = context;
    return i % shard->of == shard->number - 1;
}

void batch_files_take_shard(batch_files *b)
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
    struct stat drawing;
    return stat(b->file[i].output, &drawing) == 0 && is_newer_than(&drawing, b->file[i].input) &&
           (!b->options->names || is_newer_than(&drawing, b->options->names));
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

int batch_files_drop_current(batch_files *b, const manifest *rows)
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

/* ---- for each file ---- */

const char *batch_files_command(const batch_files *b, const batch_file *file, description *command)
{
    *command = b->options->description;
    description_word(command, file->input);
    return command->text;
}

void batch_files_make_folders(const batch_files *b, const batch_file *file)
{
    char *slash = file->output + strlen(b->options->batch);
    while ((slash = strchr(slash + 1, '/'))) {
        *slash = '\0';
        (void)mkdir(file->output, 0777);
        *slash = '/';
    }
}

void batch_files_free(batch_files *b)
{
    for (size_t i = 0; i < b->count; i++) {
        free(b->file[i].output);
        free(b->file[i].text);
    }
    free(b->file);
    list_free(&b->list);
}
