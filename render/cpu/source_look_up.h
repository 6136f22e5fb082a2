#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "render/cpu/source_grid.h"

namespace brume {

// What a view ray makes of a node of a SourceGrid: J is the sum of the node's values, each times
// its weight.
struct SourceWeights {
  std::array<float, 4 * sh_size(PhaseBands::most)> harmonics{};  // for each R G B 0
  bool has_beams = false;
  std::array<glm::vec3, source_families> beams{};
  // Not of J: what the peak of the phase function makes of the other families.
  std::array<glm::vec3, source_families> spread{};
};

// The light that arrives at a point: for each basis function R G B 0.
using ArrivingLight = std::array<float, 4 * sh_size(grid_bands)>;

// A SourceGrid seen from one origin, in single precision (Highway). Refers to the grid.
class SourceLookUp {
 public:
  SourceLookUp(const SourceGrid& grid, const glm::dvec3& origin);

  // The sum over k of shares[k] J at origin + t[k] w; beyond the grid J is that of its nearest
  // point. A share of 0 costs nothing. Thread-safe.
  [[nodiscard]] glm::vec3 operator()(const glm::vec3& w, std::span<const float> t,
                                     std::span<const float> shares,
                                     const SourceWeights& weights) const;

  // The transmittance towards each family at the origin, in a grid of more than one band; beyond
  // the grid it is 1. Thread-safe.
  using Families = std::array<float, source_families>;
  [[nodiscard]] Families families_at_origin() const;

  // The light that arrives at origin + p, where the grid has receivers. Thread-safe.
  [[nodiscard]] ArrivingLight arriving(const glm::vec3& p) const;

  // The grid relative to the origin.
  struct Level {
    glm::vec3 first{0.0f};
    float per_unit = 1.0f;
    glm::ivec3 count{2};
    const float* values = nullptr;
    const float* arriving = nullptr;
  };

 private:
  std::array<Level, 2> levels_;
  std::size_t count_ = 0;
  int bands_;
};

}  // namespace brume
