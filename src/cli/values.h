/* values.h - values of the options that name a view, a format or a mode, and of those that are vectors or numbers. */
#ifndef ROBERTS_CLI_VALUES_H
#define ROBERTS_CLI_VALUES_H

#include "cli/options.h"

/* The name that -f and endings of files give to a format. */
const char *values_format_name(roberts_format format);

/* Each returns EXIT_DONE, or EXIT_MISUSED and has said why. `value` NULL: none was given. */
int values_set_format(cli_options *options, const char *value);
int values_set_view(cli_options *options, const char *value);
int values_set_hidden(cli_options *options, const char *value);
int values_set_stats(cli_options *options, const char *value); /* NULL, json */
int values_set_sheet(cli_options *options, const char *value);
int values_set_fill_rule(cli_options *options, const char *value); /* nonzero, evenodd */
int values_add_pick(cli_options *options, const char *value);      /* one more point */
int values_set_angle_of_view(const char *value, double *degrees);
int values_set_resolution(const char *value, double *dpi);
int values_set_rays(const char *value, uint32_t *rays);
int values_set_turntable(const char *value, uint32_t *number);

/* Of the option --name. */
int values_set_vector(const char *name, const char *value, roberts_vec3 *vector);
int values_set_direction(const char *name, const char *value, roberts_vec3 *vector);    /* points somewhere */
int values_set_number(const char *name, const char *value, double max, double *number); /* 0 .. max */
int values_set_length(const char *name, const char *value, double max, double *mm);     /* the same, of mm */
int values_set_number_between(const char *name, const char *value, double min, double max, double *number);
int values_set_integer(const char *name, const char *value, uint32_t min, uint32_t max, uint32_t *number);

#endif
