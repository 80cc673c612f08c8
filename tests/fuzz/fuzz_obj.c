/* fuzz_obj.c - OBJ with any bytes behind a first vertex, and the same bytes as a file of materials. */

#include "fuzz.h"
#include "read/obj.h"

int fuzz_obj(const uint8_t *bytes, size_t size)
{
    obj_materials materials = {0};
    input_memory text = {(const char *)bytes, size, 0};
    const input_source source = input_from_memory(&text);
    FUZZ_REQUIRE(obj_materials_read(&materials, &source));
    FUZZ_REQUIRE(materials.count <= size);
    obj_materials_sort(&materials);
    for (size_t i = 0; i < materials.count; i++) {
        const roberts_color *color = obj_materials_color(&materials, materials.item[i].name);
        FUZZ_REQUIRE(color);
        FUZZ_REQUIRE(color->count == 0 || color->count == 3);
        for (int k = 0; k < color->count; k++)
            FUZZ_REQUIRE(color->value[k] >= 0.0f && color->value[k] <= 1.0f);
    }
    obj_materials_free(&materials);
    return fuzz_read_behind("v 0 0 0\n", 8, bytes, size);
}
