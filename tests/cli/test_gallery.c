/* test_gallery.c - the program draws the pictures of the README's gallery by the commands given there: none is missing,
 * none is left over; each is shown, and small. With the same version of Cairo they are the same bytes; with another
 * one, which may write numbers differently, the same lines. */
#include <cairo.h>
#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "folders.h"
#include "temporary.h"
#include "testing.h"

enum { LARGEST = 100000 /* bytes of a picture */, README_ROOM = 1 << 17, DRAWN_WITH = CAIRO_VERSION_ENCODE(1, 16, 0) };

static const char committed[] = "models/gallery"; /* those drawn now are in `temporary` */

static int set_up(void **state)
{
    char command[4096];
    if (temporary_make(state) != 0)
        return -1;
    snprintf(command, sizeof command, "ROBERTS_BUILD='%s' tools/draw-gallery.sh '%s'", build_folder(), temporary);
    return system(command); /* NOLINT(cert-env33-c): the gallery's commands are shell commands */
}

/* Reads at most `room` bytes of the file, and returns their number; 0: it is not there. */
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

static const char blank[] = " ,\n"; /* between numbers */

/* Skips separators, and a number if one begins there. */
static bool take_number(const char **at, double *number)
{
    char *end;
    *at += strspn(*at, blank);
    bool begins = **at && strchr("+-.0123456789", **at);
    *number = begins ? strtod(*at, &end) : 0.0;
    *at = begins ? end : *at;
    return begins;
}

/* Whether the data of two paths, each up to its quote, are the same commands with the same numbers, to the last digit
 * that is printed. Both move on. */
static bool same_path(const char **a, const char **b)
{
    const double last_digit = 0.001 + 1e-9; /* mm */
    while (**a && **a != '"') {
        double x, y;
        bool number = take_number(a, &x);
        if (number != take_number(b, &y) || fabs(x - y) > last_digit || (!number && **a != **b))
            return false;
        if (!number && **a && **a != '"') {
            ++*a;
            ++*b;
        }
    }
    *b += strspn(*b, blank);
    return **a == **b;
}

/* Everything else must be the same, byte for byte. */
static bool same_lines(const char *a, const char *b)
{
    static const char path[] = " d=\"";
    const size_t length = sizeof path - 1;
    while (*a && *a == *b) {
        if (strncmp(a, path, length) == 0 && strncmp(b, path, length) == 0) {
            a += length;
            b += length;
            if (!same_path(&a, &b))
                return false;
        } else {
            a++;
            b++;
        }
    }
    return *a == *b;
}

static void compare(const char *name)
{
    static char old[LARGEST + 1], new[LARGEST + 1];
    size_t old_size = contents(committed, name, old, LARGEST), new_size = contents(temporary, name, new, LARGEST);
    if (new_size == LARGEST)
        fail_msg("%s: too large", name);
    old[old_size] = new[new_size] = '\0';
    bool same_bytes = old_size == new_size && memcmp(old, new, new_size) == 0;
    if (!same_lines(old, new) || (!same_bytes && cairo_version() == DRAWN_WITH))
        fail_msg("%s is not what the program draws (make gallery)", name);
}

/* Which paths the comparison accepts as the same, and which not. */
static void lines_are_compared(void **state)
{
    static const char one[] = "<path w=\"0.5\" d=\"M 1 2 L 3.25 4 Z M 5 6 L 7 8\"/>\n";
    static const struct {
        const char *other;
        bool same;
    } table[] = {
        {one, true},
        {"<path w=\"0.5\" d=\"M 1,2.000 L 3.2509 4 Z\nM 5 6 L 7 8 \"/>\n", true},
        {"<path w=\"0.5\" d=\"M1 2L3.25 4ZM5 6L7 8\"/>\n", true},
        {"<path w=\"0.5\" d=\"M 1 2 L 3.252 4 Z M 5 6 L 7 8\"/>\n", false},
        {"<path w=\"0.5\" d=\"M 1 2 L 3.25 4 M 5 6 L 7 8\"/>\n", false},
        {"<path w=\"0.5\" d=\"M 1 2 L 3.25 4 Z M 5 6\"/>\n", false},
        {"<path w=\"0.5\" d=\"M 1 2 L 3.25 4 Z M 5 6 L 7 8 9\"/>\n", false},
        {"<path w=\"0.5\" d=\"M 1 2 L 3.25 4 Z M 5 6 L 7 8\"/>", false},
        {"<path w=\"0.501\" d=\"M 1 2 L 3.25 4 Z M 5 6 L 7 8\"/>\n", false},
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
        if (same_lines(one, table[i].other) != table[i].same || same_lines(table[i].other, one) != table[i].same)
            fail_msg("%s", table[i].other);
}

static void pictures_are_what_the_program_draws(void **state)
{
    (void)state;
    size_t count = each_picture(temporary, compare);
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
        snprintf(name, sizeof name, "%.*s", (int)strcspn(at + 15, "\")"), at + 15);
        if (contents(committed, name, &byte, 1) == 0)
            fail_msg("there is no %s", name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_are_compared),
        cmocka_unit_test(pictures_are_what_the_program_draws),
        cmocka_unit_test(pictures_are_shown),
    };
    return cmocka_run_group_tests_name("gallery", tests, set_up, temporary_remove);
}
