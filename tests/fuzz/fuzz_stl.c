/* fuzz_stl.c - STL with any bytes behind what every file of it begins with: "solid" where the first byte is odd; else
 * 80 bytes and a number of triangles, that of the bytes or, so that some are missing, one more. */
#include "fuzz.h"

enum { HEADER = 80, COUNT = 4, TRIANGLE = 50 };

int fuzz_stl(const uint8_t *bytes, size_t size)
{
    uint8_t header[HEADER + COUNT] = "solid";
    if (size == 0)
        return 0;
    const uint8_t way = *bytes++;
    size--;
    if (way & 1)
        return fuzz_read_behind("solid ", 6, bytes, size);
    const size_t count = size / TRIANGLE + (way >> 1 & 1);
    for (int i = 0; i < COUNT; i++)
        header[HEADER + i] = (uint8_t)(count >> 8 * i);
    return fuzz_read_behind(header, sizeof header, bytes, way & 2 ? size : size / TRIANGLE * TRIANGLE);
}
