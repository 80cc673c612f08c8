/* table.c - segments as tables: CSV and JSON, one row per maximal interval of an edge.
 *
 * Numbers have 17 significant digits, so that a table holds all that was computed. `by` is empty (null) where nothing
 * hides the row. */
#include "draw/table.h"

static const char *const column[] = {"solid", "v0", "v1", "t0", "t1", "state", "x0", "y0", "x1", "y1", "by"};

enum { COLUMNS = sizeof column / sizeof column[0], T0 = 3, STATE = 5, BY = 10 };

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

static bool is_listed(const roberts_segment *s, bool with_hidden)
{
    return s->state == ROBERTS_VISIBLE || with_hidden;
}

static void write_field(const roberts_segment *s, int i, output *out)
{
    const uint32_t integer[] = {s->solid, s->v0, s->v1};
    const double number[] = {s->t0, s->t1, 0.0 /* no number: the state */, s->p0.x, s->p0.y, s->p1.x, s->p1.y};
    if (i < T0)
        output_integer(out, integer[i]);
    else if (i == STATE)
        output_text(out, state_name(s->state));
    else if (i < BY)
        output_number(out, number[i - T0]);
    else
        output_integer(out, s->by);
}

void table_write_csv(const roberts_drawing *drawing, bool with_hidden, output *out)
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
        for (int i = 0; i < COLUMNS; i++) {
            if (i)
                output_bytes(out, ",", 1);
            if (i != BY || s->by != ROBERTS_NONE)
                write_field(s, i, out);
        }
        output_bytes(out, "\n", 1);
    }
}

static void write_member(const roberts_segment *s, int i, output *out)
{
    output_text(out, i ? ",\"" : "\"");
    output_text(out, column[i]);
    output_text(out, i == STATE ? "\":\"" : "\":");
    if (i == BY && s->by == ROBERTS_NONE)
        output_text(out, "null");
    else
        write_field(s, i, out);
    if (i == STATE)
        output_bytes(out, "\"", 1);
}

void table_write_json(const roberts_drawing *drawing, bool with_hidden, output *out)
{
    bool first = true;
    output_text(out, "[");
    for (size_t n = 0; n < drawing->count; n++) {
        const roberts_segment *s = &drawing->segment[n];
        if (!is_listed(s, with_hidden))
            continue;
        output_text(out, first ? "\n{" : ",\n{");
        first = false;
        for (int i = 0; i < COLUMNS; i++)
            write_member(s, i, out);
        output_text(out, "}");
    }
    output_text(out, first ? "]\n" : "\n]\n");
}
