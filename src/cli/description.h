/* description.h - what was drawn and how, as a command that draws it again. */
#ifndef ROBERTS_CLI_DESCRIPTION_H
#define ROBERTS_CLI_DESCRIPTION_H

#include <stddef.h>

/* Words as a shell takes them. What does not fit is cut off, and three dots are put there. */
typedef struct description {
    char text[4096];
    size_t length;
    int is_full;
} description;

void description_word(description *d, const char *word);

/* --name or --name=value. */
void description_option(description *d, const char *name, const char *value);

#endif
