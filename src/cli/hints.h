/* hints.h - what was meant, why a drawing is empty, or what can be done: the second half of a message. */
#ifndef ROBERTS_CLI_HINTS_H
#define ROBERTS_CLI_HINTS_H

#include "cli/options.h"

/* ---- words; their lists end with NULL ---- */

/* Returns the word of the list that is most like `word`; NULL if none is similar enough. */
const char *hint_word(const char *word, const char *const *words);

/* Returns the option that other programs call --word, perhaps with its value; NULL if none is known. */
const char *hint_option(const char *word);

/* Reports that `word` is no value of `what`, with a suggestion or the possible values (`also`: values other than
 * `words`, or NULL). Returns EXIT_MISUSED. */
int hint_unknown(const char *what, const char *word, const char *const *words, const char *also);

/* ---- files and models ---- */

/* The file of --labels could not be read. If its name is a word for --label, the message suggests that option. */
void hint_label(const char *name, roberts_error *error);

/* The input called `name` could not be read. If it is a folder or a drawing, the message says so, or suggests another
 * name. */
void hint_unread(const cli_options *options, const char *name, roberts_error *error);

/* The mesh was refused. Appends to the message which options would accept it. */
void hint_refused(const cli_options *options, const roberts_mesh *mesh, roberts_error *error);

/* If --limit-memory caused the lack of memory, the message says so. */
void hint_memory(const cli_options *options, roberts_error *error);

/* ---- drawings that show nothing ---- */

/* Returns why no drawing on a page (or in a table) shows a line, and which option changes that; NULL if one of them
 * does. */
const char *hint_empty(const cli_options *options, const roberts_drawing *drawing, size_t views);

/* Whether the drawing is almost empty because the eye is in or on a solid, or so near that the near plane cuts the
 * solid in the middle of the picture; then `why` says so. */
bool hint_near_plane(const cli_options *options, const roberts_scene *scene, const roberts_drawing *drawing, char *why,
                     size_t size);

/* ---- options that change nothing in this drawing ---- */

/* Writes which names of --labels belong to nothing in this model: the first one, and how many more there are. False:
 * each belongs to something. */
bool hint_idle_names(const cli_options *options, const roberts_mesh *mesh, size_t bodies, char *text, size_t size);

/* Does --style set pens of classes that none of the drawings has? Then `text` names them. */
bool hint_idle_pens(const cli_options *options, const roberts_drawing *drawing, size_t views, char *text, size_t size);

/* Has no visible face a colour that --fill model or shade could use? */
bool hint_no_colors(const cli_options *options, const roberts_drawing *drawing, size_t views);

/* Is --epsilon so large that faces narrower than it, which hide nothing, are probably many? *width: about how wide
 * faces are in the picture, model units. */
bool hint_wide_epsilon(const cli_options *options, const roberts_drawing *drawing, double *width);

/* Does --hatch draw no stroke, because the light falls straight on all faces that are seen, or because only sections
 * have strokes and there are none? */
bool hint_idle_hatch(const cli_options *options, const roberts_drawing *drawing, size_t views);

/* How many bodies are curved? */
size_t hint_curved(const roberts_scene *scene);

/* How many bodies are convex, with so many faces that they probably stand for round ones? */
size_t hint_round(const roberts_scene *scene);

/* Are edges left out because they are flat, so that only borders are drawn? A tiling and a net are like this. A face
 * that is given as a few triangles is not meant. */
bool hint_flat(const cli_options *options, const roberts_scene *scene, const roberts_drawing *drawing);

/* Is no body closed? Then --union changes nothing. */
bool hint_all_open(const roberts_scene *scene);

/* Has no body a name, so that --label names changes nothing? */
bool hint_no_names(const roberts_scene *scene);

/* Is no body a hull, and none left out, so that --hull changes nothing? `faces`: of the mesh. */
bool hint_idle_hull(const roberts_scene *scene, size_t faces);

/* Are all faces convex, so that --fill-rule changes nothing? Others need not cross themselves; then nothing is said. */
bool hint_idle_rule(const roberts_scene *scene);

#endif
