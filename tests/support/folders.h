/* folders.h - the folders that the environment names. */
#ifndef ROBERTS_TESTS_FOLDERS_H
#define ROBERTS_TESTS_FOLDERS_H

#include <stdlib.h>

/* Where the program and the tests are built. */
static inline const char *build_folder(void)
{
    const char *folder = getenv("ROBERTS_BUILD");
    return folder && *folder ? folder : "build";
}

/* The folder with published models. */
static inline const char *shared_folder(void)
{
    const char *folder = getenv("ROBERTS_SHARED");
    return folder && *folder ? folder : "../shared";
}

#endif
