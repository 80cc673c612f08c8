/* bench-read - reads OFF text with the library, and the same numbers with strtod(): bench-read FILE.off [RUNS]
 *
 * Prints one line, tab-separated: bytes, numbers, CPU seconds of the library, CPU seconds of strtod(), and the latter
 * divided by the former. The seconds are medians of RUNS runs (default 1), which alternate. The library does
 * everything: dialects, checks, a mesh in memory. The other side does the least that a program could do: it reads
 * blocks, passes every word to strtod(), and stores nothing. Both use one thread. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "roberts.h"

enum { BLOCK = 1 << 18, RUNS_MAX = 99 };

/* What strtod() has read. */
typedef struct tally {
    unsigned long long bytes, numbers;
} tally;

static double cpu_now(void)
{
    struct timespec now = {0};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Reads every number of a line; skips words that are not numbers (the keyword) and comments. */
static void take_line(char *p, tally *s)
{
    for (;;) {
        char *end;
        p += strspn(p, " \t\r");
        if (*p == '\0' || *p == '#')
            return;
        (void)strtod(p, &end);
        s->numbers += end != p;
        p = end != p ? end : p + strcspn(p, " \t\r");
    }
}

/* Reads the complete lines of a block; returns the number of bytes of an incomplete line that are left. */
static size_t take_lines(char *block, size_t size, tally *s)
{
    char *line = block, *end;
    block[size] = '\0';
    while ((end = memchr(line, '\n', size - (size_t)(line - block))) != NULL) {
        *end = '\0';
        take_line(line, s);
        line = end + 1;
    }
    return size - (size_t)(line - block);
}

/* False: there is no such file, it cannot be read, or a line is longer than a block. */
static bool read_by_strtod(const char *path, tally *s)
{
    static char block[BLOCK + 1];
    FILE *file = fopen(path, "rb");
    size_t held = 0, got;
    *s = (tally){0};
    if (!file)
        return false;
    while ((got = fread(block + held, 1, BLOCK - held, file)) > 0) {
        size_t size = held + got;
        s->bytes += got;
        held = take_lines(block, size, s);
        memmove(block, block + size - held, held);
    }
    block[held] = '\0';
    take_line(block, s);
    bool good = !ferror(file) && held < BLOCK;
    fclose(file);
    return good;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *value, int count)
{
    qsort(value, (size_t)count, sizeof *value, compare);
    return value[count / 2];
}

static bool time_library(const char *path, double *seconds)
{
    roberts_mesh mesh = {.threads = 1};
    roberts_error error = {0};
    double start = cpu_now();
    roberts_status status = roberts_mesh_read_file(&mesh, path, NULL, &error);
    *seconds = cpu_now() - start;
    roberts_mesh_free(&mesh);
    if (status != ROBERTS_OK)
        fprintf(stderr, "bench-read: %s:%zu: %s\n", error.file, error.line, error.message);
    return status == ROBERTS_OK;
}

static bool time_strtod(const char *path, double *seconds, tally *s)
{
    double start = cpu_now();
    errno = 0;
    bool good = read_by_strtod(path, s);
    *seconds = cpu_now() - start;
    if (!good)
        fprintf(stderr, "bench-read: %s: %s\n", path, errno ? strerror(errno) : "a line is too long");
    return good;
}

int main(int argc, char **argv)
{
    double ours[RUNS_MAX], others[RUNS_MAX];
    tally s = {0};
    int runs = argc == 3 ? (int)strtol(argv[2], NULL, 10) : 1;
    if ((argc != 2 && argc != 3) || runs < 1 || runs > RUNS_MAX) {
        fprintf(stderr, "usage: bench-read FILE.off [RUNS]    (RUNS from 1 to %d)\n", RUNS_MAX);
        return 2;
    }
    for (int i = 0; i < runs; i++)
        if (!time_library(argv[1], &ours[i]) || !time_strtod(argv[1], &others[i], &s))
            return EXIT_FAILURE;
    double a = median(ours, runs), b = median(others, runs);
    printf("%llu\t%llu\t%.6f\t%.6f\t%.2f\n", s.bytes, s.numbers, a, b, b / a);
    return EXIT_SUCCESS;
}
