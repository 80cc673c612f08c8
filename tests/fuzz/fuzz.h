/* fuzz.h - what a fuzzer calls with bytes of its own making. Each stops the process where something is wrong that no
 * sanitizer sees; all also run over the seeds and over what was once found, in test_fuzz.c. */
#ifndef ROBERTS_TESTS_FUZZ_H
#define ROBERTS_TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* Like assert(), but never compiled away. */
#define FUZZ_REQUIRE(condition)                                                                                        \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition);                                    \
            abort();                                                                                                   \
        }                                                                                                              \
    } while (0)

/* Bytes of an input of fuzz_pipeline() that stand before the file and choose camera and options. */
enum { FUZZ_SETTINGS = 12 };

/* All return 0, as the fuzzer wants it. */
int fuzz_read(const uint8_t *bytes, size_t size);
int fuzz_stl(const uint8_t *bytes, size_t size);
int fuzz_obj(const uint8_t *bytes, size_t size);
int fuzz_ply(const uint8_t *bytes, size_t size);
int fuzz_pipeline(const uint8_t *bytes, size_t size);

/* fuzz_read() with the bytes behind `length` others. */
int fuzz_read_behind(const void *begins, size_t length, const uint8_t *bytes, size_t size);

#endif
