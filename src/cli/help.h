/* help.h - the text of --help. */
#ifndef ROBERTS_CLI_HELP_H
#define ROBERTS_CLI_HELP_H

extern const char help_text[];

#endif
