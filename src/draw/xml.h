/* xml.h - text as XML holds it. */
#ifndef ROBERTS_DRAW_XML_H
#define ROBERTS_DRAW_XML_H

#include "draw/output.h"

/* Writes UTF-8 text with <, > and & as entities. Whatever is no UTF-8 or no character of XML 1.0 (control characters,
 * for one) becomes a question mark a byte, so that names of files, which may hold anything, leave the file sound. */
void xml_text(output *out, const char *text);

#endif
