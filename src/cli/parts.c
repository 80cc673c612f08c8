/* parts.c - a drawing in parts. See parts.h. */
#include "cli/parts.h"

#include <sys/resource.h>

#include "cli/hints.h"
#include "cli/lists.h"
#include "cli/message.h"
#include "cli/signals.h"
#include "cli/values.h"

static roberts_task task_of(const cli_options *options)
{
    return (roberts_task){.camera = options->camera,
                          .scene = options->scene,
                          .hide = options->hide,
                          .temporary = options->draw.temporary,
                          .temporary_context = options->draw.temporary_context};
}

/* A part has no names. It fails early if the drawing of all parts cannot have them. */
static roberts_status check_names(const char *path, roberts_error *error)
{
    name_list names = {0};
    roberts_status status = names_read(&names, path, error);
    if (status == ROBERTS_OK)
        status = names_check_part(&names, path, error);
    else
        hint_label(path, error);
    names_free(&names);
    return status;
}

int part_make(const cli_options *options)
{
    const roberts_task task = task_of(options);
    const roberts_inputs input = {options->input_count, options->input};
    roberts_error error = {0};
    roberts_status status = options->names ? check_names(options->names, &error) : ROBERTS_OK;
    progress_stage(options->plan ? "laying out" : "drawing a part");
    if (status == ROBERTS_OK)
        status = options->plan ? roberts_plan_save(&input, &task, options->output, &error)
                               : roberts_part_save(&input, &task, options->part, options->output, &error);
    if (status != ROBERTS_OK && !error.file[0] && options->input_count == 1) /* bodies count over all inputs */
        snprintf(error.file, sizeof error.file, "%s", options->input[0]);
    return status == ROBERTS_OK ? EXIT_DONE : message_error(options->log, &error);
}

/* Is a name of a group written? */
static bool wants_names(const cli_options *options)
{
    const roberts_draw_options *page = &options->draw;
    return (page->format == ROBERTS_SVG && page->grouping != ROBERTS_GROUP_CLASS) ||
           values_has_column(page, ROBERTS_COLUMN_NAME) || values_has_column(page, ROBERTS_COLUMN_BY);
}

/* All parts are open at the same time. Often the limit is 1024 open files, unless a program raises it. */
static void allow_files(size_t count)
{
    const rlim_t wanted = (rlim_t)count + 64; /* including the drawing's file, and files that were open before */
    struct rlimit limit;
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= wanted)
        return;
    limit.rlim_cur = wanted < limit.rlim_max ? wanted : limit.rlim_max;
    (void)setrlimit(RLIMIT_NOFILE, &limit);
}

roberts_status part_join(const cli_options *options, roberts_joined *joined, roberts_error *error)
{
    const roberts_task task = task_of(options);
    allow_files(options->input_count);
    roberts_status status = roberts_join(&(roberts_inputs){options->input_count, options->input}, &task, joined, error);
    if (status != ROBERTS_OK || !joined->has_names || !wants_names(options))
        return status;
    roberts_joined_free(joined);
    error->status = ROBERTS_BAD_ARGUMENT;
    snprintf(error->message, sizeof error->message,
             "the models name their faces, but parts hold no names: --group and --columns +name need one run");
    return error->status;
}
