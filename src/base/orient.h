/* orient.h - on which side of a line a point lies, exactly. */
#ifndef ROBERTS_BASE_ORIENT_H
#define ROBERTS_BASE_ORIENT_H

#include "roberts.h"

/* > 0 if a, b, c turn left. The sign is exact unless products leave the range of doubles. */
double orient2d(roberts_vec2 a, roberts_vec2 b, roberts_vec2 c);

#endif
