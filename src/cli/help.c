/* help.c - prints the table of options in five forms. A test runs the examples. */
#include "cli/help.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "cli/options.h"

enum { INDENT = 23, WIDTH = 110, MANUAL_WIDTH = 100 };

static const char usage[] =
    "Usage: roberts [OPTION]... [FILE]...\n"
    "Draws polyhedra of any kind without their hidden lines, by Roberts' method. Several files make one scene.\n"
    "- or no file at all is standard input.\n";

static const char closing[] =
    "\n"
    "A model is a file in OFF, STL, OBJ or PLY; its content decides, not its name.\n"
    "If an option is given twice, the last one counts; but --style, --field, --pick and\n"
    "--room-for may be given several times.\n"
    "The program warns of an option that has no effect.\n"
    "Exit status: 0 done, 1 the input or the work failed, 2 misuse.\n"
    "\n"
    "Examples\n"
    "  roberts models/table.off -o table.svg\n"
    "  roberts --dir 3,-6,4 --hidden dashed models/table.off -o table.pdf\n"
    "  roberts --eye 70,-60,60 models/table.off >table.svg\n"
    "  roberts --page a3 --landscape --scale 5:1 --frame models/table.off -o table.svg\n"
    "  roberts --hidden dashed --dash real --style hidden:color=blue models/table.off -o plot.svg\n"
    "  roberts --view top -f csv --hidden solid - <models/table.off >table.csv\n"
    "  roberts -f null --stats models/table.off\n"
    "  roberts --elevation 30 --turntable 4 models/table.off -o turn-%03d.svg\n"
    "  roberts --sheet first --landscape --hidden dashed models/table.off -o sheet.pdf\n"
    "  roberts --batch drawings -f pdf models/table.off models/tower.off\n"
    "  roberts -f null --verify --pick 0,5 models/table.off\n";

/* ---- --help ---- */

/* Words with lines broken between them. The text begins at column INDENT. */
static void print_wrapped(FILE *file, const char *text)
{
    size_t column = INDENT;
    for (bool first = true; *text; first = false) {
        const size_t length = strcspn(text, " ");
        const bool breaks = !first && column + 1 + length > WIDTH;
        if (breaks)
            fprintf(file, "\n%*s", INDENT, "");
        else if (!first)
            fputc(' ', file);
        fprintf(file, "%.*s", (int)length, text);
        column = (breaks ? INDENT : column + !first) + length;
        text += length + strspn(text + length, " ");
    }
    fputc('\n', file);
}

static void print_option(FILE *file, const option *o)
{
    char name[80];
    int length = o->letter ? snprintf(name, sizeof name, "  -%c, --%s", o->letter, o->name)
                           : snprintf(name, sizeof name, "      --%s", o->name);
    if (o->value)
        length += snprintf(name + length, sizeof name - (size_t)length, o->flags & OPTION_OPTIONAL ? "[=%s]" : " %s",
                           o->value);
    if (length < INDENT)
        fprintf(file, "%-*s", INDENT, name);
    else
        fprintf(file, "%s\n%*s", name, INDENT, "");
    print_wrapped(file, o->help);
}

void help_print(FILE *file, const option_table *table)
{
    fputs(usage, file);
    for (int group = 0; group < OPTION_GROUPS; group++) {
        const option_title *title = &option_titles[group];
        fprintf(file, "\n%s", title->title);
        if (title->help)
            fprintf(file, " (%s)", title->help);
        fputc('\n', file);
        for (const option *o = table->row; o < table->row + table->count; o++)
            if (o->group == (option_group)group)
                print_option(file, o);
    }
    fputs(closing, file);
}

/* ---- the manual page ---- */

/* Prints a word for roff: every hyphen becomes a minus, so that it can be copied to a shell, and no line looks like a
 * command. */
static void put_roff(FILE *file, const char *word, size_t length)
{
    if (*word == '.' || *word == '\'')
        fputs("\\&", file);
    for (size_t i = 0; i < length; i++) {
        if (word[i] == '-' || word[i] == '\\')
            fputc('\\', file);
        fputc(word[i] == '\\' ? 'e' : word[i], file);
    }
}

/* A newline in the text begins a paragraph. */
static void print_paragraphs(FILE *file, const char *text)
{
    size_t column = 0;
    while (*text) {
        const size_t length = strcspn(text, " \n");
        if (column > 0 && column + 1 + length > MANUAL_WIDTH) {
            fputc('\n', file);
            column = 0;
        }
        if (column > 0)
            fputc(' ', file);
        put_roff(file, text, length);
        column += length + 1;
        text += length;
        if (*text == '\n') {
            fputs("\n.IP\n", file);
            column = 0;
        }
        text += strspn(text, " \n");
    }
    fputc('\n', file);
}

/* Which options contradict this one, and which it needs. */
static void print_relations(FILE *file, const option *o, const option_table *table)
{
    const char *before = ".IP\nExcludes ";
    for (const option *other = table->row; other < table->row + table->count; other++)
        if (option_excludes(o, other)) {
            fprintf(file, "%s\\-\\-", before);
            put_roff(file, other->name, strlen(other->name));
            before = ", ";
        }
    fputs(*before == ',' ? ".\n" : "", file);
    if (o->needs) {
        fputs(*before == ',' ? "Needs " : ".IP\nNeeds ", file);
        for (const char *at = o->needs; *at; at += strspn(at, " ")) {
            const size_t length = strcspn(at, " ");
            fputs(at == o->needs ? "\\-\\-" : " or \\-\\-", file);
            put_roff(file, at, length);
            at += length;
        }
        fputs(".\n", file);
    }
}

static void print_manual_option(FILE *file, const option *o, const option_table *table)
{
    fputs(".TP\n", file);
    if (o->letter)
        fprintf(file, "\\fB\\-%c\\fR, ", o->letter);
    fputs("\\fB\\-\\-", file);
    put_roff(file, o->name, strlen(o->name));
    fputs("\\fR", file);
    if (o->value && (o->flags & OPTION_OPTIONAL))
        fprintf(file, "[=\\fI%s\\fR]", o->value);
    else if (o->value)
        fprintf(file, " \\fI%s\\fR", o->value);
    fputc('\n', file);
    print_paragraphs(file, o->manual ? o->manual : o->help);
    print_relations(file, o, table);
}

void help_print_manual(FILE *file, const option_table *table)
{
    for (int group = 0; group < OPTION_GROUPS; group++) {
        fprintf(file, ".SS \"%s\"\n", option_titles[group].title);
        if (option_titles[group].manual)
            print_paragraphs(file, option_titles[group].manual);
        for (const option *o = table->row; o < table->row + table->count; o++)
            if (o->group == (option_group)group)
                print_manual_option(file, o, table);
    }
}

/* ---- completions ---- */

/* What stands behind the words of a value such as CLASS:KEY=VALUE or KEY=VALUE: ':' or '='; 0: nothing. */
static char sign_behind(const option *o)
{
    const char *sign = strpbrk(o->value, ":=");
    return sign ? *sign : '\0';
}

/* The words of an option with the signs behind them; before a colon stands `escape`. Only "on" and "off" stand alone.
 */
static void print_words(FILE *file, const option *o, const char *escape)
{
    const char sign = sign_behind(o);
    for (size_t i = 0; o->words[i]; i++) {
        fprintf(file, "%s%s", i ? " " : "", o->words[i]);
        if (sign && strcmp(o->words[i], "on") != 0 && strcmp(o->words[i], "off") != 0)
            fprintf(file, "%s%c", sign == ':' ? escape : "", sign);
    }
}

/* One branch of a case: the completions of the option's value. */
static void print_bash_option(FILE *file, const option *o)
{
    fputs("    ", file);
    if (o->letter)
        fprintf(file, "-%c | ", o->letter);
    if (!(o->flags & OPTION_OPTIONAL))
        fprintf(file, "--%s | ", o->name);
    fprintf(file, "--%s=) ", o->name);
    if (o->words) {
        fputs("_roberts_words \"$2\" ", file);
        print_words(file, o, "");
        fputs(sign_behind(o) ? "; compopt +o filenames -o nospace 2>/dev/null ;;\n" : " ;;\n", file);
    } else if (o->flags & (OPTION_FILE | OPTION_FOLDER))
        fprintf(file, "_roberts_names -%c \"$2\" ;;\n", o->flags & OPTION_FILE ? 'f' : 'd');
    else
        fputs(";;\n", file);
}

void help_print_bash(FILE *file, const option_table *table)
{
    fputs("_roberts_options='", file);
    for (const option *o = table->row; o < table->row + table->count; o++)
        if (o->letter)
            fprintf(file, "-%c ", o->letter);
    for (const option *o = table->row; o < table->row + table->count; o++) {
        fprintf(file, "%s--%s", o == table->row ? "" : " ", o->name);
        for (size_t i = 0; o->words && (o->flags & OPTION_OPTIONAL) && o->words[i]; i++)
            fprintf(file, " --%s=%s", o->name, o->words[i]);
    }
    fputs("'\n\n# completes the value of option $1 that begins with $2; fails where the option takes none\n"
          "_roberts_value() {\n    case $1 in\n",
          file);
    for (const option *o = table->row; o < table->row + table->count; o++)
        if (o->value)
            print_bash_option(file, o);
    fputs("    *) return 1 ;;\n    esac\n    return 0\n}\n", file);
}

/* The options that cannot follow this one: those that it excludes, and itself unless it repeats. */
static void print_zsh_excluded(FILE *file, const option *o, const option_table *table)
{
    const char *before = "(";
    for (const option *other = table->row; other < table->row + table->count; other++) {
        const bool itself = other == o && o->letter && !(o->flags & OPTION_REPEATS);
        if (!itself && !option_excludes(o, other))
            continue;
        fputs(before, file);
        if (other->letter)
            fprintf(file, "-%c ", other->letter);
        fprintf(file, "--%s", other->name);
        before = " ";
    }
    fputs(*before == '(' ? "" : ")", file);
}

static void print_zsh_option(FILE *file, const option *o, const option_table *table)
{
    fputs("    '", file);
    if (o->flags & OPTION_ALONE)
        fputs("(- *)", file);
    else
        print_zsh_excluded(file, o, table);
    if (o->flags & OPTION_REPEATS)
        fputc('*', file);
    if (o->letter)
        fprintf(file, "'{-%c,--%s}'", o->letter, o->name);
    else
        fprintf(file, "--%s%s", o->name, o->flags & OPTION_OPTIONAL ? "=-" : "");
    fprintf(file, "[%s]", o->brief);
    if (o->value)
        fputs(o->flags & OPTION_OPTIONAL ? "::" : ":", file);
    for (const char *c = o->value; c && *c; c++) {
        fputs(*c == ':' ? "\\" : "", file);
        fputc(tolower((unsigned char)*c), file);
    }
    if (o->words) {
        fputs(":(", file);
        print_words(file, o, "\\");
        fputc(')', file);
    } else if (o->flags & OPTION_FILE)
        fputs(":_files", file);
    else if (o->flags & OPTION_FOLDER)
        fputs(":_files -/", file);
    fputs("' \\\n", file);
}

void help_print_zsh(FILE *file, const option_table *table)
{
    for (const option *o = table->row; o < table->row + table->count; o++)
        print_zsh_option(file, o, table);
}

void help_print_fish(FILE *file, const option_table *table)
{
    for (const option *o = table->row; o < table->row + table->count; o++) {
        fputs("complete -c roberts", file);
        if (o->letter)
            fprintf(file, " -s %c", o->letter);
        fprintf(file, " -l %s", o->name);
        if (o->flags & OPTION_FILE)
            fputs(" -r -F", file);
        else if (o->flags & OPTION_FOLDER)
            fputs(" -x -a '(__fish_complete_directories)'", file);
        else if (o->value && !(o->flags & OPTION_OPTIONAL))
            fputs(" -x", file);
        if (o->words && !(o->flags & OPTION_OPTIONAL)) {
            fputs(" -a '", file);
            print_words(file, o, "");
            fputs("'", file);
        }
        fprintf(file, " -d '%c%s'\n", toupper((unsigned char)o->brief[0]), o->brief + 1);
    }
}
