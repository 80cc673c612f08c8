/* needles.c - see needles.h. In a flat face that is cut into triangles, some are hardly wider than the step to which
 * coordinates were rounded. The plane of such a needle says nothing: it may even face the other way. What lies beyond
 * its longest side says what the needle was before: the same plane, or, where it lies along an edge of the body, one of
 * the two planes that meet there. */
#include "model/needles.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/sort.h"

/* A face beyond a side of a needle. */
typedef struct beyond {
    uint32_t face; /* ROBERTS_NONE: none */
    double length; /* of the side */
    double way;    /* scene_way() of the side */
} beyond;

typedef struct needle_search {
    roberts_scene *scene;
    scene_needle *needle; /* [count] */
    beyond (*side)[2];    /* [count] what lies beyond the longest side, and beyond the second */
    uint8_t *state;       /* [count] */
    uint32_t *path;       /* [count] scratch: needles, each beyond a side of the one before */
    uint32_t count;
    size_t needle_room;
} needle_search;

enum { UNKNOWN, ON_PATH, KNOWN };

/* Is a face narrower than `width`? A triangle is, if its area is less than that times its longest side. */
static bool is_narrow(const roberts_scene *scene, uint32_t face, double width)
{
    if (scene->face_plane)
        return scene_width(scene, face) < width;
    const uint32_t *corner = scene->corner + scene->face_start[face];
    const roberts_vec3 P = scene->point[corner[0]];
    const roberts_vec3 PQ = vec3_sub(scene->point[corner[1]], P), PR = vec3_sub(scene->point[corner[2]], P);
    const roberts_vec3 QR = vec3_sub(PR, PQ), n = vec3_cross(PQ, PR);
    const double longest = greater(vec3_dot(PQ, PQ), greater(vec3_dot(PR, PR), vec3_dot(QR, QR)));
    return vec3_dot(n, n) < 4.0 * width * width * longest;
}

/* Lists the needles of a body. False: no memory. */
static bool list_needles(needle_search *n, uint32_t body)
{
    const roberts_scene *scene = n->scene;
    const double width = 0.5 * scene_step(scene) / SCENE_NEEDLE_TURN; /* see scene_turn() */
    for (uint32_t f = scene->solid[body].face; f < scene->solid[body + 1].face; f++) {
        if (!is_narrow(scene, f, width))
            continue;
        if (!array_reserve(&n->needle, &n->needle_room, n->count + (size_t)1, sizeof *n->needle))
            return false;
        n->needle[n->count++] = (scene_needle){f, ROBERTS_NONE, 1.0F, (float)scene_turn(scene, f)};
    }
    return true;
}

/* Returns the place of a face in the list; its length: the face is no needle. */
static uint32_t place_of(const needle_search *n, uint32_t face)
{
    const size_t at = find_numbered(n->needle, n->count, sizeof *n->needle, face);
    return at < n->count && n->needle[at].face == face ? (uint32_t)at : n->count;
}

static void note_side(beyond side[2], beyond found)
{
    if (found.length > side[0].length) {
        side[1] = side[0];
        side[0] = found;
    } else if (found.length > side[1].length) {
        side[1] = found;
    }
}

/* Finds what lies beyond the sides of the needles of a body, and marks their edges. */
static void find_sides(needle_search *n, uint32_t body)
{
    const roberts_scene *scene = n->scene;
    const scene_solid *own = &scene->solid[body];
    scene_surface *surface = scene->surface;
    for (uint32_t e = own->edge; e < own[1].edge; e++) {
        const scene_edge *edge = scene_edge_stored(scene, body, e);
        if (edge->f[1] == ROBERTS_NONE || surface->edge_is[e] & EDGE_MANY)
            continue;
        const uint32_t face[2] = {own->face + edge->f[0], own->face + edge->f[1]};
        const uint32_t at[2] = {place_of(n, face[0]), place_of(n, face[1])};
        if (at[0] == n->count && at[1] == n->count)
            continue;
        const double length =
            vec3_length(vec3_sub(scene->point[own->vertex + edge->v[0]], scene->point[own->vertex + edge->v[1]]));
        for (int k = 0; k < 2; k++)
            if (at[k] < n->count)
                note_side(n->side[at[k]], (beyond){face[1 - k], length, scene_way(surface->edge_is[e])});
        surface->edge_is[e] |= EDGE_NEEDLE;
        if (surface->bend)
            surface->bend[e] = UINT8_MAX; /* no byte decides whether it is flat */
    }
}

/* Does the needle with this place on the path get a face from beyond its side k? */
static bool take_side(needle_search *n, uint32_t at, int k)
{
    const beyond *side = &n->side[at][k];
    if (side->face == ROBERTS_NONE)
        return false;
    const uint32_t next = place_of(n, side->face);
    const bool known = next < n->count && n->state[next] == KNOWN;
    if (next < n->count && (!known || n->needle[next].stand_in == ROBERTS_NONE))
        return false;
    n->needle[at].stand_in = known ? n->needle[next].stand_in : side->face;
    n->needle[at].way = (float)(known ? side->way * n->needle[next].way : side->way);
    return true;
}

/* Goes from a needle over the longest sides as far as possible, and gives each needle on the way what the next one
 * has. Two needles may have the same longest side. Then the second one looks over its second side. */
static void find_stand_in(needle_search *n, uint32_t at)
{
    uint32_t steps = 0;
    while (at < n->count && n->state[at] == UNKNOWN) {
        n->state[at] = ON_PATH;
        n->path[steps++] = at;
        at = n->side[at][0].face == ROBERTS_NONE ? n->count : place_of(n, n->side[at][0].face);
    }
    while (steps > 0) {
        at = n->path[--steps];
        if (!take_side(n, at, 0))
            take_side(n, at, 1);
        n->state[at] = KNOWN;
    }
}

bool needles_find(roberts_scene *scene)
{
    needle_search n = {.scene = scene};
    bool enough = true;
    for (uint32_t b = 0; enough && b < scene->solid_count && scene_step(scene) > 0.0; b++)
        enough = scene_is_convex(scene, b) || list_needles(&n, b);
    scene->surface->needle = n.needle;
    if (n.count == 0 || !enough)
        return enough;
    n.side = alloc_array(n.count, sizeof *n.side);
    n.state = alloc_zeroed(n.count, 1);
    n.path = alloc_array(n.count, sizeof *n.path);
    enough = n.side && n.state && n.path;
    for (uint32_t i = 0; enough && i < n.count; i++)
        n.side[i][0] = n.side[i][1] = (beyond){.face = ROBERTS_NONE};
    for (uint32_t b = 0; enough && b < scene->solid_count; b++)
        if (!scene_is_convex(scene, b))
            find_sides(&n, b);
    for (uint32_t i = 0; enough && i < n.count; i++)
        find_stand_in(&n, i);
    scene->surface->needle_count = n.count;
    free(n.side);
    free(n.state);
    free(n.path);
    return enough;
}
