/* write.h - a drawing or a sheet, in any format. */
#ifndef ROBERTS_DRAW_WRITE_H
#define ROBERTS_DRAW_WRITE_H

#include "roberts.h"

/* What is written: one of the two, the other NULL. */
typedef struct subject {
    const roberts_drawing *drawing;
    const roberts_sheet *sheet;
} subject;

/* As roberts_drawing_write(); `options` are not NULL. */
roberts_status write_subject(const subject *what, const roberts_draw_options *options, roberts_write_fn *write,
                             void *context, roberts_error *error);

#endif
