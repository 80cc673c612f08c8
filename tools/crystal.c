/* crystal.c - writes a crystal as OFF, from its cell, its class and its forms.
 *
 *     crystal FILE [NAMES.csv] >crystal.off
 *
 * NAMES.csv receives the Miller indices of each face, as roberts --labels reads them; in the OFF they are comments.
 *
 * FILE has lines of words; a # begins a comment:
 *
 *     cell 4.913 4.913 5.405 90 90 120    the lengths a b c (any unit) and the angles alpha beta gamma (degrees)
 *     class 32                            one of the 32 crystal classes, by its international symbol
 *     form 1 0 1 5                        h k l (or h k i l) of a face, and its distance from the centre (any unit)
 *     form 1 1 1 5.2 200 80 0             the same with a colour
 *
 * A form is the set of faces that the class makes of one face. The crystal is the region behind the faces of all forms.
 * The axis c points up, and b lies in the plane of y and z. Classes are in the standard settings of the International
 * Tables for Crystallography, volume A: unique axis b, hexagonal axes for trigonal classes. */
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/vec.h"
#include "roberts.h"

enum { OPERATIONS_MAX = 48, PLANES_MAX = 600, CORNERS_MAX = 4 * PLANES_MAX, GENERATORS_MAX = 3 };

/* Corners are this near to a face that they lie on, as a part of the largest distance of a face. */
static const double slack = 1e-9;

static const double degree = 3.14159265358979323846 / 180.0;

static struct {
    const char *name;
    size_t line;
} input;

static _Noreturn void fail(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "crystal: %s:%zu: ", input.name, input.line);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(1);
}

/* ---- symmetry -------------------------------------------------------------------------------------------------- */

/* A symmetry operation on coordinates along the axes of the cell. */
typedef struct operation {
    int m[3][3];
} operation;

typedef struct group {
    operation item[OPERATIONS_MAX];
    size_t count;
} group;

/* The generators of the classes, by letters. */
static const struct {
    char letter;
    operation by;
} generators[] = {
    {'i', {{{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}}, /* the inversion */
    {'z', {{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}},  /* 2 along c */
    {'y', {{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}},  /* 2 along b */
    {'x', {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}},  /* 2 along a */
    {'m', {{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}},   /* m across b */
    {'n', {{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},   /* m across a */
    {'4', {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}},   /* 4 along c */
    {'f', {{{0, 1, 0}, {-1, 0, 0}, {0, 0, -1}}}},  /* -4 along c */
    {'d', {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}}},    /* 3 along [111] */
    {'3', {{{0, -1, 0}, {1, -1, 0}, {0, 0, 1}}}},  /* 3 along c; this and the rest: hexagonal axes */
    {'6', {{{1, -1, 0}, {1, 0, 0}, {0, 0, 1}}}},   /* 6 along c */
    {'s', {{{-1, 1, 0}, {-1, 0, 0}, {0, 0, -1}}}}, /* -6 along c */
    {'a', {{{1, -1, 0}, {0, -1, 0}, {0, 0, -1}}}}, /* 2 along [100] */
    {'b', {{{0, -1, 0}, {-1, 0, 0}, {0, 0, -1}}}}, /* 2 along [1-10] */
    {'p', {{{-1, 1, 0}, {0, 1, 0}, {0, 0, 1}}}},   /* m across [100] */
    {'q', {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}},    /* m across [1-10] */
};

/* Systems differ in what they require of the cell. */
typedef enum crystal_system { TRICLINIC, MONOCLINIC, ORTHORHOMBIC, TETRAGONAL, HEXAGONAL, CUBIC } crystal_system;

static const struct {
    const char *symbol, *generators;
    crystal_system system;
    size_t order; /* the number of its operations */
} classes[] = {
    {"1", "", TRICLINIC, 1},          {"-1", "i", TRICLINIC, 2},       {"2", "y", MONOCLINIC, 2},
    {"m", "m", MONOCLINIC, 2},        {"2/m", "yi", MONOCLINIC, 4},    {"222", "zy", ORTHORHOMBIC, 4},
    {"mm2", "zm", ORTHORHOMBIC, 4},   {"mmm", "zyi", ORTHORHOMBIC, 8}, {"4", "4", TETRAGONAL, 4},
    {"-4", "f", TETRAGONAL, 4},       {"4/m", "4i", TETRAGONAL, 8},    {"422", "4x", TETRAGONAL, 8},
    {"4mm", "4n", TETRAGONAL, 8},     {"-42m", "fx", TETRAGONAL, 8},   {"-4m2", "fn", TETRAGONAL, 8},
    {"4/mmm", "4xi", TETRAGONAL, 16}, {"3", "3", HEXAGONAL, 3},        {"-3", "3i", HEXAGONAL, 6},
    {"32", "3a", HEXAGONAL, 6},       {"321", "3a", HEXAGONAL, 6},     {"312", "3b", HEXAGONAL, 6},
    {"3m", "3p", HEXAGONAL, 6},       {"3m1", "3p", HEXAGONAL, 6},     {"31m", "3q", HEXAGONAL, 6},
    {"-3m", "3ai", HEXAGONAL, 12},    {"-3m1", "3ai", HEXAGONAL, 12},  {"-31m", "3bi", HEXAGONAL, 12},
    {"6", "6", HEXAGONAL, 6},         {"-6", "s", HEXAGONAL, 6},       {"6/m", "6i", HEXAGONAL, 12},
    {"622", "6a", HEXAGONAL, 12},     {"6mm", "6p", HEXAGONAL, 12},    {"-6m2", "sp", HEXAGONAL, 12},
    {"-62m", "sa", HEXAGONAL, 12},    {"6/mmm", "6ai", HEXAGONAL, 24}, {"23", "zd", CUBIC, 12},
    {"m-3", "zdi", CUBIC, 24},        {"432", "4d", CUBIC, 24},        {"-43m", "fd", CUBIC, 24},
    {"m-3m", "4di", CUBIC, 48},
};

enum { CLASSES = sizeof classes / sizeof classes[0], LETTERS = sizeof generators / sizeof generators[0] };

static operation product(const operation *a, const operation *b)
{
    operation c = {0};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                c.m[i][j] += a->m[i][k] * b->m[k][j];
    return c;
}

static void add_operation(group *g, operation new)
{
    for (size_t i = 0; i < g->count; i++)
        if (memcmp(&g->item[i], &new, sizeof new) == 0)
            return;
    if (g->count == OPERATIONS_MAX)
        abort(); /* no crystal class has more */
    g->item[g->count++] = new;
}

/* All products of the generators: each operation, multiplied by each generator, is one of the group. */
static group make_group(size_t class)
{
    group g = {.item = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}, .count = 1};
    for (size_t i = 0; i < g.count; i++)
        for (const char *letter = classes[class].generators; *letter; letter++)
            for (size_t k = 0; k < LETTERS; k++)
                if (generators[k].letter == *letter)
                    add_operation(&g, product(&g.item[i], &generators[k].by));
    if (g.count != classes[class].order)
        abort();
    return g;
}

/* ---- the cell -------------------------------------------------------------------------------------------------- */

/* The reciprocal axes a*, b*, c*, to any scale: face (hkl) has the normal h a* + k b* + l c*. */
typedef struct cell {
    double length[3], angle[3]; /* degrees */
    roberts_vec3 reciprocal[3];
} cell;

static void set_axes(cell *c)
{
    const double cos_a = cos(c->angle[0] * degree), cos_b = cos(c->angle[1] * degree),
                 cos_c = cos(c->angle[2] * degree), sin_a = sin(c->angle[0] * degree);
    const double y = (cos_c - cos_a * cos_b) / sin_a, x2 = 1.0 - cos_b * cos_b - y * y;
    if (!(x2 > 0.0))
        fail("no cell has these angles");
    const roberts_vec3 a = vec3_scale(c->length[0], (roberts_vec3){sqrt(x2), y, cos_b});
    const roberts_vec3 b = vec3_scale(c->length[1], (roberts_vec3){0.0, sin_a, cos_a});
    const roberts_vec3 up = {0.0, 0.0, c->length[2]};
    const double volume = vec3_dot(vec3_cross(a, b), up);
    c->reciprocal[0] = vec3_scale(1.0 / volume, vec3_cross(b, up));
    c->reciprocal[1] = vec3_scale(1.0 / volume, vec3_cross(up, a));
    c->reciprocal[2] = vec3_scale(1.0 / volume, vec3_cross(a, b));
}

/* Does the cell have the shape that the system requires? */
static bool fits(const cell *c, crystal_system system)
{
    const double *l = c->length, *angle = c->angle;
    const bool right = angle[0] == 90.0 && angle[1] == 90.0 && angle[2] == 90.0;
    switch (system) {
    case MONOCLINIC:
        return angle[0] == 90.0 && angle[2] == 90.0;
    case ORTHORHOMBIC:
        return right;
    case TETRAGONAL:
        return right && l[0] == l[1];
    case HEXAGONAL:
        return angle[0] == 90.0 && angle[1] == 90.0 && angle[2] == 120.0 && l[0] == l[1];
    case CUBIC:
        return right && l[0] == l[1] && l[1] == l[2];
    default:
        return true;
    }
}

static const char *const wanted_cells[] = {
    [TRICLINIC] = "any cell",
    [MONOCLINIC] = "alpha = gamma = 90",
    [ORTHORHOMBIC] = "three right angles",
    [TETRAGONAL] = "a = b and three right angles",
    [HEXAGONAL] = "a = b, alpha = beta = 90 and gamma = 120",
    [CUBIC] = "a = b = c and three right angles",
};

/* ---- faces ----------------------------------------------------------------------------------------------------- */

typedef struct crystal_face {
    roberts_vec3 n; /* unit vector, outward */
    double d;       /* from the centre */
    int color[3];
    bool has_color;
    int hkl[3];
    bool has_four; /* its form was given as h k i l */
} crystal_face;

typedef struct crystal {
    crystal_face face[PLANES_MAX];
    size_t face_count;
    roberts_vec3 corner[CORNERS_MAX];
    size_t corner_count;
    size_t outside;    /* faces behind another in the same direction */
    crystal_face lost; /* the first of them */
    double size;       /* the largest distance of a face */
} crystal;

/* Adds a face. Of two in the same direction, the nearer one is kept. */
static void add_face(crystal *c, crystal_face new)
{
    for (size_t i = 0; i < c->face_count; i++)
        if (vec3_length(vec3_sub(c->face[i].n, new.n)) < slack) {
            const crystal_face old = c->face[i];
            const bool is_nearer = new.d < old.d;
            if (fabs(new.d - old.d) > slack * new.d && c->outside++ == 0)
                c->lost = is_nearer ? old : new;
            if (is_nearer)
                c->face[i] = new;
            return;
        }
    if (c->face_count == PLANES_MAX)
        fail("more than %d faces", PLANES_MAX);
    c->face[c->face_count++] = new;
    c->size = fmax(c->size, new.d);
}

/* Adds all faces of a form. `like` has its distance and colour. */
static void add_form(crystal *c, const cell *axes, const group *g, const int hkl[3], crystal_face like)
{
    roberts_vec3 done[OPERATIONS_MAX];
    size_t count = 0;
    for (size_t i = 0; i < g->count; i++) {
        roberts_vec3 n = {0.0, 0.0, 0.0};
        for (int column = 0; column < 3; column++) {
            int index = 0;
            for (int row = 0; row < 3; row++)
                index += hkl[row] * g->item[i].m[row][column];
            like.hkl[column] = index;
            n = vec3_add(n, vec3_scale(index, axes->reciprocal[column]));
        }
        like.n = vec3_scale(1.0 / vec3_length(n), n);
        size_t k = 0;
        while (k < count && vec3_length(vec3_sub(done[k], like.n)) >= slack)
            k++;
        if (k == count)
            add_face(c, like);
        done[k] = like.n;
        count += k == count;
    }
}

/* ---- the region behind all faces ------------------------------------------------------------------------------- */

static bool is_inside(const crystal *c, roberts_vec3 p)
{
    for (size_t i = 0; i < c->face_count; i++)
        if (vec3_dot(c->face[i].n, p) > c->face[i].d + slack * c->size)
            return false;
    return true;
}

static void add_corner(crystal *c, roberts_vec3 p)
{
    for (size_t i = 0; i < c->corner_count; i++)
        if (vec3_length(vec3_sub(c->corner[i], p)) < 100.0 * slack * c->size)
            return;
    if (c->corner_count == CORNERS_MAX)
        fail("more than %d corners", CORNERS_MAX);
    c->corner[c->corner_count++] = p;
}

/* The corners are the points of three planes that lie behind all others. */
static void find_corners(crystal *c)
{
    for (size_t i = 0; i < c->face_count; i++)
        for (size_t j = 0; j < i; j++) {
            const roberts_vec3 along = vec3_cross(c->face[i].n, c->face[j].n);
            for (size_t k = 0; k < j; k++) {
                const crystal_face *p = &c->face[i], *q = &c->face[j], *r = &c->face[k];
                const double volume = vec3_dot(along, r->n);
                if (fabs(volume) < slack)
                    continue;
                roberts_vec3 at = vec3_scale(p->d, vec3_cross(q->n, r->n));
                at = vec3_add(at, vec3_scale(q->d, vec3_cross(r->n, p->n)));
                at = vec3_scale(1.0 / volume, vec3_add(at, vec3_scale(r->d, along)));
                if (is_inside(c, at))
                    add_corner(c, at);
            }
        }
}

/* A corner of a face, and its direction as seen from the middle of the face. */
typedef struct turn {
    size_t corner;
    double angle;
} turn;

static int by_angle(const void *a, const void *b)
{
    const turn *p = a, *q = b;
    return (p->angle > q->angle) - (p->angle < q->angle);
}

/* Lists the corners of a face, counter-clockwise from outside. Returns their number. */
static size_t face_corners(const crystal *c, const crystal_face *face, turn list[CORNERS_MAX])
{
    size_t count = 0;
    roberts_vec3 middle = {0.0, 0.0, 0.0};
    for (size_t i = 0; i < c->corner_count; i++)
        if (fabs(vec3_dot(face->n, c->corner[i]) - face->d) < 100.0 * slack * c->size) {
            list[count++].corner = i;
            middle = vec3_add(middle, c->corner[i]);
        }
    if (count < 3)
        return 0;
    middle = vec3_scale(1.0 / (double)count, middle);
    const roberts_vec3 right = vec3_sub(c->corner[list[0].corner], middle), up = vec3_cross(face->n, right);
    for (size_t i = 0; i < count; i++) {
        const roberts_vec3 from = vec3_sub(c->corner[list[i].corner], middle);
        list[i].angle = atan2(vec3_dot(from, up), vec3_dot(from, right));
    }
    qsort(list, count, sizeof *list, by_angle);
    return count;
}

/* Counts the faces that have corners. They must enclose a region: a closed convex surface has two more faces and
 * corners than edges (Euler). An open one lacks faces, those with fewer than three corners. */
static size_t count_faces(const crystal *c)
{
    static turn list[CORNERS_MAX];
    size_t faces = 0, sides = 0;
    for (size_t i = 0; i < c->face_count; i++) {
        const size_t count = face_corners(c, &c->face[i], list);
        faces += count > 0;
        sides += count;
    }
    if (c->face_count == 0)
        fail("a line with a form expected, such as form 1 0 0 1");
    if (c->corner_count < 4 || sides % 2 != 0 || c->corner_count + faces != sides / 2 + 2)
        fail("these forms do not close; add another one");
    return faces;
}

/* The Miller indices of a face. `bars`: negative ones have bars over their digits, and no spaces stand between indices
 * that have one digit each. */
static void write_indices(const crystal_face *face, bool bars, FILE *file)
{
    const int h = face->hkl[0], k = face->hkl[1], l = face->hkl[2];
    const int all[] = {h, k, -h - k, l};
    bool few = bars;
    for (int i = 0; i < 4; i++)
        few = few && (abs(all[i]) < 10 || (i == 2 && !face->has_four));
    for (int i = 0; i < 4; i++) {
        char text[16];
        if (i == 2 && !face->has_four)
            continue;
        if (i > 0 && !few)
            putc(' ', file);
        snprintf(text, sizeof text, "%d", bars ? abs(all[i]) : all[i]);
        for (const char *digit = text; *digit; digit++) {
            putc(*digit, file);
            if (bars && all[i] < 0)
                fputs("\u0305", file); /* combining overline */
        }
    }
}

/* names: NULL, or what receives the indices of the faces. */
static void write_crystal(const crystal *c, size_t faces, FILE *names)
{
    static turn list[CORNERS_MAX];
    size_t written = 0;
    const crystal_face *lost = c->outside > 0 ? &c->lost : NULL;
    printf("OFF\n%zu %zu 0\n", c->corner_count, faces);
    for (size_t i = 0; i < c->corner_count; i++)
        printf("%.12g %.12g %.12g\n", c->corner[i].x + 0.0, c->corner[i].y + 0.0, c->corner[i].z + 0.0);
    for (size_t i = 0; i < c->face_count; i++) {
        const crystal_face *face = &c->face[i];
        const size_t count = face_corners(c, face, list);
        if (count == 0) {
            lost = lost ? lost : face;
            continue;
        }
        printf("%zu", count);
        for (size_t k = 0; k < count; k++)
            printf(" %zu", list[k].corner);
        if (face->has_color)
            printf(" %d %d %d", face->color[0], face->color[1], face->color[2]);
        fputs(" # ", stdout);
        write_indices(face, false, stdout);
        putchar('\n');
        if (names) {
            fprintf(names, "face,%zu,(", written);
            write_indices(face, true, names);
            fputs(")\n", names);
        }
        written++;
    }
    const size_t outside = c->face_count - faces + c->outside;
    if (!lost)
        return;
    fprintf(stderr, "crystal: %s: %zu face%s outside of the crystal, as (", input.name, outside,
            outside == 1 ? " lies" : "s lie");
    write_indices(lost, false, stderr);
    fputs(")\n", stderr);
}

/* ---- the input ------------------------------------------------------------------------------------------------- */

enum { NUMBERS_MAX = 8 };

/* Reads the numbers of a line. Returns how many there are. */
static int read_numbers(const char *text, double number[NUMBERS_MAX])
{
    int count = 0;
    for (;;) {
        char *end;
        text += strspn(text, " \t\r\n");
        if (!*text)
            return count;
        if (count == NUMBERS_MAX)
            fail("too many numbers");
        number[count] = strtod(text, &end);
        if (end == text || !isfinite(number[count]))
            fail("a number expected, found \"%.*s\"", (int)strcspn(text, " \t\r\n"), text);
        text = end;
        count++;
    }
}

static void read_cell(const char *text, cell *c)
{
    double n[NUMBERS_MAX] = {0.0, 0.0, 0.0, 90.0, 90.0, 90.0};
    const int count = read_numbers(text, n);
    if (count != 3 && count != 6)
        fail("cell: a b c or a b c alpha beta gamma expected");
    for (int i = 0; i < 3; i++) {
        c->length[i] = n[i];
        c->angle[i] = n[i + 3];
        if (!(n[i] > 0.0 && n[i + 3] > 0.0 && n[i + 3] < 180.0))
            fail("cell: lengths must be above 0, and angles between 0 and 180 degrees");
    }
    set_axes(c);
}

static size_t read_class(char *text)
{
    text += strspn(text, " \t");
    text[strcspn(text, " \t\r\n")] = '\0';
    for (size_t i = 0; i < CLASSES; i++)
        if (strcmp(text, classes[i].symbol) == 0)
            return i;
    fail("\"%s\" is no crystal class; examples: m-3m, 4/mmm, 6/mmm, -3m, 32, mmm, 2/m, -1", text);
}

static void read_form(const char *text, crystal *c, const cell *axes, const group *g)
{
    double n[NUMBERS_MAX];
    const int count = read_numbers(text, n);
    const bool four = count == 5 || count == 8, colored = count >= 7;
    if (count != 4 && count != 5 && count != 7 && count != 8)
        fail("form: h k l (or h k i l), a distance, and perhaps red green blue expected");
    const int hkl[3] = {(int)n[0], (int)n[1], (int)n[2 + four]};
    const double *rest = n + 3 + four;
    for (int i = 0; i < 3 + four; i++)
        if (n[i] != floor(n[i]) || fabs(n[i]) > 1000.0)
            fail("form: %g is no Miller index", n[i]);
    if (four && n[0] + n[1] + n[2] != 0.0)
        fail("form: in h k i l, h + k + i must be 0");
    if (hkl[0] == 0 && hkl[1] == 0 && hkl[2] == 0)
        fail("form: one index at least must not be 0");
    if (!(rest[0] > 0.0))
        fail("form: the distance must be above 0");
    crystal_face like = {.d = rest[0], .has_color = colored, .has_four = four};
    for (int i = 0; i < 3 && colored; i++) {
        const double part = rest[1 + i];
        if (!(part >= 0.0 && part <= 255.0 && part == floor(part)))
            fail("form: a colour has whole numbers from 0 to 255, as 200 80 0");
        like.color[i] = (int)part;
    }
    add_form(c, axes, g, hkl, like);
}

static void read_crystal(FILE *file, crystal *c)
{
    cell axes = {0};
    group g = {0};
    size_t class = CLASSES;
    char line[512];
    for (input.line = 1; fgets(line, sizeof line, file); input.line++) {
        char word[16];
        int used = 0;
        line[strcspn(line, "#")] = '\0';
        if (sscanf(line, " %15s%n", word, &used) != 1)
            continue;
        if (strcmp(word, "cell") == 0)
            read_cell(line + used, &axes);
        else if (strcmp(word, "class") == 0)
            g = make_group(class = read_class(line + used));
        else if (strcmp(word, "form") != 0)
            fail("cell, class or form expected, found \"%s\"", word);
        else if (axes.length[0] == 0.0 || class == CLASSES)
            fail("the lines of cell and class must come before the forms");
        else
            read_form(line + used, c, &axes, &g);
        if (axes.length[0] > 0.0 && class < CLASSES && !fits(&axes, classes[class].system))
            fail("class %s needs a cell with %s", classes[class].symbol, wanted_cells[classes[class].system]);
    }
}

static void print_help(void)
{
    puts("usage: crystal FILE [NAMES.csv] >crystal.off\n\n"
         "FILE (- is standard input) has lines of words; a # begins a comment:\n\n"
         "  cell 4.913 4.913 5.405 90 90 120    lengths a b c, and angles alpha beta gamma (default: 90)\n"
         "  class 32                            a crystal class\n"
         "  form 1 0 1 5                        h k l or h k i l of a face, and its distance from the centre\n"
         "  form 1 1 1 5.2 200 80 0             the same with a colour, from 0 to 255\n\n"
         "NAMES.csv receives the indices of each face, for roberts --labels NAMES.csv.\n\n"
         "Classes:");
    for (size_t i = 0; i < CLASSES; i++)
        printf("%s%s", classes[i].symbol, i + 1 == CLASSES || i % 12 == 11 ? "\n" : " ");
}

/* Tells why a file could not be opened or written. Returns the exit status. */
static int complain(const char *path)
{
    fprintf(stderr, "crystal: %s: %s\n", path, strerror(errno));
    return 1;
}

int main(int argc, char **argv)
{
    static crystal c;
    if (argc == 2 && (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)) {
        print_help();
        return fflush(stdout) != 0;
    }
    if ((argc != 2 && argc != 3) || (argv[1][0] == '-' && argv[1][1] != '\0')) {
        fputs("usage: crystal FILE [NAMES.csv] >crystal.off\ncrystal --help lists the classes.\n", stderr);
        return 2;
    }
    const bool standard = strcmp(argv[1], "-") == 0;
    FILE *file = standard ? stdin : fopen(argv[1], "r"), *names = NULL;
    input.name = standard ? "standard input" : argv[1];
    if (!file)
        return complain(argv[1]);
    read_crystal(file, &c);
    if (!standard)
        fclose(file);
    find_corners(&c);
    const size_t faces = count_faces(&c);
    if (argc == 3 && strcmp(argv[1], argv[2]) == 0)
        fail("the names would take the place of the crystal");
    if (argc == 3 && !(names = fopen(argv[2], "w")))
        return complain(argv[2]);
    write_crystal(&c, faces, names);
    bool named = !names || !ferror(names);
    named = (!names || fclose(names) == 0) && named;
    if (!named)
        return complain(argv[2]);
    return ferror(stdout) || fflush(stdout) != 0 ? complain("standard output") : 0;
}
