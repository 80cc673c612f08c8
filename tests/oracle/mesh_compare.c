/* mesh_compare.c - compares the library with the mesh oracle on scenes of any bodies; see --help. */
#include <inttypes.h>
#include <string.h>

#include "arguments.h"
#include "mesh_families.h"

static const char help[] =
    "mesh_compare [--family NAME] [--seed S] [--edges N] [--folder DIR] [--list]\n"
    "Compares program and exact oracle edge by edge on generated scenes of any bodies. Exit status 1 if any edge "
    "disagrees.\n"
    "  --family NAME  only this family (default: all in turn)\n"
    "  --seed S       first seed (default: 1)\n"
    "  --edges N      goes on until N edges and lines have been compared (default: one scene of each family)\n"
    "  --folder DIR   failing scenes are written to DIR/failures/ (default: build)\n"
    "  --list         names the families\n"
    "mesh_compare [--dir X,Y,Z | --eye X,Y,Z] [--slack S] --file FILE...\n"
    "The same for files of any origin. What could change if things moved by S (model units) is not judged.\n";

typedef struct arguments {
    const char *family, *folder;
    uint64_t seed, edges;
    int first_file; /* 0: none */
    mesh_scene scene;
} arguments;

static void list(void)
{
    for (size_t f = 0; f < mesh_family_count(); f++)
        puts(mesh_family_name(f));
}

static arguments parse(int argc, char **argv)
{
    arguments a = {.folder = "build", .seed = 1, .scene.view = {.x = 1, .y = -1, .z = 1}};
    const argument table[] = {{"--family", ARGUMENT_WORD, &a.family},
                              {"--folder", ARGUMENT_WORD, &a.folder},
                              {"--seed", ARGUMENT_COUNT, &a.seed},
                              {"--edges", ARGUMENT_COUNT, &a.edges},
                              {"--slack", ARGUMENT_NUMBER, &a.scene.slack},
                              {"--dir", ARGUMENT_DIR, &a.scene.view},
                              {"--eye", ARGUMENT_EYE, &a.scene.view},
                              {"--file", ARGUMENT_REST, &a.first_file},
                              {0}};
    arguments_parse(argc, argv, table, help, list);
    return a;
}

static void sum_up(const mesh_total *t)
{
    printf("%zu edges and %zu intersection lines (%zu of them hidden in part or wholly, %zu on edges that are left "
           "out) of "
           "%zu scenes (%zu refused by the oracle), %zu disagreements; %zu hidden, %zu cut; not judged: %.3g edge "
           "lengths; "
           "greatest difference %.2g; %zu pairs of edge and face, %zu by rational numbers\n",
           t->edges, t->lines, t->lines_cut, t->on_edges, t->scenes, t->refused, t->disagreements, t->hidden, t->cut,
           t->unjudged, t->worst, t->pairs, t->exact);
}

static bool compare_files(const arguments *a, int argc, char **argv, mesh_total *total)
{
    bool read = true;
    for (int i = a->first_file; i < argc; i++) {
        const char *name = strrchr(argv[i], '/') ? strrchr(argv[i], '/') + 1 : argv[i];
        mesh_scene scene = a->scene;
        roberts_error error;
        scene.mesh = (roberts_mesh){0};
        if (roberts_mesh_read_file(&scene.mesh, argv[i], NULL, &error) == ROBERTS_OK)
            mesh_judge(name, &scene, a->folder, total, stdout);
        else {
            printf("%s: %s\n", argv[i], error.message);
            read = false;
        }
        mesh_scene_free(&scene);
    }
    return read;
}

static bool is_enough(const arguments *a, const mesh_total *total)
{
    return total->edges + total->lines >= a->edges;
}

static bool compare_families(const arguments *a, mesh_total *total)
{
    for (uint64_t seed = a->seed; seed == a->seed || !is_enough(a, total); seed++)
        for (size_t f = 0; f < mesh_family_count(); f++) {
            char name[64];
            mesh_scene scene;
            if (a->family && strcmp(a->family, mesh_family_name(f)) != 0)
                continue;
            if (!mesh_family_make(f, seed, &scene))
                return false;
            snprintf(name, sizeof name, "%s-%" PRIu64, mesh_family_name(f), seed);
            mesh_judge(name, &scene, a->folder, total, stdout);
            mesh_scene_free(&scene);
        }
    return true;
}

int main(int argc, char **argv)
{
    const arguments a = parse(argc, argv);
    mesh_total total = {0};
    bool done = a.first_file ? compare_files(&a, argc, argv, &total) : compare_families(&a, &total);
    sum_up(&total);
    return done && total.disagreements == 0 ? 0 : 1;
}
