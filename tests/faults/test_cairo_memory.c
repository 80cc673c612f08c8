/* test_cairo_memory.c - drawings with each of Cairo's own allocations failing in turn: a failure or a drawing, no
 * crash. Leaks inside Cairo are not checked: it keeps some blocks for later use. PNG is left out: Cairo 1.16 itself
 * crashes in cairo_stroke() if an allocation for filling an image fails. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "drawing.h"
#include "process_memory.h"
#include "testing.h"

static bool take(void *context, const void *bytes, size_t size)
{
    (void)bytes;
    *(size_t *)context += size;
    return true;
}

static roberts_status write_once(roberts_format format, size_t *written, roberts_error *error)
{
    roberts_segment segment[] = {line_at(ROBERTS_OUTLINE, 0, 0, 3, 1), line_at(ROBERTS_CREASE, 3, 1, 2, 7),
                                 line_at(ROBERTS_BACK, 2, 7, 0, 0)};
    roberts_drawing drawing = {.count = 3, .segment = segment, .window_max = {3, 7}};
    roberts_draw_options options = roberts_draw_options_default();
    segment[2].state = ROBERTS_HIDDEN;
    options.format = format;
    options.hidden = ROBERTS_HIDDEN_DASHED;
    options.dpi = 30;
    *written = 0;
    return roberts_drawing_write(&drawing, &options, take, written, error);
}

static void drawings(void **state)
{
    static const roberts_format formats[] = {ROBERTS_PDF, ROBERTS_PS, ROBERTS_EPS};
    (void)state;
    if (!REPLACED)
        SKIP_BECAUSE("allocations cannot be replaced in this build");
    for (size_t f = 0; f < sizeof formats / sizeof formats[0]; f++) {
        size_t written, refused = 0, n = 0;
        for (bool failed = true; failed;) {
            roberts_error error = {0};
            memory.calls = 0;
            memory.failing = ++n;
            roberts_status status = write_once(formats[f], &written, &error);
            failed = memory.calls >= memory.failing;
            memory.failing = 0;
            refused += status != ROBERTS_OK;
            /* PostScript: without memory for its temporary file Cairo reports an error writing it */
            if (status != ROBERTS_OK && status != ROBERTS_NO_MEMORY && status != ROBERTS_IO)
                fail_msg("allocation %zu: status %d, %s", n, status, error.message);
            assert_true(failed || (status == ROBERTS_OK && written > 100));
        }
        print_message("format %d: %zu allocations, %zu of them refused the drawing\n", formats[f], n - 1, refused);
        assert_true(n > 30 && refused > 10);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(drawings)};
    return cmocka_run_group_tests_name("cairo_memory", tests, NULL, NULL);
}
