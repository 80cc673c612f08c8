/* skip.h - skips a test with a reason, which run.sh prints beside the test's name. Include it after cmocka.h. */
#ifndef ROBERTS_TESTS_SKIP_H
#define ROBERTS_TESTS_SKIP_H

#define SKIP_BECAUSE(...)                                                                                              \
    do {                                                                                                               \
        print_message("skipped: " __VA_ARGS__);                                                                        \
        print_message("\n");                                                                                           \
        skip();                                                                                                        \
    } while (0)

#endif
