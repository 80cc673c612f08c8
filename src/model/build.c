/* build.c - from polygons to solids: the stages in order. */
#include "model/scene.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/error.h"
#include "base/threads.h"
#include "model/bodies.h"
#include "model/body_edges.h"
#include "model/components.h"
#include "model/convex.h"
#include "model/hull.h"
#include "model/plain_bodies.h"
#include "model/needles.h"
#include "model/repeated_solids.h"
#include "model/solid.h"
#include "model/weld.h"
#include "read/mesh.h"

#define CHUNK_SOLIDS 256
#define CHUNKS_PER_THREAD 4 /* with less work, another thread does not pay */

/* Marks of solids that are not of the kind `opening`. OPENING_NONE: closed, and with `bodies` also convex. */
enum {
    NOT_CONVEX = OPENING_HOLES + 1, /* only with `bodies`: closed, but not convex */
    GLANCED                         /* only with `bodies`: not convex; its edges are unknown */
};

/* State shared by the threads that build solids. */
typedef struct construction {
    roberts_scene *scene;
    const roberts_scene_options *options;
    solid_rules rules;
    uint8_t *open; /* [solid_count] receives the marks; NULL: an open solid is an error */
    bool bodies;   /* solids may be of any shape */
    atomic_bool any_marked;
    atomic_bool any_open;
    _Atomic uint32_t refused; /* the first solid known to be refused; ROBERTS_NONE: none */
} construction;

/* State of one thread. */
typedef struct construction_worker {
    builder tools;
    roberts_error found; /* why the current solid is refused */
    uint32_t refused;    /* the first solid that this thread refused; ROBERTS_NONE: none */
    roberts_error error; /* why it was refused */
    bool no_memory;
    char apart[THREADS_APART];
} construction_worker;

/* Copies the colours, except those that roberts_scene_take() can take over unchanged. False: no memory. */
static bool copy_colors(roberts_scene *scene, const roberts_mesh *mesh, bool lend)
{
    if (mesh->vertex_color && (scene->number || !lend)) {
        scene->vertex_color = alloc_array(scene->vertex_count, sizeof *scene->vertex_color);
        if (!scene->vertex_color)
            return false;
        for (uint32_t v = 0; v < scene->vertex_count; v++)
            if (scene_vertex_number(scene, v) == ROBERTS_NONE)
                scene->vertex_color[v] = (roberts_color){0};
            else
                scene->vertex_color[v] = mesh->vertex_color[scene_vertex_number(scene, v)];
    }
    if (mesh->face_color && (scene->face_number || !lend)) {
        scene->face_color = alloc_array(scene->face_count, sizeof *scene->face_color);
        if (!scene->face_color)
            return false;
        for (uint32_t f = 0; f < scene->face_count; f++) {
            uint32_t number = scene_face_number(scene, f);
            scene->face_color[f] = (roberts_color){0};
            if (number != ROBERTS_NONE)
                scene->face_color[f] = mesh->face_color[number];
        }
    }
    return true;
}

/* Stores the edges of a finished solid. The edges of a shared pattern are already stored, for both windings. The faces
 * of the first edge tell which winding this solid has. */
static void store_edges(roberts_scene *scene, uint32_t s, const solid_frame *frame)
{
    scene_edge *stored = scene->edge + scene->solid[s].stored;
    if (scene->solid[s].stored >= scene->shared)
        memcpy(stored, frame->edge, frame->edge_count * sizeof *stored);
    else if (frame->edge->f[0] != stored->f[0])
        scene->solid[s].stored += frame->edge_count;
}

static void mark(construction *c, uint32_t s, uint8_t as)
{
    c->open[s] = as;
    atomic_store_explicit(&c->any_marked, true, memory_order_relaxed);
    if (as < NOT_CONVEX)
        atomic_store_explicit(&c->any_open, true, memory_order_relaxed);
}

static void refuse(construction *c, construction_worker *worker, uint32_t s)
{
    roberts_error *found = &worker->found;
    worker->no_memory |= found->status == ROBERTS_NO_MEMORY;
    if (s < worker->refused) {
        error_set_file(found, source_of_solid(c->scene, s, c->rules.mesh).file);
        worker->refused = s;
        worker->error = *found;
    }
    thread_lower(&c->refused, s);
}

/* Was the model refused for its shape alone? */
static bool is_shape(roberts_status status)
{
    return status == ROBERTS_NOT_CLOSED || status == ROBERTS_NOT_PLANAR || status == ROBERTS_NOT_CONVEX ||
           status == ROBERTS_FLAT;
}

/* Builds solid s if it is convex; otherwise marks it. Once some solid is open, the others are first checked for being
 * closed: in a soup, none is. */
static void build_or_mark(construction *c, construction_worker *worker, uint32_t s)
{
    build_result result = BUILD_OK;
    if (solid_surely_not_convex(c->scene, s, c->rules.tolerance)) {
        mark(c, s, GLANCED);
        return;
    }
    if (atomic_load_explicit(&c->any_open, memory_order_relaxed))
        result = solid_is_closed(c->scene, &worker->tools, s, &worker->found);
    if (result == BUILD_OK)
        result = solid_build(c->scene, &worker->tools, s, &c->rules, &worker->found);
    if (result == BUILD_OK)
        store_edges(c->scene, s, &worker->tools.frame);
    else if (result == BUILD_OPEN)
        mark(c, s, (uint8_t)worker->tools.opening);
    else if (is_shape(worker->found.status))
        mark(c, s, NOT_CONVEX);
    else
        refuse(c, worker, s);
}

/* Builds solid s, or does less if the rest is known to be useless. Once some solid is open, the others are only checked
 * for being closed, since all will be numbered again. The same holds for solids after a refused one. */
static void build_solid(construction *c, construction_worker *worker, uint32_t s)
{
    const bool only_ask = atomic_load_explicit(&c->any_open, memory_order_relaxed) ||
                          s > atomic_load_explicit(&c->refused, memory_order_relaxed);
    roberts_error *found = &worker->found;
    build_result result;
    if (c->bodies) {
        build_or_mark(c, worker, s);
        return;
    }
    if (only_ask && !c->open)
        return;
    result = only_ask ? solid_is_closed(c->scene, &worker->tools, s, found)
                      : solid_build(c->scene, &worker->tools, s, &c->rules, found);
    if (result == BUILD_OPEN && c->open) {
        mark(c, s, (uint8_t)worker->tools.opening);
        return;
    }
    if (result == BUILD_OPEN) {
        error_set(found, ROBERTS_NOT_CLOSED, 0, "solid %u is not closed",
                  s - source_of_solid(c->scene, s, c->rules.mesh).solid);
        result = BUILD_REFUSED;
    }
    if (result == BUILD_OK && !only_ask)
        store_edges(c->scene, s, &worker->tools.frame);
    if (result == BUILD_REFUSED)
        refuse(c, worker, s);
}

/* Returns the refusal of the first refused solid, whichever thread found it. Lack of memory takes precedence. */
static roberts_status first_refusal(const construction *c, const construction_worker *worker, int threads,
                                    roberts_error *error)
{
    const construction_worker *first = worker;
    for (int i = 0; i < threads; i++) {
        if (worker[i].no_memory)
            return error_no_memory(error);
        if (worker[i].refused < first->refused)
            first = &worker[i];
    }
    if (first->refused == ROBERTS_NONE || atomic_load(&c->any_open))
        return ROBERTS_OK;
    *error = first->error;
    return first->error.status;
}

static void free_workers(construction_worker *worker, int threads)
{
    for (int i = 0; worker && i < threads; i++)
        builder_free(&worker[i].tools);
    free(worker);
}

/* Numbers the edges. If `list` is empty, the patterns are found first. False: no memory. */
static bool number_all_edges(roberts_scene *scene, repeated_solids *list, edge_scratch *scratch)
{
    return (list->count > 0 || repeated_find(list, scene)) && repeated_number_edges(list, scene, scratch);
}

typedef struct building {
    construction *c;
    construction_worker *worker; /* [threads] */
} building;

static bool build_some(void *context, size_t first, size_t end)
{
    const building *b = context;
    for (size_t s = first; s < end; s++)
        build_solid(b->c, &b->worker[thread_self()], (uint32_t)s);
    return true;
}

/* Builds the solids of a scene that is laid out. `list` has their patterns, or is empty and receives them. `c` has the
 * scene, the options, the rules and the array for marks; afterwards c->any_open tells whether a solid is open. The
 * result does not depend on the number of threads. */
static roberts_status build_solids(construction *c, repeated_solids *list, roberts_error *error)
{
    const uint32_t solids = c->scene->solid_count, chunks = (solids + CHUNK_SOLIDS - 1) / CHUNK_SOLIDS;
    int threads = threads_for(c->options->threads, 1 + chunks / CHUNKS_PER_THREAD);
    construction_worker *worker = alloc_zeroed((size_t)threads, sizeof *worker);
    roberts_status status;
    if (!worker || !number_all_edges(c->scene, list, &worker[0].tools.edges)) {
        free_workers(worker, threads);
        return error_no_memory(error);
    }
    atomic_init(&c->any_open, false);
    atomic_init(&c->any_marked, false);
    atomic_init(&c->refused, ROBERTS_NONE);
    for (int i = 0; i < threads; i++)
        worker[i].refused = ROBERTS_NONE;
    threads_each(threads, solids, CHUNK_SOLIDS, build_some, &(building){c, worker});
    status = first_refusal(c, worker, threads, error);
    free_workers(worker, threads);
    return status;
}

/* Returns the file's name if there is only one file. */
static const char *only_name(const roberts_mesh *mesh)
{
    return mesh->source_count == 1 && mesh->source[0].name ? mesh->source[0].name : "";
}

static roberts_status refuse_empty(const roberts_mesh *mesh, roberts_error *error)
{
    error_set(error, ROBERTS_NOT_CLOSED, 0, "nothing to draw: there is no face with three different corners");
    return error_in(error, only_name(mesh), ROBERTS_NOT_CLOSED);
}

static void warn_repeated(size_t corners, const roberts_mesh *mesh, const roberts_warnings *warnings)
{
    const char *name = only_name(mesh);
    if (corners > 0)
        warning_send(warnings, name, 0, "%zu corner%s that repeat%s another of the same face ignored", corners,
                     corners == 1 ? "" : "s", corners == 1 ? "s" : "");
}

static void warn_copies(noted_faces noted, const roberts_mesh *mesh, const roberts_warnings *warnings)
{
    const size_t faces = noted.count;
    if (faces > 0)
        warning_send(warnings, source_of_noted(mesh, noted), 0, "%zu face%s an earlier one, and %s", faces,
                     faces == 1 ? " repeats" : "s repeat", faces == 1 ? "does not count" : "do not count");
}

static void warn_bent(noted_faces noted, const roberts_mesh *mesh, const roberts_warnings *warnings)
{
    const size_t faces = noted.count;
    if (faces > 0)
        warning_send(warnings, source_of_noted(mesh, noted), 0,
                     "%zu face%s and %s not planar: lines on %s may be wrong", faces,
                     faces == 1 ? " crosses or touches itself" : "s cross or touch themselves",
                     faces == 1 ? "is" : "are", faces == 1 ? "it" : "them");
}

static void warn_uncut(noted_faces noted, const roberts_mesh *mesh, const roberts_warnings *warnings)
{
    const size_t faces = noted.count;
    if (faces > 0)
        warning_send(warnings, source_of_noted(mesh, noted), 0, "%zu face%s too often to be cut: %s nothing", faces,
                     faces == 1 ? " crosses itself" : "s cross themselves", faces == 1 ? "it hides" : "they hide");
}

/* Are all open solids closed surfaces with holes? Welding and splitting cannot make them convex. */
static bool only_holes(const uint8_t *open, uint32_t count)
{
    for (uint32_t s = 0; s < count; s++)
        if (open[s] && open[s] != OPENING_HOLES)
            return false;
    return true;
}

/* Makes plain bodies of the marked solids, if possible. *done: it succeeded or failed for good. Otherwise the marks
 * show which solids are open, and the status is that of the first one that is not convex. */
static roberts_status build_plain(construction *c, const polygons *faces, const repeated_solids *list,
                                  roberts_status status, bool *done, roberts_error *error)
{
    roberts_scene *scene = c->scene;
    const roberts_mesh *mesh = c->rules.mesh;
    builder work = {0};
    *done = false;
    if (status == ROBERTS_OK && scene->face_count == mesh->face_count && faces->repeated == 0) {
        const face_rules rules = bodies_rules(scene, mesh, c->options);
        plain_answer answer = plain_bodies_build(scene, c->open, list, &rules);
        *done = answer != PLAIN_NO;
        if (*done)
            return answer == PLAIN_YES ? ROBERTS_OK : ROBERTS_NO_MEMORY;
    }
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        if (c->open[s] == GLANCED && status != ROBERTS_NO_MEMORY) {
            build_result result = solid_is_closed(scene, &work, s, error);
            if (result == BUILD_REFUSED)
                status = ROBERTS_NO_MEMORY;
            mark(c, s, result == BUILD_OPEN ? (uint8_t)work.opening : NOT_CONVEX);
        }
        if (c->open[s] == NOT_CONVEX) {
            c->open[s] = 0;
            if (status == ROBERTS_OK || (status != ROBERTS_NO_MEMORY && s < atomic_load(&c->refused)))
                status = error_set(error, ROBERTS_NOT_CONVEX, 0, "solid %u is not convex", s);
        }
    }
    builder_free(&work);
    return status == ROBERTS_NO_MEMORY || !atomic_load(&c->any_open) ? status : ROBERTS_OK;
}

/* Facts found while building a scene of solids. */
typedef struct solid_notes {
    bool known;      /* some component is known not to be a convex solid */
    size_t repeated; /* corners left out because they repeat another of their face */
} solid_notes;

/* Builds the components as solids. If some are open, welds and splits them, and builds all solids again. */
static roberts_status build_convex(roberts_scene *scene, const roberts_mesh *mesh, bool lend,
                                   const roberts_scene_options *options, solid_notes *notes, roberts_error *error)
{
    polygons faces;
    repeated_solids list = {0};
    const bool bodies = !options->solids && !options->hull;
    construction c = {scene, options, .rules = {mesh, options->tolerance, false}, .bodies = bodies};
    bool any_open, done = false;
    roberts_status status = polygons_of_mesh(&faces, mesh, error);
    if (status != ROBERTS_OK)
        return status;
    status = ROBERTS_NO_MEMORY;
    if (!components_lay_out(scene, &faces, mesh, lend, &list))
        goto done;
    notes->repeated = faces.repeated;
    if (!(c.open = alloc_zeroed(scene->solid_count, sizeof *c.open)))
        goto done;
    status = build_solids(&c, &list, error);
    if (status != ROBERTS_NO_MEMORY && atomic_load(&c.any_marked) && bodies)
        status = build_plain(&c, &faces, &list, status, &done, error);
    any_open = status == ROBERTS_OK && !done && atomic_load(&c.any_open);
    notes->known = is_shape(status);
    if (any_open && bodies && only_holes(c.open, scene->solid_count)) {
        status = error_set(error, ROBERTS_NOT_CONVEX, 0, "a surface has holes"); /* bodies_build() handles it */
        notes->known = true;
    } else if (any_open) {
        construction closed = {scene, options, .rules = {mesh, options->tolerance, true}};
        repeated_free(&list);
        scene_turn_back(scene); /* regrouping starts from the original winding */
        status = weld_regroup(scene, c.open, &faces, mesh, false, error);
        if (status == ROBERTS_OK)
            status = build_solids(&closed, &list, error);
    }
    if (status == ROBERTS_OK && scene->solid_count == 0)
        status = refuse_empty(mesh, error);
    if (status == ROBERTS_OK && !copy_colors(scene, mesh, lend))
        status = ROBERTS_NO_MEMORY;
done:
    free(c.open);
    repeated_free(&list);
    polygons_free(&faces);
    return status == ROBERTS_NO_MEMORY ? error_no_memory(error) : status;
}

/* Marks the open components, except those that stand for points without faces. */
static roberts_status find_open(roberts_scene *scene, builder *work, const roberts_mesh *mesh, uint8_t *open,
                                bool *any_open, roberts_error *error)
{
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        build_result result = solid_is_closed(scene, work, s, error);
        if (result == BUILD_REFUSED)
            return error->status;
        if (scene_face_number(scene, scene->solid[s].face) < mesh->face_count)
            open[s] = (uint8_t)work->opening;
        *any_open |= open[s] != OPENING_NONE;
    }
    return ROBERTS_OK;
}

/* Builds a scene in which hulls replace solids that would be refused. Components are welded and split as above, inputs
 * of points are added as components, and then hulls are taken. The warnings have already been sent. */
static roberts_status build_hulls(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                                  roberts_error *error)
{
    polygons faces;
    repeated_solids list = {0};
    builder work = {0};
    construction closed = {scene, options, .rules = {mesh, options->tolerance, true}};
    uint8_t *open = NULL;
    bool any_open = false;
    roberts_status status = polygons_of_mesh(&faces, mesh, error);
    if (status == ROBERTS_OK)
        status = hull_add_inputs(&faces, mesh, error);
    if (status == ROBERTS_OK && !(components_lay_out(scene, &faces, mesh, false, &list) &&
                                  (open = alloc_zeroed(scene->solid_count, sizeof *open))))
        status = ROBERTS_NO_MEMORY;
    repeated_free(&list); /* hulls have different patterns */
    if (status == ROBERTS_OK)
        status = find_open(scene, &work, mesh, open, &any_open, error);
    if (status == ROBERTS_OK && any_open)
        status = weld_regroup(scene, open, &faces, mesh, true, error);
    if (status == ROBERTS_OK && scene->solid_count == 0)
        status = refuse_empty(mesh, error);
    if (status == ROBERTS_OK)
        status = hull_solids(scene, mesh, options, error);
    if (status == ROBERTS_OK)
        status = build_solids(&closed, &list, error);
    if (status == ROBERTS_OK && !copy_colors(scene, mesh, false))
        status = ROBERTS_NO_MEMORY;
    free(open);
    repeated_free(&list);
    builder_free(&work);
    polygons_free(&faces);
    return status == ROBERTS_NO_MEMORY ? error_no_memory(error) : status;
}

/* Are there elements of two corners that are not edges of the solids? */
static bool has_wires(const roberts_scene *scene, const roberts_mesh *mesh, roberts_status *status)
{
    bool found = false;
    if (*status == ROBERTS_OK && scene->face_count < mesh->face_count && !body_edges_wires(scene, mesh, &found))
        *status = ROBERTS_NO_MEMORY;
    return found;
}

/* Builds a scene whose bodies need not be convex. */
static roberts_status build_bodies(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                                   bool known, roberts_error *error)
{
    bodies_notes notes = {0};
    roberts_status status = bodies_build(scene, mesh, options, known, &notes, error);
    if (status == ROBERTS_OK) {
        warn_repeated(notes.repeated, mesh, &options->warnings);
        warn_copies(notes.copies, mesh, &options->warnings);
        warn_bent(notes.bent, mesh, &options->warnings);
        warn_uncut(notes.uncut, mesh, &options->warnings);
    }
    if (status == ROBERTS_OK && !copy_colors(scene, mesh, false))
        status = error_no_memory(error);
    return status;
}

static bool copy_groups(roberts_scene *scene, const roberts_mesh *mesh)
{
    scene->group = mesh_groups_copy(mesh);
    scene->group_count = scene->group ? mesh->group_count : 0;
    return scene->group_count == mesh->group_count;
}

static roberts_status check_input(const roberts_mesh *mesh, const roberts_scene_options *options,
                                  const scene_whole *whole, roberts_error *error)
{
    if (!(options->tolerance > 0.0 && options->tolerance <= 1.0))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "the tolerance, %g, is not between 0 and 1",
                         options->tolerance);
    if (options->threads > ROBERTS_THREADS_MOST)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "more than %d threads", ROBERTS_THREADS_MOST);
    /* Readers check that corners name vertices, and so do plans. */
    const bool checked = mesh->source_count > 0 || whole;
    return checked ? ROBERTS_OK : mesh_check_arrays(mesh, error);
}

/* Builds a scene of convex solids; if that fails, one of hulls or of bodies of any kind, as the options say. */
static roberts_status build_any(roberts_scene *scene, const roberts_mesh *mesh, bool lend,
                                const roberts_scene_options *options, roberts_error *error)
{
    solid_notes notes = {0};
    roberts_status status = build_convex(scene, mesh, lend, options, &notes, error);
    const bool bodies = !options->solids && !options->hull && (is_shape(status) || has_wires(scene, mesh, &status));
    if (!bodies)
        warn_repeated(notes.repeated, mesh, &options->warnings);
    if (options->hull && status != ROBERTS_NO_MEMORY && (status != ROBERTS_OK || hull_bare_input(mesh))) {
        scene_clear(scene);
        *error = (roberts_error){0};
        return build_hulls(scene, mesh, options, error);
    }
    if (bodies) {
        roberts_error other = {0};
        scene_clear(scene);
        status = build_bodies(scene, mesh, options, notes.known, &other);
        if (status != ROBERTS_NOT_CLOSED)
            *error = other;
        return status;
    }
    return status == ROBERTS_NO_MEMORY ? error_no_memory(error) : status;
}

/* whole: NULL, or what the mesh is a part of. */
static roberts_status build_scene(const roberts_mesh *mesh, bool lend, const roberts_scene_options *options,
                                  const scene_whole *whole, roberts_scene **scene, roberts_error *error)
{
    roberts_scene_options chosen = options ? *options : (roberts_scene_options){0};
    roberts_error found = {0};
    *scene = NULL;
    if (chosen.tolerance == 0.0)
        chosen.tolerance = SCENE_TOLERANCE;
    roberts_status status = check_input(mesh, &chosen, whole, &found);
    if (status == ROBERTS_OK && !(*scene = alloc_zeroed(1, sizeof **scene)))
        status = error_no_memory(&found);
    if (status == ROBERTS_OK) {
        (*scene)->whole = whole;
        (*scene)->steps = whole ? whole->steps : mesh_rounding(mesh, chosen.rounded);
        status = build_any(*scene, mesh, lend, &chosen, &found);
    }
    if (status == ROBERTS_OK && (*scene)->surface && !needles_find(*scene))
        status = error_no_memory(&found);
    if (status == ROBERTS_OK && !lend) {
        free((*scene)->turned);
        (*scene)->turned = NULL;
        if (!copy_groups(*scene, mesh))
            status = error_no_memory(&found);
    }
    if (status != ROBERTS_OK) {
        roberts_scene_free(*scene);
        *scene = NULL;
        if (error)
            *error = found;
    }
    return status;
}

roberts_status roberts_scene_build(const roberts_mesh *mesh, const roberts_scene_options *options,
                                   roberts_scene **scene, roberts_error *error)
{
    return build_scene(mesh, false, options, NULL, scene, error);
}

/* Removes from the mesh the arrays that the scene now owns. */
static void release_taken(roberts_scene *scene, roberts_mesh *mesh)
{
    if (scene->lent & LENT_POINT)
        mesh->vertex = NULL;
    if (scene->lent & LENT_FACE_START)
        mesh->face_start = NULL;
    if (scene->lent & LENT_CORNER)
        mesh->corner = NULL;
    free(scene->turned);
    scene->turned = NULL;
    scene->lent = 0;
    if (!scene->vertex_color) {
        scene->vertex_color = mesh->vertex_color;
        mesh->vertex_color = NULL;
    }
    if (!scene->face_color) {
        scene->face_color = mesh->face_color;
        mesh->face_color = NULL;
    }
    scene->group = mesh->group;
    scene->group_count = mesh->group_count;
    mesh->group = NULL;
    mesh->group_count = 0;
}

roberts_status scene_take_part(roberts_mesh *mesh, const roberts_scene_options *options, const scene_whole *whole,
                               roberts_scene **scene, roberts_error *error)
{
    roberts_status status = build_scene(mesh, true, options, whole, scene, error);
    if (status != ROBERTS_OK)
        return status;
    release_taken(*scene, mesh);
    roberts_mesh_free(mesh);
    return ROBERTS_OK;
}

roberts_status roberts_scene_take(roberts_mesh *mesh, const roberts_scene_options *options, roberts_scene **scene,
                                  roberts_error *error)
{
    return scene_take_part(mesh, options, NULL, scene, error);
}

void roberts_scene_free(roberts_scene *scene)
{
    if (scene)
        scene_clear(scene);
    free(scene);
}
