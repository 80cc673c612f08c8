/* off_pieces.c - reads plain lines by several threads, in an input that can be read at any position at any time.
 *
 * The input is cut at line ends into pieces. A thread reads a piece as if its first line began a vertex or a face, into
 * memory of its own, since the number of preceding items is not yet known. Pieces are joined in order as long as each
 * begins where the one before it ended, so they contain what a single thread would have read there. At anything other
 * than plain lines, the rest is discarded, and the reader continues alone from there, with its line number. So messages
 * do not depend on threads.
 *
 * Pieces are stored in a ring of slots. A thread takes the next piece, reads it and stores it. If no other thread is
 * joining, it then joins the pieces that are ready, in order, to the mesh, while the others continue reading. Threads
 * wait only if the ring is full, and they sleep then. (Rounds with a barrier were tried. On a busy machine they cost
 * twice the processor time, spent spinning.) */
#include "read/off.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/threads.h"

enum {
    SLOTS_PER_THREAD = 6,
    TRIES_IN_VAIN = 3, /* after this many tries that give less than half of what the ring holds, pieces are given up */
    SPREAD = 4 /* most bytes of the mesh per byte of text: 24 from "0 0 0\n", 4 from the "0\n" of a face, or " 0" */
};

#define PIECE ((size_t)1 << 17)    /* text and result fit into a core's cache */
#define OVERHANG ((size_t)1 << 12) /* room for a face of about 500 corners */
#define LEAST ((size_t)1 << 19)    /* takes about half a millisecond */

/* The result of a piece. Offsets count from the start of the input. */
typedef struct piece {
    roberts_vec3 *vertex;   /* [vertices]; the other arrays follow in the same memory */
    uint32_t *corner, *end; /* [corners], [faces]; ends count from the first corner of the piece */
    size_t vertices, faces, corners, thin;
    uint64_t begin;        /* offset of the line end before its first line */
    uint64_t middle, stop; /* offsets after the last vertex and after the last face */
    uint64_t next;         /* `begin` of the next piece if this one is plain to its end; otherwise 0 */
} piece;

typedef struct slot {
    piece piece;
    bool ready; /* read, and not yet joined */
} slot;

typedef struct pieces_job {
    reader *r; /* only the joining thread touches its mesh */
    const off_division *division;
    slot *slot;           /* [slots] piece i is in slot i modulo `slots` */
    char **text;          /* [threads] text buffer of each thread */
    size_t slots, count;  /* count: total number of pieces */
    uint64_t start;       /* start of the first piece, the end of a token */
    pthread_mutex_t lock; /* guards the members down to `vertices`, and the slots' `ready` */
    pthread_cond_t room;  /* a slot is free, or all is done */
    size_t taken, joined; /* numbers of pieces */
    bool joining, over;
    bool vertices; /* vertices are left */
    /* only the joining thread touches these: */
    uint64_t vertices_left, faces_left;
    uint64_t at, begin; /* position of the reader, and where the next piece must begin */
} pieces_job;

/* Returns the most bytes that a piece may have. */
static inline size_t most_bytes(const off_division *d)
{
    return d->piece + d->overhang;
}

/* ---- reading a piece ------------------------------------------------------------------------------------------- */

/* Reads `size` bytes of text, or fewer at the end of the input or if reading fails. (The reader then fails there
 * again.) */
static size_t fetch(const input *in, uint64_t from, char *text, size_t size)
{
    size_t got = 0;
    while (got < size) {
        ptrdiff_t more = in->source.read_at(in->source.context, from + got, text + got, size - got);
        if (more <= 0)
            break;
        got += (size_t)more;
    }
    return got;
}

/* Finds the lines of piece i: from the line end before the first one to that of the last one, which is the first line
 * end beyond the piece's own bytes. NULL: none. */
static const char *find_lines(const pieces_job *job, size_t i, piece *p, char *text, const char **end)
{
    const off_division *d = job->division;
    uint64_t from = job->start + i * (uint64_t)d->piece;
    size_t got = fetch(&job->r->in, from, text, most_bytes(d));
    size_t own = got < d->piece ? got : d->piece;
    const char *begin = i == 0 ? text : memchr(text, '\n', own), *last = NULL;
    if (got > own)
        last = memchr(text + own, '\n', got - own);
    if (!begin || got == 0)
        return NULL;
    size_t size = last ? (size_t)(last + 1 - text) : own;
    memset(text + size, 0, 1 + NUMBER_PADDING);
    *end = text + size;
    p->begin = from + (uint64_t)(begin - text);
    if (last)
        p->next = from + (uint64_t)(last - text);
    return begin;
}

static void read_piece(const pieces_job *job, size_t i, bool vertices, piece *p, char *text)
{
    const char *end = NULL, *at;
    *p = (piece){.vertex = p->vertex};
    at = find_lines(job, i, p, text, &end);
    if (!at)
        return;
    const uint64_t offset = p->begin - (uint64_t)(at - text);
    size_t room = most_bytes(job->division) * SPREAD / sizeof *p->vertex;
    if (vertices)
        at = plain_vertices(at, p->vertex, room, &p->vertices);
    p->middle = offset + (uint64_t)(at - text);
    room = (room - p->vertices) * (sizeof *p->vertex / sizeof *p->corner / 2); /* half for ends, half for corners */
    p->end = (uint32_t *)(p->vertex + p->vertices);
    p->corner = p->end + room;
    plain_faces faces = {.corner = p->corner,
                         .end = p->end,
                         .corner_room = room,
                         .room = room,
                         .first = (uint32_t)job->r->mark.vertices,
                         .limit = off_index_limit(job->r)};
    at = plain_read_faces(at, &faces);
    p->stop = offset + (uint64_t)(at - text);
    p->faces = faces.count;
    p->corners = faces.corner_count;
    p->thin = faces.thin;
    if (plain_next_line(at) != end)
        p->next = 0;
}

/* ---- joining, by one thread at a time -------------------------------------------------------------------------- */

/* Discards what the reader would read differently, since it counts vertices first and then faces. Returns the position
 * of the reader then. */
static uint64_t accept(const pieces_job *job, piece *p)
{
    if (p->begin != job->begin || p->vertices > job->vertices_left) {
        p->vertices = p->faces = p->corners = p->thin = 0;
        p->next = 0;
        return job->at;
    }
    if (p->faces == 0 || (p->vertices == job->vertices_left && p->faces <= job->faces_left))
        return p->stop;
    p->faces = p->corners = p->thin = 0;
    p->next = 0;
    return p->middle;
}

/* Adds the piece to the mesh. False: no memory, or no other piece can follow. */
static bool join_piece(pieces_job *job, piece *p)
{
    reader *r = job->r;
    roberts_mesh *mesh = r->mesh;
    uint64_t at = accept(job, p);
    if (!mesh_room(mesh, mesh->vertex_count + p->vertices, mesh->face_count + p->faces,
                   mesh->corner_count + p->corners))
        return false;
    if (p->vertices)
        memcpy(mesh->vertex + mesh->vertex_count, p->vertex, p->vertices * sizeof *p->vertex);
    if (p->corners)
        memcpy(mesh->corner + mesh->corner_count, p->corner, p->corners * sizeof *p->corner);
    for (size_t f = 0; f < p->faces; f++)
        mesh->face_start[mesh->face_count + 1 + f] = (uint32_t)(mesh->corner_count + p->end[f]);
    mesh->vertex_count += p->vertices;
    mesh->face_count += p->faces;
    mesh->corner_count += p->corners;
    r->in.line += p->vertices + p->faces;
    r->thin_faces += p->thin;
    job->vertices_left -= p->vertices;
    job->faces_left -= p->faces;
    job->at = at;
    job->begin = p->next;
    return p->next != 0;
}

/* Joins the pieces that are ready, in order. Called with the lock held; releases it while joining. */
static void join_ready(pieces_job *job)
{
    slot *s;
    job->joining = true;
    while (!job->over && (s = &job->slot[job->joined % job->slots])->ready) {
        pthread_mutex_unlock(&job->lock);
        bool good = join_piece(job, &s->piece);
        pthread_mutex_lock(&job->lock);
        s->ready = false;
        job->vertices = job->vertices_left > 0;
        job->over = !good || ++job->joined == job->count;
        pthread_cond_broadcast(&job->room);
    }
    job->joining = false;
}

/* ---- threads --------------------------------------------------------------------------------------------------- */

/* Reads one piece after another until there are no more or the rest is discarded. */
static void work(void *context, uint32_t thread)
{
    pieces_job *job = context;
    pthread_mutex_lock(&job->lock);
    for (;;) {
        while (!job->over && job->taken < job->count && job->taken - job->joined >= job->slots)
            pthread_cond_wait(&job->room, &job->lock);
        if (job->over || job->taken == job->count)
            break;
        size_t i = job->taken++;
        bool vertices = job->vertices;
        pthread_mutex_unlock(&job->lock);
        slot *s = &job->slot[i % job->slots];
        read_piece(job, i, vertices, &s->piece, job->text[thread]);
        pthread_mutex_lock(&job->lock);
        s->ready = true;
        if (!job->joining)
            join_ready(job);
    }
    pthread_mutex_unlock(&job->lock);
}

typedef struct run_work {
    off_work_fn *function;
    void *job;
} run_work;

static bool run_some(void *context, size_t first, size_t end)
{
    const run_work *r = context;
    for (size_t thread = first; thread < end; thread++)
        r->function(r->job, (uint32_t)thread);
    return true;
}

static void run(off_work_fn *function, void *job, uint32_t threads)
{
    threads_each((int)threads, threads, 1, run_some, &(run_work){function, job});
}

off_division off_divide(uint32_t threads)
{
    threads = threads_inside() ? 1 : (uint32_t)threads_for(threads, ROBERTS_THREADS_MOST);
    return (off_division){threads < ROBERTS_THREADS_MOST ? threads : ROBERTS_THREADS_MOST, PIECE, OVERHANG, LEAST, run};
}

/* ---- the job --------------------------------------------------------------------------------------------------- */

static void job_free(pieces_job *job, uint32_t threads)
{
    for (size_t i = 0; job->slot && i < job->slots; i++)
        free(job->slot[i].piece.vertex);
    for (uint32_t i = 0; job->text && i < threads; i++)
        free(job->text[i]);
    free(job->slot);
    free(job->text);
}

/* Prepares the job. False: no memory. Call job_free() in either case. */
static bool job_init(pieces_job *job, uint32_t threads)
{
    const size_t most = most_bytes(job->division);
    job->slot = alloc_zeroed(job->slots, sizeof *job->slot);
    job->text = alloc_zeroed(threads, sizeof *job->text);
    if (!job->slot || !job->text)
        return false;
    for (uint32_t i = 0; i < threads; i++)
        if (!(job->text[i] = alloc_array(most + 1 + NUMBER_PADDING, 1)))
            return false;
    for (size_t i = 0; i < job->slots; i++)
        if (!(job->slot[i].piece.vertex = alloc_array(most, SPREAD)))
            return false;
    return true;
}

static void do_job(pieces_job *job, uint32_t threads)
{
    if (pthread_mutex_init(&job->lock, NULL) != 0)
        return;
    if (pthread_cond_init(&job->room, NULL) == 0) {
        job->division->run(work, job, threads);
        pthread_cond_destroy(&job->room);
    }
    pthread_mutex_destroy(&job->lock);
}

void off_read_pieces(reader *r)
{
    const off_division *d = r->off->division;
    const input_source *source = &r->in.source;
    if (d->threads < 2 || !source->read_at || r->off->tries_in_vain >= TRIES_IN_VAIN)
        return;
    uint64_t start = input_offset(&r->in), left = source->size > start ? source->size - start : 0;
    uint32_t threads = left / d->least < d->threads ? (uint32_t)(left / d->least) : d->threads;
    if (threads < 2)
        return;
    pieces_job job = {.r = r,
                      .division = d,
                      .slots = (size_t)threads * SLOTS_PER_THREAD,
                      .count = (size_t)(left / d->piece) + 1,
                      .start = start,
                      .at = start,
                      .begin = start,
                      .vertices_left = r->off->header.vertices - (r->mesh->vertex_count - r->mark.vertices),
                      .faces_left = r->off->header.faces - (r->mesh->face_count - r->mark.faces)};
    job.vertices = job.vertices_left > 0;
    if (job_init(&job, threads)) {
        do_job(&job, threads);
        input_go(&r->in, job.at);
        if (2 * (job.at - start) < job.slots * (uint64_t)d->piece)
            r->off->tries_in_vain++;
    } else {
        r->off->tries_in_vain = TRIES_IN_VAIN; /* a single thread needs less memory */
    }
    job_free(&job, threads);
}
