/* same_scene.h - compares the solids of two scenes to the last bit; where edges are stored may differ. */
#ifndef ROBERTS_TESTS_SAME_SCENE_H
#define ROBERTS_TESTS_SAME_SCENE_H

#include "model/scene.h"
#include "testing.h"

/* Compares vertices and faces. */
static inline void expect_same_faces(const roberts_scene *a, const roberts_scene *b)
{
    for (uint32_t v = 0; v < a->vertex_count; v++)
        assert_int_equal(scene_vertex_number(a, v), scene_vertex_number(b, v));
    for (uint32_t f = 0; f < a->face_count; f++)
        assert_int_equal(scene_face_number(a, f), scene_face_number(b, f));
    assert_memory_equal(a->point, b->point, a->vertex_count * sizeof *a->point);
    assert_memory_equal(a->face_start, b->face_start, (a->face_count + 1) * sizeof *a->face_start);
    assert_memory_equal(a->corner, b->corner, a->face_start[a->face_count] * sizeof *a->corner);
    for (uint32_t f = 0; f < a->face_count; f++) {
        scene_shape p = scene_shape_of(a, f), q = scene_shape_of(b, f);
        assert_memory_equal(&p, &q, sizeof p);
    }
}

static inline void expect_same_scene(const roberts_scene *a, const roberts_scene *b)
{
    assert_int_equal(a->solid_count, b->solid_count);
    assert_int_equal(a->vertex_count, b->vertex_count);
    assert_int_equal(a->face_count, b->face_count);
    assert_int_equal(a->corner_count, b->corner_count);
    assert_int_equal(a->edge_count, b->edge_count);
    for (uint32_t s = 0; s <= a->solid_count; s++) {
        assert_int_equal(a->solid[s].vertex, b->solid[s].vertex);
        assert_int_equal(a->solid[s].face, b->solid[s].face);
        assert_int_equal(a->solid[s].edge, b->solid[s].edge);
    }
    expect_same_faces(a, b);
    assert_true(a->unit == b->unit);
    assert_true(!a->vertex_color == !b->vertex_color && !a->face_color == !b->face_color);
    if (a->vertex_color)
        assert_memory_equal(a->vertex_color, b->vertex_color, a->vertex_count * sizeof(roberts_color));
    if (a->face_color)
        assert_memory_equal(a->face_color, b->face_color, a->face_count * sizeof(roberts_color));
    for (uint32_t s = 0; s < a->solid_count; s++)
        for (uint32_t e = a->solid[s].edge; e < a->solid[s + 1].edge; e++) {
            scene_edge p = scene_edge_at(a, s, e), q = scene_edge_at(b, s, e);
            assert_memory_equal(&p, &q, sizeof p);
        }
}

#endif
