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

/* ---- header ------------------------------------------------------------------------------------------------------ */

/* Keyword, dimension and counts, in all the forms in which they occur. The format says [ST][C][N][4][n]OFF. Prefixes
 * are accepted in any order, since MeshLab writes NCSTOFF. The keyword may be missing, in lower case (then n means N),
 * joined to the first count, or followed by BINARY. Without a keyword, a first line with a single integer is a
 * dimension (qhull). The edge count, which nothing needs, may be missing.
 *
 * A dimension followed by words ("3 rbox 50 s") begins points without faces, and only their number follows: rbox writes
 * points this way, and qhull reads them. */

/* Compares with upper-case `word`, ignoring case, independent of the locale. */
static bool same_word(const char *text, size_t length, const char *word)
{
    for (size_t i = 0; i < length; i++) {
        char c = text[i] >= 'a' && text[i] <= 'z' ? (char)(text[i] - 'a' + 'A') : text[i];
        if (word[i] == '\0' || c != word[i])
            return false;
    }
    return word[length] == '\0';
}

static bool set_once(bool *flag)
{
    bool first = !*flag;
    *flag = true;
    return first;
}

/* Returns the length of the keyword that begins the token; 0: none. */
static size_t keyword(const char *token, size_t length, off_header *h)
{
    off_header found = *h;
    size_t i = 0;
    bool good = true;
    while (good && i + 3 <= length && !same_word(token + i, 3, "OFF")) {
        if (same_word(token + i, 2, "ST") && i++ < length)
            good = set_once(&found.texture);
        else if (token[i] == 'n' && i + 4 <= length && memcmp(token + i + 1, "OFF", 3) == 0)
            good = set_once(&found.dimension);
        else if (same_word(token + i, 1, "C"))
            good = set_once(&found.color);
        else if (same_word(token + i, 1, "N"))
            good = set_once(&found.normal);
        else if (token[i] == '4')
            good = set_once(&found.homogeneous);
        else
            return 0;
        i++;
    }
    i += 3;
    if (!good || i > length || (i < length && (token[i] < '0' || token[i] > '9')))
        return 0;
    *h = found;
    return i;
}

/* Takes "{" and "{ =" repeatedly (Geomview nests objects this way). Returns the number of braces. */
static size_t open_braces(reader *r)
{
    size_t count = 0;
    for (; input_skip(&r->in) && *r->in.at == '{'; count++) {
        r->in.at++;
        if (input_skip(&r->in) && *r->in.at == '=')
            r->in.at++;
    }
    return count;
}

bool off_is_keyword(const char *word, size_t length)
{
    off_header unused = {0};
    return length <= INPUT_TOKEN_MAX && keyword(word, length, &unused) > 0;
}

bool off_at_keyword(reader *r)
{
    open_braces(r);
    const size_t length = input_token(&r->in); /* moves `at` */
    return off_is_keyword(r->in.at, length);
}

static roberts_status opening(reader *r)
{
    r->off->header.braces = open_braces(r);
    if (input_token(&r->in) == 0 && !r->in.failure && !r->in.too_blank)
        return read_fail(r, ROBERTS_BAD_SYNTAX, "the input is empty");
    return ROBERTS_OK;
}

/* Reads "BINARY" after the keyword. One line end and then the data follow. */
static roberts_status binary_word(reader *r)
{
    if (!input_skip_in_line(&r->in))
        return ROBERTS_OK;
    size_t length = input_token(&r->in); /* which moves `at` */
    if (!same_word(r->in.at, length, "BINARY"))
        return ROBERTS_OK;
    r->in.at += 6;
    while (input_need(&r->in, 1) && (*r->in.at == ' ' || *r->in.at == '\t'))
        r->in.at++;
    if (input_need(&r->in, 1) && *r->in.at == '\r')
        r->in.at++;
    if (!input_need(&r->in, 1) || *r->in.at != '\n')
        return read_expected(r, ROBERTS_BAD_SYNTAX, "the end of the line after BINARY");
    r->in.at++;
    r->off->header.binary = true;
    r->in.line = 0; /* from here on there are no lines */
    return ROBERTS_OK;
}

/* Is there an unsigned integer here, alone on its line? */
static bool is_integer_alone(reader *r)
{
    size_t i = 0;
    for (bool blank = false;; i++) {
        if (!input_need(&r->in, i + 1))
            return i > 0;
        char c = r->in.at[i];
        if (c == '\n' || c == '\r' || c == '#')
            return i > 0;
        if (c == ' ' || c == '\t')
            blank = true;
        else if (c < '0' || c > '9' || blank || i > INPUT_TOKEN_MAX)
            return false;
    }
}

static roberts_status dimension(reader *r)
{
    uint64_t dimension;
    if (!input_skip(&r->in) || !input_integer(&r->in, &dimension))
        return read_expected(r, ROBERTS_BAD_SYNTAX, "the dimension");
    const size_t line = r->in.line;
    const bool is_dxf = dimension == 0 && input_skip(&r->in) && input_at_word(&r->in, "section");
    r->in.line = line;
    if (is_dxf)
        return read_refuse_format(r, "DXF", "assimp export model.dxf model.stl");
    if (dimension != 3)
        return read_fail(r, ROBERTS_BAD_SYNTAX, "the dimension is %llu, but only 3 can be drawn",
                         (unsigned long long)dimension);
    return ROBERTS_OK;
}

static roberts_status counts(reader *r)
{
    uint64_t edges;
    if (!input_skip(&r->in) || !input_integer(&r->in, &r->off->header.vertices))
        return read_expected(r, ROBERTS_BAD_SYNTAX, "the number of vertices");
    if (!input_skip(&r->in) || !input_integer(&r->in, &r->off->header.faces))
        return read_expected(r, ROBERTS_BAD_SYNTAX, "the number of faces");
    if (r->off->header.vertices >= UINT32_MAX || r->off->header.faces >= UINT32_MAX)
        return read_fail(r, ROBERTS_BAD_NUMBER, "there can be no more than 4294967294 vertices or faces");
    r->off->header.line = r->in.line;
    if (input_skip_in_line(&r->in)) {
        if (*r->in.at == '-')
            r->in.at++; /* some programs write -1 for unknown counts */
        if (!input_integer(&r->in, &edges))
            return read_expected(r, ROBERTS_BAD_SYNTAX, "the number of edges");
    } else if (input_skip(&r->in) && is_integer_alone(r)) {
        input_integer(&r->in, &edges); /* on a line of its own */
        r->off->header.line = r->in.line;
    }
    /* only 4OFF is ambiguous: with OFF, the rest of this line is the first vertex */
    if (r->off->header.homogeneous && input_skip_in_line(&r->in) && input_integer(&r->in, &edges))
        return read_fail(r, ROBERTS_BAD_SYNTAX,
                         "four counts: this is the 4OFF of four-dimensional polytopes with cells (as of Stella), not "
                         "4OFF with homogeneous coordinates, and cannot be drawn");
    if (r->in.line == r->off->header.line && input_skip_in_line(&r->in))
        r->off->header.line = 0;
    return ROBERTS_OK;
}

/* Is there an unsigned integer here, followed on the line by a word that begins with a letter? */
static bool titled_integer(reader *r)
{
    size_t i = 0;
    while (input_need(&r->in, i + 1) && r->in.at[i] >= '0' && r->in.at[i] <= '9' && i < INPUT_TOKEN_MAX)
        i++;
    for (size_t digits = i; input_need(&r->in, i + 1) && i < digits + INPUT_TOKEN_MAX; i++) {
        char c = r->in.at[i];
        if (c != ' ' && c != '\t')
            return i > digits && digits > 0 && ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'));
    }
    return false;
}

/* Reads the rest of the line, which is a title, and the number of points. */
static roberts_status count_points(reader *r)
{
    if (!input_pass_line(&r->in))
        return read_fail(r, ROBERTS_BAD_SYNTAX, "the first line does not end");
    if (!input_skip(&r->in) || !is_integer_alone(r) || !input_integer(&r->in, &r->off->header.vertices))
        return read_expected(r, ROBERTS_BAD_SYNTAX, "the number of points, alone on its line,");
    r->off->header.line = r->in.line;
    return ROBERTS_OK;
}

/* Refuses an input that begins with a word that is not a keyword. */
static roberts_status refuse_word(reader *r, size_t length)
{
    const roberts_status status = read_refuse_foreign(r, length);
    if (status != ROBERTS_OK)
        return status;
    return read_expected(r, ROBERTS_BAD_SYNTAX, "the beginning of OFF (keyword or counts), STL, OBJ or PLY");
}

static roberts_status read_header(reader *r)
{
    roberts_status status = opening(r);
    if (status != ROBERTS_OK)
        return status;
    size_t length = input_token(&r->in), word = 0;
    if (length <= INPUT_TOKEN_MAX)
        word = keyword(r->in.at, length, &r->off->header);
    r->off->header.bare = word == 0;
    if (word == 0 && (*r->in.at < '0' || *r->in.at > '9'))
        return refuse_word(r, length);
    r->in.at += word;
    if (word == length && (status = binary_word(r)) != ROBERTS_OK)
        return status;
    if (r->off->header.binary)
        return ROBERTS_OK; /* dimension and counts are binary too */
    if (word == 0 && titled_integer(r))
        return (status = dimension(r)) == ROBERTS_OK ? count_points(r) : status;
    if (r->off->header.dimension || (word == 0 && is_integer_alone(r)))
        status = dimension(r);
    return status == ROBERTS_OK ? counts(r) : status;
}

/* ---- the whole file -------------------------------------------------------------------------------------------- */

size_t off_count_empty(const reader *r)
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
    const size_t empty = off_count_empty(r);
    if (off_faces_read(r) < r->off->header.faces)
        warning_send(r->warnings, r->name, 0, "%llu faces declared, but there are %llu",
                     (unsigned long long)r->off->header.faces, (unsigned long long)off_faces_read(r));
    if (empty > 0)
        warning_send(r->warnings, r->name, 0, "%zu face%s without corners", empty, empty == 1 ? "" : "s");
    read_warn_colors(r->warnings, r->name, r->off->first_odd_color, r->off->odd_colors);
}

static roberts_status read_all(reader *r)
{
    roberts_status status = read_header(r);
    if (status != ROBERTS_OK)
        return status;
    status = r->off->header.binary ? off_read_binary(r) : off_read_text(r);
    if (status != ROBERTS_OK)
        return status;
    warn_of_left_out(r);
    if (r->thin_faces || r->off->odd_colors || r->off->runs_on || off_faces_read(r) < r->off->header.faces)
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
