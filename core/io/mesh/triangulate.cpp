#include "core/io/mesh/triangulate.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>

#include "core/io/mesh/ear_clipping.h"
#include "core/math/basis.h"

namespace brume {
namespace {

// A fan may overlap itself by this share of its area: corners on one line are so only to the
// rounding of their file.
constexpr double max_overlap = 1e-6;

// Ears are looked for in a second or two; what is left of polygons for which that is too little,
// as hardly any are, becomes fans.
constexpr std::size_t max_tests = std::size_t{1} << 28;

// The corners in their mean plane, counterclockwise; empty where they have none.
std::vector<glm::dvec2> flattened(const RawMesh& mesh, std::span<const std::uint32_t> corners) {
  const glm::dvec3 origin = mesh.points[corners[0]];
  glm::dvec3 normal(0.0);
  for (std::size_t i = 2; i < corners.size(); ++i) {
    normal += glm::cross(mesh.points[corners[i - 1]] - origin, mesh.points[corners[i]] - origin);
  }
  const double length = glm::length(normal);
  if (!(length > 0.0 && length <= 1e300)) return {};
  const Basis basis = make_basis(normal / length);
  std::vector<glm::dvec2> result;
  for (const std::uint32_t corner : corners) {
    const glm::dvec3 p = mesh.points[corner] - origin;
    result.emplace_back(glm::dot(p, basis.u), glm::dot(p, basis.v));
  }
  return result;
}

// Whether the fan around the first corner covers the polygon without overlaps.
bool is_fan(std::span<const glm::dvec2> points) {
  double covered = 0.0;
  double overlaps = 0.0;
  for (std::size_t i = 2; i < points.size(); ++i) {
    const double area = doubled_area(points[0], points[i - 1], points[i]);
    (area > 0.0 ? covered : overlaps) += area;
  }
  return -overlaps <= max_overlap * covered;
}

class Triangulator {
 public:
  explicit Triangulator(const RawMesh& mesh) : mesh_(mesh) {
    result_.triangles.reserve(mesh.corners.size() - 2 * mesh.polygon_ends.size());
    result_.polygons.reserve(result_.triangles.capacity());
  }

  Triangulation run() {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < mesh_.polygon_ends.size(); ++i) {
      const std::size_t end = mesh_.polygon_ends[i];
      add(static_cast<std::uint32_t>(i), std::span(mesh_.corners).subspan(begin, end - begin));
      begin = end;
    }
    return std::move(result_);
  }

 private:
  void add(std::uint32_t polygon, std::span<const std::uint32_t> corners) {
    const std::vector<glm::dvec2> points =
        corners.size() > 3 ? flattened(mesh_, corners) : std::vector<glm::dvec2>();
    if (!points.empty() && !is_fan(points)) {
      add_ears(polygon, corners, points);
      return;
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      add_triangle(polygon, {corners[0], corners[i - 1], corners[i]});
    }
  }

  void add_ears(std::uint32_t polygon, std::span<const std::uint32_t> corners,
                std::span<const glm::dvec2> points) {
    // Without the corners that are where the one before is: neither of the two would be an ear.
    std::vector<std::uint32_t> different;
    std::vector<glm::dvec2> outline;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (points[i] == points[i > 0 ? i - 1 : points.size() - 1]) continue;
      different.push_back(corners[i]);
      outline.push_back(points[i]);
    }
    for (const auto& [a, b, c] : clip_ears(outline, tests_)) {
      add_triangle(polygon, {different[a], different[b], different[c]});
    }
  }

  void add_triangle(std::uint32_t polygon, const glm::uvec3& triangle) {
    if (triangle.x == triangle.y || triangle.y == triangle.z || triangle.z == triangle.x) return;
    result_.triangles.push_back(triangle);
    result_.polygons.push_back(polygon);
  }

  const RawMesh& mesh_;
  Triangulation result_;
  std::size_t tests_ = max_tests;
};

}  // namespace

Triangulation triangulate(const RawMesh& mesh) {
  return Triangulator(mesh).run();
}

}  // namespace brume
