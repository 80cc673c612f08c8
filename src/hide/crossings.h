/* crossings.h - the lines in which faces toward the viewer cross: which pairs of faces may, and the lines that they
 * give. Whether two faces cross, and where, is decided in model/crossing.h.
 *
 * Only what can be seen is looked for. Candidates are pairs of fronts in one cell of Objet[i][j] whose boxes meet; of a
 * convex solid the front faces count, of another body all faces that are not edge-on. What covers hide is no front, and
 * has no lines; and where hidden lines are not wanted, no pair is sought behind a sheet that fills the cell (see
 * layers.h). The grid and the threads change no line that is seen: lines are put in the order of the faces of the
 * file. */
#ifndef ROBERTS_HIDE_CROSSINGS_H
#define ROBERTS_HIDE_CROSSINGS_H

#include "hide/objet.h"
#include "model/crossing.h"
#include "view/united.h"

typedef struct crossings {
    crossing_segment *item; /* [count] by the numbers of their faces, then by their ends; each once */
    seen_point (*end)[2];   /* [count] their ends */
    roberts_crossing *name; /* [count] what rows say of them */
    size_t count;
    size_t pairs;  /* of faces */
    united pieces; /* of the lines, where bodies are taken together as one */
} crossings;

/* Finds all lines, and their pieces where bodies are one. False: no memory; crossings_free() is due in any case. */
bool crossings_find(crossings *c, const hide_fronts *fronts, const objet *grid, uint32_t threads);
void crossings_free(crossings *c);

/* Line k as `hide` takes it up. */
seen_line crossings_line(const crossings *c, const seen *s, size_t k);

/* Does a convex body of which one of the two faces is hide all of the line? */
bool crossings_is_back(const crossings *c, const seen *s, size_t k);

/* Gives the line its pieces, where bodies are one. False: nothing of it is drawn. */
bool crossings_unite(const crossings *c, const seen *s, size_t k, seen_line *line);

#endif
