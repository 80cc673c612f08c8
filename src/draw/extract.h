/* extract.h - the path data in Cairo's SVG, brought to mm. */
#ifndef ROBERTS_DRAW_EXTRACT_H
#define ROBERTS_DRAW_EXTRACT_H

#include "draw/chain.h"
#include "draw/output.h"

/* How points are to be handed to Cairo: page units p as EXTRACT_ORIGIN + p / EXTRACT_UNITS. */
enum { EXTRACT_ORIGIN = 2, EXTRACT_UNITS = 1000000 };

/* Where in Cairo's text it is. */
typedef enum extract_place {
    EXTRACT_BETWEEN, /* not in a tag */
    EXTRACT_NAME,    /* in the name of a tag */
    EXTRACT_TAG,     /* in a tag that is no path */
    EXTRACT_PATH,    /* in a path's tag, before or in the name of an attribute */
    EXTRACT_VALUE,   /* in the value of an attribute that is not wanted */
    EXTRACT_DATA,    /* in the value of d */
} extract_place;

/* A number of which some digits have been read. */
typedef struct extract_number {
    uint32_t value; /* of its digits, the point left out */
    int digits;
    int behind; /* digits behind the point; -1: no point yet */
    bool minus;
} extract_number;

/* To begin with, all that is not named here is 0. */
typedef struct extract {
    output *out;
    int decimals; /* of a mm, in page units */
    size_t paths; /* path data so far, over all surfaces */
    bool strange; /* something that is not understood */
    extract_place at;
    char name[8]; /* of a tag or an attribute; the beginning of longer ones */
    size_t length;
    page_point expected; /* the first point of the surface */
    bool begun;          /* which has been read */
    char command;        /* M or L, whose coordinates come; 0: none */
    extract_number number;
    int32_t coordinate[2];
    int coordinates;
    page_point move; /* M that waits for what follows */
    bool moves;
} extract;

/* Before each surface: the first point that will be drawn there. */
void extract_surface(extract *e, page_point first);

/* Takes the next bytes of Cairo's SVG and writes what of them is path data. */
void extract_bytes(extract *e, const unsigned char *bytes, size_t size);

#endif
