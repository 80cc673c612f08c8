/* hull.c - convex hulls in place of solids that are not convex.
 *
 * Each solid is first tried as it is. If it is refused, it gets the faces of its convex hull, which must pass the same
 * checks. First Qhull is called with a width, so that faces that are coplanar within the tolerance become one face
 * instead of a fan of slivers. If the solid is too thin for that, Qhull is called again without a width.
 *
 * A hull's vertices are vertices of the input. Vertices inside the hull are no longer part of the solid, but the solid
 * keeps its place among the others. A flat solid has no hull: it is left out, unless there is nothing else. */
#include "model/hull.h"

#include <limits.h>
#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <libqhull_r/qhull_ra.h>

#include "base/array.h"
#include "base/error.h"
#include "base/threads.h"
#include "model/scene.h"
#include "model/solid.h"

/* ---- the facets of one hull, computed by Qhull ------------------------------------------------------------------- */

/* Qhull adds point after point to a hull, and merges facets that rounding leaves doubtful. So its facets are polygons.
 * Points that are not corners lie inside, or at most a few widths outside. Source: C. B. Barber, D. P. Dobkin, H.
 * Huhdanpaa, "The Quickhull algorithm for convex hulls", ACM Transactions on Mathematical Software 22(4), 1996.
 *
 * Qhull's messages go to a small memory buffer that nobody reads; its errors are returned as numbers. Qhull calls
 * exit() on an error within an error, and on an error outside qh_new_qhull(), so nothing that can fail is called
 * outside. Every hull has its own state. */

_Static_assert(sizeof(roberts_vec3) == 3 * sizeof(coordT), "points are given to Qhull as they are");

/* Writes Qhull's option for the width as an integer and a power of ten. This avoids the decimal point, which depends on
 * the locale. */
static void write_command(char *command, size_t size, double width)
{
    if (width > 0.0) {
        int exponent = (int)floor(log10(width)) - 2;
        snprintf(command, size, "qhull Pp E%.0fe%d", ceil(width / pow(10.0, exponent)), exponent);
    } else {
        snprintf(command, size, "qhull Pp");
    }
}

static uint32_t point_number(const qhT *qh, const vertexT *vertex)
{
    return (uint32_t)((vertex->point - qh->first_point) / 3);
}

static size_t count_ridges(const facetT *facet)
{
    ridgeT *ridge, **ridgep;
    size_t count = 0;
    FOREACHridge_(facet->ridges) count++;
    return count;
}

/* Appends the corners of a facet that was merged from others. Its ridges determine the order of the corners. False: no
 * memory. */
static bool add_polygon(hull_facets *facets, const qhT *qh, const facetT *facet)
{
    uint32_t *corner = facets->corner + facets->start[facets->count], count = 0, first = 0, at;
    ridgeT *ridge, **ridgep;
    FOREACHridge_(facet->ridges)
    {
        uint32_t a = point_number(qh, SETfirstt_(ridge->vertices, vertexT));
        uint32_t b = point_number(qh, SETsecondt_(ridge->vertices, vertexT));
        bool along = ridge->top == facet;
        first = along ? a : b;
        facets->next[first] = along ? b : a;
        count++;
    }
    at = first;
    for (uint32_t i = 0; i < count; i++, at = facets->next[at])
        corner[i] = at;
    facets->start[facets->count + 1] = facets->start[facets->count] + count;
    facets->count++;
    return count >= 3 && at == first;
}

static bool add_triangle(hull_facets *facets, const qhT *qh, const facetT *facet)
{
    uint32_t *corner = facets->corner + facets->start[facets->count];
    for (int i = 0; i < 3; i++)
        corner[i] = point_number(qh, SETelemt_(facet->vertices, i, vertexT));
    facets->start[facets->count + 1] = facets->start[facets->count] + 3;
    facets->count++;
    return true;
}

static hull_result copy_facets(hull_facets *facets, const qhT *qh, uint32_t points)
{
    size_t corners = 0, count = 0;
    const facetT *facet;
    FORALLfacets
    {
        corners += facet->simplicial ? 3 : count_ridges(facet);
        count++;
    }
    if (corners >= ROBERTS_NONE ||
        !array_reserve(&facets->start, &facets->start_room, count + 1, sizeof *facets->start) ||
        !array_reserve(&facets->corner, &facets->corner_room, corners, sizeof *facets->corner) ||
        !array_reserve(&facets->next, &facets->next_room, points, sizeof *facets->next))
        return HULL_NO_MEMORY;
    memset(facets->next, 0, points * sizeof *facets->next); /* defined even if the ridges are not a cycle */
    facets->count = 0;
    facets->start[0] = 0;
    facets->outside = qh->max_outside;
    FORALLfacets
    {
        if (!(facet->simplicial ? add_triangle : add_polygon)(facets, qh, facet))
            return HULL_FAILED;
    }
    return HULL_OK;
}

static hull_result result_of_code(int code)
{
    switch (code) {
    case qh_ERRnone:
        return HULL_OK;
    case qh_ERRinput: /* all points have the same x, y or z: there are enough points, and the options are ours */
    case qh_ERRsingular:
        return HULL_FLAT;
    case qh_ERRmem:
        return HULL_NO_MEMORY;
    default:
        return HULL_FAILED;
    }
}

hull_result hull_take(hull_facets *facets, const roberts_vec3 *point, uint32_t count, double width)
{
    char command[64], said[128];
    int unused[2];
    if (count < 4)
        return HULL_FLAT;
    if (count > INT_MAX)
        return HULL_NO_MEMORY;
    qhT *qh = alloc_zeroed(1, sizeof *qh);
    FILE *messages = fmemopen(said, sizeof said, "w");
    hull_result result = HULL_NO_MEMORY;
    if (qh && messages) {
        /* Qhull's parameter is not const, but only options that rotate or joggle the points would change them */
        coordT *coordinates = (coordT *)(uintptr_t)point;
        write_command(command, sizeof command, width);
        result = result_of_code(qh_new_qhull(qh, 3, (int)count, coordinates, False, command, NULL, messages));
        if (result == HULL_OK)
            result = copy_facets(facets, qh, count);
        qh_freeqhull(qh, !qh_ALL);
        qh_memfreeshort(qh, &unused[0], &unused[1]);
    }
    if (messages)
        fclose(messages);
    free(qh);
    return result;
}

void hull_facets_free(hull_facets *facets)
{
    free(facets->start);
    free(facets->corner);
    free(facets->next);
    *facets = (hull_facets){0};
}

/* ---- inputs ---------------------------------------------------------------------------------------------------- */

/* Inputs that have points but no faces: each gets one face with all its points as corners. */

/* The vertices and faces of an input. A mesh that was not read from files counts as one input. */
typedef struct hull_input {
    size_t vertex, vertex_end, face, face_end;
} hull_input;

static size_t hull_input_count(const roberts_mesh *mesh)
{
    return mesh->source_count ? mesh->source_count : 1;
}

static hull_input hull_input_at(const roberts_mesh *mesh, size_t i)
{
    hull_input range = {0, mesh->vertex_count, 0, mesh->face_count};
    if (i > 0) {
        range.vertex = mesh->source[i].first_vertex;
        range.face = mesh->source[i].first_face;
    }
    if (i + 1 < mesh->source_count) {
        range.vertex_end = mesh->source[i + 1].first_vertex;
        range.face_end = mesh->source[i + 1].first_face;
    }
    return range;
}

/* Returns the number of points of input i if it is bare, otherwise 0. */
static size_t hull_bare_points(const roberts_mesh *mesh, size_t i)
{
    const hull_input range = hull_input_at(mesh, i);
    for (size_t f = range.face; f < range.face_end; f++)
        if (mesh->face_start[f + 1] - mesh->face_start[f] >= 3)
            return 0;
    return range.vertex_end - range.vertex;
}

bool hull_bare_input(const roberts_mesh *mesh)
{
    for (size_t i = 0; i < hull_input_count(mesh); i++)
        if (hull_bare_points(mesh, i) > 0)
            return true;
    return false;
}

static roberts_status refuse_few(const char *name, size_t points, roberts_error *error)
{
    error_set(error, ROBERTS_FLAT, 0, "a convex hull takes four points, but there %s %zu", points == 1 ? "is" : "are",
              points);
    return error_in(error, name ? name : "", ROBERTS_FLAT);
}

roberts_status hull_add_inputs(polygons *faces, const roberts_mesh *mesh, roberts_error *error)
{
    const size_t inputs = hull_input_count(mesh);
    size_t corners = mesh->corner_count, count = mesh->face_count, few = inputs, vertices_of_few = 0;
    for (size_t i = 0; i < inputs; i++) {
        const size_t points = hull_bare_points(mesh, i);
        if (points >= HULL_POINTS) {
            corners += points;
            count++;
        } else if (points > 0) {
            vertices_of_few += points;
            few = few < i ? few : i;
        }
    }
    if (few < inputs && vertices_of_few == mesh->vertex_count)
        return refuse_few(mesh->source_count ? mesh->source[few].name : NULL, hull_bare_points(mesh, few), error);
    if (count == mesh->face_count)
        return ROBERTS_OK;
    if (count >= ROBERTS_NONE || corners >= ROBERTS_NONE)
        return error_no_memory(error);
    uint32_t *start = alloc_array(count + 1, sizeof *start), *corner = alloc_array(corners, sizeof *corner);
    if (!start || !corner) {
        free(start);
        free(corner);
        return error_no_memory(error);
    }
    start[0] = 0;
    if (mesh->face_count > 0)
        memcpy(start, mesh->face_start, (mesh->face_count + 1) * sizeof *start);
    if (mesh->corner_count > 0)
        memcpy(corner, mesh->corner, mesh->corner_count * sizeof *corner);
    faces->face_count = (uint32_t)mesh->face_count;
    for (size_t i = 0; i < inputs; i++) {
        const hull_input range = hull_input_at(mesh, i);
        if (hull_bare_points(mesh, i) < HULL_POINTS)
            continue;
        uint32_t to = start[faces->face_count];
        for (size_t v = range.vertex; v < range.vertex_end; v++)
            corner[to++] = (uint32_t)v;
        start[++faces->face_count] = to;
    }
    faces->start = faces->own_start = start;
    faces->corner = faces->own_corner = corner;
    return ROBERTS_OK;
}

/* ---- messages -------------------------------------------------------------------------------------------------- */

/* Messages about solids that were replaced by hulls or left out. */

/* What happened to a solid. */
typedef enum hull_fate {
    FATE_KEPT,  /* already convex, or points without faces, which only a hull can use */
    FATE_FLAT,  /* flat: left out */
    FATE_OPEN,  /* replaced by its hull because it is not closed */
    FATE_BENT,  /* replaced because a face is not planar */
    FATE_DENTED /* replaced because it is not convex, or too flat to tell */
} hull_fate;

/* Refuses solid s because its hull could not be made. */
static roberts_status hull_refuse(const roberts_scene *scene, uint32_t s, const roberts_mesh *mesh,
                                  roberts_status status, const char *why, roberts_error *error)
{
    solid_source at = source_of_points(scene, s, mesh);
    error_set(error, status, 0, "the convex hull of solid %u, of %u points from vertex %u on, %s", s - at.solid,
              scene->solid[s + 1].vertex - scene->solid[s].vertex,
              scene_vertex_number(scene, scene->solid[s].vertex) - at.vertex, why);
    return error_in(error, at.file, status);
}

static const char *name_input(const roberts_mesh *mesh, size_t input)
{
    return mesh->source_count && mesh->source[input].name ? mesh->source[input].name : "";
}

static void warn_flat(const roberts_scene *scene, uint32_t first, uint32_t count, const roberts_mesh *mesh,
                      size_t input, const roberts_warnings *warnings)
{
    const bool one = count == 1;
    warning_send(warnings, name_input(mesh, input), 0,
                 "%u flat component%s ignored, %sof %u points from vertex %u on: %s", count, one ? "" : "s",
                 one ? "" : "the first ", scene->solid[first + 1].vertex - scene->solid[first].vertex,
                 scene_vertex_number(scene, scene->solid[first].vertex) - (uint32_t)hull_input_at(mesh, input).vertex,
                 one ? "it has no convex hull" : "they have no convex hulls");
}

/* Writes e.g. "3 solids replaced by their convex hulls: 2 not closed, 1 not convex". The counts are omitted if there is
 * only one reason. */
static void warn_replaced(const uint32_t count[], const char *name, const roberts_warnings *warnings)
{
    static const char *const why[] = {
        [FATE_OPEN] = "not closed", [FATE_BENT] = "not planar", [FATE_DENTED] = "not convex"};
    const uint32_t all = count[FATE_OPEN] + count[FATE_BENT] + count[FATE_DENTED];
    char reasons[120] = "";
    size_t used = 0;
    if (all == 0)
        return;
    for (int i = FATE_OPEN; i <= FATE_DENTED; i++)
        if (count[i] == all)
            snprintf(reasons, sizeof reasons, "%s", why[i]);
        else if (count[i] > 0)
            used +=
                (size_t)snprintf(reasons + used, sizeof reasons - used, "%s%u %s", used ? ", " : "", count[i], why[i]);
    warning_send(warnings, name, 0, "%u solid%s replaced by %s: %s", all, all == 1 ? "" : "s",
                 all == 1 ? "its convex hull" : "their convex hulls", reasons);
}

static void warn_few(size_t points, const char *name, const roberts_warnings *warnings)
{
    if (points > 0 && points < HULL_POINTS)
        warning_send(warnings, name, 0, "%zu point%s ignored: a convex hull takes four", points,
                     points == 1 ? "" : "s");
}

static bool all_flat(const uint8_t *fate, uint32_t solids)
{
    uint32_t s = 0;
    while (s < solids && fate[s] == FATE_FLAT)
        s++;
    return s == solids;
}

/* Sends the warnings, input by input. A solid belongs to the input that contains its first vertex. fate: [solids]
 * hull_fate. Returns ROBERTS_FLAT if all solids are flat. */
static roberts_status send_warnings(const uint8_t *fate, const roberts_scene *scene, const roberts_mesh *mesh,
                                    const roberts_warnings *warnings, roberts_error *error)
{
    uint32_t s = 0;
    if (all_flat(fate, scene->solid_count))
        return hull_refuse(scene, 0, mesh, ROBERTS_FLAT, "is flat: they lie in one plane, or nearly so", error);
    for (size_t i = 0; i < hull_input_count(mesh); i++) {
        const size_t vertex_end = hull_input_at(mesh, i).vertex_end;
        uint32_t count[FATE_DENTED + 1] = {0}, first = ROBERTS_NONE;
        for (; s < scene->solid_count && scene_vertex_number(scene, scene->solid[s].vertex) < vertex_end; s++)
            if (count[fate[s]]++ == 0 && fate[s] == FATE_FLAT)
                first = s;
        warn_replaced(count, name_input(mesh, i), warnings);
        if (first != ROBERTS_NONE)
            warn_flat(scene, first, count[FATE_FLAT], mesh, i, warnings);
        warn_few(hull_bare_points(mesh, i), name_input(mesh, i), warnings);
    }
    return ROBERTS_OK;
}

/* ---- widths and tools ------------------------------------------------------------------------------------------ */

/* Fraction of the tolerance: the width given to Qhull. Facets are planar to within a few widths, so this keeps them
 * within the tolerance. */
static const double WIDTH_PART = 0.1;

/* Fractions of the size: bounds of the width. A larger one might be visible, whatever the tolerance and wherever the
 * solid stands. A smaller one is left to Qhull, whose own width for rounding is about 1e-15. */
static const double GREATEST_WIDTH = 1e-5, LEAST_WIDTH = 1e-14;

/* The faces of all solids, in order. The result does not depend on the number of threads. */
typedef struct face_list {
    uint32_t *start, *corner;
    uint32_t *solid;  /* [count] */
    uint32_t *origin; /* [count] number of each face in the input, or ROBERTS_NONE */
    size_t count, corner_count, start_room, corner_room, solid_room, origin_room;
} face_list;

/* Tools of one thread; the arrays are reused for solid after solid. */
typedef struct hull_maker {
    const roberts_scene *scene;
    const roberts_mesh *mesh; /* for messages */
    double tolerance;
    hull_facets facets;
    solid_frame frame; /* of the solid that gets a hull */
    builder work;      /* for the original solid, then for its hull */
    uint32_t *zero;    /* [facets] */
    size_t zero_room;
} hull_maker;

static void hull_maker_free(hull_maker *maker)
{
    hull_facets_free(&maker->facets);
    frame_free(&maker->frame);
    builder_free(&maker->work);
    free(maker->zero);
}

/* ---- faces ----------------------------------------------------------------------------------------------------- */

static void face_list_free(face_list *list)
{
    free(list->start);
    free(list->corner);
    free(list->solid);
    free(list->origin);
}

/* A face to be added to a list. */
typedef struct new_face {
    const uint32_t *corner; /* [count] relative to vertex `first` of the scene */
    size_t count;
    uint32_t first, origin; /* origin: number in the input, or ROBERTS_NONE */
} new_face;

/* Appends a face of solid s. False: no memory. */
static bool add_hull_face(face_list *list, const roberts_scene *scene, uint32_t s, const new_face *face)
{
    const size_t count = face->count;
    if (count >= ROBERTS_NONE - list->corner_count || list->count + 1 >= ROBERTS_NONE ||
        !array_reserve(&list->start, &list->start_room, list->count + 2, sizeof *list->start) ||
        !array_reserve(&list->corner, &list->corner_room, list->corner_count + count, sizeof *list->corner) ||
        !array_reserve(&list->solid, &list->solid_room, list->count + 1, sizeof *list->solid) ||
        !array_reserve(&list->origin, &list->origin_room, list->count + 1, sizeof *list->origin))
        return false;
    list->start[0] = 0;
    for (size_t i = 0; i < count; i++)
        list->corner[list->corner_count++] = scene_vertex_number(scene, face->first + face->corner[i]);
    list->solid[list->count] = s;
    list->origin[list->count] = face->origin;
    list->start[++list->count] = (uint32_t)list->corner_count;
    return true;
}

static bool keep_faces(face_list *list, const roberts_scene *scene, uint32_t s)
{
    for (uint32_t f = scene->solid[s].face; f < scene->solid[s + 1].face; f++) {
        const uint32_t start = scene->face_start[f], end = scene->face_start[f + 1];
        const new_face face = {scene->corner + start, end - start, 0, scene_face_number(scene, f)};
        if (!add_hull_face(list, scene, s, &face))
            return false;
    }
    return true;
}

static bool add_facets(face_list *list, const roberts_scene *scene, uint32_t s, const hull_facets *facets)
{
    for (uint32_t f = 0; f < facets->count; f++) {
        const uint32_t start = facets->start[f], end = facets->start[f + 1];
        const new_face face = {facets->corner + start, end - start, scene->solid[s].vertex, ROBERTS_NONE};
        if (!add_hull_face(list, scene, s, &face))
            return false;
    }
    return true;
}

/* ---- hulls ----------------------------------------------------------------------------------------------------- */

static hull_result result_of(build_result built, roberts_status refusal)
{
    if (built == BUILD_OK)
        return HULL_OK;
    if (built == BUILD_REFUSED && refusal == ROBERTS_NO_MEMORY)
        return HULL_NO_MEMORY;
    return built == BUILD_REFUSED && refusal == ROBERTS_FLAT ? HULL_FLAT : HULL_FAILED;
}

/* Do the facets form a solid that passes all checks? */
static hull_result try_facets(hull_maker *maker, uint32_t s)
{
    const roberts_scene *scene = maker->scene;
    const hull_facets *facets = &maker->facets;
    polygons faces = {.face_count = facets->count, .start = facets->start, .corner = facets->corner};
    const solid_rules rules = {maker->mesh, maker->tolerance, true};
    roberts_scene trial = {0};
    roberts_error refusal = {0};
    hull_result result = HULL_NO_MEMORY;
    if (array_reserve(&maker->zero, &maker->zero_room, facets->count, sizeof *maker->zero)) {
        memset(maker->zero, 0, facets->count * sizeof *maker->zero);
        if (scene_lay_out(&trial, &faces, maker->zero, 1, scene->point + scene->solid[s].vertex)) {
            build_result built = solid_build(&trial, &maker->work, 0, &rules, &refusal);
            result = result_of(built, refusal.status);
        }
    }
    scene_clear(&trial);
    return result;
}

/* Computes the hull of solid s, in the maker's frame, into maker->facets. All points must lie within it, up to
 * `allowed`: the checks of the solid see only the points that have become vertices. */
static hull_result try_width(hull_maker *maker, uint32_t s, double width, double allowed)
{
    const solid_frame *frame = &maker->frame;
    hull_result result = hull_take(&maker->facets, frame->point, frame->vertex_count, width);
    if (result == HULL_OK && maker->facets.outside > allowed)
        return HULL_FAILED;
    return result == HULL_OK ? try_facets(maker, s) : result;
}

/* Scales the frame to a size of about 1, and computes the hull with the best width. */
static hull_result make_hull(hull_maker *maker, uint32_t s)
{
    solid_frame *frame = &maker->frame;
    hull_result wide = HULL_FLAT, narrow;
    double part = fmin(WIDTH_PART * frame->allowed / frame->size, GREATEST_WIDTH), scale;
    int exponent;
    frexp(frame->size, &exponent);
    scale = ldexp(1.0, -exponent);
    for (uint32_t v = 0; v < frame->vertex_count; v++)
        frame->point[v] = vec3_scale(scale, frame->point[v]);
    if (part > LEAST_WIDTH)
        wide = try_width(maker, s, part * frame->size * scale, frame->allowed * scale);
    if (wide == HULL_OK || wide == HULL_NO_MEMORY)
        return wide;
    narrow = try_width(maker, s, 0.0, frame->allowed * scale);
    return narrow == HULL_FAILED && part > LEAST_WIDTH ? wide : narrow;
}

/* Appends the faces of the hull of solid s. A flat solid gets none, and FATE_FLAT. */
static roberts_status replace(face_list *list, hull_maker *maker, uint32_t s, uint8_t *fate, roberts_error *error)
{
    const roberts_scene *scene = maker->scene;
    const roberts_mesh *mesh = maker->mesh;
    roberts_status status = frame_enter(&maker->frame, scene, s, maker->tolerance);
    if (status == ROBERTS_NO_MEMORY)
        return error_no_memory(error);
    if (status != ROBERTS_OK)
        return hull_refuse(scene, s, mesh, status, "has none: one of them is not of finite numbers up to 1e150", error);
    frame_loosen(&maker->frame, scene);
    switch (maker->frame.size > 0.0 ? make_hull(maker, s) : HULL_FLAT) {
    case HULL_OK:
        return add_facets(list, scene, s, &maker->facets) ? ROBERTS_OK : error_no_memory(error);
    case HULL_FLAT:
        *fate = FATE_FLAT;
        return ROBERTS_OK;
    case HULL_FAILED:
        return hull_refuse(scene, s, mesh, ROBERTS_NOT_CONVEX, "could not be found: rounding is too much for it",
                           error);
    case HULL_NO_MEMORY:
        break;
    }
    return error_no_memory(error);
}

/* ---- all solids ------------------------------------------------------------------------------------------------ */

/* Solids are divided into at most this many runs; each run has its own list of faces. */
enum { RUNS_MOST = 256 };

typedef struct hull_job {
    roberts_scene *scene;
    const roberts_mesh *mesh;
    double tolerance;
    uint8_t *fate;  /* [solids] hull_fate */
    face_list *run; /* [runs] */
    uint32_t runs;
    /* the first solid known to have no hull; those after it need no work; ROBERTS_NONE: none */
    _Atomic uint32_t refused;
} hull_job;

/* State of one thread. */
typedef struct hull_worker {
    hull_maker maker;
    uint32_t refused; /* the first solid of this thread without a hull; `error` has the reason; ROBERTS_NONE: none */
    roberts_error error;
} hull_worker;

/* Returns the fate of a solid that was refused with this status. */
static hull_fate fate_of(roberts_status refusal)
{
    return refusal == ROBERTS_OK ? FATE_OPEN : refusal == ROBERTS_NOT_PLANAR ? FATE_BENT : FATE_DENTED;
}

/* Appends the faces of solid s: its own, or those of its hull, or none if it is flat. */
static roberts_status take_solid(const hull_job *job, hull_maker *maker, face_list *list, uint32_t s,
                                 roberts_error *error)
{
    roberts_scene *scene = job->scene;
    roberts_error refusal = {0};
    bool bare = scene_face_number(scene, scene->solid[s].face) >= job->mesh->face_count;
    const solid_rules rules = {job->mesh, job->tolerance, true};
    build_result built = bare ? BUILD_OPEN : solid_build(scene, &maker->work, s, &rules, &refusal);
    if (built == BUILD_OK)
        return keep_faces(list, scene, s) ? ROBERTS_OK : error_no_memory(error);
    if (refusal.status == ROBERTS_NO_MEMORY)
        return error_no_memory(error);
    job->fate[s] = bare ? FATE_KEPT : fate_of(refusal.status);
    return replace(list, maker, s, &job->fate[s], error);
}

/* Processes the solids of a run, up to the first solid known to have no hull. */
static void take_run(hull_job *job, hull_worker *worker, uint32_t run)
{
    const uint64_t solids = job->scene->solid_count;
    const uint32_t end = (uint32_t)(solids * (run + 1) / job->runs);
    for (uint32_t s = (uint32_t)(solids * run / job->runs); s < end; s++) {
        roberts_error error = {0};
        if (s > atomic_load_explicit(&job->refused, memory_order_relaxed))
            return;
        if (take_solid(job, &worker->maker, &job->run[run], s, &error) == ROBERTS_OK)
            continue;
        if (s < worker->refused) {
            worker->refused = s;
            worker->error = error;
        }
        thread_lower(&job->refused, s);
    }
}

/* Appends one list to another. False: no memory. */
static bool append_faces(face_list *list, const face_list *more)
{
    size_t count = list->count + more->count, corners = list->corner_count + more->corner_count;
    if (count >= ROBERTS_NONE || corners >= ROBERTS_NONE ||
        !array_reserve(&list->start, &list->start_room, count + 1, sizeof *list->start) ||
        !array_reserve(&list->corner, &list->corner_room, corners, sizeof *list->corner) ||
        !array_reserve(&list->solid, &list->solid_room, count, sizeof *list->solid) ||
        !array_reserve(&list->origin, &list->origin_room, count, sizeof *list->origin))
        return false;
    list->start[0] = 0;
    for (size_t f = 0; f < more->count; f++)
        list->start[list->count + f + 1] = (uint32_t)list->corner_count + more->start[f + 1];
    if (more->count > 0) {
        memcpy(list->corner + list->corner_count, more->corner, more->corner_count * sizeof *list->corner);
        memcpy(list->solid + list->count, more->solid, more->count * sizeof *list->solid);
        memcpy(list->origin + list->count, more->origin, more->count * sizeof *list->origin);
    }
    list->count = count;
    list->corner_count = corners;
    return true;
}

/* Fails with the refusal of the first solid without a hull, whichever thread found it. Otherwise joins the runs. */
static roberts_status join_runs(face_list *list, const hull_job *job, const hull_worker *worker, int threads,
                                roberts_error *error)
{
    const hull_worker *first = worker;
    for (int i = 1; i < threads; i++)
        if (worker[i].refused < first->refused)
            first = &worker[i];
    if (first->refused != ROBERTS_NONE) {
        *error = first->error;
        return error->status;
    }
    for (uint32_t run = 0; run < job->runs; run++)
        if (!append_faces(list, &job->run[run]))
            return error_no_memory(error);
    return ROBERTS_OK;
}

typedef struct hull_crew {
    hull_job *job;
    hull_worker *worker; /* [threads] */
} hull_crew;

static bool take_runs(void *context, size_t first, size_t end)
{
    const hull_crew *c = context;
    for (size_t run = first; run < end; run++)
        take_run(c->job, &c->worker[thread_self()], (uint32_t)run);
    return true;
}

/* Collects the faces of all solids, in order. The result does not depend on the threads. */
static roberts_status collect(face_list *list, uint8_t *fate, roberts_scene *scene, const roberts_mesh *mesh,
                              const roberts_scene_options *options, roberts_error *error)
{
    hull_job job = {.scene = scene, .mesh = mesh, .tolerance = options->tolerance, .fate = fate};
    job.runs = scene->solid_count < RUNS_MOST ? scene->solid_count : RUNS_MOST;
    int threads = threads_for(options->threads, job.runs);
    hull_worker *worker = alloc_zeroed((size_t)threads, sizeof *worker);
    roberts_status status = ROBERTS_NO_MEMORY;
    job.run = alloc_zeroed(job.runs, sizeof *job.run);
    atomic_init(&job.refused, ROBERTS_NONE);
    if (worker && job.run) {
        for (int i = 0; i < threads; i++)
            worker[i] = (hull_worker){.maker = {.scene = scene, .mesh = mesh, .tolerance = job.tolerance},
                                      .refused = ROBERTS_NONE};
        threads_each(threads, job.runs, 1, take_runs, &(hull_crew){&job, worker});
        status = join_runs(list, &job, worker, threads, error);
    } else {
        error_no_memory(error);
    }
    for (int i = 0; worker && i < threads; i++)
        hull_maker_free(&worker[i].maker);
    for (uint32_t run = 0; job.run && run < job.runs; run++)
        face_list_free(&job.run[run]);
    free(worker);
    free(job.run);
    return status;
}

/* Renumbers the solids that have faces; returns their number. */
static uint32_t number_solids(face_list *list)
{
    uint32_t count = 0, before = ROBERTS_NONE;
    for (size_t f = 0; f < list->count; f++) {
        count += list->solid[f] != before;
        before = list->solid[f];
        list->solid[f] = count - 1;
    }
    return count;
}

roberts_status hull_solids(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                           roberts_error *error)
{
    face_list list = {0};
    uint8_t *fate = alloc_zeroed(scene->solid_count, sizeof *fate);
    roberts_status status = fate ? collect(&list, fate, scene, mesh, options, error) : error_no_memory(error);
    if (status == ROBERTS_OK)
        status = send_warnings(fate, scene, mesh, &options->warnings, error);
    if (status == ROBERTS_OK) {
        const uint32_t solids = number_solids(&list);
        polygons faces = {.face_count = (uint32_t)list.count,
                          .vertex_count = (uint32_t)mesh->vertex_count,
                          .start = list.start,
                          .corner = list.corner};
        scene_clear(scene);
        if (!scene_lay_out(scene, &faces, list.solid, solids, mesh->vertex))
            status = error_no_memory(error);
        for (uint32_t f = 0; status == ROBERTS_OK && f < scene->face_count; f++)
            scene->face_number[f] = list.origin[scene->face_number[f]];
    }
    face_list_free(&list);
    free(fate);
    return status;
}
