/* hints.h - what was meant, or what can be done: the second half of a message. */
#ifndef ROBERTS_CLI_HINTS_H
#define ROBERTS_CLI_HINTS_H

/* Lists of words end with NULL. */

/* The word of the list that `word` is most like; NULL where none is near enough to be what was meant. */
const char *hint_word(const char *word, const char *const *words);

/* The option that does here what other programs call --word, perhaps with its value; NULL where nothing is known. */
const char *hint_option(const char *word);

/* Says that `word` is no value of `what`, and what was meant or what it can be (`also`: what else than `words`, or NULL).
 * Returns EXIT_MISUSED. */
int hint_unknown(const char *what, const char *word, const char *const *words, const char *also);

#endif
