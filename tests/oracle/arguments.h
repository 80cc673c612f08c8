/* arguments.h - the options of the programs that compare. */
#ifndef ROBERTS_TESTS_ARGUMENTS_H
#define ROBERTS_TESTS_ARGUMENTS_H

#include "oracle.h"

typedef enum argument_kind {
    ARGUMENT_WORD,   /* const char * */
    ARGUMENT_COUNT,  /* uint64_t */
    ARGUMENT_NUMBER, /* double */
    ARGUMENT_SWITCH, /* bool; the option has no value */
    ARGUMENT_DIR,    /* oracle_view, from a direction X,Y,Z */
    ARGUMENT_EYE,    /* oracle_view, from an eye X,Y,Z */
    ARGUMENT_REST    /* int: the index of the option's first value; all that follows are values */
} argument_kind;

/* An option, and where its value goes. */
typedef struct argument {
    const char *option;
    argument_kind kind;
    void *to;
} argument;

/* Reads the command line. `table` ends with a row of zeros. --help prints the help and --list calls `list`; both end
 * the program, and so does an option that is wrong, after the help, with exit status 2. */
void arguments_parse(int argc, char **argv, const argument *table, const char *help, void (*list)(void));

#endif
