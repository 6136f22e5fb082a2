// Makes a scene in code, a ring of fog around a lamp, and saves it: build_medium OUT.brume
#include <brume/files.h>
#include <brume/scene.h>

#include <cmath>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  brume::Scene scene;
  scene.camera.eye = {0.0, 2.0, 6.0};
  scene.film = {320, 240};
  for (int i = 0; i < 24; ++i) {
    const double angle = i * 2.0 * M_PI / 24;
    scene.medium.append({.center = {2.0 * std::cos(angle), 0.0, 2.0 * std::sin(angle)},
                         .radius = 0.5,
                         .density = 0.8 + 0.4 * std::sin(3.0 * angle)});
  }
  scene.lights.push_back({.position = {0.0, 0.5, 0.0}, .intensity = {9.0, 8.0, 6.0}});
  brume::Surface floor;
  floor.primitive = brume::Primitive{.shape = brume::Primitive::Shape::plane, .size = {20, 1, 20}};
  floor.mesh = brume::mesh_of(*floor.primitive);
  floor.translate.y = -0.8;
  scene.surfaces.push_back(floor);
  brume::save_scene(scene, argv[1]);
}
