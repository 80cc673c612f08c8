/* off.c - the reader of OFF: header, then text or binary words, then warnings. If anything fails, the mesh stays as it
 * was. */
#include "read/off.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- errors ---------------------------------------------------------------------------------------------------- */

roberts_status off_fail(off_reader *r, roberts_status status, const char *format, ...)
{
    char message[sizeof r->error->message];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    return error_set(r->error, status, r->header.binary ? 0 : r->in.line, "%s", message);
}

/* For somebody who writes 0,5 or separates numbers by commas. */
static const char *explain_commas(const char *token, size_t length)
{
    const bool number = strchr("+-.0123456789", token[0]) != NULL;
    return number && (memchr(token, ',', length) || memchr(token, ';', length))
               ? "; OFF has decimal points, and blanks between numbers"
               : "";
}

/* -3, where only whole numbers from 0 on are allowed. (Elsewhere negative numbers are read.) */
static bool is_negative(const char *token, size_t length)
{
    bool digits = length > 1 && token[0] == '-', zero = true;
    for (size_t i = 1; i < length && digits; i++) {
        digits = token[i] >= '0' && token[i] <= '9';
        zero = zero && token[i] == '0';
    }
    return digits && !zero;
}

static const char *explain_word(roberts_status status, const char *token, size_t length)
{
    if (status == ROBERTS_BAD_NUMBER)
        return "; it must be a finite number";
    return is_negative(token, length) ? ", which is negative" : explain_commas(token, length);
}

roberts_status off_expected(off_reader *r, roberts_status status, const char *format, ...)
{
    char wanted[120];
    size_t length = input_token(&r->in);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(wanted, sizeof wanted, format, arguments);
    va_end(arguments);
    const char *hint = length && length <= INPUT_TOKEN_MAX ? explain_word(status, r->in.at, length) : "";
    return input_expected(&r->in, r->error, status, r->header.binary ? 0 : r->in.line, wanted, hint);
}

void off_warn_fewer(off_reader *r, uint64_t found)
{
    warning_send(r->warnings, r->name, 0, "%llu faces declared, but there are %llu",
                 (unsigned long long)r->header.faces, (unsigned long long)found);
}

/* ---- colours --------------------------------------------------------------------------------------------------- */

/* Three or four integers are 0..255. Other numbers are 0..1, unless one of them is greater than 1, as in "255.0 0.0
 * 0.0": then they are 0..255 too (Geomview's rule). One integer is an index into a colour map. */
static bool make_color(const off_color_numbers *numbers, roberts_color *color)
{
    int count = numbers->count;
    double most = numbers->real ? 1.0 : 255.0;
    if (count != 1 && count != 3 && count != 4)
        return false;
    *color = (roberts_color){.count = (unsigned char)count};
    for (int i = 0; i < count; i++) {
        double v = numbers->value[i];
        if (!(v >= 0.0) || (count == 1 ? v != floor(v) || v > UINT32_MAX : v > 255.0))
            return false;
        if (v > most)
            most = 255.0;
    }
    for (int i = 0; i < count; i++)
        color->value[i] = (float)(count == 1 ? numbers->value[i] : numbers->value[i] / most);
    return true;
}

static roberts_status count_odd_color(off_reader *r)
{
    if (r->odd_colors++ == 0)
        r->first_odd_color = r->header.binary ? 0 : r->in.line;
    return ROBERTS_OK;
}

roberts_status off_color_vertex(off_reader *r, const off_color_numbers *numbers)
{
    roberts_color color;
    if (!make_color(numbers, &color))
        return count_odd_color(r);
    if (!mesh_color_vertex(r->mesh, r->mesh->vertex_count - 1, color, &r->vertices_filled))
        return error_no_memory(r->error);
    return ROBERTS_OK;
}

roberts_status off_color_face(off_reader *r, const off_color_numbers *numbers)
{
    roberts_color color;
    if (!make_color(numbers, &color))
        return count_odd_color(r);
    if (!mesh_color_face(r->mesh, r->mesh->face_count - 1, color, &r->faces_filled))
        return error_no_memory(r->error);
    return ROBERTS_OK;
}

/* ---- the whole file -------------------------------------------------------------------------------------------- */

/* Warns of what was left out. */
static void warn(off_reader *r)
{
    read_warn_thin(r->warnings, r->name, r->thin_faces);
    if (r->odd_colors)
        warning_send(r->warnings, r->name, r->first_odd_color, "%zu colour%s that make%s no sense ignored",
                     r->odd_colors, r->odd_colors == 1 ? "" : "s", r->odd_colors == 1 ? "s" : "");
}

static roberts_status read_all(off_reader *r)
{
    roberts_status status = off_read_header(r);
    if (status != ROBERTS_OK)
        return status;
    status = r->header.binary ? off_read_binary(r) : off_read_text(r);
    if (status != ROBERTS_OK)
        return status;
    warn(r);
    if (r->thin_faces || r->odd_colors || r->mesh->face_count - r->mark.faces < r->header.faces)
        off_explain_warning(r);
    return ROBERTS_OK;
}

roberts_status off_read(reader *from, const off_division *division)
{
    off_reader r = {.in = from->in,
                    .mesh = from->mesh,
                    .mark = from->mark,
                    .name = from->name,
                    .warnings = from->warnings,
                    .error = from->error,
                    .division = division,
                    .vertices_filled = from->vertices_filled,
                    .faces_filled = from->faces_filled};
    roberts_status status = read_all(&r);
    if (status == ROBERTS_BAD_SYNTAX || status == ROBERTS_BAD_INDEX)
        off_explain_error(&r);
    from->in = r.in;
    from->vertices_filled = r.vertices_filled;
    from->faces_filled = r.faces_filled;
    return status;
}
