/* pthread.h - for a system with one thread: locks that are always free. */
#ifndef ROBERTS_WEB_WASI_PTHREAD_H
#define ROBERTS_WEB_WASI_PTHREAD_H

#include <sys/types.h>

#define PTHREAD_OF_ONE(name, type)                                                                                     \
    static inline int name(type *one)                                                                                  \
    {                                                                                                                  \
        (void)one;                                                                                                     \
        return 0;                                                                                                      \
    }

PTHREAD_OF_ONE(pthread_mutex_lock, pthread_mutex_t)
PTHREAD_OF_ONE(pthread_mutex_unlock, pthread_mutex_t)
PTHREAD_OF_ONE(pthread_mutex_destroy, pthread_mutex_t)
PTHREAD_OF_ONE(pthread_cond_broadcast, pthread_cond_t)
PTHREAD_OF_ONE(pthread_cond_destroy, pthread_cond_t)
#define pthread_mutex_init(mutex, attributes) 0
#define pthread_cond_init(condition, attributes) 0
#define pthread_cond_wait(condition, mutex) ((void)0) /* never comes to it: nobody else could end the wait */

#endif
