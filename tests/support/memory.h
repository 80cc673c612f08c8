/* memory.h - makes one allocation after the other fail. For test programs named test_memory_*: only these are linked
 * such that malloc(), calloc(), realloc(), posix_memalign() and free() of our own code come here. Include it in one
 * file only.
 *
 * memory_fail(n), call, memory_try_failed(): for n = 1, 2, ... until nothing failed. */
#ifndef ROBERTS_TESTS_MEMORY_H
#define ROBERTS_TESTS_MEMORY_H

#include <errno.h>
#include <stdbool.h>
#include <stddef.h>

#include "roberts.h"
#include "testing.h"

/* The linker's names.
 * NOLINTBEGIN(bugprone-reserved-identifier) */
void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *block, size_t size);
void __real_free(void *block);
int __real_posix_memalign(void **block, size_t alignment, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *block, size_t size);
void __wrap_free(void *block);
int __wrap_posix_memalign(void **block, size_t alignment, size_t size);

static size_t memory_calls, memory_failing; /* number of calls so far; the one that fails, 0: none */
static size_t memory_blocks;                /* number of blocks not yet freed */
static size_t memory_largest;               /* bytes of the largest block requested */

static bool memory_allows(size_t size)
{
    memory_largest = size > memory_largest ? size : memory_largest;
    return ++memory_calls != memory_failing;
}

void *__wrap_malloc(size_t size)
{
    void *block = memory_allows(size) ? __real_malloc(size) : NULL;
    memory_blocks += block != NULL;
    return block;
}

void *__wrap_calloc(size_t count, size_t size)
{
    void *block = memory_allows(count * size) ? __real_calloc(count, size) : NULL;
    memory_blocks += block != NULL;
    return block;
}

void *__wrap_realloc(void *block, size_t size)
{
    void *grown = memory_allows(size) ? __real_realloc(block, size) : NULL;
    memory_blocks += grown && !block;
    return grown;
}

void __wrap_free(void *block)
{
    memory_blocks -= block != NULL;
    __real_free(block);
}

int __wrap_posix_memalign(void **block, size_t alignment, size_t size)
{
    int status = memory_allows(size) ? __real_posix_memalign(block, alignment, size) : ENOMEM;
    memory_blocks += status == 0;
    return status;
}

/* NOLINTEND(bugprone-reserved-identifier) */

/* From now on, call number `failing` fails, once; 0: none. */
static void memory_fail(size_t failing)
{
    memory_calls = memory_largest = 0;
    memory_failing = failing;
}

/* Has that call happened? */
static bool memory_failed(void)
{
    return memory_failing && memory_calls >= memory_failing;
}

/* Ends a try. If an allocation failed, the status must be ROBERTS_NO_MEMORY, else ROBERTS_OK. There must be as many
 * blocks as before. Returns whether one failed. */
static inline bool memory_try_failed(roberts_status status, const roberts_error *error, size_t before)
{
    bool failed = memory_failed();
    memory_fail(0);
    assert_int_equal(memory_blocks, before);
    assert_int_equal(status, failed ? ROBERTS_NO_MEMORY : ROBERTS_OK);
    assert_string_equal(error->message, failed ? "not enough memory" : "");
    return failed;
}

#endif
