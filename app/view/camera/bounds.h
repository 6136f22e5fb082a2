#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "brume/scene.h"

namespace brume {

struct Sphere {
  glm::dvec3 center{0.0};
  double radius = 0.0;
};

// Bounding spheres for framing: of Gaussians (to their radii), and of the scene (Gaussians and
// surfaces, or else lights). nullopt if empty.
std::optional<Sphere> bounding_sphere(const Medium& medium, std::span<const GaussianId> ids);
std::optional<Sphere> bounding_sphere(const Scene& scene);
// Spheres hold copies, too; around no points at all they have no size.
std::optional<Sphere> bounding_sphere(std::span<const Surface> surfaces);
Sphere bounding_sphere(std::span<const glm::dvec3> points);

}  // namespace brume
