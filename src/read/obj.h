/* obj.h - the materials of an OBJ file, which are in other files (.mtl). */
#ifndef ROBERTS_READ_OBJ_H
#define ROBERTS_READ_OBJ_H

#include "read/input.h"

typedef struct obj_material {
    char *name;
    size_t order;        /* of several with one name, the last one counts */
    roberts_color color; /* count 0: none given */
} obj_material;

typedef struct obj_materials {
    obj_material *item; /* [count] sorted by name after obj_materials_sort() */
    size_t count, room;
    size_t odd,
        first_odd; /* of the last .mtl: how many colours are not numbers from 0 to 1, and the line of the first */
} obj_materials;

/* Adds the materials of one .mtl. Skips anything it does not understand, since colours are no reason to refuse a model.
 * False: no memory. */
bool obj_materials_read(obj_materials *m, const input_source *source);
void obj_materials_sort(obj_materials *m);

/* Returns the colour of a material (count 0: none given), or NULL if there is no such material. */
const roberts_color *obj_materials_color(const obj_materials *m, const char *name);
void obj_materials_free(obj_materials *m);

#endif
