/* stl.c - STL: triangles without shared vertices, as text or binary.
 *
 * Text is "solid NAME", facets, "endsolid", any number of times; each solid is a group of that name. Binary is 80
 * arbitrary bytes, the number n of triangles, and 50 bytes for each: a normal, three corners (little-endian floats),
 * and two bytes that every program uses differently. Its length of 84 + 50 n bytes distinguishes it from text, since
 * many programs begin the 80 bytes with "solid".
 *
 * Corners with equal positions become one vertex, numbered by its first appearance. This is done within each solid,
 * since solids that touch are still two solids. Normals are not read; winding and planes follow from the corners. */
#include "read/read.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/vec.h"

enum { FLOAT = 4, POINT = 3 * FLOAT, LEAST_CORNERS = 3, AT_ONCE = 32 };

/* ---- equal positions ------------------------------------------------------------------------------------------- */

/* The vertices of one group by position: a hash table with open addressing (D. E. Knuth, The Art of Computer
 * Programming 3, 6.4, algorithm L), at most half full. */
typedef struct position_table {
    uint32_t *slot;     /* [size] vertex + 1; 0: empty */
    size_t size, count; /* size: 0 or a power of two */
    size_t first;       /* earlier vertices belong to other groups */
} position_table;

static uint64_t position_hash(roberts_vec3 p)
{
    uint64_t word[3], hash = 0;
    memcpy(word, &p, sizeof word);
    for (int i = 0; i < 3; i++) {
        hash = (hash ^ word[i]) * UINT64_C(0x9e3779b97f4a7c15);
        hash ^= hash >> 32;
    }
    return hash * UINT64_C(0x9e3779b97f4a7c15) >> 20;
}

/* Returns the slot to try first. */
static size_t home(const position_table *t, uint64_t hash)
{
    return (size_t)hash & (t->size - 1);
}

/* Returns the slot that contains p, or the empty one where p belongs. */
static size_t find_slot(const position_table *t, const roberts_mesh *mesh, roberts_vec3 p, uint64_t hash)
{
    size_t i = home(t, hash);
    while (t->slot[i] && !vec3_same(mesh->vertex[t->slot[i] - 1], p))
        i = (i + 1) & (t->size - 1);
    return i;
}

/* Makes room for `more` positions. False: no memory. */
static bool reserve(position_table *t, const roberts_mesh *mesh, size_t more)
{
    if (2 * (t->count + more) <= t->size)
        return true;
    position_table larger = {.size = t->size ? 2 * t->size : 1024, .count = t->count, .first = t->first};
    larger.slot = alloc_zeroed(larger.size, sizeof *larger.slot);
    if (!larger.slot)
        return false;
    for (size_t v = t->first; v < mesh->vertex_count; v++)
        larger.slot[find_slot(&larger, mesh, mesh->vertex[v], position_hash(mesh->vertex[v]))] = (uint32_t)v + 1;
    free(t->slot);
    *t = larger;
    return true;
}

/* Starts another group. */
static void start_group(position_table *t, const roberts_mesh *mesh)
{
    if (t->count)
        memset(t->slot, 0, t->size * sizeof *t->slot);
    t->count = 0;
    t->first = mesh->vertex_count;
}

/* Turns -0 into +0: they are the same position. */
static roberts_vec3 without_sign_of_zero(roberts_vec3 p)
{
    return (roberts_vec3){p.x + 0.0, p.y + 0.0, p.z + 0.0};
}

/* Adds the vertex at p, if it is new, as a corner of the current face. The table has room. False: no memory. */
static bool add_corner(roberts_mesh *mesh, position_table *t, roberts_vec3 p, uint64_t hash)
{
    size_t i = find_slot(t, mesh, p, hash);
    if (!t->slot[i]) {
        if (!mesh_add_vertex(mesh, p))
            return false;
        t->slot[i] = (uint32_t)mesh->vertex_count;
        t->count++;
    }
    return mesh_add_corner(mesh, t->slot[i] - 1);
}

/* ---- text ------------------------------------------------------------------------------------------------------ */

static size_t facets_read(const reader *r)
{
    return r->mesh->face_count - r->mark.faces;
}

static roberts_status missing(reader *r, const char *word)
{
    return read_expected(r, ROBERTS_BAD_SYNTAX, "%s of facet %zu", word, facets_read(r));
}

/* Takes one word of the facet. */
static roberts_status take_word(reader *r, const char *word)
{
    if (!input_skip(&r->in) || !input_at_word(&r->in, word))
        return missing(r, word);
    input_pass_token(&r->in);
    return ROBERTS_OK;
}

/* Skips the normal, whatever it contains, up to "outer". */
static roberts_status skip_normal(reader *r)
{
    enum { MOST = 4 }; /* "normal" and three numbers */
    for (int i = 0; i < MOST && input_skip(&r->in) && !input_at_word(&r->in, "outer"); i++)
        input_pass_token(&r->in);
    return take_word(r, "outer");
}

/* Reports a missing coordinate; the corner began on this line. A word on a later line belongs to something else. */
static roberts_status no_coordinate(reader *r, const char *part, size_t line)
{
    const bool infinite = input_not_finite(&r->in);
    if (r->in.line > line && input_token(&r->in) > 0 && !infinite)
        return error_set(r->error, ROBERTS_BAD_SYNTAX, line,
                         "%s of a corner of facet %zu expected, but the line ends here", part, facets_read(r));
    return read_expected(r, infinite ? ROBERTS_BAD_NUMBER : ROBERTS_BAD_SYNTAX, "%s of a corner of facet %zu", part,
                         facets_read(r));
}

static roberts_status read_corner(reader *r, position_table *t)
{
    static const char *const part[3] = {"x", "y", "z"};
    const size_t line = r->in.line;
    double p[3];
    for (int i = 0; i < 3; i++) {
        if (!input_skip(&r->in) || !input_number(&r->in, &p[i]))
            return no_coordinate(r, part[i], line);
    }
    if (!mesh_position((roberts_vec3){p[0], p[1], p[2]}))
        return read_bad_position(r, r->mesh->vertex_count - r->mark.vertices);
    const roberts_vec3 at = without_sign_of_zero((roberts_vec3){p[0], p[1], p[2]});
    const bool good = reserve(t, r->mesh, 1) && add_corner(r->mesh, t, at, position_hash(at));
    return good ? ROBERTS_OK : error_no_memory(r->error);
}

/* Reads a facet after its first word. */
static roberts_status read_facet(reader *r, position_table *t)
{
    roberts_status status = skip_normal(r);
    size_t corners = 0;
    if (status == ROBERTS_OK)
        status = take_word(r, "loop");
    for (; status == ROBERTS_OK && input_skip(&r->in) && input_at_word(&r->in, "vertex"); corners++) {
        input_pass_token(&r->in);
        status = read_corner(r, t);
    }
    if (status == ROBERTS_OK && corners < LEAST_CORNERS)
        status = missing(r, "vertex");
    if (status == ROBERTS_OK)
        status = take_word(r, "endloop");
    if (status == ROBERTS_OK)
        status = take_word(r, "endfacet");
    if (status == ROBERTS_OK && !mesh_end_face(r->mesh))
        status = error_no_memory(r->error);
    return status;
}

/* Reads from "solid" to "endsolid", both with the rest of their lines. */
static roberts_status read_solid(reader *r, position_table *t, bool *ended)
{
    char name[MESH_GROUP_NAME];
    roberts_status status = ROBERTS_OK;
    input_pass_token(&r->in);
    read_rest(r, name, sizeof name);
    if (!mesh_group(r->mesh, name))
        return error_no_memory(r->error);
    start_group(t, r->mesh);
    *ended = false;
    while (status == ROBERTS_OK && input_skip(&r->in)) {
        *ended = input_at_word(&r->in, "endsolid");
        if (!*ended && !input_at_word(&r->in, "facet"))
            return read_expected(r, ROBERTS_BAD_SYNTAX, "facet or endsolid");
        input_pass_token(&r->in);
        if (*ended)
            return input_pass_line(&r->in) ? ROBERTS_OK : read_fail(r, ROBERTS_BAD_SYNTAX, "the line does not end");
        status = read_facet(r, t);
    }
    return status;
}

roberts_status stl_read_text(reader *r)
{
    position_table table = {0};
    roberts_status status = ROBERTS_OK;
    bool ended = true;
    r->in.plain = true;
    while (status == ROBERTS_OK && ended && input_skip(&r->in)) {
        if (input_at_word(&r->in, "solid")) {
            status = read_solid(r, &table, &ended);
        } else {
            warning_send(r->warnings, r->name, r->in.line, "text after the last solid ignored");
            break;
        }
    }
    free(table.slot);
    if (status == ROBERTS_OK && r->in.failure)
        return read_expected(r, ROBERTS_IO, "endsolid");
    if (status == ROBERTS_OK && !ended)
        warning_send(r->warnings, r->name, 0, "there is no endsolid at the end: is the file complete?");
    return status;
}

/* ---- binary ---------------------------------------------------------------------------------------------------- */

static roberts_status ends_early(reader *r, uint64_t triangle, uint64_t count)
{
    return read_expected(r, ROBERTS_BAD_SYNTAX, "triangle %llu of 0..%llu", (unsigned long long)triangle,
                         (unsigned long long)count - 1);
}

/* Reads `count` triangles from the buffer; at most AT_ONCE. It prefetches all their slots in the table before it needs
 * the first one. In a large model each comes from main memory, and this saves a quarter of the time. */
static roberts_status read_triangles(reader *r, position_table *t, size_t count)
{
    roberts_vec3 p[3 * AT_ONCE];
    uint64_t hash[3 * AT_ONCE];
    if (!reserve(t, r->mesh, 3 * count))
        return error_no_memory(r->error);
    for (size_t i = 0; i < 3 * count; i++) {
        const char *at = r->in.at + i / 3 * STL_TRIANGLE + POINT + i % 3 * POINT; /* the normal comes first */
        p[i] = (roberts_vec3){read_float(at, true), read_float(at + FLOAT, true),
                              read_float(at + 2 * (size_t)FLOAT, true)};
        if (!mesh_position(p[i])) {
            r->in.at += i / 3 * STL_TRIANGLE;
            return read_fail(r, ROBERTS_BAD_NUMBER, "triangle %zu has a coordinate that is infinite or no number",
                             facets_read(r) + i / 3);
        }
        p[i] = without_sign_of_zero(p[i]);
        hash[i] = position_hash(p[i]);
        FETCH_AHEAD(&t->slot[home(t, hash[i])]);
    }
    for (size_t i = 0; i < 3 * count; i++)
        if (t->slot[home(t, hash[i])])
            FETCH_AHEAD(&r->mesh->vertex[t->slot[home(t, hash[i])] - 1]);
    for (size_t i = 0; i < 3 * count; i++)
        if (!add_corner(r->mesh, t, p[i], hash[i]) || (i % 3 == 2 && !mesh_end_face(r->mesh)))
            return error_no_memory(r->error);
    r->in.at += count * STL_TRIANGLE;
    return ROBERTS_OK;
}

roberts_status stl_read_binary(reader *r)
{
    position_table table = {.first = r->mesh->vertex_count};
    roberts_status status = ROBERTS_OK;
    r->binary = true;
    if (!input_need(&r->in, STL_FIRST))
        return read_expected(r, ROBERTS_BAD_SYNTAX, "the number of triangles");
    const uint64_t count = read_word(r->in.at + STL_HEADER, true);
    r->in.at += STL_FIRST;
    mesh_float32(r->mesh);
    if (count == 0)
        warning_send(r->warnings, r->name, 0, "this is binary STL without triangles");
    for (uint64_t done = 0; done < count && status == ROBERTS_OK;) {
        size_t part = count - done < AT_ONCE ? (size_t)(count - done) : AT_ONCE;
        if (!input_need(&r->in, part * STL_TRIANGLE))
            part = (size_t)(r->in.end - r->in.at) / STL_TRIANGLE; /* the part available before its end */
        status = part ? read_triangles(r, &table, part) : ends_early(r, done, count);
        done += part;
    }
    free(table.slot);
    r->in.ended |= !r->in.source.to_end; /* the rest of the input may belong to someone else */
    if (status == ROBERTS_OK && input_need(&r->in, 1))
        warning_send(r->warnings, r->name, 0, "data after the last triangle ignored");
    return status;
}
