/* studio.h - builds the scenes of the families: first the solids, then the viewer. */
#ifndef ROBERTS_TESTS_STUDIO_H
#define ROBERTS_TESTS_STUDIO_H

#include "families.h"
#include "shapes.h"

enum { STUDIO_SOLIDS = 1024 };

/* For rounded contacts: effects of moves of this fraction of the largest coordinate are not judged. */
#define ROUNDING 1e-13

typedef struct studio {
    test_scene *scene;
    rng d;
    double unit;    /* the eye's coordinates are multiples of it */
    bool eye;       /* perspective wanted, from outside */
    bool no_memory; /* checked once, at the end */
    uint32_t solid_count, first_face[STUDIO_SOLIDS];
} studio;

/* A point with integer coordinates from lo to hi, or with real ones from -1 to 1. x is drawn first, then y, then z. As
 * arguments of one call, or in one initializer, they would be drawn in an order chosen by the compiler. */
roberts_vec3 whole_point(studio *st, int lo, int hi);
roberts_vec3 real_point(studio *st);

/* Adds the shape; each point p goes to at + m p, where the rows of m give the images' coordinates. Each face gets
 * either winding. */
void put_mapped(studio *st, const shape *s, roberts_vec3 at, double m[3][3]);
void put_scaled(studio *st, const shape *s, roberts_vec3 at, double x, double y, double z);
void put(studio *st, const shape *s, double x, double y, double z);
void put_at(studio *st, const shape *s, roberts_vec3 at);
void put_box(studio *st, roberts_vec3 low, roberts_vec3 high);
void put_turned(studio *st, const shape *s, roberts_vec3 at, double size);

/* Sets a viewer at infinity. */
void look(studio *st, double x, double y, double z);
void look_small(studio *st, int size);
void look_axis(studio *st);
void look_corner(studio *st);
void look_random(studio *st);
/* Sets a viewer at z, and up to `aside` from there. */
void look_down(studio *st, double aside, double z);
void look_any(studio *st);
/* Keeps the direction, but changes the viewer: an eye well in front of the scene; an eye amid the scene, with a near
 * plane that cuts some of it; an eye just in front of a corner; an eye in a face's plane or at a corner, with a near
 * plane; a parallel view of a section; or an oblique view. Call it after all solids have been added. */
void look_from_eye(studio *st);
void look_from_amid(studio *st);
void look_from_close(studio *st);
void look_from_face_plane(studio *st);
void look_at_section(studio *st);
void look_oblique(studio *st);

/* Gives the program the faces as triangles without shared vertices, in any order, through its reader. No two solids may
 * have a corner at the same position. */
void give_as_soup(studio *st);

/* Gives the program only the points of each solid, to take their hulls. */
void give_as_points(studio *st);

/* Excludes from judgement distances close to the touching distance. Call it last. */
void near_touching(studio *st);

void map_vertices(studio *st, double scale, roberts_vec3 shift);
/* Maps every vertex by m. */
void map_vertices_by(studio *st, double m[3][3]);
/* Keeps the scene as the original, and maps every vertex and the viewer by m, or scales them. */
void spoil(studio *st, double m[3][3]);
void spoil_scale(studio *st, double scale);

#endif
