#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

namespace brume {

// How the matter of a Gaussian scatters and shines. By default as the medium, and not at all.
struct GaussianOptics {
  // Single-scattering albedo, RGB in (0, 1]: extinction is density / albedo. Absent: the medium's.
  std::optional<glm::dvec3> albedo{};
  // Radiance of an opaque body of it that lets nothing through and scatters nothing: RGB >= 0
  // [W/(sr u^2)], per unit of extinction optical depth.
  glm::dvec3 emission{0.0};

  bool operator==(const GaussianOptics&) const = default;
};

// Identifies a group of Gaussians in its scene (brume/group.h); 0: none.
using GroupId = std::uint32_t;

// One Gaussian of a medium: b_i(x) = density * exp(-|x - center|^2 / radius^2)  [1/u].
// The paper's a_i is 1 / radius, its c_i is density. Domain: radius > 0, density >= 0, all finite.
struct Gaussian {
  glm::dvec3 center{0.0};
  double radius = 1.0;
  double density = 0.0;
  GaussianOptics optics{};
  GroupId group = 0;

  bool operator==(const Gaussian&) const = default;
};

// Identifies a Gaussian in its medium; ids are never reused.
using GaussianId = std::uint64_t;

// Persistent id of a Gaussian across the frames of a sequence.
using GaussianNumber = std::uint32_t;

}  // namespace brume
