/* test_readme.c - the commands of the README work as printed, and its links and file names exist.
 *
 * In a new folder with links to build, include and models, each line of a ```sh block of the README, of the page on the
 * models and of the recipes is run as printed, with `roberts` the one in build, and the ```c block is compiled, as
 * example.c, by the README's own command, where `cc` is the compiler that built the library (CC). The constants and
 * files on the pages of the rooms are checked too. A block with a name after its language (```python seen.py) is first
 * written to a file of that name. Lines that need a program that is not installed are left out with a message, and so
 * are those that call `make`, which runs this test. */
#include <ctype.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "folders.h"
#include "sanitized.h"
#include "temporary.h"
#include "testing.h"

/* Runs a shell command and gives its exit status. */
static int shell(const char *command)
{
    return system(command); /* NOLINT(cert-env33-c): the README's commands are shell commands */
}

/* Links `name` in the folder to `target`, a path from the top folder or an absolute one. */
static int link_in(const char *top, const char *target, const char *name)
{
    char from[4096], to[512];
    snprintf(from, sizeof from, "%s%s%s", target[0] == '/' ? "" : top, target[0] == '/' ? "" : "/", target);
    snprintf(to, sizeof to, "%s/%s", temporary, name);
    return symlink(from, to);
}

static int set_up(void **state)
{
    char top[2048];
    if (!getcwd(top, sizeof top) || temporary_make(state) != 0)
        return -1;
    return link_in(top, build_folder(), "build") || link_in(top, "include", "include") ||
           link_in(top, "models", "models");
}

/* Size of a file in the folder; -1: there is none. */
static long size_of(const char *name)
{
    char path[512];
    struct stat about;
    snprintf(path, sizeof path, "%s/%s", temporary, name);
    return stat(path, &about) == 0 ? (long)about.st_size : -1;
}

/* Runs one command of the README in the folder: it succeeds and leaves something in `output` there, or prints it. */
static void run_command(const char *command, const char *output)
{
    char script[512], line[1024];
    snprintf(script, sizeof script, "%s/command.sh", temporary);
    FILE *f = fopen(script, "w");
    assert_non_null(f);
    fprintf(f, "cc() { command ${CC:-cc} \"$@\"; }\nPATH=$PWD/build:$PATH HOME=$PWD\n%s\n", command);
    assert_int_equal(fclose(f), 0);
    snprintf(line, sizeof line, "cd '%s' && MAKEFLAGS= sh -e command.sh >printed 2>&1", temporary);
    int status = shell(line);
    if (status != 0 || size_of(output) <= 0) {
        snprintf(line, sizeof line, "cat '%s/printed' >&2", temporary);
        shell(line);
        fail_msg("exit status %d, %ld bytes in %s: %s", status, size_of(output), output, command);
    }
}

/* The file that a command line writes: what follows "-o ", "> " or "--regions ", of a numbered row the first one; else
 * the last word, where that has an ending and no such file is there yet; else what is printed. */
static void output_of(const char *line, char output[64])
{
    char command[1024];
    snprintf(command, sizeof command, "%s", line);
    char *comment = strstr(command, " #");
    if (comment)
        *comment = '\0';
    const char *o = strstr(command, " -o "), *redirect = strstr(command, " > "), *last = strrchr(command, ' ');
    const char *regions = strstr(command, " --regions ");
    char name[64] = "printed";
    if (o || redirect)
        sscanf(o ? o + 4 : redirect + 3, "%63s", name);
    else if (regions)
        sscanf(regions + strlen(" --regions "), "%63s", name);
    else if (last && strchr(last, '.') && !strpbrk(last, "*/") && size_of(last + 1) < 0)
        sscanf(last, "%63s", name);
    const char *number = strstr(name, "%03d");
    if (number)
        snprintf(output, 64, "%.*s000%s", (int)(number - name), name, number + 4);
    else
        snprintf(output, 64, "%s", name);
}

/* Whether the line calls a program that is not installed. */
static bool lacks_program(const char *line)
{
    static const char *const programs[] = {"rbox",   "qconvex", "inkscape", "vpype",   "pdflatex",
                                           "ffmpeg", "python3", "gnuplot",  "parallel"};
    for (size_t i = 0; i < sizeof programs / sizeof programs[0]; i++) {
        char called[16], piped[32], probe[64];
        snprintf(called, sizeof called, "%s ", programs[i]);
        snprintf(piped, sizeof piped, "| %s", called);
        snprintf(probe, sizeof probe, "command -v %s >/dev/null", programs[i]);
        if ((strncmp(line, called, strlen(called)) == 0 || strstr(line, piped)) && shell(probe) != 0) {
            print_message("no %s: %s\n", programs[i], line);
            return true;
        }
    }
    return false;
}

/* Pages whose commands are run. */
static const char *const pages[] = {"README.md", "models/README.md", "models/recipes.md", "models/many.md"};
enum { PAGES = sizeof pages / sizeof pages[0] };

/* Reads one line, without its end. A backslash before the end joins it to the next line. */
static bool read_line(FILE *text, char *line, size_t room)
{
    size_t length = 0;
    while (fgets(line + length, (int)(room - length), text)) {
        length += strcspn(line + length, "\n");
        line[length] = '\0';
        if (length == 0 || line[length - 1] != '\\')
            return true;
        length--;
    }
    return length > 0;
}

/* Gives the lines of a page's ````language` blocks, one after the other, to `use`. */
static int each_line(const char *page, const char *language, void use(const char *line, void *context), void *context)
{
    FILE *text = fopen(page, "r");
    char line[1024];
    int count = 0, inside = 0;
    assert_non_null(text);
    while (read_line(text, line, sizeof line)) {
        if (strncmp(line, "```", 3) == 0) {
            inside = !inside && strcmp(line + 3, language) == 0;
        } else if (inside) {
            use(line, context);
            count++;
        }
    }
    fclose(text);
    return count;
}

/* Writes the blocks of a page that have a name to files of that name. */
static void write_named_blocks(const char *page)
{
    FILE *text = fopen(page, "r"), *file = NULL;
    char line[1024], name[64], path[512];
    bool inside = false;
    assert_non_null(text);
    while (fgets(line, sizeof line, text)) {
        if (strncmp(line, "```", 3) != 0) {
            if (file)
                fputs(line, file);
            continue;
        }
        if (file)
            assert_int_equal(fclose(file), 0);
        file = NULL;
        inside = !inside;
        if (inside && sscanf(line, "```%*s %63s", name) == 1) {
            snprintf(path, sizeof path, "%s/%s", temporary, name);
            file = fopen(path, "w");
            assert_non_null(file);
        }
    }
    assert_null(file);
    fclose(text);
}

/* Fails, with what to do, if the line calls a program of build that is not built. */
static void need_built(const char *line)
{
    char program[64], path[512];
    snprintf(path, sizeof path, "%s/build/roberts", temporary);
    if (access(path, X_OK) != 0)
        fail_msg("there is no build/roberts: run `make all tools` first");
    if (sscanf(line, "%63s", program) != 1 || strncmp(program, "build/", 6) != 0)
        return;
    snprintf(path, sizeof path, "%s/%s", temporary, program);
    if (access(path, X_OK) != 0)
        fail_msg("there is no %s: run `make all tools` first", program);
}

static void try_command(const char *line, void *context)
{
    char output[64];
    bool our_make = strncmp(line, "make ", 5) == 0 && strncmp(line, "make -f ", 8) != 0;
    bool clone = strncmp(line, "git clone ", 10) == 0;
    if (our_make || clone || strncmp(line, "cc ", 3) == 0 || lacks_program(line))
        return;
    need_built(line);
    output_of(line, output);
    run_command(line, output);
    ++*(int *)context;
}

static void test_commands(void **state)
{
    (void)state;
    int tried = 0;
    for (int i = 0; i < PAGES; i++) {
        write_named_blocks(pages[i]);
        each_line(pages[i], "sh", try_command, &tried);
    }
    assert_true(tried > 15);
}

/* ---- blocks that nothing runs ---- */

/* Blocks that test_commands() neither runs nor writes to a file: how many a page has, and why. */
static const struct {
    const char *page, *language;
    int count;
    const char *why;
} other_blocks[] = {
    {"README.md", "c", 1, "test_example() compiles it"},
    {"README.md", "", 1, "a path from file to file"},
    {"README.md", "python", 1, "tests/python/test_roberts.py runs it"},
    {"models/recipes.md", "python octahedron.py", 1, "tests/python/test_roberts.py runs it"},
    {"models/recipes.md", "latex", 1, "a part of a document, which has no end of its own"},
    {"models/many.md", "sbatch shards.sbatch", 1, "test_cluster.c gives it to Slurm"},
    {"models/gallery/README.md", "sh", 1, "test_gallery.c runs its commands"},
    {"src/README.md", "", 1, "a path from file to file"},
    {"src/cli/README.md", "", 1, "a path from argv to the exit status"},
    {"src/cli/README.md", "c", 1, "a row of a table; test_options.c adds one of its own"},
};
enum { OTHERS = sizeof other_blocks / sizeof other_blocks[0] };

static bool is_run(const char *page)
{
    for (int i = 0; i < PAGES; i++)
        if (strcmp(pages[i], page) == 0)
            return true;
    return false;
}

typedef struct mention {
    const char *name;
    bool found;
} mention;

static void find_mention(const char *line, void *context)
{
    mention *m = context;
    m->found = m->found || strstr(line, m->name);
}

/* Reads the opening line of a block. Returns whether test_commands() runs the block, or some command names its file. */
static bool block_is_used(const char *path, const char *page, const char *opening)
{
    char language[32] = "", name[64] = "";
    if (sscanf(opening, "```%31s %63s", language, name) < 2)
        return strcmp(language, "sh") == 0 && is_run(page);
    mention m = {name, false};
    each_line(path, "sh", find_mention, &m);
    return is_run(page) && m.found;
}

/* Counts the blocks of a file, called `page` in the table, that nothing runs and no row explains. */
static int unused_blocks(const char *path, const char *page)
{
    int left[OTHERS], unused = 0;
    char line[1024];
    bool inside = false;
    FILE *text = fopen(path, "r");
    assert_non_null(text);
    for (int i = 0; i < OTHERS; i++)
        left[i] = strcmp(other_blocks[i].page, page) == 0 ? other_blocks[i].count : 0;
    while (fgets(line, sizeof line, text)) {
        const bool indented = isspace((unsigned char)line[0]) && strncmp(line + strspn(line, " \t"), "```", 3) == 0;
        if (indented)
            print_message("%s: an indented block is not run: %s", path, line);
        unused += indented;
        if (strncmp(line, "```", 3) != 0)
            continue;
        inside = !inside;
        if (!inside || block_is_used(path, page, line))
            continue;
        line[strcspn(line, "\n")] = '\0';
        int row = 0;
        while (row < OTHERS && (left[row] == 0 || strcmp(other_blocks[row].language, line + 3) != 0))
            row++;
        if (row == OTHERS)
            print_message("%s: nothing runs the block %s\n", path, line);
        else
            left[row]--;
        unused += row == OTHERS;
    }
    for (int i = 0; i < OTHERS; i++)
        if (left[i] > 0)
            fail_msg("%s: fewer blocks ```%s than the test's table says", path, other_blocks[i].language);
    fclose(text);
    return unused;
}

/* Every block of every page is run, is a file that a command uses, or has a row with the reason. */
static void test_blocks(void **state)
{
    static const char page[] = "```text a.txt\n1\n```\n```sh\nroberts a.txt\n```\n"
                               "```bash\nroberts b.txt\n```\n```text b.txt\n2\n```\n    ```sh\n    true\n    ```\n";
    char path[512];
    glob_t texts;
    (void)state;
    snprintf(path, sizeof path, "%s/page.md", temporary);
    write_text(path, page);
    assert_int_equal(unused_blocks(path, "models/README.md"), 4); /* bash, b.txt, both ends of the indented one */
    assert_int_equal(unused_blocks(path, "a page whose commands are not run"), 6);
    assert_int_equal(glob("README.md", 0, NULL, &texts), 0);
    assert_int_equal(glob("*/*.md", GLOB_APPEND, NULL, &texts), 0);
    assert_int_equal(glob("*/*/README.md", GLOB_APPEND, NULL, &texts), 0);
    assert_true(texts.gl_pathc > 10);
    for (size_t i = 0; i < texts.gl_pathc; i++)
        assert_int_equal(unused_blocks(texts.gl_pathv[i], texts.gl_pathv[i]), 0);
    globfree(&texts);
}

/* ---- the page whose faces name themselves ---- */

/* A script for the page: it moves the pointer over each face, and adds what the page says of it and its colour. A page
 * without a real pointer hovers over nothing, so the rule for :hover is copied for faces of a class. Then it adds
 * whether a pointer that goes over the page line by line finds nearly all faces (some are small), and no edge. */
static const char pointer_script[] =
    "<script>document.head.append(Object.assign(document.createElement('style'), {textContent:"
    "document.querySelector('style').textContent.replace(':hover', '.hovered')}));"
    "function add(name, text) {"
    "document.body.insertAdjacentHTML('beforeend', `<p class=${name}>${text}</p>`); }"
    "const found = new Set(), others = new Set();"
    "const box = document.querySelector('svg').getBoundingClientRect();"
    "for (let y = box.top; y < Math.min(box.bottom, innerHeight); y += 2)"
    "for (let x = box.left; x < Math.min(box.right, innerWidth); x += 2) {"
    "const there = document.elementFromPoint(x, y);"
    "(there.matches('.region') ? found : others).add(there); }"
    "const faces = document.querySelectorAll('.region');"
    "for (const face of faces) {"
    "face.dispatchEvent(new MouseEvent('mouseover', {bubbles: true}));"
    "face.classList.add('hovered');"
    "add('said', document.getElementById('name').textContent + ': ' + getComputedStyle(face).fill);"
    "face.classList.remove('hovered'); }"
    "const edge = [...others].some(other => other.matches('.edge'));"
    "add('found', `${found.size > 0.9 * faces.length && !edge}`);</script>";

/* Every face of the drawing is in the group of a body, and has a number. Returns how many there are. */
static int count_faces(const char *page)
{
    char line[4096];
    int faces = 0, bodies = 0;
    FILE *text = fopen(page, "r");
    assert_non_null(text);
    while (fgets(line, sizeof line, text)) {
        if (strncmp(line, "<g class=\"body\" data-body=\"", 27) == 0)
            bodies++;
        if (!strstr(line, "<path class=\"region\""))
            continue;
        assert_int_equal(strncmp(line, "<path class=\"region\" data-face=\"", 32), 0);
        assert_true(bodies > 0);
        faces++;
    }
    fclose(text);
    return faces;
}

/* The recipe's page, made by test_commands(). Chromium moves over it where it is installed. */
static void test_page_of_faces(void **state)
{
    char path[512], command[2048];
    (void)state;
    snprintf(path, sizeof path, "%s/faces.html", temporary);
    if (access(path, R_OK) != 0)
        fail_msg("there is no faces.html: the commands of the recipes, tested before, make it");
    const int faces = count_faces(path);
    assert_true(faces > 50);
    FILE *page = fopen(path, "a");
    assert_non_null(page);
    fputs(pointer_script, page);
    assert_int_equal(fclose(page), 0);
    snprintf(
        command, sizeof command,
        "for name in chromium chromium-browser google-chrome; do browser=$(command -v $name) && break; done; "
        "[ -n \"$browser\" ] || exit 77; cd '%s' && HOME=$PWD timeout 120 \"$browser\" --headless --no-sandbox "
        "--disable-gpu --disable-dev-shm-usage --disable-quic --no-first-run --disable-background-networking "
        "--disable-component-update --disable-sync --window-size=1000,800 --user-data-dir=\"$PWD/profile\" --dump-dom "
        "\"file://$PWD/faces.html\" > dom.html 2>/dev/null && "
        "test $(grep -o 'class=\"said\">face [0-9]* of body [0-9]*: rgb(255, 215, 0)<' dom.html | wc -l) = %d && "
        "grep -q 'class=\"found\">true<' dom.html",
        temporary, faces);
    const int status = shell(command);
    if (status == 77 * 256) {
        SKIP_BECAUSE("no Chromium: the page's markup is sound, but its script has not run");
    }
    assert_int_equal(status, 0);
}

static void write_line(const char *line, void *context)
{
    fprintf(context, "%s\n", line);
}

static void try_compiling(const char *line, void *context)
{
    if (strncmp(line, "cc ", 3) != 0)
        return;
    run_command(line, "example");
    ++*(int *)context;
}

/* The example prints one line for each visible row of the table. */
static void test_example(void **state)
{
    (void)state;
    char path[512];
    int compiled = 0;
    if (SANITIZED)
        SKIP_BECAUSE("the README's command cannot link a library with sanitizers");
    snprintf(path, sizeof path, "%s/example.c", temporary);
    FILE *example = fopen(path, "w");
    assert_non_null(example);
    assert_true(each_line("README.md", "c", write_line, example) > 0);
    assert_int_equal(fclose(example), 0);
    each_line("README.md", "sh", try_compiling, &compiled);
    assert_int_equal(compiled, 1);
    run_command("./example models/table.off > segments", "segments");
    run_command("build/roberts -f csv models/table.off > rows.csv", "rows.csv");
    run_command("test $(wc -l < segments) -eq $(grep -c visible rows.csv) && echo same", "printed");
}

/* The relative links of one text, from [...](target) and src="target", lead to files. Returns how many. */
static int check_links(const char *path)
{
    char line[2048], target[512];
    int links = 0, length = (int)(strrchr(path, '/') ? strrchr(path, '/') + 1 - path : 0);
    FILE *text = fopen(path, "r");
    assert_non_null(text);
    while (fgets(line, sizeof line, text))
        for (const char *at = line, *link, *image; *at; at++) {
            link = strncmp(at, "](", 2) == 0 ? at + 2 : NULL;
            image = strncmp(at, "src=\"", 5) == 0 ? at + 5 : NULL;
            int size = link ? (int)strcspn(link, "#)") : image ? (int)strcspn(image, "\"") : 0;
            link = link ? link : image;
            if (size == 0 || strncmp(link, "http", 4) == 0)
                continue;
            snprintf(target, sizeof target, "%.*s%.*s", length, path, size, link);
            if (access(target, F_OK) != 0)
                fail_msg("%s: there is no %s", path, target);
            links++;
        }
    fclose(text);
    return links;
}

static void test_links(void **state)
{
    glob_t texts;
    int links = 0;
    (void)state;
    assert_int_equal(glob("README.md", 0, NULL, &texts), 0);
    assert_int_equal(glob("*/*.md", GLOB_APPEND, NULL, &texts), 0);
    assert_int_equal(glob("*/*/README.md", GLOB_APPEND, NULL, &texts), 0);
    for (size_t i = 0; i < texts.gl_pathc; i++)
        links += check_links(texts.gl_pathv[i]);
    globfree(&texts);
    assert_true(links > 4);
}

/* ---- files that pages name ---- */

/* Whether a word is the name of one file: letters, an ending that files of this project have, no pattern. */
static bool is_file_name(const char *word)
{
    static const char *const endings[] = {"c",  "h",   "cpp", "off", "stl", "obj",  "ply",
                                          "md", "txt", "svg", "sh",  "py",  "dict", "supp"};
    const char *dot = strrchr(word, '.');
    if (!dot || dot == word || dot[-1] == '/' ||
        strspn(word, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                     "0123456789_-./") != strlen(word))
        return false;
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++)
        if (strcmp(dot + 1, endings[i]) == 0)
            return true;
    return false;
}

/* Whether the file is there: from the folder of the page, from src/, tests/, one folder of tests/, or the top. */
static bool is_there(const char *page, const char *name)
{
    const char *slash = strrchr(page, '/');
    char path[512];
    const int length = slash ? (int)(slash + 1 - page) : 0;
    static const char *const patterns[] = {"src/%s", "include/%s", "tests/%s", "tests/*/%s", "%s"};
    snprintf(path, sizeof path, "%.*s%s", length, page, name);
    bool found = access(path, F_OK) == 0;
    for (size_t i = 0; i < sizeof patterns / sizeof patterns[0] && !found; i++) {
        glob_t files;
        const char *place = strstr(patterns[i], "%s");
        snprintf(path, sizeof path, "%.*s%s", (int)(place - patterns[i]), patterns[i], name);
        found = glob(path, 0, NULL, &files) == 0;
        globfree(&files);
    }
    return found;
}

/* Names that stand for any file, and files that the reader's own commands write. */
static bool is_example(const char *name)
{
    static const char *const examples[] = {"test_NAME.c", "models/INDEX.md"};
    for (size_t i = 0; i < sizeof examples / sizeof examples[0]; i++)
        if (strcmp(name, examples[i]) == 0)
            return true;
    return false;
}

/* Words in single backquotes, outside of blocks, that name a file name one that is there. Returns how many. */
static int check_names(const char *page)
{
    static char text[65536];
    char name[128];
    int names = 0;
    FILE *file = fopen(page, "r");
    assert_non_null(file);
    const size_t size = fread(text, 1, sizeof text - 1, file);
    assert_true(size < sizeof text - 1);
    text[size] = '\0';
    fclose(file);
    for (char *at = text; (at = strchr(at, '`')) != NULL;) {
        const bool block = strncmp(at, "```", 3) == 0;
        char *end = block ? strstr(at + 3, "```") : strchr(at + 1, '`');
        if (!end)
            fail_msg("%s: a backquote without its other: %.40s", page, at);
        if (!block && end - at < (int)sizeof name) {
            snprintf(name, sizeof name, "%.*s", (int)(end - at - 1), at + 1);
            if (is_file_name(name) && !is_example(name)) {
                if (!is_there(page, name))
                    fail_msg("%s: there is no %s", page, name);
                names++;
            }
        }
        at = end + (block ? 3 : 1);
    }
    return names;
}

static void test_names(void **state)
{
    static const char *const patterns[] = {"README.md", "src/*.md", "src/*/README.md", "tests/README.md",
                                           "models/*.md"};
    int names = 0;
    (void)state;
    assert_true(is_file_name("read/off.c") && is_file_name("README.md") && is_file_name("models/table.off"));
    assert_true(!is_file_name(".svg") && !is_file_name("*.off") && !is_file_name("a b.c") && !is_file_name("0.5"));
    assert_true(is_there("src/README.md", "read/read.c") && !is_there("src/README.md", "read/none.c"));
    for (size_t i = 0; i < sizeof patterns / sizeof patterns[0]; i++) {
        glob_t texts;
        assert_int_equal(glob(patterns[i], 0, NULL, &texts), 0);
        for (size_t k = 0; k < texts.gl_pathc; k++)
            names += check_names(texts.gl_pathv[k]);
        globfree(&texts);
    }
    assert_true(names > 200);
}

/* ---- pages on the stages ---- */

/* Whether some line of a source of the room holds both words. */
static bool stands_in_room(const char *room, const char *name, const char *value)
{
    char pattern[256], line[2048];
    bool found = false;
    glob_t sources;
    snprintf(pattern, sizeof pattern, "%s*.[ch]", room);
    assert_int_equal(glob(pattern, 0, NULL, &sources), 0);
    for (size_t i = 0; i < sources.gl_pathc && !found; i++) {
        FILE *source = fopen(sources.gl_pathv[i], "r");
        assert_non_null(source);
        while (!found && fgets(line, sizeof line, source)) {
            const char *at = strstr(line, name);
            found = at && strstr(at + strlen(name), value);
        }
        fclose(source);
    }
    globfree(&sources);
    return found;
}

/* Copies the text between the first two backquotes from `at` on; returns the rest after them; NULL: there are none. */
static const char *quoted(const char *at, char word[64])
{
    const char *open = strchr(at, '`'), *close = open ? strchr(open + 1, '`') : NULL;
    if (!close || close - open > 63)
        return NULL;
    snprintf(word, 64, "%.*s", (int)(close - open - 1), open + 1);
    return close + 1;
}

/* Rows of tables that begin with a file are of files that are there; those of a name and a value, both in backquotes,
 * are constants of the room with that value. Returns how many. */
static int check_page(const char *path)
{
    char line[2048], room[64], first[64], second[64], file[192];
    int checked = 0;
    FILE *page = fopen(path, "r");
    assert_non_null(page);
    snprintf(room, sizeof room, "%.*s", (int)(strrchr(path, '/') + 1 - path), path);
    while (fgets(line, sizeof line, page)) {
        const char *rest;
        if (strncmp(line, "| `", 3) != 0 || !(rest = quoted(line, first)))
            continue;
        bool is_file = strstr(first, ".c") || strstr(first, ".h");
        bool is_name = isalpha((unsigned char)first[0]) && strcspn(first, "-. /") == strlen(first);
        if (is_name && strncmp(rest, " | `", 4) == 0 && quoted(rest, second)) {
            if (!stands_in_room(room, first, second))
                fail_msg("%s: no %s of %s in the sources", path, first, second);
            checked++;
        }
        char *end = strstr(line + 2, " | "); /* of the first column */
        if (is_file && end)
            *end = '\0';
        for (const char *at = line; is_file && (at = quoted(at, first)); checked++) {
            snprintf(file, sizeof file, "%s%s", room, first);
            if (access(file, F_OK) != 0)
                fail_msg("%s: there is no %s", path, file);
        }
    }
    fclose(page);
    return checked;
}

/* Every source of the room is named in its page. Returns whether the room has C sources. */
static bool check_files(const char *path)
{
    static char text[65536];
    char pattern[64], name[128];
    glob_t sources;
    const int length = (int)(strrchr(path, '/') + 1 - path);
    bool is_c;
    FILE *page = fopen(path, "r");
    assert_non_null(page);
    text[fread(text, 1, sizeof text - 1, page)] = '\0';
    fclose(page);
    snprintf(pattern, sizeof pattern, "%.*s*.[ch]", length, path);
    is_c = glob(pattern, 0, NULL, &sources) == 0;
    snprintf(pattern, sizeof pattern, "%.*s*/*.py", length, path);
    assert_true(glob(pattern, is_c ? GLOB_APPEND : 0, NULL, &sources) == 0 || is_c);
    for (size_t i = 0; i < sources.gl_pathc; i++) {
        snprintf(name, sizeof name, "`%s`", sources.gl_pathv[i] + length);
        if (!strstr(text, name))
            fail_msg("%s does not name %s", path, name);
    }
    globfree(&sources);
    return is_c;
}

static void test_pages(void **state)
{
    glob_t rooms;
    (void)state;
    assert_int_equal(glob("src/*/README.md", 0, NULL, &rooms), 0);
    assert_true(rooms.gl_pathc >= 5);
    for (size_t i = 0; i < rooms.gl_pathc; i++) {
        const int rows = check_page(rooms.gl_pathv[i]);
        assert_true(!check_files(rooms.gl_pathv[i]) || rows > 8);
    }
    globfree(&rooms);
}

/* The program draws the figures. Another version of Cairo may write the same path differently. */
static void test_figures(void **state)
{
    char command[1024];
    (void)state;
    if (shell("pkg-config --modversion cairo | grep -q '^1[.]16[.]'") != 0) {
        SKIP_BECAUSE("figures were drawn with Cairo 1.16");
    }
    snprintf(command, sizeof command,
             "ROBERTS_BUILD='%s' tools/draw-figures.sh '%s/figures' && diff -r '%s/figures' models/figures >&2",
             build_folder(), temporary, temporary);
    assert_int_equal(shell(command), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_links),         cmocka_unit_test(test_names),   cmocka_unit_test(test_pages),
        cmocka_unit_test(test_figures),       cmocka_unit_test(test_blocks),  cmocka_unit_test(test_commands),
        cmocka_unit_test(test_page_of_faces), cmocka_unit_test(test_example),
    };
    return cmocka_run_group_tests_name("readme", tests, set_up, temporary_remove);
}
