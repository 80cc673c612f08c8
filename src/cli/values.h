/* values.h - what the value of each option may be, and where it goes. */
#ifndef ROBERTS_CLI_VALUES_H
#define ROBERTS_CLI_VALUES_H

#include "cli/options.h"

/* Words that a value can be, ending with NULL. */
extern const char *const values_formats[];
extern const char *const values_fill_rules[];
extern const char *const values_sheets[];
extern const char *const values_hidden[];
extern const char *const values_columns[];
extern const char *const values_pages[];
extern const char *const values_scales[];
extern const char *const values_units[];
extern const char *const values_labels[];
extern const char *const values_texts[];
extern const char *const values_frames[];
extern const char *const values_fields[];
extern const char *const values_dimensions[];
extern const char *const values_places[];
extern const char *const values_backgrounds[];
extern const char *const values_fills[];
extern const char *const values_dashes[];
extern const char *const values_orders[];
extern const char *const values_layers[];
extern const char *const values_groups[];
extern const char *const values_hatch_keys[];
extern const char *const values_views[];
extern const char *const values_stats[];

/* Classes of lines, each with a pen; their names, ending with NULL. */
enum {
    PEN_OUTLINE,
    PEN_BORDER,
    PEN_CREASE,
    PEN_INTERSECTION,
    PEN_WIRE,
    PEN_HIDDEN,
    PEN_FRAME,
    PEN_SYMBOL,
    PEN_HATCH,
    PEN_TEXT,
    PEN_HIDDEN_TEXT,
    PENS
};
extern const char *const values_pens[];

/* The pen of a class. */
const roberts_pen *values_pen(const roberts_draw_options *draw, size_t pen);

/* Does the pen differ from the default in width, colour or dashes? */
bool values_pen_is_set(const roberts_draw_options *draw, size_t pen);

/* The name that -f and endings of files give to a format. */
const char *values_format_name(roberts_format format);

static inline bool values_is_table(roberts_format format)
{
    return format == ROBERTS_CSV || format == ROBERTS_JSON;
}

/* Is this one of the further columns? */
static inline bool values_has_column(const roberts_draw_options *draw, roberts_column column)
{
    for (size_t i = 0; i < draw->column_count; i++)
        if (draw->column[i] == column)
            return true;
    return false;
}

static inline bool values_has_page(roberts_format format)
{
    return !values_is_table(format) && format != ROBERTS_NULL;
}

/* For any option: the row says where the value goes (o->field) and what it may be. */
option_set values_set_flag;      /* bool */
option_set values_set_text;      /* const char *, not empty */
option_set values_set_any_text;  /* const char * */
option_set values_set_number;    /* double, from o->least to o->most */
option_set values_set_integer;   /* uint32_t, from o->least to o->most */
option_set values_set_length;    /* double in mm, from o->least to o->most; may have a unit */
option_set values_set_share;     /* roberts_share */
option_set values_set_vector;    /* roberts_vec3 */
option_set values_set_direction; /* roberts_vec3, not 0,0,0 */
option_set values_set_section;

/* For one option each. */
option_set values_add_room, values_set_format, values_set_sheet, values_set_hidden, values_set_columns,
    values_set_crease, values_set_label, values_set_text_mode, values_set_field, values_set_dimensions,
    values_set_fill_rule, values_set_page, values_set_scale, values_set_unit, values_set_align, values_set_plotter,
    values_set_frame, values_set_background, values_set_fill, values_set_style, values_set_dash, values_set_order,
    values_set_layers, values_set_group, values_set_id_prefix, values_set_hatch, values_set_view, values_set_dir,
    values_set_eye, values_set_look_at, values_set_stats, values_set_verify, values_set_pick;

/* Are strokes of hatching drawn? */
bool values_hatches(const roberts_draw_options *draw);

#endif
