/* arguments.c - see arguments.h. */
#include "arguments.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool take_view(const char *text, int w, oracle_view *view)
{
    double v[3];
    for (int i = 0; i < 3; i++) {
        char *end;
        v[i] = strtod(text, &end);
        if (end == text || *end != (i < 2 ? ',' : '\0'))
            return false;
        text = end + 1;
    }
    *view = (oracle_view){.x = v[0], .y = v[1], .z = v[2], .w = w};
    return true;
}

/* False: the value is wrong. */
static bool take_value(const argument *a, const char *value)
{
    switch (a->kind) {
    case ARGUMENT_WORD:
        *(const char **)a->to = value;
        return true;
    case ARGUMENT_COUNT:
        *(uint64_t *)a->to = strtoull(value, NULL, 10);
        return true;
    case ARGUMENT_NUMBER:
        *(double *)a->to = strtod(value, NULL);
        return true;
    default:
        return take_view(value, a->kind == ARGUMENT_EYE, a->to);
    }
}

void arguments_parse(int argc, char **argv, const argument *table, const char *help, void (*list)(void))
{
    for (int i = 1; i < argc; i++) {
        const argument *a = table;
        if (strcmp(argv[i], "--list") == 0) {
            list();
            exit(0);
        }
        if (strcmp(argv[i], "--help") == 0) {
            fputs(help, stdout);
            exit(0);
        }
        while (a->option && strcmp(argv[i], a->option) != 0)
            a++;
        if (a->option && a->kind == ARGUMENT_SWITCH) {
            *(bool *)a->to = true;
            continue;
        }
        if (a->option && a->kind == ARGUMENT_REST && i + 1 < argc) {
            *(int *)a->to = i + 1;
            return;
        }
        if (!a->option || ++i == argc || !take_value(a, argv[i])) {
            fputs(help, stderr);
            exit(2);
        }
    }
}
