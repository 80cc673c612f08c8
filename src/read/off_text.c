/* off_text.c - vertices and faces as text.
 *
 * Numbers may be distributed over lines in any way, but a colour is the rest of a line: for a face, everything after
 * its last corner; for a vertex (prefix C), everything after position and normal, except the last two numbers if there
 * are texture coordinates (prefix ST). 0, 1, 3 or 4 numbers are a colour. A vertex with any other count on its line is
 * assumed to be laid out freely: the next four numbers are its colour, on whatever line they are.
 *
 * So a number that is missing, or one too many, shifts all words after it, and the reader finds faces that the file
 * does not contain. Two signs together tell this from a free layout: an item begins or ends where no item should, and
 * what was read makes no sense. Then the file is refused.
 *
 * Most of the time goes into plain lines (off.h), so two loops read these with everything written out. That saves a
 * fifth of the time, and threads (off_pieces.c) read nothing else. */
#include "read/off.h"

#include <math.h>
#include <string.h>

#include "base/number.h"

/* ---- plain lines ----------------------------------------------------------------------------------------------- */

static inline bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static inline const char *pass_blanks(const char *at)
{
    while (is_blank(*at))
        at++;
    return at;
}

const char *plain_next_line(const char *at)
{
    at = pass_blanks(at);
    at += *at == '\r';
    return *at == '\n' ? at + 1 : NULL;
}

/* Returns the first nonblank character of the next line; NULL: the current line does not end here. */
BITS_INLINE const char *begin_line(const char *at)
{
    const char *c = *at == '\n' ? at + 1 : plain_next_line(at);
    return c && (unsigned char)*c <= ' ' ? pass_blanks(c) : c;
}

static inline bool line_ends(const char *at)
{
    return *at == '\n' || plain_next_line(at);
}

/* Reads one of the few coordinates, about one in a hundred, that number_usual() rejects. NULL: it is not a number, or
 * it is too large. */
BITS_RARE static const char *any_coordinate(const char *c, double *value)
{
    c = number_parse(c, value);
    return c && (unsigned char)*c <= ' ' && mesh_coordinate(*value) ? c : NULL;
}

/* Moves to the next token of the line, or to the end of the line. */
BITS_INLINE const char *next_token(const char *end)
{
    return *end == ' ' && (unsigned char)end[1] > ' ' ? end + 1 : pass_blanks(end);
}

/* Models along the axes repeat their coordinates. Comparing a text with an earlier one costs a sixth of reading it. */
enum { SPELLINGS = 2, SHORT_SPELLING = 8, LONG_SPELLING = 23, FRUITLESS_VERTICES = 16 };

/* A coordinate as text. */
typedef struct spelling {
    uint64_t begin, middle, end; /* its first eight characters; eight more; its last seven, and what follows */
    size_t middle_at, length;
    double value;
} spelling;

/* The last coordinates of one column. */
typedef struct column {
    number_guess guess;
    spelling last[SPELLINGS];
    int oldest;
} column;

static void begin_column(column *k)
{
    const spelling none = {.begin = UINT64_C(0x2020202020202020)}; /* blanks */
    *k = (column){.guess = number_guess_digits(8), .last = {none, none}};
}

/* Is this the number at c? No more than eight characters beyond the end of the text are read: each part is compared
 * only if the characters before it are those of a number. */
BITS_INLINE bool is_spelled(const spelling *s, const char *c)
{
    return bits_load(c) == s->begin && bits_load(c + s->middle_at) == s->middle &&
           bits_load(c + s->length - 7) == s->end;
}

BITS_INLINE void keep_spelling(column *k, const char *c, const char *end, double value)
{
    size_t length = (size_t)(end - c), middle = length < 15 ? length - 7 : 8;
    if (length < SHORT_SPELLING || length > LONG_SPELLING)
        return;
    k->last[k->oldest] = (spelling){bits_load(c), bits_load(c + middle), bits_load(end - 7), middle, length, value};
    k->oldest = !k->oldest;
}

/* Reads a coordinate and moves to the next token of the line, or to the end of the line. spelled: compares its text
 * first, and counts those found in *found. */
BITS_INLINE const char *coordinate(const char *c, column *k, bool spelled, size_t *found, double *value)
{
    for (int i = 0; spelled && i < SPELLINGS; i++)
        if (is_spelled(&k->last[i], c)) {
            *value = k->last[i].value;
            ++*found;
            return next_token(c + k->last[i].length);
        }
    const char *end = number_usual(c, &k->guess, value); /* far below MESH_COORDINATE_MAX */
    if (!end || (unsigned char)*end > ' ')
        end = any_coordinate(c, value);
    if (!end)
        return NULL;
    if (spelled)
        keep_spelling(k, c, end, *value);
    return next_token(end);
}

/* Reads vertices as plain_vertices() does. spelled: compares texts, and stops after some vertices if none was found. */
BITS_INLINE const char *vertices_in_columns(const char *at, column k[3], bool spelled, roberts_vec3 *vertex,
                                            size_t room, size_t *count)
{
    size_t n = 0, found = 0;
    for (; n < room && (!spelled || n < FRUITLESS_VERTICES * (1 + found)); n++) {
        roberts_vec3 *p = &vertex[n];
        const char *c = begin_line(at);
        if (!c || !(c = coordinate(c, &k[0], spelled, &found, &p->x)) ||
            !(c = coordinate(c, &k[1], spelled, &found, &p->y)) ||
            !(c = coordinate(c, &k[2], spelled, &found, &p->z)) || !line_ends(c))
            break;
        at = c;
    }
    *count = n;
    return at;
}

const char *plain_vertices(const char *at, roberts_vec3 *vertex, size_t room, size_t *count)
{
    column k[3];
    size_t more;
    for (int i = 0; i < 3; i++)
        begin_column(&k[i]);
    at = vertices_in_columns(at, k, true, vertex, room, count);
    at = vertices_in_columns(at, k, false, vertex + *count, room - *count, &more);
    *count += more;
    return at;
}

/* Handles a vertex number that is not as long as the last one, or not exactly one blank away: returns its position, and
 * corrects the guess. NULL: there is none. */
BITS_RARE static const char *guess_again(const char *at, number_guess *guess)
{
    const char *c = pass_blanks(at);
    int digits = number_digit_count(bits_load(c) ^ NUMBER_DIGITS);
    if (c == at || digits == 0)
        return NULL;
    *guess = number_guess_digits(digits);
    return c;
}

/* Reads `count` vertex numbers. NULL: one is not plain or is out of range. */
BITS_INLINE const char *plain_corners(const char *at, const plain_faces *f, number_guess *guess, uint32_t *corner,
                                      uint32_t count)
{
    const uint32_t first = f->first, limit = f->limit;
    uint64_t shift = 64 - 8 * guess->digits; /* shifts in leading zeros */
    for (const uint32_t *end = corner + count; corner < end; corner++) {
        const char *c = at + 1;
        uint64_t chunk = bits_load(c) ^ NUMBER_DIGITS;
        if (!number_guess_right(chunk, guess) || *at != ' ') {
            c = guess_again(at, guess);
            if (!c)
                return NULL;
            chunk = bits_load(c) ^ NUMBER_DIGITS;
            shift = 64 - 8 * guess->digits;
        }
        uint32_t index = (uint32_t)number_eight_digits(chunk << shift);
        if (index >= limit)
            return NULL;
        *corner = first + index;
        at = c + guess->digits; /* a ninth digit would be here, and is not a blank */
    }
    return at;
}

const char *plain_read_faces(const char *at, plain_faces *faces)
{
    number_guess guess = number_guess_digits(1);
    plain_faces f = *faces; /* a copy, so that its members can stay in registers */
    while (f.count < f.room) {
        const char *c = begin_line(at);
        if (!c)
            break;
        uint32_t count = (uint32_t)(unsigned char)*c - '0';
        int digits = 1;
        if (count > 9 || c[1] != ' ')
            digits = number_short_integer(c, &count);
        if (digits == 0 || count == 0 || count > PLAIN_CORNERS || count > f.corner_room - f.corner_count)
            break;
        c = plain_corners(c + digits, &f, &guess, f.corner + f.corner_count, count);
        if (!c || !line_ends(c))
            break;
        f.corner_count += count;
        f.end[f.count++] = (uint32_t)f.corner_count;
        f.thin += count < 3;
        at = c;
    }
    *faces = f;
    return at;
}

/* ---- all other lines ------------------------------------------------------------------------------------------- */

enum {
    CORNERS_AT_ONCE = 256,
    PATIENCE = 4, /* after this many consecutive lines that are not plain ... */
    PAUSE = 60    /* ... this many are not tried */
};

/* Reads one number of a colour. Sets *real if it has a point or an exponent. */
static bool color_number(reader *r, double *value, bool *real)
{
    size_t length = input_token(&r->in);
    for (size_t i = 0; i < length; i++)
        *real |= r->in.at[i] == '.' || r->in.at[i] == 'e' || r->in.at[i] == 'E';
    return input_number(&r->in, value);
}

/* Decides whether plain lines are worth trying. After PATIENCE lines that are not plain, PAUSE more go directly to the
 * general parser. */
typedef struct patience {
    uint32_t wait, fruitless;
} patience;

static bool worth_trying(patience *p)
{
    if (p->wait == 0)
        return true;
    p->wait--;
    return false;
}

static void tried(patience *p, size_t found)
{
    p->fruitless = found ? 0 : p->fruitless + (p->fruitless < PATIENCE);
    p->wait = p->fruitless == PATIENCE ? PAUSE : 0;
}

/* ---- vertices -------------------------------------------------------------------------------------------------- */

static roberts_status bad_vertex(reader *r, uint64_t v, const char *part)
{
    return read_expected(r, input_not_finite(&r->in) ? ROBERTS_BAD_NUMBER : ROBERTS_BAD_SYNTAX,
                         "%s of vertex %llu of 0..%llu", part, (unsigned long long)v,
                         (unsigned long long)r->off->header.vertices - 1);
}

/* Skips a normal. It is not used, so even "nan" is accepted. */
static roberts_status skip_normal(reader *r, uint64_t v)
{
    double unused;
    for (int i = 0; i < NORMAL; i++) {
        if (!input_skip(&r->in))
            return bad_vertex(r, v, "the normal");
        if (input_number(&r->in, &unused))
            continue;
        if (!input_not_finite(&r->in))
            return bad_vertex(r, v, "the normal");
        input_pass_token(&r->in);
    }
    return ROBERTS_OK;
}

/* Reads colour and texture coordinates, as described at the top of the file. */
static roberts_status vertex_extras(reader *r, uint64_t v)
{
    const int texture = r->off->header.texture ? TEXTURE : 0, most = texture + (r->off->header.color ? COLOR_MOST : 0);
    off_color_numbers color = {0};
    double value[COLOR_MOST + TEXTURE] = {0};
    bool real[COLOR_MOST + TEXTURE] = {0};
    int count = 0;
    for (; count < most; count++) {
        bool may_end = count == texture || count == texture + 1 || count == texture + 3;
        if (!input_skip_in_line(&r->in) && may_end)
            break;
        if (!input_skip(&r->in))
            return bad_vertex(r, v, "the colour or texture");
        if (color_number(r, &value[count], &real[count]))
            continue;
        if (!input_not_finite(&r->in))
            return bad_vertex(r, v, "the colour or texture");
        input_pass_token(&r->in);
        value[count] = NAN; /* harmless in a texture coordinate; gives an invalid colour */
    }
    color.count = count - texture;
    memcpy(color.value, value, sizeof color.value);
    for (int i = 0; i < color.count; i++)
        color.real |= real[i];
    return color.count ? off_color_vertex(r, &color) : ROBERTS_OK;
}

static roberts_status too_large(reader *r, uint64_t v, double w)
{
    if (w == 0.0)
        return read_fail(r, ROBERTS_BAD_NUMBER, "vertex %llu lies at infinity: its fourth coordinate is 0",
                         (unsigned long long)v);
    return read_fail(r, ROBERTS_BAD_NUMBER, "vertex %llu has a coordinate beyond %g", (unsigned long long)v,
                     MESH_COORDINATE_MAX);
}

static roberts_status read_vertex(reader *r, uint64_t v)
{
    static const char *const part[4] = {"x", "y", "z", "w"};
    const int size = r->off->header.homogeneous ? 4 : 3;
    roberts_status status = ROBERTS_OK;
    double p[4] = {0, 0, 0, 1};
    for (int i = 0; i < size; i++) {
        if (!input_skip(&r->in) || !input_number(&r->in, &p[i]))
            return bad_vertex(r, v, part[i]);
    }
    if (size == 4) {
        for (int i = 0; i < 3; i++)
            p[i] /= p[3];
    }
    if (!mesh_position((roberts_vec3){p[0], p[1], p[2]}))
        return too_large(r, v, p[3]);
    if (!mesh_add_vertex(r->mesh, (roberts_vec3){p[0], p[1], p[2]}))
        return error_no_memory(r->error);
    if (r->off->header.normal)
        status = skip_normal(r, v);
    if (status == ROBERTS_OK && (r->off->header.color || r->off->header.texture))
        status = vertex_extras(r, v);
    return status;
}

/* Reads plain lines of the buffer as far as the mesh has room; returns the number of vertices. */
static size_t take_vertices(reader *r, uint64_t left)
{
    roberts_mesh *mesh = r->mesh;
    size_t room = mesh->vertex_room - mesh->vertex_count, count;
    r->in.at = plain_vertices(r->in.at, mesh->vertex + mesh->vertex_count, room < left ? room : (size_t)left, &count);
    r->in.line += count;
    mesh->vertex_count += count;
    return count;
}

static uint64_t vertices_read(const reader *r)
{
    return r->mesh->vertex_count - r->mark.vertices;
}

/* Reads a vertex, and notes where the first one is that does not end with its line. */
static roberts_status read_any_vertex(reader *r, uint64_t v)
{
    (void)input_skip(&r->in); /* to its line */
    const size_t line = r->in.line;
    const roberts_status status = read_vertex(r, v);
    if (status == ROBERTS_OK && r->off->uneven.line == 0 && input_skip_in_line(&r->in))
        r->off->uneven = (off_place){line, v};
    return status;
}

static roberts_status read_vertices(reader *r)
{
    const bool plain =
        !(r->off->header.color || r->off->header.texture || r->off->header.normal || r->off->header.homogeneous);
    const uint64_t count = r->off->header.vertices;
    patience lines = {0};
    while (vertices_read(r) < count) {
        if (plain && vertices_read(r) > 0) /* the line of the counts may continue */
            off_read_pieces(r);
        if (plain && r->mesh->vertex_count < r->mesh->vertex_room && worth_trying(&lines))
            tried(&lines, take_vertices(r, count - vertices_read(r)));
        if (vertices_read(r) == count)
            break;
        roberts_status status = read_any_vertex(r, vertices_read(r));
        if (status != ROBERTS_OK)
            return status;
    }
    return ROBERTS_OK;
}

/* ---- faces ----------------------------------------------------------------------------------------------------- */

static bool long_index(reader *r, uint64_t limit, uint64_t *value)
{
    size_t length = input_token(&r->in);
    if (length > INPUT_TOKEN_MAX || number_integer(r->in.at, value) != r->in.at + length || *value >= limit)
        return false;
    r->in.at += length;
    return true;
}

/* Reads an unsigned integer below `limit`; nearly all are short. False: nothing is taken. */
static inline bool index_number(reader *r, uint64_t limit, uint64_t *value)
{
    uint32_t number;
    int count = number_short_integer(r->in.at, &number);
    if (count == 0 || !input_separator(r->in.at[count]))
        return long_index(r, limit, value);
    if (number >= limit)
        return false;
    r->in.at += count;
    *value = number;
    return true;
}

/* Is a corner before corner i of the current face vertex 0? */
static bool names_first(const reader *r, uint64_t i)
{
    const roberts_mesh *mesh = r->mesh;
    const size_t end = mesh->corner_count + (size_t)(i % CORNERS_AT_ONCE); /* completed parts are already included */
    for (size_t k = r->mark.corners; k < end; k++)
        if (mesh->corner[k] == r->mark.vertices)
            return true;
    return false;
}

/* Explains why corner i of face f was rejected; `at` is still before it. In a file that counts from 1, the index equals
 * the number of vertices, and no corner has named vertex 0. */
static roberts_status bad_off_corner(reader *r, uint64_t f, uint64_t i, uint64_t count)
{
    uint64_t index;
    bool negative = *r->in.at == '-';
    input *in = &r->in;
    in->at += negative;
    if (!input_integer(&r->in, &index)) {
        in->at -= negative;
        return read_expected(r, ROBERTS_BAD_SYNTAX, "corner %llu of %llu in face %llu of 0..%llu",
                             (unsigned long long)i + 1, (unsigned long long)count, (unsigned long long)f,
                             (unsigned long long)r->off->header.faces - 1);
    }
    const bool next = !negative && index == r->off->header.vertices;
    return read_fail(r, ROBERTS_BAD_INDEX, "face %llu names vertex %s%llu, but there are %llu%s%s",
                     (unsigned long long)f, negative ? "-" : "", (unsigned long long)index,
                     (unsigned long long)r->off->header.vertices, next ? ", numbered from 0" : "",
                     next && !names_first(r, i) ? "; up to here no face names vertex 0: do they count from 1?" : "");
}

/* The line on which the corners of a face end, if they do not begin there. */
typedef struct last_line {
    uint64_t first, words; /* its first number, and how many corners are on it; 0: the face begins there */
} last_line;

/* Reads the corners of face f into the mesh. Room grows as they come: a count alone takes no memory. */
static roberts_status read_corners(reader *r, uint64_t f, uint64_t count, last_line *last)
{
    size_t line = r->in.line;
    const uint32_t first = (uint32_t)r->mark.vertices;
    const uint64_t vertices = r->off->header.vertices;
    roberts_mesh *mesh = r->mesh;
    for (uint64_t done = 0, part; done < count; done += part) {
        part = count - done < CORNERS_AT_ONCE ? count - done : CORNERS_AT_ONCE;
        if (!mesh_corner_room(mesh, part))
            return error_no_memory(r->error);
        uint32_t *corner = mesh->corner + mesh->corner_count;
        for (uint64_t i = 0; i < part; i++) {
            uint64_t index;
            if (!input_skip(&r->in))
                return bad_off_corner(r, f, done + i, count);
            if (!index_number(r, vertices, &index))
                return bad_off_corner(r, f, done + i, count);
            if (r->in.line != line)
                *last = (last_line){.first = index};
            line = r->in.line;
            last->words++;
            corner[i] = first + (uint32_t)index;
        }
        mesh->corner_count += part;
    }
    if (!mesh_end_face(mesh))
        return error_no_memory(r->error);
    r->thin_faces += count < 3;
    return ROBERTS_OK;
}

/* Reads the rest of the line of the last face: a colour, or something that is ignored with a warning. Adds its words to
 * *words. */
static roberts_status face_color(reader *r, uint64_t *words)
{
    off_color_numbers raw = {0};
    bool good = true;
    uint64_t start = r->in.taken;
    while (input_skip_in_line(&r->in) && !(*r->in.at == '}' && r->off->header.braces)) {
        if (r->in.taken - start > INPUT_BLANK_MAX)
            return read_fail(r, ROBERTS_BAD_SYNTAX, "the line of face %zu does not end",
                             r->mesh->face_count - 1 - r->mark.faces);
        ++*words;
        if (good && raw.count < COLOR_MOST && color_number(r, &raw.value[raw.count++], &raw.real))
            continue;
        good = false;
        input_pass_token(&r->in);
    }
    if (raw.count == 0 && good)
        return ROBERTS_OK;
    if (!good)
        raw.count = COLOR_MOST + 1;
    return off_color_face(r, &raw);
}

/* Reads a face. A token is known to follow. A face that ends within a line that looks like
 * a face itself probably lacks a corner. */
static roberts_status read_face(reader *r, uint64_t f)
{
    const size_t begun = r->in.line;
    uint64_t count, words;
    last_line last = {0};
    if (!index_number(r, UINT64_MAX, &count))
        return read_expected(r, ROBERTS_BAD_SYNTAX, "the number of corners of face %llu of 0..%llu",
                             (unsigned long long)f, (unsigned long long)r->off->header.faces - 1);
    roberts_status status = read_corners(r, f, count, &last);
    words = last.words;
    if (status == ROBERTS_OK && *r->in.at != '\n')
        status = face_color(r, &words);
    if (r->off->short_face.line == 0 && last.first >= 3 && words > last.words && words > last.first)
        r->off->short_face = (off_place){begun, f};
    return status;
}

/* Reads plain faces, like take_vertices(). */
static size_t take_faces(reader *r, uint64_t left)
{
    roberts_mesh *mesh = r->mesh;
    size_t room = mesh->face_room - mesh->face_count - 1;
    plain_faces faces = {.corner = mesh->corner,
                         .end = mesh->face_start + mesh->face_count + 1,
                         .corner_room = mesh->corner_room,
                         .room = room < left ? room : (size_t)left,
                         .first = (uint32_t)r->mark.vertices,
                         .limit = off_index_limit(r),
                         .corner_count = mesh->corner_count};
    r->in.at = plain_read_faces(r->in.at, &faces);
    r->in.line += faces.count;
    r->thin_faces += faces.thin;
    mesh->corner_count = faces.corner_count;
    mesh->face_count += faces.count;
    return faces.count;
}

static roberts_status read_faces(reader *r)
{
    const uint64_t count = r->off->header.faces;
    patience lines = {0};
    if (count > 0 && off_faces_read(r) == 0 && r->off->uneven.line > 0)
        r->off->runs_on = input_skip_in_line(&r->in) && *r->in.at != '}';
    while (off_faces_read(r) < count) {
        if (off_faces_read(r) > 0)
            off_read_pieces(r);
        if (r->mesh->face_count + 1 < r->mesh->face_room && worth_trying(&lines))
            tried(&lines, take_faces(r, count - off_faces_read(r)));
        uint64_t f = off_faces_read(r);
        if (f == count)
            break;
        if (!input_skip(&r->in) || (*r->in.at == '}' && r->off->header.braces)) {
            if (r->in.failure || r->in.too_blank)
                return read_expected(r, ROBERTS_BAD_SYNTAX, "face %llu", (unsigned long long)f);
            return ROBERTS_OK; /* there are fewer faces than declared */
        }
        roberts_status status = read_face(r, f);
        if (status != ROBERTS_OK)
            return status;
    }
    return ROBERTS_OK;
}

/* ---- the end --------------------------------------------------------------------------------------------------- */

/* Returns what makes no sense in the faces, or NULL. */
static const char *find_nonsense(const reader *r)
{
    if (off_faces_read(r) < r->off->header.faces)
        return "there are fewer faces than declared";
    if (r->thin_faces > 0 && off_count_empty(r) > 0)
        return "a face has no corners";
    if (r->off->odd_colors)
        return "a colour makes no sense";
    const uint32_t *first = r->mesh->face_start + r->mark.faces;
    return first[1] - first[0] < 3 ? "the first face has fewer than 3 corners" : NULL;
}

/* Refuses a text whose words have run out of step with its lines, if that has led to nonsense. A face that runs into
 * the next line is refused only if there are fewer faces than declared. */
static roberts_status check_layout(reader *r)
{
    const off_state *off = r->off;
    const char *nonsense = off->runs_on ? find_nonsense(r) : NULL;
    if (nonsense)
        return error_set(r->error, ROBERTS_BAD_SYNTAX, off->uneven.line,
                         "vertex %llu of 0..%llu does not end with its line, and then %s%s",
                         (unsigned long long)off->uneven.number, (unsigned long long)off->header.vertices - 1, nonsense,
                         off->header.line == 0 ? "; each face must begin a line" : "");
    if (off->short_face.line > 0 && off_faces_read(r) < off->header.faces)
        return error_set(r->error, ROBERTS_BAD_SYNTAX, off->short_face.line,
                         "face %llu of 0..%llu runs into the line of the next, and then there are fewer faces than "
                         "declared",
                         (unsigned long long)off->short_face.number, (unsigned long long)off->header.faces - 1);
    return ROBERTS_OK;
}

/* Warns of text after the last face. If the rest of the input may belong to someone else, only the last block is
 * examined. */
static roberts_status ending(reader *r)
{
    input *in = &r->in;
    in->ended |= !in->source.to_end;
    for (; r->off->header.braces && input_skip(in) && *in->at == '}'; r->off->header.braces--)
        in->at++;
    if (input_skip(in))
        off_explain_rest(r);
    if (in->failure)
        return read_expected(r, ROBERTS_IO, "the end");
    return ROBERTS_OK;
}

roberts_status off_read_text(reader *r)
{
    roberts_status status = read_vertices(r);
    if (status == ROBERTS_OK)
        status = read_faces(r);
    if (status == ROBERTS_OK)
        status = check_layout(r);
    return status == ROBERTS_OK ? ending(r) : status;
}
