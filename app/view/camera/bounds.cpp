#include "app/view/camera/bounds.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "brume/mesh_arrays.h"
#include "core/medium/gaussian_term.h"
#include "core/scene/copies.h"

namespace brume {
namespace {

struct GrowingBox {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  void include(const glm::dvec3& point, const glm::dvec3& reach = glm::dvec3(0.0)) {
    low = glm::min(low, point - reach);
    high = glm::max(high, point + reach);
  }
  void include(const Medium& medium, std::size_t index) {
    glm::dvec3 reach(medium.radii()[index]);
    const GaussianShape shape = medium.shape(index);
    if (shape != GaussianShape()) reach *= Ellipsoid<double>(shape).reach();
    include(medium.centers()[index], reach);
  }
  void include(std::span<const Surface> surfaces) {
    for (const Surface& surface : with_placed_copies({surfaces.begin(), surfaces.end()})) {
      const MeshBox around = world_box(surface);
      if (!(around.low.x <= around.high.x)) continue;
      include(around.low);
      include(around.high);
    }
  }

  [[nodiscard]] std::optional<Sphere> sphere() const {
    if (!(low.x <= high.x)) return std::nullopt;
    const double radius = 0.5 * glm::distance(low, high);
    return Sphere{0.5 * (low + high), std::max(radius, 1e-6)};
  }
};

}  // namespace

std::optional<Sphere> bounding_sphere(const Medium& medium, std::span<const GaussianId> ids) {
  GrowingBox box;
  for (const GaussianId id : ids) {
    if (const auto index = medium.index_of(id)) box.include(medium, *index);
  }
  return box.sphere();
}

Sphere bounding_sphere(std::span<const glm::dvec3> points) {
  GrowingBox box;
  for (const glm::dvec3& p : points) box.include(p);
  return box.sphere().value_or(Sphere{glm::dvec3(0.0), 1e-6});
}

std::optional<Sphere> bounding_sphere(std::span<const Surface> surfaces) {
  GrowingBox box;
  box.include(surfaces);
  return box.sphere();
}

std::optional<Sphere> bounding_sphere(const Scene& scene) {
  GrowingBox box;
  for (std::size_t i = 0; i < scene.medium.size(); ++i) box.include(scene.medium, i);
  box.include(scene.surfaces);
  if (!box.sphere()) {
    for (const Light& light : scene.lights) box.include(light.position, glm::dvec3(1.0));
  }
  return box.sphere();
}

}  // namespace brume
