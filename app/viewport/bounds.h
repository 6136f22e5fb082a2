#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "core/scene/scene.h"

namespace brume {

struct Sphere {
  glm::dvec3 center{0.0};
  double radius = 0.0;
};

// Spheres to frame: around Gaussians (out to their radius), and around all there is to see
// (Gaussians and surfaces; the lights if there is nothing else). nullopt if there is nothing.
std::optional<Sphere> bounding_sphere(const Medium& medium, std::span<const GaussianId> ids);
std::optional<Sphere> bounding_sphere(const Scene& scene);

}  // namespace brume
