/* obj.c - Wavefront OBJ: a text whose lines each begin with a keyword.
 *
 *   v x y z [w] [r g b]     vertex, perhaps with a colour; w, the weight for rational curves, is not used
 *   f a b c ...             face; a corner is v, v/vt, v/vt/vn or v//vn; a negative number counts from the last vertex
 *   l a b c ...             polyline: each segment is an element of two corners
 *   o name, g name          the name of the faces that follow; the last one counts
 *   usemtl name             the faces that follow have the colour Kd of this material
 *   mtllib name             the file beside this one with the materials; without it there are no colours
 *
 * Lines with other keywords are skipped. '#' begins a comment where a word could begin. A backslash at the end of a
 * line joins the next line to it, but not at the end of a comment. OBJ counts vertices from 1; here, as in the other
 * formats, they count from 0.
 *
 * Source: "Object Files", appendix B1 of the manual of Wavefront's Advanced Visualizer, 1995. */
#include "read/obj.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/array.h"
#include "read/read.h"

enum { POSITION = 3, COLOR = 3, NUMBERS_MOST = 8, PATH_ROOM = 4096 };

/* Statements of one kind that are worth a warning. */
typedef struct obj_oddity {
    size_t count, line; /* line: of the first one, */
    char word[32];      /* and its word */
} obj_oddity;

typedef struct obj_reader {
    reader *r;
    obj_materials materials;
    bool sorted;          /* are the materials sorted? */
    bool has_library;     /* was any .mtl found? */
    roberts_color color;  /* of the following faces */
    int64_t greatest;     /* greatest vertex named so far, counted over the whole mesh; -1: none */
    size_t greatest_line; /* the first line that names it */
    obj_oddity unknown;   /* keywords */
    obj_oddity lacking;   /* uses of materials that no .mtl has */
} obj_reader;

static void note(const obj_reader *o, obj_oddity *odd, const char *word, size_t length)
{
    if (odd->count++ > 0)
        return;
    odd->line = o->r->in.line;
    for (size_t i = 0; i < length && i + 1 < sizeof odd->word; i++)
        odd->word[i] = word[i] >= ' ' && word[i] < 0x7f ? word[i] : '?';
}

/* ---- lines ----------------------------------------------------------------------------------------------------- */

/* Moves to the next word of the line. A comment is not a word. A line that ends in a backslash continues on the
 * next. */
static bool next_word(input *in)
{
    while (input_skip_in_line(in) && *in->at != '#') {
        if (*in->at != '\\' || !input_need(in, 2) || (in->at[1] != '\n' && in->at[1] != '\r'))
            return true;
        in->at += 2;
        in->line++;
        if (in->at[-1] == '\r' && input_need(in, 1) && *in->at == '\n')
            in->at++;
    }
    return false;
}

/* Returns the length of the word here, without a backslash at the end of the line. */
static size_t word_length(input *in)
{
    size_t length = input_token(in);
    const bool ends = length > 1 && length <= INPUT_TOKEN_MAX && in->at[length - 1] == '\\';
    return ends && (in->at[length] == '\n' || in->at[length] == '\r') ? length - 1 : length;
}

static bool is_word(input *in, size_t length, const char *word)
{
    return strlen(word) == length && memcmp(in->at, word, length) == 0;
}

/* Reads the number if it is the whole word here. */
static bool number(input *in, double *value)
{
    const char *end = number_parse(in->at, value);
    if (!end || !input_separator(*end)) {
        size_t length = word_length(in);
        end = length <= INPUT_TOKEN_MAX ? number_parse(in->at, value) : NULL;
        if (end != in->at + length)
            return false;
    }
    in->at = end;
    return true;
}

/* ---- materials ------------------------------------------------------------------------------------------------- */

static bool add_material(obj_materials *m, const char *name)
{
    if (!array_reserve(&m->item, &m->room, m->count + 1, sizeof *m->item))
        return false;
    char *copy = alloc_array(strlen(name) + 1, 1);
    if (!copy)
        return false;
    memcpy(copy, name, strlen(name) + 1);
    m->item[m->count] = (obj_material){.name = copy, .order = m->count};
    m->count++;
    return true;
}

/* Reads "Kd r g b" for the last material; "Kd r" is a grey. Skips other forms ("Kd spectral", "Kd xyz"). */
static void read_diffuse(obj_materials *m, input *in)
{
    double value[COLOR];
    const size_t line = in->line;
    if (next_word(in) && (input_at_word(in, "spectral") || input_at_word(in, "xyz")))
        return;
    for (int i = 0; i < COLOR; i++) {
        const bool more = next_word(in);
        if (i == 1 && !more) {
            value[1] = value[2] = value[0];
            break;
        }
        if (!more || !number(in, &value[i]) || !(value[i] >= 0.0 && value[i] <= 1.0)) {
            m->first_odd = m->odd++ ? m->first_odd : line;
            return;
        }
    }
    if (m->count)
        m->item[m->count - 1].color =
            (roberts_color){.count = COLOR, .value = {(float)value[0], (float)value[1], (float)value[2]}};
}

/* Moves to the end of the line, past lines joined to it. A comment joins none: it may end in a Windows path. False: the
 * line does not end. */
static bool pass_line(input *in)
{
    uint64_t start = in->taken;
    for (bool comment = false, blank = true;;) {
        const char *c = in->at;
        for (; c < in->end && *c != '\n' && *c != '\r'; c++) {
            comment = comment || (blank && *c == '#');
            blank = *c == ' ' || *c == '\t';
        }
        bool backslash = !comment && c > in->at && c[-1] == '\\';
        in->at = backslash ? c - 1 : c; /* the end of the line may be in the next block */
        if (c < in->end && !backslash)
            return in->taken - start <= INPUT_BLANK_MAX;
        if (c < in->end) {
            if (!next_word(in))
                return true;
        } else if (!input_more(in)) {
            in->at = in->end;
            return in->taken - start <= INPUT_BLANK_MAX;
        } else if (in->taken - start > INPUT_BLANK_MAX) {
            return false;
        }
    }
}

/* Reads the rest of the line as one name: words separated by one blank, at most `room` - 1 characters. */
static void take_name(input *in, char *name, size_t room)
{
    size_t used = 0;
    while (next_word(in)) {
        size_t length = word_length(in), left;
        if (length > INPUT_TOKEN_MAX)
            break;
        if (used && used + 1 < room)
            name[used++] = ' ';
        left = room - 1 - used;
        memcpy(name + used, in->at, length < left ? length : left);
        used += length < left ? length : left;
        in->at += length;
    }
    name[used] = '\0';
    for (size_t i = 0; i < used; i++)
        if (name[i] == '\0')
            name[i] = '?';
}

bool obj_materials_read(obj_materials *m, const input_source *source)
{
    input in;
    char name[MESH_GROUP_NAME];
    bool good = input_open(&in, source);
    in.plain = true;
    m->odd = m->first_odd = 0;
    while (good && input_skip(&in)) {
        size_t length = word_length(&in);
        if (length <= INPUT_TOKEN_MAX && is_word(&in, length, "newmtl")) {
            in.at += length;
            take_name(&in, name, sizeof name);
            good = add_material(m, name);
        } else if (length <= INPUT_TOKEN_MAX && is_word(&in, length, "Kd")) {
            in.at += length;
            read_diffuse(m, &in);
        }
        if (!pass_line(&in))
            break;
    }
    input_close(&in);
    return good;
}

static int by_name(const void *a, const void *b)
{
    const obj_material *x = a, *y = b;
    int order = strcmp(x->name, y->name);
    return order ? order : x->order < y->order ? -1 : x->order > y->order;
}

void obj_materials_sort(obj_materials *m)
{
    if (m->count)
        qsort(m->item, m->count, sizeof *m->item, by_name);
}

const roberts_color *obj_materials_color(const obj_materials *m, const char *name)
{
    size_t low = 0, high = m->count; /* the last item that is not after `name` is before `low` */
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (strcmp(m->item[middle].name, name) <= 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low && strcmp(m->item[low - 1].name, name) == 0 ? &m->item[low - 1].color : NULL;
}

void obj_materials_free(obj_materials *m)
{
    for (size_t i = 0; i < m->count; i++)
        free(m->item[i].name);
    free(m->item);
    *m = (obj_materials){0};
}

/* Returns the last part of a name, which may be a path on another machine: files are searched for only beside the
 * OBJ. */
static const char *last_part(const char *name)
{
    const char *last = name;
    for (const char *c = name; *c; c++)
        if (*c == '/' || *c == '\\')
            last = c + 1;
    return last;
}

/* Finds the path of a file beside the input. False: it has none. */
static bool library_path(const obj_reader *o, const char *name, char path[PATH_ROOM])
{
    const char *obj = o->r->in.source.path, *last = last_part(name);
    const char *slash = obj ? strrchr(obj, '/') : NULL;
    const int folder = slash ? (int)(slash + 1 - obj) : 0;
    return obj && *last && (size_t)snprintf(path, PATH_ROOM, "%.*s%s", folder, obj, last) < PATH_ROOM;
}

/* Reads the file of that name beside the input, if it exists. False: no memory. */
static bool read_library(obj_reader *o, const char *name, bool *found)
{
    char path[PATH_ROOM];
    struct stat about;
    bool good = true;
    *found = false;
    if (!library_path(o, name, path))
        return true;
    input_file f = {.descriptor = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    if (f.descriptor < 0)
        return true;
    if (fstat(f.descriptor, &about) == 0 && S_ISREG(about.st_mode)) {
        const input_source source = input_from_file(&f);
        good = obj_materials_read(&o->materials, &source);
        read_warn_colors(o->r->warnings, path, o->materials.first_odd, o->materials.odd);
        o->sorted = false;
        o->has_library = *found = true;
    }
    close(f.descriptor);
    return good;
}

/* Reads the libraries of mtllib: one name that may contain blanks, or several names. The first one that is missing is
 * recorded; if all are, the whole name. */
static bool read_libraries(obj_reader *o)
{
    char name[PATH_ROOM], words[PATH_ROOM], path[PATH_ROOM];
    const char *missing = NULL;
    bool found, any = false;
    take_name(&o->r->in, name, sizeof name);
    if (!read_library(o, name, &found))
        return false;
    if (found)
        return true;
    memcpy(words, name, sizeof words);
    for (char *rest = NULL, *one = strtok_r(words, " ", &rest); one; one = strtok_r(NULL, " ", &rest)) {
        if (!read_library(o, one, &found))
            return false;
        any |= found;
        if (!found && !missing)
            missing = one;
    }
    missing = any ? missing : name;
    return !missing || !library_path(o, missing, path) || mesh_missing(o->r->mesh, path);
}

static void use_material(obj_reader *o)
{
    char name[MESH_GROUP_NAME];
    take_name(&o->r->in, name, sizeof name);
    if (!o->sorted)
        obj_materials_sort(&o->materials);
    o->sorted = true;
    const roberts_color *color = obj_materials_color(&o->materials, name);
    o->color = color ? *color : (roberts_color){0};
    if (!color && o->has_library)
        note(o, &o->lacking, name, strlen(name));
}

/* ---- vertices -------------------------------------------------------------------------------------------------- */

static size_t vertices_read(const reader *r)
{
    return r->mesh->vertex_count - r->mark.vertices;
}

/* Reads a vertex. Three numbers are a position; a fourth is a weight; with six or seven numbers the last three are a
 * colour. */
static roberts_status read_vertex(reader *r)
{
    static const char *const part[POSITION] = {"x", "y", "z"};
    double value[NUMBERS_MOST];
    int count = 0;
    while (count < NUMBERS_MOST && next_word(&r->in) && number(&r->in, &value[count]))
        count++;
    if (count < POSITION)
        return read_expected(r, input_not_finite(&r->in) ? ROBERTS_BAD_NUMBER : ROBERTS_BAD_SYNTAX,
                             "%s of vertex %zu (counted from 0)", part[count], vertices_read(r));
    roberts_vec3 p = {value[0], value[1], value[2]};
    if (!mesh_position(p))
        return read_bad_position(r, vertices_read(r));
    if (!mesh_add_vertex(r->mesh, p))
        return error_no_memory(r->error);
    if (count < POSITION + COLOR)
        return ROBERTS_OK;
    const double *rgb = value + (count == POSITION + COLOR ? POSITION : POSITION + 1);
    roberts_color color = {.count = COLOR};
    for (int i = 0; i < COLOR; i++) {
        if (!(rgb[i] >= 0.0 && rgb[i] <= 1.0))
            return ROBERTS_OK; /* not a colour */
        color.value[i] = (float)rgb[i];
    }
    return mesh_color_vertex(r->mesh, r->mesh->vertex_count - 1, color, &r->vertices_filled)
               ? ROBERTS_OK
               : error_no_memory(r->error);
}

/* ---- faces and lines ------------------------------------------------------------------------------------------- */

/* Reads an integer of at most 18 digits, with or without a sign. Returns the character after it; NULL: there is
 * none. */
static const char *reference(const char *c, int64_t *value)
{
    bool negative = *c == '-';
    int64_t n = 0;
    c += *c == '-' || *c == '+';
    const char *first = c;
    for (; *c >= '0' && *c <= '9' && c - first < 18; c++)
        n = 10 * n + (*c - '0');
    *value = negative ? -n : n;
    return c > first ? c : NULL;
}

/* Reads v, v/vt, v/vt/vn or v//vn. */
static const char *corner(const char *c, int64_t *v)
{
    int64_t unused;
    c = reference(c, v);
    for (int i = 0; i < 2 && c && *c == '/'; i++) {
        const char *end = reference(c + 1, &unused);
        c = end ? end : c + 1;
    }
    return c;
}

/* What messages call the current element. */
typedef struct element_name {
    char text[64];
} element_name;

static element_name name_element(const obj_reader *o, bool face)
{
    element_name name = {"a line"};
    if (face)
        snprintf(name.text, sizeof name.text, "face %zu (counted from 0)", o->r->mesh->face_count - o->r->mark.faces);
    return name;
}

/* Reads the corner that is the whole word here. Records its vertex, since vertices may follow their faces. */
static roberts_status read_corner(obj_reader *o, bool face, uint32_t *vertex)
{
    reader *r = o->r;
    int64_t v, count = (int64_t)vertices_read(r);
    const char *end = corner(r->in.at, &v);
    if (!end || !input_separator(*end)) {
        size_t length = word_length(&r->in);
        end = length <= INPUT_TOKEN_MAX ? corner(r->in.at, &v) : NULL;
        if (end != r->in.at + length)
            return read_expected(r, ROBERTS_BAD_SYNTAX, "a corner of %s", name_element(o, face).text);
    }
    if (v == 0)
        return read_fail(r, ROBERTS_BAD_INDEX, "%s names vertex 0, but OBJ counts from 1", name_element(o, face).text);
    if (v < -count || v > (int64_t)MESH_MOST)
        return read_fail(r, ROBERTS_BAD_INDEX, "%s names vertex %lld, but there are %lld so far",
                         name_element(o, face).text, (long long)v, (long long)count);
    v = (int64_t)r->mark.vertices + (v < 0 ? v + count : v - 1);
    if (v > (int64_t)MESH_MOST)
        return error_no_memory(r->error);
    if (v > o->greatest) {
        o->greatest = v;
        o->greatest_line = r->in.line;
    }
    *vertex = (uint32_t)v;
    r->in.at = end;
    return ROBERTS_OK;
}

static roberts_status end_face(obj_reader *o)
{
    roberts_mesh *mesh = o->r->mesh;
    if (!mesh_end_face(mesh))
        return error_no_memory(o->r->error);
    if (o->color.count && !mesh_color_face(mesh, mesh->face_count - 1, o->color, &o->r->faces_filled))
        return error_no_memory(o->r->error);
    return ROBERTS_OK;
}

static roberts_status read_face(obj_reader *o)
{
    size_t count = 0;
    for (; next_word(&o->r->in); count++) {
        uint32_t v = 0;
        roberts_status status = read_corner(o, true, &v);
        if (status != ROBERTS_OK)
            return status;
        if (!mesh_add_corner(o->r->mesh, v))
            return error_no_memory(o->r->error);
    }
    if (count == 0)
        return read_expected(o->r, ROBERTS_BAD_SYNTAX, "a corner of %s", name_element(o, true).text);
    o->r->thin_faces += count < 3;
    return end_face(o);
}

static roberts_status read_line(obj_reader *o)
{
    roberts_mesh *mesh = o->r->mesh;
    uint32_t last = 0, v = 0;
    roberts_status status = ROBERTS_OK;
    for (size_t count = 0; status == ROBERTS_OK && next_word(&o->r->in); count++, last = v) {
        if ((status = read_corner(o, false, &v)) != ROBERTS_OK || count == 0)
            continue;
        if (!mesh_add_corner(mesh, last) || !mesh_add_corner(mesh, v))
            return error_no_memory(o->r->error);
        status = end_face(o);
    }
    return status;
}

/* ---- the whole file -------------------------------------------------------------------------------------------- */

static roberts_status read_group(obj_reader *o)
{
    char name[MESH_GROUP_NAME];
    take_name(&o->r->in, name, sizeof name);
    return mesh_group(o->r->mesh, name) ? ROBERTS_OK : error_no_memory(o->r->error);
}

/* Is this a known keyword that does not affect the drawing? */
static bool is_passed(input *in, size_t length)
{
    static const char *const passed[] = {"vn", "vt", "vp", "s", "p", "mg", "lod", "bevel", "c_interp", "d_interp"};
    for (size_t i = 0; i < sizeof passed / sizeof passed[0]; i++)
        if (is_word(in, length, passed[i]))
            return true;
    return false;
}

/* Reads the statement of a line, but not anything after it on the line. */
static roberts_status read_statement(obj_reader *o)
{
    input *in = &o->r->in;
    size_t length = word_length(in);
    const char first = *in->at;
    if (length == 1 && first == 'v') {
        in->at++;
        return read_vertex(o->r);
    }
    if (length == 1 && (first == 'f' || first == 'l')) {
        in->at++;
        return first == 'f' ? read_face(o) : read_line(o);
    }
    if (length == 1 && (first == 'o' || first == 'g')) {
        in->at++;
        return read_group(o);
    }
    if (length <= INPUT_TOKEN_MAX && is_word(in, length, "mtllib")) {
        in->at += length;
        return read_libraries(o) ? ROBERTS_OK : error_no_memory(o->r->error);
    }
    if (length <= INPUT_TOKEN_MAX && is_word(in, length, "usemtl")) {
        in->at += length;
        use_material(o);
    } else if (first != '#' && !(length <= INPUT_TOKEN_MAX && is_passed(in, length))) {
        note(o, &o->unknown, in->at, length);
    }
    return ROBERTS_OK;
}

/* Checks that every corner is an existing vertex, after all vertices have been read. */
static roberts_status check_corners(const obj_reader *o)
{
    reader *r = o->r;
    if (o->greatest < (int64_t)r->mesh->vertex_count)
        return ROBERTS_OK;
    return error_set(r->error, ROBERTS_BAD_INDEX, o->greatest_line,
                     "a face or line names vertex %llu, but there are %zu",
                     (unsigned long long)o->greatest - r->mark.vertices + 1, vertices_read(r));
}

roberts_status obj_read(reader *r)
{
    obj_reader o = {.r = r, .greatest = -1};
    roberts_status status = ROBERTS_OK;
    r->in.plain = true;
    while (status == ROBERTS_OK && input_skip(&r->in)) {
        status = read_statement(&o);
        if (status == ROBERTS_OK && !pass_line(&r->in))
            status = read_fail(r, ROBERTS_BAD_SYNTAX, "the line does not end");
    }
    if (status == ROBERTS_OK && (r->in.failure || r->in.too_blank))
        status = read_expected(r, ROBERTS_IO, "the end");
    if (status == ROBERTS_OK)
        status = check_corners(&o);
    if (status == ROBERTS_OK && o.unknown.count)
        warning_send(r->warnings, r->name, o.unknown.line, "%zu line%s ignored, the first with \"%s\"", o.unknown.count,
                     o.unknown.count == 1 ? "" : "s", o.unknown.word);
    if (status == ROBERTS_OK && o.lacking.count)
        warning_send(r->warnings, r->name, o.lacking.line,
                     "no colour for %zu use%s of materials that the .mtl files lack, the first of \"%s\"",
                     o.lacking.count, o.lacking.count == 1 ? "" : "s", o.lacking.word);
    obj_materials_free(&o.materials);
    return status;
}
