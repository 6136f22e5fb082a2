#include "core/scene/copies.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <span>
#include <utility>

#include "brume/limits.h"
#include "core/math/random_source.h"
#include "core/scene/mesh.h"
#include "core/scene/placement.h"
#include "core/scene/remembered.h"

namespace brume {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The shortest rotation from +y to a unit normal.
glm::dquat rotation_from_y(const glm::dvec3& normal) {
  constexpr double opposite = -1.0 + 1e-12;
  if (normal.y < opposite) return {0.0, 1.0, 0.0, 0.0};
  return glm::normalize(glm::dquat(1.0 + normal.y, normal.z, 0.0, -normal.x));
}

glm::dquat rotation_about_y(double degrees) {
  const double half = 0.5 * glm::radians(degrees);
  return {std::cos(half), 0.0, std::sin(half), 0.0};
}

// A surface's triangles, by area.
class AreaPoints {
 public:
  explicit AreaPoints(const Surface& surface)
      : placement_(surface), mesh_(to_arrays(*surface.mesh)) {
    double sum = 0.0;
    sums_.reserve(mesh_.triangles.size());
    const double square = placement_.scale * placement_.scale;
    for (const glm::uvec3& corners : mesh_.triangles) {
      sum += 0.5 * square * glm::length(across(corners));
      sums_.push_back(sum);
    }
  }

  [[nodiscard]] double area() const { return sums_.empty() ? 0.0 : sums_.back(); }

  // A random point, and the unit normal there.
  void draw(RandomSource& random, glm::dvec3& point, glm::dvec3& normal) const {
    const auto chosen =
        std::min(std::ranges::upper_bound(sums_, random.uniform() * area()), sums_.end() - 1);
    const glm::uvec3& corners = mesh_.triangles[static_cast<std::size_t>(chosen - sums_.begin())];
    const double root = std::sqrt(random.uniform());
    const double v = random.uniform() * root;
    const glm::dvec3 weights(1.0 - root, root - v, v);
    point = normal = glm::dvec3(0.0);
    for (int k = 0; k < 3; ++k) {
      point += weights[k] * glm::dvec3(mesh_.points[corners[k]]);
      normal += weights[k] * glm::dvec3(mesh_.normals[corners[k]]);
    }
    if (normal == glm::dvec3(0.0)) normal = across(corners);
    const double length = glm::length(normal);
    normal = length > 0.0 ? normal / length : glm::dvec3(0.0, 1.0, 0.0);
    point = placement_.point_to_world(point);
    normal = placement_.normal_to_world(normal);
  }

 private:
  [[nodiscard]] glm::dvec3 across(const glm::uvec3& corners) const {
    const glm::dvec3 a(mesh_.points[corners.x]);
    return glm::cross(glm::dvec3(mesh_.points[corners.y]) - a,
                      glm::dvec3(mesh_.points[corners.z]) - a);
  }

  Placement placement_;
  const MeshArrays& mesh_;
  std::vector<double> sums_;  // of areas [u^2]
};

std::size_t rounded_count(double count) {
  return count < static_cast<double>(limits::copies) ? static_cast<std::size_t>(std::llround(count))
                                                     : limits::copies;
}

// An area depends on these.
struct AreaKey {
  Identity<TriangleMesh> mesh;
  double scale;

  bool operator==(const AreaKey&) const = default;
};

// What scattered placements depend on.
struct ScatterKey {
  Identity<TriangleMesh> mesh;
  Placement placement;
  Scatter scatter;

  bool operator==(const ScatterKey&) const = default;
};
using SharedPlacements = std::shared_ptr<const CopyPlacements>;

std::size_t bytes_of(const SharedPlacements& placements) {
  return std::span(*placements).size_bytes();
}

SharedPlacements placements_of(const Copies& copies, const std::vector<Surface>& surfaces) {
  static Remembered<ScatterKey, SharedPlacements> results;
  if (copies.placements) return copies.placements;
  const Surface* const over = find_scattered_over(copies.scatter, surfaces);
  if (!over || !over->mesh) return nullptr;
  return results.get(
      {over->mesh, Placement(*over), copies.scatter},
      [&] { return std::make_shared<const CopyPlacements>(scattered(copies.scatter, *over)); },
      bytes_of);
}

// Where the meshes of a surface's copies are in the world.
struct PlacedKey {
  Identity<CopyPlacements> placements;
  glm::dquat rotate;
  double scale;

  bool operator==(const PlacedKey&) const = default;
};

SharedPlacements placed(const SharedPlacements& placements, const Surface& surface) {
  static Remembered<PlacedKey, SharedPlacements> results;
  if (!placements || placements->empty()) return nullptr;
  return results.get(
      {placements, surface.rotate, surface.scale},
      [&] {
        CopyPlacements all = *placements;
        for (CopyPlacement& copy : all) {
          copy.rotate = copy.rotate * surface.rotate;
          copy.scale *= surface.scale;
        }
        return std::make_shared<const CopyPlacements>(std::move(all));
      },
      bytes_of);
}

// The vertices of a surface at all its placements.
class PlacedVertices {
 public:
  explicit PlacedVertices(const Surface& surface)
      : surface_(surface), points_(to_arrays(*surface.mesh).points) {
    const MeshBox box = box_of(*surface.mesh);
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        corners_[k][axis] = static_cast<float>(k >> axis & 1U ? box.high[axis] : box.low[axis]);
      }
    }
  }

  // The greatest value of a vertex, -inf without any; of a convex function, which is no less at the
  // corners of a box. If many placements may have it, that of a corner.
  [[nodiscard]] double greatest(auto&& value) const {
    if (points_.empty()) return -infinite;
    const auto max_over = [&](std::span<const glm::vec3> points, std::size_t copy) {
      const Placement placement = placement_of(surface_, copy);
      using Range = tbb::blocked_range<std::size_t>;
      const auto max_in = [&](const Range& range, double result) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          result = std::max(result, value(placement.point_to_world(glm::dvec3(points[i]))));
        }
        return result;
      };
      return tbb::parallel_reduce(Range(0, points.size(), 65536), -infinite, max_in,
                                  [](double a, double b) { return std::max(a, b); });
    };
    const std::size_t count = placement_count(surface_);
    if (count == 1) return max_over(points_, 0);
    std::vector<std::pair<double, std::size_t>> bounds(count);
    for (std::size_t k = 0; k < count; ++k) bounds[k] = {max_over(corners_, k), k};
    std::ranges::make_heap(bounds);
    double result = -infinite;
    auto end = bounds.end();
    for (std::size_t tried = 0; end != bounds.begin() && bounds.front().first > result; ++tried) {
      if (tried == max_tried) return bounds.front().first;
      result = std::max(result, max_over(points_, bounds.front().second));
      std::pop_heap(bounds.begin(), end--);
    }
    return result;
  }

 private:
  static constexpr std::size_t max_tried = 1000;
  const Surface& surface_;
  std::span<const glm::vec3> points_;
  std::array<glm::vec3, 8> corners_;  // of the box around the mesh
};

// What the box around a surface depends on.
struct BoxKey {
  Identity<TriangleMesh> mesh;
  Placement placement;
  Identity<CopyPlacements> copies;

  bool operator==(const BoxKey&) const = default;
};

}  // namespace

const Surface* find_scattered_over(const Scatter& scatter, const std::vector<Surface>& surfaces) {
  const auto found = std::ranges::find(surfaces, scatter.over, &Surface::name);
  return scatter.over.empty() || found == surfaces.end() ? nullptr : &*found;
}

double scattered_count(const Scatter& scatter, const Surface& over) {
  static Remembered<AreaKey, double> areas;
  return scatter.density * areas.get(
                               {over.mesh, over.scale}, [&] { return AreaPoints(over).area(); },
                               [](double area) { return sizeof(area); });
}

double copy_count(const std::vector<Surface>& surfaces) {
  double count = 0.0;
  for (const Surface& surface : surfaces) {
    if (!surface.copies) continue;
    const Copies& copies = *surface.copies;
    const Surface* const over = find_scattered_over(copies.scatter, surfaces);
    if (copies.placements) {
      count += static_cast<double>(copies.placements->size());
    } else if (over && over->mesh) {
      count += std::round(scattered_count(copies.scatter, *over));
    }
  }
  return count;
}

CopyPlacements scattered(const Scatter& scatter, const Surface& over) {
  const AreaPoints points(over);
  CopyPlacements placements(rounded_count(scatter.density * points.area()));
  RandomSource random(static_cast<std::uint64_t>(scatter.seed));
  for (CopyPlacement& copy : placements) {
    glm::dvec3 normal;
    points.draw(random, copy.translate, normal);
    copy.scale = glm::mix(scatter.scale[0], scatter.scale[1], random.uniform());
    const double turn = scatter.max_turn * (2.0 * random.uniform() - 1.0);
    copy.rotate = rotation_from_y(normal) * rotation_about_y(turn);
  }
  return placements;
}

std::vector<Surface> with_placed_copies(std::vector<Surface> surfaces) {
  std::vector<SharedPlacements> all;
  for (const Surface& surface : surfaces) {
    all.push_back(surface.copies ? placements_of(*surface.copies, surfaces) : nullptr);
  }
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!surfaces[i].copies) continue;  // of a frame already
    surfaces[i].placed_copies = placed(all[i], surfaces[i]);
    surfaces[i].copies.reset();
  }
  return surfaces;
}

MeshBox world_box(const Surface& surface) {
  static Remembered<BoxKey, MeshBox> results;
  return results.get(
      {surface.mesh, Placement(surface), surface.placed_copies},
      [&]() -> MeshBox {
        const PlacedVertices vertices(surface);
        MeshBox box;
        for (int axis = 0; axis < 3; ++axis) {
          box.low[axis] = -vertices.greatest([axis](const glm::dvec3& p) { return -p[axis]; });
          box.high[axis] = vertices.greatest([axis](const glm::dvec3& p) { return p[axis]; });
        }
        return box;
      },
      [](const MeshBox& box) { return sizeof(box); });
}

double farthest_vertex(const Surface& surface, const glm::dvec3& point) {
  return PlacedVertices(surface).greatest(
      [&point](const glm::dvec3& p) { return glm::distance(p, point); });
}

}  // namespace brume
