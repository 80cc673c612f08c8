/* SVG in groups: the file is sound XML, ids are unique, every name is that of the table, and every group has exactly
 * its own lines. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drawing.h"
#include "sheet_views.h"
#include "testing.h"

/* ---- a scene, drawn ---- */

typedef struct drawn {
    roberts_scene *scene;
    roberts_drawing drawing;
} drawn;

static void free_drawn(drawn *d)
{
    roberts_drawing_free(&d->drawing);
    roberts_scene_free(d->scene);
}

static drawn draw_scene(roberts_scene *scene)
{
    roberts_camera camera = preset_camera("iso");
    roberts_hide_options options = roberts_hide_options_default();
    options.keep_hidden = true;
    return (drawn){scene, drawing_of(scene, &camera, &options)};
}

static char *save(const drawn *d, roberts_draw_options options, roberts_grouping grouping)
{
    options.scene = d->scene;
    options.grouping = grouping;
    return drawing_written(&d->drawing, &options).bytes;
}

static roberts_draw_options with_hidden(void)
{
    roberts_draw_options options = roberts_draw_options_default();
    options.hidden = ROBERTS_HIDDEN_DASHED;
    return options;
}

/* ---- a small reader of XML ---- */

enum { DEPTH_MOST = 8, IDS_MOST = 400, TEXT_MOST = 200, ELEMENTS_MOST = 20000 };

typedef struct xml_element {
    char class[TEXT_MOST], body[TEXT_MOST], name[TEXT_MOST], view[TEXT_MOST], edge[TEXT_MOST], faces[TEXT_MOST],
        by[TEXT_MOST], layer[TEXT_MOST], line[TEXT_MOST];
    size_t depth; /* groups round it */
    bool is_path;
    const char *data; /* of a path: the text after d=" */
} xml_element;

typedef struct xml {
    xml_element *item;
    size_t count;
    char id[IDS_MOST][TEXT_MOST];
    size_t ids;
} xml;

/* Copies the value of an attribute with its entities as they are. True if it is there. */
static bool attribute(const char *tag, const char *end, const char *name, char *value)
{
    char start[TEXT_MOST];
    snprintf(start, sizeof start, " %s=\"", name);
    const char *at = strstr(tag, start);
    value[0] = '\0';
    if (!at || at >= end)
        return false;
    at += strlen(start);
    size_t length = strcspn(at, "\"");
    assert_true(length < TEXT_MOST || strcmp(name, "d") == 0);
    if (length < TEXT_MOST) {
        memcpy(value, at, length);
        value[length] = '\0';
    }
    assert_null(strchr(value, '<'));
    return true;
}

static const char *after(const char *at, char c)
{
    at = strchr(at, c);
    assert_non_null(at);
    return at + 1;
}

/* Reads the groups and paths of a file; missing attributes are those of the enclosing group. */
static xml read_xml(const char *text)
{
    xml x = {.item = calloc(ELEMENTS_MOST, sizeof *x.item)};
    xml_element open[DEPTH_MOST] = {{.depth = 0}};
    size_t depth = 0;
    assert_non_null(x.item);
    const char *at = strstr(text, "<svg");
    assert_non_null(at);
    for (at = after(at, '>'); strncmp(at, "</svg>", 6) != 0; at = after(at, '>')) {
        while (*at != '<')
            at = after(at, '\n');
        if (strncmp(at, "</svg>", 6) == 0)
            break;
        const char *end = after(at, '>');
        if (strncmp(at, "</", 2) == 0) {
            if (strncmp(at, "</g>", 4) == 0) {
                assert_true(depth > 0);
                depth--;
            }
            continue;
        }
        if (strncmp(at, "<g", 2) != 0 && strncmp(at, "<path", 5) != 0)
            continue;
        assert_true(x.count < ELEMENTS_MOST);
        xml_element *e = &x.item[x.count++];
        char own[TEXT_MOST];
        *e = open[depth];
        e->depth = depth;
        e->is_path = at[1] == 'p';
        e->class[0] = '\0';
        attribute(at, end, "class", e->class);
        if (attribute(at, end, "inkscape:label", own))
            strcpy(e->layer, own);
        if (attribute(at, end, "data-body", own))
            strcpy(e->body, own);
        if (attribute(at, end, "data-name", own))
            strcpy(e->name, own);
        if (attribute(at, end, "data-view", own))
            strcpy(e->view, own);
        if (!e->is_path && attribute(at, end, "stroke", own))
            strcpy(e->line, e->class);
        attribute(at, end, "data-edge", e->edge);
        attribute(at, end, "data-faces", e->faces);
        attribute(at, end, "data-by", e->by);
        if (attribute(at, end, "id", own)) {
            for (size_t i = 0; i < x.ids; i++)
                assert_string_not_equal(x.id[i], own);
            assert_true(x.ids < IDS_MOST);
            strcpy(x.id[x.ids++], own);
        }
        if (e->is_path) {
            e->data = strstr(at, " d=\"") + 4;
            assert_true(end[-2] == '/');
        } else {
            assert_true(depth + 1 < DEPTH_MOST);
            open[++depth] = *e;
        }
    }
    assert_int_equal(depth, 0);
    return x;
}

/* ---- lengths ---- */

typedef struct pen_at {
    double x, y, x0, y0, length;
    size_t lines;
} pen_at;

static void go_to(pen_at *p, double x, double y)
{
    p->length += hypot(x - p->x, y - p->y);
    p->lines++;
    p->x = x;
    p->y = y;
}

/* How far the pen goes along the data of a path, up to its quote. */
static pen_at follow(const char *data)
{
    pen_at p = {0};
    for (char *at = (char *)(uintptr_t)data; *at != '"';) {
        const bool relative = islower((unsigned char)*at);
        const char command = (char)toupper((unsigned char)*at++);
        double x = p.x, y = p.y;
        if (isspace((unsigned char)command))
            continue;
        if (command == 'Z') {
            go_to(&p, p.x0, p.y0);
            continue;
        }
        if (command != 'V')
            x = strtod(at, &at) + (relative ? x : 0.0);
        if (command != 'H')
            y = strtod(at, &at) + (relative ? y : 0.0);
        if (command == 'M') {
            p.x = p.x0 = x;
            p.y = p.y0 = y;
        } else {
            assert_non_null(strchr("LHV", command));
            go_to(&p, x, y);
        }
    }
    return p;
}

static const char *const class_names[] = {"hidden", "wire",    "intersection", "crease",
                                          "border", "outline", "frame",        "symbol"};

/* How long the lines of a class are on paper. */
static double length_of(const xml *x, const char *class)
{
    double length = 0.0;
    for (size_t i = 0; i < x->count; i++)
        if (x->item[i].is_path && (strcmp(x->item[i].line, class) == 0 || strcmp(x->item[i].layer, class) == 0))
            length += follow(x->item[i].data).length;
    return length;
}

/* ---- tests ---- */

static const char *const models[] = {"models/table.off", "models/compound-of-five-tetrahedra.off", "models/city.off",
                                     "models/temple.off", "models/stacked-blocks.off"};

/* Whatever the groups are, each class has the same lines. In the layers of classes they are chained as Cairo does,
 * which drops lines without length, so they are compared within rounding. */
static void lines_are_the_same(void **state)
{
    (void)state;
    for (size_t m = 0; m < sizeof models / sizeof models[0]; m++) {
        drawn d = draw_scene(scene_of_file(models[m]));
        char *text[3];
        xml x[3];
        for (int g = ROBERTS_GROUP_CLASS; g <= ROBERTS_GROUP_ELEMENT; g++) {
            text[g] = save(&d, with_hidden(), (roberts_grouping)g);
            x[g] = read_xml(text[g]);
        }
        for (size_t c = 0; c < sizeof class_names / sizeof class_names[0]; c++) {
            const double wanted = length_of(&x[0], class_names[c]);
            const size_t lines = x[2].count;
            for (int g = 1; g < 3; g++)
                if (fabs(length_of(&x[g], class_names[c]) - wanted) > 0.003 * (double)lines)
                    fail_msg("%s: %s: %g mm, not %g", models[m], class_names[c], length_of(&x[g], class_names[c]),
                             wanted);
        }
        for (int g = 0; g < 3; g++) {
            free(text[g]);
            free(x[g].item);
        }
        free_drawn(&d);
    }
}

/* Does a segment have the names of an element? */
static bool has_names(const drawn *d, const roberts_segment *s, const xml_element *e)
{
    char edge[40] = "", faces[40] = "", by[20] = "", body[20];
    uint32_t f[2];
    roberts_segment_faces(d->scene, &d->drawing, s, f);
    snprintf(body, sizeof body, "%u", (unsigned)s->solid);
    if (s->v0 != ROBERTS_NONE)
        snprintf(edge, sizeof edge, "%u-%u", (unsigned)s->v0, (unsigned)s->v1);
    if (f[1] != ROBERTS_NONE)
        snprintf(faces, sizeof faces, "%u,%u", (unsigned)f[0], (unsigned)f[1]);
    else if (f[0] != ROBERTS_NONE)
        snprintf(faces, sizeof faces, "%u", (unsigned)f[0]);
    if (s->state == ROBERTS_HIDDEN)
        snprintf(by, sizeof by, "%u", (unsigned)s->by);
    return strcmp(body, e->body) == 0 && strcmp(edge, e->edge) == 0 && strcmp(faces, e->faces) == 0 &&
           strcmp(by, e->by) == 0;
}

/* Each element has the names of a segment and its length, or is shorter if it lies under another line. */
static void elements_have_names(void **state)
{
    (void)state;
    for (size_t m = 0; m < sizeof models / sizeof models[0]; m++) {
        drawn d = draw_scene(scene_of_file(models[m]));
        roberts_ink ink;
        roberts_draw_options options = with_hidden();
        options.ink = &ink;
        char *text = save(&d, options, ROBERTS_GROUP_ELEMENT);
        xml x = read_xml(text);
        size_t elements = 0;
        for (size_t i = 0; i < x.count; i++) {
            const xml_element *e = &x.item[i];
            bool found = false;
            if (!e->is_path)
                continue;
            elements++;
            assert_string_equal(e->class, "edge");
            const double length = follow(e->data).length;
            for (size_t k = 0; k < d.drawing.count && !found; k++) {
                const roberts_segment *s = &d.drawing.segment[k];
                found = has_names(&d, s, e) && length <= ink.scale * hypot(s->p1.x - s->p0.x, s->p1.y - s->p0.y) + 0.01;
            }
            if (!found)
                fail_msg("%s: body %s has no such edge %s, faces %s, by %s, %g mm", models[m], e->body, e->edge,
                         e->faces, e->by, length);
        }
        assert_true(elements > 20);
        assert_true(elements == ink.strokes); /* without dashes of their own, each is one stroke */
        free(text);
        free(x.item);
        free_drawn(&d);
    }
}

/* The dashes of a piece are one element. */
static void dashes_stay_together(void **state)
{
    drawn d = draw_scene(scene_of_file("models/platonic/cube.off"));
    roberts_draw_options options = with_hidden();
    size_t hidden = 0;
    (void)state;
    options.real_dashes = true;
    char *text = save(&d, options, ROBERTS_GROUP_ELEMENT);
    xml x = read_xml(text);
    for (size_t i = 0; i < x.count; i++)
        if (x.item[i].is_path && strcmp(x.item[i].line, "hidden") == 0) {
            hidden++;
            assert_true(follow(x.item[i].data).lines > 3);
        }
    assert_int_equal(hidden, 3);
    free(text);
    free(x.item);
    free_drawn(&d);
}

/* Groups and elements take at most 90 bytes each more than the path of their class. */
static void elements_are_short(void **state)
{
    (void)state;
    for (size_t m = 0; m < sizeof models / sizeof models[0]; m++) {
        drawn d = draw_scene(scene_of_file(models[m]));
        char *by_class = save(&d, with_hidden(), ROBERTS_GROUP_CLASS);
        char *by_element = save(&d, with_hidden(), ROBERTS_GROUP_ELEMENT);
        xml x = read_xml(by_element);
        size_t elements = 0;
        for (size_t i = 0; i < x.count; i++)
            elements += x.item[i].is_path || strcmp(x.item[i].class, "body") == 0;
        const size_t more = strlen(by_element) - strlen(by_class);
        print_message("%s: %.1f bytes more for each of %zu elements\n", models[m], (double)more / (double)elements,
                      elements);
        assert_true(more <= 90 * elements);
        free(by_class);
        free(by_element);
        free(x.item);
        free_drawn(&d);
    }
}

static const char named_obj[] = "o lid \"A\" <1> & 'b'\n"
                                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 3 4\n"
                                "o \xff\x01lid\n"
                                "v 3 0 0\nv 4 0 0\nv 3 1 0\nv 3 0 1\nf 5 6 7\nf 5 6 8\nf 6 7 8\nf 5 7 8\n";

/* Names of files are text, whatever characters they have. */
static void names_are_escaped(void **state)
{
    drawn d = draw_scene(scene_of_text(named_obj));
    (void)state;
    roberts_draw_options options = roberts_draw_options_default();
    options.id_prefix = "p\"<";
    options.number_layers = true;
    char *text = save(&d, options, ROBERTS_GROUP_BODY);
    xml x = read_xml(text);
    assert_string_equal(x.item[0].name, "lid &quot;A&quot; &lt;1&gt; &amp; 'b'");
    assert_string_equal(x.item[0].layer, "1 lid &quot;A&quot; &lt;1&gt; &amp; 'b'");
    assert_string_equal(x.item[0].body, "0");
    assert_string_equal(x.item[0].class, "body");
    assert_int_equal(x.ids, 2);
    assert_string_equal(x.id[0], "p&quot;&lt;body-0");
    assert_string_equal(x.id[1], "p&quot;&lt;body-1");
    assert_non_null(strstr(text, "data-name=\"?"));
    assert_null(strpbrk(text, "\xff\x01"));
    free(text);
    free(x.item);
    free_drawn(&d);
}

/* Numbers of layers that are classes follow those of the bodies, whether text is strokes or text. */
static void no_number_is_used_twice(void **state)
{
    static const struct {
        bool native;
        const char *layer[5]; /* the last ones */
    } cases[] = {
        {false, {"2 body-1", "9 frame", "12 text", "13 hidden-text"}},
        {true, {"2 body-1", "9 frame", "13 hidden-letters", "12 letters"}},
    };
    drawn d = draw_scene(scene_of_file("models/cube-behind-cube.off"));
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_draw_options options = with_hidden();
        options.number_layers = true;
        options.frame.off = false;
        options.lettering.labels = ROBERTS_LABEL_VERTICES;
        options.lettering.native = cases[i].native;
        char *text = save(&d, options, ROBERTS_GROUP_BODY);
        const char *at = text;
        for (const char *const *layer = cases[i].layer; *layer; layer++) {
            char label[40];
            snprintf(label, sizeof label, "inkscape:label=\"%s\"", *layer);
            at = strstr(at, label);
            assert_non_null(at);
        }
        free(text);
    }
    free_drawn(&d);
}

/* A body's group holds the classes; pens are on groups, never on paths. */
static void bodies_hold_classes(void **state)
{
    drawn d = draw_scene(scene_of_file("models/table.off"));
    (void)state;
    char *text = save(&d, with_hidden(), ROBERTS_GROUP_BODY);
    xml x = read_xml(text);
    long last = -1;
    for (size_t i = 0; i < x.count; i++) {
        const xml_element *e = &x.item[i];
        assert_int_equal(e->depth, e->is_path ? 2 : strcmp(e->class, "body") == 0 ? 0 : 1);
        if (e->depth == 0) {
            assert_true(strtol(e->body, NULL, 10) > last);
            last = strtol(e->body, NULL, 10);
        }
    }
    for (const char *path = strstr(text, "<path"); path; path = strstr(path + 1, "<path"))
        assert_int_equal(strncmp(path, "<path d=\"M", 10), 0);
    free(text);
    free(x.item);
    free_drawn(&d);
}

static void sheets_have_views(void **state)
{
    static const char *const names[] = {"front", "top", "left", "iso"};
    views v;
    (void)state;
    hide_views(&v, "table", ROBERTS_FIRST_ANGLE);
    for (int g = ROBERTS_GROUP_BODY; g <= ROBERTS_GROUP_ELEMENT; g++) {
        roberts_draw_options options = roberts_draw_options_default();
        size_t layers = 0;
        options.grouping = (roberts_grouping)g;
        options.scene = v.scene;
        options.frame.off = false;
        char *text = sheet_written(&v.sheet, &options).bytes;
        xml x = read_xml(text);
        for (size_t i = 0; i < x.count; i++) {
            const xml_element *e = &x.item[i];
            if (e->depth == 0 && layers < 4) {
                assert_string_equal(e->class, "view");
                assert_string_equal(e->view, names[layers++]);
            } else if (e->depth == 0) {
                assert_string_equal(e->class, layers++ == 4 ? "frame" : "symbol");
            }
            if (e->is_path && strcmp(e->line, "frame") != 0 && strcmp(e->line, "symbol") != 0)
                assert_true(e->view[0] && e->body[0] && e->line[0]);
        }
        assert_int_equal(layers, 6);
        assert_int_equal(x.ids, 6);
        free(text);
        free(x.item);
    }
    free_views(&v);
}

/* A label in letters of the reader names what it belongs to, as its text says; without groups it does not. */
static void labels_have_names(void **state)
{
    static const struct {
        roberts_label_kind kind;
        const char *name;
        size_t count;
    } cases[] = {{ROBERTS_LABEL_VERTICES, "<text data-vertex=\"", 8},
                 {ROBERTS_LABEL_EDGES, "<text data-edge=\"", 12},
                 {ROBERTS_LABEL_FACES, "<text data-face=\"", 3},
                 {ROBERTS_LABEL_BODIES, "<text data-body=\"", 1}};
    const roberts_camera camera = preset_camera("iso");
    drawn d = draw_scene(scene_of_file("models/platonic/cube.off"));
    roberts_region_list regions;
    (void)state;
    assert_int_equal(roberts_regions(d.scene, &camera, NULL, &regions, NULL), ROBERTS_OK);
    d.drawing.regions = &regions;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_draw_options options = with_hidden();
        options.lettering = (roberts_lettering){.labels = cases[i].kind, .native = true};
        char *plain = save(&d, options, ROBERTS_GROUP_CLASS), *named = save(&d, options, ROBERTS_GROUP_ELEMENT);
        size_t found = 0;
        for (const char *at = named; (at = strstr(at, cases[i].name)); found++) {
            at += strlen(cases[i].name);
            const char *text = strchr(strchr(at, '"') + 1, '>') + 1;
            const size_t length = strcspn(at, "\"");
            assert_memory_equal(text, at, length);
            assert_int_equal(text[length], '<');
        }
        assert_int_equal(found, cases[i].count);
        assert_null(strstr(plain, "<text data-"));
        assert_non_null(strstr(plain, "<text "));
        free(plain);
        free(named);
    }
    roberts_regions_free(&regions);
    free_drawn(&d);
}

/* Other formats have no groups: the option changes nothing. */
static void others_have_none(void **state)
{
    static const roberts_format formats[] = {ROBERTS_PDF, ROBERTS_EPS, ROBERTS_TIKZ, ROBERTS_DXF, ROBERTS_HPGL};
    drawn d = draw_scene(scene_of_file("models/platonic/cube.off"));
    (void)state;
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        roberts_draw_options options = with_hidden();
        sink to[2];
        options.format = formats[i];
        for (int k = 0; k < 2; k++) {
            options.grouping = k == 0 ? ROBERTS_GROUP_CLASS : ROBERTS_GROUP_ELEMENT;
            to[k] = drawing_written(&d.drawing, &options);
        }
        assert_int_equal(to[0].size, to[1].size);
        assert_memory_equal(to[0].bytes, to[1].bytes, to[0].size);
        free(to[0].bytes);
        free(to[1].bytes);
    }
    free_drawn(&d);
}

static void odd_arguments(void **state)
{
    roberts_drawing empty = {0};
    roberts_draw_options options = roberts_draw_options_default();
    sink to = {0};
    (void)state;
    for (int g = ROBERTS_GROUP_BODY; g <= ROBERTS_GROUP_ELEMENT; g++) {
        options.grouping = (roberts_grouping)g;
        assert_int_equal(roberts_drawing_write(&empty, &options, sink_write, &to, NULL), ROBERTS_OK);
    }
    options.grouping = (roberts_grouping)(ROBERTS_GROUP_ELEMENT + 1);
    assert_int_equal(roberts_drawing_write(&empty, &options, sink_write, &to, NULL), ROBERTS_BAD_ARGUMENT);
    free(to.bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_are_the_same),   cmocka_unit_test(elements_have_names),
        cmocka_unit_test(dashes_stay_together), cmocka_unit_test(elements_are_short),
        cmocka_unit_test(names_are_escaped),    cmocka_unit_test(no_number_is_used_twice),
        cmocka_unit_test(bodies_hold_classes),  cmocka_unit_test(sheets_have_views),
        cmocka_unit_test(labels_have_names),    cmocka_unit_test(others_have_none),
        cmocka_unit_test(odd_arguments),
    };
    return cmocka_run_group_tests_name("svg, groups", tests, NULL, NULL);
}
