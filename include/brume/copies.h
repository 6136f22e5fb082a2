#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace brume {

// Where a copy of something stands: world = translate + rotate * (scale * original).
struct CopyPlacement {
  glm::dvec3 translate{0.0};
  glm::dquat rotate{1.0, 0.0, 0.0, 0.0};  // unit
  double scale = 1.0;                     // > 0

  bool operator==(const CopyPlacement&) const = default;
};
using CopyPlacements = std::vector<CopyPlacement>;

// Copies at random points of another surface, uniform by area: the same seed gives the same copies.
struct Scatter {
  std::string over{};     // the name of that surface; without one there are no copies
  double density = 1.0;   // >= 0 [1/u^2]
  std::int64_t seed = 0;  // another one gives other copies
  glm::dvec2 scale{1.0};  // the least and the greatest, > 0
  double max_turn = 0.0;  // about the normal, either way, in [0, 360] [degrees]

  bool operator==(const Scatter&) const = default;
};

// More placements of a surface: of a file, or scattered. Each places the surface as its own rotate
// and scale have it, in place of its translate.
struct Copies {
  std::filesystem::path file{};                        // of `placements`; empty: none
  std::shared_ptr<const CopyPlacements> placements{};  // null: scattered
  Scatter scatter{};

  bool operator==(const Copies&) const = default;
};

}  // namespace brume
