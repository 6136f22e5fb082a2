#include "tools/bench/scenes/mesh_patches.h"

#include <cmath>
#include <numbers>

namespace brume {

std::size_t add_patch(MeshArrays& mesh, int n,
                      const std::function<MeshVertex(double, double)>& vertex) {
  const std::size_t first = mesh.points.size();
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const MeshVertex v = vertex(static_cast<double>(i) / n, static_cast<double>(j) / n);
      mesh.points.emplace_back(v.position);
      mesh.normals.emplace_back(v.normal);
    }
  }
  const auto index_at = [&](int i, int j) {
    return first + static_cast<std::size_t>(i * (n + 1) + j);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      mesh.triangles.emplace_back(index_at(i, j), index_at(i + 1, j), index_at(i + 1, j + 1));
      mesh.triangles.emplace_back(index_at(i, j), index_at(i + 1, j + 1), index_at(i, j + 1));
    }
  }
  return first;
}

std::size_t add_floor(MeshArrays& mesh, int n, double half) {
  return add_patch(mesh, n, [half](double u, double v) {
    return MeshVertex{{half * (2.0 * u - 1.0), half * (2.0 * v - 1.0), 0.0}, {0.0, 0.0, 1.0}};
  });
}

std::size_t add_ball(MeshArrays& mesh, int n, const glm::dvec3& center, double radius, double to,
                     bool inward) {
  return add_patch(mesh, n, [=](double u, double v) {
    const double theta = to * u;
    // The winding matches the normals.
    const double phi = 2.0 * std::numbers::pi * (inward ? v : -v);
    const glm::dvec3 out(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                         -std::cos(theta));
    return MeshVertex{center + radius * out, inward ? -out : out};
  });
}

}  // namespace brume
