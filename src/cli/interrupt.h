/* interrupt.h - what becomes of an unfinished file when the program is interrupted. */
#ifndef ROBERTS_CLI_INTERRUPT_H
#define ROBERTS_CLI_INTERRUPT_H

/* From now on SIGINT, SIGTERM and SIGHUP remove the unfinished file, if there is one, and then end the program as ever;
 * a closed pipe and the limit on file sizes become errors of write(). */
void interrupt_prepare(void);

/* A roberts_temporary_fn. */
void interrupt_temporary(void *context, const char *path);

#endif
