/* large.h - shared by the scenes of any size: their arguments, the meshes of meshes.c, and hard.c. */
#ifndef MODELS_LARGE_H
#define MODELS_LARGE_H

#include "body.h"

/* The arguments of a scene, and bodies used in it, centred at the origin. */
typedef struct plan {
    uint64_t n, seed;
    body tetrahedron, cube, octahedron, icosahedron;
    body part; /* made once before the scene, if its family prepares one */
} plan;

/* ---- meshes.c: bodies that are not convex, of many triangles; all coordinates are integers ---------------------- */

void scan_prepare(plan *p);
void ball_prepare(plan *p);
void boulder_prepare(plan *p);
void terrain_prepare(plan *p);

uint64_t thousand(uint64_t n);
void part_solid(body *b, const plan *p, uint64_t index);
void balls_solid(body *b, const plan *p, uint64_t index);
void crossing_solid(body *b, const plan *p, uint64_t index);
void stars_solid(body *b, const plan *p, uint64_t index);
void soup_solid(body *b, const plan *p, uint64_t index);

/* ---- hard.c: scenes that are hard for a grid ------------------------------------------------------------------ */

uint64_t crowd_count(uint64_t n);
void boards_solid(body *b, const plan *p, uint64_t index);
void diagonal_solid(body *b, const plan *p, uint64_t index);
void crowd_solid(body *b, const plan *p, uint64_t index);
void galaxy_solid(body *b, const plan *p, uint64_t index);
void sheets_solid(body *b, const plan *p, uint64_t index);
void floors_solid(body *b, const plan *p, uint64_t index);
void spines_solid(body *b, const plan *p, uint64_t index);
void posts_solid(body *b, const plan *p, uint64_t index);
void shells_solid(body *b, const plan *p, uint64_t index);

#endif
