/* table.c - segments as tables: CSV and JSON, one row per maximal interval of a line.
 *
 * Numbers have 17 significant digits, so that a table holds all that was computed. `by` is empty (null) where nothing
 * hides the row, v0 and v1 where the line is no edge, and f0 and f1 where the edge has no such face. */
#include "draw/table.h"

static const char *const column[] = {"body", "v0", "v1", "t0", "t1",    "state", "x0",
                                     "y0",   "x1", "y1", "by", "class", "f0",    "f1"};

enum { COLUMNS = sizeof column / sizeof column[0], V0 = 1, T0 = 3, STATE = 5, BY = 10, CLASS = 11, F0 = 12 };

/* A row: a segment and the faces of its line. */
typedef struct row {
    const roberts_segment *s;
    uint32_t face[2];
} row;

static row row_of(const roberts_drawing *drawing, const roberts_scene *scene, const roberts_segment *s)
{
    row r = {s, {ROBERTS_NONE, ROBERTS_NONE}};
    if (scene || s->line == ROBERTS_INTERSECTION)
        roberts_segment_faces(scene, drawing, s, r.face);
    return r;
}

static const char *state_name(uint8_t state)
{
    switch (state) {
    case ROBERTS_HIDDEN:
        return "hidden";
    case ROBERTS_CLIPPED:
        return "clipped";
    default:
        return "visible";
    }
}

/* An edge at the back of its solid is a crease: its faces lie on both sides of it. */
static const char *class_name(uint8_t line)
{
    switch (line) {
    case ROBERTS_OUTLINE:
        return "outline";
    case ROBERTS_BORDER:
        return "border";
    case ROBERTS_INTERSECTION:
        return "intersection";
    case ROBERTS_WIRE:
        return "wire";
    default:
        return "crease";
    }
}

static bool is_listed(const roberts_segment *s, bool with_hidden)
{
    return s->state == ROBERTS_VISIBLE || with_hidden;
}

/* Whether column i holds whole numbers; all other columns but the words hold numbers with decimals. */
static bool is_whole(int i)
{
    return i < T0 || i == BY || i >= F0;
}

/* The number in such a column; ROBERTS_NONE: empty. */
static uint32_t whole_number(const row *r, int i)
{
    const uint32_t early[] = {r->s->solid, r->s->v0, r->s->v1};
    return i < T0 ? early[i] : i == BY ? r->s->by : r->face[i - F0];
}

static bool is_word(int i)
{
    return i == STATE || i == CLASS;
}

static bool is_empty(const row *r, int i)
{
    return i >= V0 && is_whole(i) && whole_number(r, i) == ROBERTS_NONE;
}

static void write_field(const row *r, int i, output *out)
{
    const roberts_segment *s = r->s;
    const double number[] = {s->t0, s->t1, 0.0 /* no number: the state */, s->p0.x, s->p0.y, s->p1.x, s->p1.y};
    if (is_whole(i))
        output_integer(out, whole_number(r, i));
    else if (is_word(i))
        output_text(out, i == STATE ? state_name(s->state) : class_name(s->line));
    else
        output_number(out, number[i - T0]);
}

void table_write_csv(const roberts_drawing *drawing, const roberts_scene *scene, bool with_hidden, output *out)
{
    for (int i = 0; i < COLUMNS; i++) {
        output_text(out, i ? "," : "");
        output_text(out, column[i]);
    }
    output_bytes(out, "\n", 1);
    for (size_t n = 0; n < drawing->count; n++) {
        const roberts_segment *s = &drawing->segment[n];
        if (!is_listed(s, with_hidden))
            continue;
        const row r = row_of(drawing, scene, s);
        for (int i = 0; i < COLUMNS; i++) {
            if (i)
                output_bytes(out, ",", 1);
            if (!is_empty(&r, i))
                write_field(&r, i, out);
        }
        output_bytes(out, "\n", 1);
    }
}

static void write_member(const row *r, int i, output *out)
{
    output_text(out, i ? ",\"" : "\"");
    output_text(out, column[i]);
    output_text(out, is_word(i) ? "\":\"" : "\":");
    if (is_empty(r, i))
        output_text(out, "null");
    else
        write_field(r, i, out);
    if (is_word(i))
        output_bytes(out, "\"", 1);
}

void table_write_json(const roberts_drawing *drawing, const roberts_scene *scene, bool with_hidden, output *out)
{
    bool first = true;
    output_text(out, "[");
    for (size_t n = 0; n < drawing->count; n++) {
        const roberts_segment *s = &drawing->segment[n];
        if (!is_listed(s, with_hidden))
            continue;
        output_text(out, first ? "\n{" : ",\n{");
        first = false;
        const row r = row_of(drawing, scene, s);
        for (int i = 0; i < COLUMNS; i++)
            write_member(&r, i, out);
        output_text(out, "}");
    }
    output_text(out, first ? "]\n" : "\n]\n");
}
