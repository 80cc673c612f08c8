/* help.h - the text of --help. */
#ifndef ROBERTS_CLI_HELP_H
#define ROBERTS_CLI_HELP_H

/* In parts, as compilers need not take strings of 4096 characters; NULL behind the last. */
extern const char *const help_text[];

#endif
