/* trials.c - drawings whose pages are compared with their tables.
 *
 * The families here resemble real models: solids that touch, are turned, rounded to some digits, or off by a little
 * noise. So edges may lie on one another on the page, and not quite in space. */
#include "trials.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../oracle/judge.h"
#include "../oracle/studio.h"
#include "base/array.h"
#include "plots.h"

/* ---- families -------------------------------------------------------------------------------------------------- */

static const double pi = 3.14159265358979323846;

/* Turns the whole scene. */
static void turn_all(studio *st)
{
    roberts_mesh *mesh = &st->scene->mesh;
    double a = pi * rng_real(&st->d), b = pi * rng_real(&st->d);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        roberts_vec3 *p = &mesh->vertex[i];
        *p = (roberts_vec3){cos(a) * p->x - sin(a) * p->y, sin(a) * p->x + cos(a) * p->y, p->z};
        *p = (roberts_vec3){p->x, cos(b) * p->y - sin(b) * p->z, sin(b) * p->y + cos(b) * p->z};
    }
}

/* Rounds all coordinates to this number of digits. */
static void round_all(studio *st, int digits)
{
    roberts_mesh *mesh = &st->scene->mesh;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        double *at[] = {&mesh->vertex[i].x, &mesh->vertex[i].y, &mesh->vertex[i].z};
        for (int k = 0; k < 3; k++) {
            char text[40];
            snprintf(text, sizeof text, "%.*g", digits, *at[k]);
            *at[k] = strtod(text, NULL);
        }
    }
}

/* Every coordinate is off by up to `most`. */
static void shake_all(studio *st, double most)
{
    roberts_mesh *mesh = &st->scene->mesh;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        mesh->vertex[i].x += most * rng_real(&st->d);
        mesh->vertex[i].y += most * rng_real(&st->d);
        mesh->vertex[i].z += most * rng_real(&st->d);
    }
}

/* Leaves contacts exact, rounds them to 5 to 7 digits, or gives them noise of 1e-6 to 1e-12. */
static void spoil_contacts(studio *st)
{
    switch (rng_int(&st->d, 0, 3)) {
    case 0:
        break;
    case 1:
        shake_all(st, pow(10, -rng_int(&st->d, 6, 12)));
        break;
    default:
        round_all(st, rng_int(&st->d, 5, 7));
    }
}

/* A wall in running bond, turned; bricks lie on one another along their edges. */
static void wall(studio *st)
{
    int rows = rng_int(&st->d, 2, 5), columns = rng_int(&st->d, 2, 5), deep = rng_int(&st->d, 1, 2);
    for (int z = 0; z < rows; z++)
        for (int x = 0; x < columns; x++)
            for (int y = 0; y < deep; y++)
                put_box(st, (roberts_vec3){2 * x + z % 2, y, z}, (roberts_vec3){2 * x + z % 2 + 2, y + 1, z + 1});
    if (rng_int(&st->d, 0, 3))
        turn_all(st);
    spoil_contacts(st);
    look_any(st);
}

static shape rhombic_dodecahedron(void)
{
    shape s = {0};
    for (int i = 0; i < 8; i++)
        shape_point(&s, i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    for (int sign = -2; sign <= 2; sign += 4) {
        shape_point(&s, sign, 0, 0);
        shape_point(&s, 0, sign, 0);
        shape_point(&s, 0, 0, sign);
    }
    shape_hull(&s);
    return s;
}

static shape truncated_octahedron(void)
{
    shape s = {0};
    for (int zero = 0; zero < 3; zero++)
        for (int i = 0; i < 8; i++) {
            int p[3];
            p[zero] = 0;
            p[(zero + 1) % 3] = (i & 1 ? 1 : -1) * (i & 4 ? 1 : 2);
            p[(zero + 2) % 3] = (i & 2 ? 1 : -1) * (i & 4 ? 2 : 1);
            shape_point(&s, p[0], p[1], p[2]);
        }
    shape_hull(&s);
    return s;
}

/* Cells that fill space: cubes, rhombic dodecahedra or truncated octahedra, some of them missing. */
static void honeycomb(studio *st)
{
    int n = rng_int(&st->d, 2, 3), kind = rng_int(&st->d, 0, 2);
    shape cell = kind == 0 ? shape_box(2, 2, 2) : kind == 1 ? rhombic_dodecahedron() : truncated_octahedron();
    for (int i = 0; i < n * n * n; i++) {
        int x = i % n, y = i / n % n, z = i / n / n;
        if (i && rng_int(&st->d, 0, 4) == 0)
            continue;
        if (kind == 0)
            put(st, &cell, 2 * x, 2 * y, 2 * z);
        else if (kind == 1) /* face-centred: x + y + z is even, times 2 */
            put(st, &cell, 2 * (x + y), 2 * (x + z), 2 * (y + z));
        else /* body-centred */
            put(st, &cell, 4 * x + 2 * (z % 2), 4 * y + 2 * (z % 2), 2 * z);
    }
    if (rng_int(&st->d, 0, 1))
        turn_all(st);
    spoil_contacts(st);
    look_any(st);
}

/* Boxes between whole coordinates that touch and overlap. */
static void boxes(studio *st)
{
    int count = rng_int(&st->d, 4, 30);
    for (int i = 0; i < count; i++) {
        roberts_vec3 p = whole_point(st, 0, 6), size = whole_point(st, 1, 3);
        put_box(st, p, (roberts_vec3){p.x + size.x, p.y + size.y, p.z + size.z});
    }
    if (rng_int(&st->d, 0, 2) == 0)
        turn_all(st);
    spoil_contacts(st);
    look_any(st);
}

/* A round disc of `count` corners with its axis along z. */
static void put_disc(studio *st, int count, double radius, double low, double high)
{
    roberts_mesh *mesh = &st->scene->mesh;
    uint32_t base = (uint32_t)mesh->vertex_count, *face = alloc_array((size_t)count, sizeof *face);
    st->no_memory = st->no_memory || !face;
    for (int i = 0; i < 2 * count && !st->no_memory; i++) {
        double angle = 2.0 * pi * (i / 2) / count;
        roberts_vec3 p = {radius * cos(angle), radius * sin(angle), i % 2 ? high : low};
        st->no_memory = roberts_mesh_add_vertex(mesh, p, NULL, NULL) != ROBERTS_OK;
    }
    for (int side = 0; side < 2 && !st->no_memory; side++) {
        for (int i = 0; i < count; i++)
            face[i] = base + 2 * (uint32_t)i + (uint32_t)side;
        st->no_memory = roberts_mesh_add_face(mesh, face, (size_t)count, NULL) != ROBERTS_OK;
    }
    for (int i = 0; i < count && !st->no_memory; i++) {
        uint32_t here = base + 2 * (uint32_t)i, next = base + 2 * (uint32_t)((i + 1) % count);
        const uint32_t quad[] = {here, next, next + 1, here + 1};
        st->no_memory = roberts_mesh_add_face(mesh, quad, 4, NULL) != ROBERTS_OK;
    }
    free(face);
}

/* Discs of very many corners on one another, among boxes so large that the sides of the discs are shorter than a
 * micrometre on the page, or not. */
static void discs(studio *st)
{
    int count = rng_int(&st->d, 2, 4), corners = rng_int(&st->d, 100, 500);
    double away = pow(10, rng_int(&st->d, 0, 4));
    for (int i = 0; i < count; i++)
        put_disc(st, corners, 1, i, i + 1);
    put_box(st, (roberts_vec3){away, away, 0}, (roberts_vec3){away + 1, away + 1, 1});
    if (rng_int(&st->d, 0, 1))
        turn_all(st);
    spoil_contacts(st);
    look_any(st);
}

/* Chains of tiny boxes on one another beside a large one: their edges are shorter than a micrometre on the page. */
static void tiny(studio *st)
{
    int count = rng_int(&st->d, 20, 120);
    double size = pow(10, -rng_int(&st->d, 3, 6)) * rng_int(&st->d, 1, 9);
    bool shifted = rng_int(&st->d, 0, 1);
    put_box(st, (roberts_vec3){1, 1, 0}, (roberts_vec3){2, 2, 1});
    for (int i = 0; i < count; i++) {
        double y = shifted ? size * 0.25 * (i % 4) : 0;
        put_box(st, (roberts_vec3){size * i, y, 0}, (roberts_vec3){size * (i + 1), y + size, size});
    }
    if (rng_int(&st->d, 0, 1))
        turn_all(st);
    if (rng_int(&st->d, 0, 1))
        shake_all(st, size * pow(10, -rng_int(&st->d, 6, 12)));
    look_any(st);
}

static const struct {
    const char *name;
    void (*make)(studio *st);
} families[] = {
    {"turned-wall", wall}, {"honeycomb", honeycomb}, {"touching-boxes", boxes}, {"discs", discs}, {"tiny-chain", tiny},
};

enum { OWN_FAMILIES = sizeof families / sizeof families[0] };

size_t trial_family_count(void)
{
    return OWN_FAMILIES + scene_family_count();
}

size_t trial_own_families(void)
{
    return OWN_FAMILIES;
}

const char *trial_family_name(size_t i)
{
    return i < OWN_FAMILIES ? families[i].name : scene_family_name(i - OWN_FAMILIES);
}

bool trial_make(size_t family, uint64_t seed, trial_scene *scene)
{
    test_scene made = {0};
    bool done = false;
    *scene = (trial_scene){0};
    snprintf(scene->name, sizeof scene->name, "%s-%llu", trial_family_name(family), (unsigned long long)seed);
    if (family >= OWN_FAMILIES) {
        done = scene_make(scene_family_name(family - OWN_FAMILIES), seed, &made);
    } else {
        studio st = {.scene = &made, .d = {seed}, .unit = 1};
        for (const char *c = families[family].name; *c; c++)
            st.d.state = rng_next(&st.d) ^ (unsigned char)*c;
        families[family].make(&st);
        done = !st.no_memory;
        scene->tolerance = 1e-3; /* few digits */
    }
    if (done) {
        roberts_mesh *from = made.has_soup ? &made.soup : &made.mesh;
        scene->mesh = *from;
        *from = (roberts_mesh){0};
        scene->hull = made.hull;
        scene->camera = judge_camera(&made);
    }
    test_scene_free(&made);
    return done;
}

void trial_free(trial_scene *scene)
{
    roberts_mesh_free(&scene->mesh);
}

/* ---- styles ---------------------------------------------------------------------------------------------------- */

#define NONE ROBERTS_HIDDEN_NONE
#define DASHED ROBERTS_HIDDEN_DASHED
#define SOLID ROBERTS_HIDDEN_SOLID
#define TRAVEL ROBERTS_ORDER_TRAVEL
#define AS_GIVEN ROBERTS_ORDER_NONE

static const trial_style styles[] = {
    {"dashed", TRIAL_VIEW, DASHED, TRAVEL, false, false, ROBERTS_SVG},
    {"plain", TRIAL_VIEW, NONE, TRAVEL, false, false, ROBERTS_PDF},
    {"dashed-in-order", TRIAL_VIEW, DASHED, AS_GIVEN, false, false, ROBERTS_PDF},
    {"solid", TRIAL_VIEW, SOLID, TRAVEL, false, false, ROBERTS_PNG},
    {"real-dashes", TRIAL_VIEW, DASHED, TRAVEL, true, false, ROBERTS_PDF},
    {"framed", TRIAL_VIEW, DASHED, TRAVEL, false, true, ROBERTS_PDF},
    {"fov", TRIAL_FOV, DASHED, TRAVEL, false, false, ROBERTS_PDF},
    {"plain-in-order", TRIAL_VIEW, NONE, AS_GIVEN, false, false, ROBERTS_PNG},
    {"sheet", TRIAL_SHEET, DASHED, TRAVEL, false, false, ROBERTS_PDF},
    {"real-dashes-in-order", TRIAL_VIEW, DASHED, AS_GIVEN, true, false, ROBERTS_PNG},
    {"fov-framed", TRIAL_FOV, SOLID, AS_GIVEN, false, true, ROBERTS_PNG},
    {"sheet-framed", TRIAL_SHEET, NONE, AS_GIVEN, false, true, ROBERTS_PDF},
};

size_t trial_style_count(void)
{
    return sizeof styles / sizeof styles[0];
}

const trial_style *trial_style_at(size_t i)
{
    return &styles[i];
}

static roberts_draw_options options_of(const trial_style *style)
{
    roberts_draw_options options = paper_options();
    options.hidden = style->hidden;
    options.order = style->order;
    options.real_dashes = style->real_dashes;
    options.frame.off = !style->frame;
    options.dpi = 254.0; /* ten pixels per mm */
    if (style->kind == TRIAL_SHEET)
        options.page = (roberts_page){.width_mm = 297.0, .height_mm = 210.0, .margin_mm = 10.0};
    else if (style->format == ROBERTS_PNG)
        options.page = (roberts_page){.width_mm = 90.0, .height_mm = 80.0, .margin_mm = 5.0};
    return options;
}

/* ---- one drawing ----------------------------------------------------------------------------------------------- */

enum { VIEWS = ROBERTS_SHEET_VIEWS };

/* What is drawn: one drawing, or four on a sheet. */
typedef struct drawings {
    roberts_drawing drawing[VIEWS];
    roberts_sheet sheet;
    int count;
} drawings;

typedef struct bytes {
    char *at;
    size_t size, room;
} bytes;

static bool take(void *context, const void *from, size_t size)
{
    bytes *to = context;
    if (!array_reserve(&to->at, &to->room, to->size + size + 1, 1))
        return false;
    memcpy(to->at + to->size, from, size);
    to->size += size;
    to->at[to->size] = '\0';
    return true;
}

static bool write_all(const drawings *d, const roberts_draw_options *options, bytes *to)
{
    *to = (bytes){0};
    return (d->count > 1 ? roberts_sheet_write(&d->sheet, options, take, to, NULL)
                         : roberts_drawing_write(&d->drawing[0], options, take, to, NULL)) == ROBERTS_OK;
}

/* A camera that sees a part of the scene, from the side of the given one. */
static roberts_camera look_closer(const roberts_mesh *mesh, const roberts_camera *camera)
{
    roberts_vec3 low = mesh->vertex[0], high = low, to = camera->dir;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        roberts_vec3 p = mesh->vertex[i];
        low = (roberts_vec3){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (roberts_vec3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    roberts_vec3 middle = {(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
    double size = hypot(hypot(high.x - low.x, high.y - low.y), high.z - low.z);
    if (camera->projection == ROBERTS_PERSPECTIVE)
        to = (roberts_vec3){camera->eye.x - middle.x, camera->eye.y - middle.y, camera->eye.z - middle.z};
    double k = 2.0 * size / hypot(hypot(to.x, to.y), to.z);
    return (roberts_camera){.projection = ROBERTS_PERSPECTIVE,
                            .eye = {middle.x + k * to.x, middle.y + k * to.y, middle.z + k * to.z},
                            .look_at = middle,
                            .has_look_at = true,
                            .fov_degrees = 15.0};
}

static bool hide_all(const trial_scene *from, const trial_style *style, drawings *d)
{
    const roberts_scene_options solids = {.tolerance = from->tolerance, .hull = from->hull};
    roberts_scene *scene;
    roberts_hide_options options = roberts_hide_options_default();
    options.keep_hidden = style->hidden != NONE;
    *d = (drawings){.count = style->kind == TRIAL_SHEET ? VIEWS : 1, .sheet.angle = ROBERTS_THIRD_ANGLE};
    if (roberts_scene_build(&from->mesh, &solids, &scene, NULL) != ROBERTS_OK)
        return false;
    bool done = true;
    for (int i = 0; i < d->count && done; i++) {
        roberts_camera camera = from->camera;
        if (style->kind == TRIAL_SHEET)
            done = roberts_sheet_camera(d->sheet.angle, i, &camera);
        else if (style->kind == TRIAL_FOV)
            camera = look_closer(&from->mesh, &from->camera);
        done = done && roberts_hide(scene, &camera, &options, &d->drawing[i], NULL) == ROBERTS_OK;
        d->sheet.view[i] = &d->drawing[i];
    }
    roberts_scene_free(scene);
    return done;
}

static void check_png(const drawings *d, const row_list *r, roberts_draw_options options, findings *f)
{
    bytes file;
    picture shown = {0};
    options.format = ROBERTS_PNG;
    if (write_all(d, &options, &file) && picture_read_png(&shown, file.at, file.size))
        check_pixels(r, &shown, &options, f);
    else
        f->pixels++;
    picture_free(&shown);
    free(file.at);
}

static void check_pdf(const drawings *d, const row_list *r, const paper *svg, roberts_draw_options options, findings *f)
{
    bytes file;
    paper pdf = {0};
    options.format = ROBERTS_PDF;
    if (write_all(d, &options, &file) && paper_read_pdf(&pdf, file.at, file.size, options.page.height_mm) &&
        check_same(svg, &pdf)) {
        check_lines(r, &pdf, &options, f);
    } else {
        if (f->out)
            fprintf(f->out, "  PDF: not the lines of the SVG, or not understood\n");
        f->missing++;
    }
    paper_free(&pdf);
    free(file.at);
}

/* TikZ, DXF and HP-GL/2 have the strokes and pens of the SVG. */
static void check_plots(const drawings *d, const char *svg, roberts_draw_options options, findings *f)
{
    static const roberts_format formats[] = {ROBERTS_TIKZ, ROBERTS_DXF, ROBERTS_HPGL};
    const double height_mm = options.page.height_mm;
    plot wanted;
    bool read = plot_read(&wanted, ROBERTS_SVG, svg, height_mm);
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        bytes file = {0};
        plot own = {0};
        options.format = formats[i];
        if (!(read && write_all(d, &options, &file) && plot_read(&own, formats[i], file.at, height_mm) &&
              plot_is_same(&wanted, &own, formats[i], height_mm, f->out))) {
            if (f->out)
                fprintf(f->out, "  format %d: not the strokes of the SVG, or not understood\n", formats[i]);
            f->missing++;
        }
        plot_free(&own);
        free(file.at);
    }
    plot_free(&wanted);
}

static void check_all(const drawings *d, const row_list *r, const trial_style *style,
                      const roberts_draw_options *options, findings *f)
{
    bytes file;
    paper svg = {0};
    if (write_all(d, options, &file) && paper_read_svg(&svg, file.at, file.size)) {
        check_lines(r, &svg, options, f);
        check_plots(d, file.at, *options, f);
        if (style->format == ROBERTS_PDF)
            check_pdf(d, r, &svg, *options, f);
    } else {
        if (f->out)
            fprintf(f->out, "  SVG: not understood\n");
        f->missing++;
    }
    if (style->format == ROBERTS_PNG)
        check_png(d, r, *options, f);
    paper_free(&svg);
    free(file.at);
}

trial_result trial_run(const trial_scene *scene, const trial_style *style, findings *f)
{
    drawings d;
    row_list r = {0};
    roberts_draw_options options = options_of(style);
    size_t before = findings_total(f);
    bool drawn = hide_all(scene, style, &d) && (style->kind == TRIAL_SHEET ? rows_place_sheet(&r, &d.sheet, &options)
                                                                           : rows_place(&r, &d.drawing[0], &options));
    if (drawn)
        check_all(&d, &r, style, &options, f);
    rows_free(&r);
    for (int i = 0; i < d.count; i++)
        roberts_drawing_free(&d.drawing[i]);
    return !drawn ? TRIAL_REFUSED : findings_total(f) > before ? TRIAL_WRONG : TRIAL_RIGHT;
}
