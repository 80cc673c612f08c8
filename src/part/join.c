/* join.c - joins the parts of a drawing. Each part has its lines in the order of the whole, and each body is in one
 * part. So the parts are merged: the next line is the least of the next lines of all parts. */
#include "part/rows.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/array.h"
#include "base/error.h"
#include "base/output.h"

/* One part, open at its next line. */
typedef struct source {
    const char *path;
    rows_head head;
    rows_end end;
    FILE *file;
    rows_line next;
    uint64_t lines, segments, hash; /* lines, segments: still to come, `next` not counted; hash: so far */
    bool over;                      /* `next` is none */
} source;

typedef struct joiner {
    source *part; /* [count] by number */
    size_t count;
    roberts_joined *to;
    size_t segments, lines, crossings; /* room */
} joiner;

static roberts_status broken(const source *s, roberts_error *error)
{
    return error_in(error, s->path, error_set(error, ROBERTS_BAD_SYNTAX, 0, "this part is broken; draw it again"));
}

/* ---- opening ---------------------------------------------------------------------------------------------------- */

/* Reads the beginning and the end. The length of the file must agree with them. */
static bool read_frame(source *s, uint64_t size, bool *is_part)
{
    *is_part = size >= sizeof s->head && fread(&s->head, sizeof s->head, 1, s->file) == 1 &&
               memcmp(s->head.magic, ROWS_MAGIC, sizeof ROWS_MAGIC) == 0;
    if (!*is_part || size < sizeof s->head + sizeof s->end || fseeko(s->file, -(off_t)sizeof s->end, SEEK_END) != 0 ||
        fread(&s->end, sizeof s->end, 1, s->file) != 1 || memcmp(s->end.magic, ROWS_MAGIC, sizeof ROWS_MAGIC) != 0)
        return false;
    const uint64_t rest = size - sizeof s->head - sizeof s->end;
    const uint64_t names = s->head.names + -s->head.names % PLAN_UNIT;
    return s->head.names <= rest && names <= rest && s->end.lines <= rest / sizeof(rows_line) &&
           s->end.segments <= rest / sizeof(rows_segment) && s->end.crossings <= s->end.lines &&
           s->end.lines <= s->end.segments &&
           names + s->end.lines * sizeof(rows_line) + s->end.segments * sizeof(rows_segment) == rest &&
           fseeko(s->file, (off_t)(sizeof s->head + names), SEEK_SET) == 0;
}

static roberts_status open_part(source *s, const char *path, roberts_error *error)
{
    struct stat found;
    bool is_part = false;
    *s = (source){.path = path, .file = fopen(path, "rb")};
    if (!s->file || fstat(fileno(s->file), &found) != 0)
        return error_in(error, path, output_error(error, "cannot read", errno));
    if (S_ISREG(found.st_mode) && read_frame(s, (uint64_t)found.st_size, &is_part)) {
        s->lines = s->end.lines;
        s->segments = s->end.segments;
        return ROBERTS_OK;
    }
    const char *why = S_ISREG(found.st_mode) && is_part ? "this part is unfinished or broken; draw it again"
                                                        : "this is no part of a drawing, as --part K/N writes it";
    return error_in(error, path, error_set(error, ROBERTS_BAD_SYNTAX, 0, "%s", why));
}

static int by_number(const void *a, const void *b)
{
    const source *p = a, *q = b;
    return (p->head.number > q->head.number) - (p->head.number < q->head.number);
}

/* Do all parts belong to one drawing, of this task? */
static roberts_status check_parts(joiner *j, const roberts_task *task, roberts_error *error)
{
    const part_stamp stamp = part_stamp_of(task);
    const rows_head *first = &j->part[0].head;
    for (size_t i = 0; i < j->count; i++) {
        const rows_head *head = &j->part[i].head;
        const char *why = NULL;
        if (memcmp(&head->facts, &first->facts, sizeof head->facts) != 0)
            why = "of another drawing";
        else if (head->of != first->of)
            why = "of another number of parts";
        if (!why && memcmp(&stamp, &head->facts.stamp, sizeof stamp) == 0)
            continue;
        if (why)
            error_set(error, ROBERTS_BAD_ARGUMENT, 0, "part %u of %u is %s than %.100s", head->number, head->of, why,
                      j->part[0].path);
        else
            error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                      "part %u of %u was drawn with another view, or with other options for lines", head->number,
                      head->of);
        return error_in(error, j->part[i].path, ROBERTS_BAD_ARGUMENT);
    }
    qsort(j->part, j->count, sizeof *j->part, by_number);
    for (size_t i = 0; i < j->count; i++)
        if (i > 0 && j->part[i].head.number == j->part[i - 1].head.number) {
            error_set(error, ROBERTS_BAD_ARGUMENT, 0, "part %u is given twice: %.100s", j->part[i].head.number,
                      j->part[i - 1].path);
            return error_in(error, j->part[i].path, ROBERTS_BAD_ARGUMENT);
        }
    for (uint32_t i = 0; i < j->part[0].head.of; i++)
        if (i >= j->count || j->part[i].head.number != i + 1)
            return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "part %u of %u is missing", i + 1, j->part[0].head.of);
    return ROBERTS_OK;
}

/* ---- merging ---------------------------------------------------------------------------------------------------- */

static bool is_crossing(const rows_line *line)
{
    return line->v0 == ROBERTS_NONE;
}

/* Reads and checks the next line of a part. */
static roberts_status advance(source *s, roberts_error *error)
{
    s->over = s->lines == 0;
    if (s->over)
        return s->segments == 0 && s->hash == s->end.hash ? ROBERTS_OK : broken(s, error);
    if (fread(&s->next, sizeof s->next, 1, s->file) != 1 || s->next.segments == 0 || s->next.segments > s->segments)
        return broken(s, error);
    s->hash = part_hash(s->hash, &s->next, sizeof s->next);
    s->lines--;
    s->segments -= s->next.segments;
    return ROBERTS_OK;
}

/* Does line a come before b? Edges are in order within their body, and of two faces all crossings are in one part. */
static bool before(const rows_line *a, const rows_line *b)
{
    if (is_crossing(a) != is_crossing(b))
        return is_crossing(b);
    if (!is_crossing(a))
        return a->solid < b->solid;
    const uint32_t *f = a->known.face, *g = b->known.face;
    return f[0] != g[0] ? f[0] < g[0] : f[1] < g[1];
}

/* Adds the line to the drawing; returns its number there. False: there are more than the parts say. */
static bool add_rows_line(joiner *j, const rows_line *line, uint32_t *number)
{
    roberts_drawing *d = &j->to->drawing;
    const bool crossing = is_crossing(line);
    size_t *count = crossing ? &d->crossing_count : &d->known_edge_count;
    if (*count >= (crossing ? j->crossings : j->lines - j->crossings))
        return false;
    *number = (uint32_t)*count;
    if (crossing)
        d->crossing[*count] =
            (roberts_crossing){{line->known.face[0], line->known.face[1]}, {line->known.end[0], line->known.end[1]}};
    else
        d->known_edge[*count] = line->known;
    ++*count;
    return true;
}

/* Moves the next line of a part, with its segments, to the drawing. */
static roberts_status move_line(joiner *j, source *s, roberts_error *error)
{
    roberts_drawing *d = &j->to->drawing;
    const rows_line line = s->next;
    uint32_t number;
    if (line.segments > j->segments - d->count || !add_rows_line(j, &line, &number))
        return broken(s, error);
    for (uint32_t i = 0; i < line.segments; i++) {
        rows_segment r;
        if (fread(&r, sizeof r, 1, s->file) != 1 || r.state > ROBERTS_CLIPPED || r.line > ROBERTS_BACK_OUTLINE)
            return broken(s, error);
        s->hash = part_hash(s->hash, &r, sizeof r);
        d->segment[d->count++] = (roberts_segment){.solid = line.solid,
                                                   .v0 = line.v0,
                                                   .v1 = line.v1,
                                                   .by = r.by,
                                                   .t0 = r.t0,
                                                   .t1 = r.t1,
                                                   .p0 = r.p0,
                                                   .p1 = r.p1,
                                                   .z0 = r.z0,
                                                   .z1 = r.z1,
                                                   .state = r.state,
                                                   .line = r.line,
                                                   .level = r.level,
                                                   .edge = number};
    }
    roberts_status status = advance(s, error);
    return status == ROBERTS_OK && !s->over && before(&s->next, &line) ? broken(s, error) : status;
}

static roberts_status merge_rows(joiner *j, roberts_error *error)
{
    roberts_status status = ROBERTS_OK;
    for (size_t i = 0; i < j->count && status == ROBERTS_OK; i++)
        status = advance(&j->part[i], error);
    while (status == ROBERTS_OK) {
        source *least = NULL;
        for (size_t i = 0; i < j->count; i++)
            if (!j->part[i].over && (!least || before(&j->part[i].next, &least->next)))
                least = &j->part[i];
        if (!least)
            return ROBERTS_OK;
        const rows_line line = least->next; /* and all that follow of the same body */
        do
            status = move_line(j, least, error);
        while (status == ROBERTS_OK && !least->over && !before(&line, &least->next));
    }
    return status;
}

/* ---- all of it -------------------------------------------------------------------------------------------------- */

static bool alloc_drawing(joiner *j)
{
    roberts_drawing *d = &j->to->drawing;
    for (size_t i = 0; i < j->count; i++) {
        j->segments += j->part[i].end.segments;
        j->lines += j->part[i].end.lines;
        j->crossings += j->part[i].end.crossings;
    }
    d->segment = alloc_array(j->segments, sizeof *d->segment);
    d->known_edge = alloc_array(j->lines - j->crossings, sizeof *d->known_edge);
    d->crossing = alloc_array(j->crossings, sizeof *d->crossing);
    return j->lines < ROBERTS_NONE && d->segment && d->known_edge && d->crossing;
}

/* Takes over the data about the whole from the parts. */
static void describe_whole(joiner *j)
{
    const plan_facts *facts = &j->part[0].head.facts;
    roberts_drawing *d = &j->to->drawing;
    d->window_min = facts->window[0];
    d->window_max = facts->window[1];
    d->framed = facts->framed;
    d->epsilon = facts->epsilon;
    d->epsilon_reason = (roberts_epsilon_reason)facts->epsilon_reason;
    d->scene_diameter = facts->scene_diameter;
    d->solids = facts->bodies;
    j->to->has_names = facts->has_names;
}

/* Reads the names of the models from one of the parts. */
static roberts_status take_names(joiner *j, roberts_error *error)
{
    source *s = &j->part[0];
    const uint64_t size = s->head.names, count = s->head.facts.inputs;
    roberts_joined *to = j->to;
    if (count > size)
        return broken(s, error);
    char **name = alloc_array(count, sizeof *name);
    to->input.name = name;
    to->names = malloc(size + 1);
    if (!name || !to->names)
        return error_no_memory(error);
    off_t lines = ftello(s->file);
    if (fseeko(s->file, sizeof s->head, SEEK_SET) != 0 || fread(to->names, 1, size, s->file) != size ||
        fseeko(s->file, lines, SEEK_SET) != 0)
        return broken(s, error);
    to->names[size] = '\0';
    for (size_t at = 0; at < size && to->input.count < count; at += strlen(to->names + at) + 1)
        name[to->input.count++] = to->names + at;
    return to->input.count == count ? ROBERTS_OK : broken(s, error);
}

roberts_status roberts_join(const roberts_inputs *part, const roberts_task *task, roberts_joined *joined,
                            roberts_error *error)
{
    joiner j = {.part = alloc_zeroed(part->count, sizeof *j.part), .to = joined};
    roberts_status status = j.part ? ROBERTS_OK : error_no_memory(error);
    *joined = (roberts_joined){0};
    if (status == ROBERTS_OK && part->count == 0)
        status = error_set(error, ROBERTS_BAD_ARGUMENT, 0, "there is no part to join");
    for (; j.count < part->count && status == ROBERTS_OK; j.count++)
        status = open_part(&j.part[j.count], part->name[j.count], error);
    if (status == ROBERTS_OK)
        status = check_parts(&j, task, error);
    if (status == ROBERTS_OK)
        status = take_names(&j, error);
    if (status == ROBERTS_OK && !alloc_drawing(&j))
        status = error_no_memory(error);
    if (status == ROBERTS_OK)
        status = merge_rows(&j, error);
    if (status == ROBERTS_OK)
        describe_whole(&j);
    else
        roberts_joined_free(joined);
    for (size_t i = 0; i < j.count; i++)
        if (j.part[i].file)
            fclose(j.part[i].file);
    free(j.part);
    return status;
}

void roberts_joined_free(roberts_joined *joined)
{
    if (!joined)
        return;
    roberts_drawing_free(&joined->drawing);
    free((void *)joined->input.name);
    free(joined->names);
    *joined = (roberts_joined){0};
}
