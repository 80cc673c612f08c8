/* mesh_judge.h - runs the program's library and the mesh oracle on one scene and compares every edge. */
#ifndef ROBERTS_TESTS_MESH_JUDGE_H
#define ROBERTS_TESTS_MESH_JUDGE_H

#include <stdio.h>

#include "mesh_oracle.h"

/* A scene of any bodies. */
typedef struct mesh_scene {
    roberts_mesh mesh;
    oracle_view view; /* without a near plane */
    bool even_odd;
    bool united;  /* closed bodies, drawn as one */
    bool seams;   /* instead of edges: lines where flat edges, which are not drawn, lie in faces */
    double slack; /* model units: effects of moves this large are not judged; 0: judged strictly */
} mesh_scene;

typedef struct mesh_total {
    size_t scenes, edges, hidden, cut; /* compared; completely hidden; partly hidden */
    size_t lines, lines_cut;           /* intersection lines; those hidden partly or completely */
    size_t lines_left_out;             /* lines without rows of which nothing can be seen */
    size_t disagreements;              /* edges, lines, or whole scenes that the program refused */
    size_t refused;                    /* scenes that the oracle refused */
    double unjudged;                   /* length in t that was not judged because of slack; a whole edge counts 1 */
    double worst;                      /* greatest difference on an edge that did not fail */
    size_t pairs, exact;               /* as in mesh_truth */
} mesh_total;

/* An edge fails if program and oracle differ on more than this fraction of it. */
#define MESH_JUDGE_LIMIT 1e-9

/* Compares all edges and adds to `total`. Reports the first few failures to `out`, with the command that draws the
 * scene, which is written to FOLDER/failures/NAME.off. Returns whether everything agreed. */
bool mesh_judge(const char *name, const mesh_scene *scene, const char *folder, mesh_total *total, FILE *out);

#endif
