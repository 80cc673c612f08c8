/* test_off_pieces.c - reading by several threads gives the same mesh, warnings and errors with their lines as reading
 * by one, wherever pieces begin and end. Pieces have only a few bytes here, so that borders lie everywhere. Plain lines
 * are also read by the parser of all forms, which gets a byte or two at a time; the results must be equal.
 *
 * Threads are those of POSIX, which the thread sanitizer knows (make test-threads). */
#include <dirent.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/off.h"
#include "folders.h"
#include "make_mesh.h"
#include "rng.h"
#include "same_mesh.h"
#include "temporary.h"
#include "testing.h"
#include "whole_file.h"

/* ---- threads --------------------------------------------------------------------------------------------------- */

typedef struct start {
    off_work_fn *work;
    void *job;
    uint32_t thread;
} start;

static void *work_in_thread(void *argument)
{
    start *s = argument;
    s->work(s->job, s->thread);
    return NULL;
}

enum { THREADS = 4 };

static void run_side_by_side(off_work_fn *work, void *job, uint32_t threads)
{
    pthread_t thread[THREADS];
    start s[THREADS];
    assert_true(threads > 1 && threads <= THREADS);
    for (uint32_t i = 0; i < threads; i++) {
        s[i] = (start){work, job, i};
        assert_int_equal(pthread_create(&thread[i], NULL, work_in_thread, &s[i]), 0);
    }
    for (uint32_t i = 0; i < threads; i++)
        assert_int_equal(pthread_join(thread[i], NULL), 0);
}

/* One after the other, as without threads: much faster. */
static void run_in_turn(off_work_fn *work, void *job, uint32_t threads)
{
    for (uint32_t i = threads; i-- > 0;)
        work(job, i);
}

/* ---- an input, and what is read from it ------------------------------------------------------------------------ */

typedef struct test_input {
    const char *text;
    size_t size, at, step; /* step: bytes given at a time, 0: any number */
    size_t read;           /* bytes taken by the one reader */
    size_t first;          /* vertices that the mesh has before */
} test_input;

static ptrdiff_t read_at(void *context, uint64_t offset, void *buffer, size_t size)
{
    const test_input *in = context;
    size_t left = offset < in->size ? in->size - (size_t)offset : 0, n = left < size ? left : size;
    if (n)
        memcpy(buffer, in->text + offset, n);
    return (ptrdiff_t)n;
}

static ptrdiff_t read_on(void *context, void *buffer, size_t size)
{
    test_input *in = context;
    ptrdiff_t got = read_at(in, in->at, buffer, in->step && in->step < size ? in->step : size);
    in->at += (size_t)got;
    in->read += (size_t)got;
    return got;
}

static bool go(void *context, uint64_t offset)
{
    test_input *in = context;
    in->at = (size_t)offset;
    return true;
}

typedef struct result {
    roberts_mesh mesh;
    roberts_error error;
    char warnings[1000];
} result;

static void keep_warning(void *context, const char *file, size_t line, const char *message)
{
    char *text = context;
    size_t length = strlen(text);
    snprintf(text + length, sizeof((result *)0)->warnings - length, "%s:%zu: %s;", file, line, message);
}

static void read_input(test_input *in, const off_division *division, result *r)
{
    const roberts_warnings warnings = {keep_warning, r->warnings};
    const input_source source = {
        .read = read_on, .context = in, .read_at = read_at, .go = go, .size = in->size, .to_end = true};
    *r = (result){0};
    for (size_t i = 0; i < in->first; i++)
        mesh_vertex(&r->mesh, (roberts_vec3){1, 2, 3});
    in->at = in->read = 0;
    (void)read_mesh(&r->mesh, "t", &source, division, &warnings, &r->error);
}

static void compare(const result *one, const result *other, const test_input *in, const char *way)
{
    if (one->error.status != other->error.status || one->error.line != other->error.line ||
        strcmp(one->error.message, other->error.message) != 0 || strcmp(one->warnings, other->warnings) != 0 ||
        !same_mesh(&one->mesh, &other->mesh))
        fail_msg("%s: \"%s\" line %zu, warnings \"%s\"; by one thread: \"%s\" line %zu, warnings \"%s\"\n%.2000s", way,
                 other->error.message, other->error.line, other->warnings, one->error.message, one->error.line,
                 one->warnings, in->text);
}

static const off_division alone = {.threads = 1};

/* Reads it by one thread, whole and in steps of some bytes, and in pieces. */
static void check(const char *text, size_t size, const off_division *division, size_t piece_count)
{
    test_input in = {.text = text, .size = size};
    result one, other;
    char way[80];
    read_input(&in, &alone, &one);
    in.step = 1 + size % 3;
    read_input(&in, &alone, &other);
    compare(&one, &other, &in, "byte by byte");
    roberts_mesh_free(&other.mesh);
    for (size_t i = 0; i < piece_count; i++) {
        in.step = i % 2 ? 7 : 0;
        read_input(&in, &division[i], &other);
        snprintf(way, sizeof way, "%u threads, pieces of %zu, overhang %zu", (unsigned)division[i].threads,
                 division[i].piece, division[i].overhang);
        compare(&one, &other, &in, way);
        roberts_mesh_free(&other.mesh);
    }
    roberts_mesh_free(&one.mesh);
}

static const off_division tiny[] = {
    {2, 24, 40, 1, run_in_turn},
    {3, 61, 30, 1, run_in_turn},
    {2, 200, 100, 1, run_in_turn},
};

enum { TINY = sizeof tiny / sizeof *tiny };

/* ---- texts ----------------------------------------------------------------------------------------------------- */

/* Adds a number in a form that programs write. */
static size_t add_number(char *text, rng *r)
{
    double value = ((double)rng_below(r, 2000000) - 1e6) / 1e4 * (rng_below(r, 4) ? 1.0 : 1e-9);
    static const char *const format[] = {"%.17g", "%g", "%.6f", "%.15g", "%.0f"};
    return (size_t)sprintf(text, format[rng_below(r, 5)], value * 1.0000001234567);
}

/* A plain file. If odd > 0, one line in `odd` is not plain. Returns its length. */
static size_t make_text(char *text, uint32_t vertices, uint32_t faces, uint32_t odd, rng *r)
{
    static const char *const odd_end[] = {"\r\n", "\n\n", " \n",    "\t\r\n",   " # 1\n",
                                          "\r",   " ",    "\n#x\n", " 1 0 0\n", "\n \n"};
    char *c = text + sprintf(text, "OFF\n%lu %lu 0\n", (unsigned long)vertices, (unsigned long)faces);
    for (uint32_t i = 0; i < vertices + faces; i++) {
        uint32_t corners = i < vertices ? 3 : 1 + rng_below(r, 6);
        if (i >= vertices)
            c += sprintf(c, "%lu ", (unsigned long)corners);
        for (uint32_t k = 0; k < corners; k++) {
            c += i < vertices ? add_number(c, r) : (size_t)sprintf(c, "%lu", (unsigned long)rng_below(r, vertices));
            if (k + 1 < corners)
                *c++ = odd && rng_below(r, 3 * odd) == 0 ? '\n' : ' ';
        }
        const char *end =
            odd && rng_below(r, odd) == 0 ? odd_end[rng_below(r, sizeof odd_end / sizeof *odd_end)] : "\n";
        if (i < vertices && strcmp(end, " 1 0 0\n") == 0)
            end = "\n";
        c += sprintf(c, "%s", end);
    }
    return (size_t)(c - text);
}

static char *allocate(size_t size)
{
    char *text = malloc(size);
    assert_non_null(text);
    return text;
}

/* ---- tests ----------------------------------------------------------------------------------------------------- */

/* Each size of pieces, so that their borders fall on each byte; and the pieces really read it. */
static void borders_anywhere(void **state)
{
    char *text = allocate(1 << 16);
    rng random = {1};
    size_t size = make_text(text, 150, 150, 0, &random);
    (void)state;
    for (size_t piece = 1; piece < 400; piece++) {
        const off_division division = {2 + piece % 3, piece, 90, 1, run_in_turn};
        check(text, size, &division, 1);
        if (piece < 100)
            continue;
        test_input in = {.text = text, .size = size, .step = 40, .first = 5};
        result r, one;
        read_input(&in, &division, &r);
        assert_true(r.error.status == ROBERTS_OK && r.mesh.vertex_count == 155 && r.mesh.face_count == 150);
        assert_true(in.read < 300); /* the header, a vertex, the rest after the last piece */
        read_input(&in, &alone, &one);
        compare(&one, &r, &in, "after other vertices");
        roberts_mesh_free(&one.mesh);
        roberts_mesh_free(&r.mesh);
    }
    free(text);
}

/* Real threads, on a text of many pieces. */
static void threads_side_by_side(void **state)
{
    char *text = allocate(1 << 22);
    rng r = {2};
    (void)state;
    for (uint32_t odd = 0; odd < 1200; odd = 4 * odd + 100) {
        size_t size = make_text(text, 20000, 20000, odd, &r);
        const off_division division[] = {{2, 5000, 200, 1, run_side_by_side},
                                         {4, 300, 200, 1, run_side_by_side},
                                         {3, 1 << 14, 200, 1 << 14, run_side_by_side},
                                         {2, 100000, 4096, 1, run_side_by_side}};
        check(text, size, division, 4);
    }
    free(text);
}

/* Lines of all kinds between plain ones. */
static void odd_lines(void **state)
{
    char text[1 << 14];
    rng r = {3};
    (void)state;
    for (int n = 0; n < 600; n++) {
        size_t size = make_text(text, 1 + rng_below(&r, 60), rng_below(&r, 60), 2 + rng_below(&r, 40), &r);
        check(text, size, tiny, TINY);
    }
}

/* An error at each place: a file cut off anywhere, and each byte replaced. */
static void broken_anywhere(void **state)
{
    static const char other[] = {'\n', '\r', ' ', '\t', '\0', '#', '}', '-', '+', '.', 'e', '9', 'x', '\v', '{'};
    char text[4096];
    rng r = {4};
    size_t size = make_text(text, 14, 16, 0, &r);
    (void)state;
    for (size_t length = 0; length <= size; length++)
        check(text, length, tiny, TINY);
    for (size_t i = 0; i < size; i++) {
        char c = text[i];
        for (size_t k = 0; k < sizeof other; k++) {
            text[i] = other[k];
            check(text, size, tiny, TINY);
        }
        text[i] = c;
    }
}

/* Counts that are not those of the lines, where faces look like vertices, and dialects. */
static const char *const heads[] = {
    "OFF 40 40 0\n",  "OFF 39 41 0\n",         "OFF 41 39 0\n",    "OFF 40 10 0\n",   "OFF 40 4000000000 0\n",
    "OFF 10 70 0\n",  "OFF 4000000000 40 0\n", "OFF 79 1 0\n",     "OFF 80 0 0\n",    "{ OFF 40 40\n",
    "COFF 40 40 0\n", "NOFF 20 40 0\n",        "4OFF 30 40 0\n",   "STOFF 24 40 0\n", "OFF 0 80 0\n",
    "40 40 0\n",      "OFF BINARY\n",          "OFF\n40\n40\n0\n",
};

static void heads_and_lines_that_differ(void **state)
{
    char text[1 << 13];
    (void)state;
    for (size_t h = 0; h < sizeof heads / sizeof *heads; h++) {
        for (int corners = 0; corners < 5; corners++) {
            char *c = text + sprintf(text, "%s", heads[h]);
            for (int i = 0; i < 40; i++)
                c += sprintf(c, "%d %d %d\n", i % 5, i % 7, i);
            for (int i = 0; i < 40; i++) {
                c += sprintf(c, "%d", corners);
                for (int k = 0; k < corners; k++)
                    c += sprintf(c, " %d", (i + k) % 40);
                c += sprintf(c, i % 9 == 8 && corners == 4 ? " 5\n" : "\n");
            }
            check(text, (size_t)(c - text), tiny, TINY);
        }
    }
}

/* The largest values that fit, and larger ones: indices, and lines that exceed a piece by more than is allowed. */
static void extremes(void **state)
{
    static const char *const lines[] = {
        "1e150 0 0\n",
        "1.0001e150 0 0\n",
        "-1e151 0 0\n",
        "nan 0 0\n",
        "0 inf 0\n",
        "1e-400 1e-310 0\n",
        "0.00000000000000000000000000000000000000000000000000000000000001 12345678901234567890123 1\n",
        "0        \t                                                                                0 0\n",
        "99999999 9999999 123456789012\n",
    };
    char text[1 << 13];
    (void)state;
    for (size_t n = 0; n < sizeof lines / sizeof *lines; n++) {
        for (int at = 1; at < 30; at++) {
            char *c = text + sprintf(text, "OFF 30 3 0\n");
            for (int i = 0; i < 30; i++)
                c += sprintf(c, "%s", i == at ? lines[n] : "1 2 3.5\n");
            c += sprintf(c, "3 0 1 2\n3 0 1 %s\n3 0 1 2\n", n % 3 == 0 ? "29" : n % 3 == 1 ? "30" : "00000029");
            check(text, (size_t)(c - text), tiny, TINY);
        }
    }
}

/* A face of more corners than a plain one has, among others. */
static void a_large_face(void **state)
{
    char *text = allocate(1 << 16), *c = text + sprintf(text, "OFF 3 41 0\n0 0 0\n1 0 0\n0 1 0\n");
    const off_division division[] = {{2, 300, 200, 1, run_in_turn}, {2, 4000, 2000, 1, run_in_turn}};
    (void)state;
    for (int f = 0; f < 41; f++) {
        int corners = f % 10 ? 3 : 253 + f / 10;
        c += sprintf(c, "%d", corners);
        for (int i = 0; i < corners; i++)
            c += sprintf(c, " %d", i % 3);
        c += sprintf(c, "\n");
    }
    check(text, (size_t)(c - text), division, 2);
    free(text);
}

/* ---- files ----------------------------------------------------------------------------------------------------- */

static int check_folder(const char *folder)
{
    static const off_division division[] = {
        {2, 100, 60, 1, run_in_turn}, {3, 1000, 200, 1, run_in_turn}, {2, 60000, 4096, 1, run_side_by_side}};
    DIR *dir = opendir(folder);
    int count = 0;
    if (!dir)
        return 0;
    for (struct dirent *entry; (entry = readdir(dir)) != NULL;) {
        char path[1000];
        size_t size, length = strlen(entry->d_name);
        if (length < 5 || strcmp(entry->d_name + length - 4, ".off") != 0)
            continue;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        char *text = whole_file(path, &size);
        check(text, size, division, 3);
        free(text);
        count++;
    }
    closedir(dir);
    return count;
}

static void models_in_pieces(void **state)
{
    char path[1000];
    (void)state;
    assert_true(check_folder("models") >= 15 && check_folder("models/tests") >= 30);
    snprintf(path, sizeof path, "%s/models", shared_folder());
    print_message("%d published models\n", check_folder(path));
}

/* The public functions: a file of several pieces as they are, by any number of threads. */
static void public_functions(void **state)
{
    char *text = allocate(1 << 23), path[TEMPORARY_ROOM + 10];
    rng r = {6};
    size_t size = make_text(text, 70000, 70000, 0, &r);
    roberts_mesh one = {.threads = 1}, other;
    (void)state;
    snprintf(path, sizeof path, "%s/large.off", temporary);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_true(size > 3 << 20 && fwrite(text, 1, size, file) == size && fclose(file) == 0);
    assert_int_equal(roberts_mesh_read_file(&one, path, NULL, NULL), ROBERTS_OK);
    for (uint32_t threads = 0; threads < 8; threads += 1 + threads) {
        other = (roberts_mesh){.threads = threads};
        assert_int_equal(roberts_mesh_read_file(&other, path, NULL, NULL), ROBERTS_OK);
        assert_true(same_mesh(&one, &other));
        roberts_mesh_free(&other);
        other = (roberts_mesh){.threads = threads};
        assert_int_equal(roberts_mesh_read_memory(&other, path, text, size, NULL, NULL), ROBERTS_OK);
        assert_true(same_mesh(&one, &other));
        roberts_mesh_free(&other);
    }
    roberts_mesh_free(&one);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(borders_anywhere),
        cmocka_unit_test(threads_side_by_side),
        cmocka_unit_test(odd_lines),
        cmocka_unit_test(broken_anywhere),
        cmocka_unit_test(heads_and_lines_that_differ),
        cmocka_unit_test(extremes),
        cmocka_unit_test(a_large_face),
        cmocka_unit_test(models_in_pieces),
        cmocka_unit_test_setup_teardown(public_functions, temporary_make, temporary_remove),
    };
    return cmocka_run_group_tests_name("off pieces", tests, NULL, NULL);
}
