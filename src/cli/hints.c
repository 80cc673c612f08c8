/* hints.c - what was meant, or what can be done: the second half of a message. */
#include "cli/hints.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "cli/message.h"

enum { LONGEST = 32, FAR = LONGEST * 2 };

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* "ISO" means iso: what is near is so in any case of letters. */
static bool same(char a, char b)
{
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/* The edit distance of two words: letters left out, added or wrong, and pairs that changed places.
 * Source: the restricted form of Damerau, "A technique for computer detection and correction of spelling errors",
 * CACM 7(3), 1964. */
static size_t distance(const char *a, const char *b)
{
    size_t n = strlen(a), m = strlen(b);
    size_t row[3][LONGEST + 1]; /* of the table: two rows ago, the last, this one */
    if (n > LONGEST || m > LONGEST)
        return FAR;
    for (size_t j = 0; j <= m; j++)
        row[1][j] = row[0][j] = j;
    for (size_t i = 1; i <= n; i++) {
        row[2][0] = i;
        for (size_t j = 1; j <= m; j++) {
            size_t change = row[1][j - 1] + !same(a[i - 1], b[j - 1]);
            row[2][j] = least(change, least(row[1][j], row[2][j - 1]) + 1);
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
                row[2][j] = least(row[2][j], row[0][j - 2] + 1);
        }
        memmove(row[0], row[1], 2 * sizeof row[0]);
    }
    return row[1][m];
}

const char *hint_word(const char *word, const char *const *words)
{
    const char *best = NULL;
    size_t length = strlen(word), best_distance = FAR;
    for (size_t i = 0; words[i]; i++) {
        /* The beginning of a word means that word, and "isometric" means iso; of other words a third of the letters may
         * be wrong, of two letters none. */
        size_t shorter = least(length, strlen(words[i]));
        bool begins = shorter >= 2 && strncmp(words[i], word, shorter) == 0;
        size_t d = begins ? 0 : distance(word, words[i]);
        if (d < best_distance && (begins || (shorter > 2 && 3 * d <= shorter + 1))) {
            best = words[i];
            best_distance = d;
        }
    }
    return best;
}

const char *hint_option(const char *word)
{
    static const struct {
        const char *word, *option;
    } known[] = {
        {"angle", "fov"},
        {"border", "frame"},
        {"camera", "eye"},
        {"check", "verify"},
        {"color", "style outline:color=NAME"},
        {"colour", "style outline:color=NAME"},
        {"convex", "hull"},
        {"dashed", "hidden dashed"},
        {"debug", "stats"},
        {"direction", "dir"},
        {"height", "page WxH"},
        {"isometric", "view iso"},
        {"jobs", "threads"},
        {"line-width", "style outline:width=MM"},
        {"linewidth", "style outline:width=MM"},
        {"optimize", "order"},
        {"paper", "page"},
        {"pen", "style outline:width=MM"},
        {"perspective", "eye"},
        {"portrait", "page"},
        {"position", "eye"},
        {"projection", "view"},
        {"resolution", "dpi"},
        {"rotate", "azimuth"},
        {"silent", "quiet"},
        {"size", "page"},
        {"stroke-width", "style outline:width=MM"},
        {"target", "look-at"},
        {"type", "format"},
        {"units", "unit"},
        {"viewpoint", "eye"},
        {"width", "style outline:width=MM"},
        {"wireframe", "hidden solid"},
        {"zoom", "scale"},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (strcmp(word, known[i].word) == 0)
            return known[i].option;
    return NULL;
}

int hint_unknown(const char *what, const char *word, const char *const *words, const char *also)
{
    const char *meant = hint_word(word, words);
    char list[256] = ""; /* more than all names of any option */
    for (size_t i = 0, used = 0; words[i] && used < sizeof list; i++)
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", words[i]);
    if (meant)
        return message_misuse("%s: \"%s\" is unknown; did you mean %s? It can be %s%s%s", what, word, meant, list,
                              also ? ", " : "", also ? also : "");
    return message_misuse("%s: \"%s\" is unknown; it can be %s%s%s", what, word, list, also ? ", " : "",
                          also ? also : "");
}
