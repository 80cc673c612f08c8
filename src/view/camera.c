/* camera.c - the named views. */
#include <string.h>

#include "roberts.h"

bool roberts_camera_preset(const char *name, roberts_camera *camera)
{
    static const struct {
        const char *name;
        roberts_vec3 dir, up;
        double depth; /* right and up for a unit of depth */
    } presets[] = {
        {"iso", {1, -1, 1}, {0, 0, 1}, 0},
        {"dimetric", {1, -2.6457513110645907, 1}, {0, 0, 1}, 0}, /* 1, -sqrt 7, 1: one axis at half of the others */
        {"trimetric", {3, -6, 4}, {0, 0, 1}, 0},
        {"front", {0, -1, 0}, {0, 0, 1}, 0},
        {"back", {0, 1, 0}, {0, 0, 1}, 0},
        {"right", {1, 0, 0}, {0, 0, 1}, 0},
        {"left", {-1, 0, 0}, {0, 0, 1}, 0},
        {"top", {0, 0, 1}, {0, 1, 0}, 0}, /* the lecture's own view */
        {"bottom", {0, 0, -1}, {0, 1, 0}, 0},
        {"cavalier", {0, -1, 0}, {0, 0, 1}, 0.70710678118654752},      /* cos 45, sin 45 */
        {"cabinet", {0, -1, 0}, {0, 0, 1}, 0.5 * 0.70710678118654752}, /* half of that */
    };
    for (size_t i = 0; i < sizeof presets / sizeof presets[0]; i++) {
        if (strcmp(presets[i].name, name) == 0) {
            *camera = (roberts_camera){
                .dir = presets[i].dir, .up = presets[i].up, .oblique = {presets[i].depth, presets[i].depth}};
            return true;
        }
    }
    return false;
}
