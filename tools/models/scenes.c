/* scenes.c - scenes for pictures. All contacts are exact: heights are integers or halves, and the lowest face of a
 * turned solid gets exactly its height. */
#include "exact.h"
#include "figures.h"
#include "models.h"
#include "stand.h"
#include "uniform.h"

/* ---- cubes ----------------------------------------------------------------------------------------------------- */

static void cube_behind_cube(body *b)
{
    body_box(b, vec3(0, 0, 0), vec3(4, 4, 4));
    body_box(b, vec3(-5, 3, -1), vec3(-1, 7, 3));
}

static void cube_hidden_by_cube(body *b)
{
    body_box(b, vec3(0, 0, 0), vec3(4, 4, 4));
    body_box(b, vec3(-6, 6, -6), vec3(-2, 10, -2));
}

static void interpenetrating_cubes(body *b)
{
    body_box(b, vec3(0, 0, 0), vec3(6, 6, 6));
    body_box(b, vec3(4, 2, 2), vec3(10, 8, 8));
}

/* The rotation of a cube by a sixth turn about its diagonal, the quaternion 3 + i + j + k, is a matrix of thirds. */
static void compound_of_two_cubes(body *b)
{
    body cube = {0};
    body_box(&cube, vec3(-3, -3, -3), vec3(3, 3, 3));
    body_add(b, &cube, turn(1, 0, 0, 0, 1, vec3(0, 0, 0)));
    body_add(b, &cube, turn(3, 1, 1, 1, 1, vec3(0, 0, 0)));
    body_free(&cube);
}

/* A cube turned by an eighth turn about each of its three axes: its corners are (+-1, 0, +-sqrt 2), (+-1, +-sqrt 2, 0)
 * and their cyclic permutations. */
static void compound_of_three_cubes(body *b)
{
    double h = sqrt(0.5);
    body cube = {0};
    motion axis[3] = {{{{1, 0, 0}, {0, h, -h}, {0, h, h}}, {0, 0, 0}},
                      {{{h, 0, h}, {0, 1, 0}, {-h, 0, h}}, {0, 0, 0}},
                      {{{h, -h, 0}, {h, h, 0}, {0, 0, 1}}, {0, 0, 0}}};
    uniform_make(&cube, CUBE);
    for (int i = 0; i < 3; i++)
        body_add(b, &cube, axis[i]);
    body_free(&cube);
}

/* The second tetrahedron is the first turned by a quarter turn. */
static void stella_octangula(body *b)
{
    body tetrahedron = {0};
    uniform_make(&tetrahedron, TETRAHEDRON);
    body_add(b, &tetrahedron, turn(1, 0, 0, 0, 1, vec3(0, 0, 0)));
    body_add(b, &tetrahedron, turn(1, 0, 0, 1, 1, vec3(0, 0, 0)));
    body_free(&tetrahedron);
}

/* ---- things that stand on one another -------------------------------------------------------------------------- */

/* A flight away from the viewer, a landing, and a second flight to the left; every step is a block down to the
 * floor. */
static void staircase(body *b)
{
    for (int i = 0; i < 8; i++)
        body_box(b, vec3(0, 2 * i, 0), vec3(8, 2 * i + 2, i + 1));
    body_box(b, vec3(0, 16, 0), vec3(8, 24, 8));
    for (int i = 0; i < 6; i++)
        body_box(b, vec3(-2 * i - 2, 16, 0), vec3(-2 * i, 24, 9 + i));
}

/* Cubes of size 2 in layers of 4 x 4, 3 x 3, 2 x 2, each over the joints of the one below, and a pyramid. */
static void stacked_blocks(body *b)
{
    for (int layer = 0; layer < 3; layer++)
        for (int i = 0; i < 4 - layer; i++)
            for (int j = 0; j < 4 - layer; j++) {
                roberts_vec3 lo = {2 * i + layer, 2 * j + layer, 2 * layer};
                body_box(b, lo, vec3_add(lo, vec3(2, 2, 2)));
            }
    body_pyramid(b, vec3(3, 3, 6), vec3(5, 5, 8));
}

/* Each floor is turned by 2 atan(1/24), about 4.8 degrees, relative to the one below. */
static void tower(body *b)
{
    roberts_vec2 step = half_angle(1.0 / 24), a = {1, 0};
    body_box(b, vec3(-6, -6, -1), vec3(6, 6, 0));
    for (int i = 0; i < 24; i++) {
        body_turned_box(b, vec3(-4, -4, i), vec3(4, 4, i + 1), a.x, a.y);
        a = (roberts_vec2){a.x * step.x - a.y * step.y, a.x * step.y + a.y * step.x};
    }
}

/* ---- the table ------------------------------------------------------------------------------------------------- */

enum { TABLE_HEIGHT = 16 };

static void table_frame(body *b)
{
    const double under = TABLE_HEIGHT - 1; /* of the board */
    body_box(b, vec3(0, 0, under), vec3(36, 24, TABLE_HEIGHT));
    for (int i = 0; i < 4; i++) {
        double x = i % 2 ? 33 : 1, y = i / 2 ? 21 : 1;
        body_box(b, vec3(x, y, 0), vec3(x + 2, y + 2, under));
    }
    body_box(b, vec3(3, 1.5, under - 3), vec3(33, 2.5, under)); /* between the legs */
    body_box(b, vec3(3, 21.5, under - 3), vec3(33, 22.5, under));
    body_box(b, vec3(1.5, 3, under - 3), vec3(2.5, 21, under));
    body_box(b, vec3(33.5, 3, under - 3), vec3(34.5, 21, under));
}

/* Three books, and a ball of squares on them. */
static void books(body *b, double x, double y)
{
    static const double half[3][2] = {{4.5, 3.25}, {4, 3}, {3.25, 2.5}}, tangent[3] = {0, 0.125, -0.0625};
    const double thick = 1.25;
    for (int i = 0; i < 3; i++) {
        double z = TABLE_HEIGHT + i * thick;
        roberts_vec2 a = half_angle(tangent[i]);
        body_turned_box(b, vec3(x - half[i][0], y - half[i][1], z), vec3(x + half[i][0], y + half[i][1], z + thick),
                        a.x, a.y);
    }
    stand_uniform(b, RHOMBICUBOCTAHEDRON, 4, 1, vec3(x, y, TABLE_HEIGHT + 3 * thick), half_angle(0.25));
}

/* Two pillars and what they support. */
static void gate(body *b, double x, double y)
{
    const double z = TABLE_HEIGHT;
    body_box(b, vec3(x - 1, y - 4, z), vec3(x + 1, y - 2, z + 5));
    body_box(b, vec3(x - 1, y + 2, z), vec3(x + 1, y + 4, z + 5));
    body_box(b, vec3(x - 1.5, y - 5, z + 5), vec3(x + 1.5, y + 5, z + 6.5));
    body_pyramid(b, vec3(x - 1, y - 2, z + 6.5), vec3(x + 1, y + 2, z + 9));
}

static void table(body *b)
{
    const double z = TABLE_HEIGHT;
    table_frame(b);
    books(b, 7, 17.5);
    stand_uniform(b, TRUNCATED_ICOSAHEDRON, 6, 0.75, vec3(18, 18, z), half_angle(0.25));
    stand_round(b, false, 12, 2, 7, vec3(28.5, 20, z));
    stand_round(b, true, 12, 2, 4, vec3(28.5, 20, z + 7));
    stand_uniform(b, DODECAHEDRON, 5, 1.75, vec3(5, 7, z), half_angle(0.25));
    body_pyramid(b, vec3(10, 8, z), vec3(16, 14, z + 6));
    stand_uniform(b, ICOSAHEDRON, 3, 1.75, vec3(20, 8, z), half_angle(0.5));
    gate(b, 30, 11);
    body_turned_box(b, vec3(30, 2, z), vec3(33.5, 5.5, z + 3.5), half_angle(0.25).x, half_angle(0.25).y);
    stand_uniform(b, OCTAHEDRON, 3, 1.75, vec3(31.75, 3.75, z + 3.5), half_angle(0.75));
    stand_uniform(b, CUBOCTAHEDRON, 3, 1.75, vec3(12.5, 3.5, z), half_angle(0.625));
    stand_uniform(b, TETRAHEDRON, 3, 1.5, vec3(25.5, 2.5, z), half_angle(-0.125));
}

/* ---- a temple -------------------------------------------------------------------------------------------------- */

/* Adds the roof over the rectangle lo.x..hi.x, lo.y..hi.y: its ridge runs along y at height hi.z. */
static void roof(body *b, roberts_vec3 lo, roberts_vec3 hi)
{
    double middle = (lo.x + hi.x) / 2;
    uint32_t v = body_vertex(b, lo.x, lo.y, lo.z);
    body_vertex(b, hi.x, lo.y, lo.z);
    body_vertex(b, middle, lo.y, hi.z);
    body_vertex(b, lo.x, hi.y, lo.z);
    body_vertex(b, hi.x, hi.y, lo.z);
    body_vertex(b, middle, hi.y, hi.z);
    body_face(b, (uint32_t[]){v + 1, v + 4, v + 5, v + 2}, 4);
    body_face(b, (uint32_t[]){v + 3, v, v + 2, v + 5}, 4);
    body_face(b, (uint32_t[]){v, v + 3, v + 4, v + 1}, 4);
    body_face(b, (uint32_t[]){v, v + 1, v + 2}, 3);
    body_face(b, (uint32_t[]){v + 3, v + 5, v + 4}, 3);
}

/* 4 by 6 columns around a room, on three steps; everything touches. */
static void temple(body *b)
{
    for (int i = 0; i < 3; i++) {
        double out = 6 - 1.5 * i;
        body_box(b, vec3(-out, -out, i), vec3(18 + out, 30 + out, i + 1));
    }
    body_box(b, vec3(4, 5, 3), vec3(14, 25, 17));
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 6; j++) {
            if (i % 3 != 0 && j % 5 != 0)
                continue;
            stand_round(b, false, 12, 1.5, 13, vec3(6 * i, 6 * j, 3));
            body_box(b, vec3(6 * i - 2, 6 * j - 2, 16), vec3(6 * i + 2, 6 * j + 2, 17));
        }
    body_box(b, vec3(-2, -2, 17), vec3(20, 32, 19));
    roof(b, vec3(-3, -3, 19), vec3(21, 33, 25));
}

static const scene scenes[] = {
    {"cube-behind-cube", "A cube behind a cube: the corner and parts of the edges of the farther one are hidden.",
     cube_behind_cube},
    {"cube-hidden-by-cube",
     "A cube exactly behind a cube of the same size, as seen from (1, -1, 1) (--view iso): it is hidden altogether.",
     cube_hidden_by_cube},
    {"interpenetrating-cubes", "Two cubes through one another; edges end where they pierce the other cube.",
     interpenetrating_cubes},
    {"compound-of-two-cubes",
     "Two cubes about one centre, the second turned by 60 degrees about a diagonal; all coordinates are integers, and\n"
     "edges cross edges.",
     compound_of_two_cubes},
    {"compound-of-three-cubes", "Three cubes about one centre, each turned by 45 degrees about one of the axes.",
     compound_of_three_cubes},
    {"stella-octangula", "Two tetrahedra through one another, the corners of a cube.", stella_octangula},
    {"staircase", "A staircase of two flights with a landing, of blocks that touch.", staircase},
    {"stacked-blocks", "A pyramid of 29 cubes that touch, each layer over the joints of the one below, and its tip.",
     stacked_blocks},
    {"tower",
     "A tower of 24 square floors, each turned against the one below by the angle whose half has tangent 1/24.", tower},
    {"temple", "A temple: steps, columns with twelve sides, a room, beams and a roof, all of which touch.", temple},
    {"table", "A table, made of boxes that touch, and solids that stand on it exactly.", table},
    {"chair", "A chair, in centimetres; all its parts touch.", chair},
    {"spiral-staircase",
     "A spiral staircase: 16 steps a turn, each of them touching a side of the column, with posts and a rail.",
     spiral_staircase},
    {"octahedra", "An octahedron of 216 octahedra that touch at their corners: six at half the size, three times over.",
     octahedra},
    {"icosahedra",
     "An icosahedron of 144 icosahedra that touch along edges: twelve, smaller by the golden section's square, twice "
     "over.",
     icosahedra},
    {"cubic-space", "Cubes at the points of a cubic lattice, and the bars that join them; all touch.", cubic_space},
    {"platonic-solids", "The five regular solids in a row on a board, each with its corners on a sphere of one size.",
     platonic_solids},
    {"archimedean-solids",
     "The thirteen half-regular solids side by side, each with its corners on a sphere of one size.",
     archimedean_solids},
    {"compound-of-five-tetrahedra", "Five tetrahedra through one another, the corners of a dodecahedron.",
     five_tetrahedra},
    {"menger-sponge", "Menger sponge of level 2, of 400 cubes that touch.", menger_sponge},
    {"locomotive", "A locomotive of blocks and columns that touch or go through one another.", locomotive},
    {"crystals",
     "Crystals by their forms, axial ratios after Dana: galena {100} {111}, garnet {110} {211}, pyrite {210} {100}, "
     "zircon\n"
     "{100} {111}; quartz {10-10} {10-11} {01-11}, calcite {21-31} {10-11}, topaz {110} {021} {111} {001}, sulphur "
     "{111}\n"
     "{113} {011} {001}.",
     crystals},
};

size_t scene_count(void)
{
    return sizeof scenes / sizeof *scenes;
}

const scene *scene_at(size_t i)
{
    return &scenes[i];
}
