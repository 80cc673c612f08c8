/* narrow_face.c - faces too narrow to tell by themselves which side is the inner one, or where their plane lies.
 *
 * In coordinates given to six digits a face may be narrower than the rounding: its plane then points anywhere, and it
 * may cut the solid. Triangles without any area occur as well, where a corner of one face lies on a side of another. Such
 * faces are kept, since the surface is closed only with them. They take winding and plane from their neighbours: the
 * mean of two adjacent planes touches the solid along their common edge, and so hides nothing and is hidden by nothing
 * that the neighbours are not. */
#include "model/narrow_face.h"

#include <stdlib.h>

#include "base/array.h"
#include "model/layout.h"

enum { UNSEEN, KEEP, TURN };

/* Which edges each face has: edge[start[f]] .. edge[start[f + 1] - 1]. */
typedef struct face_edges {
    uint32_t *start, *edge;
} face_edges;

static bool collect_edges(face_edges *of, const solid_frame *frame)
{
    uint32_t count = 2 * frame->edge_count;
    of->start = alloc_zeroed((size_t)frame->face_count + 2, sizeof *of->start);
    of->edge = alloc_array(count, sizeof *of->edge);
    if (!of->start || !of->edge)
        return false;
    for (uint32_t e = 0; e < count; e++)
        of->start[frame->edge[e / 2].f[e % 2] + 2]++;
    for (uint32_t f = 0; f < frame->face_count; f++)
        of->start[f + 2] += of->start[f + 1];
    for (uint32_t e = 0; e < count; e++)
        of->edge[of->start[frame->edge[e / 2].f[e % 2] + 1]++] = e / 2;
    return true;
}

/* Decides all faces that are connected with `seed` by edges. */
static void flood(const solid_frame *frame, const face_edges *of, const uint8_t *alike, uint32_t seed,
                  uint8_t *decision, uint32_t *queue)
{
    uint32_t head = 0, tail = 0;
    decision[seed] = KEEP;
    queue[tail++] = seed;
    while (head < tail) {
        uint32_t f = queue[head++];
        for (uint32_t i = of->start[f]; i < of->start[f + 1]; i++) {
            const scene_edge *e = frame->edge + of->edge[i];
            uint32_t other = e->f[0] == f ? e->f[1] : e->f[0];
            if (decision[other] != UNSEEN)
                continue;
            decision[other] = alike[of->edge[i]] == (decision[f] == KEEP) ? TURN : KEEP;
            queue[tail++] = other;
        }
    }
}

static void turn_face(roberts_scene *scene, solid_frame *frame, uint32_t f)
{
    plane *global = &scene->face_plane[frame->face_first + f], *F = &frame->face[f].F;
    layout_turn_face(scene, frame->face_first + f);
    *F = (plane){-F->a, -F->b, -F->c, -F->d};
    frame->face[f].depth = -frame->face[f].depth;
    *global = (plane){-global->a, -global->b, -global->c, -global->d};
}

/* Whether the decisions leave the two faces of each edge passing it in opposite directions. */
static bool agree(const solid_frame *frame, const uint8_t *alike, const uint8_t *decision)
{
    for (uint32_t e = 0; e < frame->edge_count; e++) {
        const scene_edge *edge = &frame->edge[e];
        bool turned = decision[edge->f[0]] != decision[edge->f[1]];
        if (turned != (alike[e] != 0))
            return false;
    }
    return true;
}

roberts_status narrow_wind(roberts_scene *scene, solid_frame *frame, const edge_scratch *edges)
{
    face_edges of = {0};
    uint8_t *decision = alloc_zeroed(frame->face_count, sizeof *decision);
    uint32_t *queue = alloc_array(frame->face_count, sizeof *queue);
    roberts_status status = ROBERTS_NO_MEMORY;
    if (!decision || !queue || !collect_edges(&of, frame))
        goto done;
    flood(frame, &of, edges->alike, frame->widest, decision, queue);
    for (uint32_t f = 0; f < frame->face_count; f++)
        if (decision[f] == UNSEEN)
            flood(frame, &of, edges->alike, f, decision, queue);
    status = agree(frame, edges->alike, decision) ? ROBERTS_OK : ROBERTS_NOT_CONVEX;
    for (uint32_t f = 0; f < frame->face_count && status == ROBERTS_OK; f++)
        if (decision[f] == TURN)
            turn_face(scene, frame, f);
done:
    free(decision);
    free(queue);
    free(of.start);
    free(of.edge);
    return status;
}

/* Adds to `sum` the neighbour's normal, weighed by the length of the edge, if the neighbour stands by itself. */
static void add_neighbour(const solid_frame *frame, const scene_edge *edge, uint32_t neighbour, roberts_vec3 *sum)
{
    const local_face *face = &frame->face[neighbour];
    roberts_vec3 a = frame->point[edge->v[0]], b = frame->point[edge->v[1]];
    if (!face->lean)
        *sum = vec3_add(*sum, vec3_scale(vec3_length(vec3_sub(b, a)), (roberts_vec3){face->F.a, face->F.b, face->F.c}));
}

/* For a face without area and without neighbours to lean on: from the line that it is toward the barycentre. */
static roberts_vec3 toward_barycentre(const solid_frame *frame, roberts_vec3 origin, uint32_t count)
{
    roberts_vec3 inward = vec3_sub(frame->barycentre, origin), chord = {0, 0, 0};
    for (uint32_t i = 1; i < count; i++) {
        roberts_vec3 d = frame->ring[i];
        chord = vec3_dot(d, d) > vec3_dot(chord, chord) ? d : chord;
    }
    if (vec3_dot(chord, chord) > 0.0)
        inward = vec3_sub(inward, vec3_scale(vec3_dot(inward, chord) / vec3_dot(chord, chord), chord));
    return inward;
}

/* Gives face f the normal n (of any length), through the mean of its corners. */
static void mend_face(roberts_scene *scene, solid_frame *frame, uint32_t f, roberts_vec3 n)
{
    local_face *face = &frame->face[f];
    uint32_t count = frame_ring(frame, scene, f);
    double sum = 0.0, mean, deviation = 0.0;
    if (face->area == 0.0 && vec3_length(n) == 0.0)
        n = toward_barycentre(frame, frame_origin(frame, scene, f), count);
    if (vec3_length(n) == 0.0)
        return;
    n = vec3_scale(1.0 / vec3_length(n), n);
    for (uint32_t i = 1; i < count; i++)
        sum += vec3_dot(n, frame->ring[i]);
    mean = sum / count;
    for (uint32_t i = 0; i < count; i++)
        deviation = fmax(deviation, fabs(vec3_dot(n, frame->ring[i]) - mean));
    if (face->area > 0.0 && deviation > frame->allowed)
        return;
    face->F = (plane){n.x, n.y, n.z, -vec3_dot(n, frame_origin(frame, scene, f)) - mean};
    face->deviation = deviation;
    frame_store(frame, scene, f, mean);
}

roberts_status narrow_mend(roberts_scene *scene, solid_frame *frame)
{
    roberts_vec3 *sum;
    if (!frame->any_lean)
        return ROBERTS_OK;
    sum = alloc_zeroed(frame->face_count, sizeof *sum); /* all bits zero are 0.0 */
    if (!sum)
        return ROBERTS_NO_MEMORY;
    for (const scene_edge *edge = frame->edge; edge < frame->edge + frame->edge_count; edge++) {
        add_neighbour(frame, edge, edge->f[0], &sum[edge->f[1]]);
        add_neighbour(frame, edge, edge->f[1], &sum[edge->f[0]]);
    }
    for (uint32_t f = 0; f < frame->face_count; f++)
        if (frame->face[f].lean)
            mend_face(scene, frame, f, sum[f]);
    free(sum);
    return ROBERTS_OK;
}
