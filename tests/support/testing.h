/* testing.h - cmocka, after the headers that it needs, and how a test is skipped. */
#ifndef ROBERTS_TESTS_TESTING_H
#define ROBERTS_TESTS_TESTING_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Skips a test with a reason, which run.sh prints beside the test's name. */
#define SKIP_BECAUSE(...)                                                                                              \
    do {                                                                                                               \
        print_message("skipped: " __VA_ARGS__);                                                                        \
        print_message("\n");                                                                                           \
        skip();                                                                                                        \
    } while (0)

#endif
