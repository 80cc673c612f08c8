/* camera.c - the named views. */
#include <string.h>

#include "roberts.h"

bool roberts_camera_preset(const char *name, roberts_camera *camera)
{
    static const struct {
        const char *name;
        roberts_vec3 dir, up;
    } presets[] = {
        {"iso", {1, -1, 1}, {0, 0, 1}},
        {"dimetric", {1, -2.6457513110645907, 1}, {0, 0, 1}}, /* 1, -sqrt 7, 1: two axes at full scale, one at half */
        {"trimetric", {3, -6, 4}, {0, 0, 1}},
        {"front", {0, -1, 0}, {0, 0, 1}},
        {"back", {0, 1, 0}, {0, 0, 1}},
        {"right", {1, 0, 0}, {0, 0, 1}},
        {"left", {-1, 0, 0}, {0, 0, 1}},
        {"top", {0, 0, 1}, {0, 1, 0}}, /* the lecture's own view */
        {"bottom", {0, 0, -1}, {0, 1, 0}},
    };
    for (size_t i = 0; i < sizeof presets / sizeof presets[0]; i++) {
        if (strcmp(presets[i].name, name) == 0) {
            *camera = (roberts_camera){.dir = presets[i].dir, .up = presets[i].up};
            return true;
        }
    }
    return false;
}
