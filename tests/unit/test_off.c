/* test_off.c - reading OFF: every dialect and quirk, every kind of bad input, and properties of any input.
 *
 * A mesh is compared as text: "(x y z)" for a vertex, "[0 1 2]" for a face, each with "/1" (a map index) or "/r,g,b" if
 * it has a colour. Warnings are compared as "LINE: MESSAGE;". */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "read/off.h"
#include "roberts.h"
#include "rng.h"
#include "testing.h"

enum { ROOM = 1 << 14 };

typedef struct log {
    char text[ROOM];
    size_t length;
} log_text;

static void add(log_text *log, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int n = vsnprintf(log->text + log->length, sizeof log->text - log->length, format, arguments);
    va_end(arguments);
    assert_true(n >= 0 && log->length + (size_t)n < sizeof log->text);
    log->length += (size_t)n;
}

static void on_warning(void *context, const char *file, size_t line, const char *message)
{
    assert_string_equal(file, "test.off");
    assert_null(strchr(message, '\n'));
    add(context, "%zu: %s;", line, message);
}

static void add_color(log_text *log, const roberts_color *color)
{
    if (!color)
        return;
    for (int i = 0; i < color->count; i++)
        add(log, "%c%g", i ? ',' : '/', (double)color->value[i]);
}

static void describe(const roberts_mesh *mesh, log_text *log)
{
    *log = (log_text){0};
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        add(log, "(%.17g %.17g %.17g", mesh->vertex[v].x, mesh->vertex[v].y, mesh->vertex[v].z);
        add_color(log, mesh->vertex_color ? &mesh->vertex_color[v] : NULL);
        add(log, ")");
    }
    for (size_t f = 0; f < mesh->face_count; f++) {
        for (uint32_t i = mesh->face_start[f]; i < mesh->face_start[f + 1]; i++)
            add(log, "%s%lu", i == mesh->face_start[f] ? "[" : " ", (unsigned long)mesh->corner[i]);
        add(log, mesh->face_start[f] == mesh->face_start[f + 1] ? "[" : "");
        add_color(log, mesh->face_color ? &mesh->face_color[f] : NULL);
        add(log, "]");
    }
}

/* Properties of every mesh, whatever was read. */
static void check_mesh(const roberts_mesh *mesh)
{
    assert_true(mesh->vertex_count <= mesh->vertex_room && mesh->corner_count <= mesh->corner_room);
    if (mesh->face_start) {
        assert_true(mesh->face_start[0] == 0 && mesh->face_start[mesh->face_count] == mesh->corner_count);
        for (size_t f = 0; f < mesh->face_count; f++)
            assert_true(mesh->face_start[f] <= mesh->face_start[f + 1]);
    } else {
        assert_true(mesh->face_count == 0 && mesh->corner_count == 0);
    }
    for (size_t i = 0; i < mesh->corner_count; i++)
        assert_true(mesh->corner[i] < mesh->vertex_count);
    for (size_t v = 0; v < mesh->vertex_count; v++)
        assert_true(fabs(mesh->vertex[v].x) <= 1e150 && fabs(mesh->vertex[v].y) <= 1e150 &&
                    fabs(mesh->vertex[v].z) <= 1e150);
    assert_true(!mesh->vertex_color || mesh->vertex_color_room >= mesh->vertex_count);
    assert_true(!mesh->face_color || mesh->face_color_room >= mesh->face_count);
    for (size_t v = 0; mesh->vertex_color && v < mesh->vertex_count; v++)
        assert_true(mesh->vertex_color[v].count <= 4);
    for (size_t f = 0; mesh->face_color && f < mesh->face_count; f++)
        assert_true(mesh->face_color[f].count <= 4);
}

/* Bytes that come in pieces of `step`, and what happens at their end. */
typedef struct feed {
    const char *bytes;
    size_t left, step;
    bool no_end; /* asking for more than there is fails the test */
    int error;   /* errno at the end; 0: a proper end */
} feed;

static ptrdiff_t read_feed(void *context, void *buffer, size_t size)
{
    feed *f = context;
    size_t n = f->left < f->step ? f->left : f->step;
    if (n > size)
        n = size;
    if (n == 0) {
        assert_false(f->no_end);
        errno = f->error;
        return f->error ? -1 : 0;
    }
    memcpy(buffer, f->bytes, n);
    f->bytes += n;
    f->left -= n;
    return (ptrdiff_t)n;
}

#define TRIANGLE "(0 0 0)(1 0 0)(0 1 0)[0 1 2]"
#define POINTS "0 0 0\n1 0 0\n0 1 0\n"

/* Text that is read. */
static const struct {
    const char *name, *text, *mesh, *warnings;
} good[] = {
    {"plain", "OFF\n3 1 0\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"no line end at the end", "OFF\n3 1 0\n" POINTS "3 0 1 2", TRIANGLE, ""},
    {"no faces", "OFF\n1 0 0\n1 2 3\n", "(1 2 3)", ""},
    {"points of rbox", "3 rbox 3 s D3\n3\n" POINTS, "(0 0 0)(1 0 0)(0 1 0)", ""},
    {"... with a comment and a wide title", "3 \t points{} # 7\n#\n1\n1 2 3\n", "(1 2 3)", ""},
    {"nothing at all", "OFF\n0 0 0\n", "", ""},
    {"CR LF", "OFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n", TRIANGLE, ""},
    {"lone CR", "OFF\r3 1 0\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r", TRIANGLE, ""},
    {"tabs, blank lines", "\n \tOFF\n\n\t3\t1\t0\t\n\n0\t0  0\n\n\n 1 0\v0\f\n0 1 0\n\n3\t0\t1\t2\n\n\n", TRIANGLE, ""},
    {"byte-order mark", "\xef\xbb\xbfOFF\n3 1 0\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"comments", "# a\nOFF # b\n# c\n3 1 0 # d\n#\n0 0 0 # e\n1 0 0\n#\n0 1 0\n# f\n3 0 1 2 # g\n#h", TRIANGLE, ""},
    {"comments glued to digits", "OFF#a\n3 1 0#b\n0 0 0#c\n1 0 0#\n0 1 0#d\n3 0 1 2#e", TRIANGLE, ""},
    {"comments between the numbers of a vertex", "OFF 3 1 0\n0#x\n0#y\n0#z\n1 0 0\n0 1 0\n3#n\n0#a\n1#b\n2#c\n",
     TRIANGLE, ""},
    {"counts on the keyword's line", "OFF 3 1 0\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"counts glued to the keyword", " \t OFF3 1 0 # or nah\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"counts on three lines", "OFF\n3\n1\n0\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"all on one line", "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2", TRIANGLE, ""},
    {"edge count missing", "OFF\n3 1\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"edge count missing, keyword's line", "OFF 3 1\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"edge count on the next line", "OFF\n3 1\n7\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"edge count unknown", "OFF\n3 1 -1\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"no keyword", "3 1 0\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"no keyword, comments first", "# of\n# old\n3 1 0\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"no keyword, four vertices", "4 1 0\n" POINTS "0 0 1\n3 0 1 2\n", "(0 0 0)(1 0 0)(0 1 0)(0 0 1)[0 1 2]", ""},
    {"dimension line of qhull", "3\n3 1 3\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"dimension line with blanks", "  3  # d\n3 1 3\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"keyword in lower case", "off\n3 1 0\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"keyword in mixed case", "Off 3 1 0\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"wrapper", "{ OFF\n3 1 0\n" POINTS "3 0 1 2\n}\n", TRIANGLE, ""},
    {"wrapper, tight", "{OFF 3 1 0\n" POINTS "3 0 1 2}", TRIANGLE, ""},
    {"wrapper with =", "{ = OFF\n3 1 0\n" POINTS "3 0 1 2 1 0 0 }", "(0 0 0)(1 0 0)(0 1 0)[0 1 2/0.00392157,0,0]", ""},
    {"wrappers", "{{=OFF 3 1 0\n" POINTS "3 0 1 2\n} # end\n}", TRIANGLE, ""},
    {"wrapper that is not closed", "{ OFF 3 1 0\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"NOFF", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n", TRIANGLE, ""},
    {"NOFF in lower case", "noff\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n", TRIANGLE, ""},
    {"NOFF with normals that are no numbers",
     "NOFF\n3 1 0\n0 0 0 nan nan nan\n1 0 0 -nan -NaN nan(ind)\n0 1 0 inf 0 1\n"
     "3 0 1 2\n",
     TRIANGLE, ""},
    {"STOFF", "STOFF\n3 1 0\n0 0 0 .1 .2\n1 0 0 1 1\n0 1 0 0 0\n3 0 1 2\n", TRIANGLE, ""},
    {"nOFF", "nOFF 3\n3 1 0\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"nOFF, dimension on its line", "nOFF\n3\n3 1 0\n" POINTS "3 0 1 2\n", TRIANGLE, ""},
    {"4OFF", "4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 -3 0 -3\n3 0 1 2\n", "(0 0 0)(1 0 0)(-0 1 -0)[0 1 2]", ""},
    {"4OFF in lower case, glued", "4off3 1 0\n0 0 0 1\n2 0 0 2\n0 3 0 3\n3 0 1 2\n", TRIANGLE, ""},
    {"4nOFF", "4nOFF 3\n3 1 0\n0 0 0 1\n2 0 0 2\n0 .5 0 .5\n3 0 1 2\n", TRIANGLE, ""},
    {"COFF, integers", "COFF\n3 1 0\n0 0 0 255 0 51 255\n1 0 0 0 0 0\n0 1 0 0 255 0 0\n3 0 1 2\n",
     "(0 0 0/1,0,0.2,1)(1 0 0/0,0,0)(0 1 0/0,1,0,0)[0 1 2]", ""},
    {"COFF, decimals", "COFF\n3 1 0\n0 0 0 1. 0 .25 1\n1 0 0 1e0 0 0\n0 1 0 0.0 1 0 0\n3 0 1 2\n",
     "(0 0 0/1,0,0.25,1)(1 0 0/1,0,0)(0 1 0/0,1,0,0)[0 1 2]", ""},
    {"COFF, some without, some with an index", "COFF\n3 1 0\n0 0 0\n1 0 0 7\n0 1 0 0 255 0\n3 0 1 2\n",
     "(0 0 0)(1 0 0/7)(0 1 0/0,1,0)[0 1 2]", ""},
    {"COFF, last ones without", "COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
     "(0 0 0/1,0,0)(1 0 0)(0 1 0)[0 1 2]", ""},
    {"COFF, laid out freely", "COFF 3 1 0 0 0 0 255 0 0 255 1 0 0 255 0 0 255 0 1 0 255 0 0 255 3 0 1 2",
     "(0 0 0/1,0,0,1)(1 0 0/1,0,0,1)(0 1 0/1,0,0,1)[0 1 2]", ""},
    {"COFF, colour that makes no sense", "COFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 300 0 0\n0 1 0 0 -1 0\n3 0 1 2\n",
     "(0 0 0/0.00392157,0,0)(1 0 0)(0 1 0)[0 1 2]", "4: 2 colours that make no sense ignored;"},
    {"STCNOFF",
     "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 255 .5 .5\n1 0 0 0 0 1 0 255 0 .5 .5\n0 1 0 0 0 1 9 .5 .5\n3 0 1 2\n",
     "(0 0 0/1,0,0,1)(1 0 0/0,1,0)(0 1 0/9)[0 1 2]", ""},
    {"STCOFF, whole colours beside decimal texture", "STCOFF\n1 0 0\n0 0 0 1 0 1 .5 .5\n",
     "(0 0 0/0.00392157,0,0.00392157)", ""},
    {"prefixes in MeshLab's order",
     "NCSTOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 255 .5 .5\n1 0 0 0 0 1 0 255 0 1 .5 .5\n"
     "0 1 0 0 0 1 0 0 255 0 .5 .5\n3 0 1 2\n",
     "(0 0 0/1,0,0,1)(1 0 0/0,1,0,0.00392157)(0 1 0/0,0,1,0)[0 1 2]", ""},
    {"C4nOFF, N after C",
     "CN4nOFF\n3\n3 1 0\n0 0 0 1 0 0 1 255 0 0\n2 0 0 2 0 0 1 0 255 0\n0 2 0 2 0 0 1 0 0 255\n3 0 1 2\n",
     "(0 0 0/1,0,0)(1 0 0/0,1,0)(0 1 0/0,0,1)[0 1 2]", ""},
    {"face colours",
     "OFF 3 6 0\n" POINTS "3 0 1 2\n3 0 1 2 5\n3 0 1 2 255 0 51\n3 0 1 2 0 0 255 0\n3 0 1 2 1.0 0 .5\n"
     "3 0 1 2 0 0 0 1.\n",
     "(0 0 0)(1 0 0)(0 1 0)[0 1 2][0 1 2/5][0 1 2/1,0,0.2][0 1 2/0,0,1,0][0 1 2/1,0,0.5]"
     "[0 1 2/0,0,0,1]",
     ""},
    {"face colours, large decimals", "OFF 3 1 0\n" POINTS "3 0 1 2 255.0 0.0 51\n",
     "(0 0 0)(1 0 0)(0 1 0)[0 1 2/1,0,0.2]", ""},
    {"face colours that make no sense",
     "OFF 3 5 0\n" POINTS "3 0 1 2 1 1\n3 0 1 2 red\n3 0 1 2 1 2 3 4 5\n3 0 1 2 256 0 0\n"
     "3 0 1 2 nan 0 0\n",
     "(0 0 0)(1 0 0)(0 1 0)[0 1 2][0 1 2][0 1 2][0 1 2][0 1 2]", "5: 5 colours that make no sense ignored;"},
    {"a face over several lines", "OFF 3 2 0\n" POINTS "3 0 \n1 \n2 \n\n3\n# c\n0\n\n1 2 7\n",
     "(0 0 0)(1 0 0)(0 1 0)[0 1 2][0 1 2/7]", ""},
    {"thin faces", "OFF 3 5 0\n" POINTS "1 0\n3 0 1 2\n2 0 1 255 0 0\n0\n1 2 .5 .5 .5\n",
     "(0 0 0)(1 0 0)(0 1 0)[0][0 1 2][0 1/1,0,0][][2/0.5,0.5,0.5]", "0: 1 face without corners;"},
    {"one thin face", "OFF 3 2 0\n" POINTS "1 0\n3 0 1 2\n", "(0 0 0)(1 0 0)(0 1 0)[0][0 1 2]", ""},
    {"a corner twice, a face twice", "OFF 3 2 0\n" POINTS "4 0 1 1 2\n4 0 1 1 2\n",
     "(0 0 0)(1 0 0)(0 1 0)[0 1 1 2][0 1 1 2]", ""},
    {"fewer faces", "OFF\n3 4 0\n" POINTS "3 0 1 2\n", TRIANGLE, "0: 4 faces declared, but there are 1;"},
    {"fewer faces, wrapper", "{OFF\n3 4 0\n" POINTS "3 0 1 2\n}", TRIANGLE, "0: 4 faces declared, but there are 1;"},
    {"no face of those declared", "OFF\n3 4 0\n" POINTS "# none\n", "(0 0 0)(1 0 0)(0 1 0)",
     "0: 4 faces declared, but there are 0;"},
    {"more faces", "OFF\n3 1 0\n" POINTS "3 0 1 2\n3 2 1 0\n3 2 1 0\n", TRIANGLE,
     "7: text after the last face ignored; the header says 3 vertices and 1 face;"},
    {"points, the first one 0", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "",
     "0: this looks like points, not OFF; put the lines \"3 points\" and \"4\" before them and use --hull;"},
    {"text after the last face", "OFF\n3 1 0\n" POINTS "3 0 1 2\n\n# c\nhello\n", TRIANGLE,
     "9: text after the last face ignored; the header says 3 vertices and 1 face;"},
    {"two models", "OFF\n3 1 0\n" POINTS "3 0 1 2\n\nOFF\n3 1 0\n" POINTS "3 0 1 2\n", TRIANGLE,
     "8: another model begins here and is ignored; OFF holds one, but several files are drawn together;"},
    {"two models of prefixes and counts on the line", "OFF\n3 1 0\n" POINTS "3 0 1 2\nstcnoff3 1 0\n", TRIANGLE,
     "7: another model begins here and is ignored; OFF holds one, but several files are drawn together;"},
    {"two models in braces", "{OFF\n3 1 0\n" POINTS "3 0 1 2\n}\n{ =\nOFF\n3 1 0\n" POINTS "3 0 1 2\n}\n", TRIANGLE,
     "8: another model begins here and is ignored; OFF holds one, but several files are drawn together;"},
    {"two models in more braces", "OFF\n3 1 0\n" POINTS "3 0 1 2\n{ = { OFF\n3 1 0\n" POINTS "3 0 1 2\n}}\n", TRIANGLE,
     "7: another model begins here and is ignored; OFF holds one, but several files are drawn together;"},
    {"no keyword, and another model", "3 1 0\n" POINTS "3 0 1 2\nOFF\n", TRIANGLE,
     "6: another model begins here and is ignored; OFF holds one, but several files are drawn together;"},
    {"a word that begins as the keyword", "OFF\n3 1 0\n" POINTS "3 0 1 2\nOFFICE\n", TRIANGLE,
     "7: text after the last face ignored; the header says 3 vertices and 1 face;"},
    {"text after the wrapper", "{OFF\n3 1 0\n" POINTS "3 0 1 2\n}\n}\n", TRIANGLE,
     "8: text after the last face ignored; the header says 3 vertices and 1 face;"},
    {"numbers of all kinds", "OFF 3 0 0\n+1 -0 1.\n.5 1e3 -1E-3\n0.1 1e150 -1e-320\n",
     "(1 -0 1)(0.5 1000 -0.001)(0.10000000000000001 9.9999999999999998e+149 -9.9998886718268301e-321)", ""},
    {"a number missing, and faces that make sense", "OFF\n4 2 0\n0 0 0\n1 0\n0 1 0\n0 0 1\n4 3 2 1 0\n3 0 2 3\n",
     "(0 0 0)(1 0 0)(1 0 0)(0 1 4)[2 1 0][0 2 3]",
     "4: is a number missing? line 4 has 2 words, and the vertices before it have 3;"},
    {"vertices on one line with a face", "OFF\n3 2 0\n0 0 0 1 0 0 0\n1 0 3 0 1 2\n3 2 1 0\n",
     "(0 0 0)(1 0 0)(0 1 0)[0 1 2][2 1 0]", ""},
    {"wrapped faces with colours, and fewer of them",
     "OFF\n4 5 0\n" POINTS "0 0 1\n4 0 1\n2 3 255 0 0\n3 0\n1 2 0 255 0\n",
     "(0 0 0)(1 0 0)(0 1 0)(0 0 1)[0 1 2 3/1,0,0][0 1 2/0,1,0]", "0: 5 faces declared, but there are 2;"},
    {"a vertex too many", "OFF\n3 1 0\n" POINTS "0 0 1\n3 0 1 3\n", "(0 0 0)(1 0 0)(0 1 0)[]",
     "7: text after the last face ignored; the header says 3 vertices and 1 face;"
     "0: 1 face without corners;6: 1 colour that makes no sense ignored;"
     "6: line 6 looks like a vertex, but the header says 3 vertices, and 3 stand before it;"},
    {"vertices of whole numbers and edges", "OFF\n3 3 0\n" POINTS "2 0 1\n1 2\n3 0 1 2\n",
     "(0 0 0)(1 0 0)(0 1 0)[0 1][2][0 1 2]", ""},
    {"faces without the number of corners", "OFF\n3 3 0\n" POINTS "0 1 2 0\n2 1 0 1 1\n3 0 1 2\n",
     "(0 0 0)(1 0 0)(0 1 0)[/0.00392157,0.00784314,0][1 0][0 1 2]",
     "0: 1 face without corners;7: 1 colour that makes no sense ignored;"
     "7: line 7 begins a face of 2 corners, and 4 numbers follow on it;"},
    {"vertices with colours or without, and a thin face", "COFF\n3 2 0\n0 0 0\n1 0 0 255 0 0\n0 1 0\n2 0 1\n3 0 1 2\n",
     "(0 0 0)(1 0 0/1,0,0)(0 1 0)[0 1][0 1 2]", ""},
    {"all numbers on lines of their own, and a thin face", "OFF\n3 2 0\n0\n0\n0\n1 0\n0\n0\n1\n0\n2 0 1\n3 0 1 2\n",
     "(0 0 0)(1 0 0)(0 1 0)[0 1][0 1 2]", ""},
    {"the first vertex beside the counts, and a thin face", "OFF 3 2 0 0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n",
     "(0 0 0)(1 0 0)(0 1 0)[0 1 2][0 1]", ""},
    {"unused vertices", "OFF 5 1 0\n9 9 9\n" POINTS "8 8 8\n3 1 2 3\n", "(9 9 9)(0 0 0)(1 0 0)(0 1 0)(8 8 8)[1 2 3]",
     ""},
};

static void reads_every_dialect(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        size_t length = strlen(good[i].text);
        for (size_t step = 0; step < 4; step++) { /* 0: all at once, from memory */
            static log_text seen, warnings;
            roberts_mesh mesh = {0};
            roberts_error error;
            roberts_warnings sink = {on_warning, &warnings};
            feed source = {.bytes = good[i].text, .left = length, .step = step};
            warnings = (log_text){0};
            roberts_status status =
                step ? roberts_mesh_read(&mesh, "test.off", read_feed, &source, &sink, &error)
                     : roberts_mesh_read_memory(&mesh, "test.off", good[i].text, length, &sink, &error);
            if (status != ROBERTS_OK)
                fail_msg("%s: line %zu: %s", good[i].name, error.line, error.message);
            check_mesh(&mesh);
            describe(&mesh, &seen);
            if (strcmp(seen.text, good[i].mesh) != 0)
                fail_msg("%s, step %zu: read as %s", good[i].name, step, seen.text);
            /* in pieces, what follows the last face may not have come yet */
            if (step == 0 && strcmp(warnings.text, good[i].warnings) != 0)
                fail_msg("%s: warned of \"%s\"", good[i].name, warnings.text);
            assert_int_equal(mesh.source_count, 1);
            assert_string_equal(mesh.source[0].name, "test.off");
            roberts_mesh_free(&mesh);
        }
    }
}

/* Refused input: the status, the line and the reason. */
static const struct {
    const char *name, *text;
    roberts_status status;
    size_t line;
    const char *message;
} bad[] = {
    {"empty", "", ROBERTS_BAD_SYNTAX, 1, "the input is empty"},
    {"blank", "\n  \n# c\n", ROBERTS_BAD_SYNTAX, 4, "the input is empty"},
    {"glTF, binary", "glTF\2", ROBERTS_BAD_SYNTAX, 1,
     "this is glTF, but only OFF, STL, OBJ and PLY can be read; to convert it: assimp export model.glb model.stl"},
    {"glTF, text", "{\n  \"asset\": {}\n}\n", ROBERTS_BAD_SYNTAX, 2,
     "this is JSON (as glTF is), but only OFF, STL, OBJ and PLY can be read; to convert it: assimp export model.gltf "
     "model.stl"},
    {"Blender", "BLENDER-v304", ROBERTS_BAD_SYNTAX, 1,
     "this is Blender's own format, but only OFF, STL, OBJ and PLY can be read; to convert it: blender -b model.blend "
     "--python-expr \"import bpy; bpy.ops.wm.obj_export(filepath='model.obj', forward_axis='Y', up_axis='Z')\""},
    {"Blender, compressed", "\x28\xb5\x2f\xfd", ROBERTS_BAD_SYNTAX, 1,
     "this is compressed by zstd (as Blender's files are), but only OFF, STL, OBJ and PLY can be read; to convert it: "
     "blender -b model.blend --python-expr \"import bpy; bpy.ops.wm.obj_export(filepath='model.obj', forward_axis='Y', "
     "up_axis='Z')\""},
    {"DXF", "  0\r\nSECTION\r\n  2\r\nENTITIES\r\n", ROBERTS_BAD_SYNTAX, 1,
     "this is DXF, but only OFF, STL, OBJ and PLY can be read; to convert it: assimp export model.dxf model.stl"},
    {"dimension 0", "0\n4 4 6\n", ROBERTS_BAD_SYNTAX, 1, "the dimension is 0, but only 3 can be drawn"},
    {"VRML", "#VRML V2.0 utf8\n", ROBERTS_BAD_SYNTAX, 1, "this is VRML, but only OFF, STL, OBJ and PLY can be read"},
    {"FBX", "Kaydara FBX Binary", ROBERTS_BAD_SYNTAX, 1,
     "this is FBX, but only OFF, STL, OBJ and PLY can be read; to convert it: assimp export model.fbx model.stl"},
    {"STEP", "ISO-10303-21;\nHEADER;\n", ROBERTS_BAD_SYNTAX, 1,
     "this is STEP, but only OFF, STL, OBJ and PLY can be read; to convert it: gmsh -2 model.step -o model.stl"},
    {"OpenSCAD", "// a box\ncube([1, 2, 3]);\n", ROBERTS_BAD_SYNTAX, 1,
     "this is a program (as OpenSCAD's are), but only OFF, STL, OBJ and PLY can be read; to convert it: openscad -o "
     "model.stl model.scad"},
    {"OpenSCAD without a comment", "difference() {\n cube(3);\n}\n", ROBERTS_BAD_SYNTAX, 1,
     "this is OpenSCAD, but only OFF, STL, OBJ and PLY can be read; to convert it: openscad -o model.stl model.scad"},
    {"XML", "<?xml version=\"1.0\"?>\n", ROBERTS_BAD_SYNTAX, 1,
     "this is XML (as AMF, X3D and COLLADA are), but only OFF, STL, OBJ and PLY can be read"},
    {"a word that only begins like a format", "plywood\n", ROBERTS_BAD_SYNTAX, 1,
     "the beginning of OFF (keyword or counts), STL, OBJ or PLY expected, found \"plywood\""},
    {"ZIP", "PK\x03\x04", ROBERTS_BAD_SYNTAX, 1,
     "this is a ZIP archive (as 3MF is), but only OFF, STL, OBJ and PLY can be read; to convert it: echo "
     "'import(\"model.3mf\");' | openscad -o model.stl -"},
    {"UTF-16", "\xff\xfeO", ROBERTS_BAD_SYNTAX, 1,
     "this is text in UTF-16 (to be saved as UTF-8), but only OFF, STL, OBJ and PLY can be read"},
    {"gzip", "\x1f\x8b\x08", ROBERTS_BAD_SYNTAX, 1,
     "this is compressed, as by gzip, but only OFF, STL, OBJ and PLY can be read; to convert it: gzip -dc "
     "model.off.gz | roberts -"},
    {"points without their number", "3 rbox c\n0 0 0\n", ROBERTS_BAD_SYNTAX, 2,
     "the number of points, alone on its line, expected, found \"0\""},
    {"points of four dimensions", "4 rbox c D4\n16\n", ROBERTS_BAD_SYNTAX, 1,
     "the dimension is 4, but only 3 can be drawn"},
    {"no number of points", "3 rbox c\n", ROBERTS_BAD_SYNTAX, 2,
     "the number of points, alone on its line, expected, but the input ends here"},
    {"fewer points than told", "3 rbox c\n3\n0 0 0\n1 1 1\n", ROBERTS_BAD_SYNTAX, 5,
     "x of vertex 2 of 0..2 expected, but the input ends here"},
    {"a word that no format has", "# c\nShape {\n", ROBERTS_BAD_SYNTAX, 2,
     "the beginning of OFF (keyword or counts), STL, OBJ or PLY expected, found \"Shape\""},
    {"unknown prefix", "XOFF\n3 1 0\n", ROBERTS_BAD_SYNTAX, 1,
     "the beginning of OFF (keyword or counts), STL, OBJ or PLY expected, found \"XOFF\""},
    {"prefix twice", "NNOFF\n3 1 0\n", ROBERTS_BAD_SYNTAX, 1,
     "the beginning of OFF (keyword or counts), STL, OBJ or PLY expected, found \"NNOFF\""},
    {"keyword with a tail", "OFFICE\n3 1 0\n", ROBERTS_BAD_SYNTAX, 1,
     "the beginning of OFF (keyword or counts), STL, OBJ or PLY expected, found \"OFFICE\""},
    {"unprintable start", "\x1b[31m\x80\n", ROBERTS_BAD_SYNTAX, 1,
     "the beginning of OFF (keyword or counts), STL, OBJ or PLY expected, found \"\\x1b\""},
    {"long word", "OFFOFFOFFOFFOFFOFFOFFOFFOFFOFF\n", ROBERTS_BAD_SYNTAX, 1,
     "the beginning of OFF (keyword or counts), STL, OBJ or PLY expected, found \"OFFOFFOFFOFFOFFOFFOFFOFF...\""},
    {"keyword alone", "OFF\n", ROBERTS_BAD_SYNTAX, 2, "the number of vertices expected, but the input ends here"},
    {"counts are words", "OFF\nthree 1 0\n", ROBERTS_BAD_SYNTAX, 2, "the number of vertices expected, found \"three\""},
    {"negative count", "OFF\n-3 1 0\n", ROBERTS_BAD_SYNTAX, 2,
     "the number of vertices expected, found \"-3\", which is negative"},
    {"negative number of faces", "OFF\n3 -1 0\n", ROBERTS_BAD_SYNTAX, 2,
     "the number of faces expected, found \"-1\", which is negative"},
    {"a count of minus zero, which is not negative", "OFF\n-0 1 0\n", ROBERTS_BAD_SYNTAX, 2,
     "the number of vertices expected, found \"-0\""},
    {"a minus for a count", "OFF\n- 1 0\n", ROBERTS_BAD_SYNTAX, 2, "the number of vertices expected, found \"-\""},
    {"a negative number that is not whole", "OFF\n-3.5 1 0\n", ROBERTS_BAD_SYNTAX, 2,
     "the number of vertices expected, found \"-3.5\""},
    {"count with a point", "OFF\n3. 1 0\n", ROBERTS_BAD_SYNTAX, 2, "the number of vertices expected, found \"3.\""},
    {"one count", "OFF\n3\n", ROBERTS_BAD_SYNTAX, 3, "the number of faces expected, but the input ends here"},
    {"bad edge count", "OFF\n3 1 many\n", ROBERTS_BAD_SYNTAX, 2, "the number of edges expected, found \"many\""},
    {"4OFF with four counts", "4OFF\n5 10 10 5\n", ROBERTS_BAD_SYNTAX, 2,
     "four counts: this is the 4OFF of four-dimensional polytopes with cells (as of Stella), not 4OFF with homogeneous "
     "coordinates, and cannot be drawn"},
    {"dimension 4", "nOFF 4\n5 10 0\n", ROBERTS_BAD_SYNTAX, 1, "the dimension is 4, but only 3 can be drawn"},
    {"dimension 2 of qhull", "2\n5 10 10\n", ROBERTS_BAD_SYNTAX, 1, "the dimension is 2, but only 3 can be drawn"},
    {"dimension missing", "nOFF\nx\n", ROBERTS_BAD_SYNTAX, 2, "the dimension expected, found \"x\""},
    {"vertex missing", "OFF\n1000 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 999", ROBERTS_BAD_SYNTAX, 6,
     "y of vertex 4 of 0..999 expected, but the input ends here; look: line 6 looks like a face, but the header says "
     "1000 "
     "vertices, and 3 stand before it"},
    {"a number too many, and the end", "OFF\n1000 1 0\n0 0 0\n3 0 1 999\n5 0 0\n1 2\n", ROBERTS_BAD_SYNTAX, 7,
     "x of vertex 4 of 0..999 expected, but the input ends here; look: line 4 has 4 words, and the vertices before it "
     "have 3"},
    {"a vertex more than told", "OFF\n3 2 0\n" POINTS "0 0 1\n3 0 1 3\n", ROBERTS_BAD_INDEX, 7,
     "face 1 names vertex 3, but there are 3, numbered from 0; look: line 6 looks like a vertex, but the header says 3 "
     "vertices, and 3 stand before it"},
    {"normals without NOFF, and an error", "OFF\n3 2 0\n0 0 .5 0 0 1\n1 0 0 0 0 .5\n.5 1 0 0 .5 0\n3 0 1 2\n3 0 2 1\n",
     ROBERTS_BAD_SYNTAX, 5,
     "the number of corners of face 1 of 0..1 expected, found \".5\"; look: line 3 has 6 words, and the vertices of "
     "OFF "
     "have 3; is NOFF or COFF meant?"},
    {"no normals with NOFF", "NOFF\n4 2 0\n" POINTS "0 0 1\n3 0 1 2\n3 0 1 3\n", ROBERTS_BAD_SYNTAX, 9,
     "z of vertex 3 of 0..3 expected, but the input ends here; look: line 3 has 3 words, and the vertices of NOFF have "
     "6"},
    {"a word in each vertex", "OFF\n3 1 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\n3 0 1 2\n", ROBERTS_BAD_SYNTAX, 3,
     "x of vertex 0 of 0..2 expected, found \"v\""},
    {"a corner missing in the last face", "OFF\n3 2 0\n" POINTS "3 0 1 2\n3 0 1\n", ROBERTS_BAD_SYNTAX, 8,
     "corner 3 of 3 in face 1 of 0..1 expected, but the input ends here; look: line 7 begins a face of 3 corners, and "
     "2 "
     "numbers follow on it"},
    {"semicolons", "OFF\n3 1 0\n" POINTS "3 0 1 2;\n", ROBERTS_BAD_SYNTAX, 6,
     "corner 3 of 3 in face 0 of 0..0 expected, found \"2;\"; OFF has decimal points, and blanks between numbers"},
    {"all vertices missing", "OFF\n3 1 0\n", ROBERTS_BAD_SYNTAX, 3,
     "x of vertex 0 of 0..2 expected, but the input ends here"},
    {"word for a coordinate", "OFF\n3 1 0\n0 0 0\n1 O 0\n0 1 0\n3 0 1 2\n", ROBERTS_BAD_SYNTAX, 4,
     "y of vertex 1 of 0..2 expected, found \"O\""},
    {"line after CR", "OFF\r3 1 0\r\n0 0 0\r1 O 0\n", ROBERTS_BAD_SYNTAX, 4,
     "y of vertex 1 of 0..2 expected, found \"O\""},
    {"decimal comma", "OFF\n3 1 0\n0,5 0 0\n", ROBERTS_BAD_SYNTAX, 3,
     "x of vertex 0 of 0..2 expected, found \"0,5\"; OFF has decimal points, and blanks between numbers"},
    {"hexadecimal", "OFF\n3 1 0\n0 0x10 0\n", ROBERTS_BAD_SYNTAX, 3, "y of vertex 0 of 0..2 expected, found \"0x10\""},
    {"half a number", "OFF\n3 1 0\n0 0 1e\n", ROBERTS_BAD_SYNTAX, 3, "z of vertex 0 of 0..2 expected, found \"1e\""},
    {"half a number at the end", "OFF\n3 1 0\n0 0 1e", ROBERTS_BAD_SYNTAX, 3,
     "z of vertex 0 of 0..2 expected, found \"1e\""},
    {"nan", "OFF\n3 1 0\n0 0 nan\n", ROBERTS_BAD_NUMBER, 3,
     "z of vertex 0 of 0..2 expected, found \"nan\"; it must be a finite number"},
    {"inf", "OFF\n3 1 0\n0 0 0\n-Inf 0 0\n", ROBERTS_BAD_NUMBER, 4,
     "x of vertex 1 of 0..2 expected, found \"-Inf\"; it must be a finite number"},
    {"overflow", "OFF\n3 1 0\n0 0 0\n0 1e400 0\n", ROBERTS_BAD_NUMBER, 4, "vertex 1 has a coordinate beyond 1e+150"},
    {"1e308", "OFF\n3 1 0\n0 -1e308 0\n", ROBERTS_BAD_NUMBER, 3, "vertex 0 has a coordinate beyond 1e+150"},
    {"just too large", "OFF\n3 1 0\n0 0 1.0000000000000002e150\n", ROBERTS_BAD_NUMBER, 3,
     "vertex 0 has a coordinate beyond 1e+150"},
    {"w = 0", "4OFF\n3 1 0\n0 0 0 1\n1 0 0 0\n", ROBERTS_BAD_NUMBER, 4,
     "vertex 1 lies at infinity: its fourth coordinate is 0"},
    {"w tiny", "4OFF\n3 1 0\n0 0 0 1\n1 0 0 1e-200\n", ROBERTS_BAD_NUMBER, 4,
     "vertex 1 has a coordinate beyond 1e+150"},
    {"w missing", "4OFF\n1 0 0\n0 0 0\n", ROBERTS_BAD_SYNTAX, 4,
     "w of vertex 0 of 0..0 expected, but the input ends here; look: line 3 has 3 words, and the vertices of 4OFF have "
     "4"},
    {"normal missing", "NOFF\n1 0 0\n0 0 0 1 0\n", ROBERTS_BAD_SYNTAX, 4,
     "the normal of vertex 0 of 0..0 expected, but the input ends here; look: line 3 has 5 words, and the vertices of "
     "NOFF "
     "have 6"},
    {"word for a normal", "NOFF\n1 0 0\n0 0 0 1 up 0\n", ROBERTS_BAD_SYNTAX, 3,
     "the normal of vertex 0 of 0..0 expected, found \"up\""},
    {"texture missing", "STOFF\n1 0 0\n0 0 0 1\n", ROBERTS_BAD_SYNTAX, 4,
     "the colour or texture of vertex 0 of 0..0 expected, but the input ends here; look: line 3 has 4 words, and the "
     "vertices of STOFF have 5"},
    {"index too large", "OFF\n3 1 0\n" POINTS "3 0 1 3\n", ROBERTS_BAD_INDEX, 6,
     "face 0 names vertex 3, but there are 3, numbered from 0"},
    {"index far too large", "OFF\n3 2 0\n" POINTS "3 0 1 2\n3 0 99999999999999999999999999 1\n", ROBERTS_BAD_INDEX, 7,
     "face 1 names vertex 18446744073709551615, but there are 3"},
    {"index at the very end", "OFF\n4 1 0\n0 0 0\n" POINTS "3 0 1 999", ROBERTS_BAD_INDEX, 7,
     "face 0 names vertex 999, but there are 4"},
    {"index of 2^32", "OFF\n3 1 0\n" POINTS "3 0 4294967296 2\n", ROBERTS_BAD_INDEX, 6,
     "face 0 names vertex 4294967296, but there are 3"},
    {"negative index", "OFF\n3 1 0\n" POINTS "3 0 -1 2\n", ROBERTS_BAD_INDEX, 6,
     "face 0 names vertex -1, but there are 3"},
    {"index with a point", "OFF\n3 1 0\n" POINTS "3 0 1. 2\n", ROBERTS_BAD_SYNTAX, 6,
     "corner 2 of 3 in face 0 of 0..0 expected, found \"1.\""},
    {"minus", "OFF\n3 1 0\n" POINTS "3 0 - 2\n", ROBERTS_BAD_SYNTAX, 6,
     "corner 2 of 3 in face 0 of 0..0 expected, found \"-\""},
    {"face cut short", "OFF\n3 1 0\n" POINTS "3 0 1\n", ROBERTS_BAD_SYNTAX, 7,
     "corner 3 of 3 in face 0 of 0..0 expected, but the input ends here; look: line 6 begins a face of 3 corners, and "
     "2 "
     "numbers follow on it"},
    {"word for a face", "OFF\n3 2 0\n" POINTS "3 0 1 2\nend\n", ROBERTS_BAD_SYNTAX, 7,
     "the number of corners of face 1 of 0..1 expected, found \"end\""},
    {"negative corner count", "OFF\n3 1 0\n" POINTS "-3 0 1 2\n", ROBERTS_BAD_SYNTAX, 6,
     "the number of corners of face 0 of 0..0 expected, found \"-3\", which is negative"},
    {"face of 4e9 corners", "OFF\n3 1 0\n" POINTS "4000000000 0 1 2\n", ROBERTS_BAD_SYNTAX, 7,
     "corner 4 of 4000000000 in face 0 of 0..0 expected, but the input ends here; look: line 6 begins a face of "
     "4000000000 "
     "corners, and 3 numbers follow on it"},
    {"4e9 vertices", "OFF\n4000000000 4000000000 0\n0 0 0\n", ROBERTS_BAD_SYNTAX, 4,
     "x of vertex 1 of 0..3999999999 expected, but the input ends here"},
    {"more vertices than can be counted", "OFF\n99999999999999999999999 1 0\n0 0 0\n", ROBERTS_BAD_NUMBER, 2,
     "there can be no more than 4294967294 vertices or faces"},
    {"brace too early", "{OFF\n3 1 0\n0 0 0\n}", ROBERTS_BAD_SYNTAX, 4, "x of vertex 1 of 0..2 expected, found \"}\""},
    {"a number missing, and faces without corners", "OFF\n4 2 0\n0 0 0\n1 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 2 3\n",
     ROBERTS_BAD_SYNTAX, 4,
     "vertex 1 of 0..3 does not end with its line, and then a face has no corners; look: line 4 has 2 words, and the "
     "vertices before it have 3"},
    {"a number missing at once", "OFF\n4 2 0\n# none\n\n0 0\n1 0 0 # 7\n0 1 0\n0 0 1\n3 0 1 2\n3 0 2 3\n",
     ROBERTS_BAD_SYNTAX, 5,
     "vertex 0 of 0..3 does not end with its line, and then a face has no corners; look: line 5 has 2 words, and the "
     "next vertices have 3"},
    {"a number missing, and a first face of one corner", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1\n0 0 1\n3 1 2 0\n3 0 2 3\n",
     ROBERTS_BAD_SYNTAX, 5,
     "vertex 2 of 0..3 does not end with its line, and then the first face has fewer than 3 corners; look: line 5 has "
     "2 words, and the vertices before it have 3"},
    {"a number missing, and a colour", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1\n0 0 1\n4 1 2 0 3\n3 0 2 3\n", ROBERTS_BAD_SYNTAX,
     5,
     "vertex 2 of 0..3 does not end with its line, and then a colour makes no sense; look: line 5 has 2 words, and the "
     "vertices before it have 3"},
    {"a number too many", "OFF\n4 1 0\n0 0 0\n1 0 0 7\n0 1 0\n0 0 1\n3 0 1 2\n", ROBERTS_BAD_SYNTAX, 4,
     "vertex 1 of 0..3 does not end with its line, and then the first face has fewer than 3 corners; look: line 4 has "
     "4 words, and the vertices before it have 3"},
    {"a vertex less than told", "OFF\r\n5 2 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n0 0 1\r\n3 0 1 2\r\n3 0 2 3\r\n",
     ROBERTS_BAD_SYNTAX, 7,
     "vertex 4 of 0..4 does not end with its line, and then there are fewer faces than declared; look: line 7 looks "
     "like a face, but the header says 5 vertices, and 4 stand before it"},
    {"normals without NOFF", "OFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 -1\n0 1 0 0 1 0\n3 0 1 2\n", ROBERTS_BAD_SYNTAX, 3,
     "vertex 0 of 0..2 does not end with its line, and then a face has no corners; look: line 3 has 6 words, and the "
     "vertices of OFF have 3; is NOFF or COFF meant?"},
    {"several faces on one line", "OFF 3 2 0 0 0 0 1 0 0 0 1 0 3 0 1 2 3 2 1 0", ROBERTS_BAD_SYNTAX, 1,
     "vertex 0 of 0..2 does not end with its line, and then there are fewer faces than declared; each face must begin "
     "a line"},
    {"a corner missing", "OFF\n4 3 0\n" POINTS "0 0 1\n3 0 1\n3 0 1 3\n3 1 2 3\n", ROBERTS_BAD_SYNTAX, 7,
     "face 0 of 0..2 runs into the line of the next, and then there are fewer faces than declared; look: line "
     "7 begins a face of 3 corners, and 2 numbers follow on it"},
    {"a face over several lines, and a corner missing",
     "OFF\n4 4 0\n" POINTS "0 0 1\n4 0\n1\n2 3\n3 0 1\n3 0 1 3\n3 1 2 3\n", ROBERTS_BAD_SYNTAX, 10,
     "face 1 of 0..3 runs into the line of the next, and then there are fewer faces than declared; look: line "
     "10 begins a face of 3 corners, and 2 numbers follow on it"},
    {"a number missing", "OFF\n4 2 0\n0 0 0\n1 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 2 9\n", ROBERTS_BAD_INDEX, 8,
     "face 1 names vertex 9, but there are 4; look: line 4 has 2 words, and the vertices before it have 3"},
    {"the first vertex beside the counts", "OFF 3 2 0 0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 9\n", ROBERTS_BAD_INDEX, 5,
     "face 1 names vertex 9, but there are 3"},
    {"a normal too few", "NOFF\n3 2 0\n0 0 0 0 0 1\n1 0 0 0 0\n0 1 0 0 0 1\n3 0 1 2\n3 0 x 2\n", ROBERTS_BAD_SYNTAX, 7,
     "corner 2 of 3 in face 1 of 0..1 expected, found \"x\"; look: line 4 has 5 words, and the vertices before it have "
     "6"},
    {"points", "0.5 0 0\n1 0 0\n\n0 1 0\n", ROBERTS_BAD_SYNTAX, 0,
     "this looks like points, not OFF; put the lines \"3 points\" and \"3\" before them and use --hull"},
    {"whole points", "1 2 3\n4 5 6\n7 8 9\n1 5 2", ROBERTS_BAD_INDEX, 0,
     "this looks like points, not OFF; put the lines \"3 points\" and \"4\" before them and use --hull"},
    {"two counts, and a wrong face", "OFF\n3 2\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 3\n", ROBERTS_BAD_INDEX, 7,
     "face 1 names vertex 3, but there are 3, numbered from 0"},
    {"points with a minus", "-1 2 3\r\n4 5 6\r\n", ROBERTS_BAD_SYNTAX, 0,
     "this looks like points, not OFF; put the lines \"3 points\" and \"2\" before them and use --hull"},
    {"a table", "1.5,2,3\n4,5,6\n", ROBERTS_BAD_SYNTAX, 0,
     "this looks like a table, 3 numbers a line with commas, not OFF; points are the lines \"3 points\", their number, "
     "and "
     "then "
     "three numbers a line, with blanks between"},
    {"points with normals", ".5 2 3 0 0 1\n4 5 6 0 0 1\n", ROBERTS_BAD_SYNTAX, 0,
     "this looks like a table, 6 numbers a line, not OFF; points are the lines \"3 points\", their number, and then "
     "three numbers a line, with blanks between"},
    {"faces counted from 1", "OFF\n3 2 0\n" POINTS "3 1 2 1\n3 2 1 3\n", ROBERTS_BAD_INDEX, 7,
     "face 1 names vertex 3, but there are 3, numbered from 0; up to here no face names vertex 0: do they count from "
     "1?"},
    {"the very first face too", "OFF\n3 1 0\n" POINTS "3 1 2 3\n", ROBERTS_BAD_INDEX, 6,
     "face 0 names vertex 3, but there are 3, numbered from 0; up to here no face names vertex 0: do they count from "
     "1?"},
    {"vertex 0 in a face before", "OFF\n3 2 0\n" POINTS "3 2 1 0\n3 1 2 3\n", ROBERTS_BAD_INDEX, 7,
     "face 1 names vertex 3, but there are 3, numbered from 0"},
    {"minus the number of vertices", "OFF\n3 1 0\n" POINTS "3 0 -3 2\n", ROBERTS_BAD_INDEX, 6,
     "face 0 names vertex -3, but there are 3"},
    {"XYZ", "4\nmethanol, in part\nC 0 0 0.1\nO 0 0 1.4\n", ROBERTS_BAD_SYNTAX, 0,
     "this looks like XYZ, the atoms of a molecule, but only OFF, STL, OBJ and PLY can be read"},
    {"XYZ of three atoms", "3\r\nwater\r\nO 0 0 .1 -0.8\r\nH 0 .7 -.4 0.4\r\n", ROBERTS_BAD_SYNTAX, 0,
     "this looks like XYZ, the atoms of a molecule, but only OFF, STL, OBJ and PLY can be read"},
    {"XYZ without a title", "3\n\nO 0 0 .1\nH 0 .7 -.4\n", ROBERTS_BAD_SYNTAX, 0,
     "this looks like XYZ, the atoms of a molecule, but only OFF, STL, OBJ and PLY can be read"},
    {"XYZ with an energy for a title", "12\n-76.4\nO 0 0 .1\n", ROBERTS_BAD_SYNTAX, 0,
     "this looks like XYZ, the atoms of a molecule, but only OFF, STL, OBJ and PLY can be read"},
    {"a dimension, counts and a word", "3\n4 4 6\nx 0 0 0\n", ROBERTS_BAD_SYNTAX, 3,
     "x of vertex 0 of 0..3 expected, found \"x\""},
    {"another dimension and words", "4\nfour-dimensional\n0 0 0 1\n", ROBERTS_BAD_SYNTAX, 1,
     "the dimension is 4, but only 3 can be drawn"},
    {"no keyword, and faces", "3 1 0\n" POINTS "3 0 1 3\n", ROBERTS_BAD_INDEX, 5,
     "face 0 names vertex 3, but there are 3, numbered from 0"},
    {"BINARY with a tail", "OFF BINARY 3\n", ROBERTS_BAD_SYNTAX, 1,
     "the end of the line after BINARY expected, found \"3\""},
    {"BINARY and nothing", "OFF BINARY\n", ROBERTS_BAD_SYNTAX, 0, "the input ends in its counts (byte 11)"},
    {"BINARY and no dimension", "nOFF BINARY\n", ROBERTS_BAD_SYNTAX, 0, "the input ends in its counts (byte 12)"},
};

static void refuses_bad_input(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        roberts_mesh mesh = {0};
        roberts_error error;
        roberts_status status =
            roberts_mesh_read_memory(&mesh, "test.off", bad[i].text, strlen(bad[i].text), NULL, &error);
        if (status != bad[i].status || error.status != status || error.line != bad[i].line ||
            strcmp(error.message, bad[i].message) != 0 || strcmp(error.file, "test.off") != 0)
            fail_msg("%s: status %d, line %zu: %s", bad[i].name, (int)status, error.line,
                     status ? error.message : "read without complaint");
        assert_true(!mesh.vertex_count && !mesh.face_count && !mesh.source_count && !mesh.face_start && !mesh.vertex);
        assert_int_equal(roberts_mesh_read_memory(&mesh, "test.off", bad[i].text, strlen(bad[i].text), NULL, NULL),
                         bad[i].status);
    }
}

/* NUL bytes: these are no strings, so they need a table of their own. */
static void refuses_nul_bytes(void **state)
{
    static const char zeros[5000];
    static const struct {
        const char *text;
        size_t length, line;
        const char *message;
    } rows[] = {
        {zeros, sizeof zeros, 1,
         "the beginning of OFF (keyword or counts), STL, OBJ or PLY expected, found a word of more than "
         "4096 characters"},
        {zeros, 2, 1, "the beginning of OFF (keyword or counts), STL, OBJ or PLY expected, found \"\\x00\\x00\""},
        {"OFF\n1 0 0\n0 0\0 0\n", 18, 3, "y of vertex 0 of 0..0 expected, found \"0\\x00\""},
        {"OFF\n1 0 0\n0 0 \0\n", 16, 3, "z of vertex 0 of 0..0 expected, found \"\\x00\""},
        {"OFF\n1 1 0\n0 0 0\n3 0\0", 20, 4, "corner 1 of 3 in face 0 of 0..0 expected, found \"0\\x00\""},
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        roberts_mesh mesh = {0};
        roberts_error error;
        roberts_status status = roberts_mesh_read_memory(&mesh, "test.off", rows[i].text, rows[i].length, NULL, &error);
        assert_int_equal(status, ROBERTS_BAD_SYNTAX);
        assert_string_equal(error.message, rows[i].message);
        assert_int_equal(error.line, rows[i].line);
        roberts_mesh_free(&mesh);
    }
    /* but a comment may hold anything */
    roberts_mesh mesh = {0};
    assert_int_equal(roberts_mesh_read_memory(&mesh, "t", "OFF #\0\0x\n1 0 0\n1 2 3#\0", 23, NULL, NULL), ROBERTS_OK);
    assert_int_equal(mesh.vertex_count, 1);
    roberts_mesh_free(&mesh);
}

/* ---- endless and huge ------------------------------------------------------------------------------------------ */

/* A beginning, followed by an endless text. */
typedef struct endless {
    const char *head, *body;
    size_t taken;
} endless;

static ptrdiff_t read_endless(void *context, void *buffer, size_t size)
{
    endless *e = context;
    char *to = buffer;
    const size_t head = strlen(e->head), body = strlen(e->body), from = e->taken < head ? head - e->taken : 0;
    size_t i = 0;
    for (; i < size && i < from + body; i++, e->taken++)
        to[i] = e->taken < head ? e->head[e->taken] : e->body[(e->taken - head) % body];
    for (size_t more; i < size; i += more, e->taken += more) { /* whole bodies, twice as many each time */
        more = size - i < i - from ? size - i : i - from;
        memcpy(to + i, to + from, more);
    }
    return (ptrdiff_t)size;
}

/* The same for inputs that can be read at any position. */
static ptrdiff_t read_endless_at(void *context, uint64_t offset, void *buffer, size_t size)
{
    const endless *source = context;
    endless from = {source->head, source->body, (size_t)offset};
    if (from.taken > 100 << 20)
        fail_msg("\"%s\" and \"%s\" for ever: looked at again up to byte %zu", from.head, from.body, from.taken);
    return read_endless(&from, buffer, size);
}

static bool go_endless(void *context, uint64_t offset)
{
    ((endless *)context)->taken = (size_t)offset;
    return true;
}

/* After an error in an endless text, the search for its reason ends as well. */
static void looks_again_not_for_ever(void **state)
{
    static const struct {
        const char *head, *body;
        size_t line;
        const char *message;
    } rows[] = {
        {"", "1", 1, "the number of vertices expected, found a word of more than 4096 characters"},
        {"", "1 2 3.5\n", 1, "the number of edges expected, found \"3.5\""},
    };
    const off_division whole = off_divide(1);
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        endless source = {rows[i].head, rows[i].body, 0};
        const input_source both = {
            .read = read_endless, .context = &source, .read_at = read_endless_at, .go = go_endless};
        roberts_mesh mesh = {0};
        roberts_error error;
        roberts_status status = read_mesh(&mesh, "test.off", &both, &whole, NULL, &error);
        if (status == ROBERTS_OK || error.line != rows[i].line || strcmp(error.message, rows[i].message) != 0)
            fail_msg("\"%s\" and \"%s\" for ever: line %zu: %s", rows[i].head, rows[i].body, error.line, error.message);
        roberts_mesh_free(&mesh);
    }
}

/* The search ends after 64 MB. Nothing is claimed about the line in which that happens: here, after its second word. */
static void claims_nothing_where_the_look_ends(void **state)
{
    static const struct {
        const char *head, *line;
    } rows[] = {{"OFF\n99999999 1 0  \n0 0 0\n", "1 2 3\n"}, {"OFF\n3 99999999 0    \n" POINTS "2 0 1\n", "3 0 1 2\n"}};
    const size_t size = ((size_t)1 << 26) + 100;
    char *text = malloc(size + 1);
    assert_non_null(text);
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        roberts_mesh mesh = {0};
        roberts_error error;
        const size_t long_line = strlen(rows[i].line);
        size_t used = strlen(rows[i].head);
        memcpy(text, rows[i].head, used + 1);
        for (; used + long_line + 1 < size; used += long_line)
            memcpy(text + used, rows[i].line, long_line);
        memcpy(text + used, "x", 2);
        assert_int_equal(roberts_mesh_read_memory(&mesh, "test.off", text, used + 1, NULL, &error), ROBERTS_BAD_SYNTAX);
        assert_non_null(strstr(error.message, " expected, found \"x\""));
        assert_null(strstr(error.message, "look"));
        roberts_mesh_free(&mesh);
    }
    free(text);
}

static void stops_reading_the_endless(void **state)
{
    static const struct {
        const char *head, *body;
        roberts_status status;
        size_t most; /* bytes that may be read before that is found */
        const char *message;
    } rows[] = {
        {"", "1", ROBERTS_BAD_SYNTAX, 1 << 17,
         "the number of vertices expected, found a word of more than 4096 characters"},
        {"", "x", ROBERTS_BAD_SYNTAX, 1 << 17,
         "the beginning of OFF (keyword or counts), STL, OBJ or PLY expected, found a word of more than 4096 "
         "characters"},
        {"OFF ", "1", ROBERTS_BAD_SYNTAX, 1 << 17,
         "the number of vertices expected, found a word of more than 4096 characters"},
        {"OFF 1 0 0 0 0.", "1", ROBERTS_BAD_SYNTAX, 1 << 17,
         "y of vertex 0 of 0..0 expected, found a word of more than 4096 characters"},
        {"OFF 1 1 0 0 0 0 3 0 ", "0", ROBERTS_BAD_SYNTAX, 1 << 17,
         "corner 2 of 3 in face 0 of 0..0 expected, found a word of more than 4096 characters"},
        {"OFF 1 0 0 0 0 ", "x", ROBERTS_BAD_SYNTAX, 1 << 17,
         "z of vertex 0 of 0..0 expected, found a word of more than 4096 characters"},
        {"OFF 1 1 0 0 0 0 1 0 ", "1 ", ROBERTS_BAD_SYNTAX, 100 << 20, "the line of face 0 does not end"},
        {"OFF 1 0 0 ", "\n", ROBERTS_BAD_SYNTAX, 100 << 20,
         "x of vertex 0 of 0..0 expected, but nothing but blanks and comments follows"},
        {"OFF 1 0 0 #", "no end", ROBERTS_BAD_SYNTAX, 100 << 20,
         "x of vertex 0 of 0..0 expected, but nothing but blanks and comments follows"},
        {"OFF #", "1 ", ROBERTS_BAD_SYNTAX, 100 << 20,
         "the number of vertices expected, but nothing but blanks and comments follows"},
        {"OFF 1 0 #", "no end", ROBERTS_BAD_SYNTAX, 100 << 20,
         "x of vertex 0 of 0..0 expected, but nothing but blanks and comments follows"},
        {"4OFF 1 0 0 #", "1 ", ROBERTS_BAD_SYNTAX, 100 << 20,
         "x of vertex 0 of 0..0 expected, but nothing but blanks and comments follows"},
        {"OFF 2 0 0 0 0 0 #", "1 ", ROBERTS_BAD_SYNTAX, 100 << 20,
         "x of vertex 1 of 0..1 expected, but nothing but blanks and comments follows"},
        {"OFF 1 1 0 0 0 0\n1 0\n", "1 0 0\n", ROBERTS_OK, 1 << 17, ""},
        {"OFF 1 1 0 0 0 0\n1 0\n", "\n", ROBERTS_OK, 1 << 17, ""},
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        roberts_mesh mesh = {0};
        roberts_error error;
        endless source = {rows[i].head, rows[i].body, 0};
        roberts_status status = roberts_mesh_read(&mesh, "test.off", read_endless, &source, NULL, &error);
        if (status != rows[i].status || (status && strcmp(error.message, rows[i].message) != 0) ||
            source.taken > rows[i].most)
            fail_msg("\"%s\" and \"%s\" for ever: status %d after %zu bytes: %s", rows[i].head, rows[i].body,
                     (int)status, source.taken, status ? error.message : "read");
        roberts_mesh_free(&mesh);
    }
}

/* A pipe that its writer keeps open: after the line of the last face, no more is read. */
static void leaves_an_open_pipe_alone(void **state)
{
    static const char *const rows[] = {"OFF 3 1 0\n" POINTS "3 0 1 2\n",         "OFF 3 1 0\n" POINTS "3 0 1 2\r",
                                       "OFF 3 1 0\n" POINTS "3 0 1 2 1 0 0 #\n", "OFF 3 0 0\n0 0 0\n1 1 1\n2 2 2\n",
                                       "{OFF 3 1 0\n" POINTS "3 0 1 2\n",        "{OFF 3 1 0\n" POINTS "3 0 1 2}",
                                       "OFF 3 1 0\n" POINTS "3 0 1 2\nmore"};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        for (size_t step = 1; step < 1000; step += 37) {
            roberts_mesh mesh = {0};
            feed source = {.bytes = rows[i], .left = strlen(rows[i]), .step = step, .no_end = true};
            assert_int_equal(roberts_mesh_read(&mesh, "test.off", read_feed, &source, NULL, NULL), ROBERTS_OK);
            roberts_mesh_free(&mesh);
        }
    }
}

static void reads_a_face_of_a_million_corners(void **state)
{
    enum { CORNERS = 1000000 };
    size_t room = 60 + 8 * (size_t)CORNERS, length;
    char *text = malloc(room);
    roberts_mesh mesh = {0};
    (void)state;
    assert_non_null(text);
    length = (size_t)snprintf(text, room, "OFF 3 1 0\n" POINTS "%d", CORNERS);
    for (int i = 0; i < CORNERS; i++)
        length += (size_t)sprintf(text + length, " %d", i % 3);
    text[length++] = '\n';
    assert_int_equal(roberts_mesh_read_memory(&mesh, "test.off", text, length, NULL, NULL), ROBERTS_OK);
    assert_int_equal(mesh.corner_count, CORNERS);
    for (size_t i = 0; i < mesh.corner_count; i++)
        assert_true(mesh.corner[i] == i % 3);
    roberts_mesh_free(&mesh);
    free(text);
}

static void reads_dev_zero(void **state)
{
    roberts_mesh mesh = {0};
    roberts_error error;
    (void)state;
    if (access("/dev/zero", R_OK) != 0)
        SKIP_BECAUSE("no /dev/zero");
    assert_int_equal(roberts_mesh_read_file(&mesh, "/dev/zero", NULL, &error), ROBERTS_BAD_SYNTAX);
    assert_string_equal(error.file, "/dev/zero");
    assert_int_equal(error.line, 1);
}

/* ---- files, failures, several inputs --------------------------------------------------------------------------- */

static void reports_what_cannot_be_read(void **state)
{
    static const char text[] = "OFF 3 1 0\n" POINTS "3 0 1 2";
    roberts_mesh mesh = {0};
    roberts_error error;
    char name[600];
    (void)state;
    assert_int_equal(roberts_mesh_read_file(&mesh, "tests/there is no such file.off", NULL, &error), ROBERTS_IO);
    assert_string_equal(error.file, "tests/there is no such file.off");
    assert_string_equal(error.message, strerror(ENOENT));
    assert_int_equal(roberts_mesh_read_file(&mesh, "tests", NULL, &error), ROBERTS_IO);
    snprintf(name, sizeof name, "reading failed: %s", strerror(EISDIR));
    assert_string_equal(error.message, name);
    assert_int_equal(roberts_mesh_read_file(&mesh, "/dev/null", NULL, &error), ROBERTS_BAD_SYNTAX);
    assert_string_equal(error.message, "the input is empty");
    snprintf(name, sizeof name, "reading failed: %s", strerror(EIO));
    for (size_t length = 0; length < sizeof text; length++) { /* a disk that fails after this many bytes */
        feed source = {.bytes = text, .left = length, .step = 7, .error = EIO};
        if (roberts_mesh_read(&mesh, "test.off", read_feed, &source, NULL, &error) != ROBERTS_IO)
            fail_msg("failure after %zu bytes unnoticed", length);
        assert_string_equal(error.message, name);
        assert_int_equal(mesh.vertex_count, 0);
    }
    memset(name, 'x', sizeof name - 1); /* longer than an error can hold: its end is kept */
    memcpy(name + sizeof name - 10, "/end.off", 9);
    assert_int_equal(roberts_mesh_read_file(&mesh, name, NULL, &error), ROBERTS_IO);
    assert_true(strncmp(error.file, "...xxx", 6) == 0 && strstr(error.file, "x/end.off"));
}

static void appends_and_goes_back(void **state)
{
    static const char plain[] = "OFF 3 1 0\n" POINTS "3 0 1 2\n";
    static const char colored[] = "COFF 3 2 0\n0 0 1 255 0 0\n1 0 1\n0 1 1\n3 0 1 2\n3 2 1 0 9\n";
    static const char *const broken[] = {"", "OFF 3 1 0\n0 0 0\n",
                                         "COFF 2 1 0\n0 0 1 255 0 0\n0 0 1 255 0 0\n3 0 1 2\n",
                                         "OFF 1 2 0\n0 0 1\n3 0 0 0 255 0 0\n3 0 0 1\n"};
    static log_text before, after;
    (void)state;
    for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
        roberts_mesh mesh = {0};
        for (int good_ones = 0; good_ones < 4; good_ones++) {
            const char *next = good_ones == 1 ? colored : plain;
            bool vertex_colors = mesh.vertex_color, face_colors = mesh.face_color;
            size_t sources = mesh.source_count;
            describe(&mesh, &before);
            assert_true(roberts_mesh_read_memory(&mesh, "bad", broken[i], strlen(broken[i]), NULL, NULL) != ROBERTS_OK);
            describe(&mesh, &after);
            assert_string_equal(before.text, after.text);
            assert_true(vertex_colors == (mesh.vertex_color != NULL) && face_colors == (mesh.face_color != NULL));
            assert_int_equal(mesh.source_count, sources);
            assert_int_equal(roberts_mesh_read_memory(&mesh, next, next, strlen(next), NULL, NULL), ROBERTS_OK);
            check_mesh(&mesh);
        }
        describe(&mesh, &after);
        assert_string_equal(after.text,
                            "(0 0 0)(1 0 0)(0 1 0)(0 0 1/1,0,0)(1 0 1)(0 1 1)(0 0 0)(1 0 0)(0 1 0)(0 0 0)(1 0 0)"
                            "(0 1 0)[0 1 2][3 4 5][5 4 3/9][6 7 8][9 10 11]");
        assert_int_equal(mesh.source_count, 4);
        assert_true(mesh.source[2].first_vertex == 6 && mesh.source[2].first_face == 3);
        assert_string_equal(mesh.source[1].name, colored);
        roberts_mesh_free(&mesh);
    }
}

/* A mesh of all kinds of numbers, longer than several blocks, is read unchanged, however the bytes arrive. */
static void blocks_do_not_matter(void **state)
{
    enum { VERTICES = 9000 };
    static const size_t steps[] = {1, 2, 3, 4095, 4096, 65535, 65536, 65537, 1000000};
    size_t room = 120 * (size_t)VERTICES, length = 0;
    char *text = malloc(room);
    double *x = malloc(3 * sizeof *x * VERTICES);
    rng r = {99};
    (void)state;
    assert_true(text && x);
    length += (size_t)sprintf(text, "OFF\n%d %d 0\n", VERTICES, VERTICES);
    for (size_t i = 0; i < 3 * (size_t)VERTICES; i++) {
        static const char *const after[] = {" ", "\t", "  ", "\n", "\r\n", "\r", "#\n", " # comment 1 2 3\n"};
        x[i] = rng_between(&r, -1, 1) * pow(10.0, rng_int(&r, 0, 6));
        length += (size_t)sprintf(text + length, "%.17g%s", x[i], after[rng_below(&r, 8)]);
    }
    for (size_t f = 0; f < VERTICES; f++)
        length += (size_t)sprintf(text + length, "\n3 %zu %zu%s%d", f, f / 2, f % 3 ? " " : " \n", VERTICES - 1);
    assert_true(length < room);
    for (size_t s = 0; s < sizeof steps / sizeof *steps; s++) {
        roberts_mesh mesh = {0};
        roberts_error error;
        feed source = {.bytes = text, .left = length, .step = steps[s]};
        if (roberts_mesh_read(&mesh, "test.off", read_feed, &source, NULL, &error) != ROBERTS_OK)
            fail_msg("step %zu, line %zu: %s", steps[s], error.line, error.message);
        assert_true(mesh.vertex_count == VERTICES && mesh.face_count == VERTICES && !mesh.face_color);
        for (size_t v = 0; v < VERTICES; v++)
            assert_true(mesh.vertex[v].x == x[3 * v] && mesh.vertex[v].y == x[3 * v + 1] &&
                        mesh.vertex[v].z == x[3 * v + 2]);
        for (size_t f = 0; f < VERTICES; f++)
            assert_true(mesh.face_start[f] == 3 * f && mesh.corner[3 * f] == f && mesh.corner[3 * f + 1] == f / 2 &&
                        mesh.corner[3 * f + 2] == VERTICES - 1);
        roberts_mesh_free(&mesh);
    }
    free(text);
    free(x);
}

/* Coordinates that begin alike, at every length, and one that the end of the text cuts off. */
static void compares_coordinates_to_their_ends(void **state)
{
    enum { VERTICES = 3000, LONGEST = 26 };
    static const char *const digits[] = {"-0.12345678901234567890123", "-0.12345678901234667890123",
                                         "-0.12345678911234567890123", "-0.12445678901234567890123"};
    static const char *const tail[] = {"", "1", "7", "e1", "E-2"};
    char *text = malloc(40 * 3 * VERTICES), written[3 * VERTICES][40];
    size_t length = (size_t)sprintf(text, "OFF\n%d 0 0\n", VERTICES);
    rng r = {7};
    (void)state;
    for (size_t i = 0; i < 3 * VERTICES; i++) {
        int from = rng_below(&r, 16) == 0, size = (int)(8 + i * (LONGEST - 8) / (3 * VERTICES));
        sprintf(written[i], "%.*s%s", size, digits[rng_below(&r, 4)] + from, tail[i % 17 < 5 ? i % 5 : 0]);
        length += (size_t)sprintf(text + length, "%s%s", written[i], i % 3 == 2 ? "\n" : i % 7 ? " " : "\t");
    }
    const size_t last = length - 1 - strlen(written[3 * VERTICES - 1]);
    for (; length > last + 3; length--) {
        roberts_mesh mesh = {0};
        char *copy = memcpy(malloc(length), text, length);
        snprintf(written[3 * VERTICES - 1], sizeof *written, "%.*s", (int)(length - last), text + last);
        assert_int_equal(roberts_mesh_read_memory(&mesh, "a", copy, length, NULL, NULL), ROBERTS_OK);
        for (size_t v = 0; v < VERTICES; v++)
            assert_true(mesh.vertex[v].x == strtod(written[3 * v], NULL) &&
                        mesh.vertex[v].y == strtod(written[3 * v + 1], NULL) &&
                        mesh.vertex[v].z == strtod(written[3 * v + 2], NULL));
        free(copy);
        roberts_mesh_free(&mesh);
    }
    free(text);
}

/* The line of an error far into the input. */
static void counts_lines_of_all_kinds(void **state)
{
    static char text[400000];
    size_t length = (size_t)sprintf(text, "OFF\r\n99999 0 0"), lines = 2;
    (void)state;
    for (int i = 0; length < 200000; i++, lines++)
        length += (size_t)sprintf(text + length, "%s%d 0 1%s",
                                  i % 3 == 0   ? "\r\n"
                                  : i % 3 == 1 ? "\r"
                                               : "\n",
                                  i, i % 7 ? "" : " #");
    length += (size_t)sprintf(text + length, "\nbad\n");
    for (size_t step = 1; step < 100000; step = step * 3 + 1) {
        roberts_mesh mesh = {0};
        roberts_error error;
        feed source = {.bytes = text, .left = length, .step = step};
        assert_int_equal(roberts_mesh_read(&mesh, "test.off", read_feed, &source, NULL, &error), ROBERTS_BAD_SYNTAX);
        assert_int_equal(error.line, lines + 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_every_dialect),
        cmocka_unit_test(refuses_bad_input),
        cmocka_unit_test(refuses_nul_bytes),
        cmocka_unit_test(stops_reading_the_endless),
        cmocka_unit_test(looks_again_not_for_ever),
        cmocka_unit_test(claims_nothing_where_the_look_ends),
        cmocka_unit_test(leaves_an_open_pipe_alone),
        cmocka_unit_test(reads_a_face_of_a_million_corners),
        cmocka_unit_test(reads_dev_zero),
        cmocka_unit_test(reports_what_cannot_be_read),
        cmocka_unit_test(appends_and_goes_back),
        cmocka_unit_test(blocks_do_not_matter),
        cmocka_unit_test(counts_lines_of_all_kinds),
        cmocka_unit_test(compares_coordinates_to_their_ends),
    };
    return cmocka_run_group_tests_name("off", tests, NULL, NULL);
}
