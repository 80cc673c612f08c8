/* off_foreign.c - which other format an input is in, by how it begins: for a message that tells more than what is missing. */
#include "model/off.h"

#include <string.h>

/* OpenSCAD reads STL alone of these. */
#define STL "STL (OpenSCAD or MeshLab saves it as OFF)"
#define PLY "PLY (MeshLab saves it as OFF)"
#define OBJ "OBJ (MeshLab saves it as OFF)"

/* Binary STL has no mark of its own, but for the 80 bytes of any text that many programs begin with "solid" as well. */
static const struct foreign {
    const char *begins, *format;
    bool whole; /* that is the whole word */
} foreign[] = {
    {"solid", STL, true},
    {"ply", PLY, true},
    {"v", OBJ, true},
    {"vn", OBJ, true},
    {"vt", OBJ, true},
    {"o", OBJ, true},
    {"g", OBJ, true},
    {"mtllib", OBJ, true},
    {"usemtl", OBJ, true},
    {"glTF", "glTF", false},
    {"ISO-10303-21", "STEP", false},
    {"$MeshFormat", "Gmsh", true},
    {"MeshVersionFormatted", "Medit", true},
    {"LIST", "a Geomview LIST", true},
    {"MESH", "a Geomview MESH", true},
    {"<", "XML (as AMF, X3D and COLLADA are)", false},
    {"PK", "a ZIP archive (as 3MF is)", true},
    {"\x1f", "compressed, as by gzip", false},
    {"\xff\xfe", "text in UTF-16 (to be saved as UTF-8)", false},
    {"\xfe\xff", "text in UTF-16 (to be saved as UTF-8)", false},
};

const char *off_foreign(const char *word, size_t length)
{
    for (size_t i = 0; i < sizeof foreign / sizeof foreign[0]; i++) {
        size_t wanted = strlen(foreign[i].begins);
        if ((foreign[i].whole ? length == wanted : length >= wanted) && memcmp(word, foreign[i].begins, wanted) == 0)
            return foreign[i].format;
    }
    return NULL;
}
