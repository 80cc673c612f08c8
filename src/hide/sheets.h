/* sheets.h - cells of the picture in which a surface lies in one layer: there its faces do not cross one another.
 *
 * Take the faces of one body that face alike, front or back, and that a cell lists. A vertex is regular if its faces
 * lie round it in the picture once: each of its sides has one of them on the left and one on the right, and a half-line
 * from it meets one of them. If all corners of the faces are regular, the faces have no border in the cell, and each
 * vertex and side is covered as a disc is. So the number of layers is the same all over the cell, and one layer in the
 * cell's middle is one layer everywhere. Most cells of a fine mesh are of this kind, and their pairs of neighbours need
 * not be asked. */
#ifndef ROBERTS_HIDE_SHEETS_H
#define ROBERTS_HIDE_SHEETS_H

#include "hide/objet.h"

/* In a longer list nothing is known. */
#define SHEET_FACES 512
/* ... nor in one of more groups of faces. */
#define SHEET_GROUPS 4

/* The faces round a vertex. */
typedef struct sheet_vertex {
    uint64_t sides; /* 0 if each side has a face on the left and one on the right */
    uint8_t turns;  /* how many faces a half-line to the right meets, up to 255 */
    uint8_t facing; /* bits: 1 << VIEW_FRONT, 1 << VIEW_BACK */
} sheet_vertex;

typedef struct sheets {
    sheet_vertex *vertex; /* [vertex_count] NULL: there are no surfaces */
} sheets;

/* What is known of one cell. */
typedef struct sheet_cell {
    bool single;                /* the faces of one group do not cross one another */
    bool apart;                 /* nor do those of different groups: their depths are apart */
    uint8_t group[SHEET_FACES]; /* of each entry, if `single` */
} sheet_cell;

/* Looks at all vertices of surfaces. False: no memory; sheets_free() is due in any case. */
bool sheets_find(sheets *s, const hide_fronts *fronts);
void sheets_free(sheets *s);

/* Looks at one cell. */
void sheets_of_cell(const sheets *s, const hide_fronts *fronts, const objet *grid, size_t cell, sheet_cell *out);

#endif
