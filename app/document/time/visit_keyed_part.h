#pragma once

#include <glm/vec3.hpp>
#include <string_view>
#include <type_traits>
#include <variant>

#include "app/document/scene_part.h"
#include "core/scene/animation/animation.h"

namespace brume {

// Calls visit(name, value, keys, domain), as core/scene/animation/animation.h does, for the values
// of a scene part that can have keys, in order.
void visit_keyed_part(auto& part, auto&& visit) {
  std::visit(
      [&]<class T>(T& value) {
        using Part = std::remove_const_t<T>;
        if constexpr (std::is_same_v<Part, KeyedCamera>) {
          visit_keyed(value.camera, value.keys, visit);
        } else if constexpr (std::is_same_v<Part, KeyedDensity>) {
          visit_keyed_density(value.density, value.keys, visit);
        } else if constexpr (std::is_same_v<Part, Cameras>) {
          for (auto& camera : value) visit_keyed(camera.camera, camera.keys, visit);
        } else if constexpr (std::is_same_v<Part, Lights>) {
          for (auto& light : value) visit_keyed(light, visit);
        } else if constexpr (std::is_same_v<Part, Emitters>) {
          for (auto& emitter : value) visit_keyed(emitter, visit);
        } else if constexpr (std::is_same_v<Part, Surfaces>) {
          for (auto& surface : value) visit_keyed_surface(surface, visit);
        } else if constexpr (std::is_same_v<Part, Groups>) {
          for (auto& group : value) visit_keyed(group, visit);
        } else if constexpr (std::is_same_v<Part, std::optional<Environment>>) {
          if (value) visit_keyed_environment(*value, visit);
        } else if constexpr (std::is_same_v<Part, MediumOptics>) {
          visit_keyed(value, visit);
          visit_keyed(value.noise, visit);
        }
      },
      part);
}

// This visits a part of a scene alike. There may be many surfaces: they are not copied.
void visit_scene_values(const Scene& scene, std::size_t part_index, auto&& visit) {
  if (part_index == index_of<Surfaces>()) {
    for (const Surface& surface : scene.surfaces) visit_keyed_surface(surface, visit);
  } else {
    const ScenePart part = scene_part(scene, part_index);
    visit_keyed_part(part, visit);
  }
}

// Whether a value of a name may have these numbers, each in its domain: directions have a length.
template <class T>
bool may_be_value(std::string_view name, const T& value) {
  if constexpr (std::is_same_v<T, glm::dvec3>) {
    return (name != "direction" && name != "up") || value != glm::dvec3(0.0);
  } else {
    return true;
  }
}

}  // namespace brume
