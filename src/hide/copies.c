/* copies.c - see copies.h. */
#include "hide/copies.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/sort.h"

/* Bits for each front: of so many fronts that have no copy one in ten falls on another's bit. */
#define BITS_PER_FRONT 8

/* Which bits have been met, and which more than once. */
typedef struct sieve {
    uint64_t *met, *again;
    unsigned shift; /* from a key to its bit: the upper bits of a product are the mixed ones */
} sieve;

/* Do the two fronts, of different solids, show the very same faces? Then each hides what the other hides, and neither
 * anything of the other. */
static bool same_front(const hide_picture *picture, uint32_t a, uint32_t b)
{
    const hide_front *f = &picture->front[a], *g = &picture->front[b];
    if (f->face_count != g->face_count || f->corners != g->corners || f->corners == 0 ||
        memcmp(&picture->front_box[a], &picture->front_box[b], sizeof(hide_box)) != 0)
        return false;
    for (uint32_t i = 0; i < f->corners; i++) {
        roberts_vec3 p = picture->P[picture->outline[f->outline + i]], q = picture->P[picture->outline[g->outline + i]];
        if (p.x != q.x || p.y != q.y || p.z != q.z)
            return false;
    }
    for (uint32_t i = 0; i < f->face_count; i++) {
        plane F = picture->face[f->face + i].F, G = picture->face[g->face + i].F;
        if (F.a != G.a || F.b != G.b || F.c != G.c || F.d != G.d ||
            picture->face[f->face + i].touch != picture->face[g->face + i].touch)
            return false;
    }
    return true;
}

/* Fronts that can differ in nothing else differ here. */
static uint32_t place_key(const hide_picture *picture, uint32_t front)
{
    return bits_hash(&picture->front_box[front], sizeof picture->front_box[front]);
}

static bool sieve_init(sieve *s, uint32_t fronts)
{
    unsigned bits = 6;
    while (bits < 32 && (uint64_t)1 << bits < (uint64_t)fronts * BITS_PER_FRONT)
        bits++;
    size_t words = (size_t)1 << (bits - 6);
    s->met = alloc_zeroed(words, 2 * sizeof *s->met);
    s->again = s->met ? s->met + words : NULL;
    s->shift = 32 - bits;
    return s->met != NULL;
}

static void sieve_enter(sieve *s, uint32_t key)
{
    uint32_t at = key >> s->shift;
    uint64_t bit = (uint64_t)1 << (at & 63);
    s->again[at >> 6] |= s->met[at >> 6] & bit;
    s->met[at >> 6] |= bit;
}

static bool sieve_again(const sieve *s, uint32_t key)
{
    uint32_t at = key >> s->shift;
    return s->again[at >> 6] >> (at & 63) & 1;
}

/* The fronts that share their bit with another, ascending, and their keys. */
static uint32_t sift(const hide_picture *picture, const sieve *s, uint32_t *front, uint32_t *key)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < picture->front_count; i++)
        if (sieve_again(s, key[i])) {
            front[count] = i;
            key[count++] = key[i];
        }
    return count;
}

bool copies_leave_out(hide_picture *picture)
{
    uint32_t count = picture->front_count, last = ROBERTS_NONE;
    uint32_t *key = alloc_array(count, sizeof *key), *front = alloc_array(count, sizeof *front), *order = NULL;
    sieve s = {0};
    bool done = key && front && sieve_init(&s, count);
    for (uint32_t i = 0; done && i < count; i++) {
        picture->front[i].listed = true;
        key[i] = place_key(picture, i);
        sieve_enter(&s, key[i]);
    }
    if (done) {
        count = sift(picture, &s, front, key);
        order = alloc_array(count, sizeof *order);
        done = order && radix_order(key, count, order);
    }
    for (uint32_t k = 0; done && k < count; k++) {
        uint32_t i = order[k];
        if (last != ROBERTS_NONE && key[last] == key[i] && same_front(picture, front[last], front[i]))
            picture->front[front[i]].listed = false;
        else
            last = i;
    }
    free(s.met);
    free(key);
    free(front);
    free(order);
    return done;
}
