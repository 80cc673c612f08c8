/* hints.c - what was meant, why a drawing is empty, or what can be done: the second half of a message. */
#include "cli/hints.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include "cli/lists.h"
#include "cli/message.h"
#include "cli/parse.h"
#include "cli/values.h"

/* ---- words ---- */

enum { LONGEST = 32, FAR = LONGEST * 2 };

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Letters match in either case: "ISO" means iso. */
static bool same(char a, char b)
{
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/* The edit distance of two words: letters left out, added or wrong, and pairs that changed places.
 * Source: the restricted form of Damerau, "A technique for computer detection and correction of spelling errors",
 * CACM 7(3), 1964. */
static size_t distance(const char *a, const char *b)
{
    size_t n = strlen(a), m = strlen(b);
    size_t row[3][LONGEST + 1]; /* of the table: two rows ago, the last, this one */
    if (n > LONGEST || m > LONGEST)
        return FAR;
    for (size_t j = 0; j <= m; j++)
        row[1][j] = row[0][j] = j;
    for (size_t i = 1; i <= n; i++) {
        row[2][0] = i;
        for (size_t j = 1; j <= m; j++) {
            size_t change = row[1][j - 1] + !same(a[i - 1], b[j - 1]);
            row[2][j] = least(change, least(row[1][j], row[2][j - 1]) + 1);
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
                row[2][j] = least(row[2][j], row[0][j - 2] + 1);
        }
        memmove(row[0], row[1], 2 * sizeof row[0]);
    }
    return row[1][m];
}

/* Is `word` the singular of `plural`, as body of bodies? Words that differ by an "s" alone begin alike anyway. */
static bool is_singular(const char *word, const char *plural)
{
    static const struct {
        const char *one, *many;
    } endings[] = {{"ex", "ices"}, {"y", "ies"}};
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++) {
        const size_t whole = strlen(plural), ending = strlen(endings[i].many), stem = whole - least(whole, ending);
        if (strcmp(plural + stem, endings[i].many) == 0 && strncasecmp(word, plural, stem) == 0 &&
            strcasecmp(word + stem, endings[i].one) == 0)
            return true;
    }
    return false;
}

const char *hint_word(const char *word, const char *const *words)
{
    const char *best = NULL;
    size_t length = strlen(word), best_distance = FAR;
    for (size_t i = 0; words[i]; i++) {
        /* The beginning of a word means that word, "isometric" means iso, and "vertex" vertices. Otherwise a third of
         * the letters may be wrong, but none in words of two letters. */
        size_t shorter = least(length, strlen(words[i]));
        bool sure = (shorter >= 2 && strncasecmp(words[i], word, shorter) == 0) || is_singular(word, words[i]);
        size_t d = sure ? 0 : distance(word, words[i]);
        if (d < best_distance && (sure || (shorter > 2 && 3 * d <= shorter + 1))) {
            best = words[i];
            best_distance = d;
        }
    }
    return best;
}

const char *hint_option(const char *word)
{
    static const struct {
        const char *word, *option;
    } known[] = {
        {"angle", "fov"},
        {"axidraw", "layers numbered"},
        {"border", "frame"},
        {"camera", "eye"},
        {"check", "verify"},
        {"color", "style outline:color=NAME"},
        {"colour", "style outline:color=NAME"},
        {"convex", "hull"},
        {"dashed", "hidden dashed"},
        {"debug", "stats"},
        {"direction", "dir"},
        {"files-from", "list"},
        {"height", "page WxH"},
        {"isometric", "view iso"},
        {"jobs", "threads"},
        {"line-width", "style outline:width=MM"},
        {"linewidth", "style outline:width=MM"},
        {"no-hidden", "hidden none"},
        {"optimize", "order"},
        {"paper", "page"},
        {"pen", "style outline:width=MM"},
        {"perspective", "eye"},
        {"portrait", "page"},
        {"position", "eye"},
        {"projection", "view"},
        {"resolution", "dpi"},
        {"resume", "update"},
        {"rotate", "azimuth"},
        {"silent", "quiet"},
        {"size", "page"},
        {"stroke-width", "style outline:width=MM"},
        {"target", "look-at"},
        {"timeout", "limit-seconds"},
        {"type", "format"},
        {"units", "unit"},
        {"viewpoint", "eye"},
        {"width", "style outline:width=MM"},
        {"visible", "hidden none"},
        {"wireframe", "hidden solid"},
        {"zoom", "scale"},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (strcmp(word, known[i].word) == 0)
            return known[i].option;
    return NULL;
}

int hint_unknown(const char *what, const char *word, const char *const *words, const char *also)
{
    const char *meant = hint_word(word, words);
    char list[256] = ""; /* more than the names of any option */
    for (size_t i = 0, used = 0; words[i] && used < sizeof list; i++)
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", words[i]);
    if (meant)
        return message_misuse("%s: \"%s\" is unknown; did you mean %s? It can be %s%s%s", what, word, meant, list,
                              also ? ", " : "", also ? also : "");
    return message_misuse("%s: \"%s\" is unknown; it can be %s%s%s", what, word, list, also ? ", " : "",
                          also ? also : "");
}

/* ---- files and models ---- */

/* Commands that convert formats that their first bytes do not identify. */
static const struct {
    const char *ending, *command;
} converters[] = {
    {".scad", "openscad -o model.stl model.scad"}, {".dae", "assimp export model.dae model.stl"},
    {".fbx", "assimp export model.fbx model.stl"}, {".3ds", "assimp export model.3ds model.stl"},
    {".x3d", "assimp export model.x3d model.stl"}, {".iges", "gmsh -2 model.iges -o model.stl"},
    {".igs", "gmsh -2 model.igs -o model.stl"},    {".brep", "gmsh -2 model.brep -o model.stl"},
};

/* Names the converter for a file with this ending, or returns NULL. */
static const char *converter(const char *name)
{
    const char *dot = strrchr(name, '.');
    for (size_t i = 0; dot && i < sizeof converters / sizeof converters[0]; i++)
        if (strcasecmp(dot, converters[i].ending) == 0)
            return converters[i].command;
    return NULL;
}

/* Bytes of binary STL before its triangles: the header and their number. */
enum { STL_LEAST = 84 };

/* If -o was forgotten, a drawing of an earlier run is read as a model. */
void hint_unread(const cli_options *options, const char *name, roberts_error *error)
{
    const size_t used = strlen(error->message), room = sizeof error->message - used;
    struct stat found;
    roberts_format format;
    if (strcmp(name, "-") == 0 || stat(name, &found) != 0)
        return;
    if (S_ISDIR(found.st_mode))
        snprintf(error->message, sizeof error->message, "is a folder; name the files in it, as *.off or *.stl");
    else if (error->status == ROBERTS_BAD_SYNTAX && strcmp(options->output, "-") == 0 &&
             roberts_format_by_path(name, &format) && !strstr(error->message, "to convert it"))
        snprintf(error->message + used, room, "; to draw into it, name it with -o");
    else if (error->status == ROBERTS_BAD_SYNTAX && converter(name) && !strstr(error->message, "to convert it"))
        snprintf(error->message + used, room, "; to convert it: %s", converter(name));
    else if (error->status == ROBERTS_BAD_SYNTAX && parse_has_ending(name, ".stl") && found.st_size < STL_LEAST &&
             strstr(error->message, "the beginning of OFF"))
        snprintf(error->message + used, room, "; as STL it is cut off: it would have %d bytes or more", STL_LEAST);
}

void hint_label(const char *name, roberts_error *error)
{
    const size_t used = strlen(error->message), kind = strcspn(name, ",");
    struct stat found;
    for (const char *const *word = values_labels; *word; word++)
        if (strlen(*word) == kind && strncmp(name, *word, kind) == 0 && stat(name, &found) != 0)
            snprintf(error->message + used, sizeof error->message - used, "; for numbers: --label %s", name);
}

/* Fewer points have no convex hull. */
enum { HULL_POINTS = 4 };

void hint_refused(const cli_options *options, const roberts_mesh *mesh, roberts_error *error)
{
    const bool shape = error->status == ROBERTS_NOT_PLANAR || error->status == ROBERTS_NOT_CONVEX;
    const size_t used = strlen(error->message), room = sizeof error->message - used;
    roberts_scene_options solids = options->scene;
    solids.threads = options->hide.threads;
    if (options->scene.hull || (!shape && error->status != ROBERTS_NOT_CLOSED))
        return;
    const double tolerance = shape ? roberts_scene_tolerance(mesh, &solids) : 0.0;
    if (tolerance > 0.0)
        snprintf(error->message + used, room, " (--tolerance %g would do; see also --hull)", tolerance);
    else if (mesh->vertex_count >= HULL_POINTS)
        snprintf(error->message + used, room,
                 mesh->face_count ? " (see --hull)" : " (--hull draws the convex hull of points)");
}

void hint_memory(const cli_options *options, roberts_error *error)
{
    const size_t used = strlen(error->message), room = sizeof error->message - used;
    if (error->status == ROBERTS_NO_MEMORY && options->limit_memory > 0.0)
        snprintf(error->message + used, room, ": --limit-memory allows %.10g MB", options->limit_memory);
}

/* ---- drawings that show nothing ---- */

/* As many as a box has edges. */
enum { FEW_LINES = 12 };

/* Of the scene's diameter; a page shows a millionth at best. */
static const double longest_point = 1e-11;

/* Cuts [*t0, *t1] to where a + t (b - a) >= low; false if nothing is left. */
static bool clip(double a, double b, double low, double *t0, double *t1)
{
    if (a < low && b < low)
        return false;
    if (a < low)
        *t0 = fmax(*t0, (low - a) / (b - a));
    if (b < low)
        *t1 = fmin(*t1, (low - a) / (b - a));
    return *t0 <= *t1;
}

/* Whether a part of the segment lies in the window: Liang and Barsky, "A new concept and method for line clipping", ACM
 * Transactions on Graphics 3(1), 1984. */
static bool is_in_window(roberts_vec2 min, roberts_vec2 max, const roberts_segment *s)
{
    double t0 = 0.0, t1 = 1.0;
    return clip(s->p0.x, s->p1.x, min.x, &t0, &t1) && clip(-s->p0.x, -s->p1.x, -max.x, &t0, &t1) &&
           clip(s->p0.y, s->p1.y, min.y, &t0, &t1) && clip(-s->p0.y, -s->p1.y, -max.y, &t0, &t1);
}

/* The class whose pen draws a segment. */
static size_t class_of(const roberts_segment *s)
{
    if (s->state == ROBERTS_HIDDEN)
        return PEN_HIDDEN;
    switch (s->line) {
    case ROBERTS_BORDER:
        return PEN_BORDER;
    case ROBERTS_CREASE:
        return PEN_CREASE;
    case ROBERTS_INTERSECTION:
        return PEN_INTERSECTION;
    case ROBERTS_WIRE:
        return PEN_WIRE;
    default:
        return PEN_OUTLINE;
    }
}

/* What a drawing shows, on the page if there is one. */
typedef struct glance {
    bool any_seen, any_inside; /* a segment in front of the eye; one in the field of view */
    bool any_long;             /* one in the field of view that is not a point in the picture */
    size_t drawn;              /* of these, segments whose pen is on */
} glance;

/* Is a segment a point in the picture, as one along the line of sight? Rounding may leave it some length. */
static bool is_point(const roberts_drawing *d, const roberts_segment *s)
{
    return hypot(s->p1.x - s->p0.x, s->p1.y - s->p0.y) <= longest_point * d->scene_diameter;
}

/* Examines segments until `enough` of them are known to be drawn. */
static glance look(const cli_options *options, const roberts_drawing *drawing, size_t views, size_t enough)
{
    const bool page = !values_is_table(options->draw.format);
    glance g = {0};
    for (const roberts_drawing *d = drawing; d < drawing + views; d++) {
        roberts_vec2 min = d->window_min, max = d->window_max;
        roberts_page_shape(&options->draw.page, &min, &max);
        for (size_t i = 0; i < d->count + (page ? d->cut_count : 0) && g.drawn < enough; i++) {
            const roberts_segment *s = &d->segment[i];
            if (s->state == ROBERTS_CLIPPED)
                continue;
            g.any_seen = true;
            if (d->framed && page && !is_in_window(min, max, s))
                continue;
            g.any_inside = true;
            if (page && is_point(d, s))
                continue;
            g.any_long = true;
            g.drawn += !page || !values_pen(&options->draw, class_of(s))->off;
        }
    }
    return g;
}

/* Whether some face that is seen is filled or hatched. */
static bool shows_faces(const cli_options *options, const roberts_drawing *drawing, size_t views)
{
    const roberts_draw_options *page = &options->draw;
    const bool drawn = page->fill != ROBERTS_FILL_NONE || values_hatches(page);
    for (const roberts_drawing *d = drawing; d < drawing + views && drawn; d++)
        if (d->regions && d->regions->count > 0)
            return true;
    return false;
}

/* Whether labels are written. */
static bool shows_text(const roberts_draw_options *page)
{
    return !page->text.off && (page->lettering.labels || page->lettering.name_count > 0);
}

const char *hint_empty(const cli_options *options, const roberts_drawing *drawing, size_t views)
{
    const glance g = look(options, drawing, views, 1);
    bool too_far = true;
    for (const roberts_drawing *d = drawing; d < drawing + views; d++)
        too_far = too_far && d->epsilon >= d->scene_diameter;
    if (g.drawn > 0 || shows_faces(options, drawing, views))
        return NULL;
    if (g.any_inside && shows_text(&options->draw))
        return NULL;
    if (g.any_inside && !g.any_long)
        return "all lines that could be seen are points from there; --view and --dir look from elsewhere";
    if (g.any_inside)
        return "--style has turned off all lines that could be seen";
    if (g.any_seen)
        return "no line of the scene lies in the field of view; --look-at turns the eye (default: to the middle of the "
               "scene), --fov makes the field wider";
    if (too_far)
        return "from so far away the whole scene is smaller than the touching distance; bring --eye nearer, or set "
               "--epsilon";
    return "no line of the scene is seen from there; --eye, --look-at, --near and --section say what is in front of "
           "the eye";
}

/* A face that the input does not have is the cut of the near plane (or belongs to a hull). roberts_pick() takes as long
 * as the view, so it is called only if hardly anything is drawn. If --section was given, or --near and something is
 * drawn, the cut is intended. */
bool hint_near_plane(const cli_options *options, const roberts_scene *scene, const roberts_drawing *drawing, char *why,
                     size_t size)
{
    const size_t few = options->camera.near_distance > 0.0 ? 1 : FEW_LINES;
    roberts_picked picked;
    if (options->camera.projection != ROBERTS_PERSPECTIVE || options->camera.has_section || options->scene.hull ||
        !drawing->framed || look(options, drawing, 1, few).drawn >= few ||
        roberts_pick(scene, &options->camera, 0.0, 0.0, &picked, NULL) != ROBERTS_OK)
        return false;
    const bool cut = picked.count > 0 && picked.hit[0].face == ROBERTS_NONE;
    if (cut) {
        const roberts_vec3 eye = options->camera.eye, p = picked.hit[0].point;
        snprintf(
            why, size,
            "the near plane, %.3g before the eye, cuts solid %u in the middle of the picture, so that nothing is "
            "seen there: if the eye is inside the solid, move --eye out; if not, move it away, or make --near less",
            hypot(hypot(p.x - eye.x, p.y - eye.y), p.z - eye.z), (unsigned)picked.hit[0].solid);
    }
    roberts_picked_free(&picked);
    return cut;
}

/* ---- options that change nothing in this drawing ---- */

/* Marks the names of edges that are sides of faces. */
static void mark_edges(const roberts_mesh *mesh, const roberts_lettering *names, bool *found)
{
    for (size_t f = 0; f < mesh->face_count; f++) {
        const uint32_t first = mesh->face_start[f], end = mesh->face_start[f + 1];
        for (uint32_t i = first; i < end; i++) {
            const uint32_t a = mesh->corner[i], b = mesh->corner[i + 1 < end ? i + 1 : first];
            const roberts_name side = {.of = ROBERTS_LABEL_EDGES, .number = a < b ? a : b, .other = a < b ? b : a};
            const roberts_name *name = names_find(names->name, names->name_count, &side);
            if (name)
                found[name - names->name] = true;
        }
    }
}

bool hint_idle_names(const cli_options *options, const roberts_mesh *mesh, size_t bodies, char *text, size_t size)
{
    const roberts_lettering *names = &options->draw.lettering;
    size_t idle = 0, first = 0;
    bool *found = calloc(names->name_count + 1, sizeof *found);
    char thing[40];
    if (!found)
        return false; /* without memory, the run will fail anyway */
    mark_edges(mesh, names, found);
    for (size_t i = names->name_count; i-- > 0;) {
        const roberts_name *name = &names->name[i];
        const size_t count = name->of == ROBERTS_LABEL_VERTICES ? mesh->vertex_count
                             : name->of == ROBERTS_LABEL_FACES  ? mesh->face_count
                                                                : bodies;
        if (name->of == ROBERTS_LABEL_EDGES ? !found[i] : name->number >= count) {
            idle++;
            first = i;
        }
    }
    free(found);
    if (idle == 0)
        return false;
    names_thing(&names->name[first], thing, sizeof thing);
    const char *slash = strrchr(options->names, '/');
    const int used =
        snprintf(text, size, "there is no %s, which %.100s names", thing, slash ? slash + 1 : options->names);
    if (idle > 1)
        snprintf(text + used, size - (size_t)used, ", and %zu more of its names %s no effect", idle - 1,
                 idle == 2 ? "has" : "have");
    return true;
}

bool hint_idle_pens(const cli_options *options, const roberts_drawing *drawing, size_t views, char *text, size_t size)
{
    bool there[PENS] = {0};
    size_t found = 0, used = 0;
    for (size_t pen = PEN_FRAME; pen < PENS; pen++)
        there[pen] = true; /* check_warn() handles these */
    there[PEN_HIDDEN] = options->draw.hidden == ROBERTS_HIDDEN_NONE;
    for (const roberts_drawing *d = drawing; d < drawing + views; d++)
        for (size_t i = 0; i < d->count; i++)
            there[class_of(&d->segment[i])] |= d->segment[i].state != ROBERTS_CLIPPED;
    for (size_t pen = 0; pen < PENS && used < size; pen++)
        if (!there[pen] && (options->named_pens >> pen & 1) &&
            (values_pen_is_set(&options->draw, pen) || values_pen(&options->draw, pen)->off))
            used += (size_t)snprintf(text + used, size - used, "%s--style %s", found++ ? ", " : "", values_pens[pen]);
    if (found > 0 && used < size)
        snprintf(text + used, size - used, " %s no effect: the drawing has no such lines", found > 1 ? "have" : "has");
    return found > 0;
}

bool hint_no_colors(const cli_options *options, const roberts_drawing *drawing, size_t views)
{
    if (options->draw.fill != ROBERTS_FILL_MODEL)
        return false;
    for (const roberts_drawing *d = drawing; d < drawing + views; d++)
        for (size_t i = 0; d->regions && i < d->regions->count; i++)
            if (d->regions->region[i].color.count > 0)
                return false;
    return true;
}

/* Fraction: --epsilon that is more of the faces' width is probably a mistake. */
static const double wide_epsilon = 0.05;

bool hint_wide_epsilon(const cli_options *options, const roberts_drawing *drawing, double *width)
{
    const roberts_vec2 min = drawing->window_min, max = drawing->window_max;
    const size_t faces = drawing->front_faces + drawing->back_faces + drawing->edge_on_faces;
    *width = sqrt((max.x - min.x) / (double)faces) * sqrt(max.y - min.y);
    return options->hide.epsilon > wide_epsilon * *width && faces > 0 && !drawing->framed;
}

/* The library's rule: a face has strokes if it is dark, as far as the levels tell, by more than rounding, or if it is a
 * section and only sections have strokes. */
bool hint_idle_hatch(const cli_options *options, const roberts_drawing *drawing, size_t views)
{
    const roberts_hatching *h = &options->draw.hatching;
    const double rounding = 1e-12;
    const roberts_vec3 l = options->draw.light;
    const double length = hypot(hypot(l.x, l.y), l.z), least = h->levels > 0 ? 0.5 / h->levels : 0.0;
    size_t regions = 0;
    if (!values_hatches(&options->draw))
        return false;
    for (const roberts_drawing *d = drawing; d < drawing + views; d++)
        for (size_t i = 0; d->regions && i < d->regions->count; i++, regions++) {
            const roberts_region *seen = &d->regions->region[i];
            const roberts_vec3 n = seen->normal;
            const double dark = 1.0 - (n.x * l.x + n.y * l.y + n.z * l.z) / length;
            if (h->sections ? seen->section : dark > rounding && dark >= least)
                return false;
        }
    return regions > 0;
}

size_t hint_curved(const roberts_scene *scene)
{
    size_t curved = 0;
    for (uint32_t s = 0; s < roberts_scene_solid_count(scene); s++)
        curved += roberts_scene_body_curved(scene, s);
    return curved;
}

size_t hint_round(const roberts_scene *scene)
{
    size_t round = 0;
    for (uint32_t s = 0; s < roberts_scene_solid_count(scene); s++)
        round += roberts_scene_body_kind(scene, s) == ROBERTS_CONVEX &&
                 roberts_scene_body_face_count(scene, s) > ROBERTS_FACETED_MOST;
    return round;
}

bool hint_all_open(const roberts_scene *scene)
{
    const uint32_t bodies = (uint32_t)roberts_scene_solid_count(scene);
    for (uint32_t s = 0; s < bodies; s++)
        if (roberts_scene_body_kind(scene, s) != ROBERTS_OPEN)
            return false;
    return true;
}

bool hint_flat(const cli_options *options, const roberts_scene *scene, const roberts_drawing *drawing)
{
    /* of triangles alone; each has three sides, and those within have two triangles */
    const size_t edges = roberts_scene_edge_count(scene), drawn = drawing->drawn_edges;
    const bool triangles = 2 * edges - drawn == 3 * roberts_scene_face_count(scene);
    if (!options->hide.crease_auto || options->hide.all_edges || drawn == edges || (triangles && drawn > edges / 2))
        return false;
    if (!hint_all_open(scene)) /* the others, which sheets hide or a section takes away, have edges of their own */
        return false;
    for (size_t i = 0; i < drawing->count; i++)
        if (drawing->segment[i].line != ROBERTS_BORDER)
            return false;
    /* edges of curved bodies are left out for another reason, which a note gives */
    return drawing->count > 0 && hint_curved(scene) == 0;
}

bool hint_no_names(const roberts_scene *scene)
{
    const uint32_t bodies = (uint32_t)roberts_scene_solid_count(scene);
    for (uint32_t s = 0; s < bodies; s++)
        if (*roberts_scene_name(scene, s))
            return false;
    return true;
}

bool hint_idle_hull(const roberts_scene *scene, size_t faces)
{
    const uint32_t bodies = (uint32_t)roberts_scene_solid_count(scene);
    for (uint32_t s = 0; s < bodies; s++)
        if (roberts_scene_is_hull(scene, s))
            return false;
    return roberts_scene_face_count(scene) == faces;
}

bool hint_idle_rule(const roberts_scene *scene)
{
    return roberts_scene_piece_count(scene) == roberts_scene_face_count(scene);
}
