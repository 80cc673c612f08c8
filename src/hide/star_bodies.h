/* star_bodies.h - bodies that do not cross themselves, because all of their surface is seen from one point. */
#ifndef ROBERTS_HIDE_STAR_BODIES_H
#define ROBERTS_HIDE_STAR_BODIES_H

#include "hide/fronts.h"

/* Is it certain that no two faces of a body cross, or touch except in a common corner or side? Asked of closed bodies
 * of triangles that are all wound alike, with coordinates that have no low parts. Returns the facing of those of its
 * faces that lie behind others, for a viewer outside; VIEW_UNKNOWN: it is not certain. box: that of the body along the
 * axes of the model. touching: model units; faces without a common corner are farther apart than this. */
unsigned char star_body_rear(const roberts_scene *scene, uint32_t body, const box3 *box, double touching);

#endif
