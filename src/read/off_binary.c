/* off_binary.c - vertices and faces as 32-bit words.
 *
 * Geomview writes big-endian words: [dimension] vertices faces edges; the floats of the vertices in the order of the
 * text form, with four for a colour; for each face the number of corners, the corners, the number of colour floats, and
 * these floats. Other programs write in the machine's own byte order, and some omit the number of colour floats. The
 * data decide: in the right order, the floats of the first vertices are sensible (if both or neither are, smaller
 * counts win), and a walk over the first faces shows whether the number is missing. */
#include "read/off.h"

#include <math.h>
#include <string.h>

static const size_t WORD = 4; /* bytes */

enum {
    VOTES = 64,       /* floats examined for the byte order */
    FACES_TRIED = 64, /* faces examined for the colours */
    LIKELY_CORNERS = 1 << 24,
    WORDS_AT_ONCE = 4096
};

typedef struct words {
    bool little;
    bool colors;     /* every face has its number of colour floats */
    int per_vertex;  /* number of floats */
    int coordinates; /* of these, the first 3 or 4 are coordinates */
} words;

static float float_of(uint32_t word)
{
    float value;
    memcpy(&value, &word, sizeof value);
    return value;
}

/* Takes one word. False: the input ends first. */
static bool next_word(reader *r, const words *w, uint32_t *word)
{
    if (!input_need(&r->in, WORD))
        return false;
    *word = read_word(r->in.at, w->little);
    r->in.at += WORD;
    return true;
}

/* Reports that the input ends in an item. count 0: there is only one of these, so it has no number. */
static roberts_status ends_in(reader *r, const char *what, uint64_t number, uint64_t count)
{
    if (r->in.failure)
        return read_expected(r, ROBERTS_IO, "%s", what);
    if (count == 0)
        return read_fail(r, ROBERTS_BAD_SYNTAX, "the input ends in %s", what);
    return read_fail(r, ROBERTS_BAD_SYNTAX, "the input ends in %s %llu of 0..%llu", what, (unsigned long long)number,
                     (unsigned long long)count - 1);
}

/* ---- byte order ------------------------------------------------------------------------------------------------ */

/* Is this a plausible size of a coordinate? 0 is inconclusive: it is 0 in either order. */
static bool likely(uint32_t word)
{
    double size = fabs((double)float_of(word));
    return size > 0x1p-40 && size < 0x1p40;
}

/* Is the order little-endian? Called at the first count. Examines only words that are in the vertices in either
 * order. */
static bool little_endian(reader *r, const words *w)
{
    uint64_t big = 0, little = 0, floats = VOTES;
    int votes = 0;
    const size_t counts = 3;
    if (!input_need(&r->in, counts * WORD))
        return false;
    for (size_t i = 0; i < 2; i++) {
        big += read_word(r->in.at + WORD * (size_t)i, false);
        little += read_word(r->in.at + WORD * (size_t)i, true);
        uint64_t most = (uint64_t)w->per_vertex * read_word(r->in.at, i);
        floats = most < floats ? most : floats;
    }
    input_need(&r->in, (counts + floats) * WORD); /* if the input ends before, fewer will do */
    for (size_t i = 0; i < floats && (counts + i + 1) * WORD <= (size_t)(r->in.end - r->in.at); i++) {
        const char *at = r->in.at + (counts + i) * WORD;
        votes += likely(read_word(at, true)) - likely(read_word(at, false));
    }
    return votes ? votes > 0 : little < big;
}

static roberts_status read_counts(reader *r, words *w)
{
    uint32_t count[3], dimension;
    if (r->off->header.dimension) {
        if (!input_need(&r->in, WORD))
            return ends_in(r, "its counts", 0, 0);
        dimension = read_word(r->in.at, false) <= UINT16_MAX ? read_word(r->in.at, false) : read_word(r->in.at, true);
        if (dimension != 3)
            return read_fail(r, ROBERTS_BAD_SYNTAX, "the dimension is %lu, but only 3 can be drawn",
                             (unsigned long)dimension);
        r->in.at += WORD;
    }
    w->little = little_endian(r, w);
    for (int i = 0; i < 3; i++) {
        if (!next_word(r, w, &count[i]))
            return ends_in(r, "its counts", 0, 0);
    }
    r->off->header.vertices = count[0];
    r->off->header.faces = count[1];
    return ROBERTS_OK;
}

/* ---- vertices -------------------------------------------------------------------------------------------------- */

static roberts_status read_vertex(reader *r, const words *w, uint64_t v)
{
    double p[4] = {0, 0, 0, 1};
    if (!input_need(&r->in, (size_t)w->per_vertex * WORD))
        return ends_in(r, "vertex", v, r->off->header.vertices);
    for (int i = 0; i < w->coordinates; i++)
        p[i] = read_float(r->in.at + WORD * (size_t)i, w->little);
    for (int i = 0; i < 3; i++) {
        p[i] /= p[3];
        if (!mesh_coordinate(p[i]))
            return read_fail(r, ROBERTS_BAD_NUMBER, "vertex %llu has a coordinate that is infinite or no number",
                             (unsigned long long)v);
    }
    if (!mesh_add_vertex(r->mesh, (roberts_vec3){p[0], p[1], p[2]}))
        return error_no_memory(r->error);
    roberts_status status = ROBERTS_OK;
    if (r->off->header.color) {
        off_color_numbers color = {.count = COLOR_MOST, .real = true};
        const char *at = r->in.at + WORD * (size_t)(w->coordinates + (r->off->header.normal ? 3 : 0));
        for (int i = 0; i < COLOR_MOST; i++)
            color.value[i] = read_float(at + WORD * (size_t)i, w->little);
        status = off_color_vertex(r, &color);
    }
    r->in.at += (size_t)w->per_vertex * WORD;
    return status;
}

/* ---- faces ----------------------------------------------------------------------------------------------------- */

/* Would a program write this as a colour's float? */
static bool color_float(uint32_t word)
{
    double value = float_of(word);
    return value == 0.0 ? word == 0 : value >= 0x1p-24 && value <= 255.0;
}

/* Can faces follow here, each with its number of colour floats, or each without? The input may end between two
 * faces. */
static bool faces_fit(reader *r, const words *w, bool colors)
{
    size_t at = 0;
    for (uint64_t f = 0; f < r->off->header.faces && f < FACES_TRIED; f++) {
        if (!input_need(&r->in, at + WORD))
            return f > 0 && (size_t)(r->in.end - r->in.at) == at;
        uint64_t count = read_word(r->in.at + at, w->little);
        size_t length = WORD * (1 + (size_t)count + colors);
        if (count > INPUT_BLOCK / WORD || at + length + COLOR_MOST * WORD > INPUT_BLOCK)
            return count < LIKELY_CORNERS; /* not in the buffer */
        if (!input_need(&r->in, at + length))
            return false;
        for (size_t i = 1; i <= count; i++) {
            if (read_word(r->in.at + at + WORD * (size_t)i, w->little) >= r->off->header.vertices)
                return false;
        }
        at += length;
        uint32_t floats = colors ? read_word(r->in.at + at - WORD, w->little) : 0;
        if (floats == 2 || floats > COLOR_MOST || !input_need(&r->in, at + WORD * (size_t)floats))
            return false;
        for (uint32_t i = 0; i < floats && floats >= 3; i++) {
            if (!color_float(read_word(r->in.at + at + WORD * (size_t)i, w->little)))
                return false;
        }
        at += WORD * (size_t)floats;
    }
    return true;
}

/* Reads the corners into the mesh; room grows as they come. */
static roberts_status read_corners(reader *r, const words *w, uint64_t f, uint64_t count)
{
    roberts_mesh *mesh = r->mesh;
    for (uint64_t done = 0, part; done < count; done += part) {
        part = count - done < WORDS_AT_ONCE ? count - done : WORDS_AT_ONCE;
        if (!input_need(&r->in, part * WORD))
            return ends_in(r, "face", f, r->off->header.faces);
        if (!mesh_corner_room(mesh, part))
            return error_no_memory(r->error);
        for (uint64_t i = 0; i < part; i++) {
            uint32_t index = read_word(r->in.at + WORD * (size_t)i, w->little);
            if (index >= r->off->header.vertices)
                return read_fail(r, ROBERTS_BAD_INDEX, "face %llu names vertex %lu, but there are %llu",
                                 (unsigned long long)f, (unsigned long)index,
                                 (unsigned long long)r->off->header.vertices);
            mesh->corner[mesh->corner_count + i] = (uint32_t)r->mark.vertices + index;
        }
        mesh->corner_count += part;
        r->in.at += part * WORD;
    }
    if (!mesh_end_face(mesh))
        return error_no_memory(r->error);
    r->thin_faces += count < 3;
    return ROBERTS_OK;
}

static roberts_status read_color(reader *r, const words *w, uint64_t f)
{
    off_color_numbers color = {.real = true};
    uint32_t count, word = 0;
    if (!next_word(r, w, &count))
        return ends_in(r, "face", f, r->off->header.faces);
    if (count > COLOR_MOST)
        return read_fail(r, ROBERTS_BAD_SYNTAX, "face %llu has %lu colour numbers, which are too many",
                         (unsigned long long)f, (unsigned long)count);
    for (; color.count < (int)count; color.count++) {
        if (!next_word(r, w, &word))
            return ends_in(r, "face", f, r->off->header.faces);
        color.value[color.count] = float_of(word);
    }
    if (count == 1 && word < UINT32_C(1) << 23)
        color.value[0] = word; /* an index is an integer, which as a float would be almost 0 */
    return count ? off_color_face(r, &color) : ROBERTS_OK;
}

static roberts_status read_faces(reader *r, words *w)
{
    w->colors = faces_fit(r, w, true) || !faces_fit(r, w, false);
    for (uint64_t f = 0; f < r->off->header.faces; f++) {
        uint32_t count;
        if (!input_need(&r->in, 1) && !r->in.failure)
            return ROBERTS_OK; /* there are fewer faces than declared */
        if (!next_word(r, w, &count))
            return ends_in(r, "face", f, r->off->header.faces);
        roberts_status status = read_corners(r, w, f, count);
        if (status == ROBERTS_OK && w->colors)
            status = read_color(r, w, f);
        if (status != ROBERTS_OK)
            return status;
    }
    return ROBERTS_OK;
}

roberts_status off_read_binary(reader *r)
{
    words w = {.coordinates = r->off->header.homogeneous ? 4 : 3};
    w.per_vertex = w.coordinates + (r->off->header.normal ? 3 : 0) + (r->off->header.color ? COLOR_MOST : 0) +
                   (r->off->header.texture ? 2 : 0);
    r->binary = true;
    roberts_status status = read_counts(r, &w);
    mesh_float32(r->mesh);
    for (uint64_t v = 0; status == ROBERTS_OK && v < r->off->header.vertices; v++)
        status = read_vertex(r, &w, v);
    if (status == ROBERTS_OK)
        status = read_faces(r, &w);
    if (status != ROBERTS_OK)
        return status;
    r->in.ended |= !r->in.source.to_end; /* as for text: the rest of the input may belong to someone else */
    while (input_need(&r->in, 1) && (input_separator(*r->in.at) || *r->in.at == '}'))
        r->in.at++;
    if (r->in.at < r->in.end)
        warning_send(r->warnings, r->name, 0, "data after the last face ignored");
    return ROBERTS_OK;
}
