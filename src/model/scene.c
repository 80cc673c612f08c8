/* scene.c - from polygons to solids: the stages in order. */
#include "model/scene.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "model/components.h"
#include "model/layout.h"
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

static roberts_status build_solids(roberts_scene *scene, builder *work, const roberts_mesh *mesh, double tolerance,
                                   roberts_error *error)
{
    for (uint32_t s = 0; s < scene->solid_count; s++)
        switch (solid_build(scene, work, s, mesh, tolerance, false, error)) {
        case BUILD_OK:
            break;
        case BUILD_OPEN:
            return error_set(error, ROBERTS_NOT_CLOSED, 0, "solid %u is not closed", s);
        case BUILD_REFUSED:
            return error->status;
        }
    scene->edge_count = scene->solid[scene->solid_count].edge;
    return ROBERTS_OK;
}

static roberts_status build(roberts_scene *scene, const roberts_mesh *mesh, double tolerance, roberts_error *error)
{
    polygons faces;
    builder work = {0};
    roberts_status status = polygons_of_mesh(&faces, mesh, error);
    scene->centre = (roberts_vec3){0, 0, 0};
    if (status != ROBERTS_OK)
        return status;
    status = components_lay_out(scene, &faces, mesh, error);
    if (status == ROBERTS_OK && scene->solid_count == 0)
        status = error_set(error, ROBERTS_NOT_CLOSED, 0, "no solid: there is no face with three or more corners");
    if (status == ROBERTS_OK) {
        scene->centre = vec3_scale(0.5, vec3_add(scene->box_min, scene->box_max));
        status = build_solids(scene, &work, mesh, tolerance, error);
    }
    if (status == ROBERTS_OK && !copy_colors(scene, mesh))
        status = error_no_memory(error);
    builder_free(&work);
    polygons_free(&faces);
    return status;
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
        status = build(*scene, mesh, tolerance, &found);
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
