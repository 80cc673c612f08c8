/* crossings.h - the lines in which visible faces cross: finding the pairs of faces that may cross, and their lines.
 * model/crossing.h decides whether two faces cross, and where.
 *
 * Candidates are pairs of fronts in one cell of Objet[i][j] whose boxes meet. A convex solid has only its front faces
 * there, another body all faces that are not edge-on. A solid that covers hide has no fronts and no lines. If hidden
 * lines are not wanted, no pair is tested behind a sheet that fills the cell (see layers.h). The grid and the threads
 * do not change the visible lines. Lines are in the order of the faces of the file. */
#ifndef ROBERTS_HIDE_CROSSINGS_H
#define ROBERTS_HIDE_CROSSINGS_H

#include "hide/objet.h"
#include "model/crossing.h"
#include "view/united.h"

typedef struct crossings {
    crossing_segment *item; /* [count] by the numbers of their faces, then by their ends; each once */
    seen_point (*end)[2];   /* [count] their ends */
    roberts_crossing *name; /* [count] their names in rows */
    size_t count;
    size_t pairs;  /* of faces */
    united pieces; /* of the lines, where bodies are taken together as one */
} crossings;

/* Finds all lines, and their pieces if bodies are taken as one. False: no memory; call crossings_free() in any case.
 */
bool crossings_find(crossings *c, const hide_fronts *fronts, const objet *grid, uint32_t threads);
void crossings_free(crossings *c);

/* Line k, as a line to be hidden. */
seen_line crossings_line(const crossings *c, const seen *s, size_t k);

/* Is one of the two faces that of a convex body that hides all of the line? */
bool crossings_is_back(const crossings *c, const seen *s, size_t k);

/* Gives the line its pieces, if bodies are taken as one. False: no part of it is drawn. */
bool crossings_unite(const crossings *c, const seen *s, size_t k, seen_line *line);

#endif
