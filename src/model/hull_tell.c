/* hull_tell.c - what is said of solids in whose place there is a hull, or nothing. */
#include "model/hull_tell.h"

#include <stdio.h>

#include "base/error.h"
#include "model/hull_inputs.h"
#include "model/place.h"

roberts_status hull_refuse(const roberts_scene *scene, uint32_t s, const roberts_mesh *mesh, roberts_status status,
                           const char *why, roberts_error *error)
{
    place at = place_of_points(scene, s, mesh);
    error_set_file(error, at.file);
    return error_set(error, status, 0, "the convex hull of solid %u, of %u points from vertex %u on, %s", s - at.solid,
                     scene->solid[s + 1].vertex - scene->solid[s].vertex,
                     scene_vertex_number(scene, scene->solid[s].vertex) - at.vertex, why);
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

/* "3 solids replaced by their convex hulls: 2 not closed, 1 not convex", without the counts where there is one reason only. */
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

/* An input has the solids whose first vertex is in it. */
roberts_status hull_tell(const uint8_t *fate, const roberts_scene *scene, const roberts_mesh *mesh,
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
