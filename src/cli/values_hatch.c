/* values_hatch.c - the value of --hatch: KEY=VALUE,... */
#include <string.h>

#include "cli/hints.h"
#include "cli/message.h"
#include "cli/parse.h"
#include "cli/values.h"

enum { KEY_SPACING, KEY_LEVELS, KEY_ANGLE, KEY_DIRECTION, KEY_CROSS, KEY_LINES, KEY_OFF, KEY_ON };

const char *const values_hatch_keys[] = {"spacing", "levels", "angle", "direction", "cross",
                                         "lines",   "off",    "on",    NULL};

static const double shortest_mm = 0.01, longest_mm = 1000.0;
enum { LEVELS_MOST = 1000, ANGLE_MOST = 360 };

/* Without an angle, only strokes along the picture are turned, by 45 degrees; so this is decided at the end. */
static int set_key(roberts_hatching *h, const char *item, bool *turned)
{
    static const char *const directions[] = {"picture", "steep", "across", NULL};
    static const roberts_hatch_along along[] = {ROBERTS_HATCH_PICTURE, ROBERTS_HATCH_STEEP, ROBERTS_HATCH_ACROSS};
    static const char *const lines[] = {"even", "nested", NULL};
    char key[64];
    bool fits;
    const char *value = parse_word(item, '=', key, sizeof key, &fits);
    const size_t i = parse_find(key, values_hatch_keys);
    if (!values_hatch_keys[i])
        return hint_unknown("--hatch", key, values_hatch_keys, "as in spacing=0.8,angle=45");
    if ((i < KEY_OFF) != (value != NULL))
        return message_misuse("--hatch: %s %s", key, i < KEY_OFF ? "needs a value" : "takes no value");
    h->on = i != KEY_OFF;
    switch (i) {
    case KEY_SPACING:
        if (parse_length(value, &h->spacing_mm) && h->spacing_mm >= shortest_mm && h->spacing_mm <= longest_mm)
            return EXIT_DONE;
        return message_misuse("--hatch: spacing=%s is not a length from %g to %g mm", value, shortest_mm, longest_mm);
    case KEY_LEVELS:
        if (parse_integer(value, &h->levels) && h->levels <= LEVELS_MOST)
            return EXIT_DONE;
        return message_misuse("--hatch: levels=%s is not a whole number from 0 to %d", value, LEVELS_MOST);
    case KEY_ANGLE:
        *turned = true;
        if (parse_number(value, &h->degrees) && h->degrees >= -ANGLE_MOST && h->degrees <= ANGLE_MOST)
            return EXIT_DONE;
        return message_misuse("--hatch: angle=%s is not a number of degrees from -%d to %d", value, ANGLE_MOST,
                              ANGLE_MOST);
    case KEY_CROSS:
        h->cross = 1.0;
        if (strcmp(value, "none") == 0 || (parse_number(value, &h->cross) && h->cross >= 0.0 && h->cross <= 1.0))
            return EXIT_DONE;
        return message_misuse("--hatch: cross=%s is neither none nor a number from 0 to 1", value);
    case KEY_LINES:
        if (!lines[parse_find(value, lines)])
            return hint_unknown("--hatch: lines", value, lines, NULL);
        h->nested = parse_find(value, lines) == 1;
        return EXIT_DONE;
    case KEY_DIRECTION:
        if (!directions[parse_find(value, directions)])
            return hint_unknown("--hatch: direction", value, directions, NULL);
        h->along = along[parse_find(value, directions)];
        return EXIT_DONE;
    default:
        return EXIT_DONE;
    }
}

int values_set_hatch(const option *o, const char *value, cli_options *options)
{
    roberts_hatching *h = &options->draw.hatching;
    char word[64];
    bool fits, turned = false;
    int status = EXIT_DONE;
    (void)o;
    *h = roberts_draw_options_default().hatching;
    while (value && status == EXIT_DONE) {
        value = parse_word(value, ',', word, sizeof word, &fits);
        status = fits ? set_key(h, word, &turned) : message_misuse("--hatch: \"%s...\" is too long", word);
    }
    if (!turned && h->along != ROBERTS_HATCH_PICTURE)
        h->degrees = 0.0;
    return status;
}
