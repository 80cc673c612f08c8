/* test_format_table.c - which option works with which format: the program agrees with the table of the manual page, and
 * every option about pages or tables is tried with every format. */
#include <ctype.h>

#include "cli/options.h"
#include "program.h"
#include "testing.h"

enum { FORMATS = 10, TABLES = 2 /* of the formats; the last ones */, ROWS = 32 };

static const char *const formats[FORMATS] = {"svg", "pdf", "ps", "eps", "png", "tikz", "dxf", "hpgl", "csv", "json"};

/* Each option about pages or tables, given so that its effect is visible. */
static const struct {
    const char *name, *given;
} tried[] = {
    {"columns", "--columns +ends"},
    {"page", "--page a3"},
    {"landscape", "--landscape"},
    {"margin", "--margin 5"},
    {"fit", "--fit"},
    {"scale", "--scale 1:10"},
    {"unit", "--scale 1:10 --unit cm"},
    {"align", "--align left"},
    {"frame", "--frame"},
    {"background", "--background red"},
    {"fill", "--fill red"},
    {"light", "--hatch on --light 1,2,3"},
    {"dpi", "--dpi 50"},
    {"plotter", "--plotter center"},
    {"style", "--style outline:width=1"},
    {"hatch", "--hatch on"},
    {"dash", "--hidden dashed --dash real"},
    {"order", "--order none"},
    {"layers", "--layers numbered"},
    {"group", "--group body"},
    {"id-prefix", "--id-prefix a"},
    {"label", "--label vertices"},
    {"labels", "--labels names.csv"},
    {"title", "--sheet first --title T"},
    {"crop", "--crop"},
    {"room-for", "--room-for models/table.off"},
    {"description", "--description T"},
    {"field", "--sheet first --field author=A"},
    {"dimensions", "--sheet first --dimensions overall"},
    {"label-size", "--label vertices --label-size 3"},
    {"text", "--label vertices --text native"},
};

enum { TRIED = sizeof tried / sizeof tried[0] };

/* A row of the manual's table. */
typedef struct row {
    char name[32];
    bool works[FORMATS];
} row;

/* Reads the name after the two dashes, each of which follows a backslash. Returns the rest. */
static const char *take_name(const char *at, char name[32])
{
    size_t length = 0;
    for (at += strlen("\\-\\-"); *at == '\\' || *at == '-' || islower((unsigned char)*at); at++)
        if (*at != '\\' && length < 31)
            name[length++] = *at;
    name[length] = '\0';
    return at;
}

static size_t read_table(row rows[ROWS])
{
    static char page[TEXT];
    char path[2100];
    size_t count = 0;
    snprintf(path, sizeof path, "%s/src/cli/roberts.1", top);
    read_text(path, page);
    const char *at = strstr(page, "option            svg");
    assert_non_null(at);
    const char *const column = strstr(at, "svg"), *const first = at;
    while ((at = strchr(at, '\n')) && strncmp(++at, ".EE", 3) != 0) {
        assert_true(count < ROWS);
        row *r = &rows[count++];
        take_name(at, r->name);
        size_t escapes = 0; /* troff does not show them */
        for (const char *c = at; *c != '\n'; c++)
            escapes += *c == '\\';
        for (size_t i = 0; i < FORMATS; i++) {
            const char mark = at[column - first + (ptrdiff_t)(escapes + 5 * i)];
            assert_true(mark == 'x' || mark == '.');
            r->works[i] = mark == 'x';
        }
    }
    return count;
}

static const row *find_row(const row *rows, size_t count, const char *name)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(rows[i].name, name) == 0)
            return &rows[i];
    return NULL;
}

/* Whether a warning about this option says that it has no effect. */
static bool is_idle(const char *given, const char *format)
{
    char line[200], first[16];
    const char *last_option = given;
    for (const char *at = given; (at = strstr(at, "--")); at++)
        last_option = at;
    snprintf(first, sizeof first, "%.*s", (int)strcspn(last_option, " "), last_option);
    snprintf(line, sizeof line, "models/platonic/cube.off %s -f %s -o out.%s", given, format, format);
    if (run(line) != 0)
        fail_msg("%s: %s", line, last.err);
    const char *said = strstr(last.err, "no effect");
    return said && (strstr(last.err, first) || strstr(last.err, "the width of a pen"));
}

static void every_option_with_every_format(void **state)
{
    (void)state;
    row rows[ROWS];
    const size_t count = read_table(rows);
    put("names.csv", "vertex,0,A\n");
    for (size_t i = 0; i < TRIED; i++) {
        const row *r = find_row(rows, count, tried[i].name);
        for (size_t k = 0; k < FORMATS; k++) {
            const bool works = r ? r->works[k] : k < FORMATS - TABLES;
            if (is_idle(tried[i].given, formats[k]) == works)
                fail_msg("--%s with %s: the manual page says %s, the program says \"%s\"", tried[i].name, formats[k],
                         works ? "that it works" : "that it has no effect", last.err);
        }
    }
}

static void every_option_is_tried(void **state)
{
    (void)state;
    row rows[ROWS];
    const size_t count = read_table(rows);
    size_t wanted = 0;
    for (size_t i = 0; i < option_table_all.count; i++) {
        const option *o = &option_table_all.row[i];
        bool found = false;
        for (size_t k = 0; k < TRIED; k++)
            found = found || strcmp(tried[k].name, o->name) == 0;
        if (o->flags & (OPTION_PAPER | OPTION_TABLE)) {
            wanted++;
            if (!found)
                fail_msg("--%s is not tried", o->name);
        }
    }
    assert_int_equal(wanted, TRIED);
    assert_int_equal(count, 11);
}

int main(void)
{
    const struct CMUnitTest tests[] = {IN_FOLDER(every_option_with_every_format), IN_FOLDER(every_option_is_tried)};
    if (!program_find())
        return 1;
    return cmocka_run_group_tests_name("formats and options", tests, NULL, NULL);
}
