/* winding.h - what a body fills if its faces wind more than once.
 *
 * The parity of crossings tells what a surface encloses if each part of it counts once. The middle of a pentagram
 * counts twice: below it, two walls are crossed. There the sum of signed crossings decides: a point is filled if it is
 * not 0. For that, all faces must be oriented alike. */
#ifndef ROBERTS_MODEL_WINDING_H
#define ROBERTS_MODEL_WINDING_H

#include "model/scene.h"

/* Creates winding[face_count]. Of a closed body with faces whose borders wind round some points twice, how often each
 * piece counts when a line of sight leaves the body there (n . line > 0); 0: parity decides what the body fills. NULL:
 * it does for all of them. False: no memory. Release *winding with free() in any case. */
bool winding_find(const roberts_scene *scene, int32_t **winding);

#endif
