/* letters.c - text as strokes, by the fonts "simplex" of A. V. Hershey ("Calligraphy for Computers", U. S. Naval
 * Weapons Laboratory, 1967): Latin and Greek.
 *
 * A character of a font is a text: two letters for its left and right border, then two for x and y of each point, each
 * as a distance from the letter R; the pair " R" lifts the pen. y is down; capitals reach from -12 to the base line at
 * 9, small letters from -5. The build compiles the fonts into a header (tools/make-letters.sh).
 *
 * The fonts have no accents. A letter with an accent is composed of the letter and a mark over or below it. */
#include "draw/letters.h"

#include <math.h>
#include <string.h>

#include "base/angle.h"
#include "base/output.h"
#include "draw/letters_data.h"

enum { FIRST = ' ', LAST = 127, ZERO = 'R' };

static const double capital = 21.0;                                         /* height, units of the fonts */
static const double base_line = 9.0, capital_top = -12.0, small_top = -5.0; /* y */
static const double small_digit = 0.6;                                      /* of subscripts and superscripts */

/* Replaces a character that the fonts lack. */
static const char missing_box[] = "JZLFXFX[L[LF";

/* ---- accents ---- */

/* Accents, as characters of a font without borders. Their R is the middle of the letter's top, or of its foot. */
typedef enum accent {
    NO_ACCENT,
    GRAVE,
    ACUTE,
    CIRCUMFLEX,
    TILDE,
    DIAERESIS,
    RING,
    CARON,
    BREVE,
    MACRON,
    DOT,
    DOUBLE_ACUTE,
    CEDILLA, /* from here on, marks below the letter */
    OGONEK,
    COMMA,
    SLASH, /* from here on, marks across the letter, from its middle */
    BAR,
    ACCENTS
} accent;

static const char *const accent_strokes[ACCENTS] = {
    [GRAVE] = "OLSP",
    [ACUTE] = "ULQP",
    [CIRCUMFLEX] = "NPRLVP",
    [TILDE] = "MPONQNSPUPWN",
    [DIAERESIS] = "NNNO RVNVO",
    [RING] = "RJTKUMTORPPOOMPKRJ",
    [CARON] = "NLRPVL",
    [BREVE] = "NLONROUNVL",
    [MACRON] = "MNWN",
    [DOT] = "RNRO",
    [DOUBLE_ACUTE] = "QLNP RWLTP",
    [CEDILLA] = "RRQTSUSWQXOW",
    [OGONEK] = "URSTSVUWWV",
    [COMMA] = "STQX",
    [SLASH] = "KYYK",
    [BAR] = "MRWR",
};

/* Characters in pairs with the plain letter. The same as combining characters of Unicode. */
static const struct {
    uint32_t combining;
    accent accent;
    const char *pairs;
} accented[] = {
    {0x300, GRAVE, "ÀAÈEÌIÒOÙUàaèeìiòoùuǸNǹn"},
    {0x301, ACUTE, "ÁAÉEÍIÓOÚUÝYáaéeíióoúuýyĆCćcĹLĺlŃNńnŔRŕrŚSśsŹZźz"},
    {0x302, CIRCUMFLEX, "ÂAÊEÎIÔOÛUâaêeîiôoûuĈCĉcĜGĝgĤHĥhĴJĵjŜSŝsŴWŵwŶYŷy"},
    {0x303, TILDE, "ÃAÑNÕOãañnõoĨIĩiŨUũu"},
    {0x308, DIAERESIS, "ÄAËEÏIÖOÜUäaëeïiöoüuÿyŸY"},
    {0x30a, RING, "ÅAåaŮUůu"},
    {0x30c, CARON, "ČCčcĎDďdĚEěeŇNňnŘRřrŠSšsŤTťtŽZžzǍAǎa"},
    {0x306, BREVE, "ĂAăaĔEĕeĞGğgĬIĭiŎOŏoŬUŭu"},
    {0x304, MACRON, "ĀAāaĒEēeĪIīiŌOōoŪUūu"},
    {0x307, DOT, "ĊCċcĖEėeĠGġgİIŻZżz"},
    {0x30b, DOUBLE_ACUTE, "ŐOőoŰUűu"},
    {0x327, CEDILLA, "ÇCçcŞSşsŢTţt"},
    {0x328, OGONEK, "ĄAąaĘEęeĮIįiŲUųu"},
    {0x326, COMMA, "ȘSșsȚTțtĢGĶKķkĻLļlŅNņnŖRŗr"},
    {0x338, SLASH, "ØOøoŁLłl"},
    {0x335, BAR, "ĐDđdÐDĦHħh"},
};

/* Characters that unaccented letters replace, with the bytes of each. */
static const struct {
    const char *character, *plain;
} plain_letters[] = {
    {"\u00a0", " "}, {"–", "-"},  {"—", "-"},  {"−", "-"},  {"‐", "-"},   {"’", "'"},  {"‘", "`"},
    {"‚", ","},      {"“", "\""}, {"”", "\""}, {"„", "\""}, {"…", "..."}, {"ı", "i"},  {"ß", "ss"},
    {"Æ", "AE"},     {"æ", "ae"}, {"Œ", "OE"}, {"œ", "oe"}, {"þ", "th"},  {"Þ", "Th"}, {"«", "<<"},
    {"»", ">>"},     {"‹", "<"},  {"›", ">"},  {"ð", "d"},
};

/* Signs that the fonts lack, or have at other characters. */
static const struct {
    uint32_t code;
    const char *strokes;
} signs[] = {
    {0xd7, "JZMMWW RWMMW"},                                           /* times */
    {0xb1, "F^RIRU RJMZM RJYZY"},                                     /* plus or minus */
    {0x2213, "F^JKZK RJUZU RROR["},                                   /* minus or plus */
    {0xf7, "E_RJRK RIR[R RRYRZ"},                                     /* divided by */
    {0xb0, "KYRFTGUITKRLPKOIPGRF"},                                   /* degree */
    {0x2300, "G]PFMGKIJKIMINIUJWLYNZPZRZTYVWWUWNWMVKUITGRFPF RKZYF"}, /* diameter */
    {0x2220, "G]XHJ[Z["},                                             /* angle */
    {0x22a5, "G]RHR[ RI[[["},                                         /* at right angles */
    {0x221a, "H[JRMPR[YF[F"},                                         /* root */
    {0xbd, "F_IIKHMFMR RXFL[ RURVPWOZO[P\\Q\\S[UU[\\["},              /* one half */
    {0xb7, "NVRQQRRSSRRQ"},                                           /* middle dot */
    {0x2032, "NVTFQM"},                                               /* prime */
    {0x2033, "KYQFNM RWFTM"},                                         /* double prime */
    {0x2034, "H]NFKM RTFQM RZFWM"},                                   /* triple prime */
    {0x2264, "F^ZGJMZS RJYZY"},                                       /* less or equal */
    {0x2265, "F^JGZMJS RJYZY"},                                       /* greater or equal */
    {0x2260, "E_IO[O RIU[U RWHM\\"},                                  /* not equal */
    {0x2261, "E_IL[L RIR[R RIX[X"},                                   /* identical */
    {0x2248, "E_IPJNLMNMPNTPVQXQZP[N RIVJTLSNSPTTVVWXWZV[T"},         /* almost equal */
    {0x221e, "D`RROOMNJMHNGPGTHVJWMVOURRUOWNZM\\N]P]T\\VZWWVUURR"},   /* infinity */
    {0x2225, "LXOFO[ RUFU["},                                         /* parallel */
    {0x2190, "E_[RIR ROMIROW"},                                       /* arrows to the left, */
    {0x2192, "E_IR[R RUM[RUW"},                                       /* to the right, */
    {0x2194, "E_IR[R ROMIROW RUM[RUW"},                               /* and to both sides */
    {0x20ac, "G]ZKYIWGUFQFOGMILKKNKSLVMXOZQ[U[WZYXZV RHOVO RHSUS"},   /* euro */
};

/* ---- characters ---- */

uint32_t letters_decode(const char *text, size_t *length)
{
    const unsigned char *byte = (const unsigned char *)text;
    *length = output_character(text);
    if (*length == 0) {
        *length = 1;
        return 0;
    }
    uint32_t code = *length == 1 ? byte[0] : byte[0] & 0x7fu >> *length;
    for (size_t i = 1; i < *length; i++)
        code = code << 6 | (byte[i] & 0x3f);
    return code;
}

/* The final sigma counts as sigma, letters with tonos as those without. So do signs that look like a Greek letter:
 * micro, ohm, increment, triangle, sum and product. */
int letters_greek_number(uint32_t code)
{
    static const struct {
        uint32_t code, plain;
    } same[] = {{0x3c2, 0x3c3}, {0x3ac, 0x3b1},  {0x3ad, 0x3b5},  {0x3ae, 0x3b7},  {0x3af, 0x3b9},  {0x3cc, 0x3bf},
                {0x3cd, 0x3c5}, {0x3ce, 0x3c9},  {0x3d1, 0x3b8},  {0x3d5, 0x3c6},  {0x3f5, 0x3b5},  {0x386, 0x391},
                {0x388, 0x395}, {0x389, 0x397},  {0x38a, 0x399},  {0x38c, 0x39f},  {0x38e, 0x3a5},  {0x38f, 0x3a9},
                {0xb5, 0x3bc},  {0x2126, 0x3a9}, {0x2206, 0x394}, {0x25b3, 0x394}, {0x2211, 0x3a3}, {0x220f, 0x3a0}};
    for (size_t i = 0; i < sizeof same / sizeof same[0]; i++)
        if (same[i].code == code)
            code = same[i].plain;
    const bool is_capital = code >= 0x391 && code <= 0x3a9;
    const uint32_t alpha = is_capital ? 0x391 : 0x3b1, sigma = alpha + 17; /* behind rho one code is left out */
    if (code < alpha || code > alpha + 24 || code == sigma)
        return 0;
    return (int)(code - alpha + 1 - (code > sigma)) + (is_capital ? 32 : 0);
}

/* How a character is composed. */
typedef struct composed {
    const char *plain; /* letters of the Latin font; NULL: see `sign` */
    const char *sign;  /* a character as of a font; NULL: see `plain` */
    size_t count;      /* of letters in `plain` */
    accent accent;     /* over the first letter */
    double size;       /* as a part of full size */
    double raised;     /* in units of the fonts */
} composed;

static bool compose_accented(uint32_t code, composed *c)
{
    for (size_t i = 0; i < sizeof accented / sizeof accented[0]; i++)
        for (const char *at = accented[i].pairs; *at;) {
            size_t length;
            const bool found = letters_decode(at, &length) == code;
            at += length;
            if (found) {
                *c = (composed){at, NULL, 1, accented[i].accent, 1.0, 0.0};
                return true;
            }
            at++;
        }
    return false;
}

/* Digits over and below the line. */
static bool compose_small(uint32_t code, composed *c)
{
    static const char digits[] = "0123456789+-";
    const double low = -0.25 * capital, high = 0.5 * capital;
    int digit = -1;
    if (code == 0xb9 || code == 0xb2 || code == 0xb3)
        digit = code == 0xb9 ? 1 : (int)code - 0xb0;
    else if (code == 0x2070 || (code >= 0x2074 && code <= 0x207b))
        digit = (int)code - 0x2070;
    if (digit >= 0)
        *c = (composed){digits + digit, NULL, 1, NO_ACCENT, small_digit, high};
    else if (code >= 0x2080 && code <= 0x208b)
        *c = (composed){digits + (code - 0x2080), NULL, 1, NO_ACCENT, small_digit, low};
    else
        return false;
    return true;
}

static bool compose(uint32_t code, composed *c)
{
    static const char ascii[] =
        " !\"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abcdefghijklmnopqrst"
        "uvwxyz{|}~";
    const int greek = letters_greek_number(code);
    *c = (composed){.size = 1.0};
    if (code >= FIRST && code < LAST) {
        c->plain = ascii + (code - FIRST);
        c->count = 1;
        return true;
    }
    if (greek) {
        c->sign = letters_greek[(greek > 32 ? 'A' + greek - 33 : 'a' + greek - 1) - FIRST];
        return true;
    }
    for (size_t i = 0; i < sizeof signs / sizeof signs[0]; i++)
        if (signs[i].code == code) {
            c->sign = signs[i].strokes;
            return true;
        }
    for (size_t i = 0; i < sizeof plain_letters / sizeof plain_letters[0]; i++) {
        size_t length;
        if (letters_decode(plain_letters[i].character, &length) != code)
            continue;
        c->plain = plain_letters[i].plain;
        c->count = strlen(c->plain);
        return true;
    }
    return compose_accented(code, c) || compose_small(code, c);
}

/* An overline, as of the indices of crystals, is drawn as a macron. */
static accent combining_accent(uint32_t code)
{
    if (code == 0x305)
        return MACRON;
    for (size_t i = 0; i < sizeof accented / sizeof accented[0]; i++)
        if (accented[i].combining == code)
            return accented[i].accent;
    return NO_ACCENT;
}

/* Takes the next character and an accent that follows it. False: the fonts lack it; `c` is a box then. */
static bool next_character(const char **text, composed *c, uint32_t *code)
{
    size_t length;
    *code = letters_decode(*text, &length);
    *text += length;
    const bool known = *code && compose(*code, c);
    if (!known)
        *c = (composed){.sign = missing_box, .size = 1.0};
    if (known && c->plain && **text) {
        const accent follows = combining_accent(letters_decode(*text, &length));
        if (follows != NO_ACCENT) {
            c->accent = follows;
            *text += length;
        }
    }
    return known;
}

const char *letters_plain(uint32_t code, size_t *count)
{
    composed c;
    if (!compose(code, &c))
        return NULL;
    *count = c.count;
    return c.plain;
}

int letters_level(uint32_t code)
{
    composed c;
    return compose(code, &c) && c.size != 1.0 ? (c.raised > 0.0 ? 1 : -1) : 0;
}

size_t letters_missing(const char *text, uint32_t *first)
{
    size_t count = 0;
    uint32_t code;
    composed c;
    while (*text)
        if (!next_character(&text, &c, &code) && count++ == 0 && first)
            *first = code;
    return count;
}

/* ---- strokes ---- */

double text_degrees(const text_line *line)
{
    return atan2(-line->along.y, line->along.x) * (180.0 / PI);
}

/* A line of text while it is drawn. */
typedef struct writer {
    const text_line *line;
    double units_per_mm;
    double scale;  /* mm for a unit of the fonts */
    double before; /* mm of the text that lie before line->at */
    double pen;    /* x of the next character, units of the fonts */
    polylines *out;
    bool formulas; /* in dollar signs */
    bool failed;
} writer;

/* x along the base line, y down from it, both in units of the fonts. */
static void add_letter_point(writer *w, double x, double y)
{
    const double along = x * w->scale - w->before, down = y * w->scale;
    const roberts_vec2 at = w->line->at, d = w->line->along, up = text_upward(d);
    const roberts_vec2 mm = {at.x + along * d.x - down * up.x, at.y + along * d.y - down * up.y};
    w->failed = w->failed || !polylines_append_new(w->out, page_from_mm(mm, w->units_per_mm));
}

/* Removes a stroke if rounding has left only one point of it. */
static void end_stroke(const writer *w)
{
    polylines *out = w->out;
    if (!w->failed && out->item[out->count - 1].count < 2) {
        out->point_count = out->item[out->count - 1].first;
        out->count--;
    }
}

/* Adds strokes of a font, pair by pair. `x`, `y`: where R is. Without `dots` only the last stroke: an i without its
 * dot. */
static void add_letter_strokes(writer *w, const char *pair, const roberts_vec2 zero, const composed *c, bool dots)
{
    const char *last = pair;
    for (const char *at = pair; !dots && at[0] && at[1]; at += 2)
        if (at[0] == ' ')
            last = at + 2;
    bool down = false;
    for (pair = last; pair[0] && pair[1] && !w->failed; pair += 2) {
        if (pair[0] == ' ') {
            if (down)
                end_stroke(w);
            down = false;
            continue;
        }
        if (!down)
            w->failed = !polylines_start(w->out);
        down = true;
        if (!w->failed)
            add_letter_point(w, zero.x + (pair[0] - ZERO) * c->size, zero.y + (pair[1] - ZERO) * c->size);
    }
    if (down)
        end_stroke(w);
}

static void add_accent(writer *w, char letter, double middle, const composed *c)
{
    const bool is_high = (letter >= 'A' && letter <= 'Z') || strchr("bdfhklt0123456789", letter);
    const double top = is_high ? capital_top : small_top;
    double y = c->accent >= SLASH ? (top + base_line) / 2.0 : c->accent >= CEDILLA ? base_line : top;
    if (c->accent == BAR)
        y = letter == 'd' || letter == 'h' ? capital_top + 4.0 : y - 1.0;
    if (c->accent == BAR && letter == 'd')
        middle += 4.0;
    add_letter_strokes(w, accent_strokes[c->accent], (roberts_vec2){middle, y - base_line}, c, true);
}

/* Draws one character in the form of a font, with an accent over or below it; 0: none. */
static void add_character(writer *w, const char *strokes, char letter, const composed *c)
{
    const double left = (strokes[0] - ZERO) * c->size, right = (strokes[1] - ZERO) * c->size;
    const roberts_vec2 zero = {w->pen - left, -base_line * c->size - c->raised};
    const bool dots = !letter || c->accent == NO_ACCENT || c->accent >= CEDILLA || !strchr("ij", letter);
    if (w->out) {
        add_letter_strokes(w, strokes + 2, zero, c, dots);
        if (letter && c->accent != NO_ACCENT)
            add_accent(w, letter, zero.x + (left + right) / 2.0, c);
    }
    w->pen += right - left;
}

size_t letters_formula(const char *text)
{
    size_t end = 1;
    int open = 0;
    if (text[0] != '$')
        return 0;
    for (; (unsigned char)text[end] >= ' ' && text[end] != '$' && open >= 0; end++) {
        if (text[end] == '\\' && text[end + 1] > ' ')
            end++; /* what stands behind it is neither a brace nor the end */
        else
            open += (text[end] == '{') - (text[end] == '}');
    }
    return end > 1 && open == 0 && text[end] == '$' ? end + 1 : 0;
}

/* A letter for each sign of a formula; a command is one sign. */
static void write_formula(writer *w, const char *text, size_t bytes)
{
    static const char name[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    for (size_t i = 1, length; i + 1 < bytes; i += length) {
        const size_t named = text[i] == '\\' ? strspn(text + i + 1, name) : 0;
        const char *letter = "x";
        composed c;
        uint32_t code;
        letters_decode(text + i, &length);
        if (text[i] == '\\')
            length = 1 + (named ? named : 1);
        if (strchr("{}^_ ", text[i]))
            continue;
        next_character(&letter, &c, &code);
        add_character(w, letters_latin['x' - FIRST], 'x', &c);
    }
}

static void write_line(writer *w, const char *text)
{
    while (*text && !w->failed) {
        composed c;
        uint32_t code;
        const size_t formula = w->formulas ? letters_formula(text) : 0;
        if (formula) {
            write_formula(w, text, formula);
            text += formula;
            continue;
        }
        next_character(&text, &c, &code);
        if (c.sign)
            add_character(w, c.sign, 0, &c);
        for (size_t i = 0; !c.sign && i < c.count; i++)
            add_character(w, letters_latin[c.plain[i] - FIRST], i == 0 ? c.plain[0] : 0, &c);
    }
}

double letters_width(const char *text, double height_mm)
{
    writer w = {.scale = height_mm / capital};
    write_line(&w, text);
    return w.pen * w.scale;
}

double letters_tex_width(const char *text, double height_mm)
{
    writer w = {.scale = height_mm / capital, .formulas = true};
    write_line(&w, text);
    return w.pen * w.scale;
}

bool letters_draw(const text_line *line, double units_per_mm, polylines *out)
{
    writer w = {.line = line, .units_per_mm = units_per_mm, .scale = line->height_mm / capital, .out = out};
    w.before = line->align * letters_width(line->text, line->height_mm);
    write_line(&w, line->text);
    return !w.failed;
}
