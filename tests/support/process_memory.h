/* process_memory.h - makes one allocation of the whole process fail, including those of other libraries. The functions
 * here replace those of the C library. They need glibc, which calls them __libc_malloc() etc., and no sanitizer, which
 * has its own; otherwise REPLACED is 0. Include it in one file only. (memory.h does the same for the allocations of our
 * own code, on every system.) */
#ifndef ROBERTS_TESTS_PROCESS_MEMORY_H
#define ROBERTS_TESTS_PROCESS_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

#include "sanitized.h"

#if defined(__GLIBC__) && !SANITIZED
#define REPLACED 1
#else
#define REPLACED 0
#endif

static struct process_memory {
    size_t calls, failing; /* calls since it was set; the one that fails, 0: none */
    long blocks;           /* not freed yet */
} memory;

#if REPLACED
/* glibc's names.
 * NOLINTBEGIN(bugprone-reserved-identifier,readability-inconsistent-declaration-parameter-name) */
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *block, size_t size);
void __libc_free(void *block);

static bool allowed(void)
{
    return ++memory.calls != memory.failing;
}

void *malloc(size_t size)
{
    void *block = allowed() ? __libc_malloc(size) : NULL;
    memory.blocks += block != NULL;
    return block;
}

void *calloc(size_t count, size_t size)
{
    void *block = allowed() ? __libc_calloc(count, size) : NULL;
    memory.blocks += block != NULL;
    return block;
}

void *realloc(void *block, size_t size)
{
    void *grown = allowed() ? __libc_realloc(block, size) : NULL;
    memory.blocks += !block && grown;
    return grown;
}

void free(void *block)
{
    memory.blocks -= block != NULL;
    __libc_free(block);
}
/* NOLINTEND(bugprone-reserved-identifier,readability-inconsistent-declaration-parameter-name) */
#endif

#endif
