/* sweep_order.c - the lines that a sweep line meets, in order. See sweep_order.h. */
#include "model/sweep_order.h"

#include <stdlib.h>

#include "base/array.h"

bool sweep_order_start(sweep_order *order, size_t count)
{
    order->root = ROBERTS_NONE;
    order->place = alloc_array(count, sizeof *order->place);
    return order->place != NULL;
}

static uint32_t priority_of(uint32_t line)
{
    uint32_t h = (line + 1) * 0x9e3779b1u;
    h = (h ^ h >> 15) * 0x85ebca77u;
    return h ^ h >> 13;
}

/* Makes `line` take the place of `old` as a child or the root. */
static void replace_child(sweep_order *order, uint32_t old, uint32_t line)
{
    uint32_t parent = order->place[old].parent;
    if (parent == ROBERTS_NONE)
        order->root = line;
    else
        order->place[parent].child[order->place[parent].child[1] == old] = line;
    if (line != ROBERTS_NONE)
        order->place[line].parent = parent;
}

/* Rotates a line above its parent in the tree. */
static void rotate_up(sweep_order *order, uint32_t line)
{
    sweep_place *place = order->place;
    uint32_t parent = place[line].parent;
    int side = place[parent].child[1] == line;
    uint32_t inner = place[line].child[1 - side];
    replace_child(order, parent, line);
    place[parent].child[side] = inner;
    if (inner != ROBERTS_NONE)
        place[inner].parent = parent;
    place[line].child[1 - side] = parent;
    place[parent].parent = line;
}

uint32_t sweep_order_above(const sweep_order *order, uint32_t below)
{
    uint32_t line = order->root;
    if (below != ROBERTS_NONE)
        return order->place[below].near[1];
    while (line != ROBERTS_NONE && order->place[line].child[0] != ROBERTS_NONE)
        line = order->place[line].child[0];
    return line;
}

void sweep_order_insert(sweep_order *order, uint32_t line, uint32_t below)
{
    sweep_place *place = order->place, *own = &place[line];
    *own = (sweep_place){ROBERTS_NONE, {ROBERTS_NONE, ROBERTS_NONE}, {ROBERTS_NONE, ROBERTS_NONE}, priority_of(line)};
    if (order->root == ROBERTS_NONE) {
        order->root = line;
        return;
    }
    uint32_t above = sweep_order_above(order, below);
    own->near[0] = below;
    own->near[1] = above;
    if (below != ROBERTS_NONE)
        place[below].near[1] = line;
    if (above != ROBERTS_NONE)
        place[above].near[0] = line;
    /* of two neighbours in the list, one has no child on the side of the other */
    bool under = below == ROBERTS_NONE || place[below].child[1] != ROBERTS_NONE;
    own->parent = under ? above : below;
    place[own->parent].child[!under] = line;
    while (own->parent != ROBERTS_NONE && place[own->parent].priority < own->priority)
        rotate_up(order, line);
}

void sweep_order_remove(sweep_order *order, uint32_t line)
{
    sweep_place *place = order->place, *own = &place[line];
    while (own->child[0] != ROBERTS_NONE && own->child[1] != ROBERTS_NONE)
        rotate_up(order, own->child[place[own->child[1]].priority > place[own->child[0]].priority]);
    replace_child(order, line, own->child[own->child[0] == ROBERTS_NONE]);
    for (int k = 0; k < 2; k++)
        if (own->near[k] != ROBERTS_NONE)
            place[own->near[k]].near[1 - k] = own->near[1 - k];
}

void sweep_order_free(sweep_order *order)
{
    free(order->place);
    *order = (sweep_order){.root = ROBERTS_NONE};
}
