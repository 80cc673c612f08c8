/* option_table.c - the options, one row each, in the order in which --help and the manual page name them. */
#include <float.h>
#include <stddef.h>

#include "cli/options.h"
#include "cli/values.h"

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

/* Where a value goes, and the range of a number. */
#define TO(member) .field = offsetof(cli_options, member)
#define RANGE(low, high) .least = (low), .most = (high)

const option_title option_titles[OPTION_GROUPS] = {
    [GROUP_OUTPUT] = {"Output", NULL, NULL},
    [GROUP_BATCH] = {"Batches", "many drawings in one run", NULL},
    [GROUP_PARTS] =
        {"Parts of a drawing", "give the options for the drawing to each of the three",
         "A scene that is too large for one machine is drawn in parts, each by a process of its own, and "
         "the parts are joined. The drawing is the same, byte for byte, as that of one run. Give the options "
         "for the drawing to each command: parts of different views are not joined. All bodies have to be "
         "closed, and share no vertices. Open bodies, --hull, --fill, --hatch, labels of faces and bodies, "
         "and a near plane that cuts the scene need the whole, and are refused."},
    [GROUP_PAGE] = {"Page", "lengths in mm, or with a unit: cm, in or pt, as in 8.5x11in; pens too",
                    "Lengths on paper are in mm, or have a unit: mm, cm, in or pt (1/72 inch; TeX's is 1/72.27), as in "
                    "8.5x11in. This holds for pens too: width=0.8pt."},
    [GROUP_LINES] = {"Lines", NULL, NULL},
    [GROUP_TEXT] = {"Text", "UTF-8", "Text is UTF-8."},
    [GROUP_VIEW] =
        {"View", NULL,
         "A view is given by --view, by --dir, by --eye, or by --azimuth and --elevation. --up and --roll go "
         "with each of them."},
    [GROUP_ENGINE] = {"Engine", "0: choose", "0 lets the program choose."},
    [GROUP_MESSAGES] = {"Messages", NULL, NULL},
};

static const option rows[] = {
    /* ---- output ---- */
    {.group = GROUP_OUTPUT,
     .name = "output",
     .letter = 'o',
     .flags = OPTION_FILE,
     .value = "FILE",
     .set = values_set_text,
     TO(output),
     .brief = "where to",
     .help = "the file to write (default: -, standard output)",
     .manual = "The file to write. Default: -, standard output. A file appears whole or not at all: it gets its name "
               "when all of it is written."},
    {.group = GROUP_OUTPUT,
     .name = "format",
     .letter = 'f',
     .value = "FORMAT",
     .words = values_formats,
     .set = values_set_format,
     .brief = "format",
     .help = "svg, pdf, ps, eps, png, tikz, dxf, hpgl, csv, json, or null: compute, write nothing (default: by the "
             "ending of FILE, else svg)",
     .manual = "svg, pdf, ps, eps, png, tikz, dxf, hpgl, csv, json, or null, which computes and writes nothing; see "
               "OUTPUT FORMATS. "
               "Default: by the ending of FILE, else svg."},
    {.group = GROUP_OUTPUT,
     .name = "regions",
     .flags = OPTION_FILE,
     .value = "FILE",
     .set = values_set_text,
     TO(regions),
     .excludes = "sheet turntable batch",
     .brief = "what is seen of each face",
     .help = "write what is seen of each face as polygons with holes to FILE, beside the drawing: json, or csv by its "
             "ending",
     .manual =
         "Writes what is seen of each face to FILE (- is standard output), beside the drawing: json, an array with an "
         "object for each face that is seen. body and face are numbered as in tables; face is null for a hull's face "
         "and where the near plane cuts. area is that of the picture, in model units squared. z0 and z1 say how near "
         "the viewer its farthest and its nearest point are, as in +depth. color holds the numbers from the input, or "
         "is null. rings holds polygons, each an array of corners [x, y] as in tables: a ring that runs "
         "counter-clockwise bounds a piece, and those after it that run clockwise bound the holes in that piece. The "
         "regions of all faces tile the picture without gaps and overlaps. They are the same whichever lines are "
         "drawn, and with --union.\n"
         "If FILE ends in .csv, it is a table with a row for each face: body, face, area, z0, z1, color (numbers with "
         "blanks between them) and polygon, a MULTIPOLYGON as well-known text, as geographers' programs read it."},
    {.group = GROUP_OUTPUT,
     .name = "merge-regions",
     .set = values_set_flag,
     TO(hide.merge_regions),
     .brief = "one region for coplanar neighbours",
     .help = "join neighbouring regions that have one plane and one colour; with --union, those of several bodies too",
     .manual =
         "Faces of one body that lie side by side in one plane and have one colour become one region, which has "
         "the number of the first of them. With --union faces of several bodies do so, too. This is for "
         "--regions; fills are joined by colour anyway. With --group element such a region is one element, and its "
         "data-face is the number of that first face."},
    {.group = GROUP_OUTPUT,
     .name = "turntable",
     .flags = OPTION_DRAWS,
     .value = "N",
     .set = values_set_integer,
     TO(turntable),
     RANGE(1, 100000),
     .brief = "N pictures from all round",
     .help = "draw N pictures, the view turned about the upright line through the scene, at one scale; FILE has a "
             "place for the number, from 0: turn-%03d.svg",
     .manual = "Draws N pictures. From one to the next the view turns by the same angle about the upright line through "
               "the scene's centre. All have one scale. The name of the output has a place for the number, which "
               "counts from 0: %d, or %03d for at least three digits, as in turn-%03d.svg. Without this option a % in "
               "a name is just a %."},
    {.group = GROUP_OUTPUT,
     .name = "sheet",
     .flags = OPTION_DRAWS,
     .value = "ANGLE",
     .words = values_sheets,
     .set = values_set_sheet,
     .excludes = "view dir eye azimuth elevation up roll turntable pick",
     .brief = "several views on one page",
     .help = "first or third angle projection: front, top, side and isometric view (the last without hidden lines) on "
             "one page, at one scale, with the symbol",
     .manual =
         "Draws the front, top, side and isometric view on one page, at one scale and 15 mm apart (farther where "
         "dimensions lie between them), with the symbol of their arrangement (ISO 5456-2). ANGLE is first or third. In "
         "first angle projection the top view is below and the view from the left is at the right. In third angle "
         "projection the top view is above and the view from the right is at the right. The isometric view shows the "
         "sides of the other views, and has no hidden lines. --scale, --fit and --align hold for all views together, "
         "and --stats adds them up. As csv and json there is one table, whose first column names the view; if FILE has "
         "a place for that name, as in table-%s.csv, there is a table of each view.\n"
         "The symbol is smaller where the margins leave less than 61 x 52 mm, and is left out where they leave less "
         "than some 38 x 36 mm."},
    {.group = GROUP_OUTPUT,
     .name = "hidden",
     .flags = OPTION_DRAWS,
     .value = "MODE",
     .words = values_hidden,
     .set = values_set_hidden,
     .brief = "hidden lines",
     .help = "hidden lines: none, dashed or solid (default: none); in tables, dashed and solid keep them",
     .manual =
         "How hidden lines are drawn: none (the default), dashed or solid. In tables, dashed and solid keep them."},
    {.group = GROUP_OUTPUT,
     .name = "columns",
     .flags = OPTION_DRAWS | OPTION_TABLE,
     .value = "+NAME,...",
     .words = values_columns,
     .set = values_set_columns,
     .brief = "further columns of tables",
     .help = "further columns of tables, in this order: +ends (in the model), +depth (toward the viewer), +level (how "
             "many layers hide it), +name (of the group), +by (the name of what hides it)",
     .manual =
         "Further columns of tables, after the usual ones and in the order given: +ends, +depth, +level, +name, +by. "
         "OUTPUT FORMATS says what they hold."},
    {.group = GROUP_OUTPUT,
     .name = "crease",
     .flags = OPTION_DRAWS,
     .value = "DEGREES",
     .set = values_set_crease,
     TO(hide.crease_degrees),
     RANGE(0, 180),
     .excludes = "all-edges",
     .brief = "leave out flatter edges",
     .help = "leave out edges between two front faces, or two back ones, that bend by at most this (default: auto, "
             "which is 0.1, and 30 for curved bodies of many faces that are not convex)",
     .manual =
         "Leaves out edges at which two front faces bend by at most this angle; of hidden lines, also those "
         "between two back faces. Default: auto, which is 0.1 for most bodies, so that edges inside a plane are "
         "left out, and 30 for curved ones. A body is curved if it is not convex, has more than 500 faces, and "
         "half of its edges bend by less than 20 degrees. It is also curved if half of its facets have at least "
         "half such edges, as the walls of a round extrusion have. A larger angle thins out the slivers of scanned "
         "models. 0 leaves out none."},
    {.group = GROUP_OUTPUT,
     .name = "all-edges",
     .flags = OPTION_DRAWS,
     .set = values_set_flag,
     TO(hide.all_edges),
     .brief = "draw flat edges too",
     .help = "draw all edges, even those that --crease leaves out",
     .manual = "Draws all edges, even those that --crease leaves out."},
    {.group = GROUP_OUTPUT,
     .name = "solids",
     .flags = OPTION_DRAWS,
     .set = values_set_flag,
     TO(scene.solids),
     .excludes = "hull",
     .brief = "refuse all but convex solids",
     .help = "refuse any body that is not a closed convex solid",
     .manual =
         "Refuses a file with a body that is not a closed, planar, convex solid, and says which and why. Otherwise "
         "bodies of any kind are drawn."},
    {.group = GROUP_OUTPUT,
     .name = "rounded",
     .flags = OPTION_DRAWS,
     .set = values_set_flag,
     TO(scene.rounded),
     .brief = "decimals were rounded",
     .help = "coordinates were rounded to decimals: what touched before still touches",
     .manual =
         "Says that coordinates were rounded to decimals, as in 0.707107. What touched before the rounding, or lay in "
         "one plane, may now be apart by a unit of the last digit, and lines are missing or drawn twice. With this "
         "option, the touching distance is at least two such units; or of the last place of a 32-bit float, if all "
         "coordinates are printed floats, as in 0.707106769 or 0.70710676908493042, and that is more. It has no effect "
         "on other coordinates of more than nine digits, nor if two units are more than 1e-4 of the model's size."},
    {.group = GROUP_OUTPUT,
     .name = "fill-rule",
     .flags = OPTION_DRAWS,
     .value = "RULE",
     .words = values_fill_rules,
     .set = values_set_fill_rule,
     .brief = "inside of faces that cross themselves",
     .help = "what belongs to a face that crosses itself: nonzero, all that its border winds round (the default); "
             "evenodd, what it winds round an odd number of times",
     .manual = "What belongs to a face that crosses itself, such as a pentagram. nonzero (the default): all that its "
               "border winds round. evenodd: what it winds round an odd number of times, which leaves the middle of a "
               "pentagram open."},
    {.group = GROUP_OUTPUT,
     .name = "union",
     .flags = OPTION_DRAWS,
     .set = values_set_flag,
     TO(hide.unite),
     .brief = "draw all bodies as one",
     .help = "draw all closed bodies as one: no line where they touch flush or lie in one another",
     .manual =
         "Draws all closed bodies as one. Parts that are flush show no seam. Nothing inside another body is drawn, "
         "not even as a hidden line; where one body crosses itself, its lines stay, except where they run through "
         "the filled middle of a star-shaped face. A line where bodies meet has the class that it has in the whole: "
         "the foot of a leg on a slab is a crease, and so is mostly a line in which faces cross. Open surfaces and "
         "wires are drawn as without this option. Where edges of several bodies lie on "
         "one another, that of the body of smallest number is drawn. --verify then checks what is drawn, and not what "
         "is left out, since a ray cannot tell a seam from a line.\n"
         "Parts are flush if their faces lie in one plane to within the touching distance. Parts with small gaps or "
         "steps between them need --epsilon, of about twice the widest: 0.002 where gaps are up to 0.001. The same "
         "may hold for models that are rounded to six digits. --stats counts the edges that are left out."},
    {.group = GROUP_OUTPUT,
     .name = "hull",
     .flags = OPTION_DRAWS,
     .set = values_set_flag,
     TO(scene.hull),
     .brief = "convex hulls of what is not convex, and of points",
     .help = "draw the convex hulls of solids that are not closed, planar and convex, and of points without faces; a "
             "warning says how many, -v which; flat ones are left out",
     .manual =
         "Draws the convex hull of each body that is not a closed, planar, convex solid, instead of the body. Sound "
         "solids stay as they are. What is open is taken together as far as it shares vertices. A file of points "
         "without faces becomes the hull of all its points. A warning counts the solids that were replaced and says "
         "why; -v names them by their numbers.\n"
         "Flat bodies, such as a stray triangle, are left out with a warning. A file that holds nothing else is "
         "refused."},

    /* ---- batches ---- */
    {.group = GROUP_BATCH,
     .name = "batch",
     .flags = OPTION_FOLDER,
     .value = "DIR",
     .set = values_set_text,
     TO(batch),
     .excludes = "output turntable",
     .brief = "draw each file by itself",
     .help = "draw each FILE by itself, into DIR (as .svg, or as -f says), several at a time; one that fails does "
             "not stop the others",
     .manual = "Draws each FILE by itself, into DIR: table.off as DIR/table.svg, or with the ending of the format that "
               "-f names. Several files are drawn at a time, by as many processes. A file that fails, or that crashes "
               "its process, does not stop the others, but then the exit status is 1. The folder is made where it is "
               "missing."},
    {.group = GROUP_BATCH,
     .name = "list",
     .flags = OPTION_FILE,
     .value = "LIST",
     .set = values_set_text,
     TO(list),
     .needs = "batch",
     .brief = "names of files from a list",
     .help = "draw the files that LIST names too, one a line, or as find -print0 writes them (-: standard input)",
     .manual = "Draws the files that LIST names, after those of the command. - is standard input. Each line is a name, "
               "blanks and all; empty lines are skipped. Lines may end as on Windows. If the list holds a zero byte, "
               "each name ends in one instead, as find -print0 writes them, and may hold newlines."},
    {.group = GROUP_BATCH,
     .name = "root",
     .flags = OPTION_FOLDER,
     .value = "FOLDER",
     .set = values_set_text,
     TO(root),
     .needs = "batch",
     .brief = "keep the folders of files",
     .help = "keep the folders of files below FOLDER: FOLDER/a/b.off becomes DIR/a/b.svg",
     .manual =
         "Keeps the folders of files below FOLDER: the drawing of FOLDER/a/b.off is DIR/a/b.svg. Folders are made "
         "where a drawing needs them. All names have to begin with FOLDER; links are not followed. Without it all "
         "drawings are in DIR itself, and no two files may have one name."},
    {.group = GROUP_BATCH,
     .name = "shard",
     .value = "K/N",
     .set = values_set_share,
     TO(shard),
     .needs = "batch",
     .brief = "draw a part of the files",
     .help = "draw only every Nth file, from file K on: shards 1/N to N/N draw each file once",
     .manual =
         "Draws only every Nth of the files, from file K on. N runs, from 1/N to N/N, draw each file once, on one "
         "machine or on several. Names are checked for all files, so that no two of the runs write one "
         "drawing."},
    {.group = GROUP_BATCH,
     .name = "update",
     .set = values_set_flag,
     TO(update),
     .needs = "batch",
     .brief = "draw only what has changed",
     .help = "draw only files that are newer than their drawing; with --manifest, also those that it does not say were "
             "drawn, by this command",
     .manual = "Draws only files whose drawing is missing, or not newer than the file, and than those of --labels and "
               "--room-for. The drawing of a .obj file has to be newer than all .mtl files in its folder, too. So "
               "a run that was stopped goes on.\n"
               "With --manifest a file is drawn, too, unless its last row says that it was drawn, and by this "
               "command: after a change of options that change drawings, all is drawn again. Without --manifest "
               "options are not compared: after such a change, draw once without --update."},
    {.group = GROUP_BATCH,
     .name = "manifest",
     .flags = OPTION_FILE,
     .value = "FILE",
     .set = values_set_text,
     TO(manifest),
     .needs = "batch",
     .brief = "a row for each file",
     .help = "add a row to FILE for each file that is drawn or fails, as a line of JSON",
     .manual = "Adds a line to FILE for each file that is drawn or fails, as they end. It is a JSON object: file and "
               "output (null for -f null); command, the command line that draws it, without -o and -f; error, the "
               "message, or null; seconds on the clock; lines, the segments of the drawing; and warnings, how many "
               "there were (0 with --quiet). Bytes of names that are no UTF-8 become U+FFFD. Of several rows of a file "
               "the last one counts. A row is written in one piece, so several runs on one machine may share a "
               "manifest. If a run is killed in the middle of a row, the next one cuts the row off."},
    {.group = GROUP_BATCH,
     .name = "limit-seconds",
     .value = "S",
     .set = values_set_number,
     TO(limit_seconds),
     RANGE(0.001, 1e9),
     .needs = "batch",
     .brief = "time for each file",
     .help = "give up a file after S seconds on the clock",
     .manual = "Gives a file up, as failed, after S seconds on the clock."},
    {.group = GROUP_BATCH,
     .name = "limit-memory",
     .value = "MB",
     .set = values_set_number,
     TO(limit_memory),
     RANGE(1, 1e12),
     .needs = "batch",
     .brief = "memory for each file",
     .help = "give up a file that needs more than MB megabytes; each file is then drawn by one thread",
     .manual = "Gives a file up, as failed, if it needs more than MB megabytes of address space, beyond what the "
               "program itself takes. Each file is then drawn by one thread. A file that does not "
               "find enough memory is tried once more in a fresh process, so that the memory of earlier files does not "
               "count."},
    /* ---- parts ---- */
    {.group = GROUP_PARTS,
     .name = "plan",
     .set = values_set_flag,
     TO(plan),
     .excludes = "part join sheet turntable batch regions verify pick stats hull",
     .brief = "lay out a scene for parts",
     .help = "write a plan to --output: the bodies, and where they are in the picture",
     .manual = "Writes a plan: all bodies, and where they are in the picture. A plan is read by --part in place of the "
               "models. So these are read once, and not for each part."},
    {.group = GROUP_PARTS,
     .name = "part",
     .value = "K/N",
     .set = values_set_share,
     TO(part),
     .excludes = "plan join sheet turntable batch regions verify pick stats hull",
     .brief = "draw one part",
     .help = "draw part K of N from a plan, or from models, for --join",
     .manual = "Draws part K of N from a plan, or from models, and writes it to --output, for --join. Parts have about "
               "as many vertices each, and lie together in the picture. In memory are the part's bodies and those that "
               "may hide or cross them. Without a plan, the models are read and laid out first, in a file without a "
               "name beside the output. The machines must have the same byte order."},
    {.group = GROUP_PARTS,
     .name = "join",
     .set = values_set_flag,
     TO(join),
     .excludes = "plan part sheet turntable batch regions verify pick stats hull",
     .brief = "join all parts",
     .help = "join the parts named, in any order, and draw them",
     .manual = "Joins the parts named, in any order, and draws them, or writes their table. It refuses parts that are "
               "missing, given twice, unfinished or broken, and parts of different drawings. Names of groups are not "
               "in parts: where the models have such names, --group and --columns +name need one run."},

    /* ---- page ---- */
    {.group = GROUP_PAGE,
     .name = "page",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "SIZE",
     .words = values_pages,
     .set = values_set_page,
     .brief = "size of the page",
     .help = "a0 to a6, b0 to b6, letter, legal, tabloid, or WxH in mm (default: a4)",
     .manual = "The paper: a0 to a6, b0 to b6, letter, legal, tabloid, all upright, or WxH: width and height in mm. "
               "Default: a4."},
    {.group = GROUP_PAGE,
     .name = "landscape",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .set = values_set_flag,
     TO(landscape),
     .brief = "the longer side is horizontal",
     .help = "the longer side is horizontal",
     .manual = "Turns the paper, so that its longer side is horizontal."},
    {.group = GROUP_PAGE,
     .name = "crop",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .set = values_set_flag,
     TO(draw.crop),
     .excludes = "sheet fov",
     .brief = "cut the page to the drawing",
     .help = "cut the page to the drawing, its labels and its margins",
     .manual = "Lays the drawing on the page and then cuts the page to the drawing, its labels and its margins, for a "
               "figure in a text or on a web page. --page limits its size. The bounding box of eps has no margins: it "
               "is that of the lines."},
    {.group = GROUP_PAGE,
     .name = "margin",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "MM",
     .set = values_set_length,
     TO(draw.page.margin_mm),
     RANGE(0, 20000),
     .brief = "on all four sides",
     .help = "on all four sides (default: 10)",
     .manual = "The margin on all four sides. Default: 10. A drawing that is fitted keeps at least half of its widest "
               "pen from the page's edge, with --margin 0 too."},
    {.group = GROUP_PAGE,
     .name = "fit",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .excludes = "scale",
     .brief = "as large as the margins allow",
     .help = "as large as the margins allow (the default without a title block)",
     .manual = "Draws as large as the margins allow. This is the default, except for sheets with a title block: see "
               "--title."},
    {.group = GROUP_PAGE,
     .name = "room-for",
     .flags = OPTION_DRAWS | OPTION_PAPER | OPTION_REPEATS | OPTION_FILE,
     .value = "FILE",
     .set = values_add_room,
     .excludes = "sheet turntable plan part join",
     .brief = "leave room for this model, too",
     .help = "leave room for this model, which is not drawn; steps of a construction then fit together",
     .manual = "Lays out the page as if it showed the model in FILE, too. FILE is not drawn, and hides nothing. So the "
               "steps of a construction have one scale and one place, if each of them, the last one too, leaves room "
               "for the finished whole. Labels need room, too: if not all steps have the same ones, give all steps one "
               "--scale. May be given up to 64 times. With --eye, give --look-at as well."},
    {.group = GROUP_PAGE,
     .name = "scale",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "RATIO",
     .words = values_scales,
     .set = values_set_scale,
     .brief = "true to scale, as 1/20",
     .help = "true to scale: 1:20, 2:1 or 0.05; the page has to hold it. Or standard: the largest of ... 1:10, 1:5, "
             "1:2, 1:1, 2:1, 5:1, 10:1 ... (ISO 5455) that the page holds; -v tells which",
     .manual =
         "Draws true to scale: 1:20, 2:1 or 0.05. A drawing that would leave the page is refused, and the message "
         "names the scale that would fit. standard is the largest scale that the page holds of those of ISO 5455: 1, 2 "
         "or 5 times a power of ten, as 1:50 or 2:1; -v and --stats tell which. In perspective the scale holds for "
         "what lies in the plane through the look-at point, across the line of sight: nearer things are drawn larger, "
         "farther ones smaller.\n"
         "A drawing that is true to scale may fill the page. There the outer half of a line on the edge is cut off."},
    {.group = GROUP_PAGE,
     .name = "unit",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "UNIT",
     .words = values_units,
     .set = values_set_unit,
     .brief = "model unit",
     .help = "with --scale: a model unit is 1 mm (the default), cm, m, in or ft",
     .manual = "For --scale: a unit of the model is 1 mm (the default), cm, m, in or ft."},
    {.group = GROUP_PAGE,
     .name = "align",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "WHERE",
     .words = values_places,
     .set = values_set_align,
     .brief = "where on the page",
     .help = "center (the default), left, right, top, bottom, top-left, top-right, bottom-left, bottom-right",
     .manual = "Where the drawing is on the page: center (the default), left, right, top, bottom, top-left, top-right, "
               "bottom-left or bottom-right."},
    {.group = GROUP_PAGE,
     .name = "frame",
     .flags = OPTION_DRAWS | OPTION_PAPER | OPTION_OPTIONAL,
     .value = "zones",
     .words = values_frames,
     .set = values_set_frame,
     .brief = "draw the border of the margins",
     .help = "draw the border of what the margins leave; the drawing keeps 5 mm from it. Where the drawing is cut off "
             "(--fov, --near), the border at which it is cut. --frame=zones adds zones and centring marks",
     .manual =
         "Draws the border of what the margins leave, 0.7 mm wide. The drawing keeps 5 mm from it, a sheet 10 "
         "mm; on pages with less than 50 mm of room, a tenth of that room. Where the drawing is cut off (--fov, "
         "--near), the frame is the border at which it is cut: that of the margins again, unless --scale leaves "
         "the picture smaller.\n"
         "--frame=zones adds centring marks, and zones of 50 mm with letters and numbers (ISO 5457), in margins of "
         "at least 7 mm."},
    {.group = GROUP_PAGE,
     .name = "background",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "COLOR",
     .words = values_backgrounds,
     .set = values_set_background,
     .brief = "below the lines",
     .help =
         "the colour below the lines, all over the page: a name such as red, #rrggbb or #rgb (default: none; png is "
         "white)",
     .manual = "The colour below the lines, all over the page: black, white, gray, red, green, blue, cyan, brown, "
               "magenta, yellow, orange, purple, #rrggbb or #rgb. Default: none, which in png is white. In svg it is a "
               "rectangle that is in no layer. It is meant for the web, where the page round a drawing may be dark. "
               "Pen plotters may take it for something to draw."},
    {.group = GROUP_PAGE,
     .name = "fill",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "WITH",
     .words = values_fills,
     .set = values_set_fill,
     .brief = "fill visible faces",
     .help = "fill what is seen of faces, below the lines: none (the default), model (colours of the file), body (a "
             "colour for each), shade (colours of the file, or grey, by the light), a colour as for --background; "
             "shade:body, shade:COLOR",
     .manual =
         "Fills what is seen of each face, below all lines. none (the default) fills nothing. model takes the colours "
         "of the file: a face's own, or the mean of those of its corners; a face without a colour is left open. body "
         "gives each body one of nine colours that the colour-blind can tell apart, and begins again after nine. A "
         "COLOR, as for --background, is that of all faces. shade takes the colours of the file, light grey where "
         "there are none, and makes faces darker where less light falls on them (see --light). shade:body and "
         "shade:COLOR do so with other colours.\n"
         "Neighbouring regions of one colour are joined; so flush bodies of one colour show no seam with --union. "
         "Between flush bodies of two colours no line is drawn then. "
         "Where two colours meet, a line of at most 0.4 mm lies below the border, so that no gap shines through on a "
         "screen. "
         "Translucent colours let the background through, not the faces behind. They stay translucent in svg, pdf and "
         "tikz; in ps, eps and png they are mixed with the "
         "background, or with white. A line below the border of translucent colours would be seen, so there is none: a "
         "screen may show a hairline there. In svg the fills are a layer without a number; with --layers numbered its "
         "name "
         "is %fill, since AxiDraw's software skips layers with %. dxf and hpgl cannot "
         "fill."},
    {.group = GROUP_PAGE,
     .name = "light",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "X,Y,Z",
     .set = values_set_direction,
     TO(draw.light),
     .brief = "toward the light",
     .help = "the direction toward the light, as the viewer sees it: X to the right, Y upward, Z toward the viewer "
             "(default: -1,2,3)",
     .manual =
         "The direction toward the light for --fill shade and --hatch, as the viewer sees it: X is to the right, Y "
         "upward "
         "and Z toward the viewer, in every view. It has any length. Default: -1,2,3, from the upper left. A "
         "face that looks toward the light has its full colour; others have 0.45 of it, and 0.55 times the cosine "
         "of the angle between normal and light (Lambert's law)."},
    {.group = GROUP_PAGE,
     .name = "dpi",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "N",
     .set = values_set_number,
     TO(draw.dpi),
     RANGE(10, 10000),
     .brief = "resolution of png",
     .help = "resolution of png, 10 to 10000 (default: 150)",
     .manual =
         "The resolution of png, in dots per inch: 10 to 10000. Default: 150. An image has at most 32767 pixels a "
         "side."},
    {.group = GROUP_PAGE,
     .name = "plotter",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "ORIGIN[,TURN[,XxY]]",
     .set = values_set_plotter,
     RANGE(-1000, 1000),
     .brief = "origin and turn of hpgl",
     .help = "origin of hpgl, corner or center (default: corner), how the page is turned (90, 180 or 270), and how far "
             "inside the origin lies, as 10x4 in mm",
     .manual =
         "Where an hpgl plotter has its origin: corner, the page's lower left one (the default), or center. TURN turns "
         "the page counter-clockwise by 90, 180 or 270 degrees. XxY is how far the origin lies from there, along the "
         "plotter's x and y axis, in mm.\n"
         "On a plotter whose x axis runs along the longer side of the paper, an upright page needs a turn by 90, and a "
         "--landscape page none. The HP 7475A has its origin inside the paper, for A4 at corner,90,10x4, or "
         "corner,0,10x4 "
         "with --landscape. It cannot reach the border, so --margin 15 is a good choice. Large drafting plotters often "
         "have the origin in the middle."},

    /* ---- lines ---- */
    {.group = GROUP_LINES,
     .name = "style",
     .flags = OPTION_DRAWS | OPTION_PAPER | OPTION_REPEATS,
     .value = "CLASS:KEY=VALUE,...",
     .words = values_pens,
     .set = values_set_style,
     .brief = "a pen",
     .help =
         "a pen; CLASS: outline, border, crease, intersection, wire, hidden, frame, symbol, hatch, text, hidden-text "
         "or all (default: 0.5, 0.5, 0.35, 0.35, 0.35, 0.25 dashed, 0.7, 0.35, 0.25, 0.25, 0.25 mm, black). width=MM; "
         "color=NAME, #rrggbb or #rgb; dash=DASH/GAP in mm as seen, or none; pen=N: its number in hpgl and numbered "
         "layers; off, on",
     .manual =
         "Sets a pen. CLASS is outline, border, crease, intersection, wire, hidden, frame, symbol, hatch, text, "
         "hidden-text or all. width=MM is its width, color=COLOR its colour (as for --background). dash=DASH/GAP are "
         "the lengths of dashes and gaps in mm, as seen on paper; dash=DASH has gaps of a quarter of it; dash=none "
         "draws whole lines, and a dash as short as the pen is wide is a dot. pen=N is the number of the pen in "
         "hpgl, and of the layer with --layers numbered, where several classes may share one; in hpgl they then "
         "follow one another. off leaves the class out, on brings it back. All else keeps its place on the page, so "
         "files for one pen each fit together; only a frame and the symbol of a sheet must be in all of them or in "
         "none. May be given several times; later ones count, so that all comes first.\n"
         "The defaults are 0.5, 0.5, 0.35, 0.35, 0.35, 0.25, 0.7, 0.35, 0.25, 0.25 and 0.25 mm. All are black, but "
         "hidden-text is grey. Hidden lines have dashes of 3 mm and gaps of 0.75 mm; with another width= both "
         "change in proportion. The pens do not depend on the page: small or crowded pictures want thinner ones."},
    {.group = GROUP_LINES,
     .name = "hatch",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "KEY=VALUE,...",
     .words = values_hatch_keys,
     .set = values_set_hatch,
     .brief = "strokes on faces by their shade",
     .help =
         "strokes on the faces that are seen, closer together where less light falls; on, or: spacing=MM where it is "
         "darkest (default: 0.8); levels=N tones (10; 0: any); direction=picture, steep or across, in each face's "
         "plane; angle=DEGREES; cross=0.5: the darker half in two directions; lines=nested: strokes go on from tone "
         "to tone; shortest=MM leaves out shorter strokes; faces=sections hatches only sections",
     .manual =
         "Draws strokes on the faces that are seen, closer together where less light falls (--light). They are lines "
         "of their own, with the pen --style hatch:..., below all others, and stop round text. --hatch on takes the "
         "defaults; keys change them:\n"
         "spacing=MM: from stroke to stroke on paper where no light falls. Default: 0.8. The more light falls on "
         "a face, the fewer strokes it has; a face on which the light falls straight has none (Lambert's law).\n"
         "levels=N: how many tones there are; 0: one for each shade. Default: 10. Faces of one tone have strokes in "
         "line with one another.\n"
         "direction=picture (the default): strokes run the same way on all faces. steep, across: on each face along "
         "its steepest line, or along a level line. Faces that lie in one plane have strokes in line with one another. "
         "In perspective, too, strokes are parallel on paper.\n"
         "angle=DEGREES: how far strokes are turned counter-clockwise. Default: 45 in the picture, 0 on faces.\n"
         "cross=PART: in tones darker than this part of the darkest, further strokes run across the others. 0.5 is a "
         "good value. Default: none.\n"
         "lines=even (the default): the strokes of a tone are equally far apart. nested: a darker tone has the strokes "
         "of the lighter ones, and more between them, so that they go on from tone to tone. That suits curved "
         "surfaces, with cross=0.5. A face with fewer than 20 strokes may "
         "have one more or one less than its tone asks for.\n"
         "shortest=MM: shorter strokes are left out. Meshes of small triangles have many of them where two tones meet. "
         "Small dark faces get lighter. Default: 0, none is.\n"
         "faces=all (the default). sections: only sections (--section, --near) have strokes, all of the darkest tone. "
         "Those of every second body run across the others, unless --union draws all bodies as one; with cross=0.5 "
         "both look alike.\n"
         "off: no strokes."},
    {.group = GROUP_LINES,
     .name = "dash",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "MODE",
     .words = values_dashes,
     .set = values_set_dash,
     .brief = "dashes",
     .help = "pattern: dashes as a pattern of the line; real: dashes as strokes, fitted to the line (default: pattern)",
     .manual =
         "pattern: broken lines have a dash pattern, which runs on round corners and ends anywhere (the default). "
         "real: each dash is a stroke of its own. Dashes are fitted from corner to corner, so that they meet at "
         "corners and every straight line begins and ends with a dash and has a gap, unless it is shorter than "
         "three widths of the pen. Real dashes are for pen plotters and for the best print; files are twice as "
         "large."},
    {.group = GROUP_LINES,
     .name = "order",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "MODE",
     .words = values_orders,
     .set = values_set_order,
     .brief = "order of the strokes",
     .help = "travel: the lifted pen travels little; none: as in the model (default: travel)",
     .manual = "travel (the default): strokes are ordered so that the lifted pen travels little: the nearest stroke "
               "next, then 2-opt up to a fixed number of steps. none: as in the model."},
    {.group = GROUP_LINES,
     .name = "layers",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "MODE",
     .words = values_layers,
     .set = values_set_layers,
     .brief = "names of the layers of svg",
     .help = "layers of svg are named (outline) or numbered, too (6 outline), as plotters want them (default: named)",
     .manual =
         "named (the default): layers of svg have the names of the classes. numbered: the names begin with numbers, "
         "from 1 hidden to 6 outline, 7 frame, 8 symbol, 9 hatch, 10 text and 11 hidden-text, the same in every "
         "drawing. The software of AxiDraw finds layers by their numbers. With --group body layers are bodies, "
         "numbered from 1; frame, symbol and text come after the last body."},
    {.group = GROUP_LINES,
     .name = "group",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "BY",
     .words = values_groups,
     .set = values_set_group,
     .brief = "groups of svg",
     .help =
         "groups of svg, for style sheets and scripts: class (the default), body (with its name, classes inside) or "
         "element (every piece of an edge by itself)",
     .manual =
         "How the lines of svg are grouped. class (the default): a layer for each class, with one path. body: a layer "
         "for each body, with a path for each class. element: a layer for each class, in it a group for each body, in "
         "it a path for each piece of an edge; pieces are not joined to longer strokes.\n"
         "With body and element, groups and elements have names for style sheets and scripts. class is the line's "
         "class, body, view or edge. data-body and data-name are the body's number and its name in the file, if it has "
         "one. data-edge is like 4-17, the edge's vertices, and data-faces like 2,5, the faces there; all as in "
         "tables. A hidden piece has data-by, the body seen there. With --text native, a label has what it names, such "
         "as data-vertex. Pens are attributes of groups, so that rules of style sheets override them. On sheets the "
         "views are the layers. With --fill, the group seam lies below the "
         "areas: lines along their borders, without which viewers show gaps; each path has the data-body of its area."},
    {.group = GROUP_LINES,
     .name = "id-prefix",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "TEXT",
     .set = values_set_id_prefix,
     .brief = "what ids of svg begin with",
     .help = "begin the ids of svg with this, so that one web page can hold several drawings",
     .manual = "The ids of svg begin with TEXT: letters, digits, - . and _, beginning with a letter or _. One "
               "web page can then hold several drawings: in a page an id may be used only once. Groups have classes as "
               "well, such as outline, so that one style sheet serves all drawings."},

    /* ---- text ---- */
    {.group = GROUP_TEXT,
     .name = "label",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "WHAT,...",
     .words = values_labels,
     .set = values_set_label,
     .brief = "numbers at vertices or edges or faces or bodies",
     .help = "write the numbers of the file: vertices, edges (as 4-17), faces or bodies; several with commas, "
             "then as v4, f4 and b4; names: the names of bodies in the file",
     .manual =
         "Writes the numbers that the file gives to vertices, edges (by their vertices, as 4-17), faces or bodies; "
         "several with commas. Where there are vertices, faces and bodies, or two of them, their numbers are written "
         "as v4, f4 and b4. names: bodies have the names of their groups in the file (OBJ, STL); bodies without a name "
         "have no label, or with bodies,names their numbers. A label is beside its vertex or the middle of the edge's "
         "longest visible part, in the "
         "middle of what is seen of its face, or in the largest face that is seen of its body; where another place "
         "has much more room, such as the middle of a round body whose edges are left out, there. It keeps off lines "
         "and other labels where there is room. If a face or body is too narrow, its label stands near by, with a "
         "leader line. A fitted drawing leaves room for its labels. Hidden things have no label; with --hidden, hidden "
         "vertices and edges have grey ones, in the class "
         "hidden-text. Edges that are not drawn have none. Where letters could not be read on a fill, a plate in the "
         "colour of the paper lies below them."},
    {.group = GROUP_TEXT,
     .name = "labels",
     .flags = OPTION_DRAWS | OPTION_PAPER | OPTION_FILE,
     .value = "FILE.csv",
     .set = values_set_text,
     TO(names),
     .brief = "names in place of numbers",
     .help = "names for labels: lines such as vertex,4,A and edge,4-17,a and face,3,base and body,0,leg",
     .manual =
         "Writes the names that FILE.csv gives: a line is KIND,NUMBER,NAME, as vertex,4,A or edge,4-17,a or "
         "face,3,base or body,0,leg, in UTF-8. Fields may stand in quotation marks, and semicolons or tabs may "
         "separate them, as spreadsheets write them. (They may take 4-17 for a date; v4-v17 is the same, as v4, f3 and "
         "b0 are for 4, 3 and 0.) Lines that begin with # are skipped, and so is a first line with the titles of the "
         "columns. Everything with a name is labelled; with --label, the rest is labelled by its numbers. An empty "
         "name is no label. A warning tells of names that match nothing, with --batch for each file."},
    {.group = GROUP_TEXT,
     .name = "title",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "TEXT",
     .set = values_set_text,
     TO(draw.lettering.title),
     .brief = "title of svg or title block",
     .help = "the title of svg (default: the name of the file); with --sheet also a title block with it, the scale and "
             "the symbol of the projection",
     .manual =
         "The title of svg, which browsers show and read out. In tikz it is a comment. Default: the name of the file.\n"
         "On a sheet it also draws a title block (ISO 7200) in the lower right corner, 180 x 27 mm: the title, the "
         "scale, the symbol of the projection, and the fields of --field. A long title takes several lines. Without "
         "--scale or --fit the sheet is drawn at --scale standard. A page that is too small is refused, and the "
         "message names one that would do."},
    {.group = GROUP_TEXT,
     .name = "description",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "TEXT",
     .set = values_set_any_text,
     TO(draw.description),
     .brief = "description of svg and tikz",
     .help = "the description in svg and tikz (default: the command, with the names of its files)",
     .manual = "The description of svg (<desc>), which screen readers read out. In tikz it is a comment. Default: the "
               "command that draws it, with the names of its files and their folders. An empty text leaves it out."},
    {.group = GROUP_TEXT,
     .name = "field",
     .flags = OPTION_DRAWS | OPTION_PAPER | OPTION_REPEATS,
     .value = "NAME=TEXT",
     .words = values_fields,
     .set = values_set_field,
     .needs = "sheet",
     .brief = "a field of the title block",
     .help = "with --sheet: a field of the title block: owner, author, approved, number, revision, date or sheet",
     .manual = "Fills a field of the title block of a sheet: owner, author, approved, number, revision, date or sheet. "
               "May be given several times. The title block and the standard scale are those of --title."},
    {.group = GROUP_TEXT,
     .name = "dimensions",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "WHAT,...",
     .words = values_dimensions,
     .set = values_set_dimensions,
     .needs = "sheet",
     .brief = "width and height and depth or distances",
     .help = "with --sheet: overall draws width, height and depth of the whole, v4-v17 the distance between two "
             "vertices; several with commas",
     .manual =
         "Draws dimensions on a sheet (ISO 129-1), in units of the model, with the name of --unit behind them unless "
         "that is mm. Numbers have five digits and a decimal comma. overall: width, height and depth of the whole. "
         "v4-v17: the distance between two vertices, by their numbers in the file (--label vertices shows them). It "
         "is drawn once, in a view that shows it in true length, where possible one that shows both vertices. A "
         "warning says where no view does, or where there is no room. With overall, one that is the width, height or "
         "depth of the whole is not drawn again. Several with commas, as overall,v4-v17,v4-v9."},
    {.group = GROUP_TEXT,
     .name = "label-size",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "MM",
     .set = values_set_length,
     TO(draw.lettering.height_mm),
     RANGE(0.5, 100),
     .brief = "height of capitals",
     .help = "height of the capitals (default: 3.5; labels 2.5 or 1.8 where there is little room)",
     .manual =
         "How high capitals are. Default: 3.5, which goes with the pen of 0.25 mm (ISO 3098, type A). Labels are "
         "2.5 or 1.8 high if the drawing would lose a quarter of its size to them, if there is no room for all of "
         "them, or if more than one in twenty would lie on a line, nearer to another vertex or behind another "
         "line."},
    {.group = GROUP_TEXT,
     .name = "text",
     .flags = OPTION_DRAWS | OPTION_PAPER,
     .value = "MODE",
     .words = values_texts,
     .set = values_set_text_mode,
     .brief = "strokes or text of the reader",
     .help = "strokes: letters that pens draw, everywhere the same; native: text for the reader's fonts, in svg, pdf, "
             "tikz and dxf (default: strokes)",
     .manual = "strokes (the default): letters are drawn as strokes of a pen, everywhere the same: upright letters "
               "near ISO 3098, Latin with accents, and Greek. They write the "
               "German sharp s as ss, thorn as th, eth as d, and the ligatures ae and oe as two letters. A warning "
               "tells of characters that they lack. native: "
               "svg, pdf, tikz and dxf have the text itself, which can be searched, copied, and set in the "
               "document's fonts (in svg in the layers letters and hidden-letters). In pdf the fonts are Helvetica and "
               "Symbol, which are not part of the file. In tikz, text between two dollar signs, as $v_1$, is a "
               "formula. A warning tells of characters that the fonts of pdf, or LaTeX itself, lack. Other formats "
               "have strokes all the same, and a warning says so."},

    /* ---- view ---- */
    {.group = GROUP_VIEW,
     .name = "view",
     .flags = OPTION_DRAWS,
     .value = "NAME",
     .words = values_views,
     .set = values_set_view,
     .excludes = "eye look-at",
     .brief = "named view",
     .help =
         "iso (the default: 1,-1,1), dimetric, trimetric, front, back, right, left, top, bottom; oblique: cavalier, "
         "cabinet",
     .manual = "A named view, as by --dir: iso (the default) is 1,-1,1; dimetric 1,-2.64575,1 (the root of 7); "
               "trimetric 3,-6,4; front 0,-1,0; back 0,1,0; right 1,0,0; left -1,0,0; top 0,0,1 and bottom 0,0,-1, "
               "both with +y up. Oblique are cavalier and cabinet: the front, with depth drawn at 45 degrees, in full "
               "and in half."},
    {.group = GROUP_VIEW,
     .name = "dir",
     .flags = OPTION_DRAWS,
     .value = "X,Y,Z",
     .set = values_set_dir,
     TO(camera.dir),
     .excludes = "view eye look-at",
     .brief = "from the scene toward the viewer",
     .help = "parallel view; points from the scene toward the viewer",
     .manual = "A parallel view. The vector points from the scene toward the viewer and has any length."},
    {.group = GROUP_VIEW,
     .name = "azimuth",
     .flags = OPTION_DRAWS,
     .value = "DEGREES",
     .set = values_set_number,
     TO(azimuth),
     RANGE(-360, 360),
     .excludes = "dir view eye",
     .brief = "view by angles",
     .help = "parallel view by angles: 0 = front, 90 = right, 180 = back (default: 0)",
     .manual = "A parallel view by angles: 0 is the front, 90 the right, 180 the back. Default: 0, where only "
               "--elevation is given."},
    {.group = GROUP_VIEW,
     .name = "elevation",
     .flags = OPTION_DRAWS,
     .value = "DEGREES",
     .set = values_set_number,
     TO(elevation),
     RANGE(-90, 90),
     .excludes = "dir view eye",
     .brief = "over the horizon",
     .help = "the viewer over the horizon, with or without --azimuth: 90 = top (default: 0)",
     .manual = "How far the viewer stands over the horizon, with or without --azimuth: 90 is the top. Default: 0."},
    {.group = GROUP_VIEW,
     .name = "eye",
     .flags = OPTION_DRAWS,
     .value = "X,Y,Z",
     .set = values_set_eye,
     TO(camera.eye),
     .brief = "perspective from this point",
     .help = "perspective, from this point",
     .manual = "A perspective view from this point, which has to be outside all solids."},
    {.group = GROUP_VIEW,
     .name = "look-at",
     .flags = OPTION_DRAWS,
     .value = "X,Y,Z",
     .set = values_set_look_at,
     TO(camera.look_at),
     .needs = "eye",
     .brief = "toward this point",
     .help = "with --eye: the point looked at (default: the centre of the scene)",
     .manual = "The point that --eye looks at. Default: the centre of the scene's box."},
    {.group = GROUP_VIEW,
     .name = "fov",
     .flags = OPTION_DRAWS,
     .value = "DEGREES",
     .set = values_set_number,
     TO(camera.fov_degrees),
     RANGE(0.001, 179),
     .needs = "eye",
     .brief = "angle of the picture",
     .help = "with --eye: the angle across the shorter side of the picture, up to 179; the picture fills "
             "what the margins leave (default: the whole scene; at most 60 where it is cut)",
     .manual = "The angle of a perspective picture, from 0.001 to 179 degrees. The picture has the shape of what "
               "the page's margins leave, and this angle across its shorter side. The look-at point is in its middle. "
               "The drawing ends at its border, but tables also have what lies beyond. Default: the whole scene, but "
               "where the near plane cuts it, at most 60 degrees."},
    {.group = GROUP_VIEW,
     .name = "near",
     .flags = OPTION_DRAWS,
     .value = "DISTANCE",
     .set = values_set_number,
     TO(camera.near_distance),
     RANGE(0, DBL_MAX),
     .needs = "eye",
     .brief = "cut off nearer things",
     .help = "with --eye: cut off everything nearer than this (default: a thousandth of the way to look-at)",
     .manual =
         "Cuts off everything nearer to the eye than this, measured along the axis of sight. Default: a thousandth of "
         "the way to the look-at point, or 1e-5 of the scene's diameter if that is more. The least value that has an "
         "effect is 1e-6 of the diameter. Where it cuts a closed body, the section hides what lies behind it, and is "
         "filled. An outline is drawn round sections, and along the cuts of open bodies; with --union, round all "
         "sections together. These lines are in no table."},
    {.group = GROUP_VIEW,
     .name = "section",
     .flags = OPTION_DRAWS,
     .value = "X,Y,Z[,NX,NY,NZ]",
     .set = values_set_section,
     .excludes = "sheet plan part join",
     .brief = "cut off what is nearer than this point",
     .help = "cut off everything nearer to the viewer than this point; or, in parallel views, everything on the side "
             "of the point to which NX,NY,NZ points",
     .manual =
         "Cuts off everything nearer to the viewer than this point, measured along the axis of sight: with "
         "--view front, everything in front of the point. With a direction NX,NY,NZ, in a parallel view, the plane "
         "through the point and perpendicular to the direction cuts, and everything on the side to which it points is "
         "cut off: --section 0,0,0,1,0,0 shows the half of a model with x below 0, seen from the right or from iso. "
         "The direction must not point away from the viewer. Bodies are cut as by --near. With --turntable, the "
         "section turns with the viewer."},
    {.group = GROUP_VIEW,
     .name = "up",
     .flags = OPTION_DRAWS,
     .value = "X,Y,Z",
     .set = values_set_direction,
     TO(up),
     .brief = "what points up",
     .help =
         "the direction that points up in the drawing (default: 0,0,1, or 0,1,0 where that is parallel to the view)",
     .manual =
         "The direction that points up in the drawing. Default: 0,0,1, or 0,1,0 where that is parallel to the view. It "
         "turns the drawing only. For a model that lies on its side see --y-up."},
    {.group = GROUP_VIEW,
     .name = "y-up",
     .flags = OPTION_DRAWS,
     .set = values_set_flag,
     TO(y_up),
     .excludes = "plan part join",
     .brief = "the y axis of the model points up",
     .help = "stand the model up: its y axis points up, as in many OBJ and STL files",
     .manual = "Stands the model up before anything else: the point x,y,z becomes x,-z,y. For models whose y axis "
               "points up, as in many OBJ and STL files; roberts takes z to point up. All other options mean the model "
               "that stands: --view front, --azimuth, --eye X,Y,Z."},
    {.group = GROUP_VIEW,
     .name = "roll",
     .flags = OPTION_DRAWS,
     .value = "DEGREES",
     .set = values_set_number,
     TO(roll),
     RANGE(-360, 360),
     .brief = "turn the drawing",
     .help = "turn the drawing of any view, counter-clockwise (default: 0)",
     .manual = "Turns the drawing of any view, counter-clockwise. Default: 0."},

    /* ---- engine ---- */
    {.group = GROUP_ENGINE,
     .name = "threads",
     .value = "N",
     .set = values_set_integer,
     TO(hide.threads),
     RANGE(0, ROBERTS_THREADS_MOST),
     .brief = "how many",
     .help = "how many threads work, up to 1024 (default: 0, one per processor)",
     .manual =
         "How many threads work, up to 1024; with --batch, how many files are drawn at a time. Default: 0, one per "
         "processor. The drawing does not depend on it."},
    {.group = GROUP_ENGINE,
     .name = "grid",
     .value = "N",
     .set = values_set_integer,
     TO(hide.grid),
     RANGE(0, ROBERTS_GRID_MOST),
     .brief = "cells per side",
     .help = "cells per side of the grid, up to 4096, fewer where they take much memory (default: 0)",
     .manual =
         "Cells per side of the grid that keeps pairs of edge and face few, up to 4096. Default: 0. Fewer are "
         "made where the grid would take several times the scene's memory. It changes the time, never the drawing."},
    {.group = GROUP_ENGINE,
     .name = "epsilon",
     .flags = OPTION_DRAWS,
     .value = "E",
     .set = values_set_number,
     TO(hide.epsilon),
     RANGE(0, 1e150),
     .brief = "touching distance",
     .help = "points nearer than this touch, in model units (default: 0, 1e-11 of the scene's diameter)",
     .manual =
         "The touching distance, in model units, at most a hundredth of the scene: points nearer than this touch. "
         "Default: 0, which is 1e-11 of the scene's diameter, at least 16 units in the last place of the largest "
         "coordinate, and at least 2 such units of 32-bit floats if the file holds these (see also --rounded). "
         "Faces whose picture is narrower hide nothing, so it does not suit meshes of faces of that size. --stats says "
         "what it is and why."},
    {.group = GROUP_ENGINE,
     .name = "tolerance",
     .flags = OPTION_DRAWS,
     .value = "T",
     .set = values_set_number,
     TO(scene.tolerance),
     RANGE(0, 1),
     .brief = "how far from planar and convex",
     .help = "how far from planar and convex a solid may be, as a part of its size (default: 0, 1e-5)",
     .manual =
         "How far from planar and convex a solid may be, as a part of its size (the diagonal of its box). "
         "Default: 0, which is 1e-5. If all coordinates of a solid have at most six digits, or are 32-bit floats, "
         "it is a part of the largest of them instead, up to a hundred sizes.\nWhen a model is refused as not "
         "planar or not convex, the message names a tolerance that would accept it, where there is one up to "
         "0.01: the smallest 1, 2 or 5 times a power of ten that suffices. The limit is lower for a solid of more than "
         "six faces, 0.025 divided by the root of "
         "their number, and lower again for a solid that is farther from the origin than it is large: a greater "
         "tolerance would accept any shape. For models of more than 200,000 faces none is named."},

    /* ---- messages ---- */
    {.group = GROUP_MESSAGES,
     .name = "stats",
     .flags = OPTION_OPTIONAL,
     .value = "json",
     .words = values_stats,
     .set = values_set_stats,
     .brief = "counts and times",
     .help = "counts, tests and times, on standard error",
     .manual = "Prints counts, what each test decided, and times, on standard error; see STATISTICS. As JSON it is one "
               "object on a line for each picture."},
    {.group = GROUP_MESSAGES,
     .name = "verify",
     .flags = OPTION_OPTIONAL,
     .value = "N",
     .set = values_set_verify,
     TO(verify_rays),
     RANGE(1, UINT32_MAX),
     .brief = "check the drawing by rays",
     .help = "check the drawing by N rays per visible or hidden segment (default: 3); exit status 1 if any of them "
             "contradicts it",
     .manual =
         "Checks the drawing by casting N rays (default: 3) from points of each segment toward the viewer, and others "
         "wherever something may have been missed, and reports on standard error. Hidden segments are checked too, "
         "whether they are drawn or not, so it checks more segments than there are on the page. The exit status is 1 "
         "if any ray contradicts the drawing. Points within about epsilon of a change are reported as undecided and "
         "contradict nothing; if most points are, a warning says so.\n"
         "The points are not exactly N times the segments. Along a hidden segment, rays go from one hiding face to the "
         "next, in place of the two points near its ends: where one face hides it all, that is a single ray, and so "
         "N - 1 in all. There are more points where a face may hide a part of a visible segment, and one more on each "
         "hidden segment that is drawn, to see which body hides it."},

    {.group = GROUP_MESSAGES,
     .name = "pick",
     .flags = OPTION_REPEATS,
     .value = "X,Y",
     .set = values_set_pick,
     .brief = "what is seen there",
     .help = "say which body and face are seen there (x, y as in tables) and what lies behind; may be given several "
             "times",
     .manual =
         "Says what is seen at this point of the picture, and what lies behind it, nearest first: body, face, depth, "
         "and the point in the model. X and Y are those of tables: in model units, y up, counted from the middle of "
         "the scene's box or, in perspective, from the look-at point. Depth is how near the viewer it is, measured in "
         "model units from that same point along the axis of sight: greater is nearer, less than 0 is behind. Of a "
         "convex solid its front faces are named, of any other body all faces that are not seen edge-on, with --union "
         "too. May be given several times."},
    {.group = GROUP_MESSAGES,
     .name = "quiet",
     .letter = 'q',
     .set = values_set_flag,
     TO(quiet),
     .excludes = "verbose",
     .brief = "no warnings",
     .help = "no warnings, and no line of progress on a terminal",
     .manual = "No warnings, and no line of progress on a terminal. Errors are still reported, and so is what --stats, "
               "--verify and --pick print."},
    {.group = GROUP_MESSAGES,
     .name = "verbose",
     .letter = 'v',
     .set = values_set_flag,
     TO(verbose),
     .brief = "say what was read and written",
     .help = "say what was read and written",
     .manual =
         "Says what was read and written: bodies, vertices and faces of the file, the kinds of bodies if they are not "
         "all convex, the segments of the drawing, and which solids --hull has replaced."},
    {.group = GROUP_MESSAGES,
     .name = "help",
     .letter = 'h',
     .flags = OPTION_ALONE,
     .set = values_set_flag,
     TO(help),
     .brief = "help",
     .help = "this text",
     .manual = "Prints a summary of the options."},
    {.group = GROUP_MESSAGES,
     .name = "version",
     .letter = 'V',
     .flags = OPTION_ALONE,
     .set = values_set_flag,
     TO(version),
     .brief = "version",
     .help = "the version",
     .manual = "Prints the version."},
};

const option_table option_table_all = {rows, COUNT(rows)};
