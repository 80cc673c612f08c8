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
    bool united;  /* closed bodies that are drawn as one */
    double slack; /* model units: what could change if things moved so far is not judged; 0: judged strictly */
} mesh_scene;

typedef struct mesh_total {
    size_t scenes, edges, hidden, cut; /* compared; completely hidden; partly hidden */
    size_t lines, lines_cut;           /* intersection lines; those hidden partly or completely */
    size_t on_edges;                   /* those of them that lie on edges that are left out */
    size_t disagreements;              /* edges, lines, or whole scenes that the program refused */
    size_t refused;                    /* scenes that the oracle refused */
    double unjudged;                   /* length in t that was not judged because of slack; a whole edge counts 1 */
    double worst;                      /* greatest difference on an edge that did not fail */
    size_t pairs, exact;               /* as in mesh_truth */
} mesh_total;

/* An edge fails if program and oracle differ on more than this fraction of it. */
#define MESH_JUDGE_LIMIT 1e-9

/* Returns the library's camera for the scene's viewer. */
roberts_camera mesh_judge_camera(const mesh_scene *scene);

/* Writes the scene to FOLDER/failures/NAME.off, and tells the command that draws it with these options. */
void mesh_judge_keep(const char *name, const mesh_scene *scene, const char *options, const char *folder, FILE *out);

/* Draws all edges and compares them and the lines in which faces cross; then leaves flat edges out and compares these
 * lines again. What is visible must be the same without hidden lines. Adds to `total`. The first few that fail are told
 * on `out`, with the command that draws the scene, which is written to FOLDER/failures/NAME.off. Returns whether
 * everything agreed. */
bool mesh_judge(const char *name, const mesh_scene *scene, const char *folder, mesh_total *total, FILE *out);

#endif
