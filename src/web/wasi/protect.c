/* protect.c - qh_new_qhull() with its setjmp() in the host (setjmp.h).
 *
 * The linker sends calls of qh_new_qhull() here (--wrap). The host calls run() and catches what web_leave() throws. The
 * other setjmp() of Qhull is for points that are joggled, which ours never are. */
#include <libqhull_r/qhull_ra.h>

typedef struct call {
    qhT *qh;
    int dim, points;
    coordT *point;
    boolT ismalloc;
    char *command;
    FILE *out, *err;
} call;

/* Calls function(context). Returns what it returns, or the code with which it has left. */
int web_protect(int (*function)(void *), void *context) __attribute__((import_module("env"), import_name("protect")));

int __real_qh_new_qhull(qhT *qh, int dim, int points, coordT *point, boolT ismalloc, char *command, FILE *out,
                        FILE *err);
int __wrap_qh_new_qhull(qhT *qh, int dim, int points, coordT *point, boolT ismalloc, char *command, FILE *out,
                        FILE *err);

static int run(void *context)
{
    const call *c = context;
    return __real_qh_new_qhull(c->qh, c->dim, c->points, c->point, c->ismalloc, c->command, c->out, c->err);
}

int __wrap_qh_new_qhull(qhT *qh, int dim, int points, coordT *point, boolT ismalloc, char *command, FILE *out,
                        FILE *err)
{
    call c = {qh, dim, points, point, ismalloc, command, out, err};
    int code = web_protect(run, &c);
    qh->NOerrexit = True; /* as behind the setjmp() */
    return code;
}
