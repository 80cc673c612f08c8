/* scene.c - the scene's arrays: allocated, filled solid by solid, freed; queries by callers; which file a solid comes
 * from; which edge a segment is part of. */
#include "model/scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/box.h"
#include "base/error.h"
#include "base/sort.h"
#include "read/mesh.h"

/* ---- faces with every corner once ------------------------------------------------------------------------------ */

/* A corner that repeats an earlier one of its face is left out, wherever it is in the face. A face with fewer than
 * three corners does not count. */

roberts_status polygons_of_mesh(polygons *faces, const roberts_mesh *mesh, roberts_error *error)
{
    *faces = (polygons){0};
    if (mesh->vertex_count >= ROBERTS_NONE || mesh->face_count >= ROBERTS_NONE || mesh->corner_count >= ROBERTS_NONE)
        return error_set(error, ROBERTS_NO_MEMORY, 0, "more than %u vertices, faces or corners",
                         (unsigned)ROBERTS_NONE - 1);
    faces->face_count = (uint32_t)mesh->face_count;
    faces->vertex_count = (uint32_t)mesh->vertex_count;
    faces->start = mesh->face_start;
    faces->corner = mesh->corner;
    return ROBERTS_OK;
}

bool polygons_clean(polygons *faces, const uint32_t *name)
{
    size_t corners = faces->face_count ? faces->start[faces->face_count] : 0;
    uint32_t *start = alloc_array((size_t)faces->face_count + 1, sizeof *start);
    uint32_t *corner = alloc_array(corners, sizeof *corner);
    uint32_t *stamp = alloc_zeroed(faces->vertex_count, sizeof *stamp); /* 1 + the last face that has the vertex */
    bool enough = start && corner && stamp;
    uint32_t to = 0;
    if (enough) {
        for (uint32_t f = 0; f < faces->face_count; f++) {
            start[f] = to;
            for (uint32_t i = faces->start[f]; i < faces->start[f + 1]; i++) {
                uint32_t v = name ? name[faces->corner[i]] : faces->corner[i];
                if (stamp[v] != f + 1)
                    corner[to++] = v;
                stamp[v] = f + 1;
            }
        }
        start[faces->face_count] = to;
        polygons_free(&(polygons){.own_start = faces->own_start, .own_corner = faces->own_corner});
        faces->start = faces->own_start = start;
        faces->corner = faces->own_corner = corner;
        faces->repeated += corners - to;
    } else {
        free(start);
        free(corner);
    }
    free(stamp);
    return enough;
}

void polygons_free(polygons *faces)
{
    free(faces->own_start);
    free(faces->own_corner);
    *faces = (polygons){0};
}

/* ---- the arrays ------------------------------------------------------------------------------------------------ */

/* To fill them, faces are sorted by solid, and the vertices of each solid get compact numbers. If the numbers of a
 * solid's vertices are close together, a table translates them; otherwise they are sorted and searched. */

enum { LEAST_EXPONENT = -1000 }; /* of the unit: 1 / 2^-1074 would overflow */

enum { DENSE = 4 }; /* use a table if the range of vertex numbers is at most this many times the number of corners */

bool scene_alloc_arrays(roberts_scene *scene, kept_numbers kept)
{
    size_t faces = scene->face_count;
    if (!scene->solid)
        scene->solid = alloc_zeroed((size_t)scene->solid_count + 1, sizeof *scene->solid);
    if (!scene->point)
        scene->point = alloc_array(scene->vertex_count, sizeof *scene->point);
    if (!kept.vertices)
        scene->number = alloc_array(scene->vertex_count, sizeof *scene->number);
    if (!scene->face_start)
        scene->face_start = alloc_array(faces + 1, sizeof *scene->face_start);
    scene->turned = alloc_zeroed(faces, sizeof *scene->turned);
    if (!scene->corner)
        scene->corner = alloc_array(scene->corner_count, sizeof *scene->corner);
    scene->face_plane = alloc_array(faces, sizeof *scene->face_plane);
    scene->face_deviation = alloc_array(faces, sizeof *scene->face_deviation);
    scene->face_width = alloc_array(faces, sizeof *scene->face_width);
    if (!kept.faces)
        scene->face_number = alloc_array(faces, sizeof *scene->face_number);
    return scene->solid && scene->point && scene->turned && (scene->number || kept.vertices) && scene->face_start &&
           scene->corner && scene->face_plane && scene->face_deviation && scene->face_width &&
           (scene->face_number || kept.faces);
}

void scene_turn_face(roberts_scene *scene, uint32_t f)
{
    uint32_t *corner = scene->corner + scene->face_start[f], n = scene->face_start[f + 1] - scene->face_start[f];
    for (uint32_t i = 1, j = n - 1; i < j; i++, j--) {
        uint32_t swapped = corner[i];
        corner[i] = corner[j];
        corner[j] = swapped;
    }
    if (scene->turned)
        scene->turned[f] ^= 1;
}

void scene_turn_back(roberts_scene *scene)
{
    for (uint32_t f = 0; scene->lent & LENT_CORNER && scene->turned && f < scene->face_count; f++)
        if (scene->turned[f])
            scene_turn_face(scene, f);
}

static void free_surface(scene_surface *s)
{
    if (!s)
        return;
    free(s->kind);
    free(s->smooth);
    free(s->edge_is);
    free(s->bend);
    free(s->plane_of);
    free(s->whole);
    free(s->winding);
    free(s->many);
    free(s->many_face);
    free(s->part);
    free(s->needle);
    free(s);
}

void scene_clear(roberts_scene *scene)
{
    scene_turn_back(scene);
    free(scene->turned);
    free(scene->solid);
    if (!(scene->lent & LENT_POINT))
        free(scene->point);
    free(scene->number);
    if (!(scene->lent & LENT_FACE_START))
        free(scene->face_start);
    if (!(scene->lent & LENT_CORNER))
        free(scene->corner);
    free(scene->face_plane);
    free(scene->face_deviation);
    free(scene->face_width);
    free(scene->face_number);
    free(scene->edge);
    free(scene->low);
    free_surface(scene->surface);
    free(scene->vertex_color);
    free(scene->face_color);
    mesh_groups_free(scene->group, scene->group_count);
    *scene = (roberts_scene){.whole = scene->whole, .steps = scene->steps};
}

void scene_set_box(roberts_scene *scene, roberts_vec3 lo, roberts_vec3 hi)
{
    if (scene->whole) {
        lo = scene->whole->box_min;
        hi = scene->whole->box_max;
    }
    double size = fmax(hi.x - lo.x, fmax(hi.y - lo.y, hi.z - lo.z));
    int exponent = 0;
    scene->box_min = lo;
    scene->box_max = hi;
    scene->centre = vec3_scale(0.5, vec3_add(lo, hi));
    if (size > 0.0 && isfinite(size))
        frexp(size, &exponent);
    scene->unit = ldexp(1.0, exponent > LEAST_EXPONENT ? exponent : LEAST_EXPONENT);
}

void scene_copy_corners(roberts_scene *scene, const polygons *faces)
{
    const uint32_t *start = faces->start, *number = scene->face_number;
    uint32_t *to = scene->corner, *face_start = scene->face_start, face_count = scene->face_count;
    for (uint32_t f = 0; f < face_count; f++) {
        const uint32_t *from = faces->corner + start[number[f]], *end = faces->corner + start[number[f] + 1];
        face_start[f] = (uint32_t)(to - scene->corner);
        while (from < end)
            *to++ = *from++;
    }
    face_start[face_count] = (uint32_t)(to - scene->corner);
}

/* Sorts the faces by solid and copies their corners, which keep the mesh's numbers. */
static void place_faces(roberts_scene *scene, const polygons *faces, const uint32_t *of)
{
    uint32_t sum = 0;
    for (uint32_t f = 0; f < faces->face_count; f++)
        if (of[f] != ROBERTS_NONE)
            scene->solid[of[f]].face++;
    for (uint32_t s = 0; s <= scene->solid_count; s++) {
        uint32_t count = scene->solid[s].face;
        scene->solid[s].face = sum;
        sum += count;
    }
    for (uint32_t f = 0; f < faces->face_count; f++)
        if (of[f] != ROBERTS_NONE)
            scene->face_number[scene->solid[of[f]].face++] = f;
    for (uint32_t s = scene->solid_count; s > 0; s--)
        scene->solid[s].face = scene->solid[s - 1].face;
    scene->solid[0].face = 0;
    scene_copy_corners(scene, faces);
}

/* The corners of a solid, and the least and the greatest vertex number among them. */
typedef struct corner_range {
    uint32_t from, to, least, most;
} corner_range;

/* Numbers the vertices of these corners in ascending order, by marking them in a table of their range. False: no
 * memory. */
static bool number_dense(roberts_scene *scene, corner_range r, uint32_t **mark, size_t *room)
{
    const size_t span = (size_t)(r.most - r.least) + 1;
    if (!array_reserve(mark, room, span, sizeof **mark))
        return false;
    for (size_t v = 0; v < span; v++)
        (*mark)[v] = 0;
    for (uint32_t i = r.from; i < r.to; i++)
        (*mark)[scene->corner[i] - r.least] = 1;
    for (size_t v = 0; v < span; v++)
        if ((*mark)[v]) {
            (*mark)[v] = scene->vertex_count;
            scene->number[scene->vertex_count++] = r.least + (uint32_t)v;
        }
    for (uint32_t i = r.from; i < r.to; i++)
        scene->corner[i] = (*mark)[scene->corner[i] - r.least];
    return true;
}

/* Numbers them by sorting, for a solid whose vertices are scattered over the file. False: no memory. */
static bool number_sparse(roberts_scene *scene, uint32_t from, uint32_t to, uint32_t **sorted, size_t *room)
{
    uint32_t first = scene->vertex_count, count = to - from;
    if (!array_reserve(sorted, room, count, sizeof **sorted))
        return false;
    memcpy(*sorted, scene->corner + from, count * sizeof **sorted);
    qsort(*sorted, count, sizeof **sorted, compare_u32);
    for (uint32_t i = 0; i < count; i++)
        if (i == 0 || (*sorted)[i] != (*sorted)[i - 1])
            scene->number[scene->vertex_count++] = (*sorted)[i];
    for (uint32_t i = from; i < to; i++) {
        const uint32_t *found = bsearch(&scene->corner[i], scene->number + first, scene->vertex_count - first,
                                        sizeof *scene->number, compare_u32);
        scene->corner[i] = (uint32_t)(found - scene->number);
    }
    return true;
}

/* Turns the mesh's vertex numbers into compact ones, solid by solid. False: no memory. */
static bool number_vertices(roberts_scene *scene)
{
    uint32_t *scratch = NULL;
    size_t room = 0;
    bool done = true;
    scene->vertex_count = 0;
    for (uint32_t s = 0; s < scene->solid_count && done; s++) {
        corner_range r = {scene->face_start[scene->solid[s].face], scene->face_start[scene->solid[s + 1].face],
                          ROBERTS_NONE, 0};
        for (uint32_t i = r.from; i < r.to; i++) {
            r.least = scene->corner[i] < r.least ? scene->corner[i] : r.least;
            r.most = scene->corner[i] > r.most ? scene->corner[i] : r.most;
        }
        scene->solid[s].vertex = scene->vertex_count;
        if (r.to == r.from)
            continue;
        if ((r.most - r.least) / DENSE < r.to - r.from)
            done = number_dense(scene, r, &scratch, &room);
        else
            done = number_sparse(scene, r.from, r.to, &scratch, &room);
    }
    scene->solid[scene->solid_count].vertex = scene->vertex_count;
    free(scratch);
    return done;
}

/* Shrinks the arrays of vertices to their used size, if realloc() can. */
static void trim(roberts_scene *scene)
{
    void *smaller = realloc(scene->point, (scene->vertex_count + (size_t)1) * sizeof *scene->point);
    if (smaller)
        scene->point = smaller;
    smaller = realloc(scene->number, (scene->vertex_count + (size_t)1) * sizeof *scene->number);
    if (smaller)
        scene->number = smaller;
}

bool scene_lay_out(roberts_scene *scene, const polygons *faces, const uint32_t *of, uint32_t solid_count,
                   const roberts_vec3 *point)
{
    roberts_vec3 lo = {INFINITY, INFINITY, INFINITY}, hi = {-INFINITY, -INFINITY, -INFINITY};
    size_t corners = 0;
    scene->solid_count = solid_count;
    for (uint32_t f = 0; f < faces->face_count; f++)
        if (of[f] != ROBERTS_NONE) {
            scene->face_count++;
            corners += polygon_size(faces, f);
        }
    scene->corner_count = corners;
    scene->vertex_count = (uint32_t)corners; /* upper bound */
    if (!scene_alloc_arrays(scene, (kept_numbers){false, false}))
        return false;
    place_faces(scene, faces, of);
    if (!number_vertices(scene))
        return false;
    for (uint32_t v = 0; v < scene->vertex_count; v++) {
        scene->point[v] = point[scene->number[v]];
        box_add(&lo, &hi, scene->point[v]);
    }
    scene_set_box(scene, lo, hi);
    trim(scene);
    return true;
}

/* ---- questions --------------------------------------------------------------------------------------------------- */

/* The last body that begins at this face or edge, or before it. */
static uint32_t body_of(const roberts_scene *scene, bool is_edge, uint32_t number)
{
    uint32_t low = 0, high = scene->solid_count;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if ((is_edge ? scene->solid[middle].edge : scene->solid[middle].face) <= number)
            low = middle;
        else
            high = middle;
    }
    return low;
}

uint32_t scene_body_of_face(const roberts_scene *scene, uint32_t face)
{
    return body_of(scene, false, face);
}

uint32_t scene_body_of_edge(const roberts_scene *scene, uint32_t edge)
{
    return body_of(scene, true, edge);
}

/* Steps back grow while the numbers are equal, then shrink. */
uint32_t scene_first_alike(const uint32_t *number, uint32_t at, uint32_t least)
{
    const uint32_t own = number[at];
    uint32_t step = 1;
    for (; at - least >= step && number[at - step] == own; step *= 2)
        at -= step;
    for (; step > 0; step /= 2)
        if (at - least >= step && number[at - step] == own)
            at -= step;
    return at;
}

uint32_t scene_first_piece(const roberts_scene *scene, uint32_t body, uint32_t piece)
{
    if (!scene_is_in_pieces(scene, body, piece))
        return piece;
    return scene_first_alike(scene->surface->plane_of, piece, scene->solid[body].face);
}

uint32_t scene_end_of_pieces(const roberts_scene *scene, uint32_t body, uint32_t piece)
{
    uint32_t end = piece + 1;
    if (!scene_is_convex(scene, body))
        while (end < scene->solid[body + 1].face && scene_plane_number(scene, end) == scene_plane_number(scene, piece))
            end++;
    return end;
}

size_t roberts_scene_solid_count(const roberts_scene *scene)
{
    return scene->solid_count;
}

/* The pieces of a face are consecutive, so a change of number is a new face. */
size_t roberts_scene_face_count(const roberts_scene *scene)
{
    size_t count = scene->face_count;
    if (scene->surface)
        for (uint32_t f = 1; f < scene->face_count; f++)
            count -= scene_face_number(scene, f) != ROBERTS_NONE &&
                     scene_face_number(scene, f) == scene_face_number(scene, f - 1);
    return count;
}

size_t roberts_scene_piece_count(const roberts_scene *scene)
{
    return scene->face_count;
}

/* The parts of an edge are consecutive too. */
size_t roberts_scene_edge_count(const roberts_scene *scene)
{
    const scene_surface *surface = scene->surface;
    size_t count = scene->edge_count;
    if (!surface)
        return count;
    for (uint32_t e = 0; e < scene->edge_count; e++)
        count -= (surface->edge_is[e] & EDGE_CUT) != 0;
    for (uint32_t i = 1; i < surface->part_count; i++) {
        const scene_part *before = surface->part + i - 1, *part = surface->part + i;
        count -= part->v[0] == before->v[0] && part->v[1] == before->v[1];
    }
    return count;
}

size_t roberts_scene_vertex_count(const roberts_scene *scene)
{
    size_t count = scene->vertex_count;
    if (scene->surface)
        for (uint32_t v = 0; v < scene->vertex_count; v++)
            count -= scene_vertex_number(scene, v) == ROBERTS_NONE;
    return count;
}

roberts_body_kind roberts_scene_body_kind(const roberts_scene *scene, uint32_t body)
{
    if (body >= scene->solid_count)
        return ROBERTS_OPEN;
    return scene->surface ? (roberts_body_kind)scene->surface->kind[body] : ROBERTS_CONVEX;
}

uint32_t roberts_scene_body_face_count(const roberts_scene *scene, uint32_t body)
{
    return body < scene->solid_count ? scene->solid[body + 1].face - scene->solid[body].face : 0;
}

bool roberts_scene_body_curved(const roberts_scene *scene, uint32_t body)
{
    return scene->surface && body < scene->solid_count && scene->surface->smooth[body];
}

/* A hull is the only body whose faces have no numbers. */
bool roberts_scene_is_hull(const roberts_scene *scene, uint32_t solid)
{
    return solid < scene->solid_count && scene->solid[solid].face < scene->solid[solid + 1].face &&
           scene_face_number(scene, scene->solid[solid].face) == ROBERTS_NONE;
}

/* Returns the name of the last group that begins at or before the solid's first face. */
const char *roberts_scene_name(const roberts_scene *scene, uint32_t solid)
{
    size_t low = 0, high = scene->group_count;
    if (solid >= scene->solid_count || scene->solid[solid].face == scene->solid[solid + 1].face)
        return "";
    const uint32_t face = scene_face_number(scene, scene->solid[solid].face);
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (scene->group[middle].first_face <= face)
            low = middle + 1;
        else
            high = middle;
    }
    return face != ROBERTS_NONE && low > 0 ? scene->group[low - 1].name : "";
}

bool roberts_scene_vertex(const roberts_scene *scene, uint32_t number, roberts_vec3 *point)
{
    for (uint32_t v = 0; v < scene->vertex_count; v++)
        if (scene_vertex_number(scene, v) == number) {
            *point = scene->point[v];
            return true;
        }
    return false;
}

/* ---- files ------------------------------------------------------------------------------------------------------- */

/* In a mesh the inputs follow one another, and solids are numbered by their smallest vertex, so the solids of a file
 * have consecutive numbers. A solid whose faces or welded vertices come from several files has no file; its numbers
 * count over all files. */

/* Returns the last source that begins at or before the vertex and the face. An empty source contains nothing. */
static size_t source_of_vertex(const roberts_mesh *mesh, uint32_t v)
{
    size_t i = mesh->source_count;
    while (i-- > 1 && mesh->source[i].first_vertex > v)
        continue;
    return i;
}

static size_t source_of_face(const roberts_mesh *mesh, uint32_t f)
{
    size_t i = mesh->source_count;
    while (i-- > 1 && mesh->source[i].first_face > f)
        continue;
    return i;
}

solid_source source_find(const roberts_mesh *mesh, uint32_t v_least, uint32_t v_most, uint32_t f_least, uint32_t f_most)
{
    const solid_source none = {.file = ""};
    if (mesh->source_count == 0)
        return none;
    size_t i = source_of_face(mesh, f_least);
    if (source_of_face(mesh, f_most) != i || source_of_vertex(mesh, v_least) != i ||
        source_of_vertex(mesh, v_most) != i || !mesh->source[i].name)
        return none;
    return (solid_source){mesh->source[i].name, 0, mesh->source[i].first_face, mesh->source[i].first_vertex};
}

const char *source_of_noted(const roberts_mesh *mesh, noted_faces faces)
{
    const uint32_t v0 = mesh->corner[mesh->face_start[faces.first]], v1 = mesh->corner[mesh->face_start[faces.last]];
    return source_find(mesh, v0, v1, faces.first, faces.last).file;
}

/* Sets the number of the file's first solid. The first vertices of solids ascend. */
static solid_source count_solids(const roberts_scene *scene, uint32_t s, solid_source at)
{
    for (uint32_t end = s; at.solid < end;) {
        uint32_t middle = at.solid + (end - at.solid) / 2;
        if (scene_vertex_number(scene, scene->solid[middle].vertex) < at.vertex)
            at.solid = middle + 1;
        else
            end = middle;
    }
    return at;
}

/* The vertices and faces of a solid ascend. */
solid_source source_of_solid(const roberts_scene *scene, uint32_t s, const roberts_mesh *mesh)
{
    const scene_solid *first = scene->solid + s;
    return count_solids(
        scene, s,
        source_find(mesh, scene_vertex_number(scene, first->vertex), scene_vertex_number(scene, first[1].vertex - 1),
                    scene_face_number(scene, first->face), scene_face_number(scene, first[1].face - 1)));
}

solid_source source_of_points(const roberts_scene *scene, uint32_t s, const roberts_mesh *mesh)
{
    const solid_source none = {.file = ""};
    const scene_solid *first = scene->solid + s;
    if (mesh->source_count == 0)
        return none;
    size_t i = source_of_vertex(mesh, scene_vertex_number(scene, first->vertex));
    if (source_of_vertex(mesh, scene_vertex_number(scene, first[1].vertex - 1)) != i || !mesh->source[i].name)
        return none;
    return count_solids(
        scene, s, (solid_source){mesh->source[i].name, 0, mesh->source[i].first_face, mesh->source[i].first_vertex});
}

/* ---- edges, and the edge of a segment ---------------------------------------------------------------------------- */

const scene_many *scene_many_at(const roberts_scene *scene, uint32_t edge)
{
    const scene_surface *s = scene->surface;
    return &s->many[find_numbered(s->many, s->many_count, sizeof *s->many, edge)];
}

uint32_t scene_faces_at(const roberts_scene *scene, uint32_t s, uint32_t e, uint32_t room[2], const uint32_t **face)
{
    const scene_edge *edge = scene_edge_stored(scene, s, e);
    const uint8_t is = scene_is_convex(scene, s) ? 0 : scene->surface->edge_is[e];
    uint32_t count = 0;
    if (is & EDGE_MANY) {
        const scene_many *many = scene_many_at(scene, e);
        *face = scene->surface->many_face + many->first;
        return many->end - many->first;
    }
    for (int k = 0; k < 2; k++)
        if (edge->f[k] != ROBERTS_NONE)
            room[count++] =
                (scene->solid[s].face + edge->f[k]) | (is & (k ? EDGE_TURNED_1 : EDGE_TURNED_0) ? MANY_TURNED : 0);
    *face = room;
    return count;
}

const scene_part *scene_part_at(const roberts_scene *scene, uint32_t edge)
{
    const scene_surface *s = scene->surface;
    return &s->part[find_numbered(s->part, s->part_count, sizeof *s->part, edge)];
}

/* Keeps the two smallest different faces. */
static void add_smallest(uint32_t face[2], uint32_t number)
{
    if (number < face[0]) {
        face[1] = face[0];
        face[0] = number;
    } else if (number > face[0] && number < face[1]) {
        face[1] = number;
    }
}

/* Does the scene have the segment's edge? */
static bool has_edge(const roberts_scene *scene, const roberts_segment *segment)
{
    return scene && segment->solid < scene->solid_count && segment->edge >= scene->solid[segment->solid].edge &&
           segment->edge < scene->solid[segment->solid + 1].edge;
}

void roberts_segment_faces(const roberts_scene *scene, const roberts_drawing *drawing, const roberts_segment *segment,
                           uint32_t face[2])
{
    face[0] = face[1] = ROBERTS_NONE;
    if (scene_crosses(segment)) {
        if (drawing && segment->edge < drawing->crossing_count)
            memcpy(face, drawing->crossing[segment->edge].face, 2 * sizeof *face);
        return;
    }
    if (drawing && segment->edge < drawing->known_edge_count) {
        memcpy(face, drawing->known_edge[segment->edge].face, 2 * sizeof *face);
        return;
    }
    if (!has_edge(scene, segment))
        return;
    uint32_t room[2];
    const uint32_t *of;
    const uint32_t count = scene_faces_at(scene, segment->solid, segment->edge, room, &of);
    for (uint32_t k = 0; k < count; k++)
        add_smallest(face, scene_face_number(scene, of[k] & ~MANY_TURNED));
}

/* Returns the point at t on a line from A to B whose parameters run from `from` to `to`. */
static roberts_vec3 point_of_line(const roberts_vec3 line[2], double from, double to, double t)
{
    if (t <= from || t >= to)
        return line[t > from];
    return vec3_add(line[0], vec3_scale((t - from) / (to - from), vec3_sub(line[1], line[0])));
}

/* Finds the ends of a segment's line; not its faces. False: there is no such line. */
static bool find_line(const roberts_scene *scene, const roberts_drawing *drawing, const roberts_segment *segment,
                      roberts_known_edge *known)
{
    const uint32_t body = segment->solid, e = segment->edge;
    *known = (roberts_known_edge){.t1 = 1.0};
    if (scene_crosses(segment)) {
        if (!drawing || e >= drawing->crossing_count)
            return false;
        memcpy(known->end, drawing->crossing[e].end, sizeof known->end);
        return true;
    }
    if (drawing && e < drawing->known_edge_count) {
        *known = drawing->known_edge[e];
        return true;
    }
    if (!has_edge(scene, segment))
        return false;
    const scene_edge edge = scene_edge_at(scene, body, e);
    for (int i = 0; i < 2; i++)
        known->end[i] = scene->point[edge.v[i]];
    if (!scene_is_convex(scene, body) && scene->surface->edge_is[e] & EDGE_PART) {
        known->t0 = scene_part_at(scene, e)->t0;
        known->t1 = scene_part_at(scene, e)->t1;
    }
    return true;
}

bool scene_know_edge(const roberts_scene *scene, const roberts_drawing *drawing, const roberts_segment *segment,
                     roberts_known_edge *known)
{
    const bool found = find_line(scene, drawing, segment, known);
    roberts_segment_faces(scene, drawing, segment, known->face);
    return found;
}

bool roberts_segment_ends(const roberts_scene *scene, const roberts_drawing *drawing, const roberts_segment *segment,
                          roberts_vec3 end[2])
{
    roberts_known_edge line;
    if (!find_line(scene, drawing, segment, &line))
        return false;
    end[0] = point_of_line(line.end, line.t0, line.t1, segment->t0);
    end[1] = point_of_line(line.end, line.t0, line.t1, segment->t1);
    return true;
}
