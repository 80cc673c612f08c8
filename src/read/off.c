/* off.c - reading OFF: header, then text or words, then what there is to warn of. A mesh stays as it was where anything
 * fails. */
#include "read/off.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- errors ------------------------------------------------------------------------------------------------------ */

roberts_status off_fail(off_reader *r, roberts_status status, const char *format, ...)
{
    char message[sizeof r->error->message];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    return error_set(r->error, status, r->header.binary ? 0 : r->in.line, "%s", message);
}

static roberts_status fail_reading(off_reader *r)
{
    char reason[128];
    if (strerror_r(r->in.failure, reason, sizeof reason) != 0)
        snprintf(reason, sizeof reason, "error %d", r->in.failure);
    return error_set(r->error, ROBERTS_IO, 0, "reading failed: %s", reason);
}

/* The token for a message: shortened, and without characters that would disturb a terminal. */
static void quote(const char *token, size_t length, char *text, size_t room)
{
    size_t shown = length < 24 ? length : 24, n = 0;
    for (size_t i = 0; i < shown && n + 5 < room; i++) {
        unsigned char c = (unsigned char)token[i];
        if (c > ' ' && c < 0x7f)
            text[n++] = (char)c;
        else
            n += (size_t)snprintf(text + n, room - n, "\\x%02x", c);
    }
    snprintf(text + n, room - n, "%s", shown < length ? "..." : "");
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
    char wanted[120], found[112];
    size_t length = input_token(&r->in);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(wanted, sizeof wanted, format, arguments);
    va_end(arguments);
    if (r->in.failure)
        return fail_reading(r);
    if (r->in.too_blank)
        return off_fail(r, ROBERTS_BAD_SYNTAX, "%s expected, but nothing but blanks and comments follows", wanted);
    if (length == 0)
        return off_fail(r, ROBERTS_BAD_SYNTAX, "%s expected, but the input ends here", wanted);
    if (length > INPUT_TOKEN_MAX)
        return off_fail(r, ROBERTS_BAD_SYNTAX, "%s expected, found a word of more than %zu characters", wanted,
                        INPUT_TOKEN_MAX);
    quote(r->in.at, length, found, sizeof found);
    return off_fail(r, status, "%s expected, found \"%s\"%s", wanted, found, explain_word(status, r->in.at, length));
}

void off_warn_fewer(off_reader *r, uint64_t found)
{
    warning_send(r->warnings, r->name, 0, "%llu faces declared, but there are %llu",
                 (unsigned long long)r->header.faces, (unsigned long long)found);
}

/* ---- numbers ----------------------------------------------------------------------------------------------------- */

bool off_number_slowly(off_reader *r, double *value)
{
    size_t length = input_token(&r->in);
    if (length > INPUT_TOKEN_MAX || number_parse(r->in.at, value) != r->in.at + length)
        return false;
    r->in.at += length;
    return true;
}

bool off_integer(off_reader *r, uint64_t *value)
{
    size_t length = input_token(&r->in);
    if (length > INPUT_TOKEN_MAX || number_integer(r->in.at, value) != r->in.at + length)
        return false;
    r->in.at += length;
    return true;
}

/* ---- colours ----------------------------------------------------------------------------------------------------- */

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

/* ---- the whole file ---------------------------------------------------------------------------------------------- */

/* Warns of what was left out. */
static void warn(off_reader *r)
{
    if (r->thin_faces)
        warning_send(r->warnings, r->name, 0, "%zu face%s with fewer than 3 corners ignored", r->thin_faces,
                     r->thin_faces == 1 ? "" : "s");
    if (r->odd_colors)
        warning_send(r->warnings, r->name, r->first_odd_color, "%zu colour%s that make%s no sense ignored",
                     r->odd_colors, r->odd_colors == 1 ? "" : "s", r->odd_colors == 1 ? "s" : "");
}

static roberts_status read_all(off_reader *r)
{
    roberts_status status = off_read_header(r);
    if (status != ROBERTS_OK)
        return status;
    if (!mesh_source(r->mesh, r->name))
        return error_no_memory(r->error);
    status = r->header.binary ? off_read_binary(r) : off_read_text(r);
    if (status != ROBERTS_OK)
        return status;
    bool faces_missing = r->mesh->face_count - r->mark.faces < r->header.faces;
    if (!mesh_color_rest(r->mesh, r->vertices_filled, r->faces_filled))
        return error_no_memory(r->error);
    warn(r);
    if (r->thin_faces || r->odd_colors || faces_missing)
        off_explain_warning(r);
    return ROBERTS_OK;
}

roberts_status off_read(roberts_mesh *mesh, const char *name, const input_source *source,
                        const struct off_division *division, const roberts_warnings *warnings, roberts_error *error)
{
    roberts_status status = ROBERTS_NO_MEMORY;
    off_reader r = {.mesh = mesh,
                    .mark = mesh_here(mesh),
                    .name = name,
                    .warnings = warnings,
                    .error = error,
                    .division = division,
                    .vertices_filled = mesh->vertex_color ? mesh->vertex_count : 0,
                    .faces_filled = mesh->face_color ? mesh->face_count : 0};
    error_set_file(error, name);
    if (!input_open(&r.in, source))
        error_no_memory(error);
    else
        status = read_all(&r);
    if (status == ROBERTS_BAD_SYNTAX || status == ROBERTS_BAD_INDEX)
        off_explain_error(&r);
    input_close(&r.in);
    if (status != ROBERTS_OK)
        mesh_back(mesh, r.mark);
    return status;
}
