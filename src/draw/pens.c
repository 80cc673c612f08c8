/* pens.c - see pens.h. */
#include "draw/pens.h"

#include <math.h>

const roberts_pen *pens_of(const roberts_draw_options *options, roberts_line line)
{
    switch ((int)line) {
    case ROBERTS_OUTLINE:
        return &options->outline;
    case ROBERTS_CREASE:
        return &options->crease;
    case ROBERTS_BORDER:
        return &options->border;
    case ROBERTS_INTERSECTION:
        return &options->intersection;
    case ROBERTS_WIRE:
        return &options->wire;
    case LINE_FRAME:
        return &options->frame;
    case LINE_SYMBOL:
        return &options->symbol;
    case LINE_HATCH:
        return &options->hatch;
    case LINE_TEXT:
        return &options->text;
    case LINE_HIDDEN_TEXT:
        return &options->hidden_text;
    default:
        return &options->back;
    }
}

const char *pens_class_name(roberts_line line)
{
    static const char *const name[] = {
        [ROBERTS_OUTLINE] = "outline", [ROBERTS_CREASE] = "crease",       [ROBERTS_BACK] = "hidden",
        [ROBERTS_BORDER] = "border",   [ROBERTS_WIRE] = "wire",           [ROBERTS_INTERSECTION] = "intersection",
        [LINE_FRAME] = "frame",        [LINE_SYMBOL] = "symbol",          [LINE_HATCH] = "hatch",
        [LINE_TEXT] = "text",          [LINE_HIDDEN_TEXT] = "hidden-text"};
    return name[line];
}

uint32_t pens_class_number(const roberts_draw_options *options, roberts_line line)
{
    static const uint8_t number[] = {
        [ROBERTS_BACK] = 1,   [ROBERTS_WIRE] = 2,    [ROBERTS_INTERSECTION] = 3, [ROBERTS_CREASE] = 4,
        [ROBERTS_BORDER] = 5, [ROBERTS_OUTLINE] = 6, [LINE_FRAME] = 7,           [LINE_SYMBOL] = 8,
        [LINE_HATCH] = 9,     [LINE_TEXT] = 10,      [LINE_HIDDEN_TEXT] = 11};
    const uint8_t own = pens_of(options, line)->number;
    return own ? own : number[line];
}

bool pens_is_broken(const roberts_draw_options *options, roberts_line line)
{
    return pens_of(options, line)->dash_mm > 0.0 && !(line == ROBERTS_BACK && options->hidden == ROBERTS_HIDDEN_SOLID);
}

bool pens_dash(const roberts_draw_options *options, roberts_line line, double dash[2])
{
    const roberts_pen *pen = pens_of(options, line);
    dash[0] = fmax(pen->dash_mm - pen->width_mm, 0.0);
    dash[1] = pen->gap_mm + pen->width_mm;
    return pens_is_broken(options, line) && !options->real_dashes;
}

bool pens_has_place(const roberts_draw_options *options, roberts_line line)
{
    return !(line == ROBERTS_BACK && options->hidden == ROBERTS_HIDDEN_NONE) &&
           (line != LINE_HATCH || options->hatching.on);
}
