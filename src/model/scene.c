/* scene.c - from polygons to solids: the stages in order. */
#include "model/scene.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "model/components.h"
#include "model/layout.h"
#include "model/regroup.h"
#include "model/solid_build.h"

/* Published polyhedra are given to six digits. */
static const double DEFAULT_TOLERANCE = 1e-5;

static bool copy_colors(roberts_scene *scene, const roberts_mesh *mesh)
{
    if (mesh->vertex_color) {
        scene->vertex_color = alloc_array(scene->vertex_count, sizeof *scene->vertex_color);
        if (!scene->vertex_color)
            return false;
        for (uint32_t v = 0; v < scene->vertex_count; v++)
            scene->vertex_color[v] = mesh->vertex_color[scene->number[v]];
    }
    if (mesh->face_color) {
        scene->face_color = alloc_array(scene->face_count, sizeof *scene->face_color);
        if (!scene->face_color)
            return false;
        for (uint32_t f = 0; f < scene->face_count; f++)
            scene->face_color[f] = mesh->face_color[scene->face_number[f]];
    }
    return true;
}

/* Builds the solids as laid out. `open`: NULL where all must be closed; else it receives a mark for each solid that is
 * not, and *any_open whether there is one; once there is, the others are only asked whether they are closed, since their
 * numbers will change. */
static roberts_status build_solids(roberts_scene *scene, builder *work, const roberts_mesh *mesh, double tolerance,
                                   uint8_t *open, bool *any_open, roberts_error *error)
{
    roberts_status refused = ROBERTS_OK;
    *any_open = false;
    scene->centre = vec3_scale(0.5, vec3_add(scene->box_min, scene->box_max));
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        build_result result = *any_open || refused != ROBERTS_OK
                                  ? solid_is_closed(scene, work, s, error)
                                  : solid_build(scene, work, s, mesh, tolerance, !open, error);
        if (result == BUILD_OPEN && !open)
            return error_set(error, ROBERTS_NOT_CLOSED, 0, "solid %u is not closed", s);
        if (result == BUILD_OPEN) {
            *any_open = true;
            open[s] = 1;
        }
        if (result == BUILD_REFUSED)
            refused = error->status;
        if (refused == ROBERTS_NO_MEMORY || (refused != ROBERTS_OK && !open))
            return refused;
    }
    scene->edge_count = scene->solid[scene->solid_count].edge;
    return *any_open ? ROBERTS_OK : refused;
}

static roberts_status refuse_empty(roberts_error *error)
{
    return error_set(error, ROBERTS_NOT_CLOSED, 0, "no solid: there is no face with three or more corners");
}

static void warn_repeated(const polygons *faces, const roberts_mesh *mesh, const roberts_warnings *warnings)
{
    const char *name = mesh->source_count == 1 && mesh->source[0].name ? mesh->source[0].name : "";
    if (faces->repeated > 0)
        warning_send(warnings, name, 0, "%zu corner%s that repeat%s another of the same face ignored", faces->repeated,
                     faces->repeated == 1 ? "" : "s", faces->repeated == 1 ? "s" : "");
}

/* Components first; where some are open, solids once more from what welding and splitting makes of them. */
static roberts_status build(roberts_scene *scene, const roberts_mesh *mesh, double tolerance,
                            const roberts_warnings *warnings, roberts_error *error)
{
    polygons faces;
    builder work = {0};
    uint8_t *open = NULL;
    bool any_open = false;
    roberts_status status = polygons_of_mesh(&faces, mesh, error);
    if (status != ROBERTS_OK)
        return status;
    status = ROBERTS_NO_MEMORY;
    if (!components_lay_out(scene, &faces, mesh))
        goto done;
    warn_repeated(&faces, mesh, warnings);
    if (!(open = alloc_zeroed(scene->solid_count, sizeof *open)))
        goto done;
    status = build_solids(scene, &work, mesh, tolerance, open, &any_open, error);
    if (status == ROBERTS_OK && any_open) {
        status = regroup(scene, open, &faces, mesh, error);
        if (status == ROBERTS_OK)
            status = build_solids(scene, &work, mesh, tolerance, NULL, &any_open, error);
    }
    if (status == ROBERTS_OK && scene->solid_count == 0)
        status = refuse_empty(error);
    if (status == ROBERTS_OK && !copy_colors(scene, mesh))
        status = ROBERTS_NO_MEMORY;
done:
    free(open);
    builder_free(&work);
    polygons_free(&faces);
    return status == ROBERTS_NO_MEMORY ? error_no_memory(error) : status;
}

roberts_status roberts_scene_build(const roberts_mesh *mesh, const roberts_scene_options *options,
                                   roberts_scene **scene, roberts_error *error)
{
    double tolerance = options && options->tolerance != 0.0 ? options->tolerance : DEFAULT_TOLERANCE;
    roberts_error found = {0};
    roberts_status status;
    *scene = NULL;
    if (!(tolerance > 0.0 && tolerance <= 1.0)) {
        status = error_set(&found, ROBERTS_BAD_ARGUMENT, 0, "the tolerance, %g, is not between 0 and 1", tolerance);
    } else if (!(*scene = alloc_zeroed(1, sizeof **scene))) {
        status = error_no_memory(&found);
    } else {
        status = build(*scene, mesh, tolerance, options ? &options->warnings : NULL, &found);
    }
    if (status != ROBERTS_OK) {
        roberts_scene_free(*scene);
        *scene = NULL;
        if (error)
            *error = found;
    }
    return status;
}

void roberts_scene_free(roberts_scene *scene)
{
    if (scene)
        layout_clear(scene);
    free(scene);
}

size_t roberts_scene_solid_count(const roberts_scene *scene)
{
    return scene->solid_count;
}

size_t roberts_scene_face_count(const roberts_scene *scene)
{
    return scene->face_count;
}

size_t roberts_scene_edge_count(const roberts_scene *scene)
{
    return scene->edge_count;
}

size_t roberts_scene_vertex_count(const roberts_scene *scene)
{
    return scene->vertex_count;
}
