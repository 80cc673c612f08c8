/* stats.h - what --stats prints. */
#ifndef ROBERTS_CLI_STATS_H
#define ROBERTS_CLI_STATS_H

#include "cli/options.h"

/* What the program counts and times itself; the rest is in the drawing. */
typedef struct run_stats {
    size_t files, vertices, faces;
    roberts_time read, solids, verify, draw, total; /* verify: and picking */
    roberts_ink ink;                                /* nothing in it: no page was written */
    uint64_t segments[ROBERTS_CLIPPED + 1];         /* in each state */
    roberts_verification found;                     /* by --verify, in all views: counts alone */
} run_stats;

/* CPU time of all threads and wall-clock time, now. */
roberts_time stats_now(void);

/* How long it is since `start`. */
roberts_time stats_since(roberts_time start);

roberts_time stats_sum(roberts_time a, roberts_time b);

/* Counts one segment among those of its state: a roberts_segment_fn, whose context is the run. */
bool stats_count(void *run, const roberts_segment *segment);

/* To the options' log, as they want it: for people, or as one JSON object. What is counted in `views` drawings of one scene
 * is added up. */
void stats_print(const cli_options *options, const run_stats *run, const roberts_drawing *drawing, size_t views);

enum { STATS_RATIO = 40 };

/* The scale as people write it, "1:20" or "5:1"; false: the drawing is fitted, or there is no page. */
bool stats_ratio(const roberts_ink *ink, const roberts_placement *placement, char ratio[STATS_RATIO]);

#endif
