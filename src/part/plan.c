/* plan.c - makes and opens a plan. See plan.h.
 *
 * There are two passes. The first reads the inputs and writes the bodies; it finds the box of the scene, which
 * determines the view. The second reads the bodies from the plan again and finds where each lies in the picture. */
#include "part/plan.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/array.h"
#include "base/box.h"
#include "base/error.h"
#include "base/search.h"
#include "hide/cells.h"
#include "hide/tolerance.h"
#include "model/components.h"
#include "read/mesh.h"
#include "view/clip.h"
#include "view/view.h"
#include "write/save.h"
#include "write/whole_file.h"

enum { PLAN_BUFFER = 1 << 20, ORDER_LEAF = 16 /* bodies whose order does not matter */ };

/* The last digit is the version. */
static const char magic[PLAN_BEGIN] = "roberts plan 4\n";

/* Touching distances and roundings: how much larger the margin of boxes in the picture is. The cells that list fronts
 * are widened by a quarter of that (hide_margin()). */
#define MARGIN 16.0

/* ---- bytes ------------------------------------------------------------------------------------------------------ */

uint64_t part_hash(uint64_t hash, const void *bytes, size_t size)
{
    const char *at = bytes;
    for (size_t i = 0; i + PLAN_UNIT <= size; i += PLAN_UNIT) {
        uint64_t word;
        memcpy(&word, at + i, sizeof word);
        hash = (hash ^ word) * 0x9e3779b97f4a7c15u; /* the golden ratio, as in D. E. Knuth's multiplicative hashing */
        hash ^= hash >> 29;
    }
    return hash;
}

uint64_t plan_check(uint64_t check, const void *bytes, size_t size)
{
    const char *at = bytes;
    for (size_t i = 0; i + sizeof(uint32_t) <= size; i += sizeof(uint32_t)) {
        uint32_t word;
        memcpy(&word, at + i, sizeof word);
        check = (check ^ word) * 0x9e3779b97f4a7c15u;
        check ^= check >> 29;
    }
    return check;
}

/* Adds the bytes of names, one by one, and passes over zeros: behind the last name some fill the section up. */
static uint64_t check_name(uint64_t check, const char *name, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        const uint32_t letter = (unsigned char)name[i];
        check = letter ? plan_check(check, &letter, sizeof letter) : check;
    }
    return check;
}

/* The check of the facts, which are at the end of the file. */
static uint64_t check_of(const plan_facts *facts)
{
    return plan_check(0, &facts->id, sizeof *facts - offsetof(plan_facts, id));
}

/* A file that is written sequentially. Failures are checked at the end. */
typedef struct plan_writer {
    int file, reason; /* reason: errno of the first failure */
    uint64_t at, hash;
    uint64_t check; /* as in plan_reader */
    size_t used;
    char *bytes; /* [PLAN_BUFFER] */
} plan_writer;

static void flush(plan_writer *w)
{
    w->hash = part_hash(w->hash, w->bytes, w->used);
    if (!w->reason && !output_descriptor(&w->file, w->bytes, w->used))
        w->reason = errno;
    w->at += w->used;
    w->used = 0;
}

static void put(plan_writer *w, const void *bytes, size_t size)
{
    const char *from = bytes;
    w->check = plan_check(w->check, bytes, size);
    while (size > 0) {
        size_t room = PLAN_BUFFER - w->used, some = size < room ? size : room;
        memcpy(w->bytes + w->used, from, some);
        w->used += some;
        from += some;
        size -= some;
        if (w->used == PLAN_BUFFER)
            flush(w);
    }
}

/* Writes zero bytes up to the next unit. */
static void put_padding(plan_writer *w)
{
    static const char zeros[PLAN_UNIT];
    put(w, zeros, (size_t)(-(w->at + w->used)) % PLAN_UNIT);
}

bool plan_read_from(plan_reader *r, int file, uint64_t at, uint64_t end)
{
    *r = (plan_reader){.file = file, .at = at, .end = end, .bytes = malloc(PLAN_BUFFER)};
    return r->bytes;
}

static bool fill_buffer(plan_reader *r)
{
    uint64_t left = r->end - r->at;
    ssize_t some = -1;
    do
        some = pread(r->file, r->bytes, left < PLAN_BUFFER ? (size_t)left : PLAN_BUFFER, (off_t)r->at);
    while (some < 0 && errno == EINTR);
    if (some <= 0)
        return false;
    r->used = 0;
    r->filled = (size_t)some;
    r->at += (uint64_t)some;
    return true;
}

bool plan_read(plan_reader *r, void *to, size_t size)
{
    char *next = to;
    size_t held = r->filled - r->used, all = size;
    if (!to && size > held) { /* skipped bytes are not read */
        if (size - held > r->end - r->at)
            return false;
        r->at += size - held;
        r->used = r->filled = 0;
        return true;
    }
    while (size > 0) {
        if (r->used == r->filled && !fill_buffer(r))
            return false;
        size_t some = r->filled - r->used < size ? r->filled - r->used : size;
        if (next) {
            memcpy(next, r->bytes + r->used, some);
            next += some;
        }
        r->used += some;
        size -= some;
    }
    r->check = to ? plan_check(r->check, to, all) : r->check;
    return true;
}

void plan_reader_free(plan_reader *r)
{
    free(r->bytes);
    *r = (plan_reader){0};
}

part_stamp part_stamp_of(const roberts_task *task)
{
    part_stamp s;
    const roberts_camera *c = &task->camera;
    const roberts_hide_options *h = &task->hide;
    memset(&s, 0, sizeof s);
    const double numbers[] = {c->dir.x,       c->dir.y,        c->dir.z,          c->eye.x,     c->eye.y,
                              c->eye.z,       c->look_at.x,    c->look_at.y,      c->look_at.z, c->up.x,
                              c->up.y,        c->up.z,         c->oblique.x,      c->oblique.y, c->near_distance,
                              c->fov_degrees, c->roll_degrees, h->crease_degrees, h->epsilon,   task->scene.tolerance};
    static_assert(sizeof numbers == offsetof(part_stamp, perspective), "every number has its place");
    memcpy(&s, numbers, sizeof numbers);
    s.perspective = c->projection == ROBERTS_PERSPECTIVE;
    s.has_look_at = c->has_look_at;
    s.has_section = c->has_section;
    s.crease_auto = h->crease_auto;
    s.all_edges = h->all_edges;
    s.keep_hidden = h->keep_hidden;
    s.levels = h->levels;
    s.unite = h->unite;
    s.even_odd = task->scene.even_odd;
    s.rounded = task->scene.rounded;
    s.solids = task->scene.solids;
    return s;
}

/* ---- first pass: bodies ----------------------------------------------------------------------------------------- */

typedef struct planner {
    plan *p;
    const roberts_task *task;
    plan_writer out;
    plan_reader in;
    uint64_t vertices, faces; /* of the inputs so far */
    plan_place *place;        /* [room] */
    size_t room;
    size_t point_room, vertex_room;
    roberts_vec3 *point; /* scratch */
    roberts_vec3 *seen;
} planner;

/* Does each edge of the body have an even number of faces? Otherwise the body is open. (A hash needs only one pass;
 * drawing the part finds what the hash misses.) */
static bool is_even(const roberts_scene *scene, uint32_t s)
{
    const scene_solid *body = scene->solid + s;
    uint64_t sum = 0;
    for (uint32_t f = body[0].face; f < body[1].face; f++) {
        const uint32_t first = scene->face_start[f], end = scene->face_start[f + 1];
        for (uint32_t i = first; i < end; i++) {
            uint64_t a = scene->corner[i], b = scene->corner[i + 1 < end ? i + 1 : first];
            uint64_t edge = ((a < b ? a : b) << 32 | (a < b ? b : a)) * 0x9e3779b97f4a7c15u;
            sum ^= edge ^ edge >> 31;
        }
    }
    return sum == 0;
}

/* Writes the numbers of `count` vertices or faces from `first` on, if they do not follow one another. */
static void put_numbers(planner *pl, const uint32_t *number, uint32_t first, uint32_t count, uint32_t base)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t n = base + (number ? number[first + i] : first + i);
        put(&pl->out, &n, sizeof n);
    }
}

static bool in_a_row(const uint32_t *number, uint32_t first, uint32_t count)
{
    for (uint32_t i = 1; number && i < count; i++)
        if (number[first + i] != number[first + i - 1] + 1)
            return false;
    return true;
}

static uint32_t least_number(const uint32_t *number, uint32_t first, uint32_t count)
{
    uint32_t least = number ? number[first] : first;
    for (uint32_t i = 1; number && i < count; i++)
        least = number[first + i] < least ? number[first + i] : least;
    return least;
}

/* Writes one body of a scene that is laid out. */
static void put_body(planner *pl, const roberts_scene *scene, uint32_t s)
{
    const scene_solid *body = scene->solid + s;
    const uint32_t vertices = body[1].vertex - body[0].vertex, faces = body[1].face - body[0].face;
    plan_body head = {vertices, faces, scene_corners(scene, s), 0, 0, 0};
    const uint64_t begin = pl->out.at + pl->out.used;
    pl->out.check = 0;
    head.listed = (in_a_row(scene->number, body->vertex, vertices) ? 0 : PLAN_VERTICES) |
                  (in_a_row(scene->face_number, body->face, faces) ? 0 : PLAN_FACES);
    head.first_vertex = (uint32_t)pl->vertices + least_number(scene->number, body->vertex, vertices);
    head.first_face = (uint32_t)pl->faces + least_number(scene->face_number, body->face, faces);
    put(&pl->out, &head, sizeof head);
    put(&pl->out, scene->point + body->vertex, vertices * sizeof *scene->point);
    if (head.listed & PLAN_VERTICES)
        put_numbers(pl, scene->number, body->vertex, vertices, (uint32_t)pl->vertices);
    if (head.listed & PLAN_FACES)
        put_numbers(pl, scene->face_number, body->face, faces, (uint32_t)pl->faces);
    for (uint32_t f = body[0].face; f < body[1].face; f++) {
        uint32_t corners = scene->face_start[f + 1] - scene->face_start[f];
        put(&pl->out, &corners, sizeof corners);
    }
    for (uint32_t i = scene->face_start[body[0].face]; i < scene->face_start[body[1].face]; i++) {
        uint32_t corner = scene->corner[i] - body->vertex;
        put(&pl->out, &corner, sizeof corner);
    }
    const uint64_t check = pl->out.check;
    put_padding(&pl->out);
    pl->place[pl->p->facts.bodies++] = (plan_place){.vertices = vertices,
                                                    .faces = faces,
                                                    .corners = head.corners,
                                                    .size = (uint32_t)((pl->out.at + pl->out.used - begin) / PLAN_UNIT),
                                                    .check = check};
    pl->p->facts.weight += vertices;
}

static roberts_status put_bodies(planner *pl, const roberts_scene *scene, roberts_error *error)
{
    scene_whole *whole = &pl->p->facts.whole;
    const size_t bodies = pl->p->facts.bodies + scene->solid_count;
    if (bodies >= ROBERTS_NONE || !array_reserve(&pl->place, &pl->room, bodies, sizeof *pl->place))
        return error_no_memory(error);
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        if (!is_even(scene, s))
            return error_set(error, ROBERTS_NOT_CLOSED, 0, "body %u is open; only closed bodies can be drawn in parts",
                             s);
        put_body(pl, scene, s);
    }
    if (scene->solid_count > 0) {
        box_add(&whole->box_min, &whole->box_max, scene->box_min);
        box_add(&whole->box_min, &whole->box_max, scene->box_max);
    }
    return ROBERTS_OK;
}

/* Checks that need more than one body. */
static roberts_status check_mesh(const roberts_mesh *mesh, roberts_error *error)
{
    for (size_t f = 0; f < mesh->face_count; f++)
        if (mesh->face_start[f + 1] - mesh->face_start[f] == 2)
            return error_set(error, ROBERTS_NOT_CLOSED, 0,
                             "element %zu is a line; only closed bodies can be drawn in parts", f);
    return ROBERTS_OK;
}

/* Lays out and writes the bodies of one input. Changes the mesh. */
static roberts_status put_mesh(planner *pl, roberts_mesh *mesh, roberts_error *error)
{
    polygons faces;
    repeated_solids list = {0};
    roberts_scene scene = {0};
    roberts_status status = check_mesh(mesh, error);
    if (status != ROBERTS_OK || (status = polygons_of_mesh(&faces, mesh, error)) != ROBERTS_OK)
        return status;
    if (!components_lay_out(&scene, &faces, mesh, true, &list))
        status = error_no_memory(error);
    else if (faces.repeated > 0)
        status = error_set(error, ROBERTS_NOT_CLOSED, 0,
                           "%zu corner%s repeat%s another of the same face; such faces cannot be drawn in parts",
                           faces.repeated, faces.repeated == 1 ? "" : "s", faces.repeated == 1 ? "s" : "");
    else
        status = put_bodies(pl, &scene, error);
    scene_clear(&scene);
    repeated_free(&list);
    polygons_free(&faces);
    return status;
}

static roberts_status put_input(planner *pl, const char *name, roberts_error *error)
{
    roberts_mesh mesh = {.threads = pl->task->hide.threads};
    plan_facts *facts = &pl->p->facts;
    roberts_status status = roberts_mesh_read_file(&mesh, name, &pl->task->scene.warnings, error);
    if (status == ROBERTS_OK &&
        (mesh.vertex_count > MESH_MOST - pl->vertices || mesh.face_count > MESH_MOST - pl->faces))
        status = error_set(error, ROBERTS_BAD_ARGUMENT, 0, "more vertices or faces than 32 bits can number");
    if (status == ROBERTS_OK) {
        const mesh_steps steps = mesh_rounding(&mesh, pl->task->scene.rounded);
        facts->whole.steps.float32 = fmax(facts->whole.steps.float32, steps.float32);
        facts->whole.steps.decimal = fmax(facts->whole.steps.decimal, steps.decimal);
        facts->has_names |= mesh.group_count > 0;
        status = put_mesh(pl, &mesh, error);
        pl->vertices += mesh.vertex_count;
        pl->faces += mesh.face_count;
    }
    if (status != ROBERTS_OK && status != ROBERTS_NO_MEMORY)
        error_set_file(error, name);
    roberts_mesh_free(&mesh);
    return status;
}

/* ---- second pass: places ---------------------------------------------------------------------------------------- */

/* Reads the next body's points. */
static roberts_status next_points(planner *pl, const plan_place *place, roberts_error *error)
{
    plan_body head;
    const size_t points = place->vertices * sizeof *pl->point;
    if (!array_reserve(&pl->point, &pl->point_room, place->vertices, sizeof *pl->point) ||
        !array_reserve(&pl->seen, &pl->vertex_room, place->vertices, sizeof *pl->seen))
        return error_no_memory(error);
    bool done = plan_read(&pl->in, &head, sizeof head) && plan_read(&pl->in, pl->point, points) &&
                plan_read(&pl->in, NULL, (size_t)place->size * PLAN_UNIT - sizeof head - points);
    return done ? ROBERTS_OK : error_set(error, ROBERTS_IO, 0, "cannot read the plan again");
}

/* Finds the body's box in the picture; measures its points. */
static void place_body(planner *pl, const view *v, plan_place *place, box3 *box)
{
    plan_facts *facts = &pl->p->facts;
    *box = (box3){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    view_points(v, pl->point, place->vertices, pl->seen);
    view_add_reach(v, pl->point, place->vertices, &facts->whole.reach);
    box_add_all(&box->lo, &box->hi, pl->seen, place->vertices);
    box->lo.z = box->hi.z = 0.0; /* bodies are ordered only by their place in the picture */
    facts->whole.low = (roberts_vec2){lesser(facts->whole.low.x, box->lo.x), lesser(facts->whole.low.y, box->lo.y)};
    facts->whole.high =
        (roberts_vec2){greater(facts->whole.high.x, box->hi.x), greater(facts->whole.high.y, box->hi.y)};
    const hide_box rounded = hide_box_around(box);
    place->low[0] = rounded.x0;
    place->low[1] = rounded.y0;
    place->high[0] = rounded.x1;
    place->high[1] = rounded.y1;
}

/* Halves the bodies item[0 .. count - 1] until few are left. */
static void halve(const box3 *box, uint32_t *item, uint32_t count)
{
    while (count > ORDER_LEAF) {
        box_tree_halve(box, item, count, count / 2);
        halve(box, item, count / 2);
        item += count / 2;
        count -= count / 2;
    }
}

/* Puts the bodies in the order of the picture, and writes their starts. False: no memory. */
static bool put_starts(planner *pl, const box3 *box)
{
    const uint32_t count = (uint32_t)pl->p->facts.bodies;
    uint32_t *item = alloc_array(count, sizeof *item), *start = alloc_array(count, sizeof *start);
    bool done = item && start;
    for (uint32_t i = 0; done && i < count; i++)
        item[i] = i;
    if (done)
        halve(box, item, count);
    for (uint32_t i = 0, sum = 0; done && i < count; i++) {
        start[item[i]] = sum;
        sum += pl->place[item[i]].vertices;
    }
    if (done) {
        pl->out.check = 0;
        put(&pl->out, start, count * sizeof *start);
        pl->p->facts.starts_check = pl->out.check;
        put_padding(&pl->out);
    }
    free(item);
    free(start);
    return done;
}

/* Finds the cells of the covers, as hide_fronts_build() would for the whole. False: no memory. */
static bool count_cells(planner *pl, double margin)
{
    scene_whole *whole = &pl->p->facts.whole;
    const uint32_t count = (uint32_t)pl->p->facts.bodies;
    if (pl->task->hide.keep_hidden)
        return true; /* nothing is culled */
    hide_box *box = alloc_array(count, sizeof *box);
    for (uint32_t i = 0; box && i < count; i++) {
        const plan_place *at = &pl->place[i];
        box[i] = (hide_box){at->low[0], at->high[0], at->low[1], at->high[1], 0.0f, 0.0f};
    }
    if (box) {
        const scan_frame frame =
            cells_for_covers(&(cells_boxes){box, count, whole->low, whole->high, margin}, pl->p->facts.weight, 1);
        whole->columns = frame.nx;
        whole->rows = frame.ny;
        whole->warped = frame.warps != NULL;
        if (frame.warps)
            memcpy(whole->warps, frame.warps, sizeof whole->warps);
        free(frame.warps);
    }
    const bool done = box;
    free(box);
    return done;
}

/* Sets the data about the view that drawings have. `scene` stands for the whole. */
static roberts_status describe_view(planner *pl, const roberts_scene *scene, roberts_error *error)
{
    plan_facts *facts = &pl->p->facts;
    view v;
    roberts_status status = view_prepare(&v, scene, &pl->task->camera, pl->task->hide.epsilon, error);
    if (status != ROBERTS_OK)
        return status;
    facts->margin = MARGIN * (v.epsilon + v.rounding);
    const hide_space space = {.epsilon = v.epsilon, .rounding = v.rounding};
    if (!count_cells(pl, hide_margin(&space)))
        return error_no_memory(error);
    facts->unit = v.unit;
    facts->epsilon = v.epsilon * v.unit;
    facts->epsilon_reason = v.epsilon_reason;
    facts->scene_diameter = v.diameter * v.unit;
    facts->window[0] = (roberts_vec2){facts->whole.low.x * v.unit, facts->whole.low.y * v.unit};
    facts->window[1] = (roberts_vec2){facts->whole.high.x * v.unit, facts->whole.high.y * v.unit};
    facts->framed = view_frame(&v, &pl->task->camera, false, &facts->window[0], &facts->window[1]);
    return ROBERTS_OK;
}

static roberts_status place_bodies(planner *pl, const view *v, const roberts_scene *scene, box3 *box,
                                   roberts_error *error)
{
    plan_facts *facts = &pl->p->facts;
    for (size_t i = 0; i < facts->bodies; i++) {
        roberts_status status = next_points(pl, &pl->place[i], error);
        if (status != ROBERTS_OK)
            return status;
        if (view_is_cut(scene, &pl->task->camera, pl->point, pl->place[i].vertices))
            return error_set(error, ROBERTS_BAD_VIEW, 0,
                             "the near plane cuts the scene; what is drawn in parts has to lie in front of it");
        place_body(pl, v, &pl->place[i], &box[i]);
    }
    return ROBERTS_OK;
}

static roberts_status put_places(planner *pl, roberts_error *error)
{
    plan_facts *facts = &pl->p->facts;
    roberts_scene scene = {.whole = &facts->whole, .steps = facts->whole.steps};
    view v;
    box3 *box = alloc_array(facts->bodies, sizeof *box);
    scene_set_box(&scene, facts->whole.box_min, facts->whole.box_max);
    facts->whole.reach = (scene_reach){.nearest = INFINITY};
    facts->whole.low = (roberts_vec2){INFINITY, INFINITY};
    facts->whole.high = (roberts_vec2){-INFINITY, -INFINITY};
    roberts_status status = view_begin(&v, &scene, &pl->task->camera, pl->task->hide.epsilon, error);
    if (status == ROBERTS_OK && !(box && plan_read_from(&pl->in, pl->p->file, PLAN_BEGIN, pl->out.at)))
        status = error_no_memory(error);
    if (status == ROBERTS_OK)
        status = place_bodies(pl, &v, &scene, box, error);
    if (status == ROBERTS_OK) {
        facts->places = pl->out.at;
        pl->out.check = 0;
        put(&pl->out, pl->place, facts->bodies * sizeof *pl->place);
        facts->places_check = pl->out.check;
        facts->starts = pl->out.at + pl->out.used;
        if (!put_starts(pl, box))
            status = error_no_memory(error);
    }
    free(box);
    return status == ROBERTS_OK ? describe_view(pl, &scene, error) : status;
}

/* ---- all of it -------------------------------------------------------------------------------------------------- */

/* Creates a file without a name in the folder of `path`. Returns it, or -1 with errno. */
static int open_nameless(const char *path)
{
    char *full = whole_file_beside(path, ".roberts-plan-XXXXXX");
    if (!full) {
        errno = ENOMEM;
        return -1;
    }
    int file = mkstemp(full);
    if (file >= 0)
        unlink(full);
    free(full);
    return file;
}

static void put_names(planner *pl, const roberts_inputs *input)
{
    plan_facts *facts = &pl->p->facts;
    facts->names = pl->out.at + pl->out.used;
    facts->inputs = input->count;
    uint64_t check = 0;
    for (size_t i = 0; i < input->count; i++) {
        const size_t size = strlen(input->name[i]) + 1;
        put(&pl->out, input->name[i], size);
        check = check_name(check, input->name[i], size);
    }
    facts->names_check = check;
    put_padding(&pl->out);
}

static roberts_status read_names(plan *p, uint64_t end, roberts_error *error)
{
    plan_reader in;
    const size_t size = (size_t)(end - p->facts.names);
    size_t names = 0;
    p->name = alloc_zeroed(size + 1, 1);
    bool done = plan_read_from(&in, p->file, p->facts.names, end) && p->name;
    roberts_status status = done ? ROBERTS_OK : error_no_memory(error);
    if (done && !plan_read(&in, p->name, size))
        status = error_set(error, ROBERTS_IO, 0, "cannot read the names of its inputs");
    for (size_t i = 0; status == ROBERTS_OK && i < size; i++)
        names += p->name[i] == '\0';
    if (status == ROBERTS_OK && (names < p->facts.inputs || check_name(0, p->name, size) != p->facts.names_check))
        status = error_set(error, ROBERTS_BAD_SYNTAX, 0, "the plan is broken");
    plan_reader_free(&in);
    return status;
}

static roberts_status make(planner *pl, const roberts_inputs *input, roberts_error *error)
{
    plan_facts *facts = &pl->p->facts;
    roberts_status status = ROBERTS_OK;
    facts->whole.box_min = (roberts_vec3){INFINITY, INFINITY, INFINITY};
    facts->whole.box_max = (roberts_vec3){-INFINITY, -INFINITY, -INFINITY};
    put(&pl->out, magic, sizeof magic);
    for (size_t i = 0; i < input->count && status == ROBERTS_OK; i++)
        status = put_input(pl, input->name[i], error);
    flush(&pl->out);
    if (status == ROBERTS_OK && !pl->out.reason && facts->bodies == 0)
        status = error_set(error, ROBERTS_NOT_CLOSED, 0, "nothing to draw: there is no body");
    if (status == ROBERTS_OK && !pl->out.reason)
        status = put_places(pl, error);
    if (status != ROBERTS_OK)
        return status;
    put_names(pl, input);
    flush(&pl->out);
    const uint64_t end = pl->out.at;
    memcpy(facts->magic, magic, sizeof magic);
    facts->id = part_hash(pl->out.hash, &facts->whole, sizeof *facts - offsetof(plan_facts, whole));
    facts->check = check_of(facts);
    put(&pl->out, facts, sizeof *facts);
    flush(&pl->out);
    if (pl->out.reason)
        return output_error(error, "cannot write the plan", pl->out.reason);
    return read_names(pl->p, end, error);
}

roberts_status plan_make(plan *p, const roberts_inputs *input, const roberts_task *task, const char *path,
                         roberts_error *error)
{
    planner pl = {.p = p, .task = task};
    memset(p, 0, sizeof *p); /* padding too: it goes into the file */
    p->facts.stamp = part_stamp_of(task);
    p->file = -1;
    if (task->scene.hull)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "what is drawn in parts has no hulls");
    if (task->camera.has_section)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "what is drawn in parts has no section");
    p->file = open_nameless(path);
    if (p->file < 0 && errno == ENOMEM)
        return error_no_memory(error);
    if (p->file < 0)
        return error_in(error, path, output_error(error, "cannot write into its folder", errno));
    pl.out = (plan_writer){.file = p->file, .bytes = malloc(PLAN_BUFFER)};
    roberts_status status = pl.out.bytes ? make(&pl, input, error) : error_no_memory(error);
    if (status == ROBERTS_IO && pl.out.reason)
        error_set_file(error, path);
    plan_reader_free(&pl.in);
    free(pl.out.bytes);
    free(pl.place);
    free(pl.point);
    free(pl.seen);
    return status;
}

/* Do the sections follow one another, with the right sizes? Is the picture's grid possible for this many bodies? */
static bool is_sound(const plan_facts *facts, uint64_t end)
{
    return facts->check == check_of(facts) && facts->bodies < ROBERTS_NONE && facts->weight < ROBERTS_NONE &&
           facts->places >= PLAN_BEGIN && facts->places <= facts->starts && facts->starts <= facts->names &&
           facts->names <= end && facts->starts - facts->places == facts->bodies * sizeof(plan_place) &&
           facts->names - facts->starts >= facts->bodies * sizeof(uint32_t) && facts->inputs > 0 &&
           cells_may_cover(facts->whole.columns, facts->whole.rows, facts->weight) && facts->whole.warped <= 1 &&
           (!facts->whole.warped || (warp_is_sound(&facts->whole.warps[0]) && warp_is_sound(&facts->whole.warps[1])));
}

roberts_status plan_open(plan *p, const char *path, roberts_error *error)
{
    struct stat found;
    const size_t size = sizeof p->facts;
    memset(p, 0, sizeof *p);
    p->file = open(path, O_RDONLY | O_CLOEXEC);
    if (p->file < 0 || fstat(p->file, &found) != 0)
        return error_in(error, path, output_error(error, "cannot read", errno));
    const uint64_t end = (uint64_t)found.st_size;
    if (end < size || pread(p->file, &p->facts, size, (off_t)(end - size)) != (ssize_t)size ||
        memcmp(p->facts.magic, magic, sizeof magic) != 0 || !is_sound(&p->facts, end - size))
        return error_in(error, path, error_set(error, ROBERTS_BAD_SYNTAX, 0, "the plan is unfinished or broken"));
    roberts_status status = read_names(p, end - size, error);
    return status == ROBERTS_OK ? ROBERTS_OK : error_in(error, path, status);
}

bool plan_is(const char *path)
{
    const size_t name = strlen(path);
    char found[sizeof magic];
    struct stat what;
    bool is = name > 5 && strcmp(path + name - 5, ".plan") == 0;
    int file = strcmp(path, "-") == 0 || stat(path, &what) != 0 || !S_ISREG(what.st_mode) ||
                       what.st_size < (off_t)sizeof(plan_facts)
                   ? -1
                   : open(path, O_RDONLY | O_CLOEXEC);
    if (file >= 0)
        is = is ||
             (pread(file, found, sizeof found, what.st_size - (off_t)sizeof(plan_facts)) == (ssize_t)sizeof found &&
              memcmp(found, magic, sizeof found) == 0);
    if (file >= 0)
        close(file);
    return is;
}

void plan_close(plan *p)
{
    if (p->file >= 0)
        close(p->file);
    free(p->name);
    *p = (plan){.file = -1};
}

/* Copies a plan from the file without a name. */
static roberts_status copy_plan(void *context, output *out, roberts_error *error)
{
    const plan *p = context;
    plan_reader in;
    char block[16384];
    struct stat found;
    if (fstat(p->file, &found) != 0)
        return output_error(error, "cannot read the plan", errno);
    uint64_t left = (uint64_t)found.st_size;
    bool done = plan_read_from(&in, p->file, 0, left);
    roberts_status status = done ? ROBERTS_OK : error_no_memory(error);
    while (status == ROBERTS_OK && left > 0 && !out->failed) {
        size_t some = left < sizeof block ? (size_t)left : sizeof block;
        if (!plan_read(&in, block, some))
            status = error_set(error, ROBERTS_IO, 0, "cannot read the plan again");
        else
            output_bytes(out, block, some);
        left -= some;
    }
    plan_reader_free(&in);
    return status;
}

roberts_status roberts_plan_save(const roberts_inputs *input, const roberts_task *task, const char *path,
                                 roberts_error *error)
{
    plan p;
    roberts_status status = plan_make(&p, input, task, path, error);
    if (status == ROBERTS_OK)
        status = plan_check_bodies(&p, task, error);
    if (status == ROBERTS_OK)
        status = save_from(&(save_source){copy_plan, &p}, task->temporary, task->temporary_context, path, error);
    plan_close(&p);
    return status;
}
