// Renders a scene: render SCENE.brume OUT.exr|OUT.png
#include <brume/error.h>
#include <brume/files.h>
#include <brume/render.h>

#include <iostream>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    const brume::Scene scene = brume::load_scene(argv[1]);
    const brume::Frame frame = *brume::render(scene, {.film = brume::Film{320, 240}});
    brume::save_frame(frame, argv[2]);
    std::cout << frame.statistics.airlight << ": " << frame.statistics.frame_milliseconds << " ms, "
              << 100.0 * frame.error->rel_rmse << "% off\n";
  } catch (const brume::InputError& error) {  // names the file and the place in it
    std::cerr << error.what() << '\n';
    return 1;
  }
}
