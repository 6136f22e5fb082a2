#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace brume {

// How brushes paint, as values; core/authoring does it.

// The paintbrush of section 6 of the paper: Gaussians along a stroke.
struct Paintbrush {
  double radius = 0.3;   // of each Gaussian, across the stroke [u], > 0
  double density = 1.0;  // its peak [1/u], >= 0
  double spacing = 1.0;  // along the stroke, relative to the radius along it
  double scatter = 0.5;  // maximum offset from the stroke, relative to the radius
  double falloff =
      0.0;            // of the density from the stroke to the maximum offset, in [0, 1]: soft edge
  double flow = 1.0;  // share of the density that one pass adds, in [0, 1]
  double jitter = 0.0;   // random factors of radius and density, at 1 from 1/2 to 2; in [0, 1]
  double stretch = 1.0;  // the radius along the stroke over that across it, >= 1; 1: balls

  bool operator==(const Paintbrush&) const = default;
};

// Planes through a point, across the axes that are true.
struct MirrorPlanes {
  std::array<bool, 3> axes{};
  glm::dvec3 center{0.0};

  bool operator==(const MirrorPlanes&) const = default;
};

}  // namespace brume
