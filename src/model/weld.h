/* weld.h - vertices at the same position become one. */
#ifndef ROBERTS_MODEL_WELD_H
#define ROBERTS_MODEL_WELD_H

#include "roberts.h"

/* Sets name[v] to the smallest of the listed vertices that have exactly v's position (-0 is 0), for each of the `count`
 * vertices listed (ascending); other names are left alone. False: no memory. */
bool weld_vertices(uint32_t *name, const uint32_t *listed, uint32_t count, const roberts_vec3 *point);

#endif
