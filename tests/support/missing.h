/* missing.h - tables of texts, and how many of their characters something lacks. */
#ifndef ROBERTS_TESTS_MISSING_H
#define ROBERTS_TESTS_MISSING_H

#include "testing.h"

typedef struct missing_case {
    const char *text;
    size_t missing;
    uint32_t first; /* the first of them; MISSING_NOTHING: there is none */
} missing_case;

#define MISSING_NOTHING 7u /* no case has this control character */

/* missing: counts, and stores the first one, unless there is none. */
static inline void expect_missing(size_t (*missing)(const char *, uint32_t *), const missing_case *cases, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t first = MISSING_NOTHING;
        const size_t found = missing(cases[i].text, &first);
        if (found != cases[i].missing || first != cases[i].first)
            fail_msg("case %zu, \"%s\": %zu missing, the first U+%04X", i, cases[i].text, found, (unsigned)first);
    }
}

#endif
