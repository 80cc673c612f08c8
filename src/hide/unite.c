/* unite.c - see unite.h. */
#include "hide/unite.h"

#include <math.h>
#include <string.h>

#include "base/array.h"

/* Corners of the outlines that are looked at. */
#define MOST_CORNERS 16
/* A convex polygon gets four corners more in a cell, and one by each side that cuts it. One with dents, within the tolerance,
 * may get more: then it is not looked at any further. */
#define MOST_PIECE (2 * MOST_CORNERS + 8)
/* How far a front reaches beyond a point is kept in parts of a cell; it takes another's place when it reaches so many
 * parts farther, so that a cell changes its fronts a few times at most. */
#define PARTS 32
#define BETTER 4
/* a x + b y + d: how far inside of each side. */
typedef struct sides {
    double a[MOST_CORNERS], b[MOST_CORNERS], d[MOST_CORNERS];
    uint32_t count;
} sides;

typedef struct piece {
    double x[MOST_PIECE], y[MOST_PIECE];
    uint32_t count;
} piece;

bool unite_init(cover *c)
{
    size_t cells = scan_cells(&c->frame);
    c->rest = alloc_array(cells, sizeof *c->rest);
    for (size_t i = 0; c->rest && i < cells; i++) {
        c->by[i] = ROBERTS_NONE;
        c->rest[i] = (cover_rest){.front = ROBERTS_NONE};
    }
    return c->rest != NULL;
}

/* The front's outline, as much larger as still touches it: what is inside of it is hidden by the front, and between two
 * that do not overlap there is no more than epsilon. False where that cannot be trusted: with a side of length l and
 * corners off by `rounding`, the border is off by 2 rounding (1 + r / l) at a distance r, and the points that are asked
 * about by some rounding too. */
static bool sides_of(const hide_picture *picture, uint32_t index, sides *s)
{
    const hide_space *space = &picture->space;
    const hide_front *front = &picture->front[index];
    const hide_box *box = &picture->front_box[index];
    const uint32_t *corner = picture->outline + front->outline;
    double size = (double)(box->x1 - box->x0) + (double)(box->y1 - box->y0);
    double least = size / (HIDE_TRUSTED * space->epsilon / space->rounding - 6.0);
    if (front->corners < 3 || front->corners > MOST_CORNERS || !(least > 0.0))
        return false;
    s->count = front->corners;
    for (uint32_t i = 0; i < s->count; i++) {
        roberts_vec3 P = picture->P[corner[i]], Q = picture->P[corner[i + 1 < s->count ? i + 1 : 0]];
        double dx = Q.x - P.x, dy = Q.y - P.y, length = sqrt(dx * dx + dy * dy);
        if (!(length > 2.0 * least))
            return false;
        s->a[i] = -dy / length;
        s->b[i] = dx / length;
        s->d[i] = 0.5 * space->epsilon - front->loose - (s->a[i] * P.x + s->b[i] * P.y);
    }
    return true;
}

static double inside_by(const sides *s, double x, double y)
{
    double least = INFINITY;
    for (uint32_t i = 0; i < s->count; i++)
        least = lesser(least, s->a[i] * x + s->b[i] * y + s->d[i]);
    return least;
}

static bool all_inside(const sides *s, const piece *p)
{
    for (uint32_t i = 0; i < p->count; i++)
        if (!(inside_by(s, p->x[i], p->y[i]) >= 0.0))
            return false;
    return true;
}

static void add_point(piece *p, double x, double y)
{
    p->x[p->count] = x;
    p->y[p->count++] = y;
}

/* Divides the polygon by the line a x + b y + d = 0; points on it belong to both. False: more corners than there is room for. */
static bool divide(const piece *whole, double a, double b, double d, piece *inner, piece *outer)
{
    inner->count = outer->count = 0;
    for (uint32_t i = 0; i < whole->count; i++) {
        if (inner->count + 2 > MOST_PIECE || outer->count + 2 > MOST_PIECE)
            return false;
        uint32_t k = i + 1 < whole->count ? i + 1 : 0;
        double px = whole->x[i], py = whole->y[i], qx = whole->x[k], qy = whole->y[k];
        double p = a * px + b * py + d, q = a * qx + b * qy + d;
        if (p >= 0.0)
            add_point(inner, px, py);
        if (p <= 0.0)
            add_point(outer, px, py);
        if ((p < 0.0 && q > 0.0) || (p > 0.0 && q < 0.0)) {
            double t = p / (p - q);
            add_point(inner, px + t * (qx - px), py + t * (qy - py));
            add_point(outer, px + t * (qx - px), py + t * (qy - py));
        }
    }
    return true;
}

/* The least of a x + b y + d over the polygon. */
static double least_of(const piece *p, double a, double b, double d)
{
    double least = INFINITY;
    for (uint32_t i = 0; i < p->count; i++)
        least = lesser(least, a * p->x[i] + b * p->y[i] + d);
    return least;
}

/* Does one front, or that and another (NULL: none) together, hold all of the polygon? What is outside of a side of the
 * first must be inside the second. */
static bool hold(const sides *first, const sides *second, const piece *polygon)
{
    piece room[2], outer;
    for (uint32_t i = 0; i < first->count && polygon->count; i++) {
        double a = first->a[i], b = first->b[i], d = first->d[i];
        if (least_of(polygon, a, b, d) >= 0.0)
            continue;
        piece *inner = polygon == &room[0] ? &room[1] : &room[0];
        if (!second)
            return false;
        if (!divide(polygon, a, b, d, inner, &outer) || !all_inside(second, &outer))
            return false;
        polygon = inner;
    }
    return true;
}

/* The cell, a margin wider on all sides. */
static piece cell_of(const scan_frame *f, uint32_t i, uint32_t j)
{
    double x0 = f->x0 + i * f->dx - f->margin, x1 = f->x0 + (i + 1) * f->dx + f->margin;
    double y0 = f->y0 + j * f->dy - f->margin, y1 = f->y0 + (j + 1) * f->dy + f->margin;
    return (piece){.x = {x0, x1, x1, x0}, .y = {y0, y0, y1, y1}, .count = 4};
}

static signed char in_parts(const scan_frame *f, double length)
{
    double parts = PARTS * length / lesser(f->dx, f->dy);
    return (signed char)(parts < -127.0 ? -127.0 : parts > 127.0 ? 127.0 : parts);
}

/* `index` becomes the first of the cell's fronts. Of the others the one stays that reaches farther where it reaches
 * least. */
static void take_first(hide_picture *picture, size_t at, const piece *cell, uint32_t index, const sides *own,
                       int middle)
{
    cover *c = &picture->cover;
    cover_rest *rest = &c->rest[at];
    uint32_t before[2] = {c->by[at], rest->front};
    double least = INFINITY;
    for (unsigned char k = 0; k < 4; k++) {
        double by = inside_by(own, cell->x[k], cell->y[k]);
        rest->corner = by < least ? k : rest->corner;
        least = lesser(least, by);
    }
    *rest = (cover_rest){ROBERTS_NONE, (signed char)middle, -128, rest->corner};
    c->by[at] = index;
    for (int k = 0; k < 2; k++) {
        sides other;
        if (before[k] == ROBERTS_NONE || !sides_of(picture, before[k], &other))
            continue;
        signed char by = in_parts(&c->frame, inside_by(&other, cell->x[rest->corner], cell->y[rest->corner]));
        if (by > rest->second_by) {
            rest->front = before[k];
            rest->second_by = by;
        }
    }
}

/* Offers the front to one cell; where two now leave nothing open it is covered. */
static void offer(hide_picture *picture, uint32_t index, const sides *own, uint32_t i, uint32_t j)
{
    cover *c = &picture->cover;
    const scan_frame *f = &c->frame;
    size_t at = (size_t)i * f->ny + j;
    cover_rest *rest = &c->rest[at];
    if (c->depth[at] > -INFINITY)
        return;
    signed char middle = in_parts(f, inside_by(own, f->x0 + (i + 0.5) * f->dx, f->y0 + (j + 0.5) * f->dy));
    if (middle <= -PARTS)
        return;
    piece cell = cell_of(f, i, j);
    if (c->by[at] == ROBERTS_NONE || middle >= rest->first_by + 2 * BETTER) {
        take_first(picture, at, &cell, index, own, middle);
    } else {
        signed char by = in_parts(f, inside_by(own, cell.x[rest->corner], cell.y[rest->corner]));
        if (by < rest->second_by + BETTER)
            return;
        rest->front = index;
        rest->second_by = by;
    }
    sides first, second;
    if (rest->front == ROBERTS_NONE || rest->second_by < 0 || !sides_of(picture, c->by[at], &first) ||
        !sides_of(picture, rest->front, &second) || !hold(&first, &second, &cell))
        return;
    float a = picture->front[c->by[at]].depth, b = picture->front[rest->front].depth;
    c->depth[at] = a < b ? a : b;
    c->by[at] = ROBERTS_NONE;
}

void unite_offer(hide_picture *picture, const scan *s, uint32_t front, uint32_t first_front)
{
    const scan_frame *f = &picture->cover.frame;
    sides own;
    bool again = front > first_front &&
                 memcmp(&picture->front_box[front], &picture->front_box[front - 1], sizeof(hide_box)) == 0;
    if (!picture->cover.rest || again || !sides_of(picture, front, &own))
        return; /* many at one place, mostly copies, offer nothing new */
    for (uint32_t i = s->first; i <= s->last; i++) {
        uint32_t low, high, first = 1, last = 0;
        scan_touched(s, f, i, &low, &high);
        if (i < s->inner_first || i > s->inner_last || !scan_inside(s, f, i, &first, &last)) {
            first = 1;
            last = 0;
        }
        for (uint32_t j = low; j <= high; j++)
            if (j < first || j > last)
                offer(picture, front, &own, i, j);
    }
}

/* The polygon's part in the cell, in one of `room`, or the polygon itself where the cell holds all of it. NULL: it has too many
 * corners. */
static const piece *cut_to_cell(const piece *polygon, const scan_frame *f, uint32_t i, uint32_t j, piece room[2])
{
    piece cell = cell_of(f, i, j), outer;
    const double line[4][3] = {{1, 0, -cell.x[0]}, {-1, 0, cell.x[1]}, {0, 1, -cell.y[0]}, {0, -1, cell.y[2]}};
    for (int k = 0; k < 4; k++) {
        piece *inner = polygon == &room[0] ? &room[1] : &room[0];
        if (least_of(polygon, line[k][0], line[k][1], line[k][2]) >= 0.0)
            continue;
        if (!divide(polygon, line[k][0], line[k][1], line[k][2], inner, &outer))
            return NULL;
        polygon = inner;
    }
    return polygon;
}

static bool hidden_in_cell(const hide_picture *picture, const piece *polygon, uint32_t i, uint32_t j, float z1)
{
    const cover *c = &picture->cover;
    size_t at = (size_t)i * c->frame.ny + j;
    uint32_t a = c->by[at], b = c->rest[at].front;
    sides first, second;
    piece room[2];
    if (c->depth[at] > -INFINITY)
        return c->depth[at] > z1;
    if (a == ROBERTS_NONE || !(picture->front[a].depth > z1) || !sides_of(picture, a, &first))
        return false;
    bool both = b != ROBERTS_NONE && picture->front[b].depth > z1 && sides_of(picture, b, &second);
    const piece *part = cut_to_cell(polygon, &c->frame, i, j, room);
    return part && hold(&first, both ? &second : NULL, part);
}

/* Of most solids that are hidden by two fronts these cover cells at their corners: then no cell need be asked. */
static bool hidden_by_two(const hide_picture *picture, const piece *polygon, float z1)
{
    const cover *c = &picture->cover;
    double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
    uint32_t front[2] = {ROBERTS_NONE, ROBERTS_NONE};
    sides first, second;
    for (uint32_t i = 0; i < polygon->count; i++) {
        x0 = lesser(x0, polygon->x[i]);
        x1 = greater(x1, polygon->x[i]);
        y0 = lesser(y0, polygon->y[i]);
        y1 = greater(y1, polygon->y[i]);
    }
    for (int k = 0; k < 4; k++) {
        double dx = 1.5 * c->frame.dx, dy = 1.5 * c->frame.dy;
        uint32_t at = cover_at(c, k % 2 ? x1 - dx : x0 + dx, k / 2 ? y1 - dy : y0 + dy, z1);
        if (at == ROBERTS_NONE)
            continue;
        if (front[0] != ROBERTS_NONE && front[0] != at)
            front[1] = at;
        else
            front[0] = at;
    }
    return front[1] != ROBERTS_NONE && picture->front[front[0]].depth > z1 && picture->front[front[1]].depth > z1 &&
           sides_of(picture, front[0], &first) && sides_of(picture, front[1], &second) &&
           hold(&first, &second, polygon);
}

bool unite_hides(const hide_picture *picture, scan *s, const uint32_t *corner, uint32_t count, float z1)
{
    const cover *c = &picture->cover;
    piece polygon;
    if (!c->rest || count < 3 || count > MOST_CORNERS)
        return false;
    polygon.count = 0;
    for (uint32_t k = 0; k < count; k++)
        add_point(&polygon, picture->P[corner[k]].x, picture->P[corner[k]].y);
    if (hidden_by_two(picture, &polygon, z1))
        return true;
    scan_polygon(s, &c->frame, picture->P, corner, count);
    for (uint32_t i = s->first; i <= s->last; i++) {
        uint32_t low, high;
        scan_touched(s, &c->frame, i, &low, &high);
        for (uint32_t j = low; j <= high; j++)
            if (!hidden_in_cell(picture, &polygon, i, j, z1))
                return false;
    }
    return true;
}
