/* compare.c - compares any number of pages with the tables that they were drawn from; see --help. */
#include <string.h>
#include <time.h>

#include "../oracle/arguments.h"
#include "../oracle/judge.h"
#include "trials.h"

static const char help[] =
    "compare [--count N] [--seed S] [--family NAME] [--style NAME] [--folder DIR] [--list]\n"
    "Draws generated scenes, reads the files back and compares them with the segments. Exit status 1 if one is wrong.\n"
    "  --count N      drawings (default: 100)\n"
    "  --seed S       first seed (default: 1)\n"
    "  --family NAME  only this family (default: all in turn)\n"
    "  --style NAME   only this way to draw (default: all in turn)\n"
    "  --folder DIR   scenes that are drawn wrong are written to DIR/failures/ (default: build)\n"
    "  --list         names families and styles\n";

typedef struct arguments {
    const char *family, *style, *folder;
    uint64_t count, seed;
} arguments;

static void list(void)
{
    for (size_t i = 0; i < trial_family_count(); i++)
        printf("family %s\n", trial_family_name(i));
    for (size_t i = 0; i < trial_style_count(); i++)
        printf("style %s\n", trial_style_at(i)->name);
}

static void keep(const trial_scene *scene, const char *folder)
{
    char path[JUDGE_PATH];
    if (judge_write_failure(folder, scene->name, &scene->mesh, scene->name, path))
        printf("  scene: %s\n", path);
}

int main(int argc, char **argv)
{
    arguments a = {.folder = "build", .count = 100, .seed = 1};
    const argument table[] = {{"--family", ARGUMENT_WORD, &a.family}, {"--style", ARGUMENT_WORD, &a.style},
                              {"--folder", ARGUMENT_WORD, &a.folder}, {"--count", ARGUMENT_COUNT, &a.count},
                              {"--seed", ARGUMENT_COUNT, &a.seed},    {0}};
    uint64_t drawn = 0, wrong = 0, refused = 0, tried = 0;
    clock_t start = clock();
    arguments_parse(argc, argv, table, help, list);
    for (uint64_t seed = a.seed; drawn < a.count; seed++) {
        uint64_t before = tried;
        for (size_t i = 0; i < trial_family_count() && drawn < a.count; i++) {
            trial_scene scene;
            const trial_style *style = trial_style_at((seed + i) % trial_style_count());
            for (size_t k = 0; a.style && k < trial_style_count(); k++)
                if (strcmp(a.style, trial_style_at(k)->name) == 0)
                    style = trial_style_at(k);
            if (a.family && strcmp(a.family, trial_family_name(i)) != 0)
                continue;
            tried++;
            if (!trial_make(i, seed, &scene)) {
                fputs("compare: no memory\n", stderr);
                return 1;
            }
            findings f = {.out = stdout};
            trial_result result = trial_run(&scene, style, &f);
            refused += result == TRIAL_REFUSED;
            drawn += result != TRIAL_REFUSED;
            if (result == TRIAL_WRONG) {
                wrong++;
                printf("%s, %s: %zu rows not drawn, %zu lines without a row, %zu lines twice, %zu faults of pixels\n",
                       scene.name, style->name, f.missing, f.unfounded, f.twice, f.pixels);
                keep(&scene, a.folder);
            }
            trial_free(&scene);
        }
        if (tried == before)
            break; /* no such family */
    }
    printf("%llu drawings compared with their tables, %llu wrong (%llu scenes refused); %.1f s\n",
           (unsigned long long)drawn, (unsigned long long)wrong, (unsigned long long)refused,
           (double)(clock() - start) / CLOCKS_PER_SEC);
    return wrong || !drawn ? 1 : 0;
}
