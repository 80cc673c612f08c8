/* options.h - the command line as a plain struct, and the table of options.
 *
 * Everything about an option is in one row of the table: how it is parsed, what it excludes and needs, and its texts
 * for --help, the manual page and the shell completions. A new option is a new row. */
#ifndef ROBERTS_CLI_OPTIONS_H
#define ROBERTS_CLI_OPTIONS_H

#include <stdio.h>

#include "roberts.h"

enum { PICKS_MOST = 64, FIELDS_MOST = 7, DISTANCES_MOST = 64, ROOMS_MOST = 64 };

typedef enum cli_stats { STATS_NONE, STATS_TEXT, STATS_JSON } cli_stats;

/* What is drawn and how, as a shell command. If it is too long, the end is replaced by three dots. */
typedef struct description {
    char text[4096];
    size_t length;
    bool is_full;
} description;

typedef struct cli_options {
    char *const *input; /* [input_count], of argv; "-" is standard input; at least one, unless there is a list */
    size_t input_count;
    const char *output;   /* "-" is standard output */
    const char *batch;    /* NULL, or the folder for a picture of each input; then `output` is not used */
    const char *list;     /* NULL, or the file with names of further inputs; "-" is standard input */
    const char *root;     /* NULL, or the folder below which a drawing keeps the path of its input */
    const char *manifest; /* NULL, or the file that gets a row for each input */
    roberts_share shard;  /* of the inputs; of 0: all */
    bool update;          /* draw only inputs that are newer than their drawings */
    double limit_seconds; /* for each input; 0: none */
    double limit_memory;  /* for each input, MB; 0: none */
    bool plan;            /* plan the scene for parts, and draw nothing */
    roberts_share part;   /* draw this part of the scene into a file for --join; `of` 0: draw everything */
    bool join;            /* the inputs are parts */
    const char *names;    /* NULL, or the file with names of vertices, edges, faces and bodies */
    const char *regions;  /* NULL, or the file for the visible regions of faces; "-" is standard output */
    uint32_t turntable;   /* 0, or how many pictures; then `output` has a place for their numbers */
    bool is_sheet;        /* several views on one page; then the camera is not used */
    roberts_sheet_angle sheet;
    FILE *log;         /* for messages */
    const char *label; /* NULL, or the name of this picture among several: messages begin with it */
    roberts_scene_options scene;
    bool y_up; /* the y axis of the model points up */
    roberts_camera camera;
    roberts_vec3 section[2];         /* point and direction; goes into the camera last, like `up` */
    roberts_vec3 up;                 /* goes into the camera last, like --roll, so the order of options is free */
    double azimuth, elevation, roll; /* degrees */
    roberts_hide_options hide;
    roberts_draw_options draw;
    roberts_field field[FIELDS_MOST]; /* of the title block */
    size_t field_count;
    roberts_distance distance[DISTANCES_MOST]; /* between vertices of a sheet */
    size_t distance_count;
    const char *room[ROOMS_MOST]; /* files for which there is room in the picture, too */
    size_t room_count;
    uint32_t named_pens; /* bit i: --style names class i of values_pens */
    const char *unit;    /* name of --unit; NULL: not given */
    bool landscape;
    description description;
    cli_stats stats;
    bool verify;
    uint32_t verify_rays; /* per segment; 0 = choose */
    roberts_vec2 pick[PICKS_MOST];
    size_t pick_count;
    bool quiet, verbose, help, version;
} cli_options;

/* ---- the table ---- */

enum { OPTIONS_MOST = 128 };

typedef enum option_group {
    GROUP_OUTPUT,
    GROUP_BATCH,
    GROUP_PARTS,
    GROUP_PAGE,
    GROUP_LINES,
    GROUP_TEXT,
    GROUP_VIEW,
    GROUP_ENGINE,
    GROUP_MESSAGES,
    OPTION_GROUPS
} option_group;

typedef enum option_flags {
    OPTION_DRAWS = 1,    /* changes what is drawn: part of the description in a drawing */
    OPTION_PAPER = 2,    /* about the page: without effect on tables */
    OPTION_REPEATS = 4,  /* may be given several times; otherwise the last one counts */
    OPTION_OPTIONAL = 8, /* the value is optional, and can only follow "=" */
    OPTION_FILE = 16,    /* the value is a file: for completions */
    OPTION_FOLDER = 32,  /* the value is a folder */
    OPTION_ALONE = 64,   /* the program does nothing else */
    OPTION_TABLE = 128,  /* about tables: without effect on pages */
} option_flags;

typedef struct option option;

/* Puts the value (NULL: none was given) into `options`. Returns EXIT_DONE, or EXIT_MISUSED after a message. */
typedef int option_set(const option *o, const char *value, cli_options *options);

struct option {
    option_group group;
    const char *name;         /* without the two dashes */
    char letter;              /* 0: none */
    unsigned flags;           /* of option_flags */
    const char *value;        /* what --help calls the value; NULL: the option takes none */
    const char *const *words; /* values to choose from, ending with NULL; NULL: any. For messages and completions */
    option_set *set;          /* NULL: no action: it is enough that the option was given */
    size_t field;             /* what `set` fills: an offset in cli_options */
    double least, most;       /* of numbers */
    const char *excludes;     /* options that contradict this one, separated by blanks; it works both ways */
    const char *needs;        /* options of which one must be given, too */
    const char *brief;        /* for completions: a few words in small letters, without quotes, colons and brackets */
    const char *help;         /* for --help */
    const char *manual;       /* for the manual page, a newline between paragraphs; NULL: as `help` */
};

typedef struct option_table {
    const option *row;
    size_t count;
} option_table;

extern const option_table option_table_all;

typedef struct option_title {
    const char *title;
    const char *help, *manual; /* text about the whole group, or NULL */
} option_title;

extern const option_title option_titles[OPTION_GROUPS];

/* Whether one of the two excludes the other. */
bool option_excludes(const option *a, const option *b);

/* ---- parsing ---- */

/* Which options were given. */
typedef struct options_given {
    const option_table *table;
    bool row[OPTIONS_MOST];
} options_given;

bool options_is_given(const options_given *given, const char *name);

/* Fills `options` from the arguments and moves the operands to the front of argv. Returns EXIT_DONE, or EXIT_MISUSED
 * after a message. */
int options_parse(const option_table *table, int argc, char **argv, cli_options *options);

/* Adds one word to a description, the name of a file: -x becomes ./-x, so that the command runs. */
void description_word(description *d, const char *word);

#endif
