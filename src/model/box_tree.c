/* box_tree.c - a tree of boxes. See box_tree.h. Boxes are split at the median of their centres along the longest
 * extent, until at most four are left. */
#include "model/box_tree.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"

enum { LEAF = 4 };

static double box_middle(const box3 *box, int axis)
{
    return axis == 0 ? box->lo.x + box->hi.x : axis == 1 ? box->lo.y + box->hi.y : box->lo.z + box->hi.z;
}

static int longest_axis(const box3 *box, const uint32_t *item, uint32_t count)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = lesser(low[k], box_middle(&box[item[i]], k));
            high[k] = greater(high[k], box_middle(&box[item[i]], k));
        }
    int axis = high[1] - low[1] > high[0] - low[0];
    return high[2] - low[2] > high[axis] - low[axis] ? 2 : axis;
}

/* C. A. R. Hoare, "Algorithm 65: Find", CACM 4(7), 1961. Ties are broken by number, so the order of equal boxes is the
 * same in every run. */
void box_tree_halve(const box3 *box, uint32_t *item, uint32_t count, uint32_t half)
{
    const int axis = longest_axis(box, item, count);
    uint32_t from = 0, to = count > 0 ? count - 1 : 0;
    while (from < to) {
        uint32_t pivot = item[from + (to - from) / 2], i = from, j = to;
        double at = box_middle(&box[pivot], axis);
        for (;;) {
            while (box_middle(&box[item[i]], axis) < at || (box_middle(&box[item[i]], axis) == at && item[i] < pivot))
                i++;
            while (box_middle(&box[item[j]], axis) > at || (box_middle(&box[item[j]], axis) == at && item[j] > pivot))
                j--;
            if (i >= j)
                break;
            uint32_t swapped = item[i];
            item[i++] = item[j];
            item[j--] = swapped;
        }
        if (half <= j)
            to = j;
        else
            from = j + 1;
    }
}

/* Builds the subtree over the items from `first` on. Numbers in `item` start at 0 until the tree is complete. False: no
 * memory. */
static bool build_box_node(box_tree *tree, const box3 *box, uint32_t first, uint32_t count)
{
    if (!array_reserve(&tree->node, &tree->node_room, tree->node_count + 1, sizeof *tree->node))
        return false;
    size_t at = tree->node_count++;
    uint32_t *item = tree->item + first;
    box3 all = box[item[0]];
    for (uint32_t i = 1; i < count; i++) {
        box_add(&all.lo, &all.hi, box[item[i]].lo);
        box_add(&all.lo, &all.hi, box[item[i]].hi);
    }
    bool leaf = count <= LEAF;
    tree->node[at] = (box_tree_node){.box = all, .first = first, .count = leaf ? count : 0};
    if (!leaf) {
        box_tree_halve(box, item, count, count / 2);
        if (!build_box_node(tree, box, first, count / 2) ||
            !build_box_node(tree, box, first + count / 2, count - count / 2))
            return false;
    }
    tree->node[at].skip = (uint32_t)tree->node_count;
    return true;
}

bool box_tree_add(box_tree *tree, const box3 *box, uint32_t count, uint32_t base, uint32_t *root)
{
    size_t first = tree->item_count;
    if (!array_reserve(&tree->item, &tree->item_room, first + count, sizeof *tree->item))
        return false;
    for (uint32_t i = 0; i < count; i++)
        tree->item[first + i] = i;
    tree->item_count += count;
    *root = (uint32_t)tree->node_count;
    if (!build_box_node(tree, box, (uint32_t)first, count))
        return false;
    for (uint32_t i = 0; i < count; i++)
        tree->item[first + i] += base;
    return true;
}

void box_tree_free(box_tree *tree)
{
    free(tree->node);
    free(tree->item);
    *tree = (box_tree){0};
}
