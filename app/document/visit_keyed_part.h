#pragma once

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

}  // namespace brume
