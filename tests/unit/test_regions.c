/* test_regions.c - visible regions tile the shadow of a scene's picture, each of the face that is seen there.
 *
 * The shadow is the union of the pictures of all faces. Its area is found here by cutting the picture into upright
 * strips in which no two sides cross. roberts_pick() finds what is seen at a point, by casting a ray. The environment
 * variable REGIONS requests more random scenes, until they have so many regions (`make check-long`). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/sort.h"
#include "scenes.h"
#include "segments.h"

#include "roberts.h"

enum { SCENES = 60, ROUNDED_SCENES = 600, POINTS = 12, MOST_FACES = 80, MOST_CORNERS = 4 };

/* ---- scenes ---------------------------------------------------------------------------------------------------- */

static roberts_vec3 grid_point(rng *r, int size)
{
    return (roberts_vec3){rng_int(r, -size, size), rng_int(r, -size, size), rng_int(r, -size, size)};
}

/* Skew boxes in one another. */
static void make_skew(rng *r, roberts_mesh *mesh)
{
    for (int i = rng_int(r, 1, 6); i > 0; i--)
        mesh_block(mesh, rng_vec3(r, 3), rng_vec3(r, 3), rng_vec3(r, 3), rng_vec3(r, 3));
}

/* Boxes on a grid: they touch, lie flush, hold or repeat one another, and have faces in one plane. */
static void make_blocks(rng *r, roberts_mesh *mesh)
{
    for (int i = rng_int(r, 2, 10); i > 0; i--)
        mesh_block(mesh, grid_point(r, 2), (roberts_vec3){rng_int(r, 1, 3), 0, 0},
                   (roberts_vec3){0, rng_int(r, 1, 3), 0}, (roberts_vec3){0, 0, rng_int(r, 1, 3)});
}

/* The same, sheared along the grid. */
static void make_sheared(rng *r, roberts_mesh *mesh)
{
    for (int i = rng_int(r, 2, 7); i > 0; i--)
        mesh_block(mesh, grid_point(r, 2), (roberts_vec3){rng_int(r, 1, 3), rng_int(r, -1, 1), 0},
                   (roberts_vec3){0, rng_int(r, 1, 3), rng_int(r, -1, 1)}, (roberts_vec3){0, 0, rng_int(r, 1, 3)});
}

/* Triangles through one another. */
static void make_soup(rng *r, roberts_mesh *mesh)
{
    for (int i = rng_int(r, 2, 20); i > 0; i--)
        mesh_triangle(mesh, rng_vec3(r, 4), rng_vec3(r, 4), rng_vec3(r, 4));
}

/* Triangles with corners on a grid: many share corners and planes, and some are seen edge-on. */
static void make_grid_soup(rng *r, roberts_mesh *mesh)
{
    for (int i = rng_int(r, 2, 14); i > 0; i--)
        mesh_triangle(mesh, grid_point(r, 2), grid_point(r, 2), grid_point(r, 2));
}

/* Horizontal triangles in few planes, over and in one another. */
static void make_layers(rng *r, roberts_mesh *mesh)
{
    for (int i = rng_int(r, 2, 12); i > 0; i--) {
        double z = rng_int(r, 0, 2);
        roberts_vec3 p[3];
        for (int k = 0; k < 3; k++)
            p[k] = (roberts_vec3){rng_int(r, -4, 4), rng_int(r, -4, 4), z};
        mesh_triangle(mesh, p[0], p[1], p[2]);
    }
}

typedef void make_fn(rng *r, roberts_mesh *mesh);

static const struct {
    const char *name;
    make_fn *make;
} families[] = {
    {"skew boxes", make_skew},
    {"blocks", make_blocks},
    {"sheared blocks", make_sheared},
    {"triangles", make_soup},
    {"triangles on a grid", make_grid_soup},
    {"layers", make_layers},
};

/* ---- the shadow ------------------------------------------------------------------------------------------------ */

typedef struct face_picture {
    roberts_vec2 p[MOST_CORNERS];
    uint32_t count;
} face_picture;

/* Where a corner is in the picture from above: of the camera below, or from an eye at this height. */
static roberts_vec2 seen_from_above(roberts_vec3 p, roberts_vec3 middle, double height)
{
    if (height == 0)
        return (roberts_vec2){p.x - middle.x, p.y - middle.y};
    return (roberts_vec2){p.x / (1 - p.z / height), p.y / (1 - p.z / height)};
}

typedef struct span {
    double low, high;
} span;

static int compare_spans(const void *a, const void *b)
{
    double p = ((const span *)a)->low, q = ((const span *)b)->low;
    return (p > q) - (p < q);
}

/* How much of an upright line lies in some of the convex polygons. */
static double covered(const face_picture *face, size_t count, double x)
{
    span own[MOST_FACES];
    size_t found = 0;
    for (size_t f = 0; f < count; f++) {
        span s = {HUGE_VAL, -HUGE_VAL};
        for (uint32_t k = 0; k < face[f].count; k++) {
            roberts_vec2 p = face[f].p[k], q = face[f].p[(k + 1) % face[f].count];
            if ((p.x <= x) == (q.x <= x))
                continue;
            double y = p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y);
            s = (span){fmin(s.low, y), fmax(s.high, y)};
        }
        if (s.low < s.high)
            own[found++] = s;
    }
    qsort(own, found, sizeof *own, compare_spans);
    double sum = 0, at = -HUGE_VAL;
    for (size_t i = 0; i < found; i++) {
        sum += fmax(0, own[i].high - fmax(own[i].low, at));
        at = fmax(at, own[i].high);
    }
    return sum;
}

/* The area of the union of convex polygons. */
static double shadow(const face_picture *face, size_t count)
{
    enum { SIDES = MOST_FACES * MOST_CORNERS };
    static roberts_vec2 side[SIDES][2];
    static double cut[SIDES + SIDES * SIDES / 2];
    size_t sides = 0, cuts = 0;
    for (size_t f = 0; f < count; f++)
        for (uint32_t k = 0; k < face[f].count; k++) {
            side[sides][0] = face[f].p[k];
            side[sides][1] = face[f].p[(k + 1) % face[f].count];
            cut[cuts++] = side[sides++][0].x;
        }
    for (size_t i = 0; i < sides; i++)
        for (size_t j = 0; j < i; j++) {
            roberts_vec2 a = side[i][0], b = side[i][1], c = side[j][0], d = side[j][1];
            double turn = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
            double t = ((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / turn;
            if (turn != 0 && t > 0 && t < 1)
                cut[cuts++] = a.x + t * (b.x - a.x);
        }
    qsort(cut, cuts, sizeof *cut, compare_doubles);
    double sum = 0;
    for (size_t i = 0; i + 1 < cuts; i++)
        if (cut[i + 1] > cut[i])
            sum += (cut[i + 1] - cut[i]) * covered(face, count, 0.5 * (cut[i] + cut[i + 1]));
    return sum;
}

static double shadow_of(const roberts_mesh *mesh, double height)
{
    face_picture face[MOST_FACES];
    roberts_vec3 low = mesh->vertex[0], high = low;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        roberts_vec3 p = mesh->vertex[i];
        low = (roberts_vec3){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (roberts_vec3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    roberts_vec3 middle = {0.5 * (low.x + high.x), 0.5 * (low.y + high.y), 0.5 * (low.z + high.z)};
    assert_true(mesh->face_count <= MOST_FACES);
    for (size_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *corner = mesh->corner + mesh->face_start[f];
        face[f].count = mesh->face_start[f + 1] - mesh->face_start[f];
        for (uint32_t k = 0; k < face[f].count; k++)
            face[f].p[k] = seen_from_above(mesh->vertex[corner[k]], middle, height);
    }
    return shadow(face, mesh->face_count);
}

/* ---- regions --------------------------------------------------------------------------------------------------- */

static double ring_area(const roberts_region_list *l, size_t ring)
{
    size_t first = l->ring_start[ring], end = l->ring_start[ring + 1];
    roberts_vec2 o = l->corner[first];
    double sum = 0;
    for (size_t i = first; i < end; i++) {
        roberts_vec2 p = l->corner[i], q = l->corner[i + 1 < end ? i + 1 : first];
        sum += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
    }
    return 0.5 * sum;
}

/* Is (x, y) in the region, and how far is it from the border? */
static bool holds(const roberts_region_list *l, const roberts_region *region, double x, double y, double *off)
{
    bool inside = false;
    for (size_t r = region->first_ring; r < region->first_ring + region->ring_count; r++)
        for (size_t i = l->ring_start[r]; i < l->ring_start[r + 1]; i++) {
            roberts_vec2 p = l->corner[i], q = l->corner[i + 1 < l->ring_start[r + 1] ? i + 1 : l->ring_start[r]];
            double dx = q.x - p.x, dy = q.y - p.y;
            double t = fmin(fmax(((x - p.x) * dx + (y - p.y) * dy) / (dx * dx + dy * dy), 0), 1);
            *off = fmin(*off, hypot(p.x + t * dx - x, p.y + t * dy - y));
            if ((p.y <= y) != (q.y <= y) && x < p.x + (y - p.y) / dy * dx)
                inside = !inside;
        }
    return inside;
}

typedef struct tally {
    size_t regions, rings, points, seen;
    bool opened; /* the near plane opens bodies: where it cuts their faces, regions end without a line */
} tally;

/* Rings are what the header promises: in order, closed, of three corners or more, first a piece and then its holes. */
static void check_rings(const char *name, const roberts_region_list *l)
{
    size_t ring = 0;
    for (size_t i = 0; i < l->count; i++) {
        const roberts_region *r = &l->region[i];
        double sum = 0;
        if (r->first_ring != ring || r->ring_count == 0 || !(ring_area(l, ring) > 0) || !(r->z_min <= r->z_max))
            fail_msg("%s: region %zu begins with ring %zu of area %g; depths %g, %g", name, i, r->first_ring,
                     ring_area(l, r->first_ring), r->z_min, r->z_max);
        for (size_t k = 0; k < r->ring_count; k++, ring++) {
            if (l->ring_start[ring + 1] < l->ring_start[ring] + 3)
                fail_msg("%s: ring %zu has %zu corners", name, ring, l->ring_start[ring + 1] - l->ring_start[ring]);
            sum += ring_area(l, ring);
        }
        if (!(fabs(sum - r->area) <= 1e-12 * (1 + r->area)))
            fail_msg("%s: region %zu has area %.17g, its rings %.17g", name, i, r->area, sum);
        if (i > 0 && (r->solid < r[-1].solid || (r->solid == r[-1].solid && r->face <= r[-1].face)))
            fail_msg("%s: region %zu is out of order", name, i);
    }
    assert_int_equal(ring, l->ring_count);
    assert_int_equal(l->ring_start[ring], l->corner_count);
}

/* Every corner is an end of a visible segment. */
static void check_corners(const char *name, const roberts_region_list *l, const roberts_drawing *d)
{
    for (size_t c = 0; c < l->corner_count; c++) {
        double off = HUGE_VAL;
        for (size_t i = 0; i < d->count && off > 0; i++) {
            const roberts_segment *s = &d->segment[i];
            off = fmin(off, hypot(s->p0.x - l->corner[c].x, s->p0.y - l->corner[c].y));
            off = fmin(off, hypot(s->p1.x - l->corner[c].x, s->p1.y - l->corner[c].y));
        }
        if (off > 0)
            fail_msg("%s: corner %.17g, %.17g is %g from the next end", name, l->corner[c].x, l->corner[c].y, off);
    }
}

/* The middle of every side of a ring lies on a visible segment: an edge of any class or an intersection. */
static void check_borders(const char *name, const roberts_region_list *l, const roberts_drawing *d)
{
    double near = 1e-9 * hypot(d->window_max.x - d->window_min.x, d->window_max.y - d->window_min.y);
    for (size_t r = 0; r < l->ring_count; r++)
        for (size_t c = l->ring_start[r]; c < l->ring_start[r + 1]; c++) {
            roberts_vec2 p = l->corner[c], q = l->corner[c + 1 < l->ring_start[r + 1] ? c + 1 : l->ring_start[r]];
            double x = 0.5 * (p.x + q.x), y = 0.5 * (p.y + q.y), off = HUGE_VAL;
            for (size_t i = 0; i < d->count && off > near; i++)
                if (d->segment[i].state == ROBERTS_VISIBLE)
                    off = fmin(off, distance_to(&d->segment[i], x, y));
            if (off > near)
                fail_msg("%s: the border at %.17g, %.17g is %g from the next line", name, x, y, off);
        }
}

/* What regions were found of. */
typedef struct found {
    const char *name;
    const roberts_scene *scene;
    const roberts_camera *camera;
} found;

/* At random points, the face of the one region there is seen, or nothing if there is no region. */
static void check_points(const found *f, const roberts_region_list *l, const roberts_drawing *d, rng *r, tally *t)
{
    double near = 1e-7 * hypot(d->window_max.x - d->window_min.x, d->window_max.y - d->window_min.y);
    for (int n = 0; n < POINTS; n++) {
        double x = rng_between(r, d->window_min.x, d->window_max.x),
               y = rng_between(r, d->window_min.y, d->window_max.y);
        double off = HUGE_VAL;
        const roberts_region *there = NULL;
        for (size_t i = 0; i < l->count; i++)
            if (holds(l, &l->region[i], x, y, &off)) {
                if (there)
                    fail_msg("%s: %.17g, %.17g lies in faces %u and %u", f->name, x, y, there->face, l->region[i].face);
                there = &l->region[i];
            }
        if (off <= near)
            continue;
        roberts_picked picked;
        assert_int_equal(roberts_pick(f->scene, f->camera, x, y, &picked, NULL), ROBERTS_OK);
        if (picked.count == 0 ? there != NULL
                              : !there || there->face != picked.hit[0].face || there->solid != picked.hit[0].solid)
            fail_msg("%s: at %.17g, %.17g the region is of face %ld, but face %ld is seen", f->name, x, y,
                     there ? (long)there->face : -1L, picked.count ? (long)picked.hit[0].face : -1L);
        t->points++;
        t->seen += picked.count > 0;
        roberts_picked_free(&picked);
    }
}

static bool is_same_segment(const roberts_segment *a, const roberts_segment *b)
{
    return a->solid == b->solid && a->edge == b->edge && a->v0 == b->v0 && a->v1 == b->v1 && a->by == b->by &&
           a->t0 == b->t0 && a->t1 == b->t1 && a->p0.x == b->p0.x && a->p0.y == b->p0.y && a->p1.x == b->p1.x &&
           a->p1.y == b->p1.y && a->state == b->state && a->line == b->line;
}

/* roberts_hide_with_regions() gives the segments of roberts_hide(), and the regions of roberts_regions(), whichever
 * lines are drawn. */
static void check_both(const char *name, const roberts_scene *scene, const roberts_camera *camera, size_t turn)
{
    roberts_hide_options options = roberts_hide_options_default();
    roberts_region_list l, both;
    roberts_drawing d, with;
    options.crease_auto = turn % 3 == 0;
    options.crease_degrees = turn % 3 == 1 ? 100 : 0.1;
    options.all_edges = turn % 3 == 2;
    options.keep_hidden = turn % 5 == 4;
    options.unite = turn % 7 == 6;
    options.slopes = turn % 2;
    assert_int_equal(roberts_hide(scene, camera, &options, &d, NULL), ROBERTS_OK);
    assert_int_equal(roberts_regions(scene, camera, &options, &l, NULL), ROBERTS_OK);
    assert_int_equal(roberts_hide_with_regions(scene, camera, &options, &with, &both, NULL), ROBERTS_OK);
    if (with.count != d.count || with.surviving_edges != d.surviving_edges || with.drawn_edges != d.drawn_edges)
        fail_msg("%s: %zu segments with regions, %zu without", name, with.count, d.count);
    for (size_t i = 0; i < d.count; i++)
        if (!is_same_segment(&d.segment[i], &with.segment[i]))
            fail_msg("%s: segment %zu differs with regions", name, i);
    if (both.count != l.count || both.ring_count != l.ring_count || both.corner_count != l.corner_count)
        fail_msg("%s: %zu regions of %zu rings and %zu corners with the lines, %zu of %zu and %zu alone", name,
                 both.count, both.ring_count, both.corner_count, l.count, l.ring_count, l.corner_count);
    assert_true(!l.slope == !options.slopes && !both.slope == !options.slopes);
    for (size_t i = 0; i < l.count; i++)
        if (both.region[i].solid != l.region[i].solid || both.region[i].face != l.region[i].face)
            fail_msg("%s: region %zu is of another face with the lines", name, i);
    for (size_t i = 0; i < l.corner_count; i++)
        if (hypot(both.corner[i].x - l.corner[i].x, both.corner[i].y - l.corner[i].y) > 1e-12)
            fail_msg("%s: corner %zu differs with the lines", name, i);
    roberts_drawing_free(&d);
    roberts_drawing_free(&with);
    roberts_regions_free(&l);
    roberts_regions_free(&both);
}

/* All checks but that of the shadow. Returns the sum of all areas. crossings: lines may cross where faces touch. */
static double check_scene(const char *name, const roberts_scene *scene, const roberts_camera *camera, bool crossings,
                          rng *r, tally *t)
{
    roberts_region_list l;
    roberts_error error = {0};
    roberts_hide_options options = roberts_hide_options_default();
    options.all_edges = true;
    if (roberts_regions(scene, camera, NULL, &l, &error) != ROBERTS_OK)
        fail_msg("%s: %s", name, error.message);
    roberts_drawing d = drawing_of(scene, camera, &options);
    double sum = 0;
    for (size_t i = 0; i < l.count; i++)
        sum += l.region[i].area;
    check_rings(name, &l);
    if (!crossings)
        check_corners(name, &l, &d);
    if (!t->opened)
        check_borders(name, &l, &d);
    check_points(&(found){name, scene, camera}, &l, &d, r, t);
    check_both(name, scene, camera, t->regions);
    t->regions += l.count;
    t->rings += l.ring_count;
    roberts_drawing_free(&d);
    roberts_regions_free(&l);
    return sum;
}

/* Faces that are all seen edge-on have a shadow of 0, which strips measure as up to this: coordinates are below 10. */
static const double SHADOW_ROUNDING = 1e-14;

static const roberts_camera from_above = {.dir = {0, 0, 1}, .up = {0, 1, 0}};

static void test_random_scenes(void **state)
{
    rng r = {20261123};
    const char *wanted = getenv("REGIONS");
    const size_t kinds = sizeof families / sizeof families[0];
    const size_t least = wanted ? strtoull(wanted, NULL, 10) / kinds : 0; /* regions of each family */
    (void)state;
    for (size_t f = 0; f < kinds; f++) {
        tally t = {0};
        for (int n = 0; n < SCENES || t.regions < least; n++) {
            roberts_mesh mesh = {0};
            char name[100];
            families[f].make(&r, &mesh);
            roberts_scene *scene = scene_of_mesh(&mesh, NULL);
            const double heights[] = {0, 40, 15};
            for (size_t v = 0; v < sizeof heights / sizeof heights[0]; v++) {
                roberts_camera camera = from_above;
                if (heights[v] > 0)
                    camera = (roberts_camera){.projection = ROBERTS_PERSPECTIVE,
                                              .eye = {0, 0, heights[v]},
                                              .has_look_at = true,
                                              .up = {0, 1, 0}};
                snprintf(name, sizeof name, "%s, scene %d, view %zu", families[f].name, n, v);
                double area = check_scene(name, scene, &camera, f != 0 && f != 3, &r, &t);
                double all = shadow_of(&mesh, heights[v]);
                if (!(fabs(area - all) <= 1e-9 * all + SHADOW_ROUNDING))
                    fail_msg("%s: the regions have area %.17g, their shadow %.17g", name, area, all);
            }
            snprintf(name, sizeof name, "%s, scene %d, aslant", families[f].name, n);
            check_scene(name, scene, &(roberts_camera){.dir = rng_vec3(&r, 1)}, f != 0 && f != 3, &r, &t);
            snprintf(name, sizeof name, "%s, scene %d, along a diagonal", families[f].name, n);
            check_scene(name, scene, &(roberts_camera){.dir = {1, 1, 1}}, true, &r, &t);
            roberts_scene_free(scene);
            roberts_mesh_free(&mesh);
        }
        print_message("note: %s: %zu regions of %zu rings; %zu points, %zu on faces\n", families[f].name, t.regions,
                      t.rings, t.points, t.seen);
        assert_true(t.regions > SCENES && t.points > SCENES && t.seen > SCENES / 2);
    }
}

/* Adds what is seen of each face, times `way`. */
static void add_areas(const roberts_scene *scene, double epsilon, double way, double area[12])
{
    roberts_region_list l;
    roberts_hide_options options = roberts_hide_options_default();
    options.epsilon = epsilon;
    assert_int_equal(roberts_regions(scene, &from_above, &options, &l, NULL), ROBERTS_OK);
    for (size_t i = 0; i < l.count; i++)
        area[l.region[i].face] += way * l.region[i].area;
    roberts_regions_free(&l);
}

/* A box on another, both turned and then rounded, as in files of few digits: what should touch misses by some units of
 * the last digit. Nearly always the areas are then as right as with a touching distance of some such units. (In the
 * other cases, rounding hides which of two faces is in front, and a line is missing.) */
static void test_rounded(void **state)
{
    rng r = {31};
    int wrong = 0;
    (void)state;
    for (int n = 0; n < ROUNDED_SCENES; n++) {
        roberts_mesh mesh = {0};
        double area[12] = {0}, most = 0;
        const double digits = pow(10, rng_int(&r, 4, 7));
        const mat3 turn = mat3_turn(&r);
        for (int z = 0; z < 2; z++)
            mesh_block(&mesh, (roberts_vec3){z * rng_int(&r, -1, 1), z * rng_int(&r, -1, 1), z},
                       (roberts_vec3){rng_int(&r, 2, 3), 0, 0}, (roberts_vec3){0, 2, 0}, (roberts_vec3){0, 0, 1});
        for (size_t v = 0; v < mesh.vertex_count; v++) {
            roberts_vec3 p = mat3_map(turn, mesh.vertex[v]);
            mesh.vertex[v] = (roberts_vec3){round(p.x * digits) / digits, round(p.y * digits) / digits,
                                            round(p.z * digits) / digits};
        }
        roberts_scene *scene = scene_of_mesh(&mesh, NULL);
        add_areas(scene, 0, 1, area);
        add_areas(scene, 4 / digits, -1, area);
        for (size_t f = 0; f < 12; f++)
            most = fmax(most, fabs(area[f]));
        wrong += most > 300 / digits;
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
    print_message("note: stacked boxes, rounded: %d of %d scenes have wrong regions\n", wrong, ROUNDED_SCENES);
    assert_true(wrong < ROUNDED_SCENES / 30);
}

/* A large box with one corner far off its place, which a great tolerance allows, takes nothing from a small one. */
static void test_bent_neighbour(void **state)
{
    const roberts_scene_options options = {.tolerance = 0.01};
    roberts_mesh mesh = {0};
    roberts_region_list l;
    size_t small = 0;
    (void)state;
    mesh_box(&mesh, (roberts_vec3){0, 0, 0}, (roberts_vec3){100, 100, 100});
    for (size_t v = 0; v < mesh.vertex_count; v++)
        if (mesh.vertex[v].x + mesh.vertex[v].y + mesh.vertex[v].z == 300)
            mesh.vertex[v].z += 1;
    mesh_box(&mesh, (roberts_vec3){110, 0, 0}, (roberts_vec3){111, 1, 1});
    roberts_scene *scene = scene_of_mesh(&mesh, &options);
    const roberts_camera camera = {.dir = {1, -2, 3}};
    assert_int_equal(roberts_regions(scene, &camera, NULL, &l, NULL), ROBERTS_OK);
    for (size_t i = 0; i < l.count; i++)
        small += l.region[i].solid == 1;
    assert_int_equal(small, 3);
    roberts_regions_free(&l);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
}

/* The near plane cuts solids, and what it cuts is seen. */
/* A prism whose coordinates are rounded, before a square. Its outline bends inward by the rounding, so its hull hides
 * the square's border, which ends beside the outline. Still, the square is seen round the prism. */
static void test_bent_outline(void **state)
{
    roberts_scene *scene =
        scene_of_text("OFF\n14 17 0\n0 0 1.5\n-0.40679 -0.08667 1.2225\n-0.81359 -0.17334 0.945\n"
                      "-0.98235 -1.01638 1.4557\n-0.16877 -0.84303 2.0107\n-0.55641 0.50917 2.15663\n"
                      "-0.9632 0.42249 1.87912\n-1.37 0.33582 1.60162\n-1.53877 -0.50721 2.11232\n"
                      "-0.72518 -0.33387 2.66733\n-0.738 -3.931 -1\n5.262 -3.931 -1\n5.262 2.069 -1\n"
                      "-0.738 2.069 -1\n3 0 4 3\n3 3 2 1\n3 1 0 3\n3 6 7 8\n3 6 8 9\n3 9 5 6\n3 0 1 6\n3 6 5 0\n"
                      "3 7 6 1\n3 1 2 7\n3 8 7 2\n3 2 3 8\n3 8 3 4\n3 4 9 8\n3 4 0 5\n3 5 9 4\n4 10 11 12 13\n");
    const roberts_vec3 dirs[] = {{0.098, 0.071, 2.021}, {0.3, -0.2, 1.3}, {-0.4, 0.5, 0.9}, {0.61, 0.13, 1.7}};
    (void)state;
    for (size_t i = 0; i < sizeof dirs / sizeof dirs[0]; i++) {
        const roberts_camera camera = {.dir = dirs[i]};
        const roberts_hide_options options = roberts_hide_options_default();
        roberts_region_list regions;
        double area = 0.0;
        assert_int_equal(roberts_regions(scene, &camera, &options, &regions, NULL), ROBERTS_OK);
        for (size_t k = 0; k < regions.count; k++)
            area += regions.region[k].face == 16 ? regions.region[k].area : 0.0;
        assert_in_range(area, 12, 36); /* of 36, seen aslant */
        roberts_regions_free(&regions);
    }
    roberts_scene_free(scene);
}

static void test_near_plane(void **state)
{
    rng r = {7};
    tally t = {0};
    (void)state;
    for (int n = 0; n < 120; n++) {
        roberts_mesh mesh = {0};
        char name[100];
        for (int i = 0; i < 12; i++) {
            roberts_vec3 u = rng_vec3(&r, 0.5), v = rng_vec3(&r, 0.5), w = rng_vec3(&r, 0.5);
            roberts_vec3 at = rng_vec3(&r, 3);
            at.x += at.x < 0 ? -2 : 2; /* none holds the eye */
            mesh_block(&mesh, at, u, v, w);
        }
        roberts_scene *scene = build_scene(&mesh);
        roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE,
                                 .eye = {0, 0, 0},
                                 .look_at = {4, rng_between(&r, -1, 1), rng_between(&r, -1, 1)},
                                 .has_look_at = true,
                                 .near_distance = 0.5};
        snprintf(name, sizeof name, "near plane, scene %d", n);
        check_scene(name, scene, &camera, true, &r, &t);
        roberts_scene_free(scene);
    }
    print_message("note: near plane: %zu regions of %zu rings; %zu points, %zu on faces\n", t.regions, t.rings,
                  t.points, t.seen);
    assert_true(t.regions > 200 && t.seen > 40);
}

/* A prism over a frame: eight sides round, four round the hole, and above and below faces with a slit to the hole; or
 * over a letter L. */
static void add_prism(rng *r, bool is_frame, roberts_mesh *mesh)
{
    static const double l[6][2] = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    static const double frame[8][2] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}};
    static const uint32_t slit[10] = {0, 1, 2, 3, 0, 4, 7, 6, 5, 4};
    const uint32_t count = is_frame ? 8 : 6, first = (uint32_t)mesh->vertex_count;
    const roberts_vec3 u = rng_vec3(r, 1), v = rng_vec3(r, 1), w = rng_vec3(r, 2), at = rng_vec3(r, 3);
    uint32_t below[10], above[10], corners = is_frame ? 10 : 6;
    for (uint32_t i = 0; i < 2 * count; i++) {
        const double *p = is_frame ? frame[i % count] : l[i % count], h = i < count ? 0 : 1;
        roberts_vec3 P = {at.x + p[0] * u.x + p[1] * v.x + h * w.x, at.y + p[0] * u.y + p[1] * v.y + h * w.y,
                          at.z + p[0] * u.z + p[1] * v.z + h * w.z};
        mesh_vertex(mesh, P);
    }
    for (uint32_t k = 0; k < corners; k++) {
        uint32_t i = is_frame ? slit[k] : k;
        below[corners - 1 - k] = first + i;
        above[k] = first + count + i;
    }
    mesh_face(mesh, below, corners);
    mesh_face(mesh, above, corners);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t next = is_frame ? i / 4 * 4 + (i + 1) % 4 : (i + 1) % 6;
        const uint32_t side[4] = {first + i, first + next, first + count + next, first + count + i};
        mesh_face(mesh, side, 4);
    }
}

/* The same with bodies that are not convex: closed ones get caps, open ones do not. */
static void test_near_plane_not_convex(void **state)
{
    enum { SOLID_LS, FRAMES, SOUPS, BOXES_TOO, KINDS };
    rng r = {11};
    tally t = {.opened = true};
    size_t inside = 0;
    (void)state;
    for (int n = 0; n < 400; n++) {
        roberts_mesh mesh = {0};
        char name[100];
        for (int i = rng_int(&r, 1, 5); i > 0; i--)
            switch (n % KINDS) {
            case SOUPS:
                mesh_triangle(&mesh, rng_vec3(&r, 4), rng_vec3(&r, 4), rng_vec3(&r, 4));
                break;
            case BOXES_TOO:
                mesh_block(&mesh, rng_vec3(&r, 3), rng_vec3(&r, 2), rng_vec3(&r, 2), rng_vec3(&r, 2));
                add_prism(&r, i % 2, &mesh);
                break;
            default:
                add_prism(&r, n % KINDS == FRAMES, &mesh);
            }
        roberts_scene *scene = build_scene(&mesh);
        roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE,
                                 .eye = {rng_between(&r, -1, 1), rng_between(&r, -1, 1), 3},
                                 .look_at = rng_vec3(&r, 1),
                                 .has_look_at = true,
                                 .near_distance = rng_between(&r, 0.5, 3)};
        snprintf(name, sizeof name, "near plane, bodies that are not convex, scene %d", n);
        roberts_region_list l;
        roberts_status status = roberts_regions(scene, &camera, NULL, &l, NULL);
        roberts_regions_free(&l);
        if (status == ROBERTS_OK)
            check_scene(name, scene, &camera, true, &r, &t);
        else
            inside++;
        roberts_scene_free(scene);
    }
    print_message("note: near plane, not convex: %zu regions of %zu rings; %zu points, %zu on faces; %zu eyes inside\n",
                  t.regions, t.rings, t.points, t.seen, inside);
    assert_true(t.regions > 400 && t.seen > 200);
}

/* By hand: a small square in front of the middle of a large one leaves a hole in it. */
static void test_hole(void **state)
{
    roberts_mesh mesh = {0};
    roberts_region_list l;
    (void)state;
    mesh_box(&mesh, (roberts_vec3){0, 0, 0}, (roberts_vec3){4, 4, 1});
    mesh_box(&mesh, (roberts_vec3){1, 1, 2}, (roberts_vec3){3, 3, 3});
    roberts_scene *scene = build_scene(&mesh);
    assert_int_equal(roberts_regions(scene, &from_above, NULL, &l, NULL), ROBERTS_OK);
    assert_int_equal(l.count, 2);
    assert_int_equal(l.region[0].solid, 0);
    assert_int_equal(l.region[0].face, 1);
    assert_int_equal(l.region[0].ring_count, 2);
    assert_true(l.region[0].area == 12 && ring_area(&l, 0) == 16 && ring_area(&l, 1) == -4);
    assert_true(l.region[0].z_min == -0.5 && l.region[0].z_max == -0.5);
    assert_int_equal(l.region[1].solid, 1);
    assert_int_equal(l.region[1].face, 7);
    assert_true(l.region[1].area == 4 && l.region[1].z_max == 1.5);
    assert_true(l.corner[0].x == -2 && l.corner[0].y == -2);
    roberts_regions_free(&l);
    roberts_scene_free(scene);
}

/* A face of two columns of corners, from above: planar with a notch, or bent at random. */
static void add_strip(rng *r, roberts_mesh *mesh, bool bent)
{
    enum { ROWS = 6 };
    uint32_t corner[2 * ROWS];
    for (int side = 0; side < 2; side++)
        for (int k = 0; k < ROWS; k++) {
            const int row = side ? ROWS - 1 - k : k;
            const double x = (side ? 2.0 : 0.0) + (bent ? 0.0 : rng_between(r, -0.9, 0.9)), y = row;
            const double z = bent ? rng_between(r, -2, 2) : 0.3 * x - 0.8 * y;
            corner[side * ROWS + k] = mesh_vertex(mesh, (roberts_vec3){x, y, z});
        }
    mesh_face(mesh, corner, 2 * ROWS);
}

/* Do the depths of a region hold those of rays just inside its sides, and do some rays come near to both ends? */
static void check_depths(const roberts_scene *scene, const roberts_camera *camera, const roberts_region_list *l,
                         const roberts_region *own)
{
    enum { STEPS = 60 };
    const double aside = 1e-7, exact = 1e-6, near = 0.15; /* `near`: a step along the steepest side */
    double low = INFINITY, high = -INFINITY;
    for (size_t ring = own->first_ring; ring < own->first_ring + own->ring_count; ring++)
        for (size_t k = l->ring_start[ring]; k < l->ring_start[ring + 1]; k++) {
            const roberts_vec2 P = l->corner[k];
            const roberts_vec2 Q = l->corner[k + 1 < l->ring_start[ring + 1] ? k + 1 : l->ring_start[ring]];
            const double length = hypot(Q.x - P.x, Q.y - P.y);
            for (int i = 0; i < STEPS && length > 1e-5; i++) {
                const double t = (i + 0.5) / STEPS;
                roberts_picked picked;
                assert_int_equal(roberts_pick(scene, camera, P.x + t * (Q.x - P.x) - aside * (Q.y - P.y) / length,
                                              P.y + t * (Q.y - P.y) + aside * (Q.x - P.x) / length, &picked, NULL),
                                 ROBERTS_OK);
                if (picked.count > 0 && picked.hit[0].face == own->face) {
                    low = fmin(low, picked.hit[0].depth);
                    high = fmax(high, picked.hit[0].depth);
                }
                roberts_picked_free(&picked);
            }
        }
    if (!(own->z_min <= low + exact && own->z_max >= high - exact && own->z_min >= low - near &&
          own->z_max <= high + near))
        fail_msg("face %u: depths %.9g .. %.9g, rays %.9g .. %.9g", own->face, own->z_min, own->z_max, low, high);
}

/* The normal of a face that is not planar is that of Newell's method, whichever corner comes first. */
static void test_normal_of_a_bent_face(void **state)
{
    static const roberts_vec3 P[4] = {{0, -1, 0}, {0, 1, 0}, {1, 1, 0.3}, {1, -1, -0.5}};
    const roberts_camera camera = {.dir = {0, 0, 1}, .up = {0, 1, 0}};
    roberts_vec3 sum = {0, 0, 0};
    (void)state;
    for (int i = 0; i < 4; i++)
        sum = vec3_sub(sum, vec3_cross(P[i], P[(i + 1) % 4]));
    sum = vec3_scale(1.0 / vec3_length(sum), sum);
    for (int first = 0; first < 4; first++) {
        roberts_mesh mesh = {0};
        roberts_region_list l;
        uint32_t corner[4];
        for (int i = 0; i < 4; i++)
            corner[i] = mesh_vertex(&mesh, P[(first + i) % 4]);
        mesh_face(&mesh, corner, 4);
        roberts_scene *scene = build_scene(&mesh);
        assert_int_equal(roberts_regions(scene, &camera, NULL, &l, NULL), ROBERTS_OK);
        assert_true(l.count > 0);
        for (size_t i = 0; i < l.count; i++)
            assert_true(vec3_length(vec3_sub(l.region[i].normal, sum)) < 1e-12);
        roberts_regions_free(&l);
        roberts_scene_free(scene);
    }
}

/* Faces of several pieces, partly behind boxes: the depths are those of the pieces that are seen. Seen aslant, a face
 * that is not planar lies partly behind itself. */
static void test_depths_of_pieces(void **state)
{
    rng r = {2611};
    size_t faces = 0;
    (void)state;
    for (int scenes = 0; scenes < 60; scenes++) {
        const roberts_camera camera = {.dir = {0, scenes % 4 < 2 ? 0 : 2, 1}, .up = {0, 0, 1}};
        roberts_mesh mesh = {0};
        roberts_region_list l;
        add_strip(&r, &mesh, scenes % 2);
        for (int i = rng_int(&r, 0, 3); i > 0; i--)
            mesh_block(&mesh, (roberts_vec3){rng_between(&r, -1, 2), rng_between(&r, 0, 5), 6.0 + i},
                       (roberts_vec3){rng_between(&r, 0.5, 3), 0.2, 0}, (roberts_vec3){-0.1, 1, 0},
                       (roberts_vec3){0, 0, 0.5});
        roberts_scene *scene = build_scene(&mesh);
        assert_int_equal(roberts_regions(scene, &camera, NULL, &l, NULL), ROBERTS_OK);
        for (size_t i = 0; i < l.count; i++) {
            check_depths(scene, &camera, &l, &l.region[i]);
            faces += l.region[i].face == 0;
        }
        roberts_regions_free(&l);
        roberts_scene_free(scene);
    }
    assert_true(faces >= 55);
}

/* By hand: a strip of four squares, the last of them red, and beside it two blocks that are flush with one another. */
static void test_merged(void **state)
{
    const char *strip = "OFF\n10 4 0\n0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n3 0 0\n3 1 0\n4 0 0\n4 1 0\n"
                        "4 0 2 3 1\n4 2 4 5 3\n4 4 6 7 5\n4 6 8 9 7 1 0 0\n";
    roberts_mesh mesh = mesh_of_text(strip);
    roberts_region_list l;
    (void)state;
    mesh_box(&mesh, (roberts_vec3){5, 0, -1}, (roberts_vec3){6, 1, 0});
    mesh_box(&mesh, (roberts_vec3){6, 0, -1}, (roberts_vec3){7, 1, 0});
    roberts_scene *scene = build_scene(&mesh);
    for (int n = 0; n < 3; n++) {
        roberts_hide_options options = roberts_hide_options_default();
        options.merge_regions = n > 0;
        options.unite = n == 2;
        assert_int_equal(roberts_regions(scene, &from_above, &options, &l, NULL), ROBERTS_OK);
        assert_int_equal(l.count, n == 0 ? 6 : n == 1 ? 4 : 3);
        if (n > 0) {
            assert_true(l.region[0].face == 0 && l.region[0].area == 3 && l.region[0].ring_count == 1);
            assert_true(l.region[1].face == 3 && l.region[1].area == 1 && l.region[1].color.count == 3);
            assert_true(l.region[2].solid == 1 && l.region[2].area == (n == 2 ? 2 : 1));
        }
        roberts_regions_free(&l);
    }
    roberts_scene_free(scene);
    /* a bent face, and one in the plane of half of it */
    mesh = mesh_of_text("OFF\n6 2 0\n1 0 4\n1 2 3\n3 2 3\n3 0 3\n1 1 3\n3 1 3\n4 0 4 5 3\n4 4 1 2 5\n");
    scene = build_scene(&mesh);
    roberts_hide_options options = roberts_hide_options_default();
    options.merge_regions = true;
    assert_int_equal(roberts_regions(scene, &from_above, &options, &l, NULL), ROBERTS_OK);
    assert_int_equal(l.count, 2);
    roberts_regions_free(&l);
    roberts_scene_free(scene);
}

static bool same_regions(const roberts_region_list *a, const roberts_region_list *b)
{
    if (a->count != b->count || a->ring_count != b->ring_count || a->corner_count != b->corner_count)
        return false;
    for (size_t i = 0; i < a->count; i++)
        if (a->region[i].face != b->region[i].face || a->region[i].area != b->region[i].area ||
            a->region[i].z_min != b->region[i].z_min || a->region[i].z_max != b->region[i].z_max)
            return false;
    return !memcmp(a->corner, b->corner, a->corner_count * sizeof *a->corner) &&
           !memcmp(a->ring_start, b->ring_start, a->ring_count * sizeof *a->ring_start);
}

/* Neither threads nor grid change a bit. */
static void test_threads_and_grid(void **state)
{
    rng r = {99};
    roberts_mesh mesh = {0};
    (void)state;
    for (int i = 0; i < 400; i++)
        mesh_block(&mesh, rng_vec3(&r, 20), rng_vec3(&r, 2), rng_vec3(&r, 2), rng_vec3(&r, 2));
    roberts_scene *scene = build_scene(&mesh);
    roberts_region_list first = {0};
    const uint32_t grids[] = {0, 1, 7, 0}, threads[] = {1, 3, 1, 5};
    for (size_t i = 0; i < 4; i++) {
        roberts_region_list l;
        roberts_hide_options options = roberts_hide_options_default();
        options.grid = grids[i];
        options.threads = threads[i];
        assert_int_equal(roberts_regions(scene, &from_above, &options, &l, NULL), ROBERTS_OK);
        if (i == 0)
            first = l;
        else if (!same_regions(&first, &l))
            fail_msg("grid %u, %u threads: other regions", grids[i], threads[i]);
        if (i > 0)
            roberts_regions_free(&l);
    }
    assert_true(first.count > 200);
    roberts_regions_free(&first);
    roberts_scene_free(scene);
}

/* Impossible requests give errors. */
static void test_refused(void **state)
{
    roberts_mesh mesh = {0};
    roberts_region_list l;
    roberts_error error = {0};
    (void)state;
    mesh_triangle(&mesh, (roberts_vec3){-1, -1, 0}, (roberts_vec3){9, -1, 0}, (roberts_vec3){-1, 9, 0});
    roberts_scene *scene = build_scene(&mesh);
    roberts_camera camera = {
        .projection = ROBERTS_PERSPECTIVE, .eye = {1, 1, 1}, .look_at = {6, 1, 0.5}, .has_look_at = true};
    camera.eye = camera.look_at;
    assert_int_equal(roberts_regions(scene, &camera, NULL, &l, &error), ROBERTS_BAD_VIEW);
    assert_int_equal(l.count, 0);
    assert_int_equal(roberts_regions(scene, &(roberts_camera){0}, NULL, &l, &error), ROBERTS_BAD_VIEW);
    roberts_drawing d;
    assert_int_equal(roberts_hide_with_regions(scene, &camera, NULL, &d, &l, &error), ROBERTS_BAD_VIEW);
    assert_true(l.count == 0 && d.count == 0 && !l.region && !d.segment);
    roberts_regions_free(&l);
    roberts_regions_free(NULL);
    roberts_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_hole),
        cmocka_unit_test(test_random_scenes),
        cmocka_unit_test(test_near_plane_not_convex),
        cmocka_unit_test(test_normal_of_a_bent_face),
        cmocka_unit_test(test_depths_of_pieces),
        cmocka_unit_test(test_merged),
        cmocka_unit_test(test_rounded),
        cmocka_unit_test(test_bent_neighbour),
        cmocka_unit_test(test_bent_outline),
        cmocka_unit_test(test_near_plane),
        cmocka_unit_test(test_threads_and_grid),
        cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests_name("regions", tests, NULL, NULL);
}
