/* shapes.c - bodies that are not convex, from formulas: two famous toroids, solids of revolution, a bolt, a bracket,
 * land, and a one-sided strip. Faces run counter-clockwise seen from outside, if there is an outside. */
#include "exact.h"
#include "models.h"

/* ---- faces ------------------------------------------------------------------------------------------------------ */

enum { LOOP_MAX = 32 };

/* Corners in a ring. */
typedef struct loop {
    size_t count;
    uint32_t corner[LOOP_MAX];
} loop;

static void loop_add(loop *l, uint32_t vertex)
{
    l->corner[l->count++] = vertex;
}

static loop reversed(const loop *l)
{
    loop r = {0};
    for (size_t i = 0; i < l->count; i++)
        loop_add(&r, l->corner[(l->count - i) % l->count]);
    return r;
}

static void loop_face(body *b, const loop *l)
{
    body_face(b, l->corner, l->count);
}

/* A hole, and the corner of the outer loop from which a slit leads to the hole's first corner. */
typedef struct hole {
    const loop *loop;
    size_t slit_from;
} hole;

/* Adds a face with holes; all loops run counter-clockwise seen from outside. */
static void face_with_holes(body *b, const loop *outer, const hole *holes, size_t hole_count)
{
    for (size_t i = 0; i < outer->count; i++) {
        body_corner(b, outer->corner[i]);
        for (size_t h = 0; h < hole_count; h++) {
            const loop *l = holes[h].loop;
            if (holes[h].slit_from != i)
                continue;
            for (size_t k = 0; k <= l->count; k++)
                body_corner(b, l->corner[(l->count - k) % l->count]);
            body_corner(b, outer->corner[i]);
        }
    }
    body_end_face(b);
}

/* Adds quadrangles from the loop `lower` to `upper`, joining corners of the same number. */
static void loop_band(body *b, const loop *lower, const loop *upper)
{
    for (size_t i = 0; i < lower->count; i++) {
        size_t j = (i + 1) % lower->count;
        body_face(b, (uint32_t[]){lower->corner[i], lower->corner[j], upper->corner[j], upper->corner[i]}, 4);
    }
}

/* A regular polygon about the z axis. */
static loop ring(body *b, uint32_t n, double radius, double z)
{
    loop l = {0};
    for (uint32_t i = 0; i < n; i++) {
        roberts_vec2 p = circle_point(i, n);
        loop_add(&l, body_vertex(b, radius * p.x, radius * p.y, z));
    }
    return l;
}

/* ---- toroids of seven ------------------------------------------------------------------------------------------- */

static void add_table(body *b, const int (*vertex)[3], size_t vertex_count, const uint32_t *corner, size_t face_count,
                      size_t corners)
{
    for (size_t v = 0; v < vertex_count; v++)
        body_vertex(b, vertex[v][0], vertex[v][1], vertex[v][2]);
    for (size_t f = 0; f < face_count; f++)
        body_face(b, corner + f * corners, corners);
}

static void csaszar(body *b)
{
    static const int vertex[7][3] = {{3, -3, 0},  {-3, 3, 0}, {-3, -3, 1}, {3, 3, 1},
                                     {-1, -2, 3}, {1, 2, 3},  {0, 0, 15}};
    static const uint32_t corner[14 * 3] = {0, 1, 3, 0, 2, 1, 0, 3, 4, 0, 4, 5, 0, 5, 6, 0, 6, 2, 1, 2, 5,
                                            1, 4, 6, 1, 5, 4, 1, 6, 3, 2, 3, 5, 2, 4, 3, 2, 6, 4, 3, 6, 5};
    add_table(b, vertex, 7, corner, 14, 3);
}

static void szilassi(body *b)
{
    static const int vertex[14][3] = {{240, 0, 240},    {-240, 0, 240},   {0, 252, -240}, {0, -252, -240},
                                      {40, -100, -160}, {-40, 100, -160}, {75, 75, -60},  {-75, -75, -60},
                                      {90, -50, 40},    {-90, 50, 40},    {140, 0, 40},   {-140, 0, 40},
                                      {140, 50, 40},    {-140, -50, 40}};
    static const uint32_t corner[7 * 6] = {0, 1, 13, 8, 7, 4, 8, 13, 11, 9, 12, 10, 1, 5, 2,  3, 11, 13, 3, 4, 7,
                                           6, 9, 11, 0, 4, 3, 2, 10, 12, 2, 5,  6,  7, 8, 10, 0, 12, 9,  6, 5, 1};
    add_table(b, vertex, 14, corner, 7, 6);
}

/* ---- revolved --------------------------------------------------------------------------------------------------- */

/* 24 trapezoids around the ring, 12 around the tube. */
static void torus(body *b)
{
    const double radius = 3, tube = 1.25;
    loop first, last;
    for (uint32_t i = 0; i <= 12; i++) {
        roberts_vec2 p = circle_point(i, 12);
        loop next = i < 12 ? ring(b, 24, radius + tube * p.x, tube * p.y) : first;
        if (i == 0)
            first = next;
        else
            loop_band(b, &last, &next);
        last = next;
    }
}

/* The outline from the foot up to the rim and down to the bottom of the bowl. */
static void goblet(body *b)
{
    static const double outline[][2] = {{3, 0},        {3, 0.25},     {1.5, 0.75},  {0.5, 1.5}, {0.375, 3.5},
                                        {0.75, 4},     {0.375, 4.5},  {0.5, 5},     {1.75, 6},  {2.5, 7.5},
                                        {2.625, 9},    {2.375, 10.5}, {2.25, 10.5}, {2.5, 9},   {2.375, 7.5},
                                        {1.625, 6.25}, {0.5, 5.5}};
    loop last = ring(b, 24, outline[0][0], outline[0][1]), bottom = reversed(&last);
    loop_face(b, &bottom);
    for (size_t i = 1; i < sizeof outline / sizeof *outline; i++) {
        loop next = ring(b, 24, outline[i][0], outline[i][1]);
        loop_band(b, &last, &next);
        last = next;
    }
    loop_face(b, &last);
}

/* ---- a bolt ----------------------------------------------------------------------------------------------------- */

/* The thread is cut by COLUMNS half-planes through the axis. In each one, its crest and its root are points, half a
 * pitch apart in height; they are numbered h, with even numbers on the crest. From one half-plane to the next they rise
 * by pitch / COLUMNS. Heights below are in these steps. */
enum { COLUMNS = 24, HALF_PITCH = COLUMNS / 2, TURNS = 6, TOP = TURNS * COLUMNS, POINTS = 2 * TURNS + 3 };

static const double thread_pitch = 1.5, crest_radius = 2.75, root_radius = 2;

/* The points of one half-plane from h = low - 2 to high - 2, including the ends of the thread where one falls on a
 * crest or a root. */
typedef struct column {
    int low, high;
    uint32_t bottom, top, point[POINTS];
} column;

static uint32_t thread_vertex(body *b, int k, int step)
{
    int phase = ((step - k) % COLUMNS + COLUMNS) % COLUMNS, from_crest = phase < HALF_PITCH ? phase : COLUMNS - phase;
    double radius = crest_radius - (crest_radius - root_radius) * from_crest / HALF_PITCH;
    roberts_vec2 p = circle_point((uint64_t)k, COLUMNS);
    return body_vertex(b, radius * p.x, radius * p.y, thread_pitch / COLUMNS * step);
}

static column thread_column(body *b, int k)
{
    column c = {.low = POINTS, .high = -1};
    c.bottom = thread_vertex(b, k, 0);
    c.top = thread_vertex(b, k, TOP);
    for (int h = 0; h < POINTS; h++) {
        int step = k + (h - 2) * HALF_PITCH;
        if (step < 0 || step > TOP)
            continue;
        c.point[h] = step == 0 ? c.bottom : step == TOP ? c.top : thread_vertex(b, k, step);
        c.low = c.low < h ? c.low : h;
        c.high = h;
    }
    return c;
}

/* Returns column 0 again, after the last one: a turn further, each of its points has a number smaller by 2. */
static column next_turn(const column *c)
{
    column next = *c;
    next.low -= 2;
    next.high -= 2;
    for (int h = 0; h + 2 < POINTS; h++)
        next.point[h] = c->point[h + 2];
    return next;
}

/* Adds a quadrangle, or a triangle if two of its corners are the same. */
static void add_cell(body *b, uint32_t p, uint32_t q, uint32_t r, uint32_t s)
{
    body_corner(b, p);
    if (q != p)
        body_corner(b, q);
    if (r != q)
        body_corner(b, r);
    if (s != r && s != p)
        body_corner(b, s);
    body_end_face(b);
}

static void thread_strip(body *b, const column *c, const column *d)
{
    int low = c->low > d->low ? c->low : d->low, high = c->high < d->high ? c->high : d->high;
    add_cell(b, c->bottom, d->bottom, d->point[low], c->point[low]);
    for (int h = low; h < high; h++)
        add_cell(b, c->point[h], d->point[h], d->point[h + 1], c->point[h + 1]);
    add_cell(b, c->point[high], d->point[high], d->top, c->top);
}

static void screw(body *b)
{
    const double head_radius = 5, head_height = 3, end = thread_pitch * TURNS;
    loop bottom = {0}, top = {0};
    column at[COLUMNS + 1];
    for (int k = 0; k < COLUMNS; k++) {
        at[k] = thread_column(b, k);
        loop_add(&bottom, at[k].bottom);
        loop_add(&top, at[k].top);
    }
    at[COLUMNS] = next_turn(&at[0]);
    for (int k = 0; k < COLUMNS; k++)
        thread_strip(b, &at[k], &at[k + 1]);
    bottom = reversed(&bottom);
    top = reversed(&top);
    loop_face(b, &bottom);
    loop under = ring(b, 6, head_radius, end), over = ring(b, 6, head_radius, end + head_height);
    loop_band(b, &under, &over);
    loop_face(b, &over);
    under = reversed(&under);
    face_with_holes(b, &under, &(hole){&top, 0}, 1);
}

/* ---- a bracket -------------------------------------------------------------------------------------------------- */

/* A circle of n corners in the plane y = const about the point x = 0, z, or in the plane z = const about x, y. It
 * starts `first` steps from the x axis and runs from x to the other axis. */
static loop upright_circle(body *b, uint32_t n, double radius, double y, double z)
{
    loop l = {0};
    for (uint32_t i = 0; i < n; i++) {
        roberts_vec2 p = circle_point(i, n);
        loop_add(&l, body_vertex(b, radius * p.x, y, z + radius * p.y));
    }
    return l;
}

static loop level_circle(body *b, uint32_t first, double radius, roberts_vec3 middle)
{
    const uint32_t n = 16;
    loop l = {0};
    for (uint32_t i = 0; i < n; i++) {
        roberts_vec2 p = circle_point(first + i, n);
        loop_add(&l, body_vertex(b, middle.x + radius * p.x, middle.y + radius * p.y, middle.z));
    }
    return l;
}

static const double half_width = 6, bracket_depth = 10, thickness = 2, eye_height = 9;

/* The outline of the upright plate at y: its two lower corners, then the arc above from right to left. */
static loop upright_outline(body *b, double y, double bottom)
{
    loop l = {0};
    loop_add(&l, body_vertex(b, -half_width, y, bottom));
    loop_add(&l, body_vertex(b, half_width, y, bottom));
    for (uint32_t i = 0; i <= 12; i++) {
        roberts_vec2 p = circle_point(i, 24);
        loop_add(&l, body_vertex(b, half_width * p.x, y, eye_height + half_width * p.y));
    }
    return l;
}

/* The base plate, which lies under the upright plate and in front of it. Its corners at the back are those of `back`;
 * those of the inner corner are those of `front`. */
static void bracket_base(body *b, const loop *back, const loop *front)
{
    loop end = {0}, hole_low[2], hole_high[2];
    for (int i = 0; i < 2; i++)
        loop_add(&end, body_vertex(b, i ? -half_width : half_width, bracket_depth, 0));
    for (int i = 0; i < 2; i++)
        loop_add(&end, body_vertex(b, i ? half_width : -half_width, bracket_depth, thickness));
    for (int i = 0; i < 2; i++) { /* each slit leads to the nearest corner */
        roberts_vec3 middle = {i ? -3.5 : 3.5, 6.5, 0};
        hole_low[i] = level_circle(b, i ? 6 : 2, 1.25, middle);
        hole_high[i] = level_circle(b, i ? 6 : 2, 1.25, vec3_add(middle, vec3(0, 0, thickness)));
        hole_low[i] = reversed(&hole_low[i]);
        loop inside = reversed(&hole_high[i]);
        loop_band(b, &hole_low[i], &inside);
    }
    loop_face(b, &end);
    loop bottom = {4, {back->corner[1], back->corner[0], end.corner[1], end.corner[0]}};
    loop top = {4, {front->corner[0], front->corner[1], end.corner[3], end.corner[2]}};
    face_with_holes(b, &bottom, (hole[]){{&hole_low[0], 3}, {&hole_low[1], 2}}, 2);
    face_with_holes(b, &top, (hole[]){{&hole_high[0], 2}, {&hole_high[1], 3}}, 2);
    body_face(b,
              (uint32_t[]){back->corner[1], end.corner[0], end.corner[3], front->corner[1], front->corner[2],
                           back->corner[2]},
              6);
    body_face(b,
              (uint32_t[]){back->corner[0], back->corner[14], front->corner[14], front->corner[0], end.corner[2],
                           end.corner[1]},
              6);
}

/* A bracket of two plates: two holes in the base, and an eye with a rim in the rounded upright plate. */
static void bracket(body *b)
{
    const double eye = 3, rim = 4.25, rim_depth = 3;
    loop back = upright_outline(b, 0, 0), front = upright_outline(b, thickness, thickness);
    loop eye_back = upright_circle(b, 24, eye, 0, eye_height),
         eye_front = upright_circle(b, 24, eye, rim_depth, eye_height);
    loop rim_foot = upright_circle(b, 24, rim, thickness, eye_height);
    loop rim_front = upright_circle(b, 24, rim, rim_depth, eye_height);
    bracket_base(b, &back, &front);
    for (size_t i = 2; i + 1 < back.count; i++)
        body_face(b, (uint32_t[]){back.corner[i], front.corner[i], front.corner[i + 1], back.corner[i + 1]}, 4);
    face_with_holes(b, &back, &(hole){&eye_back, 2}, 1);
    loop_band(b, &eye_back, &eye_front);
    loop_band(b, &rim_front, &rim_foot);
    front = reversed(&front);
    rim_foot = reversed(&rim_foot);
    rim_front = reversed(&rim_front);
    eye_front = reversed(&eye_front);
    face_with_holes(b, &front, &(hole){&rim_foot, front.count - 2}, 1);
    face_with_holes(b, &rim_front, &(hole){&eye_front, 0}, 1);
}

/* ---- sheets ----------------------------------------------------------------------------------------------------- */

/* Returns the height of hills of a given height and width about x, y. */
static double hills(double x, double y)
{
    static const double hill[][4] = {{14, 5, 12, 19}, {10, 4, 22, 12}, {6, 3, 25, 25}, {5, 3, 6, 7}, {-4, 4, 16, 5}};
    double z = 0;
    for (size_t i = 0; i < sizeof hill / sizeof *hill; i++) {
        double u = (x - hill[i][2]) / hill[i][1], v = (y - hill[i][3]) / hill[i][1];
        z += hill[i][0] / (1 + u * u + v * v);
    }
    return z;
}

enum { FIELD = 32 };

static void terrain(body *b)
{
    for (int j = 0; j <= FIELD; j++)
        for (int i = 0; i <= FIELD; i++)
            body_vertex(b, i, j, rint(64 * hills(i, j)) / 64);
    for (uint32_t j = 0; j < FIELD; j++)
        for (uint32_t i = 0; i < FIELD; i++) {
            uint32_t v = j * (FIELD + 1) + i, w = v + FIELD + 1;
            body_face(b, (uint32_t[]){v, v + 1, w + 1, w}, 4);
        }
}

enum { STRIP_PARTS = 48 };

/* Half a turn about the middle line in one round, so that it closes with its sides exchanged. */
static void moebius_strip(body *b)
{
    const double radius = 4, half = 1.25;
    for (uint32_t i = 0; i < STRIP_PARTS; i++) {
        roberts_vec2 p = circle_point(i, STRIP_PARTS), q = circle_point(i, 2 * STRIP_PARTS);
        for (int side = -1; side < 2; side += 2) {
            double r = radius + side * half * q.x;
            body_vertex(b, r * p.x, r * p.y, side * half * q.y);
        }
    }
    for (uint32_t i = 0; i < STRIP_PARTS; i++) {
        uint32_t v = 2 * i, w = i + 1 < STRIP_PARTS ? v + 2 : 1, x = i + 1 < STRIP_PARTS ? v + 3 : 0;
        body_face(b, (uint32_t[]){v, v + 1, x, w}, 4);
    }
}

static const scene shapes[] = {
    {"csaszar", "Csaszar polyhedron: a toroid of 14 triangles, in which each two of the seven corners share an edge.",
     csaszar},
    {"szilassi",
     "Szilassi polyhedron: a toroid of seven hexagons, each two of which share an edge. Szilassi's coordinates times "
     "20.",
     szilassi},
    {"torus", "Torus: 24 trapezoids round, 12 round the tube.", torus},
    {"goblet", "Goblet, hollow: an outline turned in 24 steps.", goblet},
    {"screw", "Bolt with six turns of a thread and a hexagonal head; faces of the thread are a little twisted.", screw},
    {"bracket", "Bracket: an angle of two plates with two holes, and an eye with a rim. Slits join holes to borders.",
     bracket},
    {"terrain", "Land: five hills over 32 x 32 squares, heights in 64ths; the squares are not flat.", terrain},
    {"moebius-strip", "Moebius strip: 48 quadrangles, a little twisted.", moebius_strip},
};

size_t shape_count(void)
{
    return sizeof shapes / sizeof *shapes;
}

const scene *shape_at(size_t i)
{
    return &shapes[i];
}
