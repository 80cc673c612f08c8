/* nearest.h - the word that was meant. */
#ifndef ROBERTS_CLI_NEAREST_H
#define ROBERTS_CLI_NEAREST_H

#include <stddef.h>

/* Of `count` words the one that `word` is most like; NULL where none is near enough to be what was meant. */
const char *nearest_word(const char *word, const char *const *words, size_t count);

/* What does here what other programs call --word: an option, perhaps with its value; NULL where nothing is known. */
const char *nearest_option(const char *word);

/* Says that `word` is no value of `what`, and what was meant or what it can be (`also`: what else than `words`, or NULL);
 * returns EXIT_MISUSED. */
int nearest_unknown(const char *what, const char *word, const char *const *words, size_t count, const char *also);

#endif
