/* region_compare.c - compares the library's visible regions with the region oracle; see --help. */
#include <inttypes.h>
#include <string.h>

#include "arguments.h"
#include "mesh_families.h"
#include "region_judge.h"

static const char help[] =
    "region_compare [--family NAME] [--seed S] [--regions N] [--folder DIR] [--list]\n"
    "Compares the visible regions of program and exact oracle face by face on generated scenes of any bodies. Exit "
    "status 1 if any face disagrees.\n"
    "  --family NAME  only this family (default: all in turn)\n"
    "  --seed S       first seed (default: 1)\n"
    "  --regions N    goes on until N regions have been compared (default: one scene of each family)\n"
    "  --folder DIR   failing scenes are written to DIR/failures/ (default: build)\n"
    "  --list         names the families\n";

typedef struct arguments {
    const char *family, *folder;
    uint64_t seed, regions;
} arguments;

static void list(void)
{
    for (size_t f = 0; f < mesh_family_count(); f++)
        puts(mesh_family_name(f));
}

static bool compare(const arguments *a, region_total *total)
{
    for (uint64_t seed = a->seed; seed == a->seed || total->regions < a->regions; seed++)
        for (size_t f = 0; f < mesh_family_count(); f++) {
            char name[64];
            mesh_scene scene;
            if (a->family && strcmp(a->family, mesh_family_name(f)) != 0)
                continue;
            if (!mesh_family_make(f, seed, &scene))
                return false;
            snprintf(name, sizeof name, "%s-%" PRIu64, mesh_family_name(f), seed);
            region_judge(name, &scene, a->folder, total, stdout);
            fflush(stdout);
            mesh_scene_free(&scene);
        }
    return total->scenes > 0;
}

int main(int argc, char **argv)
{
    arguments a = {.folder = "build", .seed = 1};
    const argument table[] = {{"--family", ARGUMENT_WORD, &a.family},
                              {"--folder", ARGUMENT_WORD, &a.folder},
                              {"--seed", ARGUMENT_COUNT, &a.seed},
                              {"--regions", ARGUMENT_COUNT, &a.regions},
                              {0}};
    region_total total = {0};
    arguments_parse(argc, argv, table, help, list);
    bool done = compare(&a, &total);
    printf("%zu regions with %zu rings (%zu pieces of borders; nothing is seen of %zu more faces) of %zu scenes (%zu "
           "refused by the oracle), %zu disagreements; greatest difference %.2g; %zu questions, %zu rational numbers "
           "needed\n",
           total.regions, total.rings, total.pieces, total.unseen, total.scenes, total.refused, total.disagreements,
           total.worst, total.questions, total.exact);
    return done && total.disagreements == 0 ? 0 : 1;
}
