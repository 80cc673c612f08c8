/* json.h - text in JSON. */
#ifndef ROBERTS_CLI_JSON_H
#define ROBERTS_CLI_JSON_H

#include <stdio.h>

/* Writes `text` as a string of JSON (RFC 8259), with its quotes; NULL is null. Bytes that are no UTF-8, as names of
 * files may have, become U+FFFD. */
void json_string(FILE *file, const char *text);

#endif
