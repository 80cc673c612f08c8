/* many.h - tests 2 to 4 against a polygon of very many corners: what tests.c finds, without asking all sides.
 *
 * Test 2 takes runs of corners whose box lies plainly on one side of the sight plane for one corner. Tests 3 and 4 need the
 * sides that cut something off. Let the edge's part inside the polygon be guessed as s0 .. s1: the sides across which the
 * corners change from one side of the sight plane to the other are found by halving. Then a run that holds the edge's points
 * at s0 and s1, well inside, has no side that A and B are both outside of or on; and where A is outside of one of its sides,
 * the edge comes in across it before s0, and where B is, goes out after s1. So if the sides of all other runs leave no more
 * than s0 .. s1, those of that run have no say. If they leave more, the guess was wrong, and what they leave is the next one. */
#ifndef ROBERTS_HIDE_MANY_H
#define ROBERTS_HIDE_MANY_H

#include "hide/runs.h"
#include "hide/tests.h"

/* What hide_test2() and hide_by_sides() say of F, whose runs these are, counted: the part of e inside all sides; false where
 * there is none. To the last bit, unless a run of several sides is straight. */
bool hide_by_runs(const hide_space *space, const runs *r, const hide_face *F, const hide_edge *e, hide_sides *sides,
                  roberts_tally *tally, hide_part *part);

#endif
