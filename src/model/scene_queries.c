/* scene_queries.c - queries of a scene: how much of the input it contains, the kinds of its bodies, and which body an
 * element belongs to. */
#include "model/scene.h"

uint32_t scene_body_of_face(const roberts_scene *scene, uint32_t face)
{
    uint32_t low = 0, high = scene->solid_count;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (scene->solid[middle].face <= face)
            low = middle;
        else
            high = middle;
    }
    return low;
}

uint32_t scene_body_of_edge(const roberts_scene *scene, uint32_t edge)
{
    uint32_t low = 0, high = scene->solid_count;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (scene->solid[middle].edge <= edge)
            low = middle;
        else
            high = middle;
    }
    return low;
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
