/* regolden.c - regolden MODEL VIEW GOLDEN: writes a golden, if the oracle agrees with the program (make goldens). */
#include "golden.h"

int main(int argc, char **argv)
{
    if (argc != 4) {
        fputs("regolden MODEL VIEW GOLDEN\n", stderr);
        return 2;
    }
    return golden_write(argv[1], argv[2], argv[3], stdout) ? 0 : 1;
}
