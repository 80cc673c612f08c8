/* The manual page and the completions have the options of --help, and the README names no other ones. */
#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "folders.h"
#include "testing.h"

enum { TEXT = 1 << 17, OPTIONS = 200 };

static char help[TEXT], option[OPTIONS][32]; /* "--output", and "-o" if it has a letter */
static int option_count;

static void read_stream(FILE *stream, char text[TEXT])
{
    assert_non_null(stream);
    size_t size = fread(text, 1, TEXT - 1, stream);
    text[size] = '\0';
}

/* Where make puts the manual page and the completions. */
static const char *in_build(const char *name)
{
    static char path[4096];
    snprintf(path, sizeof path, "%s/%s", build_folder(), name);
    return path;
}

static void read_file(const char *path, char text[TEXT])
{
    FILE *file = fopen(path, "r");
    print_message("%s\n", path);
    read_stream(file, text);
    fclose(file);
}

static size_t word_length(const char *word)
{
    size_t length = 0;
    while (word[length] == '-' || isalnum((unsigned char)word[length]))
        length++;
    return length;
}

/* The options that the lines of the help begin with. */
static int set_up(void **state)
{
    char command[4096];
    (void)state;
    snprintf(command, sizeof command, "'%s/roberts' --help", build_folder());
    FILE *pipe = popen(command, "r");
    read_stream(pipe, help);
    if (pclose(pipe) != 0)
        return -1;
    for (const char *line = help; line; line = strchr(line, '\n') ? strchr(line, '\n') + 1 : NULL) {
        const char *word = line + strspn(line, " ");
        if (strncmp(line, "  -", 3) == 0 || strncmp(line, "      --", 8) == 0)
            for (int i = 0; i < 2 && *word == '-'; i++) {
                size_t length = word_length(word);
                snprintf(option[option_count++], sizeof option[0], "%.*s", (int)length, word);
                word += length;
                word += strspn(word, ", ");
            }
    }
    return option_count > 20 ? 0 : -1;
}

/* `word`, not as a part of another option's name. */
static bool has_word(const char *text, const char *word)
{
    size_t length = strlen(word);
    for (const char *at = text; (at = strstr(at, word)); at++) {
        bool begins = at == text || !(isalnum((unsigned char)at[-1]) || at[-1] == '-');
        if (begins && word_length(at) == length)
            return true;
    }
    return false;
}

static bool is_option(const char *word, size_t length)
{
    for (int i = 0; i < option_count; i++)
        if (strlen(option[i]) == length && strncmp(option[i], word, length) == 0)
            return true;
    return false;
}

/* All options of the help stand there, and no long option that is not in the help. */
static void expect_options(const char *text)
{
    for (int i = 0; i < option_count; i++)
        if (!has_word(text, option[i]))
            fail_msg("%s is missing", option[i]);
    for (const char *at = text; (at = strstr(at, "--")); at += 2)
        if ((at == text || at[-1] != '-') && isalpha((unsigned char)at[2]) && !is_option(at, word_length(at)))
            fail_msg("%.*s is no option", (int)word_length(at), at);
}

/* Without roff's backslashes and fonts. */
static void manual_page(void **state)
{
    static char text[TEXT];
    (void)state;
    read_file(in_build("roberts.1"), text);
    char *to = text;
    for (const char *from = text; *from; from++)
        if (strncmp(from, "\\fB", 3) == 0 || strncmp(from, "\\fR", 3) == 0 || strncmp(from, "\\fI", 3) == 0)
            from += 2;
        else if (*from != '\\')
            *to++ = *from;
    *to = '\0';
    expect_options(text);
}

/* Is there this word, no part of a longer one? */
static bool has_name(const char *text, const char *name, size_t length)
{
    for (const char *at = text; (at = strstr(at, name)); at++)
        if (!isalnum((unsigned char)at[-1]) && at[-1] != '_' && !isalnum((unsigned char)at[length]) &&
            at[length] != '_')
            return true;
    return false;
}

/* The page explains each name of --stats=json. */
static void names_of_statistics(void **state)
{
    static const char *const runs[] = {"-o /dev/null -f svg models/table.off",
                                       "-f null --union --verify --sheet first models/star/dodecadodecahedron.off"};
    static char manual[TEXT], json[TEXT];
    size_t names = 0;
    (void)state;
    read_file(in_build("roberts.1"), manual);
    *strstr(manual, "\n.SH LIMITS") = '\0';
    const char *section = strstr(manual, "\n.SH STATISTICS");
    assert_non_null(section);
    for (size_t i = 0; i < sizeof runs / sizeof runs[0]; i++) {
        char command[4096], name[64];
        snprintf(command, sizeof command, "'%s/roberts' -q --stats=json %s 2>&1", build_folder(), runs[i]);
        FILE *pipe = popen(command, "r");
        read_stream(pipe, json);
        assert_int_equal(pclose(pipe), 0);
        for (char *at = json; (at = strstr(at, "\":")) != NULL; at++, names++) {
            char *begin = at;
            while (begin[-1] != '"')
                begin--;
            snprintf(name, sizeof name, "%.*s", (int)(at - begin), begin);
            if (!has_name(section, name, strlen(name)))
                fail_msg("%s is missing", name);
        }
    }
    assert_true(names > 80);
}

static void examples_are_in_the_manual(void **state)
{
    static char text[TEXT];
    (void)state;
    read_file(in_build("roberts.1"), text);
    char *to = text;
    for (const char *from = text; *from; from++)
        if (*from != '\\')
            *to++ = *from;
    *to = '\0';
    char *line = strstr(help, "\nExamples\n");
    assert_non_null(line);
    int count = 0;
    for (line = strstr(line, "\n  "); line; line = strstr(line + 1, "\n  "), count++) {
        char example[256];
        snprintf(example, sizeof example, "\n%.*s\n", (int)strcspn(line + 3, "\n"), line + 3);
        if (!strstr(text, example))
            fail_msg("missing:%s", example);
    }
    assert_true(count > 4);
}

static void completions_of_bash_and_zsh(void **state)
{
    static char text[TEXT];
    (void)state;
    read_file(in_build("completions/bash"), text);
    expect_options(text);
    read_file(in_build("completions/zsh"), text);
    expect_options(text);
}

/* fish writes -s o -l output. */
static void completions_of_fish(void **state)
{
    static char text[TEXT];
    (void)state;
    read_file(in_build("completions/fish"), text);
    int found = 0;
    for (int i = 0; i < option_count; i++) {
        bool is_long = option[i][1] == '-';
        char word[48];
        snprintf(word, sizeof word, " -%c %s ", is_long ? 'l' : 's', option[i] + (is_long ? 2 : 1));
        if (!strstr(text, word))
            fail_msg("%s is missing", option[i]);
        found += is_long;
    }
    for (const char *at = text; (at = strstr(at, " -l ")); at++)
        found--;
    assert_int_equal(found, 0); /* no others */
}

/* Every long option that the README gives for this program exists: in commands, after "roberts ", and in the table. */
static void options_of_the_readme(void **state)
{
    static char text[TEXT];
    int checked = 0;
    (void)state;
    read_file("README.md", text);
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
        const bool row = strncmp(line, "| `-", 4) == 0;
        const char *from = row ? line : strstr(line, "roberts ");
        for (const char *at = from; at && (at = strstr(at, "--")); at += 2)
            if (at[-1] != '-' && isalpha((unsigned char)at[2])) {
                checked++;
                if (!is_option(at, word_length(at)))
                    fail_msg("%.*s is no option: %s", (int)word_length(at), at, line);
            }
    }
    assert_true(checked > 20);
}

/* The names of colours that the program knows, as it lists them when given another name. */
static void colors_are_listed(void **state)
{
    static char said[TEXT], manual[TEXT];
    char command[4096];
    int count = 0;
    (void)state;
    snprintf(command, sizeof command, "'%s/roberts' --background no-such-color 2>&1", build_folder());
    FILE *pipe = popen(command, "r");
    read_stream(pipe, said);
    assert_true(pclose(pipe) != 0);
    char *list = strstr(said, "it can be ");
    assert_non_null(list);
    read_file(in_build("roberts.1"), manual);
    for (char *name = strtok(list + strlen("it can be "), ", \n"); name && *name != '#'; name = strtok(NULL, ", \n")) {
        count++;
        if (!has_word(manual, name))
            fail_msg("%s is missing", name);
    }
    assert_true(count > 10);
}

/* What bash would offer for the words of a line, the last of them unfinished; bash does not pass on a "=" or ":". */
static const struct {
    const char *words, *offered;
} bash_cases[] = {
    {"roberts --hi", "--hidden "},
    {"roberts --view ca", "cavalier cabinet "},
    {"roberts --view = ca", "cavalier cabinet "},
    {"roberts -f p", "pdf ps png "},
    {"roberts --format = p", "pdf ps png "},
    {"roberts --stats =", "json "},
    {"roberts --stats = j", "json "},
    {"roberts --stats models/tab", "models/table.off "},
    {"roberts --verify = models/tab", ""},
    {"roberts --style ou", "outline: "},
    {"roberts --hatch spac", "spacing= "},
    {"roberts --hatch on,an", "on,angle= "},
    {"roberts --hatch spacing = 3,an", "3,angle= "},
    {"roberts --hatch = spac", "spacing= "},
    {"roberts --field num", "number= "},
    {"roberts --fill shade : bo", "body "},
    {"roberts --fill = shade : bo", "body "},
    {"roberts --fill shade :", "body white gray "},
    {"roberts --label vertices,fa", "vertices,faces "},
    {"roberts --label = vertices,fa", "vertices,faces "},
    {"roberts --columns +ends,+b", "+ends,+by "},
    {"roberts models/tab", "models/table.off "},
    {"roberts -q --format svg models/tab", "models/table.off "},
    {"roberts --dir 1", ""},
    {"roberts -- --hi", ""},
    {"roberts --no-such", ""},
};

static void bash_completes(void **state)
{
    (void)state;
    if (access("/bin/bash", X_OK) != 0)
        SKIP_BECAUSE("no /bin/bash");
    for (size_t i = 0; i < sizeof bash_cases / sizeof bash_cases[0]; i++) {
        char command[8192], offered[1024];
        snprintf(command, sizeof command,
                 "/bin/bash --norc -c '. \"$0\"; COMP_WORDS=(%s); COMP_CWORD=$((${#COMP_WORDS[@]} - "
                 "1)); _roberts roberts \"${COMP_WORDS[COMP_CWORD]#[:=]}\" \"${COMP_WORDS[COMP_CWORD - 1]}\"; "
                 "printf \"%%s \" ${COMPREPLY[@]+\"${COMPREPLY[@]}\"}' '%s'",
                 bash_cases[i].words, in_build("completions/bash"));
        print_message("%s\n", bash_cases[i].words);
        FILE *pipe = popen(command, "r");
        assert_non_null(pipe);
        offered[fread(offered, 1, sizeof offered - 1, pipe)] = '\0';
        assert_int_equal(pclose(pipe), 0);
        assert_string_equal(strcmp(offered, " ") == 0 ? "" : offered, bash_cases[i].offered);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(manual_page),
        cmocka_unit_test(names_of_statistics),
        cmocka_unit_test(examples_are_in_the_manual),
        cmocka_unit_test(completions_of_bash_and_zsh),
        cmocka_unit_test(completions_of_fish),
        cmocka_unit_test(options_of_the_readme),
        cmocka_unit_test(colors_are_listed),
        cmocka_unit_test(bash_completes),
    };
    return cmocka_run_group_tests_name("manual", tests, set_up, NULL);
}
