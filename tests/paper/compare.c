/* compare.c - compares any number of pages with the tables that they were drawn from; see --help. */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

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

static bool parse(int argc, char **argv, arguments *a)
{
    *a = (arguments){.folder = "build", .count = 100, .seed = 1};
    for (int i = 1; i < argc; i += 2) {
        const char *option = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
        if (strcmp(option, "--list") == 0) {
            list();
            exit(0);
        }
        if (!value)
            return false;
        if (strcmp(option, "--family") == 0)
            a->family = value;
        else if (strcmp(option, "--style") == 0)
            a->style = value;
        else if (strcmp(option, "--folder") == 0)
            a->folder = value;
        else if (strcmp(option, "--count") == 0)
            a->count = strtoull(value, NULL, 10);
        else if (strcmp(option, "--seed") == 0)
            a->seed = strtoull(value, NULL, 10);
        else
            return false;
    }
    return true;
}

static void keep(const trial_scene *scene, const char *folder)
{
    char path[700];
    snprintf(path, sizeof path, "%s/failures", folder);
    (void)mkdir(path, 0777);
    snprintf(path, sizeof path, "%s/failures/%s.off", folder, scene->name);
    if (judge_write_off(path, &scene->mesh, scene->name))
        printf("  scene: %s\n", path);
}

int main(int argc, char **argv)
{
    arguments a;
    uint64_t drawn = 0, wrong = 0, refused = 0, tried = 0;
    clock_t start = clock();
    if (!parse(argc, argv, &a)) {
        fputs(help, stderr);
        return 2;
    }
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
