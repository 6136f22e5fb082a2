#include "app/document/scene_part.h"

#include <tuple>

#include "core/scene/cameras.h"

namespace brume {
namespace {

// Those that a scene holds as they are, in the order of the variant.
constexpr std::size_t first_whole = 3;
template <class S>
auto whole_parts(S& scene) {
  return std::tie(scene.lights, scene.environment, scene.optics, scene.surfaces, scene.emitters,
                  scene.sequences, scene.playback, scene.film, scene.output, scene.groups,
                  scene.splines, scene.cameras);
}

}  // namespace

ScenePart scene_part(const Scene& scene, std::size_t index) {
  if (index == 0) return KeyedCamera{scene.camera, scene.camera_keys};
  if (index == 1) return KeyedDensity{scene.medium.homogeneous_density(), scene.density_keys};
  if (index == 2) return CameraList{camera_in_use(scene), scene.cameras};
  ScenePart part;
  const auto parts = whole_parts(scene);
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((first_whole + i == index ? void(part.emplace<first_whole + i>(std::get<i>(parts))) : void()),
     ...);
  }
  (std::make_index_sequence<std::variant_size_v<ScenePart> - first_whole>());
  return part;
}

void set_scene_part(Scene& scene, const ScenePart& part) {
  std::visit(
      [&scene]<class T>(const T& value) {
        if constexpr (std::is_same_v<T, KeyedCamera>) {
          scene.camera = value.camera;
          scene.camera_keys = value.keys;
        } else if constexpr (std::is_same_v<T, KeyedDensity>) {
          scene.medium.set_homogeneous_density(value.density);
          scene.density_keys = value.keys;
        } else if constexpr (std::is_same_v<T, CameraList>) {
          scene.camera = value.in_use.camera;
          scene.camera_keys = value.in_use.keys;
          scene.camera_name = value.in_use.name;
          scene.camera_id = value.in_use.id;
          scene.cameras = value.others;
        } else {
          std::get<T&>(whole_parts(scene)) = value;
        }
      },
      part);
}

}  // namespace brume
