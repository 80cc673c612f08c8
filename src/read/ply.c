/* ply.c - PLY: a text header that declares elements and their properties, followed by their values, as text or as
 * binary numbers in either byte order.
 *
 *   ply
 *   format ascii 1.0                        or binary_little_endian, binary_big_endian
 *   comment ...                             skipped, like obj_info
 *   element vertex 8                        an element and its count
 *   property float x                        a number, or
 *   property list uchar int vertex_indices  a count, followed by that many numbers
 *   end_header
 *
 * The mesh gets x, y, z of "vertex", the list vertex_indices (or vertex_index) of "face", vertex1 and vertex2 of "edge"
 * (an element of two corners), and red, green, blue of all three; and the triangles of "tristrips", whose lists
 * vertex_indices hold strips with -1 between them. All other elements and properties are skipped.
 *
 * Source: G. Turk, "The PLY polygon file format", Stanford 1994. */
#include "read/read.h"

#include <math.h>
#include <string.h>

enum {
    NAME_ROOM = 64,
    ELEMENTS_MOST = 16,
    PROPERTIES_MOST = 256,
    VALUE_MOST = 8, /* bytes of a number */
    COLOR = 3,
    AT_ONCE = 256 /* numbers of a list for which room is made at a time */
};

typedef enum value_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64, TYPES } value_type;

/* The use of a property's values. */
typedef enum role { UNUSED, X, Y, Z, RED, GREEN, BLUE, FIRST_CORNER, SECOND_CORNER, CORNERS, STRIP, ROLES } role;

typedef enum element_kind { OTHER, VERTEX, FACE, EDGE, STRIPS } element_kind;

typedef struct property {
    bool list;
    uint8_t count_type, type; /* value_type */
    uint8_t role;
} property;

typedef struct element {
    element_kind kind;
    char name[NAME_ROOM];
    uint64_t count; /* as declared: nothing is allocated for it */
    size_t first_property, properties;
} element;

typedef struct ply_reader {
    reader *r;
    bool binary, little;
    bool cr_lf; /* lines of the header end with CR LF */
    size_t elements, properties;
    element element[ELEMENTS_MOST];
    property property[PROPERTIES_MOST];
    uint64_t vertices; /* as declared */
    double value[ROLES];
} ply_reader;

static const struct type_name {
    const char *name, *other_name;
    size_t size;
} types[TYPES] = {{"char", "int8", 1}, {"uchar", "uint8", 1}, {"short", "int16", 2},   {"ushort", "uint16", 2},
                  {"int", "int32", 4}, {"uint", "uint32", 4}, {"float", "float32", 4}, {"double", "float64", 8}};

/* ---- the header ------------------------------------------------------------------------------------------------ */

/* Takes the next word of the line. False: there is none, or it is too long. */
static bool take_word(ply_reader *p, char word[NAME_ROOM])
{
    input *in = &p->r->in;
    if (!input_skip_in_line(in))
        return false;
    size_t length = input_token(in);
    if (length == 0 || length >= NAME_ROOM || memchr(in->at, '\0', length))
        return false;
    memcpy(word, in->at, length);
    word[length] = '\0';
    in->at += length;
    return true;
}

static roberts_status bad_header(ply_reader *p, const char *wanted)
{
    return read_expected(p->r, ROBERTS_BAD_SYNTAX, "%s in the header of PLY", wanted);
}

/* Takes the end of a header line. After the last line, binary data may begin with LF, so CR LF ends that line only if
 * it has ended another one. */
static roberts_status end_line(ply_reader *p, bool last)
{
    input *in = &p->r->in;
    if (input_skip_in_line(in))
        return bad_header(p, "the end of the line");
    if (!input_need(in, 1))
        return bad_header(p, "end_header");
    const bool cr = *in->at == '\r';
    in->at++;
    in->line++;
    if (cr && (p->cr_lf || !last || !p->binary) && input_need(in, 1) && *in->at == '\n') {
        in->at++;
        p->cr_lf = true;
    }
    return ROBERTS_OK;
}

static roberts_status read_format(ply_reader *p)
{
    char word[NAME_ROOM];
    input *in = &p->r->in;
    if (!input_skip_in_line(in) || !take_word(p, word))
        return bad_header(p, "the format");
    p->little = strcmp(word, "binary_little_endian") == 0;
    p->binary = p->little || strcmp(word, "binary_big_endian") == 0;
    if (!p->binary && strcmp(word, "ascii") != 0) {
        in->at -= strlen(word);
        return bad_header(p, "format ascii, binary_little_endian or binary_big_endian");
    }
    if (take_word(p, word) && strcmp(word, "1.0") != 0)
        warning_send(p->r->warnings, p->r->name, in->line, "PLY of version %s is read as version 1.0", word);
    return ROBERTS_OK;
}

static roberts_status read_element(ply_reader *p)
{
    if (p->elements == ELEMENTS_MOST)
        return read_fail(p->r, ROBERTS_BAD_SYNTAX, "more than %d elements", ELEMENTS_MOST);
    element *e = &p->element[p->elements];
    *e = (element){.first_property = p->properties};
    if (!take_word(p, e->name))
        return bad_header(p, "the name of an element");
    if (!input_skip_in_line(&p->r->in) || !input_integer(&p->r->in, &e->count))
        return bad_header(p, "the number of elements");
    e->kind = strcmp(e->name, "vertex") == 0      ? VERTEX
              : strcmp(e->name, "face") == 0      ? FACE
              : strcmp(e->name, "edge") == 0      ? EDGE
              : strcmp(e->name, "tristrips") == 0 ? STRIPS
                                                  : OTHER;
    for (size_t i = 0; i < p->elements; i++)
        if (e->kind != OTHER && p->element[i].kind == e->kind)
            return read_fail(p->r, ROBERTS_BAD_SYNTAX, "element %s is declared twice", e->name);
    if (e->kind == VERTEX)
        p->vertices = e->count;
    p->elements++;
    return ROBERTS_OK;
}

static roberts_status read_type(ply_reader *p, const char *word, uint8_t *type)
{
    for (*type = 0; *type < TYPES; ++*type)
        if (strcmp(word, types[*type].name) == 0 || strcmp(word, types[*type].other_name) == 0)
            return ROBERTS_OK;
    return read_fail(p->r, ROBERTS_BAD_SYNTAX, "type \"%.32s\" of a property is not known", word);
}

static role role_of(element_kind kind, const property *q, const char *name)
{
    static const struct row {
        element_kind kind; /* OTHER: any but STRIPS */
        bool list;
        role role;
        const char *name;
    } rows[] = {{VERTEX, false, X, "x"},
                {VERTEX, false, Y, "y"},
                {VERTEX, false, Z, "z"},
                {FACE, true, CORNERS, "vertex_indices"},
                {FACE, true, CORNERS, "vertex_index"},
                {STRIPS, true, STRIP, "vertex_indices"},
                {STRIPS, true, STRIP, "vertex_index"},
                {EDGE, false, FIRST_CORNER, "vertex1"},
                {EDGE, false, SECOND_CORNER, "vertex2"},
                {OTHER, false, RED, "red"},
                {OTHER, false, GREEN, "green"},
                {OTHER, false, BLUE, "blue"},
                {OTHER, false, RED, "diffuse_red"},
                {OTHER, false, GREEN, "diffuse_green"},
                {OTHER, false, BLUE, "diffuse_blue"}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        if ((rows[i].kind == kind || (rows[i].kind == OTHER && kind != OTHER && kind != STRIPS)) &&
            rows[i].list == q->list && strcmp(rows[i].name, name) == 0)
            return rows[i].role;
    return UNUSED;
}

static roberts_status read_property(ply_reader *p)
{
    char word[NAME_ROOM];
    if (p->elements == 0)
        return read_fail(p->r, ROBERTS_BAD_SYNTAX, "a property before the first element");
    if (p->properties == PROPERTIES_MOST)
        return read_fail(p->r, ROBERTS_BAD_SYNTAX, "more than %d properties", PROPERTIES_MOST);
    element *e = &p->element[p->elements - 1];
    property q = {0};
    if (!take_word(p, word))
        return bad_header(p, "the type of a property");
    roberts_status status = ROBERTS_OK;
    q.list = strcmp(word, "list") == 0;
    if (q.list) {
        if (!take_word(p, word))
            return bad_header(p, "the type of a list's count");
        status = read_type(p, word, &q.count_type);
        if (status == ROBERTS_OK && !take_word(p, word))
            return bad_header(p, "the type of a list");
    }
    if (status == ROBERTS_OK)
        status = read_type(p, word, &q.type);
    if (status != ROBERTS_OK)
        return status;
    if (!take_word(p, word))
        return bad_header(p, "the name of a property");
    q.role = (uint8_t)role_of(e->kind, &q, word);
    for (size_t i = 0; i < e->properties; i++)
        if (q.role != UNUSED && p->property[e->first_property + i].role == q.role)
            return read_fail(p->r, ROBERTS_BAD_SYNTAX, "property %s is declared twice", word);
    p->property[p->properties++] = q;
    e->properties++;
    return ROBERTS_OK;
}

static bool has_role(const ply_reader *p, const element *e, role wanted)
{
    for (size_t i = 0; i < e->properties; i++)
        if (p->property[e->first_property + i].role == wanted)
            return true;
    return false;
}

/* Do the properties suffice for a mesh? */
static roberts_status check_header(ply_reader *p)
{
    for (size_t i = 0; i < p->elements; i++) {
        element *e = &p->element[i];
        if (e->kind == VERTEX && !(has_role(p, e, X) && has_role(p, e, Y) && has_role(p, e, Z)))
            return read_fail(p->r, ROBERTS_BAD_SYNTAX, "vertices without x, y and z");
        if (e->kind == FACE && !has_role(p, e, CORNERS) && e->count)
            return read_fail(p->r, ROBERTS_BAD_SYNTAX, "faces without a list vertex_indices");
        if (e->kind == EDGE && !(has_role(p, e, FIRST_CORNER) && has_role(p, e, SECOND_CORNER)))
            e->kind = OTHER;
    }
    return ROBERTS_OK;
}

static roberts_status read_header(ply_reader *p)
{
    char word[NAME_ROOM];
    bool format = false;
    p->r->in.plain = true;
    p->r->in.at += 3; /* "ply" */
    roberts_status status = end_line(p, false);
    while (status == ROBERTS_OK) {
        if (!input_skip(&p->r->in) || !take_word(p, word))
            return bad_header(p, "end_header");
        if (strcmp(word, "comment") == 0 || strcmp(word, "obj_info") == 0) {
            if (!input_pass_line(&p->r->in))
                return bad_header(p, "the end of the line");
        } else if (strcmp(word, "format") == 0) {
            status = read_format(p);
            format = true;
        } else if (strcmp(word, "element") == 0) {
            status = read_element(p);
        } else if (strcmp(word, "property") == 0) {
            status = read_property(p);
        } else if (strcmp(word, "end_header") != 0) {
            p->r->in.at -= strlen(word);
            return bad_header(p, "element, property or end_header");
        } else if (!format) {
            return read_fail(p->r, ROBERTS_BAD_SYNTAX, "the header of PLY has no format");
        } else {
            status = end_line(p, true);
            if (status == ROBERTS_OK)
                status = check_header(p);
            p->r->binary = p->binary;
            return status;
        }
        if (status == ROBERTS_OK)
            status = end_line(p, false);
    }
    return status;
}

/* ---- values ---------------------------------------------------------------------------------------------------- */

static double binary_value(const char *at, value_type type, bool little)
{
    const unsigned char *b = (const unsigned char *)at;
    const unsigned low = little ? b[0] : b[types[type].size > 1 ? 1 : 0];
    const unsigned half = types[type].size == 2 ? low | (unsigned)(little ? b[1] : b[0]) << 8 : low;
    uint64_t wide;
    double value;
    switch (type) {
    case INT8:
        return low < 0x80 ? (double)low : (double)low - 0x100;
    case UINT8:
        return low;
    case INT16:
        return half < 0x8000 ? (double)half : (double)half - 0x10000;
    case UINT16:
        return half;
    case INT32:
        return read_word(at, little) < 0x80000000u ? (double)read_word(at, little)
                                                   : (double)read_word(at, little) - 4294967296.0;
    case UINT32:
        return read_word(at, little);
    case FLOAT32:
        return read_float(at, little);
    default:
        wide = (uint64_t)read_word(at + (little ? 4 : 0), little) << 32 | read_word(at + (little ? 0 : 4), little);
        memcpy(&value, &wide, sizeof value);
        return value;
    }
}

/* Reports a missing value, with the row of the current element. */
static roberts_status missing(ply_reader *p, const element *e, uint64_t row)
{
    reader *r = p->r;
    const roberts_status status = !r->binary && input_not_finite(&r->in) ? ROBERTS_BAD_NUMBER : ROBERTS_BAD_SYNTAX;
    return read_expected(r, status, "%s %llu of 0..%llu", e->name, (unsigned long long)row,
                         (unsigned long long)e->count - 1);
}

/* Takes one value; in text also "nan" and "inf" if `any`. False: there is none. */
static bool take_value(ply_reader *p, value_type type, bool any, double *value)
{
    reader *r = p->r;
    if (r->binary) {
        if (!input_need(&r->in, types[type].size))
            return false;
        *value = binary_value(r->in.at, type, p->little);
        r->in.at += types[type].size;
        return true;
    }
    if (!input_skip(&r->in))
        return false;
    if (input_number(&r->in, value))
        return true;
    if (!any || !input_not_finite(&r->in))
        return false;
    input_pass_token(&r->in);
    *value = NAN;
    return true;
}

static roberts_status bad_ply_corner(ply_reader *p, const element *e, uint64_t row, double index)
{
    return read_fail(p->r, ROBERTS_BAD_INDEX, "%s %llu names vertex %.17g, but there are %llu", e->name,
                     (unsigned long long)row, index, (unsigned long long)p->vertices);
}

static bool is_vertex(const ply_reader *p, double index)
{
    return index >= 0.0 && index < (double)p->vertices && index == floor(index);
}

/* Reads all corners at once if they are binary words and few, as is usual. False: they are not, or one of them is not a
 * vertex; nothing is taken. */
static bool read_words(ply_reader *p, value_type type, uint64_t count)
{
    reader *r = p->r;
    if (!r->binary || (type != INT32 && type != UINT32) || count > AT_ONCE || !input_need(&r->in, 4 * (size_t)count))
        return false;
    uint32_t *corner = r->mesh->corner + r->mesh->corner_count;
    for (size_t i = 0; i < count; i++) {
        uint32_t index = read_word(r->in.at + 4 * i, p->little);
        if (index >= p->vertices || index > INT32_MAX)
            return false;
        corner[i] = (uint32_t)r->mark.vertices + index;
    }
    r->in.at += 4 * count;
    r->mesh->corner_count += count;
    return true;
}

/* Reads the corners of a face; room grows as they come. */
static roberts_status read_corners(ply_reader *p, const element *e, uint64_t row, value_type type, uint64_t count)
{
    roberts_mesh *mesh = p->r->mesh;
    p->r->thin_faces += count < 3;
    for (uint64_t i = 0; i < count; i++) {
        double index;
        if (i % AT_ONCE == 0 && !mesh_corner_room(mesh, count - i < AT_ONCE ? count - i : AT_ONCE))
            return error_no_memory(p->r->error);
        if (i == 0 && read_words(p, type, count))
            return ROBERTS_OK;
        if (!take_value(p, type, false, &index))
            return missing(p, e, row);
        if (!is_vertex(p, index))
            return bad_ply_corner(p, e, row, index);
        mesh->corner[mesh->corner_count++] = (uint32_t)(p->r->mark.vertices + (uint64_t)index);
    }
    return ROBERTS_OK;
}

/* Adds a triangle, unless two corners are one: such join strips. False: no memory. */
static bool add_triangle(roberts_mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
    if (a == b || b == c || c == a)
        return true;
    return mesh_add_corner(mesh, a) && mesh_add_corner(mesh, b) && mesh_add_corner(mesh, c) && mesh_end_face(mesh);
}

/* Reads strips of triangles: each vertex makes one with the two before it, and every second one is turned. A negative
 * number ends a strip. */
static roberts_status read_strips(ply_reader *p, const element *e, uint64_t row, value_type type, uint64_t count)
{
    uint32_t before = 0, last = 0;
    uint64_t length = 0;
    for (uint64_t i = 0; i < count; i++) {
        double index;
        if (!take_value(p, type, false, &index))
            return missing(p, e, row);
        if (index < 0.0) {
            length = 0;
            continue;
        }
        if (!is_vertex(p, index))
            return bad_ply_corner(p, e, row, index);
        const uint32_t next = (uint32_t)(p->r->mark.vertices + (uint64_t)index);
        const bool turned = length % 2;
        if (length > 1 && !add_triangle(p->r->mesh, turned ? last : before, turned ? before : last, next))
            return error_no_memory(p->r->error);
        before = last;
        last = next;
        length++;
    }
    return ROBERTS_OK;
}

static roberts_status read_list(ply_reader *p, const element *e, uint64_t row, const property *q)
{
    double count, unused;
    if (!take_value(p, q->count_type, false, &count))
        return missing(p, e, row);
    if (!(count >= 0.0 && count == floor(count) && count <= (double)UINT32_MAX))
        return read_fail(p->r, ROBERTS_BAD_SYNTAX, "%s %llu has a list of %.17g numbers", e->name,
                         (unsigned long long)row, count);
    if (q->role == CORNERS)
        return read_corners(p, e, row, q->type, (uint64_t)count);
    if (q->role == STRIP)
        return read_strips(p, e, row, q->type, (uint64_t)count);
    for (uint64_t i = 0; i < (uint64_t)count; i++)
        if (!take_value(p, q->type, true, &unused))
            return missing(p, e, row);
    return ROBERTS_OK;
}

/* Reads the properties of one row: numbers into p->value, corners into the mesh. */
static roberts_status read_row(ply_reader *p, const element *e, uint64_t row)
{
    const property *q = p->property + e->first_property;
    roberts_status status = ROBERTS_OK;
    for (size_t i = 0; i < e->properties && status == ROBERTS_OK; i++, q++) {
        if (q->list)
            status = read_list(p, e, row, q);
        else if (!take_value(p, q->type, !(q->role >= X && q->role <= Z), &p->value[q->role]))
            status = missing(p, e, row);
    }
    return status;
}

/* ---- elements -------------------------------------------------------------------------------------------------- */

/* Returns the colour of the current row. Floats are 0 to 1, 16-bit integers 0 to 65535, other integers 0 to 255. */
static roberts_color row_color(const ply_reader *p, const element *e)
{
    roberts_color color = {.count = COLOR};
    size_t found = 0;
    for (size_t i = 0; i < e->properties; i++) {
        const property *q = &p->property[e->first_property + i];
        if (q->role < RED || q->role > BLUE)
            continue;
        double part = p->value[q->role] / (q->type >= FLOAT32 ? 1.0 : q->type == UINT16 ? 65535.0 : 255.0);
        if (!(part >= 0.0 && part <= 1.0))
            return (roberts_color){0};
        color.value[q->role - RED] = (float)part;
        found++;
    }
    return found == COLOR ? color : (roberts_color){0};
}

static roberts_status add_ply_vertex(ply_reader *p, uint64_t row)
{
    const roberts_vec3 position = {p->value[X], p->value[Y], p->value[Z]};
    if (!mesh_position(position))
        return read_bad_position(p->r, row);
    return mesh_add_vertex(p->r->mesh, position) ? ROBERTS_OK : error_no_memory(p->r->error);
}

static roberts_status add_ply_edge(ply_reader *p, const element *e, uint64_t row)
{
    for (int i = FIRST_CORNER; i <= SECOND_CORNER; i++) {
        if (!is_vertex(p, p->value[i]))
            return bad_ply_corner(p, e, row, p->value[i]);
        if (!mesh_add_corner(p->r->mesh, (uint32_t)(p->r->mark.vertices + (uint64_t)p->value[i])))
            return error_no_memory(p->r->error);
    }
    return ROBERTS_OK;
}

static roberts_status set_color(ply_reader *p, const element *e)
{
    reader *r = p->r;
    roberts_color color = row_color(p, e);
    if (color.count == 0)
        return ROBERTS_OK;
    bool good = e->kind == VERTEX ? mesh_color_vertex(r->mesh, r->mesh->vertex_count - 1, color, &r->vertices_filled)
                                  : mesh_color_face(r->mesh, r->mesh->face_count - 1, color, &r->faces_filled);
    return good ? ROBERTS_OK : error_no_memory(r->error);
}

static roberts_status read_elements(ply_reader *p, const element *e)
{
    const bool colored = e->kind != OTHER && has_role(p, e, RED);
    roberts_status status = ROBERTS_OK;
    if (e->kind == OTHER && e->properties == 0)
        return ROBERTS_OK; /* otherwise a count alone could take forever */
    for (uint64_t row = 0; row < e->count && status == ROBERTS_OK; row++) {
        status = read_row(p, e, row);
        if (status == ROBERTS_OK && e->kind == VERTEX)
            status = add_ply_vertex(p, row);
        if (status == ROBERTS_OK && e->kind == EDGE)
            status = add_ply_edge(p, e, row);
        if (status == ROBERTS_OK && (e->kind == FACE || e->kind == EDGE) && !mesh_end_face(p->r->mesh))
            status = error_no_memory(p->r->error);
        if (status == ROBERTS_OK && colored)
            status = set_color(p, e);
    }
    return status;
}

/* Warns of text after the last element. */
static roberts_status ending(ply_reader *p)
{
    reader *r = p->r;
    r->in.ended |= !r->in.source.to_end; /* the rest of the input may belong to someone else */
    if (r->binary ? input_need(&r->in, 1) : input_skip(&r->in))
        warning_send(r->warnings, r->name, r->binary ? 0 : r->in.line, "data after the last element ignored");
    return r->in.failure ? read_expected(r, ROBERTS_IO, "the end") : ROBERTS_OK;
}

roberts_status ply_read(reader *r)
{
    ply_reader p = {.r = r};
    roberts_status status = read_header(&p);
    for (size_t i = 0; i < p.elements && status == ROBERTS_OK; i++) {
        const element *e = &p.element[i];
        for (size_t k = 0; k < e->properties && r->binary && e->kind == VERTEX; k++) {
            const property *q = &p.property[e->first_property + k];
            if (q->role >= X && q->role <= Z && q->type == FLOAT32)
                mesh_float32(r->mesh);
        }
        status = read_elements(&p, e);
    }
    return status == ROBERTS_OK ? ending(&p) : status;
}
