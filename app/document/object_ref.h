#pragma once

#include <cstddef>

namespace brume {

// A light, an emitter or a surface of a scene, by its place among those of its kind.
struct ObjectRef {
  enum class Kind { light, emitter, surface };
  Kind kind = Kind::surface;
  std::size_t index = 0;

  bool operator==(const ObjectRef&) const = default;
};

}  // namespace brume
