/* test_batch.c - many drawings in one run: lists, shards, updates, the manifest, limits, and files or runs that are
 * killed. Runs $ROBERTS_BUILD/roberts from the top folder. */
#include <poll.h>
#include <stdio.h>
#include <sys/file.h>
#include <time.h>

#include "program.h"
#include "sanitized.h"
#include "testing.h"

static char rows[TEXT]; /* of the manifest */

/* How many rows of the manifest "rows" have the text. */
static int rows_with(const char *text)
{
    read_text("rows", rows);
    return count_of(rows, text);
}

static void put_bytes(const char *path, const char *bytes, size_t size)
{
    int descriptor = open_stream(path, O_WRONLY | O_TRUNC);
    assert_int_equal(write(descriptor, bytes, size), size);
    close(descriptor);
}

static void put_cube(const char *path)
{
    static char cube[TEXT];
    read_text("models/platonic/cube.off", cube);
    put(path, cube);
}

/* Runs with the list on standard input. */
static int run_list(const char *line, const char *list, size_t size)
{
    put_bytes("list", list, size);
    finish(start(line, "list", -1));
    return last.status;
}

#define RUN_LIST(line, list) run_list(line, list, sizeof(list) - 1)

/* Sets the time of a file: seconds since 1970, and nanoseconds. */
static void set_time(const char *path, time_t seconds, long nanoseconds)
{
    const struct timespec times[2] = {{seconds, nanoseconds}, {seconds, nanoseconds}};
    assert_int_equal(utimensat(AT_FDCWD, path, times, 0), 0);
}

static time_t time_of(const char *path)
{
    struct stat found;
    assert_int_equal(stat(path, &found), 0);
    return found.st_mtim.tv_sec;
}

/* ---- lists and shards ---- */

static void lists_name_files(void **state)
{
    static const char zeros[] = "a b.off\0new\nline.off\0";
    (void)state;
    put_cube("a b.off");
    put_cube("new\nline.off");
    put_cube(" c.off ");
    put_cube("#d.off");
    put_cube("e.off");
    assert_int_equal(RUN_LIST("--batch in --list -", "a b.off\n\n c.off \n#d.off"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(access("in/a b.svg", F_OK) + access("in/ c.svg", F_OK) + access("in/#d.svg", F_OK), 0);
    assert_int_equal(entries("in", true), 3);
    assert_int_equal(RUN_LIST("--batch in --list -", "\xef\xbb\xbf"
                                                     "a b.off\r\n\r\ne.off\r"),
                     0); /* made on Windows */
    assert_string_equal(last.err, "");
    assert_int_equal(access("in/a b.svg", F_OK) + access("in/e.svg", F_OK), 0);
    assert_int_equal(entries("in", true), 2);
    assert_int_equal(RUN_LIST("--batch in --label vertices,edges,faces --page 20x20 --margin 0 --list -", "a b.off\n"),
                     0);
    assert_non_null(strstr(last.err, "roberts: a b.off: warning: no room for "));
    assert_int_equal(run_list("--batch in --list list models/table.off", zeros, sizeof zeros - 1), 0);
    assert_int_equal(access("in/a b.svg", F_OK) + access("in/new\nline.svg", F_OK) + access("in/table.svg", F_OK), 0);
    assert_int_equal(entries("in", true), 3);
}

static const struct {
    const char *line, *list, *said;
    int status;
} list_cases[] = {
    {"--batch in --list -", "", "standard input: the list is empty\n", 1},
    {"--batch in --list -", "\n\n", "standard input: the list is empty\n", 1},
    {"--batch in --list list models/table.off", "\n", "list: the list is empty\n", 1},
    {"--batch in --list -", "models/table.off\n-\n", "standard input:2: - is no file; a file of this name is ./-\n", 1},
    {"--batch in --list missing", "", "missing: No such file or directory\n", 1},
    {"--batch in --list in", "", "in: is a folder\n", 1},
    {"--batch in --list - -", "models/table.off\n", "--batch needs names of files: --batch DIR FILE..., or --batch", 2},
    {"--batch in --list -", "models/table.off\nmodels/../models/table.off\n", "would both be drawn to in/table.svg", 2},
    {"--batch in --list in/table.svg", "models/table.off\n", "in/table.svg: No such file or directory\n", 1},
    {"--list list", "models/table.off\n", "--list needs --batch\n", 2},
};

static void lists_can_be_wrong(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof list_cases / sizeof list_cases[0]; i++) {
        print_message("%s, %s\n", list_cases[i].line, list_cases[i].list);
        assert_int_equal(run_list(list_cases[i].line, list_cases[i].list, strlen(list_cases[i].list)),
                         list_cases[i].status);
        assert_said(list_cases[i].said);
        assert_int_equal(entries("in", false), 0);
    }
    put("in/table.svg", "models/table.off\n");
    assert_int_equal(run("--batch in --list in/table.svg"), 2);
    assert_said("in/table.svg is an input, the list, the manifest or a file of --labels or --room-for; the drawing of "
                "models/table.off would take its place");
}

/* Globs overlap, and lists repeat. */
static void a_name_given_twice_is_drawn_once(void **state)
{
    static const char list[] = "b.off\na.off\n";
    (void)state;
    put_cube("a.off");
    put_cube("b.off");
    assert_int_equal(run("--batch in --manifest rows b.off a.off b.off models/table.off a.off b.off"), 0);
    assert_string_equal(last.err, "roberts: b.off: warning: this file is named twice, and is drawn once\n");
    assert_int_equal(entries("in", false), 3);
    assert_int_equal(rows_with("\"error\":null"), 3);
    assert_int_equal(run_list("--batch in --list - -q a.off", list, strlen(list)), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("--batch in --shard 2/2 -v a.off a.off b.off"), 0); /* shards count each once */
    assert_said("roberts: b.off: 1 body");
    assert_said("roberts: 1 file drawn, 0 up to date, 0 failed; ");
}

static const char *const wrong_shares[] = {"0/3", "4/3", "1/0",   "0/0",  "1",     "/",
                                           "1/",  "/2",  "1/2/3", "-1/2", "1.5/2", ""};

static void shards_draw_each_file_once(void **state)
{
    char line[200];
    static char list[2000];
    (void)state;
    for (int i = 0; i < 11; i++) {
        snprintf(line, sizeof line, "%d.off", i);
        put_cube(line);
        snprintf(list + strlen(list), sizeof list - strlen(list), "%d.off\n", i);
    }
    for (int k = 1; k <= 4; k++) {
        snprintf(line, sizeof line, "--batch in --list - --shard %d/4 --manifest rows", k);
        assert_int_equal(run_list(line, list, strlen(list)), 0);
        assert_int_equal(entries("in", false), k < 4 ? 3 * k : 11);
    }
    assert_int_equal(rows_with("\"error\":null"), 11);
    for (int i = 0; i < 11; i++) {
        snprintf(line, sizeof line, "{\"file\":\"%d.off\",", i);
        assert_int_equal(rows_with(line), 1);
    }
    assert_int_equal(run("--batch in --shard 9/9 models/table.off"), 0); /* there may be more shards than files */
    /* names are checked for all files, even in a shard that has one of them */
    assert_int_equal(run("--batch in --shard 2/2 0.off models/../0.off"), 2);
    assert_said("would both be drawn to in/0.svg");
    for (size_t i = 0; i < sizeof wrong_shares / sizeof wrong_shares[0]; i++) {
        snprintf(line, sizeof line, "--batch in --shard=%s models/table.off", wrong_shares[i]);
        assert_int_equal(run(line), 2);
        assert_said("is not K/N, with K from 1 to N\n");
    }
}

/* ---- folders ---- */

static const struct {
    const char *line, *drawings[3]; /* nothing else is drawn */
} root_cases[] = {
    {"--batch in --root a a/p.off a/b/p.off a/b/.x", {"in/p.svg", "in/b/p.svg", "in/b/.x.svg"}},
    {"--batch in --root . a/p.off ./c//p.off a/./b/p.off", {"in/a/p.svg", "in/c/p.svg", "in/a/b/p.svg"}},
    {"--batch in/new --root ./a/ a/p.off", {"in/new/p.svg"}},
    {"--batch in --root=.// --list list --shard 2/2 a/p.off", {"in/a/b/p.svg"}},
    {"--batch in -f null --root . a/p.off", {NULL}},
};

static const struct {
    const char *line, *said;
} wrong_root_cases[] = {
    {"--batch in a/p.off c/p.off", "a/p.off and c/p.off would both be drawn to in/p.svg; with --root FOLDER drawings"},
    {"--batch in --root a a/p.off c/p.off", "--root: c/p.off is not in the folder a\n"},
    {"--batch in --root a ab/p.off", "--root: ab/p.off is not in the folder a\n"},
    {"--batch in --root a/b a/p.off", "--root: a/p.off is not in the folder a/b\n"},
    {"--batch in --root a a/b/../p.off", "--root: a/b/../p.off is not in the folder a\n"},
    {"--batch in --root / a/p.off", "--root: a/p.off is not in the folder /\n"},
    {"--batch in --root a /a/p.off", "--root: /a/p.off is not in the folder a\n"},
    {"--batch in --root a/p.off a/p.off", "--root: a/p.off is not in the folder a/p.off\n"},
    {"--batch in --root a a/p.off a/p.obj", "a/p.off and a/p.obj would both be drawn to in/p.svg\n"},
    {"--batch in --root . a/p.off a/./p.off", "a/p.off and a/./p.off would both be drawn to in/a/p.svg\n"},
    {"--root a a/p.off", "--root needs --batch\n"},
};

static void put_folders(void)
{
    static const char *const folders[] = {"a", "a/b", "c"};
    static const char *const files[] = {"a/p.off", "a/b/p.off", "a/b/.x", "c/p.off"};
    for (size_t i = 0; i < sizeof folders / sizeof folders[0]; i++)
        assert_int_equal(mkdir(folders[i], 0777), 0);
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++)
        put_cube(files[i]);
    put("list", "a/b/p.off\n");
}

static void drawings_keep_their_folders(void **state)
{
    (void)state;
    put_folders();
    for (size_t i = 0; i < sizeof root_cases / sizeof root_cases[0]; i++) {
        print_message("%s\n", root_cases[i].line);
        assert_int_equal(run(root_cases[i].line), 0);
        for (size_t k = 0; k < 3 && root_cases[i].drawings[k]; k++)
            assert_int_equal(unlink(root_cases[i].drawings[k]), 0);
        assert_int_equal(system("find in -type f | grep -q ."), 1 << 8);
    }
    for (size_t i = 0; i < sizeof wrong_root_cases / sizeof wrong_root_cases[0]; i++) {
        print_message("%s\n", wrong_root_cases[i].line);
        assert_int_equal(run(wrong_root_cases[i].line), 2);
        assert_said(wrong_root_cases[i].said);
    }
    /* a folder that cannot be made affects only one file */
    put("in/file", "");
    assert_int_equal(mkdir("file", 0777), 0);
    put_cube("file/p.off");
    assert_int_equal(run("--batch in --root . file/p.off c/p.off"), 1);
    assert_said("in/file/p.svg: ");
    assert_int_equal(access("in/c/p.svg", F_OK), 0);
    /* a model that is not there or is refused leaves no folders behind, and folders that were there stay */
    put("file/bad.off", "OFF\n3 1 0\n");
    assert_int_equal(unlink("in/file") + unlink("in/c/p.svg"), 0);
    assert_int_equal(run("--batch in --root . missing/d/p.off file/bad.off c/missing.off"), 1);
    assert_int_equal(access("in/missing", F_OK) + access("in/file", F_OK), -2);
    assert_int_equal(access("in/c", F_OK), 0);
}

/* ---- the manifest ---- */

static void rows_tell(void **state)
{
    (void)state;
    put("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n");
    put("w.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n1 0\n");
    put_cube("q\"\\\t\xff.off");
    assert_int_equal(RUN_LIST("--batch in --list - --manifest rows --hidden dashed --threads 1",
                              "models/platonic/cube.off\nbad.off\nmissing.off\nw.off\nq\"\\\t\xff.off\n"),
                     1);
    read_text("rows", rows);
    static const char *const begins[] = {
        "{\"file\":\"models/platonic/cube.off\",\"output\":\"in/cube.svg\",\"command\":\"roberts --hidden=dashed "
        "models/platonic/cube.off\",\"error\":null,\"seconds\":0.",
        ",\"lines\":12,\"warnings\":0}\n{\"file\":\"bad.off\",\"output\":\"in/bad.svg\",\"command\":\"roberts "
        "--hidden=dashed bad.off\",\"error\":\"bad.off:6: ",
        ",\"lines\":0,\"warnings\":0}\n{\"file\":\"missing.off\",\"output\":\"in/missing.svg\",",
        "\"error\":\"missing.off: No such file or directory\",",
        "{\"file\":\"w.off\",\"output\":\"in/w.svg\",\"command\":\"roberts --hidden=dashed w.off\",\"error\":null,",
        ",\"warnings\":1}\n{\"file\":\"q\\\"\\\\\\u0009\\ufffd.off\",\"output\":\"in/q\\\"\\\\\\u0009\\ufffd.svg\",",
    };
    const char *at = rows;
    for (size_t i = 0; i < sizeof begins / sizeof begins[0]; i++) {
        const char *found = strstr(at, begins[i]);
        if (!found)
            fail_msg("%s\nhas not: %s", at, begins[i]);
        at = found + 1;
    }
    assert_int_equal(count_of(rows, "\n"), 5);
    assert_int_equal(run("--batch in -f null --manifest rows models/table.off"), 0);
    assert_int_equal(rows_with("{\"file\":\"models/table.off\",\"output\":null,"), 1);
    assert_int_equal(rows_with("\n"), 6);
}

static void rows_that_were_cut_go(void **state)
{
    static const char cut[] = "{\"file\":\"models/table.off\",\"output\":\"in/ta";
    (void)state;
    for (size_t size = 1; size < sizeof cut; size += 7) { /* in the first line, and in a later one */
        put_bytes("rows", cut, size);
        assert_int_equal(run("--batch in --manifest rows models/table.off"), 0);
        int descriptor = open("rows", O_WRONLY | O_APPEND);
        assert_int_equal(write(descriptor, cut, size), size);
        close(descriptor);
        assert_int_equal(run("--batch in --manifest rows --update models/table.off models/tower.off"), 0);
        assert_int_equal(rows_with("\n"), 2);
        assert_int_equal(rows_with("{\"file\":"), 2);
        assert_int_equal(rows_with("}\n"), 2);
    }
    /* of a run that is still writing, nothing is cut */
    int descriptor = open("rows", O_WRONLY | O_APPEND);
    assert_int_equal(flock(descriptor, LOCK_SH), 0);
    assert_int_equal(write(descriptor, cut, sizeof cut - 1), sizeof cut - 1);
    assert_int_equal(run("--batch in --manifest rows models/table.off"), 0);
    close(descriptor);
    assert_int_equal(rows_with("\"output\":\"in/ta{\"file\":"), 1);
}

static const struct {
    const char *text, *line, *said;
    int status;
} manifest_cases[] = {
    {"OFF\n", "--batch in --manifest rows models/table.off", "rows: is no manifest: its first line is something", 1},
    {"{\"files\":", "--batch in --manifest rows models/table.off", "rows: is no manifest", 1},
    {NULL, "--batch in --manifest in models/table.off", "in: cannot write: Is a directory\n", 1},
    {NULL, "--batch in --manifest /dev/full models/table.off", "/dev/full: is no file\n", 1},
    {NULL, "--batch in --manifest missing/rows models/table.off", "missing/rows: cannot write: No such file", 1},
    {NULL, "--batch in --manifest in/table.json -f json models/table.off",
     "in/table.json is an input, the list, the manifest or", 2},
    {NULL, "--manifest rows models/table.off", "--manifest needs --batch\n", 2},
    {NULL, "--update models/table.off", "--update needs --batch\n", 2},
    {NULL, "--shard 1/2 models/table.off", "--shard needs --batch\n", 2},
    {NULL, "--limit-seconds 1 models/table.off", "--limit-seconds needs --batch\n", 2},
    {NULL, "--limit-memory 1 models/table.off", "--limit-memory needs --batch\n", 2},
    {NULL, "--batch in --limit-seconds 0 models/table.off", "--limit-seconds: 0 is out of range", 2},
    {NULL, "--batch in --limit-memory 2G models/table.off", "--limit-memory: \"2G\" is not a number", 2},
    {NULL, "--batch in --update -f null models/table.off", "--update compares files with their drawings, and -f", 2},
};

static void manifests_can_be_wrong(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof manifest_cases / sizeof manifest_cases[0]; i++) {
        print_message("%s\n", manifest_cases[i].line);
        if (manifest_cases[i].text)
            put("rows", manifest_cases[i].text);
        assert_int_equal(run(manifest_cases[i].line), manifest_cases[i].status);
        assert_said(manifest_cases[i].said);
        if (manifest_cases[i].text) {
            read_text("rows", rows);
            assert_string_equal(rows, manifest_cases[i].text);
        }
    }
}

/* ---- updates ---- */

/* Whether the drawing of a.off was made again. */
static bool is_redrawn(const char *line)
{
    set_time("in/a.svg", 2000, 1);
    assert_int_equal(run(line), 0);
    return time_of("in/a.svg") != 2000;
}

static void updates_draw_what_is_newer(void **state)
{
    static const char plain[] = "--batch in --update a.off", labels[] = "--batch in --update --labels names a.off";
    (void)state;
    put_cube("a.off");
    put("names", "vertex,0,A\n");
    set_time("a.off", 1000, 0);
    set_time("names", 1000, 0);
    assert_int_equal(run(plain), 0);
    assert_int_equal(access("in/a.svg", F_OK), 0);
    assert_false(is_redrawn(plain));
    assert_false(is_redrawn("--batch in --update --hidden dashed a.off")); /* options are not compared */
    assert_true(is_redrawn("--batch in a.off"));
    set_time("a.off", 2000, 0);
    assert_false(is_redrawn(plain));
    set_time("a.off", 2000, 1); /* of one age */
    assert_true(is_redrawn(plain));
    set_time("a.off", 2000, 2);
    assert_true(is_redrawn(plain));
    set_time("a.off", 1000, 0);
    assert_false(is_redrawn(labels));
    set_time("names", 2000, 2);
    assert_true(is_redrawn(labels));
    put_cube("room");
    set_time("room", 1000, 0);
    assert_true(is_redrawn("--batch in --room-for room a.off"));
    assert_false(is_redrawn("--batch in --update --room-for room a.off"));
    set_time("room", 2000, 2);
    assert_true(is_redrawn("--batch in --update --room-for room a.off"));
    assert_int_equal(unlink("a.off"), 0);
    assert_int_equal(run(plain), 1);
    assert_said("roberts: a.off: No such file or directory\n");
}

/* The colours of an OBJ come from .mtl files in its folder. */
static void updates_look_at_materials(void **state)
{
    static const char *const lines[] = {"--batch in --update o/a.obj", "--batch in --update --manifest rows o/a.obj",
                                        "--batch in --update --list list"};
    (void)state;
    assert_int_equal(mkdir("o", 0777), 0);
    put("o/a.obj", "mtllib x.MTL\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    put("o/x.MTL", "newmtl m\n");
    put("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    put("list", "b.obj\no/a.obj\nmodels/table.off\n");
    set_time("o/a.obj", 1000, 0);
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        print_message("%s\n", lines[i]);
        set_time("o/x.MTL", 1000, 0);
        assert_int_equal(run(lines[i]), 0);
        assert_false(is_redrawn(lines[i]));
        set_time("o/x.MTL", 2000, 1); /* of one age */
        assert_true(is_redrawn(lines[i]));
        set_time("o/x.MTL", 2000, 0);
        assert_false(is_redrawn(lines[i]));
    }
    put("x.mtl", "newmtl m\n"); /* of another folder */
    set_time("x.mtl", 4000000000, 0);
    assert_false(is_redrawn(lines[0]));
}

static void updates_know_the_manifest(void **state)
{
    static const char plain[] = "--batch in --update --manifest rows a.off",
                      dashed[] = "--batch in --update --manifest rows --hidden dashed a.off";
    (void)state;
    put_cube("a.off");
    set_time("a.off", 1000, 0);
    assert_int_equal(run("--batch in a.off"), 0);
    assert_true(is_redrawn(plain)); /* there is no row yet */
    assert_false(is_redrawn(plain));
    assert_int_equal(rows_with("\n"), 1);
    assert_true(is_redrawn(dashed));
    assert_false(is_redrawn(dashed));
    assert_true(is_redrawn(plain)); /* the last row counts */
    assert_true(is_redrawn("--batch in --update --manifest rows --epsilon 1e-7 a.off"));
    assert_false(is_redrawn("--batch in --update --manifest rows --epsilon 1e-7 --threads 1 --grid 7 a.off"));
    assert_true(is_redrawn(plain));
    assert_int_equal(rows_with("\n"), 5);
    /* a file that has failed, beside an older drawing */
    put("a.off", "OFF\n");
    assert_int_equal(run(plain), 1);
    assert_int_equal(rows_with("\n"), 6);
    put_cube("a.off");
    set_time("a.off", 1000, 0);
    assert_true(is_redrawn(plain));
    assert_false(is_redrawn(plain));
    assert_int_equal(run("--batch in --update --manifest rows -v a.off models/table.off"), 0);
    assert_said("roberts: 1 file drawn, 1 up to date, 0 failed; ");
}

/* ---- limits, and workers that die ---- */

static const char late_line[] = "--batch in --manifest rows --limit-seconds 0.4 models/table.off pipe models/tower.off";

static void late_files_are_given_up(void **state)
{
    (void)state;
    assert_int_equal(mkfifo("pipe", 0600), 0); /* nobody writes to it: reading never ends */
    for (int threads = 1; threads <= 3; threads++) {
        char line[200];
        snprintf(line, sizeof line, "%s --threads %d", late_line, threads);
        unlink("rows");
        assert_int_equal(run(line), 1);
        assert_string_equal(last.err, "roberts: pipe: it takes too long: --limit-seconds allows 0.4 s\n"
                                      "roberts: 1 of 3 models was not drawn\n");
        assert_int_equal(entries("in", true), 2);
        assert_int_equal(rows_with("\"error\":null"), 2);
        assert_int_equal(rows_with("\"error\":\"it takes too long: --limit-seconds allows 0.4 s\",\"seconds\":0.4"), 1);
    }
}

/* A file of so many points that it needs more than ten MB. */
static void put_large(const char *path)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs("OFF\n300004 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n", file);
    for (int i = 0; i < 300000; i++)
        fputs("0 0 0\n", file);
    fputs("3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", file);
    fclose(file);
}

static void large_files_are_given_up(void **state)
{
    (void)state;
    if (SANITIZED)
        SKIP_BECAUSE("a sanitizer needs more memory");
    put_large("large.off");
    assert_int_equal(run("--batch in --manifest rows --limit-memory 8 --threads 1 models/table.off large.off "
                         "models/tower.off"),
                     1);
    assert_string_equal(last.err, "roberts: large.off: not enough memory: --limit-memory allows 8 MB\n"
                                  "roberts: 1 of 3 models was not drawn\n");
    assert_int_equal(rows_with("\"error\":null"), 2);
    assert_int_equal(rows_with("\"error\":\"large.off: not enough memory: --limit-memory allows 8 MB\","), 1);
    assert_int_equal(entries("in", true), 2);
    assert_int_equal(run("--batch in --limit-memory 200 models/table.off large.off models/tower.off"), 0);
}

/* The limit is for each file: whether one is drawn does not depend on those before it. */
static void limits_are_fair(void **state)
{
    bool drawn = false, refused = false;
    (void)state;
    if (SANITIZED)
        SKIP_BECAUSE("a sanitizer needs more memory");
    for (int mb = 1; mb <= 16; mb += 3) {
        char line[300];
        snprintf(line, sizeof line, "--batch in -f png --dpi 100 -q --threads 1 --limit-memory %d models/lattice.off",
                 mb);
        const int alone = run(line);
        assert_int_equal(entries("in", true), alone == 0);
        snprintf(line, sizeof line,
                 "--batch in -f png --dpi 100 -q --threads 1 --limit-memory %d models/table.off models/city.off "
                 "models/menger-sponge.off models/lattice.off",
                 mb);
        run(line);
        assert_int_equal(access("in/lattice.png", F_OK) == 0, alone == 0);
        entries("in", true);
        drawn = drawn || alone == 0;
        refused = refused || alone == 1;
    }
    assert_true(drawn && refused);
}

/* The one worker of a running process; 0: there is none (yet). */
static pid_t worker_of(pid_t parent)
{
    char name[64];
    int worker = 0;
    snprintf(name, sizeof name, "/proc/%d/task/%d/children", (int)parent, (int)parent);
    FILE *file = fopen(name, "r");
    if (file && fscanf(file, "%d", &worker) != 1)
        worker = 0;
    if (file)
        fclose(file);
    return worker;
}

static void rest(void)
{
    nanosleep(&(struct timespec){0, 1000000}, NULL);
}

/* Long enough for a worker to take the next file. */
static void rest_long(void)
{
    nanosleep(&(struct timespec){0, 100000000}, NULL);
}

static void skip_without_children(void)
{
    char own[64];
    snprintf(own, sizeof own, "/proc/self/task/%d/children", (int)getpid());
    if (access(own, R_OK) != 0)
        SKIP_BECAUSE("/proc does not tell the children of a process");
}

static void dead_workers_harm_one_file(void **state)
{
    (void)state;
    skip_without_children();
    assert_int_equal(mkfifo("pipe", 0600), 0);
    pid_t parent = start("--batch in --manifest rows --threads 1 models/table.off pipe models/tower.off", NULL, -1);
    pid_t first = 0, second = 0;
    for (int i = 0; i < 10000 && (first == 0 || access("in/table.svg", F_OK) != 0); i++, rest())
        first = worker_of(parent);
    assert_true(first > 0);
    rest_long();
    kill(first, SIGKILL); /* it has drawn the table, so a fresh one tries the pipe again */
    for (int i = 0; i < 10000 && (second == 0 || second == first); i++, rest())
        second = worker_of(parent);
    assert_true(second > 0 && second != first);
    rest_long();
    assert_int_equal(access("in/tower.svg", F_OK), -1);
    kill(second, SIGKILL);
    finish(parent);
    assert_int_equal(last.status, 1);
    assert_string_equal(last.err, "roberts: pipe: the process that draws it was ended by signal 9 (Killed)\n"
                                  "roberts: 1 of 3 models was not drawn\n");
    assert_int_equal(rows_with("\"error\":null"), 2);
    assert_int_equal(
        rows_with("{\"file\":\"pipe\",\"output\":\"in/pipe.svg\",\"command\":\"roberts pipe\",\"error\":\"the "
                  "process that draws it was ended by signal 9 (Killed)\",\"seconds\":"),
        1);
    assert_int_equal(entries("in", true), 2);
}

/* ---- runs that are killed ---- */

/* A worker in the middle of a file that never ends. Its standard error is the end of a pipe. */
static void workers_end_with_their_run(void **state)
{
    int ends[2];
    (void)state;
    skip_without_children();
    assert_int_equal(mkfifo("pipe", 0600), 0);
    assert_int_equal(pipe(ends), 0);
    start_error = ends[1];
    pid_t parent = start("--batch in --threads 2 pipe", NULL, -1);
    start_error = -1;
    close(ends[1]);
    for (int i = 0; i < 10000 && worker_of(parent) == 0; i++)
        rest();
    rest_long();
    kill(parent, SIGKILL);
    finish(parent);
    struct pollfd end = {.fd = ends[0], .events = POLLIN};
    const bool ended = poll(&end, 1, 10000) == 1;
    close(ends[0]);
    close(open("pipe", O_RDWR)); /* a remaining reader would end with that */
    assert_true(ended);
}

static const char killed_line[] = "--batch in -f png --dpi 200 --manifest rows --update --threads 2 models/table.off "
                                  "models/city.off models/tower.off models/chair.off";

/* Kills the run while there is an unfinished file; false if the run was faster. */
static bool is_killed(int number)
{
    int ends[2];
    char byte;
    bool seen = false;
    assert_int_equal(pipe(ends), 0);
    start_error = ends[1];
    pid_t parent = start(killed_line, NULL, -1);
    start_error = -1;
    close(ends[1]);
    for (int i = 0; i < 10000 && !seen; i++, rest()) {
        DIR *directory = opendir("in");
        for (struct dirent *entry; (entry = readdir(directory));)
            seen = seen || strncmp(entry->d_name, ".roberts", 8) == 0;
        closedir(directory);
        if (!seen && waitpid(parent, NULL, WNOHANG) == parent) {
            close(ends[0]);
            return false;
        }
    }
    kill(parent, number);
    finish(parent);
    while (read(ends[0], &byte, 1) > 0) /* until the last worker has ended as well */
        ;
    close(ends[0]);
    return last.status == 1000 + number;
}

static void killed_runs_go_on(void **state)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGKILL};
    (void)state;
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
        bool done = false;
        for (int attempt = 0; attempt < 10 && !done; attempt++) {
            unlink("rows");
            entries("in", true);
            done = is_killed(signals[i]);
            DIR *directory = opendir("in");
            for (struct dirent *entry; (entry = readdir(directory));)
                if (strncmp(entry->d_name, ".roberts", 8) == 0)
                    fail_msg("signal %d leaves %s", signals[i], entry->d_name);
            closedir(directory);
        }
        assert_true(done);
        const int before = rows_with("\n");
        assert_true(before < 4);
        assert_int_equal(run(killed_line), 0);
        assert_int_equal(rows_with("\"error\":null"), 4);
        assert_int_equal(rows_with("\n"), 4);
        assert_int_equal(entries("in", false), 4);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(lists_name_files),
        IN_FOLDER(lists_can_be_wrong),
        IN_FOLDER(a_name_given_twice_is_drawn_once),
        IN_FOLDER(shards_draw_each_file_once),
        IN_FOLDER(drawings_keep_their_folders),
        IN_FOLDER(rows_tell),
        IN_FOLDER(rows_that_were_cut_go),
        IN_FOLDER(manifests_can_be_wrong),
        IN_FOLDER(updates_draw_what_is_newer),
        IN_FOLDER(updates_look_at_materials),
        IN_FOLDER(updates_know_the_manifest),
        IN_FOLDER(late_files_are_given_up),
        IN_FOLDER(large_files_are_given_up),
        IN_FOLDER(limits_are_fair),
        IN_FOLDER(dead_workers_harm_one_file),
        IN_FOLDER(workers_end_with_their_run),
        IN_FOLDER(killed_runs_go_on),
    };
    if (!program_find())
        return 1;
    return cmocka_run_group_tests_name("batches", tests, NULL, NULL);
}
