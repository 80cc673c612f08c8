/* test_gallery.c - the pictures of the README's gallery are what the program draws by the commands that stand there: the
 * same bytes, none missing, none left over; each is shown, and small. */
#include <dirent.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { LARGEST = 100000 /* bytes of a picture */, README_ROOM = 1 << 17 };

static const char committed[] = "models/gallery";
static char drawn[] = "/tmp/roberts-gallery-XXXXXX"; /* made by set_up() */

static int shell(const char *command)
{
    return system(command); /* NOLINT(cert-env33-c): the gallery's commands are shell commands */
}

static int set_up(void **state)
{
    char command[4096];
    const char *build = getenv("ROBERTS_BUILD");
    (void)state;
    if (!mkdtemp(drawn))
        return -1;
    snprintf(command, sizeof command, "ROBERTS_BUILD='%s' tools/draw-gallery.sh %s", build ? build : "build", drawn);
    return shell(command);
}

static int tear_down(void **state)
{
    char command[256];
    (void)state;
    snprintf(command, sizeof command, "rm -rf %s", drawn);
    return shell(command);
}

/* The file's bytes, at most `room`; their number. 0: not there. */
static size_t contents(const char *folder, const char *name, char *bytes, size_t room)
{
    char path[600];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "r");
    size_t size = file ? fread(bytes, 1, room, file) : 0;
    if (file)
        (void)fclose(file);
    return size;
}

/* Calls `use` for each picture of a folder; returns how many there are. */
static size_t each_picture(const char *folder, void use(const char *name))
{
    size_t count = 0;
    DIR *opened = opendir(folder);
    assert_non_null(opened);
    for (struct dirent *entry; (entry = readdir(opened));)
        if (strstr(entry->d_name, ".svg")) {
            use(entry->d_name);
            count++;
        }
    (void)closedir(opened);
    return count;
}

static void compare(const char *name)
{
    static char old[LARGEST], new[LARGEST];
    size_t old_size = contents(committed, name, old, LARGEST), new_size = contents(drawn, name, new, LARGEST);
    if (new_size == LARGEST)
        fail_msg("%s: too large", name);
    if (old_size != new_size || memcmp(old, new, new_size) != 0)
        fail_msg("%s is not what the program draws (make gallery)", name);
}

static void pictures_are_what_the_program_draws(void **state)
{
    (void)state;
    size_t count = each_picture(drawn, compare);
    print_message("%zu pictures\n", count);
    assert_true(count >= 12);
    assert_int_equal(each_picture(committed, compare), count);
}

static char readme[README_ROOM];

static void expect_shown(const char *name)
{
    char image[300];
    snprintf(image, sizeof image, "<img src=\"models/gallery/%s\"", name);
    if (!strstr(readme, image))
        fail_msg("the README does not show %s", name);
}

static void pictures_are_shown(void **state)
{
    (void)state;
    readme[contents(".", "README.md", readme, sizeof readme - 1)] = '\0';
    (void)each_picture(committed, expect_shown);
    for (const char *at = readme; (at = strstr(at, "models/gallery/")); at++) {
        char name[100], byte;
        snprintf(name, sizeof name, "%.*s", (int)strcspn(at + 15, "\""), at + 15);
        if (contents(committed, name, &byte, 1) == 0)
            fail_msg("there is no %s", name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_what_the_program_draws),
        cmocka_unit_test(pictures_are_shown),
    };
    return cmocka_run_group_tests_name("gallery", tests, set_up, tear_down);
}
