/* tikz_text.c - text for LaTeX: characters that TeX reads as commands get names, Greek letters are in mathematics. All
 * others stay as they are, in UTF-8, which LaTeX reads since 2018. */
#include "draw/tikz_text.h"

#include <stddef.h>
#include <stdint.h>

#include "draw/letters.h"

/* What TeX reads as a character of its own, or lacks in old fonts. */
static const char *tex_name(uint32_t code)
{
    static const struct {
        uint32_t code;
        const char *name;
    } names[] = {{'#', "\\#"},
                 {'$', "\\$"},
                 {'%', "\\%"},
                 {'&', "\\&"},
                 {'_', "\\_"},
                 {'{', "\\{"},
                 {'}', "\\}"},
                 {'\\', "\\textbackslash{}"},
                 {'^', "\\textasciicircum{}"},
                 {'~', "\\textasciitilde{}"},
                 {'<', "\\textless{}"},
                 {'>', "\\textgreater{}"},
                 {'|', "\\textbar{}"},
                 {'"', "''"},
                 {0xd7, "\\ensuremath{\\times}"},
                 {0xb0, "\\ensuremath{{}^\\circ}"},
                 {0xb1, "\\ensuremath{\\pm}"},
                 {0x2212, "\\ensuremath{-}"},
                 {0x2300, "\\O{}"},
                 {0x2220, "\\ensuremath{\\angle}"},
                 {0x22a5, "\\ensuremath{\\perp}"}};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (names[i].code == code)
            return names[i].name;
    return NULL;
}

/* TeX has no commands for Greek letters that look like Latin ones. */
static const char *tex_greek(int number)
{
    /* [number of letters_greek_number()] */
    static const char *const name[] = {[1] = "alpha", "beta",      "gamma",     "delta",     "varepsilon",
                                       "zeta",        "eta",       "theta",     "iota",      "kappa",
                                       "lambda",      "mu",        "nu",        "xi",        "mathrm{o}",
                                       "pi",          "rho",       "sigma",     "tau",       "upsilon",
                                       "varphi",      "chi",       "psi",       "omega",     [33] = "mathrm{A}",
                                       "mathrm{B}",   "Gamma",     "Delta",     "mathrm{E}", "mathrm{Z}",
                                       "mathrm{H}",   "Theta",     "mathrm{I}", "mathrm{K}", "Lambda",
                                       "mathrm{M}",   "mathrm{N}", "Xi",        "mathrm{O}", "Pi",
                                       "mathrm{P}",   "Sigma",     "mathrm{T}", "Upsilon",   "Phi",
                                       "mathrm{X}",   "Psi",       "Omega"};
    return name[number];
}

void tikz_text_write(output *out, const char *text)
{
    size_t length, count;
    for (; *text; text += length) {
        const uint32_t code = letters_decode(text, &length);
        const int greek = letters_greek_number(code), level = letters_level(code);
        const char *name = tex_name(code);
        if (name) {
            output_text(out, name);
        } else if (greek) {
            output_text(out, "\\ensuremath{\\");
            output_text(out, tex_greek(greek));
            output_text(out, "}");
        } else if (level) {
            output_text(out, level > 0 ? "\\textsuperscript{" : "\\textsubscript{");
            output_bytes(out, letters_plain(code, &count), 1);
            output_text(out, "}");
        } else if (code < ' ' || code == 0x7f) {
            output_text(out, "?");
        } else {
            output_bytes(out, text, length);
        }
    }
}
