/* hull_tell.h - what is said of solids in whose place there is a hull, or nothing. */
#ifndef ROBERTS_MODEL_HULL_TELL_H
#define ROBERTS_MODEL_HULL_TELL_H

#include "model/scene.h"

/* What has become of a solid. */
typedef enum hull_fate {
    FATE_KEPT,  /* it is sound, or stands for points without faces, whose hull is all that was wanted */
    FATE_FLAT,  /* left out */
    FATE_OPEN,  /* replaced by its hull, since it is not closed */
    FATE_BENT,  /* ... since a face is not planar */
    FATE_DENTED /* ... since it is not convex, or too flat to tell */
} hull_fate;

/* Fails: solid s has no hull, and why. */
roberts_status hull_refuse(const roberts_scene *scene, uint32_t s, const roberts_mesh *mesh, roberts_status status,
                           const char *why, roberts_error *error);

/* Warns of each input by itself. Where all solids are flat nothing is left to draw: ROBERTS_FLAT. fate: [solids] hull_fate. */
roberts_status hull_tell(const uint8_t *fate, const roberts_scene *scene, const roberts_mesh *mesh,
                         const roberts_warnings *warnings, roberts_error *error);

#endif
