/* part.c - draws one part of a scene.
 *
 * 1. Which bodies. The part's own bodies are known from their starts (plan.h). Their boxes mark cells of the picture.
 *    Every body whose box meets a marked cell is kept: nothing else can hide or cross the part's lines. If bodies are
 *    culled, the boxes of kept bodies mark cells, too, and bodies that meet these are kept as well: they may cull them.
 * 2. The kept bodies become a mesh, in their order, and the mesh becomes a scene with the data of the whole
 *    (scene_whole). Then all tolerances are those of the whole. No result depends on bodies that are not met, so the
 *    rows are those of one run.
 * 3. Its hidden lines are removed. Segments of own bodies are written with their numbers in the whole. */
#include "part/rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/error.h"
#include "base/sort.h"
#include "write/save.h"

enum { CELLS = 512 };

/* Cells of covers: how far beside its box a body may read covers; and a little more, for margins. */
#define COVERS_BESIDE 5.0

/* More parts than this are probably a mistake. */
#define SHARES_MOST 1000000u

typedef struct kept_body {
    uint64_t at;    /* of its record in the plan */
    uint64_t check; /* of the record */
    uint32_t number;
    uint32_t first_vertex; /* in the mesh */
    bool own;
} kept_body;

/* Cells of the picture, as sums: how many cells to the left and below are marked. */
typedef struct picture_cells {
    uint32_t sum[CELLS + 1][CELLS + 1];
    const plan_facts *facts;
} picture_cells;

typedef struct part {
    const plan *p;
    const roberts_task *task;
    roberts_share share;
    picture_cells *cells, *next;
    kept_body *body; /* [count] by number */
    size_t count, room;
    size_t vertices, faces, corners;
    roberts_mesh mesh;
    uint32_t *vertex_number, *face_number; /* [vertices], [faces] in the whole */
    roberts_scene *scene;
    roberts_drawing drawing; /* without segments */
    output *out;
    rows_line line; /* the line whose segments are being received */
    rows_segment *segment;
    size_t segment_room;
    uint32_t edge; /* its number in the scene */
    bool crossing, no_memory;
    rows_end end;
} part;

/* ---- which bodies ----------------------------------------------------------------------------------------------- */

/* Returns the cell of a coordinate along axis k. */
static int picture_cell(const plan_facts *facts, double x, int k)
{
    const double low = k ? facts->whole.low.y : facts->whole.low.x,
                 high = k ? facts->whole.high.y : facts->whole.high.x;
    const double cell = floor((x - low) / (high - low) * CELLS);
    return cell >= CELLS ? CELLS - 1 : cell > 0.0 ? (int)cell : 0; /* 0 also if the picture has no width */
}

/* Returns what lies `cells` columns (k = 0) or rows (k = 1) of covers beyond x. */
static double beside(const plan_facts *facts, double x, int k, double cells)
{
    const scene_whole *w = &facts->whole;
    const uint32_t count = k ? w->rows : w->columns;
    const double size = count ? (k ? w->high.y - w->low.y : w->high.x - w->low.x) / count : 0.0;
    return w->warped ? warp_back(&w->warps[k], warp_at(&w->warps[k], x) + cells * size) : x + cells * size;
}

/* Finds the cells that a body's box touches, widened by the margin and by the cells of covers about it. */
static void cells_of(const plan_facts *facts, const plan_place *place, int first[2], int last[2])
{
    for (int k = 0; k < 2; k++) {
        first[k] = picture_cell(facts, beside(facts, (double)place->low[k] - facts->margin, k, -COVERS_BESIDE), k);
        last[k] = picture_cell(facts, beside(facts, (double)place->high[k] + facts->margin, k, COVERS_BESIDE), k);
    }
}

static bool is_own(const part *q, uint32_t start)
{
    return (uint64_t)start * q->share.of / q->p->facts.weight == q->share.number - 1;
}

/* Marks cells by how many rectangles begin and end there; the sums are then the numbers of rectangles over each
 * cell. */
static void mark(picture_cells *c, const plan_place *place)
{
    int first[2], last[2];
    cells_of(c->facts, place, first, last);
    c->sum[first[1]][first[0]]++;
    c->sum[first[1]][last[0] + 1]--;
    c->sum[last[1] + 1][first[0]]--;
    c->sum[last[1] + 1][last[0] + 1]++;
}

static void add_up(picture_cells *c)
{
    for (int y = 0; y <= CELLS; y++)
        for (int x = 0; x <= CELLS; x++)
            c->sum[y][x] +=
                (x ? c->sum[y][x - 1] : 0) + (y ? c->sum[y - 1][x] : 0) - (x && y ? c->sum[y - 1][x - 1] : 0);
}

/* From rectangles to the sums of marked cells: sum[y][x] is how many cells before column x and row y are marked. */
static void close_cells(picture_cells *c)
{
    add_up(c);
    for (int y = CELLS; y >= 0; y--)
        for (int x = CELLS; x >= 0; x--)
            c->sum[y][x] = x > 0 && y > 0 ? c->sum[y - 1][x - 1] != 0 : 0;
    add_up(c);
}

static bool is_met(const picture_cells *c, const plan_place *place)
{
    int first[2], last[2];
    cells_of(c->facts, place, first, last);
    return c->sum[last[1] + 1][last[0] + 1] - c->sum[first[1]][last[0] + 1] - c->sum[last[1] + 1][first[0]] +
               c->sum[first[1]][first[0]] !=
           0;
}

static bool keep_body(part *q, uint32_t number, uint64_t at, const plan_place *place, bool own)
{
    if (!array_reserve(&q->body, &q->room, q->count + 1, sizeof *q->body))
        return false;
    q->body[q->count++] = (kept_body){at, place->check, number, (uint32_t)q->vertices, own};
    q->vertices += place->vertices;
    q->faces += place->faces;
    q->corners += place->corners;
    return true;
}

/* The passes over the places of bodies: own bodies mark cells; bodies that meet these mark cells of another picture;
 * bodies that meet those are kept. */
typedef enum look { LOOK_OWN, LOOK_MET, LOOK_KEEP } look;

static roberts_status broken(roberts_error *error)
{
    return error_set(error, ROBERTS_BAD_SYNTAX, 0, "the plan is broken, or cannot be read");
}

/* Is the record large enough for the counts in its place? */
static bool has_room(const plan_place *place)
{
    const uint64_t numbers = (uint64_t)place->faces + place->corners;
    return sizeof(plan_body) + place->vertices * sizeof(roberts_vec3) + numbers * sizeof(uint32_t) <=
           (uint64_t)place->size * PLAN_UNIT;
}

/* Examines the places of all bodies, one after the other. The sizes must fit the file, so a damaged plan cannot require
 * more memory than a sound one of its length. */
static roberts_status look_through(part *q, look what, roberts_error *error)
{
    const plan_facts *facts = &q->p->facts;
    plan_reader places, starts = {0};
    roberts_status status = ROBERTS_OK;
    if (!plan_read_from(&places, q->p->file, facts->places, facts->starts) ||
        !plan_read_from(&starts, q->p->file, facts->starts, facts->names))
        status = error_no_memory(error);
    uint64_t at = PLAN_BEGIN, vertices = 0;
    for (uint32_t i = 0; i < facts->bodies && status == ROBERTS_OK; i++) {
        plan_place place;
        uint32_t start;
        if (!plan_read(&places, &place, sizeof place) || !plan_read(&starts, &start, sizeof start)) {
            status = error_set(error, ROBERTS_IO, 0, "cannot read the plan");
            break;
        }
        vertices += place.vertices;
        if (start >= facts->weight || vertices > facts->weight || !has_room(&place)) {
            status = broken(error);
            break;
        }
        const bool own = is_own(q, start);
        if (what == LOOK_OWN && own)
            mark(q->cells, &place);
        if (what == LOOK_MET && is_met(q->cells, &place))
            mark(q->next, &place);
        if (what == LOOK_KEEP && is_met(q->cells, &place) && !keep_body(q, i, at, &place, own))
            status = error_no_memory(error);
        at += (uint64_t)place.size * PLAN_UNIT;
    }
    if (status == ROBERTS_OK && (at != facts->places || vertices != facts->weight ||
                                 places.check != facts->places_check || starts.check != facts->starts_check))
        status = broken(error);
    plan_reader_free(&places);
    plan_reader_free(&starts);
    return status;
}

static roberts_status choose_bodies(part *q, roberts_error *error)
{
    q->cells = alloc_zeroed(1, sizeof *q->cells);
    q->next = alloc_zeroed(1, sizeof *q->next);
    roberts_status status = q->cells && q->next ? ROBERTS_OK : error_no_memory(error);
    if (status == ROBERTS_OK) {
        q->cells->facts = q->next->facts = &q->p->facts;
        status = look_through(q, LOOK_OWN, error);
    }
    if (status == ROBERTS_OK) {
        close_cells(q->cells);
        if (q->p->facts.whole.columns) {
            status = look_through(q, LOOK_MET, error);
            close_cells(q->next);
            picture_cells *met = q->next;
            q->next = q->cells;
            q->cells = met;
        }
    }
    if (status == ROBERTS_OK)
        status = look_through(q, LOOK_KEEP, error);
    free(q->cells);
    free(q->next);
    q->cells = q->next = NULL;
    return status;
}

/* ---- a mesh of them --------------------------------------------------------------------------------------------- */

static bool alloc_mesh(part *q)
{
    roberts_mesh *m = &q->mesh;
    m->vertex = alloc_array(m->vertex_room = q->vertices, sizeof *m->vertex);
    m->face_start = alloc_array(m->face_room = q->faces + 1, sizeof *m->face_start);
    m->corner = alloc_array(m->corner_room = q->corners, sizeof *m->corner);
    q->vertex_number = alloc_array(q->vertices, sizeof *q->vertex_number);
    q->face_number = alloc_array(q->faces, sizeof *q->face_number);
    if (!m->vertex || !m->face_start || !m->corner || !q->vertex_number || !q->face_number)
        return false;
    m->face_start[0] = 0;
    return true;
}

/* Reads the listed numbers, or counts from the first one. */
static bool read_numbers(plan_reader *in, bool listed, uint32_t first, uint32_t count, uint32_t *to)
{
    for (uint32_t i = 0; i < count && !listed; i++)
        to[i] = first + i;
    return !listed || plan_read(in, to, count * sizeof *to);
}

/* Reads one body to the end of the mesh. False: it is not as its place says, or cannot be read. */
static bool read_body(part *q, const kept_body *body, plan_reader *in)
{
    roberts_mesh *m = &q->mesh;
    plan_body head;
    const uint32_t first = body->first_vertex;
    in->check = 0;
    if (first != m->vertex_count || !plan_read(in, &head, sizeof head) ||
        head.vertices > q->vertices - m->vertex_count || head.faces > q->faces - m->face_count ||
        head.corners > q->corners - m->corner_count ||
        !plan_read(in, m->vertex + first, head.vertices * sizeof *m->vertex) ||
        !read_numbers(in, head.listed & PLAN_VERTICES, head.first_vertex, head.vertices, q->vertex_number + first) ||
        !read_numbers(in, head.listed & PLAN_FACES, head.first_face, head.faces, q->face_number + m->face_count))
        return false;
    uint32_t *start = m->face_start + m->face_count, *corner = m->corner + m->corner_count;
    if (!plan_read(in, start + 1, head.faces * sizeof *start) ||
        !plan_read(in, corner, head.corners * sizeof *corner) || in->check != body->check)
        return false;
    for (uint32_t f = 0, left = head.corners; f < head.faces; f++) { /* up to here start[f + 1] is a face's corners */
        if (start[f + 1] > left)
            return false;
        left -= start[f + 1];
        start[f + 1] += start[f];
    }
    for (uint32_t i = 0; i < head.corners; i++) {
        if (corner[i] >= head.vertices)
            return false;
        corner[i] += first;
    }
    m->vertex_count += head.vertices;
    m->face_count += head.faces;
    m->corner_count += head.corners;
    return start[head.faces] == m->corner_count;
}

/* Puts the faces in the order of the input, if bodies are mixed there: of two faces that cross, the smaller number
 * comes first. False: no memory. */
static bool sort_faces(part *q)
{
    roberts_mesh *m = &q->mesh;
    const uint32_t count = (uint32_t)q->faces;
    bool sorted = true;
    for (uint32_t f = 1; f < count && sorted; f++)
        sorted = q->face_number[f] > q->face_number[f - 1];
    if (sorted)
        return true;
    uint32_t *order = alloc_array(count, sizeof *order), *number = alloc_array(count, sizeof *number);
    uint32_t *start = alloc_array((size_t)count + 1, sizeof *start), *corner = alloc_array(q->corners, sizeof *corner);
    const bool done = order && number && start && corner && radix_order(q->face_number, count, order);
    for (uint32_t f = 0, to = 0; done && f < count; f++) {
        const uint32_t from = m->face_start[order[f]], size = m->face_start[order[f] + 1] - from;
        number[f] = q->face_number[order[f]];
        start[f] = to;
        memcpy(corner + to, m->corner + from, size * sizeof *corner);
        start[f + 1] = to += size;
    }
    free(order);
    free(done ? q->face_number : number);
    free(done ? m->face_start : start);
    free(done ? m->corner : corner);
    if (done) {
        q->face_number = number;
        m->face_start = start;
        m->corner = corner;
    }
    return done;
}

static roberts_status gather(part *q, roberts_error *error)
{
    plan_reader in = {0};
    if (q->count == 0)
        return ROBERTS_OK;
    roberts_status status = alloc_mesh(q) && plan_read_from(&in, q->p->file, PLAN_BEGIN, q->p->facts.places)
                                ? ROBERTS_OK
                                : error_no_memory(error);
    uint64_t at = PLAN_BEGIN;
    for (size_t k = 0; k < q->count && status == ROBERTS_OK; k++) {
        const uint64_t now = in.at - (in.filled - in.used);
        at = q->body[k].at;
        if (at < now || !plan_read(&in, NULL, (size_t)(at - now)) || !read_body(q, &q->body[k], &in))
            status = broken(error);
    }
    const roberts_mesh *m = &q->mesh;
    if (status == ROBERTS_OK &&
        (m->vertex_count != q->vertices || m->face_count != q->faces || m->corner_count != q->corners))
        status = broken(error);
    plan_reader_free(&in);
    if (status == ROBERTS_OK && !sort_faces(q))
        status = error_no_memory(error);
    return status;
}

/* ---- a scene of it ---------------------------------------------------------------------------------------------- */

/* Are the scene's bodies the ones that were kept, and all closed? Then nothing was welded or split, and no body depends
 * on others. */
static roberts_status check_bodies(const part *q, roberts_error *error)
{
    const roberts_scene *scene = q->scene;
    for (uint32_t k = 0; k < scene->solid_count || k < q->count; k++) {
        const bool kept = k < q->count, found = k < scene->solid_count;
        const uint32_t least = kept ? q->body[k].first_vertex : ROBERTS_NONE;
        const uint32_t end = k + 1 < q->count ? q->body[k + 1].first_vertex : (uint32_t)q->vertices;
        const uint32_t number = found ? scene_vertex_number(scene, scene->solid[k].vertex) : ROBERTS_NONE;
        if (k > 0 && number < least) /* one more of the body before */
            return error_set(error, ROBERTS_NOT_CLOSED, 0,
                             "body %u is several bodies; only bodies that share no vertices can be drawn in parts",
                             q->body[k - 1].number);
        if (number >= end || roberts_scene_body_kind(scene, k) == ROBERTS_OPEN)
            return error_set(error, ROBERTS_NOT_CLOSED, 0, "body %u is open; only closed bodies can be drawn in parts",
                             q->body[k].number);
    }
    if (scene->low && q->task->camera.projection == ROBERTS_PERSPECTIVE)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                         "faces cross themselves; in perspective such a scene cannot be drawn in parts");
    return ROBERTS_OK;
}

static roberts_status build_part(part *q, roberts_error *error)
{
    roberts_scene_options options = q->task->scene;
    options.threads = q->task->hide.threads;
    roberts_status status = scene_take_part(&q->mesh, &options, &q->p->facts.whole, &q->scene, error);
    return status == ROBERTS_OK ? check_bodies(q, error) : status;
}

/* Vertices of bodies that are checked together: more take more memory, fewer are not faster. */
#define CHECK_TOGETHER (1u << 18)

/* Builds the bodies that are kept, as a part does, and forgets them. */
static roberts_status check_kept(part *q, roberts_error *error)
{
    roberts_status status = gather(q, error);
    if (status == ROBERTS_OK)
        status = build_part(q, error);
    roberts_scene_free(q->scene);
    roberts_mesh_free(&q->mesh);
    free(q->vertex_number);
    free(q->face_number);
    *q = (part){.p = q->p, .task = q->task, .body = q->body, .room = q->room};
    return status;
}

roberts_status plan_check_bodies(const plan *p, const roberts_task *task, roberts_error *error)
{
    roberts_task silent = *task;
    part q = {.p = p, .task = &silent};
    const plan_facts *facts = &p->facts;
    uint64_t at = PLAN_BEGIN;
    plan_reader places;
    silent.scene.warnings = (roberts_warnings){0}; /* parts send them */
    roberts_status status =
        plan_read_from(&places, p->file, facts->places, facts->starts) ? ROBERTS_OK : error_no_memory(error);
    for (uint32_t i = 0; i < facts->bodies && status == ROBERTS_OK; i++) {
        plan_place place;
        if (!plan_read(&places, &place, sizeof place))
            status = error_set(error, ROBERTS_IO, 0, "cannot read the plan again");
        else if (!keep_body(&q, i, at, &place, true))
            status = error_no_memory(error);
        else if (q.vertices >= CHECK_TOGETHER || i + 1 == facts->bodies)
            status = check_kept(&q, error);
        at += (uint64_t)place.size * PLAN_UNIT;
    }
    plan_reader_free(&places);
    free(q.body);
    return status;
}

/* ---- its rows --------------------------------------------------------------------------------------------------- */

static void put(part *q, const void *bytes, size_t size)
{
    q->end.hash = part_hash(q->end.hash, bytes, size);
    output_bytes(q->out, bytes, size);
}

/* Writes the line whose segments have been received. */
static void end_line(part *q)
{
    if (q->line.segments == 0)
        return;
    put(q, &q->line, sizeof q->line);
    put(q, q->segment, q->line.segments * sizeof *q->segment);
    q->end.lines++;
    q->end.crossings += q->crossing;
    q->end.segments += q->line.segments;
    q->line.segments = 0;
}

static uint32_t number_of(const uint32_t *number, uint32_t n)
{
    return n == ROBERTS_NONE ? n : number[n];
}

/* Begins the line of a segment. */
static void begin_line(part *q, const roberts_segment *s)
{
    end_line(q);
    memset(&q->line, 0, sizeof q->line);
    q->crossing = scene_crosses(s);
    q->edge = s->edge;
    q->line.solid = q->body[s->solid].number;
    q->line.v0 = number_of(q->vertex_number, s->v0);
    q->line.v1 = number_of(q->vertex_number, s->v1);
    scene_know_edge(q->scene, &q->drawing, s, &q->line.known);
    for (int k = 0; k < 2; k++)
        q->line.known.face[k] = number_of(q->face_number, q->line.known.face[k]);
}

static bool take(void *context, const roberts_segment *s)
{
    part *q = context;
    if (!q->body[s->solid].own)
        return !q->out->failed;
    if (q->line.segments == 0 || s->edge != q->edge || scene_crosses(s) != q->crossing)
        begin_line(q, s);
    if (!array_reserve(&q->segment, &q->segment_room, (size_t)q->line.segments + 1, sizeof *q->segment)) {
        q->no_memory = true;
        return false;
    }
    q->segment[q->line.segments++] =
        (rows_segment){s->t0, s->t1, s->z0, s->z1, s->p0, s->p1, s->by, s->state, s->line, s->level};
    if (s->by != ROBERTS_NONE)
        q->segment[q->line.segments - 1].by = q->body[s->by].number;
    return !q->out->failed;
}

static roberts_status hide(part *q, roberts_error *error)
{
    const roberts_receiver each = {take, q};
    roberts_hide_options options = q->task->hide;
    options.nameless = false;
    roberts_status status = roberts_hide_each(q->scene, &q->task->camera, &options, &each, &q->drawing, error);
    end_line(q);
    if (status == ROBERTS_STOPPED)
        status = q->no_memory ? error_no_memory(error) : ROBERTS_IO; /* the output stores the reason */
    return status;
}

/* Writes the part's file. */
static roberts_status write_part(void *context, output *out, roberts_error *error)
{
    part *q = context;
    static const char zeros[PLAN_UNIT];
    const plan_facts *facts = &q->p->facts;
    rows_head head;
    memset(&head, 0, sizeof head);
    memcpy(head.magic, ROWS_MAGIC, sizeof ROWS_MAGIC);
    memcpy(&head.facts, facts, sizeof head.facts);
    head.number = q->share.number;
    head.of = q->share.of;
    for (uint64_t i = 0; i < facts->inputs; i++)
        head.names += strlen(q->p->name + head.names) + 1;
    const size_t padding = (size_t)(-head.names % PLAN_UNIT);
    output_bytes(out, &head, sizeof head);
    output_bytes(out, q->p->name, head.names);
    output_bytes(out, zeros, padding);
    q->out = out;
    roberts_status status = q->count > 0 ? hide(q, error) : ROBERTS_OK;
    memcpy(q->end.magic, ROWS_MAGIC, sizeof ROWS_MAGIC);
    output_bytes(out, &q->end, sizeof q->end);
    return status;
}

/* ---- all of it -------------------------------------------------------------------------------------------------- */

static roberts_status check_share(const plan *p, const roberts_task *task, roberts_share share, roberts_error *error)
{
    const part_stamp stamp = part_stamp_of(task);
    if (share.of > SHARES_MOST || share.number < 1 || share.number > share.of)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "there is no part %u of %u", share.number, share.of);
    if (memcmp(&stamp, &p->facts.stamp, sizeof stamp) != 0)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                         "the plan was made with another view, or with other options for lines");
    return ROBERTS_OK;
}

static roberts_status open_plan(plan *p, const roberts_inputs *input, const roberts_task *task, const char *path,
                                roberts_error *error)
{
    for (size_t i = 0; i < input->count; i++)
        if (plan_is(input->name[i])) {
            if (input->count == 1)
                return plan_open(p, input->name[0], error);
            *p = (plan){.file = -1};
            error_set(error, ROBERTS_BAD_ARGUMENT, 0, "a plan holds the whole scene; give no other file with it");
            return error_in(error, input->name[i], ROBERTS_BAD_ARGUMENT);
        }
    return plan_make(p, input, task, path, error);
}

roberts_status roberts_part_save(const roberts_inputs *input, const roberts_task *task, roberts_share share,
                                 const char *path, roberts_error *error)
{
    plan p;
    part q = {.p = &p, .task = task, .share = share};
    roberts_status status = open_plan(&p, input, task, path, error);
    if (status == ROBERTS_OK)
        status = check_share(&p, task, share, error);
    if (status == ROBERTS_OK)
        status = choose_bodies(&q, error);
    if (status == ROBERTS_OK)
        status = gather(&q, error);
    if (status == ROBERTS_OK && q.count > 0)
        status = build_part(&q, error);
    if (status == ROBERTS_OK)
        status = save_from(&(save_source){write_part, &q}, task->temporary, task->temporary_context, path, error);
    roberts_drawing_free(&q.drawing);
    roberts_scene_free(q.scene);
    roberts_mesh_free(&q.mesh);
    free(q.body);
    free(q.vertex_number);
    free(q.face_number);
    free(q.segment);
    plan_close(&p);
    return status;
}
