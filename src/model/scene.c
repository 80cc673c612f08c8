/* scene.c - from polygons to solids: the stages in order, memory, messages. */
#include "model/scene.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "model/components.h"
#include "model/solid_build.h"

/* As DESIGN says: published polyhedra are given to six digits. */
static const double DEFAULT_TOLERANCE = 1e-5;

static bool scene_alloc(roberts_scene *scene, const grouping *group)
{
    size_t faces = group->start[group->solid_count], edges = group->corner_count / 2;
    scene->solid = alloc_zeroed((size_t)group->solid_count + 1, sizeof *scene->solid);
    scene->point = alloc_array(group->vertex_count, sizeof *scene->point);
    scene->number = alloc_array(group->vertex_count, sizeof *scene->number);
    scene->face_start = alloc_zeroed(faces + 1, sizeof *scene->face_start);
    scene->corner = alloc_array(group->corner_count, sizeof *scene->corner);
    scene->face_plane = alloc_array(faces, sizeof *scene->face_plane);
    scene->face_deviation = alloc_array(faces, sizeof *scene->face_deviation);
    scene->face_width = alloc_array(faces, sizeof *scene->face_width);
    scene->face_number = alloc_array(faces, sizeof *scene->face_number);
    scene->edge = alloc_array(edges, sizeof *scene->edge);
    scene->box_min = group->box_min;
    scene->box_max = group->box_max;
    scene->centre = vec3_scale(0.5, vec3_add(group->box_min, group->box_max));
    return scene->solid && scene->point && scene->number && scene->face_start && scene->corner && scene->face_plane &&
           scene->face_deviation && scene->face_width && scene->face_number && scene->edge;
}

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

static roberts_status build_solids(roberts_scene *scene, builder *work, const grouping *group, roberts_error *error)
{
    for (uint32_t s = 0; s < group->solid_count; s++)
        switch (solid_build(scene, work, group, s, error)) {
        case BUILD_OK:
            break;
        case BUILD_OPEN:
            return error_set(error, ROBERTS_NOT_CLOSED, 0, "solid %u is not closed", s);
        case BUILD_REFUSED:
            return error->status;
        case BUILD_NO_MEMORY:
            return error_no_memory(error);
        }
    scene->corner_count = scene->face_start[scene->face_count];
    return ROBERTS_OK;
}

roberts_status roberts_scene_build(const roberts_mesh *mesh, const roberts_scene_options *options,
                                   roberts_scene **scene, roberts_error *error)
{
    roberts_error ignored;
    polygons faces = {0};
    grouping group = {0};
    builder work = {.mesh = mesh, .faces = &faces};
    roberts_status status;
    *scene = NULL;
    error = error ? error : &ignored;
    work.tolerance = options && options->tolerance != 0.0 ? options->tolerance : DEFAULT_TOLERANCE;
    if (!(work.tolerance > 0.0 && work.tolerance <= 1.0))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "tolerance %g is not between 0 and 1", work.tolerance);
    if ((status = polygons_clean(&faces, mesh, error)) != ROBERTS_OK)
        goto done;
    if ((status = components_find(&group, &faces, mesh->vertex, error)) != ROBERTS_OK)
        goto done;
    if (group.solid_count == 0) {
        status = error_set(error, ROBERTS_NOT_CLOSED, 0, "no solid: there is no face with 3 or more corners");
        goto done;
    }
    *scene = alloc_zeroed(1, sizeof **scene);
    if (!*scene || !scene_alloc(*scene, &group)) {
        status = error_no_memory(error);
        goto done;
    }
    if ((status = build_solids(*scene, &work, &group, error)) != ROBERTS_OK)
        goto done;
    if (!copy_colors(*scene, mesh))
        status = error_no_memory(error);
done:
    builder_free(&work);
    grouping_free(&group);
    polygons_free(&faces);
    if (status != ROBERTS_OK) {
        roberts_scene_free(*scene);
        *scene = NULL;
    }
    return status;
}

void roberts_scene_free(roberts_scene *scene)
{
    if (!scene)
        return;
    free(scene->solid);
    free(scene->point);
    free(scene->number);
    free(scene->face_start);
    free(scene->corner);
    free(scene->face_plane);
    free(scene->face_deviation);
    free(scene->face_width);
    free(scene->face_number);
    free(scene->edge);
    free(scene->vertex_color);
    free(scene->face_color);
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
