/* print-options.c - writes the manual page and the completions from the program's table of options.
 *
 *     print-options manual|bash|zsh|fish <template >file
 *
 * In the template, the line @OPTIONS@ is replaced by the contents of the table, and @VERSION@ by the version. */
#include <stdio.h>
#include <string.h>

#include "cli/help.h"
#include "roberts.h"

static const struct {
    const char *name;
    void (*print)(FILE *file, const option_table *table);
} kinds[] = {
    {"manual", help_print_manual},
    {"bash", help_print_bash},
    {"zsh", help_print_zsh},
    {"fish", help_print_fish},
};

enum { KINDS = sizeof kinds / sizeof kinds[0] };

int main(int argc, char **argv)
{
    char line[4096];
    size_t kind = 0;
    while (argc == 2 && kind < KINDS && strcmp(argv[1], kinds[kind].name) != 0)
        kind++;
    if (argc != 2 || kind == KINDS) {
        fputs("usage: print-options manual|bash|zsh|fish <template >file\n", stderr);
        return 2;
    }
    while (fgets(line, sizeof line, stdin)) {
        const char *version = strstr(line, "@VERSION@");
        if (strcmp(line, "@OPTIONS@\n") == 0)
            kinds[kind].print(stdout, &option_table_all);
        else if (version)
            printf("%.*s%s%s", (int)(version - line), line, ROBERTS_VERSION, version + strlen("@VERSION@"));
        else
            fputs(line, stdout);
    }
    return ferror(stdin) || fflush(stdout) != 0 || ferror(stdout);
}
