/* From segments to strokes: no line is drawn twice, the nearest wins, pieces are joined and chained, and the pen
 * travels little. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/strokes.h"
#include "drawing.h"
#include "rng.h"
#include "testing.h"

enum { SIDE = 100 }; /* of the page, mm; here a model unit is one mm, and 0,0 the lower left corner */

static roberts_draw_options plain_options(roberts_order order)
{
    roberts_draw_options options = roberts_draw_options_default();
    options.page = (roberts_page){.width_mm = SIDE, .height_mm = SIDE, .margin_mm = 0.0};
    options.hidden = ROBERTS_HIDDEN_SOLID;
    options.order = order;
    return options;
}

static strokes strokes_of(roberts_segment *segment, size_t count, const roberts_draw_options *options)
{
    roberts_drawing drawing = {
        .count = count, .segment = segment, .framed = true, .window_max = {SIDE, SIDE}, .epsilon = 1e-9};
    strokes s;
    assert_int_equal(strokes_make(&s, &drawing, options, NULL), ROBERTS_OK);
    return s;
}

static void print_strokes(const strokes *s, char *text, size_t size)
{
    size_t used = 0;
    text[0] = '\0';
    for (int i = 0; i < LINE_CLASSES; i++)
        for (size_t k = s->start[i]; k < s->start[i + 1] && used < size; k++) {
            const polyline *line = &s->lines.item[k];
            used +=
                (size_t)snprintf(text + used, size - used, "%s%s", used ? "; " : "", pens_class_name(line_order[i]));
            for (uint32_t n = 0; n < line->count && used < size; n++) {
                page_point p = s->lines.point[line->first + n];
                used += (size_t)snprintf(text + used, size - used, " %g,%g", p.x / 1000.0, SIDE - p.y / 1000.0);
            }
            if (line->closed && used < size)
                used += (size_t)snprintf(text + used, size - used, " closed");
        }
}

/* ---- doubles ---- */

enum { GIVEN_MOST = 6 };

typedef struct given {
    char class; /* o, b, c, i, w, h; 0: no more */
    double x0, y0, x1, y1, z0, z1;
} given;

static const struct {
    const char *name;
    given segment[GIVEN_MOST];
    const char *wanted;
} cases[] = {
    {"alone", {{'o', 1, 1, 9, 1, 0, 0}}, "outline 1,1 9,1"},
    {"the same twice", {{'o', 1, 1, 9, 1, 0, 0}, {'o', 1, 1, 9, 1, 0, 0}}, "outline 1,1 9,1"},
    {"the same backward", {{'o', 1, 1, 9, 1, 0, 0}, {'o', 9, 1, 1, 1, 0, 0}}, "outline 1,1 9,1"},
    {"the nearer wins: crease", {{'o', 1, 1, 9, 1, 0, 0}, {'c', 1, 1, 9, 1, 1, 1}}, "crease 1,1 9,1"},
    {"the nearer wins: outline", {{'o', 1, 1, 9, 1, 1, 1}, {'c', 1, 1, 9, 1, 0, 0}}, "outline 1,1 9,1"},
    {"the nearer wins: wire", {{'o', 1, 1, 9, 1, 0, 0}, {'w', 1, 1, 9, 1, 1, 1}}, "wire 1,1 9,1"},
    {"at one depth: outline, border",
     {{'b', 1, 1, 9, 1, 0, 0}, {'o', 1, 1, 5, 1, 0, 0}},
     "border 5,1 9,1; outline 1,1 5,1"},
    {"at one depth: border, crease",
     {{'c', 1, 1, 9, 1, 0, 0}, {'b', 1, 1, 5, 1, 0, 0}},
     "crease 5,1 9,1; border 1,1 5,1"},
    {"the nearer wins: intersection", {{'c', 1, 1, 9, 1, 0, 0}, {'i', 1, 1, 9, 1, 1, 1}}, "intersection 1,1 9,1"},
    {"at one depth: crease, intersection",
     {{'i', 1, 1, 9, 1, 0, 0}, {'c', 1, 1, 5, 1, 0, 0}},
     "intersection 5,1 9,1; crease 1,1 5,1"},
    {"at one depth: intersection, wire",
     {{'w', 1, 1, 9, 1, 0, 0}, {'i', 1, 1, 5, 1, 0, 0}},
     "wire 5,1 9,1; intersection 1,1 5,1"},
    {"at one depth: wire, hidden", {{'h', 1, 1, 9, 1, 0, 0}, {'w', 1, 1, 5, 1, 0, 0}}, "hidden 5,1 9,1; wire 1,1 5,1"},
    {"the order of the classes",
     {{'o', 1, 6, 9, 6, 0, 0},
      {'b', 1, 5, 9, 5, 0, 0},
      {'c', 1, 4, 9, 4, 0, 0},
      {'i', 1, 3, 9, 3, 0, 0},
      {'w', 1, 2, 9, 2, 0, 0},
      {'h', 1, 1, 9, 1, 0, 0}},
     "hidden 1,1 9,1; wire 1,2 9,2; intersection 1,3 9,3; crease 1,4 9,4; border 1,5 9,5; outline 1,6 9,6"},
    {"visible wins over a nearer hidden one: crease",
     {{'h', 1, 1, 9, 1, 1, 1}, {'c', 1, 1, 9, 1, 0, 0}},
     "crease 1,1 9,1"},
    {"visible wins over a nearer hidden one: outline, in its middle",
     {{'h', 1, 1, 9, 1, 1, 1}, {'o', 4, 1, 6, 1, 0, 0}, {'h', 1, 1, 9, 1, 2, 2}},
     "hidden 1,1 4,1; hidden 6,1 9,1; outline 4,1 6,1"},
    {"equally near: outline before crease", {{'c', 1, 1, 9, 1, 0, 0}, {'o', 1, 1, 9, 1, 0, 0}}, "outline 1,1 9,1"},
    {"equally near: crease before hidden", {{'h', 1, 1, 9, 1, 0, 0}, {'c', 1, 1, 9, 1, 0, 0}}, "crease 1,1 9,1"},
    {"nearer by less than epsilon: no", {{'c', 1, 1, 9, 1, 5e-10, 5e-10}, {'o', 1, 1, 9, 1, 0, 0}}, "outline 1,1 9,1"},
    {"nearer by more", {{'c', 1, 1, 9, 1, 2e-9, 2e-9}, {'o', 1, 1, 9, 1, 0, 0}}, "crease 1,1 9,1"},
    {"overlap, one class", {{'o', 1, 1, 6, 1, 0, 0}, {'o', 4, 1, 9, 1, 1, 1}}, "outline 1,1 9,1"},
    {"overlap, the second nearer",
     {{'o', 1, 1, 6, 1, 0, 0}, {'c', 4, 1, 9, 1, 1, 1}},
     "crease 4,1 9,1; outline 1,1 4,1"},
    {"overlap, the first nearer",
     {{'o', 1, 1, 6, 1, 1, 1}, {'c', 4, 1, 9, 1, 0, 0}},
     "crease 6,1 9,1; outline 1,1 6,1"},
    {"inside, nearer",
     {{'o', 1, 1, 9, 1, 0, 0}, {'c', 4, 1, 6, 1, 1, 1}},
     "crease 4,1 6,1; outline 1,1 4,1; outline 6,1 9,1"},
    {"inside, farther", {{'o', 1, 1, 9, 1, 1, 1}, {'c', 4, 1, 6, 1, 0, 0}}, "outline 1,1 9,1"},
    {"nearer on one side, farther on the other, ends cut them apart",
     {{'o', 0, 1, 4, 1, 8, 0}, {'c', 2, 1, 6, 1, 5, 5}},
     "crease 2,1 6,1; outline 0,1 2,1"},
    {"depth is taken where they overlap",
     {{'o', 0, 1, 8, 1, 8, 0}, {'c', 6, 1, 10, 1, 2, 2}},
     "crease 6,1 10,1; outline 0,1 6,1"},
    {"three on one another",
     {{'h', 1, 1, 9, 1, 0, 0}, {'c', 2, 1, 6, 1, 1, 1}, {'o', 4, 1, 5, 1, 2, 2}},
     "hidden 1,1 2,1; hidden 6,1 9,1; crease 2,1 4,1; crease 5,1 6,1; outline 4,1 5,1"},
    {"end to end", {{'o', 1, 1, 5, 1, 0, 0}, {'o', 5, 1, 9, 1, 1, 1}}, "outline 1,1 9,1"},
    {"end to end, other classes",
     {{'o', 1, 1, 5, 1, 0, 0}, {'c', 5, 1, 9, 1, 0, 0}},
     "crease 5,1 9,1; outline 1,1 5,1"},
    {"a gap of less than touches", {{'o', 1, 1, 5, 1, 0, 0}, {'o', 5.0009, 1, 9, 1, 0, 0}}, "outline 1,1 9,1"},
    {"a gap of more", {{'o', 1, 1, 5, 1, 0, 0}, {'o', 5.003, 1, 9, 1, 0, 0}}, "outline 1,1 5,1; outline 5.003,1 9,1"},
    {"parallel, nearer than touches", {{'o', 1, 1, 9, 1, 0, 0}, {'o', 1, 1.0004, 9, 1.0004, 0, 0}}, "outline 1,1 9,1"},
    {"parallel, farther apart",
     {{'o', 1, 1, 9, 1, 0, 0}, {'o', 1, 1.003, 9, 1.003, 0, 0}},
     "outline 1,1 9,1; outline 1,1.003 9,1.003"},
    {"crossing", {{'o', 1, 1, 9, 9, 0, 0}, {'o', 1, 9, 9, 1, 0, 0}}, "outline 1,1 9,9; outline 1,9 9,1"},
    {"a bend is none", {{'o', 1, 1, 5, 1, 0, 0}, {'o', 5, 1, 9, 1.01, 0, 0}}, "outline 1,1 5,1 9,1.01"},
    {"a sliver goes to its neighbour", {{'o', 1, 1, 9, 1, 0, 0}, {'c', 1.0003, 1, 9.0003, 1, 1, 1}}, "crease 1,1 9,1"},
    {"turned by 30 degrees",
     {{'o', 0, 0, 8.660254037844386, 5, 0, 0}, {'c', 4.330127018922193, 2.5, 17.32050807568877, 10, 0, 0}},
     "crease 8.66,5 17.321,10; outline 0,0 8.66,5"},
    {"steep", {{'o', 50, 0, 50, 80, 0, 0}, {'o', 50, 90, 50.00000000000001, 40, 0, 0}}, "outline 50,0 50,90"},
    {"far from the middle of all, where a small turn moves the line by more than touches",
     {{'o', 0, 0, 30, 0, 0, 0}, {'o', 5, 0.0009, 15, 0.00099, 0, 0}, {'o', 100, 100, 100, 90, 0, 0}},
     "outline 0,0 30,0; outline 100,100 100,90"},
    {"a little to both sides of where directions begin anew",
     {{'o', 1, 1, 91, 62.57231275075231, 0, 0},
      {'o', 20, 13.998799358492153, 30, 20.840197441909076, 0, 0},
      {'o', 20, 13.998399358492154, 30, 20.83973744190908, 0, 0}},
     "outline 1,1 91,62.572"},
    {"from one place to another, though at an angle",
     {{'o', 1, 1, 2, 1, 0, 0}, {'c', 1, 1.0007, 2, 0.9993, 1, 1}, {'h', 2.0004, 1.0004, 1.0004, 1, 2, 2}},
     "crease 1,1.001 2,0.999"},
    {"no length", {{'o', 5, 5, 5, 5, 0, 0}, {'o', 1, 1, 9, 1, 0, 0}}, "outline 1,1 9,1"},
    {"leaves the frame",
     {{'o', -50, 10, 50, 10, 0, 0}, {'o', 10, 50, 10, 150, 0, 0}},
     "outline 0,10 50,10; outline 10,50 10,100"},
    {"beyond the frame", {{'o', -50, 10, -40, 10, 0, 0}, {'o', 10, 150, 60, 150, 0, 0}}, ""},
};

static roberts_segment segment_of(const given *g)
{
    roberts_line line = g->class == 'b'   ? ROBERTS_BORDER
                        : g->class == 'c' ? ROBERTS_CREASE
                        : g->class == 'i' ? ROBERTS_INTERSECTION
                        : g->class == 'w' ? ROBERTS_WIRE
                                          : ROBERTS_OUTLINE;
    roberts_segment s = line_at(line, g->x0, g->y0, g->x1, g->y1);
    s.z0 = g->z0;
    s.z1 = g->z1;
    if (g->class == 'h')
        s.state = ROBERTS_HIDDEN;
    return s;
}

/* The strokes of the segments are those wanted. */
static void expect_strokes(const char *name, const given *list, const roberts_draw_options *options, const char *wanted)
{
    roberts_segment segment[GIVEN_MOST];
    size_t count = 0;
    char text[1000];
    for (; count < GIVEN_MOST && list[count].class; count++)
        segment[count] = segment_of(&list[count]);
    strokes s = strokes_of(segment, count, options);
    print_strokes(&s, text, sizeof text);
    print_message("%s: %s\n", name, text);
    assert_string_equal(text, wanted);
    strokes_free(&s);
}

static void doubles(void **state)
{
    roberts_draw_options options = plain_options(ROBERTS_ORDER_NONE);
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        expect_strokes(cases[i].name, cases[i].segment, &options, cases[i].wanted);
}

/* ---- chains ---- */

static const struct {
    const char *name;
    given segment[GIVEN_MOST];
    const char *wanted, *in_order;
} chain_cases[] = {
    {"square",
     {{'o', 1, 1, 9, 1, 0, 0}, {'o', 1, 1, 1, 9, 0, 0}, {'o', 9, 1, 9, 9, 0, 0}, {'o', 1, 9, 9, 9, 0, 0}},
     "outline 1,1 9,1 9,9 1,9 closed",
     "outline 9,1 1,1 1,9; outline 9,1 9,9 1,9"},
    {"square that begins on a side",
     {{'o', 5, 1, 9, 1, 0, 0},
      {'o', 9, 1, 9, 9, 0, 0},
      {'o', 9, 9, 1, 9, 0, 0},
      {'o', 1, 9, 1, 1, 0, 0},
      {'o', 1, 1, 5, 1, 0, 0}},
     "outline 1,1 9,1 9,9 1,9 closed",
     "outline 1,1 9,1 9,9 1,9 closed"},
    {"star of three",
     {{'o', 5, 5, 9, 5, 0, 0}, {'o', 5, 5, 1, 9, 0, 0}, {'o', 5, 5, 1, 1, 0, 0}},
     "outline 1,9 5,5; outline 9,5 5,5 1,1",
     "outline 9,5 5,5 1,9; outline 5,5 1,1"},
    {"two classes do not meet",
     {{'o', 1, 1, 9, 1, 0, 0}, {'c', 9, 1, 9, 9, 0, 0}},
     "crease 9,9 9,1; outline 9,1 1,1",
     "crease 9,1 9,9; outline 1,1 9,1"},
    {"ends within touch",
     {{'o', 1, 1, 5, 5, 0, 0}, {'o', 5.0008, 5.0008, 9, 1, 0, 0}},
     "outline 1,1 5,5 9,1",
     "outline 1,1 5,5; outline 5.001,5.001 9,1"},
};

static void chains(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof chain_cases / sizeof chain_cases[0]; i++)
        for (int order = ROBERTS_ORDER_TRAVEL; order <= ROBERTS_ORDER_NONE; order++) {
            roberts_draw_options options = plain_options((roberts_order)order);
            expect_strokes(chain_cases[i].name, chain_cases[i].segment, &options,
                           order == ROBERTS_ORDER_NONE ? chain_cases[i].in_order : chain_cases[i].wanted);
        }
}

/* ---- random lines of a lattice: what is drawn is compared step by step with what should be ---- */

enum { LATTICE = 20, DIRECTIONS = 5, LATTICE_MM = 5 };

static const int direction[DIRECTIONS][2] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 1}};

/* What is drawn on each step, by direction and starting point. */
typedef struct step {
    int times;
    int line; /* roberts_line */
    double z;
} step;

typedef step steps[DIRECTIONS][LATTICE + 1][LATTICE + 1];

/* A random run of steps, drawn either way, at a random height; `wanted` keeps the nearest visible one, or else the
 * nearest hidden one. */
static roberts_segment random_run(rng *r, steps wanted)
{
    for (;;) {
        int k = (int)rng_below(r, DIRECTIONS), x = (int)rng_below(r, LATTICE + 1);
        int y = (int)rng_below(r, LATTICE + 1), n = 1 + (int)rng_below(r, 8);
        int ex = x + n * direction[k][0], ey = y + n * direction[k][1];
        if (ex > LATTICE || ey > LATTICE || ey < 0)
            continue;
        int class = (int)rng_below(r, 3);
        double z = rng_below(r, 4), m = LATTICE_MM;
        roberts_segment s = rng_below(r, 2) ? line_at((roberts_line) class, m * x, m * y, m * ex, m * ey)
                                            : line_at((roberts_line) class, m * ex, m * ey, m * x, m * y);
        s.z0 = s.z1 = z;
        s.state = class == ROBERTS_BACK ? ROBERTS_HIDDEN : ROBERTS_VISIBLE;
        for (int i = 0; i < n; i++) {
            step *w = &wanted[k][x + i * direction[k][0]][y + i * direction[k][1]];
            int first = w->times ? (class == ROBERTS_BACK) - (w->line == ROBERTS_BACK) : -1;
            if (first < 0 || (first == 0 && (z > w->z || (z == w->z && class < w->line))))
                *w = (step){1, class, z};
        }
        return s;
    }
}

static void add_side(steps drawn, page_point a, page_point b, int class)
{
    const int unit = 1000 * LATTICE_MM;
    int x = a.x / unit, y = (SIDE * 1000 - a.y) / unit, ex = b.x / unit, ey = (SIDE * 1000 - b.y) / unit;
    assert_true(a.x % unit == 0 && a.y % unit == 0 && b.x % unit == 0 && b.y % unit == 0);
    for (int k = 0; k < DIRECTIONS; k++)
        for (int sign = -1; sign <= 1; sign += 2) {
            int dx = direction[k][0], dy = direction[k][1];
            int n = dx ? (ex - x) * sign / dx : (ey - y) * sign / dy;
            if (n <= 0 || x + sign * n * dx != ex || y + sign * n * dy != ey)
                continue;
            for (int i = 0; i < n; i++) {
                int at = sign > 0 ? i : i + 1;
                step *d = &drawn[k][x + sign * at * dx][y + sign * at * dy];
                d->times++;
                d->line = class;
            }
            return;
        }
    fail_msg("a stroke runs in no direction of the lattice");
}

/* Places where an odd number of steps of a class ends; half as many lines must be open. */
static size_t odd_places(steps drawn, int class)
{
    int ends[LATTICE + 1][LATTICE + 1] = {{0}};
    size_t odd = 0;
    for (int k = 0; k < DIRECTIONS; k++)
        for (int x = 0; x <= LATTICE; x++)
            for (int y = 0; y <= LATTICE; y++)
                if (drawn[k][x][y].times && drawn[k][x][y].line == class) {
                    ends[x][y]++;
                    ends[x + direction[k][0]][y + direction[k][1]]++;
                }
    for (int x = 0; x <= LATTICE; x++)
        for (int y = 0; y <= LATTICE; y++)
            odd += ends[x][y] % 2;
    return odd;
}

static void every_step_is_drawn_once(void **state)
{
    static steps wanted, drawn;
    rng r = {1};
    (void)state;
    for (int round = 0; round < 200; round++) {
        roberts_segment segment[300];
        size_t count = 1 + rng_below(&r, round < 100 ? 20 : 300);
        memset(wanted, 0, sizeof wanted);
        for (size_t i = 0; i < count; i++)
            segment[i] = random_run(&r, wanted);
        for (int order = ROBERTS_ORDER_TRAVEL; order <= ROBERTS_ORDER_NONE; order++) {
            roberts_draw_options options = plain_options((roberts_order)order);
            strokes s = strokes_of(segment, count, &options);
            memset(drawn, 0, sizeof drawn);
            for (int c = 0; c < LINE_CLASSES; c++) {
                size_t open = 0;
                for (size_t i = s.start[c]; i < s.start[c + 1]; i++) {
                    const polyline *line = &s.lines.item[i];
                    const page_point *p = s.lines.point + line->first;
                    open += !line->closed;
                    for (uint32_t n = 0; n + !line->closed < line->count; n++)
                        add_side(drawn, p[n], p[(n + 1) % line->count], line_order[c]);
                }
                if (order == ROBERTS_ORDER_TRAVEL)
                    assert_int_equal(2 * open, odd_places(wanted, line_order[c]));
            }
            for (int k = 0; k < DIRECTIONS; k++)
                for (int x = 0; x <= LATTICE; x++)
                    for (int y = 0; y <= LATTICE; y++) {
                        assert_int_equal(drawn[k][x][y].times, wanted[k][x][y].times);
                        assert_int_equal(drawn[k][x][y].line, wanted[k][x][y].line);
                    }
            strokes_free(&s);
        }
    }
}

/* ---- whole scenes: all ink is there, and none twice ---- */

static const struct {
    const char *model, *view; /* NULL: perspective */
} scene_cases[] = {
    {"table", "iso"},      {"table", "front"},        {"table", NULL},           {"brick-wall", "front"},
    {"brick-wall", "iso"}, {"stacked-blocks", "iso"}, {"stacked-blocks", "top"}, {"stacked-blocks", NULL},
    {"temple", "iso"},     {"temple", "cabinet"},     {"staircase", "right"},    {"compound-of-two-cubes", "top"},
};

typedef struct side {
    double x, y, ux, uy, length; /* units of the page; u of length 1 */
} side;

static side *all_sides(const strokes *s, size_t *count)
{
    side *sides = malloc((s->lines.point_count + 1) * sizeof *sides);
    assert_non_null(sides);
    *count = 0;
    for (size_t i = 0; i < s->lines.count; i++) {
        const polyline *line = &s->lines.item[i];
        const page_point *p = s->lines.point + line->first;
        for (uint32_t n = 0; n + !line->closed < line->count; n++) {
            page_point a = p[n], b = p[(n + 1) % line->count];
            double x = b.x - a.x, y = b.y - a.y, length = hypot(x, y);
            assert_true(length > 0.0);
            sides[(*count)++] = (side){a.x, a.y, x / length, y / length, length};
        }
    }
    return sides;
}

/* Distance of (x, y) from a side. */
static double distance_from(const side *s, double x, double y)
{
    double t = (x - s->x) * s->ux + (y - s->y) * s->uy;
    t = fmin(fmax(t, 0.0), s->length);
    return hypot(x - s->x - t * s->ux, y - s->y - t * s->uy);
}

/* Whether two sides run along one another. */
static bool overlap(const side *a, const side *b)
{
    const double beside = 0.5, along = 20.0; /* units; a shorter one may well run another way */
    double x = b->x - a->x, y = b->y - a->y, t0 = x * a->ux + y * a->uy;
    double t1 = t0 + b->length * (a->ux * b->ux + a->uy * b->uy);
    double h0 = y * a->ux - x * a->uy, h1 = h0 + b->length * (a->ux * b->uy - a->uy * b->ux);
    double from = fmax(0.0, fmin(t0, t1)), to = fmin(a->length, fmax(t0, t1));
    return to - from > along && fabs(h0) < beside && fabs(h1) < beside;
}

static void scenes_are_drawn_once(void **state)
{
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    options.hidden = ROBERTS_HIDDEN_SOLID;
    for (size_t i = 0; i < sizeof scene_cases / sizeof scene_cases[0]; i++) {
        roberts_drawing drawing = model_drawing(scene_cases[i].model, scene_cases[i].view);
        strokes s;
        size_t count, doubled = 0;
        double worst = 0.0, length = 0.0;
        assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
        side *sides = all_sides(&s, &count);
        for (size_t a = 0; a < count; a++)
            for (size_t b = 0; b < count; b++)
                if (a != b && sides[a].length >= sides[b].length && overlap(&sides[a], &sides[b])) {
                    print_message("%.0f,%.0f and %.0f,%.0f, %.0f and %.0f long\n", sides[a].x, sides[a].y, sides[b].x,
                                  sides[b].y, sides[a].length, sides[b].length);
                    doubled++;
                }
        for (size_t n = 0; n < drawing.count; n++)
            for (int k = 1; k < 8; k++) {
                const roberts_segment *g = &drawing.segment[n];
                roberts_vec2 p = {g->p0.x + k / 8.0 * (g->p1.x - g->p0.x), g->p0.y + k / 8.0 * (g->p1.y - g->p0.y)};
                double least = INFINITY;
                p = page_place(&s.map, p);
                for (size_t a = 0; a < count; a++)
                    least = fmin(least, distance_from(&sides[a], 1000 * p.x, 1000 * p.y));
                worst = fmax(worst, least);
            }
        for (size_t n = 0; n < drawing.count; n++)
            length += hypot(drawing.segment[n].p1.x - drawing.segment[n].p0.x,
                            drawing.segment[n].p1.y - drawing.segment[n].p0.y);
        roberts_ink ink = strokes_measure(&s);
        print_message("%s, %s: %zu segments, %zu strokes, %.1f mm of %.1f; ink moved by %.4f mm\n",
                      scene_cases[i].model, scene_cases[i].view ? scene_cases[i].view : "perspective", drawing.count,
                      ink.strokes, ink.down_mm, length * ink.scale, worst / 1000);
        assert_int_equal(doubled, 0);
        assert_true(worst < 2.5); /* joined within a unit, and rounded twice */
        assert_true(ink.down_mm <= length * ink.scale + 1e-3 * (double)drawing.count);
        free(sides);
        strokes_free(&s);
        roberts_drawing_free(&drawing);
    }
}

/* Two blocks of one footprint, one on the other, seen at an angle: where they touch, the lower one's edges are creases,
 * the upper one's outlines, equally near. And from the front, the edges at the back lie behind those in front. */
static void what_touches_is_outline(void **state)
{
    roberts_draw_options options = roberts_draw_options_default();
    roberts_mesh mesh = {0};
    roberts_hide_options hide = roberts_hide_options_default();
    const size_t wanted[][2] = {{3, 8}, {0, 5}}; /* sides of creases, of outlines: iso, front */
    (void)state;
    for (int block = 0; block < 2; block++)
        mesh_box(&mesh, (roberts_vec3){0, 0, block}, (roberts_vec3){1, 1, block + 1});
    roberts_scene *scene = build_scene(&mesh);
    assert_int_equal(roberts_scene_solid_count(scene), 2);
    hide.keep_hidden = true;
    options.hidden = ROBERTS_HIDDEN_SOLID;
    for (int view = 0; view < 2; view++) {
        strokes s;
        roberts_camera camera = preset_camera(view ? "front" : "iso");
        roberts_drawing drawing = drawing_of(scene, &camera, &hide);
        assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
        char text[2000];
        print_strokes(&s, text, sizeof text);
        print_message("%s\n", text);
        size_t sides[LINE_CLASSES] = {0};
        for (int class = 0; class < LINE_CLASSES; class ++)
            for (size_t i = s.start[class]; i < s.start[class + 1]; i++)
                sides[line_order[class]] += s.lines.item[i].count - !s.lines.item[i].closed;
        assert_int_equal(sides[ROBERTS_CREASE], wanted[view][0]);
        assert_int_equal(sides[ROBERTS_OUTLINE], wanted[view][1]);
        if (view)
            assert_int_equal(s.start[1] - s.start[0], 0); /* no hidden line beside a visible one */
        strokes_free(&s);
        roberts_drawing_free(&drawing);
    }
    roberts_scene_free(scene);
}

/* ---- order ---- */

static double random_mm(rng *r)
{
    return rng_below(r, 1000000) * (SIDE / 1e6);
}

static roberts_segment *random_lines(size_t count, double length)
{
    rng r = {7};
    roberts_segment *segment = malloc(count * sizeof *segment);
    assert_non_null(segment);
    for (size_t i = 0; i < count; i++) {
        double x = random_mm(&r), y = random_mm(&r), angle = random_mm(&r);
        segment[i] = line_at(ROBERTS_OUTLINE, x, y, x + length * cos(angle), y + length * sin(angle));
    }
    return segment;
}

/* The travel of the lifted pen gets shorter, and the strokes stay the same. A tour through n random places in a square
 * of side a is some 0.71 a sqrt(n) long (Beardwood, Halton, Hammersley 1959); here each stroke has two ends to choose
 * from. */
static void ways_are_short(void **state)
{
    const size_t counts[] = {1, 2, 3, 10, 1000, 30000};
    (void)state;
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        roberts_segment *segment = random_lines(counts[i], 0.2);
        roberts_draw_options options = plain_options(ROBERTS_ORDER_NONE);
        strokes none = strokes_of(segment, counts[i], &options);
        options.order = ROBERTS_ORDER_TRAVEL;
        strokes ordered = strokes_of(segment, counts[i], &options);
        roberts_ink a = strokes_measure(&none), b = strokes_measure(&ordered);
        print_message("%zu: %zu strokes, %.1f mm down, %.1f up; ordered %zu, %.1f, %.1f\n", counts[i], a.strokes,
                      a.down_mm, a.up_mm, b.strokes, b.down_mm, b.up_mm);
        assert_true(b.strokes <= a.strokes && b.strokes + counts[i] / 5000 >= a.strokes); /* some happen to meet */
        assert_true(fabs(a.down_mm - b.down_mm) < 1e-3 * (double)a.strokes);
        assert_true(b.up_mm <= a.up_mm);
        if (counts[i] >= 1000)
            assert_true(b.up_mm < 1.1 * 0.71 * SIDE * sqrt((double)counts[i]));
        strokes_free(&none);
        strokes_free(&ordered);
        free(segment);
    }
}

/* A square of four strokes in which a greedy pen goes wrong, and 2-opt mends it. All tours are tried to know the best
 * one. */
static double best_tour(const roberts_segment *segment, int count, int done, unsigned used, roberts_vec2 pen)
{
    double best = INFINITY;
    if (done == count)
        return 0.0;
    for (int i = 0; i < 2 * count; i++) {
        if (used & 1u << (i / 2))
            continue;
        roberts_vec2 in = i % 2 ? segment[i / 2].p1 : segment[i / 2].p0,
                     out = i % 2 ? segment[i / 2].p0 : segment[i / 2].p1;
        double way = done ? hypot(in.x - pen.x, in.y - pen.y) : 0.0;
        best = fmin(best, way + best_tour(segment, count, done + 1, used | 1u << (i / 2), out));
    }
    return best;
}

static void small_tours_are_nearly_best(void **state)
{
    roberts_draw_options options = plain_options(ROBERTS_ORDER_TRAVEL);
    rng r = {5};
    double sum = 0.0, best = 0.0;
    (void)state;
    for (int round = 0; round < 200; round++) {
        roberts_segment segment[5];
        for (int i = 0; i < 5; i++)
            segment[i] = line_at(ROBERTS_OUTLINE, random_mm(&r), random_mm(&r), random_mm(&r), random_mm(&r));
        strokes s = strokes_of(segment, 5, &options);
        double own = strokes_measure(&s).up_mm, least = best_tour(segment, 5, 0, 0, (roberts_vec2){0, 0});
        assert_true(own > least - 0.01);
        sum += own;
        best += least;
        strokes_free(&s);
    }
    print_message("%.1f mm, %.1f at best\n", sum, best);
    assert_true(sum < 1.2 * best);
}

/* ---- crowds: none of this may take long ---- */

static void crowds(void **state)
{
    enum { COUNT = 200000 };
    roberts_draw_options options = plain_options(ROBERTS_ORDER_TRAVEL);
    roberts_segment *segment = malloc(COUNT * sizeof *segment);
    static const char *const names[] = {"one line, at many heights", "a fan", "hatching", "stairs", "a heap"};
    (void)state;
    assert_non_null(segment);
    for (int kind = 0; kind < 5; kind++) {
        rng r = {3};
        for (size_t i = 0; i < COUNT; i++) {
            double x = random_mm(&r), y = random_mm(&r), k = (double)i / COUNT;
            segment[i] = kind == 0   ? line_at(ROBERTS_OUTLINE, x, 50, y, 50)
                         : kind == 1 ? line_at(ROBERTS_OUTLINE, 50, 50, 50 + 40 * cos(6 * k), 50 + 40 * sin(6 * k))
                         : kind == 2 ? line_at(ROBERTS_OUTLINE, 0, 100 * k, 100, 100 * k)
                         : kind == 3 ? line_at(ROBERTS_OUTLINE, 100 * k, 100 * k, 100 * k + (i % 2 ? 5e-4 : 0),
                                               100 * k + (i % 2 ? 0 : 5e-4))
                                     : line_at(ROBERTS_OUTLINE, 50 + x / 1e3, 50 + y / 1e3, 50 + y / 1e3, 50 + x / 1e3);
            segment[i].z0 = y;
            segment[i].z1 = x;
            if (i % 3 == 0)
                segment[i].line = ROBERTS_CREASE;
        }
        strokes s = strokes_of(segment, COUNT, &options);
        roberts_ink ink = strokes_measure(&s);
        print_message("%s: %zu strokes, %.1f mm down, %.1f up\n", names[kind], ink.strokes, ink.down_mm, ink.up_mm);
        if (kind == 0)
            assert_true(ink.down_mm > 99.9 && ink.down_mm < 100.001);
        strokes_free(&s);
    }
    free(segment);
}

/* Lines so near one another that many lie in one cell of the hash, each in pieces that are not quite straight. */
static void near_lines_are_told_apart(void **state)
{
    enum { LINES = 30000, PIECES = 3, COUNT = LINES * PIECES };
    const double apart = 0.0025, tilt = 0.5e-3, rough = 0.05e-3; /* mm; touching is 0.001 mm */
    roberts_draw_options options = plain_options(ROBERTS_ORDER_NONE);
    roberts_segment *segment = malloc(COUNT * sizeof *segment);
    rng r = {5};
    (void)state;
    assert_non_null(segment);
    for (size_t i = 0; i < COUNT; i++) {
        size_t k = i * 7919 % COUNT, line = k / PIECES; /* a prime: each once */
        double x = 30.0 * (double)(k % PIECES), y = 10.0 + apart * (double)line, end[2];
        for (int e = 0; e < 2; e++)
            end[e] = y + (line % 2 ? tilt : -tilt) * (x + 40.0 * e) / SIDE + rough * (random_mm(&r) / 50.0 - 1.0);
        segment[i] = line_at(ROBERTS_OUTLINE, x, end[0], x + 40.0, end[1]);
    }
    strokes s = strokes_of(segment, COUNT, &options);
    assert_int_equal(s.lines.count, LINES);
    for (size_t i = 0; i < s.lines.count; i++) {
        const page_point *p = s.lines.point + s.lines.item[i].first;
        assert_int_equal(s.lines.item[i].count, 2);
        assert_int_equal(abs(p[1].x - p[0].x), 100 * 1000);
    }
    strokes_free(&s);
    free(segment);
}

/* ---- real dashes ---- */

static const struct {
    const char *name;
    given segment[GIVEN_MOST];
    double dash_mm, gap_mm;
    const char *wanted;
} dash_cases[] = {
    {"3 mm seen, 1 mm gap, of a pen of 1 mm",
     {{'h', 1, 1, 11, 1, 0, 0}},
     3,
     1,
     "hidden 1,1 3,1; hidden 5,1 7,1; hidden 9,1 11,1"},
    {"a line that another meets is one",
     {{'h', 1, 1, 7, 1, 0, 0}, {'h', 7, 1, 11, 1, 0, 0}, {'h', 7, 1, 7, 2, 0, 0}},
     3,
     1,
     "hidden 1,1 3,1; hidden 5,1 7,1; hidden 9,1 11,1; hidden 7,1 7,2"},
    {"round a corner",
     {{'h', 1, 1, 7, 1, 0, 0}, {'h', 7, 1, 7, 7, 0, 0}},
     3,
     1,
     "hidden 1,1 3,1; hidden 5,1 7,1 7,3; hidden 7,5 7,7"},
    {"unbroken", {{'h', 1, 1, 9, 1, 0, 0}}, 0, 1, "hidden 1,1 9,1"},
    {"other classes stay",
     {{'h', 1, 1, 4, 1, 0, 0}, {'o', 1, 5, 9, 5, 0, 0}},
     3,
     1,
     "hidden 1,1 1.5,1; hidden 3.5,1 4,1; outline 1,5 9,5"},
};

static void real_dashes(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof dash_cases / sizeof dash_cases[0]; i++) {
        roberts_draw_options options = plain_options(ROBERTS_ORDER_NONE);
        options.hidden = ROBERTS_HIDDEN_DASHED;
        options.real_dashes = true;
        options.back = (roberts_pen){.width_mm = 1, .dash_mm = dash_cases[i].dash_mm, .gap_mm = dash_cases[i].gap_mm};
        expect_strokes(dash_cases[i].name, dash_cases[i].segment, &options, dash_cases[i].wanted);
    }
}

static void too_many_dashes_are_refused(void **state)
{
    roberts_draw_options options = plain_options(ROBERTS_ORDER_NONE);
    roberts_segment segment = line_at(ROBERTS_OUTLINE, 0, 0, 40000, 0);
    roberts_drawing drawing = {.count = 1, .segment = &segment};
    roberts_error error = {0};
    strokes s;
    (void)state;
    options.page = (roberts_page){.width_mm = 40000, .height_mm = 4000, .margin_mm = 0};
    options.real_dashes = true;
    options.outline = (roberts_pen){.width_mm = 1e-3, .dash_mm = 1e-3};
    assert_int_equal(strokes_make(&s, &drawing, &options, &error), ROBERTS_OK); /* at a unit of 0.01 mm */
    strokes_free(&s);
    roberts_segment many[20];
    for (int i = 0; i < 20; i++)
        many[i] = line_at(ROBERTS_OUTLINE, 0, 100 * i, 40000, 100 * i);
    drawing = (roberts_drawing){.count = 20, .segment = many};
    assert_int_equal(strokes_make(&s, &drawing, &options, &error), ROBERTS_BAD_ARGUMENT);
    assert_non_null(strstr(error.message, "dashes"));
    strokes_free(&s);
}

/* ---- the frame ---- */

static void frame_lies_on_the_margins(void **state)
{
    roberts_draw_options options = plain_options(ROBERTS_ORDER_TRAVEL);
    roberts_segment segment = line_at(ROBERTS_OUTLINE, 0, 0, 100, 0);
    char text[200];
    (void)state;
    options.page.margin_mm = 10;
    options.frame.off = false;
    strokes s = strokes_of(&segment, 1, &options);
    print_strokes(&s, text, sizeof text);
    assert_string_equal(text, "outline 10,10 90,10; frame 10,90 90,90 90,10 10,10 closed");
    strokes_free(&s);
}

/* The strokes of the drawing are those wanted; NULL: it is refused. If `wanted` ends in a semicolon and a blank, more
 * may follow. */
static void expect_on_page(const char *name, const roberts_drawing *drawing, const roberts_draw_options *options,
                           const char *wanted)
{
    char text[200];
    strokes s;
    bool done = strokes_make(&s, drawing, options, NULL) == ROBERTS_OK;
    print_strokes(&s, text, sizeof text);
    print_message("%s: %s\n", name, text);
    assert_int_equal(done, wanted != NULL);
    if (done) {
        size_t length = strlen(wanted);
        assert_memory_equal(text, wanted, length + (wanted[length - 1] != ' '));
    }
    strokes_free(&s);
}

/* A drawing keeps clear of the frame whether it is fitted, at the left or true to scale. A window reaches to it. */
static void drawings_keep_from_the_frame(void **state)
{
    static const struct {
        const char *name;
        double side_mm, margin_mm;
        bool off, framed, windowed;
        roberts_placement placement;
        const char *wanted; /* NULL: refused */
    } table[] = {
        {"fitted", 100, 10, false, false, false, {0, 0, 0, 0, false}, "outline 15,50 85,50; "},
        {"fitted, no frame", 100, 10, true, false, false, {0, 0, 0, 0, false}, "outline 10,50 90,50"},
        {"fitted, a window", 100, 10, false, true, false, {0, 0, 0, 0, false}, "outline 10,10 90,10; "},
        {"fitted, by the window", 100, 10, false, false, true, {0, 0, 0, 0, false}, "outline 15,15 85,15; "},
        {"small page: a tenth of its room", 40, 10, false, false, false, {0, 0, 0, 0, false}, "outline 12,80 28,80; "},
        {"aligned", 100, 10, false, false, false, {0.5, 1, -1, -1, false}, "outline 15,15 65,15; "},
        {"no margin: half of the pen is kept",
         100,
         0,
         true,
         false,
         false,
         {0, 0, 0, 0, false},
         "outline 0.25,50 99.75,50"},
        {"one of less than that", 100, 0.1, true, false, false, {0, 0, 0, 0, false}, "outline 0.25,50 99.75,50"},
        {"one of just that", 100, 0.25, true, false, false, {0, 0, 0, 0, false}, "outline 0.25,50 99.75,50"},
        {"no margin on a page as small as they come",
         1,
         0,
         true,
         false,
         false,
         {0, 0, 0, 0, false},
         "outline 0.1,99.5 0.9,99.5"},
        {"no margin, true to scale", 100, 0, true, false, false, {1, 1, 0, 0, false}, "outline 0,50 100,50"},
        {"no margin, at a standard scale", 100, 0, true, false, false, {0, 1, 0, 0, true}, "outline 25,50 75,50"},
        {"no margin, aligned", 100, 0, true, false, false, {0, 0, 0, -1, false}, "outline 0.25,0.25 99.75,0.25"},
        {"no margin, a field of view", 100, 0, true, true, false, {0, 0, 0, 0, false}, "outline 0,0 100,0"},
        {"fills the room", 100, 10, false, false, false, {0.7, 1, 0, 0, false}, "outline 15,50 85,50; "},
        {"leaves the room", 100, 10, false, false, false, {0.71, 1, 0, 0, false}, NULL},
        {"leaves it, but there is no frame",
         100,
         10,
         true,
         false,
         false,
         {0.71, 1, 0, 0, false},
         "outline 14.5,50 85.5,50"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_draw_options options = plain_options(ROBERTS_ORDER_TRAVEL);
        roberts_segment segment = line_at(ROBERTS_OUTLINE, 0, 0, 100, 0);
        roberts_drawing drawing = {.count = 1,
                                   .segment = &segment,
                                   .framed = table[i].framed,
                                   .windowed = table[i].windowed,
                                   .window_max = {SIDE, SIDE},
                                   .epsilon = 1e-9};
        options.page = (roberts_page){table[i].side_mm, table[i].side_mm, table[i].margin_mm};
        options.frame.off = table[i].off;
        options.placement = table[i].placement;
        expect_on_page(table[i].name, &drawing, &options, table[i].wanted);
    }
}

/* A field of view of 100 x 100 about (50, 50), and what it becomes on pages of other shapes: the longer side is filled,
 * the frame is where lines are cut off. (Here y is counted down from 100 at the top.) */
static void fields_of_view_fill_the_page(void **state)
{
    static const struct {
        const char *name;
        roberts_page page;
        bool off;
        roberts_placement placement;
        const char *wanted; /* NULL: refused */
    } table[] = {
        {"square",
         {100, 100, 10},
         false,
         {0, 0, 0, 0, false},
         "outline 10,50 90,50; frame 10,90 90,90 90,10 10,10 closed"},
        {"lying",
         {180, 100, 10},
         false,
         {0, 0, 0, 0, false},
         "outline 10,50 170,50; frame 10,90 170,90 170,10 10,10 closed"},
        {"upright",
         {100, 180, 10},
         false,
         {0, 0, 0, 0, false},
         "outline 10,10 90,10; frame 10,90 90,90 90,-70 10,-70 closed"},
        {"no frame", {180, 100, 10}, true, {0, 0, 0, 0, false}, "outline 10,50 170,50"},
        {"nothing to align", {180, 100, 10}, true, {0, 0, -1, 1, false}, "outline 10,50 170,50"},
        {"true to scale",
         {180, 100, 10},
         false,
         {0.4, 1, 0, 0, false},
         "outline 50,50 130,50; frame 50,70 130,70 130,30 50,30 closed"},
        {"the same in a corner",
         {180, 100, 10},
         false,
         {0.4, 1, -1, -1, false},
         "outline 10,30 90,30; frame 10,50 90,50 90,10 10,10 closed"},
        {"at the largest standard scale",
         {180, 100, 10},
         false,
         {0, 1, 0, 0, true},
         "outline 40,50 140,50; frame 40,75 140,75 140,25 40,25 closed"},
        {"leaves the page", {180, 100, 10}, false, {0.81, 1, 0, 0, false}, NULL},
        {"a strip", {4000, 2, 0}, true, {0, 0, 0, 0, false}, "outline 0,99 4000,99"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_draw_options options = plain_options(ROBERTS_ORDER_TRAVEL);
        roberts_segment segment = line_at(ROBERTS_OUTLINE, -1e7, 50, 1e7, 50);
        roberts_drawing drawing = {
            .count = 1, .segment = &segment, .framed = true, .window_max = {SIDE, SIDE}, .epsilon = 1e-9};
        options.page = table[i].page;
        options.frame.off = table[i].off;
        options.placement = table[i].placement;
        expect_on_page(table[i].name, &drawing, &options, table[i].wanted);
    }
}

/* ---- smooth meshes ---- */

enum { ROUND = 90, ACROSS = 45 };

/* A torus of quadrilaterals, seen as the preset `view`. */
static roberts_drawing torus_drawing(const char *view)
{
    const double turn = 6.283185307179586;
    roberts_mesh mesh = {0};
    for (uint32_t i = 0; i < ROUND * ACROSS; i++) {
        const double u = turn * (i / ACROSS) / ROUND, v = turn * (i % ACROSS) / ACROSS, r = 3.0 + cos(v);
        const roberts_vec3 p = {r * cos(u), r * sin(u), sin(v)};
        mesh_vertex(&mesh, p);
    }
    for (uint32_t i = 0; i < ROUND; i++)
        for (uint32_t k = 0; k < ACROSS; k++) {
            const uint32_t row = i * ACROSS, next = (i + 1) % ROUND * ACROSS, over = (k + 1) % ACROSS;
            const uint32_t corner[] = {row + k, next + k, next + over, row + over};
            mesh_face(&mesh, corner, 4);
        }
    roberts_camera camera = preset_camera(view);
    roberts_scene *scene = build_scene(&mesh);
    roberts_drawing drawing = drawing_of(scene, &camera, NULL);
    roberts_scene_free(scene);
    return drawing;
}

static double stroke_length(const strokes *s, const polyline *line)
{
    const page_point *p = s->lines.point + line->first;
    double length = line->closed ? page_distance(p[0], p[line->count - 1]) : 0.0;
    for (uint32_t k = 1; k < line->count; k++)
        length += page_distance(p[k - 1], p[k]);
    return length;
}

/* The pen is lifted only where a line ends: no two strokes of a class end at one place, so none could continue as the
 * other. */
static void check_ends(const strokes *s)
{
    for (size_t i = 0; i < s->lines.count; i++)
        for (size_t k = 0; k < i; k++) {
            const polyline *a = &s->lines.item[i], *b = &s->lines.item[k];
            for (int end = 0; end < 4 && !a->closed && !b->closed; end++)
                assert_false(page_touches(s->lines.point[a->first + (end & 1 ? a->count - 1 : 0)],
                                          s->lines.point[b->first + (end & 2 ? b->count - 1 : 0)]));
        }
}

static const struct {
    const char *view;
    size_t most; /* strokes */
} smooth_cases[] = {
    {"front", 1}, {"top", 2}, {"iso", 30}, /* where the outline folds back and goes behind itself it is cut */
};

/* Outlines of smooth meshes are drawn in long strokes. */
static void smooth_outlines_are_long_strokes(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof smooth_cases / sizeof smooth_cases[0]; i++) {
        roberts_drawing drawing = torus_drawing(smooth_cases[i].view);
        roberts_draw_options options = roberts_draw_options_default();
        strokes s;
        double all = 0.0, longest = 0.0;
        assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
        for (size_t k = 0; k < s.lines.count; k++) {
            const double length = stroke_length(&s, &s.lines.item[k]);
            all += length;
            longest = length > longest ? length : longest;
        }
        print_message("%s: %zu segments, %zu strokes, the longest has %.0f %% of the length\n", smooth_cases[i].view,
                      drawing.count, s.lines.count, 100.0 * longest / all);
        assert_true(s.lines.count <= smooth_cases[i].most);
        assert_true(longest > 0.5 * all);
        check_ends(&s);
        strokes_free(&s);
        roberts_drawing_free(&drawing);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(doubles),
        cmocka_unit_test(chains),
        cmocka_unit_test(every_step_is_drawn_once),
        cmocka_unit_test(scenes_are_drawn_once),
        cmocka_unit_test(what_touches_is_outline),
        cmocka_unit_test(ways_are_short),
        cmocka_unit_test(small_tours_are_nearly_best),
        cmocka_unit_test(crowds),
        cmocka_unit_test(near_lines_are_told_apart),
        cmocka_unit_test(real_dashes),
        cmocka_unit_test(too_many_dashes_are_refused),
        cmocka_unit_test(frame_lies_on_the_margins),
        cmocka_unit_test(drawings_keep_from_the_frame),
        cmocka_unit_test(fields_of_view_fill_the_page),
        cmocka_unit_test(smooth_outlines_are_long_strokes),
    };
    return cmocka_run_group_tests_name("strokes", tests, NULL, NULL);
}
