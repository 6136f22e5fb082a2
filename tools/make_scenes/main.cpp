// brume-make-scenes FOLDER: writes the sample scenes of resources/scenes, the same bytes each time;
// brume-make-scenes --templates FOLDER: the templates of resources/templates.

#include <exception>
#include <filesystem>
#include <iostream>
#include <string_view>

#include "tools/make_scenes/generated_files.h"
#include "tools/make_scenes/scenes.h"

int main(int argc, char** argv) {
  const bool templates = argc == 3 && argv[1] == std::string_view("--templates");
  if ((argc != 2 && !templates) || *argv[argc - 1] == '-') {
    std::cerr << "usage: brume-make-scenes [--templates] FOLDER\n";
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[argc - 1];
    std::filesystem::create_directories(folder);
    if (templates) {
      brume::write_template_scenes(folder);
      return 0;
    }
    brume::write_plane(folder / "plane.obj");
    brume::write_object_scenes(folder);
    brume::write_cloud_scenes(folder);
    brume::write_terrain_scene(folder);
    brume::write_courtyard_scene(folder);
    brume::write_forest_scene(folder);
    brume::write_headlights_scene(folder);
    brume::write_candle_scene(folder);
    brume::write_harbour_scene(folder);
    brume::write_interior_scenes(folder);
  } catch (const std::exception& error) {
    std::cerr << "brume-make-scenes: " << error.what() << '\n';
    return 2;
  }
}
