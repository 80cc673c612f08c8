/* skip.h - skips a test and says why; run.sh prints the reason beside the test's name. Include it after cmocka.h. */
#ifndef ROBERTS_TESTS_SKIP_H
#define ROBERTS_TESTS_SKIP_H

#define SKIP_BECAUSE(...)                                                                                              \
    do {                                                                                                               \
        print_message("skipped: " __VA_ARGS__);                                                                        \
        print_message("\n");                                                                                           \
        skip();                                                                                                        \
    } while (0)

#endif
