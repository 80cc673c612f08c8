// The same header from C++: the visible segments of an OFF file, those of each solid counted.
//   c++ segments.cpp $(pkg-config --cflags --libs roberts) -o segments++ && ./segments++ model.off
#include <iostream>
#include <map>
#include <memory>
#include <roberts.h>

int main(int argc, char **argv)
{
    roberts_mesh mesh{};
    roberts_error error{};
    roberts_scene *built = nullptr;
    roberts_camera camera{};
    roberts_drawing drawing{};
    std::map<unsigned, unsigned> count;
    roberts_camera_preset("top", &camera);
    roberts_status status = roberts_mesh_read_file(&mesh, argc > 1 ? argv[1] : "-", nullptr, &error);
    if (status == ROBERTS_OK)
        status = roberts_scene_build(&mesh, nullptr, &built, &error);
    roberts_mesh_free(&mesh);
    std::unique_ptr<roberts_scene, decltype(&roberts_scene_free)> scene(built, roberts_scene_free);
    if (status == ROBERTS_OK)
        status = roberts_hide(scene.get(), &camera, nullptr, &drawing, &error);
    if (status != ROBERTS_OK) {
        std::cerr << error.file << ": " << error.message << '\n';
        return 1;
    }
    for (size_t i = 0; i < drawing.count; i++)
        count[drawing.segment[i].solid]++;
    for (const auto &[solid, segments] : count)
        std::cout << "solid " << solid << ": " << segments << " segments\n";
    roberts_drawing_free(&drawing);
}
