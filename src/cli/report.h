/* report.h - the reports of --stats, --verify and --pick, on standard error. */
#ifndef ROBERTS_CLI_REPORT_H
#define ROBERTS_CLI_REPORT_H

#include "cli/options.h"

/* Counts and times of the program itself; the rest is in the drawing. */
typedef struct run_stats {
    size_t files, vertices, faces, pieces, edges;   /* pieces: convex ones, of faces */
    size_t lines;                                   /* points and lines among the faces of the files, for -v */
    char missing[512];                              /* an .mtl file that an OBJ names and that is not there */
    double step;                                    /* roberts_mesh_step() of the inputs, for a note; else 0 */
    roberts_time begin;                             /* when the picture was begun */
    roberts_time read, solids, verify, draw, total; /* verify: picking too */
    roberts_ink ink;                                /* all zero if no page was written */
    uint64_t segments[ROBERTS_CLIPPED + 1];         /* in each state */
    roberts_verification found;                     /* by --verify, in all views: counts alone */
} run_stats;

/* CPU time of all threads and wall-clock time, now. */
roberts_time report_now(void);

/* The time since `start`. */
roberts_time report_since(roberts_time start);

roberts_time report_sum(roberts_time a, roberts_time b);

/* Counts one segment among those of its state: a roberts_segment_fn, whose context is the run. */
bool report_count(void *run, const roberts_segment *segment);

/* Writes the statistics to the options' log, for people or as one JSON object. Counts of several `views` of one scene
 * are added up. */
void report_stats(const cli_options *options, const run_stats *run, const roberts_drawing *drawing, size_t views);

enum { REPORT_RATIO = 40 };

/* The scale as people write it, "1:20" or "5:1". False if the drawing is fitted, or if there is no page. */
bool report_ratio(const roberts_ink *ink, const roberts_placement *placement, char ratio[REPORT_RATIO]);

/* Checks the drawing by rays. Reports the first contradictions, one per line, then how many points were checked (with
 * --quiet only if something is wrong). Adds the counts to those of `sum`. */
roberts_status report_verify(const cli_options *options, const roberts_scene *scene, const roberts_drawing *drawing,
                             roberts_verification *sum, roberts_error *error);

/* Reports what is seen at each point of --pick and what lies behind it, nearest first, one per line. */
roberts_status report_picks(const cli_options *options, const roberts_scene *scene, roberts_error *error);

#endif
