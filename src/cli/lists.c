/* lists.c - lists that the user writes: names of files, one per line; names of vertices, edges, faces and bodies, in
 * lines KIND,NUMBER,NAME. */
#include "cli/lists.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "cli/parse.h"

enum {
    PIECE = 4096,                   /* bytes read at a time */
    FILES_MOST = 256 * 1024 * 1024, /* bytes of a list of files: more than two million names of a hundred */
    NAMES_MOST = 32 * 1024 * 1024   /* bytes of a list of names */
};

/* ---- the text of a list ---- */

roberts_status lists_fail(roberts_error *error, roberts_status status, const char *path, size_t line, const char *why)
{
    *error = (roberts_error){.status = status, .line = line};
    snprintf(error->file, sizeof error->file, "%s", path);
    snprintf(error->message, sizeof error->message, "%s", why);
    return status;
}

/* Reads all `*size` bytes of an open file, of which there may be about `most`; a NUL follows them. Errors name the file
 * `path`. The caller frees `*text`, after a failure too. Returns ROBERTS_OK, _IO, _NO_MEMORY or _BAD_SYNTAX (it is too
 * long). */
static roberts_status read_stream(FILE *file, const char *path, size_t most, char **text, size_t *size,
                                  roberts_error *error)
{
    size_t room = 0;
    *text = NULL;
    *size = 0;
    for (size_t got = 1; got > 0; *size += got) {
        if (*size + PIECE > room) {
            if (*size > most)
                return lists_fail(error, ROBERTS_BAD_SYNTAX, path, 0, "is too long");
            room = 2 * room + 2 * PIECE;
            char *grown = realloc(*text, room);
            if (!grown)
                return lists_fail(error, ROBERTS_NO_MEMORY, path, 0, "not enough memory");
            *text = grown;
        }
        got = fread(*text + *size, 1, PIECE - 1, file);
    }
    (*text)[*size] = '\0';
    if (!ferror(file))
        return ROBERTS_OK;
    return lists_fail(error, ROBERTS_IO, path, 0, errno == EISDIR ? "is a folder" : "cannot be read");
}

/* The same for a file by its name. */
static roberts_status read_whole(const char *path, size_t most, char **text, size_t *size, roberts_error *error)
{
    FILE *file = fopen(path, "rb");
    *text = NULL;
    *size = 0;
    if (!file)
        return lists_fail(error, ROBERTS_IO, path, 0, strerror(errno));
    const roberts_status status = read_stream(file, path, most, text, size, error);
    fclose(file);
    return status;
}

/* Skips a byte-order mark, as editors and spreadsheets write it. */
static char *skip_mark(char *text)
{
    static const char mark[] = "\xef\xbb\xbf";
    return strncmp(text, mark, sizeof mark - 1) == 0 ? text + sizeof mark - 1 : text;
}

/* Removes the CR at the end of a line. */
static void cut_cr(char *line)
{
    const size_t length = strlen(line);
    if (length > 0 && line[length - 1] == '\r')
        line[length - 1] = '\0';
}

/* ---- names of files ---- */

bool list_add(file_list *list, char *name)
{
    if (list->count == list->room) {
        const size_t room = 2 * list->room + 64;
        char **grown = realloc(list->name, room * sizeof *grown); /* NOLINT(bugprone-sizeof-expression): of a pointer */
        if (!grown)
            return false;
        list->name = grown;
        list->room = room;
    }
    list->name[list->count++] = name;
    return true;
}

static roberts_status read_files(file_list *list, const char *path, size_t *size, roberts_error *error)
{
    if (strcmp(path, "-") == 0)
        return read_stream(stdin, "standard input", FILES_MOST, &list->text, size, error);
    return read_whole(path, FILES_MOST, &list->text, size, error);
}

roberts_status list_read(file_list *list, const char *path, roberts_error *error)
{
    size_t size, line = 0, first = list->count;
    const char *called = strcmp(path, "-") == 0 ? "standard input" : path;
    roberts_status status = read_files(list, path, &size, error);
    if (status != ROBERTS_OK)
        return status;
    const char end = memchr(list->text, '\0', size) ? '\0' : '\n';
    for (char *at = end == '\n' ? skip_mark(list->text) : list->text, *next; at < list->text + size; at = next) {
        char *stop = memchr(at, end, (size_t)(list->text + size - at));
        next = stop ? stop + 1 : list->text + size;
        if (stop)
            *stop = '\0'; /* a NUL follows the last name in any case */
        if (end == '\n')
            cut_cr(at);
        line++;
        if (*at == '\0')
            continue;
        if (strcmp(at, "-") == 0)
            return lists_fail(error, ROBERTS_BAD_SYNTAX, called, line, "- is no file; a file of this name is ./-");
        if (!list_add(list, at))
            return lists_fail(error, ROBERTS_NO_MEMORY, called, 0, "not enough memory");
    }
    return list->count > first ? ROBERTS_OK : lists_fail(error, ROBERTS_BAD_SYNTAX, called, 0, "the list is empty");
}

void list_free(file_list *list)
{
    free(list->name);
    free(list->text);
    *list = (file_list){0};
}

bool file_identify(const char *name, file_identity *file)
{
    struct stat found;
    if (strcmp(name, "-") == 0 || stat(name, &found) != 0 || !S_ISREG(found.st_mode))
        return false;
    *file = (file_identity){found.st_dev, found.st_ino};
    return true;
}

int file_identity_order(const void *a, const void *b)
{
    const file_identity *p = a, *q = b;
    if (p->device != q->device)
        return p->device < q->device ? -1 : 1;
    return (p->number > q->number) - (p->number < q->number);
}

/* ---- names of things in a model ---- */

/* Reads the whole file; the text ends with a NUL. */
static roberts_status read_names(name_list *n, const char *path, roberts_error *error)
{
    size_t size;
    const roberts_status status = read_whole(path, NAMES_MOST, &n->text, &size, error);
    if (status == ROBERTS_OK && memchr(n->text, '\0', size))
        return lists_fail(error, ROBERTS_BAD_SYNTAX, path, 0, "is no text");
    return status;
}

static const char wrong_quotes[] =
    "a quotation mark opens this field, and none closes it at its end; two within it stand for one";

/* Removes blanks at both ends. */
static char *trim(char *text)
{
    text += strspn(text, " \t");
    size_t length = strlen(text);
    while (length > 0 && strchr(" \t\r", text[length - 1]))
        text[--length] = '\0';
    return text;
}

/* Takes the first field of a line of CSV (RFC 4180), without the quotation marks round it. `*rest` receives what
 * follows the comma, or NULL at the end of the line. NULL: the closing quotation mark is not at the field's end. */
static char *take_field(char *line, char comma, char **rest)
{
    char *to = line, *at = line + 1;
    if (*line != '"') {
        *rest = strchr(line, comma);
        if (*rest)
            *(*rest)++ = '\0';
        return trim(line);
    }
    for (; *at && (at[0] != '"' || at[1] == '"'); at++) {
        at += *at == '"'; /* two of them stand for one */
        *to++ = *at;
    }
    if (at[0] != '"' || (at[1] != comma && at[1] != '\0'))
        return NULL;
    *rest = at[1] == comma ? at + 2 : NULL;
    *to = '\0';
    return line;
}

/* Takes the name, which is the rest of the line. Only in quotation marks may it end with commas: spreadsheets fill rows
 * up with them. Returns why it is wrong, or NULL. */
static const char *take_name(char *rest, char comma, const char **name)
{
    char *more = NULL;
    rest = trim(rest);
    for (size_t length = strlen(rest); length > 0 && rest[length - 1] == comma; length--)
        rest[length - 1] = '\0';
    *name = *rest == '"' ? take_field(rest, comma, &more) : rest;
    if (!*name)
        return wrong_quotes;
    return more ? "more fields follow the name; a name with commas stands in quotation marks" : NULL;
}

/* A number, as 4, or as labels show it beside those of other kinds: v4. */
static bool take_number(const char *text, char letter, uint32_t *number)
{
    return parse_integer(*text == letter || *text == letter - 'a' + 'A' ? text + 1 : text, number);
}

/* Reads one line, whose fields are separated by `comma`. Returns why it is wrong, or NULL. Sets *titles if it may be
 * the titles of the columns. */
static const char *read_line(char *line, char comma, roberts_name *name, bool *titles)
{
    static const char *const kinds[] = {"vertex", "edge", "face", "body", NULL};
    static const roberts_label_kind of[] = {ROBERTS_LABEL_VERTICES, ROBERTS_LABEL_EDGES, ROBERTS_LABEL_FACES,
                                            ROBERTS_LABEL_BODIES};
    char *number = NULL, *text = NULL, *word = take_field(line, comma, &number);
    if (word && number)
        number = take_field(number, comma, &text);
    if (!word || (text && !number))
        return wrong_quotes;
    if (!text)
        return "a line is KIND,NUMBER,NAME, as vertex,4,A or edge,4-17,a";
    for (char *c = word; *c; c++)
        *c = (char)(*c >= 'A' && *c <= 'Z' ? *c - 'A' + 'a' : *c);
    const size_t kind = parse_find(word, kinds);
    *titles = !kinds[kind] && !strpbrk(number, "0123456789");
    if (*titles)
        return "the kind is none of vertex, edge, face and body, and the second field is no number";
    if (!kinds[kind])
        return "the kind is none of vertex, edge, face and body";
    *name = (roberts_name){.of = of[kind]};
    const char *why = take_name(text, comma, &name->text);
    if (why)
        return why;
    char *second = name->of == ROBERTS_LABEL_EDGES ? strchr(number, '-') : NULL;
    if (name->of == ROBERTS_LABEL_EDGES && !second)
        return "an edge is named by its vertices, as 4-17 or v4-v17 (some spreadsheets take 4-7 for a date)";
    if (second)
        *second++ = '\0';
    const char letter = name->of == ROBERTS_LABEL_FACES ? 'f' : name->of == ROBERTS_LABEL_BODIES ? 'b' : 'v';
    if (!take_number(number, letter, &name->number) || (second && !take_number(second, letter, &name->other)))
        return "the number is not a whole number from 0 on";
    if (second && name->number > name->other) {
        const uint32_t smaller = name->other;
        name->other = name->number;
        name->number = smaller;
    }
    return NULL;
}

const roberts_name *names_find(const roberts_name *name, size_t count, const roberts_name *thing)
{
    return count ? bsearch(thing, name, count, sizeof *name, roberts_name_order) : NULL;
}

void names_thing(const roberts_name *name, char *text, size_t size)
{
    const char *kind = name->of == ROBERTS_LABEL_VERTICES ? "vertex"
                       : name->of == ROBERTS_LABEL_EDGES  ? "edge"
                       : name->of == ROBERTS_LABEL_FACES  ? "face"
                                                          : "body";
    const int length = snprintf(text, size, "%s %u", kind, (unsigned)name->number);
    if (name->of == ROBERTS_LABEL_EDGES && length > 0 && (size_t)length < size)
        snprintf(text + length, size - (size_t)length, "-%u", (unsigned)name->other);
}

/* A name, and the line of the list that gives it. */
typedef struct listed_name {
    roberts_name name;
    size_t line;
} listed_name;

typedef struct listed_names {
    listed_name *item;
    size_t count, room;
} listed_names;

static bool add_name(listed_names *l, const roberts_name *name, size_t line)
{
    if (l->count == l->room) {
        const size_t room = 2 * l->room + 64;
        listed_name *grown = realloc(l->item, room * sizeof *grown);
        if (!grown)
            return false;
        l->item = grown;
        l->room = room;
    }
    l->item[l->count++] = (listed_name){*name, line};
    return true;
}

static int by_thing_and_line(const void *a, const void *b)
{
    const listed_name *p = a, *q = b;
    const int order = roberts_name_order(&p->name, &q->name);
    return order ? order : (p->line > q->line) - (p->line < q->line);
}

/* What separates the fields of a list, by its first line: a comma, or else a semicolon or a tab, as some spreadsheets
 * have it. */
static char separator(const char *line)
{
    const char first = line[strcspn(line, ",;\t")];
    return first ? first : ',';
}

/* Reads all lines of the text. */
static roberts_status read_lines(listed_names *l, char *text, const char *path, roberts_error *error)
{
    size_t line = 0;
    char comma = '\0';
    for (char *at = skip_mark(text), *next; at && *at; at = next) {
        roberts_name name;
        next = strchr(at, '\n');
        if (next)
            *next++ = '\0';
        line++;
        cut_cr(at);
        if (*at == '#' || at[strspn(at, " \t,;")] == '\0')
            continue;
        bool titles = false;
        const bool first = !comma;
        if (first)
            comma = separator(at);
        const char *why = read_line(at, comma, &name, &titles);
        if (first && titles)
            continue;
        if (why)
            return lists_fail(error, ROBERTS_BAD_SYNTAX, path, line, why);
        if (!add_name(l, &name, line))
            return lists_fail(error, ROBERTS_NO_MEMORY, path, 0, "not enough memory");
    }
    return ROBERTS_OK;
}

/* Sorts the names, and copies them. Refuses a second name of the same thing. */
static roberts_status take_names(name_list *n, listed_names *l, const char *path, roberts_error *error)
{
    if (l->count == 0)
        return ROBERTS_OK;
    qsort(l->item, l->count, sizeof *l->item, by_thing_and_line);
    n->item = malloc(l->count * sizeof *n->item);
    if (!n->item)
        return lists_fail(error, ROBERTS_NO_MEMORY, path, 0, "not enough memory");
    for (size_t i = 0; i < l->count; i++) {
        n->item[i] = l->item[i].name;
        if (i > 0 && roberts_name_order(&n->item[i - 1], &n->item[i]) == 0) {
            char thing[40], why[120];
            names_thing(&n->item[i], thing, sizeof thing);
            snprintf(why, sizeof why, "%s has a name already, in line %zu", thing, l->item[i - 1].line);
            return lists_fail(error, ROBERTS_BAD_SYNTAX, path, l->item[i].line, why);
        }
    }
    n->count = l->count;
    return ROBERTS_OK;
}

roberts_status names_read(name_list *n, const char *path, roberts_error *error)
{
    listed_names listed = {0};
    roberts_status status = read_names(n, path, error);
    if (status == ROBERTS_OK)
        status = read_lines(&listed, n->text, path, error);
    if (status == ROBERTS_OK)
        status = take_names(n, &listed, path, error);
    free(listed.item);
    return status;
}

roberts_status names_check_part(const name_list *n, const char *path, roberts_error *error)
{
    for (size_t i = 0; i < n->count; i++)
        if (n->item[i].of == ROBERTS_LABEL_FACES || n->item[i].of == ROBERTS_LABEL_BODIES)
            return lists_fail(error, ROBERTS_BAD_ARGUMENT, path, 0,
                              "names of faces and bodies need the whole scene: draw it in one run");
    return ROBERTS_OK;
}

void names_free(name_list *n)
{
    free(n->item);
    free(n->text);
    *n = (name_list){0};
}
