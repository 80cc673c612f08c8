/* cull.c - see cull.h. */
#include "hide/cull.h"

/* Does the front hide the solid, all of whose vertices lie inside its outline or on it? By `loose` it may fail to fill that:
 * then they must lie so far inside. */
static bool hides_solid(const hide_picture *picture, const hide_front *front, uint32_t solid)
{
    const roberts_scene *scene = picture->scene;
    const uint32_t *corner = picture->outline + front->outline;
    double slack = 0.5 * picture->space.epsilon - (double)front->loose;
    if (!(front->depth > picture->box[solid].z1))
        return false;
    if (slack < 0.0 && runs_of(&picture->outline_runs, corner, front->corners))
        return false; /* runs are not asked about points inside */
    for (uint32_t v = scene->solid[solid].vertex; v < scene->solid[solid + 1].vertex; v++) {
        roberts_vec3 X = view_point(&picture->view, scene->point[v]);
        if (!hide_picture_holds(picture, &picture->outline_runs, corner, front->corners, X.x, X.y, slack))
            return false;
    }
    return true;
}

/* A solid whose border lies on the border of what hides it is in cells that are not wholly covered. So, where the cells
 * further in are, the fronts that cover its middle and its corners are asked themselves. Most solids that are not hidden
 * are not in their middle, or not at those corners. */
bool cull_hides(const hide_picture *picture, const hide_box *box, uint32_t solid)
{
    const cover *c = &picture->cover;
    static const float at[5][2] = {{0.5f, 0.5f}, {0, 0}, {0, 1}, {1, 0}, {1, 1}};
    uint32_t last = ROBERTS_NONE;
    if (!c->depth ||
        !cover_nearer(c, 0.5 * ((double)box->x0 + (double)box->x1), 0.5 * ((double)box->y0 + (double)box->y1), box->z1))
        return false;
    float dx = 1.5f * (float)c->frame.dx, dy = 1.5f * (float)c->frame.dy;
    hide_box inner = {box->x0 + dx, box->x1 - dx, box->y0 + dy, box->y1 - dy, box->z0, box->z1};
    if (inner.x0 > inner.x1 || inner.y0 > inner.y1)
        return cover_hides(c, box);
    if (!cover_nearer(c, (double)inner.x0, (double)inner.y0, box->z1) ||
        !cover_nearer(c, (double)inner.x0, (double)inner.y1, box->z1) ||
        !cover_nearer(c, (double)inner.x1, (double)inner.y0, box->z1) ||
        !cover_nearer(c, (double)inner.x1, (double)inner.y1, box->z1))
        return false;
    if (cover_hides(c, box))
        return true;
    if (!cover_hides(c, &inner))
        return false;
    for (int k = 0; k < 5; k++) {
        float x = inner.x0 + at[k][0] * (inner.x1 - inner.x0), y = inner.y0 + at[k][1] * (inner.y1 - inner.y0);
        uint32_t front = cover_at(c, (double)x, (double)y, box->z1);
        if (front != ROBERTS_NONE && front != last && hides_solid(picture, &picture->front[front], solid))
            return true;
        last = front;
    }
    return false;
}
