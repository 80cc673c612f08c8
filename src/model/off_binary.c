/* off_binary.c - vertices and faces as 32-bit words. */
#include "model/off.h"

roberts_status off_read_binary(off_reader *r)
{
    return off_fail(r, ROBERTS_BAD_SYNTAX, "binary OFF cannot be read yet");
}
