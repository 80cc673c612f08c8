/* make-models - writes the files of models/, or one scene of any size to standard output.
 *
 * Everything is computed from formulas (see tools/models/), and every machine with IEEE doubles writes the same bytes.
 * A failure ends the program with a message and status 1, wrong usage with status 2. */
#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "models/models.h"
#include "models/off.h"
#include "models/uniform.h"

static const char *const uniform_names[UNIFORM_COUNT] = {
    [TETRAHEDRON] = "tetrahedron",
    [CUBE] = "cube",
    [OCTAHEDRON] = "octahedron",
    [DODECAHEDRON] = "dodecahedron",
    [ICOSAHEDRON] = "icosahedron",
    [TRUNCATED_TETRAHEDRON] = "truncated-tetrahedron",
    [CUBOCTAHEDRON] = "cuboctahedron",
    [TRUNCATED_CUBE] = "truncated-cube",
    [TRUNCATED_OCTAHEDRON] = "truncated-octahedron",
    [RHOMBICUBOCTAHEDRON] = "rhombicuboctahedron",
    [TRUNCATED_CUBOCTAHEDRON] = "truncated-cuboctahedron",
    [SNUB_CUBE] = "snub-cube",
    [ICOSIDODECAHEDRON] = "icosidodecahedron",
    [TRUNCATED_DODECAHEDRON] = "truncated-dodecahedron",
    [TRUNCATED_ICOSAHEDRON] = "truncated-icosahedron",
    [RHOMBICOSIDODECAHEDRON] = "rhombicosidodecahedron",
    [TRUNCATED_ICOSIDODECAHEDRON] = "truncated-icosidodecahedron",
    [SNUB_DODECAHEDRON] = "snub-dodecahedron",
};

static const char *const catalan_names[UNIFORM_COUNT] = {
    [TRUNCATED_TETRAHEDRON] = "triakis-tetrahedron",
    [CUBOCTAHEDRON] = "rhombic-dodecahedron",
    [TRUNCATED_CUBE] = "triakis-octahedron",
    [TRUNCATED_OCTAHEDRON] = "tetrakis-hexahedron",
    [RHOMBICUBOCTAHEDRON] = "deltoidal-icositetrahedron",
    [TRUNCATED_CUBOCTAHEDRON] = "disdyakis-dodecahedron",
    [SNUB_CUBE] = "pentagonal-icositetrahedron",
    [ICOSIDODECAHEDRON] = "rhombic-triacontahedron",
    [TRUNCATED_DODECAHEDRON] = "triakis-icosahedron",
    [TRUNCATED_ICOSAHEDRON] = "pentakis-dodecahedron",
    [RHOMBICOSIDODECAHEDRON] = "deltoidal-hexecontahedron",
    [TRUNCATED_ICOSIDODECAHEDRON] = "disdyakis-triacontahedron",
    [SNUB_DODECAHEDRON] = "pentagonal-hexecontahedron",
};

/* The members of families that are committed. */
static const struct {
    const char *file, *family;
    uint64_t n;
} members[] = {
    {"prisms/prism-3", "prism", 3},
    {"prisms/prism-5", "prism", 5},
    {"prisms/prism-6", "prism", 6},
    {"prisms/prism-8", "prism", 8},
    {"prisms/prism-10", "prism", 10},
    {"prisms/prism-12", "prism", 12},
    {"prisms/prism-60", "prism", 60},
    {"prisms/antiprism-3", "antiprism", 3},
    {"prisms/antiprism-4", "antiprism", 4},
    {"prisms/antiprism-5", "antiprism", 5},
    {"prisms/antiprism-6", "antiprism", 6},
    {"prisms/antiprism-8", "antiprism", 8},
    {"prisms/antiprism-10", "antiprism", 10},
    {"prisms/antiprism-12", "antiprism", 12},
    {"brick-wall", "wall", 54},
    {"city", "city", 8},
    {"lattice", "lattice", 5},
    {"plates", "plates", 40},
    {"needles", "needles", 24},
    {"sphere", "sphere", 288},
};

enum { DEFAULT_SEED = 1 };

/* ---- the folder ------------------------------------------------------------------------------------------------ */

/* The folder being written, and its errors. */
typedef struct target {
    const char *folder;
    bool failed;
} target;

static void complain(const char *what)
{
    fprintf(stderr, "make-models: %s: %s\n", what, strerror(errno));
}

static void make_folder(target *to, const char *name)
{
    char path[4096];
    if (snprintf(path, sizeof path, "%s/%s", to->folder, name) >= (int)sizeof path)
        errno = ENAMETOOLONG;
    else if (mkdir(path, 0777) == 0 || errno == EEXIST)
        return;
    complain(path);
    to->failed = true;
}

static FILE *open_model(target *to, const char *group, const char *name, char *path, size_t size)
{
    FILE *file = NULL;
    if (snprintf(path, size, "%s/%s%s.off", to->folder, group, name) >= (int)size)
        errno = ENAMETOOLONG;
    else
        file = fopen(path, "w");
    if (!file) {
        complain(path);
        to->failed = true;
    }
    return file;
}

static void close_model(target *to, FILE *file, const char *path, bool written)
{
    if (!written || fclose(file) != 0) {
        complain(path);
        to->failed = true;
    }
}

static void write_body(target *to, const char *group, const char *name, const char *about, body *b)
{
    static off_writer w; /* too large for some stacks */
    char path[4096];
    FILE *file = open_model(to, group, name, path, sizeof path);
    if (file) {
        off_begin(&w, file, about, b->vertex_count, b->face_count);
        off_vertices(&w, b);
        off_faces(&w, b, 0);
        close_model(to, file, path, off_end(&w));
    }
    body_free(b);
}

static void write_solids(target *to)
{
    char about[512];
    for (int i = 0; i < UNIFORM_COUNT; i++) {
        body b = {0};
        uniform_make(&b, i);
        write_body(to, i < PLATONIC_COUNT ? "platonic/" : "archimedean/", uniform_names[i], uniform_about(i), &b);
    }
    for (int i = PLATONIC_COUNT; i < UNIFORM_COUNT; i++) {
        body b = {0};
        catalan_make(&b, i);
        snprintf(about, sizeof about,
                 "%s\nIts vertices are the poles of that solid's faces about the sphere that touches its edges.",
                 catalan_about(i));
        write_body(to, "catalan/", catalan_names[i], about, &b);
    }
}

static void write_scenes(target *to)
{
    char about[512];
    for (size_t i = 0; i < case_count(); i++) {
        body b = {0};
        case_make(&b, i);
        case_about(i, about, sizeof about);
        write_body(to, "tests/", case_name(i), about, &b);
    }
    for (size_t i = 0; i < star_count(); i++) {
        body b = {0};
        star_make(&b, i);
        write_body(to, "star/", star_name(i), star_about(i), &b);
    }
    for (size_t i = 0; i < shape_count(); i++) {
        body b = {0};
        shape_at(i)->make(&b);
        write_body(to, "shapes/", shape_at(i)->name, shape_at(i)->about, &b);
    }
    for (size_t i = 0; i < scene_count(); i++) {
        body b = {0};
        scene_at(i)->make(&b);
        write_body(to, "", scene_at(i)->name, scene_at(i)->about, &b);
    }
}

/* Returns the number of the family with this name; family_count(): none. */
static size_t find_family(const char *name)
{
    size_t i = 0;
    while (i < family_count() && strcmp(family_at(i)->name, name) != 0)
        i++;
    return i;
}

static void write_members(target *to)
{
    for (size_t i = 0; i < sizeof members / sizeof *members; i++) {
        char path[4096];
        FILE *file = open_model(to, "", members[i].file, path, sizeof path);
        if (file)
            close_model(to, file, path, family_write(find_family(members[i].family), members[i].n, DEFAULT_SEED, file));
    }
}

static int write_all(const char *folder)
{
    static const char *const parts[] = {"", "platonic", "archimedean", "catalan", "prisms", "star", "shapes", "tests"};
    target to = {folder, false};
    for (size_t i = 0; i < sizeof parts / sizeof *parts && !to.failed; i++)
        make_folder(&to, parts[i]);
    if (!to.failed) {
        write_solids(&to);
        write_scenes(&to);
        write_members(&to);
    }
    return to.failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/* ---- the command ----------------------------------------------------------------------------------------------- */

static int usage(FILE *out)
{
    fputs("usage: make-models --all FOLDER      write the files of models/ into FOLDER\n"
          "       make-models SCENE N [SEED]    write one scene to standard output; SEED is 1 unless given\n",
          out);
    for (size_t i = 0; i < family_count(); i++) {
        const family *f = family_at(i);
        fprintf(out, "\n%s %s    (N from %" PRIu64 " to %" PRIu64 ")\n%s\n", f->name, f->arguments, f->least, f->limit,
                f->about);
    }
    return out == stdout ? EXIT_SUCCESS : 2;
}

static bool parse_count(const char *text, uint64_t *value)
{
    char *end;
    errno = 0;
    *value = strtoull(text, &end, 10);
    return isdigit((unsigned char)*text) && *end == '\0' && errno == 0;
}

static int write_family(size_t which, char **argument, int count)
{
    const family *f = family_at(which);
    uint64_t n, seed = DEFAULT_SEED;
    if (!parse_count(argument[0], &n) || n < f->least || n > f->limit) {
        fprintf(stderr, "make-models: %s: N is a number from %" PRIu64 " to %" PRIu64 "\n", f->name, f->least,
                f->limit);
        return 2;
    }
    if (count > 1 && (!f->seeded || !parse_count(argument[1], &seed))) {
        fprintf(stderr, "make-models: %s: %s\n", f->name, f->seeded ? "SEED is a number" : "takes no SEED");
        return 2;
    }
    if (!family_write(which, n, seed, stdout)) {
        complain("standard output");
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}

int main(int argc, char **argv)
{
    size_t which;
    if (argc == 2 && !strcmp(argv[1], "--help"))
        return usage(stdout);
    if (argc == 3 && !strcmp(argv[1], "--all"))
        return write_all(argv[2]);
    if ((argc == 3 || argc == 4) && (which = find_family(argv[1])) < family_count())
        return write_family(which, argv + 2, argc - 2);
    return usage(stderr);
}
