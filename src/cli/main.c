/* main.c - the program: reads the options, calls the library, writes. A client of roberts.h like any other. */
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "cli/help.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/rays.h"
#include "cli/stats.h"

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

static roberts_status read_all(const cli_options *options, roberts_mesh *mesh, roberts_error *error)
{
    roberts_status status = ROBERTS_OK;
    for (size_t i = 0; i < options->input_count && status == ROBERTS_OK; i++)
        status = roberts_mesh_read_file(mesh, options->input[i], &options->scene.warnings, error);
    return status;
}

/* From the files to a drawing; what is not needed any more is released on the way. */
static roberts_status compute(const cli_options *options, roberts_drawing *drawing, run_stats *run,
                              roberts_error *error)
{
    roberts_mesh mesh = {0};
    roberts_scene *scene = NULL;
    roberts_time start = stats_now();
    roberts_status status = read_all(options, &mesh, error);
    run->read = stats_since(start);
    if (status != ROBERTS_OK)
        goto done;
    start = stats_now();
    status = roberts_scene_build(&mesh, &options->scene, &scene, error);
    roberts_mesh_free(&mesh);
    run->solids = stats_since(start);
    if (status != ROBERTS_OK)
        goto done;
    run->vertices = roberts_scene_vertex_count(scene);
    run->faces = roberts_scene_face_count(scene);
    status = roberts_hide(scene, &options->camera, &options->hide, drawing, error);
    start = stats_now();
    if (status == ROBERTS_OK && options->verify)
        status = rays_verify(options, scene, drawing, &run->wrong, error);
    if (status == ROBERTS_OK && options->pick)
        status = rays_pick(options, scene, error);
    run->verify = stats_since(start);
done:
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
    return status;
}

/* The first file's name without folders, and how many more there are. */
static const char *write_title(const cli_options *options, char *title, size_t size)
{
    const char *first = options->input[0], *slash = strrchr(first, '/'), *name = slash ? slash + 1 : first;
    if (strcmp(first, "-") == 0)
        name = "standard input";
    if (options->input_count > 1)
        snprintf(title, size, "%s and %zu more", name, options->input_count - 1);
    else
        snprintf(title, size, "%s", name);
    return title;
}

static int draw(const cli_options *options)
{
    roberts_drawing drawing = {0};
    roberts_error error = {0};
    run_stats run = {.files = options->input_count};
    roberts_time begin = stats_now();
    int result = EXIT_DONE;
    roberts_status status = compute(options, &drawing, &run, &error);
    if (status == ROBERTS_OK) {
        roberts_time start = stats_now();
        roberts_draw_options page = options->draw;
        char title[256];
        page.title = write_title(options, title, sizeof title);
        page.description = options->description.text;
        page.ink = &run.ink;
        status = roberts_drawing_save(&drawing, &page, options->output, &error);
        run.draw = stats_since(start);
    }
    run.total = stats_since(begin);
    if (status != ROBERTS_OK)
        result = message_error(&error);
    else if (run.wrong)
        result = EXIT_FAILED; /* and the drawing is there to look at */
    if (status == ROBERTS_OK && options->stats != STATS_NONE)
        stats_print(options->stats, &run, &drawing);
    roberts_drawing_free(&drawing);
    return result;
}

int main(int argc, char **argv)
{
    cli_options options;
    interrupt_prepare();
    int status = options_parse(argc, argv, &options);
    if (status != EXIT_DONE)
        return status;
    if (options.help)
        return print_help();
    if (options.version)
        return print("roberts " ROBERTS_VERSION "\n");
    options.scene.warnings.warn = options.quiet ? NULL : message_warning;
    options.draw.temporary = interrupt_temporary;
    return draw(&options);
}
