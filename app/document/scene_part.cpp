#include "app/document/scene_part.h"

#include <tuple>

namespace brume {
namespace {

// In the order of the variant.
template <class S>
auto parts(S& scene) {
  return std::tie(scene.camera, scene.lights, scene.environment, scene.optics, scene.surfaces,
                  scene.emitters);
}

}  // namespace

ScenePart scene_part(const Scene& scene, std::size_t index) {
  ScenePart part;
  const auto parts_of_scene = parts(scene);
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((i == index ? void(part.emplace<i>(std::get<i>(parts_of_scene))) : void()), ...);
  }
  (std::make_index_sequence<std::variant_size_v<ScenePart>>());
  return part;
}

void set_scene_part(Scene& scene, const ScenePart& part) {
  std::visit([&scene]<class T>(const T& value) { std::get<T&>(parts(scene)) = value; }, part);
}

}  // namespace brume
