/* uniform.h - the regular and semiregular solids and their duals. */
#ifndef MODELS_UNIFORM_H
#define MODELS_UNIFORM_H

#include "body.h"

enum { PLATONIC_COUNT = 5, ARCHIMEDEAN_COUNT = 13, UNIFORM_COUNT = PLATONIC_COUNT + ARCHIMEDEAN_COUNT };

/* The five Platonic, then the thirteen Archimedean solids. */
enum uniform_solid {
    TETRAHEDRON,
    CUBE,
    OCTAHEDRON,
    DODECAHEDRON,
    ICOSAHEDRON,
    TRUNCATED_TETRAHEDRON,
    CUBOCTAHEDRON,
    TRUNCATED_CUBE,
    TRUNCATED_OCTAHEDRON,
    RHOMBICUBOCTAHEDRON,
    TRUNCATED_CUBOCTAHEDRON,
    SNUB_CUBE,
    ICOSIDODECAHEDRON,
    TRUNCATED_DODECAHEDRON,
    TRUNCATED_ICOSAHEDRON,
    RHOMBICOSIDODECAHEDRON,
    TRUNCATED_ICOSIDODECAHEDRON,
    SNUB_DODECAHEDRON,
};

/* Describe the solid and how its coordinates are made, and its Catalan dual, for the file's comment. */
const char *uniform_about(int solid);
const char *catalan_about(int solid);

/* Adds the solid, centred at the origin. */
void uniform_make(body *b, int solid);

/* Adds the polar reciprocal of an Archimedean solid with respect to its midsphere. */
void catalan_make(body *b, int solid);

/* ---- solids over regular polygons, n >= 3 corners on circles of radius 1 about the z axis ---------------------- */

void prism_make(body *b, uint32_t n);     /* side faces are squares */
void antiprism_make(body *b, uint32_t n); /* side faces are equilateral triangles */

/* Adds a prism of the given radius between two heights, exact in z. */
void column_make(body *b, uint32_t n, double radius, double z0, double z1);

/* Adds a pyramid over such a polygon at height z0 with its apex at z1. */
void cone_make(body *b, uint32_t n, double radius, double z0, double z1);

/* Adds a ball of radius 1 with `rings` + 1 parallels, including the poles, and `sides` meridians. */
void globe_make(body *b, uint32_t rings, uint32_t sides);

#endif
