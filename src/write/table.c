/* table.c - segments as tables: CSV and JSON, one row per maximal interval of a line.
 *
 * Numbers have 17 significant digits, so that a table holds all that was computed. `by` is empty (null) if nothing
 * hides the row, v0 and v1 if the line is no edge, and f0 and f1 if the edge has no such face. */
#include "write/table.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- visible regions --------------------------------------------------------------------------------------------- */

/* Visible regions as JSON, an array with one object, on a line of its own, for each face that is seen;
 * or as CSV with one row for each, whose polygon is well-known text (ISO 19125-1).
 *
 * Numbers but colours have 17 significant digits, as in the tables of segments. `face` is null or empty for a face that
 * the input does not have, and `color` where the input gives none. */

static void write_point(roberts_vec2 p, output *out)
{
    output_text(out, "[");
    output_number(out, p.x);
    output_text(out, ",");
    output_number(out, p.y);
    output_text(out, "]");
}

static void write_member(const char *name, double value, output *out)
{
    output_text(out, name);
    output_number(out, value);
}

/* Writes a number of a colour, which is kept as a 32-bit float, with as few digits as tell it apart: 0.1 stays 0.1. */
static void write_tint(float value, output *out)
{
    char text[DECIMAL_ROOM], plain[DECIMAL_ROOM];
    int digits = FLT_DIG;
    do
        snprintf(text, sizeof text, "%.*g", digits, (double)value);
    while (digits++ < FLT_DECIMAL_DIG && strtof(text, NULL) != value);
    decimal_unlocalise(plain, text);
    output_text(out, plain);
}

/* One number is an index into a colour map, three or four are red, green, blue and alpha. */
static void write_color(const roberts_color *color, output *out)
{
    output_text(out, color->count ? ",\"color\":[" : ",\"color\":null");
    for (int i = 0; i < color->count; i++) {
        output_text(out, i ? "," : "");
        write_tint(color->value[i], out);
    }
    output_text(out, color->count ? "]" : "");
}

static void write_rings(const roberts_region_list *regions, const roberts_region *r, output *out)
{
    output_text(out, ",\"rings\":[");
    for (size_t k = r->first_ring; k < r->first_ring + r->ring_count; k++) {
        output_text(out, k > r->first_ring ? ",[" : "[");
        for (size_t c = regions->ring_start[k]; c < regions->ring_start[k + 1]; c++) {
            output_text(out, c > regions->ring_start[k] ? "," : "");
            write_point(regions->corner[c], out);
        }
        output_text(out, "]");
    }
    output_text(out, "]}");
}

void region_table_write_json(const roberts_region_list *regions, output *out)
{
    output_text(out, "[");
    for (size_t i = 0; i < regions->count; i++) {
        const roberts_region *r = &regions->region[i];
        output_text(out, i ? ",\n{\"body\":" : "\n{\"body\":");
        output_integer(out, r->solid);
        output_text(out, ",\"face\":");
        if (r->face == ROBERTS_NONE)
            output_text(out, "null");
        else
            output_integer(out, r->face);
        write_member(",\"area\":", r->area, out);
        write_member(",\"z0\":", r->z_min, out);
        write_member(",\"z1\":", r->z_max, out);
        write_color(&r->color, out);
        write_rings(regions, r, out);
    }
    output_text(out, "\n]\n");
}

/* A ring of well-known text ends with its first corner. */
static void write_text_ring(const roberts_region_list *regions, size_t ring, output *out)
{
    const size_t first = regions->ring_start[ring], count = regions->ring_start[ring + 1] - first;
    output_text(out, "(");
    for (size_t k = 0; k <= count; k++) {
        const roberts_vec2 p = regions->corner[first + (k < count ? k : 0)];
        output_text(out, k > 0 ? "," : "");
        output_number(out, p.x);
        output_text(out, " ");
        output_number(out, p.y);
    }
    output_text(out, ")");
}

/* Whether a ring bounds a piece, and not a hole in the piece before: its area is then > 0. */
static bool is_piece(const roberts_region_list *regions, size_t ring)
{
    const size_t first = regions->ring_start[ring], end = regions->ring_start[ring + 1];
    const roberts_vec2 o = regions->corner[first];
    double sum = 0.0;
    for (size_t k = first; k + 1 < end; k++) {
        const roberts_vec2 p = regions->corner[k], q = regions->corner[k + 1];
        sum += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
    }
    return sum > 0.0;
}

static void write_polygon(const roberts_region_list *regions, const roberts_region *r, output *out)
{
    output_text(out, "\"MULTIPOLYGON (");
    for (size_t i = 0; i < r->ring_count; i++) {
        const bool piece = i == 0 || is_piece(regions, r->first_ring + i);
        if (i > 0)
            output_text(out, piece ? ")," : ",");
        if (piece)
            output_text(out, "(");
        write_text_ring(regions, r->first_ring + i, out);
    }
    output_text(out, "))\"\n");
}

static void write_csv_number(double value, output *out)
{
    output_text(out, ",");
    output_number(out, value);
}

void region_table_write_csv(const roberts_region_list *regions, output *out)
{
    output_text(out, "body,face,area,z0,z1,color,polygon\n");
    for (size_t i = 0; i < regions->count; i++) {
        const roberts_region *r = &regions->region[i];
        output_integer(out, r->solid);
        output_text(out, ",");
        if (r->face != ROBERTS_NONE)
            output_integer(out, r->face);
        write_csv_number(r->area, out);
        write_csv_number(r->z_min, out);
        write_csv_number(r->z_max, out);
        for (int k = 0; k < r->color.count; k++) {
            output_text(out, k == 0 ? "," : " ");
            write_tint(r->color.value[k], out);
        }
        output_text(out, r->color.count ? "," : ",,");
        write_polygon(regions, r, out);
    }
}

/* ---- segments ---------------------------------------------------------------------------------------------------- */

/* The columns: first those that each table has, then those of roberts_column. */
enum {
    BODY,
    V0,
    V1,
    T0,
    T1,
    STATE,
    X0,
    Y0,
    X1,
    Y1,
    BY,
    CLASS,
    F0,
    F1,
    USUAL, /* every table has these */
    END_X0 = USUAL,
    END_Y0,
    END_Z0,
    END_X1,
    END_Y1,
    END_Z1,
    DEPTH0,
    DEPTH1,
    LEVEL,
    NAME,
    BY_NAME,
    COLUMNS
};

static const char *const names[COLUMNS] = {
    [BODY] = "body",   [V0] = "v0",       [V1] = "v1",       [T0] = "t0",     [T1] = "t1",
    [STATE] = "state", [X0] = "x0",       [Y0] = "y0",       [X1] = "x1",     [Y1] = "y1",
    [BY] = "by",       [CLASS] = "class", [F0] = "f0",       [F1] = "f1",     [END_X0] = "X0",
    [END_Y0] = "Y0",   [END_Z0] = "Z0",   [END_X1] = "X1",   [END_Y1] = "Y1", [END_Z1] = "Z1",
    [DEPTH0] = "z0",   [DEPTH1] = "z1",   [LEVEL] = "level", [NAME] = "name", [BY_NAME] = "by_name",
};

/* What a field may hold. */
typedef enum field_kind { WHOLE, NUMBER, WORD, TEXT } field_kind;

static const field_kind kinds[COLUMNS] = {
    [BODY] = WHOLE,    [V0] = WHOLE,      [V1] = WHOLE,      [T0] = NUMBER,     [T1] = NUMBER,
    [STATE] = WORD,    [X0] = NUMBER,     [Y0] = NUMBER,     [X1] = NUMBER,     [Y1] = NUMBER,
    [BY] = WHOLE,      [CLASS] = WORD,    [F0] = WHOLE,      [F1] = WHOLE,      [END_X0] = NUMBER,
    [END_Y0] = NUMBER, [END_Z0] = NUMBER, [END_X1] = NUMBER, [END_Y1] = NUMBER, [END_Z1] = NUMBER,
    [DEPTH0] = NUMBER, [DEPTH1] = NUMBER, [LEVEL] = WHOLE,   [NAME] = TEXT,     [BY_NAME] = TEXT,
};

/* The columns of each roberts_column. */
static const struct {
    uint8_t first, end;
} further[ROBERTS_COLUMNS] = {
    [ROBERTS_COLUMN_ENDS] = {END_X0, END_Z1 + 1}, [ROBERTS_COLUMN_DEPTH] = {DEPTH0, DEPTH1 + 1},
    [ROBERTS_COLUMN_LEVEL] = {LEVEL, LEVEL + 1},  [ROBERTS_COLUMN_NAME] = {NAME, NAME + 1},
    [ROBERTS_COLUMN_BY] = {BY_NAME, BY_NAME + 1},
};

/* A table: its columns, from left to right, after that of the view. */
typedef struct table {
    const roberts_drawing *drawing;
    const char *view;           /* or NULL */
    const roberts_scene *scene; /* or NULL */
    uint8_t column[COLUMNS];
    int count;
    bool wants_ends;
} table;

static table table_of(const table_view *view, const roberts_draw_options *options)
{
    table t = {.drawing = view->drawing, .view = view->name, .scene = options->scene};
    for (; t.count < USUAL; t.count++)
        t.column[t.count] = (uint8_t)t.count;
    for (size_t k = 0; k < options->column_count; k++) {
        for (uint8_t i = further[options->column[k]].first; i < further[options->column[k]].end; i++)
            t.column[t.count++] = i;
        t.wants_ends = t.wants_ends || options->column[k] == ROBERTS_COLUMN_ENDS;
    }
    return t;
}

/* ---- rows ---- */

/* A row: a segment, and its data from the scene. */
typedef struct row {
    const table *of;
    const roberts_segment *s;
    uint32_t face[2];
    bool has_ends;
    roberts_vec3 end[2];
} row;

static row table_row(const table *t, const roberts_segment *s)
{
    row r = {t, s, {ROBERTS_NONE, ROBERTS_NONE}, false, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}};
    roberts_segment_faces(t->scene, t->drawing, s, r.face);
    r.has_ends = t->wants_ends && roberts_segment_ends(t->scene, t->drawing, s, r.end);
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

/* An edge at the back of its solid is a crease, if its faces lie on both sides of it. */
static const char *class_name(uint8_t line)
{
    switch (line) {
    case ROBERTS_OUTLINE:
    case ROBERTS_BACK_OUTLINE:
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

/* ROBERTS_NONE: the field is empty. */
static uint32_t whole_number(const row *r, int column)
{
    switch (column) {
    case BODY:
        return r->s->solid;
    case V0:
        return r->s->v0;
    case V1:
        return r->s->v1;
    case BY:
        return r->s->by;
    case LEVEL:
        return r->s->level;
    default:
        return r->face[column - F0];
    }
}

static double number(const row *r, int column)
{
    const roberts_segment *s = r->s;
    const double usual[] = {s->t0, s->t1, 0.0 /* no number: the state */, s->p0.x, s->p0.y, s->p1.x, s->p1.y};
    const roberts_vec3 a = r->end[0], b = r->end[1];
    const double rest[] = {a.x, a.y, a.z, b.x, b.y, b.z, s->z0, s->z1};
    if (column >= END_X0)
        return rest[column - END_X0];
    return column <= Y1 ? usual[column - T0] : 0.0;
}

static const char *word(const row *r, int column)
{
    return column == STATE ? state_name(r->s->state) : class_name(r->s->line);
}

/* "": there is none. */
static const char *name(const row *r, int column)
{
    const uint32_t body = column == NAME ? r->s->solid : r->s->by;
    return r->of->scene && body != ROBERTS_NONE ? roberts_scene_name(r->of->scene, body) : "";
}

/* Writes a field that is no text; `empty` where it holds nothing. */
static void write_field(const row *r, int column, const char *empty, output *out)
{
    uint32_t whole;
    switch (kinds[column]) {
    case WHOLE:
        whole = whole_number(r, column);
        if (whole == ROBERTS_NONE && column != BODY)
            output_text(out, empty);
        else
            output_integer(out, whole);
        break;
    case NUMBER:
        if (column >= END_X0 && column <= END_Z1 && !r->has_ends)
            output_text(out, empty);
        else
            output_number(out, number(r, column));
        break;
    default:
        output_text(out, word(r, column));
    }
}

static bool is_listed(const roberts_segment *s, bool with_hidden)
{
    return s->state == ROBERTS_VISIBLE || with_hidden;
}

/* ---- CSV ---- */

/* With quotes where commas, quotes or line ends need them (RFC 4180). The bytes are those of the input. */
static void write_csv_text(const char *text, output *out)
{
    if (!strpbrk(text, ",\"\r\n")) {
        output_text(out, text);
        return;
    }
    output_bytes(out, "\"", 1);
    for (; *text; text++)
        output_bytes(out, *text == '"' ? "\"\"" : text, *text == '"' ? 2 : 1);
    output_bytes(out, "\"", 1);
}

static void write_csv_row(const row *r, output *out)
{
    if (r->of->view) {
        output_text(out, r->of->view);
        output_text(out, ",");
    }
    for (int i = 0; i < r->of->count; i++) {
        int column = r->of->column[i];
        if (i)
            output_bytes(out, ",", 1);
        if (kinds[column] == TEXT)
            write_csv_text(name(r, column), out);
        else
            write_field(r, column, "", out);
    }
    output_bytes(out, "\n", 1);
}

static void write_csv_head(const table *t, output *out)
{
    output_text(out, t->view ? "view," : "");
    for (int i = 0; i < t->count; i++) {
        output_text(out, i ? "," : "");
        output_text(out, names[t->column[i]]);
    }
    output_bytes(out, "\n", 1);
}

void table_write_csv(const table_view *view, size_t count, const roberts_draw_options *options, output *out)
{
    for (size_t v = 0; v < count; v++) {
        const table t = table_of(&view[v], options);
        if (v == 0)
            write_csv_head(&t, out);
        for (size_t n = 0; n < t.drawing->count; n++)
            if (is_listed(&t.drawing->segment[n], options->hidden != ROBERTS_HIDDEN_NONE)) {
                const row r = table_row(&t, &t.drawing->segment[n]);
                write_csv_row(&r, out);
            }
    }
}

/* ---- JSON ---- */

/* As a string of JSON (RFC 8259); null where there is none. A byte that belongs to no character of UTF-8 becomes
 * U+FFFD. */
static void write_json_text(const char *text, output *out)
{
    static const char hex[] = "0123456789abcdef";
    if (!*text) {
        output_text(out, "null");
        return;
    }
    output_bytes(out, "\"", 1);
    while (*text) {
        size_t length = output_character(text);
        if (*text == '"' || *text == '\\') {
            output_bytes(out, "\\", 1);
            output_bytes(out, text, 1);
        } else if ((unsigned char)*text < 0x20) {
            output_text(out, *text < 0x10 ? "\\u000" : "\\u001");
            output_bytes(out, &hex[*text & 15], 1);
        } else if (length) {
            output_bytes(out, text, length);
        } else {
            output_text(out, "\\ufffd");
        }
        text += length ? length : 1;
    }
    output_bytes(out, "\"", 1);
}

static void write_json_member(const row *r, int i, output *out)
{
    int column = r->of->column[i];
    bool is_word = kinds[column] == WORD;
    output_text(out, i ? ",\"" : "\"");
    output_text(out, names[column]);
    output_text(out, is_word ? "\":\"" : "\":");
    if (kinds[column] == TEXT)
        write_json_text(name(r, column), out);
    else
        write_field(r, column, "null", out);
    if (is_word)
        output_bytes(out, "\"", 1);
}

static void write_json_row(const row *r, output *out)
{
    if (r->of->view) {
        output_text(out, "\"view\":\"");
        output_text(out, r->of->view);
        output_text(out, "\",");
    }
    for (int i = 0; i < r->of->count; i++)
        write_json_member(r, i, out);
}

void table_write_json(const table_view *view, size_t count, const roberts_draw_options *options, output *out)
{
    bool first = true;
    output_text(out, "[");
    for (size_t v = 0; v < count; v++) {
        const table t = table_of(&view[v], options);
        for (size_t n = 0; n < t.drawing->count; n++) {
            if (!is_listed(&t.drawing->segment[n], options->hidden != ROBERTS_HIDDEN_NONE))
                continue;
            output_text(out, first ? "\n{" : ",\n{");
            first = false;
            const row r = table_row(&t, &t.drawing->segment[n]);
            write_json_row(&r, out);
            output_text(out, "}");
        }
    }
    output_text(out, first ? "]\n" : "\n]\n");
}
