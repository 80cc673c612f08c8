/* plan.h - a scene laid out to be drawn in parts: the data that all parts need, and each body at a known place.
 *
 * A plan is a file:
 *
 *   magic    16 bytes, also at the beginning of the facts
 *   bodies   one record for each body, in the order of their numbers: its faces and vertices (plan_body)
 *   places   [bodies] plan_place: where the body is in the picture, and how large its record is
 *   starts   [bodies] uint32_t: how many vertices the bodies before it have, in the order of the picture
 *   names    of the inputs, each with its NUL
 *   facts    plan_facts, at the very end: a plan without them is unfinished
 *
 * The order of the picture halves the bodies at their middles, again and again (as the tree of boxes does). Part K of N
 * has the bodies whose start lies in the K-th of N equal stretches. So every body is in one part, parts have about as
 * many vertices each, and the bodies of a part lie together in the picture, whatever N is.
 *
 * Sums over words of 32 bits tell whether what a part reads is as it was written.
 *
 * Numbers are those of the machine: machines that share the work must have the same byte order. */
#ifndef ROBERTS_PART_PLAN_H
#define ROBERTS_PART_PLAN_H

#include "model/scene.h"

enum {
    PLAN_UNIT = 8,  /* bytes; records, and names together, take a multiple of it */
    PLAN_BEGIN = 16 /* where the records begin */
};

/* Everything that determines the rows. Padding is zero, so that stamps can be compared as bytes. */
typedef struct part_stamp {
    double dir[3], eye[3], look_at[3], up[3], oblique[2], near_distance, fov, roll; /* of the camera */
    double crease, epsilon, tolerance;
    uint8_t perspective, has_look_at, crease_auto, all_edges, keep_hidden, levels, unite, even_odd, solids, rounded;
    uint8_t has_section; /* never in a plan: a task that has one is refused */
    uint8_t padding[5];
} part_stamp;

typedef struct plan_body {
    uint32_t vertices, faces, corners;
    uint32_t listed;                   /* PLAN_VERTICES, PLAN_FACES: numbers that do not follow one another */
    uint32_t first_vertex, first_face; /* in the input: the smallest numbers */
    /* then: point [vertices]; if listed, the numbers of vertices and of faces; how many corners each face has; corners,
     * counted from the body's first vertex; and zero bytes up to a multiple of 8 */
} plan_body;
enum { PLAN_VERTICES = 1, PLAN_FACES = 2 };

typedef struct plan_place {
    float low[2], high[2]; /* its box in the picture, rounded outward, view units */
    uint32_t vertices, faces, corners;
    uint32_t size;  /* of its record, in units of 8 bytes */
    uint64_t check; /* plan_check() of the record without its last zero bytes */
} plan_place;

typedef struct plan_facts {
    char magic[16];
    uint64_t check; /* plan_check() of the facts from `id` on */
    uint64_t id;    /* a hash of everything else: the same inputs and options give the same one */
    uint64_t places_check, starts_check, names_check; /* the same of these sections */
    uint64_t places, starts, names;                   /* positions in the file */
    uint64_t bodies, weight, inputs;                  /* weight: vertices of all bodies */
    uint64_t has_names;                               /* 1: faces have names in some input (see roberts_group) */
    scene_whole whole;
    double margin;                  /* of boxes in the picture: bodies farther apart never touch; view units */
    double unit;                    /* model units per view unit */
    roberts_vec2 window[2];         /* as in roberts_drawing */
    double epsilon, scene_diameter; /* the same */
    uint64_t framed, epsilon_reason;
    part_stamp stamp;
} plan_facts;

typedef struct plan {
    int file; /* -1: none */
    plan_facts facts;
    char *name; /* names of the inputs, as in the file */
} plan;

/* A section of a file that is read sequentially, through a buffer. */
typedef struct plan_reader {
    int file;
    uint64_t at, end;
    size_t used, filled;
    uint64_t check; /* plan_check() of all that has been read since it was set to 0 */
    char *bytes;    /* [PLAN_BUFFER] */
} plan_reader;

/* Starts a reader. False: no memory; call plan_reader_free() in any case. */
bool plan_read_from(plan_reader *r, int file, uint64_t at, uint64_t end);
/* Reads `size` bytes; if `to` is NULL, skips them. False: the stretch has fewer, or reading fails. */
bool plan_read(plan_reader *r, void *to, size_t size);
void plan_reader_free(plan_reader *r);

/* Adds bytes, a multiple of 8, to a hash that tells files apart. It does not withstand deliberate collisions. */
uint64_t part_hash(uint64_t hash, const void *bytes, size_t size);

/* Adds bytes, a multiple of 4, to a check that tells damaged files. */
uint64_t plan_check(uint64_t check, const void *bytes, size_t size);

part_stamp part_stamp_of(const roberts_task *task);

/* Makes a plan in a file without a name, in the folder of `path`. The inputs are read once, one after the other.
 * Returns ROBERTS_OK, what reading returns, ROBERTS_NO_MEMORY, _IO, _BAD_VIEW, _BAD_ARGUMENT, or _NOT_CLOSED (a body is
 * open, so the whole is needed). Call plan_close() in any case. */
roberts_status plan_make(plan *p, const roberts_inputs *input, const roberts_task *task, const char *path,
                         roberts_error *error);

/* Builds all bodies, some at a time, and refuses what no part can draw (part.c). Returns ROBERTS_OK, _NO_MEMORY, _IO,
 * or what building them returns. */
roberts_status plan_check_bodies(const plan *p, const roberts_task *task, roberts_error *error);

/* Opens a plan. Returns ROBERTS_OK, _NO_MEMORY, _IO or _BAD_SYNTAX. Call plan_close() in any case. */
roberts_status plan_open(plan *p, const char *path, roberts_error *error);

/* Is the file a plan, finished or not? */
bool plan_is(const char *path);

void plan_close(plan *p);

#endif
