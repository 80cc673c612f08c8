/* compare.c - compares the library with the exact oracle on as many scenes as wanted; see --help. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "arguments.h"
#include "judge.h"

static const char help[] =
    "compare [--family NAME] [--seed S] [--count N] [--edges N] [--folder DIR] [--write] [--list]\n"
    "Compares program and exact oracle edge by edge on generated scenes. Exit status 1 if any edge disagrees.\n"
    "  --family NAME  only this family (default: all in turn)\n"
    "  --seed S       first seed (default: 1)\n"
    "  --count N      seeds per family (default: 1, or as many as --edges needs)\n"
    "  --edges N      goes on until N edges have been compared, always with the family that has had the fewest\n"
    "  --folder DIR   failing scenes are written to DIR/failures/ (default: build)\n"
    "  --write        only writes the scenes, to DIR/scenes/FAMILY-SEED.off, and compares nothing\n"
    "  --per-family   a line of figures for each family\n"
    "  --list         names the families\n"
    "compare [--dir X,Y,Z | --eye X,Y,Z] [--slack S] --file FILE.off\n"
    "The same for one scene of any origin (default: --dir 1,-1,1). What could change if corners moved by S (model\n"
    "units) is not judged.\n";

typedef struct arguments {
    const char *family, *folder;
    uint64_t seed, count, edges;
    bool write, per_family;
    const char *file;
    oracle_view view;
    double slack;
} arguments;

static void list(void)
{
    for (size_t f = 0; f < scene_family_count(); f++)
        puts(scene_family_name(f));
}

static arguments parse(int argc, char **argv)
{
    arguments a = {.folder = "build", .seed = 1, .view = {.x = 1, .y = -1, .z = 1}};
    const argument table[] = {{"--write", ARGUMENT_SWITCH, &a.write}, {"--per-family", ARGUMENT_SWITCH, &a.per_family},
                              {"--family", ARGUMENT_WORD, &a.family}, {"--folder", ARGUMENT_WORD, &a.folder},
                              {"--seed", ARGUMENT_COUNT, &a.seed},    {"--count", ARGUMENT_COUNT, &a.count},
                              {"--edges", ARGUMENT_COUNT, &a.edges},  {"--file", ARGUMENT_WORD, &a.file},
                              {"--slack", ARGUMENT_NUMBER, &a.slack}, {"--dir", ARGUMENT_DIR, &a.view},
                              {"--eye", ARGUMENT_EYE, &a.view},       {0}};
    arguments_parse(argc, argv, table, help, list);
    if (a.count == 0)
        a.count = a.edges ? UINT64_MAX : 1;
    if (a.edges == 0)
        a.edges = UINT64_MAX;
    return a;
}

static bool write_scene(const char *name, const test_scene *scene, const char *folder)
{
    char path[512], comment[200];
    snprintf(path, sizeof path, "%s/scenes/%s.off", folder, name);
    snprintf(comment, sizeof comment, "--%s %.17g,%.17g,%.17g; slack %.17g", scene->view.w ? "eye" : "dir",
             scene->view.x, scene->view.y, scene->view.z, scene->slack);
    if (judge_write_off(path, &scene->mesh, comment))
        return true;
    perror(path);
    return false;
}

static void add(judge_total *sum, const judge_total *t)
{
    sum->scenes += t->scenes;
    sum->edges += t->edges;
    sum->drawn += t->drawn;
    sum->cut += t->cut;
    sum->clipped += t->clipped;
    sum->disagreements += t->disagreements;
    sum->unjudged += t->unjudged;
    sum->worst = sum->worst > t->worst ? sum->worst : t->worst;
    sum->pairs += t->pairs;
    sum->exact += t->exact;
    sum->slivers += t->slivers;
    sum->seen += t->seen;
    sum->reordered += t->reordered;
    sum->reordered_open += t->reordered_open;
}

static void print(const char *name, const judge_total *t)
{
    printf("%-24s %8zu edges (%zu drawn, %zu cut, %zu at the near plane) of %zu scenes: %zu disagreements; greatest "
           "difference "
           "%.1e; left open: %.5g edges, parts of %zu shorter than their ends are sure; %zu segments' `by`; %zu scenes "
           "in another "
           "order, %zu with other lines where contact is open; %zu of %zu pairs by rational numbers\n",
           name, t->edges, t->drawn, t->cut, t->clipped, t->scenes, t->disagreements, t->worst, t->unjudged, t->slivers,
           t->seen, t->reordered, t->reordered_open, t->exact, t->pairs);
    fflush(stdout);
}

static int judge_file(const arguments *a)
{
    test_scene scene = {.view = a->view, .slack = a->slack};
    roberts_error error = {0};
    judge_total total = {0};
    if (roberts_mesh_read_file(&scene.mesh, a->file, NULL, &error) != ROBERTS_OK) {
        fprintf(stderr, "%s: %s\n", a->file, error.message);
        return 1;
    }
    judge_scene("file", &scene, a->folder, &total, stdout);
    print(a->file, &total);
    test_scene_free(&scene);
    return total.disagreements ? 1 : 0;
}

/* NULL: all of them. */
static bool is_known(const char *family)
{
    for (size_t f = 0; family && f < scene_family_count(); f++)
        if (strcmp(family, scene_family_name(f)) == 0)
            return true;
    return !family;
}

/* Returns the wanted family with the fewest edges so far that still has scenes to compare; `families` if there is
 * none. */
static size_t next_family(const arguments *a, const judge_total *family, size_t families)
{
    size_t best = families;
    for (size_t f = 0; f < families; f++)
        if ((!a->family || strcmp(a->family, scene_family_name(f)) == 0) && family[f].scenes < a->count &&
            (best == families || family[f].edges < family[best].edges))
            best = f;
    return best;
}

int main(int argc, char **argv)
{
    const arguments a = parse(argc, argv);
    judge_total sum = {0}, *family;
    size_t families = scene_family_count();
    clock_t start = clock();
    if (a.file)
        return judge_file(&a);
    if (!is_known(a.family)) {
        fprintf(stderr, "compare: no family %s\n", a.family);
        return 2;
    }
    if (!(family = calloc(families, sizeof *family))) {
        fputs("compare: no memory\n", stderr);
        return 1;
    }
    for (size_t f; (f = next_family(&a, family, families)) < families;) {
        const char *name = scene_family_name(f);
        char label[100];
        test_scene scene;
        judge_total one = {.scenes = a.write};
        uint64_t seed = a.seed + family[f].scenes;
        snprintf(label, sizeof label, "%s-%" PRIu64, name, seed);
        if (!scene_make(name, seed, &scene)) {
            fprintf(stderr, "%s: no memory\n", label);
            free(family);
            return 1;
        }
        if (a.write)
            write_scene(label, &scene, a.folder);
        else
            judge_scene(label, &scene, a.folder, &one, stdout);
        test_scene_free(&scene);
        add(&family[f], &one);
        add(&sum, &one);
        if (sum.edges >= a.edges)
            break;
    }
    for (size_t f = 0; a.per_family && f < families; f++)
        if (family[f].scenes)
            print(scene_family_name(f), &family[f]);
    if (!a.write)
        print("all", &sum);
    free(family);
    if (!a.write)
        printf("%zu edges compared, %zu disagreements; %.1f s\n", sum.edges, sum.disagreements,
               (double)(clock() - start) / CLOCKS_PER_SEC);
    return sum.disagreements ? 1 : 0;
}
