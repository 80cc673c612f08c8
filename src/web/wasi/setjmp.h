/* setjmp.h - the jump by which Qhull leaves after an error. WebAssembly has none, so the host throws an exception, and
 * protect.c catches it around the whole call. setjmp() itself only ever returns the first time. */
#ifndef ROBERTS_WEB_WASI_SETJMP_H
#define ROBERTS_WEB_WASI_SETJMP_H

typedef int jmp_buf[1];

#define setjmp(buffer) ((void)(buffer), 0)
#define longjmp(buffer, code) ((void)(buffer), web_leave(code))

_Noreturn void web_leave(int code) __attribute__((import_module("env"), import_name("leave")));

#endif
