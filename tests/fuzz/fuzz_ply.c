/* fuzz_ply.c - PLY with any bytes behind its first line. */
#include "fuzz.h"

int fuzz_ply(const uint8_t *bytes, size_t size)
{
    return fuzz_read_behind("ply\n", 4, bytes, size);
}
