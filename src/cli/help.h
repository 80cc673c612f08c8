/* help.h - prints the table of options: as --help, in the manual page, and in the completions of bash, zsh and fish. */
#ifndef ROBERTS_CLI_HELP_H
#define ROBERTS_CLI_HELP_H

#include <stdio.h>

#include "cli/options.h"

/* The text of --help. */
void help_print(FILE *file, const option_table *table);

/* The section OPTIONS of the manual page, in the macros of man(7). */
void help_print_manual(FILE *file, const option_table *table);

/* The part of each shell's completion that follows the table. */
void help_print_bash(FILE *file, const option_table *table);
void help_print_zsh(FILE *file, const option_table *table);
void help_print_fish(FILE *file, const option_table *table);

#endif
