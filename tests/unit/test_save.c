/* Files appear whole or not at all; links, modes, devices and pipes stay what they are. */
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "drawing.h"
#include "temporary.h"
#include "testing.h"

#define TABLE                                                                                                          \
    "body,v0,v1,t0,t1,state,x0,y0,x1,y1,by,class,f0,f1\n"                                                              \
    "0,0,1,0,1,visible,1,2,3,4,,outline,,\n"

static roberts_draw_options table_options(void)
{
    roberts_draw_options options = roberts_draw_options_default();
    options.format = ROBERTS_CSV;
    return options;
}

static roberts_status save(const char *path, roberts_error *error)
{
    roberts_segment one = line_at(ROBERTS_OUTLINE, 1, 2, 3, 4);
    roberts_drawing drawing = {.count = 1, .segment = &one};
    roberts_draw_options options = table_options();
    return roberts_drawing_save(&drawing, &options, path, error);
}

static void put(const char *path, const char *text, mode_t mode)
{
    int descriptor = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    assert_true(descriptor >= 0);
    assert_int_equal(write(descriptor, text, strlen(text)), strlen(text));
    assert_int_equal(fchmod(descriptor, mode), 0);
    close(descriptor);
}

static void assert_holds(const char *path, const char *wanted)
{
    char text[512];
    int descriptor = open(path, O_RDONLY);
    assert_true(descriptor >= 0);
    ssize_t size = read(descriptor, text, sizeof text - 1);
    close(descriptor);
    assert_true(size >= 0);
    text[size] = '\0';
    assert_string_equal(text, wanted);
}

static mode_t mode_of(const char *path)
{
    struct stat status;
    assert_int_equal(lstat(path, &status), 0);
    return status.st_mode;
}

static int enter_folder(void **state)
{
    return temporary_make(state) == 0 && chdir(temporary) == 0 ? mkdir("in", 0777) : -1;
}

static int leave_folder(void **state)
{
    return chdir("/") == 0 ? temporary_remove(state) : -1;
}

/* ---- files ---- */

static void new_file(void **state)
{
    (void)state;
    mode_t before = umask(027);
    assert_int_equal(save("in/a.csv", NULL), ROBERTS_OK);
    umask(before);
    assert_holds("in/a.csv", TABLE);
    assert_int_equal(mode_of("in/a.csv"), S_IFREG | 0640);
    assert_int_equal(entries("in", false), 1);
}

static void old_file_keeps_its_mode(void **state)
{
    static const mode_t modes[] = {0600, 0640, 0666, 0755, 04755};
    (void)state;
    for (size_t i = 0; i < sizeof modes / sizeof modes[0]; i++) {
        put("in/a.csv", "something longer than what comes in its place: it must not be left over at the end......",
            modes[i]);
        assert_int_equal(save("in/a.csv", NULL), ROBERTS_OK);
        assert_holds("in/a.csv", TABLE);
        assert_int_equal(mode_of("in/a.csv"), S_IFREG | modes[i]);
        assert_int_equal(entries("in", false), 1);
    }
}

static void names_of_all_kinds(void **state)
{
    char longest[256];
    (void)state;
    memset(longest, 'n', 255);
    longest[255] = '\0';
    assert_int_equal(save(longest, NULL), ROBERTS_OK);
    assert_holds(longest, TABLE);
    assert_int_equal(save("in/../in/./\xe2\x98\xa0 \n%s", NULL), ROBERTS_OK);
    assert_holds("in/\xe2\x98\xa0 \n%s", TABLE);
}

static const struct {
    const char *name, *link, *target, *holds; /* `holds`: the file that must have the bytes */
} link_cases[] = {
    {"in its folder", "l", "a", "a"},
    {"into another folder", "l", "in/a", "in/a"},
    {"out of a folder", "in/l", "../a", "a"},
    {"beside, in a folder", "in/l", "a", "in/a"},
};

static void links_are_followed(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof link_cases / sizeof link_cases[0]; i++)
        for (int exists = 0; exists < 2; exists++) {
            print_message("%s, target %s\n", link_cases[i].name, exists ? "exists" : "is missing");
            assert_int_equal(symlink(link_cases[i].target, link_cases[i].link), 0);
            if (exists)
                put(link_cases[i].holds, "old", 0604);
            assert_int_equal(save(link_cases[i].link, NULL), ROBERTS_OK);
            assert_true(S_ISLNK(mode_of(link_cases[i].link)));
            assert_holds(link_cases[i].holds, TABLE);
            if (exists)
                assert_int_equal(mode_of(link_cases[i].holds), S_IFREG | 0604);
            assert_int_equal(unlink(link_cases[i].link), 0);
            assert_int_equal(unlink(link_cases[i].holds), 0);
        }
    assert_int_equal(entries(".", false), 1);
}

static void chains_of_links(void **state)
{
    char target[TEMPORARY_ROOM + 5];
    (void)state;
    snprintf(target, sizeof target, "%s/in/a", temporary);
    assert_int_equal(symlink(target, "in/1"), 0);
    assert_int_equal(symlink("in/1", "2"), 0);
    assert_int_equal(symlink("2", "3"), 0);
    assert_int_equal(save("3", NULL), ROBERTS_OK);
    assert_holds("in/a", TABLE);
    assert_true(S_ISLNK(mode_of("2")) && S_ISLNK(mode_of("in/1")));
}

/* ---- what is no regular file ---- */

static void pipes_are_written_in_place(void **state)
{
    char text[512];
    (void)state;
    assert_int_equal(mkfifo("p", 0600), 0);
    int reader = open("p", O_RDONLY | O_NONBLOCK);
    assert_true(reader >= 0);
    assert_int_equal(save("p", NULL), ROBERTS_OK);
    assert_int_equal(read(reader, text, sizeof text), strlen(TABLE));
    assert_memory_equal(text, TABLE, strlen(TABLE));
    assert_true(S_ISFIFO(mode_of("p")));
    close(reader);
}

static void devices_are_written_in_place(void **state)
{
    (void)state;
    mode_t before = mode_of("/dev/null");
    assert_int_equal(save("/dev/null", NULL), ROBERTS_OK);
    assert_int_equal(mode_of("/dev/null"), before);
    if (access("/dev/full", W_OK) != 0)
        SKIP_BECAUSE("no /dev/full");
    roberts_error error = {0};
    assert_int_equal(save("/dev/full", &error), ROBERTS_IO);
    assert_string_equal(error.file, "/dev/full");
    assert_string_equal(error.message, "cannot write: No space left on device");
}

static void descriptors_go_on_where_they_are(void **state)
{
    char name[64];
    roberts_error error = {0};
    (void)state;
    put("a", "before\n", 0600);
    int descriptor = open("a", O_WRONLY | O_APPEND);
    assert_true(descriptor >= 0);
    snprintf(name, sizeof name, "/dev/fd/%d", descriptor);
    assert_int_equal(save(name, NULL), ROBERTS_OK);
    assert_holds("a", "before\n" TABLE);
    assert_int_equal(symlink(name, "l"), 0);
    assert_int_equal(save("l", NULL), ROBERTS_OK);
    assert_holds("a", "before\n" TABLE TABLE);
    close(descriptor);
    assert_int_equal(save(name, &error), ROBERTS_IO);
    assert_string_equal(error.message, "cannot write: Bad file descriptor");
}

static void closed_pipe(void **state)
{
    int ends[2];
    char name[64];
    roberts_error error = {0};
    (void)state;
    signal(SIGPIPE, SIG_IGN);
    assert_int_equal(pipe(ends), 0);
    close(ends[0]);
    snprintf(name, sizeof name, "/dev/fd/%d", ends[1]);
    assert_int_equal(save(name, &error), ROBERTS_IO);
    assert_string_equal(error.message, "cannot write: Broken pipe");
    close(ends[1]);
}

/* ---- failures ---- */

static const struct {
    const char *path, *message;
} failure_cases[] = {
    {"in", "cannot write: Is a directory"},
    {"in/", "cannot write: Is a directory"},
    {"new/", "cannot write: Is a directory"},
    {"missing/a.csv", "cannot write: No such file or directory"},
    {"file/a.csv", "cannot write: Not a directory"},
    {"loop", "cannot write: Too many levels of symbolic links"},
    {"", "cannot write: No such file or directory"},
    {"/dev/fd/987654", "cannot write: Bad file descriptor"},
    {"/dev/fd/1x", NULL}, /* no number: any message of the system */
};

static void failures(void **state)
{
    (void)state;
    put("file", "old", 0600);
    assert_int_equal(symlink("loop", "loop"), 0);
    for (size_t i = 0; i < sizeof failure_cases / sizeof failure_cases[0]; i++) {
        roberts_error error = {0};
        print_message("\"%s\"\n", failure_cases[i].path);
        assert_int_equal(save(failure_cases[i].path, &error), ROBERTS_IO);
        assert_string_equal(error.file, failure_cases[i].path);
        if (failure_cases[i].message)
            assert_string_equal(error.message, failure_cases[i].message);
    }
    assert_holds("file", "old");
    assert_int_equal(entries(".", false), 3);
    assert_int_equal(entries("in", false), 0);
}

/* In a child without root's rights: it does not replace files that it may not write. */
static void protected_files_and_folders(void **state)
{
    int status;
    (void)state;
    put("in/a.csv", "old", 0444);
    assert_int_equal(chmod(temporary, 0755), 0);
    assert_int_equal(chmod("in", 0777), 0);
    pid_t child = fork();
    if (child == 0) {
        roberts_error error = {0};
        if (geteuid() == 0 && seteuid(65534) != 0)
            _exit(2);
        bool file = save("in/a.csv", &error) == ROBERTS_IO && strstr(error.message, "Permission denied");
        bool place = geteuid() != 65534 || (save("b.csv", &error) == ROBERTS_IO && strstr(error.message, "denied"));
        bool other = save("in/b.csv", &error) == ROBERTS_OK;
        _exit(file && place && other ? 0 : 1);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    assert_holds("in/a.csv", "old");
    assert_holds("in/b.csv", TABLE);
    assert_int_equal(entries("in", false), 2);
    assert_int_equal(entries(".", false), 1);
}

/* The limit on file sizes stands for a disk that fills up in the middle. */
static void full_disk_leaves_the_old_file(void **state)
{
    size_t count = 5000;
    roberts_drawing drawing = {.count = count, .segment = malloc(count * sizeof(roberts_segment))};
    roberts_draw_options options = table_options();
    struct rlimit limit, low;
    (void)state;
    assert_non_null(drawing.segment);
    for (size_t i = 0; i < count; i++)
        drawing.segment[i] = line_at(ROBERTS_OUTLINE, (double)i, 0.1, 0.2, 0.3);
    put("in/a.csv", "old", 0604);
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &limit), 0);
    low = limit;
    for (rlim_t size = 0; size <= 150000; size += 50000) {
        roberts_error error = {0};
        low.rlim_cur = size;
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &low), 0);
        roberts_status old = roberts_drawing_save(&drawing, &options, "in/a.csv", &error);
        roberts_status new = roberts_drawing_save(&drawing, &options, "in/b.csv", &error);
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
        assert_int_equal(old, ROBERTS_IO);
        assert_int_equal(new, ROBERTS_IO);
        assert_string_equal(error.message, "cannot write: File too large");
        assert_holds("in/a.csv", "old");
        assert_int_equal(mode_of("in/a.csv"), S_IFREG | 0604);
        assert_int_equal(entries("in", false), 1);
    }
    free(drawing.segment);
}

static void bad_drawing_leaves_the_old_file(void **state)
{
    roberts_segment bad = line_at(ROBERTS_OUTLINE, 0, 0, 1, NAN);
    roberts_drawing drawing = {.count = 1, .segment = &bad};
    roberts_draw_options options = table_options();
    roberts_error error = {0};
    (void)state;
    put("in/a.csv", "old", 0600);
    assert_int_equal(roberts_drawing_save(&drawing, &options, "in/a.csv", &error), ROBERTS_BAD_NUMBER);
    assert_string_equal(error.file, "in/a.csv");
    assert_int_equal(roberts_drawing_save(&drawing, &options, "in/b.csv", &error), ROBERTS_BAD_NUMBER);
    assert_holds("in/a.csv", "old");
    assert_int_equal(entries("in", false), 1);
}

static void null_writes_nothing(void **state)
{
    roberts_segment one = line_at(ROBERTS_OUTLINE, 0, 0, 1, 1);
    roberts_drawing drawing = {.count = 1, .segment = &one};
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    options.format = ROBERTS_NULL;
    put("in/a", "old", 0600);
    assert_int_equal(roberts_drawing_save(&drawing, &options, "in/a", NULL), ROBERTS_OK);
    assert_int_equal(roberts_drawing_save(&drawing, &options, "in/b", NULL), ROBERTS_OK);
    assert_holds("in/a", "old");
    assert_int_equal(entries("in", false), 1);
}

/* ---- where the unfinished file is ---- */

typedef struct announced {
    int calls;
    char name[256];
    bool early, folder;
} announced;

static void take_name(void *context, const char *path)
{
    announced *a = context;
    a->calls++;
    if (path) {
        snprintf(a->name, sizeof a->name, "%s", path);
        a->early = access(path, F_OK) != 0;
        a->folder = strncmp(path, "in/", 3) == 0;
    } else {
        a->early = a->early && access(a->name, F_OK) != 0;
    }
}

static void unfinished_file_is_announced(void **state)
{
    roberts_segment one = line_at(ROBERTS_OUTLINE, 0, 0, 1, 1);
    roberts_drawing drawing = {.count = 1, .segment = &one};
    roberts_draw_options options = table_options();
    announced a = {0};
    (void)state;
    options.temporary = take_name;
    options.temporary_context = &a;
    assert_int_equal(roberts_drawing_save(&drawing, &options, "in/a", NULL), ROBERTS_OK);
    assert_int_equal(a.calls, 2);
    assert_true(a.early && a.folder);
    assert_int_equal(roberts_drawing_save(&drawing, &options, "missing/a", NULL), ROBERTS_IO);
    assert_int_equal(a.calls, 4);
    assert_int_equal(roberts_drawing_save(&drawing, &options, "/dev/null", NULL), ROBERTS_OK);
    assert_int_equal(a.calls, 4);
}

/* Leaves the unfinished file of a process that was killed while saving in/a; the file is called `name`. */
static void leave_unfinished(char name[300])
{
    announced a = {0};
    roberts_segment one = line_at(ROBERTS_OUTLINE, 0, 0, 1, 1);
    roberts_drawing drawing = {.count = 1, .segment = &one};
    roberts_draw_options options = table_options();
    options.temporary = take_name;
    options.temporary_context = &a;
    assert_int_equal(roberts_drawing_save(&drawing, &options, "in/a", NULL), ROBERTS_OK);
    assert_int_equal(unlink("in/a"), 0);
    snprintf(name, 300, "%s", a.name);
    put(name, "half of a table", 0600); /* what the killed process had written */
}

static void what_a_killed_run_has_left_is_removed(void **state)
{
    char name[300];
    (void)state;
    leave_unfinished(name);
    assert_int_equal(entries("in", false), 1);
    assert_int_equal(save("in/b", NULL), ROBERTS_OK); /* another file's: it stays */
    assert_int_equal(entries("in", false), 2);
    assert_int_equal(save("in/a", NULL), ROBERTS_OK);
    assert_holds("in/a", TABLE);
    assert_int_equal(entries("in", false), 2);
}

static void what_is_being_written_stays(void **state)
{
    char name[300];
    (void)state;
    leave_unfinished(name);
    int other = open(name, O_WRONLY);
    assert_true(other >= 0);
    assert_int_equal(flock(other, LOCK_EX | LOCK_NB), 0);
    assert_int_equal(save("in/a", NULL), ROBERTS_OK);
    assert_holds("in/a", TABLE);
    assert_holds(name, "half of a table");
    close(other);
    assert_int_equal(save("in/a", NULL), ROBERTS_OK);
    assert_int_equal(entries("in", false), 1);
}

/* A link or a folder of that name is no unfinished file. */
static void what_is_no_unfinished_file_stays(void **state)
{
    char name[300];
    (void)state;
    leave_unfinished(name);
    put("in/own", "something", 0600);
    assert_int_equal(unlink(name), 0);
    assert_int_equal(symlink("own", name), 0);
    assert_int_equal(save("in/a", NULL), ROBERTS_OK);
    assert_holds("in/own", "something");
    assert_int_equal(unlink(name), 0);
    assert_int_equal(mkdir(name, 0700), 0);
    assert_int_equal(save("in/a", NULL), ROBERTS_OK);
    assert_holds("in/a", TABLE);
    assert_int_equal(entries("in", false), 3);
}

#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, enter_folder, leave_folder)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(new_file),
        IN_FOLDER(old_file_keeps_its_mode),
        IN_FOLDER(names_of_all_kinds),
        IN_FOLDER(links_are_followed),
        IN_FOLDER(chains_of_links),
        IN_FOLDER(pipes_are_written_in_place),
        IN_FOLDER(devices_are_written_in_place),
        IN_FOLDER(descriptors_go_on_where_they_are),
        IN_FOLDER(closed_pipe),
        IN_FOLDER(failures),
        IN_FOLDER(protected_files_and_folders),
        IN_FOLDER(full_disk_leaves_the_old_file),
        IN_FOLDER(bad_drawing_leaves_the_old_file),
        IN_FOLDER(null_writes_nothing),
        IN_FOLDER(unfinished_file_is_announced),
        IN_FOLDER(what_a_killed_run_has_left_is_removed),
        IN_FOLDER(what_is_being_written_stays),
        IN_FOLDER(what_is_no_unfinished_file_stays),
    };
    return cmocka_run_group_tests_name("save", tests, NULL, NULL);
}
