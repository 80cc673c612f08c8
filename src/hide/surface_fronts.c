/* surface_fronts.c - the faces of a body that is not convex, each a front of its own that hides from both sides. */
#include "hide/front.h"

/* The face as seen: its plane away from the viewer, its corners counter-clockwise. */
static void turn_to_viewer(hide_fronts *fronts, uint32_t face, bool back, hide_face *f)
{
    const roberts_scene *scene = fronts->scene;
    uint32_t first = scene->face_start[face], count = scene->face_start[face + 1] - first;
    f->corner = scene->corner + first;
    f->count = count;
    if (!back)
        return;
    f->F = (plane){-f->F.a, -f->F.b, -f->F.c, -f->F.d};
    for (uint32_t i = 0; i < count; i++)
        fronts->turned[first + i] = scene->corner[first + count - 1 - i];
    f->corner = fronts->turned + first;
}

bool surface_add_fronts(hide_fronts *fronts, front_tile *tile, uint32_t body)
{
    const roberts_scene *scene = fronts->scene;
    uint32_t first = scene->solid[body].face, end = scene->solid[body + 1].face;
    if (!front_more_singles(tile, end - first))
        return false;
    for (uint32_t face = first; face < end; face++) {
        hide_face *f = &fronts->face[tile->face];
        double stretch;
        f->F = view_plane(&fronts->view, scene, face, &stretch);
        int facing = view_facing(&fronts->view, scene, face, f->F, fronts->P);
        fronts->facing[face] = (unsigned char)facing;
        tile->faces += facing == VIEW_FRONT;
        tile->back += facing == VIEW_BACK;
        tile->edge_on += facing == VIEW_EDGE_ON;
        if (facing == VIEW_EDGE_ON)
            continue;
        turn_to_viewer(fronts, face, facing == VIEW_BACK, f);
        front_set_trust(fronts, body, face, stretch, f);
        tile->most_corners = f->count > tile->most_corners ? f->count : tile->most_corners;
        hide_bounds own = hide_no_bounds;
        for (uint32_t i = 0; i < f->count; i++)
            box_add(&own.low, &own.high, fronts->P[f->corner[i]]);
        tile->single_box[tile->single_count] = hide_box_around(&own);
        tile->single[tile->single_count++] = (hide_front){.solid = body,
                                                          .face = tile->face++,
                                                          .face_count = 1,
                                                          .plane = scene->surface->plane_of[face],
                                                          .listed = true,
                                                          .kind = HIDE_SURFACE_FACE};
    }
    return true;
}
