/* The program from outside: exit status, messages, files. Runs $ROBERTS_BUILD/roberts from the top folder. */
/* for a terminal of our own: posix_openpt() */
#define _XOPEN_SOURCE 700 /* NOLINT(bugprone-reserved-identifier): that is its name */
#include <dirent.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "program.h"
#include "testing.h"

/* ---- misuse ---- */

static const struct {
    const char *arguments, *said;
} misuse_cases[] = {
    {"--hiden dashed", "--hiden is unknown; did you mean --hidden?"},
    {"--lookat 1,2,3", "--lookat is unknown; did you mean --look-at?"},
    {"--al", "--al is unknown; did you mean --all-edges?"},
    {"--frobnicate", "--frobnicate is unknown\n"},
    {"-x", "-x is unknown"},
    {"-qx", "-qx: -x is unknown\n"},
    {"-x.off", "-x.off is unknown\n"},
    {"-o=in/a.svg", "-o=in/a.svg: only long options have \"=\"; did you mean -o in/a.svg?"},
    {"-qf=svg", "-qf=svg: only long options have \"=\"; did you mean -f svg?"},
    {"--hidden dotted", "--hidden: \"dotted\" is unknown; it can be none, dashed, solid"},
    {"--hidden dahsed", "did you mean dashed?"},
    {"--view isometric", "--view: \"isometric\" is unknown; did you mean iso?"},
    {"--view ISO", "--view: \"ISO\" is unknown; did you mean iso?"},
    {"--hidden Dashed", "did you mean dashed?"},
    {"--hidden DASH", "did you mean dashed?"},
    {"--label vertex", "--label: \"vertex\" is unknown; did you mean vertices? It can be vertices, edges, "},
    {"--label face,Body", "--label: \"face\" is unknown; did you mean faces? "},
    {"--label faces,Body", "--label: \"Body\" is unknown; did you mean bodies? "},
    {"--Hidden dashed", "--Hidden is unknown; did you mean --hidden?"},
    {"--view buttom", "did you mean bottom?"},
    {"-f svgz", "--format: \"svgz\" is unknown; did you mean svg?"},
    {"--stats=xml", "--stats: \"xml\" is unknown"},
    {"--stats=", "--stats: \"\" is unknown"},
    {"--dir 1,2", "--dir: \"1,2\" is not X,Y,Z"},
    {"--dir 1,2,x", "--dir: \"1,2,x\" is not X,Y,Z"},
    {"--dir 1,2,3,4", "--dir: \"1,2,3,4\" is not X,Y,Z"},
    {"--dir 1;2;3", "is not X,Y,Z"},
    {"--dir 1,,3", "is not X,Y,Z"},
    {"--dir=", "--dir: \"\" is not X,Y,Z"},
    {"--dir 1,2,nan", "is not X,Y,Z"},
    {"--dir 1,2,0x3", "is not X,Y,Z"},
    {"--dir 1,2,1e999", "is not X,Y,Z"},
    {"--dir 1,2,e3", "is not X,Y,Z"},
    {"--dir 0,0,0", "--dir: 0,0,0 is no direction"},
    {"--up 0,-0,0", "--up: 0,0,0 is no direction"},
    {"--eye 1,2", "--eye: \"1,2\" is not X,Y,Z"},
    {"--dir 1,2,3 --eye 1,2,3", "--dir and --eye exclude each other"},
    {"--eye 1,2,3 --view top", "--view and --eye exclude each other"},
    {"--view top --dir 1,2,3", "--dir and --view exclude each other"},
    {"--dir 1,2,3 --look-at 1,2,3", "--dir and --look-at exclude each other"},
    {"--azimuth 10 --dir 1,2,3", "--azimuth and --dir exclude each other"},
    {"--view top --azimuth 10", "--azimuth and --view exclude each other"},
    {"--elevation 10 --eye 1,2,3", "--elevation and --eye exclude each other"},
    {"--azimuth 30deg", "--azimuth: \"30deg\" is not a number"},
    {"--azimuth 361", "--azimuth: 361 is out of range: from -360 to 360"},
    {"--elevation -91", "--elevation: -91 is out of range: from -90 to 90"},
    {"--roll inf", "--roll: \"inf\" is not a number"},
    {"--look-at 1,2,3", "--look-at needs --eye"},
    {"--background dark", "--background: \"dark\" is unknown"},
    {"--background #12345", "--background: \"#12345\" is unknown"},
    {"--background nothing", "orange, purple, #rrggbb, #rgb or none\n"},
    {"--style crease:pen=256", "--style: \"pen=256\" is no number of a pen, from 1 to 255"},
    {"--style crease:pen=0", "--style: \"pen=0\" is no number of a pen, from 1 to 255"},
    {"--style crease:color=none", "orange, purple, #rrggbb or #rgb\n"},
    {"--background", "--background needs a value"},
    {"--crease 1 --all-edges", "--crease and --all-edges exclude each other"},
    {"--crease 1,5", "--crease: \"1,5\" is not a number"},
    {"--crease -1", "--crease: -1 is out of range: from 0 to 180"},
    {"--crease 181", "--crease: 181 is out of range: from 0 to 180"},
    {"--epsilon nan", "--epsilon: \"nan\" is not a number"},
    {"--epsilon -1", "--epsilon: -1 is out of range: "},
    {"--tolerance 2", "--tolerance: 2 is out of range: from 0 to 1"},
    {"--grid -1", "--grid: \"-1\" is not a whole number"},
    {"--grid 1.5", "--grid: \"1.5\" is not a whole number"},
    {"--threads 4294967296", "--threads: \"4294967296\" is not a whole number"},
    {"--threads=", "--threads: \"\" is not a whole number"},
    {"--verify=", "--verify: \"\" is not a whole number"},
    {"--verify=-1", "--verify: \"-1\" is not a whole number"},
    {"--pick 1", "--pick: \"1\" is not X,Y"},
    {"--pick 1,2,3", "--pick: \"1,2,3\" is not X,Y"},
    {"--pick 1,inf", "--pick: \"1,inf\" is not X,Y"},
    {"--pick", "--pick needs a value"},
    {"--quiet=1", "--quiet takes no value"},
    {"-o", "-o needs a value"},
    {"--format", "--format needs a value"},
    {"--output=", "--output: the name is empty"},
    {"-o a.bmp models/table.off", "a.bmp: no format has this ending (.svg, .pdf, .ps, .eps, .png, .tikz, .tex, .dxf, "
                                  ".hpgl, .plt, .csv and .json are known); name the format with -f"},
    {"--turntable 4", "--turntable needs a name with a place for the number: -o turn-%03d.svg"},
    {"--turntable 4 -o a.svg", "--turntable needs a name with a place"},
    {"--turntable 4 -o a-%d-%d.svg", "--turntable needs a name with a place"},
    {"--turntable 4 -o a-%s.svg", "--turntable needs a name with a place"},
    {"--turntable 4 -o a-%03.svg", "--turntable needs a name with a place"},
    {"--turntable 4 -o a-%%d.svg", "--turntable needs a name with a place"},
    {"--turntable 4 -o a-%n%d.svg", "--turntable needs a name with a place"},
    {"--turntable 0 -o a-%d.svg", "--turntable: 0 is out of range: from 1 to 100000"},
    {"--turntable 100001 -o a-%d.svg", "--turntable: 100001 is out of range: from 1 to 100000"},
    {"--batch in -o a.svg a.off", "--batch and --output exclude each other"},
    {"--batch in --turntable 3 a.off", "--batch and --turntable exclude each other"},
    {"--batch in", "--batch needs names of files"},
    {"--batch in a.off -", "--batch needs names of files"},
    {"--batch= a.off", "--batch: the name is empty"},
    {"--room-for= a.off", "--room-for: a file is needed, not \"\""},
    {"--room-for a.off --turntable 2 -o a-%d.svg a.off", "--room-for and --turntable exclude each other"},
    {"--room-for - a.off", "--room-for: a file is needed, not \"-\""},
    {"--room-for a.off --sheet first a.off", "--room-for and --sheet exclude each other"},
    {"--sheet first --title= a.off", "--title: the text is empty"},
    {"--batch in a.off in/a.off", "--batch: a.off and in/a.off would both be drawn to in/a.svg"},
    {"--part 0/3 models/table.off", "--part: \"0/3\" is not K/N, with K from 1 to N"},
    {"--part 4/3 models/table.off", "--part: \"4/3\" is not K/N"},
    {"--part 1/3 --plan models/table.off", "--plan and --part exclude each other"},
    {"--part 1/3 --fill white models/table.off", "--part: --fill needs the whole scene"},
    {"--plan --label faces models/table.off", "--plan: labels of faces and bodies need the whole scene"},
    {"--join", "--join needs the names of all parts"},
    {"--join --verify part-1", "exclude each other"},
    {"--sheet", "--sheet needs a value"},
    {"--sheet frist", "--sheet: \"frist\" is unknown; did you mean first?"},
    {"--sheet first --view top", "--sheet and --view exclude each other"},
    {"--sheet first --dir 1,2,3", "--sheet and --dir exclude each other"},
    {"--sheet first --eye 1,2,3", "--sheet and --eye exclude each other"},
    {"--sheet first --azimuth 1", "--sheet and --azimuth exclude each other"},
    {"--sheet first --elevation 1", "--sheet and --elevation exclude each other"},
    {"--sheet first --up 0,1,0", "--sheet and --up exclude each other"},
    {"--sheet first --roll 9", "--sheet and --roll exclude each other"},
    {"--sheet first --pick 0,0", "--sheet and --pick exclude each other"},
    {"--sheet first --turntable 2 -o a-%d.svg", "--sheet and --turntable exclude each other"},
    {"-q -v", "--quiet and --verbose exclude each other"},
    {"- -", "standard input (-) can be read only once"},
    {"--page a7", "--page: \"a7\" is unknown"},
    {"--page leter", "did you mean letter?"},
    {"--page 100", "or WxH in mm"},
    {"--page 100x", "--page: \"100x\" is unknown"},
    {"--page 100x0", "--page: 100x0 is out of range: from 1 to 40000 mm a side"},
    {"--page 50000x100", "is out of range: from 1 to 40000 mm a side"},
    {"--page 8.5x11inch", "--page: \"8.5x11inch\" is unknown"},
    {"--page 8.5in", "or WxH in mm, as 210x297, or 8.5x11in"},
    {"--page 2000x1in", "--page: 2000x1in is out of range: from 1 to 40000 mm a side"},
    {"--page 100x100 --margin 2in", "--margin: 50.8 mm leave no room on a page of 100 x 100 mm"},
    {"--page 100x100 --margin 50", "--margin: 50 mm leave no room on a page of 100 x 100 mm"},
    {"--margin -1", "--margin: -1 is out of range: from 0 to 20000 mm"},
    {"--margin 2001cm", "--margin: 2001cm is out of range: from 0 to 20000 mm"},
    {"--margin 10px", "--margin: \"10px\" is not a length in mm, or with cm, in or pt behind it"},
    {"--margin mm", "--margin: \"mm\" is not a length in mm"},
    {"--margin 1m", "--margin: \"1m\" is not a length in mm"},
    {"--fit --scale 1:2", "--fit and --scale exclude each other"},
    {"--scale 1:0", "--scale: 1:0 is out of range: "},
    {"--scale -1", "--scale: -1 is out of range: "},
    {"--scale 1/20", "--scale: \"1/20\" is not like 1:20"},
    {"--scale big", "--scale: \"big\" is not like 1:20"},
    {"--unit inch", "--unit: \"inch\" is unknown; did you mean in?"},
    {"--align botom-left", "did you mean bottom-left?"},
    {"--order fast", "--order: \"fast\" is unknown; it can be travel, none"},
    {"--dash fake", "--dash: \"fake\" is unknown; it can be pattern, real"},
    {"--dpi 0", "--dpi: 0 is out of range: from 10 to 10000"},
    {"--dpi 300dpi", "--dpi: \"300dpi\" is not a number"},
    {"--style outlin:off", "--style: \"outlin\" is unknown; did you mean outline?"},
    {"--style outline", "--style: \"outline\" is not CLASS:key=value"},
    {"--style outline:", "--style: \"\" is unknown; it can be width"},
    {"--style outline:widht=1", "did you mean width?"},
    {"--style outline:width", "--style: width needs a value"},
    {"--style outline:off=1", "--style: off takes no value"},
    {"--style outline:width=0", "--style: width=0 is out of range: "},
    {"--style outline:width=wide", "--style: width=wide is not a length in mm, or with cm, in or pt behind it"},
    {"--style outline:width=1e", "--style: width=1e is not a length in mm"},
    {"--style outline:width=2880pt", "--style: width=2880pt is out of range: from 0.001 to 1000 mm"},
    {"--style hidden:dash=3/1px", "--style: dash=3/1px is neither none nor DASH/GAP"},
    {"--style outline:color=#12345", "--style: colour: \"#12345\" is unknown"},
    {"--style outline:color=purpel", "did you mean purple?"},
    {"--style hidden:dash=1/x", "--style: dash=1/x is neither none nor DASH/GAP"},
    {"--style hidden:dash=0", "--style: dash=0 is out of range: "},
};

static void misuse(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof misuse_cases / sizeof misuse_cases[0]; i++) {
        print_message("roberts %s\n", misuse_cases[i].arguments);
        assert_int_equal(run(misuse_cases[i].arguments), 2);
        assert_int_equal(strncmp(last.err, "roberts: ", 9), 0);
        assert_said(misuse_cases[i].said);
        assert_said("roberts --help");
        assert_string_equal(last.out, "");
    }
    assert_int_equal(access("a.dxf", F_OK), -1);
}

/* ---- input that fails ---- */

static void failing_input(void **state)
{
    (void)state;
    assert_int_equal(run("missing.off"), 1);
    assert_string_equal(last.err, "roberts: missing.off: No such file or directory\n");
    assert_int_equal(run("models/table.off missing.off -o in/a.svg"), 1);
    assert_int_equal(run("in -o in/a.svg"), 1);
    assert_said("roberts: in: is a folder; name the files in it, as *.off or *.stl\n");
    assert_int_equal(run("/dev/null -o in/a.svg"), 1);
    assert_said("roberts: /dev/null:1: ");
    put("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n");
    assert_int_equal(run("bad.off -o in/a.svg"), 1);
    assert_said("roberts: bad.off:6: ");
    assert_int_equal(entries("in", false), 0);
    assert_string_equal(last.out, "");
}

/* ---- output ---- */

static void output_goes_where_it_should(void **state)
{
    static char text[TEXT];
    (void)state;
    assert_int_equal(run("models/platonic/cube.off"), 0);
    assert_int_equal(strncmp(last.out, "<?xml", 5), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("models/platonic/cube.off -o in/a.svg"), 0);
    assert_string_equal(last.out, "");
    read_text("in/a.svg", text);
    assert_int_equal(run("-o - -- models/platonic/cube.off"), 0);
    assert_string_equal(last.out, text);
    assert_int_equal(run("-qoin/b.svg models/platonic/cube.off"), 0);
    read_text("in/b.svg", last.out);
    assert_string_equal(last.out, text);
    finish(start("--view=iso", "models/platonic/cube.off", -1));
    assert_int_equal(last.status, 0);
    assert_string_equal(strstr(last.out, "<g "), strstr(text, "<g ")); /* title and description differ */
    finish(start("--view iso - --up 0,0,2", "models/platonic/cube.off", -1));
    assert_string_equal(strstr(last.out, "<g "), strstr(text, "<g "));
    assert_int_equal(run("models/platonic/cube.off -o in/a.csv"), 0);
    read_text("in/a.csv", text);
    assert_int_equal(strncmp(text, "body,v0,v1,t0,t1,state,x0,y0,x1,y1,by,class,f0,f1\n0,", 52), 0);
    assert_int_equal(run("models/platonic/cube.off -f csv -o in/a.svg"), 0); /* -f overrides the ending */
    read_text("in/a.svg", last.out);
    assert_string_equal(last.out, text);
    assert_int_equal(run("models/platonic/cube.off -f null -o in/c.svg"), 0);
    assert_int_equal(access("in/c.svg", F_OK), -1);
    assert_int_equal(entries("in", false), 3);
}

static void options_reach_the_library(void **state)
{
    static char text[TEXT];
    (void)state;
    assert_int_equal(run("-f csv models/platonic/cube.off"), 0);
    assert_int_equal(count_of(last.out, ",visible,"), 9);
    assert_int_equal(count_of(last.out, ",hidden,"), 0);
    assert_int_equal(run("-f csv --hidden solid models/platonic/cube.off"), 0);
    assert_int_equal(count_of(last.out, ",hidden,"), 3);
    assert_int_equal(run("-f csv --view top models/platonic/cube.off"), 0);
    assert_int_equal(count_of(last.out, ",visible,"), 4);
    strcpy(text, last.out);
    assert_int_equal(run("-f csv --dir 0,0,7 models/platonic/cube.off"), 0);
    assert_string_equal(last.out, text);
    assert_int_equal(run("-f csv --view top --view front models/platonic/cube.off"), 0); /* the last counts */
    assert_string_not_equal(last.out, text);
    assert_int_equal(run("-f csv --dir -1,-2,-3 models/platonic/cube.off"), 0);
    assert_int_equal(count_of(last.out, ",visible,"), 9);
    assert_int_equal(run("-f csv --eye 0,0,50 models/platonic/cube.off"), 0);
    assert_int_equal(count_of(last.out, ",visible,"), 4);
    assert_string_not_equal(last.out, text);
    assert_int_equal(run("-f csv --eye 0,0,50 --look-at 0,0,60 models/platonic/cube.off"), 1);
    assert_int_equal(run("-f csv --crease 80 models/platonic/cube.off"), 0);
    assert_int_equal(count_of(last.out, ",visible,"), 9);
    assert_int_equal(run("-f csv --crease 100 models/platonic/cube.off"), 0);
    assert_int_equal(count_of(last.out, ",visible,"), 6);
    assert_int_equal(run("-f csv --view top --up 1,0,0 models/platonic/cube.off"), 0);
    assert_string_not_equal(last.out, text);
    assert_int_equal(run("models/platonic/cube.off models/platonic/cube.off -f csv --hidden solid"), 0);
    assert_int_equal(count_of(last.out, "\n1,"), 12);
    assert_int_equal(run("-f csv --epsilon 1e300 models/platonic/cube.off"), 2);
}

/* The same view given in two ways gives the same rows. */
static void angles_are_views(void **state)
{
    static const char *const same[][2] = {
        {"--azimuth 0", "--view front"},
        {"--azimuth 90", "--view right"},
        {"--azimuth -90", "--view left"},
        {"--azimuth 180 --elevation 0", "--view back"},
        {"--elevation 90", "--view top"},
        {"--elevation -90", "--view bottom --roll 180"},
        {"--elevation 90 --azimuth 90", "--view top --roll -90"},
        {"--azimuth 45", "--dir 1,-1,0"},
        {"--view top --roll 90", "--roll 90 --dir 0,0,1"},
        {"--view top --roll 90", "--view top --up 1,0,0"},
        {"--eye 18,12,90 --look-at 18,12,0 --roll 90", "--eye 18,12,90 --look-at 18,12,0 --up 1,0,0"},
        {"--y-up --view front", "--view top"},
        {"--y-up --view top", "--dir 0,1,0 --up 0,0,-1"},
    };
    static char text[TEXT], line[512];
    (void)state;
    for (size_t i = 0; i < sizeof same / sizeof same[0]; i++) {
        print_message("%s, %s\n", same[i][0], same[i][1]);
        snprintf(line, sizeof line, "-f csv models/table.off %s", same[i][0]);
        assert_int_equal(run(line), 0);
        assert_true(count_of(last.out, ",visible,") > 3);
        strcpy(text, last.out);
        snprintf(line, sizeof line, "-f csv models/table.off %s", same[i][1]);
        assert_int_equal(run(line), 0);
        assert_string_equal(last.out, text);
    }
}

/* The page, its lines and their pens: options of each on a cube, and their effect in the SVG. */
static const struct {
    const char *arguments, *wanted; /* a part of the SVG; if it begins with !, the rest must be missing */
} page_cases[] = {
    {"", "width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\""},
    {"--page a3", "width=\"297mm\" height=\"420mm\""},
    {"--page a0", "width=\"841mm\" height=\"1189mm\""},
    {"--page a6", "width=\"105mm\" height=\"148mm\""},
    {"--page letter", "width=\"215.9mm\" height=\"279.4mm\""},
    {"--page legal", "width=\"215.9mm\" height=\"355.6mm\""},
    {"--page tabloid", "width=\"279.4mm\" height=\"431.8mm\""},
    {"--page 100x50.5", "width=\"100mm\" height=\"50.5mm\""},
    {"--page 8.5x11in", "width=\"215.9mm\" height=\"279.4mm\""},
    {"--page 8.5inx11in", "width=\"215.9mm\" height=\"279.4mm\""},
    {"--page 8.5inx11", "width=\"215.9mm\" height=\"279.4mm\""}, /* one unit stands for both */
    {"--page 10cmx2in", "width=\"100mm\" height=\"50.8mm\""},
    {"--page 144X72PT", "width=\"50.8mm\" height=\"25.4mm\""},
    {"--page 100mmx50", "width=\"100mm\" height=\"50mm\""},
    {"--landscape", "width=\"297mm\" height=\"210mm\""},
    {"--landscape --page a5", "width=\"210mm\" height=\"148mm\""},
    {"--landscape --page 100x50", "width=\"100mm\" height=\"50mm\""},
    {"--view top --page 100x100", "M 90 10 L 10 10 L 10 90 L 90 90 Z"},
    {"--view top --page 100x100 --margin 20 --fit", "M 80 20 L 20 20 L 20 80 L 80 80 Z"},
    {"--view top --page 100x100 --margin 2cm", "M 80 20 L 20 20 L 20 80 L 80 80 Z"},
    {"--view top --page 100x100 --margin 0 --scale 10:1", "M 60 40 L 40 40 L 40 60 L 60 60 Z"},
    {"--view top --page 100x100 --scale 10", "M 60 40 L 40 40 L 40 60 L 60 60 Z"},
    {"--view top --page 100x100 --scale 1:2 --unit cm", "M 55 45 L 45 45 L 45 55 L 55 55 Z"},
    {"--view top --page 100x100 --scale 1:25 --unit m", "M 90 10 L 10 10 L 10 90 L 90 90 Z"},
    {"--view top --page 100x100 --scale 1 --unit in", "M 75.4 24.6 L 24.6 24.6 L 24.6 75.4 L 75.4 75.4 Z"},
    {"--view top --page 100x100 --scale standard", "M 70 30 L 30 30 L 30 70 L 70 70 Z"},
    {"--view top --page 100x100 --scale standard --unit m", "M 70 30 L 30 30 L 30 70 L 70 70 Z"},
    {"--view top --page 100x100 --scale standard --scale 10", "M 60 40 L 40 40 L 40 60 L 60 60 Z"},
    {"--sheet first --scale standard --unit cm --align top-left", "M 50 10 L 10 10 L 10 50 L 50 50 Z"},
    {"--sheet first --title T --unit cm --align top-left", "M 50 65 L 10 65 L 10 105 L 50 105 Z"},
    {"--sheet first --title T --unit cm --align top-left --fit", "M 148.744 97.487 L 97.487 127.08"},
    {"--view top --page 100x100 --scale 10 --align top-left", "M 30 10 L 10 10 L 10 30 L 30 30 Z"},
    {"--view top --page 100x100 --scale 10 --align bottom-right", "M 90 70 L 70 70 L 70 90 L 90 90 Z"},
    {"--view top --page 100x100 --scale 10 --align right", "M 90 40 L 70 40 L 70 60 L 90 60 Z"},
    {"--view top --page 100x100 --scale 10 --align bottom", "M 60 70 L 40 70 L 40 90 L 60 90 Z"},
    {"--frame", "<g id=\"frame\" inkscape:groupmode=\"layer\" inkscape:label=\"frame\">"},
    {"--frame", "stroke-width=\"0.7\" stroke-linecap=\"round\" stroke-linejoin=\"round\" d=\"M 10 10 L 200 10 L 200 "
                "287 L 10 287 Z \""},
    {"", "!id=\"frame\""},
    {"--background white", "<rect id=\"background\" width=\"210\" height=\"297\" fill=\"#ffffff\"/>"},
    {"--background #1A2b3c --page 60x50", "<rect id=\"background\" width=\"60\" height=\"50\" fill=\"#1a2b3c\"/>"},
    {"--background=blue --sheet first", "fill=\"#0000ff\"/>\n<g id=\"crease\""},
    {"--background white --background none", "!<rect"},
    {"", "!<rect"},
    {"--background white", "<desc>roberts --background=white models/platonic/cube.off</desc>"},
    {"", "!id=\"hidden\""},
    {"--hidden dashed", "stroke-dasharray=\"2.75 1\""},
    {"--layers named", "inkscape:label=\"outline\""},
    {"--layers numbered", "<g id=\"outline\" inkscape:groupmode=\"layer\" inkscape:label=\"6 outline\">"},
    {"--layers numbered --hidden dashed", "inkscape:label=\"1 hidden\""},
    {"--layers numbered --style crease:pen=2", "inkscape:label=\"2 crease\""},
    {"--id-prefix a-", "<g id=\"a-outline\" class=\"outline\" inkscape:groupmode"},
    {"--id-prefix a- --group element", "<g id=\"a-outline\" class=\"outline\" inkscape:groupmode"},
    {"--id-prefix a-", "inkscape:label=\"outline\" fill=\"none\" stroke=\"#000000\""},
    {"--style all:off --style all:on", "id=\"outline\""},
    {"--style all:off --style all:on", "!id=\"frame\""},
    {"--style crease:pen=7 -f hpgl", "SP7;PW0.35,7;PC7,0,0,0;"},
    {"--layers numbered --group body --frame", "inkscape:label=\"1 body-0\""},
    {"--layers numbered --group body --frame", "inkscape:label=\"8 frame\""},
    {"--group class", "<g id=\"outline\" inkscape:groupmode=\"layer\" inkscape:label=\"outline\">\n<path fill"},
    {"--group body", "<g id=\"body-0\" inkscape:groupmode=\"layer\" inkscape:label=\"body-0\" class=\"body\" "
                     "data-body=\"0\">\n<g class=\"crease\" fill=\"none\""},
    {"--group element", "<path class=\"edge\" data-edge=\"4-6\" data-faces=\"1,5\" d=\"M"},
    {"--group element --hidden dashed", "data-faces=\"2,3\" data-by=\"0\" d=\"M"},
    {"--group element --fill shade",
     "<g class=\"body\" data-body=\"0\">\n<path class=\"region\" data-face=\"0\" fill=\"#"},
    {"--group element --hatch on", "<path class=\"hatch\" data-face=\"4\" d=\"M"},
    {"--hatch on", "<g id=\"hatch\" inkscape:groupmode=\"layer\" inkscape:label=\"hatch\">"},
    {"--hatch on --layers numbered", "inkscape:label=\"9 hatch\""},
    {"--hatch on --style hatch:color=red", "stroke=\"#ff0000\" stroke-width=\"0.25\""},
    {"--hatch on --style hatch:off", "!id=\"hatch\""},
    {"--hatch on --hatch off", "!id=\"hatch\""},
    {"--hatch spacing=2,levels=3,angle=30,direction=steep,cross=0.5 --sheet first", "id=\"hatch\""},
    {"--group element --id-prefix a.-_9", "<g id=\"a.-_9outline\" class=\"outline\" inkscape"},
    {"--id-prefix a_ --background red", "<rect id=\"a_background\""},
    {"--hidden solid", "!stroke-dasharray"},
    {"--hidden solid", "id=\"hidden\""},
    {"--hidden dashed --dash pattern", "stroke-dasharray"},
    {"--hidden dashed --dash real", "!stroke-dasharray"},
    {"--hidden dashed --style hidden:width=0.5",
     "stroke-width=\"0.5\" stroke-linecap=\"round\" stroke-linejoin=\"round\" stroke-dasharray=\"5.5 2\""},
    {"--hidden dashed --style hidden:dash=2/1", "stroke-dasharray=\"1.75 1.25\""},
    {"--hidden dashed --style hidden:dash=4", "stroke-dasharray=\"3.75 1.25\""},
    {"--hidden dashed --style hidden:dash=2mm/1mm", "stroke-dasharray=\"1.75 1.25\""},
    {"--hidden dashed --style hidden:dash=0.2/0.1cm", "stroke-dasharray=\"1.75 1.25\""},
    {"--hidden dashed --style hidden:dash=0.4cm", "stroke-dasharray=\"3.75 1.25\""},
    {"--hidden dashed --style hidden:dash=none", "!stroke-dasharray"},
    {"--hidden dashed --style hidden:off", "!id=\"hidden\""},
    {"--style outline:width=3.6pt", "stroke-width=\"1.27\""},
    {"--style outline:width=1,colour=#f00", "stroke=\"#ff0000\" stroke-width=\"1\""},
    {"--style outline:color=#1A2b3c", "stroke=\"#1a2b3c\" stroke-width=\"0.5\""},
    {"--style crease:color=blue", "stroke=\"#0000ff\" stroke-width=\"0.35\""},
    {"--style crease:off", "!id=\"crease\""},
    {"--style crease:off --style crease:on", "id=\"crease\""},
    {"--style frame:width=2 --frame", "stroke-width=\"2\""},
    {"--sheet first", "<g id=\"symbol\" inkscape:groupmode=\"layer\" inkscape:label=\"symbol\">"},
    {"--sheet first --style symbol:color=red", "stroke=\"#ff0000\" stroke-width=\"0.35\""},
    {"--sheet third --style symbol:off", "!id=\"symbol\""},
    {"", "!id=\"symbol\""},
    {"--sheet first --hidden dashed", "!id=\"hidden\""}, /* the isometric view has none */
    {"--sheet third", "<desc>roberts --sheet=third models/platonic/cube.off</desc>"},
    {"--sheet first --scale 10 --align top-left", "M 30 10 L 10 10 L 10 30 L 30 30 Z"},
    {"--sheet first --scale 10 --align top-left", "M 45 10 L 65 10 L 65 30 L 45 30 Z"},
    {"--style crease:dash=3/1", "stroke-dasharray=\"2.65 1.35\""},
    {"-q --threads 1 --grid 3 -f svg --stats", "<desc>roberts models/platonic/cube.off</desc>"},
    {"--order none --view=top --crease 5",
     "<desc>roberts --order=none --view=top --crease=5 models/platonic/cube.off</desc>"},
    {"", "<title>cube.off</title>"},
    {"--title A&B", "<title>A&amp;B</title>"},
    {"--crop --view top --margin 1", "viewBox=\"0 0 210 210\""},
    {"--crop --view top --margin 1 --frame", "M 1 1 L 209 1 L 209 209 L 1 209 Z"},
    {"--crop --view top --margin 5 --scale 10", "viewBox=\"0 0 30 30\""},
    {"--crop --view top --margin 0 --scale 10", "viewBox=\"0 0 20.5 20.5\""},
    {"--crop --view top --margin 5 --scale 10 --page 31x31 --label vertices", "viewBox=\"0 0 31 31\""},
    {"--description A&B", "<desc>A&amp;B</desc>"},
    {"--description=", "!<desc>"},
    {"--title T", "!id=\"text\""}, /* only sheets have title blocks, which a mark of --frame=zones keeps off */
    {"--title T --frame=zones", "M 105 292 L 105 282"},
    {"--sheet first --page a4 --landscape --title Cube", "<title>Cube</title>"},
};

/* The file drawn with these arguments holds the text wanted; or, after an exclamation mark, does not. */
static void expect_in_file(const char *arguments, const char *model, const char *wanted)
{
    char line[300];
    snprintf(line, sizeof line, "%s %s", arguments, model);
    print_message("%s: %s\n", line, wanted);
    assert_int_equal(run(line), 0);
    if (*wanted == '!')
        assert_null(strstr(last.out, wanted + 1));
    else if (!strstr(last.out, wanted))
        fail_msg("%s", last.out);
}

static void pages_and_pens(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof page_cases / sizeof page_cases[0]; i++)
        expect_in_file(page_cases[i].arguments, "models/platonic/cube.off", page_cases[i].wanted);
}

static const struct {
    const char *arguments, *wanted;
} open_cases[] = {
    {"", "<g id=\"border\" inkscape:groupmode=\"layer\" inkscape:label=\"border\">"},
    {"", "<g id=\"wire\" inkscape:groupmode=\"layer\" inkscape:label=\"wire\">"},
    {"", "!id=\"outline\""},
    {"--style border:color=red", "stroke=\"#ff0000\" stroke-width=\"0.5\""},
    {"--style wire:color=blue", "stroke=\"#0000ff\" stroke-width=\"0.35\""},
    {"--style border:dash=3/1", "stroke-dasharray=\"2.5 1.5\""},
    {"--style wire:dash=3/1", "stroke-dasharray=\"2.65 1.35\""},
    {"--style border:dash=3/1 --dash real", "!stroke-dasharray"},
    {"--style border:off", "!id=\"border\""},
    {"--style border:off", "id=\"wire\""},
    {"--style wire:off", "!id=\"wire\""},
    {"--style wire:width=2 --view top --page 100x100 --margin 0", "M 1 50 L 99 50"},
    {"--style wire:width=2,off --view top --page 100x100 --margin 0", "M 1 99 L 99 99 L 99 1 Z"},
};

/* Draws with these pens off. Returns the layer of one class, or NULL if there is none; the caller frees it. */
static char *layer_of(const char *model, const char *off, const char *class)
{
    char line[600], begin[60];
    snprintf(line, sizeof line, "--order none --hidden dashed --hatch spacing=6%s %s", off, model);
    if (run(line) != 0)
        fail_msg("%s: %s", line, last.err);
    snprintf(begin, sizeof begin, "<g id=\"%s\"", class);
    const char *from = strstr(last.out, begin), *end = from ? strstr(from, "</g>") : NULL;
    return from ? strndup(from, (size_t)(end - from)) : NULL;
}

/* Drawings for one pen each fit together: whatever else is off, a class is drawn in the same way. */
static void pens_that_are_off_move_nothing(void **state)
{
    static const char *const models[] = {"models/chair.off", "--label vertices,faces models/stella-octangula.off",
                                         "--label faces models/interpenetrating-cubes.off"};
    static const char *const classes[] = {"outline", "border", "crease", "intersection",
                                          "hidden",  "hatch",  "text",   "hidden-text"};
    enum { CLASSES = sizeof classes / sizeof classes[0] };
    size_t layers = 0;
    (void)state;
    for (size_t m = 0; m < sizeof models / sizeof models[0]; m++)
        for (size_t c = 0; c < CLASSES; c++) {
            char off[400] = "";
            for (size_t k = 0; k < CLASSES; k++)
                if (k != c)
                    snprintf(off + strlen(off), sizeof off - strlen(off), " --style %s:off", classes[k]);
            char *all = layer_of(models[m], "", classes[c]), *alone = layer_of(models[m], off, classes[c]);
            if (!all != !alone || (all && strcmp(all, alone) != 0))
                fail_msg("%s: %s", models[m], classes[c]);
            layers += all != NULL;
            free(all);
            free(alone);
        }
    assert_int_equal(layers, 17);
}

/* Two blocks, one against the other, behind two posts. */
static void put_boxes(const char *path)
{
    static const int box[4][6] = {
        {0, 0, 0, 4, 1, 1}, {0, -1, 0, 2, 0, 2}, {-1, -6, -3, 2, -5, 9}, {2, -8, -3, 5, -7, 9}};
    static const int face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
    char text[2000] = "OFF\n32 24 0\n";
    for (int v = 0; v < 32; v++) {
        const int *b = box[v / 8];
        snprintf(text + strlen(text), sizeof text - strlen(text), "%d %d %d\n", b[v & 1 ? 3 : 0], b[v & 2 ? 4 : 1],
                 b[v & 4 ? 5 : 2]);
    }
    for (int f = 0; f < 24; f++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "4 %d %d %d %d\n", f / 6 * 8 + face[f % 6][0],
                 f / 6 * 8 + face[f % 6][1], f / 6 * 8 + face[f % 6][2], f / 6 * 8 + face[f % 6][3]);
    put(path, text);
}

/* A hidden line is drawn where strokes of hatching lie on it. What one body hides of an edge is an element, and so is
 * what the next one hides. */
static void hidden_elements(void **state)
{
    static const char hatched[] = "--view front --hidden dashed --hatch spacing=0.5,angle=0,direction=across "
                                  "--group element",
                      behind_two[] = "--dir 0,-3,1 --hidden dashed --union --group element";
    (void)state;
    put("hatched.off", "OFF\n12 3 0\n0 2 3\n0 2 6\n0 5 4\n0 5 3\n1 2 3\n1 2 6\n1 5 4\n1 5 3\n2 6 1\n2 6 2\n4 6 1\n"
                       "4 6 2\n4 0 1 5 4\n4 2 3 7 6\n4 8 9 11 10\n");
    expect_in_file(hatched, "hatched.off", "data-edge=\"2-6\" data-faces=\"1\" data-by=\"0\"");
    put_boxes("behind.off");
    expect_in_file(behind_two, "behind.off", "data-edge=\"4-5\" data-faces=\"1,2\" data-by=\"2\"");
    expect_in_file(behind_two, "behind.off", "data-edge=\"4-5\" data-faces=\"1,2\" data-by=\"3\"");
}

/* A triangle, and a wire through its middle. */
static void borders_and_wires(void **state)
{
    (void)state;
    put("open.off", "OFF\n5 2 0\n0 0 0\n4 0 0\n4 4 0\n0 2 1\n4 2 1\n3 0 1 2\n2 3 4\n");
    for (size_t i = 0; i < sizeof open_cases / sizeof open_cases[0]; i++)
        expect_in_file(open_cases[i].arguments, "open.off", open_cases[i].wanted);
}

/* A wire, which is face 0, and three faces about one edge. */
static void tables_name_class_and_faces(void **state)
{
    static const char *const wanted[] = {
        ",visible,-2,-1.5,2,-1.5,,crease,1,2\n", /* faces 1, 2 and 3 */
        ",visible,2,-1.5,2,2.5,,border,1,\n",
        ",visible,-2,-4.5,2,-4.5,,border,3,\n",
        ",visible,-2,5.5,2,5.5,,wire,,\n",
    };
    (void)state;
    put("book.off", "OFF\n9 4 0\n0 0 0\n4 0 0\n4 4 0\n0 -4 -1\n4 -4 -1\n0 -3 0\n4 -3 0\n0 7 0\n4 7 0\n"
                    "2 7 8\n3 0 1 2\n4 0 1 4 3\n4 0 1 6 5\n");
    assert_int_equal(run("--view top book.off -f csv"), 0);
    print_message("%s", last.out);
    for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; i++)
        assert_int_equal(strstr(last.out, wanted[i]) != NULL, 1);
    assert_int_equal(run("--view top book.off -f json"), 0);
    assert_non_null(strstr(last.out, "\"by\":null,\"class\":\"border\",\"f0\":3,\"f1\":null}"));
    put("near.off", "OFF\n6 2 0\n-1 0 0\n1 0 0\n1 20 0\n-1 20 0\n0 0 1\n0 20 1\n4 0 1 2 3\n2 4 5\n");
    assert_int_equal(run("--eye 0,-5,4 --near 8 --look-at 0,10,0 -f csv --hidden dashed near.off"), 0);
    assert_non_null(strstr(last.out, ",clipped,"));
    assert_null(strstr(last.out, ",outline,")); /* parts that the near plane removes keep their class */
    assert_null(strstr(last.out, ",crease,"));
    assert_int_equal(run("--view top models/platonic/cube.off -f csv --hidden dashed"), 0);
    assert_null(strstr(last.out, ",,\n")); /* each edge has two faces */
    assert_null(strstr(last.out, ",border,"));
}

/* How often `what` occurs in the output. */
static size_t count(const char *what)
{
    return (size_t)count_of(last.out, what);
}

static const struct {
    const char *arguments;
    size_t outlines, creases, clipped;
} class_cases[] = {
    /* an edge between two back faces is a crease, one with a face edge-on an outline */
    {"--view iso models/platonic/cube.off", 6, 6, 0},
    {"--view top models/platonic/cube.off", 12, 0, 0},
    /* the near plane removes the front, the only face toward the eye, and a part of the four edges to the back */
    {"--eye 0,-4,0 --near 3.5 models/platonic/cube.off", 4, 4 + 2 * 4, 4 + 4},
    /* from higher up the top faces the eye too */
    {"--eye 0,-4,2 --look-at 0,4,2 --near 3.5 models/platonic/cube.off", 3 + 2 * 2 + 1, 1 + 2 * 2 + 3, 4 + 4},
    /* a floor with a sheet that rises from its front edge, above it, and one that rises from its back edge, behind it
     */
    {"--eye 0,-5,1 --look-at 0,4,1 --near 8 far.off", 1, 1, 4 + 4},
};

/* Hidden rows and rows removed by the near plane have the class of the line, too. */
static void lost_lines_have_a_class(void **state)
{
    char line[300];
    (void)state;
    put("far.off", "OFF\n5 3 0\n-1 0 0\n1 0 0\n1 1 0\n-1 1 0\n0 9 3\n4 0 1 2 3\n3 0 1 4\n3 2 3 4\n");
    for (size_t i = 0; i < sizeof class_cases / sizeof class_cases[0]; i++) {
        snprintf(line, sizeof line, "-q -f csv --hidden dashed %s", class_cases[i].arguments);
        assert_int_equal(run(line), 0);
        print_message("%s\n%s", line, last.out);
        assert_int_equal(count(",outline,"), class_cases[i].outlines);
        assert_int_equal(count(",crease,"), class_cases[i].creases);
        assert_int_equal(count(",clipped,"), class_cases[i].clipped);
    }
}

/* A cube from -1 to 1, cut half a unit before its middle: the edges to the back lose the quarter in front. From an eye,
 * the point takes the place of the near distance. */
static void sections_are_cut(void **state)
{
    static const char *const views[] = {"--view cabinet", "--eye 0.1,-9,0.2 --look-at 0.1,0,0.2",
                                        "--eye 0.1,-9,0.2 --look-at 0.1,0,0.2 --near 2"};
    char line[300];
    (void)state;
    for (size_t i = 0; i < sizeof views / sizeof views[0]; i++) {
        snprintf(line, sizeof line, "%s --section 7,-0.5,9 -f csv --hidden solid models/platonic/cube.off", views[i]);
        assert_int_equal(run(line), 0);
        print_message("%s\n%s", line, last.out);
        assert_int_equal(count(",clipped,"), 8);
        assert_int_equal(count(",0.25,1,") + count(",0,0.75,"), 4);
    }
    assert_int_equal(run("--section 0,-0.5,0 --view front --hatch faces=sections -o a.svg models/platonic/cube.off"),
                     0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("--section 0,-1,0 --view front --hatch faces=sections -o a.svg models/platonic/cube.off"), 0);
    assert_non_null(strstr(last.err, "--hatch has no effect: no closed body is cut\n"));
    assert_non_null(strstr(last.err, "--section has no effect: it cuts off nothing of the scene\n"));
    /* a section that does not face the viewer: the right half is gone */
    assert_int_equal(run("--view iso --section 0.25,0,0,1,0,0 -f csv models/platonic/cube.off"), 0);
    assert_int_equal(count("\n"), 1 + 5);
    assert_int_equal(count(",0.375,1,"), 3);
    assert_int_equal(run("--eye 0,-9,0 --near 8.5 --section 0,-5,0 -o a.svg models/platonic/cube.off"), 0);
    assert_non_null(strstr(last.err, "--section has no effect"));
    /* the picture is not cut at a field of view, as near the eye */
    assert_int_equal(run("--eye 0,-1.8,0 --section 0,-0.5,0 --crop -o a.svg models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "");
    /* the eye is in the part of a solid that is cut off */
    assert_int_equal(run("--eye 0,-0.95,0 --look-at 0,1,0 --section 0,0.9,0 -o a.svg models/platonic/cube.off"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("--eye 0,-0.95,0 --look-at 0,1,0 --section 0,-0.95,0 -o a.svg models/platonic/cube.off"), 1);
}

/* Levels are counted only on request; a row that is not hidden has 0. */
static void levels_are_counted(void **state)
{
    (void)state;
    assert_int_equal(run("--view top models/platonic/cube.off -f csv --hidden dashed --columns +name,+level"), 0);
    assert_int_equal(count(",outline,0,2,,0\n") + count(",outline,0,1,,0\n"), 2);
    assert_int_equal(count(",,1\n"), 8);
    assert_int_equal(run("--view top models/platonic/cube.off -f json --hidden dashed --columns +level"), 0);
    assert_int_equal(count("\"level\":1}"), 8);
    assert_int_equal(run("--view top models/platonic/cube.off -f csv --columns +level"), 0);
    assert_int_equal(count(",0\n"), 4);
    assert_int_equal(run("models/platonic/cube.off -f csv --columns level"), 2);
    assert_int_equal(strncmp(last.err, "roberts: --columns: \"level\" is unknown; did you mean +level?", 60), 0);
}

static void put_lid_and_crumb(void)
{
    put("in/two.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 1 1 -1\nv 2 1 -1\nv 1 2 -1\no lid\nf 1 2 3\no crumb\nf 4 5 6\n");
}

/* A body and what hides it, by their names. */
static void bodies_are_named(void **state)
{
    (void)state;
    put_lid_and_crumb();
    assert_int_equal(run("--view top in/two.obj -f csv --hidden dashed --columns +by,+name"), 0);
    assert_int_equal(count(",f1,by_name,name\n"), 1);
    assert_int_equal(count(",,,lid\n"), 3);
    assert_int_equal(count(",,lid,crumb\n"), 3);
    assert_int_equal(run("--view top in/two.obj -f json --hidden dashed --columns +by"), 0);
    assert_int_equal(count(",\"by_name\":null}"), 3);
    assert_int_equal(count(",\"by_name\":\"lid\"}"), 3);
}

/* Labels from the file: of bodies that are seen and have a name; with `bodies`, the others have their numbers. */
static void bodies_are_labelled_by_name(void **state)
{
    (void)state;
    put_lid_and_crumb();
    put("in/labels.csv", "body,0,cover\n");
    assert_int_equal(run("--view bottom --text native in/two.obj --label names"), 0);
    assert_int_equal(count("<text "), 2);
    assert_int_equal(count(">lid</text>") + count(">crumb</text>"), 2);
    assert_string_equal(last.err, "");
    assert_int_equal(run("--view bottom --text native in/two.obj --labels in/labels.csv --label names"), 0);
    assert_int_equal(count(">cover</text>") + count(">crumb</text>"), 2);
    assert_int_equal(run("--view top --text native models/table.off --label bodies,names"), 0);
    assert_int_equal(count(">0</text>"), 1);
    assert_int_equal(run("--view top models/table.off --label names"), 0);
    assert_non_null(strstr(last.err, "--label names has no effect: no body has a name in the file\n"));
}

/* Lines where faces cross are no edges: rays check the others. */
static void crossing_bodies_are_verified(void **state)
{
    (void)state;
    assert_int_equal(run("-f csv models/interpenetrating-cubes.off --columns +ends"), 0);
    assert_int_equal(count(",intersection,"), 2);
    assert_non_null(strstr(last.out, ",,intersection,0,8,4,2,6,6,2,6\n"));
    assert_int_equal(run("-f null --verify models/interpenetrating-cubes.off"), 0);
    assert_non_null(strstr(last.err, "contradictions: 0"));
}

static void too_large_for_the_page(void **state)
{
    (void)state;
    assert_int_equal(run("--view top --page 100x100 --scale 1:20 --unit ft models/platonic/cube.off -o in/a.svg"), 0);
    assert_int_equal(run("--view top --page 100x100 --scale 1:2 --unit ft models/platonic/cube.off -o in/b.svg"), 2);
    assert_said("in/b.svg: at 1:2 the drawing is 305 x 305 mm and would leave the page, whose margins leave 80 x 80; "
                "1:7.62 would fit, or --page a2\n");
    assert_int_equal(run("--view top --page 100x100 --scale 1:7.62 --unit ft models/platonic/cube.off -o in/b.svg"), 0);
    assert_int_equal(entries("in", false), 2);
}

/* Options of the engine and the place of the output change no byte. */
static void description_depends_on_the_drawing_alone(void **state)
{
    static char text[TEXT];
    (void)state;
    assert_int_equal(run("models/platonic/cube.off --hidden dashed"), 0);
    strcpy(text, last.out);
    assert_int_equal(
        run("--threads 1 --grid 1 --stats=json --verify --hidden=dashed -o in/a.svg -- models/platonic/cube.off"), 0);
    read_text("in/a.svg", last.out);
    assert_string_equal(last.out, text);
    assert_int_equal(run("--turntable 2 -o in/a%d.svg models/platonic/cube.off"),
                     0); /* this needs a name with a place */
    read_text("in/a1.svg", text);
    assert_non_null(strstr(text, "<desc>roberts --turntable=2 --output=a%d.svg models/platonic/cube.off</desc>"));
}

/* A file whose name begins with a minus is no option in the command of a drawing, and messages say how to name it. */
static void names_that_begin_with_a_minus(void **state)
{
    (void)state;
    put("-x.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    assert_int_equal(run("-- -x.off"), 0);
    assert_non_null(strstr(last.out, "<desc>roberts ./-x.off</desc>"));
    assert_int_equal(run("--batch in --manifest m.jsonl -- -x.off"), 0);
    read_text("m.jsonl", last.out);
    assert_non_null(strstr(last.out, "\"command\":\"roberts ./-x.off\""));
    assert_int_equal(run("-x.off"), 2);
    assert_said("roberts: -x.off is unknown; the file of this name is ./-x.off\n");
    put("--x.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    assert_int_equal(run("--x.off"), 2);
    assert_said("roberts: --x.off is unknown; the file of this name is ./--x.off\n");
}

/* Least and greatest coordinate of the paths of an SVG, in mm. */
static void svg_box(const char *path, double low[2], double high[2])
{
    static char text[TEXT];
    read_text(path, text);
    low[0] = low[1] = 1e9;
    high[0] = high[1] = -1e9;
    const char *at = text;
    while ((at = strstr(at, " d=\"")) != NULL) {
        int axis = 0;
        for (at += 4; *at && *at != '"'; axis = 1 - axis) {
            char *end;
            at += strspn(at, "MLZ ,");
            double x = strtod(at, &end);
            if (end == at)
                break;
            low[axis] = x < low[axis] ? x : low[axis];
            high[axis] = x > high[axis] ? x : high[axis];
            at = end;
        }
    }
}

/* A box of 6 by 2 by 3, off the origin, seen from the front and the right: as wide as its sides, at one scale, about
 * the page's middle; in perspective the eye goes round and sees the opposite sides alike. */
static void turntable_keeps_scale_and_centre(void **state)
{
    double low[4][2], high[4][2];
    (void)state;
    put("box.off", "OFF\n8 6 0\n10 20 0\n16 20 0\n16 22 0\n10 22 0\n10 20 3\n16 20 3\n16 22 3\n10 22 3\n"
                   "4 0 1 2 3\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
    static const char *const views[] = {"--azimuth 0", "--eye 13,1,1.5"};
    for (size_t v = 0; v < 2; v++) {
        char line[256], name[64];
        snprintf(line, sizeof line, "%s --turntable 4 box.off -o in/t-%%02d.svg", views[v]);
        assert_int_equal(run(line), 0);
        assert_int_equal(entries("in", false), 4);
        for (int i = 0; i < 4; i++) {
            snprintf(name, sizeof name, "in/t-%02d.svg", i);
            svg_box(name, low[i], high[i]);
            assert_true(fabs(low[i][0] + high[i][0] - 210) < 0.01 && fabs(low[i][1] + high[i][1] - 297) < 0.01);
        }
        for (int i = 0; i < 2; i++)
            assert_true(fabs(high[i][0] - high[i + 2][0]) < 0.01 && fabs(high[i][1] - high[i + 2][1]) < 0.01);
        double front = high[0][0] - low[0][0], side = high[1][0] - low[1][0];
        double tall = high[0][1] - low[0][1], side_tall = high[1][1] - low[1][1];
        if (v == 0) {
            assert_true(fabs(front - 190) < 0.01 && fabs(side - 190 / 3.0) < 0.01);
            assert_true(fabs(tall - 95) < 0.01 && fabs(side_tall - 95) < 0.01);
        } else {
            /* the near faces are 19 and 17 away from the eye: 3 high */
            assert_true(fabs(side_tall / tall - 19.0 / 17) < 0.001);
        }
    }
    assert_int_equal(run("-v --azimuth 0 --turntable 2 --scale standard --unit cm box.off -o in/t-%d.svg"), 0);
    assert_int_equal(count_of(last.err, " segments at 2:1; "), 2);
    assert_int_equal(run("-v --azimuth 0 --turntable 2 --scale 1:1234567 box.off -o in/t-%d.svg"), 0);
    assert_int_equal(count_of(last.err, " segments at 1:1234567; "), 2);
    /* everything keeps 5 mm from a frame, except a field of view, which reaches to it */
    assert_int_equal(run("--azimuth 0 --turntable 2 --frame --stats=json box.off -o in/t-%d.svg"), 0);
    assert_int_equal(count_of(last.err, "\"scale\":30,"), 2);
    assert_int_equal(run("--eye 13,1,1.5 --look-at 13,2,1.5 --fov 90 --turntable 2 --frame --stats=json box.off "
                         "-o in/t-%d.svg"),
                     0);
    assert_int_equal(count_of(last.err, "\"scale\":95"), 2);
    assert_int_equal(run("--turntable 3 -f csv models/platonic/cube.off -o in/u%d"), 0);
    assert_int_equal(access("in/u0", F_OK) + access("in/u2", F_OK), 0);
}

/* An icosahedron has room for larger labels from some sides than from others. */
static void turntable_keeps_letters(void **state)
{
    static const char with[] = "--page 70x70 --margin 3 --elevation 20 --hidden dashed --label vertices --text native "
                               "models/platonic/icosahedron.off";
    static const char small[] = "font-size=\"2.514\"";
    static char text[TEXT];
    char line[256], name[64];
    (void)state;
    for (int i = 0; i < 3; i++) {
        snprintf(line, sizeof line, "%s --azimuth %d", with, 30 * i);
        assert_int_equal(run(line), 0);
        assert_int_equal(count_of(last.out, small), i == 1 ? 12 : 0);
    }
    snprintf(line, sizeof line, "%s --turntable 12 -o in/t-%%d.svg", with);
    assert_int_equal(run(line), 0);
    assert_string_equal(last.err, "");
    for (int i = 0; i < 12; i++) {
        snprintf(name, sizeof name, "in/t-%d.svg", i);
        read_text(name, text);
        assert_int_equal(count_of(text, small), 12);
    }
    assert_int_equal(run("--scale 1000:1 --label vertices models/platonic/cube.off --turntable 2 -o in/t-%d.svg"), 2);
    assert_said("in/t-0.svg: at 1000:1 the drawing is ");
}

static void batch_draws_each_file(void **state)
{
    static char text[TEXT];
    (void)state;
    put("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n");
    assert_int_equal(run("--batch in/new/sub bad.off models/table.off missing.off models/platonic/cube.off"), 1);
    const char *first = strstr(last.err, "roberts: bad.off:6: "), *second = strstr(last.err, "roberts: missing.off: ");
    assert_true(first == last.err && second > first);
    assert_said("roberts: missing.off: No such file or directory\nroberts: 2 of 4 models were not drawn\n");
    assert_int_equal(run("models/table.off -o in/a.svg"), 0);
    read_text("in/a.svg", text);
    read_text("in/new/sub/table.svg", last.out);
    assert_string_equal(last.out, text);
    assert_int_equal(access("in/new/sub/cube.svg", F_OK), 0);
    assert_int_equal(entries("in/new/sub", true), 2);
    assert_int_equal(run("--batch in/new/sub -f csv --threads 2 -v models/table.off models/platonic/cube.off"), 0);
    first = strstr(last.err, "in/new/sub/table.csv: ");
    assert_true(first && strstr(first, "in/new/sub/cube.csv: "));
    assert_int_equal(entries("in/new/sub", true), 2);
    assert_int_equal(run("--batch in/new/sub -f null -v bad.off models/table.off"), 1);
    assert_int_equal(count_of(last.err, "not drawn") + 2 * count_of(last.err, " 1 failed; "), 2);
    assert_int_equal(run("--batch in/new/sub -f null -q bad.off models/table.off"), 1);
    assert_int_equal(count_of(last.err, "roberts: "), 1);
    assert_int_equal(run("--batch in/new/sub -f null bad.off"), 1);
    assert_int_equal(count_of(last.err, "roberts: "), 1);
    assert_int_equal(run("--batch in/new/sub -f null models/table.off"), 0);
    assert_int_equal(entries("in/new/sub", false), 0);
    assert_int_equal(rmdir("in/new/sub"), 0);
    assert_int_equal(rmdir("in/new"), 0);
    assert_int_equal(run("--batch in --threads 1025 models/table.off"), 2);
    assert_said("roberts: --threads: 1025 is out of range: from 0 to 1024\n");
    assert_int_equal(run("--batch bad.off/new models/table.off"), 1);
    assert_said("roberts: bad.off/new: cannot make the folder: Not a directory");
}

static void verbose_tells(void **state)
{
    (void)state;
    assert_int_equal(run("-v models/platonic/cube.off -o in/a.svg"), 0);
    assert_said("roberts: models/platonic/cube.off: 1 body, 8 vertices, 6 faces; ");
    assert_said("roberts: in/a.svg: 9 segments; ");
}

/* Reads a model that comes after `wait_ms`, with standard error as given. */
static void run_slowly(const char *line, int error, long wait_ms)
{
    static char text[TEXT];
    const struct timespec wait = {wait_ms / 1000, wait_ms % 1000 * 1000000};
    int ends[2];
    read_text("models/platonic/cube.off", text);
    assert_int_equal(pipe(ends), 0);
    char in[32];
    snprintf(in, sizeof in, "/dev/fd/%d", ends[0]);
    start_error = error;
    pid_t child = start(line, in, -1);
    start_error = -1;
    nanosleep(&wait, NULL);
    assert_int_equal(write(ends[1], text, strlen(text)), strlen(text));
    close(ends[0]);
    close(ends[1]);
    finish(child);
}

/* Reads from a terminal until nothing more comes for a while: the system delivers text in pieces, with delay. */
static void read_terminal(int terminal, char *text, size_t size)
{
    struct pollfd wait = {.fd = terminal, .events = POLLIN};
    size_t used = 0;
    while (used + 1 < size && poll(&wait, 1, 200) > 0 && (wait.revents & POLLIN)) {
        ssize_t count = read(terminal, text + used, size - 1 - used);
        if (count <= 0)
            break;
        used += (size_t)count;
    }
    text[used] = '\0';
}

static void progress_is_for_terminals(void **state)
{
    static char text[TEXT];
    (void)state;
    int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0)
        SKIP_BECAUSE("no terminal can be opened");
    int side = open(ptsname(terminal), O_RDWR | O_NOCTTY);
    assert_true(side >= 0);
    run_slowly("-", side, 1300);
    assert_int_equal(last.status, 0);
    read_terminal(terminal, text, sizeof text);
    assert_non_null(strstr(text, "roberts: reading, 1 s"));
    assert_int_equal(text[strlen(text) - 1], '\r'); /* and the line is blank again */
    assert_int_equal(text[strlen(text) - 2], ' ');
    assert_null(strchr(text, '\033'));
    run_slowly("-q -", side, 1300);
    read_terminal(terminal, text, sizeof text);
    assert_string_equal(text, "");
    run_slowly("-", side, 0); /* fast */
    read_terminal(terminal, text, sizeof text);
    assert_string_equal(text, "");
    run_slowly("-", -1, 1300); /* into a file */
    assert_string_equal(last.err, "");
    close(side);
    close(terminal);
}

static void outputs_that_fail(void **state)
{
    (void)state;
    assert_int_equal(run_into("models/table.off", "/dev/full"), 1);
    assert_string_equal(last.err, "roberts: standard output: cannot write: No space left on device\n");
    assert_int_equal(run_into("--help", "/dev/full"), 1);
    assert_said("No space left on device");
    start_error = open("/dev/full", O_WRONLY); /* statistics are written to standard error */
    assert_int_equal(run("-f null --stats models/table.off"), 1);
    assert_int_equal(run("-f null --verify models/table.off"), 1);
    assert_int_equal(run("-f null models/table.off"), 0);
    close(start_error);
    start_error = -1;
    assert_int_equal(run("models/table.off -o /dev/full -f svg"), 1);
    assert_string_equal(last.err, "roberts: /dev/full: cannot write: No space left on device\n");
    assert_int_equal(run("models/table.off -o missing/a.svg"), 1);
    assert_string_equal(last.err, "roberts: missing/a.svg: cannot write: No such file or directory\n");
    assert_int_equal(run("models/table.off --turntable 2 -o in/%d/"), 1);
    assert_string_equal(last.err, "roberts: in/0/: cannot write: Is a directory\n");
    finish(start("models/table.off", NULL, CLOSED));
    assert_int_equal(last.status, 1);
    assert_said("roberts: standard output: cannot write: Bad file descriptor\n");
    assert_int_equal(entries("in", false), 0);
}

/* Formats that Cairo draws are refused where it cannot be loaded. The others do not need it. */
static void some_formats_need_cairo(void **state)
{
    static const char *const format[] = {"png", "ps", "eps"};
    (void)state;
    put("in/libcairo.so.2", "broken");
    setenv("LD_LIBRARY_PATH", "in", 1);
    for (size_t i = 0; i < sizeof format / sizeof format[0]; i++) {
        char line[80];
        snprintf(line, sizeof line, "models/table.off -o in/a.%s", format[i]);
        assert_int_equal(run(line), 1);
        assert_said("roberts: in/a.");
        assert_said("PNG, PS and EPS are drawn by Cairo: ");
        assert_said("libcairo.so.2");
    }
    assert_int_equal(entries("in", false), 1);
    assert_int_equal(run("models/table.off -o in/a.svg -o in/a.pdf"), 0);
    unsetenv("LD_LIBRARY_PATH");
    assert_int_equal(run("models/table.off -o in/a.png"), 0);
}

/* A reader that stops early, like head(1), is no error to report, unless the caller ignores the signal. */
static void closed_pipe_ends_quietly(void **state)
{
    int ends[2];
    (void)state;
    assert_int_equal(pipe(ends), 0);
    close(ends[0]);
    finish(start("models/table.off", NULL, ends[1]));
    assert_int_equal(last.status, 1000 + SIGPIPE);
    assert_string_equal(last.err, "");
    finish(start("--help", NULL, ends[1]));
    assert_int_equal(last.status, 1000 + SIGPIPE);
    start_pipe_signal = SIG_IGN;
    finish(start("models/table.off", NULL, ends[1]));
    start_pipe_signal = SIG_DFL;
    close(ends[1]);
    assert_int_equal(last.status, 1);
    assert_string_equal(last.err, "roberts: standard output: cannot write: Broken pipe\n");
}

static void standard_output_by_name(void **state)
{
    static char text[TEXT];
    (void)state;
    assert_int_equal(run("models/platonic/cube.off"), 0);
    strcpy(text, last.out);
    int out = open_stream("out", O_WRONLY | O_TRUNC);
    assert_int_equal(write(out, "before\n", 7), 7);
    finish(start("models/platonic/cube.off -o /dev/stdout", NULL, out));
    close(out);
    assert_int_equal(last.status, 0);
    assert_int_equal(strncmp(last.out, "before\n", 7), 0);
    assert_string_equal(last.out + 7, text);
}

/* ---- what it tells ---- */

static void tells_version_and_help(void **state)
{
    (void)state;
    assert_int_equal(run("--version"), 0);
    assert_int_equal(strncmp(last.out, "roberts 0.", 10), 0);
    assert_int_equal(run("-h"), 0);
    assert_int_equal(strncmp(last.out, "Usage: roberts ", 15), 0);
    for (char *line = strtok(last.out, "\n"); line; line = strtok(NULL, "\n"))
        assert_true(strlen(line) <= 120);
}

/* Every line of the help's examples, as a shell takes it. */
static void examples_of_the_help_run(void **state)
{
    static char text[TEXT], command[8192];
    int count = 0;
    (void)state;
    assert_int_equal(run("--help"), 0);
    strcpy(text, last.out);
    char *line = strstr(text, "\nExamples\n");
    assert_non_null(line);
    for (line = strtok(line + 10, "\n"); line; line = strtok(NULL, "\n"), count++) {
        assert_int_equal(strncmp(line, "  roberts ", 10), 0);
        snprintf(command, sizeof command, "'%s' %s 2>err", program, line + 10);
        print_message("%s\n", line);
        assert_int_equal(system(command), 0);
        char *name = strstr(line, " table.") ? strstr(line, " table.") + 1 : strstr(line, ">table.");
        if (name) {
            read_text(name + (*name == '>'), last.out);
            assert_true(strlen(last.out) > 100);
            unlink(name + (*name == '>'));
        }
    }
    assert_true(count >= 4);
    assert_int_equal(access("turn-000.svg", F_OK), 0);
    assert_int_equal(access("turn-003.svg", F_OK), 0);
    assert_int_equal(entries("drawings", false), 2);
}

static void statistics(void **state)
{
    (void)state;
    assert_int_equal(run("-f null --stats models/platonic/cube.off"), 0);
    assert_said("1  bodies\n");
    assert_said("12  edges\n");
    assert_said("epsilon");
    assert_said("  hide\n");
    assert_null(strstr(last.err, "strokes")); /* no page, no pen */
    assert_null(strstr(last.err, "pieces"));  /* convex faces are whole */
    assert_int_equal(run("-v -f null --stats models/star/pentagrammic-prism.off"), 0);
    assert_said("models/star/pentagrammic-prism.off: 1 body, 10 vertices, 7 faces; ");
    assert_said("models/star/pentagrammic-prism.off: bodies: 1 closed but not convex\n");
    assert_said("10  vertices\n");
    assert_said("7  faces\n");
    assert_said("17  convex pieces of them\n"); /* a pentagon and five points for each pentagram */
    assert_said("15  edges\n");
    assert_said("35  parts of them, and cuts between pieces\n"); /* a pentagram's side is three */
    assert_int_equal(run("-f null --stats=json models/star/pentagrammic-prism.off"), 0);
    assert_said("\"vertices\":10,\"faces\":7,\"pieces\":17,\"front_faces\":");
    assert_said("\"edges\":15,\"edge_parts\":35,\"surviving_edges\":");
    assert_int_equal(run("-f null --stats models/shapes/moebius-strip.off"), 0);
    assert_said("48  faces\n"); /* none of them planar: two triangles each */
    assert_said("96  convex pieces of them\n");
    assert_said("144  edges\n");
    assert_int_equal(run("-o in/a.svg --stats --view top --page 100x100 models/platonic/cube.off"), 0);
    assert_said("1  strokes\n");
    assert_said("320.0  mm with the pen down\n");
    assert_said("0.0  mm with the pen up\n");
    assert_said("40  mm on paper per model unit\n");
    assert_int_equal(run("-o in/a.svg --stats=json --view top --page 100x100 models/platonic/cube.off"), 0);
    assert_said("\"strokes\":1,\"pen_down_mm\":320.000,\"pen_up_mm\":0.000,\"scale\":40,\"origin_mm\":[50,50],");
    assert_int_equal(run("-f null -q --stats=json models/platonic/cube.off"), 0);
    assert_int_equal(strncmp(last.err, "{\"version\":\"0.", 14), 0);
    assert_string_equal(last.err + strlen(last.err) - 3, "}}\n");
    assert_said("\"solids\":1,");
    assert_said("\"segments\":9,");
    assert_said("\"test1_visible\":");
    assert_said("\"hide\":{\"cpu\":");
    int depth = 0, quotes = 0;
    for (const char *at = last.err; *at; at++) {
        depth += (*at == '{') - (*at == '}');
        quotes += *at == '"';
        assert_true(depth > 0 || strcmp(at, "}\n") == 0 || *at == '\n');
    }
    assert_true(depth == 0 && quotes % 2 == 0);
}

/* All views of a sheet are counted: for a cube, three show 4 edges and the isometric one shows 9. */
static void sheets(void **state)
{
    static char text[TEXT];
    (void)state;
    assert_int_equal(run("--sheet first -o in/a.svg --stats=json --page 150x100 models/platonic/cube.off"), 0);
    assert_said("\"views\":4,");
    assert_said("\"solids\":4,");
    assert_said("\"vertices\":32,");
    assert_said("\"faces\":24,\"front_faces\":6,\"back_faces\":6,\"edge_on_faces\":12,");
    assert_said("\"segments\":21,");
    assert_int_equal(run("--sheet first -f null --stats models/platonic/cube.off"), 0);
    assert_said("4  views, counted together\n");
    assert_int_equal(run("-f null --stats models/platonic/cube.off"), 0);
    assert_null(strstr(last.err, "views"));
    read_text("in/a.svg", text);
    assert_int_equal(run("--sheet first --batch in --page 150x100 models/platonic/cube.off"), 0);
    read_text("in/cube.svg", last.out);
    assert_string_equal(last.out, text);
}

/* The rows of one table for the whole sheet are those of the tables of its views, in their order. */
static void views_have_tables_of_their_own(void **state)
{
    static const char *const view[] = {"front", "top", "left", "iso"};
    static const char options[] = "--sheet first --columns +depth --hidden solid models/platonic/cube.off";
    static char whole[TEXT], own[TEXT];
    char command[200], name[40];
    (void)state;
    snprintf(command, sizeof command, "-o in/all.csv %s", options);
    assert_int_equal(run(command), 0);
    snprintf(command, sizeof command, "-o in/of-%%s.csv %s", options);
    assert_int_equal(run(command), 0);
    assert_string_equal(last.err, "");
    read_text("in/all.csv", whole);
    assert_memory_equal(whole, "view,", 5);
    const char *row = whole + 5;
    for (size_t i = 0; i < sizeof view / sizeof view[0]; i++) {
        snprintf(name, sizeof name, "in/of-%s.csv", view[i]);
        read_text(name, own);
        if (i == 0) { /* the head */
            assert_memory_equal(own, row, strcspn(row, "\n") + 1);
            row += strcspn(row, "\n") + 1;
        }
        for (const char *at = strchr(own, '\n') + 1; *at; at = strchr(at, '\n') + 1) {
            const size_t length = strcspn(at, "\n") + 1, word = strlen(view[i]);
            assert_memory_equal(row, view[i], word);
            assert_int_equal(row[word], ',');
            assert_memory_equal(row + word + 1, at, length);
            row += word + 1 + length;
        }
    }
    assert_string_equal(row, "");
    snprintf(command, sizeof command, "-o in/of-%%s.json %s", options);
    assert_int_equal(run(command), 0);
    read_text("in/of-left.json", own);
    assert_memory_equal(own, "[\n{\"body\":0,", 12);
}

static void warnings_can_be_silenced(void **state)
{
    (void)state;
    put("w.off", "OFF\n4 6 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n1 0\n0\n");
    assert_int_equal(run("w.off"), 0);
    assert_said("roberts: w.off:");
    assert_said("warning: ");
    assert_int_equal(run("--quiet w.off"), 0);
    assert_string_equal(last.err, "");
}

/* ---- interrupted ---- */

/* A flat field of cubes: large enough for the drawing to take a while. */
static void write_field(const char *path, int side)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "OFF\n%d %d 0\n", side * side * 8, side * side * 6);
    for (int i = 0; i < side * side * 8; i++)
        fprintf(file, "%d %d %d\n", i / 8 % side * 2 + i % 2, i / 8 / side * 2 + i / 2 % 2, i / 4 % 2);
    for (int i = 0; i < side * side; i++) {
        static const int corner[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        for (int f = 0; f < 6; f++)
            fprintf(file, "4 %d %d %d %d\n", 8 * i + corner[f][0], 8 * i + corner[f][1], 8 * i + corner[f][2],
                    8 * i + corner[f][3]);
    }
    fclose(file);
}

/* Interrupts while the unfinished file exists; false if the program was faster. */
static bool interrupted(int number)
{
    const struct timespec moment = {0, 200000};
    pid_t child = start("field.off --hidden solid -o in/a.json", NULL, -1);
    bool seen = false;
    for (int i = 0; i < 100000 && !seen; i++) {
        seen = entries("in", false) == 2; /* the old file and the unfinished one */
        if (!seen && waitpid(child, NULL, WNOHANG) == child)
            return false;
        nanosleep(&moment, NULL);
    }
    kill(child, number);
    finish(child);
    return seen && last.status == 1000 + number;
}

static void interruption_leaves_no_partial_file(void **state)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    (void)state;
    write_field("field.off", 100);
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
        bool done = false;
        for (int attempt = 0; attempt < 10 && !done; attempt++) {
            put("in/a.json", "old");
            done = interrupted(signals[i]);
            assert_int_equal(entries("in", false), 1);
        }
        assert_true(done);
        read_text("in/a.json", last.out);
        assert_string_equal(last.out, "old");
    }
}

static void locale_changes_nothing(void **state)
{
    static char text[TEXT];
    (void)state;
    assert_int_equal(run("--dir 0.5,-0.25,0.125 models/platonic/cube.off --stats"), 0);
    strcpy(text, last.out);
    setenv("LC_ALL", "de_DE.UTF-8", 1);
    assert_int_equal(run("--dir 0.5,-0.25,0.125 models/platonic/cube.off --stats"), 0);
    unsetenv("LC_ALL");
    assert_string_equal(last.out, text);
}

/* ---- bodies as one ---- */

static size_t lines_of(const char *text)
{
    size_t lines = 0;
    for (; *text; text++)
        lines += *text == '\n';
    return lines;
}

/* Two cubes side by side: of the one seven edges are seen, of the other nine. As one they are a
 * bar, with nine visible edges, of which three are in two parts. */
static void draws_bodies_as_one(void **state)
{
    (void)state;
    put("two.off", "OFF 16 12 0\n"
                   "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
                   "1 0 0\n2 0 0\n1 1 0\n2 1 0\n1 0 1\n2 0 1\n1 1 1\n2 1 1\n"
                   "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"
                   "4 8 10 11 9\n4 12 13 15 14\n4 8 9 13 12\n4 10 14 15 11\n4 8 12 14 10\n4 9 11 15 13\n");
    assert_int_equal(run("-f csv two.off"), 0);
    assert_int_equal(lines_of(last.out), 1 + 16);
    assert_int_equal(run("--union --stats -f csv two.off"), 0);
    assert_int_equal(lines_of(last.out), 1 + 12);
    assert_non_null(strstr(last.err, " 6  edges left out, or parts of them, where bodies are one\n"));
    assert_int_equal(run("--union --stats=json --verify -f null two.off"), 0);
    assert_non_null(strstr(last.err, "\"seams\":6,"));
    assert_int_equal(run("--stats=json -f null two.off"), 0);
    assert_null(strstr(last.err, "seams"));
}

/* ---- rays ---- */

/* Three solids with notches. The hulls of two of them have faces in one plane, and the third one crosses it. */
static const char notched[] =
    "OFF\n36 24 0\n1 0 1\n1 0 3\n2 0 3\n2 0 2\n3 0 2\n3 0 1\n1 2 1\n1 2 3\n2 2 3\n2 2 2\n3 2 2\n3 2 1\n1 0 2\n"
    "1 2 2\n1 2 3\n1 1 3\n1 1 4\n1 0 4\n3 0 2\n3 2 2\n3 2 3\n3 1 3\n3 1 4\n3 0 4\n1 1 1\n3 1 1\n3 2 1\n2 2 1\n"
    "2 3 1\n1 3 1\n1 1 2\n3 1 2\n3 2 2\n2 2 2\n2 3 2\n1 3 2\n6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n4 0 1 7 6\n"
    "4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n4 5 0 6 11\n6 17 16 15 14 13 12\n6 18 19 20 21 22 23\n"
    "4 12 13 19 18\n4 13 14 20 19\n4 14 15 21 20\n4 15 16 22 21\n4 16 17 23 22\n4 17 12 18 23\n"
    "6 29 28 27 26 25 24\n6 30 31 32 33 34 35\n4 24 25 31 30\n4 25 26 32 31\n4 26 27 33 32\n4 27 28 34 33\n"
    "4 28 29 35 34\n4 29 24 30 35\n";

static void checks_by_rays(void **state)
{
    unsigned points, more, segments;
    (void)state;
    assert_int_equal(run("--verify -f csv models/table.off"), 0);
    assert_int_equal(
        sscanf(last.err, "roberts: verify: %u points of %u segments checked; contradictions: 0,", &points, &segments),
        2);
    assert_true(segments > 10 && points > segments);
    assert_int_equal(strncmp(last.out, "body,v0,v1,", 11), 0);
    assert_int_equal(run("--verify=11 -f null models/table.off"), 0);
    assert_int_equal(sscanf(last.err, "roberts: verify: %u points", &more), 1);
    assert_true(more >= points + 8 * segments);
    assert_int_equal(run("--verify --all-edges --hidden solid -f null models/sphere.off"), 0);
    assert_int_equal(run("--verify --crease 45 --quiet -f null models/sphere.off"), 0);
    assert_int_equal(sscanf(last.err, "roberts: verify: %u points", &points), 1); /* a report is no warning */
    assert_null(strstr(last.err, "warning"));
    put("notched.off", notched);
    assert_int_equal(run("--hull --dir 1,2,3 --verify --quiet -f null notched.off"), 0);
    assert_int_equal(sscanf(last.err, "roberts: verify: %u points", &points), 1);
}

static void picks(void **state)
{
    (void)state;
    assert_int_equal(run("--pick 2.5,-2 --view top -f null models/cube-behind-cube.off"), 0);
    assert_string_equal(last.err, "roberts: pick 2.5,-2: body 0, face 0, depth 2.5, at 2,1.5,4\n");
    assert_int_equal(run("--pick -1e6,0 -f null models/cube-behind-cube.off"), 0);
    assert_string_equal(
        last.err,
        "roberts: pick -1000000,0: nothing is there; the picture reaches from -3.53553,-4.49073 to 3.53553,4.49073\n");
    put("two.off", "OFF\n8 8 0\n0 0 0\n6 0 0\n0 6 0\n0 0 6\n0 0 -9\n6 0 -9\n0 6 -9\n0 0 -3\n"
                   "3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n3 4 5 6\n3 4 5 7\n3 4 6 7\n3 5 6 7\n");
    /* middle of the box: 3, 3, -1.5; (1, 1) lies below the slanting faces at z = 4 and z = -5 */
    assert_int_equal(run("--pick -2,-2 --view top -f null two.off"), 0);
    assert_string_equal(last.err, "roberts: pick -2,-2: body 0, face 3, depth 5.5, at 1,1,4\n"
                                  "roberts: pick -2,-2: behind it body 1, face 7, depth -3.5, at 1,1,-5\n");
}

/* The visible regions of faces, beside the drawing. */
static void regions(void **state)
{
    (void)state;
    put("plate.off", "COFF\n4 1 0\n0 0 0\n4 0 0\n4 2 0\n0 2 0\n4 0 1 2 3 1 0 0.5 1\n");
    assert_int_equal(run("--view top -f null --regions - plate.off"), 0);
    assert_string_equal(last.out, "[\n{\"body\":0,\"face\":0,\"area\":8,\"z0\":0,\"z1\":0,\"color\":[1,0,0.5,1],"
                                  "\"rings\":[[[-2,-1],[2,-1],[2,1],[-2,1]]]}\n]\n");
    assert_int_equal(run("--view top -o plate.svg --regions plate.json plate.off"), 0);
    assert_int_equal(run("--view top --regions - plate.off"), 2);
    assert_int_equal(run("--view top --fill model --style border:off plate.off"), 0);
    assert_string_equal(last.err, ""); /* it is filled, and so not empty */
    assert_non_null(strstr(last.out, "<path fill=\"#ff0080\" d=\"M"));
    assert_int_equal(run("--view top --fill black --label faces plate.off"), 0); /* plates do not catch the pointer */
    assert_non_null(strstr(last.out, "<g class=\"plate\" pointer-events=\"none\">\n<path fill=\"#ffffff\" d=\"M"));
    assert_int_equal(run("--fill model -o a.svg models/table.off"), 0);
    assert_non_null(strstr(last.err, "--fill model has no effect: no face that is seen has a colour\n"));
    assert_int_equal(run("--hatch on --light 0,0,1 --view top --style outline:off -o a.svg plate.off"), 0);
    assert_non_null(strstr(last.err, "--hatch has no effect: the light falls straight on all faces that are seen\n"));
    assert_int_equal(run("--hatch on --light 1,0,1 --view top --style border:off -o a.svg plate.off"), 0);
    assert_string_equal(last.err, ""); /* it is hatched, and so not empty */
    put("plate.obj", "v 0 0 0\nv 4 0 0\nv 4 2 0\nf 1 2 3\n");
    assert_int_equal(run("--fill model -o a.svg plate.obj"), 0);
    assert_non_null(strstr(last.err, "--fill model has no effect: no face that is seen has a colour (those of an OBJ "
                                     "are in the .mtl files beside it that it names)\n"));
    put("bare.obj", "mtllib c:/x/ba\x7fre.mtl\nv 0 0 0\nv 4 0 0\nv 4 2 0\nusemtl red\nf 1 2 3\n");
    assert_int_equal(run("--fill model -o a.svg bare.obj"), 0);
    assert_string_equal(last.err, "roberts: bare.obj: warning: --fill model has no effect: no face that is seen has a "
                                  "colour, since there is no file ba?re.mtl\n");
    assert_int_equal(run("--fill shade -o a.svg bare.obj"), 0);
    assert_string_equal(last.err,
                        "roberts: bare.obj: warning: --fill shade is grey: no face that is seen has a colour, "
                        "since there is no file ba?re.mtl\n");
    assert_int_equal(run("--fill shade -o a.svg plate.obj"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("-o a.svg bare.obj"), 0);
    assert_string_equal(last.err, "");
    assert_int_equal(run("-v -f null bare.obj"), 0);
    assert_said("roberts: bare.obj: colours are missing, since there is no file ba?re.mtl\n");
    assert_int_equal(run("--fill shade:pink -o a.svg models/table.off"), 2);
    assert_int_equal(run("--light 0,0,0 -o a.svg models/table.off"), 2);
    assert_int_equal(run("--view top -f null --regions plate.csv plate.off"), 0);
    read_text("plate.csv", last.out);
    assert_string_equal(last.out, "body,face,area,z0,z1,color,polygon\n0,0,8,0,0,1 0 0.5 1,"
                                  "\"MULTIPOLYGON (((-2 -1,2 -1,2 1,-2 1,-2 -1)))\"\n");
    put("tinted.off", "COFF\n4 1 0\n0 0 0\n4 0 0\n4 2 0\n0 2 0\n4 0 1 2 3 0.1 0.2 0.333333 0.0625\n");
    assert_int_equal(run("--view top -f null --regions - tinted.off"), 0); /* kept as 32-bit floats */
    assert_non_null(strstr(last.out, ",\"color\":[0.1,0.2,0.333333,0.0625],"));
    assert_int_equal(run("--eye 1,1,1 --look-at 3,1,0.5 -f null --regions - plate.off"), 0); /* the near plane cuts */
}

/* Where the picture of the last run lies on the page, and its scale: what --stats=json says of them. */
static void read_place(double place[3])
{
    const char *at = strstr(last.err, "\"scale\":");
    assert_non_null(at);
    assert_int_equal(sscanf(at, "\"scale\":%lf,\"origin_mm\":[%lf,%lf]", &place[0], &place[1], &place[2]), 3);
}

/* A cube of side 2 about 0,0,0, and a tower on it: the picture's 0,0 is the middle of what is drawn. */
static void steps_have_one_place(void **state)
{
    static const char *const views[] = {"--view front", "--eye 9,-20,8 --look-at 0,0,2", "--view front --scale 10",
                                        "--view front --align bottom-left"};
    (void)state;
    put("tower.off", "OFF\n8 6 0\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n-1 -1 9\n1 -1 9\n1 1 9\n-1 1 9\n"
                     "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
    for (size_t i = 0; i < sizeof views / sizeof views[0]; i++) {
        char line[200];
        double step[3], whole[3];
        print_message("%s\n", views[i]);
        snprintf(line, sizeof line, "-q %s --stats=json -o in/a.svg models/platonic/cube.off tower.off", views[i]);
        assert_int_equal(run(line), 0);
        read_place(whole);
        snprintf(line, sizeof line, "-q %s --stats=json -o in/a.svg --room-for tower.off models/platonic/cube.off",
                 views[i]);
        assert_int_equal(run(line), 0);
        read_place(step);
        const double down = i == 1 ? 0.0 : 4.0 * whole[0]; /* from the middle of the whole to that of the cube */
        assert_true(fabs(step[0] - whole[0]) < 1e-9);
        assert_true(fabs(step[1] - whole[1]) < 1e-9 && fabs(step[2] - whole[2] - down) < 1e-9);
    }
    assert_int_equal(run("-o in/b.svg --room-for nowhere.off models/platonic/cube.off"), 1);
    assert_said("roberts: nowhere.off: No such file or directory\n");
    assert_int_equal(access("in/b.svg", F_OK), -1);
    assert_int_equal(rename("tower.off", "tower"), 0);
    assert_int_equal(run("-o tower --room-for tower models/platonic/cube.off"), 2);
    assert_said("roberts: --output: tower is a file of --room-for; the drawing would take its place\n");
    assert_int_equal(run("-f pdf -o in/a.pdf --eye 9,9,9 --fov 9 --room-for tower models/platonic/cube.off"), 0);
    assert_said("warning: --room-for has no effect: --fov says what the picture holds\n");
    assert_int_equal(run("-o in/a.svg --crop --eye 0,-1.5,0 --near 0.6 --room-for tower models/platonic/cube.off"), 0);
    assert_said("warning: --room-for has no effect: the near plane cuts the scene close to the eye\n");
    assert_said("warning: --crop has no effect: the near plane cuts the scene close to the eye\n");
    put("points", "OFF\n1 0 0\n0 0 0\n");
    assert_int_equal(run("-o in/a.svg --room-for points models/platonic/cube.off"), 0);
    assert_said("roberts: points: warning: --room-for has no effect: there is no face in it\n");
}

int main(void)
{
    if (!program_find())
        return 1;
    const struct CMUnitTest tests[] = {
        IN_FOLDER(misuse),
        IN_FOLDER(failing_input),
        IN_FOLDER(output_goes_where_it_should),
        IN_FOLDER(options_reach_the_library),
        IN_FOLDER(angles_are_views),
        IN_FOLDER(pages_and_pens),
        IN_FOLDER(hidden_elements),
        IN_FOLDER(borders_and_wires),
        IN_FOLDER(pens_that_are_off_move_nothing),
        IN_FOLDER(lost_lines_have_a_class),
        IN_FOLDER(sections_are_cut),
        IN_FOLDER(levels_are_counted),
        IN_FOLDER(bodies_are_named),
        IN_FOLDER(bodies_are_labelled_by_name),
        IN_FOLDER(crossing_bodies_are_verified),
        IN_FOLDER(tables_name_class_and_faces),
        IN_FOLDER(too_large_for_the_page),
        IN_FOLDER(description_depends_on_the_drawing_alone),
        IN_FOLDER(names_that_begin_with_a_minus),
        IN_FOLDER(turntable_keeps_scale_and_centre),
        IN_FOLDER(turntable_keeps_letters),
        IN_FOLDER(batch_draws_each_file),
        IN_FOLDER(verbose_tells),
        IN_FOLDER(progress_is_for_terminals),
        IN_FOLDER(outputs_that_fail),
        IN_FOLDER(some_formats_need_cairo),
        IN_FOLDER(closed_pipe_ends_quietly),
        IN_FOLDER(standard_output_by_name),
        IN_FOLDER(tells_version_and_help),
        IN_FOLDER(examples_of_the_help_run),
        IN_FOLDER(statistics),
        IN_FOLDER(sheets),
        IN_FOLDER(views_have_tables_of_their_own),
        IN_FOLDER(warnings_can_be_silenced),
        IN_FOLDER(interruption_leaves_no_partial_file),
        IN_FOLDER(locale_changes_nothing),
        IN_FOLDER(draws_bodies_as_one),
        IN_FOLDER(checks_by_rays),
        IN_FOLDER(picks),
        IN_FOLDER(steps_have_one_place),
        IN_FOLDER(regions),
    };
    return cmocka_run_group_tests_name("cli", tests, NULL, NULL);
}
