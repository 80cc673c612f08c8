/* off.c - the reader of OFF: header, then text or binary words, then warnings. After an error, the mesh is
 * unchanged. */
#include "read/off.h"

#include <math.h>
#include <string.h>

/* ---- errors ---------------------------------------------------------------------------------------------------- */

/* Explains commas to a user who writes 0,5 or separates numbers by commas. */
static const char *explain_commas(const char *token, size_t length)
{
    const bool number = strchr("+-.0123456789", token[0]) != NULL;
    return number && (memchr(token, ',', length) || memchr(token, ';', length))
               ? "; OFF has decimal points, and blanks between numbers"
               : "";
}

/* Is this a number like -3 where only integers from 0 on are allowed? (Elsewhere negative numbers are valid.) */
static bool is_negative(const char *token, size_t length)
{
    bool digits = length > 1 && token[0] == '-', zero = true;
    for (size_t i = 1; i < length && digits; i++) {
        digits = token[i] >= '0' && token[i] <= '9';
        zero = zero && token[i] == '0';
    }
    return digits && !zero;
}

const char *off_explain_word(const char *token, size_t length)
{
    return is_negative(token, length) ? ", which is negative" : explain_commas(token, length);
}

void off_warn_fewer(reader *r, uint64_t found)
{
    warning_send(r->warnings, r->name, 0, "%llu faces declared, but there are %llu",
                 (unsigned long long)r->off->header.faces, (unsigned long long)found);
}

/* ---- colours --------------------------------------------------------------------------------------------------- */

/* Three or four integers are 0..255. Other numbers are 0..1, unless one of them is greater than 1, as in "255.0 0.0
 * 0.0": then they are 0..255 too (Geomview's rule). A single integer is an index into a colour map. */
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

static roberts_status count_odd_color(reader *r)
{
    if (r->off->odd_colors++ == 0)
        r->off->first_odd_color = r->in.line;
    return ROBERTS_OK;
}

roberts_status off_color_vertex(reader *r, const off_color_numbers *numbers)
{
    roberts_color color;
    if (!make_color(numbers, &color))
        return count_odd_color(r);
    if (!mesh_color_vertex(r->mesh, r->mesh->vertex_count - 1, color, &r->vertices_filled))
        return error_no_memory(r->error);
    return ROBERTS_OK;
}

roberts_status off_color_face(reader *r, const off_color_numbers *numbers)
{
    roberts_color color;
    if (!make_color(numbers, &color))
        return count_odd_color(r);
    if (!mesh_color_face(r->mesh, r->mesh->face_count - 1, color, &r->faces_filled))
        return error_no_memory(r->error);
    return ROBERTS_OK;
}

/* ---- the whole file -------------------------------------------------------------------------------------------- */

/* Counts faces without corners. Elements of one corner or two are points and lines, which OFF may hold as well. */
static size_t count_empty(const reader *r)
{
    const roberts_mesh *mesh = r->mesh;
    size_t count = 0;
    for (size_t f = r->mark.faces; r->thin_faces > 0 && f < mesh->face_count; f++)
        count += mesh->face_start[f] == mesh->face_start[f + 1];
    return count;
}

/* Warns of anything left out. */
static void warn_of_left_out(reader *r)
{
    const size_t empty = count_empty(r);
    if (empty > 0)
        warning_send(r->warnings, r->name, 0, "%zu face%s without corners", empty, empty == 1 ? "" : "s");
    read_warn_colors(r->warnings, r->name, r->off->first_odd_color, r->off->odd_colors);
}

static roberts_status read_all(reader *r)
{
    roberts_status status = off_read_header(r);
    if (status != ROBERTS_OK)
        return status;
    status = r->off->header.binary ? off_read_binary(r) : off_read_text(r);
    if (status != ROBERTS_OK)
        return status;
    warn_of_left_out(r);
    if (r->thin_faces || r->off->odd_colors || r->mesh->face_count - r->mark.faces < r->off->header.faces)
        off_explain_warning(r);
    r->thin_faces = 0; /* so that no other code warns of them */
    return ROBERTS_OK;
}

roberts_status off_read(reader *r, const off_division *division)
{
    off_state state = {.division = division};
    r->off = &state;
    roberts_status status = read_all(r);
    if (status == ROBERTS_BAD_SYNTAX || status == ROBERTS_BAD_INDEX)
        off_explain_error(r);
    r->off = NULL;
    return status;
}
