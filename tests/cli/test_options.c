/* One table of options feeds parsing, --help, the manual page and the completions: one more row there is one more
 * option everywhere. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "cli/help.h"
#include "cli/message.h"
#include "cli/options.h"
#include "testing.h"

enum { TEXT = 1 << 16 };

static const char *const tastes[] = {"sweet", "sour", NULL};
static size_t taste; /* what --taste has set */

static int set_taste(const option *o, const char *value, cli_options *options)
{
    (void)options;
    for (taste = 0; o->words[taste] && strcmp(o->words[taste], value) != 0;)
        taste++;
    return o->words[taste] ? EXIT_DONE : EXIT_MISUSED;
}

/* The table of the program with one row more. */
static option_table with_one_more(void)
{
    static option rows[OPTIONS_MOST];
    size_t count = option_table_all.count;
    assert_true(count + 1 < OPTIONS_MOST);
    memcpy(rows, option_table_all.row, count * sizeof *rows);
    rows[count] = (option){.group = GROUP_LINES,
                           .name = "taste",
                           .letter = 'T',
                           .flags = OPTION_DRAWS,
                           .value = "TASTE",
                           .words = tastes,
                           .set = set_taste,
                           .excludes = "crease quiet",
                           .needs = "eye hull",
                           .brief = "how lines taste",
                           .help = "how lines taste",
                           .manual = "How lines taste: sweet or sour.\nMore on taste."};
    return (option_table){rows, count + 1};
}

static void print_text(void (*print)(FILE *, const option_table *), const option_table *table, char text[TEXT])
{
    FILE *file = tmpfile();
    assert_non_null(file);
    print(file, table);
    rewind(file);
    text[fread(text, 1, TEXT - 1, file)] = '\0';
    fclose(file);
}

static const struct {
    const char *name;
    void (*print)(FILE *file, const option_table *table);
    const char *lines[2]; /* what the new row adds */
} printed[] = {
    {"--help", help_print, {"\n  -T, --taste TASTE    how lines taste\n"}},
    {"manual",
     help_print_manual,
     {"\n.TP\n\\fB\\-T\\fR, \\fB\\-\\-taste\\fR \\fITASTE\\fR\nHow lines taste: sweet or sour.\n.IP\nMore on "
      "taste.\n"}},
    {"bash", help_print_bash, {" --taste", "    -T | --taste | --taste=) _roberts_words \"$2\" sweet sour ;;\n"}},
    {"zsh",
     help_print_zsh,
     {"    '(--crease -q --quiet -T --taste)'{-T,--taste}'[how lines taste]:taste:(sweet sour)' \\\n",
      "'(--all-edges -T --taste)--crease["}},
    {"fish", help_print_fish, {"complete -c roberts -s T -l taste -x -a 'sweet sour' -d 'How lines taste'\n"}},
};

static void a_row_more_is_an_option_more(void **state)
{
    static char text[TEXT], before[TEXT];
    const option_table more = with_one_more();
    (void)state;
    for (size_t i = 0; i < sizeof printed / sizeof printed[0]; i++) {
        print_message("%s\n", printed[i].name);
        print_text(printed[i].print, &more, text);
        print_text(printed[i].print, &option_table_all, before);
        for (size_t j = 0; j < 2 && printed[i].lines[j]; j++) {
            if (!strstr(text, printed[i].lines[j]))
                fail_msg("missing: %s\nin: %s", printed[i].lines[j], text);
            assert_null(strstr(before, printed[i].lines[j]));
        }
    }
}

/* Parses the words of one line; returns the exit status and the messages. */
static int parse(const char *line, cli_options *options, char said[TEXT])
{
    static char words[1024];
    char *argv[16] = {words};
    int argc = 1;
    const option_table more = with_one_more();
    FILE *file = tmpfile();
    snprintf(words, sizeof words, "%s", line);
    for (char *word = strtok(words, " "); word; word = strtok(NULL, " "))
        argv[argc++] = word;
    assert_non_null(file);
    fflush(stderr);
    int kept = dup(STDERR_FILENO);
    dup2(fileno(file), STDERR_FILENO);
    int status = options_parse(&more, argc, argv, options);
    fflush(stderr);
    dup2(kept, STDERR_FILENO);
    close(kept);
    rewind(file);
    said[fread(said, 1, TEXT - 1, file)] = '\0';
    fclose(file);
    return status;
}

static const struct {
    const char *line, *said; /* said: NULL if the line is valid */
} parsed[] = {
    {"--taste sour --hull a.off", NULL},
    {"--eye 1,2,3 -T sour a.off", NULL},
    {"--hull --taste=sour a.off", NULL},
    {"--hull -qTsour a.off", "--taste and --quiet exclude each other\n"},
    {"--crease 3 --hull --taste sour a.off", "--taste and --crease exclude each other\n"},
    {"--taste sour a.off", "--taste needs --eye\n"},
    {"--hull a.off --taste", "--taste needs a value\n"},
    {"--taste --hull a.off", "--taste needs a value, but --hull follows; to have that as its value: --taste=--hull\n"},
    {"--taste --page=a4 a.off", "--taste needs a value, but --page=a4 follows; "},
    {"--taste -- a.off", "--taste needs a value, but -- follows; "},
    {"-T --hull a.off", "-T needs a value, but --hull follows; to have that as its value: --taste=--hull\n"},
    {"--tast sour", "--tast is unknown; did you mean --taste?\n"},
};

static void it_is_parsed(void **state)
{
    static cli_options options;
    static char said[TEXT];
    (void)state;
    for (size_t i = 0; i < sizeof parsed / sizeof parsed[0]; i++) {
        print_message("%s\n", parsed[i].line);
        taste = 9;
        assert_int_equal(parse(parsed[i].line, &options, said), parsed[i].said ? EXIT_MISUSED : EXIT_DONE);
        if (parsed[i].said && !strstr(said, parsed[i].said))
            fail_msg("said: %s", said);
        if (!parsed[i].said) {
            assert_int_equal(taste, 1);
            assert_non_null(strstr(options.description.text, "=sour"));
        }
    }
}

/* A sheet with a title block has a scale of ISO 5455, unless the user chooses it. */
static void scale_of_title_blocks(void **state)
{
    static const struct {
        const char *line;
        bool standard;
        double scale;
        const char *said;
    } cases[] = {
        {"--sheet first --title T", true, 0.0, ""},
        {"--title T", false, 0.0, ""},
        {"--sheet third --field number=17 --unit cm", true, 0.0, ""},
        {"--sheet first --title T --scale 1:3", false, 1.0 / 3.0, ""},
        {"--scale 2:1 --title T --sheet first", false, 2.0, ""},
        {"--sheet first --title T --fit", false, 0.0, ""},
        {"--sheet first", false, 0.0, ""},
        {"--sheet first --dimensions overall", false, 0.0, ""},
        {"--sheet first --unit cm", false, 0.0, "--unit has no effect"},
        {"--sheet first --title T --fit --unit cm", false, 0.0, "--unit has no effect"},
    };
    static char said[TEXT];
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        static cli_options options;
        print_message("%s\n", cases[i].line);
        assert_int_equal(parse(cases[i].line, &options, said), EXIT_DONE);
        assert_int_equal(options.draw.placement.standard, cases[i].standard);
        assert_true(options.draw.placement.scale == cases[i].scale);
        assert_true(*cases[i].said ? strstr(said, cases[i].said) != NULL : *said == '\0');
    }
}

/* What the printers rely on, and the names of other rows. */
static void rows_are_sound(void **state)
{
    const option *row = option_table_all.row;
    const size_t count = option_table_all.count;
    (void)state;
    assert_true(count < OPTIONS_MOST);
    for (size_t i = 0; i < count; i++) {
        print_message("--%s\n", row[i].name);
        assert_true(row[i].brief && row[i].help && row[i].group < OPTION_GROUPS);
        assert_null(strpbrk(row[i].brief, "'\"[]:\\"));
        assert_null(strchr(row[i].help, '\n'));
        for (size_t j = 0; j < i; j++) {
            assert_string_not_equal(row[i].name, row[j].name);
            assert_true(row[i].letter == 0 || row[i].letter != row[j].letter);
        }
        const char *lists[] = {row[i].excludes, row[i].needs};
        for (size_t k = 0; k < 2; k++)
            for (const char *at = lists[k]; at && *at; at += strspn(at, " ")) {
                size_t length = strcspn(at, " "), j = 0;
                while (j < count && !(strlen(row[j].name) == length && strncmp(row[j].name, at, length) == 0))
                    j++;
                assert_true(j < count && j != i);
                at += length;
            }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_row_more_is_an_option_more),
        cmocka_unit_test(it_is_parsed),
        cmocka_unit_test(scale_of_title_blocks),
        cmocka_unit_test(rows_are_sound),
    };
    return cmocka_run_group_tests_name("options", tests, NULL, NULL);
}
