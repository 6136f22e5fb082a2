// Renders an animation: animate SCENE.brume FOLDER FRAMES
#include <brume/at_time.h>
#include <brume/files.h>
#include <brume/render.h>

#include <filesystem>
#include <iostream>
#include <string>

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  using enum brume::AirlightMethod;
  const brume::Scene scene = brume::load_scene(argv[1]);
  const int count = std::stoi(argv[3]);
  brume::SceneRenderer renderer;  // keeps what is the same in the next frame
  for (int i = 0; i < count; ++i) {
    const double time = brume::last_moment(scene) * i / count;
    // One method for all frames, so that they cost and err alike.
    const auto frame =
        renderer.render(scene, {.film = brume::Film{160, 120}, .time = time, .airlight = sliced});
    const std::string name = "frame_" + std::to_string(i) + ".png";
    brume::save_frame(*frame, std::filesystem::path(argv[2]) / name);
    std::cout << name << " at " << time << " s: " << frame->statistics.frame_milliseconds
              << " ms\n";
  }
}
