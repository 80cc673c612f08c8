/* zones.c - centring marks and zones of a frame after ISO 5457: fields of 50 mm, counted from the middle of each side,
 * with letters from top to bottom and numbers from left to right. */
#include <math.h>

#include "draw/title_block.h"

/* mm */
static const double field_mm = 50.0, strip_mm = 5.0, mark_mm = 5.0, letter_mm = 2.5;

/* Where field `i` of a side of this length ends, from its start; the outer fields take what is left. */
static double field_end(double length, int fields, int i)
{
    return i + 1 == fields ? length : length / 2.0 + (i + 1 - fields / 2) * field_mm;
}

/* Fields on a side: an even number, so that the middle is between two. */
static int count_fields(double length)
{
    const int half = (int)ceil(length / 2.0 / field_mm - 0.5);
    return 2 * (half < 1 ? 1 : half > 12 ? 12 : half);
}

static bool add_side(strokes *s, bool is_level)
{
    static const char letters[] = "ABCDEFGHJKLMNPQRSTUVWXYZ"; /* without I and O */
    const roberts_vec2 low = s->frame_mm[0], high = s->frame_mm[1];
    const double start = is_level ? low.x : low.y, length = (is_level ? high.x : high.y) - start;
    const int fields = count_fields(length);
    double begin = 0.0;
    bool done = true;
    for (int i = 0; i < fields && done; i++) {
        const double end = field_end(length, fields, i), middle = start + (begin + end) / 2.0, at = start + end;
        const char text[] = {is_level ? (char)('0' + (i + 1) / 10) : letters[i], (char)('0' + (i + 1) % 10), '\0'};
        const char name[] = {text[0], '\0'};
        const char *shown = is_level ? (i + 1 < 10 ? text + 1 : text) : name;
        for (int side = 0; side < 2 && done; side++) {
            const double edge = is_level ? (side ? high.y : low.y) : (side ? high.x : low.x), out = side ? 1.0 : -1.0;
            const bool is_centre = i + 1 == fields / 2;
            const double off = edge + out * strip_mm / 2.0, far = edge + out * strip_mm,
                         near = is_centre ? edge - out * mark_mm : edge;
            const text_line line = {shown,
                                    is_level ? (roberts_vec2){middle, off + letter_mm / 2.0}
                                             : (roberts_vec2){off, middle + letter_mm / 2.0},
                                    letter_mm, 0.5, TEXT_LEVEL};
            done = notes_add_text(&s->notes, &line, false);
            if (done && i + 1 < fields)
                done = notes_add_line(&s->notes, is_level ? (roberts_vec2){at, far} : (roberts_vec2){far, at},
                                      is_level ? (roberts_vec2){at, near} : (roberts_vec2){near, at}, s->units_per_mm);
        }
        begin = end;
    }
    return done;
}

bool zones_add(strokes *s)
{
    return !s->options->lettering.zones || s->options->frame.off || (add_side(s, true) && add_side(s, false));
}
