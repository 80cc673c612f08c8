/* source.c - which input file a solid comes from.
 *
 * In a mesh the inputs follow one another, and solids are numbered by their smallest vertex, so the solids of a file
 * have consecutive numbers. A solid whose faces or welded vertices come from several files has no file; its numbers
 * count over all files. */
#include "model/source.h"

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
