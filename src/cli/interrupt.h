/* interrupt.h - what becomes of unfinished files when the program is interrupted. */
#ifndef ROBERTS_CLI_INTERRUPT_H
#define ROBERTS_CLI_INTERRUPT_H

enum { INTERRUPT_SLOTS = 64 }; /* files that can be under way at a time */

/* From now on SIGINT, SIGTERM, SIGHUP and SIGPIPE (whoever read what is written is gone) remove the unfinished files, if
 * there are any, and then end the program as ever; a signal that was ignored stays so, and a closed pipe is then an error
 * of write(), as the limit on file sizes is always. */
void interrupt_prepare(void);

/* The context that interrupt_temporary() wants, one for each thread that writes, from 0. */
void *interrupt_slot(int number);

/* A roberts_temporary_fn. */
void interrupt_temporary(void *context, const char *path);

#endif
