/* read.c - a mesh from a function, a file or memory: format detection, and code shared by the readers of all
 * formats. */
#include "read/read.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "read/off.h"

/* ---- errors ---------------------------------------------------------------------------------------------------- */

roberts_status read_fail(reader *r, roberts_status status, const char *format, ...)
{
    char message[sizeof r->error->message];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    if (r->binary)
        return error_set(r->error, status, 0, "%s (byte %llu)", message, (unsigned long long)input_offset(&r->in));
    return error_set(r->error, status, r->in.line, "%s", message);
}

roberts_status read_expected(reader *r, roberts_status status, const char *format, ...)
{
    char wanted[120];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(wanted, sizeof wanted, format, arguments);
    va_end(arguments);
    if (r->binary && !r->in.failure)
        return read_fail(r, ROBERTS_BAD_SYNTAX, "%s expected, but the input ends before", wanted);
    const char *hint = status == ROBERTS_BAD_NUMBER ? "; it must be a finite number" : "";
    size_t length = r->off && !*hint ? input_token(&r->in) : 0;
    if (length > 0 && length <= INPUT_TOKEN_MAX)
        hint = off_explain_word(r->in.at, length);
    return input_expected(&r->in, r->error, status, r->in.line, wanted, hint);
}

roberts_status read_bad_position(reader *r, uint64_t v)
{
    return read_fail(r, ROBERTS_BAD_NUMBER, "vertex %llu has a coordinate that is infinite or beyond %g",
                     (unsigned long long)v, MESH_COORDINATE_MAX);
}

void read_warn_colors(const roberts_warnings *warnings, const char *name, size_t line, size_t count)
{
    if (count)
        warning_send(warnings, name, line, "%zu colour%s that make%s no sense ignored", count, count == 1 ? "" : "s",
                     count == 1 ? "s" : "");
}

/* Warns of faces with fewer than 3 corners, if there are any. OFF has its own warning: there they may be points and
 * lines. */
static void read_warn_thin(const roberts_warnings *warnings, const char *name, size_t count)
{
    if (count)
        warning_send(warnings, name, 0, "%zu face%s with fewer than 3 corners: %s nothing", count,
                     count == 1 ? "" : "s", count == 1 ? "it hides" : "they hide");
}

/* ---- words ----------------------------------------------------------------------------------------------------- */

void read_rest(reader *r, char *text, size_t room)
{
    size_t used = 0;
    while (input_skip_in_line(&r->in)) {
        size_t length = input_token(&r->in);
        if (length > INPUT_TOKEN_MAX)
            break;
        if (used && used + 1 < room)
            text[used++] = ' ';
        for (size_t i = 0; i < length && used + 1 < room; i++)
            text[used++] = r->in.at[i] ? r->in.at[i] : '?';
        r->in.at += length;
    }
    text[used] = '\0';
}

/* ---- which format ---------------------------------------------------------------------------------------------- */

#define BLENDER_COMMAND                                                                                                \
    "blender -b model.blend --python-expr \"import bpy; bpy.ops.wm.obj_export(filepath='model.obj', "                  \
    "forward_axis='Y', up_axis='Z')\""
#define SCAD_IMPORT(file) "echo 'import(\"" file "\");' | openscad -o model.stl -"
#define SCAD_COMMAND "openscad -o model.stl model.scad"

static const struct foreign {
    const char *begins, *format, *command;
    bool whole; /* the first word must be the whole word */
} foreign[] = {
    {"glTF", "glTF", "assimp export model.glb model.stl", false},
    {"\"", "JSON (as glTF is)", "assimp export model.gltf model.stl", false},
    {"BLENDER", "Blender's own format", BLENDER_COMMAND, false},
    {"\x28\xb5\x2f\xfd", "compressed by zstd (as Blender's files are)", BLENDER_COMMAND, false},
    {"Kaydara", "FBX", "assimp export model.fbx model.stl", true},
    {"#VRML", "VRML", "", false},
    {"PK", "a ZIP archive (as 3MF is)", SCAD_IMPORT("model.3mf"), false},
    {"ISO-10303-21", "STEP", "gmsh -2 model.step -o model.stl", false},
    {"module", "OpenSCAD", SCAD_COMMAND, true},
    {"function", "OpenSCAD", SCAD_COMMAND, true},
    {"use", "OpenSCAD", SCAD_COMMAND, true},
    {"include", "OpenSCAD", SCAD_COMMAND, true},
    {"//", "a program (as OpenSCAD's are)", SCAD_COMMAND, false},
    {"/*", "a program (as OpenSCAD's are)", SCAD_COMMAND, false},
    {"$f", "OpenSCAD", SCAD_COMMAND, false},
    {"cube(", "OpenSCAD", SCAD_COMMAND, false},
    {"sphere(", "OpenSCAD", SCAD_COMMAND, false},
    {"cylinder(", "OpenSCAD", SCAD_COMMAND, false},
    {"union(", "OpenSCAD", SCAD_COMMAND, false},
    {"difference(", "OpenSCAD", SCAD_COMMAND, false},
    {"intersection(", "OpenSCAD", SCAD_COMMAND, false},
    {"translate(", "OpenSCAD", SCAD_COMMAND, false},
    {"rotate(", "OpenSCAD", SCAD_COMMAND, false},
    {"linear_extrude(", "OpenSCAD", SCAD_COMMAND, false},
    {"$MeshFormat", "Gmsh", "gmsh -0 model.msh -o model.stl", true},
    {"MeshVersionFormatted", "Medit", "gmsh -0 model.mesh -o model.stl", true},
    {"LIST", "a Geomview LIST", "", true},
    {"MESH", "a Geomview MESH", "", true},
    {"roberts part", "a part of a drawing", "roberts --join -o drawing.svg part-*", true},
    {"roberts plan", "the plan of a drawing",
     "roberts --part 1/1 x.plan -o part-1 && roberts --join part-1 -o drawing.svg", true},
    {"<", "XML (as AMF, X3D and COLLADA are)", "", false},
    {"\xff\xfe", "text in UTF-16 (to be saved as UTF-8)", "", false},
    {"\xfe\xff", "text in UTF-16 (to be saved as UTF-8)", "", false},
};

roberts_status read_refuse_format(reader *r, const char *format, const char *command)
{
    return read_fail(r, ROBERTS_BAD_SYNTAX, "this is %s, but only OFF, STL, OBJ and PLY can be read%s%s", format,
                     *command ? "; to convert it: " : "", command);
}

/* The command has the name of the input, if that is one of gzip's and a shell takes it as it is. */
static roberts_status refuse_compressed(reader *r)
{
    static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+./";
    char command[128];
    const size_t length = strlen(r->name);
    const bool own = length > 3 && length < 100 && strcmp(r->name + length - 3, ".gz") == 0 && *r->name != '-' &&
                     strspn(r->name, plain) == length;
    snprintf(command, sizeof command, "gzip -dc %s | roberts -", own ? r->name : "model.off.gz");
    return read_refuse_format(r, "compressed, as by gzip", command);
}

roberts_status read_refuse_foreign(reader *r, size_t length)
{
    if (input_need(&r->in, 1) && *r->in.at == '\x1f')
        return refuse_compressed(r);
    for (size_t i = 0; i < sizeof foreign / sizeof foreign[0]; i++) {
        const size_t first = strcspn(foreign[i].begins, " "), wanted = strlen(foreign[i].begins);
        if ((foreign[i].whole ? length == first : length >= first) && input_need(&r->in, wanted) &&
            memcmp(r->in.at, foreign[i].begins, wanted) == 0)
            return read_refuse_format(r, foreign[i].format, foreign[i].command);
    }
    return ROBERTS_OK;
}

enum { LOOK = 512 };

/* Does the input have the length of binary STL with that many triangles? */
static bool has_size_of_stl(reader *r)
{
    const input_source *source = &r->in.source;
    if (!source->read_at || source->size < STL_FIRST || !input_need(&r->in, STL_FIRST))
        return false;
    const uint64_t count = read_word(r->in.at + STL_HEADER, true);
    return count > 0 && source->size == STL_FIRST + STL_TRIANGLE * count;
}

/* Does one of these bytes occur in no text? */
static bool looks_binary(const char *bytes, size_t count)
{
    for (const char *c = bytes; c < bytes + count; c++)
        if ((unsigned char)*c < ' ' && !(*c >= '\t' && *c <= '\r'))
            return true;
    return false;
}

static size_t at_hand(const input *in)
{
    return (size_t)(in->end - in->at);
}

/* Are these bytes, which begin with "solid", binary? A name may have control characters, but then a line with the first
 * word of a facet follows, or with the end. */
static bool solid_is_binary(const char *bytes, size_t count)
{
    const char *line = memchr(bytes, '\n', count), *end = bytes + count;
    while (line && line < end && (*line == ' ' || (*line >= '\t' && *line <= '\r')))
        line++;
    const size_t rest = line ? (size_t)(end - line) : 0;
    if ((rest >= 5 && memcmp(line, "facet", 5) == 0) || (rest >= 8 && memcmp(line, "endsolid", 8) == 0))
        return false;
    return looks_binary(bytes, count);
}

static bool is_obj_word(const char *word, size_t length)
{
    static const char *const words[] = {"v", "vn", "vt", "vp", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl"};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (strlen(words[i]) == length && memcmp(word, words[i], length) == 0)
            return true;
    return false;
}

/* May OFF or OBJ as text begin with the word here? */
static bool begins_text(input *in)
{
    const size_t length = input_need(in, 1) ? input_token(in) : 0;
    return length > 0 && length <= INPUT_TOKEN_MAX &&
           ((*in->at && strchr("#{0123456789", *in->at)) || input_separator(*in->at) ||
            off_is_keyword(in->at, length) || is_obj_word(in->at, length));
}

/* Makes the header and the count of binary STL available. False: they do not come, or a line of text ends before. A
 * small model may end there, and its sender may be waiting for an answer, so no more is requested. */
static bool need_stl_header(input *in)
{
    const bool text = begins_text(in);
    for (size_t i = 0; i < STL_FIRST; i++) {
        if (!input_need(in, i + 1) || (text && (in->at[i] == '\n' || in->at[i] == '\r') && !looks_binary(in->at, i)))
            return false;
    }
    return true;
}

/* Do the bytes begin a binary format that is not supported? (Binary OFF begins with a line of text.) */
static bool begins_foreign_binary(const char *bytes)
{
    static const char *const begins[] = {"PK\x03\x04", "\x1f\x8b",    "\xff\xfe",
                                         "\xfe\xff",   "$MeshFormat", "roberts p"}; /* see part/rows.h, part/plan.h */
    for (size_t i = 0; i < sizeof begins / sizeof begins[0]; i++)
        if (memcmp(bytes, begins[i], strlen(begins[i])) == 0)
            return true;
    return false;
}

/* Is it binary STL without triangles? Other formats can have that length and zeros at their end, too. */
static bool is_empty_stl(reader *r)
{
    input *in = &r->in;
    if (!in->source.read_at || in->source.size != STL_FIRST || !input_need(in, STL_FIRST) ||
        read_word(in->at + STL_HEADER, true) != 0)
        return false;
    return !begins_text(in) && memcmp(in->at, "ply", 3) != 0 && !begins_foreign_binary(in->at) &&
           read_refuse_foreign(r, input_token(in)) == ROBERTS_OK;
}

/* Can an input of unknown or wrong length still be binary STL, whatever its header says? It can if the count has a byte
 * that no text has, and if the available part of the first triangle has corners of a sensible size. */
static bool looks_like_stl(reader *r)
{
    input *in = &r->in;
    if (!need_stl_header(in) || !looks_binary(in->at + STL_HEADER, STL_FIRST - STL_HEADER) ||
        read_word(in->at + STL_HEADER, true) == 0 || begins_foreign_binary(in->at))
        return false;
    (void)input_need(in, STL_FIRST + STL_TRIANGLE);
    for (size_t i = 3; i < 12 && STL_FIRST + 4 * (i + 1) <= at_hand(in); i++) { /* after the normal */
        const float size = fabsf(read_float(in->at + STL_FIRST + 4 * i, true));
        if (!(size < 1e15f) || (size > 0.0f && size < 1e-30f))
            return false;
    }
    return true;
}

/* Reads the format indicated by the first bytes. OFF, which may begin with a number, is the default; its reader refuses
 * anything that is none of these. */
static roberts_status read_any(reader *r, const off_division *division)
{
    input *in = &r->in;
    if (has_size_of_stl(r) || is_empty_stl(r))
        return stl_read_binary(r);
    if (input_need(in, 3) && memcmp(in->at, "\xef\xbb\xbf", 3) == 0)
        in->at += 3; /* a byte-order mark */
    if (looks_like_stl(r))
        return stl_read_binary(r);
    const size_t first = input_need(in, 1) ? input_token(in) : 0;
    if (input_need(in, 1) && *in->at == '#' && input_need(in, 5) && memcmp(in->at, "#VRML", 5) == 0)
        return read_refuse_foreign(r, 5); /* it looks like a comment */
    if (first == 3 && memcmp(in->at, "ply", 3) == 0)
        return ply_read(r);
    if (input_at_word(in, "solid")) {
        (void)input_need(in, LOOK);
        if (solid_is_binary(in->at, at_hand(in) < LOOK ? at_hand(in) : LOOK))
            return stl_read_binary(r);
    }
    if (!input_skip(in))
        return off_read(r, division);
    if (input_at_word(in, "solid"))
        return stl_read_text(r);
    const size_t length = input_token(in);
    return is_obj_word(in->at, length) ? obj_read(r) : off_read(r, division);
}

/* Reads a pipe to its end, so that its writer can end well. */
static roberts_status read_rest_of_pipe(reader *r)
{
    input_drain(&r->in);
    return r->in.failure ? read_expected(r, ROBERTS_IO, "the end") : ROBERTS_OK;
}

/* ---- sources --------------------------------------------------------------------------------------------------- */

roberts_status read_mesh(roberts_mesh *mesh, const char *name, const input_source *source, const off_division *division,
                         const roberts_warnings *warnings, roberts_error *error)
{
    roberts_status status = ROBERTS_NO_MEMORY;
    reader r = {.mesh = mesh,
                .mark = mesh_here(mesh),
                .name = name,
                .warnings = warnings,
                .error = error,
                .vertices_filled = mesh->vertex_color ? mesh->vertex_count : 0,
                .faces_filled = mesh->face_color ? mesh->face_count : 0};
    if (input_open(&r.in, source) && mesh_source(mesh, name))
        status = read_any(&r, division);
    if (status == ROBERTS_OK && source->to_end && !source->read_at)
        status = read_rest_of_pipe(&r);
    if (status == ROBERTS_OK && !mesh_color_rest(mesh, r.vertices_filled, r.faces_filled))
        status = ROBERTS_NO_MEMORY;
    if (status == ROBERTS_NO_MEMORY)
        error_no_memory(error);
    if (status == ROBERTS_OK)
        read_warn_thin(warnings, name, r.thin_faces);
    input_close(&r.in);
    if (status == ROBERTS_OK)
        return ROBERTS_OK;
    mesh_back(mesh, r.mark);
    return error_in(error, name, status);
}

static roberts_status read_source(roberts_mesh *mesh, const char *name, const input_source *source,
                                  const roberts_warnings *warnings, roberts_error *error)
{
    off_division division = off_divide(mesh->threads);
    return read_mesh(mesh, name ? name : "", source, &division, warnings, error);
}

roberts_status roberts_mesh_read(roberts_mesh *mesh, const char *name, roberts_read_fn *read, void *context,
                                 const roberts_warnings *warnings, roberts_error *error)
{
    const input_source source = {.read = read, .context = context};
    return read_source(mesh, name, &source, warnings, error);
}

roberts_status roberts_mesh_read_file(roberts_mesh *mesh, const char *path, const roberts_warnings *warnings,
                                      roberts_error *error)
{
    bool standard = strcmp(path, "-") == 0;
    const char *name = standard ? "standard input" : path;
    input_file f = {.descriptor = standard ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC)};
    if (f.descriptor < 0) {
        char reason[128];
        if (strerror_r(errno, reason, sizeof reason) != 0)
            snprintf(reason, sizeof reason, "it cannot be opened");
        return error_in(error, name, error_set(error, ROBERTS_IO, 0, "%s", reason));
    }
    input_source source = input_from_file(&f);
    source.path = standard ? NULL : path;
    roberts_status status = read_source(mesh, name, &source, warnings, error);
    if (!standard)
        close(f.descriptor);
    return status;
}

roberts_status roberts_mesh_read_memory(roberts_mesh *mesh, const char *name, const void *bytes, size_t size,
                                        const roberts_warnings *warnings, roberts_error *error)
{
    input_memory m = {bytes, size, 0};
    const input_source source = input_from_memory(&m);
    return read_source(mesh, name, &source, warnings, error);
}
