/* mesh.c - the mesh as a container: appending, rolling back, releasing. */
#include "read/mesh.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/box.h"
#include "base/error.h"
#include "base/vec.h"

/* ---- rounded coordinates: see mesh_rounding() ---- */

enum {
    DECIMAL_DIGITS = 9,   /* enough to tell 32-bit floats apart. A double that was not rounded has up to 17 */
    DECIMAL_SAMPLE = 1000 /* the most vertices that are examined, evenly spaced in the list */
};

/* Model units: multiples of this, such as 0.5 and 0.375, are exact and do not count as rounded. */
static const double EXACT = 0x1p-20;

/* Part of a number: one this near to a whole one counts as whole. The powers and products of digit_count() are off by
 * less. A 32-bit float is off by far more from the decimal that it stands for. */
static const double DIGIT_ERROR = 4e-15;

/* Part of the size (the diagonal of the box): the largest step. On a large sheet, this is less than a tenth of a pen.
 */
static const double DECIMAL_MOST = 1e-4;

mesh_mark mesh_here(const roberts_mesh *mesh)
{
    return (mesh_mark){.vertices = mesh->vertex_count,
                       .faces = mesh->face_count,
                       .corners = mesh->corner_count,
                       .sources = mesh->source_count,
                       .groups = mesh->group_count,
                       .has_vertex = mesh->vertex,
                       .has_start = mesh->face_start,
                       .has_corner = mesh->corner,
                       .has_vertex_color = mesh->vertex_color,
                       .has_face_color = mesh->face_color,
                       .has_source = mesh->source,
                       .has_group = mesh->group};
}

/* Releases an array that did not exist before. */
static void drop(bool keep, void *array, size_t *room)
{
    void *none = NULL, *old;
    if (keep)
        return;
    memcpy(&old, array, sizeof old); /* `array` points to a pointer of any type, as in array_reserve() */
    free(old);
    memcpy(array, &none, sizeof none);
    *room = 0;
}

void mesh_back(roberts_mesh *mesh, mesh_mark mark)
{
    while (mesh->source_count > mark.sources) {
        free(mesh->source[--mesh->source_count].name);
        free(mesh->source[mesh->source_count].missing);
    }
    while (mesh->group_count > mark.groups)
        free(mesh->group[--mesh->group_count].name);
    mesh->vertex_count = mark.vertices;
    mesh->face_count = mark.faces;
    mesh->corner_count = mark.corners;
    drop(mark.has_vertex, &mesh->vertex, &mesh->vertex_room);
    drop(mark.has_start, &mesh->face_start, &mesh->face_room);
    drop(mark.has_corner, &mesh->corner, &mesh->corner_room);
    drop(mark.has_vertex_color, &mesh->vertex_color, &mesh->vertex_color_room);
    drop(mark.has_face_color, &mesh->face_color, &mesh->face_color_room);
    drop(mark.has_source, &mesh->source, &mesh->source_room);
    drop(mark.has_group, &mesh->group, &mesh->group_room);
}

/* Like array_reserve(), but with room for no more than uint32_t can number. So a count below the room needs no other
 * check. */
static bool reserve(void *array, size_t *room, size_t need, size_t most, size_t size)
{
    if (need > most || !array_reserve(array, room, need, size))
        return false;
    if (*room > most)
        *room = most; /* the rest of the block is never used */
    return true;
}

bool mesh_more_vertices(roberts_mesh *mesh)
{
    return reserve(&mesh->vertex, &mesh->vertex_room, mesh->vertex_count + 1, MESH_MOST, sizeof *mesh->vertex);
}

bool mesh_more_faces(roberts_mesh *mesh)
{
    if (!reserve(&mesh->face_start, &mesh->face_room, mesh->face_count + 2, MESH_MOST, sizeof *mesh->face_start))
        return false;
    if (mesh->face_count == 0)
        mesh->face_start[0] = 0;
    return true;
}

bool mesh_more_corners(roberts_mesh *mesh, size_t more)
{
    return more <= UINT32_MAX - mesh->corner_count &&
           reserve(&mesh->corner, &mesh->corner_room, mesh->corner_count + more, UINT32_MAX, sizeof *mesh->corner);
}

bool mesh_room(roberts_mesh *mesh, size_t vertices, size_t faces, size_t corners)
{
    if (!reserve(&mesh->vertex, &mesh->vertex_room, vertices, MESH_MOST, sizeof *mesh->vertex) ||
        !reserve(&mesh->corner, &mesh->corner_room, corners, UINT32_MAX, sizeof *mesh->corner))
        return false;
    if (faces == 0)
        return true;
    if (!reserve(&mesh->face_start, &mesh->face_room, faces + 1, MESH_MOST, sizeof *mesh->face_start))
        return false;
    if (mesh->face_count == 0)
        mesh->face_start[0] = 0;
    return true;
}

/* Makes room for `count` colours; those from `filled` on are "none". */
static bool fill_colors(roberts_color **color, size_t *room, size_t filled, size_t count)
{
    if (!array_reserve(color, room, count, sizeof **color))
        return false;
    for (size_t i = filled; i < count; i++)
        (*color)[i] = (roberts_color){0};
    return true;
}

bool mesh_color_vertex(roberts_mesh *mesh, size_t index, roberts_color color, size_t *filled)
{
    if (!fill_colors(&mesh->vertex_color, &mesh->vertex_color_room, *filled, index + 1))
        return false;
    mesh->vertex_color[index] = color;
    *filled = index + 1;
    return true;
}

bool mesh_color_face(roberts_mesh *mesh, size_t index, roberts_color color, size_t *filled)
{
    if (!fill_colors(&mesh->face_color, &mesh->face_color_room, *filled, index + 1))
        return false;
    mesh->face_color[index] = color;
    *filled = index + 1;
    return true;
}

bool mesh_color_rest(roberts_mesh *mesh, size_t vertices_filled, size_t faces_filled)
{
    if (mesh->vertex_color &&
        !fill_colors(&mesh->vertex_color, &mesh->vertex_color_room, vertices_filled, mesh->vertex_count))
        return false;
    return !mesh->face_color || fill_colors(&mesh->face_color, &mesh->face_color_room, faces_filled, mesh->face_count);
}

/* Copies a name. NULL: no memory. */
static char *copy_name(const char *name)
{
    size_t size = strlen(name) + 1;
    char *copy = alloc_array(size, 1);
    if (copy)
        memcpy(copy, name, size);
    return copy;
}

bool mesh_source(roberts_mesh *mesh, const char *name)
{
    if (mesh->group_count && !mesh_group(mesh, "")) /* groups of earlier inputs end here */
        return false;
    if (!array_reserve(&mesh->source, &mesh->source_room, mesh->source_count + 1, sizeof *mesh->source))
        return false;
    char *copy = copy_name(name);
    if (!copy)
        return false;
    mesh->source[mesh->source_count++] = (roberts_source){
        .name = copy, .first_vertex = (uint32_t)mesh->vertex_count, .first_face = (uint32_t)mesh->face_count};
    return true;
}

void mesh_float32(roberts_mesh *mesh)
{
    mesh->source[mesh->source_count - 1].float32 = true;
}

bool mesh_missing(roberts_mesh *mesh, const char *path)
{
    roberts_source *source = &mesh->source[mesh->source_count - 1];
    if (!source->missing)
        source->missing = copy_name(path);
    return source->missing;
}

/* Returns how many decimal digits x > 0 has; DECIMAL_DIGITS + 1: more than count as rounded. */
static int digit_count(double x)
{
    int count = 1;
    double y = x * pow(10.0, -floor(log10(x)));
    for (; count <= DECIMAL_DIGITS && !(fabs(y - rint(y)) <= DIGIT_ERROR * y); count++)
        y *= 10.0;
    return count;
}

/* Returns the unit of the last of so many decimal digits of x > 0. */
static double digit_unit(double x, int digits)
{
    return pow(10.0, floor(log10(x)) + 1 - digits);
}

/* Returns two units of the last place of a 32-bit float as large as x > 0. */
static double float32_units(double x)
{
    int exponent;
    frexp(x, &exponent); /* 2^(exponent - 1) <= x, and the last of 24 bits is 2^-23 of that */
    return ldexp(2.0, exponent - FLT_MANT_DIG);
}

/* Is x > 0, which has so many digits, what a 32-bit float shows in that many? Beyond floats, all doubles are exact. */
static bool shows_float32(double x, int digits)
{
    return fabs((double)(float)x - x) <= 0.5 * digit_unit(x, digits) + DIGIT_ERROR * x;
}

/* Returns two units of the last place of coordinates that were rounded to decimals. 0: they were not, or so coarsely
 * that a picture would show such a touching distance. The last place is that of the last digit. But the decimals may
 * be 32-bit floats, printed in up to nine digits: then each shows what its float does, and the last place is that of
 * the float if it is coarser. Decimals of six or seven digits always pass as floats, and are coarser. With eight digits
 * nearly half of them pass by chance, with nine every twentieth: so even a few coordinates tell. With more digits, they
 * are no decimals; but if all are floats to the last bit, that is no chance. Then exact ones count, too: from 8 on,
 * every float is one. */
static double decimal_step(const roberts_vec3 *vertex, size_t count)
{
    int digits = 0;
    bool floats = true, in_full = false;
    double largest = 0.0, largest_of_all = 0.0;
    roberts_vec3 low = vertex[0], high = vertex[0];
    for (size_t i = 0; i < count; i += count / DECIMAL_SAMPLE + 1) {
        const double coordinate[] = {fabs(vertex[i].x), fabs(vertex[i].y), fabs(vertex[i].z)};
        box_add(&low, &high, vertex[i]);
        for (int k = 0; k < 3; k++) {
            double multiple = coordinate[k] / EXACT;
            largest_of_all = greater(largest_of_all, coordinate[k]);
            if (multiple == rint(multiple))
                continue;
            int own = digit_count(coordinate[k]);
            if (own > DECIMAL_DIGITS) {
                if ((double)(float)coordinate[k] != coordinate[k])
                    return 0.0;
                in_full = true;
                continue;
            }
            digits = own > digits ? own : digits;
            floats = floats && shows_float32(coordinate[k], own);
            largest = greater(largest, coordinate[k]);
        }
    }
    if (in_full ? !floats : digits == 0)
        return 0.0;
    const double as_floats = floats ? float32_units(in_full ? largest_of_all : largest) : 0.0;
    const double step = in_full ? as_floats : greater(as_floats, 2.0 * digit_unit(largest, digits));
    return step <= DECIMAL_MOST * vec3_length(vec3_sub(high, low)) ? step : 0.0;
}

/* Returns two units of the last place of a 32-bit float as large as the largest coordinate read as one; 0: none was. */
static double float32_step(const roberts_mesh *mesh)
{
    double most = 0.0;
    for (size_t i = 0; i < mesh->source_count; i++) {
        size_t end = i + 1 < mesh->source_count ? mesh->source[i + 1].first_vertex : mesh->vertex_count;
        for (size_t v = mesh->source[i].first_vertex; mesh->source[i].float32 && v < end; v++)
            most = greater(most, vec3_largest(mesh->vertex[v]));
    }
    return most > 0.0 ? float32_units(most) : 0.0;
}

double roberts_mesh_step(const roberts_mesh *mesh)
{
    double step = 0.0;
    for (size_t i = 0, first = 0; i <= mesh->source_count; i++) { /* the first vertices may come from no input */
        size_t end = i < mesh->source_count ? mesh->source[i].first_vertex : mesh->vertex_count;
        if (first < end && !(i > 0 && mesh->source[i - 1].float32))
            step = greater(step, decimal_step(mesh->vertex + first, end - first));
        first = end;
    }
    return step;
}

mesh_steps mesh_rounding(const roberts_mesh *mesh, bool decimals)
{
    return (mesh_steps){float32_step(mesh), decimals ? roberts_mesh_step(mesh) : 0.0};
}

bool mesh_group(roberts_mesh *mesh, const char *name)
{
    if (!array_reserve(&mesh->group, &mesh->group_room, mesh->group_count + 1, sizeof *mesh->group))
        return false;
    char *copy = copy_name(name);
    if (!copy)
        return false;
    mesh->group[mesh->group_count++] = (roberts_group){copy, (uint32_t)mesh->face_count};
    return true;
}

roberts_group *mesh_groups_copy(const roberts_mesh *mesh)
{
    roberts_group *copy = mesh->group_count ? alloc_array(mesh->group_count, sizeof *copy) : NULL;
    for (size_t i = 0; copy && i < mesh->group_count; i++) {
        copy[i] = (roberts_group){copy_name(mesh->group[i].name), mesh->group[i].first_face};
        if (!copy[i].name) {
            mesh_groups_free(copy, i);
            return NULL;
        }
    }
    return copy;
}

void mesh_groups_free(roberts_group *group, size_t count)
{
    for (size_t i = 0; i < count; i++)
        free(group[i].name);
    free(group);
}

static roberts_status bad_vertex(roberts_error *error, size_t vertex)
{
    return error_set(error, ROBERTS_BAD_NUMBER, 0, "vertex %zu has a coordinate that is infinite or beyond %g", vertex,
                     MESH_COORDINATE_MAX);
}

static roberts_status bad_mesh_corner(roberts_error *error, size_t face, uint32_t corner, size_t vertices)
{
    return error_set(error, ROBERTS_BAD_INDEX, 0, "face %zu names vertex %lu, but there are %zu", face,
                     (unsigned long)corner, vertices);
}

roberts_status roberts_mesh_add_vertex(roberts_mesh *mesh, roberts_vec3 position, uint32_t *index, roberts_error *error)
{
    if (!mesh_position(position))
        return bad_vertex(error, mesh->vertex_count);
    if (!mesh_vertex_room(mesh) || !(!mesh->vertex_color || fill_colors(&mesh->vertex_color, &mesh->vertex_color_room,
                                                                        mesh->vertex_count, mesh->vertex_count + 1)))
        return error_no_memory(error);
    if (index)
        *index = (uint32_t)mesh->vertex_count;
    mesh->vertex[mesh->vertex_count++] = position;
    return ROBERTS_OK;
}

roberts_status roberts_mesh_add_face(roberts_mesh *mesh, const uint32_t *corners, size_t count, roberts_error *error)
{
    for (size_t i = 0; i < count; i++) {
        if (corners[i] >= mesh->vertex_count)
            return bad_mesh_corner(error, mesh->face_count, corners[i], mesh->vertex_count);
    }
    if (!mesh_corner_room(mesh, count) || !mesh_face_room(mesh) ||
        !(!mesh->face_color ||
          fill_colors(&mesh->face_color, &mesh->face_color_room, mesh->face_count, mesh->face_count + 1)))
        return error_no_memory(error);
    if (count)
        memcpy(mesh->corner + mesh->corner_count, corners, count * sizeof *corners);
    mesh->corner_count += count;
    mesh->face_start[++mesh->face_count] = (uint32_t)mesh->corner_count;
    return ROBERTS_OK;
}

static roberts_status bad_null(roberts_error *error, const char *array, size_t count, const char *what)
{
    return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "%s is NULL, but there are %zu %s", array, count, what);
}

/* The starts of faces begin with 0, do not descend, and end with the number of corners. */
static roberts_status check_starts(const roberts_mesh *mesh, roberts_error *error)
{
    const uint32_t *start = mesh->face_start;
    if (start[0] != 0)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "face_start begins with %lu, not with 0",
                         (unsigned long)start[0]);
    for (size_t f = 0; f < mesh->face_count; f++)
        if (start[f + 1] < start[f])
            return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "face_start descends behind face %zu", f);
    if (start[mesh->face_count] != mesh->corner_count)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "face_start ends with %lu, but there are %zu corners",
                         (unsigned long)start[mesh->face_count], mesh->corner_count);
    return ROBERTS_OK;
}

/* A difference from 0.0 is never -0. */
void roberts_mesh_stand_up(roberts_mesh *mesh)
{
    for (size_t v = 0; v < mesh->vertex_count; v++)
        mesh->vertex[v] = (roberts_vec3){mesh->vertex[v].x, 0.0 - mesh->vertex[v].z, mesh->vertex[v].y};
}

roberts_status mesh_check_arrays(const roberts_mesh *mesh, roberts_error *error)
{
    if (mesh->vertex_count >= ROBERTS_NONE || mesh->face_count >= ROBERTS_NONE || mesh->corner_count > UINT32_MAX)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                         "there are more vertices, faces or corners than 32 bits count");
    if (mesh->vertex_count && !mesh->vertex)
        return bad_null(error, "vertex", mesh->vertex_count, "vertices");
    if (mesh->face_count && !mesh->face_start)
        return bad_null(error, "face_start", mesh->face_count, "faces");
    if (mesh->corner_count && !mesh->corner)
        return bad_null(error, "corner", mesh->corner_count, "corners");
    roberts_status status = mesh->face_count ? check_starts(mesh, error) : ROBERTS_OK;
    for (size_t f = 0; f < mesh->face_count && status == ROBERTS_OK; f++)
        for (size_t i = mesh->face_start[f]; i < mesh->face_start[f + 1]; i++)
            if (mesh->corner[i] >= mesh->vertex_count)
                return bad_mesh_corner(error, f, mesh->corner[i], mesh->vertex_count);
    return status;
}

roberts_status roberts_mesh_check(const roberts_mesh *mesh, roberts_error *error)
{
    if (mesh->source_count || mesh->group_count)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "arrays have neither sources nor groups");
    roberts_status status = mesh_check_arrays(mesh, error);
    for (size_t v = 0; v < mesh->vertex_count && status == ROBERTS_OK; v++)
        if (!mesh_position(mesh->vertex[v]))
            return bad_vertex(error, v);
    return status;
}

void roberts_mesh_free(roberts_mesh *mesh)
{
    if (!mesh)
        return;
    for (size_t i = 0; i < mesh->source_count; i++) {
        free(mesh->source[i].name);
        free(mesh->source[i].missing);
    }
    mesh_groups_free(mesh->group, mesh->group_count);
    free(mesh->source);
    free(mesh->vertex);
    free(mesh->face_start);
    free(mesh->corner);
    free(mesh->vertex_color);
    free(mesh->face_color);
    *mesh = (roberts_mesh){0};
}
