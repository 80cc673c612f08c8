/* test_bodies.c - bodies that are not convex: their kinds, the classes of their lines, and what hides them. The mesh
 * oracle compares whole pictures with exact numbers. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "build_scene.h"
#include "roberts.h"
#include "testing.h"

typedef struct body_case {
    const char *name, *text; /* OFF */
    roberts_vec3 dir;
    const char *kinds; /* x convex, c closed, o open: body by body */
    double outline, border, crease,
        wire; /* visible length of each class, in edges of length 1 along the axes of the picture */
    bool even_odd, all_edges;
} body_case;

#define ROOT_5 2.2360679774997898
#define ROOT_10 3.1622776601683795
#define ROOT_13 3.6055512754639891
#define ROOT_2 1.41421356237309504880
#define TOP                                                                                                            \
    {                                                                                                                  \
        0, 0, 1                                                                                                        \
    }
#define FRONT                                                                                                          \
    {                                                                                                                  \
        0, -1, 0                                                                                                       \
    }

#define BACK                                                                                                           \
    {                                                                                                                  \
        0, 1, 0                                                                                                        \
    }

#define SQUARE "4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"
#define CROSSED "5 1 0\n0 3 0\n2 -3 0\n-3 1 0\n3 1 0\n-2 -3 0\n5 0 1 2 3 4\n"

/* The triangle beside edge 0-1 in one face may lie in the plane of that in the other face. */
#define TWISTED "6 2 0\n0 -1 0\n0 1 0\n1 -1 -.3\n1 1 .3\n-1 -1 .3\n-1 1 -.3\n"

/* Two L-blocks, 1 high, upon one another, between vertices 0 to 5, 6 to 11 and 12 to 17. */
#define L_RING(z) "0 0 " #z "\n2 0 " #z "\n2 1 " #z "\n1 1 " #z "\n1 2 " #z "\n0 2 " #z "\n"
#define L_BLOCKS(faces) "20 " #faces " 0\n" L_RING(0) L_RING(1) L_RING(2) "-1 0 1\n0 -1 1\n"
#define L_SIDES(a, b, c, d, e, f, A, B, C, D, E, F)                                                                    \
    "4 " #a " " #b " " #B " " #A "\n4 " #b " " #c " " #C " " #B "\n4 " #c " " #d " " #D " " #C "\n"                    \
    "4 " #d " " #e " " #E " " #D "\n4 " #e " " #f " " #F " " #E "\n4 " #f " " #a " " #A " " #F "\n"
#define L_BLOCK_ON(a, b, c, d, e, f, A, B, C, D, E, F)                                                                 \
    L_SIDES(a, b, c, d, e, f, A, B, C, D, E, F)                                                                        \
    "6 " #f " " #e " " #d " " #c " " #b " " #a "\n6 " #A " " #B " " #C " " #D " " #E " " #F "\n"

/* Blocks whose top has a corner on one of its sides. */
#define V_RING(z) "0 0 " #z "\n4 0 " #z "\n4 3 " #z "\n2 0 " #z "\n0 3 " #z "\n"
#define V_BLOCK_ON(a, b, c, d, e, A, B, C, D, E)                                                                       \
    "5 " #e " " #d " " #c " " #b " " #a "\n5 " #A " " #B " " #C " " #D " " #E "\n4 " #a " " #b " " #B " " #A "\n4 " #b \
    " " #c " " #C " " #B "\n4 " #c " " #d " " #D " " #C "\n4 " #d " " #e " " #E " " #D "\n4 " #e " " #a " " #A " " #E  \
    "\n"

/* Lengths are measured in the picture: an edge along the line of sight has none. */
static const body_case cases[] = {
    {"a sheet", "OFF\n" SQUARE, TOP, "o", 0, 4, 0, 0, false, false},
    {"a sheet from below", "OFF\n" SQUARE, {0, 0, -1}, "o", 0, 4, 0, 0, false, false},
    {"a sheet edge-on is a line, four times", "OFF\n" SQUARE, FRONT, "o", 0, 2, 0, 0, false, false},
    {"two triangles are a sheet", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n", TOP, "o", 0, 4, 0, 0,
     false, false},
    {"... wound against one another", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 3 2\n", TOP, "o", 0, 4, 0,
     0, false, false},
    {"... with all edges", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n", TOP, "o", 0, 4, ROOT_2, 0,
     false, true},
    {"... with corners of their own", "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 0\n1 1 0\n3 0 1 2\n3 4 5 3\n", TOP,
     "o", 0, 4, 0, 0, false, false},
    {"the same face three times", "OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n4 2 1 0 3\n4 1 2 3 0\n", TOP, "o",
     0, 4, 0, 0, false, false},
    {"closed parts that share a vertex are split, not welded with a triangle that touches them",
     "OFF\n10 9 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n1 0 0\n0 1 0\n2 2 0\n3 0 1 2\n3 0 2 3\n3 0 3 1\n"
     "3 1 3 2\n3 0 4 5\n3 0 5 6\n3 0 6 4\n3 4 6 5\n3 7 9 8\n",
     TOP, "xxo", ROOT_2 + 2 + ROOT_2 + 2, ROOT_2 + 2 * ROOT_5, 0, 0, false, false},
    {"a vertex divides a side", "OFF\n6 3 0\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n1 1 0\n1 2 0\n4 0 1 2 3\n3 3 4 5\n3 4 2 5\n",
     TOP, "o", 0, 4 + 2 * ROOT_2, 0, 0, false, false},
    {"a side on half of another, within rounding",
     "OFF\n7 2 0\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n1 1.0000000000000002 0\n2 1 0\n"
     "2 2 0\n4 0 1 2 3\n3 4 5 6\n",
     TOP, "o", 0, 2 + 1 + 1 + 1 + 1 + ROOT_2, 0, 0, false, false},
    {"twisted faces that meet at an angle", "OFF\n" TWISTED "4 0 1 3 2\n4 5 1 0 4\n", TOP, "o", 0, 8, 2, 0, false,
     false},
    {"... that begin with other corners", "OFF\n" TWISTED "4 1 3 2 0\n4 4 5 1 0\n", TOP, "o", 0, 8, 2, 0, false, false},
    {"a fold is outline from where it is one",
     "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0.5 1\n0 0.5 1\n4 0 1 4 5\n4 3 2 4 5\n", FRONT, "o", 1, 1 + 1 + 1, 0, 0,
     false, false},
    {"... and a crease from above", "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0.5 1\n0 0.5 1\n4 0 1 4 5\n4 3 2 4 5\n",
     TOP, "o", 0, 4, 1, 0, false, false},
    {"three sheets at an edge",
     "OFF\n8 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 -1 0\n0 -1 0\n1 0 1\n0 0 1\n4 0 1 2 3\n4 0 1 4 5\n"
     "4 0 1 6 7\n",
     TOP, "o", 0, 6 + 1, 1, 0, false, false}, /* the third is edge-on: it hides nothing */
    /* 2 sqrt 40 (1/3 + 8/19) + 2 sqrt 41 (2/5 + 7/19) + 6 * 7/9: its inner pentagon has the face on both sides */
    {"a pentagram", "OFF\n" CROSSED, TOP, "o", 0, 24.049569135931204, 0, 0, false, false},
    {"a pentagram between two copies of a square",
     "OFF\n9 3 0\n0 3 0\n2 -3 0\n-3 1 0\n3 1 0\n-2 -3 0\n4 0 0\n5 0 0\n5 1 0\n4 1 0\n4 5 6 7 8\n5 0 1 2 3 4\n"
     "4 5 6 7 8\n",
     TOP, "oo", 0, 24.049569135931204 + 4, 0, 0, false, false},
    {"a slit bounds nothing",
     "OFF\n8 1 0\n0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 0\n1 2 0\n2 2 0\n2 1 0\n10 0 1 2 3 0 4 5 6 7 4\n", TOP, "o", 0,
     12 + 4, 0, 0, false, false},
    {"a square behind a hole",
     "OFF\n12 2 0\n0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 0\n1 2 0\n2 2 0\n2 1 0\n"
     "0.5 1.25 -1\n2.5 1.25 -1\n2.5 1.75 -1\n0.5 1.75 -1\n"
     "10 0 1 2 3 0 4 5 6 7 4\n4 8 9 10 11\n",
     TOP, "oo", 0, 12 + 4 + 2, 0, 0, false, false},
    {"a wire", "OFF\n2 1 0\n0 0 0\n1 0 0\n2 0 1\n", TOP, "o", 0, 0, 0, 1, false, false},
    {"wires that meet, alone", "OFF\n5 3 0\n0 0 0\n1 0 0\n0.5 0 0\n0.5 1 0\n2 1 0\n2 0 1\n2 2 3\n2 3 4\n", TOP, "o", 0,
     0, 0, 3.5, false, false},
    {"a wire before a sheet and behind it",
     "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 -0.5 1\n0.5 1.5 -1\n4 0 1 2 3\n2 4 5\n", TOP, "oo", 0, 4, 0, 1.5,
     false, false},
    {"a wire on an edge is none", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n2 1 0\n", TOP, "o", 0, 4, 0, 0,
     false, false},
    {"a face without area is wires", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n", TOP, "o", 0, 0, 0, 2, false, false},
    {"two faces at an edge that a third divides: it crosses itself there",
     "OFF\n6 3 0\n0 0 0\n4 0 0\n4 2 0\n0 -2 0\n2 -1 2\n2 -1 -2\n4 0 1 2 3\n3 0 1 4\n3 0 1 5\n", FRONT, "o", 0,
     8 * ROOT_2 + 2, 4, 0, false, false},
    {"an edge ends where no piece of its faces has a corner: 1 and 2 coincide in the coordinate plane",
     "OFF\n5 2 0\n0 0 0\n0 3 0\n0 3 2\n4 3 0\n0 6 0\n4 0 1 2 3\n4 4 1 2 3\n", TOP, "o", 0, 3 + 5 + 3 + 5, 4, 0, false,
     true},
    {"... from the front, where the side from 1 to 2 has a length",
     "OFF\n5 2 0\n0 0 0\n0 3 0\n0 3 2\n4 3 0\n0 6 0\n4 0 1 2 3\n4 4 1 2 3\n", FRONT, "o", 2 + 2 * ROOT_5, 4 + 4, 0, 0,
     false, true},
    {"a face that is not planar is an outline at its cut: beyond it, it is edge-on",
     "OFF\n4 1 0\n0 0 0\n2 0 0\n2 1 2\n0 2 0\n4 0 1 2 3\n", BACK, "o", 2, 2 + 2 * ROOT_2, 0, 0, false, false},
    {"... with another such face along the cut, that does not fold",
     "OFF\n5 2 0\n3 3 0\n0 0 3\n1 2 0\n3 2 3\n1 3 1\n4 3 4 2 1\n4 1 3 0 2\n", BACK, "o", ROOT_10 + 3 + ROOT_13,
     2 + 3 + 1 + 2 * ROOT_2, 0, 0, false, false},
    {"... through it along the cut: a line as the edge of four faces is, although neither folds",
     "OFF\n6 2 0\n-2 0 0\n0 -3 1\n2 0 0\n0 3 1\n0 -3 -1\n0 3 -1\n4 0 1 2 3\n4 0 4 2 5\n", TOP, "o", 0, 4 * ROOT_13, 4,
     0, false, false},
    {"washers on one another, whose faces have slits to the holes: neither is welded",
     "OFF\n32 20 0\n0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 0\n1 2 0\n2 2 0\n2 1 0\n0 0 1\n3 0 1\n3 3 1\n0 3 1\n"
     "1 1 1\n1 2 1\n2 2 1\n2 1 1\n0 0 1\n3 0 1\n3 3 1\n0 3 1\n1 1 1\n1 2 1\n2 2 1\n2 1 1\n0 0 2\n3 0 2\n"
     "3 3 2\n0 3 2\n1 1 2\n1 2 2\n2 2 2\n2 1 2\n10 0 1 2 3 0 4 5 6 7 4\n10 8 9 10 11 8 12 13 14 15 12\n"
     "4 0 1 9 8\n4 1 2 10 9\n4 2 3 11 10\n4 3 0 8 11\n4 4 5 13 12\n4 5 6 14 13\n4 6 7 15 14\n4 7 4 12 15\n"
     "10 16 17 18 19 16 20 21 22 23 20\n10 24 25 26 27 24 28 29 30 31 28\n4 16 17 25 24\n4 17 18 26 25\n"
     "4 18 19 27 26\n4 19 16 24 27\n4 20 21 29 28\n4 21 22 30 29\n4 22 23 31 30\n4 23 20 28 31\n",
     TOP, "cc", 12 + 4, 0, 0, 0, false, false},
    {"L-blocks on one another that have all vertices of a face in common, each with a face there",
     "OFF\n" L_BLOCKS(16) L_BLOCK_ON(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11)
         L_BLOCK_ON(6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17),
     TOP, "cc", 8, 0, 0, 0, false, false},
    {"... with a face for both: it is one body",
     "OFF\n" L_BLOCKS(15) L_BLOCK_ON(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11)
         L_SIDES(6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17) "6 12 13 14 15 16 17\n",
     TOP, "o", 8, 0, 0, 0, false, false},
    {"... and a triangle at a vertex of both",
     "OFF\n" L_BLOCKS(17) L_BLOCK_ON(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11)
         L_BLOCK_ON(6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17) "3 6 18 19\n",
     TOP, "cco", 8, 2 + ROOT_2, 0, 0, false, false},
    {"two solids upon one another, a corner of each on a side of its own",
     "OFF\n20 14 0\n" V_RING(0) V_RING(1) V_RING(1) V_RING(2) V_BLOCK_ON(0, 1, 2, 3, 4, 5, 6, 7, 8, 9)
         V_BLOCK_ON(10, 11, 12, 13, 14, 15, 16, 17, 18, 19),
     TOP, "cc", 10 + 2 * ROOT_13, 0, 0, 0, false, false},
    {"sides on one line, which another side crosses",
     "OFF\n6 1 0\n0 2 0\n1 1 0\n3 3 0\n0 1 0\n2 0 0\n1 3 0\n7 0 1 2 3 0 4 5\n", TOP, "o", 0,
     (0.4 + 1 + 1 + 1.5) * ROOT_2 + 1 + (6.0 / 11 + 0.2) * ROOT_13 + (0.5 + 4.0 / 11) * ROOT_10, 0, 0, false, false},
    {"a spike hides nothing, though rounding gives it a width",
     "OFF\n6 2 0\n0 0 0\n0.9 0.3 0\n0.3 0.1 0\n0 1 0\n0.6 0.2 -1\n0.75 0.25 -1\n4 0 1 2 3\n2 4 5\n", TOP, "oo", 0,
     0.1 * ROOT_10 + 0.3 * ROOT_10 + 1, 0, 0.05 * ROOT_10, false, false},
    {"two boxes with a vertex on an edge each, and a wire between these vertices",
     "OFF\n18 13 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n0.5 0 0\n3 0 0\n4 0 0\n3 1 0\n"
     "4 1 0\n3 0 1\n4 0 1\n3 1 1\n4 1 1\n3.5 0 0\n5 0 2 3 1 8\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n"
     "4 1 3 7 5\n5 9 11 12 10 17\n4 13 14 16 15\n4 9 10 14 13\n4 11 15 16 12\n4 9 13 15 11\n4 10 12 16 14\n"
     "2 17 8\n",
     TOP, "coc", 8, 0, 0, 2, false, false},
    {"a box open above: one sees into it",
     "OFF\n8 5 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 1\n2 0 1\n2 2 1\n0 2 1\n4 0 1 2 3\n"
     "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n",
     TOP, "o", 8, 8, 0, 0, false, false},
};

/* Visible length of each class. */
static void measure(const roberts_drawing *drawing, double length[ROBERTS_BACK_OUTLINE + 1])
{
    for (int i = 0; i <= ROBERTS_BACK_OUTLINE; i++)
        length[i] = 0.0;
    for (size_t i = 0; i < drawing->count; i++) {
        const roberts_segment *s = &drawing->segment[i];
        assert_in_range(s->line, 0, ROBERTS_BACK_OUTLINE);
        assert_true(s->t0 < s->t1 && s->v0 < s->v1);
        assert_true(i == 0 || s[-1].v0 != s->v0 || s[-1].v1 != s->v1 || s[-1].t1 <= s->t0);
        length[s->line] += hypot(s->p1.x - s->p0.x, s->p1.y - s->p0.y);
    }
}

static roberts_scene *scene_of(const char *text, const roberts_scene_options *options)
{
    roberts_mesh mesh = mesh_of_text(text);
    roberts_scene *scene = scene_of_mesh(&mesh, options);
    roberts_mesh_free(&mesh);
    return scene;
}

static roberts_drawing drawing_along(const roberts_scene *scene, roberts_vec3 dir, bool all_edges)
{
    roberts_camera camera = {.dir = dir};
    roberts_hide_options options = roberts_hide_options_default();
    options.all_edges = all_edges;
    return drawing_of(scene, &camera, &options);
}

static void lines_have_their_classes(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const body_case *c = &cases[i];
        const double wanted[ROBERTS_BACK_OUTLINE + 1] = {c->outline, c->crease, 0.0, c->border, c->wire};
        roberts_scene *scene = scene_of(c->text, &(roberts_scene_options){.even_odd = c->even_odd});
        roberts_drawing drawing = drawing_along(scene, c->dir, c->all_edges);
        double length[ROBERTS_BACK_OUTLINE + 1];
        print_message("%s\n", c->name);
        assert_int_equal(roberts_scene_solid_count(scene), strlen(c->kinds));
        for (uint32_t s = 0; s < strlen(c->kinds); s++)
            assert_int_equal("xco"[roberts_scene_body_kind(scene, s)], c -> kinds[s]);
        measure(&drawing, length);
        for (int k = 0; k <= ROBERTS_BACK_OUTLINE; k++)
            if (fabs(length[k] - wanted[k]) > 1e-9)
                fail_msg("class %d: %.12g of lines instead of %.12g", k, length[k], wanted[k]);
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
}

/* Bodies that share vertices have copies of them inside, but their lines name those of the file. */
static void lines_name_vertices_of_the_file(void **state)
{
    roberts_scene *scene = scene_of_text("OFF\n" L_BLOCKS(16) L_BLOCK_ON(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11)
                                             L_BLOCK_ON(6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17));
    roberts_drawing drawing = drawing_along(scene, (roberts_vec3){1, -2, 1}, true);
    bool below = false, above = false;
    (void)state;
    for (size_t i = 0; i < drawing.count; i++) {
        const roberts_segment *s = &drawing.segment[i];
        below = below || (s->solid == 0 && s->v0 == 6 && s->v1 == 7);
        above = above || (s->solid == 1 && s->v0 == 6 && s->v1 == 7);
        assert_true(s->v1 < 18);
    }
    assert_true(below && above);
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
}

/* A cube far from the origin, with a shallow dent in its top. Its coordinates are 32-bit floats of more than six
 * digits, which are off by far less than the dent. */
static void a_dent_far_away(void **state)
{
    roberts_scene *scene = scene_of_text("OFF\n9 9 0\n3000.0009765625 -2000 1500\n3020.0009765625 -2000 1500\n"
                                         "3020.0009765625 -1980 1500\n3000.0009765625 -1980 1500\n"
                                         "3000.0009765625 -2000 1520\n3020.0009765625 -2000 1520\n"
                                         "3020.0009765625 -1980 1520\n3000.0009765625 -1980 1520\n"
                                         "3010.0009765625 -1990 1519.984375\n4 3 2 1 0\n4 0 1 5 4\n4 1 2 6 5\n"
                                         "4 2 3 7 6\n4 3 0 4 7\n3 4 5 8\n3 5 6 8\n3 6 7 8\n3 7 4 8\n");
    (void)state;
    assert_int_equal(roberts_scene_body_kind(scene, 0), ROBERTS_CLOSED);
    roberts_scene_free(scene);
}

/* A tube of 150 sides, made of 1200 triangles or 600 quadrilaterals. The radius of a ring may alternate, which makes a
 * star of it. */
static bool tube_is_curved(double outer_star, double inner_star, bool triangles)
{
    enum { SIDES = 150 };
    roberts_mesh mesh = {0};
    for (int i = 0; i < SIDES; i++) {
        const double angle = 2.0 * 3.14159265358979323846 * i / SIDES, c = cos(angle), s = sin(angle);
        for (int k = 0; k < 4; k++) {
            const double r = k % 2 ? 3.0 + (i % 2) * inner_star : 9.0 + (i % 2) * outer_star;
            mesh_vertex(&mesh, (roberts_vec3){r * c, r * s, k / 2});
        }
    }
    for (uint32_t i = 0; i < SIDES; i++) {
        const uint32_t a = 4 * i, b = 4 * ((i + 1) % SIDES);
        const uint32_t side[4][4] = {
            {a, b, b + 2, a + 2}, {a + 1, a + 3, b + 3, b + 1}, {a, a + 1, b + 1, b}, {a + 2, b + 2, b + 3, a + 3}};
        for (int k = 0; k < 4; k++) {
            const uint32_t *q = side[k];
            if (triangles) {
                mesh_face(&mesh, (uint32_t[]){q[0], q[1], q[2]}, 3);
                mesh_face(&mesh, (uint32_t[]){q[0], q[2], q[3]}, 3);
            } else {
                mesh_face(&mesh, q, 4);
            }
        }
    }
    roberts_scene *scene = scene_of_mesh(&mesh, NULL);
    const bool curved = roberts_scene_body_curved(scene, 0);
    assert_int_equal(roberts_scene_solid_count(scene), 1);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
    return curved;
}

/* The rims of a tube are sharp and outnumber its slight bends, but half of its facets are curved. */
static void extrusions_are_curved(void **state)
{
    (void)state;
    for (int triangles = 0; triangles < 2; triangles++) {
        assert_true(tube_is_curved(0.0, 0.0, triangles));
        assert_false(tube_is_curved(0.0, 0.5, triangles)); /* 150 of 302 facets */
        assert_false(tube_is_curved(0.5, 0.5, triangles));
    }
}

/* Five cubes as one body; two of them touch in an edge, at which four faces meet. The last face can be left out. */
#define CUBES                                                                                                          \
    "0 0 1\n0 1 1\n0 1 0\n0 0 0\n1 0 0\n1 1 0\n1 1 1\n1 0 1\n0 0 2\n0 1 2\n1 0 2\n1 1 2\n2 0 1\n2 1 1\n2 1 2\n2 0 2\n" \
    "1 2 1\n1 2 0\n2 1 0\n2 2 0\n2 2 1\n1 2 2\n2 2 2\n4 0 1 2 3\n4 4 5 6 7\n4 4 7 0 3\n4 2 1 6 5\n4 2 5 4 3\n"         \
    "4 8 9 1 0\n4 7 10 8 0\n4 1 9 11 6\n4 8 10 11 9\n4 12 13 14 15\n4 12 15 10 7\n4 6 13 12 7\n4 10 15 14 11\n"        \
    "4 6 16 17 5\n4 18 19 20 13\n4 18 13 6 5\n4 17 16 20 19\n4 17 19 18 5\n4 11 21 16 6\n4 13 20 22 14\n4 16 21 22 "   \
    "20\n"

/* A body is closed if each edge has an even number of faces. Then the near plane leaves a cap, which hides its inside.
 */
static void four_faces_at_an_edge(void **state)
{
    const roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE, .eye = {3, -3, 2.5}, .near_distance = 3.9};
    const char *text[] = {"OFF\n23 22 0\n" CUBES "4 11 14 22 21\n", "OFF\n23 21 0\n" CUBES};
    const roberts_body_kind kind[] = {ROBERTS_CLOSED, ROBERTS_OPEN};
    size_t count[2];
    (void)state;
    for (int i = 0; i < 2; i++) {
        roberts_scene *scene = scene_of(text[i], NULL);
        assert_int_equal(roberts_scene_solid_count(scene), 1);
        assert_int_equal(roberts_scene_body_kind(scene, 0), kind[i]);
        roberts_hide_options options = roberts_hide_options_default();
        roberts_drawing drawing = drawing_of(scene, &camera, &options);
        count[i] = drawing.count;
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
    assert_true(count[0] < count[1]); /* one can look into the open one */
}

/* An L-block made of triangles, wound as they come, all reversed, or every other one reversed. */
static const char *block(int winding)
{
    static char text[2000];
    static const int face[20][3] = {{0, 3, 1},  {1, 3, 2},  {0, 5, 4},  {0, 4, 3},   {6, 7, 9}, {7, 8, 9}, {6, 10, 11},
                                    {6, 9, 10}, {0, 1, 7},  {0, 7, 6},  {1, 2, 8},   {1, 8, 7}, {2, 3, 9}, {2, 9, 8},
                                    {3, 4, 10}, {3, 10, 9}, {4, 5, 11}, {4, 11, 10}, {5, 0, 6}, {5, 6, 11}};
    size_t n = (size_t)sprintf(text, "OFF\n12 20 0\n");
    for (int z = 0; z < 2; z++)
        n += (size_t)sprintf(text + n, "0 0 %d\n2 0 %d\n2 1 %d\n1 1 %d\n1 2 %d\n0 2 %d\n", z, z, z, z, z, z);
    for (int i = 0; i < 20; i++) {
        bool turned = winding == 1 || (winding == 2 && i % 2);
        n += (size_t)sprintf(text + n, "3 %d %d %d\n", face[i][0], face[i][turned ? 2 : 1], face[i][turned ? 1 : 2]);
    }
    return text;
}

/* Two blocks apart, each face with vertices of its own, in any order. A corner of each top lies on a side of the same
 * top. Welded, they are two closed bodies, without borders. */
static void welded_bodies_touch_themselves(void **state)
{
    enum { FACES = 14 };
    static const double ring[5][2] = {{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}};
    (void)state;
    for (int order = 0; order < 6 * FACES; order++) {
        const int first = order % FACES, step = (int[]){1, 3, 5, 9, 11, 13}[order / FACES];
        char text[4000];
        int at = sprintf(text, "OFF\n60 14 0\n"), vertex = 0;
        for (int k = 0; k < FACES; k++) {
            const int face = (first + step * k) % FACES, z = 3 * (face / 7), side = face % 7;
            for (int i = 0; side >= 5 && i < 5; i++)
                at += sprintf(text + at, "%g %g %d\n", ring[i][0], ring[i][1], z + side - 5);
            for (int i = 0; side < 5 && i < 4; i++) {
                const double *p = ring[(side + (i == 1 || i == 2)) % 5];
                at += sprintf(text + at, "%g %g %d\n", p[0], p[1], z + (i > 1));
            }
        }
        for (int k = 0; k < FACES; k++) {
            const int corners = (first + step * k) % FACES % 7 < 5 ? 4 : 5;
            at += sprintf(text + at, "%d", corners);
            for (int i = 0; i < corners; i++)
                at += sprintf(text + at, " %d", vertex++);
            at += sprintf(text + at, "\n");
        }
        roberts_scene *scene = scene_of_text(text);
        assert_int_equal(roberts_scene_solid_count(scene), 2);
        assert_int_equal(roberts_scene_body_kind(scene, 0), ROBERTS_CLOSED);
        roberts_drawing drawing = drawing_along(scene, (roberts_vec3){1, -2, 1}, true);
        for (size_t i = 0; i < drawing.count; i++)
            assert_int_not_equal(drawing.segment[i].line, ROBERTS_BORDER);
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
}

static void winding_decides_nothing(void **state)
{
    roberts_drawing drawing[3];
    (void)state;
    for (int k = 0; k < 3; k++) {
        roberts_scene *scene = scene_of(block(k), NULL);
        assert_int_equal(roberts_scene_solid_count(scene), 1);
        assert_int_equal(roberts_scene_body_kind(scene, 0), ROBERTS_CLOSED);
        drawing[k] = drawing_along(scene, (roberts_vec3){1, -1, 1}, false);
        roberts_scene_free(scene);
    }
    assert_int_equal(drawing[0].count, 12);
    for (int k = 1; k < 3; k++) {
        assert_int_equal(drawing[k].count, drawing[0].count);
        for (size_t i = 0; i < drawing[0].count; i++) {
            const roberts_segment *a = &drawing[0].segment[i], *b = &drawing[k].segment[i];
            assert_true(a->v0 == b->v0 && a->v1 == b->v1 && a->t0 == b->t0 && a->t1 == b->t1 && a->line == b->line);
        }
    }
    for (int k = 0; k < 3; k++)
        roberts_drawing_free(&drawing[k]);
}

/* A pentagram has its middle by one rule and not by the other: a wire below is seen there. */
static void the_fill_rule_decides(void **state)
{
    (void)state;
    for (int odd = 0; odd < 2; odd++) {
        roberts_scene *scene = scene_of("OFF\n7 2 0\n0 3 0\n2 -3 0\n-3 1 0\n3 1 0\n-2 -3 0\n0 0.1 -1\n0 0.3 -1\n"
                                        "5 0 1 2 3 4\n2 5 6\n",
                                        &(roberts_scene_options){.even_odd = odd});
        roberts_drawing drawing = drawing_along(scene, (roberts_vec3){0, 0, 1}, false);
        double length[ROBERTS_BACK_OUTLINE + 1];
        measure(&drawing, length);
        assert_true(fabs(length[ROBERTS_WIRE] - (odd ? 0.2 : 0.0)) < 1e-12);
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
}

/* With `solids` all of them are refused. */
static void solids_are_asked_for(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_mesh mesh = mesh_of_text(cases[i].text);
        roberts_scene *scene = NULL;
        assert_int_not_equal(roberts_scene_build(&mesh, &(roberts_scene_options){.solids = true}, &scene, NULL),
                             ROBERTS_OK);
        assert_null(scene);
        roberts_mesh_free(&mesh);
    }
}

static void note_warning(void *context, const char *file, size_t line, const char *message)
{
    (void)file;
    (void)line;
    char *said = context;
    snprintf(said + strlen(said), 200 - strlen(said), "%s;", message);
}

/* The message about a face with these corners. */
static void require_warning_of(const roberts_vec3 *point, const uint32_t *corner, size_t count, int copies,
                               const char *wanted)
{
    roberts_mesh mesh = {0};
    char said[200] = "";
    for (size_t i = 0; i < count; i++)
        mesh_vertex(&mesh, point[i]);
    for (int i = 0; i < copies; i++)
        mesh_face(&mesh, corner, count);
    roberts_scene *scene = scene_of_mesh(&mesh, &(roberts_scene_options){.warnings = {note_warning, said}});
    assert_string_equal(said, wanted);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
}

static void require_warning(const roberts_vec3 *point, const uint32_t *corner, size_t count, const char *wanted)
{
    require_warning_of(point, corner, count, 1, wanted);
}

/* The corners of a slit are kept, but those that repeat their neighbour are left out. A bow tie off its plane is told
 * of, but not one off it by six digits. A star of 801 sides, of which each crosses 798 others, is not cut. */
static void what_is_left_out_is_said(void **state)
{
    static const roberts_vec3 slit[10] = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0},
                                          {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {9, 9, 0}, {9, 9, 0}};
    static const uint32_t way[10] = {0, 1, 2, 3, 0, 4, 5, 6, 7, 4}, still[10] = {0, 1, 2, 2, 2, 3, 4, 5, 6, 0};
    enum { SIDES = 801, STEP = 400 };
    static roberts_vec3 point[SIDES];
    static uint32_t corner[SIDES];
    (void)state;
    require_warning(slit, way, 10, "");
    require_warning_of(slit, way, 10, 2, "1 face repeats an earlier one, and does not count;");
    require_warning_of(slit, way, 10, 3, "2 faces repeat an earlier one, and do not count;");
    require_warning(slit, still, 10, "3 corners that repeat another of the same face ignored;");
    for (int i = 0; i < 2; i++) {
        const roberts_vec3 bow[4] = {{0, 0, i ? 0.5 : 1e-6}, {3, 3, 0}, {3, 0, 0}, {0, 3, 0}};
        require_warning(bow, way, 4,
                        i ? "1 face crosses or touches itself and is not planar: lines on it may be wrong;" : "");
    }
    for (uint32_t i = 0; i < SIDES; i++) {
        double angle = 2.0 * 3.14159265358979323846 * i / SIDES;
        point[i] = (roberts_vec3){cos(angle), sin(angle), 0};
        corner[i] = (uint32_t)((uint64_t)i * STEP % SIDES);
    }
    require_warning(point, corner, SIDES, "1 face crosses itself too often to be cut: it hides nothing;");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_have_their_classes),        cmocka_unit_test(a_dent_far_away),
        cmocka_unit_test(welded_bodies_touch_themselves),  cmocka_unit_test(winding_decides_nothing),
        cmocka_unit_test(the_fill_rule_decides),           cmocka_unit_test(solids_are_asked_for),
        cmocka_unit_test(what_is_left_out_is_said),        cmocka_unit_test(four_faces_at_an_edge),
        cmocka_unit_test(lines_name_vertices_of_the_file), cmocka_unit_test(extrusions_are_curved),
    };
    return cmocka_run_group_tests_name("bodies", tests, NULL, NULL);
}
