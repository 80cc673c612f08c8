/* cases.c - one small scene for each outcome of the four tests, seen from the top (--view top): the picture plane is
 * that of x and y, the viewer at z = +infinity.
 *
 * Every scene has the same plate, the box (0, 0, 0) - (8, 8, 1), whose top is face 0, the F of the tests, and a
 * tetrahedron whose first two vertices, 8 and 9, are the ends A and B of the edge in question. AB is drawn: a front face
 * meets it. All coordinates are integers, so that "on" is exact. */
#include <math.h>

#include "models.h"

typedef struct test_case {
    const char *name;
    roberts_vec3 A, B, C, D;
    const char *outcome; /* of edge 8-9 against face 0 */
} test_case;

static const test_case cases[] = {
    {"test1-in-front", {1, 2, 3}, {7, 5, 4}, {4, 6, 2}, {5, 2, 2}, "test 1: F(A) < 0, F(B) < 0; visible"},
    {"test1-one-end-on",
     {1, 4, 1},
     {6, 4, 4},
     {5, 7, 3},
     {5, 1, 3},
     "test 1: F(A) = 0, F(B) < 0 (A stands on the face); visible"},
    {"test1-in-plane",
     {2, 2, 1},
     {6, 2, 1},
     {4, 6, 1},
     {4, 3, 4},
     "test 1: F(A) = F(B) = 0 (AB lies on the face); visible"},
    {"test2-all-left", {14, 4, -1}, {4, 14, -1}, {12, 12, -2}, {11, 11, -5}, "test 2: the sum of s is -n; visible"},
    {"test2-all-right", {4, -6, -1}, {-6, 4, -1}, {-4, -4, -2}, {-3, -3, -5}, "test 2: the sum of s is n; visible"},
    {"test2-corner-on-left",
     {12, 4, -1},
     {4, 12, -1},
     {11, 11, -2},
     {10, 10, -5},
     "test 2: the sum of s is -n + 1, AB passes over the corner (8, 8); visible"},
    {"test2-corner-on-right",
     {4, -4, -1},
     {-4, 4, -1},
     {-3, -3, -2},
     {-2, -2, -5},
     "test 2: the sum of s is n - 1, AB passes over the corner (0, 0); visible"},
    {"test3-outside",
     {10, 4, -1},
     {14, 5, -1},
     {12, 8, -2},
     {12, 6, -5},
     "test 3: A and B are outside the side x = 8; visible"},
    {"test3-outside-end-on-side",
     {8, 4, -1},
     {14, 5, -1},
     {12, 8, -2},
     {12, 6, -5},
     "test 3: A is on the side x = 8, B outside; visible"},
    {"test3-outside-end-on-corner",
     {8, 8, -1},
     {14, 11, -1},
     {11, 14, -2},
     {11, 11, -5},
     "test 3: A is on the corner (8, 8), B outside; visible"},
    {"test3-outside-beyond-side",
     {8, 10, -1},
     {8, 14, -1},
     {12, 12, -2},
     {10, 12, -5},
     "test 3: A and B are on the side x = 8 drawn out, and outside the side y = 8; visible"},
    {"test3-inside", {2, 3, -1}, {6, 5, -1}, {3, 6, -2}, {4, 5, -5}, "test 3: A and B are inside; hidden"},
    {"test3-inside-ends-on-sides",
     {0, 2, -1},
     {8, 6, -1},
     {3, 7, -2},
     {4, 5, -5},
     "test 3: A is on the side x = 0, B on the side x = 8; hidden"},
    {"test3-inside-corner-to-corner",
     {0, 0, -1},
     {8, 8, -1},
     {2, 6, -2},
     {3, 5, -5},
     "test 3: A and B are on opposite corners; hidden"},
    {"test3-inside-along-side",
     {8, 2, -1},
     {8, 6, -1},
     {4, 4, -2},
     {6, 4, -5},
     "test 3: AB lies behind the side x = 8, within it; hidden"},
    {"test3-inside-whole-side",
     {8, 0, -1},
     {8, 8, -1},
     {4, 4, -2},
     {6, 4, -5},
     "test 3: AB lies behind the side x = 8, from corner to corner; hidden"},
    {"test3-pierced",
     {2, 4, -3},
     {6, 4, 5},
     {4, 2, -4},
     {4, 6, -4},
     "test 3: A and B are inside, AB pierces the face; hidden for 0 <= t <= 1/2"},
    {"test4-one-crossing",
     {4, 4, -1},
     {12, 6, -1},
     {10, 10, -2},
     {9, 7, -5},
     "test 4: A is inside, AB crosses the side x = 8; hidden for 0 <= t <= 1/2"},
    {"test4-two-crossings",
     {-4, 2, -1},
     {12, 6, -1},
     {4, 10, -2},
     {4, 7, -5},
     "test 4: AB crosses the sides x = 0 and x = 8; hidden for 1/4 <= t <= 3/4"},
    {"test4-starts-on-side",
     {0, 2, -1},
     {16, 6, -1},
     {10, 10, -2},
     {9, 6, -5},
     "test 4: A is on the side x = 0, AB crosses the side x = 8; hidden for 0 <= t <= 1/2"},
    {"test4-leaves-by-corner",
     {4, 4, -1},
     {12, 12, -1},
     {12, 4, -2},
     {10, 7, -5},
     "test 4: A is inside, AB leaves over the corner (8, 8); hidden for 0 <= t <= 1/2"},
    {"test4-corner-and-side",
     {-4, -2, -1},
     {12, 6, -1},
     {8, -4, -2},
     {6, 0, -5},
     "test 4: AB enters over the corner (0, 0) and leaves over the side x = 8; hidden for 1/4 <= t <= 3/4"},
    {"test4-through-corners",
     {-4, -4, -1},
     {12, 12, -1},
     {10, -2, -2},
     {7, 1, -5},
     "test 4: AB enters over the corner (0, 0) and leaves over (8, 8); hidden for 1/4 <= t <= 3/4"},
    {"test4-along-side",
     {8, -4, -1},
     {8, 12, -1},
     {14, 4, -2},
     {10, 4, -5},
     "test 4: AB and the side x = 8 are in one sight plane, AB the longer; hidden for 1/4 <= t <= 3/4"},
    {"test4-along-side-one-end",
     {8, 4, -1},
     {8, 12, -1},
     {12, 8, -2},
     {9, 8, -5},
     "test 4: AB and the side x = 8 are in one sight plane, A within the side; hidden for 0 <= t <= 1/2"},
    {"test4-in-front-one-crossing",
     {4, 4, 6},
     {12, 4, -2},
     {12, 7, -3},
     {12, 1, -3},
     "test 4: A is inside, AB crosses the side x = 8 in front of the face; visible"},
    {"test4-in-front-two-crossings",
     {-4, 4, 11},
     {12, 4, -1},
     {12, 7, -2},
     {12, 1, -2},
     "test 4: AB crosses the sides x = 0 and x = 8 in front of the face; visible"},
    {"test4-touches-side",
     {4, 4, 3},
     {12, 4, -1},
     {12, 7, -1},
     {10, 5, 4},
     "test 4: AB meets the side x = 8 itself (F = 0 at the crossing); visible"},
    {"test4-pierced-one-crossing",
     {4, 4, 3},
     {12, 4, -5},
     {12, 7, -6},
     {12, 1, -6},
     "test 4: A is in front, AB pierces the face, then crosses the side x = 8; hidden for 1/4 <= t <= 1/2"},
    {"test4-pierced-two-crossings",
     {-4, 4, -3},
     {12, 4, 5},
     {-4, 6, -4},
     {-4, 2, -4},
     "test 4: AB crosses the side x = 0 behind the face, then pierces it; hidden for 1/4 <= t <= 1/2"},
};

size_t case_count(void)
{
    return sizeof cases / sizeof *cases;
}

const char *case_name(size_t i)
{
    return cases[i].name;
}

void case_about(size_t i, char *text, size_t size)
{
    snprintf(
        text, size,
        "A plate and a tetrahedron, to be seen from the top (--view top). Edge 8-9, from A at t = 0 to B at t = 1,\n"
        "against the plate's top, face 0:\n"
        "%s.",
        cases[i].outcome);
}

void case_make(body *b, size_t i)
{
    body_box(b, vec3(0, 0, 0), vec3(8, 8, 1));
    body_tetrahedron(b, cases[i].A, cases[i].B, cases[i].C, cases[i].D);
}
