/* paper.c - reads lines back from SVG and PDF, and pixels from PNG.
 *
 * It reads only what Cairo and src/write/svg.c write: paths of straight lines. */
#include "paper.h"

#include <cairo.h>
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "base/array.h"
#include "read_png.h"

static const double mm_per_point = 25.4 / 72.0;

uint32_t paper_color(int line)
{
    static const uint32_t color[PAPER_CLASSES] = {
        [ROBERTS_OUTLINE] = 0xff0000, [ROBERTS_CREASE] = 0x00ff00, [ROBERTS_BACK] = 0x0000ff,
        [ROBERTS_BORDER] = 0xe0e000,  [ROBERTS_WIRE] = 0xc0c000,   [ROBERTS_INTERSECTION] = 0xd0d000,
        [PAPER_FRAME] = 0xffff00,     [PAPER_SYMBOL] = 0x00ffff,   [PAPER_HATCH] = 0xb0b000,
    };
    return color[line];
}

static void set_color(roberts_pen *pen, int line)
{
    uint32_t color = paper_color(line);
    pen->red = (unsigned char)(color >> 16);
    pen->green = (unsigned char)(color >> 8);
    pen->blue = (unsigned char)color;
}

roberts_draw_options paper_options(void)
{
    roberts_draw_options options = roberts_draw_options_default();
    set_color(&options.outline, ROBERTS_OUTLINE);
    set_color(&options.crease, ROBERTS_CREASE);
    set_color(&options.back, ROBERTS_BACK);
    set_color(&options.border, ROBERTS_BORDER);
    set_color(&options.wire, ROBERTS_WIRE);
    set_color(&options.intersection, ROBERTS_INTERSECTION);
    set_color(&options.frame, PAPER_FRAME);
    set_color(&options.symbol, PAPER_SYMBOL);
    set_color(&options.hatch, PAPER_HATCH);
    return options;
}

void paper_free(paper *p)
{
    free(p->item);
    *p = (paper){0};
}

/* ---- paths ----------------------------------------------------------------------------------------------------- */

/* A path and the position in it. */
typedef struct path {
    paper *p;
    roberts_vec2 start, at;
    int line;
    bool lifted; /* the pen, since the last line */
    bool failed;
} path;

static void move_to(path *w, roberts_vec2 to)
{
    w->start = w->at = to;
    w->lifted = true;
}

static void line_to(path *w, roberts_vec2 to)
{
    paper *p = w->p;
    p->strokes += w->lifted;
    w->lifted = false;
    w->failed = w->failed || !array_reserve(&p->item, &p->room, p->count + 1, sizeof *p->item);
    if (!w->failed)
        p->item[p->count++] = (paper_line){w->at, to, w->line, p->strokes};
    w->at = to;
}

/* ---- SVG ------------------------------------------------------------------------------------------------------- */

static int class_of_layer(const char *name)
{
    static const char *const layer[PAPER_CLASSES] = {"outline\"", "crease\"",       "hidden\"",     "border\"",
                                                     "wire\"",    "intersection\"", "frame\"",      "symbol\"",
                                                     "hatch\"",   "text\"",         "hidden-text\""};
    for (int i = 0; i < PAPER_CLASSES; i++)
        if (strncmp(name, layer[i], strlen(layer[i])) == 0)
            return i;
    return -1;
}

/* Path data up to the quotation mark: M x y, L x y and Z. */
static void read_data(path *w, const char *at)
{
    for (;;) {
        char command = *at, *end;
        at++;
        if (isspace((unsigned char)command))
            continue;
        if (command == '"')
            return;
        if (command == 'Z') {
            line_to(w, w->start);
            continue;
        }
        if (command != 'M' && command != 'L')
            break;
        roberts_vec2 to;
        to.x = strtod(at, &end);
        to.y = strtod(end, (char **)&at);
        if (at == end)
            break;
        command == 'M' ? move_to(w, to) : line_to(w, to);
    }
    w->failed = true;
}

bool paper_read_svg(paper *p, const char *bytes, size_t size)
{
    path w = {.p = p};
    *p = (paper){0};
    for (const char *at = bytes; !w.failed && (at = strstr(at, "<g id=\"")) != NULL;) {
        const char *data;
        at += strlen("<g id=\"");
        w.line = class_of_layer(at);
        data = strstr(at, " d=\"");
        w.failed = w.line < 0 || !data;
        if (!w.failed)
            read_data(&w, data + strlen(" d=\""));
    }
    return !w.failed && bytes[size] == '\0' && strstr(bytes, "</svg>");
}

/* ---- PDF ------------------------------------------------------------------------------------------------------- */

enum { STATES = 16, OPERANDS = 6 };

/* x' = a x + c y + e, y' = b x + d y + f */
typedef struct matrix {
    double a, b, c, d, e, f;
} matrix;

/* A page's content: operands, then an operator. */
typedef struct content {
    path path;
    double operand[OPERANDS];
    int operands;
    struct state {
        matrix m;
        uint32_t color;
    } state[STATES]; /* the last is in use */
    int depth;
    double height_mm;
    size_t first; /* line of the path that has not been stroked yet */
} content;

static roberts_vec2 on_page(const content *c, double x, double y)
{
    const matrix *m = &c->state[c->depth].m;
    return (roberts_vec2){(m->a * x + m->c * y + m->e) * mm_per_point,
                          c->height_mm - (m->b * x + m->d * y + m->f) * mm_per_point};
}

/* What Cairo makes of a closed path of four sides that lie along the axes. */
static void rectangle(content *c)
{
    double x = c->operand[0], y = c->operand[1], width = c->operand[2], height = c->operand[3];
    move_to(&c->path, on_page(c, x, y));
    line_to(&c->path, on_page(c, x + width, y));
    line_to(&c->path, on_page(c, x + width, y + height));
    line_to(&c->path, on_page(c, x, y + height));
    line_to(&c->path, c->path.start);
}

static void transform(content *c)
{
    const double *o = c->operand;
    matrix *m = &c->state[c->depth].m, by = {o[0], o[1], o[2], o[3], o[4], o[5]};
    *m = (matrix){m->a * by.a + m->c * by.b, m->b * by.a + m->d * by.b,        m->a * by.c + m->c * by.d,
                  m->b * by.c + m->d * by.d, m->a * by.e + m->c * by.f + m->e, m->b * by.e + m->d * by.f + m->f};
}

/* The class of the path that is stroked. */
static void stroke(content *c)
{
    int line = 0;
    while (line < PAPER_CLASSES && paper_color(line) != c->state[c->depth].color)
        line++;
    c->path.failed = c->path.failed || line == PAPER_CLASSES;
    for (; c->first < c->path.p->count; c->first++)
        c->path.p->item[c->first].line = line;
}

static void operate(content *c, const char *name, size_t length)
{
    static const char known[] = " w J j M d gs n W W* Do i ri cs scn rg g f f* BT ET ";
    char word[8] = " ";
    if (length > 4) {
        c->path.failed = true;
        return;
    }
    memcpy(word + 1, name, length);
    memcpy(word + 1 + length, " ", 2);
    if (strcmp(word, " q ") == 0 && c->depth + 1 < STATES) {
        c->state[c->depth + 1] = c->state[c->depth];
        c->depth++;
    } else if (strcmp(word, " Q ") == 0 && c->depth > 0) {
        c->depth--;
    } else if (strcmp(word, " cm ") == 0 && c->operands == 6) {
        transform(c);
    } else if (strcmp(word, " RG ") == 0 && c->operands == 3) {
        c->state[c->depth].color = (uint32_t)lround(255.0 * c->operand[0]) << 16 |
                                   (uint32_t)lround(255.0 * c->operand[1]) << 8 |
                                   (uint32_t)lround(255.0 * c->operand[2]);
    } else if (strcmp(word, " m ") == 0 && c->operands == 2) {
        move_to(&c->path, on_page(c, c->operand[0], c->operand[1]));
    } else if (strcmp(word, " l ") == 0 && c->operands == 2) {
        line_to(&c->path, on_page(c, c->operand[0], c->operand[1]));
    } else if (strcmp(word, " re ") == 0 && c->operands == 4) {
        rectangle(c);
    } else if (strcmp(word, " h ") == 0) {
        line_to(&c->path, c->path.start);
    } else if (strcmp(word, " S ") == 0) {
        stroke(c);
    } else if (strstr(known, word) == NULL) {
        c->path.failed = true;
    }
    c->operands = 0;
}

static void read_content(content *c, const char *at)
{
    static const char blank[] = " \n\r\t";
    for (at += strspn(at, blank); *at && !c->path.failed; at += strspn(at, blank)) {
        char *end;
        double number = strtod(at, &end);
        size_t length = strcspn(at, " \n\r\t[]");
        if (*at == '[' || *at == ']') { /* a pattern of dashes */
            at++;
        } else if (*at == '/') {
            at += length;
        } else if (end != at) {
            if (c->operands < OPERANDS)
                c->operand[c->operands++] = number;
            at = end;
        } else {
            operate(c, at, length);
            at += length;
        }
    }
}

/* The bytes of a compressed stream, which are text, with a NUL behind them; NULL: no memory, or not compressed so. */
static char *inflated(const char *bytes, size_t size)
{
    z_stream z = {.next_in = (Bytef *)(uintptr_t)bytes, .avail_in = (uInt)size};
    char *text = NULL;
    size_t used = 0, room = 0;
    int status = inflateInit(&z);
    while (status == Z_OK) {
        if (!array_reserve(&text, &room, used + 65536, 1))
            break;
        z.next_out = (Bytef *)text + used;
        z.avail_out = (uInt)(room - used - 1);
        uInt before = z.avail_out;
        status = inflate(&z, Z_NO_FLUSH);
        used += before - z.avail_out;
    }
    inflateEnd(&z);
    if (status != Z_STREAM_END) {
        free(text);
        return NULL;
    }
    text[used] = '\0';
    return text;
}

static const char *find(const char *from, const char *end, const char *text)
{
    size_t length = strlen(text);
    for (; (size_t)(end - from) >= length; from++)
        if (*from == *text && memcmp(from, text, length) == 0)
            return from;
    return NULL;
}

bool paper_read_pdf(paper *p, const char *bytes, size_t size, double height_mm)
{
    content c = {.path.p = p, .height_mm = height_mm, .state[0].m = {.a = 1, .d = 1}};
    const char *end = bytes + size, *start = find(bytes, end, "stream\n");
    *p = (paper){0};
    if (!start)
        return false;
    char *text = inflated(start + strlen("stream\n"), (size_t)(end - start) - strlen("stream\n"));
    if (!text)
        return false;
    read_content(&c, text);
    free(text);
    return !c.path.failed && c.first == p->count;
}

/* ---- PNG ------------------------------------------------------------------------------------------------------- */

bool picture_read_png(picture *p, const char *bytes, size_t size)
{
    cairo_surface_t *surface = read_png(bytes, size);
    *p = (picture){0};
    if (cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS) {
        p->width = cairo_image_surface_get_width(surface);
        p->height = cairo_image_surface_get_height(surface);
        p->pixel = alloc_array((size_t)p->width * (size_t)p->height, sizeof *p->pixel);
    }
    for (int y = 0; p->pixel && y < p->height; y++) {
        const unsigned char *row =
            cairo_image_surface_get_data(surface) + (ptrdiff_t)y * cairo_image_surface_get_stride(surface);
        for (int x = 0; x < p->width; x++) {
            uint32_t *to = &p->pixel[(size_t)y * (size_t)p->width + (size_t)x];
            memcpy(to, row + 4 * (ptrdiff_t)x, sizeof *to);
            *to &= 0xffffff;
        }
    }
    cairo_surface_destroy(surface);
    return p->pixel != NULL;
}

void picture_free(picture *p)
{
    free(p->pixel);
    *p = (picture){0};
}
