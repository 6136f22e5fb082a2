#pragma once

#include <cstddef>
#include <optional>

namespace brume {

// A light, an emitter or a surface of a scene, by its place among those of its kind.
struct ObjectRef {
  enum class Kind { light, emitter, surface };
  Kind kind = Kind::surface;
  std::size_t index = 0;
  // The node that is chosen of a surface with an imported scene, which may have fewer by now.
  std::optional<std::size_t> node{};

  bool operator==(const ObjectRef&) const = default;
};

}  // namespace brume
