/* bare_faces.h - triangles of a surface that are certainly seen whole: nothing lies before them, or near them.
 *
 * A sheet fills a cell of Objet[i][j] (layers.h). A triangle that lies in the sheets of all cells that it touches is
 * seen whole. Visible lines near it are sides of the triangles about its corners. If none of these is narrow, only the
 * lines that end in its corners are near it, and its own sides. Then what is seen of it is its picture, whatever the
 * rest of the scene is: it is bare. In a fine mesh, most faces that are seen are bare. */
#ifndef ROBERTS_HIDE_BARE_FACES_H
#define ROBERTS_HIDE_BARE_FACES_H

#include "hide/objet.h"

/* Finds what is known of the faces, as seen.sight, or NULL if nothing is. apart: view units; lines nearer than this are
 * near. The caller frees *sight. False: no memory. */
bool bare_faces_find(const hide_fronts *fronts, const objet *grid, double apart, uint32_t threads, uint8_t **sight);

#endif
