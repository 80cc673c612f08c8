/* cut_lines.c - see cut_lines.h. The near plane is a plane of one depth in view space, and nothing is nearer. So the
 * lines are the sides of faces with both ends at the greatest depth of all. */
#include "hide/cut_lines.h"

#include <stdlib.h>

#include "base/array.h"

static bool is_mapped(const hide_fronts *fronts, uint32_t body)
{
    return !fronts->culled[body];
}

static double greatest_depth(const hide_fronts *fronts)
{
    const roberts_scene *scene = fronts->scene;
    double most = -INFINITY;
    for (uint32_t s = 0; s < scene->solid_count; s++)
        for (uint32_t v = scene->solid[s].vertex; is_mapped(fronts, s) && v < scene->solid[s + 1].vertex; v++)
            most = greater(most, fronts->P[v].z);
    return most;
}

typedef struct line_list {
    seen_line *line; /* [count] */
    size_t count, room;
} line_list;

/* Adds the sides of a face that lie at the depth `least` or nearer. False: no memory. */
static bool add_sides(const hide_fronts *fronts, uint32_t body, uint32_t face, double least, line_list *to)
{
    const roberts_scene *scene = fronts->scene;
    uint32_t first = scene->face_start[face], end = scene->face_start[face + 1];
    for (uint32_t k = first; k < end; k++) {
        uint32_t v[2] = {scene->corner[k], scene->corner[k + 1 < end ? k + 1 : first]};
        if (fronts->P[v[0]].z < least || fronts->P[v[1]].z < least)
            continue;
        if (!array_reserve(&to->line, &to->room, to->count + 1, sizeof *to->line))
            return false;
        to->line[to->count++] = (seen_line){.edge = ROBERTS_NONE,
                                            .v = {v[0], v[1]},
                                            .own = {{seen_face_key(scene, body, face), ROBERTS_NONE}, NULL},
                                            .t1 = 1.0,
                                            .class = ROBERTS_CREASE};
    }
    return true;
}

bool cut_lines_find(const hide_fronts *fronts, seen_further *lines)
{
    const roberts_scene *scene = fronts->scene;
    double least = greatest_depth(fronts) - CUT_TOUCHING * (fronts->space.epsilon + fronts->space.depth_rounding);
    line_list found = {0};
    uint32_t *first = alloc_array((size_t)scene->solid_count + 1, sizeof *first);
    bool enough = first != NULL;
    for (uint32_t s = 0; enough && s < scene->solid_count; s++) {
        bool convex = scene_is_convex(scene, s);
        first[s] = (uint32_t)found.count;
        for (uint32_t f = scene->solid[s].face; enough && is_mapped(fronts, s) && f < scene->solid[s + 1].face; f++)
            if (fronts->seen->facing[f] == VIEW_FRONT || (!convex && fronts->seen->facing[f] == VIEW_BACK))
                enough = add_sides(fronts, s, f, least, &found);
    }
    if (enough)
        first[scene->solid_count] = (uint32_t)found.count;
    lines->line = found.line;
    lines->first = first;
    return enough;
}

void cut_lines_free(seen_further *lines)
{
    free((void *)lines->line);
    free((void *)lines->first);
    *lines = (seen_further){0};
}
