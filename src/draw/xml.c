/* xml.c - text as XML holds it. UTF-8 after RFC 3629: no surrogates, nothing beyond U+10FFFF, no longer than need be. */
#include "draw/xml.h"

/* Length of the character that `text` begins with, 0 where it is none of XML. */
static size_t character(const unsigned char *text)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    uint32_t code = text[0];
    size_t length = code < 0x80 ? 1 : code < 0xc0 ? 0 : code < 0xe0 ? 2 : code < 0xf0 ? 3 : code < 0xf8 ? 4 : 0;
    if (length > 1)
        code &= 0x7fu >> length;
    for (size_t i = 1; i < length; i++) {
        if ((text[i] & 0xc0) != 0x80) /* the end of the text as well */
            return 0;
        code = code << 6 | (text[i] & 0x3f);
    }
    bool control = code < 0x20 && code != '\t' && code != '\n';
    bool none = (code >= 0xd800 && code < 0xe000) || code == 0xfffe || code == 0xffff || code > 0x10ffff;
    return length == 0 || code < least[length] || control || none ? 0 : length;
}

void xml_text(output *out, const char *text)
{
    while (*text) {
        size_t length = character((const unsigned char *)text);
        if (*text == '<' || *text == '>' || *text == '&')
            output_text(out, *text == '<' ? "&lt;" : *text == '>' ? "&gt;" : "&amp;");
        else if (length)
            output_bytes(out, text, length);
        else
            output_text(out, "?");
        text += length ? length : 1;
    }
}
